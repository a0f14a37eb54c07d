//! Meshes as text.

use relief_core::mesh::Mesh;

use super::command::Folder;

/// A mesh as an OBJ file, with all that `f32` holds.
pub fn obj(mesh: &Mesh) -> String {
    let mut text = String::new();
    for vertex in mesh.vertices() {
        let [[x, y, z], [nx, ny, nz]] = [vertex.position, vertex.normal].map(|vector| vector.to_array());
        text += &format!("v {x} {y} {z}\nvn {nx} {ny} {nz}\n");
        text += &format!("vt {} {}\n", vertex.uv.x, 1.0 - f64::from(vertex.uv.y));
    }
    for [a, b, c] in mesh.triangles().iter().map(|corners| corners.map(|index| index + 1)) {
        text += &format!("f {a}/{a}/{a} {b}/{b}/{b} {c}/{c}/{c}\n");
    }
    text
}

/// Returns a triangle as a glTF that names a file for its picture and one for its buffer, and the
/// buffer's bytes.
pub fn gltf(picture: &str, buffer: &str) -> (String, Vec<u8>) {
    let numbers: [f32; 15] = [0., 0., 0., 1., 0., 0., 0., 0., 1., 0., 0., 1., 0., 0., 1.];
    let json = serde_json::json!({
        "asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0,
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}], "images": [{"uri": picture}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
             "min": [0, 0, 0], "max": [1, 0, 1]},
            {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24},
        ],
        "buffers": [{"uri": buffer, "byteLength": 60}],
    });
    (json.to_string(), numbers.iter().flat_map(|number| number.to_le_bytes()).collect())
}

/// Writes a glTF of two triangles that make the square from (0, 0, 0) to (1, 1, 0), with the given
/// primitives and more of the file's keys.
///
/// Attributes are positions (0), texture coordinates (1, mirrored 6, from -1 to 2 7), colours (all
/// yellow 5, of several hues 10), joints (8) and weights of 0 (9). Indices are for the lower
/// triangle (2), the upper one (3) and both (4).
pub fn square(folder: &Folder, name: &str, primitives: &str, more: &str) {
    let floats = |numbers: &[f32]| numbers.iter().flat_map(|n| n.to_le_bytes()).collect::<Vec<u8>>();
    let buffer = [
        floats(&[0., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 0.]),
        floats(&[0., 1., 1., 1., 1., 0., 0., 0.]),
        [0u16, 1, 2, 0, 2, 3].iter().flat_map(|n| n.to_le_bytes()).collect(),
        [255u8, 255, 0, 255].repeat(4),
        floats(&[1., 1., 0., 1., 0., 0., 1., 0.]),
        floats(&[-1., 1., 2., 1., 2., 0., -1., 0.]),
        vec![0; 16],
        vec![0; 64],
        vec![255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255],
    ];
    let mut at = 0;
    let views = buffer.iter().map(|part| {
        at += part.len();
        format!(r#"{{"buffer": 0, "byteOffset": {}, "byteLength": {}}}"#, at - part.len(), part.len())
    });
    let views = views.collect::<Vec<String>>().join(", ");
    let accessor = |view: u32, count: u32, component: u32, kind: &str, more: &str| {
        format!(
            r#"{{"bufferView": {view}, "count": {count}, "componentType": {component},
                "type": "{kind}"{more}}}"#
        )
    };
    let colors = r#", "normalized": true"#;
    let accessors = [
        accessor(0, 4, 5126, "VEC3", r#", "min": [0, 0, 0], "max": [1, 1, 0]"#),
        accessor(1, 4, 5126, "VEC2", ""),
        accessor(2, 3, 5123, "SCALAR", ""),
        accessor(2, 3, 5123, "SCALAR", r#", "byteOffset": 6"#),
        accessor(2, 6, 5123, "SCALAR", ""),
        accessor(3, 4, 5121, "VEC4", colors),
        accessor(4, 4, 5126, "VEC2", ""),
        accessor(5, 4, 5126, "VEC2", ""),
        accessor(6, 4, 5121, "VEC4", ""),
        accessor(7, 4, 5126, "VEC4", ""),
        accessor(8, 4, 5121, "VEC4", colors),
    ];
    let json = format!(
        r#"{{"asset": {{"version": "2.0"}}, "scenes": [{{"nodes": [0]}}], "nodes": [{{"mesh": 0}}],
        "meshes": [{{"primitives": [{primitives}]}}],
        "buffers": [{{"uri": "square.bin", "byteLength": {at}}}], "bufferViews": [{views}],
        "accessors": [{}]{more}}}"#,
        accessors.join(", ")
    );
    folder.write("square.bin", buffer.concat());
    folder.write(name, json);
}

/// A primitive of the square of those indices and that material.
pub fn part(indices: u32, material: u32) -> String {
    let attributes = r#"{"POSITION": 0, "TEXCOORD_0": 1}"#;
    format!(r#"{{"attributes": {attributes}, "indices": {indices}, "material": {material}}}"#)
}

/// A material of that colour and opacity.
pub fn factor(rgba: &str) -> String {
    format!(r#"{{"pbrMetallicRoughness": {{"baseColorFactor": [{rgba}]}}}}"#)
}

/// Writes a glTF of a strip of paper, 3 m long and 1 m wide, that is folded twice. Each of its
/// three squares has its own material, one with the picture `leaf.png`, or all have the first
/// material.
pub fn folded(folder: &Folder, name: &str, has_several: bool) {
    let ends = [[0.0, 0.0], [1.0, 0.0], [1.8, 0.6], [1.8, 1.6]];
    let numbers = |list: Vec<f32>| list.iter().flat_map(|n| n.to_le_bytes()).collect::<Vec<u8>>();
    let positions = ends.iter().flat_map(|[x, y]| [*x, *y, 0.0, *x, *y, 1.0]).collect();
    let uvs = (0..4).flat_map(|at| [at as f32, 0.0, at as f32, 1.0]).collect();
    let quad = |at: u16| [0, 1, 3, 0, 3, 2].map(|corner| 2 * at + corner);
    let indices: Vec<u8> = (0..3).flat_map(quad).flat_map(|n| n.to_le_bytes()).collect();
    let buffer = [numbers(positions), numbers(uvs), indices].concat();
    let part = |at: u32| {
        let material = if has_several { at } else { 0 };
        serde_json::json!({ "attributes": { "POSITION": 0, "TEXCOORD_0": 1 }, "indices": 2 + at,
            "material": material })
    };
    let list = |at: u32| {
        serde_json::json!({ "bufferView": 2, "byteOffset": 12 * at, "componentType": 5123, "count": 6,
            "type": "SCALAR" })
    };
    let corners = serde_json::json!({ "bufferView": 0, "componentType": 5126, "count": 8, "type": "VEC3",
        "min": [0, 0, 0], "max": [1.8, 1.6, 1] });
    let uvs = serde_json::json!({ "bufferView": 1, "componentType": 5126, "count": 8, "type": "VEC2" });
    let json = serde_json::json!({
        "asset": {"version": "2.0"}, "nodes": [{"mesh": 0}], "scenes": [{"nodes": [0]}], "scene": 0,
        "meshes": [{"primitives": [part(0), part(1), part(2)]}],
        "materials": [
            {"name": "red @ \"home\"", "pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}},
            {"name": "leaf", "alphaMode": "MASK", "alphaCutoff": 0.25,
             "pbrMetallicRoughness": {"baseColorTexture": {"index": 0, "extensions":
                {"KHR_texture_transform": {"offset": [0.5, 0.25], "rotation": 0.5, "scale": [2, -3]}}}}},
            {"name": "blue", "pbrMetallicRoughness": {"baseColorFactor": [0, 0, 1, 1]}},
        ],
        "textures": [{"source": 0, "sampler": 0}], "images": [{"uri": "leaf.png"}],
        "samplers": [{"wrapS": 33648, "wrapT": 33071}],
        "accessors": [corners, uvs, list(0), list(1), list(2)],
        "bufferViews": [
            {"buffer": 0, "byteLength": 96}, {"buffer": 0, "byteOffset": 96, "byteLength": 64},
            {"buffer": 0, "byteOffset": 160, "byteLength": 36},
        ],
        "buffers": [{"uri": "folded.bin", "byteLength": 196}],
    });
    folder.write("folded.bin", buffer);
    folder.write(name, json.to_string());
}
