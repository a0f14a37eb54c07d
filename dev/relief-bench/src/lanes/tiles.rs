//! Camera rays against base meshes: tiles beside one ray at a time, and a frame that hardly does more.

use std::hint::black_box;
use std::sync::Arc;

use glam::Vec3;
use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, rectangle, sphere, torus};
use relief_core::raycast::tiles::{Area, Bins, PictureRays, TILE, TILE_POINTS, TileCaster, TileHits};
use relief_core::raycast::{RayCaster, Sides};
use relief_core::{Lanes, Watch};
use relief_maps::Maps;
use relief_render::Renderer;
use relief_scene::{Scene, Surface};
use relief_shaders::Selection;
use relief_testing::maps;

use super::frames::{camera, fastest, scene};
use crate::table::table;

const SIZE: [u32; 2] = [1000, 750];

/// Rows that are sorted into tiles at once.
const ROWS: u32 = 32;

/// How many times faster tiles are to be with lanes of a width.
const AIMS: [(Lanes, f64); 2] = [(Lanes::Eight, 3.0), (Lanes::Sixteen, 6.0)];

/// How many times faster a frame is to be in all.
const AIM_FRAME: f64 = 2.0;

pub fn run(rounds: u16) -> Result<(), String> {
    let mut missed = Vec::new();
    cast(rounds, &mut missed)?;
    frames(rounds, &mut missed)?;
    let verdict = if missed.is_empty() { "Reached everywhere".to_owned() } else { missed.join("; ") };
    let [eight, sixteen] = AIMS.map(|(_, aim)| aim);
    println!("Aim: tiles {eight} times and {sixteen} times faster, a frame {AIM_FRAME} times. {verdict}.");
    Ok(())
}

fn widths() -> impl Iterator<Item = Lanes> {
    Lanes::available().filter(|lanes| *lanes != Lanes::One)
}

fn meshes() -> Result<Vec<(&'static str, Mesh)>, String> {
    let made = [
        ("plane, 2 triangles", rectangle([1.0, 1.0], 1)),
        ("plane, 8192", rectangle([1.0, 1.0], 64)),
        ("sphere 96x48", sphere(96, 48)),
        ("torus 96x48", torus(96, 48)),
        ("sphere 512x256", sphere(512, 256)),
        ("sphere 1024x512", sphere(1024, 512)),
    ];
    made.into_iter().map(|(name, mesh)| Ok((name, mesh.map_err(|error| error.to_string())?))).collect()
}

/// The first hit of every pixel: its parameter's bits, the triangle, and whether it is a front.
type Seen = Option<(u64, u32, bool)>;

fn one_by_one(caster: &RayCaster, rays: &PictureRays, seen: &mut [Seen]) {
    for (y, row) in (0u32..).zip(seen.chunks_exact_mut(SIZE[0] as usize)) {
        for (x, seen) in (0u32..).zip(row) {
            let ray = rays.ray(PictureRays::point([x, y], [0.0; 2]));
            let hit = caster.next_hit(&ray, Sides::Front, None);
            *seen = hit.map(|hit| (hit.t.to_bits(), hit.triangle, hit.front));
        }
    }
}

fn by_tiles(caster: &RayCaster, rays: &PictureRays, lanes: Lanes, seen: &mut [Seen]) {
    let tiles = TileCaster::new(caster, *rays, SIZE, Sides::Front, lanes);
    let (mut bins, mut hits) = (Bins::new(), TileHits::new());
    for first in (0..SIZE[1]).step_by(ROWS as usize) {
        let area = Area { first: [0, first], size: [SIZE[0], ROWS.min(SIZE[1] - first)] };
        tiles.bin(area, [[0.0; 2]; 2], &mut bins);
        let [across, down] = area.tiles();
        for number in 0..across * down {
            let tile = [number % across, number / across];
            tiles.cast(&bins, tile, [0.0; 2], &mut hits);
            let [x, y] = area.pixel(tile);
            for point in 0..TILE_POINTS {
                let pixel = [x + (point % TILE) as u32, y + (point / TILE) as u32];
                if pixel[0] < SIZE[0] && pixel[1] < SIZE[1] {
                    // As the renderer reads them: mostly all is known.
                    let hit = if hits.is_miss(point) {
                        None
                    } else {
                        hits.first(point).or_else(|| tiles.hits(&hits, point).next())
                    };
                    let seen = &mut seen[(pixel[1] * SIZE[0] + pixel[0]) as usize];
                    *seen = hit.map(|hit| (hit.t.to_bits(), hit.triangle, hit.front));
                }
            }
        }
    }
}

fn cast(rounds: u16, missed: &mut Vec<String>) -> Result<(), String> {
    let count = (SIZE[0] * SIZE[1]) as usize;
    let rays = rays_of(&camera()?);
    let mut table =
        table(&["mesh", "lanes", "pixels with a hit", "one by one ns", "tiles ns", "times", "differing"]);
    for (name, mesh) in meshes()? {
        let caster = RayCaster::new(&mesh);
        let mut expected: Vec<Seen> = vec![None; count];
        for lanes in widths() {
            let mut found: Vec<Seen> = vec![None; count];
            let mut singly = || one_by_one(&caster, &rays, black_box(&mut expected));
            let mut together = || by_tiles(&caster, &rays, lanes, black_box(&mut found));
            let [one, tiles] = fastest(rounds, [&mut singly, &mut together]);
            let differing = expected.iter().zip(&found).filter(|(a, b)| a != b).count();
            let times = one / tiles;
            if differing > 0 || AIMS.iter().any(|(width, aim)| *width == lanes && times < *aim) {
                missed.push(format!("{name} with {lanes} lanes is missed"));
            }
            let ns = |seconds: f64| format!("{:.1}", seconds * 1e9 / count as f64);
            let covered = expected.iter().flatten().count() as f64 / count as f64;
            table.add_row([
                name.to_owned(),
                lanes.to_string(),
                format!("{:.0} %", 100.0 * covered),
                ns(one),
                ns(tiles),
                format!("{times:.1}"),
                differing.to_string(),
            ]);
        }
    }
    println!(
        "The first hits of {}x{} camera rays, on one thread, the fastest of {rounds} rounds, a pixel; tiles \
         with what sorts triangles into them.\n\n{table}\n",
        SIZE[0], SIZE[1]
    );
    Ok(())
}

/// The rays of a camera's picture.
fn rays_of(camera: &Camera) -> PictureRays {
    let at = |x, y| camera.ray(x, y, SIZE[0], SIZE[1]).direction;
    let (first, right, down) = (at(0, 0), at(1, 0), at(0, 1));
    let (right, down) = (right - first, down - first);
    PictureRays {
        origin: [camera.eye().as_vec3(), Vec3::ZERO, Vec3::ZERO],
        direction: [first - (right + down) * 0.5, right, down].map(|along| along.as_vec3()),
    }
}

fn frames(rounds: u16, missed: &mut Vec<String>) -> Result<(), String> {
    let mut table = table(&["mesh", "lanes", "one by one ms", "tiles ms", "times"]);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().map_err(|error| error.to_string())?;
    for (name, mesh) in meshes()? {
        let scene = bump(Arc::new(mesh))?;
        let render = |renderer: &mut Renderer| {
            let made = pool.install(|| renderer.render(&scene, &mut Maps::in_memory(), &Watch::none()));
            made.map(|made| made.rendering.pixels).map_err(|error| error.to_string())
        };
        let mut one = Renderer::on_cpu();
        one.set_lanes(Lanes::One);
        let expected = render(&mut one)?;
        for lanes in widths() {
            let mut wide = Renderer::on_cpu();
            wide.set_lanes(lanes);
            if render(&mut wide)? != expected {
                return Err(format!("{name}: pictures differ with {lanes} lanes"));
            }
            let [before, after] = fastest(
                rounds,
                [&mut || drop(black_box(render(&mut one))), &mut || drop(black_box(render(&mut wide)))],
            );
            let times = before / after;
            if times < AIM_FRAME {
                missed.push(format!("a frame of {name} with {lanes} lanes is {times:.2} times faster"));
            }
            let ms = |seconds: f64| format!("{:.1}", seconds * 1e3);
            table.add_row([name.to_owned(), lanes.to_string(), ms(before), ms(after), format!("{times:.2}")]);
        }
    }
    println!(
        "Second frames of `bump` without shadows, {}x{} pixels, one sample each, on one thread, the fastest \
         of {rounds} rounds, whose pictures have the same bits.\n\n{table}\n",
        SIZE[0], SIZE[1]
    );
    Ok(())
}

fn bump(mesh: Arc<Mesh>) -> Result<Scene, String> {
    let named = maps::ALL.iter().find(|map| map.name == "natural 101x67").ok_or("the map is not listed")?;
    let map = named.build(relief_core::Wrap::Repeat).with_displacement(0.03, -0.03);
    let mut selection = Selection::method("bump").map_err(|error| error.to_string())?;
    selection.choose("shadow", "none").map_err(|error| error.to_string())?;
    scene(Surface::new(mesh, map.map_err(|error| error.to_string())?).with_selection(selection), SIZE)
}
