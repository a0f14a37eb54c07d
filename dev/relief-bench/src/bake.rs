//! `bake`: the time of every kind of map, on one and two threads, and what brute force would take.

use std::time::Instant;

use clap::Args;
use comfy_table::Table;
use comfy_table::presets::ASCII_MARKDOWN;
use rayon::ThreadPoolBuilder;
use relief::{HeightMap, Wrap};
use relief_bake::{KINDS, Kind, Metric, Progress, Sink, SinkError, Texture, bake};
use relief_tests::brute;
use relief_tests::maps::fractal;

/// Depth of the relief in tiles.
const SCALE_M: f64 = 0.1;

/// Radius of the brute-force window, in texels: the kind's default.
const RADIUS: u32 = 8;

/// What `bake` is given.
#[derive(Args)]
pub struct Arguments {
    /// Sides of the maps, in texels
    #[arg(long, value_delimiter = ',', default_values_t = [256, 512, 1024])]
    sizes: Vec<u32>,
    /// Kinds [default: all]
    #[arg(long, value_delimiter = ',')]
    kinds: Vec<String>,
    /// Runs of each; the median counts
    #[arg(long, default_value_t = 3)]
    runs: usize,
    /// Side of the map that brute force is run on; its time at the other sizes follows from its texel pairs. 0 leaves it
    /// out
    #[arg(long, default_value_t = 128)]
    brute_size: u32,
}

/// Takes textures and forgets them, so that only the bake is timed.
struct Nowhere;

impl Sink for Nowhere {
    fn begin(&mut self, _: &Texture) -> Result<(), SinkError> {
        Ok(())
    }

    fn slice(&mut self, planes: &[&[f32]]) -> Result<(), SinkError> {
        std::hint::black_box(planes);
        Ok(())
    }
}

/// Prints the table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let kinds = chosen(&arguments.kinds)?;
    let metric = Metric::unit_tile(SCALE_M).map_err(|error| error.to_string())?;
    let mut table = Table::new();
    table.load_style(ASCII_MARKDOWN).set_header([
        "kind",
        "size",
        "1 thread ms",
        "2 threads ms",
        "exponent of time over texels",
        "brute force ms, 2 threads",
        "lead over brute force",
    ]);
    for kind in kinds {
        let brute = match arguments.brute_size {
            0 => None,
            side => brute_ms(kind.name, &ground(side)?).map(|ms| (side, ms)),
        };
        let mut before: Option<(u32, f64)> = None;
        for &side in &arguments.sizes {
            let map = ground(side)?;
            let one = median_ms(kind, &map, metric, 1, arguments.runs)?;
            let two = median_ms(kind, &map, metric, 2, arguments.runs)?;
            let exponent = before
                .map(|(smaller, ms)| (two / ms).ln() / (2.0 * (f64::from(side) / f64::from(smaller)).ln()));
            let expected = brute
                .map(|(measured, ms)| ms * (f64::from(side) / f64::from(measured)).powi(growth(kind.name)));
            let shown = |value: Option<f64>, digits: usize| {
                value.map_or("-".to_owned(), |value| format!("{value:.digits$}"))
            };
            table.add_row([
                kind.name.to_owned(),
                format!("{side}²"),
                format!("{one:.1}"),
                format!("{two:.1}"),
                shown(exponent, 2),
                shown(expected, 0),
                shown(expected.map(|ms| ms / two), 0),
            ]);
            before = Some((side, two));
        }
    }
    println!("Natural ground that tiles; relief {SCALE_M} of the tile; medians of {} runs.", arguments.runs);
    if arguments.brute_size > 0 {
        println!(
            "Brute force was run at {0}² and extrapolated to the other sizes by its work.",
            arguments.brute_size
        );
    }
    println!("\n{table}");
    Ok(())
}

fn chosen(names: &[String]) -> Result<Vec<&'static Kind>, String> {
    if names.is_empty() {
        return Ok(KINDS.iter().collect());
    }
    names.iter().map(|name| relief_bake::kind(name).map_err(|error| error.to_string())).collect()
}

fn ground(side: u32) -> Result<HeightMap, String> {
    let map = HeightMap::new(side, side, fractal(7, side, side, 0.5), Wrap::Repeat);
    map.and_then(|map| map.with_displacement(SCALE_M, -SCALE_M)).map_err(|error| error.to_string())
}

fn median_ms(
    kind: &Kind,
    map: &HeightMap,
    metric: Metric,
    threads: usize,
    runs: usize,
) -> Result<f64, String> {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build().map_err(|error| error.to_string())?;
    let settings = kind.defaults();
    let mut times = Vec::new();
    for _ in 0..runs.max(1) {
        let started = Instant::now();
        pool.install(|| bake(kind, map, metric, &settings, &Progress::none(), &mut Nowhere))
            .map_err(|error| error.to_string())?;
        times.push(started.elapsed().as_secs_f64() * 1e3);
    }
    times.sort_unstable_by(f64::total_cmp);
    Ok(times[times.len() / 2])
}

/// Time of the kind's brute force, on all threads; `None` for kinds whose brute force is written for single texels.
fn brute_ms(kind: &str, map: &HeightMap) -> Option<f64> {
    let texel_m = [1.0 / f64::from(map.width()), 1.0 / f64::from(map.height())];
    let started = Instant::now();
    match kind {
        "cone" => drop(std::hint::black_box(brute::cone::slopes(map, texel_m, true))),
        "dilation-erosion" => drop(std::hint::black_box(brute::dilation_erosion::window_bounds(map, RADIUS))),
        "frustum" => {
            for forward in [[false, false], [true, false], [false, true], [true, true]] {
                std::hint::black_box(brute::frustum::least_slopes(map, forward));
            }
        }
        "distance" => {
            for slice in 0..64 {
                let level = (f64::from(slice) + 0.5) / 64.0;
                std::hint::black_box(brute::distance::boxes(map, [1.0, 1.0], SCALE_M, level));
            }
        }
        _ => return None,
    }
    Some(started.elapsed().as_secs_f64() * 1e3)
}

/// How brute force grows with the side: with an early out it looks as far as the relief is high, which is a number of
/// texels that grows with the side, so that every texel looks at a square of it; a window stays as it is.
fn growth(kind: &str) -> i32 {
    if kind == "dilation-erosion" { 2 } else { 4 }
}
