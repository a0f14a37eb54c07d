//! Keys of a surface inside the file of its mesh: `relief` in the extras of a glTF's material.

use std::collections::BTreeMap;
use std::path::PathBuf;

use relief_core::registry::UnknownName;
use relief_io::{Files, Source, beside_file, mesh_needs_roughness, read_mesh_extras};
use relief_shaders::{SHADE, STAGES};
use serde::Deserialize;
use serde_json::{Map, Value};

use super::keys::keys_of;
use super::material_spec::metallic_roughness;
use super::{DEFAULT_MAX_MEMORY, MeshChoice, SceneError, SceneSpec, SurfaceSpec};

/// Name of the object in the extras.
const EXTRAS: &str = "relief";

/// Key that the extras cannot have, as it names the mesh itself.
const MESH: &str = "mesh";

impl SceneSpec {
    /// Returns this description, completed with the keys that mesh files hold for their surfaces.
    /// Keys of this description take precedence.
    ///
    /// A glTF holds them in an object `relief` in the `extras` of the only material of its
    /// triangles, or equally in all of these materials. The keys are a surface's keys in a scene
    /// file except `mesh`. Paths start at the glTF's folder and stay within it. [`Self::load`]
    /// calls this function.
    ///
    /// # Errors
    ///
    /// When a mesh file cannot be read, or its keys or values cannot be used.
    pub fn with_keys_of_meshes(&self) -> Result<SceneSpec, SceneError> {
        self.with_keys_of(&Files::Disk)
    }

    /// Returns this description, completed with the keys of mesh files in `files`.
    pub(super) fn with_keys_of(&self, files: &Files) -> Result<SceneSpec, SceneError> {
        let limit = self.max_memory.unwrap_or(DEFAULT_MAX_MEMORY).0;
        let mut known: BTreeMap<PathBuf, Option<SurfaceSpec>> = BTreeMap::new();
        let mut each = Vec::new();
        for surface in self.each_surface() {
            let of_mesh = match &surface.mesh {
                Some(MeshChoice::File(path)) => match known.get(path) {
                    Some(of_mesh) => of_mesh.clone(),
                    None => {
                        let of_mesh = keys_of_mesh(files.source(path), limit)?;
                        known.insert(path.clone(), of_mesh.clone());
                        of_mesh
                    }
                },
                _ => None,
            };
            let mut surface = match of_mesh {
                Some(of_mesh) => over(of_mesh, surface),
                None => surface,
            };
            // A material that Blinn-Phong cannot show chooses the shading, unless the keys do.
            if let Some(MeshChoice::File(path)) = &surface.mesh
                && surface.object.is_none()
                && !surface.stages.contains_key(STAGES[SHADE].key)
                && surface.shading_model().is_ok_and(|model| model.is_none())
                && mesh_needs_roughness(files.source(path), limit).map_err(SceneError::Mesh)?
            {
                surface.stages.insert(STAGES[SHADE].key.to_owned(), metallic_roughness().to_owned());
            }
            each.push(surface);
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
    // The keys belong to this very mesh. Another mesh would drop some of them.
    let mesh = surface.mesh.take();
    SurfaceSpec { mesh, ..of_mesh.overridden_by(surface) }
}

/// Returns the checked keys of a mesh's file.
fn keys_of_mesh(source: Source<'_>, limit: u64) -> Result<Option<SurfaceSpec>, SceneError> {
    let path = source.name();
    let Some(text) = read_mesh_extras(source, EXTRAS, limit).map_err(SceneError::Mesh)? else {
        return Ok(None);
    };
    let wrong = |what: String| SceneError::MeshKeys { path: path.to_owned(), what };
    let mut surface = parse(&text).map_err(wrong)?;
    for file in surface.files_mut() {
        *file = beside_file(source, file).map_err(SceneError::Mesh)?;
    }
    let alone = SurfaceSpec { mesh: Some(MeshChoice::File(path.to_owned())), ..surface.clone() };
    SceneSpec::of_surface(alone).check().map_err(|error| wrong(error.to_string()))?;
    Ok(Some(surface))
}

/// Returns the surface in a JSON text, or a description of the problem.
fn parse(text: &str) -> Result<SurfaceSpec, String> {
    let all: Map<String, Value> = serde_json::from_str(text).map_err(|error| error.to_string())?;
    let is_of_stage = |key: &str| relief_shaders::stage(key).is_some();
    let (stages, rest): (Map<_, _>, Map<_, _>) = all.into_iter().partition(|(key, _)| is_of_stage(key));
    let known = || keys_of::<SurfaceSpec>().iter().copied().filter(|key| *key != MESH);
    // One key after another, so that an error names its key.
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
        other => Err(format!("{key}: {other} is no text: write the name of a variant in quotes")),
    });
    Ok(SurfaceSpec { stages: named.collect::<Result<_, _>>()?, ..surface })
}
