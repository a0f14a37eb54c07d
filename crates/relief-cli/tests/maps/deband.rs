//! `relief height deband`: steps of files, what stays, and the note of `relief inspect`.

use std::path::{Path, PathBuf};

use crate::common::command::{Folder, json_of};
use crate::common::files::{Samples, exr, georeference, tiff};
use crate::common::maps::Map;
use crate::common::refused::{assert_refused, with_out};
use relief_core::HeightMap;
use relief_io::{HeightOptions, HeightRange, read_height};

const SIDE: u32 = 128;

/// Hills from 0 to 1 with two waves along each side.
fn hill(i: u32, j: u32) -> f64 {
    let turn = |at: u32| (f64::from(at) * std::f64::consts::TAU * 2.0 / f64::from(SIDE)).sin();
    0.5 + 0.25 * (turn(i) + turn(j + 9))
}

/// Hills of some levels, stored by 16-bit integers of `per_level` each.
fn stepped(levels: u32, per_level: f64) -> Vec<u8> {
    let level = |i, j| (hill(i, j) * f64::from(levels - 1)).round();
    Map::new(SIDE, SIDE, |i, j| (per_level * level(i, j)).round() as u16).png()
}

fn read(path: &Path) -> HeightMap {
    let options = HeightOptions { range: Some(HeightRange::Between([0.0, 1.0])), ..HeightOptions::default() };
    let is_exr = path.extension().is_some_and(|ending| ending == "exr");
    read_height(path, &if is_exr { options } else { HeightOptions::default() }).expect("a height map")
}

/// Root mean square difference from the hills.
fn error(map: &HeightMap) -> f64 {
    let off = |(at, &h): (usize, &f32)| (f64::from(h) - hill(at as u32 % SIDE, at as u32 / SIDE)).powi(2);
    (map.texels().iter().enumerate().map(off).sum::<f64>() / f64::from(SIDE * SIDE)).sqrt()
}

#[test]
fn steps_of_files_become_slopes() {
    let folder = Folder::new();
    for (levels, per_level, flags) in [
        (52, 257.0 * 5.0, ""),
        (40, 65535.0 / 39.0, ""),
        (52, 257.0 * 5.0, " --levels 52"),
        (52, 257.0 * 5.0, " --step 1285 --wrap mirror"),
    ] {
        folder.write("map.png", stepped(levels, per_level));
        for output in ["a.exr", "a.png"] {
            let line = format!("height deband map.png -o {output} --json{flags}");
            let said = json_of(&folder.relief(&line).fine());
            let step = said["step"].as_f64().expect("a number");
            assert!((step * f64::from(levels - 1) - 1.0).abs() < 1e-3, "{line}: a step of {step}");
            let [before, after] = ["map.png", output].map(|name| read(&folder.path(name)));
            let moved = before.texels().iter().zip(after.texels()).map(|(a, b)| f64::from((a - b).abs()));
            let moved = moved.fold(0.0, f64::max);
            assert!(moved > 0.4 * step && moved <= 0.5 * step + 1e-5, "{line}: moved by {moved}");
            let ratio = error(&after) / error(&before);
            // Hills that tile have a crease where they are mirrored.
            let most = if flags.contains("mirror") { 0.4 } else { 0.2 };
            assert!(ratio < most, "{line}: {ratio}");
        }
    }
}

#[test]
fn metres_are_kept() {
    let folder = Folder::new();
    let metres: Vec<u8> = (0..SIDE * SIDE)
        .flat_map(|at| (100.0 + (hill(at % SIDE, at / SIDE) * 40.0).round() as f32).to_le_bytes())
        .collect();
    folder.write("dem.tif", tiff([SIDE; 2], Samples::Float, &metres, &georeference()));
    folder.relief("height deband dem.tif -o dem.exr").fine();
    let [before, after] = ["dem.tif", "dem.exr"]
        .map(|name| read_height(&folder.path(name), &HeightOptions::default()).expect("a height map"));
    assert_eq!(before.stated_tile_m(), after.stated_tile_m());
    let [low, high] = after.physical_range().expect("metres");
    assert!((low - 100.0).abs() <= 0.5 && (high - 140.0).abs() <= 0.5, "{low} m to {high} m");
    let metres = |map: &HeightMap, at: usize| {
        let [low, high] = map.physical_range().expect("metres");
        low + f64::from(map.texels()[at]) * (high - low)
    };
    assert!((0..before.texels().len()).all(|at| (metres(&before, at) - metres(&after, at)).abs() < 0.501));
}

#[test]
fn cobbles_of_8_bits_keep_their_edges() {
    let folder = Folder::new();
    let cobbles = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/cobbles.png");
    let truth = read_height(&cobbles, &HeightOptions::default()).expect("a height map");
    let code = |i: u32, j: u32| (truth.texel(i.into(), j.into()) * 255.0).round() as u16 * 257;
    folder.write("map.png", Map::new(truth.width(), truth.height(), code).png());
    folder.relief("height deband map.png -o a.png").fine();
    let off = |name: &str| {
        let map = read(&folder.path(name));
        let squares = map.texels().iter().zip(truth.texels()).map(|(a, b)| f64::from(a - b).powi(2));
        squares.sum::<f64>()
    };
    let ratio = (off("a.png") / off("map.png")).sqrt();
    assert!(ratio <= 1.0, "{ratio}");
}

/// Share of the texels of a map's occlusion that are more than 0.1 off the median of 3x3.
fn specks(folder: &Folder, line: &str) -> f64 {
    folder.relief(&format!("bake {line} --kind ao -o ao.png --force")).fine();
    let map = read(&folder.path("ao.png"));
    let is_off = |at: usize| {
        let [i, j] = [at as u32 % map.width(), at as u32 / map.width()].map(i64::from);
        let mut around: Vec<f32> = (-1..=1)
            .flat_map(|b| (-1..=1).map(move |a| [a, b]))
            .map(|[a, b]| map.texel(i + a, j + b))
            .collect();
        around.sort_unstable_by(f32::total_cmp);
        (map.texels()[at] - around[4]).abs() > 0.1
    };
    (0..map.texels().len()).filter(|at| is_off(*at)).count() as f64 / map.texels().len() as f64
}

#[test]
fn occlusion_of_an_8_bit_scan_loses_its_specks() {
    let data = std::env::var_os("RELIEF_DATA").map(PathBuf::from);
    let Some(rock) = data.map(|data| data.join("rock023_alb_ht.png")).filter(|file| file.is_file()) else {
        println!("skipped: RELIEF_DATA names no folder with rock023_alb_ht.png");
        return;
    };
    let folder = Folder::new();
    std::fs::copy(rock, folder.path("rock.png")).expect("the temporary folder is writable");
    let before = specks(&folder, "rock.png --channel a");
    folder.relief("height deband rock.png --channel a -o a.exr").fine();
    let after = specks(&folder, "a.exr --range 0,1");
    println!("{before:.4} become {after:.4}");
    assert!(before > 0.035, "{before}");
    assert!(after <= 0.016, "{after}");
}

#[test]
fn inspect_notes_steps_that_show() {
    let folder = Folder::new();
    let noted = |name: &str, bytes: Vec<u8>| {
        folder.write(name, bytes);
        let ran = folder.relief(&format!("inspect {name}")).fine();
        ran.stdout.contains("height deband")
    };
    let noise =
        |i: u32, j: u32| (i.wrapping_mul(2_654_435_761).wrapping_add(j.wrapping_mul(40_503_987)) >> 9) % 200;
    for levels in [16, 30, 52] {
        assert!(noted("a.png", stepped(levels, 257.0)), "{levels} levels");
    }
    assert!(!noted("a.png", stepped(256, 257.0)), "steep enough to hide its steps");
    // Smooth maps, masks, noise, and a map of few texels need nothing.
    assert!(!noted("a.png", Map::new(SIDE, SIDE, |i, j| (65535.0 * hill(i, j)) as u16).png()));
    assert!(!noted("a.png", Map::new(SIDE, SIDE, |i, j| 65535 * u16::from(hill(i, j) > 0.5)).png()));
    assert!(!noted("a.png", Map::new(SIDE, SIDE, |i, j| 257 * noise(i, j) as u16).png()));
    assert!(!noted("a.png", Map::new(40, 40, |i, j| 257 * (40.0 * hill(i, j)) as u16).png()));
    assert!(!noted("a.png", Map::new(SIDE, SIDE, |_, _| 257).png()));
    let floats = (0..SIDE * SIDE).map(|at| hill(at % SIDE, at / SIDE) as f32).collect();
    assert!(!noted("a.exr", exr([SIDE; 2], &[("Y", floats)])));
}

#[test]
fn what_has_no_steps_is_refused() {
    let folder = with_out();
    folder.write("map.png", stepped(40, 257.0));
    let floats: Vec<f32> = (0..SIDE * SIDE).map(|at| hill(at % SIDE, at / SIDE).powi(2) as f32).collect();
    folder.write("f.exr", exr([SIDE; 2], &[("Y", floats.clone())]));
    let holes = floats.iter().enumerate().map(|(at, h)| if at == 7 { f32::NAN } else { (h * 40.0).round() });
    folder.write("h.exr", exr([SIDE; 2], &[("Y", holes.collect())]));
    for (line, code, words) in [
        ("f.exr -o out/a.exr", 1, ["equal steps", "--levels"]),
        ("h.exr -o out/a.exr", 1, ["NaN", "--fill"]),
        ("map.png -o out/a.exr --step 0", 2, ["--step", "above 0"]),
        ("map.png -o out/a.exr --step nan", 2, ["--step", "NaN"]),
        ("map.png -o out/a.exr --step 1e9", 2, ["--step", "65535"]),
        ("map.png -o out/a.exr --levels 1", 2, ["--levels", "1"]),
        ("map.png -o out/a.exr --levels 9 --step 3", 2, ["--levels", "--step"]),
        ("map.png -o out/a.exr --max-memory 300KiB", 1, ["memory", ""]),
        ("map.png -o map.png", 2, ["map.png", "replace"]),
    ] {
        let ran = folder.relief(&format!("height deband {line}"));
        assert_refused(&folder, &ran, code, &words);
    }
    // A level map and filled holes are fine.
    folder.write("level.png", Map::new(1, 9, |_, _| 300).png());
    folder.relief("height deband level.png -o out/level.exr").fine();
    folder.relief("height deband h.exr --fill -o out/h.exr").fine();
    folder.relief("height deband f.exr --levels 40 -o out/f.exr").fine();
}
