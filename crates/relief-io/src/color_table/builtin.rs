//! Built-in tables of colours.

use std::fmt;
use std::str::FromStr;

use relief_core::registry::UnknownName;

use super::{ColorEntry, ColorTable, TableElevation};

/// Built-in table of colours. It spans the map's range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BuiltinRamp {
    /// Tints of land: green valleys, yellow slopes, brown ridges, white peaks.
    Terrain,
    /// Viridis of matplotlib, from violet to yellow: equal steps of height look equally large, also
    /// without colour vision.
    Viridis,
    /// From black to white.
    Grey,
}

impl BuiltinRamp {
    /// All built-in tables, in the order of the help.
    pub const ALL: [BuiltinRamp; 3] = [BuiltinRamp::Terrain, BuiltinRamp::Viridis, BuiltinRamp::Grey];

    /// Returns the name, as scenes spell it: `terrain`, `viridis` or `grey`.
    pub const fn name(self) -> &'static str {
        match self {
            BuiltinRamp::Terrain => "terrain",
            BuiltinRamp::Viridis => "viridis",
            BuiltinRamp::Grey => "grey",
        }
    }
}

impl fmt::Display for BuiltinRamp {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for BuiltinRamp {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let known = BuiltinRamp::ALL.into_iter().find(|builtin| builtin.name() == name);
        known.ok_or_else(|| UnknownName::new("ramp", name, BuiltinRamp::ALL.map(BuiltinRamp::name)))
    }
}

/// Percentages of the map's range, and their tints.
const TERRAIN: [(f64, [u8; 3]); 8] = [
    (0.0, [88, 132, 84]),
    (12.0, [122, 158, 94]),
    (28.0, [172, 182, 112]),
    (45.0, [206, 188, 128]),
    (62.0, [182, 142, 100]),
    (78.0, [148, 114, 90]),
    (90.0, [176, 164, 154]),
    (100.0, [244, 243, 240]),
];

/// Entries of viridis, one for each of its colours.
const VIRIDIS: usize = 256;

impl From<BuiltinRamp> for ColorTable {
    fn from(builtin: BuiltinRamp) -> Self {
        let entry = |percent: f64, [red, green, blue]: [u8; 3]| ColorEntry {
            elevation: TableElevation::Percent(percent),
            color: [red, green, blue, 255],
        };
        ColorTable::of(match builtin {
            BuiltinRamp::Terrain => TERRAIN.iter().map(|&(percent, color)| entry(percent, color)).collect(),
            BuiltinRamp::Viridis => (0..VIRIDIS)
                .map(|at| {
                    let percent = 100.0 * at as f64 / (VIRIDIS - 1) as f64;
                    entry(percent, colorous::VIRIDIS.eval_rational(at, VIRIDIS).as_array())
                })
                .collect(),
            BuiltinRamp::Grey => vec![entry(0.0, [0; 3]), entry(100.0, [255; 3])],
        })
    }
}
