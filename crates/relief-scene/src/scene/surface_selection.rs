//! Selection of a surface's method, shadow and other variants, from what its description names.

use super::builder::{
    AMBIENT_ENVIRONMENT, DEFAULT_METHOD, DEFAULT_METHOD_OF_MOTIFS, DEFAULT_METHOD_OF_OBJECTS,
    DEFAULT_METHOD_OF_VOLUMES, of_selection,
};
use super::error::{ValueError, ValueProblem};
use super::material_spec::{metallic_roughness, reads_materials};
use super::surface_spec::environment;
use super::{Look, SurfaceSpec};
use crate::material::{Material, ShadingModel};
use relief_shaders::field::Solids;
use relief_shaders::surface::Proposal;
use relief_shaders::{
    AMBIENT, DETAIL, GEOMETRY, REFINE, SEARCH, SHADE, SHADOW, SHADOW_SEARCH, STAGES, SURFACE, Selection,
};

/// Detail variant for pictures with several samples per pixel, if the search's maps can have levels
/// of detail.
const FOOTPRINT: &str = "footprint";

/// Method and shadow of a mesh without a height map. The triangles cast shadows on each other.
const METHOD_OF_MESHES: &str = "bump";
const SHADOW_OF_MESHES: &str = "map";

/// Values of the scene that a surface depends on.
#[derive(Clone, Copy, Debug, Default)]
pub struct SceneContext {
    pub look: Look,
    /// Whether the scene has an environment map.
    pub has_environment: bool,
    /// Whether the scene has several surfaces.
    pub several: bool,
    /// Columns and rows of the picture, or an assumed size.
    pub size: [u32; 2],
}

impl SurfaceSpec {
    /// Returns the variants of all stages. With several samples per pixel, minified maps are
    /// filtered, too, if the search's maps can have levels of detail.
    pub(super) fn selection(&self, samples: u32, context: &SceneContext) -> Result<Selection, ValueError> {
        if samples > 1 && !self.stages.contains_key(STAGES[DETAIL].key) {
            let selection = self.selection_in(Some(FOOTPRINT), context)?;
            let has_levels = selection.object_cells().is_none() && selection.solids() == Solids::Heights;
            if has_levels && selection.check_levels().is_ok() {
                return Ok(selection);
            }
        }
        self.selection_in(None, context)
    }

    /// Returns the selection, with `detail` in place of the method's.
    pub(super) fn selection_in(
        &self,
        detail: Option<&str>,
        context: &SceneContext,
    ) -> Result<Selection, ValueError> {
        let named = |stage: usize| self.stages.get(STAGES[stage].key).map(String::as_str);
        let selection = match (&self.method, named(SEARCH), named(REFINE)) {
            (Some(_), None, None) if named(GEOMETRY).is_some() => {
                return Err(ValueProblem::Excludes("geometry").of("method"));
            }
            (method, None, None) => {
                let default = match self.object {
                    Some(_) => DEFAULT_METHOD_OF_OBJECTS,
                    None if self.volume.is_some() => DEFAULT_METHOD_OF_VOLUMES,
                    None if self.motif.is_some() => DEFAULT_METHOD_OF_MOTIFS,
                    None if self.is_mesh_alone() => METHOD_OF_MESHES,
                    None => DEFAULT_METHOD,
                };
                Selection::method(method.as_deref().unwrap_or(default))
            }
            (None, Some(search), Some(refine)) => Selection::pair(search, refine),
            (None, Some(_), None) => return Err(ValueProblem::Needs("refine").of("search")),
            (None, None, Some(_)) => return Err(ValueProblem::Needs("search").of("refine")),
            (Some(_), _, _) => return Err(ValueProblem::Excludes("search and refine").of("method")),
        };
        let mut selection = selection.map_err(of_selection)?;
        if self.volume.is_some() {
            selection = selection.with_solids(Solids::Volumes);
        }
        if self.motif.is_some() {
            selection = selection.with_solids(Solids::Motifs);
        }
        if self.extinction.is_some() && !selection.is_translucent() {
            return Err(ValueProblem::NotTranslucent.of("extinction"));
        }
        if let Some(detail) = detail {
            selection.choose(STAGES[DETAIL].key, detail).map_err(of_selection)?;
        }
        // The sides of a block are seen, where a relief on polygons shows nothing.
        let is_named = [GEOMETRY, SURFACE].iter().any(|stage| named(*stage).is_some());
        if self.has_walls() && !is_named && selection.geometry().is_none() {
            let shells = STAGES[SURFACE].first(|entry| entry.paths().proposal == Proposal::Shells);
            if let Some((_, entry)) = shells {
                selection.choose(STAGES[SURFACE].key, entry.name).map_err(of_selection)?;
            }
        }
        let model = self.shading_model()?;
        let is_rough =
            model.map_or(context.look.shades_materials(), |model| model == ShadingModel::MetallicRoughness);
        if is_rough {
            selection.choose(STAGES[SHADE].key, metallic_roughness()).map_err(of_selection)?;
        }
        let sees_environment = context.has_environment || self.asks_for_environment();
        if sees_environment {
            selection.choose(STAGES[AMBIENT].key, environment()).map_err(of_selection)?;
        }
        if self.is_mesh_alone() {
            selection.choose(STAGES[SHADOW].key, SHADOW_OF_MESHES).map_err(of_selection)?;
        }
        // A shadow takes over the view's search with its settings, unless it has its own.
        for is_of_shadow in [false, true] {
            let of_part = |key: &&String| key.starts_with(STAGES[SHADOW].key) == is_of_shadow;
            for key in self.stages.keys().filter(of_part) {
                selection.choose(key, &self.stages[key]).map_err(of_selection)?;
            }
            let is_named = |stage: usize| self.stages.contains_key(STAGES[stage].key);
            if !is_of_shadow && !sees_environment && !is_named(AMBIENT) {
                context.look.light_from_sky(&mut selection, !self.is_mesh_alone(), context.size);
            }
            let sets_search =
                self.set.keys().any(|key| key.split('.').next() == Some(STAGES[SHADOW_SEARCH].key));
            let has_shadow =
                self.is_mesh_alone() || is_named(SHADOW) || is_named(SHADOW_SEARCH) || sets_search;
            if is_of_shadow && context.several && !has_shadow {
                context.look.share_shadows(&mut selection, context.size);
            }
            for key in self.set.keys().filter(of_part) {
                selection.set(key, self.set[key]).map_err(of_selection)?;
            }
        }
        let is_read = selection.sees_environment() || reads_materials(&selection);
        if self.ior.is_some_and(|ior| ior != Material::default().ior()) && !is_read {
            return Err(ValueProblem::Needs(&AMBIENT_ENVIRONMENT).of("ior"));
        }
        if !selection.uses(SHADOW_SEARCH) {
            let search = STAGES[SHADOW_SEARCH].key;
            if self.stages.contains_key(search) {
                return Err(ValueProblem::NoShadowRays.of(search));
            }
            if self.set.keys().any(|key| key.split('.').next() == Some(search)) {
                return Err(ValueProblem::NoShadowRays.of("set"));
            }
        }
        Ok(selection)
    }
}
