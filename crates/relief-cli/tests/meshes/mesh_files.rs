//! `relief mesh`: its report on triangles, and the ways of storing them.

use crate::common::command::{Folder, json_of};
use crate::common::maps::{Map, encoded};
use crate::common::meshes::gltf;
use crate::common::refused::{assert_refused, with_out};
use image::{DynamicImage, ImageFormat, Rgb, RgbImage};
use relief_io::{MeshOptions, read_mesh};
use serde_json::{Value, json};

/// A folder with a map of hills.
fn folder() -> Folder {
    let folder = with_out();
    folder.write("hills.png", Map::many_hills().png());
    folder
}

#[test]
fn a_folder_of_textures_gives_heights_and_material() {
    let folder = folder();
    let colors = RgbImage::from_fn(8, 8, |x, y| Rgb([40 + 20 * x as u8, 200, 30 * y as u8]));
    folder.write("wall/wall_Height.png", Map::many_hills().png());
    folder.write("wall/wall_Color.png", encoded(&DynamicImage::ImageRgb8(colors), ImageFormat::Png));
    folder.write("wall/wall_Roughness.png", Map::constant(0.25).png());
    folder.write("wall/wall_Normal.png", Map::constant(0.5).png());
    let line = |flags: &str| folder.relief(&format!("mesh {flags} --scale 5cm --texels 2 -q"));
    line("wall -o out/set.glb").fine();
    line("hills.png --textures wall -o out/beside.glb").fine();
    line("hills.png -o out/plain.glb").fine();
    let read = |name: &str| std::fs::read(folder.path(name)).expect("a mesh");
    assert_eq!(read("out/set.glb"), read("out/beside.glb"));
    let options = MeshOptions { colors: true, materials: true, ..MeshOptions::default() };
    let [set, plain] = ["out/set.glb", "out/plain.glb"]
        .map(|name| read_mesh(folder.path(name).as_path(), &options).expect(name));
    assert_eq!(set.mesh.triangles().len(), plain.mesh.triangles().len());
    assert_eq!(set.mesh.measures().bounds_m, plain.mesh.measures().bounds_m);
    let colors = set.colors.expect("a material");
    let [material] = &colors.materials[..] else { panic!("one material") };
    let picture = material.picture.as_ref().expect("colours");
    assert_eq!(([picture.width, picture.height], material.values.roughness), ([8, 8], 1.0));
    let rough = material.values.textures.metallic_roughness.as_ref().expect("roughness");
    assert!((rough.texels[0][1] - 0.25).abs() < 0.01, "{:?}", rough.texels[0]);
    assert!(material.values.textures.normal.is_none() && material.values.metallic == 0.0);
    // Normals are baked from the heights, and other formats say that they hold no material.
    line("wall --maps normal -o out/shaded.glb").fine();
    let ran = folder.relief("mesh wall --scale 5cm -o out/set.stl");
    assert!(ran.code == Some(0) && ran.stderr.contains("STL cannot hold them"), "{}", ran.stderr);
    folder.write("bare/bare_Color.png", Map::constant(0.5).png());
    let ran = folder.relief("mesh bare -o out/none.glb");
    assert!(ran.code == Some(1) && ran.stderr.contains("has no height map"), "{}", ran.stderr);
}

#[test]
fn folds_are_told_with_the_triangles_that_they_are_on() {
    let folder = folder();
    let line = "mesh hills.png --mesh torus --tile 8,4 --texels 8 -o out/ring.glb";
    let fine = json_of(&folder.relief(&format!("{line} --scale 1cm --json")).fine());
    assert_eq!(fine["folds"]["triangles"], 0, "{fine}");
    let deep = json_of(&folder.relief(&format!("{line} --scale 2 --bias -2 --json")).fine());
    let count = |of: &Value| of.as_u64().unwrap_or_else(|| panic!("{deep}"));
    let folds = &deep["folds"];
    assert!(count(&folds["triangles"]) >= count(&folds["mesh_triangles"]), "{deep}");
    let first = folds["first"].as_array().expect("a list");
    assert!(!first.is_empty() && first[0]["middle_m"].as_array().is_some_and(|place| place.len() == 3));
    // In words, with what helps.
    let ran = folder.relief(&format!("{line} --scale 2 --bias -2"));
    let words = format!("{} triangles turned over", folds["triangles"]);
    assert!(ran.code == Some(0) && ran.stdout.contains(&words), "{}", ran.stdout);
    assert!(ran.stderr.contains("relief inspect") && ran.stderr.contains("--scale"), "{}", ran.stderr);
    assert!(!folder.relief(&format!("{line} --scale 1cm")).fine().stdout.contains("folds"));
}

#[test]
fn integers_are_a_smaller_file_with_a_greater_error() {
    let folder = folder();
    let made =
        |line: &str| json_of(&folder.relief(&format!("mesh hills.png --scale 0.1 {line} --json")).fine());
    let number =
        |about: &Value, name: &str| about[name].as_f64().unwrap_or_else(|| panic!("{name}: {about}"));
    let plain = made("-o out/plain.glb");
    let mut last = f64::INFINITY;
    for bits in [8, 12, 16] {
        let about = made(&format!("--quantize {bits} -o out/few.glb"));
        let moved = number(&about["quantized"], "greatest_m");
        assert!(moved < last && moved <= 0.867 * number(&about["quantized"], "step_m"), "{about}");
        last = moved;
        let more = number(&about["error"], "greatest_m") - number(&plain["error"], "greatest_m");
        assert!((more - moved).abs() < 1e-12, "{about}");
        assert!(number(&about, "bytes") < 0.85 * number(&plain, "bytes"), "{about}");
        assert_eq!(about["triangles"], plain["triangles"]);
        let found = json_of(&folder.relief("inspect out/few.glb --json").fine());
        let lost = number(&about["quantized"], "triangles_without_area");
        assert_eq!(number(&found, "triangles") + lost, number(&about, "triangles"), "{found}");
    }
    // In words, as large as it is printed, and in parts.
    let ran =
        folder.relief("mesh hills.png --print-size 80 --tiles 2x1 --quantize 14 -o out/part.glb").fine();
    assert!(ran.stdout.contains("quantised   to 14 bits") && ran.stdout.contains(" mm "), "{}", ran.stdout);
    assert!(ran.stdout.contains("rounding included"), "{}", ran.stdout);
    // A closed mesh stays closed, and its texture may go beyond 1.
    let ball = made("--mesh sphere --tile 3,2 --texels 2 --quantize 16 -o out/ball.glb");
    assert_eq!((&ball["open_edges"], &ball["quantized"]["uvs"]), (&json!(0), &json!("floats")), "{ball}");
    assert_eq!(plain["quantized"], Value::Null);
}

#[test]
fn files_that_cannot_be_are_refused() {
    let folder = folder();
    for (line, words) in [
        ("--quantize 7 -o out/a.glb", ["--quantize", "8..=16"]),
        ("--quantize 17 -o out/a.glb", ["--quantize", "8..=16"]),
        ("--quantize few -o out/a.glb", ["--quantize", "few"]),
        ("--quantize -9 -o out/a.glb", ["--quantize", "-9"]),
        ("--quantize 12 -o out/a.ply", ["--quantize", "GLB"]),
        ("--quantize 12 -o out/a.stl", ["--quantize", "GLB"]),
        ("--lods 1 -o out/a.glb", ["--lods", "2..=8"]),
        ("--lods 99 -o out/a.glb", ["--lods", "2..=8"]),
        ("--lods 3 -o out/a.obj", ["--lods", "GLB"]),
        ("--quantize 12 --side above -o out/a.glb", ["--quantize", "--side above"]),
    ] {
        let ran = folder.relief(&format!("mesh hills.png {line}"));
        assert_refused(&folder, &ran, 2, &words);
    }
}

#[test]
fn levels_of_detail_are_coarser_and_coarser() {
    let folder = folder();
    folder.write("view.toml", "height = 'hills.png'\neye = [0.3, 0.6, 1]\nsize = [320, 240]\n");
    for (flags, most) in [
        ("--mesh torus --tile 4,2 --texels 1 --scale 2cm", 0.3),
        ("--texels 1 --scale 0.1", 0.3),
        ("--view view.toml --pixels 1 --scale 0.1", 0.3),
        ("--error 0.2% --scale 0.1", 0.7),
        ("--triangles 8000 --scale 0.1", 0.3),
    ] {
        let line = format!("mesh hills.png {flags} --lods 3 --json -o out/a.glb");
        let about = json_of(&folder.relief(&line).fine());
        let lods = about["lods"].as_array().unwrap_or_else(|| panic!("{about}"));
        let number = |level: usize, name: &str| lods[level][name].as_f64();
        assert_eq!((lods.len(), &lods[0]["triangles"]), (3, &about["triangles"]), "{about}");
        for level in [1, 2] {
            let [here, before] = [level, level - 1].map(|level| number(level, "triangles").expect("a count"));
            assert!(here <= most * before && here > 0.15 * before, "{flags}: {here} of {before}");
            if let (Some(here), Some(before)) = (number(level, "greatest_m"), number(level - 1, "greatest_m"))
            {
                assert!(here > 1.3 * before, "{flags}: {about}");
            }
        }
        let found = json_of(&folder.relief("inspect out/a.glb --json").fine());
        assert_eq!(found["triangles"], about["triangles"], "{flags}");
    }
    // In parts, in integers, in words.
    let parts = "mesh hills.png --error 0.2% --scale 0.1 --tiles 2x1 --quantize 15 --lods 2 -o out/part.glb";
    let ran = folder.relief(parts).fine();
    assert!(ran.stdout.contains("level 0") && ran.stdout.contains("level 1"), "{}", ran.stdout);
    assert!(!ran.stdout.contains("level 2"), "{}", ran.stdout);
    // A level that is not coarser is refused, and nothing is written.
    let ran = folder.relief("mesh hills.png --mesh sphere --texels 64 --lods 8 -o out/none.glb");
    assert!(ran.code == Some(1) && ran.stderr.contains("--lods"), "{}", ran.stderr);
    assert!(!folder.path("out/none.glb").exists());
}

/// Files that belong to an input are not replaced either: buffers and pictures of a mesh, pictures
/// of a depth object, and files that a scene names.
#[test]
fn what_a_file_names_is_not_replaced() {
    let folder = with_out();
    folder.write("h.png", Map::hills().png());
    let (json, buffer) = gltf("color.png", "b.glb");
    folder.write("m.gltf", json);
    folder.write("b.glb", buffer);
    folder.write("color.png", Map::hills().png());
    folder.write("s.toml", "height = 'h.png'\nmesh = 'm.gltf'\n");
    folder.relief("mesh h.png -o plane.glb -q").fine();
    folder.write("p.toml", "height = 'h.png'\nmesh = 'plane.glb'\n");
    folder.relief("capture cube --size 16 --verify 0 --cover centre -q -o o").fine();
    for (line, read) in [
        ("render --height h.png --mesh m.gltf -o color.png", "color.png"),
        ("render s.toml -o color.png", "color.png"),
        ("render --object o/object.toml -o o/normal.png", "o/normal.png"),
        ("render --object o/object.toml --aov o/depth.exr -o out/p.png", "o/depth.exr"),
        ("mesh h.png --mesh m.gltf -o b.glb", "b.glb"),
        ("slices p.toml -o plane.glb", "plane.glb"),
        ("slices s.toml -o b.glb", "b.glb"),
        ("height from-meshes --low m.gltf --high cube --size 8x8 -o color.png", "color.png"),
        (
            "height from-meshes --low cube --high m.gltf --size 8x8 -o out/h.exr --normals color.png",
            "color.png",
        ),
        ("height from-view o/object.toml --view 1 -o o/depth.exr", "o/depth.exr"),
        ("height for-mesh h.png --mesh m.gltf --lift -o color.png", "color.png"),
    ] {
        let path = folder.path(read);
        let before = std::fs::read(&path).expect("it is there");
        assert_refused(&folder, &folder.relief(line), 2, &["would replace the input", read]);
        assert!(before == std::fs::read(&path).expect("it is there"), "{line}");
    }
    // A picture inside of a file is no other file's.
    folder.relief("render --height h.png --mesh plane.glb --size 8x8 -q -o out/plane.png").fine();
}

#[test]
fn finer_pixels_give_more_triangles_or_are_refused() {
    let folder = with_out();
    folder.write("h.png", Map::hills().png());
    folder.write("s.toml", "height = 'h.png'\n");
    folder.write("wide.toml", "height = 'h.png'\nsize = [32768, 16]\n");
    folder.write("far.toml", "height = 'h.png'\nfov = 0.2\neye = [0, 300, 1]\ntarget = [0, 0, 0]\n");
    let triangles = |line: &str| {
        let about = json_of(&folder.relief(&format!("mesh h.png {line} --json -o m.ply")).fine());
        about["triangles"].as_u64().unwrap_or_else(|| panic!("{about}"))
    };
    for scene in ["s.toml", "far.toml"] {
        let counts = ["16", "8", "4"].map(|pixels| triangles(&format!("--view {scene} --pixels {pixels}")));
        assert!(counts.is_sorted() && counts[0] < counts[2], "{scene}: {counts:?}");
    }
    for (scene, pixels) in [("s.toml", "0.01"), ("s.toml", "0.001"), ("far.toml", "0.001")] {
        let line = format!("mesh h.png --view {scene} --pixels {pixels} --max-memory 256MiB -o out/m.ply");
        assert_refused(&folder, &folder.relief(&line), 1, &[]);
    }
    for (scene, pixels) in
        [("s.toml", "0.0001"), ("s.toml", "0.00001"), ("far.toml", "0.000000001"), ("wide.toml", "0.06")]
    {
        let line = format!("mesh h.png --view {scene} --pixels {pixels} --max-memory 256MiB -o out/m.ply");
        assert_refused(&folder, &folder.relief(&line), 1, &["--pixels", pixels, "at least"]);
    }
}
