//! `relief explain`: drawings, their turns, and refusals.

use std::collections::BTreeSet;

use crate::common::command::{Folder, json_of};
use crate::common::maps::Map;
use crate::common::refused::{OUT, assert_refused, entries};
use serde_json::Value;

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("map.png", Map::hills().png());
    folder
}

/// The numbers of marks of a kind.
fn count(about: &Value, kind: &str) -> usize {
    let marks = ["search", "refinement"].map(|part| about[part].as_array().expect("marks"));
    marks.into_iter().flatten().filter(|mark| !mark[kind].is_null()).count()
}

#[test]
fn turns_are_told_and_drawn() {
    let folder = folder();
    for (method, kind) in [
        ("relief", "bracket"),
        ("cone", "cone"),
        ("quadtree", "box"),
        ("sphere-tracing", "ball"),
        ("frustum", "frustum"),
        ("secant-search", "chord"),
        ("parallax-slope", "plane"),
        ("exact", "patch"),
    ] {
        let line = format!("explain map.png --scale 0.2 --method {method} --no-cache -o {method}.svg --json");
        let about = json_of(&folder.relief(&line).fine());
        assert_eq!(about["turns"].as_u64(), Some(count(&about, "turn") as u64), "{method}");
        assert!(count(&about, kind) > 0, "{method}: {about:#}");
        let svg = std::fs::read_to_string(folder.path(format!("{method}.svg"))).expect("a drawing");
        assert!(svg.starts_with("<svg") && svg.trim_end().ends_with("</svg>"), "{method}");
    }
}

#[test]
fn each_turn_gets_a_drawing_and_both_formats_are_written() {
    let folder = folder();
    let line = "explain map.png --scale 0.2 --search linear --refine binary --no-cache --frames";
    let about = json_of(&folder.relief(&format!("{line} -o cut.svg --json")).fine());
    let turns = about["turns"].as_u64().expect("turns") as usize;
    let digits = turns.to_string().len();
    let mut named: BTreeSet<String> = (1..=turns).map(|turn| format!("cut-{turn:0digits$}.svg")).collect();
    named.extend(["cut.svg".to_owned(), "map.png".to_owned()]);
    let written: BTreeSet<String> = entries(&folder.path("")).into_iter().collect();
    assert_eq!(written, named);
    let read = |name: &str| std::fs::read(folder.path(name)).expect("a drawing");
    let (first, last) = (format!("cut-{:0digits$}.svg", 1), format!("cut-{turns}.svg"));
    assert_ne!(read(&first), read(&last));
    folder.relief("explain map.png --scale 0.2 --no-cache -o cut.png").fine();
    let picture = image::load_from_memory(&read("cut.png")).expect("a PNG").to_rgb8();
    // Ground, paper and ink are there.
    for color in [[214, 205, 190], [255, 255, 255], [40, 40, 40]] {
        assert!(picture.pixels().filter(|pixel| pixel.0 == color).count() > 100, "{color:?}");
    }
}

#[test]
fn a_folder_of_textures_gives_its_own_heights() {
    let folder = folder();
    folder.write("stones/Stones_Height.png", Map::hills().png());
    folder.write("stones/Stones_Color.png", Map::constant(0.7).png());
    let drawn = |of: &str| {
        let line = format!("explain {of} --scale 0.2 --method relief --no-cache -q -o cut.svg --json");
        let about = json_of(&folder.relief(&line).fine());
        (
            about["t"].clone(),
            about["reads"].clone(),
            std::fs::read(folder.path("cut.svg")).expect("a drawing"),
        )
    };
    let of_map = drawn("map.png");
    assert_eq!(drawn("stones"), of_map);
    assert_eq!(drawn("--textures stones"), of_map);
    // The sample map has another hit.
    assert_ne!(drawn("").2, of_map.2);
    let ran = folder.relief("explain stones --method relief --no-cache -o cut.svg");
    assert!(ran.code == Some(0) && ran.stderr.contains("height from Stones_Height.png"), "{}", ran.stderr);
}

#[test]
fn methods_without_a_search_say_so() {
    let folder = folder();
    let ran = folder.relief("explain map.png --scale 0.2 --method bump -o cut.svg").fine();
    assert!(ran.stdout.contains("no search"), "{}", ran.stdout);
}

#[test]
fn what_cannot_be_drawn_is_refused_and_leaves_no_file() {
    let folder = folder();
    std::fs::create_dir(folder.path(OUT)).expect("a folder");
    for (flags, output, code, says) in [
        ("--angle 90", "cut.svg", 2, "--angle"),
        ("--angle nan", "cut.svg", 2, "--angle"),
        ("--at nan,0", "cut.svg", 2, "--at"),
        ("--radius 0", "cut.svg", 2, "--radius"),
        ("--scale 0", "cut.svg", 2, "--scale"),
        ("--method vertex", "cut.svg", 2, "another method"),
        ("--method sphere", "cut.svg", 2, "sphere-tracing"),
        ("--angle 60", "cut.gif", 2, "svg, png"),
        ("--angle 60", "no/cut.svg", 1, "no folder"),
    ] {
        let ran = folder.relief(&format!("explain map.png --no-cache {flags} -o {OUT}/{output}"));
        assert_refused(&folder, &ran, code, &[says]);
    }
    // The drawing of the first turn would have the map's name.
    folder.write("map-1.png", Map::hills().png());
    let line = "explain map-1.png --scale 0.2 --search none --refine binary --no-cache --frames -o map.png";
    let before = std::fs::read(folder.path("map.png")).expect("the map");
    assert_refused(&folder, &folder.relief(line), 2, &["--frames", "map-1.png"]);
    assert_eq!(std::fs::read(folder.path("map.png")).expect("the map"), before);
}
