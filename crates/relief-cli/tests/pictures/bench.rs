//! `relief bench`: report and refusals.

use crate::common::command::{Folder, json_of};
use crate::common::maps::Map;
use crate::common::refused::{assert_refused, with_out};

const SMALL: &str = "--size 16x12 --frames 3 --warm 0 --backend cpu";

#[test]
fn frames_of_every_method_have_their_parts() {
    let folder = Folder::new();
    folder.write("map.png", Map::constant(0.5).png());
    let line = format!("bench --height map.png --methods bump,relief,vertex {SMALL}");
    let answer = json_of(&folder.relief(&format!("{line} --json")).fine());
    let pictures = answer["pictures"].as_array().expect("records");
    assert_eq!(answer["about"]["command"], format!("relief {line} --json"));
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
fn medians_are_sure_from_six_frames_on() {
    let folder = Folder::new();
    folder.write("map.png", Map::hills().png());
    let line = "bench --height map.png --methods bump,relief --backend cpu --size 16x12 --warm 0 --frames";
    for (frames, confidence) in [(1, 0.0), (2, 0.5), (3, 0.75), (5, 0.9375), (6, 0.95), (9, 0.95)] {
        let answer = json_of(&folder.relief(&format!("{line} {frames} --json")).fine());
        for record in answer["pictures"].as_array().expect("records") {
            assert_eq!(record["confidence"], confidence, "{frames}");
            // Times that may be 0 are marked, and so is everything below the noise.
            let noise: Vec<&str> = record["below_noise"]
                .as_array()
                .expect("keys")
                .iter()
                .filter_map(|key| key.as_str())
                .collect();
            for key in ["displacement_ms", "shade_ms", "shadow_ms"] {
                let ms = record[key].as_f64().expect("a number");
                assert!(ms > 0.0 || noise.contains(&key), "{key} of {record}");
            }
            let low = record["displacement_low_ms"].as_f64().expect("a number");
            assert_eq!(noise.contains(&"displacement_ms"), low <= 0.0, "{record}");
        }
        let said = folder.relief(&format!("{line} {frames}")).fine().stdout;
        let rows: Vec<Vec<&str>> = said
            .lines()
            .filter(|row| row.starts_with("| bump") || row.starts_with("| relief"))
            .map(|row| row.split('|').map(str::trim).collect())
            .collect();
        assert_eq!(rows.len(), 2, "{said}");
        for row in rows {
            assert_eq!([row[4] == "-", row[9] == "-"], [frames < 6; 2], "{said}");
        }
        assert_eq!(said.contains("--frames 6"), frames < 6, "{said}");
    }
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
