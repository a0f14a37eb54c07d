//! Pictures of triangles that are made for the camera: the same, to the last bit, whether those that nothing
//! sees are left out or not.

use std::sync::Arc;

use glam::{DVec3, Vec2, Vec3};
use relief_core::camera::{Camera, Projection};
use relief_core::mesh::{Builtin, Mesh, cube, cylinder, sphere, torus};
use relief_core::raycast::{RayCaster, Sides};
use relief_core::{HeightMap, Watch, Wrap};
use relief_maps::Maps;
use relief_mesh::{Cull, MeshSettings, Mesher, Outside, View};
use relief_render::Renderer;
use relief_render::gpu::AdapterChoice;
use relief_scene::light::Light;
use relief_scene::{Sampling, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use relief_testing::maps;
use relief_tests::adapter::open;

const SIZE: [u32; 2] = [120, 90];

fn map(wrap: Wrap, scale_m: f64) -> HeightMap {
    let named = maps::ALL.iter().find(|map| map.name == "natural 101x67").expect("it is listed");
    named.build(wrap).with_displacement(scale_m, -scale_m / 2.0).expect("lengths")
}

fn camera(eye: [f64; 3], target: [f64; 3], projection: Projection) -> Camera {
    Camera::with(eye.into(), target.into(), projection).expect("a camera")
}

/// From outside, zoomed in, through parallel rays, from below, within the relief, and past all of it.
fn cameras() -> [Camera; 6] {
    let perspective = |fov_degrees| Projection::Perspective { fov_degrees };
    [
        camera([0.7, 1.0, 1.3], [0.0; 3], perspective(40.0)),
        camera([0.4, 0.6, 1.1], [0.2, 0.05, 0.25], perspective(12.0)),
        camera([1.0, 0.8, 1.0], [0.2, 0.0, 0.1], Projection::Orthographic { height_m: 0.5 }),
        camera([0.3, -0.9, -0.8], [0.1, 0.0, 0.0], perspective(35.0)),
        camera([0.1, 0.01, 0.3], [0.3, 0.0, 0.0], perspective(70.0)),
        camera([0.0, 3.0, 0.0], [0.1, 6.0, 0.0], perspective(40.0)),
    ]
}

fn bases() -> Vec<(&'static str, Arc<Mesh>)> {
    let tiled = |mesh: Mesh, tiles| Arc::new(mesh.tiled(tiles).expect("tiles"));
    let mut bases = vec![
        ("plane", tiled(Builtin::Plane.build([1.2, 0.8]).expect("a mesh"), Vec2::splat(3.0))),
        ("torus", tiled(torus(24, 12).expect("a mesh"), Vec2::new(3.0, 1.0))),
        ("sphere", tiled(sphere(20, 10).expect("a mesh"), Vec2::new(2.0, 1.0))),
        ("cube", tiled(cube(4).expect("a mesh"), Vec2::ONE)),
        ("cylinder", tiled(cylinder(16, 3).expect("a mesh"), Vec2::new(2.0, 1.0))),
    ];
    if let Some(spot) = relief_tests::spot("spot_control_mesh.obj") {
        bases.push(("spot", Arc::new(spot)));
    }
    bases
}

fn remesh(stages: &[(&str, &str)], settings: &[(&str, f64)]) -> Selection {
    let mut selection = Selection::method("remesh").expect("a method");
    for (stage, name) in stages {
        selection.choose(stage, name).expect("a listed name");
    }
    for (key, value) in settings {
        selection.set(key, *value).expect("a setting");
    }
    selection
}

fn rendered(scene: &Scene, renderer: &mut Renderer) -> Vec<PixelOut> {
    renderer.render(scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
}

/// Some lights, far away and near.
fn lights(way: usize) -> Vec<Light> {
    let far = |toward: [f64; 3]| Light::directional(toward.into(), Vec3::ONE).expect("a light");
    let near = |at: [f64; 3]| Light::point(at.into(), Vec3::ONE).expect("a light");
    match way % 4 {
        0 => vec![far([0.4, 1.0, 0.3])],
        1 => vec![near([0.6, 1.1, 0.9])],
        2 => vec![far([-0.9, 0.5, 0.2]), near([-0.5, 1.4, 0.6])],
        _ => vec![far([0.1, 0.3, -1.0])],
    }
}

/// A scene of a base in one of a few ways, lit or without shadows.
fn scene(base: &Arc<Mesh>, camera: Camera, way: usize, is_lit: bool) -> Scene {
    // Bases beside the eye or behind it have many points there.
    let is_beside = camera.eye().length() < 0.5 || camera.eye().length() > 2.5;
    let pixels = [1.0, 2.5][way % 2] * if is_beside { 4.0 } else { 1.0 };
    let detail = ["none", "footprint"][way % 2];
    let shadow = if is_lit { "map" } else { "none" };
    let mut selection = remesh(&[("shadow", shadow), ("detail", detail)], &[("geometry.pixels", pixels)]);
    if is_lit {
        selection.set("shadow.size", 256.0).expect("a setting");
    }
    let map = map(Wrap::ALL[way % Wrap::ALL.len()], [0.06, 0.15][way / 2 % 2]);
    let surface = Surface::new(Arc::clone(base), map).with_selection(selection);
    let surface = surface.with_two_sided(way % 3 == 2);
    let builder = Scene::builder(surface).camera(camera).size(SIZE[0], SIZE[1]).lights(lights(way));
    builder.samples([1, 4][usize::from(way % 4 == 3)]).build().expect("a scene")
}

fn whole(scene: &Scene) -> Scene {
    scene.to_builder().culls(false).build().expect("a scene")
}

/// All pictures with and without what nothing sees, and how many of them show anything.
fn same_pictures(renderer: &mut Renderer) -> [usize; 2] {
    let mut found = [0; 2];
    for (b, (name, base)) in bases().iter().enumerate() {
        for (c, camera) in cameras().into_iter().enumerate() {
            let way = b + c;
            let scene = scene(base, camera, way, (b + c / 2) % 2 == 1);
            println!("{name}, camera {c}, way {way}");
            let culled = rendered(&scene, renderer);
            assert!(culled == rendered(&whole(&scene), renderer), "{name}, camera {c}, way {way}");
            let hits = culled.iter().filter(|pixel| pixel.hit == 1).count();
            found[usize::from(hits > 0)] += 1;
        }
    }
    found
}

#[test]
fn pictures_are_the_same_on_the_cpu() {
    let [empty, shown] = same_pictures(&mut Renderer::on_cpu());
    println!("{shown} pictures, {empty} of nothing");
    assert!(empty >= 5 && shown >= 20, "{shown} {empty}");
}

#[test]
fn pictures_are_the_same_on_a_gpu() {
    let Some(gpu) = open(AdapterChoice::Any) else { return };
    let [empty, shown] = same_pictures(&mut Renderer::on_gpu(gpu, Sampling::Exact));
    println!("{shown} pictures, {empty} of nothing");
    assert!(empty >= 5 && shown >= 20, "{shown} {empty}");
}

#[test]
fn shadows_of_what_the_camera_does_not_see_stay() {
    // A ball behind the eye, between the light and the ground that is seen.
    let ground = Builtin::Plane.build([2.0, 2.0]).expect("a mesh");
    let ball = sphere(12, 6).expect("a mesh").placed(&relief_core::mesh::Placement {
        position_m: DVec3::new(0.0, 1.2, 1.2),
        rotation_degrees: DVec3::ZERO,
        size: 0.5,
    });
    let ball = Arc::new(ball.expect("a place"));
    let camera = camera([0.0, 0.5, 0.5], [0.0, 0.0, 0.0], Projection::Perspective { fov_degrees: 60.0 });
    let light = Light::directional(DVec3::new(0.0, 1.0, 1.0), Vec3::ONE).expect("a light");
    for shadow in ["map", "scene"] {
        let under = || remesh(&[("shadow", shadow)], &[("geometry.pixels", 4.0)]);
        let surface = Surface::new(ground.clone(), map(Wrap::Clamp, 0.02)).with_selection(under());
        let ball = Surface::new(Arc::clone(&ball), map(Wrap::Repeat, 0.02)).with_selection(under());
        let builder = Scene::builder(surface).surface(ball).camera(camera).size(SIZE[0], SIZE[1]);
        let scene = builder.samples(1).lights(vec![light]).build().expect("a scene");
        let culled = rendered(&scene, &mut Renderer::on_cpu());
        assert!(culled == rendered(&whole(&scene), &mut Renderer::on_cpu()), "{shadow}");
        let dark = culled.iter().filter(|pixel| pixel.hit == 1 && pixel.lit < 0.5).count();
        println!("{shadow}: {dark} in the shadow");
        assert!(dark > 300, "{shadow}: {dark}");
    }
}

/// The depths that rays through all pixels meet a mesh at.
fn depths(mesh: &Mesh, view: &View, sides: Sides) -> Vec<Option<u64>> {
    let caster = RayCaster::new(mesh);
    let [width, height] = view.size;
    let ray = |at: u32| view.camera.ray(at % width, at / width, width, height);
    (0..width * height).map(|at| Some(caster.next_hit(&ray(at), sides, None)?.t.to_bits())).collect()
}

#[test]
fn what_another_view_or_another_side_leaves_out_is_missed() {
    let (mut same, mut missed, mut turned) = (0, 0, 0);
    for (name, base) in &bases()[..4] {
        for camera in &cameras()[..4] {
            let view = View { pixels: 2.0, near_m: 0.05, ..View::new(*camera, SIZE) };
            let map = map(Wrap::Repeat, 0.08);
            let made = |cull: Cull| {
                let settings = MeshSettings { cull: Some(cull), ..MeshSettings::seen_by(view) };
                Mesher::new(base, &map, &settings).expect("a mesh")
            };
            let shown = |cull: Cull, view: &View, sides: Sides| match made(cull) {
                mesher if mesher.triangles() == 0 => None,
                mesher => Some(depths(&mesher.mesh().expect("finite"), view, sides)),
            };
            let all = Cull { outside: Outside::ALL, backs: true };
            let front = shown(Cull::default(), &view, Sides::Front);
            assert!(shown(all, &view, Sides::Front) == front, "{name}");
            same += 1;
            // Seen from both sides the backs are missed, and farther aside what lies beside the picture.
            let both = shown(Cull::default(), &view, Sides::Both);
            turned += usize::from(shown(all, &view, Sides::Both) != both);
            let outside = Cull { outside: Outside::ALL, backs: false };
            assert!(shown(outside, &view, Sides::Both) == both, "{name}");
            let wide = View { size: [SIZE[0] * 3, SIZE[1]], ..view };
            let beside = shown(outside, &wide, Sides::Both) != shown(Cull::default(), &wide, Sides::Both);
            missed += usize::from(beside);
        }
    }
    println!("{same} the same, {missed} of wider pictures not, {turned} from both sides not");
    assert!(missed >= 2 && turned >= 1, "{missed} {turned}");
}
