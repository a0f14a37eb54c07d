//! Distance between a point and a triangle.

use glam::DVec3;

/// Square of the distance from a point to a triangle, which may be degenerate.
///
/// Regions of the plane by barycentric signs: Ericson, *Real-Time Collision Detection* (2005),
/// section 5.1.5.
pub(super) fn squared_distance(p: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return ap.length_squared();
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return bp.length_squared();
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return to_segment(p, a, b);
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return cp.length_squared();
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return to_segment(p, a, c);
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        return to_segment(p, b, c);
    }
    let sum = va + vb + vc;
    if sum > 0.0 {
        let at = a + ab * (vb / sum) + ac * (vc / sum);
        return p.distance_squared(at);
    }
    to_segment(p, a, b).min(to_segment(p, b, c)).min(to_segment(p, c, a))
}

fn to_segment(p: DVec3, a: DVec3, b: DVec3) -> f64 {
    let along = b - a;
    let length = along.length_squared();
    let part = if length > 0.0 { ((p - a).dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
    p.distance_squared(a + along * part)
}

#[cfg(test)]
mod tests {
    use relief_core::rng::Rng;

    use super::*;

    /// No point of a fine sampling of the triangle is nearer, and one is about as near.
    #[test]
    fn the_distance_is_the_nearest_points() {
        let mut rng = Rng::new(3);
        let mut point = || DVec3::from_array([rng.unit(), rng.unit(), rng.unit()]);
        for round in 0..300 {
            let (p, mut corners) = (2.0 * point() - 0.5, [point(), point(), point()]);
            if round % 10 == 0 {
                corners[2] = corners[0].midpoint(corners[1]);
            }
            if round % 30 == 0 {
                corners = [corners[0]; 3];
            }
            let [a, b, c] = corners;
            let mut nearest = f64::INFINITY;
            for i in 0..=100 {
                for j in 0..=100 - i {
                    let at = a + (b - a) * (f64::from(i) / 100.0) + (c - a) * (f64::from(j) / 100.0);
                    nearest = nearest.min(p.distance(at));
                }
            }
            let found = squared_distance(p, corners).sqrt();
            assert!(found <= nearest + 1e-12 && found >= nearest - 0.02, "{round}: {found} {nearest}");
        }
    }
}
