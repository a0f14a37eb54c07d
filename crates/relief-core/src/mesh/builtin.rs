//! List of the built-in meshes.

use super::{Mesh, MeshError, cube, cylinder, rectangle, sphere, square, torus};
use crate::registry::UnknownName;
use std::fmt;
use std::str::FromStr;

/// A mesh that needs no file. Each fits the unit cube around the origin, in metres.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Builtin {
    /// A rectangle at `y = 0` with the proportions of its map; the longer side is 1 m.
    #[default]
    Plane,
    /// The unit square at `y = 0`, for any map.
    Square,
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
    /// All built-in meshes, in the order of the help.
    pub const ALL: [Builtin; 6] =
        [Builtin::Plane, Builtin::Square, Builtin::Cube, Builtin::Cylinder, Builtin::Sphere, Builtin::Torus];

    /// Returns the name of this mesh, as scenes spell it: `plane`, `square` and so on.
    pub const fn name(self) -> &'static str {
        match self {
            Builtin::Plane => "plane",
            Builtin::Square => "square",
            Builtin::Cube => "cube",
            Builtin::Cylinder => "cylinder",
            Builtin::Sphere => "sphere",
            Builtin::Torus => "torus",
        }
    }

    /// Builds the mesh at its usual resolution. Flat faces are undivided. Curved faces have edges
    /// of 1 to 3 cm, so that a triangle stays within 0.4 mm of the true surface.
    ///
    /// The plane takes the proportions of its map, given as lengths along `u` and `v` in any unit.
    /// The other meshes ignore them.
    ///
    /// # Errors
    ///
    /// When the proportions are not finite, not positive, or too far apart for `f32`.
    pub fn build(self, proportions: [f64; 2]) -> Result<Mesh, MeshError> {
        match self {
            Builtin::Plane => {
                let longer = proportions[0].max(proportions[1]);
                rectangle(proportions.map(|length| length / longer), 1)
            }
            Builtin::Square => square(1),
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
