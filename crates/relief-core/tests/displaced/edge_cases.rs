//! Invalid rays, triangles and lengths.

use glam::{Vec2, Vec3};
use relief_core::exact::{DisplacedMesh, DisplacedMeshError, DisplacedTrace, Sides};
use relief_core::mesh::{Mesh, Vertex, square, torus};
use relief_core::{HeightMap, Wrap};

use relief_core::rng::Rng;
use relief_testing::displaced::scenes::{self, Heights, map};
use relief_testing::displaced::{judge_of, rays_of};

fn noise() -> HeightMap {
    map(Heights::Noise, [16, 16], Wrap::Repeat)
}

fn displaced(mesh: &Mesh) -> DisplacedMesh {
    DisplacedMesh::new(mesh, &noise(), 0.1, -0.05).expect("a displaced mesh")
}

#[test]
fn what_is_no_ray_hits_nothing() {
    let judge = displaced(&torus(16, 8).expect("a mesh"));
    let (origin, down) = ([0.35, 1.0, 0.0], [0.0, -1.0, 0.0]);
    assert!(judge.first_hit(origin, down, Sides::Front).is_some());
    let nothing = DisplacedTrace { hit: None, nodes: 0 };
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e100] {
        for axis in 0..3 {
            let (mut from, mut along) = (origin, down);
            from[axis] = bad;
            along[axis] = bad;
            assert_eq!(judge.trace(from, down, Sides::Both), nothing);
            assert_eq!(judge.trace(origin, along, Sides::Both), nothing);
            assert_eq!(judge.clearance(from, down), f64::INFINITY);
        }
    }
    for tiny in [0.0, -0.0, 1e-100, f64::MIN_POSITIVE] {
        assert_eq!(judge.trace(origin, [0.0, -tiny, 0.0], Sides::Both), nothing);
    }
    assert_eq!(judge.trace_triangle(u32::MAX, origin, down, Sides::Both), nothing);
}

#[test]
fn far_origins_and_long_directions_hit_the_same_point() {
    let judge = displaced(&square(2).expect("a mesh"));
    let near = judge.first_hit([0.1, 1.0, 0.2], [0.0, -1.0, 0.0], Sides::Front).expect("a hit");
    for (height, speed) in [(1e3, 1e-80), (1e6, 1e80), (1e3, 1.0)] {
        let hit = judge.first_hit([0.1, height, 0.2], [0.0, -speed, 0.0], Sides::Front).expect("a hit");
        assert!((hit.position[1] - near.position[1]).abs() < 1e-12 * height);
        assert!((hit.t * speed - (height - near.position[1])).abs() < 1e-12 * height);
    }
}

#[test]
fn degenerate_triangles_harm_nothing() {
    let corner = |position: [f32; 3], normal: [f32; 3], uv: [f32; 2]| Vertex {
        position: position.into(),
        normal: normal.into(),
        tangent: Vec3::X,
        bitangent: Vec3::Z,
        uv: uv.into(),
    };
    let up = [0.0, 1.0, 0.0];
    let vertices = vec![
        corner([0.0, 0.0, 0.0], up, [0.0, 0.0]),
        corner([0.0, 0.0, 1.0], up, [0.0, 1.0]),
        corner([1.0, 0.0, 1.0], up, [1.0, 1.0]),
        // The same positions as others, on their side, with the same texture coordinates, without a
        // normal.
        corner([0.0, 0.0, 0.0], up, [3.0, -2.0]),
        corner([0.0, 0.0, 0.5], up, [0.0, 0.5]),
        corner([1.0, 0.0, 0.0], up, [0.0, 0.0]),
        corner([1.0, 0.5, 0.0], [0.0; 3], [0.0, 0.0]),
        corner([0.5, 0.5, 1.0], [0.0; 3], [0.0, 0.0]),
        corner([0.5, 0.7, 0.2], [0.0, -1.0, 0.0], [1e3, -1e3]),
    ];
    let degenerate = vec![
        [0, 0, 0],
        [0, 3, 0],
        [0, 3, 3],
        [0, 1, 3],
        [0, 4, 1],
        [0, 5, 3],
        [0, 5, 6],
        [5, 6, 7],
        [6, 7, 6],
        [2, 6, 8],
        [8, 8, 8],
    ];
    let triangles: Vec<[u32; 3]> = [vec![[0, 1, 2]], degenerate].concat();
    let healthy = Mesh::new(vertices.clone(), vec![[0, 1, 2]]).expect("a mesh");
    let judges =
        [healthy, Mesh::new(vertices, triangles.clone()).expect("a mesh")].map(|mesh| displaced(&mesh));
    let mut rng = Rng::new(5);
    let mut hits = 0;
    for _ in 0..3_000 {
        // Half of the rays are aimed at corners, sides and lines of the cells.
        let round = |number: f64| (16.0 * number).round() / 16.0;
        let target =
            [rng.unit(), 0.0, rng.unit()].map(if rng.unit() < 0.5 { round } else { |number| number });
        let unit = rng.direction();
        let origin = [0, 1, 2].map(|k| target[k] - 2.0 * unit[k]);
        let [alone, all] =
            judges.each_ref().map(|judge| judge.trace(origin, unit.to_array(), Sides::Both).hit);
        if let Some(alone) = alone {
            assert!(all.is_some_and(|all| all.t <= alone.t + 1e-12));
        }
        for hit in all.iter().chain(&alone) {
            let numbers =
                [hit.t, hit.height].into_iter().chain(hit.weights).chain(hit.uv).chain(hit.position);
            assert!(numbers.into_iter().all(f64::is_finite), "{hit:?}");
            hits += 1;
        }
        for triangle in 1..triangles.len() as u32 {
            let trace = judges[1].trace_triangle(triangle, origin, unit.to_array(), Sides::Front);
            assert!(trace.nodes < 1_000_000, "triangle {triangle} takes {} nodes", trace.nodes);
        }
    }
    assert!(hits > 1_000);
}

#[test]
fn a_mesh_without_triangles_is_nowhere() {
    let judge = displaced(&Mesh::new(vec![], vec![]).expect("a mesh"));
    assert_eq!(judge.first_hit([0.0; 3], [1.0, 0.0, 0.0], Sides::Both), None);
    assert_eq!(judge.clearance([0.0; 3], [1.0, 0.0, 0.0]), f64::INFINITY);
}

#[test]
fn impossible_lengths_and_far_tiles_are_refused() {
    let mesh = square(1).expect("a mesh");
    for bad in [f64::NAN, f64::INFINITY, -2e9] {
        for [scale_m, bias_m] in [[bad, 0.0], [0.1, bad]] {
            let refused = DisplacedMesh::new(&mesh, &noise(), scale_m, bias_m);
            assert!(matches!(refused, Err(DisplacedMeshError::BadLength { .. })), "{bad}");
        }
    }
    let far = mesh.tiled(Vec2::new(1.0, 1e12)).expect("a mesh");
    let refused = DisplacedMesh::new(&far, &noise(), 0.1, 0.0);
    assert!(matches!(refused, Err(DisplacedMeshError::TooFar { triangle: 0, .. })));
}

#[test]
fn the_first_hit_is_the_first_of_all_triangles() {
    for scene in scenes::all() {
        let judge = judge_of(&scene.sheet);
        for ray in rays_of(&scene.sheet, 90) {
            let (origin, direction) = (ray.origin.to_array(), ray.direction.to_array());
            for sides in [Sides::Front, Sides::Both] {
                let of_one = |triangle| judge.trace_triangle(triangle, origin, direction, sides).hit;
                let each = (0..scene.sheet.triangles()).filter_map(of_one);
                let least = each.map(|hit| hit.t).min_by(f64::total_cmp);
                let trace = judge.trace(origin, direction, sides);
                // A hit on a side is found in either triangle, to rounding.
                let agrees = match (trace.hit, least) {
                    (Some(hit), Some(least)) => (hit.t - least).abs() <= 1e-9 * least,
                    (hit, least) => hit.is_none() && least.is_none(),
                };
                assert!(agrees, "{}: {:?}, {least:?}", scene.name, trace.hit);
                assert!(trace.nodes > 0);
            }
        }
    }
}

#[test]
fn sheets_that_are_a_line_take_no_longer() {
    // All corners, or two of them, coincide: the sheet is a part of a normal, or a curtain seen
    // edge-on.
    let corner = |x: f32, uv: [f32; 2]| Vertex {
        position: Vec3::new(x, 0.0, 0.0),
        normal: Vec3::Y,
        tangent: Vec3::X,
        bitangent: Vec3::Z,
        uv: uv.into(),
    };
    let uvs = [[0.0, 0.0], [3.0, -2.0], [1.0, 5.0]];
    let [smooth, level] = [Heights::Smooth, Heights::Constant].map(|of| map(of, [16, 16], Wrap::Repeat));
    let maps = [noise(), smooth, level];
    let mut grazing = 0;
    for places in [[0.0; 3], [0.0, 0.0, 1.0], [0.0, 0.5, 1.0]] {
        let vertices = [0, 1, 2].map(|k| corner(places[k], uvs[k])).to_vec();
        let mesh = Mesh::new(vertices, vec![[0, 1, 2]]).expect("a mesh");
        for map in &maps {
            let judge = DisplacedMesh::new(&mesh, map, 0.1, -0.05).expect("a displaced mesh");
            for height in [-0.03, 0.0, 0.01, 0.01 + 1e-9] {
                for (origin, direction) in [
                    ([-2.0, height, 0.0], [1.0, 0.0, 0.0]),
                    ([0.3, height, -2.0], [0.0, 0.0, 1.0]),
                    ([0.0, height, -2.0], [0.0, 0.0, 1.0]),
                    ([0.3, 2.0, 0.0], [0.0, -1.0, 0.0]),
                    ([0.0, 2.0, 0.0], [0.0, -1.0, 0.0]),
                    ([-2.0, height + 1.0, 0.0], [2.0, -1.0, 0.0]),
                ] {
                    for sides in [Sides::Front, Sides::Both] {
                        let trace = judge.trace(origin, direction, sides);
                        assert!(trace.nodes < 50_000, "{places:?} {origin:?}: {} nodes", trace.nodes);
                        assert!(trace.hit.is_none_or(|hit| hit.t.is_finite()));
                        grazing += usize::from(trace.hit.is_some_and(|hit| hit.grazing));
                    }
                }
            }
        }
    }
    assert!(grazing > 50, "{grazing}");
}
