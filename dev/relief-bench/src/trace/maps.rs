//! The maps that are traced.

use relief_core::{HeightMap, Wrap};
use relief_io::{HeightOptions, read_height};
use relief_testing::maps::fractal;
use relief_tests::accuracy::sample_maps;

use super::view::SCALE_M;

/// A map that is named in tables.
pub struct Subject {
    /// The name.
    pub name: &'static str,
    origin: Origin,
}

enum Origin {
    /// Fractal ground of that many texels a side.
    Ground(u32),
    /// A sample map of the project.
    Sample(&'static str),
}

/// All of them.
pub const SUBJECTS: &[Subject] = &[
    Subject { name: "ground512", origin: Origin::Ground(512) },
    Subject { name: "ground4096", origin: Origin::Ground(4096) },
    Subject { name: "cobbles", origin: Origin::Sample("cobbles.png") },
    Subject { name: "jacksboro", origin: Origin::Sample("jacksboro.png") },
];

/// Height of an octave as a multiple of the previous octave's, which is twice as coarse. Above a half,
/// slopes grow with resolution, as on natural ground.
const ROUGHNESS: f32 = 0.55;

impl Subject {
    /// The map, with heights that are multiples of 1/65535: what a 16-bit picture holds, and so what every
    /// program sees.
    pub fn map(&self) -> Result<HeightMap, String> {
        let map = match self.origin {
            Origin::Ground(side) => {
                HeightMap::new(side, side, fractal(11, side, side, ROUGHNESS), Wrap::Clamp)
                    .map_err(|error| error.to_string())?
            }
            Origin::Sample(file) => {
                let options = HeightOptions { wrap: Some(Wrap::Clamp), ..HeightOptions::default() };
                read_height(&sample_maps().join(file), &options).map_err(|error| error.to_string())?
            }
        };
        let texels = levels(&map).map(|level| f32::from(level) / f32::from(u16::MAX)).collect();
        HeightMap::new(map.width(), map.height(), texels, Wrap::Clamp)
            .and_then(|map| map.with_displacement(SCALE_M, 0.0))
            .map_err(|error| error.to_string())
    }
}

/// The texels in 65536 levels.
pub fn levels(map: &HeightMap) -> impl Iterator<Item = u16> + '_ {
    map.texels().iter().map(|texel| (texel * f32::from(u16::MAX)).round() as u16)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_and_texels_are_the_same_heights() {
        let map = SUBJECTS[2].map().expect("a sample map");
        let again: Vec<f32> = levels(&map).map(|level| f32::from(level) / 65535.0).collect();
        assert_eq!(map.texels(), again);
    }
}
