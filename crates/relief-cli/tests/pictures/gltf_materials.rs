//! Materials of a glTF with all five pictures: shown by `render`, and written again by `mesh`.

use crate::common::command::Folder;
use crate::common::maps::{Map, encoded};
use crate::common::meshes::{part, square};
use image::{DynamicImage, ImageFormat, Rgb, RgbImage};
use relief_io::{MeshOptions, read_mesh};

/// Picture of the material's square from the front, without a height map.
fn render(folder: &Folder, mesh: &str, more: &str) -> (RgbImage, String) {
    let line = format!(
        "render --mesh {mesh} --projection orthographic --eye 0.5,0.5,3 --target 0.5,0.5,0 --view-height 1 \
         --size 48x48 --samples 1 --shadow none --ambient constant --backend cpu {more} -o out.png"
    );
    let ran = folder.relief(&line);
    assert_eq!(ran.code, Some(0), "{more}: {}", ran.stderr);
    (image::open(folder.path("out.png")).expect("a picture").into_rgb8(), ran.stderr)
}

/// A folder with five pictures, each for one part of a material.
fn folder() -> Folder {
    let folder = Folder::new();
    let write = |name: &str, texel: fn(u32, u32) -> [u8; 3]| {
        let picture = RgbImage::from_fn(16, 16, |x, y| Rgb(texel(x, y)));
        folder.write(name, encoded(&DynamicImage::ImageRgb8(picture), ImageFormat::Png));
    };
    write("base.png", |x, _| [200, 80 + 8 * x as u8, 60]);
    write("rough.png", |x, y| [0, 60 + 10 * y as u8, if x < 8 { 255 } else { 0 }]);
    write("normal.png", |x, y| if (x + y) % 8 < 4 { [170, 128, 247] } else { [86, 128, 247] });
    write("ao.png", |x, y| [if (x / 4 + y / 4) % 2 == 0 { 60 } else { 255 }; 3]);
    write("light.png", |x, y| if x.abs_diff(8) < 3 && y.abs_diff(8) < 3 { [0, 255, 90] } else { [0; 3] });
    folder.write("flat.png", Map::constant(0.5).png());
    folder
}

/// Textures, each with its place in a material, and keys that they need.
const FIVE: [(&str, &str); 5] = [
    ("base", r#""baseColorTexture": {"index": 0}"#),
    ("rough", r#""metallicRoughnessTexture": {"index": 1}"#),
    ("normal", r#""normalTexture": {"index": 2, "scale": 0.75}"#),
    ("ao", r#""occlusionTexture": {"index": 3, "strength": 0.5}"#),
    ("light", r#""emissiveTexture": {"index": 4}, "emissiveFactor": [1, 0.5, 1]"#),
];

const EXTENSIONS: &str = r#""KHR_materials_ior": {"ior": 1.75},
    "KHR_materials_specular": {"specularFactor": 0.5},
    "KHR_materials_emissive_strength": {"emissiveStrength": 1.5},
    "KHR_materials_transmission": {"transmissionFactor": 0.25}"#;

/// Writes a square whose material has the five pictures but one.
fn write(folder: &Folder, name: &str, without: Option<&str>, extensions: &str) {
    let is_kept = |(picture, _): &&(&str, &str)| Some(*picture) != without;
    let kept = |range: std::ops::Range<usize>| {
        let each = FIVE[range].iter().filter(is_kept).map(|(_, key)| *key);
        each.map(|key| format!(", {key}")).collect::<String>()
    };
    let images = FIVE.map(|(picture, _)| format!(r#"{{"uri": "{picture}.png"}}"#)).join(", ");
    let more = format!(
        r#", "materials": [{{"name": "five", "pbrMetallicRoughness": {{"baseColorFactor": [0.9, 0.9, 0.9, 1],
        "roughnessFactor": 0.75, "metallicFactor": 0.875{}}}{}, "extensions": {{{extensions}}}}}],
        "textures": [{{"source": 0}}, {{"source": 1}}, {{"source": 2}}, {{"source": 3}}, {{"source": 4}}],
        "images": [{images}]"#,
        kept(0..2),
        kept(2..5)
    );
    square(folder, name, &part(4, 0), &more);
}

#[test]
fn each_of_five_pictures_is_shown_and_comes_back_from_a_mesh() {
    let folder = folder();
    write(&folder, "five.gltf", None, EXTENSIONS);
    let ran = folder.relief("mesh flat.png --mesh five.gltf --scale 0 -o again.glb");
    assert_eq!((ran.code, ran.stderr.as_str()), (Some(0), ""));
    for look in ["plain", "studio"] {
        let more = format!("--look {look}");
        let (shown, notes) = render(&folder, "five.gltf", &more);
        assert!(notes.contains("transmission 0.25 is not shown"), "{notes}");
        assert!(notes.contains("specular factor"), "{notes}");
        let (again, _) = render(&folder, "again.glb", &more);
        assert!(again == shown, "{look}: the written mesh has another picture");
        for (picture, _) in FIVE {
            write(&folder, "four.gltf", Some(picture), EXTENSIONS);
            assert!(render(&folder, "four.gltf", &more).0 != shown, "{look}: {picture} is not shown");
        }
        // Extensions change the picture, too: reflection and the strength of the light.
        write(&folder, "plain.gltf", None, "");
        assert!(render(&folder, "plain.gltf", &more).0 != shown, "{look}: extensions");
    }
    // The written file has the values and extensions of the first.
    let bytes = std::fs::read(folder.path("again.glb")).expect("a file");
    let length = u32::from_le_bytes([bytes[12], bytes[13], bytes[14], bytes[15]]) as usize;
    let json: serde_json::Value = serde_json::from_slice(&bytes[20..20 + length]).expect("JSON");
    let material = &json["materials"][0];
    assert_eq!(material["extensions"]["KHR_materials_transmission"]["transmissionFactor"], 0.25);
    assert_eq!(material["extensions"]["KHR_materials_ior"]["ior"], 1.75);
    assert_eq!(material["normalTexture"]["scale"], 0.75);
    assert_eq!(material["occlusionTexture"]["strength"], 0.5);
    assert_eq!(material["pbrMetallicRoughness"]["metallicFactor"], 0.875);
    assert_eq!(json["images"].as_array().map(Vec::len), Some(5));
}

#[test]
fn values_and_maps_of_a_surface_go_before_those_in_a_file() {
    let folder = folder();
    write(&folder, "five.gltf", None, "");
    let (shown, _) = render(&folder, "five.gltf", "");
    let mut seen = vec![shown];
    for more in [
        "--color ao.png",
        "--roughness ao.png",
        "--occlusion rough.png",
        "--emission base.png",
        "--normal base.png",
        "--material roughness=0.1",
        "--material metallic=0",
        "--material emission=0,0,0",
        "--shade blinn-phong",
    ] {
        let (other, _) = render(&folder, "five.gltf", more);
        assert!(!seen.contains(&other), "{more}");
        seen.push(other);
    }
    // A height map gives the normals.
    let line = "render --height flat.png --mesh five.gltf --backend cpu --size 32x24 -o out.png";
    let ran = folder.relief(line);
    assert!(ran.code == Some(0) && ran.stderr.contains("normals is not shown"), "{}", ran.stderr);
}

#[test]
fn wrong_materials_are_refused_with_the_reason() {
    let folder = folder();
    for (extensions, wanted) in [
        (r#""KHR_materials_ior": {"ior": 0.5}"#, "KHR_materials_ior.ior is 0.5, which must be 0 or a number"),
        (r#""KHR_materials_specular": {"specularFactor": "x"}"#, "KHR_materials_specular.specularFactor"),
        (r#""KHR_materials_specular": {"specularColorFactor": [1]}"#, "must be three numbers from 0"),
        (r#""KHR_materials_emissive_strength": {"emissiveStrength": -1}"#, "must be a number from 0"),
    ] {
        write(&folder, "bad.gltf", None, extensions);
        let ran = folder.relief("render --mesh bad.gltf --backend cpu --size 16x16 -o bad.png");
        assert!(ran.code != Some(0) && ran.stderr.contains(wanted), "{extensions}: {}", ran.stderr);
        assert!(!folder.path("bad.png").exists());
    }
    for (name, wanted) in [("../secret.png", "secret.png"), ("none.png", "none.png")] {
        write(&folder, "bad.gltf", None, "");
        let text = std::fs::read_to_string(folder.path("bad.gltf")).expect("it was written");
        folder.write("bad.gltf", text.replace("rough.png", name));
        let ran = folder.relief("render --mesh bad.gltf --backend cpu --size 16x16 -o bad.png");
        assert!(ran.code != Some(0) && ran.stderr.contains(wanted), "{name}: {}", ran.stderr);
    }
    write(&folder, "bad.gltf", None, "");
    let text = std::fs::read_to_string(folder.path("bad.gltf")).expect("it was written");
    folder.write("bad.gltf", text.replace(r#"{"source": 3}"#, r#"{"source": 93}"#));
    let ran = folder.relief("render --mesh bad.gltf --backend cpu --size 16x16 -o bad.png");
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    // An own place of one picture is noted, and the picture is left out.
    write(&folder, "moved.gltf", None, "");
    let text = std::fs::read_to_string(folder.path("moved.gltf")).expect("it was written");
    let moved = r#"{"index": 3, "extensions": {"KHR_texture_transform": {"scale": [2, 2]}}, "#;
    folder.write("moved.gltf", text.replace(r#"{"index": 3, "#, moved));
    let (_, notes) = render(&folder, "moved.gltf", "");
    assert!(notes.contains("the picture of its occlusion is left out"), "{notes}");
}

/// Part of the pixels within 3 of 255 in all channels.
fn near(a: &RgbImage, b: &RgbImage) -> f64 {
    let pixels = a.pixels().zip(b.pixels());
    let is_near = |(a, b): &(&Rgb<u8>, &Rgb<u8>)| (0..3).all(|at| a.0[at].abs_diff(b.0[at]) <= 3);
    pixels.filter(is_near).count() as f64 / f64::from(a.width() * a.height())
}

#[test]
fn a_coarse_mesh_with_a_map_of_normals_looks_as_exact_does() {
    let folder = Folder::new();
    folder.write("hills.png", Map::many_hills().png());
    let shown = |what: &str, backend: &str| {
        let line = format!(
            "render {what} --projection orthographic --eye 0,2,0.001 --target 0,0,0 --view-height 0.9 \
             --size 160x160 --samples 4 --shadow none --ambient constant --look plain --shade \
             metallic-roughness --material base=0.5,0.5,0.5 --material roughness=0.8 --material metallic=0 \
             --backend {backend} -o out.png"
        );
        let ran = folder.relief(&line);
        assert_eq!(ran.code, Some(0), "{what}: {}", ran.stderr);
        image::open(folder.path("out.png")).expect("a picture").into_rgb8()
    };
    let exact = shown("--height hills.png --scale 0.08 --method exact", "cpu");
    let mesh = |more: &str, name: &str| {
        let ran = folder.relief(&format!("mesh hills.png --scale 0.08 --error 5% {more} -o {name}"));
        assert_eq!(ran.code, Some(0), "{more}: {}", ran.stderr);
    };
    mesh("--maps normal", "baked.glb");
    mesh("", "coarse.glb");
    mesh("--shading base", "bare.glb");
    let share = near(&exact, &shown("--mesh baked.glb", "cpu"));
    println!("{share}");
    assert!(share >= 0.95, "{share} of the pixels");
    // Vertices alone are worse, and the normals of the base alone much worse.
    let coarse = near(&exact, &shown("--mesh coarse.glb", "cpu"));
    let bare = near(&exact, &shown("--mesh bare.glb", "cpu"));
    println!("{coarse}, {bare}");
    assert!(coarse < share && bare < 0.5, "{coarse}, {bare}");

    mesh("--maps normal,occlusion --solid 3 --print-size 100", "both.glb");
    let options = MeshOptions { colors: true, materials: true, ..MeshOptions::default() };
    let read = |name: &str| read_mesh(folder.path(name).as_path(), &options).expect("a mesh");
    let file = read("both.glb");
    let textures = &file.colors.expect("a material").materials[0].values.textures;
    assert!(textures.normal.is_some() && textures.occlusion.is_some());
    let file = read("baked.glb");
    assert!(file.mesh.vertices().iter().all(|vertex| vertex.normal.y > 0.999_99));
    for (line, wanted) in [
        ("--maps normal -o out.ply", "--maps"),
        ("--maps normal --shading exact -o out.glb", "needs the normals of the base"),
        ("--maps bumps -o out.glb", "normal"),
    ] {
        let ran = folder.relief(&format!("mesh hills.png {line}"));
        assert!(ran.code == Some(2) && ran.stderr.contains(wanted), "{line}: {}", ran.stderr);
    }
}
