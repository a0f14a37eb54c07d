//! Reader of a [`HeightMap`] from a file: choice of the channel, holes, range and convention.

use std::fmt;
use std::str::FromStr;

use relief_core::registry::UnknownName;
use relief_core::{HeightMap, TexelMask, Wrap};

use crate::elevation::{Elevation, UnitOrigin};
use crate::examine::examine;
use crate::fill::fill_holes;
use crate::image_file::ImageFile;
use crate::layout::{Layout, Terrain};
use crate::samples::{Samples, Selection};
use crate::{
    GivenUnits, HeightNote, HeightRange, RawLayout, ReadError, ReadNote, ReadProblem, Remark, Source,
};

/// Meaning of white in a file of heights.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Convention {
    /// White is high.
    #[default]
    Height,
    /// White is deep: a texel's height is 1 minus its value.
    Depth,
}

impl Convention {
    /// Returns the name of this convention, as files and the command spell it: `height` or `depth`.
    pub const fn name(self) -> &'static str {
        match self {
            Convention::Height => "height",
            Convention::Depth => "depth",
        }
    }
}

impl fmt::Display for Convention {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Convention {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let all = [Convention::Height, Convention::Depth];
        let known = all.into_iter().find(|convention| convention.name() == name);
        known.ok_or_else(|| UnknownName::new("convention", name, all.map(Convention::name)))
    }
}

/// Treatment of holes: texels that are NaN, infinite, nodata or masked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Fill {
    /// Holes are an error.
    #[default]
    Never,
    /// Holes are filled in elevation models, where they are common, and in files whose nodata value
    /// is given by [`HeightOptions::nodata`]. In other files they are an error.
    Elevation,
    /// Holes are filled.
    Always,
}

impl Fill {
    fn fills(self, is_expected: bool) -> bool {
        match self {
            Fill::Never => false,
            Fill::Elevation => is_expected,
            Fill::Always => true,
        }
    }
}

/// Default limit of memory for reading in bytes: 4 GiB, enough for a map of 23,000 texels a side.
pub const DEFAULT_MAX_BYTES: u64 = 4 << 30;

/// Options for reading a height map.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightOptions {
    /// Name of the channel to read, in any case: `r`, `g`, `b`, `a`, `y`, or a name in an EXR file.
    /// `luminance` and `height` stand for `y`. None reads the only channel. In a picture of grey
    /// with alpha it reads the grey. In a picture of red, green and blue it reads their common
    /// value if they are equal everywhere, or their mean if they are nearly equal (see
    /// [`HeightMap::nearly_grey_texels`]).
    pub channel: Option<String>,
    /// Whether white is high or deep. None: deep if the file names a vertical system that counts
    /// downward, otherwise high.
    pub convention: Option<Convention>,
    /// Raw values that become heights 0 and 1. None: see [`read_height`].
    pub range: Option<HeightRange>,
    /// Elevations in metres that heights 0 and 1 stand for: finite, the second above the first. They
    /// replace the file's own, and make the file an elevation model. None: see [`read_height`].
    pub elevation_m: Option<[f64; 2]>,
    /// Raw value, as stored in the file, that marks texels without a value, in addition to the
    /// nodata value that the file itself declares. It must be finite.
    pub nodata: Option<f64>,
    /// Units of heights and ground, if the file does not state them or states wrong ones. A file
    /// without units becomes an elevation model by this option.
    pub unit: Option<GivenUnits>,
    /// Layout for reading the file as headerless samples, whatever its content.
    pub raw: Option<RawLayout>,
    /// Treatment of texels without a value. Default: an error.
    pub fill: Fill,
    /// Continuation of the map beyond its edges. None: elevation models are clamped, other maps
    /// repeated.
    pub wrap: Option<Wrap>,
    /// Greatest memory for reading, in bytes. Default: [`DEFAULT_MAX_BYTES`].
    pub max_bytes: u64,
}

impl Default for HeightOptions {
    fn default() -> Self {
        Self {
            channel: None,
            convention: None,
            range: None,
            elevation_m: None,
            nodata: None,
            unit: None,
            raw: None,
            fill: Fill::Never,
            wrap: None,
            max_bytes: DEFAULT_MAX_BYTES,
        }
    }
}

/// Peak memory of reading a height map per texel: the values and, while holes are filled, marks and
/// a pyramid of a third more.
pub(crate) const BYTES_PER_TEXEL: u64 = 8;

/// Reads a height map from a file or from the bytes of one. Its texels are in `[0, 1]`, 1 highest.
///
/// The format (PNG, JPEG, EXR, TIFF and GeoTIFF, Radiance HDR, PGM, WebP, headerless raw) is
/// recognised by the file's content. Samples are taken as stored: no gamma or colour profile is
/// applied. These raw values become 0 and 1:
///
/// * the ends of [`HeightOptions::range`] where they are given;
/// * the least and the greatest value for elevation models, for floats, and for signed and 32 and 64-bit
///   integers, whose type's maximum says nothing of what they hold. A constant map becomes 0;
/// * 0 and the type's maximum for other unsigned integers of up to 16 bit (255, 65535, a PGM's maxval).
///
/// [`HeightMap::physical_range`] returns the raw values of texels 0 and 1; with the depth
/// convention the first is the greater. If the file has a [`HeightNote`](crate::HeightNote), the
/// range and [`HeightMap::texel_size_m`] come from the note, in metres. Its values are then
/// fractions of their type's maximum or, if they are floats, the fractions themselves. If the note
/// belongs to a mesh, its displacements become [`HeightMap::stated_displacement_m`].
///
/// # Elevation models
///
/// A TIFF, PNG or JPEG file with a georeference, or with a scale, an offset or a unit of its
/// values, is an elevation model. Sidecar files can supply all of that, as GDAL writes and reads
/// them: `.aux.xml`, world files (`.tfw`, `.pgw`, `.jgw`, `.wld`) and `.prj`. The physical range is
/// in metres (see [`Elevation`](crate::Elevation)), and unknown if the unit is not a known length.
/// The size of texels is their size on the ground (see [`Georeference`](crate::Georeference)).
///
/// The units are the ones that the file names, or the units of the coordinate systems whose EPSG
/// codes it gives. If only one of ground and heights has a unit, both share it. If neither has one,
/// only their proportions are known. Heights that count downward are depths.
///
/// Row 0 lies in the north, however the file stores it. Texels that a mask excludes have no value;
/// the mask is in the file itself or in a sidecar with `.msk` after its name.
///
/// Texels without a value are an error unless [`HeightOptions::fill`] says otherwise. They are
/// filled smoothly from their surroundings. [`HeightMap::filled_texels`] counts them, and
/// [`HeightMap::holes`] marks them.
///
/// Peak memory is 8 bytes a texel and one row or block of the file; see the crate's documentation
/// for the exceptions.
///
/// # Errors
///
/// When the file cannot be read, is damaged, too large or not a picture. When the channel is
/// unknown, or no channel stands out. When texels have no value and are not to be filled, or no
/// texel has one. When values lie outside the range given. When an elevation model states an
/// impossible georeference, or its mask cannot be used.
pub fn read_height<'a>(
    source: impl Into<Source<'a>>,
    options: &HeightOptions,
) -> Result<HeightMap, ReadError> {
    Ok(read_height_file(source, options)?.map)
}

/// Height map with notes on everything that its reader ignored or assumed.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightFile {
    /// The map.
    pub map: HeightMap,
    /// Notes for the user.
    pub notes: Vec<ReadNote>,
}

/// Reads a height map like [`read_height`], and returns notes with it.
///
/// # Errors
///
/// See [`read_height`].
pub fn read_height_file<'a>(
    source: impl Into<Source<'a>>,
    options: &HeightOptions,
) -> Result<HeightFile, ReadError> {
    let source = source.into();
    let (map, remarks) = read(source, options).map_err(|problem| source.error(problem))?;
    let notes = remarks.into_iter().map(|remark| remark.of(source.name())).collect();
    Ok(HeightFile { map, notes })
}

fn read(source: Source<'_>, options: &HeightOptions) -> Result<(HeightMap, Vec<Remark>), ReadProblem> {
    if let Some(range) = options.range.and_then(HeightRange::between)
        && !(range[0] < range[1] && (range[1] - range[0]).is_finite())
    {
        return Err(ReadProblem::BadRange { range });
    }
    if let Some(range) = options.elevation_m
        && !(range[0] < range[1] && (range[1] - range[0]).is_finite())
    {
        return Err(ReadProblem::BadElevations { range });
    }
    let file = ImageFile::open(source, options.raw, BYTES_PER_TEXEL, options.max_bytes)?;
    let file = file.in_units(options.unit);
    let mut layout = file.layout().clone();
    let mut remarks = std::mem::take(&mut layout.remarks);
    let selection = select(&layout, options.channel.as_deref())?;
    let sample = layout.channels[selection.first()].sample;
    let terrain = layout.terrain()?;
    let elevation = terrain.map(|terrain| &terrain.channels[selection.first()]);
    let note = HeightNote::of_file(source, &layout);
    let mut samples = Samples::read(file, &selection, options.nodata)
        .map_err(|problem| with_alpha(problem, source, options))?;
    remarks.extend(examine(&mut samples, &layout, sample, options, note.is_some()));
    let (holes, nearly_grey) = (samples.holes(), samples.nearly_grey);
    let full_scale = layout.height_full_scale();
    let range = range(&samples, full_scale, options)?;
    let downward = elevation.is_some_and(|elevation| elevation.downward);
    let of_file = if downward { Convention::Depth } else { Convention::Height };
    let convention = options.convention.unwrap_or(of_file);
    let is_elevation = elevation.is_some() || options.elevation_m.is_some();
    let map = height_map(samples, range, is_elevation, convention, options)?;
    let range = match convention {
        Convention::Height => range,
        Convention::Depth => [range[1], range[0]],
    };
    let physical_range = match (note, elevation) {
        (Some(note), _) => Some(range.map(|raw| note.metres(raw / full_scale.unwrap_or(1.0)))),
        (None, Some(elevation)) if elevation.origin == UnitOrigin::Unnamed => Some(elevation.units(range)),
        (None, Some(elevation)) => elevation.metres(range),
        (None, None) => Some(range),
    };
    let noted_size = note.map(|note| note.texel_size_m([layout.width, layout.height]));
    let mut map = map.with_filled_texels(holes).with_nearly_grey_texels(nearly_grey);
    if let Some(range) = physical_range {
        map = map.with_physical_range(range)?;
    }
    if note.is_none() && elevation.is_some_and(Elevation::is_named) {
        map = map.with_named_heights();
    }
    if let (Some(HeightNote { of_mesh: true, .. }), Some(range)) = (note, physical_range)
        && range[0] <= range[1]
    {
        map = map.with_stated_displacement_m(range)?;
    }
    if let Some(size_m) = noted_size.or(terrain.and_then(Terrain::texel_size_m)) {
        map = map.with_texel_size_m(size_m)?;
    } else if let Some(size) = terrain.and_then(|terrain| terrain.relative_texel_size) {
        map = map.with_texel_size_m(size)?.with_unnamed_unit();
    }
    if let Some(range) = options.elevation_m {
        map = map.with_physical_range(range)?.with_named_heights();
    }
    Ok((map, remarks))
}

/// Reads heights from 0 to 1 without scaling: floats unchanged, integers of up to 16 bit divided by
/// their type's maximum. Beyond its edges the map is clamped.
///
/// # Errors
///
/// See [`read_height`]. Also when a float is below 0 or above 1.
pub fn read_stored_heights<'a>(
    source: impl Into<Source<'a>>,
    max_bytes: u64,
) -> Result<HeightMap, ReadError> {
    let source = source.into();
    let read_as_stored = || {
        let full_scale =
            ImageFile::open(source, None, BYTES_PER_TEXEL, max_bytes)?.layout().height_full_scale();
        let range = full_scale.is_none().then_some(HeightRange::Between([0.0, 1.0]));
        let wrap = Some(Wrap::Clamp);
        let options = HeightOptions { range, wrap, max_bytes, ..HeightOptions::default() };
        Ok(read(source, &options)?.0)
    };
    read_as_stored().map_err(|problem| source.error(problem))
}

/// Adds to the problem of a colour picture whether its alpha varies.
fn with_alpha(problem: ReadProblem, source: Source<'_>, options: &HeightOptions) -> ReadProblem {
    let ReadProblem::NotGrey { channels, column, row, .. } = problem else { return problem };
    let read = || {
        let file = ImageFile::open(source, options.raw, BYTES_PER_TEXEL, options.max_bytes).ok()?;
        let alpha = file.layout().channel("a")?;
        Samples::read(file, &Selection::Channel(alpha), None).ok()
    };
    let alpha_varies = read().is_some_and(|alpha| alpha.extremes[0] < alpha.extremes[1]);
    ReadProblem::NotGrey { channels, column, row, alpha_varies }
}

/// Determines the raw values that become 0 and 1.
fn range(
    samples: &Samples,
    full_scale: Option<f64>,
    options: &HeightOptions,
) -> Result<[f64; 2], ReadProblem> {
    let actual = samples.extremes;
    if actual[0] > actual[1] {
        return Err(ReadProblem::AllHoles);
    }
    match (options.range, full_scale) {
        (Some(HeightRange::Between(range)), _) if actual[0] < range[0] || actual[1] > range[1] => {
            Err(ReadProblem::OutsideRange { range, actual })
        }
        (Some(HeightRange::Between(range)), _) => Ok(range),
        (None, Some(full_scale)) => Ok([0.0, full_scale]),
        (Some(HeightRange::Extremes), _) | (None, None) => Ok(actual),
    }
}

fn height_map(
    mut samples: Samples,
    range: [f64; 2],
    is_elevation: bool,
    convention: Convention,
    options: &HeightOptions,
) -> Result<HeightMap, ReadProblem> {
    let (width, height) = (samples.width, samples.height);
    let wrap = options.wrap.unwrap_or(if is_elevation { Wrap::Clamp } else { Wrap::Repeat });
    let mut holes = None;
    if let Some(hole) = samples.first_hole {
        if !options.fill.fills(is_elevation || options.nodata.is_some()) {
            let (column, row) = ((hole % width as usize) as u32, (hole / width as usize) as u32);
            let Samples { not_finite, nodata, masked, .. } = samples;
            return Err(ReadProblem::Holes { not_finite, nodata, masked, column, row });
        }
        let is_hole =
            |column: u32, row: u32| samples.values[row as usize * width as usize + column as usize].is_nan();
        holes = Some(TexelMask::from_fn(width, height, is_hole));
        fill_holes(width, height, &mut samples.values, wrap);
    }
    let span = range[1] - range[0];
    let start = samples.offset - range[0];
    let (sign, zero) = match convention {
        Convention::Height => (1.0, 0.0),
        Convention::Depth => (-1.0, 1.0),
    };
    for value in &mut samples.values {
        let fraction = if span > 0.0 { (f64::from(*value) + start) / span } else { 0.0 };
        *value = (zero + sign * fraction).clamp(0.0, 1.0) as f32;
    }
    let map = HeightMap::new(width, height, samples.values, wrap)?;
    Ok(match holes {
        Some(holes) => map.with_holes(holes)?,
        None => map,
    })
}

/// Other names of channels of pictures.
const ALIASES: [(&str, &str); 8] = [
    ("red", "r"),
    ("green", "g"),
    ("blue", "b"),
    ("alpha", "a"),
    ("luminance", "y"),
    ("grey", "y"),
    ("gray", "y"),
    ("height", "y"),
];

/// Selects the channel asked for, or the one that stands out.
pub(crate) fn select(layout: &Layout, asked: Option<&str>) -> Result<Selection, ReadProblem> {
    if let Some(name) = asked {
        // EXR files may hold `r` beside `R`.
        let same = || layout.channels.iter().position(|channel| channel.name == name);
        let alias =
            || ALIASES.iter().find(|(alias, _)| alias.eq_ignore_ascii_case(name)).map(|(_, name)| *name);
        let channel = same().or_else(|| layout.channel(name)).or_else(|| layout.channel(alias()?));
        let known = layout.channel_names();
        let unknown = || UnknownName::new("channel", name, known.iter().map(String::as_str));
        return channel.map(Selection::Channel).ok_or_else(|| ReadProblem::UnknownChannel(unknown()));
    }
    if layout.channels.len() == 1 {
        return Ok(Selection::Channel(0));
    }
    let [y, r, g, b, a] = ["y", "r", "g", "b", "a"].map(|name| layout.channel(name));
    let count = layout.channels.len() - usize::from(a.is_some());
    match (y, r, g, b) {
        (Some(y), ..) if count == 1 => Ok(Selection::Channel(y)),
        (_, Some(r), Some(g), Some(b)) if count == 3 => Ok(Selection::Grey([r, g, b])),
        _ => Err(ReadProblem::ChooseChannel { channels: layout.channel_names() }),
    }
}
