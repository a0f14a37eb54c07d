//! Choices that have a few names each.

use std::fmt;
use std::str::FromStr;

use relief_core::registry::UnknownName;

/// An enumeration whose variants have names on the command line, and errors that name the nearest.
macro_rules! choice {
    ($(#[$about:meta])* $name:ident, $kind:literal: $($(#[$of:meta])* $variant:ident = $text:literal,)+) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
        pub enum $name {
            $($(#[$of])* $variant,)+
        }

        impl $name {
            /// All of them, in the order in which help lists them.
            pub const ALL: &[Self] = &[$(Self::$variant),+];

            /// The name on the command line.
            pub const fn name(self) -> &'static str {
                match self { $(Self::$variant => $text),+ }
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(self.name())
            }
        }

        impl FromStr for $name {
            type Err = UnknownName;

            fn from_str(name: &str) -> Result<Self, UnknownName> {
                let known = || Self::ALL.iter().copied();
                known()
                    .find(|choice| choice.name() == name)
                    .ok_or_else(|| UnknownName::new($kind, name, known().map(Self::name)))
            }
        }
    };
}

choice! {
    /// The surface that is displaced.
    BaseSurface, "base surface":
    /// The triangles as they are.
    #[default]
    Flat = "flat",
    /// The smooth surface that the mesh's normals promise: see
    /// [`Mesh::lifts`](relief_core::mesh::Mesh::lifts).
    Lift = "lift",
    /// Cubic triangles through the corners, at right angles to the normals there: the smooth base that
    /// Gumhold and Hüttner 1999 ask for (section 6), by the curved point-normal triangles of Vlachos, Peters,
    /// Boyd and Mitchell 2001 (section 3). A side follows from its two ends.
    Pn = "pn",
}

choice! {
    /// Along what a point of a triangle is displaced.
    Directions, "directions":
    /// The interpolated normal, not normalised, as the exact tracer of displaced meshes and the surface
    /// `prism` have it.
    #[default]
    Raw = "raw",
    /// The interpolated normal, normalised: displacement goes as far as it says everywhere.
    Unit = "unit",
    /// Normals interpolated by their angles, of length 1, too: along a side they turn evenly (Gumhold and
    /// Hüttner 1999, section 2.1, after Kuijk and Blake 1989).
    Angle = "angle",
}

choice! {
    /// The normals of the vertices.
    Shading, "shading normals":
    /// Of the bilinear surface and the base's frame, where the vertex lies, however coarse the mesh is.
    #[default]
    Exact = "exact",
    /// The same without what the direction of displacement turns by: equation 9 of Szirmay-Kalos and
    /// Umenhoffer 2008. It is off by as much as the relief is high beside the radius of a curved base.
    Derivative = "derivative",
    /// The interpolated normal, turned by two angles whose tangents are the slopes of the relief along `u`
    /// and `v`, as Kugler stores them in a map (Gumhold and Hüttner 1999, sections 1 and 2.1): exact on level
    /// ground whose texture has right angles, and off by what the base turns by and by how much the texture
    /// is sheared.
    Rotation = "rotation",
    /// Of the triangles that are made: the mean over those at a vertex, weighted by their angles there.
    Mesh = "mesh",
}

choice! {
    /// What becomes of edges along which the base's normals or texture coordinates differ.
    Seams, "seams":
    /// A position has one direction of displacement and one place on the map, so that the mesh is closed
    /// where its base is.
    #[default]
    Weld = "weld",
    /// Every side has its own, and gapes where they differ.
    Keep = "keep",
}

choice! {
    /// Where triangles are compared with the relief.
    Judge, "judge":
    /// Everywhere on the bilinear surface.
    #[default]
    Surface = "surface",
    /// At the centres of texels alone, as other programs do: between them the surface may be farther away.
    Texels = "texels",
}

choice! {
    /// Which heights the points get that are inserted where they are needed.
    Fit, "fit":
    /// Such that fewer triangles are enough: a little off the surface, within the tolerance.
    #[default]
    Heights = "heights",
    /// Those of the surface.
    None = "none",
}

choice! {
    /// On which side of the relief triangles lie that are made to a tolerance.
    Side, "side":
    /// On both, as far as the tolerance allows: the nearest.
    #[default]
    Both = "both",
    /// Above it or on it: nothing that stands on the triangles sinks into them.
    Above = "above",
    /// Below it or on it.
    Below = "below",
}

impl Side {
    /// The part of a tolerance that triangles are made to: above alone is the same as on both sides of a
    /// surface that is higher by half of it.
    pub(crate) fn part(self) -> f64 {
        if self == Self::Both { 1.0 } else { 0.5 }
    }

    /// The way that triangles are moved off the relief, along the displacement.
    pub(crate) fn sign(self) -> f64 {
        match self {
            Self::Both => 0.0,
            Self::Above => 1.0,
            Self::Below => -1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_lead_back_and_unknown_ones_to_the_nearest() {
        for seams in Seams::ALL {
            assert_eq!(seams.name().parse(), Ok(*seams));
        }
        assert_eq!(Directions::Unit.to_string().parse(), Ok(Directions::Unit));
        let unknown = "lft".parse::<BaseSurface>().expect_err("no such base");
        assert!(unknown.to_string().contains("lift"), "{unknown}");
    }
}
