//! Writer of PNG with 1 to 4 channels of 8 or 16 bit and metadata in `iTXt` chunks.

use std::io::{self, Write};
use std::path::Path;

use png::{BitDepth, ColorType};
use relief_core::HeightMap;

use super::{Metadata, Row, RowSource, unorm_code};
use crate::write::write_png;
use crate::write_whole::write_file;
use crate::{WriteError, WriteProblem};

/// Description of a PNG texture to write.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PngTexture {
    /// Width in texels.
    pub width: u32,
    /// Height in texels.
    pub height: u32,
    /// Number of channels: 1 grey, 2 grey and opacity, 3 colour, 4 colour and opacity.
    pub channels: usize,
    /// Bits per sample: 8 or 16.
    pub bits: u32,
}

/// Writes a PNG whose samples are texels in `[0, 1]`, rounded to the nearest code, without a
/// transfer function. Values outside `[0, 1]` are clamped. The metadata are `iTXt` chunks before
/// the texels.
///
/// # Errors
///
/// When the size, the channels, the bits or the metadata cannot be stored, when `rows` fails, or
/// when the file cannot be written. Nothing is left behind then.
pub fn write_png_rows(
    path: &Path,
    texture: &PngTexture,
    metadata: &Metadata,
    rows: &mut RowSource<'_>,
) -> Result<(), WriteError> {
    write_rows_of(path, texture, metadata, false, rows)
}

/// Writes a PNG like [`write_png_rows`], and marks its colours as sRGB. `rows` returns them in sRGB.
///
/// # Errors
///
/// See [`write_png_rows`].
pub fn write_png_colours(
    path: &Path,
    texture: &PngTexture,
    metadata: &Metadata,
    rows: &mut RowSource<'_>,
) -> Result<(), WriteError> {
    write_rows_of(path, texture, metadata, true, rows)
}

fn write_rows_of(
    path: &Path,
    texture: &PngTexture,
    metadata: &Metadata,
    is_srgb: bool,
    rows: &mut RowSource<'_>,
) -> Result<(), WriteError> {
    write_file(path, |out| {
        HeightMap::check_size(texture.width, texture.height)
            .map_err(|error| WriteProblem::NotStorable(error.to_string()))?;
        let colour = match texture.channels {
            1 => ColorType::Grayscale,
            2 => ColorType::GrayscaleAlpha,
            3 => ColorType::Rgb,
            4 => ColorType::Rgba,
            other => return Err(not_storable(format!("a PNG has 1 to 4 channels, not {other}"))),
        };
        let depth = match texture.bits {
            8 => BitDepth::Eight,
            16 => BitDepth::Sixteen,
            other => return Err(not_storable(format!("a PNG texture has 8 or 16 bit, not {other}"))),
        };
        write_png(out, [texture.width, texture.height], colour, depth, is_srgb, metadata, |mut stream| {
            write_rows(texture, rows, &mut stream)
        })
    })
}

fn write_rows(texture: &PngTexture, rows: &mut RowSource<'_>, stream: &mut impl Write) -> io::Result<()> {
    let bytes_per_sample = texture.bits as usize / 8;
    let step = texture.channels * bytes_per_sample;
    let mut texels = vec![0.0; texture.width as usize];
    let mut bytes = vec![0; texture.width as usize * step];
    for row in 0..texture.height {
        for channel in 0..texture.channels {
            rows(Row { level: 0, slice: 0, channel, row }, &mut texels)?;
            for (texel, place) in texels.iter().zip(bytes.chunks_exact_mut(step)) {
                let place = &mut place[channel * bytes_per_sample..][..bytes_per_sample];
                match texture.bits {
                    8 => place[0] = unorm_code(*texel, 255) as u8,
                    _ => place.copy_from_slice(&(unorm_code(*texel, 65535) as u16).to_be_bytes()),
                }
            }
        }
        stream.write_all(&bytes)?;
    }
    Ok(())
}

fn not_storable(what: String) -> WriteProblem {
    WriteProblem::NotStorable(what)
}
