//! Blades of grass.

use glam::DVec3;
use relief_core::rng::Rng;

use super::MotifSettings;
use super::tube::{End, Parts};

/// Length of the heights 0 to 1 in tiles.
const DEPTH: f64 = 0.3;

/// Half the width of a blade at its root, in tiles, where the thickness is 1.
const HALF_WIDTH: f64 = 0.035;

/// Thickness of a blade as a part of its width.
const FLATNESS: f64 = 0.4;

fn pieces(detail: u64) -> u64 {
    (detail / 2).max(3)
}

/// Corners of a blade's cross section.
const CORNERS: u64 = 4;

pub(super) fn triangles_a_blade(detail: u64) -> u64 {
    2 * CORNERS * (pieces(detail) - 1) + 2 * CORNERS
}

pub(super) fn make(settings: &MotifSettings, parts: &mut Parts) -> f64 {
    let mut rng = Rng::new(settings.seed);
    let pieces = pieces(settings.detail.into());
    for _ in 0..settings.count {
        let root = DVec3::new(rng.unit(), 0.0, rng.unit());
        let height = DEPTH * rng.between(0.55, 1.0);
        // Two random numbers together, so that few blades lean far.
        let bend = height * rng.between(0.1, 1.0) * rng.between(0.2, 0.9);
        let lean = rng.between(0.0, std::f64::consts::TAU);
        let half_width = HALF_WIDTH * settings.thickness * rng.between(0.7, 1.3);
        let forward = DVec3::new(lean.cos(), 0.0, lean.sin());
        let across = forward.cross(DVec3::Y);
        let middle = |part: f64| root + DVec3::Y * (height * part) + forward * (bend * part * part);
        let tile = |at: DVec3| DVec3::new(at.x, at.y / DEPTH, at.z);
        let ring = |piece: u64| -> Vec<DVec3> {
            let part = piece as f64 / pieces as f64;
            let width = half_width * (1.0 - part).powf(0.7);
            let up = DVec3::Y * height + forward * (2.0 * bend * part);
            // The root is level, so that it lies on the surface.
            let up = if piece == 0 { DVec3::Y } else { up.normalize() };
            let outward = across.cross(up);
            let at = middle(part);
            let corners = [across * width, outward * (width * FLATNESS)];
            [corners[0], corners[1], -corners[0], -corners[1]].map(|corner| tile(at + corner)).to_vec()
        };
        let rings: Vec<_> = (0..pieces).map(ring).collect();
        parts.tube(&rings, Some([End::Cap(tile(root)), End::Tip(tile(middle(1.0)))]));
    }
    DEPTH
}
