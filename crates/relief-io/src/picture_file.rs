//! Writer of pictures, row by row, so that they need not fit into memory.

use std::io::{self, Seek, Write};
use std::path::Path;

use png::{BitDepth, ColorType};

use crate::jpeg_write::write_jpeg;
use crate::texture::{LineSink, unorm_code, write_exr_lines_of};
use crate::write::write_png;
use crate::write_whole::write_file;
use crate::{Metadata, WriteError, WriteProblem};

/// Format of a picture's file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum PictureFormat {
    /// PNG with 8 bits a sample, marked as sRGB.
    Png8,
    /// PNG with 16 bits a sample, marked as sRGB.
    Png16,
    /// EXR: linear 32-bit floats in the channels R, G and B, with the primaries of sRGB.
    Exr,
    /// JPEG of high quality, in sRGB, which programs assume.
    Jpeg,
}

impl PictureFormat {
    /// Whether colours are linear light of any amount. Otherwise they are sRGB from 0 to 1.
    pub const fn is_linear(self) -> bool {
        matches!(self, PictureFormat::Exr)
    }
}

/// Receiver of the next row of a picture: red, green and blue of each pixel.
pub type PictureSink<'a> = dyn FnMut(&[[f32; 3]]) -> io::Result<()> + 'a;

/// Writes a picture. `rows` passes the rows to its argument, from the top: linear or in sRGB,
/// depending on the [format](PictureFormat::is_linear). Values outside 0 to 1 are clamped if the
/// format cannot hold them.
///
/// # Errors
///
/// When the size is 0 or too large for the format, when `rows` fails or passes rows of a wrong
/// length or number, or when the file cannot be written. Nothing is left behind then.
pub fn write_picture(
    path: &Path,
    size: [u32; 2],
    format: PictureFormat,
    rows: impl FnOnce(&mut PictureSink) -> io::Result<()>,
) -> Result<(), WriteError> {
    write_file(path, |out| encode_picture(out, size, format, rows))
}

/// Writes the bytes of the file of [`write_picture`].
///
/// ```
/// use std::io::Cursor;
///
/// use relief_io::{DEFAULT_MAX_BYTES, PictureFormat, Source, encode_picture, read_picture};
///
/// let mut png = Cursor::new(Vec::new());
/// encode_picture(&mut png, [1, 1], PictureFormat::Png8, |sink| sink(&[[1.0, 0.0, 1.0]]))?;
/// let read = read_picture(Source::bytes("pixel.png", png.get_ref()), DEFAULT_MAX_BYTES)?;
/// assert_eq!(read.texels, [[1.0, 0.0, 1.0, 1.0]]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// See [`write_picture`].
pub fn encode_picture(
    out: &mut (impl Write + Seek + Send),
    size: [u32; 2],
    format: PictureFormat,
    rows: impl FnOnce(&mut PictureSink) -> io::Result<()>,
) -> Result<(), WriteProblem> {
    let [width, height] = size;
    match format {
        PictureFormat::Png8 | PictureFormat::Png16 => {
            let depth = if format == PictureFormat::Png8 { BitDepth::Eight } else { BitDepth::Sixteen };
            relief_core::HeightMap::check_size(width, height)
                .map_err(|error| WriteProblem::NotStorable(error.to_string()))?;
            write_png(out, size, ColorType::Rgb, depth, true, &Metadata::default(), |png| {
                let mut bytes = Vec::with_capacity(6 * width as usize);
                counted(size, rows, &mut |row| {
                    bytes.clear();
                    for sample in row.as_flattened() {
                        match depth {
                            BitDepth::Eight => bytes.push(unorm_code(*sample, 255) as u8),
                            _ => bytes.extend((unorm_code(*sample, 65535) as u16).to_be_bytes()),
                        }
                    }
                    png.write_all(&bytes)
                })
            })
        }
        PictureFormat::Exr => {
            let channels = ["R", "G", "B"];
            write_exr_lines_of(out, size, &channels, &Metadata::default(), true, |sink: &mut LineSink| {
                let mut planes = [0; 3].map(|_| Vec::with_capacity(width as usize));
                counted(size, rows, &mut |row| {
                    for (channel, plane) in planes.iter_mut().enumerate() {
                        plane.clear();
                        plane.extend(row.iter().map(|pixel| pixel[channel]));
                    }
                    sink(&planes.each_ref().map(Vec::as_slice))
                })
            })
        }
        PictureFormat::Jpeg => write_jpeg(out, size, |sink| {
            counted(size, rows, &mut |row| {
                sink(&mut row.as_flattened().iter().map(|sample| unorm_code(*sample, 255) as u8))
            })
        }),
    }
}

/// Passes rows on, and checks that they match the picture's size.
fn counted(
    [width, height]: [u32; 2],
    rows: impl FnOnce(&mut PictureSink) -> io::Result<()>,
    sink: &mut PictureSink,
) -> io::Result<()> {
    let wrong = |what: String| Err(io::Error::new(io::ErrorKind::InvalidInput, what));
    let mut count = 0;
    rows(&mut |row| {
        count += 1;
        if row.len() != width as usize || count > height {
            return wrong(format!("row {count} has {} pixels in a picture of {width}x{height}", row.len()));
        }
        sink(row)
    })?;
    if count == height { Ok(()) } else { wrong(format!("{count} rows for a picture of {width}x{height}")) }
}
