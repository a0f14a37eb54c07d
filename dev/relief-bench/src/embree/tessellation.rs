//! A displaced mesh as triangles, two a texel.

use glam::{DVec2, DVec3};
use relief_core::HeightMap;
use relief_core::mesh::Mesh;

/// Weights that are less than 0 by rounding alone.
const ROUNDING: f64 = 1e-9;

/// Points and triangles, for programs that know nothing else.
pub struct Triangles {
    /// The points, in metres.
    pub points: Vec<[f32; 3]>,
    /// Three points each.
    pub corners: Vec<[u32; 3]>,
}

/// The displaced surface of a mesh that is one closed sheet of whole tiles, from (0, 0) on and joined at its
/// ends, with a point at the centre of every texel of every tile.
///
/// # Errors
///
/// When a texel lies on no triangle.
pub fn tessellated(mesh: &Mesh, map: &HeightMap, tiles: [u32; 2]) -> Result<Triangles, String> {
    let (columns, rows) = (tiles[0] * map.width(), tiles[1] * map.height());
    let side = DVec2::new(map.width().into(), map.height().into());
    let mut points = vec![[f32::NAN; 3]; columns as usize * rows as usize];
    for triangle in 0..mesh.triangles().len() as u32 {
        let corners = mesh.corners(triangle);
        let places = corners.map(|corner| corner.uv.as_dvec2() * side - 0.5);
        let [a, b, c] = places;
        let area = (b - a).perp_dot(c - a);
        let least = (a.min(b).min(c) - ROUNDING).ceil().max(DVec2::ZERO);
        let greatest = (a.max(b).max(c) + ROUNDING).floor();
        for j in least.y as u32..(greatest.y as u32 + 1).min(rows) {
            for i in least.x as u32..(greatest.x as u32 + 1).min(columns) {
                let at = DVec2::new(i.into(), j.into());
                let weights = [(b, c), (c, a), (a, b)].map(|(p, q)| (p - at).perp_dot(q - at) / area);
                if weights.into_iter().any(|weight| weight < -ROUNDING) {
                    continue;
                }
                let height = f64::from(map.texel(i.into(), j.into()));
                let metres = map.bias_m() + map.scale_m() * height;
                let point: DVec3 =
                    corners.into_iter().zip(weights).fold(DVec3::ZERO, |sum, (corner, weight)| {
                        sum + weight * (corner.position.as_dvec3() + metres * corner.normal.as_dvec3())
                    });
                points[j as usize * columns as usize + i as usize] = point.as_vec3().to_array();
            }
        }
    }
    if points.iter().any(|point| point[0].is_nan()) {
        return Err("a texel lies on no triangle of the mesh".to_owned());
    }
    let at = |i: u32, j: u32| j % rows * columns + i % columns;
    let quad = |k: u32| {
        let (i, j) = (k % columns, k / columns);
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)];
        [[a, c, b], [b, c, d]]
    };
    Ok(Triangles { points, corners: (0..columns * rows).flat_map(quad).collect() })
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec2;
    use relief_core::Wrap;
    use relief_core::mesh::torus;

    #[test]
    fn points_lie_on_the_displaced_torus() {
        let mesh = torus(64, 32).and_then(|mesh| mesh.tiled(Vec2::new(3.0, 2.0))).expect("a mesh");
        let map =
            HeightMap::from_fn(16, 8, Wrap::Repeat, |_, j| if j < 4 { 0.0 } else { 1.0 }).expect("a map");
        let map = map.with_displacement(0.05, -0.01).expect("lengths");
        let Triangles { points, corners } = tessellated(&mesh, &map, [3, 2]).expect("a closed sheet");
        assert_eq!((points.len(), corners.len()), (3 * 16 * 2 * 8, 2 * 3 * 16 * 2 * 8));
        for (number, [x, y, z]) in points.iter().enumerate() {
            let from_ring = (x.hypot(*z) - 0.35).hypot(*y);
            let expected = if number / 48 % 8 < 4 { 0.14 } else { 0.19 };
            assert!((from_ring - expected).abs() < 2e-3, "{number}: {from_ring}");
        }
        // All sides have two triangles.
        let mut sides = std::collections::HashMap::new();
        for [a, b, c] in corners {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                *sides.entry((from.min(to), from.max(to))).or_insert(0) += 1;
            }
        }
        assert!(sides.values().all(|count| *count == 2));
    }
}
