//! The shadow of a relief on a floor, by the shadow map of three.js. The renderer's picture from the light
//! says where a ray to the light meets the relief.

use std::path::Path;

use glam::{DVec2, DVec3};
use relief_core::camera::{Camera, Projection};
use serde_json::json;

use super::drawn;
use super::mask::{Apart, Mask};
use crate::kits::{Job, rendered};

/// Longest way to the exact edge, in texels of the shadow map.
pub const BOUND_TEXELS: f64 = 1.5;

/// Ways that are looked for, in texels.
const LIMIT_TEXELS: f64 = 6.0;

/// Texels along a side of the shadow map.
const TEXELS: u32 = 512;

/// Pixels of the exact picture along a texel.
const FINER: u32 = 6;

/// The way to the light.
const SUN: DVec3 = DVec3::new(0.45, 1.0, 0.3);

/// How far the light's camera is away, and its view from edge to edge, in metres.
const SUN_M: [f64; 2] = [2.0, 1.25];

/// Heights of the floor, and of the camera that looks down at it from below the mesh.
const FLOOR_M: [f64; 2] = [-0.7, -0.55];

/// The floor that is seen, from edge to edge, in metres.
const FLOOR_HEIGHT_M: f64 = 1.4;

/// The light as a camera.
fn sun() -> Result<Camera, String> {
    let parallel = Projection::Orthographic { height_m: SUN_M[1] };
    Camera::with(SUN.normalize() * SUN_M[0], DVec3::ZERO, parallel).map_err(|error| error.to_string())
}

/// The camera over the middle of the shadow.
fn above() -> Result<Camera, String> {
    let middle = SUN * (FLOOR_M[0] / SUN.y);
    let eye = DVec3::new(middle.x, FLOOR_M[1], middle.z);
    let parallel = Projection::Orthographic { height_m: FLOOR_HEIGHT_M };
    Camera::with(eye, eye - DVec3::Y, parallel).map_err(|error| error.to_string())
}

/// Where the light meets the relief, exactly.
pub fn exact_of(job: &Job) -> Result<Mask, String> {
    let size = [TEXELS * FINER; 2];
    let hits = rendered::shown(job.mesh, job.heights, job.selection, sun()?, size)?;
    Ok(Mask { size, on: hits.iter().map(Option::is_some).collect() })
}

/// The points of the floor that pixels show, as places in a picture of this side from the light.
pub fn places([width, height]: [u32; 2], side: u32) -> Result<Vec<DVec2>, String> {
    let (sun, above) = (sun()?, above()?);
    let place = |k: u32| {
        let ray = above.ray(k % width, k / width, width, height);
        let point = ray.origin + ray.direction * (FLOOR_M[1] - FLOOR_M[0]) - sun.eye();
        let seen = DVec2::new(point.dot(sun.right()), -point.dot(sun.up())) / sun.half_height();
        (seen + 1.0) * (f64::from(side) / 2.0) - 0.5
    };
    Ok((0..width * height).map(place).collect())
}

/// How far from there three.js shows the shadow, in texels. `depth` is an option of its renderer.
pub fn measure(
    chromium: &Path,
    job: &Job,
    backend: &str,
    depth: &str,
    exact: &Mask,
) -> Result<(Apart, Mask), String> {
    let above = above()?;
    let floor = json!({
        "sun": (SUN.normalize() * SUN_M[0]).to_array(),
        "texels": TEXELS,
        "view": SUN_M[1],
        "height": FLOOR_M[0],
        "eye": above.eye().to_array(),
        "seen": FLOOR_HEIGHT_M,
    });
    let pixels = drawn(chromium, job, backend, json!({ "floor": floor, "depth": depth }))?;
    let mask = Mask { size: job.size, on: pixels.iter().map(|pixel| pixel[0] < 0.5).collect() };
    Ok((compare(exact, &mask)?, mask))
}

fn compare(exact: &Mask, shadow: &Mask) -> Result<Apart, String> {
    let places = places(shadow.size, exact.size[0])?;
    let shown = places.into_iter().zip(shadow.on.iter().copied());
    let texel = f64::from(exact.size[0]) / f64::from(TEXELS);
    let apart = exact.compare(shown, LIMIT_TEXELS * texel);
    Ok(Apart { farthest: apart.farthest / texel, ..apart })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kits::Subject;
    use relief_core::mesh::Builtin;

    /// The floor's picture of a shadow that lies some texels aside.
    fn moved(exact: &Mask, size: [u32; 2], texels: f64) -> Mask {
        let aside = DVec2::splat(texels * f64::from(exact.size[0]) / f64::from(TEXELS)) / 2f64.sqrt();
        let places = places(size, exact.size[0]).expect("places");
        Mask { size, on: places.iter().map(|place| exact.at(*place - aside)).collect() }
    }

    #[test]
    fn shadows_three_texels_aside_are_seen() {
        let subject = Subject::of(Builtin::Torus, "exact", [256, 192]).expect("a subject");
        let job = subject.job(true);
        let hits = rendered::shown(job.mesh, job.heights, job.selection, sun().expect("a sun"), [TEXELS; 2]);
        let on = hits.expect("hits").iter().map(Option::is_some).collect();
        let exact = Mask { size: [TEXELS; 2], on };
        let farthest = |texels| compare(&exact, &moved(&exact, job.size, texels)).expect("places").farthest;
        assert_eq!(farthest(0.0), 0.0);
        assert!(farthest(0.7) > 0.0 && farthest(0.7) <= BOUND_TEXELS);
        assert!(farthest(3.0) > BOUND_TEXELS);
    }
}
