//! Reader of PNG, row by row: grey, grey with alpha, colour, colour with alpha and palettes, 1 to
//! 16 bit, also interlaced.
//!
//! Samples are read as stored. Of the chunks about colours, only a declaration of linear samples is
//! used, for pictures.

mod chunks;

use std::io::{Read, Seek};

use png::{BitDepth, ColorType, Decoder, DecodingError, Limits, Reader, Transformations};

use self::chunks::Chunks;
use crate::ReadProblem;
use crate::input::{Input, io_problem};
use crate::layout::{Format, Layout, SampleType, Sink, Span};
use crate::omissions::{ANIMATION, LONG_OPACITY, Remark};
use crate::source::SourceReader;

/// Memory limit of the decoder for chunks other than image data. A row of the widest height map
/// needs half of it.
const DECODER_BYTES: usize = 16 << 20;

/// Greatest ratio of Deflate: one byte expands to at most 1032.
const DEFLATE_RATIO: u64 = 1032;

/// Left-most column, top row, column step and row step of each of the seven passes of Adam7 (PNG
/// specification, 8.2).
const ADAM7: [[u32; 4]; 7] =
    [[0, 0, 8, 8], [4, 0, 8, 8], [0, 4, 4, 8], [2, 0, 4, 4], [0, 2, 2, 4], [1, 0, 2, 2], [0, 1, 1, 2]];

pub(crate) struct PngFile<'a> {
    reader: Reader<SourceReader<'a>>,
    layout: Layout,
    /// Factor by which the decoder has multiplied samples of less than 8 bit, to fill 8 bit.
    expansion: u8,
}

impl<'a> PngFile<'a> {
    pub(crate) fn open(input: Input<'a>) -> Result<Self, ReadProblem> {
        // The decoder owns the file, and the size must be known before the decoder continues.
        // Therefore the header is read twice, first directly. It is at a fixed position: after the
        // signature, in the IHDR chunk (PNG specification, 5.6).
        let (mut input, header) = Header::read(input)?;
        let chunks = Chunks::read(&mut input.file);
        input.file.rewind()?;
        let row_bytes = (u64::from(header.width) * u64::from(header.bits_per_texel)).div_ceil(8) + 1;
        let least = row_bytes.saturating_mul(u64::from(header.height)) / DEFLATE_RATIO;
        input.check_size(Format::Png, [header.width, header.height], DECODER_BYTES as u64, least)?;

        let mut decoder = Decoder::new_with_limits(input.file, Limits { bytes: DECODER_BYTES });
        decoder.set_transformations(Transformations::EXPAND);
        decoder.set_ignore_text_chunk(true);
        decoder.set_ignore_iccp_chunk(true);
        let reader = decoder.read_info().map_err(problem)?;
        let info = reader.info();
        let stored_bits = match info.color_type {
            ColorType::Grayscale => info.bit_depth as u8,
            _ => (info.bit_depth as u8).max(8),
        };
        let expansion = match stored_bits {
            1 => 255,
            2 => 85,
            4 => 17,
            _ => 1,
        };
        let channels: &[&str] = match reader.output_color_type().0 {
            ColorType::Grayscale => &["y"],
            ColorType::GrayscaleAlpha => &["y", "a"],
            ColorType::Rgb | ColorType::Indexed => &["r", "g", "b"],
            ColorType::Rgba => &["r", "g", "b", "a"],
        };
        let size = [info.width, info.height];
        let mut layout = Layout::new(Format::Png, size, channels, SampleType::unsigned(stored_bits));
        layout.stated_orientation = chunks.orientation;
        layout.is_linear = chunks.is_linear;
        if chunks.is_animated {
            let text = "it is an animation: its still picture is read";
            layout.remarks.push(Remark::new(&ANIMATION, text));
        }
        if let Some([bytes, most]) = chunks.long_opacity {
            let text = format!(
                "its opacity (chunk tRNS) has {bytes} bytes, but its colours allow {most}: it is applied in \
                 part, or not at all"
            );
            layout.remarks.push(Remark::new(&LONG_OPACITY, text));
        }
        Ok(Self { reader, layout, expansion })
    }

    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    pub(crate) fn layout_mut(&mut self) -> &mut Layout {
        &mut self.layout
    }

    pub(crate) fn decode(mut self, channels: &[usize], sink: &mut Sink<'_>) -> Result<(), ReadProblem> {
        let (width, height) = (self.layout.width, self.layout.height);
        let passes: &[[u32; 4]] = if self.reader.info().interlaced { &ADAM7 } else { &[[0, 0, 1, 1]] };
        let mut samples = Vec::with_capacity(width as usize * channels.len());
        for &[left, top, column_step, row_step] in passes {
            let columns = width.saturating_sub(left).div_ceil(column_step);
            if columns == 0 {
                continue;
            }
            for row in (top..height).step_by(row_step as usize) {
                self.read_row(columns as usize, channels, &mut samples)?;
                sink(Span { row, column: left, step: column_step, samples: &samples })?;
            }
        }
        self.reader.finish().map_err(problem)
    }

    fn read_row(
        &mut self,
        columns: usize,
        channels: &[usize],
        samples: &mut Vec<f64>,
    ) -> Result<(), ReadProblem> {
        let (_, depth) = self.reader.output_color_type();
        let per_texel = self.layout.channels.len();
        let row = self.reader.next_interlaced_row().map_err(problem)?;
        let data = row.as_ref().map_or(&[][..], |row| row.data());
        let sample_bytes = if depth == BitDepth::Sixteen { 2 } else { 1 };
        if data.len() != columns * per_texel * sample_bytes {
            return Err(ReadProblem::damaged("PNG", "a row is missing or has a wrong length"));
        }
        samples.clear();
        for texel in data.chunks_exact(per_texel * sample_bytes) {
            for &channel in channels {
                samples.push(if sample_bytes == 2 {
                    f64::from(u16::from_be_bytes([texel[2 * channel], texel[2 * channel + 1]]))
                } else {
                    f64::from(texel[channel] / self.expansion)
                });
            }
        }
        Ok(())
    }
}

/// Part of the IHDR chunk with the picture's size.
struct Header {
    width: u32,
    height: u32,
    bits_per_texel: u32,
}

impl Header {
    fn read(mut input: Input<'_>) -> Result<(Input<'_>, Self), ReadProblem> {
        let mut bytes = [0; 26];
        input.file.read_exact(&mut bytes).map_err(|error| io_problem(Format::Png, error))?;
        input.file.rewind()?;
        if bytes[12..16] != *b"IHDR" {
            return Err(ReadProblem::damaged("PNG", "it does not begin with its header"));
        }
        let number = |at: usize| u32::from_be_bytes([bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]]);
        let samples = match bytes[25] {
            0 | 3 => 1,
            2 => 3,
            4 => 2,
            6 => 4,
            other => {
                return Err(ReadProblem::damaged("PNG", format!("unknown colour type {other}")));
            }
        };
        let header =
            Self { width: number(16), height: number(20), bits_per_texel: samples * u32::from(bytes[24]) };
        Ok((input, header))
    }
}

fn problem(error: DecodingError) -> ReadProblem {
    match error {
        DecodingError::IoError(error) => io_problem(Format::Png, error),
        other => ReadProblem::damaged("PNG", other),
    }
}
