//! Files that `relief compare`, `relief bench` and `relief shader` leave if they cannot go on.

#![cfg(unix)]

use std::process::{Command, Stdio};

use crate::common::command::{Folder, Ran};
use crate::common::maps::Map;
use crate::common::refused::entries;

/// Flags of a comparison that takes a moment.
const SMALL: &str = "--quick --rays 50 --size 16x12 --samples 1 --angles 30 --backend cpu";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("map.png", Map::constant(0.5).png());
    folder.write("old/page.html", b"old");
    folder.write("old/all.csv", b"old");
    folder
}

/// Runs a line in a shell after other commands, as with less room for files.
fn in_shell(folder: &Folder, before: &str, line: &str) -> Ran {
    let script = format!("{before}; exec {} {line}", env!("CARGO_BIN_EXE_relief"));
    let output = Command::new("sh").args(["-c", &script]).current_dir(folder.path("")).output();
    Ran::new(line, &output.expect("a shell runs"))
}

fn assert_old(folder: &Folder) {
    for name in ["page.html", "all.csv"] {
        let bytes = std::fs::read(folder.path("old").join(name)).expect("it is there");
        assert_eq!(bytes, b"old", "{name}");
    }
    let mut left = entries(&folder.path("old"));
    left.retain(|name| !name.starts_with('.'));
    left.sort();
    assert_eq!(left, ["all.csv", "page.html"]);
}

#[test]
fn no_room_on_the_disk_leaves_what_was_there() {
    let folder = folder();
    let outputs = "-o old/page.html --csv old/all.csv --records old/all.json";
    let line = format!("compare --height map.png --methods bump {SMALL} {outputs}");
    // Blocks of 512 bytes: the page takes more, the files before it take less.
    let ran = in_shell(&folder, "trap '' XFSZ; ulimit -f 8", &line);
    assert_eq!((ran.code, ran.stdout.as_str()), (Some(1), ""), "{}", ran.stderr);
    assert!(ran.stderr.contains("old/page.html") && !ran.stderr.contains("panicked"), "{}", ran.stderr);
    assert_old(&folder);
    // With room all are replaced.
    folder.relief(&line).fine();
    assert!(std::fs::metadata(folder.path("old/page.html")).expect("it is there").len() > 4096);
    assert!(folder.path("old/all.json").is_file());
}

#[cfg(target_os = "linux")]
#[test]
fn an_answer_that_cannot_be_written_is_an_error() {
    let folder = folder();
    let lines = [
        format!("compare --height map.png --methods bump {SMALL} --json -o page.html"),
        "bench --height map.png --methods bump --size 16x12 --frames 2 --backend cpu".to_owned(),
        "shader --method cone --target wgsl -o shaders".to_owned(),
    ];
    for line in lines {
        let ran = in_shell(&folder, "exec > /dev/full", &line);
        assert_eq!(ran.code, Some(1), "{line}: {}", ran.stderr);
        // With --json the error is JSON, too.
        let is_error = ["error: ", "{\"error\":"].iter().any(|start| ran.stderr.starts_with(start));
        assert!(is_error && ran.stderr.contains("standard output"), "{}", ran.stderr);
    }
}

#[test]
fn an_interrupt_leaves_what_was_there() {
    let folder = folder();
    let line =
        "compare --height map.png --size 160x120 --backend cpu --json -o old/page.html --csv old/all.csv";
    let mut command = folder.command();
    command.args(line.split(' ')).stdout(Stdio::piped()).stderr(Stdio::piped());
    let run = command.spawn().expect("the command starts");
    // When the files are begun, the work goes on for long.
    let begun = || entries(&folder.path("old")).len() > 2;
    for _ in 0..4000 {
        if begun() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    assert!(begun());
    let killed = Command::new("kill").args(["-INT", &run.id().to_string()]).status();
    assert!(killed.expect("kill runs").success());
    let ran = Ran::new(line, &run.wait_with_output().expect("it ends"));
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("cancelled"), "{}", ran.stderr);
    assert_eq!(entries(&folder.path("old")).len(), 2);
    assert_old(&folder);
}

#[test]
fn two_outputs_do_not_become_one_file() {
    let folder = folder();
    std::os::unix::fs::symlink("page.html", folder.path("all.json")).expect("a link");
    folder.write("page.html", b"old");
    let line = format!("compare --height map.png --methods bump {SMALL}");
    let ran = folder.relief(&format!("{line} -o page.html --records all.json"));
    assert_eq!((ran.code, ran.stdout.as_str()), (Some(1), ""), "{}", ran.stderr);
    assert!(ran.stderr.contains("two outputs"), "{}", ran.stderr);
    assert_eq!(std::fs::read(folder.path("page.html")).expect("it is there"), b"old");
    // Names have endings that say what is in them, so that no two can be the same.
    for flags in ["-o a.csv --csv a.csv", "-o a.html --records a.html", "--csv a.json --records a.json"] {
        assert_eq!(folder.relief(&format!("{line} {flags}")).code, Some(2), "{flags}");
    }
    let ran = folder.relief("shader --method cone --target wgsl,wgsl -o shaders");
    assert!(ran.code == Some(2) && !folder.path("shaders").exists(), "{}", ran.stderr);
}
