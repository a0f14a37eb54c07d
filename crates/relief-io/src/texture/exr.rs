//! Writer of EXR with any named float channels, and metadata in one string attribute.

use std::io::{self, Seek, Write};
use std::path::Path;

use exr::block::UncompressedBlock;
use exr::block::writer::ChunksWriter;
use exr::meta::attribute::{AttributeValue, Chromaticities};
use exr::meta::header::{Header, LayerAttributes};
use exr::meta::{BlockDescription, MetaData};
use exr::prelude::{ChannelDescription, Compression, LineOrder, SampleType, SmallVec, Text, Vec2};
use relief_core::HeightMap;

use super::metadata::EXR_ATTRIBUTE;
use super::{LineSink, Metadata, Row, RowSource};
use crate::write_whole::write_file;
use crate::{WriteError, WriteProblem};

/// Writes named channels as 32-bit floats, without loss (ZIP, 16 rows a block). Rows are requested
/// from `rows`.
///
/// The metadata are lines of one string attribute named `relief`: the `exr` crate stores several
/// attributes in an order that changes from run to run. Channels are stored in the order of their
/// names; [`Row::channel`] is an index into `names`.
///
/// # Errors
///
/// When there is no channel; when a name is empty, longer than 255 bytes, not printable ASCII or
/// given twice; when the size is 0 or above the limit of a height map; when `rows` fails; or when
/// the file cannot be written. Nothing is left behind then.
pub fn write_exr_rows(
    path: &Path,
    width: u32,
    height: u32,
    names: &[&str],
    metadata: &Metadata,
    rows: &mut RowSource<'_>,
) -> Result<(), WriteError> {
    write_exr_lines(path, [width, height], names, metadata, |sink| {
        let mut texels = vec![vec![0.0; width as usize]; names.len()];
        for row in 0..height {
            for (channel, texels) in texels.iter_mut().enumerate() {
                rows(Row { level: 0, slice: 0, channel, row }, texels)?;
            }
            sink(&texels.iter().map(Vec::as_slice).collect::<Vec<_>>())?;
        }
        Ok(())
    })
}

/// Writes named channels like [`write_exr_rows`]. `lines` passes the rows to its argument, from the
/// top: the texels of each channel, in the order of `names`.
///
/// # Errors
///
/// See [`write_exr_rows`]. Also when `lines` fails, or passes a wrong number of rows, channels or
/// texels.
pub fn write_exr_lines(
    path: &Path,
    size: [u32; 2],
    names: &[&str],
    metadata: &Metadata,
    lines: impl FnOnce(&mut LineSink) -> io::Result<()>,
) -> Result<(), WriteError> {
    write_file(path, |out| write_exr_lines_of(out, size, names, metadata, false, lines))
}

/// Writes the bytes of the file of [`write_exr_lines`].
///
/// # Errors
///
/// See [`write_exr_lines`].
pub fn encode_exr_lines(
    out: &mut (impl Write + Seek),
    size: [u32; 2],
    names: &[&str],
    metadata: &Metadata,
    lines: impl FnOnce(&mut LineSink) -> io::Result<()>,
) -> Result<(), WriteProblem> {
    write_exr_lines_of(out, size, names, metadata, false, lines)
}

/// Primaries and white point of sRGB (IEC 61966-2-1).
const SRGB: [(f32, f32); 4] = [(0.64, 0.33), (0.3, 0.6), (0.15, 0.06), (0.3127, 0.329)];

/// Writes the bytes of an EXR file. With `is_picture` its channels are colours in the primaries of
/// sRGB.
pub(crate) fn write_exr_lines_of(
    out: &mut (impl Write + Seek),
    [width, height]: [u32; 2],
    names: &[&str],
    metadata: &Metadata,
    is_picture: bool,
    lines: impl FnOnce(&mut LineSink) -> io::Result<()>,
) -> Result<(), WriteProblem> {
    HeightMap::check_size(width, height).map_err(|error| WriteProblem::NotStorable(error.to_string()))?;
    let mut order: Vec<usize> = (0..names.len()).collect();
    order.sort_by_key(|&channel| names[channel]);
    check_names(names, &order)?;
    let descriptions: SmallVec<[ChannelDescription; 5]> = order
        .iter()
        .map(|&channel| ChannelDescription::new(Text::new_or_panic(names[channel]), SampleType::F32, false))
        .collect();
    let mut attributes = LayerAttributes::default();
    if metadata.iter().next().is_some() {
        let lines = Text::from_slice_unchecked(metadata.to_lines().as_bytes());
        attributes.other.insert(Text::new_or_panic(EXR_ATTRIBUTE), AttributeValue::Text(lines));
    }
    let mut header = Header::new(Text::from(""), (width as usize, height as usize), descriptions)
        .with_encoding(Compression::ZIP16, BlockDescription::ScanLines, LineOrder::Increasing)
        .with_attributes(attributes);
    if is_picture {
        let [red, green, blue, white] = SRGB.map(|(x, y)| Vec2(x, y));
        header.shared_attributes.chromaticities = Some(Chromaticities { red, green, blue, white });
    }
    write_blocks(out, header, [width, height], &order, lines)
}

fn check_names(names: &[&str], order: &[usize]) -> Result<(), WriteProblem> {
    if names.is_empty() {
        return Err(WriteProblem::NotStorable("an EXR file needs at least one channel".into()));
    }
    if let Some(pair) = order.windows(2).find(|pair| names[pair[0]] == names[pair[1]]) {
        return Err(WriteProblem::NotStorable(format!("the channel '{}' is given twice", names[pair[0]])));
    }
    let printable = |name: &&&str| {
        (1..=255).contains(&name.len()) && name.bytes().all(|byte| (b' '..=b'~').contains(&byte))
    };
    match names.iter().find(|name| !printable(name)) {
        None => Ok(()),
        Some(name) => Err(WriteProblem::NotStorable(format!(
            "'{name}' cannot be an EXR channel's name: use 1 to 255 printable ASCII characters"
        ))),
    }
}

fn write_blocks(
    out: &mut (impl Write + Seek),
    header: Header,
    [width, height]: [u32; 2],
    order: &[usize],
    lines: impl FnOnce(&mut LineSink) -> io::Result<()>,
) -> Result<(), WriteProblem> {
    let wrong = |what: &str| Err(io::Error::new(io::ErrorKind::InvalidInput, what.to_owned()));
    let written = exr::block::write(out, [header].into_iter().collect(), true, |meta: MetaData, chunks| {
        let mut blocks = meta.enumerate_ordered_header_block_indices();
        let mut compressor = chunks.sequential_blocks_compressor(&meta);
        let mut next = blocks.next();
        // The bytes of a block are its rows, each channel after channel.
        let (mut data, mut held, mut count) = (Vec::new(), 0, 0);
        lines(&mut |line| {
            let Some((number, index)) = next else { return wrong("more rows than the file has") };
            if line.len() != order.len() || line.iter().any(|texels| texels.len() != width as usize) {
                return wrong("a row of a wrong size");
            }
            for &channel in order {
                data.extend(line[channel].iter().flat_map(|sample| sample.to_ne_bytes()));
            }
            (held, count) = (held + 1, count + 1);
            if held == index.pixel_size.height() {
                let block = UncompressedBlock { index, data: std::mem::take(&mut data) };
                compressor.compress_block(number, block).map_err(|error| match error {
                    exr::error::Error::Io(error) => error,
                    other => io::Error::other(other.to_string()),
                })?;
                (held, next) = (0, blocks.next());
            }
            Ok(())
        })?;
        if count == height { Ok(()) } else { Ok(wrong("fewer rows than the file has")?) }
    });
    written.map_err(|error| match error {
        exr::error::Error::Io(error) => WriteProblem::Io(error),
        other => WriteProblem::NotStorable(other.to_string()),
    })
}
