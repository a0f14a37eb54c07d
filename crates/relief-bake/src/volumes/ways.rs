//! Ways from the voxels of a volume to its solid, direction by direction.

use rayon::prelude::*;
use relief_core::{Path, PathMetric, Volume, Watch};

use super::VolumeDistance;
use crate::BakeError;

/// Halvings of the way through a cell until a hit is known.
const HALVINGS: u32 = 24;

/// Directions of a generalised displacement map, in voxels: equal steps of azimuth, and of the part
/// of the way that goes up, from straight down to straight up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Directions {
    /// Azimuths, at least 1: the first along the columns, then towards the rows.
    pub azimuths: u32,
    /// Elevations, at least 2.
    pub elevations: u32,
}

impl Directions {
    /// Directions in all.
    pub fn count(&self) -> u32 {
        self.azimuths * self.elevations
    }

    /// The unit vector of direction `azimuth * elevations + elevation`, in voxels.
    pub fn toward(&self, direction: u32) -> [f64; 3] {
        let [azimuth, elevation] = [direction / self.elevations, direction % self.elevations];
        let up = -1.0 + 2.0 * f64::from(elevation) / f64::from(self.elevations - 1);
        let across = (1.0 - up * up).sqrt();
        let [cos, sin] = crate::azimuths::unit_vector(azimuth, self.azimuths);
        [across * cos, across * sin, up]
    }
}

/// Computes the way from every voxel's centre to the first hit with a volume in one direction, in
/// voxels. The values lie as the voxels do in the volume's [atlas](Volume::atlas). Where nothing is
/// hit within `most` voxels, or before the lowest or the highest level, the way is infinite. It is 0
/// within the solid.
///
/// A hit is the first root of the trilinear field, to a part of 2⁻²⁴ of the way through a cell.
/// `distance` is the volume's own, and lets rays skip what is empty. The result has the same bytes
/// with any number of threads.
///
/// # Errors
///
/// When it is cancelled.
pub fn ways_to_solid(
    volume: &Volume,
    distance: &VolumeDistance,
    toward: [f64; 3],
    most: f64,
    watch: &Watch,
) -> Result<Vec<f32>, BakeError> {
    let layout = volume.layout();
    let [columns, rows, slices] = volume.size();
    let [width, height] = layout.atlas_size();
    let mut ways = vec![f32::INFINITY; width as usize * height as usize];
    ways.par_chunks_mut(width as usize).enumerate().try_for_each(|(y, line)| {
        let (row_of_slices, j) = (y as u32 / rows, y as u32 % rows);
        for (x, way) in line.iter_mut().enumerate() {
            let k = row_of_slices * layout.slices_in_a_row() + x as u32 / columns;
            if k < slices {
                let voxel = [x as u32 % columns, j, k].map(i64::from);
                if let Some(found) = way_to_solid(volume, distance, voxel, toward, most) {
                    *way = found as f32;
                }
            }
        }
        watch.check()
    })?;
    Ok(ways)
}

/// The way from a voxel to the first hit.
fn way_to_solid(
    volume: &Volume,
    distance: &VolumeDistance,
    voxel: [i64; 3],
    toward: [f64; 3],
    most: f64,
) -> Option<f64> {
    let [i, j, k] = voxel;
    if f64::from(volume.voxel(i, j, k)) >= Volume::SURFACE {
        return Some(0.0);
    }
    let origin = voxel.map(|at| at as f64);
    let top = f64::from(volume.size()[2]) - 0.5;
    let level = if toward[2] > 0.0 { top } else { -0.5 };
    let end = if toward[2] == 0.0 { most } else { most.min((level - origin[2]) / toward[2]) };
    // A voxel is a corner of cells: the walk begins with the one ahead.
    let mut cell = [0, 1, 2].map(|axis| voxel[axis] - i64::from(toward[axis] < 0.0));
    let mut t = 0.0;
    while t < end {
        let empty = i64::from(distance.cell(cell[0], cell[1], cell[2]));
        let reach = (empty - 1).max(0);
        let leave = [0, 1, 2].map(|axis| match toward[axis] {
            step if step > 0.0 => ((cell[axis] + 1 + reach) as f64 - origin[axis]) / step,
            step if step < 0.0 => ((cell[axis] - reach) as f64 - origin[axis]) / step,
            _ => f64::INFINITY,
        });
        let side = (0..3).min_by(|a, b| leave[*a].total_cmp(&leave[*b])).unwrap_or(0);
        let next = leave[side].max(t);
        if empty == 0
            && let Some(hit) = hit_between(volume, origin, toward, [t, next.min(end)])
        {
            return Some(hit);
        }
        t = next;
        for axis in 0..3 {
            let ahead = (origin[axis] + toward[axis] * t).floor() as i64;
            cell[axis] = if axis == side {
                cell[axis] + if toward[axis] > 0.0 { reach + 1 } else { -reach - 1 }
            } else {
                ahead.clamp(cell[axis] - reach, cell[axis] + reach)
            };
        }
    }
    None
}

/// The first hit between two places on a way.
fn hit_between(volume: &Volume, origin: [f64; 3], toward: [f64; 3], [begin, end]: [f64; 2]) -> Option<f64> {
    let size = volume.size().map(f64::from);
    let at = [0, 1, 2].map(|axis| (origin[axis] + toward[axis] * begin + 0.5) / size[axis]);
    let step = [0, 1, 2].map(|axis| toward[axis] / size[axis]);
    let path = Path {
        uv: [at[0], at[1]],
        duv: [step[0], step[1]],
        h: [at[2], step[2], 0.0],
        exit: end - begin,
        base: 0.0,
        metric: PathMetric::unit(1.0),
    };
    volume.first_hit_in_cell(&path, HALVINGS).map(|t| begin + t)
}
