//! The metres of a grid on the ground.

use super::grid::{Grid, SQUARE};
use crate::elevation::CoordinateSystem;

/// WGS 84: the equator's radius in metres, and the square of the first eccentricity.
const EQUATOR_M: f64 = 6_378_137.0;
const ECCENTRICITY_SQUARED: f64 = 0.006_694_379_990_14;

/// Sides of texels that can be, in metres.
const POSSIBLE_M: std::ops::RangeInclusive<f64> = 1e-9..=1e9;

/// Why there is no size of a texel.
pub(super) enum NoSize {
    /// The file does not say enough, or says what is not known here.
    Unknown(String),
    /// What it says cannot be.
    Impossible(String),
}

/// The metres of a grid on the ground, at its middle.
pub(super) struct GroundMetres {
    /// The size of a texel along `u` and `v`.
    pub texel_size_m: [f64; 2],
    /// Of one unit of the coordinates along x and y.
    pub per_unit: [f64; 2],
    /// The shortest and the longest row, as parts of the middle one.
    pub row_lengths: [f64; 2],
}

/// The metres of a grid, at the picture's middle. `unit` is the size of one unit of the coordinates: metres,
/// of a geographic system radians.
pub(super) fn ground_metres(
    system: CoordinateSystem,
    unit: f64,
    grid: &Grid,
) -> Result<GroundMetres, NoSize> {
    let unknown = |reason: &str| NoSize::Unknown(reason.to_owned());
    let nowhere = || unknown("the file does not say where its grid lies");
    let middle_y = || grid.middle_y().ok_or_else(nowhere);
    let mut row_lengths = [1.0; 2];
    let metres = match system {
        CoordinateSystem::Projected => [unit; 2],
        CoordinateSystem::WebMercator => {
            // The cosine of the latitude at which the projection has that y.
            let at = |y: f64| unit / (y * unit / EQUATOR_M).cosh();
            let middle = at(middle_y()?);
            row_lengths = grid.spread_of(at, middle).ok_or_else(nowhere)?;
            [middle; 2]
        }
        CoordinateSystem::Geographic => {
            let middle = degrees_m(middle_y()? * unit)?.map(|metres| metres * unit);
            // Beyond a pole there is nothing.
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
        return Err(unknown("its texels are no rectangles"));
    }
    Ok(GroundMetres { texel_size_m: size, per_unit: metres, row_lengths })
}

/// Metres in one radian along a parallel and along a meridian of the WGS 84 ellipsoid.
fn degrees_m(latitude: f64) -> Result<[f64; 2], NoSize> {
    if latitude.is_nan() || latitude.abs() >= std::f64::consts::FRAC_PI_2 {
        let degrees = latitude.to_degrees();
        return Err(NoSize::Impossible(format!("its middle lies at the latitude {degrees:?} degrees")));
    }
    // Radii of curvature; that along the parallel is its own times the cosine.
    let w = 1.0 - ECCENTRICITY_SQUARED * latitude.sin().powi(2);
    let parallel = EQUATOR_M / w.sqrt() * latitude.cos();
    let meridian = EQUATOR_M * (1.0 - ECCENTRICITY_SQUARED) / (w * w.sqrt());
    Ok([parallel, meridian])
}
