//! Place of a mesh in the tile of a volume.

use std::fmt;
use std::str::FromStr;

use glam::{DVec3, Vec3};
use relief_core::registry::UnknownName;

use super::VolumesError;

/// Most tiles that a mesh may reach beyond its own, along `u` and `v`.
pub const MAX_TILES: u32 = 16;

/// Way in which a mesh is placed in a tile. In all, `x` becomes `u`, `z` becomes `v`, and `y`
/// becomes the height.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Fit {
    /// Proportions are kept. The mesh fills the tile along `u` or `v`, whichever is tighter, and lies
    /// in its middle along the other. Its height fills the heights 0 to 1; the scale says how long
    /// that is.
    #[default]
    Keep,
    /// The mesh fills the tile along `u`, `v` and the height, whatever its proportions.
    Stretch,
    /// The mesh lies in the tile already: its coordinates are `(u, height, v)`. Parts beyond the
    /// tile's edges belong to the tiles beside it. Where the mesh comes nearer to height 0 or 1 than
    /// the margin, the volume reaches as far beyond, so that its surface is not cut off there. A mesh
    /// that passes height 0 or 1 itself is cut off.
    Tile,
}

impl Fit {
    /// Every fit.
    pub const ALL: [Fit; 3] = [Fit::Keep, Fit::Stretch, Fit::Tile];

    /// Returns the name of this fit: `keep`, `stretch` or `tile`.
    pub const fn name(self) -> &'static str {
        match self {
            Fit::Keep => "keep",
            Fit::Stretch => "stretch",
            Fit::Tile => "tile",
        }
    }

    /// Returns the corners of triangles as `(u, v, height)`, and the scale and bias of these heights
    /// in metres. With [`Fit::Tile`] a metre stands for a height of 1.
    pub(super) fn place(
        self,
        triangles: &[[Vec3; 3]],
        size: [u32; 3],
        margin: f64,
        tile_m: [f64; 2],
    ) -> Result<(Vec<[DVec3; 3]>, [f64; 2]), VolumesError> {
        let turned = |at: Vec3| DVec3::new(at.x.into(), at.z.into(), at.y.into());
        let bounds = triangles.iter().flatten().map(|at| turned(*at));
        let [low, high] = bounds
            .fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)]);
        if self == Fit::Tile {
            let beyond = (-low).max(high - 1.0).truncate().max_element().max(0.0);
            if beyond > f64::from(MAX_TILES) {
                return Err(VolumesError::TooWide { tiles: beyond });
            }
            if low.z >= 1.0 || high.z <= 0.0 {
                return Err(VolumesError::Outside);
            }
            let [below, above] = free_heights(low.z, high.z, margin / f64::from(size[2]))
                .ok_or(VolumesError::NoRoom { margin, size })?;
            let length = 1.0 + below + above;
            let placed = |at: Vec3| {
                let at = turned(at);
                at.with_z((at.z + below) / length)
            };
            let corners = triangles.iter().map(|corners| corners.map(placed)).collect();
            return Ok((corners, [length, -below]));
        }
        let extent = high - low;
        for (axis, length) in ["x", "z", "y"].into_iter().zip(extent.to_array()) {
            if length <= 0.0 {
                return Err(VolumesError::Flat { axis });
            }
        }
        let inner = DVec3::from_array(size.map(|side| 1.0 - 2.0 * margin / f64::from(side)));
        if inner.min_element() <= 0.0 {
            return Err(VolumesError::NoRoom { margin, size });
        }
        let tile = DVec3::new(tile_m[0], tile_m[1], 1.0);
        let mut factor = inner / extent;
        // Metres of the tile for a metre of the mesh.
        let along = (factor * tile).truncate();
        let metres = if self == Fit::Keep {
            let least = along.min_element();
            factor = (least / tile).with_z(factor.z);
            least
        } else {
            (along.x * along.y).sqrt()
        };
        let middle = low.midpoint(high);
        let placed = |at: Vec3| (turned(at) - middle) * factor + 0.5;
        let corners = triangles.iter().map(|corners| corners.map(placed)).collect();
        Ok((corners, [metres / factor.z, 0.0]))
    }
}

/// Returns the heights that a volume adds below height 0 and above height 1, so that at least
/// `margin`, a part of all its heights, is free below `low` and above `high`. `None` if nothing is
/// left between the margins.
fn free_heights(low: f64, high: f64, margin: f64) -> Option<[f64; 2]> {
    if 2.0 * margin >= 1.0 {
        return None;
    }
    if low < 0.0 || high > 1.0 {
        return Some([0.0; 2]);
    }
    let top = 1.0 - high;
    // Added heights make the whole longer, and with it the margins.
    let alone = |free: f64| (margin - free).max(0.0) / (1.0 - margin);
    let [below, above] = [alone(low), alone(top)];
    if top >= margin * (1.0 + below) {
        return Some([below, 0.0]);
    }
    if low >= margin * (1.0 + above) {
        return Some([0.0, above]);
    }
    let each = margin * (high - low) / (1.0 - 2.0 * margin);
    Some([each - low, each - top].map(|added| added.max(0.0)))
}

impl fmt::Display for Fit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Fit {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let known = Fit::ALL.into_iter().find(|fit| fit.name() == name);
        known.ok_or_else(|| UnknownName::new("fit", name, Fit::ALL.map(Fit::name)))
    }
}
