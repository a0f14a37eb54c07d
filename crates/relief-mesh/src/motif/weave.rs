//! Plain weave.

use std::f64::consts::{PI, TAU};

use glam::DVec3;

use super::MotifSettings;
use super::tube::{End, Parts};

/// Heights by which the middle of a thread goes up and down, and half the thickness of a thread. The
/// second stays below the first times a cosine wherever two threads cross, so that they do not touch.
const SWING: f64 = 0.26;
const HALF_THICKNESS: f64 = 0.22;

/// Width of the widest thread, in distances between threads.
const WIDEST: f64 = 0.8;

/// Depth in distances between threads.
const DEPTH: f64 = 0.8;

/// Rings of points from one crossing to the next.
fn rings_a_crossing(detail: u64) -> u64 {
    detail.max(6)
}

pub(super) fn triangles_a_thread(count: u64, detail: u64) -> u64 {
    2 * detail * (count * rings_a_crossing(detail)) + 2 * detail
}

pub(super) fn make(settings: &MotifSettings, parts: &mut Parts) -> f64 {
    let MotifSettings { count, thickness, detail, .. } = *settings;
    let threads = f64::from(count);
    let rings = count * rings_a_crossing(detail.into()) as u32;
    for over in [false, true] {
        for number in 0..count {
            let middle = (f64::from(number) + 0.5) / threads;
            let ring = |ring: u32| -> (DVec3, Vec<DVec3>) {
                let along = f64::from(ring) / f64::from(rings);
                // The last ring has the first one's numbers, so that the caps of two tiles match.
                let phase = f64::from(ring % rings) / f64::from(rings);
                let side = if (number % 2 == 0) == over { 1.0 } else { -1.0 };
                let height = 0.5 + side * SWING * (PI * threads * phase - 0.5 * PI).cos();
                let point = |across: f64, height: f64| {
                    if over { DVec3::new(across, height, along) } else { DVec3::new(along, height, across) }
                };
                let around = (0..detail).map(|at| {
                    // Half a step on, so that no side stands upright.
                    let (sin, cos) = (TAU * (f64::from(at) + 0.5) / f64::from(detail)).sin_cos();
                    let half_width = 0.5 * WIDEST * thickness / threads;
                    point(middle + half_width * cos, height + HALF_THICKNESS * thickness.sqrt() * sin)
                });
                (point(middle, height), around.collect())
            };
            let (centres, rings): (Vec<DVec3>, Vec<_>) = (0..=rings).map(ring).unzip();
            let ends = [centres[0], centres[centres.len() - 1]].map(End::Cap);
            parts.tube(&rings, Some(ends));
        }
    }
    DEPTH / threads
}
