//! `relief height from-normals` with texels that hold no normal, and with pictures that are no
//! normal maps.

use crate::common::command::{Folder, json_of};
use crate::common::files::exr;
use crate::common::maps::encoded;
use image::{DynamicImage, ImageFormat, RgbImage, RgbaImage};
use relief_core::Wrap;
use relief_io::{Fill, HeightOptions, read_height};

/// Function that tells which texels hold no normal.
type Mask<'a> = &'a dyn Fn(u32, u32) -> bool;

/// Function that encodes a normal as a texel.
type Texel<'a> = &'a dyn Fn([f64; 3]) -> [u8; 4];

const SIDE: u32 = 128;

/// Heights in metres on a tile of 1 m, and the unit normals of them by central differences.
fn tiling() -> (Vec<f64>, Vec<[f64; 3]>) {
    let side = f64::from(SIDE);
    let turn = std::f64::consts::TAU;
    let height = |i: u32, j: u32| {
        let [u, v] = [i, j].map(|at| (f64::from(at % SIDE) + 0.5) / side);
        0.02 * ((turn * 3.0 * u).sin() * (turn * 2.0 * v).cos() + 0.5 * (turn * (u + 4.0 * v)).sin())
    };
    let texels = || (0..SIDE).flat_map(|j| (0..SIDE).map(move |i| (i, j)));
    let normals = texels().map(|(i, j)| {
        let along = (height(i + 1, j) - height(i + SIDE - 1, j)) * side / 2.0;
        let down = (height(i, j + 1) - height(i, j + SIDE - 1)) * side / 2.0;
        let length = (along * along + down * down + 1.0).sqrt();
        [-along, down, 1.0].map(|x| x / length)
    });
    (texels().map(|(i, j)| height(i, j)).collect(), normals.collect())
}

fn code(x: f64) -> u8 {
    ((0.5 * x + 0.5) * 255.0).round() as u8
}

/// The picture of normals, with another colour where a texel is a hole.
fn picture(is_hole: &dyn Fn(u32, u32) -> bool, colour: [u8; 3]) -> RgbImage {
    let (_, normals) = tiling();
    RgbImage::from_fn(SIDE, SIDE, |i, j| {
        let normal = normals[(j * SIDE + i) as usize].map(code);
        image::Rgb(if is_hole(i, j) { colour } else { normal })
    })
}

fn png(picture: RgbImage) -> Vec<u8> {
    encoded(&DynamicImage::ImageRgb8(picture), ImageFormat::Png)
}

fn is_frame(i: u32, j: u32) -> bool {
    [i, j].iter().any(|at| !(8..SIDE - 8).contains(at))
}

/// The greatest difference in metres of the heights of a file from the true ones, where a texel is
/// no hole; the means of both are made equal there.
fn difference(folder: &Folder, name: &str, is_hole: &dyn Fn(u32, u32) -> bool) -> f64 {
    let options = HeightOptions { fill: Fill::Always, ..HeightOptions::default() };
    let map = read_height(&folder.path(name), &options).expect("a height map");
    let [zero, one] = map.physical_range().expect("the file says it");
    let (truth, _) = tiling();
    let off: Vec<f64> = (0..SIDE * SIDE)
        .filter(|at| !is_hole(at % SIDE, at / SIDE))
        .map(|at| zero + f64::from(map.texels()[at as usize]) * (one - zero) - truth[at as usize])
        .collect();
    let mean = off.iter().sum::<f64>() / off.len() as f64;
    off.iter().map(|off| (off - mean).abs()).fold(0.0, f64::max)
}

#[test]
fn background_does_not_change_the_heights_beside_it() {
    let folder = Folder::new();
    let is_one = |i: u32, j: u32| [i, j] == [64, 64];
    let is_disc = |i: u32, j: u32| {
        let [x, y] = [i, j].map(|at| f64::from(at) - 63.5);
        x * x + y * y > 55.0 * 55.0
    };
    let is_hole_in_it = |i: u32, j: u32| (40..60).contains(&i) && (70..85).contains(&j);
    let none = |_: u32, _: u32| false;
    let masks: [(&str, Mask); 4] =
        [("frame", &is_frame), ("one", &is_one), ("disc", &is_disc), ("inside", &is_hole_in_it)];
    let colours = [("black", [0u8; 3]), ("white", [255; 3]), ("grey", [128; 3]), ("blue", [0, 0, 255])];
    folder.write("whole.png", png(picture(&none, [0; 3])));
    folder.relief("height from-normals whole.png -o whole.exr").fine();
    let whole = difference(&folder, "whole.exr", &none);
    assert!(whole < 3e-4, "{whole}");
    for (mask, is_hole) in masks {
        let count = (0..SIDE * SIDE).filter(|at| is_hole(at % SIDE, at / SIDE)).count();
        for (name, colour) in colours {
            folder.write("n.png", png(picture(is_hole, colour)));
            for flags in ["", "--fill", "--green up"] {
                let line = format!("height from-normals n.png -o n.exr --json {flags}");
                let said = json_of(&folder.relief(&line).fine());
                assert_eq!(said["normals"]["holes"], count, "{mask} {name} {flags}");
                assert_eq!(said["green"]["way"], "up", "{mask} {name} {flags}");
                let off = difference(&folder, "n.exr", is_hole);
                assert!(off < 6e-4, "{mask} {name} {flags}: {off} m of 0.06 m");
                let seen = json_of(&folder.relief("inspect n.exr --json").fine());
                let holes = if flags == "--fill" { 0 } else { count };
                assert_eq!(seen["values"]["not_finite"], holes, "{mask} {name} {flags}: {seen}");
            }
            let refused = folder.relief("height from-normals n.png -o n16.png");
            assert!(refused.code == Some(1) && refused.stderr.contains("--fill"), "{}", refused.stderr);
            assert!(!folder.path("n16.png").exists());
        }
    }
}

#[test]
fn opacity_is_a_mask_or_something_else() {
    let folder = Folder::new();
    let none = |_: u32, _: u32| false;
    let write = |opacity: &dyn Fn(u32, u32) -> u8| {
        let colours = picture(&none, [0; 3]);
        let all = RgbaImage::from_fn(SIDE, SIDE, |i, j| {
            let [r, g, b] = colours.get_pixel(i, j).0;
            image::Rgba([r, g, b, opacity(i, j)])
        });
        folder.write("n.png", encoded(&DynamicImage::ImageRgba8(all), ImageFormat::Png));
    };
    let transparent = |flags: &str| {
        let line = format!("height from-normals n.png -o n.exr --json {flags}");
        json_of(&folder.relief(&line).fine())["normals"]["transparent"].clone()
    };
    write(&|i, j| if is_frame(i, j) { 0 } else { 255 });
    for wrap in Wrap::ALL {
        assert_eq!(transparent(&format!("--wrap {wrap}")), 128 * 128 - 112 * 112);
        let off = difference(&folder, "n.exr", &is_frame);
        assert!(off < 6e-4, "{wrap}: {off}");
    }
    // Heights in opacity are no holes where they are 0; neither is opacity that is 0 everywhere.
    write(&|i, j| (i + j) as u8);
    assert_eq!(transparent(""), 0);
    write(&|_, _| 0);
    assert_eq!(transparent(""), 0);
}

#[test]
fn edges_mixed_with_the_background_are_holes() {
    let folder = Folder::new();
    let is_hole = |i: u32, j: u32| (40..80).contains(&i) && (50..90).contains(&j);
    let sharp = picture(&is_hole, [0; 3]);
    let blurred = RgbImage::from_fn(SIDE, SIDE, |i, j| {
        let [left, right] = [i.max(1) - 1, (i + 1).min(SIDE - 1)].map(|i| sharp.get_pixel(i, j).0);
        let mean = [0, 1, 2].map(|k| (u16::from(left[k]).midpoint(u16::from(right[k]))) as u8);
        let is_edge = is_hole(i, j) != is_hole(i + 1, j) || is_hole(i, j) != is_hole(i.max(1) - 1, j);
        image::Rgb(if is_edge { mean } else { sharp.get_pixel(i, j).0 })
    });
    folder.write("n.png", png(blurred));
    let said = json_of(&folder.relief("height from-normals n.png -o n.exr --json --fill").fine());
    assert!(said["normals"]["mixed"].as_u64() >= Some(80), "{said}");
    let is_near = |i: u32, j: u32| (39..81).contains(&i) && (50..90).contains(&j);
    let off = difference(&folder, "n.exr", &is_near);
    assert!(off < 6e-4, "{off}");
}

#[test]
fn what_is_no_normal_map_is_told_by_what_is_measured() {
    let folder = Folder::new();
    let (_, normals) = tiling();
    let write = |texel: &dyn Fn([f64; 3]) -> [u8; 4]| {
        let all = RgbaImage::from_fn(SIDE, SIDE, |i, j| image::Rgba(texel(normals[(j * SIDE + i) as usize])));
        folder.write("n.png", encoded(&DynamicImage::ImageRgba8(all), ImageFormat::Png));
    };
    let curve =
        |code: f64| if code <= 0.003_130_8 { 12.92 * code } else { 1.055 * code.powf(1.0 / 2.4) - 0.055 };
    let back = |code: f64| if code <= 0.040_45 { code / 12.92 } else { ((code + 0.055) / 1.055).powf(2.4) };
    let through = |curve: &dyn Fn(f64) -> f64, normal: [f64; 3]| {
        let [r, g, b] = normal.map(|x| (255.0 * curve(0.5 * x + 0.5)).round() as u8);
        [r, g, b, 255]
    };
    let cases: [(&str, &str, Texel); 5] = [
        // The ground of a world with y up.
        ("object space", "object", &|[x, y, z]| [code(x), code(z), code(-y), 255]),
        // The side of a house.
        ("object space", "side", &|[x, y, z]| [code(z), code(y), code(-x), 255]),
        ("sRGB", "encoded", &|normal| through(&curve, normal)),
        ("sRGB", "decoded", &|normal| through(&back, normal)),
        ("opacity", "opacity", &|[x, y, _]| [255, code(y), 255, code(x)]),
    ];
    for (word, name, texel) in cases {
        write(texel);
        let refused = folder.relief("height from-normals n.png -o h.exr");
        assert_eq!(refused.code, Some(1), "{name}: {}", refused.stdout);
        assert!(refused.stderr.contains(word), "{name}: {}", refused.stderr);
        assert!(!folder.path("h.exr").exists());
    }
    // Noise is nothing that is known, and taken where it is wanted.
    let noise = |at: usize, seed: usize| ((at * seed) % 1009) as f32 / 1009.0 - 0.5;
    let plane = |seed: usize| (0..64 * 64).map(|at| noise(at * at, seed)).collect::<Vec<f32>>();
    folder.write("n.exr", exr([64, 64], &[("x", plane(771)), ("y", plane(313)), ("z", vec![0.8; 64 * 64])]));
    let line = "height from-normals n.exr -o h.exr --json";
    let refused = folder.relief(line);
    assert!(refused.code == Some(1) && refused.stderr.contains("--max-misfit"), "{}", refused.stderr);
    for most in ["100", "90%"] {
        let said = json_of(&folder.relief(&format!("{line} --max-misfit {most}")).fine());
        assert!(said["misfit"].as_f64() > Some(0.6), "{said}");
        std::fs::remove_file(folder.path("h.exr")).expect("it was written");
    }
    assert_eq!(folder.relief(&format!("{line} --max-misfit 10")).code, Some(1));
    for bad in ["-1", "101", "nan", "much"] {
        let refused = folder.relief(&format!("{line} --max-misfit {bad}"));
        assert!(refused.code == Some(2) && refused.stderr.contains("--max-misfit"), "{}", refused.stderr);
    }
}
