//! The kinds of input that functions take.

use std::fmt;
use std::str::FromStr;

use relief_core::registry::UnknownName;
use relief_shaders::surface::Shown;
use relief_shaders::wgsl::Root;
use relief_shaders::{Entry, Selection};

/// The kind of input of functions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Form {
    /// A point of the mesh and the direction of a ray, in the tangent space of the point. For surfaces whose
    /// rays need no more of the mesh.
    #[default]
    Tangent,
    /// A triangle with the space above it and a ray, in any space. For every surface that has a relief on its
    /// triangles, shells among them.
    Triangle,
}

impl Form {
    /// Every form, in the order in which help lists them.
    pub const ALL: [Form; 2] = [Form::Tangent, Form::Triangle];

    /// Returns the name of this form, as files and the command spell it.
    pub const fn name(self) -> &'static str {
        match self {
            Form::Tangent => "tangent",
            Form::Triangle => "triangle",
        }
    }

    /// Returns whether a surface has functions in this form.
    pub fn takes(self, surface: &Entry) -> bool {
        let paths = surface.paths();
        match self {
            Form::Tangent => paths.through_frame,
            Form::Triangle => paths.shown == Shown::Relief && paths.images.is_none(),
        }
    }

    /// The sources of its functions.
    pub(super) const fn root(self) -> Root {
        match self {
            Form::Tangent => Root::Functions,
            Form::Triangle => Root::TriangleFunctions,
        }
    }

    /// The function that finds a hit, as the sources name it.
    pub(super) const fn hit(self) -> &'static str {
        match self {
            Form::Tangent => "relief_hit",
            Form::Triangle => "relief_triangle_hit",
        }
    }

    /// The function that says how much of a light arrives.
    pub(super) const fn light(self) -> &'static str {
        match self {
            Form::Tangent => "relief_light",
            Form::Triangle => "relief_triangle_light",
        }
    }

    /// The functions that programs call.
    pub(super) fn called(self, selection: &Selection) -> Vec<&'static str> {
        let mut called = vec![self.hit()];
        if selection.has_shadows() {
            called.push(self.light());
        }
        if self == Form::Tangent {
            called.push("relief_tile");
            if selection.quadrics().is_some() {
                called.push("relief_curvature");
            }
        }
        called
    }

    /// The structs that go in.
    pub(super) const fn given(self) -> &'static [&'static str] {
        match self {
            Form::Tangent => &["ReliefPoint"],
            Form::Triangle => &["ReliefTriangle", "Corner", "Shell", "ReliefRay"],
        }
    }

    /// The struct that comes out.
    pub(super) const fn found(self) -> &'static str {
        match self {
            Form::Tangent => "ReliefHit",
            Form::Triangle => "ReliefTriangleHit",
        }
    }
}

impl fmt::Display for Form {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Form {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let found = Self::ALL.into_iter().find(|form| form.name() == name);
        found.ok_or_else(|| UnknownName::new("form of functions", name, Self::ALL.map(Self::name)))
    }
}
