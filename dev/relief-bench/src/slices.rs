//! `slices`: slices through the relief beside the truth, on planes and on a torus, and what they cost.

use std::sync::Arc;

use clap::Args;
use relief_core::HeightMap;
use relief_scene::BackendChoice;
use relief_tests::accuracy::maps;
use relief_tests::slices::PlaneView;

use crate::compare::maps::rock;
use crate::table::table;

mod torus;

/// Arguments of `slices`.
#[derive(Args)]
pub struct Arguments {
    /// Width and height of the pictures
    #[arg(long, default_value_t = 240)]
    width: u32,
    /// Displacement in metres, on a plane of a metre
    #[arg(long, default_value_t = 0.15)]
    scale: f64,
    /// On a torus of 32x16 quads in place of the plane
    #[arg(long)]
    torus: bool,
    /// Time pictures of a torus of 25x25 quads in place of comparing any
    #[arg(long)]
    times: bool,
    /// Time a GPU, too
    #[arg(long)]
    gpu: bool,
    /// Pictures that are timed of each; the median counts
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u32).range(1..=1000))]
    rounds: u32,
}

/// The ways to slice.
const METHODS: [&str; 3] = ["slices-surface", "slices-orthogonal", "slices-screen"];

/// Degrees from the normal.
const DEGREES: [f64; 3] = [20.0, 60.0, 80.0];

/// Slices over the displacement, and steps of false position.
const COUNTS: [(u32, u32); 5] = [(16, 0), (16, 1), (64, 0), (128, 0), (256, 0)];

/// The part of the way to the middle by which the eye comes nearer, to see whether slices jump.
const DOLLY: f64 = 0.001;

/// Prints the table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    if arguments.times {
        return torus::times(arguments);
    }
    if arguments.torus { torus::errors(arguments) } else { on_planes(arguments) }
}

/// The maps that are looked at.
fn all_maps() -> Result<Vec<(&'static str, HeightMap)>, String> {
    let shipped = maps().into_iter().filter(|map| ["cobbles", "spikes"].contains(&map.name));
    let rock = rock()?.map(|map| ("rock023", map));
    Ok(shipped.map(|named| (named.name, named.map)).chain(rock).collect())
}

fn on_planes(arguments: &Arguments) -> Result<(), String> {
    let mut rows = table(&[
        "map",
        "degrees",
        "method",
        "slices",
        "steps",
        "through %",
        "late %",
        "median",
        "p99",
        "fragments",
        "median x fragments",
        "jump %",
    ]);
    for (name, map) in all_maps()? {
        let map = map.with_displacement(arguments.scale, -arguments.scale);
        let map = Arc::new(map.map_err(|error| error.to_string())?);
        for degrees in DEGREES {
            let view = PlaneView { map: &map, degrees, away_m: 2.0, size: arguments.width };
            let nearer = PlaneView { away_m: 2.0 * (1.0 - DOLLY), ..view };
            let [truth, truth_after] = [view, nearer].map(|of| of.pixels("exact", &[], BackendChoice::Cpu));
            for (method, (count, steps)) in METHODS.iter().flat_map(|method| COUNTS.map(|of| (*method, of))) {
                let set = [("slices.count", f64::from(count)), ("slices.refine", f64::from(steps))];
                let slices = view.pixels(method, &set, BackendChoice::Cpu);
                let after = nearer.pixels(method, &set, BackendChoice::Cpu);
                let along_m = view.along_m(method, f64::from(count).recip());
                let errors = view.errors(&truth, &slices, along_m);
                let jumps = view.jumps([&truth, &slices], [&truth_after, &after], along_m);
                let fragments = view.fragments(&truth, view.settings(method, count));
                rows.add_row([
                    name.to_owned(),
                    format!("{degrees}"),
                    method.to_owned(),
                    count.to_string(),
                    steps.to_string(),
                    format!("{:.2}", 100.0 * errors.see_through),
                    format!("{:.2}", 100.0 * errors.late),
                    format!("{:.3}", errors.median),
                    format!("{:.2}", errors.p99),
                    format!("{fragments:.1}"),
                    format!("{:.1}", errors.median * fragments),
                    format!("{:.1}", 100.0 * jumps),
                ]);
            }
        }
    }
    println!("{rows}");
    Ok(())
}
