//! The bilinear surface between the texels.

use super::HeightMap;

impl HeightMap {
    /// The texel at any column and row, wrapped.
    #[inline]
    pub fn texel(&self, column: i64, row: i64) -> f32 {
        let i = self.wrap.index(column, self.width) as usize;
        let j = self.wrap.index(row, self.height) as usize;
        self.heights.texels[j * self.width as usize + i]
    }

    /// Whether dual cell `(i, j)` is a hole: one of its four corners is, see [`holes`](Self::holes).
    pub fn is_hole(&self, i: i64, j: i64) -> bool {
        let Some(holes) = self.holes() else { return false };
        let columns = self.wrap.pair(i, self.width);
        let rows = self.wrap.pair(j, self.height);
        rows.iter().any(|&row| columns.iter().any(|&column| holes.contains(column, row)))
    }

    /// The four corners `[h00, h10, h01, h11]` of dual cell `(i, j)`: the texels `(i, j)`, `(i + 1, j)`,
    /// `(i, j + 1)` and `(i + 1, j + 1)`.
    #[inline(always)]
    pub fn cell(&self, i: i64, j: i64) -> [f32; 4] {
        let [i0, i1] = self.wrap.pair(i, self.width).map(|column| column as usize);
        let [j0, j1] = self.wrap.pair(j, self.height).map(|row| row as usize * self.width as usize);
        let texels = self.texels();
        [texels[j0 + i0], texels[j0 + i1], texels[j1 + i0], texels[j1 + i1]]
    }

    /// The bilinear surface at texture coordinates `(u, v)`, in `[0, 1]`.
    pub fn height_at(&self, u: f64, v: f64) -> f64 {
        self.height_at_place(u * f64::from(self.width) - 0.5, v * f64::from(self.height) - 0.5)
    }

    /// The bilinear surface at a place counted in texels, in `[0, 1]`: whole numbers are the centres of
    /// texels, so that `(0, 0)` is the centre of the first one.
    #[inline(always)]
    pub fn height_at_place(&self, x: f64, y: f64) -> f64 {
        let (i, j) = (x.floor(), y.floor());
        bilinear(self.cell(i as i64, j as i64).map(f64::from), [x - i, y - j])
    }

    /// Both [`height_at_place`](Self::height_at_place) and [`slope_at_place`](Self::slope_at_place), the same
    /// bits, in less time than one after the other.
    #[inline(always)]
    pub fn height_and_slope_at_place(&self, x: f64, y: f64) -> (f64, [f64; 2]) {
        let (i, j) = (x.floor(), y.floor());
        let cell = self.cell(i as i64, j as i64).map(f64::from);
        let parts = [x - i, y - j];
        let is_on_line = |part: f64| part.min(1.0 - part) <= ON_A_LINE;
        let slope =
            if parts.into_iter().any(is_on_line) { self.slope_at_place(x, y) } else { slope(cell, parts) };
        (bilinear(cell, parts), slope)
    }

    /// The derivatives of the bilinear surface along `x` and `y` at such a place, in heights for each texel.
    /// On a line between dual cells, to 2⁻¹² of a texel, where the surface has a crease, the derivative
    /// across is the mean of both sides'. So at the centre of a texel it is the central difference.
    pub fn slope_at_place(&self, x: f64, y: f64) -> [f64; 2] {
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

    /// The displacement of a texel value, in metres (eq. 8).
    #[inline]
    pub fn displacement_m(&self, texel: f64) -> f64 {
        self.bias_m + self.scale_m * texel
    }
}

/// How near to a line between dual cells a place is on it, in texels.
const ON_A_LINE: f64 = 1.0 / 4096.0;

fn mix([a, b]: [f64; 2], part: f64) -> f64 {
    a + (b - a) * part
}

/// The height at a place within a cell, by parts of its sides.
#[inline]
fn bilinear([h00, h10, h01, h11]: [f64; 4], [fx, fy]: [f64; 2]) -> f64 {
    mix([mix([h00, h10], fx), mix([h01, h11], fx)], fy)
}

/// The derivatives of the height at such a place.
#[inline]
fn slope([h00, h10, h01, h11]: [f64; 4], [fx, fy]: [f64; 2]) -> [f64; 2] {
    [mix([h10 - h00, h11 - h01], fy), mix([h01 - h00, h11 - h10], fx)]
}
