//! `kits`: kits for engines beside Relief. Engines draw meshes with them in Chromium without a window
//! (SwiftShader), and Bevy without a window; each pixel's hit is held to the renderer's.

pub mod bevy;
pub mod godot;
mod pages;
pub mod rendered;
mod three;

use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Arc;

use clap::Args;
use comfy_table::Table;
use glam::{DVec3, Vec2};
use relief_core::camera::{Camera, Projection};
use relief_core::mesh::{Builtin, Mesh};
use relief_core::{HeightMap, Wrap};
use relief_shaders::Selection;
use relief_testing::maps;
use serde_json::{Value, json};

use self::rendered::{Shown, mesh_json};
pub use self::three::KIT as THREE_KIT;
use crate::table::table;

/// Arguments of `kits`.
#[derive(Args)]
pub struct Arguments {
    /// Chromium or Chrome, which runs three.js
    #[arg(long, value_name = "PROGRAM", default_value = "chromium")]
    chromium: PathBuf,
    /// Engines: three, godot, bevy. Bevy is built first, with Rust 1.97.1, which takes minutes
    #[arg(long, value_name = "NAME[,NAME...]", value_delimiter = ',', default_value = "three,godot")]
    engine: Vec<String>,
    /// Meshes: plane, sphere, torus
    #[arg(long, value_name = "NAME[,NAME...]", value_delimiter = ',', default_value = "plane,sphere,torus")]
    mesh: Vec<String>,
    /// Methods
    #[arg(long, value_name = "NAME[,NAME...]", value_delimiter = ',', default_value = "relief,exact")]
    method: Vec<String>,
    /// The command, for the pages that it writes
    #[arg(long, value_name = "PROGRAM", default_value = "target/release/relief")]
    relief: PathBuf,
    /// Draw scenes of three.js instead: boxes cut the relief, it casts a shadow on a floor, and one mesh is
    /// in three places, turned and scaled unevenly
    #[arg(long)]
    scene: bool,
    /// Folder for pictures of the scenes: what is shown, and in red what differs from the exact
    #[arg(long, value_name = "FOLDER")]
    pictures: Option<PathBuf>,
    /// Width of the pictures; they are three quarters as high
    #[arg(long, default_value_t = 512)]
    width: u32,
}

/// A mesh under a relief: its tiles, and the surface.
const MESHES: [(Builtin, Vec2, &str); 3] = [
    (Builtin::Plane, Vec2::new(0.25, 0.25), "plane"),
    (Builtin::Sphere, Vec2::new(1.0, 0.5), "quadric-vertical"),
    (Builtin::Torus, Vec2::new(1.0, 0.375), "quadric-vertical"),
];

const EYE_M: DVec3 = DVec3::new(0.9, 0.8, 1.3);
const FOV_DEGREES: f64 = 40.0;
const SCALE_M: f64 = 0.03;

/// A summand that makes texture coordinates positive, since they are drawn as colours.
const BEYOND: f64 = 4.0;

/// Part of the pixels by which a kit may be behind: rasterisers differ from machine to machine.
const SLACK: f64 = 0.002;

/// Hits that are as near as this, in texels, count as the same.
const NEAR_TEXELS: f64 = 0.02;

/// Least part of the hits of bent meshes that agree without frames at their vertices.
const LEAST_FROM_DERIVATIVES: f64 = 0.995;

/// Rasterisers know places to some hundredths of a pixel (SwiftShader to a sixteenth). How much that
/// moves hits is seen by the renderer's own picture, moved as far aside.
const ASIDE_PIXELS: f64 = 1.0 / 32.0;

/// Prints the tables. Fails where a picture misses a bound.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let subjects = subjects(arguments)?;
    let holds = match arguments.scene {
        true => three::scene::run(arguments, &subjects)?,
        false => {
            let holds = hits(arguments, &subjects)?;
            written(arguments)?;
            holds
        }
    };
    Ok(if holds { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Prints how far each kit's hits are from the renderer's. Returns whether the bounds hold.
fn hits(arguments: &Arguments, subjects: &[Subject]) -> Result<bool, String> {
    let mut rows = table_of_hits();
    let mut holds = true;
    for subject in subjects {
        let Subject { builtin, method, heights, .. } = subject;
        let [ours, aside] = [ours(subject, 0.0)?, ours(subject, ASIDE_PIXELS)?];
        let itself = compare(&ours, &aside, heights.width());
        rows.add_row(row(*builtin, method, "Relief, aside", &itself));
        for (name, frames, draw) in kits(arguments)? {
            let theirs = draw(arguments, &subject.job(frames))?;
            let found = compare(&ours, &theirs, heights.width());
            holds &= is_near(*builtin, frames, &found, &itself);
            rows.add_row(row(*builtin, method, &name, &found));
        }
    }
    println!("{rows}");
    Ok(holds)
}

/// Whether hits are near enough. From derivatives each triangle of a bent mesh has one curvature.
fn is_near(builtin: Builtin, frames: bool, found: &Apart, itself: &Apart) -> bool {
    match frames || builtin == Builtin::Plane {
        true => found.is_as_near_as(itself),
        false => found.hits >= LEAST_FROM_DERIVATIVES,
    }
}

/// Reads texts of engines, and shows what `relief engine` writes.
fn written(arguments: &Arguments) -> Result<(), String> {
    if arguments.engine.iter().any(|engine| engine == "godot") {
        println!("Godot takes {} texts of methods", godot::texts::read_all(&arguments.chromium)?);
    }
    if arguments.engine.iter().any(|engine| engine == "bevy") {
        let step = bevy::open(&arguments.relief)?;
        println!("what `relief engine bevy` writes is shown: mean steps of {step:.1}");
    }
    if arguments.engine.iter().all(|engine| engine == "bevy") {
        return Ok(());
    }
    let [three, godot] = pages::open(&arguments.relief, &arguments.chromium)?;
    println!(
        "what `relief engine` writes is shown: mean steps of {three:.1} in three.js, {godot:.1} in Godot"
    );
    Ok(())
}

/// Columns of hits beside the renderer's.
fn table_of_hits() -> Table {
    table(&["mesh", "method", "picture", "hits agree", "median", "p99", "within 0.02 texel"])
}

/// Whether meshes have frames of their own at their vertices, and what is said of it.
const FRAMES: [(bool, &str); 2] = [(false, ""), (true, ", own frames")];

/// A name, whether meshes have frames of their own, and how a picture is drawn.
type Kit = (String, bool, Box<dyn Fn(&Arguments, &Job) -> Result<Shown, String>>);

/// The kits that are asked for.
fn kits(arguments: &Arguments) -> Result<Vec<Kit>, String> {
    let mut kits: Vec<Kit> = Vec::new();
    for engine in &arguments.engine {
        match engine.as_str() {
            "three" => {
                for (frames, own) in FRAMES {
                    kits.extend(three::BACKENDS.map(|backend| -> Kit {
                        let draw =
                            move |given: &Arguments, job: &Job| three::shown(&given.chromium, job, backend);
                        (format!("three.js, {backend}{own}"), frames, Box::new(draw))
                    }));
                }
            }
            "godot" => kits.extend(FRAMES.map(|(frames, own)| -> Kit {
                let draw = |given: &Arguments, job: &Job| godot::shown(&given.chromium, job);
                (format!("Godot{own}"), frames, Box::new(draw))
            })),
            "bevy" => kits.extend(FRAMES.map(|(frames, own)| -> Kit {
                let draw = |given: &Arguments, job: &Job| bevy::shown(&given.relief, job);
                (format!("Bevy{own}"), frames, Box::new(draw))
            })),
            other => return Err(format!("--engine: no '{other}' here: three, godot, bevy")),
        }
    }
    Ok(kits)
}

fn row(mesh: Builtin, method: &str, picture: &str, found: &Apart) -> [String; 7] {
    [
        mesh.name().to_owned(),
        method.to_owned(),
        picture.to_owned(),
        format!("{:.3} %", 100.0 * found.hits),
        format!("{:.4}", found.median),
        format!("{:.4}", found.p99),
        format!("{:.2} %", 100.0 * found.near),
    ]
}

fn heights() -> Result<HeightMap, String> {
    let natural = maps::ALL.iter().find(|map| map.name == "natural 128x128").ok_or("no such map")?;
    natural.build(Wrap::Repeat).with_displacement(SCALE_M, -SCALE_M).map_err(|error| error.to_string())
}

/// A mesh under a relief, and a method that shows it.
struct Subject {
    builtin: Builtin,
    tile: Vec2,
    method: String,
    mesh: Arc<Mesh>,
    heights: HeightMap,
    selection: Selection,
    /// Width and height of its pictures.
    size: [u32; 2],
}

impl Subject {
    fn of(builtin: Builtin, method: &str, size: [u32; 2]) -> Result<Self, String> {
        let known = MESHES.into_iter().find(|(of, ..)| *of == builtin);
        let (_, tile, surface) = known.ok_or_else(|| format!("--mesh: no '{builtin}' here"))?;
        let mut selection = Selection::method(method).map_err(|error| error.to_string())?;
        for (key, name) in [("surface", surface), ("shadow", "none")] {
            selection.choose(key, name).map_err(|error| error.to_string())?;
        }
        let mesh = builtin.build([1.0, 1.0]).and_then(|mesh| mesh.tiled(tile));
        let mesh = Arc::new(mesh.map_err(|error| error.to_string())?);
        Ok(Self { builtin, tile, method: method.to_owned(), mesh, heights: heights()?, selection, size })
    }

    /// The same with more tiles along u and v.
    fn finer(&self, tiles: f32) -> Result<Self, String> {
        let mesh = self.mesh.as_ref().clone().tiled(Vec2::splat(tiles)).map_err(|error| error.to_string())?;
        let (heights, method, tile) = (self.heights.clone(), self.method.clone(), self.tile * tiles);
        Ok(Self { mesh: Arc::new(mesh), heights, method, tile, ..*self })
    }

    /// The picture of it, of a mesh with frames of its own at its vertices or without them.
    fn job(&self, frames: bool) -> Job<'_> {
        let Self { builtin, tile, method, mesh, heights, selection, size } = self;
        Job { builtin: *builtin, tile: *tile, method, mesh, frames, heights, selection, size: *size }
    }
}

/// The meshes and methods that are asked for.
fn subjects(arguments: &Arguments) -> Result<Vec<Subject>, String> {
    let size = [arguments.width, arguments.width * 3 / 4];
    let unknown = |name: &&String| MESHES.iter().all(|(builtin, ..)| builtin.name() != name.as_str());
    if let Some(name) = arguments.mesh.iter().find(unknown) {
        return Err(format!("--mesh: no '{name}' here"));
    }
    let is_asked = |builtin: &Builtin| arguments.mesh.iter().any(|name| name == builtin.name());
    let asked = MESHES.into_iter().map(|(builtin, ..)| builtin).filter(is_asked);
    asked.flat_map(|of| arguments.method.iter().map(move |name| Subject::of(of, name, size))).collect()
}

/// The renderer's hits, in a picture that is moved aside.
fn ours(subject: &Subject, aside_pixels: f64) -> Result<Shown, String> {
    let Subject { mesh, heights, selection, size, .. } = subject;
    let camera = camera(EYE_M, aside_pixels, *size)?;
    rendered::shown(mesh, heights, selection, camera, *size)
}

/// A camera that looks at the middle, some pixels aside.
fn camera(eye: DVec3, aside_pixels: f64, size: [u32; 2]) -> Result<Camera, String> {
    let pixel_m = 2.0 * eye.length() * (FOV_DEGREES.to_radians() / 2.0).tan() / f64::from(size[1]);
    let target = DVec3::Y.cross(eye).normalize() * (pixel_m * aside_pixels);
    let camera = Camera::with(eye, target, Projection::Perspective { fov_degrees: FOV_DEGREES });
    camera.map_err(|error| error.to_string())
}

/// A picture that an engine's kit draws.
struct Job<'a> {
    builtin: Builtin,
    tile: Vec2,
    method: &'a str,
    mesh: &'a Arc<Mesh>,
    /// Whether the mesh has frames of its own at its vertices.
    frames: bool,
    heights: &'a HeightMap,
    selection: &'a Selection,
    /// Width and height.
    size: [u32; 2],
}

impl Job<'_> {
    /// The job in words of a page.
    fn json(&self) -> Value {
        let Self { mesh, heights, size: [width, height], .. } = *self;
        json!({
            "width": width,
            "height": height,
            "eye": EYE_M.to_array(),
            "fov": FOV_DEGREES,
            "scale": SCALE_M,
            "beyond": BEYOND,
            "mesh": mesh_json(mesh, self.frames),
            "heights": {
                "width": heights.width(), "height": heights.height(), "texels": heights.texels(),
            },
        })
    }
}

/// How far hits are from others.
struct Apart {
    hits: f64,
    median: f64,
    p99: f64,
    near: f64,
}

impl Apart {
    /// Whether a kit is as near as the renderer is to its own picture, moved aside.
    fn is_as_near_as(&self, itself: &Self) -> bool {
        self.hits >= itself.hits - SLACK && self.near >= itself.near - SLACK
    }
}

fn compare(ours: &Shown, theirs: &Shown, side: u32) -> Apart {
    let covered = ours.iter().zip(theirs).filter(|(a, b)| a.is_some() || b.is_some()).count();
    let both = ours.iter().zip(theirs).filter_map(|(a, b)| a.zip(*b));
    let mut off: Vec<f64> = both.map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]) * f64::from(side)).collect();
    off.sort_by(f64::total_cmp);
    let at =
        |part: f64| off.get((off.len().saturating_sub(1) as f64 * part) as usize).copied().unwrap_or(0.0);
    let near = off.iter().filter(|off| **off <= NEAR_TEXELS).count();
    Apart {
        hits: off.len() as f64 / covered.max(1) as f64,
        median: at(0.5),
        p99: at(0.99),
        near: near as f64 / off.len().max(1) as f64,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shifted_and_missing_hits_are_seen() {
        let ours: Shown = (0..100).map(|k| (k % 4 != 0).then(|| [f64::from(k) / 100.0, 0.5])).collect();
        let same = compare(&ours, &ours, 128);
        assert_eq!((same.hits, same.median, same.near), (1.0, 0.0, 1.0));
        let shifted: Shown = ours.iter().map(|hit| hit.map(|[u, v]| [u, v + 0.1 / 128.0])).collect();
        let apart = compare(&ours, &shifted, 128);
        assert!((apart.median - 0.1).abs() < 1e-6 && apart.near == 0.0 && !apart.is_as_near_as(&same));
        let mut fewer = ours.clone();
        fewer[1] = None;
        assert!(!compare(&ours, &fewer, 128).is_as_near_as(&same));
    }
}
