//! Loading of the surface of a depth object.

use super::error::{SceneError, ValueProblem};
use super::maps::Maps;
use super::material_spec::reads_materials;
use super::surface_parts::Parts;
use super::{Surface, SurfaceSpec};
use crate::material::Material;
use glam::Vec3;
use relief_object::{ObjectFile, ObjectOptions};
use std::path::Path;

impl SurfaceSpec {
    /// Loads the surface of an object's file.
    pub(super) fn load_object(
        &self,
        path: &Path,
        parts: Parts,
        maps: &mut Maps<'_>,
    ) -> Result<Surface, SceneError> {
        let options = ObjectOptions { max_bytes: maps.left(), ..ObjectOptions::default() };
        let ObjectFile { object, color, normal, .. } =
            relief_object::read_object(maps.files().source(path), &options)?;
        maps.take(path, object.heights(), &parts.selection)?;
        let object = self.placed_object(&object)?;
        let surface = if parts.selection.blends_normals() && !object.has_solid() {
            Surface::of_object_in_ball(object)
        } else {
            Surface::of_object(object)
        };
        let surface = surface.map_err(|error| ValueProblem::from(error).of("object"))?;
        let under = || {
            if reads_materials(&parts.selection) { Vec3::ONE } else { Material::under_colours().diffuse() }
        };
        let material = self.material_of(color.is_some().then(under), &parts.selection)?;
        let mut surface = surface.with_material(material).with_selection(parts.selection);
        if let Some(color) = color {
            maps.take_picture(&color);
            surface = surface.with_color(color);
        }
        // Silhouettes have normals of their own.
        if let Some(normal) = normal.filter(|_| parts.selection.has_normals_of_relief()) {
            maps.take_normals([normal.width, normal.height]);
            surface = surface.with_normal_map(&normal);
        }
        Ok(surface.with_creases(parts.creases))
    }
}
