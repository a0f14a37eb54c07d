//! Textures of named float channels to PNG and EXR files, row by row, with metadata inside the file; KTX2 is
//! in [`ktx2`](crate::ktx2).
//!
//! Writers *ask* for rows in the order of the file. Whoever holds the texels on disk can so write a texture
//! that no memory holds: a writer keeps a few rows, a band of 16 in EXR files.

mod exr;
mod metadata;
mod png;
mod read_metadata;

use std::io;

pub(crate) use self::exr::write_exr_lines_of;
pub use self::exr::{write_exr_lines, write_exr_rows};
pub use self::metadata::Metadata;
pub use self::png::{PngTexture, write_png_rows};
pub use self::read_metadata::read_metadata;

/// A row of texels of one channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Row {
    /// Mip level; 0 is the finest.
    pub level: u32,
    /// Slice of a volume; 0 in 2-D textures.
    pub slice: u32,
    /// Channel.
    pub channel: usize,
    /// Row from the top.
    pub row: u32,
}

/// Fills the slice, which is as long as the row, with its texels.
pub type RowSource<'a> = dyn FnMut(Row, &mut [f32]) -> io::Result<()> + 'a;

/// Takes the next row of a texture: of each channel its texels.
pub type LineSink<'a> = dyn FnMut(&[&[f32]]) -> io::Result<()> + 'a;

/// The code of an unsigned normalised integer with that maximum, to the nearest; what lies outside `[0, 1]`
/// is cut off and NaN becomes 0.
pub(crate) fn unorm_code(value: f32, most: u32) -> u32 {
    (f64::from(value).clamp(0.0, 1.0) * f64::from(most)).round() as u32
}
