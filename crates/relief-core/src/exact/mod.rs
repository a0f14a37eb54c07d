//! The exact first hit: the judge of every method.
//!
//! Along a [`Path`] the gap `g(t) = H(t) - f(u(t), v(t))` is the height of the path above the bilinear
//! surface. All tracers here answer the same question: the least `t` in `[0, exit]` with `g(t) <= 0`. A path
//! that begins on or below the surface therefore hits at `t = 0`.
//!
//! | tracer | how it finds the cells | how it solves a cell | meant for |
//! | --- | --- | --- | --- |
//! | [`cell_walk`] | visits every dual cell in order (2-D DDA) | closed form | the truth |
//! | [`PyramidTracer`] | halves the path, bounded by a [`MaxPyramid`](crate::MaxPyramid) | Bernstein isolation, then bracketing | judging the truth |
//! | [`FastTracer`] | tree of maxima with 16 branches, in conservative `f32` | closed form | rendering |
//!
//! The first two share no code. All three accept every path:
//!
//! * `exit` may be infinite. A path that comes below the map ends there with a hit, one that rises above the
//!   map for good ends there with a miss. One that does neither is given up, [`exhausted`](Hit::exhausted),
//!   once it has moved [`MAX_TRAVEL`] cells.
//! * A path is a miss when its `exit` is below 0 or NaN, when it begins [`MAX_START`] or more cells away from
//!   the origin of the texture, or when it moves [`MAX_RATE`] or more cells a unit of `t`, or a coefficient
//!   of its height is as large. That includes what is infinite or NaN.
//! * Under [`Wrap::Clamp`](crate::Wrap::Clamp) the surface goes on outside of the footprint, level along the
//!   axis on which it is left; the tracers do not end a path there.
//!
//! [`DisplacedMesh`] answers for whole meshes, where the displaced surface is not a height field over any
//! plane and a ray is not a path of one texture space.

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

/// How far, in cells along the longer axis, a path is followed before it is given up: once across the largest
/// map. Larger values only keep tracers busy for longer with level paths through valleys that never end.
pub const MAX_TRAVEL: f64 = (1u32 << 20) as f64;

/// How far from the origin of the texture, in cells, a path may begin. There `f64` still resolves 2⁻¹² of a
/// cell.
pub const MAX_START: f64 = (1u64 << 40) as f64;

/// How fast a path may move and rise: far beyond use, and yet squares and products of such numbers are
/// finite.
pub const MAX_RATE: f64 = 1e90;

/// Bytes of the heights of a cell.
const CELL_BYTES: u32 = 16;

/// An exact tracer's answer, with what is needed to judge another's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ExactHit {
    /// The hit. Its height is the surface's; that is the path's too, except where the path begins below the
    /// surface.
    pub hit: Hit,
    /// The dual cell that was hit, unwrapped. A hit on an edge or a vertex names one of the cells there. 0
    /// for a miss.
    pub cell: [i64; 2],
    /// `g'(t)` at the hit: how fast the gap closes, in heights per unit of `t`. An error `e` of a height
    /// moves the hit by `e / |slope|`. 0 for a miss.
    pub slope: f64,
    /// For a hit the gap there: 0, or negative where the path begins below the surface. For a miss a lower
    /// bound of the least gap along the path, never negative, in heights: how far the path is from touching.
    /// [`cell_walk`] knows it exactly when it is below 1 and the path was not given up; [`FastTracer`] does
    /// not look and says 0.
    pub clearance: f64,
}

impl ExactHit {
    /// No hit, at that cost, at least `clearance` above the surface.
    pub const fn miss(cost: Cost, clearance: f64) -> Self {
        Self { hit: Hit::miss(cost), cell: [0; 2], slope: 0.0, clearance }
    }

    /// A hit at `t` in a cell: `gap` is the path's height above the surface there, `slope` its derivative.
    #[inline]
    fn at(path: &Path, t: f64, cell: [i64; 2], gap: f64, slope: f64, cost: Cost) -> Self {
        let [u, v, h] = path.at(t);
        let height = (h - gap).clamp(0.0, 1.0);
        let hit = Hit { found: true, exhausted: false, uv: [u, v], height, t, cost };
        Self { hit, cell, slope, clearance: gap }
    }

    /// A path given up at `t`: the last point reached, which is above the surface.
    fn given_up(map: &HeightMap, path: &Path, t: f64, cost: Cost) -> Self {
        let [u, v, h] = path.at(t);
        let height = map.height_at(u, v);
        let hit = Hit { found: true, exhausted: true, uv: [u, v], height, t, cost };
        Self { hit, cell: [0; 2], slope: 0.0, clearance: h - height }
    }
}

/// Whether a path can be traced through a map of that size: see the module's text.
#[inline(always)]
fn is_traceable([w, h]: [u32; 2], path: &Path) -> bool {
    let [w, h] = [f64::from(w), f64::from(h)];
    let near = ((path.uv[0] * w).abs() < MAX_START) & ((path.uv[1] * h).abs() < MAX_START);
    // NaN is not below anything.
    let slow = ((path.duv[0] * w).abs() < MAX_RATE) & ((path.duv[1] * h).abs() < MAX_RATE);
    let smooth = (path.h[0].abs() < MAX_RATE) & (path.h[1].abs() < MAX_RATE) & (path.h[2].abs() < MAX_RATE);
    near & slow & smooth & (path.exit >= 0.0)
}
