//! Baked maps that `relief render` caches from run to run.

use std::path::{Path, PathBuf};
#[cfg(unix)]
use std::process::Command;
use std::process::Stdio;
use std::time::Instant;

use crate::common::command::{Folder, Ran};
use crate::common::maps::Map;
use serde_json::Value;

/// A folder with two maps of hills of one size.
fn map_folder() -> Folder {
    let folder = Folder::new();
    for (name, step) in [("one.png", 700), ("two.png", 900)] {
        let map = Map::new(48, 40, |x, y| ((x * step + y * 1100 + (x * y) % 11 * 2000) % 65_536) as u16);
        folder.write(name, map.png());
    }
    folder
}

/// Renders a map with the method whose search reads a baked one.
fn line(map: &str, flags: &str) -> String {
    format!(
        "render --height {map} --look plain --method frustum --backend cpu --size 64x48 --output out.png \
         {flags}"
    )
}

/// Returns a run's report on the baked map.
fn map_of(ran: Ran) -> Value {
    assert_eq!(ran.code, Some(0), "{ran:?}");
    let about: Value = serde_json::from_str(&ran.stdout).expect("JSON");
    about["maps"][0].clone()
}

fn json(folder: &Folder, map: &str, flags: &str) -> Value {
    map_of(folder.relief(&line(map, &format!("--json {flags}"))).fine())
}

fn picture(folder: &Folder) -> Vec<u8> {
    std::fs::read(folder.path("out.png")).expect("a picture")
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = std::fs::read_dir(folder) else { return Vec::new() };
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.expect("readable").path()).collect();
    // The lock file stays.
    files.retain(|file| !file.ends_with(".lock"));
    files.sort();
    files
}

#[test]
fn a_map_is_baked_once_and_read_after_that() {
    let folder = map_folder();
    let first = json(&folder, "one.png", "--cache kept/here");
    assert_eq!((&first["from"], &first["kind"]), (&"bake".into(), &"frustum".into()), "{first}");
    let with_baked = picture(&folder);
    let file = folder.path(first["file"].as_str().expect("a file"));
    assert_eq!(files(&folder.path("kept/here")), [file.as_path()]);
    let written = std::fs::read(&file).expect("the file");
    let second = json(&folder, "one.png", "--cache kept/here");
    assert_eq!((&second["from"], &second["file"]), (&"cache".into(), &first["file"]), "{second}");
    assert!(with_baked == picture(&folder) && written == std::fs::read(&file).expect("the file"));
    // Changes of the picture alone use the same baked map.
    let steeper = json(&folder, "one.png", "--cache kept/here --scale 0.2 --tile 3,2 --mesh sphere");
    assert_eq!(steeper["from"], "cache");
    // The text says so, too.
    let said = folder.relief(&line("one.png", "--cache kept/here")).fine().stdout;
    assert!(said.contains("frustum") && said.contains("kept/here"), "{said}");
}

#[test]
fn other_heights_another_wrap_and_another_size_have_files_of_their_own() {
    let folder = map_folder();
    folder.write("small.png", Map::new(47, 40, |x, y| (x * 700 + y * 100) as u16).png());
    let flags = ["", "--wrap clamp", "--wrap mirror", "--depth"];
    let mut runs: Vec<(&str, &str)> = flags.map(|flags| ("one.png", flags)).into();
    runs.extend([("two.png", ""), ("small.png", "")]);
    for (count, (map, flags)) in (1..).zip(&runs) {
        assert_eq!(json(&folder, map, &format!("--cache kept {flags}"))["from"], "bake", "{map} {flags}");
        assert_eq!(files(&folder.path("kept")).len(), count, "{map} {flags}");
    }
    for (map, flags) in runs {
        assert_eq!(json(&folder, map, &format!("--cache kept {flags}"))["from"], "cache", "{map} {flags}");
    }
}

#[test]
fn damaged_files_are_baked_again() {
    let folder = map_folder();
    let first = json(&folder, "one.png", "--cache kept");
    let right = picture(&folder);
    let file = folder.path(first["file"].as_str().expect("a file"));
    let whole = std::fs::read(&file).expect("the file");
    let mut flipped = whole.clone();
    flipped[whole.len() / 2] ^= 1;
    json(&folder, "two.png", "--cache kept");
    let others = files(&folder.path("kept")).into_iter().find(|other| *other != file).expect("a second file");
    let others = std::fs::read(others).expect("the file");
    let damages: [(&str, &[u8]); 5] = [
        ("empty", &[]),
        ("cut", &whole[..whole.len() - 1]),
        ("longer", &[&whole[..], &[0]].concat()),
        ("a flipped bit", &flipped),
        ("another map's", &others),
    ];
    for (what, bytes) in damages {
        std::fs::write(&file, bytes).expect("the folder is writable");
        let again = json(&folder, "one.png", "--cache kept");
        assert!(again["from"] == "bake" && again["note"].is_string(), "{what}: {again}");
        assert!(picture(&folder) == right, "{what}");
        assert_eq!(std::fs::read(&file).expect("the file"), whole, "{what}");
    }
    std::fs::write(&file, flipped).expect("the folder is writable");
    let ran = folder.relief(&line("one.png", "--cache kept"));
    assert!(ran.code == Some(0) && ran.stderr.starts_with("note: "), "{ran:?}");
}

#[test]
fn a_folder_that_cannot_be_written_to_is_noted_and_the_picture_is_there() {
    let folder = map_folder();
    json(&folder, "one.png", "--no-cache");
    let right = picture(&folder);
    // A file in the folder's place stops everyone, even root.
    folder.write("no-folder", "a file");
    for flags in ["--cache no-folder", "--cache no-folder/below"] {
        std::fs::remove_file(folder.path("out.png")).expect("a picture");
        let about = json(&folder, "one.png", flags);
        assert!(about["file"].is_null() && about["note"].is_string(), "{about}");
        assert!(picture(&folder) == right);
        let ran = folder.relief(&line("one.png", flags));
        assert!(ran.code == Some(0) && ran.stderr.starts_with("note: "), "{ran:?}");
    }
    assert_eq!(std::fs::read(folder.path("no-folder")).expect("the file"), b"a file");
}

#[test]
fn without_a_cache_nothing_is_read_and_nothing_kept() {
    let folder = map_folder();
    let variable = |flags: &str| {
        let line = line("one.png", &format!("--json {flags}"));
        let mut command = folder.command();
        command.env("RELIEF_CACHE", folder.path("from-the-environment")).args(line.split_ascii_whitespace());
        map_of(Ran::new(&line, &command.output().expect("the command starts")).fine())
    };
    let about = variable("--no-cache");
    assert!(about["from"] == "bake" && about["file"].is_null() && about["note"].is_null(), "{about}");
    assert!(files(&folder.path("from-the-environment")).is_empty());
    let without = picture(&folder);
    // The environment's folder is used; a flag overrides it.
    assert_eq!(variable("")["from"], "bake");
    assert_eq!(files(&folder.path("from-the-environment")).len(), 1);
    assert!(without == picture(&folder));
    assert_eq!(variable("")["from"], "cache");
    assert!(without == picture(&folder));
    assert_eq!(variable("--cache by-flag")["from"], "bake");
    // Existing files are not read either.
    let file = &files(&folder.path("from-the-environment"))[0];
    std::fs::write(file, "nothing of use").expect("the folder is writable");
    let about = variable("--no-cache");
    assert!(about["from"] == "bake" && about["note"].is_null(), "{about}");
    assert_eq!(std::fs::read(file).expect("the file"), b"nothing of use");
    let both = folder.relief(&line("one.png", "--no-cache --cache kept"));
    assert_eq!(both.code, Some(2), "{both:?}");
}

#[test]
fn methods_without_a_baked_map_do_not_touch_the_cache() {
    let folder = map_folder();
    let ran = folder.relief(
        "render --height one.png --look plain --method relief --backend cpu --cache kept --json -o out.png",
    );
    assert!(map_of(ran.fine()).is_null());
    assert!(!folder.path("kept").exists());
}

#[test]
fn several_processes_at_once_all_finish_and_leave_one_whole_file() {
    let folder = map_folder();
    let runs: Vec<_> = (0..6)
        .map(|number| {
            let line = line("one.png", "--cache kept").replace("out.png", &format!("out{number}.png"));
            let mut command = folder.command();
            command.args(line.split_ascii_whitespace()).stdout(Stdio::piped()).stderr(Stdio::piped());
            (line, command.spawn().expect("the command starts"))
        })
        .collect();
    for (line, run) in runs {
        Ran::new(&line, &run.wait_with_output().expect("the command ends")).fine();
    }
    let pictures: Vec<Vec<u8>> = (0..6)
        .map(|number| std::fs::read(folder.path(format!("out{number}.png"))).expect("a picture"))
        .collect();
    assert!(pictures.iter().all(|picture| *picture == pictures[0]));
    assert_eq!(files(&folder.path("kept")).len(), 1);
    assert_eq!(json(&folder, "one.png", "--cache kept")["from"], "cache");
}

/// Bytes of everything in a folder.
fn held(folder: &Path) -> u64 {
    files(folder).iter().filter_map(|file| file.metadata().ok()).map(|about| about.len()).sum()
}

#[test]
fn killed_processes_leave_nothing_over_and_nothing_wrong() {
    const LIMIT: u64 = 1_500_000;
    let folder = Folder::new();
    for (name, step) in [("one.png", 700), ("two.png", 900)] {
        let map = Map::new(256, 256, |x, y| ((x * step + y * 1100 + (x * y) % 11 * 2000) % 65_536) as u16);
        folder.write(name, map.png());
    }
    let flags = format!("--cache kept --cache-size {LIMIT}");
    json(&folder, "one.png", "--no-cache");
    let right = picture(&folder);
    let started = Instant::now();
    json(&folder, "two.png", "--no-cache");
    let whole = started.elapsed();
    // Of the two maps the folder holds one only, so that each run writes, and removes the other's.
    let mut state = 1u32;
    for round in 0..20 {
        let words = line(["one.png", "two.png"][round % 2], &flags);
        let mut run = folder.command().args(words.split_ascii_whitespace()).stdout(Stdio::null()).spawn();
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        std::thread::sleep(whole.mul_f64(1.2 * f64::from(state) / f64::from(u32::MAX)));
        let run = run.as_mut().expect("the command starts");
        run.kill().expect("it is ours");
        run.wait().expect("it ends");
        assert!(held(&folder.path("kept")) <= LIMIT, "round {round}");
    }
    json(&folder, "one.png", &flags);
    assert!(picture(&folder) == right);
    assert_eq!(json(&folder, "one.png", &flags)["from"], "cache");
    assert!(picture(&folder) == right);
    assert_eq!(files(&folder.path("kept")).len(), 1);
    assert!(held(&folder.path("kept")) <= LIMIT);
}

#[test]
#[cfg(unix)]
fn a_disk_that_fills_up_is_noted_and_leaves_nothing() {
    let folder = map_folder();
    json(&folder, "one.png", "--no-cache");
    let right = picture(&folder);
    // No file may grow beyond 16 blocks of 512 bytes: the picture fits, the map does not.
    let line = line("one.png", "--json --cache kept");
    let script = format!("trap '' XFSZ; ulimit -f 16; exec {} {line}", env!("CARGO_BIN_EXE_relief"));
    let mut shell = Command::new("sh");
    shell.args(["-c", &script]).current_dir(folder.path("")).stdin(Stdio::null());
    let about = map_of(Ran::new(&line, &shell.output().expect("a shell")).fine());
    assert!(about["from"] == "bake" && about["file"].is_null() && about["note"].is_string(), "{about}");
    assert!(picture(&folder) == right);
    assert_eq!(files(&folder.path("kept")), [] as [PathBuf; 0]);
}

#[test]
fn a_map_that_needs_more_memory_than_allowed_is_refused_before_it_is_baked() {
    let folder = Folder::new();
    folder.write("map.png", Map::new(1024, 1024, |x, y| (x * 60 + y) as u16).png());
    let render = |method: &str| {
        let line = format!(
            "render --height map.png --look plain --method {method} --backend cpu --size 16x16 -o out.png"
        );
        folder.relief(&format!("{line} --max-memory 32MiB --cache kept"))
    };
    render("relief").fine();
    let refused = render("frustum");
    assert!(refused.code == Some(1) && refused.stderr.contains("--max-memory"), "{refused:?}");
    assert!(!folder.path("kept").exists());
}
