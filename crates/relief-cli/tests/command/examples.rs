//! Example commands of `docs/commands.md` and of every help: they run on stand-in files, in small
//! pictures, and their answers make sense. Commands of the README and the guide run by `cargo xtask
//! guide --check`.

use std::collections::BTreeSet;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::Stdio;
use std::sync::OnceLock;

use crate::common::command::{Folder, Ran, json_of};
use crate::common::files::{Samples, exr, georeference, tiff};
use crate::common::maps::{Map, encoded};
use crate::common::meshes::obj;
use image::{ImageFormat, Rgb, RgbImage, Rgba, RgbaImage};
use relief_core::mesh::{sphere, square, torus};

/// Commands with examples, as help is asked for.
const COMMANDS: [&str; 27] = [
    "render",
    "scene",
    "view",
    "inspect",
    "bake",
    "height",
    "height from-normals",
    "height from-photos",
    "height from-shading",
    "height from-meshes",
    "height from-view",
    "height procedure",
    "height for-mesh",
    "height deband",
    "volume",
    "motif",
    "mesh",
    "capture",
    "slices",
    "compare",
    "explain",
    "bench",
    "shader",
    "engine",
    "methods",
    "completions",
    "man",
];

/// Flags that keep an example quick, by its command. A flag of the example itself stays as it is.
const SMALL: [(&str, &[(&str, &str)]); 11] = [
    ("render", &[("--size", "64x48"), ("--samples", "1"), ("--backend", "cpu")]),
    ("view", &[("--size", "64x48"), ("--samples", "1"), ("--backend", "cpu")]),
    ("bake", &[]),
    ("mesh", &[]),
    ("capture", &[("--size", "16"), ("--verify", "4")]),
    ("compare", &[("--size", "24x18"), ("--rays", "200"), ("--backend", "cpu"), ("--methods", "bump,cone")]),
    ("bench", &[("--size", "24x18"), ("--frames", "6"), ("--warm", "1"), ("--methods", "bump,cone")]),
    ("from-meshes", &[]),
    ("procedure", &[]),
    ("shader", &[]),
    ("slices", &[]),
];

/// Values that are too large for a test, and smaller ones in their place.
const SMALLER: [(&str, &str); 11] = [
    ("--methods all", "--methods bump,relief,cone"),
    ("1600x1200", "64x48"),
    ("1280x720", "32x18"),
    ("2048x2048", "64x64"),
    ("1024x1024", "64x64"),
    ("512x256", "32x16"),
    ("0..47", "0..1"),
    ("--grid 12", "--grid 3"),
    ("--grid 7", "--grid 3"),
    ("--rays 100000", "--rays 200"),
    ("--backend cpu,gpu", "--backend cpu"),
];

/// The lines of a text that are examples, without their comments; lines that go on are joined.
fn examples(text: &str) -> Vec<String> {
    let joined = text.replace("\\\n", " ").replace("\\ ", " ");
    let lines = joined.lines().map(str::trim).filter(|line| line.starts_with("relief "));
    let plain = |line: &str| line.split(['#', '>', '|']).next().unwrap_or_default().trim().to_owned();
    lines.map(plain).map(|line| line.split_whitespace().collect::<Vec<_>>().join(" ")).collect()
}

/// The examples of a command's help. The command is a folder's, and its help is as wide as its
/// lines.
fn examples_of_help(folder: &Folder, command: &str) -> Vec<String> {
    let help = folder.relief(&format!("{command} --help")).fine().stdout;
    let mut lines: Vec<String> = Vec::new();
    for line in help.lines().skip_while(|line| !line.starts_with("Examples")).skip(1) {
        if line.trim().is_empty() {
            break;
        }
        // A wrapped line begins without the program's name.
        match lines.last_mut() {
            Some(last) if !line.trim_start().starts_with("relief ") => {
                *last = format!("{last} {}", line.trim());
            }
            _ => lines.push(line.to_owned()),
        }
    }
    examples(&lines.join("\n"))
}

/// All examples, each once, in an order of their own.
fn all(folder: &Folder) -> BTreeSet<String> {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/commands.md");
    let page = fs::read_to_string(page).expect("the page of commands");
    let of_page = page.split("```").skip(1).step_by(2).flat_map(examples).collect::<Vec<_>>();
    assert!(of_page.len() > 30, "{of_page:?}");
    let of_help = COMMANDS.iter().flat_map(|command| examples_of_help(folder, command));
    of_help.chain(of_page).collect()
}

/// A picture of three different channels, as the bytes of a PNG file.
fn colours(side: u32) -> Vec<u8> {
    let picture =
        RgbImage::from_fn(side, side, |x, y| Rgb([x, y, x ^ y].map(|part| (part * 255 / side) as u8)));
    encoded(&picture.into(), ImageFormat::Png)
}

/// A folder with every file that an example reads.
fn stand_ins() -> Folder {
    let folder = Folder::new();
    let hills = Map::new(128, 128, |x, y| {
        let [u, v] = [x, y].map(|at| f64::from(at) / 128.0 * std::f64::consts::TAU);
        ((0.5 + 0.25 * ((3.0 * u).sin() * (4.0 * v).cos() + (3.0 * v + 2.0 * u).sin())) * 65535.0) as u16
    });
    for name in ["wall.png", "bark.png", "bricks.png", "brickwork.png", "wave_0000.png", "wave_0001.png"] {
        folder.write(name, hills.png());
    }
    for name in ["waves_0000.png", "waves_0001.png"] {
        folder.write(name, Map::hills().png());
    }
    // The maps of a material.
    for name in ["wall_color.png", "wall_orm.png"] {
        folder.write(name, colours(128));
    }
    for (role, texels) in [("Color", colours(32)), ("Displacement", hills.png()), ("Roughness", colours(32))]
    {
        folder.write(&format!("Bricks090/Bricks090_1K-PNG_{role}.png"), texels);
    }
    // Heights in the opacity, too.
    let rock = RgbaImage::from_fn(128, 128, |x, y| {
        let height = (hills.texels[(y * 128 + x) as usize] >> 8) as u8;
        Rgba([height; 4])
    });
    folder.write("rock.png", encoded(&rock.into(), ImageFormat::Png));
    let floats: Vec<f32> = hills.texels.iter().map(|&texel| f32::from(texel) / 65535.0).collect();
    for name in ["map.exr", "wall.exr"] {
        folder.write(name, exr([hills.width, hills.height], &[("Y", floats.clone())]));
    }
    // Ground of 1.9 km by 1.4 km, 300 m high.
    let ground: Vec<u8> = (0..48 * 64)
        .flat_map(|at| {
            let [x, y] = [(at % 64) as f32 / 64.0, (at / 64) as f32 / 48.0];
            (150.0 + 90.0 * (9.0 * x).sin() * (7.0 * y).cos() + 60.0 * (17.0 * x + 11.0 * y).sin())
                .to_le_bytes()
        })
        .collect();
    folder.write("dem.tif", tiff([64, 48], Samples::Float, &ground, &georeference()));
    folder.write("tints.txt", "0% green\n50% 190 185 135\n100% white\n");
    // An island of it.
    let island = ground.chunks_exact(4).enumerate().flat_map(|(at, height)| {
        let [x, y] = [(at % 64) as f32 - 31.5, (at / 64) as f32 - 23.5];
        if x.hypot(y) < 20.0 { height.to_vec() } else { (-9999.0f32).to_le_bytes().to_vec() }
    });
    folder.write("island.tif", tiff([64, 48], Samples::Float, &island.collect::<Vec<u8>>(), &georeference()));
    let ring = obj(&torus(24, 12).expect("a mesh"));
    for name in ["tree.obj", "hall.obj", "spot.obj", "column.obj"] {
        folder.write(name, &ring);
    }
    folder.write("panel.obj", obj(&square(2).expect("a mesh")));
    folder.write("ball.obj", obj(&sphere(24, 12).expect("a mesh")));
    for (mesh, names) in [
        ("tree.obj", &["column.glb", "tree.glb", "lamp.glb"][..]),
        ("ball.obj", &["rock.ply"]),
        ("ball.obj", &["rock.glb", "rock_low.glb", "low.glb"]),
    ] {
        for name in names {
            folder
                .relief(&format!("mesh bark.png --mesh {mesh} --scale 0.1mm --texels 64 -q -o {name}"))
                .fine();
        }
    }
    for name in ["scan.ply", "rock_scan.ply"] {
        folder.relief(&format!("mesh bark.png --mesh ball.obj --scale 1cm --texels 16 -q -o {name}")).fine();
    }
    for name in ["wall.toml", "fur.toml"] {
        folder.write(name, "height = \"wall.png\"\nscale = 0.05\n");
    }
    folder.write("scene.toml", "height = \"wall.png\"\n");
    folder.write("actions.json", "[{ \"do\": \"zoom\", \"factor\": 2 }]");
    folder.write("walk.toml", "height = \"wave_%04d.png\"\n");
    folder.write("flight.toml", "height = \"wall.png\"\nsize = [64, 48]\n");
    folder.relief("bake rock.png --kind normal -q -o rock_normal.png").fine();
    folder.relief("bake wall.png --kind normal --set normal.green_down=1 -q -o wall_dx.png").fine();
    folder.relief("capture spot.obj --color bark.png --size 16 --verify 0 --cover centre -q -o spot").fine();
    folder
        .relief("capture spot.obj --views octahedral --grid 3 --size 16 --verify 0 --cover centre -q -o grid")
        .fine();
    folder.relief("motif mail -q -o mail.glb").fine();
    folder.relief("volume sponge --size 16x16x8 -q -o sponge.ktx2").fine();
    for number in 0..5u8 {
        let slice =
            RgbaImage::from_fn(12, 8, |x, y| Rgba([0, 0, 0, (x as u8 * 20).max(y as u8 * 9 * number)]));
        folder.write(&format!("slice_{number:03}.png"), encoded(&slice.into(), ImageFormat::Png));
    }
    // Photographs of hills under four lights, by the renderer.
    let lights = [[0.5, 0.1, 0.8], [-0.5, 0.2, 0.8], [0.0, 0.55, 0.8], [0.1, -0.5, 0.7]];
    let mut text = String::new();
    for (number, [right, up, out]) in lights.into_iter().enumerate() {
        let look =
            "--view top --projection orthographic --shadow none --ambient 0,0,0 --material specular=0,0,0";
        let small = "--size 64x64 --samples 1 --backend cpu --mesh square --scale 0.01 -q";
        // The picture's right is +x, its upper side -z.
        let light = format!("{right},{out},{}", -up);
        folder
            .relief(&format!("render --height wall.png {look} {small} --light {light} -o photo{number}.png"))
            .fine();
        text += &format!("[[photo]]\nfile = \"photo{number}.png\"\nlight = [{right}, {up}, {out}]\n");
    }
    folder.write("lights.toml", text);
    fs::copy(folder.path("photo0.png"), folder.path("photo.png")).expect("it was rendered");
    // Files that the project ships.
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for shipped in ["data", "scenes"] {
        fs::create_dir(folder.path(shipped)).expect("a folder");
        for entry in fs::read_dir(root.join(shipped)).expect("it is shipped").flatten() {
            if entry.path().is_file() {
                fs::copy(entry.path(), folder.path(shipped).join(entry.file_name())).expect("copied");
            }
        }
    }
    folder
}

/// An example as it is run: small, and into files.
fn made_small(example: &str) -> String {
    let mut line = example.strip_prefix("relief ").unwrap_or(example).to_owned();
    for (large, small) in SMALLER {
        line = line.replace(large, small);
    }
    line = line.replace("--output DIR", "--output shell");
    let words: Vec<&str> = line.split(' ').collect();
    let name = if words[0] == "height" { words.get(1).copied().unwrap_or_default() } else { words[0] };
    let flags = SMALL.iter().find(|(command, _)| *command == name).map_or(&[][..], |(_, flags)| flags);
    let missing = flags.iter().filter(|(flag, _)| !words.contains(flag));
    let more: String = missing.map(|(flag, value)| format!(" {flag} {value}")).collect();
    line + &more
}

/// Whether much of a picture is unlike its background, which a corner shows.
fn shows_something(picture: &RgbImage) -> bool {
    let corner = picture.get_pixel(0, 0);
    let unlike = picture.pixels().filter(|pixel| *pixel != corner).count();
    unlike * 10 >= 3 * picture.pixels().len()
}

/// Checks an example's answer.
fn check(folder: &Folder, line: &str, ran: &Ran) {
    assert_eq!(ran.code, Some(0), "relief {line}: {}", ran.stderr);
    let words: Vec<&str> = line.split_whitespace().collect();
    let after =
        |flag: &str| words.iter().position(|word| *word == flag).and_then(|at| words.get(at + 1).copied());
    let Some(output) = after("-o").or(after("--output")) else {
        assert!(!ran.stdout.is_empty(), "relief {line} says nothing");
        return;
    };
    let name = output.replace("%04d", "0001");
    match words[0] {
        "mesh" => {
            let json = json_of(&folder.relief(&format!("{line} --json")));
            let triangles = json["triangles"].as_u64().unwrap_or_default();
            assert!(triangles > 100, "relief {line}: {triangles} triangles");
            if let Some(metres) = after("--error").and_then(|error| error.strip_suffix('m')) {
                let asked: f64 = metres.parse().expect("metres");
                let found = json["error"]["greatest_m"].as_f64();
                // Of tiles each file has its own, and integers are rounded.
                let found = found.or(json["files"][0]["error_m"].as_f64()).expect("an error");
                let rounded = json["quantized"]["greatest_m"].as_f64().unwrap_or_default();
                assert!(found > 0.0 && found <= asked + rounded, "relief {line}: {found} m");
            }
        }
        "render" if !output.ends_with(".exr") => {
            let picture = image::open(folder.path(&name)).expect("a picture").to_rgb8();
            // Sheets are mostly paper.
            let is_sheet = words.iter().any(|word| ["--show", "--methods"].contains(word));
            let colors: BTreeSet<[u8; 3]> = picture.pixels().map(|pixel| pixel.0).collect();
            let is_seen = if is_sheet { colors.len() > 40 } else { shows_something(&picture) };
            assert!(is_seen, "relief {line}: hardly anything is shown");
        }
        _ => {}
    }
    let is_there = folder.path(&name).exists() || words.contains(&"--tiles");
    assert!(is_there, "relief {line}: there is no {name}");
}

/// The examples and the folder that they run in, made once for all tests.
fn shared() -> &'static (Folder, Vec<String>) {
    static SHARED: OnceLock<(Folder, Vec<String>)> = OnceLock::new();
    SHARED.get_or_init(|| {
        let folder = stand_ins();
        let lines = all(&folder).into_iter().collect();
        (folder, lines)
    })
}

/// Runs the examples for which `is_one` holds.
fn run(is_one: impl Fn(&str) -> bool) {
    let (folder, lines) = shared();
    let chosen: Vec<&String> =
        lines.iter().filter(|line| is_one(line.strip_prefix("relief ").unwrap_or(line))).collect();
    assert!(!chosen.is_empty());
    for line in chosen {
        let line = made_small(line);
        if begins(&line, &["view"]) && !line.contains("--script") {
            opens(folder, &line);
            continue;
        }
        let ran = folder.relief(&line);
        check(folder, &line, &ran);
    }
}

/// Runs an example that answers until it is ended: it says where.
fn opens(folder: &Folder, line: &str) {
    let line = line.replace(" --no-open", "").replace("--port 8000", "--port 0");
    let mut command = folder.command();
    command.args(line.split_ascii_whitespace()).arg("--no-open").stdout(Stdio::piped());
    let mut child = command.spawn().expect("the command starts");
    let mut said = String::new();
    BufReader::new(child.stdout.take().expect("a pipe")).read_line(&mut said).expect("a line");
    child.kill().and_then(|()| child.wait()).expect("it ends");
    assert!(said.starts_with("http://127.0.0.1:"), "relief {line}: {said}");
}

fn begins(line: &str, commands: &[&str]) -> bool {
    commands.iter().any(|command| line.split(' ').next() == Some(command))
}

#[test]
fn examples_of_pictures_run() {
    run(|line| begins(line, &["render", "scene", "view"]));
}

#[test]
fn examples_of_meshes_run() {
    run(|line| begins(line, &["mesh", "slices", "volume", "motif"]));
}

#[test]
fn examples_of_maps_and_heights_run() {
    run(|line| begins(line, &["bake", "height", "inspect"]));
}

#[test]
fn examples_of_objects_and_shaders_run() {
    run(|line| begins(line, &["capture", "shader", "engine", "methods", "completions", "man"]));
}

#[test]
fn examples_of_comparisons_run() {
    run(|line| begins(line, &["compare", "bench", "explain"]));
}

#[test]
fn every_example_belongs_to_one_of_these() {
    let (_, lines) = shared();
    let known = [
        "render",
        "scene",
        "view",
        "mesh",
        "slices",
        "volume",
        "motif",
        "bake",
        "height",
        "inspect",
        "capture",
        "shader",
        "engine",
        "methods",
        "completions",
        "man",
        "compare",
        "bench",
        "explain",
    ];
    for line in lines {
        assert!(begins(line.strip_prefix("relief ").unwrap_or(line), &known), "{line}");
    }
    assert!(lines.len() > 70, "{} examples", lines.len());
}
