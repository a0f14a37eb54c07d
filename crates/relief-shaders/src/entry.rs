//! Registry entries of variants.
//!
//! Each variant of a stage, such as a search or a shadow, has one [`Entry`] beside its source. The
//! command's help, the tables in the documentation, the tests' matrix and the benchmarks read the
//! lists of entries. A variant's name stands in its own file only: other code asks its [`Role`].

use relief_core::FoundState;
use relief_core::registry::{Guarantees, MAX_PARAMS, MapInput, Param, Publication, UnknownName, Weakened};

use crate::field::Solids;
use crate::geometry::GeometryRole;
use crate::object::ObjectRole;
use crate::shadow::ShadowRole;
use crate::surface::Paths;

/// One variant of a stage: its name, its source, its needs and its promises. Its number in the shaders is its
/// place in its list.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// The name on the command line and in scenes.
    pub name: &'static str,
    /// A line that says what it does.
    pub summary: &'static str,
    /// Where it was published.
    pub publication: Publication,
    /// The baked maps that it reads besides the height map.
    pub maps: &'static [MapInput],
    /// The parameters, at most [`MAX_PARAMS`]. The shader gets the first four, in this order.
    pub params: &'static [Param],
    /// For a search, the results with which it ends if it finds something. For a refinement or a
    /// shadow, the results that it takes. Empty for all others.
    pub states: &'static [FoundState],
    /// The guarantee for each class of rays.
    pub guarantee: Guarantees,
    /// Parameter values with a weaker guarantee.
    pub weakened: &'static [Weakened],
    /// Why the guarantee holds: the claim, the rays, the rounding slack in `f32`.
    pub argument: &'static str,
    /// Data for programs beside its shader.
    pub role: Role,
}

/// Data about a variant for programs, beside its shader: which other variants go with it, and what
/// programs must provide for it.
#[derive(Clone, Copy, Debug)]
pub enum Role {
    /// No such data: its shader, its maps and its parameters say all.
    Plain,
    /// A variant that does nothing: its stage can be left out.
    Idle,
    /// A geometry: the triangles that it draws.
    Geometry(GeometryRole),
    /// A surface: the path segments of its rays.
    Surface(Paths),
    /// A slice test that draws only points near the relief's surface.
    NearSurface,
    /// An object: the solid that its images show.
    Object(ObjectRole),
    /// A field that shows other solids than heights.
    Field(Solids),
    /// A level of detail in which relief is flatter with distance.
    Flattened,
    /// A search or a refinement: the paths that it serves.
    Tracing(TracingRole),
    /// A shadow: its test between a hit and a light.
    Shadow(ShadowRole),
    /// A shading that reads roughness, metalness and the material maps.
    ReadsMaterials,
    /// An ambient light that shows the environment map: in reflections, and through the surface.
    Surroundings,
}

/// The paths that a search or a refinement serves.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TracingRole {
    /// Whether it has the exact answer without a baked map. Where both the search and the refinement are
    /// references, CPUs may run the exact tracer in their place. Each of the two stages has one reference.
    pub is_reference: bool,
    /// Whether it serves the images of an object: their heights jump from texel to texel, and rays come from
    /// all sides.
    pub serves_images: bool,
    /// Whether it reads heights at sample points alone, and assumes nothing between them.
    pub only_samples: bool,
    /// The solids that it finds.
    pub solids: Solids,
    /// Whether it finds a hit between a slice that is drawn and the one before it.
    pub joins_slices: bool,
    /// Whether it knows only paths that come in at the top of the relief.
    pub begins_at_top: bool,
    /// Whether nothing is hit: renderers gather the light that a translucent volume scatters along the path.
    pub gathers: bool,
}

impl TracingRole {
    /// A search or a refinement for paths over a relief alone.
    pub const PLAIN: Self = Self {
        is_reference: false,
        serves_images: false,
        only_samples: false,
        solids: Solids::Heights,
        joins_slices: false,
        begins_at_top: false,
        gathers: false,
    };
}

/// A variant of another stage that is chosen together with one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Companion {
    /// The key of its stage.
    pub stage: &'static str,
    /// The variant's name.
    pub name: &'static str,
    /// Parameters that differ from their defaults, by name.
    pub settings: &'static [(&'static str, f32)],
}

impl Companion {
    /// Returns a variant with its default parameters, by its stage's key and its name.
    pub const fn new(stage: &'static str, name: &'static str) -> Self {
        Self { stage, name, settings: &[] }
    }

    /// Returns the variant with other values of some parameters.
    #[must_use]
    pub const fn with(self, settings: &'static [(&'static str, f32)]) -> Self {
        Self { settings, ..self }
    }
}

impl Entry {
    /// Returns the parameter of that name and its place in the parameter vector.
    pub fn param(&self, name: &str) -> Option<(usize, &'static Param)> {
        self.params.iter().enumerate().find(|(_, param)| param.name == name)
    }

    /// Returns the guarantee with these parameters, given in the entry's order.
    pub fn promises(&self, params: &[f32; MAX_PARAMS]) -> Guarantees {
        let is_met = |weakened: &&Weakened| {
            self.param(weakened.param).is_some_and(|(place, _)| params[place] == weakened.value)
        };
        self.weakened.iter().find(is_met).map_or(self.guarantee, |weakened| weakened.to)
    }

    /// Returns the default of every parameter, as the vector that the shader takes.
    pub fn defaults(&self) -> [f32; MAX_PARAMS] {
        let mut values = [0.0; MAX_PARAMS];
        for (value, param) in values.iter_mut().zip(self.params) {
            *value = param.default;
        }
        values
    }

    /// Whether it reads a baked map of that kind.
    pub fn reads(&self, kind: &str) -> bool {
        self.maps.iter().any(|map| map.kind == kind)
    }

    /// Whether it does nothing, so that its stage can be left out.
    pub const fn is_idle(&self) -> bool {
        matches!(self.role, Role::Idle)
    }

    /// Returns the triangles that it draws as a geometry: the base's for all other variants.
    pub const fn geometry(&self) -> GeometryRole {
        match self.role {
            Role::Geometry(geometry) => geometry,
            _ => GeometryRole::BASE,
        }
    }

    /// Returns the path segments of a ray on this surface: one straight segment for all other
    /// variants.
    pub const fn paths(&self) -> &Paths {
        match &self.role {
            Role::Surface(paths) => paths,
            _ => &Paths::STRAIGHT,
        }
    }

    /// Whether it draws only points near the relief's surface as a slice test.
    pub const fn is_near_surface(&self) -> bool {
        matches!(self.role, Role::NearSurface)
    }

    /// Returns the solid that its images show as an object; `None` for a relief.
    pub const fn object(&self) -> Option<ObjectRole> {
        match self.role {
            Role::Object(object) => Some(object),
            _ => None,
        }
    }

    /// Returns what it shows as a field: heights for all other variants.
    pub const fn field(&self) -> Solids {
        match self.role {
            Role::Field(solids) => solids,
            _ => Solids::Heights,
        }
    }

    /// Whether it is a level of detail in which relief is flatter with distance.
    pub const fn flattens(&self) -> bool {
        matches!(self.role, Role::Flattened)
    }

    /// Returns the paths that it serves as a search or a refinement: by default paths over heights.
    pub const fn tracing(&self) -> TracingRole {
        match self.role {
            Role::Tracing(tracing) => tracing,
            Role::Idle => TracingRole { solids: Solids::All, ..TracingRole::PLAIN },
            _ => TracingRole::PLAIN,
        }
    }

    /// Returns its test between a hit and a light as a shadow; `None` if its shader says all.
    pub const fn shadow(&self) -> Option<ShadowRole> {
        match self.role {
            Role::Shadow(shadow) => Some(shadow),
            _ => None,
        }
    }

    /// Whether it reads roughness, metalness and the material maps as a shading.
    pub const fn reads_materials(&self) -> bool {
        matches!(self.role, Role::ReadsMaterials)
    }

    /// Whether it shows the environment map as an ambient light.
    pub const fn sees_surroundings(&self) -> bool {
        matches!(self.role, Role::Surroundings)
    }
}

/// Returns the place of the entry of that name.
///
/// # Errors
///
/// When no entry has that name; the error names the nearest.
pub fn find(kind: &'static str, entries: &[Entry], name: &str) -> Result<usize, UnknownName> {
    let known = || entries.iter().map(|entry| entry.name);
    entries.iter().position(|entry| entry.name == name).ok_or_else(|| UnknownName::new(kind, name, known()))
}

#[cfg(test)]
mod tests;
