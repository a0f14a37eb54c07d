//! What is said of displaced meshes besides their cracks, and the ways in which they are stored.

use std::collections::BTreeMap;

use glam::{DVec3, Vec3};
use relief_core::mesh::{Mesh, cylinder, rectangle, sphere, square, torus};
use relief_core::{HeightMap, Wrap};
use relief_mesh::{Directions, Folds, INTERIORS, MeshSettings, Mesher, Seams, Stream, Streamed, Watch};

/// Moves everything by so many metres.
fn moved(by_m: f64) -> HeightMap {
    let map = HeightMap::from_fn(64, 32, Wrap::Repeat, |_, _| 1.0).expect("a map");
    map.with_displacement(0.0, by_m).expect("lengths")
}

fn hills(scale_m: f64) -> HeightMap {
    let height = |i: u32, j: u32| 0.5 + 0.25 * ((0.4 * i as f32).sin() + (0.3 * j as f32).cos());
    let map = HeightMap::from_fn(64, 32, Wrap::Repeat, height).expect("a map");
    map.with_displacement(scale_m, 0.0).expect("lengths")
}

fn streamed(mesher: &Mesher, size: f64) -> Streamed {
    let how = Stream { size, check: true, watch: Watch::NOBODY };
    mesher.stream(&how, |_| Ok::<(), ()>(())).expect("finite")
}

fn folds(base: &Mesh, map: &HeightMap, settings: &MeshSettings) -> Folds {
    streamed(&Mesher::new(base, map, settings).expect("a mesh"), 1.0).folds
}

#[test]
fn a_cylinder_turned_inside_out_is_folded_where_it_has_a_side() {
    let base = cylinder(24, 2).expect("a mesh");
    let upright = (0..base.triangles().len()).filter(|&at| {
        let corners = base.triangles()[at].map(|corner| base.vertices()[corner as usize]);
        corners.iter().all(|corner| corner.normal.y.abs() < 0.1)
    });
    let upright = upright.count() as u64;
    for directions in Directions::ALL {
        // Each side by itself, so that no corner is drawn down by the ends.
        let settings = MeshSettings {
            texels: 4,
            seams: Seams::Keep,
            directions: *directions,
            ..MeshSettings::default()
        };
        // Within its radius of half a metre nothing folds, beyond the axis all of its sides do.
        for by_m in [-0.4, 0.0, 0.3] {
            assert_eq!(folds(&base, &moved(by_m), &settings), Folds::default(), "{by_m}");
        }
        let turned = folds(&base, &moved(-0.8), &settings);
        assert_eq!(turned.base_triangles, upright, "{turned:?}");
        assert!(turned.triangles > turned.base_triangles && turned.first.len() == Folds::FIRST);
    }
}

#[test]
fn folds_are_those_that_brute_force_finds() {
    let base = torus(16, 12).expect("a mesh");
    let map = hills(0.5);
    for interior in INTERIORS.iter().filter(|interior| !interior.is_for_planes()) {
        let settings = MeshSettings { texels: 2, ..MeshSettings::default() };
        if relief_mesh::check_pair(settings.edges, interior).is_err() {
            continue;
        }
        let settings = MeshSettings { interior, ..settings };
        let mesher = Mesher::new(&base, &map, &settings).expect("a mesh");
        let found = streamed(&mesher, 1.0).folds;
        // The directions of a torus point away from the circle in its middle: those of the base, interpolated
        // over its flat triangles, are near enough to tell what is far from either.
        let mesh = mesher.mesh().expect("finite");
        let [mut certain, mut possible] = [0, 0];
        for corners in mesh.triangles() {
            let corners = corners.map(|corner| mesh.vertices()[corner as usize]);
            let [a, b, c] = corners.map(|corner| corner.position.as_dvec3());
            let along: DVec3 = corners.iter().map(|corner| direction(&base, corner.uv.into())).sum();
            let cosine = (b - a).cross(c - a).normalize_or_zero().dot(along.normalize());
            certain += u64::from(cosine < -0.2);
            possible += u64::from(cosine < 0.2);
        }
        println!("{}: {certain} to {possible}, {}", interior.name, found.triangles);
        assert!(certain > 50 && (certain..=possible).contains(&found.triangles), "{found:?}");
        let of_base = found.first.iter().map(|base| base.pieces).sum::<u64>();
        assert!(found.first.len() == Folds::FIRST && of_base <= found.triangles);
        assert!(found.first.windows(2).all(|pair| pair[0].triangle < pair[1].triangle));
        for folded in &found.first {
            let corners = base.triangles()[folded.triangle as usize];
            let sum: Vec3 = corners.map(|corner| base.vertices()[corner as usize].position).iter().sum();
            assert!(folded.middle_m.distance(sum.as_dvec3() / 3.0) < 1e-6);
        }
        // Places are those of the mesh that is written.
        let larger = streamed(&mesher, 3.0).folds;
        assert_eq!(larger.first[0].middle_m, found.first[0].middle_m * 3.0);
        assert_eq!((larger.triangles, larger.base_triangles), (found.triangles, found.base_triangles));
    }
}

/// The normal of a base at texture coordinates.
fn direction(base: &Mesh, uv: [f32; 2]) -> DVec3 {
    let mut best = (f32::INFINITY, DVec3::ZERO);
    for vertex in base.vertices() {
        let distance = (vertex.uv.x - uv[0]).abs() + (vertex.uv.y - uv[1]).abs();
        if distance < best.0 {
            best = (distance, vertex.normal.as_dvec3());
        }
    }
    best.1
}

#[test]
fn what_moves_along_one_direction_does_not_fold() {
    let settings = MeshSettings { texels: 1, ..MeshSettings::default() };
    for base in [square(1), square(3), rectangle([1.0, 0.2], 2)] {
        assert_eq!(folds(&base.expect("a mesh"), &hills(30.0), &settings), Folds::default());
    }
    assert_eq!(folds(&square(1).expect("a mesh"), &hills(3.0), &MeshSettings::within(0.1)), Folds::default());
    // A ball that is only made larger does not, either.
    assert_eq!(folds(&sphere(32, 16).expect("a mesh"), &hills(0.05), &settings), Folds::default());
}

#[test]
fn folds_do_not_depend_on_threads_or_blocks() {
    let base = torus(6, 4).expect("a mesh").tiled([40.0, 20.0].into()).expect("tiled");
    // A few large triangles are cut apart into several blocks.
    let mesher = Mesher::new(&base, &hills(0.6), &MeshSettings::default()).expect("a mesh");
    let found = streamed(&mesher, 1.0).folds;
    assert!(mesher.triangles() > 200_000 && found.base_triangles <= 48, "{found:?}");
    let by_base: BTreeMap<u32, u64> = found.first.iter().map(|base| (base.triangle, base.pieces)).collect();
    assert_eq!(by_base.len(), found.first.len());
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool");
    assert_eq!(pool.install(|| streamed(&mesher, 1.0)).folds, found);
}
