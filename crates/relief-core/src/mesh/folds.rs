//! Range of displacements in which a mesh's triangles do not fold.

use super::Mesh;
use glam::DVec3;

/// Greatest difference between the components of two unit normals that rounding alone causes.
const ROUNDING: f64 = 2.0 * f32::EPSILON as f64;

/// Part of its undisplaced value to which the Jacobian falls, by the rounding of corners, where a
/// shell shrinks to a point or a line.
const NOTHING: f64 = 1e-4;

impl Mesh {
    /// Returns the offsets `[down, up]` in metres between which a triangle's shell is not folded.
    /// `down` is negative and `up` positive, or both are 0. An end is infinite if the shell never
    /// folds in that direction. The ends are not part of the range.
    ///
    /// The shell over the corners `p_i` with the normals `n_i` is
    /// `X(w, h) = Σ w_i p_i + h Σ w_i n_i`, over barycentric weights `w` and the offset `h`. Its
    /// Jacobian is `det(E₁, E₂, Σ w_i n_i)`, where `E₁ = p_b - p_a + h (n_b - n_a)`, and `E₂`
    /// likewise from `a` to `c`. The shell is folded where the Jacobian is not positive: there it
    /// is turned over, and points of the displaced surface hide each other.
    ///
    /// At one offset `E₁` and `E₂` are the same on the whole triangle. So the Jacobian is linear in
    /// `w` and least at a corner, and at a corner it is a quadratic in `h`. This gives the range in
    /// closed form: it ends at the nearest root on either side of the three corners' quadratics. A
    /// quadratic whose minimum is 1e-4 of its undisplaced value or below counts as touching 0
    /// there. On a sphere this occurs at the centre.
    ///
    /// A triangle without an area, or with a normal that points backward, is folded without any
    /// displacement: its range is `[0, 0]`. Normals that differ by no more than rounding count as
    /// equal, so that flat meshes never fold.
    ///
    /// Panics if there is no such triangle.
    ///
    /// ```
    /// use relief_core::mesh::{cylinder, square};
    ///
    /// assert_eq!(square(1)?.fold_range(0), [f64::NEG_INFINITY, f64::INFINITY]);
    /// // A cylinder folds in its axis, at a depth of its radius, and never outward.
    /// let [down, up] = cylinder(64, 1)?.fold_range(0);
    /// assert!((down + 0.5).abs() < 1e-6 && up == f64::INFINITY);
    /// # Ok::<(), relief_core::mesh::MeshError>(())
    /// ```
    pub fn fold_range(&self, triangle: u32) -> [f64; 2] {
        let corners = self.corners(triangle);
        let positions = corners.map(|corner| corner.position.as_dvec3());
        let normals = corners.map(|corner| corner.normal.as_dvec3());
        let [edge_1, edge_2] = [positions[1] - positions[0], positions[2] - positions[0]];
        let [turn_1, turn_2] = [normals[1] - normals[0], normals[2] - normals[0]]
            .map(|turn| if turn.abs().max_element() <= ROUNDING { DVec3::ZERO } else { turn });
        let constant = edge_1.cross(edge_2);
        let linear = edge_1.cross(turn_2) + turn_1.cross(edge_2);
        let square = turn_1.cross(turn_2);
        let mut range = [f64::NEG_INFINITY, f64::INFINITY];
        for normal in normals {
            let [c0, c1, c2] = [constant, linear, square].map(|cross| cross.dot(normal));
            if c0 <= 0.0 {
                return [0.0; 2];
            }
            range = both(range, [-first_root(c0, -c1, c2), first_root(c0, c1, c2)]);
        }
        range
    }

    /// Returns the offsets `[down, up]` in metres between which no triangle of the mesh is folded:
    /// the limits of displacement inward and outward. See [`Self::fold_range`].
    pub fn unfolded_range(&self) -> [f64; 2] {
        (0..self.triangles.len() as u32)
            .map(|triangle| self.fold_range(triangle))
            .fold([f64::NEG_INFINITY, f64::INFINITY], both)
    }

    /// Number of triangles that fold while the mesh is displaced between the two `offsets_m`, in
    /// metres. A triangle counts if it is folded at one of them or at an offset between it and 0.
    /// All triangles count if an offset is NaN.
    pub fn folded(&self, offsets_m: [f64; 2]) -> usize {
        let [low, high] = offsets_m;
        let is_unfolded =
            |[down, up]: [f64; 2]| [0.0, low, high].into_iter().all(|offset| down < offset && offset < up);
        (0..self.triangles.len() as u32).filter(|&triangle| !is_unfolded(self.fold_range(triangle))).count()
    }
}

/// Intersection of two ranges.
fn both(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].max(b[0]), a[1].min(b[1])]
}

/// Least positive root of `c0 + c1 x + c2 x²` with a positive `c0`. Infinite if there is none.
fn first_root(c0: f64, c1: f64, c2: f64) -> f64 {
    let discriminant = c1 * c1 - 4.0 * c0 * c2;
    if discriminant < -NOTHING * c1 * c1 {
        return f64::INFINITY;
    }
    // This way neither root is a difference of nearly equal numbers.
    let q = -0.5 * (c1 + discriminant.max(0.0).sqrt().copysign(c1));
    let positive = |root: f64| if root > 0.0 { root } else { f64::INFINITY };
    positive(q / c2).min(positive(c0 / q))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Vertex, cube, sphere, square, torus};
    use glam::{Quat, Vec2, Vec3};
    use proptest::prelude::*;
    use proptest::strategy::ValueTree;
    use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

    /// A mesh of one triangle.
    fn triangle(positions: [Vec3; 3], normals: [Vec3; 3]) -> Mesh {
        let vertex = |at: usize| Vertex {
            position: positions[at],
            normal: normals[at],
            tangent: Vec3::X,
            bitangent: Vec3::Z,
            uv: Vec2::ZERO,
        };
        Mesh::new([0, 1, 2].map(vertex).to_vec(), vec![[0, 1, 2]]).expect("a mesh")
    }

    /// Least Jacobian at an offset over points of a triangle's shell, from finite differences.
    fn least_jacobian(mesh: &Mesh, offset: f64, divisions: i32) -> f64 {
        let corners = mesh.corners(0);
        let [p, n]: [[DVec3; 3]; 2] = [
            corners.map(|corner| corner.position.as_dvec3()),
            corners.map(|corner| corner.normal.as_dvec3()),
        ];
        let shell = |v: f64, w: f64, h: f64| {
            let weights = [1.0 - v - w, v, w];
            (0..3).map(|i| (p[i] + n[i] * h) * weights[i]).sum::<DVec3>()
        };
        let mut least = f64::INFINITY;
        for i in 0..=divisions {
            for j in 0..=divisions - i {
                let [v, w] = [i, j].map(|part| f64::from(part) / f64::from(divisions));
                let step = 0.25;
                let by_v = shell(v + step, w, offset) - shell(v - step, w, offset);
                let by_w = shell(v, w + step, offset) - shell(v, w - step, offset);
                let by_h = shell(v, w, offset + step) - shell(v, w, offset - step);
                least = least.min(by_v.cross(by_w).dot(by_h) / (2.0 * step).powi(3));
            }
        }
        least
    }

    /// Whether sampling confirms the range of the closed form: no fold at a hundred offsets before
    /// either end, up to 4 m, and a fold just behind it.
    fn agrees(mesh: &Mesh, [down, up]: [f64; 2]) -> bool {
        if [down, up] == [0.0; 2] {
            return least_jacobian(mesh, 0.0, 6) <= 0.0;
        }
        [down, up].into_iter().all(|end| {
            let reach = end.clamp(-4.0, 4.0);
            let is_clear = (0..100).all(|i| least_jacobian(mesh, reach * f64::from(i) / 100.0, 6) > 0.0);
            is_clear && (reach != end || least_jacobian(mesh, end * (1.0 + 1e-6), 6) < 0.0)
        })
    }

    /// A triangle with sides of 0.2 to 2 m. Its vertex normals differ from its own by up to 70°,
    /// rarely more.
    fn random_shell() -> impl Strategy<Value = Mesh> {
        let corner = (0.2f32..1.0, -0.9f32..0.9);
        let lean = (0f32..1.3, 0f32..std::f32::consts::TAU);
        (prop::array::uniform3(corner), prop::array::uniform3(lean), prop::array::uniform3(-3f32..3.0))
            .prop_map(|(corners, leans, turn)| {
                let turn = Quat::from_scaled_axis(turn.into());
                let position = |at: usize| {
                    let (radius, angle) = corners[at];
                    let angle = angle + at as f32 * std::f32::consts::TAU / 3.0;
                    turn * Vec3::new(radius * angle.sin(), 0.0, radius * angle.cos())
                };
                let normal = |at: usize| {
                    let ((sin, cos), (sin_way, cos_way)) = (leans[at].0.sin_cos(), leans[at].1.sin_cos());
                    turn * Vec3::new(sin * sin_way, cos, sin * cos_way)
                };
                triangle([0, 1, 2].map(position), [0, 1, 2].map(normal))
            })
    }

    #[test]
    fn random_shells_fold_where_sampling_says() {
        let mut runner =
            TestRunner::new_with_rng(Config::default(), TestRng::deterministic_rng(RngAlgorithm::ChaCha));
        let [mut right, mut bounded, mut noticed] = [0; 3];
        for _ in 0..300 {
            let mesh = random_shell().new_tree(&mut runner).expect("a shell").current();
            let range = mesh.fold_range(0);
            right += usize::from(agrees(&mesh, range));
            bounded += usize::from(range.iter().any(|end| end.is_finite()));
            // Ends that are wrong by a hundredth, either way.
            let is_noticed = |factor: f64| !agrees(&mesh, range.map(|end| end * factor));
            noticed += usize::from(is_noticed(1.02) && is_noticed(0.98));
        }
        assert_eq!(right, 300);
        assert!(bounded > 200 && noticed > 200, "{bounded} {noticed}");
    }

    #[test]
    fn a_shell_folds_first_at_any_of_its_corners() {
        // One normal leans far outward. The range is the same for each of the three.
        let positions = [Vec3::ZERO, Vec3::Z, Vec3::X];
        let normals = [Vec3::Y, Vec3::new(0.6, 0.8, 0.0), Vec3::new(-0.6, 0.8, 0.0)];
        let turned = |by: usize| {
            let corner = |at: usize| (at + by) % 3;
            triangle([0, 1, 2].map(|at| positions[corner(at)]), [0, 1, 2].map(|at| normals[corner(at)]))
        };
        let [a, b, c] = [0, 1, 2].map(|by| turned(by).fold_range(0));
        for other in [b, c] {
            assert!((0..2).all(|end| a[end] == other[end] || (a[end] - other[end]).abs() < 1e-12));
        }
        assert!(a[1].is_finite() && agrees(&turned(0), a));
    }

    #[test]
    fn spheres_and_tori_fold_at_their_radius() {
        let sphere = sphere(128, 64).expect("a mesh");
        let [down, up] = sphere.unfolded_range();
        assert!((down + 0.5).abs() < 5e-3 && up == f64::INFINITY, "{down} {up}");
        let folding = (0..sphere.triangles().len() as u32).filter(|&at| sphere.fold_range(at)[0] > -0.51);
        assert_eq!(folding.count(), sphere.triangles().len());
        // Inward it is the tube's radius. Outward the inner equator closes at the radius of the
        // hole.
        let torus = torus(128, 64).expect("a mesh");
        let [down, up] = torus.unfolded_range();
        assert!((down + 0.15).abs() < 1e-3 && (up - 0.2).abs() < 1e-3, "{down} {up}");
        let count = torus.triangles().len();
        assert_eq!([[-0.14, 0.19], [-0.16, 0.0], [-0.19, -0.17]].map(|o| torus.folded(o)), [0, count, count]);
        let some = torus.folded([0.0, 0.25]);
        assert!(some > 0 && some < count / 2, "{some}");
        assert_eq!(torus.folded([f64::NAN, 0.0]), count);
    }

    #[test]
    fn flat_meshes_never_fold() {
        let never = [f64::NEG_INFINITY, f64::INFINITY];
        let [a, b] = [square(3), cube(2)].map(|mesh| mesh.expect("a mesh"));
        assert_eq!([a.unfolded_range(), b.unfolded_range()], [never; 2]);
        assert_eq!([a.folded([-1e9, 1e9]), b.folded(never)], [0, 24 * 2]);
        // A rotated mesh whose normals have rounded last bits.
        let mut turned = a;
        let turn = Quat::from_scaled_axis(Vec3::new(0.3, 1.1, -0.7));
        for (at, vertex) in turned.vertices.iter_mut().enumerate() {
            vertex.position = turn * vertex.position;
            vertex.normal = turn * vertex.normal + Vec3::splat([-1e-7, 0.0, 1e-7][at % 3]);
        }
        assert_eq!(turned.unfolded_range(), never);
        assert_eq!(Mesh::new(Vec::new(), Vec::new()).expect("an empty mesh").unfolded_range(), never);
    }

    #[test]
    fn what_has_no_front_is_folded_already() {
        let positions = [Vec3::ZERO, Vec3::Z, Vec3::X];
        let cases = [
            (positions, [Vec3::NEG_Y; 3]),
            (positions, [Vec3::Y, Vec3::Y, Vec3::new(0.0, -0.6, 0.8)]),
            (positions, [Vec3::Y, Vec3::X, Vec3::Y]),
            (positions, [Vec3::ZERO; 3]),
            ([Vec3::ZERO, Vec3::X, 2.0 * Vec3::X], [Vec3::Y; 3]),
            ([Vec3::ONE; 3], [Vec3::Y, Vec3::X, Vec3::Z]),
        ];
        for (positions, normals) in cases {
            let mesh = triangle(positions, normals);
            assert_eq!((mesh.fold_range(0), mesh.folded([0.0; 2])), ([0.0; 2], 1));
        }
        // Ranges are ordered for numbers of any size.
        for size in [1e-38, 1e-20, 1e18, 1e38] {
            let normals = [Vec3::Y, Vec3::new(0.0, 0.8, 0.6), Vec3::new(0.6, 0.8, 0.0)];
            let [down, up] = triangle(positions.map(|p| p * size), normals).fold_range(0);
            assert!(down <= 0.0 && up >= 0.0, "{size}: {down} {up}");
        }
    }
}
