//! Reader of EXR, block by block: f16, f32 and u32 channels of flat scan line and tiled parts. All
//! compressions are read, except HTJ2K, LJ2K and ZSTD.
//!
//! The header is parsed in [`header`], because the `exr` crate allocates what an unchecked header
//! claims. Chunks are located and checked here, too; the crate only decompresses them.

mod dwa;
mod header;
mod part;

use std::io::{Read, Seek, SeekFrom};

use exr::block::UncompressedBlock;
use exr::block::chunk::{
    Chunk, CompressedBlock, CompressedScanLineBlock, CompressedTileBlock, TileCoordinates,
};
use exr::meta::header::Header;
use exr::meta::{MetaData, Requirements};
use exr::prelude::{SampleType as ExrSample, Text, Vec2, f16};

use self::header::FileHeader;
use self::part::{ExrChannel, Part};
use crate::ReadProblem;
use crate::input::{Input, io_problem, zeros};
use crate::layout::{Channel, Format, Layout, SampleType, Sink, Span};
use crate::source::SourceReader;

pub(crate) struct ExrFile<'a> {
    file: SourceReader<'a>,
    header: FileHeader,
    layout: Layout,
}

impl<'a> ExrFile<'a> {
    pub(crate) fn open(mut input: Input<'a>) -> Result<Self, ReadProblem> {
        let header = FileHeader::read(&mut input.file, input.file_len)?;
        let [width, height] = header.parts[0].size;
        let mut channels = Vec::new();
        for part in &header.parts {
            if part.size != [width, height] {
                return Err(ReadProblem::Unsupported {
                    what: "parts of different sizes".into(),
                    advice: "export the part with the heights into a file of its own",
                });
            }
            // A chunk has an 8-byte entry in the offset table, and begins with its coordinates and
            // its length.
            let least = (part.chunks() * 16).max(part.least_bytes(part.bytes()));
            let decoder_bytes = 3 * part.block_bytes() + 8 * part.chunks();
            input.check_size(Format::Exr, part.size, decoder_bytes, least)?;
            channels.extend(part.channels.iter().map(|channel| Channel {
                name: part.full_name(&channel.name),
                sample: match channel.sample {
                    ExrSample::F16 => SampleType::float(16),
                    ExrSample::F32 => SampleType::float(32),
                    ExrSample::U32 => SampleType::unsigned(32),
                },
            }));
        }
        let mut layout = Layout::new(Format::Exr, [width, height], &[], SampleType::float(32));
        layout.channels = channels;
        layout.remarks.extend(header.parts.iter().find_map(Part::remark));
        Ok(Self { file: input.file, header, layout })
    }

    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    pub(crate) fn layout_mut(&mut self) -> &mut Layout {
        &mut self.layout
    }

    pub(crate) fn decode(mut self, channels: &[usize], sink: &mut Sink<'_>) -> Result<(), ReadProblem> {
        let (index, chosen) = self.part_of(channels)?;
        let part = &self.header.parts[index];
        let meta = metadata(part);
        let offsets = self.header.offset_table(index, &mut self.file)?;
        let (blocks_x, _) = part.blocks();
        let mut samples = Vec::new();
        for (block, offset) in offsets.into_iter().enumerate() {
            let place = [block as u64 % blocks_x, block as u64 / blocks_x];
            let compressed = read_chunk(&mut self.file, &self.header, index, offset, place)?;
            dwa::check(part, part.block_rectangle(place)[1], &compressed)?;
            let chunk = Chunk { layer_index: 0, compressed_block: block_of(part, place, compressed) };
            let block = UncompressedBlock::decompress_chunk(chunk, &meta, false)
                .map_err(|error| ReadProblem::damaged("EXR", error))?;
            let [[left, top], [columns, rows]] = part.block_rectangle(place);
            let bytes_per_texel = part.channels.iter().map(|c| c.sample.bytes_per_sample()).sum::<usize>();
            let line_bytes = columns as usize * bytes_per_texel;
            if block.data.len() != line_bytes * rows as usize {
                return Err(ReadProblem::damaged("EXR", "a block's length differs from its header"));
            }
            for (row, line) in (top..).zip(block.data.chunks_exact(line_bytes)) {
                samples.clear();
                samples.resize(columns as usize * chosen.len(), 0.0);
                for (slot, &channel) in chosen.iter().enumerate() {
                    let before = part.channels[..channel].iter().map(|c| c.sample.bytes_per_sample());
                    let start = columns as usize * before.sum::<usize>();
                    let kind = part.channels[channel].sample;
                    let bytes = &line[start..start + columns as usize * kind.bytes_per_sample()];
                    spread(kind, bytes, samples[slot..].iter_mut().step_by(chosen.len()));
                }
                sink(Span { row, column: left, step: 1, samples: &samples })?;
            }
        }
        Ok(())
    }

    /// Finds the part that holds the chosen channels, and their indices in it.
    fn part_of(&self, channels: &[usize]) -> Result<(usize, Vec<usize>), ReadProblem> {
        let mut first = 0;
        for (index, part) in self.header.parts.iter().enumerate() {
            let end = first + part.channels.len();
            if channels.iter().all(|channel| (first..end).contains(channel)) {
                return Ok((index, channels.iter().map(|channel| channel - first).collect()));
            }
            first = end;
        }
        Err(ReadProblem::Unsupported {
            what: "a picture whose channels lie in different parts".into(),
            advice: "export its channels into one part",
        })
    }
}

/// Reads the compressed bytes of one chunk, and checks that it is the expected one.
fn read_chunk(
    file: &mut SourceReader<'_>,
    header: &FileHeader,
    index: usize,
    offset: u64,
    place: [u64; 2],
) -> Result<Vec<u8>, ReadProblem> {
    let part = &header.parts[index];
    let problem = |error| io_problem(Format::Exr, error);
    if offset < header.chunks_start || offset >= header.file_len {
        return Err(ReadProblem::damaged("EXR", "a block is missing"));
    }
    file.seek(SeekFrom::Start(offset)).map_err(problem)?;
    let mut number = || {
        let mut bytes = [0; 4];
        file.read_exact(&mut bytes).map_err(problem)?;
        Ok::<_, ReadProblem>(i64::from(i32::from_le_bytes(bytes)))
    };
    let mut expected = Vec::new();
    if header.multipart {
        expected.push(index as i64);
    }
    match part.tiles {
        Some(_) => expected.extend([place[0] as i64, place[1] as i64, 0, 0]),
        None => expected.push(part.data_window[1] + (place[1] * part.rows_per_block()) as i64),
    }
    for value in expected {
        if number()? != value {
            return Err(ReadProblem::damaged("EXR", "a block is not where its offset table says"));
        }
    }
    let length = number()?;
    let [_, [columns, rows]] = part.block_rectangle(place);
    let most = u64::from(columns) * u64::from(rows) * part.bytes_per_texel();
    // Writers store a block uncompressed if compression would make it longer. Therefore no chunk is
    // longer than its texels.
    match u64::try_from(length) {
        Ok(length) if length <= most && length >= part.least_bytes(most) && length <= header.file_len => {
            let mut bytes = zeros(length as usize)?;
            file.read_exact(&mut bytes).map_err(problem)?;
            Ok(bytes)
        }
        _ => Err(ReadProblem::damaged("EXR", "a block has an impossible length")),
    }
}

/// Builds the `exr` crate's description of a part, moved to the origin and with the first
/// resolution level only.
fn metadata(part: &Part) -> MetaData {
    let descriptions = part.channels.iter().map(ExrChannel::description).collect();
    let size = (part.size[0] as usize, part.size[1] as usize);
    let header = Header::new(Text::from(""), size, descriptions).with_encoding(
        part.compression,
        part.block_description(),
        exr::prelude::LineOrder::Increasing,
    );
    let requirements = Requirements {
        file_format_version: 2,
        is_single_layer_and_tiled: part.tiles.is_some(),
        has_long_names: true,
        has_deep_data: false,
        has_multiple_layers: false,
    };
    MetaData { requirements, headers: [header].into_iter().collect() }
}

fn block_of(part: &Part, [x, y]: [u64; 2], compressed_pixels_le: Vec<u8>) -> CompressedBlock {
    if part.tiles.is_some() {
        let tile_index = Vec2(x as usize, y as usize);
        let coordinates = TileCoordinates { tile_index, level_index: Vec2(0, 0) };
        CompressedBlock::Tile(CompressedTileBlock { coordinates, compressed_pixels_le })
    } else {
        let y_coordinate = (y * part.rows_per_block()) as i32;
        CompressedBlock::ScanLine(CompressedScanLineBlock { y_coordinate, compressed_pixels_le })
    }
}

fn spread<'a>(kind: ExrSample, bytes: &[u8], slots: impl Iterator<Item = &'a mut f64>) {
    match kind {
        ExrSample::F16 => {
            for (slot, sample) in slots.zip(bytes.as_chunks::<2>().0) {
                *slot = f16::from_ne_bytes(*sample).to_f64();
            }
        }
        ExrSample::F32 => {
            for (slot, sample) in slots.zip(bytes.as_chunks::<4>().0) {
                *slot = f64::from(f32::from_ne_bytes(*sample));
            }
        }
        ExrSample::U32 => {
            for (slot, sample) in slots.zip(bytes.as_chunks::<4>().0) {
                *slot = f64::from(u32::from_ne_bytes(*sample));
            }
        }
    }
}
