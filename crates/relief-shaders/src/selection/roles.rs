//! Needs and effects of the chosen variants, by their entries.

use relief_core::HeightMap;
use relief_core::mesh::QuadricCoefficients;
use relief_core::registry::{Guarantee, RayClass};

use super::{Choice, Selection};
use crate::entry::Entry;
use crate::field::Solids;
use crate::geometry::Geometry;
use crate::object::{ObjectCells, ObjectRole, Solid};
use crate::shadow::ShadowRole;
use crate::stages::{
    AMBIENT, DETAIL, FIELD, GEOMETRY, OBJECT, REFINE, SEARCH, SHADOW, SHADOW_SEARCH, SLICES, STAGES, SURFACE,
};
use crate::surface::{AskedImages, Paths, Shown};

impl Selection {
    /// Returns the triangles that are shown in place of the base's; `None` for the base's own.
    pub fn geometry(&self) -> Option<Geometry> {
        let [geometry, slices] = [GEOMETRY, SLICES].map(|place| &self.choices[place]);
        let triangles = geometry.entry.geometry().triangles?;
        Some(triangles(geometry.params, slices.params))
    }

    /// The content of the geometry's triangles.
    pub(super) fn shown_by_geometry(&self) -> Shown {
        self.choices[GEOMETRY].entry.geometry().shown
    }

    /// Whether the images of an object are counted in a stencil buffer, which only GPUs have.
    pub fn counts_in_stencil(&self) -> bool {
        let geometry = &self.choices[GEOMETRY];
        geometry.entry.geometry().stencil.is_some_and(|param| geometry.value(param) != 0.0)
    }

    /// Returns the path segments of rays on the chosen surface.
    pub fn paths(&self) -> &'static Paths {
        self.choices[SURFACE].entry.paths()
    }

    /// Whether the relief lies on a smooth base in place of flat triangles.
    pub fn has_smooth_base(&self) -> bool {
        self.choices[SURFACE].value("lift") != 0.0
    }

    /// Returns the selection with segments that run at most `texels` texels beside their rays, on
    /// surfaces with such a tolerance.
    #[must_use]
    pub fn with_tolerance_within(mut self, texels: f32) -> Self {
        let Choice { entry, params, .. } = &mut self.choices[SURFACE];
        if let Some((place, _)) = entry.param("tolerance") {
            params[place] = params[place].min(texels);
        }
        self
    }

    /// Returns the greatest distance of hits beside a shell, in texels. Segments reach that far
    /// beyond its sides, so that nothing passes between neighbours.
    pub fn beside_shells_texels(&self) -> f32 {
        2.0 * self.choices[SURFACE].value("tolerance")
    }

    /// Returns which coefficients the surface's quadrics have. `None` if rays do not follow
    /// quadrics around the corners of triangles.
    ///
    /// Quadrics have all relief carved into their triangles. Where relief would rise above them, a
    /// renderer must first move the triangles out along their normals.
    pub fn quadrics(&self) -> Option<QuadricCoefficients> {
        let Choice { entry, params, .. } = &self.choices[SURFACE];
        let (place, _) = entry.param("coefficients")?;
        Some(if params[place] < 3.0 { QuadricCoefficients::Two } else { QuadricCoefficients::Three })
    }

    /// Whether a relief gives the normals, not triangles or silhouettes.
    pub fn has_normals_of_relief(&self) -> bool {
        self.paths().has_normals_of_relief()
            && !self.object_cells().is_some_and(|object| object.solid == Solid::Hull)
    }

    /// Whether the geometry is the box around an object of images.
    pub(super) fn is_of_images(&self) -> bool {
        self.shown_by_geometry().is_of_images()
    }

    /// The solid of an object of images, if one is shown; by default the first of the stage's list.
    pub(super) fn object_role(&self) -> Option<ObjectRole> {
        let first = || STAGES[OBJECT].entries.iter().find_map(Entry::object);
        self.choices[OBJECT].entry.object().or_else(first).filter(|_| self.is_of_images())
    }

    /// Returns the way in which the images of an object are read, if one is shown.
    pub fn object_cells(&self) -> Option<ObjectCells> {
        self.object_role().map(|role| ObjectCells::of(role.solid, self.choices[OBJECT].params))
    }

    /// Whether rays read all images of an object, and not only some that a grid gives.
    pub fn asks_all_images(&self) -> bool {
        self.is_of_images() && self.paths().images == Some(AskedImages::All)
    }

    /// Whether rays read the frames of a grid, which an object's images must make.
    pub fn needs_grid(&self) -> bool {
        let is_of_frames = self.paths().images == Some(AskedImages::OfGrid);
        self.object_cells().is_some_and(|object| is_of_frames || object.has_blended_colors)
    }

    /// Whether normals are blended from several images.
    pub fn blends_normals(&self) -> bool {
        self.object_cells().is_some_and(|object| object.solid == Solid::Blend)
    }

    /// Returns what the surface shows: heights, a volume or a motif.
    pub fn solids(&self) -> Solids {
        self.choices[FIELD].entry.field()
    }

    /// Whether nothing is hit: light is gathered through a translucent volume.
    pub fn is_translucent(&self) -> bool {
        self.search().tracing().gathers
    }

    /// Whether pixels have different levels of detail.
    pub fn has_levels(&self) -> bool {
        !self.choices[DETAIL].entry.is_idle()
    }

    /// Returns the number of levels of a height map that are read.
    pub fn levels_of(&self, map: &HeightMap) -> u32 {
        if self.has_levels() { map.levels() } else { 1 }
    }

    /// Whether a stage is used. The search for shadows is not if no shadow sends rays, and the test
    /// of slices is not without slices.
    pub fn uses(&self, stage: usize) -> bool {
        match stage {
            // A translucent volume looks for its own shadows itself.
            SHADOW_SEARCH => !self.choices[SHADOW].entry.states.is_empty() && !self.is_translucent(),
            SLICES => self.shown_by_geometry().is_sliced(),
            OBJECT => self.is_of_images(),
            _ => true,
        }
    }

    /// Returns the chosen search.
    pub fn search(&self) -> &'static Entry {
        self.choices[SEARCH].entry
    }

    /// Returns the chosen refinement.
    pub fn refine(&self) -> &'static Entry {
        self.choices[REFINE].entry
    }

    /// Returns the guarantee of search and refinement together for a class of rays: the weaker of
    /// the two.
    pub fn guarantee(&self, rays: RayClass) -> Guarantee {
        let [search, refine] = [SEARCH, REFINE].map(|stage| self.choices[stage].promises().of(rays));
        search.min(refine)
    }

    /// Whether this is the pair that has the exact answer without a baked map, whatever its
    /// parameters.
    pub fn is_exact(&self) -> bool {
        self.search().tracing().is_reference && self.refine().tracing().is_reference && !self.uses(OBJECT)
    }

    /// Whether paths are searched or refined. Bump mapping and surfaces without a relief do
    /// neither.
    pub fn is_traced(&self) -> bool {
        self.paths().has_relief() && !(self.search().is_idle() && self.refine().is_idle())
    }

    /// Whether the relief casts shadows.
    pub fn has_shadows(&self) -> bool {
        !self.choices[SHADOW].entry.is_idle()
    }

    /// Whether shadows come from rays through the exact search without a baked map.
    pub fn has_exact_shadows(&self) -> bool {
        self.sends_rays_to_lights() && self.choices[SHADOW_SEARCH].entry.tracing().is_reference
    }

    /// Whether shadows come from rays from the hit to the light, or to points of its disc, through
    /// the relief of the same surface.
    pub fn sends_rays_to_lights(&self) -> bool {
        matches!(self.choices[SHADOW].entry.shadow(), Some(ShadowRole::ToLights { .. }))
    }

    /// Returns the number of points of a light's disc to which shadows send rays: 0 if they send
    /// one to its centre, or none.
    pub fn points_of_lights(&self) -> u32 {
        let shadow = &self.choices[SHADOW];
        match shadow.entry.shadow() {
            Some(ShadowRole::ToLights { rays: Some(rays) }) => shadow.value(rays) as u32,
            _ => 0,
        }
    }

    /// Returns the side of shadow maps, in texels, and the number of cascades of a distant light;
    /// `None` if shadows do not read shadow maps.
    pub fn light_views(&self) -> Option<[u32; 2]> {
        let shadow = &self.choices[SHADOW];
        match shadow.entry.shadow() {
            Some(ShadowRole::LightViews { size, cascades }) => {
                Some([size, cascades].map(|name| shadow.value(name) as u32))
            }
            _ => None,
        }
    }

    /// Returns the number of points of a light's disc to which rays go through the whole scene;
    /// `None` for other shadows. No surface can trace such rays alone, and no GPU.
    pub fn rays_through_scene(&self) -> Option<u32> {
        let shadow = &self.choices[SHADOW];
        match shadow.entry.shadow() {
            Some(ShadowRole::ThroughScene { rays }) => Some(shadow.value(rays) as u32),
            _ => None,
        }
    }

    /// Whether the environment map is seen: in reflections, and through the surface.
    pub fn sees_environment(&self) -> bool {
        self.choices[AMBIENT].entry.sees_surroundings()
    }
}
