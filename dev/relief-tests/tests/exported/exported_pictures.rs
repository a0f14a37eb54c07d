//! Exported shaders, bound by nothing but their manifests, beside the project's own renderer: the same bits.

use relief_core::object::{ImageObject, JumpCells};
use relief_core::{Watch, Wrap};
use relief_export::{Exported, Placement};
use relief_maps::Maps;
use relief_render::job::Job;
use relief_scene::BackendChoice;
use relief_shaders::Selection;
use relief_tests::compilers;
use relief_tests::exported::{Difference, Language, compare, device, draw, exported, rendered};
use relief_tests::object_pictures::{self, EYES};
use relief_tests::one_source::picture::{Picture, Variation};
use relief_tests::spheres::{CUBE, eyes_on_spheres};

/// Columns and rows: 100,000 rays.
const SIZE: [u32; 2] = [400, 250];

fn selection([method, surface, shadow, ambient, shade]: [&str; 5]) -> Selection {
    let mut selection = Selection::method(method).expect("a method");
    selection.choose("shade", shade).expect("a shading");
    selection.choose("surface", surface).expect("a surface");
    selection.choose("shadow", shadow).expect("a shadow");
    selection.choose("ambient", ambient).expect("an ambient light");
    selection
}

fn picture(selection: &Selection, wrap: Wrap) -> Picture {
    let variation = Variation { selection, wrap, normal_map: false, two_sided: true };
    Picture::new(SIZE[0], SIZE[1], &variation)
}

#[test]
fn an_export_of_an_object_gives_the_bits_of_the_renderer() {
    let Some(device) = device() else { return };
    // Every other image is seen from an eye.
    let (views, maps) = eyes_on_spheres(&CUBE, 2.5, 64);
    let object = ImageObject::new(views, &maps, JumpCells::Highest, 4.0).expect("an object");
    let selection = object_pictures::selection("depth-object", &[]);
    let scene = object_pictures::scene(&object, selection, EYES[0], BackendChoice::Gpu);
    let job = Job::of_scene(&scene, &mut Maps::in_memory(), &Watch::none()).expect("a job");
    let (export, own) = (exported(&selection, None), rendered(&device, &job));
    let Difference { bits, covered, .. } = compare(&own, &draw(&device, &export, &job, Language::Wgsl));
    println!("{bits} of {covered} pixels differ");
    assert!(covered > 2500 && bits == 0, "{bits} of {covered}");
    // Another number of images is noticed.
    let mut fewer = job.clone();
    fewer.surfaces[0].settings.solids -= 2;
    let drawn = draw(&device, &export, &fewer, Language::Wgsl);
    assert!(compare(&own, &drawn).bits > 0);
}

/// Draws the export of a method, surface, shadow, ambient light and shading in all languages, bound by
/// nothing but its manifest, and compares it with the renderer's picture.
fn gives_the_bits_of_the_renderer(names: [&str; 5], wrap: Wrap) {
    let Some(device) = device() else { return };
    let mut languages = vec![Language::Wgsl, Language::Spirv];
    if compilers::are_there() {
        languages.extend([Language::Glsl, Language::Hlsl]);
    }
    let ([method, surface, ..], selection) = (names, selection(names));
    let picture = picture(&selection, wrap);
    let own = rendered(&device, picture.job());
    let check = |export: &Exported, language| {
        let drawn = draw(&device, export, picture.job(), language);
        let Difference { bits, far, covered } = compare(&own, &drawn);
        assert!(covered > 25_000, "{covered}");
        println!("{method} {surface} in {language:?}: {bits} and {far} of {covered} pixels differ");
        // The compiler of HLSL rounds otherwise: a ray at an edge may meet the other side of it.
        let is_same = if language == Language::Hlsl { far <= 50 } else { bits == 0 };
        assert!(is_same, "{method} {surface} in {language:?}: {bits}, {far}");
    };
    check(&exported(&selection, None), Language::Wgsl);
    // The device numbers its bindings one after the other, whatever numbers are given.
    let export = exported(&selection, Some(Placement { group: 0, first_binding: 0 }));
    languages.iter().for_each(|language| check(&export, *language));
}

#[test]
fn an_export_of_cones_with_shadow_rays_gives_the_bits_of_the_renderer() {
    gives_the_bits_of_the_renderer(["cone", "plane", "ray", "constant", "blinn-phong"], Wrap::Repeat);
}

#[test]
fn an_export_of_relief_with_materials_gives_the_bits_of_the_renderer() {
    let names = ["relief", "plane", "heuristic", "constant", "metallic-roughness"];
    gives_the_bits_of_the_renderer(names, Wrap::Mirror);
}

#[test]
fn an_export_of_exact_hits_with_baked_light_gives_the_bits_of_the_renderer() {
    gives_the_bits_of_the_renderer(["exact", "plane", "horizon", "occlusion", "blinn-phong"], Wrap::Clamp);
}

#[test]
fn an_export_of_prisms_gives_the_bits_of_the_renderer() {
    gives_the_bits_of_the_renderer(["relief", "prism", "none", "constant", "blinn-phong"], Wrap::Repeat);
}

#[test]
fn a_mutated_export_gives_other_bits() {
    let Some(device) = device() else { return };
    let selection = selection(["relief", "plane", "ray", "constant", "blinn-phong"]);
    let picture = picture(&selection, Wrap::Mirror);
    let (export, own) = (exported(&selection, None), rendered(&device, picture.job()));
    // Of the shader, then of the manifest.
    let mutations = [
        (".wgsl", "while (k <= steps)", "while (k < steps)"),
        (".wgsl", "return select(period - 1 - i, i, i < n);", "return min(i, n - 1);"),
        (".wgsl", "let top = h.x + (h.y - h.x) * f.x;", "let top = h.x;"),
        (".json", "\"name\": \"eye_right\"", "\"name\": \"forward\""),
    ];
    for (ending, from, to) in mutations {
        let mut mutated = export.clone();
        let file = mutated.files.iter_mut().find(|file| file.name.ends_with(ending)).expect("a file");
        let text = String::from_utf8(file.bytes.clone()).expect("text");
        assert!(text.contains(from), "{from}");
        file.bytes = text.replace(from, to).into_bytes();
        let drawn = draw(&device, &mutated, picture.job(), Language::Wgsl);
        assert!(compare(&own, &drawn).bits > 0, "{from} as {to} is not noticed");
    }
}
