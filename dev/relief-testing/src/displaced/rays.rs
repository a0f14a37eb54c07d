//! Rays that are hard to judge, and ordinary ones.

use glam::DVec3;

use super::sheet::Sheet;
use relief_core::rng::Rng;

/// A ray, and what is known of it.
pub struct Ray {
    /// Where it begins, in metres.
    pub origin: DVec3,
    /// Direction, of any length.
    pub direction: DVec3,
    /// The depth, in metres, of a point of the sheet that the ray goes through for certain.
    pub target: Option<f64>,
}

/// The kinds of rays.
pub const KINDS: [&str; 9] = [
    "from around to inside",
    "along an axis",
    "to a point of a triangle",
    "to a point on an edge",
    "to a vertex",
    "to a line between texels",
    "tangent, or hardly not",
    "through two points, nearly tangent",
    "from inside the relief",
];

/// A ray of one of several kinds; `kind` counts through them.
pub fn ray(sheet: &Sheet, kind: usize, rng: &mut Rng) -> Ray {
    let size = sheet.size();
    let triangle = rng.below(sheet.triangles());
    match kind % KINDS.len() {
        // From anywhere around to anywhere inside.
        0 => {
            let origin = 2.0 * size * rng.direction();
            let to = 0.6 * size * rng.unit() * rng.direction();
            Ray { origin, direction: (to - origin) * (0.1 + 3.0 * rng.unit()), target: None }
        }
        // Along an axis of the world.
        1 => {
            let axis = rng.pick(&DVec3::AXES);
            let beside = 0.5 * size * rng.direction();
            Ray {
                origin: beside - beside.dot(axis) * axis - 3.0 * size * axis,
                direction: axis,
                target: None,
            }
        }
        // To a point inside a triangle, on a side, at a corner, on a line between cells.
        2 => aimed(sheet, triangle, inside(rng), rng),
        3 => {
            let s = rng.unit();
            let side = [[s, 1.0 - s, 0.0], [0.0, s, 1.0 - s], [1.0 - s, 0.0, s]];
            aimed(sheet, triangle, rng.pick(&side), rng)
        }
        4 => aimed(sheet, triangle, rng.pick(&DVec3::AXES).to_array(), rng),
        5 => {
            let weights = on_line(sheet, triangle, rng);
            aimed(sheet, triangle, weights, rng)
        }
        // Tangent, or a little beside.
        6 => tangent(sheet, triangle, rng),
        // Through two points of the sheet that may be very near each other: nearly tangent, and yet a hit.
        7 => chord(sheet, triangle, rng),
        // From inside the relief.
        _ => {
            let weights = inside(rng);
            let above = sheet.scale_m.abs() * (2.0 * rng.unit() - 1.0) * sheet.normal(triangle, weights);
            let origin = sheet.point(triangle, weights) + above;
            Ray { origin, direction: 0.01 * rng.direction(), target: None }
        }
    }
}

/// Weights inside a triangle.
fn inside(rng: &mut Rng) -> [f64; 3] {
    let (a, b) = (rng.unit(), rng.unit());
    let (a, b) = if a + b > 1.0 { (1.0 - a, 1.0 - b) } else { (a, b) };
    [1.0 - a - b, a, b]
}

/// Weights whose place is on a line between cells, where the triangle has one.
fn on_line(sheet: &Sheet, triangle: u32, rng: &mut Rng) -> [f64; 3] {
    let (from, to) = (inside(rng), inside(rng));
    let axis = rng.below(2) as usize;
    let [a, b] = [from, to].map(|w| sheet.place(triangle, w)[axis]);
    let s = (a.max(b).floor() - a) / (b - a);
    if (0.0..=1.0).contains(&s) { std::array::from_fn(|k| from[k] + s * (to[k] - from[k])) } else { from }
}

/// A ray from outside through a point of the sheet. What it meets before does not matter.
fn aimed(sheet: &Sheet, triangle: u32, weights: [f64; 3], rng: &mut Rng) -> Ray {
    let point = sheet.point(triangle, weights);
    let unit = rng.direction();
    let depth = 2.0 * sheet.size();
    Ray { origin: point - depth * unit, direction: unit * (0.5 + rng.unit()), target: Some(depth) }
}

/// A ray through two points of the sheet in one triangle, a tenth to a ten-thousandth of it apart. What the
/// ray runs along is no target: there its depth is lost to rounding.
fn chord(sheet: &Sheet, triangle: u32, rng: &mut Rng) -> Ray {
    let (from, towards) = (inside(rng), inside(rng));
    let apart = 10.0f64.powf(-1.0 - 3.0 * rng.unit());
    let at = |to: [f64; 3], s: f64| {
        sheet.point(triangle, std::array::from_fn(|k| from[k] + s * (to[k] - from[k])))
    };
    let [a, b] = [0.0, apart].map(|s| at(towards, s));
    let direction = (b - a).normalize_or(DVec3::X);
    let depth = sheet.size();
    let normal = (at(towards, 1e-7) - a).cross(at(inside(rng), 1e-7) - a).normalize_or_zero();
    let crosses = normal.dot(direction).abs() > 1e-4;
    Ray { origin: a - depth * direction, direction, target: crosses.then_some(depth) }
}

/// A ray that touches the sheet at a point, or passes a little above or below.
fn tangent(sheet: &Sheet, triangle: u32, rng: &mut Rng) -> Ray {
    let (weights, towards) = (inside(rng), inside(rng));
    let at = |s: f64, to: [f64; 3]| -> DVec3 {
        sheet.point(triangle, std::array::from_fn(|k| weights[k] + s * (to[k] - weights[k])))
    };
    let point = at(0.0, towards);
    let along = (at(1e-6, towards) - at(-1e-6, towards)).normalize_or(DVec3::X);
    let other = (at(1e-6, inside(rng)) - point).normalize_or(DVec3::Y);
    let above = along.cross(other).normalize_or(DVec3::Y);
    let aside = rng.pick(&[0.0, 1e-14, 1e-11, 1e-8, 1e-5, 1e-3]) * (2.0 * rng.unit() - 1.0);
    Ray { origin: point - sheet.size() * along + aside * above, direction: along, target: None }
}
