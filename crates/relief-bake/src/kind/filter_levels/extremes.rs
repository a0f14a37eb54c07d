//! Levels that are nowhere below, or nowhere above, the surface of the map.

use rayon::prelude::*;
use relief_core::{Cancelled, HeightMap, Watch, Wrap};

use super::axis::Axis;

/// Amount added to a height between texels before it is rounded: more than the rounding of two
/// interpolations in `f64`.
const SLACK: f64 = 1.0 / (1u64 << 50) as f64;

/// Choice of extremes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// The greatest heights.
    Above,
    /// The least heights.
    Below,
}

/// Places along an axis at which the surface has its extremes over a texel's support: the centres
/// of the map's texels, and both ends.
struct Support {
    /// First and last centre within, not wrapped; none where the last is before the first.
    centres: [i64; 2],
    /// Ends that lie between two centres: the first of these, and the part of the way to the
    /// second.
    cuts: [Option<(i64, f64)>; 2],
}

impl Support {
    /// Creates the support from the centre of the previous texel to the centre of the next one.
    fn new(axis: Axis, texel: usize) -> Self {
        let [fine, coarse, texel] = [i64::from(axis.fine), i64::from(axis.coarse), texel as i64];
        // In texels of the map from the centre of the first, times 2 `coarse`.
        let unit = 2 * coarse;
        let at = |texel: i64| (2 * texel + 1) * fine - coarse;
        let [mut from, mut to] = [at(texel - 1), at(texel + 1)];
        if axis.repeats {
            if to - from >= fine * unit {
                return Self { centres: [0, fine - 1], cuts: [None, None] };
            }
        } else {
            // Beyond the outermost centres the surface is as high as there.
            (from, to) = (from.max(0), to.min((fine - 1) * unit));
        }
        let cut = |at: i64| {
            let part = at.rem_euclid(unit);
            (part != 0).then(|| (at.div_euclid(unit), part as f64 / unit as f64))
        };
        let centres = [-(-from).div_euclid(unit), to.div_euclid(unit)];
        Self { centres, cuts: [cut(from), cut(to)] }
    }
}

/// Returns the height between two heights, raised by more than its rounding.
fn mixed(a: f64, b: f64, part: f64) -> f64 {
    if a == b { a } else { (a + (b - a) * part + SLACK).min(a.max(b)) }
}

/// Returns the least `f32` that is not below a value.
fn rounded_up(value: f64) -> f32 {
    let rounded = value as f32;
    if f64::from(rounded) < value { rounded.next_up() } else { rounded }
}

/// Returns the level's texels, row by row from the top: each is the extreme of the map's surface
/// over all points where the texel counts.
pub fn level(map: &HeightMap, size: [u32; 2], side: Side, watch: &Watch) -> Result<Vec<f32>, Cancelled> {
    // The least heights are the greatest of the heights turned upside down.
    let sign = if side == Side::Above { 1.0 } else { -1.0 };
    let repeats = map.wrap() == Wrap::Repeat;
    let across = Axis { fine: map.width(), coarse: size[0], repeats };
    let down = Axis { fine: map.height(), coarse: size[1], repeats };
    let columns: Vec<Support> = (0..across.nodes()).map(|texel| Support::new(across, texel)).collect();
    let (width, rows) = (map.width() as usize, size[1] as f32);
    let row = |at: i64| {
        let row = map.wrap().index(at, map.height()) as usize;
        &map.texels()[row * width..][..width]
    };
    let mut level = vec![0.0f32; across.nodes() * down.nodes()];
    level.par_chunks_mut(across.nodes()).enumerate().try_for_each_init(
        || (vec![0.0f64; width], vec![0.0f64; across.nodes()]),
        |(line, highest), (at, texels)| {
            watch.at(at as f32 / rows)?;
            let support = Support::new(down, at);
            highest.fill(f64::NEG_INFINITY);
            for centre in support.centres[0]..=support.centres[1] {
                for (value, &texel) in line.iter_mut().zip(row(centre)) {
                    *value = sign * f64::from(texel);
                }
                raise(highest, line, &columns, map.wrap());
            }
            for (centre, part) in support.cuts.into_iter().flatten() {
                let pairs = row(centre).iter().zip(row(centre + 1));
                for (value, (&before, &after)) in line.iter_mut().zip(pairs) {
                    *value = mixed(sign * f64::from(before), sign * f64::from(after), part);
                }
                raise(highest, line, &columns, map.wrap());
            }
            for (texel, &highest) in texels.iter_mut().zip(highest.iter()) {
                // The sum turns the negative zero that a sign may have left into zero.
                *texel = sign as f32 * rounded_up(highest) + 0.0;
            }
            Ok(())
        },
    )?;
    Ok(level)
}

/// Raises the highest so far to the heights of a line over every column's support.
fn raise(highest: &mut [f64], line: &[f64], columns: &[Support], wrap: Wrap) {
    let value = |at: i64| line[wrap.index(at, line.len() as u32) as usize];
    for (highest, Support { centres: [first, last], cuts }) in highest.iter_mut().zip(columns) {
        let inner = usize::try_from(*first).ok().zip(usize::try_from(*last + 1).ok());
        let most = match inner.and_then(|(first, end)| line.get(first..end)) {
            Some(inside) => inside.iter().fold(*highest, |most, &value| most.max(value)),
            None => (*first..=*last).fold(*highest, |most, at| most.max(value(at))),
        };
        let cuts = cuts.iter().flatten().map(|&(at, part)| mixed(value(at), value(at + 1), part));
        *highest = cuts.fold(most, f64::max);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn supports_reach_from_centre_to_centre() {
        // Of four texels to two: the centres of the two lie between texels 0 and 1, and 2 and 3.
        let clamped = Axis { fine: 4, coarse: 2, repeats: false };
        let first = Support::new(clamped, 0);
        assert_eq!((first.centres, first.cuts), ([0, 2], [None, Some((2, 0.5))]));
        let last = Support::new(clamped, 1);
        assert_eq!((last.centres, last.cuts), ([1, 3], [Some((0, 0.5)), None]));
        let tiled = Support::new(Axis { fine: 8, coarse: 4, repeats: true }, 0);
        assert_eq!((tiled.centres, tiled.cuts), ([-1, 2], [Some((-2, 0.5)), Some((2, 0.5))]));
        let whole = Support::new(Axis { fine: 4, coarse: 2, repeats: true }, 1);
        assert_eq!((whole.centres, whole.cuts), ([0, 3], [None, None]));
    }

    #[test]
    fn rounding_up_is_never_below_and_leaves_what_is_exact() {
        assert_eq!((rounded_up(0.5), rounded_up(-0.5), mixed(0.3, 0.3, 0.7)), (0.5, -0.5, 0.3));
        let third = 1.0 / 3.0;
        assert!(f64::from(rounded_up(third)) >= third && f64::from(rounded_up(-third)) >= -third);
        assert!(mixed(0.1, 0.7, third) > 0.1 + 0.6 * third && mixed(0.1, 0.7, 1.0) <= 0.7);
    }
}
