//! `bake`: time and memory of every kind of map, and what brute force would take.

mod brute;
mod grounds;
mod measure;
mod python;

use std::path::PathBuf;
use std::process::ExitCode;

use clap::Args;
use rayon::ThreadPool;
use relief_bake::{KINDS, Kind, Settings};
use relief_core::{HeightMap, Metric, Wrap};

use self::brute::Brute;
use self::grounds::Ground;
use self::measure::Measured;

use crate::table::table;

/// Depth of the relief in tiles.
const SCALE_M: f64 = 0.1;

/// Growth of the time that is reckoned with before a larger map is measured, over texels.
const EXPECTED_EXPONENT: f64 = 1.15;

/// Arguments of `bake`.
#[derive(Args)]
pub struct Arguments {
    /// Sides of the maps, in texels
    #[arg(long, value_delimiter = ',', default_values_t = [256, 512, 1024, 2048, 4096])]
    sizes: Vec<u32>,
    /// Kinds [default: all]
    #[arg(long, value_delimiter = ',')]
    kinds: Vec<String>,
    /// Bits of the stored values: 8 or 16, 0 for floats
    #[arg(long, default_value_t = 0)]
    bits: u32,
    /// Runs of each, and as many more as take 50 ms together; the median counts
    #[arg(long, default_value_t = 3)]
    runs: usize,
    /// A map that would take longer than this on one thread is left out, and larger ones too; one that takes
    /// more than a tenth of it is run once
    #[arg(long, default_value_t = 60.0, value_name = "SECONDS")]
    limit: f64,
    /// How long brute force may take at each size: then the time of the texels that were done counts for all.
    /// 0 leaves it out
    #[arg(long, default_value_t = 1.5, value_name = "SECONDS")]
    brute: f64,
    /// Measure these sorts of ground beside natural ground, instead of the tables of all kinds. A size that
    /// takes longer than the limit is the last one
    #[arg(long, value_enum, value_delimiter = ',')]
    ground: Vec<Ground>,
    /// How these maps go on beyond their edges: a table for each
    #[arg(long, value_delimiter = ',', default_values_t = Wrap::ALL)]
    wrap: Vec<Wrap>,
    /// A Python with numpy, edt and topocalc: times distance and horizon beside these two
    #[arg(long, value_name = "PYTHON")]
    beside_python: Option<PathBuf>,
}

/// What is measured: a kind with its default settings, but for what the name says.
struct Variant {
    name: String,
    kind: &'static Kind,
    settings: Settings,
}

/// One row of the table.
struct Row {
    side: u32,
    /// Milliseconds on one thread and on two, and of processor time on one.
    ms: [f64; 3],
    /// Memory of input, output and everything between, over input and output.
    memory: f64,
    brute: Option<Brute>,
    /// Of cones one that looks at texels only.
    at_texels: Option<Brute>,
}

/// Prints the tables.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    if let Some(code) = measure::with_fresh_memory()? {
        return Ok(code);
    }
    let variants = variants(&chosen(&arguments.kinds)?, arguments.bits)?;
    if !arguments.ground.is_empty() {
        return grounds::run(arguments, &variants).map(|()| ExitCode::SUCCESS);
    }
    let pools = [pool(1)?, pool(2)?];
    if let Some(python) = &arguments.beside_python {
        return python::run(python, &arguments.sizes, &pools[0]).map(|()| ExitCode::SUCCESS);
    }
    let mut times = table(&[
        "kind",
        "size",
        "1 thread ms",
        "2 threads ms",
        "processor ms",
        "memory / (input + output)",
        "brute force s, 2 threads",
        "texels done",
        "lead over brute force",
    ]);
    let mut growth = table(&["kind", "sizes", "1 thread", "2 threads", "processor time"]);
    let mut at_texels = table(&["kind", "size", "brute force s, 2 threads", "texels done", "lead over it"]);
    let mut left_out = Vec::new();
    for variant in &variants {
        let rows = rows(variant, arguments, &pools, &mut left_out)?;
        for row in &rows {
            times.add_row(row.cells(&variant.name));
            if let Some(brute) = &row.at_texels {
                let [seconds, share, lead] = brute.cells(row.ms[1]);
                at_texels.add_row([variant.name.clone(), format!("{}²", row.side), seconds, share, lead]);
            }
        }
        if let [first, .., last] = rows.as_slice() {
            let exponent = |which: usize| {
                let points = rows.iter().map(|row| (2.0 * f64::from(row.side).ln(), row.ms[which].ln()));
                format!("{:.2}", slope(&points.collect::<Vec<_>>()))
            };
            growth.add_row([
                variant.name.clone(),
                format!("{}² to {}²", first.side, last.side),
                exponent(0),
                exponent(1),
                exponent(2),
            ]);
        }
    }
    println!(
        "Natural ground that tiles; relief {SCALE_M} of the tile; {} bits; medians of {} runs or more, of \
         slow bakes one run.",
        if arguments.bits == 0 { "32".to_owned() } else { arguments.bits.to_string() },
        arguments.runs
    );
    println!("Every bake takes fresh memory from the system, as the first one of a program does.");
    println!(
        "Processor time is what a bake takes on one thread; memory is the peak of what is allocated, on two \
         threads."
    );
    for text in left_out {
        println!("{text}");
    }
    if arguments.brute > 0.0 {
        println!(
            "Brute force is parallel and ends early where nothing farther can matter. It was run for the \
             share of the texels that is shown and extrapolated from these."
        );
    }
    println!("\n{times}\n");
    println!(
        "Exponents of time over texels, fitted by least squares to the logarithms of all sizes:\n\n{growth}"
    );
    if !at_texels.is_empty() {
        println!(
            "\n\
             Cones beside a brute force that looks at texels only, not between them, which is quicker and \
             less than the kind promises:\n\n{at_texels}"
        );
    }
    Ok(ExitCode::SUCCESS)
}

impl Row {
    fn cells(&self, name: &str) -> Vec<String> {
        let Row { side, ms: [one, two, cpu], memory, brute, .. } = self;
        let mut cells = vec![
            name.to_owned(),
            format!("{side}²"),
            format!("{one:.2}"),
            format!("{two:.2}"),
            format!("{cpu:.2}"),
            format!("{memory:.2}"),
        ];
        cells.extend(brute.as_ref().map_or(["-"; 3].map(str::to_owned), |brute| brute.cells(*two)));
        cells
    }
}

impl Brute {
    /// Returns its seconds, the share of the texels that was done, and the lead of a bake with the given
    /// milliseconds over it.
    fn cells(&self, bake_ms: f64) -> [String; 3] {
        let lead = 1e3 * self.seconds / bake_ms;
        [format!("{:.3}", self.seconds), percent(self.share), format!("{lead:.0}")]
    }
}

fn percent(share: f64) -> String {
    if share >= 1.0 { "all".to_owned() } else { format!("{:.2} %", 100.0 * share) }
}

/// Measures at every size that the limit allows.
fn rows(
    variant: &Variant,
    arguments: &Arguments,
    pools: &[ThreadPool; 2],
    left_out: &mut Vec<String>,
) -> Result<Vec<Row>, String> {
    let Variant { name, kind, settings } = variant;
    let mut sizes = arguments.sizes.clone();
    sizes.sort_unstable();
    let mut rows: Vec<Row> = Vec::new();
    for side in sizes {
        if let Some(last) = rows.last() {
            let growth = (2.0 * (f64::from(side) / f64::from(last.side)).ln() * EXPECTED_EXPONENT).exp();
            let expected = 1e-3 * last.ms[0] * growth;
            if expected > arguments.limit {
                left_out.push(format!(
                    "{name} is left out from {side}² on: about {expected:.0} s on one thread, more than \
                     --limit {}.",
                    arguments.limit
                ));
                break;
            }
        }
        eprintln!("{name} {side}²");
        let map = ground(side)?;
        let metric = metric()?;
        let measure = |pool: &ThreadPool| {
            measure::measure(kind, &map, metric, settings, pool, arguments.runs, 0.1 * arguments.limit)
        };
        let [one, two]: [Measured; 2] = [measure(&pools[0])?, measure(&pools[1])?];
        let limit_s = arguments.brute;
        let brute = (limit_s > 0.0)
            .then(|| pools[1].install(|| brute::time(kind.name, settings, &map, metric, limit_s)))
            .flatten();
        let at_texels = (limit_s > 0.0 && kind.name == "cone")
            .then(|| pools[1].install(|| brute::time_cones_at_texels(settings, &map, metric, limit_s)));
        let ms = [one.ms, two.ms, one.cpu_ms];
        rows.push(Row { side, ms, memory: two.memory, brute, at_texels });
    }
    Ok(rows)
}

/// The slope of the line through points that misses them least in the mean square.
fn slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let mean = |value: fn(&(f64, f64)) -> f64| points.iter().map(value).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let above: f64 = points.iter().map(|point| (point.0 - x) * (point.1 - y)).sum();
    above / points.iter().map(|point| (point.0 - x).powi(2)).sum::<f64>()
}

fn pool(threads: usize) -> Result<ThreadPool, String> {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().map_err(|error| error.to_string())
}

fn chosen(names: &[String]) -> Result<Vec<&'static Kind>, String> {
    if names.is_empty() {
        return Ok(KINDS.iter().collect());
    }
    names.iter().map(|name| relief_bake::kind(name).map_err(|error| error.to_string())).collect()
}

/// The kinds as they are by default; and cones with the other sort of apex, which is another search.
fn variants(kinds: &[&'static Kind], bits: u32) -> Result<Vec<Variant>, String> {
    let mut variants = Vec::new();
    for kind in kinds {
        let mut settings = kind.defaults();
        settings.set("bits", f64::from(bits)).map_err(|error| error.to_string())?;
        let apex = settings.iter().find(|setting| setting.0 == "apex").map(|setting| setting.1);
        variants.push(Variant { name: kind.name.to_owned(), kind, settings: settings.clone() });
        if let Some(apex) = apex {
            let other = 1.0 - f64::from(apex);
            settings.set("apex", other).map_err(|error| error.to_string())?;
            variants.push(Variant { name: format!("{}, apex {other}", kind.name), kind, settings });
        }
    }
    Ok(variants)
}

fn metric() -> Result<Metric, String> {
    Metric::unit_tile(SCALE_M).map_err(|error| error.to_string())
}

fn ground(side: u32) -> Result<HeightMap, String> {
    Ground::Natural.map(side, Wrap::Repeat)
}
