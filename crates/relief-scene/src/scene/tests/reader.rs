//! Scenes loaded one after the other.

use super::*;
use crate::SceneReader;

fn spec(text: &str) -> SceneSpec {
    let height = format!("height = {:?}\n", shipped("data/noise.png").display().to_string());
    parse_scene(&format!("{height}{text}"), Path::new("")).expect("a scene")
}

/// Changes of camera, light and picture, and changes of surfaces.
const CHANGES: [&str; 14] = [
    "eye = [1, 1, 0.2]\n",
    "view = \"top\"\nprojection = \"orthographic\"\n",
    "view = \"top\"\nprojection = \"orthographic\"\nsize = \"map\"\n",
    "size = [40, 30]\nsamples = 1\n",
    "light = [0, 1, 0.2]\nexposure = -1\ntone = \"none\"\n",
    "background = \"environment\"\nambient-color = [0.1, 0.2, 0.3]\n",
    "look = \"sun\"\n",
    "shadow = \"map\"\nsize = [1600, 20]\n",
    "shadow = \"map\"\nsize = [32, 20]\n",
    "method = \"cone\"\n",
    "scale = 0.1\n",
    "walls = true\n",
    "walls = true\nsamples = 1\n",
    "mesh = \"sphere\"\nambient = \"environment\"\n",
];

#[test]
fn scenes_are_the_same_as_loaded_alone() {
    let mut reader = SceneReader::default();
    for before in CHANGES {
        for after in CHANGES {
            reader.load(&spec(before)).expect("a scene");
            let (again, alone) = (reader.load(&spec(after)), spec(after).load());
            let text = |scene: Result<Scene, SceneError>| {
                // What maps need of the memory is known of those that were read alone.
                let scene = Scene { geometry_memory: ByteSize(0), ..scene.expect("a scene") };
                format!("{scene:?}")
            };
            assert!(text(again) == text(alone), "{after} after {before}");
        }
    }
}

#[test]
fn what_the_camera_sees_is_not_read_again() {
    let mut reader = SceneReader::default();
    let first = reader.load(&spec("")).expect("a scene");
    let map = |scene: &Scene| Arc::clone(scene.surfaces()[0].height_map());
    for same in [CHANGES[0], CHANGES[3], CHANGES[4]] {
        assert!(Arc::ptr_eq(&map(&first), &map(&reader.load(&spec(same)).expect("a scene"))), "{same}");
    }
    for other in [CHANGES[9], CHANGES[10], CHANGES[13]] {
        assert!(!Arc::ptr_eq(&map(&first), &map(&reader.load(&spec(other)).expect("a scene"))), "{other}");
    }
}

#[test]
fn a_file_that_changed_is_read_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("map.png");
    let copy = |name: &str| fs::copy(shipped(name), &path).expect("a copy");
    copy("data/noise.png");
    let spec = of(SurfaceSpec { height: Some(path.clone()), ..SurfaceSpec::default() });
    let mut reader = SceneReader::default();
    assert_eq!(reader.load(&spec).expect("a scene").surfaces()[0].height_map().width(), 128);
    copy("data/bricks.png");
    assert_eq!(reader.load(&spec).expect("a scene").surfaces()[0].height_map().width(), 256);
    fs::remove_file(&path).expect("removable");
    assert!(reader.load(&spec).is_err());
    // An error forgets nothing.
    copy("data/noise.png");
    assert_eq!(reader.load(&spec).expect("a scene").surfaces()[0].height_map().width(), 128);
}

#[test]
fn all_files_of_a_scene_are_named() {
    let text = "height = \"a.png\"\nenvironment = \"sky.hdr\"\n[[surfaces]]\nmesh = \"b.obj\"\n[[surfaces]]\n\
                color = \"c.png\"\n";
    let mut scene = parse_scene(text, Path::new("/there/scene.toml")).expect("a scene");
    scene.files_mut().for_each(|file| file.push("x"));
    let named: BTreeSet<&Path> = scene.files().map(PathBuf::as_path).collect();
    let expected =
        ["a.png", "sky.hdr", "b.obj", "c.png"].map(|name| Path::new("/there").join(name).join("x"));
    assert_eq!(named, expected.iter().map(PathBuf::as_path).collect());
}
