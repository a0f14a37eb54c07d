//! `parallax`: what engines have of their own beside Relief's methods in their shaders, in one run:
//! how far hits are off the exact ones, and how long a frame takes. An unlit texture whose colours are
//! its coordinates shows each.

mod babylon;
mod bevy;

use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

use clap::Args;
use glam::DVec3;
use relief_bake::{Collected, kind};
use relief_core::camera::{Camera, Projection};
use relief_core::mesh::{Mesh, square};
use relief_core::{HeightMap, Metric, Watch, Wrap};
use relief_export::{ExportedFunctions, FunctionOptions, Profile, functions};
use relief_io::{HeightOptions, read_height_file};
use relief_shaders::Selection;
use serde_json::{Value, json};

use crate::kits::godot::{FRAGMENT, run as run_godot};
use crate::kits::rendered::{self, Shown, mesh_json};
use crate::table::table;

/// Arguments of `parallax`.
#[derive(Args)]
pub struct Arguments {
    /// Chromium or Chrome, which runs Godot and Babylon.js
    #[arg(long, value_name = "PROGRAM", default_value = "chromium")]
    chromium: PathBuf,
    /// Engine: godot (deep parallax), babylon (parallax occlusion, beside the kit of three.js), or bevy
    /// (parallax occlusion and relief mapping), which is built first
    #[arg(long, value_name = "NAME", default_value = "godot")]
    engine: String,
    /// The command, for the program of Bevy that it writes
    #[arg(long, value_name = "PROGRAM", default_value = "target/release/relief")]
    relief: PathBuf,
    /// Width of the pictures; they are three quarters as high
    #[arg(long, default_value_t = 320)]
    width: u32,
}

/// Sample maps.
const MAPS: [&str; 3] = ["cobbles.png", "bricks.png", "noise.png"];

/// Angles between the normal and the ray to the middle.
const ANGLES: [f64; 3] = [30.0, 60.0, 80.0];

/// Numbers of layers of Godot's parallax.
const LAYERS: [u32; 4] = [8, 16, 32, 64];

const METHODS: [&str; 5] = ["relief", "occlusion", "cone", "frustum", "exact"];

const SCALE_M: f64 = 0.05;
const DISTANCE_M: f64 = 1.6;
const FOV_DEGREES: f64 = 30.0;

/// The byte of 0 in the pictures, and how far the byte of 1 is above it.
const DARKEST: f64 = 70.0;
const RANGE: f64 = 180.0;

/// Rises and falls of the fine part of a coordinate over a tile.
const FINE: f64 = 32.0;

/// How far the second fine part is ahead, in rises.
const AHEAD: f64 = 0.5;

/// How far coordinates that are shown may be off, in tiles: a sixteenth of a pixel, at the flattest angle.
const SHOWN_WITHIN: f64 = 1.0 / 600.0;

/// Prints a table for each map. Fails where pictures do not show coordinates.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let size = [arguments.width, arguments.width * 3 / 4];
    for name in MAPS {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name);
        let file = read_height_file(&path, &HeightOptions::default()).map_err(|error| error.to_string())?;
        // Godot reads heights of 8 bits, so all do.
        let heights = rounded(&file.map)?;
        let mesh = Arc::new(square(1).map_err(|error| error.to_string())?);
        let found = match arguments.engine.as_str() {
            "godot" => of_map(arguments, &heights, &mesh, size),
            "babylon" => babylon::of_map(arguments, &heights, &mesh, &eyes(), size),
            "bevy" => bevy::of_map(arguments, &heights, &mesh, &eyes(), size),
            other => Err(format!("--engine: no '{other}' here: godot, babylon, bevy")),
        };
        println!("{name}:\n\n{}\n", found?);
    }
    Ok(ExitCode::SUCCESS)
}

/// The places from which the plane is seen.
fn eyes() -> [DVec3; 3] {
    ANGLES.map(|angle| {
        let angle = angle.to_radians();
        DVec3::new(0.0, angle.cos(), angle.sin()) * DISTANCE_M
    })
}

/// The heights, rounded to 8 bits.
fn rounded(heights: &HeightMap) -> Result<HeightMap, String> {
    let texels: Vec<f32> = heights.texels().iter().map(|height| f32::from(byte(*height)) / 255.0).collect();
    let map = HeightMap::new(heights.width(), heights.height(), texels, Wrap::Repeat);
    map.and_then(|map| map.with_displacement(SCALE_M, -SCALE_M)).map_err(|error| error.to_string())
}

fn byte(height: f32) -> u8 {
    (height * 255.0).round() as u8
}

fn of_map(
    arguments: &Arguments,
    heights: &HeightMap,
    mesh: &Arc<Mesh>,
    size: [u32; 2],
) -> Result<String, String> {
    let eyes = eyes();
    let mut ways = vec![json!({ "name": "flat", "layers": 0 })];
    ways.extend(LAYERS.map(|layers| json!({ "name": format!("Godot, {layers} layers"), "layers": layers })));
    let mut files = vec![
        ("main.gd".to_owned(), include_bytes!("main.gd").to_vec()),
        ("relief_fragment.gdshaderinc".to_owned(), FRAGMENT.as_bytes().to_vec()),
    ];
    for method in METHODS {
        let (mut exported, map) = exported_of(method, heights, Profile::Godot4)?;
        let text = exported.files.swap_remove(0).bytes;
        let shader =
            include_str!("shown.gdshader").replace("relief.gdshaderinc", &format!("{method}.gdshaderinc"));
        files.push((format!("{method}.gdshaderinc"), text));
        files.push((format!("{method}.gdshader"), shader.into_bytes()));
        let mut way = json!({ "name": format!("Relief, {method}"), "shader": format!("{method}.gdshader") });
        if let Some(map) = map {
            way["map"] = map;
        }
        ways.push(way);
    }
    let bytes: Vec<u8> = heights.texels().iter().map(|at| byte(*at)).collect();
    let input = json!({
        "width": size[0], "height": size[1], "fov": FOV_DEGREES, "scale": SCALE_M,
        "eyes": eyes.map(|eye| eye.to_array()),
        "ways": ways,
        "mesh": mesh_json(mesh, true),
        "heights": of_texels(heights, &json!(heights.texels())),
        "heights8": of_texels(heights, &json!(bytes)),
    });
    files.push(("input.json".to_owned(), input.to_string().into_bytes()));
    let answer = run_godot(&arguments.chromium, files)?;

    let pixels = (size[0] * size[1]) as usize;
    let pictures = 2 * ways.len() * eyes.len();
    let (shown, seconds) = answer.split_at_checked(3 * pixels * pictures).ok_or("Godot's answer is short")?;
    let seconds: Vec<f64> = serde_json::from_slice(seconds).map_err(|error| error.to_string())?;
    let mut rows = table(&["way", "p99 at 30°", "60°", "80°", "ms over flat at 30°", "60°", "80°"]);
    let mut cells: Vec<Vec<String>> = ways.iter().map(|_| Vec::new()).collect();
    let mut costs = cells.clone();
    for (number, eye) in eyes.iter().enumerate() {
        let exact = ours("exact", mesh, heights, *eye, size)?;
        let base = ours("bump", mesh, heights, *eye, size)?;
        for (at, (cells, costs)) in cells.iter_mut().zip(&mut costs).enumerate() {
            let first = 2 * (number * ways.len() + at) * 3 * pixels;
            let seen = decode(&shown[first..first + 6 * pixels], pixels);
            if at == 0 && p99(&base, &seen) > SHOWN_WITHIN {
                return Err(format!("the plane's coordinates are shown {} tiles off", p99(&base, &seen)));
            }
            let texels = f64::from(heights.width());
            cells.push(format!("{:.2}", texels * p99(&exact, &seen)));
            let flat = seconds[number * ways.len()];
            costs.push(format!("{:.1}", 1e3 * (seconds[number * ways.len() + at] - flat)));
        }
    }
    for ((way, cells), costs) in ways.iter().zip(cells).zip(costs) {
        let name = way["name"].as_str().unwrap_or_default().to_owned();
        rows.add_row([vec![name], cells, costs].concat());
    }
    Ok(rows.to_string())
}

/// A method's functions, and the texels of its map.
fn exported_of(
    method: &str,
    heights: &HeightMap,
    profile: Profile,
) -> Result<(ExportedFunctions, Option<Value>), String> {
    let text = |error: &dyn std::fmt::Display| error.to_string();
    let mut selection = Selection::method(method).map_err(|error| text(&error))?;
    selection.choose("shadow", "none").map_err(|error| text(&error))?;
    let options =
        FunctionOptions { wrap: Some(Wrap::Repeat), profiles: vec![profile], ..FunctionOptions::default() };
    let exported = functions(&selection, &options).map_err(|error| text(&error))?;
    let bake = exported.manifest.bindings.iter().find_map(|bound| bound.texture.as_ref()?.bake.as_ref());
    let map = match bake {
        None => None,
        Some(bake) => {
            let kind = kind(bake.kind).map_err(|error| text(&error))?;
            let mut settings = kind.defaults();
            for (name, value) in &bake.settings {
                settings.set(name, f64::from(*value)).map_err(|error| text(&error))?;
            }
            let unit = heights.clone().with_displacement(1.0, -1.0).map_err(|error| text(&error))?;
            let mut baked = Collected::default();
            relief_bake::bake(kind, &unit, Metric::UNIT, &settings, &Watch::none(), &mut baked)
                .map_err(|error| text(&error))?;
            let found = baked.textures.into_iter().find(|texture| texture.texture.name == bake.texture);
            let planes =
                found.and_then(|texture| texture.levels.into_iter().next()).ok_or("no such texture")?;
            let texel = |at: usize| (0..4).map(move |channel| (channel, at));
            let texels: Vec<f32> = (0..heights.texels().len())
                .flat_map(texel)
                .map(|(channel, at)| planes.get(channel).map_or(0.0, |plane| plane[at]))
                .collect();
            Some(of_texels(heights, &json!(texels)))
        }
    };
    Ok((exported, map))
}

fn of_texels(heights: &HeightMap, texels: &Value) -> Value {
    json!({ "width": heights.width(), "height": heights.height(), "texels": texels })
}

/// The coordinates that the renderer shows, each within a tile.
fn ours(
    method: &str,
    mesh: &Arc<Mesh>,
    heights: &HeightMap,
    eye: DVec3,
    size: [u32; 2],
) -> Result<Shown, String> {
    let camera = Camera::with(eye, DVec3::ZERO, Projection::Perspective { fov_degrees: FOV_DEGREES });
    let mut selection = Selection::method(method).map_err(|error| error.to_string())?;
    selection.choose("shadow", "none").map_err(|error| error.to_string())?;
    rendered::shown(mesh, heights, &selection, camera.map_err(|error| error.to_string())?, size)
}

/// The coordinates of two pictures, u and v.
fn decode(bytes: &[u8], pixels: usize) -> Shown {
    let texels = bytes.as_chunks::<3>().0;
    let part = |byte: u8| (f64::from(byte) - DARKEST) / RANGE;
    let value = |parts: [u8; 3]| value_of(parts.map(part));
    let seen = |at: usize| (texels[at][0] > 0).then(|| [value(texels[at]), value(texels[pixels + at])]);
    (0..pixels).map(seen).collect()
}

/// The coordinate that a colour shows: roughly, and by two waves.
fn value_of([coarse, fine, ahead]: [f64; 3]) -> f64 {
    // Where one wave turns round, the other is half way up.
    let (fine, by) = if (fine - 0.5).abs() < 0.25 { (fine, 0.0) } else { (ahead, AHEAD) };
    // The point of a rise or fall that is nearest to the coarse value.
    let near = (0..=FINE as u32).map(|rise| {
        let within = if rise % 2 == 0 { fine } else { 1.0 - fine };
        (f64::from(rise) + within - by) / FINE
    });
    near.min_by(|a, b| (a - coarse).abs().total_cmp(&(b - coarse).abs())).unwrap_or(coarse)
}

/// The 99th percentile of the distance, in tiles, where both show something.
fn p99(truth: &Shown, seen: &Shown) -> f64 {
    part(truth, seen, 0.99)
}

/// The distance, in tiles, that a part of the pixels stays below, where both show something.
fn part(truth: &Shown, seen: &Shown, below: f64) -> f64 {
    // Tiles are all the same.
    let off = |a: f64, b: f64| (a - b) - (a - b).round();
    let both = truth.iter().zip(seen).filter_map(|(a, b)| a.zip(*b));
    let mut off: Vec<f64> = both.map(|(a, b)| off(a[0], b[0]).hypot(off(a[1], b[1]))).collect();
    off.sort_by(f64::total_cmp);
    off.get((off.len() as f64 * below) as usize).copied().unwrap_or(f64::INFINITY)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(at: f64) -> [u8; 3] {
        let fine = |ahead: f64| 1.0 - ((FINE * at + ahead).rem_euclid(2.0) - 1.0).abs();
        [at, fine(0.0), fine(AHEAD)].map(|part| (DARKEST + RANGE * part).round() as u8)
    }

    #[test]
    fn coordinates_are_read_back_and_differences_seen() {
        let values: Vec<f64> = (0..1000).map(|at| (f64::from(at) + 0.5) / 1000.0).collect();
        let picture = |values: &[f64]| values.iter().flat_map(|at| shown(*at)).collect::<Vec<u8>>();
        let seen = decode(&[picture(&values), picture(&values)].concat(), 1000);
        let truth: Shown = values.iter().map(|at| Some([*at + 3.0, *at - 1.0])).collect();
        assert!(p99(&truth, &seen) < SHOWN_WITHIN, "{}", p99(&truth, &seen));
        let moved: Shown = values.iter().map(|at| Some([*at, *at + 0.01])).collect();
        assert!((p99(&moved, &seen) - 0.01).abs() < SHOWN_WITHIN);
        assert_eq!(p99(&vec![None; 1000], &seen), f64::INFINITY);
    }
}
