//! What a picture can show besides the light of a scene: numbers of its pixels, and
//! errors beside the exact one.

use relief_core::registry::UnknownName;
use std::fmt;
use std::str::FromStr;

/// What is shown of a picture.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Shown {
    /// The picture itself.
    #[default]
    Picture,
    /// Metres from the base to the surface.
    Height,
    /// Metres along the view axis.
    Depth,
    /// Normal in the world.
    Normal,
    /// Reads of maps.
    Reads,
    /// Steps of the search.
    Steps,
    /// Distance of the hit from the exact one, in texels.
    Error,
    /// Where the ray has passed the exact hit.
    Passed,
    /// Difference of the colour from the exact picture's.
    ColorError,
    /// FLIP: the difference from the exact picture that an eye sees.
    Flip,
    /// Share of the first light that arrives.
    Lit,
    /// Level of detail.
    Level,
}

impl Shown {
    /// All that can be shown, in the order in which lists have it.
    pub const ALL: [Shown; 12] = [
        Self::Picture,
        Self::Height,
        Self::Depth,
        Self::Normal,
        Self::Reads,
        Self::Steps,
        Self::Error,
        Self::Passed,
        Self::ColorError,
        Self::Flip,
        Self::Lit,
        Self::Level,
    ];

    /// Returns the name, as files and the command spell it: `picture` to `level`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Picture => "picture",
            Self::Height => "height",
            Self::Depth => "depth",
            Self::Normal => "normal",
            Self::Reads => "reads",
            Self::Steps => "steps",
            Self::Error => "error",
            Self::Passed => "passed",
            Self::ColorError => "color-error",
            Self::Flip => "flip",
            Self::Lit => "lit",
            Self::Level => "level",
        }
    }

    /// Returns what it is, in one line.
    pub const fn about(self) -> &'static str {
        match self {
            Self::Picture => "the picture itself",
            Self::Height => "height over the base in metres",
            Self::Depth => "depth along the view in metres",
            Self::Normal => "normal in the world, x, y and z as red, green and blue",
            Self::Reads => "reads of maps, or nodes of the exact tracer",
            Self::Steps => "steps of the search, or cells of the exact tracer",
            Self::Error => "distance from the exact hit in texels",
            Self::Passed => {
                "rays that passed the exact hit: they miss it, or hit more than half a texel behind it"
            }
            Self::ColorError => "difference of the colour from the exact picture, in linear light",
            Self::Flip => "FLIP, the difference from the exact picture that an eye sees",
            Self::Lit => "share of the first light that arrives",
            Self::Level => "level of detail, 0 is the finest",
        }
    }
}

impl fmt::Display for Shown {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Shown {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let found = Self::ALL.into_iter().find(|shown| shown.name() == name);
        found.ok_or_else(|| UnknownName::new("quantity", name, Self::ALL.map(Self::name)))
    }
}
