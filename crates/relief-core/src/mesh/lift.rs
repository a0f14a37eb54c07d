//! Height of the smooth surface that a mesh's normals imply above its triangles.
//!
//! Gumhold and Hüttner 1999, section 5, describe the creases of a coarse base mesh, which show
//! through its displacement. They name a smooth base surface as the remedy.

use super::{Mesh, Vertex};
use glam::DVec3;

impl Mesh {
    /// For each triangle `abc`, returns the three numbers `[bc, ca, ab]` in metres that make its
    /// flat base smooth. At the barycentric weights `w` the smooth base has the height
    ///
    /// `bc · w_b w_c + ca · w_c w_a + ab · w_a w_b`
    ///
    /// above the triangle along the interpolated normal `Σ w_i n_i`, where
    /// `bc = ½ (p_b - p_c)·(n_b - n_c)`, and so on. The numbers are positive where the surface is
    /// convex, and 0 where it is flat.
    ///
    /// This follows from the curvature along an edge. Take a curve between the ends of an edge of
    /// length `l`, with the normals `n_b` and `n_c` there. To the second order it has the curvature
    /// `(p_b - p_c)·(n_b - n_c) / l²` against its normal, and rises `½ l²` times that times
    /// `w_b w_c` above its chord. The polynomial is the only one of degree 2 that is 0 at the
    /// corners and does so along all three edges. On a sphere of radius `r` the interpolated point
    /// is `(r² - Σ l_ij² w_i w_j)^½` from the centre. So the remaining error there is of the fourth
    /// order in `l / r`.
    ///
    /// An edge has the same number, bit by bit, in all triangles with the same positions and
    /// normals at its ends, in any order. So a smooth base has no cracks there. Along hard edges
    /// each side has its own number, because it has its own normals. A shell over the smooth base,
    /// displaced by `h`, is the shell over the triangle displaced by `h` plus the height. It folds
    /// where [`Self::fold_range`] says for that sum.
    ///
    /// All numbers are finite; values beyond the range of `f32` become its greatest number.
    ///
    /// ```
    /// use relief_core::mesh::{sphere, square};
    ///
    /// assert!(square(4)?.lifts().iter().all(|numbers| *numbers == [0.0; 3]));
    /// assert!(sphere(16, 8)?.lifts().iter().flatten().all(|&number| number > 0.0));
    /// # Ok::<(), relief_core::mesh::MeshError>(())
    /// ```
    pub fn lifts(&self) -> Vec<[f32; 3]> {
        let of_triangle = |triangle| {
            let [a, b, c] = self.corners(triangle);
            [lift(b, c), lift(c, a), lift(a, b)]
        };
        (0..self.triangles.len() as u32).map(of_triangle).collect()
    }
}

/// Number of an edge. If the ends are exchanged, both differences only change their sign.
fn lift(from: &Vertex, to: &Vertex) -> f32 {
    let [along, turn]: [DVec3; 2] =
        [to.position.as_dvec3() - from.position.as_dvec3(), to.normal.as_dvec3() - from.normal.as_dvec3()];
    (0.5 * along.dot(turn)).clamp(-f64::from(f32::MAX), f64::from(f32::MAX)) as f32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{cube, cylinder, sphere, torus};
    use glam::Vec3;
    use std::collections::HashMap;

    /// Distance between a point and a true surface, in metres.
    type Distance = fn(DVec3) -> f64;

    /// Distance between points of a mesh and the true surface: the root of the mean square in
    /// metres.
    fn distance_m(mesh: &Mesh, lifts: &[[f32; 3]], to_surface: Distance) -> f64 {
        let (mut sum, mut count) = (0.0, 0.0);
        for (triangle, lift) in lifts.iter().enumerate() {
            for i in 0..=8 {
                for j in 0..=8 - i {
                    let w = [i, j, 8 - i - j].map(|part| part as f32 / 8.0);
                    let at = mesh.interpolated(triangle as u32, w);
                    let height = lift[0] * w[1] * w[2] + lift[1] * w[2] * w[0] + lift[2] * w[0] * w[1];
                    sum += to_surface((at.position + at.normal * height).as_dvec3()).powi(2);
                    count += 1.0;
                }
            }
        }
        (sum / f64::from(count as f32)).sqrt()
    }

    fn to_sphere(p: DVec3) -> f64 {
        p.length() - 0.5
    }

    fn to_torus(p: DVec3) -> f64 {
        (p.x.hypot(p.z) - 0.35).hypot(p.y) - 0.15
    }

    /// Distance of the flat base, and the factor by which the lifted one is nearer.
    fn gain(mesh: &Mesh, factor: f32, to_surface: Distance) -> [f64; 2] {
        let lifts = mesh.lifts();
        let flat = distance_m(mesh, &vec![[0.0; 3]; lifts.len()], to_surface);
        let lifts: Vec<_> = lifts.iter().map(|numbers| numbers.map(|number| number * factor)).collect();
        [flat, flat / distance_m(mesh, &lifts, to_surface)]
    }

    #[test]
    fn lifted_bases_are_near_the_true_surface() {
        let cases: [(&str, Mesh, Distance, f64); 5] = [
            ("sphere 8x4", sphere(8, 4).expect("a mesh"), to_sphere, 4.0),
            ("sphere 16x8", sphere(16, 8).expect("a mesh"), to_sphere, 15.0),
            ("sphere 64x32", sphere(64, 32).expect("a mesh"), to_sphere, 200.0),
            ("torus 16x8", torus(16, 8).expect("a mesh"), to_torus, 5.0),
            ("torus 32x16", torus(32, 16).expect("a mesh"), to_torus, 20.0),
        ];
        for (name, mesh, to_surface, least) in cases {
            let [flat, gained] = gain(&mesh, 1.0, to_surface);
            println!("{name}: {flat:.2e} m, {gained:.1} times nearer");
            assert!(gained > least, "{name}: {gained}");
            // A wrong sign or factor is noticed.
            for wrong in [-1.0, 0.5, 2.0] {
                assert!(gain(&mesh, wrong, to_surface)[1] < gained.min(3.0), "{name}: {wrong}");
            }
        }
    }

    #[test]
    fn an_edge_has_one_number() {
        let key = |vertex: &Vertex| {
            [vertex.position, vertex.normal].map(|v| (v + Vec3::ZERO).to_array().map(f32::to_bits))
        };
        for mesh in [sphere(9, 7), torus(7, 5), cylinder(9, 2)].map(|mesh| mesh.expect("a mesh")) {
            let mut of_edge = HashMap::new();
            let mut met = 0;
            for (triangle, lifts) in mesh.lifts().iter().enumerate() {
                let corners = mesh.corners(triangle as u32).map(key);
                for (place, lift) in lifts.iter().enumerate() {
                    let (a, b) = (corners[(place + 1) % 3], corners[(place + 2) % 3]);
                    if let Some(before) = of_edge.insert([a.min(b), a.max(b)], lift.to_bits()) {
                        assert_eq!(before, lift.to_bits());
                        met += 1;
                    }
                }
            }
            assert!(met > mesh.triangles().len());
        }
    }

    #[test]
    fn flat_and_extreme_meshes_are_lifted_by_finite_numbers() {
        assert!(cube(3).expect("a mesh").lifts().iter().flatten().all(|&number| number == 0.0));
        let mut mesh = torus(5, 4).expect("a mesh");
        for (at, vertex) in mesh.vertices.iter_mut().enumerate() {
            vertex.position *= [0.0, 1e38, 1e-40][at % 3];
            vertex.normal *= [1e38, 0.0, 1.0][at % 3];
        }
        assert!(mesh.lifts().iter().flatten().all(|number| number.is_finite()));
        assert_eq!(Mesh::new(Vec::new(), Vec::new()).expect("an empty mesh").lifts(), Vec::<[f32; 3]>::new());
    }
}
