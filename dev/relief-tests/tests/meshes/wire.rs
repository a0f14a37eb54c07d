//! The edges of base meshes over pictures: where they are, how strong, and over both backends' pictures.

use glam::DVec3;
use relief_core::camera::{Camera, Projection};
use relief_core::mesh::{Mesh, square, torus};
use relief_core::{HeightMap, Watch, Wrap};
use relief_maps::Maps;
use relief_render::gpu::AdapterChoice;
use relief_render::{Renderer, Wire};
use relief_scene::{Sampling, Scene, SceneBuilder, Surface, View};
use relief_shaders::cpu::PixelOut;
use relief_testing::maps;
use relief_tests::adapter::open;

const SIZE: [u32; 2] = [160, 120];

fn backends() -> Vec<Renderer> {
    let gpu = open(AdapterChoice::Any).map(|gpu| Renderer::on_gpu(gpu, Sampling::Exact));
    [Renderer::on_cpu()].into_iter().chain(gpu).collect()
}

fn scene(mesh: Mesh, map: HeightMap, view: impl Fn(&Surface) -> SceneBuilder) -> Scene {
    let surface = Surface::new(mesh, map);
    view(&surface).size(SIZE[0], SIZE[1]).samples(1).build().expect("a proper scene")
}

/// A relief that is its base.
fn level() -> HeightMap {
    let map = HeightMap::new(1, 1, vec![1.0], Wrap::Repeat).expect("a map");
    map.with_displacement(0.02, -0.02).expect("lengths")
}

fn pixels(renderer: &mut Renderer, scene: &Scene) -> Vec<PixelOut> {
    renderer.render(scene, &mut Maps::in_memory(), &Watch::none()).expect("a picture").rendering.pixels
}

/// A white picture with the lines over it.
fn drawn(scene: &Scene, pixels: &[PixelOut]) -> Vec<f32> {
    let mut wire = Wire::new(scene);
    let rows = pixels.chunks(SIZE[0] as usize).flat_map(|row| {
        let mut colors = vec![[1.0; 3]; row.len()];
        wire.next_row(row, &mut colors);
        colors
    });
    // Of white is left in blue what is not the line's.
    rows.map(|[_, _, blue]| 1.0 - blue).collect()
}

/// A place on an edge: its distance from a pixel's centre, and how many pixels' widths it lies behind what
/// the pixel shows.
type Sample = (f64, f64);

/// For every pixel the places on edges nearer than two pixels.
fn samples(scene: &Scene, pixels: &[PixelOut]) -> Vec<Vec<Sample>> {
    let [width, height] = SIZE.map(f64::from);
    let camera = scene.camera();
    let matrix = camera.view_projection(width / height, 1e-3, 100.0).expect("planes");
    let mut all = vec![Vec::new(); pixels.len()];
    let mesh = scene.surfaces()[0].mesh();
    for [a, b, c] in mesh.triangles() {
        for [from, to] in [[a, b], [b, c], [c, a]] {
            let [from, to] = [from, to].map(|at| mesh.vertices()[*at as usize].position.as_dvec3());
            for step in 0..=1000 {
                let point = from.lerp(to, f64::from(step) / 1000.0);
                let depth = camera.forward().dot(point - camera.eye());
                if depth <= 0.0 {
                    continue;
                }
                let at = matrix.project_point3(point);
                let [x, y] = [0.5 * (1.0 + at.x) * width, 0.5 * (1.0 - at.y) * height];
                let pixel_m = if camera.is_orthographic() { 1.0 } else { depth };
                let pixel_m = pixel_m * 2.0 * camera.half_height() / height;
                for (i, j) in (-2..=2).flat_map(|i| (-2..=2).map(move |j| (i, j))) {
                    let [column, row] = [x.floor() as i64 + i, y.floor() as i64 + j];
                    if !(0..SIZE[0].into()).contains(&column) || !(0..SIZE[1].into()).contains(&row) {
                        continue;
                    }
                    let number = (row * i64::from(SIZE[0]) + column) as usize;
                    let distance = (column as f64 + 0.5 - x).hypot(row as f64 + 0.5 - y);
                    let pixel = &pixels[number];
                    let before = if pixel.hit == 1 { depth - f64::from(pixel.depth) } else { 0.0 };
                    all[number].push((distance, before / pixel_m));
                }
            }
        }
    }
    all
}

/// What is wrong with the lines of a picture.
fn mistake(lines: &[f32], samples: &[Vec<Sample>]) -> Option<String> {
    lines.iter().zip(samples).enumerate().find_map(|(number, (&part, near))| {
        let nearest = |of: &dyn Fn(&&Sample) -> bool| {
            near.iter().filter(of).map(|(distance, _)| *distance).fold(f64::INFINITY, f64::min)
        };
        let [any, shown] = [nearest(&|_| true), nearest(&|(_, behind)| *behind < 3.5)];
        let might_show = nearest(&|(_, behind)| *behind < 8.5);
        let wrong = match part {
            0.0 => any < 0.9,
            _ if any > 1.05 => true,
            // Two thirds of what a line is where it is seen best.
            part if shown < 0.3 => part < 0.6,
            part if might_show > 1.05 => part > 0.21,
            _ => false,
        };
        wrong.then(|| format!("pixel {number}: {part}, {any} {shown} {might_show}"))
    })
}

#[test]
fn lines_lie_on_the_edges_and_are_faint_behind_what_is_seen() {
    let carved = || maps::ALL[2].build(Wrap::Repeat).with_displacement(0.02, -0.02).expect("lengths");
    let within = Camera::new(DVec3::new(0.35, 0.02, 0.0), DVec3::new(0.0, 0.0, 0.4), 60.0).expect("a camera");
    let scenes = [
        scene(torus(16, 8).expect("a mesh"), level(), |surface| Scene::builder(surface.clone())),
        scene(torus(16, 8).expect("a mesh"), carved(), |surface| {
            Scene::builder(surface.clone()).fitted_orthographic_camera(View::Corner)
        }),
        // Edges go by the eye and end behind it.
        scene(torus(16, 8).expect("a mesh"), level(), |surface| {
            Scene::builder(surface.clone().with_two_sided(true)).camera(within)
        }),
    ];
    for renderer in &mut backends() {
        for (number, scene) in scenes.iter().enumerate() {
            let pixels = pixels(renderer, scene);
            let (lines, samples) = (drawn(scene, &pixels), samples(scene, &pixels));
            assert_eq!(mistake(&lines, &samples), None, "scene {number}");
            let strong = lines.iter().filter(|part| **part > 0.6).count();
            let faint = lines.iter().filter(|part| (0.05..0.21).contains(*part)).count();
            assert!(strong > 300 && faint > 300, "scene {number}: {strong} {faint}");
            // Other lines are wrong ones.
            let mut moved = lines.clone();
            moved.rotate_right(2);
            assert!(mistake(&moved, &samples).is_some());
            let all_strong: Vec<f32> = lines.iter().map(|part| part * 4.0).collect();
            assert!(mistake(&all_strong, &samples).is_some());
            assert!(mistake(&vec![0.0; lines.len()], &samples).is_some());
        }
    }
}

#[test]
fn a_line_is_a_pixel_wide_and_the_same_over_both_backends() {
    // Two pixels a centimetre, so that edges lie on and between centres.
    let camera = Projection::Orthographic { height_m: 1.2 };
    let camera = Camera::with(DVec3::new(0.0, 1.0, 0.0), DVec3::ZERO, camera).expect("a camera");
    let scene =
        scene(square(4).expect("a mesh"), level(), |surface| Scene::builder(surface.clone()).camera(camera));
    let pictures: Vec<Vec<f32>> =
        backends().iter_mut().map(|renderer| drawn(&scene, &pixels(renderer, &scene))).collect();
    let row = SIZE[1] as usize / 2 + 5;
    for lines in &pictures {
        let row = &lines[row * SIZE[0] as usize..][..SIZE[0] as usize];
        // Five upright edges, and four diagonal ones that are a root of two wide across a row.
        let sum: f32 = row.iter().sum();
        let expected = 0.9 * (5.0 + 4.0 * std::f32::consts::SQRT_2);
        assert!((sum - expected).abs() < 0.1 * expected, "{sum} {expected}");
    }
    assert!(pictures.iter().all(|lines| *lines == pictures[0]));
}
