//! Reader of tangent-space normal maps.

use std::fmt;
use std::str::FromStr;

use relief_core::registry::UnknownName;

use crate::image_file::ImageFile;
use crate::layout::{Layout, SampleKind};
use crate::picture::collect;
use crate::{ReadError, ReadProblem, Source};

/// Direction of a normal map's green channel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum GreenSign {
    /// Up in the picture (OpenGL, glTF, Blender, Godot, Unity): `+y`.
    #[default]
    PlusY,
    /// Down in the picture (DirectX, Unreal): `-y`.
    MinusY,
}

impl GreenSign {
    /// Returns the name of this direction, as files and the command spell it: `+y` or `-y`.
    pub const fn name(self) -> &'static str {
        match self {
            GreenSign::PlusY => "+y",
            GreenSign::MinusY => "-y",
        }
    }
}

impl fmt::Display for GreenSign {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for GreenSign {
    type Err = UnknownName;

    /// Parses `+y` and `-y`, `up` and `down`, or `opengl` and `directx`, in any case.
    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let all = [
            ("+y", GreenSign::PlusY),
            ("-y", GreenSign::MinusY),
            ("up", GreenSign::PlusY),
            ("down", GreenSign::MinusY),
            ("opengl", GreenSign::PlusY),
            ("directx", GreenSign::MinusY),
        ];
        let known = all.into_iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|(_, sign)| sign);
        known.ok_or_else(|| UnknownName::new("green sign", name, all.map(|(known, _)| known)))
    }
}

/// Normal map, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct NormalMap {
    /// Width in texels.
    pub width: u32,
    /// Height in texels.
    pub height: u32,
    /// Unit normals: `x` along growing `u`, `y` up in the picture (along falling `v`), `z` out of the
    /// surface.
    pub normals: Vec<[f32; 3]>,
    /// Number of texels without a direction (shorter than [`SHORTEST`], or not finite). They are
    /// set to `(0, 0, 1)`.
    pub degenerate: u64,
}

/// Least length of a decoded normal that has a direction. Rounding to 8 bits alone moves a normal
/// by 0.007.
pub const SHORTEST: f32 = 0.1;

const NORMAL_BYTES_PER_TEXEL: u64 = 12;

/// While opacity is split from the vectors, memory holds both.
const BYTES_PER_TEXEL_WITH_OPACITY: u64 = 32;

/// Decoded vectors of a normal map's file, before they are normalised.
#[derive(Clone, Debug, PartialEq)]
pub struct NormalVectors {
    /// Width in texels.
    pub width: u32,
    /// Height in texels.
    pub height: u32,
    /// `x`, `y` and `z` of each texel, of any length and perhaps not finite, row by row from the top.
    pub vectors: Vec<[f32; 3]>,
    /// Opacity of each texel from 0 to 1, if the file has it. Its meaning varies: some files mark
    /// texels without a normal by it, others store heights or the normals' `x` there.
    pub opacity: Option<Vec<f32>>,
    /// Greatest integer of the components, such as 255; none for floats.
    pub most: Option<u32>,
}

impl NormalVectors {
    /// Moves `x` and `y` of the two integers around the middle to the mean of the values that were
    /// rounded to them.
    ///
    /// No integer stands for 0: 128 of 255 is 1/255, 127 is -1/255, and a writer of level normals
    /// picks one of them. Level parts of a map then lean by 0.2°. Shading does not show it, but
    /// integration adds it up to a ramp. Therefore the texels of an integer in excess of the mean
    /// of its two neighbours' counts are taken as exact zeros. The integer is replaced by the mean
    /// of these zeros and its other texels. The result is 0 if only level normals have the integer,
    /// and almost unchanged if none has. It moves a component by at most 1/255.
    #[must_use]
    pub fn with_zero_centred(mut self) -> Self {
        let Some(most) = self.most.map(f64::from) else { return self };
        for axis in 0..2 {
            // Numbers of texels with each of the four integers around the middle: -3, -1, 1 and 3
            // over the greatest.
            let place = |value: f32| {
                let steps = (f64::from(value) * most).round();
                [-3.0, -1.0, 1.0, 3.0].iter().position(|&known| known == steps)
            };
            let mut counts = [0.0f64; 4];
            for vector in &self.vectors {
                if let Some(at) = place(vector[axis]) {
                    counts[at] += 1.0;
                }
            }
            let others = |at: usize| {
                let beside = 0.5 * (counts[at - 1] + counts[at + 1]);
                if counts[at] > 0.0 { (beside / counts[at]).min(1.0) } else { 1.0 }
            };
            let centred = [-3.0, -others(1), others(2), 3.0].map(|steps| (steps / most) as f32);
            for vector in &mut self.vectors {
                if let Some(at) = place(vector[axis]) {
                    vector[axis] = centred[at];
                }
            }
        }
        self
    }
}

/// Reads a normal map from a file or from the bytes of one. It uses the channels red, green and
/// blue (or `x`, `y` and `z`); `green` is the direction of the green channel.
///
/// Vectors are read as by [`read_normal_vectors`], then scaled to length 1. A texel without a
/// direction becomes `(0, 0, 1)` and is counted. At most `max_bytes` of memory are used: 12 bytes a
/// texel.
///
/// # Errors
///
/// When the file cannot be read, is damaged, too large, not a picture, or has no red, green and blue.
pub fn read_normal_map<'a>(
    source: impl Into<Source<'a>>,
    green: GreenSign,
    max_bytes: u64,
) -> Result<NormalMap, ReadError> {
    let NormalVectors { width, height, vectors: mut normals, .. } = read_normal_vectors(source, max_bytes)?;
    let mut degenerate = 0;
    for normal in &mut normals {
        let [x, y, z] = *normal;
        let length = length(*normal);
        *normal = if length.is_finite() && length >= SHORTEST {
            let y = if green == GreenSign::PlusY { y } else { -y };
            [x / length, y / length, z / length]
        } else {
            degenerate += 1;
            [0.0, 0.0, 1.0]
        };
    }
    Ok(NormalMap { width, height, normals, degenerate })
}

/// Reads the vectors of a normal map from a file or from the bytes of one. It uses the channels
/// red, green and blue, or `x`, `y` and `z`, and opacity.
///
/// Unsigned integers `s` of up to 16 bit stand for `2 s / maximum - 1` (glTF 2.0, 3.9.3). Floats
/// are used unchanged if the channels are `x`, `y` and `z`, or if any value is negative. Otherwise
/// they are used unchanged or as `2 s - 1`, whichever gives lengths nearer to 1. At most
/// `max_bytes` of memory are used: 12 bytes a texel, and 32 for files with opacity.
///
/// # Errors
///
/// When the file cannot be read, is damaged, too large, not a picture, or lacks these channels.
pub fn read_normal_vectors<'a>(
    source: impl Into<Source<'a>>,
    max_bytes: u64,
) -> Result<NormalVectors, ReadError> {
    let source = source.into();
    read(source, max_bytes).map_err(|problem| source.error(problem))
}

fn read(source: Source<'_>, max_bytes: u64) -> Result<NormalVectors, ReadProblem> {
    let mut file = ImageFile::open(source, None, NORMAL_BYTES_PER_TEXEL, max_bytes)?;
    let layout = file.layout().clone();
    let (channels, are_vectors) = normal_channels(&layout)?;
    let scale = layout.full_scale.unwrap_or(1.0);
    let (mut vectors, opacity) = match layout.channel("a") {
        None => {
            let texel = |s: &[f64]| [0, 1, 2].map(|axis| (s[axis] / scale) as f32);
            (collect(file, &channels, [0.0; 3], texel)?, None)
        }
        Some(opacity) => {
            file = ImageFile::open(source, None, BYTES_PER_TEXEL_WITH_OPACITY, max_bytes)?;
            let [x, y, z] = channels;
            let texel = |s: &[f64]| [0, 1, 2, 3].map(|channel| (s[channel] / scale) as f32);
            let texels = collect(file, &[x, y, z, opacity], [0.0; 4], texel)?;
            let opacity = texels.iter().map(|texel| texel[3]).collect();
            let vectors: Vec<[f32; 3]> = texels.iter().map(|&[x, y, z, _]| [x, y, z]).collect();
            (vectors, Some(opacity))
        }
    };
    if layout.full_scale.is_some() || !(are_vectors || is_signed(&vectors)) {
        vectors.iter_mut().for_each(|vector| *vector = unpacked(*vector));
    }
    let most = layout.full_scale.map(|full_scale| full_scale as u32);
    Ok(NormalVectors { width: layout.width, height: layout.height, vectors, opacity, most })
}

fn length(vector: [f32; 3]) -> f32 {
    vector.iter().map(|x| x * x).sum::<f32>().sqrt()
}

fn unpacked(vector: [f32; 3]) -> [f32; 3] {
    vector.map(|value| 2.0 * value - 1.0)
}

/// Whether floats are components of directions without unpacking.
fn is_signed(vectors: &[[f32; 3]]) -> bool {
    let off = |vector: [f32; 3]| {
        let off = f64::from((length(vector) - 1.0).abs());
        if off.is_finite() { off } else { 0.0 }
    };
    vectors.iter().flatten().any(|&value| value < 0.0)
        || vectors.iter().map(|&vector| off(vector) - off(unpacked(vector))).sum::<f64>() < 0.0
}

/// Finds the three channels, and whether their names say that they hold a vector.
fn normal_channels(layout: &Layout) -> Result<([usize; 3], bool), ReadProblem> {
    let named = |names: [&str; 3]| match names.map(|name| layout.channel(name)) {
        [Some(x), Some(y), Some(z)] => Some([x, y, z]),
        _ => None,
    };
    let colours = named(["r", "g", "b"]);
    let Some(channels) = colours.or_else(|| named(["x", "y", "z"])) else {
        return Err(ReadProblem::NoColour { what: "normal map", channels: layout.channel_names() });
    };
    let sample = layout.channels[channels[0]].sample;
    if layout.full_scale.is_none() && sample.kind != SampleKind::Float {
        return Err(ReadProblem::Unsupported {
            what: format!("normals of {sample} samples"),
            advice: "export 8 or 16-bit unsigned integers, or floats",
        });
    }
    Ok((channels, colours.is_none()))
}
