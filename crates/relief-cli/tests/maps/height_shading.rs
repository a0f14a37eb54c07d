//! `relief height from-shading`: one photograph that the tests take of a map.

use crate::common::command::{Folder, json_of};
use crate::common::files::exr;
use crate::common::maps::encoded;
use crate::common::refused::{assert_refused, with_out};
use image::{ImageFormat, Rgb, RgbImage};
use relief_bake::from_shading::{Shading, heights_from_shading};
use relief_core::{Watch, Wrap};
use relief_io::{HeightOptions, linear_to_srgb, read_height, read_metadata};

const SIDE: u32 = 48;

/// Slopes of hills, along u and v.
fn slopes(x: u32, y: u32) -> [f64; 2] {
    let [u, v] = [x, y].map(|at| f64::from(at) / f64::from(SIDE) * std::f64::consts::TAU);
    [0.3 * u.cos() * v.cos(), -0.3 * u.sin() * v.sin()]
}

/// Their heights, in some unit.
fn height(x: u32, y: u32) -> f64 {
    let [u, v] = [x, y].map(|at| f64::from(at) / f64::from(SIDE) * std::f64::consts::TAU);
    u.sin() * v.cos()
}

/// Linear brightness under the light (0.6, 0, 0.8), of the albedo 0.9.
fn light(x: u32, y: u32) -> f64 {
    let [p, q] = slopes(x, y);
    0.9 * (0.8 - 0.6 * p) / (1.0 + p * p + q * q).sqrt()
}

fn photo(colour: [f64; 3], brighter: f64) -> Vec<u8> {
    let pixel = |x, y| {
        let sample =
            |part: f64| (linear_to_srgb((brighter * part * light(x, y)).min(1.0)) * 255.0).round() as u8;
        Rgb(colour.map(sample))
    };
    encoded(&RgbImage::from_fn(SIDE, SIDE, pixel).into(), ImageFormat::Png)
}

fn correlation(folder: &Folder, name: &str) -> f64 {
    let map = read_height(&folder.path(name), &HeightOptions::default()).expect("a height map");
    let pairs: Vec<[f64; 2]> = (0..SIDE * SIDE)
        .map(|at| [f64::from(map.texels()[at as usize]), height(at % SIDE, at / SIDE)])
        .collect();
    let mean = [0, 1].map(|of| pairs.iter().map(|pair| pair[of]).sum::<f64>() / pairs.len() as f64);
    let sum =
        |a: usize, b: usize| pairs.iter().map(|pair| (pair[a] - mean[a]) * (pair[b] - mean[b])).sum::<f64>();
    sum(0, 1) / (sum(0, 0) * sum(1, 1)).sqrt()
}

const LINE: &str = "height from-shading photo.png --light 0.6,0,0.8 --wrap repeat";

#[test]
fn one_photograph_gives_a_guess_that_says_so() {
    let folder = Folder::new();
    for colour in [[1.0; 3], [1.0, 0.9, 0.7]] {
        folder.write("photo.png", photo(colour, 1.0));
        for flags in ["-o h.exr", "-o h.png --texel-size 0.5", "-o h.exr --wrap mirror"] {
            let line = format!("{} {flags} --json", LINE.replace(" --wrap repeat", ""));
            let said = json_of(&folder.relief(&line).fine());
            let name = if flags.contains("png") { "h.png" } else { "h.exr" };
            assert!(correlation(&folder, name) > 0.9, "{flags}: {}", correlation(&folder, name));
            assert_eq!((&said["overexposed_percent"], &said["dark_percent"]), (&0.0.into(), &0.0.into()));
            let metadata = read_metadata(&folder.path(name)).expect("it has metadata");
            assert!(metadata.get("relief.guarantee").is_some_and(|found| found.contains("a guess")));
            assert!(metadata.get("relief.settings").is_some_and(|found| found.contains("light=0.6,0,0.8")));
        }
    }
    let ran = folder.relief(&format!("{LINE} -o h.exr")).fine();
    assert!(ran.stdout.contains("guessed") && ran.stdout.contains("estimated"), "{}", ran.stdout);
    // A second run gives the same bytes.
    let bytes = std::fs::read(folder.path("h.exr")).expect("it was written");
    folder.relief(&format!("{LINE} -o again.exr")).fine();
    assert_eq!(std::fs::read(folder.path("again.exr")).expect("it was written"), bytes);
}

#[test]
fn doubts_about_the_photograph_are_said() {
    let folder = Folder::new();
    folder.write("photo.png", photo([1.0; 3], 1.4));
    let ran = folder.relief(&format!("{LINE} -o h.exr"));
    assert!(ran.stderr.contains("% of the pixels are overexposed"), "{}", ran.stderr);
    folder.write("photo.png", photo([1.0; 3], 1.0));
    let ran = folder.relief(&format!("{LINE} --albedo 0.4 -o h.exr"));
    assert!(ran.stderr.contains("brighter than the albedo 0.4"), "{}", ran.stderr);
    let mut picture = image::load_from_memory(&photo([1.0; 3], 1.0)).expect("a picture").to_rgb8();
    picture.enumerate_pixels_mut().filter(|(x, ..)| *x < 4).for_each(|(_, _, pixel)| *pixel = Rgb([0; 3]));
    folder.write("photo.png", encoded(&picture.into(), ImageFormat::Png));
    let ran = folder.relief(&format!("{LINE} -o h.exr"));
    assert!(ran.stderr.contains("from-photos"), "{}", ran.stderr);
    let ran = folder.relief(&format!("{LINE} --albedo 0.9 -o h.exr --json"));
    assert!(json_of(&ran)["dark_percent"].as_f64().is_some_and(|share| share > 8.0));
}

#[test]
fn photographs_without_heights_are_refused() {
    let folder = with_out();
    folder.write("photo.png", photo([1.0; 3], 1.0));
    folder.write("text.png", "This is no picture.\n");
    let grey = |value: u8| encoded(&RgbImage::from_pixel(9, 1, Rgb([value; 3])).into(), ImageFormat::Png);
    folder.write("black.png", grey(0));
    folder.write("cut.png", &photo([1.0; 3], 1.0)[..90]);
    folder.write("nan.exr", exr([8, 8], &[("Y", vec![f32::NAN; 64])]));
    folder.write("minus.exr", exr([8, 8], &[("Y", vec![-0.5; 64])]));
    let table: &[(i32, &str, &[&str])] = &[
        (2, "photo.png --light 0,0,0 -o out/h.exr", &["--light", "direction"]),
        (2, "photo.png --light 1,0,-1 -o out/h.exr", &["--light", "above the surface"]),
        (2, "photo.png --light 1,0,0 -o out/h.exr", &["--light", "above the surface"]),
        (2, "photo.png --light nan,0,1 -o out/h.exr", &["--light", "finite"]),
        (2, "photo.png --light 1,0 -o out/h.exr", &["--light", "three numbers"]),
        (2, "photo.png -o out/h.exr", &["--light"]),
        (2, "photo.png --light 1,0,1", &["--output"]),
        (2, "photo.png --light 1,0,1 --albedo 0 -o out/h.exr", &["--albedo", "0"]),
        (2, "photo.png --light 1,0,1 --albedo 1.5 -o out/h.exr", &["--albedo", "1.5"]),
        (2, "photo.png --light 1,0,1 --albedo nan -o out/h.exr", &["--albedo"]),
        (2, "photo.png --light 1,0,1 --texel-size 0 -o out/h.exr", &["--texel-size"]),
        (2, "photo.png --light 1,0,1 -o photo.png", &["photo.png", "replace"]),
        (2, "photo.png --light 1,0,1 -o out/h.tif", &["--output", "exr"]),
        (1, "missing.png --light 1,0,1 -o out/h.exr", &["missing.png"]),
        (1, "text.png --light 1,0,1 -o out/h.exr", &["text.png"]),
        (1, "cut.png --light 1,0,1 -o out/h.exr", &["cut.png"]),
        (1, "black.png --light 1,0,1 -o out/h.exr", &["black.png", "black"]),
        (1, "nan.exr --light 1,0,1 -o out/h.exr", &["nan.exr"]),
        (1, "minus.exr --light 1,0,1 -o out/h.exr", &["minus.exr", "(0, 0)"]),
        (1, "photo.png --light 1,0,1 -o out/h.exr --max-memory 100KiB", &["--max-memory"]),
        (1, "photo.png --light 1,0,1 -o nowhere/h.exr", &["nowhere"]),
    ];
    for (code, line, words) in table {
        assert_refused(&folder, &folder.relief(&format!("height from-shading {line}")), *code, words);
    }
    // Photographs of a line and of one pixel are ground, too.
    folder.write("line.png", grey(120));
    for line in ["line.png --light 1,0,1 -o line.exr", "line.png --light 1,0,1 --wrap repeat -o line.exr"] {
        folder.relief(&format!("height from-shading {line}")).fine();
    }
}

/// Side of the maps that are photographed, and of the photographs.
const SIDES: [usize; 2] = [256, 64];

/// Directions of the light around the normal.
const AZIMUTHS: usize = 6;

/// A map whose heights are known: its name, and heights from 0 to 1.
type Known = (&'static str, Vec<f64>);

fn known_maps(folder: &Folder) -> Vec<Known> {
    let mut files = Vec::new();
    for name in ["waves", "fbm", "bumps"] {
        folder.relief(&format!("height procedure {name} --size 256x256 -o {name}.exr")).fine();
        files.push((name, folder.path(format!("{name}.exr")), None));
    }
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    files.push(("cobbles", root.join("data/cobbles.png"), None));
    let data = std::env::var_os("RELIEF_DATA").map(std::path::PathBuf::from);
    match data.map(|data| data.join("rock023_alb_ht.png")).filter(|file| file.is_file()) {
        Some(rock) => files.push(("rock", rock, Some("a".to_owned()))),
        None => println!("rock is skipped: RELIEF_DATA names no folder with rock023_alb_ht.png"),
    }
    let read = |(name, path, channel): (_, std::path::PathBuf, _)| {
        let map = read_height(&path, &HeightOptions { channel, ..HeightOptions::default() });
        let map = map.expect("a height map");
        let map = if map.width() == 1024 { map.level(2) } else { map };
        let [low, high] = map.extremes().map(f64::from);
        (name, map.texels().iter().map(|&h| (f64::from(h) - low) / (high - low)).collect())
    };
    files.into_iter().map(read).collect()
}

/// Means over the texels of a photograph.
fn averaged(plane: &[f64]) -> Vec<f64> {
    let [fine, coarse] = SIDES;
    let by = fine / coarse;
    let texel = |at: usize| {
        let (i, j) = (at % coarse * by, at / coarse * by);
        let rows = (j..j + by).map(|row| plane[row * fine + i..][..by].iter().sum::<f64>());
        rows.sum::<f64>() / (by * by) as f64
    };
    (0..coarse * coarse).map(texel).collect()
}

/// The photograph, in 8 bits, of a relief a twentieth of a tile deep.
fn photograph(heights: &[f64], to_light: [f64; 3], with_shadows: bool) -> Vec<f32> {
    let side = SIDES[0] as i64;
    let depth = 0.05 * side as f64;
    let height = |i: i64, j: i64| depth * heights[(j.rem_euclid(side) * side + i.rem_euclid(side)) as usize];
    let is_shadowed = |i: i64, j: i64| {
        let level = to_light[0].hypot(to_light[1]);
        let [right, down, rise] = [to_light[0], -to_light[1], to_light[2]].map(|x| x / level);
        let between = |x: f64, y: f64| {
            let (i, j) = (x.floor(), y.floor());
            let (u, v) = (x - i, y - j);
            let row = |by: i64| {
                let [a, b] = [0, 1].map(|at| height(i as i64 + at, j as i64 + by));
                a + u * (b - a)
            };
            row(0) + v * (row(1) - row(0))
        };
        let over = |step: i32| height(i, j) + 0.5 * f64::from(step) * rise;
        let mut steps = (2..).take_while(|&step| over(step) < depth);
        steps.any(|step| {
            let t = 0.5 * f64::from(step);
            between(i as f64 + t * right, j as f64 + t * down) > over(step)
        })
    };
    let pixel = |at: usize| {
        let (i, j) = (at as i64 % side, at as i64 / side);
        let p = (height(i + 1, j) - height(i - 1, j)) / 2.0;
        let q = (height(i, j + 1) - height(i, j - 1)) / 2.0;
        let facing = to_light[2] - to_light[0] * p + to_light[1] * q;
        if with_shadows && is_shadowed(i, j) { 0.0 } else { facing.max(0.0) / (1.0 + p * p + q * q).sqrt() }
    };
    let pixels: Vec<f64> = (0..SIDES[0] * SIDES[0]).map(pixel).collect();
    averaged(&pixels).iter().map(|light| ((light * 255.0).round() / 255.0) as f32).collect()
}

/// Heights by Pentland 1989, *Shape Information from Shading: A Theory about Human Perception*: the
/// brightness as a linear function of the slopes, inverted wave by wave.
fn linear(photo: &[f32], to_light: [f64; 3]) -> Vec<f64> {
    let side = SIDES[1];
    let angle = |k: usize| k as f64 / side as f64 * std::f64::consts::TAU;
    let transform = |plane: &[[f64; 2]], sign: f64| -> Vec<[f64; 2]> {
        let lines = |plane: &[[f64; 2]]| -> Vec<[f64; 2]> {
            // Transforms the rows, and writes columns.
            let wave = |at: usize| {
                let (row, k) = (at % side, at / side);
                (0..side).fold([0.0; 2], |[re, im], n| {
                    let (sin, cos) = (sign * angle(k * n % side)).sin_cos();
                    let [a, b] = plane[row * side + n];
                    [re + a * cos - b * sin, im + a * sin + b * cos]
                })
            };
            (0..side * side).map(wave).collect()
        };
        lines(&lines(plane))
    };
    let brightness: Vec<[f64; 2]> = photo.iter().map(|&light| [f64::from(light), 0.0]).collect();
    let mut waves = transform(&brightness, -1.0);
    for (at, wave) in waves.iter_mut().enumerate() {
        let seen = -to_light[0] * angle(at % side).sin() + to_light[1] * angle(at / side).sin();
        let [re, im] = *wave;
        *wave = [im, -re].map(|part| part * seen / (seen * seen + 1e-3));
    }
    waves[0] = [0.0; 2];
    transform(&waves, 1.0).iter().map(|[re, _]| *re).collect()
}

fn likeness(a: &[f64], b: &[f64]) -> f64 {
    let mean = [a, b].map(|values| values.iter().sum::<f64>() / values.len() as f64);
    let sum = |f: &dyn Fn(f64, f64) -> f64| -> f64 {
        a.iter().zip(b).map(|(x, y)| f(x - mean[0], y - mean[1])).sum()
    };
    sum(&|x, y| x * y) / (sum(&|x, _| x * x) * sum(&|_, y| y * y)).sqrt()
}

#[test]
fn guesses_are_nearer_to_known_maps_than_a_linear_method() {
    let least = [("waves", [0.95, 0.92]), ("fbm", [0.94, 0.91]), ("bumps", [0.75, 0.47])];
    let least = least.into_iter().chain([("cobbles", [0.69, 0.41]), ("rock", [0.60, 0.34])]);
    let least: std::collections::BTreeMap<_, _> = least.collect();
    println!("| map | degrees | from-shading | without --albedo | with cast shadows | linear |");
    for (name, heights) in known_maps(&Folder::new()) {
        let truth = averaged(&heights);
        for (at, degrees) in [60.0f64, 30.0].into_iter().enumerate() {
            let (sin, cos) = degrees.to_radians().sin_cos();
            let mut sums = [0.0; 4];
            for azimuth in 0..AZIMUTHS {
                let (up, right) = (azimuth as f64 / AZIMUTHS as f64 * std::f64::consts::PI).sin_cos();
                let to_light = [sin * right, sin * up, cos];
                let how = |albedo| Shading {
                    to_light,
                    albedo,
                    overexposed: f32::INFINITY,
                    texel_m: [1.0; 2],
                    wrap: Wrap::Repeat,
                };
                let guess = |photo: &[f32], albedo| {
                    let size = [SIDES[1] as u32; 2];
                    let found = heights_from_shading(size, photo, &how(albedo), &Watch::none());
                    let found = found.expect("a good photograph").heights_m;
                    likeness(&found.iter().map(|&h| f64::from(h)).collect::<Vec<f64>>(), &truth)
                };
                let photo = photograph(&heights, to_light, false);
                sums[0] += guess(&photo, Some(1.0));
                sums[1] += guess(&photo, None);
                sums[2] += guess(&photograph(&heights, to_light, true), Some(1.0));
                sums[3] += likeness(&linear(&photo, to_light), &truth);
            }
            let [with, without, shadowed, linear] = sums.map(|sum| sum / AZIMUTHS as f64);
            println!("| {name} | {degrees} | {with:.2} | {without:.2} | {shadowed:.2} | {linear:.2} |");
            assert!(with >= least[name][at], "{name}, {degrees} degrees: {with}");
            assert!(with > linear, "{name}, {degrees} degrees: {with}, linear {linear}");
        }
    }
}
