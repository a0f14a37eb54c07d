//! `relief render FILE` with a scene, a height map, a mesh or a depth object, and words that users
//! know from other programs.

use crate::common::command::{Folder, json_of};
use crate::common::maps::Map;
use crate::common::meshes::obj;
use crate::common::refused::{assert_refused, with_out};
use relief_core::mesh::torus;
use relief_io::HeightOptions;

const SMALL: &str = "--size 40x30 --samples 1 --backend cpu";

fn folder() -> Folder {
    let folder = with_out();
    folder.write("hills.png", Map::hills().png());
    folder.write("hills.heights", Map::hills().png());
    folder.write("ring.obj", obj(&torus(32, 16).expect("a mesh")));
    folder.write("scene.toml", "height = \"hills.png\"\nscale = 0.1\n");
    folder
}

/// The bytes of the picture that a line renders.
fn picture(folder: &Folder, what: &str) -> Vec<u8> {
    folder.relief(&format!("render {what} {SMALL} -q -o picture.png")).fine();
    std::fs::read(folder.path("picture.png")).expect("it was written")
}

#[test]
fn a_file_is_shown_whatever_it_is() {
    let folder = folder();
    let map = picture(&folder, "--height hills.png");
    assert_eq!(picture(&folder, "hills.png"), map);
    assert_eq!(picture(&folder, "hills.heights"), map, "its name says nothing, its content does");
    assert_ne!(picture(&folder, "scene.toml"), map);
    assert_eq!(
        picture(&folder, "ring.obj --height hills.png"),
        picture(&folder, "--mesh ring.obj --height hills.png")
    );
    folder.relief("capture ring.obj --size 16 --verify 0 --cover centre -q -o ring").fine();
    let object = picture(&folder, "--object ring/object.toml");
    assert_eq!(picture(&folder, "ring/object.toml"), object);
    // From the standard input, too.
    let mut command = folder.command();
    let input = std::fs::File::open(folder.path("hills.png")).expect("it is there");
    command.args(["render", "-", "-q", "-o", "piped.png"]).args(SMALL.split(' ')).stdin(input);
    assert!(command.status().expect("it starts").success());
    assert_eq!(std::fs::read(folder.path("piped.png")).expect("it was written"), map);
}

#[test]
fn a_mesh_alone_is_shown_as_it_is() {
    let folder = folder();
    let alone = picture(&folder, "--mesh ring.obj");
    assert_eq!(picture(&folder, "ring.obj"), alone);
    folder.write("alone.toml", "mesh = \"ring.obj\"\n");
    assert_eq!(picture(&folder, "alone.toml"), alone);
    // It is there: much of the frame is no background.
    let image = image::load_from_memory(&alone).expect("a PNG").to_rgb8();
    let corner = *image.get_pixel(0, 0);
    let shown = image.pixels().filter(|pixel| **pixel != corner).count();
    assert!(shown * 100 > 20 * image.pixels().len(), "{shown} pixels");
    // So it is without texture coordinates, and however small.
    let covered = |side: f32| {
        let [a, b] = [-side, side];
        let corners = [[a, 0.0, a], [a, 0.0, b], [b, 0.0, b], [b, 0.0, a]];
        let lines = corners.map(|[x, y, z]| format!("v {x} {y} {z}\n")).concat();
        folder.write("bare.obj", format!("{lines}f 1 2 3\nf 1 3 4\n"));
        let image = image::load_from_memory(&picture(&folder, "bare.obj")).expect("a PNG").to_rgb8();
        let corner = *image.get_pixel(0, 0);
        image.pixels().filter(|pixel| **pixel != corner).count()
    };
    let of_one_metre = covered(1.0);
    assert!(of_one_metre > 300, "{of_one_metre} pixels");
    assert!(covered(0.001).abs_diff(of_one_metre) * 50 < of_one_metre, "{} pixels", covered(0.001));
    // Where a height map is what is asked for, it is still missed.
    folder.write("alone.toml", "mesh = \"ring.obj\"\n");
    let ran = folder.relief("slices alone.toml -o out/ring.glb");
    assert_refused(&folder, &ran, 1, &["no height map"]);
    for line in ["render --mesh sphere", "render"] {
        let ran = folder.relief(&format!("{line} -o out/a.png"));
        assert_refused(&folder, &ran, 2, &["--height"]);
    }
}

#[test]
fn what_is_named_twice_or_not_there_is_refused() {
    let folder = folder();
    for (line, code, word) in [
        ("render hills.png --height hills.png", 2, "--height"),
        ("render ring.obj --mesh sphere --height hills.png", 2, "--mesh"),
        ("render missing.png", 1, "missing.png"),
        ("render missing.toml", 1, "missing.toml"),
    ] {
        let ran = folder.relief(&format!("{line} -o out/a.png"));
        assert_refused(&folder, &ran, code, &[word]);
    }
}

#[test]
fn errors_blame_the_flag_that_was_given() {
    let folder = folder();
    for (flags, flag) in [
        ("--surface object", "--surface"),
        ("--geometry slices --surface prism", "--geometry"),
        ("--method cone --surface facets", "--surface"),
        ("--shadow-search none", "--shadow-search"),
    ] {
        let ran = folder.relief(&format!("render --height hills.png {flags} -o out/a.png"));
        assert_refused(&folder, &ran, 2, &[]);
        assert!(ran.stderr.starts_with(&format!("error: {flag}")), "{flags}: {}", ran.stderr);
    }
}

#[test]
fn quiet_leaves_what_was_asked_for() {
    let folder = folder();
    for line in [
        "render hills.png --size 20x20 --backend cpu -o a.png",
        "bake hills.png --kind normal -o maps",
        "mesh hills.png --texels 4 -o a.glb",
        "capture ring.obj --size 16 --verify 0 --cover centre -o ring",
        "shader --method bump --target wgsl -o shaders",
        "height procedure waves --size 16x16 -o waves.png",
        "scene --height hills.png -o a.toml",
    ] {
        let ran = folder.relief(&format!("{line} -q")).fine();
        assert_eq!(ran.stdout, "", "relief {line}");
    }
    // Answers that are the result stay, and so does what machines ask for.
    for line in
        ["inspect hills.png", "methods", "mesh hills.png --texels 4 --json -o a.glb", "scene hills.png"]
    {
        assert!(!folder.relief(&format!("{line} -q")).fine().stdout.is_empty(), "relief {line}");
    }
}

#[test]
fn one_kind_is_baked_into_one_file() {
    let folder = folder();
    let read = |name: &str| std::fs::read(folder.path(name)).expect("it was written");
    folder.relief("bake hills.png --kind normal -o maps").fine();
    folder.relief("bake hills.png --kind normal -o out/up.png").fine();
    let pixels = |name: &str| image::load_from_memory(&read(name)).expect("a PNG").to_rgb16();
    assert_eq!(pixels("out/up.png"), pixels("maps/hills.normal.png"));
    let names = crate::common::refused::entries(&folder.path("out"));
    assert_eq!(names, ["up.png"], "and nothing beside it");
    // Again, and in another format; another program's file stays.
    folder.relief("bake hills.png --kind normal -o out/up.png").fine();
    let said = json_of(&folder.relief("bake hills.png --kind cone --json -o out/cone.exr").fine());
    assert_eq!(said["baked"][0]["files"][0], "cone.exr", "{said}");
    std::fs::remove_dir_all(folder.path("out")).expect("writable");
    std::fs::create_dir(folder.path("out")).expect("writable");
    folder.write("mine.png", "mine");
    for (line, code, word) in [
        ("--kind normal -o mine.png", 1, "--force"),
        ("--kind normal,cone -o out/a.png", 2, "--output"),
        ("--kind normal --format exr -o out/a.png", 2, "--format"),
        ("--kind normal -o nowhere/a.png", 1, "nowhere"),
        ("--kind normal --set normal.mips=1 -o out/a.png", 2, "folder"),
    ] {
        let ran = folder.relief(&format!("bake hills.png {line}"));
        assert_refused(&folder, &ran, code, &[word]);
    }
    assert_eq!(read("mine.png"), b"mine");
}

#[test]
fn maps_have_the_names_of_other_programs() {
    let folder = folder();
    for (other, kind) in
        [("ao", "occlusion"), ("sky-view", "occlusion"), ("AO", "occlusion"), ("normals", "normal")]
    {
        let said = json_of(&folder.relief(&format!("bake hills.png --kind {other} --json -o maps")).fine());
        assert_eq!(said["baked"][0]["kind"], kind, "{said}");
    }
    folder.relief("bake hills.png --kind ao --set ao.azimuths=4 -o fewer.exr").fine();
    folder.relief("bake hills.png --kind occlusion --set occlusion.azimuths=4 -o same.exr").fine();
    folder.relief("bake hills.png --kind ao -o usual.exr").fine();
    let [fewer, same, usual] = ["fewer.exr", "same.exr", "usual.exr"].map(|name| {
        relief_io::read_height_file(&folder.path(name), &HeightOptions::default()).expect(name).map
    });
    assert!(fewer == same && fewer != usual);
    for (other, nearest) in [("curvature", "'normal'"), ("roughness", "'normal'"), ("normall", "'normal'")] {
        let ran = folder.relief(&format!("bake hills.png --kind {other} -o out/maps"));
        assert_refused(&folder, &ran, 2, &[nearest]);
    }
}

#[test]
fn help_begins_with_what_is_used_most() {
    let folder = Folder::new();
    for (command, flags) in [
        ("render", ["--output", "--height", "--mesh", "--shadow"]),
        ("mesh", ["--output", "--error", "--scale", "--view"]),
        ("bake", ["--kind", "--output", "--set", "--force"]),
        ("compare", ["--output", "--height", "--budget-ms", "--json"]),
    ] {
        let help = folder.relief(&format!("{command} -h")).fine().stdout;
        let options = help.split("Options:").nth(1).expect("a section").split("\n\n").next().expect("lines");
        // The texts of flags stand further to the right, and may begin with the name of another
        // flag.
        let of_a_flag = |line: &&str| line.trim_start().starts_with('-') && line.find('-') <= Some(6);
        let listed: Vec<&str> = options
            .lines()
            .filter(of_a_flag)
            .filter_map(|line| line.split_whitespace().find(|word| word.starts_with("--")))
            .collect();
        let places: Vec<_> = flags.iter().map(|flag| listed.iter().position(|known| known == flag)).collect();
        assert!(places.iter().all(|place| place.is_some_and(|place| place < 10)), "{command}: {listed:?}");
        assert!(places.is_sorted(), "{command}: {listed:?}");
    }
}
