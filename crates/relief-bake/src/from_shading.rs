//! Heights from the shading of one photograph: a guess.
//!
//! Szirmay-Kalos and Umenhoffer 2008, section 2.2, name shape from shading as a source of height
//! maps; Zhang, Tsai, Cryer and Shah 1999, *Shape from Shading: A Survey*, compare its methods.
//!
//! One camera looks straight down at a matt (Lambertian) surface of one albedo under one known
//! distant light. A pixel's brightness is `albedo max(0, l · n)`. One number a pixel does not
//! determine a normal, which has two. Slopes across the light hardly change the brightness, and
//! some hollows look like hills. Of all heights the ones are sought that minimise a sum.
//!
//! A profile across the light is the same all along the light's direction, as a tilt to one side
//! is. It hardly shows, and the gentlest one is taken. If a map tiles, few profiles do so with it,
//! and its heights are nearer to the truth. Of other maps mainly the slopes towards the light are.
//!
//! # The sum
//!
//! * *Brightness*: the differences to the photograph. A pixel's model is the mean over the four
//!   quarters of its texel, whose slopes are the differences to the neighbours. Differences above
//!   0.1 count less than their square (pseudo-Huber), so shadows and gloss bend the heights less.
//!   An overexposed pixel may be brighter than it says. Turned away from the light is black.
//! * *Steepness*: 0.003 times the squares of the slopes. It decides the slopes that the brightness
//!   does not show.
//! * *Curvature*: 0.001 times the squared Laplacian, 1.5 times as much on each coarser level.
//!
//! Roughness smaller than a texel darkens it. The model's albedo is therefore halfway between the
//! given one and the one under which flat ground is as bright as the photograph's mean.
//!
//! # The minimum
//!
//! The sum is minimised from about 8² texels up, each level twice as fine and starting from the
//! heights of the previous one. On each level L-BFGS takes at most 40 steps. Its first metric is
//! the second derivative about flat ground, diagonal in the waves of
//! [`from_normals`](crate::from_normals). The minimum is a local one.
//!
//! Results are the same bits for any number of threads.

mod descent;
mod levels;
mod objective;

use relief_core::{Cancelled, HeightMap, HeightMapError, Watch, Wrap};

use self::objective::Objective;

/// Memory in bytes that a texel takes besides the photograph.
pub const BYTES_PER_TEXEL: u64 = 224;

/// Weight of the squared slopes.
const FLATNESS: f64 = 3e-3;

/// Weight of the squared Laplacian on the finest level, and its factor from level to level.
const SMOOTHNESS: [f64; 2] = [1e-3, 1.5];

/// Sides up to which a level is the coarsest.
const COARSEST: usize = 8;

/// Steps on each level.
const STEPS: u32 = 40;

/// Part of the pixels that are at most as bright as the estimated albedo.
const QUANTILE: f64 = 0.999;

/// Light, surface and map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shading {
    /// Direction to the light: right in the picture, up in the picture, towards the camera. Of any
    /// length; the last part is above 0.
    pub to_light: [f64; 3],
    /// Brightness of a surface that faces the light, above 0 and at most 1. If there is none, the
    /// larger of two is taken: the albedo under which flat ground is as bright as the photograph's
    /// mean, and the brightness that 99.9 % of the pixels do not exceed.
    pub albedo: Option<f64>,
    /// Brightness from which a pixel is overexposed.
    pub overexposed: f32,
    /// Size of a texel along `u` and `v` in metres.
    pub texel_m: [f64; 2],
    /// Continuation of the map beyond its edges.
    pub wrap: Wrap,
}

/// Heights guessed from shading.
#[derive(Clone, Debug, PartialEq)]
pub struct ShadedHeights {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Heights in metres, row by row from the top; their mean is 0.
    pub heights_m: Vec<f32>,
    /// Albedo, given or estimated.
    pub albedo: f64,
    /// Root mean square difference of the brightness between photograph and heights. Differences
    /// above 0.1 count less.
    pub misfit: f64,
    /// Overexposed pixels.
    pub overexposed: usize,
    /// Pixels brighter than the albedo by more than a hundredth: no slope explains them.
    pub too_bright: usize,
    /// Pixels at most a hundredth as bright as the albedo: turned away from the light, or in the
    /// shadow that something casts.
    pub dark: usize,
}

impl ShadedHeights {
    /// Returns the height map: its lowest texel is 0, its highest 1, and its displacement gives
    /// back the heights in metres. A level map has scale 0.
    ///
    /// # Errors
    ///
    /// When a height is not finite, or the size is invalid.
    pub fn to_map(&self, wrap: Wrap) -> Result<HeightMap, HeightMapError> {
        let (low, high) =
            self.heights_m.iter().fold((f32::MAX, f32::MIN), |(low, high), &h| (low.min(h), high.max(h)));
        let span = f64::from(high) - f64::from(low);
        let texel = |&h: &f32| if span > 0.0 { ((f64::from(h) - f64::from(low)) / span) as f32 } else { 0.0 };
        let texels = self.heights_m.iter().map(texel).collect();
        HeightMap::new(self.size[0], self.size[1], texels, wrap)?.with_displacement(span, f64::from(low))
    }
}

/// Reason why a photograph gives no heights.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FromShadingError {
    /// The size is invalid for a height map.
    #[error(transparent)]
    Size(#[from] HeightMapError),
    /// The photograph has another number of pixels.
    #[error("{given} pixels were given, {width}x{height} are needed")]
    WrongLength {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
        /// Pixels given.
        given: usize,
    },
    /// A pixel is NaN, infinite or negative.
    #[error("pixel ({column}, {row}) is {value}: brightness must be finite and not negative")]
    BadPixel {
        /// Column of the first such pixel.
        column: u32,
        /// Row of the first such pixel.
        row: u32,
        /// Value of that pixel.
        value: f32,
    },
    /// The light has no direction.
    #[error("the light needs a direction of finite numbers that are not all 0")]
    NoDirection,
    /// The light is below the surface or along it.
    #[error(
        "the light is not above the surface: its third number, towards the camera, is {0} of its length and \
         must be above 0.01"
    )]
    BelowHorizon(f64),
    /// The albedo is out of range.
    #[error("the albedo is {0}: it must be above 0 and at most 1")]
    BadAlbedo(f64),
    /// The size of a texel is out of range.
    #[error("a texel of {0} m x {1} m cannot be used: sides are from 1e-12 to 1e9 m")]
    BadTexel(f64, f64),
    /// All pixels are black.
    #[error("no pixel is lit: all are black")]
    NothingLit,
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl Shading {
    /// Checks the numbers. Needs no photograph.
    ///
    /// # Errors
    ///
    /// Fails for a light without a direction or not above the surface, and for an albedo or a
    /// texel out of range.
    pub fn check(&self) -> Result<(), FromShadingError> {
        self.unit_light()?;
        if let Some(albedo) = self.albedo.filter(|albedo| !(*albedo > 0.0 && *albedo <= 1.0)) {
            return Err(FromShadingError::BadAlbedo(albedo));
        }
        if !self.texel_m.iter().all(|side| (1e-12..=1e9).contains(side)) {
            return Err(FromShadingError::BadTexel(self.texel_m[0], self.texel_m[1]));
        }
        Ok(())
    }

    /// Returns the unit vector to the light: right, up, towards the camera.
    fn unit_light(&self) -> Result<[f64; 3], FromShadingError> {
        let largest = self.to_light.iter().fold(0.0f64, |largest, x| largest.max(x.abs()));
        if !largest.is_normal() || !self.to_light.iter().all(|x| x.is_finite()) {
            return Err(FromShadingError::NoDirection);
        }
        let scaled = self.to_light.map(|x| x / largest);
        let length = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
        let unit = scaled.map(|x| x / length);
        if unit[2] <= 0.01 {
            return Err(FromShadingError::BelowHorizon(unit[2]));
        }
        Ok(unit)
    }
}

/// Guesses heights from the brightness of a photograph: linear (not sRGB), row by row from the top,
/// 0 for black, 1 for a white surface that faces the light. Takes [`BYTES_PER_TEXEL`].
///
/// # Errors
///
/// When size, pixels, light, albedo or texels are wrong, when all is black, or when it is
/// cancelled.
pub fn heights_from_shading(
    size: [u32; 2],
    brightness: &[f32],
    how: &Shading,
    watch: &Watch,
) -> Result<ShadedHeights, FromShadingError> {
    let [width, height] = size;
    HeightMap::check_size(width, height)?;
    how.check()?;
    let [right, up, front] = how.unit_light()?;
    if brightness.len() as u64 != u64::from(width) * u64::from(height) {
        return Err(FromShadingError::WrongLength { width, height, given: brightness.len() });
    }
    if let Some(at) = brightness.iter().position(|value| !(value.is_finite() && *value >= 0.0)) {
        let [column, row] = [at % width as usize, at / width as usize].map(|at| at as u32);
        return Err(FromShadingError::BadPixel { column, row, value: brightness[at] });
    }
    let mean = brightness.iter().map(|&value| f64::from(value)).sum::<f64>() / brightness.len() as f64;
    if mean == 0.0 {
        return Err(FromShadingError::NothingLit);
    }
    watch.at(0.0)?;
    let flat = mean / front;
    let albedo = how.albedo.unwrap_or_else(|| flat.max(quantile(brightness)));
    let wanted = Wanted {
        to_light: [right, -up, front],
        albedo: 0.5 * (albedo + flat),
        how,
        sides: size.map(|side| side as usize),
    };
    let (mut heights, misfit) = wanted.coarse_to_fine(brightness, watch)?;
    // The light's sum is the same for heights that are moved up or down.
    let middle = heights.iter().sum::<f64>() / heights.len() as f64;
    let unit = how.texel_m[0];
    let heights_m = heights.drain(..).map(|h| ((h - middle) * unit) as f32).collect();
    let count = |is: &dyn Fn(f64) -> bool| brightness.iter().filter(|value| is(f64::from(**value))).count();
    Ok(ShadedHeights {
        size,
        heights_m,
        albedo,
        misfit,
        overexposed: count(&|value| value >= f64::from(how.overexposed)),
        too_bright: count(&|value| value > 1.01 * albedo),
        dark: count(&|value| value <= 0.01 * albedo),
    })
}

/// Returns the brightness that nearly all pixels do not exceed.
fn quantile(brightness: &[f32]) -> f64 {
    let mut sorted = brightness.to_vec();
    let at = ((sorted.len() as f64 * QUANTILE) as usize).min(sorted.len() - 1);
    f64::from(*sorted.select_nth_unstable_by(at, f32::total_cmp).1)
}

/// Heights that are wanted.
struct Wanted<'a> {
    /// Unit vector to the light: right, down, towards the camera.
    to_light: [f64; 3],
    /// Albedo of the model.
    albedo: f64,
    how: &'a Shading,
    sides: [usize; 2],
}

impl Wanted<'_> {
    /// Returns the heights in texels along `u`, and the misfit of the brightness.
    fn coarse_to_fine(&self, brightness: &[f32], watch: &Watch) -> Result<(Vec<f64>, f64), Cancelled> {
        let mut sizes = vec![self.sides];
        let mut coarser: Vec<Vec<f32>> = Vec::new();
        while let Some(&sides) = sizes.last().filter(|sides| sides.iter().any(|side| *side > COARSEST)) {
            let halves = sides.map(|side| side.div_ceil(2));
            let finer = coarser.last().map_or(brightness, Vec::as_slice);
            coarser.push(levels::averaged(finer, sides, halves));
            sizes.push(halves);
        }
        let mut heights = vec![0.0; sizes[sizes.len() - 1].iter().product()];
        for level in (0..sizes.len()).rev() {
            let sides = sizes[level];
            if let Some(&from) = sizes.get(level + 1) {
                let factor = sides[0] as f64 / from[0] as f64;
                heights = levels::refined(&heights, from, sides, self.how.wrap == Wrap::Repeat, factor);
            }
            let photo = if level == 0 { brightness } else { &coarser[level - 1] };
            let objective = self.objective(photo, sides, level);
            // Each level has four times the texels of the next one.
            let [from, to] = [level + 1, level].map(|level| 0.25f32.powi(level as i32));
            let from = if level + 1 == sizes.len() { 0.0 } else { from };
            descent::minimise(&objective, &mut heights, STEPS, &watch.piece(from, to))?;
        }
        let misfit = self.objective(brightness, self.sides, 0).misfit(&heights);
        Ok((heights, misfit))
    }

    fn objective<'a>(&self, brightness: &'a [f32], sides: [usize; 2], level: usize) -> Objective<'a> {
        let [u, v] = [0, 1].map(|axis| self.how.texel_m[axis] * self.sides[axis] as f64 / sides[axis] as f64);
        Objective {
            sides,
            wrap: self.how.wrap,
            texel: [1.0, v / u],
            to_light: self.to_light,
            albedo: self.albedo,
            brightness,
            overexposed: f64::from(self.how.overexposed),
            smoothness: SMOOTHNESS[0] * SMOOTHNESS[1].powi(level as i32),
            flatness: FLATNESS,
        }
    }
}
