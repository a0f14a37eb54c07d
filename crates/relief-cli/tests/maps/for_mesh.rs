//! `relief height for-mesh`: a lifted map over flat triangles, and texels without values.

use crate::common::aov::Aov;
use crate::common::command::{Folder, json_of};
use crate::common::maps::Map;
use crate::common::meshes::obj;
use crate::common::refused::{assert_refused, with_out};
use relief_core::mesh::torus;

/// A folder with a coarse torus, a triangle in the middle of its map, and a map of hills.
fn folder() -> Folder {
    let folder = with_out();
    folder.write("ring.obj", obj(&torus(16, 8).expect("a mesh")));
    folder.write(
        "corner.obj",
        "v -0.5 0 0\nv 0 0 1\nv 0.5 0 0\nvt 0.21 0.31\nvt 0.4 0.8\nvt 0.77 0.4\nf 1/1 2/2 3/3\n",
    );
    folder.write("hills.png", Map::many_hills().png());
    folder
}

/// Returns the distance in metres within which most hits of both lie, and the number of pixels that
/// only one covers.
fn apart(a: &Aov, b: &Aov) -> (f64, usize) {
    let pairs = || a.pixels().zip(b.pixels());
    let mut distances: Vec<f64> = pairs()
        .filter(|((_, _, a), (_, _, b))| a.hit == 1.0 && b.hit == 1.0)
        .map(|((_, _, a), (_, _, b))| (a.position - b.position).length())
        .collect();
    distances.sort_by(f64::total_cmp);
    let other = pairs().filter(|((_, _, a), (_, _, b))| a.hit != b.hit).count();
    (distances[distances.len() * 9 / 10], other)
}

#[test]
fn a_lifted_map_shows_over_flat_triangles_what_the_smooth_base_shows() {
    let folder = folder();
    let look = "--mesh ring.obj --eye 0.5,0.8,1 --target 0,0,0 --size 240x180 --samples 1 --backend cpu \
        --surface prism -o p.png --aov";
    let of_aov = |name: &str, flags: &str| {
        folder.relief(&format!("render {look} {name} {flags}")).fine();
        Aov::read(&folder.path(name))
    };
    let scale = "--height hills.png --scale 0.03 --bias 0.01";
    let lifted = of_aov("lifted.exr", &format!("{scale} --set surface.lift=1"));
    let flat = of_aov("flat.exr", scale);
    for output in ["made.exr", "made.png"] {
        let line =
            format!("height for-mesh hills.png --mesh ring.obj --lift --scale 0.03 --bias 0.01 -o {output}");
        let about = json_of(&folder.relief(&format!("{line} --json")).fine());
        let number = |name: &str| about[name].as_f64().expect("a number");
        let made = format!("--height {output} --scale {} --bias {}", number("scale_m"), number("bias_m"));
        let made = of_aov("made-aov.exr", &made);
        let ((to_made, beside_made), (to_flat, beside_flat)) = (apart(&lifted, &made), apart(&lifted, &flat));
        println!("{output}: {to_made} m, {beside_made} pixels; flat {to_flat} m, {beside_flat}");
        assert!(to_made * 8.0 < to_flat, "{output}: {to_made} {to_flat}");
        assert!(beside_made * 5 < beside_flat, "{output}: {beside_made} {beside_flat}");
        let text = folder.relief(&line).fine().stdout;
        assert!(text.contains("--scale") && text.contains("--bias"), "{text}");
        // Its metres are in the file.
        let about = json_of(&folder.relief(&format!("inspect {output} --json")).fine());
        assert_eq!(about["width"].as_u64(), Some(256), "{about}");
    }
}

#[test]
fn a_gutter_leaves_nothing_out_that_the_mesh_shows() {
    let folder = folder();
    let mut before = u64::MAX;
    for gutter in [0, 3, 20, 1000] {
        let line = format!("height for-mesh hills.png --mesh corner.obj --gutter {gutter} --json -o g.exr");
        let about = json_of(&folder.relief(&line).fine());
        let without = about["without_value"].as_u64().expect("a number");
        // The triangle is an eighth of the map.
        assert!(without < before && (gutter > 0 || without > 27_000), "{gutter}: {without}");
        assert_eq!(without == 0, gutter == 1000);
        before = without;
        let ran = folder.relief("render --height g.exr --size 40x30 --backend cpu -o p.png");
        assert_eq!(ran.code, Some(i32::from(gutter != 1000)), "{}", ran.stderr);
        let scale = format!("--scale {} --bias {}", about["scale_m"], about["bias_m"]);
        let look = "--mesh corner.obj --size 160x120 --samples 1 --backend cpu --two-sided -o p.png --json";
        let covered = |flags: &str| {
            let ran = folder.relief(&format!("render {look} {flags}"));
            assert_eq!(ran.code, Some(0), "{}", ran.stderr);
            json_of(&ran)["covered"].as_u64().expect("a number")
        };
        // From above, so that hits lie where rays enter.
        let view = "--view top --projection orthographic";
        let all = covered(&format!("--height hills.png --scale 0.05 {view}"));
        assert!(all > 1000, "{all}");
        assert_eq!(covered(&format!("--height g.exr {scale} --holes {view}")), all, "{gutter}");
    }
    // Texels that have no value are seen.
    let whole = "--mesh square --size 80x60 --samples 1 --backend cpu --view top -o p.png --json";
    folder.relief("height for-mesh hills.png --mesh corner.obj --gutter 0 -o g.exr").fine();
    let covered = |flags: &str| {
        let ran = folder.relief(&format!("render {whole} --height g.exr {flags}"));
        json_of(&ran)["covered"].as_u64().expect("a number")
    };
    assert!(2 * covered("--holes") < covered("--fill"));
}

#[test]
fn what_cannot_be_made_is_refused() {
    let folder = folder();
    folder.write("tiled.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nvt 0 0\nvt 0 3\nvt 1 0\nf 1/1 2/2 3/3\n");
    folder.write("bare.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nf 1 2 3\n");
    folder.write("speck.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nvt 0 0\nvt 0 1e-5\nvt 1e-5 0\nf 1/1 2/2 3/3\n");
    for (line, code, words) in [
        ("--mesh ring.obj -o out/a.exr", 2, ["--lift", "--gutter"]),
        ("--mesh ring.obj --gutter 2 -o out/a.png", 2, ["PNG", "EXR"]),
        ("--mesh ring.obj --gutter -1 -o out/a.exr", 2, ["--gutter", "-1"]),
        ("--mesh rung --lift -o out/a.exr", 2, ["rung", "torus"]),
        ("--mesh none.obj --lift -o out/a.exr", 1, ["none.obj", ""]),
        ("--mesh cube --lift -o out/a.exr", 1, ["cube", "both lie"]),
        ("--mesh tiled.obj --lift -o out/a.exr", 1, ["tiled.obj", "outside 0 to 1"]),
        ("--mesh bare.obj --lift -o out/a.exr", 1, ["bare.obj", "texture coordinates"]),
        ("--mesh speck.obj --lift -o out/a.exr", 1, ["speck.obj", "too small"]),
        ("--mesh ring.obj --lift -o out/none/a.exr", 1, ["out/none", ""]),
        ("--mesh ring.obj --lift --scale -1 -o out/a.exr", 2, ["-1", ""]),
        ("--mesh ring.obj --lift --scale inf -o out/a.exr", 2, ["inf", ""]),
        ("--mesh ring.obj --lift --max-memory 300KiB -o out/a.exr", 1, ["memory", ""]),
        ("--mesh ring.obj --lift -o hills.png", 2, ["hills.png", "replace"]),
    ] {
        let ran = folder.relief(&format!("height for-mesh hills.png {line}"));
        assert_refused(&folder, &ran, code, &words);
    }
}
