//! Open meshes made solid: closed to the last bit, as thick as they say, and the right way round.

use std::collections::{HashMap, HashSet};

use glam::{DVec3, Vec2, Vec3};
use rayon::ThreadPoolBuilder;
use relief_core::mesh::{Mesh, Vertex, cube, rectangle, square, torus};
use relief_core::{HeightMap, Watch, Wrap};
use relief_mesh::{
    BaseSurface, CrackTest, Directions, MeshSettings, Mesher, MesherError, Seams, Shading, Stream,
};
use relief_testing::maps;

const SOLID_M: f64 = 0.05;

const SCALE_M: f64 = 0.06;

/// The relief lies on both sides of the base.
const BIAS_M: f64 = -0.02;

fn relief(name: &str, wrap: Wrap) -> HeightMap {
    let named = maps::ALL.iter().find(|map| map.name == name).expect("it is listed");
    named.build(wrap).with_displacement(SCALE_M, BIAS_M).expect("lengths")
}

/// A sheet over the unit square: its vertices by their places on it, `u` with `v` turns toward the back.
fn sheet(across: u32, down: u32, at: impl Fn(f32, f32) -> [Vec3; 4]) -> Mesh {
    let places = (0..=down).flat_map(|j| (0..=across).map(move |i| [i as f32, j as f32]));
    let vertices = places.map(|[i, j]| {
        let (u, v) = (i / across as f32, j / down as f32);
        let [position, normal, tangent, bitangent] = at(u, v);
        Vertex { position, normal, tangent, bitangent, uv: Vec2::new(u, v) }
    });
    let vertices = vertices.collect();
    let cell = |i: u32, j: u32| {
        let [here, below] = [j, j + 1].map(|row| row * (across + 1) + i);
        [[here, below, below + 1], [here, below + 1, here + 1]]
    };
    let triangles = (0..down).flat_map(|j| (0..across).flat_map(move |i| cell(i, j))).collect();
    Mesh::new(vertices, triangles).expect("a mesh")
}

/// A part of a cylinder around y, 1 m high, of radius 0.5: a whole turn has a seam.
fn tube(across: u32, down: u32, turns: f32) -> Mesh {
    sheet(across, down, |u, v| {
        // The ends of a whole turn are at one place.
        let turn = if u == 1.0 && turns == 1.0 { 0.0 } else { turns * u };
        let (sin, cos) = (std::f32::consts::TAU * turn).sin_cos();
        let (out, along) = (Vec3::new(sin, 0.0, cos), Vec3::new(cos, 0.0, -sin));
        let around = std::f32::consts::PI * turns;
        [0.5 * out + Vec3::Y * (0.5 - v), out, along * around, -Vec3::Y]
    })
}

/// Those triangles of a mesh.
fn some_of(mesh: &Mesh, keep: impl Fn([Vec3; 3], usize) -> bool) -> Mesh {
    let position = |corner: u32| mesh.vertices()[corner as usize].position;
    let kept = mesh.triangles().iter().enumerate();
    let kept = kept.filter(|(at, corners)| keep(corners.map(position), *at)).map(|(_, corners)| *corners);
    Mesh::new(mesh.vertices().to_vec(), kept.collect()).expect("a mesh")
}

/// A part of a cylinder, seen from inside.
fn hollow() -> Mesh {
    sheet(4, 3, |u, v| {
        let (sin, cos) = (-std::f32::consts::TAU * 0.3 * u).sin_cos();
        let (out, along) = (Vec3::new(sin, 0.0, cos), Vec3::new(-cos, 0.0, sin));
        [0.5 * out + Vec3::Y * (0.5 - v), -out, along * std::f32::consts::PI * 0.3, -Vec3::Y]
    })
}

/// Triangles of an underside. Triangles of walls have a corner at the surface.
fn underside(mesh: &Mesh, surface: usize) -> Vec<[DVec3; 3]> {
    let bits = |at: &DVec3| at.to_array().map(f64::to_bits);
    let all = points(mesh);
    let (above, below) = all.split_at(surface);
    let above: HashSet<[u64; 3]> = above.as_flattened().iter().map(bits).collect();
    below.iter().filter(|corners| corners.iter().all(|at| !above.contains(&bits(at)))).copied().collect()
}

fn half_torus() -> Mesh {
    some_of(&torus(16, 9).expect("a mesh"), |corners, _| corners.iter().all(|at| at.x > -1e-4))
}

fn open_bases() -> Vec<(&'static str, Mesh)> {
    let mut bases = vec![
        ("tube", tube(14, 3, 1.0)),
        ("panel", tube(5, 4, 0.3)),
        ("half torus", half_torus()),
        ("grid", sheet(7, 5, |u, v| [Vec3::new(u, 0.0, v), Vec3::Y, Vec3::X, Vec3::Z])),
        ("open cube", some_of(&cube(2).expect("a mesh"), |corners, _| corners.iter().any(|at| at.y < 0.49))),
        ("torus with a hole", some_of(&torus(12, 8).expect("a mesh"), |_, at| at != 17)),
    ];
    if let Some(spot) = relief_tests::spot("spot_triangulated.obj") {
        bases.push(("spot with holes", some_of(&spot, |_, at| !(1000..1003).contains(&at) && at != 40)));
    }
    bases
}

fn all_settings() -> Vec<(&'static str, MeshSettings)> {
    let solid = MeshSettings { solid_m: Some(SOLID_M), texels: 5, ..MeshSettings::default() };
    vec![
        ("texels", solid),
        ("unit", MeshSettings { directions: Directions::Unit, ..solid }),
        ("lift", MeshSettings { base: BaseSurface::Lift, shading: Shading::Mesh, ..solid }),
        ("pn", MeshSettings { base: BaseSurface::Pn, ..solid }),
        ("error", MeshSettings { solid_m: Some(SOLID_M), ..MeshSettings::within(0.05 * SCALE_M) }),
    ]
}

/// The triangles of a mesh by the positions of their corners.
fn points(mesh: &Mesh) -> Vec<[DVec3; 3]> {
    let position = |corner: u32| mesh.vertices()[corner as usize].position.as_dvec3();
    mesh.triangles().iter().map(|corners| corners.map(position)).collect()
}

fn volume(mesh: &Mesh) -> f64 {
    points(mesh).iter().map(|[a, b, c]| a.dot(b.cross(*c)) / 6.0).sum()
}

/// Sides without exactly one that runs the other way, by the bits of their ends.
fn unmatched(triangles: &[[Vec3; 3]]) -> usize {
    let mut ways: HashMap<[[u32; 3]; 2], i32> = HashMap::new();
    for corners in triangles {
        let bits = corners.map(|at| at.to_array().map(f32::to_bits));
        for k in 0..3 {
            *ways.entry([bits[k], bits[(k + 1) % 3]]).or_default() += 1;
        }
    }
    let has_one = |[a, b]: [[u32; 3]; 2]| ways.get(&[b, a]) == Some(&1) && ways[&[a, b]] == 1;
    ways.keys().filter(|ends| !has_one(**ends)).count()
}

fn stored(mesh: &Mesh) -> Vec<[Vec3; 3]> {
    let position = |corner: u32| mesh.vertices()[corner as usize].position;
    mesh.triangles().iter().map(|corners| corners.map(position)).collect()
}

/// Mesh, and the numbers of its triangles and vertices on the displaced surface.
fn made(base: &Mesh, map: &HeightMap, settings: &MeshSettings) -> (Mesh, usize, usize) {
    let mesher = Mesher::new(base, map, settings).expect("a solid");
    let open = MeshSettings { solid_m: None, ..*settings };
    let surface = Mesher::new(base, map, &open).expect("a mesh");
    let mesh = mesher.mesh().expect("finite");
    assert_eq!(mesh.vertices().len() as u64, mesher.vertices());
    assert_eq!(mesh.triangles().len() as u64, mesher.triangles());
    (mesh, surface.triangles() as usize, surface.vertices() as usize)
}

#[test]
fn open_meshes_become_closed_ones() {
    let map = relief("natural 101x67", Wrap::Repeat);
    for (name, base) in open_bases() {
        let pieces = CrackTest::of_mesh(&base).pieces;
        for (how, settings) in all_settings() {
            let (mesh, surface, _) = made(&base, &map, &settings);
            let cracks = CrackTest::of_mesh(&mesh);
            let about = format!("{name}, {how}: {cracks:?}");
            assert!(cracks.is_closed() && cracks.pieces == pieces, "{about}");
            let triangles = stored(&mesh);
            assert_eq!(unmatched(&triangles), 0, "{about}");
            assert!(volume(&mesh) > 0.0, "{about}: {}", volume(&mesh));
            // A vertex of any wall that is moved by one ulp is a crack; walls come last.
            for at in [surface, (surface + triangles.len()) / 2, triangles.len() - 1] {
                let mut moved = triangles.clone();
                let z = &mut moved[at][0].z;
                *z = f32::from_bits(z.to_bits() ^ 1);
                assert!(!CrackTest::of_triangles(moved).is_closed(), "{about}: {at}");
            }
            for vertex in mesh.vertices() {
                assert!(vertex.uv.is_finite() && (vertex.normal.length() - 1.0).abs() < 1e-5, "{about}");
            }
            // It is closed by the numbers of its vertices, too.
            let mut sides: Vec<[u32; 2]> = Vec::new();
            for [a, b, c] in mesh.triangles() {
                sides.extend([[*a, *b], [*b, *c], [*c, *a]]);
            }
            sides.sort_unstable();
            let back: Vec<[u32; 2]> = sides.iter().map(|[a, b]| [*b, *a]).collect();
            assert!(back.iter().all(|side| sides.binary_search(side).is_ok()), "{about}");
            assert!(sides.windows(2).all(|pair| pair[0] != pair[1]), "{about}");
        }
    }
}

/// How far it is from a point along a direction to the nearest of some triangles.
fn way_to(from: DVec3, along: DVec3, triangles: &[[DVec3; 3]]) -> Option<f64> {
    let hits = triangles.iter().filter_map(|[a, b, c]| {
        let (side, other) = (*b - *a, *c - *a);
        let across = along.cross(other);
        let scale = side.dot(across);
        let start = from - *a;
        let of_b = start.dot(across) / scale;
        let turned = start.cross(side);
        let of_c = along.dot(turned) / scale;
        let way = other.dot(turned) / scale;
        // A little beside them, too: rounding.
        (of_b.min(of_c).min(1.0 - of_b - of_c) > -1e-4 && way > 0.0).then_some(way)
    });
    hits.reduce(f64::min)
}

#[test]
fn the_underside_is_as_deep_as_asked_below_every_vertex() {
    let mut bases = open_bases();
    bases.retain(|(name, _)| !name.starts_with("spot"));
    bases.push(("hollow", hollow()));
    for name in ["white noise 37x53", "single spike 33x31"] {
        let map = relief(name, Wrap::Mirror);
        let raised = map.clone().with_displacement(SCALE_M, BIAS_M + 1.0).expect("lengths");
        for (name, base) in &bases {
            for (how, settings) in all_settings() {
                let (mesh, surface, vertices) = made(base, &map, &settings);
                // The same points 1 m higher say along what each is displaced.
                let open = MeshSettings { solid_m: None, ..settings };
                let [low, high] = [&map, &raised].map(|map| {
                    Mesher::new(base, map, &open).expect("a mesh").mesh().expect("finite").vertices().to_vec()
                });
                let of_surface = mesh.triangles()[..surface].as_flattened();
                assert!(of_surface.iter().all(|corner| (*corner as usize) < vertices));
                let below = underside(&mesh, surface);
                let (mut least, mut seen) = (f64::INFINITY, 0);
                // Vertices at one position are one.
                let bits = |vertex: &Vertex| vertex.position.to_array().map(f32::to_bits);
                let known: HashSet<[u32; 3]> = mesh.vertices().iter().map(bits).collect();
                for (low, high) in low.iter().zip(&high) {
                    let from = low.position.as_dvec3();
                    assert!(known.contains(&bits(low)));
                    let along = (high.position.as_dvec3() - from).normalize();
                    if let Some(way) = way_to(from, -along, &below) {
                        (least, seen) = (least.min(way), seen + 1);
                    }
                }
                let about = format!("{name}, {how}: {least}, {seen} of {vertices}");
                assert!(least > SOLID_M * (1.0 - 1e-4), "{about}");
                // Lines from borders go past it.
                assert!(seen * 10 > vertices * 8, "{about}");
                // And no deeper than directions of half a length, the error and hollows ask.
                assert!(least < 2.0 * SOLID_M + 0.1, "{about}");
            }
        }
    }
}

#[test]
fn a_level_grid_has_the_volume_under_its_relief() {
    let map = relief("natural 101x67", Wrap::Clamp);
    let (_, base) = open_bases().swap_remove(3);
    let [low, _] = map.extremes().map(|height| map.displacement_m(f64::from(height)));
    let of = |settings: MeshSettings| {
        let (mesh, surface, _) = made(&base, &map, &settings);
        let bottom = mesh.vertices().iter().map(|vertex| vertex.position.y).fold(f32::MAX, f32::min);
        let under = |[a, b, c]: &[DVec3; 3]| {
            let area = 0.5 * (*b - *a).cross(*c - *a).y;
            area * ((a.y + b.y + c.y) / 3.0 - f64::from(bottom))
        };
        let summed: f64 = points(&mesh)[..surface].iter().map(under).sum();
        (volume(&mesh), summed, f64::from(bottom))
    };
    let texels = MeshSettings { solid_m: Some(SOLID_M), ..MeshSettings::default() };
    let within = MeshSettings { solid_m: Some(SOLID_M), ..MeshSettings::within(0.01 * SCALE_M) };
    for (settings, more) in [(texels, 0.0), (within, 0.01 * SCALE_M)] {
        let (volume, summed, bottom) = of(settings);
        assert!((volume - summed).abs() < 1e-7, "{volume} {summed}");
        let thick = low - bottom - SOLID_M;
        assert!((-1e-7..=more + 1e-7).contains(&thick), "{thick}");
        let mean = map.displacement_m(f64::from(map.mean())) - bottom;
        assert!((volume - mean).abs() < 0.01 * mean, "{volume} {mean}");
    }
}

#[test]
fn what_has_no_inside_or_no_room_is_refused() {
    let map = relief("natural 101x67", Wrap::Repeat);
    let refused =
        |base: &Mesh, settings: &MeshSettings| Mesher::new(base, &map, settings).expect_err("refused");
    for (how, settings) in all_settings() {
        for base in [torus(16, 8), cube(2)].map(|mesh| mesh.expect("a mesh")) {
            assert!(matches!(refused(&base, &settings), MesherError::SolidOfClosed), "{how}");
        }
        // Three sheets at one edge, and two that face opposite ways.
        let book = |sheets: &[(f32, bool)]| {
            let mut vertices = Vec::new();
            let mut triangles = Vec::new();
            for &(turn, is_turned) in sheets {
                let first = vertices.len() as u32;
                let along = Vec3::new(turn.cos(), 0.0, turn.sin());
                for (position, uv) in [(Vec3::ZERO, Vec2::ZERO), (Vec3::Y, Vec2::Y), (along, Vec2::X)] {
                    let normal = Vec3::Y.cross(along);
                    vertices.push(Vertex { position, normal, tangent: along, bitangent: Vec3::Y, uv });
                }
                let [a, b, c] = [first, first + 1, first + 2];
                triangles.push(if is_turned { [b, a, c] } else { [a, b, c] });
            }
            Mesh::new(vertices, triangles).expect("a mesh")
        };
        for sheets in [&[(0.0, false), (2.0, true), (4.0, false)][..], &[(0.0, false), (3.0, false)]] {
            let found = refused(&book(sheets), &settings);
            assert!(matches!(found, MesherError::SolidBranches { edges: 1, .. }), "{how}: {found}");
            assert!(found.to_string().contains("(0.000000, 0.500000, 0.000000)"), "{found}");
        }
        // Two corners of a grid that touch.
        let grid = square(4).expect("a mesh");
        let is_in = |at: Vec3, low: f32| at.x >= low - 1e-4 && at.x <= low + 0.5001 && at.z >= low - 1e-4;
        let least = grid.vertices().iter().map(|vertex| vertex.position.x).fold(f32::MAX, f32::min);
        let touching = some_of(&grid, |corners, _| {
            let all = |low: f32| corners.iter().all(|at| is_in(*at, low) && at.z <= low + 0.5001);
            all(least) || all(least + 0.5)
        });
        let found = refused(&touching, &settings);
        assert!(matches!(found, MesherError::SolidTouches { .. }), "{how}: {found}");
    }
    // The triangles that close it count as well.
    for base in [rectangle([1.0, 1.0], 1).expect("a mesh"), tube(5, 4, 0.3)] {
        let solid = MeshSettings { solid_m: Some(SOLID_M), ..MeshSettings::within(f64::NAN) };
        let mesher = Mesher::with_at_most(&base, &map, &solid, 1500, &Watch::none()).expect("a solid");
        assert!((1200..=1500).contains(&mesher.triangles()), "{}", mesher.triangles());
        let few = Mesher::with_at_most(&base, &map, &solid, 40, &Watch::none());
        assert!(matches!(few, Err(MesherError::MoreThan { most: 40 })) == (base.triangles().len() > 2));
    }
    let kept = MeshSettings { seams: Seams::Keep, solid_m: Some(SOLID_M), ..MeshSettings::default() };
    assert!(matches!(refused(&tube(14, 3, 1.0), &kept), MesherError::SolidOfSeams { .. }));
    let (mesh, ..) = made(&tube(5, 4, 0.3), &map, &kept);
    assert!(CrackTest::of_mesh(&mesh).is_closed());
    for solid_m in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let bad = MeshSettings { solid_m: Some(solid_m), ..MeshSettings::default() };
        assert!(matches!(refused(&tube(5, 4, 0.3), &bad), MesherError::BadSolid { .. }));
    }
}

#[test]
fn closed_pieces_stay_and_undersides_that_fold_are_counted() {
    let map = relief("natural 101x67", Wrap::Repeat);
    let solid = MeshSettings { solid_m: Some(SOLID_M), texels: 9, ..MeshSettings::default() };
    let (ring, panel) = (torus(12, 8).expect("a mesh"), tube(5, 4, 0.3));
    let mut vertices = ring.vertices().to_vec();
    let mut triangles = ring.triangles().to_vec();
    let first = vertices.len() as u32;
    vertices.extend(panel.vertices().iter().map(|vertex| {
        let position = vertex.position + 5.0 * Vec3::X;
        Vertex { position, ..*vertex }
    }));
    triangles.extend(panel.triangles().iter().map(|corners| corners.map(|corner| first + corner)));
    let both = Mesh::new(vertices, triangles).expect("a mesh");
    for shading in [Shading::Exact, Shading::Mesh] {
        let (mesh, surface, _) = made(&both, &map, &MeshSettings { shading, ..solid });
        let cracks = CrackTest::of_mesh(&mesh);
        assert!(cracks.is_closed() && cracks.pieces == 2, "{cracks:?}");
        let (alone, own, _) = made(&panel, &map, &MeshSettings { shading, ..solid });
        assert_eq!(mesh.triangles().len() - surface, alone.triangles().len() - own);
    }
    let folds = |base: &Mesh, solid_m: f64| {
        let mesher = Mesher::new(base, &map, &MeshSettings { solid_m: Some(solid_m), ..solid });
        let how = Stream { size: 1.0, check: true, grid: None, cache_order: true, watch: Watch::none() };
        let streamed = mesher.expect("a solid").stream(&how, |_| Ok::<(), ()>(())).expect("finite");
        assert_eq!(streamed.folds.triangles, 0);
        assert!(streamed.cracks.expect("looked at").is_closed());
        streamed.folds_below.base_triangles
    };
    // Deeper than the axis of the cylinder all of it is turned over.
    assert_eq!(folds(&panel, 0.2), 0);
    assert_eq!(folds(&panel, 0.9), panel.triangles().len() as u64);
    assert_eq!(folds(&rectangle([1.0, 1.0], 3).expect("a mesh"), 9.0), 0);
}

#[test]
fn solids_do_not_depend_on_threads() {
    let map = relief("natural 101x67", Wrap::Repeat);
    let base = tube(40, 30, 1.0).tiled(Vec2::new(4.0, 3.0)).expect("tiled");
    for settings in [MeshSettings::default(), MeshSettings::within(0.02 * SCALE_M)] {
        let settings = MeshSettings { solid_m: Some(SOLID_M), ..settings };
        let mesh = || Mesher::new(&base, &map, &settings).expect("a solid").mesh().expect("finite");
        let pool = ThreadPoolBuilder::new().num_threads(1).build().expect("a pool");
        let (one, all) = (pool.install(mesh), mesh());
        assert_eq!(one.triangles(), all.triangles());
        assert_eq!(one.vertices(), all.vertices());
        // Of several blocks.
        assert!(all.triangles().len() > 1 << 15 && CrackTest::of_mesh(&all).is_closed());
    }
}

#[test]
fn triangles_without_an_area_open_nothing() {
    let map = relief("natural 101x67", Wrap::Repeat);
    let panel = tube(5, 4, 0.3);
    let mut vertices = panel.vertices().to_vec();
    let mut triangles = panel.triangles().to_vec();
    // One along an inner side, one along the border, one in a corner, by vertices of their own.
    for ends in [[7, 8], [0, 1], [0, 0]] {
        let first = vertices.len() as u32;
        vertices.extend(ends.iter().chain(&ends[..1]).map(|end| panel.vertices()[*end as usize]));
        triangles.push([first, first + 1, first + 2]);
    }
    let base = Mesh::new(vertices, triangles).expect("a mesh");
    for (how, settings) in all_settings() {
        let (mesh, ..) = made(&base, &map, &settings);
        let cracks = CrackTest::of_mesh(&mesh);
        assert_eq!(cracks.open, 0, "{how}: {cracks:?}");
        let (plain, ..) = made(&panel, &map, &settings);
        assert!((volume(&mesh) - volume(&plain)).abs() < 1e-6 * volume(&plain), "{how}");
    }
}
