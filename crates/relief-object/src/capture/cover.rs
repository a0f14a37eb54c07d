//! Height of a texel in a captured image.

use std::fmt;
use std::str::FromStr;

use relief_core::registry::UnknownName;

/// Point of the mesh whose height a texel stores.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Cover {
    /// The first hit of the ray through the texel's centre.
    #[default]
    Centre,
    /// The highest point of the mesh in the texel's square. Nothing thin is lost, but silhouettes
    /// are up to a texel too wide.
    Pixel,
}

impl Cover {
    /// Both covers.
    pub const ALL: [Cover; 2] = [Cover::Centre, Cover::Pixel];

    /// Returns the name of this cover, as files and the command spell it: `centre` or `pixel`.
    pub const fn name(self) -> &'static str {
        match self {
            Cover::Centre => "centre",
            Cover::Pixel => "pixel",
        }
    }
}

impl fmt::Display for Cover {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Cover {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let known = Self::ALL.into_iter().find(|cover| cover.name() == name);
        known.ok_or_else(|| UnknownName::new("cover", name, Self::ALL.map(Self::name)))
    }
}
