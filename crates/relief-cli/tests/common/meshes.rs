//! Meshes as text.

use relief_core::mesh::Mesh;

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

/// A triangle as a glTF that names the file of its picture and that of its buffer, and the buffer's bytes.
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
