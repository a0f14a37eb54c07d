//! Tolerance of a mesh: the greatest distance to the relief.

use crate::units;

/// Tolerance as given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Tolerance {
    /// Part of the map's scale.
    OfScale(f64),
    /// Metres of the written mesh.
    Metres(f64),
}

impl Default for Tolerance {
    /// Returns half a percent of the scale.
    fn default() -> Self {
        Self::OfScale(0.005)
    }
}

impl Tolerance {
    /// Returns the tolerance in metres of the scene. The written mesh is larger by the factor
    /// `size`.
    pub fn metres(self, scale_m: f64, size: f64) -> f64 {
        match self {
            // Where there is no relief, anything is near enough.
            Self::OfScale(_) if scale_m == 0.0 => 1.0,
            Self::OfScale(part) => part * scale_m.abs(),
            Self::Metres(metres) => metres / size,
        }
    }
}

/// Reads a tolerance: a length, or a part of the scale in percent.
pub fn tolerance(text: &str) -> Result<Tolerance, String> {
    let known = match text.trim().strip_suffix('%') {
        Some(percent) => percent.trim().parse().map(|percent: f64| Tolerance::OfScale(percent / 100.0)).ok(),
        None => units::length(text).map(Tolerance::Metres).ok(),
    };
    match known {
        Some(Tolerance::OfScale(value) | Tolerance::Metres(value)) if !(value > 0.0 && value.is_finite()) => {
            Err("it must be greater than 0, and finite".to_owned())
        }
        Some(tolerance) => Ok(tolerance),
        None => {
            Err("write it as a length, as in 2mm or 0.5m, or as a part of the scale, as in 1%".to_owned())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_are_lengths_or_parts_of_the_scale() {
        assert_eq!(tolerance("1%"), Ok(Tolerance::OfScale(0.01)));
        assert_eq!(tolerance(" 2mm "), Ok(Tolerance::Metres(0.002)));
        assert_eq!(tolerance("0.5"), Ok(Tolerance::Metres(0.5)));
        for bad in ["", "0", "0%", "-1mm", "nan", "inf%", "5 %%", "1 light year"] {
            assert!(tolerance(bad).is_err(), "{bad}");
        }
        assert_eq!(Tolerance::OfScale(0.01).metres(-0.5, 7.0), 0.005);
        assert_eq!(Tolerance::Metres(0.01).metres(0.5, 2.0), 0.005);
    }
}
