//! What a file holds, without judging it.

use crate::examine::examine;
use crate::height::{BYTES_PER_TEXEL, HeightOptions, select};
use crate::image_file::ImageFile;
use crate::layout::{Channel, Format};
use crate::samples::Samples;
use crate::{Elevation, Georeference, HeightNote, ReadError, ReadNote, ReadProblem, Source};

/// Bins of [`Values::histogram`].
pub const HISTOGRAM_BINS: usize = 64;

/// What a file says of itself, and what its values are.
#[derive(Clone, Debug, PartialEq)]
pub struct SourceInfo {
    /// The format, by the file's content.
    pub format: Format,
    /// Width in texels.
    pub width: u32,
    /// Height in texels.
    pub height: u32,
    /// The channels, in the file's order, with type and depth of their samples.
    pub channels: Vec<Channel>,
    /// The raw value that marks texels without a value, where the file names one.
    pub nodata_value: Option<f64>,
    /// Size of a texel along `u` and `v` in metres, where the file says so.
    pub texel_size_m: Option<[f64; 2]>,
    /// What the file says of the ground, where it says anything.
    pub georeference: Option<Georeference>,
    /// What the file notes of its size in the world, where Relief wrote it.
    pub note: Option<HeightNote>,
    /// The orientation of EXIF or TIFF by which the picture is turned, from 2 to 8; none where it is shown as
    /// it is stored.
    pub orientation: Option<u32>,
    /// The values of the channel that [`crate::read_height`] would read; none where it would ask for one.
    pub values: Option<Values>,
    /// What [`crate::read_height_file`] would say of reading it.
    pub notes: Vec<ReadNote>,
}

/// The values of one channel, in the file's own units.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// The channel; of grey stored as red, green and blue, the first of them.
    pub channel: String,
    /// The raw values that [`crate::read_height`] makes 0 and 1 if no range is given; none where no texel has
    /// a value.
    pub normalised_range: Option<[f64; 2]>,
    /// Least and greatest value; none where no texel has one.
    pub range: Option<[f64; 2]>,
    /// How many different values occur (at the precision of `f32` relative to their range).
    pub levels: u64,
    /// How many texels lie in each of [`HISTOGRAM_BINS`] equal parts of `range`.
    pub histogram: [u64; HISTOGRAM_BINS],
    /// Texels that are NaN or infinite.
    pub not_finite: u64,
    /// Texels that hold the file's nodata value.
    pub nodata: u64,
    /// Texels that the file's mask leaves out.
    pub masked: u64,
    /// What the values stand for, where the file is an elevation model.
    pub elevation: Option<Elevation>,
    /// Whether the map goes on smoothly across its edges; none where a texel has no value.
    pub tiling: Option<Tiling>,
}

/// Whether a map goes on smoothly across its edges.
///
/// The step between the last and the first column is compared with the steps inside the map: `seam` is its
/// mean absolute difference over all rows, divided by the greatest such mean of two neighbouring columns (of
/// rows, for `v`). A map made to tile has a step there as any other; one that is cut out of something larger
/// has a multiple. A side of one texel tiles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tiling {
    /// The ratio along `u` and `v`; 0 for constant maps.
    pub seam: [f64; 2],
    /// Whether the ratio is at most [`SEAM_LIMIT`], along `u` and `v`.
    pub tiles: [bool; 2],
}

/// The largest seam of a map that tiles. Real tiling maps have at most 0.9, since the seam is one of many
/// steps, cut-outs 1.8 and far more.
pub const SEAM_LIMIT: f64 = 1.25;

/// Reads a file, or the bytes of one, and says what it holds. Options are used as in [`crate::read_height`]:
/// `channel`, `nodata`, `unit`, `range` (for notes alone), `raw` and `max_bytes`.
///
/// Texels without a value are counted, not an error; nor is a picture in colour, of which `values` are not
/// given.
///
/// # Errors
///
/// When the file cannot be read, is damaged, too large or not a picture, when the channel is unknown, or when
/// an elevation model says of itself what cannot be or its mask cannot be used.
pub fn inspect<'a>(source: impl Into<Source<'a>>, options: &HeightOptions) -> Result<SourceInfo, ReadError> {
    let source = source.into();
    read(source, options).map_err(|problem| source.error(problem))
}

fn read(source: Source<'_>, options: &HeightOptions) -> Result<SourceInfo, ReadProblem> {
    let file = ImageFile::open(source, options.raw, BYTES_PER_TEXEL, options.max_bytes)?;
    let file = file.in_units(options.unit);
    let mut layout = file.layout().clone();
    let mut remarks = std::mem::take(&mut layout.remarks);
    let terrain = layout.terrain()?.cloned();
    let note = HeightNote::of_file(source, &layout);
    let values = match select(&layout, options.channel.as_deref()) {
        Ok(selection) => {
            let channel = selection.first();
            let elevation = terrain.as_ref().map(|terrain| terrain.channels[channel].clone());
            match Samples::read(file, &selection, options.nodata) {
                Ok(mut samples) => {
                    let sample = layout.channels[channel].sample;
                    remarks.extend(examine(&mut samples, &layout, sample, options, note.is_some()));
                    let name = &layout.channels[channel].name;
                    Some(values(samples, name, layout.height_full_scale(), elevation))
                }
                Err(ReadProblem::NotGrey { .. }) => None,
                Err(problem) => return Err(problem),
            }
        }
        Err(ReadProblem::ChooseChannel { .. }) => None,
        Err(problem) => return Err(problem),
    };
    let orientation = layout.turning_number();
    Ok(SourceInfo {
        format: layout.format,
        width: layout.width,
        height: layout.height,
        channels: layout.channels,
        nodata_value: layout.nodata,
        orientation,
        texel_size_m: note
            .map(|note| note.texel_size_m([layout.width, layout.height]))
            .or_else(|| terrain.as_ref()?.texel_size_m()),
        georeference: terrain.and_then(|terrain| terrain.georeference),
        note,
        values,
        notes: remarks.into_iter().map(|remark| remark.of(source.name())).collect(),
    })
}

fn values(
    mut samples: Samples,
    channel: &str,
    full_scale: Option<f64>,
    elevation: Option<Elevation>,
) -> Values {
    let [least, greatest] = samples.extremes;
    let range = (least <= greatest).then_some([least, greatest]);
    let mut histogram = [0; HISTOGRAM_BINS];
    let span = greatest - least;
    for &value in samples.values.iter().filter(|value| !value.is_nan()) {
        let fraction = if span > 0.0 { (f64::from(value) + samples.offset - least) / span } else { 0.0 };
        histogram[((fraction * HISTOGRAM_BINS as f64) as usize).min(HISTOGRAM_BINS - 1)] += 1;
    }
    let tiling = (samples.holes() == 0).then(|| tiling(&samples));
    // Sorted in place: the order is not needed any more.
    samples.values.retain(|value| !value.is_nan());
    samples.values.sort_unstable_by(f32::total_cmp);
    let levels = samples.values.chunk_by(|a, b| a == b).count() as u64;
    Values {
        channel: channel.to_owned(),
        normalised_range: full_scale.map(|full_scale| [0.0, full_scale]).or(range),
        range,
        levels,
        histogram,
        not_finite: samples.not_finite,
        nodata: samples.nodata,
        masked: samples.masked,
        elevation,
        tiling,
    }
}

fn tiling(samples: &Samples) -> Tiling {
    let (width, height) = (samples.width as usize, samples.height as usize);
    let value = |column: usize, row: usize| f64::from(samples.values[row * width + column]);
    // Sums of the steps from each column to the next, and from each row; the last of each is the seam.
    let mut across = vec![0.0f64; width];
    let mut down = vec![0.0f64; height];
    for (row, down) in down.iter_mut().enumerate() {
        for (column, across) in across.iter_mut().enumerate() {
            let here = value(column, row);
            *across += (value((column + 1) % width, row) - here).abs();
            *down += (value(column, (row + 1) % height) - here).abs();
        }
    }
    let seam = [across, down].map(|mut steps| {
        let seam = steps.pop().unwrap_or(0.0);
        let steepest = steps.into_iter().fold(0.0, f64::max);
        if seam > 0.0 { seam / steepest } else { 0.0 }
    });
    Tiling { seam, tiles: seam.map(|seam| seam <= SEAM_LIMIT) }
}
