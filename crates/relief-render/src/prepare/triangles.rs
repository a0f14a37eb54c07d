//! Triangles that share corners.

use glam::DVec3;
use relief_mesh::FullBounds;
use relief_shaders::cpu::{Corner, Face, Shell, Triangle};

use crate::prepare::Tessellation;

/// Triangles of a mesh as input of the shaders, in the order of the mesh.
///
/// Corners are held once, however many triangles meet there: 96 bytes each, and 48 for a triangle.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triangles {
    corners: Vec<Corner>,
    faces: Vec<Face>,
    everything: Option<FullBounds>,
    tessellation: Option<Tessellation>,
    slices: Vec<u32>,
}

impl Triangles {
    /// Creates triangles from corners, and from the indices of each triangle's corners with its
    /// shell. All indices are valid.
    pub(crate) fn new(corners: Vec<Corner>, faces: impl Iterator<Item = ([u32; 3], Shell)>) -> Self {
        let faces = faces.map(|(corners, shell)| Face { corners: corners.into(), shell });
        let (everything, tessellation, slices) = (None, None, Vec::new());
        Self { corners, faces: faces.collect(), everything, tessellation, slices }
    }

    /// Creates an empty set for triangles that a backend makes from a base, with their bounds.
    pub(crate) fn to_be_made(tessellation: Tessellation, everything: FullBounds) -> Self {
        let (everything, tessellation) = (Some(everything), Some(tessellation));
        Self { everything, tessellation, ..Self::default() }
    }

    /// Returns the base from which a backend makes the triangles, if any.
    pub(crate) fn tessellation(&self) -> Option<&Tessellation> {
        self.tessellation.as_ref()
    }

    /// Adds the bounds of all triangles, including the culled ones.
    #[must_use]
    pub(crate) fn among(self, everything: Option<FullBounds>) -> Self {
        Self { everything, ..self }
    }

    /// Divides the triangles into consecutive slices that end at `ends`.
    #[must_use]
    pub(crate) fn in_slices(self, ends: Vec<u32>) -> Self {
        Self { slices: ends, ..self }
    }

    /// Returns the ends of slices among the triangles; empty if these are not sorted slices.
    #[cfg(feature = "gpu")]
    pub(crate) fn slices(&self) -> &[u32] {
        &self.slices
    }

    /// Returns the least and the greatest depth along the view axis, in metres, including culled
    /// triangles. `None` unless they were made for a camera.
    pub(crate) fn depths_m(&self) -> Option<[f64; 2]> {
        self.everything.as_ref().map(|all| all.depths_m)
    }

    /// Returns points around all triangles, including culled ones. `None` unless they were made for
    /// a camera.
    pub(crate) fn around(&self) -> Option<&[DVec3]> {
        self.everything.as_ref().map(|all| &all.around[..])
    }

    /// Returns the number of triangles.
    pub fn len(&self) -> usize {
        self.faces.len()
    }

    /// Whether there are no triangles.
    pub fn is_empty(&self) -> bool {
        self.faces.is_empty()
    }

    /// Returns the triangle with a number, with its corners and its shell.
    ///
    /// # Panics
    ///
    /// When there is no such triangle.
    #[inline]
    pub fn get(&self, number: usize) -> Triangle {
        self.of(&self.faces[number])
    }

    /// Returns an iterator over all triangles.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Triangle> {
        self.faces.iter().map(|face| self.of(face))
    }

    /// Returns all corners.
    pub fn corners(&self) -> &[Corner] {
        &self.corners
    }

    /// Returns the indices of each triangle's corners among [`Self::corners`], with its shell.
    pub fn faces(&self) -> &[Face] {
        &self.faces
    }

    #[inline]
    fn of(&self, face: &Face) -> Triangle {
        let at = face.corners;
        let [a, b, c] = [at.x, at.y, at.z].map(|place| self.corners[place as usize]);
        Triangle { a, b, c, shell: face.shell }
    }
}

impl FromIterator<Triangle> for Triangles {
    /// Triangles that share no corners.
    fn from_iter<I: IntoIterator<Item = Triangle>>(triangles: I) -> Self {
        let (mut corners, mut faces) = (Vec::new(), Vec::new());
        for Triangle { a, b, c, shell } in triangles {
            let first = corners.len() as u32;
            faces.push(Face { corners: [first, first + 1, first + 2].into(), shell });
            corners.extend([a, b, c]);
        }
        Self { corners, faces, ..Self::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_are_shared_or_not_and_the_same() {
        let corner = |x: f32, y: f32| {
            Corner::new([x, y, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [x, y], [0.0; 3])
        };
        let corners = vec![corner(0.0, 0.0), corner(1.0, 0.0), corner(0.0, 1.0), corner(1.0, 1.0)];
        let [first, second] = [Shell::whole(), Shell::whole().folded()];
        let faces = [([0, 1, 2], first), ([2, 1, 3], second)];
        let shared = Triangles::new(corners.clone(), faces.into_iter());
        let unshared: Triangles = shared.iter().collect();
        assert_eq!((shared.corners().len(), unshared.corners().len()), (4, 6));
        assert!(shared.iter().eq(unshared.iter()) && shared.len() == 2 && !shared.is_empty());
        let (a, b, c) = (corners[2], corners[1], corners[3]);
        assert_eq!(unshared.get(1), Triangle { a, b, c, shell: second });
    }
}
