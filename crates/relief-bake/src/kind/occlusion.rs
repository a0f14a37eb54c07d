//! Ambient occlusion, from horizons in closed form.
//!
//! Zhukov, Iones and Kronin 1998, *An ambient light illumination model*; over a height field it
//! needs only the horizons of Max 1988. Timonen and Westerholm 2010.
//!
//! # What is stored
//!
//! The map holds the visibility `1 - mean(sin² H)` in `[0, 1]` over the azimuths, `H` the elevation
//! of the [`horizon`](super::horizon). It is the part of a uniform sky's light that reaches a plane
//! parallel to the base at the texel: the cosine-weighted open part of the hemisphere about the
//! *base* normal, `1/π ∫ V cos θ dω`. The sky of one azimuth above the horizon contributes
//! `∫ from H to π/2 of sin e cos e de = cos² H / 2`. The relief's own normal plays no part.
//!
//! # Accuracy
//!
//! The map is exact in elevation, for the horizons given. Between azimuths the mean is the
//! rectangle rule, which for 16 azimuths leaves about a hundredth on rough ground. An error `ε` of
//! a horizon, in radians, moves the visibility by at most `ε`, since
//! `|d sin² H / dH| = |sin 2H| <= 1`.

use relief_core::registry::Publication;
use relief_core::{Cancelled, HeightMap, Metric, Rounding, Watch};

use super::{BITS_TO_NEAREST, Kind, Reach, to_nearest};
use crate::azimuths::{AZIMUTHS, TILES, texture};
use crate::horizon_sweep::Sweep;
use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink};

/// The kind `occlusion`.
pub const KIND: Kind = Kind {
    name: "occlusion",
    summary: "the part of the sky's light that reaches a texel, about the base normal",
    revision: 2,
    publication: Publication {
        paper: "Zhukov, Iones and Kronin 1998; Timonen and Westerholm 2010",
        section: "",
    },
    params: &[AZIMUTHS, TILES, BITS_TO_NEAREST],
    guarantee: "closed form of the horizons, off by at most their mean error in radians and the part between \
                azimuths",
    is_picture: true,
    of_volume: false,
    shapes: |size, _| vec![Shape::slices("", size, 1, 1)],
    reach: |_| Reach::Everything,
    working_maps: |_| super::WORKING_MAPS,
    bake,
};

/// Returns the visibility of the sky at every texel, from 0 to 1, row by row from the top.
/// Parameters are the ones of [`horizons`](super::horizon::horizons). The working set besides input
/// and result is a quarter of the map; each thread takes 16 lines of the map with their reach, and
/// 50 of its rows.
///
/// # Errors
///
/// When the bake is cancelled.
pub fn visibility(
    map: &HeightMap,
    metric: Metric,
    azimuths: u32,
    tiles: u32,
    watch: &Watch,
) -> Result<Vec<f32>, Cancelled> {
    let part = 1.0 / azimuths as f32;
    let mut sweep = Sweep::new(map, metric, azimuths, tiles);
    let mut hidden = vec![0.0f32; map.texels().len()];
    for azimuth in 0..azimuths {
        sweep.azimuth(azimuth, [&mut hidden], watch, |[hidden], sines| {
            hidden.iter_mut().zip(sines).for_each(|(hidden, sine)| *hidden += sine * sine);
        })?;
    }
    hidden.iter_mut().for_each(|texel| *texel = (1.0 - *texel * part).clamp(0.0, 1.0));
    Ok(hidden)
}

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let (azimuths, tiles, bits) = (settings.count(0), settings.count(1), settings.count(2));
    let mut open = visibility(source.map, source.metric, azimuths, tiles, watch)?;
    let channels =
        [Channel { name: "visibility", unit: "1", range: [0.0, 1.0], rounding: Rounding::Nearest }];
    sink.begin(&texture(source, azimuths, 1, channels.to_vec()))?;
    Ok(to_nearest(sink, &channels, bits, &mut [&mut open])?)
}
