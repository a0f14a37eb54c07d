//! Quadrics that approximate a curved base surface around every vertex.
//!
//! Sources: Oliveira and Policarpo 2005, sections 3 and 3.4, equations 1, 2 and 8; Szirmay-Kalos
//! and Umenhoffer 2008, section 5.1. In addition to theirs, this fit uses the neighbours' normals.

use super::least_norm::LeastNorm;
use super::measures::HARD_DEG;
use super::topology::weld;
use super::{Mesh, Vertex};
use glam::{DVec2, DVec3};
use rayon::prelude::*;
use std::f64::consts::{FRAC_1_SQRT_2, SQRT_2};

/// Least sine of the angle between the normal and the direction to a neighbour, for the neighbour
/// to count.
const STRAIGHT_ABOVE: f64 = 1e-3;

/// Squared sine of the angle between tangent and bitangent below which they count as parallel.
const ONE_DIRECTION: f64 = 1e-12;

/// Number of coefficients of a quadric.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum QuadricCoefficients {
    /// `A du² + C dv²` (Oliveira and Policarpo 2005, eq. 1), fitted in the directions of the
    /// tangent and the bitangent. A saddle whose straight lines have these directions, `du dv`, is
    /// lost.
    Two,
    /// `A du² + B du dv + C dv²`: all curvatures.
    #[default]
    Three,
}

impl Mesh {
    /// For each vertex, returns the coefficients `[A, B, C]` of the quadric
    /// `q(du, dv) = A du² + B du dv + C dv²` that approximates the base surface around it. `du` and
    /// `dv` are texture coordinates relative to the vertex's own, in tiles along its tangent and
    /// bitangent. `q` is the height along its normal in metres, positive outward.
    ///
    /// So the coefficients are metres per squared tile, and negative where the surface is convex.
    /// Divided by the scale of the heights they are the paper's `α` and `β` (eq. 8) with the
    /// opposite sign.
    ///
    /// The fit is by least squares over the *star*: the other corners of all triangles with this
    /// position and this normal (to 0.1°). Vertices and texture coordinates may differ there. So
    /// seams have no effect, and faces beyond a hard edge do not count. Each neighbour gives three
    /// equations of equal weight:
    ///
    /// * its height above the tangent plane, in its direction on that plane but at its true
    ///   distance (so circles and spheres are fitted exactly, however coarse the mesh);
    /// * two slopes, from its normal, which coarse and lopsided stars need.
    ///
    /// Texture coordinates are not read. The projections of tangent and bitangent to the tangent
    /// plane give the length of a tile. If the star leaves curvatures undetermined, as a single
    /// triangle may, these are 0. Among all quadrics with the least error, the one with the least
    /// curvatures is chosen. It is found by the normal matrix's eigenvectors. Eigenvalues below
    /// 1e-4 of the largest count as undetermined.
    ///
    /// All coefficients are 0 at a vertex without triangles or without a normal. With
    /// [`QuadricCoefficients::Two`] they are also 0 where tangent and bitangent are parallel. All
    /// are finite; values beyond the range of `f32` become its greatest number.
    ///
    /// The fit takes about 50 bytes per triangle and 80 per vertex. Equal meshes give equal bits,
    /// whatever the number of threads.
    ///
    /// ```
    /// use relief_core::mesh::{QuadricCoefficients, sphere};
    ///
    /// // The radius is 0.5 m: at a distance of d metres a sphere has fallen by about d² metres.
    /// let mesh = sphere(64, 32)?;
    /// let quadrics = mesh.quadrics(QuadricCoefficients::Three);
    /// for (vertex, [a, b, c]) in mesh.vertices().iter().zip(quadrics) {
    ///     assert!((a + vertex.tangent.length_squared()).abs() < 1e-4);
    ///     assert!((c + vertex.bitangent.length_squared()).abs() < 1e-4 && b.abs() < 1e-4);
    /// }
    /// # Ok::<(), relief_core::mesh::MeshError>(())
    /// ```
    pub fn quadrics(&self, coefficients: QuadricCoefficients) -> Vec<[f32; 3]> {
        let star_of = self.stars();
        let mut neighbours = Vec::with_capacity(6 * self.triangles.len());
        for corners in &self.triangles {
            let stars = corners.map(|index| star_of[index as usize]);
            for (from, to) in [(0, 1), (1, 2), (2, 0)] {
                neighbours.extend([(stars[from], stars[to]), (stars[to], stars[from])]);
            }
        }
        neighbours.sort_unstable();
        neighbours.dedup();
        let quadric = |(vertex, &star): (&Vertex, &u32)| {
            let start = neighbours.partition_point(|&(from, _)| from < star);
            let around = neighbours[start..].iter().take_while(|&&(from, _)| from == star);
            let around = around.map(|&(_, to)| &self.vertices[to as usize]);
            quadric(vertex, &self.vertices[star as usize], around, coefficients)
        };
        self.vertices.par_iter().zip(&star_of).map(quadric).collect()
    }

    /// For every vertex, the first one with its position and its normal.
    fn stars(&self) -> Vec<u32> {
        const NONE: u32 = u32::MAX;
        let point_of = weld(self.vertices.iter().map(|vertex| vertex.position));
        let normals: Vec<DVec3> =
            self.vertices.iter().map(|vertex| vertex.normal.as_dvec3().normalize_or_zero()).collect();
        let least_cos = HARD_DEG.to_radians().cos();
        let alike = |a: DVec3, b: DVec3| a == b || a.dot(b) >= least_cos;
        // The stars of a point form a list that starts with the point's first vertex.
        let mut next = vec![NONE; self.vertices.len()];
        let mut star_of = Vec::with_capacity(self.vertices.len());
        for (vertex, &point) in point_of.iter().enumerate() {
            let mut star = point;
            while !alike(normals[star as usize], normals[vertex]) {
                if next[star as usize] == NONE {
                    next[star as usize] = vertex as u32;
                }
                star = next[star as usize];
            }
            star_of.push(star);
        }
        star_of
    }
}

/// Directions in a tangent plane in which a quadric is fitted: unit vectors, not always at right
/// angles.
struct Axes {
    axes: [DVec3; 2],
    /// Cosine of the angle between the axes.
    cos: f64,
}

impl Axes {
    /// Axes along a vertex's tangent and bitangent. `None` if these are parallel.
    fn of_texture(vertex: &Vertex, normal: DVec3) -> Option<Self> {
        let [t, b] = [vertex.tangent, vertex.bitangent].map(|vector| {
            let vector = vector.as_dvec3();
            (vector - normal * normal.dot(vector)).normalize_or_zero()
        });
        let cos = t.dot(b);
        (t.cross(b).length_squared() > ONE_DIRECTION).then_some(Self { axes: [t, b], cos })
    }

    /// Axes at right angles, which depend on the normal alone.
    fn of_normal(normal: DVec3) -> Self {
        Self { axes: normal.any_orthonormal_pair().into(), cos: 0.0 }
    }

    /// Coordinates of a vector along the axes.
    fn coordinates(&self, vector: DVec3) -> DVec2 {
        let [x, y] = self.axes.map(|axis| axis.dot(vector));
        DVec2::new(x - self.cos * y, y - self.cos * x) / (1.0 - self.cos * self.cos)
    }
}

/// Coefficients at a vertex, from its star's first vertex and that vertex's neighbours.
fn quadric<'a>(
    vertex: &Vertex,
    star: &Vertex,
    neighbours: impl Iterator<Item = &'a Vertex>,
    coefficients: QuadricCoefficients,
) -> [f32; 3] {
    let normal = star.normal.as_dvec3().normalize_or_zero();
    if normal == DVec3::ZERO {
        return [0.0; 3];
    }
    let is_mixed = coefficients == QuadricCoefficients::Three;
    let axes = if is_mixed { Some(Axes::of_normal(normal)) } else { Axes::of_texture(vertex, normal) };
    let Some(axes) = axes else {
        return [0.0; 3];
    };
    // The unknowns are x², √2 xy and y². The sum of their squares is the same in all axes at right
    // angles, and so is the solution of least norm.
    let mut system = LeastNorm::default();
    let mut add =
        |[xx, xy, yy]: [f64; 3], value| system.add([xx, if is_mixed { xy } else { 0.0 }, yy], value);
    for neighbour in neighbours {
        let offset = neighbour.position.as_dvec3() - star.position.as_dvec3();
        let length = offset.length();
        let flat = (offset - normal * normal.dot(offset)).length();
        if flat <= STRAIGHT_ABOVE * length {
            continue;
        }
        let seen = axes.coordinates(offset) / length;
        let far = seen * (length / flat);
        add([far.x * far.x, SQRT_2 * far.x * far.y, far.y * far.y], normal.dot(offset) / length / length);
        let up = neighbour.normal.as_dvec3().normalize_or_zero();
        let [along_x, along_y] = axes.axes.map(|axis| -0.5 * up.dot(axis) / length);
        add([seen.x, FRAC_1_SQRT_2 * seen.y, 0.0], along_x);
        add([0.0, FRAC_1_SQRT_2 * seen.x, seen.y], along_y);
    }
    let [a, b, c] = system.solve();
    let [t, s] = [vertex.tangent, vertex.bitangent].map(|vector| axes.coordinates(vector.as_dvec3()));
    let form =
        |p: DVec2, q: DVec2| a * p.x * q.x + c * p.y * q.y + b * FRAC_1_SQRT_2 * (p.x * q.y + p.y * q.x);
    let mixed = if is_mixed { 2.0 * form(t, s) } else { 0.0 };
    [form(t, t), mixed, form(s, s)]
        .map(|number| number.clamp(-f64::from(f32::MAX), f64::from(f32::MAX)) as f32)
}

#[cfg(test)]
mod tests;
