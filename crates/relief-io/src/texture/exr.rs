//! EXR with any named float channels, and metadata in one string attribute.

use std::fs::File;
use std::io::{self, BufWriter};
use std::path::Path;

use exr::block::UncompressedBlock;
use exr::block::writer::ChunksWriter;
use exr::meta::attribute::AttributeValue;
use exr::meta::header::{Header, LayerAttributes};
use exr::meta::{BlockDescription, MetaData};
use exr::prelude::{ChannelDescription, Compression, LineOrder, SampleType, SmallVec, Text};
use relief_core::HeightMap;

use super::metadata::EXR_ATTRIBUTE;
use super::{Metadata, Row, RowSource};
use crate::write_whole::write_file;
use crate::{WriteError, WriteProblem};

/// Writes named channels as 32-bit floats, without loss (ZIP, 16 rows a block), row by row.
///
/// The metadata are the lines of one string attribute named `relief`: the `exr` crate stores several
/// attributes in an order that changes from run to run. Channels are stored in the order of their names;
/// [`Row::channel`] counts in the order of `names`.
///
/// # Errors
///
/// When there is no channel, when a name is empty, longer than 255 bytes, not printable ASCII or given twice,
/// when the size is 0 or above what a height map may have, when a row cannot be had, or when the file cannot
/// be written. Nothing is left behind then.
pub fn write_exr_rows(
    path: &Path,
    width: u32,
    height: u32,
    names: &[&str],
    metadata: &Metadata,
    rows: &mut RowSource<'_>,
) -> Result<(), WriteError> {
    write_file(path, |out| {
        HeightMap::check_size(width, height).map_err(|error| WriteProblem::NotStorable(error.to_string()))?;
        let mut order: Vec<usize> = (0..names.len()).collect();
        order.sort_by_key(|&channel| names[channel]);
        check_names(names, &order)?;
        let descriptions: SmallVec<[ChannelDescription; 5]> = order
            .iter()
            .map(|&channel| {
                ChannelDescription::new(Text::new_or_panic(names[channel]), SampleType::F32, false)
            })
            .collect();
        let mut attributes = LayerAttributes::default();
        if metadata.iter().next().is_some() {
            let lines = Text::from_slice_unchecked(metadata.to_lines().as_bytes());
            attributes.other.insert(Text::new_or_panic(EXR_ATTRIBUTE), AttributeValue::Text(lines));
        }
        let header = Header::new(Text::from(""), (width as usize, height as usize), descriptions)
            .with_encoding(Compression::ZIP16, BlockDescription::ScanLines, LineOrder::Increasing)
            .with_attributes(attributes);
        write_blocks(out, header, width as usize, &order, rows)
    })
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
            "an EXR channel's name has 1 to 255 printable ASCII characters, this one is '{name}'"
        ))),
    }
}

fn write_blocks(
    out: &mut BufWriter<&File>,
    header: Header,
    width: usize,
    order: &[usize],
    rows: &mut RowSource<'_>,
) -> Result<(), WriteProblem> {
    let mut texels = vec![0.0; width];
    let mut failed: Option<io::Error> = None;
    let written = exr::block::write(out, [header].into_iter().collect(), true, |meta: MetaData, chunks| {
        let list = &meta.headers[0].channels;
        let blocks = meta.collect_ordered_block_data(|block| {
            UncompressedBlock::collect_block_data_from_lines(list, block, |line| {
                let channel = order[line.location.channel];
                let row = line.location.position.y() as u32;
                // The crate's closure cannot fail: what follows a failure is not asked for, and the file is
                // dropped.
                if failed.is_none() {
                    failed = rows(Row { level: 0, slice: 0, channel, row }, &mut texels).err();
                }
                for (bytes, sample) in line.value.chunks_exact_mut(4).zip(&texels) {
                    bytes.copy_from_slice(&sample.to_ne_bytes());
                }
            })
        });
        let mut compressor = chunks.sequential_blocks_compressor(&meta);
        for (index, block) in blocks {
            compressor.compress_block(index, block)?;
        }
        Ok(())
    });
    match (failed, written) {
        (Some(error), _) | (None, Err(exr::error::Error::Io(error))) => Err(WriteProblem::Io(error)),
        (None, Err(other)) => Err(WriteProblem::NotStorable(other.to_string())),
        (None, Ok(())) => Ok(()),
    }
}
