//! `relief bake` as users run it, with every kind.

use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use relief_bake::KINDS;
use relief_io::{read_ktx2, read_metadata, write_png16};

fn command(arguments: &[&str], folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_relief"));
    command.arg("bake").args(arguments).current_dir(folder);
    command
}

fn run(arguments: &[&str], folder: &Path) -> Output {
    command(arguments, folder).output().expect("the command runs")
}

/// A folder with a map of hills and an empty folder `out`.
fn map_folder(side: u32) -> tempfile::TempDir {
    let room = tempfile::tempdir().expect("a temporary folder");
    let height = |at: u32| {
        let (u, v) = (at % side, at / side);
        ((f64::from(u) * 0.4).sin() * (f64::from(v) * 0.3).cos() * 30_000.0 + 32_000.0) as u16
    };
    let texels: Vec<u16> = (0..side * side).map(height).collect();
    write_png16(&room.path().join("map.png"), side, side, &texels).expect("the folder is writable");
    std::fs::create_dir(room.path().join("out")).expect("the folder is writable");
    room
}

fn files(room: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(room.join("out")).expect("the folder is there");
    let mut names: Vec<String> =
        entries.map(|entry| entry.expect("readable").file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn the_help_names_every_kind_and_setting() {
    let room = map_folder(4);
    let output = run(&["--help"], room.path());
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success() && text.contains("Kinds:"));
    for kind in KINDS {
        assert!(text.contains(kind.name), "{}", kind.name);
        for param in kind.params {
            assert!(text.contains(&format!("{}.{}=", kind.name, param.name)), "{}.{}", kind.name, param.name);
        }
    }
}

#[test]
fn wrong_command_lines_and_missing_maps_have_their_exit_codes() {
    let room = map_folder(4);
    let output = run(&["map.png", "--kind", "no such kind", "-o", "out"], room.path());
    assert_eq!(output.status.code(), Some(2));
    assert!(!output.stderr.is_empty() && output.stdout.is_empty());
    for kind in KINDS.iter().take(1) {
        let output = run(&["no such map.png", "--kind", kind.name, "-o", "out"], room.path());
        assert_eq!(output.status.code(), Some(1));
    }
    assert!(files(room.path()).is_empty());
}

#[test]
fn every_kind_is_baked_once_and_says_what_it_is() {
    let room = map_folder(16);
    for kind in KINDS.iter().filter(|kind| !kind.of_volume) {
        for format in ["exr", "ktx2"] {
            let line = ["map.png", "--kind", kind.name, "--format", format, "-o", "out", "--json"];
            let run = || -> serde_json::Value {
                let output = run(&line, room.path());
                let error = String::from_utf8_lossy(&output.stderr);
                assert!(output.status.success(), "{} {format}: {error}", kind.name);
                serde_json::from_slice(&output.stdout).expect("JSON")
            };
            let (first, second) = (run(), run());
            assert_eq!(first["baked"][0]["up_to_date"], false, "{}", kind.name);
            assert_eq!(second["baked"][0]["up_to_date"], true, "{}", kind.name);
            let names = first["baked"][0]["files"].as_array().expect("a list");
            assert!(!names.is_empty(), "{}", kind.name);
            for name in names {
                let path = room.path().join("out").join(name.as_str().expect("a name"));
                let metadata = read_metadata(&path).expect("a file with metadata");
                assert_eq!(metadata.get("relief.kind"), Some(kind.name));
                assert!(metadata.get("relief.ranges").is_some_and(|ranges| !ranges.is_empty()));
                if format == "ktx2" {
                    let file = read_ktx2(&path, 1 << 30).expect("a texture");
                    let values = || file.levels.iter().flat_map(|level| level.planes.iter().flatten());
                    assert!(values().all(|value| !value.is_nan()), "{}", kind.name);
                }
            }
        }
    }
}

#[test]
fn distances_are_baked_from_volumes_alone() {
    let room = map_folder(8);
    let fails = |line: &[&str], code: i32, words: &[&str]| {
        let output = run(line, room.path());
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(code), "{line:?}: {error}");
        assert!(words.iter().all(|word| error.contains(word)), "{line:?}: {error}");
    };
    fails(&["map.png", "--kind", "volume-distance", "-o", "out"], 2, &["relief volume", "slices"]);
    // A cube in the middle of the tile, of 16x12x8 voxels.
    let cube = |[u, v, h]: [f64; 3]| f64::from([u, v, h].iter().all(|part| (part - 0.5).abs() < 0.2));
    let volume =
        relief_core::Volume::from_fn([16, 12, 8], relief_core::Wrap::Repeat, cube).expect("a volume");
    let file = room.path().join("cube.ktx2");
    relief_io::write_volume(&file, &volume, &relief_io::VolumeFormat::default()).expect("a file");
    fails(&["cube.ktx2", "--kind", "normal", "-o", "out"], 2, &["volume", "normal"]);
    fails(&["cube.ktx2", "--kind", "volume-distance", "--depth", "-o", "out"], 2, &["--depth"]);
    let line = ["cube.ktx2", "--kind", "volume-distance", "--set", "volume-distance.bits=8"];
    let output = run(&[&line[..], &["--format", "ktx2", "-o", "out"]].concat(), room.path());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let baked = read_ktx2(&room.path().join("out/cube.volume-distance.ktx2"), 1 << 20).expect("a texture");
    let distance =
        relief_bake::volumes::volume_distance(&volume, 0.5, &relief_core::Watch::none()).expect("distances");
    let values = &baked.levels[0].planes[0];
    assert!(
        distance
            .texels()
            .iter()
            .zip(values)
            .all(|(cells, value)| (f32::from(*cells) / 255.0 - value).abs() < 1e-6)
    );
    assert!(distance.texels().iter().any(|cells| *cells > 2));
    // By direction, too: straight down from above the cube the way to it, beside it none.
    let few = ["--set", "generalised.azimuths=4", "--set", "generalised.elevations=2"];
    let line = ["cube.ktx2", "--kind", "generalised", "--format", "ktx2", "-o", "out"];
    let output = run(&[&line[..], &few].concat(), room.path());
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let baked = read_ktx2(&room.path().join("out/cube.generalised.ktx2"), 1 << 20).expect("a texture");
    let [x, y] = volume.layout().place(7);
    let [width, _] = volume.layout().atlas_size();
    let at = |column: u32, row: u32| baked.levels[0].planes[0][((y + row) * width + x + column) as usize];
    assert!((1.0..3.0).contains(&at(8, 6)) && at(0, 0) == 64.0, "{} {}", at(8, 6), at(0, 0));
    let many = ["--set", "generalised.azimuths=32", "--set", "generalised.elevations=32"];
    fails(&[&line[..], &many].concat(), 1, &["1024", "256"]);
    // The slices of a picture lie as its settings say; they must fit it.
    let wrong = ["map.png", "--kind", "volume-distance", "--set", "volume-distance.slices=3", "-o", "out"];
    fails(&wrong, 1, &["8x8x3"]);
}

/// Waits until the bake has begun to write, or has ended.
fn wait_for_work(child: &mut Child, room: &Path) {
    let started = Instant::now();
    while started.elapsed() < Duration::from_secs(60) {
        let ended = child.try_wait().expect("the command can be waited for").is_some();
        if ended || !files(room).is_empty() {
            return;
        }
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_no_file_or_whole_ones() {
    for kind in KINDS.iter().take(3) {
        let room = map_folder(600);
        let mut child = command(&["map.png", "--kind", kind.name, "-o", "out"], room.path())
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .expect("the command runs");
        wait_for_work(&mut child, room.path());
        let pid = child.id().to_string();
        let signalled = Command::new("kill").args(["-INT", &pid]).stderr(Stdio::null()).status();
        signalled.expect("kill is there");
        let status = child.wait().expect("the command ends");
        // Where the bake was faster than the signal, its files are whole; else there is none,
        // hidden or not.
        let left = files(room.path());
        match status.code() {
            Some(0) => {
                let is_manifest = |name: &str| name == "map.relief-manifest";
                let is_whole = |name: &str| read_metadata(&room.path().join("out").join(name)).is_ok();
                assert!(left.iter().all(|name| is_manifest(name) || is_whole(name)), "{left:?}");
            }
            code => assert_eq!((code, left.as_slice()), (Some(1), &[][..]), "{}", kind.name),
        }
    }
}
