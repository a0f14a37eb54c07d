//! Tracers for the exact first hit, by which every method is judged.
//!
//! Along a [`Path`] the gap `g(t) = H(t) - f(u(t), v(t))` is the height of the path above the
//! bilinear surface. All tracers in this module find the least `t` in `[0, exit]` with `g(t) <= 0`.
//! So a path that begins on or below the surface hits at `t = 0`.
//!
//! | tracer | finding cells | solving a cell | purpose |
//! | --- | --- | --- | --- |
//! | [`cell_walk`] | visits every dual cell in order (2-D DDA) | closed form | the truth |
//! | [`PyramidTracer`] | halves the path, bounded by a [`MaxPyramid`](crate::MaxPyramid) | Bernstein isolation, then bracketing | judging the truth |
//! | [`FastTracer`] | tree of maxima with 16 branches, in conservative `f32` | closed form | rendering |
//!
//! The first two share no code. All three accept every path:
//!
//! * `exit` may be infinite. A path that falls below the map ends there with a hit. A path that
//!   rises above the map for good ends there with a miss. Any other path is given up,
//!   [`exhausted`](Hit::exhausted), once it has moved [`MAX_TRAVEL`] cells.
//! * A path is a miss if its `exit` is below 0 or NaN, or if it begins [`MAX_START`] or more cells
//!   away from the texture's origin. It is also a miss if it moves [`MAX_RATE`] or more cells per
//!   unit of `t`, or if a coefficient of its height is as large. This includes infinite and NaN
//!   values.
//! * Under [`Wrap::Clamp`](crate::Wrap::Clamp) the surface continues outside the footprint, level
//!   along the axis that the path leaves it on. The tracers do not end a path there.
//!
//! [`DisplacedMesh`] traces rays against whole meshes. There the displaced surface is not a height
//! field over any plane, and a ray is not a path in a single texture space.

mod cell_walk;
mod displaced;
mod fast;
mod patch;
mod pyramid_tracer;

use crate::{Cost, HeightMap, Hit, Path};

pub use cell_walk::{cell_walk, least_gap};
pub use displaced::{DisplacedHit, DisplacedMesh, DisplacedMeshError, DisplacedTrace, Side, Sides};
pub use fast::{FastTracer, HitPacket, PathPacket};
pub use pyramid_tracer::PyramidTracer;

/// Distance, in cells along the longer axis, after which a path is given up: once across the
/// largest map. A larger value would only keep tracers busy for longer with level paths through
/// endless valleys.
pub const MAX_TRAVEL: f64 = (1u32 << 20) as f64;

/// Greatest distance, in cells, between the origin of the texture and the beginning of a path. At
/// this distance `f64` still resolves 2⁻¹² of a cell.
pub const MAX_START: f64 = (1u64 << 40) as f64;

/// Greatest speed and rise of a path, far beyond any use. Squares and products of such numbers are
/// still finite.
pub const MAX_RATE: f64 = 1e90;

/// Bytes of the four heights of a cell.
const CELL_BYTES: u32 = 16;

/// Result of an exact tracer, with the data to judge other results.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExactHit {
    /// The hit. Its height is the surface's. The path has the same height there, unless it begins
    /// below the surface.
    pub hit: Hit,
    /// Dual cell of the hit, not wrapped. For a hit on an edge or a vertex it is one of the
    /// adjacent cells. 0 for a miss.
    pub cell: [i64; 2],
    /// Derivative `g'(t)` of the gap at the hit, in heights per unit of `t`. An error `e` of a
    /// height moves the hit by `e / |slope|`. 0 for a miss.
    pub slope: f64,
    /// Gap at a hit: 0, or negative if the path begins below the surface. For a miss it is a lower
    /// bound of the least gap along the path, in heights, and never negative.
    ///
    /// [`cell_walk`] returns the exact gap if it is below 1 and the path was not given up.
    /// [`FastTracer`] does not compute it and returns 0.
    pub clearance: f64,
}

impl ExactHit {
    /// A miss at this cost, at least `clearance` above the surface.
    pub const fn miss(cost: Cost, clearance: f64) -> Self {
        Self { hit: Hit::miss(cost), cell: [0; 2], slope: 0.0, clearance }
    }

    /// A hit at `t` in a cell. `gap` is the path's height above the surface there, `slope` its
    /// derivative.
    #[inline]
    fn at(path: &Path, t: f64, cell: [i64; 2], gap: f64, slope: f64, cost: Cost) -> Self {
        let [u, v, h] = path.at(t);
        let height = (h - gap).clamp(0.0, 1.0);
        let hit = Hit { found: true, exhausted: false, uv: [u, v], height, t, cost };
        Self { hit, cell, slope, clearance: gap }
    }

    /// A path given up at `t`: the last point reached, above the surface.
    fn given_up(map: &HeightMap, path: &Path, t: f64, cost: Cost) -> Self {
        let [u, v, h] = path.at(t);
        let height = map.height_at(u, v);
        let hit = Hit { found: true, exhausted: true, uv: [u, v], height, t, cost };
        Self { hit, cell: [0; 2], slope: 0.0, clearance: h - height }
    }
}

/// Whether a path can be traced through a map of this size: see the module's documentation.
#[inline(always)]
fn is_traceable([w, h]: [u32; 2], path: &Path) -> bool {
    let [w, h] = [f64::from(w), f64::from(h)];
    let near = ((path.uv[0] * w).abs() < MAX_START) & ((path.uv[1] * h).abs() < MAX_START);
    // NaN is not below any number.
    let slow = ((path.duv[0] * w).abs() < MAX_RATE) & ((path.duv[1] * h).abs() < MAX_RATE);
    let smooth = (path.h[0].abs() < MAX_RATE) & (path.h[1].abs() < MAX_RATE) & (path.h[2].abs() < MAX_RATE);
    near & slow & smooth & (path.exit >= 0.0)
}
