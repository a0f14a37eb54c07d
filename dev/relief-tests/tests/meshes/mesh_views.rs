//! Meshes that are divided by the voxels of a view: closed from wherever they are looked at, as fine as they
//! were asked to be, and on the base.

use glam::{DVec2, DVec3, Vec2, Vec3};
use relief_bake::{Filter, filter_levels};
use relief_core::camera::{Camera, Projection};
use relief_core::mesh::{BasePoint, Builtin, Mesh, Vertex, cube, cylinder, sphere, torus};
use relief_core::{HeightMap, Watch, Wrap};
use relief_mesh::{
    BaseSurface, CrackTest, Cracks, EDGE_RULES, INTERIORS, Interior, MeshSettings, Mesher, MesherError, Part,
    Seams, Spacing, View, Weights, check_pair,
};
use relief_testing::maps;

/// Views from all around.
const VIEWS: usize = 200;

/// The interiors that fill sides which are divided by voxels.
fn interiors() -> Vec<&'static Interior> {
    let rule = EDGE_RULES.iter().find(|rule| rule.spacing == Spacing::Voxels).expect("it is listed");
    INTERIORS.iter().filter(|interior| check_pair(rule, interior).is_ok()).collect()
}

fn map(name: &str, wrap: Wrap, scale_m: f64) -> HeightMap {
    let named = maps::ALL.iter().find(|map| map.name == name).expect("it is listed");
    named.build(wrap).with_displacement(scale_m, -scale_m / 2.0).expect("lengths")
}

/// Cameras all around the origin, every fifth of them orthographic, some near it.
fn cameras(count: usize) -> impl Iterator<Item = Camera> {
    (0..count).map(move |k| {
        let part = (k as f64 + 0.5) / count as f64;
        let (up, turn) = (1.0 - 2.0 * part, k as f64 * 2.399_963);
        let aside = (1.0 - up * up).sqrt();
        let distance = [1.4, 3.0, 0.9, 8.0][k % 4];
        let eye = DVec3::new(aside * turn.cos(), up, aside * turn.sin()) * distance;
        let projection = if k % 5 == 4 {
            Projection::Orthographic { height_m: 1.5 }
        } else {
            Projection::Perspective { fov_degrees: 40.0 }
        };
        Camera::with(eye, DVec3::new(0.1, -0.05, 0.0), projection).expect("a camera")
    })
}

fn seen(camera: Camera, side: u32, pixels: f64) -> View {
    View { pixels, ..View::new(camera, [side, side]) }
}

/// The coarser levels of a map.
fn coarser(map: &HeightMap, filter: Filter) -> Vec<HeightMap> {
    filter_levels(map, filter, &Watch::none()).expect("levels").split_off(1)
}

#[test]
fn meshes_are_closed_from_everywhere() {
    let bases = [cube(2), cylinder(12, 2), sphere(16, 8), torus(16, 8)].map(|mesh| mesh.expect("a mesh"));
    let map = map("natural 101x67", Wrap::Mirror, 0.05);
    let levels = coarser(&map, Filter::Average);
    let mut triangles = 0;
    for (at, camera) in cameras(VIEWS).enumerate() {
        for base in &bases {
            for interior in interiors() {
                let view = seen(camera, 150, [1.0, 3.7, 40.0][at % 3]);
                let base_surface = BaseSurface::ALL[at % 3];
                let settings = MeshSettings { interior, base: base_surface, ..MeshSettings::seen_by(view) };
                let mesher = match at % 2 {
                    0 => Mesher::new(base, &map, &settings),
                    _ => Mesher::with_levels(base, &map, &levels, &settings, &Watch::none()),
                };
                let mesher = mesher.expect("a mesh");
                let mesh = mesher.mesh().expect("finite");
                assert_eq!(mesh.triangles().len() as u64, mesher.triangles());
                assert_eq!(mesh.vertices().len() as u64, mesher.vertices());
                let cracks = CrackTest::of_mesh(&mesh);
                assert!(cracks.is_closed() && cracks.pieces == 1, "{camera:?} {}: {cracks:?}", interior.name);
                triangles += cracks.triangles;
            }
        }
    }
    println!("{triangles} triangles");
}

#[test]
fn spot_is_closed_from_everywhere() {
    let Some(base) = relief_tests::spot("spot_triangulated.obj") else { return };
    let was = CrackTest::of_mesh(&base);
    let map = map("natural 101x67", Wrap::Mirror, 0.03);
    let levels = coarser(&map, Filter::Average);
    for (at, camera) in cameras(VIEWS).enumerate() {
        for interior in interiors() {
            // Some of the eyes lie within it.
            let view = View { near_m: 0.3, ..seen(camera, 150, [2.0, 3.7, 40.0][at % 3]) };
            let base_surface = BaseSurface::ALL[at % 3];
            let settings = MeshSettings { interior, base: base_surface, ..MeshSettings::seen_by(view) };
            let mesher = Mesher::with_levels(&base, &map, &levels, &settings, &Watch::none());
            let cracks = CrackTest::of_mesh(&mesher.expect("a mesh").mesh().expect("finite"));
            let counts = |of: &Cracks| [of.open, of.branching, of.pieces];
            assert_eq!(counts(&cracks), counts(&was), "{camera:?} {}", interior.name);
        }
    }
}

#[test]
fn eyes_within_the_surface_or_before_it_make_no_crack() {
    let map = map("white noise 37x53", Wrap::Repeat, 0.1);
    let base = sphere(12, 6).expect("a mesh");
    for eye in [DVec3::ZERO, DVec3::new(0.3, 0.2, 0.1), DVec3::new(0.0, 0.5, 0.0), DVec3::new(0.5, 0.0, 0.0)]
    {
        let camera = Camera::new(eye, DVec3::new(0.6, 0.3, 0.2), 60.0).expect("a camera");
        for interior in interiors() {
            let view = View { near_m: 0.1, ..seen(camera, 100, 3.0) };
            let settings = MeshSettings { interior, ..MeshSettings::seen_by(view) };
            let mesh = Mesher::new(&base, &map, &settings).expect("a mesh").mesh().expect("finite");
            let cracks = CrackTest::of_mesh(&mesh);
            assert!(cracks.is_closed() && cracks.pieces == 1, "{eye}: {cracks:?}");
        }
    }
}

#[test]
fn spot_has_no_crack_but_its_own() {
    let Some(base) = relief_tests::spot("spot_triangulated.obj") else { return };
    let was = CrackTest::of_mesh(&base);
    let map = map("natural 128x128", Wrap::Repeat, 0.03);
    for (at, camera) in cameras(12).enumerate() {
        // It is larger than the built-in shapes.
        let camera = camera.moved(camera.eye() * 2.5, DVec3::ZERO).expect("a camera");
        let view = seen(camera, 300, [1.5, 5.0][at % 2]);
        let mesh = Mesher::new(&base, &map, &MeshSettings::seen_by(view)).expect("a mesh").mesh();
        let cracks = CrackTest::of_mesh(&mesh.expect("finite"));
        assert_eq!((cracks.open, cracks.branching, cracks.pieces), (was.open, was.branching, was.pieces));
    }
}

/// Corners of ten triangles around a point, and two whose sweeps go other ways, as in figure 4 of the paper.
fn fan(spokes: u32) -> Mesh {
    let vertex = |position: DVec3| Vertex {
        position: position.as_vec3(),
        normal: Vec3::Y,
        tangent: Vec3::X,
        bitangent: Vec3::Z,
        uv: (DVec2::new(position.x, position.z) + 0.5).as_vec2(),
    };
    let around = (0..spokes).map(|k| {
        let (sine, cosine) = (f64::from(k) / f64::from(spokes) * std::f64::consts::TAU).sin_cos();
        vertex(DVec3::new(0.5 * cosine, 0.2 * (2.0 * sine).sin(), 0.5 * sine))
    });
    let vertices = [vertex(DVec3::Y * 0.3)].into_iter().chain(around).collect();
    let triangles = (0..spokes).map(|k| [0, (k + 1) % spokes + 1, k + 1]).collect();
    Mesh::new(vertices, triangles).expect("a mesh")
}

/// Parts of an edge, counted from the longest of its three ways in grid space.
fn parts_of(base: &Mesh, view: &View, ends: [u32; 2]) -> u64 {
    let camera = view.camera;
    let voxels = ends.map(|end| {
        let from_eye = base.vertices()[end as usize].position.as_dvec3() - camera.eye();
        let depth = from_eye.dot(camera.forward());
        let size = 2.0 * camera.half_height() / f64::from(view.size[1]) * view.pixels;
        let half = f64::from(view.size[0]) / 2.0 / view.pixels;
        let (share, away) = if camera.is_orthographic() {
            (1.0, depth / size)
        } else {
            (1.0 / depth, (depth / view.near_m).ln() / (1.0 + size).ln())
        };
        let [right, down] = [from_eye.dot(camera.right()), -from_eye.dot(camera.up())];
        [right / size * share + half, down / size * share + half, away].map(f64::round)
    });
    (0..3).map(|axis| (voxels[1][axis] - voxels[0][axis]).abs()).fold(1.0, f64::max) as u64
}

#[test]
fn corners_of_ten_triangles_and_other_remeshing_planes_meet() {
    let map = map("needles in a pit 64x64", Wrap::Clamp, 0.1);
    for spokes in [3, 4, 10] {
        let base = fan(spokes);
        for (at, camera) in cameras(30).enumerate() {
            for interior in interiors() {
                let view = seen(camera, 300, [1.0, 2.0, 7.0][at % 3]);
                let settings = MeshSettings { interior, ..MeshSettings::seen_by(view) };
                let mesh = Mesher::new(&base, &map, &settings).expect("a mesh").mesh().expect("finite");
                let cracks = CrackTest::of_mesh(&mesh);
                // Open along the rim alone: each triangle by itself is open along its spokes, too.
                let alone = |k: u32| {
                    let corners = base.triangles()[k as usize];
                    let one = Mesh::new(base.vertices().to_vec(), vec![corners]).expect("a mesh");
                    let mesh = Mesher::new(&one, &map, &settings).expect("a mesh").mesh().expect("finite");
                    CrackTest::of_mesh(&mesh).open
                };
                let parts: u64 = (0..spokes).map(alone).sum();
                let of_spokes: u64 = (0..spokes).map(|k| parts_of(&base, &view, [0, k + 1])).sum();
                assert_eq!((cracks.branching, cracks.pieces), (0, 1), "{camera:?}");
                assert_eq!(cracks.open, parts - 2 * of_spokes, "{camera:?}");
            }
        }
    }
}

#[test]
fn points_lie_on_the_base_and_as_far_apart_in_the_picture_as_voxels() {
    let level = HeightMap::from_fn(64, 64, Wrap::Repeat, |_, _| 0.0).expect("a valid map");
    let level = level.with_displacement(0.0, 0.0).expect("lengths");
    let base = Builtin::Plane.build([1.0, 1.0]).expect("a mesh");
    for (at, camera) in cameras(24).enumerate() {
        if camera.eye().y.abs() < 0.2 {
            continue;
        }
        let view = seen(camera, 400, [1.0, 5.0][at % 2]);
        let mesh = Mesher::new(&base, &level, &MeshSettings::seen_by(view)).expect("a mesh");
        let mesh = mesh.mesh().expect("finite");
        for vertex in mesh.vertices() {
            // In perspective texture is no other than position.
            let uv = DVec2::new(vertex.position.x.into(), vertex.position.z.into()) + 0.5;
            assert!(
                (uv - vertex.uv.as_dvec2()).length() < 1e-5 && vertex.position.y.abs() < 1e-6,
                "{vertex:?}"
            );
        }
        let pixel = |corner: u32| {
            let from_eye = mesh.vertices()[corner as usize].position.as_dvec3() - camera.eye();
            let depth = if camera.is_orthographic() { 1.0 } else { from_eye.dot(camera.forward()) };
            let per_m = 400.0 / 2.0 / camera.half_height() / depth;
            DVec2::new(from_eye.dot(camera.right()), from_eye.dot(camera.up())) * per_m / view.pixels
        };
        let mut lengths: Vec<f64> = Vec::new();
        for corners in mesh.triangles() {
            let corners = corners.map(pixel);
            lengths.extend((0..3).map(|k| corners[k].distance(corners[(k + 1) % 3])));
        }
        lengths.sort_by(f64::total_cmp);
        // A voxel and its diagonal, stretched by at most the root of 5; corners are rounded to voxels.
        let longest = lengths[lengths.len() - 1];
        let usual = lengths[lengths.len() / 2];
        assert!(longest < 3.3 && usual < 1.6, "{camera:?}: {longest} {usual}");
    }
}

#[test]
fn vertices_are_displaced_as_the_judge_has_it() {
    let map = map("natural 101x67", Wrap::Repeat, 0.1);
    let base = torus(10, 6).expect("a mesh");
    let camera = Camera::new(DVec3::new(0.3, 0.9, 1.2), DVec3::ZERO, 40.0).expect("a camera");
    let mesh = Mesher::new(&base, &map, &MeshSettings::seen_by(seen(camera, 300, 3.0))).expect("a mesh");
    let mesh = mesh.mesh().expect("finite");
    // Each vertex is a displaced base point of one of the triangles, by its texture coordinates.
    let mut checked = 0;
    for vertex in mesh.vertices().iter().step_by(7) {
        let uv = vertex.uv.as_dvec2();
        let nearest = (0..base.triangles().len() as u32).map(|triangle| {
            let corners = base.corners(triangle).map(BasePoint::from);
            let [a, b, c] = [corners[0].uv, corners[1].uv, corners[2].uv];
            let area = (b - a).perp_dot(c - a);
            let weights = [(b - uv).perp_dot(c - uv), (c - uv).perp_dot(a - uv), (a - uv).perp_dot(b - uv)];
            let weights = weights.map(|weight| weight / area);
            if !weights.iter().all(|weight| *weight > -1e-4) {
                return f64::INFINITY;
            }
            let point = BasePoint::weighted(corners, weights);
            let [x, y] = [point.uv.x * f64::from(map.width()), point.uv.y * f64::from(map.height())];
            let expected = point.displaced(map.displacement_m(map.height_at_place(x - 0.5, y - 0.5)));
            expected.distance(vertex.position.as_dvec3())
        });
        let nearest = nearest.fold(f64::INFINITY, f64::min);
        assert!(nearest < 2e-5, "{vertex:?}: {nearest}");
        checked += 1;
    }
    assert!(checked > 500, "{checked}");
}

#[test]
fn coarse_points_have_the_heights_of_the_level_that_is_as_coarse() {
    let map = map("natural 128x128", Wrap::Clamp, 0.2);
    let base = Builtin::Plane.build([1.0, 1.0]).expect("a mesh");
    // From above, parallel: a voxel is as wide everywhere.
    let camera = Camera::with(DVec3::Y, DVec3::ZERO, Projection::Orthographic { height_m: 1.0 });
    let camera = camera.expect("a camera");
    let levels = coarser(&map, Filter::Max);
    let made = |pixels: f64, levels: &[HeightMap]| {
        let settings = MeshSettings::seen_by(seen(camera, 512, pixels));
        let mesher = Mesher::with_levels(&base, &map, levels, &settings, &Watch::none()).expect("a mesh");
        mesher.mesh().expect("finite")
    };
    // Four pixels are a texel.
    let [with, without] = [made(4.0, &levels), made(4.0, &[])];
    let positions = |mesh: &Mesh| -> Vec<Vec3> { mesh.vertices().iter().map(|at| at.position).collect() };
    assert_eq!(positions(&with), positions(&without));
    let height = |map: &HeightMap, vertex: &Vertex| {
        let [x, y] = [vertex.uv.x * map.width() as f32, vertex.uv.y * map.height() as f32];
        map.height_at_place(f64::from(x) - 0.5, f64::from(y) - 0.5)
    };
    for (pixels, level) in [(8.0, 1.0_f64), (16.0, 2.0), (12.0, 1.584_962_5), (64.0, 4.0)] {
        for vertex in made(pixels, &levels).vertices() {
            let of = |level: f64| if level < 1.0 { &map } else { &levels[level as usize - 1] };
            let [fine, coarse] = [of(level.floor()), of(level.ceil())].map(|map| height(map, vertex));
            let expected = map.displacement_m(fine + (coarse - fine) * level.fract());
            let found = f64::from(vertex.position.y);
            assert!((found - expected).abs() < 1e-5, "{pixels}: {vertex:?} is not at {expected}");
            // The maximum is nowhere below the relief.
            assert!(found >= map.displacement_m(height(&map, vertex)) - 1e-5);
        }
    }
    // What is seen at a fixed distance of texels has no levels.
    let found = Mesher::with_levels(&base, &map, &levels, &MeshSettings::default(), &Watch::none());
    assert!(matches!(found, Err(MesherError::LevelsOfNoView { .. })));
}

#[test]
fn weights_move_points_to_slopes_and_silhouettes_without_a_crack() {
    let bumps = map("natural 101x67", Wrap::Repeat, 0.08);
    let level = map("constant half 16x9", Wrap::Repeat, 0.08);
    let base = sphere(16, 8).expect("a mesh");
    let camera = Camera::new(DVec3::new(0.0, 0.3, 2.0), DVec3::ZERO, 40.0).expect("a camera");
    let dice = INTERIORS.iter().find(|interior| interior.takes.contains(&Spacing::Even)).expect("listed");
    let plain = MeshSettings { interior: dice, ..MeshSettings::seen_by(seen(camera, 300, 2.0)) };
    let made = |map: &HeightMap, weights: Weights| {
        let settings = MeshSettings { weights, ..plain };
        let mesh = Mesher::new(&base, map, &settings).expect("a mesh").mesh().expect("finite");
        let cracks = CrackTest::of_mesh(&mesh);
        assert!(cracks.is_closed() && cracks.pieces == 1, "{weights:?}: {cracks:?}");
        mesh
    };
    let count = |mesh: &Mesh| mesh.triangles().len();
    let steep = Weights { slope: 4.0, ..Weights::NONE };
    let varied = Weights { variation: 2.0, ..Weights::NONE };
    let usual = count(&made(&bumps, Weights::NONE));
    let finer = [steep, varied].map(|weights| count(&made(&bumps, weights)));
    println!("{usual} {finer:?}");
    assert!(finer.iter().all(|finer| *finer > usual + usual / 10));
    // Where there is no relief there is nothing to be finer for.
    assert_eq!(count(&made(&level, steep)), count(&made(&level, Weights::NONE)));
    assert_eq!(count(&made(&level, varied)), count(&made(&level, Weights::NONE)));
    // At the silhouette as fine as before, and coarse in the middle.
    let around = |mesh: &Mesh, is_rim: bool| {
        let vertices = mesh.vertices().iter().filter(|vertex| {
            let normal = vertex.normal.as_dvec3();
            let toward = (camera.eye() - vertex.position.as_dvec3()).normalize();
            (normal.dot(toward).abs() < 0.3) == is_rim
        });
        vertices.count() as f64
    };
    let outlined = made(&level, Weights { silhouette: 1.0, ..Weights::NONE });
    let whole = made(&level, Weights::NONE);
    let [rim, middle] = [true, false].map(|rim| around(&outlined, rim) / around(&whole, rim));
    assert!(rim > 3.0 * middle && rim > 0.5, "{rim} {middle}");
    for weights in [
        Weights { silhouette: 1.1, ..Weights::NONE },
        Weights { slope: -1.0, ..Weights::NONE },
        Weights { variation: f64::NAN, ..Weights::NONE },
    ] {
        let found = Mesher::new(&base, &level, &MeshSettings { weights, ..plain });
        assert!(matches!(found, Err(MesherError::BadWeights { .. })));
    }
    let swept = MeshSettings { weights: steep, ..MeshSettings::seen_by(seen(camera, 300, 2.0)) };
    assert!(matches!(Mesher::new(&base, &level, &swept), Err(MesherError::Weighted { .. })));
}

#[test]
fn planes_are_one_sheet_and_their_parts_meet() {
    for name in ["natural 101x67", "one texel", "one row 1x29"] {
        let map = map(name, Wrap::Clamp, 0.1);
        let base = Builtin::Plane.build(map.proportions()).expect("a mesh");
        for camera in cameras(8) {
            let settings = MeshSettings::seen_by(seen(camera, 300, 2.0));
            let whole = Mesher::new(&base, &map, &settings).expect("a mesh").mesh().expect("finite");
            let cracks = CrackTest::of_mesh(&whole);
            assert_eq!((cracks.branching, cracks.pieces), (0, 1), "{name}");
        }
    }
    let map = map("white noise 128x128", Wrap::Clamp, 0.1);
    let base = Builtin::Plane.build(map.proportions()).expect("a mesh").tiled(Vec2::new(2.7, 1.9));
    let base = base.expect("a mesh");
    for camera in cameras(6) {
        let settings = MeshSettings::seen_by(seen(camera, 300, 2.0));
        let mut triangles = Vec::new();
        let mut alone = 0;
        for at in [[0, 0], [1, 0], [0, 1], [1, 1]] {
            let part = Part { of: [2, 2], at };
            let mesh = Mesher::new(&base, &map, &MeshSettings { part, ..settings }).expect("a mesh");
            let mesh = mesh.mesh().expect("finite");
            alone += CrackTest::of_mesh(&mesh).open;
            let corner = |corner: u32| mesh.vertices()[corner as usize].position;
            triangles.extend(mesh.triangles().iter().map(|corners| corners.map(corner)));
        }
        let cracks = CrackTest::of_triangles(triangles);
        assert_eq!((cracks.branching, cracks.pieces), (0, 1));
        assert!(cracks.open < alone, "{} {alone}", cracks.open);
    }
}

#[test]
fn what_cannot_be_seen_is_refused() {
    let map = map("natural 101x67", Wrap::Clamp, 0.1);
    let base = Builtin::Plane.build(map.proportions()).expect("a mesh");
    let camera = Camera::new(DVec3::ONE, DVec3::ZERO, 40.0).expect("a camera");
    let settings = MeshSettings::seen_by(View::new(camera, [300, 200]));
    let refused = |settings: &MeshSettings| Mesher::new(&base, &map, settings).expect_err("it is refused");
    assert!(matches!(refused(&MeshSettings { view: None, ..settings }), MesherError::NoView { .. }));
    assert!(matches!(refused(&MeshSettings { solid_m: Some(0.1), ..settings }), MesherError::SolidOfView));
    let finer = View { pixels: 2e-3, ..View::new(camera, [300, 200]) };
    let found = Mesher::new(&base, &map, &MeshSettings::seen_by(finer));
    assert!(matches!(found, Err(MesherError::TooLarge { .. })));
    let kept = MeshSettings { seams: Seams::Keep, ..settings };
    assert!(Mesher::new(&base, &map, &kept).is_ok());
}
