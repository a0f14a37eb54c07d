//! `relief capture`: files, report and refusals.

use crate::common::aov::Aov;
use crate::common::command::{Folder, json_of};
use crate::common::files::foreign;
use crate::common::maps::Map;
use crate::common::meshes::{gltf, obj};
use crate::common::refused::{assert_refused, entries, with_out};
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
        // The measurement is printed and stored.
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
fn open_meshes_are_told() {
    let folder = folder();
    let ran = folder.relief("capture bare.obj --size 32 --verify 2 -o out/bare");
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    assert!(ran.stdout.contains("3 edges of the mesh are open"), "{}", ran.stdout);
    let about =
        json_of(&folder.relief("capture bare.obj --size 32 --verify 0 --cover pixel --json -o out/b"));
    let count = |name: &str| about[name].as_u64().expect("a number");
    // The triangle is seen from both sides, and one of them is its back.
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

/// Rectangles between corners that are given in turn, as an OBJ.
fn cards(corners: &[[[f64; 3]; 4]]) -> String {
    let mut text = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n".to_owned();
    for (number, card) in corners.iter().enumerate() {
        for [x, y, z] in card {
            text += &format!("v {x} {y} {z}\n");
        }
        let [a, b, c, d] = [1, 2, 3, 4].map(|corner| 4 * number + corner);
        text += &format!("f {a}/1 {b}/2 {c}/3\nf {a}/1 {c}/3 {d}/4\n");
    }
    text
}

#[test]
fn a_single_card_is_said_to_leave_nothing_and_is_shown_as_an_impostor() {
    let upright = [[-0.5, 0.0, 0.0], [0.5, 0.0, 0.0], [0.5, 1.0, 0.0], [-0.5, 1.0, 0.0]];
    let lying = [[-0.5, 0.0, 0.5], [0.5, 0.0, 0.5], [0.5, 0.0, -0.5], [-0.5, 0.0, -0.5]];
    let across = [[0.0, 0.0, 0.5], [0.0, 0.0, -0.5], [0.0, 1.0, -0.5], [0.0, 1.0, 0.5]];
    let folder = folder();
    folder.write("sign.obj", cards(&[upright]));
    folder.write("leaf.obj", cards(&[lying]));
    folder.write("fence.obj", cards(&[upright, upright.map(|[x, y, z]| [x + 1.0, y, z])]));
    folder.write("crossed.obj", cards(&[upright, across, lying.map(|[x, y, z]| [x, y + 0.5, z])]));
    for (mesh, flags, size, solid) in [
        ("sign.obj", "", 32, false),
        ("sign.obj", "--views octahedral --grid 4 --verify 4", 32, false),
        ("sign.obj", "--views octahedral --grid 6 --verify 0", 32, false),
        ("sign.obj", "--cover centre", 33, false),
        ("leaf.obj", "--verify 0", 32, false),
        ("leaf.obj", "--cover centre --verify 2", 33, false),
        ("fence.obj", "--views octahedral --grid 4 --cover pixel --verify 2", 32, false),
        // A row of texels in the middle sees a card through it.
        ("sign.obj", "--cover pixel --verify 2", 33, true),
        ("crossed.obj", "--verify 2", 33, true),
        ("ring.obj", "--verify 0", 32, true),
        ("cube", "--verify 0 --views octahedral --grid 3", 32, true),
    ] {
        let line = format!("capture {mesh} {flags} --size {size} -o o");
        assert_eq!(json_of(&folder.relief(&format!("{line} --json")).fine())["solid"], solid, "{line}");
        let ran = folder.relief(&line);
        assert_eq!(ran.code, Some(0), "{line}: {}", ran.stderr);
        let said = format!("{}{}", ran.stdout, ran.stderr);
        assert_eq!(ran.stdout.contains("empty"), !solid, "{line}: {said}");
        assert_eq!(ran.stderr.contains("impostor-blend"), !solid, "{line}: {said}");
        // The choice without a comparison is noted.
        let takes_pixel = flags.contains("--verify 0") && !flags.contains("--cover");
        assert_eq!(ran.stderr.contains("--cover pixel is used"), takes_pixel, "{line}: {said}");
        if takes_pixel {
            assert!(ran.stdout.contains("cover pixel"), "{line}: {said}");
        }
    }
    // From the front the impostor is as large as the card, in the box of the ball around it.
    for (mesh, eye) in [("sign.obj", "0,0.5,3"), ("leaf.obj", "0,3,0.001")] {
        let capture = "--views octahedral --grid 12 --size 96 --cover centre --verify 0 -q -o o";
        folder.relief(&format!("capture {mesh} {capture}")).fine();
        let target = if mesh == "sign.obj" { "0,0.5,0" } else { "0,0,0" };
        let look = format!("--size 96x96 --eye {eye} --target {target} --fov 40 --samples 1 --backend cpu");
        let covered = |shown: &str| {
            folder.relief(&format!("render {shown} {look} --shadow none -q -o a.png --aov a.exr")).fine();
            let aov = Aov::read(&folder.path("a.exr"));
            aov.pixels().filter(|(_, _, pixel)| pixel.hit > 0.0).count() as f64
        };
        let blended = covered("--object o/object.toml --method impostor-blend");
        // A square of 1 m at 3 m.
        let side = 96.0 / (2.0 * 20.0_f64.to_radians().tan() * 3.0);
        assert!((blended / (side * side) - 1.0).abs() < 0.05, "{mesh}: {blended} of {}", side * side);
    }
}

/// A folder with a mesh whose picture has the name of an object's.
fn with_picture(picture: &str, buffer: &str) -> Folder {
    let folder = folder();
    let (json, bytes) = gltf(picture, buffer);
    folder.write("m.gltf", json);
    folder.write(buffer, bytes);
    folder.write(picture, Map::hills().png());
    folder
}

#[test]
fn objects_replace_nothing_that_they_are_made_from() {
    for (picture, buffer, line, read) in [
        ("color.png", "b.bin", "m.gltf -o .", "color.png"),
        ("normal.png", "b.bin", "m.gltf -o .", "normal.png"),
        ("p.png", "depth.exr", "m.gltf -o .", "depth.exr"),
        ("maps/color.png", "b.bin", "m.gltf -o maps", "color.png"),
        ("color.png", "b.bin", "ring.obj --color color.png -o .", "color.png"),
        ("color.png", "b.bin", "ring.obj --color color.png --force -o .", "color.png"),
        ("depth.png", "b.bin", "ring.obj --color depth.png --bits 8 -o .", "depth.png"),
        ("color.png", "b.bin", "s.toml -o .", "color.png"),
        ("color.png", "b.bin", "of_file.toml -o .", "color.png"),
        ("p.png", "b.bin", "ring.obj --views object.toml -o .", "object.toml"),
    ] {
        let folder = with_picture(picture, buffer);
        folder.write("s.toml", format!("mesh = 'ring.obj'\ncolor = '{picture}'\n"));
        folder.write("of_file.toml", "mesh = 'm.gltf'\n");
        folder.write("object.toml", "[[view]]\nfrom = [0, 0, 1]\n");
        let bytes = |name: &str| std::fs::read(folder.path(name)).expect("it is there");
        let before = [picture, buffer, "object.toml"].map(bytes);
        let ran = folder.relief(&format!("capture {line} --size 16 --verify 0 --cover centre"));
        assert_refused(&folder, &ran, 2, &["would replace the input", read]);
        assert!(before == [picture, buffer, "object.toml"].map(bytes), "{line}");
    }
}

#[test]
fn files_that_no_capture_has_written_are_replaced_when_asked_to() {
    let capture = "capture ring.obj --size 16 --verify 0 --cover centre -q -o o";
    for (name, more) in [
        ("normal.png", ""),
        ("depth.exr", ""),
        ("depth.png", "--bits 8"),
        ("normal-depth.png", "--views octahedral --grid 2"),
        ("object.toml", ""),
    ] {
        let folder = folder();
        folder.write(&format!("o/{name}"), "mine");
        let ran = folder.relief(&format!("{capture} {more}"));
        assert_refused(&folder, &ran, 1, &[name, "exists already", "--force"]);
        assert_eq!(entries(&folder.path("o")), [name]);
        assert_eq!(std::fs::read(folder.path(format!("o/{name}"))).expect("it is there"), b"mine");
        folder.relief(&format!("{capture} {more} --force")).fine();
        // A capture replaces its own files.
        folder.relief(&format!("{capture} {more}")).fine();
        read_object(&folder.path("o/object.toml"), &ObjectOptions::default()).expect("an object");
    }
    // Other files of these names stay; files of another object are removed.
    let folder = folder();
    folder.relief(&format!("{capture} --views hemi --grid 2 --bits 16")).fine();
    folder.write("o/depth.exr", "mine");
    folder.write("o/color.png", "mine");
    folder.relief(&format!("{capture} --bits 8")).fine();
    let mut names = entries(&folder.path("o"));
    names.sort();
    assert_eq!(names, ["color.png", "depth.exr", "depth.png", "normal.png", "object.toml"]);
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
        ("ring.obj -o out/a --verify 0 --cover auto", 2, &["--cover", "--verify"]),
        ("ring.obj -o out/a --verify 5000", 2, &["--verify"]),
        ("ring.obj -o out/a --cells highst", 2, &["highest"]),
        ("ring.obj -o out/a --jump -1", 2, &["--jump"]),
        ("ring.obj -o out/a --color missing.png", 1, &["missing.png"]),
    ] {
        assert_refused(&folder, &folder.relief(&format!("capture {line}")), code, words);
    }
}
