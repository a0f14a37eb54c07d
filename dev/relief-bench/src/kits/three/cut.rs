//! Boxes of three.js that stand in a relief and cut it. Exact are the pixels where they are nearer than the
//! renderer's hits.

use std::path::Path;

use glam::DVec3;
use relief_core::camera::Camera;
use relief_core::mesh::Builtin;
use relief_core::raycast::Ray;
use relief_shaders::cpu::PixelOut;
use serde_json::{Value, json};

use super::drawn;
use super::mask::{Apart, Mask};
use super::place::Place;
use crate::kits::{EYE_M, Job, camera, rendered};

/// Longest way to the exact edge, in pixels: to a neighbour, also across a corner.
pub const BOUND_PIXELS: f64 = std::f64::consts::SQRT_2;

/// Ways that are looked for.
const LIMIT_PIXELS: f64 = 12.0;

/// A post, and a sheet that lies in the relief like water, for a mesh.
fn boxes(builtin: Builtin) -> [Place; 2] {
    match builtin {
        Builtin::Plane => [
            Place::new([0.1, 0.0, 0.15], [20.0, 30.0, 10.0], [0.3, 0.2, 0.15]),
            Place::new([-0.1, -0.027, -0.1], [2.0, 10.0, -1.0], [0.6, 0.01, 0.5]),
        ],
        _ => [
            Place::new([0.3, 0.1, 0.35], [20.0, 30.0, 10.0], [0.25, 0.3, 0.25]),
            Place::new([0.0, -0.03, 0.0], [12.0, 10.0, -8.0], [1.2, 0.01, 1.1]),
        ],
    }
}

/// How far along the ray a box begins, in units of its direction.
fn distance(ray: &Ray, of: &Place) -> Option<f64> {
    let inside = of.matrix().inverse();
    let (origin, way) = (inside.transform_point3(ray.origin), inside.transform_vector3(ray.direction));
    let (to, from) = ((DVec3::splat(-0.5) - origin) / way, (DVec3::splat(0.5) - origin) / way);
    let (enter, leave) = (to.min(from).max_element(), to.max(from).min_element());
    (enter <= leave && enter > 0.0).then_some(enter)
}

/// The pixels that show a box: those whose ray meets it before the hit.
fn exact(pixels: &[PixelOut], camera: &Camera, [width, height]: [u32; 2], boxes: &[Place]) -> Mask {
    let shows = |(k, pixel): (u32, &PixelOut)| {
        let ray = camera.ray(k % width, k / width, width, height);
        let hit = if pixel.hit == 1 { f64::from(pixel.depth) } else { f64::INFINITY };
        boxes.iter().filter_map(|of| distance(&ray, of)).any(|nearer| nearer < hit)
    };
    Mask { size: [width, height], on: (0..).zip(pixels).map(shows).collect() }
}

/// The exact picture of the boxes in a job's relief.
pub fn exact_of(job: &Job) -> Result<Mask, String> {
    let camera = camera(EYE_M, 0.0, job.size)?;
    let pixels = rendered::pixels(job.mesh, job.heights, job.selection, camera, job.size)?;
    Ok(exact(&pixels, &camera, job.size, &boxes(job.builtin)))
}

/// How far from there three.js shows the boxes. `depth` is an option of its renderer.
pub fn measure(
    chromium: &Path,
    job: &Job,
    backend: &str,
    depth: &str,
    exact: &Mask,
) -> Result<(Apart, Mask), String> {
    let places: Vec<Value> = boxes(job.builtin).iter().map(Place::json).collect();
    let pixels = drawn(chromium, job, backend, json!({ "boxes": places, "depth": depth }))?;
    let mask = Mask { size: job.size, on: pixels.iter().map(is_box).collect() };
    Ok((exact.compare(mask.places(), LIMIT_PIXELS), mask))
}

/// Boxes are drawn without texture coordinates.
fn is_box(pixel: &[f32; 4]) -> bool {
    pixel[3] > 0.5 && pixel[0] < 0.5
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kits::Subject;

    #[test]
    fn boxes_begin_where_they_do() {
        let of = Place::new([0.0, 0.0, -2.0], [0.0, 90.0, 0.0], [4.0, 1.0, 1.0]);
        let ray = |x| Ray { origin: DVec3::new(x, 0.0, 3.0), direction: DVec3::NEG_Z };
        let near = distance(&ray(0.0), &of).expect("it is there");
        assert!((near - 3.0).abs() < 1e-12, "{near}");
        assert_eq!(distance(&ray(0.6), &of), None);
    }

    #[test]
    fn boxes_two_pixels_aside_are_seen() {
        let subject = Subject::of(Builtin::Sphere, "exact", [128, 96]).expect("a subject");
        let job = subject.job(true);
        let camera = camera(EYE_M, 0.0, job.size).expect("a camera");
        let pixels = rendered::pixels(job.mesh, job.heights, job.selection, camera, job.size).expect("hits");
        let pixel_m = 2.0 * EYE_M.length() * camera.half_height() / f64::from(job.size[1]);
        let moved = |pixels_aside: f64| {
            boxes(job.builtin)
                .map(|of| Place { position: of.position + camera.right() * (pixel_m * pixels_aside), ..of })
        };
        let truth = exact(&pixels, &camera, job.size, &moved(0.0));
        let farthest = |aside| {
            truth.compare(exact(&pixels, &camera, job.size, &moved(aside)).places(), LIMIT_PIXELS).farthest
        };
        assert_eq!(farthest(0.0), 0.0);
        assert!(farthest(0.1) <= BOUND_PIXELS);
        assert!(farthest(2.0) > BOUND_PIXELS);
    }
}
