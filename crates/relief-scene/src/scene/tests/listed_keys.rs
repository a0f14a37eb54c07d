//! The list of keys, and files that are written with all of them.

use super::*;

#[test]
fn a_description_is_written_as_it_is_read() {
    let path = Path::new("scene.toml");
    let full = parse_scene(FULL, path).expect("a proper scene");
    let text = full.to_toml();
    assert_eq!(parse_scene(&text, path).unwrap_or_else(|error| panic!("{error} in:\n{text}")), full);
    assert_eq!(parse_scene(&SceneSpec::default().to_toml(), path).expect("no scene"), SceneSpec::default());
    let several = shipped("scenes/still-life.toml");
    let text = fs::read_to_string(&several).expect("a shipped scene");
    let several = parse_scene(&text, path).expect("a proper scene");
    assert_eq!(parse_scene(&several.to_toml(), path).expect("the same scene"), several);
}

#[test]
fn every_key_is_listed_with_a_default_that_can_be_written() {
    let listed = |of_surface: bool| -> BTreeSet<&str> {
        keys().iter().filter(|key| key.of_surface == of_surface).map(|key| key.name).collect()
    };
    let stages = relief_shaders::STAGES.iter().filter(|stage| stage.has_key()).map(|stage| stage.key);
    // The older name of a surface's mesh-scale is read, and not written.
    let of_surface = keys::keys_of::<SurfaceSpec>().iter().copied().filter(|key| *key != "size");
    assert_eq!(listed(true), of_surface.chain(stages).collect());
    assert_eq!(listed(false), keys::keys_of::<SceneSpec>().iter().copied().collect());
    for Key { name, default, .. } in keys().iter().filter(|key| !key.default.is_empty()) {
        read(&format!("{name} = {default}\n")).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}

/// What a key needs beside it.
fn companions(key: &str) -> &'static str {
    match key {
        "extinction" => "volume = \"grass.ktx2\"\nmethod = \"translucent\"\n",
        "base" => "walls = true\n",
        "view-height" => "projection = \"orthographic\"\n",
        "udim" => "textures = \"bricks\"\n",
        "near" => "projection = \"orthographic\"\nview-height = 1\n",
        "far" => "projection = \"orthographic\"\nview-height = 1\nnear = -1e7\n",
        "ambient-color" => "ambient = \"constant\"\n",
        _ => "",
    }
}

/// A key's line with a number, or with it in every place.
fn line_of(key: &Key, number: f64) -> String {
    let each = |count: usize| vec![number; count];
    let value = match key.form {
        Form::Numbers(count) | Form::Lengths(count) => format!("{:?}", each(count)),
        Form::Size => format!("[{number}, {number}]"),
        Form::Whole => format!("{number}"),
        _ => format!("{number:?}"),
    };
    // A fitted camera does not reach as far as surfaces may.
    let camera = match key.name {
        "eye" => "target = [0, 0, 0]\n",
        "target" => "eye = [0, 1, 2]\n",
        _ => "eye = [0, 1, 2]\ntarget = [0, 0, 0]\n",
    };
    format!("{camera}{}{} = {value}\n", companions(key.name), key.name)
}

#[test]
fn ranges_of_numbers_are_those_that_hold() {
    use std::ops::Bound::{Excluded, Included, Unbounded};
    let mut bounds = 0;
    for key in keys() {
        let is_number = matches!(
            key.form,
            Form::Number | Form::Whole | Form::Numbers(_) | Form::Length | Form::Lengths(_) | Form::Size
        );
        assert_eq!(key.number.is_some(), is_number, "{}", key.name);
        // Its two numbers are not the same.
        let Some(number) = key.number.filter(|_| key.name != "elevation") else { continue };
        assert!(number.step > 0.0, "{}", key.name);
        let accepted = |value: f64| read(&line_of(&key, value)).map(drop).map_err(|error| error.to_string());
        let (least, greatest) = number.range;
        // A little farther: numbers of 32 bits, and whole ones.
        let beside = |at: f64| {
            if key.form == Form::Whole || key.form == Form::Size { 1.0 } else { 1e-6 + at.abs() * 1e-3 }
        };
        for (bound, outward) in [(least, -1.0), (greatest, 1.0)] {
            let (inside, outside) = match bound {
                Included(at) => (at, at + outward * beside(at)),
                Excluded(at) => (at - outward * 1e-3, at),
                Unbounded => (outward * 1e6_f64.min(if key.name == "udim" { 1.0 } else { 1e6 }), f64::NAN),
            };
            if key.form != Form::Whole || inside >= 0.0 {
                assert_eq!(accepted(inside), Ok(()), "{} = {inside}", key.name);
            }
            if !outside.is_nan() {
                assert!(accepted(outside).is_err(), "{} = {outside}", key.name);
                bounds += 1;
            }
        }
    }
    assert!(bounds > 30, "{bounds}");
}

#[test]
fn the_defaults_that_are_listed_are_those_that_hold() {
    let map = shipped("data/noise.png");
    let load = |text: String| {
        let text = format!("height = {:?}\n{text}", map.to_string_lossy());
        read(&text).and_then(|spec| spec.load()).unwrap_or_else(|error| panic!("{error} in:\n{text}"))
    };
    let expected = format!("{:?}", load(String::new()));
    let listed = keys();
    for Key { name, default, .. } in listed.iter().filter(|key| !key.default.is_empty()) {
        assert_eq!(format!("{:?}", load(format!("{name} = {default}\n"))), expected, "{name} = {default}");
    }
    // Most values are not the default.
    assert_ne!(format!("{:?}", load("samples = 5\n".to_owned())), expected);
}
