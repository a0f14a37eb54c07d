//! Picture of a TIFF with a checked header, decoded block by block.

use half::f16;
use tiff_reader::{Ifd, OpenOptions, ParseBudgets};

use super::halves;
use super::palette::Palette;
use super::stored::Stored;
use super::{GREY, TO_FLOATS, problem, unsupported};
use crate::ReadProblem;
use crate::input::Input;
use crate::layout::{Format, SampleKind, SampleType, Sink, Span};

/// Memory limit of the file's tags. The tables of the largest height map, with one row a strip,
/// need 16 MiB.
const MAX_TAG_BYTES: usize = 20 << 20;

/// Limits for all headers of a file.
pub(super) const PARSE_BUDGETS: ParseBudgets = ParseBudgets {
    max_ifds: 256,
    max_ifd_entries: 1024,
    max_tag_value_bytes: MAX_TAG_BYTES,
    max_metadata_value_bytes: MAX_TAG_BYTES,
};

/// Greatest number of texels that are passed on at once. A larger block is passed on in several
/// pieces from the cache.
const WINDOW_TEXELS: u32 = 1 << 16;

/// Greatest number of channels of a picture, whose blocks are used together.
const MAX_CHANNELS: u64 = 4;

pub(super) struct Raster<'a> {
    stored: Stored<'a>,
    decoder: tiff_reader::TiffFile,
    ifd: usize,
    /// Header for the decoder that replaces the file's.
    as_integers: Option<Ifd>,
    pub size: [u32; 2],
    pub bands: usize,
    pub sample: SampleType,
    blocks: Blocks,
    /// Value of a block that a sparse file omits; 0 if none.
    pub nodata: Option<f64>,
    /// Palette of the samples, if they have one.
    pub palette: Option<Palette>,
    /// Sample of white if grey is stored with white as 0 and passed on with black as 0.
    pub inverted_white: Option<f64>,
}

/// Division of the picture into blocks.
struct Blocks {
    columns: u32,
    rows: u32,
    /// Offset of each block in the file; 0 for a block that a sparse file omits.
    offsets: Vec<u64>,
    /// Whether each channel has blocks of its own.
    planar: bool,
}

impl<'a> Raster<'a> {
    /// Opens the picture with the given header and index.
    pub(super) fn open(
        input: &Input<'a>,
        stored: Stored<'a>,
        header: &Ifd,
        ifd: usize,
    ) -> Result<Self, ReadProblem> {
        let as_integers = halves::as_integers(header).map_err(problem)?;
        let raster = as_integers.as_ref().unwrap_or(header).raster_layout().map_err(problem)?;
        let size = [header.width(), header.height()];
        let sample = match as_integers {
            Some(_) => SampleType::float(16),
            None => sample_type(raster.sample_format, raster.bits_per_sample)?,
        };
        let (columns, rows) = if header.is_tiled() {
            (header.tile_width().unwrap_or(0), header.tile_height().unwrap_or(0))
        } else {
            (size[0], header.rows_per_strip().min(size[1]))
        };
        if columns == 0 || rows == 0 {
            return Err(ReadProblem::damaged("TIFF", "its blocks have no size"));
        }
        let planar = raster.planar_configuration == 2;
        let bands = raster.samples_per_pixel as u64;
        let (in_block, at_once) = if planar { (1, bands.min(MAX_CHANNELS)) } else { (bands, 1) };
        let block_bytes =
            (u64::from(columns) * u64::from(rows)).saturating_mul(in_block * raster.bytes_per_sample as u64);
        let count = u64::from(size[0].div_ceil(columns)) * u64::from(size[1].div_ceil(rows));
        let cache_bytes = block_bytes.saturating_mul(at_once);
        // Besides the cache, one compressed block is held. Each block has an entry of at least two
        // bytes in two tables.
        let least = if count > 1 { 4 * count } else { 0 };
        input.check_size(Format::Tiff, size, cache_bytes.saturating_add(block_bytes), least)?;

        let offsets = if header.is_tiled() { header.tile_offsets() } else { header.strip_offsets() };
        let offsets = offsets.ok_or_else(|| ReadProblem::damaged("TIFF", "it has no blocks"))?;
        let decoder = stored.decoder(options(cache_bytes)).map_err(problem)?;
        let blocks = Blocks { columns, rows, offsets, planar };
        Ok(Self {
            stored,
            decoder,
            ifd,
            as_integers,
            size,
            bands: raster.samples_per_pixel,
            sample,
            blocks,
            nodata: None,
            palette: Palette::read(header)?,
            inverted_white: None,
        })
    }

    pub(super) fn decode(&self, channels: &[usize], sink: &mut Sink<'_>) -> Result<(), ReadProblem> {
        let [width, height] = self.size;
        let (columns, rows) = (self.blocks.columns, self.blocks.rows);
        let rows_at_once = (WINDOW_TEXELS / columns.min(width)).clamp(1, rows);
        for top in (0..height).step_by(rows as usize) {
            for left in (0..width).step_by(columns as usize) {
                let block_columns = columns.min(width - left);
                let bottom = top.saturating_add(rows).min(height);
                for first in (top..bottom).step_by(rows_at_once as usize) {
                    let window = [[left, first], [block_columns, rows_at_once.min(bottom - first)]];
                    self.window(window, channels, sink)?;
                }
            }
        }
        Ok(())
    }

    /// Passes on a part of one block.
    fn window(
        &self,
        [[left, top], [columns, rows]]: [[u32; 2]; 2],
        channels: &[usize],
        sink: &mut Sink<'_>,
    ) -> Result<(), ReadProblem> {
        let [columns_len, rows_len] = [columns as usize, rows as usize];
        let mut samples = vec![0.0; columns_len * rows_len * channels.len()];
        for (slot, &channel) in channels.iter().enumerate() {
            let slots = samples[slot..].iter_mut().step_by(channels.len());
            if let (true, Some(nodata)) = (self.left_out(left, top, channel), self.nodata) {
                slots.for_each(|sample| *sample = nodata);
                continue;
            }
            let band = if self.palette.is_some() { 0 } else { channel };
            let place = (top as usize, left as usize);
            let read = || {
                let header = self.as_integers.as_ref().map_or_else(|| self.decoder.ifd(self.ifd), Ok)?;
                let (top, left) = place;
                self.decoder.read_band_window_bytes_from_ifd(header, band, top, left, rows_len, columns_len)
            };
            let bytes = self.stored.with_ranges(read).map_err(problem)?;
            spread(self.sample, &bytes, slots)?;
            if let Some(palette) = &self.palette {
                let slots = samples[slot..].iter_mut().step_by(channels.len());
                slots.for_each(|sample| *sample = palette.sample(channel, *sample));
            }
        }
        if let (Some(white), Some(slot)) =
            (self.inverted_white, channels.iter().position(|&channel| channel == GREY))
        {
            samples[slot..].iter_mut().step_by(channels.len()).for_each(|sample| *sample = white - *sample);
        }
        for (row, samples) in (top..).zip(samples.chunks_exact(columns_len * channels.len())) {
            sink(Span { row, column: left, step: 1, samples })?;
        }
        Ok(())
    }

    /// Whether a sparse file omits the block at a texel.
    fn left_out(&self, left: u32, top: u32, channel: usize) -> bool {
        let [width, height] = self.size;
        let across = width.div_ceil(self.blocks.columns) as usize;
        let down = height.div_ceil(self.blocks.rows) as usize;
        let plane = if self.blocks.planar { channel * across * down } else { 0 };
        let block = (top / self.blocks.rows) as usize * across + (left / self.blocks.columns) as usize;
        self.blocks.offsets.get(plane + block) == Some(&0)
    }
}

fn options(cache_bytes: u64) -> OpenOptions {
    let cache_bytes = usize::try_from(cache_bytes).unwrap_or(usize::MAX);
    OpenOptions {
        block_cache_bytes: cache_bytes,
        block_cache_slots: 16,
        parse_budgets: PARSE_BUDGETS,
        decode_output_bytes: cache_bytes.max(16 * WINDOW_TEXELS as usize),
    }
}

fn sample_type(format: u16, bits: u16) -> Result<SampleType, ReadProblem> {
    let kind = match format {
        1 => SampleKind::Unsigned,
        2 => SampleKind::Signed,
        _ => SampleKind::Float,
    };
    match (kind, bits) {
        (SampleKind::Unsigned, 1..=16 | 32 | 64)
        | (SampleKind::Signed, 8 | 16 | 32 | 64)
        | (SampleKind::Float, 16 | 32 | 64) => Ok(SampleType { kind, bits: bits as u8 }),
        _ => Err(unsupported(format!("{bits}-bit samples of format {format}"), TO_FLOATS)),
    }
}

/// Converts native-endian samples to numbers.
fn spread<'a>(
    sample: SampleType,
    bytes: &[u8],
    slots: impl ExactSizeIterator<Item = &'a mut f64>,
) -> Result<(), ReadProblem> {
    fn each<'a, const N: usize>(
        bytes: &[u8],
        slots: impl ExactSizeIterator<Item = &'a mut f64>,
        value: impl Fn([u8; N]) -> f64,
    ) -> bool {
        let fits = bytes.len() == slots.len() * N;
        slots.zip(bytes.as_chunks::<N>().0).for_each(|(slot, &bytes)| *slot = value(bytes));
        fits
    }
    let fits = match (sample.kind, sample.bits) {
        (SampleKind::Unsigned, 1..=8) => each(bytes, slots, |b: [u8; 1]| f64::from(b[0])),
        (SampleKind::Unsigned, 9..=16) => each(bytes, slots, |b| f64::from(u16::from_ne_bytes(b))),
        (SampleKind::Unsigned, 17..=32) => each(bytes, slots, |b| f64::from(u32::from_ne_bytes(b))),
        (SampleKind::Unsigned, _) => each(bytes, slots, |b| u64::from_ne_bytes(b) as f64),
        (SampleKind::Signed, 1..=8) => each(bytes, slots, |b| f64::from(i8::from_ne_bytes(b))),
        (SampleKind::Signed, 9..=16) => each(bytes, slots, |b| f64::from(i16::from_ne_bytes(b))),
        (SampleKind::Signed, 17..=32) => each(bytes, slots, |b| f64::from(i32::from_ne_bytes(b))),
        (SampleKind::Signed, _) => each(bytes, slots, |b| i64::from_ne_bytes(b) as f64),
        (SampleKind::Float, 1..=16) => each(bytes, slots, |b| f16::from_ne_bytes(b).to_f64()),
        (SampleKind::Float, 17..=32) => each(bytes, slots, |b| f64::from(f32::from_ne_bytes(b))),
        (SampleKind::Float, _) => each(bytes, slots, f64::from_ne_bytes),
    };
    if fits { Ok(()) } else { Err(ReadProblem::damaged("TIFF", "a block's length does not fit its size")) }
}
