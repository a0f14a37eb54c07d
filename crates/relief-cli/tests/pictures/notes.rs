//! Notes on what readers leave out or assume. Every row of the table of omissions has a file that
//! makes it appear. Every command that reads heights prints the notes on undeclared holes and on
//! ranges.

use std::f64::consts::TAU;

use crate::common::command::{Folder, Ran, json_of};
use crate::common::files::{Samples, Tag, crc32, exr, georeference, pgm, tiff};
use crate::common::maps::{Map, encoded};
use crate::common::meshes::{factor, part, square};
use image::{ImageFormat, Rgb, RgbImage};
use relief_io::OMISSIONS;
use serde_json::Value;

const SIZE: [u32; 2] = [24, 16];

/// Ground from 100 to 146 with six texels of another value.
fn ground(hole: f32) -> Vec<f32> {
    let height = |at: u32| (100 + at % 24 * 2) as f32;
    (0..SIZE[0] * SIZE[1]).map(|at| if matches!(at, 50..53 | 74..77) { hole } else { height(at) }).collect()
}

fn bytes(values: &[f32]) -> Vec<u8> {
    values.iter().flat_map(|value| value.to_le_bytes()).collect()
}

/// A picture of floats, of those values.
fn floats(values: &[f32]) -> Vec<u8> {
    tiff(SIZE, Samples::Float, &bytes(values), &[])
}

/// A picture of 16 bit from one value to another.
fn integers(low: u16, high: u16) -> Vec<u8> {
    let step = (high - low) / 23;
    Map::new(SIZE[0], SIZE[1], |x, _| low + x as u16 * step).png()
}

/// Returns, for each row of the table, a command whose note belongs to it, with the files that it
/// needs.
type Feed = (&'static str, fn(&Folder) -> &'static str);

const FEEDS: &[Feed] = &[
    ("undeclared-nodata", |folder| {
        folder.write("map.tif", floats(&ground(-9999.0)));
        "inspect map.tif"
    }),
    ("near-nodata", |folder| {
        folder.write("map.tif", floats(&ground(9998.985)));
        "mesh map.tif --nodata 9999 -o out.stl"
    }),
    ("absent-nodata", |folder| {
        folder.write("map.tif", floats(&ground(100.0)));
        "bake map.tif --nodata -9999 --kind normal -o ."
    }),
    ("narrow-range", |folder| {
        folder.write("map.png", integers(3000, 4150));
        "mesh map.png -o out.stl"
    }),
    ("fitted-range", |folder| {
        folder.write("map.exr", exr(SIZE, &[("Y", ground(0.0).iter().map(|h| h / 200.0).collect())]));
        "render --height map.exr --backend cpu --size 32x24 -o out.png"
    }),
    ("banded", |folder| {
        let hill = |x: u32, y: u32| ((x as f32 * 0.05).sin() + (y as f32 * 0.04).cos()) * 8.0 + 16.0;
        folder.write("map.png", Map::new(96, 96, |x, y| 2000 * hill(x, y).round() as u16).png());
        "inspect map.png"
    }),
    ("nearly-grey", |folder| {
        let rgb: Vec<u8> = (0..192u32).map(|at| 100 + (at % 48 / 3) as u8 + u8::from(at == 7)).collect();
        folder.write("map.ppm", [b"P6 8 8 255\n".to_vec(), rgb].concat());
        "bake map.ppm --range auto --kind normal -o ."
    }),
    ("filled", |folder| {
        folder.write("map.tif", floats(&ground(-9999.0)));
        "render --height map.tif --nodata -9999 --backend cpu --size 32x24 -o out.png"
    }),
    ("holes", |folder| {
        folder.write("map.tif", floats(&ground(f32::NAN)));
        "mesh map.tif --holes -o out.stl"
    }),
    ("no-holes", |folder| {
        folder.write("map.tif", floats(&ground(101.0)));
        "mesh map.tif --holes -o out.stl"
    }),
    ("named-like-depth", |folder| {
        folder.write("wall_depth.png", integers(0, 65535));
        "mesh wall_depth.png -o out.stl"
    }),
    ("units", |folder| {
        let high: Vec<f32> = ground(100.0).iter().map(|height| 100.0 * height + 10_000.0).collect();
        folder.write("dem.tif", tiff(SIZE, Samples::Float, &bytes(&high), &georeference()));
        "bake dem.tif --kind normal -o ."
    }),
    ("unweighted-vertices", |folder| {
        let attributes = r#"{"POSITION": 0, "TEXCOORD_0": 1, "JOINTS_0": 8, "WEIGHTS_0": 9}"#;
        let part = format!(r#"{{"attributes": {attributes}, "indices": 4}}"#);
        square(folder, "a.gltf", &part, r#", "skins": [{"joints": [1]}]"#);
        let text = std::fs::read_to_string(folder.path("a.gltf")).expect("it was written");
        folder.write("a.gltf", text.replace(r#"[{"mesh": 0}]"#, r#"[{"mesh": 0, "skin": 0}, {}]"#));
        "inspect a.gltf"
    }),
    ("absent-coordinates", |folder| painted(folder, r#", "texCoord": 3"#, "", "")),
    ("unread-picture", |folder| {
        let line = painted(folder, "", "", "");
        let text = std::fs::read_to_string(folder.path("a.gltf")).expect("it was written");
        let basis = r#"[{"extensions": {"KHR_texture_basisu": {"source": 0}}}]"#;
        folder.write("a.gltf", text.replace(r#"[{"source": 0, "sampler": 0}]"#, basis));
        line
    }),
    ("other-pictures", |folder| {
        painted(folder, "", r#", "occlusionTexture": {"index": 0}"#, "");
        "render --mesh a.gltf --shade blinn-phong --backend cpu --size 32x24 -o out.png"
    }),
    ("unread-material", |folder| painted(folder, "", r#", "extensions": {"KHR_materials_sheen": {}}"#, "")),
    ("unshown-material", |folder| {
        let glass = r#", "extensions": {"KHR_materials_transmission": {"transmissionFactor": 0.9}}"#;
        painted(folder, "", glass, "")
    }),
    ("mtl", |folder| {
        let obj = "mtllib ../a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n";
        folder.write("a.obj", obj);
        "render --mesh a.obj --backend cpu --size 32x24 -o out.png"
    }),
    ("blended", |folder| painted(folder, "", r#", "alphaMode": "BLEND""#, "")),
    ("uneven-colours", |folder| {
        let attributes = r#"{"POSITION": 0, "TEXCOORD_0": 1, "COLOR_0": 10}"#;
        square(folder, "a.gltf", &format!(r#"{{"attributes": {attributes}, "indices": 4}}"#), "");
        "render --mesh a.gltf --backend cpu --size 32x24 -o out.png"
    }),
    ("left-out-colours", |folder| {
        let materials = format!(r#", "materials": [{}, {}]"#, factor("1, 0, 0, 1"), factor("0, 0, 1, 1"));
        square(folder, "a.gltf", &[part(2, 0), part(3, 1)].join(", "), &materials);
        folder.write("map.png", integers(0, 65535));
        "render --height map.png --mesh a.gltf --method vertex --backend cpu --size 32x24 -o out.png"
    }),
    ("tiled-picture", |folder| {
        painted(folder, "", "", "");
        "render --mesh a.gltf --tile 2,2 --backend cpu --size 32x24 -o out.png"
    }),
    ("beyond-motif", |folder| {
        folder.write("a.obj", "v 0 0.5 0\nv 1 0.5 0\nv 0 1.5 1\nf 1 2 3\n");
        "render --motif a.obj --backend cpu --size 32x24 -o out.png"
    }),
    ("folded-shells", |folder| {
        folder.write("a.obj", "v 0 0.5 0\nv 1 0.5 0\nv 0 0.6 1\nf 1 2 3\n");
        "render --motif a.obj --mesh sphere --bias -1 --scale 3 --backend cpu --size 32x24 -o out.png"
    }),
    ("open-motif", |folder| {
        folder.write("a.obj", "v 0 0.5 0\nv 1 0.5 0\nv 0 0.6 1\nf 1 2 3\n");
        "render --motif a.obj --backend cpu --size 32x24 -o out.png"
    }),
    ("coarse-vectors", |folder| {
        let path = folder.path("v.png");
        relief_io::write_png8(&path, 1, 1, relief_io::PngColour::Rgb, &[128, 200, 128]).expect("written");
        "render --motif v.png --backend cpu --size 32x24 -o out.png"
    }),
    ("unwritten-materials", |folder| {
        painted(folder, "", "", "");
        "mesh map.png --mesh a.gltf -o out.stl"
    }),
    ("no-orientation", |folder| {
        folder.write("map.tif", tiff(SIZE, Samples::Float, &bytes(&ground(100.0)), &[tag_orientation(9)]));
        "mesh map.tif -o out.stl"
    }),
    ("orientation-on-ground", |folder| {
        let tags = [&[tag_orientation(6)][..], &georeference()].concat();
        folder.write("dem.tif", tiff(SIZE, Samples::Float, &bytes(&ground(100.0)), &tags));
        "bake dem.tif --kind normal -o ."
    }),
    ("pages", |folder| {
        folder.write("map.png", integers(0, 65535));
        folder.write("colours.tif", pages(&tiff(SIZE, Samples::Float, &bytes(&ground(0.0)), &[])));
        "render --height map.png --color colours.tif --backend cpu --size 32x24 -o out.png"
    }),
    ("no-photometric", |folder| {
        let mut bytes = floats(&ground(0.0));
        let entry = bytes.windows(4).position(|found| found == [6, 1, 3, 0]).expect("tag 262, a short");
        bytes[entry] += 1;
        folder.write("map.tif", bytes);
        "inspect map.tif"
    }),
    ("long-opacity", |folder| {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, 8, 2);
        encoder.set_color(png::ColorType::Indexed);
        encoder.set_depth(png::BitDepth::One);
        encoder.set_palette(vec![0, 0, 0, 255, 255, 255]);
        encoder.set_trns(vec![0, 128, 255]);
        let written = encoder.write_header().and_then(|mut writer| writer.write_image_data(&[0x5a, 0x3c]));
        written.expect("memory is writable");
        folder.write("map.png", bytes);
        "inspect map.png"
    }),
    ("display-window", |folder| {
        let mut bytes = exr(SIZE, &[("Y", ground(0.0))]);
        let name = b"displayWindow\0box2i\0";
        let at = bytes.windows(name.len()).position(|found| found == name).expect("it has one");
        bytes[at + name.len() + 4] = 9;
        folder.write("map.exr", bytes);
        "mesh map.exr -o out.stl"
    }),
    ("animation", |folder| {
        let chunk = [&b"acTL"[..], &1u32.to_be_bytes(), &0u32.to_be_bytes()].concat();
        folder.write("map.png", with_chunk(&integers(0, 65535), &chunk));
        "inspect map.png"
    }),
    ("other-green", |folder| {
        // Waves along both axes, and normals whose green points down.
        let at = |x: u32, y: u32| [x, y].map(|place| f64::from(place) / 16.0 * TAU);
        let map = Map::new(16, 16, |x, y| {
            let [u, v] = at(x, y);
            (32768.0 + 12000.0 * (u.sin() + v.sin())) as u16
        });
        let normals = RgbImage::from_fn(16, 16, |x, y| {
            let [u, v] = at(x, y).map(|turn| (127.5 - 60.0 * turn.cos()) as u8);
            Rgb([u, v, 220])
        });
        folder.write("map.png", map.png());
        folder.write("map_normal.png", encoded(&normals.into(), ImageFormat::Png));
        "render map.png --normal map_normal.png --size 8x8 --backend cpu -o out.jpg"
    }),
    ("texture-set", |folder| {
        folder.write("Stones_Height.pgm", "P2 2 1 255 51 255");
        "render --textures . --size 8x8 --backend cpu -o out.jpg"
    }),
    ("left-textures", |folder| {
        folder.write("Stones_Height.pgm", "P2 2 1 255 51 255");
        folder.write("Stones_Unknown.pgm", "P2 2 1 255 51 255");
        "render . --size 8x8 --backend cpu -o out.jpg"
    }),
    ("deep-relief", |folder| {
        folder.write("map.png", integers(0, 65535));
        "render map.png --scale 840m --backend cpu --size 32x24 -o out.png"
    }),
    ("table-opacity", |folder| {
        folder.write("map.png", integers(0, 65535));
        folder.write("tints.txt", "0% green 128\n100% white\n");
        "render map.png --ramp tints.txt --backend cpu --size 32x24 -o out.png"
    }),
    ("outside-table", |folder| {
        folder.write("map.png", integers(0, 65535));
        folder.write("tints.txt", "236 green\n1076 white\n");
        "render map.png --ramp tints.txt --unit m --backend cpu --size 32x24 -o out.png"
    }),
    ("idle-factor", |folder| {
        folder.write("map.pgm", "P2 2 1 255 51 255");
        folder.write("black.pgm", "P2 2 1 255 0 0");
        "render --height map.pgm --metallic black.pgm --material metallic=1 --size 8x8 --backend cpu -o \
         out.jpg"
    }),
    ("orientation-in-gltf", |folder| {
        let line = painted(folder, "", "", "");
        let turned = b"eXIfII*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0\x06\0\0\0\0\0\0\0";
        folder.write("map.png", with_chunk(&integers(0, 65535), turned));
        line
    }),
];

/// A mesh with a picture, and a command that shows it. More of the keys of the picture's place, of
/// the material and of the sampler.
fn painted(folder: &Folder, info: &str, material: &str, sampler: &str) -> &'static str {
    folder.write("map.png", integers(0, 65535));
    let more = format!(
        r#", "materials":
        [{{"pbrMetallicRoughness": {{"baseColorTexture": {{"index": 0{info}}}}}{material}}}],
        "images": [{{"uri": "map.png"}}], "textures": [{{"source": 0, "sampler": 0}}],
        "samplers": [{{{sampler}}}]"#
    );
    square(folder, "a.gltf", &part(4, 0), &more);
    "render --mesh a.gltf --backend cpu --size 32x24 -o out.png"
}

/// The tag that says how a TIFF is turned.
fn tag_orientation(number: u16) -> Tag {
    (274, 3, number.to_le_bytes().to_vec())
}

/// A TIFF with its only page a second time behind it.
fn pages(one: &[u8]) -> Vec<u8> {
    let number = |at: usize, len: usize| {
        one[at..at + len].iter().rev().fold(0, |number, byte| number << 8 | usize::from(*byte))
    };
    let page = number(4, 4);
    let entries = 2 + 12 * number(page, 2);
    let mut two = one.to_vec();
    two[page + entries..page + entries + 4].copy_from_slice(&(one.len() as u32).to_le_bytes());
    two.extend_from_slice(&one[page..page + entries]);
    two.extend([0; 4]);
    two
}

/// Returns a PNG with a further chunk behind the header, given from its type on.
fn with_chunk(png: &[u8], chunk: &[u8]) -> Vec<u8> {
    let [before, after] = [&png[..33], &png[33..]];
    let length = (chunk.len() as u32 - 4).to_be_bytes();
    [before, &length, chunk, &crc32(chunk).to_be_bytes(), after].concat()
}

/// Returns the rows that the notes in a command's JSON are about.
fn abouts(ran: &Ran) -> Vec<String> {
    assert_eq!(ran.code, Some(0), "relief {}: {}", ran.line, ran.stderr);
    let notes = json_of(ran)["notes"].as_array().cloned().unwrap_or_default();
    notes.iter().map(|note| note["about"].as_str().expect("a name").to_owned()).collect()
}

#[test]
fn every_row_of_the_table_has_a_note() {
    let names: Vec<&str> = OMISSIONS.iter().map(|row| row.name).collect();
    let fed: Vec<&str> = FEEDS.iter().map(|(name, _)| *name).collect();
    assert_eq!(fed, names, "each row of OMISSIONS has its feed, in the same order");
    for (name, feed) in FEEDS {
        let folder = Folder::new();
        let line = feed(&folder);
        let found = abouts(&folder.relief(&format!("{line} --json")));
        assert!(found.iter().any(|about| about == name), "relief {line}: {found:?}, not {name}");
        // The text output has the note, too, unless --quiet is given; `inspect` always prints it.
        let ran = folder.relief(line);
        assert_eq!(ran.code, Some(0), "relief {line}: {}", ran.stderr);
        let is_said = |text: &str| text.lines().any(|line| line.trim_start().starts_with("note"));
        assert!(is_said(&ran.stderr) || is_said(&ran.stdout), "relief {line}: {}", ran.stderr);
    }
}

#[test]
fn a_value_for_none_is_named_with_its_flag_by_all_commands() {
    let folder = Folder::new();
    folder.write("f32.tif", floats(&ground(-9999.0)));
    folder.write("limit.tif", floats(&ground(f32::MIN)));
    folder.write("dem.tif", tiff(SIZE, Samples::Float, &bytes(&ground(-32768.0)), &georeference()[..3]));
    folder.write("high.exr", exr(SIZE, &[("Y", ground(1e20))]));
    folder.write("surfer.exr", exr(SIZE, &[("Y", ground(1.70141e38))]));
    let wide: Vec<u16> = ground(65535.0).iter().map(|value| *value as u16).collect();
    folder.write("wide.png", Map::new(SIZE[0], SIZE[1], |x, y| wide[(y * 24 + x) as usize]).png());
    folder.write("wide.pgm", pgm(SIZE, &wide));
    folder.write("wide.r16", wide.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<u8>>());
    for (line, flag) in [
        ("inspect f32.tif", "-9999"),
        ("mesh limit.tif -o out.stl", "-3.4028235e38"),
        ("render dem.tif --backend cpu --size 32x24 -o out.png", "-32768"),
        ("render --height high.exr --backend cpu --size 32x24 -o out.png", "1e20"),
        ("bake surfer.exr --kind normal -o .", "1.70141e38"),
        ("render --height wide.png --backend cpu --size 32x24 -o out.png", "65535"),
        ("height for-mesh wide.pgm --mesh square --lift -o out.exr", "65535"),
        ("bake wide.r16 --raw 24x16,le --kind normal -o .", "65535"),
        ("bench --height f32.tif --methods bump --backend cpu --size 16x12 --frames 2 --warm 0", "-9999"),
        ("compare --height f32.tif --methods bump --backend cpu --size 16x12 --quick --rays 10", "-9999"),
    ] {
        let ran = folder.relief(line);
        assert_eq!(ran.code, Some(0), "relief {line}: {}", ran.stderr);
        let words = format!("--nodata {flag}");
        let said = format!("{}{}", ran.stderr, ran.stdout);
        let note = said
            .lines()
            .find(|line| line.contains(&words))
            .unwrap_or_else(|| panic!("relief {line}: {said}"));
        assert!(note.contains("6 texels have") && note.contains("note"), "{note}");
        // The flag is accepted, makes these texels holes, and ends the note.
        let force = if line.starts_with("bake") { " --force" } else { "" };
        let ran = folder.relief(&format!("{line} {words} --fill{force}"));
        assert_eq!(ran.code, Some(0), "relief {line}: {}", ran.stderr);
        assert!(!format!("{}{}", ran.stderr, ran.stdout).contains(&words), "relief {line}: {}", ran.stderr);
    }
    // No mesh in metres is made of it.
    let ran = folder.relief("mesh dem.tif -o refused.glb");
    assert!(ran.code == Some(1) && ran.stderr.contains("--nodata -32768"), "{}", ran.stderr);
    assert!(!ran.stderr.contains("--unit") && !folder.path("refused.glb").exists(), "{}", ran.stderr);
    folder.relief("mesh dem.tif --nodata -32768 --fill -o mended.glb").fine();
    // Commands that take a scene file name the key.
    folder.write("scene.toml", "height = 'f32.tif'\n");
    for line in ["slices scene.toml -o out.glb", "capture scene.toml --views cube --size 16 -o ball"] {
        let ran = folder.relief(line);
        assert!(ran.code == Some(0) && ran.stderr.contains("? nodata = -9999\n"), "{line}: {}", ran.stderr);
    }
}

#[test]
fn a_range_is_named_by_all_commands_and_auto_takes_it() {
    let folder = Folder::new();
    let narrow = Map::new(SIZE[0], SIZE[1], |x, y| (44 + (x + y) % 26) as u16);
    let grey: Vec<u8> = narrow.texels.iter().map(|h| *h as u8).collect();
    folder.write("a.pgm", [&b"P5 24 16 255\n"[..], &grey].concat());
    folder.write("b.ppm", [b"P6 24 16 255\n".to_vec(), grey.iter().flat_map(|h| [*h; 3]).collect()].concat());
    folder.write("c.png", integers(100, 1020));
    folder.write("d.png", integers(60000, 65060));
    folder.write("e.pgm", pgm(SIZE, &narrow.texels));
    let wide: Vec<u8> = narrow.texels.iter().flat_map(|h| (h * 20).to_le_bytes()).collect();
    folder.write("f.r16", &wide);
    folder.write("g.tif", tiff(SIZE, Samples::Short, &wide, &[]));
    folder.write("h.png", Map::new(8, 8, |x, _| if x == 3 { 0 } else { 9 }).png());
    for (line, range) in [
        ("mesh a.pgm -o out.stl", "44,69"),
        ("bake b.ppm --kind normal -o .", "44,69"),
        ("render --height c.png --backend cpu --size 32x24 -o out.png", "100,1020"),
        ("mesh d.png -o out.stl", "60000,65060"),
        ("render --height e.pgm --backend cpu --size 32x24 -o out.png", "44,69"),
        ("bake f.r16 --raw 24x16,le --kind normal -o .", "880,1380"),
        ("mesh g.tif -o out.stl", "880,1380"),
        ("height for-mesh h.png --mesh square --lift -o out.exr", "0,9"),
    ] {
        let ran = folder.relief(line);
        let words = format!("--range {range}");
        assert!(ran.code == Some(0) && ran.stderr.contains(&words), "relief {line}: {}", ran.stderr);
        let looked = line.split(' ').find(|word| word.contains('.')).expect("a file");
        let raw = if looked == "f.r16" { " --raw 24x16,le" } else { "" };
        let text = folder.relief(&format!("inspect {looked}{raw}")).fine().stdout;
        assert!(text.contains(&words), "{text}");
        let force = if line.starts_with("bake") { " --force" } else { "" };
        for range in [words.as_str(), "--range auto"] {
            let ran = folder.relief(&format!("{line} {range}{force}"));
            assert_eq!((ran.code, ran.stderr.as_str()), (Some(0), ""), "relief {line} {range}");
        }
    }
    // The relief is as deep as the two values say.
    let depth = |flags: &str| -> f64 {
        let ran = folder.relief(&format!("mesh a.pgm --texels 1 --scale 1 -o out.stl --json{flags}"));
        let size: [f64; 3] = serde_json::from_value(json_of(&ran)["size_m"].clone()).expect("three lengths");
        size[1]
    };
    let [narrow, given, auto] = ["", " --range 44,69", " --range auto"].map(depth);
    assert!((narrow - 25.0 / 255.0).abs() < 1e-3, "{narrow}");
    assert!((given - 1.0).abs() < 1e-6 && given == auto, "{given} {auto}");
}

#[test]
fn the_same_picture_in_integers_and_floats_is_as_deep_where_the_note_is_followed() {
    let folder = Folder::new();
    let height = |x: u32| 0.1 + 0.8 * f64::from(x) / 23.0;
    folder.write("map.png", Map::new(SIZE[0], SIZE[1], |x, _| (65535.0 * height(x)).round() as u16).png());
    let floats = (0..SIZE[0] * SIZE[1]).map(|at| height(at % 24) as f32).collect();
    folder.write("map.exr", exr(SIZE, &[("Y", floats)]));
    let depth = |line: &str| -> (f64, String) {
        let size: [f64; 3] = serde_json::from_value(
            json_of(&folder.relief(&format!("mesh {line} -o out.stl --json")))["size_m"].clone(),
        )
        .expect("three lengths");
        (size[1], folder.relief(&format!("mesh {line} -o out.stl")).stderr)
    };
    let [(png, nothing), (exr, said), (followed, quiet)] =
        ["map.png", "map.exr", "map.exr --range 0,1"].map(depth);
    assert!((png - 0.04).abs() < 1e-3 && (exr - 0.05).abs() < 1e-3, "{png} {exr}");
    assert!((followed - png).abs() < 1e-4, "{followed} {png}");
    assert_eq!((nothing.as_str(), quiet.as_str()), ("", ""));
    assert!(said.contains("0.1 and 0.9") && said.contains("--range 0,1"), "{said}");
}

#[test]
fn a_scene_file_holds_both_and_is_written_with_them() {
    let folder = Folder::new();
    folder.write("map.tif", floats(&ground(-9999.0)));
    let written = folder.relief("scene --height map.tif --nodata -9999 --range auto").fine().stdout;
    folder.write("scene.toml", &written);
    assert_eq!(folder.relief("scene scene.toml").fine().stdout, written);
    assert!(written.contains("\nnodata = -9999.0") && written.contains("\nrange = \"auto\""), "{written}");
    let about = |line: &str| {
        json_of(&folder.relief(&format!("render {line} --backend cpu --size 32x24 -o out.png --json")))
    };
    let [by_file, by_flags] = ["scene.toml", "--height map.tif --nodata -9999 --range auto"].map(about);
    assert_eq!(by_file["surfaces"], by_flags["surfaces"]);
    assert_eq!(by_file["surfaces"][0]["filled_texels"], 6);
    // Each surface has its own note, since another map has another value.
    folder.write("plain.tif", floats(&ground(7.0)));
    folder.write(
        "two.toml",
        "[[surfaces]]\nheight = 'map.tif'\nnodata = -9999\n[[surfaces]]\nheight = 'plain.tif'\nnodata = 7\n\
         position = [2, 0, 0]\n",
    );
    let filled = |about: &Value| -> Vec<u64> {
        let surfaces = about["surfaces"].as_array().expect("surfaces");
        surfaces.iter().map(|surface| surface["filled_texels"].as_u64().expect("a number")).collect()
    };
    assert_eq!(filled(&about("two.toml")), [6, 6]);
    assert_eq!(filled(&about("scene.toml --height plain.tif")), [0]);
    let schema: Value = serde_json::from_str(&folder.relief("scene --schema").fine().stdout).expect("JSON");
    assert!(schema["properties"]["nodata"].is_object() && schema["properties"]["range"]["oneOf"].is_array());
}

#[test]
fn values_that_cannot_be_are_refused() {
    let folder = crate::common::refused::with_out();
    folder.write("map.tif", floats(&ground(-9999.0)));
    for (line, words) in [
        ("inspect map.tif --nodata nan", &["--nodata", "never have a value"][..]),
        ("mesh map.tif --nodata inf -o out/a.stl", &["--nodata"]),
        ("bake map.tif --nodata none --kind normal -o out", &["--nodata", "-9999"]),
        ("render --height map.tif --nodata 1,2 -o out/a.png", &["--nodata"]),
        ("mesh map.tif --range all -o out/a.stl", &["--range", "auto"]),
        ("mesh map.tif --range 1,nan -o out/a.stl", &["--range", "finite"]),
    ] {
        crate::common::refused::assert_refused(&folder, &folder.relief(line), 2, words);
    }
    for (text, word) in [
        ("nodata = nan", "nodata"),
        ("nodata = 'none'", "nodata"),
        ("range = 'all'", "auto"),
        ("range = [1, 2, 3]", "range"),
    ] {
        folder.write("scene.toml", format!("height = 'map.tif'\n{text}\n"));
        let ran = folder.relief("render scene.toml -o out/a.png");
        crate::common::refused::assert_refused(&folder, &ran, 1, &["scene.toml", word]);
    }
    // No height is left.
    folder.write("level.tif", floats(&vec![5.0; 384]));
    let ran = folder.relief("mesh level.tif --nodata 5 -o out/a.stl");
    crate::common::refused::assert_refused(&folder, &ran, 1, &["no texel"]);
}
