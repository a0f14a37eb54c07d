//! Smooth bases and directions of displacement over a triangle, written down from their definitions alone.

use glam::DVec3;
use relief_core::mesh::Vertex;

/// The point of a curved point-normal triangle, by the coefficients of its ten Bernstein polynomials.
pub fn curved_point(vertices: &[Vertex; 3], w: [f64; 3]) -> DVec3 {
    let [p, n] = [0, 1].map(|of| {
        vertices.map(|vertex| if of == 0 { vertex.position.as_dvec3() } else { vertex.normal.as_dvec3() })
    });
    let mut point = (0..3).map(|i| p[i] * w[i].powi(3)).sum::<DVec3>();
    let mut edges = DVec3::ZERO;
    for i in 0..3 {
        for j in (0..3).filter(|&j| j != i) {
            let unit = n[i].normalize();
            let control = (2.0 * p[i] + p[j] - (p[j] - p[i]).dot(unit) * unit) / 3.0;
            point += 3.0 * control * w[i] * w[i] * w[j];
            edges += control / 6.0;
        }
    }
    let middle = (p[0] + p[1] + p[2]) / 3.0;
    point + 6.0 * (edges + (edges - middle) / 2.0) * w[0] * w[1] * w[2]
}

/// The metres that the smooth surface lies above a triangle which its normals promise: over each side half of
/// what the ends are apart, times what their normals are, times both weights.
pub fn lift_m(vertices: &[Vertex; 3], w: [f64; 3]) -> f64 {
    let of_side = |[i, j]: [usize; 2]| {
        let along = (vertices[i].position - vertices[j].position).as_dvec3();
        let turn = (vertices[i].normal - vertices[j].normal).as_dvec3();
        0.5 * along.dot(turn) * w[i] * w[j]
    };
    [[0, 1], [1, 2], [2, 0]].map(of_side).iter().sum()
}

/// The mean of unit directions on the sphere: along the sum of them, each weighted by its angle over the sine
/// of that, too.
pub fn mean_on_sphere(corners: [DVec3; 3], w: [f64; 3]) -> DVec3 {
    let mut mean = DVec3::ZERO;
    for _ in 0..200 {
        let weight = |k: usize| {
            let sine = mean.cross(corners[k]).length();
            let angle = sine.atan2(mean.dot(corners[k]));
            w[k] * if sine > 1e-9 && mean != DVec3::ZERO { angle / sine } else { 1.0 }
        };
        let sum: DVec3 = (0..3).map(|k| corners[k] * weight(k)).sum();
        mean = sum.normalize();
    }
    mean
}
