//! `shell-map`: rays to a motif in shells beside Embree over the same motif as triangles.

use std::path::PathBuf;

use clap::Args;
use cpu_time::ProcessTime;
use glam::{DVec3, Vec2};
use relief_core::camera::{Camera, Ray};
use relief_core::mesh::{Mesh, RawMesh, torus};
use relief_core::{HeightMap, Watch, Wrap};
use relief_maps::Maps;
use relief_mesh::motif::{MotifKind, MotifSettings, motif};
use relief_mesh::shell_map::{ShellMapSettings, map_shells, motif_for_rays};
use relief_render::Renderer;
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;

use super::python;
use super::tessellation::Triangles;
use super::{differences, shuffled};
use crate::memory;
use crate::python::require;
use crate::samples::Samples;
use crate::table::table;
use crate::trace::measure::pool;

/// The parts of Embree's memory and of its rays a second that are asked for.
const MEMORY: f64 = 0.01;
const RATE: f64 = 0.1;

/// Arguments of `shell-map`.
#[derive(Args)]
pub struct Arguments {
    /// A Python with numpy and embreex
    #[arg(long, default_value = "python3")]
    python: PathBuf,
    /// Size of the picture, as WIDTHxHEIGHT
    #[arg(long, default_value = "800x600", value_parser = crate::cost::sides)]
    size: [u32; 2],
    /// Tiles along the texture of the mesh
    #[arg(long, default_value_t = 20)]
    tiles: u16,
    /// Sides around a link
    #[arg(long, default_value_t = 14)]
    detail: u32,
    /// Metres between the heights 0 and 1; the mesh is 1 to 2 m large
    #[arg(long, default_value_t = 0.02)]
    scale: f64,
    /// Runs of each; medians count
    #[arg(long, default_value_t = 3, value_parser = clap::value_parser!(u16).range(1..=1000))]
    rounds: u16,
}

/// What a run of ours takes.
struct Ours {
    bytes: usize,
    prepared_s: Samples,
    rate: Samples,
    depths: Vec<Option<f64>>,
}

/// Prints the table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let (name, base) = match relief_tests::spot("spot_triangulated.obj") {
        Some(spot) => ("spot", spot),
        None => ("a torus", torus(64, 32).map_err(|error| error.to_string())?),
    };
    let tiles = Vec2::splat(arguments.tiles.into());
    let base = base.tiled(tiles).map_err(|error| error.to_string())?;
    let settings =
        MotifSettings { count: 1, detail: arguments.detail, ..MotifSettings::new(MotifKind::Mail) };
    let links: RawMesh = (&motif(&settings).map_err(|error| error.to_string())?.mesh).into();
    let shells = ShellMapSettings { scale_m: arguments.scale, ..ShellMapSettings::default() };
    let forward = map_shells(&base, &links, &shells, &Watch::none()).map_err(|error| error.to_string())?;
    let triangles = Triangles {
        points: forward.mesh.vertices().iter().map(|vertex| vertex.position.to_array()).collect(),
        corners: forward.mesh.triangles().to_vec(),
    };
    let camera =
        Camera::new(DVec3::new(1.4, 1.2, -2.4), DVec3::ZERO, 40.0).map_err(|error| error.to_string())?;
    let [columns, rows] = arguments.size;
    let rays: Vec<Ray> =
        (0..columns * rows).map(|at| camera.ray(at % columns, at / columns, columns, rows)).collect();
    println!(
        "{name}, {} triangles, {}x{} tiles; a motif of {} triangles, {} as triangles in the shells. One \
         thread, processor time, medians of {} runs. Picture: {columns}x{rows} pixels, shaded without \
         shadows.\n",
        base.triangles().len(),
        arguments.tiles,
        arguments.tiles,
        links.triangles.len(),
        triangles.corners.len(),
        arguments.rounds,
    );
    drop(forward);
    let ours = pool(1)?.install(|| measured(&base, &links, camera, arguments))?;
    let mut rows =
        table(&["tracer", "bytes", "part", "preparation ms", "rays/s", "part", "hits otherwise", "p99 m"]);
    let answer = match require(&arguments.python, "import embreex, numpy", "embreex") {
        Err(reason) => {
            println!("Embree is left out: {reason}\n");
            None
        }
        Ok(()) => {
            let mixed = shuffled(&rays);
            let sets = [("picture", &rays[..]), ("shuffled", &mixed[..])];
            Some(python::measured(&arguments.python, &triangles, &sets, arguments.rounds)?)
        }
    };
    let mut parts = None;
    let mut last = ["-".to_owned(), "-".to_owned()];
    if let Some(answer) = &answer {
        let (rate, depths) = &answer.sets["picture"];
        let [otherwise, _, far] = differences(&ours.depths, depths);
        last = [format!("{:.3} %", 100.0 * otherwise), format!("{far:.6}")];
        parts = Some([ours.bytes as f64 / answer.bytes, ours.rate.median() / rate]);
        rows.add_row([
            format!("Embree (embreex {})", answer.version),
            format!("{:.0}", answer.bytes),
            "1".to_owned(),
            format!("{:.0}", 1e3 * answer.build_s[0]),
            format!("{rate:.0}"),
            "1".to_owned(),
            "-".to_owned(),
            "-".to_owned(),
        ]);
    }
    let part = |at: usize| parts.map_or("-".to_owned(), |parts| format!("{:.4}", parts[at]));
    let [otherwise, far] = last;
    rows.add_row([
        "shell-map".to_owned(),
        ours.bytes.to_string(),
        part(0),
        ours.prepared_s.times(1e3).to_string(),
        format!("{:.0}", ours.rate.median()),
        part(1),
        otherwise,
        far,
    ]);
    println!("{rows}\n");
    if let Some([bytes, rate]) = parts {
        let verdict = |holds: bool| if holds { "reached" } else { "missed" };
        println!("At most {MEMORY} of the memory: {}.", verdict(bytes <= MEMORY));
        println!("At least {RATE} of the rays a second: {}.", verdict(rate >= RATE));
    }
    Ok(())
}

/// Measures the renderer, from the meshes on.
fn measured(base: &Mesh, links: &RawMesh, camera: Camera, arguments: &Arguments) -> Result<Ours, String> {
    let mut ours =
        Ours { bytes: 0, prepared_s: Samples::default(), rate: Samples::default(), depths: Vec::new() };
    for _ in 0..arguments.rounds {
        let start = ProcessTime::now();
        let (kit, held) = memory::held(|| Kit::new(base, links, camera, arguments.scale));
        ours.prepared_s.push(start.elapsed().as_secs_f64());
        let mut kit = kit?;
        ours.bytes = held;
        let (seconds, depths) = kit.frame(arguments.size)?;
        ours.rate.push(depths.len() as f64 / seconds);
        ours.depths = depths;
    }
    Ok(ours)
}

/// Everything that a frame needs.
struct Kit {
    scene: Scene,
    renderer: Renderer,
    maps: Maps,
}

impl Kit {
    /// All of it from the meshes on, which are copied: with a picture of one pixel.
    fn new(base: &Mesh, links: &RawMesh, camera: Camera, scale_m: f64) -> Result<Self, String> {
        let tree = motif_for_rays(links).map_err(|error| error.to_string())?.tree;
        let ground = HeightMap::new(1, 1, vec![0.0], Wrap::Repeat).map_err(|error| error.to_string())?;
        let mut method = Selection::method("shell-map").map_err(|error| error.to_string())?;
        method.choose("shadow", "none").map_err(|error| error.to_string())?;
        let surface = Surface::new(base.clone(), ground).with_motif(tree, scale_m, 0.0);
        let surface = surface.map_err(|error| error.to_string())?.with_selection(method);
        let scene = Scene::builder(surface).camera(camera).size(1, 1).samples(1).backend(BackendChoice::Cpu);
        let scene = scene.build().map_err(|error| error.to_string())?;
        let mut kit = Self { scene, renderer: Renderer::on_cpu(), maps: Maps::in_memory() };
        kit.frame([1, 1])?;
        Ok(kit)
    }

    /// Seconds of processor time of a picture, and its depths.
    fn frame(&mut self, size: [u32; 2]) -> Result<(f64, Vec<Option<f64>>), String> {
        let scene =
            self.scene.to_builder().size(size[0], size[1]).build().map_err(|error| error.to_string())?;
        let start = ProcessTime::now();
        let rendered = self.renderer.render(&scene, &mut self.maps, &Watch::none());
        let seconds = start.elapsed().as_secs_f64();
        let pixels = rendered.map_err(|error| error.to_string())?.rendering.pixels;
        let depths = pixels.iter().map(|pixel| (pixel.hit == 1).then_some(f64::from(pixel.depth)));
        Ok((seconds, depths.collect()))
    }
}
