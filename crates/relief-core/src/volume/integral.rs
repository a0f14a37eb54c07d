//! The integral of the field along a path: the judge of translucent volumes.

use super::Volume;
use crate::Path;

/// Pieces of a path that are looked at by themselves, so that thin solids are not stepped over.
const PIECES: u32 = 256;

/// Halvings of a piece at most. Then it is shorter than rounding.
const HALVINGS: u32 = 32;

impl Volume {
    /// Returns the integral of the field over a path's parameter, from 0 to its exit. With a parameter in
    /// metres it is the optical depth for an extinction of 1 per metre.
    ///
    /// It is adaptive quadrature by Simpson's rule: parts are halved until two estimates of each differ by
    /// less than its share of `tolerance`. It knows nothing of the cells of the volume. What lies in less
    /// than a 512th of the path may be missed.
    ///
    /// ```
    /// use relief_core::{Path, Volume, Wrap};
    ///
    /// // Half of the tile is full.
    /// let half = Volume::from_fn([64, 1, 1], Wrap::Repeat, |[u, ..]| if u < 0.5 { 1.0 } else { 0.0 })?;
    /// let across = Path::between([0.0, 0.0, 0.5], [1.0, 0.0, 0.5]);
    /// assert!((half.integral_along(&across, 1e-9) - 0.5).abs() < 1e-8);
    /// # Ok::<(), relief_core::VolumeError>(())
    /// ```
    pub fn integral_along(&self, path: &Path, tolerance: f64) -> f64 {
        let step = path.exit / f64::from(PIECES);
        let value = |t: f64| self.value_at(path.at(t));
        let piece = |number: u32| {
            let (begin, end) = (step * f64::from(number), step * f64::from(number + 1));
            let values = [begin, 0.5 * (begin + end), end].map(value);
            refined(&value, [begin, end], values, tolerance / f64::from(PIECES), HALVINGS)
        };
        if step > 0.0 { (0..PIECES).map(piece).sum() } else { 0.0 }
    }
}

/// Simpson's rule on an interval, from the values at its ends and its middle.
fn simpson([begin, end]: [f64; 2], [first, middle, last]: [f64; 3]) -> f64 {
    (end - begin) / 6.0 * (first + 4.0 * middle + last)
}

/// The integral over an interval: of both halves where these differ from the whole.
fn refined(
    value: &impl Fn(f64) -> f64,
    [begin, end]: [f64; 2],
    [first, middle, last]: [f64; 3],
    tolerance: f64,
    halvings: u32,
) -> f64 {
    let centre = 0.5 * (begin + end);
    let halves = [[begin, centre], [centre, end]];
    let [left, right] = halves.map(|[begin, end]| value(0.5 * (begin + end)));
    let of_halves = [[first, left, middle], [middle, right, last]];
    let sum: f64 = halves.iter().zip(of_halves).map(|(half, values)| simpson(*half, values)).sum();
    if halvings == 0 || (sum - simpson([begin, end], [first, middle, last])).abs() <= tolerance {
        return sum;
    }
    let parts = halves.into_iter().zip(of_halves);
    parts.map(|(half, values)| refined(value, half, values, 0.5 * tolerance, halvings - 1)).sum()
}
