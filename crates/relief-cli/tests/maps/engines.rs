//! `relief bake --for`: textures for engines, read back.

use image::{DynamicImage, GrayImage, ImageFormat, Luma, Rgb, RgbImage};
use relief_io::{ENGINES, GreenSign};
use serde_json::{Value, json};

use crate::common::command::{Folder, json_of};
use crate::common::maps::{Map, encoded};

const SIDE: u32 = 96;

/// Part of a turn at a column or row.
fn turn(at: u32) -> f64 {
    f64::from(at) / f64::from(SIDE) * std::f64::consts::TAU
}

/// Value between 0 and 255 at a texel, smooth and without a seam.
fn smooth(x: u32, y: u32, [across, down]: [f64; 2], [low, high]: [f64; 2]) -> u8 {
    let wave = 0.5 + 0.5 * (across * turn(x) + 0.3).sin() * (down * turn(y)).cos();
    (255.0 * (low + (high - low) * wave)).round() as u8
}

fn hills() -> Map {
    Map::new(SIDE, SIDE, |x, y| {
        let waves = (2.0 * turn(x)).sin() * turn(y).cos() + 0.5 * (turn(x) + 2.0 * turn(y)).sin();
        ((0.5 + 0.25 * waves) * 65535.0).round() as u16
    })
}

/// Normals of the hills, 4 cm high on a tile of 1 m.
fn normals(green: GreenSign) -> Vec<u8> {
    let map = hills();
    let at = |x: u32, y: u32| f64::from(map.texels[(y % SIDE * SIDE + x % SIDE) as usize]) / 65535.0;
    let picture = RgbImage::from_fn(SIDE, SIDE, |x, y| {
        let slope = |ahead: f64, behind: f64| (ahead - behind) * 0.5 * 0.04 * f64::from(SIDE);
        let along_u = slope(at(x + 1, y), at(x + SIDE - 1, y));
        let along_v = slope(at(x, y + 1), at(x, y + SIDE - 1));
        let length = (along_u * along_u + along_v * along_v + 1.0).sqrt();
        let up = if green == GreenSign::PlusY { along_v } else { -along_v };
        Rgb([-along_u, up, 1.0].map(|part| (255.0 * (0.5 + 0.5 * part / length)).round() as u8))
    });
    encoded(&DynamicImage::ImageRgb8(picture), ImageFormat::Png)
}

fn grey(waves: [f64; 2], range: [f64; 2], side: u32) -> Vec<u8> {
    let picture = GrayImage::from_fn(side, side, |x, y| {
        let [x, y] = [x, y].map(|at| at * SIDE / side);
        Luma([smooth(x, y, waves, range)])
    });
    encoded(&DynamicImage::ImageLuma8(picture), ImageFormat::Png)
}

fn colours(range: [f64; 2]) -> Vec<u8> {
    let picture = RgbImage::from_fn(SIDE, SIDE, |x, y| {
        Rgb([[1.0, 2.0], [2.0, 1.0], [3.0, 1.0]].map(|waves| smooth(x, y, waves, range)))
    });
    encoded(&DynamicImage::ImageRgb8(picture), ImageFormat::Png)
}

/// A folder with a texture set `wall` of these parts.
fn set(parts: &[&str]) -> Folder {
    let folder = Folder::new();
    for part in parts {
        let bytes = match *part {
            "Height" => hills().png(),
            "Color" => colours([0.2, 0.8]),
            "NormalGL" => normals(GreenSign::PlusY),
            "NormalDX" => normals(GreenSign::MinusY),
            "Roughness" => grey([1.0, 1.0], [0.4, 0.9], SIDE / 2),
            "Metalness" => grey([1.0, 2.0], [0.0, 1.0], SIDE),
            "AmbientOcclusion" => grey([2.0, 2.0], [0.5, 1.0], SIDE),
            "Emission" => colours([0.0, 0.2]),
            "ARM" => colours([0.4, 0.9]),
            "Opacity" => grey([1.0, 1.0], [0.5, 1.0], SIDE),
            other => panic!("no part {other}"),
        };
        folder.write(&format!("wall/wall_{part}.png"), bytes);
    }
    folder
}

const WHOLE: [&str; 7] =
    ["Height", "Color", "NormalDX", "Roughness", "Metalness", "AmbientOcclusion", "Emission"];

fn bake(folder: &Folder, flags: &str) -> Value {
    json_of(&folder.relief(&format!("bake wall --scale 4cm --json {flags}")).fine())
}

/// The picture of a folder.
fn picture(folder: &Folder, of: &str, flags: &str) -> RgbImage {
    let ran = folder.relief(&format!(
        "render {of} --size 160x120 --backend cpu --light az=0,alt=30 -q -o picture.png {flags}"
    ));
    assert_eq!(ran.code, Some(0), "relief {}: {}", ran.line, ran.stderr);
    image::open(folder.path("picture.png")).expect("a picture").to_rgb8()
}

/// The greatest difference of two pictures.
fn difference(one: &RgbImage, other: &RgbImage) -> u8 {
    one.as_raw().iter().zip(other.as_raw()).map(|(one, other)| one.abs_diff(*other)).max().unwrap_or(0)
}

#[test]
fn textures_for_every_engine_show_the_same() {
    for parts in [&WHOLE[..], &["Height", "Color", "NormalGL", "ARM"], &["Height", "Color"]] {
        let folder = set(parts);
        let first = picture(&folder, "wall", "--scale 4cm");
        for engine in ENGINES {
            let said = bake(&folder, &format!("--for {0} -o {0}", engine.name));
            // The files say how deep they are.
            let again = picture(&folder, engine.name, "");
            let off = difference(&first, &again);
            assert!(off <= 2, "{}, {parts:?}: {off} of 255", engine.name);
            let file = |holds: &str| {
                let textures = said["textures"].as_array().expect("a list");
                let found = textures.iter().find(|texture| texture["holds"] == holds);
                let name = found.map(|texture| &texture["file"]);
                format!("{}/{}", engine.name, name.and_then(Value::as_str).expect("a file"))
            };
            let normals = file("normals");
            let line = format!("inspect wall/wall_Height.png --normal {normals} --json");
            let about = json_of(&folder.relief(&line).fine());
            assert_eq!(about["detection"]["green"], engine.green.name(), "{}: {about:#}", engine.name);

            // A normal map whose green was not turned shows.
            let path = folder.path(&normals);
            let mut turned = image::open(&path).expect("a picture").to_rgb8();
            turned.pixels_mut().for_each(|pixel| pixel[1] = 255 - pixel[1]);
            turned.save(&path).expect("a picture");
            let off = difference(&first, &picture(&folder, engine.name, ""));
            assert!(off > 10, "{}, {parts:?}: green is turned and {off} of 255 off", engine.name);
        }
    }
}

#[test]
fn integers_of_normals_are_kept_or_turned() {
    let folder = set(&["Height", "NormalDX"]);
    let before = image::open(folder.path("wall/wall_NormalDX.png")).expect("a picture").to_rgb8();
    for (engine, name) in [("unreal", "T_wall_N.png"), ("godot", "wall_normal.png")] {
        bake(&folder, &format!("--for {engine} -o {engine}"));
        let after = image::open(folder.path(engine).join(name)).expect("a picture").to_rgb8();
        for (before, after) in before.pixels().zip(after.pixels()) {
            let green = if engine == "unreal" { before[1] } else { 255 - before[1] };
            assert_eq!(after.0, [before[0], green, before[2]], "{engine}");
        }
    }
}

#[test]
fn channels_bits_and_depths_are_the_engine_s() {
    let folder = set(&WHOLE);
    let read = |path: &str| image::open(folder.path(path)).expect("a picture");
    let occlusion = read("wall/wall_AmbientOcclusion.png").to_luma8();
    let metalness = read("wall/wall_Metalness.png").to_luma8();
    bake(&folder, "--for unity -o unity");
    let mask = read("unity/wall_MaskMap.png").to_rgba8();
    bake(&folder, "--for gltf -o gltf");
    let orm = read("gltf/wall_orm.png").to_rgb8();
    for ((mask, orm), (occlusion, metalness)) in
        mask.pixels().zip(orm.pixels()).zip(occlusion.pixels().zip(metalness.pixels()))
    {
        assert_eq!([mask[0], mask[1], mask[2]], [metalness[0], occlusion[0], 0]);
        assert_eq!([orm[0], orm[2]], [occlusion[0], metalness[0]]);
        // Each of the two is rounded.
        assert!((254..=256).contains(&(u16::from(mask[3]) + u16::from(orm[1]))));
    }
    assert_eq!(read("unity/wall_Height.png"), read("wall/wall_Height.png"));
    bake(&folder, "--for bevy -o bevy");
    let DynamicImage::ImageLuma8(depths) = read("bevy/wall_depth_map.png") else { panic!("8 bits of grey") };
    for (depth, height) in depths.pixels().zip(hills().texels) {
        let sum = f64::from(depth[0]) + f64::from(height) / 257.0;
        assert!((sum - 255.0).abs() <= 0.5001, "{sum}");
    }
}

#[test]
fn a_plane_names_the_textures() {
    let folder = set(&WHOLE);
    for (engine, cells) in [("three", 128), ("bevy", 1), ("gltf", 1)] {
        let said = bake(&folder, &format!("--for {engine} -o {engine}"));
        let text = std::fs::read_to_string(folder.path(engine).join("wall.gltf")).expect("a glTF");
        let gltf: Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!(gltf["accessors"][4]["count"], 6 * cells * cells);
        let images = gltf["images"].as_array().expect("a list");
        assert_eq!(images.len(), 4, "{engine}");
        for image in images {
            let uri = image["uri"].as_str().expect("a name");
            assert!(folder.path(engine).join(uri).is_file(), "{uri}");
        }
        let displacement = &gltf["materials"][0]["extras"]["displacement"];
        assert_eq!((&displacement["scale_m"], &displacement["bias_m"]), (&json!(0.04), &json!(-0.04)));
        let shown = picture(&folder, &format!("{engine}/wall.gltf"), "--view top");
        assert!(shown.pixels().any(|pixel| pixel != shown.get_pixel(0, 0)));
        let note = std::fs::read_to_string(folder.path(engine).join(format!("wall.{engine}.txt")));
        let note = note.expect("a text");
        for file in said["textures"].as_array().expect("a list") {
            assert!(note.contains(file["file"].as_str().expect("a name")), "{note}");
        }
        for name in said["settings"].as_object().expect("settings").keys() {
            assert!(note.contains(name), "{note}");
        }
    }
}

#[test]
fn a_height_map_alone_is_a_material_too() {
    let folder = Folder::new();
    folder.write("hills_height.png", hills().png());
    folder.relief("bake hills_height.png --for unreal --scale 5cm --tile-size 2,2 -o out").fine();
    let note = std::fs::read_to_string(folder.path("out/hills.unreal.txt")).expect("a text");
    for part in ["T_hills_N.png", "T_hills_H.png", "Magnitude, in centimetres: 5", "Center: 1", "2 m wide"] {
        assert!(note.contains(part), "{part} is missing:\n{note}");
    }
    assert!(!folder.path("out/T_hills_BC.png").exists());
}

#[test]
fn what_is_missing_or_left_is_said() {
    let folder = set(&["Height", "Roughness", "Metalness", "Opacity"]);
    let ran = folder.relief("bake wall --for godot -o out");
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    for part in [
        "note: the textures wall have no map of: base colour, occlusion\n",
        "wall_Opacity.png (opacity is not written)",
        "note: normals are baked from the heights\n",
        "note: maps of other sizes are resampled to 96x96, to share a file\n",
    ] {
        assert!(ran.stderr.contains(part), "{part} is missing:\n{}", ran.stderr);
    }
    // A green that no name tells, and that does not fit.
    let folder = set(&["Height"]);
    folder.write("wall/wall_Normal.png", normals(GreenSign::MinusY));
    let ran = folder.relief("bake wall --for godot -o out");
    assert!(ran.stderr.contains("give --green -y"), "{}", ran.stderr);
    let ran = folder.relief("bake wall --for godot --green -y -o out");
    assert!(ran.code == Some(0) && !ran.stderr.contains("--green"), "{}", ran.stderr);
    let about =
        json_of(&folder.relief("inspect wall/wall_Height.png --normal out/wall_normal.png --json").fine());
    assert_eq!(about["detection"]["green"], "+y");
}

#[test]
fn files_are_written_whole_and_only_when_they_are_out_of_date() {
    let folder = set(&["Height", "Color", "NormalGL"]);
    assert_eq!(bake(&folder, "--for unity -o out")["up_to_date"], json!(false));
    assert_eq!(bake(&folder, "--for unity -o out")["up_to_date"], json!(true));
    assert_eq!(bake(&folder, "--for unity -o out --force")["up_to_date"], json!(false));
    folder.write("wall/wall_Color.png", colours([0.0, 1.0]));
    assert_eq!(bake(&folder, "--for unity -o out")["up_to_date"], json!(false));
    // A texture that the set no longer has goes.
    std::fs::remove_file(folder.path("wall/wall_Color.png")).expect("it was there");
    bake(&folder, "--for unity -o out");
    assert!(!folder.path("out/wall_BaseMap.png").exists());
    // Files of other programs stay.
    folder.write("other/wall_Normal.png", normals(GreenSign::PlusY));
    let ran = folder.relief("bake wall --for unity -o other");
    assert!(ran.code == Some(1) && ran.stderr.contains("--force"), "{}", ran.stderr);
    let entries = std::fs::read_dir(folder.path("other")).expect("a folder").count();
    assert_eq!(entries, 1);
}

#[test]
fn maps_are_named_over_the_names_in_a_folder() {
    let folder = set(&["Height", "Color", "NormalGL", "Roughness"]);
    folder.write("given.png", colours([0.0, 1.0]));
    folder.write("metal.png", grey([1.0, 2.0], [0.0, 1.0], SIDE));
    let read = |path: &str| image::open(folder.path(path)).expect("a picture");
    let said = bake(&folder, "--for gltf --color given.png --metallic metal.png --normal none -o out");
    let note = |of: &Value, part: &str| of["notes"].to_string().contains(part);
    assert!(note(&said, "base colour from given.png") || note(&said, "colour from given.png"), "{said:#}");
    assert!(note(&said, "normals are baked"), "{said:#}");
    assert_eq!(read("out/wall_basecolor.png").to_rgb8(), read("given.png").to_rgb8());
    let metalness = read("metal.png").to_luma8();
    let orm = read("out/wall_orm.png").to_rgb8();
    assert!(orm.pixels().zip(metalness.pixels()).all(|(orm, metal)| orm[2] == metal[0]));
    // A height map that no name tells is named, with what to do.
    folder.write("lone/rock.png", hills().png());
    let ran = folder.relief("bake lone --for godot -o lone-out");
    assert!(
        ran.code == Some(1) && ran.stderr.contains("rock.png") && ran.stderr.contains("--height"),
        "{}",
        ran.stderr
    );
    folder.relief("bake lone --for godot --height lone/rock.png -q -o lone-out").fine();
    assert_eq!(read("lone-out/lone_height.png").to_luma8(), hills_8());
    // A height map alone takes maps, too.
    folder.relief("bake lone/rock.png --for godot --color given.png -q -o rock").fine();
    assert!(folder.path("rock/rock_albedo.png").exists());
    for (line, part) in [
        ("bake lone/rock.png --kind normal --color given.png -o x", "add --for"),
        ("bake lone/rock.png --for godot --height metal.png -o x", "already"),
        ("bake lone/rock.png --for godot --roughness a.png --glossiness b.png -o x", "cannot be used with"),
    ] {
        let ran = folder.relief(line);
        assert!(ran.code == Some(2) && ran.stderr.contains(part), "relief {line}: {}", ran.stderr);
    }
}

/// The hills with 8 bits.
fn hills_8() -> GrayImage {
    let map = hills();
    GrayImage::from_fn(SIDE, SIDE, |x, y| {
        Luma([(f64::from(map.texels[(y * SIDE + x) as usize]) / 257.0).round() as u8])
    })
}

#[test]
fn bad_input_gets_clear_errors() {
    let folder = set(&["Height", "Color"]);
    folder.write("two/a_Height.1001.png", hills().png());
    folder.write("two/a_Height.1002.png", hills().png());
    folder.write("empty/readme.txt", "");
    folder.write("bare/a_Color.png", colours([0.0, 1.0]));
    folder.write("bad/a_Height.png", hills().png());
    folder.write("bad/a_Roughness.png", "no picture");
    for (line, code, part) in [
        ("bake wall --for unrael -o out", 2, "did you mean 'unreal'?"),
        ("bake wall --for unreal --kind normal -o out", 2, "cannot be used with"),
        ("bake wall -o out", 2, "--kind"),
        ("bake wall --kind normal -o out", 2, "--for"),
        ("bake wall/wall_Height.png --kind normal --udim 1001 -o out", 2, "add --for"),
        ("bake wall/wall_Height.png --for godot --green -y -o out", 2, "folders of textures"),
        ("bake wall --for unreal -o out.png", 2, "give the name of a folder"),
        ("bake wall --for unreal -o wall", 2, "give another --output"),
        ("bake wall --for unreal -o wall/wall_Color.png", 2, "give the name of a folder"),
        ("bake two --for unreal -o out", 1, "use --udim"),
        ("bake two --for unreal --udim 1003 -o out", 1, "use --udim"),
        ("bake empty --for unreal -o out", 1, "give a folder of textures"),
        ("bake bare --for unreal -o out", 1, "has no height map"),
        ("bake bad --for unreal -o out", 1, "a_Roughness.png"),
        ("bake none --for unreal -o out", 1, "none"),
    ] {
        let ran = folder.relief(line);
        assert_eq!(ran.code, Some(code), "relief {line}: {}", ran.stderr);
        assert!(ran.stderr.contains(part), "relief {line}: {}", ran.stderr);
    }
    let left = std::fs::read_dir(folder.path("out")).map(|entries| entries.count()).unwrap_or(0);
    assert_eq!(left, 0);
    folder.relief("bake two --for unreal --udim 1002 -q -o out").fine();
    let ran = folder.relief("bake two --for godot --udim 1002 -q -o out");
    assert!(ran.stderr.contains("give each engine a folder of its own"), "{}", ran.stderr);
}
