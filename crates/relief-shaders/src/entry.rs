//! What the list of a stage says of a variant.
//!
//! Each variant of a stage, such as a search or a shadow, has one [`Entry`] beside its source. The command's
//! help, the tables in the documentation, the tests' matrix and the benchmarks read the lists of these. A
//! variant's name stands in its own file: what other code must know of it is its [`Role`].

use relief_core::FoundState;
use relief_core::registry::{Guarantees, MAX_PARAMS, MapInput, Param, Publication, UnknownName, Weakened};

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
    /// One line on what it does.
    pub summary: &'static str,
    /// Where it was published.
    pub publication: Publication,
    /// The baked maps that it reads besides the height map.
    pub maps: &'static [MapInput],
    /// Its parameters, at most [`MAX_PARAMS`], in the order of the shader's parameter vector.
    pub params: &'static [Param],
    /// Of a search, the states in which it ends after a find; of a refinement or a shadow, the states that it
    /// takes. Empty for all others.
    pub states: &'static [FoundState],
    /// What it promises for each class of rays.
    pub guarantee: Guarantees,
    /// Where it promises less.
    pub weakened: &'static [Weakened],
    /// Why the guarantee holds: the claim, the rays, the rounding slack in `f32`.
    pub argument: &'static str,
    /// What programs must know of it beside its shader.
    pub role: Role,
}

/// What programs must know of a variant beside its shader: which other variants go with it, and what they must
/// provide for it.
#[derive(Clone, Copy, Debug)]
pub enum Role {
    /// Programs need to know nothing: its shader, its maps and its parameters say all.
    Plain,
    /// It does nothing: its stage is as good as left out.
    Idle,
    /// A geometry: the triangles that it draws.
    Geometry(GeometryRole),
    /// A surface: the path segments of its rays.
    Surface(Paths),
    /// A slice test that draws only points near the relief's surface.
    NearSurface,
    /// An object: the solid that its images show.
    Object(ObjectRole),
    /// A level of detail in which relief is flatter with distance.
    Flattened,
    /// A search or a refinement: the paths that it serves.
    Tracing(TracingRole),
    /// A shadow: how it tests what is between a hit and a light.
    Shadow(ShadowRole),
    /// An ambient light that shows the surroundings: in reflections, and through the surface.
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
    /// Whether it finds a hit between a slice that is drawn and the one before it.
    pub joins_slices: bool,
}

impl TracingRole {
    /// A search or a refinement for paths over a relief alone.
    pub const PLAIN: Self =
        Self { is_reference: false, serves_images: false, only_samples: false, joins_slices: false };
}

/// A variant of another stage that is chosen together with one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Companion {
    /// The key of its stage.
    pub stage: &'static str,
    /// Its name.
    pub name: &'static str,
    /// Its parameters that differ from their defaults, by name.
    pub settings: &'static [(&'static str, f32)],
}

impl Companion {
    /// A variant with its default parameters, by its stage's key and its name.
    pub const fn new(stage: &'static str, name: &'static str) -> Self {
        Self { stage, name, settings: &[] }
    }

    /// The same variant with other values of some parameters.
    #[must_use]
    pub const fn with(self, settings: &'static [(&'static str, f32)]) -> Self {
        Self { settings, ..self }
    }
}

impl Entry {
    /// The parameter of that name and its place in the parameter vector.
    pub fn param(&self, name: &str) -> Option<(usize, &'static Param)> {
        self.params.iter().enumerate().find(|(_, param)| param.name == name)
    }

    /// What it promises with these parameters, in the order of its own.
    pub fn promises(&self, params: &[f32; MAX_PARAMS]) -> Guarantees {
        let is_met = |weakened: &&Weakened| {
            self.param(weakened.param).is_some_and(|(place, _)| params[place] == weakened.value)
        };
        self.weakened.iter().find(is_met).map_or(self.guarantee, |weakened| weakened.to)
    }

    /// The default of every parameter, as the vector that the shader takes.
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

    /// Whether it does nothing, so that its stage is as good as left out.
    pub const fn is_idle(&self) -> bool {
        matches!(self.role, Role::Idle)
    }

    /// The triangles that it draws as a geometry: the base, unless it says otherwise.
    pub const fn geometry(&self) -> GeometryRole {
        match self.role {
            Role::Geometry(geometry) => geometry,
            _ => GeometryRole::BASE,
        }
    }

    /// The path segments of a ray on this surface: one straight segment unless it says otherwise.
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

    /// The solid that its images show as an object; none for a relief.
    pub const fn object(&self) -> Option<ObjectRole> {
        match self.role {
            Role::Object(object) => Some(object),
            _ => None,
        }
    }

    /// Whether relief is flatter with distance in it as a level of detail.
    pub const fn flattens(&self) -> bool {
        matches!(self.role, Role::Flattened)
    }

    /// The paths that it serves as a search or a refinement: those over a relief unless it says otherwise.
    pub const fn tracing(&self) -> TracingRole {
        match self.role {
            Role::Tracing(tracing) => tracing,
            _ => TracingRole::PLAIN,
        }
    }

    /// How it tests as a shadow what is between a hit and a light; none where its shader says all.
    pub const fn shadow(&self) -> Option<ShadowRole> {
        match self.role {
            Role::Shadow(shadow) => Some(shadow),
            _ => None,
        }
    }

    /// Whether it shows the surroundings as an ambient light.
    pub const fn sees_surroundings(&self) -> bool {
        matches!(self.role, Role::Surroundings)
    }
}

/// The place of the entry of that name.
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
