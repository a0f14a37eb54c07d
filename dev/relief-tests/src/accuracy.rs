//! Errors of every method against the truth: the maps, and the results of `relief-compare` for a pair of
//! stages on them.

use std::path::{Path as FilePath, PathBuf};

use relief_compare::rays::{PICTURE, UNIT_TILE};
use relief_compare::{Case, cost};
use relief_core::metrics::{CostReport, ErrorReport};
use relief_core::{HeightMap, Lanes, Path, Wrap};
use relief_io::{HeightOptions, read_height};
use relief_shaders::cpu::MethodTracer;
use relief_shaders::{Selection, SlotMaps};

use crate::baked::{maps_for, slots};
use relief_testing::maps::fractal;

/// Depth of the relief, in tiles: a tenth, which is deep.
pub const SCALE_M: f64 = 0.1;

/// Angles between ray and normal, in degrees.
pub const ANGLES: [f64; 4] = [10.0, 30.0, 60.0, 85.0];

/// A map by name.
pub struct Named {
    /// Name in tables.
    pub name: &'static str,
    /// The map, with [`SCALE_M`].
    pub map: HeightMap,
}

/// The five maps of the accuracy tables: bricks and cobbles, a real elevation model, spikes, and fractal
/// ground.
///
/// # Panics
///
/// When a sample map is missing or broken.
pub fn maps() -> Vec<Named> {
    let folder = sample_maps();
    let read = |file: &str, wrap: Wrap| {
        let options = HeightOptions { wrap: Some(wrap), ..HeightOptions::default() };
        read_height(&folder.join(file), &options).unwrap_or_else(|error| panic!("{error}"))
    };
    let ground = HeightMap::new(256, 256, fractal(7, 256, 256, 0.5), Wrap::Repeat);
    let named = [
        ("bricks", read("bricks.png", Wrap::Repeat)),
        ("cobbles", read("cobbles.png", Wrap::Repeat)),
        ("jacksboro", read("jacksboro.png", Wrap::Mirror)),
        ("spikes", read("spikes.png", Wrap::Repeat)),
        ("ground", ground.unwrap_or_else(|error| panic!("{error}"))),
    ];
    named
        .into_iter()
        .map(|(name, map)| Named {
            name,
            map: map.with_displacement(SCALE_M, -SCALE_M).unwrap_or_else(|error| panic!("{error}")),
        })
        .collect()
}

/// The folder of the sample maps that the project ships.
pub fn sample_maps() -> PathBuf {
    FilePath::new(env!("CARGO_MANIFEST_DIR")).join("../../data")
}

/// Cost of a pair of stages for [`picture_paths`](relief_compare::rays::picture_paths); a baked map that
/// its search reads is baked first.
pub fn picture_cost(map: &HeightMap, selection: &Selection, paths: &[Path]) -> CostReport {
    let maps = maps_for(map, selection);
    let tracer = MethodTracer::over(map, selection, slots(map, selection, &maps));
    cost(&tracer, paths, PICTURE[0], Lanes::widest())
}

/// View rays at an angle, with their true hits.
pub fn case(map: &HeightMap, degrees: f64, count: usize) -> Case<'_> {
    Case::new(map, UNIT_TILE, degrees, count)
}

/// Errors of a pair of stages. A baked map that its search reads is baked first.
pub fn report(case: &Case, selection: &Selection) -> ErrorReport {
    let maps = maps_for(case.map, selection);
    report_with(case, selection, &slots(case.map, selection, &maps))
}

/// Errors of a pair of stages, with the baked map that its search reads.
pub fn report_with(case: &Case, selection: &Selection, maps: &SlotMaps) -> ErrorReport {
    case.report(&MethodTracer::over(case.map, selection, *maps), Lanes::widest())
}

/// Mean distance to the truth in texels over all maps and angles, and the share of rays that passed the first
/// hit, of a method with that many linear steps.
///
/// # Errors
///
/// When the method has no such setting.
pub fn mean_error(maps: &[Named], method: &str, steps: u32, rays: usize) -> Result<(f64, f64), String> {
    let mut selection = Selection::method(method).map_err(|error| error.to_string())?;
    selection.set("search.steps", f64::from(steps)).map_err(|error| error.to_string())?;
    let (mut error, mut passed, mut count) = (0.0, 0.0, 0.0);
    for named in maps {
        for degrees in ANGLES {
            let report = report(&case(&named.map, degrees, rays), &selection);
            error += report.distance_texels.mean;
            passed += report.missed + report.late;
            count += 1.0;
        }
    }
    Ok((error / count, passed / count))
}
