//! Pictures of objects of images that look at the spheres, on both backends.

use glam::DVec3;
use relief_core::Watch;
use relief_core::camera::Camera;
use relief_core::camera::Ray;
use relief_core::object::ImageObject;
use relief_maps::Maps;
use relief_render::render;
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;

use crate::adapter::Leeway;
use crate::spheres::first_on_spheres;

/// Columns and rows of the pictures.
pub const SIZE: [u32; 2] = [150, 120];

/// From where they are seen.
pub const EYES: [DVec3; 3] =
    [DVec3::new(1.0, 0.8, 3.0), DVec3::new(-2.6, 1.1, 1.3), DVec3::new(0.3, -3.0, 1.2)];

/// The share of covered pixels that must be alike.
pub const ALIKE: f64 = 0.999;

/// Places that are less far apart along each axis are the same.
const SAME_PLACE_M: f32 = 1e-4;

/// A method with settings, without shadows.
pub fn selection(method: &str, settings: &[(&str, f64)]) -> Selection {
    let mut selection = Selection::method(method).expect("a method");
    selection.choose("shadow", "none").expect("a listed name");
    for (key, value) in settings {
        selection.set(key, *value).expect("a setting");
    }
    selection
}

/// The camera there.
pub fn camera(eye: DVec3) -> Camera {
    Camera::new(eye, DVec3::new(0.0, 0.05, 0.0), 35.0).expect("a camera")
}

/// An object as a scene.
pub fn scene(object: &ImageObject, selection: Selection, eye: DVec3, backend: BackendChoice) -> Scene {
    let surface = Surface::of_object(object.clone()).expect("something to see").with_selection(selection);
    let scene = Scene::builder(surface).camera(camera(eye)).size(SIZE[0], SIZE[1]).samples(1);
    scene.backend(backend).build().expect("a proper scene")
}

/// Picture of an object.
pub fn pixels(
    object: &ImageObject,
    selection: Selection,
    eye: DVec3,
    backend: BackendChoice,
) -> Vec<PixelOut> {
    let scene = scene(object, selection, eye, backend);
    render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
}

/// The rays of all pixels.
pub fn rays(eye: DVec3) -> impl Iterator<Item = Ray> {
    let camera = camera(eye);
    (0..SIZE[0] * SIZE[1]).map(move |at| camera.ray(at % SIZE[0], at / SIZE[0], SIZE[0], SIZE[1]))
}

/// Share of pixels that see the spheres and should, among those that do either; and
/// their mean error of depth.
pub fn beside_truth(pixels: &[PixelOut], eye: DVec3) -> (f64, f64) {
    let (mut both, mut either, mut off) = (0, 0, 0.0);
    for (pixel, ray) in pixels.iter().zip(rays(eye)) {
        let truth = first_on_spheres(&ray);
        either += usize::from(truth.is_some() || pixel.hit == 1);
        if let (Some(t), 1) = (truth, pixel.hit) {
            both += 1;
            off += (t - f64::from(pixel.depth)).abs();
        }
    }
    (f64::from(both) / either as f64, off / f64::from(both))
}

/// The share of covered pixels that show the same place.
pub fn alike(one: &[PixelOut], other: &[PixelOut]) -> f64 {
    alike_within(one, other, SAME_PLACE_M)
}

/// The share of covered pixels that show the same place on both backends, and the least that it may be.
pub fn alike_on_both(cpu: &[PixelOut], gpu: &[PixelOut]) -> [f64; 2] {
    let leeway = Leeway::of_any();
    [alike_within(cpu, gpu, leeway.rounding * SAME_PLACE_M), leeway.share(ALIKE)]
}

fn alike_within(one: &[PixelOut], other: &[PixelOut], within_m: f32) -> f64 {
    let covered = one.iter().zip(other).filter(|(a, b)| a.hit == 1 || b.hit == 1);
    let alike = covered.clone().filter(|(a, b)| {
        let apart = [a.position.x - b.position.x, a.position.y - b.position.y, a.position.z - b.position.z];
        a.hit == b.hit && apart.iter().all(|part| part.abs() <= within_m)
    });
    let covered = covered.count();
    assert!(covered > 2500, "{covered} pixels");
    alike.count() as f64 / covered as f64
}
