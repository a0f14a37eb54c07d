//! Heights of a tile, on a lattice of 1/16 of a cell.

/// Steps of the lattice along a cell.
pub const STEPS: i32 = 16;

/// Heights at the corners of a tile's cells. Places are counted in steps of the lattice from the
/// first corner. The surface is bilinear in every cell.
#[derive(Clone, Debug)]
pub struct Window {
    /// Number of corners along both axes, at least two.
    corners: [usize; 2],
    /// Heights by rows, and three more numbers, so that four can be read from each corner.
    heights: Vec<f32>,
    /// Which cells are holes, row by row; empty if none is.
    holes: Vec<bool>,
    /// Start of the tile, in steps. Cells at its border may lie partly outside.
    pub from: [i32; 2],
    /// End of the tile, in steps.
    pub to: [i32; 2],
}

impl Window {
    /// Creates a window over a tile from place `from` to place `to`, in steps of 1/16 of a cell.
    ///
    /// Both are counted from the window's first corner. `from` lies in the first cell, from 0 to
    /// [`STEPS`] along both axes. `to` is greater and lies in the last cell.
    ///
    /// `height` returns the height of the map at corner `[column, row]` of the window. The caller
    /// adds the place of the window's first corner, and wraps the result into the map.
    pub fn new(from: [i32; 2], to: [i32; 2], mut height: impl FnMut([usize; 2]) -> f32) -> Self {
        let corners = to.map(|to| ((to + STEPS - 1) / STEPS + 1) as usize);
        let mut heights = Vec::with_capacity(corners[0] * corners[1]);
        for j in 0..corners[1] {
            heights.extend((0..corners[0]).map(|i| height([i, j])));
        }
        heights.extend([0.0; 3]);
        Self { corners, heights, holes: Vec::new(), from, to }
    }

    /// Adds holes. `is_hole` says whether cell `[column, row]` of the window is a hole.
    #[must_use]
    pub fn with_holes(mut self, mut is_hole: impl FnMut([usize; 2]) -> bool) -> Self {
        let [across, down] = self.corners.map(|corners| corners - 1);
        self.holes = (0..down).flat_map(|j| (0..across).map(move |i| [i, j])).map(&mut is_hole).collect();
        if !self.holes.contains(&true) {
            self.holes = Vec::new();
        }
        self
    }

    /// Returns whether some cells are holes.
    pub fn has_holes(&self) -> bool {
        !self.holes.is_empty()
    }

    /// Returns whether the cell at a place is a hole. The place is in cells from the window's first
    /// corner.
    pub fn is_hole(&self, place: [f64; 2]) -> bool {
        let [i, j] = self.cell_at(place).map(|at| at as usize);
        self.holes.get(j * (self.corners[0] - 1) + i).is_some_and(|is_hole| *is_hole)
    }

    /// Returns the corners that touch both holes and other cells, as `[column, row]` in the window.
    pub fn outline(&self) -> impl Iterator<Item = [i32; 2]> + use<'_> {
        let [across, down] =
            if self.has_holes() { self.corners.map(|corners| corners as i32) } else { [0; 2] };
        let is_between = |&[i, j]: &[i32; 2]| {
            let around = [[-0.5, -0.5], [0.5, -0.5], [-0.5, 0.5], [0.5, 0.5]];
            let holes = around.map(|[x, y]| self.is_hole([f64::from(i) + x, f64::from(j) + y]));
            holes.contains(&true) && holes.contains(&false)
        };
        (0..down).flat_map(move |j| (0..across).map(move |i| [i, j])).filter(is_between)
    }

    /// Returns the heights at all corners, row by row.
    pub fn heights(&self) -> &[f32] {
        &self.heights[..self.corners[0] * self.corners[1]]
    }

    /// Returns the heights at row `j` of the window's corners.
    pub fn row(&self, j: usize) -> &[f32] {
        &self.heights[j * self.corners[0]..][..self.corners[0]]
    }

    /// Returns the heights at four corners, from the corner with the index `at` onward. Corners are
    /// counted row by row.
    pub fn four(&self, at: i32) -> &[f32; 4] {
        self.heights[at as usize..].first_chunk().unwrap_or(&[0.0; 4])
    }

    /// Returns the heights at the corners of cell `[i, j]`, column and row in the window: `h00`,
    /// `h10`, `h01`, `h11`. The first digit is along the row.
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

    /// Returns the number of corners along the first axis.
    pub fn columns(&self) -> usize {
        self.corners[0]
    }

    /// Returns the number of corners along the second axis.
    pub fn rows(&self) -> usize {
        self.corners[1]
    }

    /// Returns column and row of the cell at a place. The place is in cells from the window's first
    /// corner. A place that rounding put beyond the border is in the cell at the border.
    pub fn cell_at(&self, place: [f64; 2]) -> [i32; 2] {
        [0, 1].map(|axis| (place[axis].floor() as i32).clamp(0, self.corners[axis] as i32 - 2))
    }

    /// Returns the height of the bilinear surface at a lattice point of the window, in heights of
    /// the map. The point is in steps from the window's first corner.
    pub fn height_at(&self, point: [i32; 2]) -> f64 {
        let cell = [0, 1].map(|axis| (point[axis] / STEPS).min(self.corners[axis] as i32 - 2));
        let part = |axis: usize| f64::from(point[axis] - STEPS * cell[axis]) / f64::from(STEPS);
        bilinear(self.cell(cell), [part(0), part(1)])
    }
}

/// Returns the height in a cell at `u` and `v` from 0 to 1.
pub fn bilinear([h00, h10, h01, h11]: [f64; 4], [u, v]: [f64; 2]) -> f64 {
    let [near, far] = [h00 + (h10 - h00) * u, h01 + (h11 - h01) * u];
    near + (far - near) * v
}
