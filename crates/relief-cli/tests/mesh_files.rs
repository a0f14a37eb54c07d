//! `relief mesh`: what it says of its triangles, and the ways in which it stores them.

mod common;

use common::command::{Folder, json_of};
use common::maps::Map;
use common::refused::with_out;

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
    let count = |of: &serde_json::Value| of.as_u64().unwrap_or_else(|| panic!("{deep}"));
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
