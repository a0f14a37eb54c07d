//! Objects of images with depth as pictures: against what the images were made of, and on both backends.
//!
//! Kautz and Seidel 2001, section 4.

use glam::DVec3;
use relief_core::object::{ImageObject, JumpCells};
use relief_core::raycast::Ray;
use relief_core::{HeightMap, Wrap};
use relief_scene::BackendChoice;
use relief_shaders::cpu::PixelOut;
use relief_tests::adapter::has_adapter;
use relief_tests::object_pictures::{
    ALIKE, EYES, alike, alike_on_both, beside_truth, pixels, rays, selection,
};
use relief_tests::spheres::{CUBE, eyes_on_spheres, normal_on_spheres, object_of_spheres};

/// Picture of the spheres through images with the given texels a side.
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
        let [share, least] = alike_on_both(&cpu, &gpu);
        println!("{settings:?}: {share:.5} alike");
        assert!(share >= least, "{settings:?}: {share}");
    }
    let hull = |backend| {
        let object = object_of_spheres(&CUBE, 48, JumpCells::Highest);
        pixels(&object, selection("visual-hull", &[]), EYES[1], backend)
    };
    let [share, least] = alike_on_both(&hull(BackendChoice::Cpu), &hull(BackendChoice::Gpu));
    assert!(share >= least, "{share}");
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

/// Object with every other image in perspective.
fn seen_from_eyes(away_m: f64, cells: JumpCells) -> ImageObject {
    let (views, maps) = eyes_on_spheres(&CUBE, away_m, 72);
    ImageObject::new(views, &maps, cells, 4.0).expect("an object")
}

/// The share of pixels that show what the core says, of those that show something or should.
fn as_the_core_says(pixels: &[PixelOut], eye: DVec3, first: impl Fn(&Ray) -> Option<f64>) -> f64 {
    let (mut all, mut right) = (0, 0);
    for (pixel, ray) in pixels.iter().zip(rays(eye)) {
        let truth = first(&Ray { origin: ray.origin, direction: ray.direction }).map(|t| ray.at(t));
        let at = DVec3::new(pixel.position.x.into(), pixel.position.y.into(), pixel.position.z.into());
        all += u32::from(pixel.hit == 1 || truth.is_some());
        right += u32::from(pixel.hit == 1 && truth.is_some_and(|truth| (truth - at).length() < 2e-4));
    }
    assert!(all > 2500, "{all} pixels");
    f64::from(right) / f64::from(all)
}

#[test]
fn images_from_eyes_show_what_the_core_says() {
    for (away_m, cells, eye) in [
        (1.3, JumpCells::Highest, EYES[0]),
        (2.5, JumpCells::Bilinear, EYES[1]),
        (2.5, JumpCells::Step, EYES[2]),
        // From within the ball: behind some of the eyes' backs.
        (1.6, JumpCells::Highest, DVec3::new(1.1, 0.9, 2.0)),
    ] {
        let object = seen_from_eyes(away_m, cells);
        let cells = [("object.cells", cells as u32 as f64)];
        let shown = pixels(&object, selection("depth-object", &cells), eye, BackendChoice::Cpu);
        let share = as_the_core_says(&shown, eye, |ray| object.first_hit(ray).map(|hit| hit.t));
        let hull = pixels(&object, selection("visual-hull", &[]), eye, BackendChoice::Cpu);
        let of_hull = as_the_core_says(&hull, eye, |ray| object.hull_first_hit(ray).map(|hit| hit.t));
        println!("{away_m} m, {cells:?}: {share:.5}, hull {of_hull:.5}");
        assert!(share >= ALIKE && of_hull >= ALIKE, "{away_m} m: {share}, hull {of_hull}");
        // The same eyes a little farther away are noticed.
        let other = seen_from_eyes(away_m * 1.1, JumpCells::Highest);
        let wrong = as_the_core_says(&shown, eye, |ray| other.first_hit(ray).map(|hit| hit.t));
        assert!(wrong < 0.9, "{away_m} m: {wrong}");
    }
}

#[test]
fn normals_of_images_from_eyes_are_those_of_what_they_saw() {
    // Median of the degrees between a pixel's normal and the sphere's.
    let off = |object: &ImageObject| {
        let shown = pixels(object, selection("depth-object", &[]), EYES[0], BackendChoice::Cpu);
        let mut all: Vec<f64> = shown
            .iter()
            .filter(|pixel| pixel.hit == 1)
            .map(|pixel| {
                let of = |v: [f32; 3]| DVec3::from(v.map(f64::from));
                let (normal, at) = (pixel.normal, pixel.position);
                let truth = normal_on_spheres(of([at.x, at.y, at.z]));
                of([normal.x, normal.y, normal.z]).angle_between(truth).to_degrees()
            })
            .collect();
        all.sort_by(f64::total_cmp);
        all[all.len() / 2]
    };
    let parallel = off(&object_of_spheres(&CUBE, 72, JumpCells::Highest));
    let [near, far] = [1.3, 4.0].map(|away_m| off(&seen_from_eyes(away_m, JumpCells::Highest)));
    println!("{parallel:.3} degrees by parallel rays, {near:.3} and {far:.3} from eyes");
    assert!(near < 1.5 * parallel && far < 1.5 * parallel, "{parallel} {near} {far}");
}

#[test]
fn both_backends_show_the_same_from_eyes() {
    if !has_adapter() {
        return;
    }
    let object = seen_from_eyes(1.3, JumpCells::Highest);
    for (eye, method) in EYES.into_iter().zip(["depth-object", "visual-hull", "depth-object-slices"]) {
        let [cpu, gpu] = [BackendChoice::Cpu, BackendChoice::Gpu]
            .map(|backend| pixels(&object, selection(method, &[("object.color", 1.0)]), eye, backend));
        let [share, least] = alike_on_both(&cpu, &gpu);
        println!("{method}: {share:.5} alike");
        assert!(share >= least, "{method}: {share}");
    }
}

#[test]
fn hulls_are_in_the_shadows_that_rays_find() {
    for object in [object_of_spheres(&CUBE, 64, JumpCells::Highest), seen_from_eyes(2.0, JumpCells::Highest)]
    {
        let [looked_up, traced] = ["map", "scene"].map(|shadow| {
            let mut hull = selection("visual-hull", &[]);
            hull.choose("shadow", shadow).expect("a listed name");
            pixels(&object, hull, EYES[1], BackendChoice::Cpu)
        });
        let both = || looked_up.iter().zip(&traced).filter(|(one, _)| one.hit == 1);
        let alike = both().filter(|(one, other)| (one.lit - other.lit).abs() < 0.5).count();
        let lit = both().filter(|(_, other)| other.lit > 0.5).count();
        let [alike, lit] = [alike, lit].map(|count| count as f64 / both().count() as f64);
        println!("{alike:.4} alike, {lit:.4} lit");
        assert!(alike > 0.95 && lit > 0.2 && lit < 0.9, "{alike} {lit}");
    }
}
