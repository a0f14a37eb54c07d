//! The surface, cell by cell.

use relief::HeightMap;

/// A map, quick to read around a texel.
pub(in crate::kind) struct Field<'a> {
    pub map: &'a HeightMap,
    size: [i64; 2],
}

/// A dual cell as seen from a texel.
#[derive(Clone, Copy, Debug)]
pub(in crate::kind) struct Seen {
    /// Corner `h00` in texels from the texel's centre.
    pub offset: [i64; 2],
    /// The heights `h00 h10 h01 h11`.
    pub heights: [f64; 4],
}

impl<'a> Field<'a> {
    pub fn new(map: &'a HeightMap) -> Self {
        Self { map, size: [i64::from(map.width()), i64::from(map.height())] }
    }

    /// The cell at that offset from a texel, whether or not it is in the map.
    #[inline(always)]
    pub fn cell(&self, texel: [i64; 2], offset: [i64; 2]) -> Seen {
        let [i, j] = [texel[0] + offset[0], texel[1] + offset[1]];
        let ([h00, h10], [h01, h11]) = (self.row([i, j]), self.row([i, j + 1]));
        Seen { offset, heights: [h00, h10, h01, h11] }
    }

    /// The heights of as many texels of a row, whether or not they are in the map.
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
