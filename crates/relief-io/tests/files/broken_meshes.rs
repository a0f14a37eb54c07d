//! Reading any mesh file ends soon, in an error or a valid mesh.

use crate::common::Random;
use crate::common::broken_mesh::{
    Case, Right, assert_right, case, has_bad_number, has_no_texture_area, has_no_triangles, has_no_uv,
    has_short_tiles, is_damaged, is_too_large, is_unsupported, read,
};
use crate::common::gltf_file::Gltf;
use crate::common::mesh_file::{Ply, data_uri, glb, gltf, gltf_buffer, obj, ply, stl_binary, stl_text};
use relief_core::mesh::{Mesh, UvProjection, square, torus};
use relief_io::{MeshOptions, ReadProblem, Source, read_mesh};

/// Number of flipped copies per valid file.
const FLIPS: u64 = 1500;

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
        refused(
            "a part without an area in the texture",
            &with("v 5 0 0\nv 5.1 0 0\nv 5 0 0.1\nf 1/1 2/2 3/3\nf 5/1 6/1 7/1"),
            has_no_texture_area,
        ),
        read(
            "a speck without one",
            &with("v 5 0 0\nv 5.0001 0 0\nv 5 0 0.0001\nf 1/1 2/2 3/3\nf 5/1 6/1 7/1"),
            [2, 0, 0],
        ),
        read("a normal of 0", &with("vn 0 0 0\nf 1/1/1 2/2/1 3/3/1"), [1, 0, 0]),
        read("a normal along the surface", &with("vn 0 0 1\nf 1/1/1 2/2/1 3/3/1"), [1, 0, 0]),
        read("a sliver", &with("v 0.5 0 0.50000003\nvt 0.5 0.5\nf 1/1 5/5 3/3\nf 1/1 3/3 4/4"), [2, 0, 0]),
        read("other line ends, and texts that are not Unicode", "", [0, 0, 0]).in_latin1(),
    ]);
}

impl Case {
    fn in_latin1(mut self) -> Self {
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
         property list uchar int vertex_indices\nend_header\n\
         0 0 0 0 1\n0 0 1 0 0\n1 0 1 1 0\n1 0 0 1 1\n{faces}\n"
    )
}

#[test]
fn plys_are_read_or_refused() {
    let refused =
        |what, text: String, is: fn(&ReadProblem) -> bool| case(what, "a.ply", text, Right::Refused(is));
    let right = |what, text: String, triangles| case(what, "a.ply", text, Right::Mesh(triangles, 0, 0));
    let plain = square_ply(4, "4 0 1 2 3", 1);
    let nobody = "element empty 9999999\n";
    let early = "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n";
    let early = format!("{early}end_header\n3 0 1 2\n");
    let mesh = square(1).expect("a mesh");
    let little = String::from_utf8_lossy(&ply(&mesh, Ply::Little)[..40]).into_owned();
    assert_right(vec![
        right("a square", plain.clone(), 2),
        right(
            "an element that nobody knows",
            plain.replace("element face", &format!("{nobody}element face")),
            2,
        ),
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
        refused("faces before vertices", early, is_damaged),
        refused("a binary header alone", little, is_damaged),
    ]);
}

/// Tests a mesh so small that no `f32` holds the squares of its lengths, in every format with texture
/// coordinates. Its positions, the scale of a node, or misaligned positions make it small.
#[test]
fn meshes_of_next_to_no_size_are_refused() {
    let refused = |what, name, bytes: Vec<u8>| case(what, name, bytes, Right::Refused(has_short_tiles));
    let mesh = square(1).expect("a mesh");
    let small = SQUARE.replace("v 0 0 1", "v 0 0 1e-30").replace("v 1 0 1", "v 1e-30 0 1e-30");
    let small = small.replace("v 1 0 0", "v 1e-30 0 0") + "f 1/1 2/2 3/3 4/4\n";
    let narrow = SQUARE.replace("v 0 0 1", "v 0 0 1e-41").replace("v 1 0 1", "v 1 0 1e-41");
    let narrow = narrow + "f 1/1 2/2 3/3 4/4\n";
    let ply = square_ply(4, "4 0 1 2 3", 1);
    let ply = ply.replace("0 0 1 0 0", "0 0 1e-25 0 0").replace("1 0 1 1 0", "1e-25 0 1e-25 1 0");
    let scaled = gltf(&mesh, Some(&data_uri(&gltf_buffer(&mesh))), r#""scale": [1e-25, 1e-25, 1e-25]"#);
    let shifted = String::from_utf8(Gltf::square().json()).expect("a text");
    let shifted = shifted.replacen(r#""byteOffset": 0"#, r#""byteOffset": 2"#, 1);
    assert_right(vec![
        refused("a small square", "a.obj", small.into_bytes()),
        refused("a square next to no width", "a.obj", narrow.into_bytes()),
        refused("small positions", "a.ply", ply.replace("1 0 0 1 1", "1e-25 0 0 1 1").into_bytes()),
        refused("a small scale", "a.gltf", scaled.into_bytes()),
        refused("positions that begin within a number", "a.gltf", shifted.into_bytes()),
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
        refused("NaN in a text", text.replace("vertex -500", "vertex nan").as_bytes(), is_damaged),
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
            let options = MeshOptions {
                max_bytes,
                projection: Some(UvProjection::Box),
                colors: true,
                ..MeshOptions::default()
            };
            let error = read_mesh(Source::bytes(name, &bytes), &options).expect_err(name);
            assert!(is_too_large(&error.problem), "{name}: {error}");
        }
        let options = MeshOptions {
            max_bytes: 16 << 20,
            projection: Some(UvProjection::Box),
            colors: true,
            ..MeshOptions::default()
        };
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
