//! Cubic triangles over base triangles.
//!
//! Source: Vlachos, Peters, Boyd and Mitchell 2001, Curved PN Triangles, section 3.

use glam::DVec3;
use relief_core::mesh::BasePoint;

/// Returns the inner control points of a side. They lie a third of the way along it, in the planes
/// perpendicular to the normals of its ends.
pub fn bent(ends: [BasePoint; 2]) -> [DVec3; 2] {
    [0, 1].map(|end| {
        let [from, to] = [ends[end], ends[1 - end]];
        let normal = from.normal.normalize_or_zero();
        let along = to.position - from.position;
        from.position + (along - normal * along.dot(normal)) / 3.0
    })
}

/// Returns the point of a side with the weights `[a, b]` of its ends.
pub fn on_side([from, to]: [DVec3; 2], [first, second]: [DVec3; 2], [a, b]: [f64; 2]) -> DVec3 {
    from * (a * a * a) + (first * a + second * b) * (3.0 * a * b) + to * (b * b * b)
}

/// Returns the inner control point of a triangle. `flat` is the mean of its corners, `sum` the sum
/// of its sides' control points.
pub fn middle(flat: DVec3, sum: DVec3) -> DVec3 {
    sum / 4.0 - flat / 2.0
}

/// Returns the point of a triangle with the weights of its corners. Side `k` goes from corner `k`
/// to the next.
pub fn inside(corners: [DVec3; 3], sides: [[DVec3; 2]; 3], weights: [f64; 3]) -> DVec3 {
    let sum: DVec3 = sides.as_flattened().iter().sum();
    let flat = (corners[0] + corners[1] + corners[2]) / 3.0;
    let mut point = middle(flat, sum) * (6.0 * weights[0] * weights[1] * weights[2]);
    for k in 0..3 {
        let [a, b] = [weights[k], weights[(k + 1) % 3]];
        point += corners[k] * (a * a * a) + (sides[k][0] * a + sides[k][1] * b) * (3.0 * a * b);
    }
    point
}

/// Cubic triangle by its control points. Each is indexed by the three corners that it belongs to,
/// in any order.
#[derive(Clone, Copy, Debug)]
pub struct Cubic([[[DVec3; 3]; 3]; 3]);

/// Greatest sum of the weights of control points along sides, and greatest weight of the middle
/// one.
const ON_SIDES: f64 = 0.75;
const IN_MIDDLE: f64 = 2.0 / 9.0;

impl Cubic {
    /// Creates a triangle from the inner control points of its sides. Side `k` goes from corner `k`
    /// to the next.
    pub fn new(corners: [DVec3; 3], sides: [[DVec3; 2]; 3]) -> Self {
        let beside = |near: usize, far: usize| {
            if (near + 1) % 3 == far { sides[near][0] } else { sides[far][1] }
        };
        let control = |[i, j, k]: [usize; 3]| match (i == j, j == k, k == i) {
            (true, true, _) => corners[i],
            (true, ..) => beside(i, k),
            (_, true, _) => beside(j, i),
            (.., true) => beside(k, j),
            _ => {
                let [a, b, c] = corners;
                middle((a + b + c) / 3.0, sides.as_flattened().iter().sum())
            }
        };
        Self([0, 1, 2].map(|i| [0, 1, 2].map(|j| [0, 1, 2].map(|k| control([i, j, k])))))
    }

    /// Returns the triangle in units of `length`.
    #[must_use]
    pub fn in_units_of(self, length: f64) -> Self {
        Self(self.0.map(|rows| rows.map(|row| row.map(|point| point / length))))
    }

    /// Returns a bound on the distance from the flat piece between three of its points, given by
    /// their weights. The control points of the part over the piece give the bound, as that part is
    /// a mean of them.
    pub fn off_piece(&self, pieces: [[f64; 3]; 3]) -> f64 {
        let sum =
            |weights: [f64; 3], of: [DVec3; 3]| of[0] * weights[0] + of[1] * weights[1] + of[2] * weights[2];
        let all = [0, 1, 2];
        // A part's control points are the triangle's, mixed by the weights of three corners of the
        // piece.
        let once = pieces.map(|weights| self.0.map(|rows| rows.map(|row| sum(weights, row))));
        let twice = |a: usize, b: usize| all.map(|i| sum(pieces[b], once[a][i]));
        let control = |a: usize, b: usize, c: usize| sum(pieces[c], twice(a, b));
        let points = all.map(|a| control(a, a, a));
        let mut on_sides = 0.0_f64;
        for a in all {
            for b in all.into_iter().filter(|b| *b != a) {
                let straight = (points[a] * 2.0 + points[b]) / 3.0;
                on_sides = on_sides.max(control(a, a, b).distance(straight));
            }
        }
        let flat = (points[0] + points[1] + points[2]) / 3.0;
        ON_SIDES * on_sides + IN_MIDDLE * control(0, 1, 2).distance(flat)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    fn corner(direction: DVec3) -> BasePoint {
        BasePoint { position: direction.normalize(), normal: direction.normalize() * 1.7, uv: DVec2::ZERO }
    }

    #[test]
    fn triangles_on_a_sphere_bulge_toward_it_and_meet_their_sides() {
        let corners =
            [DVec3::new(1.0, 0.1, 0.0), DVec3::new(0.2, 1.0, 0.1), DVec3::new(0.1, 0.3, 1.0)].map(corner);
        let sides = [0, 1, 2].map(|k| bent([corners[k], corners[(k + 1) % 3]]));
        let at = |weights| inside(corners.map(|corner| corner.position), sides, weights);
        for k in 0..=10 {
            let part = f64::from(k) / 10.0;
            for side in 0..3 {
                let mut weights = [0.0; 3];
                weights[side] = 1.0 - part;
                weights[(side + 1) % 3] = part;
                let ends = [side, (side + 1) % 3].map(|corner| corners[corner].position);
                let on_side = on_side(ends, sides[side], [1.0 - part, part]);
                assert!(on_side.distance(at(weights)) < 1e-14);
                // In the middle chords are off by 0.17 to 0.25.
                assert!((on_side.length() - 1.0).abs() < 0.09, "{}", on_side.length());
            }
        }
        // The flat triangle's middle is off by 0.28.
        assert!((at([1.0 / 3.0; 3]).length() - 1.0).abs() < 0.12);
    }

    #[test]
    fn pieces_are_as_far_off_as_is_said() {
        let corners =
            [DVec3::new(1.0, 0.1, 0.0), DVec3::new(0.2, 1.0, 0.1), DVec3::new(0.1, 0.3, 1.0)].map(corner);
        let sides = [0, 1, 2].map(|k| bent([corners[k], corners[(k + 1) % 3]]));
        let corners = corners.map(|corner| corner.position);
        let cubic = Cubic::new(corners, sides);
        for piece in [
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            [[0.5, 0.3, 0.2], [0.4, 0.5, 0.1], [0.6, 0.1, 0.3]],
            [[0.9, 0.1, 0.0], [0.1, 0.85, 0.05], [0.5, 0.5, 0.0]],
            [[0.8, 0.2, 0.0], [0.3, 0.7, 0.0], [0.3, 0.7, 0.0]],
        ] {
            let (said, mut found) = (cubic.off_piece(piece), 0.0_f64);
            let points = piece.map(|weights| inside(corners, sides, weights));
            for i in 0..=40 {
                for j in 0..=40 - i {
                    let of = [i, j, 40 - i - j].map(|part| f64::from(part) / 40.0);
                    let weights = [0, 1, 2].map(|k| (0..3).map(|c| of[c] * piece[c][k]).sum());
                    let straight: DVec3 = (0..3).map(|c| points[c] * of[c]).sum();
                    found = found.max(inside(corners, sides, weights).distance(straight));
                }
            }
            assert!(found <= said + 1e-12 && found >= 0.6 * said, "{piece:?}: {found} {said}");
        }
    }

    #[test]
    fn level_triangles_stay_level() {
        let corners = [DVec2::ZERO, DVec2::new(3.0, 0.5), DVec2::new(1.0, 2.0)];
        let corners = corners.map(|at| BasePoint { position: at.extend(0.0), normal: DVec3::Z, uv: at });
        let sides = [0, 1, 2].map(|k| bent([corners[k], corners[(k + 1) % 3]]));
        for weights in [[0.2, 0.3, 0.5], [0.9, 0.05, 0.05], [0.0, 0.4, 0.6]] {
            let flat = BasePoint::weighted(corners, weights).position;
            let found = inside(corners.map(|corner| corner.position), sides, weights);
            assert!(found.distance(flat) < 1e-14, "{weights:?}");
        }
    }
}
