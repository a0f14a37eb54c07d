//! `relief mesh` of maps that know their metres. The mesh is as large as the ground, lies where the
//! file says, and keeps a tolerance in metres.

use crate::common::command::{Folder, json_of};
use crate::common::files::{Samples, Tag, tiff};
use crate::common::refused::{assert_refused, with_out};
use relief_io::{DEFAULT_MAX_BYTES, read_raw_mesh};
use serde_json::{Value, json};

const SIZE: [u32; 2] = [40, 24];

/// The lowest and the highest ground, in the unit of heights.
const GROUND: [f64; 2] = [100.0, 200.0];

/// Rounding error of 32-bit positions in a few hundred metres.
const BITS_M: f64 = 1e-4;

/// Returns hills between the heights of `GROUND`.
fn heights() -> Vec<f32> {
    let wave = |at: u32| ((f64::from(at % 40) / 7.0).sin() * (f64::from(at / 40) / 5.0).cos() + 1.0) / 2.0;
    let waves: Vec<f64> = (0..SIZE[0] * SIZE[1]).map(wave).collect();
    let [low, high] = [f64::min, f64::max].map(|of| waves.iter().copied().reduce(of).expect("some"));
    let span = GROUND[1] - GROUND[0];
    waves.iter().map(|wave| (GROUND[0] + span * (wave - low) / (high - low)) as f32).collect()
}

fn dem(tags: &[Tag]) -> Vec<u8> {
    let data: Vec<u8> = heights().iter().flat_map(|height| height.to_le_bytes()).collect();
    tiff(SIZE, Samples::Float, &data, tags)
}

/// The transformation of texels, `x = a column + b row + c` and `y = d column + e row + f`, and
/// keys.
fn ground([a, b, c, d, e, f]: [f64; 6], keys: &[[u16; 2]]) -> Vec<Tag> {
    let matrix = [a, b, 0.0, c, d, e, 0.0, f, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    let mut directory = vec![1, 1, 0, keys.len() as u16];
    keys.iter().for_each(|[key, value]| directory.extend([*key, 0, 1, *value]));
    vec![
        (34264, 12, matrix.iter().flat_map(|number| number.to_le_bytes()).collect()),
        (34735, 3, directory.iter().flat_map(|number: &u16| number.to_le_bytes()).collect()),
    ]
}

const US_FOOT: f64 = 1200.0 / 3937.0;

/// A map of the ground.
struct Model {
    name: &'static str,
    transform: [f64; 6],
    keys: &'static [[u16; 2]],
    crs: &'static str,
    /// Metres of a unit at the middle of the map, along x and y.
    metres: [f64; 2],
}

/// Metres of a degree on the WGS 84 ellipsoid, along the parallel and along the meridian.
fn degree(latitude: f64) -> [f64; 2] {
    let (a, e2) = (6_378_137.0, 0.006_694_379_990_141_3);
    let (sin, cos) = latitude.to_radians().sin_cos();
    let w = (1.0f64 - e2 * sin * sin).sqrt();
    [a * cos / w, a * (1.0 - e2) / w.powi(3)].map(|radius| radius.to_radians())
}

fn models() -> [Model; 5] {
    let turned = [8.0, 6.0, 5e5, 6.0, -8.0, 5e6];
    let rows = f64::from(SIZE[1]);
    let mercator = 1.0 / ((5_800_000.0 - 7.0 * rows) / 6_378_137.0f64).cosh();
    let of = |name, transform, keys, crs, metres| Model { name, transform, keys, crs, metres };
    let utm = &[[1024, 1], [3072, 32633], [3076, 9001], [4099, 9001]];
    [
        of("metres", [10.0, 0.0, 5e5, 0.0, -10.0, 5e6], utm, "EPSG:32633", [1.0; 2]),
        of(
            "feet",
            [32.5, 0.0, 6e6, 0.0, -32.5, 2e6],
            &[[1024, 1], [3072, 2225], [3076, 9003], [4099, 9001]],
            "EPSG:2225",
            [US_FOOT; 2],
        ),
        of(
            "degrees",
            [1e-4, 0.0, 7.0, 0.0, -1e-4, 46.0],
            &[[1024, 2], [2048, 4326], [4099, 9001]],
            "EPSG:4326",
            degree(46.0 - 1e-4 * rows / 2.0),
        ),
        of(
            "mercator",
            [14.0, 0.0, 8e5, 0.0, -14.0, 5.8e6],
            &[[1024, 1], [3072, 3857], [3076, 9001], [4099, 9001]],
            "EPSG:3857",
            [mercator; 2],
        ),
        of("turned", turned, utm, "EPSG:32633", [1.0; 2]),
    ]
}

/// A folder with all models, and one that says nothing of the ground.
fn folder() -> Folder {
    let folder = with_out();
    for Model { name, transform, keys, .. } in models() {
        folder.write(&format!("{name}.tif"), dem(&ground(transform, keys)));
    }
    folder.write("none.tif", dem(&[]));
    folder
}

/// A mesh as it is in a file: positions with texture coordinates, and triangles.
struct WrittenMesh {
    about: Value,
    vertices: Vec<([f64; 3], [f64; 2])>,
    triangles: Vec<[usize; 3]>,
}

fn read(folder: &Folder, name: &str, about: Value) -> WrittenMesh {
    let raw = read_raw_mesh(&folder.path(name), DEFAULT_MAX_BYTES).unwrap_or_else(|error| panic!("{error}"));
    let corners = raw.triangles.as_flattened();
    let vertex = |corner: &relief_core::mesh::RawCorner| {
        let uv = raw.uvs[corner.uv as usize];
        let position = raw.positions[corner.position as usize];
        (position.to_array().map(f64::from), uv.to_array().map(f64::from))
    };
    let vertices: Vec<_> = corners.iter().map(vertex).collect();
    let triangles = (0..vertices.len() / 3).map(|at| [3 * at, 3 * at + 1, 3 * at + 2]).collect();
    WrittenMesh { about, vertices, triangles }
}

fn mesh_of(folder: &Folder, line: &str) -> WrittenMesh {
    let about = json_of(&folder.relief(&format!("mesh {line} -o out/made.glb --json")).fine());
    read(folder, "out/made.glb", about)
}

fn number(of: &Value) -> f64 {
    of.as_f64().unwrap_or_else(|| panic!("{of} is no number"))
}

fn numbers<const N: usize>(of: &Value) -> [f64; N] {
    std::array::from_fn(|at| number(&of[at]))
}

/// The JSON of a GLB.
fn glb_json(folder: &Folder, name: &str) -> Value {
    let bytes = std::fs::read(folder.path(name)).expect("it was written");
    let length = u32::from_le_bytes(bytes[12..16].try_into().expect("four bytes"));
    serde_json::from_slice(&bytes[20..20 + length as usize]).expect("JSON")
}

#[test]
fn vertices_and_the_origin_are_the_coordinates_of_the_file() {
    let folder = folder();
    for Model { name, transform: [a, b, c, d, e, f], crs, metres, .. } in models() {
        let file = format!("{name}.tif");
        for flags in ["--texels 1", "--error 1m", "--error 1m --quantize 16", "--texels 3 --lods 2"] {
            let WrittenMesh { about, vertices, .. } = mesh_of(&folder, &format!("{file} {flags}"));
            let place = &about["georeference"];
            let extras = &glb_json(&folder, "out/made.glb")["nodes"][0]["extras"]["georeference"];
            assert_eq!((place, &place["crs"]), (extras, &json!(crs)), "{name} {flags}");
            assert_eq!(numbers(&place["transform"]), [a, b, c, d, e, f], "{name}");
            let [x, y, zero_m] = numbers(&place["origin"]);
            let length_m = SIZE[0].max(SIZE[1]) as f64 * (a * metres[0]).hypot(d * metres[1]);
            let moved_m = about["quantized"]["greatest_m"].as_f64().unwrap_or(0.0);
            let enough_m = f64::max(1e-3, length_m * 2.0f64.powi(-23)) + moved_m;
            for (position, [u, v]) in &vertices {
                let [column, row] = [u * f64::from(SIZE[0]), v * f64::from(SIZE[1])];
                let expected = [a * column + b * row + c, d * column + e * row + f];
                let found = [x + position[0] / metres[0], y - position[2] / metres[1]];
                let off_m = [0, 1].map(|axis| (found[axis] - expected[axis]) * metres[axis]);
                // Texture coordinates of 32 bits, or of 16, are of the same plane.
                let of_uv_m = length_m * if flags.contains("quantize") { 2e-5 } else { 1e-7 };
                let is_corner = [*u, *v].iter().all(|of| *of == 0.0 || *of == 1.0);
                let enough_m = enough_m + if is_corner { 0.0 } else { of_uv_m };
                assert!(off_m[0].hypot(off_m[1]) <= enough_m, "{name} {flags} at {u},{v}: {off_m:?} m");
            }
            let corner = |at: [f64; 2]| vertices.iter().any(|(_, uv)| *uv == at);
            assert!([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0]].into_iter().all(corner), "{name}");
            // Heights, from the lowest one.
            let [low, high] = [f64::min, f64::max]
                .map(|of| vertices.iter().map(|(at, _)| at[1]).reduce(of).expect("some vertices"));
            let within_m = enough_m + if flags == "--texels 1" { 0.0 } else { 1.0 };
            for (found, expected) in [low, high].into_iter().zip(GROUND) {
                assert!((found + zero_m - expected).abs() <= within_m, "{name} {flags}: {low} to {high}");
            }
            assert!(zero_m == GROUND[0], "{name}: {zero_m}");
        }
        let rows: [f64; 2] = numbers(&mesh_of(&folder, &file).about["georeference"]["row_lengths"]);
        let varies = ["degrees", "mercator"].contains(&name);
        assert!(rows[0] <= 1.0 && rows[1] >= 1.0 && (rows[0] < rows[1]) == varies, "{name}: {rows:?}");
    }
    // A map that knows nothing of the ground is as large as it was, and says so.
    let WrittenMesh { about, vertices, .. } = mesh_of(&folder, "none.tif --texels 1");
    let ends = |axis: usize| {
        [f64::min, f64::max].map(|of| vertices.iter().map(|(at, _)| at[axis]).reduce(of).expect("some"))
    };
    assert_eq!((ends(0), ends(2)), ([-0.5, 0.5], [-0.3f32, 0.3].map(f64::from)));
    assert_eq!((&about["georeference"], &about["metres"]["from"]), (&Value::Null, &Value::Null));
    let said = folder.relief("mesh none.tif -o out/none.glb").fine().stdout;
    assert!(said.contains("the plane is 1 m long") && said.contains("--tile-size"), "{said}");
    assert!(glb_json(&folder, "out/none.glb")["nodes"][0].get("extras").is_none());
}

/// The greatest distance in height of triangles from the bilinear surface of the map, at 8 x 8
/// points a texel, and how many of them were looked at.
fn farthest(parts: &[WrittenMesh]) -> (f64, usize) {
    const PER_TEXEL: f64 = 8.0;
    let heights = heights();
    let texel = |column: f64, row: f64| {
        let at = [column, row].map(|at| at as i64);
        let [column, row] = [at[0].clamp(0, 39), at[1].clamp(0, 23)];
        f64::from(heights[(row * 40 + column) as usize]) - GROUND[0]
    };
    let surface = |[u, v]: [f64; 2]| {
        let [x, y] = [u * 40.0 - 0.5, v * 24.0 - 0.5];
        let ([i, j], [s, t]) = ([x.floor(), y.floor()], [x - x.floor(), y - y.floor()]);
        let along = |j: f64| texel(i, j) * (1.0 - s) + texel(i + 1.0, j) * s;
        along(j) * (1.0 - t) + along(j + 1.0) * t
    };
    let count = SIZE.map(|side| (f64::from(side) * PER_TEXEL) as usize);
    let mut seen = vec![false; count[0] * count[1]];
    let mut greatest = 0.0f64;
    for WrittenMesh { vertices, triangles, .. } in parts {
        for corners in triangles {
            let [(a, uva), (b, uvb), (c, uvc)] = corners.map(|corner| vertices[corner]);
            let area = (uvb[0] - uva[0]) * (uvc[1] - uva[1]) - (uvb[1] - uva[1]) * (uvc[0] - uva[0]);
            let range = |axis: usize| {
                let [low, high] = [f64::min, f64::max]
                    .map(|of| of(of(uva[axis], uvb[axis]), uvc[axis]) * count[axis] as f64);
                (low - 0.5).ceil().max(0.0) as usize..((high - 0.5).floor().max(-1.0) + 1.0) as usize
            };
            for (i, j) in range(0).flat_map(|i| range(1).map(move |j| (i, j))) {
                let uv = [(i as f64 + 0.5) / count[0] as f64, (j as f64 + 0.5) / count[1] as f64];
                let part = |p: [f64; 2], q: [f64; 2]| {
                    ((p[0] - uv[0]) * (q[1] - uv[1]) - (p[1] - uv[1]) * (q[0] - uv[0])) / area
                };
                let weights = [part(uvb, uvc), part(uvc, uva), part(uva, uvb)];
                if weights.iter().any(|weight| *weight < -1e-9) {
                    continue;
                }
                seen[j * count[0] + i] = true;
                let height = a[1] * weights[0] + b[1] * weights[1] + c[1] * weights[2];
                greatest = greatest.max((height - surface(uv)).abs());
            }
        }
    }
    (greatest, seen.iter().filter(|seen| **seen).count())
}

#[test]
fn an_error_in_metres_holds_between_the_texels() {
    let folder = folder();
    let all = (SIZE[0] * SIZE[1] * 64) as usize;
    for name in ["metres", "feet", "degrees", "mercator", "turned"] {
        let within = mesh_of(&folder, &format!("{name}.tif --error 1m"));
        let certified = number(&within.about["error"]["greatest_m"]);
        let count = within.triangles.len();
        let (greatest, seen) = farthest(&[within]);
        assert!(
            greatest <= 1.0 + BITS_M && certified <= 1.0 && greatest > 0.5,
            "{name}: {greatest} {certified}"
        );
        assert!(seen == all && count > 100, "{name}: {seen} points, {count} triangles");
        // With half as many triangles the tolerance is missed, and the answer says so.
        let fewer = mesh_of(&folder, &format!("{name}.tif --triangles {}", count / 2));
        let certified = number(&fewer.about["error"]["greatest_m"]);
        let (greatest, seen) = farthest(&[fewer]);
        assert!(greatest > 1.0 && certified > 1.0 && seen == all, "{name}: {greatest} {certified}");
    }
    // In tiles, too, whose metres have one origin.
    folder.relief("mesh metres.tif --error 2m --tiles 2x2 -o out/tile.glb").fine();
    let tiles: Vec<WrittenMesh> = ["0-0", "1-0", "0-1", "1-1"]
        .map(|at| read(&folder, &format!("out/tile-{at}.glb"), Value::Null))
        .into();
    let (greatest, seen) = farthest(&tiles);
    assert!(greatest <= 2.0 + BITS_M && greatest > 1.0 && seen == all, "{greatest} {seen}");
    // A size that is named is the ground's, and a unit is what it says.
    let named = mesh_of(&folder, "none.tif --tile-size 400,240 --error 100cm --wrap clamp");
    assert!(farthest(std::slice::from_ref(&named)).0 <= 1.0 + BITS_M && named.triangles.len() > 100);
    assert_eq!(named.about["metres"]["from"], "tile-size");
    // The codes of a picture are no heights on the ground, whatever size its tile has.
    folder.write("codes.png", crate::common::maps::Map::hills().png());
    let picture = mesh_of(&folder, "codes.png --tile-size 400,240 --scale 5m --texels 4");
    assert_eq!(picture.about["metres"]["from"], "tile-size");
    assert_eq!(picture.about["metres"]["exaggeration"], Value::Null);
}

#[test]
fn lengths_are_those_of_the_mesh_that_is_written() {
    let folder = folder();
    let sizes = |line: &str| {
        let about = mesh_of(&folder, line).about;
        (numbers::<3>(&about["size_m"]), about)
    };
    let near = |found: f64, expected: f64| (found - expected).abs() <= 1e-4 * expected.abs();
    let (usual, about) = sizes("metres.tif --texels 1");
    assert_eq!((usual, number(&about["bias_m"])), ([400.0, 100.0, 240.0], 0.0));
    assert!(near(number(&about["scale_m"]), 100.0), "{about}");
    for (flags, high) in [
        ("--exaggerate 2", 200.0),
        ("--exaggerate 0.5", 50.0),
        ("--scale 30m", 30.0),
        ("--scale 30m --exaggerate 3", 90.0),
        ("--scale 0.03km --bias -5m", 30.0),
        ("--bias 1km", 100.0),
    ] {
        let ([x, y, z], about) = sizes(&format!("metres.tif --texels 1 {flags}"));
        assert!(near(x, 400.0) && near(y, high) && near(z, 240.0), "{flags}: {about}");
        // The file's metadata give the heights back.
        let place = &about["georeference"];
        let [_, _, zero_m] = numbers(&place["origin"]);
        let times = number(&place["exaggeration"]);
        let low = mesh_of(&folder, &format!("metres.tif --texels 1 {flags}"))
            .vertices
            .iter()
            .map(|(at, _)| at[1])
            .fold(f64::INFINITY, f64::min);
        assert!((low / times + zero_m - GROUND[0]).abs() < 1e-2, "{flags}: {low} {about}");
    }
    // A print is smaller, and the answer says what its error is on the ground.
    let (print, about) = sizes("metres.tif --error 0.1mm --print-size 150");
    assert!(near(print[0], 0.15) && near(number(&about["metres"]["size"]), 0.15 / 400.0), "{about}");
    let [on_ground, of_print] = ["on_ground_m", "greatest_m"].map(|name| number(&about["error"][name]));
    assert!(of_print <= 1e-4 && near(on_ground, of_print * 400.0 / 0.15), "{about}");
    let words = folder.relief("mesh metres.tif --texels 1 --print-size 150 -o out/a.stl").fine().stdout;
    assert!(words.contains("150 x 90 x 37.5 mm, z up") && words.contains("1 to 2666.67"), "{words}");
    let words = folder.relief("mesh metres.tif --texels 1 -o out/a.glb").fine().stdout;
    assert!(words.contains("400 x 100 x 240 m, y up") && words.contains("EPSG:32633"), "{words}");
    let words = folder.relief("mesh none.tif --tile-size 40km,24km -o out/a.glb").fine().stdout;
    assert!(words.contains(" x 24 km") && words.contains(" mm at uv"), "{words}");
    // Both commands give --exaggerate the same meaning.
    let look = "render --height metres.tif --size 64x48 --samples 1 --backend cpu";
    folder.relief(&format!("{look} --exaggerate 0.5 -o out/a.png")).fine();
    folder.relief(&format!("{look} --scale 0.125 -o out/b.png")).fine();
    folder.write("scene.toml", "height = 'metres.tif'\nexaggerate = 0.5\nsize = [64, 48]\nsamples = 1\n");
    folder.relief("render scene.toml --backend cpu -o out/c.png").fine();
    let [a, b, c] = ["a", "b", "c"]
        .map(|name| std::fs::read(folder.path(format!("out/{name}.png"))).expect("it was written"));
    assert!(a == b && b == c);
    // Pixels count in the scene, whose plane is 1 m long; the file is in metres.
    folder.write("view.toml", "height = 'none.png'\neye = [0.3, 0.6, 1]\nsize = [160, 120]\n");
    let seen = mesh_of(&folder, "metres.tif --view view.toml --pixels 4");
    let scene = mesh_of(&folder, "none.tif --scale 0.25 --wrap clamp --view view.toml --pixels 4");
    assert_eq!(seen.triangles.len(), scene.triangles.len());
    assert!(near(numbers::<3>(&seen.about["size_m"])[0], 400.0), "{}", seen.about);
    for ((at, _), (of_scene, _)) in seen.vertices.iter().zip(&scene.vertices) {
        let expected = [400.0 * of_scene[0], 400.0 * (of_scene[1] + 0.25), 400.0 * of_scene[2]];
        assert!((0..3).all(|axis| (at[axis] - expected[axis]).abs() < 1e-3), "{at:?} {expected:?}");
    }
}

#[test]
fn what_may_not_be_meant_is_said() {
    let folder = folder();
    let said = |line: &str| {
        let ran = folder.relief(&format!("mesh {line} -o out/a.glb"));
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
        ran.stderr
    };
    for (line, words) in [
        ("metres.tif --error 301m", "--error"),
        ("feet.tif --error 1km", "--error"),
        ("none.tif --scale 0.1 --error 0.2", "--error"),
        ("none.tif --mesh sphere --scale 1mm --error 1cm", "--error"),
        ("metres.tif --scale 100", "--exaggerate"),
        ("degrees.tif --scale 0.1", "--exaggerate"),
        ("none.tif --tile-size 400,240 --scale 0.1", "--exaggerate"),
    ] {
        let said = said(line);
        assert!(said.starts_with("note: ") && said.contains(words), "{line}: {said}");
    }
    for line in [
        "metres.tif --error 20m",
        "metres.tif --scale 100m",
        "none.tif --scale 0.1",
        "none.tif --mesh sphere --scale 0.1",
        "metres.tif --exaggerate 4 --error 301m",
    ] {
        assert_eq!(said(line), "", "{line}");
    }
}

#[test]
fn what_is_no_length_or_no_place_is_refused() {
    let folder = folder();
    // A mesh too large to print is not made solid by accident.
    for (line, code, words) in [
        ("metres.tif --solid 3 -o out/b.stl", 1, ["--solid", "--print-size"]),
        ("feet.tif --solid 3 --texels 1 -o out/b.stl", 1, ["--solid", "--print-size"]),
        ("none.tif --tile-size 2.1,1 --scale 1cm --solid 3 -o out/b.glb", 1, ["--solid", "--print-size"]),
        ("none.tif --place -o out/b.stl", 2, ["--place", "GLB"]),
        ("metres.tif --place -o out/b.stl", 2, ["--place", "GLB"]),
        ("metres.tif --place -o out/b.ply", 2, ["--place", "GLB"]),
        ("metres.tif --place --print-size 100 -o out/b.glb", 2, ["--place", "--print-size"]),
        ("none.tif --place -o out/b.glb", 1, ["--place", "does not state"]),
        ("degrees.tif --place -o out/b.glb", 1, ["--place", "EPSG:4326"]),
        ("mercator.tif --place -o out/b.glb", 1, ["--place", "EPSG:3857"]),
        ("metres.tif --exaggerate 0 -o out/b.glb", 2, ["--exaggerate", "0"]),
        ("metres.tif --exaggerate nan -o out/b.glb", 2, ["--exaggerate", "nan"]),
        ("metres.tif --exaggerate 1e9 -o out/b.glb", 2, ["--exaggerate", "1e6"]),
        ("metres.tif --error 1e-9m -o out/b.glb", 1, ["--error", "possible"]),
    ] {
        assert_refused(&folder, &folder.relief(&format!("mesh {line}")), code, &words);
    }
    folder.relief("mesh metres.tif --solid 3 --print-size 400m -o out/c.stl").fine();
    folder.relief("mesh none.tif --tile-size 2,1 --scale 1cm --solid 3 -o out/c.stl").fine();
}

#[test]
fn a_node_is_moved_to_where_the_map_lies() {
    let folder = folder();
    for (name, [x, y]) in [("metres", [500_200.0, 4_999_880.0]), ("turned", [500_232.0, 5_000_024.0])] {
        for flags in ["", "--quantize 14", "--lods 2 --error 1m"] {
            folder.relief(&format!("mesh {name}.tif --place {flags} -o out/d.glb")).fine();
            let placed = glb_json(&folder, "out/d.glb");
            folder.relief(&format!("mesh {name}.tif {flags} -o out/e.glb")).fine();
            let usual = glb_json(&folder, "out/e.glb");
            let at = |json: &Value, node: usize| match json["nodes"][node].get("translation") {
                Some(translation) => numbers::<3>(translation),
                None => [0.0; 3],
            };
            for node in 0..placed["nodes"].as_array().expect("nodes").len() {
                let [placed, usual] = [&placed, &usual].map(|json| at(json, node));
                for (axis, expected) in [x, GROUND[0], -y].into_iter().enumerate() {
                    let moved = placed[axis] - usual[axis];
                    assert!((moved - expected).abs() < 1e-6, "{name} {flags} axis {axis}: {moved}");
                }
            }
        }
    }
}
