//! Keys of a surface in the file of its mesh: `relief` in the extras of a glTF's material.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use relief_core::registry::UnknownName;
use relief_io::{beside_file, read_mesh_extras};
use relief_shaders::STAGES;
use serde::Deserialize;
use serde_json::{Map, Value};

use super::keys::keys_of;
use super::{DEFAULT_MAX_MEMORY, MeshChoice, SceneError, SceneSpec, SurfaceSpec};

/// The name of the extras.
const EXTRAS: &str = "relief";

/// The key that the extras cannot have: they are the mesh's own.
const MESH: &str = "mesh";

impl SceneSpec {
    /// This description with what the files of its meshes say of their surfaces, where it says nothing
    /// itself.
    ///
    /// A glTF says it by an object `relief` in the `extras` of the only material of its triangles, or of all
    /// of these alike: with the keys of a surface in a scene file but `mesh`, and files by paths from its own
    /// folder on, in which they lie. [`Self::load`] does this by itself.
    ///
    /// # Errors
    ///
    /// When such a file cannot be read, or has keys or values there that cannot be used.
    pub fn with_keys_of_meshes(&self) -> Result<SceneSpec, SceneError> {
        let limit = self.max_memory.unwrap_or(DEFAULT_MAX_MEMORY).0;
        let mut known: BTreeMap<PathBuf, Option<SurfaceSpec>> = BTreeMap::new();
        let mut each = Vec::new();
        for surface in self.each_surface() {
            let of_mesh = match &surface.mesh {
                Some(MeshChoice::File(path)) => match known.get(path) {
                    Some(of_mesh) => of_mesh.clone(),
                    None => {
                        let of_mesh = keys_of_mesh(path, limit)?;
                        known.insert(path.clone(), of_mesh.clone());
                        of_mesh
                    }
                },
                _ => None,
            };
            each.push(match of_mesh {
                Some(of_mesh) => over(of_mesh, surface),
                None => surface,
            });
        }
        let spec = self.clone();
        Ok(if self.surfaces.is_empty() {
            SceneSpec { surface: each.pop().unwrap_or_default(), ..spec }
        } else {
            SceneSpec { surface: SurfaceSpec::default(), surfaces: each, ..spec }
        })
    }
}

/// Returns the keys of a mesh's file, overridden by the keys of a surface on it.
fn over(of_mesh: SurfaceSpec, mut surface: SurfaceSpec) -> SurfaceSpec {
    // The keys are of this very mesh: it is no other one, which would drop some.
    let mesh = surface.mesh.take();
    SurfaceSpec { mesh, ..of_mesh.overridden_by(surface) }
}

/// The keys of a mesh's file, checked.
fn keys_of_mesh(path: &Path, limit: u64) -> Result<Option<SurfaceSpec>, SceneError> {
    let Some(text) = read_mesh_extras(path, EXTRAS, limit).map_err(SceneError::Mesh)? else {
        return Ok(None);
    };
    let wrong = |what: String| SceneError::MeshKeys { path: path.to_owned(), what };
    let mut surface = parse(&text).map_err(wrong)?;
    for file in surface.files_mut() {
        *file = beside_file(path, file).map_err(SceneError::Mesh)?;
    }
    let alone = SurfaceSpec { mesh: Some(MeshChoice::File(path.to_owned())), ..surface.clone() };
    SceneSpec::of_surface(alone).check().map_err(|error| wrong(error.to_string()))?;
    Ok(Some(surface))
}

/// A surface of a JSON text; or what is wrong with it.
fn parse(text: &str) -> Result<SurfaceSpec, String> {
    let all: Map<String, Value> = serde_json::from_str(text).map_err(|error| error.to_string())?;
    let is_of_stage = |key: &str| relief_shaders::stage(key).is_some();
    let (stages, rest): (Map<_, _>, Map<_, _>) = all.into_iter().partition(|(key, _)| is_of_stage(key));
    let known = || keys_of::<SurfaceSpec>().iter().copied().filter(|key| *key != MESH);
    // Key by key, so that it is known which is wrong.
    for (key, value) in &rest {
        if !known().any(|known| known == key) {
            let keys = known().chain(STAGES.iter().map(|stage| stage.key));
            return Err(UnknownName::new("key", key, keys).to_string());
        }
        let one = Map::from_iter([(key.clone(), value.clone())]);
        SurfaceSpec::deserialize(Value::Object(one)).map_err(|error| format!("{key}: {error}"))?;
    }
    let surface = SurfaceSpec::deserialize(Value::Object(rest)).map_err(|error| error.to_string())?;
    let named = stages.into_iter().map(|(key, value)| match value {
        Value::String(name) => Ok((key, name)),
        other => Err(format!("{key}: {other} is no name of a variant")),
    });
    Ok(SurfaceSpec { stages: named.collect::<Result<_, _>>()?, ..surface })
}
