//! Files of a scene whose names have a placeholder for the frame number.

use std::path::{Path, PathBuf};

use relief_scene::{MeshChoice, SceneSpec};

use crate::failure::Failure;
use crate::pattern::{Pattern, has_placeholder};
use crate::streams::is_input;

/// Numbering of names. Names in a scene file count from its folder on, whose own name is no
/// pattern.
pub struct Numbering<'a> {
    folder: &'a Path,
}

impl<'a> Numbering<'a> {
    /// Creates the numbering of names in the scene file `scene` and of flags.
    pub fn of(scene: Option<&'a Path>) -> Self {
        Self { folder: scene.and_then(Path::parent).unwrap_or(Path::new("")) }
    }

    /// Returns the folder before a name, and the part that may be a pattern; none if the name is
    /// not Unicode or is standard input.
    fn parts<'b>(&self, path: &'b Path) -> Option<(&Path, &'b str)> {
        if is_input(path) {
            return None;
        }
        match path.strip_prefix(self.folder) {
            Ok(rest) => Some((self.folder, rest.to_str()?)),
            Err(_) => Some((Path::new(""), path.to_str()?)),
        }
    }

    /// Whether a name has a placeholder for a number.
    pub fn is_pattern(&self, path: &Path) -> bool {
        self.parts(path).is_some_and(|(_, name)| has_placeholder(name))
    }

    /// Returns the name in a frame.
    pub fn path(&self, path: &Path, frame: u32) -> Result<PathBuf, Failure> {
        let Some((folder, name)) = self.parts(path) else { return Ok(path.to_owned()) };
        if !name.contains('%') {
            return Ok(path.to_owned());
        }
        let pattern = Pattern::parse(name);
        let pattern = pattern.map_err(|error| Failure::Usage(format!("{}: {error}", path.display())))?;
        Ok(folder.join(pattern.with(frame)))
    }

    /// Returns the scene in a frame.
    pub fn spec(&self, spec: &SceneSpec, frame: u32) -> Result<SceneSpec, Failure> {
        let mut spec = spec.clone();
        for file in spec.files_mut() {
            *file = self.path(file, frame)?;
        }
        Ok(spec)
    }

    /// Whether a file of the scene differs from frame to frame.
    pub fn has_frames(&self, spec: &SceneSpec) -> bool {
        files(spec).iter().any(|file| self.is_pattern(file))
    }

    /// Whether a mesh, whose file may name others, differs from frame to frame.
    pub fn has_frames_of_meshes(&self, spec: &SceneSpec) -> bool {
        spec.each_surface().iter().any(|surface| match &surface.mesh {
            Some(MeshChoice::File(path)) => self.is_pattern(path),
            _ => false,
        })
    }

    /// Refuses a scene with frames; `advice` says what to do.
    pub fn refuse(&self, spec: &SceneSpec, advice: &str) -> Result<(), Failure> {
        match files(spec).iter().find(|file| self.is_pattern(file)) {
            Some(file) => {
                let file = file.display();
                Err(Failure::Usage(format!(
                    "{file}: the name has a placeholder for a frame number: {advice}"
                )))
            }
            None => Ok(()),
        }
    }
}

/// Advice of commands that show no frames.
pub const ONE_FRAME: &str = "name the file of one frame, since only `relief render --frames` renders several";

/// Returns the files that a scene names.
pub fn files(spec: &SceneSpec) -> Vec<PathBuf> {
    let surfaces = spec.each_surface();
    surfaces.iter().flat_map(|surface| surface.files()).chain(&spec.environment).cloned().collect()
}
