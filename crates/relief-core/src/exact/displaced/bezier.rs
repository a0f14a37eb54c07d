//! The sheet over a triangle inside one cell, as a cubic Bézier triangle.
//!
//! Position and normal are linear over the triangle. The displacement is quadratic, because the
//! texture position is linear and the bilinear patch has degree two. So `P + D N` is cubic, and
//! lies in the convex hull of its ten Bézier coefficients.
//!
//! This hull is tighter than the hull of a shell: its distance from the sheet falls with the square
//! of the triangle's size. That keeps the search short where a ray grazes the sheet.

use glam::{DMat2, DMat3, DVec2, DVec3, Vec3Swizzles};

use super::relief::Cell;
use super::shell::Corner;

/// The sheet over a triangle inside one cell.
#[derive(Clone, Debug)]
pub(super) struct Sheet<'a> {
    cell: &'a Cell,
    pub corners: [Corner; 3],
    /// `[b300, b030, b003, b210, b120, b021, b012, b102, b201, b111]`.
    control: [DVec3; 10],
}

/// A point of a sheet. Its position is given by the weights of the second and the third corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct SheetPoint {
    /// Position in ray space.
    pub point: DVec3,
    /// Derivatives of the point by these two weights.
    pub tangents: [DVec3; 2],
    /// Volume spanned by the shell's derivatives by the weights and by the displacement. It is
    /// positive where the shell keeps the orientation of the base triangle's corners.
    pub volume: f64,
    pub weights: DVec3,
    pub height: f64,
}

/// Known crossings of the ray with a sheet.
pub(super) enum Crossings {
    None,
    /// Exactly one crossing.
    One(SheetPoint),
    Unknown,
}

/// Indices into `control` of the coefficients whose differences are the derivatives by the second
/// and by the third weight. Each derivative is `3 (to - from)`, in the order of the six
/// coefficients of a quadratic.
const DIFFERENCES: [[[usize; 2]; 6]; 2] =
    [[[0, 3], [3, 4], [4, 1], [8, 9], [9, 5], [7, 6]], [[0, 8], [3, 9], [4, 5], [8, 7], [9, 6], [7, 2]]];

/// Corners and inner coefficients of the three sides.
const SIDES: [[usize; 4]; 3] = [[0, 3, 4, 1], [1, 5, 6, 2], [2, 7, 8, 0]];

/// Largest deviation of the derivative over a sheet for which Newton's method is certain.
const STRAY: f64 = 0.25;

/// Slowest rate of convergence of Newton's method under that limit: `2 STRAY / (1 - STRAY)`.
const RATE: f64 = 2.0 * STRAY / (1.0 - STRAY);

/// Limit of Newton steps, above what convergence at that rate takes. Convergence is mostly
/// quadratic.
const MAX_STEPS: u32 = 64;

impl<'a> Sheet<'a> {
    pub fn new(cell: &'a Cell, corners: [Corner; 3]) -> Self {
        let [a, b, c] = &corners;
        let d = |i: usize, j: usize| cell.displacement_blossom(corners[i].place, corners[j].place);
        let [daa, dbb, dcc, dab, dbc, dca] = [d(0, 0), d(1, 1), d(2, 2), d(0, 1), d(1, 2), d(2, 0)];
        // Coefficient with two shares of one corner and one share of the other.
        let mixed = |two: &Corner, one: &Corner, d_two: f64, d_mixed: f64| {
            let positions = 2.0 * two.position + one.position;
            (positions + d_two * one.normal + 2.0 * d_mixed * two.normal) / 3.0
        };
        let control = [
            a.at(daa),
            b.at(dbb),
            c.at(dcc),
            mixed(a, b, daa, dab),
            mixed(b, a, dbb, dab),
            mixed(b, c, dbb, dbc),
            mixed(c, b, dcc, dbc),
            mixed(c, a, dcc, dca),
            mixed(a, c, daa, dca),
            (a.at(dbc) + b.at(dca) + c.at(dab)) / 3.0,
        ];
        Self { cell, corners, control }
    }

    /// Bézier coefficients, whose hull holds the sheet.
    pub fn hull(&self) -> impl Iterator<Item = DVec3> + Clone {
        self.control.iter().copied()
    }

    /// Splits the sheet in two along a line from the middle of the longest side.
    pub fn split(&self) -> [Self; 2] {
        let length = |side: [usize; 4]| -> f64 {
            side.windows(2).map(|pair| self.control[pair[0]].distance(self.control[pair[1]])).sum()
        };
        let lengths = SIDES.map(length);
        let first = if lengths[0] >= lengths[1] && lengths[0] >= lengths[2] {
            0
        } else if lengths[1] >= lengths[2] {
            1
        } else {
            2
        };
        let second = (first + 1) % 3;
        let middle = self.corners[first].middle(&self.corners[second]);
        let with = |k: usize| {
            let mut corners = self.corners;
            corners[k] = middle;
            Self::new(self.cell, corners)
        };
        [with(second), with(first)]
    }

    /// Evaluates a point of the sheet.
    pub fn at(&self, weights: DVec2) -> SheetPoint {
        let [a, b, c] = &self.corners;
        let all = DVec3::new(1.0 - weights.x - weights.y, weights.x, weights.y);
        let place = all.x * a.place + all.y * b.place + all.z * c.place;
        let normal = all.x * a.normal + all.y * b.normal + all.z * c.normal;
        let position = all.x * a.position + all.y * b.position + all.z * c.position;
        let (metres, slope) = self.cell.displacement(place);
        let shell = [b, c].map(|other| (other.position - a.position) + metres * (other.normal - a.normal));
        let rise = [b, c].map(|other| slope.dot(other.place - a.place));
        SheetPoint {
            point: position + metres * normal,
            tangents: [shell[0] + rise[0] * normal, shell[1] + rise[1] * normal],
            volume: DMat3::from_cols(shell[0], shell[1], normal).determinant(),
            weights: all.x * a.weights + all.y * b.weights + all.z * c.weights,
            height: self.cell.height(place),
        }
    }

    /// Returns the crossing of the ray with the sheet, to `error` metres beside it, if that can be
    /// decided.
    ///
    /// Let `F` be the sheet's lateral coordinates as a function of the weights. Let `J` be the mean
    /// of its derivative's coefficients, and `y = J w`. So the triangle is about as large in `y` as
    /// it looks along the ray.
    ///
    /// Suppose that all coefficients, times the inverse of `J`, are within `STRAY` of the identity
    /// (in the Frobenius norm). Then so is the derivative of `F` by `y`, at every point and on the
    /// mean between any two. It is a convex combination of the coefficients. So `F` takes no value
    /// twice. Consider a step of Newton's method, brought back to the nearest point of the triangle
    /// in `y`. It takes any point of the triangle nearer to a root in it, by the factor `RATE` or
    /// better. Steps longer than this allows prove that there is no root.
    ///
    /// A root just outside is replaced by the nearest point of the triangle. That point is as near
    /// to the ray as the triangle is, except for the factor `1 + STRAY`.
    pub fn crossings(&self, error: f64) -> Crossings {
        let derivative = |k: usize| {
            let column = |axis: usize| {
                let [from, to] = DIFFERENCES[axis][k];
                3.0 * (self.control[to] - self.control[from]).xy()
            };
            DMat2::from_cols(column(0), column(1))
        };
        let derivatives: [DMat2; 6] = std::array::from_fn(derivative);
        let mean = derivatives.iter().fold(DMat2::ZERO, |sum, matrix| sum + *matrix) * (1.0 / 6.0);
        let determinant = mean.determinant();
        if determinant == 0.0 || !determinant.recip().is_finite() {
            return Crossings::Unknown;
        }
        let inverse = mean.inverse();
        let is_near = |matrix: &DMat2| {
            let off = *matrix * inverse - DMat2::IDENTITY;
            off.x_axis.length_squared() + off.y_axis.length_squared() <= STRAY * STRAY
        };
        if derivatives.iter().all(is_near) { self.newton(&mean, error) } else { Crossings::Unknown }
    }

    fn newton(&self, mean: &DMat2, error: f64) -> Crossings {
        let mut weights = DVec2::splat(1.0 / 3.0);
        let mut here = self.at(weights);
        // No two points of a triangle are further apart than its longest side is long.
        let [x, y] = [mean.x_axis, mean.y_axis];
        let mut distance = x.length().max(y.length()).max((x - y).length());
        for _ in 0..MAX_STEPS {
            let was_there = here.point.xy().length() <= error;
            let jacobian = DMat2::from_cols(here.tangents[0].xy(), here.tangents[1].xy());
            let step = jacobian.inverse() * -here.point.xy();
            if (*mean * step).length() > (1.0 + RATE) * distance + error {
                return Crossings::None;
            }
            let next = into_triangle(weights + step, mean);
            let moved = (*mean * (next - weights)).length();
            weights = next;
            here = self.at(weights);
            if was_there || moved <= 0.01 * error {
                break;
            }
            distance *= RATE;
        }
        if here.point.xy().length() <= error { Crossings::One(here) } else { Crossings::None }
    }
}

/// Point with weights `x >= 0`, `y >= 0` and `x + y <= 1` that is nearest to `weights`. Distances
/// are measured after the matrix `shown` is applied.
fn into_triangle(weights: DVec2, shown: &DMat2) -> DVec2 {
    if weights.min_element() >= 0.0 && weights.x + weights.y <= 1.0 {
        return weights;
    }
    let on_side = |from: DVec2, to: DVec2| {
        let (side, point) = (*shown * (to - from), *shown * (weights - from));
        let s = (point.dot(side) / side.length_squared()).clamp(0.0, 1.0);
        let near = from.lerp(to, s);
        ((*shown * (weights - near)).length(), near)
    };
    let [a, b, c] =
        [on_side(DVec2::ZERO, DVec2::X), on_side(DVec2::X, DVec2::Y), on_side(DVec2::Y, DVec2::ZERO)];
    let nearer = |a: (f64, DVec2), b: (f64, DVec2)| if b.0 < a.0 { b } else { a };
    nearer(a, nearer(b, c)).1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exact::displaced::relief::Relief;
    use crate::{HeightMap, Wrap};

    fn relief() -> Relief {
        let map = HeightMap::new(2, 2, vec![0.1, 0.9, 0.6, 0.0], Wrap::Clamp).expect("a valid map");
        Relief::new(&map, 0.5, -0.1)
    }

    fn corners() -> [Corner; 3] {
        let corner = |k: usize, position: [f64; 3], normal: [f64; 3], place: [f64; 2]| Corner {
            position: position.into(),
            normal: normal.into(),
            weights: DVec3::AXES[k],
            place: place.into(),
        };
        [
            corner(0, [-0.4, -0.3, 2.0], [0.1, 0.0, -1.0], [0.0, 0.1]),
            corner(1, [0.1, 0.9, 2.5], [0.0, 0.3, -1.0], [0.2, 0.9]),
            corner(2, [0.8, -0.2, 2.2], [0.2, -0.1, -0.9], [1.0, 0.3]),
        ]
    }

    /// Bernstein polynomials in the order of the coefficients.
    fn bernstein([a, b, c]: [f64; 3]) -> [f64; 10] {
        [
            a * a * a,
            b * b * b,
            c * c * c,
            3.0 * a * a * b,
            3.0 * a * b * b,
            3.0 * b * b * c,
            3.0 * b * c * c,
            3.0 * c * c * a,
            3.0 * c * a * a,
            6.0 * a * b * c,
        ]
    }

    #[test]
    fn the_coefficients_are_those_of_the_sheet() {
        let cell = relief().cell([0, 0]);
        let sheet = Sheet::new(&cell, corners());
        for (x, y) in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (0.3, 0.3), (0.7, 0.1), (0.05, 0.9)] {
            let at = sheet.at(DVec2::new(x, y));
            let shares = bernstein([1.0 - x - y, x, y]);
            let sum: DVec3 = shares.iter().zip(sheet.control).map(|(share, point)| *share * point).sum();
            assert!((sum - at.point).length() < 1e-14);
            for (axis, step) in [(0, DVec2::X), (1, DVec2::Y)] {
                let ends = [-1e-6, 1e-6].map(|s| sheet.at(DVec2::new(x, y) + s * step).point);
                assert!(((ends[1] - ends[0]) / 2e-6 - at.tangents[axis]).length() < 1e-8);
            }
        }
        for part in sheet.split() {
            let middle = part.at(DVec2::splat(1.0 / 3.0));
            let whole = sheet.at(middle.weights.yz());
            assert!((middle.point - whole.point).length() < 1e-14);
            assert!(middle.volume * whole.volume > 0.0, "halves keep the turn");
        }
    }

    #[test]
    fn differences_of_coefficients_are_the_derivative() {
        let cell = relief().cell([0, 0]);
        let sheet = Sheet::new(&cell, corners());
        let (x, y) = (0.25, 0.35);
        let [a, b, c] = [1.0 - x - y, x, y];
        // The order of the table is aa, ab, bb, ac, bc, cc.
        let shares = [a * a, 2.0 * a * b, b * b, 2.0 * a * c, 2.0 * b * c, c * c];
        for (axis, pairs) in DIFFERENCES.iter().enumerate() {
            let difference = |[from, to]: &[usize; 2]| 3.0 * (sheet.control[*to] - sheet.control[*from]);
            let sum: DVec3 = shares.iter().zip(pairs).map(|(share, pair)| *share * difference(pair)).sum();
            assert!((sum - sheet.at(DVec2::new(x, y)).tangents[axis]).length() < 1e-14);
        }
    }

    #[test]
    fn a_sheet_that_faces_the_ray_is_solved_at_once() {
        let cell = relief().cell([0, 0]);
        for aim in [DVec2::new(0.2, 0.3), DVec2::new(0.0, 0.5), DVec2::new(0.6, 0.4), DVec2::ZERO] {
            let target = Sheet::new(&cell, corners()).at(aim).point;
            let aimed = corners()
                .map(|corner| Corner { position: corner.position - target.xy().extend(0.0), ..corner });
            let Crossings::One(found) = Sheet::new(&cell, aimed).crossings(1e-13) else {
                panic!("{aim} is not found");
            };
            assert!((found.weights.yz() - aim).length() < 1e-12);
            let aside = corners().map(|corner| Corner {
                position: corner.position - (target.xy() + DVec2::splat(2.0)).extend(0.0),
                ..corner
            });
            assert!(matches!(Sheet::new(&cell, aside).crossings(1e-13), Crossings::None));
        }
    }

    #[test]
    fn points_come_back_to_the_nearest_of_the_triangle() {
        let grid = (0..=200).flat_map(|i| (0..=200 - i).map(move |j| DVec2::new(i.into(), j.into()) / 200.0));
        let grid: Vec<DVec2> = grid.collect();
        for shown in [DMat2::IDENTITY, DMat2::from_cols_array(&[2.0, 0.3, -1.0, 0.5])] {
            for (i, j) in (-8..=8).flat_map(|i| (-8..=8).map(move |j| (i, j))) {
                let point = DVec2::new(i.into(), j.into()) * 0.31;
                let near = into_triangle(point, &shown);
                assert!(near.min_element() >= 0.0 && near.x + near.y <= 1.0 + 1e-15);
                let distance = |at: DVec2| (shown * (at - point)).length();
                let least = grid.iter().map(|at| distance(*at)).fold(f64::INFINITY, f64::min);
                assert!(distance(near) <= least + 1e-12, "{point}: {near}");
            }
        }
    }
}
