//! Settings with a few named choices each.

use std::fmt;
use std::str::FromStr;

use relief_core::registry::UnknownName;

/// Defines an enumeration with names for the command line. Errors of unknown names suggest the
/// nearest.
macro_rules! choice {
    ($(#[$about:meta])* $name:ident, $kind:literal: $($(#[$of:meta])* $variant:ident = $text:literal,)+) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
        pub enum $name {
            $($(#[$of])* $variant,)+
        }

        impl $name {
            /// All choices, in the order in which help lists them.
            pub const ALL: &[Self] = &[$(Self::$variant),+];

            /// Returns the name on the command line.
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
    /// Surface that is displaced.
    BaseSurface, "base surface":
    /// The triangles as they are.
    #[default]
    Flat = "flat",
    /// Smooth surface implied by the mesh's normals: see
    /// [`Mesh::lifts`](relief_core::mesh::Mesh::lifts).
    Lift = "lift",
    /// Cubic triangles through the corners, perpendicular to the normals there. This is the smooth
    /// base that Gumhold and Hüttner 1999 ask for (section 6). It is made of the curved
    /// point-normal triangles of Vlachos, Peters, Boyd and Mitchell 2001 (section 3). A side
    /// depends on its two ends alone.
    Pn = "pn",
}

choice! {
    /// Direction along which a point of a triangle is displaced.
    Directions, "directions":
    /// The interpolated normal, not normalised, as in the exact tracer of displaced meshes and the
    /// surface `prism`.
    #[default]
    Raw = "raw",
    /// The interpolated normal, normalised: a displacement has its full length everywhere.
    Unit = "unit",
    /// Normals interpolated by their angles, also of length 1. Along a side they turn evenly
    /// (Gumhold and Hüttner 1999, section 2.1, after Kuijk and Blake 1989).
    Angle = "angle",
}

choice! {
    /// Method that computes the normals of the vertices.
    Shading, "shading normals":
    /// Normals of the bilinear surface in the base's frame at the vertex, however coarse the mesh
    /// is.
    #[default]
    Exact = "exact",
    /// Like [`Exact`](Self::Exact), but ignores that the direction of displacement turns: equation
    /// 9 of Szirmay-Kalos and Umenhoffer 2008. The error grows with the relief's height relative to
    /// the radius of a curved base.
    Derivative = "derivative",
    /// The interpolated normal, turned by two angles. Their tangents are the slopes of the relief
    /// along `u` and `v`, as Kugler stores them in a map (Gumhold and Hüttner 1999, sections 1 and
    /// 2.1). It is exact on level ground whose texture has right angles. Elsewhere it is off by the
    /// turning of the base and the shear of the texture.
    Rotation = "rotation",
    /// Mean of the normals of the triangles at a vertex, weighted by their angles there.
    Mesh = "mesh",
    /// Normals and tangents of the base, for a normal map that has the relief's.
    Base = "base",
}

choice! {
    /// Treatment of edges along which the base's normals or texture coordinates differ.
    Seams, "seams":
    /// Each position has one direction of displacement and one place on the map. The mesh is closed
    /// where its base is.
    #[default]
    Weld = "weld",
    /// Each side has its own direction and place. The sides gape where these differ.
    Keep = "keep",
}

choice! {
    /// Places at which triangles are compared with the relief.
    Judge, "judge":
    /// Everywhere on the bilinear surface.
    #[default]
    Surface = "surface",
    /// At the centres of texels alone, as in other programs. Between them the surface may be
    /// farther away.
    Texels = "texels",
}

choice! {
    /// Heights of the points that are inserted where the tolerance needs them.
    Fit, "fit":
    /// Heights that need fewer triangles: a little off the surface, within the tolerance.
    #[default]
    Heights = "heights",
    /// Heights of the surface.
    None = "none",
}

choice! {
    /// Side of the relief on which triangles lie that are made to a tolerance.
    Side, "side":
    /// Both sides, as far as the tolerance allows: the nearest fit.
    #[default]
    Both = "both",
    /// Above the relief or on it. Objects that stand on the triangles do not sink into the relief.
    Above = "above",
    /// Below the relief or on it.
    Below = "below",
}

impl Side {
    /// Returns the part of the tolerance to which triangles are made. `Above` equals `Both` on a
    /// surface that is higher by half the tolerance.
    pub(crate) fn part(self) -> f64 {
        if self == Self::Both { 1.0 } else { 0.5 }
    }

    /// Returns the sign of the triangles' offset from the relief along the displacement; 0 for
    /// none.
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
