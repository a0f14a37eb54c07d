//! Settings of a kind: the values of its parameters.

use relief_core::registry::Param;

/// Name of the parameter for the bits of stored values.
pub(crate) const BITS: &str = "bits";

/// Accepted values of [`BITS`]: the bits that files store, or 0 for floats.
const STORED_BITS: [f64; 3] = [0.0, 8.0, 16.0];

/// The values of a kind's parameters.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    kind: &'static str,
    params: &'static [Param],
    values: Vec<f32>,
}

/// A setting that cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SettingsError {
    /// The kind has no such parameter.
    #[error(
        "the map kind '{kind}' has no parameter '{name}'; it has {}",
        if known.is_empty() { "none".to_owned() } else { known.join(", ") }
    )]
    NoParam {
        /// The kind.
        kind: &'static str,
        /// The requested name.
        name: String,
        /// Names of the kind's parameters.
        known: Vec<&'static str>,
    },
    /// The value is not accepted.
    #[error(
        "{kind}.{name} is {value}: it must be {} from {min} to {max}",
        if *integer { "a whole number" } else { "a number" }
    )]
    Value {
        /// The kind.
        kind: &'static str,
        /// The parameter.
        name: &'static str,
        /// The value given.
        value: f64,
        /// Least accepted value.
        min: f32,
        /// Greatest accepted value.
        max: f32,
        /// Whether only whole numbers are accepted.
        integer: bool,
    },
    /// No file format stores values of this many bits.
    #[error("{kind}.bits is {value}: it must be 8 or 16, or 0 for floats")]
    Bits {
        /// The kind.
        kind: &'static str,
        /// The value given.
        value: f64,
    },
}

impl Settings {
    /// Creates the defaults of a kind with those parameters.
    pub fn defaults(kind: &'static str, params: &'static [Param]) -> Self {
        Self { kind, params, values: params.iter().map(|param| param.default).collect() }
    }

    /// Sets a parameter by name.
    ///
    /// # Errors
    ///
    /// Fails when there is no such parameter, or when the value is out of its range.
    pub fn set(&mut self, name: &str, value: f64) -> Result<(), SettingsError> {
        let kind = self.kind;
        let Some(place) = self.params.iter().position(|param| param.name == name) else {
            let known = self.params.iter().map(|param| param.name).collect();
            return Err(SettingsError::NoParam { kind, name: name.to_owned(), known });
        };
        let Param { name, min, max, integer, .. } = self.params[place];
        if !(f64::from(min)..=f64::from(max)).contains(&value) || (integer && value.fract() != 0.0) {
            return Err(SettingsError::Value { kind, name, value, min, max, integer });
        }
        if name == BITS && !STORED_BITS.contains(&value) {
            return Err(SettingsError::Bits { kind, value });
        }
        self.values[place] = value as f32;
        Ok(())
    }

    /// Returns the value of the parameter at index `place` of the kind's list.
    ///
    /// # Panics
    ///
    /// Panics when the kind has fewer parameters, which only the kind's own code can get wrong.
    pub fn get(&self, place: usize) -> f32 {
        self.values[place]
    }

    /// Returns the whole-number parameter at index `place`.
    ///
    /// # Panics
    ///
    /// Panics as [`Self::get`] does.
    pub fn count(&self, place: usize) -> u32 {
        self.values[place] as u32
    }

    /// Iterates over names and values, in the order of the kind's list.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, f32)> + '_ {
        self.params.iter().map(|param| param.name).zip(self.values.iter().copied())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kind;

    #[test]
    fn only_bits_that_files_store_are_accepted() {
        for name in ["cone", "horizon"] {
            let mut settings = kind(name).expect("a kind").defaults();
            for good in [8.0, 16.0, 0.0] {
                assert_eq!(settings.set(BITS, good), Ok(()), "{name} {good}");
            }
            for bad in [7.0, 1.0, 15.0] {
                assert!(matches!(settings.set(BITS, bad), Err(SettingsError::Bits { .. })), "{name} {bad}");
            }
            for bad in [-8.0, 32.0, f64::NAN, 8.5] {
                assert!(matches!(settings.set(BITS, bad), Err(SettingsError::Value { .. })), "{name} {bad}");
            }
        }
    }
}
