//! Pictures to keep: formats, colours, cameras and lights by flags.

use std::fs;
use std::io::BufReader;
use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use crate::common::aov::Aov;
use crate::common::command::{Folder, Ran};
use crate::common::maps::Map;
use relief_io::{linear_to_srgb, read_picture};

/// A map with something to see on it.
fn map_folder() -> Folder {
    let folder = Folder::new();
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/cobbles.png");
    fs::copy(shipped, folder.path("map.png")).expect("the shipped map");
    folder
}

const SMALL: &str = "render --height map.png --backend cpu --size 60x40";

/// The linear pixels of a picture's file.
fn pixels(folder: &Folder, name: &str) -> Vec<[f32; 4]> {
    read_picture(&folder.path(name), 1 << 26).expect("a picture").texels
}

fn worst(a: &[[f32; 4]], b: &[[f32; 4]]) -> f32 {
    assert_eq!(a.len(), b.len());
    let encoded = |light: f32| linear_to_srgb(f64::from(light.clamp(0.0, 1.0))) as f32;
    let pairs = a.iter().zip(b).flat_map(|(a, b)| (0..3).map(|at| (encoded(a[at]) - encoded(b[at])).abs()));
    pairs.fold(0.0, f32::max)
}

#[test]
fn every_format_holds_the_same_picture_and_states_its_colours() {
    let folder = map_folder();
    for (name, flags) in [("a.png", ""), ("b.png", "--bits 16"), ("c.exr", ""), ("d.jpg", ""), ("e.JPEG", "")]
    {
        folder.relief(&format!("{SMALL} -o {name} --tone none {flags}")).fine();
    }
    let [a, b, c, d, e] = ["a.png", "b.png", "c.exr", "d.jpg", "e.JPEG"].map(|name| pixels(&folder, name));
    assert!(worst(&b, &c) < 1.0 / 65535.0, "{}", worst(&b, &c));
    assert!(worst(&a, &c) < 0.51 / 255.0, "{}", worst(&a, &c));
    assert!(worst(&d, &c) < 0.15 && d == e, "{}", worst(&d, &c));
    for (name, depth) in [("a.png", png::BitDepth::Eight), ("b.png", png::BitDepth::Sixteen)] {
        let file = fs::File::open(folder.path(name)).expect("it was written");
        let reader = png::Decoder::new(BufReader::new(file)).read_info().expect("a PNG");
        assert_eq!(reader.output_color_type(), (png::ColorType::Rgb, depth));
        assert!(reader.info().srgb.is_some(), "{name}");
    }
    // No tone curve is in an EXR, whatever the look has.
    folder.relief(&format!("{SMALL} -o look.exr")).fine();
    assert_eq!(pixels(&folder, "look.exr"), c);
    // Light above 1 stays in an EXR.
    folder.relief(&format!("{SMALL} -o bright.exr --exposure 4")).fine();
    let bright = pixels(&folder, "bright.exr");
    assert!(bright.iter().any(|pixel| pixel[0] > 2.0));
    let covered = c.iter().zip(&bright).filter(|(_, b)| b[0] > 0.4);
    assert!(covered.clone().count() > 500);
    assert!(covered.filter(|(a, b)| (a[0] * 16.0 - b[0]).abs() < 1e-4 * b[0]).count() > 500);
}

#[test]
fn edges_are_drawn_over_pictures_and_not_over_numbers() {
    let folder = map_folder();
    let small = format!("{SMALL} --mesh torus --exposure 5");
    for name in ["png", "exr"] {
        folder.relief(&format!("{small} -o plain.{name} --aov plain-aov.exr")).fine();
        folder.relief(&format!("{small} -o wire.{name} --aov wire-aov.exr --wire")).fine();
        let [plain, wire] = ["plain", "wire"].map(|file| pixels(&folder, &format!("{file}.{name}")));
        let changed = plain.iter().zip(&wire).filter(|(plain, wire)| plain != wire).count();
        assert!(changed > 300, "{name}: {changed}");
        let [plain, wire] = ["plain-aov.exr", "wire-aov.exr"].map(|name| Aov::read(&folder.path(name)));
        assert!(plain.names() == wire.names() && plain.names().len() > 10);
        assert!(plain.names().iter().all(|name| plain.plane(name) == wire.plane(name)), "{name}");
    }
    // Lines are seen in an sRGB picture even where it is too bright.
    let red = pixels(&folder, "wire.png").into_iter().filter(|[r, _, b, _]| *r > 0.9 && *b < 0.3);
    assert!(red.count() > 50);
}

#[test]
fn tone_and_exposure_change_light_and_not_the_background() {
    let folder = map_folder();
    let flags = "--background 0.2,0.4,0.6 --view top --projection orthographic";
    folder.relief(&format!("{SMALL} -o plain.png {flags}")).fine();
    folder.relief(&format!("{SMALL} -o toned.png {flags} --tone agx --exposure 3")).fine();
    let [plain, toned] = ["plain.png", "toned.png"].map(|name| pixels(&folder, name));
    assert_eq!((plain[0], plain[0][2] > plain[0][0]), (toned[0], true));
    let middle = 20 * 60 + 30;
    assert!(toned[middle][0] > plain[middle][0] && toned.iter().all(|pixel| pixel[0] < 0.99));
}

#[test]
fn flags_say_what_scene_files_say() {
    let folder = map_folder();
    folder.write(
        "scene.toml",
        "height = 'map.png'\nbackend = 'cpu'\nsize = [60, 40]\nsamples = 2\nexposure = 0.5\ntone = 'agx'\n\
         view = 'front'\nfov = 25\nbackground = [0.1, 0.2, 0.3]\nambient = [0.2, 0.1, 0.1]\n\
         material = { diffuse = [0.5, 0.4, 0.3], shininess = 9 }\nlights = [{ direction = [1, 2, 3] }, \
         { position = [0, 1, 0], color = [0.5, 0.25, 1] }]\nmesh = 'torus'\n",
    );
    folder.relief("render scene.toml -o a.png").fine();
    let flags = "--samples 2 --exposure 0.5 --tone agx --view front --fov 25 --background 0.1,0.2,0.3 \
         --ambient 0.2,0.1,0.1 --material diffuse=0.5,0.4,0.3 --material shininess=9 --light 1,2,3 \
         --point-light 0,1,0,0.5,0.25,1 --mesh torus";
    folder.relief(&format!("{SMALL} -o b.png {flags}")).fine();
    let read = |name: &str| fs::read(folder.path(name)).expect("it was written");
    assert!(read("a.png") == read("b.png"));
    // Each of them counts.
    for over in ["--samples 3", "--exposure 1", "--tone none", "--view right", "--fov 30", "--ambient 0,0,0"]
    {
        folder.relief(&format!("render scene.toml -o c.png {over}")).fine();
        assert!(read("a.png") != read("c.png"), "{over}");
    }
}

#[test]
fn surroundings_of_a_file_are_seen_through_the_surface() {
    let folder = map_folder();
    // Red on the right, along x, and green on the left; below white.
    let texel = |x: u32, y: u32| match (y < 40, x < 64) {
        (true, true) => image::Rgb([0, 255, 0]),
        (true, false) => image::Rgb([255, 0, 0]),
        (false, _) => image::Rgb([255, 255, 255]),
    };
    image::RgbImage::from_fn(128, 64, texel).save(folder.path("around.png")).expect("writable");
    folder.write(
        "scenes/glass.toml",
        "height = '../map.png'\nenvironment = '../around.png'\ntransmission = 1\n",
    );
    let flags = "--shadow none --material specular=0,0,0 --background 0,0,0 --samples 1 --view top";
    for (name, line) in [
        ("glass.exr", "--height map.png --environment around.png --transmission 1"),
        ("scene.exr", "scenes/glass.toml"),
        ("stone.exr", "--height map.png --environment around.png"),
        ("sky.exr", "--height map.png --transmission 1"),
    ] {
        folder.relief(&format!("render {line} --backend cpu --size 60x40 -o {name} {flags}")).fine();
    }
    let [glass, scene, stone, sky] =
        ["glass.exr", "scene.exr", "stone.exr", "sky.exr"].map(|name| pixels(&folder, name));
    assert!(glass == scene && glass != stone && glass != sky);
    // From above white is seen through the cobbles, but where they stand steep.
    let covered: Vec<_> = glass.iter().filter(|pixel| pixel[1] > 0.0).collect();
    let white = covered.iter().filter(|pixel| pixel[..3].iter().all(|part| *part > 0.9)).count();
    assert!(covered.len() > 500 && white > covered.len() * 9 / 10, "{white} of {}", covered.len());
    // Stones that lean to the right are lit by red, others by green.
    let [red, green] =
        [0, 1].map(|part| stone.iter().filter(|pixel| pixel[part] > 1.1 * pixel[1 - part]).count());
    assert!(red > 100 && green > 100, "{red}, {green}");
}

#[test]
fn what_cannot_be_pictured_is_refused() {
    let folder = map_folder();
    let refused = [
        ("-o a.exr --tone agx", "linear"),
        ("-o a.jpg --bits 16", "--bits"),
        ("-o a.png --bits 12", "8 or 16"),
        ("-o a.gif", "png"),
        ("-o a.png --aov a.png", "exr"),
        ("-o a.exr --aov a.exr", "same file"),
        ("-o a.png --samples 0", "samples"),
        ("-o a.png --samples 1025", "1024"),
        ("-o a.png --exposure 99", "stops"),
        ("-o a.png --exposure nan", "exposure"),
        ("-o a.png --view top --eye 1,1,1", "--eye"),
        ("-o a.png --view tpo", "top"),
        ("-o a.png --projection orthographic --fov 30", "fov"),
        ("-o a.png --projection orthographic --eye 1,1,1", "view-height"),
        ("-o a.png --projection orthographic --eye 1,1,1 --view-height 0", "view"),
        ("-o a.png --view-height 2", "orthographic"),
        ("-o a.png --material diffuse=2,0,0", "diffuse"),
        ("-o a.png --material colour=1,1,1", "diffuse"),
        ("-o a.png --point-light 1,2", "X,Y,Z"),
        ("-o a.png --point-light 1,2,3,-1,0,0", "negative"),
        ("-o a.png --background 1,1,-1", "background"),
        ("-o a.png --fov 180", "180"),
    ];
    for (flags, word) in refused {
        let ran = folder.relief(&format!("{SMALL} {flags}"));
        assert!(ran.code == Some(2) && ran.stderr.contains(word), "{flags}: {ran:?}");
    }
    let names: Vec<_> = fs::read_dir(folder.path("")).expect("a folder").flatten().collect();
    assert_eq!(names.len(), 1, "{names:?}");
}

#[cfg(unix)]
#[test]
fn a_picture_that_is_given_up_leaves_nothing() {
    let folder = map_folder();
    fs::write(folder.path("x.png"), "before").expect("writable");
    let line = "render --height map.png --look plain --backend cpu --size 1500x1500 --samples 64 --method \
         relief -o x.png --aov x.exr";
    for (signal, code) in [("-INT", Some(1)), ("-TERM", Some(1)), ("-KILL", None)] {
        let mut command = folder.command();
        command.args(line.split_ascii_whitespace());
        let run = command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("the command starts");
        std::thread::sleep(Duration::from_millis(1200));
        let sent = Command::new("kill").args([signal, &run.id().to_string()]).status();
        assert!(sent.expect("kill is there").success());
        let ran = Ran::new(line, &run.wait_with_output().expect("it ends"));
        assert_eq!(ran.code, code, "{ran:?}");
        assert!(code.is_none() || ran.stderr.contains("cancelled"), "{ran:?}");
        assert_eq!(fs::read(folder.path("x.png")).expect("it stays"), b"before");
        assert!(!folder.path("x.exr").exists());
    }
    // The next run removes what the killed one left.
    folder.relief(&format!("{SMALL} --look plain -o x.png")).fine();
    let mut names: Vec<_> = fs::read_dir(folder.path("")).expect("a folder").flatten().collect();
    names.retain(|entry| entry.file_name() != "map.png" && entry.file_name() != "x.png");
    assert!(names.is_empty(), "{names:?}");
}

#[test]
fn a_map_of_one_colour_is_still_seen_from_every_side() {
    let folder = Folder::new();
    folder.write("map.png", Map::constant(0.5).png());
    for view in ["corner", "top", "front", "right"] {
        for projection in ["perspective", "orthographic"] {
            let flags = format!("--view {view} --projection {projection} --mesh cube");
            let ran = folder.relief(&format!("{SMALL} -o a.png --json {flags}")).fine();
            let about: serde_json::Value = serde_json::from_str(&ran.stdout).expect("JSON");
            assert!(about["covered"].as_u64() > Some(600), "{flags}: {}", about["covered"]);
        }
    }
}
