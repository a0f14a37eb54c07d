//! `relief mesh --motif`: a closed mesh in the shells of another.

use std::f64::consts::TAU;

use crate::common::aov::Aov;
use crate::common::command::json_of;
use crate::common::files::exr;
use crate::common::refused::{assert_refused, with_out};
use relief_io::{MeshOptions, read_mesh};

/// A closed torus of few triangles.
fn ring() -> String {
    const COUNT: [usize; 2] = [12, 6];
    let turn = |at: usize, of: usize| TAU * at as f64 / of as f64;
    let mut text = String::new();
    for at in 0..COUNT[0] * COUNT[1] {
        let (a, b) = (turn(at / COUNT[1], COUNT[0]), turn(at % COUNT[1], COUNT[1]));
        let out = [b.cos() * a.cos(), b.sin(), b.cos() * a.sin()];
        let place = [a.cos() + 0.4 * out[0], 0.4 * out[1], a.sin() + 0.4 * out[2]];
        text += &format!("v {} {} {}\nvn {} {} {}\n", place[0], place[1], place[2], out[0], out[1], out[2]);
    }
    for at in 0..(COUNT[0] + 1) * (COUNT[1] + 1) {
        let [u, v] = [at / (COUNT[1] + 1), at % (COUNT[1] + 1)];
        text += &format!("vt {} {}\n", u as f64 / COUNT[0] as f64, v as f64 / COUNT[1] as f64);
    }
    let corner = |i: usize, j: usize| {
        let place = (i % COUNT[0]) * COUNT[1] + j % COUNT[1] + 1;
        format!("{place}/{}/{place}", i * (COUNT[1] + 1) + j + 1)
    };
    for (i, j) in (0..COUNT[0]).flat_map(|i| (0..COUNT[1]).map(move |j| (i, j))) {
        let [a, b, c, d] = [corner(i, j), corner(i, j + 1), corner(i + 1, j + 1), corner(i + 1, j)];
        text += &format!("f {a} {b} {c}\nf {a} {c} {d}\n");
    }
    text
}

#[test]
fn a_motif_is_put_on_a_mesh_in_every_format() {
    let folder = with_out();
    folder.relief("motif mail --links 1 --detail 4 -o mail.glb").fine();
    folder.write("ring.obj", ring());
    let line = "mesh --motif mail.glb --mesh ring.obj --tile 6,2";
    let about = json_of(&folder.relief(&format!("{line} -o out/a.glb --json")).fine());
    assert_eq!([&about["open_edges"], &about["without_area"]], [0, 0]);
    assert_eq!(about["beyond"], 0.0);
    let mesh = read_mesh(folder.path("out/a.glb").as_path(), &MeshOptions::default()).expect("a mesh").mesh;
    // Readers leave out slivers without an area.
    let triangles = about["triangles"].as_u64().expect("a number");
    assert!((triangles - mesh.triangles().len() as u64) * 1000 < triangles, "{about}");
    for ending in ["ply", "obj", "stl"] {
        let other = json_of(&folder.relief(&format!("{line} -o out/a.{ending} --json")).fine());
        assert_eq!(other["triangles"], about["triangles"], "{ending}");
    }
    folder.relief(&format!("{line} --threads 1 -o out/b.glb --json")).fine();
    let [a, b] = ["out/a.glb", "out/b.glb"].map(|name| std::fs::read(folder.path(name)).expect("a file"));
    assert!(a == b);
    // Its depth follows the tiles: they are half as long, so it is half as deep.
    let half = json_of(
        &folder.relief("mesh --motif mail.glb --mesh ring.obj --tile 12,4 -o out/c.glb --json").fine(),
    );
    let [whole, half] = [&about, &half].map(|about| about["scale_m"].as_f64().expect("a length"));
    assert!((whole / half - 2.0).abs() < 1e-5, "{whole} {half}");
    // A file may be the base, with coordinates that a projection makes.
    folder.write("base.obj", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 3 2\n");
    let ran = folder.relief("mesh --motif mail.glb --mesh base.obj --project box --scale 1mm -o out/d.glb");
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    folder.relief("render --mesh out/d.glb --size 32x24 --backend cpu -o out/d.png").fine();
}

#[test]
fn a_vector_displacement_map_is_a_motif() {
    let folder = with_out();
    // A point of the middle row is moved up, and up in the map: to smaller v.
    let mut channels = [[0.0f32; 9]; 3];
    (channels[0][4], channels[1][4], channels[2][4]) = (0.125, 0.5, 0.25);
    let [tangents, normals, bitangents] = channels.map(Vec::from);
    let written = |name: &str, channels: [&Vec<f32>; 3]| {
        let named = ["R", "G", "B"].into_iter().zip(channels.map(Vec::clone)).collect::<Vec<_>>();
        folder.write(name, exr([3, 3], &named));
    };
    written("tnb.exr", [&tangents, &normals, &bitangents]);
    written("tbn.exr", [&tangents, &bitangents, &normals]);
    let line = "mesh --mesh plane --tile 2,2 --scale 2cm --motif";
    let about = json_of(&folder.relief(&format!("{line} tnb.exr -o out/a.glb --json")));
    assert_eq!((&about["axes"], about["scale_m"].as_f64()), (&"tnb".into(), Some(0.02)));
    let told = folder.relief(&format!("{line} tnb.exr -o out/told.glb"));
    assert!(told.stdout.contains("tangent, normal and bitangent"), "{}", told.stdout);
    let other = json_of(&folder.relief(&format!("{line} tbn.exr --axes tbn -o out/b.glb --json")));
    assert_eq!(other["axes"], "tbn");
    let [a, b] = ["out/a.glb", "out/b.glb"].map(|name| std::fs::read(folder.path(name)).expect("a file"));
    assert!(a == b);
    let mesh = read_mesh(folder.path("out/a.glb").as_path(), &MeshOptions::default()).expect("a mesh").mesh;
    let highest = |low: &glam::Vec3, at: glam::Vec3| if at.y > low.y { at } else { *low };
    let top =
        mesh.vertices().iter().fold(glam::Vec3::NEG_INFINITY, |top, vertex| highest(&top, vertex.position));
    assert!((top.y - 0.01).abs() < 1e-6, "{top}");
    // Tiles are half a metre long; their middles are at 0.25 m from the plane's middle.
    let near = |place: f32, moved: f32| ((place.abs() - 0.25).abs() - moved.abs()).abs() < 1e-6;
    assert!(near(top.x, 0.0025) && near(top.z, 0.005), "{top}");
    let is_up = mesh
        .vertices()
        .iter()
        .any(|vertex| vertex.position.distance(glam::Vec3::new(0.2525, 0.01, 0.245)) < 1e-6);
    assert!(is_up, "up in the map is along falling v");
    // A vector is as long as a tile where no scale says more.
    let about = json_of(&folder.relief("mesh --mesh plane --tile 2,2 --motif tnb.exr -o out/c.glb --json"));
    let scale_m = about["scale_m"].as_f64().expect("a length");
    assert!((scale_m - 0.5).abs() < 1e-6, "{scale_m}");
    relief_io::write_png8(&folder.path("v.png"), 1, 1, relief_io::PngColour::Rgb, &[128, 200, 128])
        .expect("written");
    let ran = folder.relief("mesh --mesh torus --motif v.png -o out/d.glb");
    assert!(ran.code == Some(0) && ran.stderr.contains("8 bits"), "{}", ran.stderr);
}

#[test]
fn a_motif_is_rendered_as_its_triangles_are() {
    let folder = with_out();
    folder.relief("motif mail --links 1 --detail 4 -o mail.glb").fine();
    // Not so deep that shells fold.
    let place = "--motif mail.glb --mesh torus --tile 12,4 --scale 0.05";
    folder.relief(&format!("mesh {place} -o forward.glb"));
    let look = "--eye 0.9,1.2,1.3 --target 0,0,0 --size 96x72 --samples 1 --backend cpu -q";
    folder.relief(&format!("render {place} {look} -o a.png --aov a.exr")).fine();
    folder.relief(&format!("render --mesh forward.glb {look} -o b.png --aov b.exr"));
    let [rays, triangles] = ["a.exr", "b.exr"].map(|name| Aov::read(&folder.path(name)));
    let [rays, triangles] = [&rays, &triangles].map(|aov| aov.plane("hit"));
    let seen = rays.iter().filter(|hit| **hit > 0.0).count();
    let other = rays.iter().zip(triangles).filter(|(a, b)| (**a > 0.0) != (**b > 0.0)).count();
    assert!(seen > 1_000 && other * 200 < rays.len(), "{seen} seen, {other} otherwise");
    // A scene file says the same.
    folder.write("a.toml", "motif = \"mail.glb\"\nmesh = \"torus\"\ntile = [12, 4]\nscale = 0.05\n");
    folder.relief(&format!("render a.toml {look} -o c.png")).fine();
    let [a, c] = ["a.png", "c.png"].map(|name| std::fs::read(folder.path(name)).expect("a picture"));
    assert!(a == c);
    // Vectors move a sheet, and are as long as a tile where no scale says more.
    let data = concat!(env!("CARGO_MANIFEST_DIR"), "/../../data/mushrooms.exr");
    let line = format!("render --motif {data} --mesh torus --tile 12,4 {look}");
    folder.relief(&format!("{line} -o d.png")).fine();
    folder.relief(&format!("{line} --axes tbn --scale 5cm -o e.png")).fine();
    let [d, e] = ["d.png", "e.png"].map(|name| std::fs::read(folder.path(name)).expect("a picture"));
    assert!(d != e);
}

#[test]
fn what_is_unusual_is_said() {
    let folder = with_out();
    folder.relief("motif grass --blades 4 -o grass.glb").fine();
    let ran = folder.relief("mesh --motif grass.glb --mesh plane --tile 2,2 -o out/a.glb");
    assert!(ran.code == Some(0) && !ran.stderr.contains("fold"), "{}", ran.stderr);
    let ran =
        folder.relief("mesh --motif grass.glb --mesh sphere --tile 8,4 --bias -1 --scale 3 -o out/b.glb");
    assert!(
        ran.code == Some(0) && ran.stderr.contains("fold") && ran.stderr.contains("--scale"),
        "{}",
        ran.stderr
    );
}

#[test]
fn what_cannot_be_a_motif_is_refused() {
    let folder = with_out();
    folder.relief("motif mail --detail 4 -o mail.glb").fine();
    folder.write("h.pgm", "P2 2 1 255 51 255");
    folder.relief("volume sponge --size 8x8x8 -o sponge.ktx2").fine();
    folder.write("cut.glb", &std::fs::read(folder.path("mail.glb")).expect("a file")[..300]);
    folder.write("v.exr", exr([2, 1], &[("R", vec![0.0; 2]), ("G", vec![0.0, 5.0]), ("B", vec![0.0; 2])]));
    folder.write("grey.exr", exr([2, 1], &["R", "G", "B"].map(|name| (name, vec![0.25, 0.5]))));
    let unit = [("R", vec![0.6, 0.0]), ("G", vec![0.0, 0.8]), ("B", vec![0.8, 0.6])];
    folder.write("normals.exr", exr([2, 1], &unit));
    let level = vec![0.0; 100 * 100];
    folder.write("wide.exr", exr([100, 100], &["R", "G", "B"].map(|name| (name, level.clone()))));
    folder.write("far.obj", "v 0 0.5 0\nv 99 0.5 0\nv 0 0.5 1\nf 1 2 3\n");
    folder.write("above.obj", "v 0 5 0\nv 1 5 0\nv 0 6 1\nf 1 2 3\n");
    for (line, code, words) in [
        ("mesh -o out/a.glb", 2, &["HEIGHT"][..]),
        ("mesh h.pgm --motif mail.glb -o out/a.glb", 2, &["--motif", "height map"]),
        ("mesh --motif no.glb -o out/a.glb", 1, &["no.glb"]),
        ("mesh --motif cut.glb -o out/a.glb", 1, &["cut.glb"]),
        ("mesh --motif h.pgm -o out/a.glb", 1, &["h.pgm"]),
        ("mesh --motif far.obj -o out/a.glb", 1, &["16 tiles"]),
        ("mesh --motif mail.glb --axes tbn -o out/a.glb", 2, &["--axes", "mail.glb"]),
        ("mesh h.pgm --axes tbn -o out/a.glb", 2, &["--axes", "--motif"]),
        ("mesh --motif grey.exr -o out/a.glb", 1, &["grey.exr", "height map", "--motif"]),
        ("mesh --motif normals.exr -o out/a.glb", 1, &["normals.exr", "normal map"]),
        ("mesh --motif out -o out/a.glb", 2, &["--motif", "folder"]),
        ("render --volume mail.glb -o out/a.png", 2, &["--volume", "relief volume"]),
        ("render --motif mail -o out/a.png", 2, &["relief motif mail"]),
        ("render --motif no.glb -o out/a.png", 1, &["no.glb"]),
        ("render --motif cut.glb -o out/a.png", 1, &["cut.glb"]),
        ("render --motif sponge.ktx2 -o out/a.png", 2, &["--motif", "--volume"]),
        ("render --motif far.obj -o out/a.png", 1, &["far.obj", "16 tiles"]),
        ("render --motif above.obj -o out/a.png", 1, &["above.obj", "heights"]),
        ("render --motif grey.exr -o out/a.png", 1, &["grey.exr", "height map", "--motif"]),
        ("render --motif h.pgm -o out/a.png", 1, &["h.pgm", "--motif"]),
        ("render --motif normals.exr -o out/a.png", 1, &["normals.exr", "normal map"]),
        ("render --motif v.exr --scale 9 -o out/a.png", 1, &["v.exr", "(1, 0)", "--scale"]),
        ("render --motif mail.glb --axes tbn -o out/a.png", 1, &["mail.glb", "--axes"]),
        ("render h.pgm --axes tbn -o out/a.png", 2, &["--motif"]),
        ("render h.pgm --motif mail.glb -o out/a.png", 2, &["h.pgm"]),
        ("render --height h.pgm --motif mail.glb -o out/a.png", 2, &["--motif"]),
        ("render --motif mail.glb --wrap clamp -o out/a.png", 2, &["wrap", "repeats"]),
        ("render --motif mail.glb --scale 0 -o out/a.png", 2, &["scale"]),
        ("render --motif mail.glb --normal h.pgm -o out/a.png", 2, &["normal"]),
        ("render --motif mail.glb --method relief -o out/a.png", 2, &["'shell-map'"]),
        ("render --motif mail.glb --method voxels -o out/a.png", 2, &["'shell-map'"]),
        ("render h.pgm --method shell-map -o out/a.png", 2, &["give a motif"]),
        ("render --motif mail.glb --surface prism -o out/a.png", 2, &["prism", "tetrahedra"]),
        ("render --motif mail.glb --refine binary -o out/a.png", 2, &["search"]),
        ("render --motif mail.glb --shadow horizon -o out/a.png", 2, &["horizon", "a motif"]),
        ("render --motif mail.glb --max-memory 1MiB -o out/a.png", 1, &["--max-memory"]),
        ("compare --motif mail.glb -o out/a.html", 1, &["a motif"]),
        ("explain --motif mail.glb -o out/a.svg", 2, &["a motif"]),
        ("mesh --motif v.exr --axes xyz -o out/a.glb", 2, &["--axes", "tnb"]),
        ("mesh --motif v.exr --scale 9 -o out/a.glb", 1, &["v.exr", "(1, 0)", "--scale"]),
        ("mesh --motif wide.exr --max-memory 1200KiB -o out/a.glb", 1, &["wide.exr", "--max-memory"]),
        ("mesh --motif mail -o out/a.glb", 2, &["relief motif mail"]),
        ("mesh --motif mail.ktx2 -o out/a.glb", 2, &["volume"]),
        ("mesh mail.glb --mesh torus -o out/a.glb", 2, &["mesh", "--motif"]),
        ("mesh --motif mail.glb --mesh far.obj -o out/a.glb", 1, &["texture coordinates", "--project"]),
        ("mesh --motif above.obj -o out/a.glb", 1, &["heights"]),
        ("mesh --motif mail.glb --error 1% -o out/a.glb", 2, &["--error"]),
        ("mesh --motif mail.glb --wrap clamp -o out/a.glb", 2, &["--wrap"]),
        ("mesh --motif mail.glb --scale 0 -o out/a.glb", 2, &["--scale"]),
        ("mesh --motif mail.glb --scale -0.1 -o out/a.glb", 2, &["--scale"]),
        ("mesh --motif mail.glb --tile 0,1 -o out/a.glb", 2, &["--tile"]),
        ("mesh --motif mail.glb --tile 900,900 -o out/a.glb", 1, &["tiles"]),
        (
            "mesh --motif mail.glb --mesh torus --tile 500,500 --max-memory 8MiB -o out/a.glb",
            1,
            &["triangles"],
        ),
        ("mesh --motif mail.glb --mesh nothing -o out/a.glb", 2, &["nothing"]),
        ("mesh --motif mail.glb -o out/a.txt", 2, &["--output"]),
        ("mesh --motif mail.glb -o mail.glb", 2, &["mail.glb"]),
    ] {
        assert_refused(&folder, &folder.relief(line), code, words);
    }
}
