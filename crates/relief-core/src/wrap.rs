//! Continuation of a height map beyond its edges.

use std::fmt;
use std::str::FromStr;

/// Continuation of a map beyond its edges. It belongs to the height map: every bake and every
/// method respects it.
///
/// The discriminants are the numbers that the shaders use.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum Wrap {
    /// The map is tiled: texel `W` is texel 0.
    #[default]
    Repeat = 0,
    /// The edge texels are repeated for ever: texel `W` is texel `W - 1`. The footprint is
    /// `[0, 1]²`.
    Clamp = 1,
    /// The map is tiled and every second tile is mirrored: texel `W` is texel `W - 1`, texel
    /// `W + 1` is texel `W - 2`.
    Mirror = 2,
}

impl Wrap {
    /// All wraps, in the order of the shaders' numbers.
    pub const ALL: [Wrap; 3] = [Wrap::Repeat, Wrap::Clamp, Wrap::Mirror];

    /// Returns the name of this wrap, as scenes spell it: `repeat`, `clamp` or `mirror`.
    pub const fn name(self) -> &'static str {
        match self {
            Wrap::Repeat => "repeat",
            Wrap::Clamp => "clamp",
            Wrap::Mirror => "mirror",
        }
    }

    /// Index of the texel in `0..size` at `index` after wrapping. `size` must not be 0.
    #[inline]
    pub const fn index(self, index: i64, size: u32) -> u32 {
        let size = size as i64;
        // Indices are nearly always inside. This path avoids a division.
        if 0 <= index && index < size {
            return index as u32;
        }
        let wrapped = match self {
            Wrap::Repeat => index.rem_euclid(size),
            Wrap::Clamp => {
                if index < 0 {
                    0
                } else if index >= size {
                    size - 1
                } else {
                    index
                }
            }
            Wrap::Mirror => {
                let folded = index.rem_euclid(2 * size);
                if folded < size { folded } else { 2 * size - 1 - folded }
            }
        };
        wrapped as u32
    }

    /// Indices of the texels at `index` and `index + 1` after wrapping. `size` must not be 0.
    #[inline]
    pub const fn pair(self, index: i64, size: u32) -> [u32; 2] {
        let first = self.index(index, size);
        let second = match self {
            Wrap::Repeat if first + 1 == size => 0,
            Wrap::Repeat => first + 1,
            Wrap::Clamp | Wrap::Mirror => self.index(index + 1, size),
        };
        [first, second]
    }
}

impl fmt::Display for Wrap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Wrap {
    type Err = UnknownWrap;

    fn from_str(name: &str) -> Result<Self, UnknownWrap> {
        Wrap::ALL.into_iter().find(|wrap| wrap.name() == name).ok_or_else(|| UnknownWrap(name.to_owned()))
    }
}

/// The name is not a wrap.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("unknown wrap '{0}': use repeat, clamp or mirror")]
pub struct UnknownWrap(String);

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn indices_continue_the_map_as_documented() {
        let row = |wrap: Wrap| (-4..7).map(|i| wrap.index(i, 3)).collect::<Vec<_>>();
        assert_eq!(row(Wrap::Repeat), [2, 0, 1, 2, 0, 1, 2, 0, 1, 2, 0]);
        assert_eq!(row(Wrap::Clamp), [0, 0, 0, 0, 0, 1, 2, 2, 2, 2, 2]);
        assert_eq!(row(Wrap::Mirror), [2, 2, 1, 0, 0, 1, 2, 2, 1, 0, 0]);
    }

    #[test]
    fn a_single_texel_is_everywhere() {
        for wrap in Wrap::ALL {
            assert!((-5..5).all(|i| wrap.index(i, 1) == 0), "{wrap}");
        }
    }
}
