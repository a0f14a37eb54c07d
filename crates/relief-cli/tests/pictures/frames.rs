//! `relief render --frames`: each picture is the same as if rendered alone, and refusals come
//! before anything is written.

use std::fs;

use crate::common::command::{Folder, json_of};
use crate::common::maps::Map;
use crate::common::refused::{assert_refused, entries, with_out};

const SMALL: &str = "--backend cpu --size 48x36 --samples 2";

/// Returns a map of waves that move from frame to frame.
fn wave(frame: u32) -> Vec<u8> {
    let map = Map::new(24, 16, |x, y| {
        let turn = std::f64::consts::TAU * (f64::from(x) / 24.0 + f64::from(frame) / 8.0);
        ((0.5 + 0.3 * turn.sin() + 0.1 * f64::from(y % 5) / 5.0) * 65535.0) as u16
    });
    map.png()
}

/// A folder of five frames.
fn map_folder() -> Folder {
    let folder = with_out();
    for frame in 8..=12 {
        folder.write(&format!("wave_{frame:03}.png"), wave(frame));
        let shade = 40 + 15 * (frame as u8);
        let colour: Vec<u8> = [shade, 200, 255 - shade].repeat(4);
        let name = folder.path(format!("c{frame}.png"));
        relief_io::write_png8(&name, 2, 2, relief_io::PngColour::Rgb, &colour).expect("writable");
    }
    folder
}

fn bytes(folder: &Folder, name: &str) -> Vec<u8> {
    fs::read(folder.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn sorted(folder: &Folder) -> Vec<String> {
    let mut names = entries(&folder.path("out"));
    names.sort();
    names
}

#[test]
fn frames_are_the_pictures_of_their_own_files() {
    let folder = map_folder();
    // The camera is fitted, the scene has a folder of its own, and one of its surfaces is the same
    // in all frames.
    let scene = |height: &str, color: &str| {
        format!(
            "[[surfaces]]\nheight = '{height}'\ncolor = '{color}'\nmethod = 'cone'\n\
             [[surfaces]]\nheight = '../wave_008.png'\nmesh = 'sphere'\n\
             position = [0.2, 0.1, 0]\nsize = 0.3\n"
        )
    };
    folder.write("100%d%/s.toml", scene("../wave_%03d.png", "../c%d.png"));
    let line = "--aov out/a%02d.exr -o out/p%02d.png";
    let ran = folder.relief(&format!("render 100%d%/s.toml {SMALL} --frames 8..12 {line}")).fine();
    let names: Vec<&str> = ran.stdout.lines().filter_map(|line| line.split(':').next()).collect();
    for frame in 8..=12 {
        assert_eq!(names.iter().filter(|name| **name == format!("out/p{frame:02}.png")).count(), 1);
    }
    for frame in 8..=12 {
        folder
            .write("100%d%/one.toml", scene(&format!("../wave_{frame:03}.png"), &format!("../c{frame}.png")));
        folder.relief(&format!("render 100%d%/one.toml {SMALL} --aov one.exr -o one.png")).fine();
        assert!(bytes(&folder, &format!("out/p{frame:02}.png")) == bytes(&folder, "one.png"), "{frame}");
        assert!(bytes(&folder, &format!("out/a{frame:02}.exr")) == bytes(&folder, "one.exr"), "{frame}");
    }
    assert_eq!(sorted(&folder).len(), 10);
    assert!(bytes(&folder, "out/p08.png") != bytes(&folder, "out/p09.png"));
}

/// A GPU's renderer is used for all frames.
#[test]
fn frames_of_a_gpu_are_the_pictures_of_their_own_files() {
    let folder = map_folder();
    let line = "--size 48x36 --samples 1 --backend gpu";
    let ran = folder.relief(&format!(
        "render --height wave_%03d.png --color c%d.png --frames 8..10 {line} -o out/%d.png"
    ));
    if ran.code == Some(1) && std::env::var_os("RELIEF_REQUIRE_GPU").is_none_or(|value| value != "1") {
        println!("skipped: there is no GPU");
        return;
    }
    ran.fine();
    for frame in 8..=10 {
        let one = format!("render --height wave_{frame:03}.png --color c{frame}.png {line} -o one.png");
        folder.relief(&one).fine();
        assert!(bytes(&folder, &format!("out/{frame}.png")) == bytes(&folder, "one.png"), "{frame}");
    }
}

#[test]
fn objects_move() {
    let folder = map_folder();
    for (frame, mesh) in [(0, "cube"), (1, "torus"), (2, "sphere")] {
        folder.relief(&format!("capture {mesh} --size 32 --verify 1 -q -o walk/{frame:04}")).fine();
    }
    let line = format!("render --object walk/%04d/object.toml {SMALL} --frames 0..2");
    let about = json_of(&folder.relief(&format!("{line} --json -o out/%03d.png")).fine());
    let told = about["frames"].as_array().expect("a list");
    assert_eq!(told.len(), 3);
    for frame in 0..3u32 {
        folder.relief(&format!("render --object walk/{frame:04}/object.toml {SMALL} -o one.png")).fine();
        assert!(bytes(&folder, &format!("out/{frame:03}.png")) == bytes(&folder, "one.png"), "{frame}");
        let about = &told[frame as usize];
        assert_eq!((about["frame"].as_u64(), about["width"].as_u64()), (Some(u64::from(frame)), Some(48)));
        assert_eq!(about["output"], format!("out/{frame:03}.png"));
        assert!(about["covered"].as_u64() > Some(50), "{about}");
    }
    // The same by a scene file.
    folder.write("walk.toml", "object = 'walk/%04d/object.toml'\n");
    folder.relief(&format!("render walk.toml {SMALL} --frames 1..1 -o s%d.png")).fine();
    assert!(bytes(&folder, "s1.png") == bytes(&folder, "out/001.png"));
    // A picture of an object is a file that must be there, too.
    for name in sorted(&folder) {
        fs::remove_file(folder.path("out").join(name)).expect("it was there");
    }
    fs::remove_file(folder.path("walk/0002/depth.exr")).expect("it was there");
    let ran = folder.relief(&format!("{line} -o out/%03d.png"));
    assert_refused(&folder, &ran, 1, &["frame 2", "depth.exr"]);
}

#[test]
fn what_cannot_be_rendered_in_frames_is_refused_before_anything_is_written() {
    let folder = map_folder();
    fs::remove_file(folder.path("wave_011.png")).expect("it was there");
    folder.write("s.toml", "height = 'wave_%03d.png'\n");
    folder.write("still.toml", "height = 'wave_008.png'\n");
    folder.write("unused.toml", "height = 'no_%d.png'\n[[surfaces]]\nheight = 'wave_008.png'\n");
    folder.write("two.toml", "height = 'w%d_%03d.png'\n");
    let wave = "--height wave_%03d.png";
    for (line, code, words) in [
        // A frame is missing.
        (format!("{wave} --frames 8..12 -o out/%d.png"), 1, &["wave_011.png", "frame 11"][..]),
        ("s.toml --frames 8..12 -o out/%d.png".to_owned(), 1, &["wave_011.png", "frame 11"]),
        (format!("{wave} --color x%d.png --frames 8..9 -o out/%d.png"), 1, &["x8.png", "frame 8"]),
        (format!("{wave} --normal n.png --frames 8..9 -o out/%d.png"), 1, &["n.png", "frame 8"]),
        ("--object walk/%d/object.toml --frames 0..2 -o out/%d.png".to_owned(), 1, &["walk/0/object.toml"]),
        ("--height c8.png --mesh m%d.obj --frames 0..2 -o out/%d.png".to_owned(), 1, &["m0.obj"]),
        (format!("{wave} --frames 8..9 -o out/%d/a.png"), 1, &["out/8"]),
        // There are no frames, or no names for them.
        ("s.toml -o out/a.png".to_owned(), 2, &["wave_%03d.png", "--frames"]),
        (format!("{wave} -o out/a.png"), 2, &["wave_%03d.png", "--frames"]),
        ("still.toml -o out/a%d.png".to_owned(), 2, &["--output", "a%d.png", "--frames"]),
        ("still.toml --aov out/a%d.exr -o out/a.png".to_owned(), 2, &["--aov", "a%d.exr", "--frames"]),
        ("s.toml --frames 8..9 -o out/a.png".to_owned(), 2, &["--output", "out/a.png"]),
        ("s.toml --frames 8..9 -o out/a%%d.png".to_owned(), 2, &["--output", "out/a%%d.png"]),
        ("s.toml --frames 8..9 --aov out/a.exr -o out/%d.png".to_owned(), 2, &["--aov", "out/a.exr"]),
        ("s.toml --frames 8..9 -o - --format png".to_owned(), 2, &["--frames", "--output"]),
        ("still.toml --frames 8..9 -o out/%d.png".to_owned(), 2, &["--frames", "height_%04d.png"]),
        ("unused.toml --frames 8..9 -o out/%d.png".to_owned(), 2, &["--frames", "height_%04d.png"]),
        // Bad patterns.
        ("two.toml --frames 8..9 -o out/%d.png".to_owned(), 2, &["w%d_%03d.png", "more than one"]),
        ("two.toml -o out/a.png".to_owned(), 2, &["w%d_%03d.png", "--frames"]),
        ("s.toml --frames 8..9 -o out/%4d.png".to_owned(), 2, &["out/%4d.png", "%04d"]),
        ("s.toml --frames 8..9 -o out/%033d.png".to_owned(), 2, &["33"]),
        (format!("{wave} --color 50%.png --frames 8..9 -o out/%d.png"), 2, &["50%.png", "%%"]),
        // Bad ranges.
        ("s.toml --frames 9..8 -o out/%d.png".to_owned(), 2, &["--frames", "9 comes after 8"]),
        ("s.toml --frames -1..8 -o out/%d.png".to_owned(), 2, &["--frames", "from 0"]),
        ("s.toml --frames 0..1000000 -o out/%d.png".to_owned(), 2, &["1000001", "1000000"]),
        ("s.toml --frames 0..=7 -o out/%d.png".to_owned(), 2, &["A..B"]),
        // Inputs are not replaced.
        ("--height wave_%03d.png --frames 8..9 -o wave_%03d.png".to_owned(), 2, &["wave_008.png", "replace"]),
    ] {
        assert_refused(&folder, &folder.relief(&format!("render {line} {SMALL}")), code, words);
    }
}

#[test]
fn no_frame_replaces_what_another_one_reads_or_writes() {
    let folder = with_out();
    let maps = folder.path("maps");
    for frame in 0..=11 {
        folder.write(&format!("maps/v{frame}.png"), wave(frame));
    }
    for (line, words) in [
        // Frame 0 would replace an input of frame 10.
        ("--frames 0..11 -o maps/v1%d.png", &["v10.png", "frame 0 ", "frame 10 "][..]),
        ("--frames 1..11 -o out/../maps/v1%d.png", &["v11.png", "frame 1 ", "frame 11 "]),
        // An input of all frames.
        ("--color maps/v10.png --frames 0..1 -o maps/v1%d.png", &["v10.png", "replace"]),
        // The picture of frame 11 and the AOVs of frame 1.
        ("--frames 1..11 -o out/a%d.exr --aov ./out/a1%d.exr", &["a11.exr", "frame 1 ", "frame 11"]),
    ] {
        let ran = folder.relief(&format!("render --height maps/v%d.png {line} {SMALL}"));
        assert_refused(&folder, &ran, 2, words);
        assert_eq!(entries(&maps).len(), 12);
        assert!(bytes(&folder, "maps/v10.png") == wave(10) && bytes(&folder, "maps/v11.png") == wave(11));
    }
}

#[test]
fn a_percent_sign_that_is_no_pattern_is_one() {
    let folder = map_folder();
    folder.write("50%.png", wave(0));
    folder.write("%4d.png", wave(1));
    folder.write("%%d.png", wave(2));
    for name in ["50%.png", "%4d.png", "%%d.png"] {
        folder.relief(&format!("render --height {name} {SMALL} -o out/100%_{name}")).fine();
    }
    // With --frames the percent sign is written twice.
    folder
        .relief(&format!("render --height 50%%.png --color c%d.png {SMALL} --frames 8..8 -o out/%%%d.png"))
        .fine();
    assert!(folder.path("out/%8.png").exists());
}

#[test]
fn other_commands_say_that_they_show_no_frames() {
    let folder = map_folder();
    folder.write("s.toml", "height = 'wave_%03d.png'\n");
    for line in [
        "compare s.toml -o out/page.html",
        "bench --height wave_%03d.png",
        "capture s.toml --size 16 --verify 1 -o out/o",
    ] {
        assert_refused(&folder, &folder.relief(line), 2, &["wave_%03d.png", "render --frames"]);
    }
    // A scene file may have placeholders.
    folder.relief("scene --height wave_%03d.png -o made.toml").fine();
    folder.relief(&format!("render made.toml {SMALL} --frames 8..8 -o out/%d.png")).fine();
}

#[test]
fn a_frame_that_fails_leaves_those_before_it() {
    let folder = map_folder();
    folder.write("wave_010.png", "no picture");
    let ran = folder.relief(&format!("render --height wave_%03d.png {SMALL} --frames 8..12 -o out/%d.png"));
    assert_eq!(ran.code, Some(1), "{ran:?}");
    assert!(ran.stderr.contains("frame 10") && ran.stderr.contains("wave_010.png"), "{}", ran.stderr);
    assert_eq!(sorted(&folder), ["8.png", "9.png"]);
    for frame in [8, 9] {
        image::open(folder.path(format!("out/{frame}.png"))).expect("a whole picture");
    }
}

#[cfg(unix)]
#[test]
fn frames_that_are_given_up_are_whole() {
    use crate::common::command::Ran;
    use std::process::{Command, Stdio};
    use std::time::Duration;

    let folder = map_folder();
    let line = "render --height wave_%03d.png --backend cpu --size 900x900 --samples 64 --method relief \
         --frames 8..12 -o out/%d.png";
    let mut command = folder.command();
    command.args(line.split_ascii_whitespace());
    let run = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the command starts");
    // It ends when there is a whole picture.
    for _ in 0..600 {
        if folder.path("out/8.png").exists() {
            break;
        }
        std::thread::sleep(Duration::from_millis(50));
    }
    let sent = Command::new("kill").args(["-INT", &run.id().to_string()]).status();
    assert!(sent.expect("kill is there").success());
    let ran = Ran::new(line, &run.wait_with_output().expect("it ends"));
    assert_eq!(ran.code, Some(1), "{ran:?}");
    let names = sorted(&folder);
    assert!((1..5).contains(&names.len()), "{names:?}");
    assert!(ran.stderr.contains(&format!("{} of 5 frames", names.len())), "{ran:?}");
    for name in names {
        image::open(folder.path("out").join(&name)).unwrap_or_else(|error| panic!("{name}: {error}"));
    }
}
