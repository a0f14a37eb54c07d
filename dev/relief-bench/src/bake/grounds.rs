//! Times on ground where much is equally steep or equally high, beside those on natural ground: where a
//! search cannot tell places apart it passes over none.

use clap::ValueEnum;
use relief_core::{HeightMap, Wrap};
use relief_testing::maps::fractal;

use super::{Arguments, SCALE_M, Variant, measure, metric, pool, slope, table};

/// Sorts of ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Ground {
    /// Fractal noise that tiles
    Natural,
    /// Inclined along both axes
    Plane,
    /// Inclined along one axis
    Ramp,
    /// Inclined along the other axis
    Down,
    /// Inclined as much along both axes
    Diagonal,
    /// Inclined towards the middle along one axis
    Valley,
    /// A ramp of 64 heights
    Staircase,
    /// A ramp of 256 heights
    Levels,
    /// Sixteen level steps
    Terraces,
    /// A four-sided pyramid
    Pyramid,
    /// One texel above level ground
    Spike,
    /// Level
    Constant,
}

impl Ground {
    /// A map of that ground.
    pub fn map(self, side: u32, wrap: Wrap) -> Result<HeightMap, String> {
        let last = f64::from(side - 1).max(1.0);
        // From 0 to 1 along the axes.
        let place = |i: u32, j: u32| [i, j].map(|k| f64::from(k) / last);
        let height = |i: u32, j: u32| {
            let [x, y] = place(i, j);
            match self {
                Ground::Natural | Ground::Constant => 0.5,
                Ground::Plane => (2.0 * x + y) / 3.0,
                Ground::Ramp => x,
                Ground::Down => y,
                Ground::Diagonal => 0.5 * (x + y),
                Ground::Valley => (2.0 * x - 1.0).abs(),
                Ground::Staircase => (63.0 * x).floor() / 63.0,
                Ground::Levels => (255.0 * x).round() / 255.0,
                Ground::Terraces => f64::from(16 * i / side) / 15.0,
                Ground::Pyramid => 1.0 - (2.0 * x - 1.0).abs().max((2.0 * y - 1.0).abs()),
                Ground::Spike => f64::from([i, j] == [side / 3, side / 2]),
            }
        };
        let map = match self {
            Ground::Natural => HeightMap::new(side, side, fractal(7, side, side, 0.5), wrap),
            _ => HeightMap::from_fn(side, side, wrap, |i, j| height(i, j) as f32),
        };
        map.and_then(|map| map.with_displacement(SCALE_M, -SCALE_M)).map_err(|error| error.to_string())
    }

    fn name(self) -> String {
        self.to_possible_value().map_or_else(String::new, |value| value.get_name().to_owned())
    }
}

/// Prints a table of all grounds that are asked for, for each wrap.
pub fn run(arguments: &Arguments, variants: &[Variant]) -> Result<(), String> {
    arguments.wrap.iter().try_for_each(|wrap| table_of(arguments, variants, *wrap))
}

fn table_of(arguments: &Arguments, variants: &[Variant], wrap: Wrap) -> Result<(), String> {
    let mut sizes = arguments.sizes.clone();
    sizes.sort_unstable();
    let pool = pool(1)?;
    let mut header = vec!["kind".to_owned(), "ground".to_owned()];
    header.extend(sizes.iter().map(|side| format!("{side}² ms")));
    header.extend(sizes.iter().map(|side| format!("{side}²: times natural")));
    header.push("exponent".to_owned());
    let mut times = table(&header.iter().map(String::as_str).collect::<Vec<_>>());
    for variant in variants {
        let mut natural: Vec<f64> = Vec::new();
        let others = arguments.ground.iter().copied().filter(|ground| *ground != Ground::Natural);
        for ground in std::iter::once(Ground::Natural).chain(others) {
            let mut found: Vec<f64> = Vec::new();
            for &side in &sizes {
                eprintln!("{} {} {side}² {wrap}", variant.name, ground.name());
                let map = ground.map(side, wrap)?;
                let (kind, settings) = (variant.kind, &variant.settings);
                let once_s = 0.1 * arguments.limit;
                let measured =
                    measure::measure(kind, &map, metric()?, settings, &pool, arguments.runs, once_s)?;
                found.push(measured.cpu_ms);
                if 1e-3 * measured.cpu_ms > arguments.limit {
                    break;
                }
            }
            if ground == Ground::Natural {
                natural.clone_from(&found);
            }
            let mut cells = vec![variant.name.clone(), ground.name()];
            let at = |place: usize, text: fn(f64, f64) -> String| match (found.get(place), natural.get(place))
            {
                (Some(&ms), Some(&natural)) => text(ms, natural),
                _ => "-".to_owned(),
            };
            cells.extend((0..sizes.len()).map(|place| at(place, |ms, _| format!("{ms:.1}"))));
            cells.extend(
                (0..sizes.len()).map(|place| at(place, |ms, natural| format!("{:.2}", ms / natural))),
            );
            let points: Vec<(f64, f64)> =
                sizes.iter().zip(&found).map(|(&side, ms)| (2.0 * f64::from(side).ln(), ms.ln())).collect();
            cells.push(if points.len() > 1 { format!("{:.2}", slope(&points)) } else { "-".to_owned() });
            times.add_row(cells);
        }
    }
    println!("Wrap {wrap}; processor time of the bake on one thread.\n\n{times}\n");
    Ok(())
}
