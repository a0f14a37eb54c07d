//! A pyramid that is descended alone: no node that the ray leaves is noticed, and none above is looked at
//! again. Szirmay-Kalos and Umenhoffer 2008, section 4.3.3, says that this is wrong.

use rayon::prelude::*;
use relief_compare::Case;
use relief_core::{Cost, HeightMap, Hit, Path, Wrap};

use relief_testing::brute::pyramid::level;

/// The greatest height over each node, from the finest level on.
struct Pyramid<'a> {
    map: &'a HeightMap,
    levels: Vec<Vec<f32>>,
}

impl<'a> Pyramid<'a> {
    fn new(map: &'a HeightMap) -> Self {
        let top = map.width().max(map.height()).next_power_of_two().ilog2();
        let greatest = |of| level(map, of).into_iter().map(|[_, most]| most).collect();
        Self { map, levels: (0..=top).map(greatest).collect() }
    }

    /// The greatest height over the node that a place lies in.
    fn at(&self, of: usize, [u, v, _]: [f64; 3]) -> f64 {
        let [column, row] = [(u, self.map.width()), (v, self.map.height())].map(|(place, texels)| {
            let cell = (place * f64::from(texels) - 0.5).floor() as i64;
            let texels = i64::from(texels);
            let inside = match self.map.wrap() {
                Wrap::Repeat => cell.rem_euclid(texels),
                Wrap::Clamp => cell.clamp(0, texels - 1),
                Wrap::Mirror => {
                    let folded = cell.rem_euclid(2 * texels);
                    // The cell beyond the middle of a mirrored one is the one before it.
                    if folded < texels { folded } else { (2 * texels - 2 - folded).max(0) }
                }
            };
            inside as usize >> of
        });
        let columns = (self.map.width() as usize).div_ceil(1 << of);
        self.levels[of][row * columns + column].into()
    }

    /// Where the path ends that sinks to each level's height in turn.
    fn descend(&self, path: &Path) -> Hit {
        let (mut t, mut cost) = (0.0, Cost::default());
        for of in (0..self.levels.len()).rev() {
            let place = path.at(t);
            cost.reads += 1;
            let gap = place[2] - self.at(of, place);
            if gap > 0.0 {
                t += gap / -path.h[1];
            }
            if t >= path.exit {
                return Hit::miss(cost);
            }
        }
        let [u, v, height] = path.at(t);
        Hit { found: true, exhausted: false, uv: [u, v], height, t, cost }
    }
}

/// The hits of straight rays that go down.
pub fn hits(case: &Case) -> Vec<Hit> {
    let pyramid = Pyramid::new(case.map);
    case.paths.par_iter().map(|path| pyramid.descend(path)).collect()
}
