//! Files of `relief bake`: whole sets of one run, whatever becomes of the process, and nobody
//! else's files.

use std::collections::BTreeMap;
use std::path::Path;
#[cfg(unix)]
use std::process::Command;
use std::process::Stdio;
use std::time::{Duration, Instant};

use crate::common::command::{Folder, Ran};
use crate::common::maps::Map;
use relief_io::file_set::FileSet;
use serde_json::{Value, json};

fn hills(folder: &Folder, side: u32) {
    let map = Map::new(side, side, |x, y| ((x * 700 + y * 1100 + (x * y) % 11 * 2000) % 65_536) as u16);
    folder.write("map.png", map.png());
}

fn map_folder(side: u32) -> Folder {
    let folder = Folder::new();
    hills(&folder, side);
    folder
}

/// Names and contents of the files of `out`, hidden ones, too.
fn files(folder: &Folder) -> BTreeMap<String, Vec<u8>> {
    let Ok(entries) = std::fs::read_dir(folder.path("out")) else { return BTreeMap::new() };
    let paths = entries.map(|entry| entry.expect("readable").path());
    let name = |path: &Path| path.file_name().expect("a name").to_string_lossy().into_owned();
    paths.map(|path| (name(&path), std::fs::read(&path).unwrap_or_default())).collect()
}

fn names(folder: &Folder) -> Vec<String> {
    files(folder).into_keys().collect()
}

fn line(flags: &str) -> String {
    format!("bake map.png -o out {flags}")
}

fn bake(folder: &Folder, flags: &str) -> Value {
    let ran = folder.relief(&line(&format!("--json {flags}"))).fine();
    serde_json::from_str(&ran.stdout).expect("JSON")
}

fn up_to_date(folder: &Folder, flags: &str) -> bool {
    let said = bake(folder, flags);
    said["baked"].as_array().expect("a list").iter().all(|baked| baked["up_to_date"] == json!(true))
}

#[test]
fn a_manifest_lists_what_is_whole() {
    let folder = map_folder(24);
    let flags = "--kind normal,frustum --set normal.mips=0 --format ktx2";
    bake(&folder, flags);
    let expected =
        ["map.frustum.slopes.ktx2", "map.frustum.top.ktx2", "map.normal.ktx2", "map.relief-manifest"];
    assert_eq!(names(&folder), expected);
    let whole = files(&folder);
    let manifest = String::from_utf8(whole["map.relief-manifest"].clone()).expect("text");
    assert!(expected[..3].iter().all(|name| manifest.contains(name)), "{manifest}");
    assert!(up_to_date(&folder, flags) && up_to_date(&folder, "--kind frustum --format ktx2"));
    // Cut, changed or gone, a file is baked again, and is what it was.
    for name in &expected[..3] {
        let bytes = &whole[*name];
        let mut flipped = bytes.clone();
        flipped[bytes.len() / 2] ^= 1;
        for damaged in [&bytes[..bytes.len() / 2], &bytes[..0], &flipped] {
            folder.write(&format!("out/{name}"), damaged);
            assert!(!up_to_date(&folder, flags), "{name}");
            assert_eq!(files(&folder), whole, "{name}");
        }
        std::fs::remove_file(folder.path("out").join(name)).expect("it is there");
        assert!(!up_to_date(&folder, flags), "{name}");
        assert_eq!(files(&folder), whole, "{name}");
    }
    // A damaged or missing manifest counts as empty, and is written again.
    for manifest in [&manifest.as_bytes()[..manifest.len() / 2], manifest.replace("file", "fill").as_bytes()]
    {
        folder.write("out/map.relief-manifest", manifest);
        assert!(!up_to_date(&folder, flags));
        assert_eq!(files(&folder), whole);
    }
    std::fs::remove_file(folder.path("out/map.relief-manifest")).expect("it is there");
    assert!(!up_to_date(&folder, flags) && up_to_date(&folder, flags));
    assert_eq!(files(&folder), whole);
}

#[test]
fn files_that_the_new_bake_does_not_have_go_unless_they_were_changed() {
    let folder = map_folder(64);
    let flags = "--kind pyramid --format png";
    bake(&folder, flags);
    let large = names(&folder);
    hills(&folder, 8);
    let small = {
        let other = map_folder(8);
        bake(&other, flags);
        names(&other)
    };
    assert!(large.len() >= small.len() + 3, "{large:?} {small:?}");
    // Another program's file with a name of ours, and a former file of ours.
    folder.write("out/map.pyramid.level99.png", "mine");
    let changed = large.iter().find(|name| !small.contains(name)).expect("it has fewer levels").clone();
    folder.write(&format!("out/{changed}"), "changed");
    let ran = folder.relief(&line(flags));
    assert!(ran.code == Some(0) && ran.stderr.contains(&changed), "{ran:?}");
    let mut expected = small.clone();
    expected.extend([changed.clone(), "map.pyramid.level99.png".to_owned()]);
    expected.sort();
    assert_eq!(names(&folder), expected);
    assert_eq!(files(&folder)[&changed], b"changed");
    // The JSON lists the file, too. Other kinds and formats stay.
    let folder = map_folder(64);
    bake(&folder, flags);
    bake(&folder, "--kind normal");
    hills(&folder, 8);
    folder.write(&format!("out/{changed}"), "changed");
    assert_eq!(bake(&folder, flags)["kept"], json!([changed]));
    assert!(names(&folder).iter().any(|name| name.starts_with("map.normal.")));
}

#[test]
fn files_of_other_programs_are_not_replaced_without_force() {
    let folder = map_folder(16);
    folder.write("out/map.normal.ktx2", "mine");
    let flags = "--kind normal,occlusion --set normal.mips=0 --format ktx2";
    let refused = folder.relief(&line(flags));
    assert_eq!(refused.code, Some(1), "{refused:?}");
    assert!(refused.stderr.contains("map.normal.ktx2") && refused.stderr.contains("--force"), "{refused:?}");
    assert_eq!(files(&folder), BTreeMap::from([("map.normal.ktx2".to_owned(), b"mine".to_vec())]));
    bake(&folder, &format!("{flags} --force"));
    assert_eq!(names(&folder), ["map.normal.ktx2", "map.occlusion.ktx2", "map.relief-manifest"]);
    assert!(up_to_date(&folder, flags));
    let whole = files(&folder);
    // Without a manifest the files' metadata identify them.
    std::fs::remove_file(folder.path("out/map.relief-manifest")).expect("it is there");
    assert!(!up_to_date(&folder, flags));
    assert_eq!(files(&folder), whole);
    folder.write("out/map.relief-manifest", "mine");
    let refused = folder.relief(&line(flags));
    assert!(refused.code == Some(1) && refused.stderr.contains("map.relief-manifest"), "{refused:?}");
    bake(&folder, &format!("{flags} --force"));
    assert_eq!(files(&folder), whole);
}

#[cfg(unix)]
#[test]
fn links_stay_and_inputs_are_no_outputs() {
    use std::os::unix::fs::symlink;

    let folder = map_folder(16);
    bake(&folder, "--kind normal,occlusion");
    let whole = files(&folder);
    std::fs::remove_dir_all(folder.path("out")).expect("it is there");
    std::fs::create_dir_all(folder.path("elsewhere")).expect("writable");
    std::fs::create_dir_all(folder.path("out")).expect("writable");
    symlink("../elsewhere/n", folder.path("out/map.normal.png")).expect("writable");
    symlink("o", folder.path("out/map.occlusion.png")).expect("writable");
    let flags = "--kind normal,occlusion";
    for _ in 0..2 {
        bake(&folder, &format!("{flags} --force"));
        assert!(up_to_date(&folder, flags));
        for (link, to) in [("normal", "../elsewhere/n"), ("occlusion", "o")] {
            let link = folder.path(format!("out/map.{link}.png"));
            assert_eq!(std::fs::read_link(link).expect("a link"), Path::new(to));
        }
        let mut found = files(&folder);
        assert_eq!(found.remove("o").as_ref(), Some(&whole["map.occlusion.png"]));
        assert_eq!(found, whole);
        assert_eq!(std::fs::read_dir(folder.path("elsewhere")).expect("a folder").count(), 1);
    }
    for second in [false, true] {
        let folder = map_folder(16);
        let before = std::fs::read(folder.path("map.png")).expect("the map");
        std::fs::create_dir(folder.path("out")).expect("writable");
        let output = folder.path("out/map.normal.png");
        if second {
            std::fs::hard_link(folder.path("map.png"), output)
        } else {
            symlink("../map.png", output)
        }
        .expect("writable");
        for force in ["", "--force"] {
            let refused = folder.relief(&line(&format!("--kind normal {force}")));
            assert!(refused.code == Some(2) && refused.stderr.contains("map.png"), "{refused:?}");
            assert_eq!(names(&folder), ["map.normal.png"]);
        }
        assert_eq!(std::fs::read(folder.path("map.png")).expect("the map"), before);
    }
}

#[test]
fn what_cannot_be_written_is_said_before_the_work() {
    // The bake of this volume would take a minute, and then go into no PNG.
    let folder = map_folder(700);
    let refusals = [
        ("--kind distance --set distance.slices=2048 --format png", "ktx2"),
        ("--kind distance --set distance.slices=2048 --format ktx2 --texels bc", "bc"),
        ("--kind relaxed-cone,distance --format ktx2 --texels bc", "bc"),
        ("--kind view-dependent --set view-dependent.rank=4 --format ktx2 --texels bc", "scales"),
        ("--kind normal,distance --set distance.slices=2048 --format png", "ktx2"),
        ("--kind cone --max-memory 5MiB", "--max-memory"),
    ];
    for (flags, word) in refusals {
        let started = Instant::now();
        let refused = folder.relief(&line(flags));
        assert!(refused.code == Some(1) && refused.stderr.contains(word), "{refused:?}");
        assert!(!folder.path("out").exists(), "{flags}");
        println!("{flags}: refused in {:?}", started.elapsed());
    }
    folder.write("file", "a file");
    for output in ["file", "file/below"] {
        let refused = folder.relief(&format!("bake map.png --kind normal -o {output}"));
        assert!(refused.code == Some(1) && refused.stderr.contains("file"), "{refused:?}");
    }
    folder.write("out/map.normal.png/inside", "");
    let refused = folder.relief(&line("--kind normal"));
    assert!(refused.code == Some(1) && refused.stderr.contains("it is a folder"), "{refused:?}");
    hills(&folder, 8);
    folder.relief("bake map.png --kind occlusion -o not/there/yet").fine();
    assert!(folder.path("not/there/yet/map.occlusion.png").exists());
}

#[cfg(target_os = "linux")]
#[test]
fn memory_that_the_system_refuses_is_an_error() {
    let folder = map_folder(700);
    let line = line("--kind normal");
    let mut refused = 0;
    for mebibytes in (16..400).step_by(4) {
        let script = format!("ulimit -v {}; exec {} {line}", mebibytes * 1024, env!("CARGO_BIN_EXE_relief"));
        let mut shell = Command::new("sh");
        shell.args(["-c", &script]).current_dir(folder.path("")).env("RAYON_NUM_THREADS", "1");
        let ran = Ran::new(&line, &shell.output().expect("a shell"));
        if ran.code == Some(0) {
            break;
        }
        let is_refused = ran.code == Some(1) && ran.stderr.contains("memory, which the system refuses");
        // With less the program itself has no room; with more, nothing else stops it.
        assert!(is_refused || refused == 0, "{mebibytes} MiB: {ran:?}");
        assert!(!folder.path("out").exists());
        refused += usize::from(is_refused);
    }
    assert!(refused >= 3, "{refused}");
}

#[cfg(unix)]
fn signal(name: &str, pid: u32) {
    let sent = Command::new("kill").args([name, &pid.to_string()]).stderr(Stdio::null()).status();
    sent.expect("kill is there");
}

/// The flags of two bakes of several files each, so that they have no byte in common.
const SETS: [&str; 2] = [
    "--kind pyramid,normal,dilation-erosion --set normal.mips=1 --format png --scale 0.1",
    "--kind pyramid,normal,dilation-erosion --set normal.mips=1 --format png --scale 0.3 --wrap clamp",
];

/// Returns the files of both bakes, and the time of the second.
fn two_sets(folder: &Folder) -> ([BTreeMap<String, Vec<u8>>; 2], Duration) {
    let mut took = Duration::ZERO;
    let sets = SETS.map(|flags| {
        let started = Instant::now();
        bake(folder, flags);
        took = started.elapsed();
        files(folder)
    });
    assert!(sets[0].keys().eq(sets[1].keys()) && sets[0].len() > 10, "{:?}", sets[0].keys());
    (sets, took)
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_the_old_files_or_the_new_ones_and_says_which() {
    let folder = map_folder(96);
    let (sets, took) = two_sets(&folder);
    let mut state = 1u32;
    let mut cancelled = 0;
    for round in 0..20 {
        let before = files(&folder);
        let mut command = folder.command();
        command.args(line(SETS[round % 2]).split_ascii_whitespace());
        let run = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the command starts");
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        std::thread::sleep(took.mul_f64(1.1 * f64::from(state) / f64::from(u32::MAX)));
        signal(["-INT", "-TERM"][round / 2 % 2], run.id());
        let ran = Ran::new(SETS[round % 2], &run.wait_with_output().expect("it ends"));
        let left = files(&folder);
        match ran.code {
            Some(0) => assert!(left == sets[round % 2], "round {round}: {:?}", left.keys()),
            Some(1) => {
                assert!(ran.stderr.contains("cancelled: no file was written"), "{ran:?}");
                assert!(ran.stdout.is_empty(), "{ran:?}");
                cancelled += 1;
            }
            // The signal came before there was anything to clean up.
            code => assert_eq!(code, None, "{ran:?}"),
        }
        assert!(ran.code == Some(0) || left == before, "round {round}: {:?}", left.keys());
    }
    // On a busy machine most signals come before the first byte is read, or after the end.
    assert!(cancelled > 0);
}

#[test]
fn killed_processes_leave_whole_sets_and_nothing_over() {
    let folder = map_folder(96);
    let (sets, took) = two_sets(&folder);
    let others = |mut files: BTreeMap<String, Vec<u8>>| {
        files.retain(|name, _| name != "map.occlusion.png" && name != "map.relief-manifest");
        files
    };
    let sets = sets.map(others);
    let mut state = 1u32;
    for round in 0..20 {
        let mut command = folder.command();
        command.args(line(SETS[round % 2]).split_ascii_whitespace());
        let run = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn();
        let mut run = run.expect("the command starts");
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        std::thread::sleep(took.mul_f64(1.1 * f64::from(state) / f64::from(u32::MAX)));
        run.kill().expect("it is ours");
        run.wait().expect("it ends");
        bake(&folder, "--kind occlusion");
        let left = others(files(&folder));
        assert!(sets.contains(&left), "round {round}: {:?}", left.keys());
    }
    bake(&folder, SETS[0]);
    assert_eq!(others(files(&folder)), sets[0]);
    assert!(up_to_date(&folder, SETS[0]));
}

#[test]
fn processes_with_different_settings_leave_the_set_of_one() {
    let folder = map_folder(48);
    let (sets, _) = two_sets(&folder);
    for round in 0..8 {
        let runs = [0, 1, 0].map(|which| {
            let mut command = folder.command();
            command.args(line(SETS[which]).split_ascii_whitespace());
            if round % 2 == 0 {
                command.arg("--force");
            }
            command.stdout(Stdio::null()).stderr(Stdio::piped()).spawn().expect("the command starts")
        });
        for run in runs {
            let ran = Ran::new("bake", &run.wait_with_output().expect("it ends"));
            assert_eq!(ran.code, Some(0), "{ran:?}");
        }
        let left = files(&folder);
        assert!(sets.contains(&left), "round {round}: {:?}", left.keys());
    }
}

#[cfg(unix)]
#[test]
fn who_waits_for_another_process_says_so_and_can_be_interrupted() {
    let folder = map_folder(16);
    let start = || {
        let mut command = folder.command();
        command.args(line("--kind normal").split_ascii_whitespace());
        command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the command starts")
    };
    let set = FileSet::open(&folder.path("out"), "map", &mut |_| false).expect("nobody holds it");
    let (interrupted, patient) = (start(), start());
    std::thread::sleep(Duration::from_millis(2500));
    signal("-INT", interrupted.id());
    let ran = Ran::new("bake", &interrupted.wait_with_output().expect("it ends"));
    assert!(ran.code == Some(1) && ran.stderr.contains("cancelled"), "{ran:?}");
    drop(set);
    let ran = Ran::new("bake", &patient.wait_with_output().expect("it ends"));
    assert!(ran.code == Some(0) && ran.stderr.starts_with("note: another process"), "{ran:?}");
    assert!(names(&folder).contains(&"map.relief-manifest".to_owned()));
}
