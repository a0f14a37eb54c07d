//! How texels lie in a file's coordinate system.

use crate::elevation::GridTransform;

/// The cosine of the angle between a texel's sides up to which it is a rectangle.
pub(super) const SQUARE: f64 = 1e-3;

/// How texels lie in the file's coordinate system.
#[derive(Clone, Debug)]
pub(crate) struct Grid {
    /// The way from one column to the next, and from one row to the next, along x and y.
    pub(super) sides: [[f64; 2]; 2],
    /// The outer corner of the file's first texel, where the file says it.
    corner: Option<[f64; 2]>,
    /// Columns and rows.
    size: [f64; 2],
}

impl Grid {
    /// A grid of that many columns and rows by its texels' sides and where its first texel's outer corner
    /// lies.
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

    /// Whether the coordinates may be degrees, where nothing says what they are: all of them are possible
    /// ones.
    pub(super) fn may_be_degrees(&self) -> bool {
        let [columns, rows] = self.size;
        let [u, v] = self.sides;
        let Some(corner) = self.corner else { return true };
        [[0.0, 0.0], [columns, 0.0], [0.0, rows], [columns, rows]].iter().all(|at| {
            let [x, y] = [0, 1].map(|axis| corner[axis] + at[0] * u[axis] + at[1] * v[axis]);
            x.abs() <= 360.0 && y.abs() <= 90.0
        })
    }

    /// The `y` of the picture's middle, where the file says it.
    pub(super) fn middle_y(&self) -> Option<f64> {
        let [columns, rows] = self.size;
        self.y_at([columns / 2.0, rows / 2.0])
    }

    fn y_at(&self, [columns, rows]: [f64; 2]) -> Option<f64> {
        let [u, v] = self.sides;
        Some(self.corner?[1] + columns * u[1] + rows * v[1])
    }

    /// The least and the greatest of a length that is the longer the nearer `y` is to 0, over the picture, as
    /// parts of that in its middle.
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

    /// Where the texels of the map lie, turned over as it is read.
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

    /// The area of a texel, negative where rows go south and columns east.
    fn area(&self) -> f64 {
        let [u, v] = self.sides;
        u[0] * v[1] - u[1] * v[0]
    }

    /// Whether columns, and whether rows, lie in the other order than the map's.
    pub(crate) fn turned_over(&self) -> [bool; 2] {
        let [u, v] = self.sides;
        let upright = u[1].abs() <= SQUARE * u[0].abs() && v[0].abs() <= SQUARE * v[1].abs();
        if upright { [u[0] < 0.0, v[1] > 0.0] } else { [false, self.area() > 0.0] }
    }
}
