use std::collections::BTreeSet;
use std::sync::atomic::AtomicBool;

use glam::{DVec3, Vec3};
use relief_core::mesh::{Mesh, cube, cylinder, sphere, square, torus};
use relief_core::{ByteSize, HeightMap, Wrap};
use relief_maps::{Maps, Watch};
use relief_mesh::{CrackTest, EDGE_RULES, MeshSettings, Mesher, View, interior};
use relief_shaders::Selection;

use super::*;
use crate::Renderer;
use crate::camera::Camera;
use crate::prepare::Preparer;
use crate::scene::{Scene, Surface};

/// A map of 48x32 texels under a mesh, tessellated.
pub fn surface_of(mesh: Mesh, pixels: f64) -> Surface {
    let texel = |i: u32, j: u32| ((i * 7 + j * j * 3 + i * j) % 29) as f32 / 28.0;
    let map = HeightMap::from_fn(48, 32, Wrap::Repeat, texel).expect("a map");
    let map = map.with_displacement(0.06, -0.02).expect("lengths");
    let mut selection = Selection::method("tessellate").expect("a method");
    selection.set("geometry.pixels", pixels).expect("a parameter");
    selection.choose("shadow", "none").expect("a shadow");
    Surface::new(Arc::new(mesh), Arc::new(map)).with_selection(selection)
}

/// A scene that looks from there to the middle, of which nothing is left out unless it says so.
pub fn scene_of(surface: Surface, eye: [f64; 3], culls: bool) -> Scene {
    let camera = Camera::new(DVec3::from(eye), DVec3::ZERO, 45.0).expect("a camera");
    let builder = Scene::builder(surface).camera(camera).size(96, 64).samples(1).culls(culls);
    builder.build().expect("a scene")
}

/// The job of a scene.
pub fn job_of(scene: &Scene) -> Job {
    let mut preparer = Preparer::default();
    let mut maps = Maps::in_memory();
    preparer.provide(scene, &mut maps, &|_| false, &Watch::none()).expect("no maps");
    preparer.job(scene, &AtomicBool::new(false)).expect("a job")
}

/// The triangles of its first surface.
pub fn made(job: &Job) -> Arc<Triangles> {
    Arc::clone(&KeptTessellated::default().job(job).surfaces[0].triangles)
}

fn closed() -> [Mesh; 4] {
    [cube(1), cylinder(9, 3), sphere(10, 5), torus(12, 7)].map(|mesh| mesh.expect("a mesh"))
}

fn positions(triangles: &Triangles) -> Vec<[Vec3; 3]> {
    let position = |corner: Corner| Vec3::from([corner.position.x, corner.position.y, corner.position.z]);
    triangles.iter().map(|of| [of.a, of.b, of.c].map(position)).collect()
}

fn tessellator_of(job: &Job) -> Tessellator<'_> {
    let surface = &job.surfaces[0];
    let grid = surface.triangles.tessellation().expect("it is to be tessellated").grid;
    Tessellator::new(&surface.bound(surface.settings, job.frame, None), grid)
}

/// The weights of a point of a triangle whose sides have so many parts.
fn weights(point: relief_shaders::cpu::DicePoint, parts: [u32; 3]) -> [f64; 3] {
    if point.side == INSIDE {
        return [point.weights.x, point.weights.y, point.weights.z].map(f64::from);
    }
    let side = point.side as usize;
    let part = f64::from(point.at) / f64::from(parts[side]);
    let mut weights = [0.0; 3];
    weights[side] = 1.0 - part;
    weights[(side + 1) % 3] = part;
    weights
}

#[test]
fn triangles_found_by_their_numbers_tile_the_whole_and_use_every_point() {
    let job = job_of(&scene_of(surface_of(square(1).expect("a mesh"), 1.0), [0.0, 2.0, 0.1], false));
    let tessellator = tessellator_of(&job);
    for code in 0..13u32.pow(3) {
        let parts = [code % 13 + 1, code / 13 % 13 + 1, code / 169 + 1];
        let rows = tessellator.rows(parts);
        let (mut area, mut borders, mut inner) = (0.0, BTreeSet::new(), BTreeSet::new());
        for number in 0..tessellator.triangles(rows) {
            let cut = tessellator.triangle(rows, number);
            let points = [cut.a, cut.b, cut.c].map(|place| tessellator.point(rows, place));
            let [a, b, c] = points.map(|point| weights(point, parts));
            let twice = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
            assert!(twice > 1e-5, "{parts:?}: a piece of area {twice}");
            area += twice;
            for point in points {
                if point.side == INSIDE {
                    inner.insert(point.at);
                    let again = tessellator.point(rows, tessellator.place(rows, point.at));
                    assert_eq!(again, point, "{parts:?}");
                } else {
                    borders.insert((point.side, point.at));
                }
            }
        }
        assert!((area - 1.0).abs() < 1e-5, "{parts:?}: {area}");
        assert_eq!(borders.len() as u32, parts.iter().sum::<u32>(), "{parts:?}");
        assert!(inner.into_iter().eq(0..tessellator.points(rows)), "{parts:?}");
    }
}

#[test]
fn numbers_of_large_patterns_lead_where_counting_does() {
    let job = job_of(&scene_of(surface_of(square(1).expect("a mesh"), 1.0), [0.0, 2.0, 0.1], false));
    let tessellator = tessellator_of(&job);
    let most = 32_767;
    for parts in [[most, most, most], [most, 1, most], [1, most, 2], [most, 20_011, 30_013], [907, 5, 1000]] {
        let rows = tessellator.rows(parts);
        let (triangles, points) = (tessellator.triangles(rows), tessellator.points(rows));
        // Every inner point has as many triangles as twice its angles, every point of a side half of that.
        let border: u32 = parts.iter().sum();
        assert_eq!(triangles, 2 * points + border - 2, "{parts:?}");
        for number in (0..triangles).step_by(triangles as usize / 1000 + 1).chain([triangles - 1]) {
            let cut = tessellator.triangle(rows, number);
            let corners = [cut.a, cut.b, cut.c].map(|place| tessellator.point(rows, place));
            let [a, b, c] = corners.map(|point| weights(point, parts));
            let twice = (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1]);
            let inside = corners.iter().all(|point| point.side != INSIDE || point.at < points);
            // In 32 bits narrow ones may come out without an area.
            assert!(inside && twice > -1e-7, "{parts:?} {number}: {twice}");
        }
        for number in (0..points).step_by(points as usize / 1000 + 1) {
            let point = tessellator.point(rows, tessellator.place(rows, number));
            assert_eq!((point.side, point.at), (INSIDE, number), "{parts:?}");
        }
    }
}

#[test]
fn triangles_are_those_of_the_mesher_in_64_bits() {
    let eyes = [[1.3, 0.9, 1.1], [-0.4, 1.7, 0.3], [0.2, -0.1, 2.3]];
    let (mut least, mut whole) = (1.0f64, 0);
    for (mesh, eye) in closed().into_iter().flat_map(|mesh| eyes.map(|eye| (mesh.clone(), eye))) {
        let scene = scene_of(surface_of(mesh.clone(), 2.0), eye, false);
        let job = job_of(&scene);
        let triangles = made(&job);
        let grid = job.surfaces[0].triangles.tessellation().expect("one").grid;
        let near_m = f64::from(grid.near_m);
        let view = View { pixels: 2.0, near_m, ..View::new(*scene.camera(), scene.size()) };
        let pixels = EDGE_RULES.iter().find(|rule| rule.name == "pixels").expect("a rule");
        let dice = interior("dice").expect("an interior");
        let settings = MeshSettings { edges: pixels, interior: dice, ..MeshSettings::seen_by(view) };
        let mesher = Mesher::new(&mesh, scene.surfaces()[0].height_map(), &settings).expect("a mesh");
        let exact = mesher.mesh().expect("a mesh");
        let [own, other] = [triangles.len(), exact.triangles().len()].map(|count| count as f64);
        assert!((own / other - 1.0).abs() < 0.02, "{own} {other}");
        let three = |of: relief_shaders::cpu::Vec3<f32>| Vec3::from([of.x, of.y, of.z]);
        let is_known = |corner: &&Corner| {
            let (position, normal) = (three(corner.position), three(corner.normal));
            exact
                .vertices()
                .iter()
                .any(|vertex| position.distance(vertex.position) < 2e-6 && normal.dot(vertex.normal) > 0.999)
        };
        // A vertex that lies between two voxels may be taken for one in the other: then sides that end there
        // may have another number of parts.
        let known = triangles.corners().par_iter().filter(is_known).count() as f64;
        least = least.min(known / triangles.corners().len() as f64);
        whole += u32::from(known as usize == triangles.corners().len());
    }
    assert!(least > 0.99 && whole >= 6, "{least} {whole}");
}

#[test]
fn no_view_opens_a_closed_base() {
    let mut seed = 1u32;
    let mut random = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(seed >> 8) / f64::from(1 << 24)
    };
    for mesh in closed() {
        for _ in 0..25 {
            let toward = DVec3::new(random() - 0.5, random() - 0.5, random() - 0.5).normalize();
            let eye = toward * (0.3 + 3.0 * random() * random());
            let surface = surface_of(mesh.clone(), 1.0 + 3.0 * random());
            let triangles = made(&job_of(&scene_of(surface, eye.to_array(), false)));
            let cracks = CrackTest::of_triangles(positions(&triangles));
            assert!(cracks.is_closed(), "{eye}: {cracks:?}");
        }
    }
    // A point moved by one step of its numbers is noticed.
    let triangles = made(&job_of(&scene_of(surface_of(torus(12, 7).expect("a mesh"), 2.0), [1.0; 3], false)));
    let mut positions = positions(&triangles);
    positions[17][1].x = positions[17][1].x.next_up();
    assert!(!CrackTest::of_triangles(positions).is_closed());
}

#[test]
fn with_less_room_the_grid_is_coarser_and_nothing_is_dropped() {
    let scene = scene_of(surface_of(torus(12, 7).expect("a mesh"), 1.0), [1.2, 0.8, 0.9], false);
    let whole = made(&job_of(&scene)).len();
    let mut before = whole;
    for kilobytes in [1500, 600, 300] {
        let memory = ByteSize(kilobytes << 10);
        let scene = scene.to_builder().geometry_memory(memory).build().expect("a scene");
        let job = job_of(&scene);
        let most = job.surfaces[0].triangles.tessellation().expect("one").grid.most_triangles;
        let triangles = made(&job);
        assert!(triangles.len() < before && triangles.len() <= most as usize, "{kilobytes}: {before}");
        assert!(CrackTest::of_triangles(positions(&triangles)).is_closed(), "{kilobytes}");
        before = triangles.len();
    }
    assert!(before * 4 < whole);
    let none = scene.to_builder().geometry_memory(ByteSize(20 << 10)).build().expect("a scene");
    let mut preparer = Preparer::default();
    preparer.provide(&none, &mut Maps::in_memory(), &|_| false, &Watch::none()).expect("no maps");
    let refused = preparer.job(&none, &AtomicBool::new(false)).expect_err("no room").to_string();
    assert!(refused.contains("geometry.pixels"), "{refused}");
}

#[test]
fn what_is_left_out_is_not_seen() {
    // There is room for all of it: with less, the whole would be coarser than what is left of it.
    let surface = surface_of(torus(24, 12).expect("a mesh"), 4.0);
    let [whole, seen] = [false, true].map(|culls| scene_of(surface.clone(), [0.6, 0.1, 0.2], culls));
    let [all, few] = [&whole, &seen].map(|scene| made(&job_of(scene)).len());
    assert!(few * 4 < all * 3 && few > 0, "{few} of {all}");
    let mut renderer = Renderer::on_cpu();
    let [whole, seen] = [whole, seen].map(|scene| {
        renderer.render(&scene, &mut Maps::in_memory(), &|_, _| ()).expect("a picture").rendering
    });
    assert!(whole.pixels.iter().any(|pixel| pixel.hit == 1));
    for (a, b) in whole.pixels.iter().zip(&seen.pixels) {
        assert_eq!((a.color, a.position, a.depth, a.hit), (b.color, b.position, b.depth, b.hit));
    }
}
