//! Chain mail, four in one: links in rows that lean to one side and to the other by turns.

use std::f64::consts::TAU;

use glam::DVec3;

use super::MotifSettings;
use super::tube::Parts;

/// Radius of a link's middle line, in distances between links of a row.
const RADIUS: f64 = 0.4;

/// Distance between rows, in distances between links of a row.
const ROW: f64 = 0.3;

/// Angle by which links lean, in degrees.
const LEAN_DEG: f64 = 30.0;

/// Least distance between the middle lines of two links, with the numbers above: found by trying all
/// pairs of points.
const APART: f64 = 0.174;

/// Number of rows in a tile: even, and about as long as the links are wide.
pub(super) fn rows(count: u32) -> u64 {
    2 * ((f64::from(count) / ROW / 2.0).round() as u64).max(1)
}

fn rings_a_link(detail: u64) -> u64 {
    3 * detail
}

pub(super) fn triangles_a_link(detail: u64) -> u64 {
    2 * detail * rings_a_link(detail)
}

pub(super) fn make(settings: &MotifSettings, parts: &mut Parts) -> f64 {
    let MotifSettings { count, thickness, detail, .. } = *settings;
    let wire = 0.5 * APART * thickness;
    let (sin, cos) = LEAN_DEG.to_radians().sin_cos();
    let half_depth = RADIUS * sin + wire;
    let rows = rows(count);
    // From distances between links to tiles.
    let [along, down] = [1.0 / f64::from(count), 1.0 / (ROW * rows as f64)];
    let rings = rings_a_link(detail.into());
    for row in 0..rows {
        let lean = if row % 2 == 0 { sin } else { -sin };
        for column in 0..count {
            let offset = if row % 2 == 0 { 0.25 } else { 0.75 };
            let middle = DVec3::new(f64::from(column) + offset, 0.0, (row as f64 + 0.5) * ROW);
            // Both axes of the link's plane, and its normal.
            let (right, back) = (DVec3::X, DVec3::new(0.0, lean, cos));
            let normal = right.cross(back);
            let ring = |at: u64| -> Vec<DVec3> {
                let (sin, cos) = (TAU * at as f64 / rings as f64).sin_cos();
                let outward = right * cos + back * sin;
                let point = |side: u32| {
                    let (sin, cos) = (TAU * (f64::from(side) + 0.5) / f64::from(detail)).sin_cos();
                    let at = middle + outward * (RADIUS + wire * cos) + normal * (wire * sin);
                    DVec3::new(at.x * along, 0.5 + 0.5 * at.y / half_depth, at.z * down)
                };
                (0..detail).map(point).collect()
            };
            parts.tube(&(0..rings).map(ring).collect::<Vec<_>>(), None);
        }
    }
    2.0 * half_depth * along
}
