//! Conversion of a grid to metres on the ground.

use super::grid::{Grid, SQUARE};
use crate::elevation::CoordinateSystem;

/// WGS 84: the equator's radius in metres, and the square of the first eccentricity.
const EQUATOR_M: f64 = 6_378_137.0;
const ECCENTRICITY_SQUARED: f64 = 0.006_694_379_990_14;

/// Possible sides of texels in metres.
const POSSIBLE_M: std::ops::RangeInclusive<f64> = 1e-9..=1e9;

/// Reason why the size of a texel is not known.
pub(super) enum NoSize {
    /// The file gives too little, or something unknown.
    Unknown(String),
    /// The file gives an impossible value.
    Impossible(String),
}

/// Size of a grid on the ground in metres, at its middle.
pub(super) struct GroundMetres {
    /// Size of a texel along `u` and `v`.
    pub texel_size_m: [f64; 2],
    /// Metres per unit of the coordinates along x and y.
    pub per_unit: [f64; 2],
    /// Lengths of the shortest and the longest row, relative to the middle one.
    pub row_lengths: [f64; 2],
}

/// Computes the size of a grid at the picture's middle. `unit` is the size of one unit of the
/// coordinates: in metres, or in radians for a geographic system.
pub(super) fn ground_metres(
    system: CoordinateSystem,
    unit: f64,
    grid: &Grid,
) -> Result<GroundMetres, NoSize> {
    let unknown = |reason: &str| NoSize::Unknown(reason.to_owned());
    let nowhere = || unknown("the file does not give the position of its grid");
    let middle_y = || grid.middle_y().ok_or_else(nowhere);
    let mut row_lengths = [1.0; 2];
    let metres = match system {
        CoordinateSystem::Projected => [unit; 2],
        CoordinateSystem::WebMercator => {
            // Scale by the cosine of the latitude that the projection has at `y`.
            let at = |y: f64| unit / (y * unit / EQUATOR_M).cosh();
            let middle = at(middle_y()?);
            row_lengths = grid.spread_of(at, middle).ok_or_else(nowhere)?;
            [middle; 2]
        }
        CoordinateSystem::Geographic => {
            let middle = degrees_m(middle_y()? * unit)?.map(|metres| metres * unit);
            // Beyond a pole the length is 0.
            let at = |y: f64| degrees_m(y * unit).map_or(0.0, |[parallel, _]| parallel * unit);
            row_lengths = grid.spread_of(at, middle[0]).ok_or_else(nowhere)?;
            middle
        }
        CoordinateSystem::Unknown => return Err(unknown("the kind of its coordinate system is not known")),
    };
    let [u, v] = grid.sides.map(|[x, y]| [x * metres[0], y * metres[1]]);
    let size = [u[0].hypot(u[1]), v[0].hypot(v[1])];
    if !size.iter().all(|side| POSSIBLE_M.contains(side)) {
        return Err(NoSize::Impossible(format!("its texels measure {:?} m x {:?} m", size[0], size[1])));
    }
    if (u[0] * v[0] + u[1] * v[1]).abs() > SQUARE * size[0] * size[1] {
        return Err(unknown("its texels are not rectangles"));
    }
    Ok(GroundMetres { texel_size_m: size, per_unit: metres, row_lengths })
}

/// Metres per radian along a parallel and along a meridian of the WGS 84 ellipsoid.
fn degrees_m(latitude: f64) -> Result<[f64; 2], NoSize> {
    if latitude.is_nan() || latitude.abs() >= std::f64::consts::FRAC_PI_2 {
        let degrees = latitude.to_degrees();
        return Err(NoSize::Impossible(format!("its middle lies at the latitude {degrees:?} degrees")));
    }
    // Radii of curvature. The radius along the parallel is the prime vertical's times the cosine.
    let w = 1.0 - ECCENTRICITY_SQUARED * latitude.sin().powi(2);
    let parallel = EQUATOR_M / w.sqrt() * latitude.cos();
    let meridian = EQUATOR_M * (1.0 - ECCENTRICITY_SQUARED) / (w * w.sqrt());
    Ok([parallel, meridian])
}
