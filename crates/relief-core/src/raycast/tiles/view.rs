//! Where on a picture points of the world are.

use glam::{DMat3, DVec3, Vec3};

use super::{Corners, PictureRays};
use crate::raycast::Sides;

/// What every projection is grown by besides what rays may stray, in pixels: rounding in `f64`, which is far
/// less unless a view is hardly one.
const MARGIN_PIXELS: f64 = 1.0 / 16.0;

/// The most that rays may stray from where they are projected, in pixels. More, and tiles list triangles that
/// they hardly show.
const MOST_STRAY_PIXELS: f64 = 2.0;

/// The least depth of a corner, relative to its distance, at which it is projected: its place is then known to
/// `1e-9` of itself.
const LEAST_DEPTH: f64 = 1.0 / (1 << 20) as f64;

/// How far beyond a plane something must be to be left out, relative to its distance; more than rounding.
const PLANE_SLACK: f64 = 1e-12;

/// How far the eye must be behind a triangle, as the sine of an angle, for no ray to meet its front, whatever
/// is rounded.
const BEHIND: f64 = 1e-5;

/// The projection of a picture's rays.
#[derive(Clone, Copy, Debug)]
pub struct View {
    eye: DVec3,
    /// Turns what is seen from the eye into columns, rows and depths; columns and rows from a point are to be
    /// divided by the depth.
    rows: [DVec3; 3],
    /// The direction of parallel rays.
    parallel: Option<DVec3>,
    /// How much projections are grown.
    grown: [f64; 2],
}

/// Where a triangle is.
pub enum Place {
    /// No ray of the picture meets it.
    Unseen,
    /// In a range of columns and rows.
    Within([[f64; 2]; 2]),
    /// It reaches beside or behind the eye.
    Through,
}

impl View {
    /// That of some rays, through points of a picture of so many columns and rows; none where their place is
    /// not known to a few pixels.
    pub fn new(rays: &PictureRays, size: [u32; 2]) -> Option<Self> {
        let [eye, eye_right, eye_down] = rays.origin;
        let [corner, right, down] = rays.direction;
        let stands = [eye_right, eye_down] == [Vec3::ZERO; 2];
        let is_parallel = [right, down] == [Vec3::ZERO; 2];
        if stands == is_parallel {
            return None;
        }
        let steps = if is_parallel { [eye_right, eye_down] } else { [right, down] }.map(Vec3::as_dvec3);
        let corner = corner.as_dvec3();
        let columns = DMat3::from_cols(steps[0], steps[1], corner);
        let inverse = columns.inverse();
        if !(inverse.is_finite() && columns.is_finite() && eye.is_finite()) {
            return None;
        }
        let rows = [0, 1, 2].map(|row| inverse.row(row));
        let [width, height] = size.map(f64::from);
        // A product and two sums of three numbers, each rounded to half of a unit in the last place.
        let added = if is_parallel { eye.as_dvec3() } else { corner };
        let sizes = added.abs() + steps[0].abs() * width + steps[1].abs() * height;
        let strays = rows.map(|row| row.abs().dot(sizes) * 4.0 * f64::from(f32::EPSILON));
        // The points themselves are rounded, too.
        let along = |axis: usize, length: f64| {
            let at_depth = if is_parallel { 0.0 } else { strays[2] };
            (strays[axis] + length * at_depth) / (1.0 - at_depth) + length * f64::from(f32::EPSILON)
        };
        let strays = [along(0, width), along(1, height), strays[2]];
        let is_fine = is_parallel || strays[2] < 0.5;
        if !(is_fine && strays[0] <= MOST_STRAY_PIXELS && strays[1] <= MOST_STRAY_PIXELS) {
            return None;
        }
        let grown = [strays[0] + MARGIN_PIXELS, strays[1] + MARGIN_PIXELS];
        let view = Self { eye: eye.as_dvec3(), rows, parallel: is_parallel.then_some(corner), grown };
        // A matrix that is nearly singular is no inverse.
        let ends = [[0.0, 0.0], [width, 0.0], [0.0, height], [width, height]];
        let is_inverse = ends.into_iter().all(|[x, y]| {
            let [column, row, depth] = view.seen(corner + steps[0] * x + steps[1] * y);
            let strays = [column - x, row - y, (depth - 1.0) * (width + height)];
            strays.into_iter().all(|stray| stray.abs() < 0.1 * MARGIN_PIXELS)
        });
        is_inverse.then_some(view)
    }

    /// Whether all rays have the same direction, and not the same origin.
    pub fn is_parallel(&self) -> bool {
        self.parallel.is_some()
    }

    /// How far beside its projection something may be met, in pixels.
    pub fn grown(&self) -> [f64; 2] {
        self.grown
    }

    /// Grows projections by other pixels than these must be grown by.
    #[cfg(test)]
    pub fn grow(&mut self, pixels: f64) {
        self.grown = [pixels; 2];
    }

    #[inline(always)]
    fn seen(&self, from_eye: DVec3) -> [f64; 3] {
        self.rows.map(|row| row.dot(from_eye))
    }

    /// Where a triangle is seen.
    #[inline(always)]
    pub fn place(&self, corners: &Corners, sides: Sides) -> Place {
        let from_eye = corners.map(|corner| corner - self.eye);
        let [a, b, c] = from_eye.map(|corner| self.seen(corner));
        let distance = from_eye[0].abs().max(from_eye[1].abs()).max(from_eye[2].abs()).max_element();
        let least = self.rows[2].abs().max_element() * distance * LEAST_DEPTH;
        if a[2].max(b[2]).max(c[2]) < -least || sides == Sides::Front && self.is_behind(from_eye, distance) {
            return Place::Unseen;
        }
        let range = |axis: usize, scale: [f64; 3]| {
            let [a, b, c] = [a[axis] * scale[0], b[axis] * scale[1], c[axis] * scale[2]];
            [a.min(b).min(c), a.max(b).max(c)]
        };
        if self.parallel.is_some() {
            return Place::Within([range(0, [1.0; 3]), range(1, [1.0; 3])]);
        }
        if a[2].min(b[2]).min(c[2]) <= least {
            return Place::Through;
        }
        let scale = [1.0 / a[2], 1.0 / b[2], 1.0 / c[2]];
        Place::Within([range(0, scale), range(1, scale)])
    }

    /// Whether the eye is clearly behind a triangle, whose corners are seen from there so far away at most.
    #[inline(always)]
    fn is_behind(&self, [a, b, c]: Corners, distance: f64) -> bool {
        let normal = (b - a).cross(c - a);
        let (along, length) = match self.parallel {
            Some(direction) => (normal.dot(direction), direction.abs().max_element()),
            None => (normal.dot(a), distance),
        };
        along > normal.abs().max_element() * length * BEHIND
    }

    /// The planes around a range of columns and rows.
    pub fn planes(&self, [columns, rows]: [[f64; 2]; 2]) -> Planes {
        let along = |axis: usize, end: f64, sign: f64| {
            let row = self.rows[axis];
            let (normal, from) = match self.parallel {
                Some(_) => (row, -end),
                None => (row - self.rows[2] * end, 0.0),
            };
            (normal * sign, from * sign)
        };
        let sides = [
            along(0, columns[0] - self.grown[0], 1.0),
            along(0, columns[1] + self.grown[0], -1.0),
            along(1, rows[0] - self.grown[1], 1.0),
            along(1, rows[1] + self.grown[1], -1.0),
        ];
        Planes {
            eye: self.eye,
            normals: [0, 1, 2].map(|axis| sides.map(|(normal, _)| normal[axis])),
            from: sides.map(|(_, from)| from),
        }
    }
}

/// Four planes around some rays, which lie where none of them is negative.
#[derive(Clone, Copy, Debug)]
pub struct Planes {
    eye: DVec3,
    /// The planes' normals, axis by axis.
    normals: [[f64; 4]; 3],
    /// What is added to a product with the normal.
    from: [f64; 4],
}

/// How something lies to planes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// All of it is beyond one of them.
    Outside,
    /// It may be on both sides.
    Across,
    /// It is clearly between them.
    Inside,
}

impl Planes {
    /// Where a box lies.
    #[inline(always)]
    pub fn side_of_box(&self, low: DVec3, high: DVec3) -> Side {
        let middle = ((low + high) * 0.5 - self.eye).to_array();
        let half = ((high - low) * 0.5).to_array();
        let (mut outside, mut across) = (false, false);
        for plane in 0..4 {
            let [mut along, mut reach, mut size] = [self.from[plane], 0.0, self.from[plane].abs()];
            for axis in 0..3 {
                let normal = self.normals[axis][plane];
                along += normal * middle[axis];
                reach += normal.abs() * half[axis];
                size += (normal * middle[axis]).abs();
            }
            reach += (size + reach) * PLANE_SLACK;
            outside |= along < -reach;
            across |= along < reach;
        }
        match (outside, across) {
            (true, _) => Side::Outside,
            (_, true) => Side::Across,
            _ => Side::Inside,
        }
    }

    /// Whether all of a triangle is beyond one of them.
    #[inline(always)]
    pub fn leave_out(&self, corners: &Corners) -> bool {
        let mut beyond = [true; 4];
        for corner in corners {
            let from_eye = (*corner - self.eye).to_array();
            for (plane, beyond) in beyond.iter_mut().enumerate() {
                let [mut along, mut size] = [self.from[plane], self.from[plane].abs()];
                for (normals, from_eye) in self.normals.iter().zip(from_eye) {
                    let part = normals[plane] * from_eye;
                    along += part;
                    size += part.abs();
                }
                *beyond &= along < -size * PLANE_SLACK;
            }
        }
        beyond.contains(&true)
    }
}
