//! Volumes in KTX2 files: 3-D textures of one channel, with a note on their real size.

use std::io;
use std::path::Path;

use relief_core::{Volume, VolumeError, Wrap};

use super::read::{Layout, header, metadata_of};
use super::{Ktx2Texture, TexelFormat, read_ktx2, write_ktx2};
use crate::{Metadata, ReadError, ReadProblem, Row, Source, WriteError, WriteProblem};

/// Value of `relief.kind` in a volume's file.
const KIND: &str = "volume";

/// Names of the note's entries, without `relief.`.
const OWN: [&str; 6] = ["kind", "tile_m", "scale_m", "bias_m", "wrap", "surface"];

/// Settings for reading a volume.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VolumeOptions {
    /// Continuation beyond the edges along `u` and `v`. Default: as the file says, or repeated if it
    /// does not.
    pub wrap: Option<Wrap>,
    /// Greatest memory for reading, in bytes. Default: [`DEFAULT_MAX_BYTES`](crate::DEFAULT_MAX_BYTES).
    pub max_bytes: u64,
}

impl Default for VolumeOptions {
    fn default() -> Self {
        Self { wrap: None, max_bytes: crate::DEFAULT_MAX_BYTES }
    }
}

/// Volume from a file.
#[derive(Clone, Debug, PartialEq)]
pub struct VolumeFile {
    /// The volume. Scale and bias are the note's, or 1 m and 0 without one.
    pub volume: Volume,
    /// Storage format of the values.
    pub format: TexelFormat,
    /// Whether the values are compressed with Zstandard.
    pub zstd: bool,
    /// Lengths of the tile along `u` and `v` in metres, if Relief wrote the file.
    pub tile_m: Option<[f64; 2]>,
    /// Names and values of all metadata that are text.
    pub metadata: Metadata,
}

/// Form in which a volume is written.
#[derive(Clone, Debug, PartialEq)]
pub struct VolumeFormat {
    /// Storage format: `R16` by default, `R8` or `R32F`.
    pub texel: TexelFormat,
    /// Whether to compress the values with Zstandard. Default: true.
    pub zstd: bool,
    /// Lengths of the tile along `u` and `v` in metres. Default: 1 m by 1 m.
    pub tile_m: [f64; 2],
    /// Entries beside the note's, by names without `relief.`.
    pub more: Vec<(String, String)>,
}

impl Default for VolumeFormat {
    fn default() -> Self {
        Self { texel: TexelFormat::R16, zstd: true, tile_m: [1.0; 2], more: Vec::new() }
    }
}

/// Reads a volume from a KTX2 file, or from the bytes of one: a 3-D texture of one channel in
/// `R16_UNORM`, `R8_UNORM` or `R32_SFLOAT`, uncompressed or with Zstandard. Slice 0 is the lowest.
///
/// Relief's own files state scale, bias, wrap and tile in the entries `relief.scale_m`,
/// `relief.bias_m`, `relief.wrap` and `relief.tile_m`; `relief.kind` is `volume`, and
/// `relief.surface` is 0.5. Files of other programs may have none of these entries. A volume of a
/// single slice is a 2-D texture, which is read as a volume only if its entries say so.
///
/// ```
/// use relief_core::{Volume, Wrap};
/// use relief_io::{VolumeFormat, VolumeOptions, read_volume, write_volume};
///
/// # fn main() -> Result<(), Box<dyn std::error::Error>> {
/// # let folder = tempfile::tempdir()?;
/// # let path = folder.path().join("ramp.ktx2");
/// let ramp = Volume::from_fn([8, 8, 16], Wrap::Clamp, |[_, _, h]| 1.0 - h)?.with_displacement(0.02, 0.0)?;
/// write_volume(&path, &ramp, &VolumeFormat::default())?;
/// let file = read_volume(path.as_path(), &VolumeOptions::default())?;
/// assert_eq!(file.volume.size(), [8, 8, 16]);
/// assert_eq!((file.volume.wrap(), file.volume.atlas().scale_m()), (Wrap::Clamp, 0.02));
/// # Ok(())
/// # }
/// ```
///
/// # Memory
///
/// Reading takes 4 bytes a voxel, 4 a texel of the volume's atlas, and up to 8 MiB. It is counted
/// before any memory is allocated.
///
/// # Errors
///
/// When the file cannot be read, is not a KTX2 file, is damaged, or holds another kind of texture;
/// when a value is not a number from 0 to 1 or an entry is impossible; or when the volume is too
/// large or needs more than [`VolumeOptions::max_bytes`].
pub fn read_volume<'a>(
    source: impl Into<Source<'a>>,
    options: &VolumeOptions,
) -> Result<VolumeFile, ReadError> {
    let source = source.into();
    check(source, options.max_bytes).map_err(|problem| source.error(problem))?;
    let file = read_ktx2(source, options.max_bytes)?;
    let (format, zstd, metadata) = (file.format, file.zstd, file.metadata);
    let plane = file.levels.into_iter().next().and_then(|level| {
        let values = level.planes.into_iter().next()?;
        Some((level.size, values))
    });
    let volume = || {
        // The check has seen one level with one channel.
        let (size, values) = plane.ok_or_else(|| damaged("it has no texels"))?;
        let note = VolumeNote::of(&metadata)?;
        let wrap = options.wrap.or(note.as_ref().map(|note| note.wrap)).unwrap_or_default();
        let mut volume = Volume::new(size, &values, wrap)?;
        if let Some(VolumeNote { scale_m, bias_m, .. }) = note {
            volume = volume.with_displacement(scale_m, bias_m)?;
        }
        Ok((volume, note.map(|note| note.tile_m)))
    };
    let (volume, tile_m) = volume().map_err(|problem: ReadProblem| source.error(problem))?;
    Ok(VolumeFile { volume, format, zstd, tile_m, metadata })
}

/// Checks that a file holds a volume that fits into `max_bytes`, by its header and metadata.
fn check(source: Source<'_>, max_bytes: u64) -> Result<(), ReadProblem> {
    let (mut file, file_len) = source.open()?;
    let header = header(&mut file)?;
    let layout = Layout::of(&header)?;
    let metadata = metadata_of(&header, &mut file, file_len)?;
    let kind = metadata.get("relief.kind");
    if kind.is_some_and(|kind| kind != KIND) {
        return Err(unsupported(&format!("a map of the kind {}", kind.unwrap_or_default())));
    }
    if !matches!(layout.format, TexelFormat::R8 | TexelFormat::R16 | TexelFormat::R32F) {
        return Err(unsupported("other texels than R8_UNORM, R16_UNORM and R32_SFLOAT"));
    }
    if layout.levels > 1 {
        return Err(unsupported(&format!("{} mip levels, where a volume has one", layout.levels)));
    }
    if kind.is_none() && layout.size[2] == 1 {
        return Err(unsupported("a 2-D texture, where a volume has slices"));
    }
    let slices = Volume::check_size(layout.size)?;
    let [width, height] = slices.atlas_size().map(u64::from);
    let needed = 4 * slices.voxels() + 4 * width * height + layout.window();
    if needed > max_bytes {
        return Err(ReadProblem::VolumeMemory { size: layout.size, needed, limit: max_bytes });
    }
    Ok(())
}

/// Writes a volume as a KTX2 file with one level: a 3-D texture whose depth is the number of slices,
/// slice 0 the lowest. A volume of a single slice becomes a 2-D texture. The entries say its scale,
/// bias, wrap and tile, see [`read_volume`]. The same volume gives the same bytes.
///
/// # Errors
///
/// When the format has not one channel, or is neither `R16`, `R8` nor `R32F`; when the tile is not
/// of finite lengths above 0; when an entry is invalid or has a name that the note uses; or when the
/// file cannot be written. Nothing is left behind then.
pub fn write_volume(path: &Path, volume: &Volume, format: &VolumeFormat) -> Result<(), WriteError> {
    let metadata = format.metadata(volume).map_err(|problem| problem.at(path))?;
    let texture = Ktx2Texture {
        format: format.texel,
        size: volume.size(),
        levels: 1,
        channels: 1,
        zstd: format.zstd,
        metadata,
    };
    let (layout, atlas) = (volume.layout(), volume.atlas());
    let width = layout.atlas_size()[0] as usize;
    write_ktx2(path, &texture, &mut |row: Row, texels: &mut [f32]| -> io::Result<()> {
        let [x, y] = layout.place(row.slice).map(|at| at as usize);
        let start = (y + row.row as usize) * width + x;
        texels.copy_from_slice(&atlas.texels()[start..start + texels.len()]);
        Ok(())
    })
}

impl VolumeFormat {
    fn metadata(&self, volume: &Volume) -> Result<Metadata, WriteProblem> {
        if !matches!(self.texel, TexelFormat::R8 | TexelFormat::R16 | TexelFormat::R32F) {
            return Err(WriteProblem::NotStorable(
                "a volume is stored as R16, R8 or R32F: choose one of them".to_owned(),
            ));
        }
        let [tile_u, tile_v] = self.tile_m;
        if !self.tile_m.iter().all(|side| is_length(*side)) {
            return Err(WriteProblem::NotStorable(format!(
                "a tile of {tile_u} m by {tile_v} m is impossible: both sides must be finite and above 0"
            )));
        }
        let (scale_m, bias_m) = (volume.atlas().scale_m(), volume.atlas().bias_m());
        let own = [
            KIND.to_owned(),
            format!("{tile_u} {tile_v}"),
            scale_m.to_string(),
            bias_m.to_string(),
            volume.wrap().name().to_owned(),
            Volume::SURFACE.to_string(),
        ];
        let own = OWN.into_iter().zip(own).map(|(name, value)| (format!("relief.{name}"), value));
        let more = self.more.iter().map(|(name, value)| (format!("relief.{name}"), value.clone()));
        Metadata::new(own.chain(more).collect())
    }
}

/// What the entries of a volume's file say.
struct VolumeNote {
    tile_m: [f64; 2],
    scale_m: f64,
    bias_m: f64,
    wrap: Wrap,
}

impl VolumeNote {
    /// Reads the note, if there is one.
    fn of(metadata: &Metadata) -> Result<Option<Self>, ReadProblem> {
        if metadata.get("relief.kind") != Some(KIND) {
            return Ok(None);
        }
        let entry = |name: &'static str| {
            let text = metadata.get(name).ok_or_else(|| damaged(format!("it has no entry {name}")))?;
            Ok::<(&str, &str), ReadProblem>((name, text))
        };
        let wrong = |(name, text): (&str, &str)| damaged(format!("its entry {name} is '{text}'"));
        let number = |found: (&str, &str)| {
            let number = found.1.parse::<f64>().ok().filter(|number| number.is_finite());
            number.ok_or_else(|| wrong(found))
        };
        let tile = entry("relief.tile_m")?;
        let sides = tile.1.split_once(' ').ok_or_else(|| wrong(tile))?;
        let tile_m = [number((tile.0, sides.0))?, number((tile.0, sides.1))?];
        let surface = entry("relief.surface")?;
        if number(surface)? != Volume::SURFACE || !tile_m.iter().all(|side| is_length(*side)) {
            return Err(wrong(if tile_m.iter().all(|side| is_length(*side)) { surface } else { tile }));
        }
        let (scale, bias) = (entry("relief.scale_m")?, entry("relief.bias_m")?);
        let wrap = entry("relief.wrap")?;
        Ok(Some(Self {
            tile_m,
            scale_m: number(scale)?,
            bias_m: number(bias)?,
            wrap: wrap.1.parse().map_err(|_| wrong(wrap))?,
        }))
    }
}

fn is_length(metres: f64) -> bool {
    metres > 0.0 && metres.is_finite()
}

fn damaged(what: impl ToString) -> ReadProblem {
    ReadProblem::damaged(super::read::NAME, what)
}

fn unsupported(what: &str) -> ReadProblem {
    ReadProblem::Unsupported {
        what: what.to_owned(),
        advice: "give a 3-D texture of one channel with values from 0 to 1",
    }
}

impl From<VolumeError> for ReadProblem {
    fn from(error: VolumeError) -> Self {
        Self::Volume(error)
    }
}
