//! Grids of frames as pictures: blended as engines do, and intersected.

use relief_core::camera::Ray;
use relief_core::object::{GridMapping, ImageObject, JumpCells};
use relief_maps::Maps;
use relief_render::camera::Camera;
use relief_render::glam::DVec3;
use relief_render::render;
use relief_render::scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use relief_tests::adapter::has_adapter;
use relief_tests::spheres::{CUBE, first_on_spheres, grid_of_spheres, object_of_spheres};

const SIZE: [u32; 2] = [140, 110];

/// The share of covered pixels that must show the same place.
const ALIKE: f64 = 0.999;

const EYES: [DVec3; 3] = [DVec3::new(1.0, 0.8, 3.0), DVec3::new(-2.6, 1.1, 1.3), DVec3::new(0.3, -3.0, 1.2)];

fn camera(eye: DVec3) -> Camera {
    Camera::new(eye, DVec3::new(0.0, 0.05, 0.0), 35.0).expect("a camera")
}

fn selection(method: &str, settings: &[(&str, f64)]) -> Selection {
    let mut selection = Selection::method(method).expect("a method");
    selection.choose("shadow", "none").expect("a listed name");
    for (key, value) in settings {
        match value.is_nan() {
            true => selection.choose("surface", key).expect("a listed name"),
            false => selection.set(key, *value).expect("a setting"),
        }
    }
    selection
}

fn pixels(object: &ImageObject, selection: Selection, eye: DVec3, backend: BackendChoice) -> Vec<PixelOut> {
    let surface = Surface::of_object(object.clone()).expect("something to see").with_selection(selection);
    let scene = Scene::builder(surface)
        .camera(camera(eye))
        .size(SIZE[0], SIZE[1])
        .samples(1)
        .backend(backend)
        .build()
        .expect("a proper scene");
    render(&scene, &mut Maps::in_memory(), &|_, _| {}).expect("a picture").rendering.pixels
}

/// The surface `frames` in place of `object`.
const OF_FRAMES: (&str, f64) = ("frames", f64::NAN);

/// The share of covered pixels that show what `truth` says of their rays, to a ten thousandth of the ball.
fn as_told(pixels: &[PixelOut], eye: DVec3, truth: impl Fn(&Ray) -> Option<f64>) -> f64 {
    let camera = camera(eye);
    let (mut covered, mut alike) = (0, 0);
    for (at, pixel) in pixels.iter().enumerate() {
        let [x, y] = [at as u32 % SIZE[0], at as u32 / SIZE[0]];
        let ray = camera.ray(x, y, SIZE[0], SIZE[1]);
        let told = truth(&ray);
        covered += usize::from(told.is_some() || pixel.hit == 1);
        alike += usize::from(match told {
            Some(t) => pixel.hit == 1 && (t - f64::from(pixel.depth)).abs() < 2e-4,
            None => false,
        });
    }
    assert!(covered > 2500, "{covered} pixels");
    f64::from(alike as u32) / f64::from(covered as u32)
}

#[test]
fn blends_are_those_that_the_core_tells() {
    let turned = GridMapping::Octahedral;
    for (eye, (mapping, side, steps)) in
        EYES.into_iter().zip([(turned, 6, 3), (turned, 5, 0), (turned, 9, 1)])
    {
        let object = grid_of_spheres(mapping, side, 48);
        let seen = pixels(
            &object,
            selection("impostor-blend", &[("object.steps", f64::from(steps))]),
            eye,
            BackendChoice::Cpu,
        );
        let frames = object.frames().expect("a grid");
        let share = as_told(&seen, eye, |ray| frames.blended(ray, steps));
        let other = as_told(&seen, eye, |ray| frames.blended(ray, steps + 1));
        println!("{side} frames, {steps} steps: {share:.5}, another count of steps {other:.5}");
        assert!(share >= ALIKE && other < 0.98, "{share} {other}");
    }
}

#[test]
fn the_upper_half_of_directions_makes_a_grid_too() {
    let object = grid_of_spheres(GridMapping::HemiOctahedral, 6, 48);
    let frames = object.frames().expect("a grid");
    for eye in &EYES[..2] {
        let seen = pixels(&object, selection("impostor-blend", &[]), *eye, BackendChoice::Cpu);
        let share = as_told(&seen, *eye, |ray| frames.blended(ray, 3));
        assert!(share >= ALIKE, "{share}");
    }
}

fn meets_box([low, high]: [DVec3; 2], ray: &Ray) -> bool {
    let (to_low, to_high) = ((low - ray.origin) / ray.direction, (high - ray.origin) / ray.direction);
    to_low.min(to_high).max_element() <= to_low.max(to_high).min_element()
}

#[test]
fn three_frames_are_intersected_as_the_core_does() {
    for (eye, side) in EYES.into_iter().zip([5, 8, 11]) {
        let object = grid_of_spheres(GridMapping::Octahedral, side, 48);
        let seen = pixels(&object, selection("depth-object", &[OF_FRAMES]), eye, BackendChoice::Cpu);
        let frames = object.frames().expect("a grid");
        // Three frames reach farther than all do, but the box around what all see ends them.
        let bounds = object.bounds().expect("something to see");
        let share = as_told(&seen, eye, |ray| {
            frames.first_hit(ray).filter(|_| meets_box(bounds, ray)).map(|hit| hit.t)
        });
        let blend = as_told(&seen, eye, |ray| frames.blended(ray, 3));
        println!("{side} frames: {share:.5}, as a blend {blend:.5}");
        assert!(share >= ALIKE && blend < 0.9, "{share} {blend}");
    }
}

#[test]
fn objects_without_the_images_that_are_asked_for_are_refused() {
    let is_shown = |object: &ImageObject, selection: Selection| {
        let surface = Surface::of_object(object.clone()).expect("something to see").with_selection(selection);
        Scene::builder(surface).build().is_ok()
    };
    let all = selection("depth-object", &[]);
    let three = selection("depth-object", &[OF_FRAMES]);
    let blend = selection("impostor-blend", &[]);
    let colours = selection("depth-object", &[("object.color", 3.0)]);
    // Six images are no grid, and 81 too many to ask all.
    let six = object_of_spheres(&CUBE, 16, JumpCells::Highest);
    assert_eq!([all, three, blend, colours].map(|of| is_shown(&six, of)), [true, false, false, false]);
    let many = grid_of_spheres(GridMapping::Octahedral, 9, 16);
    assert_eq!([all, three, blend, colours].map(|of| is_shown(&many, of)), [false, true, true, false]);
    let few = grid_of_spheres(GridMapping::HemiOctahedral, 8, 16);
    assert_eq!([all, three, blend, colours].map(|of| is_shown(&few, of)), [true; 4]);
}

/// Of pixels that see the spheres or should the share that do both, and the mean error of their depth.
fn beside_truth(pixels: &[PixelOut], eye: DVec3) -> (f64, f64) {
    let camera = camera(eye);
    let (mut both, mut either, mut off) = (0, 0, 0.0);
    for (at, pixel) in pixels.iter().enumerate() {
        let truth = first_on_spheres(&camera.ray(at as u32 % SIZE[0], at as u32 / SIZE[0], SIZE[0], SIZE[1]));
        either += usize::from(truth.is_some() || pixel.hit == 1);
        if let (Some(t), 1) = (truth, pixel.hit) {
            both += 1;
            off += (t - f64::from(pixel.depth)).abs();
        }
    }
    (f64::from(both) / either as f64, off / f64::from(both))
}

#[test]
fn images_intersected_are_nearer_to_the_truth_than_blended() {
    // As many texels: six images of 147 a side, and 36 frames of 60.
    let six = object_of_spheres(&CUBE, 147, JumpCells::Highest);
    let grid = grid_of_spheres(GridMapping::Octahedral, 6, 60);
    for eye in EYES {
        let of = |object, selection| beside_truth(&pixels(object, selection, eye, BackendChoice::Cpu), eye);
        let exact = of(&six, selection("depth-object", &[]));
        let blend = of(&grid, selection("impostor-blend", &[]));
        println!("{exact:.4?} beside {blend:.4?}");
        assert!(1.0 - exact.0 < 0.5 * (1.0 - blend.0) && exact.1 < 0.25 * blend.1, "{exact:?} {blend:?}");
    }
}

#[test]
fn both_backends_show_the_same_frames() {
    if !has_adapter() {
        return;
    }
    let object = grid_of_spheres(GridMapping::Octahedral, 9, 40);
    let ways: [(&str, &[(&str, f64)]); 3] = [
        ("impostor-blend", &[]),
        ("impostor-blend", &[("object.steps", 0.0), ("object.color", 0.0)]),
        ("depth-object", &[OF_FRAMES, ("object.color", 3.0)]),
    ];
    for (eye, (method, settings)) in EYES.into_iter().zip(ways) {
        let [cpu, gpu] = [BackendChoice::Cpu, BackendChoice::Gpu]
            .map(|backend| pixels(&object, selection(method, settings), eye, backend));
        let covered = cpu.iter().zip(&gpu).filter(|(a, b)| a.hit == 1 || b.hit == 1);
        let alike = covered.clone().filter(|(a, b)| {
            let color = [a.color.x - b.color.x, a.color.y - b.color.y, a.color.z - b.color.z];
            a.hit == b.hit && (a.depth - b.depth).abs() < 1e-4 && color.iter().all(|part| part.abs() < 1e-3)
        });
        let share = alike.count() as f64 / covered.count() as f64;
        println!("{method} {settings:?}: {share:.5}");
        assert!(share >= ALIKE, "{method}: {share}");
    }
}
