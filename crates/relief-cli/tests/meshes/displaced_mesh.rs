//! `relief mesh`: its triangles are the relief that is rendered, in every format, whole or not at
//! all.

use crate::common::aov::Aov;
use crate::common::command::{Folder, Ran, json_of};
use crate::common::files::exr;
use crate::common::maps::Map;
use crate::common::meshes::obj;
use crate::common::refused::{assert_refused, entries, with_out};
use relief_core::mesh::torus;
use serde_json::Value;

/// A folder with a map of hills, a level one, and a torus.
fn folder() -> Folder {
    let folder = with_out();
    folder.write("hills.png", Map::many_hills().png());
    folder.write("level.png", Map::constant(0.0).png());
    folder.write("ring.obj", obj(&torus(32, 16).expect("a mesh")));
    folder
}

/// Corners of triangles in an OBJ.
const CORNERS: &str = "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 0 -1\nv -1 0 0\nv 1 1 0\n\
    vt 0 0\nvt 0 1\nvt 1 0\nvt 0.5 0.5\n";

/// Returns two triangles with a seam between them.
const SEAM: &str = "f 1/1 2/2 3/3\nf 2/4 1/3 5/1\n";

#[test]
fn every_format_holds_the_mesh_that_is_answered() {
    let folder = folder();
    for (ending, format) in [("glb", "glTF"), ("ply", "PLY"), ("obj", "OBJ"), ("stl", "STL")] {
        let output = format!("out/ring.{ending}");
        let line = format!("mesh hills.png --mesh ring.obj --scale 3cm --bias 0 --texels 3 -o {output}");
        let about = json_of(&folder.relief(&format!("{line} --json")).fine());
        let number = |name: &str| about[name].as_u64().unwrap_or_else(|| panic!("{name}: {about}"));
        assert_eq!((number("open_edges"), number("branching_edges"), number("pieces")), (0, 0, 1));
        assert_eq!(about["format"], format);
        assert_eq!((about["scale_m"].as_f64(), about["bias_m"].as_f64()), (Some(0.03), Some(0.0)));
        let written = std::fs::metadata(folder.path(&output)).expect("it was written").len();
        assert_eq!(number("bytes"), written);
        let project = if ending == "stl" { "--project box" } else { "" };
        let found = json_of(&folder.relief(&format!("inspect {output} {project} --json")).fine());
        assert_eq!(found["triangles"].as_u64(), Some(number("triangles")), "{found}");
        assert_eq!(found["open_edges"].as_u64(), Some(0), "{found}");
        // In words, too.
        let text = folder.relief(&line).fine().stdout;
        assert!(text.contains("closed") && text.contains(&output), "{text}");
        let longest = about["size_m"].as_array().expect("three").iter().filter_map(Value::as_f64);
        let unit = if longest.fold(0.0, f64::max) < 1.0 { " mm, " } else { " m, " };
        assert!(text.contains(unit), "{text}");
        let up = if ending == "stl" { ", z up\n" } else { ", y up\n" };
        assert!(text.contains(up), "{text}");
    }
    assert_eq!(entries(&folder.path("out")).len(), 4);
}

#[test]
fn the_mesh_is_where_the_relief_is_rendered() {
    let folder = folder();
    let look = "--eye 0.5,0.8,1 --target 0,0,0 --size 200x150 --samples 1 --backend cpu -o p.png";
    for (mesh, base) in [("ring.obj", "flat"), ("ring.obj", "lift"), ("plane", "flat")] {
        let place = format!("--mesh {mesh} --scale 0.04 --bias -0.01");
        let lift = if base == "lift" { "--set surface.lift=1" } else { "" };
        folder
            .relief(&format!("render --height hills.png {place} --surface prism {lift} {look} --aov a.exr"))
            .fine();
        folder.relief(&format!("mesh hills.png {place} --base {base} -o out/made.glb")).fine();
        let made = "--height level.png --mesh out/made.glb --scale 0 --bias 0 --method bump --two-sided";
        folder.relief(&format!("render {made} {look} --aov b.exr")).fine();
        let [truth, found] = ["a.exr", "b.exr"].map(|name| Aov::read(&folder.path(name)));
        let pairs = || truth.pixels().zip(found.pixels());
        let both = pairs().filter(|((_, _, a), (_, _, b))| a.hit == 1.0 && b.hit == 1.0);
        let (mut distances, mut angles) = (Vec::new(), Vec::new());
        for ((_, _, a), (_, _, b)) in both {
            distances.push((a.position - b.position).length());
            angles.push(a.normal.angle_between(b.normal).to_degrees());
        }
        let other = pairs().filter(|((_, _, a), (_, _, b))| a.hit != b.hit).count();
        [&mut distances, &mut angles].into_iter().for_each(|all| all.sort_by(f64::total_cmp));
        let at = distances.len() * 9 / 10;
        println!(
            "{mesh} {base}: {} m, {} degrees, {other} of {}",
            distances[at],
            angles[at],
            distances.len()
        );
        assert!(distances.len() > 2000 && other * 50 < distances.len(), "{mesh} {base}: {other}");
        assert!(distances[at] < 1e-3 && angles[at] < 4.0, "{mesh} {base}: {} {}", distances[at], angles[at]);
    }
}

#[test]
fn sizes_inversion_and_threads() {
    let folder = folder();
    let bytes = |name: &str| std::fs::read(folder.path(name)).expect("it was written");
    let made = |flags: &str, name: &str| {
        json_of(&folder.relief(&format!("mesh hills.png --texels 2 {flags} --json -o {name}")).fine())
    };
    let printed = made("--mesh ring.obj --print-size 120", "out/a.stl");
    let longest = printed["size_m"].as_array().expect("three").iter().filter_map(Value::as_f64);
    assert!((longest.fold(0.0, f64::max) - 0.12).abs() < 1e-6, "{printed}");
    made("--mesh ring.obj --print-size 12cm --threads 1", "out/b.stl");
    assert_eq!(bytes("out/a.stl"), bytes("out/b.stl"));
    made("--invert", "out/a.ply");
    made("--depth", "out/b.ply");
    made("", "out/c.ply");
    assert_eq!(bytes("out/a.ply"), bytes("out/b.ply"));
    assert_ne!(bytes("out/a.ply"), bytes("out/c.ply"));
    made("--shading mesh", "out/d.ply");
    assert_ne!(bytes("out/c.ply"), bytes("out/d.ply"));
    // Strips hold the same triangles in fewer bytes.
    let strips = made("--strips --lods 2 --quantize 12", "out/strips.glb");
    let lists = made("--lods 2 --quantize 12", "out/lists.glb");
    assert!(strips["bytes"].as_u64() < lists["bytes"].as_u64(), "{strips}");
    assert!(strips["strips"]["per_triangle"].as_f64().is_some_and(|count| (1.0..1.1).contains(&count)));
    let read = |name: &str| json_of(&folder.relief(&format!("inspect {name} --json")).fine());
    let [strips, lists] = ["out/strips.glb", "out/lists.glb"].map(read);
    assert_eq!(strips["triangles"], lists["triangles"]);
    assert!(strips["left_out"].is_object() && strips["left_out"] == lists["left_out"], "{strips}");
    // Elevation models need no more words: a sheet with the border of a sheet.
    let sheet = made("", "out/e.glb");
    assert_eq!(sheet["open_edges"].as_u64(), Some(2 * (129 + 65)), "{sheet}");
    // Through a pipe.
    let mut command = folder.command();
    command.args(["mesh", "hills.png", "--texels", "2", "-o", "-", "--format", "ply"]);
    assert_eq!(command.output().expect("the command starts").stdout, bytes("out/c.ply"));
}

#[test]
fn what_cannot_be_made_is_refused() {
    let folder = folder();
    folder.write("bare.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nf 1 2 3\n");
    folder.write("flat.obj", "v 0 0 0\nv 0 0 1\nv 0 0 2\nvt 0 0\nvt 0 1\nvt 1 0\nf 1/1 2/2 3/3\n");
    folder.write("nan.obj", "v 0 0 nan\nv 0 0 1\nv 1 0 0\nvt 0 0\nvt 0 1\nvt 1 0\nf 1/1 2/2 3/3\n");
    folder.write("point.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nvt 0 0\nvt 0 0\nvt 0 0\nf 1/1 2/2 3/3\n");
    // Two that face opposite ways, two that touch in a corner, and two with a seam between them.
    let corners = CORNERS;
    folder.write("fold.obj", format!("{corners}f 1/1 2/2 3/3\nf 1/1 2/2 6/4\n"));
    folder.write("touch.obj", format!("{corners}f 1/1 2/2 3/3\nf 1/1 4/2 5/3\n"));
    folder.write("seam.obj", format!("{corners}{SEAM}"));
    folder.write("nan.exr", exr([2, 1], &[("Y", vec![f32::NAN, 1.0])]));
    folder.write("eye.toml", "height = 'hills.png'\neye = [0, 0, 0]\ntarget = [0, 0, 0]\n");
    folder.write("view.toml", "height = 'hills.png'\neye = [0.3, 0.6, 1]\nsize = [320, 240]\n");
    folder.write("broken.png", b"\x89PNG\r\n\x1a\nno more");
    for (line, code, words) in [
        ("hills.png --texels 0 -o out/a.glb", 2, ["--texels", "0"]),
        ("hills.png --texels -1 -o out/a.glb", 2, ["--texels", "-1"]),
        ("hills.png --texels two -o out/a.glb", 2, ["--texels", "two"]),
        ("hills.png --edges texel -o out/a.glb", 2, ["texel", "texels"]),
        ("hills.png --interior dise -o out/a.glb", 2, ["dise", "dice"]),
        ("hills.png --base lft -o out/a.glb", 2, ["lft", "lift"]),
        ("hills.png --directions rw -o out/a.glb", 2, ["rw", "raw"]),
        ("hills.png --seams wedl -o out/a.glb", 2, ["wedl", "weld"]),
        ("hills.png --shading exat -o out/a.glb", 2, ["exat", "exact"]),
        ("hills.png --mesh rung -o out/a.glb", 2, ["rung", "torus"]),
        ("hills.png --error 0 -o out/a.glb", 2, ["--error", "0"]),
        ("hills.png --error -1mm -o out/a.glb", 2, ["--error", "-1mm"]),
        ("hills.png --error nan% -o out/a.glb", 2, ["--error", "nan"]),
        ("hills.png --error fine -o out/a.glb", 2, ["--error", "1%"]),
        ("hills.png --error 1e-9% -o out/a.glb", 1, ["--error", "possible"]),
        ("hills.png --error 1% --texels 2 -o out/a.glb", 2, ["--error", "--texels"]),
        ("hills.png --error 1% --edges texels -o out/a.glb", 2, ["--error", "texels"]),
        ("hills.png --texels 2 --edges error -o out/a.glb", 2, ["--texels", "error"]),
        (
            "hills.png --error 1% --mesh ring.obj --scale 60cm --side above -o out/a.glb",
            1,
            ["--side", "--scale"],
        ),
        (
            "hills.png --error 1% --mesh ring.obj --side above --base pn -o out/a.glb",
            1,
            ["one side", "cubic"],
        ),
        ("hills.png --error 1% --mesh cube --directions angle -o out/a.glb", 1, ["angle", "--texels"]),
        ("hills.png --edges error --interior dice -o out/a.glb", 2, ["dice", "evenly"]),
        ("hills.png --tile 9,9 --error 0.1% --max-memory 40MiB -o out/a.glb", 1, ["--max-memory", "--error"]),
        ("hills.png --triangles 0 -o out/a.glb", 2, ["--triangles", "0"]),
        ("hills.png --triangles 1 -o out/a.glb", 1, ["--triangles", "more than 1"]),
        ("hills.png --triangles 9 --error 1% -o out/a.glb", 2, ["--triangles", "--error"]),
        ("hills.png --judge texel -o out/a.glb", 2, ["texel", "texels"]),
        ("hills.png --fit hights -o out/a.glb", 2, ["hights", "heights"]),
        ("hills.png --side up -o out/a.glb", 2, ["up", "above"]),
        ("hills.png --side above --mesh cube -o out/a.glb", 1, ["--side", "--seams"]),
        ("hills.png --texels 2 --judge texels -o out/a.glb", 2, ["--judge", "--texels"]),
        ("hills.png --texels 2 --fit none -o out/a.glb", 2, ["--fit", "--texels"]),
        ("hills.png --edges pixels -o out/a.glb", 2, ["pixels", "--view"]),
        ("hills.png --interior sweep -o out/a.glb", 2, ["pixels", "--view"]),
        ("hills.png --edges texels --interior sweep -o out/a.glb", 2, ["sweep", "voxel"]),
        ("hills.png --view none.toml -o out/a.glb", 1, ["none.toml", ""]),
        ("hills.png --view hills.png -o out/a.glb", 1, ["hills.png", ""]),
        ("hills.png --view eye.toml -o out/a.glb", 1, ["eye", "target"]),
        ("hills.png --view view.toml --pixels 0 -o out/a.glb", 2, ["--pixels", "0"]),
        ("hills.png --view view.toml --pixels few -o out/a.glb", 2, ["--pixels", "few"]),
        ("hills.png --view view.toml --level-filter avrage -o out/a.glb", 2, ["avrage", "average"]),
        ("hills.png --weights 1,0,0 -o out/a.glb", 2, ["--weights", "--view"]),
        ("hills.png --view view.toml --weights 1,0 -o out/a.glb", 2, ["--weights", "X,Y,Z"]),
        ("hills.png --view view.toml --weights 2,0,0 -o out/a.glb", 2, ["--weights", "from 0 to 1"]),
        ("hills.png --view view.toml --weights 0,-1,0 -o out/a.glb", 2, ["--weights", "at least 0"]),
        (
            "hills.png --view view.toml --weights 0,1,0 --interior sweep -o out/a.glb",
            2,
            ["--weights", "sweep"],
        ),
        ("hills.png --level-filter max -o out/a.glb", 2, ["--level-filter", "--view"]),
        ("hills.png --pixels 2 -o out/a.glb", 2, ["--pixels", "--view"]),
        ("hills.png --view view.toml --texels 2 -o out/a.glb", 2, ["--view", "--texels"]),
        ("hills.png --view view.toml --error 1% -o out/a.glb", 2, ["--view", "--error"]),
        ("hills.png --view view.toml --side above -o out/a.glb", 2, ["--side", "pixels"]),
        ("hills.png --view view.toml --edges texels -o out/a.glb", 2, ["--view", "texels"]),
        ("hills.png --view view.toml --pixels 0.002 -o out/a.glb", 1, ["vertices", "--pixels"]),
        ("hills.png --view view.toml --solid 3 -o out/a.stl", 1, ["--solid", "view"]),
        ("hills.png --solid 0 -o out/a.stl", 2, ["--solid", "0"]),
        ("hills.png --solid 3 --mesh cube -o out/a.stl", 1, ["--solid", "closed"]),
        ("hills.png --solid 3 --mesh fold.obj -o out/a.stl", 1, ["--solid", "two triangles"]),
        ("hills.png --solid 3 --mesh touch.obj -o out/a.stl", 1, ["--solid", "twice through (0.000000"]),
        ("hills.png --solid 3 --mesh seam.obj --seams keep -o out/a.stl", 1, ["--solid", "--seams weld"]),
        ("hills.png --strips -o out/a.stl", 2, ["--strips", "STL has no triangle strips"]),
        ("hills.png --strips -o out/a.ply", 2, ["--strips", "PLY"]),
        ("hills.png --tiles 0x1 -o out/a.glb", 2, ["--tiles", "4x2"]),
        ("hills.png --tiles 2 -o out/a.glb", 2, ["--tiles", "4x2"]),
        ("hills.png --tiles 2x2 --mesh cube -o out/a.glb", 1, ["--tiles", "planes"]),
        ("hills.png --tiles 900x1 -o out/a.glb", 1, ["--tiles", "too many"]),
        ("hills.png --tiles 2x2 --shading mesh -o out/a.glb", 2, ["--tiles", "--shading"]),
        ("hills.png --tiles 2x2 --triangles 9 -o out/a.glb", 2, ["--tiles", "--triangles"]),
        ("hills.png --tiles 2x2 -o - --format glb", 2, ["--tiles", "-"]),
        ("hills.png --project box -o out/a.glb", 2, ["--project", "--mesh"]),
        ("hills.png --scale -1 -o out/a.glb", 2, ["--scale", "-1"]),
        ("hills.png --scale inf -o out/a.glb", 2, ["--scale", "inf"]),
        ("hills.png --tile 0,1 -o out/a.glb", 2, ["--tile", "0"]),
        ("hills.png --tile-size 0,1 -o out/a.glb", 2, ["--tile-size", "0"]),
        ("hills.png --print-size 0 -o out/a.stl", 2, ["--print-size", "0"]),
        ("hills.png --print-size wide -o out/a.stl", 2, ["--print-size", "wide"]),
        ("hills.png --wrap repaet -o out/a.glb", 2, ["repaet", "repeat"]),
        ("hills.png -o out/a.step", 2, ["step", "stl"]),
        ("hills.png -o out/a", 2, [".glb", ".stl"]),
        ("hills.png --mesh ring.obj -o ring.obj", 2, ["ring.obj", "replace"]),
        ("hills.png -o -", 2, ["--format", "-"]),
        ("hills.png -o out/none/a.glb", 1, ["out/none", "folder"]),
        ("hills.png -o out", 2, ["out", ".glb"]),
        ("none.png -o out/a.glb", 1, ["none.png", ""]),
        ("broken.png -o out/a.glb", 1, ["broken.png", ""]),
        ("nan.exr -o out/a.glb", 1, ["nan.exr", "--fill"]),
        ("hills.png --mesh none.obj -o out/a.glb", 1, ["none.obj", ""]),
        ("hills.png --mesh bare.obj -o out/a.glb", 1, ["bare.obj", "--project"]),
        ("hills.png --mesh flat.obj -o out/a.glb", 1, ["flat.obj", "area"]),
        ("hills.png --mesh point.obj -o out/a.glb", 1, ["point.obj", "--project"]),
        ("hills.png --mesh nan.obj -o out/a.glb", 1, ["nan.obj", ""]),
        ("hills.png --tile 1e6,1e6 -o out/a.glb", 1, ["vertices", "--texels"]),
        ("hills.png --mesh cube --tile 1e6,1e6 -o out/a.stl", 1, ["vertices", "--texels"]),
        ("hills.png --tile 48,48 --texels 1 -o out/a.glb", 1, ["4 GiB", "PLY"]),
        ("hills.png --max-memory 1MiB -o out/a.glb", 1, ["--max-memory", ""]),
        (
            "hills.png --tile 20,20 --texels 1 --shading mesh --max-memory 96MiB -o out/a.ply",
            1,
            ["--max-memory", "--texels"],
        ),
    ] {
        let ran = folder.relief(&format!("mesh {line}"));
        assert_refused(&folder, &ran, code, &words);
    }
}

#[test]
fn an_error_is_kept_in_lengths_of_the_file_and_by_each_of_its_tiles() {
    let folder = folder();
    let error = |about: &Value| about["error"]["greatest_m"].as_f64().unwrap_or_else(|| panic!("{about}"));
    let made = |line: &str| json_of(&folder.relief(&format!("mesh hills.png {line} --json")).fine());
    // By default half a percent of the scale.
    let usual = made("--scale 0.2 -o out/usual.glb");
    assert!(error(&usual) <= 0.001 && error(&usual) > 0.0002, "{usual}");
    // A tenth of a millimetre of a print of 5 cm, whatever the plane's own size is.
    let print = made("--scale 0.2 --print-size 50 --error 0.1mm -o out/print.stl");
    assert!(error(&print) <= 0.0001 && error(&print) > 0.000_05, "{print}");
    assert!((print["size_m"][0].as_f64().expect("a size") - 0.05).abs() < 1e-6, "{print}");
    // Made solid it is closed, and as thick as it was asked to be.
    let solid = made("--scale 0.2 --print-size 50 --solid 4 -o out/solid.stl");
    assert_eq!(solid["open_edges"], 0, "{solid}");
    let thick = solid["size_m"][1].as_f64().expect("a size") - print["size_m"][1].as_f64().expect("a size");
    assert!((0.0039..0.0042).contains(&thick), "{solid}");
    // So is a mesh that is no plane.
    folder.write("seam.obj", format!("{CORNERS}{SEAM}"));
    for more in ["--texels 9", "--error 1%", "--texels 9 --print-size 40", "--texels 9 --invert --base lift"]
    {
        let solid = made(&format!("--mesh seam.obj --scale 0.05 --solid 4 {more} -o out/solid.stl"));
        let counts = ["open_edges", "branching_edges", "pieces"].map(|name| solid[name].as_u64());
        assert_eq!(counts, [Some(0), Some(0), Some(1)], "{solid}");
        assert_eq!(solid["folds_below"]["triangles"], 0, "{solid}");
    }
    let few = made("--scale 0.2 --triangles 500 -o out/few.ply");
    assert!(few["triangles"].as_u64().is_some_and(|count| (400..=500).contains(&count)), "{few}");
    assert!(error(&few) > error(&usual));
    let tiles = made("--scale 0.2 --error 1mm --tiles 2x1 -o out/tile.glb");
    let files = tiles["files"].as_array().expect("files");
    let counted: u64 = files.iter().map(|file| file["triangles"].as_u64().expect("a count")).sum();
    assert_eq!((files.len(), Some(counted)), (2, tiles["triangles"].as_u64()));
    assert!(error(&tiles) <= 0.001, "{tiles}");
    assert_eq!(entries(&folder.path("out")).len(), 6);
    for name in ["tile-0-0.glb", "tile-1-0.glb"] {
        let found = json_of(&folder.relief(&format!("inspect out/{name} --json")).fine());
        assert!(files.iter().any(|file| file["triangles"] == found["triangles"]), "{found}");
    }
}

#[test]
fn a_view_makes_a_mesh_as_fine_as_it_sees() {
    let folder = folder();
    let count = |line: &str| {
        let about = json_of(&folder.relief(&format!("mesh hills.png {line} --json")).fine());
        (about["triangles"].as_u64().expect("a count"), about)
    };
    // Half as many pixels a side give a fourth of the triangles; a greater distance gives fewer.
    for (name, distance) in [("near", 1.0), ("far", 3.0)] {
        let eye = [0.3, 0.6, 1.0].map(|along| along * distance);
        let text = format!("height = 'none.png'\neye = {eye:?}\nsize = [320, 240]\n");
        folder.write(&format!("{name}.toml"), text);
    }
    let (fine, about) = count("--mesh ring.obj --view near.toml -o out/fine.glb");
    assert_eq!((about["open_edges"].as_u64(), about["pieces"].as_u64()), (Some(0), Some(1)), "{about}");
    let (coarse, _) = count("--mesh ring.obj --view near.toml --pixels 2 -o out/coarse.glb");
    let (far, _) = count("--mesh ring.obj --view far.toml -o out/far.glb");
    let ratio = fine as f64 / coarse as f64;
    assert!((3.0..4.5).contains(&ratio) && far * 4 < fine, "{fine} {coarse} {far}");
    // Coarse meshes use coarser levels, and each filter makes its own.
    let filters = ["none", "average", "max", "min", "least-squares", "variational"];
    let files: Vec<Vec<u8>> = filters
        .iter()
        .map(|filter| {
            count(&format!(
                "--mesh ring.obj --view far.toml --pixels 16 --level-filter {filter} -o out/f.ply"
            ));
            std::fs::read(folder.path("out/f.ply")).expect("it was written")
        })
        .collect();
    for (at, file) in files.iter().enumerate() {
        assert!(!files[..at].contains(file), "{}", filters[at]);
    }
    // On a plane, too, by a fixed pattern, and in parts.
    let (sheet, about) = count("--view near.toml -o out/sheet.ply");
    assert!(sheet > 20_000 && about["pieces"] == 1, "{about}");
    count("--view near.toml --interior dice --tiles 2x1 -o out/parts.ply");
    assert_eq!(entries(&folder.path("out")).len(), 7);
}

#[cfg(unix)]
#[test]
fn no_room_on_the_disk_leaves_what_was_there() {
    let folder = folder();
    folder.write("full/ring.stl", b"old");
    folder.write("full/.relief-0123456789abcdef/ring.stl", b"left by a killed process");
    let line = "mesh hills.png --mesh ring.obj -o full/ring.stl";
    let script = format!("trap '' XFSZ; ulimit -f 64; exec {} {line}", env!("CARGO_BIN_EXE_relief"));
    let output = std::process::Command::new("sh").args(["-c", &script]).current_dir(folder.path("")).output();
    let ran = Ran::new(line, &output.expect("a shell runs"));
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("full/ring.stl") && ran.stderr.contains("disk"), "{}", ran.stderr);
    assert_eq!(std::fs::read(folder.path("full/ring.stl")).expect("it is there"), b"old");
    assert_eq!(entries(&folder.path("full")).iter().filter(|name| !name.starts_with('.')).count(), 1);
    // With room it is replaced.
    folder.relief(line).fine();
    assert!(std::fs::metadata(folder.path("full/ring.stl")).expect("it is there").len() > 100_000);
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_what_was_there() {
    use std::process::Stdio;
    let folder = folder();
    folder.write("stopped/hills.ply", b"old");
    let line = "mesh hills.png --tile 60,60 --json -o stopped/hills.ply";
    let mut command = folder.command();
    command.args(line.split(' ')).stdout(Stdio::piped()).stderr(Stdio::piped());
    let run = command.spawn().expect("the command starts");
    // When the file is begun, the work goes on for long.
    let begun = || entries(&folder.path("stopped")).len() > 1;
    for _ in 0..2000 {
        if begun() {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    assert!(begun());
    let killed = std::process::Command::new("kill").args(["-INT", &run.id().to_string()]).status();
    assert!(killed.expect("kill runs").success());
    let ran = Ran::new(line, &run.wait_with_output().expect("it ends"));
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("cancelled"), "{}", ran.stderr);
    assert_eq!(entries(&folder.path("stopped")), ["hills.ply"]);
    assert_eq!(std::fs::read(folder.path("stopped/hills.ply")).expect("it is there"), b"old");
}

#[cfg(unix)]
#[test]
fn every_signal_ends_a_mesh_while_its_triangles_are_chosen() {
    use std::process::{Command, Stdio};
    use std::time::{Duration, Instant};
    let folder = folder();
    // One tile that needs many triangles, and takes seconds.
    folder.write("rough.png", Map::new(128, 128, |x, y| (((x * 7 + y * 13) * 5) % 256 * 257) as u16).png());
    for (signal, more) in
        [("-INT", ""), ("-TERM", "--fit none"), ("-HUP", "--mesh cube"), ("-INT", "--triangles 9000")]
    {
        folder.write("stopped/hills.ply", b"old");
        let line = format!("mesh rough.png {more} -q -o stopped/hills.ply");
        let mut command = folder.command();
        command.args(line.split_whitespace()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let run = command.spawn().expect("the command starts");
        // The hidden folder is there before the work begins.
        let begun = Instant::now();
        while entries(&folder.path("stopped")).len() < 2 && begun.elapsed() < Duration::from_secs(10) {
            std::thread::sleep(Duration::from_millis(2));
        }
        let sent = Command::new("kill").args([signal, &run.id().to_string()]).status();
        assert!(sent.expect("kill runs").success());
        let ran = Ran::new(&line, &run.wait_with_output().expect("it ends"));
        assert_eq!(ran.code, Some(1), "{line}: {}", ran.stderr);
        assert!(ran.stderr.contains("cancelled"), "{line}: {}", ran.stderr);
        assert_eq!(entries(&folder.path("stopped")), ["hills.ply"]);
        assert_eq!(std::fs::read(folder.path("stopped/hills.ply")).expect("it is there"), b"old");
    }
}
