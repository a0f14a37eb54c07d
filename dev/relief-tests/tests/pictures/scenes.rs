//! Every scene that is shipped is read, and shows all of its surfaces.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use relief_core::Watch;
use relief_maps::Maps;
use relief_render::render;
use relief_scene::{BackendChoice, SceneSpec, read_scene};

/// All scene files in a folder and in those within it, in the order of their names.
fn scenes_in(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("a folder");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    let scenes = paths.into_iter().flat_map(|path| if path.is_dir() { scenes_in(&path) } else { vec![path] });
    scenes.filter(|path| path.extension().is_some_and(|ending| ending == "toml")).collect()
}

#[test]
fn shipped_scenes_show_all_of_their_surfaces() {
    let scenes = scenes_in(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes"));
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
