//! Volumes of closed meshes, of height maps and of formulas, and the distances that let rays skip
//! their empty parts.
//!
//! A [`Volume`] holds values from 0 to 1 with the surface at ½. Here a value is ½ less a part
//! of the signed distance to the surface in voxels, clamped: it is 0 at the reach outside and 1 at
//! the reach inside.
//! Voxels count alike along all axes, however long they are in metres.
//!
//! Source: Szirmay-Kalos and Umenhoffer 2008, section 5.2, which puts such volumes on surfaces.

mod closest;
mod columns;
mod distance;
mod error;
mod faces;
mod fit;
mod heights;
mod mesh;
pub(crate) mod params;
mod sponge;
mod ways;

pub use distance::{VolumeDistance, volume_distance};
pub use error::VolumesError;
pub use fit::{Fit, MAX_TILES};
pub use heights::volume_from_heights;
pub use mesh::{MeshVolume, MeshVolumeSettings, Solid, volume_from_mesh};
pub use sponge::{Sponge, volume_of_sponge};
pub use ways::{Directions, ways_to_solid};

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;
use relief_core::{Cancelled, Volume, Watch, Wrap};

/// Usual distance from the surface in voxels at which values reach 0 and 1. With less, surfaces
/// between the slices have terraces, as the field knows no distance beyond a cell; with more, parts
/// of a few voxels become thinner.
pub const REACH: f64 = 1.5;

/// Computes a volume row by row, in parallel. `row(j, values)` fills the values of row `j` of all
/// slices: slice by slice, each from the first column.
fn by_rows(
    size: [u32; 3],
    wrap: Wrap,
    watch: &Watch,
    row: impl Fn(u32, &mut [f32]) + Sync,
) -> Result<Volume, VolumesError> {
    let voxels = Volume::check_size(size)?.voxels() as usize;
    let [width, rows, slices] = size.map(|side| side as usize);
    // Row by row first, so that a row is one piece of memory.
    let mut turned = vec![0.0f32; voxels];
    let done = AtomicUsize::new(0);
    turned.par_chunks_mut(width * slices).enumerate().try_for_each(|(j, values)| {
        row(j as u32, values);
        let done = done.fetch_add(1, Ordering::Relaxed) + 1;
        watch.at(done as f32 / rows as f32)?;
        Ok::<(), Cancelled>(())
    })?;
    let mut values = vec![0.0f32; voxels];
    values.par_chunks_mut(width * rows).enumerate().for_each(|(k, slice)| {
        for (j, row) in slice.chunks_exact_mut(width).enumerate() {
            row.copy_from_slice(&turned[(j * slices + k) * width..][..width]);
        }
    });
    drop(turned);
    Ok(Volume::new(size, &values, wrap)?)
}

#[cfg(test)]
mod tests;
