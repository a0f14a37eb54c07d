//! Keys of a surface in a glTF's material: they are defaults for the scene, and bad ones are
//! refused by name.

use std::fs;

use crate::common::command::Folder;
use crate::common::maps::Map;
use relief_core::mesh::{Mesh, torus};

/// A glTF of a mesh whose buffer lies beside it, with those materials; each part of it has the next
/// one.
fn gltf(mesh: &Mesh, materials: &[&str]) -> (String, Vec<u8>) {
    let floats = |numbers: Vec<f32>| numbers.into_iter().flat_map(f32::to_le_bytes).collect::<Vec<u8>>();
    let vertices = mesh.vertices();
    let lists = [
        floats(vertices.iter().flat_map(|vertex| vertex.position.to_array()).collect()),
        floats(vertices.iter().flat_map(|vertex| vertex.normal.to_array()).collect()),
        floats(vertices.iter().flat_map(|vertex| vertex.uv.to_array()).collect()),
        mesh.triangles().iter().flatten().flat_map(|index| index.to_le_bytes()).collect(),
    ];
    let mut from = 0;
    let views = lists.each_ref().map(|list| {
        from += list.len();
        format!(r#"{{"buffer": 0, "byteOffset": {}, "byteLength": {}}}"#, from - list.len(), list.len())
    });
    let (count, corners) = (vertices.len(), 3 * mesh.triangles().len());
    let parts = (0..materials.len().max(1)).map(|material| {
        let material =
            if materials.is_empty() { String::new() } else { format!(r#", "material": {material}"#) };
        let attributes = r#"{"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}"#;
        format!(r#"{{"attributes": {attributes}, "indices": 3{material}}}"#)
    });
    let parts = parts.collect::<Vec<_>>().join(", ");
    let json = format!(
        r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}],
        "nodes": [{{"mesh": 0}}], "meshes": [{{"primitives": [{parts}]}}], "materials": [{}],
        "buffers": [{{"uri": "mesh.bin", "byteLength": {from}}}], "bufferViews": [{}], "accessors": [
        {{"bufferView": 0, "count": {count}, "componentType": 5126, "type": "VEC3",
        "min": [-1, -1, -1], "max": [1, 1, 1]}},
        {{"bufferView": 1, "count": {count}, "componentType": 5126, "type": "VEC3"}},
        {{"bufferView": 2, "count": {count}, "componentType": 5126, "type": "VEC2"}},
        {{"bufferView": 3, "count": {corners}, "componentType": 5125, "type": "SCALAR"}}]}}"#,
        materials.join(", "),
        views.join(", ")
    );
    let json = if materials.is_empty() { json.replace(r#""materials": [],"#, "") } else { json };
    (json, lists.concat())
}

/// Returns the glTF as a GLB.
fn glb(json: &str, buffer: &[u8]) -> Vec<u8> {
    let mut json = json.replace(r#""uri": "mesh.bin", "#, "").into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let chunk = |kind: &[u8], bytes: &[u8]| [&(bytes.len() as u32).to_le_bytes(), kind, bytes].concat();
    let chunks = [chunk(b"JSON", &json), chunk(b"BIN\0", buffer)].concat();
    let len = (12 + chunks.len() as u32).to_le_bytes();
    [b"glTF".as_slice(), &2u32.to_le_bytes(), &len, &chunks].concat()
}

/// A material with those extras.
fn material(extras: &str) -> String {
    format!(r#"{{"extras": {extras}}}"#)
}

/// A folder with a torus in a folder of its own, with a map, and those materials.
fn folder(materials: &[&str]) -> Folder {
    let folder = Folder::new();
    let (json, buffer) = gltf(&torus(24, 12).expect("a mesh"), materials);
    folder.write("ring/ring.glb", glb(&json, &buffer));
    folder.write("ring/ring.gltf", json);
    folder.write("ring/mesh.bin", buffer);
    folder.write("ring/maps/hills.png", Map::hills().png());
    folder.write("other.png", Map::constant(0.25).png());
    folder
}

const SMALL: &str = "size = [80, 60]\nsamples = 1\nbackend = 'cpu'\n";

/// The picture of a scene file.
fn picture(folder: &Folder, keys: &str, flags: &str) -> Vec<u8> {
    folder.write("scene.toml", format!("{SMALL}{keys}"));
    folder.relief(&format!("render scene.toml -o out.png {flags}")).fine();
    fs::read(folder.path("out.png")).expect("a picture")
}

#[test]
fn the_scene_has_the_keys_of_its_mesh_where_it_says_nothing() {
    let extras = r#"{"relief": {"height": "maps/hills.png", "scale": 0.03, "bias": 0.0, "tile": [6, 2],
        "method": "relief", "set": {"search": {"steps": 20}}, "shadow": "none", "two-sided": true,
        "material": {"diffuse": [0.9, 0.3, 0.1]}, "project": "sphere", "wrap": "mirror"}, "other": 1}"#;
    let folder = folder(&[&material(extras)]);
    let same = "height = 'ring/maps/hills.png'\nscale = 0.03\nbias = 0.0\ntile = [6, 2]\nmethod = 'relief'\n\
        set.search.steps = 20\nshadow = 'none'\ntwo-sided = true\nmaterial.diffuse = [0.9, 0.3, 0.1]\n\
        project = 'sphere'\nwrap = 'mirror'\n";
    // Without the extras a mesh has no keys.
    folder.write("plain/ring.gltf", gltf(&torus(24, 12).expect("a mesh"), &[]).0);
    fs::copy(folder.path("ring/mesh.bin"), folder.path("plain/mesh.bin")).expect("the buffer");
    let plain = "mesh = 'plain/ring.gltf'\n";
    let told = picture(&folder, &format!("{plain}{same}"), "");
    for mesh in ["mesh = 'ring/ring.gltf'\n", "mesh = 'ring/ring.glb'\n"] {
        assert!(picture(&folder, mesh, "") == told, "{mesh}");
        let several = "[[surfaces]]\nmesh = 'ring/ring.glb'\n[[surfaces]]\nmesh = 'ring/ring.gltf'\n\
            position = [0, -9, 0]\n";
        let _ = picture(&folder, several, "");
        // The scene file wins, and flags over it.
        let other = picture(&folder, &format!("{mesh}height = 'other.png'\nscale = 0.01\n"), "");
        let expected =
            same.replace("ring/maps/hills.png", "other.png").replace("scale = 0.03", "scale = 0.01");
        let expected = expected.replace("bias = 0.0\n", "");
        assert!(other == picture(&folder, &format!("{plain}{expected}"), "") && other != told);
        let by_flags = picture(&folder, mesh, "--height other.png --scale 0.01");
        assert!(by_flags == other);
        let cone = picture(&folder, &format!("{mesh}method = 'cone'\n"), "");
        let expected = same.replace("method = 'relief'\nset.search.steps = 20", "method = 'cone'");
        assert!(cone == picture(&folder, &format!("{plain}{expected}"), "") && cone != told);
    }
    // The map that the mesh names is an input and is not replaced.
    let ran = folder.relief("render scene.toml --mesh ring/ring.glb -o ring/maps/hills.png");
    assert_eq!(ran.code, Some(2), "{}", ran.stderr);
}

#[test]
fn extras_of_others_are_not_looked_at() {
    let keys = "mesh = 'ring/ring.glb'\nheight = 'other.png'\n";
    let plain = picture(&folder(&["{}"]), keys, "");
    for extras in ["{}", "7", "[1, 2]", "\"relief\"", "null", r#"{"Relief": {"heigt": 1}}"#] {
        assert!(picture(&folder(&[&material(extras)]), keys, "") == plain, "{extras}");
    }
    // Materials with the same keys are one; a mesh with two has no colours.
    let plain = picture(&folder(&["{}", "{}"]), keys, "");
    let both = material(r#"{"relief": {"scale": 0.05}}"#);
    assert!(picture(&folder(&[&both, &both]), keys, "") == plain);
}

#[test]
fn lengths_may_have_units() {
    let all = |scale: &str, bias: &str, tile: &str, position: &str| {
        let keys = format!(
            r#""height": "maps/hills.png", "scale": {scale}, "bias": {bias},
            "tile-size": {tile}, "position": {position}"#
        );
        folder(&[&material(&format!(r#"{{"relief": {{{keys}}}}}"#))])
    };
    let [metres, units] = [
        all("0.03", "-0.0254", "[0.5, 0.3048]", "[0, 0.1, -0.2]"),
        all(r#""3cm""#, r#""-1 in""#, r#"["500mm", "1ft"]"#, r#"["0 m", 0.1, "-20cm"]"#),
    ];
    let keys = "mesh = 'ring/ring.glb'\n";
    assert!(picture(&metres, keys, "") == picture(&units, keys, ""));
    assert!(picture(&metres, keys, "") != picture(&metres, &format!("{keys}bias = '1mm'\n"), ""));
    // In a scene file, too.
    let own = |bias: &str, eye: &str, far: &str| {
        picture(&metres, &format!("{keys}bias = {bias}\neye = {eye}\nfar = {far}\n"), "")
    };
    assert!(own("-0.01", "[1.5, 2, 2]", "30000") == own("'-10mm'", "['150cm', 2, '2m']", "'30 km'"));
}

#[test]
fn bad_keys_are_refused_with_the_file_and_the_key() {
    let cases = [
        (r#"{"heigt": "maps/hills.png"}"#, "height"),
        (r#"{"mesh": "torus"}"#, "mesh"),
        (r#"{"view": "top"}"#, "view"),
        (r#"{"scale": "big"}"#, "scale"),
        (r#"{"scale": -1}"#, "scale"),
        (r#"{"scale": "5 fet"}"#, "scale"),
        (r#"{"position": ["1m", "2m"]}"#, "position"),
        (r#"{"tile": [1]}"#, "tile"),
        (r#"{"method": "conee"}"#, "cone"),
        (r#"{"search": "linear"}"#, "search"),
        (r#"{"shadow": 3}"#, "shadow"),
        (r#"{"set": {"search": {"stepz": 3}}}"#, "stepz"),
        (r#"{"set": {"search.steps": 3}}"#, "set"),
        (r#"{"material": {"difuse": [1, 1, 1]}}"#, "difuse"),
        (r#"{"wrap": "sideways"}"#, "sideways"),
        ("[]", "extras.relief"),
        ("null", "extras.relief"),
        (r#"{"height": "../other.png"}"#, "../other.png"),
        (r#"{"height": "/etc/hostname"}"#, "/etc/hostname"),
        (r#"{"height": "maps\\hills.png"}"#, "maps"),
        (r#"{"color": "maps/none.png"}"#, "none.png"),
        (r#"{"normal": ""}"#, "not in its folder"),
    ];
    for (relief, named) in cases {
        let folder = folder(&[&material(&format!(r#"{{"relief": {relief}}}"#))]);
        folder.write("scene.toml", format!("{SMALL}mesh = 'ring/ring.glb'\nheight = 'other.png'\n"));
        let ran = folder.relief("render scene.toml -o out.png");
        assert_eq!(ran.code, Some(1), "{relief}: {}", ran.stderr);
        assert!(ran.stderr.contains("ring.glb") && ran.stderr.contains(named), "{relief}: {}", ran.stderr);
        assert_eq!((ran.stderr.lines().count(), folder.path("out.png").exists()), (1, false), "{relief}");
    }
    let (one, other) = (material(r#"{"relief": {"scale": 0.1}}"#), material("{}"));
    let folder = folder(&[&one, &other]);
    let ran = folder.relief("render --mesh ring/ring.gltf --height other.png -o out.png");
    assert!(ran.code == Some(1) && ran.stderr.contains("several materials"), "{}", ran.stderr);
}

#[cfg(unix)]
#[test]
fn a_link_that_leads_out_of_the_folder_is_refused() {
    let folder = folder(&[&material(r#"{"relief": {"height": "maps/out.png"}}"#)]);
    std::os::unix::fs::symlink(folder.path("other.png"), folder.path("ring/maps/out.png")).expect("a link");
    let ran = folder.relief("render --mesh ring/ring.glb -o out.png");
    assert!(ran.code == Some(1) && ran.stderr.contains("maps/out.png"), "{}", ran.stderr);
}

#[test]
fn a_mesh_is_made_larger_by_a_flag_a_key_and_its_older_name() {
    let extras =
        |key: &str| material(&format!(r#"{{"relief": {{"height": "maps/hills.png", "{key}": 3}}}}"#));
    let plain = folder(&[&material(r#"{"relief": {"height": "maps/hills.png"}}"#)]);
    let eye = "eye = [0, 3, 4]\ntarget = [0, 0, 0]\n";
    let mesh = format!("{eye}mesh = 'ring/ring.glb'\n");
    let small = picture(&plain, &mesh, "");
    let large = picture(&plain, &format!("{mesh}mesh-scale = 3\n"), "");
    assert!(large != small);
    assert!(picture(&plain, &mesh, "--mesh-scale 3") == large);
    let of_surface = |key: &str| format!("{eye}[[surfaces]]\nmesh = 'ring/ring.glb'\n{key} = 3\n");
    for key in ["mesh-scale", "size"] {
        assert!(picture(&plain, &of_surface(key), "") == large, "{key}");
        assert!(picture(&folder(&[&extras(key)]), &mesh, "") == large, "{key}");
    }
    // What `relief scene` writes says the same by the newer name.
    plain.write("old.toml", format!("{SMALL}{}", of_surface("size")));
    plain.relief("scene old.toml -o new.toml").fine();
    let written = fs::read_to_string(plain.path("new.toml")).expect("a scene file");
    assert!(written.contains("mesh-scale = 3"), "{written}");
    plain.relief("render new.toml -o new.png").fine();
    assert!(fs::read(plain.path("new.png")).expect("a picture") == large);
    for bad in ["0", "-1", "1e9"] {
        let ran = plain.relief(&format!("render scene.toml --mesh-scale {bad} -o out.png"));
        assert!(ran.code == Some(2) && ran.stderr.contains("--mesh-scale"), "{bad}: {}", ran.stderr);
    }
}
