//! Heights around texels side by side.

use super::apexes::{APEXES, Apexes, RIM, Region};
use super::field::{Field, RelativeCell};
use super::lanes::{LANES, Lanes};

/// Cells of the block to each side of a texel's centre. Cells beyond are at least 2½ texels away,
/// where their corners bound them closely. With fewer, most texels would also visit cells beyond;
/// with more, the block would take longer than these visits.
pub(super) const REACH: usize = 3;

/// Vertices along a side of the area read: the block, and one more for the texel to the right or
/// below.
pub(super) const SIDE: usize = 2 * REACH + 2;

/// Numbers of vertices are masked with this: the compiler then knows that they are within an array.
pub(super) const MASK: usize = (SIDE * SIDE).next_power_of_two() - 1;

/// Cells along a side of the area read.
pub(super) const CELLS_READ: usize = SIDE - 1;

/// The centre's place among the vertices.
pub(super) const CENTRE: usize = REACH * SIDE + REACH;

/// Returns whether a cell at that offset from a texel is in its block.
#[inline(always)]
pub(crate) fn is_in_block(cell: [i64; 2]) -> bool {
    cell.iter().all(|x| (-(REACH as i64)..REACH as i64).contains(x))
}

/// Returns the vertex at a number of columns and rows from the centre.
pub(super) const fn vertex_at(column: isize, row: isize) -> usize {
    (CENTRE as isize + row * SIDE as isize + column) as usize
}

/// Heights of the vertices around texels side by side, row by row.
pub(crate) struct Block {
    pub vertices: [Lanes; SIDE * SIDE],
}

impl Block {
    /// Reads the heights around the texels from `texel` on. Columns beyond the last texel continue
    /// with the wrap.
    #[inline(always)]
    pub fn new(field: &Field, texel: [i64; 2]) -> Self {
        let mut vertices = [[0.0; LANES]; SIDE * SIDE];
        let reach = REACH as i64;
        for (row, vertices) in vertices.chunks_exact_mut(SIDE).enumerate() {
            let heights: [f64; LANES + SIDE - 1] =
                field.row([texel[0] - reach, texel[1] + row as i64 - reach]);
            for (column, vertex) in vertices.iter_mut().enumerate() {
                vertex.copy_from_slice(&heights[column..column + LANES]);
            }
        }
        Self { vertices }
    }

    /// Returns the apexes of the texels from `texel` on.
    #[inline(always)]
    pub fn apexes(&self, texel: [i64; 2], region: Region) -> [Apexes; LANES] {
        let centre = &self.vertices[CENTRE];
        let mut heights = [*centre; APEXES];
        if region == Region::Footprint {
            for (heights, [column, row]) in heights.iter_mut().zip(RIM) {
                // Halfway to the neighbours along one axis or both; without a step they are the
                // centre.
                let place = |column: i8, row: i8| vertex_at(isize::from(column), isize::from(row));
                let [aside, ahead] = [place(column, 0), place(0, row)].map(|vertex| &self.vertices[vertex]);
                let beyond = &self.vertices[place(column, row)];
                for (lane, height) in heights.iter_mut().enumerate() {
                    *height = 0.5 * (0.5 * (centre[lane] + aside[lane]) + 0.5 * (ahead[lane] + beyond[lane]));
                }
            }
        }
        std::array::from_fn(|lane| {
            let heights = heights.each_ref().map(|lanes| lanes[lane]);
            Apexes::new([texel[0] + lane as i64, texel[1]], heights, centre[lane])
        })
    }

    /// Returns the 3 by 3 vertices around the centre of one of the texels, row by row.
    pub fn around(&self, lane: usize) -> [[f64; 3]; 3] {
        [-1, 0, 1].map(|row| [-1, 0, 1].map(|column| self.vertices[vertex_at(column, row)][lane]))
    }

    /// Returns the cell that begins at a vertex, relative to one of the texels.
    #[inline(always)]
    pub fn cell(&self, lane: usize, first: usize) -> RelativeCell {
        let corners = [first, first + 1, first + SIDE, first + SIDE + 1];
        RelativeCell { offset: offset_of(first), heights: corners.map(|vertex| self.vertices[vertex][lane]) }
    }

    /// Returns the heights of the corners `h00 h10 h01 h11` of the cell that begins at a vertex.
    #[inline(always)]
    pub fn corners(&self, first: usize) -> [&Lanes; 4] {
        let at = |by: usize| &self.vertices[(first + by) & MASK];
        [at(0), at(1), at(SIDE), at(SIDE + 1)]
    }
}

/// Returns the vertices at which the cells of a texel's block begin, cells around its centre first.
pub(crate) fn cells_of_block() -> impl Iterator<Item = usize> {
    (0..REACH).flat_map(|ring| {
        let (from, to) = (REACH - 1 - ring, REACH + ring);
        (from..=to).flat_map(move |row| {
            let is_end = row == from || row == to;
            (from..=to).step_by(if is_end { 1 } else { to - from }).map(move |column| row * SIDE + column)
        })
    })
}

/// Returns the offset of a vertex from the centre, in texels.
#[inline(always)]
pub(crate) fn offset_of(vertex: usize) -> [i64; 2] {
    [vertex % SIDE, vertex / SIDE].map(|place| place as i64 - REACH as i64)
}
