//! The shipped scenes by every method, on the CPU: colours, and every channel of numbers that a picture can
//! be written as.

use std::collections::BTreeMap;
use std::path::Path;

use relief_core::Watch;
use relief_maps::Maps;
use relief_render::job::Rendering;
use relief_render::picture::{aov, linear};
use relief_render::render;
use relief_scene::{BackendChoice, SceneSpec, SurfaceSpec, parse_scene, read_scene};
use relief_shaders::{DETAIL, METHODS, SLICES, STAGES, Selection};

use crate::hash::Bits;

const SCENES: [&str; 5] = ["bricks", "cobbles", "jacksboro", "logo", "spikes"];

const SIZE: [u32; 2] = [200, 150];

/// Of pictures with levels of detail: so small that several texels lie in a pixel.
const SMALL: [u32; 2] = [50, 38];

/// The methods with which these are rendered.
const IN_LEVELS: [&str; 4] = ["exact", "cone", "frustum", "relief"];

/// Scenes in the look `studio`: a plane, a curved mesh, and two surfaces that shadow each other.
const STUDIO: [(&str, &str); 3] = [
    ("bricks", "height = '../data/bricks.png'\n"),
    ("torus", "height = '../data/cobbles.png'\nmesh = 'torus'\ntile = [7, 3]\nscale = 0.03\n"),
    (
        "ball over a floor",
        "height = '../data/cobbles.png'\nset.shadow.size = 256\n[[surfaces]]\nmesh-scale = 2\n\
         [[surfaces]]\nmesh = 'sphere'\nposition = [0, 0.6, 0]\n",
    ),
];

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
    let studio = STUDIO.iter().map(|(name, toml)| (format!("studio {name}"), hashes_of_look(toml)));
    finest.chain(levels).chain(studio).collect()
}

/// The hashes of a scene in the look of scene files that name none: of all channels, and of what is shown.
fn hashes_of_look(toml: &str) -> String {
    let (backend, size) = (Some(BackendChoice::Cpu), Some(SIZE.into()));
    let over = SceneSpec { backend, size, ..SceneSpec::default() };
    let place = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/studio.toml");
    let spec = parse_scene(toml, &place).expect("a proper scene").overridden_by(over);
    let scene = spec.load().expect("shipped maps");
    let rendering = render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering;
    let shown = linear(&rendering, &scene);
    let shown = Bits::default().floats(shown.into_iter().flatten()).short();
    format!("{}, shown {shown}", of_channels(&rendering))
}

fn hashes(scene: &str, method: &str, detail: &str, size: [u32; 2]) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").join(format!("{scene}.toml"));
    let stages = [(STAGES[DETAIL].key.to_owned(), detail.to_owned())].into();
    // What lights see need not be fine.
    let of_method = Selection::method(method).expect("a method");
    let is_sliced = of_method.uses(SLICES);
    // Nor must every direction be baked.
    let has_directions = of_method.search().param("elevations").is_some();
    let is_compressed = of_method.search().param("rank").is_some();
    let set = [
        (of_method.light_views().is_some(), "shadow.size", 256.0),
        (is_sliced, "slices.count", 8.0),
        (has_directions, "search.azimuths", 4.0),
        (has_directions, "search.elevations", 3.0),
        (is_compressed, "search.rank", 6.0),
    ];
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
    of_channels(&render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering)
}

fn of_channels(rendering: &Rendering) -> String {
    let pixels = rendering.pixels.iter();
    let colors = pixels.flat_map(|pixel| [pixel.color.x, pixel.color.y, pixel.color.z, pixel.color.w]);
    let mut said = vec![format!("color {}", Bits::default().floats(colors).short())];
    for (name, values) in aov(rendering) {
        if name == "transmittance" {
            assert!(values.iter().all(|value| *value == 1.0), "nothing translucent is shown");
            continue;
        }
        said.push(format!("{name} {}", Bits::default().floats(values).short()));
    }
    said.join(", ")
}
