//! Meshes that are made to an error over bases that are no plane: no point of the relief is farther from them
//! than their bound, they have no crack, and the comparator that says so notices a vertex out of its place.

use std::sync::atomic::AtomicBool;

use glam::{DVec2, DVec3, Vec2, Vec3};
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;
use relief_core::mesh::{BasePoint, Mesh, Vertex, cube, cylinder, sphere, torus};
use relief_core::{HeightMap, Watch, Wrap};
use relief_mesh::{
    BaseSurface, Certificate, CrackTest, Directions, Fit, Judge, MeshSettings, Mesher, MesherError, Seams,
    Shading, Side,
};
use relief_testing::maps;
use relief_testing::smooth_base::{curved_point, lift_m};

/// Metres of displacement between heights 0 and 1.
const SCALE_M: f64 = 0.04;

/// What stored positions and texture coordinates may be wrong by, as a part of the scale.
const ROUNDING: f64 = 2e-5;

fn displaced(map: &HeightMap) -> HeightMap {
    map.clone().with_displacement(SCALE_M, -0.01).expect("lengths")
}

fn map(name: &str, wrap: Wrap) -> HeightMap {
    displaced(&maps::ALL.iter().find(|map| map.name == name).expect("it is listed").build(wrap))
}

fn made(base: &Mesh, map: &HeightMap, settings: &MeshSettings) -> (Mesh, Certificate) {
    let mesher = Mesher::new(base, map, settings).expect("a mesh");
    (mesher.mesh().expect("finite"), *mesher.certificate().expect("made to an error"))
}

/// The barycentric weights of texture coordinates in a triangle of them.
fn weights([a, b, c]: [DVec2; 3], at: DVec2) -> [f64; 3] {
    let area = (b - a).perp_dot(c - a);
    let [of_b, of_c] = [(at - a).perp_dot(c - a) / area, (b - a).perp_dot(at - a) / area];
    [1.0 - of_b - of_c, of_b, of_c]
}

/// The farthest that samples of the relief are from the mesh at the same base points, `n` along each side of
/// a triangle, and the sum of the triangles' areas in the texture. Charts must not overlap.
fn farthest(base: &Mesh, map: &HeightMap, mesh: &Mesh, n: u32) -> (f64, f64) {
    farthest_over(base, map, mesh, n, (BaseSurface::Flat, Directions::Raw))
}

/// The same over a smooth base, or along directions of length 1.
fn farthest_over(
    base: &Mesh,
    map: &HeightMap,
    mesh: &Mesh,
    n: u32,
    (smooth, directions): (BaseSurface, Directions),
) -> (f64, f64) {
    let bases: Vec<[Vertex; 3]> = (0..base.triangles().len() as u32)
        .map(|triangle| base.corners(triangle).map(|corner| *corner))
        .collect();
    let of_piece = |piece: u32| -> (f64, f64) {
        let corners = mesh.corners(piece);
        let uvs = corners.map(|corner| corner.uv.as_dvec2());
        let area = 0.5 * (uvs[1] - uvs[0]).perp_dot(uvs[2] - uvs[0]).abs();
        let middle = (uvs[0] + uvs[1] + uvs[2]) / 3.0;
        let inside = |base: &&[Vertex; 3]| {
            weights(base.map(|corner| corner.uv.as_dvec2()), middle).iter().all(|weight| *weight > -1e-6)
        };
        let base = bases.iter().find(inside).expect("a piece lies in a base triangle");
        let chart = base.map(|corner| corner.uv.as_dvec2());
        let mut farthest = 0.0_f64;
        for i in 0..=n {
            for j in 0..=n - i {
                let of = [i, j, n - i - j].map(|part| f64::from(part) / f64::from(n));
                let uv = uvs[0] * of[0] + uvs[1] * of[1] + uvs[2] * of[2];
                let there: DVec3 = (0..3).map(|k| corners[k].position.as_dvec3() * of[k]).sum();
                let at = weights(chart, uv);
                let mut point = BasePoint::weighted(base.map(|corner| (&corner).into()), at);
                let mut metres = map.displacement_m(map.height_at(uv.x, uv.y));
                match smooth {
                    BaseSurface::Flat => {}
                    BaseSurface::Lift => metres += lift_m(base, at),
                    BaseSurface::Pn => point.position = curved_point(base, at),
                }
                if directions == Directions::Unit {
                    point.normal = point.normal.normalize();
                }
                let relief = point.displaced(metres);
                farthest = farthest.max(relief.distance(there));
            }
        }
        (farthest, area)
    };
    let all: Vec<(f64, f64)> = (0..mesh.triangles().len() as u32).into_par_iter().map(of_piece).collect();
    let most = all.iter().map(|(farthest, _)| *farthest).fold(0.0, f64::max);
    (most, all.iter().map(|(_, area)| area).sum())
}

/// Bases whose normals are the same on all sides, and whose charts fill the texture. Bases with poles leave
/// out triangles.
fn smooth_bases() -> Vec<(&'static str, Mesh, f64)> {
    vec![
        ("torus", torus(12, 6).expect("a mesh"), 1.0),
        ("coarse torus", torus(3, 3).expect("a mesh"), 1.0),
        ("sphere", sphere(10, 6).expect("a mesh"), 1.0 - 1.0 / 6.0),
    ]
}

#[test]
fn no_sample_is_farther_than_the_bound() {
    let mut turn = 0;
    for (name, base, area) in smooth_bases() {
        for named in maps::ALL.iter().filter(|named| named.name != "white noise 128x128") {
            for wrap in Wrap::ALL {
                let map = displaced(&named.build(wrap));
                let error_m = [0.02, 0.05, 0.1][turn % 3] * SCALE_M;
                let fit = Fit::ALL[turn % 2];
                turn += 1;
                let settings = MeshSettings { fit, ..MeshSettings::within(error_m) };
                let (mesh, certificate) = made(&base, &map, &settings);
                let about = format!("{name}, {}, {wrap}, {fit}: {certificate:?}", named.name);
                assert!(certificate.error_m <= error_m, "{about}");
                let (found, covered) = farthest(&base, &map, &mesh, 6);
                let bound_m = certificate.error_m + certificate.seams_m + ROUNDING * SCALE_M;
                assert!(found <= bound_m, "{about}: {found}");
                assert!((covered - area).abs() < 1e-4, "{about}: {covered} of {area}");
                // The bound says something.
                assert!(found >= 0.3 * certificate.error_m, "{about}: {found}");
            }
        }
    }
}

#[test]
fn smooth_bases_and_unit_directions_keep_to_the_bound() {
    let mut turn = 0;
    for (name, base, area) in smooth_bases() {
        for (smooth, directions) in [
            (BaseSurface::Flat, Directions::Unit),
            (BaseSurface::Lift, Directions::Raw),
            (BaseSurface::Lift, Directions::Unit),
            (BaseSurface::Pn, Directions::Raw),
            (BaseSurface::Pn, Directions::Unit),
        ] {
            for (wrap, map_name) in [
                (Wrap::Repeat, "natural 101x67"),
                (Wrap::Mirror, "white noise 37x53"),
                (Wrap::Clamp, "single spike 33x31"),
            ] {
                let map = map(map_name, wrap);
                let error_m = [0.02, 0.05, 0.1][turn % 3] * SCALE_M;
                let fit = Fit::ALL[turn % 2];
                turn += 1;
                let within = MeshSettings::within(error_m);
                let settings = MeshSettings { fit, base: smooth, directions, ..within };
                let (mesh, certificate) = made(&base, &map, &settings);
                let about = format!("{name}, {map_name}, {smooth} {directions}, {fit}: {certificate:?}");
                assert!(certificate.error_m <= error_m, "{about}");
                let (found, covered) = farthest_over(&base, &map, &mesh, 6, (smooth, directions));
                let bound_m = certificate.error_m + certificate.seams_m + ROUNDING * SCALE_M;
                assert!(found <= bound_m, "{about}: {found}");
                assert!((covered - area).abs() < 1e-4, "{about}: {covered} of {area}");
                // The bound says something, and what is judged is not the flat base: hills are all over it.
                assert!(found >= 0.1 * certificate.error_m, "{about}: {found}");
                let (flat, _) = farthest(&base, &map, &mesh, 6);
                assert!(
                    flat > bound_m || map_name != "natural 101x67" || name == "sphere",
                    "{about}: {flat}"
                );
                println!("{about}: {} triangles, found {found}", mesh.triangles().len());
            }
        }
    }
}

/// The least and the greatest displacement at which lines along the direction of displacement, through
/// samples of the relief, cross the mesh, less the relief's own; how many samples there are, and how many of
/// them have no crossing. Crossings farther than `most_m` belong to something else.
fn crossings(base: &Mesh, map: &HeightMap, mesh: &Mesh, n: u32, most_m: f64) -> ([f64; 2], [usize; 2]) {
    let corners: Vec<[DVec3; 3]> = (0..mesh.triangles().len() as u32)
        .map(|triangle| mesh.corners(triangle).map(|corner| corner.position.as_dvec3()))
        .collect();
    // Pieces by the cells of a grid that their boxes touch.
    let reach_m = 0.05;
    let cell = |at: f64| (at / reach_m).floor() as i32;
    let mut grid: std::collections::HashMap<[i32; 3], Vec<u32>> = std::collections::HashMap::new();
    for (number, points) in corners.iter().enumerate() {
        let least = (points[0].min(points[1]).min(points[2]) - most_m).to_array().map(cell);
        let greatest = (points[0].max(points[1]).max(points[2]) + most_m).to_array().map(cell);
        for x in least[0]..=greatest[0] {
            for y in least[1]..=greatest[1] {
                for z in least[2]..=greatest[2] {
                    grid.entry([x, y, z]).or_default().push(number as u32);
                }
            }
        }
    }
    let of_base = |triangle: u32| -> ([f64; 2], [usize; 2]) {
        let base = base.corners(triangle).map(BasePoint::from);
        let (mut range, mut counts) = ([f64::INFINITY, f64::NEG_INFINITY], [0; 2]);
        for i in 0..n {
            for j in 0..n - i {
                // Inside of the triangle.
                let of = [i, j, n - 1 - i - j].map(|part| (f64::from(part) + 1.0 / 3.0) / f64::from(n));
                let point = BasePoint::weighted(base, of);
                let metres = map.displacement_m(map.height_at(point.uv.x, point.uv.y));
                let (origin, along) = (point.displaced(metres), point.normal);
                let near = grid.get(&origin.to_array().map(cell)).map_or(&[][..], Vec::as_slice);
                let crossed = near.iter().filter_map(|&piece| {
                    let [a, b, c] = corners[piece as usize];
                    let (ab, ac) = (b - a, c - a);
                    let across = along.cross(ac);
                    let scale = across.dot(ab);
                    let from = origin - a;
                    let of_b = from.dot(across) / scale;
                    let of_c = along.dot(from.cross(ab)) / scale;
                    let t = ac.dot(from.cross(ab)) / scale;
                    let is_in = of_b >= -1e-9 && of_c >= -1e-9 && of_b + of_c <= 1.0 + 1e-9;
                    (is_in && t.abs() <= most_m).then_some(t)
                });
                let crossed: Vec<f64> = crossed.collect();
                counts[0] += 1;
                counts[1] += usize::from(crossed.is_empty());
                range = crossed.into_iter().fold(range, |[low, high], t| [low.min(t), high.max(t)]);
            }
        }
        (range, counts)
    };
    let all: Vec<_> = (0..base.triangles().len() as u32).into_par_iter().map(of_base).collect();
    all.into_iter().fold(([f64::INFINITY, f64::NEG_INFINITY], [0; 2]), |(range, counts), (of, more)| {
        ([range[0].min(of[0]), range[1].max(of[1])], [counts[0] + more[0], counts[1] + more[1]])
    })
}

#[test]
fn on_one_side_nothing_of_the_relief_is_on_the_other() {
    let mut turn = 0;
    for (name, base, _) in smooth_bases() {
        if name == "coarse torus" {
            // It folds over.
            continue;
        }
        for (map_name, wrap) in [
            ("natural 101x67", Wrap::Repeat),
            ("white noise 37x53", Wrap::Repeat),
            ("single spike 33x31", Wrap::Repeat),
            ("steps 61x40", Wrap::Mirror),
        ] {
            // Seams fit where a map repeats itself along both sides.
            let map = map(map_name, wrap);
            for side in [Side::Above, Side::Below] {
                let error_m = [0.05, 0.1][turn % 2] * SCALE_M;
                let fit = Fit::ALL[turn / 2 % 2];
                turn += 1;
                let settings = MeshSettings { side, fit, ..MeshSettings::within(error_m) };
                let mesher = match Mesher::new(&base, &map, &settings) {
                    Err(MesherError::SideOfSeams { .. }) => {
                        println!("{name}, {map_name}: seams");
                        continue;
                    }
                    mesher => mesher.unwrap_or_else(|error| panic!("{name}, {map_name}, {side}: {error}")),
                };
                let mesh = mesher.mesh().expect("finite");
                let certificate = mesher.certificate().expect("made to an error");
                let about = format!("{name}, {map_name}, {side}, {fit}: {certificate:?}");
                assert!(certificate.error_m <= error_m, "{about}");
                let (found, _) = farthest(&base, &map, &mesh, 6);
                let rounding = ROUNDING * SCALE_M;
                assert!(found <= certificate.error_m + rounding, "{about}: {found}");
                let (range, [samples, missed]) = crossings(&base, &map, &mesh, 12, 3.0 * error_m);
                let [low, high] = if side == Side::Above { range } else { [-range[1], -range[0]] };
                println!("{about}: {} triangles, from {low} to {high}", mesh.triangles().len());
                assert!(low >= -rounding && high <= 3.0 * error_m, "{about}: {range:?}");
                assert!(missed * 1000 <= samples, "{about}: {missed} of {samples}");
                // A mesh on both sides is not on one, and the test would say so.
                let both = made(&base, &map, &MeshSettings { side: Side::Both, ..settings }).0;
                let (range, _) = crossings(&base, &map, &both, 12, 3.0 * error_m);
                assert!(range[0] < -0.1 * error_m && range[1] > 0.1 * error_m, "{about}: {range:?}");
            }
        }
    }
}

#[test]
fn smooth_bases_are_closed_where_they_are() {
    let bases = [cube(2), cylinder(16, 2), sphere(24, 12), torus(24, 10)];
    let mut turn = 0;
    for base in bases {
        let base = base.expect("a mesh");
        for named in maps::ALL.iter().filter(|named| named.name != "white noise 128x128") {
            let map = displaced(&named.build(Wrap::ALL[turn % 3]));
            let (smooth, directions) = (BaseSurface::ALL[turn % 3], Directions::ALL[turn / 3 % 2]);
            turn += 1;
            let within = MeshSettings::within(0.1 * SCALE_M);
            let (mesh, certificate) = made(&base, &map, &MeshSettings { base: smooth, directions, ..within });
            let cracks = CrackTest::of_mesh(&mesh);
            let about = format!("{}, {smooth} {directions}: {cracks:?}, {certificate:?}", named.name);
            assert!(cracks.is_closed() && cracks.pieces == 1, "{about}");
        }
    }
}

#[test]
fn a_vertex_out_of_its_place_is_noticed() {
    let (base, map) = (torus(12, 6).expect("a mesh"), map("natural 101x67", Wrap::Repeat));
    let error_m = 0.02 * SCALE_M;
    let (mesh, certificate) = made(&base, &map, &MeshSettings::within(error_m));
    assert!(certificate.seams_m <= ROUNDING * SCALE_M, "{certificate:?}");
    for moved in [0, mesh.vertices().len() / 2, mesh.vertices().len() - 1] {
        let mut vertices = mesh.vertices().to_vec();
        let up = vertices[moved].normal;
        vertices[moved].position += up * (2.0 * error_m) as f32;
        let wrong = Mesh::new(vertices, mesh.triangles().to_vec()).expect("a mesh");
        let (found, _) = farthest(&base, &map, &wrong, 4);
        assert!(found > error_m + ROUNDING * SCALE_M, "{moved}: {found}");
    }
}

#[test]
fn large_triangles_are_cut_first_and_nothing_moves() {
    // Sides of 350 texels and more.
    let texel = |i: u32, j: u32| 0.5 + 0.3 * (i as f32 * 0.05).sin() * (j as f32 * 0.031).cos();
    let large = displaced(&HeightMap::from_fn(1050, 700, Wrap::Repeat, texel).expect("a map"));
    for (name, base) in [("torus", torus(3, 3)), ("sphere", sphere(3, 2)), ("fine", torus(7, 5))] {
        let base = base.expect("a mesh");
        for (smooth, directions) in [
            (BaseSurface::Flat, Directions::Raw),
            (BaseSurface::Flat, Directions::Unit),
            (BaseSurface::Lift, Directions::Raw),
            (BaseSurface::Pn, Directions::Raw),
        ] {
            let error_m = 0.01 * SCALE_M;
            let within = MeshSettings::within(error_m);
            let (mesh, certificate) =
                made(&base, &large, &MeshSettings { base: smooth, directions, ..within });
            let about = format!("{name}, {smooth} {directions}: {certificate:?}");
            assert!(certificate.error_m <= error_m, "{about}");
            let (found, _) = farthest_over(&base, &large, &mesh, 6, (smooth, directions));
            let bound_m = certificate.error_m + certificate.seams_m + ROUNDING * SCALE_M;
            assert!(found <= bound_m, "{about}: {found}");
            assert!(CrackTest::of_mesh(&mesh).is_closed(), "{about}");
            let triangles = mesh.triangles().len();
            println!("{about}: {triangles} triangles");
            assert!(triangles < 1050 * 700 / 10, "{about}: {triangles}");
        }
    }
}

#[test]
fn triangles_over_very_many_texels_are_refused_before_they_are_cut() {
    // Rough texels, tens of thousands along a side.
    let map = HeightMap::from_fn(31, 11, Wrap::Repeat, |i, j| ((i * 7 + j * 13) % 17) as f32 / 16.0);
    let map = displaced(&map.expect("a map"));
    let base = torus(3, 3).and_then(|base| base.tiled(Vec2::new(6000.0, 30.0))).expect("a mesh");
    let settings = MeshSettings { max_bytes: 256 << 20, ..MeshSettings::within(0.01 * SCALE_M) };
    let few = Mesher::with_at_most(&base, &map, &settings, 5000, &Watch::none());
    assert!(matches!(few, Err(MesherError::MoreThan { most: 5000 })), "{:?}", few.err());
    let tight = MeshSettings { max_bytes: 16 << 20, ..settings };
    let much = Mesher::new(&base, &map, &tight);
    assert!(matches!(much, Err(MesherError::NoMemory { limit }) if limit == 16 << 20), "{:?}", much.err());
    let cancel = AtomicBool::new(true);
    let stopped = Watch::cancelled_by(&cancel);
    let stopped = Mesher::watched(&base, &map, &settings, &stopped);
    assert!(matches!(stopped, Err(MesherError::Cancelled(_))), "{:?}", stopped.err());
}

#[test]
fn meshes_are_closed_where_their_bases_are() {
    let bases = [cube(1), cube(3), cylinder(16, 2), sphere(24, 12), torus(24, 10)];
    let mut turn = 0;
    for base in bases {
        let base = base.expect("a mesh");
        for named in maps::ALL.iter().filter(|named| named.name != "white noise 128x128") {
            for wrap in Wrap::ALL {
                let map = displaced(&named.build(wrap));
                let error_m = [0.05, 0.3, 0.02][turn % 3] * SCALE_M;
                let settings = MeshSettings { judge: Judge::ALL[turn % 2], ..MeshSettings::within(error_m) };
                turn += 1;
                let (mesh, certificate) = made(&base, &map, &settings);
                let cracks = CrackTest::of_mesh(&mesh);
                let about = format!("{}, {wrap}: {cracks:?}, {certificate:?}", named.name);
                assert!(cracks.is_closed() && cracks.pieces == 1, "{about}");
            }
        }
    }
}

#[test]
fn spot_is_closed() {
    let Some(base) = relief_tests::spot("spot_triangulated.obj") else { return };
    let was = CrackTest::of_mesh(&base);
    for (name, error) in [("natural 128x128", 0.02), ("white noise 37x53", 0.1)] {
        let map = map(name, Wrap::Repeat);
        for fit in Fit::ALL {
            let settings = MeshSettings { fit: *fit, ..MeshSettings::within(error * SCALE_M) };
            let (mesh, certificate) = made(&base, &map, &settings);
            let cracks = CrackTest::of_mesh(&mesh);
            println!("spot, {name}, {fit}: {} triangles, {certificate:?}", mesh.triangles().len());
            assert_eq!((cracks.open, cracks.branching, cracks.pieces), (was.open, was.branching, was.pieces));
        }
    }
}

#[test]
fn kept_seams_gape_and_keep_the_bound() {
    let base = torus(12, 6).expect("a mesh");
    let map = map("white noise 37x53", Wrap::Clamp);
    let settings = MeshSettings { seams: Seams::Keep, ..MeshSettings::within(0.05 * SCALE_M) };
    let (mesh, certificate) = made(&base, &map, &settings);
    assert_eq!(certificate.seams_m, 0.0);
    let (found, _) = farthest(&base, &map, &mesh, 6);
    assert!(found <= certificate.error_m + ROUNDING * SCALE_M, "{found}");
    assert!(!CrackTest::of_mesh(&mesh).is_closed());
    let (_, welded) = made(&base, &map, &MeshSettings::within(0.05 * SCALE_M));
    assert!(welded.seams_m > 0.1 * SCALE_M, "{welded:?}");
}

#[test]
fn smooth_relief_needs_few_triangles() {
    let base = torus(48, 24).expect("a mesh");
    let level = displaced(&HeightMap::from_fn(200, 90, Wrap::Repeat, |_, _| 0.25).expect("a map"));
    let (mesh, certificate) = made(&base, &level, &MeshSettings::within(1e-4 * SCALE_M));
    assert_eq!(mesh.triangles().len(), base.triangles().len());
    assert!(certificate.error_m <= 1e-6 * SCALE_M, "{certificate:?}");
    let turns = |of: u32, all: u32| (of as f32 / all as f32) * std::f32::consts::TAU;
    let hills = |i: u32, j: u32| 0.5 + 0.25 * turns(2 * i, 800).sin() + 0.25 * turns(j, 400).cos();
    let hills = displaced(&HeightMap::from_fn(800, 400, Wrap::Repeat, hills).expect("a map"));
    let count = |fit: Fit, error: f64| {
        let settings = MeshSettings { fit, ..MeshSettings::within(error * SCALE_M) };
        made(&base, &hills, &settings).0.triangles().len()
    };
    let [fitted, plain, fine] = [(Fit::Heights, 0.005), (Fit::None, 0.005), (Fit::None, 0.0005)]
        .map(|(fit, error)| count(fit, error));
    println!("{fitted} fitted, {plain} not, {fine} to a tenth");
    assert!(fitted <= plain && plain < 800 * 400 / 20 && plain < fine, "{fitted} {plain} {fine}");
}

#[test]
fn so_many_triangles_are_used_and_no_more() {
    let (base, map) = (torus(12, 6).expect("a mesh"), map("natural 101x67", Wrap::Repeat));
    let settings = MeshSettings::within(f64::NAN);
    let mut before = f64::INFINITY;
    for most in [1000, 4000] {
        let mesher = Mesher::with_at_most(&base, &map, &settings, most, &Watch::none()).expect("a mesh");
        let error_m = mesher.certificate().expect("made to an error").error_m;
        let triangles = mesher.triangles();
        assert!(triangles <= most && triangles * 10 >= most * 9, "{most}: {triangles}");
        assert!(error_m < before);
        before = error_m;
    }
    let none = Mesher::with_at_most(&base, &map, &settings, 10, &Watch::none());
    assert!(matches!(none, Err(MesherError::MoreThan { most: 10 })));
}

#[test]
fn the_same_bits_whatever_the_number_of_threads() {
    let (base, map) = (sphere(24, 12).expect("a mesh"), map("white noise 37x53", Wrap::Mirror));
    let settings = MeshSettings { shading: Shading::Mesh, ..MeshSettings::within(0.1 * SCALE_M) };
    let with = |threads: usize| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| made(&base, &map, &settings))
    };
    let bits = |mesh: &Mesh| -> Vec<[Vec3; 2]> {
        mesh.vertices().iter().map(|vertex| [vertex.position, vertex.normal]).collect()
    };
    let [(alone, certificate), (together, same)] = [1, 4].map(with);
    assert_eq!((alone.triangles(), bits(&alone)), (together.triangles(), bits(&together)));
    assert_eq!(certificate, same);
}

#[test]
fn what_cannot_be_made_is_refused() {
    let (base, map) = (torus(12, 6).expect("a mesh"), map("white noise 37x53", Wrap::Repeat));
    let within = MeshSettings::within(0.1 * SCALE_M);
    let refused = |settings: MeshSettings| Mesher::new(&base, &map, &settings).expect_err("refused");
    for settings in [
        MeshSettings { directions: Directions::Angle, ..within },
        MeshSettings { side: Side::Above, directions: Directions::Unit, ..within },
        MeshSettings { side: Side::Below, base: BaseSurface::Pn, ..within },
    ] {
        assert!(matches!(refused(settings), MesherError::OnPlanesAlone { .. }));
    }
    for error_m in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(refused(MeshSettings::within(error_m)), MesherError::BadTolerance { .. }));
    }
    let fine = refused(MeshSettings::within(1e-9 * SCALE_M));
    let MesherError::TooFine { least_m, .. } = fine else { panic!("{fine}") };
    assert!(least_m > 1e-9 * SCALE_M && least_m < 0.1 * SCALE_M);
    // What bridges other heights at a seam is on both sides, and so is what folds over.
    let below = MeshSettings { side: Side::Below, ..within };
    let noisy = Mesher::new(&cube(2).expect("a mesh"), &map, &below);
    assert!(matches!(noisy, Err(MesherError::SideOfSeams { .. })), "{:?}", noisy.err());
    let deep = map.clone().with_displacement(0.3, 0.0).expect("lengths");
    let folded = Mesher::new(&base, &deep, &MeshSettings { error_m: 0.03, ..below });
    assert!(matches!(folded, Err(MesherError::SideOfFold { .. })), "{:?}", folded.err());
    let held = MeshSettings { max_bytes: 1000, ..within };
    assert!(matches!(refused(held), MesherError::NoMemory { limit: 1000 }));
    // A texture that repeats so often that no memory holds its texels.
    let endless = torus(3, 3).expect("a mesh").tiled(Vec2::splat(1e9)).expect("factors");
    let error = Mesher::new(&endless, &map, &within).expect_err("refused");
    assert!(matches!(error, MesherError::TooLarge { .. }), "{error}");
}
