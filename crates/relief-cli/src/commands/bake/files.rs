//! Files of spooled textures: their plan, and writing them.

use std::io;
use std::ops::Range;
use std::path::{Path, PathBuf};

use relief_bake::Shape;
use relief_core::{Cancelled, HeightMap, MAX_SIDE, MAX_TEXELS, Watch};
use relief_io::{
    Ktx2Texture, Metadata, PngTexture, Row, WriteProblem, write_exr_rows, write_ktx2, write_png_rows,
};

use super::identity::Identity;
use super::spool::{SpoolReader, Spooled};
use super::storage::{FileFormat, Packing, Storage};

/// File to be written: some channels and mip levels of a texture, and some slices of a volume.
#[derive(Debug)]
pub struct Plan {
    /// Name of the file.
    pub name: String,
    texture: usize,
    channels: Range<usize>,
    levels: Range<usize>,
    slices: Range<u32>,
    /// Columns, rows and slices of its finest level: the texture's, or more.
    size: [u32; 3],
}

/// Reason that files were not written.
#[derive(Debug, thiserror::Error)]
pub enum FilesError {
    /// A file cannot be written.
    #[error("{name}: {problem}")]
    Write {
        /// Name of the file.
        name: String,
        /// Reason.
        problem: WriteProblem,
    },
    /// A value cannot be stored.
    #[error("{0}")]
    Value(String),
    /// Writing was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Returns the files of textures of the given shapes. Their names begin with `base`.
pub fn plan<'a>(base: &str, format: FileFormat, shapes: impl IntoIterator<Item = &'a Shape>) -> Vec<Plan> {
    let numbered = shapes.into_iter().enumerate();
    numbered.flat_map(|(index, shape)| plan_texture(base, format, index, shape)).collect()
}

/// Returns the files of a texture.
///
/// PNG and KTX2 files hold up to four channels. Two colours become two files, so that no channel of
/// the second becomes the opacity of the first. PNG and EXR files hold one mip level, KTX2 files
/// hold all. KTX2 requires that each level is half the one before, rounded down; other levels are
/// padded to the right and below. In EXR files slices lie below each other, as many as fit.
fn plan_texture(base: &str, format: FileFormat, index: usize, shape: &Shape) -> Vec<Plan> {
    let count = shape.channels as usize;
    let levels = shape.mips.len() + 1;
    let together = levels == 1 || format == FileFormat::Ktx2;
    let step = match format.channels().min(count.max(1)) {
        4 if count == 6 => 3,
        step => step,
    };
    let mut plans = Vec::new();
    for from in (0..count).step_by(step) {
        let channels = from..(from + step).min(count);
        for level in 0..if together { 1 } else { levels } {
            let mut parts = vec![base.to_owned()];
            if !shape.name.is_empty() {
                parts.push(shape.name.to_owned());
            }
            if count > step {
                parts.push(format!("channels{}-{}", channels.start, channels.end - 1));
            }
            if !together {
                parts.push(format!("level{level}"));
            }
            let levels = if together { 0..levels } else { level..level + 1 };
            let mut size = shape.level_size(level);
            if levels.len() > 1 {
                [size[0], size[1]] = shape.chain_size(0);
            }
            let depth = size[2];
            let slices = if format == FileFormat::Exr { slices_below(size) } else { depth.max(1) };
            for first in (0..depth).step_by(slices as usize) {
                let slices = first..depth.min(first.saturating_add(slices));
                let mut parts = parts.clone();
                if slices.end - first < depth {
                    parts.push(format!("slices{first}-{}", slices.end - 1));
                }
                parts.push(format.extension().to_owned());
                let (channels, levels) = (channels.clone(), levels.clone());
                plans.push(Plan { name: parts.join("."), texture: index, channels, levels, slices, size });
            }
        }
    }
    plans
}

/// Returns how many slices of a size fit below each other into one picture, at least one.
fn slices_below([width, height, depth]: [u32; 3]) -> u32 {
    let fits = |slices: &u32| HeightMap::check_size(width, height.saturating_mul(*slices)).is_ok();
    let most = (MAX_TEXELS / (u64::from(width) * u64::from(height)).max(1)).min(u64::from(depth)) as u32;
    Some(most.min(MAX_SIDE / height.max(1))).filter(fits).unwrap_or(1).max(1)
}

impl Plan {
    /// Returns columns, rows and slices of one of the file's levels; level 0 is its finest.
    fn level_size(&self, level: usize) -> [u32; 3] {
        self.size.map(|side| (side >> level.min(31)).max(1))
    }

    /// Checks that a file can hold it.
    ///
    /// # Errors
    ///
    /// When it cannot; the text says what to do.
    pub fn check(&self, packing: Packing) -> Result<(), String> {
        let size = self.size;
        let [width, height, _] = size;
        match packing.format {
            FileFormat::Ktx2 => {
                let (count, levels) = (self.channels.len(), self.levels.len() as u32);
                let (format, metadata) = (packing.storage.ktx2(count), Metadata::default());
                let texture =
                    Ktx2Texture { format, size, levels, channels: count, zstd: packing.zstd, metadata };
                texture.check().map_err(|problem| problem.to_string())
            }
            FileFormat::Exr | FileFormat::Png => {
                let slices = self.slices.end - self.slices.start;
                let fits = HeightMap::check_size(width, height.saturating_mul(slices));
                fits.map_err(|_| {
                    let format = packing.format.extension();
                    format!(
                        "{width}x{height} texels do not fit into an {format} file: the limit is {MAX_SIDE} \
                         texels a side and {MAX_TEXELS} in all: use another --format, or a smaller map"
                    )
                })
            }
        }
    }
}

/// Writes the files of a bake, each to its place.
pub fn write(
    plans: &[Plan],
    places: &[PathBuf],
    packing: Packing,
    textures: &[Spooled],
    reader: &mut SpoolReader,
    identity: &Identity,
    watch: &Watch,
) -> Result<(), FilesError> {
    let names = plans.iter().map(|plan| plan.name.clone()).collect();
    let of_bake = BakeContext { packing, identity, names };
    let rows_of = |plan: &Plan| -> u64 {
        let slices = u64::from(plan.slices.end - plan.slices.start);
        let rows = (0..plan.levels.len()).map(|level| u64::from(plan.level_size(level)[1]) * slices);
        rows.sum::<u64>() * plan.channels.len() as u64
    };
    let all = plans.iter().map(rows_of).sum::<u64>().max(1) as f32;
    let mut done = 0u64;
    for (plan, place) in plans.iter().zip(places) {
        let spooled = &textures[plan.texture];
        let mut count = || {
            done += 1;
            watch.at(done as f32 / all)
        };
        write_one(place, plan, &of_bake, spooled, reader, &mut count)?;
    }
    Ok(())
}

/// Data that all files of a bake share.
struct BakeContext<'a> {
    packing: Packing,
    identity: &'a Identity,
    names: Vec<String>,
}

/// Writes a file and counts each of its rows.
fn write_one(
    path: &Path,
    plan: &Plan,
    BakeContext { packing, identity, names }: &BakeContext,
    spooled: &Spooled,
    reader: &mut SpoolReader,
    count: &mut dyn FnMut() -> Result<(), Cancelled>,
) -> Result<(), FilesError> {
    let Packing { format, storage, zstd } = *packing;
    let texture = &spooled.texture;
    let single = (plan.levels.len() == 1 && !texture.mips.is_empty()).then_some(plan.levels.start);
    let size = plan.size;
    let is_part = plan.slices.end - plan.slices.start < size[2];
    let slices = is_part.then(|| plan.slices.clone());
    let mut entries = identity.metadata(texture, plan.channels.clone(), single, slices, storage, names);
    let sizes: Vec<[u32; 3]> = plan.levels.clone().map(|level| texture.level_size(level)).collect();
    if sizes.iter().enumerate().any(|(level, size)| *size != plan.level_size(level)) {
        let sizes = sizes.iter().map(|[width, height, _]| format!("{width}x{height}"));
        entries.push(("relief.level_sizes".to_owned(), sizes.collect::<Vec<_>>().join(" ")));
    }
    let metadata = Metadata::new(entries).map_err(|problem| FilesError::Value(problem.to_string()))?;
    let channels = &texture.channels[plan.channels.clone()];
    // Writers pass on failed rows only as system errors.
    let mut failure = None;
    let mut rows = |row: Row, texels: &mut [f32]| -> io::Result<()> {
        let Some(channel) = channels.get(row.channel) else {
            // A fourth channel is opacity.
            texels.fill(if row.channel == 3 { 1.0 } else { 0.0 });
            return Ok(());
        };
        let [columns, rows, _] = sizes[row.level as usize];
        let source = Row {
            level: row.level + plan.levels.start as u32,
            slice: row.slice + plan.slices.start,
            channel: row.channel + plan.channels.start,
            // Padding repeats the last row and column.
            row: row.row.min(rows - 1),
        };
        let (own, beyond) = texels.split_at_mut(columns as usize);
        reader.row(spooled, source, own)?;
        let stored = own.iter_mut().try_for_each(|texel| {
            *texel = storage.texel(*texel, channel)?;
            Ok(())
        });
        beyond.fill(own.last().copied().unwrap_or_default());
        failure = stored.map_err(FilesError::Value).err();
        if failure.is_none() {
            failure = count().err().map(FilesError::Cancelled);
        }
        if failure.is_some() { Err(io::Error::other("stopped")) } else { Ok(()) }
    };
    let [width, height, _] = size;
    let written = match format {
        FileFormat::Exr => {
            let names: Vec<&str> = channels.iter().map(|channel| channel.name).collect();
            // The slices of a volume lie below each other.
            let mut below = |row: Row, texels: &mut [f32]| {
                rows(Row { slice: row.row / height, row: row.row % height, ..row }, texels)
            };
            let tall = height.saturating_mul(plan.slices.end - plan.slices.start);
            write_exr_rows(path, width, tall, &names, &metadata, &mut below)
        }
        FileFormat::Png => {
            let bits = if storage == (Storage::Unorm { bits: 8 }) { 8 } else { 16 };
            // Viewers would mix two channels as grey and opacity, so a blue of 0 is added.
            let channels = if channels.len() == 2 { 3 } else { channels.len() };
            write_png_rows(path, &PngTexture { width, height, channels, bits }, &metadata, &mut rows)
        }
        FileFormat::Ktx2 => {
            let levels = plan.levels.len() as u32;
            let format = storage.ktx2(channels.len());
            let description = Ktx2Texture { format, size, levels, channels: channels.len(), zstd, metadata };
            write_ktx2(path, &description, &mut rows)
        }
    };
    match failure {
        Some(failure) => Err(failure),
        None => {
            written.map_err(|error| FilesError::Write { name: plan.name.clone(), problem: error.problem })
        }
    }
}
