//! Translucent volumes beside closed forms and quadrature in `f64`.

use glam::{DVec3, Vec3};
use rayon::prelude::*;
use relief_core::camera::Camera;
use relief_core::mesh::Mesh;
use relief_core::{HeightMap, Path, Volume, Wrap};
use relief_scene::{Scene, SceneBuilder, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::MethodTracer;

use crate::volume_rays::baked;

/// Metres that volumes are thick.
pub const THICK_M: f64 = 0.1;

/// The optical depth up to which the shaders promise the whole of it, with some leeway.
const SEEN_DEPTH: f64 = 7.0;

/// The method with an extinction per metre, and with other variants.
///
/// # Panics
///
/// When a name is unknown.
pub fn translucent(extinction: f64, others: &[(&str, &str)]) -> Selection {
    let mut selection = Selection::method("translucent").expect("a method");
    for (key, name) in others {
        selection.choose(key, name).expect("a listed name");
    }
    selection.set("search.extinction", extinction).expect("an extinction");
    selection
}

/// A volume that is 1 everywhere.
pub fn full() -> Volume {
    Volume::new([1; 3], &[1.0], Wrap::Repeat).expect("a volume")
}

/// A mesh under a volume of [`THICK_M`].
pub fn under(mesh: Mesh, volume: &Volume, selection: Selection) -> Surface {
    let volume = volume.clone().with_displacement(THICK_M, 0.0).expect("lengths");
    let ground = HeightMap::new(1, 1, vec![0.0], Wrap::Repeat).expect("a map");
    Surface::new(mesh, ground).with_volume(volume).with_selection(selection)
}

/// A scene that is seen askew from above, in pixels, without lights of its own.
pub fn seen(surface: Surface, [width, height]: [u32; 2]) -> SceneBuilder {
    let camera = Camera::new([0.4, 0.5, 0.9].into(), [0.0, 0.05, 0.0].into(), 40.0).expect("a camera");
    Scene::builder(surface)
        .camera(camera)
        .size(width, height)
        .samples(1)
        .lights(Vec::new())
        .ambient(Vec3::ZERO)
}

/// Metres of every pixel's ray in a box over the square, between two heights.
pub fn ways_in_box(scene: &Scene, low: f64, high: f64) -> Vec<f64> {
    let [width, height] = scene.size();
    let way = |at: u32| {
        let ray = scene.camera().ray(at % width, at / width, width, height);
        let along = ray.direction.normalize();
        let [a, b] =
            [[-0.5, low, -0.5], [0.5, high, 0.5]].map(|corner| (DVec3::from(corner) - ray.origin) / along);
        (a.max(b).min_element() - a.min(b).max_element().max(0.0)).max(0.0)
    };
    (0..width * height).into_par_iter().map(way).collect()
}

/// The greatest difference of a volume's optical depth, by the shaders, to another's by quadrature:
/// relative to depths above 1, over paths that some light comes through.
pub fn depth_error(shown: &Volume, judged: &Volume, paths: &[Path]) -> f64 {
    let selection = translucent(1.0, &[]);
    let maps = baked(shown, &selection);
    let tracer = MethodTracer::of_volume(shown, &selection, maps.iter().map(|map| &**map)).expect("its maps");
    let off = |path: &Path| {
        let judge = judged.integral_along(path, 1e-8);
        let found = f64::from(tracer.optical_depth(path));
        if judge > SEEN_DEPTH { 0.0 } else { (found - judge).abs() / judge.max(1.0) }
    };
    paths.par_iter().map(off).reduce(|| 0.0, f64::max)
}
