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
