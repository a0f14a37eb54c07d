//! Whether the ray misses the convex hull of some points of ray space.

use glam::{DVec2, DVec3, Vec3Swizzles};

/// A lateral unit direction along which all of the points may lie ahead of the ray: the middle of the wedge
/// that they fill, seen from the ray. Where they fill half a turn or more it is of no use.
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

/// How far the points are ahead of the ray in a lateral direction.
fn ahead(points: impl Iterator<Item = DVec3>, direction: DVec2) -> f64 {
    points.map(|point| point.xy().dot(direction)).fold(f64::INFINITY, f64::min)
}

/// Whether the ray passes the hull of the points at more than `margin` metres.
///
/// A yes is certain up to the rounding of a dot product, because it names a line that parts the ray from all
/// points. A no is certain but for hulls that the ray passes at little more than the margin.
pub(super) fn is_missed(points: impl Iterator<Item = DVec3> + Clone, margin: f64) -> bool {
    let (least, greatest) = lateral_box(points.clone());
    if least.x > margin || least.y > margin || greatest.x < -margin || greatest.y < -margin {
        return true;
    }
    middle(points.clone().map(DVec3::xy)).is_some_and(|direction| ahead(points, direction) > margin)
}

/// A lower bound of the lateral distance between the ray and the hull of the points, 0 where the ray may go
/// through. It is exact in the limit of a small hull.
pub(super) fn least_distance(points: impl Iterator<Item = DVec3> + Clone) -> f64 {
    let (least, greatest) = lateral_box(points.clone());
    let boxed = least.max(-greatest).max(DVec2::ZERO).length();
    let nearest =
        points.clone().map(DVec3::xy).min_by(|a, b| a.length_squared().total_cmp(&b.length_squared()));
    let directions = [nearest.and_then(DVec2::try_normalize), middle(points.clone().map(DVec3::xy))];
    directions.into_iter().flatten().map(|direction| ahead(points.clone(), direction)).fold(boxed, f64::max)
}

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
        // Beside: a triangle whose box holds the ray at most angles, and a flat wedge of nearly half a turn.
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
    fn distances_are_those_of_the_nearest_corner_or_side() {
        let corner = turned(&[[1.0, 0.0], [2.0, 1.0], [2.0, -1.0]], 0.7);
        assert!((least_distance(corner.iter().copied()) - 1.0).abs() < 1e-12);
        let side = turned(&[[0.5, 1.0], [0.5, -1.0]], 0.7);
        assert!((least_distance(side.iter().copied()) - 0.5).abs() < 1e-12);
    }
}
