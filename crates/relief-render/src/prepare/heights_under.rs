//! Bounds of the heights under base triangles, for their shells.

use glam::DVec2;
use relief_core::{HeightBounds, HeightMap};

/// Texels of the finest level beyond a triangle's own that its segments may read, in any level.
/// Segments reach beyond a triangle by rounding, and by their tolerance beside the ray.
const BEYOND_TEXELS: f64 = 2.0;

/// Bounds of the heights under triangles, in several mip levels.
pub struct HeightsUnder {
    /// Levels, from the finest on.
    levels: Vec<Level>,
}

/// Bounds of one mip level.
struct Level {
    /// Texels of this level that may be read beyond a triangle's own.
    beyond: DVec2,
    bounds: HeightBounds,
}

impl HeightsUnder {
    /// Creates the bounds of a map whose first `levels` mip levels may be traced.
    pub fn new(map: &HeightMap, levels: u32) -> Self {
        let size = |map: &HeightMap| DVec2::new(map.width().into(), map.height().into());
        let level = |number| {
            let level = map.level(number);
            let beyond = size(&level) / size(map) * BEYOND_TEXELS;
            Level { beyond, bounds: HeightBounds::new(&level) }
        };
        Self { levels: (0..levels.max(1)).map(level).collect() }
    }

    /// Returns bounds of the heights in all levels under a triangle, from the texture coordinates
    /// of its corners: a lower and an upper one.
    pub fn under(&self, uv: [DVec2; 3]) -> [f32; 2] {
        let widest = [f32::INFINITY, f32::NEG_INFINITY];
        self.levels
            .iter()
            .map(|level| level.under(uv))
            .fold(widest, |[low, high], [lowest, highest]| [low.min(lowest), high.max(highest)])
    }
}

impl Level {
    fn under(&self, uv: [DVec2; 3]) -> [f32; 2] {
        let [a, b, c] = uv;
        self.bounds.between(a.min(b).min(c), a.max(b).max(c), self.beyond)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use proptest::strategy::ValueTree;
    use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
    use relief_core::Wrap;

    /// A map with a single peak and a single hole on each of its levels' scales, at odd places.
    fn map(size: [u32; 2], wrap: Wrap, seed: u32) -> HeightMap {
        let of = |i: u32, j: u32| {
            let mixed = (i * 7 + j * 13 + seed).wrapping_mul(2_654_435_761) >> 16;
            let waves = (i as f32 * 0.21 + j as f32 * 0.13 + seed as f32).sin() * 0.3 + 0.5;
            if mixed.is_multiple_of(29) { (mixed % 2) as f32 } else { waves }
        };
        HeightMap::from_fn(size[0], size[1], wrap, of).expect("heights from 0 to 1")
    }

    /// Returns the distance of a level's surface from the stated range of a triangle. It is taken
    /// at many points of the triangle, and up to `beyond` finest texels beside them.
    fn outside(map: &HeightMap, level: u32, uv: [DVec2; 3], beyond: f64, said: [f32; 2]) -> f64 {
        let seen = map.level(level);
        let finest = DVec2::new(map.width().into(), map.height().into());
        let (parts, mut most) = (24, 0.0f64);
        for i in 0..=parts {
            for j in 0..=parts - i {
                let [a, b] = [i, j].map(|part| f64::from(part) / f64::from(parts));
                let at = uv[0] * (1.0 - a - b) + uv[1] * a + uv[2] * b;
                let turn = f64::from(i * 31 + j * 17);
                let at = at + DVec2::new(turn.cos(), turn.sin()) * beyond / finest;
                let height = seen.height_at(at.x, at.y);
                most = most.max(f64::from(said[0]) - height).max(height - f64::from(said[1]));
            }
        }
        most
    }

    fn triangle() -> impl Strategy<Value = [DVec2; 3]> {
        let corner = (-1.0..1.0f64, -1.0..1.0f64);
        let size = prop::sample::select(vec![0.01, 0.1, 0.5, 1.5]);
        ((-2.0..2.0f64, -2.0..2.0f64), prop::array::uniform3(corner), size).prop_map(
            |(centre, corners, size)| corners.map(|corner| DVec2::from(centre) + DVec2::from(corner) * size),
        )
    }

    #[test]
    fn no_level_is_higher_or_lower_under_a_triangle() {
        let mut runner =
            TestRunner::new_with_rng(Config::default(), TestRng::deterministic_rng(RngAlgorithm::ChaCha));
        let (mut tight, mut noticed) = (0, 0);
        for (number, wrap) in (0..90).zip(Wrap::ALL.into_iter().cycle()) {
            let size = [[64, 64], [37, 50], [1, 40]][number as usize / 3 % 3];
            let map = map(size, wrap, number);
            let [finest, all] = [1, map.levels()].map(|levels| HeightsUnder::new(&map, levels));
            for _ in 0..8 {
                let uv = triangle().new_tree(&mut runner).expect("a triangle").current();
                let said = all.under(uv);
                for level in 0..map.levels() {
                    for beyond in [0.0, BEYOND_TEXELS] {
                        let outside = outside(&map, level, uv, beyond, said);
                        assert!(outside <= 1e-7, "{wrap}, {size:?}, level {level}, {uv:?}: {outside}");
                    }
                }
                let [low, high] = map.extremes();
                tight += usize::from(said[1] - said[0] < 0.9 * (high - low));
                // The finest level alone does not bound the others.
                let alone = finest.under(uv);
                noticed += usize::from((1..map.levels()).any(|k| outside(&map, k, uv, 0.0, alone) > 1e-3));
            }
        }
        assert!(tight > 100 && noticed > 100, "{tight} {noticed}");
    }
}
