//! Flags, scene files, what is printed, and exit codes.

use std::process::Stdio;

use crate::common::aov::Aov;
use crate::common::command::{Folder, Ran, json_of};
use crate::common::maps::{Map, encoded};
use image::{DynamicImage, ImageFormat, RgbaImage};
use relief_core::Lanes;
use relief_io::write_exr;
use serde_json::Value;

/// Flags of a small picture that looks straight at the map.
const SMALL: &str = "--backend cpu --size 12x10 --eye 0,1,0.01 --fov 30 -o a.png --aov a.exr";

/// Returns the single height of all covered pixels.
fn only_height(folder: &Folder) -> f64 {
    let aov = Aov::read(&folder.path("a.exr"));
    let heights: Vec<f64> = aov.pixels().filter(|(_, _, p)| p.hit == 1.0).map(|(_, _, p)| p.height).collect();
    assert!(heights.len() > 50, "{} pixels are covered", heights.len());
    assert!(heights.iter().all(|height| (height - heights[0]).abs() < 1e-4), "{heights:?}");
    heights[0]
}

fn assert_near(value: f64, expected: f64) {
    assert!((value - expected).abs() < 1e-4, "{value}, not {expected}");
}

#[test]
fn flags_override_the_scene_and_paths_start_where_they_are_written() {
    let folder = Folder::new();
    folder.write("map.png", Map::constant(1.0).png());
    folder.write("scenes/map.png", Map::constant(0.0).png());
    folder.write(
        "scenes/s.toml",
        "height = 'map.png'\nscale = 0.2\nsize = [20, 10]\neye = [0, 1, 0.01]\nfov = 30\nbackend = 'cpu'\n\
         search = 'linear'\nrefine = 'secant'\n[set]\nsearch.steps = 7\nrefine.steps = 3\n",
    );
    let from_scene = json_of(&folder.relief("render scenes/s.toml -o a.png --aov a.exr --json").fine());
    assert_eq!((&from_scene["width"], &from_scene["height"]), (&20.into(), &10.into()));
    let surface = &from_scene["surfaces"][0];
    assert_eq!((&surface["search"], &surface["refine"]), (&"linear".into(), &"secant".into()));
    assert_eq!(only_height(&folder), 0.0);
    let level = |folder: &Folder| Aov::read(&folder.path("a.exr")).pixel(6, 5).position.y;
    assert_near(level(&folder), -0.2);

    let over = "render scenes/s.toml -o a.png --aov a.exr --json --size 12x10 --height map.png --bias 0.1";
    let overridden = json_of(&folder.relief(over).fine());
    assert_eq!((&overridden["width"], &overridden["height"]), (&12.into(), &10.into()));
    assert_eq!(only_height(&folder), 1.0);
    assert_near(level(&folder), 0.3);
    // Without a bias a new scale carves again.
    folder.relief("render scenes/s.toml -o a.png --aov a.exr --scale 0.05 --size 12x10").fine();
    assert_near(level(&folder), -0.05);

    let named = |flags: &str| {
        let about = json_of(&folder.relief(&format!("render scenes/s.toml -o a.png --json {flags}")).fine());
        let name = |stage: &str| about["surfaces"][0][stage].as_str().expect("a name").to_owned();
        format!("{} {}", name("search"), name("refine"))
    };
    assert_eq!(named("--method exact"), "cells patch");
    assert_eq!(named("--search none"), "none secant");
    assert_eq!(named("--refine binary"), "linear binary");
}

#[test]
fn surfaces_of_a_scene_are_rendered_together_and_reported_each() {
    let folder = Folder::new();
    folder.write("map.png", Map::constant(1.0).png());
    let shared = "height = 'map.png'\neye = [0, 3, 0.01]\nsize = [24, 24]\nbackend = 'cpu'\n";
    let two =
        "[[surfaces]]\nposition = [-0.6, 0, 0]\n[[surfaces]]\nposition = [0.6, 0, 0]\nmethod = 'cone'\n";
    folder.write("one.toml", shared);
    folder.write("two.toml", format!("{shared}{two}"));
    let of = |line: &str| json_of(&folder.relief(&format!("render {line} -o a.png --json")).fine());
    let (one, both) = (of("one.toml"), of("two.toml"));
    let surfaces = both["surfaces"].as_array().expect("a list");
    let searches: Vec<&Value> = surfaces.iter().map(|surface| &surface["search"]).collect();
    assert_eq!(searches, [&Value::from("cells"), &Value::from("cone")]);
    let covered = |about: &Value| about["covered"].as_u64().expect("a number");
    assert!(covered(&both) > covered(&one) * 3 / 2, "{both}");
    // A flag applies to each surface.
    let over = of("two.toml --method relief");
    let surfaces = over["surfaces"].as_array().expect("a list");
    assert!(surfaces.iter().all(|surface| surface["search"] == "linear"), "{over}");
}

#[test]
fn settings_reach_the_method() {
    let folder = Folder::new();
    folder.write("map.png", Map::hills().png());
    let reads = |steps: u32| {
        let line =
            format!("render --height map.png {SMALL} --json --method steep --set search.steps={steps}");
        json_of(&folder.relief(&line).fine())["mean_reads"].as_f64().expect("a number")
    };
    assert!(reads(4) < reads(16) && reads(16) < reads(128));
}

#[test]
fn slices_are_told_by_names_and_too_many_are_refused_before_memory_is_taken() {
    let folder = Folder::new();
    folder.write("map.png", Map::hills().png());
    folder.write("s.toml", "height = 'map.png'\nmethod = 'slices-screen'\nset.slices.test = 'band'\n");
    folder.write("bad.toml", "height = 'map.png'\nmethod = 'slices-screen'\nset.slices.test = 'bond'\n");
    let picture = |flags: &str| {
        let about = json_of(&folder.relief(&format!("render {flags} {SMALL} --json")).fine());
        assert!(about["covered"].as_u64() > Some(50), "{flags}: {about}");
        std::fs::read(folder.path("a.exr")).expect("numbers of the picture")
    };
    let usual = "--height map.png --method slices-screen";
    let (band, inside) = (picture("s.toml"), picture("s.toml --set slices.test=inside"));
    assert!(band == picture(&format!("{usual} --set slices.test=band")) && inside == picture(usual));
    assert!(band != inside);
    for count in [0, 1] {
        picture(&format!("--height map.png --method slices-surface --set slices.count={count}"));
    }
    for (flags, code, said) in [
        ("--set slices.count=1e9", 1, "slices.count"),
        ("--set slices.count=-1", 2, "slices.count"),
        ("--set slices.test=bond", 2, "did you mean 'band'"),
        ("--set slices.direction=nan", 2, "slices.direction"),
        ("--scale 0", 1, "one place"),
        ("--surface plane", 2, "slices"),
        ("--detail fade", 2, "slices"),
    ] {
        let refused = folder.relief(&format!("render {usual} {SMALL} {flags}"));
        let is_so = refused.code == Some(code) && refused.stderr.contains(said);
        assert!(is_so, "{flags}: {:?} {}", refused.code, refused.stderr);
    }
    let refused = folder.relief(&format!("render bad.toml {SMALL}"));
    assert!(refused.stderr.contains("line 3") && refused.stderr.contains("'band'"), "{}", refused.stderr);
}

#[test]
fn heights_come_from_the_channel_range_and_convention_asked_for() {
    let folder = Folder::new();
    let height = |flags: &str| {
        folder.relief(&format!("render {flags} {SMALL}")).fine();
        only_height(&folder)
    };
    // Integers are divided by their type's maximum, whatever values occur.
    folder.write("map.png", Map::constant(0.3).png());
    assert_near(height("--height map.png"), 0.3);
    assert_near(height("--height map.png --depth"), 0.7);
    assert_near(height("--height map.png --range 0,39321"), 0.5);
    let rgba = DynamicImage::ImageRgba8(RgbaImage::from_pixel(5, 3, image::Rgba([51, 102, 153, 204])));
    folder.write("rgba.png", encoded(&rgba, ImageFormat::Png));
    for (channel, expected) in [("r", 0.2), ("g", 0.4), ("b", 0.6), ("a", 0.8)] {
        assert_near(height(&format!("--height rgba.png --channel {channel}")), expected);
    }
    // Floats by their finite least and greatest value.
    let mut texels = [20.0f32; 64];
    texels[63] = 10.0;
    texels[7] = 40.0;
    let float =
        |texels: &[f32], name: &str| write_exr(&folder.path(name), 8, 8, &[("Y", texels)]).expect("an EXR");
    float(&texels, "float.exr");
    let centre = |flags: &str| {
        folder.relief(&format!("render {flags} {SMALL}")).fine();
        Aov::read(&folder.path("a.exr")).pixel(6, 5).height
    };
    assert_near(centre("--height float.exr"), 1.0 / 3.0);
    assert_near(centre("--height float.exr --range 0,80"), 0.25);
    texels[56] = f32::NAN;
    float(&texels, "holes.exr");
    assert_eq!(folder.relief(&format!("render --height holes.exr {SMALL}")).code, Some(1));
    assert_near(centre("--height holes.exr --fill"), 1.0 / 3.0);
    // 0x8000 in one order is 0x0080 in the other.
    folder.write("map.r16", [0x80, 0x00].repeat(12));
    assert_near(height("--height map.r16 --raw 4x3,be"), 32768.0 / 65535.0);
    assert_near(height("--height map.r16 --raw 4x3,le"), 128.0 / 65535.0);
}

#[test]
fn the_report_agrees_with_the_numbers() {
    let folder = Folder::new();
    folder.write("map.png", Map::hills().png());
    let about = json_of(&folder.relief(&format!("render --height map.png {SMALL} --json")).fine());
    let aov = Aov::read(&folder.path("a.exr"));
    let hits: Vec<f64> = aov.pixels().filter(|(_, _, p)| p.hit == 1.0).map(|(_, _, p)| p.reads).collect();
    assert_eq!(about["covered"], hits.len());
    let mean = hits.iter().sum::<f64>() / hits.len() as f64;
    assert_near(about["mean_reads"].as_f64().expect("a number"), mean);
    assert_eq!((&about["output"], &about["aov"]), (&"a.png".into(), &"a.exr".into()));
    assert_eq!(
        (&about["backend"], &about["exhausted"], &about["reason"]),
        (&"cpu".into(), &0.into(), &Value::Null)
    );
    assert!(about["seconds"].as_f64().is_some_and(|seconds| seconds >= 0.0));
    let picture = image::open(folder.path("a.png")).expect("a valid picture");
    assert_eq!((picture.width(), picture.height()), (12, 10));
    // Without --backend the report gives the reason for the backend.
    let auto = folder.relief("render --height map.png --size 4x4 -o a.png --json");
    assert_eq!(auto.code, Some(0));
    assert!(json_of(&auto)["reason"].as_str().is_some_and(|reason| !reason.is_empty()));
}

#[test]
fn every_listed_name_renders() {
    let folder = Folder::new();
    folder.write("map.png", Map::hills().png());
    let listed = json_of(&folder.relief("methods --json").fine());
    let names = |stage: &str| -> Vec<String> {
        let list = listed[stage].as_array().expect("a list");
        list.iter().map(|entry| entry["name"].as_str().expect("a name").to_owned()).collect()
    };
    // A grid of images serves all methods of objects.
    folder.relief("capture cube --views octahedral --grid 6 --size 32 --verify 1 -q -o cube").fine();
    let render_of = |of: &str, flags: &str| {
        json_of(&folder.relief(&format!("render {of} {SMALL} --json {flags}")).fine())
    };
    folder.relief("volume sponge --size 16x16x16 -q -o sponge.ktx2").fine();
    folder.relief("motif mail --detail 4 -q -o mail.glb").fine();
    for method in listed["methods"].as_array().expect("a list") {
        let name = method["name"].as_str().expect("a name");
        let (of, other) = match method["family"].as_str() {
            Some("object") => ("--object cube/object.toml", "--height map.png"),
            Some("volume") => ("--volume sponge.ktx2", "--height map.png"),
            Some("motif") => ("--motif mail.glb", "--height map.png"),
            _ => ("--height map.png", "--object cube/object.toml"),
        };
        let about = render_of(of, &format!("--method {name}"));
        // An object, a volume or a motif is no relief, nor a relief an object.
        let refused = folder.relief(&format!("render {other} {SMALL} --method {name}"));
        assert!(refused.code == Some(2) && refused.stderr.contains("method"), "{refused:?}");
        let surface = &about["surfaces"][0];
        assert_eq!((&surface["search"], &surface["refine"]), (&method["search"], &method["refine"]));
        assert!(about["covered"].as_u64() > Some(50), "{about}");
    }
    let pairs = json_of(&folder.relief("methods --pairs --json").fine());
    for pair in pairs.as_array().expect("a list") {
        let [search, refine] = ["search", "refine"].map(|key| pair[key].as_str().expect("a name"));
        let flags = format!("--search {search} --refine {refine}");
        let Some(reason) = pair["refused"].as_str() else {
            let of = match search {
                "voxels" | "generalised" | "translucent" => "--volume sponge.ktx2",
                "shell-map" => "--motif mail.glb",
                _ => "--height map.png",
            };
            let about = render_of(of, &flags);
            assert!(about["covered"].as_u64() > Some(50), "{about}");
            continue;
        };
        let refused = folder.relief(&format!("render --height map.png {SMALL} {flags}"));
        assert!(refused.code == Some(2) && refused.stderr.contains(reason), "{refused:?}");
    }
    let table = folder.relief("methods").fine().stdout;
    for name in ["methods", "search", "refinement", "surface", "shading"].into_iter().flat_map(names) {
        assert!(table.contains(&format!("| {name} ")), "{name} is missing from the table");
    }
}

#[test]
fn the_number_of_threads_changes_no_byte() {
    let folder = Folder::new();
    folder.write("map.png", Map::hills().png());
    let with = |threads: &str| {
        let line =
            "render --height map.png --mesh torus --tile 6,2 --size 60x44 --backend cpu -o a.png --aov a.exr";
        let mut command = folder.command();
        let output = command.args(line.split(' ')).env("RAYON_NUM_THREADS", threads).output();
        Ran::new(line, &output.expect("the command starts")).fine();
        ["a.png", "a.exr"].map(|name| std::fs::read(folder.path(name)).expect("it was written"))
    };
    let one = with("1");
    assert_eq!(one, with("2"));
    assert_eq!(one, with("5"));
}

#[test]
fn the_width_of_vectors_changes_no_byte_and_must_be_one() {
    let folder = Folder::new();
    folder.write("map.png", Map::hills().png());
    let with = |value: &str, name: &str| {
        let line = format!("render --height map.png --mesh torus --size 40x30 --backend cpu -o {name}");
        let mut command = folder.command();
        command.env("RELIEF_LANES", value).args(line.split_ascii_whitespace());
        Ran::new(&line, &command.output().expect("the command starts"))
    };
    let bytes = |name: &str| std::fs::read(folder.path(name)).expect("a picture");
    with("1", "one.png").fine();
    with("", "unset.png").fine();
    assert!(bytes("one.png") == bytes("unset.png"));
    for lanes in Lanes::available() {
        with(&lanes.to_string(), "wide.png").fine();
        assert!(bytes("one.png") == bytes("wide.png"), "{lanes}");
    }
    let missing = Lanes::ALL.into_iter().filter(|lanes| !lanes.is_available()).map(|lanes| lanes.to_string());
    for wrong in ["0", "5", "wide", "-8", "8 16"].map(str::to_owned).into_iter().chain(missing) {
        let ran = with(&wrong, "none.png");
        assert!(ran.code == Some(2) && ran.stderr.starts_with("error: RELIEF_LANES: "), "{ran:?}");
        assert!(!folder.path("none.png").exists());
    }
}

#[test]
fn a_pipe_gets_text_and_nothing_else() {
    let folder = Folder::new();
    folder.write("map.png", Map::hills().png());
    let lines = [
        &format!("render --height map.png {SMALL}") as &str,
        // Long enough for a bar to show.
        "render --height map.png --backend cpu --size 1500x1200 --method relief --set search.steps=512 -o \
         b.png",
        "inspect map.png",
        "methods",
        "shader --method cone --target wgsl,spirv -o shaders",
        "--help",
        "render --help",
        "shader --help",
        "--version",
    ];
    for line in lines {
        let ran = folder.relief(line).fine();
        assert!(!ran.stdout.is_empty(), "{line} says nothing");
        let control = |c: char| c.is_control() && c != '\n';
        assert!(!ran.stdout.contains(control), "{line}: {:?}", ran.stdout);
    }
}

#[test]
fn who_stops_reading_is_no_failure() {
    let folder = Folder::new();
    let mut child = folder
        .command()
        .args(["methods", "--json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    drop(child.stdout.take());
    let output = child.wait_with_output().expect("it ends");
    assert_eq!((output.status.code(), output.stderr.len()), (Some(0), 0));
}

#[test]
fn exit_codes_tell_a_wrong_line_from_failed_work() {
    let folder = Folder::new();
    folder.write("map.png", Map::constant(0.5).png());
    folder.write("bad.toml", "height = 'map.png'\nmethod = 'relif'\n");
    let table = [
        (0, "--help"),
        (0, "--version"),
        (0, "help render"),
        (0, "inspect map.png"),
        (1, "inspect no.png"),
        (1, "render --height no.png -o a.png"),
        (1, "render bad.toml -o a.png"),
        (2, ""),
        (2, "rendr"),
        (2, "render"),
        (2, "render --height map.png"),
        (2, "render -o a.png"),
        (2, "render --height map.png -o a.png --method relif"),
        (0, "shader --method cone --target wgsl -o shaders"),
        (1, "shader --method cone --target wgsl -o map.png"),
        (2, "shader --method cone --target wsgl -o shaders"),
        (2, "shader --method cone --target wgsl"),
        (2, "render --height map.png -o a.png --backend cpu --sampling fast"),
        (2, "inspect map.png --frobnicate"),
    ];
    for (code, line) in table {
        let ran = folder.relief(line);
        assert_eq!(ran.code, Some(code), "relief {line}: {}", ran.stderr);
        assert_eq!(ran.stderr.is_empty(), code == 0, "relief {line}: {}", ran.stderr);
        if code != 0 {
            let with_json = folder.relief(&format!("{line} --json"));
            let error: Value = serde_json::from_str(&with_json.stderr)
                .unwrap_or_else(|error| panic!("relief {line} --json: {error}: {}", with_json.stderr));
            assert_eq!((with_json.code, &error["exit"]), (Some(code), &code.into()), "relief {line} --json");
            assert!(error["error"].as_str().is_some_and(|error| !error.is_empty()));
        }
    }
    let refused = folder.relief("render --height map.png -o a.png --backend cpu --sampling fast");
    assert!(refused.stderr.contains("sampler") && refused.stderr.contains("CPU"), "{}", refused.stderr);
}

#[test]
fn an_output_never_replaces_what_is_read() {
    let folder = Folder::new();
    let bytes = Map::constant(0.5).png();
    folder.write("map.png", &bytes);
    folder.write("in/s.toml", "height = '../map.png'\n");
    for line in ["--height map.png -o map.png", "--height map.png -o in/../map.png", "in/s.toml -o ./map.png"]
    {
        let ran = folder.relief(&format!("render --backend cpu --size 4x4 {line}"));
        assert_eq!(ran.code, Some(2), "{line}: {}", ran.stderr);
        assert_eq!(std::fs::read(folder.path("map.png")).expect("it is there"), bytes);
    }
    // A picture of another run is replaced.
    folder.relief("render --backend cpu --size 4x4 --height map.png -o a.png").fine();
    folder.relief("render --backend cpu --size 5x5 --height map.png -o a.png").fine();
    assert_eq!(image::open(folder.path("a.png")).expect("a valid picture").width(), 5);
}

/// File names are bytes on most systems, and not all of them text.
#[cfg(target_os = "linux")]
#[test]
fn names_may_be_no_text() {
    use std::ffi::{OsStr, OsString};
    use std::os::unix::ffi::OsStrExt;

    let folder = Folder::new();
    let name = OsStr::from_bytes(b"m\xffp.png");
    std::fs::write(folder.path(name), Map::constant(0.5).png()).expect("the temporary folder is writable");
    let words = |line: &str| -> Vec<OsString> { line.split(' ').map(OsString::from).collect() };
    let mut inspect = words("inspect --json");
    inspect.push(name.to_owned());
    let about = json_of(&folder.with("inspect", inspect).fine());
    assert_eq!(about["width"], 4);
    let mut render = words("render --json --backend cpu --size 4x4 --height");
    render.extend([name.to_owned(), "-o".into(), OsStr::from_bytes(b"\xfe.png").to_owned()]);
    json_of(&folder.with("render", render).fine());
    assert!(folder.path(OsStr::from_bytes(b"\xfe.png")).exists());
}

#[test]
fn what_is_counted_as_reads_is_said() {
    let folder = Folder::new();
    folder.write("map.png", Map::hills().png());
    for (method, counted) in [("exact", "tracer nodes"), ("relief", "reads")] {
        let line = format!("render --height map.png --backend cpu --size 32x24 --method {method} -o out.png");
        let said = folder.relief(&line).fine().stdout;
        assert!(said.contains(&format!(" {counted} a pixel")), "{said}");
        assert_eq!(json_of(&folder.relief(&format!("{line} --json")).fine())["reads_are"], counted);
    }
}

#[test]
fn without_a_desktop_nothing_but_the_answer_is_written() {
    let folder = Folder::new();
    folder.write("map.png", Map::hills().png());
    let line = "render --height map.png --backend gpu --size 32x24 -o out.png --json";
    let mut command = folder.command();
    for name in ["XDG_RUNTIME_DIR", "WAYLAND_DISPLAY", "DISPLAY"] {
        command.env_remove(name);
    }
    let output = command.args(line.split_ascii_whitespace()).output().expect("the command starts");
    let ran = Ran::new(line, &output);
    if ran.code == Some(0) {
        assert_eq!(ran.stderr, "");
    } else {
        // One error, and nothing beside it.
        assert!(serde_json::from_str::<Value>(&ran.stderr).is_ok(), "{ran:?}");
    }
}

#[test]
fn long_names_and_lines_are_cut_in_what_is_said() {
    let folder = Folder::new();
    folder.write("map.png", Map::hills().png());
    let long = "x".repeat(60_000);
    folder.write("s.toml", format!("height = '{long}'\nsearch = '{long}'\n"));
    folder.write("key.toml", format!("{long} = 1\n"));
    folder.write("value.toml", format!("height = 'map.png'\nwrap = '{long}'\n"));
    folder.write("bad.toml", format!("height = '{long}' nothing\n"));
    folder.write("m.ply", format!("ply\nformat ascii 1.0\n{long}\nend_header\n"));
    folder.write("m.obj", format!("v {long} 0 0\n"));
    for line in [
        format!("render --height {long}.png -o a.png"),
        format!("render --height map.png --size {long} -o a.png"),
        format!("render --height map.png --method {long} -o a.png"),
        format!("render --height map.png --set {long}=1 -o a.png"),
        format!("render --height map.png -o a.{long}"),
        format!("render --{long}"),
        long.clone(),
        "render s.toml -o a.png".to_owned(),
        "render key.toml -o a.png".to_owned(),
        "render value.toml -o a.png".to_owned(),
        "render bad.toml -o a.png".to_owned(),
        "inspect m.ply".to_owned(),
        "inspect m.obj".to_owned(),
        format!("bake map.png --kind {long} -o ."),
    ] {
        for json in ["", " --json"] {
            let ran = folder.relief(&format!("{line}{json}"));
            let about = &line[..line.len().min(50)];
            assert!(matches!(ran.code, Some(1 | 2)), "{about}");
            assert!((20..8000).contains(&ran.stderr.len()), "{about}: {} bytes", ran.stderr.len());
        }
    }
    // Both ends stay: what is wrong, and what to do.
    let ran = folder.relief(&format!("render --height {long}.png -o a.png"));
    assert!(ran.stderr.starts_with("error: xxx") && ran.stderr.contains("…"), "{}", ran.stderr);
}

#[test]
fn a_light_has_a_vector_or_an_azimuth_and_an_altitude() {
    let folder = Folder::new();
    folder.write("map.png", Map::hills().png());
    let picture = |line: &str| {
        folder.relief(&format!("render {line} {SMALL}")).fine();
        std::fs::read(folder.path("a.png")).expect("a picture")
    };
    let east = picture("--height map.png --look plain --light 1,1,0");
    assert!(east == picture("--height map.png --look plain --light az=90,alt=45"));
    assert!(east != picture("--height map.png --look plain --light az=270,alt=45"));
    for key in ["light = 'alt=45, az=90'", "lights = [{ direction = 'az=90,alt=45' }]"] {
        folder.write("s.toml", format!("look = 'plain'\nheight = 'map.png'\n{key}\n"));
        assert!(east == picture("s.toml"), "{key}");
    }
    for (bad, named) in [("az=,alt=45", "az=315"), ("az=90,alt=-1", "altitude"), ("az=400,alt=1", "azimuth")]
    {
        let ran = folder.relief(&format!("render --height map.png --light {bad} -o b.png"));
        assert!(ran.code == Some(2) && ran.stderr.contains(named), "{bad}: {}", ran.stderr);
        folder.write("s.toml", format!("height = 'map.png'\n\nlight = '{bad}'\n"));
        let ran = folder.relief("render s.toml -o b.png");
        assert_eq!(ran.code, Some(1), "{bad}: {}", ran.stderr);
        assert!(ran.stderr.contains("line 3") && ran.stderr.contains(named), "{bad}: {}", ran.stderr);
    }
    assert!(!folder.path("b.png").exists());
}
