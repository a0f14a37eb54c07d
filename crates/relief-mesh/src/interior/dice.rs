//! Fixed pattern for the three counts of a triangle, and the grid of a tile.
//!
//! A triangle is cut into rows that run along its side of fewest parts, from the opposite corner
//! `A`. The other two sides have `n` and `m >= n` parts. Row `r` of `m` goes from point `⌈r n / m⌉`
//! of the one to point `r` of the other. So each point of either side is the end of a row, and rows
//! meet only at their ends. A row has the part of the short side's parts that it has of its length,
//! rounded up. The last row is that side. Two neighbouring rows are zipped: of the two next points,
//! the one that is less far along its row makes the next triangle with the last two.
//!
//! Rows are straight. Both ends of each are farther from `A` than the ends of the row before, or
//! one is and the other is the same. So all triangles between two rows turn like the base triangle.
//! Rows that share an end differ by at most one part. Zipping then takes their points by turns, and
//! no triangle is without an area. Equal counts give the regular lattice. Long narrow triangles get
//! no more rows across than they are wide.

use std::ops::Range;

use relief_core::registry::Publication;

use super::{Cut, Fills, Interior, PatchCounts, Pattern};
use crate::Spacing;
use crate::patch::{Patch, PatchPoint};

pub const INTERIOR: Interior = Interior {
    name: "dice",
    summary: "a fixed pattern: rows along the side of fewest parts, and on a plane a grid",
    publication: Publication { paper: "Relief", section: "" },
    takes: &[Spacing::Even, Spacing::Voxels],
    why: "a fixed pattern needs sides that are divided evenly",
    fills: Fills::Patch(Pattern { steps, counts, cut }),
};

/// Rows of a triangle, seen from its corner `A`.
#[derive(Clone, Copy, Debug)]
struct Rows {
    /// Numbers of its sides: from `A` onward, of fewest parts, and back to `A`.
    sides: [u32; 3],
    /// Number of parts of each.
    parts: [u32; 3],
}

/// Row of points: its two ends, and its number of parts.
#[derive(Clone, Copy, Debug)]
struct Row {
    ends: [u32; 2],
    parts: u32,
}

impl Rows {
    fn new(parts: [u32; 3]) -> Self {
        let short = (0..3).min_by_key(|&side| parts[side as usize]).unwrap_or_default();
        let sides = [(short + 2) % 3, short, (short + 1) % 3];
        Self { sides, parts: sides.map(|side| parts[side as usize]) }
    }

    /// Returns the number of rows after `A`.
    fn count(&self) -> u32 {
        self.parts[0].max(self.parts[2])
    }

    fn row(&self, row: u32) -> Row {
        let share = |parts: u32| {
            let whole = u64::from(row) * u64::from(parts);
            whole.div_ceil(u64::from(self.count())) as u32
        };
        // A row has fewer parts than one side of the triangle.
        let parts = share(self.parts[1]).max(u32::from(row > 0));
        Row { ends: [share(self.parts[0]), share(self.parts[2])], parts }
    }

    /// Returns the number of inner points of a row.
    fn inner(&self, row: u32) -> u32 {
        if row == 0 || row == self.count() { 0 } else { self.row(row).parts - 1 }
    }

    fn triangles(&self, row: u32) -> u64 {
        let (above, below) = (self.row(row - 1), self.row(row));
        let shared = (0..2).filter(|&end| row > 1 && above.ends[end] == below.ends[end]).count() as u64;
        u64::from(above.parts) + u64::from(below.parts) - shared
    }

    /// Returns the point `at` of a side, counted from `A`, or on the short side from its first
    /// corner.
    fn border(&self, side: usize, at: u32) -> PatchPoint {
        let (number, parts) = (self.sides[side], self.parts[side]);
        let at = if side == 2 { parts - at } else { at };
        // The last point of a side is the first one of the next.
        if at == parts {
            PatchPoint::Border { side: (number + 1) % 3, at: 0 }
        } else {
            PatchPoint::Border { side: number, at }
        }
    }

    /// Adds the points of a row and returns their indices. `first` is the number of its first inner
    /// point.
    fn add(&self, number: u32, first: u32, cut: &mut Cut) -> Range<u32> {
        let from = cut.points.len() as u32;
        let Row { ends, parts } = self.row(number);
        if number == 0 {
            cut.points.push(self.border(0, 0));
        } else if number == self.count() {
            cut.points.extend((0..=parts).map(|at| self.border(1, at)));
        } else {
            cut.points.push(self.border(0, ends[0]));
            let [of_first, of_second] =
                [0, 1].map(|end| f64::from(ends[end]) / f64::from(self.parts[2 * end]));
            cut.points.extend((1..parts).map(|at| {
                let part = f64::from(at) / f64::from(parts);
                // Weights of the two corners at the ends of the short side, and of `A`.
                let of_ends = [(1.0 - part) * of_first, part * of_second];
                let mut weights = [0.0; 3];
                weights[self.sides[1] as usize] = of_ends[0];
                weights[self.sides[2] as usize] = of_ends[1];
                weights[self.sides[0] as usize] = 1.0 - of_ends[0] - of_ends[1];
                PatchPoint::Inner { number: first + at - 1, weights: [weights[1], weights[2]] }
            }));
            cut.points.push(self.border(2, ends[1]));
        }
        from..cut.points.len() as u32
    }

    fn cut(&self, rows: Range<u32>, first: u32, cut: &mut Cut) {
        let mut first = first;
        let mut above = self.add(rows.start, first - self.inner(rows.start), cut);
        for row in rows.start + 1..=rows.end {
            let below = self.add(row, first, cut);
            first += self.inner(row);
            let [before, after] = [self.row(row - 1), self.row(row)];
            let shared = [0, 1].map(|end| row > 1 && before.ends[end] == after.ends[end]);
            zip([above, below.clone()], shared, cut);
            above = below;
        }
    }
}

/// Adds the triangles between two rows, without the ones at shared ends.
fn zip([above, below]: [Range<u32>; 2], shared: [bool; 2], cut: &mut Cut) {
    let [last_above, last_below] = [&above, &below].map(|row| row.len() as u64 - 1);
    let (mut i, mut j) = (0, 0);
    cut.triangles.reserve((last_above + last_below) as usize);
    while i < last_above || j < last_below {
        // Halfway to the next point of each row, in parts of the row, times both rows' parts.
        let goes_below =
            i == last_above || (j < last_below && (2 * j + 1) * last_above <= (2 * i + 1) * last_below);
        let is_first = i + j == 0;
        let corners = [above.start + i as u32, below.start + j as u32];
        let next = if goes_below { corners[1] + 1 } else { corners[0] + 1 };
        i += u64::from(!goes_below);
        j += u64::from(goes_below);
        let is_last = i == last_above && j == last_below;
        if !(is_first && shared[0] || is_last && shared[1]) {
            cut.triangles.push([corners[0], corners[1], next]);
        }
    }
}

fn steps(patch: &Patch) -> u32 {
    match patch {
        Patch::Triangle { parts, .. } => Rows::new(*parts).count(),
        Patch::Tile(_) => 1,
    }
}

fn counts(patch: &Patch, step: u32) -> PatchCounts {
    match patch {
        Patch::Triangle { parts, .. } => {
            let rows = Rows::new(*parts);
            let points = u64::from(rows.inner(step + 1));
            PatchCounts { points, triangles: rows.triangles(step + 1) }
        }
        Patch::Tile(lines) => {
            let [across, down] = lines.map(|lines| lines.len() as u64);
            PatchCounts { points: across * down, triangles: 2 * (across - 1) * (down - 1) }
        }
    }
}

fn cut(patch: &Patch, steps: Range<u32>, first: u32, cut: &mut Cut) {
    match patch {
        Patch::Triangle { parts, .. } => Rows::new(*parts).cut(steps, first, cut),
        Patch::Tile(lines) => {
            let [across, down] = lines.map(|lines| lines.len() as u32);
            for at in 0..down {
                for side in 0..across {
                    cut.point(PatchPoint::Border { side, at });
                }
            }
            for j in 0..down - 1 {
                for i in 0..across - 1 {
                    let [here, below] = [j * across + i, (j + 1) * across + i];
                    cut.triangles.push([here, below, below + 1]);
                    cut.triangles.push([here, below + 1, here + 1]);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the barycentric weights of a point.
    fn weights(point: PatchPoint, parts: [u32; 3]) -> [f64; 3] {
        match point {
            PatchPoint::Border { side, at } => {
                let mut weights = [0.0; 3];
                let part = f64::from(at) / f64::from(parts[side as usize]);
                weights[side as usize] = 1.0 - part;
                weights[(side as usize + 1) % 3] = part;
                weights
            }
            PatchPoint::Inner { weights: [b, c], .. } => [1.0 - b - c, b, c],
        }
    }

    fn all(parts: [u32; 3]) -> Cut {
        let mut all = Cut::default();
        let patch = Patch::Triangle { parts, voxels: [[0; 3]; 3] };
        cut(&patch, 0..steps(&patch), 0, &mut all);
        all
    }

    #[test]
    fn pieces_tile_the_triangle_and_use_every_point_of_its_sides() {
        for code in 0..12u32.pow(3) {
            let parts = [code % 12 + 1, code / 12 % 12 + 1, code / 144 + 1];
            let cut = all(parts);
            let mut area = 0.0;
            for corners in &cut.triangles {
                let [a, b, c] = corners.map(|at| weights(cut.points[at as usize], parts));
                let twice = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
                assert!(twice > 1e-6, "{parts:?}: a piece of area {twice}");
                area += twice;
            }
            assert!((area - 1.0).abs() < 1e-12, "{parts:?}: {area}");
            for side in 0..3 {
                for at in 0..parts[side as usize] {
                    let is_used =
                        |corner: &u32| cut.points[*corner as usize] == PatchPoint::Border { side, at };
                    assert!(cut.triangles.iter().flatten().any(is_used), "{parts:?}: {side} {at}");
                }
            }
            let patch = Patch::Triangle { parts, voxels: [[0; 3]; 3] };
            let counted = (0..steps(&patch)).map(|step| counts(&patch, step));
            let [points, triangles] = counted
                .fold([0, 0], |[points, triangles], step| [points + step.points, triangles + step.triangles]);
            let inner: Vec<u32> = cut.points.iter().filter_map(inner_number).collect();
            assert_eq!(inner, (0..points as u32).collect::<Vec<_>>(), "{parts:?}");
            assert_eq!(cut.triangles.len() as u64, triangles, "{parts:?}");
        }
    }

    fn inner_number(point: &PatchPoint) -> Option<u32> {
        match point {
            PatchPoint::Inner { number, .. } => Some(*number),
            PatchPoint::Border { .. } => None,
        }
    }

    #[test]
    fn equal_counts_make_the_regular_lattice_and_narrow_triangles_few_pieces() {
        assert_eq!(all([8; 3]).triangles.len(), 64);
        assert!(all([1000, 1000, 4]).triangles.len() < 8000);
    }

    #[test]
    fn steps_by_themselves_make_what_they_make_together() {
        let parts = [9, 31, 27];
        let patch = Patch::Triangle { parts, voxels: [[0; 3]; 3] };
        let shown = |cut: &Cut| -> Vec<[PatchPoint; 3]> {
            cut.triangles.iter().map(|corners| corners.map(|at| cut.points[at as usize])).collect()
        };
        let (mut apart, mut first) = (Vec::new(), 0);
        for step in 0..steps(&patch) {
            let mut part = Cut::default();
            cut(&patch, step..step + 1, first, &mut part);
            first += counts(&patch, step).points as u32;
            apart.extend(shown(&part));
        }
        assert_eq!(apart, shown(&all(parts)));
    }
}
