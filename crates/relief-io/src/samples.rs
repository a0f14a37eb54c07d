//! One channel's raw values, collected from a decoder at 4 bytes a texel, with what has to be known of them.

use crate::ReadProblem;
use crate::image_file::ImageFile;
use crate::layout::{Layout, Span};

/// How far apart red, green and blue of a grey may be, as a part of the greatest value: what lossy
/// compression does to it.
const NEARLY_GREY: f64 = 6.0 / 255.0;

/// Raw values as `f32`, NaN where a texel has none.
///
/// Types wider than `f32` are stored as differences from the first value, so that their rounding is relative
/// to the range of the values and not to their size (heights far above sea level stay exact to 2^-24 of their
/// range).
pub(crate) struct Samples {
    pub width: u32,
    pub height: u32,
    pub values: Vec<f32>,
    /// The raw value of a stored 0.
    pub offset: f64,
    /// Least and greatest raw value; the first is above the second where no texel has a value.
    pub extremes: [f64; 2],
    /// Texels that are NaN, infinite or beyond `f32`.
    pub not_finite: u64,
    /// Texels that hold the file's nodata value.
    pub nodata: u64,
    /// Texels that the file's mask leaves out, whatever they hold.
    pub masked: u64,
    /// The first texel without a value, in rows from the top.
    pub first_hole: Option<usize>,
    /// Texels whose red, green and blue were nearly, but not quite, equal.
    pub nearly_grey: u64,
}

/// Where the samples come from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Selection {
    /// One channel.
    Channel(usize),
    /// Three channels that have to be equal everywhere, or nearly so: compression makes a colour of a grey.
    Grey([usize; 3]),
}

impl Selection {
    /// The channel; of grey the first of them.
    pub(crate) fn first(&self) -> usize {
        match self {
            Self::Channel(channel) | Self::Grey([channel, ..]) => *channel,
        }
    }
}

impl Samples {
    pub(crate) fn read(file: ImageFile<'_>, selection: &Selection) -> Result<Self, ReadProblem> {
        let file = file.of_heights();
        let layout = file.layout();
        let names = layout.channel_names();
        let channels = match selection {
            Selection::Channel(channel) => vec![*channel],
            Selection::Grey(channels) => channels.to_vec(),
        };
        let sample = layout.channels[selection.first()].sample;
        let mut collector = Collector::new(layout, sample.fits_f32())?;
        // Floats come from no lossy compression.
        let most_apart = layout.height_full_scale().map_or(0.0, |full| NEARLY_GREY * full);
        let mut means = Vec::new();
        file.decode_mask(selection.first(), &mut |span| {
            collector.mask(&span);
            Ok(())
        })?;
        file.decode(&channels, &mut |span| {
            let [_, _, _] = channels[..] else {
                collector.take(&span, channels.len());
                return Ok(());
            };
            means.clear();
            for (at, texel) in span.samples.chunks_exact(3).enumerate() {
                if !texel[1..].iter().any(|sample| differ(*sample, texel[0])) {
                    means.push(texel[0]);
                    continue;
                }
                let least = texel.iter().copied().fold(f64::INFINITY, f64::min);
                let greatest = texel.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                // Not so where one of them is NaN.
                let is_near = greatest - least <= most_apart && texel.iter().all(|sample| sample.is_finite());
                if !is_near {
                    let (column, row) = (span.column + at as u32 * span.step, span.row);
                    let channels = names.clone();
                    return Err(ReadProblem::NotGrey { channels, column, row, alpha_varies: false });
                }
                collector.samples.nearly_grey += 1;
                means.push(texel.iter().sum::<f64>() / 3.0);
            }
            collector.take(&Span { samples: &means, ..span }, 1);
            Ok(())
        })?;
        Ok(collector.samples)
    }

    /// How many texels have no value.
    pub(crate) fn holes(&self) -> u64 {
        self.not_finite + self.nodata + self.masked
    }
}

fn differ(a: f64, b: f64) -> bool {
    a != b && !(a.is_nan() && b.is_nan())
}

struct Collector {
    samples: Samples,
    nodata: Option<f64>,
    exact: bool,
}

impl Collector {
    fn new(layout: &Layout, exact: bool) -> Result<Self, ReadProblem> {
        let texels = layout.width as usize * layout.height as usize;
        let mut values = Vec::new();
        let needed = 4 * texels as u64;
        values.try_reserve_exact(texels).map_err(|_| ReadProblem::OutOfMemory { needed })?;
        let samples = Samples {
            width: layout.width,
            height: layout.height,
            values,
            offset: 0.0,
            extremes: [f64::INFINITY, f64::NEG_INFINITY],
            not_finite: 0,
            nodata: 0,
            masked: 0,
            first_hole: None,
            nearly_grey: 0,
        };
        Ok(Self { samples, nodata: layout.nodata, exact })
    }

    /// The texel where a span begins, with room for all of the span. Memory is touched only as far as the
    /// decoder has come: a cut-off file costs what it holds.
    fn make_room(&mut self, span: &Span<'_>, channels: usize) -> (usize, usize) {
        let values = &mut self.samples.values;
        let first = span.row as usize * self.samples.width as usize + span.column as usize;
        let count = span.samples.len() / channels;
        let end = first + count.saturating_sub(1) * span.step as usize + 1;
        if values.len() < end {
            values.resize(end, 0.0);
        }
        (first, end)
    }

    /// Marks the texels that a mask leaves out, before their values come.
    fn mask(&mut self, span: &Span<'_>) {
        let (first, end) = self.make_room(span, 1);
        let stored = self.samples.values[first..end].iter_mut().step_by(span.step as usize);
        for (stored, _) in stored.zip(span.samples).filter(|(_, mask)| **mask == 0.0) {
            *stored = f32::NAN;
        }
    }

    fn take(&mut self, span: &Span<'_>, channels: usize) {
        let (first, end) = self.make_room(span, channels);
        let samples = &mut self.samples;
        let stored = samples.values[first..end].iter_mut().step_by(span.step as usize);
        for (index, (stored, texel)) in stored.zip(span.samples.chunks_exact(channels)).enumerate() {
            let value = texel[0];
            let is_masked = stored.is_nan();
            let is_nodata = self.nodata == Some(value);
            if is_masked || is_nodata || value.is_nan() || value.abs() > f64::from(f32::MAX) {
                *stored = f32::NAN;
                *match (is_masked, is_nodata) {
                    (true, _) => &mut samples.masked,
                    (false, true) => &mut samples.nodata,
                    (false, false) => &mut samples.not_finite,
                } += 1;
                let at = first + index * span.step as usize;
                samples.first_hole = Some(samples.first_hole.map_or(at, |hole| hole.min(at)));
                continue;
            }
            if !self.exact && samples.extremes[0] > samples.extremes[1] {
                samples.offset = value;
            }
            samples.extremes = [samples.extremes[0].min(value), samples.extremes[1].max(value)];
            *stored = (value - samples.offset) as f32;
        }
    }
}
