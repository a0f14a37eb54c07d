//! Files that are given, and what they change.

use relief_core::Watch;
use relief_io::MemoryFiles;
use serde_json::json;

use crate::{Asked, NotDrawn, Sent, Viewer};

/// Files by their paths.
type Files<'a> = &'a [(&'a str, &'a [u8])];

const MAP: &[u8] = b"P5 2 2 255\n\x00\x40\x80\xff";

fn viewer() -> Viewer {
    let mut files = MemoryFiles::new();
    files.insert("a/wall.pgm", MAP).expect("a path");
    files.insert("a/scene.toml", b"height = 'wall.pgm'".as_slice()).expect("a path");
    Viewer::open(files, "a/scene.toml".as_ref()).expect("a scene")
}

/// The text of the scene after files were given together.
fn after(files: Files, key: Option<&str>) -> Result<String, String> {
    let mut viewer = viewer();
    for (path, bytes) in files {
        viewer.give(3, path, bytes.to_vec())?;
    }
    viewer.take(3, key)?;
    Ok(String::from_utf8(viewer.save("scene.toml", &Watch::none())?).expect("a text"))
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
    let missing = viewer.picture(Asked::whole([4, 3]), &Watch::none()).expect_err("no file");
    assert!(
        matches!(missing, NotDrawn::Scene(_)) && missing.to_string().starts_with("none.pgm: "),
        "{missing}"
    );
    viewer.apply(&set(r#"{"do": "undo"}"#)).expect("undone");
    assert!(viewer.picture(Asked::whole([4, 3]), &Watch::none()).is_ok());
    assert_eq!(viewer.state()["revision"], json!(2));
    assert!(viewer.save("picture.bmp", &Watch::none()).is_err_and(|said| said.contains("picture.bmp")));
}
