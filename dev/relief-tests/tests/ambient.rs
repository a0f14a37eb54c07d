//! Light from all around: how much of it arrives, beside many lights with shadows; and none is made.

use std::f64::consts::TAU;

use glam::{DVec3, Vec2, Vec3};
use relief_core::{HeightMap, Wrap};
use relief_maps::Maps;
use relief_render::Renderer;
use relief_render::light::Light;
use relief_render::material::Material;
use relief_render::mesh::Builtin;
use relief_render::scene::{BackendChoice, Scene, Surface, View};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use relief_tests::accuracy::maps;
use relief_tests::shadows::{self, mean_error, pixels};

/// The lights that stand for the sky.
const LIGHTS: u32 = 512;

/// Width and height of the pictures.
const SIZE: [u32; 2] = [48, 48];

/// A corner of a sample map.
fn map(name: &str, side: u32) -> HeightMap {
    let map = maps().into_iter().find(|named| named.name == name).expect("a sample map").map;
    let texel = |i: u32, j: u32| map.texels()[(j * map.width() + i) as usize];
    HeightMap::from_fn(side, side, Wrap::Mirror, texel).expect("a map")
}

/// A white surface of a map on a mesh.
fn surface(map: &HeightMap, mesh: Builtin, choose: &[(&str, &str)], set: &[(&str, f64)]) -> Surface {
    let mesh = mesh.build(map.proportions()).expect("a built-in mesh");
    let mesh =
        if mesh.triangles().len() > 2 { mesh.tiled(Vec2::new(6.0, 3.0)).expect("tiles") } else { mesh };
    let [u, v] = mesh.tile_m();
    let depth = shadows::DEPTH * u.min(v);
    let map = map.clone().with_displacement(depth, -depth).expect("lengths");
    let mut selection = Selection::exact();
    for (stage, name) in choose {
        selection.choose(stage, name).expect("a variant");
    }
    for (key, value) in set {
        selection.set(key, *value).expect("a setting");
    }
    let white = Material::new(Vec3::ONE, Vec3::ZERO, 1).expect("a material");
    Surface::new(mesh, map).with_selection(selection).with_material(white)
}

/// A surface in a sky of radiance 1 and no other light.
fn in_white_sky(surface: Surface, view: View) -> Vec<PixelOut> {
    let scene = Scene::builder(surface).lights(Vec::new()).ambient(Vec3::ONE).background(Vec3::ZERO);
    let scene = scene.fitted_camera(view, 30.0).samples(1).size(SIZE[0], SIZE[1]);
    pixels(&scene.backend(BackendChoice::Cpu).build().expect("a scene"))
}

/// What a white surface of a map on the plane reflects of a sky of radiance 1: pictures with hard shadows
/// under lights that are spread evenly over the sky.
fn truth(map: &HeightMap) -> Vec<f32> {
    let surface = surface(map, Builtin::Plane, &[("shadow", "ray")], &[]);
    let (mut renderer, mut maps) = (Renderer::on_cpu(), Maps::in_memory());
    let light = Light::directional(DVec3::Y, Vec3::splat(2.0)).expect("a light");
    let scene = shadows::under_one_light(surface, light, View::Top, SIZE, BackendChoice::Cpu);
    let mut sums = vec![0.0; (SIZE[0] * SIZE[1]) as usize];
    for number in 0..LIGHTS {
        // Rings of the same solid angle, each a golden angle farther: a spiral over the sky.
        let up = (f64::from(number) + 0.5) / f64::from(LIGHTS);
        let (sin, cos) = (f64::from(number) * 0.618_033_988_749_895 * TAU).sin_cos();
        let flat = (1.0 - up * up).sqrt();
        let light = Light::directional(DVec3::new(cos * flat, up, sin * flat), Vec3::splat(2.0));
        let scene = scene.to_builder().lights(vec![light.expect("a light")]).build().expect("a scene");
        let rendered = renderer.render(&scene, &mut maps, &|_, _| {}).expect("a picture");
        for (sum, pixel) in sums.iter_mut().zip(&rendered.rendering.pixels) {
            *sum += pixel.color.x / LIGHTS as f32;
        }
    }
    sums
}

#[test]
fn what_knows_more_of_the_sky_is_nearer_to_the_truth() {
    // On smooth ground all of the sky that is seen lies before the surface: bent normals are right there.
    for (name, bent, occluded) in [("ground", 0.001, 0.001), ("cobbles", 0.01, 0.03), ("bricks", 0.01, 0.03)]
    {
        let map = map(name, 48);
        let truth = truth(&map);
        let [constant, occlusion, bent_normal] = ["constant", "occlusion", "bent-normal"].map(|ambient| {
            let surface = surface(&map, Builtin::Plane, &[("ambient", ambient)], &[]);
            let colors: Vec<f32> =
                in_white_sky(surface, View::Top).iter().map(|pixel| pixel.color.x).collect();
            mean_error(&colors, &truth)
        });
        println!("{name}: constant {constant:.4}, occlusion {occlusion:.4}, bent-normal {bent_normal:.4}");
        assert!(constant > occlusion && occlusion > bent_normal, "{name}");
        assert!(bent_normal < bent && occlusion < occluded, "{name}: {bent_normal}, {occlusion}");
    }
}

#[test]
fn a_white_furnace_is_white() {
    let settings = |albedo, bounces| [("ambient.albedo", albedo), ("ambient.bounces", bounces)];
    for (name, mesh) in [("bricks", Builtin::Plane), ("cobbles", Builtin::Sphere), ("bricks", Builtin::Torus)]
    {
        let map = map(name, 32);
        let shown = |settings: &[(&str, f64)]| {
            let surface = surface(&map, mesh, &[("ambient", "bounce")], settings);
            let pixels = in_white_sky(surface, View::Corner);
            let colors: Vec<f32> =
                pixels.iter().filter(|pixel| pixel.hit == 1).map(|pixel| pixel.color.x).collect();
            assert!(colors.len() > 300, "{name}: hardly any pixel");
            colors
        };
        let furnace = shown(&settings(1.0, 100.0));
        let worst = furnace.iter().map(|color| (color - 1.0).abs()).fold(0.0, f32::max);
        println!("{name}: {worst:.6}");
        assert!(worst < 1e-3, "{name}: {worst}");
        // A relief that swallows light is no furnace.
        let [none, half] = [0.0, 0.5].map(|albedo| shown(&settings(albedo, 8.0)));
        let darkest = none.iter().copied().fold(1.0, f32::min);
        assert!(darkest < 0.9, "{name}: {darkest}");
        assert!(none.iter().zip(&half).zip(&furnace).all(|((none, half), all)| none <= half && half <= all));
    }
}
