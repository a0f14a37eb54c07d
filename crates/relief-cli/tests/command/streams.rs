//! Standard input and output as files: `-`.

use std::fs;
use std::io::Write;
use std::path::Path;
use std::process::{Output, Stdio};

use crate::common::command::{Folder, Ran};
use crate::common::files::foreign;
use serde_json::Value;

fn shipped() -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/bricks.png");
    fs::read(path).expect("the shipped map")
}

/// Runs a line with that on its standard input. Temporary files go into a folder of the test's own.
fn fed(folder: &Folder, line: &str, input: &[u8]) -> Output {
    let temporary = folder.path("tmp");
    fs::create_dir_all(&temporary).expect("the temporary folder is writable");
    let mut command = folder.command();
    command.args(line.split_ascii_whitespace()).env("TMPDIR", &temporary).stdin(Stdio::piped());
    let command = command.stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().expect("the command starts");
    // A command that refuses its arguments does not read.
    let _ = child.stdin.take().expect("it is piped").write_all(input);
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(fs::read_dir(&temporary).expect("it is there").count(), 0, "{line} leaves something");
    output
}

fn ran(folder: &Folder, line: &str, input: &[u8]) -> Ran {
    Ran::new(line, &fed(folder, line, input))
}

#[test]
fn maps_and_pictures_go_through_pipes() {
    let folder = Folder::new();
    folder.write("map.png", shipped());
    for (format, file) in [("png", "a.png"), ("jpg", "a.jpg"), ("exr", "a.exr")] {
        let line = "--backend cpu --size 24x16 -o";
        folder.relief(&format!("render --height map.png {line} {file}")).fine();
        let piped = fed(&folder, &format!("render --height - {line} - --format {format}"), &shipped());
        assert!(piped.status.success(), "{piped:?}");
        assert!(piped.stdout == fs::read(folder.path(file)).expect("it was written"), "{format}");
        let said = String::from_utf8_lossy(&piped.stderr);
        assert!(said.starts_with("standard output: 24x16"), "{said}");
    }
    let json = fed(&folder, "render --height - --size 8x8 -o - --format png --json", &shipped());
    let about: Value = serde_json::from_slice(&json.stderr).expect("JSON on the standard error");
    assert_eq!(about["output"], "standard output");

    ran(&folder, "bake - --kind normal -o maps", &shipped()).fine();
    let normals = fs::read(folder.path("maps/stdin.normal.png")).expect("it was written");
    let heights = fed(&folder, "height from-normals - -o - --format exr", &normals);
    assert!(heights.status.success(), "{heights:?}");
    let about = ran(&folder, "inspect - --json", &heights.stdout).fine().stdout;
    let about: Value = serde_json::from_str(&about).expect("JSON");
    assert_eq!((&about["input"], &about["width"]), (&"standard input".into(), &256.into()));
}

#[test]
fn a_scene_from_a_pipe_starts_in_the_current_folder() {
    let folder = Folder::new();
    folder.write("maps/map.png", shipped());
    let scene = b"height = 'maps/map.png'\nsize = [12, 9]\nbackend = 'cpu'\n";
    ran(&folder, "render - -o a.png", scene);
    assert!(folder.path("a.png").exists());
    let printed = ran(&folder, "scene - --samples 3 -o -", scene).fine().stdout;
    assert!(printed.contains("\nsamples = 3 ") && printed.contains("maps/map.png"), "{printed}");
    // However its text is written.
    let picture = fs::read(folder.path("a.png")).expect("it was written");
    for (name, bytes) in foreign(std::str::from_utf8(scene).expect("text")) {
        folder.write("scene.toml", &bytes);
        folder.relief("render scene.toml -o b.png").fine();
        assert!(fs::read(folder.path("b.png")).expect("it was written") == picture, "{name}");
        ran(&folder, "render - -o c.png", &bytes).fine();
        assert!(fs::read(folder.path("c.png")).expect("it was written") == picture, "{name}");
    }
    folder.write("scene.toml", b"height = 'gr\xfcn.png'\n");
    assert_eq!(folder.relief("render scene.toml -o d.png").code, Some(1));
    let wrong = ran(&folder, "render - -o d.png", b"size = [12, 9]\nsamples = 0\n");
    assert_eq!(wrong.code, Some(1));
    assert!(wrong.stderr.contains("standard input") && wrong.stderr.contains("line 2"), "{wrong:?}");
}

#[test]
fn what_cannot_go_through_a_pipe_is_refused() {
    let folder = Folder::new();
    folder.write("map.png", shipped());
    let table: &[(&str, &[u8], i32, &str)] = &[
        ("render --height map.png -o -", b"", 2, "--format"),
        ("render --height map.png -o a.png --format png", b"", 2, "--format"),
        ("render --height - --color - -o a.png", b"", 2, "once"),
        ("render - --height - -o a.png", b"", 2, "once"),
        ("render --height - -o a.png", b"", 1, "standard input"),
        ("render --height - -o a.png", &shipped()[..100], 1, "standard input"),
        ("render --height - -o - --format png", &shipped()[..100], 1, "standard input"),
        ("inspect -", b"text", 1, "standard input"),
        ("height from-normals - -o -", b"", 2, "--format"),
    ];
    for (line, input, code, word) in table {
        let ran = ran(&folder, line, input);
        assert!(ran.code == Some(*code) && ran.stderr.contains(word), "{ran:?}");
        assert!(ran.stdout.is_empty() && !folder.path("a.png").exists(), "{ran:?}");
    }
}
