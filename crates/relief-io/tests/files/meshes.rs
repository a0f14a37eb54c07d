//! Meshes that are read equal the written ones, with true normals and frames.

use std::path::Path;

use crate::common::Folder;
use crate::common::mesh_file::{Ply, data_uri, glb, gltf, gltf_buffer, obj, ply, stl_binary, stl_text};
use glam::{DVec3, Vec3};
use relief_core::mesh::{Builtin, Mesh, UvProjection, Vertex, cube, cylinder, sphere, torus};
use relief_io::{MeshFile, MeshOptions, Source, read_mesh};

/// Reads a file's bytes by its name.
fn read(name: &str, bytes: &[u8]) -> MeshFile {
    let file = read_mesh(Source::bytes(name, bytes), &MeshOptions::default());
    file.unwrap_or_else(|error| panic!("{error}"))
}

fn projected(name: &str, bytes: &[u8], projection: UvProjection) -> Mesh {
    let options = MeshOptions { projection: Some(projection), ..MeshOptions::default() };
    read_mesh(Source::bytes(name, bytes), &options).unwrap_or_else(|error| panic!("{error}")).mesh
}

/// Greatest differences between the corners of two meshes of the same triangles: of positions, normals,
/// texture coordinates, and of tangents and bitangents relative to the longest.
fn differences(a: &Mesh, b: &Mesh) -> [f64; 4] {
    assert_eq!(a.triangles().len(), b.triangles().len());
    let longest = |vector: fn(&Vertex) -> Vec3| {
        a.vertices().iter().map(|vertex| vector(vertex).length()).fold(0.0, f32::max)
    };
    let (tangent, bitangent) = (longest(|vertex| vertex.tangent), longest(|vertex| vertex.bitangent));
    let mut worst = [0.0f32; 4];
    for triangle in 0..a.triangles().len() as u32 {
        for (a, b) in a.corners(triangle).into_iter().zip(b.corners(triangle)) {
            let frame = ((a.tangent - b.tangent).length() / tangent)
                .max((a.bitangent - b.bitangent).length() / bitangent);
            let found = [
                (a.position - b.position).length(),
                (a.normal - b.normal).length(),
                (a.uv - b.uv).length(),
                frame,
            ];
            worst.iter_mut().zip(found).for_each(|(worst, found)| *worst = worst.max(found));
        }
    }
    worst.map(f64::from)
}

/// Returns 1 if the texture is upright, -1 if it is mirrored.
fn handedness(vertex: &Vertex) -> f32 {
    vertex.bitangent.cross(vertex.tangent).dot(vertex.normal).signum()
}

fn written_torus() -> Mesh {
    torus(64, 32).expect("a built-in mesh")
}

/// The torus in every format that has texture coordinates.
fn torus_files() -> Vec<(&'static str, Vec<u8>)> {
    let mesh = written_torus();
    let buffer = gltf_buffer(&mesh);
    vec![
        ("torus.obj", obj(&mesh, true).into_bytes()),
        ("torus.ply", ply(&mesh, Ply::Text)),
        ("little.ply", ply(&mesh, Ply::Little)),
        ("BIG.PLY", ply(&mesh, Ply::Big)),
        ("torus.gltf", gltf(&mesh, Some(&data_uri(&buffer)), "").into_bytes()),
        ("torus.glb", glb(&gltf(&mesh, None, ""), &buffer)),
    ]
}

#[test]
fn written_meshes_are_read_back_in_every_format() {
    let mesh = written_torus();
    for (name, bytes) in torus_files() {
        let file = read(name, &bytes);
        let [positions, normals, uvs, frames] = differences(&mesh, &file.mesh);
        assert!(positions == 0.0 && normals < 2e-7 && uvs < 2e-7, "{name}: {positions} {normals} {uvs}");
        // A triangle's frame belongs to a chord, which is half a percent shorter than the arc of
        // one of 32 pieces.
        assert!(frames < 0.01, "{name}: {frames}");
        assert_eq!((file.degenerate, file.double), (0, 0), "{name}");
        assert_eq!(file.mesh.vertices().len(), mesh.vertices().len(), "{name}");
        assert_eq!(read(name, &bytes), file, "{name} twice");
    }
}

#[test]
fn frames_converge_to_those_of_the_surface() {
    for kind in [Builtin::Torus, Builtin::Cylinder] {
        let error = |fineness: u32| {
            let mesh = match kind {
                Builtin::Torus => torus(2 * fineness, fineness),
                _ => cylinder(fineness, 1),
            };
            let mesh = mesh.expect("a built-in mesh");
            differences(&mesh, &read("mesh.obj", obj(&mesh, true).as_bytes()).mesh)[3]
        };
        let (coarse, fine) = (error(24), error(96));
        // Of second order, at the cuts of the texture, too.
        assert!(fine < 0.1 * coarse, "{kind}: {coarse}, {fine}");
    }
}

#[test]
fn a_tiled_texture_goes_on_across_its_cut() {
    let mesh = torus(48, 24).and_then(|mesh| mesh.tiled(glam::Vec2::new(6.0, 3.0))).expect("a built-in mesh");
    let read = read("torus.obj", obj(&mesh, true).as_bytes()).mesh;
    let at = |position: Vec3| -> Vec<Vertex> {
        read.vertices().iter().filter(|vertex| vertex.position == position).copied().collect()
    };
    let cut = mesh.vertices()[5 * 49];
    let sides = at(cut.position);
    assert_eq!(sides.len(), 2, "{sides:?}");
    assert_eq!((sides[0].tangent, sides[0].bitangent), (sides[1].tangent, sides[1].bitangent));
    assert_eq!((sides[0].uv.x - sides[1].uv.x).abs(), 6.0);
    // Of one side alone it would be half a division off, which is 0.07.
    assert!((sides[0].tangent.normalize() - cut.tangent.normalize()).length() < 0.01);
}

/// Two adjacent squares on the ground, each of 1 m. `uvs` are the texture coordinates of their
/// corners: first of the left one (from -x to 0), then of the right one, each from back to front.
fn two_squares(uvs: [[f64; 2]; 8]) -> Mesh {
    let positions = "v -1 0 0\nv -1 0 1\nv 0 0 1\nv 0 0 0\nv 0 0 0\nv 0 0 1\nv 1 0 1\nv 1 0 0\n";
    let uvs: String = uvs.iter().map(|[u, v]| format!("vt {u} {}\n", 1.0 - v)).collect();
    let faces = "f 1/1 2/2 3/3 4/4\nf 5/5 6/6 7/7 8/8\n";
    read("squares.obj", [positions, &uvs, faces].concat().as_bytes()).mesh
}

#[test]
fn mirrored_charts_keep_their_handedness() {
    let right = [[0.0, 0.0], [0.0, 1.0], [1.0, 1.0], [1.0, 0.0]];
    let left = [[1.0, 0.0], [1.0, 1.0], [0.0, 1.0], [0.0, 0.0]];
    let mesh = two_squares([left[0], left[1], left[2], left[3], right[0], right[1], right[2], right[3]]);
    // The two vertices in the middle exist twice, although only their frames differ.
    assert_eq!(mesh.vertices().len(), 8);
    for triangle in 0..mesh.triangles().len() as u32 {
        let corners = mesh.corners(triangle);
        let is_left = corners.iter().any(|corner| corner.position.x < 0.0);
        for corner in corners {
            let (tangent, hand) = if is_left { (Vec3::NEG_X, -1.0) } else { (Vec3::X, 1.0) };
            assert_eq!((corner.tangent, corner.bitangent), (tangent, Vec3::Z));
            assert_eq!(handedness(corner), hand);
        }
    }
    assert_eq!(mesh.measures().mirrored, 2);
}

#[test]
fn a_seam_does_not_bend_tangents() {
    // The right square has its texture turned by a quarter, and twice as large.
    let mesh = two_squares([
        [0.0, 0.0],
        [0.0, 1.0],
        [1.0, 1.0],
        [1.0, 0.0],
        [0.0, 0.5],
        [0.5, 0.5],
        [0.5, 0.0],
        [0.0, 0.0],
    ]);
    for triangle in 0..mesh.triangles().len() as u32 {
        let corners = mesh.corners(triangle);
        let is_left = corners.iter().any(|corner| corner.position.x < 0.0);
        for corner in corners {
            let expected = if is_left { (Vec3::X, Vec3::Z) } else { (2.0 * Vec3::Z, -2.0 * Vec3::X) };
            assert_eq!((corner.tangent, corner.bitangent), expected);
        }
    }
    let measures = mesh.measures();
    assert_eq!((measures.seams, measures.charts, measures.hard_edges), (1, 2, 0));
}

#[test]
fn missing_normals_are_weighted_by_angles() {
    let built_in = cube(1).expect("a built-in mesh");
    let read = read("cube.obj", obj(&built_in, false).as_bytes()).mesh;
    for vertex in read.vertices() {
        let outward = vertex.position.normalize();
        assert!((vertex.normal - outward).length() < 1e-6, "{vertex:?}");
        // Frames are turned with the normal and keep the length of a tile.
        assert!(
            (vertex.tangent.length() - 1.0).abs() < 1e-6 && vertex.tangent.dot(vertex.normal).abs() < 1e-6
        );
        assert_eq!(handedness(vertex), 1.0);
    }
    // Those that are given stay: edges are hard.
    let hard = self::read("cube.obj", obj(&built_in, true).as_bytes()).mesh;
    assert_eq!(differences(&built_in, &hard), [0.0; 4]);
    assert_eq!((hard.measures().hard_edges, read.measures().hard_edges), (12, 0));
}

#[test]
fn projections_match_the_built_in_shapes() {
    let (cube, ball) = (cube(3).expect("a mesh"), sphere(48, 24).expect("a mesh"));
    let boxed = projected("cube.stl", &stl_binary(&cube), UvProjection::Box);
    for triangle in 0..cube.triangles().len() as u32 {
        for (a, b) in cube.corners(triangle).into_iter().zip(boxed.corners(triangle)) {
            assert!((a.uv - b.uv).length() < 1e-6, "{a:?} {b:?}");
            // The conversion to millimetres and back changes at most the last bit.
            assert!((a.position - b.position).abs().max_element() < 1e-7, "{a:?} {b:?}");
        }
    }
    let globe = projected("ball.stl", stl_text(&ball).as_bytes(), UvProjection::Sphere);
    let [positions, normals, uvs, frames] = differences(&ball, &globe);
    assert!(positions < 1e-6 && normals < 0.01 && uvs < 1e-6, "{positions} {normals} {uvs}");
    // At the poles the built-in sphere chooses a frame; everywhere else they are the same.
    assert!(frames < 0.08, "{frames}");
    for triangle in 0..globe.triangles().len() as u32 {
        let around = globe.corners(triangle).map(|corner| corner.uv.x);
        let span =
            around.iter().copied().fold(f32::MIN, f32::max) - around.iter().copied().fold(f32::MAX, f32::min);
        assert!(span < 0.5, "{around:?}");
    }
    let tube = cylinder(48, 2).expect("a mesh");
    let rolled = projected("tube.stl", &stl_binary(&tube), UvProjection::Cylinder);
    assert!(differences(&tube, &rolled)[2] < 1e-6);
}

#[test]
fn nodes_place_their_meshes() {
    let mesh = written_torus();
    let buffer = gltf_buffer(&mesh);
    let placed = |node: &str| read("torus.glb", &glb(&gltf(&mesh, None, node), &buffer)).mesh;
    let moved = placed(r#""translation": [1, 2, 3], "scale": [2, 2, 2]"#);
    for triangle in 0..mesh.triangles().len() as u32 {
        for (a, b) in mesh.corners(triangle).into_iter().zip(moved.corners(triangle)) {
            assert!((2.0 * a.position + Vec3::new(1.0, 2.0, 3.0) - b.position).length() < 1e-6);
            assert!((a.normal - b.normal).length() < 1e-6);
            assert!((2.0 * a.tangent - b.tangent).length() < 0.05);
        }
    }
    // Uneven scales turn normals the other way than positions; mirrors turn fronts over.
    for node in [r#""scale": [1, 3, 0.5]"#, r#""scale": [-1, 1, 1]"#, r#""rotation": [0, 0.6, 0, 0.8]"#] {
        let placed = placed(node);
        let mirrored = node.contains("-1");
        for triangle in 0..placed.triangles().len() as u32 {
            let corners = placed.corners(triangle);
            let [a, b, c] = corners.map(|corner| corner.position.as_dvec3());
            let front = (b - a).cross(c - a).normalize();
            for corner in corners {
                assert!(front.dot(corner.normal.as_dvec3()) > 0.8, "{node}");
                assert_eq!(handedness(corner), if mirrored { -1.0 } else { 1.0 }, "{node}");
            }
        }
    }
}

#[test]
fn faces_of_many_corners_are_cut_into_triangles() {
    let positions = "v 0 0 0\nv 0 0 2\nv 2 0 2\nv 2 0 0\nv 1 0 -1\n";
    let uvs = "vt 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0.5 1.5\n";
    let file = [positions, uvs, "f 1/1 2/2 3/3 \\\n 4/4 -1/-1\n"].concat();
    let mesh = read("house.obj", file.as_bytes()).mesh;
    let area: f64 = (0..mesh.triangles().len() as u32)
        .map(|triangle| {
            let [a, b, c] = mesh.corners(triangle).map(|corner| corner.position.as_dvec3());
            0.5 * (b - a).cross(c - a).dot(DVec3::Y)
        })
        .sum();
    assert_eq!((mesh.triangles().len(), area), (3, 5.0));
}

#[test]
fn buffers_lie_beside_their_gltf() {
    let folder = Folder::new();
    let mesh = written_torus();
    std::fs::create_dir(folder.path().join("a b")).expect("the temporary folder is writable");
    folder.file("a b/torus.bin", &gltf_buffer(&mesh));
    let path = folder.file("torus.gltf", gltf(&mesh, Some("./a%20b/torus.bin"), "").as_bytes());
    let file = read_mesh(&path, &MeshOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(file.mesh, read("torus.glb", &glb(&gltf(&mesh, None, ""), &gltf_buffer(&mesh))).mesh);
}

/// Torus as a glTF with one material, whose picture is `image`.
fn painted(image: &str, more: &str) -> Vec<u8> {
    let mesh = written_torus();
    let buffer = gltf_buffer(&mesh);
    let material = format!(
        r#""materials": [{{"pbrMetallicRoughness": {{"baseColorFactor": [0.5, 1, 7, 1],
        "baseColorTexture": {{"index": 0{more}}}}}}}], "textures": [{{"source": 0}}], "images": [{image}],
        "buffers""#
    );
    let json = gltf(&mesh, Some(&data_uri(&buffer)), "");
    let json = json.replace(r#""indices": 3"#, r#""indices": 3, "material": 0"#);
    json.replacen(r#""buffers""#, &material, 1).into_bytes()
}

#[test]
fn colours_are_those_of_the_only_material() {
    let red = crate::common::files::png(1, 1, png::ColorType::Rgb, png::BitDepth::Eight, &[255, 0, 0]);
    let image = format!(r#"{{"uri": "{}"}}"#, data_uri(&red));
    let options = MeshOptions { colors: true, ..MeshOptions::default() };
    let read = |bytes: &[u8], options: &MeshOptions| read_mesh(Source::bytes("a.gltf", bytes), options);
    let colors = |bytes: &[u8], options: &MeshOptions| {
        read(bytes, options).unwrap_or_else(|error| panic!("{error}")).colors
    };
    let found = colors(&painted(&image, ""), &options).expect("a material");
    // Factors are parts of the light.
    let [material] = &found.materials[..] else { panic!("{} materials", found.materials.len()) };
    assert_eq!(material.factor, [0.5, 1.0, 1.0, 1.0]);
    assert_eq!(material.picture.as_ref().expect("a picture").texels, [[1.0, 0.0, 0.0, 1.0]]);
    assert_eq!(colors(&painted(&image, ""), &MeshOptions::default()), None);
    assert_eq!(colors(&torus_files()[4].1, &options), None);
    // A projection changes the coordinates of maps; the picture keeps the file's.
    let projected = MeshOptions { projection: Some(UvProjection::Box), ..options };
    let found = colors(&painted(&image, ""), &projected).expect("a material");
    assert!(found.materials[0].picture.is_some() && !found.uvs.is_empty());
    for broken in [r#"{"uri": "data:;base64,AAAA"}"#, r#"{"uri": "../a.png"}"#, r#"{"bufferView": 0}"#, "{}"]
    {
        assert!(read(&painted(broken, ""), &options).is_err(), "{broken}");
        assert!(read(&painted(broken, ""), &MeshOptions::default()).is_ok(), "{broken}");
    }
}

#[test]
fn stated_measures_are_correct() {
    let cube = cube(2).expect("a mesh");
    let measures = read("cube.obj", obj(&cube, true).as_bytes()).mesh.measures();
    assert_eq!((measures.vertices, measures.points, measures.triangles), (6 * 9, 26, 48));
    assert_eq!((measures.charts, measures.seams, measures.hard_edges), (6, 24, 24));
    assert_eq!((measures.open_edges, measures.branching_edges, measures.mirrored), (0, 0, 0));
    assert_eq!(measures.bounds_m, [Vec3::splat(-0.5), Vec3::splat(0.5)]);
    assert!(
        measures.tile_m.iter().all(|tile| (tile.least - 1.0).abs() < 1e-6 && tile.least == tile.greatest)
    );
    assert_eq!(measures.normal_angle_deg.greatest, 0.0);
    let torus = written_torus().measures();
    assert_eq!((torus.charts, torus.seams, torus.open_edges, torus.hard_edges), (1, 64 + 32, 0, 0));
    assert!(torus.normal_angle_deg.greatest > 360.0 / 32.0 - 0.1, "{torus:?}");
}

#[test]
fn real_meshes_are_read() {
    let Some(data) = crate::common::real_data() else { return };
    let path = data.join("spot/spot_triangulated.obj");
    if !Path::new(&path).is_file() {
        return;
    }
    let file = read_mesh(&path, &MeshOptions::default()).unwrap_or_else(|error| panic!("{error}"));
    let measures = file.mesh.measures();
    assert_eq!((measures.triangles, measures.points), (5856, 2930));
    assert_eq!((measures.open_edges, measures.branching_edges, file.degenerate, file.double), (0, 0, 0, 0));
    let quads = read_mesh(&data.join("spot/spot_control_mesh.obj"), &MeshOptions::default());
    assert!(quads.is_ok(), "{quads:?}");
}
