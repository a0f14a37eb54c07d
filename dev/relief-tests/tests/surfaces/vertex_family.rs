//! Pictures of displaced triangles beside the exact surface, beside each other, and on both backends.

use std::f32::consts::TAU;
use std::sync::Arc;

use glam::{DVec3, Vec2, Vec3};
use rayon::prelude::*;
use relief_core::camera::Camera;
use relief_core::exact::{DisplacedMesh, Sides};
use relief_core::mesh::{Builtin, Mesh, cylinder, sphere, torus};
use relief_core::{ByteSize, HeightMap, TexelMask, Watch, Wrap};
use relief_io::NormalMap;
use relief_maps::Maps;
use relief_render::gpu::AdapterChoice;
use relief_render::{GeometryError, RenderError, Renderer};
use relief_scene::light::Light;
use relief_scene::{Sampling, Scene, SceneBuilder, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use relief_testing::outline::{Mask, distances};
use relief_tests::adapter::{Leeway, open};

const SIZE: [u32; 2] = [200, 150];

const SCALE_M: f64 = 0.06;

/// Bumps and dents of a dozen texels, and finer waves on them.
fn bumps(wrap: Wrap, scale_m: f64) -> HeightMap {
    let wave = |turns: f32, at: f32| (TAU * turns * at).sin();
    let map = HeightMap::from_fn(96, 64, wrap, |i, j| {
        let [u, v] = [(i as f32 + 0.5) / 96.0, (j as f32 + 0.5) / 64.0];
        0.5 + 0.3 * wave(4.0, u) * wave(3.0, v) + 0.1 * wave(9.0, u + v) + 0.08 * wave(7.0, u - 2.0 * v)
    });
    map.expect("heights from 0 to 1").with_displacement(scale_m, -scale_m / 2.0).expect("lengths")
}

fn looking(eye: [f64; 3], target: [f64; 3]) -> Camera {
    Camera::new(eye.into(), target.into(), 40.0).expect("a camera")
}

/// A base mesh and a camera that sees its outline.
struct Case {
    name: &'static str,
    mesh: Arc<Mesh>,
    camera: Camera,
}

fn cases() -> Vec<Case> {
    let case = |name, mesh: Mesh, tiles: Vec2, camera| Case {
        name,
        mesh: Arc::new(mesh.tiled(tiles).expect("tiles")),
        camera,
    };
    let above = looking([0.7, 1.0, 1.3], [0.0, 0.0, 0.0]);
    vec![
        case("plane", Builtin::Plane.build([1.2, 0.8]).expect("a mesh"), Vec2::ONE, above),
        case("torus", torus(24, 12).expect("a mesh"), Vec2::new(3.0, 1.0), above),
        case(
            "cylinder",
            cylinder(24, 2).expect("a mesh"),
            Vec2::new(2.0, 1.0),
            looking([0.55, 0.0, 1.23], [0.0; 3]),
        ),
        case(
            "sphere",
            sphere(24, 12).expect("a mesh"),
            Vec2::new(2.0, 1.0),
            looking([0.6, 0.5, 1.5], [0.0; 3]),
        ),
    ]
}

/// What is run by a method, with these stages and settings.
fn selection(method: &str, stages: &[(&str, &str)], settings: &[(&str, f64)]) -> Selection {
    let mut selection = Selection::method(method).expect("a method");
    for (stage, name) in stages {
        selection.choose(stage, name).expect("a listed name");
    }
    for (key, value) in settings {
        selection.set(key, *value).expect("a setting");
    }
    selection
}

fn scene_of(surface: Surface, camera: Camera) -> SceneBuilder {
    Scene::builder(surface).camera(camera).size(SIZE[0], SIZE[1]).samples(1)
}

fn rendered(scene: &Scene, renderer: &mut Renderer) -> Vec<PixelOut> {
    renderer.render(scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
}

/// A picture of a case without shadows.
fn picture(case: &Case, map: &HeightMap, method: &str, settings: &[(&str, f64)]) -> Vec<PixelOut> {
    let surface = Surface::new(Arc::clone(&case.mesh), map.clone());
    let surface = surface.with_selection(selection(method, &[("shadow", "none")], settings));
    rendered(&scene_of(surface, case.camera).build().expect("a scene"), &mut Renderer::on_cpu())
}

/// Of every pixel the depth of the displaced surface itself in metres, its place on the map and its height.
type Judged = Option<(f64, [f64; 2], f64)>;

fn judged(case: &Case, map: &HeightMap) -> Vec<Judged> {
    let judge = DisplacedMesh::new(&case.mesh, map, map.scale_m(), map.bias_m()).expect("a judge");
    let [width, height] = SIZE;
    let pixel = |place: u32| {
        let ray = case.camera.ray(place % width, place / width, width, height);
        let hit = judge.first_hit(ray.origin.to_array(), ray.direction.to_array(), Sides::Front)?;
        Some((hit.t, hit.uv, hit.height))
    };
    (0..width * height).into_par_iter().map(pixel).collect()
}

fn mask(covered: impl Iterator<Item = bool>) -> Mask {
    Mask::new(SIZE, covered.collect())
}

fn shown(pixels: &[PixelOut]) -> Mask {
    mask(pixels.iter().map(|pixel| pixel.hit == 1))
}

/// The number that so large a part of some numbers does not exceed.
fn quantile(mut of: Vec<f64>, part: f64) -> f64 {
    of.sort_by(f64::total_cmp);
    of[((of.len() - 1) as f64 * part) as usize]
}

/// How far a picture is from what is judged.
#[derive(Debug)]
struct Off {
    /// Of the outline, in pixels.
    outline_p95: f64,
    /// Of depths where both see something, in parts of the displacement.
    depth_p50: f64,
    depth_p90: f64,
    /// Of places on the map, in texels.
    texels_p90: f64,
    height_p90: f64,
}

impl Off {
    fn of(pixels: &[PixelOut], judged: &[Judged]) -> Self {
        let both = || pixels.iter().zip(judged).filter(|(pixel, _)| pixel.hit == 1);
        let both = || both().filter_map(|(pixel, judged)| Some((pixel, (*judged)?)));
        assert!(both().count() > 3000, "{}", both().count());
        let depths = || both().map(|(pixel, (depth, ..))| (f64::from(pixel.depth) - depth).abs() / SCALE_M);
        let texels = both().map(|(pixel, (_, uv, _))| {
            let aside = [f64::from(pixel.uv.x) - uv[0], f64::from(pixel.uv.y) - uv[1]];
            // At a seam texture coordinates differ by tiles.
            let [u, v] = aside.map(|aside| aside - aside.round());
            (u * 96.0).hypot(v * 64.0)
        });
        let heights = both().map(|(pixel, (.., height))| (f64::from(pixel.height) - height).abs());
        let outlines = distances(&shown(pixels).filled(), &mask(judged.iter().map(Option::is_some)).filled());
        Self {
            outline_p95: quantile(outlines, 0.95),
            depth_p50: quantile(depths().collect(), 0.5),
            depth_p90: quantile(depths().collect(), 0.9),
            texels_p90: quantile(texels.collect(), 0.9),
            height_p90: quantile(heights.collect(), 0.9),
        }
    }

    /// Whether it is as near as triangles of a texel are to these bumps: a chord of a texel is a hundredth of
    /// the displacement off, and more along rays that graze it.
    fn is_near(&self) -> bool {
        let Self { outline_p95, depth_p50, depth_p90, texels_p90, height_p90 } = *self;
        outline_p95 <= 1.0 && depth_p50 < 0.02 && depth_p90 < 0.15 && texels_p90 < 0.5 && height_p90 < 0.05
    }
}

#[test]
fn a_vertex_every_texel_shows_the_displaced_surface() {
    let map = bumps(Wrap::Repeat, SCALE_M);
    for case in cases() {
        let judged = judged(&case, &map);
        let off = Off::of(&picture(&case, &map, "vertex", &[]), &judged);
        println!("{}: {off:?}", case.name);
        assert!(off.is_near(), "{}: {off:?}", case.name);
        // Coarser triangles are farther off, and meshes that are displaced twice, or not at all, are seen.
        let coarse = Off::of(&picture(&case, &map, "vertex", &[("geometry.texels", 6.0)]), &judged);
        assert!(coarse.depth_p50 > 2.0 * off.depth_p50, "{}: {coarse:?}", case.name);
        for scale_m in [0.0, 2.0 * SCALE_M] {
            let wrong = bumps(Wrap::Repeat, scale_m);
            let wrong = Off::of(&picture(&case, &wrong, "vertex", &[]), &judged);
            assert!(!wrong.is_near(), "{} {scale_m}: {wrong:?}", case.name);
        }
    }
}

#[test]
fn a_vertex_every_pixel_has_the_same_outline() {
    let map = bumps(Wrap::Repeat, SCALE_M);
    for case in cases() {
        let vertex = picture(&case, &map, "vertex", &[]);
        let judged = judged(&case, &map);
        let swept = &[("geometry.interior", 1.0)];
        let methods: [(&str, &[(&str, f64)]); 3] =
            [("remesh", &[]), ("tessellate", &[]), ("tessellate", swept)];
        for (method, settings) in methods {
            let pixels = picture(&case, &map, method, settings);
            let aside = distances(&shown(&vertex).filled(), &shown(&pixels).filled());
            let near = quantile(aside, 0.95);
            println!("{} {method}: {near} pixels", case.name);
            assert!(near <= 1.0, "{} {method}: {near}", case.name);
            let off = Off::of(&pixels, &judged);
            assert!(off.is_near(), "{} {method}: {off:?}", case.name);
        }
        let moved = shown(&vertex).moved(3);
        assert!(quantile(distances(&shown(&vertex), &moved), 0.95) > 1.0, "{}", case.name);
    }
}

#[test]
fn normals_and_places_are_those_of_the_relief() {
    let map = bumps(Wrap::Clamp, SCALE_M);
    let case = &cases()[0];
    let exact = picture(case, &map, "exact", &[]);
    let vertex = picture(case, &map, "vertex", &[]);
    let (mut turned, mut apart) = (Vec::new(), Vec::new());
    let three = |v: relief_shaders::cpu::Vec3<f32>| Vec3::new(v.x, v.y, v.z);
    for (a, b) in exact.iter().zip(&vertex).filter(|(a, b)| a.hit == 1 && b.hit == 1) {
        turned.push(f64::from(three(a.normal).angle_between(three(b.normal)).to_degrees()));
        apart.push(f64::from(three(a.position).distance(three(b.position))) / SCALE_M);
        assert!((b.height - map.height_at(b.uv.x.into(), b.uv.y.into()) as f32).abs() < 1e-4);
        assert!((b.reads, b.steps, b.t.to_bits()) == (0, 0, 0), "nothing is searched");
    }
    let (turned, apart) = (quantile(turned, 0.9), quantile(apart, 0.9));
    println!("{turned} degrees, {apart} of the displacement");
    assert!(turned < 4.0 && apart < 0.1, "{turned} {apart}");
}

#[test]
fn both_backends_show_the_same_triangles() {
    let Some(gpu) = open(AdapterChoice::Any) else { return };
    let map = bumps(Wrap::Mirror, SCALE_M);
    let mut on_gpu = Renderer::on_gpu(gpu, Sampling::Exact);
    let (mut on_cpu, mut before) = (Renderer::on_cpu(), Vec::new());
    let cases = cases();
    let both = cases.iter().zip(["vertex", "remesh"].into_iter().cycle());
    let both = both.map(|(case, method)| (case, method, None));
    let ways = [None, Some(("geometry.interior", 1.0)), Some(("geometry.texels", 4.0))];
    let tessellated =
        ways.into_iter().flat_map(|way| cases.iter().map(move |case| (case, "tessellate", way)));
    for (case, method, way) in both.chain(tessellated) {
        let settings: Vec<(&str, f64)> = [("shadow.size", 256.0)].into_iter().chain(way).collect();
        let selection = selection(method, &[("detail", "footprint")], &settings);
        let surface = Surface::new(Arc::clone(&case.mesh), map.clone()).with_selection(selection);
        let surface = surface.with_two_sided(case.name == "plane");
        let scene = scene_of(surface, case.camera).build().expect("a scene");
        let [cpu, gpu] = [&mut on_cpu, &mut on_gpu].map(|renderer| rendered(&scene, renderer));
        let alike = |a: &[PixelOut], b: &[PixelOut]| {
            let covered = a.iter().zip(b).filter(|(a, b)| a.hit == 1 || b.hit == 1);
            let same = covered.clone().filter(|(a, b)| {
                let colors = [a.color.x - b.color.x, a.color.y - b.color.y, a.color.z - b.color.z];
                let same_place = a.hit == b.hit && (a.depth - b.depth).abs() <= 3e-4;
                same_place && colors.iter().all(|part| part.abs() <= 3e-4)
            });
            same.count() as f64 / covered.count().max(1) as f64
        };
        println!("{} {method} {way:?}: {:.5}", case.name, alike(&cpu, &gpu));
        // At edges rasterisers may choose the other triangle.
        let least = Leeway::of_any().share(0.996);
        assert!(alike(&cpu, &gpu) >= least, "{} {method}: {}", case.name, alike(&cpu, &gpu));
        assert!(alike(&cpu, &before) < 0.5, "{} {method}: another picture is the same", case.name);
        before = cpu;
    }
}

#[test]
fn shadows_fall_from_triangle_to_triangle_and_from_surface_to_surface() {
    let case = &cases()[0];
    let light = Light::directional(DVec3::new(-0.8, 0.5, 0.3), Vec3::ONE).expect("a light");
    let lit = |shadow: &str| {
        let under = |method: &str| selection(method, &[("shadow", shadow)], &[]);
        let ground = Surface::new(Arc::clone(&case.mesh), bumps(Wrap::Repeat, SCALE_M));
        let ball = sphere(16, 8).expect("a mesh").placed(&relief_core::mesh::Placement {
            position_m: DVec3::new(-0.1, 0.25, 0.0),
            rotation_degrees: DVec3::ZERO,
            size: 0.25,
        });
        let ball = Surface::new(ball.expect("a place"), bumps(Wrap::Repeat, 0.02));
        let scene = scene_of(ground.with_selection(under("vertex")), case.camera)
            .surface(ball.with_selection(under("remesh")))
            .lights(vec![light]);
        rendered(&scene.build().expect("a scene"), &mut Renderer::on_cpu())
    };
    let [none, map, rays] = ["none", "map", "scene"].map(lit);
    let surfaces: std::collections::BTreeSet<u32> =
        map.iter().filter(|pixel| pixel.hit == 1).map(|pixel| pixel.surface).collect();
    assert_eq!(surfaces.len(), 2);
    let apart = |a: &[PixelOut], b: &[PixelOut]| {
        let covered = a.iter().zip(b).filter(|(a, b)| a.hit == 1 && b.hit == 1);
        let apart = covered.clone().filter(|(a, b)| (a.lit - b.lit).abs() > 0.5);
        apart.count() as f64 / covered.count() as f64
    };
    let (differ, shadowed) = (apart(&map, &rays), apart(&none, &rays));
    println!("{differ} of {shadowed}");
    assert!(differ < 0.02 && shadowed > 0.1, "{differ} {shadowed}");
}

#[test]
fn the_eye_may_be_anywhere() {
    let map = bumps(Wrap::Repeat, SCALE_M);
    let cases = cases();
    for case in [&cases[0], &cases[3]] {
        for (eye, target) in [
            // Below the ground and within the ball, in the relief, behind all of it, and along it.
            ([0.1, -0.2, 0.0], [0.4, 0.1, 0.2]),
            ([0.0, 0.001, 0.5], [0.3, 0.0, 0.1]),
            ([0.0, 3.0, 0.0], [0.1, 6.0, 0.0]),
            ([0.9, 0.0, 0.0], [0.0, 0.0, 0.0]),
        ] {
            let seen = Case { camera: looking(eye, target), mesh: Arc::clone(&case.mesh), name: case.name };
            for method in ["vertex", "remesh", "tessellate"] {
                for pixel in picture(
                    &seen,
                    &map,
                    method,
                    &[("geometry.texels", 4.0)][..usize::from(method == "vertex")],
                ) {
                    let numbers = [pixel.depth, pixel.color.x, pixel.normal.y, pixel.uv.x, pixel.position.z];
                    assert!(numbers.iter().all(|number| number.is_finite()), "{eye:?}: {pixel:?}");
                    assert!(pixel.depth >= 0.0, "{eye:?}: {pixel:?}");
                }
            }
        }
    }
}

#[test]
fn holes_and_what_lies_beside_a_map_are_not_shown() {
    let wide = cases().remove(0);
    let mesh = Mesh::clone(&wide.mesh).tiled(Vec2::new(2.0, 2.0)).expect("tiles");
    let wide = Case { mesh: Arc::new(mesh), ..wide };
    let map = bumps(Wrap::Clamp, SCALE_M);
    let pixels = picture(&wide, &map, "vertex", &[]);
    let hits = || pixels.iter().filter(|pixel| pixel.hit == 1);
    assert!(hits().count() > 500 && hits().all(|pixel| pixel.uv.x < 1.0001 && pixel.uv.y < 1.0001));
    // A square of texels in the middle is a hole, and so are the cells that it is a corner of.
    let is_hole = |i: u32, j: u32| (30..60).contains(&i) && (15..45).contains(&j);
    let map = map.with_holes(TexelMask::from_fn(96, 64, is_hole)).expect("of its size");
    let surface =
        Surface::new(Arc::clone(&cases()[0].mesh), map).with_selection(selection("vertex", &[], &[]));
    let [closed, open] = [false, true].map(|holes| {
        let scene = scene_of(surface.clone().with_holes(holes), cases()[0].camera);
        rendered(&scene.build().expect("a scene"), &mut Renderer::on_cpu())
    });
    let in_hole = |pixel: &&PixelOut| {
        pixel.hit == 1 && (29..60).contains(&pixel.cell.x) && (14..45).contains(&pixel.cell.y)
    };
    assert!(closed.iter().filter(in_hole).count() > 100);
    assert_eq!(open.iter().filter(in_hole).count(), 0);
}

#[test]
fn what_cannot_be_shown_is_refused_with_the_reason() {
    let case = &cases()[0];
    let surface =
        |selection| Surface::new(Arc::clone(&case.mesh), bumps(Wrap::Repeat, 0.1)).with_selection(selection);
    let refused = |surface: Surface| {
        scene_of(surface, case.camera).build().map(drop).expect_err("a scene that cannot be").to_string()
    };
    let vertex = || selection("vertex", &[], &[]);
    let normals = NormalMap { width: 1, height: 1, normals: vec![[0.0, 0.0, 1.0]], degenerate: 0 };
    let error = refused(surface(vertex()).with_normal_map(&normals));
    assert!(error.contains("normal") && error.contains("vertices"), "{error}");
    let error = refused(surface(vertex()).with_creases(true));
    assert!(error.contains("creases"), "{error}");
    let error = refused(surface(selection("vertex", &[("surface", "prism")], &[])));
    assert!(error.contains("'vertex'") && error.contains("'prism'") && error.contains("'facets'"), "{error}");
    let error = refused(surface(selection("remesh", &[("shadow", "ray")], &[])));
    assert!(error.contains("'ray'") && error.contains("'map'"), "{error}");
    let both = [("geometry.interior", 1.0), ("geometry.texels", 1.0)];
    let error = refused(surface(selection("tessellate", &[], &both)));
    assert!(error.contains("'tessellate'") && error.contains("texels"), "{error}");
    // Memory is counted before it is taken, over all surfaces.
    let scene = |memory: u64, count: usize| {
        let surfaces = (0..count).map(|_| surface(vertex())).collect();
        let scene = scene_of(surface(vertex()), case.camera).surfaces(surfaces);
        scene.geometry_memory(ByteSize(memory)).build().expect("a scene")
    };
    let render = |scene: &Scene| Renderer::on_cpu().render(scene, &mut Maps::in_memory(), &Watch::none());
    let needed_of = |error: &RenderError| match error {
        RenderError::Geometry { surface, source: GeometryError::Memory { needed, .. } } => {
            (*surface, *needed)
        }
        other => panic!("{other}"),
    };
    let error = render(&scene(1 << 20, 1)).expect_err("too much");
    let (number, needed) = needed_of(&error);
    assert!(number == 0 && error.to_string().contains("geometry.texels"), "{error}");
    assert!(render(&scene(needed, 1)).is_ok() && render(&scene(needed - 1, 1)).is_err());
    assert_eq!(needed_of(&render(&scene(needed, 3)).expect_err("too much")), (1, needed));
    let many = Mesh::clone(&case.mesh).tiled(Vec2::splat(1e6)).expect("tiles");
    let many = Surface::new(many, bumps(Wrap::Repeat, 0.1)).with_selection(vertex());
    let error = render(&scene_of(many, case.camera).build().expect("a scene")).expect_err("too many");
    assert!(error.to_string().contains("geometry.texels"), "{error}");
}
