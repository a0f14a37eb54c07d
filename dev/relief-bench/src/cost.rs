//! `cost`: the time of a frame of every surface, beside one of `plane`.

use std::time::Instant;

use clap::Args;
use cpu_time::ProcessTime;
use glam::{DVec3, Vec3};
use relief_core::mesh::torus;
use relief_core::{HeightMap, Watch};
use relief_maps::Maps;
use relief_render::Renderer;
use relief_render::gpu::{AdapterChoice, Gpu};
use relief_scene::light::Light;
use relief_scene::{BackendChoice, Sampling, Scene};
use relief_shaders::Selection;
use relief_tests::curved::{Curved, Drawn};

use crate::samples::Samples;
use crate::surfaces::Lies;
use crate::surfaces::bases::{TILES, cobbles};
use crate::table::table;

/// How many times the time of `plane` frames may take, and up to how many triangles.
const AIM_QUADRIC: f64 = 1.5;
const AIM_PRISM: f64 = 4.0;
const AIM_PRISM_TRIANGLES: usize = 2_048;

/// From where the torus is seen.
const FROM: DVec3 = DVec3::new(0.6, 0.9, 1.1);

/// Where the light of frames with shadows comes from.
const TO_LIGHT: DVec3 = DVec3::new(-0.6, 0.6, -0.1);

/// Arguments of `cost`.
#[derive(Args)]
pub struct Arguments {
    /// Where frames are made: cpu or gpu
    #[arg(long, default_value_t = BackendChoice::Cpu)]
    backend: BackendChoice,
    /// Quads along the ring and around the tube of each torus
    #[arg(long, value_delimiter = ',', value_parser = sides,
        default_values = ["16x8", "32x16", "64x16", "128x64"])]
    torus: Vec<[u32; 2]>,
    /// Methods, which all surfaces use that can
    #[arg(long, value_delimiter = ',', default_values = ["quadtree", "relief"])]
    method: Vec<String>,
    /// Surfaces beside plane; all, unless told
    #[arg(long, value_parser = BESIDE_PLANE)]
    surface: Vec<String>,
    /// Size of the pictures, as WIDTHxHEIGHT
    #[arg(long, default_value = "400x300", value_parser = sides)]
    size: [u32; 2],
    /// Metres between the heights 0 and 1, on meshes that are 1 m large
    #[arg(long, default_value_t = 0.03)]
    scale: f64,
    /// Where the relief lies
    #[arg(long, value_enum, default_value_t = Lies::Carved)]
    relief: Lies,
    /// With a light and a shadow ray a pixel, as pictures have unless told otherwise
    #[arg(long)]
    shadows: bool,
    /// Frames of each; medians count
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..=1000))]
    rounds: u16,
}

/// Two numbers with an x between them.
pub fn sides(text: &str) -> Result<[u32; 2], String> {
    let sides = text.split_once('x').and_then(|(a, b)| Some([a.parse().ok()?, b.parse().ok()?]));
    sides.ok_or_else(|| "it must be two numbers, as 32x16".to_owned())
}

const PLANE: Drawn = Drawn::flat("plane");
const VERTICAL: Drawn = Drawn::flat("quadric-vertical");
const PRISM: Drawn = Drawn::flat("prism");

/// What is measured; the first one is what all others are beside of.
const SURFACES: [(&str, Drawn); 7] = [
    ("plane", PLANE),
    ("quadric-vertical", VERTICAL),
    ("quadric-vertical, two", Drawn { two_coefficients: true, ..VERTICAL }),
    ("quadric-perpendicular", Drawn::flat("quadric-perpendicular")),
    ("tetrahedra", Drawn::flat("tetrahedra")),
    ("prism", PRISM),
    ("prism, lifted", Drawn { lifted: true, ..PRISM }),
];

/// What those beside plane are called.
const BESIDE_PLANE: [&str; 6] = [
    "quadric-vertical",
    "quadric-vertical, two",
    "quadric-perpendicular",
    "tetrahedra",
    "prism",
    "prism, lifted",
];

/// A surface on its way.
struct Runner {
    name: &'static str,
    scene: Scene,
    renderer: Renderer,
    maps: Maps,
    cpu: Samples,
    wall: Samples,
    seen: usize,
    reads: f64,
}

/// Prints the table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let map = cobbles()?;
    let mut table = table(&[
        "triangles",
        "method",
        "surface",
        "processor ms",
        "over plane",
        "wall ms",
        "over plane",
        "pixels seen",
        "reads a pixel",
    ]);
    // There the processor waits, and frames are timed without reading them back.
    let on_hardware = arguments.backend == BackendChoice::Gpu && Gpu::new(AdapterChoice::Real).is_ok();
    let (mut device, mut missed) = (String::new(), Vec::new());
    for divisions in &arguments.torus {
        for method in &arguments.method {
            let runners = measured(arguments, *divisions, method, &map, on_hardware, &mut device)?;
            let Some(plane) = runners.first() else { continue };
            let triangles = 2 * divisions[0] as usize * divisions[1] as usize;
            for runner in &runners {
                let [cpu, wall] =
                    [runner.cpu.over(&plane.cpu).median(), runner.wall.over(&plane.wall).median()];
                let most = match runner.name {
                    "quadric-vertical" => AIM_QUADRIC,
                    "prism" if triangles <= AIM_PRISM_TRIANGLES => AIM_PRISM,
                    _ => f64::INFINITY,
                };
                let ratio = if on_hardware { wall } else { cpu };
                if ratio > most {
                    missed.push(format!("{} {ratio:.2} ({triangles}, {method})", runner.name));
                }
                table.add_row([
                    triangles.to_string(),
                    method.clone(),
                    runner.name.to_owned(),
                    runner.cpu.to_string(),
                    format!("{cpu:.2}"),
                    runner.wall.to_string(),
                    format!("{wall:.2}"),
                    runner.seen.to_string(),
                    format!("{:.1}", runner.reads),
                ]);
            }
        }
    }
    let [width, height] = arguments.size;
    println!(
        "A torus of {} cobbles, {}, {width}x{height} pixels, {} shadows, {} frames of each in turn; medians, \
         with the least and the greatest. Processor time is that of all threads{}. On {device}.\n\n{table}\n",
        format_args!("{}x{}", TILES.x, TILES.y),
        arguments.relief.name(),
        if arguments.shadows { "with" } else { "no" },
        arguments.rounds,
        if on_hardware { "; the other one is without reading back" } else { "" },
    );
    println!(
        "Aims, in {} over that of plane: quadric-vertical {AIM_QUADRIC}, prism {AIM_PRISM} up to \
         {AIM_PRISM_TRIANGLES} triangles. {}",
        if on_hardware { "the time of a frame" } else { "processor time" },
        if missed.is_empty() {
            "Reached everywhere.".to_owned()
        } else {
            format!("Missed: {}.", missed.join(", "))
        }
    );
    Ok(())
}

/// The scene with shadows of a light.
fn lit(scene: &Scene, mut selection: Selection) -> Result<Scene, String> {
    selection.choose("shadow", "ray").map_err(|error| error.to_string())?;
    let surfaces = scene.surfaces().iter().map(|surface| surface.clone().with_selection(selection));
    let light = Light::directional(TO_LIGHT, Vec3::ONE).map_err(|error| error.to_string())?;
    let lit = scene.to_builder().surfaces(surfaces.collect()).lights(vec![light]);
    lit.build().map_err(|error| error.to_string())
}

/// The frames of all surfaces that can use a method on a torus, one after the other in each round.
fn measured(
    arguments: &Arguments,
    [around, tube]: [u32; 2],
    method: &str,
    map: &HeightMap,
    on_hardware: bool,
    device: &mut String,
) -> Result<Vec<Runner>, String> {
    let Arguments { backend, size, scale, relief, rounds, shadows, .. } = *arguments;
    let mesh = torus(around, tube).and_then(|mesh| mesh.tiled(TILES)).map_err(|error| error.to_string())?;
    let curved = Curved::new(mesh, map, scale, relief.bias_m(scale));
    let name = relief_shaders::method(method).map_err(|error| error.to_string())?.name;
    let camera = curved.camera(FROM, 1.0);
    let mut runners = Vec::new();
    for (surface, drawn) in SURFACES {
        let is_wanted = arguments.surface.is_empty() || surface == SURFACES[0].0;
        if !is_wanted && !arguments.surface.iter().any(|wanted| wanted == surface) {
            continue;
        }
        let drawn = Drawn { method: name, ..drawn };
        let selection = drawn.selection();
        if selection.check_pair().is_err() || selection.check().is_err() {
            continue;
        }
        let scene = curved.scene(drawn, camera, size, backend);
        runners.push(Runner {
            name: surface,
            scene: if shadows { lit(&scene, selection)? } else { scene },
            renderer: Renderer::new(backend, Sampling::Exact).map_err(|error| error.to_string())?,
            maps: Maps::in_memory(),
            cpu: Samples::default(),
            wall: Samples::default(),
            seen: 0,
            reads: 0.0,
        });
    }
    // The first frames make ready what is kept.
    for round in 0..=rounds {
        for runner in &mut runners {
            let (start, cpu) = (Instant::now(), ProcessTime::now());
            let rendered = runner.renderer.render(&runner.scene, &mut runner.maps, &Watch::none());
            let (wall_ms, cpu_ms) = (1e3 * start.elapsed().as_secs_f64(), 1e3 * cpu.elapsed().as_secs_f64());
            let rendered = rendered.map_err(|error| error.to_string())?;
            let wall_ms = match on_hardware {
                true => {
                    let time = runner.renderer.time(&runner.scene, &mut runner.maps, &Watch::none());
                    1e3 * time.map_err(|error| error.to_string())?.elapsed.as_secs_f64()
                }
                false => wall_ms,
            };
            if round > 0 {
                runner.cpu.push(cpu_ms);
                runner.wall.push(wall_ms);
            } else {
                let seen = || rendered.rendering.pixels.iter().filter(|pixel| pixel.hit == 1);
                runner.seen = seen().count();
                let reads: f64 = seen().map(|pixel| f64::from(pixel.reads)).sum();
                runner.reads = reads / runner.seen.max(1) as f64;
                *device = rendered.info.device;
            }
        }
    }
    Ok(runners)
}
