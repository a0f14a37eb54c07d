//! Whatever a mesh's file holds, reading it ends soon, in an error or a valid mesh.

mod common;

use std::time::{Duration, Instant};

use common::mesh_file::{Ply, data_uri, glb, gltf, gltf_buffer, obj, ply, stl_binary, stl_text};
use common::{Folder, Random};
use relief_core::mesh::{FramingError, Mesh, UvProjection, square, torus};
use relief_io::{MeshFile, MeshOptions, ReadError, ReadProblem, Source, read_mesh};

/// Enough for every small file.
const LIMIT: u64 = 64 << 20;

/// Flips of bits a valid file.
const FLIPS: u64 = 1500;

/// What reading has to give.
enum Right {
    /// A problem of this kind.
    Refused(fn(&ReadProblem) -> bool),
    /// A mesh of so many triangles, and so many left out as degenerate and as double.
    Mesh(usize, usize, usize),
}

struct Case {
    what: &'static str,
    name: &'static str,
    bytes: Vec<u8>,
    right: Right,
}

fn case(what: &'static str, name: &'static str, bytes: impl AsRef<[u8]>, right: Right) -> Case {
    Case { what, name, bytes: bytes.as_ref().to_vec(), right }
}

fn is_damaged(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::Damaged { .. })
}

fn is_unsupported(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::Unsupported { .. })
}

fn is_outside(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::OutsideFolder { .. })
}

fn is_too_large(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::MeshMemory { .. })
}

fn has_no_uv(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::Mesh(FramingError::NoTextureCoordinates { .. }))
}

fn has_no_texture_area(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::Mesh(FramingError::NoTextureArea { .. }))
}

fn has_no_triangles(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::Mesh(FramingError::NoTriangles))
}

fn has_bad_number(problem: &ReadProblem) -> bool {
    matches!(problem, ReadProblem::Mesh(FramingError::BadNumber { .. }))
}

fn read(name: &str, bytes: &[u8]) -> Result<MeshFile, ReadError> {
    let start = Instant::now();
    let options = MeshOptions { max_bytes: LIMIT, ..MeshOptions::default() };
    let read = read_mesh(Source::bytes(name, bytes), &options);
    for projection in UvProjection::ALL {
        // What has no texture coordinates gets them, but where all is seen from its edge.
        let projected = MeshOptions { projection: Some(projection), ..options };
        let projected = read_mesh(Source::bytes(name, bytes), &projected);
        let is_edge = |error: &ReadError| has_no_texture_area(&error.problem);
        assert!(read.is_err() || projected.as_ref().err().is_none_or(is_edge), "{name}: {projected:?}");
        projected.iter().for_each(|file| assert_sound(&file.mesh));
    }
    assert!(start.elapsed() < Duration::from_secs(20), "{name} takes too long");
    if let Ok(file) = &read {
        assert_sound(&file.mesh);
        file.mesh.measures();
    }
    if let Err(error) = &read {
        assert!(error.to_string().starts_with(&format!("{name}: ")), "{error}");
        assert!(error.to_string().len() < 600, "{error}");
        assert!(!matches!(error.problem, ReadProblem::OutOfMemory { .. }), "{error}");
    }
    read
}

/// Fails unless frames are such that displacement can be reckoned in them. (That numbers are finite and indices
/// in range is checked where meshes are made.)
fn assert_sound(mesh: &Mesh) {
    assert!(!mesh.triangles().is_empty());
    for vertex in mesh.vertices() {
        assert!((vertex.normal.length() - 1.0).abs() < 1e-5, "{vertex:?}");
        assert!(vertex.tangent.length() > 0.0 && vertex.bitangent.length() > 0.0, "{vertex:?}");
    }
}

fn assert_right(cases: Vec<Case>) {
    for Case { what, name, bytes, right } in cases {
        match (read(name, &bytes), right) {
            (Ok(file), Right::Mesh(triangles, degenerate, double)) => {
                let found = (file.mesh.triangles().len(), file.degenerate, file.double);
                assert_eq!(found, (triangles, degenerate, double), "{what}");
            }
            (Err(error), Right::Refused(is_right)) => assert!(is_right(&error.problem), "{what}: {error}"),
            (Ok(_), Right::Refused(_)) => panic!("{what} is read"),
            (Err(error), Right::Mesh(..)) => panic!("{what}: {error}"),
        }
    }
}

const SQUARE: &str = "v 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\nvt 0 1\nvt 0 0\nvt 1 0\nvt 1 1\n";

/// An OBJ of a square's corners and of something more.
fn with(more: &str) -> String {
    format!("{SQUARE}{more}\n")
}

#[test]
fn objs_are_read_or_refused() {
    let refused =
        |what, text: &str, is: fn(&ReadProblem) -> bool| case(what, "a.obj", text, Right::Refused(is));
    let read = |what, text: &str, [triangles, degenerate, double]: [usize; 3]| {
        case(what, "a.obj", text, Right::Mesh(triangles, degenerate, double))
    };
    let far = "v 3e9 0 0\nv 3e9 0 1\nv 4e9 0 1\n";
    assert_right(vec![
        refused("no faces", &with(""), is_damaged),
        refused("lines and points alone", &with("l 1 2\np 3"), is_damaged),
        refused("curves", &with("cstype bezier\nsurf 0 1 0 1 1 2 3 4"), is_unsupported),
        refused("a face of two corners", &with("f 1/1 2/2"), is_damaged),
        refused("an index of 0", &with("f 0/1 2/2 3/3"), is_damaged),
        refused("an index beyond the end", &with("f 1/1 2/2 5/3"), is_damaged),
        refused("a huge index", &with("f 1/1 2/2 99999999999/3"), is_damaged),
        refused("one that no number holds", &with("f 1/1 2/2 99999999999999999999999/3"), is_damaged),
        refused("a negative index before the start", &with("f -1/-1 -2/-2 -5/-3"), is_damaged),
        refused("the most negative index", &with("f 1/1 2/2 -9223372036854775808/3"), is_damaged),
        refused("texture coordinates beyond the end", &with("f 1/1 2/9 3/3"), is_damaged),
        refused("normals that are not there", &with("f 1/1/1 2/2/1 3/3/1"), is_damaged),
        refused("a corner without a position", &with("f /1 2/2 3/3"), is_damaged),
        refused("four parts", &with("f 1/1/1/1 2/2 3/3"), is_damaged),
        refused("no number", &with("f one 2/2 3/3"), is_damaged),
        refused("NaN", &with("v nan 0 0\nf 5/1 2/2 3/3"), is_damaged),
        refused("infinity", &with("v 1e999 0 0\nf 5/1 2/2 3/3"), is_damaged),
        refused("two numbers of a position", &with("v 1 2\nf 1/1 2/2 3/3"), is_damaged),
        refused("positions too far away", &with(&format!("{far}f 5/1 6/2 7/3")), has_bad_number),
        refused("texture coordinates too far away", &with("vt 1e7 0\nf 1/1 2/2 3/5"), has_bad_number),
        refused("no texture coordinates", &with("f 1 2 3"), has_no_uv),
        refused("some without texture coordinates", &with("f 1/1 2/2 3/3\nf 1 3 4"), has_no_uv),
        refused("texture coordinates on a point", &with("f 1/1 2/1 3/1"), has_no_texture_area),
        refused("texture coordinates on a line", &with("vt 2 -1\nf 1/1 2/3 3/5"), has_no_texture_area),
        refused("a tile of many kilometres", &with("vt 0 0.9999999\nf 1/1 2/5 3/5"), has_no_texture_area),
        refused("no area", &with("f 1/1 2/2 1/3"), has_no_triangles),
        refused("a face of too many corners", &with(&format!("f {}", "1/1 ".repeat(70_000))), is_unsupported),
        read("a square", &with("f 1/1 2/2 3/3 4/4"), [2, 0, 0]),
        read("indices from the end", &with("f -4/-4 -3/-3 -2/-2"), [1, 0, 0]),
        read("what comes later", &format!("f 1/1 2/2 3/3\n{SQUARE}"), [1, 0, 0]),
        read("triangles without an area", &with("f 1/1 2/2 3/3\nf 1/1 1/1 2/2\nf 2/2 3/3 2/2"), [1, 2, 0]),
        read("doubles", &with("f 1/1 2/2 3/3\nf 2/2 3/3 1/1\nf 1/1 2/2 3/3"), [1, 0, 2]),
        read("two fronts", &with("f 1/1 2/2 3/3\nf 3/3 2/2 1/1"), [2, 0, 0]),
        read(
            "an edge of three triangles",
            &with("v 0 1 0\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\nf 1/1 3/3 5/2"),
            [3, 0, 0],
        ),
        read("texture without an area beside one", &with("f 1/1 2/2 3/3\nf 1/1 3/1 4/1"), [2, 0, 0]),
        read("a normal of 0", &with("vn 0 0 0\nf 1/1/1 2/2/1 3/3/1"), [1, 0, 0]),
        read("a normal along the surface", &with("vn 0 0 1\nf 1/1/1 2/2/1 3/3/1"), [1, 0, 0]),
        read("a sliver", &with("v 0.5 0 0.50000003\nvt 0.5 0.5\nf 1/1 5/5 3/3\nf 1/1 3/3 4/4"), [2, 0, 0]),
        read("other line ends, and texts that are not Unicode", "", [0, 0, 0]).as_latin1(),
    ]);
}

impl Case {
    fn as_latin1(mut self) -> Self {
        self.bytes = with("o caf\u{e9}\\\ng x\nf 1/1 2/2 3/3")
            .replace('\n', "\r\n")
            .chars()
            .map(|c| c as u8)
            .collect();
        self.right = Right::Mesh(1, 0, 0);
        self
    }
}

/// A PLY of a square; `header` and `faces` in place of its own where they are given.
fn square_ply(vertices: u64, faces: &str, count: u64) -> String {
    let properties = ["x", "y", "z", "u", "v"].map(|name| format!("property float {name}\n")).concat();
    format!(
        "ply\nformat ascii 1.0\nelement vertex {vertices}\n{properties}element face {count}\n\
         property list uchar int vertex_indices\nend_header\n0 0 0 0 1\n0 0 1 0 0\n1 0 1 1 0\n1 0 0 1 1\n{faces}\n"
    )
}

#[test]
fn plys_are_read_or_refused() {
    let refused =
        |what, text: String, is: fn(&ReadProblem) -> bool| case(what, "a.ply", text, Right::Refused(is));
    let right = |what, text: String, triangles| case(what, "a.ply", text, Right::Mesh(triangles, 0, 0));
    let plain = square_ply(4, "4 0 1 2 3", 1);
    let mesh = square(1).expect("a mesh");
    let little = String::from_utf8_lossy(&ply(&mesh, Ply::Little)[..40]).into_owned();
    assert_right(vec![
        right("a square", plain.clone(), 2),
        right("an element that nobody knows", plain.replace("element face", "element empty 9999999\nelement face"), 2),
        refused("no PLY", plain.replace("ply\n", "plx\n"), is_damaged),
        refused("no end of the header", plain[..100].to_owned(), is_damaged),
        refused("an unknown format", plain.replace("ascii", "utf8"), is_damaged),
        refused("an unknown type", plain.replace("float x", "complex x"), is_damaged),
        refused("no format", plain.replace("format ascii 1.0\n", ""), is_damaged),
        refused("no z", plain.replace("float z", "float w"), is_damaged),
        refused("more vertices than there are", square_ply(5, "4 0 1 2 3", 1), is_damaged),
        refused("more faces than there are", square_ply(4, "4 0 1 2 3", 2), is_damaged),
        refused("more vertices than memory holds", square_ply(1 << 50, "4 0 1 2 3", 1), is_damaged),
        refused("the most faces", square_ply(4, "4 0 1 2 3", u64::MAX), is_damaged),
        refused("a vertex that is not there", square_ply(4, "3 0 1 4", 1), is_damaged),
        refused("a negative vertex", square_ply(4, "3 0 1 -1", 1), is_damaged),
        refused("half a vertex", square_ply(4, "3 0 1 1.5", 1), is_damaged),
        refused("a list of negative length", square_ply(4, "-3 0 1 2", 1), is_damaged),
        refused("a list longer than all", square_ply(4, "4000000000 0 1 2", 1), is_damaged),
        refused("a face of two corners", square_ply(4, "2 0 1", 1), is_damaged),
        refused("points alone", square_ply(4, "", 0), is_damaged),
        refused("no number", plain.replace("1 0 1 1 0", "1 0 one 1 0"), is_damaged),
        refused("NaN", plain.replace("1 0 1 1 0", "1 0 nan 1 0"), has_bad_number),
        refused("infinite texture coordinates", plain.replace("1 0 1 1 0", "1 0 1 inf 0"), has_bad_number),
        refused("no texture coordinates", plain.replace("float u", "float q"), has_no_uv),
        refused("strips", plain.replace("element face 1", "element tristrips 1"), is_unsupported),
        refused("faces before vertices", "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n3 0 1 2\n".to_owned(), is_damaged),
        refused("a binary header alone", little, is_damaged),
    ]);
}

#[test]
fn texture_coordinates_of_a_plys_faces_are_read() {
    let text = square_ply(4, "4 0 1 2 3 8 0 1 0 0 1 0 1 1", 1)
        .replace("float u", "float q")
        .replace("vertex_indices\n", "vertex_indices\nproperty list uchar float texcoord\n");
    let file = read("faces.ply", text.as_bytes()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(
        file.mesh,
        read("vertices.ply", square_ply(4, "4 0 1 2 3", 1).as_bytes()).expect("a mesh").mesh
    );
}

#[test]
fn stls_are_read_or_refused() {
    let mesh = square(2).expect("a mesh");
    let (text, binary) = (stl_text(&mesh), stl_binary(&mesh));
    let projected = |bytes: &[u8]| {
        let options = MeshOptions { projection: Some(UvProjection::Box), ..MeshOptions::default() };
        read_mesh(Source::bytes("a.stl", bytes), &options)
    };
    for bytes in [text.as_bytes(), &binary, text.to_uppercase().as_bytes()] {
        let file = projected(bytes).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(file.mesh.measures().points, 9);
    }
    let refused =
        |what, bytes: &[u8], is: fn(&ReadProblem) -> bool| case(what, "a.stl", bytes, Right::Refused(is));
    let mut lying = binary.clone();
    lying[80..84].copy_from_slice(&u32::MAX.to_le_bytes());
    let mut headless = lying.clone();
    headless[..5].copy_from_slice(b"mesh ");
    let mut nan = binary.clone();
    nan[84 + 12..84 + 16].copy_from_slice(&f32::NAN.to_le_bytes());
    assert_right(vec![
        refused("no texture coordinates", text.as_bytes(), has_no_uv),
        refused("none in binary", &binary, has_no_uv),
        refused("a count that lies", &headless, is_damaged),
        refused("a count that lies in what may be a text", &lying, is_damaged),
        refused("NaN", &nan, is_damaged),
        refused("NaN in a text", text.replace("vertex -0.5", "vertex nan").as_bytes(), is_damaged),
        refused("four corners", text.replacen("vertex", "vertex 0 0 0 vertex", 1).as_bytes(), is_damaged),
        refused("two corners", text.replacen("vertex", "endloop vertex", 1).as_bytes(), is_damaged),
        refused(
            "other words",
            text.replace("outer loop", "inner loop").replace("loop", "x").as_bytes(),
            is_damaged,
        ),
        refused("nothing in it", b"solid nothing\nendsolid\n", has_no_triangles),
        refused("no triangles", &stl_binary(&Mesh::new(vec![], vec![]).expect("a mesh")), has_no_triangles),
        refused("something else", &[7; 60], is_damaged),
    ]);
    for cut in (0..text.len() - 20).step_by(7) {
        assert!(projected(&text.as_bytes()[..cut]).is_err(), "{cut} bytes of a text");
    }
    for cut in 0..binary.len() {
        assert!(projected(&binary[..cut]).is_err(), "{cut} bytes of a binary file");
    }
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
    let nothing_but_zeros = r#"{"count": 1000000000000, "componentType": 5126, "type": "VEC3", "sparse": {"count": 0, "indices":
        {"bufferView": 3, "componentType": 5125}, "values": {"bufferView": 0}}"#;
    assert_right(vec![
        right("a square", &[], 2, 0),
        right("a strip", &[(r#", "indices": 3"#, r#", "mode": 5"#)], 2, 0),
        right("a strip that comes back", &[(r#""indices": 3"#, r#""indices": 3, "mode": 5"#)], 3, 1),
        right("a fan", &[(r#""indices": 3"#, r#""indices": 3, "mode": 6"#)], 2, 2),
        right("an extension of materials", &[(r#""scene": 0"#, &sheen)], 2, 0),
        right("no scene", &[(r#""scene": 0, "scenes": [{"nodes": [0]}],"#, "")], 2, 0),
        right("a deep chain of nodes", &[(r#"{"mesh": 0}]"#, &chain)], 2, 0),
        right("two instances", &[(r#""nodes": [0]"#, r#""nodes": [0, 1]"#), (r#"{"mesh": 0}]"#,
            r#"{"mesh": 0}, {"mesh": 0, "translation": [0, 1, 0]}]"#)], 4, 0),
        refused("points", &[(r#""indices": 3"#, r#""indices": 3, "mode": 0"#)], is_damaged),
        refused("lines", &[(r#""indices": 3"#, r#""indices": 3, "mode": 3"#)], is_damaged),
        refused("an unknown mode", &[(r#""indices": 3"#, r#""indices": 3, "mode": 9"#)], is_damaged),
        refused("Draco", &[(r#""scene": 0"#, &draco)], is_unsupported),
        refused("meshopt", &[(r#""scene": 0"#, &meshopt)], is_unsupported),
        refused("a node that is its own child", &[(r#"{"mesh": 0}"#, r#"{"mesh": 0, "children": [0]}"#)], is_damaged),
        refused("a node of two parents", &[(r#""nodes": [0]"#, r#""nodes": [0, 1]"#), (r#"{"mesh": 0}]"#,
            r#"{"mesh": 0, "children": [2]}, {"children": [2]}, {"mesh": 0}]"#)], is_damaged),
        refused("a circle of nodes", &[(r#"{"mesh": 0}]"#,
            r#"{"mesh": 0, "children": [1]}, {"children": [2]}, {"children": [0]}]"#)], is_damaged),
        refused("a node that is not there", &[(r#""nodes": [0]"#, r#""nodes": [7]"#)], is_damaged),
        refused("no mesh in the scene", &[(r#"{"mesh": 0}"#, r#"{"name": "empty"}"#)], is_damaged),
        refused("positions that are not there", &[(r#""POSITION": 0"#, r#""POSITION": 77"#)], is_damaged),
        refused("no positions", &[(r#""POSITION": 0, "#, "")], is_damaged),
        refused("no texture coordinates", &[(r#", "TEXCOORD_0": 2"#, "")], has_no_uv),
        refused("an accessor that is not there", &[(r#""TEXCOORD_0": 2"#, r#""TEXCOORD_0": 9"#)], is_damaged),
        refused("positions as texture coordinates", &[(r#""TEXCOORD_0": 2"#, r#""TEXCOORD_0": 0"#)], is_damaged),
        refused("positions as indices", &[(r#""indices": 3"#, r#""indices": 0"#)], is_damaged),
        refused("fewer normals than positions", &[(r#""bufferView": 1, "count": 4"#, r#""bufferView": 1, "count": 3"#)], is_damaged),
        refused("more elements than the view", &[(r#""count": 4"#, r#""count": 5"#)], is_damaged),
        refused("elements for terabytes", &[(r#""count": 4"#, r#""count": 1000000000000"#)], is_too_large),
        refused("the most elements", &[(r#""count": 4"#, r#""count": 18446744073709551615"#)], is_too_large),
        refused("indices for terabytes", &[(r#""count": 6"#, r#""count": 1000000000000"#)], is_too_large),
        refused("an accessor that begins behind its view", &[(r#""bufferView": 0,"#, r#""bufferView": 0, "byteOffset": 4611686018427387904,"#)], is_damaged),
        refused("a view beyond its buffer", &[(r#""byteOffset": 0, "byteLength": 48"#, r#""byteOffset": 130, "byteLength": 48"#)], is_damaged),
        refused("a view that wraps around", &[(r#""byteOffset": 0, "byteLength": 48"#, r#""byteOffset": 18446744073709551615, "byteLength": 48"#)], is_damaged),
        refused("a buffer longer than its bytes", &[(r#""byteLength": 152}]"#, r#""byteLength": 99999999999}]"#)], is_damaged),
        refused("an index beyond the vertices", &[(r#""bufferView": 3, "count": 6, "componentType": 5125"#, r#""bufferView": 0, "count": 6, "componentType": 5125"#)], is_damaged),
        right("a sparse accessor", &[(positions, &sparse("4")), (r#""bufferViews": ["#, r#""bufferViews": ["#), (
            r#""byteOffset": 128, "byteLength": 24}"#, r#""byteOffset": 128, "byteLength": 24}, {"buffer": 0, "byteOffset": 152, "byteLength": 16}"#),
            (r#""byteLength": 152}]"#, r#""byteLength": 168}]"#)], 2, 0).followed_by(&[0, 1, 2, 3]),
        refused("a sparse accessor beyond its end", &[(positions, &sparse("0"))], is_damaged),
        refused("sparse nothing for terabytes", &[(positions, nothing_but_zeros)], is_too_large),
        refused("an infinite place", &[(r#"{"mesh": 0}"#, r#"{"mesh": 0, "translation": [1e38, 0, 0], "scale": [1e38, 1e38, 1e38]}"#)], has_bad_number),
        refused("no size", &[(r#"{"mesh": 0}"#, r#"{"mesh": 0, "scale": [0, 0, 0]}"#)], has_no_triangles),
        case("no JSON", "a.gltf", "v 0 0 0", Right::Refused(is_damaged)),
        case("deep JSON", "a.gltf", "[".repeat(9999), Right::Refused(is_damaged)),
        case("an old version", "a.glb", [b"glTF".as_slice(), &[1, 0, 0, 0], &[20; 4]].concat(), Right::Refused(is_unsupported)),
        case("no mesh by its name", "a.fbx", SQUARE, Right::Refused(|problem| matches!(problem, ReadProblem::NoMesh))),
        case("nothing", "a.obj", "", Right::Refused(|problem| matches!(problem, ReadProblem::Empty))),
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
    // Bytes in memory have nothing beside them.
    let bytes = gltf(&mesh, Some("a.bin"), "");
    let error = read("a.gltf", bytes.as_bytes()).expect_err("no folder");
    assert!(is_unsupported(&error.problem), "{error}");
}

#[test]
fn no_more_memory_is_taken_than_allowed() {
    let mesh = torus(100, 100).expect("a mesh");
    let files = [
        ("a.obj", obj(&mesh, true).into_bytes()),
        ("a.ply", ply(&mesh, Ply::Little)),
        ("a.stl", stl_binary(&mesh)),
        ("a.glb", glb(&gltf(&mesh, None, ""), &gltf_buffer(&mesh))),
    ];
    for (name, bytes) in files {
        for max_bytes in [0, 1000, 1 << 20, 8 << 20] {
            let options = MeshOptions { max_bytes, projection: Some(UvProjection::Box) };
            let error = read_mesh(Source::bytes(name, &bytes), &options).expect_err(name);
            assert!(is_too_large(&error.problem), "{name}: {error}");
        }
        let options = MeshOptions { max_bytes: 16 << 20, projection: Some(UvProjection::Box) };
        assert!(read_mesh(Source::bytes(name, &bytes), &options).is_ok(), "{name}");
    }
}

/// A small valid file of every format.
fn valid_files() -> Vec<(&'static str, Vec<u8>)> {
    let mesh = torus(5, 4).expect("a mesh");
    let buffer = gltf_buffer(&mesh);
    vec![
        ("a.obj", obj(&mesh, true).into_bytes()),
        ("a.ply", ply(&mesh, Ply::Text)),
        ("little.ply", ply(&mesh, Ply::Little)),
        ("big.ply", ply(&mesh, Ply::Big)),
        ("a.stl", stl_text(&mesh).into_bytes()),
        ("binary.stl", stl_binary(&mesh)),
        ("a.gltf", gltf(&mesh, Some(&data_uri(&buffer)), r#""scale": [2, 1, 1]"#).into_bytes()),
        ("a.glb", glb(&gltf(&mesh, None, r#""scale": [2, 1, 1]"#), &buffer)),
    ]
}

#[test]
fn cut_files_end_in_an_error_or_a_valid_mesh() {
    for (name, bytes) in valid_files() {
        let is_whole_or_nothing =
            name.starts_with("big") || name.starts_with("little") || name.contains(".gl");
        for cut in 0..bytes.len() {
            let read = read(name, &bytes[..cut]);
            assert!(read.is_err() || !is_whole_or_nothing, "{cut} bytes of {name} are read");
        }
    }
}

#[test]
fn flipped_bits_end_in_an_error_or_a_valid_mesh() {
    for (name, bytes) in valid_files() {
        let mut survivors = 0;
        for seed in 0..FLIPS {
            let mut random = Random::new(seed);
            let mut broken = bytes.clone();
            for _ in 0..1 + random.below(4) {
                let at = random.below(broken.len());
                broken[at] ^= 1 << random.below(8);
            }
            survivors += usize::from(read(name, &broken).is_ok());
        }
        println!("{name}: {survivors} of {FLIPS} are still read");
    }
}
