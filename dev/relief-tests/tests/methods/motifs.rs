//! Motifs in shells: the search `shell-map` beside the triangles one by one, and beside the mesh that is cut
//! and moved.

use glam::{DVec3, Vec3};
use relief_core::camera::Camera;
use relief_core::mesh::{RawMesh, torus};
use relief_core::raycast::{RayCaster, Sides};
use relief_core::{Cost, HeightMap, Hit, Lanes, MotifTree, MotifTreeError, Path, TileTriangle, Watch, Wrap};
use relief_maps::Maps;
use relief_mesh::motif::MotifKind;
use relief_mesh::shell_map::{ShellMapSettings, map_shells, motif_for_rays};
use relief_render::render;
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::{MethodTracer, PixelOut};
use relief_shaders::field::Solids;
use relief_testing::motifs::Repeated;
use relief_tests::adapter::{Leeway, has_adapter};
use relief_tests::motif_rays::{motif_mesh, motif_tree, straight_paths, tile_triangles, wrong};

/// Rays to a motif. Times scale with it.
const RAYS: usize = 2_000;

fn shell_map() -> Selection {
    Selection::method("shell-map").expect("a method")
}

fn ground() -> HeightMap {
    HeightMap::new(1, 1, vec![0.0], Wrap::Repeat).expect("a map")
}

fn hits(tree: &MotifTree, paths: &[Path], lanes: Lanes) -> Vec<Hit> {
    let (ground, mut hits) = (ground(), vec![Hit::miss(Cost::default()); paths.len()]);
    MethodTracer::of_motif(&ground, tree, &shell_map()).first_hits(paths, lanes, &mut hits);
    hits
}

#[test]
fn the_first_triangle_is_found_in_all_tiles() {
    for (seed, kind) in MotifKind::ALL.into_iter().enumerate() {
        let mesh = motif_mesh(kind);
        let tree = motif_for_rays(&mesh).expect("a motif").tree;
        let paths = straight_paths(seed as u64, RAYS);
        let found = hits(&tree, &paths, Lanes::widest());
        let hit = found.iter().filter(|hit| hit.found).count();
        assert!((RAYS / 4..RAYS).contains(&hit), "{kind}: {hit} hits");
        assert!(found.iter().all(|hit| !hit.exhausted), "{kind}");
        let judge = Repeated::new(&tile_triangles(&mesh));
        assert_eq!(wrong(&judge, &paths, &found), 0, "{kind}");
        // Where a triangle is missing, or all lies elsewhere, it is noticed.
        let all = tile_triangles(&mesh);
        let less = MotifTree::new(&all[all.len() / 8..]).expect("a motif");
        assert!(wrong(&judge, &paths, &hits(&less, &paths, Lanes::widest())) > 10, "{kind}");
        let moved = all.iter().map(|triangle| TileTriangle {
            corners: triangle.corners.map(|at| at + DVec3::new(1e-3, 0.0, 0.0)),
            ..*triangle
        });
        let moved = MotifTree::new(&moved.collect::<Vec<_>>()).expect("a motif");
        assert!(wrong(&judge, &paths, &hits(&moved, &paths, Lanes::widest())) > 10, "{kind}");
    }
}

#[test]
fn every_width_has_the_bits_of_one_by_one() {
    for kind in MotifKind::ALL {
        let (tree, ground) = (motif_tree(kind), ground());
        let paths = straight_paths(11, 500);
        let tracer = MethodTracer::of_motif(&ground, &tree, &shell_map());
        let alone: Vec<Hit> = paths.iter().map(|path| tracer.first_hit(path)).collect();
        for lanes in Lanes::available() {
            assert_eq!(alone, hits(&tree, &paths, lanes), "{kind} {lanes:?}");
        }
    }
}

#[test]
fn nothing_passes_between_two_triangles() {
    // A level square of many triangles at half the height, on which all rays from above end.
    let count = 7;
    let at = |i: usize, j: usize| DVec3::new(i as f64 / count as f64, j as f64 / count as f64, 0.5);
    let mut triangles = Vec::new();
    for (i, j) in (0..count).flat_map(|j| (0..count).map(move |i| (i, j))) {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)];
        triangles
            .extend([[a, b, c], [c, b, d]].map(|corners| TileTriangle { corners, normals: [Vec3::Z; 3] }));
    }
    let tree = MotifTree::new(&triangles).expect("a motif");
    let aimed = (0..40_000).map(|k| {
        // At corners and edges, in tiles near and far.
        let [i, j] = [k % 29, (k / 29) % 31];
        let [u, v] = [f64::from(i) / 7.0 + f64::from(k % 5) * 9.0, f64::from(j) / 14.0 - 3.0];
        let [du, dv] = [f64::from(k % 13) / 13.0 - 0.5, f64::from(k % 17) / 17.0 - 0.5];
        let path = Path::between([u - du, v - dv, 1.0], [u + du, v + dv, 0.0]);
        Path::from(&relief_shaders::cpu::Path::from(&path))
    });
    let paths: Vec<Path> = aimed
        .chain(
            straight_paths(3, 20_000)
                .into_iter()
                .filter(|path| path.h[0] > 0.5 && path.at(path.exit)[2] < 0.5),
        )
        .collect();
    let found = hits(&tree, &paths, Lanes::widest());
    let missed = found.iter().filter(|hit| !hit.found).count();
    assert_eq!(missed, 0, "of {}", paths.len());
    assert!(found.iter().all(|hit| (hit.height - 0.5).abs() < 1e-4));
}

/// A scene with mail on a torus.
fn scene(surface: &str, shadow: &str, backend: BackendChoice, size: [u32; 2]) -> Scene {
    let mut selection = shell_map();
    selection.choose("surface", surface).expect("a listed name");
    selection.choose("shadow", shadow).expect("a listed name");
    let shown = Surface::new(base(), ground()).with_motif(motif_tree(MotifKind::Mail), DEPTH_M, 0.0);
    let shown = shown.expect("lengths").with_selection(selection);
    let builder = Scene::builder(shown).camera(camera()).size(size[0], size[1]).samples(1).backend(backend);
    builder.build().expect("a proper scene")
}

const DEPTH_M: f64 = 0.05;

fn base() -> relief_core::mesh::Mesh {
    torus(24, 12).expect("a mesh").tiled([12.0, 4.0].into()).expect("tiles")
}

fn camera() -> Camera {
    Camera::new([0.5, 0.9, 1.0].into(), [0.0; 3].into(), 40.0).expect("a camera")
}

fn pixels(surface: &str, shadow: &str, backend: BackendChoice, size: [u32; 2]) -> Vec<PixelOut> {
    let scene = scene(surface, shadow, backend, size);
    render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
}

#[test]
fn rays_show_the_mesh_that_is_cut_and_moved() {
    let size = [240, 180];
    let pixels = pixels("tetrahedra", "none", BackendChoice::Cpu, size);
    let settings = ShellMapSettings { scale_m: DEPTH_M, ..ShellMapSettings::default() };
    let forward = map_shells(&base(), &motif_mesh(MotifKind::Mail), &settings, &Watch::none());
    let forward = forward.expect("a mesh").mesh;
    let caster = RayCaster::new(&forward);
    let scene = scene("tetrahedra", "none", BackendChoice::Cpu, size);
    let (mut other, mut apart, mut turned, mut both) = (0, Vec::new(), 0, 0);
    for (at, pixel) in pixels.iter().enumerate() {
        let (x, y) = (at as u32 % size[0], at as u32 / size[0]);
        let ray = scene.camera().ray(x, y, size[0], size[1]);
        let hit = caster.next_hit(&ray, Sides::Both, None);
        if hit.is_some() != (pixel.hit == 1) {
            other += 1;
        }
        let (Some(hit), 1) = (hit, pixel.hit) else { continue };
        both += 1;
        let point = DVec3::new(pixel.position.x.into(), pixel.position.y.into(), pixel.position.z.into());
        apart.push(point.distance(ray.at(hit.t)));
        let corners = forward.corners(hit.triangle);
        let normal: DVec3 =
            corners.iter().zip(hit.weights).map(|(corner, weight)| corner.normal.as_dvec3() * weight).sum();
        let normal = if hit.front { normal } else { -normal };
        let seen = DVec3::new(pixel.normal.x.into(), pixel.normal.y.into(), pixel.normal.z.into());
        turned += u32::from(normal.normalize().dot(seen) < 0.8);
    }
    apart.sort_by(f64::total_cmp);
    let p99 = apart[apart.len() * 99 / 100];
    println!("{other} of {} pixels differ, p99 {p99} m, {turned} of {both} normals are turned", pixels.len());
    assert!(both > 8_000, "{both}");
    assert!(other * 1_000 <= pixels.len(), "{other} of {}", pixels.len());
    assert!(p99 < 0.01 * DEPTH_M, "{p99}");
    assert!(turned * 1_000 <= both, "{turned} of {both}");
}

/// Heights that change along `u` alone, so that each dual cell is flat.
fn ridges() -> HeightMap {
    let height = |i: u32, _: u32| [0.1, 0.9, 0.4, 0.7, 0.2, 0.2, 1.0, 0.5][i as usize % 8];
    HeightMap::from_fn(8, 4, Wrap::Repeat, height).expect("a map")
}

#[test]
fn a_sheet_of_heights_is_what_the_heights_are() {
    let map = ridges();
    let corner = |i: u32, v: f64| {
        let height = f64::from(map.texel(i.into(), 0));
        DVec3::new((f64::from(i) + 0.5) / 8.0, v, height)
    };
    let triangles: Vec<TileTriangle> = (0..8)
        .flat_map(|i| {
            let [a, b, c, d] = [corner(i, 0.0), corner(i + 1, 0.0), corner(i, 1.0), corner(i + 1, 1.0)];
            [[a, b, c], [c, b, d]].map(|corners| TileTriangle { corners, normals: [Vec3::Z; 3] })
        })
        .collect();
    let sheet = MotifTree::new(&triangles).expect("a motif");
    let shown = |surface: Surface| {
        let builder = Scene::builder(surface).camera(camera()).size(160, 120).samples(1);
        let scene = builder.backend(BackendChoice::Cpu).build().expect("a proper scene");
        render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
    };
    let mut exact = Selection::exact();
    exact.choose("surface", "tetrahedra").expect("a listed name");
    let heights = map.with_displacement(DEPTH_M, 0.0).expect("lengths");
    let heights = shown(Surface::new(base(), heights).with_selection(exact));
    let sheet = Surface::new(base(), ground()).with_motif(sheet, DEPTH_M, 0.0).expect("lengths");
    let sheet = shown(sheet.with_selection(shell_map()));
    let both = heights.iter().zip(&sheet).filter(|(a, b)| a.hit == 1 && b.hit == 1);
    let apart = both.map(|(a, b)| f64::from((a.depth - b.depth).abs())).collect::<Vec<_>>();
    let other = heights.iter().zip(&sheet).filter(|(a, b)| a.hit != b.hit).count();
    let far = apart.iter().filter(|apart| **apart > 1e-4).count();
    println!("{} pixels in both, {far} apart, {other} in one alone", apart.len());
    assert!(apart.len() > 4_000 && far * 500 < apart.len() && other * 500 < heights.len());
}

#[test]
fn the_backends_show_the_same() {
    let surfaces = [("plane", "ray"), ("tetrahedra", "soft"), ("tetrahedra", "map"), ("tetrahedra", "scene")];
    for (surface, shadow) in surfaces {
        let size = [96, 72];
        let on_cpu = pixels(surface, shadow, BackendChoice::Cpu, size);
        let seen = on_cpu.iter().filter(|pixel| pixel.hit == 1).count();
        assert!(seen > 1_000, "{surface} {shadow}: {seen} pixels");
        let dark = on_cpu.iter().filter(|pixel| pixel.hit == 1 && pixel.lit < 0.5).count();
        assert!(dark * 20 > seen, "{surface} {shadow}: {dark} of {seen} in shadow");
        if shadow == "scene" || !has_adapter() {
            continue;
        }
        let on_gpu = pixels(surface, shadow, BackendChoice::Gpu, size);
        let bits =
            |pixel: &PixelOut| [pixel.uv.x, pixel.uv.y, pixel.t, pixel.lit, pixel.normal.x].map(f32::to_bits);
        let is_same = |(a, b): &(&PixelOut, &PixelOut)| a.hit == b.hit && bits(a) == bits(b);
        let share = on_cpu.iter().zip(&on_gpu).filter(is_same).count() as f64 / on_cpu.len() as f64;
        println!("{surface} {shadow}: {share:.5} alike");
        assert!(share >= Leeway::of_any().share(0.999), "{surface} {shadow}: {share}");
    }
}

#[test]
fn what_finds_no_motif_is_refused() {
    assert_eq!(shell_map().check(), Ok(()));
    assert_eq!(shell_map().solids(), Solids::Motifs);
    for (key, name) in [
        ("search", "voxels"),
        ("search", "linear"),
        ("refine", "binary"),
        ("shadow", "horizon"),
        ("ambient", "occlusion"),
        ("detail", "footprint"),
        ("surface", "prism"),
        ("surface", "quadric-vertical"),
    ] {
        let mut selection = shell_map();
        selection.choose(key, name).expect("a listed name");
        let other = selection.with_solids(Solids::Motifs);
        assert!(other.check().is_err(), "{key} {name}");
    }
    for (key, name) in [("shadow", "soft"), ("shadow", "map"), ("shadow", "scene"), ("surface", "tetrahedra")]
    {
        assert_eq!(shell_map().goes_with(key, name), Ok(true), "{key} {name}");
    }
}

#[test]
fn closed_motifs_are_told_from_sheets() {
    let is_closed = |triangles: &[TileTriangle]| MotifTree::new(triangles).expect("a motif").is_closed();
    for kind in MotifKind::ALL {
        let all = tile_triangles(&motif_mesh(kind));
        assert!(is_closed(&all) && !is_closed(&all[1..]), "{kind}");
    }
}

#[test]
fn bad_motifs_say_what_is_wrong() {
    let triangle =
        |corners: [[f64; 3]; 3]| TileTriangle { corners: corners.map(DVec3::from), normals: [Vec3::Z; 3] };
    let above = triangle([[0.0, 0.0, 2.0], [1.0, 0.0, 2.0], [0.0, 1.0, 2.0]]);
    let on_a_line = triangle([[0.0, 0.0, 0.5], [0.5, 0.5, 0.5], [1.0, 1.0, 0.5]]);
    assert_eq!(MotifTree::new(&[above, on_a_line]).err(), Some(MotifTreeError::Nothing));
    assert_eq!(MotifTree::new(&[]).err(), Some(MotifTreeError::Nothing));
    let far = triangle([[0.0, 0.0, 0.5], [40.0, 0.0, 0.5], [0.0, 1.0, 0.5]]);
    assert_eq!(MotifTree::new(&[on_a_line, far]).err(), Some(MotifTreeError::Far(1)));
    let lost = triangle([[f64::NAN, 0.0, 0.5], [1.0, 0.0, 0.5], [0.0, 1.0, 0.5]]);
    assert_eq!(MotifTree::new(&[lost]).err(), Some(MotifTreeError::Far(0)));
    assert!(motif_for_rays(&RawMesh::default()).is_err());
}
