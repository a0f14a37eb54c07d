//! Triangulation of faces of many corners.

use glam::{DVec2, DVec3};

/// Greatest number of corners of a face.
pub(super) const MAX_CORNERS: usize = 1 << 16;

/// Greatest number of corners of a face that is not convex: each ear that is cut off checks all
/// corners.
const MAX_CORNERS_OF_CONCAVE: usize = 1024;

/// Result of a triangulation.
pub(super) enum Triangulated {
    /// Triangles by indices of their corners, with the face's front.
    Triangles(Vec<[usize; 3]>),
    /// The face is not convex and has too many corners.
    TooComplex,
}

/// Cuts a face of at least three corners into triangles: a fan if it is convex, otherwise ear by
/// ear (Meisters 1975). Corners need not lie in one plane.
pub(super) fn triangulate(points: &[DVec3]) -> Triangulated {
    let flat = flattened(points);
    let mut left: Vec<usize> = (0..points.len()).collect();
    let is_convex = (0..left.len()).all(|at| turn(&flat, &left, at) >= 0.0);
    if is_convex {
        return Triangulated::Triangles((2..points.len()).map(|place| [0, place - 1, place]).collect());
    }
    if points.len() > MAX_CORNERS_OF_CONCAVE {
        return Triangulated::TooComplex;
    }
    let mut triangles = Vec::with_capacity(points.len().saturating_sub(2));
    while left.len() > 3 {
        // A face that intersects itself may have no ear: then any corner is cut off.
        let ear = (0..left.len()).find(|&at| is_ear(&flat, &left, at)).unwrap_or_default();
        triangles.push(around(&left, ear));
        left.remove(ear);
    }
    triangles.push([left[0], left[1], left[2]]);
    Triangulated::Triangles(triangles)
}

/// Projects the corners to the plane of the face, counter-clockwise seen from its front.
fn flattened(points: &[DVec3]) -> Vec<DVec2> {
    let next = |at: usize| points[(at + 1) % points.len()];
    // Newell's normal is also right for faces that are not convex or not quite plane.
    let normal = points
        .iter()
        .enumerate()
        .fold(DVec3::ZERO, |sum, (at, &point)| sum + (point - points[0]).cross(next(at) - points[0]));
    let (x, y) = normal.try_normalize().unwrap_or(DVec3::Z).any_orthonormal_pair();
    points.iter().map(|point| DVec2::new((point - points[0]).dot(x), (point - points[0]).dot(y))).collect()
}

/// Returns a remaining corner between its predecessor and its successor.
fn around(left: &[usize], at: usize) -> [usize; 3] {
    [left[(at + left.len() - 1) % left.len()], left[at], left[(at + 1) % left.len()]]
}

/// Twice the area of the triangle at a corner, negative where the face bends inward.
fn turn(flat: &[DVec2], left: &[usize], at: usize) -> f64 {
    area(around(left, at).map(|place| flat[place]))
}

fn area([a, b, c]: [DVec2; 3]) -> f64 {
    (b - a).perp_dot(c - b)
}

/// Whether the triangle at a corner lies inside the face and contains no other corner.
fn is_ear(flat: &[DVec2], left: &[usize], at: usize) -> bool {
    let corners = around(left, at);
    let [a, b, c] = corners.map(|place| flat[place]);
    if area([a, b, c]) <= 0.0 {
        return false;
    }
    let is_inside = |point: DVec2| {
        [[a, b, point], [b, c, point], [c, a, point]].into_iter().all(|side| area(side) >= 0.0)
            && point != a
            && point != b
            && point != c
    };
    !left.iter().any(|place| !corners.contains(place) && is_inside(flat[*place]))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Areas of the triangles of a face in the plane of `x` and `z`; its front looks up.
    fn areas(corners: &[[f64; 2]]) -> Vec<f64> {
        let points: Vec<DVec3> = corners.iter().map(|[x, z]| DVec3::new(*x, 0.0, *z)).collect();
        let Triangulated::Triangles(triangles) = triangulate(&points) else { return Vec::new() };
        let up = |[a, b, c]: [usize; 3]| 0.5 * (points[b] - points[a]).cross(points[c] - points[a]).y;
        triangles.into_iter().map(up).collect()
    }

    #[test]
    fn convex_and_other_faces_are_covered_once() {
        let square: &[[f64; 2]] = &[[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
        let arrow: &[[f64; 2]] = &[[0.0, 0.0], [1.0, 1.0], [0.0, 2.0], [3.0, 1.0]];
        let house: &[[f64; 2]] = &[[0.0, 0.0], [0.0, 2.0], [2.0, 2.0], [2.0, 0.0], [1.0, -1.0]];
        let comb: &[[f64; 2]] =
            &[[0.0, 0.0], [0.0, 3.0], [1.0, 1.0], [2.0, 3.0], [3.0, 1.0], [4.0, 3.0], [4.0, 0.0]];
        for (corners, expected) in [(square, 1.0), (arrow, 2.0), (house, 5.0), (comb, 8.0)] {
            let areas = areas(corners);
            assert_eq!(areas.len(), corners.len() - 2);
            assert!(areas.iter().all(|&area| area > 0.0), "{corners:?}: {areas:?}");
            assert!((areas.iter().sum::<f64>() - expected).abs() < 1e-12, "{corners:?}: {areas:?}");
        }
    }

    #[test]
    fn a_face_that_crosses_itself_ends() {
        let bow: Vec<[f64; 2]> =
            vec![[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0], [0.5, 3.0], [0.5, -3.0]];
        assert_eq!(areas(&bow).len(), 4);
        let nothing = vec![[0.0, 0.0]; 9];
        assert_eq!(areas(&nothing).len(), 7);
    }
}
