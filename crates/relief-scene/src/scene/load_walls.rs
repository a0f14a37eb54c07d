//! Walls and the bottom of a block: checks and making.

use super::error::{SceneError, ValueError, ValueProblem};
use super::load_surface::level_map;
use super::maps::Maps;
use super::surface_selection::SceneContext;
use super::walls::{triangles_of_walls, walls};
use super::{MeshChoice, Surface, SurfaceSpec};
use glam::Vec3;
use relief_core::mesh::Builtin;
use relief_shaders::surface::{Proposal, Shown};
use relief_shaders::{AMBIENT, Entry, SEARCH, SHADE, SHADOW, STAGES, Selection};
use std::path::{Path, PathBuf};

/// Linear colour of the walls of blocks: earth.
const COLOR_OF_WALLS: Vec3 = Vec3::new(0.24, 0.17, 0.12);

impl SurfaceSpec {
    /// Returns whether walls close the relief to a block.
    pub(super) fn has_walls(&self) -> bool {
        self.walls == Some(true)
    }

    /// Refuses walls around another mesh than a plane, or around a relief that shows no sides.
    pub(super) fn check_walls(&self, selection: &Selection) -> Result<(), ValueError> {
        let is_plane = matches!(
            self.mesh,
            None | Some(MeshChoice::Builtin(Builtin::Plane)) | Some(MeshChoice::Builtin(Builtin::Square))
        );
        if !is_plane {
            return Err(ValueProblem::WallsOfMesh.of("walls"));
        }
        let paths = selection.paths();
        let is_searched = paths.has_relief() && !selection.choices[SEARCH].entry.is_idle();
        match paths.shown {
            Shown::Relief if is_searched && paths.proposal == Proposal::Shells => Ok(()),
            Shown::Triangles => Ok(()),
            _ => Err(ValueProblem::WallsOfBase.of("walls")),
        }
    }

    /// Makes the walls and the bottom of a loaded surface: a surface without a relief, with its
    /// shading.
    pub(super) fn load_walls(
        &self,
        surface: &Surface,
        samples: u32,
        context: &SceneContext,
        maps: &mut Maps<'_>,
    ) -> Result<Surface, SceneError> {
        let shadow = STAGES[SHADOW].first(Entry::is_idle).map(|(_, entry)| entry.name);
        // Nothing lies beside a block, so only other surfaces cast shadows on its walls.
        let shadow = shadow.filter(|_| !context.several).map(|name| (STAGES[SHADOW].key, name));
        let named = |stage: usize| Some((STAGES[stage].key, surface.selection().choices[stage].entry.name));
        let is_free = surface.selection().choices[AMBIENT].entry.maps.is_empty();
        let is_named =
            surface.selection().sees_environment() || self.stages.contains_key(STAGES[AMBIENT].key);
        let ambient = named(AMBIENT).filter(|_| is_free && is_named);
        let stages = [named(SHADE), ambient, shadow].into_iter().flatten();
        let spec = SurfaceSpec {
            mesh: Some(MeshChoice::File(PathBuf::new())),
            stages: stages.map(|(key, name)| (key.to_owned(), name.to_owned())).collect(),
            ..SurfaceSpec::default()
        };
        let selection = spec.selection(samples, context)?;
        let material = spec.material_of(Some(COLOR_OF_WALLS), &selection)?;
        let path = self.height.as_deref().unwrap_or(Path::new(""));
        maps.take_triangles(path, surface.height_map(), triangles_of_walls(surface))?;
        let mesh = walls(surface, self.base.unwrap_or_default())
            .map_err(|error| ValueProblem::from(error).of("walls"))?;
        let level = level_map(None)?.with_displacement(0.0, 0.0);
        let level = level.map_err(|error| ValueProblem::from(error).of("walls"))?;
        Ok(Surface::new(mesh, level).with_material(material).with_selection(selection))
    }
}
