//! `relief mesh`: what it says of its triangles, and the ways in which it stores them.

mod common;

use common::command::{Folder, json_of};
use common::maps::Map;
use common::refused::{assert_refused, with_out};
use serde_json::{Value, json};

/// A folder with a map of hills.
fn folder() -> Folder {
    let folder = with_out();
    folder.write("hills.png", Map::many_hills().png());
    folder
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
    assert!(ran.stdout.contains("its rounding counted"), "{}", ran.stdout);
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
        ("--quantize 12 --side above -o out/a.glb", ["--quantize", "--side above"]),
    ] {
        let ran = folder.relief(&format!("mesh hills.png {line}"));
        assert_refused(&folder, &ran, 2, &words);
    }
}
