//! Kind of a file that is to be shown: a scene, a depth object, a height map or a mesh.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use relief_io::{Format, MeshFormat};

use crate::failure::Failure;

/// Kind of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// A scene file.
    Scene,
    /// Description of a depth object.
    Object,
    /// Picture whose values are heights.
    HeightMap,
    /// A volume.
    Volume,
    /// A mesh.
    Mesh,
    /// A folder with the maps of a material.
    Textures,
}

/// Bytes at the start of a file that decide its kind: a scene's first tables.
const START_BYTES: u64 = 1 << 16;

/// Name of a depth object's description.
const OBJECT: &str = "object.toml";

/// Whether a file is named as a volume.
pub fn is_volume(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("ktx2"))
}

impl FileKind {
    /// Returns the kind of a file by its content. The kind of a mesh, or of a missing file, follows
    /// from its name.
    ///
    /// # Errors
    ///
    /// When the file cannot be read.
    pub fn of(path: &Path) -> Result<Self, Failure> {
        if MeshFormat::by_name(path).is_some() {
            return Ok(FileKind::Mesh);
        }
        if is_volume(path) {
            return Ok(FileKind::Volume);
        }
        if !path.exists() {
            return Ok(Self::by_name(path));
        }
        if path.is_dir() {
            return Ok(if path.join(OBJECT).is_file() { FileKind::Object } else { FileKind::Textures });
        }
        let mut start = Vec::new();
        let read = File::open(path).and_then(|file| file.take(START_BYTES).read_to_end(&mut start));
        read.map_err(|error| Failure::Work(format!("{}: cannot be read: {error}", path.display())))?;
        if Format::by_signature(&start).is_some() {
            return Ok(FileKind::HeightMap);
        }
        let is_text = !start.contains(&0) && path.extension().is_some_and(|ending| ending == "toml");
        let has_views = || String::from_utf8_lossy(&start).lines().any(|line| line.trim() == "[[view]]");
        if is_text && has_views() {
            return Ok(FileKind::Object);
        }
        Ok(Self::by_name(path))
    }

    fn by_name(path: &Path) -> Self {
        match Format::by_name(path) {
            Some(_) => FileKind::HeightMap,
            None if path.file_name().is_some_and(|name| name == OBJECT) => FileKind::Object,
            None => FileKind::Scene,
        }
    }

    /// Returns the file that describes the object at a path: the path, or in a folder the one with the
    /// name of all of them.
    pub fn object_at(path: &Path) -> PathBuf {
        if path.is_dir() { path.join(OBJECT) } else { path.to_owned() }
    }

    /// Returns the flag that names such a file.
    pub const fn flag(self) -> &'static str {
        match self {
            FileKind::Scene => "scene",
            FileKind::Object => "--object",
            FileKind::HeightMap => "--height",
            FileKind::Volume => "--volume",
            FileKind::Mesh => "--mesh",
            FileKind::Textures => "--textures",
        }
    }
}
