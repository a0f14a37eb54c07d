//! Scenes with files that came in are loaded before they are taken: what cannot be used leaves the scene as it was.

use std::path::{Path, PathBuf};

use relief_scene::{SceneError, SceneSpec};
use relief_viewer::Drawing;

use super::said;

/// Says why a scene with files of a folder is not taken in place of the one before.
///
/// It is not where one of the files cannot be used, or where the scene before could be drawn and this one cannot.
/// What is wrong already with the scene before speaks against no file.
pub fn check(
    drawing: &mut Drawing,
    before: &SceneSpec,
    after: &SceneSpec,
    folder: &Path,
    stand_in: &Path,
) -> Result<(), String> {
    let Err(error) = drawing.load(after) else { return Ok(()) };
    let is_of_files = |error: &SceneError| error.to_string().contains(&folder.display().to_string());
    if is_of_files(&error) || drawing.load(before).is_ok() {
        return Err(said::of_scene(&error));
    }
    if !matches!(error, SceneError::NoHeightMap(_)) {
        return Ok(());
    }
    // Without heights no file is read.
    match drawing.load(&with_heights(after, stand_in)) {
        Err(error) if is_of_files(&error) => Err(said::of_scene(&error)),
        _ => Ok(()),
    }
}

/// A scene whose surfaces have heights of some file, where they have none of their own.
fn with_heights(spec: &SceneSpec, heights: &Path) -> SceneSpec {
    let mut spec = spec.clone();
    spec.surface.height.get_or_insert_with(|| PathBuf::from(heights));
    spec
}
