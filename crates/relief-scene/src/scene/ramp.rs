//! Colours of surfaces by height.

use std::fmt;
use std::path::PathBuf;
use std::str::FromStr;
use std::sync::Arc;

use rayon::prelude::*;
use relief_core::HeightMap;
use relief_core::registry::UnknownName;
use relief_io::{BuiltinRamp, ColorTable, Picture, Remark, omissions, srgb_to_linear};

use super::Surface;

/// Least part of a table's elevations, or of a map's values, that both share. If they share less, the
/// values of a map without a unit are taken for something else than the table's elevations.
const LEAST_SHARED: f64 = 0.1;

/// Name of standard input.
const INPUT: &str = "-";

/// Colours by height: a built-in table by name, or a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum RampChoice {
    /// Built-in table, which spans the map's range.
    Builtin(BuiltinRamp),
    /// Path of a table for [`read_color_table`](relief_io::read_color_table).
    File(PathBuf),
}

/// Error for a text that is neither a built-in table of colours nor the name of a file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}; a file's name has an ending or a folder, as in tints.txt")]
pub struct UnknownRamp(UnknownName);

impl From<BuiltinRamp> for RampChoice {
    fn from(builtin: BuiltinRamp) -> Self {
        RampChoice::Builtin(builtin)
    }
}

impl fmt::Display for RampChoice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            RampChoice::Builtin(builtin) => builtin.fmt(f),
            RampChoice::File(path) => path.display().fmt(f),
        }
    }
}

impl FromStr for RampChoice {
    type Err = UnknownRamp;

    fn from_str(text: &str) -> Result<Self, UnknownRamp> {
        text.parse().map(RampChoice::Builtin).or_else(|unknown| {
            let is_file = text == INPUT || text.contains(['.', '/', '\\']);
            if is_file { Ok(RampChoice::File(PathBuf::from(text))) } else { Err(UnknownRamp(unknown)) }
        })
    }
}

/// Reason why a map cannot have the colours of a table.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RampError {
    /// The map's elevations are not known.
    #[error(
        "the table has elevations from {} to {}, and the map's heights have no known unit: state the unit, \
         or give percentages of the map's range, as in 50%", table[0], table[1]
    )]
    UnknownElevations {
        /// Least and greatest elevation of the table.
        table: [f64; 2],
    },
    /// The map's values and the table's elevations have little in common.
    #[error(
        "the table has elevations from {} to {}, but the map's values go from {} to {} and have no unit: \
         give percentages of the map's range, as in 50%, or the elevations that its heights stand for",
        table[0], table[1], map[0], map[1]
    )]
    OtherElevations {
        /// Least and greatest elevation of the table.
        table: [f64; 2],
        /// Least and greatest value of the map.
        map: [f64; 2],
    },
}

/// Returns the colours of a map's texels. Elevations of the table are in the unit of the map's
/// [physical range](HeightMap::physical_range): metres for elevation models, and the file's own
/// values for other maps.
///
/// Texels that are holes have the table's colour for texels without a value, if there is one.
///
/// # Errors
///
/// When the table has elevations and the map has none, or they have no unit and little in common.
pub fn tinted(map: &HeightMap, table: &ColorTable) -> Result<Picture, RampError> {
    let [zero, one] = match (map.physical_range(), table.absolute_range()) {
        (Some(range), _) => range,
        (None, None) => [0.0, 1.0],
        (None, Some(table)) => return Err(RampError::UnknownElevations { table }),
    };
    let elevation = |texel: f32| zero + f64::from(texel) * (one - zero);
    let texels = map.texels();
    let ends = extremes(map).map(elevation);
    let range = [ends[0].min(ends[1]), ends[0].max(ends[1])];
    let has_unit = map.texel_size_m().is_some() || map.has_named_heights();
    if let Some(table) = table.absolute_range().filter(|[low, high]| low < high && !has_unit) {
        let shared = table[1].min(range[1]) - table[0].max(range[0]);
        let longer = (table[1] - table[0]).max(range[1] - range[0]);
        if shared < LEAST_SHARED * longer {
            return Err(RampError::OtherElevations { table, map: range });
        }
    }
    let ramp = table.ramp(range);
    let linear = |[red, green, blue, opacity]: [f64; 4]| {
        let [red, green, blue] = [red, green, blue].map(|part| srgb_to_linear(part / 255.0) as f32);
        [red, green, blue, (opacity / 255.0) as f32]
    };
    let of_hole = table.nodata().map(|color| linear(color.map(f64::from)));
    let texels = texels.par_iter().enumerate().map(|(at, &texel)| match of_hole {
        Some(color) if is_hole(map, at) => color,
        _ => linear(ramp.color(elevation(texel))),
    });
    Ok(Picture { width: map.width(), height: map.height(), texels: texels.collect() })
}

/// Returns whether a texel of a map is a hole.
fn is_hole(map: &HeightMap, at: usize) -> bool {
    let width = map.width() as usize;
    map.holes().is_some_and(|holes| holes.contains((at % width) as u32, (at / width) as u32))
}

/// Returns the least and the greatest texel of a map that is no hole.
fn extremes(map: &HeightMap) -> [f32; 2] {
    if map.holes().is_none() {
        return map.extremes();
    }
    let wider = |[low, high]: [f32; 2], [l, h]: [f32; 2]| [low.min(l), high.max(h)];
    let none = [f32::INFINITY, f32::NEG_INFINITY];
    let texels = map.texels().par_iter().enumerate();
    texels.map(|(at, &texel)| if is_hole(map, at) { none } else { [texel; 2] }).reduce(|| none, wider)
}

/// Returns a remark on a map whose elevations lie nearly all beyond a table's.
pub(super) fn outside_remark(map: &HeightMap, table: &ColorTable) -> Option<Remark> {
    let ([zero, one], table) = (map.physical_range()?, table.absolute_range()?);
    let ends = extremes(map).map(|texel| zero + f64::from(texel) * (one - zero));
    let [low, high] = [ends[0].min(ends[1]), ends[0].max(ends[1])];
    let shared = table[1].min(high) - table[0].max(low);
    let is_outside = low < high && table[0] < table[1] && shared < LEAST_SHARED * (high - low);
    is_outside.then(|| {
        let text = format!(
            "its heights go from {low} to {high}, and the table of colours from {} to {}: most of them have \
             the colour of an end",
            table[0], table[1]
        );
        Remark::new(&omissions::OUTSIDE_TABLE, text)
    })
}

impl Surface {
    /// Sets a colour picture of the height map: the table's colour at each texel's elevation.
    ///
    /// ```
    /// use relief_core::{HeightMap, Wrap, mesh::square};
    /// use relief_io::{BuiltinRamp, ColorTable};
    /// use relief_scene::Surface;
    ///
    /// let hills = HeightMap::from_fn(8, 8, Wrap::Clamp, |i, j| (i * j) as f32 / 49.0)?;
    /// let surface = Surface::new(square(1)?, hills).with_ramp(&ColorTable::from(BuiltinRamp::Grey))?;
    /// let color = surface.color().expect("it has colours");
    /// assert_eq!((color.texels[0][0], color.texels[63][0]), (0.0, 1.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// When the table has elevations and the map has none, or they have no unit and little in common.
    pub fn with_ramp(self, table: &ColorTable) -> Result<Self, RampError> {
        let color = Arc::new(tinted(self.height_map(), table)?);
        Ok(self.with_color(color))
    }
}
