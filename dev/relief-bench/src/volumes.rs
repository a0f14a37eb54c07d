//! `volumes`: rays through volumes beside the judge in `f64`, and what each method over volumes costs.

mod grass;
mod translucent;

use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use rayon::prelude::*;
use relief_core::rng::Rng;
use relief_core::{Lanes, Path, Volume, Wrap};
use relief_mesh::motif::MotifKind;
use relief_shaders::Selection;
use relief_shaders::field::Solids;
use relief_testing::volumes;
use relief_tests::volume_rays::{baked, hits_over, motif_volume, parts_off, paths, ray_from_above, wrong};

use crate::table::table;

/// Rays that are judged at a time.
const AT_A_TIME: usize = 20_000;

/// Least part of a ray's way in voxels that goes down, in the table of methods: 80 degrees from the normal.
const LEAST_DOWN: f64 = 0.17;

/// Voxels by which a hit may be off before it counts, in the table of methods.
const OFF: [f64; 2] = [0.75, 2.0];

/// Searches and refinements over volumes.
const PAIRS: [(&str, &str); 4] =
    [("voxels", "trilinear"), ("linear", "binary"), ("generalised", "none"), ("generalised", "trilinear")];

/// Arguments of `volumes`.
#[derive(Args)]
pub struct Arguments {
    /// What is measured
    #[arg(value_enum, default_values = ["judge", "methods", "translucent"])]
    parts: Vec<Part>,
    /// Rays over each volume
    #[arg(long, value_name = "N", default_value_t = 1_000_000)]
    rays: usize,
    /// Rays over each motif in the table of methods, and over all volumes of `translucent`
    #[arg(long, value_name = "N", default_value_t = 100_000)]
    rays_of_methods: usize,
    /// Size of the pictures of grass, as WIDTHxHEIGHT
    #[arg(long, default_value = "400x300", value_parser = crate::cost::sides)]
    size: [u32; 2],
}

#[derive(Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Part {
    /// `voxels` beside the judge, over attacks and in every wrap
    Judge,
    /// Errors, reads, bytes and times of every method over cloth, mail and grass
    Methods,
    /// Optical depths and transmittances of `translucent` beside the judge
    Translucent,
    /// Grass on a mesh by every method, beside the same as triangles
    Grass,
}

/// Prints the tables. Fails where a ray of `voxels` passes the surface or hits beside it, or where an
/// optical depth is off.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let mut holds = true;
    for part in &arguments.parts {
        match part {
            Part::Judge => holds &= judge(arguments.rays)?,
            Part::Methods => methods(arguments.rays_of_methods)?,
            Part::Translucent => holds &= translucent::run(arguments.rays_of_methods)?,
            Part::Grass => grass::run(arguments.size)?,
        }
    }
    Ok(if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Rays of all kinds, a part of them in each wrap. Returns whether none errs.
fn judge(rays: usize) -> Result<bool, String> {
    let selection = Selection::method("voxels").map_err(|error| error.to_string())?;
    let mut rows = table(&["volume", "voxels", "rays", "hits", "gave up", "wrong"]);
    let mut holds = true;
    for (number, named) in volumes::ALL.iter().enumerate() {
        let (mut hits, mut gave_up, mut errs, mut asked) = (0, 0, 0, 0);
        for (turn, wrap) in Wrap::ALL.into_iter().enumerate() {
            let volume = named.build(wrap).map_err(|error| error.to_string())?;
            let maps = baked(&volume, &selection);
            let pieces = (rays / Wrap::ALL.len()).div_ceil(AT_A_TIME);
            let found: Vec<[usize; 4]> = (0..pieces)
                .into_par_iter()
                .map(|piece| {
                    let seed = ((number * Wrap::ALL.len() + turn) * pieces + piece) as u64;
                    let paths = paths(seed, AT_A_TIME);
                    let found = hits_over(&volume, &selection, &maps, &paths, Lanes::widest());
                    let hit = found.iter().filter(|hit| hit.found).count();
                    let exhausted = found.iter().filter(|hit| hit.exhausted).count();
                    [paths.len(), hit, exhausted, wrong(&volume, &paths, &found)]
                })
                .collect();
            for [rays, hit, exhausted, wrong] in found {
                asked += rays;
                hits += hit;
                gave_up += exhausted;
                errs += wrong;
            }
        }
        holds &= errs == 0 && gave_up == 0;
        let size = named.size.map(|side| side.to_string()).join("x");
        let counts = [asked, hits, gave_up, errs].map(|count| count.to_string());
        rows.add_row([vec![named.name.to_owned(), size], counts.to_vec()].concat());
    }
    println!("{rows}\n");
    Ok(holds)
}

/// Straight rays from above into motifs, by every method.
fn methods(rays: usize) -> Result<(), String> {
    let mut rows = table(&[
        "motif",
        "search, refinement",
        "off by over 3/4 voxel",
        "over 2",
        "reads a ray",
        "map, MB",
        "baked in, s",
        "rays a second",
    ]);
    for (kind, size) in [
        (MotifKind::Weave, [64, 64, 32]),
        (MotifKind::Mail, [64, 64, 32]),
        (MotifKind::Grass, [128, 128, 32]),
    ] {
        let volume = motif_volume(kind, size);
        let mut rng = Rng::new(2);
        let sides = size.map(f64::from);
        let paths: Vec<Path> = (0..rays).map(|_| ray_from_above(&mut rng, sides, LEAST_DOWN)).collect();
        for (search, refine) in PAIRS {
            let row = row_of(&volume, &paths, search, refine)?;
            rows.add_row([vec![kind.to_string()], row].concat());
        }
    }
    println!("{rows}\n");
    Ok(())
}

/// A method's row over a motif. Bakes use all cores, rays one.
fn row_of(volume: &Volume, paths: &[Path], search: &str, refine: &str) -> Result<Vec<String>, String> {
    let pair = Selection::pair(search, refine).map_err(|error| error.to_string())?;
    let selection = pair.with_solids(Solids::Volumes).with_volume_size(volume.size());
    let started = Instant::now();
    let maps = baked(volume, &selection);
    let bake_s = started.elapsed().as_secs_f64();
    let started = Instant::now();
    let found = hits_over(volume, &selection, &maps, paths, Lanes::widest());
    let rate = paths.len() as f64 / started.elapsed().as_secs_f64();
    let reads = found.iter().map(|hit| f64::from(hit.cost.reads)).sum::<f64>() / paths.len() as f64;
    let bytes = maps.iter().map(|map| map.layout().bytes()).sum::<u64>();
    let off = OFF.map(|voxels| format!("{:.1} %", 100.0 * parts_off(volume, paths, &found, voxels)));
    Ok([
        vec![format!("{search}, {refine}")],
        off.to_vec(),
        vec![
            format!("{reads:.1}"),
            format!("{:.2}", bytes as f64 / 1e6),
            format!("{bake_s:.2}"),
            format!("{:.2} million", rate / 1e6),
        ],
    ]
    .concat())
}
