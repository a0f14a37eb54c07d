//! Exported shaders of slices, drawn over the triangles that a program makes, beside the renderer.

use std::sync::Arc;

use relief_core::Watch;
use relief_core::camera::Camera;
use relief_core::mesh::torus;
use relief_core::object::{ImageObject, JumpCells};
use relief_maps::Maps;
use relief_render::job::Job;
use relief_scene::{BackendChoice, Scene, Surface};
use relief_shaders::Selection;
use relief_tests::exported::{Device, Difference, Language, compare, device, draw, exported, rendered};
use relief_tests::object_pictures::{self, EYES};
use relief_tests::spheres::{CUBE, object_of_spheres};
use relief_tests::{accuracy, compilers};

fn job_of(scene: &Scene) -> Job {
    Job::of_scene(scene, &mut Maps::in_memory(), &Watch::none()).expect("a job")
}

/// Draws an export and says how it differs from the renderer's picture.
fn beside(device: &Device, selection: &Selection, job: &Job, language: Language) -> Difference {
    let export = exported(selection, Some(relief_export::Placement { group: 0, first_binding: 0 }));
    compare(&rendered(device, job), &draw(device, &export, job, language))
}

#[test]
fn refined_shells_have_the_bits_of_the_renderer() {
    let Some(device) = device() else { return };
    let map = accuracy::maps().into_iter().find(|map| map.name == "cobbles").expect("a listed map").map;
    let map = Arc::new(map.with_displacement(0.04, 0.0).expect("lengths"));
    let base = Arc::new(torus(24, 12).and_then(|mesh| mesh.tiled([6.0, 3.0].into())).expect("a mesh"));
    let scene = |selection: Selection| {
        let surface = Surface::new(Arc::clone(&base), Arc::clone(&map)).with_selection(selection);
        let camera = Camera::new([0.6, 1.2, 2.0].into(), [0.0; 3].into(), 28.0).expect("a camera");
        let scene = Scene::builder(surface).camera(camera).size(120, 90).samples(1);
        scene.backend(BackendChoice::Gpu).build().expect("a scene")
    };
    let mut languages = vec![Language::Wgsl, Language::Spirv];
    if compilers::are_there() {
        languages.push(Language::Glsl);
    }
    for (method, refine) in [("slices-surface", 2.0), ("slices-orthogonal", 0.0), ("slices-screen", 1.0)] {
        let mut selection = Selection::method(method).expect("a method");
        for (key, value) in [("slices.count", 12.0), ("slices.refine", refine)] {
            selection.set(key, value).expect("a setting");
        }
        let job = job_of(&scene(selection));
        for language in &languages {
            let Difference { bits, covered, .. } = beside(&device, &selection, &job, *language);
            println!("{method} in {language:?}: {bits} of {covered} pixels differ");
            assert!(covered > 2500 && bits == 0, "{method} in {language:?}: {bits} of {covered}");
        }
        // Corners at other heights are noticed.
        let mut others = selection;
        others.set("slices.count", 13.0).expect("a setting");
        let drawn = draw(&device, &exported(&selection, None), &job_of(&scene(others)), Language::Wgsl);
        let far = compare(&rendered(&device, &job), &drawn).far;
        assert!(far > 100, "{method}: {far}");
    }
}

#[test]
fn slices_of_an_object_have_them_too() {
    let Some(device) = device() else { return };
    let object: ImageObject = object_of_spheres(&CUBE, 64, JumpCells::Highest);
    let selection = object_pictures::selection("depth-object-slices", &[("slices.count", 40.0)]);
    let job = job_of(&object_pictures::scene(&object, selection, EYES[1], BackendChoice::Gpu));
    let Difference { bits, covered, .. } = beside(&device, &selection, &job, Language::Wgsl);
    println!("{bits} of {covered} pixels differ");
    assert!(covered > 2500 && bits == 0, "{bits} of {covered}");
}
