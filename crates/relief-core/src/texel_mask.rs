//! Sets of texels of a map.

/// A set of texels of a map, row by row from the top, at one bit per texel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TexelMask {
    width: u32,
    height: u32,
    words: Vec<u64>,
}

impl TexelMask {
    /// Creates the set of all texels for which `is_in` returns true. It is called with each column
    /// and row of a map of `width` x `height` texels.
    pub fn from_fn(width: u32, height: u32, mut is_in: impl FnMut(u32, u32) -> bool) -> Self {
        let texels = u64::from(width) * u64::from(height);
        let mut words = vec![0u64; texels.div_ceil(64) as usize];
        let places = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
        for (at, (column, row)) in places.enumerate() {
            words[at / 64] |= u64::from(is_in(column, row)) << (at % 64);
        }
        Self { width, height, words }
    }

    /// Columns.
    #[inline]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    #[inline]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Whether the set contains a texel. Texels outside the map are never contained.
    #[inline]
    pub fn contains(&self, column: u32, row: u32) -> bool {
        if column >= self.width || row >= self.height {
            return false;
        }
        let at = row as usize * self.width as usize + column as usize;
        self.words[at / 64] >> (at % 64) & 1 == 1
    }

    /// Number of texels in the set.
    pub fn count(&self) -> u64 {
        self.words.iter().map(|word| u64::from(word.count_ones())).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texels_are_found_again_and_counted() {
        for (width, height) in [(1, 1), (13, 7), (64, 3), (65, 2)] {
            let is_in = |column: u32, row: u32| (column * 7 + row * 5) % 3 == 1;
            let mask = TexelMask::from_fn(width, height, is_in);
            let mut count = 0;
            for (column, row) in (0..height).flat_map(|row| (0..width).map(move |column| (column, row))) {
                assert_eq!(mask.contains(column, row), is_in(column, row), "({column}, {row})");
                count += u64::from(is_in(column, row));
            }
            assert_eq!((mask.count(), mask.width(), mask.height()), (count, width, height));
            let all = TexelMask::from_fn(width, height, |_, _| true);
            assert!(!all.contains(width, 0) && !all.contains(0, height) && !all.contains(u32::MAX, u32::MAX));
        }
    }
}
