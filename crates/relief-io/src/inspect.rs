//! Inspection of a file's content, without judging it.

use crate::banding::banding;
use crate::examine::examine;
use crate::height::{BYTES_PER_TEXEL, HeightOptions, select};
use crate::image_file::ImageFile;
use crate::layout::{Channel, Format};
use crate::samples::Samples;
use crate::{Elevation, Georeference, HeightNote, ReadError, ReadNote, ReadProblem, Source};

/// Number of bins of [`Values::histogram`].
pub const HISTOGRAM_BINS: usize = 64;

/// Header of a file and statistics of its values.
#[derive(Clone, Debug, PartialEq)]
pub struct SourceInfo {
    /// Format, recognised by the file's content.
    pub format: Format,
    /// Width in texels.
    pub width: u32,
    /// Height in texels.
    pub height: u32,
    /// Channels, in the file's order, with type and depth of their samples.
    pub channels: Vec<Channel>,
    /// Nodata value: the raw value that marks texels without a value, if the file names one.
    pub nodata_value: Option<f64>,
    /// Size of a texel along `u` and `v` in metres, if the file gives it.
    pub texel_size_m: Option<[f64; 2]>,
    /// Georeference, if the file has one.
    pub georeference: Option<Georeference>,
    /// Note on the map's real size, if Relief wrote the file.
    pub note: Option<HeightNote>,
    /// Orientation number of EXIF or TIFF by which the picture is turned, from 2 to 8; none if it
    /// is displayed as stored.
    pub orientation: Option<u32>,
    /// Values of the channel that [`crate::read_height`] would read; none if it would ask for a
    /// channel.
    pub values: Option<Values>,
    /// Notes that [`crate::read_height_file`] would return, and a note on steps that show.
    pub notes: Vec<ReadNote>,
}

/// Statistics of one channel, in the file's own units.
#[derive(Clone, Debug, PartialEq)]
pub struct Values {
    /// Name of the channel; the first one if grey is stored as red, green and blue.
    pub channel: String,
    /// Raw values that [`crate::read_height`] maps to 0 and 1 if no range is given; none if no
    /// texel has a value.
    pub normalised_range: Option<[f64; 2]>,
    /// Least and greatest value; none if no texel has one.
    pub range: Option<[f64; 2]>,
    /// Number of different values, at the precision of `f32` relative to their range.
    pub levels: u64,
    /// Number of texels in each of [`HISTOGRAM_BINS`] equal parts of `range`.
    pub histogram: [u64; HISTOGRAM_BINS],
    /// Number of texels that are NaN or infinite.
    pub not_finite: u64,
    /// Number of texels with the nodata value.
    pub nodata: u64,
    /// Number of texels that the file's mask excludes.
    pub masked: u64,
    /// Meaning of the values, if the file is an elevation model.
    pub elevation: Option<Elevation>,
    /// Smoothness across the map's edges; none if a texel has no value.
    pub tiling: Option<Tiling>,
}

/// Smoothness of a map across its edges, which decides whether it tiles.
///
/// The step between the last and the first column is compared with the steps inside the map. `seam`
/// is the mean absolute difference over all rows at the edge, divided by the greatest such mean of
/// two neighbouring columns (of rows, for `v`). A map made to tile has an ordinary step at its
/// edges; one cut out of a larger map has a multiple. A side of one texel tiles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tiling {
    /// Ratio along `u` and `v`; 0 for constant maps.
    pub seam: [f64; 2],
    /// Whether the ratio is at most [`SEAM_LIMIT`], along `u` and `v`.
    pub tiles: [bool; 2],
}

/// Greatest seam of a map that tiles. Real tiling maps have at most 0.9, since the seam is one of
/// many steps; cut-outs have 1.8 and far more.
pub const SEAM_LIMIT: f64 = 1.25;

/// Inspects a file, or the bytes of one. Options are used as in [`crate::read_height`]: `channel`,
/// `nodata`, `unit`, `range` (for notes only), `raw` and `max_bytes`.
///
/// Texels without a value are counted and are no error. A picture in colour is no error either, but
/// has no `values`.
///
/// # Errors
///
/// When the file cannot be read, is damaged, too large or not a picture; when the channel is
/// unknown; or when an elevation model states an impossible georeference or its mask cannot be
/// used.
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
                    remarks.extend(banding(&samples));
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
    // The values are sorted in place, since their order is not needed any more.
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
    // Sums of the steps from each column to the next, and from each row to the next; the last step
    // is the seam.
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
