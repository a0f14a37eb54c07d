//! Raw values of one channel, collected from a decoder at 4 bytes a texel, with statistics.

use crate::ReadProblem;
use crate::image_file::ImageFile;
use crate::layout::{Layout, SampleType};
use crate::nodata::Marker;
use crate::orientation::Line;

/// Greatest difference of red, green and blue of a grey, relative to the greatest value: the effect
/// of lossy compression.
const NEARLY_GREY: f64 = 6.0 / 255.0;

/// Raw values as `f32`, NaN where a texel has none.
///
/// Types wider than `f32` are stored as differences from the first value, so that rounding is
/// relative to the range of the values and not to their size. Heights far above sea level stay
/// exact to 2^-24 of their range.
pub(crate) struct Samples {
    pub width: u32,
    pub height: u32,
    pub values: Vec<f32>,
    /// Raw value of a stored 0.
    pub offset: f64,
    /// Least and greatest raw value; the first is above the second if no texel has a value.
    pub extremes: [f64; 2],
    /// Number of texels that are NaN, infinite or beyond `f32`.
    pub not_finite: u64,
    /// Number of texels with a nodata value: the file's, or the one that was given.
    pub nodata: u64,
    /// Number of texels among them with the given nodata value.
    pub given_nodata: u64,
    /// Number of texels that the file's mask excludes, whatever their value.
    pub masked: u64,
    /// Index of the first texel without a value, row by row from the top.
    pub first_hole: Option<usize>,
    /// Number of texels whose red, green and blue were nearly, but not quite, equal.
    pub nearly_grey: u64,
    /// Sample of white if white is stored as 0: the raw value is this sample minus the stored
    /// number.
    pub white: Option<f64>,
}

/// Channels from which samples are read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Selection {
    /// One channel.
    Channel(usize),
    /// Three channels that must be equal everywhere, or nearly so, since compression changes a grey
    /// to a colour.
    Grey([usize; 3]),
}

impl Selection {
    /// Returns the channel, or the first of the three.
    pub(crate) fn first(&self) -> usize {
        match self {
            Self::Channel(channel) | Self::Grey([channel, ..]) => *channel,
        }
    }
}

impl Samples {
    /// Reads the texels of a selection. Texels with the file's nodata value or `nodata` have no
    /// value.
    pub(crate) fn read(
        file: ImageFile<'_>,
        selection: &Selection,
        nodata: Option<f64>,
    ) -> Result<Self, ReadProblem> {
        let white = file.white_of_heights(selection.first());
        let file = file.into_stored();
        let layout = file.layout();
        let names = layout.channel_names();
        let channels = match selection {
            Selection::Channel(channel) => vec![*channel],
            Selection::Grey(channels) => channels.to_vec(),
        };
        let sample = layout.channels[selection.first()].sample;
        let mut collector = Collector::new(layout, sample, white, nodata)?;
        // Floats are not compressed lossily.
        let most_apart = layout.height_full_scale().map_or(0.0, |full| NEARLY_GREY * full);
        let mut means = Vec::new();
        file.decode_mask(selection.first(), &mut |line| {
            collector.mask(&line);
            Ok(())
        })?;
        file.decode(&channels, &mut |line| {
            let [_, _, _] = channels[..] else {
                collector.take(&line, channels.len());
                return Ok(());
            };
            means.clear();
            let texels = line.samples.as_chunks::<3>().0;
            for (at, texel) in line.places(texels.len()).zip(texels) {
                if !texel[1..].iter().any(|sample| differ(*sample, texel[0])) {
                    means.push(texel[0]);
                    continue;
                }
                let least = texel.iter().copied().fold(f64::INFINITY, f64::min);
                let greatest = texel.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                // A texel with NaN is not near.
                let is_near = greatest - least <= most_apart && texel.iter().all(|sample| sample.is_finite());
                if !is_near {
                    let width = collector.samples.width as usize;
                    let [column, row] = [at % width, at / width].map(|at| at as u32);
                    let channels = names.clone();
                    return Err(ReadProblem::NotGrey { channels, column, row, alpha_varies: false });
                }
                collector.samples.nearly_grey += 1;
                means.push(texel.iter().sum::<f64>() / 3.0);
            }
            collector.take(&line.with(&means), 1);
            Ok(())
        })?;
        Ok(collector.samples)
    }

    /// Converts a stored number to its raw value, or a raw value to its stored number.
    pub(crate) fn raw(&self, stored: f64) -> f64 {
        self.white.map_or(stored, |white| white - stored)
    }

    /// Converts two raw values to stored numbers, the lesser first.
    pub(crate) fn stored(&self, values: [f64; 2]) -> [f64; 2] {
        let [a, b] = values.map(|value| self.raw(value));
        [a.min(b), a.max(b)]
    }

    /// Iterates over the raw values of all texels that have one.
    pub(crate) fn raw_values(&self) -> impl Iterator<Item = f64> {
        self.values.iter().filter(|value| !value.is_nan()).map(|value| f64::from(*value) + self.offset)
    }

    /// Turns texels with certain raw values into nodata. `extremes` are the extremes of the others.
    pub(crate) fn forget(&mut self, is_nodata: impl Fn(f64) -> bool, extremes: [f64; 2]) {
        for (at, value) in self.values.iter_mut().enumerate() {
            if !value.is_nan() && is_nodata(f64::from(*value) + self.offset) {
                *value = f32::NAN;
                self.nodata += 1;
                self.first_hole = Some(self.first_hole.map_or(at, |hole| hole.min(at)));
            }
        }
        self.extremes = extremes;
    }

    /// Number of texels without a value.
    pub(crate) fn holes(&self) -> u64 {
        self.not_finite + self.nodata + self.masked
    }
}

fn differ(a: f64, b: f64) -> bool {
    a != b && !(a.is_nan() && b.is_nan())
}

struct Collector {
    samples: Samples,
    /// Markers of the file's nodata value and of the given one.
    nodata: [Option<Marker>; 2],
    exact: bool,
}

impl Collector {
    fn new(
        layout: &Layout,
        sample: SampleType,
        white: Option<f64>,
        nodata: Option<f64>,
    ) -> Result<Self, ReadProblem> {
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
            given_nodata: 0,
            masked: 0,
            first_hole: None,
            nearly_grey: 0,
            white,
        };
        let nodata = [layout.nodata, nodata].map(|number| Some(Marker::new(number?, sample)));
        Ok(Self { samples, nodata, exact: sample.fits_f32() })
    }

    /// Extends the values to the end of a line. Memory is touched only as far as the decoder has
    /// come: a cut-off file costs only its own size.
    fn extend_to(&mut self, line: &Line<'_>, count: usize) {
        let (values, end) = (&mut self.samples.values, line.end(count));
        if values.len() < end {
            values.resize(end, 0.0);
        }
    }

    /// Marks the texels that a mask excludes, before their values come.
    fn mask(&mut self, line: &Line<'_>) {
        self.extend_to(line, line.samples.len());
        let values = &mut self.samples.values;
        for (at, _) in line.places(line.samples.len()).zip(line.samples).filter(|(_, mask)| **mask == 0.0) {
            values[at] = f32::NAN;
        }
    }

    fn take(&mut self, line: &Line<'_>, channels: usize) {
        let count = line.samples.len() / channels;
        self.extend_to(line, count);
        let samples = &mut self.samples;
        for (at, texel) in line.places(count).zip(line.samples.chunks_exact(channels)) {
            let (stored, slot) = (texel[0], &mut samples.values[at]);
            let value = samples.white.map_or(stored, |white| white - stored);
            let is_masked = slot.is_nan();
            let [is_declared, is_given] =
                self.nodata.map(|marker| marker.is_some_and(|marker| marker.marks(stored)));
            let is_nodata = is_declared || is_given;
            if is_masked || is_nodata || value.is_nan() || value.abs() > f64::from(f32::MAX) {
                *slot = f32::NAN;
                samples.given_nodata += u64::from(is_given);
                *match (is_masked, is_nodata) {
                    (true, _) => &mut samples.masked,
                    (false, true) => &mut samples.nodata,
                    (false, false) => &mut samples.not_finite,
                } += 1;
                samples.first_hole = Some(samples.first_hole.map_or(at, |hole| hole.min(at)));
                continue;
            }
            if !self.exact && samples.extremes[0] > samples.extremes[1] {
                samples.offset = value;
            }
            samples.extremes = [samples.extremes[0].min(value), samples.extremes[1].max(value)];
            *slot = (value - samples.offset) as f32;
        }
    }
}
