//! The tests' brute forces, timed.

use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Instant;

use rayon::prelude::*;
use relief_bake::Settings;
use relief_core::rng::Rng;
use relief_core::{HeightMap, Metric};
use relief_testing::brute;

/// Samples along either side of a patch in the brute force of relaxed cones.
const SAMPLES: usize = 4;

/// Texels that are done between two looks at the time, at first.
const BATCH: usize = 256;

/// Time of brute force for a whole map.
pub struct Brute {
    /// Seconds, extrapolated from the texels that were done.
    pub seconds: f64,
    /// The share of the texels that were done.
    pub share: f64,
}

/// Runs the kind's brute force, with those settings, in parallel on texels drawn at random until about
/// `limit_s` has passed, or on all of them. Nothing for a kind without one.
pub fn time(kind: &str, settings: &Settings, map: &HeightMap, metric: Metric, limit_s: f64) -> Option<Brute> {
    let (tile_m, scale_m, texel_m) = (metric.tile_m, metric.scale_m, metric.texel_m(map));
    let highest = highest(map);
    let most = 2 * i64::from(map.width().max(map.height()));
    let levels = map.width().max(map.height()).ilog2();
    let each = |work: &(dyn Fn([u32; 2]) + Sync)| Some(each_texel(map, limit_s, work));
    let signed = |texel: [u32; 2]| texel.map(i64::from);
    let sky = || {
        let (azimuths, tiles) = (number(settings, "azimuths"), number(settings, "tiles"));
        let reach = f64::from(map.width()) * tiles;
        brute::sky::Sky { texel_m, scale_m, azimuths: azimuths as u32, reach, highest }
    };
    match kind {
        "normal" => whole(|| {
            for level in 0..=levels {
                let slopes = brute::normal::level(map, tile_m, scale_m, level);
                black_box(
                    slopes.par_iter().map(|&(mean, _)| brute::normal::normal(mean)).collect::<Vec<_>>(),
                );
            }
        }),
        "pyramid" => whole(|| {
            for level in 0..=levels {
                black_box(brute::pyramid::level(map, level));
            }
        }),
        "dilation-erosion" => {
            let (radius, all) = (number(settings, "radius") as u32, brute::dilation_erosion::extremes(map));
            each(&|texel| {
                black_box(brute::dilation_erosion::bounds(map, radius, signed(texel), all));
            })
        }
        "cone" => {
            let footprint = number(settings, "apex") > 0.0;
            each(&|texel| {
                black_box(brute::cone::slope(map, texel_m, footprint, signed(texel), highest));
            })
        }
        "relaxed-cone" => each(&|texel| {
            let (texel, centre) = (signed(texel), [0.0; 2]);
            black_box(brute::relaxed_cone::slope(map, texel_m, texel, centre, [SAMPLES, 1], highest, most));
        }),
        "distance" => {
            let slices = number(settings, "slices");
            each(&|texel| {
                for slice in 0..slices as u32 {
                    let level = (f64::from(slice) + 0.5) / slices;
                    black_box(brute::distance::to_boxes(map, tile_m, scale_m, level, signed(texel)));
                }
            })
        }
        "frustum" => each(&|texel| {
            for forward in [[false, false], [true, false], [false, true], [true, true]] {
                black_box(brute::frustum::least_slope(map, highest, signed(texel), forward, most));
            }
        }),
        "horizon" => {
            let sky = sky();
            each(&|texel| sky.horizons(map, texel).for_each(|horizon| _ = black_box(horizon)))
        }
        "occlusion" => {
            let sky = sky();
            each(&|texel| _ = black_box(sky.visibility(map, texel)))
        }
        "bent-normal" => {
            let sky = sky();
            each(&|texel| _ = black_box(sky.bent_normal(map, texel)))
        }
        "visibility" => {
            let directions = directions(map, metric, settings);
            each(&|texel| {
                for &(step_uv, slope, reach) in &directions {
                    let path = brute::visibility::path(map, texel, step_uv, slope, reach);
                    black_box(brute::visibility::first_hit(map, &path, 1e-9));
                }
            })
        }
        _ => None,
    }
}

/// Runs a brute force for cones that looks at texels only, not between them, and so does less than the kind
/// promises.
pub fn time_cones_at_texels(settings: &Settings, map: &HeightMap, metric: Metric, limit_s: f64) -> Brute {
    let (texel_m, highest, footprint) = (metric.texel_m(map), highest(map), number(settings, "apex") > 0.0);
    let most = 2 * i64::from(map.width().max(map.height()));
    each_texel(map, limit_s, &|texel| {
        let texel = texel.map(i64::from);
        black_box(brute::cone::vertex_slope(map, texel_m, footprint, texel, highest, most));
    })
}

fn highest(map: &HeightMap) -> f64 {
    f64::from(map.texels().iter().copied().fold(0.0, f32::max))
}

/// The value of a setting that the kind has.
fn number(settings: &Settings, name: &str) -> f64 {
    settings.iter().find(|setting| setting.0 == name).map_or(0.0, |setting| f64::from(setting.1))
}

/// The directions of the kind `visibility`: a step in texture coordinates, its rise in heights, and how many
/// steps a ray is followed.
fn directions(map: &HeightMap, metric: Metric, settings: &Settings) -> Vec<([f64; 2], f64, f64)> {
    let (azimuths, elevations) = (number(settings, "azimuths"), number(settings, "elevations"));
    let size = [f64::from(map.width()), f64::from(map.height())];
    let azimuths = (0..azimuths as u32).map(|azimuth| {
        brute::horizon::HorizonRay::new(TAU * f64::from(azimuth) / azimuths, metric.texel_m(map))
    });
    azimuths
        .flat_map(|ray| {
            (0..elevations as u32).map(move |elevation| {
                let square = (f64::from(elevation) + 0.5) / elevations;
                let slope = (square / (1.0 - square)).sqrt() * ray.step_m / metric.scale_m;
                let most = number(settings, "tiles") * size[0].max(size[1]);
                ([ray.step[0] / size[0], ray.step[1] / size[1]], slope, (1.0 / slope).min(most))
            })
        })
        .collect()
}

fn whole(work: impl FnOnce()) -> Option<Brute> {
    let started = Instant::now();
    work();
    Some(Brute { seconds: started.elapsed().as_secs_f64(), share: 1.0 })
}

/// Works on texels drawn at random, in batches that get larger, or on all where the first batch says that
/// there is time.
fn each_texel(map: &HeightMap, limit_s: f64, work: &(dyn Fn([u32; 2]) + Sync)) -> Brute {
    let (width, all) = (map.width(), map.texels().len());
    let at = |texel: u32| [texel % width, texel / width];
    let mut rng = Rng::new(1);
    let (mut done, mut seconds, mut batch) = (0, 0.0, BATCH);
    while seconds < limit_s {
        let rate = seconds / done.max(1) as f64;
        if done > 0 && rate * (all as f64) < limit_s {
            let started = Instant::now();
            (0..all as u32).into_par_iter().for_each(|texel| work(at(texel)));
            return Brute { seconds: started.elapsed().as_secs_f64(), share: 1.0 };
        }
        let texels: Vec<u32> = (0..batch).map(|_| rng.below(all as u32)).collect();
        let started = Instant::now();
        texels.par_iter().for_each(|&texel| work(at(texel)));
        seconds += started.elapsed().as_secs_f64();
        done += batch;
        batch *= 2;
    }
    let share = done as f64 / all as f64;
    Brute { seconds: seconds / share, share: share.min(1.0) }
}
