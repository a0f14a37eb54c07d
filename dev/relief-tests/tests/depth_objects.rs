//! Objects of images with depth as pictures: against what the images were made of, and on both backends.
//!
//! Kautz and Seidel 2001, section 4.

use relief_core::object::{ImageObject, JumpCells};
use relief_core::{HeightMap, Wrap};
use relief_maps::Maps;
use relief_render::camera::Camera;
use relief_render::glam::DVec3;
use relief_render::render;
use relief_render::scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;
use relief_shaders::cpu::PixelOut;
use relief_tests::adapter::has_adapter;
use relief_tests::spheres::{CUBE, first_on_spheres, object_of_spheres};

const SIZE: [u32; 2] = [150, 120];

/// The share of covered pixels that both backends must agree on.
const ALIKE: f64 = 0.999;

fn camera(eye: DVec3) -> Camera {
    Camera::new(eye, DVec3::new(0.0, 0.05, 0.0), 35.0).expect("a camera")
}

/// What is seen of the spheres through images of so many texels a side.
fn pixels(side: u32, settings: &[(&str, f64)], eye: DVec3, backend: BackendChoice) -> Vec<PixelOut> {
    pixels_of(object_of_spheres(&CUBE, side, JumpCells::Highest), settings, eye, backend)
}

fn pixels_of(
    object: ImageObject,
    settings: &[(&str, f64)],
    eye: DVec3,
    backend: BackendChoice,
) -> Vec<PixelOut> {
    pixels_by("depth-object", object, settings, eye, backend)
}

fn pixels_by(
    method: &str,
    object: ImageObject,
    settings: &[(&str, f64)],
    eye: DVec3,
    backend: BackendChoice,
) -> Vec<PixelOut> {
    let mut selection = Selection::method(method).expect("a method");
    selection.choose("shadow", "none").expect("a listed name");
    for (key, value) in settings {
        selection.set(key, *value).expect("a setting");
    }
    let surface = Surface::of_object(object).expect("something to see").with_selection(selection);
    let scene = Scene::builder(surface)
        .camera(camera(eye))
        .size(SIZE[0], SIZE[1])
        .samples(1)
        .backend(backend)
        .build()
        .expect("a proper scene");
    render(&scene, &mut Maps::in_memory(), &|_, _| {}).expect("a picture").rendering.pixels
}

/// Of pixels that see the spheres or should, the share that do both, and the mean error of their depth.
fn beside_truth(pixels: &[PixelOut], eye: DVec3) -> (f64, f64) {
    let camera = camera(eye);
    let (mut both, mut either, mut off) = (0, 0, 0.0);
    for (at, pixel) in pixels.iter().enumerate() {
        let [x, y] = [at as u32 % SIZE[0], at as u32 / SIZE[0]];
        let ray = camera.ray(x, y, SIZE[0], SIZE[1]);
        let truth = first_on_spheres(&ray);
        either += usize::from(truth.is_some() || pixel.hit == 1);
        if let (Some(t), 1) = (truth, pixel.hit) {
            both += 1;
            off += (t - f64::from(pixel.depth)).abs();
        }
    }
    (f64::from(both) / either as f64, off / f64::from(both))
}

const EYES: [DVec3; 3] = [DVec3::new(1.0, 0.8, 3.0), DVec3::new(-2.6, 1.1, 1.3), DVec3::new(0.3, -3.0, 1.2)];

#[test]
fn finer_images_come_nearer_to_what_they_were_made_of() {
    for eye in EYES {
        let mut before = (0.0, 1.0);
        for side in [24, 48, 96, 192] {
            let now = beside_truth(&pixels(side, &[], eye, BackendChoice::Cpu), eye);
            println!("{side}: {now:.5?}");
            assert!(now.0 > before.0 && now.1 < before.1, "{side}: {now:?} after {before:?}");
            before = now;
        }
        assert!(before.0 > 0.985 && before.1 < 0.004, "{before:?}");
    }
}

/// The share of covered pixels that show the same place.
fn alike(one: &[PixelOut], other: &[PixelOut]) -> f64 {
    let covered = one.iter().zip(other).filter(|(a, b)| a.hit == 1 || b.hit == 1);
    let alike = covered.clone().filter(|(a, b)| {
        let apart = [a.position.x - b.position.x, a.position.y - b.position.y, a.position.z - b.position.z];
        a.hit == b.hit && apart.iter().all(|part| part.abs() <= 1e-4)
    });
    let covered = covered.count();
    assert!(covered > 3000, "{covered} pixels");
    alike.count() as f64 / covered as f64
}

#[test]
fn hulls_hold_the_object_and_three_silhouettes_of_a_cube_are_all() {
    for eye in EYES {
        let of = |directions: &[DVec3]| {
            let object = object_of_spheres(directions, 64, JumpCells::Highest);
            pixels_by("visual-hull", object, &[], eye, BackendChoice::Cpu)
        };
        let (six, three) = (of(&CUBE), of(&[CUBE[0], CUBE[2], CUBE[4]]));
        let share = alike(&six, &three);
        // Fewer see less of the object, and others another one.
        let two = alike(&six, &of(&[CUBE[0], CUBE[2]]));
        assert!(share >= ALIKE && two < 0.9, "{share} {two}");
        let object = pixels(64, &[("object.cells", 0.0)], eye, BackendChoice::Cpu);
        let outside = object.iter().zip(&six).filter(|(object, hull)| {
            object.hit == 1 && !(hull.hit == 1 && hull.depth <= object.depth + 0.02)
        });
        let outside = outside.count();
        assert!(outside < 40, "{outside} pixels of the object before the hull");
    }
}

#[test]
fn both_backends_show_the_same_object() {
    if !has_adapter() {
        return;
    }
    let ways: [&[(&str, f64)]; 5] = [
        &[],
        &[("object.cells", 0.0)],
        &[("object.cells", 1.0)],
        &[("object.cells", 3.0)],
        &[("object.jump", 0.5), ("object.color", 1.0)],
    ];
    for (eye, settings) in EYES.iter().cycle().zip(ways) {
        let [cpu, gpu] =
            [BackendChoice::Cpu, BackendChoice::Gpu].map(|backend| pixels(48, settings, *eye, backend));
        let share = alike(&cpu, &gpu);
        println!("{settings:?}: {share:.5} alike");
        assert!(share >= ALIKE, "{settings:?}: {share}");
    }
    let hull = |backend| {
        let object = object_of_spheres(&CUBE, 48, JumpCells::Highest);
        pixels_by("visual-hull", object, &[], EYES[1], backend)
    };
    let share = alike(&hull(BackendChoice::Cpu), &hull(BackendChoice::Gpu));
    assert!(share >= ALIKE, "{share}");
}

#[test]
fn what_an_image_says_elsewhere_is_noticed() {
    // One image that looks from a little beside where it was made.
    let eye = EYES[0];
    let truth = beside_truth(&pixels(96, &[], eye, BackendChoice::Cpu), eye);
    let directions = CUBE.map(|from| if from == DVec3::X { DVec3::new(1.0, 0.02, 0.0) } else { from });
    let right = object_of_spheres(&CUBE, 96, JumpCells::Highest);
    let turned = object_of_spheres(&directions, 96, JumpCells::Highest);
    let (views, layout) = (right.views().to_vec(), turned.layout());
    let maps = layout.places().iter().map(|[column, row]| {
        HeightMap::from_fn(96, 96, Wrap::Clamp, |x, y| {
            turned.heights().texel(i64::from(column + x), i64::from(row + y))
        })
    });
    let maps: Vec<HeightMap> = maps.collect::<Result<_, _>>().expect("maps");
    let wrong = ImageObject::new(views, &maps, JumpCells::Highest, 4.0).expect("an object");
    let seen = pixels_of(wrong, &[], eye, BackendChoice::Cpu);
    let wrong = beside_truth(&seen, eye);
    assert!(wrong.0 < truth.0 - 0.002 && wrong.1 > 2.0 * truth.1, "{wrong:?} beside {truth:?}");
}
