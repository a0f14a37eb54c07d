//! Distance of one mesh from another, by brute force.

use std::collections::HashMap;

use glam::{DVec2, DVec3};
use rayon::prelude::*;
use relief_core::HeightMap;
use relief_core::mesh::{BasePoint, Mesh};

/// A grid of boxes, each with the triangles that come near it, for distances by brute force.
struct Near {
    corners: Vec<[DVec3; 3]>,
    cells: HashMap<[i32; 3], Vec<u32>>,
    side: f64,
}

impl Near {
    fn new(corners: Vec<[DVec3; 3]>, side: f64) -> Self {
        let mut cells: HashMap<[i32; 3], Vec<u32>> = HashMap::new();
        for (triangle, [a, b, c]) in corners.iter().enumerate() {
            let [low, high] = [a.min(*b).min(*c) - side, a.max(*b).max(*c) + side]
                .map(|at| (at / side).floor().as_ivec3().to_array());
            for x in low[0]..=high[0] {
                for y in low[1]..=high[1] {
                    for z in low[2]..=high[2] {
                        cells.entry([x, y, z]).or_default().push(triangle as u32);
                    }
                }
            }
        }
        Self { corners, cells, side }
    }

    /// How far a point is from the nearest triangle, or infinite beyond a side of a box.
    fn distance(&self, point: DVec3) -> f64 {
        let cell = (point / self.side).floor().as_ivec3().to_array();
        let near = self.cells.get(&cell).map_or(&[][..], Vec::as_slice);
        let of = |&triangle: &u32| to_triangle(point, self.corners[triangle as usize]);
        near.iter().map(of).filter(|apart| *apart <= self.side).fold(f64::INFINITY, f64::min)
    }
}

/// The distance of a point from a triangle.
fn to_triangle(p: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let normal = (b - a).cross(c - a);
    let inside =
        [[a, b], [b, c], [c, a]].iter().all(|[from, to]| (*to - *from).cross(p - *from).dot(normal) >= 0.0);
    if inside && normal.length() > 0.0 {
        return (p - a).dot(normal).abs() / normal.length();
    }
    let to_side = |[from, to]: [DVec3; 2]| {
        let along = to - from;
        let part = ((p - from).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        (from + part * along - p).length()
    };
    [[a, b], [b, c], [c, a]].map(to_side).into_iter().fold(f64::INFINITY, f64::min)
}

/// The corners of all triangles of a mesh.
pub fn corners_of(mesh: &Mesh) -> Vec<[DVec3; 3]> {
    (0..mesh.triangles().len() as u32)
        .map(|triangle| mesh.corners(triangle).map(|corner| corner.position.as_dvec3()))
        .collect()
}

/// Distances in texels of a displaced simple mesh from the triangles of a detailed one, at places all over
/// its triangles. The mesh is displaced by a map and a constant in metres. Returns the sorted distances, and
/// the part of the texels whose distances are all within half a texel. The length of a texel is the mean over
/// the mesh.
pub fn apart(low: &Mesh, high: &[[DVec3; 3]], map: &HeightMap, move_m: f64) -> (Vec<f64>, f64) {
    let [width, height] = [map.width(), map.height()].map(f64::from);
    let (mut area_m2, mut texels) = (0.0, 0.0);
    for triangle in 0..low.triangles().len() as u32 {
        let corners = low.corners(triangle).map(BasePoint::from);
        let [ab, ac] = [1, 2].map(|k| corners[k].position - corners[0].position);
        let [ab_uv, ac_uv] = [1, 2].map(|k| corners[k].uv - corners[0].uv);
        area_m2 += 0.5 * ab.cross(ac).length();
        texels += 0.5 * ab_uv.perp_dot(ac_uv).abs() * width * height;
    }
    let texel_m = f64::sqrt(area_m2 / texels);
    let near = Near::new(high.to_vec(), texel_m);
    let mut bases = Vec::new();
    for triangle in 0..low.triangles().len() as u32 {
        let corners = low.corners(triangle).map(BasePoint::from);
        let [a, b, c] = corners.map(|corner| corner.uv * DVec2::new(width, height));
        let steps = ((b - a).length().max((c - a).length()) * 2.0).ceil() as u32;
        for i in 0..=steps {
            for j in 0..=steps - i {
                let [wb, wc] = [i, j].map(|k| f64::from(k) / f64::from(steps));
                let base = BasePoint::weighted(corners, [1.0 - wb - wc, wb, wc]);
                bases.push(base);
            }
        }
    }
    let distance = |base: &BasePoint| {
        let metres = map.displacement_m(map.height_at(base.uv.x, base.uv.y)) + move_m;
        near.distance(base.displaced(metres)) / texel_m
    };
    let mut all: Vec<f64> = bases.par_iter().map(distance).collect();
    let mut of_texel = HashMap::new();
    for (base, distance) in bases.iter().zip(&all) {
        let texel = (base.uv * DVec2::new(width, height)).floor().as_ivec2();
        let worst: &mut f64 = of_texel.entry(texel).or_insert(0.0);
        *worst = worst.max(*distance);
    }
    all.sort_by(f64::total_cmp);
    let within = of_texel.values().filter(|worst| **worst <= 0.5).count();
    (all, within as f64 / of_texel.len() as f64)
}
