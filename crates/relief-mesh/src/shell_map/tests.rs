use std::collections::{HashMap, HashSet};

use glam::{DVec3, Vec2, Vec3};
use relief_core::Watch;
use relief_core::mesh::{Builtin, Mesh, Vertex, sphere, torus};

use super::shell::{Shell, TETRAHEDRA};
use super::*;
use crate::motif::{MotifKind, MotifSettings, VectorSheet, VectorSheetError, motif, vector_sheet};

const SETTINGS: ShellMapSettings = ShellMapSettings { scale_m: 0.06, bias_m: 0.01, triangles: MAX_TRIANGLES };

fn motif_of(kind: MotifKind) -> Mesh {
    motif(&MotifSettings { detail: 4, ..MotifSettings::new(kind) }).expect("a motif").mesh
}

fn made(base: &Mesh, motif: &Mesh, settings: &ShellMapSettings) -> ShellMap {
    map_shells(base, &motif.into(), settings, &Watch::none()).expect("a shell map")
}

fn ring() -> Mesh {
    torus(24, 10).and_then(|mesh| mesh.tiled(Vec2::new(4.0, 2.0))).expect("a torus")
}

/// The signed volume inside of a closed mesh.
fn volume_of(mesh: &Mesh) -> f64 {
    let at = |corner: u32| mesh.vertices()[corner as usize].position.as_dvec3();
    mesh.triangles().iter().map(|corners| corners.map(at)).map(|[a, b, c]| a.cross(b).dot(c) / 6.0).sum()
}

/// A mesh of a few corners `(u, height, v)`.
fn mesh_of(corners: &[[f32; 3]], triangles: &[[u32; 3]]) -> Mesh {
    let vertex = |at: &[f32; 3]| Vertex {
        position: Vec3::from_array(*at),
        normal: Vec3::Y,
        tangent: Vec3::X,
        bitangent: Vec3::Z,
        uv: Vec2::new(at[0], at[2]),
    };
    Mesh::new(corners.iter().map(vertex).collect(), triangles.to_vec()).expect("a mesh")
}

#[test]
fn closed_motifs_stay_closed_on_closed_bases() {
    for kind in MotifKind::ALL {
        let motif = motif_of(kind);
        let map = made(&ring(), &motif, &SETTINGS);
        assert_eq!((map.open_edges, map.folded.len(), map.without_area), (0, 0, 0), "{kind}");
        assert!(map.mesh.triangles().len() > 6 * motif.triangles().len(), "{kind}");
        assert!(volume_of(&map.mesh) > 0.0, "{kind}");
        // Threads have caps, which the next tile's meet.
        assert_eq!(map.doubled > 0, kind == MotifKind::Weave, "{kind}");
        let lengths = map.mesh.vertices().iter().map(|vertex| vertex.normal.length());
        assert!(lengths.into_iter().all(|length| (length - 1.0).abs() < 1e-5), "{kind}");
    }
}

/// A height map has no holes through what is above it; links of mail have one each.
#[test]
fn every_link_of_mail_stays_a_ring() {
    let map = made(&ring(), &motif_of(MotifKind::Mail), &SETTINGS).mesh;
    let place = map.welded();
    let mut whole: Vec<usize> = (0..map.vertices().len()).collect();
    fn first(whole: &mut [usize], mut at: usize) -> usize {
        while whole[at] != at {
            whole[at] = whole[whole[at]];
            at = whole[at];
        }
        at
    }
    let triangles: Vec<[usize; 3]> =
        map.triangles().iter().map(|corners| corners.map(|corner| place[corner as usize] as usize)).collect();
    for [a, b, c] in &triangles {
        for other in [b, c] {
            let [a, other] = [*a, *other].map(|at| first(&mut whole, at));
            whole[a] = other;
        }
    }
    // Corners and edges less triangles: 0 for a ring, 2 for a ball. Two triangles have three edges.
    let mut twice_euler: HashMap<usize, i64> = HashMap::new();
    for [a, _, _] in &triangles {
        *twice_euler.entry(first(&mut whole, *a)).or_default() -= 1;
    }
    let corners: HashSet<usize> = triangles.iter().flatten().copied().collect();
    for corner in corners {
        *twice_euler.entry(first(&mut whole, corner)).or_default() += 2;
    }
    // Three links in ten rows on each of eight tiles.
    assert_eq!(twice_euler.len(), 3 * 10 * 8);
    assert!(twice_euler.values().all(|euler| *euler == 0), "{twice_euler:?}");
}

#[test]
fn a_gap_in_the_motif_is_counted() {
    let motif = motif_of(MotifKind::Mail);
    let fewer = Mesh::new(motif.vertices().to_vec(), motif.triangles()[1..].to_vec()).expect("a mesh");
    assert!(made(&ring(), &fewer, &SETTINGS).open_edges > 0);
}

/// Every place of the motif is where the tetrahedra of the shells have it.
#[test]
fn places_are_those_of_the_tetrahedra() {
    let (base, motif) = (ring(), motif_of(MotifKind::Mail));
    let map = made(&base, &motif, &SETTINGS);
    let welded = base.welded();
    let lengths = [SETTINGS.bias_m, SETTINGS.bias_m + SETTINGS.scale_m];
    // Each vertex of the result lies in a tetrahedron, by its texture coordinates and its height.
    let cells: Vec<_> = (0..base.triangles().len())
        .flat_map(|at| {
            let corners = base.triangles()[at];
            let vertices = corners.map(|corner| &base.vertices()[corner as usize]);
            let numbers = corners.map(|corner| welded[corner as usize]);
            let shell = Shell::new(at, vertices, numbers, lengths).expect("few tiles").expect("an area");
            TETRAHEDRA.map(|corners| {
                let uv = corners.map(|corner| shell.uv(corner));
                let place = [0, 1, 2, 3]
                    .map(|at| DVec3::new(uv[at].x, uv[at].y, f64::from(u8::from(corners[at].is_upper))));
                (place, corners.map(|corner| shell.position(corner)))
            })
        })
        .collect();
    let places = motif.vertices().iter().step_by(7).map(|vertex| vertex.position.as_dvec3());
    let mut found = 0;
    for at in places {
        for (place, positions) in &cells {
            let [e1, e2, e3] = [1, 2, 3].map(|corner| place[corner] - place[0]);
            let volume = e1.dot(e2.cross(e3));
            for tile in 0..8 {
                let [i, j] = [tile % 4, tile / 4].map(f64::from);
                let away = DVec3::new(at.x + i, at.z + j, at.y) - place[0];
                let weights =
                    [e2.cross(e3), e3.cross(e1), e1.cross(e2)].map(|normal| away.dot(normal) / volume);
                let first = 1.0 - weights.iter().sum::<f64>();
                if first < 1e-6 || weights.iter().any(|weight| *weight < 1e-6) {
                    continue;
                }
                let moved = positions[0] * first
                    + positions[1] * weights[0]
                    + positions[2] * weights[1]
                    + positions[3] * weights[2];
                let near = map
                    .mesh
                    .vertices()
                    .iter()
                    .any(|vertex| (vertex.position.as_dvec3() - moved).length() < 1e-6);
                assert!(near, "{at} in tile {i} {j} is missing at {moved}");
                found += 1;
            }
        }
    }
    assert!(found > 500, "{found}");
}

#[test]
fn the_outside_stays_outside() {
    let cube = {
        let corners: Vec<[f32; 3]> =
            (0..8).map(|at| [0, 1, 2].map(|axis| if at >> axis & 1 == 1 { 0.7 } else { 0.3 })).collect();
        let sides = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles: Vec<_> =
            sides.into_iter().flat_map(|[a, b, c, d]: [u32; 4]| [[a, b, c], [a, c, d]]).collect();
        mesh_of(&corners, &triangles)
    };
    let plane = Builtin::Plane.build([1.0, 1.0]).expect("a plane");
    let flat = volume_of(&cube);
    // Six faces of the cube in a tile of 1 m by 1 m, as deep as the scale.
    for (mirror, scale_m) in [(false, 0.5), (true, 0.5), (false, -0.5), (true, -0.5)] {
        let mut vertices = plane.vertices().to_vec();
        if mirror {
            for vertex in &mut vertices {
                (vertex.uv.x, vertex.tangent) = (1.0 - vertex.uv.x, -vertex.tangent);
            }
        }
        let base = Mesh::new(vertices, plane.triangles().to_vec()).expect("a mesh");
        let map = made(&base, &cube, &ShellMapSettings { scale_m, ..SETTINGS });
        assert_eq!((map.open_edges, map.folded.len()), (0, 0), "{mirror} {scale_m}");
        let volume = volume_of(&map.mesh);
        assert!((volume - 0.5 * flat).abs() < 1e-6, "{mirror} {scale_m}: {volume} {flat}");
        let is_outward = map.mesh.triangles().iter().all(|corners| {
            let [a, b, c] = corners.map(|corner| map.mesh.vertices()[corner as usize].position);
            (b - a).cross(c - a).dot((a + b + c) / 3.0 - map_centre(&map.mesh)) > -1e-9
        });
        assert!(is_outward, "{mirror} {scale_m}");
    }
}

fn map_centre(mesh: &Mesh) -> Vec3 {
    let places = mesh.vertices().iter().map(|vertex| vertex.position);
    let (low, high) =
        places.fold((Vec3::INFINITY, Vec3::NEG_INFINITY), |(low, high), at| (low.min(at), high.max(at)));
    0.5 * (low + high)
}

#[test]
fn a_sheet_of_one_height_is_a_sheet_above_the_base() {
    // Along the diagonal of a plane, where its triangles meet.
    let sheet = mesh_of(
        &[[0.0, 0.25, 0.0], [1.0, 0.25, 0.0], [0.0, 0.25, 1.0], [1.0, 0.25, 1.0]],
        &[[0, 2, 1], [1, 2, 3]],
    );
    let plane =
        Builtin::Plane.build([1.0, 1.0]).and_then(|mesh| mesh.tiled(Vec2::new(3.0, 2.0))).expect("a plane");
    let map = made(&plane, &sheet, &SETTINGS);
    let heights = map.mesh.vertices().iter().map(|vertex| f64::from(vertex.position.y));
    assert!(heights.into_iter().all(|height| (height - 0.025).abs() < 1e-6));
    let area: f64 = map
        .mesh
        .triangles()
        .iter()
        .map(|corners| {
            let [a, b, c] = corners.map(|corner| map.mesh.vertices()[corner as usize].position.as_dvec3());
            0.5 * (b - a).cross(c - a).length()
        })
        .sum();
    assert!((area - 1.0).abs() < 1e-5, "{area}");
    assert!(map.open_edges > 0, "a sheet has a border");
}

/// A map of vectors that lean over each other, in tiles.
fn leaning(size: [u32; 2]) -> VectorSheet {
    let turn = |at: u32, of: u32| std::f64::consts::TAU * (f64::from(at) + 0.3) / f64::from(of);
    let texels = (0..size[1]).flat_map(|row| (0..size[0]).map(move |column| (column, row)));
    let vectors: Vec<[f64; 3]> = texels
        .map(|(column, row)| {
            let (a, b) = (turn(column, size[0]), turn(row, size[1]));
            [0.17 * a.sin(), 0.2 * a.cos() * b.sin() - 0.05, 0.11 * (b + a).cos()]
        })
        .collect();
    vector_sheet(size, &vectors).expect("a sheet")
}

#[test]
fn points_of_a_sheet_of_vectors_lie_where_they_say() {
    let tiles = Vec2::splat(3.0);
    let plane = Builtin::Plane.build([1.0, 1.0]).and_then(|mesh| mesh.tiled(tiles)).expect("a plane");
    let [low, high] = leaning([8, 5]).heights;
    let settings = ShellMapSettings { scale_m: 0.1 * (high - low), bias_m: 0.1 * low, ..SETTINGS };
    let map = map_shells(&plane, &leaning([8, 5]).mesh, &settings, &Watch::none()).expect("a shell map");
    let first = plane.vertices()[0];
    let places: Vec<DVec3> = map.mesh.vertices().iter().map(|vertex| vertex.position.as_dvec3()).collect();
    let turn = |at: u32, of: u32| std::f64::consts::TAU * (f64::from(at) + 0.3) / f64::from(of);
    for (column, row) in (0..5).flat_map(|row| (0..8).map(move |column| (column, row))) {
        let (a, b) = (turn(column, 8), turn(row, 5));
        // Of the middle tile.
        let u = 1.0 + (f64::from(column) + 0.5) / 8.0 + 0.17 * a.sin();
        let v = 1.0 + (f64::from(row) + 0.5) / 5.0 + 0.11 * (b + a).cos();
        let up = 0.1 * (0.2 * a.cos() * b.sin() - 0.05);
        let along = |step: Vec3, by: f64| step.as_dvec3() * by;
        let expected = first.position.as_dvec3()
            + along(first.tangent, u - f64::from(first.uv.x))
            + along(first.bitangent, v - f64::from(first.uv.y))
            + along(first.normal, up);
        let off = places.iter().map(|place| place.distance(expected)).fold(f64::MAX, f64::min);
        assert!(off < 1e-6, "({column}, {row}): {off} m off");
    }
}

#[test]
fn a_sheet_of_vectors_is_closed_where_the_base_is() {
    for size in [[8, 5], [1, 1], [3, 1], [7, 16]] {
        let sheet = leaning(size);
        let map = map_shells(&ring(), &sheet.mesh, &SETTINGS, &Watch::none()).expect("a shell map");
        assert_eq!((map.open_edges, map.beyond), (0, 0.0), "{size:?}");
    }
    // A level one has room, too.
    let level = vector_sheet([2, 2], &[[0.0, 3.0, 0.0]; 4]).expect("a sheet");
    assert!(level.heights[0] < 3.0 && 3.0 < level.heights[1]);
}

#[test]
fn vectors_that_make_no_sheet_are_refused() {
    let far = [[0.0; 3], [0.0, 0.0, -99.0]];
    assert_eq!(vector_sheet([2, 1], &far), Err(VectorSheetError::Far { column: 1, row: 0, tiles: 99.0 }));
    assert!(matches!(vector_sheet([1, 1], &[[f64::NAN; 3]]), Err(VectorSheetError::Far { .. })));
    for (size, count) in [([0, 0], 0), ([2, 2], 3), ([u32::MAX, u32::MAX], 1)] {
        let refused = vector_sheet(size, &vec![[0.0; 3]; count]);
        assert!(matches!(refused, Err(VectorSheetError::Size { .. })), "{size:?}");
    }
}

#[test]
fn any_number_of_threads_makes_the_same_mesh() {
    let of = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| made(&ring(), &motif_of(MotifKind::Grass), &SETTINGS))
    };
    assert_eq!(of(1), of(3));
}

#[test]
fn what_cannot_be_is_refused() {
    let (ring, mail) = (ring(), motif_of(MotifKind::Mail));
    let refused = |base: &Mesh, motif: &Mesh, settings: &ShellMapSettings| {
        map_shells(base, &motif.into(), settings, &Watch::none()).expect_err("it is refused")
    };
    for scale_m in [0.0, f64::NAN, f64::INFINITY] {
        let error = refused(&ring, &mail, &ShellMapSettings { scale_m, ..SETTINGS });
        assert!(matches!(error, ShellMapError::Lengths { .. }), "{error}");
    }
    let above = mesh_of(&[[0.0, 2.0, 0.0], [1.0, 2.0, 0.0], [0.0, 3.0, 1.0]], &[[0, 2, 1]]);
    assert_eq!(refused(&ring, &above, &SETTINGS), ShellMapError::Nothing);
    let far = mesh_of(&[[0.0, 0.5, 0.0], [99.0, 0.5, 0.0], [0.0, 0.5, 1.0]], &[[0, 2, 1]]);
    assert_eq!(refused(&ring, &far, &SETTINGS), ShellMapError::FarMotif(1));
    let few = ShellMapSettings { triangles: 1000, ..SETTINGS };
    assert!(matches!(refused(&ring, &mail, &few), ShellMapError::TooLarge { .. }));
    let wide =
        Builtin::Plane.build([1.0, 1.0]).and_then(|mesh| mesh.tiled(Vec2::splat(500.0))).expect("a plane");
    assert!(matches!(refused(&wide, &mail, &SETTINGS), ShellMapError::TooWide { .. }));
    // A texture without an area.
    let vertices = ring.vertices().iter().map(|vertex| Vertex { uv: Vec2::ZERO, ..*vertex }).collect();
    let bare = Mesh::new(vertices, ring.triangles().to_vec()).expect("a mesh");
    assert_eq!(refused(&bare, &mail, &SETTINGS), ShellMapError::Nothing);
}

#[test]
fn folds_and_cuts_are_counted() {
    // A ball of 0.5 m turned inward by 2 m is folded everywhere.
    let ball = sphere(12, 6).and_then(|mesh| mesh.tiled(Vec2::new(4.0, 2.0))).expect("a sphere");
    let deep = ShellMapSettings { scale_m: 2.0, bias_m: -2.5, ..SETTINGS };
    assert!(!made(&ball, &motif_of(MotifKind::Mail), &deep).folded.is_empty());
    let high = mesh_of(&[[0.1, 0.5, 0.1], [0.9, 0.5, 0.1], [0.1, 1.5, 0.9]], &[[0, 2, 1]]);
    let map = made(&ball, &high, &SETTINGS);
    assert!((map.beyond - 1.0 / 3.0).abs() < 1e-9, "{}", map.beyond);
}
