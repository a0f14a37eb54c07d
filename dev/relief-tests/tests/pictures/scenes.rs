//! Every scene that is shipped is read, from disk and from memory, and shows all of its surfaces.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use relief_core::Watch;
use relief_io::{Files, MemoryFiles};
use relief_maps::Maps;
use relief_render::render;
use relief_scene::{BackendChoice, SceneSpec, read_scene};

/// All files in a folder and in the folders within it, in the order of their names.
fn files_in(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    paths.into_iter().flat_map(|path| if path.is_dir() { files_in(&path) } else { vec![path] }).collect()
}

/// All scene files that are shipped.
fn scenes(root: &Path) -> Vec<PathBuf> {
    let mut scenes = files_in(&root.join("scenes"));
    scenes.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    scenes
}

#[test]
fn shipped_scenes_are_the_same_in_memory() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut memory = MemoryFiles::new();
    for path in ["scenes", "data"].iter().flat_map(|folder| files_in(&root.join(folder))) {
        let name = path.strip_prefix(&root).expect("inside");
        memory.insert(name, std::fs::read(&path).expect("a file")).expect("a path");
    }
    let files = Files::Memory(memory);
    let from_root = format!("{}/", root.display());
    for path in scenes(&root) {
        let on_disk = read_scene(&path).and_then(|spec| spec.load()).expect("a shipped scene");
        let name = path.strip_prefix(&root).expect("inside");
        let here = read_scene(files.source(name)).and_then(|spec| spec.load_from(&files)).expect("the same");
        assert!(format!("{on_disk:?}").replace(&from_root, "") == format!("{here:?}"), "{}", name.display());
    }
}

#[test]
fn shipped_scenes_show_all_of_their_surfaces() {
    let scenes = scenes(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."));
    assert!(scenes.len() > 10, "{}", scenes.len());
    for path in scenes {
        let small = SceneSpec {
            backend: Some(BackendChoice::Cpu),
            size: Some([80, 60].into()),
            samples: Some(1),
            ..SceneSpec::default()
        };
        let scene = read_scene(&path).expect("a shipped scene").overridden_by(small);
        let scene = scene.load().expect("shipped maps and meshes");
        let made = render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture");
        let pixels = &made.rendering.pixels;
        let seen: BTreeSet<u32> =
            pixels.iter().filter(|pixel| pixel.hit == 1).map(|pixel| pixel.surface).collect();
        let all = (0..scene.surfaces().len() as u32).collect();
        assert_eq!(seen, all, "{}", path.display());
    }
}
