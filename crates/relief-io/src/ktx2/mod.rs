//! KTX 2.0 textures (Khronos "KTX File Format Specification", version 2.0): 2-D textures with mip chains, and
//! volumes.
//!
//! [`write_ktx2`] writes what GPUs take as it is; [`read_ktx2`] gives back the values that a GPU would read.
//! The containers' numbers are laid out by the `ktx2` crate.
//!
//! Why not the `ctt` crate, which writes such files, too: it holds all levels of a texture at once,
//! uncompressed and compressed, and volumes need to stream. Here texels are asked for row by row in the order
//! of the file, which has its smallest level first, and go through the Zstandard compressor, one frame a
//! level, straight into the file. A writer holds a row of texels (four of block-compressed formats), and 1
//! MiB with Zstandard, whatever the size.

mod blocks;
mod format;
mod read;
mod write;

pub use self::format::TexelFormat;
pub use self::read::{Ktx2File, Ktx2Level, read_ktx2};
pub use self::write::{Ktx2Texture, write_ktx2};

pub(crate) use self::read::metadata;

/// Size of a mip level, as the specification has it: halves rounded down, at least 1.
pub(crate) fn level_size(size: [u32; 3], level: u32) -> [u32; 3] {
    size.map(|side| side.checked_shr(level).unwrap_or(0).max(1))
}

/// Levels of the whole chain, down to a single texel.
pub(crate) fn full_chain(size: [u32; 3]) -> u32 {
    size.into_iter().fold(1, u32::max).ilog2() + 1
}
