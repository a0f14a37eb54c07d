//! The two backends give the same picture on every surface: of meshes that go through each other, and from
//! within a mesh that is seen from both sides.

use glam::DVec3;
use relief_core::camera::Camera;
use relief_core::mesh::{Mesh, sphere, torus};
use relief_core::{Watch, Wrap};
use relief_maps::Maps;
use relief_render::render;
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::cpu::PixelOut;
use relief_shaders::{Selection, surface};
use relief_testing::maps;
use relief_tests::adapter::{Leeway, has_adapter};

/// The share of covered pixels that must agree: on edges of polygons rasterisers may choose the other one.
const ALIKE: f64 = 0.999;

/// Hits whose positions and texture coordinates are less far apart, in metres and tiles, are the same.
const SAME: f32 = 1e-4;

/// The picture of some meshes, with a relief that rises out of them, on a surface.
fn pixels(name: &str, meshes: &[Mesh], eye: DVec3, target: DVec3, backend: BackendChoice) -> Vec<PixelOut> {
    let map = maps::ALL[2].build(Wrap::Repeat).with_displacement(0.04, 0.0).expect("lengths");
    let mut selection = Selection::method("relief").expect("a method");
    selection.choose("surface", name).expect("a listed name");
    let surfaces = meshes
        .iter()
        .map(|mesh| Surface::new(mesh.clone(), map.clone()).with_selection(selection).with_two_sided(true));
    let surfaces: Vec<Surface> = surfaces.collect();
    let scene = Scene::builder(surfaces[0].clone())
        .surfaces(surfaces)
        .camera(Camera::new(eye, target, 60.0).expect("a proper camera"))
        .size(150, 110)
        .samples(1)
        .backend(backend);
    let scene = scene.build().expect("a proper scene");
    render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
}

/// The share of the covered pixels that show the same.
fn alike(one: &[PixelOut], other: &[PixelOut]) -> f64 {
    let covered = one.iter().zip(other).filter(|(a, b)| a.hit == 1 || b.hit == 1);
    let same = covered.clone().filter(|(a, b)| {
        let apart = [a.position.x - b.position.x, a.position.y - b.position.y, a.position.z - b.position.z];
        let aside = [a.uv.x - b.uv.x, a.uv.y - b.uv.y];
        a.hit == b.hit && apart.iter().chain(&aside).all(|part| part.abs() <= SAME)
    });
    same.count() as f64 / covered.count().max(1) as f64
}

#[test]
fn every_surface_gives_the_same_picture() {
    if !has_adapter() {
        return;
    }
    let mesh = || torus(32, 16).expect("a mesh");
    let ball = sphere(24, 12).expect("a mesh");
    let views = [
        (vec![mesh(), ball], DVec3::new(0.4, 0.9, 1.1), DVec3::ZERO),
        // From within the tube.
        (vec![mesh()], DVec3::new(0.35, 0.0, 0.0), DVec3::new(0.3, 0.01, 0.2)),
    ];
    for (meshes, eye, target) in &views {
        let mut before = Vec::new();
        let under_relief = surface::ENTRIES.iter().filter(|entry| entry.paths().has_relief());
        for entry in under_relief {
            let [cpu, gpu] = [BackendChoice::Cpu, BackendChoice::Gpu]
                .map(|backend| pixels(entry.name, meshes, *eye, *target, backend));
            let share = alike(&cpu, &gpu);
            let covered = cpu.iter().filter(|pixel| pixel.hit == 1).count();
            println!("{}: {covered} pixels, {share:.5} alike", entry.name);
            assert!(covered > 3000, "{}: {covered} pixels", entry.name);
            assert!(share >= Leeway::of_any().share(ALIKE), "{}: {share}", entry.name);
            // Others show something else.
            assert!(alike(&cpu, &before) < ALIKE, "{}", entry.name);
            before = cpu;
        }
    }
}
