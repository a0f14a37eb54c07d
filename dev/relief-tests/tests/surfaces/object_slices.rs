//! Slices through objects of images: against points of slices that the core knows to be inside, against the
//! object that they come nearer to, and on both backends.
//!
//! Kautz and Seidel 2001, sections 4.1 and 5.

use glam::DVec3;
use relief_core::Watch;
use relief_core::camera::Ray;
use relief_core::object::JumpCells;
use relief_mesh::{BoxSlicer, SliceAnchor, SliceDirection};
use relief_scene::BackendChoice;
use relief_shaders::cpu::PixelOut;
use relief_tests::adapter::has_adapter;
use relief_tests::object_pictures::{ALIKE, EYES, alike, alike_on_both, camera, pixels, rays, selection};
use relief_tests::objects::{Asked, Subject};
use relief_tests::spheres::{CUBE, object_of_spheres, views_of_spheres};

/// Texels of a side of the images.
const SIDE: u32 = 64;

/// Slices over the ball: none lies just between texels, where masks are a half.
const COUNT: f64 = 47.0;

/// The numbers of the directions of slices.
const DIRECTIONS: [&str; 5] = ["auto", "a", "b", "c", "screen"];

/// What is seen of the slices of a method, by the settings of the slices and others.
fn seen(method: &str, settings: &[(&str, f64)], eye: DVec3, backend: BackendChoice) -> Vec<PixelOut> {
    let object = object_of_spheres(&CUBE, SIDE, JumpCells::Highest);
    pixels(&object, selection(method, settings), eye, backend)
}

/// The object, and what the judge knows of it.
fn subject() -> Subject {
    let (views, maps) = views_of_spheres(&CUBE, SIDE);
    Subject::new("spheres".to_owned(), views, maps, JumpCells::Highest, 4.0)
}

/// Where each pixel's ray first meets a slice that is in the object, along the view; none where it does not.
fn judged(
    subject: &Subject,
    asked: Asked,
    direction: SliceDirection,
    count: f64,
    eye: DVec3,
) -> Vec<Option<f64>> {
    let radius = subject.object.views()[0].ball().1;
    let bounds = subject.object.bounds().expect("something to see");
    let slicer = BoxSlicer::new(bounds, 2.0 * radius / count, direction).expect("a box");
    let mut slices = Vec::new();
    slicer.each(&Watch::none(), |slice| slices.push(slice.clone())).expect("slices");
    let first = |ray: Ray| {
        let on = |slice: &Vec<DVec3>| {
            let normal = (slice[1] - slice[0]).cross(slice[2] - slice[0]);
            let t = normal.dot(slice[0] - ray.origin) / normal.dot(ray.direction);
            let point = ray.at(t);
            let sides = (0..slice.len()).map(|k| {
                let (from, to) = (slice[k], slice[(k + 1) % slice.len()]);
                (to - from).cross(point - from).dot(normal)
            });
            let is_inside = t > 0.0 && sides.clone().all(|side| side >= 0.0);
            (is_inside && subject.is_in_all(point, asked)).then(|| (point - eye).dot(camera(eye).forward()))
        };
        slices.iter().filter_map(on).min_by(f64::total_cmp)
    };
    rays(eye).map(first).collect()
}

/// The share of pixels that show what they should, of those that show something or should.
fn right(pixels: &[PixelOut], truth: &[Option<f64>]) -> f64 {
    let (mut all, mut right) = (0, 0);
    for (pixel, truth) in pixels.iter().zip(truth) {
        let is_right = truth.is_some_and(|truth| (f64::from(pixel.depth) - truth).abs() < 1e-4);
        all += u32::from(pixel.hit == 1 || truth.is_some());
        right += u32::from(pixel.hit == 1 && is_right);
    }
    assert!(all > 2500, "{all} pixels");
    f64::from(right) / f64::from(all)
}

#[test]
fn slices_are_drawn_where_all_images_see_something() {
    let subject = subject();
    for (place, name) in DIRECTIONS.iter().enumerate() {
        let eye = EYES[place % 3];
        let direction = match *name {
            "auto" => SliceDirection::Facing(camera(eye)),
            "a" => SliceDirection::Surface,
            "b" => SliceDirection::AcrossU,
            "c" => SliceDirection::AcrossV,
            _ => SliceDirection::Screen(camera(eye), SliceAnchor::Eye),
        };
        for (method, asked) in [("depth-object-slices", Asked::Object), ("visual-hull-slices", Asked::Hull)] {
            let settings = [("slices.count", COUNT), ("slices.direction", place as f64)];
            let shown = seen(method, &settings, eye, BackendChoice::Cpu);
            let truth = judged(&subject, asked, direction, COUNT, eye);
            let share = right(&shown, &truth);
            println!("{method}, {name}: {share:.5} right");
            assert!(share >= ALIKE, "{method}, {name}: {share}");
            // Slices that lie elsewhere are noticed.
            let wrong = right(&shown, &judged(&subject, asked, direction, COUNT * 1.02, eye));
            assert!(wrong < 0.5, "{method}, {name}: {wrong}");
        }
    }
}

/// Of pixels that show the object or should, the share that do both, and how much farther away it is seen on
/// average.
fn beside_object(slices: &[PixelOut], object: &[PixelOut]) -> (f64, f64) {
    let either = slices.iter().zip(object).filter(|(slice, pixel)| slice.hit == 1 || pixel.hit == 1).count();
    let both = || slices.iter().zip(object).filter(|(slice, pixel)| slice.hit == 1 && pixel.hit == 1);
    let off: f64 = both().map(|(slice, pixel)| f64::from(slice.depth - pixel.depth)).sum();
    (both().count() as f64 / either as f64, off / both().count() as f64)
}

#[test]
fn slices_come_nearer_to_the_object_with_every_doubling() {
    for (sliced, whole) in [("depth-object-slices", "depth-object"), ("visual-hull-slices", "visual-hull")] {
        for (eye, direction) in EYES.into_iter().zip([0.0, 4.0, 0.0]) {
            let truth = seen(whole, &[], eye, BackendChoice::Cpu);
            let mut before = (0.0, f64::INFINITY);
            for count in [12.0, 24.0, 48.0, 96.0, 192.0] {
                let settings = [("slices.count", count), ("slices.direction", direction)];
                let now = beside_object(&seen(sliced, &settings, eye, BackendChoice::Cpu), &truth);
                println!("{sliced}, {direction}, {count}: {now:.5?}");
                assert!(now.0 > before.0 && now.1 < before.1, "{sliced}, {count}: {now:?} after {before:?}");
                before = now;
            }
            assert!(before.0 > 0.98 && before.1 < 0.02, "{sliced}: {before:?}");
        }
    }
}

#[test]
fn both_backends_show_the_same_slices() {
    if !has_adapter() {
        return;
    }
    for (place, eye) in EYES.into_iter().enumerate() {
        for (method, cells) in [("depth-object-slices", place as f64), ("visual-hull-slices", 2.0)] {
            let settings = [("slices.direction", 2.0 * place as f64), ("object.cells", cells)];
            let [cpu, gpu] =
                [BackendChoice::Cpu, BackendChoice::Gpu].map(|backend| seen(method, &settings, eye, backend));
            let [share, least] = alike_on_both(&cpu, &gpu);
            println!("{method}, {settings:?}: {share:.5} alike");
            assert!(share >= least, "{method}, {settings:?}: {share}");
        }
    }
}

#[test]
fn counting_in_passes_shows_what_the_product_does() {
    if !has_adapter() {
        return;
    }
    let of = |images: &[DVec3], method: &str, place: usize, pass: f64| {
        let object = object_of_spheres(images, SIDE, JumpCells::Highest);
        let settings =
            [("slices.count", COUNT), ("slices.direction", 2.0 * place as f64), ("geometry.pass", pass)];
        pixels(&object, selection(method, &settings), EYES[place], BackendChoice::Gpu)
    };
    for (place, method) in [
        (0, "depth-object-slices"),
        (1, "visual-hull-slices"),
        (2, "depth-object-slices"),
        (1, "depth-object-slices"),
    ] {
        let [product, counted] = [0.0, 1.0].map(|pass| of(&CUBE, method, place, pass));
        let differ = product.iter().zip(&counted).filter(|(one, other)| {
            let of = |pixel: &PixelOut| (pixel.hit, pixel.position, pixel.color, pixel.height);
            of(one) != of(other)
        });
        let (share, differ) = (alike(&product, &counted), differ.count());
        println!("{method}, {place}: {share:.5} alike, {differ} pixels differ in something");
        assert!(share >= ALIKE && differ < 20, "{method}, {place}: {share}, {differ}");
        // As when the passes of the last two images are lost.
        let lost = alike(&product, &of(&CUBE[..4], method, place, 1.0));
        assert!(lost < 0.99, "{method}, {place}: {lost}");
    }
}
