//! Kinds of files that can be shown, by content and name.

use std::path::Path;

use relief_io::{Files, Format, MeshFormat};

/// Bytes at the start of a file that decide its kind: an object's first tables.
const START_BYTES: u64 = 1 << 16;

/// Name of a depth object's description.
const OBJECT: &str = "object.toml";

/// Kind of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    Scene,
    Object,
    Volume,
    Mesh,
    Picture,
}

impl Kind {
    /// Returns the kind of a file that can be shown.
    pub fn of(file: &Path, files: &Files) -> Option<Self> {
        if MeshFormat::by_name(file).is_some() {
            return Some(Self::Mesh);
        }
        let ending = file.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        if ending == "ktx2" {
            return Some(Self::Volume);
        }
        let start = files.source(file).start(START_BYTES).unwrap_or_default();
        if Format::by_signature(&start).is_some() || Format::by_name(file).is_some() {
            return Some(Self::Picture);
        }
        if ending != "toml" || start.contains(&0) {
            return None;
        }
        let has_views = String::from_utf8_lossy(&start).lines().any(|line| line.trim() == "[[view]]");
        let is_object = has_views || file.file_name().is_some_and(|name| name == OBJECT);
        Some(if is_object { Self::Object } else { Self::Scene })
    }

    pub const fn name(self) -> &'static str {
        match self {
            Self::Scene => "scene",
            Self::Object => "depth object",
            Self::Volume => "volume",
            Self::Mesh => "mesh",
            Self::Picture => "picture",
        }
    }
}
