//! Factors that keep triangles on one side of the relief where directions of displacement turn.
//!
//! A point of a piece is `P(w) + d N(w) + ρ`. It lies over the base point `w`, displaced by `d`,
//! which is interpolated between the piece's corners. Beside that it is off by `ρ`, at most the
//! bend of the piece (see `Turning`). The base point to which it really belongs, and the
//! displacement there, follow it from `ρ = 0` on. Where the point moves by `dx`, `J⁻¹ dx` gives the
//! moves of the base point and of the displacement, with
//! `J = (J₁, J₂, N) = (E₁ + d N₁, E₂ + d N₂, N)`. `E` are the sides of the base triangle, `N₁` and
//! `N₂` the differences of the directions at its corners. So the piece stays above the relief if it
//! is raised by two amounts. The first is the height of the relief above it over the same base
//! points. The second is `|ρ|` times the greatest value of
//!
//! ```text
//! (|J₁ × J₂| + G₁ |J₂ × N| + G₂ |J₁ × N|) / det J
//! ```
//!
//! Here `G` are the greatest slopes of the relief along both sides: in the triangle itself and,
//! since the way may lead out of it, in the triangles around it. The lift above flat triangles is a
//! part of the relief.

use std::collections::HashMap;

use glam::DVec3;
use rayon::prelude::*;
use relief_core::mesh::{BasePoint, Mesh};

use super::corners::Corners;
use super::halves::sorted;
use crate::surface::Relief;
use crate::{MesherError, Side};

/// Raise of the pieces of triangles, as a multiple of their bend: at least 1.
#[derive(Debug)]
pub struct OneSide {
    /// Factor of each base triangle.
    patches: Vec<f64>,
    /// Greatest factor of the triangles at each side, by the positions at its ends.
    sides: HashMap<[u32; 2], f64>,
    /// Extra displacement of all vertices in metres.
    pub raise_m: f64,
}

impl OneSide {
    /// Finds the factors for one side of a relief over a flat or lifted base, along interpolated
    /// directions. `lift_m` returns a bound on each triangle's lift, the sum of the lifts of its
    /// sides.
    pub fn new(
        mesh: &Mesh,
        point_of: &[u32],
        corners: &Corners,
        relief: &Relief,
        lift_m: impl Fn(usize) -> f64 + Sync,
        (side, error_m): (Side, f64),
    ) -> Result<Self, MesherError> {
        let longest = corners.longest();
        let points = |triangle: &[u32; 3]| triangle.map(|vertex| point_of[vertex as usize]);
        let own: Vec<f64> = mesh
            .triangles()
            .par_iter()
            .enumerate()
            .map(|(number, triangle)| {
                let base = triangle.map(|vertex| corners.base(vertex));
                // No piece is moved and raised farther than this.
                let beside_m = 2.0 * error_m / longest;
                factor(relief, base, [beside_m, lift_m(number)])
            })
            .collect();
        // Around each position.
        let mut around = vec![0.0_f64; mesh.vertices().len()];
        for (triangle, factor) in mesh.triangles().iter().zip(&own) {
            for point in points(triangle) {
                around[point as usize] = around[point as usize].max(*factor);
            }
        }
        let patches = mesh.triangles().iter().map(|triangle| {
            let around = points(triangle).map(|point| around[point as usize]);
            // In heights: a bend is measured along the longest direction.
            (longest * around.into_iter().fold(0.0, f64::max)).max(1.0)
        });
        let patches: Vec<f64> = patches.collect();
        if let Some(folded) = own.iter().position(|factor| factor.is_infinite()) {
            let middle = mesh.triangles()[folded].map(|vertex| corners.base(vertex).position);
            let at_m = ((middle[0] + middle[1] + middle[2]) / 3.0).to_array();
            return Err(MesherError::SideOfFold { at_m });
        }
        let mut sides: HashMap<[u32; 2], f64> = HashMap::new();
        for (triangle, factor) in mesh.triangles().iter().zip(&patches) {
            let points = points(triangle);
            for k in 0..3 {
                let most = sides.entry(sorted([points[k], points[(k + 1) % 3]])).or_insert(1.0);
                *most = most.max(*factor);
            }
        }
        Ok(Self { patches, sides, raise_m: side.sign() * 0.5 * error_m / longest })
    }

    /// Returns the factor of a triangle.
    pub fn of_patch(&self, patch: u32) -> f64 {
        self.patches[patch as usize]
    }

    /// Returns the factor of the triangles at a side, by the positions at its ends.
    pub fn of_side(&self, points: [u32; 2]) -> f64 {
        self.sides.get(&sorted(points)).copied().unwrap_or(1.0)
    }
}

/// Returns the displacement that keeps a piece on one side, per distance from where it is
/// interpolated, within a base triangle. The triangle is displaced by the heights under it, and by
/// up to `beside_m` beside them, over a base that is lifted by at most `lift_m`. Returns infinity
/// where it may fold.
fn factor(relief: &Relief, corners: [BasePoint; 3], [beside_m, lift_m]: [f64; 2]) -> f64 {
    let places = corners.map(|corner| relief.place(corner.uv));
    let extent = relief.extent_under(places);
    let [low, high] = extent.heights.map(|height| relief.metres(height));
    let displaced = [low.min(high) - beside_m - lift_m, low.max(high) + beside_m + lift_m];
    let from_first = |of: fn(&BasePoint) -> DVec3| [1, 2].map(|k| of(&corners[k]) - of(&corners[0]));
    let [sides, turns] = [from_first(|corner| corner.position), from_first(|corner| corner.normal)];
    let slopes = [1, 2].map(|k| {
        let [across, down] = [0, 1].map(|axis| (places[k][axis] - places[0][axis]).abs());
        relief.map().scale_m().abs() * (across * extent.steepest[0] + down * extent.steepest[1]) + lift_m
    });
    let along = |axis: usize| displaced.map(|metres| sides[axis] + turns[axis] * metres);
    let [first, second] = [along(0), along(1)];
    // It is quadratic in the displacement, and lies within the hull of its control points.
    let mixed = (first[0].cross(second[1]) + first[1].cross(second[0])) * 0.5;
    let across = [first[0].cross(second[0]), mixed, first[1].cross(second[1])];
    let up = corners.map(|corner| corner.normal);
    let each_up = |of: DVec3| up.map(|up| of.dot(up)).into_iter();
    // The triangle faces one way or the other.
    let sign = if each_up(across[0]).sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
    let least = across.iter().flat_map(|&of| each_up(of * sign)).fold(f64::INFINITY, f64::min);
    let greatest = |of: &mut dyn Iterator<Item = f64>| of.fold(0.0, f64::max);
    let area = greatest(&mut across.iter().map(|of| of.length()));
    let wall =
        |side: [DVec3; 2]| greatest(&mut side.iter().flat_map(|side| up.map(|up| side.cross(up).length())));
    if area == 0.0 {
        // Without an area it has no pieces with one.
        return 0.0;
    }
    // NaN is no factor of a usable triangle, either.
    if least > 0.0 {
        (area + slopes[0] * wall(second) + slopes[1] * wall(first)) / least
    } else {
        f64::INFINITY
    }
}
