//! On a plane the tracer of displaced meshes equals a tracer of height fields.

use glam::Vec2;
use relief_core::exact::{DisplacedMesh, FastTracer, PyramidTracer, Sides};
use relief_core::mesh::{Mesh, Vertex, square};
use relief_core::{Path, PathMetric, Wrap};

use relief_core::rng::Rng;
use relief_testing::displaced::scenes::{Heights, map};

const RAYS: usize = 4_000;

/// Path of a ray above the unit square, up to its exit from the square, in the ray's parameter.
fn path(origin: [f64; 3], direction: [f64; 3], [scale_m, bias_m]: [f64; 2]) -> Path {
    let exit = |axis: usize| {
        let edge = 0.5f64.copysign(direction[axis]);
        (edge - origin[axis]) / direction[axis]
    };
    Path {
        uv: [origin[0] + 0.5, origin[2] + 0.5],
        duv: [direction[0], direction[2]],
        h: [(origin[1] - bias_m) / scale_m, direction[1] / scale_m, 0.0],
        exit: exit(0).min(exit(2)),
        base: 0.0,
        metric: PathMetric::unit(scale_m),
    }
}

#[test]
fn on_a_plane_the_tracers_of_height_fields_agree() {
    let [scale_m, bias_m] = [0.25, -0.05];
    let mut rng = Rng::new(11);
    for heights in [Heights::Noise, Heights::Spikes, Heights::Smooth, Heights::Constant] {
        for (size, wrap) in [([64, 64], Wrap::Repeat), ([37, 53], Wrap::Clamp), ([1, 31], Wrap::Mirror)] {
            let map = map(heights, size, wrap);
            let judge = DisplacedMesh::new(&square(4).expect("a mesh"), &map, scale_m, bias_m);
            let judge = judge.expect("a displaced mesh");
            let (fast, pyramid) = (FastTracer::new(&map), PyramidTracer::new(&map));
            let mut hits = 0;
            for _ in 0..RAYS {
                let origin = [rng.unit() - 0.5, 0.2001 + 0.2 * rng.unit(), rng.unit() - 0.5];
                let direction = [rng.unit() - 0.5, -0.4 * rng.unit(), rng.unit() - 0.5];
                let path = path(origin, direction, [scale_m, bias_m]);
                let hit = judge.first_hit(origin, direction, Sides::Front);
                for truth in [fast.trace(&path), pyramid.trace(&path)] {
                    // Rays that are nearly tangent, or that meet the outline, may hit or miss.
                    let delicate =
                        truth.hit.found && (truth.slope.abs() < 1e-3 || path.exit - truth.hit.t < 1e-9);
                    let found = hit.map(|hit| hit.t);
                    let agrees = match found {
                        Some(t) => truth.hit.found && (t - truth.hit.t).abs() < 1e-9,
                        None => !truth.hit.found,
                    };
                    assert!(agrees || delicate, "{heights:?} {size:?} {wrap}: {found:?}, {truth:?}");
                }
                hits += usize::from(hit.is_some());
            }
            assert!(hits > RAYS / 4, "{heights:?}: {hits}");
        }
    }
}

#[test]
fn tiles_far_from_the_origin_of_the_texture_are_as_exact() {
    let near = square(1).expect("a mesh");
    let shifted =
        near.vertices().iter().map(|vertex| Vertex { uv: vertex.uv + Vec2::new(1e5, -6e4), ..*vertex });
    let far = Mesh::new(shifted.collect(), near.triangles().to_vec()).expect("a mesh");
    let map = map(Heights::Noise, [37, 53], Wrap::Repeat);
    let judges = [near, far].map(|mesh| DisplacedMesh::new(&mesh, &map, 0.2, 0.0).expect("a displaced mesh"));
    let mut rng = Rng::new(12);
    for _ in 0..2_000 {
        let origin = [rng.unit() - 0.5, 0.5, rng.unit() - 0.5];
        let direction = [rng.unit() - 0.5, -0.5, rng.unit() - 0.5];
        let [a, b] = judges.each_ref().map(|judge| judge.first_hit(origin, direction, Sides::Front));
        match (a, b) {
            (Some(a), Some(b)) => assert!((a.t - b.t).abs() < 1e-11, "{a:?}, {b:?}"),
            _ => assert_eq!(a, b),
        }
    }
}
