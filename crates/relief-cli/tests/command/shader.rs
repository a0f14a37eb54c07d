//! `relief shader`: files, their descriptions, and refusals.

use std::collections::BTreeSet;

use crate::common::command::{Folder, Ran, json_of};
use crate::common::refused::{OUT, assert_refused, entries, make_read_only, with_out};
use serde_json::Value;

fn manifest(folder: &Folder, name: &str) -> Value {
    let text = std::fs::read_to_string(folder.path(name)).expect("a manifest");
    serde_json::from_str(&text).expect("JSON")
}

fn found<'a>(list: &'a Value, key: &str, value: &str) -> &'a Value {
    let list = list.as_array().expect("a list");
    list.iter().find(|one| one[key] == value).unwrap_or_else(|| panic!("no {key} {value}"))
}

#[test]
fn every_target_has_its_files_and_the_manifest_names_them() {
    let folder = Folder::new();
    let line = "shader --method cone --target wgsl,glsl,hlsl --target msl --target spirv -o new/shaders";
    let ran = folder.relief(&format!("{line} --json")).fine();
    let told = json_of(&ran);
    let told = told["files"].as_array().expect("files").iter().filter_map(|file| file["path"].as_str());
    assert_eq!(told.filter(|path| folder.path(path).is_file()).count(), 7);
    let written: BTreeSet<String> = entries(&folder.path("new/shaders")).into_iter().collect();
    let expected =
        ["cone.wgsl", "cone.vert.glsl", "cone.frag.glsl", "cone.hlsl", "cone.metal", "cone.spv", "cone.json"];
    assert_eq!(written, expected.map(str::to_owned).into());
    let about = manifest(&folder, "new/shaders/cone.json");
    let targets = about["targets"].as_array().expect("targets");
    let files = targets.iter().flat_map(|target| target["files"].as_array().expect("files"));
    let named: BTreeSet<&str> = files.filter_map(|file| file["file"].as_str()).collect();
    assert_eq!(named.len(), 6);
    assert!(named.iter().all(|name| written.contains(*name)), "{named:?}");
    // The same again, over these files.
    let read = || expected.map(|name| std::fs::read(folder.path("new/shaders").join(name)).expect("a file"));
    let before = read();
    let ran = folder.relief(line).fine();
    assert!(expected.iter().all(|name| ran.stdout.contains(name)), "{}", ran.stdout);
    assert!(before == read());
}

#[test]
fn maps_come_with_the_line_that_bakes_them() {
    let folder = Folder::new();
    folder.relief("shader --method frustum --shadow horizon --target wgsl -o out").fine();
    let about = manifest(&folder, "out/frustum.json");
    folder.write("map.png", crate::common::maps::Map::hills().png());
    for (slot, kind, metres) in [
        ("search_map", "frustum", "--scale 1 --tile-size 1,1"),
        ("shadow_texels", "horizon", "--scale M --tile-size U,V"),
    ] {
        let bake = &found(&about["bindings"], "name", slot)["texture"]["bake"];
        assert_eq!(bake["kind"], kind);
        let how = bake["how"].as_str().expect("a line");
        assert!(how.contains(metres), "{how}");
        assert!(std::fs::read_to_string(folder.path("out/frustum.wgsl")).expect("text").contains(how));
        // It is a line that works, with what is the user's filled in.
        let line = how.replace("HEIGHT", "map.png").replace("DIR", "maps");
        let line = line.replace(" M ", " 0.1 ").replace("U,V", "1,1");
        folder.relief(line.strip_prefix("relief ").expect("a line of relief")).fine();
    }
}

#[test]
fn settings_are_values_to_begin_with() {
    let folder = Folder::new();
    folder.relief("shader --method relief --set search.steps=48 --target wgsl -o a").fine();
    folder.relief("shader --method relief --set search.steps=20 --target wgsl -o b").fine();
    for (name, steps) in [("a", 48.0), ("b", 20.0)] {
        let about = manifest(&folder, &format!("{name}/relief.json"));
        let search = found(&about["stages"], "stage", "search");
        assert_eq!(found(&search["params"], "name", "steps")["value"], steps);
    }
    let code = |name: &str| {
        let text = std::fs::read_to_string(folder.path(name)).expect("a shader");
        text.lines().filter(|line| !line.starts_with("//")).collect::<Vec<_>>().join("\n")
    };
    assert_eq!(code("a/relief.wgsl"), code("b/relief.wgsl"));
}

#[test]
fn flags_choose_sampling_depth_places_and_names() {
    let folder = Folder::new();
    let line = "shader --search linear --refine secant --sampling fast --depth --group 2 --first-binding 5";
    folder.relief(&format!("{line} --target wgsl,hlsl --profile 6.0 --name wall -o out")).fine();
    let about = manifest(&folder, "out/wall.json");
    assert_eq!((&about["sampling"], &about["draw"]["depth"]), (&"fast".into(), &true.into()));
    assert_eq!(found(&about["targets"], "target", "hlsl")["profile"], "6.0");
    for (number, bound) in (5..).zip(about["bindings"].as_array().expect("bindings")) {
        assert_eq!((&bound["group"], &bound["binding"]), (&2.into(), &number.into()));
    }
    folder.relief("shader --search linear --refine secant --target wgsl -o out").fine();
    assert!(folder.path("out/linear-secant.wgsl").is_file());
    // What shows displaced triangles, as the refusal of their methods says.
    let refusal = folder.relief("shader --method vertex --target wgsl -o out").stderr;
    let facets = "--surface facets --search none --refine none --shadow none";
    assert!(refusal.contains(facets), "{refusal}");
    folder.relief(&format!("shader {facets} --target wgsl -o out")).fine();
}

#[test]
fn wrong_lines_are_refused_with_what_is_wrong_and_what_there_is() {
    let folder = with_out();
    let table: &[(&str, &[&str])] = &[
        ("--method con --target wgsl", &["--method", "'cone'"]),
        ("--target wgsl", &["--method"]),
        ("--method cone", &["--target"]),
        ("--method cone --search cone --refine patch --target wgsl", &["--method", "--search"]),
        ("--search cone --target wgsl", &["--refine"]),
        ("--refine patch --target wgsl", &["--search"]),
        ("--search cone --refine pach --target wgsl", &["--refine", "'patch'"]),
        ("--search cone --refine offset --target wgsl", &["--refine", "offset"]),
        ("--method cone --target wsgl", &["--target", "'wgsl'", "spirv"]),
        ("--method cone --target glsl --profile core45", &["--profile", "'core450'", "es310"]),
        ("--method cone --target glsl --profile 6.0", &["--profile", "core450", "es310"]),
        ("--method cone --target wgsl,wgsl", &["--target", "cone.wgsl"]),
        ("--method cone --target glsl --profile core450,es310", &["cone.vert.glsl"]),
        ("--method cone --target wgsl --sampling quick", &["--sampling", "fast"]),
        ("--method vertex --target wgsl", &["--method", "vertex", "facets"]),
        ("--method tessellate --target wgsl", &["--method", "facets"]),
        ("--method cone --shadow scene --target wgsl", &["--shadow", "CPU"]),
        ("--method cone --surface prims --target wgsl", &["--surface", "'prism'"]),
        ("--method bump --surface prism --target wgsl", &["--search", "prism"]),
        ("--method cone --surface prism --shadow entry --target wgsl", &["--shadow", "prism"]),
        (
            "--method relief --shadow ray --shadow-search voxels --target wgsl",
            &["--shadow-search", "'cells'"],
        ),
        ("--method relief --set search.steps=0 --target wgsl", &["search.steps", "4096"]),
        ("--method relief --set search.step=4 --target wgsl", &["--set", "steps"]),
        ("--method cone --target wgsl --group 4", &["--group", "4", "3"]),
        ("--method cone --target msl --group 0 --first-binding 30", &["--first-binding", "msl", "30"]),
        ("--method cone --target glsl --group 0 --first-binding 4294967295", &["--first-binding", "255"]),
        ("--method cone --target wgsl --group -1", &["--group"]),
        ("--method cone --target wgsl --first-binding 3", &["--group"]),
        ("--method cone --target wgsl --name a/b", &["--name", "a/b"]),
        ("--method cone --target wgsl --name ..", &["--name"]),
    ];
    for (line, words) in table {
        let ran = folder.relief(&format!("shader {line} -o {OUT}"));
        assert_refused(&folder, &ran, 2, words);
    }
}

#[test]
fn folders_that_cannot_be_written_are_refused() {
    let folder = with_out();
    folder.write("file", "");
    folder.write("taken/cone.json/inside", "");
    let refused = |output: &str, word: &str| {
        let ran = folder.relief(&format!("shader --method cone --target wgsl,glsl -o {output}"));
        assert_refused(&folder, &ran, 1, &[word]);
    };
    refused("file", "file");
    refused("file/below", "file");
    refused("taken", "cone.json");
    assert_eq!(entries(&folder.path("taken")), ["cone.json"]);
    #[cfg(target_os = "linux")]
    refused("/proc/shaders", "/proc/shaders");
    if make_read_only(&folder) {
        refused(OUT, OUT);
    }
}

#[cfg(unix)]
#[test]
fn no_room_on_the_disk_leaves_what_was_there() {
    let folder = Folder::new();
    folder.write("full/cone.wgsl", b"old");
    let line = "shader --method cone --target wgsl,spirv -o full";
    let script = format!("trap '' XFSZ; ulimit -f 64; exec {} {line}", env!("CARGO_BIN_EXE_relief"));
    let output = std::process::Command::new("sh").args(["-c", &script]).current_dir(folder.path("")).output();
    let ran = Ran::new(line, &output.expect("a shell runs"));
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("full/cone"), "{}", ran.stderr);
    assert_eq!(std::fs::read(folder.path("full/cone.wgsl")).expect("it is there"), b"old");
    assert_eq!(entries(&folder.path("full")).iter().filter(|name| !name.starts_with('.')).count(), 1);
}

fn sorted(mut names: Vec<String>) -> Vec<String> {
    names.sort();
    names
}

#[test]
fn functions_are_a_text_and_its_description() {
    let folder = Folder::new();
    let line =
        "shader --method cone --entry functions --shadow ray --wrap repeat --prefix rock --target wgsl";
    folder.relief(&format!("{line} --group 2 --first-binding 5 -o out")).fine();
    assert_eq!(sorted(entries(&folder.path("out"))), ["cone.json", "cone.wgsl"]);
    let text = std::fs::read_to_string(folder.path("out/cone.wgsl")).expect("a text");
    for there in ["fn rock_hit(", "fn rock_light(", "@group(2) @binding(6) var rock_search_map"] {
        assert!(text.contains(there), "{there}");
    }
    assert!(!text.contains("@fragment") && !text.contains("surface_settings"));
    let about = manifest(&folder, "out/cone.json");
    let scale = found(&about["settings"], "name", "scale");
    assert_eq!((&scale["type"], &scale["offset"]), (&Value::from("f32"), &Value::from(0)));
    let limit = found(&about["settings"], "name", "search_limit");
    assert!(limit["value"].as_f64().expect("a value") > 1.0 && limit["max"].is_number());
    let view = found(&about["point"], "name", "view");
    assert_eq!((&view["type"], about["hit"].as_array().map(Vec::len)), (&Value::from("vec3f"), Some(5)));
    let map = found(&about["bindings"], "name", "rock_search_map");
    assert_eq!((&map["texture"]["dimension"], &map["texture"]["levels"]), (&"2d".into(), &"1".into()));
    assert!(map["texture"]["bake"]["how"].as_str().expect("a line").contains("--kind cone"));
}

#[test]
fn more_can_be_asked_of_functions() {
    let folder = Folder::new();
    let size = |flags: &str| {
        let line = format!("shader --method relief --entry functions {flags} --target wgsl -o out");
        folder.relief(&line).fine();
        std::fs::read_to_string(folder.path("out/relief.wgsl")).expect("a text")
    };
    let (plain, any_wrap) = (size("--wrap clamp"), size(""));
    assert!(plain.len() < any_wrap.len() && any_wrap.contains("wrap: u32"));
    // Without a shadow unless one is asked for.
    assert!(!plain.contains("relief_light") && size("--shadow soft").contains("light_radius"));
    let more = size("--with holes,footprint --set detail.flat=2");
    assert!(
        more.contains("relief_hole_map")
            && more.contains("footprint: f32")
            && more.contains("Begins with 2.")
    );
    assert!(!plain.contains("footprint: f32"));
    // A method whose own surface needs a triangle is written for a flat point.
    folder.relief("shader --method voxels --entry functions --target wgsl -o out").fine();
    let bent = size("--surface quadric-vertical");
    assert!(bent.contains("curvature: vec3f") && bent.contains("fn relief_curvature("));
}

#[test]
fn functions_take_triangles_too() {
    let folder = Folder::new();
    let of = |flags: &str| {
        let line = format!("shader --method relief --entry functions --form triangle {flags} -o out");
        folder.relief(&line).fine();
        (std::fs::read_to_string(folder.path("out/relief.wgsl")), manifest(&folder, "out/relief.json"))
    };
    // Of shells, unless a surface is named.
    let (text, about) = of("--target wgsl --shadow ray");
    let text = text.expect("a text");
    for there in ["fn relief_triangle_hit(", "fn relief_triangle_light(", "struct ReliefCorner {"] {
        assert!(text.contains(there), "{there}");
    }
    assert!(!text.contains("fn relief_tile("));
    assert_eq!((&about["form"], &about["point"]), (&"triangle".into(), &Value::Null));
    assert_eq!(found(&about["structs"]["ReliefRay"], "name", "direction")["type"], "vec3f");
    assert_eq!(found(&about["hit"], "name", "position")["type"], "vec3f");
    let stage = |about: &Value| found(&about["stages"], "stage", "surface")["name"].clone();
    assert_eq!(stage(&about), "prism");
    assert_eq!(stage(&of("--target wgsl --surface tetrahedra").1), "tetrahedra");
}

#[test]
fn functions_come_in_other_languages() {
    let folder = Folder::new();
    let line = "shader --method relief --entry functions --wrap repeat --prefix rock";
    folder.relief(&format!("{line} --target wesl,glsl,hlsl,msl --profile es300 -o out")).fine();
    let files = ["relief.glsl", "relief.hlsl", "relief.json", "relief.metal", "relief.wesl"];
    assert_eq!(sorted(entries(&folder.path("out"))), files);
    let text = |name: &str| std::fs::read_to_string(folder.path("out").join(name)).expect("a text");
    let declared = "RockHit rock_hit(RockSettings settings, RockPoint at)";
    for name in ["relief.glsl", "relief.hlsl"] {
        // In the code, and in the list at its head.
        assert_eq!(text(name).matches(declared).count(), 2, "{name}");
        assert!(!text(name).contains("void main") && !text(name).contains("#version"), "{name}");
    }
    assert!(text("relief.glsl").contains("sampler2D rock_height_map;"));
    assert!(text("relief.hlsl").contains("rock_height_map : register(t0)"));
    assert!(text("relief.metal").contains("RockHit rock_hit("));
}

#[test]
fn functions_that_there_are_not_are_refused() {
    let folder = with_out();
    let refused = |flags: &str, named: &[&str]| {
        let ran = folder.relief(&format!("shader {flags} --target wgsl -o {OUT}"));
        assert_refused(&folder, &ran, 2, named);
    };
    refused(
        "--method relief --entry functions --surface prism",
        &["--surface", "'plane'", "the form 'triangle'"],
    );
    refused("--method relief --entry functions --form triangel", &["--form", "triangle"]);
    refused("--method relief --form triangle --entry functions --surface slices", &["'prism'"]);
    refused("--method depth-object --entry functions", &["--method", "'object'"]);
    refused("--method vertex --entry functions", &["--method", "vertex", "'cone'"]);
    refused("--method translucent --entry functions", &["translucent"]);
    refused("--method relief --entry functions --shadow map", &["--shadow", "'ray'"]);
    refused("--method relief --entry functions --prefix while", &["--prefix", "while"]);
    refused("--method relief --entry functions --prefix Rock", &["--prefix", "small letter"]);
    refused("--method relief --entry functions --with hole", &["--with", "'holes'"]);
    refused("--method relief --entry functions --wrap mirrored", &["mirror"]);
    refused("--method relief --entry functions --depth", &["--depth"]);
    refused("--method relief --entry functions --ambient sky", &["--ambient"]);
    refused("--method relief --prefix rock", &["--prefix", "--entry functions"]);
    let other = |flags: &str, named: &[&str]| {
        let ran = folder.relief(&format!("shader --method relief {flags} -o {OUT}"));
        assert_refused(&folder, &ran, 2, named);
    };
    other("--entry functions --target spirv", &["--target", "spirv", "glsl"]);
    other("--entry functions --target glsl --profile core331", &["--profile", "core330"]);
    other("--target wesl", &["--target", "wesl", "--entry functions"]);
    other("--target glsl --profile es300", &["--profile", "es310"]);
}
