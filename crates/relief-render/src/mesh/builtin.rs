//! The list of built-in meshes.

use super::{Mesh, MeshError, cube, cylinder, plane, sphere, torus};
use relief_core::registry::UnknownName;
use std::fmt;
use std::str::FromStr;

/// A mesh that needs no file. Each fits the unit cube around the origin, in metres.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Builtin {
    /// The unit square at `y = 0`.
    #[default]
    Plane,
    /// The unit cube.
    Cube,
    /// An upright cylinder with caps.
    Cylinder,
    /// A sphere.
    Sphere,
    /// A lying torus.
    Torus,
}

impl Builtin {
    /// Every built-in mesh, in the order in which help lists them.
    pub const ALL: [Builtin; 5] =
        [Builtin::Plane, Builtin::Cube, Builtin::Cylinder, Builtin::Sphere, Builtin::Torus];

    /// The name used on the command line and in scenes.
    pub const fn name(self) -> &'static str {
        match self {
            Builtin::Plane => "plane",
            Builtin::Cube => "cube",
            Builtin::Cylinder => "cylinder",
            Builtin::Sphere => "sphere",
            Builtin::Torus => "torus",
        }
    }

    /// The mesh at its usual fineness: flat faces undivided, curved ones with edges of 1 to 3 cm, so that a
    /// triangle stays within 0.4 mm of the true surface.
    ///
    /// # Errors
    ///
    /// None for the numbers of divisions used here; the type is that of the functions which take others.
    pub fn build(self) -> Result<Mesh, MeshError> {
        match self {
            Builtin::Plane => plane(1),
            Builtin::Cube => cube(1),
            Builtin::Cylinder => cylinder(128, 1),
            Builtin::Sphere => sphere(128, 64),
            Builtin::Torus => torus(128, 64),
        }
    }
}

impl fmt::Display for Builtin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Builtin {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let known = Builtin::ALL.map(Builtin::name);
        Builtin::ALL
            .into_iter()
            .find(|builtin| builtin.name() == name)
            .ok_or_else(|| UnknownName::new("mesh", name, known))
    }
}
