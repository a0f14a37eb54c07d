//! Axis that points up in a mesh's file.

use std::fmt;
use std::str::FromStr;

use glam::Vec3;
use relief_core::registry::UnknownName;

use super::MeshFormat;

/// Axis that points up in a mesh's file. In memory it is `y`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Up {
    /// `y`, as in glTF, and mostly in OBJ and PLY.
    #[default]
    Y,
    /// `z`, as in STL, where slicers put a model on the plate as it is.
    Z,
}

/// Number of bytes at the beginning of a file that may hold the comment.
const HEAD: usize = 160;

impl Up {
    /// Both axes.
    pub const ALL: [Self; 2] = [Self::Y, Self::Z];

    /// Returns the name of this axis, as files and the command spell it: `y` or `z`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Y => "y",
            Self::Z => "z",
        }
    }

    /// Returns the usual axis of a format: `z` in STL, `y` in others.
    pub const fn usual(format: MeshFormat) -> Self {
        match format {
            MeshFormat::Stl => Self::Z,
            _ => Self::Y,
        }
    }

    /// Returns the axis of a file: from its own comment if Relief wrote it, otherwise the usual
    /// one.
    pub(super) fn of_file(format: MeshFormat, bytes: &[u8]) -> Self {
        let head = &bytes[..bytes.len().min(HEAD)];
        let says = |up: &Self| {
            let comment = comment(format, *up);
            head.windows(comment.len()).any(|part| part == comment.as_bytes())
        };
        let own = Self::ALL.into_iter().find(says).filter(|_| format != MeshFormat::Gltf);
        own.unwrap_or(Self::usual(format))
    }

    /// Converts a vector of the file to one with `y` up.
    pub fn with_y_up(self, vector: Vec3) -> Vec3 {
        match self {
            Self::Y => vector,
            // There is no negative zero.
            Self::Z => Vec3::new(vector.x, vector.z, 0.0 - vector.y),
        }
    }

    /// Converts a vector with `y` up to one of the file.
    pub fn stored(self, vector: Vec3) -> Vec3 {
        match self {
            Self::Y => vector,
            Self::Z => Vec3::new(vector.x, 0.0 - vector.z, vector.y),
        }
    }
}

/// Returns the comment that Relief writes into a file's head.
pub(super) fn comment(format: MeshFormat, up: Up) -> String {
    let unit = if format == MeshFormat::Stl { "millimetres" } else { "metres" };
    format!("Relief: a displaced mesh, in {unit}, {up} up")
}

impl fmt::Display for Up {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Up {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let known = Self::ALL.into_iter().find(|up| up.name().eq_ignore_ascii_case(name));
        known.ok_or_else(|| UnknownName::new("axis", name, Self::ALL.map(Self::name)))
    }
}
