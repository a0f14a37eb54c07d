//! The word "relief" in raised letters on a sunken panel.

use super::lattice::{mix, smooth_step};
use super::picture::Grid;

const SIDE: u32 = 384;
/// Width of the word in tiles.
const WORD_WIDTH: f64 = 0.74;
/// Half the width of a stroke, in x-heights.
const HALF_STROKE: f64 = 0.13;
/// Left and right end of the word with its strokes, in x-heights.
const ENDS: [f64; 2] = [-0.13, 5.21];
/// What is in the middle of the tile: half-way between the base line and the tops of the tall letters, by
/// eye.
const MIDDLE: f64 = 0.72;

/// Height of the frame, where the letters are 1 and the panel is 0.
const RIM_HEIGHT: f64 = 0.7;

/// A stroke of a letter, in x-heights, with y up from the base line.
#[derive(Clone, Copy)]
enum Stroke {
    Line([f64; 2], [f64; 2]),
    /// Part of a circle, counter-clockwise from one direction to another, which are unit vectors.
    Arc {
        centre: [f64; 2],
        radius: f64,
        from: [f64; 2],
        to: [f64; 2],
    },
}

/// The letters, one after the other.
const WORD: [Stroke; 12] = [
    // r
    Stroke::Line([0.0, 0.0], [0.0, 1.0]),
    Stroke::Arc { centre: [0.42, 0.58], radius: 0.42, from: [0.5, 0.866_025_403_784_438_6], to: [-1.0, 0.0] },
    // e
    Stroke::Line([1.0, 0.5], [2.0, 0.5]),
    Stroke::Arc { centre: [1.5, 0.5], radius: 0.5, from: [1.0, 0.0], to: [0.6, -0.8] },
    // l
    Stroke::Line([2.4, 0.0], [2.4, 1.6]),
    // i
    Stroke::Line([2.82, 0.0], [2.82, 1.0]),
    Stroke::Line([2.82, 1.42], [2.82, 1.44]),
    // e
    Stroke::Line([3.22, 0.5], [4.22, 0.5]),
    Stroke::Arc { centre: [3.72, 0.5], radius: 0.5, from: [1.0, 0.0], to: [0.6, -0.8] },
    // f
    Stroke::Line([4.62, 0.0], [4.62, 1.24]),
    Stroke::Arc { centre: [4.98, 1.24], radius: 0.36, from: [0.28, 0.96], to: [-1.0, 0.0] },
    Stroke::Line([4.44, 1.0], [4.94, 1.0]),
];

pub fn map() -> Grid<f64> {
    let unit = WORD_WIDTH / (ENDS[1] - ENDS[0]);
    Grid::square(SIDE, |u, v| {
        let point = [(u - 0.5) / unit + mix(ENDS[0], ENDS[1], 0.5), (0.5 - v) / unit + MIDDLE];
        let distance = WORD.iter().map(|stroke| stroke.distance(point)).fold(f64::INFINITY, f64::min);
        // A letter is round on top: the quarter of an ellipse from its edge to its middle.
        let inward = (1.0 - distance / HALF_STROKE).clamp(0.0, 1.0);
        (inward * (2.0 - inward)).sqrt().max(RIM_HEIGHT * rim(u, v))
    })
}

/// The frame around the panel: 1 at the tile's edge, 0 on the panel, which has rounded corners.
fn rim(u: f64, v: f64) -> f64 {
    let (half_side, corner) = (0.44, 0.1);
    let (qx, qy) = ((u - 0.5).abs() - half_side + corner, (v - 0.5).abs() - half_side + corner);
    let (ox, oy) = (qx.max(0.0), qy.max(0.0));
    let beyond = (ox * ox + oy * oy).sqrt() + qx.max(qy).min(0.0) - corner;
    smooth_step(-0.02, 0.01, beyond)
}

impl Stroke {
    fn distance(self, p: [f64; 2]) -> f64 {
        match self {
            Stroke::Line(a, b) => {
                let (along, to) = (minus(b, a), minus(p, a));
                let t = (dot(to, along) / dot(along, along)).clamp(0.0, 1.0);
                length([to[0] - t * along[0], to[1] - t * along[1]])
            }
            Stroke::Arc { centre, radius, from, to } => {
                let d = minus(p, centre);
                if is_between(d, from, to) {
                    return (length(d) - radius).abs();
                }
                let end = |direction: [f64; 2]| length(minus(d, direction.map(|part| part * radius)));
                end(from).min(end(to))
            }
        }
    }
}

/// Whether `d` lies in the sector that runs counter-clockwise from one direction to another.
fn is_between(d: [f64; 2], from: [f64; 2], to: [f64; 2]) -> bool {
    let (after_from, before_to) = (cross(from, d) >= 0.0, cross(d, to) >= 0.0);
    if cross(from, to) >= 0.0 { after_from && before_to } else { after_from || before_to }
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn length(a: [f64; 2]) -> f64 {
    dot(a, a).sqrt()
}
