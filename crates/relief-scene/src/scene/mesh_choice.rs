//! Base meshes by name or by file.

use relief_core::mesh::Builtin;
use relief_core::registry::UnknownName;
use relief_io::MeshFormat;
use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;

/// Base mesh of a surface: a built-in one by name, or a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MeshChoice {
    /// Built-in mesh.
    Builtin(Builtin),
    /// Path of a mesh file. Its name ends in `.gltf`, `.glb`, `.obj`, `.ply` or `.stl`.
    File(PathBuf),
}

/// Error for a text that is neither a built-in mesh nor the name of a mesh file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}; mesh files end in .gltf, .glb, .obj, .ply or .stl")]
pub struct UnknownMesh(UnknownName);

impl Default for MeshChoice {
    fn default() -> Self {
        MeshChoice::Builtin(Builtin::default())
    }
}

impl From<Builtin> for MeshChoice {
    fn from(builtin: Builtin) -> Self {
        MeshChoice::Builtin(builtin)
    }
}

impl fmt::Display for MeshChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MeshChoice::Builtin(builtin) => builtin.fmt(f),
            MeshChoice::File(path) => path.display().fmt(f),
        }
    }
}

impl FromStr for MeshChoice {
    type Err = UnknownMesh;

    fn from_str(text: &str) -> Result<Self, UnknownMesh> {
        let path = PathBuf::from(text);
        if MeshFormat::by_name(&path).is_some() {
            return Ok(MeshChoice::File(path));
        }
        text.parse().map(MeshChoice::Builtin).map_err(UnknownMesh)
    }
}
