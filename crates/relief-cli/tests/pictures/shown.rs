//! Numbers in colours, and methods side by side: `render --show` and `--methods`.

use std::fs;
use std::path::Path;

use crate::common::aov::Aov;
use crate::common::command::{Folder, json_of};
use crate::common::meshes::obj;
use crate::common::refused::{OUT, assert_refused, with_out};
use relief_core::mesh::cube;
use relief_io::read_picture;

const SMALL: &str = "render map.png --backend cpu --size 60x40";

/// Width of a letter, height of a line, and distances of a sheet, in pixels.
const GLYPH: usize = 7;
const LINE: usize = 16;
const GAP: usize = 16;

fn with_map(folder: Folder) -> Folder {
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/cobbles.png");
    fs::copy(shipped, folder.path("map.png")).expect("the shipped map");
    folder
}

/// Columns, rows and linear pixels of a picture's file.
fn pixels(folder: &Folder, name: &str) -> (usize, usize, Vec<[f32; 4]>) {
    let picture = read_picture(&folder.path(name), 1 << 28).expect("a picture");
    (picture.width as usize, picture.height as usize, picture.texels)
}

/// Cuts the picture out of a sheet whose left upper corner is there.
fn cut(
    (width, _, all): &(usize, usize, Vec<[f32; 4]>),
    [left, top]: [usize; 2],
    size: [usize; 2],
) -> Vec<[f32; 4]> {
    (top..top + size[1]).flat_map(|y| all[y * width + left..][..size[0]].to_vec()).collect()
}

#[test]
fn methods_stand_side_by_side_as_if_rendered_alone() {
    let folder = with_map(Folder::new());
    let methods = ["parallax", "relief", "linear+secant"];
    let set = "--set search.steps=9";
    let names = methods.join(",");
    let ran = folder.relief(&format!("{SMALL} --methods {names} {set} -o sheet.png --json")).fine();
    let about = json_of(&ran);
    let sheet = pixels(&folder, "sheet.png");
    assert_eq!([&about["width"], &about["height"]], [sheet.0, sheet.1]);
    assert_eq!(about["pictures"].as_array().map(Vec::len), Some(3));
    // The longest name is wider than its picture.
    let column = GLYPH * methods[2].len();
    assert_eq!([sheet.0, sheet.1], [3 * (column + GAP) + GAP, LINE + LINE / 4 + 40 + 2 * GAP]);
    let flags = ["--method parallax", "--method relief --set search.steps=9"];
    let flags = [flags[0], flags[1], "--search linear --refine secant --set search.steps=9"];
    for (place, (flags, name)) in flags.into_iter().zip(methods).enumerate() {
        folder.relief(&format!("{SMALL} {flags} -o alone.png")).fine();
        let (.., alone) = pixels(&folder, "alone.png");
        let at = [GAP + place * (column + GAP), GAP + LINE + LINE / 4];
        assert!(cut(&sheet, at, [60, 40]) == alone, "{name}");
    }
}

#[test]
fn shown_numbers_are_those_of_the_channels() {
    let folder = with_map(Folder::new());
    let flags = "--method relief --scale 0.2 --mesh sphere";
    folder.relief(&format!("{SMALL} {flags} -o plain.png --aov aov.exr")).fine();
    let shown = "height,depth,normal,reads,steps,lit,level";
    let ran = folder.relief(&format!("{SMALL} {flags} --show {shown} -o sheet.png --json")).fine();
    let about = json_of(&ran);
    let aov = Aov::read(&folder.path("aov.exr"));
    let hit = aov.plane("hit");
    for shown in about["pictures"][0]["shown"].as_array().expect("a list") {
        let name = shown["quantity"].as_str().expect("a name");
        let plane = aov.plane(name);
        let numbers = plane.iter().zip(hit).filter(|(_, hit)| **hit == 1.0).map(|(number, _)| *number);
        let ends = numbers.fold([f32::INFINITY, f32::NEG_INFINITY], |[least, most], number| {
            [least.min(number), most.max(number)]
        });
        // Heights of the channel are from 0 to 1; a scale of 0.2 m is centred on the base.
        let bias = shown["least"].as_f64().expect("a number") - f64::from(ends[0]) * 0.2;
        let [factor, bias] = if name == "height" { [0.2, bias] } else { [1.0, 0.0] };
        for (end, key) in ends.into_iter().zip(["least", "most"]) {
            let number = shown[key].as_f64().expect("a number");
            let expected = f64::from(end) * factor + bias;
            assert!((number - expected).abs() <= 1e-6 * expected.abs() + 1e-6, "{name} {key}: {number}");
        }
    }
    // Directions have no range; words give the others, too.
    assert_eq!(about["pictures"][0]["shown"].as_array().map(Vec::len), Some(6));
    let told = folder.relief(&format!("{SMALL} {flags} --show depth,steps -o told.jpg")).fine().stdout;
    assert!(told.contains("depth: ") && told.contains(" m\n") && told.contains(" steps\n"), "{told}");
}

#[test]
fn errors_are_distances_from_the_exact_hit() {
    let folder = with_map(Folder::new());
    for mesh in ["plane", "sphere"] {
        let flags = format!("--methods bump,cone,exact --show error,depth --mesh {mesh} --scale 0.1");
        let about = json_of(&folder.relief(&format!("{SMALL} {flags} -o {mesh}.png --json")).fine());
        let most = |column: usize| {
            let shown = &about["pictures"][column]["shown"][0];
            assert_eq!((shown["quantity"].as_str(), shown["unit"].as_str()), (Some("error"), Some("texels")));
            shown["most"].as_f64().expect("a number")
        };
        // Bump mapping has the places of the base.
        assert!(most(0) > 2.0, "{mesh}: {}", most(0));
        if mesh == "plane" {
            assert!(most(1) < 0.1 && most(2) < 1e-3, "{} {}", most(1), most(2));
        }
    }
}

#[test]
fn colours_are_compared_with_the_exact_picture() {
    let folder = with_map(Folder::new());
    let flags = "--methods bump,exact --show passed,color-error,flip --scale 0.1";
    let about = json_of(&folder.relief(&format!("{SMALL} {flags} -o sheet.png --json")).fine());
    for (number, name) in ["passed", "color-error", "flip"].into_iter().enumerate() {
        let [bump, exact] = [0, 1].map(|column| {
            let shown = &about["pictures"][column]["shown"][number];
            assert_eq!(shown["quantity"], name);
            shown["most"].as_f64().expect("a number")
        });
        assert!(bump > 0.1 && bump <= 1.0 && exact < 1e-5, "{name}: {bump} {exact}");
    }
    folder.write("two.toml", "height = \"map.png\"\n[[surfaces]]\n[[surfaces]]\nposition = [0, 0.3, 0]\n");
    folder.relief("render two.toml --size 60x40 --show flip -q -o two.png").fine();
    let refused = folder.relief("render two.toml --size 60x40 --show flip,passed -q -o two.png");
    assert!(refused.code == Some(2) && refused.stderr.contains("2 surfaces"), "{}", refused.stderr);
}

#[test]
fn numbers_of_a_gpu_are_shown_as_well() {
    let folder = with_map(Folder::new());
    let ran = |backend: &str| {
        let flags = "--methods relief,cone --show error,steps,height";
        folder.relief(&format!("render map.png --size 60x40 {flags} --backend {backend} -o {backend}.png"))
    };
    let on_gpu = ran("gpu");
    if on_gpu.code != Some(0) && std::env::var_os("RELIEF_REQUIRE_GPU").is_none() {
        println!("skipped: {}", on_gpu.stderr);
        return;
    }
    on_gpu.fine();
    ran("cpu").fine();
    let [(width, height, gpu), (.., cpu)] = ["gpu.png", "cpu.png"].map(|name| pixels(&folder, name));
    let other = gpu.iter().zip(&cpu).filter(|(gpu, cpu)| gpu != cpu).count();
    // A software adapter has the CPU's bits; a card rounds otherwise.
    assert!(other * 20 < width * height, "{other} of {}", width * height);
}

#[test]
fn what_cannot_be_shown_is_refused() {
    let folder = with_map(with_out());
    folder.write("cube.obj", obj(&cube(1).expect("a cube")));
    folder.relief("capture cube.obj --size 16 --verify 0 --cover pixel -o object").fine();
    folder.write(
        "two.toml",
        "[[surfaces]]\nheight = 'map.png'\n[[surfaces]]\nheight = 'map.png'\nmesh = 'cube'\n",
    );
    let refused = |line: &str, words: &[&str]| {
        let ran = folder.relief(&format!("render {line}"));
        let code = if words.contains(&"MiB") { 1 } else { 2 };
        assert_refused(&folder, &ran, code, words);
    };
    let out = format!("-o {OUT}/it.png");
    refused(&format!("map.png --show heigth {out}"), &["heigth", "'height'"]);
    refused(&format!("map.png --methods relif,cone {out}"), &["--methods", "relif", "'relief'"]);
    refused(&format!("map.png --methods linear+binery {out}"), &["--methods", "binery", "'binary'"]);
    refused(&format!("object --show error {out}"), &["--show error", "a depth object"]);
    refused(&format!("object --show depth,height {out}"), &["--show", "height", "a depth object"]);
    refused(&format!("two.toml --show error {out}"), &["--show error", "2 surfaces"]);
    refused(&format!("map.png --show depth -o {OUT}/it.exr"), &[".png", "--aov"]);
    refused(&format!("map.png --show depth --aov {OUT}/it.exr {out}"), &["--aov", "--show"]);
    refused(&format!("map.png --methods relief --method cone {out}"), &["--methods", "--method"]);
    refused(&format!("map.png --methods relief,bump --set search.limit=9 {out}"), &["--set", "search.limit"]);
    let wide = "--size 20000x20 --methods relief,cone";
    refused(&format!("map.png {wide} {out}"), &["32768", "--size"]);
    let large = "--size 3000x3000 --show error,depth --max-memory 256MiB";
    refused(&format!("map.png {large} {out}"), &["MiB", "--max-memory", "--size"]);
}
