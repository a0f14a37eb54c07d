//! Combination of the three frames of a grid that are nearest to a ray.

use glam::{DVec2, DVec3};

use super::patch::Solid;
use super::{EMPTY_HEIGHT, FrameGrid, ImageObject, ObjectHit};
use crate::raycast::Ray;

/// Least cosine between a frame's direction and the ray's for the frame to count. Other frames are
/// seen edge-on.
pub const LEAST_FACING: f64 = 0.05;

/// Weighted share of the three frames that must show something.
pub const LEAST_COVER: f64 = 0.5;

/// An object whose images form a grid. A ray uses the three images around its direction.
#[derive(Clone, Copy, Debug)]
pub struct ObjectFrames<'a> {
    object: &'a ImageObject,
    grid: FrameGrid,
}

impl ImageObject {
    /// Grid of the images, if they form one.
    pub fn grid(&self) -> Option<FrameGrid> {
        FrameGrid::of(&self.views)
    }

    /// Returns the object for tracing by three frames per ray. `None` if its images form no grid.
    pub fn frames(&self) -> Option<ObjectFrames<'_>> {
        Some(ObjectFrames { object: self, grid: self.grid()? })
    }
}

impl ObjectFrames<'_> {
    /// Returns the first hit of a ray with the solid of its three frames, as
    /// [`ImageObject::first_hit`] for these alone. Where they show nothing, all images together
    /// show nothing either. Space that only other images show as empty is solid here.
    pub fn first_hit(&self, ray: &Ray) -> Option<ObjectHit> {
        let numbers = self.grid.frames(-ray.direction.normalize()).map(|(number, _)| number);
        self.object.enter(ray, Solid::Depth, numbers.into_iter())
    }

    /// Returns the hit of a ray with the octahedral impostor as drawn by game engines, as a
    /// parameter in units of its direction, from 0 on.
    ///
    /// In each frame the ray meets the plane through the ball's middle. From there it moves `steps`
    /// times to the plane at the height that the frame shows at its position (parallax mapping).
    /// Coverage and distance along the ray are blended by the weights of the three frames. The
    /// result is an approximation without any bound (Brucks 2018): frames show different surfaces,
    /// and their outlines are mixed.
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

    /// Share of the four texels around a position that show something, and the mean height of
    /// these.
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
