//! Which axis of a mesh's file points up.

use std::fmt;
use std::str::FromStr;

use glam::Vec3;
use relief_core::registry::UnknownName;

use super::MeshFormat;

/// Which axis of a mesh's file points up. In memory it is `y`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Up {
    /// `y`, as in glTF, and mostly in OBJ and PLY.
    #[default]
    Y,
    /// `z`, as in STL, where slicers put a model on the plate as it is.
    Z,
}

/// The bytes of a file that may hold the comment of its first lines.
const HEAD: usize = 160;

impl Up {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Y, Self::Z];

    /// The name used on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Y => "y",
            Self::Z => "z",
        }
    }

    /// What points up in files of a format that do not say it: `z` in STL, `y` in others.
    pub const fn usual(format: MeshFormat) -> Self {
        match format {
            MeshFormat::Stl => Self::Z,
            _ => Self::Y,
        }
    }

    /// What points up in a file, by its own comment if this program wrote it, else as is usual.
    pub(super) fn of_file(format: MeshFormat, bytes: &[u8]) -> Self {
        let head = &bytes[..bytes.len().min(HEAD)];
        let says = |up: &Self| {
            let comment = comment(format, *up);
            head.windows(comment.len()).any(|part| part == comment.as_bytes())
        };
        let own = Self::ALL.into_iter().find(says).filter(|_| format != MeshFormat::Gltf);
        own.unwrap_or(Self::usual(format))
    }

    /// A vector of such a file, as it is with `y` up.
    pub fn with_y_up(self, vector: Vec3) -> Vec3 {
        match self {
            Self::Y => vector,
            // There is no negative zero.
            Self::Z => Vec3::new(vector.x, vector.z, 0.0 - vector.y),
        }
    }

    /// A vector that has `y` up, as such a file has it.
    pub fn stored(self, vector: Vec3) -> Vec3 {
        match self {
            Self::Y => vector,
            Self::Z => Vec3::new(vector.x, 0.0 - vector.z, vector.y),
        }
    }
}

/// What this program writes into a file's head.
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
