//! Slices through the relief: against linear search, which looks at the same heights, and against the truth.
//!
//! Kautz and Seidel 2001, section 3.

use std::sync::Arc;

use glam::DVec3;
use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, square};
use relief_core::{HeightMap, Wrap};
use relief_maps::Maps;
use relief_render::render;
use relief_render::scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use relief_tests::accuracy::maps;
use relief_tests::adapter::has_adapter;
use relief_tests::maps::fractal;

const SIZE: u32 = 160;

/// How far around its middle the plane is looked at: rays there stay over it.
const MIDDLE: f32 = 0.22;

/// A method's settings.
type Set<'a> = &'a [(&'a str, f64)];

fn selection(method: &str, set: Set) -> Selection {
    let mut selection = Selection::method(method).expect("a method");
    for (key, value) in set {
        selection.set(key, *value).expect("a setting");
    }
    selection
}

/// A plane of a metre, seen that many degrees above its surface.
fn pixels(
    map: &Arc<HeightMap>,
    degrees: f64,
    (method, set): (&str, Set),
    backend: BackendChoice,
) -> Vec<PixelOut> {
    let surface = Surface::new(Arc::<Mesh>::new(square(1).expect("a mesh")), Arc::clone(map));
    let surface = surface.with_selection(selection(method, set));
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let eye = DVec3::new(0.3 * cosine, sine, 0.95 * cosine) * 2.0;
    let camera = Camera::new(eye, DVec3::ZERO, 24.0).expect("a camera");
    let scene = Scene::builder(surface).size(SIZE, SIZE).samples(1).camera(camera).backend(backend);
    let scene = scene.build().expect("a scene");
    render(&scene, &mut Maps::in_memory(), &|_, _| {}).expect("a picture").rendering.pixels
}

fn map(name: &str) -> Arc<HeightMap> {
    let map = maps().into_iter().find(|map| map.name == name).expect("a map of the accuracy tables").map;
    Arc::new(map.with_displacement(0.08, -0.08).expect("lengths"))
}

fn is_in_middle(pixel: &PixelOut) -> bool {
    pixel.hit == 1 && (pixel.uv.x - 0.5).abs() < MIDDLE && (pixel.uv.y - 0.5).abs() < MIDDLE
}

/// Of the pixels in the middle of what one shows: how far off the other's are, in texels; misses are
/// infinitely far.
fn texels_apart(of: &[PixelOut], other: &[PixelOut], map: &HeightMap) -> Vec<f32> {
    let pairs = of.iter().zip(other).filter(|(of, _)| is_in_middle(of));
    let texels = |(a, b): (&PixelOut, &PixelOut)| {
        let [x, y] = [a.uv.x - b.uv.x, a.uv.y - b.uv.y];
        let apart = (x * map.width() as f32).hypot(y * map.height() as f32);
        if b.hit == 1 { apart } else { f32::INFINITY }
    };
    pairs.map(texels).collect()
}

fn share(apart: &[f32], most: f32) -> f64 {
    assert!(apart.len() > 1000, "hardly anything is seen: {}", apart.len());
    apart.iter().filter(|texels| **texels <= most).count() as f64 / apart.len() as f64
}

#[test]
fn slices_of_a_plane_are_the_steps_of_linear_search() {
    for (name, degrees) in [("cobbles", 60.0), ("spikes", 40.0), ("bricks", 20.0)] {
        let map = map(name);
        for count in [1.0, 7.0, 32.0] {
            let of = |method, set: Set| pixels(&map, degrees, (method, set), BackendChoice::Cpu);
            let steps = of("steep", &[("search.steps", count)]);
            let slices = of("slices-surface", &[("slices.count", count)]);
            let same = share(&texels_apart(&steps, &slices, &map), 0.01);
            assert!(same >= 0.999, "{name} {degrees} {count}: {same}");
            // Slices that lie at other heights are noticed.
            let others = of("slices-surface", &[("slices.count", count + 1.0)]);
            let noticed = 1.0 - share(&texels_apart(&steps, &others, &map), 0.01);
            assert!(noticed > 0.01, "{name} {degrees} {count}: {noticed}");
        }
    }
}

#[test]
fn sixteen_refined_slices_are_off_less_often_than_sixty_four_plain_ones() {
    let ground = HeightMap::new(1024, 1024, fractal(7, 1024, 1024, 0.5), Wrap::Repeat).expect("a map");
    let deep = |map: &HeightMap| Arc::new(map.clone().with_displacement(0.15, -0.15).expect("lengths"));
    for (name, map, degrees) in [
        ("ground", deep(&ground), [70.0, 30.0]),
        ("cobbles", deep(&map("cobbles")), [40.0, 30.0]),
        ("spikes", deep(&map("spikes")), [40.0, 30.0]),
    ] {
        for degrees in degrees {
            let of = |method, set: Set| pixels(&map, degrees, (method, set), BackendChoice::Cpu);
            let truth = of("exact", &[]);
            let off = |set: Set| 1.0 - share(&texels_apart(&truth, &of("slices-surface", set), &map), 0.5);
            let plain = off(&[("slices.count", 64.0)]);
            let refined = off(&[("slices.count", 16.0), ("slices.refine", 1.0)]);
            println!("{name} {degrees}: 64 plain {plain:.4}, 16 refined {refined:.4} off by half a texel");
            assert!(refined < 0.5 * plain, "{name} {degrees}: {refined} of 16 refined, {plain} of 64 plain");
        }
    }
}

#[test]
fn tests_draw_what_they_say() {
    let heights = |i: u32, _: u32| if i % 16 < 4 { 0.0 } else { 1.0 };
    let map = HeightMap::from_fn(64, 64, Wrap::Repeat, heights).expect("a map");
    let map = Arc::new(map.with_displacement(0.1, -0.1).expect("lengths"));
    let shown = |test: f64| {
        let set = [("slices.count", 8.0), ("slices.test", test)];
        let pixels = pixels(&map, 80.0, ("slices-surface", &set), BackendChoice::Cpu);
        pixels.iter().filter(|pixel| is_in_middle(pixel)).map(|pixel| pixel.height).collect::<Vec<f32>>()
    };
    let (inside, at_least, band) = (shown(0.0), shown(1.0), shown(2.0));
    // The lowest slice is whole, or masked where heights are 0.
    assert!(at_least.contains(&0.0) && inside.iter().all(|height| *height > 0.0));
    assert!(inside.len() < at_least.len());
    // What lies under the tops is not drawn by bands: neither their sides nor what is seen through them.
    assert!(band.len() < at_least.len() && band.contains(&0.0));
}

#[test]
fn backends_show_the_same_slices() {
    if !has_adapter() {
        return;
    }
    let map = map("cobbles");
    for set in [&[("slices.count", 24.0)][..], &[("slices.count", 12.0), ("slices.refine", 2.0)]] {
        let of = |backend| pixels(&map, 35.0, ("slices-surface", set), backend);
        let [cpu, gpu] = [BackendChoice::Cpu, BackendChoice::Gpu].map(of);
        let same = share(&texels_apart(&cpu, &gpu, &map), 0.001);
        assert!(same >= 0.999, "{set:?}: {same}");
    }
}
