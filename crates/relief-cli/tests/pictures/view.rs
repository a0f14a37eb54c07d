//! `relief view --script`: scenes changed by actions.

use std::fs;
use std::path::Path;

use crate::common::command::{Folder, json_of};

fn folder(script: &str) -> Folder {
    let folder = Folder::new();
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/cobbles.png");
    fs::copy(shipped, folder.path("map.png")).expect("the shipped map");
    folder.write("actions.json", script);
    folder
}

const SMALL: &str = "map.png --mesh torus --tile 6,2 --size 48x36 --samples 1 --backend cpu";

#[test]
fn pictures_are_those_of_render() {
    let folder = folder(
        r#"[{ "do": "picture", "file": "before.png" },
            { "do": "set", "key": "scale", "value": "8cm" },
            { "do": "set", "key": "set.search.steps", "value": 24 },
            { "do": "orbit", "degrees": [40, -10], "drag": 1 },
            { "do": "orbit", "degrees": [40, -10], "drag": 1 },
            { "do": "picture", "file": "turned.png" },
            { "do": "undo" }]"#,
    );
    let line = format!("view {SMALL} --method relief --script actions.json -o out --json");
    let answer = json_of(&folder.relief(&line).fine());
    assert_eq!(answer["changed"][1], serde_json::json!(["scale"]));
    assert_eq!(answer["changed"][2], serde_json::json!(["set.search.steps"]));
    assert_eq!(answer["changed"][6], serde_json::json!(["eye", "target"]));
    assert_eq!(answer["files"].as_array().map(Vec::len), Some(4));
    let read = |name: &str| fs::read(folder.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    folder.relief(&format!("render {SMALL} --method relief -q -o before.png")).fine();
    assert!(read("before.png") == read("out/before.png"));
    // The scene is what the last picture shows, wherever it is read from.
    fs::create_dir(folder.path("elsewhere")).expect("writable");
    fs::rename(folder.path("out/scene.toml"), folder.path("elsewhere/scene.toml")).expect("writable");
    folder.relief("render elsewhere/scene.toml -q -o after.png").fine();
    assert!(read("after.png") == read("out/picture.png"));
    assert!(read("out/turned.png") != read("out/picture.png") && read("before.png") != read("after.png"));
    // Nothing is written where nothing is asked for.
    let line = format!("view {SMALL} --method relief --script actions.json");
    assert!(folder.relief(&line).fine().stdout.starts_with("1: would draw before.png"));
}

#[test]
fn what_is_framed_stays_in_the_picture() {
    let turns = "{ \"do\": \"frame\" }, { \"do\": \"picture\", \"file\": \"0.png\" }".to_owned()
        + &(1..5)
            .map(|turn| {
                format!(
                    ", {{ \"do\": \"orbit\", \"degrees\": [75, 20] }}, {{ \"do\": \"frame\" }}, \
                     {{ \"do\": \"picture\", \"file\": \"{turn}.png\" }}"
                )
            })
            .collect::<String>();
    let folder = folder(&format!("[{turns}]"));
    folder.relief(&format!("view {SMALL} --background 0,0,1 --script actions.json -q -o out")).fine();
    for turn in 0..5 {
        let picture = image::open(folder.path(format!("out/{turn}.png"))).expect("a picture").to_rgb8();
        let is_behind = |x: u32, y: u32| picture.get_pixel(x, y) == picture.get_pixel(0, 0);
        let [width, height] = [picture.width(), picture.height()];
        let edges = (0..width).flat_map(|x| [(x, 0), (x, height - 1)]);
        let edges = edges.chain((0..height).flat_map(|y| [(0, y), (width - 1, y)]));
        assert!(edges.into_iter().all(|(x, y)| is_behind(x, y)), "{turn} is cut off");
        let seen =
            (0..width).flat_map(|x| (0..height).map(move |y| (x, y))).filter(|at| !is_behind(at.0, at.1));
        assert!(seen.count() as u32 > width * height / 8, "{turn} is small");
    }
}

#[test]
fn a_script_with_a_fault_leaves_nothing_behind() {
    for (script, words) in [
        (
            "[{ \"do\": \"picture\", \"file\": \"a.png\" }, { \"do\": \"set\", \"key\": \"samples\", \
             \"value\": \"5000\" }]",
            "action 2: samples",
        ),
        ("[{ \"do\": \"set\", \"key\": \"scal\", \"value\": \"1\" }]", "'scale'"),
        ("[{ \"do\": \"lose\" }]", "action 1: lose: missing field `key`"),
        ("[{ \"do\": \"rotate\" }]", "turn-light, undo, redo, reset, picture"),
        ("[{ \"do\": \"undo\", \"times\": 2 }]", "times"),
        ("[{ \"do\": \"picture\", \"file\": \"picture.png\" }]", "at the end"),
        ("[{ \"do\": \"set\", \"key\": \"height\", \"value\": \"nope.png\" }]", "nope.png"),
        ("[{ \"do\": \"undo\" }]", "nothing to undo"),
        ("[{ \"do\": \"picture\", \"file\": \"../a.png\" }]", "../a.png"),
        ("[{ \"do\": \"picture\", \"file\": \"a.gif\" }]", "a.gif"),
        (
            "[{ \"do\": \"picture\", \"file\": \"a.png\" }, { \"do\": \"picture\", \"file\": \"a.png\" }]",
            "twice",
        ),
        ("[{ \"do\": \"fit\", \"drag\": -1 }]", "drag"),
        ("{}", "no list"),
        ("[", "no list"),
        ("\u{0}\u{1}", "no"),
    ] {
        let folder = folder(script);
        let ran = folder.relief(&format!("view {SMALL} --script actions.json -o out"));
        assert!(ran.code == Some(1) && ran.stderr.contains(words), "{script}: {ran:?}");
        assert!(!folder.path("out").exists(), "{script}");
    }
    let folder = folder("[]");
    assert_eq!(folder.relief("view map.png --script none.json -o out").code, Some(1));
    // Only a script writes into a folder.
    assert_eq!(folder.relief("view map.png -o out").code, Some(2));
    assert!(!folder.path("out").exists());
    // No actions: the scene as it is.
    folder.relief(&format!("view {SMALL} --script actions.json -q -o out")).fine();
    assert!(folder.path("out/picture.png").is_file() && folder.path("out/scene.toml").is_file());
}
