//! Methods as functions over triangles: the renderer's hits to the bit, on shells too, in every language.

use naga::valid::{Capabilities, ValidationFlags, Validator};
use relief_core::rng::Rng;
use relief_core::{HeightMap, Wrap};
use relief_export::{ExportedFunctions, Form, FunctionOptions, Profile, functions};
use relief_render::job::JobSurface;
use relief_shaders::Selection;
use relief_shaders::cpu::{Frame, PixelIn, Shell};
use relief_testing::maps;
use relief_tests::compilers;
use relief_tests::exported::{SeenOver, compiled, device, shortened, surface_of};
use relief_tests::one_source::rays::{bent_pixels, pixels};

/// Rays of a program.
const RAYS: usize = 10_000;

/// Surfaces, with a search for each that takes its segments, and a wrap.
const CASES: [(&str, &str, Wrap); 7] = [
    ("prism", "relief", Wrap::Repeat),
    ("prism", "exact", Wrap::Mirror),
    ("prism", "cone", Wrap::Clamp),
    ("tetrahedra", "cone", Wrap::Repeat),
    ("tetrahedra", "exact", Wrap::Clamp),
    ("quadric-vertical", "relief", Wrap::Repeat),
    ("plane", "cone", Wrap::Mirror),
];

fn selection(surface: &str, method: &str, shadow: &str) -> Selection {
    let mut selection = shortened(Selection::method(method).expect("a method"));
    selection.choose("surface", surface).expect("a surface");
    selection.choose("shadow", shadow).expect("a shadow");
    selection
}

fn exported(selection: &Selection, wrap: Option<Wrap>, profiles: Vec<Profile>) -> ExportedFunctions {
    with_folds(selection, wrap, profiles, true)
}

fn with_folds(
    selection: &Selection,
    wrap: Option<Wrap>,
    profiles: Vec<Profile>,
    folds: bool,
) -> ExportedFunctions {
    let options =
        FunctionOptions { form: Form::Triangle, folds, wrap, profiles, ..FunctionOptions::default() };
    functions(selection, &options).unwrap_or_else(|error| panic!("{error}"))
}

fn map(wrap: Wrap) -> HeightMap {
    let map = maps::ALL.iter().find(|map| map.name == "natural 101x67").expect("a map").build(wrap);
    map.with_displacement(0.3, -0.1).expect("proper numbers")
}

/// Rays at triangles whose normals part, some of them in shells that overlap themselves, each with a light.
fn rays(surface: &str, map: &HeightMap, seed: u64) -> Vec<(PixelIn, [f32; 3])> {
    let mut rng = Rng::new(!seed);
    let of = if surface.starts_with("quadric") { bent_pixels } else { pixels };
    let mut rays = of(map, RAYS, seed);
    if ["prism", "tetrahedra"].contains(&surface) {
        for ray in &mut rays {
            let places = Shell::places_of([0, 1, 2].map(|_| rng.below(1000)));
            ray.shell = Shell::between([0.0, 1.0], places, [0.0; 3]);
            if surface == "prism" && rng.below(8) == 0 {
                ray.shell = ray.shell.folded();
            }
            for corner in [&mut ray.a, &mut ray.b, &mut ray.c] {
                let n = corner.normal;
                let mut aside = || rng.between(-0.2, 0.2) as f32;
                corner.normal = [n.x + aside(), n.y + aside(), n.z + aside()].into();
            }
        }
    }
    let toward = |ray: PixelIn| {
        let n = ray.a.normal;
        let mut aside = || rng.between(-0.4, 0.4) as f32;
        let toward = [n.x * ray.side + aside(), n.y * ray.side + aside(), n.z * ray.side + aside()];
        let length = toward.iter().map(|x| x * x).sum::<f32>().sqrt();
        (ray, toward.map(|x| x / length))
    };
    rays.into_iter().map(toward).collect()
}

/// The bits of a hit: its texture coordinates, its depth and its place.
type Bits = Option<[u32; 6]>;

fn bits_of(seen: &SeenOver) -> Bits {
    let SeenOver { uv, depth, position: p, .. } = *seen;
    seen.hit.then(|| [uv[0], uv[1], depth, p[0], p[1], p[2]].map(f32::to_bits))
}

/// The renderer's hits.
fn rendered(surface: &JobSurface, rays: &[(PixelIn, [f32; 3])]) -> Vec<Bits> {
    let program = surface.program(Frame::none(), None);
    let hit = |(pixel, _): &(PixelIn, [f32; 3])| {
        let at = program.enter(*pixel);
        let first = program.first_hit(*pixel, at);
        let placed = program.place(*pixel, at, first.segment, first.hit);
        let (uv, p) = (first.hit.uv, placed.point);
        (first.hit.found == 1).then(|| [uv.x, uv.y, placed.depth, p.x, p.y, p.z].map(f32::to_bits))
    };
    rays.iter().map(hit).collect()
}

#[test]
fn functions_over_triangles_find_the_renderers_hits_to_the_bit() {
    let Some(device) = device() else { return };
    for (number, (surface, method, wrap)) in CASES.into_iter().enumerate() {
        let selection = selection(surface, method, "none");
        let map = map(wrap);
        let rays = rays(surface, &map, 7);
        let of_map = surface_of(map, selection);
        let own = exported(&selection, Some(wrap).filter(|_| number % 3 != 2), vec![Profile::Wgsl]);
        let seen: Vec<Bits> = device.seen_over(&own, &of_map, &rays).iter().map(bits_of).collect();
        let theirs = rendered(&of_map, &rays);
        let hits = theirs.iter().filter(|hit| hit.is_some()).count();
        let differing = seen.iter().zip(&theirs).filter(|(own, other)| own != other).count();
        println!("{method} on {surface}, {wrap}: {hits} of {} hit, {differing} differ", rays.len());
        assert!(hits > rays.len() / 10);
        assert_eq!(differing, 0, "{method} on {surface}, {wrap}");
    }
}

#[test]
fn a_wrong_function_over_triangles_is_noticed() {
    let Some(device) = device() else { return };
    let selection = selection("prism", "relief", "none");
    let map = map(Wrap::Repeat);
    let rays = rays("prism", &map, 3);
    let of_map = surface_of(map, selection);
    let right = exported(&selection, Some(Wrap::Repeat), vec![Profile::Wgsl]);
    let theirs = rendered(&of_map, &rays);
    let changed = |from: &str, to: &str| {
        let text = String::from_utf8(right.files[0].bytes.clone()).expect("a text");
        assert!(text.contains(from), "{from}");
        let mut changed = right.clone();
        changed.files[0].bytes = text.replace(from, to).into_bytes();
        let seen = device.seen_over(&changed, &of_map, &rays);
        seen.iter().map(bits_of).zip(&theirs).filter(|(own, other)| own != *other).count()
    };
    assert_eq!(changed("fn", "fn"), 0);
    assert!(changed("(path.start + hit.t)", "path.start") > 10, "the way within a segment");
    assert!(changed("ray.direction, ray.side,", "ray.direction, 1.0,") > 10, "the back of a triangle");
    assert!(changed("step < RELIEF_POLISH_STEPS", "step < 1u") > 10, "a step of the correction");
    let wrong_wrap = exported(&selection, Some(Wrap::Mirror), vec![Profile::Wgsl]);
    let seen = device.seen_over(&wrong_wrap, &of_map, &rays);
    assert!(seen.iter().map(bits_of).zip(&theirs).filter(|(own, other)| own != *other).count() > 10);
}

#[test]
fn light_over_triangles_is_the_renderers() {
    let Some(device) = device() else { return };
    for (surface, method) in [("prism", "relief"), ("tetrahedra", "cone")] {
        let selection = selection(surface, method, "ray");
        let map = map(Wrap::Repeat);
        let rays = rays(surface, &map, 19);
        let of_map = surface_of(map, selection);
        let program = of_map.program(Frame::none(), None);
        // The renderer's light comes from where a mirror in the base would send the ray.
        let mirrored = |(pixel, _): &(PixelIn, [f32; 3])| {
            let at = program.enter(*pixel);
            let first = program.first_hit(*pixel, at);
            let placed = program.place(*pixel, at, first.segment, first.hit);
            let [d, n] = [pixel.direction, placed.normal].map(|v| [v.x, v.y, v.z]);
            let length = d.iter().map(|x| x * x).sum::<f32>().sqrt();
            let down = d.map(|x| x / length);
            let twice = 2.0 * (0..3).map(|k| down[k] * n[k]).sum::<f32>();
            let toward = [0, 1, 2].map(|k| down[k] - n[k] * twice);
            ((*pixel, toward), program.mirrored_light(*pixel, placed, first.hit))
        };
        let (rays, lights): (Vec<_>, Vec<f32>) = rays.iter().map(mirrored).unzip();
        let seen =
            device.seen_over(&exported(&selection, Some(Wrap::Repeat), vec![Profile::Wgsl]), &of_map, &rays);
        let (mut hits, mut lit, mut same) = (0, 0, 0);
        for (light, seen) in lights.iter().zip(&seen).filter(|(_, seen)| seen.hit) {
            hits += 1;
            lit += usize::from(*light > 0.5);
            same += usize::from(light.to_bits() == seen.light.to_bits());
        }
        println!("{method} on {surface}: {same} of {hits} lights are the same, {lit} arrive");
        // The direction's last bits may differ.
        assert!(same * 1000 >= hits * 999, "{method} on {surface}: {same} of {hits}");
        assert!(lit > hits / 10 && lit < hits * 99 / 100);
    }
}

#[test]
fn functions_over_triangles_are_valid_in_every_language() {
    let profiles = [Profile::Core330, Profile::Es300, Profile::Vulkan450, Profile::Hlsl51, Profile::Msl20];
    for (number, (surface, method, wrap)) in CASES.into_iter().enumerate() {
        let selection = selection(surface, method, ["ray", "none"][number % 2]);
        for profile in profiles {
            // Without folds a plane needs nothing of the space above it.
            let both = with_folds(&selection, Some(wrap), vec![Profile::Wgsl, profile], number % 2 == 1);
            let text = |place: usize| String::from_utf8(both.files[place].bytes.clone()).expect("a text");
            let own = text(0);
            let module = naga::front::wgsl::parse_str(&own).unwrap_or_else(|error| panic!("{error}"));
            let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
            validator.validate(&module).unwrap_or_else(|error| panic!("{method} on {surface}: {error}"));
            let name = || format!("{method} on {surface} in {}", profile.name());
            assert!(text(1).contains("relief_triangle_hit("), "{}", name());
            if compilers::are_there() {
                compiled(&text(1), profile, &|vector| calls(&text(1), vector))
                    .unwrap_or_else(|error| panic!("{}: {error}", name()));
            }
        }
    }
}

/// What a fragment shader does with the functions of a text.
fn calls(text: &str, vector: &str) -> String {
    let light = if text.contains("relief_triangle_light(") {
        "sum *= relief_triangle_light(settings, ray, hit, ray.direction);"
    } else {
        ""
    };
    format!(
        "ReliefTriangle at;\n    at.a.position = {vector}3(0.5, 0.25, 0.0);\n    \
         at.b.position = {vector}3(1.5, 0.25, 0.0);\n    at.c.position = {vector}3(1.0, 1.25, 0.0);\n    \
         at.a.normal = at.b.normal = at.c.normal = {vector}3(0.0, 0.0, 1.0);\n    ReliefRay ray;\n    \
         ray.origin = {vector}3(0.0, 0.0, 1.0);\n    ray.direction = {vector}3(0.0, 0.6, -0.8);\n    \
         ReliefTriangleHit hit = relief_triangle_hit(settings, at, ray);\n    \
         float sum = hit.depth + hit.height + hit.position.x;\n    {light}\n"
    )
}

#[test]
fn the_documents_shader_calls_functions_over_triangles() {
    let page = include_str!("../../../../docs/functions.md");
    let shader = page.split("```wgsl\n").find(|text| text.contains("relief_triangle_hit("));
    let shader = shader.and_then(|rest| rest.split("```").next()).expect("a shader");
    let own = exported(&selection("prism", "relief", "none"), Some(Wrap::Repeat), vec![Profile::Wgsl]).files;
    let text = String::from_utf8(own[0].bytes.clone()).expect("a text");
    let validated = |shader: &str| {
        let module =
            naga::front::wgsl::parse_str(&format!("{text}\n{shader}")).map_err(|error| error.to_string())?;
        let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
        validator.validate(&module).map(drop).map_err(|error| error.to_string())
    };
    assert_eq!(validated(shader), Ok(()));
    assert!(validated(&shader.replace("ReliefRay(", "ReliefRays(")).is_err());
}

#[test]
fn every_form_says_what_it_takes() {
    let refused = |surface: &str, form: Form| {
        let mut selection = Selection::method("relief").expect("a method");
        selection.choose("surface", surface).expect("a surface");
        let options = FunctionOptions { form, ..FunctionOptions::default() };
        functions(&selection, &options).map(drop).map_err(|error| error.to_string())
    };
    let said = refused("prism", Form::Tangent).expect_err("a refusal");
    assert!(said.contains("'plane'") && said.contains("'triangle'"), "{said}");
    assert_eq!(refused("prism", Form::Triangle), Ok(()));
    let said = refused("slices", Form::Triangle).expect_err("a refusal");
    assert!(said.contains("'prism'") && !said.contains("the form"), "{said}");
    assert!("triangl".parse::<Form>().expect_err("an unknown name").to_string().contains("triangle"));
    for form in Form::ALL {
        assert_eq!(form.name().parse(), Ok(form));
    }
}
