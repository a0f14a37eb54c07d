//! Height or depth, green up or down: what a height map and the normal map that belongs to it say of each
//! other.

use std::path::Path;

use relief_core::HeightMap;

use crate::{Convention, GreenSign, NormalMap};

/// The conventions under which a pair of maps agrees best.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Detection {
    /// Whether white is high or deep in the height map as it was read.
    pub convention: Convention,
    /// How sure that is: the size of the correlation along `u`, from 0 (nothing to see) to 1.
    pub convention_confidence: f64,
    /// Which way green pointed in the normal map's file, if it was read as [`GreenSign::PlusY`].
    pub green: GreenSign,
    /// How sure that is: the lesser of the correlations along `u` and `v`, from 0 to 1, since both signs
    /// decide it.
    pub green_confidence: f64,
}

/// Compares the slopes of a normal map, read as [`GreenSign::PlusY`], with the gradient of a height map, read
/// as [`Convention::Height`].
///
/// The normal of a height field leans against its slope: `x` falls with `∂h/∂u`, and `y`, which points along
/// falling `v`, rises with `∂h/∂v`. The correlation of `-x` with `∂h/∂u` is positive for heights and negative
/// for depths; that of `y` with `∂h/∂v` has the same sign if green points up and the other if it points down.
/// The sizes of the maps may differ: heights are taken at the normals' texel centres.
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

/// A convention that is no more than likely.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Guess {
    /// Whether white is high or deep.
    pub convention: Convention,
    /// How often such a guess is right, from 0 to 1.
    pub confidence: f64,
}

/// Words of names, what they say, and how often they were right: of maps of other projects whose convention
/// is known, all three named as depths are, and five of six named as heights. Of so few, `n` right ones of
/// `m` make `(n + 1) / (m + 2)`.
const WORDS: [(&[&str], Guess); 2] = [
    (&["depth", "depthmap"], Guess { convention: Convention::Depth, confidence: 0.8 }),
    (
        &[
            "height",
            "heights",
            "heightmap",
            "ht",
            "h",
            "displacement",
            "disp",
            "bump",
            "elevation",
            "dem",
            "dsm",
            "dtm",
            "topology",
            "topo",
            "terrain",
        ],
        Guess { convention: Convention::Height, confidence: 0.75 },
    ),
];

/// What a height map's name says of its convention; nothing of most.
///
/// Its texels say nothing: of nine maps whose convention is known, neither the skewness of the values nor
/// that of their curvature, at any scale, told depths from heights better than chance.
pub fn guess_by_name(path: &Path) -> Option<Guess> {
    let stem = path.file_stem()?.to_string_lossy().to_ascii_lowercase();
    let mut words = stem.split(|sign: char| !sign.is_ascii_alphabetic());
    words.find_map(|word| WORDS.iter().find(|(words, _)| words.contains(&word)).map(|(_, guess)| *guess))
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

    /// In `[-1, 1]`; 0 where one of both is constant.
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
    fn names_that_say_something_are_understood() {
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
