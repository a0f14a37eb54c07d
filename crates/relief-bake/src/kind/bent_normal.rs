//! Bent normals, from horizons in closed form.
//!
//! Landis 2002, *Production-ready global illumination*; the integrals over horizons as in Max 1988
//! and Timonen and Westerholm 2010.
//!
//! # What is stored
//!
//! The map holds the mean of all directions in which the sky is seen, each weighted by the same
//! solid angle, as a unit vector in tangent space. `x` points along `+u`, `y` along `-v` (up in the
//! picture, as in glTF's normal maps), `z` along the base normal. Channels have the range
//! `[-1, 1]`. Where no sky is seen it is the base normal. The sky of the azimuth `φ` above the
//! horizon `H` adds
//!
//! * along the base, in the direction of `φ`:
//!   `∫ from H to π/2 of cos² e de = (π/2 - H - sin H cos H) / 2`,
//! * upward: `∫ from H to π/2 of sin e cos e de = cos² H / 2`.
//!
//! With `scaled`, the map holds the integral over π instead of a unit vector. Its `z` is the
//! [`occlusion`](super::occlusion). Its product with the relief's normal is the part of a uniform
//! sky's light that arrives there, if all visible sky lies before that normal.
//!
//! # Accuracy
//!
//! The map is exact in elevation, for the horizons given, and uses the rectangle rule between
//! azimuths. Because the azimuths are spread evenly, an open plain has exactly the base normal.

use rayon::prelude::*;
use relief_core::registry::{Param, Publication};
use relief_core::{Cancelled, HeightMap, Metric, Rounding, Watch};

use super::{BITS_TO_NEAREST, Kind, Reach, to_nearest};
use crate::azimuths::{AZIMUTHS, TILES, texture, unit_vector};
use crate::horizon_sweep::Sweep;
use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink};

/// The kind `bent-normal`.
pub const KIND: Kind = Kind {
    name: "bent-normal",
    summary: "the mean direction in which a texel sees the sky",
    revision: 2,
    publication: Publication { paper: "Landis 2002; Timonen and Westerholm 2010", section: "" },
    params: &[AZIMUTHS, TILES, BITS_TO_NEAREST, SCALED],
    guarantee: "closed form of the horizons, about the base normal",
    is_picture: true,
    of_volume: false,
    shapes: |size, _| vec![Shape::slices("", size, 1, 3)],
    reach: |_| Reach::Everything,
    working_maps: |_| super::WORKING_MAPS,
    bake,
};

/// Index of the parameter `scaled`.
const SCALED_PLACE: usize = 3;

const SCALED: Param = Param {
    name: "scaled",
    summary: "1: as long as the part of the sky that is seen; 0: unit vectors",
    unit: "",
    min: 0.0,
    max: 1.0,
    default: 0.0,
    integer: true,
    names: &[],
};

/// Returns the bent normal of every texel as three planes, row by row from the top: along `+u`,
/// along `-v`, up. Parameters, and the working set besides input and result, are the ones of
/// [`super::occlusion::visibility`].
///
/// # Errors
///
/// When the bake is cancelled.
pub fn bent_normals(
    map: &HeightMap,
    metric: Metric,
    azimuths: u32,
    tiles: u32,
    watch: &Watch,
) -> Result<[Vec<f32>; 3], Cancelled> {
    let mut planes = sums(map, metric, azimuths, tiles, watch)?;
    let [x, y, z] = &mut planes;
    x.par_iter_mut().zip(y).zip(z).for_each(|((x, y), z)| [*x, *y, *z] = unit([*x, *y, *z]));
    Ok(planes)
}

/// Returns the integral over π of the visible sky's directions at every texel, in the planes of
/// [`bent_normals`]. Its length measures the visible part of the sky.
///
/// # Errors
///
/// When the bake is cancelled.
pub fn skies(
    map: &HeightMap,
    metric: Metric,
    azimuths: u32,
    tiles: u32,
    watch: &Watch,
) -> Result<[Vec<f32>; 3], Cancelled> {
    let mut planes = sums(map, metric, azimuths, tiles, watch)?;
    let part = 1.0 / azimuths as f32;
    planes.iter_mut().for_each(|plane| plane.par_iter_mut().for_each(|value| *value *= part));
    Ok(planes)
}

/// Returns the sums of the azimuths' integrals.
fn sums(
    map: &HeightMap,
    metric: Metric,
    azimuths: u32,
    tiles: u32,
    watch: &Watch,
) -> Result<[Vec<f32>; 3], Cancelled> {
    let mut sweep = Sweep::new(map, metric, azimuths, tiles);
    let mut planes = [0; 3].map(|_| vec![0.0f32; map.texels().len()]);
    for azimuth in 0..azimuths {
        let [cos, sin] = unit_vector(azimuth, azimuths).map(|x| x as f32);
        let sums = planes.each_mut().map(Vec::as_mut_slice);
        sweep.azimuth(azimuth, sums, watch, |[x, y, z], sines| {
            for (((x, y), z), &sine) in x.iter_mut().zip(y).zip(z).zip(sines) {
                let open = 1.0 - sine * sine;
                let aside = std::f32::consts::FRAC_PI_2 - sine.min(1.0).asin() - sine * open.max(0.0).sqrt();
                *x += cos * aside;
                *y -= sin * aside;
                *z += open;
            }
        })?;
    }
    Ok(planes)
}

/// Normalises a vector; up where it has no length.
fn unit([x, y, z]: [f32; 3]) -> [f32; 3] {
    let length = (x * x + y * y + z * z).sqrt();
    if length > 0.0 { [x / length, y / length, z / length] } else { [0.0, 0.0, 1.0] }
}

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let (azimuths, tiles, bits) = (settings.count(0), settings.count(1), settings.count(2));
    let vectors = if settings.count(SCALED_PLACE) == 0 { bent_normals } else { skies };
    let mut planes = vectors(source.map, source.metric, azimuths, tiles, watch)?;
    let channels = ["x", "y", "z"].map(|name| Channel {
        name,
        unit: "1",
        range: [-1.0, 1.0],
        rounding: Rounding::Nearest,
    });
    sink.begin(&texture(source, azimuths, 1, channels.to_vec()))?;
    Ok(to_nearest(sink, &channels, bits, &mut planes.each_mut().map(Vec::as_mut_slice))?)
}
