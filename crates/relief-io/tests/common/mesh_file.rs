//! Mesh files of every format.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use glam::Vec3;
use relief_core::mesh::Mesh;

/// OBJ file with texture coordinates and optional normals.
pub fn obj(mesh: &Mesh, normals: bool) -> String {
    let mut text = String::from("# a mesh\no mesh\n");
    for vertex in mesh.vertices() {
        let [x, y, z] = vertex.position.to_array();
        let [u, v] = vertex.uv.to_array();
        text += &format!("v {x} {y} {z}\nvt {u} {}\n", 1.0 - f64::from(v));
        if normals {
            let [x, y, z] = vertex.normal.to_array();
            text += &format!("vn {x} {y} {z}\n");
        }
    }
    for corners in mesh.triangles() {
        let words = corners.map(|index| {
            let n = index + 1;
            if normals { format!("{n}/{n}/{n}") } else { format!("{n}/{n}") }
        });
        text += &format!("f {}\n", words.join(" "));
    }
    text
}

/// Encoding of a PLY.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ply {
    Text,
    Little,
    Big,
}

/// PLY file with normals and texture coordinates.
pub fn ply(mesh: &Mesh, stored: Ply) -> Vec<u8> {
    let format = match stored {
        Ply::Text => "ascii",
        Ply::Little => "binary_little_endian",
        Ply::Big => "binary_big_endian",
    };
    let (vertices, faces) = (mesh.vertices().len(), mesh.triangles().len());
    let properties: String =
        ["x", "y", "z", "nx", "ny", "nz", "s", "t"].map(|name| format!("property float {name}\n")).concat();
    let mut bytes = format!(
        "ply\nformat {format} 1.0\ncomment a mesh\nelement vertex {vertices}\n{properties}\
         element face {faces}\nproperty list uchar int vertex_indices\nend_header\n"
    )
    .into_bytes();
    for vertex in mesh.vertices() {
        let [u, v] = vertex.uv.to_array();
        let numbers = [vertex.position.to_array(), vertex.normal.to_array()].concat();
        let numbers: Vec<f32> = numbers.into_iter().chain([u, (1.0 - f64::from(v)) as f32]).collect();
        match stored {
            Ply::Text => {
                let words: Vec<String> = numbers.iter().map(f32::to_string).collect();
                bytes.extend(format!("{}\n", words.join(" ")).bytes());
            }
            Ply::Little => bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes())),
            Ply::Big => bytes.extend(numbers.iter().flat_map(|number| number.to_be_bytes())),
        }
    }
    for [a, b, c] in mesh.triangles() {
        match stored {
            Ply::Text => bytes.extend(format!("3 {a} {b} {c}\n").bytes()),
            Ply::Little => {
                bytes.extend([3].into_iter().chain([a, b, c].into_iter().flat_map(|i| i.to_le_bytes())));
            }
            Ply::Big => {
                bytes.extend([3].into_iter().chain([a, b, c].into_iter().flat_map(|i| i.to_be_bytes())));
            }
        }
    }
    bytes
}

/// An STL as text.
pub fn stl_text(mesh: &Mesh) -> String {
    let mut text = String::from("solid a mesh\n");
    for triangle in 0..mesh.triangles().len() as u32 {
        text += "facet normal 0 0 nan\n  outer loop\n";
        for corner in mesh.corners(triangle) {
            let [x, y, z] = in_millimetres(corner.position);
            text += &format!("    vertex {x} {y} {z}\n");
        }
        text += "  endloop\nendfacet\n";
    }
    text + "endsolid a mesh\n"
}

/// Converts a position to millimetres with `z` up, as in STL.
fn in_millimetres(position: Vec3) -> [f32; 3] {
    let [x, y, z] = position.to_array();
    [x, 0.0 - z, y].map(|number| (f64::from(number) * 1000.0) as f32)
}

/// Binary STL file. It begins with the word that marks text files, as many do.
pub fn stl_binary(mesh: &Mesh) -> Vec<u8> {
    let mut bytes = b"solid or not, this is binary".to_vec();
    bytes.resize(80, b' ');
    bytes.extend((mesh.triangles().len() as u32).to_le_bytes());
    for triangle in 0..mesh.triangles().len() as u32 {
        bytes.extend([0; 12]);
        for corner in mesh.corners(triangle) {
            bytes.extend(in_millimetres(corner.position).iter().flat_map(|number| number.to_le_bytes()));
        }
        bytes.extend([0; 2]);
    }
    bytes
}

/// Buffer of [`gltf`]: positions, normals, texture coordinates, indices.
pub fn gltf_buffer(mesh: &Mesh) -> Vec<u8> {
    let floats = |numbers: Vec<f32>| numbers.into_iter().flat_map(f32::to_le_bytes).collect::<Vec<u8>>();
    let vertices = mesh.vertices();
    [
        floats(vertices.iter().flat_map(|vertex| vertex.position.to_array()).collect()),
        floats(vertices.iter().flat_map(|vertex| vertex.normal.to_array()).collect()),
        floats(vertices.iter().flat_map(|vertex| vertex.uv.to_array()).collect()),
        mesh.triangles().iter().flatten().flat_map(|index| index.to_le_bytes()).collect(),
    ]
    .concat()
}

/// JSON of a glTF with a mesh on one node; `uri` is the buffer's, and `node` has more of the node's
/// keys.
pub fn gltf(mesh: &Mesh, uri: Option<&str>, node: &str) -> String {
    let (vertices, indices) = (mesh.vertices().len(), 3 * mesh.triangles().len());
    let bytes = gltf_buffer(mesh).len();
    let uri = uri.map_or(String::new(), |uri| format!(r#""uri": "{uri}", "#));
    let view =
        |from: usize, len: usize| format!(r#"{{"buffer": 0, "byteOffset": {from}, "byteLength": {len}}}"#);
    let views = [
        view(0, 12 * vertices),
        view(12 * vertices, 12 * vertices),
        view(24 * vertices, 8 * vertices),
        view(32 * vertices, 4 * indices),
    ]
    .join(", ");
    let accessor = |at: usize, count: usize, kind: u32, shape: &str| {
        let bounds = if at == 0 { r#", "min": [-9, -9, -9], "max": [9, 9, 9]"# } else { "" };
        format!(
            r#"{{"bufferView": {at}, "count": {count}, "componentType": {kind}, "type": "{shape}"{bounds}}}"#
        )
    };
    let accessors = [
        accessor(0, vertices, 5126, "VEC3"),
        accessor(1, vertices, 5126, "VEC3"),
        accessor(2, vertices, 5126, "VEC2"),
        accessor(3, indices, 5125, "SCALAR"),
    ]
    .join(", ");
    let comma = if node.is_empty() { "" } else { ", " };
    format!(
        r#"{{"asset": {{"version": "2.0"}}, "scene": 0, "scenes": [{{"nodes": [0]}}],
 "nodes": [{{"mesh": 0{comma}{node}}}],
 "meshes": [{{"primitives": [
  {{"attributes": {{"POSITION": 0, "NORMAL": 1, "TEXCOORD_0": 2}}, "indices": 3}}
 ]}}],
 "buffers": [{{{uri}"byteLength": {bytes}}}],
 "bufferViews": [{views}],
 "accessors": [{accessors}]}}"#
    )
}

/// Data URI of bytes.
pub fn data_uri(bytes: &[u8]) -> String {
    format!("data:application/octet-stream;base64,{}", STANDARD.encode(bytes))
}

/// A GLB of a JSON and a buffer.
pub fn glb(json: &str, buffer: &[u8]) -> Vec<u8> {
    let padded = |bytes: &[u8], with: u8| {
        let mut bytes = bytes.to_vec();
        bytes.resize(bytes.len().next_multiple_of(4), with);
        bytes
    };
    let (json, buffer) = (padded(json.as_bytes(), b' '), padded(buffer, 0));
    let chunk = |kind: &[u8], bytes: &[u8]| [&(bytes.len() as u32).to_le_bytes(), kind, bytes].concat();
    let chunks = [chunk(b"JSON", &json), chunk(b"BIN\0", &buffer)].concat();
    let header = [b"glTF".as_slice(), &2u32.to_le_bytes(), &(12 + chunks.len() as u32).to_le_bytes()];
    [header.concat(), chunks].concat()
}
