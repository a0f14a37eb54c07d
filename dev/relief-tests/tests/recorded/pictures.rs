//! The shipped scenes by every method, on the CPU: colours, and every channel of numbers that a picture can
//! be written as.

use std::collections::BTreeMap;
use std::path::Path;

use relief_maps::Maps;
use relief_render::picture::aov;
use relief_render::render;
use relief_render::scene::{BackendChoice, SceneSpec, SurfaceSpec, read_scene};
use relief_shaders::{DETAIL, METHODS, SLICES, STAGES, Selection};

use crate::hash::Bits;

const SCENES: [&str; 5] = ["bricks", "cobbles", "jacksboro", "logo", "spikes"];

const SIZE: [u32; 2] = [200, 150];

/// Of pictures with levels of detail: so small that several texels lie in a pixel.
const SMALL: [u32; 2] = [50, 38];

/// The methods with which these are rendered.
const IN_LEVELS: [&str; 4] = ["exact", "cone", "frustum", "relief"];

/// The hash of every channel, by scene and method: the colours' first.
pub fn all() -> BTreeMap<String, String> {
    let methods = || METHODS.iter().filter(|method| method.is_of_reliefs());
    let scenes = SCENES.iter().flat_map(|scene| methods().map(move |method| (*scene, method.name)));
    let finest =
        scenes.map(|(scene, method)| (format!("{scene} {method}"), hashes(scene, method, "none", SIZE)));
    let scenes = SCENES.iter().flat_map(|scene| IN_LEVELS.iter().map(move |method| (*scene, *method)));
    let levels = scenes.map(|(scene, method)| {
        (format!("{scene} {method} small"), hashes(scene, method, "footprint", SMALL))
    });
    finest.chain(levels).collect()
}

fn hashes(scene: &str, method: &str, detail: &str, size: [u32; 2]) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").join(format!("{scene}.toml"));
    let stages = [(STAGES[DETAIL].key.to_owned(), detail.to_owned())].into();
    // What lights see need not be fine.
    let of_method = Selection::method(method).expect("a method");
    let is_sliced = of_method.uses(SLICES);
    let set = [(of_method.light_views().is_some(), "shadow.size", 256.0), (is_sliced, "slices.count", 8.0)];
    let set = set.iter().filter(|(is_set, ..)| *is_set).map(|(_, key, value)| ((*key).to_owned(), *value));
    let set = set.collect();
    let surface = SurfaceSpec { method: Some(method.to_owned()), stages, set, ..SurfaceSpec::default() };
    let over = SceneSpec {
        backend: Some(BackendChoice::Cpu),
        size: Some(size.into()),
        samples: Some(1),
        ..SceneSpec::of_surface(surface)
    };
    let scene =
        read_scene(&path).expect("a shipped scene").overridden_by(over).load().expect("a shipped map");
    let rendering = render(&scene, &mut Maps::in_memory(), &|_, _| {}).expect("a picture").rendering;
    let pixels = rendering.pixels.iter();
    let colors = pixels.flat_map(|pixel| [pixel.color.x, pixel.color.y, pixel.color.z, pixel.color.w]);
    let mut said = vec![format!("color {}", Bits::default().floats(colors).short())];
    for (name, values) in aov(&rendering) {
        said.push(format!("{name} {}", Bits::default().floats(values).short()));
    }
    said.join(", ")
}
