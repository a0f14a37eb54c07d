use png::{BitDepth, ColorType};
use relief_core::mesh::{UvProjection, torus};
use relief_io::{MeshOptions, Source, Up, read_mesh};

use super::{MAX_BYTES, with_choice};
use crate::Target;
use crate::common::files::png;
use crate::common::gltf_file::{Gltf, Numbers};
use crate::common::mesh_file::{Ply, data_uri, glb, gltf, gltf_buffer, obj, ply, stl_binary, stl_text};

/// Any bytes as a mesh's file: an error or a mesh with frames, never more memory than allowed.
pub const READ_MESH: Target = Target { name: "read_mesh", run, make };

const NAMES: [&str; 5] = ["a.gltf", "a.glb", "a.obj", "a.ply", "a.stl"];

fn run(bytes: &[u8]) -> bool {
    // The first byte chooses the format and the projection, the rest is the file.
    let Some((&choice, bytes)) = bytes.split_first() else { return false };
    let name = NAMES[usize::from(choice) % 5];
    let projection = UvProjection::ALL.get(usize::from(choice / 5) % 4).copied();
    let up = [None, Some(Up::Y), Some(Up::Z)][usize::from(choice) % 3];
    let options =
        MeshOptions { projection, up, colors: choice >= 128, materials: true, max_bytes: MAX_BYTES };
    let Ok(file) = read_mesh(Source::bytes(name, bytes), &options) else { return false };
    assert!(!file.mesh.triangles().is_empty());
    for vertex in file.mesh.vertices() {
        assert!((vertex.normal.length() - 1.0).abs() < 1e-5);
        assert!(vertex.tangent.length() > 0.0 && vertex.bitangent.length() > 0.0);
    }
    file.mesh.measures();
    true
}

fn make() -> Vec<Vec<u8>> {
    let mesh = torus(5, 4).expect("a mesh");
    let buffer = gltf_buffer(&mesh);
    let node = r#""scale": [2, 1, 1]"#;
    let files = [
        (0, gltf(&mesh, Some(&data_uri(&buffer)), node).into_bytes()),
        (0, textured()),
        (0, posed()),
        (1, glb(&gltf(&mesh, None, node), &buffer)),
        (2, obj(&mesh, true).into_bytes()),
        (2, obj(&mesh, false).into_bytes()),
        (3, ply(&mesh, Ply::Text)),
        (3, ply(&mesh, Ply::Little)),
        (3, ply(&mesh, Ply::Big)),
        (4, stl_text(&mesh).into_bytes()),
        (4, stl_binary(&mesh)),
    ];
    // With a projection, since an STL has no texture coordinates; and with colours, beside them.
    files.iter().flat_map(|(format, file)| [0, 130].map(|more| with_choice(format + more, file))).collect()
}

/// A square with a picture, a mask and colours of vertices.
fn textured() -> Vec<u8> {
    let mut square = Gltf::square();
    let colours = square.add(Numbers::Floats(&[0.1, 0.5, 1.0].repeat(4)), "VEC3", "");
    square.attributes = format!(r#", "COLOR_0": {colours}"#);
    square.primitive = r#", "material": 0"#.into();
    let picture = png(2, 2, ColorType::Rgba, BitDepth::Eight, &[90; 16]);
    let uri = data_uri(&picture).replace("octet-stream", "png").replace("application", "image");
    square.more = format!(
        r#", "materials": [{{"alphaMode": "MASK", "alphaCutoff": 0.3, "pbrMetallicRoughness":
        {{"baseColorFactor": [1, 0.5, 0.2, 1], "baseColorTexture": {{"index": 0, "extensions":
        {{"KHR_texture_transform": {{"offset": [0.5, 0], "scale": [2, 2], "rotation": 0.1}}}}}}}},
        "extras": {{"relief": {{"scale": "5cm"}}}}}}],
        "textures": [{{"source": 0, "sampler": 0}}], "samplers": [{{"wrapS": 33071}}],
        "images": [{{"uri": "{uri}"}}], "extensionsUsed": ["KHR_texture_transform"]"#
    );
    square.json()
}

/// A square with a skin of two joints and a morph target.
fn posed() -> Vec<u8> {
    let mut square = Gltf::square();
    let joints = square.add(Numbers::Bytes(&[0, 1, 0, 0].repeat(4)), "VEC4", "");
    let weights = square.add(Numbers::Floats(&[0.5, 0.5, 0.0, 0.0].repeat(4)), "VEC4", "");
    let moved = square.add(Numbers::Floats(&[0.0, 0.1, 0.2].repeat(4)), "VEC3", "");
    square.attributes = format!(r#", "JOINTS_0": {joints}, "WEIGHTS_0": {weights}"#);
    square.primitive = format!(r#", "targets": [{{"POSITION": {moved}}}]"#);
    square.mesh = r#", "weights": [0.5]"#.into();
    square.node = r#", "skin": 0, "children": [1, 2]"#.into();
    square.nodes = r#", {"translation": [0, 1, 0]}, {"rotation": [0, 0, 0.6, 0.8]}"#.into();
    square.more = r#", "skins": [{"joints": [1, 2]}]"#.into();
    square.json()
}
