//! Reader of JPEG: 8 bit, grey and colour. Samples are the decoded ones; colour profiles are not
//! applied.
//!
//! The decoder returns the whole picture at once: 1 or 3 bytes a texel, and for a progressive file
//! twice as much in addition while it is decoded. It also takes a cut-off file for a complete one.
//! Therefore the file's segments are walked first: size and components are known, and the end is
//! present, before memory is allocated.

use std::io::{BufRead, Read, Seek};

use image::codecs::jpeg::JpegDecoder;
use image::{ImageDecoder, ImageError};

use crate::input::{Input, io_problem, zeros};
use crate::layout::{Format, Layout, SampleType, Sink, send_bytes};
use crate::source::SourceReader;
use crate::{ReadProblem, exif};

/// Marker of EXIF metadata, and of other data.
const APP1: u8 = 0xe1;

pub(crate) struct JpegFile<'a> {
    file: SourceReader<'a>,
    layout: Layout,
}

impl<'a> JpegFile<'a> {
    pub(crate) fn open(mut input: Input<'a>) -> Result<Self, ReadProblem> {
        let frame = Frame::read(&mut input.file)?;
        let texels = u64::from(frame.width) * u64::from(frame.height);
        let components = u64::from(frame.components);
        let decoder_bytes = texels * components * if frame.progressive { 3 } else { 1 } + input.file_len;
        // A block of 8x8 texels takes at least one bit.
        let least = texels / 512;
        input.check_size(Format::Jpeg, [frame.width, frame.height], decoder_bytes, least)?;
        input.file.rewind()?;
        let channels: &[&str] = if frame.components == 1 { &["y"] } else { &["r", "g", "b"] };
        let size = [frame.width, frame.height];
        let mut layout = Layout::new(Format::Jpeg, size, channels, SampleType::unsigned(8));
        layout.stated_orientation = frame.orientation;
        Ok(Self { file: input.file, layout })
    }

    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    pub(crate) fn layout_mut(&mut self) -> &mut Layout {
        &mut self.layout
    }

    pub(crate) fn decode(self, channels: &[usize], sink: &mut Sink<'_>) -> Result<(), ReadProblem> {
        let decoder = JpegDecoder::new(self.file).map_err(problem)?;
        let per_texel = self.layout.channels.len();
        let size = (self.layout.width, self.layout.height);
        if decoder.dimensions() != size || usize::from(decoder.color_type().channel_count()) != per_texel {
            return Err(damaged("its header contradicts itself"));
        }
        let row_len = size.0 as usize * per_texel;
        let mut bytes = zeros::<u8>(row_len * size.1 as usize)?;
        decoder.read_image(&mut bytes).map_err(problem)?;
        send_bytes(&bytes, [row_len, per_texel], channels, sink)
    }
}

/// Frame header (ITU T.81, B.2.2).
struct Frame {
    width: u32,
    height: u32,
    components: u8,
    progressive: bool,
    /// Orientation number in EXIF metadata, of any value.
    orientation: Option<u32>,
}

impl Frame {
    /// Walks all segments to the end of the picture (ITU T.81, B.1.1).
    fn read(file: &mut SourceReader<'_>) -> Result<Self, ReadProblem> {
        let (mut frame, mut orientation) = (None, None);
        bytes::<2>(file)?;
        loop {
            match next_marker(file)? {
                0xd9 => {
                    let frame = frame.ok_or_else(|| damaged("it has no frame header"))?;
                    return Ok(Self { orientation, ..frame });
                }
                // Restart markers, and one marker for private use in arithmetic coding, have no
                // length.
                0x01 | 0xd0..=0xd8 => {}
                marker => {
                    let length = u16::from_be_bytes(bytes(file)?);
                    let mut rest = length.checked_sub(2).ok_or_else(|| damaged("a segment is too short"))?;
                    // These are all frame headers; DHT (c4), JPG (c8) and DAC (cc) share their
                    // range.
                    if matches!(marker, 0xc0..=0xcf) && !matches!(marker, 0xc4 | 0xc8 | 0xcc) {
                        let [precision, h1, h0, w1, w0, components] = bytes(file)?;
                        rest = rest.checked_sub(6).ok_or_else(|| damaged("its frame header is too short"))?;
                        frame = Some(Self::check(marker, precision, [w1, w0], [h1, h0], components)?);
                    } else if marker == APP1 && orientation.is_none() {
                        let mut metadata = zeros::<u8>(usize::from(rest))?;
                        file.read_exact(&mut metadata).map_err(io)?;
                        orientation = Some(metadata)
                            .filter(|metadata| metadata.starts_with(exif::HEAD))
                            .and_then(|metadata| exif::orientation(&metadata));
                        rest = 0;
                    }
                    file.seek_relative(i64::from(rest)).map_err(io)?;
                }
            }
        }
    }

    fn check(
        marker: u8,
        precision: u8,
        width: [u8; 2],
        height: [u8; 2],
        components: u8,
    ) -> Result<Self, ReadProblem> {
        if precision != 8 || !matches!(marker, 0xc0..=0xc2) {
            let what = format!("{precision}-bit JPEG of kind {}", marker - 0xc0);
            let advice = "export it as baseline or progressive JPEG with 8 bit, or as PNG";
            return Err(ReadProblem::Unsupported { what, advice });
        }
        if !matches!(components, 1 | 3 | 4) {
            return Err(damaged("its number of components is not 1, 3 or 4"));
        }
        Ok(Self {
            width: u32::from(u16::from_be_bytes(width)),
            height: u32::from(u16::from_be_bytes(height)),
            components,
            progressive: marker == 0xc2,
            orientation: None,
        })
    }
}

/// Skips to the next marker. In entropy-coded data a zero byte follows each ff that is not a
/// marker.
fn next_marker(file: &mut SourceReader<'_>) -> Result<u8, ReadProblem> {
    loop {
        let buffer = file.fill_buf().map_err(io)?;
        if buffer.is_empty() {
            return Err(damaged("it ends too early"));
        }
        match buffer.iter().position(|&byte| byte == 0xff) {
            None => {
                let len = buffer.len();
                file.consume(len);
            }
            Some(at) => {
                file.consume(at + 1);
                // Any number of ff bytes may precede a marker.
                let mut marker = bytes::<1>(file)?;
                while marker == [0xff] {
                    marker = bytes(file)?;
                }
                if marker != [0] {
                    return Ok(marker[0]);
                }
            }
        }
    }
}

fn bytes<const N: usize>(file: &mut SourceReader<'_>) -> Result<[u8; N], ReadProblem> {
    let mut bytes = [0; N];
    file.read_exact(&mut bytes).map_err(io)?;
    Ok(bytes)
}

fn io(error: std::io::Error) -> ReadProblem {
    io_problem(Format::Jpeg, error)
}

fn damaged(what: &str) -> ReadProblem {
    ReadProblem::damaged("JPEG", what)
}

fn problem(error: ImageError) -> ReadProblem {
    match error {
        ImageError::IoError(error) => io(error),
        other => ReadProblem::damaged("JPEG", other),
    }
}
