//! What a mark says about a region of the cut.

use relief_core::Path;
use relief_shaders::cpu::Mark;

use super::view::View;
use crate::figure::{Color, Shape};

/// Part of the opacity that boxes have, which overlap more than other regions.
const FILL_OF_BOXES: f64 = 0.4;

pub const BOX: Color = [86, 142, 200];
pub const CONE: Color = [0, 130, 130];
pub const BALL: Color = [150, 90, 190];

/// The shapes of a region, with that opacity; none for marks of points.
pub fn shapes(view: &View, path: &Path, turn: f64, mark: &Mark, opacity: f64) -> Vec<Shape> {
    match *mark {
        Mark::Box { low, high, top } => {
            let Some([from, to]) = over(view, low, high) else { return Vec::new() };
            let corners = [[from, 0.0], [from, top], [to, top], [to, 0.0]];
            let corners = corners.map(|[ground, height]| view.place(ground, height)).to_vec();
            let outline = [corners[0], corners[1], corners[2], corners[3], corners[0]].to_vec();
            vec![
                Shape::Area { corners, color: BOX, opacity: FILL_OF_BOXES * opacity },
                Shape::Line { places: outline, color: BOX, width: 1.0, dashed: false },
            ]
        }
        Mark::Cone { uv, apex, slope } => {
            let height = |ground: f64| {
                let [u, v] = view.uv(ground);
                apex + slope * (u - uv[0]).hypot(v - uv[1])
            };
            region(view, view.ground, CONE, opacity, height)
        }
        Mark::Frustum { low, high, top, slopes } => {
            let height = |ground: f64| {
                let at = view.uv(ground);
                let rises = [0, 1].map(|axis| {
                    let beyond = (low[axis] - at[axis]).max(at[axis] - high[axis]).max(0.0);
                    slopes[axis] * beyond
                });
                top + rises[0].max(rises[1])
            };
            region(view, [view.speed * turn, view.ground[1]], CONE, opacity, height)
        }
        Mark::Ball { t, radius } => vec![Shape::Ellipse {
            centre: view.place(view.speed * t, path.at(t)[2]),
            radii: view.radii(radius),
            color: BALL,
            opacity,
        }],
        _ => Vec::new(),
    }
}

/// An empty region above a height.
fn region(
    view: &View,
    [from, to]: [f64; 2],
    color: Color,
    opacity: f64,
    height: impl Fn(f64) -> f64,
) -> Vec<Shape> {
    vec![
        Shape::Area { corners: view.area(from, to, true, &height), color, opacity },
        Shape::Line { places: view.line(from, to, &height), color, width: 1.0, dashed: false },
    ]
}

/// Metres along the ground between which the cut is over a rectangle.
pub fn over(view: &View, low: [f64; 2], high: [f64; 2]) -> Option<[f64; 2]> {
    let (origin, along) = (view.uv(0.0), view.along());
    let mut ground = [f64::NEG_INFINITY, f64::INFINITY];
    for axis in 0..2 {
        if along[axis] == 0.0 {
            if !(low[axis]..=high[axis]).contains(&origin[axis]) {
                return None;
            }
            continue;
        }
        let ends = [low[axis], high[axis]].map(|end| (end - origin[axis]) / along[axis]);
        ground = [ground[0].max(ends[0].min(ends[1])), ground[1].min(ends[0].max(ends[1]))];
    }
    // Extents beside a clamped map have no end.
    let far = view.ground[1] - view.ground[0];
    let seen = [ground[0].max(view.ground[0] - far), ground[1].min(view.ground[1] + far)];
    (seen[0] < seen[1]).then_some(seen)
}
