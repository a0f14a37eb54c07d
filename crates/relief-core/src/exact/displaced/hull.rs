//! Tests whether the ray misses the convex hull of some points of ray space.

use glam::{DVec2, DVec3, Vec3Swizzles};

/// Lateral unit direction along which all points may lie ahead of the ray: the middle of the wedge
/// that they fill, seen from the ray. It is useless if they fill half a turn or more.
fn middle(points: impl Iterator<Item = DVec2>) -> Option<DVec2> {
    let mut wedge: Option<[DVec2; 2]> = None;
    for point in points {
        let [right, left] = *wedge.get_or_insert([point, point]);
        if right.perp_dot(point) < 0.0 {
            wedge = Some([point, left]);
        } else if left.perp_dot(point) > 0.0 {
            wedge = Some([right, point]);
        }
    }
    let [right, left] = wedge?;
    (right.try_normalize()? + left.try_normalize()?).try_normalize()
}

/// Least distance of the points ahead of the ray along a lateral direction.
fn ahead(points: impl Iterator<Item = DVec3>, direction: DVec2) -> f64 {
    points.map(|point| point.xy().dot(direction)).fold(f64::INFINITY, f64::min)
}

/// Whether the ray passes the hull of the points at more than `margin` metres.
///
/// `true` is certain up to the rounding of a dot product, because there is a line that separates
/// the ray from all points. `false` is certain except for hulls that the ray passes at little more
/// than the margin.
pub(super) fn is_missed(points: impl Iterator<Item = DVec3> + Clone, margin: f64) -> bool {
    let (least, greatest) = lateral_box(points.clone());
    if least.x > margin || least.y > margin || greatest.x < -margin || greatest.y < -margin {
        return true;
    }
    middle(points.clone().map(DVec3::xy)).is_some_and(|direction| ahead(points, direction) > margin)
}

/// Lower bound of the lateral distance between the ray and the hull of the points; 0 if the ray may
/// go through. It is exact in the limit of a small hull.
pub(super) fn least_distance(points: impl Iterator<Item = DVec3> + Clone) -> f64 {
    let (least, greatest) = lateral_box(points.clone());
    let boxed = least.max(-greatest).max(DVec2::ZERO).length();
    let nearest =
        points.clone().map(DVec3::xy).min_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
    let directions = [nearest.and_then(DVec2::try_normalize), middle(points.clone().map(DVec3::xy))];
    directions.into_iter().flatten().map(|direction| ahead(points.clone(), direction)).fold(boxed, f64::max)
}

/// Returns a lower bound of the depth at which the ray enters the hull of the points. Also returns
/// the rounding of that bound if the points are rounded by `error`. Both are in metres.
///
/// For any lateral `a` the least `z + a · (x, y)` of the points is a lower bound, because on the
/// ray it equals `z`. Here `a` makes the plane fitted to the points level. If the points lie in one
/// line, as seen along the ray, the shortest such `a` is used. This separates parts of a sheet that
/// meet the ray at one depth from earlier ones, however far they extend towards its origin.
pub(super) fn entry_depth(points: impl Iterator<Item = DVec3> + Clone, error: f64) -> [f64; 2] {
    let (count, sum) =
        points.clone().fold((0.0, DVec3::ZERO), |(count, sum), point| (count + 1.0, sum + point));
    let mean = sum / count;
    let (mut xx, mut xy, mut yy, mut z) = (0.0, 0.0, 0.0, DVec2::ZERO);
    for point in points.clone() {
        let off = point - mean;
        (xx, xy, yy) = (xx + off.x * off.x, xy + off.x * off.y, yy + off.y * off.y);
        z += off.z * off.xy();
    }
    // Directions in which the points are spread most and least, and the amounts.
    let wide = DVec2::from_angle(0.5 * (2.0 * xy).atan2(xx - yy));
    let half = 0.5 * (xx - yy).hypot(2.0 * xy);
    let (most, least) = (0.5 * (xx + yy) + half, 0.5 * (xx + yy) - half);
    let mut tilt = DVec2::ZERO;
    if most > 0.0 {
        tilt -= wide * (z.dot(wide) / most);
    }
    if least > FLAT * most {
        tilt -= wide.perp() * (z.dot(wide.perp()) / least);
    }
    let level = points.map(|point| point.z + tilt.dot(point.xy())).fold(f64::INFINITY, f64::min);
    [level, error * (1.0 + tilt.length())]
}

/// Ratio of squared spreads below which points count as lying in one line.
const FLAT: f64 = 1e-12;

fn lateral_box(points: impl Iterator<Item = DVec3>) -> (DVec2, DVec2) {
    let empty = (DVec2::INFINITY, DVec2::NEG_INFINITY);
    points.fold(empty, |(least, greatest), point| (least.min(point.xy()), greatest.max(point.xy())))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turned(points: &[[f64; 2]], angle: f64) -> Vec<DVec3> {
        let turn = DVec2::from_angle(angle);
        points.iter().map(|&point| turn.rotate(point.into()).extend(7.0)).collect()
    }

    #[test]
    fn hulls_beside_the_ray_are_missed_and_those_around_it_are_not() {
        // Two misses: a triangle whose box holds the ray at most angles, and a flat wedge of nearly
        // half a turn.
        let beside = [
            vec![[0.1, 3.0], [0.1, -3.0], [2.0, 0.0]],
            vec![[0.01, 9.0], [0.01, -9.0], [0.02, 0.0]],
            vec![[1.0, 1.0]],
            vec![[1.0, 1.0], [2.0, 2.0]],
        ];
        let around = [
            vec![[-0.1, 3.0], [-0.1, -3.0], [2.0, 0.0]],
            vec![[1.0, 1.0], [-1.0, -1.0]],
            vec![[0.0, 0.0]],
            vec![[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]],
        ];
        for step in 0..100 {
            let angle = f64::from(step) * 0.0634;
            for points in &beside {
                let points = turned(points, angle);
                assert!(is_missed(points.iter().copied(), 1e-3), "{points:?}");
                assert!(!is_missed(points.iter().copied(), 10.0), "{points:?}");
                assert!(least_distance(points.iter().copied()) > 0.0);
            }
            for points in &around {
                let points = turned(points, angle);
                assert!(!is_missed(points.iter().copied(), 1e-12), "{points:?}");
                assert!(least_distance(points.iter().copied()) < 1e-12);
            }
        }
    }

    #[test]
    fn depths_are_where_the_ray_enters() {
        let sloping = |x: f64, y: f64| DVec3::new(x, y, 5.0 + 3.0 * x - 20.0 * y);
        let plane = [sloping(-1.0, -1.0), sloping(2.0, 0.0), sloping(0.5, 3.0), sloping(-1.0, 1.0)];
        assert!((entry_depth(plane.into_iter(), 0.0)[0] - 5.0).abs() < 1e-9);
        let line = [-1.0, 0.3, 2.0].map(|s| DVec3::new(s, -2.0 * s, 4.0 - 7.0 * s));
        assert!((entry_depth(line.into_iter(), 0.0)[0] - 4.0).abs() < 1e-9);
        let along = [-1.0, 0.3, 2.0].map(|s| DVec3::new(0.0, 0.0, 4.0 + s));
        assert_eq!(entry_depth(along.into_iter(), 0.5), [3.0, 0.5]);
        assert_eq!(entry_depth([DVec3::Z].into_iter(), 0.5), [1.0, 0.5]);
        // The ray enters this solid below the plane, at some depth of the lowest side.
        let solid = [sloping(-1.0, -1.0), sloping(2.0, 0.0), sloping(-0.5, 3.0), DVec3::new(0.1, 0.0, 2.0)];
        assert!(entry_depth(solid.into_iter(), 0.0)[0] < 5.0);
    }

    #[test]
    fn distances_are_those_of_the_nearest_corner_or_side() {
        let corner = turned(&[[1.0, 0.0], [2.0, 1.0], [2.0, -1.0]], 0.7);
        assert!((least_distance(corner.iter().copied()) - 1.0).abs() < 1e-12);
        let side = turned(&[[0.5, 1.0], [0.5, -1.0]], 0.7);
        assert!((least_distance(side.iter().copied()) - 0.5).abs() < 1e-12);
    }
}
