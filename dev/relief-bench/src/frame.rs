//! `frame`: the second picture of a renderer that keeps what it was given, beside a whole rendering from
//! files.

use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use glam::DQuat;
use relief_core::Watch;
use relief_maps::{Cache, DEFAULT_LIMIT, Maps};
use relief_render::gpu::Work;
use relief_render::{Rendered, Renderer, render};
use relief_scene::{BackendChoice, Sampling, Scene, SceneSpec, read_scene};

use crate::samples::Samples;
use crate::table::table;

/// The most bytes that a second frame may upload.
const AIM_UPLOADED: u64 = 1024;

/// Most time that it may take, as a part of a whole rendering's.
const AIM_TIME: f64 = 0.5;

/// Arguments of `frame`.
#[derive(Args)]
pub struct Arguments {
    /// Scene files
    #[arg(default_values = ["scenes/bricks.toml", "scenes/cobbles.toml", "scenes/still-life.toml"])]
    scenes: Vec<PathBuf>,
    /// Size of the pictures, as WIDTHxHEIGHT
    #[arg(long, default_value = "640x480", value_parser = size)]
    size: [u32; 2],
    /// Pictures of each; the median counts
    #[arg(long, default_value_t = 7, value_parser = clap::value_parser!(u16).range(1..=1000))]
    rounds: u16,
}

pub fn size(text: &str) -> Result<[u32; 2], String> {
    let sides =
        text.split_once('x').and_then(|(width, height)| Some([width.parse().ok()?, height.parse().ok()?]));
    sides.ok_or_else(|| "it must be WIDTHxHEIGHT, as 640x480".to_owned())
}

/// What was measured of a scene on a backend.
struct Measured {
    device: String,
    /// Milliseconds of reading the files, taking the maps out of a folder, opening the renderer and one
    /// picture.
    whole: Samples,
    /// Milliseconds of the same but for reading the files.
    render: Samples,
    /// Milliseconds of a picture from elsewhere by a renderer that has made one.
    frame: Samples,
    /// Milliseconds of drawing alone, where a GPU reads nothing back.
    drawn: Samples,
    /// The most that such a picture uploaded and compiled.
    work: Work,
}

/// Prints the table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
    let cache = Cache::new(folder.path(), DEFAULT_LIMIT);
    let mut table = table(&[
        "scene",
        "backend",
        "files, maps, picture ms",
        "`render` alone ms",
        "second frame ms",
        "drawn, not read ms",
        "over the first",
        "over the second",
        "bytes uploaded",
        "programs compiled",
    ]);
    let mut devices = Vec::new();
    let mut missed = Vec::new();
    for file in &arguments.scenes {
        let name = file.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        for (backend, choice) in [("cpu", BackendChoice::Cpu), ("gpu", BackendChoice::Gpu)] {
            let spec = SceneSpec {
                backend: Some(choice),
                size: Some(arguments.size.into()),
                samples: Some(1),
                ..SceneSpec::default()
            };
            let spec = read_scene(file).map_err(|error| error.to_string())?.overridden_by(spec);
            let measured = measure(&spec, &cache, arguments.rounds)?;
            let Measured { device, whole, render, frame, drawn, work } = measured;
            let share = frame.over(&whole);
            if share.median() > AIM_TIME || work.uploaded > AIM_UPLOADED || work.compiled > 0 {
                missed.push(format!("{name} on the {backend}"));
            }
            table.add_row([
                name.clone(),
                backend.to_owned(),
                whole.to_string(),
                render.to_string(),
                frame.to_string(),
                if backend == "gpu" { drawn.to_string() } else { "-".to_owned() },
                format!("{:.2}", share.median()),
                format!("{:.2}", frame.over(&render).median()),
                work.uploaded.to_string(),
                work.compiled.to_string(),
            ]);
            if !devices.contains(&device) {
                devices.push(device);
            }
        }
    }
    println!(
        "{}x{} pixels, {} pictures of each, medians with the least and the greatest. On {}.",
        arguments.size[0],
        arguments.size[1],
        arguments.rounds,
        devices.join(" and on ")
    );
    println!(
        "A second frame shows the scene from elsewhere, and equals to the bit what a new renderer \
         draws.\n\n{table}\n"
    );
    println!(
        "Aim: at most {AIM_TIME} of the time, {AIM_UPLOADED} bytes and no program. {}",
        if missed.is_empty() {
            "Reached everywhere.".to_owned()
        } else {
            format!("Missed: {}.", missed.join(", "))
        }
    );
    Ok(())
}

fn measure(spec: &SceneSpec, cache: &Cache, rounds: u16) -> Result<Measured, String> {
    let quiet = &Watch::none();
    let scene = spec.load().map_err(|error| error.to_string())?;
    let mut maps = Maps::with_cache(cache.clone());
    let mut renderer = Renderer::new(scene.backend(), Sampling::Exact).map_err(|error| error.to_string())?;
    // The first bakes the maps and puts them into the folder.
    let first = renderer.render(&scene, &mut maps, quiet).map_err(|error| error.to_string())?;
    let (mut whole, mut alone, mut frame) = (Samples::default(), Samples::default(), Samples::default());
    let (mut drawn, mut work) = (Samples::default(), Work::default());
    for round in 0..rounds {
        let start = Instant::now();
        let loaded = spec.load().map_err(|error| error.to_string())?;
        let read = start.elapsed().as_secs_f64();
        let seen = from_elsewhere(&loaded, round)?;
        let start = Instant::now();
        let fresh =
            render(&seen, &mut Maps::with_cache(cache.clone()), quiet).map_err(|error| error.to_string())?;
        let taken = start.elapsed().as_secs_f64();
        whole.push(1e3 * (read + taken));
        alone.push(1e3 * taken);

        let seen = from_elsewhere(&scene, round)?;
        let start = Instant::now();
        let again = renderer.render(&seen, &mut maps, quiet).map_err(|error| error.to_string())?;
        frame.push(1e3 * start.elapsed().as_secs_f64());
        let last = renderer.last_work();
        work.uploaded = work.uploaded.max(last.uploaded);
        work.compiled = work.compiled.max(last.compiled);
        check_same(&fresh, &again)?;
        if renderer.backend() == "gpu" {
            let time = renderer.time(&seen, &mut maps, quiet).map_err(|error| error.to_string())?;
            drawn.push(1e3 * time.elapsed.as_secs_f64());
        }
    }
    Ok(Measured { device: first.info.device, whole, render: alone, frame, drawn, work })
}

/// The scene with its camera turned around what it looks at, another way each round.
fn from_elsewhere(scene: &Scene, round: u16) -> Result<Scene, String> {
    let camera = scene.camera();
    let turn = DQuat::from_rotation_y(0.02 * f64::from(round + 1));
    let eye = camera.target() + turn * (camera.eye() - camera.target());
    let camera = camera.moved(eye, camera.target()).map_err(|error| error.to_string())?;
    let mut seen = scene.clone();
    seen.set_camera(camera);
    Ok(seen)
}

fn check_same(one: &Rendered, other: &Rendered) -> Result<(), String> {
    if one.rendering.pixels == other.rendering.pixels {
        Ok(())
    } else {
        Err("a second frame differs from that of a new renderer".to_owned())
    }
}
