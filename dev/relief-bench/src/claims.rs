//! `claims`: what the papers say of the methods, one by one, and whether it holds on five maps.

use clap::Args;
use relief_tests::accuracy::maps;
use relief_tests::claims::{PictureVerdict, picture_verdicts, verdicts};

use crate::table::table;

/// Arguments of `claims`.
#[derive(Args)]
pub struct Arguments {
    /// Rays a map and angle
    #[arg(long, default_value_t = 20_000)]
    rays: usize,
}

/// Prints the table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let mut rows = table(&[
        "paper", "section", "claim", "less", "more", "measure", "angles", "scale m", "less has", "more has",
        "at most", "verdict",
    ]);
    for verdict in verdicts(&maps(), arguments.rays) {
        let claim = verdict.claim;
        let angles: Vec<String> = claim.angles.iter().map(f64::to_string).collect();
        let figure =
            |figure: f64| if figure >= 1000.0 { format!("{figure:.0}") } else { format!("{figure:.5}") };
        rows.add_row([
            claim.paper.to_owned(),
            claim.section.to_owned(),
            claim.text.to_owned(),
            claim.better.to_string(),
            claim.worse.to_string(),
            claim.measure.name().to_owned(),
            angles.join(", "),
            claim.scale_m.to_string(),
            figure(verdict.better),
            figure(verdict.worse),
            figure(claim.factor * verdict.worse),
            if verdict.holds() { "holds" } else { "refuted" }.to_owned(),
        ]);
    }
    println!("{} rays a map and angle; means over five maps and the angles.\n\n{rows}", arguments.rays);
    println!("\nKautz and Seidel 2001, on pictures.\n\n{}", of_pictures());
    Ok(())
}

/// The table of what is found on pictures.
fn of_pictures() -> comfy_table::Table {
    let mut rows =
        table(&["section", "claim", "less", "more", "measure", "less has", "more has", "at most", "verdict"]);
    for verdict in picture_verdicts() {
        let PictureVerdict { claim, figures: [less, more] } = verdict;
        rows.add_row([
            claim.section.to_owned(),
            claim.text.to_owned(),
            claim.of[0].to_owned(),
            claim.of[1].to_owned(),
            claim.measure.to_owned(),
            format!("{less:.4}"),
            format!("{more:.4}"),
            format!("{:.4}", claim.factor * more),
            if verdict.holds() { "holds" } else { "refuted" }.to_owned(),
        ]);
    }
    rows
}
