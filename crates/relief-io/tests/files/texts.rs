//! Text files as different programs write them: byte order marks, encodings, line ends, comments,
//! orders of parts.

use crate::common::mesh_file::{Ply, data_uri, glb, gltf, gltf_buffer, obj, ply, stl_binary, stl_text};
use glam::Vec3;
use relief_core::mesh::{Mesh, RawMesh, UvProjection, cube, torus};
use relief_io::{
    HeightOptions, MeshOptions, ReadProblem, Source, decode_text, read_height, read_mesh, read_mesh_extras,
    read_raw_mesh,
};

const MARK: &[u8] = b"\xef\xbb\xbf";

fn raw(name: &str, bytes: &[u8]) -> RawMesh {
    read_raw_mesh(Source::bytes(name, bytes), 64 << 20).unwrap_or_else(|error| panic!("{error}"))
}

fn problem(name: &str, bytes: &[u8]) -> ReadProblem {
    let options = MeshOptions { projection: Some(UvProjection::Box), ..MeshOptions::default() };
    read_mesh(Source::bytes(name, bytes), &options).expect_err(name).problem
}

fn marked(text: &[u8]) -> Vec<u8> {
    [MARK, text].concat()
}

/// The text in UTF-16 with its mark.
fn utf16(text: &[u8], big_endian: bool) -> Vec<u8> {
    let units = text.iter().map(|&byte| u16::from(byte));
    let bytes = |unit: u16| if big_endian { unit.to_be_bytes() } else { unit.to_le_bytes() };
    std::iter::once(0xfeff).chain(units).flat_map(bytes).collect()
}

fn with_ends(text: &[u8], end: &str) -> Vec<u8> {
    String::from_utf8(text.to_vec()).expect("text").replace('\n', end).into_bytes()
}

fn mesh() -> Mesh {
    torus(8, 5).expect("a built-in mesh")
}

/// One mesh in every text format.
fn texts() -> Vec<(&'static str, Vec<u8>)> {
    let mesh = mesh();
    vec![
        ("torus.obj", obj(&mesh, true).into_bytes()),
        ("torus.ply", ply(&mesh, Ply::Text)),
        ("torus.stl", stl_text(&mesh).into_bytes()),
        ("torus.gltf", gltf(&mesh, Some(&data_uri(&gltf_buffer(&mesh))), "").into_bytes()),
    ]
}

#[test]
fn byte_order_marks_are_skipped() {
    for (name, text) in texts() {
        assert_eq!(raw(name, &marked(&text)), raw(name, &text), "{name}");
    }
    // Its first line is a position, which relative numbers count from.
    let relative = b"v 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf -4 -3 -2\nf 1 3 4\n";
    let read = raw("a.obj", &marked(relative));
    assert_eq!((read.positions.len(), read.positions[0]), (4, Vec3::splat(9.0)));
    assert_eq!(read, raw("a.obj", relative));
    let json = &texts()[3].1;
    let extras = |bytes: &[u8]| read_mesh_extras(Source::bytes("a.gltf", bytes), "relief", 1 << 20);
    assert!(extras(&marked(json)).is_ok());
    // Plain grey maps are text, too.
    let map = |bytes: &[u8]| {
        read_height(Source::bytes("a.pgm", bytes), &HeightOptions::default()).map(|map| map.texels().to_vec())
    };
    let plain = b"P2 2 2 9\n0 3 6 9\n";
    assert_eq!(map(&marked(plain)).expect("a map"), map(plain).expect("a map"));
}

#[test]
fn text_in_utf_16_is_named() {
    for (name, text) in texts() {
        for big_endian in [false, true] {
            let problem = problem(name, &utf16(&text, big_endian));
            assert!(matches!(problem, ReadProblem::Unsupported { .. }), "{name}: {problem}");
            assert!(problem.to_string().contains("UTF-16"), "{name}: {problem}");
        }
    }
}

#[test]
fn binary_files_are_no_texts() {
    let mesh = mesh();
    let stl = stl_binary(&mesh);
    for head in [MARK, b"solid", b"\xff\xfe", b"\xef\xbb\xbfsolid"] {
        let mut bytes = stl.clone();
        bytes[..head.len()].copy_from_slice(head);
        assert_eq!(raw("a.stl", &bytes), raw("a.stl", &stl), "{head:?}");
    }
    let gltf = glb(&gltf(&mesh, None, ""), &gltf_buffer(&mesh));
    assert!(read_mesh(Source::bytes("a.glb", &marked(&gltf)), &MeshOptions::default()).is_err());
}

#[test]
fn line_ends_of_all_systems_are_read() {
    for (name, text) in texts() {
        for end in ["\r\n", "\r"] {
            assert_eq!(raw(name, &with_ends(&text, end)), raw(name, &text), "{name} with {end:?}");
        }
    }
    // Behind the header numbers follow at once, whatever they are.
    for kind in [Ply::Little, Ply::Big] {
        let bytes = ply(&mesh(), kind);
        let end = bytes.windows(11).position(|line| line == b"end_header\n").expect("a header") + 11;
        for line_end in ["\r\n", "\r"] {
            let changed = [with_ends(&bytes[..end], line_end), bytes[end..].to_vec()].concat();
            assert_eq!(raw("a.ply", &changed), raw("a.ply", &bytes), "{line_end:?}");
        }
    }
    // Its first number begins with a line feed, which ends no line.
    let header = "ply\rformat binary_little_endian 1.0\relement vertex 3\rproperty float x\rproperty float \
                  y\rproperty float z\relement face 1\rproperty list uchar int vertex_indices\rend_header\r";
    let first = f32::from_le_bytes([b'\n', 0, 0, 0]);
    let numbers = [first, 0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.0, 0.0].map(f32::to_le_bytes).concat();
    let face = [&[3][..], &[0u32, 1, 2].map(u32::to_le_bytes).concat()].concat();
    let read = raw("a.ply", &[header.as_bytes(), &numbers, &face].concat());
    assert_eq!((read.positions.len(), read.positions[0].x), (3, first));
}

#[test]
fn errors_count_lines_by_any_end() {
    let square = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
    let obj = format!("{square}\nf 1 2 \\\n 3\nf 1 2 x\n");
    let ply = String::from_utf8(ply(&mesh(), Ply::Text)).expect("text");
    let broken_ply = ply.replacen("\n3 ", "\n3 x ", 1);
    let ply_line = broken_ply.lines().position(|line| line.starts_with("3 x")).expect("a face") + 1;
    let stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n".to_owned();
    for (name, text, line) in [("a.obj", obj, 7), ("a.ply", broken_ply, ply_line), ("a.stl", stl, 4)] {
        for end in ["\n", "\r\n", "\r"] {
            let problem = problem(name, &with_ends(text.as_bytes(), end)).to_string();
            assert!(problem.contains(&format!("line {line}:")), "{name} with {end:?}: {problem}");
        }
    }
}

#[test]
fn a_comment_may_stand_behind_anything() {
    let plain = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\n\
                 f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/4/1\n";
    let expected = raw("a.obj", plain.as_bytes());
    for comment in [" # front", " #front", "# front", "#", " # 5/5/5", " # v 1 2 3", " # C:\\models\\"] {
        let commented = plain.replace('\n', &format!("{comment}\n"));
        assert_eq!(raw("a.obj", commented.as_bytes()), expected, "{comment}");
    }
    // A comment goes on in no other line, and a line may go on in a commented one.
    let goes_on = plain.replace("f 1/1/1 2/2/1 3/3/1", "# C:\\models\\\nf 1/1/1 \\\n2/2/1 \\\r\n 3/3/1 # \\");
    assert_eq!(raw("a.obj", goes_on.as_bytes()), expected);
    let names = format!("mtllib a#1.mtl\no #2\nusemtl Material #25\n{plain}");
    assert_eq!(raw("a.obj", names.as_bytes()), expected);
}

/// A PLY of a pyramid's square base and one side, with elements in that order; `face` alone may be twice.
fn pyramid(order: &[&str]) -> String {
    let mut header = "ply\nformat ascii 1.0\n".to_owned();
    let mut body = String::new();
    for &name in order {
        let (element, numbers) = match name {
            "vertex" => (
                "element vertex 5\nproperty float x\nproperty float y\nproperty float z\nproperty float u\n\
                 property float v\n",
                "0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n0.5 0.5 1 0.5 0.5\n",
            ),
            "face" => ("element face 1\nproperty list uchar int vertex_indices\n", "4 0 1 2 3\n"),
            "side" => {
                let list = "property uchar red\nproperty list uchar int vertex_index\n";
                header += &format!("element face 1\n{list}");
                body += "255 3 0 1 4\n";
                continue;
            }
            other => panic!("{other}"),
        };
        header += element;
        body += numbers;
    }
    format!("{header}end_header\n{body}")
}

#[test]
fn faces_may_come_before_their_vertices() {
    let expected = raw("a.ply", pyramid(&["vertex", "face", "side"]).as_bytes());
    assert_eq!(expected.triangles.len(), 3);
    for order in [["face", "vertex", "side"], ["face", "side", "vertex"]] {
        assert_eq!(raw("a.ply", pyramid(&order).as_bytes()), expected, "{order:?}");
    }
    // Binary numbers as well.
    let mesh = cube(1).expect("a built-in mesh");
    for kind in [Ply::Little, Ply::Big] {
        let bytes = ply(&mesh, kind);
        let text = |needle: &[u8]| bytes.windows(needle.len()).position(|part| part == needle);
        let [vertex, face, end] = [&b"element vertex"[..], b"element face", b"end_header\n"]
            .map(|part| text(part).expect("a part"));
        let numbers = end + 11;
        let faces = bytes.len() - mesh.triangles().len() * 13;
        let turned = [
            &bytes[..vertex],
            &bytes[face..end],
            &bytes[vertex..face],
            &bytes[end..numbers],
            &bytes[faces..],
            &bytes[numbers..faces],
        ]
        .concat();
        assert_eq!(raw("a.ply", &turned), raw("a.ply", &bytes));
    }
    for (order, what) in [(&["face"][..], "no vertices"), (&["vertex"], "no faces")] {
        let problem = problem("a.ply", pyramid(order).as_bytes()).to_string();
        assert!(problem.contains(what), "{problem}");
    }
    let beyond = pyramid(&["face", "vertex"]).replace("4 0 1 2 3", "4 0 1 2 5");
    assert!(matches!(problem("a.ply", beyond.as_bytes()), ReadProblem::Damaged { .. }));
    let cut = pyramid(&["face", "vertex"]).replace("4 0 1 2 3", "4000000000 0 1 2 3");
    assert!(matches!(problem("a.ply", cut.as_bytes()), ReadProblem::Damaged { .. }));
}

#[test]
fn short_texts_are_decoded() {
    let text = "a = \"grün\"\nb = 1\n";
    let units: Vec<u16> = text.encode_utf16().collect();
    let wide = |bytes: fn(u16) -> [u8; 2]| -> Vec<u8> {
        std::iter::once(0xfeff).chain(units.iter().copied()).flat_map(bytes).collect()
    };
    for bytes in [
        text.as_bytes().to_vec(),
        marked(text.as_bytes()),
        wide(u16::to_le_bytes),
        wide(u16::to_be_bytes),
        text.replace('\n', "\r").into_bytes(),
    ] {
        assert_eq!(decode_text(bytes.clone()).as_deref(), Some(text), "{bytes:?}");
    }
    let windows = text.replace('\n', "\r\n");
    assert_eq!(decode_text(windows.clone().into_bytes()), Some(windows));
    assert_eq!(decode_text(Vec::new()).as_deref(), Some(""));
    for bytes in [&b"gr\xfcn"[..], b"\xff\xfea", b"\xff\xfe\x00\xd8", b"\xef\xbb\xbf\xff", b"\xef\xbb"] {
        assert_eq!(decode_text(bytes.to_vec()), None, "{bytes:?}");
    }
}
