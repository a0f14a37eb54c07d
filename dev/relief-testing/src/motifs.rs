//! Motifs beside their own triangles, one by one in `f64`.

use glam::DVec3;
use relief_core::{Path, TileTriangle};

/// Triangle of a motif in all tiles.
#[derive(Clone, Debug)]
pub struct Repeated {
    corners: Vec<[DVec3; 3]>,
}

/// Where a straight path meets a triangle: its parameter, and the least weight of a corner.
#[derive(Clone, Copy, Debug)]
pub struct Meeting {
    /// The parameter.
    pub t: f64,
    /// The least weight of a corner: 0 on an edge.
    pub inside: f64,
    /// The cosine between the path and the triangle's normal, as lengths in tiles.
    pub cosine: f64,
}

impl Repeated {
    /// The triangles, which repeat with the tiles.
    pub fn new(triangles: &[TileTriangle]) -> Self {
        Self { corners: triangles.iter().map(|triangle| triangle.corners).collect() }
    }

    /// All meetings of a straight path with the triangles, in no order.
    pub fn meetings(&self, path: &Path) -> Vec<Meeting> {
        let at = |t: f64| DVec3::from(path.at(t));
        let (begin, end) = (at(0.0), at(path.exit));
        let step = (end - begin) / path.exit;
        let mut all = Vec::new();
        for corners in &self.corners {
            let [low, high] = extent(corners);
            let tiles = |axis: usize| {
                let (from, to) = (begin[axis].min(end[axis]), begin[axis].max(end[axis]));
                (from - high[axis]).floor() as i32..=(to - low[axis]).ceil() as i32
            };
            for j in tiles(1) {
                for i in tiles(0) {
                    let tile = DVec3::new(f64::from(i), f64::from(j), 0.0);
                    let moved = corners.map(|corner| corner + tile);
                    all.extend(meeting(begin, step, moved).filter(|met| (0.0..=path.exit).contains(&met.t)));
                }
            }
        }
        all
    }

    /// Distance in tiles between a place and the nearest triangle.
    pub fn distance(&self, place: [f64; 3]) -> f64 {
        let place = DVec3::from(place);
        let mut least = f64::INFINITY;
        for corners in &self.corners {
            let [low, high] = extent(corners);
            let tiles = |axis: usize| {
                (place[axis] - high[axis]).floor() as i32..=(place[axis] - low[axis]).ceil() as i32
            };
            for j in tiles(1) {
                for i in tiles(0) {
                    let tile = DVec3::new(f64::from(i), f64::from(j), 0.0);
                    least = least.min(to_triangle(place, corners.map(|corner| corner + tile)));
                }
            }
        }
        least
    }
}

fn extent([a, b, c]: &[DVec3; 3]) -> [DVec3; 2] {
    [a.min(*b).min(*c), a.max(*b).max(*c)]
}

fn meeting(begin: DVec3, step: DVec3, [a, b, c]: [DVec3; 3]) -> Option<Meeting> {
    let normal = (b - a).cross(c - a);
    let against = normal.dot(step);
    if against == 0.0 {
        return None;
    }
    let t = normal.dot(a - begin) / against;
    let place = begin + step * t;
    let weight =
        |from: DVec3, to: DVec3| (to - from).cross(place - from).dot(normal) / normal.length_squared();
    let inside = weight(a, b).min(weight(b, c)).min(weight(c, a));
    let cosine = (against / (normal.length() * step.length())).abs();
    (inside >= 0.0).then_some(Meeting { t, inside, cosine })
}

/// Distance between a point and a segment.
fn to_segment(point: DVec3, a: DVec3, b: DVec3) -> f64 {
    let way = b - a;
    let part = ((point - a).dot(way) / way.length_squared().max(f64::MIN_POSITIVE)).clamp(0.0, 1.0);
    (a + way * part - point).length()
}

/// Distance between a point and a triangle.
pub fn to_triangle(point: DVec3, corners: [DVec3; 3]) -> f64 {
    let [a, b, c] = corners;
    let normal = (b - a).cross(c - a).normalize_or_zero();
    let sides = [(a, b), (b, c), (c, a)];
    let is_above = sides.iter().all(|(from, to)| (*to - *from).cross(point - *from).dot(normal) >= 0.0);
    if is_above && normal != DVec3::ZERO {
        return (point - a).dot(normal).abs();
    }
    sides.into_iter().map(|(from, to)| to_segment(point, from, to)).fold(f64::INFINITY, f64::min)
}
