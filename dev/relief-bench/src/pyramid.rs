//! `pyramid`: what a changed height map costs a GPU renderer whose search reads a pyramid, where it builds
//! that itself and where it is baked on the CPU and uploaded.

use std::time::Instant;

use clap::Args;
use glam::DVec3;
use relief_core::camera::Camera;
use relief_core::mesh::square;
use relief_core::{HeightMap, Watch, Wrap};
use relief_maps::Maps;
use relief_render::gpu::{AdapterChoice, Gpu};
use relief_render::{Rendered, Renderer};
use relief_scene::{Sampling, Scene, Surface};
use relief_shaders::Selection;
use relief_testing::maps::fractal;

use crate::samples::Samples;
use crate::table::table;

/// Rows and columns of the pictures: few, so that pixels take next to no time.
const SIDE: u32 = 16;

/// Arguments of `pyramid`.
#[derive(Args)]
pub struct Arguments {
    /// Sides of the maps, in texels
    #[arg(long, value_delimiter = ',', default_values_t = [256, 512, 1024, 2048],
        value_parser = clap::value_parser!(u32).range(1..=16_384))]
    sizes: Vec<u32>,
    /// Changes of each map; the median counts
    #[arg(long, default_value_t = 9, value_parser = clap::value_parser!(u16).range(1..=1000))]
    rounds: u16,
}

/// Milliseconds from a changed height map to a picture of it.
#[derive(Default)]
struct Measured {
    /// Where the search reads no map: of the upload of the heights and the picture.
    without: Samples,
    /// Where the pyramid is built on the GPU.
    built: Samples,
    /// Where it is baked on the CPU and uploaded.
    baked: Samples,
    /// Of the bake alone.
    bake: Samples,
}

/// Prints the table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let gpu = Gpu::new(AdapterChoice::Any).map_err(|error| error.to_string())?;
    let mut table = table(&[
        "map",
        "no pyramid ms",
        "built on the GPU ms",
        "baked and uploaded ms",
        "of that the bake ms",
        "built over baked",
        "the same without what both take",
    ]);
    for side in &arguments.sizes {
        let Measured { without, built, baked, bake } = measure(&gpu, *side, arguments.rounds)?;
        let [alone, other] = [&built, &baked].map(|samples| samples.median() - without.median());
        table.add_row([
            format!("{side}²"),
            without.to_string(),
            built.to_string(),
            baked.to_string(),
            bake.to_string(),
            format!("{:.2}", built.over(&baked).median()),
            format!("{:.2}", alone / other),
        ]);
    }
    println!(
        "From a changed height map to a picture of {SIDE}x{SIDE} pixels, {} changes of each, medians with \
         the least and the greatest. On {}, bakes on {} threads. Both pictures are the same to the bit.\n\n\
         {table}",
        arguments.rounds,
        gpu.description(),
        rayon::current_num_threads(),
    );
    Ok(())
}

fn measure(gpu: &Gpu, side: u32, rounds: u16) -> Result<Measured, String> {
    let [exact, pyramid] = [selection("cells")?, selection("pyramid")?];
    let [mut without, mut built, mut baked] = [0; 3].map(|_| Renderer::on_gpu(gpu.clone(), Sampling::Exact));
    let mut measured = Measured::default();
    // The first round compiles the programs.
    for round in 0..=rounds {
        let texels = fractal(u64::from(round), side, side, 0.55);
        let map = HeightMap::new(side, side, texels, Wrap::Repeat).map_err(|error| error.to_string())?;
        let map = map.with_displacement(0.05, -0.05).map_err(|error| error.to_string())?;
        let [plain, searched] = [scene(&map, exact)?, scene(&map, pyramid)?];
        let (_, without_ms) = timed(|| picture(&mut without, &plain, &mut Maps::in_memory()))?;
        let (one, built_ms) = timed(|| picture(&mut built, &searched, &mut Maps::in_memory()))?;
        let mut maps = Maps::in_memory();
        let metric = searched.surfaces()[0].metric();
        let ((), bake_ms) = timed(|| {
            let provided = maps.provide(&pyramid, &map, metric, &Watch::none());
            provided.map(drop).map_err(|error| error.to_string())
        })?;
        let (other, upload_ms) = timed(|| picture(&mut baked, &searched, &mut maps))?;
        if [built.last_work().built, baked.last_work().built] != [1, 0] {
            return Err("a pyramid was not made as it should be".to_owned());
        }
        if one.rendering != other.rendering {
            return Err("a pyramid that is built differs from one that is baked".to_owned());
        }
        if round > 0 {
            measured.without.push(without_ms);
            measured.built.push(built_ms);
            measured.baked.push(bake_ms + upload_ms);
            measured.bake.push(bake_ms);
        }
    }
    Ok(measured)
}

/// A search with nothing else that reads a map.
fn selection(search: &str) -> Result<Selection, String> {
    let mut selection = Selection::pair(search, "patch").map_err(|error| error.to_string())?;
    selection.choose("shadow", "none").map_err(|error| error.to_string())?;
    Ok(selection)
}

fn scene(map: &HeightMap, selection: Selection) -> Result<Scene, String> {
    let mesh = square(1).map_err(|error| error.to_string())?;
    let surface = Surface::new(mesh, map.clone()).with_selection(selection);
    let camera = Camera::new(DVec3::new(0.6, 0.9, 1.1), DVec3::ZERO, 40.0);
    let camera = camera.map_err(|error| error.to_string())?;
    let scene = Scene::builder(surface).size(SIDE, SIDE).samples(1).camera(camera);
    scene.build().map_err(|error| error.to_string())
}

fn picture(renderer: &mut Renderer, scene: &Scene, maps: &mut Maps) -> Result<Rendered, String> {
    renderer.render(scene, maps, &Watch::none()).map_err(|error| error.to_string())
}

/// What was made, and in how many milliseconds.
fn timed<T>(make: impl FnOnce() -> Result<T, String>) -> Result<(T, f64), String> {
    let start = Instant::now();
    let made = make()?;
    Ok((made, 1e3 * start.elapsed().as_secs_f64()))
}
