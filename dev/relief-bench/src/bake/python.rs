//! `distance` beside PyPI's edt, and `horizon` beside PyPI's topocalc: the same map, the same session, one
//! thread each.

use std::fs;
use std::path::Path;
use std::process::Command;
use std::time::Instant;

use comfy_table::Table;
use cpu_time::ProcessTime;
use rayon::ThreadPool;
use relief_bake::{Collected, bake};
use relief_core::{HeightMap, Metric, Watch, Wrap};
use serde_json::Value;
use tempfile::TempDir;

use super::{SCALE_M, ground, measure, metric, table};
use crate::python::require;

/// The scripts, which are run as they are here.
const EDT: &str = include_str!("../../python/edt_beside.py");
const TOPOCALC: &str = include_str!("../../python/topocalc_beside.py");

/// Larger maps are left out: edt holds its whole volume in memory, with 64 slices 340 MB at this side.
const LARGEST: u32 = 1024;

/// Runs of each; the median counts.
const RUNS: usize = 3;

/// Slices of the distance field, and azimuths of the horizon: the kinds' defaults.
const SLICES: u32 = 64;
const AZIMUTHS: u32 = 16;

/// Seconds of processor time and from beginning to end.
#[derive(Clone, Copy)]
struct Times {
    cpu_s: f64,
    wall_s: f64,
}

/// Prints the table, of maps up to [`LARGEST`].
pub fn run(python: &Path, sizes: &[u32], pool: &ThreadPool) -> Result<(), String> {
    require(python, "import edt, numpy, topocalc.horizon", "numpy edt topocalc")?;
    let mut table = table(&[
        "kind",
        "size",
        "Relief CPU s",
        "Relief wall s",
        "beside",
        "CPU s",
        "wall s",
        "wall ratio",
        "agreement",
    ]);
    for &side in sizes.iter().filter(|&&side| side <= LARGEST) {
        // Neither of the two knows maps that repeat.
        let map = ground(side)?.with_wrap(Wrap::Clamp);
        distance(python, &map, pool, &mut table)?;
        horizon(python, &map, pool, &mut table)?;
    }
    println!(
        "Natural ground, clamped; relief {SCALE_M} of the tile; one thread each, medians of {RUNS} runs."
    );
    println!(
        "distance: {SLICES} slices. edt is given the volume of voxels that are solid up to the highest of \
         the 3x3 texels around, and finds distances between voxel centres; building that volume is not \
         timed. Relief finds distances to the boxes as high as they are, turns them into lower bounds for \
         the bilinear surface, and hands each slice over instead of holding them all. Agreement: the mean \
         stored bound over edt's mean distance, both above the ground."
    );
    println!(
        "horizon: {AZIMUTHS} azimuths. topocalc skews the map and takes horizons of its rows from texel to \
         texel as far as the map reaches, in f64. Relief takes the bilinear surface, from the texel's own \
         ray near by, and goes on beyond the edges by the wrap. Agreement: the mean difference of the sines."
    );
    println!("\n{table}");
    Ok(())
}

fn distance(python: &Path, map: &HeightMap, pool: &ThreadPool, table: &mut Table) -> Result<(), String> {
    let metric = metric()?;
    let (own, baked) = time("distance", map, metric, pool)?;
    let texture = baked.textures.first().ok_or("no texture")?;
    let values = texture.levels[0][0].iter().map(|&value| f64::from(value)).filter(|value| *value > 0.0);
    let (sum, count) = values.fold((0.0, 0), |(sum, count), value| (sum + value, count + 1));
    let [tile_u, tile_v] = metric.tile_m;
    let arguments = [f64::from(SLICES), tile_u, tile_v, metric.scale_m, RUNS as f64];
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let (other, answer) = other(python, EDT, map, &arguments, &folder, None)?;
    let mean = answer["mean"].as_f64().unwrap_or(f64::NAN);
    let agreement = format!("{:.3}", sum / f64::from(count) / mean);
    add(table, "distance", map, own, format!("edt {}", text(&answer["version"])), other, agreement);
    Ok(())
}

fn horizon(python: &Path, map: &HeightMap, pool: &ThreadPool, table: &mut Table) -> Result<(), String> {
    let metric = metric()?;
    let (own, baked) = time("horizon", map, metric, pool)?;
    let texture = baked.textures.first().ok_or("no texture")?;
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let out = folder.path().join("sines.raw");
    let arguments = [f64::from(AZIMUTHS), metric.texel_m(map)[0], metric.scale_m, RUNS as f64];
    let (other, answer) = other(python, TOPOCALC, map, &arguments, &folder, Some(&out))?;
    let bytes = fs::read(&out).map_err(|error| error.to_string())?;
    let sines = bytes.as_chunks::<4>().0.iter().map(|bytes| f32::from_le_bytes(*bytes));
    let off: f64 =
        sines.zip(&texture.levels[0][0]).map(|(other, own)| f64::from((other.max(0.0) - own).abs())).sum();
    let agreement = format!("{:.4}", off / texture.levels[0][0].len() as f64);
    add(table, "horizon", map, own, format!("topocalc {}", text(&answer["version"])), other, agreement);
    Ok(())
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap_or("of unknown version")
}

/// Times a kind's bake with its defaults into memory, which the other programs take, too.
fn time(
    kind: &str,
    map: &HeightMap,
    metric: Metric,
    pool: &ThreadPool,
) -> Result<(Times, Collected), String> {
    let kind = relief_bake::kind(kind).map_err(|error| error.to_string())?;
    let mut baked = Collected::default();
    let mut times = Vec::new();
    for _ in 0..RUNS {
        baked = Collected::default();
        let (started, cpu) = (Instant::now(), ProcessTime::now());
        pool.install(|| bake(kind, map, metric, &kind.defaults(), &Watch::none(), &mut baked))
            .map_err(|error| error.to_string())?;
        times.push(Times { cpu_s: cpu.elapsed().as_secs_f64(), wall_s: started.elapsed().as_secs_f64() });
    }
    let median = |value: fn(&Times) -> f64| measure::median(times.iter().map(value).collect());
    Ok((Times { cpu_s: median(|times| times.cpu_s), wall_s: median(|times| times.wall_s) }, baked))
}

/// Runs a script with a file of the map's heights, its size, those arguments and the file for its result.
fn other(
    python: &Path,
    script: &str,
    map: &HeightMap,
    arguments: &[f64],
    folder: &TempDir,
    out: Option<&Path>,
) -> Result<(Times, Value), String> {
    let (heights, file) = (folder.path().join("heights.raw"), folder.path().join("beside.py"));
    let bytes: Vec<u8> = map.texels().iter().flat_map(|texel| texel.to_le_bytes()).collect();
    fs::write(&heights, bytes).and_then(|()| fs::write(&file, script)).map_err(|error| error.to_string())?;
    let output = Command::new(python)
        .arg(&file)
        .arg(&heights)
        .args([map.width(), map.height()].map(|side| side.to_string()))
        .args(arguments.iter().map(f64::to_string))
        .args(out)
        .output()
        .map_err(|error| error.to_string())?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let answer: Value = serde_json::from_slice(&output.stdout).map_err(|error| error.to_string())?;
    let seconds = |name: &str| answer[name].as_f64().ok_or_else(|| format!("no {name} in {answer}"));
    Ok((Times { cpu_s: seconds("cpu_s")?, wall_s: seconds("wall_s")? }, answer))
}

fn add(
    table: &mut Table,
    kind: &str,
    map: &HeightMap,
    own: Times,
    beside: String,
    other: Times,
    agreement: String,
) {
    table.add_row([
        kind.to_owned(),
        format!("{}²", map.width()),
        format!("{:.3}", own.cpu_s),
        format!("{:.3}", own.wall_s),
        beside,
        format!("{:.3}", other.cpu_s),
        format!("{:.3}", other.wall_s),
        format!("{:.1}", other.wall_s / own.wall_s),
        agreement,
    ]);
}
