use std::collections::{BTreeSet, HashSet};

use glam::{DVec3, Vec3};
use relief_core::mesh::{Mesh, cube, cylinder, sphere, square, torus};
use relief_core::{ByteSize, HeightMap, Watch, Wrap};
use relief_maps::Maps;
use relief_mesh::{CrackTest, EDGE_RULES, MeshSettings, Mesher, View, interior};
use relief_shaders::Selection;
use relief_shaders::cpu::{DicePoint, Vec3 as Three};

use super::*;
use crate::Renderer;
use crate::prepare::Preparer;
use relief_core::camera::Camera;
use relief_scene::{Scene, Surface};

/// A map of 48x32 texels under a mesh, tessellated; what is set besides.
pub fn surface_of(mesh: Mesh, pixels: f64, set: &[(&str, f64)]) -> Surface {
    let texel = |i: u32, j: u32| ((i * 7 + j * j * 3 + i * j) % 29) as f32 / 28.0;
    let map = HeightMap::from_fn(48, 32, Wrap::Repeat, texel).expect("a map");
    let map = map.with_displacement(0.06, -0.02).expect("lengths");
    let mut selection = Selection::method("tessellate").expect("a method");
    selection.set("geometry.pixels", pixels).expect("a parameter");
    for (key, value) in set {
        selection.set(key, *value).expect("a parameter");
    }
    selection.choose("shadow", "none").expect("a shadow");
    Surface::new(Arc::new(mesh), Arc::new(map)).with_selection(selection)
}

/// Interior rule that fills base triangles with the points of a grid.
pub const SWEPT: &[(&str, f64)] = &[("geometry.interior", 1.0)];

/// Edge rule that divides sides by texels.
pub const BY_TEXELS: &[(&str, f64)] = &[("geometry.texels", 1.0)];

/// Scene that looks from `eye` to the middle. Nothing is culled unless `culls` is set.
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
    preparer.job(scene, &Watch::none()).expect("a job")
}

/// The triangles of its first surface.
pub fn made(job: &Job) -> Arc<Triangles> {
    Arc::clone(&TessellatedCache::default().job(job).surfaces[0].triangles)
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

/// A point of a triangle: its side or [`INSIDE`], its number there, and its weights, which count inside
/// alone.
type Point = (u32, u32, Three<f32>);

fn diced(point: DicePoint) -> Point {
    (point.side, point.at, point.weights)
}

/// Weights of a point of a triangle whose sides have the given numbers of parts.
fn weights((side, at, inside): Point, parts: [u32; 3]) -> [f64; 3] {
    if side == INSIDE {
        return [inside.x, inside.y, inside.z].map(f64::from);
    }
    let side = side as usize;
    let part = f64::from(at) / f64::from(parts[side]);
    let mut weights = [0.0; 3];
    weights[side] = 1.0 - part;
    weights[(side + 1) % 3] = part;
    weights
}

/// Twice the area of a piece as a part of the whole.
fn twice_area(piece: [Point; 3], parts: [u32; 3]) -> f64 {
    let [a, b, c] = piece.map(|point| weights(point, parts));
    (b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])
}

/// Checks that pieces tile a triangle whose sides have the given numbers of parts: no edge is there
/// twice, they use every point of the border and as many inside as said, and their areas add up.
fn assert_tiled(parts: [u32; 3], points: u32, pieces: &[[Point; 3]], least: f64) {
    let border: u32 = parts.iter().sum();
    let number = |(side, at, _): Point| match side {
        INSIDE => border + at,
        side => parts[..side as usize].iter().sum::<u32>() + at,
    };
    let (mut area, mut edges) = (0.0, HashSet::new());
    for piece in pieces {
        let twice = twice_area(*piece, parts);
        assert!(twice >= least, "{parts:?}: a piece of area {twice}");
        area += twice;
        let corners = piece.map(number);
        for k in 0..3 {
            assert!(edges.insert([corners[k], corners[(k + 1) % 3]]), "{parts:?}: an edge twice");
        }
    }
    assert!((area - 1.0).abs() < 1e-5, "{parts:?}: {area}");
    let open: BTreeSet<[u32; 2]> =
        edges.iter().filter(|[a, b]| !edges.contains(&[*b, *a])).copied().collect();
    let around = (0..border).map(|at| [at, (at + 1) % border]);
    assert!(open.into_iter().eq(around), "{parts:?}");
    let used: BTreeSet<u32> = edges.iter().map(|[a, _]| *a).collect();
    assert!(used.into_iter().eq(0..border + points), "{parts:?}");
}

#[test]
fn triangles_found_by_their_numbers_tile_the_whole_and_use_every_point() {
    let job = job_of(&scene_of(surface_of(square(1).expect("a mesh"), 1.0, &[]), [0.0, 2.0, 0.1], false));
    let tessellator = tessellator_of(&job);
    for code in 0..13u32.pow(3) {
        let parts = [code % 13 + 1, code / 13 % 13 + 1, code / 169 + 1];
        let rows = tessellator.rows(parts);
        let pieces = (0..tessellator.triangles(rows)).map(|number| {
            let cut = tessellator.triangle(rows, number);
            [cut.a, cut.b, cut.c].map(|place| diced(tessellator.point(rows, place)))
        });
        let pieces: Vec<[Point; 3]> = pieces.collect();
        assert_tiled(parts, tessellator.points(rows), &pieces, 1e-5);
        for number in 0..tessellator.points(rows) {
            let point = tessellator.point(rows, tessellator.place(rows, number));
            assert_eq!((point.side, point.at), (INSIDE, number), "{parts:?}");
        }
    }
}

/// Returns the sweep of triangles with corners in these voxels: parts, points inside and pieces.
fn swept(tessellator: &Tessellator, voxels: [[i32; 3]; 3]) -> Option<([u32; 3], u32, Vec<[Point; 3]>)> {
    let corners = voxels.map(|[x, y, z]| Voxel { at: Three { x, y, z }, share: 1.0 });
    let sweep = tessellator.sweep(corners, 0)?;
    let nowhere = Vec2 { x: 0.0, y: 0.0 };
    let parts =
        [0, 1, 2].map(|side| tessellator.parts_between([corners[side], corners[(side + 1) % 3]], nowhere, 0));
    let (mut inside, mut pieces) = (Vec::new(), Vec::new());
    let mut column = tessellator.swept_column(sweep, 0, 0);
    for strip in 0..sweep.end.x {
        let next = tessellator.swept_column(sweep, strip + 1, inside.len() as u32);
        inside.extend(tessellator.swept_weights(sweep, next));
        pieces.extend(tessellator.swept_triangles(sweep, [column, next]));
        column = next;
    }
    let points = tessellator.swept_points(sweep);
    assert_eq!(points as usize, inside.len(), "{voxels:?}");
    let point = |[side, at]: [u32; 2]| {
        let weights = if side == INSIDE { inside[at as usize] } else { Three { x: 0.0, y: 0.0, z: 0.0 } };
        (side, at, weights)
    };
    Some((parts, points, pieces.into_iter().map(|piece| piece.map(point)).collect()))
}

#[test]
fn swept_triangles_are_tiled_and_use_every_point() {
    let job = job_of(&scene_of(surface_of(square(1).expect("a mesh"), 1.0, SWEPT), [0.0, 2.0, 0.1], false));
    let tessellator = tessellator_of(&job);
    let corner = |code: i32| [code % 5, code / 5 % 5, code / 25];
    let of_lattice = (0..125 * 125 * 125)
        .into_par_iter()
        .map(|code| [corner(code % 125), corner(code / 125 % 125), corner(code / (125 * 125))]);
    let random = (0..200_000_u64).into_par_iter().map(|seed| {
        let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
        let size = if seed % 5000 == 0 { 1024 } else { [3, 7, 12, 40][seed as usize % 4] };
        let flat = [1, 2, size][seed as usize / 4 % 3];
        let mut random = |below: i32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as i32 % below - below / 2
        };
        let mut corner = || [random(size), random(flat), random(size)];
        let mut voxels = [corner(), corner(), corner()];
        voxels.iter_mut().for_each(|corner| corner.rotate_left(seed as usize % 3));
        voxels
    });
    let looked_at = of_lattice.chain(random).filter(|voxels| match swept(&tessellator, *voxels) {
        Some((parts, points, pieces)) => {
            assert_tiled(parts, points, &pieces, -1e-6);
            let sides = |(side, at, _): Point| match (side, at) {
                (INSIDE, _) => 0,
                (side, 0) => 1 << side | 1 << ((side + 2) % 3),
                (side, _) => 1 << side,
            };
            let on_one_side = |piece: &&[Point; 3]| piece.map(sides).iter().fold(7, |all, of| all & of) != 0;
            assert!(!pieces.iter().any(|piece| on_one_side(&piece)), "{voxels:?}");
            assert_eq!(pieces.len() as u32, 2 * points + parts.iter().sum::<u32>() - 2, "{voxels:?}");
            true
        }
        None => {
            assert_eq!(voxels.iter().collect::<HashSet<_>>().len(), 1, "{voxels:?}");
            false
        }
    });
    assert!(looked_at.count() > 2_000_000);
    // Beyond what 32 bits hold a triangle is left to the pattern.
    assert!(swept(&tessellator, [[0, 0, 0], [1023, 0, 0], [0, 1023, 0]]).is_some());
    assert!(swept(&tessellator, [[0, 0, 0], [1024, 0, 0], [0, 1, 0]]).is_none());
}

#[test]
fn numbers_of_large_patterns_lead_where_counting_does() {
    let job = job_of(&scene_of(surface_of(square(1).expect("a mesh"), 1.0, &[]), [0.0, 2.0, 0.1], false));
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
            let corners = [cut.a, cut.b, cut.c].map(|place| diced(tessellator.point(rows, place)));
            let twice = twice_area(corners, parts);
            let inside = corners.iter().all(|(side, at, _)| *side != INSIDE || *at < points);
            // In 32 bits narrow ones may come out without an area.
            assert!(inside && twice > -1e-7, "{parts:?} {number}: {twice}");
        }
        for number in (0..points).step_by(points as usize / 1000 + 1) {
            let point = tessellator.point(rows, tessellator.place(rows, number));
            assert_eq!((point.side, point.at), (INSIDE, number), "{parts:?}");
        }
    }
}

/// A place of each corner.
type Places = [Option<usize>; 3];

/// Triangles by the places of their corners, each from the first place on.
fn by_places(triangles: impl Iterator<Item = [u32; 3]>, places: Vec<Option<usize>>) -> BTreeSet<Places> {
    let turned = triangles.map(|corners| {
        let mut corners = corners.map(|corner| places[corner as usize]);
        let first = (0..3).min_by_key(|&k| corners[k]).unwrap_or_default();
        corners.rotate_left(first);
        corners
    });
    turned.collect()
}

/// Agreement of the points of all closed bases with the mesher in 64 bits: the least part of a picture's
/// points, and the number of pictures in which all agree.
fn beside_mesher(set: &[(&str, f64)], settings: impl Fn(View) -> MeshSettings) -> (f64, u32) {
    let eyes = [[1.3, 0.9, 1.1], [-0.4, 1.7, 0.3], [0.2, -0.1, 2.3]];
    let (mut least, mut whole) = (1.0f64, 0);
    for (mesh, eye) in closed().into_iter().flat_map(|mesh| eyes.map(|eye| (mesh.clone(), eye))) {
        let scene = scene_of(surface_of(mesh.clone(), 2.0, set), eye, false);
        let job = job_of(&scene);
        let triangles = made(&job);
        let grid = job.surfaces[0].triangles.tessellation().expect("one").grid;
        let near_m = f64::from(grid.near_m);
        let settings = settings(View { pixels: 2.0, near_m, ..View::new(*scene.camera(), scene.size()) });
        let mesher = Mesher::new(&mesh, scene.surfaces()[0].height_map(), &settings).expect("a mesh");
        let exact = mesher.mesh().expect("a mesh");
        let [own, other] = [triangles.len(), exact.triangles().len()].map(|count| count as f64);
        assert!((own / other - 1.0).abs() < 0.02, "{own} {other}");
        let three = |of: Three<f32>| Vec3::from([of.x, of.y, of.z]);
        let is_known = |corner: &&Corner| {
            let (position, normal) = (three(corner.position), three(corner.normal));
            exact
                .vertices()
                .iter()
                .any(|vertex| position.distance(vertex.position) < 2e-6 && normal.dot(vertex.normal) > 0.999)
        };
        let known = triangles.corners().par_iter().filter(is_known).count();
        if known == triangles.corners().len() {
            let place = |position: Vec3| {
                exact.vertices().iter().position(|vertex| position.distance(vertex.position) < 2e-6)
            };
            let places = triangles.corners().par_iter().map(|corner| place(three(corner.position)));
            let own = triangles.faces().iter().map(|face| face.corners);
            let own = by_places(own.map(|Three { x, y, z }| [x, y, z]), places.collect());
            let places = exact.vertices().par_iter().map(|vertex| place(vertex.position));
            let other = by_places(exact.triangles().iter().copied(), places.collect());
            assert_eq!(own, other, "{set:?}: other triangles between the same points");
        }
        least = least.min(known as f64 / triangles.corners().len() as f64);
        whole += u32::from(known == triangles.corners().len());
    }
    (least, whole)
}

#[test]
fn triangles_are_those_of_the_mesher_in_64_bits() {
    // A vertex that lies between two voxels may be taken for one in the other: then sides that end there may
    // have another number of parts. A point on a line between texels may have the slope of either side.
    let rule = |name| EDGE_RULES.iter().find(|rule| rule.name == name).expect("a rule");
    let dice = interior("dice").expect("an interior");
    let (least, whole) = beside_mesher(&[], |view| MeshSettings {
        edges: rule("pixels"),
        interior: dice,
        ..MeshSettings::seen_by(view)
    });
    assert!(least > 0.99 && whole >= 6, "{least} {whole}");
    let (least, whole) = beside_mesher(SWEPT, MeshSettings::seen_by);
    assert!(least > 0.99 && whole >= 6, "{least} {whole}");
    let (least, whole) = beside_mesher(BY_TEXELS, |_| MeshSettings { texels: 1, ..MeshSettings::default() });
    assert!(least > 0.99 && whole >= 6, "{least} {whole}");
}

#[test]
fn no_view_opens_a_closed_base() {
    [&[], SWEPT, BY_TEXELS].into_iter().for_each(no_view_opens);
}

fn no_view_opens(set: &[(&str, f64)]) {
    let mut seed = 1u32;
    let mut random = || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(seed >> 8) / f64::from(1 << 24)
    };
    for mesh in closed() {
        for _ in 0..25 {
            let toward = DVec3::new(random() - 0.5, random() - 0.5, random() - 0.5).normalize();
            let eye = toward * (0.3 + 3.0 * random() * random());
            let surface = surface_of(mesh.clone(), 1.0 + 3.0 * random(), set);
            let triangles = made(&job_of(&scene_of(surface, eye.to_array(), false)));
            let cracks = CrackTest::of_triangles(positions(&triangles));
            assert!(cracks.is_closed(), "{eye}: {cracks:?}");
        }
    }
    // A point moved by one step of its numbers is noticed.
    let triangles =
        made(&job_of(&scene_of(surface_of(torus(12, 7).expect("a mesh"), 2.0, set), [1.0; 3], false)));
    let mut positions = positions(&triangles);
    positions[17][1].x = positions[17][1].x.next_up();
    assert!(!CrackTest::of_triangles(positions).is_closed());
}

#[test]
fn with_less_room_the_grid_is_coarser_and_nothing_is_dropped() {
    [&[], SWEPT, BY_TEXELS].into_iter().for_each(with_less_room);
}

fn with_less_room(set: &[(&str, f64)]) {
    let scene = scene_of(surface_of(torus(12, 7).expect("a mesh"), 1.0, set), [1.2, 0.8, 0.9], false);
    let whole = made(&job_of(&scene)).len();
    let mut before = whole;
    for kilobytes in [1500, 600, 200] {
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
    let refused = preparer.job(&none, &Watch::none()).expect_err("no room").to_string();
    assert!(refused.contains("a larger 'geometry."), "{refused}");
}

#[test]
fn what_is_left_out_is_not_seen() {
    [&[], SWEPT, BY_TEXELS].into_iter().for_each(is_not_seen);
}

fn is_not_seen(set: &[(&str, f64)]) {
    // There is room for all of it: with less, the whole would be coarser than its visible part.
    let surface = surface_of(torus(48, 24).expect("a mesh"), 4.0, set);
    let [whole, seen] = [false, true].map(|culls| scene_of(surface.clone(), [0.6, 0.1, 0.2], culls));
    let [all, few] = [&whole, &seen].map(|scene| made(&job_of(scene)).len());
    assert!(few * 5 < all * 4 && few > 0, "{few} of {all}");
    let mut renderer = Renderer::on_cpu();
    let [whole, seen] = [whole, seen].map(|scene| {
        renderer.render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering
    });
    assert!(whole.pixels.iter().any(|pixel| pixel.hit == 1));
    for (a, b) in whole.pixels.iter().zip(&seen.pixels) {
        assert_eq!((a.color, a.position, a.depth, a.hit), (b.color, b.position, b.depth, b.hit));
    }
}
