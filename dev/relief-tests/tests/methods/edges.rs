//! What of a map ends: holes, where nothing is seen of a surface, and creases, where normals change at once.
//! Both are the same on both backends.

use std::collections::BTreeSet;

use glam::{DVec3, Vec2};
use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, Placement, square, torus};
use relief_core::{HeightMap, TexelMask, Watch, Wrap};
use relief_maps::Maps;
use relief_render::Renderer;
use relief_render::gpu::AdapterChoice;
use relief_scene::{Sampling, Scene, SceneBuilder, Surface, View};
use relief_shaders::cpu::PixelOut;
use relief_shaders::{Entry, METHODS, Selection, surface};
use relief_testing::maps;
use relief_tests::adapter::{Leeway, open};

const SIZE: [u32; 2] = [120, 90];

/// Methods that a GPU is asked for: with and without baked maps, exact and beside the ray.
const ON_GPU: [&str; 4] = ["exact", "relief", "cone", "parallax"];

/// The least share of pixels that both backends show alike: on edges rasterisers may choose otherwise.
const ALIKE: f64 = 0.998;

/// Discs of holes, and one that reaches over the edge of the map.
fn holes(map: &HeightMap) -> TexelMask {
    let [across, down] = [map.width() as f32, map.height() as f32];
    TexelMask::from_fn(map.width(), map.height(), |i, j| {
        let [x, y] = [i as f32 / across, j as f32 / down];
        let within = |u: f32, v: f32, radius: f32| (x - u).hypot(y - v) < radius;
        within(0.3, 0.4, 0.12) || within(0.75, 0.6, 0.18) || within(0.0, 0.8, 0.1) || (i, j) == (90, 20)
    })
}

fn holed(wrap: Wrap) -> HeightMap {
    let map = maps::ALL[2].build(wrap).with_displacement(0.05, -0.05).expect("lengths");
    let holes = holes(&map);
    map.with_holes(holes).expect("of its size")
}

/// A backend that keeps what it has made, and its name.
struct Backend(&'static str, Renderer);

impl Backend {
    fn pixels(&mut self, scene: SceneBuilder) -> Vec<PixelOut> {
        let scene = scene.size(SIZE[0], SIZE[1]).samples(1).build().expect("a proper scene");
        self.1.render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
    }
}

fn backends() -> Vec<Backend> {
    let gpu = open(AdapterChoice::Any).map(|gpu| Backend("GPU", Renderer::on_gpu(gpu, Sampling::Exact)));
    [Backend("CPU", Renderer::on_cpu())].into_iter().chain(gpu).collect()
}

/// Whether a dual cell has a texel that is a hole.
fn is_hole(map: &HeightMap, cell: [i32; 2]) -> bool {
    let holes = map.holes().expect("a map with holes");
    [[0, 0], [1, 0], [0, 1], [1, 1]].iter().any(|beside| {
        let column = map.wrap().index(i64::from(cell[0] + beside[0]), map.width());
        let row = map.wrap().index(i64::from(cell[1] + beside[1]), map.height());
        holes.contains(column, row)
    })
}

fn shows_hole(map: &HeightMap, pixel: &PixelOut) -> bool {
    pixel.hit == 1 && is_hole(map, [pixel.cell.x, pixel.cell.y])
}

fn alike(one: &[PixelOut], other: &[PixelOut]) -> f64 {
    let same = one.iter().zip(other).filter(|(a, b)| {
        let beside = [a.depth - b.depth, a.normal.x - b.normal.x, a.normal.z - b.normal.z];
        a.hit == b.hit && beside.iter().all(|part| part.abs() < 1e-4)
    });
    same.count() as f64 / one.len() as f64
}

/// The first pixel that is not what it is to be: without holes as it was, in a hole nothing.
fn wrong_pixel(map: &HeightMap, without: &[PixelOut], with: &[PixelOut]) -> Option<usize> {
    without.iter().zip(with).position(|(without, with)| {
        if shows_hole(map, without) { with.hit != 0 || with.color.w != 0.0 } else { with != without }
    })
}

/// The surfaces on which a relief lies.
fn under_relief() -> impl Iterator<Item = &'static Entry> {
    surface::ENTRIES.iter().filter(|entry| entry.paths().has_relief())
}

#[test]
fn what_lies_in_a_hole_is_not_hit_by_any_method() {
    let mesh = square(1).expect("a mesh");
    for backend in &mut backends() {
        let on = backend.0;
        // All methods meet in one place; a few show that a GPU has it, too.
        // Through a hole in displaced triangles those behind it are seen.
        let methods = METHODS.iter().filter(|method| method.geometry == "none" && method.is_of_reliefs());
        let methods = methods.filter(|method| on == "CPU" || ON_GPU.contains(&method.name));
        for (method, wrap) in methods.zip(Wrap::ALL.into_iter().cycle()) {
            let map = holed(wrap);
            let selection = Selection::method(method.name).expect("a method");
            let surface = Surface::new(mesh.clone(), map.clone()).with_selection(selection);
            let [without, with] = [false, true].map(|holes| {
                let surface = surface.clone().with_holes(holes);
                backend.pixels(Scene::builder(surface).fitted_camera(View::Corner, 40.0))
            });
            let wrong = wrong_pixel(&map, &without, &with);
            assert_eq!(wrong, None, "{} {wrap} on {on}", method.name);
            let gone = without.iter().filter(|pixel| shows_hole(&map, pixel)).count();
            assert!(gone > 200, "{} {wrap} on {on}: {gone}", method.name);
            // A picture that shows them is a wrong one.
            assert!(wrong_pixel(&map, &without, &without).is_some());
        }
    }
}

#[test]
fn holes_are_seen_through_on_every_surface() {
    let mesh = torus(32, 16).expect("a mesh").tiled(Vec2::new(4.0, 2.0)).expect("tiles");
    for entry in under_relief() {
        let mut pictures = Vec::new();
        for backend in &mut backends() {
            let on = backend.0;
            let mut selection = Selection::method("relief").expect("a method");
            selection.choose("surface", entry.name).expect("a listed name");
            let surface = Surface::new(mesh.clone(), holed(Wrap::Repeat)).with_selection(selection);
            let scene = |surface: Surface| Scene::builder(surface.with_two_sided(true));
            let [without, with] = [false, true].map(|holes| {
                let scene = scene(surface.clone().with_holes(holes));
                backend.pixels(scene.fitted_camera(View::Corner, 40.0))
            });
            let map = holed(Wrap::Repeat);
            let shown = with.iter().filter(|pixel| shows_hole(&map, pixel)).count();
            assert_eq!(shown, 0, "{} on {on}", entry.name);
            // In holes the other side of the torus is seen, farther away.
            let through = without.iter().zip(&with).filter(|(without, with)| {
                shows_hole(&map, without) && with.hit == 1 && with.depth > without.depth + 0.05
            });
            let through = through.count();
            assert!(through > 100, "{} on {on}: {through}", entry.name);
            pictures.push(with);
        }
        if let [cpu, gpu] = &pictures[..] {
            let share = alike(cpu, gpu);
            assert!(share >= Leeway::of_any().share(ALIKE), "{}: {share}", entry.name);
        }
    }
}

#[test]
fn another_surface_is_seen_in_holes_and_they_are_as_large_from_afar() {
    let mesh = |below: f64| -> Mesh {
        let placement = Placement { position_m: DVec3::new(0.0, -below, 0.0), ..Placement::default() };
        let mesh = square(1).expect("a mesh").tiled(Vec2::new(6.0, 6.0)).expect("tiles");
        mesh.placed(&placement).expect("a place")
    };
    let map = holed(Wrap::Repeat);
    let mut selection = Selection::exact();
    selection.choose("detail", "footprint").expect("a detail");
    let upper = Surface::new(mesh(0.0), map.clone()).with_selection(selection).with_holes(true);
    let lower = Surface::new(mesh(0.4), map.clone()).with_selection(selection);
    let camera = Camera::new(DVec3::new(0.0, 3.0, 2.0), DVec3::ZERO, 30.0).expect("a camera");
    for backend in &mut backends() {
        let on = backend.0;
        let mut picture =
            |surfaces| backend.pixels(Scene::builder(upper.clone()).surfaces(surfaces).camera(camera));
        let both = picture(vec![upper.clone(), lower.clone()]);
        let levels: BTreeSet<u32> = both.iter().map(|pixel| pixel.level).collect();
        assert!(levels.iter().any(|level| *level > 0), "{levels:?}");
        let is_upper = |pixel: &PixelOut| pixel.hit == 1 && pixel.position.y > -0.1;
        assert!(!both.iter().any(|pixel| is_upper(pixel) && shows_hole(&map, pixel)), "{on}");
        let filled = picture(vec![upper.clone().with_holes(false), lower.clone()]);
        let through = both.iter().zip(&filled).filter(|(both, filled)| !is_upper(both) && is_upper(filled));
        let (through, upper_ones) = (through.count(), filled.iter().filter(|pixel| is_upper(pixel)).count());
        // A sixth or so of the map is holes.
        let share = through as f64 / upper_ones as f64;
        assert!((0.12..0.35).contains(&share), "{on}: {share}");
    }
}

#[test]
fn a_map_without_holes_is_the_same_with_the_key() {
    let map = maps::ALL[2].build(Wrap::Repeat).with_displacement(0.05, -0.05).expect("lengths");
    let surface = Surface::new(square(1).expect("a mesh"), map);
    for backend in &mut backends() {
        let on = backend.0;
        let [without, with] =
            [false, true].map(|holes| backend.pixels(Scene::builder(surface.clone().with_holes(holes))));
        assert!(without == with, "{on}");
    }
}

#[test]
fn a_clamped_map_ends_where_its_footprint_does() {
    // The tile is repeated on the mesh, and the map is there once: beyond it no ray hits anything.
    let mesh = torus(32, 16).expect("a mesh").tiled(Vec2::new(2.0, 2.0)).expect("tiles");
    for entry in under_relief() {
        let mut selection = Selection::method("relief").expect("a method");
        selection.choose("surface", entry.name).expect("a listed name");
        let map = maps::ALL[2].build(Wrap::Clamp).with_displacement(0.05, -0.05).expect("lengths");
        let surface = Surface::new(mesh.clone(), map).with_selection(selection);
        for backend in &mut backends() {
            let on = backend.0;
            let pixels = backend.pixels(Scene::builder(surface.clone().with_two_sided(true)));
            let hits = pixels.iter().filter(|pixel| pixel.hit == 1);
            let beyond = hits
                .clone()
                .filter(|pixel| [pixel.uv.x, pixel.uv.y].iter().any(|part| !(-1e-4..=1.0001).contains(part)));
            assert_eq!(beyond.count(), 0, "{} on {on}", entry.name);
            assert!(hits.count() > 300, "{} on {on}", entry.name);
        }
    }
}

/// Normals from above of a relief on a square of 1 m, with creases kept or not, each with the place of the
/// hit in texels along u.
fn normals(map: &HeightMap, creases: bool, backend: &mut Backend) -> Vec<(f32, PixelOut)> {
    let surface = Surface::new(square(1).expect("a mesh"), map.clone()).with_creases(creases);
    let scene = Scene::builder(surface).fitted_orthographic_camera(View::Top);
    let pixels = backend.pixels(scene).into_iter().filter(|pixel| pixel.hit == 1);
    pixels.map(|pixel| (pixel.uv.x * map.width() as f32 - 0.5, pixel)).collect()
}

/// The slope along u that a normal stands for.
fn slope(pixel: &PixelOut) -> f32 {
    -pixel.normal.x / pixel.normal.y
}

/// Greatest difference between the slopes of a picture and of the surface itself.
fn slope_error(map: &HeightMap, seen: &[(f32, PixelOut)], of_surface: impl Fn(i32) -> f32) -> f32 {
    let inside = seen.iter().filter(|(at, _)| (1.0..map.width() as f32 - 2.0).contains(at));
    inside.map(|(_, pixel)| (slope(pixel) - of_surface(pixel.cell.x)).abs()).fold(0.0, f32::max)
}

#[test]
fn normals_end_at_creases_and_are_those_of_the_patch_there() {
    const TEXELS: u32 = 32;
    // Ridges and valleys with sides of some 63 degrees, 8 texels wide, and then a plain and a cliff.
    let roof = |i: u32, _: u32| match i {
        0..24 => (i % 8).min(8 - i % 8) as f32 / 8.0,
        24..28 => 0.0,
        _ => 1.0,
    };
    let map = HeightMap::from_fn(TEXELS, TEXELS, Wrap::Clamp, roof).expect("a map");
    let map = map.with_displacement(0.5, -0.5).expect("lengths");
    let of_patch = |cell: i32| {
        let [left, right] = [cell, cell + 1].map(|i| map.texel(i64::from(i), 5));
        (right - left) * 0.5 * TEXELS as f32
    };
    let mut of_backends = Vec::new();
    for backend in &mut backends() {
        let on = backend.0;
        let [smooth, creased] = [false, true].map(|creases| normals(&map, creases, backend));
        let [smeared, kept] = [&smooth, &creased].map(|seen| slope_error(&map, seen, of_patch));
        assert!(kept < 1e-3, "{on}: {kept}");
        assert!(smeared > 0.5, "{on}: {smeared}");
        // Nothing else changes.
        for ((_, a), (_, b)) in smooth.iter().zip(&creased) {
            assert_eq!((a.uv, a.height, a.position, a.cell), (b.uv, b.height, b.position, b.cell));
        }
        of_backends.push(creased);
    }
    if let [cpu, gpu] = &of_backends[..] {
        for ((_, a), (_, b)) in cpu.iter().zip(gpu) {
            assert!((a.normal.x - b.normal.x).abs() < 1e-5 && (a.normal.z - b.normal.z).abs() < 1e-5);
        }
    }
}

#[test]
fn normals_of_what_has_no_creases_are_the_same() {
    let wave = |i: u32, j: u32| 0.5 + 0.25 * ((i as f32 * 0.3).sin() + (j as f32 * 0.2).cos());
    let map = HeightMap::from_fn(64, 48, Wrap::Mirror, wave).expect("a map");
    let map = map.with_displacement(0.1, -0.1).expect("lengths");
    for backend in &mut backends() {
        let on = backend.0;
        let [smooth, creased] = [false, true].map(|creases| normals(&map, creases, backend));
        assert_eq!(smooth.len(), creased.len());
        for ((_, a), (_, b)) in smooth.iter().zip(&creased) {
            let apart = [a.normal.x - b.normal.x, a.normal.y - b.normal.y, a.normal.z - b.normal.z];
            assert!(apart.iter().all(|part| part.abs() < 1e-4), "{on} at {:?}: {apart:?}", a.uv);
        }
    }
}
