//! Reader and writer of KTX 2.0 textures (Khronos "KTX File Format Specification", version 2.0):
//! 2-D textures with mip chains, and volumes.
//!
//! [`write_ktx2`] writes textures that GPUs use without conversion. [`read_ktx2`] returns the
//! values that a GPU would read. The `ktx2` crate lays out the container's numbers.
//!
//! The `ctt` crate writes such files, too, but holds all levels of a texture at once, uncompressed
//! and compressed. Volumes need to stream. Here texels are requested row by row in the order of the
//! file, which has its smallest level first. They go through the Zstandard compressor, one frame a
//! level, straight into the file. A writer holds a row of texels (four of block-compressed
//! formats), and 1 MiB with Zstandard, for any size.

mod blocks;
mod format;
mod read;
mod volume;
mod write;

pub use self::format::TexelFormat;
pub use self::read::{Ktx2File, Ktx2Level, read_ktx2};
pub use self::volume::{VolumeFile, VolumeFormat, VolumeOptions, read_volume, write_volume};
pub use self::write::{Ktx2Texture, write_ktx2};

pub(crate) use self::read::metadata;

/// Size of a mip level by the specification: halves rounded down, at least 1.
pub(crate) fn level_size(size: [u32; 3], level: u32) -> [u32; 3] {
    size.map(|side| side.checked_shr(level).unwrap_or(0).max(1))
}

/// Number of levels of the whole chain, down to a single texel.
pub(crate) fn full_chain(size: [u32; 3]) -> u32 {
    size.into_iter().fold(1, u32::max).ilog2() + 1
}
