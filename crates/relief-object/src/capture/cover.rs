//! What a texel's height is.

use std::fmt;
use std::str::FromStr;

use relief_core::registry::UnknownName;

/// What the height of a texel is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Cover {
    /// That of what the ray through its centre meets first.
    #[default]
    Centre,
    /// That of the highest point of the mesh in its square: nothing thin is lost, and silhouettes are up to a
    /// texel too wide.
    Pixel,
}

impl Cover {
    /// Both.
    pub const ALL: [Cover; 2] = [Cover::Centre, Cover::Pixel];

    /// The name on the command line.
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
