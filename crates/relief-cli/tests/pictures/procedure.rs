//! `relief height procedure`: formulas fill height maps, also in motion.

use crate::common::command::json_of;
use crate::common::refused::{OUT, assert_refused, entries, with_out};
use relief_core::Wrap;
use relief_io::read_height;

#[test]
fn a_map_is_the_procedure_with_its_settings() {
    let folder = with_out();
    let line =
        "height procedure fbm --set octaves=3 --seed 5 --time 0.25 --size 40x24 --scale 12cm --wgsl fbm.wgsl";
    let about = json_of(&folder.relief(&format!("{line} --json -o fbm.exr")).fine());
    assert_eq!((about["settings"]["octaves"].as_f64(), about["tile_m"][1].as_f64()), (Some(3.0), Some(0.6)));
    let map = read_height(&folder.path("fbm.exr"), &Default::default()).expect("a map");
    assert_eq!((map.width(), map.height(), map.wrap()), (40, 24, Wrap::Repeat));
    let said = json_of(&folder.relief("inspect fbm.exr --json").fine()).to_string();
    assert!(said.contains("0.12"), "{said}");
    let mut procedure = relief_shaders::procedure::Procedure::named("fbm").expect("a listed name");
    procedure.set("octaves", 3.0).expect("a setting");
    let expected = procedure.with_seed(5).at_time(0.25).fill([40, 24]).expect("a map");
    // The heights go from 0 to 1.
    let [low, high] =
        [f32::min, f32::max].map(|of| expected.texels().iter().copied().reduce(of).expect("heights"));
    for (read, height) in map.texels().iter().zip(expected.texels()) {
        assert!((low + read * (high - low) - height).abs() < 1e-6, "{read} {height}");
    }
    let wgsl = std::fs::read_to_string(folder.path("fbm.wgsl")).expect("the formula");
    assert!(wgsl.contains("fn procedure_fbm("), "{wgsl}");
    // Another number of threads gives the same bytes.
    folder.relief(&format!("{line} --threads 1 -o again.exr")).fine();
    let bytes = |name: &str| std::fs::read(folder.path(name)).expect("a file");
    assert!(bytes("fbm.exr") == bytes("again.exr"));
}

#[test]
fn frames_go_once_around_and_are_rendered_as_frames() {
    let folder = with_out();
    folder.relief("height procedure waves --frames 3..6 --size 32x32 -o w_%02d.png").fine();
    for (number, time) in [(3, 0.0), (4, 0.25), (5, 0.5), (6, 0.75)] {
        folder.relief(&format!("height procedure waves --time {time} --size 32x32 -o one.png")).fine();
        let bytes = |name: &str| std::fs::read(folder.path(name)).expect("a file");
        assert!(bytes("one.png") == bytes(&format!("w_{number:02}.png")), "frame {number}");
    }
    let line = "render --height w_%02d.png --frames 3..6 --size 24x24 --backend cpu -o out/%d.png -q";
    folder.relief(line).fine();
    let pictures: Vec<Vec<u8>> =
        (3..=6).map(|n| std::fs::read(folder.path(format!("out/{n}.png"))).expect("a picture")).collect();
    assert!(pictures.windows(2).all(|pair| pair[0] != pair[1]), "it moves");
}

#[test]
fn what_cannot_be_filled_is_refused_and_leaves_nothing() {
    let folder = with_out();
    for (flags, code, words) in [
        ("wave -o out/a.png", 2, &["waves", "did you mean"][..]),
        ("waves -o out/a.jpg", 2, &["jpg", "png"]),
        ("waves -o out/a_%d.png", 2, &["--frames"]),
        ("waves --frames 0..3 -o out/a.png", 2, &["%04d"]),
        ("waves --set octaves=3 -o out/a.png", 2, &["octaves", "sharpness"]),
        ("fbm --set octaves=1.5 -o out/a.png", 2, &["octaves", "whole number"]),
        ("fbm --set gain -o out/a.png", 2, &["NAME=VALUE"]),
        ("bumps --size 0x9 -o out/a.png", 2, &["--size"]),
        ("bumps --size 4000000x4000000 -o out/a.png", 2, &["--size"]),
        ("bumps --size 4096x4096 --max-memory 1MiB -o out/a.png", 1, &["MiB", "--max-memory"]),
        ("bumps --time NaN -o out/a.png", 2, &["--time"]),
        ("bumps --scale 0 -o out/a.png", 2, &["--scale"]),
        ("bumps --wgsl out/a.png -o out/a.png", 2, &["two outputs"]),
        ("bumps -o nowhere/a.png", 1, &["no folder"]),
    ] {
        let ran = folder.relief(&format!("height procedure {flags}"));
        assert_refused(&folder, &ran, code, words);
        assert_eq!(entries(&folder.path(OUT)), Vec::<String>::new(), "{flags}");
    }
}
