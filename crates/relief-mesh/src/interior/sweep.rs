//! The sweep of a triangle through a grid of voxels.
//!
//! Source: Gumhold and Hüttner 1999, section 3.4. Corners lie on whole numbers of grid space, and each side
//! is divided along the direction in which it is longest (its *main direction*), one part a voxel. A *primary
//! edge* is one between whose ends, along its main direction, the third corner lies: there always is one
//! (theorem 1), and the longest says along which axis is *swept*. Of the two coordinate planes that hold this
//! axis the triangle is cut in the one that it covers more of; the other axis of that plane is the *side*.
//!
//! So the primary edge has one point in each *column*, at its bottom. The two other sides make the top: the
//! points of theirs that round to a column belong to it. Between are the grid's own points, but those that
//! lie within a voxel of a side are left out: they are dragged to it, in the paper's words. Neighbouring
//! columns are zipped from below, by the shorter diagonal of the two that turn nothing over. How far a
//! diagonal goes along and up is added up, so that whole numbers compare it exactly. Points of the top that
//! lie before the third corner are zipped with the next column, those behind it with the last one; what
//! there is of both in the third corner's own column is closed there, as a roof.
//!
//! The shaders have the same sweep in 32 bits, for GPUs, with sides of at most 1,023 voxels. Here sides are
//! of any length. A test of `relief-render` finds the same triangles by both.
//!
//! No piece has three corners on one side: the neighbour could have the same, and an edge four triangles.
//!
//! Unlike in the paper no differences are added up: each column follows from the three corners, so that
//! columns are cut apart, and points are the same whoever asks.

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
    why: "a sweep goes through voxels, and needs a point of each side in every voxel along it",
    fills: Fills::Patch(Pattern { steps, counts, cut }),
};

/// A triangle as it is swept. Coordinates are those along the sweep and along the side, counted from the
/// first end of the primary edge, and such that the third corner lies above it.
#[derive(Clone, Copy, Debug)]
struct Sweep {
    /// The ends of the primary edge and the third corner, as numbers of the patch's corners.
    corners: [u32; 3],
    /// The end of the primary edge: `[columns - 1, rise]`.
    end: [i64; 2],
    /// The third corner.
    apex: [i64; 2],
    /// Parts of the sides from the first end to the apex, and from there to the other end.
    parts: [i64; 2],
    /// Whether pieces are turned over, as seen from the patch.
    is_turned: bool,
}

/// A point in the plane of the sweep.
#[derive(Clone, Copy, Debug)]
struct Place {
    /// It lies at `[x / w, y / w]`.
    x: i64,
    y: i64,
    w: i64,
    /// Which sides it lies on.
    sides: u8,
}

/// The primary edge, the side from its first end to the apex, and that from there to its other end.
const SIDES: [u8; 3] = [1, 2, 4];

/// A point, and its place among those of the cut.
type Point = (u32, Place);

/// A column of points.
#[derive(Debug, Default)]
struct Column {
    /// From below: that of the primary edge, those of the grid, then those of the top along the sweep.
    points: Vec<Point>,
    /// How many come before the top.
    below_top: usize,
    /// Where the apex is among the points, if it is.
    apex: Option<usize>,
    top: Top,
}

/// What the points of a column's top are zipped with.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Top {
    /// They lie before the apex, or are the apex: the next column.
    #[default]
    Next,
    /// They lie behind it: the column before.
    Before,
    /// There are both: each other.
    Roof,
}

impl Sweep {
    /// The sweep of a triangle; none where all corners are in one voxel.
    fn new(voxels: [[i32; 3]; 3]) -> Option<Self> {
        let voxels = voxels.map(|voxel| voxel.map(i64::from));
        let length = |k: usize, axis: usize| (voxels[(k + 1) % 3][axis] - voxels[k][axis]).abs();
        // Of axes along which an edge is equally long the first.
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

    /// Strips between columns.
    fn strips(&self) -> u32 {
        self.end[0] as u32
    }

    /// Twice the area.
    fn twice_area(&self) -> i64 {
        self.end[0] * self.apex[1] - self.end[1] * self.apex[0]
    }

    /// Points of the top, the apex and both ends among them, are counted along the sweep: that number has the
    /// first of a column.
    fn first_of(&self, column: i64) -> i64 {
        let ([n, m], [x, _]) = (self.parts, self.apex);
        // A point belongs to the column if it lies less than half a voxel before its middle, or just that.
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

    /// The point of the top of that number.
    fn upper(&self, number: i64) -> Place {
        let ([n, m], [x, y], [end_x, end_y]) = (self.parts, self.apex, self.end);
        if number <= n {
            let sides = if number == n { SIDES[1] | SIDES[2] } else { SIDES[1] };
            Place { x: x * number, y: y * number, w: n, sides }
        } else {
            let k = number - n;
            Place { x: x * (m - k) + end_x * k, y: y * (m - k) + end_y * k, w: m, sides: SIDES[2] }
        }
    }

    /// The numbers of a column's points of the top, and what they are zipped with.
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

    /// The grid's points inside of a column.
    fn inner(&self, column: i64) -> Range<i64> {
        if column <= 0 || column >= self.end[0] {
            return 0..0;
        }
        let from = rounded(self.end[1] * column, self.end[0]) + 1;
        let (top, _) = self.top(column);
        let heights = [top.start, top.end - 1].map(|number| {
            let Place { y, w, .. } = self.upper(number);
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

    /// A point between two corners of the triangle, that so many parts lie before.
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

    /// The weights of the second and the third corner of the patch at a point of the grid.
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

    /// Makes a column, whose first inner point has that number.
    fn column(&self, column: i64, first: u32, into: &mut Column, cut: &mut Cut) {
        into.points.clear();
        let bottom = self.border([0, 1], column, self.end[0]);
        let of_top = [column == 0, column == self.end[0]];
        let sides = SIDES[0] | if of_top[0] { SIDES[1] } else { 0 } | if of_top[1] { SIDES[2] } else { 0 };
        let place = Place { x: column * self.end[0], y: self.end[1] * column, w: self.end[0], sides };
        into.points.push((cut.point(bottom), place));
        for (number, y) in (first..).zip(self.inner(column)) {
            let point = PatchPoint::Inner { number, weights: self.weights([column, y]) };
            into.points.push((cut.point(point), Place { x: column, y, w: 1, sides: 0 }));
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
        // The apex goes with the side that has more room for it.
        let apex = if apex == column.below_top { apex + 1 } else { apex };
        let (left, right) = column.points[column.below_top..].split_at(apex - column.below_top);
        let under = column.points[column.below_top - 1];
        let right: Vec<Point> = right.iter().rev().copied().collect();
        if let (Some(&up), Some(&down)) = (left.first(), right.first()) {
            self.piece([under, down, up], cut);
        }
        self.zip(left, &right, [0; 2], cut);
    }

    /// The triangles between two chains from below, the first one to the left of the second. `in_grid` says
    /// how many points each begins with before the top: one at the bottom, then the grid's. It is 0 in roofs.
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
                // The end comes last, or the triangles with it would have three corners on that side.
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

    /// The triangles between the grid's points of two columns, from these on, until either column has none
    /// left. Gives where both are then. Each point is a voxel above the one before, so that nothing is turned
    /// over, and the shorter diagonal is the one to the point above the lower of the two.
    fn zip_grid(&self, from: [Point; 2], at: [usize; 2], in_grid: [usize; 2], cut: &mut Cut) -> [usize; 2] {
        let [(mut left, Place { y: mut y_left, .. }), (mut right, Place { y: mut y_right, .. })] = from;
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
    /// Its points from below, as they are zipped with the next column or the one before.
    fn chain(&self, with: Top, into: &mut Vec<Point>) {
        let (below, top) = self.points.split_at(self.below_top);
        into.clear();
        into.extend_from_slice(below);
        match (with, top) {
            (Top::Before, top) if self.top == with => into.extend(top.iter().rev()),
            (_, top) if self.top == with => into.extend_from_slice(top),
            // Of a top that is not zipped here there is the end that is nearest.
            (Top::Before, [first, ..]) => into.push(*first),
            (_, [.., last]) => into.push(*last),
            (_, []) => {}
        }
    }
}

/// The sign of twice the area of a triangle.
fn turn([a, b, c]: [Place; 3]) -> i32 {
    let along = |to: Place| [to.x * a.w - a.x * to.w, to.y * a.w - a.y * to.w].map(i128::from);
    let ([bx, by], [cx, cy]) = (along(b), along(c));
    (bx * cy - by * cx).signum() as i32
}

/// Whether a way is no longer than another one, along and up together.
fn is_no_longer(way: [Place; 2], other: [Place; 2]) -> bool {
    let length =
        |[a, b]: [Place; 2]| [(b.x * a.w - a.x * b.w).abs() + (b.y * a.w - a.y * b.w).abs(), a.w * b.w];
    let ([of, by], [of_other, by_other]) = (length(way).map(i128::from), length(other).map(i128::from));
    of * by_other <= of_other * by
}

/// A quotient of whole numbers, the second above 0, rounded up.
fn div_ceil(of: i64, by: i64) -> i64 {
    -(-of).div_euclid(by)
}

/// A quotient of whole numbers, the second above 0, rounded to the nearest.
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
