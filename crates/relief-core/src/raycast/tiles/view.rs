//! Projection of points of the world to a picture.

use glam::{DMat3, DVec3, Vec3};

use super::{Corners, PictureRays};
use crate::raycast::Sides;

/// Growth of every projection, in pixels, in addition to the rays' error. It covers rounding in
/// `f64`, which is far smaller in all sensible views.
const MARGIN_PIXELS: f64 = 1.0 / 16.0;

/// Largest error of rays in `f32`, in pixels. With a larger one, tiles would list many triangles
/// that they do not show.
const MOST_ERROR_PIXELS: f64 = 2.0;

/// Least depth of a corner, relative to its distance, at which it is projected. The relative error
/// of its position is then at most `1e-9`.
const LEAST_DEPTH: f64 = 1.0 / (1 << 20) as f64;

/// Distance beyond a plane at which something is left out, relative to its distance from the eye.
/// It exceeds rounding.
const PLANE_SLACK: f64 = 1e-12;

/// Sine of the angle by which the eye must be behind a triangle so that no ray hits its front,
/// whatever the rounding.
const BEHIND: f64 = 1e-5;

/// Projection of a picture's rays.
#[derive(Clone, Copy, Debug)]
pub struct View {
    eye: DVec3,
    /// Rows of the matrix from directions at the eye to columns, rows and depths. Columns and rows
    /// must be divided by the depth, unless rays are parallel.
    rows: [DVec3; 3],
    /// Direction of parallel rays.
    parallel: Option<DVec3>,
    /// Growth of projections, in pixels.
    grown: [f64; 2],
}

/// Projection of a triangle.
pub enum Projected {
    /// No ray of the picture hits it.
    Culled,
    /// The triangle is inside a range of columns and rows.
    Within([[f64; 2]; 2]),
    /// The triangle reaches beside or behind the eye.
    Unbounded,
}

impl View {
    /// Creates the projection of some rays, for a picture of `size` columns and rows. `None` if the
    /// rays' positions are not known to a few pixels.
    pub fn new(rays: &PictureRays, size: [u32; 2]) -> Option<Self> {
        let [eye, eye_right, eye_down] = rays.origin;
        let [corner, right, down] = rays.direction;
        let has_one_origin = [eye_right, eye_down] == [Vec3::ZERO; 2];
        let is_parallel = [right, down] == [Vec3::ZERO; 2];
        if has_one_origin == is_parallel {
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
        // A product and two sums of three numbers, each rounded to half a unit in the last place.
        let added = if is_parallel { eye.as_dvec3() } else { corner };
        let sizes = added.abs() + steps[0].abs() * width + steps[1].abs() * height;
        let errors = rows.map(|row| row.abs().dot(sizes) * 4.0 * f64::from(f32::EPSILON));
        // The points themselves are rounded, too.
        let along = |axis: usize, length: f64| {
            let at_depth = if is_parallel { 0.0 } else { errors[2] };
            (errors[axis] + length * at_depth) / (1.0 - at_depth) + length * f64::from(f32::EPSILON)
        };
        let errors = [along(0, width), along(1, height), errors[2]];
        let is_fine = is_parallel || errors[2] < 0.5;
        if !(is_fine && errors[0] <= MOST_ERROR_PIXELS && errors[1] <= MOST_ERROR_PIXELS) {
            return None;
        }
        let grown = [errors[0] + MARGIN_PIXELS, errors[1] + MARGIN_PIXELS];
        let view = Self { eye: eye.as_dvec3(), rows, parallel: is_parallel.then_some(corner), grown };
        // The inverse of a nearly singular matrix is not accurate.
        let ends = [[0.0, 0.0], [width, 0.0], [0.0, height], [width, height]];
        let is_inverse = ends.into_iter().all(|[x, y]| {
            let [column, row, depth] = view.coordinates(corner + steps[0] * x + steps[1] * y);
            let errors = [column - x, row - y, (depth - 1.0) * (width + height)];
            errors.into_iter().all(|error| error.abs() < 0.1 * MARGIN_PIXELS)
        });
        is_inverse.then_some(view)
    }

    /// Whether all rays have the same direction, and not the same origin.
    pub fn is_parallel(&self) -> bool {
        self.parallel.is_some()
    }

    /// Distance beside its projection at which something may still be hit, in pixels.
    pub fn grown(&self) -> [f64; 2] {
        self.grown
    }

    /// Replaces the growth of projections by a wrong one.
    #[cfg(test)]
    pub fn grow(&mut self, pixels: f64) {
        self.grown = [pixels; 2];
    }

    #[inline(always)]
    fn coordinates(&self, from_eye: DVec3) -> [f64; 3] {
        self.rows.map(|row| row.dot(from_eye))
    }

    /// Projects a triangle.
    #[inline(always)]
    pub fn project(&self, corners: &Corners, sides: Sides) -> Projected {
        let from_eye = corners.map(|corner| corner - self.eye);
        let [a, b, c] = from_eye.map(|corner| self.coordinates(corner));
        let distance = from_eye[0].abs().max(from_eye[1].abs()).max(from_eye[2].abs()).max_element();
        let least = self.rows[2].abs().max_element() * distance * LEAST_DEPTH;
        if a[2].max(b[2]).max(c[2]) < -least || sides == Sides::Front && self.is_behind(from_eye, distance) {
            return Projected::Culled;
        }
        let range = |axis: usize, scale: [f64; 3]| {
            let [a, b, c] = [a[axis] * scale[0], b[axis] * scale[1], c[axis] * scale[2]];
            [a.min(b).min(c), a.max(b).max(c)]
        };
        if self.parallel.is_some() {
            return Projected::Within([range(0, [1.0; 3]), range(1, [1.0; 3])]);
        }
        if a[2].min(b[2]).min(c[2]) <= least {
            return Projected::Unbounded;
        }
        let scale = [1.0 / a[2], 1.0 / b[2], 1.0 / c[2]];
        Projected::Within([range(0, scale), range(1, scale)])
    }

    /// Whether the eye is clearly behind a triangle. `distance` is the largest coordinate of its
    /// corners, seen from the eye.
    #[inline(always)]
    fn is_behind(&self, [a, b, c]: Corners, distance: f64) -> bool {
        let normal = (b - a).cross(c - a);
        let (along, length) = match self.parallel {
            Some(direction) => (normal.dot(direction), direction.abs().max_element()),
            None => (normal.dot(a), distance),
        };
        along > normal.abs().max_element() * length * BEHIND
    }

    /// Planes around a range of columns and rows.
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

/// Four planes around some rays. The rays lie where no plane's value is negative.
#[derive(Clone, Copy, Debug)]
pub struct Planes {
    eye: DVec3,
    /// Normals of the planes, axis by axis.
    normals: [[f64; 4]; 3],
    /// Offsets added to the product with the normal.
    from: [f64; 4],
}

/// Position of something relative to planes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// Entirely beyond one of the planes.
    Outside,
    /// Possibly on both sides.
    Across,
    /// Clearly between the planes.
    Inside,
}

impl Planes {
    /// Position of a box.
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

    /// Whether a triangle is entirely beyond one of the planes.
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
