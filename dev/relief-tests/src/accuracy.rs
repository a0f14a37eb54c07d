//! How near every method comes to the truth: maps, view rays at given angles, and the survey's claims about
//! the order.

use std::f64::consts::TAU;
use std::path::{Path as FilePath, PathBuf};

use rayon::prelude::*;
use relief_core::exact::{ExactHit, cell_walk};
use relief_core::metrics::{CostReport, ErrorReport, WAVE, compare};
use relief_core::{HeightMap, Hit, Path, PathMetric, Wrap};
use relief_io::{HeightOptions, read_height};
use relief_shaders::cpu::MethodTracer;
use relief_shaders::{Selection, SlotMaps};

use crate::baked::{maps_for, slots};
use crate::maps::fractal;
use crate::rng::Rng;

/// Depth of the relief, in tiles: a tenth, which is deep.
pub const SCALE_M: f64 = 0.1;

/// Angles between ray and normal, in degrees.
pub const ANGLES: [f64; 4] = [10.0, 30.0, 60.0, 85.0];

/// A map by name.
pub struct Named {
    /// Its name in tables.
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

/// View rays through a map at one angle, from height 1 down to 0, everywhere and in all directions.
pub fn view_paths(map: &HeightMap, degrees: f64, count: usize, seed: u64) -> Vec<Path> {
    let mut rng = Rng::new(seed);
    (0..count)
        .map(|_| {
            let direction = rng.between(0.0, TAU);
            view_path(map.scale_m(), degrees, direction, [rng.unit(), rng.unit()])
        })
        .collect()
}

/// A view ray of that angle and direction in the tile from a place at height 1 down to 0.
fn view_path(scale_m: f64, degrees: f64, direction: f64, uv: [f64; 2]) -> Path {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let (sin, cos) = direction.sin_cos();
    let path = Path {
        uv,
        duv: [sine * cos, sine * sin],
        h: [1.0, -cosine / scale_m, 0.0],
        // A little below the floor, as the surface stage makes them.
        exit: scale_m / cosine * 1.000_001,
        base: 0.0,
        metric: PathMetric::unit(scale_m),
    };
    // What a shader is given is the ray to judge.
    Path::from(&relief_shaders::cpu::Path::from(&path))
}

/// Columns and rows of the pictures of [`picture_paths`]: whole tiles of [`WAVE`].
pub const PICTURE: [usize; 2] = [20 * WAVE[0], 30 * WAVE[1]];

/// Directions from which these pictures are seen.
const DIRECTIONS: usize = 8;

/// View rays of neighbouring pixels: orthographic pictures of the map at that angle, seen from several sides,
/// one below the other. A pixel is a texel of the longer side wide, and as high, so that along the view a
/// pixel's footprint is longer.
pub fn picture_paths(map: &HeightMap, degrees: f64) -> Vec<Path> {
    let pixel = 1.0 / f64::from(map.width().max(map.height()));
    let stretched = pixel / degrees.to_radians().cos();
    let [columns, rows] = PICTURE;
    let mut paths = Vec::with_capacity(columns * rows * DIRECTIONS);
    for side in 0..DIRECTIONS {
        // Not along the axes, nor along the diagonals.
        let direction = (side as f64 + 0.3) / DIRECTIONS as f64 * TAU;
        let (sin, cos) = direction.sin_cos();
        for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
            let (right, along) = (column as f64 * pixel, row as f64 * stretched);
            // Upper rows are farther away.
            let uv = [right * sin - along * cos, -right * cos - along * sin];
            paths.push(view_path(map.scale_m(), degrees, direction, uv.map(|place| place.rem_euclid(1.0))));
        }
    }
    paths
}

/// What a pair of stages pays for [`picture_paths`]; a baked map that its search reads is baked first.
pub fn picture_cost(map: &HeightMap, selection: &Selection, paths: &[Path]) -> CostReport {
    let maps = maps_for(map, selection);
    CostReport::of(&hits(map, selection, &slots(map, selection, &maps), paths), PICTURE[0])
}

/// The true hits.
pub fn truth(map: &HeightMap, paths: &[Path]) -> Vec<ExactHit> {
    paths.par_iter().map(|path| cell_walk(map, path)).collect()
}

/// The hits of a pair of stages, by the translated shaders, with the baked map that the search reads.
///
/// # Panics
///
/// When that map is missing or is none of the height map.
pub fn hits(map: &HeightMap, selection: &Selection, maps: &SlotMaps, paths: &[Path]) -> Vec<Hit> {
    let tracer = MethodTracer::over(map, selection, *maps);
    paths.par_iter().map(|path| tracer.first_hit(path)).collect()
}

/// Rays with their true hits.
pub struct Case<'a> {
    /// The map.
    pub map: &'a HeightMap,
    /// The rays.
    pub paths: Vec<Path>,
    /// Where they truly hit.
    pub truth: Vec<ExactHit>,
}

impl<'a> Case<'a> {
    /// View rays at an angle.
    pub fn new(map: &'a HeightMap, degrees: f64, count: usize) -> Self {
        let paths = view_paths(map, degrees, count, degrees.to_bits());
        let truth = truth(map, &paths);
        Self { map, paths, truth }
    }

    /// How wrong a pair of stages is; a baked map that its search reads is baked first.
    pub fn report(&self, selection: &Selection) -> ErrorReport {
        let maps = maps_for(self.map, selection);
        self.report_with(selection, &slots(self.map, selection, &maps))
    }

    /// How wrong a pair of stages is, with the baked map that its search reads.
    pub fn report_with(&self, selection: &Selection, maps: &SlotMaps) -> ErrorReport {
        let hits = hits(self.map, selection, maps, &self.paths);
        compare(&self.truth, &hits, self.map).unwrap_or_default()
    }
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
            let report = Case::new(&named.map, degrees, rays).report(&selection);
            error += report.distance_texels.mean;
            passed += report.missed + report.late;
            count += 1.0;
        }
    }
    Ok((error / count, passed / count))
}
