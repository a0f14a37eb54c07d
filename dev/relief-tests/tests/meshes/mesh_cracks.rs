//! Displaced meshes are closed where their bases are, to the last bit, and the test that says so notices one.

use glam::Vec3;
use relief_core::mesh::{BasePoint, Builtin, Mesh, cube, cylinder, sphere, torus};
use relief_core::{HeightMap, Wrap};
use relief_mesh::{
    BaseSurface, CrackTest, Directions, EDGE_RULES, INTERIORS, MeshSettings, Mesher, Seams, Spacing,
    check_pair,
};
use relief_testing::maps;

/// All pairs of an edge rule and an interior that make sense on any mesh, with the given texels between
/// points.
fn settings(texels: u32) -> Vec<MeshSettings> {
    let pairs = EDGE_RULES.iter().flat_map(|edges| INTERIORS.iter().map(move |interior| (edges, interior)));
    pairs
        .filter(|(edges, interior)| check_pair(edges, interior).is_ok() && edges.spacing == Spacing::Even)
        .map(|(edges, interior)| MeshSettings { edges, interior, texels, ..MeshSettings::default() })
        .collect()
}

fn displaced(map: &HeightMap, scale_m: f64, bias_m: f64) -> HeightMap {
    map.clone().with_displacement(scale_m, bias_m).expect("lengths")
}

fn closed_bases() -> Vec<(&'static str, Mesh)> {
    let mesh = |mesh: Result<Mesh, _>| mesh.expect("a mesh");
    vec![
        ("cube", mesh(cube(1))),
        ("cube of 3", mesh(cube(3))),
        ("cylinder", mesh(cylinder(16, 2))),
        ("sphere", mesh(sphere(24, 12))),
        ("torus", mesh(torus(24, 10))),
    ]
}

fn triangles(mesh: &Mesh) -> Vec<[Vec3; 3]> {
    let position = |corner: u32| mesh.vertices()[corner as usize].position;
    mesh.triangles().iter().map(|corners| corners.map(position)).collect()
}

#[test]
fn meshes_are_closed_where_their_bases_are() {
    let mut made = 0;
    for (name, base) in closed_bases() {
        assert!(CrackTest::of_mesh(&base).is_closed(), "{name}: the base is not closed");
        for named in maps::ALL {
            for (at, wrap) in Wrap::ALL.into_iter().enumerate() {
                // Adversarial maps at several finenesses; all of them in each wrap would be slow.
                let texels = [1, 3, 16][(at + made) % 3];
                let map = displaced(&named.build(wrap), 0.04, -0.01);
                for settings in settings(texels) {
                    let base_surface = BaseSurface::ALL[made % 3];
                    let directions = Directions::ALL[made / 2 % 3];
                    let settings = MeshSettings { base: base_surface, directions, ..settings };
                    let mesh = Mesher::new(&base, &map, &settings).expect("a mesh").mesh().expect("finite");
                    let cracks = CrackTest::of_mesh(&mesh);
                    let about =
                        format!("{name}, {}, {wrap}, {texels}, {base_surface}: {cracks:?}", named.name);
                    assert!(cracks.is_closed() && cracks.pieces == 1, "{about}");
                    made += 1;
                }
            }
        }
    }
    assert!(made >= 200, "{made}");
}

#[test]
fn spot_is_closed() {
    let Some(base) = relief_tests::spot("spot_triangulated.obj") else { return };
    let was = CrackTest::of_mesh(&base);
    let map = maps::ALL.iter().find(|map| map.name == "natural 128x128").expect("it is listed");
    let map = displaced(&map.build(Wrap::Repeat), 0.03, 0.0);
    for texels in [1, 2, 7] {
        for base_surface in BaseSurface::ALL {
            for settings in settings(texels) {
                let settings = MeshSettings { base: *base_surface, ..settings };
                let mesher = Mesher::new(&base, &map, &settings).expect("a mesh");
                let cracks = CrackTest::of_mesh(&mesher.mesh().expect("finite"));
                println!("spot, {texels}, {base_surface}: {cracks:?}");
                assert_eq!((cracks.open, cracks.branching), (was.open, was.branching));
                assert_eq!(cracks.pieces, was.pieces);
            }
        }
    }
}

#[test]
fn kept_seams_gape_where_heights_or_normals_differ_and_not_elsewhere() {
    let map = maps::ALL.iter().find(|map| map.name == "white noise 37x53").expect("it is listed");
    let rough = displaced(&map.build(Wrap::Clamp), 0.05, 0.01);
    let kept = MeshSettings { seams: Seams::Keep, texels: 4, ..MeshSettings::default() };
    let cracks = |base: &Mesh, map: &HeightMap| {
        CrackTest::of_mesh(&Mesher::new(base, map, &kept).expect("a mesh").mesh().expect("finite"))
    };
    // Hard edges gape.
    assert!(cracks(&cube(1).expect("a mesh"), &rough).open > 0);
    // A clamped map has other heights on both sides of the cut, a level one has not.
    let ball = sphere(16, 8).expect("a mesh");
    assert!(cracks(&ball, &rough).open > 0);
    let level = HeightMap::from_fn(37, 53, Wrap::Clamp, |_, _| 0.3).expect("a valid map");
    assert!(cracks(&ball, &displaced(&level, 0.05, 0.0)).is_closed());
}

#[test]
fn planes_are_one_sheet_with_one_border() {
    for named in maps::ALL {
        for texels in [1, 2, 50] {
            let map = displaced(&named.build(Wrap::Mirror), 0.1, 0.0);
            let base = Builtin::Plane.build(map.proportions()).expect("a mesh");
            for settings in settings(texels) {
                let mesher = Mesher::new(&base, &map, &settings).expect("a mesh");
                let mesh = mesher.mesh().expect("finite");
                let cracks = CrackTest::of_mesh(&mesh);
                let lines = [map.width(), map.height()].map(|side| u64::from(side.div_ceil(texels)) + 1);
                assert_eq!((cracks.branching, cracks.pieces), (0, 1), "{}", named.name);
                assert_eq!(cracks.open, 2 * (lines[0] + lines[1]), "{} {texels}", named.name);
                assert_eq!(mesher.triangles(), 2 * lines[0] * lines[1]);
                assert_eq!(mesher.vertices(), (lines[0] + 1) * (lines[1] + 1));
            }
        }
    }
}

#[test]
fn running_sums_and_moved_vertices_are_found() {
    let map = maps::ALL.iter().find(|map| map.name == "natural 101x67").expect("it is listed");
    let map = displaced(&map.build(Wrap::Repeat), 0.05, 0.0);
    let base = torus(9, 7).expect("a mesh");
    let mesh = Mesher::new(&base, &map, &MeshSettings::default()).expect("a mesh").mesh().expect("finite");
    let whole = triangles(&mesh);
    assert!(CrackTest::of_triangles(whole.iter().copied()).is_closed());
    for at in [0, whole.len() / 2, whole.len() - 1] {
        let mut moved = whole.clone();
        moved[at][1].x = f32::from_bits(moved[at][1].x.to_bits() ^ 1);
        assert!(!CrackTest::of_triangles(moved).is_closed());
    }
    // Points of edges by differences that are added up, as Gumhold and Hüttner 1999 have them, from the first
    // corner of each triangle's own side.
    let strips = |is_summed: bool| {
        let mut strips = Vec::new();
        for triangle in 0..base.triangles().len() as u32 {
            let corners = base.corners(triangle).map(|vertex| BasePoint::from(vertex).position.as_vec3());
            for side in 0..3 {
                let (a, b) = (corners[side], corners[(side + 1) % 3]);
                let n = 16u16;
                let step = (b - a) / f32::from(n);
                let mut points = vec![a];
                for k in 1..n {
                    let summed = points[usize::from(k) - 1] + step;
                    let [left, right] = [n - k, k].map(f32::from);
                    points.push(if is_summed { summed } else { (a * left + b * right) / f32::from(n) });
                }
                points.push(b);
                let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
                strips.extend(points.windows(2).map(|pair| [pair[0], pair[1], middle]));
            }
        }
        CrackTest::of_triangles(strips)
    };
    assert!(strips(false).is_closed());
    assert!(strips(true).open > 1000, "{:?}", strips(true));
}
