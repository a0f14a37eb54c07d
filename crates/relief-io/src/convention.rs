//! Detection of conventions: whether a height map's white is high or deep, and whether a normal
//! map's green points up or down.

use std::path::Path;

use relief_core::HeightMap;

use crate::texture_set::is_height_word;
use crate::{Convention, GreenSign, NormalMap};

/// Conventions under which a height map and a normal map agree best.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detection {
    /// Whether white is high or deep in the height map as it was read.
    pub convention: Convention,
    /// Confidence in `convention`, from 0 to 1: the absolute correlation along `u`.
    pub convention_confidence: f64,
    /// Direction of green in the normal map's file, given that it was read as [`GreenSign::PlusY`].
    pub green: GreenSign,
    /// Confidence in `green`, from 0 to 1: the lesser absolute correlation along `u` and `v`, since
    /// both signs decide it.
    pub green_confidence: f64,
}

/// Compares the slopes of a normal map with the gradient of a height map. The normal map must be
/// read as [`GreenSign::PlusY`] and the height map as [`Convention::Height`].
///
/// The normal of a height field leans against its slope: `x` falls with `∂h/∂u`. `y`, which points
/// along falling `v`, rises with `∂h/∂v`. The correlation of `-x` with `∂h/∂u` is positive for
/// heights and negative for depths. The correlation of `y` with `∂h/∂v` has the same sign if green
/// points up, and the opposite sign if it points down. The maps may differ in size: heights are
/// sampled at the normals' texel centres.
pub fn detect(height: &HeightMap, normals: &NormalMap) -> Detection {
    let (mut along_u, mut along_v) = (Correlation::default(), Correlation::default());
    let (du, dv) = (1.0 / f64::from(normals.width), 1.0 / f64::from(normals.height));
    let width = normals.width as usize;
    for (row, normals) in normals.normals.chunks_exact(width.max(1)).enumerate() {
        let v = (row as f64 + 0.5) * dv;
        for (column, &[x, y, _]) in normals.iter().enumerate() {
            let u = (column as f64 + 0.5) * du;
            along_u.add(-f64::from(x), height.height_at(u + du, v) - height.height_at(u - du, v));
            along_v.add(f64::from(y), height.height_at(u, v + dv) - height.height_at(u, v - dv));
        }
    }
    let (u, v) = (along_u.value(), along_v.value());
    Detection {
        convention: if u < 0.0 { Convention::Depth } else { Convention::Height },
        convention_confidence: u.abs(),
        green: if u * v < 0.0 { GreenSign::MinusY } else { GreenSign::PlusY },
        green_confidence: u.abs().min(v.abs()),
    }
}

/// Convention guessed from a file's name.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Guess {
    /// Whether white is high or deep.
    pub convention: Convention,
    /// Share of such guesses that are right, from 0 to 1.
    pub confidence: f64,
}

/// Words of depth maps in file names.
const DEPTH_WORDS: [&str; 2] = ["depth", "depthmap"];

/// Words of height maps in file names, beside the words for textures of this role.
const HEIGHT_WORDS: [&str; 8] = ["h", "elevation", "dem", "dsm", "dtm", "topology", "topo", "terrain"];

/// Guesses from a word of a file name. The words were checked with maps of other projects whose
/// convention is known: all three that were named as depths are depths, and five of six named as
/// heights are heights. For samples this small the confidence is `(n + 1) / (m + 2)`, if `n` of `m`
/// are right.
fn guess_by_word(word: &str) -> Option<Guess> {
    if DEPTH_WORDS.contains(&word) {
        Some(Guess { convention: Convention::Depth, confidence: 0.8 })
    } else if HEIGHT_WORDS.contains(&word) || is_height_word(word) {
        Some(Guess { convention: Convention::Height, confidence: 0.75 })
    } else {
        None
    }
}

/// Guesses a height map's convention from its file name. None for most names.
///
/// The texels give no hint. In nine maps whose convention is known, guesses by the skewness of the
/// values, or of their curvature at any scale, were no better than chance.
pub fn guess_by_name(path: &Path) -> Option<Guess> {
    let stem = path.file_stem()?.to_string_lossy().to_ascii_lowercase();
    let mut words = stem.split(|sign: char| !sign.is_ascii_alphabetic());
    words.find_map(guess_by_word)
}

/// Pearson's correlation, from sums of values whose means are near 0.
#[derive(Default)]
struct Correlation {
    count: f64,
    sum: [f64; 2],
    squares: [f64; 2],
    product: f64,
}

impl Correlation {
    fn add(&mut self, a: f64, b: f64) {
        self.count += 1.0;
        self.sum = [self.sum[0] + a, self.sum[1] + b];
        self.squares = [self.squares[0] + a * a, self.squares[1] + b * b];
        self.product += a * b;
    }

    /// Correlation in `[-1, 1]`; 0 if either side is constant.
    fn value(&self) -> f64 {
        let mean = self.sum.map(|sum| sum / self.count);
        let variance = [0, 1].map(|i| self.squares[i] / self.count - mean[i] * mean[i]);
        let covariance = self.product / self.count - mean[0] * mean[1];
        // Below this a variance is rounding of constant slopes.
        const LEAST: f64 = 1e-20;
        if variance.iter().all(|&variance| variance > LEAST) {
            (covariance / (variance[0] * variance[1]).sqrt()).clamp(-1.0, 1.0)
        } else {
            0.0
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn maps_are_recognised_by_file_names() {
        let of = |name: &str| guess_by_name(Path::new(name)).map(|guess| guess.convention);
        for depth in ["bevy_cube_depth.png", "maps/Wool-Depth.PNG", "depth.exr"] {
            assert_eq!(of(depth), Some(Convention::Depth), "{depth}");
        }
        for height in
            ["canyon_height.jpg", "rock023_alb_ht.png", "dem.tif", "a-h.png", "wall displacement 4k.exr"]
        {
            assert_eq!(of(height), Some(Convention::Height), "{height}");
        }
        for neither in ["wall.png", "depths_of_the_sea.png", "hill.png", "", ".."] {
            assert_eq!(of(neither), None, "{neither}");
        }
    }
}
