//! Parts of frames, and the times of several ways of doing something.

use std::time::Instant;

use glam::Vec3;
use relief_core::camera::Camera;
use relief_scene::light::Light;
use relief_scene::{Scene, Surface};

/// The fastest of some rounds of several ways, one after the other in each round, in seconds.
pub fn fastest<const N: usize>(rounds: u16, ways: [&mut dyn FnMut(); N]) -> [f64; N] {
    let mut timed = ways.map(|way| {
        move || {
            let start = Instant::now();
            way();
            start.elapsed().as_secs_f64()
        }
    });
    least(rounds, timed.each_mut().map(|way| way as &mut dyn FnMut() -> f64))
}

/// The same of ways that say how long they took.
pub fn least<const N: usize>(rounds: u16, mut ways: [&mut dyn FnMut() -> f64; N]) -> [f64; N] {
    let mut best = [f64::INFINITY; N];
    for _ in 0..rounds {
        for (way, best) in ways.iter_mut().zip(&mut best) {
            *best = best.min(way());
        }
    }
    best
}

/// From where base meshes and scenes are seen.
pub fn camera() -> Result<Camera, String> {
    let camera = Camera::new([0.24, 0.72, 0.96].into(), [0.0; 3].into(), 45.0);
    camera.map_err(|error| error.to_string())
}

/// A surface in the sun, with one sample a pixel.
pub fn scene(surface: Surface, size: [u32; 2]) -> Result<Scene, String> {
    let light = Light::directional([0.4, 1.0, 0.3].into(), Vec3::ONE).map_err(|error| error.to_string())?;
    let scene = Scene::builder(surface).camera(camera()?).size(size[0], size[1]).samples(1);
    scene.lights(vec![light]).build().map_err(|error| error.to_string())
}
