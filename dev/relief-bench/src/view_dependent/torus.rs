//! View-dependent and generalised maps on a torus, beside other methods and at three sizes of the map.

use std::sync::Arc;

use glam::{DVec3, Vec2};
use relief_bake::volumes::volume_from_heights;
use relief_core::camera::Camera;
use relief_core::mesh::torus;
use relief_core::{HeightMap, MapFormat, Volume, Watch, Wrap};
use relief_io::{HeightOptions, read_height};
use relief_maps::Maps;
use relief_render::render;
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use relief_tests::accuracy::sample_maps;
use relief_tests::baked::maps_in;
use relief_tests::volume_rays;

use crate::samples::Samples;
use crate::table::table;

/// Columns and rows of the maps.
const SIDES: [u32; 3] = [64, 128, 256];

/// Metres of displacement, tiles along the ring and around the tube, and pixels.
const SCALE_M: f64 = 0.02;
const TILES: Vec2 = Vec2::new(6.0, 2.0);
const PIXELS: [u32; 2] = [512, 384];

/// Pixels within which a hit is near the outline.
const NEAR: i64 = 6;

/// Texels by which a hit is off.
const OFF: f64 = 0.5;

/// Frames that are timed.
const ROUNDS: u32 = 3;

/// Slices of a volume of heights.
const SLICES: u32 = 16;

const BENT: &[(&str, f64)] = &[("search.bends", 4.0)];

/// Methods over heights, on quadrics.
const METHODS: [(&str, &[(&str, f64)]); 9] = [
    ("view-dependent", BENT),
    ("view-dependent-svd", BENT),
    ("view-dependent-clusters", BENT),
    ("view-dependent-free", BENT),
    ("relief", &[]),
    ("occlusion", &[]),
    ("cone", &[]),
    ("frustum", &[]),
    ("exact", &[]),
];

/// Methods over the volume of the same heights, on flat triangles.
const OF_VOLUMES: [&str; 2] = ["voxels", "generalised"];

/// Prints the table.
pub fn run() -> Result<(), String> {
    let mut rows = table(&[
        "map",
        "surface",
        "method",
        "map, MB",
        "reads a pixel",
        "off by 1/2 texel, inside",
        "near the outline",
        "lost",
        "late",
        "median, texels",
        "p99",
        "frame, ms",
    ]);
    for side in SIDES {
        let map = cobbles(side)?;
        let flat = truth(&map, "plane")?;
        let bent = truth(&map, "quadric-vertical")?;
        for (method, set) in METHODS {
            let mut selection = selection(method, "quadric-vertical")?;
            for (key, value) in set {
                selection.set(key, *value).map_err(|error| error.to_string())?;
            }
            let format =
                if method.starts_with("view-dependent") { MapFormat::Unorm8 } else { MapFormat::F32 };
            let maps = maps_in(format, &map, &selection);
            let bytes = maps.iter().map(|map| map.layout().bytes()).sum();
            let scene = scene(Surface::new(ring()?, Arc::clone(&map)).with_selection(selection))?;
            rows.add_row(row(side, "quadric-vertical", method, bytes, &scene, &bent)?);
        }
        if side > SIDES[1] {
            // In 256 directions it takes gigabytes.
            continue;
        }
        let volume = volume(&map, side)?;
        for method in OF_VOLUMES {
            let selection = selection(method, "plane")?;
            let sized = selection.with_solids(relief_shaders::field::Solids::Volumes);
            let maps = volume_rays::baked(&volume, &sized.with_volume_size(volume.size()));
            let baked: u64 = maps.iter().map(|map| map.layout().texels()).sum();
            let bytes = baked + volume.size().map(u64::from).iter().product::<u64>();
            let surface = Surface::new(ring()?, ground()?).with_volume(volume.clone());
            rows.add_row(row(
                side,
                "plane",
                method,
                bytes,
                &scene(surface.with_selection(selection))?,
                &flat,
            )?);
        }
    }
    println!("{rows}\n");
    Ok(())
}

fn cobbles(side: u32) -> Result<Arc<HeightMap>, String> {
    let options = HeightOptions::default();
    let map = read_height(&sample_maps().join("cobbles.png"), &options).map_err(|error| error.to_string())?;
    let texel =
        |i: u32, j: u32| map.texel(i64::from(i * map.width() / side), i64::from(j * map.height() / side));
    let map = HeightMap::from_fn(side, side, Wrap::Repeat, texel).map_err(|error| error.to_string())?;
    let map = map.with_displacement(SCALE_M, 0.0).map_err(|error| error.to_string())?;
    Ok(Arc::new(map))
}

fn volume(map: &HeightMap, side: u32) -> Result<Volume, String> {
    volume_from_heights(map, [side, side, SLICES], &Watch::none()).map_err(|error| error.to_string())
}

fn ring() -> Result<relief_core::mesh::Mesh, String> {
    torus(64, 32).and_then(|mesh| mesh.tiled(TILES)).map_err(|error| error.to_string())
}

fn ground() -> Result<HeightMap, String> {
    HeightMap::new(1, 1, vec![0.0], Wrap::Repeat).map_err(|error| error.to_string())
}

fn selection(method: &str, surface: &str) -> Result<Selection, String> {
    let mut selection = Selection::method(method).map_err(|error| error.to_string())?;
    for (stage, name) in [("surface", surface), ("shadow", "none")] {
        selection.choose(stage, name).map_err(|error| error.to_string())?;
    }
    Ok(selection)
}

fn scene(surface: Surface) -> Result<Scene, String> {
    let camera =
        Camera::new(DVec3::new(0.2, 0.85, 1.05), DVec3::ZERO, 40.0).map_err(|error| error.to_string())?;
    let builder = Scene::builder(surface).camera(camera).size(PIXELS[0], PIXELS[1]).samples(1);
    builder.backend(BackendChoice::Cpu).build().map_err(|error| error.to_string())
}

fn pixels(scene: &Scene) -> Result<Vec<PixelOut>, String> {
    let rendered = render(scene, &mut Maps::in_memory(), &Watch::none());
    Ok(rendered.map_err(|error| error.to_string())?.rendering.pixels)
}

/// What the exact method shows on a surface.
fn truth(map: &Arc<HeightMap>, surface: &str) -> Result<Vec<PixelOut>, String> {
    let surface = Surface::new(ring()?, Arc::clone(map)).with_selection(selection("exact", surface)?);
    pixels(&scene(surface)?)
}

fn row(
    side: u32,
    surface: &str,
    method: &str,
    bytes: u64,
    scene: &Scene,
    truth: &[PixelOut],
) -> Result<Vec<String>, String> {
    let shown = pixels(scene)?;
    let reads = shown.iter().filter(|pixel| pixel.hit == 1).map(|pixel| f64::from(pixel.reads)).sum::<f64>();
    let hits = shown.iter().filter(|pixel| pixel.hit == 1).count().max(1) as f64;
    let (mut counts, mut offs, mut lost, mut late, mut apart) = ([0.0; 2], [0.0; 2], 0.0, 0.0, Vec::new());
    for (at, (a, b)) in truth.iter().zip(&shown).enumerate().filter(|(_, (a, _))| a.hit == 1) {
        let place = usize::from(is_near_outline(truth, at));
        counts[place] += 1.0;
        if b.hit == 0 {
            lost += 1.0;
            offs[place] += 1.0;
            continue;
        }
        // Tiles are all alike.
        let beside = [a.uv.x - b.uv.x, a.uv.y - b.uv.y].map(f64::from);
        let beside = beside.map(|beside| (beside - beside.round()) * f64::from(side));
        let texels = beside[0].hypot(beside[1]);
        apart.push(texels);
        if texels > OFF {
            offs[place] += 1.0;
            late += f64::from(u8::from(b.depth > a.depth));
        }
    }
    apart.sort_by(f64::total_cmp);
    let quantile = |part: f64| apart.get((part * apart.len() as f64) as usize).copied().unwrap_or(0.0);
    let all = counts[0] + counts[1];
    let share = |part: f64, whole: f64| format!("{:.1} %", 100.0 * part / whole.max(1.0));
    Ok(vec![
        format!("{side}x{side}"),
        surface.to_owned(),
        method.to_owned(),
        format!("{:.2}", bytes as f64 / 1e6),
        format!("{:.1}", reads / hits),
        share(offs[0], counts[0]),
        share(offs[1], counts[1]),
        share(lost, all),
        share(late, all),
        format!("{:.3}", quantile(0.5)),
        format!("{:.2}", quantile(0.99)),
        format!("{:.0}", Samples::of_pictures(scene, BackendChoice::Cpu, ROUNDS)?.median()),
    ])
}

/// Whether one of the pixels around shows nothing.
fn is_near_outline(pixels: &[PixelOut], at: usize) -> bool {
    let [width, height] = PIXELS.map(i64::from);
    let (x, y) = (at as i64 % width, at as i64 / width);
    let shows_nothing = |x: i64, y: i64| {
        let is_inside = (0..width).contains(&x) && (0..height).contains(&y);
        is_inside && pixels[(y * width + x) as usize].hit == 0
    };
    (-NEAR..=NEAR).any(|dy| (-NEAR..=NEAR).any(|dx| shows_nothing(x + dx, y + dy)))
}
