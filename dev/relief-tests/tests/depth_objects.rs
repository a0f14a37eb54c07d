//! Objects of images with depth as pictures: against what the images were made of, and on both backends.
//!
//! Kautz and Seidel 2001, section 4.

use relief_core::object::{ImageObject, JumpCells};
use relief_core::{HeightMap, Wrap};
use relief_render::glam::DVec3;
use relief_render::scene::BackendChoice;
use relief_shaders::cpu::PixelOut;
use relief_tests::adapter::has_adapter;
use relief_tests::object_pictures::{ALIKE, EYES, alike, beside_truth, pixels, selection};
use relief_tests::spheres::{CUBE, object_of_spheres};

/// What is seen of the spheres through images of so many texels a side.
fn seen(side: u32, settings: &[(&str, f64)], eye: DVec3, backend: BackendChoice) -> Vec<PixelOut> {
    let object = object_of_spheres(&CUBE, side, JumpCells::Highest);
    pixels(&object, selection("depth-object", settings), eye, backend)
}

#[test]
fn finer_images_come_nearer_to_what_they_were_made_of() {
    for eye in EYES {
        let mut before = (0.0, 1.0);
        for side in [24, 48, 96, 192] {
            let now = beside_truth(&seen(side, &[], eye, BackendChoice::Cpu), eye);
            println!("{side}: {now:.5?}");
            assert!(now.0 > before.0 && now.1 < before.1, "{side}: {now:?} after {before:?}");
            before = now;
        }
        assert!(before.0 > 0.985 && before.1 < 0.004, "{before:?}");
    }
}

#[test]
fn hulls_hold_the_object_and_three_silhouettes_of_a_cube_are_all() {
    for eye in EYES {
        let of = |directions: &[DVec3]| {
            let object = object_of_spheres(directions, 64, JumpCells::Highest);
            pixels(&object, selection("visual-hull", &[]), eye, BackendChoice::Cpu)
        };
        let (six, three) = (of(&CUBE), of(&[CUBE[0], CUBE[2], CUBE[4]]));
        let share = alike(&six, &three);
        // Fewer see less of the object, and others another one.
        let two = alike(&six, &of(&[CUBE[0], CUBE[2]]));
        assert!(share >= ALIKE && two < 0.9, "{share} {two}");
        let object = seen(64, &[("object.cells", 0.0)], eye, BackendChoice::Cpu);
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
            [BackendChoice::Cpu, BackendChoice::Gpu].map(|backend| seen(48, settings, *eye, backend));
        let share = alike(&cpu, &gpu);
        println!("{settings:?}: {share:.5} alike");
        assert!(share >= ALIKE, "{settings:?}: {share}");
    }
    let hull = |backend| {
        let object = object_of_spheres(&CUBE, 48, JumpCells::Highest);
        pixels(&object, selection("visual-hull", &[]), EYES[1], backend)
    };
    let share = alike(&hull(BackendChoice::Cpu), &hull(BackendChoice::Gpu));
    assert!(share >= ALIKE, "{share}");
}

#[test]
fn what_an_image_says_elsewhere_is_noticed() {
    // One image that looks from a little beside where it was made.
    let eye = EYES[0];
    let truth = beside_truth(&seen(96, &[], eye, BackendChoice::Cpu), eye);
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
    let wrong = pixels(&wrong, selection("depth-object", &[]), eye, BackendChoice::Cpu);
    let wrong = beside_truth(&wrong, eye);
    assert!(wrong.0 < truth.0 - 0.002 && wrong.1 > 2.0 * truth.1, "{wrong:?} beside {truth:?}");
}
