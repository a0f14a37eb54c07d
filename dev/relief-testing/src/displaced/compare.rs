//! Judges a judge: every hit must lie on the sheet, and no crossing may be passed over.
//!
//! Why a flat triangle can prove a crossing of the sheet: seen along the ray, the sheet's part over the
//! triangle's weights is a continuous map to the plane that differs from the flat triangle by at most `e`.
//! Where the ray goes through the flat triangle further than `e` from its outline, the two maps wind around
//! the ray alike along the outline, once, so the sheet's part meets the ray, in the direction in which the
//! flat triangle does, no deeper than the triangle's farthest corner plus `e`.

use glam::{DMat3, DVec2, DVec3};
use relief_core::exact::{DisplacedHit, Side, Sides};

use super::rays::Ray;
use super::sheet::Sheet;
use super::tessellation::{Flat, Group};

/// How far from the sheet and the ray a hit may be, as a part of the size.
const ON_SHEET: f64 = 1e-11;

/// The same where ray and sheet are nearly tangent.
const ON_SHEET_GRAZING: f64 = 2e-9;

/// Fault of an answer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// A number of the hit does not belong to the others.
    Inconsistent,
    /// The hit is off the sheet or off the ray, by this distance in metres.
    NotOnSheet(f64),
    /// The sheet is certainly crossed before.
    Late {
        /// Metres from the origin within which it is.
        crossed: f64,
    },
    /// The hit is on a side that was not asked for, or on the other than it says.
    WrongSide,
    /// The ray was aimed at a point of the sheet and neither hits it nor anything before.
    LosesTarget {
        /// Metres to that point.
        target: f64,
    },
}

/// A crossing of the sheet that a flat triangle proves.
pub struct Crossing<'a> {
    /// Metres from the origin within which it is.
    pub far: f64,
    /// The side on which the sheet is crossed.
    pub side: Side,
    flat: &'a Flat,
}

/// Certain crossings along a ray; each is `far` metres from its origin or less.
pub fn crossings<'a>(groups: &'a [Group], ray: &Ray) -> Vec<Crossing<'a>> {
    let unit = ray.direction.normalize();
    let (across, along) = unit.any_orthonormal_pair();
    let turn = DMat3::from_cols(across, along, unit).transpose();
    let mirrored = turn.determinant() < 0.0;
    let mut found = Vec::new();
    for group in groups {
        let centre = turn * (group.centre - ray.origin);
        if centre.truncate().length() > group.radius || centre.z < -group.radius {
            continue;
        }
        found.extend(group.flats.iter().filter_map(|flat| crossing(flat, &turn, ray.origin, mirrored)));
    }
    found
}

fn crossing<'a>(flat: &'a Flat, turn: &DMat3, origin: DVec3, mirrored: bool) -> Option<Crossing<'a>> {
    let [a, b, c] = flat.points.map(|point| *turn * (point - origin));
    let depths = [a.z, b.z, c.z];
    let near = depths.iter().copied().fold(f64::INFINITY, f64::min) - flat.error;
    let far = depths.iter().copied().fold(f64::NEG_INFINITY, f64::max) + flat.error;
    let distances = [(a, b), (b, c), (c, a)].map(|(p, q)| {
        let (p, q) = (p.truncate(), q.truncate());
        (q - p).perp_dot(-p) / (q - p).length()
    });
    let counter_clockwise = distances.iter().all(|distance| *distance > flat.error);
    let clockwise = distances.iter().all(|distance| *distance < -flat.error);
    // Seen along the ray, what faces its origin runs clockwise.
    let side = if clockwise != mirrored { Side::Front } else { Side::Back };
    ((clockwise || counter_clockwise) && near >= 0.0).then_some(Crossing { far, side, flat })
}

/// Returns the fault of an answer, if it has one. Sides are `comparable` where no shell is folded.
pub fn fault(
    sheet: &Sheet,
    crossings: &[Crossing],
    ray: &Ray,
    sides: Sides,
    hit: Option<&DisplacedHit>,
    comparable: bool,
) -> Option<Fault> {
    let length = ray.direction.length();
    let size = sheet.size() + ray.origin.length();
    if let Some(hit) = hit {
        let off = match off_sheet(sheet, ray, hit) {
            Ok(off) => off,
            Err(fault) => return Some(fault),
        };
        let allowed = if hit.grazing { ON_SHEET_GRAZING } else { ON_SHEET };
        if off.is_nan() || off > allowed * size {
            return Some(Fault::NotOnSheet(off));
        }
        if sides == Sides::Front && hit.side == Side::Back {
            return Some(Fault::WrongSide);
        }
    }
    let depth = hit.map_or(f64::INFINITY, |hit| hit.t * length);
    let counts = |crossing: &&Crossing| sides == Sides::Both || (comparable && crossing.side == Side::Front);
    let crossed = crossings.iter().filter(counts).map(|crossing| crossing.far).fold(f64::INFINITY, f64::min);
    if depth > crossed + ON_SHEET * size {
        return Some(Fault::Late { crossed });
    }
    if let Some(hit) = hit.filter(|hit| comparable && !hit.grazing) {
        // In the flat triangle that holds the hit's weights there is no other crossing.
        if let Some(one) = crossings.iter().find(|crossing| holds(crossing.flat, hit))
            && one.side != hit.side
        {
            return Some(Fault::WrongSide);
        }
    }
    let loses = ray.target.filter(|target| sides == Sides::Both && depth > target + 1e-9 * size);
    loses.map(|target| Fault::LosesTarget { target })
}

/// Whether the weights of a hit belong to a point of a flat triangle.
fn holds(flat: &Flat, hit: &DisplacedHit) -> bool {
    let turn = |[a, b, c]: [[f64; 3]; 3]| {
        let [a, b, c] = [a, b, c].map(|w| DVec2::new(w[1], w[2]));
        (b - a).perp_dot(c - a)
    };
    let [a, b, c] = flat.weights;
    let parts = [[hit.weights, b, c], [a, hit.weights, c], [a, b, hit.weights]].map(turn);
    flat.triangle == hit.triangle && parts.iter().all(|part| part * turn(flat.weights) > 0.0)
}

/// How far the points that a hit names are from each other, in metres.
fn off_sheet(sheet: &Sheet, ray: &Ray, hit: &DisplacedHit) -> Result<f64, Fault> {
    let numbers = [hit.t, hit.height].into_iter().chain(hit.weights).chain(hit.uv).chain(hit.position);
    let total: f64 = hit.weights.iter().sum();
    let fits = numbers.into_iter().all(f64::is_finite)
        && hit.t >= 0.0
        && hit.triangle < sheet.triangles()
        && hit.weights.iter().all(|w| (-1e-12..=1.0 + 1e-12).contains(w))
        && (total - 1.0).abs() < 1e-12;
    if !fits {
        return Err(Fault::Inconsistent);
    }
    let uv = sheet.uv(hit.triangle, hit.weights);
    let height = sheet.height(hit.triangle, hit.weights);
    if (uv - DVec2::from(hit.uv)).length() > 1e-12 || (height - hit.height).abs() > 1e-11 {
        return Err(Fault::Inconsistent);
    }
    let point = sheet.point(hit.triangle, hit.weights);
    let on_ray = ray.origin + hit.t * ray.direction;
    Ok(point.distance(on_ray).max(point.distance(hit.position.into())))
}
