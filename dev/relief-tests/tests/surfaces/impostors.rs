//! Grids of frames as pictures: blended as engines do, and intersected.

use glam::DVec3;
use relief_core::camera::Ray;
use relief_core::object::{GridMapping, ImageObject, JumpCells};
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use relief_tests::adapter::has_adapter;
use relief_tests::object_pictures::{ALIKE, EYES, alike_on_both, beside_truth, pixels, rays, selection};
use relief_tests::spheres::{CUBE, grid_of_spheres, object_of_spheres};

/// The intersection of three frames.
fn of_three(settings: &[(&str, f64)]) -> Selection {
    let mut selection = selection("depth-object", settings);
    selection.choose("surface", "frames").expect("a listed name");
    selection
}

/// The share of covered pixels that show what `truth` says of their rays, to a ten thousandth of the ball.
fn as_told(pixels: &[PixelOut], eye: DVec3, truth: impl Fn(&Ray) -> Option<f64>) -> f64 {
    let (mut covered, mut alike) = (0, 0);
    for (pixel, ray) in pixels.iter().zip(rays(eye)) {
        let told = truth(&ray);
        covered += u32::from(told.is_some() || pixel.hit == 1);
        let is_there = |t: f64| pixel.hit == 1 && (t - f64::from(pixel.depth)).abs() < 2e-4;
        alike += u32::from(told.is_some_and(is_there));
    }
    assert!(covered > 2500, "{covered} pixels");
    f64::from(alike) / f64::from(covered)
}

#[test]
fn blends_are_those_that_the_core_tells() {
    for (eye, (side, steps)) in EYES.into_iter().zip([(6, 3), (5, 0), (9, 1)]) {
        let object = grid_of_spheres(GridMapping::Octahedral, side, 48);
        let blend = selection("impostor-blend", &[("object.steps", f64::from(steps))]);
        let seen = pixels(&object, blend, eye, BackendChoice::Cpu);
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
        let seen = pixels(&object, of_three(&[]), eye, BackendChoice::Cpu);
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
    let three = of_three(&[]);
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
    let ways = [
        selection("impostor-blend", &[]),
        selection("impostor-blend", &[("object.steps", 0.0), ("object.color", 0.0)]),
        of_three(&[("object.color", 3.0)]),
    ];
    for (eye, selection) in EYES.into_iter().zip(ways) {
        let [cpu, gpu] =
            [BackendChoice::Cpu, BackendChoice::Gpu].map(|backend| pixels(&object, selection, eye, backend));
        let [share, least] = alike_on_both(&cpu, &gpu);
        let of_colour = cpu.iter().zip(&gpu).filter(|(a, b)| {
            let apart = [a.color.x - b.color.x, a.color.y - b.color.y, a.color.z - b.color.z];
            apart.iter().any(|part| part.abs() > 1e-3)
        });
        let others = of_colour.count() as f64 / cpu.iter().filter(|pixel| pixel.hit == 1).count() as f64;
        println!("{share:.5} alike, {others:.5} of another colour");
        assert!(share >= least && others <= 1.0 - least, "{share} {others}");
    }
}
