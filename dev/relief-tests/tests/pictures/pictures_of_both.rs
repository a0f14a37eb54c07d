//! Pictures of the GPU beside pictures of the translated shaders.

use std::collections::BTreeSet;

use relief_core::{Watch, Wrap};
use relief_shaders::cpu::PixelOut;
use relief_shaders::wgsl::Sampling;
use relief_shaders::{SHADE, STAGES, Selection, ambient};
use relief_tests::one_source::adapter;
use relief_tests::one_source::picture::{Picture, Variation};

#[test]
fn pictures_agree() {
    let Some(mut renderer) = adapter::renderer() else { return };
    // The first is larger than what is shaded at once.
    let cases = [
        (620, 500, "relief", "none", "none", Wrap::Repeat, false, true),
        (211, 160, "exact", "ray", "footprint", Wrap::Clamp, true, false),
        (160, 211, "occlusion", "entry", "none", Wrap::Mirror, true, true),
        (201, 99, "parallax-slope", "visibility", "footprint", Wrap::Clamp, false, false),
        (180, 140, "frustum", "soft", "fade", Wrap::Mirror, false, true),
        (140, 120, "cone", "horizon", "footprint", Wrap::Repeat, false, true),
        (120, 140, "relaxed", "heuristic", "none", Wrap::Repeat, false, false),
    ];
    let ambients = ambient::ENTRIES.iter().cycle();
    for ((number, case), ambient) in cases.into_iter().enumerate().zip(ambients) {
        let (width, height, method, shadow, detail, wrap, normal_map, two_sided) = case;
        let mut selection = Selection::method(method).expect("a method");
        selection.choose("ambient", ambient.name).expect("an ambient light");
        selection.choose("shadow", shadow).expect("a shadow");
        let shadings = STAGES[SHADE].entries;
        selection.choose("shade", shadings[number % shadings.len()].name).expect("a shading");
        selection.choose("detail", detail).expect("a detail");
        let variation = Variation { selection: &selection, wrap, normal_map, two_sided };
        let picture = Picture::new(width, height, &variation);
        let rendering = renderer.render(picture.job(), Sampling::Exact, &Watch::none()).expect("a picture");
        let levels: BTreeSet<u32> = rendering.pixels.iter().map(|pixel| pixel.level).collect();
        assert_eq!(levels.len() > 1, detail != "none", "{method} {shadow} {wrap}: {levels:?}");
        picture.check(&rendering).unwrap_or_else(|error| panic!("{method} {shadow} {wrap}: {error}"));
        let again = renderer.render(picture.job(), Sampling::Exact, &Watch::none()).expect("a picture");
        assert!(rendering == again, "{method} {shadow} {wrap}: the second picture differs");
    }
}

#[test]
fn a_wrong_picture_is_seen() {
    let selection = Selection::method("relief").expect("a method");
    let variation =
        Variation { selection: &selection, wrap: Wrap::Repeat, normal_map: false, two_sided: true };
    let picture = Picture::new(96, 64, &variation);
    let right = picture.on_cpu();
    picture.check(&right).expect("the same picture");
    let hit = right.pixels.iter().position(|pixel| pixel.hit == 1 && pixel.normal.x != 0.0).expect("a hit");
    type Mutation = (&'static str, fn(&mut [PixelOut], usize));
    let mutations: [Mutation; 9] = [
        ("a colour", |pixels, at| pixels[at].color.y += 3e-5),
        ("a normal", |pixels, at| pixels[at].normal.x *= -1.0),
        ("a depth", |pixels, at| pixels[at].depth += 1e-4),
        ("a read", |pixels, at| pixels[at].reads += 1),
        ("a step", |pixels, at| pixels[at].steps += 1),
        ("a byte", |pixels, at| pixels[at].bytes += 1),
        ("a hole", |pixels, at| pixels[at].hit = 0),
        ("upside down", |pixels, _| pixels.reverse()),
        ("a pixel to the right", |pixels, _| pixels.rotate_right(1)),
    ];
    for (what, mutate) in mutations {
        let mut wrong = right.clone();
        mutate(&mut wrong.pixels, hit);
        assert!(picture.check(&wrong).is_err(), "{what} was not seen");
    }
}
