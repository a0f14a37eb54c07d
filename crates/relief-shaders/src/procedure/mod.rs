//! Procedures: formulas that fill height maps, and by which shaders may displace vertices.
//!
//! A new procedure is a `.wesl` and a `.rs` file here and its name in the list below.
//!
//! All procedures tile without a seam. Their period in time is 1: the heights at times 0 and 1 are
//! the same.
//!
//! Source: Szirmay-Kalos and Umenhoffer 2008, section 3.1.
//!
//! ```
//! use relief_shaders::procedure::Procedure;
//!
//! let mut waves = Procedure::named("waves")?;
//! waves.set("count", 5.0)?;
//! let wgsl = waves.wgsl();
//! assert!(wgsl.contains("fn procedure_waves(") && !wgsl.contains("fn procedure_fbm("));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#[cfg(feature = "cpu")]
use std::ops::Range;

use relief_core::registry::{Guarantee, Guarantees, Param, Publication, SHADER_PARAMS, UnknownName};

#[cfg(feature = "cpu")]
use relief_core::{HeightMap, HeightMapError, Wrap};

use crate::SelectionError;
use crate::entry::{Entry, Role, find};

mod bumps;
mod fbm;
mod waves;

/// All procedures, in the order of their numbers in the shaders.
pub static ENTRIES: &[Entry] = &[waves::ENTRY, fbm::ENTRY, bumps::ENTRY];

/// Returns the name of a procedure's function in the shaders.
pub fn function_of(entry: &Entry) -> String {
    format!("procedure_{}", entry.name.replace('-', "_"))
}

/// A procedure with its settings, at a time.
#[derive(Clone, Copy, Debug)]
pub struct Procedure {
    /// Place in the list.
    number: usize,
    params: [f32; SHADER_PARAMS],
    time: f32,
    seed: u32,
}

impl Procedure {
    /// Returns the procedure of that name with its default settings, at time 0.
    ///
    /// # Errors
    ///
    /// When there is none; the error names the nearest.
    pub fn named(name: &str) -> Result<Self, UnknownName> {
        let number = find("procedure", ENTRIES, name)?;
        let [x, y, z, w, ..] = ENTRIES[number].defaults();
        Ok(Self { number, params: [x, y, z, w], time: 0.0, seed: 0 })
    }

    /// Returns the registry entry: name, summary and parameters.
    pub fn entry(&self) -> &'static Entry {
        &ENTRIES[self.number]
    }

    /// Returns the parameters, in the entry's order.
    pub fn params(&self) -> [f32; SHADER_PARAMS] {
        self.params
    }

    /// Returns the time, from 0 up to 1.
    pub fn time(&self) -> f32 {
        self.time
    }

    /// Returns the seed of the random numbers.
    pub fn seed(&self) -> u32 {
        self.seed
    }

    /// Sets a parameter.
    ///
    /// # Errors
    ///
    /// When it has no such parameter, or the value is not accepted.
    pub fn set(&mut self, name: &str, value: f64) -> Result<(), SelectionError> {
        let Some((place, param)) = self.entry().param(name) else {
            return Err(SelectionError::NoParam {
                stage: "procedure",
                entry: self.entry().name,
                name: name.to_owned(),
                entries: self.entry().params.iter().map(|param| param.name).collect(),
            });
        };
        let Param { min, max, integer, .. } = *param;
        if !(f64::from(min)..=f64::from(max)).contains(&value) || (integer && value.fract() != 0.0) {
            return Err(SelectionError::Value { key: name.to_owned(), value, min, max, integer });
        }
        self.params[place] = value as f32;
        Ok(())
    }

    /// Returns the procedure at another time. One period is 1; whole periods are dropped. A time
    /// that is not finite counts as 0.
    #[must_use]
    pub fn at_time(self, time: f64) -> Self {
        let part = time - time.floor();
        Self { time: if part.is_finite() { part as f32 } else { 0.0 }, ..self }
    }

    /// Returns the procedure with another seed of its random numbers. Default: 0.
    #[must_use]
    pub fn with_seed(self, seed: u32) -> Self {
        Self { seed, ..self }
    }

    /// Returns its function and all that it calls as plain WGSL, for a program's own shaders. The
    /// function takes texture coordinates, the time, a seed and the parameters, and returns the
    /// height from 0 to 1.
    pub fn wgsl(&self) -> String {
        crate::wgsl::of_function(&function_of(self.entry()))
    }

    /// Computes some rows of a height map of `size` texels: heights from 0 to 1 at the centres of
    /// the texels, row by row.
    ///
    /// # Errors
    ///
    /// None is known: it runs over a map of one texel, which can always be made.
    #[cfg(feature = "cpu")]
    pub fn rows(&self, size: [u32; 2], rows: Range<u32>) -> Result<Vec<f32>, HeightMapError> {
        let Self { number, params, time, seed } = *self;
        crate::cpu::procedure_rows((number as u32, params), (time, seed), size, rows)
    }

    /// Makes a height map of `size` texels, which tiles.
    ///
    /// ```
    /// let bumps = relief_shaders::procedure::Procedure::named("bumps")?.at_time(0.25).fill([64, 64])?;
    /// assert!(bumps.texels().iter().all(|height| (0.0..=1.0).contains(height)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// When a map cannot have that size.
    #[cfg(feature = "cpu")]
    pub fn fill(&self, size: [u32; 2]) -> Result<HeightMap, HeightMapError> {
        let [width, height] = size;
        HeightMap::check_size(width, height)?;
        HeightMap::new(width, height, self.rows(size, 0..height)?, Wrap::Repeat)
    }
}

/// An entry of the list.
const fn entry(name: &'static str, summary: &'static str, params: &'static [Param]) -> Entry {
    Entry {
        name,
        summary,
        publication: Publication { paper: crate::SURVEY, section: "3.1" },
        maps: &[],
        params,
        states: &[],
        guarantee: Guarantees::all(Guarantee::Exact),
        weakened: &[],
        argument: "The heights follow from a formula.",
        role: Role::Plain,
    }
}

/// A parameter with a number along a tile.
const fn count(summary: &'static str, max: f32, default: f32) -> Param {
    Param { name: "count", summary, unit: "", min: 1.0, max, default, integer: true, names: &[] }
}

#[cfg(all(test, feature = "cpu"))]
mod tests;
