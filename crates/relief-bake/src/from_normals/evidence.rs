//! Measurements of a picture that distinguish tangent-space normal maps from other images.

use std::fmt;

use super::slopes::length;

/// A smaller part of normals that point into the surface is noise.
const INWARD: f64 = 0.05;

/// Lengths farther than this from 1 (root mean square) are no rounding.
const OFF: f64 = 0.08;

/// Channels with less spread (standard deviation, of 1) are the same everywhere.
const FLAT: f64 = 0.01;

/// Measurements of a normal map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Evidence {
    /// The mean vector.
    pub mean: [f64; 3],
    /// Part of the normals that points along the surface or into it, from 0 to 1.
    pub inward: f64,
    /// Root mean square deviation of the lengths from 1: of the picture as it is, decoded from
    /// sRGB, and encoded to sRGB.
    pub lengths_off: [f64; 3],
    /// Standard deviations of the four channels, from 0 to 1 each. Without opacity, its deviation
    /// is 0.
    pub spreads: [f64; 4],
    /// Means of the four channels, from 0 to 1. Without opacity, its mean is 1.
    pub levels: [f64; 4],
}

/// Other contents that a picture may have instead of tangent-space normals in red, green and blue.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NormalSource {
    /// Normals in object space: the mean normal, and the part that points into the surface.
    ObjectSpace {
        /// The mean vector.
        mean: [f64; 3],
        /// Part of the normals that points along the surface or into it, from 0 to 1.
        inward: f64,
    },
    /// Normals that went through the curve of sRGB, with the errors of the lengths before and
    /// after.
    Srgb {
        /// Whether the picture was encoded; otherwise it was decoded.
        is_encoded: bool,
        /// Root mean square deviation of the lengths from 1: as they are, and with the curve
        /// undone.
        lengths_off: [f64; 2],
    },
    /// Normals with `x` in opacity: the spreads of red and of opacity.
    XInOpacity {
        /// Standard deviations of red and of opacity, as parts of their range.
        spreads: [f64; 2],
    },
    /// Normals of two channels: the constant level of blue.
    TwoChannels {
        /// The mean of blue, from 0 to 1.
        blue: f64,
    },
}

impl NormalSource {
    /// Returns whether no normal map looks like this, whatever its heights are.
    pub fn is_sure(&self) -> bool {
        matches!(self, Self::Srgb { .. } | Self::XInOpacity { .. })
    }
}

impl Evidence {
    /// Measures vectors and the opacity beside them. Vectors that are not finite are left out.
    pub fn of(normals: &[[f32; 3]], opacity: Option<&[f32]>) -> Self {
        let mut sums = [[0.0f64; 2]; 4];
        let (mut inward, mut off, mut count) = (0usize, [0.0f64; 3], 0usize);
        for (at, normal) in normals.iter().enumerate().filter(|(_, normal)| length(**normal).is_finite()) {
            count += 1;
            let codes = normal.map(|x| 0.5 * f64::from(x) + 0.5);
            let opacity = opacity.map_or(1.0, |opacity| f64::from(opacity[at]));
            for (sum, code) in sums.iter_mut().zip(codes.into_iter().chain([opacity])) {
                sum[0] += code;
                sum[1] += code * code;
            }
            inward += usize::from(normal[2] <= 0.0);
            for (sum, codes) in off.iter_mut().zip([codes, codes.map(decoded), codes.map(encoded)]) {
                let length = codes.iter().map(|code| (2.0 * code - 1.0).powi(2)).sum::<f64>().sqrt();
                *sum += (length - 1.0).powi(2);
            }
        }
        let count = (count as f64).max(1.0);
        let levels = sums.map(|[sum, _]| sum / count);
        let spreads = sums.map(|[sum, squares]| (squares / count - (sum / count).powi(2)).max(0.0).sqrt());
        let [x, y, z, _] = levels.map(|level| 2.0 * level - 1.0);
        Self {
            mean: [x, y, z],
            inward: inward as f64 / count,
            lengths_off: off.map(|sum| (sum / count).sqrt()),
            spreads,
            levels,
        }
    }

    /// Returns the contents that the picture may have, the likeliest first.
    pub fn sources(&self) -> Vec<NormalSource> {
        let Self { mean: [x, y, z], inward, lengths_off: [plain, as_encoded, as_decoded], spreads, levels } =
            *self;
        let mut sources = Vec::new();
        if spreads[0] < FLAT && spreads[3] > 2.0 * FLAT {
            sources.push(NormalSource::XInOpacity { spreads: [spreads[0], spreads[3]] });
            return sources;
        }
        let is_grey = x.abs().max(y.abs()).max(z.abs()) < FLAT;
        if spreads[2] < FLAT
            && !is_grey
            && spreads[0].max(spreads[1]) > FLAT
            && !(0.6..0.99).contains(&levels[2])
        {
            sources.push(NormalSource::TwoChannels { blue: levels[2] });
        }
        let undone = as_encoded.min(as_decoded);
        if plain > OFF && undone < OFF.min(0.5 * plain) {
            let is_encoded = as_encoded < as_decoded;
            sources.push(NormalSource::Srgb { is_encoded, lengths_off: [plain, undone] });
        } else if plain < 2.0 * OFF && (x.abs().max(y.abs()) > z || inward > INWARD) {
            sources.push(NormalSource::ObjectSpace { mean: [x, y, z], inward });
        }
        sources
    }
}

impl fmt::Display for NormalSource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::ObjectSpace { mean: [x, y, z], inward } => {
                let inward = 100.0 * inward;
                write!(
                    f,
                    "in object space: {inward:.0} % of its normals point along the surface or into it, and \
                     their mean is ({x:.2}, {y:.2}, {z:.2})"
                )
            }
            Self::Srgb { is_encoded, lengths_off: [plain, undone] } => {
                let [plain, undone] = [plain, undone].map(|off| 100.0 * off);
                let [what, undo] = if *is_encoded { ["encoded", "decoded"] } else { ["decoded", "encoded"] };
                write!(
                    f,
                    "{what} as colours are (sRGB): lengths are {plain:.0} % off from 1, and {undone:.1} % \
                     once it is {undo}"
                )
            }
            Self::XInOpacity { spreads: [red, opacity] } => {
                let [red, opacity] = [red, opacity].map(|spread| 100.0 * spread);
                write!(
                    f,
                    "one with x in opacity: red is the same everywhere (spread {red:.1} % of its range), and \
                     opacity is not ({opacity:.0} %)"
                )
            }
            Self::TwoChannels { blue } => {
                write!(f, "one of two channels: blue is {:.0} % everywhere", 100.0 * blue)
            }
        }
    }
}

/// Inverse of the sRGB curve (IEC 61966-2-1).
fn decoded(code: f64) -> f64 {
    if code <= 0.040_45 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) }
}

fn encoded(light: f64) -> f64 {
    if light <= 0.003_130_8 { 12.92 * light } else { 1.055 * light.powf(1.0 / 2.4) - 0.055 }
}
