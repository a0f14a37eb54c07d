//! `adapt`: triangles and seconds to an error, beside packages of PyPI.

mod distance;
mod peers;

use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use glam::{DVec2, Vec2};
use relief_core::mesh::{Mesh, Vertex, rectangle};
use relief_core::{HeightMap, Watch, Wrap};
use relief_io::{Fill, HeightOptions, read_height};
use relief_mesh::{Fit, Judge, MeshSettings, Mesher};
use relief_testing::maps::fractal;
use relief_tests::{accuracy, data_dir};

use self::distance::{Piece, distance};
use crate::python;
use crate::samples::Samples;
use crate::table::table;

/// Arguments of `adapt`.
#[derive(Args)]
pub struct Arguments {
    /// Python with PyPI's pydelatin, pymartini, fast-simplification and meshoptimizer
    #[arg(long, default_value = "python3")]
    python: PathBuf,
    /// Texels along a side of the fractal ground
    #[arg(long, default_value_t = 2049, value_parser = clap::value_parser!(u32).range(65..=8193))]
    side: u32,
    /// Tolerances, in percent of the height of the map
    #[arg(long, value_delimiter = ',', default_values_t = [1.0, 0.1])]
    error: Vec<f64>,
    /// Rounds of each; medians count
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..=1000))]
    rounds: u16,
}

/// Samples along a texel, where a mesh is measured between them.
const PER_TEXEL: u32 = 8;

/// Side of the map on which meshes of equally many triangles are compared: a power of two and one.
const SIDE_AT_ONE_COUNT: u32 = 513;

/// Real maps, where there are any.
const FILES: [&str; 4] = ["earth-topology.png", "canyon_height.jpg", "t3d_terrain1.exr", "t3d_mountain1.exr"];

/// Prints the tables.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    python::require(
        &arguments.python,
        "import pydelatin, pymartini, fast_simplification, meshoptimizer",
        "pydelatin pymartini fast-simplification meshoptimizer",
    )?;
    to_an_error(arguments)?;
    at_one_count(arguments)
}

fn maps(side: u32) -> Result<Vec<(String, HeightMap)>, String> {
    let ground = HeightMap::new(side, side, fractal(7, side, side, 0.5), Wrap::Clamp);
    let mut maps = vec![(format!("ground {side}²"), ground.map_err(|error| error.to_string())?)];
    let options = HeightOptions { wrap: Some(Wrap::Clamp), fill: Fill::Always, ..HeightOptions::default() };
    let mut files = vec![accuracy::sample_maps().join("jacksboro.png")];
    match data_dir() {
        Some(folder) => files.extend(FILES.map(|file| folder.join(file))),
        None => eprintln!("RELIEF_DATA names no folder of real maps: only shipped ones are measured"),
    }
    for file in files {
        let map = read_height(&file, &options).map_err(|error| error.to_string())?;
        let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        // Lengths are heights here.
        let map = map.with_displacement(1.0, 0.0).map_err(|error| error.to_string())?;
        maps.push((format!("{name} {}x{}", map.width(), map.height()), map));
    }
    Ok(maps)
}

/// A plane from the first centre of a texel to the last, as far as other programs see.
fn plane(map: &HeightMap) -> Result<Mesh, String> {
    let square = rectangle([1.0, 1.0], 1).map_err(|error| error.to_string())?;
    let inset = Vec2::new(0.5 / map.width() as f32, 0.5 / map.height() as f32);
    let inside = |vertex: &Vertex| Vertex { uv: inset + vertex.uv * (Vec2::ONE - 2.0 * inset), ..*vertex };
    Mesh::new(square.vertices().iter().map(inside).collect(), square.triangles().to_vec())
        .map_err(|error| error.to_string())
}

/// The triangles of a mesh over that plane.
fn pieces(map: &HeightMap, mesh: &Mesh) -> Vec<Piece> {
    let sides = DVec2::new(f64::from(map.width()), f64::from(map.height()));
    let corner = |at: u32| {
        let vertex = &mesh.vertices()[at as usize];
        (vertex.uv.as_dvec2() * sides - 0.5, f64::from(vertex.position.y))
    };
    mesh.triangles().iter().map(|corners| corners.map(corner)).collect()
}

/// The greatest twist of a cell, as the error that its two triangles have at least.
fn twist(map: &HeightMap) -> f64 {
    let cells =
        (0..i64::from(map.height()) - 1).flat_map(|j| (0..i64::from(map.width()) - 1).map(move |i| (i, j)));
    cells.fold(0.0, |most, (i, j)| {
        let [h00, h10, h01, h11] = map.cell(i, j).map(f64::from);
        most.max((h00 - h10 - h01 + h11).abs() / 4.0)
    })
}

fn to_an_error(arguments: &Arguments) -> Result<(), String> {
    let mut rows = table(&[
        "map",
        "tolerance",
        "mesher",
        "triangles",
        "of pydelatin's",
        "s",
        "pydelatin's time over it",
        "worst at texels",
        "worst anywhere",
        "cells twisted by more",
    ]);
    let mut version = String::new();
    for (name, map) in maps(arguments.side)? {
        let plane = plane(&map)?;
        let twist = twist(&map);
        for percent in &arguments.error {
            let tolerance = percent / 100.0;
            let settings =
                |judge: Judge, fit: Fit| MeshSettings { judge, fit, ..MeshSettings::within(tolerance) };
            let ours = [
                ("texels, no fit", settings(Judge::Texels, Fit::None)),
                ("texels, fit", settings(Judge::Texels, Fit::Heights)),
                ("everywhere, no fit", settings(Judge::Surface, Fit::None)),
                ("everywhere, fit", settings(Judge::Surface, Fit::Heights)),
            ];
            let mut seconds = vec![Samples::default(); ours.len()];
            let mut peers = Samples::default();
            let (mut beside, mut made) = (Vec::new(), Vec::new());
            for _ in 0..arguments.rounds {
                let answer = peers::made(&arguments.python, "pydelatin", &map, tolerance)?;
                peers.push(answer.seconds);
                (version, beside) = (answer.version, answer.pieces);
                made.clear();
                for (at, (_, settings)) in ours.iter().enumerate() {
                    let start = Instant::now();
                    match Mesher::new(&plane, &map, settings) {
                        Ok(mesher) => {
                            seconds[at].push(start.elapsed().as_secs_f64());
                            made.push(Ok(mesher));
                        }
                        Err(error) => made.push(Err(error.to_string())),
                    }
                }
            }
            let twisted = if twist > tolerance { "yes" } else { "no" };
            let error = |pieces: &[Piece], per_texel: u32| {
                format!("{:.2}", distance(&map, pieces, per_texel).greatest / tolerance)
            };
            let count = beside.len();
            let percent = format!("{percent} %");
            rows.add_row([
                name.clone(),
                percent.clone(),
                "pydelatin".to_owned(),
                count.to_string(),
                "1".to_owned(),
                peers.to_string(),
                "1".to_owned(),
                error(&beside, 1),
                error(&beside, PER_TEXEL),
                twisted.to_owned(),
            ]);
            for ((label, _), (mesher, seconds)) in ours.iter().zip(made.into_iter().zip(&seconds)) {
                let mut row = vec![name.clone(), percent.clone(), (*label).to_owned()];
                match mesher {
                    Ok(mesher) => {
                        let mesh = mesher.mesh().map_err(|error| error.to_string())?;
                        let pieces = pieces(&map, &mesh);
                        row.extend([
                            pieces.len().to_string(),
                            format!("{:.3}", pieces.len() as f64 / count as f64),
                            seconds.to_string(),
                            peers.over(seconds).to_string(),
                            error(&pieces, 1),
                            error(&pieces, PER_TEXEL),
                        ]);
                    }
                    Err(error) => row.push(error),
                }
                rows.add_row(row);
            }
        }
    }
    println!(
        "Errors in tolerances, at texels and at {PER_TEXEL}² places a texel; {} threads beside pydelatin \
         {version}'s one; medians of {} rounds, in which both took turns.\n\n{rows}\n",
        rayon::current_num_threads(),
        arguments.rounds
    );
    Ok(())
}

fn at_one_count(arguments: &Arguments) -> Result<(), String> {
    let side = SIDE_AT_ONE_COUNT;
    let ground = HeightMap::new(side, side, fractal(7, side, side, 0.5), Wrap::Clamp);
    let map = ground.map_err(|error| error.to_string())?;
    let plane = plane(&map)?;
    let mut rows = table(&["triangles wanted", "mesher", "triangles", "greatest", "RMS", "s"]);
    for wanted in [5_000_u32, 50_000] {
        let mut add = |name: String, pieces: &[Piece], seconds: f64| {
            let measured = distance(&map, pieces, PER_TEXEL);
            rows.add_row([
                wanted.to_string(),
                name,
                pieces.len().to_string(),
                format!("{:.3} %", 100.0 * measured.greatest),
                format!("{:.4} %", 100.0 * measured.rms()),
                format!("{seconds:.3}"),
            ]);
        };
        let start = Instant::now();
        let settings = MeshSettings::within(1.0);
        let mesher = Mesher::with_at_most(&plane, &map, &settings, u64::from(wanted), &Watch::none())
            .map_err(|error| error.to_string())?;
        let seconds = start.elapsed().as_secs_f64();
        add("Relief".to_owned(), &pieces(&map, &mesher.mesh().map_err(|error| error.to_string())?), seconds);
        for package in ["pymartini", "fast-simplification", "meshoptimizer"] {
            let answer = peers::made(&arguments.python, package, &map, f64::from(wanted))?;
            add(format!("{package} {}", answer.version), &answer.pieces, answer.seconds);
        }
    }
    println!("Fractal ground of {side}², errors in percent of its height, everywhere.\n\n{rows}");
    Ok(())
}
