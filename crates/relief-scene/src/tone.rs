//! Tone curves, from linear light to colours of a screen.

use std::fmt;
use std::str::FromStr;

use relief_core::registry::UnknownName;

mod powers;

use powers::{exp2, log2};

/// Tone curve: maps linear light, which has no upper limit, to linear colours of a screen from 0 to
/// 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Tone {
    /// Leaves colours unchanged. A screen clips components above 1.
    #[default]
    None,
    /// AgX (Troy Sobotka, 2022) as in three.js. Bright colours become pale; none is clipped.
    Agx,
}

impl Tone {
    /// All curves, in the order in which help lists them.
    pub const ALL: [Tone; 2] = [Tone::None, Tone::Agx];

    /// Returns the name of this tone curve, as files and the command spell it: `none` or `agx`.
    pub const fn name(self) -> &'static str {
        match self {
            Tone::None => "none",
            Tone::Agx => "agx",
        }
    }

    /// Returns the colour of `light`. Both are linear sRGB: red, green, blue. [`Tone::None`]
    /// returns `light` itself, which may exceed 1.
    pub fn apply(self, light: [f32; 3]) -> [f32; 3] {
        match self {
            Tone::None => light,
            Tone::Agx => agx(light),
        }
    }
}

impl fmt::Display for Tone {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Tone {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let found = Self::ALL.into_iter().find(|tone| tone.name() == name);
        found.ok_or_else(|| UnknownName::new("tone", name, Self::ALL.map(Self::name)))
    }
}

/// Rows of a matrix that is applied to red, green and blue.
type Rows = [[f32; 3]; 3];

/// Linear sRGB to linear Rec. 2020, to four digits as three.js has it, and back.
const TO_REC2020: Rows = [[0.6274, 0.3293, 0.0433], [0.0691, 0.9195, 0.0113], [0.0164, 0.0880, 0.8956]];
const FROM_REC2020: Rows =
    [[1.6605, -0.5876, -0.0728], [-0.1246, 1.1329, -0.0083], [-0.0182, -0.1006, 1.1187]];

/// Moves the primaries together, so that bright colours lose saturation, and apart again.
const INSET: Rows = [
    [0.856_627_15, 0.095_121_24, 0.048_251_606],
    [0.137_318_97, 0.761_242, 0.101_439_04],
    [0.111_898_21, 0.076_799_42, 0.811_302_37],
];
const OUTSET: Rows = [
    [1.127_100_6, -0.110_606_64, -0.016_493_939],
    [-0.141_329_76, 1.157_823_7, -0.016_493_939],
    [-0.141_329_76, -0.110_606_64, 1.251_936_4],
];

/// Range of the curve in stops of light.
const STOPS: [f32; 2] = [-12.473_93, 4.026_069];

/// Coefficients of a polynomial fitted to the curve, highest power (6) first. Its argument goes
/// from 0 to 1 over [`STOPS`].
const CURVE: [f32; 7] = [15.5, -40.14, 31.96, -6.868, 0.4298, 0.1191, -0.002_32];

/// Power that makes the curve's values linear: the nearest number of 32 bits to 2.2, as shaders have it.
const POWER: f64 = 2.2_f32 as f64;

fn agx(light: [f32; 3]) -> [f32; 3] {
    // Rounded once: the system's own of 32 bits are others elsewhere, and then a pixel in
    // some hundred thousand is.
    let curve = |light: f32| {
        let stops = log2(f64::from(light.max(1e-10))) as f32;
        let part = ((stops - STOPS[0]) / (STOPS[1] - STOPS[0])).clamp(0.0, 1.0);
        CURVE.into_iter().fold(0.0, |sum, coefficient| sum * part + coefficient)
    };
    let shown = times(&OUTSET, times(&INSET, times(&TO_REC2020, light)).map(curve));
    times(&FROM_REC2020, shown.map(|part| exp2(POWER * log2(f64::from(part.max(0.0)))) as f32))
        .map(|part| part.clamp(0.0, 1.0))
}

fn times(rows: &Rows, [red, green, blue]: [f32; 3]) -> [f32; 3] {
    rows.map(|[of_red, of_green, of_blue]| of_red * red + of_green * green + of_blue * blue)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Light and its colour in three.js (r160 to r180), computed from its shader in 64-bit floats.
    const RAMP: &[([f32; 3], [f32; 3])] = &[
        ([1.0 / 4096.0; 3], [0.0; 3]),
        ([0.0009765625, 0.0009765625, 0.0009765625], [0.000102, 0.000102, 0.000102]),
        ([0.00390625, 0.00390625, 0.00390625], [0.001076, 0.001075, 0.001075]),
        ([0.015625, 0.015625, 0.015625], [0.012507, 0.012502, 0.012503]),
        ([0.0625, 0.0625, 0.0625], [0.079069, 0.079049, 0.079050]),
        ([0.25, 0.25, 0.25], [0.274886, 0.274830, 0.274823]),
        ([1.0, 1.0, 1.0], [0.590229, 0.590136, 0.590102]),
        ([4.0, 4.0, 4.0], [0.861016, 0.860910, 0.860839]),
        ([16.0, 16.0, 16.0], [0.995212, 0.995098, 0.995009]),
        ([0.18, 0.18, 0.18], [0.214549, 0.214502, 0.214499]),
        ([0.0, 0.0, 0.0], [0.000000, 0.000000, 0.000000]),
        ([1.0, 0.0, 0.0], [0.723276, 0.105847, 0.066736]),
        ([0.0, 1.0, 0.0], [0.234997, 0.584542, 0.130356]),
        ([0.0, 0.0, 1.0], [0.034013, 0.135471, 0.730010]),
        ([4.0, 0.5, 0.1], [0.986347, 0.524875, 0.354265]),
        ([0.02, 0.2, 0.7], [0.080724, 0.276854, 0.555263]),
        ([16.0, 16.0, 2.0], [0.999066, 0.987678, 0.872753]),
    ];

    #[test]
    fn agx_is_that_of_three_js() {
        for (light, expected) in RAMP {
            let found = Tone::Agx.apply(*light);
            for (found, expected) in found.iter().zip(expected) {
                assert!((found - expected).abs() < 2e-5, "{light:?}: {found} for {expected}");
            }
        }
    }

    #[test]
    fn more_light_is_never_darker() {
        let mut before = -1.0;
        for step in 0..2000 {
            let light = (step as f32 / 2000.0 * 20.0 - 14.0).exp2();
            let [grey, ..] = Tone::Agx.apply([light; 3]);
            assert!(grey >= before - 1e-6, "{light}: {grey} after {before}");
            before = grey;
        }
        assert!(before > 0.98, "{before}");
        assert_eq!(Tone::None.apply([0.1, 2.0, 3.0]), [0.1, 2.0, 3.0]);
    }
}
