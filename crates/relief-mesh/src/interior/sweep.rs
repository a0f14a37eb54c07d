//! Sweep of a triangle through a grid of voxels.
//!
//! Source: Gumhold and Hüttner 1999, section 3.4. Corners lie on integers of grid space. Each side
//! is divided along the axis in which it is longest (its *main direction*), one part a voxel. An
//! edge is *primary* if the third corner lies between its ends along its main direction. There is
//! always one (theorem 1). The longest primary edge is *swept* along its main direction. Two
//! coordinate planes contain this axis. The triangle is cut in the plane in which its area is
//! larger. The other axis of that plane is the *side*.
//!
//! So the primary edge has one point in each *column*, at its bottom. The two other sides are the
//! top: their points belong to the column to which they round. Points of the grid lie between.
//! Those within a voxel of a side are left out: they are dragged to it, in the paper's words.
//!
//! Neighbouring columns are zipped from below, by the shorter of the two diagonals that turn
//! nothing over. The length of a diagonal is the sum of its extents along both axes, so that
//! integers compare it exactly. Points of the top before the third corner are zipped with the next
//! column, those behind it with the previous one. If the third corner's own column has both, they
//! are closed there, as a roof.
//!
//! The shaders have the same sweep in 32 bits, for GPUs, with sides of at most 1,023 voxels. Here
//! sides have any length. A test of `relief-render` finds the same triangles by both.
//!
//! No piece has three corners on one side: the neighbour could have the same piece, and an edge
//! would have four triangles.
//!
//! Unlike in the paper no differences are accumulated. Each column follows from the three corners
//! alone. So columns can be cut apart, and a point is the same in every block.

use std::ops::Range;

use relief_core::registry::Publication;

use super::{Cut, Fills, Interior, PatchCounts, Pattern};
use crate::Spacing;
use crate::patch::{Patch, PatchPoint};

pub const INTERIOR: Interior = Interior {
    name: "sweep",
    summary: "the points of a grid of voxels in columns along the longest edge, for sides by pixels",
    publication: Publication {
        paper: "Gumhold and Hüttner 1999, Multiresolution Rendering With Displacement Mapping",
        section: "3.4",
    },
    takes: &[Spacing::Voxels],
    why: "a sweep needs a point of each side in every voxel along it",
    fills: Fills::Patch(Pattern { steps, counts, cut }),
};

/// Triangle with the axes of its sweep. Coordinates are along the sweep and along the side, counted
/// from the first end of the primary edge. The third corner, the apex, lies above that edge.
#[derive(Clone, Copy, Debug)]
struct Sweep {
    /// Numbers of the patch's corners: the ends of the primary edge, and the apex.
    corners: [u32; 3],
    /// Other end of the primary edge: `[columns - 1, rise]`.
    end: [i64; 2],
    /// Third corner.
    apex: [i64; 2],
    /// Number of parts of the sides from the first end to the apex, and from there to the other
    /// end.
    parts: [i64; 2],
    /// Whether pieces are turned over, relative to the patch.
    is_turned: bool,
}

/// Point in the plane of the sweep.
#[derive(Clone, Copy, Debug)]
struct PlanePoint {
    /// Coordinates are `[x / w, y / w]`.
    x: i64,
    y: i64,
    w: i64,
    /// Bits of the sides on which it lies.
    sides: u8,
}

/// Bits of the primary edge, the side from its first end to the apex, and the side from there to
/// its other end.
const SIDES: [u8; 3] = [1, 2, 4];

/// Index of a point in the cut, and its coordinates.
type Point = (u32, PlanePoint);

/// Column of points.
#[derive(Debug, Default)]
struct Column {
    /// Points from below: of the primary edge, of the grid, then of the top along the sweep.
    points: Vec<Point>,
    /// Number of points below the top.
    below_top: usize,
    /// Index of the apex in `points`, if the column has it.
    apex: Option<usize>,
    top: Top,
}

/// Partner with which the points of a column's top are zipped.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Top {
    /// The next column: the points lie before the apex, or are the apex.
    #[default]
    Next,
    /// The previous column: the points lie behind the apex.
    Before,
    /// Each other: there are points before the apex and behind it.
    Roof,
}

impl Sweep {
    /// Creates the sweep of a triangle. Returns `None` if all corners are in one voxel.
    fn new(voxels: [[i32; 3]; 3]) -> Option<Self> {
        let voxels = voxels.map(|voxel| voxel.map(i64::from));
        let length = |k: usize, axis: usize| (voxels[(k + 1) % 3][axis] - voxels[k][axis]).abs();
        // Of axes along which an edge is equally long, the first counts.
        let main = |k: usize| (0..3).rev().max_by_key(|&axis| length(k, axis)).unwrap_or_default();
        let is_primary = |k: usize| {
            let [from, to, third] = [0, 1, 2].map(|next| voxels[(k + next) % 3][main(k)]);
            (from.min(to)..=from.max(to)).contains(&third)
        };
        let primary = (0..3).rev().max_by_key(|&k| (is_primary(k), length(k, main(k))))?;
        let sweep = main(primary);
        if length(primary, sweep) == 0 {
            return None;
        }
        let mut corners = [0, 1, 2].map(|next| (primary + next) % 3);
        let is_back = voxels[corners[1]][sweep] < voxels[corners[0]][sweep];
        if is_back {
            corners.swap(0, 1);
        }
        let [first, end, apex] = corners.map(|corner| voxels[corner]);
        let twice = |side: usize| {
            let [end, apex] = [end, apex].map(|at| [at[sweep] - first[sweep], at[side] - first[side]]);
            end[0] * apex[1] - end[1] * apex[0]
        };
        let sides = [(sweep + 1) % 3, (sweep + 2) % 3];
        let side = sides.into_iter().rev().max_by_key(|&side| twice(side).abs())?;
        let upward = if twice(side) < 0 { -1 } else { 1 };
        let place = |at: [i64; 3]| [at[sweep] - first[sweep], (at[side] - first[side]) * upward];
        let parts = [0, 1].map(|end| {
            let [from, to] = [corners[end], corners[2]].map(|corner| voxels[corner]);
            (0..3).map(|axis| (to[axis] - from[axis]).abs()).fold(1, i64::max)
        });
        Some(Self {
            corners: corners.map(|corner| corner as u32),
            end: place(end),
            apex: place(apex),
            parts,
            is_turned: is_back,
        })
    }

    /// Returns the number of strips between columns.
    fn strips(&self) -> u32 {
        self.end[0] as u32
    }

    /// Returns twice the area.
    fn twice_area(&self) -> i64 {
        self.end[0] * self.apex[1] - self.end[1] * self.apex[0]
    }

    /// Returns the number of the first top point of a column. Points of the top, with the apex and
    /// both ends, are numbered along the sweep.
    fn first_of(&self, column: i64) -> i64 {
        let ([n, m], [x, _]) = (self.parts, self.apex);
        // A point belongs to the column if it lies half a voxel or less before its middle.
        let doubled = 2 * column - 1;
        if column <= 0 {
            0
        } else if column > self.end[0] {
            n + m + 1
        } else if doubled <= 2 * x {
            div_ceil(n * doubled, 2 * x)
        } else {
            n + div_ceil(m * (doubled - 2 * x), 2 * (self.end[0] - x))
        }
    }

    /// Returns the top point of a number.
    fn upper(&self, number: i64) -> PlanePoint {
        let ([n, m], [x, y], [end_x, end_y]) = (self.parts, self.apex, self.end);
        if number <= n {
            let sides = if number == n { SIDES[1] | SIDES[2] } else { SIDES[1] };
            PlanePoint { x: x * number, y: y * number, w: n, sides }
        } else {
            let k = number - n;
            PlanePoint { x: x * (m - k) + end_x * k, y: y * (m - k) + end_y * k, w: m, sides: SIDES[2] }
        }
    }

    /// Returns the numbers of a column's top points, and their partner.
    fn top(&self, column: i64) -> (Range<i64>, Top) {
        let [n, m] = self.parts;
        let [first, next] = [column, column + 1].map(|column| self.first_of(column));
        let top = match [first < n, next - 1 > n] {
            [true, true] => Top::Roof,
            [false, true] => Top::Before,
            _ => Top::Next,
        };
        // The ends of the primary edge are at the bottom.
        (first.max(1)..next.min(n + m), top)
    }

    /// Returns the grid's points inside a column.
    fn inner(&self, column: i64) -> Range<i64> {
        if column <= 0 || column >= self.end[0] {
            return 0..0;
        }
        let from = rounded(self.end[1] * column, self.end[0]) + 1;
        let (top, _) = self.top(column);
        let heights = [top.start, top.end - 1].map(|number| {
            let PlanePoint { y, w, .. } = self.upper(number);
            rounded(y, w)
        });
        from..heights[0].min(heights[1]).max(from)
    }

    fn counts(&self, strip: u32) -> PatchCounts {
        let [before, after] = [0, 1].map(|next| i64::from(strip) + next);
        let inner = |column| {
            let range = self.inner(column);
            range.end - range.start
        };
        let [(of_before, top_before), (of_after, top_after)] = [before, after].map(|at| self.top(at));
        let size = |range: &Range<i64>| range.end - range.start;
        let one = |range: &Range<i64>| size(range).min(1);
        let left = inner(before) + if top_before == Top::Next { size(&of_before) } else { one(&of_before) };
        let right = inner(after) + if top_after == Top::Before { size(&of_after) } else { one(&of_after) };
        let roofs = [(strip == 0, &of_before, top_before), (true, &of_after, top_after)];
        let in_roofs = roofs.into_iter().filter(|(is_own, _, top)| *is_own && *top == Top::Roof);
        let in_roofs: i64 = in_roofs.map(|(_, range, _)| size(range) - 1).sum();
        PatchCounts { points: inner(after) as u64, triangles: (left + right + in_roofs) as u64 }
    }

    /// Returns the point `at` of `parts` between two corners of the triangle.
    fn border(&self, [from, to]: [usize; 2], at: i64, parts: i64) -> PatchPoint {
        let [from, to] = [from, to].map(|corner| self.corners[corner]);
        let (side, at) = match at {
            0 => (from, 0),
            at if at == parts => (to, 0),
            at if to == (from + 1) % 3 => (from, at),
            at => (to, parts - at),
        };
        PatchPoint::Border { side, at: at as u32 }
    }

    /// Returns the weights of the patch's second and third corner at a point of the grid.
    fn weights(&self, [x, y]: [i64; 2]) -> [f64; 2] {
        let twice = self.twice_area() as f64;
        let of_end = (x * self.apex[1] - y * self.apex[0]) as f64 / twice;
        let of_apex = (self.end[0] * y - self.end[1] * x) as f64 / twice;
        let mut weights = [0.0; 3];
        let [first, end, apex] = self.corners.map(|corner| corner as usize);
        weights[first] = 1.0 - of_end - of_apex;
        weights[end] = of_end;
        weights[apex] = of_apex;
        [weights[1], weights[2]]
    }

    /// Fills a column, whose first inner point has the number `first`.
    fn column(&self, column: i64, first: u32, into: &mut Column, cut: &mut Cut) {
        into.points.clear();
        let bottom = self.border([0, 1], column, self.end[0]);
        let of_top = [column == 0, column == self.end[0]];
        let sides = SIDES[0] | if of_top[0] { SIDES[1] } else { 0 } | if of_top[1] { SIDES[2] } else { 0 };
        let place = PlanePoint { x: column * self.end[0], y: self.end[1] * column, w: self.end[0], sides };
        into.points.push((cut.point(bottom), place));
        for (number, y) in (first..).zip(self.inner(column)) {
            let point = PatchPoint::Inner { number, weights: self.weights([column, y]) };
            into.points.push((cut.point(point), PlanePoint { x: column, y, w: 1, sides: 0 }));
        }
        into.below_top = into.points.len();
        let (range, top) = self.top(column);
        into.apex =
            (range.contains(&self.parts[0])).then(|| into.below_top + (self.parts[0] - range.start) as usize);
        into.top = top;
        for number in range {
            let [n, m] = self.parts;
            let point =
                if number <= n { self.border([0, 2], number, n) } else { self.border([2, 1], number - n, m) };
            into.points.push((cut.point(point), self.upper(number)));
        }
    }

    fn cut(&self, strips: Range<u32>, first: u32, cut: &mut Cut) {
        let [mut before, mut after] = [Column::default(), Column::default()];
        let [mut left, mut right] = [Vec::new(), Vec::new()];
        let column = i64::from(strips.start);
        let inner = self.inner(column);
        let mut first = first;
        self.column(column, first - (inner.end - inner.start) as u32, &mut before, cut);
        if strips.start == 0 {
            self.roof(&before, cut);
        }
        for strip in strips {
            self.column(i64::from(strip) + 1, first, &mut after, cut);
            first += after.below_top as u32 - 1;
            before.chain(Top::Next, &mut left);
            after.chain(Top::Before, &mut right);
            self.zip(&left, &right, [before.below_top, after.below_top], cut);
            self.roof(&after, cut);
            std::mem::swap(&mut before, &mut after);
        }
    }

    /// Closes the roof of a column, if it has one.
    fn roof(&self, column: &Column, cut: &mut Cut) {
        let (Top::Roof, Some(apex)) = (column.top, column.apex) else { return };
        // The apex is in the right chain, or in the left one if that were empty without it.
        let apex = if apex == column.below_top { apex + 1 } else { apex };
        let (left, right) = column.points[column.below_top..].split_at(apex - column.below_top);
        let under = column.points[column.below_top - 1];
        let right: Vec<Point> = right.iter().rev().copied().collect();
        if let (Some(&up), Some(&down)) = (left.first(), right.first()) {
            self.piece([under, down, up], cut);
        }
        self.zip(left, &right, [0; 2], cut);
    }

    /// Adds the triangles between two chains from below, `left` to the left of `right`. `in_grid`
    /// is the number of points that each has before the top: one at the bottom, then the grid's. It
    /// is 0 in roofs.
    fn zip(&self, left: &[Point], right: &[Point], in_grid: [usize; 2], cut: &mut Cut) {
        let (mut i, mut j) = (0, 0);
        // Whether the end of a chain lies on the side on which the other one ends.
        let is_on = |end: &[Point], chain: &[Point]| match (end, chain) {
            ([.., (_, end)], [.., (_, a), (_, b)]) => end.sides & a.sides & b.sides != 0,
            _ => false,
        };
        let [keeps_left, keeps_right] = [is_on(left, right), is_on(right, left)];
        while let (Some(at_left), Some(at_right)) = (left.get(i), right.get(j)) {
            if i > 0 && j > 0 && i + 1 < in_grid[0] && j + 1 < in_grid[1] {
                [i, j] = self.zip_grid([*at_left, *at_right], [i, j], in_grid, cut);
                continue;
            }
            let goes_left = match (left.get(i + 1), right.get(j + 1)) {
                (None, None) => return,
                (Some(_), None) => true,
                (None, Some(_)) => false,
                // The end comes last, or its triangles would have three corners on that side.
                (Some(_), Some(_)) if keeps_right && j + 2 == right.len() => true,
                (Some(_), Some(_)) if keeps_left && i + 2 == left.len() => false,
                (Some(up_left), Some(up_right)) => {
                    let of = [up_left, up_right].map(|up| turn([at_left.1, at_right.1, up.1]));
                    let shorter = is_no_longer([up_left.1, at_right.1], [at_left.1, up_right.1]);
                    if of[0] == of[1] { shorter } else { of[0] > 0 && (of[1] <= 0 || shorter) }
                }
            };
            let up = if goes_left { left.get(i + 1) } else { right.get(j + 1) };
            if let Some(&up) = up {
                self.piece([*at_left, *at_right, up], cut);
            }
            if goes_left {
                i += 1;
            } else {
                j += 1;
            }
        }
    }

    /// Adds the triangles between the grid's points of two columns, from these points on, until
    /// either column has none left. Returns the indices of both columns then. Each point is a voxel
    /// above the one before. So nothing is turned over, and the shorter diagonal leads to the point
    /// above the lower of the two.
    fn zip_grid(&self, from: [Point; 2], at: [usize; 2], in_grid: [usize; 2], cut: &mut Cut) -> [usize; 2] {
        let [(mut left, PlanePoint { y: mut y_left, .. }), (mut right, PlanePoint { y: mut y_right, .. })] =
            from;
        let [mut i, mut j] = at;
        cut.triangles.reserve(in_grid[0] - i + in_grid[1] - j);
        while i + 1 < in_grid[0] && j + 1 < in_grid[1] {
            let goes_left = y_left <= y_right;
            let up = if goes_left { left + 1 } else { right + 1 };
            cut.triangles.push(if self.is_turned { [right, left, up] } else { [left, right, up] });
            let [step_left, step_right] = [goes_left, !goes_left].map(u32::from);
            (left, y_left, i) = (left + step_left, y_left + i64::from(step_left), i + step_left as usize);
            (right, y_right, j) =
                (right + step_right, y_right + i64::from(step_right), j + step_right as usize);
        }
        [i, j]
    }

    fn piece(&self, corners: [Point; 3], cut: &mut Cut) {
        let [a, b, c] = corners.map(|(place, _)| place);
        cut.triangles.push(if self.is_turned { [b, a, c] } else { [a, b, c] });
    }
}

impl Column {
    /// Collects the points from below, as they are zipped with the next column or the previous one.
    fn chain(&self, with: Top, into: &mut Vec<Point>) {
        let (below, top) = self.points.split_at(self.below_top);
        into.clear();
        into.extend_from_slice(below);
        match (with, top) {
            (Top::Before, top) if self.top == with => into.extend(top.iter().rev()),
            (_, top) if self.top == with => into.extend_from_slice(top),
            // A top that is zipped elsewhere has only its nearest end here.
            (Top::Before, [first, ..]) => into.push(*first),
            (_, [.., last]) => into.push(*last),
            (_, []) => {}
        }
    }
}

/// Returns the sign of a triangle's area.
fn turn([a, b, c]: [PlanePoint; 3]) -> i32 {
    let along = |to: PlanePoint| [to.x * a.w - a.x * to.w, to.y * a.w - a.y * to.w].map(i128::from);
    let ([bx, by], [cx, cy]) = (along(b), along(c));
    (bx * cy - by * cx).signum() as i32
}

/// Returns whether a way is no longer than another one, as the sum of its extents along both axes.
fn is_no_longer(way: [PlanePoint; 2], other: [PlanePoint; 2]) -> bool {
    let length =
        |[a, b]: [PlanePoint; 2]| [(b.x * a.w - a.x * b.w).abs() + (b.y * a.w - a.y * b.w).abs(), a.w * b.w];
    let ([of, by], [of_other, by_other]) = (length(way).map(i128::from), length(other).map(i128::from));
    of * by_other <= of_other * by
}

/// Returns a quotient of integers, rounded up. The divisor is greater than 0.
fn div_ceil(of: i64, by: i64) -> i64 {
    -(-of).div_euclid(by)
}

/// Returns a quotient of integers, rounded to the nearest. The divisor is greater than 0.
fn rounded(of: i64, by: i64) -> i64 {
    (2 * of + by).div_euclid(2 * by)
}

fn steps(patch: &Patch) -> u32 {
    match patch {
        Patch::Triangle { voxels, .. } => Sweep::new(*voxels).map_or(1, |sweep| sweep.strips()),
        Patch::Tile(_) => 0,
    }
}

fn counts(patch: &Patch, step: u32) -> PatchCounts {
    match patch {
        Patch::Triangle { voxels, .. } => match Sweep::new(*voxels) {
            Some(sweep) => sweep.counts(step),
            None => PatchCounts { points: 0, triangles: 1 },
        },
        Patch::Tile(_) => PatchCounts::default(),
    }
}

fn cut(patch: &Patch, steps: Range<u32>, first: u32, cut: &mut Cut) {
    let Patch::Triangle { voxels, .. } = patch else { return };
    match Sweep::new(*voxels) {
        Some(sweep) => sweep.cut(steps, first, cut),
        None => {
            let corners = [0, 1, 2].map(|side| cut.point(PatchPoint::Border { side, at: 0 }));
            cut.triangles.push(corners);
        }
    }
}

#[cfg(test)]
mod tests;
