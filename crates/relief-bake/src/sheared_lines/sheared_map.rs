//! Sheared maps: the texels in the order of the lines that pass them.

use std::ops::Range;

use super::lines::Lines;

/// Texels by which the rows of a block exceed their content. Without them, rows of a power of two
/// would all fall into the same cache lines.
pub(crate) const SKEW: usize = 16;

/// Neighbouring slots of a sheared map, `stride` values each.
pub(crate) struct Slab<'a> {
    pub slots: Range<usize>,
    pub stride: usize,
    pub values: &'a mut [f32],
}

/// Neighbouring slots of a sheared map, for reading. The value of position `p` in slot
/// `slots.start + k` is at `k * stride + offset + p`.
#[derive(Clone)]
pub(crate) struct Plane<'a> {
    pub texels: &'a [f32],
    pub stride: usize,
    pub offset: usize,
    pub slots: Range<usize>,
}

/// Part of a row of the map.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Run {
    /// The row, from the band's first.
    pub row: usize,
    /// The columns of the map.
    pub columns: Range<usize>,
}

/// Band of rows of the map, as far as its texels lie in a plane's slots.
pub(crate) struct Band {
    /// Parts of the rows, row by row.
    pub runs: Vec<Run>,
    /// Columns that hold them all.
    pub columns: Range<usize>,
    top: usize,
    values: Vec<f32>,
}

impl Band {
    /// Finds the parts of the rows `rows`, without their values; `None` where no texel of them lies
    /// in those slots.
    pub fn new(lines: &Lines, rows: Range<usize>, slots: &Range<usize>) -> Option<Self> {
        let (mut runs, mut found) = (Vec::new(), Vec::new());
        for row in 0..rows.len() {
            lines.runs(rows.start + row, slots, &mut found);
            runs.extend(found.drain(..).map(|columns| Run { row, columns }));
        }
        let all = runs.iter().map(|run| run.columns.clone());
        let columns = all.reduce(|a, b| a.start.min(b.start)..a.end.max(b.end))?;
        let values = vec![0.0; rows.len() * (columns.len() + SKEW)];
        Some(Self { runs, columns, top: rows.start, values })
    }

    /// Returns the index of a texel, given its row from the band's first and its column.
    fn place(&self, row: usize, column: usize) -> usize {
        row * (self.columns.len() + SKEW) + column - self.columns.start
    }

    /// Returns the values of a part.
    pub fn row(&self, run: &Run) -> &[f32] {
        let start = self.place(run.row, run.columns.start);
        &self.values[start..start + run.columns.len()]
    }

    /// Copies the values out of the sheared plane.
    pub fn unshear(&mut self, lines: &Lines, plane: &Plane) {
        let position = |along: usize| if lines.reversed { lines.length - 1 - along } else { along };
        if !lines.steep {
            for run in &self.runs {
                let start = self.place(run.row, run.columns.start);
                let values = &mut self.values[start..start + run.columns.len()];
                for (column, value) in run.columns.clone().zip(values) {
                    let p = position(column);
                    let slot = lines.slot(p, self.top + run.row) - plane.slots.start;
                    *value = plane.texels[slot * plane.stride + plane.offset + p];
                }
            }
            return;
        }
        // Slot by slot, because a slot's texels of the band are side by side.
        let places: Vec<(usize, usize)> = (0..self.values.len() / (self.columns.len() + SKEW))
            .map(|row| position(self.top + row))
            .map(|p| (p, lines.slot(p, 0)))
            .collect();
        for (slot, texels) in plane.slots.clone().zip(plane.texels.chunks_exact(plane.stride)) {
            for (row, &(p, first)) in places.iter().enumerate() {
                // Column 0 lies in slot `first`, and each further one in the next.
                let column = if slot >= first { slot - first } else { slot + lines.count - first };
                let place = self.place(row, column);
                self.values[place] = texels[plane.offset + p];
            }
        }
    }
}
