//! `levels`: filter levels beside the average, and beside the descent of Gumhold and Hüttner 1999.

use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use comfy_table::Table;
use rayon::prelude::*;
use relief_bake::kind::filter_levels::difference_volume;
use relief_bake::{Filter, filter_level, filter_levels};
use relief_core::{HeightMap, Watch, Wrap};
use relief_io::{HeightOptions, read_height};
use relief_testing::maps::fractal;
use relief_tests::{accuracy, data_dir};

use crate::table::table;

/// Arguments of `levels`.
#[derive(Args)]
pub struct Arguments {
    /// Side of the part of each map, from its middle, whose levels are compared
    #[arg(long, default_value_t = 256)]
    side: u32,
    /// Sides of the ground whose levels are timed
    #[arg(long, value_delimiter = ',', default_values_t = [512, 1024, 2048])]
    times: Vec<u32>,
}

/// Real maps, where there are any.
const FILES: [&str; 6] = [
    "t3d_terrain1.exr",
    "t3d_mountain1.exr",
    "t3d_stones.exr",
    "godot_wool_depth.png",
    "earth-topology.png",
    "canyon_height.jpg",
];

/// Levels that are compared.
const LEVELS: std::ops::RangeInclusive<u32> = 1..=3;

/// Steps of the descent at most, and the displacement of its derivative (section 4.2).
const DESCENT_STEPS: usize = 100;
const EPSILON: f64 = 1e-4;

/// The descent's factor at first, and where it ends: it is halved where a step would not lower the volume.
const FACTORS: [f64; 2] = [0.25, 1.0 / 16384.0];

/// Points a texel of the map along an axis, for the descent, and columns a texel for skylines.
const POINTS: u32 = 2;
const COLUMNS: u32 = 4;

/// Heights below a skyline that are rounding.
const ROUNDING: f64 = 1e-6;

/// Prints the tables.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let maps = maps(arguments.side)?;
    println!("Volume over the average's, and the average's own in heights:\n\n{}\n", volumes(&maps)?);
    println!("Columns of skylines (the highest along v) that are below the map's:\n\n{}\n", skylines(&maps)?);
    println!("Seconds for all levels of natural ground, which repeats:\n\n{}", times(&arguments.times)?);
    Ok(())
}

/// The parts of the maps, and their names.
fn maps(side: u32) -> Result<Vec<(String, HeightMap)>, String> {
    let shipped = ["cobbles.png", "bricks.png", "jacksboro.png"];
    let mut files: Vec<PathBuf> = shipped.map(|file| accuracy::sample_maps().join(file)).to_vec();
    match data_dir() {
        Some(folder) => files.extend(FILES.map(|file| folder.join(file))),
        None => eprintln!("RELIEF_DATA names no folder of real maps: only shipped ones are measured"),
    }
    let read = |file: PathBuf| {
        let map = read_height(&file, &HeightOptions::default()).map_err(|error| error.to_string())?;
        let size = [map.width(), map.height()].map(|all| all.min(side));
        let first = [map.width() - size[0], map.height() - size[1]].map(|left| i64::from(left / 2));
        let texel = |i: u32, j: u32| map.texel(first[0] + i64::from(i), first[1] + i64::from(j));
        let part =
            HeightMap::from_fn(size[0], size[1], Wrap::Clamp, texel).map_err(|error| error.to_string())?;
        Ok((file.file_stem().unwrap_or_default().to_string_lossy().into_owned(), part))
    };
    files.into_iter().map(read).collect()
}

fn made(map: &HeightMap, level: u32, filter: Filter) -> Result<HeightMap, String> {
    filter_level(map, level, filter, &Watch::none()).map_err(|error| error.to_string())
}

fn volumes(maps: &[(String, HeightMap)]) -> Result<Table, String> {
    let mut rows = table(&["map", "level", "average", "least-squares", "variational", "their descent"]);
    let mut all = [Vec::new(), Vec::new(), Vec::new()];
    for (name, map) in maps {
        for level in LEVELS {
            let average = made(map, level, Filter::Average)?;
            let volume = difference_volume(map, &average);
            let others = [
                made(map, level, Filter::LeastSquares)?,
                made(map, level, Filter::Variational)?,
                descent(map, &average)?,
            ];
            let ratios = others.map(|other| difference_volume(map, &other) / volume);
            all.iter_mut().zip(ratios).for_each(|(all, ratio)| all.push(ratio));
            let cells = [name.clone(), level.to_string(), format!("{volume:.5}")];
            rows.add_row(cells.into_iter().chain(ratios.map(|ratio| format!("{ratio:.3}"))));
        }
    }
    let medians = all.map(|mut all| {
        all.sort_by(f64::total_cmp);
        format!("{:.3}", all[all.len() / 2])
    });
    rows.add_row(["median", "", ""].map(str::to_owned).into_iter().chain(medians));
    Ok(rows)
}

/// The paper's descent from the average: all heights at once against the derivative of equation 12.
fn descent(map: &HeightMap, average: &HeightMap) -> Result<HeightMap, String> {
    let (mut level, mut factor) = (average.clone(), FACTORS[0]);
    let (mut volume, mut derivative) = derivative(map, &level);
    for _ in 0..DESCENT_STEPS {
        let moved = level.texels().iter().zip(&derivative);
        let moved = moved.map(|(&texel, by)| (f64::from(texel) - factor * by).clamp(0.0, 1.0) as f32);
        let next = HeightMap::new(level.width(), level.height(), moved.collect(), level.wrap());
        let next = next.map_err(|error| error.to_string())?;
        let (after, derivative_after) = self::derivative(map, &next);
        if after < volume {
            (level, volume, derivative) = (next, after, derivative_after);
        } else {
            factor *= 0.5;
            if factor < FACTORS[1] {
                break;
            }
        }
    }
    Ok(level)
}

/// The volume, and equation 12 for each of the level's texels: by how much the volume over its area grows
/// when it is displaced, over that displacement and the area.
fn derivative(map: &HeightMap, level: &HeightMap) -> (f64, Vec<f64>) {
    let [columns, rows] = [map.width() * POINTS, map.height() * POINTS];
    let [width, height] = [level.width(), level.height()];
    let place = |at: f64, side: u32| {
        let at = at * f64::from(side) - 0.5;
        let before = at.floor();
        let nodes = [0, 1].map(|next| level.wrap().index(before as i64 + next, side));
        [(nodes[0], 1.0 - (at - before)), (nodes[1], at - before)]
    };
    let bands: Vec<(f64, Vec<(usize, f64)>)> = (0..rows)
        .into_par_iter()
        .map(|row| {
            let v = (f64::from(row) + 0.5) / f64::from(rows);
            let (mut volume, mut grows) = (0.0, Vec::with_capacity(4 * columns as usize));
            for column in 0..columns {
                let u = (f64::from(column) + 0.5) / f64::from(columns);
                let apart = level.height_at(u, v) - map.height_at(u, v);
                volume += apart.abs();
                for (j, down) in place(v, height) {
                    for (i, across) in place(u, width) {
                        let by = EPSILON * across * down;
                        grows.push(((j * width + i) as usize, (apart + by).abs() - apart.abs()));
                    }
                }
            }
            (volume, grows)
        })
        .collect();
    let points = f64::from(columns) * f64::from(rows);
    let area = 4.0 / f64::from(width * height);
    let mut derivative = vec![0.0; (width * height) as usize];
    for (node, grows) in bands.iter().flat_map(|(_, grows)| grows) {
        derivative[*node] += grows / (EPSILON * area * points);
    }
    (bands.iter().map(|(volume, _)| volume).sum::<f64>() / points, derivative)
}

fn skylines(maps: &[(String, HeightMap)]) -> Result<Table, String> {
    let mut rows = table(&["map", "level", "block maximum", "max", "average", "variational"]);
    for (name, map) in maps {
        let truth = skyline(map, map);
        for level in LEVELS {
            let levels = [
                block_maximum(map, level)?,
                made(map, level, Filter::Max)?,
                made(map, level, Filter::Average)?,
                made(map, level, Filter::Variational)?,
            ];
            let shares = levels.map(|level| {
                let below =
                    skyline(map, &level).iter().zip(&truth).filter(|(a, b)| **a < **b - ROUNDING).count();
                format!("{:.1} %", 100.0 * below as f64 / truth.len() as f64)
            });
            rows.add_row([name.clone(), level.to_string()].into_iter().chain(shares));
        }
    }
    Ok(rows)
}

/// The highest of a level along each column, seen along `v`: between the centres of its rows it is linear.
fn skyline(map: &HeightMap, level: &HeightMap) -> Vec<f64> {
    let columns = map.width() * COLUMNS;
    let highest = |column: u32| {
        let u = (f64::from(column) + 0.5) / f64::from(columns);
        let rows = (0..level.height()).map(|row| (f64::from(row) + 0.5) / f64::from(level.height()));
        rows.map(|v| level.height_at(u, v)).fold(0.0, f64::max)
    };
    (0..columns).into_par_iter().map(highest).collect()
}

/// The level of the highest texels of blocks.
fn block_maximum(map: &HeightMap, level: u32) -> Result<HeightMap, String> {
    let side = 1 << level;
    let texel = |i: u32, j: u32| {
        let of_block = (0..side * side).map(|at| [side * i + at % side, side * j + at / side].map(i64::from));
        of_block.map(|[i, j]| map.texel(i, j)).fold(0.0, f32::max)
    };
    HeightMap::from_fn((map.width() / side).max(1), (map.height() / side).max(1), map.wrap(), texel)
        .map_err(|error| error.to_string())
}

fn times(sides: &[u32]) -> Result<Table, String> {
    let mut rows = table(&["filter", "size", "1 thread s", "2 threads s"]);
    for filter in Filter::ALL {
        for &side in sides {
            let mut cells = vec![filter.to_string(), format!("{side}²")];
            for threads in [1, 2] {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
                let pool = pool.map_err(|error| error.to_string())?;
                // A map of its own, whose averages nobody has asked for yet.
                let map = HeightMap::new(side, side, fractal(7, side, side, 0.5), Wrap::Repeat);
                let map = map.map_err(|error| error.to_string())?;
                let started = Instant::now();
                pool.install(|| filter_levels(&map, filter, &Watch::none()))
                    .map_err(|error| error.to_string())?;
                cells.push(format!("{:.3}", started.elapsed().as_secs_f64()));
            }
            rows.add_row(cells);
        }
    }
    Ok(rows)
}
