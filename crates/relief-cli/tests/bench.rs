//! `relief bench`: what it tells, and what it refuses.

mod common;

use common::command::{Folder, json_of};
use common::maps::Map;
use common::refused::{assert_refused, with_out};

const SMALL: &str = "--size 16x12 --frames 3 --warm 0 --backend cpu";

#[test]
fn frames_of_every_method_have_their_parts() {
    let folder = Folder::new();
    folder.write("map.png", Map::constant(0.5).png());
    let line = format!("bench --height map.png --methods bump,relief,vertex {SMALL}");
    let answer = json_of(&folder.relief(&format!("{line} --json")).fine());
    let pictures = answer["pictures"].as_array().expect("records");
    assert_eq!((pictures.len(), answer["rays"].as_array().map(Vec::len)), (3, Some(0)));
    for record in pictures {
        let ms = |key: &str| record[key].as_f64().expect("a number");
        assert_eq!((&record["timed_size"][0], &record["clock"]), (&16.into(), &"wall".into()));
        assert!(ms("frame_ms") > 0.0 && ms("frame_low_ms") <= ms("frame_ms"), "{record}");
        assert!(ms("frame_ms") <= ms("frame_high_ms") && ms("base_ms") > 0.0, "{record}");
    }
    let ran = folder.relief(&line).fine();
    assert!(ran.stdout.contains("vertex") && ran.stdout.contains("thread"));
}

#[test]
fn what_cannot_be_timed_is_told() {
    let folder = with_out();
    folder.write("map.png", Map::constant(0.5).png());
    let refused = [
        ("--frames 0", 2, "--frames"),
        ("--frames -1", 2, "--frames"),
        ("--warm x", 2, "--warm"),
        ("--methods conee", 2, "cone"),
        ("--method cone", 2, "--methods"),
        ("--size 0x0", 2, "--size"),
        ("--height missing.png", 1, "missing.png"),
    ];
    for (flags, code, word) in refused {
        let map = if flags.contains("--height") { "" } else { "--height map.png" };
        let ran = folder.relief(&format!("bench {map} --backend cpu {flags}"));
        assert_refused(&folder, &ran, code, &[word]);
    }
}
