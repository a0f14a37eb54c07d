//! Volumes of height maps.

use relief_core::{HeightMap, Volume, Watch};

use super::{REACH, VolumesError, by_rows};

/// Voxels below the lowest and above the highest height, so that the surface lies between slices.
const MARGIN: f64 = 1.0;

/// Computes the volume under a height map: its surface is the relief. A value is ½ less the distance
/// to the relief's tangent plane at the voxel's column, in voxels, divided by twice [`REACH`] and
/// clamped to `[0, 1]`.
///
/// Heights 0 to 1 of the map lie one voxel above the floor and one below the top. Scale and bias are
/// chosen so that the relief keeps its metres. The wrap is the map's. Details finer than a voxel are
/// sampled, not averaged. The result has the same bytes with any number of threads.
///
/// ```
/// use relief_bake::volumes::volume_from_heights;
/// use relief_core::{HeightMap, Watch, Wrap};
///
/// let ramp = HeightMap::from_fn(32, 32, Wrap::Clamp, |i, _| i as f32 / 31.0)?.with_displacement(0.1, 0.0)?;
/// let volume = volume_from_heights(&ramp, [32, 32, 32], &Watch::none())?;
/// let (scale, bias) = (volume.atlas().scale_m(), volume.atlas().bias_m());
/// // The height of the relief's middle, 5 cm, in the volume.
/// let middle = (0.05 - bias) / scale;
/// assert!((volume.value_at([0.5, 0.5, middle]) - 0.5).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// When the size is invalid for a volume or has fewer than three slices, or when it is cancelled.
pub fn volume_from_heights(map: &HeightMap, size: [u32; 3], watch: &Watch) -> Result<Volume, VolumesError> {
    Volume::check_size(size)?;
    let [width, rows, slices] = size.map(f64::from);
    if size[2] < 3 {
        let what = "the number of slices";
        return Err(VolumesError::BadSetting { what, value: slices, must: "at least 3 for a height map" });
    }
    let texels = [f64::from(map.width()), f64::from(map.height())];
    let depth = slices - 2.0 * MARGIN;
    let volume = by_rows(size, map.wrap(), watch, |row, values| {
        let columns = size[0] as usize;
        for column in 0..columns {
            let x = (column as f64 + 0.5) / width * texels[0] - 0.5;
            let y = (f64::from(row) + 0.5) / rows * texels[1] - 0.5;
            let (height, slope) = map.height_and_slope_at_place(x, y);
            // In voxels up for each voxel along.
            let slope = [slope[0] * texels[0] / width * depth, slope[1] * texels[1] / rows * depth];
            let part_along_normal = (1.0 + slope[0] * slope[0] + slope[1] * slope[1]).sqrt().recip();
            let surface = MARGIN + height * depth;
            for (slice, value) in values[column..].iter_mut().step_by(columns).enumerate() {
                let above = (slice as f64 + 0.5 - surface) * part_along_normal;
                *value = (0.5 - 0.5 * above / REACH).clamp(0.0, 1.0) as f32;
            }
        }
    })?;
    let scale_m = map.scale_m() * slices / depth;
    Ok(volume.with_displacement(scale_m, map.bias_m() - scale_m * MARGIN / slices)?)
}
