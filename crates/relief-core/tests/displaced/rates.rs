//! Cost of a ray.

use std::time::Instant;

use relief_core::exact::{DisplacedMesh, Sides};
use relief_core::mesh::torus;
use relief_core::{HeightMap, Wrap};

use relief_core::rng::Rng;

/// Round stones of several sizes in random order.
fn cobbles(side: u32) -> HeightMap {
    let mut rng = Rng::new(1);
    let stones: Vec<[f32; 3]> =
        (0..150).map(|_| [rng.unit() as f32, rng.unit() as f32, 0.04 + 0.05 * rng.unit() as f32]).collect();
    let texel = |i: u32, j: u32| {
        let [x, y] = [i, j].map(|k| (k as f32 + 0.5) / side as f32);
        let height = |[sx, sy, radius]: &[f32; 3]| {
            let apart = |a: f32, b: f32| (a - b).abs().min(1.0 - (a - b).abs());
            let far = (apart(x, *sx).powi(2) + apart(y, *sy).powi(2)) / (radius * radius);
            (1.0 - far).max(0.0).sqrt() * radius / 0.09
        };
        stones.iter().map(height).fold(0.0, f32::max)
    };
    HeightMap::from_fn(side, side, Wrap::Repeat, texel).expect("a valid map")
}

#[test]
#[ignore = "measures time, to be read with --nocapture"]
fn rates() {
    for (around, tube) in [(16, 8), (32, 16), (128, 64)] {
        let mesh = torus(around, tube).expect("a mesh");
        let judge = DisplacedMesh::new(&mesh, &cobbles(256), 0.03, 0.0).expect("a displaced mesh");
        let mut rng = Rng::new(2);
        let rays: Vec<[[f64; 3]; 2]> = (0..100_000)
            .map(|_| {
                let origin = 1.5 * rng.direction();
                let to = 0.45 * rng.unit() * rng.direction();
                [origin.to_array(), (to - origin).to_array()]
            })
            .collect();
        let start = Instant::now();
        let (mut nodes, mut hits, mut most) = (0, 0, 0);
        for [origin, direction] in &rays {
            let trace = judge.trace(*origin, *direction, Sides::Front);
            nodes += trace.nodes;
            most = most.max(trace.nodes);
            hits += usize::from(trace.hit.is_some());
        }
        let seconds = start.elapsed().as_secs_f64();
        let count = rays.len() as f64;
        let (rate, mean) = (count / seconds, nodes as f64 / count);
        println!("torus {around}x{tube}: {rate:.0} rays/s, {mean:.1} nodes a ray (most {most}), {hits} hits");
    }
}
