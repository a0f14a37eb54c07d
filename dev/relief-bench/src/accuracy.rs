//! `accuracy`: every method on five maps at four angles, beside the exact answer.

use clap::Args;
use comfy_table::Table;
use relief_shaders::{METHODS, Selection};
use relief_tests::accuracy::{ANGLES, Case, Named, maps};
use relief_tests::baked::{maps_for, slots};
use relief_tests::claims::{Measure, verdicts};

use crate::table::table;

/// What `accuracy` is given.
#[derive(Args)]
pub struct Arguments {
    /// Rays a map and angle
    #[arg(long, default_value_t = 20_000)]
    rays: usize,
}

/// Prints the tables.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let maps = maps();
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
    println!("What the survey says of the order\n{}", order(&maps, arguments.rays));
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
    let cases: Vec<Case> = ANGLES.iter().map(|&degrees| Case::new(&named.map, degrees, rays)).collect();
    for method in METHODS {
        let selection = Selection::of(method).map_err(|error| error.to_string())?;
        let baked = maps_for(&named.map, &selection);
        let maps = slots(&named.map, &selection, &baked);
        for (case, degrees) in cases.iter().zip(ANGLES) {
            let report = case.report_with(&selection, &maps);
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

fn order(maps: &[Named], rays: usize) -> Table {
    let mut table =
        table(&["section", "claim", "nearer", "farther", "measure", "nearer's", "farther's", "verdict"]);
    for verdict in verdicts(maps, rays) {
        let claim = verdict.claim;
        let measure = match claim.measure {
            Measure::Median => "median texels",
            Measure::Tail => "p99 texels",
            Measure::Passed => "passed, share",
        };
        table.add_row([
            claim.section.to_owned(),
            claim.text.to_owned(),
            claim.better.to_string(),
            claim.worse.to_string(),
            measure.to_owned(),
            format!("{:.5}", verdict.better),
            format!("{:.5}", verdict.worse),
            if verdict.holds() { "holds" } else { "refuted" }.to_owned(),
        ]);
    }
    table
}
