//! Points of a mesh with rays, for functions of exports.

use relief_core::rng::Rng;

use super::Point;

/// Points with rays from upright to grazing, over a flat mesh.
pub fn points(count: usize, tile: [f32; 2], seed: u64) -> Vec<Point> {
    let mut rng = Rng::new(seed);
    let point = |_| {
        let (turn, down) = (rng.between(0.0, std::f64::consts::TAU), rng.between(0.15, 1.0));
        let flat = (1.0 - down * down).sqrt();
        let view = [flat * turn.cos(), flat * turn.sin(), -down].map(|x| x as f32);
        let up = rng.between(0.2, 1.0);
        let aside = (1.0 - up * up).sqrt();
        let around = rng.between(0.0, std::f64::consts::TAU);
        Point {
            uv: [rng.unit() as f32, rng.unit() as f32],
            view,
            tile,
            curvature: [0.0; 3],
            footprint: 0.0,
            toward: [aside * around.cos(), aside * around.sin(), up].map(|x| x as f32),
        }
    };
    (0..count).map(point).collect()
}
