//! Georeference in a GeoTIFF's tags (OGC 19-008r4, GeoTIFF 1.1).

use tiff_reader::Ifd;

use super::gdal;
use super::keys::{KEY_RASTER_TYPE, Keys};
use crate::georeference::{Band, Facts, Grid};

const TAG_PIXEL_SCALE: u16 = 33550;
const TAG_TIEPOINTS: u16 = 33922;
const TAG_TRANSFORMATION: u16 = 34264;

/// Raster type whose coordinates refer to texels' centres, not their corners.
const PIXEL_IS_POINT: u16 = 2;

/// Reads the facts about ground and heights of a file with `channels` channels. An error, with the
/// reason, if a fact is impossible.
pub(super) fn facts(ifd: &Ifd, channels: usize) -> Result<Facts, String> {
    let keys = Keys::read(ifd)?;
    let ground = Ground::read(ifd)?;
    let crs = keys.as_ref().map(Keys::system).transpose()?;
    let mut bands = gdal::bands(ifd, channels)?.unwrap_or_default();
    // The heights of tie points belong to a vertical system, and are ignored without one.
    if let Some([scale, offset]) = ground.heights.filter(|_| keys.as_ref().is_some_and(Keys::has_heights)) {
        bands.resize(channels, Band::default());
        for band in bands.iter_mut().filter(|band| band.scale.is_none() && band.offset.is_none()) {
            (band.scale, band.offset) = (Some(scale), Some(offset));
        }
    }
    let grid = ground.grid(keys.as_ref(), [ifd.width(), ifd.height()])?;
    Ok(Facts { crs, grid, grid_from: None, bands })
}

/// Georeference from tie points, scale or matrix.
struct Ground {
    /// Steps from one column to the next, and from one row to the next, along x and y.
    sides: Option<[[f64; 2]; 2]>,
    /// Coordinates of column 0 and row 0, if the file gives them.
    tied: Option<[f64; 2]>,
    /// Scale and offset of the texels' values, unless they change nothing.
    heights: Option<[f64; 2]>,
}

impl Ground {
    fn read(ifd: &Ifd) -> Result<Self, String> {
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
        let (sides, tied, heights) = match (scale.as_deref(), matrix.as_deref()) {
            (Some(&[x, y, ref z @ ..]), _) => {
                let tie = match ties.as_deref() {
                    Some(&[column, row, value, tie_x, tie_y, tie_z, ..]) => {
                        Some(([tie_x - column * x, tie_y + row * y], [value, tie_z]))
                    }
                    _ => None,
                };
                let z = z.first().copied().unwrap_or(0.0);
                let [value, height] = tie.map_or([0.0; 2], |(_, heights)| heights);
                (Some([[x, 0.0], [0.0, -y]]), tie.map(|(at, _)| at), [z, height - value * z])
            }
            (None, Some(&[xx, xy, _, x, yx, yy, _, y, zx, zy, zz, z, ..])) => {
                // A matrix whose heights depend on the position has another purpose.
                let heights = if [zx, zy] == [0.0; 2] { [zz, z] } else { [0.0; 2] };
                (Some([[xx, yx], [xy, yy]]), Some([x, y]), heights)
            }
            _ => (None, None, [0.0; 2]),
        };
        // 0 means that there is no scale.
        if heights[0] < 0.0 {
            return Err(format!("the scale of its values is {}", heights[0]));
        }
        let heights = Some(heights).filter(|[scale, offset]| *scale > 0.0 && [*scale, *offset] != [1.0, 0.0]);
        Ok(Self { sides, tied, heights })
    }

    /// Returns the grid; none if the file has only single points or none at all.
    fn grid(&self, keys: Option<&Keys>, size: [u32; 2]) -> Result<Option<Grid>, String> {
        let Some(sides) = self.sides else { return Ok(None) };
        // Position 0, 0 is the first texel's corner or its centre.
        let is_point = keys.and_then(|keys| keys.short(KEY_RASTER_TYPE)) == Some(PIXEL_IS_POINT);
        let to_corner = if is_point { 0.5 } else { 0.0 };
        let [u, v] = sides;
        let corner = self.tied.map(|at| [0, 1].map(|axis| at[axis] - to_corner * (u[axis] + v[axis])));
        Grid::new(sides, corner, size).map(Some)
    }
}
