//! Writers of textures of named float channels to PNG, EXR and DDS files, row by row, with metadata
//! inside the file. KTX2 is in [`ktx2`](crate::ktx2).
//!
//! Writers *request* rows in the order of the file. A caller with texels on disk can therefore
//! write a texture larger than memory: a writer holds a few rows, or a band of 16 in EXR files.

mod dds;
mod exr;
mod metadata;
mod png;
mod read_metadata;

use std::io;

pub use self::dds::write_dds;
pub(crate) use self::exr::write_exr_lines_of;
pub use self::exr::{encode_exr_lines, write_exr_lines, write_exr_rows};
pub use self::metadata::Metadata;
pub use self::png::{PngTexture, write_png_colours, write_png_rows};
pub use self::read_metadata::read_metadata;

/// Row of texels of one channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Row {
    /// Mip level; 0 is the finest.
    pub level: u32,
    /// Slice of a volume; 0 in 2-D textures.
    pub slice: u32,
    /// Index of the channel.
    pub channel: usize,
    /// Index of the row, from the top.
    pub row: u32,
}

/// Callback that fills a slice, as long as a row, with the row's texels.
pub type RowSource<'a> = dyn FnMut(Row, &mut [f32]) -> io::Result<()> + 'a;

/// Receiver of the next row of a texture: the texels of each channel.
pub type LineSink<'a> = dyn FnMut(&[&[f32]]) -> io::Result<()> + 'a;

/// Encodes a value as an unsigned normalised integer with maximum `most`, rounded to the nearest.
/// Values outside `[0, 1]` are clamped, and NaN becomes 0.
pub(crate) fn unorm_code(value: f32, most: u32) -> u32 {
    (f64::from(value).clamp(0.0, 1.0) * f64::from(most)).round() as u32
}
