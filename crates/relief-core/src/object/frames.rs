//! What three frames of a grid make together.

use glam::{DVec2, DVec3};

use super::patch::Solid;
use super::{EMPTY_HEIGHT, FrameGrid, ImageObject, ObjectHit};
use crate::raycast::Ray;

/// The least cosine between a frame's direction and the ray's for the frame to count: others are seen edge
/// on.
pub const LEAST_FACING: f64 = 0.05;

/// The part of three frames, by their weights, that must show something.
pub const LEAST_COVER: f64 = 0.5;

/// An object whose images make a grid, of which the three around the direction of a ray are asked.
#[derive(Clone, Copy, Debug)]
pub struct ObjectFrames<'a> {
    object: &'a ImageObject,
    grid: FrameGrid,
}

impl ImageObject {
    /// The grid that its images make, if they make one.
    pub fn grid(&self) -> Option<FrameGrid> {
        FrameGrid::of(&self.views)
    }

    /// The same by three frames a ray; none where its images make no grid.
    pub fn frames(&self) -> Option<ObjectFrames<'_>> {
        Some(ObjectFrames { object: self, grid: self.grid()? })
    }
}

impl ObjectFrames<'_> {
    /// Where a ray first meets what the three frames see: as [`ImageObject::first_hit`] of these alone. Where
    /// they see nothing all images do not either, but what others alone say is empty is solid.
    pub fn first_hit(&self, ray: &Ray) -> Option<ObjectHit> {
        let numbers = self.grid.frames(-ray.direction.normalize()).map(|(number, _)| number);
        self.object.enter(ray, Solid::Depth, numbers.into_iter())
    }

    /// Where a ray meets the impostor that game engines draw, in units of its direction, from 0 on.
    ///
    /// In each frame the ray meets the plane through the ball's middle. From there it is moved so many steps
    /// to the plane of the height that the frame shows where it is (parallax mapping). What the three frames
    /// show there is blended by their weights: whether there is something, and how far along the ray. An
    /// approximation without any bound (Brucks 2018): frames do not agree on what is seen, and their outlines
    /// are mixed.
    pub fn blended(&self, ray: &Ray, steps: u32) -> Option<f64> {
        let length = ray.direction.length();
        let toward = -ray.direction / length;
        let (mut cover, mut along) = (0.0, 0.0);
        for (number, weight) in self.grid.frames(toward) {
            let (view, place) = (&self.object.views[number], self.object.layout.places()[number]);
            if view.axes()[2].dot(toward) < LEAST_FACING {
                continue;
            }
            let [u, v, height, _] = view.rows();
            let seen = |at: DVec3, w: f64| {
                let point = at.extend(w);
                DVec3::new(u.dot(point), v.dot(point), height.dot(point))
            };
            let (origin, change) = (seen(ray.origin, 1.0), seen(ray.direction, 0.0));
            let at_height = |height: f64| (height - origin.z) / change.z;
            let mut height = 0.5;
            let mut looked = (0.0, height);
            for _ in 0..=steps {
                let place_on = origin + change * at_height(height);
                looked = self.look(view.size(), place, place_on.truncate());
                if looked.0 > 0.0 {
                    height = looked.1;
                }
            }
            cover += weight * looked.0;
            along += weight * looked.0 * at_height(height);
        }
        (cover >= LEAST_COVER && along >= 0.0).then(|| along / cover)
    }

    /// The part of a frame's four texels around a place that show something, and the height that these have.
    fn look(&self, size: [u32; 2], place: [u32; 2], uv: DVec2) -> (f64, f64) {
        let size = DVec2::from(size.map(f64::from));
        let at = (uv * size - 0.5).clamp(DVec2::splat(-1.0), size);
        let cell = at.floor();
        let part = at - cell;
        let first = [cell.x as i64 + i64::from(place[0]), cell.y as i64 + i64::from(place[1])];
        let (mut cover, mut sum) = (0.0, 0.0);
        for (below, across_rows) in [1.0 - part.y, part.y].into_iter().enumerate() {
            for (right, across_columns) in [1.0 - part.x, part.x].into_iter().enumerate() {
                let texel = self.object.heights.texel(first[0] + right as i64, first[1] + below as i64);
                if f64::from(texel) > EMPTY_HEIGHT {
                    let weight = across_rows * across_columns;
                    cover += weight;
                    sum += weight * f64::from(texel);
                }
            }
        }
        (cover, if cover > 0.0 { sum / cover } else { 0.0 })
    }
}
