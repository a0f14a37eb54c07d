//! Environment maps: light from far away, different in every direction.

mod cube;
mod lobes;
mod sky;
mod sphere;

use std::sync::{Arc, OnceLock};

use relief_core::encoding::code::Codes;
use relief_core::{BakedMap, MapFormat, MapIdentity, MapLayout, MapTexels};
use relief_io::Picture;

use self::sphere::Sphere;

/// Side in texels of a face in the last level, which holds the light that diffuse surfaces scatter.
/// This light is smooth: between texels its error is below a hundredth.
const LAST_SIDE: u32 = 16;

/// Largest side of a face in texels: a fifth of a degree each.
const MOST_SIDE: u32 = 512;

/// Environment map: the six faces of a cube, with mip levels that hold the light within ever wider
/// lobes.
///
/// Radiance has the unit of ambient light: a white surface in an environment of 1 shows 1.
/// Directions are in world space, `y` up. In the equirectangular picture the middle is seen along
/// `-z`, a quarter of the width to its right along `x`, and the upper row along `y`.
///
/// ```
/// # fn main() -> Result<(), relief_scene::environment::EnvironmentError> {
/// use relief_io::Picture;
/// use relief_scene::environment::Environment;
///
/// // A white sky above black ground.
/// let texel = |at: u32| if at < 64 * 16 { [1.0; 4] } else { [0.0; 4] };
/// let picture = Picture { width: 64, height: 32, texels: (0..64 * 32).map(texel).collect() };
/// let environment = Environment::from_equirectangular(&picture)?;
/// # let _ = environment;
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Environment {
    map: Arc<BakedMap>,
}

/// Reason why a picture is no environment map.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum EnvironmentError {
    /// The picture is not twice as wide as high.
    #[error(
        "the environment map has {width}x{height} texels: use an equirectangular picture, which is twice as \
         wide as high"
    )]
    Proportions {
        /// Width in texels.
        width: u32,
        /// Height in texels.
        height: u32,
    },
    /// A texel is NaN or infinite.
    #[error("the texel at ({column}, {row}) of the environment map is not finite: give it a finite colour")]
    NotFinite {
        /// Column of the texel, from 0.
        column: usize,
        /// Row of the texel, from 0.
        row: usize,
    },
    /// The number of texels does not match width and height.
    #[error("{given} texels are given for a picture of {width}x{height}: give as many as it has")]
    Length {
        /// Width in texels.
        width: u32,
        /// Height in texels.
        height: u32,
        /// Number of texels given.
        given: usize,
    },
}

impl Environment {
    /// Creates an environment map from an equirectangular picture in linear light, twice as wide as
    /// high. Colours below 0 count as 0. Opacity is ignored.
    ///
    /// # Errors
    ///
    /// When the picture has other proportions or the wrong number of texels, or a texel is not
    /// finite.
    pub fn from_equirectangular(picture: &Picture) -> Result<Self, EnvironmentError> {
        let Picture { width, height, ref texels } = *picture;
        if height == 0 || u64::from(width) != 2 * u64::from(height) {
            return Err(EnvironmentError::Proportions { width, height });
        }
        if texels.len() as u64 != u64::from(width) * u64::from(height) {
            return Err(EnvironmentError::Length { width, height, given: texels.len() });
        }
        if let Some(at) = texels.iter().position(|texel| !texel[..3].iter().all(|part| part.is_finite())) {
            let (column, row) = (at % width as usize, at / width as usize);
            return Err(EnvironmentError::NotFinite { column, row });
        }
        Ok(Self::of(&Sphere::of(picture)))
    }

    /// Returns a generated sky without a sun: blue, pale at the horizon, above brown ground. It is
    /// made once and shared.
    pub fn sky() -> Arc<Self> {
        static SKY: OnceLock<Arc<Environment>> = OnceLock::new();
        Arc::clone(SKY.get_or_init(|| Arc::new(Self::of(&Sphere::of(&sky::picture())))))
    }

    fn of(sphere: &Sphere) -> Self {
        let side = side_for(sphere.width());
        let levels = (side / LAST_SIDE).ilog2() + 1;
        let layout = MapLayout { size: [side, side], levels, layers: 6, channels: 4, format: MapFormat::F32 };
        let mut values = Vec::with_capacity((layout.texels() * 4) as usize);
        for level in 0..levels {
            let side = side >> level;
            // The width of a texel in the middle of a face.
            let width = 2.0 / f64::from(side);
            let texels = match level {
                0 => cube::faces(side, |toward| sphere.mean(toward, width)),
                _ => {
                    let source = sphere.level(4 * side);
                    cube::faces(side, |toward| lobes::light(source, toward, lobes::reach(side)))
                }
            };
            values.extend(texels.into_iter().flatten());
        }
        let identity = MapIdentity::without_heights("environment");
        let codes = [Codes { low: 0.0, step: 0.0 }; 4];
        let map = BakedMap::new(identity, layout, codes, MapTexels::F32(values));
        Self { map: Arc::new(map.expect("as many values as six faces in all levels have")) }
    }

    /// Returns the faces of the cube as the shaders read them: layers in the order `x`, `-x`, `y`,
    /// `-y`, `z`, `-z`, with the axes of cube maps on GPUs. The outer texels lie on the edges of
    /// the cube.
    pub fn map(&self) -> &Arc<BakedMap> {
        &self.map
    }

    /// Memory in bytes: for each texel of a picture while its environment map is made, and of the
    /// finished map at most.
    pub(crate) const BYTES: [u64; 2] = [Sphere::BYTES, 16 * 6 * 4 / 3 * (MOST_SIDE as u64).pow(2)];
}

/// Returns the side in texels of a face that is about as fine as a picture `width` columns wide.
fn side_for(width: u32) -> u32 {
    1 << (width / 4).clamp(2 * LAST_SIDE, MOST_SIDE).ilog2()
}

#[cfg(test)]
mod tests;
