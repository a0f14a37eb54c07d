//! Elevation models on the command line: their holes, edges and notes.

use std::path::PathBuf;

use crate::common::command::Folder;
use crate::common::files::{Samples, exr, georeference, tiff};
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
    // Two texels beside each other are at the corners of six cells: two triangles each, ten sides
    // around them.
    let [filled, holes] = ["", " --holes"].map(|flag| count(&format!("dem.tif --texels 1{flag}")));
    assert_eq!(holes, [filled[0] - 12, filled[1] + 10]);
    let [filled, holes] = ["", " --holes"].map(|flag| count(&format!("dem.tif --error 1%{flag}")));
    assert!(holes[1] >= filled[1] + 10 && holes != filled, "{holes:?} {filled:?}");
    // Nothing is left out of a map without holes, and a note says so.
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

    // Holes that are seen through are filled in files of all kinds, and a map without any is said
    // to be.
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
        "unit": "m", "unit_by": "EPSG:32617", "placed_by": null, "size_unknown": null,
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

    // The reason for unknown metres is printed, too.
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

/// A ramp of 40x24 texels of 10 units in a projected system with these keys, its values from `low`
/// in steps.
fn ramp(numbers: &[[u16; 2]], [low, step]: [f32; 2]) -> Vec<u8> {
    let mut tags = georeference();
    tags[0].2 = [10.0f64, 10.0, 0.0].iter().flat_map(|value| value.to_le_bytes()).collect();
    let keys = [[1024, 1]].iter().chain(numbers).flat_map(|[key, value]| [*key, 0, 1, *value]);
    let directory: Vec<u16> = [1, 1, 1, numbers.len() as u16 + 1].into_iter().chain(keys).collect();
    tags[2].2 = directory.iter().flat_map(|key| key.to_le_bytes()).collect();
    let data: Vec<u8> = (0..40 * 24).flat_map(|at| (low + step * (at % 40) as f32).to_le_bytes()).collect();
    tiff([40, 24], Samples::Float, &data, &tags)
}

#[test]
fn inspect_says_where_metres_come_from() {
    let folder = Folder::new();
    for (numbers, parts) in [
        (
            &[[3072u16, 2271], [4096, 6360]] as &[_],
            &["EPSG:2271) in us-ft of 0.3048", "(by EPSG:2271)", "texel       3.048006 m", "(by EPSG:6360)"]
                as &[_],
        ),
        (&[[3072, 2222], [4099, 9001]], &["texel       3.048000 m", "by EPSG:2222", "in m (by key 4099)"]),
        (&[[3072, 2263], [3076, 9001]], &["in m (by key 3076)", "in m, the unit of the ground"]),
        (&[[3072, 31000], [4096, 5703]], &["unit of EPSG:31000", "not known", "--unit"]),
        (&[[3072, 32617], [4096, 9999]], &["unit of EPSG:9999", "no known length", "--unit"]),
        (&[[3072, 32767]], &["names no unit", "metres are not known", "--unit"]),
        (&[[3072, 32767], [4099, 9002]], &["in ft of 0.3048 m each, the unit of the heights", "--unit"]),
        (&[[3072, 2263]], &["the unit of the ground", "--unit"]),
        (&[[3072, 32617], [4096, 5715]], &["counted downward: -110 m to -90.5 m", "convention  depth"]),
    ] {
        folder.write("dem.tif", ramp(numbers, [90.5, 0.5]));
        let text = folder.relief("inspect dem.tif").fine().stdout;
        for part in parts {
            assert!(text.contains(part), "{numbers:?}: '{part}' is missing:\n{text}");
        }
    }
    folder.write("dem.tif", ramp(&[[3072, 2271], [4096, 6360]], [90.0, 10.0]));
    let about = json_of(&folder.relief("inspect dem.tif --json").fine().stdout);
    let [ground, heights] = [&about["georeference"], &about["values"]["elevation"]];
    assert_eq!([&ground["unit"], &ground["unit_by"]], [&json!("us-ft"), &json!("EPSG:2271")]);
    assert_eq!([&heights["unit_by"], &heights["downward"]], [&json!("EPSG:6360"), &json!(false)]);
    assert_eq!(heights["doubt"], Value::Null);
}

#[test]
fn heights_that_are_no_metres_are_doubted_and_make_no_mesh() {
    let folder = crate::common::refused::with_out();
    let utm = [[3072, 32617]];
    // Doubtful heights of eight made maps, with their unit.
    for (numbers, values, unit) in [
        (utm.as_slice(), [29_332.0, 40.0], "cm"),
        (&utm, [0.0, 250.0], "cm"),
        (&utm, [10_000.0, 1.0], "dm"),
        (&utm, [0.0, 8.0], "dm"),
        (&utm, [9_500.0, 5.0], "ft"),
        (&utm, [-15_000.0, 2.0], "cm"),
        (&[[3072, 32617], [4099, 9001]], [9_100.0, 1.0], "dm"),
        (&[[3072, 2263]], [40_000.0, 20.0], "cm"),
    ] {
        folder.write("dem.tif", ramp(numbers, values));
        let text = folder.relief("inspect dem.tif").fine().stdout;
        assert!(text.contains("doubtful") && text.contains("--unit") && text.contains(unit), "{text}");
        let ran = folder.relief("mesh dem.tif -o out/dem.glb");
        crate::common::refused::assert_refused(&folder, &ran, 1, &["dem.tif", "--unit", unit]);
        folder.relief(&format!("mesh dem.tif --unit {unit} -o dem.glb")).fine();
        let text = folder.relief(&format!("inspect dem.tif --unit {unit}")).fine().stdout;
        assert!(text.contains("by --unit") && !text.contains("doubtful"), "{text}");
        let ran = folder.relief("render --backend cpu --size 32x24 -o out.png --height dem.tif");
        assert!(ran.code == Some(0) && ran.stderr.contains("--unit"), "{}", ran.stderr);
    }
    // A user who confirms metres is believed; real ground is never doubted.
    folder.write("dem.tif", ramp(&utm, [9_500.0, 5.0]));
    folder.relief("mesh dem.tif --unit m -o dem.glb").fine();
    for (numbers, values) in [
        (utm.as_slice(), [0.0, 5.0]),
        (&utm, [-11_000.0, 5.0]),
        (&utm, [8_600.0, 5.0]),
        (&utm, [0.0, 0.0]),
        (&[[3072, 2263], [4096, 6360]], [29_000.0, 0.5]),
        (&[[3072, 2271], [4096, 6360]], [500.0, 10.0]),
        (&[[3072, 32617], [4099, 9001]], [0.0, 9.5]),
        (&[[3072, 32767], [4099, 9001]], [0.0, 5.0]),
    ] {
        folder.write("dem.tif", ramp(numbers, values));
        let text = folder.relief("inspect dem.tif").fine().stdout;
        assert!(!text.contains("doubtful"), "{text}");
        let ran = folder.relief("mesh dem.tif -o dem.glb");
        assert!(ran.code == Some(0) && !ran.stderr.contains("would"), "{}", ran.stderr);
    }
    for bad in ["kelvin", "", "m,", "m,m,m"] {
        let words = ["mesh", "dem.tif", "-o", "out/dem.glb", "--unit", bad];
        let ran = folder.with("", words);
        assert_eq!(ran.code, Some(2), "{bad}: {}", ran.stderr);
    }
}

#[test]
fn notes_say_which_unit_is_taken() {
    let folder = Folder::new();
    let line = "mesh dem.tif -o dem.glb";
    for (numbers, part) in [
        (&[[3072u16, 2263]] as &[_], "the unit of the ground is assumed, us-ft"),
        (&[[3072, 2222]], "the unit of the ground is assumed, ft"),
        (&[[3072, 32767], [4099, 9002]], "the unit of the heights is assumed, ft"),
        (&[[3072, 32767]], "their metres are not known"),
        (&[[3072, 31000], [4096, 5703]], "(unit of EPSG:31000)"),
        (&[[3072, 32617], [3076, 9999]], "(EPSG:9999)"),
        (&[[3072, 32617], [4096, 9999]], "no known length"),
        (&[[3072, 32617], [4099, 9102]], "EPSG:9102"),
    ] {
        folder.write("dem.tif", ramp(numbers, [90.0, 0.5]));
        let ran = folder.relief(line);
        assert_eq!(ran.code, Some(0), "{numbers:?}: {}", ran.stderr);
        assert!(ran.stderr.contains(part) && ran.stderr.contains("--unit"), "{numbers:?}: {}", ran.stderr);
        folder.relief(&format!("{line} --unit ft,ft")).fine();
    }
    for numbers in
        [&[[3072u16, 32617]] as &[_], &[[3072, 2263], [4096, 6360]], &[[3072, 32617], [4096, 5715]]]
    {
        folder.write("dem.tif", ramp(numbers, [90.0, 0.5]));
        folder.relief(line).fine();
    }
    // Depths that are turned inside out are heights again.
    let heights = |line: &str| {
        folder.relief(line).fine();
        std::fs::read(folder.path("dem.glb")).expect("it is written")
    };
    let [depth, inverted] = ["", " --invert"].map(|flag| heights(&format!("{line}{flag}")));
    assert_ne!(depth, inverted);
}

#[test]
fn feet_by_code_alone_are_as_high_as_they_are_long() {
    let folder = Folder::new();
    for code in [2271, 6597, 2263, 3089] {
        // 10 feet up for 10 feet along: as high as the plane is long, less one texel.
        folder.write("dem.tif", ramp(&[[3072, code], [4096, 6360]], [500.0, 10.0]));
        let about = json_of(&folder.relief("mesh dem.tif -o dem.glb --print-size 1m --json").fine().stdout);
        let size: Vec<f64> = serde_json::from_value(about["size_m"].clone()).expect("three numbers");
        assert!((size[1] / size[0] - 0.975).abs() < 1e-6, "EPSG:{code}: {size:?}");
    }
}

#[test]
fn files_beside_a_map_say_where_it_lies() {
    let folder = crate::common::refused::with_out();
    let data: Vec<u8> = (0..40 * 24).flat_map(|at| (at as f32 * 0.05).to_le_bytes()).collect();
    folder.write("dem.tif", tiff([40, 24], Samples::Float, &data, &[]));
    folder.write("dem.tfw", b"10\n0\n0\n-10\n500005\n4999995\n");
    let ran = folder.relief("mesh dem.tif -o dem.glb");
    assert!(ran.code == Some(0) && ran.stderr.contains("--unit"), "{}", ran.stderr);
    folder.write("dem.prj", b"EPSG:2222");
    let text = folder.relief("inspect dem.tif").fine().stdout;
    for part in ["(by EPSG:2222), placed by dem.tfw", "texel       3.048000 m", "the unit of the ground"] {
        assert!(text.contains(part), "'{part}' is missing:\n{text}");
    }
    folder.write("dem.prj", b"LOCAL_CS[\"site\",UNIT[\"metre\",1]]");
    assert!(folder.relief("inspect dem.tif").fine().stdout.contains("in m (by dem.prj), placed by dem.tfw"));
    folder.relief("mesh dem.tif -o dem.glb").fine();
    for (name, bytes) in [("dem.tfw", "1\n2\n3\n4\n5\n"), ("dem.tif.aux.xml", "<PAMDataset>")] {
        folder.write(name, bytes.as_bytes());
        let ran = folder.relief("mesh dem.tif -o out/dem.glb");
        crate::common::refused::assert_refused(&folder, &ran, 1, &[name]);
    }
}
