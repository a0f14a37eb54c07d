//! The heights around texels side by side.

use super::apexes::{APEXES, Apexes, RIM, Region};
use super::field::{Field, Seen};
use super::lanes::{LANES, Lanes};

/// Cells of the block to each side of a texel's centre. Cells beyond are at least 2½ texels away, where their
/// corners tell nearly all. With fewer, most texels must look into some cells beyond; with more, the block
/// takes longer than those.
pub(super) const REACH: usize = 3;

/// Vertices along a side of what is read: the block, and one more for the texel to the right or below.
pub(super) const SIDE: usize = 2 * REACH + 2;

/// Numbers of vertices are masked with this: the compiler then knows that they are within an array.
pub(super) const MASK: usize = (SIDE * SIDE).next_power_of_two() - 1;

/// Cells along a side of what is read.
pub(super) const CELLS_READ: usize = SIDE - 1;

/// The centre's place among the vertices.
pub(super) const CENTRE: usize = REACH * SIDE + REACH;

/// Whether a cell at that offset from a texel is in its block.
#[inline(always)]
pub(crate) fn is_in_block(cell: [i64; 2]) -> bool {
    cell.iter().all(|x| (-(REACH as i64)..REACH as i64).contains(x))
}

/// The vertex so many columns and rows from the centre.
pub(super) const fn vertex_at(column: isize, row: isize) -> usize {
    (CENTRE as isize + row * SIDE as isize + column) as usize
}

/// The heights of the vertices around texels side by side, row by row.
pub(crate) struct Block {
    pub vertices: [Lanes; SIDE * SIDE],
}

impl Block {
    /// The heights around the texels from the one given; columns beyond the last texel are read as they come.
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

    /// The apexes of the texels from the one given.
    #[inline(always)]
    pub fn apexes(&self, texel: [i64; 2], region: Region) -> [Apexes; LANES] {
        let centre = &self.vertices[CENTRE];
        let mut heights = [*centre; APEXES];
        if region == Region::Footprint {
            for (heights, [column, row]) in heights.iter_mut().zip(RIM) {
                // Halfway to the neighbours along one axis or both; without a step they are the centre.
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

    /// The 3 by 3 vertices around the centre of one of the texels, row by row.
    pub fn around(&self, lane: usize) -> [[f64; 3]; 3] {
        [-1, 0, 1].map(|row| [-1, 0, 1].map(|column| self.vertices[vertex_at(column, row)][lane]))
    }

    /// A cell that begins at a vertex, as seen from one of the texels.
    #[inline(always)]
    pub fn cell(&self, lane: usize, first: usize) -> Seen {
        let corners = [first, first + 1, first + SIDE, first + SIDE + 1];
        Seen { offset: offset_of(first), heights: corners.map(|vertex| self.vertices[vertex][lane]) }
    }

    /// The heights of the corners `h00 h10 h01 h11` of a cell that begins at a vertex.
    #[inline(always)]
    pub fn corners(&self, first: usize) -> [&Lanes; 4] {
        let at = |by: usize| &self.vertices[(first + by) & MASK];
        [at(0), at(1), at(SIDE), at(SIDE + 1)]
    }
}

/// The vertices at which the cells of a texel's block begin, those around its centre first.
pub(crate) fn cells_of_block() -> impl Iterator<Item = usize> {
    (0..REACH).flat_map(|ring| {
        let (from, to) = (REACH - 1 - ring, REACH + ring);
        (from..=to).flat_map(move |row| {
            let is_end = row == from || row == to;
            (from..=to).step_by(if is_end { 1 } else { to - from }).map(move |column| row * SIDE + column)
        })
    })
}

/// How far a vertex is from the centre, in texels.
#[inline(always)]
pub(crate) fn offset_of(vertex: usize) -> [i64; 2] {
    [vertex % SIDE, vertex / SIDE].map(|place| place as i64 - REACH as i64)
}
