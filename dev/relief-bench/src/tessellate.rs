//! `tessellate`: triangles per second that a GPU makes from a height map for a moving camera.

use clap::Args;
use glam::{DQuat, DVec3, Vec2};
use relief_core::camera::{Camera, Projection};
use relief_core::mesh::{Mesh, rectangle, sphere, torus};
use relief_core::{ByteSize, Watch};
use relief_maps::Maps;
use relief_render::Renderer;
use relief_render::gpu::{AdapterChoice, Gpu};
use relief_scene::{Sampling, Scene, Surface};
use relief_shaders::Selection;

use crate::samples::Samples;
use crate::surfaces::bases::cobbles;
use crate::table::table;

/// Triangles a second, in thousand millions, that are to be reached, and that are aimed at.
const LEAST: f64 = 2.0;
const AIM: f64 = 10.0;

/// Arguments of `tessellate`.
#[derive(Args)]
pub struct Arguments {
    /// Tiles of 256x256 texels along each side of the plane, each texel of two triangles
    #[arg(long, default_value_t = 4, value_parser = clap::value_parser!(u32).range(1..=60))]
    tiles: u32,
    /// Columns and rows of the picture whose pixels say how fine triangles are
    #[arg(long, default_value_t = 512, value_parser = clap::value_parser!(u32).range(8..=8192))]
    side: u32,
    /// Views of each; medians count
    #[arg(long, default_value_t = 9, value_parser = clap::value_parser!(u16).range(1..=1000))]
    rounds: u16,
}

/// Prints the table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let tiles = arguments.tiles as f32;
    let tiled = |mesh: Result<Mesh, _>, along: Vec2| {
        mesh.and_then(|mesh: Mesh| mesh.tiled(along)).map_err(|error| error.to_string())
    };
    let bases = [
        ("plane 64x64", tiled(rectangle([1.0, 1.0], 64), Vec2::splat(tiles))?),
        ("torus 128x64", tiled(torus(128, 64), Vec2::new(tiles, tiles / 2.0))?),
        ("sphere 128x64", tiled(sphere(128, 64), Vec2::new(tiles, tiles / 2.0))?),
    ];
    let ways: [(&str, &[(&str, f64)]); 3] = [
        ("a vertex every texel", &[("geometry.texels", 1.0)]),
        ("by pixels, pattern", &[]),
        ("by pixels, sweep", &[("geometry.interior", 1.0)]),
    ];
    let gpu = Gpu::new(AdapterChoice::Any).map_err(|error| error.to_string())?;
    let device = gpu.description().to_owned();
    let mut renderer = Renderer::on_gpu(gpu, Sampling::Exact);
    let mut rows = table(&["base", "how fine", "triangles", "made in ms", "thousand millions/s"]);
    for ((name, mesh), (way, settings)) in bases.iter().flat_map(|base| ways.map(|way| (base, way))) {
        let scene = scene(mesh.clone(), settings, arguments.side)?;
        let (mut ms, mut rate, mut triangles) = (Samples::default(), Samples::default(), 0);
        // The first view is not counted: programs are compiled and maps are uploaded for it.
        for round in 0..=arguments.rounds {
            let camera = scene.camera();
            let turn = DQuat::from_rotation_y(0.02 * f64::from(round));
            let eye = camera.target() + turn * (camera.eye() - camera.target());
            let mut seen = scene.clone();
            seen.set_camera(camera.moved(eye, camera.target()).map_err(|error| error.to_string())?);
            let time = renderer.time(&seen, &mut Maps::in_memory(), &Watch::none());
            let time = time.map_err(|error| error.to_string())?;
            let Some(passes) = time.passes else { return Err(format!("{device} has no clock")) };
            if round > 0 {
                let seconds = passes.make.as_secs_f64();
                triangles = triangles.max(time.made_triangles);
                ms.push(1e3 * seconds);
                rate.push(time.made_triangles as f64 / seconds / 1e9);
            }
        }
        rows.add_row([
            (*name).to_owned(),
            way.to_owned(),
            triangles.to_string(),
            ms.to_string(),
            rate.to_string(),
        ]);
    }
    println!(
        "Cobbles for a camera that moves, by the clock of {device}: culled, counted, numbered and made, \
         without drawing; medians of {} views with the least and the greatest.\n\n{rows}\n\nAim: {LEAST} \
         thousand millions a second, and {AIM}.",
        arguments.rounds
    );
    Ok(())
}

/// Cobbles on a mesh, without shadows, one sample a pixel.
fn scene(mesh: Mesh, settings: &[(&str, f64)], side: u32) -> Result<Scene, String> {
    let text = |error: &dyn std::fmt::Display| error.to_string();
    let map = cobbles()?.with_displacement(0.01, 0.0).map_err(|error| text(&error))?;
    let mut selection = Selection::method("tessellate").map_err(|error| text(&error))?;
    selection.choose("shadow", "none").map_err(|error| text(&error))?;
    for (key, value) in settings {
        selection.set(key, *value).map_err(|error| text(&error))?;
    }
    let projection = Projection::Perspective { fov_degrees: 40.0 };
    let camera = Camera::with(DVec3::new(0.2, 1.3, 0.9), DVec3::ZERO, projection);
    let surface = Surface::new(mesh, map).with_selection(selection);
    let builder = Scene::builder(surface).camera(camera.map_err(|error| text(&error))?);
    let builder = builder.size(side, side).samples(1).geometry_memory(ByteSize(4 << 30));
    builder.build().map_err(|error| text(&error))
}
