//! The files of a scene whose names have a place for a frame's number.

use std::path::{Path, PathBuf};

use relief_scene::{MeshChoice, SceneSpec};

use crate::failure::Failure;
use crate::pattern::{Pattern, has_place};
use crate::streams::is_input;

/// How names are numbered: those of a scene file from its own folder on, whose name is no pattern.
pub struct Numbering<'a> {
    folder: &'a Path,
}

impl<'a> Numbering<'a> {
    /// Of names in that scene file, and of flags.
    pub fn of(scene: Option<&'a Path>) -> Self {
        Self { folder: scene.and_then(Path::parent).unwrap_or(Path::new("")) }
    }

    /// The part of a name that may be a pattern, and the folder before it; none of what is
    /// no text or no name.
    fn parts<'b>(&self, path: &'b Path) -> Option<(&Path, &'b str)> {
        if is_input(path) {
            return None;
        }
        match path.strip_prefix(self.folder) {
            Ok(rest) => Some((self.folder, rest.to_str()?)),
            Err(_) => Some((Path::new(""), path.to_str()?)),
        }
    }

    /// Whether a name has a place for a number.
    pub fn is_pattern(&self, path: &Path) -> bool {
        self.parts(path).is_some_and(|(_, name)| has_place(name))
    }

    /// The name in a frame.
    pub fn path(&self, path: &Path, frame: u32) -> Result<PathBuf, Failure> {
        let Some((folder, name)) = self.parts(path) else { return Ok(path.to_owned()) };
        if !name.contains('%') {
            return Ok(path.to_owned());
        }
        let pattern = Pattern::parse(name);
        let pattern = pattern.map_err(|error| Failure::Usage(format!("{}: {error}", path.display())))?;
        Ok(folder.join(pattern.with(frame)))
    }

    /// The scene in a frame.
    pub fn spec(&self, spec: &SceneSpec, frame: u32) -> Result<SceneSpec, Failure> {
        let mut spec = spec.clone();
        let surfaces = spec.surfaces.iter_mut().chain([&mut spec.surface]);
        for file in surfaces.flat_map(|surface| surface.files_mut()).chain(&mut spec.environment) {
            *file = self.path(file, frame)?;
        }
        Ok(spec)
    }

    /// Whether a file of the scene is another in each frame.
    pub fn has_frames(&self, spec: &SceneSpec) -> bool {
        files(spec).iter().any(|file| self.is_pattern(file))
    }

    /// Whether that is a mesh, whose file may name others.
    pub fn has_frames_of_meshes(&self, spec: &SceneSpec) -> bool {
        spec.each_surface().iter().any(|surface| match &surface.mesh {
            Some(MeshChoice::File(path)) => self.is_pattern(path),
            _ => false,
        })
    }

    /// Refuses a scene with frames, and says what to do.
    pub fn refuse(&self, spec: &SceneSpec, advice: &str) -> Result<(), Failure> {
        match files(spec).iter().find(|file| self.is_pattern(file)) {
            Some(file) => {
                let file = file.display();
                Err(Failure::Usage(format!("{file}: its name has a place for a frame's number: {advice}")))
            }
            None => Ok(()),
        }
    }
}

/// What to do where a command shows no frames.
pub const ONE_FRAME: &str = "name the file of one frame, as `relief render --frames` alone shows several";

/// The files that a scene names.
pub fn files(spec: &SceneSpec) -> Vec<PathBuf> {
    let surfaces = spec.each_surface();
    surfaces.iter().flat_map(|surface| surface.files()).chain(&spec.environment).cloned().collect()
}
