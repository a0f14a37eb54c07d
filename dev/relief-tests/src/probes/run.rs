//! Attacks on every kind of map that makes a one-sided promise: the same for tests and for long runs.

use std::fmt::Debug;

use rayon::prelude::*;
use relief_bake::BakeError;
use relief_bake::kind::{cone, dilation_erosion, distance, frustum, pyramid, relaxed_cone};
use relief_core::{HeightMap, MaxPyramid, Metric, Wrap};

use super::stored;
use relief_testing::maps;
use relief_testing::probes::Found;
use relief_testing::probes::distance::Field;

/// The kinds that are attacked.
pub const KINDS: [&str; 6] = ["cone", "relaxed-cone", "frustum", "distance", "pyramid", "dilation-erosion"];

/// The maps that are attacked, each in a wrap, so that every wrap meets several kinds of maps and both odd
/// sizes and powers of two.
pub const MAPS: [(&str, Wrap); 8] = [
    ("white noise 37x53", Wrap::Repeat),
    ("natural 128x128", Wrap::Mirror),
    ("natural 101x67", Wrap::Clamp),
    ("single spike 33x31", Wrap::Mirror),
    ("needles in a pit 64x64", Wrap::Repeat),
    ("checkerboard 24x24", Wrap::Repeat),
    ("steps 61x40", Wrap::Clamp),
    ("one row 1x29", Wrap::Mirror),
];

/// The unit of the room that is a ratio of ratios: 1 is none.
pub const RATIO: &str = "of the ratio";

/// Probes that one task makes.
const BATCH: usize = 1 << 16;

/// Slices of the distance fields.
const SLICES: u32 = 24;

/// Radii of the windows, map by map in turn.
const RADII: [u32; 3] = [5, 1, 13];

/// Attacked baked map: its kind, heights and storage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Case {
    /// The kind.
    pub kind: &'static str,
    /// Place of the map in [`MAPS`].
    pub map: usize,
    /// Bits of the stored values; 0 for floats.
    pub bits: u32,
    /// The kind's parameter `apex`; 0 for kinds without it.
    pub apex: u32,
}

/// Result of the attack.
#[derive(Clone, Debug, PartialEq)]
pub struct Outcome {
    /// Probes that broke the promise.
    pub violations: usize,
    /// The least room that a probe found: of cones the ratio that would have been safe over the stored one,
    /// else how far the surface stayed inside, in the unit.
    pub room: f64,
    /// The unit of the room.
    pub unit: &'static str,
    /// Where it was found.
    pub tightest: String,
}

/// Everything that is attacked of a kind at that number of bits.
pub fn cases(kind: &'static str, bits: u32) -> Vec<Case> {
    let apexes = if kind == "cone" || kind == "relaxed-cone" { 0..=1 } else { 0..=0 };
    let maps = 0..MAPS.len();
    maps.flat_map(|map| apexes.clone().map(move |apex| Case { kind, map, bits, apex })).collect()
}

/// Runs `count` probes, in parallel; the outcome does not depend on the number of threads. `done` receives
/// the number of probes as they end.
///
/// # Errors
///
/// When the map cannot be baked.
///
/// # Panics
///
/// When the kind is not one of [`KINDS`].
pub fn run(case: &Case, count: usize, done: &(dyn Fn(usize) + Sync)) -> Result<Outcome, BakeError> {
    let Case { kind, bits, apex, .. } = *case;
    let (map, metric) = (map(case.map), metric(kind, case.map));
    let set = |name: &'static str, value: u32| [("bits", f64::from(bits)), (name, f64::from(value))];
    let heights = stored::heights(&map, bits)?;
    let texel_m = metric.texel_m(&map);
    let folding = MaxPyramid::new(&heights);
    match kind {
        "cone" => {
            let textures = stored::textures(&cone::KIND, &map, metric, &set("apex", apex))?;
            let ratios = stored::ratios(&textures[0]);
            Ok(attack(count, done, RATIO, |count, seed| {
                let probes = relief_testing::probes::cone::Probes::new(&heights, texel_m, apex == 1, seed);
                let ratio = |contact: &relief_testing::probes::cone::Contact| {
                    stored::at(&heights, &ratios, contact.texel)
                };
                let (violations, tightest) = relief_testing::probes::cone::attack(probes, count, ratio);
                Found { violations, tightest: tightest.map(|at| (at.limit / ratio(&at), at)) }
            }))
        }
        "relaxed-cone" => {
            let textures = stored::textures(&relaxed_cone::KIND, &map, metric, &set("apex", apex))?;
            let ratios = stored::ratios(&textures[0]);
            Ok(attack(count, done, RATIO, |count, seed| {
                let probes =
                    relief_testing::probes::relaxed_cone::Probes::new(&heights, texel_m, apex == 1, seed);
                let ratio = |exit: &relief_testing::probes::relaxed_cone::Exit| {
                    stored::at(&heights, &ratios, exit.texel)
                };
                let (violations, tightest) =
                    relief_testing::probes::relaxed_cone::attack(probes, count, ratio);
                Found { violations, tightest: tightest.map(|at| (at.limit / ratio(&at), at)) }
            }))
        }
        "frustum" => {
            let textures = stored::textures(&frustum::KIND, &map, metric, &[("bits", f64::from(bits))])?;
            let frusta = stored::frustum_map(&map, &textures);
            Ok(attack(count, done, "heights", |count, seed| {
                let read = |cell, forward| stored::frustum(&frusta, cell, forward);
                relief_testing::probes::frustum::attack(&heights, read, count, seed)
            }))
        }
        "distance" => {
            let textures = stored::textures(&distance::KIND, &map, metric, &set("slices", SLICES))?;
            let Metric { tile_m, scale_m } = metric;
            let values = &textures[0].levels[0][0];
            let field = Field { map: &heights, tile_m, scale_m, slices: SLICES, values };
            Ok(attack(count, done, "m", |count, seed| field.attack(count, seed)))
        }
        "pyramid" => {
            let textures = stored::textures(&pyramid::KIND, &map, metric, &[("bits", f64::from(bits))])?;
            let levels = textures[0].levels.len();
            Ok(attack(count, done, "heights", |count, seed| {
                let bounds = |level: usize, cell: [i64; 2]| {
                    let (column, row) = (folding.column(cell[0]) >> level, folding.row(cell[1]) >> level);
                    stored::pair(&textures[0], level, column, row)
                };
                relief_testing::probes::pyramid::attack(&heights, levels, bounds, count, seed)
            }))
        }
        "dilation-erosion" => {
            let radius = RADII[case.map % RADII.len()];
            let textures = stored::textures(&dilation_erosion::KIND, &map, metric, &set("radius", radius))?;
            Ok(attack(count, done, "heights", |count, seed| {
                let bounds = |cell: [i64; 2]| {
                    stored::pair(&textures[0], 0, folding.column(cell[0]), folding.row(cell[1]))
                };
                relief_testing::probes::dilation_erosion::attack(&heights, radius, bounds, count, seed)
            }))
        }
        _ => panic!("'{kind}' is none of the kinds that are attacked"),
    }
}

/// A map of [`MAPS`].
///
/// # Panics
///
/// When there is no such place in the list.
pub fn map(place: usize) -> HeightMap {
    let (name, wrap) = MAPS[place];
    let named = maps::ALL.iter().find(|named| named.name == name);
    named.expect("the list names adversarial maps").build(wrap)
}

/// The metric that a kind is baked in from a map of [`MAPS`]: square texels and long ones in turn.
fn metric(kind: &str, place: usize) -> Metric {
    let scale_m = if kind == "distance" { 0.3 } else { 0.1 };
    Metric::new([[1.0, 1.0], [3.0, 0.7]][place % 2], scale_m).expect("positive lengths")
}

/// Runs an attack in batches, which is given the number of probes and a seed.
fn attack<T: Copy + Send + Debug>(
    count: usize,
    done: &(dyn Fn(usize) + Sync),
    unit: &'static str,
    attack: impl Fn(usize, u64) -> Found<T> + Sync,
) -> Outcome {
    let batches: Vec<Found<T>> = (0..count.div_ceil(BATCH))
        .into_par_iter()
        .map(|batch| {
            let part = BATCH.min(count - batch * BATCH);
            let found = attack(part, batch as u64 + 1);
            done(part);
            found
        })
        .collect();
    let found = batches.into_iter().fold(Found::default(), Found::and);
    let (room, tightest) =
        found.tightest.map_or((f64::INFINITY, String::new()), |(room, at)| (room, format!("{at:?}")));
    Outcome { violations: found.violations, room, unit, tightest }
}
