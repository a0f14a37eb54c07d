//! Folds: triangles that the displacement turned over.

use glam::{DVec3, Vec3};

/// Rounding of positions as a part of the largest coordinate, with a margin.
const ROUNDING: f64 = 1.0 / (1 << 22) as f64;

/// Folds of a mesh.
///
/// A triangle is folded if the normal by its corners points against the direction of displacement.
/// That is the sum of the directions of its corners. The triangle was turned over and shows its
/// back. A triangle does not count if rounded positions could have turned it, or if it has no area.
/// A mesh that is displaced along one direction, such as a plane, does not fold.
/// [`Mesh::fold_range`](relief_core::mesh::Mesh::fold_range) gives the displacement at which a mesh
/// begins to fold.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Folds {
    /// Number of folded triangles.
    pub triangles: u64,
    /// Number of base triangles with folded pieces.
    pub base_triangles: u64,
    /// The first of these base triangles, at most [`Folds::FIRST`].
    pub first: Vec<FoldedBase>,
    /// The base triangle counted last.
    last: Option<u32>,
}

/// Base triangle with folded pieces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FoldedBase {
    /// Number of the base triangle, from 0.
    pub triangle: u32,
    /// Number of folded pieces.
    pub pieces: u64,
    /// Middle before displacement, in metres. If it is filled in several patches: the middle of the
    /// first.
    pub middle_m: DVec3,
}

impl Folds {
    /// Greatest number of base triangles in [`Folds::first`].
    pub const FIRST: usize = 8;

    /// Counts the folded pieces of a base triangle. Call it in the order of the base triangles.
    pub(crate) fn add(&mut self, found: FoldedBase) {
        self.triangles += found.pieces;
        if self.last == Some(found.triangle) {
            if let Some(known) = self.first.last_mut().filter(|known| known.triangle == found.triangle) {
                known.pieces += found.pieces;
            }
            return;
        }
        self.last = Some(found.triangle);
        self.base_triangles += 1;
        if self.first.len() < Self::FIRST {
            self.first.push(found);
        }
    }
}

/// Returns whether a triangle may be folded, where the directions in it are sums of `directions`.
#[inline(always)]
pub fn may_be_folded([a, b, c]: [Vec3; 3], directions: &[DVec3; 3]) -> bool {
    let a = a.as_dvec3();
    let normal = (b.as_dvec3() - a).cross(c.as_dvec3() - a);
    let [along_a, along_b, along_c] = directions;
    // Without a branch between the terms.
    (normal.dot(*along_a) < 0.0) | (normal.dot(*along_b) < 0.0) | (normal.dot(*along_c) < 0.0)
}

/// Returns whether a triangle is folded, by the directions in which its corners were displaced.
pub fn is_folded(corners: [Vec3; 3], directions: [DVec3; 3]) -> bool {
    let [a, b, c] = corners.map(|corner| corner.as_dvec3());
    let along = directions[0] + directions[1] + directions[2];
    let way = (b - a).cross(c - a).dot(along);
    if way >= 0.0 {
        return false;
    }
    let largest = [a, b, c].map(|at| at.abs().max_element()).into_iter().fold(0.0, f64::max);
    let longest = (b - a).length().max((c - a).length());
    -way > ROUNDING * largest * longest * along.length()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(triangle: u32, pieces: u64) -> FoldedBase {
        FoldedBase { triangle, pieces, middle_m: DVec3::ZERO }
    }

    #[test]
    fn a_triangle_in_several_parts_is_counted_once() {
        let mut folds = Folds::default();
        [found(3, 2), found(3, 5), found(4, 1)].into_iter().for_each(|part| folds.add(part));
        assert_eq!((folds.triangles, folds.base_triangles), (8, 2));
        assert_eq!(folds.first, [found(3, 7), found(4, 1)]);
        // Also once its base triangle is not stored any more.
        (10..30).flat_map(|triangle| [found(triangle, 1); 2]).for_each(|part| folds.add(part));
        assert_eq!((folds.triangles, folds.base_triangles, folds.first.len()), (48, 22, Folds::FIRST));
        assert!(folds.first.iter().skip(2).all(|base| base.pieces == 2));
    }

    #[test]
    fn turned_triangles_fold_and_rounded_ones_do_not() {
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y];
        let turned = [corners[0], corners[2], corners[1]];
        assert!(!is_folded(corners, [DVec3::Z; 3]) && is_folded(turned, [DVec3::Z; 3]));
        assert!(is_folded(corners, [-DVec3::Z; 3]) && !is_folded(corners, [DVec3::X; 3]));
        // The next float, far from the origin: nothing but rounding.
        let far = 1000.0_f32;
        let sliver = [Vec3::new(far, 0.0, 0.0), Vec3::new(far, 1.0, 0.0), Vec3::new(far.next_up(), 0.5, 0.0)];
        assert!(!is_folded(sliver, [DVec3::Z; 3]) && !is_folded(sliver, [-DVec3::Z; 3]));
        assert!(!is_folded([corners[0]; 3], [DVec3::Z; 3]));
    }
}
