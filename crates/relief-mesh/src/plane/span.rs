//! Tiles along an axis of a plane.

use crate::interior::STEPS;

use super::centre;

/// Approximate number of cells of a tile along a side.
pub const TILE: f64 = 128.0;

/// Returns the distance in texels by which rounding can move an end of a plane off the lattice, as
/// texture coordinates are `f32`.
fn rounding(at: f64) -> f64 {
    f64::from(f32::EPSILON) * at.abs().max(1.0)
}

/// Tile along an axis, with the lattice over it.
///
/// Steps are 1/16 of a texel, and centres of texels are at multiples of 16 steps. A tile that ends
/// beside that lattice is a strip within one cell, with 16 steps of its own. The surface has no
/// crease in it, so that it needs no centre.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Both ends in texels: `i + ½` is the centre of texel `i`.
    pub ends: [f64; 2],
    /// Steps at both ends.
    pub steps: [i32; 2],
    /// Place of step 0.
    pub origin: f64,
    /// Length of a step in texels.
    pub step: f64,
}

impl Span {
    /// Returns the place of a step. Both tiles at a step have the same place.
    pub fn place(&self, step: i32) -> f64 {
        match self.steps {
            [first, _] if step == first => self.ends[0],
            [_, last] if step == last => self.ends[1],
            _ => self.origin + f64::from(step) * self.step,
        }
    }

    /// Returns the texel at step 0, unless this is a strip.
    pub fn first_texel(&self) -> Option<i64> {
        (self.step == 1.0 / f64::from(STEPS)).then_some((self.origin - 0.5) as i64)
    }

    fn strip(from: f64, to: f64) -> Self {
        Self { ends: [from, to], steps: [0, STEPS], origin: from, step: (to - from) / f64::from(STEPS) }
    }

    fn whole(from: f64, to: f64) -> Self {
        let origin = (from - 0.5 + rounding(from)).floor() + 0.5;
        let steps = [from, to].map(|end| ((end - origin) * f64::from(STEPS)).round() as i32);
        Self { ends: [from, to], steps, origin, step: 1.0 / f64::from(STEPS) }
    }
}

/// Returns the tiles of an axis between two places.
pub fn spans(from: f64, to: f64) -> Vec<Span> {
    let is_on_lattice = |at: f64| {
        let steps = at * f64::from(STEPS);
        (steps - steps.round()).abs() <= rounding(at) * f64::from(STEPS)
    };
    let first = (from - 0.5 - rounding(from)).ceil() + 0.5;
    let last = (to - 0.5 + rounding(to)).floor() + 0.5;
    if last < first {
        return vec![Span::strip(from, to)];
    }
    let mut spans = Vec::new();
    let begin = if is_on_lattice(from) { from } else { first };
    let end = if is_on_lattice(to) { to } else { last };
    if begin > from {
        spans.push(Span::strip(from, begin));
    }
    if end > begin {
        let count = ((end - begin) / TILE).ceil().max(1.0) as u32;
        let cut = |number: u32| match number {
            0 => begin,
            last if last == count => end,
            _ => centre(begin + (end - begin) * f64::from(number) / f64::from(count)),
        };
        spans.extend((0..count).map(|number| Span::whole(cut(number), cut(number + 1))));
    }
    if to > end {
        spans.push(Span::strip(end, to));
    }
    spans
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tiles_follow_one_another_and_their_lattices_hold_the_centres() {
        for (from, to) in [
            (0.0, 256.0),
            (0.0, 1.0),
            (0.0, 2049.0),
            (-3.3, 17.9),
            (0.2, 0.4),
            (0.2, 0.7),
            (0.5, 64.5),
            (10.25, 300.031_25),
            (0.0, 128.500_000_1),
        ] {
            let spans = spans(from, to);
            assert_eq!([spans[0].ends[0], spans[spans.len() - 1].ends[1]], [from, to]);
            for (at, span) in spans.iter().enumerate() {
                assert!(at == 0 || spans[at - 1].ends[1] == span.ends[0], "{spans:?}");
                let [first, last] = span.steps;
                assert!((0..STEPS).contains(&first) && last > first && last <= 200 * STEPS, "{span:?}");
                assert!(span.ends[1] - span.ends[0] <= TILE + 1.0);
                let mut before = f64::NEG_INFINITY;
                for step in first..=last {
                    let place = span.place(step);
                    assert!(place > before, "{span:?}: {step}");
                    before = place;
                }
                if let Some(texel) = span.first_texel() {
                    assert_eq!(span.origin, texel as f64 + 0.5, "{span:?}");
                } else {
                    let centre = (span.ends[0] - 0.5).floor() + 1.5;
                    assert!(span.ends[1] <= centre, "{span:?}: a crease inside");
                }
            }
        }
    }
}
