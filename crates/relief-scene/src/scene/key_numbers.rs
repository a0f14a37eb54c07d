//! The numbers of keys: units, ranges, and steps for controls.

use std::ops::Bound;

use super::extinction::EXTINCTIONS;
use super::limits::{MAX_EXPOSURE, MAX_IMAGE_SIDE, MAX_SAMPLES};
use super::metres::MAX_METRES;
use super::surface_place::{MAX_SIZE, MAX_TILES};
use super::surface_scale::{EXAGGERATIONS, LENGTHS_M};
use crate::light::MAX_DIAMETER_DEG;

/// The number of a key, or each of its numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct KeyNumber {
    /// Unit, such as `m` or `degrees`; empty for a plain number.
    pub unit: &'static str,
    /// Range of the numbers that are accepted, of all that are finite. What other keys forbid is not in it.
    pub range: (Bound<f64>, Bound<f64>),
    /// A small change that is seen in a picture, above 0: for sliders and arrow keys.
    pub step: f64,
}

const METRES: &str = "m";
const DEGREES: &str = "degrees";

/// Any finite number.
const ANY: (Bound<f64>, Bound<f64>) = (Bound::Unbounded, Bound::Unbounded);

const fn within(least: f64, greatest: f64) -> (Bound<f64>, Bound<f64>) {
    (Bound::Included(least), Bound::Included(greatest))
}

/// Returns the number of a key; none if its values are no numbers.
pub(super) fn number_of(key: &str) -> Option<KeyNumber> {
    let everywhere = within(-MAX_METRES, MAX_METRES);
    let above_nothing = Bound::Excluded(0.0);
    let (unit, range, step) = match key {
        "nodata" => ("", ANY, 1.0),
        "udim" => ("", ANY, 1.0),
        "elevation" => (METRES, everywhere, 1.0),
        "scale" => (METRES, within(0.0, MAX_METRES), 0.001),
        "bias" => (METRES, everywhere, 0.001),
        "extinction" => ("1/m", within(*EXTINCTIONS.start(), *EXTINCTIONS.end()), 1.0),
        "exaggerate" => ("", within(*EXAGGERATIONS.start(), *EXAGGERATIONS.end()), 0.1),
        "base" => (METRES, (above_nothing, Bound::Included(MAX_METRES)), 0.01),
        "tile" => ("tiles", within(1.0 / f64::from(MAX_TILES), f64::from(MAX_TILES)), 0.5),
        "tile-size" => (METRES, within(*LENGTHS_M.start(), *LENGTHS_M.end()), 0.01),
        "position" => (METRES, everywhere, 0.01),
        "rotation" => (DEGREES, ANY, 1.0),
        "mesh-scale" => ("", within(1.0 / MAX_SIZE, MAX_SIZE), 0.05),
        "transmission" => ("", within(0.0, 1.0), 0.01),
        "ior" => ("", within(1.0, 4.0), 0.01),
        "eye" | "target" => (METRES, everywhere, 0.01),
        "fov" => (DEGREES, (above_nothing, Bound::Excluded(180.0)), 1.0),
        "view-height" => (METRES, (above_nothing, Bound::Unbounded), 0.01),
        "near" | "far" => (METRES, ANY, 0.01),
        "size" => ("pixels", within(1.0, MAX_IMAGE_SIDE as f64), 1.0),
        "samples" => ("", within(1.0, MAX_SAMPLES as f64), 1.0),
        "exposure" => ("stops", within(-MAX_EXPOSURE as f64, MAX_EXPOSURE as f64), 0.1),
        "light-angle" => (DEGREES, within(0.0, MAX_DIAMETER_DEG), 0.1),
        "ambient-color" => ("", (Bound::Included(0.0), Bound::Unbounded), 0.05),
        _ => return None,
    };
    Some(KeyNumber { unit, range, step })
}
