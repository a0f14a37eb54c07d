//! Reader of colour pictures for shading, in linear light.

use crate::image_file::ImageFile;
use crate::layout::{Layout, SampleKind};
use crate::orientation::Line;
use crate::{ReadError, ReadProblem, Source};

/// Picture in linear light (BT.709 primaries if the file is sRGB), row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Width in texels.
    pub width: u32,
    /// Height in texels.
    pub height: u32,
    /// Red, green, blue and opacity of each texel. Opacity is 1 if the file has none; colours are
    /// not multiplied by it. Float files may hold colours above 1 and below 0.
    pub texels: Vec<[f32; 4]>,
}

const PICTURE_BYTES_PER_TEXEL: u64 = 16;

/// Transfer curve of integer samples of up to 16 bit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Curve {
    /// The sRGB curve (IEC 61966-2-1).
    #[default]
    Srgb,
    /// No curve: samples are proportional to light.
    Linear,
}

/// Reads a picture like [`read_picture_as`], with the curve that the file declares. Integers are
/// sRGB, unless a PNG declares them as linear by a gamma of 1 (chunk `gAMA`) or a transfer function
/// (`cICP`).
///
/// # Errors
///
/// See [`read_picture_as`].
pub fn read_picture<'a>(source: impl Into<Source<'a>>, max_bytes: u64) -> Result<Picture, ReadError> {
    let source = source.into();
    let open = || ImageFile::open(source, None, PICTURE_BYTES_PER_TEXEL, max_bytes);
    open().and_then(|file| read(file, None)).map_err(|problem| source.error(problem))
}

/// Reads a picture of a glTF: as it is stored, ignoring its orientation, and by `curve`, ignoring its
/// colour chunks (glTF 2.0, 3.8.4.1). Also returns whether an orientation was ignored.
///
/// # Errors
///
/// See [`read_picture_as`].
pub(crate) fn read_gltf_picture(
    source: Source<'_>,
    curve: Curve,
    max_bytes: u64,
) -> Result<(Picture, bool), ReadError> {
    let read = || {
        let file = ImageFile::open(source, None, PICTURE_BYTES_PER_TEXEL, max_bytes)?;
        let is_turned = file.layout().turning_number().is_some();
        Ok((read(file.unturned(), Some(curve))?, is_turned))
    };
    read().map_err(|problem| source.error(problem))
}

/// Reads a picture from a file or from the bytes of one. Integers of up to 16 bit are decoded by
/// `curve`; floats are linear. Grey becomes three equal channels. The picture is turned by its
/// orientation. At most `max_bytes` of memory are used: 16 bytes a texel.
///
/// # Errors
///
/// When the file cannot be read, is damaged, too large or not a picture; when its channels are not
/// colours; or when it holds a NaN or an infinite value.
pub fn read_picture_as<'a>(
    source: impl Into<Source<'a>>,
    curve: Curve,
    max_bytes: u64,
) -> Result<Picture, ReadError> {
    let source = source.into();
    let open = || ImageFile::open(source, None, PICTURE_BYTES_PER_TEXEL, max_bytes);
    open().and_then(|file| read(file, Some(curve))).map_err(|problem| source.error(problem))
}

fn read(file: ImageFile<'_>, curve: Option<Curve>) -> Result<Picture, ReadProblem> {
    let of_file = if file.layout().is_linear { Curve::Linear } else { Curve::Srgb };
    let curve = curve.unwrap_or(of_file);
    let layout = file.layout().clone();
    let channels = colour_channels(&layout)?;
    let transfer = Transfer::of(&layout, channels[0], curve)?;
    // Colours come first (one for grey, else three), then opacity.
    let colours = if channels.len() >= 3 { 3 } else { 1 };
    let texels = collect(file, &channels, [0.0; 4], |samples| {
        let colour = |channel: usize| transfer.linear(samples[channel.min(colours - 1)]);
        let opacity = samples.get(colours).map_or(1.0, |&sample| transfer.fraction(sample));
        [colour(0), colour(1), colour(2), opacity]
    })?;
    let width = layout.width as usize;
    let bad = |texel: &[f32; 4]| texel.iter().any(|value| !value.is_finite());
    if let Some(at) = texels.iter().position(bad) {
        let not_finite = texels.iter().filter(|texel| bad(texel)).count() as u64;
        let (column, row) = ((at % width) as u32, (at / width) as u32);
        return Err(ReadProblem::NotFinite { not_finite, column, row });
    }
    Ok(Picture { width: layout.width, height: layout.height, texels })
}

/// Reads the chosen channels of every texel, and collects the results of `texel`.
pub(crate) fn collect<T: Copy>(
    file: ImageFile<'_>,
    channels: &[usize],
    empty: T,
    texel: impl Fn(&[f64]) -> T,
) -> Result<Vec<T>, ReadProblem> {
    let width = file.layout().width as usize;
    let count = width * file.layout().height as usize;
    let mut texels = Vec::new();
    let needed = (count * size_of::<T>()) as u64;
    texels.try_reserve_exact(count).map_err(|_| ReadProblem::OutOfMemory { needed })?;
    file.decode(channels, &mut |line: Line<'_>| {
        let found = line.samples.chunks_exact(channels.len());
        if texels.len() < line.end(found.len()) {
            texels.resize(line.end(found.len()), empty);
        }
        for (at, samples) in line.places(found.len()).zip(found) {
            texels[at] = texel(samples);
        }
        Ok(())
    })?;
    Ok(texels)
}

/// Channels of a picture: red, green, blue or grey, then opacity if there is one.
fn colour_channels(layout: &Layout) -> Result<Vec<usize>, ReadProblem> {
    let [y, r, g, b, a] = ["y", "r", "g", "b", "a"].map(|name| layout.channel(name));
    let mut channels = match (r, g, b, y) {
        (Some(r), Some(g), Some(b), _) => vec![r, g, b],
        (_, _, _, Some(y)) => vec![y],
        _ if layout.channels.len() == 1 => vec![0],
        _ => {
            return Err(ReadProblem::NoColour { what: "picture", channels: layout.channel_names() });
        }
    };
    channels.extend(a.filter(|a| !channels.contains(a)));
    Ok(channels)
}

/// Conversion of samples to light.
enum Transfer {
    /// Table of linear values by sample, and the sample of value 1.
    Table(Vec<f32>, f64),
    Linear,
}

impl Transfer {
    fn of(layout: &Layout, channel: usize, curve: Curve) -> Result<Self, ReadProblem> {
        let sample = layout.channels[channel].sample;
        match (layout.full_scale, sample.kind) {
            (Some(full_scale), SampleKind::Unsigned) => {
                let levels = full_scale as u32;
                let linear = |level: u32| {
                    let fraction = f64::from(level) / full_scale;
                    if curve == Curve::Srgb { srgb_to_linear(fraction) } else { fraction }
                };
                Ok(Self::Table((0..=levels).map(|level| linear(level) as f32).collect(), full_scale))
            }
            (_, SampleKind::Float) => Ok(Self::Linear),
            _ => Err(ReadProblem::Unsupported {
                what: format!("colours of {sample} samples"),
                advice: "export 8 or 16-bit unsigned integers, or floats",
            }),
        }
    }

    fn linear(&self, sample: f64) -> f32 {
        match self {
            Self::Table(table, _) => table.get(sample as usize).copied().unwrap_or(1.0),
            Self::Linear => sample as f32,
        }
    }

    fn fraction(&self, sample: f64) -> f32 {
        match self {
            Self::Table(_, full_scale) => (sample / full_scale) as f32,
            Self::Linear => sample as f32,
        }
    }
}

/// Decodes a value by the sRGB curve (IEC 61966-2-1). Both values are in `[0, 1]`.
pub fn srgb_to_linear(encoded: f64) -> f64 {
    if encoded <= 0.04045 { encoded / 12.92 } else { ((encoded + 0.055) / 1.055).powf(2.4) }
}

/// Encodes a linear value by the sRGB curve. Both values are in `[0, 1]`.
pub fn linear_to_srgb(linear: f64) -> f64 {
    if linear <= 0.003_130_8 { linear * 12.92 } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_curve_and_its_inverse_cancel() {
        for level in 0..=255 {
            let encoded = f64::from(level) / 255.0;
            assert!((linear_to_srgb(srgb_to_linear(encoded)) - encoded).abs() < 1e-6, "{level}");
        }
    }
}
