//! A sponge: a solid with round pores.

use glam::DVec3;
use relief_core::rng::Rng;
use relief_core::{Volume, Watch, Wrap};

use super::{REACH, VolumesError, by_rows};

/// Part of the height below which the sponge is solid, so that no ray leaves it below.
const FLOOR: f64 = 0.08;

/// Height of the sponge's top, as a part of the volume's.
const TOP: f64 = 0.94;

/// Settings of a sponge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sponge {
    /// Number of pores in a tile, 1 to 10,000.
    pub pores: u32,
    /// Mean diameter of the pores in tiles, above 0 and at most 1.
    pub diameter: f64,
    /// Length of the heights 0 to 1 in tiles, above 0 and at most 16.
    pub depth: f64,
    /// Seed of the pores' places.
    pub seed: u64,
    /// Distance from the surface in voxels at which values reach 0 and 1, above 0 and at most 8.
    pub reach: f64,
}

impl Default for Sponge {
    fn default() -> Self {
        Self { pores: 90, diameter: 0.18, depth: 0.3, seed: 1, reach: REACH }
    }
}

/// Computes the volume of a sponge: a slab with round pores at random places. It tiles, and its
/// floor is closed. The scale is the depth, for a tile of 1 m. A value is ½ less the signed distance
/// to the nearest pore's wall in voxels, divided by twice the reach and clamped to `[0, 1]`.
///
/// # Errors
///
/// When the size is invalid for a volume, a setting is outside its range, or it is cancelled.
pub fn volume_of_sponge(sponge: &Sponge, size: [u32; 3], watch: &Watch) -> Result<Volume, VolumesError> {
    Volume::check_size(size)?;
    let Sponge { pores, diameter, depth, seed, reach } = *sponge;
    let bad = |what, value, must| Err(VolumesError::BadSetting { what, value, must });
    if !(1..=10_000).contains(&pores) {
        return bad("the number of pores", f64::from(pores), "from 1 to 10000");
    }
    if !(diameter > 0.0 && diameter <= 1.0) {
        return bad("the diameter of pores", diameter, "above 0 and at most 1 tile");
    }
    if !(depth > 0.0 && depth <= 16.0) {
        return bad("the depth", depth, "above 0 and at most 16 tiles");
    }
    if !(reach > 0.0 && reach <= 8.0) {
        return bad("the reach", reach, "above 0 and at most 8 voxels");
    }
    let mut rng = Rng::new(seed);
    let pores: Vec<(DVec3, f64)> = (0..pores)
        .map(|_| {
            let at = DVec3::new(rng.unit(), rng.unit(), depth * rng.between(FLOOR, 1.0));
            (at, 0.5 * diameter * rng.between(0.6, 1.4))
        })
        .collect();
    // Voxels in a tile's length, along each axis.
    let voxels = DVec3::new(f64::from(size[0]), f64::from(size[1]), f64::from(size[2]) / depth);
    let volume = by_rows(size, Wrap::Repeat, watch, |row, values| {
        for (at, value) in values.iter_mut().enumerate() {
            let (column, slice) = (at % size[0] as usize, at / size[0] as usize);
            let place = (DVec3::new(column as f64, f64::from(row), slice as f64) + 0.5) / voxels;
            let mut inside = (TOP * depth - place.z) * voxels.z;
            for (centre, radius) in &pores {
                let mut apart = place - *centre;
                apart.x -= apart.x.round();
                apart.y -= apart.y.round();
                let distance = apart.length();
                // Along the way to the nearest wall a voxel is as long as its direction says.
                let length = if distance > 0.0 { (apart / distance * voxels).length() } else { voxels.x };
                inside = inside.min((distance - radius) * length);
            }
            // The floor closes pores that reach below.
            inside = inside.max((FLOOR * depth - place.z) * voxels.z);
            *value = (0.5 + 0.5 * inside / reach).clamp(0.0, 1.0) as f32;
        }
    })?;
    Ok(volume.with_displacement(depth, 0.0)?)
}
