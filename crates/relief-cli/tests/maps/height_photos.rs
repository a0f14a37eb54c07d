//! `relief height from-photos`: photographs that the tests take of a map under known lights.

use crate::common::command::{Folder, json_of};
use crate::common::files::{exr, foreign};
use crate::common::maps::{Map, encoded};
use image::{DynamicImage, ImageBuffer, ImageFormat, Rgb};
use relief_io::{HeightOptions, linear_to_srgb, read_height, read_metadata, read_picture};

const SIDE: u32 = 48;

/// Metres between heights 0 and 1, on a tile of 1 m.
const SCALE_M: f64 = 0.06;

const LIGHTS: [([f64; 3], f64); 4] =
    [([0.5, 0.1, 0.8], 1.0), ([-0.5, 0.2, 0.8], 1.1), ([0.0, 0.55, 0.8], 0.9), ([0.1, -0.5, 0.7], 1.0)];

/// Red, green and blue that a texel reflects, in linear light.
fn albedo(x: u32, y: u32) -> [f64; 3] {
    if (x / 8 + y / 6).is_multiple_of(2) { [0.7, 0.5, 0.3] } else { [0.3, 0.5, 0.8] }
}

/// Hills that tile.
fn hills() -> Map {
    Map::new(SIDE, SIDE, |x, y| {
        let [u, v] = [x, y].map(|at| f64::from(at) / f64::from(SIDE) * std::f64::consts::TAU);
        let hills = (2.0 * u).sin() * v.cos() + 0.5 * (3.0 * u + 1.0).cos() + 0.4 * (2.0 * v + u).sin();
        ((0.5 + 0.25 * hills) * 65535.0).round() as u16
    })
}

/// Linear red, green and blue of each pixel under a light, none of it in shadow.
fn photo(map: &Map, (to_light, intensity): ([f64; 3], f64)) -> Vec<[f64; 3]> {
    let length = to_light.iter().map(|x| x * x).sum::<f64>().sqrt();
    let height = |x: u32, y: u32| {
        f64::from(map.texels[(y % SIDE * SIDE + x % SIDE) as usize]) / 65535.0 * SCALE_M * f64::from(SIDE)
    };
    let pixel = |x: u32, y: u32| {
        let along_u = (height(x + 1, y) - height(x + SIDE - 1, y)) / 2.0;
        let along_v = (height(x, y + 1) - height(x, y + SIDE - 1)) / 2.0;
        // Up in the picture is against v.
        let facing = -along_u * to_light[0] + along_v * to_light[1] + to_light[2];
        let light = facing / (1.0 + along_u.powi(2) + along_v.powi(2)).sqrt() / length * intensity;
        assert!(light > 0.05, "the lights shine on all of the map");
        albedo(x, y).map(|part| part * light)
    };
    (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))).map(|(x, y)| pixel(x, y)).collect()
}

fn integers(pixels: &[[f64; 3]], curve: fn(f64) -> f64) -> Vec<u8> {
    let samples =
        pixels.iter().flatten().map(|&light| (curve(light.min(1.0)) * 65535.0).round() as u16).collect();
    let picture = ImageBuffer::<Rgb<u16>, Vec<u16>>::from_raw(SIDE, SIDE, samples).expect("as many samples");
    encoded(&DynamicImage::ImageRgb16(picture), ImageFormat::Png)
}

fn floats(pixels: &[[f64; 3]]) -> Vec<u8> {
    let plane = |channel: usize| pixels.iter().map(|pixel| pixel[channel] as f32).collect::<Vec<f32>>();
    exr([SIDE, SIDE], &[("R", plane(0)), ("G", plane(1)), ("B", plane(2))])
}

/// Storage of a folder's photographs.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Srgb,
    Linear,
    Floats,
}

/// The photographs in the folder `shots`, and the list of their lights.
fn shoot(folder: &Folder, kind: Kind) {
    let mut list = String::from(if kind == Kind::Linear { "linear = true\n" } else { "" });
    for (at, (to_light, intensity)) in LIGHTS.into_iter().enumerate() {
        let pixels = photo(&hills(), (to_light, intensity));
        let (name, bytes) = match kind {
            Kind::Srgb => (format!("{at}.png"), integers(&pixels, linear_to_srgb)),
            Kind::Linear => (format!("{at}.png"), integers(&pixels, |light| light)),
            Kind::Floats => (format!("{at}.exr"), floats(&pixels)),
        };
        folder.write(&format!("shots/{name}"), bytes);
        list += &format!("[[photo]]\nfile = '{name}'\nlight = {to_light:?}\nintensity = {intensity}\n");
    }
    folder.write("shots/lights.toml", list);
}

/// The root mean square error of the heights in a file, as a part of the relief.
fn error(folder: &Folder, name: &str) -> f64 {
    let map = read_height(&folder.path(name), &HeightOptions::default()).expect("a height map");
    let [zero, one] = map.physical_range().expect("the file says it");
    let original = hills();
    let off: Vec<f64> = map
        .texels()
        .iter()
        .zip(&original.texels)
        .map(|(&texel, &known)| zero + f64::from(texel) * (one - zero) - f64::from(known) / 65535.0 * SCALE_M)
        .collect();
    let mean = off.iter().sum::<f64>() / off.len() as f64;
    (off.iter().map(|off| (off - mean).powi(2)).sum::<f64>() / off.len() as f64).sqrt() / SCALE_M
}

#[test]
fn heights_normals_and_colours_come_back() {
    let folder = Folder::new();
    for kind in [Kind::Srgb, Kind::Linear, Kind::Floats] {
        shoot(&folder, kind);
        for (ending, rounding) in [("png", 1.0), ("exr", 0.0)] {
            let line = format!(
                "height from-photos shots/lights.toml -o h.{ending} --normals n.{ending} --albedo a.{ending} \
                 --wrap repeat --damping 0 --json"
            );
            let said = json_of(&folder.relief(&line).fine());
            assert_eq!((&said["photographs"], &said["filled_in"]), (&4.into(), &0.into()));
            let off = error(&folder, &format!("h.{ending}"));
            let most = if kind == Kind::Floats { 1e-6 } else { 1e-4 } + rounding * 1e-5;
            assert!(off < most, "{kind:?} {ending}: {off} of the relief");
            // The normals fit the heights, and their file states where green points.
            let back = format!("height from-normals n.{ending} -o back.exr --damping 0 --json");
            assert_eq!(json_of(&folder.relief(&back).fine())["green"]["said_by"], "the file");
            let off = error(&folder, "back.exr");
            assert!(off < 1e-4, "{kind:?} {ending}: {off} of the relief");
            let colours = read_picture(&folder.path(format!("a.{ending}")), 1 << 30).expect("a picture");
            for (at, found) in colours.texels.iter().enumerate() {
                let expected = albedo(at as u32 % SIDE, at as u32 / SIDE);
                for (found, expected) in found.iter().zip(expected) {
                    let off = (f64::from(*found) - expected).abs();
                    assert!(off < 1e-3 + rounding * 4e-3, "{kind:?} {ending}: {found} for {expected}");
                }
            }
        }
    }
    // The list may come from other systems.
    let list = std::fs::read_to_string(folder.path("shots/lights.toml")).expect("it was written");
    for (name, bytes) in foreign(&list) {
        folder.write("shots/lights.toml", bytes);
        folder.relief("height from-photos shots/lights.toml -o h.exr --wrap repeat --damping 0").fine();
        assert!(error(&folder, "h.exr") < 1e-6, "{name}");
    }
    for (name, space) in [("n.exr", "up"), ("a.exr", "linear"), ("a.png", "sRGB")] {
        let metadata = read_metadata(&folder.path(name)).expect("it has metadata");
        assert!(metadata.get("relief.note.space").is_some_and(|found| found.contains(space)), "{name}");
    }
    // The wrong curve shows: matt normals no longer explain the photographs.
    shoot(&folder, Kind::Linear);
    let list = std::fs::read_to_string(folder.path("shots/lights.toml")).expect("it was written");
    folder.write("shots/lights.toml", list.replace("linear = true", ""));
    folder.relief("height from-photos shots/lights.toml -o h.exr --wrap repeat --damping 0").fine();
    assert!(error(&folder, "h.exr") > 0.01);
}

/// A PNG of linear samples whose rows are stored as an orientation of EXIF says, by which it is
/// shown upright; marked as linear or not.
fn turned(pixels: &[[f64; 3]], orientation: u8, gamma: Option<f32>) -> Vec<u8> {
    let samples = pixels.iter().flatten().map(|&light| (light.min(1.0) * 65535.0).round() as u16).collect();
    let shown = ImageBuffer::<Rgb<u16>, Vec<u16>>::from_raw(SIDE, SIDE, samples).expect("as many samples");
    let shown = DynamicImage::ImageRgb16(shown);
    let stored = match orientation {
        3 => shown.rotate180(),
        6 => shown.rotate270(),
        8 => shown.rotate90(),
        _ => shown,
    };
    let exif =
        [b"II*\0\x08\0\0\0\x01\0\x12\x01\x03\0\x01\0\0\0".as_slice(), &[orientation, 0, 0, 0], &[0; 4]]
            .concat();
    let mut info = png::Info::with_size(SIDE, SIDE);
    info.color_type = png::ColorType::Rgb;
    info.bit_depth = png::BitDepth::Sixteen;
    info.exif_metadata = Some(exif.into());
    info.source_gamma = gamma.map(png::ScaledFloat::new);
    let mut bytes = Vec::new();
    let writer = png::Encoder::with_info(&mut bytes, info).and_then(png::Encoder::write_header);
    let mut writer = writer.expect("a valid header");
    let data: Vec<u8> = stored.into_rgb16().iter().flat_map(|sample| sample.to_be_bytes()).collect();
    writer.write_image_data(&data).expect("as many samples as the header says");
    writer.finish().expect("it is whole");
    bytes
}

#[test]
fn photographs_are_turned_and_linear_as_they_say() {
    let folder = Folder::new();
    shoot(&folder, Kind::Linear);
    let list = std::fs::read_to_string(folder.path("shots/lights.toml")).expect("it was written");
    let unsaid = list.replace("linear = true\n", "");
    let solve = |list: &str, orientation: u8, gamma: Option<f32>| {
        for (at, light) in LIGHTS.into_iter().enumerate() {
            folder.write(&format!("shots/{at}.png"), turned(&photo(&hills(), light), orientation, gamma));
        }
        folder.write("shots/lights.toml", list);
        let ran = folder.relief("height from-photos shots/lights.toml -o h.exr --wrap repeat --damping 0");
        assert_eq!(ran.code, Some(0), "{ran:?}");
        (error(&folder, "h.exr"), ran.stderr.matches("note: ").count())
    };
    for orientation in [1, 3, 6, 8] {
        let (off, notes) = solve(&list, orientation, None);
        assert!(off < 1e-4 && notes == 0, "{orientation}: {off} of the relief");
        let (off, notes) = solve(&unsaid, orientation, Some(1.0));
        assert!(off < 1e-4 && notes == 0, "{orientation}, linear: {off} of the relief");
    }
    // The list overrides the files, and bad numbers are reported for each photograph.
    assert!(solve(&format!("linear = false\n{unsaid}"), 1, Some(1.0)).0 > 0.01);
    assert!(solve(&unsaid, 1, None).0 > 0.01);
    assert_eq!(solve(&list, 9, None).1, LIGHTS.len());
}

#[test]
fn shadows_and_overexposure_are_left_out() {
    let folder = Folder::new();
    shoot(&folder, Kind::Floats);
    // In one photograph a corner is in shadow, in another one is too bright.
    let mut pixels = LIGHTS.map(|light| photo(&hills(), light));
    let corner = |at: usize| at % SIDE as usize > 40 && at / (SIDE as usize) < 7;
    for at in (0..pixels[0].len()).filter(|&at| corner(at)) {
        pixels[0][at] = [0.01; 3];
    }
    let list = std::fs::read_to_string(folder.path("shots/lights.toml")).expect("it was written");
    let run = |head: &str, pixels: &[Vec<[f64; 3]>; 4]| {
        pixels
            .iter()
            .enumerate()
            .for_each(|(at, pixels)| folder.write(&format!("shots/{at}.exr"), floats(pixels)));
        folder.write("shots/lights.toml", format!("{head}{list}"));
        folder.relief("height from-photos shots/lights.toml -o h.exr --wrap repeat --damping 0").fine();
        error(&folder, "h.exr")
    };
    assert!(run("shadow = 0.02\n", &pixels) < 1e-6);
    assert!(run("shadow = 0\n", &pixels) > 1e-3);
    let mut bright = LIGHTS.map(|light| photo(&hills(), light));
    bright[2].iter_mut().enumerate().filter(|(at, _)| corner(*at)).for_each(|(_, pixel)| pixel[1] = 1.2);
    assert!(run("overexposed = 1.19\n", &bright) < 1e-6);
    assert!(run("overexposed = inf\n", &bright) > 1e-3);
    // Where two photographs are dark, the other two are too few, and slopes are filled in.
    for (at, pixel) in pixels[1].iter_mut().enumerate() {
        if corner(at) {
            *pixel = [0.0; 3];
        }
    }
    assert!(run("shadow = 0.02\n", &pixels) < 0.1);
    let said = json_of(&folder.relief("height from-photos shots/lights.toml -o h.exr --json").fine());
    assert_eq!(said["filled_in"], 7 * 7);
}

#[test]
fn nothing_is_written_unless_everything_is() {
    let folder = Folder::new();
    shoot(&folder, Kind::Srgb);
    folder.write("n.exr/inside", "");
    let before = |folder: &Folder| {
        let entries = std::fs::read_dir(folder.path("")).expect("the folder is there");
        let mut names: Vec<_> = entries.map(|entry| entry.expect("an entry").file_name()).collect();
        names.sort();
        names
    };
    let names = before(&folder);
    for (flags, code) in [
        ("--normals n.exr", 1),
        ("--normals nowhere/n.exr", 1),
        ("--albedo h.png", 2),
        ("--albedo ./h.png", 2),
        ("--normals shots/0.png", 2),
        ("--albedo a.jpg", 2),
    ] {
        let ran = folder.relief(&format!("height from-photos shots/lights.toml -o h.png {flags}"));
        assert_eq!(ran.code, Some(code), "{flags}: {}", ran.stderr);
        assert_eq!(before(&folder), names, "{flags}");
    }
    let whole = std::fs::read(folder.path("shots/0.png")).expect("it is there");
    folder.relief("height from-photos shots/lights.toml -o h.png").fine();
    folder.relief("height from-photos shots/lights.toml -o h.png --wrap mirror").fine();
    assert_eq!(std::fs::read(folder.path("shots/0.png")).expect("it is there"), whole);
}
