//! Writers of pictures and float channels in one call, from samples in memory.

use std::io::{self, Write};
use std::path::Path;

use png::{BitDepth, ColorType, Encoder, EncodingError, SrgbRenderingIntent};
use relief_core::HeightMap;

use crate::write_whole::write_file;
use crate::{Metadata, WriteError, WriteProblem, write_exr_rows};

/// Channels of an 8-bit PNG.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PngColour {
    /// One sample a texel.
    Grey,
    /// Red, green and blue.
    Rgb,
    /// Red, green, blue and opacity.
    Rgba,
}

impl PngColour {
    /// Returns the number of samples per texel.
    pub const fn channels(self) -> usize {
        match self {
            PngColour::Grey => 1,
            PngColour::Rgb => 3,
            PngColour::Rgba => 4,
        }
    }
}

/// Writes an 8-bit PNG. `samples` are stored unchanged, row by row from the top, the channels of a
/// texel interleaved. For display they must be in sRGB.
///
/// # Errors
///
/// When `samples.len()` is not width times height times channels, when the size is 0 or above the
/// limit of a height map, or when the file cannot be written.
pub fn write_png8(
    path: &Path,
    width: u32,
    height: u32,
    colour: PngColour,
    samples: &[u8],
) -> Result<(), WriteError> {
    check_length(width, height, colour.channels(), samples.len()).map_err(|problem| problem.at(path))?;
    let colour = match colour {
        PngColour::Grey => ColorType::Grayscale,
        PngColour::Rgb => ColorType::Rgb,
        PngColour::Rgba => ColorType::Rgba,
    };
    write_file(path, |out| {
        write_png(out, [width, height], colour, BitDepth::Eight, false, &Metadata::default(), |png| {
            png.write_all(samples)
        })
    })
}

/// Writes a 16-bit grey PNG, row by row from the top.
///
/// # Errors
///
/// When `samples.len()` is not width times height, when the size is 0 or above the limit of a
/// height map, or when the file cannot be written.
pub fn write_png16(path: &Path, width: u32, height: u32, samples: &[u16]) -> Result<(), WriteError> {
    check_length(width, height, 1, samples.len()).map_err(|problem| problem.at(path))?;
    write_file(path, |out| {
        write_png(
            out,
            [width, height],
            ColorType::Grayscale,
            BitDepth::Sixteen,
            false,
            &Metadata::default(),
            |png| {
                let mut row_bytes = Vec::with_capacity(2 * width as usize);
                for row in samples.chunks_exact(width as usize) {
                    row_bytes.clear();
                    row_bytes.extend(row.iter().flat_map(|sample| sample.to_be_bytes()));
                    png.write_all(&row_bytes)?;
                }
                Ok(())
            },
        )
    })
}

/// Writes a PNG from encoded bytes, with metadata in `iTXt` chunks before them; `is_srgb` marks it
/// as sRGB.
pub(crate) fn write_png(
    out: impl Write,
    [width, height]: [u32; 2],
    colour: ColorType,
    depth: BitDepth,
    is_srgb: bool,
    metadata: &Metadata,
    rows: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), WriteProblem> {
    let problem = |error| match error {
        EncodingError::IoError(error) => WriteProblem::Io(error),
        other => WriteProblem::NotStorable(other.to_string()),
    };
    let mut encoder = Encoder::new(out, width, height);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    if is_srgb {
        encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    }
    for (key, value) in metadata.iter() {
        encoder.add_itxt_chunk(key.to_owned(), value.to_owned()).map_err(problem)?;
    }
    let mut writer = encoder.write_header().map_err(problem)?;
    let mut stream = writer.stream_writer().map_err(problem)?;
    rows(&mut stream)?;
    stream.finish().map_err(problem)?;
    writer.finish().map_err(problem)
}

/// Writes 32-bit float channels into an EXR file, without loss (ZIP, 16 rows a block).
///
/// Each channel has a name and `width * height` samples, row by row from the top. The same input
/// gives the same bytes. Channels are stored in the order of their names, as the format requires.
///
/// # Errors
///
/// When there is no channel; when a name is empty, longer than 255 bytes, not printable ASCII or
/// given twice; when a channel's length is not width times height; when the size is 0 or above the
/// limit of a height map; or when the file cannot be written.
pub fn write_exr(
    path: &Path,
    width: u32,
    height: u32,
    channels: &[(&str, &[f32])],
) -> Result<(), WriteError> {
    for (_, samples) in channels {
        check_length(width, height, 1, samples.len()).map_err(|problem| problem.at(path))?;
    }
    let names: Vec<&str> = channels.iter().map(|(name, _)| *name).collect();
    write_exr_rows(path, width, height, &names, &Metadata::default(), &mut |row, texels| {
        let start = row.row as usize * width as usize;
        texels.copy_from_slice(&channels[row.channel].1[start..start + width as usize]);
        Ok(())
    })
}

fn check_length(width: u32, height: u32, channels: usize, given: usize) -> Result<(), WriteProblem> {
    HeightMap::check_size(width, height).map_err(|error| WriteProblem::NotStorable(error.to_string()))?;
    let expected = u64::from(width) * u64::from(height) * channels as u64;
    if expected != given as u64 {
        return Err(WriteProblem::WrongLength { width, height, expected, given: given as u64 });
    }
    Ok(())
}
