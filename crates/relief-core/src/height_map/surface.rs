//! The bilinear surface between the texels.

use super::HeightMap;
use crate::Wrap;

impl HeightMap {
    /// Texel at any column and row, wrapped.
    #[inline]
    pub fn texel(&self, column: i64, row: i64) -> f32 {
        let i = self.wrap.index(column, self.width) as usize;
        let j = self.wrap.index(row, self.height) as usize;
        self.heights.texels[j * self.width as usize + i]
    }

    /// Whether dual cell `(i, j)` is a hole: at least one of its four corners is, see
    /// [`holes`](Self::holes).
    pub fn is_hole(&self, i: i64, j: i64) -> bool {
        let Some(holes) = self.holes() else { return false };
        let columns = self.wrap.pair(i, self.width);
        let rows = self.wrap.pair(j, self.height);
        rows.iter().any(|&row| columns.iter().any(|&column| holes.contains(column, row)))
    }

    /// The four corners `[h00, h10, h01, h11]` of dual cell `(i, j)`: the texels `(i, j)`,
    /// `(i + 1, j)`, `(i, j + 1)` and `(i + 1, j + 1)`.
    #[inline(always)]
    pub fn cell(&self, i: i64, j: i64) -> [f32; 4] {
        let [i0, i1] = self.wrap.pair(i, self.width).map(|column| column as usize);
        let [j0, j1] = self.wrap.pair(j, self.height).map(|row| row as usize * self.width as usize);
        let texels = self.texels();
        [texels[j0 + i0], texels[j0 + i1], texels[j1 + i0], texels[j1 + i1]]
    }

    /// Height of the bilinear surface at texture coordinates `(u, v)`, in `[0, 1]`.
    pub fn height_at(&self, u: f64, v: f64) -> f64 {
        self.height_at_place(u * f64::from(self.width) - 0.5, v * f64::from(self.height) - 0.5)
    }

    /// Height of the bilinear surface, in `[0, 1]`, at a position in texels. Whole numbers are
    /// texel centres: `(0, 0)` is the centre of the first texel.
    #[inline(always)]
    pub fn height_at_place(&self, x: f64, y: f64) -> f64 {
        let (i, j) = (x.floor(), y.floor());
        bilinear(self.cell(i as i64, j as i64).map(f64::from), [x - i, y - j])
    }

    /// Returns [`height_at_place`](Self::height_at_place) and
    /// [`slope_at_place`](Self::slope_at_place) with the same bits, in less time than two calls.
    #[inline(always)]
    pub fn height_and_slope_at_place(&self, x: f64, y: f64) -> (f64, [f64; 2]) {
        let (i, j) = (x.floor(), y.floor());
        let cell = self.cell(i as i64, j as i64).map(f64::from);
        let parts = [x - i, y - j];
        let is_on_line = |part: f64| part.min(1.0 - part) <= ON_A_LINE;
        let is_special = parts.into_iter().any(is_on_line) || self.is_at_edge(x, y);
        let slope = if is_special { self.slope_at_place(x, y) } else { slope(cell, parts) };
        (bilinear(cell, parts), slope)
    }

    /// Derivatives of the bilinear surface along `x` and `y`, in heights per texel, at a position
    /// in texels.
    ///
    /// The surface has creases on the lines between dual cells. Within 2⁻¹² of a texel of such a
    /// line, the derivative across it is the mean of both sides. So at a texel centre it is the
    /// central difference.
    ///
    /// From the outermost centres of a clamped map to its edge the surface is level, because
    /// nothing is known about what lies beyond. There the derivatives are taken from the adjacent
    /// cells inside, so that neighbouring tiles of a terrain have no rim where they meet.
    pub fn slope_at_place(&self, x: f64, y: f64) -> [f64; 2] {
        if self.is_at_edge(x, y) {
            return self.slope_inside(x, y);
        }
        let on_line = |at: f64| {
            let line = at.round();
            ((at - line).abs() <= ON_A_LINE).then_some(line as i64)
        };
        let in_cell = |at: f64| (at.floor() as i64, at - at.floor());
        let texel = |i: i64, j: i64| f64::from(self.texel(i, j));
        match (on_line(x), on_line(y)) {
            (Some(i), Some(j)) => {
                [texel(i + 1, j) - texel(i - 1, j), texel(i, j + 1) - texel(i, j - 1)].map(|rise| 0.5 * rise)
            }
            (Some(i), None) => {
                let (j, part) = in_cell(y);
                let across = [j, j + 1].map(|j| 0.5 * (texel(i + 1, j) - texel(i - 1, j)));
                [mix(across, part), texel(i, j + 1) - texel(i, j)]
            }
            (None, Some(j)) => {
                let (i, part) = in_cell(x);
                let across = [i, i + 1].map(|i| 0.5 * (texel(i, j + 1) - texel(i, j - 1)));
                [texel(i + 1, j) - texel(i, j), mix(across, part)]
            }
            (None, None) => {
                let ((i, fx), (j, fy)) = (in_cell(x), in_cell(y));
                slope(self.cell(i, j).map(f64::from), [fx, fy])
            }
        }
    }

    /// Whether a position on a clamped map is on the line of its outermost centres, or farther out.
    fn is_at_edge(&self, x: f64, y: f64) -> bool {
        let is_out = |at: f64, side: u32| at <= ON_A_LINE || at >= f64::from(side) - 1.0 - ON_A_LINE;
        self.wrap == Wrap::Clamp && (is_out(x, self.width) || is_out(y, self.height))
    }

    /// Slope of a clamped map whose outermost cells are continued to its edge. Beyond the edge it
    /// is level.
    fn slope_inside(&self, x: f64, y: f64) -> [f64; 2] {
        let [across, down] = [self.around(x, self.width), self.around(y, self.height)];
        let height = |x: f64, y: f64| self.height_at_place(x, y);
        [
            (height(across.behind, down.at) - height(across.before, down.at)) / across.texels(),
            (height(across.at, down.behind) - height(across.at, down.before)) / down.texels(),
        ]
    }

    /// Positions along a side of a clamped map whose difference is the derivative at `at`. Beyond
    /// the map's edge the difference is 0.
    fn around(&self, at: f64, side: u32) -> Around {
        let last = f64::from(side) - 1.0;
        let is_beyond = at < -0.5 - ON_A_LINE || at > last + 0.5 + ON_A_LINE;
        let at = at.clamp(0.0, last);
        if is_beyond {
            return Around { at, before: at, behind: at };
        }
        let line = at.round();
        let (before, behind) = if (at - line).abs() <= ON_A_LINE {
            (line - 1.0, line + 1.0)
        } else {
            (at.floor(), at.floor() + 1.0)
        };
        Around { at, before: before.max(0.0), behind: behind.min(last) }
    }

    /// Distance in texels between two heights: one texel before and one texel behind the texture
    /// coordinates, along `u` and `v`.
    ///
    /// It is 2, or less at the edges of a clamped map, whose heights do not change beyond the
    /// outermost centres. The difference of the two heights over it is the slope for shading (eq.
    /// 9).
    pub fn texels_apart_at(&self, u: f64, v: f64) -> [f64; 2] {
        let apart = |place: f64, side: f64| match self.wrap {
            Wrap::Clamp => {
                (2.0 - (1.5 - place).max(0.0) - (place + 1.5 - side).max(0.0)).max(LEAST_TEXELS_APART)
            }
            Wrap::Repeat | Wrap::Mirror => 2.0,
        };
        let [columns, rows] = [self.width, self.height].map(f64::from);
        [apart(u * columns, columns), apart(v * rows, rows)]
    }

    /// Displacement of a texel value, in metres (eq. 8).
    #[inline]
    pub fn displacement_m(&self, texel: f64) -> f64 {
        self.bias_m + self.scale_m * texel
    }
}

/// Distance in texels within which a position counts as on a line between dual cells.
const ON_A_LINE: f64 = 1.0 / 4096.0;

/// Value at the edge of a clamped map: the height one texel inside is half a texel from the
/// outermost centre. Beyond the edge, slopes fall to 0.
const LEAST_TEXELS_APART: f64 = 0.5;

/// Positions along a side whose difference is a derivative.
struct Around {
    at: f64,
    before: f64,
    behind: f64,
}

impl Around {
    /// Texels between the two positions, at least 1: on a side of one texel the difference is 0.
    fn texels(&self) -> f64 {
        (self.behind - self.before).max(1.0)
    }
}

fn mix([a, b]: [f64; 2], part: f64) -> f64 {
    a + (b - a) * part
}

/// Height at a position within a cell, by parts of its sides.
#[inline]
fn bilinear([h00, h10, h01, h11]: [f64; 4], [fx, fy]: [f64; 2]) -> f64 {
    mix([mix([h00, h10], fx), mix([h01, h11], fx)], fy)
}

/// Derivatives of the height at a position within a cell.
#[inline]
fn slope([h00, h10, h01, h11]: [f64; 4], [fx, fy]: [f64; 2]) -> [f64; 2] {
    [mix([h10 - h00, h11 - h01], fy), mix([h01 - h00, h11 - h10], fx)]
}
