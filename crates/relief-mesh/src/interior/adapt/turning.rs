//! Bend of a displaced base triangle: its distance from the flat pieces between its points, besides
//! the heights of the map.
//!
//! A point of the triangle is `P + H N`: `P` on the base, `N` the direction of displacement, `H`
//! the height of the map plus the lift of a smooth base. Over a piece whose corners have the
//! weights `w`, it differs from the interpolated point by at most the sum of
//!
//! - `Σ w w' |H - H'| |N - N'|` over the pairs of corners, because `H` and `N` both vary;
//! - `|H| |N - N̄|`, `N̄` interpolated: 0 where `N` is interpolated, too; for directions of length
//!   1 see [`Turning::off_chord`];
//! - the error of a quadratic lift, `Σ w w' |Q(p - p')|`, with `Q` its quadratic form and `p` the
//!   corners' places in the triangle;
//! - the error of a cubic `P`, by the control points of its part over the piece: see
//!   [`Cubic::off_piece`].

use glam::DVec3;

use crate::cubic::Cubic;
use crate::point;

/// Greatest product of two weights.
const PAIR: f64 = 0.25;

/// Base triangle with its turning directions and its bent surface. Lengths are in heights of the
/// map.
#[derive(Clone, Copy, Debug)]
pub struct Turning {
    /// Directions of displacement at its corners. Their unit is the longest direction; directions
    /// that are normalised may have any length.
    pub directions: [DVec3; 3],
    /// Whether directions between these are normalised.
    pub is_unit: bool,
    /// Displacement at height 0.
    pub at_zero: f64,
    /// Weights of its corners in the triangle to which the smooth base belongs.
    pub part: [[f64; 3]; 3],
    /// Lifts of a smooth base for the sides of that triangle. Side `k` goes from corner `k` to the
    /// next.
    pub lifts: [f64; 3],
    /// Cubic base, if any.
    pub cubic: Option<Cubic>,
    /// Factor on each bend, more than 1 where triangles lie on one side of the relief.
    pub factor: f64,
}

/// Corner of a piece: its weights in the triangle, and its height of the map.
pub type PieceCorner = ([f64; 3], f64);

impl Turning {
    /// Creates a flat triangle with interpolated directions.
    pub fn flat(directions: [DVec3; 3]) -> Self {
        let part = point::CORNERS;
        Self { directions, is_unit: false, at_zero: 0.0, part, lifts: [0.0; 3], cubic: None, factor: 1.0 }
    }

    /// Returns the interpolated direction, not normalised.
    fn raw(&self, [a, b, c]: [f64; 3]) -> DVec3 {
        self.directions[0] * a + self.directions[1] * b + self.directions[2] * c
    }

    /// Returns weights in the whole triangle, given weights in the part.
    fn in_whole(&self, weights: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|k| (0..3).map(|corner| self.part[corner][k] * weights[corner]).sum())
    }

    /// Returns the quadratic form of the lift, at weights or at differences of weights.
    fn lift(&self, of: [f64; 3]) -> f64 {
        let along = |k: usize| self.lifts[k] * of[k] * of[(k + 1) % 3];
        along(0) + along(1) + along(2)
    }

    /// Returns a bound on the bend of a piece, times [`factor`](Self::factor).
    pub fn bend(&self, corners: [PieceCorner; 3]) -> f64 {
        self.factor * self.bend_itself(corners)
    }

    fn bend_itself(&self, corners: [PieceCorner; 3]) -> f64 {
        let raw = corners.map(|(weights, _)| self.raw(weights));
        let along = if self.is_unit { raw.map(DVec3::normalize_or_zero) } else { raw };
        let whole = corners.map(|(weights, _)| self.in_whole(weights));
        let heights = [0, 1, 2].map(|k| corners[k].1 + self.lift(whole[k]));
        let each_pair =
            |between: &dyn Fn(usize, usize) -> f64| pairs([between(0, 1), between(1, 2), between(2, 0)]);
        let mut bend = each_pair(&|a, b| (heights[a] - heights[b]).abs() * along[a].distance(along[b]));
        if self.is_unit {
            let most = heights.iter().map(|height| (height + self.at_zero).abs()).fold(0.0, f64::max);
            bend += most * Self::off_chord(along, raw.map(DVec3::length));
        }
        let apart = |a: usize, b: usize| [0, 1, 2].map(|k| whole[a][k] - whole[b][k]);
        if self.lifts != [0.0; 3] {
            bend += each_pair(&|a, b| self.lift(apart(a, b)).abs());
        }
        bend + self.cubic.map_or(0.0, |cubic| cubic.off_piece(whole))
    }

    /// Returns a bound on the distance between a direction that is interpolated and normalised, and
    /// the interpolation of the normalised directions `along` of the corners. `lengths` are the
    /// lengths at the corners before they were normalised.
    ///
    /// The normalised direction lies above a point of the triangle between the corners' directions,
    /// by at most the shortfall of that point's length from 1. That point has other weights: each
    /// times a length over the mean length.
    fn off_chord(along: [DVec3; 3], lengths: [f64; 3]) -> f64 {
        let distance = |a: usize, b: usize| along[a].distance(along[b]);
        let distances = [distance(0, 1), distance(1, 2), distance(2, 0)];
        let short = 1.0 - (1.0 - pairs(distances.map(|distance| distance * distance))).max(0.0).sqrt();
        let farthest = distances.into_iter().fold(0.0, f64::max);
        let [least, most] = lengths
            .iter()
            .fold([f64::INFINITY, 0.0_f64], |[least, most], &length| [least.min(length), most.max(length)]);
        let aside = 0.5 * farthest * (most / least - 1.0);
        // Points of the unit ball are at most 2 apart, whatever the lengths.
        let off = short + aside;
        if off.is_finite() { off.min(2.0) } else { 2.0 }
    }
}

/// Returns the greatest sum of the products of each two of three weights, times these numbers. With
/// the squares of a triangle's sides it is the squared radius of the least circle around it.
fn pairs([a, b, c]: [f64; 3]) -> f64 {
    let most = a.max(b).max(c);
    let rest = a + b + c - most;
    if most >= rest {
        return PAIR * most;
    }
    // Sixteen times the square of that triangle's area.
    let area = 2.0 * (a * b + b * c + c * a) - (a * a + b * b + c * c);
    a * b * c / area
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the weights of some points in a triangle.
    fn points(n: u32) -> Vec<[f64; 3]> {
        let each = (0..=n).flat_map(|i| (0..=n - i).map(move |j| [i, j, n - i - j]));
        each.map(|of| of.map(|part| f64::from(part) / f64::from(n))).collect()
    }

    /// Returns the farthest that the surface leaves a piece, where heights are linear between its
    /// corners.
    fn farthest(turning: &Turning, corners: [PieceCorner; 3]) -> f64 {
        let displaced = |weights: [f64; 3], height: f64| {
            let raw = turning.raw(weights);
            let along = if turning.is_unit { raw.normalize() } else { raw };
            along * (turning.at_zero + height + turning.lift(turning.in_whole(weights)))
        };
        let mut most = 0.0_f64;
        for of in points(60) {
            let weights = [0, 1, 2].map(|k| (0..3).map(|c| of[c] * corners[c].0[k]).sum::<f64>());
            let height: f64 = (0..3).map(|c| of[c] * corners[c].1).sum();
            let between: DVec3 = (0..3).map(|c| displaced(corners[c].0, corners[c].1) * of[c]).sum();
            most = most.max(displaced(weights, height).distance(between));
        }
        most
    }

    fn pieces() -> Vec<[PieceCorner; 3]> {
        let whole = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let small = [[0.5, 0.3, 0.2], [0.4, 0.5, 0.1], [0.6, 0.1, 0.3]];
        let thin = [[0.9, 0.1, 0.0], [0.1, 0.85, 0.05], [0.5, 0.5, 0.0]];
        let heights = [[0.1, 1.0, 0.0], [0.7, 0.7, 0.7]];
        let all = [whole, small, thin].into_iter().flat_map(|weights| heights.map(|of| (weights, of)));
        all.map(|(weights, of)| [0, 1, 2].map(|k| (weights[k], of[k]))).collect()
    }

    #[test]
    fn pieces_are_bent_within_the_bound() {
        let directions = [DVec3::Y, DVec3::new(0.6, 0.8, 0.0), DVec3::new(0.0, 0.8, 0.6)];
        let flat = Turning::flat(directions);
        let uneven = [directions[0], directions[1] * 0.7, directions[2] * 1.3];
        for (about, turning, tight) in [
            ("flat", flat, 0.5),
            ("unit", Turning { is_unit: true, at_zero: -0.4, ..flat }, 0.15),
            ("uneven", Turning { directions: uneven, is_unit: true, at_zero: 0.8, ..flat }, 0.1),
            ("lift", Turning { lifts: [0.3, -0.2, 0.5], ..flat }, 0.2),
            ("all", Turning { lifts: [0.3, 0.1, 0.5], is_unit: true, at_zero: 2.0, ..flat }, 0.1),
        ] {
            for corners in pieces() {
                let (found, said) = (farthest(&turning, corners), turning.bend(corners));
                assert!(found <= said + 1e-12, "{about}, {corners:?}: {found} {said}");
                assert!(found >= tight * said, "{about}, {corners:?}: {found} {said}");
            }
        }
    }

    #[test]
    fn products_of_weights_reach_the_bound() {
        for numbers in [[1.0, 1.0, 1.0], [1.0, 0.5, 0.5], [3.0, 1.0, 0.0], [0.7, 1.0, 0.6], [0.0; 3]] {
            let [a, b, c] = numbers;
            let mut most = 0.0_f64;
            for i in 0..=120 {
                for j in 0..=120 - i {
                    let [x, y, z] = [i, j, 120 - i - j].map(|part| f64::from(part) / 120.0);
                    most = most.max(a * x * y + b * y * z + c * z * x);
                }
            }
            let said = pairs(numbers);
            assert!(most <= said + 1e-12 && most >= 0.999 * said, "{numbers:?}: {most} {said}");
        }
    }
}
