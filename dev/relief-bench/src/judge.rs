//! `judge`: the exact judge of displaced meshes beside a tessellation whose error is bounded.

use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use indicatif::ProgressBar;
use relief_core::exact::{DisplacedMesh, Sides};
use relief_testing::displaced::rays::KINDS;
use relief_testing::displaced::scenes::{self, Scene};
use relief_testing::displaced::sheet::Sheet;
use relief_testing::displaced::tessellation::tessellate;
use relief_testing::displaced::{Counts, DIVISIONS, Tally, compare, first_hit, judge_of};

use crate::table::table;

/// By how much a relief is deeper whose judge must be noticed, relatively.
const MUTATED: f64 = 1.0 + 1e-9;

/// Rays that a mutated judge is given in each scene.
const MUTATED_RAYS: usize = 4_500;

/// Arguments of `judge`.
#[derive(Args)]
pub struct Arguments {
    /// Rays in all scenes together, each asked for front sides and for both
    #[arg(long, default_value_t = 1_000_000,
        value_parser = clap::value_parser!(u32).range(9..=1_000_000_000))]
    rays: u32,
}

/// Prints the tables, and fails where an answer is wrong or a mutated judge is not noticed.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let scenes = scenes::all();
    let count = (arguments.rays as usize).div_ceil(scenes.len());
    let mut by_scene = table(&["scene", "rays", "hits", "proved", "grazing", "wrong", "wrong of a mutant"]);
    let (mut all, mut unnoticed) = (Tally::default(), Vec::new());
    let start = Instant::now();
    let progress = ProgressBar::new(scenes.len() as u64);
    for scene in scenes {
        let groups = tessellate(&scene.sheet, DIVISIONS);
        let tally = compare(&scene, &groups, count, &first_hit(&judge_of(&scene.sheet)));
        let mutant = mutated(&scene.sheet)?;
        let mutant = compare(&scene, &groups, MUTATED_RAYS, &first_hit(&mutant)).faults.len();
        let [rays, hits, proved, grazing] = cells(tally.all());
        let wrong = tally.faults.len().to_string();
        by_scene.add_row([scene.name.clone(), rays, hits, proved, grazing, wrong, mutant.to_string()]);
        print_faults(&scene, &tally);
        if mutant == 0 {
            unnoticed.push(scene.name);
        }
        all = all.plus(tally);
        progress.inc(1);
    }
    progress.finish_and_clear();
    let mut by_kind = table(&["rays of all scenes", "rays", "hits", "proved", "grazing", "wrong"]);
    for (name, counts) in KINDS.into_iter().zip(all.kinds) {
        let [rays, hits, proved, grazing] = cells(counts);
        let wrong = all.faults.iter().filter(|(kind, ..)| *kind == name).count();
        by_kind.add_row([name.to_owned(), rays, hits, proved, grazing, wrong.to_string()]);
    }
    println!("{by_scene}\n\n{by_kind}\n");
    println!(
        "{} rays, each asked for front sides and for both, in {:.0} s: {} wrong answers.",
        all.all().rays,
        start.elapsed().as_secs_f64(),
        all.faults.len()
    );
    if !unnoticed.is_empty() {
        println!(
            "A judge of a relief that is {MUTATED} times as deep is not noticed: {}",
            unnoticed.join(", ")
        );
    }
    let good = all.faults.is_empty() && unnoticed.is_empty();
    Ok(if good { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The judge of a relief that is a little deeper.
fn mutated(sheet: &Sheet) -> Result<DisplacedMesh, String> {
    let Sheet { mesh, map, scale_m, bias_m, .. } = sheet;
    DisplacedMesh::new(mesh, map, scale_m * MUTATED, *bias_m).map_err(|error| error.to_string())
}

fn cells(counts: Counts) -> [String; 4] {
    let Counts { rays, hits, proved, grazing } = counts;
    [rays, hits, proved, grazing].map(|count| count.to_string())
}

/// The first faults of a scene.
fn print_faults(scene: &Scene, tally: &Tally) {
    for (kind, sides, fault) in tally.faults.iter().take(3) {
        let sides = if *sides == Sides::Front { "front sides" } else { "both sides" };
        println!("{}: a ray {kind}, {sides}: {fault:?}", scene.name);
    }
}
