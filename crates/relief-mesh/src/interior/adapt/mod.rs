//! Greedy Delaunay insertion: triangles as large as the tolerance allows.
//!
//! The points of a tile of a plane lie on a lattice of 1/16 texel, those on a base triangle on a
//! lattice of its barycentric coordinates. The triangulation is therefore exact in integers. The
//! point farthest from its triangle is inserted until none is farther than the tolerance. A fit of
//! heights allows a looser tolerance at first: a triangle that lies wholly below a bulge comes
//! nearer when its corners are raised.

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
pub use refine::Distances;
use refine::Refined;
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
    why: "sides that are not divided by the tolerance have too many points, or too few",
    fills: Fills::Ground(Fill { tile: fill_tile, facet: fill_facet }),
};

/// Factor on the tolerance before heights are fitted, found by trying: see
/// `docs/measurements/mesh.md`.
const LOOSER: f64 = 1.35;

/// Rounding of distances in `f32`.
const ROUNDING: f64 = 2e-7;

/// Request to fill a patch.
#[derive(Clone, Copy, Debug)]
pub struct FillRequest<'a> {
    /// Greatest distance of the surface from a triangle, as a height of the map.
    pub tolerance: f64,
    /// Places at which distances are measured.
    pub judge: Judge,
    /// Whether heights may leave the surface.
    pub fit: Fit,
    /// Greatest number of triangles.
    pub most: u32,
    /// Source of cancellation.
    pub watch: Watch<'a>,
}

/// Filled patch.
#[derive(Clone, Debug)]
pub struct Filled {
    /// Points in steps of the lattice, the given ones of the border first.
    pub points: Vec<[u16; 2]>,
    /// Heights of the points.
    pub heights: Vec<f32>,
    /// Triangles by the numbers of their points. They turn from the first axis of the lattice to
    /// the second.
    pub triangles: Vec<[u32; 3]>,
    /// Distances of the surface from the triangles.
    pub distances: Distances,
}

// Not generic, so that the code is compiled in this crate alone: a constant's functions are
// compiled wherever it is read.
fn fill_tile(ground: &Window, border: &[([i32; 2], f32)], request: FillRequest<'_>) -> Option<Filled> {
    fill(ground, border, request)
}

fn fill_facet(ground: &Facet, border: &[([i32; 2], f32)], request: FillRequest<'_>) -> Option<Filled> {
    fill(ground, border, request)
}

/// Fills a patch. The points of its border are its corners, in the ground's order, and then any
/// others. Returns `None` if it would have too many triangles, or was cancelled.
fn fill<G: Ground>(ground: &G, border: &[([i32; 2], f32)], request: FillRequest<'_>) -> Option<Filled> {
    if request.watch.is_cancelled() {
        return None;
    }
    // So that the results hold in `f64`, too.
    let tolerance = request.tolerance * (1.0 - 1e-5) - ROUNDING;
    let refined = |fit: Fit| {
        let mut tile = Refined::new(ground, request.judge, border);
        match fit {
            Fit::None => tile.refine(tolerance, &request)?,
            Fit::Heights => {
                tile.refine(LOOSER * tolerance, &request)?;
                fit::fit(&mut tile, tolerance, &request.watch);
                tile.moved();
                tile.refine(tolerance, &request)?;
            }
        }
        let distances = tile.distances();
        Some((tile, distances))
    };
    let (mut tile, mut distances) = refined(request.fit)?;
    // A point whose height was moved may be too far off, and no point can be inserted there.
    if distances.greatest() > request.tolerance && request.fit != Fit::None {
        (tile, distances) = refined(Fit::None)?;
    }
    Some(Filled {
        points: tile.mesh.points().iter().map(|point| point.map(|at| at as u16)).collect(),
        heights: tile.heights.iter().map(|&height| height as f32).collect(),
        triangles: (0..tile.mesh.count()).map(|triangle| tile.mesh.triangle(triangle)).collect(),
        distances,
    })
}
