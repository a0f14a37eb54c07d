//! The two backends give the same picture: every method on two of three scenes, every shadow and every
//! ambient light on all.
//!
//! Both run the same shaders on the same rays, but for `exact`, which the CPU answers with the core's fast
//! tracer. What may differ is which of two neighbouring triangles a pixel on their edge belongs to, and hits
//! that graze.

use std::path::Path;

use relief_core::Watch;
use relief_maps::Maps;
use relief_render::{Rendered, render};
use relief_scene::{BackendChoice, Scene, SceneSpec, SurfaceSpec, read_scene};
use relief_shaders::cpu::PixelOut;
use relief_shaders::geometry::Geometry;
use relief_shaders::{METHODS, Selection, ambient, shadow};
use relief_tests::adapter::{Leeway, has_adapter};

const SCENES: [&str; 3] = ["jacksboro.toml", "bricks.toml", "cobbles.toml"];

const SIZE: [u32; 2] = [160, 120];

/// Hits whose parameters differ by less, in metres, are the same hit: a thousandth of a texel of these maps.
const SAME_T_M: f32 = 4e-6;

/// Share of the covered pixels that must agree for a method that runs the same code on both backends.
const SAME_CODE: f64 = 0.999;

/// Share for `exact`, and for displaced triangles, many about a pixel wide.
const OTHER_CODE: f64 = 0.995;

/// Colours that differ by less in every channel are the same.
const SAME_COLOR: f32 = 1e-5;

/// A shipped scene with another method, and variants of stages by their keys.
fn scene(file: &str, method: &str, stages: &[(&str, &str)], backend: BackendChoice) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").join(file);
    // Surroundings are seen through a surface, too.
    let transmission = stages.contains(&("ambient", "environment")).then_some(0.5);
    // What lights see need not be fine to be the same.
    let of_method = Selection::method(method).expect("a method");
    let looks_up = of_method.light_views().is_some() || stages.contains(&("shadow", "map"));
    // Nor are a GPU's buffers as large as a vertex every texel of many tiles asks for.
    let is_diced = matches!(of_method.geometry(), Some(Geometry::Texels(_)));
    let is_sliced = matches!(of_method.geometry(), Some(Geometry::Slices(_)));
    // Nor must every direction be baked.
    let has_directions = of_method.search().param("elevations").is_some();
    let is_compressed = of_method.search().param("rank").is_some();
    let set = [
        (looks_up, "shadow.size", 256.0),
        (is_diced, "geometry.texels", 2.0),
        (is_sliced, "slices.count", 5.0),
        (has_directions, "search.azimuths", 4.0),
        (has_directions, "search.elevations", 3.0),
        (is_compressed, "search.rank", 6.0),
    ];
    let set = set.iter().filter(|(is_set, ..)| *is_set).map(|(_, key, value)| ((*key).to_owned(), *value));
    let set = set.collect();
    let stages = stages.iter().map(|(key, name)| ((*key).to_owned(), (*name).to_owned())).collect();
    let method = Some(method.to_owned());
    let surface = SurfaceSpec { method, stages, set, transmission, ..SurfaceSpec::default() };
    let over = SceneSpec {
        backend: Some(backend),
        size: Some(SIZE.into()),
        samples: Some(1),
        ..SceneSpec::of_surface(surface)
    };
    read_scene(&path).expect("a shipped scene").overridden_by(over).load().expect("a shipped map")
}

fn picture(file: &str, method: &str, backend: BackendChoice) -> Rendered {
    render(&scene(file, method, &[], backend), &mut Maps::in_memory(), &Watch::none()).expect("a picture")
}

/// How two renderings of the same scene differ.
#[derive(Debug)]
struct Comparison {
    covered: usize,
    agreeing: usize,
    uv_p99_texels: f64,
}

impl Comparison {
    fn new(one: &[PixelOut], other: &[PixelOut], map: [u32; 2]) -> Self {
        let mut distances = Vec::new();
        let (mut covered, mut agreeing) = (0, 0);
        for (a, b) in one.iter().zip(other) {
            if a.hit == 0 && b.hit == 0 {
                continue;
            }
            covered += 1;
            if a.hit != b.hit {
                continue;
            }
            let aside = [(a.uv.x - b.uv.x) * map[0] as f32, (a.uv.y - b.uv.y) * map[1] as f32];
            distances.push(f64::from(aside[0].hypot(aside[1])));
            let within_m = SAME_T_M * Leeway::of_any().rounding;
            agreeing += usize::from((a.t - b.t).abs() <= within_m && a.cell == b.cell);
        }
        distances.sort_unstable_by(f64::total_cmp);
        let uv_p99_texels = distances.get(distances.len() * 99 / 100).copied().unwrap_or(0.0);
        Self { covered, agreeing, uv_p99_texels }
    }

    fn share(&self) -> f64 {
        self.agreeing as f64 / self.covered.max(1) as f64
    }
}

#[test]
fn every_method_gives_the_same_picture_on_both_backends() {
    if !has_adapter() {
        return;
    }
    let [first, others @ ..] = SCENES;
    for (number, method) in METHODS.iter().filter(|method| method.is_of_reliefs()).enumerate() {
        for file in [first, others[number % others.len()]] {
            let cpu = picture(file, method.name, BackendChoice::Cpu);
            let gpu = picture(file, method.name, BackendChoice::Gpu);
            assert_eq!((cpu.info.backend, gpu.info.backend), ("cpu", "gpu"));
            let map = scene(file, method.name, &[], BackendChoice::Cpu);
            let map = map.surfaces()[0].height_map();
            let size = [map.width(), map.height()];
            let comparison = Comparison::new(&cpu.rendering.pixels, &gpu.rendering.pixels, size);
            let differs = method.name == "exact" || method.geometry != "none";
            let wanted = if differs { OTHER_CODE } else { SAME_CODE };
            println!("{file} {}: {comparison:?} {:.5}", method.name, comparison.share());
            assert!(comparison.covered > 2000, "{file} {}: hardly anything is seen", method.name);
            assert!(
                comparison.share() >= Leeway::of_any().share(wanted),
                "{file} {}: {comparison:?}",
                method.name
            );
            assert!(comparison.uv_p99_texels <= 0.01, "{file} {}: {comparison:?}", method.name);
        }
    }
}

/// The share of the covered pixels that have the same colour in both.
fn same_colors(one: &[PixelOut], other: &[PixelOut]) -> f64 {
    let covered = one.iter().zip(other).filter(|(a, b)| a.hit == 1 || b.hit == 1);
    let same = covered.clone().filter(|(a, b)| {
        let apart = [a.color.x - b.color.x, a.color.y - b.color.y, a.color.z - b.color.z];
        let within = SAME_COLOR * Leeway::of_any().rounding;
        a.hit == b.hit && apart.iter().all(|part| part.abs() <= within)
    });
    same.count() as f64 / covered.count().max(1) as f64
}

#[test]
fn every_shadow_and_every_ambient_light_gives_the_same_colours() {
    if !has_adapter() {
        return;
    }
    let pixels = |file: &str, stages: &[(&str, &str)], backend| {
        let scene = scene(file, "cone", stages, backend);
        render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
    };
    for file in SCENES {
        let mut before = Vec::new();
        // Rays through the whole scene are traced by the CPU alone.
        let shadows = shadow::ENTRIES.iter().filter(|shadow| shadow.name != "scene");
        for (shadow, ambient) in shadows.zip(ambient::ENTRIES.iter().cycle()) {
            let stages = [("shadow", shadow.name), ("ambient", ambient.name)];
            let [cpu, gpu] =
                [BackendChoice::Cpu, BackendChoice::Gpu].map(|backend| pixels(file, &stages, backend));
            let share = same_colors(&cpu, &gpu);
            println!("{file} {} {}: {share:.5}", shadow.name, ambient.name);
            assert!(
                share >= Leeway::of_any().share(SAME_CODE),
                "{file} {} {}: {share}",
                shadow.name,
                ambient.name
            );
            // Others have other colours.
            assert!(same_colors(&cpu, &before) < SAME_CODE, "{file} {} {}", shadow.name, ambient.name);
            before = cpu;
        }
    }
}

#[test]
fn the_comparison_sees_a_picture_of_another_method() {
    let pixels = picture("bricks.toml", "occlusion", BackendChoice::Cpu).rendering.pixels;
    let size = [256, 256];
    assert_eq!(Comparison::new(&pixels, &pixels, size).share(), 1.0);
    // Moved by a hundredth of a texel, one pixel in five hundred.
    let mut moved = pixels.clone();
    for pixel in moved.iter_mut().step_by(500) {
        pixel.t += 4e-5;
    }
    assert!(Comparison::new(&pixels, &moved, size).share() < SAME_CODE);
    let other = picture("bricks.toml", "relief", BackendChoice::Cpu).rendering.pixels;
    assert!(Comparison::new(&pixels, &other, size).share() < SAME_CODE);
}
