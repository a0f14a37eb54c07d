//! `probe`: attacks on the promises of baked maps, as the tests make them, but as many as there is time for.

use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use relief_core::registry::UnknownName;
use relief_tests::probes::run::{self, Case, KINDS, MAPS};

use crate::table::table;

/// Arguments of `probe`.
#[derive(Args)]
pub struct Arguments {
    /// Kinds [default: all that promise something to one side]
    #[arg(long, value_delimiter = ',')]
    kinds: Vec<String>,
    /// Probes of each map at each number of bits
    #[arg(long, default_value_t = 10_000_000)]
    probes: usize,
    /// Bits of the stored values; 0 for floats
    #[arg(long, value_delimiter = ',', default_values_t = [0, 8, 16])]
    bits: Vec<u32>,
}

/// Attacks, and prints the table; fails if a promise is broken.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let kinds = chosen(&arguments.kinds)?;
    let mut table = table(&["kind", "map", "wrap", "bits", "probes", "violations", "tightest", "seconds"]);
    let cases: Vec<Case> = kinds
        .iter()
        .flat_map(|kind| arguments.bits.iter().flat_map(|bits| run::cases(kind, *bits)))
        .collect();
    let bar = ProgressBar::new((cases.len() * arguments.probes) as u64);
    let style = ProgressStyle::with_template("{msg:30} {wide_bar} {percent} %, {eta} left");
    bar.set_style(style.map_err(|error| error.to_string())?);
    let mut broken = Vec::new();
    for case in &cases {
        let (map, wrap) = MAPS[case.map];
        let kind = match (case.kind, case.apex) {
            ("cone" | "relaxed-cone", 0) => format!("{} (centre)", case.kind),
            ("cone" | "relaxed-cone", _) => format!("{} (texel)", case.kind),
            (kind, _) => kind.to_owned(),
        };
        bar.set_message(format!("{kind}, {map}"));
        let started = Instant::now();
        let outcome = run::run(case, arguments.probes, &|probes| bar.inc(probes as u64))
            .map_err(|error| format!("{kind} of {map}: {error}"))?;
        table.add_row([
            kind.clone(),
            map.to_owned(),
            wrap.to_string(),
            case.bits.to_string(),
            arguments.probes.to_string(),
            outcome.violations.to_string(),
            match outcome.unit {
                run::RATIO => format!("{:.6} {}", outcome.room, outcome.unit),
                unit => format!("{:.3e} {unit}", outcome.room),
            },
            format!("{:.1}", started.elapsed().as_secs_f64()),
        ]);
        if outcome.violations > 0 {
            broken.push(format!("{kind} of {map}, {} bits: {}", case.bits, outcome.tightest));
        }
    }
    bar.finish_and_clear();
    println!(
        "Probes of stored maps against the bilinear surface. Tightest is the least room that a probe found: \
         of cones the widest safe ratio over the stored one, 1 or more; else how far the surface stayed \
         inside, 0 or more but for rounding.\n\n{table}"
    );
    for text in &broken {
        eprintln!("broken: {text}");
    }
    Ok(if broken.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn chosen(names: &[String]) -> Result<Vec<&'static str>, String> {
    if names.is_empty() {
        return Ok(KINDS.to_vec());
    }
    let find = |name: &String| KINDS.into_iter().find(|kind| kind == name);
    let kind = |name| find(name).ok_or_else(|| UnknownName::new("kind to probe", name, KINDS).to_string());
    names.iter().map(kind).collect()
}
