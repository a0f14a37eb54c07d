//! Scenes with files that came in are loaded before they are taken: what cannot be used leaves the scene as
//! it was.

use std::path::{Path, PathBuf};

use relief_scene::{SceneError, SceneSpec};
use relief_session::Taken;

use crate::coming::Coming;
use crate::{Drawing, shown};

impl Coming {
    /// Loads the document with the files, in a pane of this size. A reset goes back to it where it could not
    /// go back to the one before with them. `stand_in` is a height map for scenes that have none yet.
    ///
    /// # Errors
    ///
    /// When one of the files cannot be used, or where the scene before could be drawn and this one cannot.
    /// What is wrong already with the scene before speaks against no file.
    pub fn tried(
        &self,
        taken: Taken,
        before: &SceneSpec,
        pane: [u32; 2],
        drawing: &mut Drawing,
        stand_in: &Path,
    ) -> Result<Taken, SceneError> {
        let before = shown(before, pane);
        let mut check =
            |after: &SceneSpec| check(drawing, &before, &shown(after, pane), self.folder(), stand_in);
        let starts = taken.start == taken.document || check(&taken.start).is_ok();
        check(&taken.document)?;
        Ok(if starts { taken } else { Taken { start: taken.document.clone(), ..taken } })
    }
}

fn check(
    drawing: &mut Drawing,
    before: &SceneSpec,
    after: &SceneSpec,
    folder: &Path,
    stand_in: &Path,
) -> Result<(), SceneError> {
    let Err(error) = drawing.load(after) else { return Ok(()) };
    let is_of_files = |error: &SceneError| error.to_string().contains(&folder.display().to_string());
    if is_of_files(&error) || drawing.load(before).is_ok() {
        return Err(error);
    }
    if !matches!(error, SceneError::NoHeightMap(_)) {
        return Ok(());
    }
    // Without heights no file is read.
    match drawing.load(&with_heights(after, stand_in)) {
        Err(error) if is_of_files(&error) => Err(error),
        _ => Ok(()),
    }
}

/// A scene whose surfaces have heights of some file, where they have none of their own.
fn with_heights(spec: &SceneSpec, heights: &Path) -> SceneSpec {
    let mut spec = spec.clone();
    spec.surface.height.get_or_insert_with(|| PathBuf::from(heights));
    spec
}
