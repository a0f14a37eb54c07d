mod files_in_memory;
mod listed_keys;
mod loading;
mod looks;
mod map_size;
mod materials;
mod overriding;
mod proportions;
mod ramps;
mod reader;
mod texture_sets;
mod walls;

use super::*;
use crate::depth_buffer::Clip;
use crate::environment::Environment;
use crate::light::{Light, MAX_LIGHTS};
use crate::material::Material;
use crate::tone::Tone;
use glam::{DVec3, Vec3};
use proptest::prelude::*;
use relief_core::camera::Projection;
use relief_core::mesh::{Builtin, square};
use relief_core::{ByteSize, HeightMap, Wrap};
use relief_shaders::Selection;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A file of the project, from its root.
fn shipped(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

/// Reads a scene file with this text.
fn read(text: &str) -> Result<SceneSpec, SceneError> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("scene.toml");
    fs::write(&path, text).expect("a temporary file");
    read_scene(&path)
}

fn flat() -> Surface {
    let map = HeightMap::new(1, 1, vec![0.5], Wrap::Repeat).expect("a valid map");
    Surface::new(square(1).expect("a mesh"), map)
}

/// Returns the values that a description has for every surface.
fn of(surface: SurfaceSpec) -> SceneSpec {
    SceneSpec::of_surface(surface)
}

/// Names of variants by their stages' keys.
fn stages<const N: usize>(names: [(&str, &str); N]) -> BTreeMap<String, String> {
    names.map(|(key, name)| (key.to_owned(), name.to_owned())).into()
}

/// A file with every key but those that exclude others.
const FULL: &str = r#"
look = "plain"
height = "maps/a.exr"
channel = "height"
depth = true
range = [236, 1076.5]
elevation = [-20, "0.5km"]
nodata = -9999
unit = "cm,us-ft"
raw = "403x344,le"
fill = true
holes = true
wrap = "mirror"
scale = 0.2
bias = -0.1
exaggerate = 1.5
creases = true
color = "/somewhere/b.png"
normal = "c.png"
green = "-y"
textures = "set"
udim = 1002
roughness = "r.png"
metallic = "m.png"
occlusion = "o.png"
orm = "orm.png"
mask-map = "mask.png"
metallic-smoothness = "ms.png"
glossiness = "gloss.png"
emission = "e.png"
mesh = "meshes/column.glb"
project = "box"
mesh-up = "z"
tile = [8, 3.5]
tile-size = [50, 20]
position = [0, -0.5, 0]
rotation = [90, 0, 0]
search = "linear"
refine = "binary"
shade = "metallic-roughness"
shadow = "soft"
shadow-search = "frustum"
set.search.steps = 64
set.refine.steps = 6
eye = [1, 2, 3]
target = [0, 0.5, 0]
projection = "perspective"
fov = 30
size = [640, 480]
samples = 9
exposure = -0.5
tone = "agx"
lights = [
    { direction = [0, 1, 0], intensity = 0.5, angle = 5 },
    { position = [1, 1, 1], color = [1, 0.5, 0.25], intensity = 2, radius = 0.25 },
]
light-angle = 10
ambient = "environment"
environment = "sky/noon.hdr"
transmission = 0.25
ior = 1.33
ambient-color = [0.1, 0.1, 0.2]
material = { base = [0.5, 0.6, 0.7], roughness = 0.25, metallic = 1, emission = [4, 0, 0.5] }
background = [0, 0, 1]
backend = "cpu"
sampling = "fast"
two-sided = true
max-memory = "512MiB"
viewer = { show = "error", second = "cone", second-show = "flip", divider = 0.25, swapped = true }
clip = "reversed"
near = 0.25
far = inf
"#;

#[test]
fn every_key_is_read() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("scene.toml");
    fs::write(&path, FULL).expect("a temporary file");
    let spec = read_scene(&path).expect("a proper scene");
    let settings = [("search.steps".to_owned(), 64.0), ("refine.steps".to_owned(), 6.0)];
    let surface = SurfaceSpec {
        object: None,
        volume: None,
        motif: None,
        axes: None,
        ramp: None,
        walls: None,
        base: None,
        height: Some(folder.path().join("maps/a.exr")),
        channel: Some("height".to_owned()),
        depth: Some(true),
        range: Some([236.0, 1076.5].into()),
        elevation: Some([-20.0, 500.0]),
        nodata: Some(-9999.0),
        unit: "cm,us-ft".parse().ok(),
        raw: "403x344,le".parse().ok(),
        fill: Some(true),
        holes: Some(true),
        wrap: Some(Wrap::Mirror),
        scale: Some(0.2),
        bias: Some(-0.1),
        exaggerate: Some(1.5),
        extinction: None,
        creases: Some(true),
        color: Some(PathBuf::from("/somewhere/b.png")),
        normal: Some(folder.path().join("c.png")),
        green: "-y".parse().ok(),
        textures: Some(folder.path().join("set")),
        udim: Some(1002),
        roughness: Some(folder.path().join("r.png")),
        metallic: Some(folder.path().join("m.png")),
        occlusion: Some(folder.path().join("o.png")),
        orm: Some(folder.path().join("orm.png")),
        mask_map: Some(folder.path().join("mask.png")),
        metallic_smoothness: Some(folder.path().join("ms.png")),
        glossiness: Some(folder.path().join("gloss.png")),
        emission: Some(folder.path().join("e.png")),
        mesh: Some(MeshChoice::File(folder.path().join("meshes/column.glb"))),
        project: Some(UvProjection::Box),
        mesh_up: Some(relief_io::Up::Z),
        tile: Some([8.0, 3.5]),
        tile_size: Some([50.0, 20.0]),
        position: Some([0.0, -0.5, 0.0]),
        rotation: Some([90.0, 0.0, 0.0]),
        mesh_scale: None,
        method: None,
        stages: stages([
            ("search", "linear"),
            ("refine", "binary"),
            ("shade", "metallic-roughness"),
            ("shadow", "soft"),
            ("shadow-search", "frustum"),
            ("ambient", "environment"),
        ]),
        set: settings.into_iter().collect(),
        material: Some(MaterialSpec {
            base: Some([0.5, 0.6, 0.7]),
            roughness: Some(0.25),
            metallic: Some(1.0),
            emission: Some([4.0, 0.0, 0.5]),
            ..MaterialSpec::default()
        }),
        transmission: Some(0.25),
        ior: Some(1.33),
        two_sided: Some(true),
    };
    assert!(surface.raw.is_some() && surface.unit.is_some() && surface.green.is_some());
    let expected = SceneSpec {
        surface,
        surfaces: Vec::new(),
        look: Some(Look::Plain),
        view: None,
        eye: Some([1.0, 2.0, 3.0]),
        target: Some([0.0, 0.5, 0.0]),
        projection: Some(ProjectionChoice::Perspective),
        fov: Some(30.0),
        view_height: None,
        clip: Some(Clip::Reversed),
        near: Some(0.25),
        far: Some(f64::INFINITY),
        size: Some([640, 480].into()),
        samples: Some(9),
        exposure: Some(-0.5),
        tone: Some(Tone::Agx),
        light: None,
        lights: Some(vec![
            LightSpec {
                direction: Some([0.0, 1.0, 0.0]),
                position: None,
                color: None,
                intensity: Some(0.5),
                angle: Some(5.0),
                radius: None,
            },
            LightSpec {
                direction: None,
                position: Some([1.0, 1.0, 1.0]),
                color: Some([1.0, 0.5, 0.25]),
                intensity: Some(2.0),
                angle: None,
                radius: Some(0.25),
            },
        ]),
        light_angle: Some(10.0),
        ambient_color: Some([0.1, 0.1, 0.2]),
        environment: Some(folder.path().join("sky/noon.hdr")),
        background: Some(Background::Color(Vec3::Z)),
        backend: Some(BackendChoice::Cpu),
        sampling: Some(Sampling::Fast),
        max_memory: Some(ByteSize(512 << 20)),
        viewer: ViewerSpec {
            show: Some(Shown::Error),
            second: Some("cone".into()),
            second_show: Some(Shown::Flip),
            divider: Some(0.25),
            swapped: Some(true),
        },
    };
    assert_eq!(spec, expected);
    assert_eq!(read("").expect("an empty scene"), SceneSpec::default());
}

#[test]
fn mistakes_in_a_file_are_reported_with_their_line() {
    // Each of these is wrong on its third line.
    let mistakes = [
        "mesh = 'shpere'",
        "wrap = 3",
        "fov = '40'",
        "eye = [1, 2]",
        "eye = [1, 2, '3 parsecs']",
        "scale = 'five'",
        "eye = [1, 2, 3, 4]",
        "lights = [{ position = [1, 2, 3, 4] }]",
        "material = { diffuse = [1, 1] }",
        "tile = [1, 2, 3]",
        "raw = '0x0'",
        "unit = 'kelvin'",
        "max-memory = -5",
        "lights = [{ direction = [1, 2, 3], colour = [1, 1, 1] }]",
        "size = [-1, 5]",
        "set.search = 5",
        "material = { shininess = 1.5 }",
        "= 5",
    ];
    for mistake in mistakes {
        let error = read(&format!("scale = 0.1\n\n{mistake}\n")).expect_err(mistake);
        assert!(matches!(error, SceneError::Toml { .. }), "{mistake}: {error:?}");
        assert!(error.to_string().contains("line 3"), "{mistake}: {error}");
    }
    let impossible = [
        ("fov = 180", "fov"),
        ("near = 0", "near"),
        ("near = 1e30", "near"),
        ("far = -1", "far"),
        ("far = nan", "far"),
        ("position = [0, 1e30, 0]", "position"),
        ("rotation = [0, nan, 0]", "rotation"),
        ("shade = 'blinn'", "shade"),
        ("eye = [0, 0, 0]", "eye"),
        ("target = [0.6, 0.9, 1.1]", "target"),
        ("scale = -1", "scale"),
        ("bias = nan", "bias"),
        ("range = [5, 5]", "range"),
        ("range = [-inf, 5]", "range"),
        ("nodata = nan", "nodata"),
        ("nodata = -inf", "nodata"),
        ("tile = [0, 1]", "tile"),
        ("tile-size = [0, 1]", "tile-size"),
        ("size = [0, 5]", "size"),
        ("size = [40000, 5]", "size"),
        ("light = [0, 0, 0]", "light"),
        ("lights = [{}]", "lights"),
        ("lights = [{ direction = [0, 1, 0], position = [0, 1, 0] }]", "lights"),
        ("lights = [{ direction = [0, 1, 0], intensity = -1 }]", "lights"),
        ("ambient = [0, nan, 0]", "ambient-color"),
        ("ambient-color = [0, -1, 0]", "ambient-color"),
        ("ambient = 'oclusion'", "ambient"),
        ("transmission = 1.5", "transmission"),
        ("transmission = nan", "transmission"),
        ("ior = 0.9", "ior"),
        ("ior = 2\nshade = 'blinn-phong'\nambient = 'occlusion'", "ior"),
        ("transmission = 1\nambient = 'constant'", "transmission"),
        ("environment = 'sky.exr'\nambient = 'bounce'", "environment"),
        ("set.ambient.intensity = -1\nambient = 'environment'", "set"),
        ("set.ambient.azimuths = 16\nambient = 'constant'", "set"),
        ("set.ambient.azimuths = 300\nambient = 'occlusion'", "set"),
        ("background = [0, -1, 0]", "background"),
        ("material = { diffuse = [2, 0, 0] }", "material"),
        ("material = { shininess = 0 }", "material"),
        ("search = 'linear'", "search"),
        ("refine = 'binary'", "refine"),
        ("set.search.steps = inf", "set"),
        ("method = 'relif'", "method"),
        ("search = 'lineer'\nrefine = 'none'", "search"),
        ("refine = 'nun'\nsearch = 'linear'", "refine"),
        ("set.search.stepz = 4", "set"),
        ("set.limit.search = 4", "set"),
        ("scale = 1e300", "scale"),
        ("bias = -1e10", "bias"),
        ("eye = [1e30, 0, 0]", "eye"),
        ("target = [0, nan, 0]", "target"),
        ("lights = [{ position = [0, 1e30, 0] }]", "lights"),
        ("lights = [{ position = [0, 1, 0], radius = -1 }]", "lights"),
        ("lights = [{ position = [0, 1, 0], radius = 1e30 }]", "lights"),
        ("lights = [{ position = [0, 1, 0], angle = 1 }]", "lights"),
        ("lights = [{ direction = [0, 1, 0], radius = 1 }]", "lights"),
        ("lights = [{ direction = [0, 1, 0], angle = 90.5 }]", "lights"),
        ("light-angle = -0.1", "light-angle"),
        ("light-angle = 91", "light-angle"),
        ("light-angle = nan", "light-angle"),
        ("light-angle = nan\nlights = []", "light-angle"),
        ("shadow-search = 'cone'\nshadow = 'horizon'", "shadow-search"),
        ("set.shadow-search.limit = 4\nshadow = 'none'", "set"),
        ("shadow-search = 'pyramid-texels'\ndetail = 'footprint'", "shadow-search"),
        ("set.detail.anisotropy = 0\ndetail = 'footprint'", "set"),
        ("set.shadow.samples = 4\nshadow = 'none'", "set"),
        ("shadow-search = 'relaxed-cone'\nshadow = 'ray'", "shadow-search"),
        ("tile = [1e30, 1]", "tile"),
        ("tile = [1, 1e-30]", "tile"),
    ];
    for (text, expected) in impossible {
        match read(&format!("# scene\n\n{text}\n")).expect_err(text) {
            SceneError::InFile { line, source, .. } => {
                assert_eq!((line, source.key), (3, expected), "{text}");
            }
            other => panic!("{text}: {other:?}"),
        }
    }
    let both = read("light = [0, 1, 0]\nlights = []").expect_err("one excludes the other");
    assert!(matches!(both, SceneError::InFile { .. }));
    let both =
        read("method = 'relief'\nsearch = 'linear'\nrefine = 'binary'").expect_err("one excludes the others");
    assert!(matches!(both, SceneError::InFile { .. }));
}

#[test]
fn unknown_keys_are_reported_with_their_line_and_the_nearest() {
    let cases = [
        ("\n\nheigth = 'x.png'", 3, "height"),
        ("\nbackgruond = [0, 0, 0]", 2, "background"),
        ("serach = 'cells'", 1, "search"),
        ("[[surfacs]]", 1, "surfaces"),
        ("[[surfaces]]\nmehs = 'cube'", 2, "mesh"),
        ("[[surfaces]]\n[[surfaces]]\neye = [0, 1, 0]", 3, "eye"),
        ("surfaces = 3", 1, "[[surfaces]]"),
        ("surfaces = [3]", 1, "[[surfaces]]"),
    ];
    for (text, expected, named) in cases {
        match read(text).expect_err(text) {
            SceneError::Key { line, what, .. } => {
                assert_eq!(line, expected, "{text}");
                assert!(what.contains(named), "{text}: {what}");
            }
            other => panic!("{text}: {other:?}"),
        }
    }
}

/// A scene of two surfaces that share what is said above them.
const TWO: &str = "
height = 'a.png'
scale = 0.1
size = [64, 48]
set.search.steps = 9
search = 'linear'
refine = 'binary'

[[surfaces]]
mesh = 'cube'
position = [1, 0, 0]
size = 0.5

[[surfaces]]
method = 'cone'
scale = 0.2
set.search.limit = 500
";

#[test]
fn surfaces_of_a_file_say_what_they_differ_in() {
    let spec = read(TWO).expect("a proper scene");
    assert_eq!((spec.surfaces.len(), spec.size), (2, Some([64, 48].into())));
    let [first, second] = &spec.each_surface()[..] else { panic!("two surfaces") };
    assert_eq!((first.height.as_ref(), first.scale), (second.height.as_ref(), Some(0.1)));
    assert_eq!((first.mesh.clone(), first.position), (Some(Builtin::Cube.into()), Some([1.0, 0.0, 0.0])));
    assert_eq!((first.mesh_scale, second.mesh_scale), (Some(0.5), None));
    // By either name; the scene's own size is the picture's.
    let newer = read(&TWO.replace("size = 0.5", "mesh-scale = 0.5")).expect("a proper scene");
    assert_eq!(newer.surfaces, spec.surfaces);
    let alone = read("height = 'a.png'\nmesh-scale = 3\nsize = [8, 8]\n").expect("a proper scene");
    assert_eq!((alone.surface.mesh_scale, alone.size), (Some(3.0), Some([8, 8].into())));
    assert!(read(&TWO.replace("size = 0.5", "mesh-scale = 0.5\nsize = 2")).is_err());
    assert_eq!(first.stages, stages([("search", "linear"), ("refine", "binary")]));
    assert_eq!((second.method.as_deref(), second.scale), (Some("cone"), Some(0.2)));
    assert!(second.stages.is_empty() && !second.set.contains_key("search.steps"));

    // What is said over a scene holds for each of its surfaces.
    let over = of(SurfaceSpec { method: Some("relief".into()), ..SurfaceSpec::default() });
    let both = spec.overridden_by(over).each_surface();
    assert!(both.iter().all(|surface| surface.method.as_deref() == Some("relief") && surface.set.is_empty()));
}

#[test]
fn mistakes_in_a_surface_are_reported_with_their_surface_and_line() {
    let mistakes = [
        ("[[surfaces]]\n[[surfaces]]\nscale = -1", 3, 1, "scale"),
        ("[[surfaces]]\nsize = 0", 2, 0, "mesh-scale"),
        ("[[surfaces]]\nscale = 1\nmesh-scale = 0", 3, 0, "mesh-scale"),
        // What is said of all is reported where it is said, and what is missing at the surface.
        ("scale = -1\n[[surfaces]]", 1, 0, "scale"),
        ("[[surfaces]]\nmethod = 'cone'\n[[surfaces]]\nsearch = 'cells'", 4, 1, "search"),
        ("[[surfaces]]\nset.search.stepz = 3", 2, 0, "set"),
    ];
    for (text, expected, number, key) in mistakes {
        match read(text).expect_err(text) {
            SceneError::InFile { line, source, .. } => {
                assert_eq!((line, source.surface, source.key), (expected, Some(number), key), "{text}");
            }
            other => panic!("{text}: {other:?}"),
        }
    }
    let error = read("[[surfaces]]\n\nmesh = 'shpere'").expect_err("no such mesh");
    assert!(matches!(error, SceneError::Toml { .. }) && error.to_string().contains("line 3"), "{error}");
}

#[test]
fn files_that_are_no_scene_are_refused() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("scene.toml");
    assert!(matches!(read_scene(&path), Err(SceneError::Io { .. })), "absent");
    assert!(matches!(read_scene(folder.path()), Err(SceneError::Io { .. })), "a folder");
    fs::write(&path, [0xff, 0xfe, 0x00]).expect("a temporary file");
    assert!(matches!(read_scene(&path), Err(SceneError::Io { .. })), "not text");
    fs::write(&path, "#".repeat(2 << 20)).expect("a temporary file");
    assert!(matches!(read_scene(&path), Err(SceneError::Io { .. })), "too long");
}

#[test]
fn ambient_light_is_a_name_or_a_colour() {
    let color = read("ambient = [0.1, 0.2, 0.3]").expect("a colour");
    assert_eq!((color.ambient_color, color.surface.stages.len()), (Some([0.1, 0.2, 0.3]), 1));
    assert_eq!(color.surface.stages["ambient"], "constant");
    let seen = read("ambient = [0.1, 0.2, 0.3]\nenvironment = 'sky.hdr'").expect("surroundings");
    assert_eq!((seen.ambient_color, seen.surface.stages.len()), (color.ambient_color, 0));
    let both = read("ambient = 'occlusion'\nambient-color = [0.1, 0.2, 0.3]").expect("a name and a colour");
    assert_eq!((both.ambient_color, both.surface.stages.len()), (color.ambient_color, 1));
    assert_eq!(read(&both.to_toml()).expect("what was written"), both);
    let error = read("ambient = [0, 0, 0]\nambient-color = [0, 0, 0]").expect_err("two colours");
    assert!(error.to_string().contains("ambient-color"), "{error}");
    assert!(read("[[surfaces]]\nambient = [0, 0, 0]").is_err());
}

#[test]
fn the_builder_refuses_what_is_impossible() {
    let key = |builder: SceneBuilder| builder.build().expect_err("an impossible scene").key;
    assert_eq!(key(Scene::builder(flat()).size(0, 1)), "size");
    assert_eq!(key(Scene::builder(flat()).ambient(Vec3::splat(-1.0))), "ambient-color");
    assert_eq!(key(Scene::builder(flat()).environment(Environment::sky())), "environment");
    let glass = Material::default().with_transmission(1.0, 1.5).expect("a material");
    assert_eq!(key(Scene::builder(flat().with_material(glass))), "transmission");
    assert_eq!(key(Scene::builder(flat()).background(Vec3::NAN)), "background");
    let light = Light::directional(DVec3::Y, Vec3::ONE).expect("a proper light");
    assert_eq!(key(Scene::builder(flat()).lights(vec![light; MAX_LIGHTS + 1])), "lights");
    assert!(Scene::builder(flat()).lights(vec![]).build().is_ok());
    assert_eq!(key(Scene::builder(flat()).surfaces(vec![])), "surfaces");
}

proptest! {
    #[test]
    fn no_text_makes_reading_panic(text in "[a-z-]{0,8} ?= ?[\\[\\]{}\"0-9a-z., -]{0,30}\n?[\\PC\n]{0,60}") {
        let _ = read(&text);
    }

    #[test]
    fn overriding_twice_is_overriding_by_both(
        a in any::<(Option<bool>, Option<u8>)>(),
        b in any::<(Option<bool>, Option<u8>)>(),
        c in any::<(Option<bool>, Option<u8>)>(),
    ) {
        let spec = |(two_sided, number): (Option<bool>, Option<u8>)| {
            let method = number.map(|number| number.to_string());
            let surface = SurfaceSpec { two_sided, method, ..SurfaceSpec::default() };
            SceneSpec { fov: number.map(f64::from), ..of(surface) }
        };
        let stepwise = spec(a).overridden_by(spec(b)).overridden_by(spec(c));
        prop_assert_eq!(stepwise, spec(a).overridden_by(spec(b).overridden_by(spec(c))));
    }
}
