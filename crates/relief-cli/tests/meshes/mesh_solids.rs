//! `relief mesh --solid`: closed by the numbers of its vertices in every format, also around holes,
//! and which way up a mesh stands.

use std::collections::HashMap;

use crate::common::command::{Folder, json_of};
use crate::common::files::exr;
use crate::common::maps::Map;
use crate::common::meshes::obj;
use crate::common::refused::{assert_refused, with_out};
use relief_core::mesh::{square, torus};
use serde_json::Value;

type Triangles = (Vec<[f32; 3]>, Vec<[u32; 3]>);

/// The positions and triangles of a file, by the numbers that it has; of an STL by equal positions.
fn of_file(folder: &Folder, name: &str, about: &Value) -> Triangles {
    let bytes = std::fs::read(folder.path(name)).expect("it was written");
    let [vertices, triangles] =
        ["vertices", "triangles"].map(|key| about[key].as_u64().expect("a count") as usize);
    let float = |at: usize| f32::from_le_bytes(bytes[at..at + 4].try_into().expect("four"));
    let point = |at: usize| [0, 4, 8].map(|k| float(at + k));
    let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four"));
    let corners = |at: usize| [0, 4, 8].map(|k| number(at + k));
    match name.rsplit_once('.').expect("an ending").1 {
        "glb" => {
            let first = bytes.len() - 48 * vertices - 12 * triangles;
            let faces = first + 48 * vertices;
            (
                (0..vertices).map(|at| point(first + 48 * at)).collect(),
                (0..triangles).map(|at| corners(faces + 12 * at)).collect(),
            )
        }
        "ply" => {
            let first = bytes.len() - 32 * vertices - 13 * triangles;
            let faces = first + 32 * vertices;
            (
                (0..vertices).map(|at| point(first + 32 * at)).collect(),
                (0..triangles).map(|at| corners(faces + 13 * at + 1)).collect(),
            )
        }
        "obj" => {
            let text = String::from_utf8(bytes).expect("a text");
            let numbers = |line: &str| -> Vec<f32> {
                let words = line.split(' ').skip(1).map(|word| word.split('/').next().unwrap_or(word));
                words.map(|word| word.parse().expect("a number")).collect()
            };
            let of = |start: &str| {
                let lines = text.lines().filter(|line| line.starts_with(start)).map(numbers);
                lines.map(|line| [line[0], line[1], line[2]]).collect::<Vec<[f32; 3]>>()
            };
            (of("v "), of("f ").into_iter().map(|face| face.map(|corner| corner as u32 - 1)).collect())
        }
        _ => {
            let (mut points, mut known) = (Vec::new(), HashMap::new());
            let mut corner = |at: usize| {
                let position = point(at);
                *known.entry(position.map(f32::to_bits)).or_insert_with(|| {
                    points.push(position);
                    points.len() as u32 - 1
                })
            };
            let faces = (0..triangles).map(|at| [96, 108, 120].map(|k| corner(50 * at + k))).collect();
            (points, faces)
        }
    }
}

/// The first vertex of a piece.
fn root(parent: &mut [u32], mut at: u32) -> u32 {
    while parent[at as usize] != at {
        parent[at as usize] = parent[parent[at as usize] as usize];
        at = parent[at as usize];
    }
    at
}

/// Whether each edge has two triangles that run opposite ways, by the numbers of vertices, each
/// vertex one ring of triangles, and the volume is positive; gives the volume and the number of
/// pieces.
fn closed(about: &str, (points, triangles): &Triangles) -> (f64, usize) {
    let mut sides: HashMap<[u32; 2], u32> = HashMap::new();
    for (number, corners) in triangles.iter().enumerate() {
        for k in 0..3 {
            let side = [corners[k], corners[(k + 1) % 3]];
            assert!(side[0] != side[1], "{about}: triangle {number} has a vertex twice");
            assert!(sides.insert(side, number as u32).is_none(), "{about}: {side:?} twice");
        }
    }
    for [a, b] in sides.keys() {
        assert!(sides.contains_key(&[*b, *a]), "{about}: {a} to {b} has one triangle");
    }
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    let at = |corner: u32| points[corner as usize].map(f64::from);
    let volume = triangles.iter().map(|&[a, b, c]| dot(at(a), cross(at(b), at(c))) / 6.0).sum::<f64>();
    assert!(volume > 0.0, "{about}: a volume of {volume}");
    // Pieces, by their vertices.
    let mut parent: Vec<u32> = (0..points.len() as u32).collect();
    for corners in triangles {
        for k in 1..3 {
            let [a, b] = [0, k].map(|k| root(&mut parent, corners[k]));
            parent[a as usize] = b;
        }
    }
    let mut roots: Vec<u32> = triangles.iter().map(|corners| root(&mut parent, corners[0])).collect();
    roots.sort_unstable();
    roots.dedup();
    (volume, roots.len())
}

const SIZE: [usize; 2] = [48, 36];

/// Returns a file of hills with holes in the mask.
fn island(folder: &Folder, name: &str, is_hole: impl Fn(usize, usize) -> bool) {
    let texels = (0..SIZE[0] * SIZE[1]).map(|at| {
        let [x, y] = [at % SIZE[0], at / SIZE[0]];
        let height = ((x as f32 / 7.0).sin() * (y as f32 / 5.0).cos() + 1.0) / 2.0;
        if is_hole(x, y) { f32::NAN } else { height }
    });
    folder.write(name, exr(SIZE.map(|side| side as u32), &[("Y", texels.collect())]));
}

type Mask = fn(usize, usize) -> bool;

fn disc([x, y]: [usize; 2], middle: [f64; 2], radius: f64) -> bool {
    (x as f64 - middle[0]).powi(2) + (y as f64 - middle[1]).powi(2) <= radius * radius
}

/// Outlines, and how many pieces the full grid has of each.
const OUTLINES: [(&str, Mask, Option<usize>); 7] = [
    ("disc", |x, y| !disc([x, y], [24.0, 18.0], 14.0), Some(1)),
    ("ring", |x, y| !disc([x, y], [24.0, 18.0], 16.0) || disc([x, y], [24.0, 18.0], 6.0), Some(1)),
    ("islands", |x, y| !(disc([x, y], [10.0, 10.0], 7.0) || disc([x, y], [34.0, 24.0], 9.0)), Some(2)),
    ("holes at the border", |x, y| x < 6 && y > 9 || x > 40 && y < 20, Some(1)),
    ("holes inside", |x, y| (x / 6 + y / 6) % 3 == 1 && x % 6 > 2 && y % 6 > 2, Some(1)),
    // Blocks of texels that touch at their corners.
    ("chessboard", |x, y| (x / 6 + y / 6) % 2 == 1, None),
    ("speckles", |x, y| (x * 7 + y * 13 + x * y) % 11 == 3, None),
];

#[test]
fn solids_are_cut_out_along_outlines_in_every_format() {
    let folder = with_out();
    for (name, mask, pieces) in OUTLINES {
        island(&folder, "island.exr", mask);
        for flags in ["--texels 1", "--error 1%", "--texels 3", "--triangles 9000"] {
            for ending in ["glb", "ply", "obj", "stl"] {
                if flags != "--texels 1" && ["ply", "obj"].contains(&ending) {
                    continue;
                }
                let output = format!("out/island.{ending}");
                let line = format!("mesh island.exr --holes --solid 3 --scale 0.1 {flags} -o {output}");
                let said = json_of(&folder.relief(&format!("{line} --json")).fine());
                let about = format!("{name} {flags} {ending}");
                assert_eq!(
                    (&said["open_edges"], &said["branching_edges"]),
                    (&0.into(), &0.into()),
                    "{about}"
                );
                let (volume, found) = closed(&about, &of_file(&folder, &output, &said));
                let cubed = if ending == "stl" { 1e9 } else { 1.0 };
                assert!((1e-4..0.2).contains(&(volume / cubed)), "{about}: {volume}");
                if flags == "--texels 1" {
                    assert!(pieces.is_none_or(|pieces| pieces == found), "{about}: {found} pieces");
                }
                if flags == "--triangles 9000" {
                    assert!(said["triangles"].as_u64() <= Some(9000), "{said}");
                }
            }
        }
    }
}

#[test]
fn parts_of_an_outline_are_closed_each() {
    let folder = with_out();
    island(&folder, "island.exr", OUTLINES[1].1);
    for flags in ["--texels 1", "--error 1%", "--shading mesh --lods 2", "--invert --bias 0"] {
        let tiles = if flags.contains("--shading") { "" } else { "--tiles 2x2" };
        let ending = if flags.contains("--lods") { "glb" } else { "stl" };
        let line =
            format!("mesh island.exr --holes --solid 3 --print-size 90 {flags} {tiles} -o out/a.{ending}");
        let said = json_of(&folder.relief(&format!("{line} --json")).fine());
        assert_eq!(said["open_edges"], 0, "{flags}");
        let mut least = f32::INFINITY;
        for file in said["files"].as_array().into_iter().flatten() {
            let name = file["output"].as_str().expect("a name").to_owned();
            let part = of_file(&folder, &name, file);
            closed(&name, &part);
            least = part.0.iter().fold(least, |least, point| least.min(point[2]));
        }
        assert!(tiles.is_empty() || least == 0.0, "{flags}: {least}");
    }
    folder.write("grid.obj", obj(&square(2).expect("a mesh")));
    for (line, words) in [
        ("--mesh grid.obj -o out/b.stl", ["--solid", "plane"]),
        ("--tiles 90x2 -o out/b.stl", ["--tiles", "texels"]),
        ("--max-memory 1MiB -o out/b.stl", ["--max-memory", "allowed"]),
    ] {
        let ran = folder.relief(&format!("mesh island.exr --holes --solid 3 --texels 1 {line}"));
        assert!(ran.code == Some(1) && words.iter().all(|word| ran.stderr.contains(word)), "{}", ran.stderr);
        assert!(!folder.path("out/b.stl").exists());
    }
}

/// Two triangles with a seam of the texture and a hard edge between them.
const SEAM: &str = "v 0 0 0\nv 0 0 1\nv 1 0 0\nv -1 0.5 0\nvt 0 0\nvt 0 1\nvt 1 0\nvt 0.5 0.5\n\
    f 1/1 2/2 3/3\nf 2/4 1/3 4/1\n";

#[test]
fn solids_share_their_vertices_in_every_format() {
    let folder = with_out();
    folder.write("hills.png", Map::many_hills().png());
    folder.write("seam.obj", SEAM);
    for (flags, most) in [
        ("--texels 4", 2.0),
        ("--error 1%", 2.0),
        ("--texels 4 --shading mesh", 2.0),
        ("--mesh seam.obj --texels 9 --print-size 500", 1.0),
        ("--mesh seam.obj --error 1% --base lift --print-size 500", 1.0),
        ("--mesh seam.obj --texels 9 --shading mesh --print-size 500", 1.0),
    ] {
        let mut volumes = Vec::new();
        for ending in ["glb", "ply", "obj", "stl"] {
            let output = format!("out/solid.{ending}");
            let line = format!("mesh hills.png --scale 0.05 --solid 9 {flags} -o {output} --json");
            let said = json_of(&folder.relief(&line).fine());
            let about = format!("{flags} {ending}");
            let solid = of_file(&folder, &output, &said);
            let (volume, pieces) = closed(&about, &solid);
            assert_eq!(pieces, 1, "{about}");
            // The number of vertices fits a closed surface without handles.
            let [vertices, triangles] = [solid.0.len(), solid.1.len()];
            assert_eq!(2 * vertices, triangles + 4, "{about}");
            assert!(volume < most * if ending == "stl" { 1e9 } else { 1.0 }, "{about}: {volume}");
            volumes.push(volume / if ending == "stl" { 1e9 } else { 1.0 });
        }
        assert!(volumes.iter().all(|volume| (volume / volumes[0] - 1.0).abs() < 1e-4), "{volumes:?}");
    }
}

fn least_and_greatest(points: &[[f32; 3]]) -> [[f32; 3]; 2] {
    let first = [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]];
    points.iter().fold(first, |[low, high], point| {
        [[0, 1, 2].map(|k| low[k].min(point[k])), [0, 1, 2].map(|k| high[k].max(point[k]))]
    })
}

#[test]
fn prints_lie_on_the_plate() {
    let folder = with_out();
    folder.write("hills.png", Map::many_hills().png());
    folder.write("seam.obj", SEAM);
    let made = |line: &str| {
        let said = json_of(&folder.relief(&format!("mesh {line} --json")).fine());
        let name = said["output"].as_str().expect("a name").to_owned();
        let [low, high] = least_and_greatest(&of_file(&folder, &name, &said).0);
        (low, [0, 1, 2].map(|k| high[k] - low[k]))
    };
    let print = "hills.png --print-size 150 --scale 0.05";
    for (line, up) in [
        (format!("{print} --solid 3 -o out/a.stl"), 2),
        (format!("{print} -o out/a.stl"), 2),
        (format!("{print} --solid 3 --up z -o out/a.stl"), 2),
        (format!("{print} --solid 3 --up y -o out/a.stl"), 1),
        ("hills.png --solid 3 --scale 0.05 --bias 0.3 -o out/a.stl".to_owned(), 2),
        ("hills.png --mesh seam.obj --print-size 90 --solid 3 --texels 9 -o out/a.stl".to_owned(), 2),
    ] {
        let (low, size) = made(&line);
        assert_eq!(low[up], 0.0, "{line}: {low:?}");
        if line.contains("150") {
            assert!((size[0] - 150.0).abs() < 1e-3 && size[up] < 15.0 && size[3 - up] > 30.0, "{size:?}");
        }
    }
    // A mesh that is not printed stays in place.
    let (low, size) = made("hills.png --scale 0.05 --bias 0.3 -o out/a.stl");
    assert!((299.0..350.0).contains(&low[2]) && size[2] < 51.0, "{low:?} {size:?}");
    for ending in ["ply", "obj"] {
        let (_, size) = made(&format!("hills.png --scale 0.05 -o out/a.{ending}"));
        assert!(size[1] < 0.051 && size[2] > 0.2, "{size:?}");
        let (_, size) = made(&format!("hills.png --scale 0.05 --up z -o out/a.{ending}"));
        assert!(size[2] < 0.051 && size[1] > 0.2, "{size:?}");
    }
}

#[test]
fn round_trips_keep_their_shape_whichever_way_is_up() {
    let folder = with_out();
    folder.write("level.png", Map::constant(0.5).png());
    folder.write("ring.obj", obj(&torus(32, 16).expect("a mesh")));
    let bounds = |line: &str| {
        let said = json_of(&folder.relief(&format!("inspect {line} --json")).fine());
        let corners = said["bounds_m"].as_array().expect("two").clone();
        corners
            .iter()
            .flat_map(|corner| corner.as_array().expect("three").clone())
            .map(|number| number.as_f64().expect("a number"))
            .collect::<Vec<f64>>()
    };
    let original = bounds("ring.obj");
    let differs = |line: &str| {
        let found = bounds(line);
        found.iter().zip(&original).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    for ending in ["glb", "ply", "obj", "stl"] {
        for up in ["", "--up y", "--up z"] {
            if ending == "glb" && up == "--up z" {
                continue;
            }
            let project = if ending == "stl" { "--project box" } else { "" };
            folder
                .relief(&format!(
                    "mesh level.png --mesh ring.obj --scale 0.01 --bias -0.005 {up} -o out/r.{ending}"
                ))
                .fine();
            let off = differs(&format!("out/r.{ending} {project}"));
            assert!(off < 1e-3, "{ending} {up}: {off}");
            // Once more, as a base.
            let line = format!(
                "mesh level.png --mesh out/r.{ending} {project} --scale 0.01 --bias -0.005 -o out/s.glb"
            );
            folder.relief(&line).fine();
            let off = differs("out/s.glb");
            assert!(off < 2e-3, "{ending} {up}: {off}");
        }
    }
    // The file states its up axis; the flag overrides it.
    let line =
        "mesh level.png --mesh out/r.stl --project box --scale 0.01 --bias -0.005 --mesh-up y -o out/s.glb";
    folder.relief(line).fine();
    assert!(differs("out/s.glb") > 0.1);
    assert!(differs("out/r.stl --project box --mesh-up y") > 0.1);
    for (line, code, words) in [
        ("level.png --up z -o out/a.glb", 2, ["--up", "glTF"]),
        ("level.png --up x -o out/a.ply", 2, ["--up", "z"]),
        ("level.png --mesh-up z -o out/a.ply", 2, ["--mesh-up", "--mesh"]),
        ("level.png --mesh out/r.stl --mesh-up north -o out/a.ply", 2, ["--mesh-up", "y"]),
    ] {
        let ran = folder.relief(&format!("mesh {line}"));
        assert!(
            ran.code == Some(code) && words.iter().all(|word| ran.stderr.contains(word)),
            "{}",
            ran.stderr
        );
    }
    std::fs::remove_dir_all(folder.path("out")).expect("it is there");
    std::fs::create_dir(folder.path("out")).expect("it is writable");
    assert_refused(&folder, &folder.relief("mesh level.png --up z -o out/a.glb"), 2, &["--up"]);
}
