//! Meshes of files through the command: rendered as the built-in shapes are, inspected, and refused
//! with advice.

use crate::common::aov::Aov;
use crate::common::command::Folder;
use crate::common::maps::Map;
use crate::common::refused::{assert_refused, with_out};
use relief_core::mesh::{Mesh, cube, torus};
use serde_json::{Value, json};

/// An OBJ with normals, and with texture coordinates or without.
fn obj(mesh: &Mesh, has_uvs: bool) -> String {
    let mut text = String::new();
    for vertex in mesh.vertices() {
        let [[x, y, z], [nx, ny, nz]] = [vertex.position, vertex.normal].map(|vector| vector.to_array());
        text += &format!("v {x} {y} {z}\nvn {nx} {ny} {nz}\n");
        if has_uvs {
            text += &format!("vt {} {}\n", vertex.uv.x, 1.0 - f64::from(vertex.uv.y));
        }
    }
    for corners in mesh.triangles() {
        let words = corners.map(|index| match (index + 1, has_uvs) {
            (n, true) => format!("{n}/{n}/{n}"),
            (n, false) => format!("{n}//{n}"),
        });
        text += &format!("f {}\n", words.join(" "));
    }
    text
}

/// A folder with a map, a torus as the built-in one is, and a cube without texture coordinates.
fn folder() -> Folder {
    let folder = with_out();
    folder.write("hills.png", Map::hills().png());
    folder.write("meshes/torus.obj", obj(&torus(128, 64).expect("a mesh"), true));
    folder.write("cube.obj", obj(&cube(1).expect("a mesh"), false));
    folder
}

const LOOK: &str = "--height hills.png --tile 6,2 --scale 0.03 --size 160x120 --samples 1 --backend cpu";

/// The part of the pixels that both pictures show, and the greatest difference of most of these, in
/// metres and in texture coordinates.
fn compare(a: &Aov, b: &Aov) -> [f64; 3] {
    let (mut alike, mut of_positions, mut of_uvs) = (0, Vec::new(), Vec::new());
    for ((_, _, a), (_, _, b)) in a.pixels().zip(b.pixels()) {
        alike += usize::from(a.hit == b.hit);
        if a.hit == 1.0 && b.hit == 1.0 {
            of_positions.push((a.position - b.position).length());
            of_uvs.push((a.uv - b.uv).length());
        }
    }
    let nearly_all = |mut differences: Vec<f64>| {
        differences.sort_by(f64::total_cmp);
        differences[differences.len() * 99 / 100]
    };
    [alike as f64 / (a.width * a.height) as f64, nearly_all(of_positions), nearly_all(of_uvs)]
}

#[test]
fn a_mesh_of_a_file_looks_as_the_built_in_one() {
    let folder = folder();
    let rendered = |mesh: &str, name: &str| {
        folder.relief(&format!("render {LOOK} {mesh} --aov {name}.exr -o {name}.png")).fine();
        Aov::read(&folder.path(format!("{name}.exr")))
    };
    let (built_in, read) =
        (rendered("--mesh torus", "built-in"), rendered("--mesh meshes/torus.obj", "read"));
    let [alike, positions, uvs] = compare(&built_in, &read);
    assert!(alike > 0.998 && positions < 1e-3 && uvs < 3e-3, "{alike} {positions} {uvs}");
    // Another mesh is another picture.
    let other = rendered("--mesh cube.obj --project box", "cube");
    assert!(compare(&built_in, &other)[0] < 0.9);
    let boxed = rendered("--mesh cube", "boxed");
    let [alike, positions, uvs] = compare(&other, &boxed);
    assert!(alike > 0.999 && positions < 1e-5 && uvs < 1e-5, "{alike} {positions} {uvs}");
}

#[test]
fn scenes_name_meshes_beside_them() {
    let folder = folder();
    let scene = "height = \"../hills.png\"\nsize = [64, 48]\nsamples = 1\nbackend = \"cpu\"\nscale = 0.02\n\
        [[surfaces]]\nmesh = \"torus.obj\"\ntile = [6, 2]\n\
        [[surfaces]]\nmesh = \"../cube.obj\"\nproject = \"box\"\nposition = [2, 0, 0]\nsize = 0.5\n\
        [[surfaces]]\nmesh = \"sphere\"\nposition = [-2, 0, 0]\n";
    folder.write("meshes/scene.toml", scene);
    folder.relief("render meshes/scene.toml -o all.png").fine();
    // A scene that is written names what it was made of.
    folder
        .relief("scene --height hills.png --mesh cube.obj --project cylinder --size 64x48 -o flags.toml")
        .fine();
    folder
        .relief("scene --height hills.png --mesh cube.obj --project sphere --size 64x48 -o out/flags.toml")
        .fine();
    folder.relief("render flags.toml -o flags.png").fine();
    folder.relief("render out/flags.toml -o out.png").fine();
    // Another mesh takes the place of the scene's with its projection.
    folder.relief("render flags.toml --mesh torus -o torus.png").fine();
    let same = std::fs::read(folder.path("flags.png")).expect("a picture");
    assert_ne!(same, std::fs::read(folder.path("out.png")).expect("a picture"));
}

#[test]
fn what_cannot_be_rendered_is_refused_with_what_to_do() {
    let folder = folder();
    folder.write("broken.obj", "v 0 0 0\nf 1 2 3\n");
    folder
        .write("far.gltf", r#"{"asset": {"version": "2.0"}, "buffers": [{"byteLength": 8, "uri": "../x"}]}"#);
    let cases: [(&str, i32, &[&str]); 9] = [
        ("--mesh cube.obj", 1, &["cube.obj", "texture coordinates", "--project"]),
        ("--mesh missing.ply", 1, &["missing.ply"]),
        ("--mesh broken.obj", 1, &["broken.obj", "line 2"]),
        ("--mesh far.gltf", 1, &["far.gltf"]),
        ("--mesh toros", 2, &["--mesh", "torus", ".glb"]),
        ("--mesh cube.obj --project cone", 2, &["--project", "cylinder"]),
        ("--project box", 2, &["--project", "--mesh FILE"]),
        ("--mesh cube --project box", 2, &["--project", "--mesh FILE"]),
        ("--mesh meshes/torus.obj --max-memory 10MiB", 1, &["torus.obj", "--max-memory"]),
    ];
    for (flags, code, words) in cases {
        let ran = folder.relief(&format!("render --height hills.png --size 64x48 {flags} -o out/a.png"));
        assert_refused(&folder, &ran, code, words);
    }
    folder.write("scene.toml", "height = \"hills.png\"\nmesh = \"cube.step\"\n");
    assert_refused(&folder, &folder.relief("render scene.toml -o out/a.png"), 1, &["line 2", ".glb"]);
    folder.write("scene.toml", "height = \"hills.png\"\nproject = \"box\"\n");
    assert_refused(&folder, &folder.relief("render scene.toml -o out/a.png"), 1, &["line 2", "mesh"]);
}

#[test]
fn meshes_are_inspected() {
    let folder = folder();
    let inspect = |line: &str| -> Value {
        let ran = folder.relief(&format!("inspect --json {line}")).fine();
        serde_json::from_str(&ran.stdout).expect("JSON")
    };
    let torus = inspect("meshes/torus.obj");
    assert_eq!((&torus["format"], &torus["triangles"]), (&json!("OBJ"), &json!(2 * 128 * 64)));
    assert_eq!(
        (&torus["charts"], &torus["seams"], &torus["open_edges"]),
        (&json!(1), &json!(128 + 64), &json!(0))
    );
    // The tube folds inward at its radius, the hole closes outward at its own.
    for (way, metres) in [("inward", 0.15), ("outward", 0.2)] {
        let fold = torus["first_fold_m"][way].as_f64().expect("metres");
        assert!((fold - metres).abs() < 1e-3, "{way}: {fold}");
    }
    let boxed = inspect("cube.obj --project box");
    assert_eq!(boxed["first_fold_m"], json!({ "inward": null, "outward": null }));
    assert_eq!(
        (&boxed["charts"], &boxed["hard_edges"], &boxed["points"]),
        (&json!(6), &json!(12), &json!(8))
    );
    assert_eq!(boxed["bounds_m"], json!([[-0.5, -0.5, -0.5], [0.5, 0.5, 0.5]]));
    let text = folder.relief("inspect meshes/torus.obj").fine().stdout;
    for part in
        ["torus.obj", "OBJ", "16384 triangles", "1 m x 0.3 m x 1 m", "closed", "charts", "tile u", "normals"]
    {
        assert!(text.contains(part), "'{part}' is missing:\n{text}");
    }
    let lines = |text: &str, words: [&str; 2]| {
        text.lines().filter(|line| words.iter().all(|word| line.contains(word))).count()
    };
    assert_eq!([lines(&text, ["inward", " m "]), lines(&text, ["outward", " m "])], [1, 1], "{text}");
    let text = folder.relief("inspect cube.obj --project box").fine().stdout;
    assert_eq!([lines(&text, ["inward", "none"]), lines(&text, ["outward", "none"])], [1, 1], "{text}");
    // Without coordinates of its own it is measured by a projection, which is said.
    let text = folder.relief("inspect cube.obj").fine().stdout;
    assert!(text.contains("no texture coordinates") && text.contains("--project"), "{text}");
    for flag in ["--channel r", "--raw 4x4,le", "--fill", "--normal hills.png"] {
        let ran = folder.relief(&format!("inspect meshes/torus.obj {flag}"));
        assert_refused(&folder, &ran, 2, &["height maps"]);
    }
    assert_refused(&folder, &folder.relief("inspect hills.png --project box"), 2, &["--project"]);
}

/// A red square of 1 m that looks up, as a glTF with its buffer beside it.
fn write_red_square(folder: &Folder) {
    let numbers: [f32; 20] =
        [-1., 0., -1., -1., 0., 1., 1., 0., 1., 1., 0., -1., 0., 0., 0., 1., 1., 1., 1., 0.];
    let mut buffer: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
    buffer.extend([0, 1, 2, 0, 2, 3]);
    folder.write("red.bin", buffer);
    let file = json!({
        "asset": { "version": "2.0" }, "scenes": [{ "nodes": [0] }], "nodes": [{ "mesh": 0 }],
        "meshes": [{ "primitives": [
            { "attributes": { "POSITION": 0, "TEXCOORD_0": 1 }, "indices": 2, "material": 0 },
        ] }],
        "materials": [{ "pbrMetallicRoughness": { "baseColorFactor": [1, 0, 0, 1] } }],
        "accessors": [
            {
                "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
                "min": [-1, 0, -1], "max": [1, 0, 1],
            },
            { "bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2" },
            { "bufferView": 2, "componentType": 5121, "count": 6, "type": "SCALAR" },
        ],
        "bufferViews": [
            { "buffer": 0, "byteOffset": 0, "byteLength": 48 },
            { "buffer": 0, "byteOffset": 48, "byteLength": 32 },
            { "buffer": 0, "byteOffset": 80, "byteLength": 6 },
        ],
        "buffers": [{ "uri": "red.bin", "byteLength": 86 }],
    });
    folder.write("red.gltf", file.to_string());
}

#[test]
fn a_gltf_has_its_own_colour_unless_another_is_given() {
    let folder = folder();
    write_red_square(&folder);
    folder.write(
        "green.png",
        crate::common::maps::encoded(
            &image::DynamicImage::ImageRgb8(image::RgbImage::from_pixel(1, 1, image::Rgb([0, 255, 0]))),
            image::ImageFormat::Png,
        ),
    );
    let middle = |flags: &str| {
        let line = format!(
            "render --height hills.png --mesh red.gltf --scale 0.001 --look plain --view top --size 32x32 \
             --samples 1 --material specular=0,0,0 --backend cpu {flags} -o a.png"
        );
        folder.relief(&line).fine();
        image::open(folder.path("a.png")).expect("a picture").to_rgb8().get_pixel(16, 16).0
    };
    let [red, green, blue] = middle("");
    assert!(red > 100 && green == 0 && blue == 0, "{red} {green} {blue}");
    for flags in ["--color green.png", "--material diffuse=0,1,0"] {
        let [red, green, blue] = middle(flags);
        assert!(green > 100 && red == 0 && blue == 0, "{flags}: {red} {green} {blue}");
    }
}
