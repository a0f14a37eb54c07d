//! Volumes that attack what traces them, and some that people would use.

use relief_core::rng::Rng;
use relief_core::{Volume, VolumeError, Wrap};

/// A volume by its name.
pub struct NamedVolume {
    /// Its name.
    pub name: &'static str,
    /// Columns, rows and slices.
    pub size: [u32; 3],
    value: fn([f64; 3], &mut Rng) -> f64,
}

/// All volumes.
pub const ALL: &[NamedVolume] = &[
    NamedVolume { name: "noise", size: [9, 7, 8], value: |_, rng| rng.unit() },
    NamedVolume { name: "steps", size: [8, 8, 6], value: |_, rng| rng.unit().round() },
    NamedVolume { name: "one voxel", size: [7, 7, 7], value: one_voxel },
    NamedVolume { name: "a column", size: [1, 9, 1], value: |_, rng| rng.unit() },
    NamedVolume { name: "empty", size: [4, 4, 4], value: |_, _| 0.0 },
    NamedVolume { name: "full", size: [4, 4, 4], value: |_, _| 1.0 },
    NamedVolume { name: "weave", size: [64, 64, 32], value: |at, _| weave(at) },
    NamedVolume { name: "sponge", size: [27, 27, 27], value: |at, _| sponge(at) },
];

impl NamedVolume {
    /// Builds it with a wrap.
    ///
    /// # Errors
    ///
    /// Never: the sizes are proper.
    pub fn build(&self, wrap: Wrap) -> Result<Volume, VolumeError> {
        let mut rng = Rng::new(11);
        Volume::from_fn(self.size, wrap, |at| (self.value)(at, &mut rng))
    }
}

fn one_voxel(at: [f64; 3], _: &mut Rng) -> f64 {
    if at.iter().all(|part| (part - 0.5).abs() < 0.01) { 1.0 } else { 0.0 }
}

/// Two threads along each direction, over and under each other by turns.
pub fn weave([u, v, h]: [f64; 3]) -> f64 {
    use std::f64::consts::PI;
    let thread = |along: f64, across: f64, side: f64| {
        let number = (across * 2.0).floor();
        let middle = (number + 0.5) / 2.0;
        let turn = if number % 2.0 == 0.0 { side } else { -side };
        let height = 0.5 + 0.17 * turn * (2.0 * PI * along).sin();
        0.16 - ((across - middle).powi(2) + (0.5 * (h - height)).powi(2)).sqrt()
    };
    0.5 + 32.0 * thread(u, v, 1.0).max(thread(v, u, -1.0))
}

/// A cube with square tunnels, three levels deep.
pub fn sponge(at: [f64; 3]) -> f64 {
    let is_tunnel = (0..3).any(|level| {
        let third = at.map(|part| (part * 3.0_f64.powi(level + 1)).floor().rem_euclid(3.0) == 1.0);
        third.iter().filter(|is_middle| **is_middle).count() >= 2
    });
    if is_tunnel { 0.0 } else { 1.0 }
}
