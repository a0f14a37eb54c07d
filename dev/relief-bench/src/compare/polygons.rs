//! Two polygons with maps beside triangles at every texel, in time and bytes: Oh, Ki and Lee 2006, Figure 20.

use relief_compare::{Contender, Timing};
use relief_core::{HeightMap, Watch, Wrap};
use relief_maps::Maps;
use relief_render::Renderer;
use relief_render::gpu::{AdapterChoice, Gpu};
use relief_scene::{Sampling, Scene};
use relief_shaders::{SHADOW, STAGES};
use relief_testing::maps::fractal;

use super::{Arguments, compared, contender, on_square};
use crate::table::table;

/// Texels of a side of the map whose triangles are counted, two for each.
const SIDE: u32 = 256;

/// Bytes of a height.
const HEIGHT_BYTES: u64 = 4;

/// Pixels of a side of the picture.
const PICTURE: u32 = 512;

/// Methods on two polygons, and displaced vertices at every texel.
fn contenders() -> Result<Vec<Contender>, String> {
    let vertex = contender("vertex", &[("geometry.texels", 1.0)]);
    let of_rays =
        ["bump", "pyramidal", "pyramidal-bilinear", "quadtree", "cone"].map(|name| contender(name, &[]));
    of_rays.into_iter().chain([vertex]).collect()
}

/// Prints frames and bytes.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let texels = fractal(11, SIDE, SIDE, 0.5);
    let map = HeightMap::new(SIDE, SIDE, texels, Wrap::Repeat).map_err(|error| error.to_string())?;
    let machines = arguments.machines(&[Sampling::Exact]);
    let mut comparison = on_square("ground", map, [PICTURE; 2], machines)?;
    (comparison.rays, comparison.contenders) = (0, contenders()?);
    comparison.timing = Some(Timing { frames: arguments.frames, warm: 2, pixels: 1 });
    let records = compared(&comparison)?;
    for machine in &records.about.machines {
        let mut rows =
            table(&["method", "polygons", "frame ms", "95 % sure", "heights and maps MiB", "uploaded MiB"]);
        for (record, contender) in records
            .pictures
            .iter()
            .filter(|of| (&of.backend, &of.sampling) == (&machine.backend, &machine.sampling))
            .zip(&comparison.contenders)
        {
            let Some(times) = &record.times else { continue };
            let polygons = if contender.is_of_rays() { 2 } else { 2 * SIDE * SIDE };
            let is_of_gpu = machine.backend == "gpu";
            let uploaded = if is_of_gpu { Some(uploaded(&comparison.scene, contender)?) } else { None };
            rows.add_row([
                record.method.label(),
                polygons.to_string(),
                format!("{:.2}", times.frame_ms),
                format!("{:.2} to {:.2}", times.frame_low_ms, times.frame_high_ms),
                mebibytes(HEIGHT_BYTES * record.method.map_texels + record.method.map_bytes),
                uploaded.map_or("-".to_owned(), mebibytes),
            ]);
        }
        println!(
            "Two polygons beside {} triangles, a map of {SIDE}² and a picture of {PICTURE}x{PICTURE} pixels \
             without shadows, the triangles kept from frame to frame. {}, {} sampling, on {}\n\n{rows}\n",
            2 * SIDE * SIDE,
            machine.backend,
            machine.sampling,
            machine.device
        );
    }
    println!("The paper has 480 frames a second and 0.35 MB beside 50 and 2.1 MB.\n");
    Ok(())
}

fn mebibytes(bytes: u64) -> String {
    format!("{:.2}", bytes as f64 / f64::from(1 << 20))
}

/// Bytes that a GPU is given for the first picture.
fn uploaded(scene: &Scene, contender: &Contender) -> Result<u64, String> {
    let gpu = Gpu::new(AdapterChoice::Any).map_err(|error| error.to_string())?;
    let [surface] = scene.surfaces() else { return Err("one surface is compared".to_owned()) };
    let mut selection = contender.selection;
    selection.choose(STAGES[SHADOW].key, "none").map_err(|error| error.to_string())?;
    let surface = surface.clone().with_selection(selection);
    let scene = scene.to_builder().surfaces(vec![surface]).build().map_err(|error| error.to_string())?;
    let mut renderer = Renderer::on_gpu(gpu, Sampling::Exact);
    let rendered = renderer.render(&scene, &mut Maps::in_memory(), &Watch::none());
    rendered.map(|_| renderer.last_work().uploaded).map_err(|error| error.to_string())
}
