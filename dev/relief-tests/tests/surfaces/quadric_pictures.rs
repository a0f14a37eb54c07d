//! Pictures of surfaces of quadrics: beside the plane's, outlines, saddles, and both backends.

use glam::{DVec3, Vec2, Vec3};
use relief_core::camera::{Camera, Projection};
use relief_core::mesh::{Mesh, Vertex, cube, sphere, square, torus};
use relief_core::{HeightMap, Watch, Wrap};
use relief_maps::Maps;
use relief_render::render;
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use relief_tests::adapter::{Leeway, has_adapter};

const SIZE: [u32; 2] = [200, 150];

fn selection(method: &str, surface: &str, settings: &[(&str, f64)]) -> Selection {
    let mut selection = Selection::method(method).expect("a method");
    selection.choose("surface", surface).expect("a surface");
    selection.choose("shadow", "ray").expect("a shadow");
    for (key, value) in settings {
        selection.set(key, *value).expect("a setting");
    }
    selection
}

fn waves(scale_m: f64, bias_m: f64) -> HeightMap {
    let wave = |i: u32, j: u32| 0.5 + 0.5 * (i as f32 * 0.4).sin() * (j as f32 * 0.3).cos();
    let map = HeightMap::from_fn(63, 63, Wrap::Repeat, wave).expect("a map");
    map.with_displacement(scale_m, bias_m).expect("proper numbers")
}

/// All at the floor of the relief.
fn floor(scale_m: f64, bias_m: f64) -> HeightMap {
    let map = HeightMap::from_fn(4, 4, Wrap::Repeat, |_, _| 0.0).expect("a map");
    map.with_displacement(scale_m, bias_m).expect("proper numbers")
}

fn camera(eye: DVec3) -> Camera {
    Camera::with(eye, DVec3::ZERO, Projection::Orthographic { height_m: 1.4 }).expect("a camera")
}

fn pixels(surface: Surface, eye: DVec3, backend: BackendChoice) -> Vec<PixelOut> {
    let scene: Scene = Scene::builder(surface)
        .camera(camera(eye))
        .size(SIZE[0], SIZE[1])
        .samples(1)
        .backend(backend)
        .build()
        .expect("a scene");
    render(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
}

fn on_cpu(mesh: Mesh, map: HeightMap, selection: Selection, eye: DVec3) -> Vec<PixelOut> {
    pixels(Surface::new(mesh, map).with_selection(selection), eye, BackendChoice::Cpu)
}

#[test]
fn flat_quadrics_are_the_plane_to_the_bit() {
    let eye = DVec3::new(0.7, 0.5, 1.1);
    for method in ["relief", "cone", "parallax", "secant-search"] {
        let of = |surface, mesh: Mesh| on_cpu(mesh, waves(0.1, -0.11), selection(method, surface, &[]), eye);
        for mesh in [square(3).expect("a mesh"), cube(2).expect("a mesh")] {
            let (plane, quadric) = (of("plane", mesh.clone()), of("quadric-vertical", mesh));
            assert!(plane.iter().filter(|pixel| pixel.hit == 1).count() > 3000, "{method}");
            assert!(plane == quadric, "{method}");
        }
    }
}

/// Distance of the outline from a circle's in pixels, and the number of pixels outside of it.
fn outline(found: &[PixelOut], radius_m: f64) -> (f64, usize) {
    let pixel_m = 1.4 / f64::from(SIZE[1]);
    let (mut covered, mut outside) = (0, 0);
    for (at, pixel) in (0u32..).zip(found) {
        let x = f64::from(at % SIZE[0]) + 0.5 - f64::from(SIZE[0]) / 2.0;
        let y = f64::from(at / SIZE[0]) + 0.5 - f64::from(SIZE[1]) / 2.0;
        covered += usize::from(pixel.hit == 1);
        outside += usize::from(pixel.hit == 1 && x.hypot(y) * pixel_m > radius_m + 1.5 * pixel_m);
    }
    let radius = (covered as f64 / std::f64::consts::PI).sqrt();
    (radius - radius_m / pixel_m, outside)
}

#[test]
fn a_sphere_has_the_outline_of_its_relief() {
    let eye = DVec3::new(0.3, 0.4, 2.0);
    let ball = || sphere(128, 64).expect("a mesh");
    // Carved to the floor, 5 cm below the base; and outward to a floor 4 cm above it, under a top at 9 cm.
    for (bias_m, radius_m) in [(-0.05, 0.45), (0.04, 0.54)] {
        let of = |surface, settings: &[(&str, f64)]| {
            on_cpu(ball(), floor(0.05, bias_m), selection("exact", surface, settings), eye)
        };
        let [plane, vertical, lifted] =
            [of("plane", &[]), of("quadric-vertical", &[]), of("quadric-vertical", &[("surface.lift", 1.0)])];
        let perpendicular = selection("relief", "quadric-perpendicular", &[]);
        let perpendicular = on_cpu(ball(), floor(0.05, bias_m), perpendicular, eye);
        let of_plane = outline(&plane, radius_m).0;
        assert!(of_plane.abs() > 3.0, "{of_plane}");
        for (name, found) in [("vertical", &vertical), ("lifted", &lifted), ("perpendicular", &perpendicular)]
        {
            let (off, outside) = outline(found, radius_m);
            println!("bias {bias_m}: plane {of_plane:.2}, {name} {off:.2}, {outside} outside");
            assert!(off.abs() < 0.75 && outside == 0, "{name} {bias_m}: {off} {outside}");
            let is_inside = |(a, b): (&PixelOut, &PixelOut)| a.hit == 0 || b.hit == 1;
            assert!(bias_m > 0.0 || found.iter().zip(&plane).all(is_inside), "{name}");
        }
        // Where rays run far along the base, quadrics are no longer near it.
        let near = |pixel: &&PixelOut| {
            let (p, n) = (pixel.position, pixel.normal);
            let at = Vec3::new(p.x, p.y, p.z).as_dvec3();
            let facing = at.normalize().dot(Vec3::new(n.x, n.y, n.z).as_dvec3());
            (at.length() - radius_m).abs() < 1e-3 && facing > 0.999
        };
        let seen: Vec<&PixelOut> = vertical.iter().filter(|pixel| pixel.hit == 1).collect();
        let near = seen.iter().copied().filter(near).count();
        println!("{near} of {} are near", seen.len());
        assert!(near * 10 > seen.len() * 8, "{near} of {}", seen.len());
    }
}

/// How high the saddle is at its corners, in metres.
const SADDLE: f32 = 0.8;

/// A saddle over the plane of x and z whose straight lines run along both.
fn saddle(sides: u32) -> Mesh {
    let vertex = |k: u32| {
        let [u, v] = [k % (sides + 1), k / (sides + 1)].map(|k| k as f32 / sides as f32);
        let (x, z) = (u - 0.5, v - 0.5);
        let (tangent, bitangent) = (Vec3::new(1.0, SADDLE * z, 0.0), Vec3::new(0.0, SADDLE * x, 1.0));
        let normal = bitangent.cross(tangent).normalize();
        Vertex { position: Vec3::new(x, SADDLE * x * z, z), normal, tangent, bitangent, uv: Vec2::new(u, v) }
    };
    let quad = |k: u32| {
        let a = k % sides + k / sides * (sides + 1);
        let (b, c, d) = (a + 1, a + sides + 1, a + sides + 2);
        [[a, c, b], [b, c, d]]
    };
    let vertices = (0..(sides + 1) * (sides + 1)).map(vertex).collect();
    Mesh::new(vertices, (0..sides * sides).flat_map(quad).collect()).expect("a mesh")
}

#[test]
fn a_saddle_takes_three_coefficients() {
    let map = || floor(0.1, -0.1);
    let of = |surface, settings: &[(&str, f64)]| {
        on_cpu(saddle(32), map(), selection("exact", surface, settings), DVec3::new(0.8, 0.5, 0.9))
    };
    let error = |found: &[PixelOut]| {
        let off = found.iter().filter(|pixel| pixel.hit == 1).map(|pixel| {
            let p = pixel.position;
            // How far the point is under the saddle, by its slope.
            let (dx, dz) = (SADDLE * p.z, SADDLE * p.x);
            let under = (SADDLE * p.x * p.z - p.y) / (1.0 + dx * dx + dz * dz).sqrt();
            f64::from((under - 0.1).abs())
        });
        let mut off: Vec<f64> = off.collect();
        off.sort_by(f64::total_cmp);
        assert!(off.len() > 2000);
        off[off.len() * 9 / 10]
    };
    let plane = error(&of("plane", &[]));
    let two = error(&of("quadric-vertical", &[("surface.coefficients", 2.0)]));
    let three = error(&of("quadric-vertical", &[]));
    println!("plane {plane:.5}, two {two:.5}, three {three:.5}");
    assert!(10.0 * three < two && 10.0 * three < plane, "{plane} {two} {three}");
}

#[test]
fn both_backends_show_the_same() {
    if !has_adapter() {
        return;
    }
    let eye = DVec3::new(0.5, 0.9, 1.2);
    let leeway = Leeway::of_any();
    let cases = [
        ("relief", "quadric-vertical", 0.0, -0.05, false),
        ("exact", "quadric-vertical", 1.0, 0.02, true),
        ("cone", "quadric-vertical", 0.0, -0.06, true),
        ("relief", "quadric-perpendicular", 1.0, -0.02, false),
    ];
    for (method, surface, lift, bias_m, two_sided) in cases {
        let of = |backend| {
            let selection = selection(method, surface, &[("surface.lift", lift)]);
            let ring = torus(32, 16).expect("a mesh").tiled(Vec2::new(6.0, 2.0)).expect("proper tiles");
            let surface = Surface::new(ring, waves(0.05, bias_m)).with_selection(selection);
            pixels(surface.with_two_sided(two_sided), eye, backend)
        };
        let (cpu, gpu) = (of(BackendChoice::Cpu), of(BackendChoice::Gpu));
        let within_m = 4e-6 * leeway.rounding;
        let same = |(a, b): &(&PixelOut, &PixelOut)| {
            a.hit == b.hit
                && (a.hit == 0 || ((a.t - b.t).abs() < within_m && a.cell == b.cell && a.lit == b.lit))
        };
        let (seen, equal) =
            (cpu.iter().filter(|pixel| pixel.hit == 1).count(), cpu.iter().zip(&gpu).filter(same).count());
        println!(
            "{method} {surface} lift {lift} bias {bias_m}: {equal} of {} pixels, {seen} seen",
            cpu.len()
        );
        let most = leeway.outliers * seen as f64 / 1000.0;
        assert!(seen > 3000 && (cpu.len() - equal) as f64 <= most, "{method} {surface} {bias_m}");
    }
}
