//! `relief capture`: what it writes, what it says of it, and what it refuses.

mod common;

use common::command::{Folder, json_of};
use common::files::foreign;
use common::maps::Map;
use common::meshes::obj;
use common::refused::{assert_refused, entries, with_out};
use relief_core::mesh::torus;
use relief_object::{Cover, ObjectOptions, read_object};
use serde_json::Value;

fn folder() -> Folder {
    let folder = with_out();
    folder.write("ring.obj", obj(&torus(64, 32).expect("a mesh")));
    folder.write("bare.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nf 1 2 3\n");
    folder
}

fn names(value: &Value) -> Vec<String> {
    let files = value["files"].as_array().expect("files");
    files.iter().filter_map(|file| file.as_str()?.rsplit('/').next().map(str::to_owned)).collect()
}

#[test]
fn objects_are_written_and_read() {
    let folder = folder();
    for (flags, views, files) in [
        ("", 6, &["depth.exr", "normal.png", "object.toml"][..]),
        (
            "--views octahedral --grid 3 --bits 16",
            9,
            &["depth.png", "normal.png", "normal-depth.png", "object.toml"],
        ),
        (
            "--views hemi --grid 2 --bits 8",
            4,
            &["depth.png", "normal.png", "normal-depth.png", "object.toml"],
        ),
        ("--views horizontal --grid 5 --perspective 40", 5, &["depth.exr", "normal.png", "object.toml"]),
    ] {
        let line = format!("capture ring.obj {flags} --size 48 --verify 4 --json -o out/ring");
        let about = json_of(&folder.relief(&line).fine());
        assert_eq!(names(&about), files, "{flags}");
        assert_eq!(about["views"].as_u64(), Some(views));
        let object = read_object(&folder.path("out/ring/object.toml"), &ObjectOptions::default());
        let object = object.expect("an object");
        assert_eq!(object.object.views().len() as u64, views);
        // What was measured is said and kept.
        let measured = object.measured.expect("measured");
        let near = |iou: f64| (iou - measured.iou).abs() < 1e-12;
        assert!(about["measured"]["iou"].as_f64().is_some_and(near), "{flags}");
        assert_eq!(about["compared"].as_array().map(Vec::len), Some(Cover::ALL.len()));
        let best = about["compared"].as_array().expect("both").iter().filter_map(|row| row["iou"].as_f64());
        assert!(near(best.fold(0.0, f64::max)), "{flags}");
        assert_eq!(entries(&folder.path("out/ring")).len(), files.len(), "{flags}");
        assert_eq!((about["backs"].as_u64(), about["open_edges"].as_u64()), (Some(0), Some(0)));
        std::fs::remove_dir_all(folder.path("out/ring")).expect("it is there");
    }
}

#[test]
fn bytes_are_the_same_whatever_the_threads_and_the_views_come_from() {
    let folder = folder();
    let bytes = |flags: &str, name: &str| {
        folder.relief(&format!("capture ring.obj {flags} --size 40 --verify 2 -o out/{name} -q")).fine();
        ["object.toml", "depth.exr", "normal.png"]
            .map(|file| std::fs::read(folder.path(format!("out/{name}/{file}"))).expect("it was written"))
    };
    let first = bytes("--threads 1", "a");
    assert!(first == bytes("--threads 3", "b"));
    assert!(first == bytes("--views out/a/object.toml", "c"));
    let list = std::fs::read_to_string(folder.path("out/a/object.toml")).expect("it was written");
    for (name, text) in foreign(&list) {
        folder.write("views.toml", text);
        assert!(first == bytes("--views views.toml", &name.replace(" ", "-")), "{name}");
    }
    assert!(first != bytes("--views out/a/object.toml --perspective 30", "d"));
}

#[test]
fn open_meshes_and_missing_colours_are_told() {
    let folder = folder();
    let ran = folder.relief("capture bare.obj --size 32 --verify 2 -o out/bare");
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    assert!(ran.stderr.contains("texture coordinates"), "{}", ran.stderr);
    assert!(ran.stdout.contains("3 edges of the mesh are open"), "{}", ran.stdout);
    let about =
        json_of(&folder.relief("capture bare.obj --size 32 --verify 0 --cover pixel --json -o out/b"));
    let count = |name: &str| about[name].as_u64().expect("a number");
    // One of both sides that the triangle is seen from shows its back.
    assert!(count("backs") > 0 && 3 * count("backs") < 2 * count("seen"), "{about}");
    assert!(about["measured"].is_null());
}

#[test]
fn scenes_give_a_mesh_its_place_and_its_colours() {
    let folder = folder();
    let grey: Vec<u8> = vec![200; 3 * 4];
    relief_io::write_png8(&folder.path("c.png"), 2, 2, relief_io::PngColour::Rgb, &grey).expect("written");
    folder.write("s.toml", "mesh = 'ring.obj'\ncolor = 'c.png'\nposition = [1, 2, 3]\n");
    let line = "capture s.toml --size 32 --verify 0 --cover centre --json -o out/s";
    let about = json_of(&folder.relief(line).fine());
    assert!(names(&about).contains(&"color.png".to_owned()));
    let height = about["centre_m"][1].as_f64().expect("a number");
    assert!((height - 2.0).abs() < 1e-6, "{about}");
    let object = read_object(&folder.path("out/s/object.toml"), &ObjectOptions::default());
    let color = object.expect("an object").color.expect("colours");
    let is_grey = |texel: &[f32; 4]| (texel[0] - 0.578).abs() < 0.01;
    assert!(color.texels.iter().filter(|texel| texel[3] > 0.0).all(is_grey));
}

#[test]
fn relief_of_a_scene_is_captured_displaced() {
    let folder = folder();
    folder.write("hills.png", Map::many_hills().png());
    let radius = |scale: f64| {
        let scene = format!("height = 'hills.png'\nmesh = 'ring.obj'\nscale = {scale}\nbias = 0\n");
        folder.write("hills.toml", scene);
        let line = "capture hills.toml --size 64 --verify 2 --cover centre --json -o out/hills";
        let about = json_of(&folder.relief(line).fine());
        assert!(about["triangles"].as_u64().is_some_and(|count| count > 10_000), "{about}");
        about["radius_m"].as_f64().expect("a number")
    };
    let [low, high] = [radius(0.01), radius(0.1)];
    assert!((high - low - 0.09).abs() < 0.02, "{low} {high}");
}

#[test]
fn what_cannot_be_captured_is_refused() {
    let folder = folder();
    folder.write("two.toml", "[[surfaces]]\nmesh = 'cube'\n[[surfaces]]\nmesh = 'sphere'\n");
    folder.write("relief.toml", "height = 'h.png'\nmesh = 'cube'\n");
    folder.write("hills.png", Map::many_hills().png());
    folder.write("hills.toml", "height = 'hills.png'\nmesh = 'ring.obj'\nscale = 0.05\nbias = 0\n");
    folder.write("object.toml", "object = 'ring/object.toml'\n");
    folder.write("none.toml", "kind = 'orthographic'\n");
    folder.write("zero.toml", "[[view]]\nfrom = [0, 0, 0]\n");
    folder.write("near.toml", "kind = 'perspective'\n[[view]]\neye = [0.1, 0, 0]\nfov = 40\n");
    folder.write("narrow.toml", "kind = 'perspective'\n[[view]]\neye = [9, 0, 0]\nfov = 1\n");
    folder.write("file", "");
    for (line, code, words) in [
        ("missing.obj -o out/a", 1, &["missing.obj"][..]),
        ("kube -o out/a", 2, &["cube"]),
        ("missing.toml -o out/a", 1, &["missing.toml"]),
        ("two.toml -o out/a", 1, &["two.toml", "several"]),
        ("relief.toml -o out/a", 1, &["h.png"]),
        ("hills.toml -o out/a --max-memory 1MiB", 1, &["--max-memory"]),
        ("object.toml -o out/a", 1, &["object.toml", "already"]),
        ("ring.obj -o file", 1, &["file"]),
        ("ring.obj -o out/a --views kube", 2, &["cube"]),
        ("ring.obj -o out/a --views missing.toml", 1, &["missing.toml"]),
        ("ring.obj -o out/a --views none.toml", 1, &["none.toml", "this one 0"]),
        ("ring.obj -o out/a --views zero.toml", 1, &["zero.toml", "view 1", "from"]),
        ("ring.obj -o out/a --views near.toml", 1, &["near.toml", "inside"]),
        ("ring.obj -o out/a --views narrow.toml", 1, &["narrow.toml", "all of the mesh"]),
        ("ring.obj -o out/a --views near.toml --perspective 30", 2, &["--perspective"]),
        ("ring.obj -o out/a --grid 4", 2, &["--grid", "--views"]),
        ("ring.obj -o out/a --views octahedral --grid 1", 2, &["--grid"]),
        ("ring.obj -o out/a --views horizontal --grid 2000", 2, &["--grid", "1024"]),
        ("ring.obj -o out/a --size 3", 2, &["--size"]),
        ("ring.obj -o out/a --size -3", 2, &["--size"]),
        ("ring.obj -o out/a --size 16384 --max-memory 1MiB", 1, &["--max-memory"]),
        ("ring.obj -o out/a --bits 12", 2, &["--bits"]),
        ("ring.obj -o out/a --perspective 180", 2, &["--perspective", "180"]),
        ("ring.obj -o out/a --cover middle", 2, &["centre"]),
        ("ring.obj -o out/a --verify 0", 2, &["--cover", "--verify"]),
        ("ring.obj -o out/a --verify 5000", 2, &["--verify"]),
        ("ring.obj -o out/a --cells highst", 2, &["highest"]),
        ("ring.obj -o out/a --jump -1", 2, &["--jump"]),
        ("ring.obj -o out/a --color missing.png", 1, &["missing.png"]),
    ] {
        assert_refused(&folder, &folder.relief(&format!("capture {line}")), code, words);
    }
}
