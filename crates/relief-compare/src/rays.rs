//! Rays on which methods are compared: view rays on a plane, the same for every method.

use std::f64::consts::TAU;

use relief_core::metrics::WAVE;
use relief_core::{HeightMap, Metric, Path, PathMetric};

use relief_core::rng::Rng;

/// Generates view rays through a map at `degrees` from the normal, from height 1 down to 0, at
/// random places and in random directions. `tile_m` is the size of a texture tile in metres. The
/// rays depend only on the seed, the angle, the tile and the map's scale.
pub fn view_paths(map: &HeightMap, tile_m: [f64; 2], degrees: f64, count: usize, seed: u64) -> Vec<Path> {
    let mut rng = Rng::new(seed);
    (0..count)
        .map(|_| {
            let direction = rng.between(0.0, TAU);
            view_path(map.scale_m(), tile_m, degrees, direction, [rng.unit(), rng.unit()])
        })
        .collect()
}

/// Generates a view ray with the given angle and direction in the tile, from the point `uv` at
/// height 1 down to 0.
fn view_path(scale_m: f64, tile_m: [f64; 2], degrees: f64, direction: f64, uv: [f64; 2]) -> Path {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    let (sin, cos) = direction.sin_cos();
    let path = Path {
        uv,
        duv: [sine * cos / tile_m[0], sine * sin / tile_m[1]],
        h: [1.0, -cosine / scale_m, 0.0],
        // The exit lies slightly below the floor, as in the surface stage.
        exit: scale_m / cosine * 1.000_001,
        base: 0.0,
        metric: PathMetric { uu: tile_m[0] * tile_m[0], uv: 0.0, vv: tile_m[1] * tile_m[1], scale_m },
    };
    // The ray is rounded as for a shader, since that ray is judged.
    Path::from(&relief_shaders::cpu::Path::from(&path))
}

/// Size in metres of a tile in the unit metric, along `u` and `v`.
pub const UNIT_TILE: [f64; 2] = Metric::UNIT.tile_m;

/// Columns and rows of the pictures of [`picture_paths`]: whole tiles of [`WAVE`].
pub const PICTURE: [usize; 2] = [20 * WAVE[0], 30 * WAVE[1]];

/// Number of directions from which these pictures are seen.
const DIRECTIONS: usize = 8;

/// Generates view rays of neighbouring pixels: orthographic pictures of the map at `degrees` from
/// the normal, seen from several sides, one below the other. A tile is one metre large. A pixel is
/// as wide and as high as a texel of the longer side, so its footprint is longer along the view.
pub fn picture_paths(map: &HeightMap, degrees: f64) -> Vec<Path> {
    let pixel = 1.0 / f64::from(map.width().max(map.height()));
    let stretched = pixel / degrees.to_radians().cos();
    let [columns, rows] = PICTURE;
    let mut paths = Vec::with_capacity(columns * rows * DIRECTIONS);
    for side in 0..DIRECTIONS {
        // The directions avoid the axes and the diagonals.
        let direction = (side as f64 + 0.3) / DIRECTIONS as f64 * TAU;
        let (sin, cos) = direction.sin_cos();
        for (row, column) in (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column))) {
            let (right, along) = (column as f64 * pixel, row as f64 * stretched);
            // Upper rows are farther away.
            let uv = [right * sin - along * cos, -right * cos - along * sin];
            let uv = uv.map(|place| place.rem_euclid(1.0));
            paths.push(view_path(map.scale_m(), UNIT_TILE, degrees, direction, uv));
        }
    }
    paths
}

#[cfg(test)]
mod tests {
    use relief_core::Wrap;

    use super::*;

    #[test]
    fn rays_go_from_the_top_to_the_floor_at_their_angle() {
        let map = HeightMap::from_fn(8, 8, Wrap::Repeat, |_, _| 0.5).expect("a valid map");
        let map = map.with_displacement(0.1, -0.1).expect("lengths");
        for degrees in [0.0, 30.0, 85.0] {
            for path in view_paths(&map, [2.0, 0.5], degrees, 100, 1) {
                let ([u0, v0, top], [u1, v1, floor]) = (path.at(0.0), path.at(path.exit));
                assert!(top == 1.0 && (-1e-4..=0.0).contains(&floor), "{top} {floor}");
                let along = (2.0 * (u1 - u0)).hypot(0.5 * (v1 - v0));
                assert!((along - 0.1 * degrees.to_radians().tan()).abs() < 1e-4, "{along} at {degrees}");
            }
        }
        let [a, b] = [1, 2].map(|seed| view_paths(&map, UNIT_TILE, 30.0, 1, seed)[0].uv);
        assert_ne!(a, b);
    }
}
