//! The heights of a tile, on a lattice of a sixteenth of a cell.

/// Steps of the lattice along a cell.
pub const STEPS: i32 = 16;

/// The heights at the corners of a tile's cells. A place in it is counted in steps of the lattice from the
/// first corner; the surface is bilinear in every cell.
#[derive(Clone, Debug)]
pub struct Window {
    /// Corners along both axes, at least two.
    corners: [usize; 2],
    heights: Vec<f32>,
    /// Where the tile begins, in steps. Cells at its border may lie outside in part.
    pub from: [i32; 2],
    /// Where it ends.
    pub to: [i32; 2],
}

impl Window {
    /// A window over a tile that goes from one place to another, in steps: the first within the first cell,
    /// the last within the last. `height` gives the height at a corner.
    pub fn new(from: [i32; 2], to: [i32; 2], mut height: impl FnMut([usize; 2]) -> f32) -> Self {
        let corners = to.map(|to| ((to + STEPS - 1) / STEPS + 1) as usize);
        let mut heights = Vec::with_capacity(corners[0] * corners[1]);
        for j in 0..corners[1] {
            heights.extend((0..corners[0]).map(|i| height([i, j])));
        }
        Self { corners, heights, from, to }
    }

    /// The heights at a row of corners.
    pub fn row(&self, j: usize) -> &[f32] {
        &self.heights[j * self.corners[0]..][..self.corners[0]]
    }

    /// The heights at the corners of a cell: `h00`, `h10`, `h01`, `h11`.
    pub fn cell(&self, [i, j]: [i32; 2]) -> [f64; 4] {
        let at = j as usize * self.corners[0] + i as usize;
        let below = at + self.corners[0];
        let ([h00, h10], [h01, h11]) = (self.pair(at), self.pair(below));
        [h00, h10, h01, h11].map(f64::from)
    }

    fn pair(&self, at: usize) -> [f32; 2] {
        let pair = &self.heights[at..at + 2];
        [pair[0], pair[1]]
    }

    /// Corners along the first axis.
    pub fn columns(&self) -> usize {
        self.corners[0]
    }

    /// Corners along the second axis.
    pub fn rows(&self) -> usize {
        self.corners[1]
    }

    /// The cell at a place, in cells; that at the border where rounding put it beyond.
    pub fn cell_at(&self, place: [f64; 2]) -> [i32; 2] {
        [0, 1].map(|axis| (place[axis].floor() as i32).clamp(0, self.corners[axis] as i32 - 2))
    }

    /// The height at a lattice point.
    pub fn height_at(&self, point: [i32; 2]) -> f64 {
        let cell = [0, 1].map(|axis| (point[axis] / STEPS).min(self.corners[axis] as i32 - 2));
        let part = |axis: usize| f64::from(point[axis] - STEPS * cell[axis]) / f64::from(STEPS);
        bilinear(self.cell(cell), [part(0), part(1)])
    }
}

/// The height in a cell, from 0 to 1 along both axes.
pub fn bilinear([h00, h10, h01, h11]: [f64; 4], [u, v]: [f64; 2]) -> f64 {
    let [near, far] = [h00 + (h10 - h00) * u, h01 + (h11 - h01) * u];
    near + (far - near) * v
}
