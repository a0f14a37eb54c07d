//! Pictures are the same, to the last bit, however many values the CPU works on at once.

use std::sync::Arc;

use glam::{Vec2, Vec3};
use relief_core::camera::{Camera, Projection};
use relief_core::mesh::{Mesh, cube, rectangle, sphere, torus};
use relief_core::{HeightMap, Lanes, Watch, Wrap};
use relief_maps::Maps;
use relief_render::Renderer;
use relief_scene::light::Light;
use relief_scene::{Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use relief_testing::maps;

fn map(way: usize) -> HeightMap {
    let named = maps::ALL.iter().find(|map| map.name == "natural 101x67").expect("it is listed");
    // Carved, and on both sides of its base, so that farther polygons may be nearer.
    let (scale_m, bias_m) = [(0.06, -0.06), (0.1, -0.04)][way % 2];
    named.build(Wrap::ALL[way % Wrap::ALL.len()]).with_displacement(scale_m, bias_m).expect("lengths")
}

fn camera(eye: [f64; 3], target: [f64; 3], projection: Projection) -> Camera {
    Camera::with(eye.into(), target.into(), projection).expect("a camera")
}

/// From outside, zoomed in, along parallel rays, within the mesh, and so wide that directions are longest
/// along several axes.
fn cameras() -> [Camera; 5] {
    let perspective = |fov_degrees| Projection::Perspective { fov_degrees };
    [
        camera([0.7, 1.0, 1.3], [0.0; 3], perspective(40.0)),
        camera([0.4, 0.6, 1.1], [0.2, 0.05, 0.25], perspective(12.0)),
        camera([1.0, 0.8, 1.0], [0.2, 0.0, 0.1], Projection::Orthographic { height_m: 0.9 }),
        camera([0.1, 0.05, 0.0], [0.4, 0.0, 0.3], perspective(70.0)),
        camera([0.3, 0.5, 0.2], [0.0; 3], perspective(140.0)),
    ]
}

fn bases() -> [(&'static str, Arc<Mesh>); 4] {
    let tiled = |mesh: Mesh, tiles| Arc::new(mesh.tiled(tiles).expect("tiles"));
    [
        ("plane", tiled(rectangle([1.2, 0.8], 12).expect("a mesh"), Vec2::splat(2.0))),
        ("torus", tiled(torus(24, 12).expect("a mesh"), Vec2::new(3.0, 1.0))),
        ("sphere", tiled(sphere(40, 20).expect("a mesh"), Vec2::new(2.0, 1.0))),
        ("cube", tiled(cube(4).expect("a mesh"), Vec2::ONE)),
    ]
}

/// What of the program is in the way from a triangle to a pixel.
const METHODS: [(&str, &[(&str, &str)]); 6] = [
    ("bump", &[]),
    ("relief", &[("shadow", "map")]),
    ("exact", &[("shadow", "ray")]),
    ("relief", &[("surface", "quadric-vertical")]),
    ("exact", &[("surface", "tetrahedra"), ("shadow", "scene")]),
    ("vertex", &[]),
];

fn scenes() -> Vec<(String, Scene)> {
    let mut scenes = Vec::new();
    for (b, (name, base)) in bases().iter().enumerate() {
        for (c, camera) in cameras().into_iter().enumerate() {
            for turn in 0..2 {
                let way = b + c + 3 * turn;
                let (method, stages) = METHODS[way % METHODS.len()];
                let mut selection = Selection::method(method).expect("a method");
                for (stage, choice) in stages {
                    selection.choose(stage, choice).expect("a listed name");
                }
                if stages.contains(&("shadow", "map")) {
                    selection.set("shadow.size", 128.0).expect("a setting");
                }
                let surface = Surface::new(Arc::clone(base), map(way)).with_selection(selection);
                let surface = surface.with_two_sided(way % 3 == 0);
                let light = Light::directional([0.4, 1.0, 0.3].into(), Vec3::ONE).expect("a light");
                let size = [[60, 43], [33, 48]][turn];
                let samples = [1, 3][(b + turn) % 2];
                let builder = Scene::builder(surface).camera(camera).size(size[0], size[1]);
                let scene = builder.lights(vec![light]).samples(samples).build().expect("a scene");
                scenes.push((format!("{name}, camera {c}, {method} {stages:?}, {samples} samples"), scene));
            }
        }
    }
    scenes
}

fn rendered(scene: &Scene, renderer: &mut Renderer) -> Vec<PixelOut> {
    renderer.render(scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
}

fn in_bands(scene: &Scene, renderer: &mut Renderer) -> Vec<PixelOut> {
    let mut pixels = Vec::new();
    let mut sink = |band: &[PixelOut]| {
        pixels.extend_from_slice(band);
        Ok(())
    };
    let made = renderer.render_bands(scene, &mut Maps::in_memory(), true, &Watch::none(), &mut sink);
    made.expect("a picture");
    pixels
}

#[test]
fn pictures_have_the_same_bits_in_all_widths() {
    let mut hits = 0;
    for (name, scene) in scenes() {
        let mut one = Renderer::on_cpu();
        one.set_lanes(Lanes::One);
        let expected = rendered(&scene, &mut one);
        hits += expected.iter().filter(|pixel| pixel.hit == 1).count();
        for lanes in Lanes::available() {
            let mut renderer = Renderer::on_cpu();
            renderer.set_lanes(lanes);
            assert!(rendered(&scene, &mut renderer) == expected, "{name}, {lanes} lanes");
            assert!(in_bands(&scene, &mut renderer) == expected, "{name}, {lanes} lanes, bands");
        }
    }
    assert!(hits > 30_000, "only {hits} hits");
}

#[test]
fn bands_need_not_end_with_tiles() {
    // So wide that a band has 87 rows.
    let surface = Surface::new(Arc::clone(&bases()[1].1), map(0));
    let surface = surface.with_selection(Selection::method("bump").expect("a method"));
    let builder = Scene::builder(surface).camera(cameras()[0]).size(3001, 100);
    let scene = builder.build().expect("a scene");
    let mut one = Renderer::on_cpu();
    one.set_lanes(Lanes::One);
    let expected = rendered(&scene, &mut one);
    for lanes in Lanes::available() {
        let mut renderer = Renderer::on_cpu();
        renderer.set_lanes(lanes);
        assert!(in_bands(&scene, &mut renderer) == expected, "{lanes} lanes");
    }
}
