//! A hash that identifies the heights of a map.

use std::fmt;

/// BLAKE3 hash of a height map's size and texels: width and height as `u32`, then the texels as
/// `f32`, all little-endian. Wrap, displacement and metadata are not hashed.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct HeightsHash(pub [u8; 32]);

/// Number of texels hashed at once.
const CHUNK: usize = 1 << 14;

impl HeightsHash {
    /// Hashes texels, row by row from the top.
    pub(crate) fn of(width: u32, height: u32, texels: &[f32]) -> Self {
        let mut hasher = blake3::Hasher::new();
        hasher.update(&width.to_le_bytes());
        hasher.update(&height.to_le_bytes());
        let mut bytes = Vec::with_capacity(4 * CHUNK);
        for texels in texels.chunks(CHUNK) {
            bytes.clear();
            bytes.extend(texels.iter().flat_map(|texel| texel.to_le_bytes()));
            hasher.update(&bytes);
        }
        Self(hasher.finalize().into())
    }
}

/// Writes the hash in hexadecimal digits.
impl fmt::Display for HeightsHash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|byte| write!(f, "{byte:02x}"))
    }
}

impl fmt::Debug for HeightsHash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "HeightsHash({self})")
    }
}
