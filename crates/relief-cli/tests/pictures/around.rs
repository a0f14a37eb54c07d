//! Everything around the work: scene files of flags, schemas, completions, manual pages, messages,
//! threads.

use std::fs;
use std::path::Path;

use crate::common::command::Folder;
use serde_json::Value;

fn map_folder() -> Folder {
    let folder = Folder::new();
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/cobbles.png");
    fs::copy(shipped, folder.path("map.png")).expect("the shipped map");
    folder
}

const FLAGS: &str = "--height map.png --method relief --set search.steps=24 --scale 3cm --mesh torus --tile \
    6,2 --view front --samples 2 --size 40x30 --material shininess=9 --point-light 0,2,0 --backend cpu";

#[test]
fn a_scene_file_of_flags_renders_the_same_picture() {
    let folder = map_folder();
    folder.relief(&format!("render {FLAGS} -o a.png")).fine();
    folder.relief(&format!("scene {FLAGS} -o scene.toml")).fine();
    folder.relief("render scene.toml -o b.png").fine();
    let read = |name: &str| fs::read(folder.path(name)).expect("it was written");
    assert!(read("a.png") == read("b.png"));
    let text = String::from_utf8(read("scene.toml")).expect("text");
    assert!(text.contains("\nscale = 0.03") && text.contains("# fov = 40"), "{text}");
    // Another folder, the standard output, and a scene with another key.
    fs::create_dir(folder.path("below")).expect("writable");
    folder.relief(&format!("scene {FLAGS} -o below/scene.toml")).fine();
    folder.relief("render below/scene.toml -o c.png").fine();
    assert!(read("a.png") == read("c.png"));
    let printed = folder.relief("scene scene.toml --samples 7").fine().stdout;
    assert_eq!(printed, text.replace("\nsamples = 2 ", "\nsamples = 7 "));
    for (line, code) in [
        ("scene --height map.png -o scene.txt", 2),
        ("scene --height map.png -o map.png", 2),
        ("scene --eye 1,2 -o x.toml", 2),
        ("scene --height map.png --fov 999 -o x.toml", 1),
        ("scene --schema -o x.toml", 2),
        ("scene not/there.toml", 1),
    ] {
        let ran = folder.relief(line);
        assert!(ran.code == Some(code) && !ran.stderr.is_empty(), "{ran:?}");
        assert!(!folder.path("x.toml").exists() && !folder.path("scene.txt").exists(), "{line}");
    }
}

#[test]
fn the_schema_knows_every_key_of_the_shipped_scenes() {
    let folder = Folder::new();
    let schema: Value = serde_json::from_str(&folder.relief("scene --schema").fine().stdout).expect("JSON");
    let knows = |properties: &Value, table: &toml::Table| {
        let unknown: Vec<&String> = table.keys().filter(|key| properties.get(key).is_none()).collect();
        assert!(unknown.is_empty(), "{unknown:?}");
    };
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let folders = [scenes.join("gallery"), scenes];
    let paths = folders.iter().flat_map(|folder| fs::read_dir(folder).expect("the shipped scenes"));
    let is_scene = |path: &std::path::PathBuf| path.extension().is_some_and(|ending| ending == "toml");
    for path in paths.map(|entry| entry.expect("an entry").path()).filter(is_scene) {
        let text = fs::read_to_string(path).expect("text");
        let table: toml::Table = text.parse().expect("TOML");
        knows(&schema["properties"], &table);
        let own = &schema["properties"]["surfaces"]["items"]["properties"];
        for surface in table.get("surfaces").and_then(toml::Value::as_array).into_iter().flatten() {
            knows(own, surface.as_table().expect("a table"));
        }
    }
    assert_eq!(schema["properties"]["tone"]["enum"], serde_json::json!(["none", "agx"]));
    // Editors know what numbers are accepted.
    let of = |key: &str| &schema["properties"][key];
    assert_eq!(
        (of("samples")["minimum"].as_f64(), of("samples")["maximum"].as_f64()),
        (Some(1.0), Some(1024.0))
    );
    assert_eq!(of("fov")["exclusiveMaximum"].as_f64(), Some(180.0));
    assert_eq!(of("tile")["items"]["maximum"].as_f64(), Some(1e6));
    assert_eq!(of("scale")["minimum"].as_f64(), Some(0.0));
    assert!(of("rotation")["items"].get("minimum").is_none());
    let steps = &of("set")["properties"]["search"]["properties"]["steps"];
    assert!(steps["maximum"].as_f64() > Some(1000.0) && steps["description"].is_string(), "{steps}");
}

#[test]
fn completions_and_pages_come_one_by_one_and_as_files() {
    let folder = Folder::new();
    for shell in ["bash", "elvish", "fish", "powershell", "zsh"] {
        let text = folder.relief(&format!("completions {shell}")).fine().stdout;
        assert!(text.contains("samples") && text.contains("from-normals"), "{shell}");
    }
    folder.relief("completions --output share/completions").fine();
    assert_eq!(fs::read_dir(folder.path("share/completions")).expect("a folder").count(), 5);
    let page = folder.relief("man render").fine().stdout;
    assert!(page.contains(".TH") && page.contains("samples"), "{page}");
    assert!(folder.relief("man").fine().stdout.contains("relief\\-render"));
    folder.relief("man --output share/man").fine();
    let pages = fs::read_dir(folder.path("share/man")).expect("a folder").flatten();
    let names: Vec<String> = pages.map(|page| page.file_name().to_string_lossy().into_owned()).collect();
    for name in ["relief.1", "relief-bake.1", "relief-height-from-photos.1", "relief-scene.1"] {
        assert!(names.contains(&name.to_owned()), "{names:?}");
    }
    let unknown = folder.relief("man rendr");
    assert!(unknown.code == Some(2) && unknown.stderr.contains("render"), "{unknown:?}");
    assert_eq!(folder.relief("completions").code, Some(2));
}

#[test]
fn quiet_says_nothing_and_verbose_what_was_done() {
    let folder = map_folder();
    fs::rename(folder.path("map.png"), folder.path("map_depth.png")).expect("writable");
    let line = "render --height map_depth.png --backend cpu --size 20x20 -o a.png";
    let usual = folder.relief(line);
    assert_eq!(usual.code, Some(0));
    assert!(usual.stderr.contains("note:") && usual.stderr.contains("--depth"), "{usual:?}");
    for quiet in ["-q", "--quiet"] {
        let ran = folder.relief(&format!("{quiet} {line}")).fine();
        assert_eq!(ran.stderr, "");
        assert!(folder.relief(&format!("{line} {quiet}")).fine().stderr.is_empty());
    }
    let verbose = folder.relief(&format!("{line} -v --depth")).stderr;
    assert!(verbose.contains("reading: ") && verbose.contains("rendering: "), "{verbose}");
    assert_eq!(folder.relief(&format!("{line} -q -v")).code, Some(2));
}

#[test]
fn threads_change_time_and_no_byte() {
    let folder = map_folder();
    let line = "render --height map.png --backend cpu --size 60x40";
    for threads in [1, 3] {
        let ran = folder.relief(&format!("{line} -o {threads}.png --threads {threads} --json")).fine();
        let about: Value = serde_json::from_str(&ran.stdout).expect("JSON");
        assert!(
            about["device"].as_str().is_some_and(|text| text.starts_with(&threads.to_string())),
            "{about}"
        );
    }
    let read = |name: &str| fs::read(folder.path(name)).expect("it was written");
    assert!(read("1.png") == read("3.png"));
    for bad in ["0", "-1", "many", "5000"] {
        assert_eq!(folder.relief(&format!("{line} -o a.png --threads {bad}")).code, Some(2), "{bad}");
    }
}

#[test]
fn the_short_help_is_shorter() {
    let folder = Folder::new();
    for command in ["bake", "render"] {
        let [short, long] =
            ["-h", "--help"].map(|help| folder.relief(&format!("{command} {help}")).fine().stdout);
        assert!(4 * short.lines().count() < 3 * long.lines().count(), "{command}");
    }
    let text = folder.relief("--help").fine().stdout;
    assert!(text.contains("Exit codes"), "{text}");
}

#[test]
fn the_table_of_pairs_in_the_docs_is_the_commands() {
    let folder = Folder::new();
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/pairs.md");
    let docs = fs::read_to_string(docs).expect("the table in the docs");
    let printed = folder.relief("methods --pairs").fine().stdout;
    assert!(docs.ends_with(&printed), "write it anew: {printed}");
    let pairs = folder.relief("methods --pairs --json").fine().stdout;
    let pairs: Vec<Value> = serde_json::from_str(&pairs).expect("JSON");
    let refused = pairs.iter().filter(|pair| pair["guarantee"].is_null()).count();
    assert_eq!(refused, printed.matches("| no ").count());
}
