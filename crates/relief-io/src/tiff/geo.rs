//! What a GeoTIFF's tags say of the ground (OGC 19-008r4, GeoTIFF 1.1).

use tiff_reader::Ifd;

use super::keys::{
    KEY_ANGULAR_UNIT, KEY_ANGULAR_UNIT_SIZE, KEY_GEOGRAPHIC_TYPE, KEY_MODEL_TYPE, KEY_PROJECTED_TYPE,
    KEY_RASTER_TYPE, Keys, USER_DEFINED,
};
use super::{gdal, units};
use crate::elevation::{CoordinateSystem, Elevation, Georeference, GridTransform};
use crate::layout::Terrain;

const TAG_PIXEL_SCALE: u16 = 33550;
const TAG_TIEPOINTS: u16 = 33922;
const TAG_TRANSFORMATION: u16 = 34264;

const MODEL_PROJECTED: u16 = 1;
const MODEL_GEOGRAPHIC: u16 = 2;

/// The raster type whose coordinates are those of texels' centres, not of their corners.
const PIXEL_IS_POINT: u16 = 2;

/// The projection of web maps, and its number before it got that one.
const WEB_MERCATOR: [u16; 2] = [3857, 3785];

/// WGS 84: the equator's radius in metres, and the square of the first eccentricity.
const EQUATOR_M: f64 = 6_378_137.0;
const ECCENTRICITY_SQUARED: f64 = 0.006_694_379_990_14;

/// Sides of texels that can be, in metres.
const POSSIBLE_M: std::ops::RangeInclusive<f64> = 1e-9..=1e9;

/// The cosine of the angle between a texel's sides up to which it is a rectangle.
const SQUARE: f64 = 1e-3;

/// What the file says as an elevation model of that many channels; none where it says nothing of the kind.
/// An error, with the reason, where what it says cannot be.
pub(super) fn terrain(ifd: &Ifd, channels: usize) -> Result<Option<Terrain>, String> {
    let keys = Keys::read(ifd)?;
    let grid = Grid::read(ifd, keys.as_ref())?;
    let bands = gdal::bands(ifd, channels)?;
    let georeference = match (&keys, &grid) {
        (None, None) => None,
        _ => Some(georeference(keys.as_ref(), grid)?),
    };
    if georeference.is_none() && bands.is_none() {
        return Ok(None);
    }
    let vertical = keys.and_then(|keys| keys.vertical_unit());
    let channels = bands.unwrap_or_else(|| vec![gdal::Band::default(); channels]);
    let elevation = |band: gdal::Band| {
        let named = band.unit.map(|name| (units::by_name(&name), name)).map(|(metres, name)| (name, metres));
        let (unit, metres_per_unit) = match named.or_else(|| vertical.clone()) {
            Some((name, metres)) => (Some(name), metres),
            None => (None, Some(1.0)),
        };
        let (scale, offset) = (band.scale.unwrap_or(1.0), band.offset.unwrap_or(0.0));
        Elevation { unit, metres_per_unit, scale, offset }
    };
    Ok(Some(Terrain { georeference, channels: channels.into_iter().map(elevation).collect() }))
}

/// Why there is no size of a texel.
enum NoSize {
    /// The file does not say enough, or says what is not known here.
    Unknown(String),
    /// What it says cannot be.
    Impossible(String),
}

fn georeference(keys: Option<&Keys>, grid: Option<Grid>) -> Result<Georeference, String> {
    let short = |key| keys.and_then(|keys| keys.short(key)).filter(|&number| number != 0);
    let (projected, geographic) = (short(KEY_PROJECTED_TYPE), short(KEY_GEOGRAPHIC_TYPE));
    let implied = || match (projected, geographic) {
        (Some(_), _) => Some(MODEL_PROJECTED),
        (None, Some(_)) => Some(MODEL_GEOGRAPHIC),
        (None, None) => None,
    };
    let (system, epsg) = match short(KEY_MODEL_TYPE).or_else(implied) {
        Some(MODEL_PROJECTED) if projected.is_some_and(|number| WEB_MERCATOR.contains(&number)) => {
            (CoordinateSystem::WebMercator, projected)
        }
        Some(MODEL_PROJECTED) => (CoordinateSystem::Projected, projected),
        Some(MODEL_GEOGRAPHIC) => (CoordinateSystem::Geographic, geographic),
        _ => (CoordinateSystem::Unknown, None),
    };
    let metres = match ground_metres(system, keys, grid.as_ref()) {
        Ok(metres) => Ok(metres),
        Err(NoSize::Unknown(reason)) => Err(reason),
        Err(NoSize::Impossible(what)) => return Err(what),
    };
    let known = metres.as_ref().ok();
    Ok(Georeference {
        system,
        epsg: epsg.filter(|&number| number != USER_DEFINED),
        turned_over: grid.as_ref().map_or([false; 2], Grid::turned_over),
        transform: grid.as_ref().and_then(Grid::transform),
        metres_per_unit: known.map(|metres| metres.per_unit),
        row_lengths: known.map_or([1.0; 2], |metres| metres.row_lengths),
        texel_size_m: metres.map(|metres| metres.texel_size_m),
    })
}

/// The metres of a grid on the ground, at its middle.
struct GroundMetres {
    /// The size of a texel along `u` and `v`.
    texel_size_m: [f64; 2],
    /// Of one unit of the coordinates along x and y.
    per_unit: [f64; 2],
    /// The shortest and the longest row, as parts of the middle one.
    row_lengths: [f64; 2],
}

/// The metres of a grid, at the picture's middle.
fn ground_metres(
    system: CoordinateSystem,
    keys: Option<&Keys>,
    grid: Option<&Grid>,
) -> Result<GroundMetres, NoSize> {
    let unknown = |reason: &str| NoSize::Unknown(reason.to_owned());
    let keys = keys.ok_or_else(|| unknown("the file names no coordinate system"))?;
    let grid = grid.ok_or_else(|| unknown("the file places no grid of texels"))?;
    let nowhere = || unknown("the file does not say where its grid lies");
    let middle_y = || grid.middle_y().ok_or_else(nowhere);
    let mut row_lengths = [1.0; 2];
    let metres = match system {
        CoordinateSystem::Projected => [linear_unit(keys)?; 2],
        CoordinateSystem::WebMercator => {
            let unit = linear_unit(keys)?;
            // The cosine of the latitude at which the projection has that y.
            let at = |y: f64| unit / (y * unit / EQUATOR_M).cosh();
            let middle = at(middle_y()?);
            row_lengths = grid.spread_of(at, middle).ok_or_else(nowhere)?;
            [middle; 2]
        }
        CoordinateSystem::Geographic => {
            let unit = angular_unit(keys)?;
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

/// Metres in one unit of the coordinates.
fn linear_unit(keys: &Keys) -> Result<f64, NoSize> {
    keys.metres_per_unit().map_err(NoSize::Impossible)?.map_err(NoSize::Unknown)
}

/// Radians in one unit of the coordinates.
fn angular_unit(keys: &Keys) -> Result<f64, NoSize> {
    use std::f64::consts::PI;
    match keys.short(KEY_ANGULAR_UNIT) {
        None | Some(9102 | 9122) => Ok(PI / 180.0),
        Some(9101) => Ok(1.0),
        Some(9105 | 9106) => Ok(PI / 200.0),
        Some(number) => {
            let size = if number == USER_DEFINED { keys.unit_size(KEY_ANGULAR_UNIT_SIZE) } else { Ok(None) };
            let unknown = || format!("the unit of its coordinates is not known (EPSG:{number})");
            size.map_err(NoSize::Impossible)?.ok_or_else(|| NoSize::Unknown(unknown()))
        }
    }
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

/// How texels lie in the file's coordinate system.
struct Grid {
    /// The way from one column to the next, and from one row to the next, along x and y.
    sides: [[f64; 2]; 2],
    /// The outer corner of the file's first texel, where the file says it.
    corner: Option<[f64; 2]>,
    /// Columns and rows.
    size: [f64; 2],
}

impl Grid {
    /// The grid; none where the file places none, but perhaps single points.
    fn read(ifd: &Ifd, keys: Option<&Keys>) -> Result<Option<Self>, String> {
        let numbers = |tag, what: &str, is_count: fn(usize) -> bool| -> Result<Option<Vec<f64>>, String> {
            let Some(tag) = ifd.tag(tag) else { return Ok(None) };
            let numbers = tag.value.as_f64_vec().unwrap_or_default();
            if !is_count(numbers.len()) {
                return Err(format!("its {what} has {} numbers", tag.count));
            }
            match numbers.iter().find(|number| !number.is_finite()) {
                Some(number) => Err(format!("its {what} holds {number}")),
                None => Ok(Some(numbers)),
            }
        };
        let scale = numbers(TAG_PIXEL_SCALE, "scale of texels", |count| matches!(count, 2 | 3))?;
        let ties =
            numbers(TAG_TIEPOINTS, "list of tie points", |count| count > 0 && count.is_multiple_of(6))?;
        let matrix = numbers(TAG_TRANSFORMATION, "transformation", |count| count == 16)?;
        let size = [f64::from(ifd.width()), f64::from(ifd.height())];
        let (sides, tied) = match (scale.as_deref(), matrix.as_deref()) {
            (Some(&[x, y, ..]), _) => {
                let tied = ties.as_deref().and_then(|ties| match ties {
                    &[column, row, _, tie_x, tie_y, ..] => Some([tie_x - column * x, tie_y + row * y]),
                    _ => None,
                });
                ([[x, 0.0], [0.0, -y]], tied)
            }
            (None, Some(&[xx, xy, _, x, yx, yy, _, y, ..])) => ([[xx, yx], [xy, yy]], Some([x, y])),
            _ => return Ok(None),
        };
        // What the file places at 0, 0 is the first texel's corner or its centre.
        let is_point = keys.and_then(|keys| keys.short(KEY_RASTER_TYPE)) == Some(PIXEL_IS_POINT);
        let to_corner = if is_point { 0.5 } else { 0.0 };
        let [u, v] = sides;
        let corner = tied.map(|at| [0, 1].map(|axis| at[axis] - to_corner * (u[axis] + v[axis])));
        let grid = Self { sides, corner, size };
        let area = grid.area();
        if !area.is_finite() || area == 0.0 {
            return Err(format!("its texels have the sides {u:?} and {v:?}"));
        }
        Ok(Some(grid))
    }

    /// The `y` of the picture's middle, where the file says it.
    fn middle_y(&self) -> Option<f64> {
        let [columns, rows] = self.size;
        self.y_at([columns / 2.0, rows / 2.0])
    }

    fn y_at(&self, [columns, rows]: [f64; 2]) -> Option<f64> {
        let [u, v] = self.sides;
        Some(self.corner?[1] + columns * u[1] + rows * v[1])
    }

    /// The least and the greatest of a length that is the longer the nearer `y` is to 0, over the picture, as
    /// parts of that in its middle.
    fn spread_of(&self, at: impl Fn(f64) -> f64, middle: f64) -> Option<[f64; 2]> {
        let [columns, rows] = self.size;
        let corners = [[0.0, 0.0], [columns, 0.0], [0.0, rows], [columns, rows]];
        let [mut low, mut high] = [f64::INFINITY, f64::NEG_INFINITY];
        for corner in corners {
            let y = self.y_at(corner)?;
            (low, high) = (low.min(y), high.max(y));
        }
        let nearest = if low <= 0.0 && high >= 0.0 { 0.0 } else { low.abs().min(high.abs()) };
        Some([at(low.abs().max(high.abs())) / middle, at(nearest) / middle])
    }

    /// Where the texels of the map lie, turned over as it is read.
    fn transform(&self) -> Option<GridTransform> {
        let ([mut column, mut row], mut origin) = (self.sides, self.corner?);
        let [columns, rows] = self.turned_over();
        for (is_turned, side, count) in [(columns, &mut column, self.size[0]), (rows, &mut row, self.size[1])]
        {
            if is_turned {
                origin = [0, 1].map(|axis| origin[axis] + count * side[axis]);
                *side = side.map(|length| -length);
            }
        }
        Some(GridTransform { origin, column, row })
    }

    /// The area of a texel, negative where rows go south and columns east.
    fn area(&self) -> f64 {
        let [u, v] = self.sides;
        u[0] * v[1] - u[1] * v[0]
    }

    fn turned_over(&self) -> [bool; 2] {
        let [u, v] = self.sides;
        let upright = u[1].abs() <= SQUARE * u[0].abs() && v[0].abs() <= SQUARE * v[1].abs();
        if upright { [u[0] < 0.0, v[1] > 0.0] } else { [false, self.area() > 0.0] }
    }
}
