//! `claims`: what the papers say of the methods, one by one, and whether it holds on five maps.

use clap::Args;
use relief_tests::accuracy::maps;
use relief_tests::claims::verdicts;

use crate::table::table;

/// What `claims` is given.
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
    Ok(())
}
