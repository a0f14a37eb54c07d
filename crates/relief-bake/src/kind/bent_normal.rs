//! Bent normals, from horizons in closed form.
//!
//! Landis 2002, *Production-ready global illumination*; the integrals over horizons as in Max 1988 and Timonen and
//! Westerholm 2010.
//!
//! # What is stored
//!
//! The mean of all directions in which the sky is seen, each weighted by the same solid angle, as a unit vector in
//! tangent space: `x` along `+u`, `y` along `-v` (up in the picture, as in glTF's normal maps), `z` along the base
//! normal. Channels have the range `[-1, 1]`. Where no sky is seen it is the base normal. The sky of the azimuth `φ`
//! above the horizon `H` adds
//!
//! * along the base, in the direction of `φ`: `∫ from H to π/2 of cos² e de = (π/2 - H - sin H cos H) / 2`,
//! * upward: `∫ from H to π/2 of sin e cos e de = cos² H / 2`.
//!
//! # Accuracy
//!
//! Exact in elevation, for the horizons that it is given; the rectangle rule between azimuths. Because the azimuths
//! are spread evenly, an open plain has exactly the base normal.

use rayon::prelude::*;
use relief::HeightMap;
use relief::registry::Source as Publication;

use super::horizon::{self, horizons, unit_vector};
use super::{BITS, Kind, Reach};
use crate::quantise::unorm;
use crate::{BakeError, Channel, Metric, Progress, Rounding, Settings, Sink, Source, Texture};

/// The kind.
pub const KIND: Kind = Kind {
    name: "bent-normal",
    summary: "the mean direction in which a texel sees the sky",
    source: Publication { paper: "Landis 2002; Timonen and Westerholm 2010", section: "" },
    params: &[horizon::AZIMUTHS, horizon::TILES, BITS],
    guarantee: "closed form of the horizons, about the base normal",
    reach: |_| Reach::Everything,
    bake,
};

/// The bent normal of every texel, row by row from the top: along `+u`, along `-v`, up. Parameters are those of
/// [`horizons`]; the working set is that of [`horizons`] and the result.
///
/// # Errors
///
/// When the bake is cancelled.
pub fn bent_normals(
    map: &HeightMap,
    metric: Metric,
    azimuths: u32,
    tiles: u32,
    progress: &Progress,
) -> Result<Vec<[f32; 3]>, BakeError> {
    let mut sums = vec![[0.0f32; 3]; map.texels().len()];
    horizons(map, metric, azimuths, tiles, progress, &mut |azimuth, sines| {
        let [cos, sin] = unit_vector(azimuth, azimuths).map(|x| x as f32);
        sums.par_iter_mut().zip(sines).for_each(|(sum, &sine)| {
            let open = 1.0 - sine * sine;
            let aside = std::f32::consts::FRAC_PI_2 - sine.min(1.0).asin() - sine * open.max(0.0).sqrt();
            sum[0] += cos * aside;
            sum[1] -= sin * aside;
            sum[2] += open;
        });
        Ok(())
    })?;
    sums.iter_mut().for_each(|sum| *sum = unit(*sum));
    Ok(sums)
}

/// A vector of unit length, up where there is none.
fn unit([x, y, z]: [f32; 3]) -> [f32; 3] {
    let length = (x * x + y * y + z * z).sqrt();
    if length > 0.0 { [x / length, y / length, z / length] } else { [0.0, 0.0, 1.0] }
}

fn bake(
    source: &Source,
    settings: &Settings,
    progress: &Progress,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let (azimuths, tiles, bits) = (settings.count(0), settings.count(1), settings.count(2));
    let normals = bent_normals(source.map, source.metric, azimuths, tiles, progress)?;
    let channel = |name| Channel { name, range: [-1.0, 1.0], rounding: Rounding::Nearest };
    sink.begin(&Texture {
        name: "",
        size: [source.map.width(), source.map.height(), 1],
        mips: Vec::new(),
        channels: vec![channel("x"), channel("y"), channel("z")],
        notes: horizon::notes(source, azimuths),
    })?;
    let stored = |x: f32| {
        if bits == 0 { x } else { unorm(0.5 * x + 0.5, bits, Rounding::Nearest) * 2.0 - 1.0 }
    };
    let plane = |k: usize| normals.iter().map(|normal| stored(normal[k])).collect::<Vec<f32>>();
    let [x, y, z] = [0, 1, 2].map(plane);
    Ok(sink.slice(&[&x, &y, &z])?)
}
