//! Elevation models on the command line: their holes, their edges, and what is said of them.

mod common;

use std::path::PathBuf;

use common::command::Folder;
use common::files::{Samples, exr, georeference, tiff};
use serde_json::{Value, json};

const SIZE: [u32; 2] = [24, 16];

/// An elevation model of hills with a hole of two texels.
fn dem(holes: bool) -> Vec<u8> {
    let height = |at: u32| match at {
        100 | 101 if holes => -9999.0f32,
        _ => 200.0 + (at % 24 * 7 + at / 24 * 5) as f32,
    };
    let data: Vec<u8> = (0..SIZE[0] * SIZE[1]).flat_map(|at| height(at).to_le_bytes()).collect();
    tiff(SIZE, Samples::Float, &data, &georeference())
}

fn json_of(text: &str) -> Value {
    serde_json::from_str(text).expect("JSON")
}

#[test]
fn a_mesh_of_one_has_holes_where_they_are_asked_for() {
    let folder = Folder::new();
    folder.write("dem.tif", dem(true));
    folder.write("whole.tif", dem(false));
    let count = |line: &str| {
        let about = json_of(&folder.relief(&format!("mesh {line} -o out.glb --json")).fine().stdout);
        ["triangles", "open_edges"].map(|key| about[key].as_u64().expect("a number"))
    };
    // Two texels beside each other are at the corners of six cells: two triangles each, ten sides around
    // them.
    let [filled, holes] = ["", " --holes"].map(|flag| count(&format!("dem.tif --texels 1{flag}")));
    assert_eq!(holes, [filled[0] - 12, filled[1] + 10]);
    let [filled, holes] = ["", " --holes"].map(|flag| count(&format!("dem.tif --error 1%{flag}")));
    assert!(holes[1] >= filled[1] + 10 && holes != filled, "{holes:?} {filled:?}");
    // Nothing is left out of a map without holes, and its reader is told.
    assert_eq!(count("whole.tif --texels 1 --holes"), count("whole.tif --texels 1"));
    let ran = folder.relief("mesh whole.tif --holes -o out.glb");
    assert!(ran.code == Some(0) && ran.stderr.contains("there are no holes"), "{}", ran.stderr);
    let ran = folder.relief("mesh dem.tif --holes --solid 3 -o out.glb");
    assert!(ran.code == Some(1) && ran.stderr.contains("--solid"), "{}", ran.stderr);
    let nothing = (0..16).map(|_| f32::NAN).collect();
    folder.write("nothing.exr", exr([4, 4], &[("Y", nothing)]));
    let ran = folder.relief("mesh nothing.exr --holes -o nothing.glb");
    assert!(ran.code == Some(1) && !folder.path("nothing.glb").exists(), "{}", ran.stderr);
    folder.write(
        "most.exr",
        exr([4, 4], &[("Y", (0..16).map(|at| if at % 2 == 1 { f32::NAN } else { 1.0 }).collect())]),
    );
    let ran = folder.relief("mesh most.exr --holes --texels 1 --wrap repeat --tile 0.25,1 -o most.glb");
    assert!(ran.code == Some(1) && ran.stderr.contains("--holes"), "{}", ran.stderr);
}

#[test]
fn a_picture_of_one_with_holes_is_rendered_and_says_so() {
    let folder = Folder::new();
    folder.write("dem.tif", dem(true));
    folder.write("whole.tif", dem(false));
    let line = "render --backend cpu --size 64x48 -o out.png --height";
    let ran = folder.relief(&format!("{line} dem.tif"));
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let note = "note: dem.tif: 2 of its texels have no value; they are filled from their surroundings\n";
    assert_eq!(ran.stderr, note);
    assert!(!ran.stdout.contains("no pixel"), "{}", ran.stdout);
    folder.relief(&format!("{line} whole.tif")).fine();
    folder.relief(&format!("{line} dem.tif --fill")).fine();

    let about = json_of(&folder.relief(&format!("{line} dem.tif --json")).fine().stdout);
    let surface = &about["surfaces"][0];
    assert_eq!((&surface["filled_texels"], &surface["wrap"]), (&json!(2), &json!("clamp")));
    assert!(about["covered"].as_u64().is_some_and(|covered| covered > 100), "{about}");
    let about = json_of(&folder.relief(&format!("{line} whole.tif --wrap repeat --json")).fine().stdout);
    let surface = &about["surfaces"][0];
    assert_eq!((&surface["filled_texels"], &surface["wrap"]), (&json!(0), &json!("repeat")));

    // Holes that are seen through are filled in files of all kinds, and a map without any is said to be.
    let covered = |line: &str| json_of(&folder.relief(line).fine().stdout)["covered"].as_u64();
    let [filled, holes] =
        ["", " --holes"].map(|flag| covered(&format!("{line} dem.tif --samples 1 --json{flag}")));
    assert!(holes < filled && holes > Some(100), "{holes:?} {filled:?}");
    let ran = folder.relief(&format!("{line} dem.tif --holes"));
    assert_eq!((ran.code, ran.stderr.matches("2 of its texels").count()), (Some(0), 1), "{}", ran.stderr);
    let ran = folder.relief(&format!("{line} whole.tif --holes"));
    assert_eq!((ran.code, ran.stderr.lines().count()), (Some(0), 1), "{}", ran.stderr);
    assert!(ran.stderr.contains("whole.tif"), "{}", ran.stderr);
    let texels = (0..16).map(|at| if at == 5 { f32::NAN } else { at as f32 }).collect();
    folder.write("map.exr", exr([4, 4], &[("Y", texels)]));
    folder.write("holes.toml", "height = 'map.exr'\nholes = true\nbackend = 'cpu'\n");
    assert_eq!(folder.relief("render holes.toml -o out.png").code, Some(0));
    folder.write("holes.toml", "height = 'map.exr'\nholes = true\nfill = false\nbackend = 'cpu'\n");
    assert_eq!(folder.relief("render holes.toml -o out.png").code, Some(1));
    folder.write("holes.toml", "height = 'map.exr'\nholes = 1\n");
    let ran = folder.relief("render holes.toml -o out.png");
    assert!(ran.code == Some(1) && ran.stderr.contains("holes.toml"), "{}", ran.stderr);

    // A scene may refuse holes.
    folder.write("scene.toml", "height = 'dem.tif'\nfill = false\nbackend = 'cpu'\n");
    let ran = folder.relief("render scene.toml -o out.png");
    assert_eq!(ran.code, Some(1));
    assert!(ran.stderr.contains("dem.tif") && ran.stderr.contains("--fill"), "{}", ran.stderr);
}

#[test]
fn a_bake_of_one_with_holes_asks_for_the_flag() {
    let folder = Folder::new();
    folder.write("dem.tif", dem(true));
    let ran = folder.relief("bake dem.tif --kind normal -o .");
    assert_eq!(ran.code, Some(1));
    assert!(ran.stderr.contains("2 of its texels") && ran.stderr.contains("--fill"), "{}", ran.stderr);
    let about = json_of(&folder.relief("bake dem.tif --kind normal --fill --json -o .").fine().stdout);
    assert_eq!((&about["wrap"], &about["tile_m"]), (&json!("clamp"), &json!([720.0, 480.0])));
    assert_eq!(about["scale_m"], json!(236.0));
}

#[test]
fn inspect_says_what_is_known_of_it() {
    let folder = Folder::new();
    let mut tags = georeference();
    // Rows from the south, heights in feet with a scale and an offset.
    tags[0].2 = [30.0f64, -30.0, 0.0].iter().flat_map(|value| value.to_le_bytes()).collect();
    let items = "<Item sample=\"0\" role=\"scale\">0.5</Item><Item sample=\"0\" role=\"offset\">10</Item>\
                 <Item sample=\"0\" role=\"unittype\">ft</Item>";
    tags.push((42112, 2, format!("<GDALMetadata>{items}</GDALMetadata>\0").into_bytes()));
    let data: Vec<u8> = (0..SIZE[0] * SIZE[1]).flat_map(|at| (at as f32).to_le_bytes()).collect();
    folder.write("dem.tif", tiff(SIZE, Samples::Float, &data, &tags));

    let about = json_of(&folder.relief("inspect dem.tif --json").fine().stdout);
    let ground = json!({
        "system": "projected", "epsg": 32617, "turned_over": { "columns": false, "rows": true },
        "size_unknown": null,
    });
    assert_eq!((&about["georeference"], &about["texel_m"]), (&ground, &json!([30.0, 30.0])));
    let elevation = &about["values"]["elevation"];
    let numbers = ["metres_per_unit", "scale", "offset"].map(|name| elevation[name].as_f64());
    assert_eq!((&elevation["unit"], numbers), (&json!("ft"), [Some(0.3048), Some(0.5), Some(10.0)]));
    let metres: [f64; 2] = serde_json::from_value(elevation["range_m"].clone()).expect("two numbers");
    assert!((metres[0] - 3.048).abs() < 1e-9 && (metres[1] - 201.5 * 0.3048).abs() < 1e-9, "{metres:?}");
    assert_eq!((&about["values"]["masked"], &about["nodata"]), (&json!(0), &json!(-9999.0)));

    let text = folder.relief("inspect dem.tif").fine().stdout;
    for part in ["EPSG:32617", "rows are turned over", "30.000000 m", "value * 0.5 + 10", "ft", "nodata"] {
        assert!(text.contains(part), "'{part}' is missing:\n{text}");
    }

    // Why metres are not known is said, too.
    let keys = [1u16, 1, 0, 1, 1024, 0, 1, 3];
    tags[2].2 = keys.iter().flat_map(|key| key.to_le_bytes()).collect();
    folder.write("dem.tif", tiff(SIZE, Samples::Float, &data, &tags));
    let text = folder.relief("inspect dem.tif").fine().stdout;
    assert!(text.contains("not known: the kind of its coordinate system"), "{text}");
}

#[test]
fn real_models_of_unsigned_integers_are_seen() {
    let Some(data) = std::env::var_os("RELIEF_DATA").map(PathBuf::from).filter(|data| data.is_dir()) else {
        println!("skipped: RELIEF_DATA is not set to a folder of real maps");
        return;
    };
    let folder = Folder::new();
    for (name, filled) in [("dem_matrix/u16_tiled_lzw_p2.tif", 0), ("small_dem_3m_merged.tif", 52119)] {
        let height = data.join(name);
        let line = "render --json --backend cpu --size 80x60 -o out.png --height";
        let words = line.split_ascii_whitespace().map(Into::into).chain([height.into_os_string()]);
        let about = json_of(&folder.with(line, words).fine().stdout);
        assert_eq!(about["surfaces"][0]["filled_texels"], json!(filled), "{name}");
        assert!(about["covered"].as_u64().is_some_and(|covered| covered > 100), "{name}: {about}");
    }
}
