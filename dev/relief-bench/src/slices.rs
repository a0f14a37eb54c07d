//! `slices`: slices through the relief beside the truth, on planes.

use std::sync::Arc;

use clap::Args;
use relief_core::{HeightMap, Wrap};
use relief_io::{HeightOptions, read_height};
use relief_render::scene::BackendChoice;
use relief_tests::accuracy::maps;
use relief_tests::slices::PlaneView;

use crate::table::table;

/// What `slices` is given.
#[derive(Args)]
pub struct Arguments {
    /// Width and height of the pictures
    #[arg(long, default_value_t = 240)]
    width: u32,
    /// Displacement in metres, on a plane of a metre
    #[arg(long, default_value_t = 0.15)]
    scale: f64,
}

const METHODS: [&str; 3] = ["slices-surface", "slices-orthogonal", "slices-screen"];

/// Degrees from the normal.
const DEGREES: [f64; 3] = [20.0, 60.0, 80.0];

/// Slices over the displacement, and steps of false position.
const COUNTS: [(u32, u32); 5] = [(16, 0), (16, 1), (64, 0), (128, 0), (256, 0)];

/// A map of the folder of the variable `RELIEF_DATA`, where it is set.
fn of_data(file: &str) -> Option<HeightMap> {
    let path = std::path::Path::new(&std::env::var_os("RELIEF_DATA")?).join(file);
    let options = HeightOptions { wrap: Some(Wrap::Repeat), ..HeightOptions::default() };
    read_height(&path, &options).ok()
}

/// Prints the table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let shipped = maps().into_iter().filter(|map| ["cobbles", "spikes"].contains(&map.name));
    let rock = of_data("rock023_alb_ht.png").map(|map| ("rock023", map));
    let all: Vec<(&str, HeightMap)> = shipped.map(|named| (named.name, named.map)).chain(rock).collect();
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
    ]);
    for (name, map) in all {
        let map = map.with_displacement(arguments.scale, -arguments.scale);
        let map = Arc::new(map.map_err(|error| error.to_string())?);
        for degrees in DEGREES {
            let view = PlaneView { map: &map, degrees, size: arguments.width };
            let truth = view.pixels("exact", &[], BackendChoice::Cpu);
            for (method, (count, steps)) in METHODS.iter().flat_map(|method| COUNTS.map(|of| (*method, of))) {
                let set = [("slices.count", f64::from(count)), ("slices.refine", f64::from(steps))];
                let slices = view.pixels(method, &set, BackendChoice::Cpu);
                let errors = view.errors(&truth, &slices, view.along_m(method, f64::from(count).recip()));
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
                ]);
            }
        }
    }
    println!("{rows}");
    Ok(())
}
