//! `relief compare`: files and refusals.

use crate::common::command::{Folder, json_of};
use crate::common::maps::Map;
use crate::common::refused::{assert_refused, with_out};
use serde_json::Value;

/// Flags of a comparison that takes a moment.
const SMALL: &str = "--quick --rays 50 --size 16x12 --samples 1 --angles 30 --backend cpu";

fn folder() -> Folder {
    let folder = Folder::new();
    folder.write("map.png", Map::constant(0.5).png());
    folder
}

#[test]
fn a_page_and_the_same_figures_for_programs_are_written() {
    let folder = folder();
    let line = format!("compare --height map.png --methods relief,linear+true-secant,vertex {SMALL}");
    let files = "-o page.html --records all.json --csv all.csv";
    let ran = folder.relief(&format!("{line} {files}")).fine();
    for name in ["page.html", "all.json", "all.csv"] {
        assert!(ran.stdout.contains(name), "{}", ran.stdout);
    }
    let read = |name: &str| std::fs::read_to_string(folder.path(name)).expect("a file");
    let records: Value = serde_json::from_str(&read("all.json")).expect("JSON");
    let count = |key: &str| records[key].as_array().map(Vec::len);
    // Two scales; displaced triangles have pictures alone.
    assert_eq!((count("rays"), count("pictures"), count("left_out")), (Some(4), Some(6), Some(0)));
    assert_eq!(read("all.csv").lines().count(), 11);
    let page = read("page.html");
    assert!(page.starts_with("<!DOCTYPE html>") && page.contains("linear+true-secant"));
    // Names stand on pictures, methods have a sentence, and differences a legend.
    assert!(page.contains(r#"<span class="name">vertex</span>"#));
    assert!(page.contains("Relief mapping: linear, then binary search.") && page.contains("Search: "));
    assert!(page.contains("FLIP difference from the reference") && page.contains("1: the greatest"));
    // Methods that follow rays have a drawing.
    assert_eq!(page.matches("data:image/svg+xml;base64,").count(), 2);
    assert!(page.contains("went through") && !page.contains("passed %"));
    assert!(ran.stdout.contains("went through %"), "{}", ran.stdout);
    assert!(
        records["about"]["command"].as_str().is_some_and(|command| command.contains("--records all.json"))
    );
    assert_eq!(records["about"]["map"], "map");

    let printed = json_of(&folder.relief(&format!("{line} -o again.html --json")).fine());
    assert_eq!(printed["rays"], records["rays"]);
}

#[test]
fn without_a_map_the_sample_is_compared_and_the_page_has_a_name() {
    let folder = Folder::new();
    let answer = json_of(&folder.relief(&format!("compare --methods bump {SMALL} --json")).fine());
    assert_eq!((&answer["about"]["map"], &answer["about"]["map_size"][0]), (&"cobbles".into(), &256.into()));
    assert!(folder.path("comparison.html").is_file());
}

#[test]
fn a_folder_of_textures_is_compared_by_its_heights_and_name() {
    let folder = folder();
    folder.write("stones/Stones_Height.png", Map::hills().png());
    folder.write("hills.png", Map::hills().png());
    let figures = |of: &str| {
        let line = format!("compare {of} --methods relief {SMALL} --scales 0.1 -o page.html --json -q");
        json_of(&folder.relief(&line))
    };
    let [map, set] = ["--height hills.png", "stones"].map(figures);
    assert_eq!(
        (&set["about"]["map"], &set["about"]["map_size"]),
        (&"stones".into(), &map["about"]["map_size"])
    );
    let reads = |figures: &Value| figures["rays"][0]["reads"].clone();
    assert!(reads(&set).is_number() && reads(&set) == reads(&map), "{set:#}");
    let page = std::fs::read_to_string(folder.path("page.html")).expect("a page");
    assert!(page.contains("Displacement methods on stones"));
}

#[test]
fn eight_methods_are_compared_unless_others_are_named() {
    let folder = folder();
    let methods = |flags: &str| {
        let line = format!("compare --height map.png {flags} {SMALL} --scales 0.1 -o page.html --json");
        let answer = json_of(&folder.relief(&line));
        let pictures = answer["pictures"].as_array().expect("records").clone();
        pictures
            .iter()
            .map(|record| record["method"].as_str().expect("a name").to_owned())
            .collect::<Vec<_>>()
    };
    let usual = ["bump", "parallax", "relief", "occlusion", "exact", "cone", "quadtree", "vertex"];
    assert_eq!(methods(""), usual);
    assert!(methods("--methods all").len() > 20 && methods("--geometry ray").len() > 20);
}

#[test]
fn a_scene_keeps_its_scale_and_settings_go_to_the_methods_that_have_them() {
    let folder = folder();
    folder.write("s.toml", "height = 'map.png'\nscale = 0.02\nsize = [16, 12]\nsamples = 1\n");
    let line = "compare s.toml --methods relief,steep,bump --set search.steps=4 --quick --rays 50 \
                --backend cpu --json";
    let answer = json_of(&folder.relief(line).fine());
    let rays = answer["rays"].as_array().expect("records");
    assert!(rays.iter().all(|record| record["scale_m"] == 0.02));
    let turns = |method: &str| {
        let of_method = rays.iter().filter(|record| record["method"] == method);
        of_method.map(|record| record["turns"].as_f64().expect("a number")).fold(0.0, f64::max)
    };
    assert!(turns("steep") <= 4.0 && turns("steep") > 0.0 && turns("bump") == 0.0);
    let of_rays =
        json_of(&folder.relief(&format!("compare s.toml --geometry ray,vertex {SMALL} --json")).fine());
    let geometries =
        of_rays["pictures"].as_array().expect("records").iter().map(|record| &record["geometry"]);
    let mut geometries: Vec<&str> = geometries.filter_map(Value::as_str).collect();
    geometries.dedup();
    assert_eq!(geometries, ["none", "vertex"]);
}

#[test]
fn shadows_distances_and_formats_are_compared_and_told() {
    let folder = folder();
    let line = format!(
        "compare --height map.png --methods bump,cone --shadow none,ray,horizon --set shadow.azimuths=8 \
         --texels float,unorm8 --distances 1,2 {SMALL} --json"
    );
    let answer = json_of(&folder.relief(&line).fine());
    let pictures = answer["pictures"].as_array().expect("records");
    // At two scales and from two distances; of bumps the horizon alone is a map.
    assert_eq!(pictures.len(), 2 * 2 * (2 * 3 + 3 + 1));
    let words = |key: &str| {
        let mut words: Vec<String> = pictures.iter().map(|record| record[key].to_string()).collect();
        words.sort();
        words.dedup();
        words
    };
    assert_eq!(words("shadow"), ["\"horizon\"", "\"none\"", "\"ray\""]);
    assert_eq!(words("map_format"), ["\"float\"", "\"unorm8\"", "null"]);
    assert_eq!(words("distance_m"), ["1.0", "2.0"]);
    let ran = folder.relief(&line.replace(" --json", " --max-error 9").replace("--texels float,unorm8", ""));
    assert!(ran.stdout.contains("--shadow "), "{}", ran.stdout);
}

#[test]
fn a_scene_of_several_surfaces_is_compared() {
    let folder = folder();
    folder.write("two.toml", "height = 'map.png'\n[[surfaces]]\n[[surfaces]]\nposition = [2, 0, 0]\n");
    let ran = folder.relief(&format!("compare two.toml --methods bump,cone {SMALL} --csv all.csv"));
    assert!(ran.code == Some(0) && ran.stderr.contains("2 surfaces"), "{}", ran.stderr);
    let values = std::fs::read_to_string(folder.path("all.csv")).expect("a file");
    assert_eq!(values.lines().count(), 3);
}

#[test]
fn what_cannot_be_compared_is_told_and_nothing_is_written() {
    let folder = with_out();
    folder.write("map.png", Map::constant(0.5).png());
    folder.write("two.toml", "height = 'map.png'\n[[surfaces]]\n[[surfaces]]\nposition = [2, 0, 0]\n");
    folder.write("taken.html/file", "a folder");
    let refused = [
        ("--methods paralax", 2, "parallax"),
        ("--methods linear+binry", 2, "binary"),
        ("--methods none+binary-", 2, "binary"),
        ("--method cone", 2, "--methods"),
        ("--search linear --refine binary", 2, "--methods"),
        ("--geometry vertx", 2, "vertex"),
        ("--geometry vertex --methods cone", 2, "methods"),
        ("--angles 90", 2, "90"),
        ("--angles -1", 2, "--angles"),
        ("--angles NaN", 2, "--angles"),
        ("--angles 89.9999999999", 2, "--angles"),
        ("--angles 30,89.99999999", 2, "89.99999999"),
        ("--scales 1e30", 2, "--scales"),
        ("--scales 0.1,1e12", 2, "1000000000000"),
        ("--scales 0", 2, "--scales"),
        ("--scales inf", 2, "--scales"),
        ("--scales -0.1", 2, "--scales"),
        ("--scales 0.1 --scale 0.2", 2, "--scale"),
        ("--steps 0", 2, "--steps"),
        ("--steps x", 2, "--steps"),
        ("--map-sizes 5", 2, "--map-sizes"),
        ("--rays -1", 2, "--rays"),
        ("--rays 0", 2, "--rays"),
        ("--rays 100000000", 1, "--max-memory"),
        ("--size 16384x16384", 1, "--max-memory"),
        ("--size 0x12", 2, "--size"),
        ("--size 99999x12", 2, "--size"),
        ("--backend auto", 2, "--backend"),
        ("--backend vulkan", 2, "--backend"),
        ("--set search.nothing=1", 2, "search.nothing"),
        ("--height missing.png", 1, "missing.png"),
        ("--shadow ray,horizn", 2, "horizon"),
        ("--shadow ray,none --set shadow.azimuths=8", 2, "shadow.azimuths"),
        ("--shadow ray,horizon --set shadow.azimuths=-8", 2, "shadow.azimuths"),
        ("--distances 0", 2, "--distances"),
        ("--distances NaN", 2, "--distances"),
        ("--distances 1 --projection orthographic", 2, "--distances"),
        ("--texels byte", 2, "unorm8"),
        ("--texels half --budget-ms 5", 2, "--texels"),
        ("two.toml --budget-ms 5", 2, "one surface"),
        ("-o no/page.html", 1, "no folder"),
        ("-o taken.html", 1, "folder"),
        ("-o page.txt", 2, "html"),
        ("--records map.png", 2, "json"),
        ("--csv a.csv -o a.csv", 2, "html"),
    ];
    for (flags, code, word) in refused {
        let map = if flags.contains("--height") || flags.contains("toml") { "" } else { "--height map.png" };
        let small = if flags.contains("--size") { "--quick --rays 50 --backend cpu" } else { SMALL };
        let small =
            if flags.contains("--angles") { small.replace("--angles 30", "") } else { small.to_owned() };
        let small = if flags.contains("--backend") { small.replace("--backend cpu", "") } else { small };
        let small = if flags.contains("--rays") { small.replace("--rays 50", "") } else { small };
        let output = if flags.contains("-o ") { "" } else { "-o out/page.html" };
        let ran = folder.relief(&format!("compare {map} {small} {flags} {output}"));
        assert_refused(&folder, &ran, code, &[word]);
    }
    let mut left: Vec<_> = std::fs::read_dir(folder.path(""))
        .expect("a folder")
        .flatten()
        .map(|entry| entry.file_name())
        .collect();
    left.sort();
    assert_eq!(left, ["map.png", "out", "taken.html", "two.toml"]);
}

#[test]
fn a_method_is_chosen_for_an_error_or_a_time() {
    let folder = folder();
    // Only one of these two finds the surface, so the choice does not depend on measured times.
    let line = format!("compare --height map.png --methods bump,cone {SMALL}");
    let ran = folder.relief(&format!("{line} --max-error 0.01")).fine();
    assert!(ran.stdout.contains("relief render --height map.png --method cone"), "{}", ran.stdout);
    let ran = folder.relief(&format!("{line} --budget-ms 60000")).fine();
    assert!(ran.stdout.contains("--method cone") && ran.stdout.contains("bump"), "{}", ran.stdout);
    // The printed command can be run.
    let printed = ran.stdout.lines().find_map(|line| line.strip_prefix("relief ")).expect("a command");
    folder.relief(&format!("{printed} --size 16x12 -q")).fine();

    let none = folder.relief(&format!("{line} --budget-ms 0.000001"));
    assert_eq!(none.code, Some(1));
    assert!(none.stderr.contains("the nearest is"), "{}", none.stderr);
    // The page is written all the same, as both helps say.
    let page = std::fs::metadata(folder.path("comparison.html")).expect("it was written");
    assert!(page.len() > 1000);
    for help in ["--help", "compare --help"] {
        let said = folder.relief(help).fine().stdout.split_whitespace().collect::<Vec<_>>().join(" ");
        let codes = &said[said.find("xit code").expect("what codes mean")..];
        assert!(said.contains("--budget-ms") && codes.contains('1'), "{said}");
    }
    for flags in ["--budget-ms 0", "--max-error NaN", "--budget-ms 1 --max-error 1"] {
        assert_eq!(folder.relief(&format!("{line} {flags}")).code, Some(2), "{flags}");
    }
}
