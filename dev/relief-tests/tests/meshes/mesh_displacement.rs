//! Vertices of displaced meshes lie where an evaluation of its own says, and their normals are the surface's.

use std::sync::atomic::AtomicBool;

use glam::{DVec2, DVec3};
use relief_core::exact::{DisplacedMesh, Sides};
use relief_core::mesh::{Builtin, Mesh, Vertex, cube, sphere, square, torus};
use relief_core::{HeightMap, Watch, Wrap};
use relief_mesh::{
    BaseSurface, Directions, MeshSettings, Mesher, MesherError, Seams, Shading, Stream, StreamError,
};
use relief_testing::maps;
use relief_testing::smooth_base::{curved_point, lift_m, mean_on_sphere};

/// The bilinear height, written down from the conventions alone.
fn height(map: &HeightMap, uv: DVec2) -> f64 {
    let [x, y] = [uv.x * f64::from(map.width()) - 0.5, uv.y * f64::from(map.height()) - 0.5];
    let texel = |i: f64, j: f64| f64::from(map.texel(i as i64, j as i64));
    let (i, j) = (x.floor(), y.floor());
    let [fx, fy] = [x - i, y - j];
    (1.0 - fy) * ((1.0 - fx) * texel(i, j) + fx * texel(i + 1.0, j))
        + fy * ((1.0 - fx) * texel(i, j + 1.0) + fx * texel(i + 1.0, j + 1.0))
}

fn displaced(map: HeightMap, scale_m: f64, bias_m: f64) -> HeightMap {
    map.with_displacement(scale_m, bias_m).expect("lengths")
}

fn mesh_of(base: &Mesh, map: &HeightMap, settings: &MeshSettings) -> Mesh {
    Mesher::new(base, map, settings).expect("a mesh").mesh().expect("finite")
}

#[test]
fn vertices_of_a_plane_are_texel_centres_at_their_heights() {
    for named in maps::ALL {
        for wrap in Wrap::ALL {
            let map = displaced(named.build(wrap), 0.2, -0.05);
            let [across, down] = map.proportions();
            let base = Builtin::Plane.build([across, down]).expect("a mesh");
            let mesh = mesh_of(&base, &map, &MeshSettings::default());
            let mut centres = 0;
            for vertex in mesh.vertices() {
                let place = |along: f32, side: f64, texels: u32| {
                    let place = (f64::from(along) / side + 0.5) * f64::from(texels);
                    // Where the vertex has to be: on a centre, or the border.
                    let whole = (place - 0.5).round() + 0.5;
                    let exact = if place < 0.25 { 0.0 } else { whole.min(f64::from(texels)) };
                    let exact = if place > f64::from(texels) - 0.25 { f64::from(texels) } else { exact };
                    assert!((place - exact).abs() < 1e-3, "{} {place}", named.name);
                    exact
                };
                let p = vertex.position;
                let x = place(p.x, across, map.width());
                let y = place(p.z, down, map.height());
                centres += u64::from(x.fract() == 0.5 && y.fract() == 0.5);
                let uv = DVec2::new(x / f64::from(map.width()), y / f64::from(map.height()));
                let expected = -0.05 + 0.2 * height(&map, uv);
                assert!(
                    (f64::from(p.y) - expected).abs() <= 1e-7 * expected.abs().max(0.05),
                    "{}",
                    named.name
                );
                assert_eq!(vertex.uv, uv.as_vec2());
            }
            assert_eq!(centres, u64::from(map.width()) * u64::from(map.height()), "{}", named.name);
        }
    }
}

/// Each vertex of a mesh over one triangle, with its barycentric weights.
fn over_a_triangle(base: &Mesh, mesh: &Mesh) -> Vec<(Vertex, [f64; 3])> {
    let uvs = base.corners(0).map(|corner| corner.uv.as_dvec2());
    let [a, b, c] = uvs;
    let area = (b - a).perp_dot(c - a);
    let weights = |uv: DVec2| {
        let second = (uv - a).perp_dot(c - a) / area;
        let third = (b - a).perp_dot(uv - a) / area;
        [1.0 - second - third, second, third]
    };
    mesh.vertices().iter().map(|vertex| (*vertex, weights(vertex.uv.as_dvec2()))).collect()
}

#[test]
fn vertices_are_where_an_evaluation_of_its_own_says() {
    let whole = torus(7, 5).expect("a mesh");
    for (at, named) in maps::ALL.iter().enumerate() {
        for wrap in Wrap::ALL {
            let map = displaced(named.build(wrap), 0.06, -0.02);
            let corners = whole.triangles()[at % whole.triangles().len()];
            let vertices = corners.map(|corner| whole.vertices()[corner as usize]);
            let base = Mesh::new(vertices.to_vec(), vec![[0, 1, 2]]).expect("a mesh");
            for (base_surface, directions) in [
                (BaseSurface::Flat, Directions::Raw),
                (BaseSurface::Lift, Directions::Unit),
                (BaseSurface::Pn, Directions::Raw),
                (BaseSurface::Flat, Directions::Angle),
            ] {
                let settings = MeshSettings { base: base_surface, directions, ..MeshSettings::default() };
                let mesh = mesh_of(&base, &map, &settings);
                assert!(mesh.vertices().len() >= 3);
                for (vertex, w) in over_a_triangle(&base, &mesh) {
                    let sum = |of: &dyn Fn(&Vertex) -> DVec3| {
                        of(&vertices[0]) * w[0] + of(&vertices[1]) * w[1] + of(&vertices[2]) * w[2]
                    };
                    let mut normal = sum(&|vertex| vertex.normal.as_dvec3());
                    let mut metres = -0.02 + 0.06 * height(&map, vertex.uv.as_dvec2());
                    match directions {
                        Directions::Raw => {}
                        Directions::Unit => normal = normal.normalize(),
                        Directions::Angle => {
                            normal = mean_on_sphere(vertices.map(|of| of.normal.as_dvec3()), w);
                        }
                    }
                    if base_surface == BaseSurface::Lift {
                        metres += lift_m(&vertices, w);
                    }
                    let base = match base_surface {
                        BaseSurface::Pn => curved_point(&vertices, w),
                        _ => sum(&|vertex| vertex.position.as_dvec3()),
                    };
                    let expected = base + metres * normal;
                    let error = (vertex.position.as_dvec3() - expected).length();
                    // Texture coordinates are rounded, and steep maps show it.
                    let steep = relief_testing::steepest(&map) * 0.06 * 64.0 * 2e-7;
                    assert!(error < 1.5e-7 + steep, "{} {wrap}: {error:e}", named.name);
                }
            }
        }
    }
}

#[test]
fn the_exact_tracer_hits_the_vertices() {
    let map = maps::ALL.iter().find(|map| map.name == "natural 128x128").expect("it is listed");
    let map = displaced(map.build(Wrap::Repeat), 0.05, 0.01);
    let base = torus(24, 12).expect("a mesh");
    let judge = DisplacedMesh::new(&base, &map, map.scale_m(), map.bias_m()).expect("lengths");
    let mesh = mesh_of(&base, &map, &MeshSettings { texels: 3, ..MeshSettings::default() });
    let mut met = 0;
    for vertex in mesh.vertices().iter().step_by(37) {
        let (position, normal) = (vertex.position.as_dvec3(), vertex.normal.as_dvec3());
        let origin = position + 1e-3 * normal;
        let hit = judge.first_hit(origin.to_array(), (-normal).to_array(), Sides::Both);
        met += usize::from(hit.is_some_and(|hit| (hit.t - 1e-3).abs() < 1e-6));
    }
    let all = mesh.vertices().len().div_ceil(37);
    // Where it is folded something else may be nearer.
    assert!(met * 100 >= all * 99, "{met} of {all}");
}

/// A mesh of one square plane, and one of the same square that is no plane but four triangles.
fn squares() -> [Mesh; 2] {
    [1, 2].map(|divisions| square(divisions).expect("a mesh"))
}

#[test]
fn exact_normals_are_those_of_differences() {
    let map = maps::ALL.iter().find(|map| map.name == "natural 128x128").expect("it is listed");
    let map = displaced(map.build(Wrap::Repeat), 0.1, 0.0);
    // On level ground with right angles two rotations are as good.
    for (base, shading) in squares().into_iter().flat_map(|base| {
        [Shading::Exact, Shading::Derivative, Shading::Rotation].map(|shading| (base.clone(), shading))
    }) {
        let mesh = mesh_of(&base, &map, &MeshSettings { shading, ..MeshSettings::default() });
        for vertex in mesh.vertices() {
            let at = |du: f64, dv: f64| {
                let uv = vertex.uv.as_dvec2() + DVec2::new(du, dv);
                DVec3::new(uv.x, 0.1 * height(&map, uv), uv.y)
            };
            let step = 1e-5;
            let [along, down] = [at(step, 0.0) - at(-step, 0.0), at(0.0, step) - at(0.0, -step)];
            let angle = down.cross(along).angle_between(vertex.normal.as_dvec3()).to_degrees();
            // Where a border halves a cell, texture coordinates that are rounded decide on which side of it.
            assert!(angle < 0.01, "{angle} degrees at {}", vertex.uv);
        }
    }
}

#[test]
fn an_even_slope_has_one_normal_up_to_the_edge_of_a_clamped_map() {
    let slope = |i: u32, j: u32| 0.2 + (3.0 * i as f32 + 2.0 * j as f32) / 64.0;
    let map = displaced(HeightMap::from_fn(9, 7, Wrap::Clamp, slope).expect("a valid map"), 1.0, 0.0);
    let expected = DVec3::new(-27.0 / 64.0, 1.0, -14.0 / 64.0).normalize();
    for base in squares() {
        for texels in [1, 2] {
            let mesh = mesh_of(&base, &map, &MeshSettings { texels, ..MeshSettings::default() });
            for vertex in mesh.vertices() {
                let off = vertex.normal.as_dvec3().angle_between(expected);
                assert!(off < 1e-4, "{off} rad at {}", vertex.uv);
            }
        }
    }
}

#[test]
fn exact_normals_of_a_curved_base_are_those_of_the_smooth_shape() {
    let hills = |i: u32, j: u32| {
        let [u, v] = [i, j].map(|at| (f64::from(at) + 0.5) / 256.0 * std::f64::consts::TAU);
        (0.5 + 0.25 * ((5.0 * u).sin() + (4.0 * v).cos())) as f32
    };
    let map = HeightMap::from_fn(256, 256, Wrap::Repeat, hills).expect("a valid map");
    let map = displaced(map, 0.05, 0.0);
    let base = torus(128, 64).expect("a mesh");
    for directions in Directions::ALL {
        for dropping in [Shading::Derivative, Shading::Rotation] {
            let off = [Shading::Exact, dropping].map(|shading| {
                let settings =
                    MeshSettings { texels: 2, shading, directions: *directions, ..Default::default() };
                degrees_off_torus(&mesh_of(&base, &map, &settings), &map)
            });
            println!("{directions}: exact {:.3} degrees, {dropping} {:.3}", off[0], off[1]);
            assert!(off[0] < 0.35 && off[1] > 4.0 * off[0], "{directions} {dropping}: {off:?}");
        }
    }
}

#[test]
fn rotations_know_nothing_of_sheared_textures() {
    let map = maps::ALL.iter().find(|map| map.name == "natural 128x128").expect("it is listed");
    let map = displaced(map.build(Wrap::Repeat), 0.1, 0.0);
    let mut vertices = square(2).expect("a mesh").vertices().to_vec();
    for vertex in &mut vertices {
        vertex.uv.x += 0.5 * vertex.uv.y;
        // Along `v` the place goes back along `u`.
        vertex.bitangent -= 0.5 * vertex.tangent;
    }
    let base = Mesh::new(vertices, square(2).expect("a mesh").triangles().to_vec()).expect("a mesh");
    let [exact, derivative, rotation] = [Shading::Exact, Shading::Derivative, Shading::Rotation]
        .map(|shading| mesh_of(&base, &map, &MeshSettings { shading, ..MeshSettings::default() }));
    let most = |other: &Mesh| {
        let each = exact.vertices().iter().zip(other.vertices());
        each.map(|(a, b)| a.normal.as_dvec3().angle_between(b.normal.as_dvec3()).to_degrees())
            .fold(0.0, f64::max)
    };
    assert!(most(&derivative) < 0.01 && most(&rotation) > 5.0, "{} {}", most(&derivative), most(&rotation));
}

/// Greatest angle between the normals of a mesh and of a displaced torus, in degrees, by differences.
fn degrees_off_torus(mesh: &Mesh, map: &HeightMap) -> f64 {
    let mut worst = 0.0_f64;
    for vertex in mesh.vertices() {
        let at = |du: f64, dv: f64| {
            let uv = vertex.uv.as_dvec2() + DVec2::new(du, dv);
            let shape = |uv: DVec2| {
                let around = (uv.x - 0.5) * std::f64::consts::TAU;
                (around, 0.15 + 0.05 * height(map, uv))
            };
            let (around, radius) = shape(uv);
            (around, radius, uv.y)
        };
        // The torus by its own frame: the middle of the tube, and the base's normal there.
        let point = |du: f64, dv: f64| {
            let (around, radius, v) = at(du, dv);
            let middle = DVec3::new(around.sin(), 0.0, around.cos()) * 0.35;
            middle + radius * torus_normal(DVec2::new(vertex.uv.as_dvec2().x + du, v))
        };
        let step = 1e-5;
        let [along, down] = [point(step, 0.0) - point(-step, 0.0), point(0.0, step) - point(0.0, -step)];
        let angle = |normal: DVec3| {
            let angle = down.cross(along).angle_between(normal).to_degrees();
            angle.min(180.0 - angle)
        };
        worst = worst.max(angle(vertex.normal.as_dvec3()));
        let off = (vertex.position.as_dvec3() - point(0.0, 0.0)).length();
        assert!(off < 2e-3, "{off}");
    }
    worst
}

/// The outward normal of a torus of the core's at texture coordinates.
fn torus_normal(uv: DVec2) -> DVec3 {
    let around = (uv.x - 0.5) * std::f64::consts::TAU;
    let tube = (uv.y - 0.5) * std::f64::consts::TAU;
    let outward = DVec3::new(around.sin(), 0.0, around.cos());
    outward * tube.cos() - DVec3::Y * tube.sin()
}

#[test]
fn normals_of_the_mesh_are_those_of_its_triangles() {
    let map = maps::ALL.iter().find(|map| map.name == "natural 101x67").expect("it is listed");
    let map = displaced(map.build(Wrap::Repeat), 0.05, 0.0);
    // A plane whose texture is mirrored.
    let plane = square(1).expect("a mesh");
    let mut vertices = plane.vertices().to_vec();
    vertices.iter_mut().for_each(|vertex| {
        vertex.uv.x = 1.0 - vertex.uv.x;
        vertex.tangent = -vertex.tangent;
    });
    let mirrored = Mesh::new(vertices, plane.triangles().to_vec());
    for base in [sphere(24, 12), cube(1), square(1), mirrored].map(|mesh| mesh.expect("a mesh")) {
        let settings = MeshSettings { shading: Shading::Mesh, texels: 2, ..MeshSettings::default() };
        let mesh = mesh_of(&base, &map, &settings);
        let exact = mesh_of(&base, &map, &MeshSettings { shading: Shading::Exact, ..settings });
        assert_eq!(mesh.triangles(), exact.triangles());
        let mut front = 0;
        for corners in mesh.triangles() {
            let [a, b, c] = corners.map(|corner| &mesh.vertices()[corner as usize]);
            let normal = (b.position - a.position).cross(c.position - a.position);
            front += usize::from([a, b, c].iter().all(|vertex| vertex.normal.dot(normal) > 0.0));
        }
        assert!(front * 100 > mesh.triangles().len() * 97, "{front} of {}", mesh.triangles().len());
        let unit = |vertex: &Vertex| (vertex.normal.length() - 1.0).abs() < 1e-5;
        assert!(mesh.vertices().iter().chain(exact.vertices()).all(unit));
    }
}

#[test]
fn a_cube_that_grows_keeps_its_shape_and_its_hard_edges() {
    let level = HeightMap::from_fn(16, 16, Wrap::Repeat, |_, _| 1.0).expect("a valid map");
    let map = displaced(level, 0.1, 0.0);
    let mesh = mesh_of(&cube(1).expect("a mesh"), &map, &MeshSettings::default());
    for vertex in mesh.vertices() {
        // Faces move out by the displacement, and so do the edges between them.
        let reach = vertex.position.abs().max_element();
        assert!((reach - 0.6).abs() < 1e-6, "{}", vertex.position);
        assert!(vertex.normal.abs().max_element() > 1.0 - 1e-6, "{}", vertex.normal);
    }
    let kept = MeshSettings { seams: Seams::Keep, ..MeshSettings::default() };
    let kept = mesh_of(&cube(1).expect("a mesh"), &map, &kept);
    assert!(kept.vertices().iter().all(|vertex| vertex.position.abs().min_element() < 0.5 + 1e-6));
}

#[test]
fn threads_and_blocks_change_no_bit() {
    let map = maps::ALL.iter().find(|map| map.name == "white noise 128x128").expect("it is listed");
    let map = displaced(map.build(Wrap::Mirror), 0.05, 0.0);
    let plane = Builtin::Plane.build([1.0, 1.0]).expect("a mesh").tiled(glam::Vec2::new(3.3, 2.1));
    for base in [torus(16, 8).expect("a mesh"), cube(1).expect("a mesh"), plane.expect("tiled")] {
        for shading in Shading::ALL {
            let settings = MeshSettings { shading: *shading, ..MeshSettings::default() };
            let of_threads = |threads: usize| {
                let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
                pool.install(|| mesh_of(&base, &map, &settings))
            };
            let alone = of_threads(1);
            assert!(alone == of_threads(2) && alone == of_threads(7));
        }
    }
}

#[test]
fn what_makes_no_mesh_is_refused() {
    let map = displaced(maps::ALL[0].build(Wrap::Repeat), 0.05, 0.0);
    let base = torus(9, 7).expect("a mesh");
    let none = Mesher::new(&base, &map, &MeshSettings { texels: 0, ..MeshSettings::default() });
    assert_eq!(none.err(), Some(MesherError::NoTexels));
    let empty = Mesh::new(Vec::new(), Vec::new()).expect("an empty mesh");
    let none = Mesher::new(&empty, &map, &MeshSettings::default());
    assert_eq!(none.err(), Some(MesherError::Empty));
    // Tiles upon tiles: more points than are counted, found out before any memory is taken.
    for base in [base, square(1).expect("a mesh")] {
        let huge = base.tiled(glam::Vec2::splat(1e6)).expect("finite");
        let none = Mesher::new(&huge, &map, &MeshSettings::default());
        assert!(matches!(none.err(), Some(MesherError::TooLarge { .. })));
    }
}

#[test]
fn a_mesh_ends_when_it_is_cancelled_or_beyond_numbers() {
    let map = displaced(maps::ALL[1].build(Wrap::Repeat), 0.05, 0.0);
    let base = torus(40, 30).expect("a mesh");
    let stream = |map: &HeightMap, stopped: bool| {
        let cancel = AtomicBool::new(stopped);
        let how = Stream {
            size: 1.0,
            check: true,
            grid: None,
            cache_order: false,
            watch: Watch::cancelled_by(&cancel),
        };
        let mesher = Mesher::new(&base, map, &MeshSettings::default()).expect("a mesh");
        mesher.stream(&how, |_| Err::<(), _>("full"))
    };
    assert!(matches!(stream(&map, true), Err(StreamError::Cancelled(_))));
    assert!(matches!(stream(&map, false), Err(StreamError::Sink("full"))));
    let far = displaced(map, 1e39, 0.0);
    assert!(matches!(stream(&far, false), Err(StreamError::NotFinite | StreamError::Sink(_))));
    let far = Mesher::new(&base, &far, &MeshSettings::default()).expect("a mesh");
    assert!(matches!(far.mesh(), Err(StreamError::NotFinite)));
}
