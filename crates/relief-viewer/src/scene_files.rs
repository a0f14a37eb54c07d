//! The files that a dropped scene names, among the files that were dropped with it.

use std::collections::BTreeSet;
use std::path::{Component, Path, PathBuf};

use relief_io::Files;
use relief_scene::{SceneSpec, read_scene};

use crate::coming::name_of;
use crate::given::GivenError;

/// Reads a scene. Its files are found where it says, or else by their names.
pub fn scene_among(
    scene: &Path,
    root: &Path,
    given: &[PathBuf],
    files: &Files,
) -> Result<SceneSpec, GivenError> {
    let mut spec = read_scene(files.source(scene))?;
    let parents = given.iter().flat_map(|file| file.ancestors().skip(1).take_while(|folder| *folder != root));
    let there: BTreeSet<&Path> = given.iter().map(PathBuf::as_path).chain(parents).collect();
    for file in spec.files_mut() {
        // Whether another path may be read is checked with all that was given.
        if !file.starts_with(root) {
            continue;
        }
        let path = plain(file);
        if path == root || there.contains(&*path) {
            *file = path;
            continue;
        }
        let (name, folder) = (name_of(file), scene.parent().unwrap_or(root));
        let written = file.strip_prefix(folder).unwrap_or(file).display().to_string();
        let mut same = there.iter().filter(|other| name_of(other) == name);
        *file = match (same.next(), same.next()) {
            (Some(found), None) => found.to_path_buf(),
            (None, _) => {
                let what = format!("{} names {written}, which did not come with it", name_of(scene));
                return Err(GivenError::Files(format!("{what}: drop the folder that holds both")));
            }
            (Some(_), Some(_)) => {
                let what = format!("{} names {written}, and several files are called {name}", name_of(scene));
                let said = format!("{what}: drop the folder that holds the scene and its files");
                return Err(GivenError::Files(said));
            }
        };
    }
    Ok(spec)
}

/// A path without `..`.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => drop(plain.pop()),
            part => plain.push(part),
        }
    }
    plain
}
