//! Interpolation of directions by angle: from end to end a direction turns at constant speed.
//!
//! Sources: Kuijk and Blake 1989, Faster Phong Shading via Angular Interpolation, for sides.
//! Between three directions the mean on the sphere of Buss and Fillmore 2001, Spherical Averages
//! (section 2). On a side both are the same.

use glam::DVec3;

/// Sine below which two directions count as equal or opposite, with no way between them.
const LEAST_SINE: f64 = 1e-12;

/// Greatest number of iterations of a mean. Each comes nearer by the square of the angles.
const TURNS: u32 = 64;

/// Returns the way from a unit direction to another on the sphere: a vector perpendicular to
/// `from`, as long as the angle (logarithmic map).
pub fn toward(from: DVec3, to: DVec3) -> DVec3 {
    let cosine = from.dot(to);
    let beside = to - from * cosine;
    let sine = beside.length();
    if sine < LEAST_SINE { DVec3::ZERO } else { beside * (sine.atan2(cosine) / sine) }
}

/// Returns the unit direction that a way on the sphere leads to (exponential map).
fn along(from: DVec3, way: DVec3) -> DVec3 {
    let angle = way.length();
    if angle == 0.0 {
        return from;
    }
    (from * angle.cos() + way * (angle.sin() / angle)).normalize_or_zero()
}

/// Returns the unit direction between two others of any length, by their weights.
#[inline(never)]
pub fn between([a, b]: [DVec3; 2], [of_a, of_b]: [f64; 2]) -> DVec3 {
    let [a, b] = [a, b].map(DVec3::normalize_or_zero);
    along(a, toward(a, b) * (of_b / (of_a + of_b)))
}

/// Returns the unit direction between three others of any length, by weights whose sum is 1. The
/// weighted ways from it to the three cancel out.
#[inline(never)]
pub fn mean(corners: [DVec3; 3], weights: [f64; 3]) -> DVec3 {
    let corners = corners.map(DVec3::normalize_or_zero);
    let sum = |of: [DVec3; 3]| of[0] * weights[0] + of[1] * weights[1] + of[2] * weights[2];
    let mut at = sum(corners).normalize_or_zero();
    for _ in 0..TURNS {
        let way = sum(corners.map(|corner| toward(at, corner)));
        at = along(at, way);
        if way.length_squared() < LEAST_SINE * LEAST_SINE {
            break;
        }
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corners() -> [DVec3; 3] {
        [DVec3::new(0.1, 1.0, 0.0), DVec3::new(1.4, 1.0, 0.3), DVec3::new(0.2, 0.6, -0.9)]
    }

    #[test]
    fn sides_turn_evenly() {
        let [a, b, _] = corners();
        let whole = a.angle_between(b);
        for k in 0..=8 {
            let part = f64::from(k) / 8.0;
            let at = between([a, b], [3.0 * (1.0 - part), 3.0 * part]);
            assert!((at.length() - 1.0).abs() < 1e-15);
            assert!((at.angle_between(a) - part * whole).abs() < 1e-7, "{part}");
            assert!((at.angle_between(b) - (1.0 - part) * whole).abs() < 1e-7, "{part}");
        }
    }

    #[test]
    fn means_meet_the_sides_and_ways_to_the_corners_cancel_out() {
        let all = corners();
        for k in 0..3 {
            let mut weights = [0.0; 3];
            (weights[k], weights[(k + 1) % 3]) = (0.3, 0.7);
            let on_side = between([all[k], all[(k + 1) % 3]], [0.3, 0.7]);
            assert!(mean(all, weights).distance(on_side) < 1e-12);
        }
        let weights = [0.2, 0.5, 0.3];
        let at = mean(all, weights);
        let ways = all.map(|corner| toward(at, corner.normalize()));
        let sum = ways[0] * weights[0] + ways[1] * weights[1] + ways[2] * weights[2];
        assert!(sum.length() < 1e-12 && (at.length() - 1.0).abs() < 1e-15);
    }

    #[test]
    fn what_has_no_way_between_stays_finite() {
        assert_eq!(between([DVec3::X, DVec3::NEG_X], [0.5, 0.5]), DVec3::X);
        assert_eq!(mean([DVec3::ZERO; 3], [0.2, 0.3, 0.5]), DVec3::ZERO);
        assert!(mean([DVec3::X, DVec3::NEG_X, DVec3::Y], [0.4, 0.4, 0.2]).is_finite());
        assert_eq!(mean([DVec3::Z; 3], [0.2, 0.3, 0.5]), DVec3::Z);
    }
}
