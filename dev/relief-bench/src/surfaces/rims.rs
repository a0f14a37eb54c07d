//! Outlines near the rims of a cylinder.

use std::f64::consts::TAU;

use glam::DVec3;
use relief_core::camera::Camera;
use relief_testing::outline::places_and_distances;
use relief_tests::curved::Picture;

/// Radius of the built-in cylinder, and half of its height.
const HALF_M: f64 = 0.5;

/// Points of a rim that are looked at.
const POINTS: u32 = 256;

/// How far from a rim an outline is near it, in scales of the displacement.
const NEAR_SCALES: f64 = 1.5;

/// The distances between the outlines of two pictures of the built-in cylinder near its rims, in pixels.
pub fn distances(one: &Picture, other: &Picture, camera: Camera, scale_m: f64) -> Vec<f64> {
    let [columns, rows] = one.size;
    let [a, b] = [one, other].map(|picture| picture.mask().filled());
    let is_near = |[x, y]: [i64; 2]| {
        let ray = camera.ray(x as u32, y as u32, columns, rows);
        let along = ray.direction.normalize();
        rims().any(|point| {
            let to = point - ray.origin;
            (to - to.dot(along) * along).length() < NEAR_SCALES * scale_m
        })
    };
    let near = places_and_distances(&a, &b).into_iter().filter(|(place, _)| is_near(*place));
    near.map(|(_, distance)| distance).collect()
}

fn rims() -> impl Iterator<Item = DVec3> {
    let point = |number: u32, y: f64| {
        let (sin, cos) = (TAU * f64::from(number) / f64::from(POINTS)).sin_cos();
        DVec3::new(HALF_M * sin, y, HALF_M * cos)
    };
    [-HALF_M, HALF_M].into_iter().flat_map(move |y| (0..POINTS).map(move |number| point(number, y)))
}
