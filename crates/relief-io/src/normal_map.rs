//! Tangent-space normal maps.

use std::fmt;
use std::path::Path;
use std::str::FromStr;

use relief::registry::UnknownName;

use crate::picture::collect;
use crate::source::{Layout, SampleKind, Source};
use crate::{ReadError, ReadProblem};

/// Which way the green channel of a normal map points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum GreenSign {
    /// Up in the picture (OpenGL, glTF, Blender, Godot, Unity): `+y`.
    #[default]
    PlusY,
    /// Down in the picture (DirectX, Unreal): `-y`.
    MinusY,
}

impl GreenSign {
    /// The name used on the command line.
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

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let all = [GreenSign::PlusY, GreenSign::MinusY];
        let known = all.into_iter().find(|sign| sign.name() == name);
        known.ok_or_else(|| UnknownName::new("green sign", name, all.map(GreenSign::name)))
    }
}

/// A normal map, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct NormalMap {
    /// Width in texels.
    pub width: u32,
    /// Height in texels.
    pub height: u32,
    /// Unit normals: `x` along growing `u`, `y` up in the picture (along falling `v`), `z` out of the surface.
    pub normals: Vec<[f32; 3]>,
    /// How many texels held no direction (shorter than [`SHORTEST`], or not finite) and became `(0, 0, 1)`.
    pub degenerate: u64,
}

/// A decoded normal shorter than this has lost its direction: 8-bit rounding alone moves it by 0.007.
pub const SHORTEST: f32 = 0.1;

const NORMAL_BYTES_PER_TEXEL: u64 = 12;

/// Reads a normal map from the channels red, green and blue, whose `green` points as told.
///
/// Unsigned integers of up to 16 bit stand for `2 s / maximum - 1` (glTF 2.0, 3.9.3). Floats are taken as they are where
/// any of them is negative, and otherwise as `2 s - 1`. Normals are then scaled to length 1; a texel without a direction
/// becomes `(0, 0, 1)` and is counted. At most `max_bytes` of memory are taken, 12 bytes a texel.
///
/// # Errors
///
/// When the file cannot be read, is damaged, too large, not a picture, or has no red, green and blue.
pub fn read_normal_map(path: &Path, green: GreenSign, max_bytes: u64) -> Result<NormalMap, ReadError> {
    read(path, green, max_bytes).map_err(|problem| problem.at(path))
}

fn read(path: &Path, green: GreenSign, max_bytes: u64) -> Result<NormalMap, ReadProblem> {
    let source = Source::open(path, None, NORMAL_BYTES_PER_TEXEL, max_bytes)?;
    let layout = source.layout().clone();
    let channels = normal_channels(&layout)?;
    let scale = layout.full_scale.unwrap_or(1.0);
    let mut normals =
        collect(source, &channels, [0.0f32; 3], |s| [0, 1, 2].map(|axis| (s[axis] / scale) as f32))?;
    let signed = layout.full_scale.is_none() && normals.iter().flatten().any(|&value| value < 0.0);
    let mut degenerate = 0;
    for normal in &mut normals {
        let [x, y, z] = if signed { *normal } else { normal.map(|value| 2.0 * value - 1.0) };
        let length = (x * x + y * y + z * z).sqrt();
        *normal = if length.is_finite() && length >= SHORTEST {
            let y = if green == GreenSign::PlusY { y } else { -y };
            [x / length, y / length, z / length]
        } else {
            degenerate += 1;
            [0.0, 0.0, 1.0]
        };
    }
    Ok(NormalMap { width: layout.width, height: layout.height, normals, degenerate })
}

fn normal_channels(layout: &Layout) -> Result<[usize; 3], ReadProblem> {
    let [Some(r), Some(g), Some(b)] = ["r", "g", "b"].map(|name| layout.channel(name)) else {
        return Err(ReadProblem::NoColour { what: "normal map", channels: layout.channel_names() });
    };
    let sample = layout.channels[r].sample;
    if layout.full_scale.is_none() && sample.kind != SampleKind::Float {
        return Err(ReadProblem::Unsupported {
            what: format!("normals of {sample} samples"),
            advice: "export 8 or 16-bit unsigned integers, or floats",
        });
    }
    Ok([r, g, b])
}
