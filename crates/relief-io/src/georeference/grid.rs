//! Grid of texels in a file's coordinate system.

use crate::elevation::GridTransform;

/// Greatest cosine of the angle between a texel's sides that counts as a rectangle.
pub(super) const SQUARE: f64 = 1e-3;

/// Grid of texels in a file's coordinate system.
#[derive(Clone, Debug)]
pub(crate) struct Grid {
    /// Steps from one column to the next, and from one row to the next, along x and y.
    pub(super) sides: [[f64; 2]; 2],
    /// Outer corner of the file's first texel, if the file gives it.
    corner: Option<[f64; 2]>,
    /// Numbers of columns and rows.
    size: [f64; 2],
}

impl Grid {
    /// Creates a grid of `size` columns and rows from its texels' sides and its first texel's outer
    /// corner. Returns an error if a texel has no area.
    pub(crate) fn new(
        sides: [[f64; 2]; 2],
        corner: Option<[f64; 2]>,
        size: [u32; 2],
    ) -> Result<Self, String> {
        let grid = Self { sides, corner, size: size.map(f64::from) };
        let (area, [u, v]) = (grid.area(), sides);
        if !area.is_finite() || area == 0.0 {
            return Err(format!("its texels have the sides {u:?} and {v:?}"));
        }
        Ok(grid)
    }

    /// Whether the coordinates may be degrees: all of them are possible angles.
    pub(super) fn may_be_degrees(&self) -> bool {
        let [columns, rows] = self.size;
        let [u, v] = self.sides;
        let Some(corner) = self.corner else { return true };
        [[0.0, 0.0], [columns, 0.0], [0.0, rows], [columns, rows]].iter().all(|at| {
            let [x, y] = [0, 1].map(|axis| corner[axis] + at[0] * u[axis] + at[1] * v[axis]);
            x.abs() <= 360.0 && y.abs() <= 90.0
        })
    }

    /// Returns `y` at the picture's middle, if the grid's position is known.
    pub(super) fn middle_y(&self) -> Option<f64> {
        let [columns, rows] = self.size;
        self.y_at([columns / 2.0, rows / 2.0])
    }

    fn y_at(&self, [columns, rows]: [f64; 2]) -> Option<f64> {
        let [u, v] = self.sides;
        Some(self.corner?[1] + columns * u[1] + rows * v[1])
    }

    /// Returns the least and the greatest value of a length over the picture, relative to its value
    /// `middle` at the picture's middle. `at` gives the length at `y`; it grows toward `y = 0`.
    pub(super) fn spread_of(&self, at: impl Fn(f64) -> f64, middle: f64) -> Option<[f64; 2]> {
        let [columns, rows] = self.size;
        let corners = [[0.0, 0.0], [columns, 0.0], [0.0, rows], [columns, rows]];
        let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
        for corner in corners {
            let y = self.y_at(corner)?;
            (low, high) = (low.min(y), high.max(y));
        }
        let nearest = if low <= 0.0 && high >= 0.0 { 0.0 } else { low.abs().min(high.abs()) };
        Some([at(low.abs().max(high.abs())) / middle, at(nearest) / middle])
    }

    /// Returns the transform of the map's texels, flipped as the map is read.
    pub(super) fn transform(&self) -> Option<GridTransform> {
        let ([mut column, mut row], mut origin) = (self.sides, self.corner?);
        let [columns, rows] = self.turned_over();
        for (is_turned, side, count) in [(columns, &mut column, self.size[0]), (rows, &mut row, self.size[1])]
        {
            if is_turned {
                origin = [0, 1].map(|axis| origin[axis] + count * side[axis]);
                *side = side.map(|length| -length);
            }
        }
        Some(GridTransform { origin, column, row })
    }

    /// Signed area of a texel, negative if rows go south and columns east.
    fn area(&self) -> f64 {
        let [u, v] = self.sides;
        u[0] * v[1] - u[1] * v[0]
    }

    /// Whether columns, and whether rows, run opposite to the map's.
    pub(crate) fn turned_over(&self) -> [bool; 2] {
        let [u, v] = self.sides;
        let upright = u[1].abs() <= SQUARE * u[0].abs() && v[0].abs() <= SQUARE * v[1].abs();
        if upright { [u[0] < 0.0, v[1] > 0.0] } else { [false, self.area() > 0.0] }
    }
}
