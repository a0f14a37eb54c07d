//! What a file is that is to be shown: a scene, an object, a height map or a mesh.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use relief_io::{Format, MeshFormat};

use crate::failure::Failure;

/// What a file holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileKind {
    /// A scene file.
    Scene,
    /// The description of an object of images.
    Object,
    /// A picture, whose values are heights.
    HeightMap,
    /// A mesh.
    Mesh,
}

/// How much of a file is looked at: a scene's first tables.
const LOOKED_AT: u64 = 1 << 16;

/// Endings of height maps' names, for names that stand for several files.
const ENDINGS_OF_MAPS: [&str; 13] =
    ["png", "jpg", "jpeg", "exr", "tif", "tiff", "hdr", "pgm", "ppm", "pnm", "raw", "r16", "bin"];

/// The name that objects of images have.
const OBJECT: &str = "object.toml";

impl FileKind {
    /// What a file holds, by its content; of a mesh, and of a file that is not there, by its name.
    ///
    /// # Errors
    ///
    /// When the file cannot be read.
    pub fn of(path: &Path) -> Result<Self, Failure> {
        if MeshFormat::by_name(path).is_some() {
            return Ok(FileKind::Mesh);
        }
        if !path.exists() {
            return Ok(Self::by_name(path));
        }
        let mut start = Vec::new();
        let read = File::open(path).and_then(|file| file.take(LOOKED_AT).read_to_end(&mut start));
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
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        match ending {
            Some(ending) if ENDINGS_OF_MAPS.contains(&ending.as_str()) => FileKind::HeightMap,
            _ if path.file_name().is_some_and(|name| name == OBJECT) => FileKind::Object,
            _ => FileKind::Scene,
        }
    }

    /// The flag that names such a file.
    pub const fn flag(self) -> &'static str {
        match self {
            FileKind::Scene => "scene",
            FileKind::Object => "--object",
            FileKind::HeightMap => "--height",
            FileKind::Mesh => "--mesh",
        }
    }
}
