//! A second exact tracer for objects, which finds the same solids as [`ImageObject::first_hit`] by
//! other means.
//!
//! It does not step from cell to cell. For each image it collects and sorts the ray's crossings
//! with all lines between cells. Between two crossings the ray is in one cell. There the height
//! above the map, times the square of the distance along the image's axis, is a quadratic in the
//! ray's own parameter. It is halved until the Bernstein coefficients of each part have one sign
//! (Lane and Riesenfeld 1981, "Bounds on a polynomial"). The lists of all images are then
//! intersected.

use super::patch::{Patch, Solid};
use super::{EMPTY_HEIGHT, ImageObject, JumpCells};
use crate::raycast::Ray;

impl ImageObject {
    /// Returns all parameters of a ray, from 0 on, at which it is in the object: intervals in
    /// ascending order, in units of its direction.
    ///
    /// Solids and valid rays are defined as for
    /// [`first_hit`](Self::first_hit). It shares neither
    /// traversal nor root finder, so intervals end [`AGREEMENT`](super::AGREEMENT) later than the
    /// solids. The cost per image is sorting the lines between all cells on the ray.
    pub fn intervals(&self, ray: &Ray) -> Vec<[f64; 2]> {
        self.common_intervals(ray, Solid::Depth)
    }

    /// Returns all parameters of a ray, from 0 on, at which it is in the [visual
    /// hull](Self::hull_first_hit), in the form of [`intervals`](Self::intervals).
    pub fn hull_intervals(&self, ray: &Ray) -> Vec<[f64; 2]> {
        self.common_intervals(ray, Solid::Silhouette)
    }

    /// Intersection of the lists of all images.
    fn common_intervals(&self, ray: &Ray, solid: Solid) -> Vec<[f64; 2]> {
        let mut common = vec![[0.0, f64::INFINITY]];
        for number in 0..self.views.len() {
            let list = self.image_intervals(number, ray, solid);
            common = intersection(&common, &list);
            if common.is_empty() {
                break;
            }
        }
        common
    }

    /// Intervals in which a ray is in the solid of one image.
    fn image_intervals(&self, number: usize, ray: &Ray, solid: Solid) -> Vec<[f64; 2]> {
        let mut list: Vec<[f64; 2]> = Vec::new();
        let Some(slack) = self.slack(number, ray) else { return list };
        let seen = Projected::new(self, number, ray);
        let Some([begin, end]) = seen.range() else { return list };
        let cuts = seen.cuts(begin, end, matches!(self.cells, JumpCells::Step | JumpCells::Nearest));
        for pair in cuts.windows(2) {
            let [a, b] = [pair[0], pair[1]];
            let middle = a + 0.5 * (b - a);
            if a < middle && middle < b {
                self.pieces(&seen, number, solid, [a, b], &mut |[from, to]| match list.last_mut() {
                    Some(last) if last[1] + slack >= from => last[1] = to,
                    _ => list.push([from, to]),
                });
            }
        }
        list.iter_mut().for_each(|interval| interval[1] += slack);
        list
    }

    /// Calls `keep` with the parts of `[a, b]` in which the ray is in the solid. `[a, b]` must lie
    /// in one cell, and in one quarter of it.
    fn pieces(
        &self,
        seen: &Projected,
        number: usize,
        solid: Solid,
        [a, b]: [f64; 2],
        keep: &mut impl FnMut([f64; 2]),
    ) {
        let middle = a + 0.5 * (b - a);
        let place = [0, 1].map(|axis| at(seen.place[axis], middle) / at(seen.depth, middle));
        let last = seen.size.map(|side| side - 1.0);
        let cell = [0, 1].map(|axis| place[axis].floor().clamp(-1.0, last[axis]));
        let corners = match self.patch(number, cell.map(|at| at as i64), solid) {
            Patch::Bilinear(corners) => corners,
            Patch::Flat(height) => [height; 4],
            Patch::Quarters(corners) => {
                let right = place[0] - cell[0] >= 0.5;
                let down = place[1] - cell[1] >= 0.5;
                [corners[usize::from(right) + 2 * usize::from(down)]; 4]
            }
        };
        let height = match solid {
            Solid::Depth => seen.height,
            Solid::Silhouette => seen.depth.map(|part| 0.5 * part),
        };
        // All values are times the depth: positions in the cell, and their distances from its other
        // side.
        let gap = |t: f64| {
            let depth = at(seen.depth, t);
            let [u, v] = [0, 1].map(|axis| at(seen.place[axis], t) - cell[axis] * depth);
            let [h00, h10, h01, h11] = corners;
            let (rest_u, rest_v) = (depth - u, depth - v);
            at(height, t) * depth - (rest_v * (rest_u * h00 + u * h10) + v * (rest_u * h01 + u * h11))
        };
        let (start, value, end) = (gap(a), gap(middle), gap(b));
        below([start, 2.0 * value - 0.5 * (start + end), end], a, b, keep);
    }
}

/// A number that is linear in the ray's parameter: its value at 0, and its change.
type Linear = [f64; 2];

fn at([value, change]: Linear, t: f64) -> f64 {
    value + change * t
}

/// A ray in an image: its position, in texels from the centre of the first one, and its height,
/// each times the depth.
struct Projected {
    size: [f64; 2],
    place: [Linear; 2],
    height: Linear,
    depth: Linear,
}

impl Projected {
    fn new(object: &ImageObject, number: usize, ray: &Ray) -> Self {
        let view = &object.views[number];
        let size = view.size().map(f64::from);
        let [u, v, height, depth] = view.rows().map(|row| {
            let along = row.truncate();
            [along.dot(ray.origin) + row.w, along.dot(ray.direction)]
        });
        let texels = |side: f64, place: Linear| [0, 1].map(|part| side * place[part] - 0.5 * depth[part]);
        Self { size, place: [texels(size[0], u), texels(size[1], v)], height, depth }
    }

    /// Parameters from 0 on at which the ray is in the image's space. `None` if it is never there.
    fn range(&self) -> Option<[f64; 2]> {
        let (mut begin, mut end) = (0.0_f64, f64::INFINITY);
        // In a perspective image nothing behind the eye has heights from 0 to 1, so these bound the
        // depth.
        let sides = [
            self.beyond(self.height, EMPTY_HEIGHT),
            self.beyond(self.height, 1.0).map(|part| -part),
            self.beyond(self.place[0], -1.0),
            self.beyond(self.place[0], self.size[0]).map(|part| -part),
            self.beyond(self.place[1], -1.0),
            self.beyond(self.place[1], self.size[1]).map(|part| -part),
        ];
        for side in sides {
            let crossed = -side[0] / side[1];
            if side[1] > 0.0 {
                begin = begin.max(crossed);
            } else if side[1] < 0.0 {
                end = end.min(crossed);
            } else if side[0] < 0.0 {
                return None;
            }
        }
        (begin < end && end.is_finite()).then_some([begin, end])
    }

    /// Distance of a number beyond a value, times the depth.
    fn beyond(&self, number: Linear, value: f64) -> Linear {
        [0, 1].map(|part| number[part] - value * self.depth[part])
    }

    /// Crossings of the ray with lines between cells, or between their quarters, in a range. The
    /// ends of the range are included.
    fn cuts(&self, begin: f64, end: f64, quarters: bool) -> Vec<f64> {
        let mut cuts = vec![begin, end];
        for axis in 0..2 {
            let ends = [begin, end].map(|t| at(self.place[axis], t) / at(self.depth, t));
            let last = 2.0 * self.size[axis];
            let first = (2.0 * ends[0].min(ends[1])).floor().clamp(-2.0, last);
            let last = (2.0 * ends[0].max(ends[1])).ceil().clamp(-2.0, last);
            for half in first as i64..=last as i64 {
                if quarters || half % 2 == 0 {
                    let line = self.beyond(self.place[axis], 0.5 * half as f64);
                    let crossed = -line[0] / line[1];
                    if begin < crossed && crossed < end {
                        cuts.push(crossed);
                    }
                }
            }
        }
        cuts.sort_by(f64::total_cmp);
        cuts
    }
}

/// Calls `keep` with the parts of `[a, b]` in which a quadratic with these Bernstein coefficients
/// is at most 0, in ascending order. Parts may touch.
fn below([start, control, end]: [f64; 3], a: f64, b: f64, keep: &mut impl FnMut([f64; 2])) {
    let middle = a + 0.5 * (b - a);
    match [start, control, end].map(|coefficient| coefficient <= 0.0) {
        [true, true, true] => keep([a, b]),
        [false, false, false] => {}
        _ if a < middle && middle < b => {
            // Values of the quadratic elsewhere are not used: their rounding would create roots
            // where there are none.
            let (left, right) = (0.5 * (start + control), 0.5 * (control + end));
            let value = 0.5 * (left + right);
            below([start, left, value], a, middle, keep);
            below([value, right, end], middle, b, keep);
        }
        [false, _, false] => {}
        _ => keep([a, b]),
    }
}

/// Intersection of two lists of intervals in ascending order.
fn intersection(one: &[[f64; 2]], other: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let (mut i, mut j, mut common) = (0, 0, Vec::new());
    while i < one.len() && j < other.len() {
        let shared = [one[i][0].max(other[j][0]), one[i][1].min(other[j][1])];
        if shared[0] <= shared[1] {
            common.push(shared);
        }
        if one[i][1] < other[j][1] {
            i += 1;
        } else {
            j += 1;
        }
    }
    common
}

#[cfg(test)]
mod tests {
    use super::{below, intersection};

    #[test]
    fn quadratics_are_below_between_their_roots() {
        let pieces = |c: [f64; 3], a: f64, b: f64| {
            let gap = |t: f64| c[0] + t * (c[1] + t * c[2]);
            let (start, end) = (gap(a), gap(b));
            let mut found: Vec<[f64; 2]> = Vec::new();
            let control = 2.0 * gap(0.5 * (a + b)) - 0.5 * (start + end);
            below([start, control, end], a, b, &mut |[from, to]: [f64; 2]| match found.last_mut() {
                Some([_, last]) if *last == from => *last = to,
                _ => found.push([from, to]),
            });
            found
        };
        let expect = |c, expected: &[[f64; 2]]| {
            let found = pieces(c, 0.0, 4.0);
            let near = |(one, other): (&[f64; 2], &[f64; 2])| {
                (one[0] - other[0]).abs() < 1e-14 && (one[1] - other[1]).abs() < 1e-14
            };
            assert!(
                found.len() == expected.len() && found.iter().zip(expected).all(near),
                "{c:?}: {found:?}"
            );
        };
        expect([3.0, -4.0, 1.0], &[[1.0, 3.0]]);
        expect([-3.0, 4.0, -1.0], &[[0.0, 1.0], [3.0, 4.0]]);
        expect([1.0, 0.0, 1.0], &[]);
        expect([-1.0, 0.0, -1.0], &[[0.0, 4.0]]);
        expect([1.0, -0.5, 0.0], &[[2.0, 4.0]]);
        expect([-1.0, 0.5, 0.0], &[[0.0, 2.0]]);
        expect([3.0001, -4.0, 1.3333], &[]);
    }

    #[test]
    fn lists_have_in_common_what_is_in_both() {
        let one = [[0.0, 2.0], [3.0, 4.0], [5.0, 9.0]];
        assert_eq!(intersection(&one, &[[1.0, 3.5], [6.0, 7.0]]), [[1.0, 2.0], [3.0, 3.5], [6.0, 7.0]]);
        assert_eq!(intersection(&one, &[[2.0, 3.0]]), [[2.0, 2.0], [3.0, 3.0]]);
        assert_eq!(intersection(&one, &[]), [[0.0; 2]; 0]);
        assert_eq!(intersection(&one, &[[-1.0, f64::INFINITY]]), one);
    }
}
