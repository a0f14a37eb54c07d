//! Files that are given, and what they change.

use std::path::Path;

use relief_core::Watch;
use relief_io::MemoryFiles;
use relief_render::block_on;
use relief_session::Session;
use serde_json::json;

use crate::{Asked, Given, NotDrawn, Sent, Viewer};

/// Files by their paths.
type Files<'a> = &'a [(&'a str, &'a [u8])];

const MAP: &[u8] = b"P5 2 2 255\n\x00\x40\x80\xff";

fn viewer() -> Viewer {
    let mut files = MemoryFiles::new();
    files.insert("a/wall.pgm", MAP).expect("a path");
    files.insert("a/scene.toml", b"height = 'wall.pgm'".as_slice()).expect("a path");
    Viewer::open(files, "a/scene.toml".as_ref()).expect("a scene")
}

/// The text of the scene that files change, before they are tried.
fn after(files: Files, key: Option<&str>) -> Result<String, String> {
    let mut memory = MemoryFiles::new();
    memory.insert("wall.pgm", MAP).expect("a path");
    let mut given = Given::new("given", 1 << 20);
    for (path, bytes) in files {
        let place = given.place(3, path, bytes.len() as u64)?;
        memory.insert(place, *bytes).expect("a path");
    }
    let files = relief_io::Files::Memory(memory);
    let session = Session::new("height = 'wall.pgm'").expect("a scene");
    let coming = given.coming(3, key, &files).and_then(|coming| coming.with(&session));
    let taken = coming.map_err(|error| given.named(&error.to_string()))?;
    Ok(given.scene_text(&taken.document, Path::to_owned))
}

#[test]
fn files_are_put_where_they_belong() {
    let obj = b"v 0 0 0\nv 0 0 1\nv 1 0 0\nvt 0 0\nvt 0 1\nvt 1 0\nf 1/1 2/2 3/3\n";
    let cases: [(Files, Option<&str>, &str); 8] = [
        (&[("x.pgm", MAP)], None, "height = \"x.pgm\""),
        (&[("x_normal.pgm", MAP)], None, "normal = \"x_normal.pgm\""),
        (&[("x.pgm", MAP)], Some("color"), "color = \"x.pgm\""),
        (&[("x.obj", obj)], None, "mesh = \"x.obj\""),
        (&[("x.ktx2", b"none")], None, "volume = \"x.ktx2\""),
        (&[("o/object.toml", b""), ("o/depth.exr", b"")], None, "object = \"o/object.toml\""),
        (&[("s/a_height.pgm", MAP), ("s/a_color.pgm", MAP)], None, "textures = \"s\""),
        (&[("s/b.toml", b"height = 'm/c.pgm'"), ("s/m/c.pgm", MAP)], None, "height = \"s/m/c.pgm\""),
    ];
    for (files, key, expected) in cases {
        let text = after(files, key).expect(expected);
        assert!(text.contains(expected) && text.starts_with("# Files"), "{expected} in:\n{text}");
    }
}

#[test]
fn what_cannot_be_taken_is_refused() {
    let cases: [(Files, Option<&str>, &str); 6] = [
        (&[("../x.pgm", MAP)], None, "'../x.pgm' is no path"),
        (&[("x.txt", b"text")], None, "x.txt: it is no picture"),
        (&[(".hidden", MAP)], None, "there is no file in it"),
        (&[("x.pgm", MAP), ("y.pgm", MAP)], Some("height"), "takes one file"),
        (&[("x.obj", b""), ("y.obj", b"")], None, "2 files are each a mesh"),
        (&[("x.toml", b"heigth = 1")], None, "x.toml"),
    ];
    for (files, key, expected) in cases {
        let said = after(files, key).expect_err(expected);
        assert!(said.contains(expected) && !said.contains("given/3"), "{said}");
    }
    assert_eq!(viewer().take(1, None), Err("no file has come".to_owned()));
}

#[test]
fn errors_change_nothing() {
    let mut viewer = viewer();
    let set =
        |value: &str| Sent::of_json(&format!(r#"{{"action": {value}, "drag": null}}"#)).expect("an action");
    let refused =
        viewer.apply(&set(r#"{"do": "set", "key": "samples", "value": 5000}"#)).expect_err("too many");
    assert!(refused.contains("1024"), "{refused}");
    viewer.apply(&set(r#"{"do": "set", "key": "height", "value": "none.pgm"}"#)).expect("a text");
    let missing = block_on(viewer.picture(Asked::whole([4, 3]), &Watch::none())).expect_err("no file");
    assert!(
        matches!(missing, NotDrawn::Scene(_)) && missing.to_string().starts_with("none.pgm: "),
        "{missing}"
    );
    viewer.apply(&set(r#"{"do": "undo"}"#)).expect("undone");
    assert!(block_on(viewer.picture(Asked::whole([4, 3]), &Watch::none())).is_ok());
    assert_eq!(viewer.state()["revision"], json!(2));
    assert!(
        block_on(viewer.save("picture.bmp", 0, &Watch::none()))
            .is_err_and(|said| said.contains("picture.bmp"))
    );
}

/// The values of all controls that have one.
fn given_values(viewer: &Viewer) -> Vec<(String, String)> {
    let state = viewer.state();
    let surfaces = state["panel"]["surfaces"][0].as_array().expect("a surface").iter();
    let text = |value: &serde_json::Value| Some(value.as_str()?.to_owned());
    surfaces.filter_map(|control| Some((text(&control["key"])?, text(&control["value"])?))).collect()
}

#[test]
fn controls_and_errors_name_files_as_the_user_knows_them() {
    let mut viewer = viewer();
    viewer.give(1, "own.pgm", MAP.to_vec()).expect("a place");
    viewer.take(1, None).expect("heights");
    let height = || ("height".to_owned(), "\"own.pgm\"".to_owned());
    assert!(given_values(&viewer).contains(&height()), "{:?}", given_values(&viewer));
    assert_eq!(viewer.state()["name"], json!("own.pgm"));
    let sent = r#"{"action": {"do": "set", "key": "color", "value": "own.pgm"}, "drag": null}"#;
    viewer.apply(&Sent::of_json(sent).expect("an action")).expect("a file that is there");
    assert!(block_on(viewer.picture(Asked::whole([4, 3]), &Watch::none())).is_ok());
    // A file that cannot be read leaves the scene as it was.
    viewer.give(2, "cut.pgm", MAP[..9].to_vec()).expect("a place");
    let said = viewer.take(2, None).expect_err("cut");
    assert!(said.starts_with("cut.pgm: "), "{said}");
    assert!(given_values(&viewer).contains(&height()));
    let scene = b"height = 'own.pgm'\nmethod = 'bump'".as_slice();
    for (path, bytes) in [("s/mine.toml", scene), ("s/own.pgm", MAP)] {
        viewer.give(3, path, bytes.to_vec()).expect("a place");
    }
    viewer.take(3, None).expect("a scene");
    assert_eq!(viewer.state()["name"], json!("mine.toml"));
}

#[test]
fn the_first_heights_take_the_places_of_all_maps_of_a_sample() {
    let sample = || {
        let mut files = MemoryFiles::new();
        for name in ["a.pgm", "a_color.pgm"] {
            files.insert(name, MAP).expect("a path");
        }
        files.insert("scene.toml", b"height = 'a.pgm'\ncolor = 'a_color.pgm'".as_slice()).expect("a path");
        Viewer::open(files, "scene.toml".as_ref()).expect("a scene")
    };
    let after = |mut viewer: Viewer, groups: &[(&str, Option<&str>)]| {
        for (group, (path, key)) in (0..).zip(groups) {
            viewer.give(group, path, MAP.to_vec()).expect("a place");
            viewer.take(group, *key).expect("a map");
        }
        let is_map = |key: &str| ["height", "color", "normal"].contains(&key);
        given_values(&viewer)
            .into_iter()
            .filter(|(key, _)| is_map(key))
            .map(|(_, value)| value)
            .collect::<Vec<_>>()
    };
    let own = [("b.pgm", None)];
    assert_eq!(after(sample().with_sample(), &own), ["\"b.pgm\""]);
    assert_eq!(after(sample(), &own), ["\"b.pgm\"", "\"a_color.pgm\""]);
    // Maps that were given stay.
    let both = [("c.pgm", Some("color")), ("b.pgm", None)];
    assert_eq!(after(sample().with_sample(), &both), ["\"b.pgm\"", "\"c.pgm\""]);
}

#[test]
fn of_two_views_each_is_saved_and_read() {
    let mut viewer = viewer();
    let apply = |viewer: &mut Viewer, key: &str, value: &str| {
        let sent = json!({ "action": { "do": "set", "key": key, "value": value }, "drag": null });
        viewer.apply(&Sent::of_json(&sent.to_string()).expect("an action")).expect("a value");
    };
    apply(&mut viewer, "viewer.second", "bump");
    apply(&mut viewer, "viewer.second-show", "flip");
    let picture = block_on(viewer.picture(Asked::whole([16, 12]), &Watch::none())).expect("drawn");
    let about = viewer.about(&picture);
    assert_eq!(about["views"][0]["method"], json!("exact"));
    let [x, y] =
        [0, 1].map(|side| about["views"][1]["errors"]["worst"][side].as_u64().expect("a pixel") as u32);
    let read = block_on(viewer.pixel([x, y], &Watch::none())).expect("read");
    assert_eq!(read["views"][1]["shown"]["name"], json!("flip"));
    assert!(read["views"][1]["shown"]["value"].as_f64().is_some_and(|flip| flip > 0.0), "{read}");
    assert_eq!(read["views"][0]["shown"], json!(null));
    let [first, second] =
        [0, 1].map(|view| block_on(viewer.save("picture.png", view, &Watch::none())).expect("a picture"));
    assert_ne!(first, second);
    let none = block_on(viewer.save("picture.png", 2, &Watch::none())).expect_err("no view");
    assert!(none.contains("no view 2"), "{none}");
}

/// A viewer with a sample, and a link to what it shows after files and values were given.
fn linked(files: Files, values: &[(&str, &str)]) -> (Viewer, String) {
    let mut viewer = viewer().with_sample();
    for (path, bytes) in files {
        viewer.give(1007, path, bytes.to_vec()).expect("a place");
    }
    if !files.is_empty() {
        viewer.take(1007, None).expect("files");
    }
    for (key, value) in values {
        let sent = json!({ "action": { "do": "set", "key": key, "value": value }, "drag": null });
        viewer.apply(&Sent::of_json(&sent.to_string()).expect("an action")).expect("a value");
    }
    let link = viewer.link().expect("a link");
    (viewer, link)
}

fn bytes(viewer: &mut Viewer) -> Result<Vec<u8>, String> {
    let drawn = block_on(viewer.picture(Asked::whole([12, 9]), &Watch::none()));
    drawn.map(crate::Drawn::into_pixels).map_err(|error| viewer.said_of_picture(&error))
}

#[test]
fn a_link_shows_the_same_in_another_viewer() {
    let (mut first, link) = linked(&[], &[("method", "bump"), ("scale", "0.3"), ("viewer.show", "depth")]);
    assert_eq!(
        link,
        "s=1&height=a/wall.pgm&method=bump&scale=0.3&viewer.show=depth&end".to_owned(),
        "{link}"
    );
    let mut second = viewer().with_sample();
    second.open_link(&link, true).expect("a scene");
    assert_eq!(bytes(&mut second), bytes(&mut first));
    assert_eq!(second.state()["undo"], json!([false, false]));
}

#[test]
fn a_link_asks_for_its_files_and_knows_them_by_their_content() {
    let own = b"P5 2 2 255\n\x00\x10\x80\x55";
    let (mut first, link) = linked(&[("own.pgm", own)], &[("method", "bump")]);
    let mut second = viewer().with_sample();
    second.open_link(&link, true).expect("a scene");
    let said = bytes(&mut second).expect_err("no file yet");
    assert!(said.contains("own.pgm") && !said.contains("given"), "{said}");
    assert!(second.link().is_err());
    // Another file of that name is none of the link's, and one of another name may be.
    second.give(1001, "own.pgm", MAP.to_vec()).expect("a place");
    assert!(second.take(1001, None).expect_err("another").contains("another content"));
    second.give(1002, "renamed.pgm", own.to_vec()).expect("a place");
    let changed = second.take(1002, None).expect("the file");
    assert_eq!(changed["changed"], json!(["height"]));
    assert_eq!(bytes(&mut second), bytes(&mut first));
    assert_eq!(second.link().as_ref(), Ok(&link));
    // A module that starts again with the text and the files finds them.
    let mut files = MemoryFiles::new();
    files.insert("scene.toml", second.text().into_bytes()).expect("a path");
    files.insert("given/1002/renamed.pgm", own.as_slice()).expect("a path");
    let mut third = Viewer::open(files, "scene.toml".as_ref()).expect("a scene");
    third.need(&link).expect("a link");
    assert_eq!(bytes(&mut third), bytes(&mut first));
}

#[test]
fn a_link_into_a_scene_is_one_step_and_a_wrong_one_none() {
    let (_, link) = linked(&[], &[("method", "bump")]);
    let mut viewer = viewer();
    let before = viewer.text();
    for (wrong, said) in [
        ("s=1&height=none.pgm&end", "none.pgm: there is no such sample"),
        ("s=1&height=given/1/x.pgm&end", "x.pgm: there is no such sample"),
        ("s=1&height=given/1/x.pgm&file=00:given/../x.pgm&end", "no path of a dropped file"),
        ("s=1&height=a/wall.pgm", "not whole"),
    ] {
        let error = viewer.open_link(wrong, false).expect_err(wrong);
        assert!(error.contains(said), "{error}");
        assert_eq!(viewer.text(), before);
    }
    viewer.open_link(&link, false).expect("a scene");
    assert!(viewer.text().contains("method = \"bump\""));
    let undo = Sent::of_json(r#"{"action": {"do": "undo"}, "drag": null}"#).expect("an action");
    viewer.apply(&undo).expect("undone");
    assert_eq!(viewer.text(), before);
}
