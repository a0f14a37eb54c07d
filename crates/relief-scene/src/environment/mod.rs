//! Surroundings: light that comes from far away, another one from every direction.

mod cube;
mod lobes;
mod sky;
mod sphere;

use std::sync::{Arc, OnceLock};

use relief_core::encoding::code::Codes;
use relief_core::{BakedMap, MapFormat, MapIdentity, MapLayout, MapTexels};
use relief_io::Picture;

use self::sphere::Sphere;

/// Texels of a face's side in the last level, which holds what surfaces scatter: that is smooth, and between
/// texels it is wrong by less than a hundredth.
const LAST_SIDE: u32 = 16;

/// The most texels of a face's side: a fifth of a degree each.
const MOST_SIDE: u32 = 512;

/// Surroundings, ready to be lit by: the faces of a cube, in levels that hold the light of ever wider lobes.
///
/// Radiance is in the units of ambient light: a white surface in surroundings of 1 shows 1. Directions are
/// the world's, `y` up. In the picture of a whole sphere the middle is seen along `-z`, a quarter of
/// the width right of it along `x`, the upper row along `y`.
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

/// Why a picture shows no surroundings.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum EnvironmentError {
    /// It is not twice as wide as high.
    #[error(
        "{width}x{height} texels are no surroundings: a picture of a whole sphere is twice as wide as high"
    )]
    Proportions {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// A texel is NaN or infinite.
    #[error("the texel at ({column}, {row}) is not finite")]
    NotFinite {
        /// Its column.
        column: usize,
        /// Its row.
        row: usize,
    },
    /// There are not as many texels as the sides say.
    #[error("a picture of {width}x{height} texels was given {given} of them")]
    Length {
        /// Columns.
        width: u32,
        /// Rows.
        height: u32,
        /// Texels given.
        given: usize,
    },
}

impl Environment {
    /// Surroundings from an equirectangular picture in linear light, which is twice as wide as high. Colours
    /// below 0 count as 0; opacity does not count.
    ///
    /// # Errors
    ///
    /// When the picture has other proportions or too few texels, or one is not finite.
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

    /// A generated sky: blue, pale at the horizon, above brown ground, without a sun. It is made once.
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
            // As wide as a texel in the middle of a face.
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

    /// The faces of the cube as the shaders read them: as layers in the order `x`, `-x`, `y`, `-y`, `z`,
    /// `-z`, with the axes that cube maps of GPUs have; outer texels lie on the edges of the cube.
    pub fn map(&self) -> &Arc<BakedMap> {
        &self.map
    }

    /// What is taken for each texel of a picture while surroundings are made of it, and what is kept at most,
    /// in bytes.
    pub(crate) const BYTES: [u64; 2] = [Sphere::BYTES, 16 * 6 * 4 / 3 * (MOST_SIDE as u64).pow(2)];
}

/// Texels of a face's side for a picture so wide: about as fine.
fn side_for(width: u32) -> u32 {
    1 << (width / 4).clamp(2 * LAST_SIDE, MOST_SIDE).ilog2()
}

#[cfg(test)]
mod tests;
