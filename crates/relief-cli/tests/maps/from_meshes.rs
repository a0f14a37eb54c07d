//! `relief height from-meshes`: the heights of a displaced mesh come back, and are shown without
//! flags.

use std::process::Stdio;
use std::time::Duration;

use crate::common::aov::Aov;
use crate::common::command::{Folder, json_of};
use crate::common::maps::Map;
use crate::common::meshes::obj;
use crate::common::refused::{OUT, assert_refused, entries, with_out};
use glam::Vec3;
use relief_core::mesh::{Mesh, torus};
use relief_io::{MeshOptions, read_height, read_mesh};

/// A folder with a coarse torus, a map of hills, and the torus displaced by it as a scan: without
/// texture coordinates.
fn folder() -> Folder {
    let folder = with_out();
    folder.write("ring.obj", obj(&torus(24, 16).expect("a mesh")));
    folder.write("hills.png", Map::many_hills().png());
    folder.relief("mesh hills.png --mesh ring.obj --scale 0.04 --bias -0.01 -o made.glb").fine();
    let scan: String = obj(&mesh(&folder, "made.glb"))
        .lines()
        .filter(|line| !line.starts_with("vt") && !line.starts_with("vn"))
        .map(|line| {
            line.split(' ').map(|word| word.split('/').next().unwrap_or(word)).collect::<Vec<_>>().join(" ")
                + "\n"
        })
        .collect();
    folder.write("scan.obj", scan);
    folder
}

fn mesh(folder: &Folder, name: &str) -> Mesh {
    read_mesh(&folder.path(name), &MeshOptions::default()).expect("a mesh").mesh
}

/// Returns the vertices of the ring displaced by a map without flags.
fn shown(folder: &Folder, map: &str) -> Vec<Vec3> {
    folder.relief(&format!("mesh {map} --mesh ring.obj -o shown.glb")).fine();
    mesh(folder, "shown.glb").vertices().iter().map(|vertex| vertex.position).collect()
}

/// Returns the greatest distance in metres between points of two lists.
fn furthest(a: &[Vec3], b: &[Vec3]) -> f32 {
    assert_eq!(a.len(), b.len());
    a.iter().zip(b).map(|(a, b)| (*a - *b).length()).fold(0.0, f32::max)
}

#[test]
fn a_map_comes_back_and_is_shown_without_flags() {
    let folder = folder();
    let made: Vec<Vec3> = mesh(&folder, "made.glb").vertices().iter().map(|vertex| vertex.position).collect();
    let size = read_height(&folder.path("hills.png"), &Default::default()).expect("a map");
    let size = format!("{}x{}", size.width(), size.height());
    for name in ["back.exr", "back.png"] {
        let line = format!("height from-meshes --low ring.obj --high scan.obj --size {size} -o {name}");
        let about = json_of(&folder.relief(&format!("{line} --json")).fine());
        let number = |key: &str| about[key].as_f64().unwrap_or_else(|| panic!("{key}: {about}"));
        assert_eq!((about["holes"].as_u64(), about["overlaps"].as_u64()), (Some(0), Some(0)), "{about}");
        assert_eq!(number("covered"), number("width") * number("height"));
        assert!(number("least_m") > -0.0101 && number("greatest_m") < 0.0301 && number("scale_m") > 0.03);
        assert!(number("mean_abs_m") > 0.001 && number("cage_m") > 0.1);
        let apart = furthest(&made, &shown(&folder, name));
        println!("{name}: {apart:.1e} m");
        // A texel is 4 to 10 mm wide.
        assert!(apart < 3e-4, "{name}: {apart}");
        let text = folder.relief(&line).fine().stdout;
        assert!(text.contains("100.000 %") && text.contains("as the file says"), "{text}");
    }
    // Other flags, and the bias alone, override it.
    for flags in ["--scale 0.01", "--bias 0.05", "--scale 0.04 --bias 0"] {
        folder.relief(&format!("mesh back.exr --mesh ring.obj {flags} -o other.glb")).fine();
        let other: Vec<Vec3> =
            mesh(&folder, "other.glb").vertices().iter().map(|vertex| vertex.position).collect();
        assert!(furthest(&made, &other) > 5e-3, "{flags}");
    }
    // A level map is displaced, too, by its bias.
    folder.relief("mesh hills.png --mesh ring.obj --scale 0 --bias 0.02 -o made.glb").fine();
    folder
        .relief("height from-meshes --low ring.obj --high made.glb --size 64x32 --wrap mirror -o level.exr")
        .fine();
    let made: Vec<Vec3> = mesh(&folder, "made.glb").vertices().iter().map(|vertex| vertex.position).collect();
    folder.relief("mesh hills.png --mesh ring.obj --scale 0 --bias 0 -o flat.glb").fine();
    let flat: Vec<Vec3> = mesh(&folder, "flat.glb").vertices().iter().map(|vertex| vertex.position).collect();
    assert!(furthest(&made, &flat) > 0.018);
    let level = read_height(&folder.path("level.exr"), &Default::default()).expect("a map");
    assert!((level.bias_m() - 0.02).abs() < 1e-6 && level.scale_m() < 1e-6, "{level:?}");
}

#[test]
fn a_picture_of_both_is_the_same() {
    let folder = folder();
    folder
        .relief(
            "height from-meshes --low ring.obj --high made.glb --size 256x256 --normals n.png -o back.exr",
        )
        .fine();
    folder.write("level.png", Map::constant(0.5).png());
    let look = "--eye 0.5,0.8,1 --target 0,0,0 --size 160x120 --samples 1 --backend cpu -o p.png --aov";
    let of_aov = |name: &str, flags: &str| {
        let ran = folder.relief(&format!("render {look} {name} {flags}")).fine();
        (Aov::read(&folder.path(name)), ran.stdout)
    };
    let (truth, _) = of_aov("truth.exr", "--height level.png --scale 0 --bias 0 --mesh made.glb");
    let (shown, said) = of_aov("shown.exr", "--height back.exr --mesh ring.obj --surface prism");
    let (lit, _) = of_aov("lit.exr", "--height back.exr --normal n.png --mesh ring.obj --surface prism");
    let (flat, _) = of_aov("flat.exr", "--height level.png --scale 0 --bias 0 --mesh ring.obj");
    assert!(said.contains("bias -0.0") && said.contains("file states"), "{said}");
    let apart = |of: &Aov| {
        let pairs = truth.pixels().zip(of.pixels());
        let both = pairs.filter(|((_, _, a), (_, _, b))| a.hit == 1.0 && b.hit == 1.0);
        let mut apart: Vec<f64> =
            both.map(|((_, _, a), (_, _, b))| (a.position - b.position).length()).collect();
        apart.sort_by(f64::total_cmp);
        assert!(apart.len() > 3000, "{}", apart.len());
        apart[apart.len() * 9 / 10]
    };
    let heights = shown;
    let [shown, flat] = [apart(&heights), apart(&flat)];
    println!("{shown:.1e} m, without the map {flat:.1e} m");
    assert!(shown < 1e-3 && flat > 10.0 * shown, "{shown} {flat}");
    // Normals of the heights bend with the mesh's own. The normal map has the detailed mesh's
    // normals.
    let turned = |of: &Aov| {
        let pairs = truth.pixels().zip(of.pixels());
        let both = pairs.filter(|((_, _, a), (_, _, b))| {
            a.hit == 1.0 && b.hit == 1.0 && (a.position - b.position).length() < 2e-3
        });
        let mut angles: Vec<f64> =
            both.map(|((_, _, a), (_, _, b))| a.normal.angle_between(b.normal).to_degrees()).collect();
        angles.sort_by(f64::total_cmp);
        assert!(angles.len() > 3000, "{}", angles.len());
        angles[angles.len() * 9 / 10]
    };
    let [lit, derived] = [turned(&lit), turned(&heights)];
    println!("normals {lit:.2} degrees, of the heights {derived:.2} degrees");
    assert!(lit < 1.0 && derived > 4.0 * lit, "{lit} {derived}");
}

#[test]
fn what_a_map_cannot_hold_is_said() {
    let folder = folder();
    // All sides of a cube lie on the whole map.
    let ran =
        folder.relief("height from-meshes --low cube --high cube --size 16x16 --wrap clamp -o out/c.png");
    assert!(ran.code == Some(0) && ran.stderr.contains("cube: 240 texels (93.750 %)"), "{}", ran.stderr);
    assert!(ran.stdout.contains("--wrap clamp"), "{}", ran.stdout);
    // A narrow cage finds only a part.
    let line = "height from-meshes --low ring.obj --high scan.obj --size 64x64 --cage 5mm -o out/h.exr";
    let about = json_of(&folder.relief(&format!("{line} --json")).fine());
    let [holes, covered] = ["holes", "covered"].map(|key| about[key].as_u64().expect("a number"));
    assert!(holes > 100 && holes < covered, "{about}");
    assert!(folder.relief(line).fine().stdout.contains("have no hit within 0.005 m"));
    // A gutter leaves texels without a value, which are seen.
    folder.write(
        "part.obj",
        "v -1 0 -1\nv -1 0 1\nv 1 0 1\nvt 0.2 0.8\nvt 0.2 0.3\nvt 0.7 0.3\nf 1/1 2/2 3/3\n",
    );
    let line =
        "height from-meshes --low part.obj --high part.obj --size 32x32 --gutter 2 --json -o out/g.exr";
    let about = json_of(&folder.relief(line).fine());
    assert!(about["without_value"].as_u64().is_some_and(|count| count > 500), "{about}");
    let ran = folder.relief("mesh out/g.exr --mesh part.obj -o out/p.glb");
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
}

#[test]
fn what_cannot_be_made_is_refused() {
    let folder = folder();
    for (name, text) in [
        ("bare.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nf 1 2 3\n"),
        ("line.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nvt 0 0\nvt 1 1\nvt 0.5 0.5\nf 1/1 2/2 3/3\n"),
        ("speck.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nvt 0 0\nvt 0 1e-5\nvt 1e-5 0\nf 1/1 2/2 3/3\n"),
        ("tiled.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nvt 0 0\nvt 0 99\nvt 99 0\nf 1/1 2/2 3/3\n"),
        ("empty.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\n"),
        ("nan.obj", "v 0 0 0\nv 0 nan 1\nv 1 0 0\nf 1 2 3\n"),
        ("vast.obj", "v 0 0 0\nv 0 1e30 1\nv 1 0 0\nf 1 2 3\n"),
        ("far.obj", "v 90 0 0\nv 90 0 1\nv 91 0 0\nf 1 2 3\n"),
        ("cut.glb", "glTF"),
    ] {
        folder.write(name, text);
    }
    // The scan with its corners the other way round.
    let scan = std::fs::read_to_string(folder.path("scan.obj")).expect("it was written");
    let turned = scan.lines().map(|line| match line.strip_prefix("f ") {
        Some(corners) => format!("f {}\n", corners.split(' ').rev().collect::<Vec<_>>().join(" ")),
        None => format!("{line}\n"),
    });
    folder.write("inside.obj", turned.collect::<String>());
    let pair = "--low ring.obj --high scan.obj";
    let table: &[(i32, &str, &[&str])] = &[
        (2, "--high scan.obj --size 8x8 -o out/h.exr", &["--low"]),
        (2, "--low ring.obj --size 8x8 -o out/h.exr", &["--high"]),
        (2, "{} -o out/h.exr", &["--size"]),
        (2, "{} --size 8x8", &["--output"]),
        (2, "{} --size 8 -o out/h.exr", &["--size", "800x600"]),
        (2, "{} --size 0x8 -o out/h.exr", &["0x8"]),
        (2, "{} --size -8x8 -o out/h.exr", &["--size"]),
        (2, "{} --size 4000000x2 -o out/h.exr", &["--size", "4000000x2", "too large"]),
        (1, "{} --size 60000x17000 -o out/h.exr", &["60000x17000", "--max-memory"]),
        (2, "{} --size 8x8 --cage 0 -o out/h.exr", &["--cage", "above 0"]),
        (2, "{} --size 8x8 --cage -1cm -o out/h.exr", &["--cage", "above 0"]),
        (2, "{} --size 8x8 --cage nan -o out/h.exr", &["--cage", "finite"]),
        (2, "{} --size 8x8 --cage inf -o out/h.exr", &["--cage", "finite"]),
        (2, "{} --size 8x8 --cage 5cn -o out/h.exr", &["--cage", "cm"]),
        (2, "{} --size 8x8 --layer outer -o out/h.exr", &["--layer", "outermost"]),
        (2, "{} --size 8x8 --wrap repaet -o out/h.exr", &["--wrap", "repeat"]),
        (2, "{} --size 8x8 --gutter -1 -o out/h.exr", &["--gutter"]),
        (2, "{} --size 8x8 --gutter 1 -o out/h.png", &["PNG", "EXR"]),
        (2, "{} --size 8x8 -o out/h.tiff", &["--output", "exr"]),
        (2, "{} --size 8x8 -o out/h", &["--output", ".png"]),
        (1, "{} --size 8x8 -o nowhere/h.exr", &["nowhere"]),
        (2, "{} --size 8x8 --normals out/h.exr -o out/h.exr", &["out/h.exr", "two outputs"]),
        (2, "{} --size 8x8 --normals out/n.jpg -o out/h.exr", &["--normals", "png"]),
        (1, "{} --size 8x8 --normals nowhere/n.png -o out/h.exr", &["nowhere"]),
        (1, "--low ring.obj --high nan.obj --normals out/n.png --size 8x8 -o out/h.exr", &["nan.obj"]),
        (1, "{} --size 8x8 --max-memory 1MiB -o out/h.exr", &["--max-memory"]),
        (2, "--low rnig.obj --high sphree --size 8x8 -o out/h.exr", &["sphree", "sphere"]),
        (1, "--low rnig.obj --high scan.obj --size 8x8 -o out/h.exr", &["rnig.obj"]),
        (1, "--low ring.obj --high none.ply --size 8x8 -o out/h.exr", &["none.ply"]),
        (1, "--low bare.obj --high scan.obj --size 8x8 -o out/h.exr", &["bare.obj", "texture", "unwrap"]),
        (1, "--low line.obj --high scan.obj --size 8x8 -o out/h.exr", &["line.obj", "no area"]),
        (1, "--low speck.obj --high scan.obj --size 3x3 -o out/h.exr", &["speck.obj", "too small"]),
        (1, "--low tiled.obj --high scan.obj --size 8x8 -o out/h.exr", &["tiled.obj", "99 tiles"]),
        (1, "--low tiled.obj --high scan.obj --size 8x8 --wrap clamp -o out/h.exr", &["outside", "--wrap"]),
        (1, "--low ring.obj --high empty.obj --size 8x8 -o out/h.exr", &["empty.obj", "faces"]),
        (1, "--low empty.obj --high scan.obj --size 8x8 -o out/h.exr", &["empty.obj", "faces"]),
        (1, "--low ring.obj --high nan.obj --size 8x8 -o out/h.exr", &["nan.obj"]),
        (1, "--low ring.obj --high vast.obj --size 8x8 -o out/h.exr", &["vast.obj", "1e9"]),
        (1, "--low ring.obj --high cut.glb --size 8x8 -o out/h.exr", &["cut.glb"]),
        (2, "--low ring.obj --high hills.png --size 8x8 -o out/h.exr", &["hills.png", ".glb"]),
        (1, "--low ring.obj --high far.obj --size 8x8 -o out/h.exr", &["same unit", "--cage"]),
        (1, "--low ring.obj --high inside.obj --size 8x8 -o out/h.exr", &["other way", "--two-sided"]),
        (2, "--low ring.glb --high scan.obj --size 8x8 -o ring.obj", &["ring.obj"]),
    ];
    for (code, line, words) in table {
        let line = line.replace("{}", pair);
        assert_refused(&folder, &folder.relief(&format!("height from-meshes {line}")), *code, words);
    }
    // A folder is no output.
    folder.write("map.png/inside", []);
    let ran = folder.relief(&format!("height from-meshes {pair} --size 8x8 -o map.png"));
    assert_refused(&folder, &ran, 1, &["map.png", "folder"]);
    let ran =
        folder.relief("height from-meshes --low ring.obj --high inside.obj --size 8x8 --two-sided -o b.png");
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
}

#[test]
fn an_interrupt_leaves_nothing_or_a_whole_file() {
    let folder = folder();
    for wait_ms in [0, 200, 600] {
        let line = "height from-meshes --low ring.obj --high scan.obj --size 4096x3000 -o out/h.exr";
        let mut command = folder.command();
        command.args(line.split(' ')).stdout(Stdio::null()).stderr(Stdio::null());
        let mut child = command.spawn().expect("the command starts");
        std::thread::sleep(Duration::from_millis(wait_ms));
        let pid = child.id().to_string();
        let kill = std::process::Command::new("kill").args(["-INT", &pid]).stderr(Stdio::null()).status();
        kill.expect("kill is there");
        let status = child.wait().expect("the command ends");
        let left = entries(&folder.path(OUT));
        assert_eq!(left, if status.success() { vec!["h.exr".to_owned()] } else { Vec::new() }, "{status}");
        assert!(!status.success() || std::fs::remove_file(folder.path("out/h.exr")).is_ok());
    }
}
