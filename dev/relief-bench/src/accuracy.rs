//! `accuracy`: every method on five maps at four angles, beside the exact answer, and what the searches cost.

use clap::Args;
use comfy_table::Table;
use relief_compare::Case;
use relief_compare::rays::{PICTURE, picture_paths};
use relief_core::metrics::{CostReport, CostSpread};
use relief_shaders::{METHODS, Selection};
use relief_tests::accuracy::{ANGLES, Named, case, maps, picture_cost, report_with};
use relief_tests::baked::{maps_for, slots};

use crate::table::table;

/// Arguments of `accuracy`.
#[derive(Args)]
pub struct Arguments {
    /// Rays a map and angle
    #[arg(long, default_value_t = 20_000)]
    rays: usize,
}

/// Prints the tables.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let maps = maps();
    costs(&maps)?;
    println!("{} rays a map and angle; relief as deep as a tenth of the tile.\n", arguments.rays);
    for named in &maps {
        println!(
            "{} ({}x{})\n{}\n",
            named.name,
            named.map.width(),
            named.map.height(),
            methods(named, arguments.rays)?
        );
    }
    println!(
        "Doubling the linear steps: mean error in texels over all maps and angles\n{}\n",
        doubling(&maps, arguments.rays)?
    );
    Ok(())
}

fn methods(named: &Named, rays: usize) -> Result<Table, String> {
    let mut table = table(&[
        "method",
        "angle",
        "reads",
        "miss %",
        "false %",
        "late %",
        "early %",
        "median texels",
        "p99 texels",
    ]);
    let cases: Vec<Case> = ANGLES.iter().map(|&degrees| case(&named.map, degrees, rays)).collect();
    // Displaced triangles search nothing.
    for method in METHODS.iter().filter(|method| method.geometry == "none") {
        let selection = Selection::of(method).map_err(|error| error.to_string())?;
        let baked = maps_for(&named.map, &selection);
        let maps = slots(&named.map, &selection, &baked);
        for (case, degrees) in cases.iter().zip(ANGLES) {
            let report = report_with(case, &selection, &maps);
            let percent = |share: f64| format!("{:.2}", share * 100.0);
            table.add_row([
                method.name.to_owned(),
                format!("{degrees}"),
                format!("{:.1}", report.mean_reads),
                percent(report.missed),
                percent(report.false_hits),
                percent(report.late),
                percent(report.early),
                format!("{:.4}", report.distance_texels.median),
                format!("{:.3}", report.distance_texels.p99),
            ]);
        }
    }
    Ok(table)
}

/// The searches that find the first hit, each refined by `patch`.
const SEARCHES: [&str; 8] = [
    "cells",
    "dilation-erosion",
    "sphere",
    "relaxed-cone",
    "cone",
    "pyramid",
    "frustum",
    "relaxed-cone-resting",
];

/// Angle at which costs are reported.
const GRAZING: f64 = 85.0;

/// Searches whose costs are compared: of the first, divided by the second's.
const RATIOS: [[&str; 2]; 4] = [
    ["pyramid", "cells"],
    ["frustum", "pyramid"],
    ["relaxed-cone", "cone"],
    ["relaxed-cone-resting", "cone"],
];

/// A number that a ray costs, by name.
type Quantity = (&'static str, fn(&CostReport) -> CostSpread);

const QUANTITIES: [Quantity; 3] =
    [("reads", |report| report.reads), ("steps", |report| report.steps), ("bytes", |report| report.bytes)];

/// Prints what the searches cost at a grazing angle, and how they compare.
fn costs(maps: &[Named]) -> Result<(), String> {
    let mut reports = Vec::new();
    for search in SEARCHES {
        let selection = Selection::pair(search, "patch").map_err(|error| error.to_string())?;
        let of = |named: &Named| picture_cost(&named.map, &selection, &picture_paths(&named.map, GRAZING));
        reports.push((search, maps.iter().map(of).collect::<Vec<_>>()));
    }
    let [columns, rows] = PICTURE;
    println!(
        "Costs of a ray at {GRAZING} degrees, in pictures of {columns} x {rows} pixels from eight sides: \
         mean / 99th percentile / mean of the greatest in a tile of 8 x 4 pixels\n"
    );
    let names: Vec<&str> = maps.iter().map(|named| named.name).collect();
    for (quantity, spread) in QUANTITIES {
        let mut table = table(&[&[quantity], &names[..]].concat());
        for (search, reports) in &reports {
            let of = |report: &CostReport| {
                let CostSpread { mean, p99, wave } = spread(report);
                if quantity == "bytes" {
                    format!("{mean:.0} / {p99:.0} / {wave:.0}")
                } else {
                    format!("{mean:.1} / {p99:.0} / {wave:.1}")
                }
            };
            table.add_row([(*search).to_owned()].into_iter().chain(reports.iter().map(of)));
        }
        println!("{table}\n");
    }
    println!(
        "The same of one search over another's, mean / greatest in a tile\n{}\n",
        ratios(&names, &reports)
    );
    Ok(())
}

fn ratios(names: &[&str], reports: &[(&str, Vec<CostReport>)]) -> Table {
    let mut table = table(&[&["over", "of"], names].concat());
    let of =
        |search| reports.iter().find(|(name, _)| *name == search).map_or(&[][..], |(_, reports)| reports);
    for [search, other] in RATIOS {
        for (quantity, spread) in QUANTITIES {
            let ratio = |(a, b): (&CostReport, &CostReport)| {
                let (a, b) = (spread(a), spread(b));
                format!("{:.2} / {:.2}", a.mean / b.mean, a.wave / b.wave)
            };
            let row = [format!("{search} / {other}"), quantity.to_owned()];
            table.add_row(row.into_iter().chain(of(search).iter().zip(of(other)).map(ratio)));
        }
    }
    table
}

/// Steps 8 to 512 of the two methods that begin with linear search.
fn doubling(maps: &[Named], rays: usize) -> Result<Table, String> {
    let mut table = table(&[
        "steps",
        "relief mean texels",
        "relief passed %",
        "occlusion mean texels",
        "occlusion passed %",
    ]);
    for steps in [8, 16, 32, 64, 128, 256, 512] {
        let mut row = vec![steps.to_string()];
        for method in ["relief", "occlusion"] {
            let (error, passed) = relief_tests::accuracy::mean_error(maps, method, steps, rays)?;
            row.extend([format!("{error:.4}"), format!("{:.3}", passed * 100.0)]);
        }
        table.add_row(row);
    }
    Ok(table)
}
