//! Greedy Delaunay insertion: triangles as large as the tolerance allows.
//!
//! The points of a tile of a plane lie on a lattice of a sixteenth of a texel, those of a base triangle on
//! one of its barycentric coordinates, so that what decides how they are joined is exact in whole numbers.
//! The point farthest from its triangle is inserted until none is farther than the tolerance. With a fit a
//! looser tolerance is enough at first: a triangle that lies wholly below a bulge comes nearer when its
//! corners are raised.

mod delaunay;
mod facet;
mod fit;
mod ground;
mod judge;
mod refine;
mod turning;
mod window;

use relief_core::Watch;
use relief_core::registry::Publication;

use super::{Fill, Fills, Interior};
use crate::{Fit, Judge, Spacing};
pub use facet::{Facet, along};
pub use ground::{Gap, Ground};
use refine::Refined;
pub use refine::Seen;
pub use turning::Turning;
pub use window::{STEPS, Window};

pub const INTERIOR: Interior = Interior {
    name: "adapt",
    summary: "as few triangles as the tolerance allows, large where the relief is smooth",
    publication: Publication {
        paper: "Garland and Heckbert 1995, Fast Polygonal Approximation of Terrains and Height Fields",
        section: "4",
    },
    takes: &[Spacing::Uneven],
    why: "sides that do not go by the tolerance have more points than it asks for, or too few",
    fills: Fills::Ground(Fill { tile: fill_tile, facet: fill_facet }),
};

/// How much looser the tolerance is before heights are fitted: found by trying, see `docs/mesh.md`.
const LOOSER: f64 = 1.35;

/// What distances of `f32` may be wrong by.
const ROUNDING: f64 = 2e-7;

/// How a patch is to be filled.
#[derive(Clone, Copy, Debug)]
pub struct Wanted<'a> {
    /// The farthest that the surface may lie from a triangle, as a height of the map.
    pub tolerance: f64,
    /// Where that is looked at.
    pub judge: Judge,
    /// Whether heights are moved off the surface.
    pub fit: Fit,
    /// The most triangles.
    pub most: u32,
    /// Asked whether to go on.
    pub watch: Watch<'a>,
}

/// A patch that is filled.
#[derive(Clone, Debug)]
pub struct Filled {
    /// The points, in steps of the lattice: first those of the border, as they were given.
    pub points: Vec<[u16; 2]>,
    /// Their heights.
    pub heights: Vec<f32>,
    /// Triangles by their points, turning from the first axis of the lattice to the second.
    pub triangles: Vec<[u32; 3]>,
    /// The farthest that the surface lies above the triangles and below them, and where.
    pub seen: Seen,
}

// Not generic, so that they are compiled here alone: what a constant names is compiled wherever that is read.
fn fill_tile(ground: &Window, border: &[([i32; 2], f32)], wanted: Wanted<'_>) -> Option<Filled> {
    fill(ground, border, wanted)
}

fn fill_facet(ground: &Facet, border: &[([i32; 2], f32)], wanted: Wanted<'_>) -> Option<Filled> {
    fill(ground, border, wanted)
}

/// Fills a patch, whose border's points are its corners, in the ground's order, and then any others. None
/// where it would have too many triangles, or was cancelled.
fn fill<G: Ground>(ground: &G, border: &[([i32; 2], f32)], wanted: Wanted<'_>) -> Option<Filled> {
    if wanted.watch.is_cancelled() {
        return None;
    }
    // So that what is found in f64 holds, too.
    let tolerance = wanted.tolerance * (1.0 - 1e-5) - ROUNDING;
    let refined = |fit: Fit| {
        let mut tile = Refined::new(ground, wanted.judge, border);
        match fit {
            Fit::None => tile.refine(tolerance, &wanted)?,
            Fit::Heights => {
                tile.refine(LOOSER * tolerance, &wanted)?;
                fit::fit(&mut tile, tolerance, &wanted.watch);
                tile.moved();
                tile.refine(tolerance, &wanted)?;
            }
        }
        let seen = tile.seen();
        Some((tile, seen))
    };
    let (mut tile, mut seen) = refined(wanted.fit)?;
    // A point whose height was moved may lie too far off, and nothing can be inserted where it is.
    if seen.greatest() > wanted.tolerance && wanted.fit != Fit::None {
        (tile, seen) = refined(Fit::None)?;
    }
    Some(Filled {
        points: tile.mesh.points().iter().map(|point| point.map(|at| at as u16)).collect(),
        heights: tile.heights.iter().map(|&height| height as f32).collect(),
        triangles: (0..tile.mesh.count()).map(|triangle| tile.mesh.triangle(triangle)).collect(),
        seen,
    })
}
