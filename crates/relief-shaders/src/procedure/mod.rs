//! Procedures: formulas that fill height maps, and that shaders may displace vertices by. A new one is a
//! `.wesl` and a `.rs` file here and its name in the list below.
//!
//! All of them tile without a seam, and come round in a unit of time: what they show at times 0 and 1 is the
//! same.
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

use relief_core::registry::{
    Entry, Guarantee, Guarantees, MAX_PARAMS, Param, Publication, UnknownName, find,
};

#[cfg(feature = "cpu")]
use relief_core::{HeightMap, HeightMapError, Wrap};

use crate::SelectionError;

mod bumps;
mod fbm;
mod waves;

/// All of them.
pub const ENTRIES: &[Entry] = &[waves::ENTRY, fbm::ENTRY, bumps::ENTRY];

/// The function of a procedure in the shaders.
pub fn function_of(entry: &Entry) -> String {
    format!("procedure_{}", entry.name.replace('-', "_"))
}

/// A procedure with its settings, at a time.
#[derive(Clone, Copy, Debug)]
pub struct Procedure {
    /// Its place in the list.
    number: usize,
    params: [f32; MAX_PARAMS],
    time: f32,
    seed: u32,
}

impl Procedure {
    /// The procedure of that name with its default settings, at time 0.
    ///
    /// # Errors
    ///
    /// When there is none.
    pub fn named(name: &str) -> Result<Self, UnknownName> {
        let number = find("procedure", ENTRIES, name)?;
        Ok(Self { number, params: ENTRIES[number].defaults(), time: 0.0, seed: 0 })
    }

    /// What it is, with its parameters.
    pub fn entry(&self) -> &'static Entry {
        &ENTRIES[self.number]
    }

    /// Its parameters, in its entry's order.
    pub fn params(&self) -> [f32; MAX_PARAMS] {
        self.params
    }

    /// Its time, from 0 up to 1.
    pub fn time(&self) -> f32 {
        self.time
    }

    /// With what its random numbers begin.
    pub fn seed(&self) -> u32 {
        self.seed
    }

    /// Sets a parameter.
    ///
    /// # Errors
    ///
    /// When it has no such parameter, or the value is not one that it takes.
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

    /// The same at another time, of which 1 is once around; only what is beyond whole numbers counts, and
    /// what is not finite is 0.
    #[must_use]
    pub fn at_time(self, time: f64) -> Self {
        let part = time - time.floor();
        Self { time: if part.is_finite() { part as f32 } else { 0.0 }, ..self }
    }

    /// The same with other random numbers.
    #[must_use]
    pub fn with_seed(self, seed: u32) -> Self {
        Self { seed, ..self }
    }

    /// Its function for a program's own shaders, with what it needs, as plain WGSL: of texture coordinates,
    /// the time, a seed and the parameters, the height from 0 to 1.
    pub fn wgsl(&self) -> String {
        crate::wgsl::of_function(&function_of(self.entry()))
    }

    /// The heights of some rows of a map of that size, from 0 to 1, at the centres of its texels, row by row.
    ///
    /// # Errors
    ///
    /// None is known: a map of a texel, over which it runs, can be made.
    #[cfg(feature = "cpu")]
    pub fn rows(&self, size: [u32; 2], rows: Range<u32>) -> Result<Vec<f32>, HeightMapError> {
        let Self { number, params, time, seed } = *self;
        crate::cpu::procedure_rows((number as u32, params), (time, seed), size, rows)
    }

    /// A height map of it, which tiles.
    ///
    /// ```
    /// let bumps = relief_shaders::procedure::Procedure::named("bumps")?.at_time(0.25).fill([64, 64])?;
    /// assert!(bumps.texels().iter().all(|height| (0.0..=1.0).contains(height)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// When there is no map of that size.
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
        argument: "It is a formula.",
    }
}

/// How many there are along a tile.
const fn count(summary: &'static str, max: f32, default: f32) -> Param {
    Param { name: "count", summary, unit: "", min: 1.0, max, default, integer: true, names: &[] }
}

#[cfg(all(test, feature = "cpu"))]
mod tests {
    use super::*;

    fn texels(procedure: &Procedure, size: [u32; 2]) -> Vec<f32> {
        procedure.fill(size).expect("a map").texels().to_vec()
    }

    #[test]
    fn heights_lie_between_0_and_1_tile_and_come_round() {
        for entry in ENTRIES {
            let mut procedure = Procedure::named(entry.name).expect("a listed name");
            procedure.set("count", 2.0).expect("a setting");
            let size = [96, 64];
            for time in [0.0, 0.3, 0.9] {
                let heights = texels(&procedure.at_time(time), size);
                assert!(heights.iter().all(|height| (0.0..=1.0).contains(height)), "{}", entry.name);
                let again = texels(&procedure.at_time(time + 1.0), size);
                let off = heights.iter().zip(&again).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
                assert!(off < 1e-4, "{} comes round: {off}", entry.name);
                // Across the edge heights change no more than within.
                let at = |x: usize, y: usize| heights[y % 64 * 96 + x % 96];
                let step =
                    |x: usize, y: usize| (at(x, y) - at(x + 1, y)).abs().max((at(x, y) - at(x, y + 1)).abs());
                let all = |is_edge: bool| {
                    let places = (0..64).flat_map(|y| (0..96).map(move |x| (x, y)));
                    let places = places.filter(|(x, y)| (*x == 95 || *y == 63) == is_edge);
                    places.map(|(x, y)| step(x, y)).fold(0.0, f32::max)
                };
                assert!(all(true) <= 1.1 * all(false), "{}: {} {}", entry.name, all(true), all(false));
            }
            let [still, later] = [0.0, 0.4].map(|time| texels(&procedure.at_time(time), size));
            let other = texels(&procedure.with_seed(7), size);
            let differs = |of: &[f32]| of.iter().zip(&still).any(|(a, b)| (a - b).abs() > 0.05);
            assert!(differs(&later) && differs(&other), "{}: time and seed matter", entry.name);
        }
    }

    #[test]
    fn each_is_a_valid_shader_by_itself() {
        for entry in ENTRIES {
            let text = Procedure::named(entry.name).expect("a listed name").wgsl();
            let module = naga::front::wgsl::parse_str(&text).expect("valid WGSL");
            let capabilities = naga::valid::Capabilities::empty();
            let mut validator =
                naga::valid::Validator::new(naga::valid::ValidationFlags::all(), capabilities);
            validator.validate(&module).expect("a valid module");
            assert!(module.global_variables.is_empty(), "{}: nothing is bound", entry.name);
        }
    }

    #[test]
    fn parameters_do_what_they_say_and_others_are_refused() {
        let mut bumps = Procedure::named("bumps").expect("a listed name");
        bumps.set("count", 1.0).expect("a setting");
        bumps.set("jitter", 0.0).expect("a setting");
        let row = bumps.rows([101, 101], 50..51).expect("heights");
        let most = row.iter().copied().fold(0.0, f32::max);
        // The middle of the tile, on the ground beyond the radius of 0.45.
        assert!(row[50] == most && most > 0.29 && row[4] == 0.0 && row[6] > 0.0);
        let mut waves = Procedure::named("waves").expect("a listed name");
        for (name, value) in [("waves", 1.0), ("spread", 0.0), ("sharpness", 0.0), ("count", 3.0)] {
            waves.set(name, value).expect("a setting");
        }
        let row = waves.rows([300, 1], 0..1).expect("heights");
        let crests = (0..300).filter(|x| row[*x] > row[(x + 1) % 300] && row[*x] >= row[(x + 299) % 300]);
        assert_eq!(crests.count(), 3);
        let error = waves.set("octaves", 3.0).expect_err("no such parameter").to_string();
        assert!(error.contains("sharpness"), "{error}");
        assert!(waves.set("waves", 1.5).is_err() && waves.set("spread", f64::NAN).is_err());
        let error = Procedure::named("wave").expect_err("no such procedure").to_string();
        assert!(error.contains("waves"), "{error}");
    }
}
