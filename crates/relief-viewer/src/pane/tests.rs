//! The CPU and a software GPU take over from each other.

use std::time::Duration;

use relief_core::{HeightMap, Watch, Wrap};
use relief_maps::Maps;
use relief_render::gpu::{AdapterChoice, Gpu};
use relief_render::{RenderInfo, block_on};
use relief_scene::{Scene, Surface};
use relief_shaders::Selection;

use super::{Painted, Pane};
use crate::takeover::Device;

/// A software GPU. Without one the test says that it skips, unless the environment variable
/// `RELIEF_REQUIRE_GPU` is 1: then it fails.
fn software() -> Option<Gpu> {
    let is_required = std::env::var_os("RELIEF_REQUIRE_GPU").is_some_and(|value| value == "1");
    match Gpu::new(AdapterChoice::Software) {
        Ok(gpu) => Some(gpu),
        Err(error) if is_required => panic!("RELIEF_REQUIRE_GPU is 1: {error}"),
        Err(error) => {
            println!("skipped: {error}");
            None
        }
    }
}

fn scene(method: &str) -> Scene {
    let heights = HeightMap::from_fn(8, 8, Wrap::Repeat, |i, j| ((i * 3 + j * 5) % 7) as f32 / 6.0);
    let heights = heights.expect("heights").with_displacement(0.2, 0.0).expect("a scale");
    let surface = Surface::new(relief_core::mesh::square(1).expect("a mesh"), heights);
    let surface = surface.with_selection(Selection::method(method).expect("a method"));
    Scene::builder(surface).size(40, 30).build().expect("a scene")
}

/// Draws a picture, and returns its bytes and the backend.
fn drawn(pane: &mut Pane, scene: &Scene) -> (Vec<u8>, &'static str) {
    let picture = block_on(pane.picture(scene, 0..30, &mut Maps::in_memory(), &Watch::none()));
    match picture.expect("a picture") {
        (Painted::Picture(bytes, _), info) => (bytes, info.backend),
        (Painted::Quantity(..), _) => panic!("it is a picture"),
    }
}

/// Draws a picture for a screen, if a GPU draws.
fn on_screen(pane: &mut Pane, scene: &Scene) -> Option<Vec<u8>> {
    let screen = block_on(pane.screen(scene, &mut Maps::in_memory(), &Watch::none())).expect("a picture");
    match screen {
        Some((Painted::Picture(bytes, rows), info)) => {
            assert_eq!((rows, info.backend), (0..30, "gpu"));
            Some(bytes)
        }
        Some((Painted::Quantity(..), _)) => panic!("it is a picture"),
        None => None,
    }
}

/// Does what is to be done in the background, and returns whether anything was.
fn warmed(pane: &Pane, scene: &Scene) -> bool {
    let warming = pane.warming(scene, &Maps::in_memory());
    warming.map(|warming| block_on(warming.run())).is_some()
}

/// Says that the CPU took an hour, in place of what was measured.
fn slow_down(pane: &mut Pane, scene: &Scene) {
    let hour = Duration::from_secs(3600);
    let info =
        RenderInfo { backend: "cpu", device: String::new(), reason: None, maps: Vec::new(), elapsed: hour };
    // The times of other methods are forgotten.
    pane.takeover.cpu_drew(&self::scene("steep"), &info);
    pane.takeover.cpu_drew(scene, &info);
}

#[test]
fn the_faster_one_draws() {
    let Some(gpu) = software() else { return };
    let (mut pane, scene) = (Pane::new(&Device::of(gpu)), scene("relief"));
    let (on_cpu, backend) = drawn(&mut pane, &scene);
    assert_eq!(backend, "cpu");
    assert_eq!(on_screen(&mut pane, &scene), None);
    assert!(warmed(&pane, &scene) && !warmed(&pane, &scene));
    slow_down(&mut pane, &scene);
    let (on_gpu, backend) = drawn(&mut pane, &scene);
    assert_eq!(backend, "gpu");
    let most = on_cpu.iter().zip(&on_gpu).map(|(one, other)| one.abs_diff(*other)).max();
    assert!(on_cpu.len() == on_gpu.len() && most <= Some(2), "{most:?}");
    let quick = on_screen(&mut pane, &scene).expect("the GPU draws");
    assert!(quick.iter().zip(&on_gpu).all(|(quick, whole)| quick.abs_diff(*whole) <= 1));
    // Another method's programs are not there yet.
    let other = self::scene("cone");
    assert_eq!(drawn(&mut pane, &other).1, "cpu");
    assert!(warmed(&pane, &other));
    // Nothing is faster than no time.
    let at_once = RenderInfo {
        backend: "cpu",
        device: String::new(),
        reason: None,
        maps: Vec::new(),
        elapsed: Duration::ZERO,
    };
    pane.takeover.cpu_drew(&other, &at_once);
    assert_eq!(drawn(&mut pane, &other).1, "cpu");
}

#[test]
fn a_gpu_that_is_lost_gives_back() {
    let Some(gpu) = software() else { return };
    let (mut pane, scene) = (Pane::new(&Device::of(gpu.clone())), scene("relief"));
    let on_cpu = drawn(&mut pane, &scene);
    assert!(warmed(&pane, &scene));
    slow_down(&mut pane, &scene);
    assert_eq!(drawn(&mut pane, &scene).1, "gpu");
    gpu.device().destroy();
    assert_eq!(on_screen(&mut pane, &scene), None);
    assert_eq!(drawn(&mut pane, &scene), on_cpu);
    assert!(pane.fallen_back.as_ref().is_some_and(|why| why.contains("lost")), "{:?}", pane.fallen_back);
    assert_eq!(drawn(&mut pane, &scene), on_cpu);
    assert!(pane.fallen_back.is_some(), "it is said as long as it is so");
}
