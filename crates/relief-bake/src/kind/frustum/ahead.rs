//! Texels ahead of a dual cell along one axis.

use relief_core::Wrap;

/// Texels `first..=last` of the map, as one run ahead of a cell.
#[derive(Clone, Copy, Debug)]
pub struct Run {
    /// First texel in the map.
    pub first: u32,
    /// Last texel in the map.
    pub last: u32,
    /// Distance of texel 0 ahead, in texels; the cell's own near texel is 0 ahead.
    zero: i64,
    /// Whether the texels get farther as their number grows.
    pub rising: bool,
}

impl Run {
    /// Returns the distance of a texel ahead, in texels.
    #[inline]
    pub fn ahead(&self, texel: u32) -> i64 {
        if self.rising { self.zero + i64::from(texel) } else { self.zero - i64::from(texel) }
    }
}

/// Returns the number, not wrapped, of the texel `ahead` texels ahead of a cell.
#[inline]
pub fn texel(cell: u32, forward: bool, ahead: i64) -> i64 {
    if forward { i64::from(cell) + ahead } else { i64::from(cell) + 1 - ahead }
}

/// Returns runs with the nearest image of every texel ahead of the cells `first..=last`, nearest
/// run first. Distances ahead are counted from the first cell. In a repeated map the last cell may
/// end at column 0 of the next tile; this column is included. For one of several cells, runs may
/// also hold texels behind it (less than 0 ahead) and farther images.
pub fn runs(wrap: Wrap, size: u32, [first, last]: [u32; 2], forward: bool) -> [Option<Run>; 3] {
    let (end, side) = (size - 1, i64::from(size));
    let at = i64::from(first);
    if forward {
        let own = Run { first, last: end, zero: -at, rising: true };
        let images = match wrap {
            Wrap::Clamp => None,
            Wrap::Repeat => Some(Run { first: 0, last, zero: side - at, rising: true }),
            Wrap::Mirror => Some(Run { first: 0, last, zero: 2 * side - 1 - at, rising: false }),
        };
        [Some(own), images, None]
    } else {
        let own = Run { first: 0, last: (last + 1).min(end), zero: at + 1, rising: false };
        let near = (first + 1).min(end);
        let images = match wrap {
            Wrap::Clamp => None,
            Wrap::Repeat => Some(Run { first: near, last: end, zero: at + 1 + side, rising: false }),
            Wrap::Mirror => Some(Run { first: near, last: end, zero: at + 2, rising: true }),
        };
        // The last cell's near column belongs to the next tile.
        let closing = Run { first: 0, last: 0, zero: at + 1 - side, rising: false };
        [Some(own), images, (wrap == Wrap::Repeat && last == end).then_some(closing)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_texel_ahead_is_in_a_run_at_its_nearest_place() {
        for wrap in Wrap::ALL {
            for size in 1..9 {
                for (cell, forward) in (0..size).flat_map(|cell| [(cell, true), (cell, false)]) {
                    let runs = runs(wrap, size, [cell, cell], forward);
                    let mut nearest = vec![i64::MAX; size as usize];
                    for run in runs.into_iter().flatten() {
                        for image in run.first..=run.last {
                            let ahead = run.ahead(image);
                            let number = texel(cell, forward, ahead);
                            assert_eq!(wrap.index(number, size), image, "{wrap} {size} {cell} {forward}");
                            nearest[image as usize] = nearest[image as usize].min(ahead);
                        }
                    }
                    // The cell's own two columns are equally near: texels 0 and 1 ahead make no
                    // difference.
                    for ahead in 0..3 * i64::from(size) {
                        let image = wrap.index(texel(cell, forward, ahead), size) as usize;
                        let found = nearest[image].max(1);
                        assert!(found <= ahead.max(1), "{wrap} {size} {cell} {forward}: {image} {ahead}");
                    }
                }
            }
        }
    }
}
