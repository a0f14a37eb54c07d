//! Light from all around: how much of it arrives, beside many lights with shadows; and none is made. What is
//! seen of surroundings, beside the laws of reflection and refraction.

use std::f64::consts::{PI, TAU};

use glam::{DMat3, DVec3, Vec2, Vec3};
use relief_core::mesh::{Builtin, Mesh, Placement};
use relief_core::{HeightMap, Watch, Wrap};
use relief_io::Picture;
use relief_maps::Maps;
use relief_render::Renderer;
use relief_scene::environment::Environment;
use relief_scene::light::Light;
use relief_scene::material::Material;
use relief_scene::{BackendChoice, Scene, Surface, View};
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
    surface_on(map, mesh, choose, set)
}

/// The plane of a map, turned about the axes by `degrees`.
fn tilted(map: &HeightMap, rotation_degrees: DVec3) -> (Mesh, DMat3) {
    let placement = Placement { rotation_degrees, ..Placement::default() };
    let plane = Builtin::Plane.build(map.proportions()).expect("a built-in mesh");
    (plane.placed(&placement).expect("a placement"), placement.turn().expect("a placement"))
}

/// A white surface of a map on any mesh.
fn surface_on(map: &HeightMap, mesh: Mesh, choose: &[(&str, &str)], set: &[(&str, f64)]) -> Surface {
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

/// What is seen of a surface in surroundings without other light.
fn in_surroundings(surface: Surface, environment: Environment, view: View) -> (Scene, Vec<PixelOut>) {
    let scene = Scene::builder(surface).lights(Vec::new()).background(Vec3::ZERO).environment(environment);
    let scene = scene.fitted_camera(view, 30.0).samples(1).size(SIZE[0], SIZE[1]);
    let scene = scene.backend(BackendChoice::Cpu).build().expect("a scene");
    let pixels = pixels(&scene);
    (scene, pixels)
}

/// Surroundings of the light that is seen in each direction.
fn surroundings(seen: impl Fn(DVec3) -> [f32; 3]) -> Environment {
    let (width, height) = (256u32, 128u32);
    let texel = |at: u32| {
        let [column, row] = [at % width, at / width].map(|at| f64::from(at) + 0.5);
        let (flat, up) = (row / f64::from(height) * PI).sin_cos();
        let (sin, cos) = ((column / f64::from(width) - 0.5) * TAU).sin_cos();
        let [red, green, blue] = seen(DVec3::new(sin * flat, up, -cos * flat));
        [red, green, blue, 1.0]
    };
    let picture = Picture { width, height, texels: (0..width * height).map(texel).collect() };
    Environment::from_equirectangular(&picture).expect("surroundings")
}

/// What a white surface of a map on the plane reflects of a sky of radiance 1.
fn truth(map: &HeightMap) -> Vec<f32> {
    truth_under(map, DVec3::ZERO, |_| 1.0)
}

/// What a white surface of a map on the plane, turned by `degrees`, reflects of surroundings of a
/// radiance for each direction: pictures with hard shadows under lights that are spread evenly over the half
/// of them that the plane sees.
fn truth_under(map: &HeightMap, degrees: DVec3, radiance: impl Fn(DVec3) -> f32) -> Vec<f32> {
    let (mesh, turn) = tilted(map, degrees);
    let surface = surface_on(map, mesh, &[("shadow", "ray")], &[]);
    let (mut renderer, mut maps) = (Renderer::on_cpu(), Maps::in_memory());
    let light = Light::directional(DVec3::Y, Vec3::splat(2.0)).expect("a light");
    let scene = shadows::under_one_light(surface, light, View::Top, SIZE, BackendChoice::Cpu);
    let mut sums = vec![0.0; (SIZE[0] * SIZE[1]) as usize];
    for number in 0..LIGHTS {
        // Rings of the same solid angle, each a golden angle farther: a spiral over the sky.
        let up = (f64::from(number) + 0.5) / f64::from(LIGHTS);
        let (sin, cos) = (f64::from(number) * 0.618_033_988_749_895 * TAU).sin_cos();
        let flat = (1.0 - up * up).sqrt();
        let toward = turn * DVec3::new(cos * flat, up, sin * flat);
        let light = Light::directional(toward, Vec3::splat(2.0 * radiance(toward)));
        let scene = scene.to_builder().lights(vec![light.expect("a light")]).build().expect("a scene");
        let rendered = renderer.render(&scene, &mut maps, &Watch::none()).expect("a picture");
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

/// The ground's radiance beside the sky's.
const GROUND: f32 = 0.35;

/// What is seen of a map on the plane, turned by `degrees`, under an ambient light with settings.
fn under(ambient: &str, map: &HeightMap, degrees: DVec3, set: &[(&str, f64)], detail: &str) -> Vec<PixelOut> {
    let choose = [("ambient", ambient), ("detail", detail)];
    in_white_sky(surface_on(map, tilted(map, degrees).0, &choose, set), View::Top)
}

#[test]
fn an_open_plane_shows_the_same_by_hemisphere_and_sky_however_it_is_turned() {
    let sizes = [[1, 1], [1, 5], [9, 1], [300, 700], [64, 64]];
    let turns = [[0.0, 0.0, 0.0], [35.0, 0.0, 0.0], [-20.0, 40.0, 60.0]].map(DVec3::from);
    for (number, size) in sizes.into_iter().enumerate() {
        let wrap = Wrap::ALL[number % Wrap::ALL.len()];
        let map = HeightMap::from_fn(size[0], size[1], wrap, |_, _| 0.25).expect("a map");
        for degrees in turns {
            for (ground, detail) in [(f64::from(GROUND), "none"), (0.0, "footprint"), (1.0, "none")] {
                let set = [("ambient.ground", ground)];
                let [hemisphere, sky] =
                    ["hemisphere", "sky"].map(|ambient| under(ambient, &map, degrees, &set, detail));
                let up = turns_up(degrees);
                let right = ground + (1.0 - ground) * (0.5 + 0.5 * up);
                let hit = |pixel: &&PixelOut| pixel.hit == 1;
                // At a border a clamped plane may be seen past, as long as most is seen.
                assert!(sky.iter().filter(hit).count() > 60, "{size:?} {degrees}");
                for (a, b) in hemisphere.iter().zip(&sky).filter(|(a, _)| a.hit == 1) {
                    assert!((f64::from(a.color.x) - right).abs() < 1e-6, "{size:?} {degrees} {ground}");
                    assert!((a.color.x - b.color.x).abs() < 1e-6, "{size:?} {degrees} {ground}");
                }
            }
        }
    }
}

/// The part upward of a plane's normal that is turned by `degrees`.
fn turns_up(degrees: DVec3) -> f64 {
    let placement = Placement { rotation_degrees: degrees, ..Placement::default() };
    (placement.turn().expect("a placement") * DVec3::Y).y
}

#[test]
fn an_occluded_sky_is_near_the_integral_over_the_hemisphere() {
    let radiance = |toward: DVec3| if toward.y >= 0.0 { 1.0 } else { GROUND };
    // Mean errors are at most 0.012, and 0.023 at least without what the relief hides.
    let (bound, open_bound) = (0.015, 0.022);
    let ground = ("ambient.ground", f64::from(GROUND));
    let mut wrong = Vec::new();
    for name in ["cobbles", "bricks"] {
        let coarse = map(name, 48);
        // The same heights, with four texels for each: the level of 48 texels is the coarse map.
        let texel = |i: u32, j: u32| coarse.texels()[(j / 2 * 48 + i / 2) as usize];
        let fine = HeightMap::from_fn(96, 96, Wrap::Mirror, texel).expect("a map");
        // Level, and on a slope, where some of the ground is seen.
        for degrees in [DVec3::ZERO, DVec3::new(35.0, 0.0, 20.0)] {
            let colors = |ambient: &str, map: &HeightMap, set: &[(&str, f64)], detail: &str| {
                let pixels = under(ambient, map, degrees, set, detail);
                pixels.iter().map(|pixel| pixel.color.x).collect::<Vec<f32>>()
            };
            for (map, side, detail) in
                [(&coarse, 512.0, "none"), (&fine, 48.0, "none"), (&fine, 48.0, "footprint")]
            {
                let truth = truth_under(map, degrees, radiance);
                let open = mean_error(&colors("hemisphere", map, &[ground], detail), &truth);
                let sky = colors("sky", map, &[ground, ("ambient.side", side)], detail);
                let sky = mean_error(&sky, &truth);
                println!("{name}, {degrees}, {} {detail}: open {open:.4}, sky {sky:.4}", map.width());
                // A sky that nothing hides is far off.
                if sky >= bound || open < open_bound {
                    wrong.push((name, degrees, sky, open));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:?}");
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

#[test]
fn refraction_neither_makes_light_nor_swallows_it() {
    let worst = |mesh, light: f32, transmission, ior| {
        let surface = surface(&map("cobbles", 32), mesh, &[("ambient", "environment")], &[]);
        let material = surface.material().with_transmission(transmission, ior).expect("a material");
        let environment = surroundings(|_| [light; 3]);
        let (_, pixels) = in_surroundings(surface.with_material(material), environment, View::Corner);
        let seen: Vec<f32> =
            pixels.iter().filter(|pixel| pixel.hit == 1).map(|pixel| pixel.color.x).collect();
        assert!(seen.len() > 300, "hardly any pixel");
        seen.into_iter().map(|color| (color - 1.0).abs()).fold(0.0, f32::max)
    };
    for mesh in [Builtin::Plane, Builtin::Sphere, Builtin::Torus] {
        for (transmission, ior) in [(1.0, 1.5), (1.0, 1.0), (1.0, 4.0), (0.5, 1.33), (0.0, 1.5)] {
            let worst = worst(mesh, 1.0, transmission, ior);
            println!("{mesh:?}, {transmission} with {ior}: {worst:.7}");
            assert!(worst < 1e-3, "{mesh:?}, {transmission} with {ior}: {worst}");
        }
        // Surroundings that are darker are seen to be.
        assert!(worst(mesh, 0.99, 1.0, 1.5) > 5e-3);
    }
}

#[test]
fn surroundings_are_seen_where_light_comes_from() {
    // Light that grows along the axes is seen as it is in every lobe that is narrow.
    let seen = |toward: DVec3| toward.to_array().map(|part| (1.0 + part) as f32);
    let flat = HeightMap::new(1, 1, vec![1.0], Wrap::Clamp).expect("a map");
    for (transmission, ior, color) in [(1.0, 1.5, 0.0), (1.0, 2.4, 0.0), (0.0, 3.0, 0.0), (0.0, 1.33, 1.0)] {
        let surface = surface(&flat, Builtin::Plane, &[("ambient", "environment")], &[]);
        let material = Material::new(Vec3::splat(color), Vec3::ZERO, 1024).expect("a material");
        let material = material.with_transmission(transmission, ior).expect("a material");
        let (scene, pixels) =
            in_surroundings(surface.with_material(material), surroundings(seen), View::Corner);
        let mut count = 0;
        for pixel in pixels.iter().filter(|pixel| pixel.hit == 1) {
            let position = [pixel.position.x, pixel.position.y, pixel.position.z].map(f64::from);
            let down = (DVec3::from(position) - scene.camera().eye()).normalize();
            let (normal, cosine, ior) = (DVec3::Y, -down.y, f64::from(ior));
            // Snell's law by angles, and Fresnel's equations as in a book of optics.
            let (outside, inside) = (cosine.acos(), (cosine.acos().sin() / ior).asin());
            let across = -(outside - inside).sin() / (outside + inside).sin();
            let along = (outside - inside).tan() / (outside + inside).tan();
            let reflected = (across * across + along * along) / 2.0;
            let aside = (down + normal * cosine).normalize_or_zero();
            let refracted = aside * inside.sin() - normal * inside.cos();
            let mirrored = down + normal * (2.0 * cosine);
            let white = DVec3::ONE + normal * (2.0 / 3.0);
            let entered = f64::from(transmission) * (DVec3::ONE + refracted)
                + (1.0 - f64::from(transmission)) * f64::from(color) * white;
            let right = reflected * (DVec3::ONE + mirrored) + (1.0 - reflected) * entered;
            for (given, right) in
                [pixel.color.x, pixel.color.y, pixel.color.z].into_iter().zip(right.to_array())
            {
                assert!(
                    (f64::from(given) - right).abs() < 0.012,
                    "{transmission}, {ior}: {given} for {right}"
                );
            }
            count += 1;
        }
        assert!(count > 300, "hardly any pixel");
    }
}
