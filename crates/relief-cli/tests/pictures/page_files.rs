//! `relief view`: what files, messages and saves do to a scene that is good.

use std::fs;

use serde_json::{Value, json};

use super::page::{Answer, Page, WHOLE, shipped};
use crate::common::command::Folder;

impl Page {
    fn drop_all(&self, number: u64, files: &[(&str, &[u8])], key: Option<&str>) -> Result<Value, String> {
        for (path, bytes) in files {
            self.drop_file(number, path, bytes).expect("kept");
        }
        self.post("drop", &json!({ "drop": number, "key": key }))
    }

    fn state(&self) -> Value {
        serde_json::from_slice(&self.get("state")).expect("JSON")
    }

    /// The value of a control of the only surface.
    fn value(&self, key: &str) -> Value {
        let state = self.state();
        let controls = state["panel"]["surfaces"][0].as_array().expect("controls").clone();
        controls.into_iter().find(|control| control["key"] == key).expect("a control")["value"].clone()
    }

    fn scene(&self) -> String {
        String::from_utf8(self.get("save?what=scene.toml")).expect("text")
    }
}

const GLTF: &[u8] =
    br#"{ "asset": { "version": "2.0" }, "buffers": [{ "uri": "away.bin", "byteLength": 36 }],
    "bufferViews": [{ "buffer": 0, "byteLength": 36 }],
    "accessors": [{ "bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
        "min": [0, 0, 0], "max": [1, 1, 1] }],
    "meshes": [{ "primitives": [{ "attributes": { "POSITION": 0 } }] }],
    "nodes": [{ "mesh": 0 }], "scenes": [{ "nodes": [0] }], "scene": 0 }"#;

#[test]
fn files_that_cannot_be_used_leave_the_scene_as_it_was() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png", "cobbles_color.png"]);
    let read = |name: &str| fs::read(folder.path(name)).expect("a file");
    let (heights, colour) = (read("cobbles.png"), read("cobbles_color.png"));
    let page = Page::open(&folder, "cobbles.png --backend cpu --samples 1");
    let (_, picture) = page.picture(WHOLE);
    let state = page.get("state");
    for (number, name, bytes, key, words) in [
        (1, "empty.png", &b""[..], None, "is empty"),
        (2, "text.png", b"hello", None, "is not a PNG"),
        (3, "cut.png", &heights[..2000], None, "cut.png"),
        (4, "wall.gltf", GLTF, None, "away.bin"),
        (5, "photo.png", &colour, None, "choose one: use the control Channel"),
        (6, "photo.png", &colour, Some("height"), "use the control Channel"),
        (7, "text.png", b"hello", Some("color"), "text.png"),
        (8, "wall.ply", b"ply", Some("mesh"), "wall.ply"),
        (9, "bare.toml", b"scale = 0.1", None, "no height map"),
        (10, "none.toml", b"height = \"none.png\"", None, "drop the folder"),
    ] {
        let refused = page.drop_all(number, &[(name, bytes)], key).expect_err(name);
        assert!(refused.contains(words), "{name}: {refused}");
        assert!(!refused.contains("relief-view-") && !refused.contains("--"), "{refused}");
    }
    assert!(page.get("state") == state && page.picture(WHOLE).1 == picture);
    // What an empty page lacks speaks against no file that is good.
    let empty = Page::open(&folder, "--backend cpu --samples 1");
    assert!(empty.drop_all(1, &[("a_color.png", b"hello")], None).is_err());
    empty.drop_all(2, &[("a_color.png", &colour)], None).expect("a colour map");
    empty.drop_all(3, &[("a.png", &heights)], None).expect("a height map");
    empty.picture(WHOLE);
}

#[test]
fn a_reset_goes_back_to_a_scene_that_can_be_drawn() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png", "cobbles_color.png"]);
    let page = Page::open(&folder, "cobbles.png --backend cpu --samples 1");
    let first = page.scene();
    page.drop_all(1, &[("a.png", &fs::read(folder.path("cobbles.png")).expect("a file"))], None)
        .expect("taken");
    page.apply(&json!({ "do": "undo" })).expect("an undo");
    page.apply(&json!({ "do": "set", "key": "scale", "value": "5cm" })).expect("a value");
    page.apply(&json!({ "do": "reset" })).expect("a reset");
    assert_eq!(page.scene(), first);
    // A drop that is made again stays, and what was refused never comes back.
    assert!(page.drop_all(2, &[("b.png", b"hello")], None).is_err());
    page.apply(&json!({ "do": "undo" })).expect("an undo");
    page.apply(&json!({ "do": "undo" })).expect("an undo");
    page.apply(&json!({ "do": "redo" })).expect("a redo");
    let colour = fs::read(folder.path("cobbles_color.png")).expect("a file");
    page.drop_all(3, &[("c.png", &colour)], Some("color")).expect("taken");
    page.apply(&json!({ "do": "reset" })).expect("a reset");
    page.picture(WHOLE);
    assert_eq!((page.value("color"), page.value("scale")), (json!("\"c.png\""), Value::Null));
}

#[test]
fn a_height_map_and_its_colours_come_together() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png", "cobbles_color.png"]);
    let read = |name: &str| fs::read(folder.path(name)).expect("a file");
    let page = Page::open(&folder, "--backend cpu --samples 1 --size 24x18");
    let (heights, colour) = (read("cobbles.png"), read("cobbles_color.png"));
    let taken =
        page.drop_all(1, &[("wall.png", &heights), ("wall_color.png", &colour)], None).expect("taken");
    assert_eq!(taken["changed"], json!(["color", "height"]));
    let (_, shown) = page.picture(WHOLE);
    // Controls have the names of the files, and take them.
    assert_eq!(
        (page.value("height"), page.value("color")),
        (json!("\"wall.png\""), json!("\"wall_color.png\""))
    );
    page.apply(&json!({ "do": "set", "key": "roughness", "value": "\"wall.png\"" }))
        .expect("a file of the scene");
    page.apply(&json!({ "do": "undo" })).expect("an undo");
    // The saved scene is what was shown.
    fs::create_dir(folder.path("saved")).expect("a folder");
    folder.write("saved/scene.toml", page.scene());
    folder.write("saved/wall.png", &heights);
    folder.write("saved/wall_color.png", &colour);
    folder.relief("render saved/scene.toml --size 48x36 -q -o saved/out.png").fine();
    let rendered = image::open(folder.path("saved/out.png")).expect("a picture").to_rgb8();
    let whole =
        page.apply(&json!({ "do": "set", "key": "size", "value": [48, 36] })).map(|_| page.picture(WHOLE).1);
    assert!(*rendered == whole.expect("a size") && shown != *rendered);
    // A picture that nobody can place is refused, with what to do.
    let several = [("wall.png", &heights[..]), ("floor.png", &heights[..])];
    let refused = page.drop_all(2, &several, None).expect_err("two heights");
    assert!(
        refused.contains("floor.png") && refused.contains("wall.png") && refused.contains("control"),
        "{refused}"
    );
}

#[test]
fn a_scene_finds_the_files_that_came_with_it() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png", "noise.png"]);
    let read = |name: &str| fs::read(folder.path(name)).expect("a file");
    let page = Page::open(&folder, "--backend cpu --samples 1");
    let scene = b"height = \"../data/x.png\"\nscale = 0.07\n";
    let (heights, other) = (read("cobbles.png"), read("noise.png"));
    page.drop_all(1, &[("wall.toml", scene), ("x.png", &heights)], None).expect("taken");
    page.picture(WHOLE);
    assert_eq!((page.value("scale"), page.value("height")), (json!("0.07"), json!("\"x.png\"")));
    // A folder in which the path leads somewhere is read as it is.
    let nested = [("all/scenes/wall.toml", &scene[..]), ("all/data/x.png", &heights), ("all/x.png", &other)];
    page.drop_all(2, &nested, None).expect("taken");
    assert_eq!(page.value("height"), "\"all/data/x.png\"");
    for (number, files, words) in [
        (3, vec![("wall.toml", &scene[..]), ("y.png", &heights)], "did not come with it"),
        (4, vec![("wall.toml", &scene[..]), ("a/x.png", &heights), ("b/x.png", &other)], "several files"),
    ] {
        let refused = page.drop_all(number, &files, None).expect_err("refused");
        assert!(refused.contains(words) && refused.contains("../data/x.png"), "{refused}");
        assert!(refused.contains("drop the folder") && !refused.contains("relief-view-"), "{refused}");
    }
}

#[test]
fn functions_are_of_the_surface_that_is_asked_for_with_its_settings() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png"]);
    let two = "height = \"cobbles.png\"\nshadow = \"ray\"\n[[surfaces]]\nmethod = \"cone\"\n[[surfaces]]\n\
               method = \"relief\"\n\
               set.search.steps = 6\n";
    folder.write("two.toml", two);
    let page = Page::open(&folder, "two.toml --backend cpu");
    let functions = "shader --entry functions --name relief --target wgsl -q";
    let of_first = format!("{functions} --method cone --shadow ray -o first");
    let of_second = format!("{functions} --method relief --shadow ray --set search.steps=6 -o second");
    for (surface, line, out) in [(0, of_first, "first"), (1, of_second, "second")] {
        folder.relief(&line).fine();
        let saved = page.get(&format!("save?what=relief.wgsl&surface={surface}"));
        assert!(saved == fs::read(folder.path(format!("{out}/relief.wgsl"))).expect("a file"), "{out}");
    }
    assert_eq!(page.ask("GET", "save?what=relief.wgsl&surface=2", b"").0, 422);
    let state = page.state();
    let is_of_surface = |what: &str| {
        let saves = state["saves"].as_array().expect("a list");
        saves.iter().find(|saved| saved["what"] == what).expect("a file")["of_surface"].clone()
    };
    assert_eq!((is_of_surface("relief.wgsl"), is_of_surface("picture.png")), (json!(true), json!(false)));
}

#[test]
fn a_page_that_is_behind_saves_nothing() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png"]);
    let page = Page::open(&folder, "cobbles.png --backend cpu");
    let revision = page.state()["revision"].as_u64().expect("a number");
    page.get(&format!("save?what=scene.toml&revision={revision}"));
    page.apply(&json!({ "do": "set", "key": "scale", "value": 0.2 })).expect("a change");
    let Answer(status, said) = page.ask("GET", &format!("save?what=scene.toml&revision={revision}"), b"");
    let said = String::from_utf8_lossy(&said).into_owned();
    assert!(status == 409 && said.contains("another page"), "{said}");
    page.get(&format!("save?what=scene.toml&revision={}", revision + 1));
}

#[test]
fn messages_name_controls() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png"]);
    let page = Page::open(&folder, "cobbles.png --backend cpu");
    for (key, value, words) in [
        ("ior", json!(99), "Ior: "),
        ("tile-size", json!("[\"5parsec\", 1]"), "Tile size: "),
        ("scale", json!("abc"), "Scale: "),
    ] {
        let refused = page.apply(&json!({ "do": "set", "key": key, "value": value })).expect_err("refused");
        assert!(refused.contains(words), "{refused}");
    }
    page.apply(&json!({ "do": "set", "key": "scale", "value": "5cm" })).expect("a length");
    page.apply(&json!({ "do": "set", "key": "tile-size", "value": "[\"5cm\", 1]" })).expect("lengths");
    assert_eq!((page.value("scale"), page.value("tile-size")), (json!("0.05"), json!("[0.05, 1.0]")));
    let empty = Page::open(&folder, "--backend cpu");
    let Answer(status, said) = empty.ask("GET", &format!("picture?{WHOLE}"), b"");
    let said = String::from_utf8_lossy(&said).into_owned();
    assert!(status == 422 && said.contains("choose a file at Height") && !said.contains("key"), "{said}");
}

#[test]
fn a_file_that_cannot_be_loaded_at_all_opens_no_page() {
    let folder = Folder::new();
    shipped(&folder, &["cobbles.png", "cobbles_color.png"]);
    folder.write("empty.png", "");
    folder.write("text.png", "hello");
    folder.write("lacking.toml", "height = \"cobbles.png\"\ncolor = \"away.png\"\n");
    for (line, words) in [
        ("nosuch.png", "cannot be read"),
        ("empty.png", "is empty"),
        ("text.png", "is not a PNG"),
        ("nosuch.toml", "cannot be read"),
        ("nosuch.obj", "nosuch.obj"),
        ("cobbles.png --color nosuch.png", "nosuch.png"),
    ] {
        let ran = folder.relief(&format!("view {line} --no-open"));
        assert!(ran.code == Some(1) && ran.stderr.contains(words), "{line}: {:?} {}", ran.code, ran.stderr);
        assert_eq!(ran.stdout, "", "{line}");
    }
    let ran = folder.relief("view cobbles.png --no-open -o out");
    assert!(ran.code == Some(2) && ran.stderr.contains("--script"), "{}", ran.stderr);
    // What a control can mend is mended on the page.
    let page = Page::open(&folder, "cobbles_color.png --backend cpu --samples 1");
    page.apply(&json!({ "do": "set", "key": "channel", "value": "g" })).expect("a channel");
    page.picture(WHOLE);
    let page = Page::open(&folder, "lacking.toml --backend cpu --samples 1");
    let Answer(status, said) = page.ask("GET", &format!("picture?{WHOLE}"), b"");
    assert!(status == 422 && String::from_utf8_lossy(&said).contains("away.png"));
    page.apply(&json!({ "do": "lose", "key": "color" })).expect("no colour");
    page.picture(WHOLE);
}
