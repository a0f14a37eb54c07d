//! Wrong normal maps, photographs and lists of lights are reported as in `bad_input.rs`.

use crate::common::files::exr;
use crate::common::maps::{Map, encoded};
use crate::common::refused::{OUT, assert_refused, entries, with_out};
use image::ImageFormat;

#[test]
fn heights_that_cannot_be_made_are_refused() {
    let folder = with_out();
    folder.write("map.png", Map::hills().png());
    folder.write("text.png", "This is no picture.\n");
    folder.write("folder.exr/inside", []);
    let picture = |side: u32, colour: [u8; 3]| {
        encoded(&image::RgbImage::from_pixel(side, side, image::Rgb(colour)).into(), ImageFormat::Png)
    };
    for (name, side, colour) in [
        ("n.png", 8, [99, 140, 230]),
        ("inward.png", 8, [99, 140, 30]),
        ("none.png", 8, [128; 3]),
        ("big.png", 9, [9; 3]),
    ] {
        folder.write(name, picture(side, colour));
    }
    let plane = |value: f32| vec![value; 64];
    folder.write("nan.exr", exr([8, 8], &[("R", plane(f32::NAN)), ("G", plane(0.0)), ("B", plane(1.0))]));
    folder.write("minus.exr", exr([8, 8], &[("Y", plane(-0.5))]));
    let table: &[(i32, &str, &[&str])] = &[
        (2, "n.png -o out/h.pgn", &["--output", "png"]),
        (2, "n.png -o out/h.tif", &["--output", "exr"]),
        (2, "n.png -o out/h", &["--output", ".png"]),
        (2, "n.png -o n.png", &["n.png", "replace"]),
        (2, "n.png -o out/../n.png", &["n.png", "replace"]),
        (2, "n.png -o out/h.png --green sideways", &["--green", "down"]),
        (2, "n.png -o out/h.png --wrap mirrored", &["--wrap", "mirror"]),
        (2, "n.png -o out/h.png --texel-size 0", &["--texel-size"]),
        (2, "n.png -o out/h.png --texel-size -1,1", &["--texel-size"]),
        (2, "n.png -o out/h.png --texel-size 1e300", &["--texel-size"]),
        (2, "n.png -o out/h.png --texel-size 1,2,3", &["--texel-size", "X,Y"]),
        (2, "n.png -o out/h.png --texel-size nan", &["--texel-size", "finite"]),
        (2, "n.png -o out/h.png --damping 2", &["--damping"]),
        (2, "n.png -o out/h.png --damping nan", &["--damping"]),
        (2, "n.png -o out/h.png --steepest 0", &["--steepest"]),
        (2, "n.png -o out/h.png --max-memory much", &["--max-memory"]),
        (2, "n.png", &["--output"]),
        (1, "missing.png -o out/h.png", &["missing.png"]),
        (1, "text.png -o out/h.png", &["text.png"]),
        (1, "map.png -o out/h.png", &["map.png", "normal map"]),
        (1, ". -o out/h.png", &["folder"]),
        (1, "none.png -o out/h.png", &["none.png", "direction"]),
        (1, "nan.exr -o out/h.png --fill", &["nan.exr", "direction"]),
        (1, "inward.png -o out/h.png", &["inward.png", "blue"]),
        (1, "n.png -o nowhere/h.png", &["nowhere"]),
        (1, "n.png -o folder.exr", &["folder.exr"]),
        (1, "n.png -o out/h.png --max-memory 100", &["n.png", "--max-memory"]),
        (1, "n.png -o out/h.png --max-memory 1KiB", &["--max-memory"]),
    ];
    for (code, line, words) in table {
        assert_refused(&folder, &folder.relief(&format!("height from-normals {line}")), *code, words);
    }
    let photo = |file: &str, light: &str| format!("[[photo]]\nfile = '{file}'\nlight = {light}\n");
    let [a, b, c] = ["[0.5, 0, 1]", "[-0.5, 0, 1]", "[0, 0.5, 1]"].map(|light| photo("n.png", light));
    let table: &[(String, &[&str])] = &[
        (String::new(), &["three", "0 are"]),
        (format!("{a}{b}"), &["three", "2 are"]),
        (format!("{a}{b}{}", photo("n.png", "[0.2, 0, 1]")), &["plane"]),
        (format!("{a}{b}{}", photo("n.png", "[0, 0, 0]")), &["line 9", "direction"]),
        (format!("{a}{b}{}", photo("n.png", "[0, 1, -0.2]")), &["line 9", "above"]),
        (format!("{a}{b}{}", photo("n.png", "[0, nan, 1]")), &["line 9", "direction"]),
        (format!("{a}{b}{}", photo("n.png", "[0, 1]")), &["line 9"]),
        (format!("{a}{b}{c}intensity = 0"), &["line 10", "intensity"]),
        (format!("{a}{b}{}", photo("missing.png", "[0, 0.5, 1]")), &["line 8", "missing.png"]),
        (format!("{a}{}{c}", photo("text.png", "[-0.5, 0, 1]")), &["line 5", "text.png"]),
        (format!("{a}{}{c}", photo("big.png", "[-0.5, 0, 1]")), &["line 5", "big.png", "9x9", "8x8"]),
        (format!("{a}{}{c}", photo("minus.exr", "[-0.5, 0, 1]")), &["line 5", "minus.exr", "(0, 0)"]),
        (format!("{a}{b}{c}ligth = 3"), &["line 10", "ligth"]),
        (format!("shadow = -1\n{a}{b}{c}"), &["line 1", "-1"]),
        (format!("shadow = 0.5\noverexposed = 0.2\n{a}{b}{c}"), &["line 2", "shadow"]),
        (format!("shadow = 5\noverexposed = 9\n{a}{b}{c}"), &["shadow", "lit"]),
        ("= 5".to_owned(), &["line 1"]),
        ("#".repeat(2 << 20), &["too long"]),
    ];
    let run = |flags: &str| folder.relief(&format!("height from-photos l.toml -o out/h.exr {flags}"));
    for (text, words) in table {
        folder.write("l.toml", text);
        assert_refused(
            &folder,
            &run("--normals out/n.png --albedo out/a.png"),
            1,
            &[&["l.toml"], *words].concat(),
        );
    }
    folder.write("l.toml", format!("{a}{b}{c}"));
    assert_refused(&folder, &run("--max-memory 2KiB"), 1, &["--max-memory"]);
    assert_refused(&folder, &run("--albedo n.png"), 2, &["--albedo", "n.png"]);
    folder.write("l.toml", [0xff, 0xfe, 0x00]);
    assert_refused(&folder, &run(""), 1, &["l.toml"]);
    assert_refused(
        &folder,
        &folder.relief("height from-photos missing.toml -o out/h.exr"),
        1,
        &["missing.toml"],
    );
    // Without a source it shows its help, as `relief` does without a command.
    let bare = folder.relief("height");
    assert!(bare.code == Some(2) && bare.stderr.contains("from-normals"), "{}", bare.stderr);
    assert_refused(&folder, &folder.relief("height from-normal n.png -o out/h.png"), 2, &["from-normals"]);
}

#[test]
fn damaged_normal_maps_give_an_error_or_heights() {
    let folder = with_out();
    let colour = |x: u32, y: u32| image::Rgb([120 + (x * y % 17) as u8, 120 + ((x + y) % 17) as u8, 240]);
    let plane = |seed: usize| (0..144).map(|at| (at * seed % 29) as f32 / 40.0 + 0.1).collect::<Vec<f32>>();
    let samples = [
        ("n.png", encoded(&image::RgbImage::from_fn(12, 12, colour).into(), ImageFormat::Png)),
        ("n.exr", exr([12, 12], &[("x", plane(7)), ("y", plane(11)), ("z", plane(13))])),
    ];
    let line = |name: &str| format!("height from-normals {name} -o out/h.png --fill --max-misfit 100");
    let mut state = 0x9e37_79b9_7f4a_7c15u64;
    let mut below = |limit: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state % limit as u64) as usize
    };
    for (name, bytes) in samples {
        folder.write(name, &bytes);
        folder.relief(&line(name)).fine();
        std::fs::remove_file(folder.path("out/h.png")).expect("it was written");
        for cut in [1, 20, bytes.len() / 2, bytes.len() - 1] {
            folder.write(name, &bytes[..cut]);
            assert_refused(&folder, &folder.relief(&line(name)), 1, &[name]);
        }
        for round in 0..60 {
            let mut flipped = bytes.clone();
            let within = if round % 2 == 0 { flipped.len().min(300) } else { flipped.len() };
            for _ in 0..=below(3) {
                flipped[below(within)] ^= 1 << below(8);
            }
            folder.write(name, &flipped);
            let ran = folder.relief(&line(name));
            if ran.code == Some(0) {
                // What was damaged may be left out, which is noted.
                assert!(ran.stderr.lines().all(|said| said.starts_with("note: ")), "{}", ran.stderr);
                assert_eq!(entries(&folder.path(OUT)), ["h.png"]);
                std::fs::remove_file(folder.path("out/h.png")).expect("it was written");
            } else {
                assert_refused(&folder, &ran, 1, &[name]);
            }
        }
    }
}
