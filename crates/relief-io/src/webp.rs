//! Reader of WebP, 8 bit, lossy and lossless. Colour profiles are not applied. The first picture of
//! an animation is read.
//!
//! The decoder returns the whole picture at once: 3 or 4 bytes a texel, and as much again while it
//! decodes.

use image_webp::{DecodingError, WebPDecoder};

use crate::input::{Input, io_problem, zeros};
use crate::layout::{Format, Layout, SampleType, Sink, send_bytes};
use crate::omissions::{ANIMATION, Remark};
use crate::source::SourceReader;
use crate::{ReadProblem, exif};

/// Peak memory of the decoder per texel: the picture, and its planes or its codes.
const DECODER_BYTES: u64 = 12;

/// Memory limit of the decoder for chunks other than picture data.
const CHUNK_BYTES: usize = 16 << 20;

pub(crate) struct WebpFile<'a> {
    decoder: WebPDecoder<SourceReader<'a>>,
    layout: Layout,
}

impl<'a> WebpFile<'a> {
    pub(crate) fn open(input: Input<'a>) -> Result<Self, ReadProblem> {
        let Input { source, file, file_len, bytes_per_texel, max_bytes } = input;
        let mut decoder = WebPDecoder::new(file).map_err(problem)?;
        let size = decoder.dimensions().into();
        // The decoder owns the file; the remaining checks need a reader of their own.
        let input = Input { file: source.open()?.0, source, file_len, bytes_per_texel, max_bytes };
        let [width, height] = size;
        let texels = u64::from(width) * u64::from(height);
        input.check_size(Format::Webp, size, texels.saturating_mul(DECODER_BYTES) + file_len, 0)?;
        decoder.set_memory_limit(CHUNK_BYTES);
        let channels: &[&str] = if decoder.has_alpha() { &["r", "g", "b", "a"] } else { &["r", "g", "b"] };
        let mut layout = Layout::new(Format::Webp, size, channels, SampleType::unsigned(8));
        // Damaged metadata are ignored: the picture may be intact.
        let metadata = decoder.exif_metadata().ok().flatten();
        layout.stated_orientation = metadata.and_then(|metadata| exif::orientation(&metadata));
        if decoder.is_animated() {
            let text = "it is an animation: its first picture is read";
            layout.remarks.push(Remark::new(&ANIMATION, text));
        }
        Ok(Self { decoder, layout })
    }

    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    pub(crate) fn layout_mut(&mut self) -> &mut Layout {
        &mut self.layout
    }

    pub(crate) fn decode(mut self, channels: &[usize], sink: &mut Sink<'_>) -> Result<(), ReadProblem> {
        let per_texel = self.layout.channels.len();
        let row_len = self.layout.width as usize * per_texel;
        let mut bytes = zeros::<u8>(row_len * self.layout.height as usize)?;
        if self.decoder.output_buffer_size() != Some(bytes.len()) {
            return Err(ReadProblem::damaged("WebP", "its header contradicts itself"));
        }
        self.decoder.read_image(&mut bytes).map_err(problem)?;
        send_bytes(&bytes, [row_len, per_texel], channels, sink)
    }
}

fn problem(error: DecodingError) -> ReadProblem {
    match error {
        DecodingError::IoError(error) => io_problem(Format::Webp, error),
        other => ReadProblem::damaged("WebP", other),
    }
}
