//! Patches of the images' maps between the centres of four texels.

use glam::DVec3;

use super::{EMPTY_HEIGHT, ImageObject, JumpCells};
use crate::raycast::Ray;

/// Relative length by which solids are extended along a ray. Two images may show the same thin
/// sheet from both sides, with heights that differ by rounding. It is thousands of roundings of
/// `f64`, and far less than a texel.
pub const AGREEMENT: f64 = 1e-12;

/// Greatest distance of a ray's origin from an image's ball, in radii. At that distance `f64` still
/// resolves a thousandth of a texel of the largest images.
pub const MAX_DISTANCE: f64 = 1e7;

/// Least and greatest length of a ray's direction. Squares and products of such numbers are finite
/// and not 0.
const LENGTHS: [f64; 2] = [1e-90, 1e90];

/// Part of the images that defines the solid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Solid {
    /// Heights of the texels.
    Depth,
    /// Only whether a texel shows something.
    Silhouette,
}

/// Map over a dual cell, between the centres of the texels `[00, 10, 01, 11]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Patch {
    /// Bilinear surface.
    Bilinear([f64; 4]),
    /// Each quarter has the height of its texel.
    Quarters([f64; 4]),
    /// Level surface.
    Flat(f64),
}

impl Patch {
    /// Height at a position in the cell, from 0 to 1 on both axes.
    fn at(&self, [u, v]: [f64; 2]) -> f64 {
        match *self {
            Self::Bilinear([h00, h10, h01, h11]) => {
                (1.0 - v) * ((1.0 - u) * h00 + u * h10) + v * ((1.0 - u) * h01 + u * h11)
            }
            Self::Quarters(corners) => corners[usize::from(u >= 0.5) + 2 * usize::from(v >= 0.5)],
            Self::Flat(height) => height,
        }
    }
}

impl ImageObject {
    /// Map of an image over dual cell `(i, j)`, which lies between the texels `(i, j)` and
    /// `(i + 1, j + 1)`. The cell must be in `-1..columns`, `-1..rows`.
    #[inline]
    pub(super) fn patch(&self, number: usize, cell: [i64; 2], solid: Solid) -> Patch {
        let place = self.layout.places()[number];
        let [x, y] = [0, 1].map(|axis| (i64::from(place[axis]) + cell[axis]) as usize);
        let (width, texels) = (self.heights.width() as usize, self.heights.texels());
        let first = y * width + x;
        let corners = [first, first + 1, first + width, first + width + 1].map(|at| f64::from(texels[at]));
        if solid == Solid::Silhouette {
            return Patch::Bilinear(corners.map(|height| f64::from(u8::from(height > EMPTY_HEIGHT))));
        }
        if self.cells == JumpCells::Nearest {
            return Patch::Quarters(corners);
        }
        let [a, b, c, d] = corners;
        let highest = a.max(b).max(c.max(d));
        let jumps = highest - a.min(b).min(c.min(d)) > self.jump;
        match self.cells {
            JumpCells::Step if jumps => Patch::Quarters(corners),
            JumpCells::Highest if jumps => Patch::Flat(highest),
            _ => Patch::Bilinear(corners),
        }
    }

    /// Height of an image's map at texture coordinates, or 0 beside the cells that reach into the
    /// image. Images are counted from 0. At a border between two cells, or two quarters, the one
    /// with the greater coordinates is used. `None` if there is no such image.
    pub fn height_at(&self, number: usize, u: f64, v: f64) -> Option<f64> {
        let size = self.views.get(number)?.size().map(f64::from);
        let place = [u * size[0] - 0.5, v * size[1] - 0.5];
        if !(0..2).all(|axis| (-1.0..size[axis]).contains(&place[axis])) {
            return Some(0.0);
        }
        let cell = place.map(f64::floor);
        let patch = self.patch(number, cell.map(|at| at as i64), Solid::Depth);
        Some(patch.at([place[0] - cell[0], place[1] - cell[1]]))
    }

    /// Whether a point is in the object.
    pub fn contains(&self, point: DVec3) -> bool {
        self.views.iter().enumerate().all(|(number, view)| {
            let seen = view.see(point).filter(|at| at.z > EMPTY_HEIGHT);
            seen.is_some_and(|at| self.height_at(number, at.x, at.y).is_some_and(|height| at.z <= height))
        })
    }

    /// Extension of an image's solid in the ray's parameter. `None` for an invalid ray: see
    /// [`first_hit`](Self::first_hit).
    pub(super) fn slack(&self, number: usize, ray: &Ray) -> Option<f64> {
        let (centre, radius) = self.views[number].ball();
        let length = ray.direction.length();
        let is_near = (ray.origin - centre).length() <= MAX_DISTANCE * radius;
        let is_direction = (LENGTHS[0]..=LENGTHS[1]).contains(&length);
        (is_near && is_direction)
            .then(|| AGREEMENT * ((ray.origin.length() + centre.length() + radius) / length))
    }
}
