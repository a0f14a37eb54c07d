//! Hostile glTF files are refused or read correctly: any size, any path, any graph of nodes.

use crate::common::Folder;
use crate::common::broken_mesh::{
    Case, Right, assert_right, case, has_bad_number, has_no_triangles, has_no_uv, is_damaged, is_outside,
    is_too_large, is_unsupported, read,
};
use crate::common::mesh_file::{data_uri, glb, gltf, gltf_buffer};
use relief_core::mesh::square;
use relief_io::{MeshOptions, ReadProblem, read_mesh};

/// Parts of a square's JSON that are replaced.
const NODES: &str = r#"{"mesh": 0}]"#;
const NODE: &str = r#"{"mesh": 0}"#;
const ROOTS: &str = r#""nodes": [0]"#;
const INDICES: &str = r#""indices": 3"#;
const UVS: &str = r#""TEXCOORD_0": 2"#;
const COUNT: &str = r#""count": 4"#;
const VIEW: &str = r#""byteOffset": 0, "byteLength": 48"#;
const LAST_VIEW: &str = r#""byteOffset": 128, "byteLength": 24}"#;
const BUFFER: &str = r#""byteLength": 152}]"#;
/// View of the bytes after the square's buffer.
const ONE_MORE_VIEW: &str =
    r#""byteOffset": 128, "byteLength": 24}, {"buffer": 0, "byteOffset": 152, "byteLength": 16}"#;

fn is_no_mesh(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::NoMesh)
}

fn is_empty(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::Empty)
}

/// A square as a GLB, with parts of its JSON replaced.
fn square_glb(replaced: &[(&str, &str)]) -> Vec<u8> {
    let mesh = square(1).expect("a mesh");
    let mut json = gltf(&mesh, None, "");
    for (from, to) in replaced {
        assert!(json.contains(from), "{from}");
        json = json.replace(from, to);
    }
    glb(&json, &gltf_buffer(&mesh))
}

#[test]
fn gltfs_are_read_or_refused() {
    let refused = |what, replaced: &[(&str, &str)], is: fn(&ReadProblem) -> bool| {
        case(what, "a.glb", square_glb(replaced), Right::Refused(is))
    };
    let right = |what, replaced: &[(&str, &str)], triangles, degenerate| {
        case(what, "a.glb", square_glb(replaced), Right::Mesh(triangles, degenerate, 0))
    };
    // A required extension is named, with the tool that unpacks it.
    let names = |name: &str| {
        let file =
            square_glb(&[(r#""scene": 0"#, &format!(r#""extensionsRequired": ["{name}"], "scene": 0"#))]);
        read("a.glb", &file).expect_err(name).to_string()
    };
    for name in ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"] {
        assert!(names(name).contains(name) && names(name).contains("gltf-transform copy"), "{}", names(name));
    }
    assert!(names("VENDOR_shapes").contains("VENDOR_shapes") && !names("VENDOR_shapes").contains("gltf-tr"));
    let extension = |name: &str| format!(r#""extensionsRequired": ["{name}"], "scene": 0"#);
    let (draco, meshopt, sheen) = (
        extension("KHR_draco_mesh_compression"),
        extension("EXT_meshopt_compression"),
        extension("KHR_materials_sheen"),
    );
    let chain: String = (1..20_000).map(|node| format!(r#", {{"children": [{}]}}"#, node + 1)).collect();
    let chain = format!(r#"{{"children": [1]}}{chain}, {{"mesh": 0}}]"#);
    let positions = r#"{"bufferView": 0, "count": 4, "componentType": 5126, "type": "VEC3""#;
    let sparse = |places: &str| {
        format!(
            r#"{{"count": 4, "componentType": 5126, "type": "VEC3", "sparse": {{"count": 4, "indices":
            {{"bufferView": {places}, "componentType": 5125}}, "values": {{"bufferView": 0}}}}"#
        )
    };
    let nothing_but_zeros = r#"{"count": 1000000000000, "componentType": 5126, "type": "VEC3",
        "sparse": {"count": 0, "indices":
        {"bufferView": 3, "componentType": 5125}, "values": {"bufferView": 0}}"#;
    assert_right(vec![
        right("a square", &[], 2, 0),
        right("a strip", &[(r#", "indices": 3"#, r#", "mode": 5"#)], 2, 0),
        // Joints of a strip are not triangles.
        right("a strip that comes back", &[(INDICES, r#""indices": 3, "mode": 5"#)], 3, 0),
        right("a fan", &[(INDICES, r#""indices": 3, "mode": 6"#)], 2, 2),
        right("an extension of materials", &[(r#""scene": 0"#, &sheen)], 2, 0),
        right("no scene", &[(r#""scene": 0, "scenes": [{"nodes": [0]}],"#, "")], 2, 0),
        right("a deep chain of nodes", &[(NODES, &chain)], 2, 0),
        right(
            "two instances",
            &[
                (ROOTS, r#""nodes": [0, 1]"#),
                (NODES, r#"{"mesh": 0}, {"mesh": 0, "translation": [0, 1, 0]}]"#),
            ],
            4,
            0,
        ),
        refused("points", &[(INDICES, r#""indices": 3, "mode": 0"#)], is_damaged),
        refused("lines", &[(INDICES, r#""indices": 3, "mode": 3"#)], is_damaged),
        refused("an unknown mode", &[(INDICES, r#""indices": 3, "mode": 9"#)], is_damaged),
        refused("Draco", &[(r#""scene": 0"#, &draco)], is_unsupported),
        refused("meshopt", &[(r#""scene": 0"#, &meshopt)], is_unsupported),
        refused("a node that is its own child", &[(NODE, r#"{"mesh": 0, "children": [0]}"#)], is_damaged),
        refused(
            "a node of two parents",
            &[
                (ROOTS, r#""nodes": [0, 1]"#),
                (NODES, r#"{"mesh": 0, "children": [2]}, {"children": [2]}, {"mesh": 0}]"#),
            ],
            is_damaged,
        ),
        refused(
            "a circle of nodes",
            &[(NODES, r#"{"mesh": 0, "children": [1]}, {"children": [2]}, {"children": [0]}]"#)],
            is_damaged,
        ),
        refused("a node that is not there", &[(ROOTS, r#""nodes": [7]"#)], is_damaged),
        refused("no mesh in the scene", &[(NODE, r#"{"name": "empty"}"#)], is_damaged),
        refused("positions that are not there", &[(r#""POSITION": 0"#, r#""POSITION": 77"#)], is_damaged),
        refused("no positions", &[(r#""POSITION": 0, "#, "")], is_damaged),
        refused("no texture coordinates", &[(r#", "TEXCOORD_0": 2"#, "")], has_no_uv),
        refused("an accessor that is not there", &[(UVS, r#""TEXCOORD_0": 9"#)], is_damaged),
        refused("positions as texture coordinates", &[(UVS, r#""TEXCOORD_0": 0"#)], is_damaged),
        refused("positions as indices", &[(INDICES, r#""indices": 0"#)], is_damaged),
        refused(
            "fewer normals than positions",
            &[(r#""bufferView": 1, "count": 4"#, r#""bufferView": 1, "count": 3"#)],
            is_damaged,
        ),
        refused("more elements than the view", &[(COUNT, r#""count": 5"#)], is_damaged),
        refused("elements for terabytes", &[(COUNT, r#""count": 1000000000000"#)], is_too_large),
        refused("the most elements", &[(COUNT, r#""count": 18446744073709551615"#)], is_too_large),
        refused("indices for terabytes", &[(r#""count": 6"#, r#""count": 1000000000000"#)], is_too_large),
        refused(
            "an accessor that begins behind its view",
            &[(r#""bufferView": 0,"#, r#""bufferView": 0, "byteOffset": 4611686018427387904,"#)],
            is_damaged,
        ),
        refused("a view beyond its buffer", &[(VIEW, r#""byteOffset": 130, "byteLength": 48"#)], is_damaged),
        refused(
            "a view that wraps around",
            &[(VIEW, r#""byteOffset": 18446744073709551615, "byteLength": 48"#)],
            is_damaged,
        ),
        refused("a buffer longer than its bytes", &[(BUFFER, r#""byteLength": 99999999999}]"#)], is_damaged),
        refused(
            "an index beyond the vertices",
            &[(
                r#""bufferView": 3, "count": 6, "componentType": 5125"#,
                r#""bufferView": 0, "count": 6, "componentType": 5125"#,
            )],
            is_damaged,
        ),
        right(
            "a sparse accessor",
            &[(positions, &sparse("4")), (LAST_VIEW, ONE_MORE_VIEW), (BUFFER, r#""byteLength": 168}]"#)],
            2,
            0,
        )
        .followed_by(&[0, 1, 2, 3]),
        refused("a sparse accessor beyond its end", &[(positions, &sparse("0"))], is_damaged),
        refused("sparse nothing for terabytes", &[(positions, nothing_but_zeros)], is_too_large),
        refused(
            "an infinite place",
            &[(NODE, r#"{"mesh": 0, "scale": [1e38, 1e38, 1e38], "translation": [1e38, 0, 0]}"#)],
            has_bad_number,
        ),
        refused("no size", &[(NODE, r#"{"mesh": 0, "scale": [0, 0, 0]}"#)], has_no_triangles),
        case("no JSON", "a.gltf", "v 0 0 0", Right::Refused(is_damaged)),
        case("deep JSON", "a.gltf", "[".repeat(9999), Right::Refused(is_damaged)),
        case("an old version", "a.glb", b"glTF\x01\0\0\0\x14\0\0\0", Right::Refused(is_unsupported)),
        case("no mesh by its name", "a.fbx", "v 0 0 0", Right::Refused(is_no_mesh)),
        case("nothing", "a.obj", "", Right::Refused(is_empty)),
    ]);
}

impl Case {
    /// The GLB with four more indices behind its buffer.
    fn followed_by(mut self, indices: &[u32]) -> Self {
        let json_len =
            u32::from_le_bytes([self.bytes[12], self.bytes[13], self.bytes[14], self.bytes[15]]) as usize;
        let json = String::from_utf8_lossy(&self.bytes[20..20 + json_len]).into_owned();
        let mut buffer = gltf_buffer(&square(1).expect("a mesh"));
        buffer.extend(indices.iter().flat_map(|index| index.to_le_bytes()));
        self.bytes = glb(json.trim_end(), &buffer);
        self
    }
}

#[test]
fn files_outside_of_the_folder_are_not_read() {
    let parent = Folder::new();
    let folder = parent.path().join("inside");
    std::fs::create_dir(&folder).expect("the temporary folder is writable");
    let mesh = square(1).expect("a mesh");
    let secret = parent.file("secret.bin", &gltf_buffer(&mesh));
    let path = folder.join("a.gltf");
    let problem = |uri: &str| {
        std::fs::write(&path, gltf(&mesh, Some(uri), "")).expect("the temporary folder is writable");
        read_mesh(&path, &MeshOptions::default()).expect_err(uri).problem
    };
    let absolute = secret.display().to_string();
    let uris = [
        "../secret.bin",
        "x/../../secret.bin",
        "%2e%2e/secret.bin",
        "..%2Fsecret.bin",
        "..\\\\secret.bin",
        "C:secret.bin",
        "http://localhost/secret.bin",
        "file:///secret.bin",
        "",
        &absolute,
    ];
    for uri in uris {
        let problem = problem(uri);
        assert!(is_outside(&problem), "{uri}: {problem}");
    }
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(&secret, folder.join("link.bin")).expect("a link");
        assert!(is_outside(&problem("link.bin")));
    }
    for uri in ["missing.bin", "a.gltf/x.bin"] {
        assert!(matches!(problem(uri), ReadProblem::Part { .. }), "{uri}");
    }
    let bad = data_uri(b"too short");
    for uri in ["data:text/plain,abc", "data:;base64,***", bad.as_str()] {
        assert!(is_damaged(&problem(uri)), "{uri}");
    }
    // Bytes in memory have no files beside them.
    let bytes = gltf(&mesh, Some("a.bin"), "");
    let error = read("a.gltf", bytes.as_bytes()).expect_err("no folder");
    assert!(is_unsupported(&error.problem), "{error}");
}
