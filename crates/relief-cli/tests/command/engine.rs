//! `relief engine`: what an engine needs, read back.

use std::collections::BTreeSet;

use relief_io::{HeightOptions, HeightRange, MeshOptions, read_height, read_mesh};
use serde_json::Value;

use crate::common::command::{Folder, json_of};
use crate::common::maps::Map;

fn folder() -> Folder {
    let folder = Folder::new();
    let map = Map::new(48, 32, |x, y| (((x * 5) ^ (y * 3)) % 64 * 1000) as u16);
    folder.write("stones.png", map.png());
    folder
}

fn files(answer: &Value) -> Vec<String> {
    let list = answer["files"].as_array().expect("a list");
    list.iter().map(|file| file.as_str().expect("a name").to_owned()).collect()
}

fn text(folder: &Folder, name: &str) -> String {
    std::fs::read_to_string(folder.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The facts in a page of three.js.
fn facts(folder: &Folder, out: &str) -> Value {
    let page = text(folder, &format!("{out}/index.html"));
    let (_, rest) = page.split_once("id=\"relief\">").expect("a place for facts");
    serde_json::from_str(rest.split('<').next().expect("its end")).expect("JSON")
}

/// Words between quotation marks after `path=` in Godot's texts.
fn paths(text: &str) -> BTreeSet<String> {
    text.split("path=\"").skip(1).filter_map(|rest| rest.split('"').next()).map(str::to_owned).collect()
}

#[test]
fn a_page_of_three_js_names_files_that_are_there() {
    let folder = folder();
    let asked = "engine three stones.png --mesh torus --tile 4,2 --method cone --scale 3cm -o page --json";
    let answer = json_of(&folder.relief(asked).fine());
    for file in files(&answer) {
        assert!(folder.path(format!("page/{file}")).is_file(), "{file}");
    }
    let facts = facts(&folder, "page");
    assert_eq!(facts["scale"], 0.03);
    let named =
        facts["maps"].as_object().expect("maps").values().chain([&facts["functions"], &facts["mesh"]]);
    for name in named {
        assert!(folder.path(format!("page/{}", name.as_str().expect("a name"))).is_file(), "{name}");
    }
    // The maps are those that the functions bind.
    let about: Value = serde_json::from_str(&text(&folder, "page/relief.json")).expect("JSON");
    let bound: BTreeSet<String> = about["bindings"]
        .as_array()
        .expect("a list")
        .iter()
        .map(|bound| bound["name"].as_str().expect("a name").trim_start_matches("relief_").to_owned())
        .collect();
    let given: BTreeSet<String> = facts["maps"].as_object().expect("maps").keys().cloned().collect();
    assert_eq!(given, bound);
    assert_eq!(given.len(), 2);
    let mesh = read_mesh(&folder.path("page/stones.gltf"), &MeshOptions::default()).expect("a mesh").mesh;
    let greatest = mesh.vertices().iter().map(|vertex| vertex.uv.x).fold(0.0, f32::max);
    assert!(mesh.triangles().len() > 1000 && (greatest - 4.0).abs() < 1e-4, "{greatest}");

    let again = json_of(&folder.relief(asked).fine());
    assert_eq!(again["up_to_date"], true);
    let other = json_of(&folder.relief(&asked.replace("--tile 4,2", "--tile 4,3")).fine());
    assert_eq!(other["up_to_date"], false);
}

#[test]
fn a_scene_of_godot_names_files_that_are_there() {
    let folder = folder();
    let answer = json_of(&folder.relief("engine godot stones.png --mesh sphere -o scene --json").fine());
    let written: BTreeSet<String> = files(&answer).into_iter().collect();
    let texts = ["stones.tscn", "stones_demo.tscn", "stones_material.tres", "stones_mesh.tres"];
    let named = texts.map(|name| paths(&text(&folder, &format!("scene/{name}"))));
    let named: BTreeSet<String> = named.into_iter().flatten().collect();
    assert!(named.is_subset(&written) && named.len() == 5, "{named:?}");
    let shader = text(&folder, "scene/relief.gdshader");
    let included = shader.split("#include \"").skip(1).filter_map(|rest| rest.split('"').next());
    assert!(included.map(str::to_owned).collect::<BTreeSet<_>>().is_subset(&written));
    // A texture of floats: its head, and four bytes a texel.
    let heights = std::fs::read(folder.path("scene/stones_height_map.dds")).expect("a file");
    assert_eq!((&heights[..4], heights.len()), (b"DDS ".as_slice(), 148 + 4 * 48 * 32));
    // A flat mesh needs no curvature.
    folder.relief("engine godot stones.png -o flat -q").fine();
    let has_curvature =
        |out: &str| text(&folder, &format!("{out}/relief.gdshaderinc")).contains("HAS_CURVATURE");
    assert!(has_curvature("scene") && !has_curvature("flat"));
}

#[test]
fn a_program_of_bevy_names_files_that_are_there() {
    let folder = folder();
    let asked = "engine bevy stones.png --mesh torus --tile 4,2 --method cone --scale 3cm -o program --json";
    let written: BTreeSet<String> = files(&json_of(&folder.relief(asked).fine())).into_iter().collect();
    let model = text(&folder, "program/relief_model.rs");
    let named = model.split('"').skip(1).step_by(2).map(|name| name.split('#').next().unwrap_or_default());
    let named: BTreeSet<String> = named.filter(|name| name.contains('.')).map(str::to_owned).collect();
    assert!(named.is_subset(&written) && named.len() == 3, "{named:?}");
    for module in text(&folder, "program/main.rs").split("\nmod ").skip(1) {
        let name = module.split(';').next().unwrap_or_default();
        assert!(written.contains(&format!("{name}.rs")), "{name}");
    }
    // The textures are bound where the functions read them, in the order of the fields.
    let (functions, shader) =
        (text(&folder, "program/relief_functions.rs"), text(&folder, "program/relief.wesl"));
    for (number, name) in [(101, "height_map"), (102, "search_map")] {
        assert!(shader.contains(&format!("@group(3) @binding({number}) var relief_{name}: ")), "{name}");
        let field = format!("#[texture({number}, filterable = false)]\n    pub {name}: ");
        assert!(functions.contains(&field), "{functions}");
    }
    assert!(functions.contains("UVec2::new(48, 32)") && model.contains("SCALE: f32 = 0.03;"));
    // A mesh that names textures would have Bevy look for them.
    assert!(!text(&folder, "program/stones.gltf").contains(".png"));
}

#[test]
fn every_setting_of_a_program_begins_with_a_value() {
    let folder = folder();
    let mut count = 0;
    for (number, method) in relief_shaders::METHODS.iter().enumerate() {
        let shadow = ["none", "ray", "soft", "entry", "heuristic", "horizon", "visibility"][number % 7];
        let asked =
            format!("engine bevy stones.png --method {} --shadow {shadow} -o out --force -q", method.name);
        if folder.relief(&asked).code == Some(0) {
            count += 1;
            let settings = text(&folder, "out/relief_functions.rs");
            let unknown = settings.lines().find(|line| line.contains("Default::default()"));
            assert_eq!(unknown, None, "{}, {shadow}", method.name);
        }
    }
    assert!(count > 12, "{count}");
}

/// The names that the head of a node lists under a title.
fn listed(node: &str, title: &str) -> BTreeSet<String> {
    let (_, rest) = node.split_once(&format!("// {title}:\n")).expect("a list");
    rest.lines()
        .map_while(|line| line.strip_prefix("//   "))
        .map(|line| line.split(':').next().unwrap_or_default().to_owned())
        .collect()
}

#[test]
fn a_node_of_unreal_reads_what_its_head_lists() {
    let folder = folder();
    let asked = "engine unreal stones.png --mesh torus --tile 4,2 --method cone --scale 3cm -o kit --json";
    let written: BTreeSet<String> = files(&json_of(&folder.relief(asked).fine())).into_iter().collect();
    let node = text(&folder, "kit/relief_node.hlsl");
    let (head, code) = node.split_once("\n\n").expect("a head");
    for file in ["relief.ush", "relief_surface.ush"] {
        assert!(written.contains(file) && head.contains(&format!("/Project/{file}")), "{head}");
    }
    for map in ["stones_height_map.exr", "stones_search_map.exr"] {
        assert!(written.contains(map) && head.contains(&format!("Texture Object of {map}")), "{head}");
    }
    assert!(head.contains("Scale: depth of the relief in centimetres: 3\n"), "{head}");
    // Each input is read, each output is set, and nothing else.
    let [inputs, outputs] = ["Inputs", "Additional Outputs"].map(|title| listed(&node, title));
    let words: BTreeSet<String> = code
        .lines()
        .filter_map(|line| line.split("//").next())
        .flat_map(|line| line.split(|c: char| !c.is_ascii_alphanumeric() && c != '_'))
        .filter(|word| word.starts_with(|c: char| c.is_ascii_uppercase()))
        .map(str::to_owned)
        .collect();
    let named: BTreeSet<String> = inputs.union(&outputs).cloned().collect();
    let own = ["GetDimensions", "Relief", "ReliefSettings", "ReliefSurface"].map(str::to_owned);
    assert_eq!(words, named.union(&BTreeSet::from(own)).cloned().collect());
    assert_eq!(inputs.len() + outputs.len(), 12, "{head}");
    for output in &outputs {
        assert!(code.contains(&format!("\n{output} = ")), "{output}: {code}");
    }
    let unlit = asked.replace("-o kit", "--shadow none -o unlit");
    folder.relief(&unlit).fine();
    let node = text(&folder, "unlit/relief_node.hlsl");
    assert!(!node.contains("Sun") && !node.contains("Light"), "{node}");
}

#[test]
fn maps_of_unreal_keep_their_bits() {
    let folder = folder();
    folder.relief("engine unreal stones.png -o kit -q").fine();
    let height = |path: &str| {
        let range = path.ends_with(".exr").then_some(HeightRange::Between([0.0, 1.0]));
        read_height(&folder.path(path), &HeightOptions { range, ..HeightOptions::default() })
            .unwrap_or_else(|error| panic!("{path}: {error}"))
    };
    let [given, written] = ["stones.png", "kit/stones_height_map.exr"].map(height);
    assert_eq!(given.texels(), written.texels());
    let mesh = read_mesh(&folder.path("kit/stones.gltf"), &MeshOptions::default()).expect("a mesh").mesh;
    assert_eq!(mesh.triangles().len(), 2);
    assert!(!text(&folder, "kit/stones.gltf").contains(".png"));
}

#[test]
fn every_setting_of_a_node_has_a_value() {
    let folder = folder();
    let mut count = 0;
    for (number, method) in relief_shaders::METHODS.iter().enumerate() {
        let shadow = ["none", "ray", "soft", "entry", "heuristic", "horizon", "visibility"][number % 7];
        let asked =
            format!("engine unreal stones.png --method {} --shadow {shadow} -o out --force -q", method.name);
        if folder.relief(&asked).code == Some(0) {
            count += 1;
            let node = text(&folder, "out/relief_node.hlsl");
            assert!(!node.contains(" = 0; "), "{}, {shadow}: {node}", method.name);
        }
    }
    assert!(count > 12, "{count}");
}

#[test]
fn what_has_no_kit_says_what_goes() {
    let folder = folder();
    for (asked, words) in [
        ("engine thre stones.png -o out", "did you mean 'three'"),
        ("engine unity stones.png -o out", "bake --for unity"),
        ("engine unreal stones.png --method voxels -o out", "--method"),
        ("engine three stones.png --method view-dependent -o out", "--method"),
        ("engine three stones.png --method voxels -o out", "--method"),
        ("engine godot stones.png --surface prism -o out", "--surface"),
        ("engine godot stones.png --mesh sphere --project box -o out", "--project"),
        ("engine godot stones.png --shadow map -o out", "--shadow"),
    ] {
        let refused = folder.relief(asked);
        assert!(refused.code == Some(2) && refused.stderr.contains(words), "{refused:?}");
        assert!(!folder.path("out").exists(), "{asked}");
    }
    folder.write("broken.png", b"no picture");
    assert_eq!(folder.relief("engine three broken.png -o out").code, Some(1));
    assert!(!folder.path("out").exists());
}

#[test]
fn files_that_somebody_changed_stay() {
    let folder = folder();
    folder.relief("engine godot stones.png -o scene -q").fine();
    let mine = text(&folder, "scene/relief.gdshader") + "// mine\n";
    folder.write("scene/relief.gdshader", &mine);
    let failed = folder.relief("engine godot stones.png --scale 4cm -o scene");
    assert!(failed.code == Some(1) && failed.stderr.contains("relief.gdshader"), "{failed:?}");
    assert_eq!(text(&folder, "scene/relief.gdshader"), mine);
    folder.relief("engine godot stones.png --scale 4cm -o scene --force -q").fine();
    assert!(!text(&folder, "scene/relief.gdshader").contains("// mine"));
}

#[test]
fn files_of_others_stay() {
    let folder = folder();
    folder.write("page/index.html", b"mine");
    let failed = folder.relief("engine three stones.png -o page");
    let says = |word: &str| failed.stderr.contains(word);
    assert!(failed.code == Some(1) && says("index.html") && says("--force"), "{failed:?}");
    assert_eq!(text(&folder, "page/index.html"), "mine");
    let left: Vec<_> = std::fs::read_dir(folder.path("page")).expect("a folder").collect();
    assert_eq!(left.len(), 1, "{left:?}");
    folder.relief("engine three stones.png -o page --force -q").fine();
    assert!(text(&folder, "page/index.html").contains("applyRelief"));
}
