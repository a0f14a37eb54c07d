//! Bounced light: the light that every texel receives of a uniform sky, directly and from other
//! texels.
//!
//! Heidrich, Daubert, Kautz and Seidel 2000, *Illuminating micro geometry based on precomputed
//! visibility*; Szirmay-Kalos and Umenhoffer 2008, section 6.2. Paths of light are chained through
//! the first hits of every texel in fixed directions (see [`visibility`]).
//!
//! # What is stored
//!
//! The map holds the irradiance about the base normal, over π times the sky's radiance, in
//! `[0, 1]`. With 0 bounces it is the visible part of the sky, as in
//! [`occlusion`](super::occlusion). Each bounce adds the light that other texels reflect, all with
//! the same albedo.
//!
//! # Accuracy
//!
//! The light is a mean over the directions; in each, the texel nearest to the first hit stands for
//! it. So no energy is made, and only the light of further bounces is lost: at most `albedo` to the
//! power of `bounces + 1`. In a white furnace, with an albedo of 1, the values rise to 1 with the
//! bounces.

use rayon::prelude::*;
use relief_core::registry::{Param, Publication};
use relief_core::{HeightMap, Metric, Rounding, Watch};

use super::visibility::{self, ELEVATIONS};
use super::{BITS_TO_NEAREST, Kind, Reach, to_nearest};
use crate::azimuths::{AZIMUTHS, texture};
use crate::{BakeError, BakeInput, Channel, Settings, Shape, Sink};

/// The kind `bounce`.
pub const KIND: Kind = Kind {
    name: "bounce",
    summary: "the sky's light that a texel receives, directly and reflected by other texels",
    revision: 1,
    publication: Publication {
        paper: "Heidrich et al. 2000; Szirmay-Kalos and Umenhoffer 2008",
        section: "6.2",
    },
    params: &[AZIMUTHS, ELEVATIONS, visibility::TILES, ALBEDO, BOUNCES, BITS_TO_NEAREST],
    guarantee: "a mean over fixed directions, exact hits: no light is made or lost",
    is_picture: true,
    of_volume: false,
    shapes: |size, _| vec![Shape::slices("", size, 1, 1)],
    reach: |_| Reach::Everything,
    working_maps: |settings| settings.count(1) as f32 + 4.5,
    bake,
};

/// Index of the parameter `albedo`.
const ALBEDO_PLACE: usize = 3;

const ALBEDO: Param = Param {
    name: "albedo",
    summary: "part of the light that every texel reflects",
    unit: "",
    min: 0.0,
    max: 1.0,
    default: 0.5,
    integer: false,
    names: &[],
};

const BOUNCES: Param = Param {
    name: "bounces",
    summary: "number of reflections of light",
    unit: "",
    min: 0.0,
    max: 256.0,
    default: 4.0,
    integer: true,
    names: &[],
};

/// Most rays of a bake, one for each texel, direction and bounce: several hours of work.
const MOST_RAYS: u64 = 1 << 36;

/// Returns the light that every texel receives, row by row from the top, from a sky of radiance 1
/// after `bounces` bounces off texels of `albedo`. `directions` are the azimuths and the elevations
/// of the rays, which are `tiles` tiles long.
///
/// The working set is the working set of [`visibility::views`] and two maps of `f32`. First hits
/// are computed again for each bounce, until a bounce changes no texel.
///
/// # Errors
///
/// When memory does not suffice, or the bake is cancelled.
pub fn light(
    map: &HeightMap,
    metric: Metric,
    directions: [u32; 2],
    tiles: u32,
    (albedo, bounces): (f32, u32),
    watch: &Watch,
) -> Result<Vec<f32>, BakeError> {
    let part = 1.0 / (directions[0] as f32 * directions[1] as f32);
    let width = map.width() as usize;
    let mut sent = vec![0.0f32; map.texels().len()];
    let mut received = Vec::new();
    for bounce in 0..=bounces {
        let of_all = (bounces + 1) as f32;
        let piece = watch.piece(bounce as f32 / of_all, (bounce + 1) as f32 / of_all);
        received.clear();
        received.resize(sent.len(), 0.0f32);
        visibility::views(map, metric, directions, tiles, &piece, &mut |view| {
            received.par_chunks_mut(width).enumerate().for_each(|(row, received)| {
                for (column, received) in received.iter_mut().enumerate() {
                    let seen = view.seen(column as u32, row as u32, map.wrap());
                    *received += part * seen.map_or(1.0, |texel| sent[texel]);
                }
            });
            Ok(())
        })?;
        let is_other = sent.par_iter_mut().zip(&received).map(|(sent, received)| {
            let before = std::mem::replace(sent, albedo * received);
            before.to_bits() != sent.to_bits()
        });
        if !is_other.reduce(|| false, |a, b| a | b) {
            // All further bounces send the same light.
            break;
        }
    }
    Ok(received)
}

/// Refuses settings whose rays would take more than hours.
fn check_rays(texels: usize, [azimuths, elevations]: [u32; 2], bounces: u32) -> Result<(), BakeError> {
    let rays = [texels as u64, azimuths.into(), elevations.into(), u64::from(bounces) + 1];
    let rays = rays.into_iter().fold(1, u64::saturating_mul);
    if rays <= MOST_RAYS {
        return Ok(());
    }
    let reason = format!(
        "{azimuths} x {elevations} directions and {bounces} bounces of {texels} texels need {rays} rays, \
         more than the limit of {MOST_RAYS}: choose fewer azimuths, elevations or bounces, or a smaller map"
    );
    Err(BakeError::Impossible { kind: KIND.name, reason })
}

fn bake(
    source: &BakeInput,
    settings: &Settings,
    watch: &Watch,
    sink: &mut dyn Sink,
) -> Result<(), BakeError> {
    let [azimuths, elevations, tiles] = [0, 1, 2].map(|place| settings.count(place));
    let (albedo, bounces, bits) = (settings.get(ALBEDO_PLACE), settings.count(4), settings.count(5));
    check_rays(source.map.texels().len(), [azimuths, elevations], bounces)?;
    let channels = [Channel { name: "light", unit: "1", range: [0.0, 1.0], rounding: Rounding::Nearest }];
    let mut texture = texture(source, azimuths, 1, channels.to_vec());
    texture.notes.push(("elevations", elevations.to_string()));
    texture.notes.push(("albedo", albedo.to_string()));
    texture.notes.push(("bounces", bounces.to_string()));
    sink.begin(&texture)?;
    let directions = [azimuths, elevations];
    let mut light = light(source.map, source.metric, directions, tiles, (albedo, bounces), watch)?;
    Ok(to_nearest(sink, &channels, bits, &mut [&mut light])?)
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

    use relief_core::Wrap;

    use super::*;

    fn pits(side: u32) -> HeightMap {
        let height = |i: u32, j: u32| ((i * 7 + j * j * 3) % 11) as f32 / 10.0;
        HeightMap::from_fn(side, side, Wrap::Repeat, height).expect("a valid map")
    }

    /// Returns the light, and the number of progress reports.
    fn of(map: &HeightMap, albedo: f32, bounces: u32) -> (Vec<f32>, usize) {
        let (reports, cancel) = (AtomicUsize::new(0), AtomicBool::new(false));
        let report = |_: &str, _: f32| {
            reports.fetch_add(1, Ordering::Relaxed);
        };
        let watch = Watch::new(&report, &cancel);
        let light = light(map, Metric::UNIT, [8, 2], 1, (albedo, bounces), &watch);
        (light.expect("memory"), reports.into_inner())
    }

    #[test]
    fn too_many_rays_are_refused() {
        let texels = |side: usize| side * side;
        for (side, directions, bounces) in
            [(256, [256, 64], 256), (512, [256, 64], 16), (16_384, [256, 64], 0), (8192, [16, 4], 16)]
        {
            let refused = check_rays(texels(side), directions, bounces);
            let said = refused.expect_err("too many").to_string();
            assert!(said.contains("bounces") && said.contains(&texels(side).to_string()), "{said}");
        }
        // By default, and small maps at the maxima.
        for (side, directions, bounces) in [(8192, [16, 4], 4), (64, [256, 64], 256), (2048, [64, 16], 4)] {
            assert!(check_rays(texels(side), directions, bounces).is_ok(), "{side}");
        }
    }

    #[test]
    fn bounces_that_change_nothing_are_not_made() {
        let map = pits(16);
        for albedo in [0.0, 0.25, 0.5] {
            let [(once, one), (many, reports)] = [0, 256].map(|bounces| of(&map, albedo, bounces));
            assert!(reports < 60 * one, "{reports} reports with albedo {albedo}, {one} for a bounce");
            assert!(many.iter().zip(&once).all(|(many, once)| many >= once));
            // The bounces left out would have changed nothing.
            assert_eq!(many, of(&map, albedo, 250).0);
        }
        let (few, most) = (of(&map, 0.5, 4).1, of(&map, 0.5, 256).1);
        assert!(most < 12 * few, "{most} reports, {few} for 4 bounces");
    }
}
