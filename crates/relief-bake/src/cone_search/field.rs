//! Cells of the surface.

use relief_core::HeightMap;

/// Height map with fast reads around a texel.
pub(crate) struct Field<'a> {
    pub map: &'a HeightMap,
    size: [i64; 2],
}

/// Dual cell relative to a texel.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RelativeCell {
    /// Corner `h00`, in texels from the texel's centre.
    pub offset: [i64; 2],
    /// Heights `h00 h10 h01 h11`.
    pub heights: [f64; 4],
}

impl<'a> Field<'a> {
    pub fn new(map: &'a HeightMap) -> Self {
        Self { map, size: [i64::from(map.width()), i64::from(map.height())] }
    }

    /// Returns the 3 by 3 heights around a texel, inside of the map or not, row by row.
    #[inline(always)]
    pub fn around(&self, [i, j]: [i64; 2]) -> [[f64; 3]; 3] {
        [self.row([i - 1, j - 1]), self.row([i - 1, j]), self.row([i - 1, j + 1])]
    }

    /// Returns the heights of `N` texels of a row, inside of the map or not.
    #[inline(always)]
    pub fn row<const N: usize>(&self, [i, j]: [i64; 2]) -> [f64; N] {
        if j >= 0 && j < self.size[1] && i >= 0 && i + N as i64 <= self.size[0] {
            let first = (j * self.size[0] + i) as usize;
            let texels = &self.map.texels()[first..first + N];
            std::array::from_fn(|k| f64::from(texels[k]))
        } else {
            std::array::from_fn(|k| f64::from(self.map.texel(i + k as i64, j)))
        }
    }
}

impl RelativeCell {
    /// Returns the cells around a vertex at an offset in texels, given the 3 by 3 heights around
    /// it.
    #[inline(always)]
    pub fn around([x, y]: [i64; 2], [above, level, below]: &[[f64; 3]; 3]) -> [Self; 4] {
        let cell = |offset, heights| Self { offset, heights };
        [
            cell([x - 1, y - 1], [above[0], above[1], level[0], level[1]]),
            cell([x, y - 1], [above[1], above[2], level[1], level[2]]),
            cell([x - 1, y], [level[0], level[1], below[0], below[1]]),
            cell([x, y], [level[1], level[2], below[1], below[2]]),
        ]
    }
}
