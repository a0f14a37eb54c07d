//! `relief mesh --motif`: a closed mesh in the shells of another.

use std::f64::consts::TAU;

use crate::common::command::json_of;
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
    folder.write("cut.glb", &std::fs::read(folder.path("mail.glb")).expect("a file")[..300]);
    folder.write("far.obj", "v 0 0.5 0\nv 99 0.5 0\nv 0 0.5 1\nf 1 2 3\n");
    folder.write("above.obj", "v 0 5 0\nv 1 5 0\nv 0 6 1\nf 1 2 3\n");
    for (line, code, words) in [
        ("mesh -o out/a.glb", 2, &["HEIGHT"][..]),
        ("mesh h.pgm --motif mail.glb -o out/a.glb", 2, &["--motif", "height map"]),
        ("mesh --motif no.glb -o out/a.glb", 1, &["no.glb"]),
        ("mesh --motif cut.glb -o out/a.glb", 1, &["cut.glb"]),
        ("mesh --motif h.pgm -o out/a.glb", 1, &["h.pgm"]),
        ("mesh --motif far.obj -o out/a.glb", 1, &["16 tiles"]),
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
