//! Normals and albedo, pixel by pixel.

use rayon::prelude::*;
use relief_core::{Cancelled, HeightMap, HeightMapError, Watch};

use crate::fill;
use crate::kind::normal::{Axes, Planes};

/// Least determinant of the lights' second moments, as a part of its value for three lights at
/// right angles. With it, noise is amplified fifty times at most. A smaller limit would amplify
/// more; a larger one would give up pixels that few lights reach.
const SPREAD: f64 = 1e-3;

/// Rows that a thread solves together.
const ROWS: usize = 4;

/// A photograph and its light.
#[derive(Clone, Copy, Debug)]
pub struct Photo<'a> {
    /// Brightness of each pixel, row by row from the top, linear (not sRGB), 0 for black.
    pub pixels: &'a [f32],
    /// Direction to the light: right in the picture, up in the picture, towards the camera. Of any
    /// length.
    pub to_light: [f64; 3],
    /// Brightness of a white surface that faces the light.
    pub intensity: f64,
}

/// Thresholds of the samples that are used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exposure {
    /// Samples at or below it are in shadow.
    pub shadow: f32,
    /// Samples at or above it are overexposed.
    pub overexposed: f32,
}

/// Normals and albedo found in photographs.
#[derive(Clone, Debug, PartialEq)]
pub struct Photometry {
    /// Unit normals in tangent space ([`Axes::Tangent`]: green up), in planes of `x`, `y` and `z`.
    pub normals: Planes,
    /// Share of the light that is reflected, from 0; 1 is white.
    pub albedo: Vec<f32>,
    /// Whether the pixel was seen under enough lights; the others are filled in.
    pub known: Vec<bool>,
    /// Root mean square of the differences between brightness and fit, over all samples used.
    pub misfit: f64,
}

/// Reason why photographs give no normals.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PhotometricError {
    /// The size is invalid for a height map.
    #[error(transparent)]
    Size(#[from] HeightMapError),
    /// Fewer than three photographs.
    #[error("three or more photographs are needed, {0} were given")]
    TooFew(usize),
    /// A photograph has another size.
    #[error("photograph {photo} has {given} pixels, {width}x{height} are needed")]
    WrongLength {
        /// Number of the photograph, from 0.
        photo: usize,
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
        /// Pixels given.
        given: usize,
    },
    /// A pixel is NaN, infinite or negative.
    #[error(
        "photograph {photo}, pixel ({column}, {row}) is {value}: brightness must be finite and not negative"
    )]
    BadPixel {
        /// Number of the photograph, from 0.
        photo: usize,
        /// Column of the first such pixel.
        column: u32,
        /// Row of the first such pixel.
        row: u32,
        /// Value of that pixel.
        value: f32,
    },
    /// A light has no direction, or its intensity is not positive.
    #[error("the light of photograph {0} needs a finite direction and a positive intensity")]
    BadLight(usize),
    /// All lights lie nearly in one plane with the surface.
    #[error("the lights are too close to one plane to tell normals apart: spread their directions")]
    LightsInAPlane,
    /// No pixel was seen under enough lights.
    #[error(
        "no pixel is lit in three photographs whose lights are well spread: check the exposure's thresholds"
    )]
    NothingKnown,
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Least-squares fit of a pixel's samples.
struct Fit {
    /// Normal times albedo.
    g: [f64; 3],
    /// Sum of squared differences to the samples used, and their number.
    misfit: [f64; 2],
}

/// Finds normals and albedo from at least three photographs.
///
/// # Errors
///
/// Fails when there are too few photographs or known pixels, when sizes, pixels or lights are
/// wrong, or when it is cancelled.
pub fn normals_from_photos(
    size: [u32; 2],
    photos: &[Photo],
    exposure: Exposure,
    watch: &Watch,
) -> Result<Photometry, PhotometricError> {
    let lights = check(size, photos)?;
    let width = size[0] as usize;
    let texels = photos[0].pixels.len();
    // Slope along u, slope along v, albedo.
    let mut planes = [0; 3].map(|_| vec![0.0f32; texels]);
    let mut known = vec![false; texels];
    let [along_u, along_v, albedo] = &mut planes;
    let chunk = width * ROWS;
    let blocks = texels.div_ceil(chunk) as f32;
    let misfits: Vec<[f64; 2]> = along_u
        .par_chunks_mut(chunk)
        .zip(along_v.par_chunks_mut(chunk))
        .zip(albedo.par_chunks_mut(chunk))
        .zip(known.par_chunks_mut(chunk))
        .enumerate()
        .map_init(
            || Vec::with_capacity(photos.len()),
            |samples, (block, (((along_u, along_v), albedo), known))| {
                watch.piece(0.0, 0.9).at(block as f32 / blocks)?;
                let mut misfit = [0.0; 2];
                for at in 0..known.len() {
                    samples.clear();
                    for (photo, &light) in photos.iter().zip(&lights) {
                        let value = photo.pixels[block * chunk + at];
                        if value > exposure.shadow && value < exposure.overexposed {
                            samples.push((light, f64::from(value)));
                        }
                    }
                    let Some(Fit { g, misfit: [sum, count] }) = fit_lit(samples) else { continue };
                    misfit = [misfit[0] + sum, misfit[1] + count];
                    known[at] = true;
                    albedo[at] = g.iter().map(|x| x * x).sum::<f64>().sqrt() as f32;
                    along_u[at] = (-g[0] / g[2]) as f32;
                    along_v[at] = (g[1] / g[2]) as f32;
                }
                Ok(misfit)
            },
        )
        .collect::<Result<_, Cancelled>>()?;
    if !known.contains(&true) {
        return Err(PhotometricError::NothingKnown);
    }
    for (part, plane) in planes.iter_mut().enumerate() {
        watch.at(0.9 + 0.03 * part as f32)?;
        fill::fill(size.map(|side| side as usize), plane, &known);
    }
    let [mut x, mut y, albedo] = planes;
    let mut z = vec![0.0; texels];
    for ((x, y), z) in x.iter_mut().zip(&mut y).zip(&mut z) {
        [*x, *y, *z] = Axes::Tangent.normal([*x, *y]);
    }
    let [sum, count] = misfits.iter().fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d]);
    Ok(Photometry { normals: [x, y, z], albedo, known, misfit: (sum / count).sqrt() })
}

/// Checks that lights, given as direction and intensity, determine normals. Needs no photographs.
///
/// # Errors
///
/// Fails for fewer than three lights, for a light without direction or positive intensity, and for
/// lights all near one plane.
pub fn check_lights(lights: &[([f64; 3], f64)]) -> Result<(), PhotometricError> {
    scaled(lights).map(|_| ())
}

/// Returns the unit vectors to the lights times their intensities.
fn scaled(lights: &[([f64; 3], f64)]) -> Result<Vec<[f64; 3]>, PhotometricError> {
    if lights.len() < 3 {
        return Err(PhotometricError::TooFew(lights.len()));
    }
    let mut scaled = Vec::with_capacity(lights.len());
    for (photo, (to_light, intensity)) in lights.iter().enumerate() {
        let length = to_light.iter().map(|x| x * x).sum::<f64>().sqrt();
        if !(length.is_normal() && intensity.is_normal() && *intensity > 0.0) {
            return Err(PhotometricError::BadLight(photo));
        }
        scaled.push(to_light.map(|x| x / length * intensity));
    }
    let samples: Vec<_> = scaled.iter().map(|&light| (light, 1.0)).collect();
    if fit(&samples).is_none() { Err(PhotometricError::LightsInAPlane) } else { Ok(scaled) }
}

/// Checks that photographs fit together, and returns their lights.
fn check(size: [u32; 2], photos: &[Photo]) -> Result<Vec<[f64; 3]>, PhotometricError> {
    let [width, height] = size;
    HeightMap::check_size(width, height)?;
    let lights: Vec<_> = photos.iter().map(|photo| (photo.to_light, photo.intensity)).collect();
    let lights = scaled(&lights)?;
    for (photo, Photo { pixels, .. }) in photos.iter().enumerate() {
        let given = pixels.len();
        if given as u64 != u64::from(width) * u64::from(height) {
            return Err(PhotometricError::WrongLength { photo, width, height, given });
        }
        if let Some(at) = pixels.iter().position(|value| !(value.is_finite() && *value >= 0.0)) {
            let (column, row) = ((at % width as usize) as u32, (at / width as usize) as u32);
            return Err(PhotometricError::BadPixel { photo, column, row, value: pixels[at] });
        }
    }
    Ok(lights)
}

/// Fits without samples whose lights the normal is turned away from. `None` when too few remain, or
/// when no relief has such a normal.
fn fit_lit(samples: &mut Vec<([f64; 3], f64)>) -> Option<Fit> {
    loop {
        let fit = fit(samples)?;
        let before = samples.len();
        samples.retain(|(light, _)| dot(*light, fit.g) > 0.0);
        if samples.len() == before {
            return (fit.g[2] > 0.0).then_some(fit);
        }
    }
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Returns the `g` with the least sum of `(l · g - I)²` over samples `(l, I)`; `None` when the
/// lights are too near one plane.
fn fit(samples: &[([f64; 3], f64)]) -> Option<Fit> {
    if samples.len() < 3 {
        return None;
    }
    let (mut rows, mut right) = ([[0.0; 3]; 3], [0.0; 3]);
    for (light, value) in samples {
        for axis in 0..3 {
            right[axis] += light[axis] * value;
            for other in 0..3 {
                rows[axis][other] += light[axis] * light[other];
            }
        }
    }
    let minors = [cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])];
    let determinant = dot(rows[0], minors[0]);
    let mean = (rows[0][0] + rows[1][1] + rows[2][2]) / 3.0;
    if determinant.is_nan() || determinant < SPREAD * mean.powi(3) {
        return None;
    }
    // The matrix is symmetric, so its adjugate has these rows.
    let g = minors.map(|minor| dot(minor, right) / determinant);
    let misfit = samples.iter().map(|&(light, value)| (dot(light, g) - value).powi(2)).sum();
    Some(Fit { g, misfit: [misfit, samples.len() as f64] })
}
