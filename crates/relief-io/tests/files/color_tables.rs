//! Tables of colours: the forms that are read, their colours beside GDAL's rules, and files that are
//! refused.

use relief_core::rng::Rng;
use relief_io::{ColorTable, ReadError, Source, TableElevation, read_color_table};

fn read(bytes: &[u8]) -> Result<ColorTable, ReadError> {
    read_color_table(Source::bytes("tints.txt", bytes))
}

fn table(text: &str) -> ColorTable {
    read(text.as_bytes()).unwrap_or_else(|error| panic!("{error} in:\n{text}"))
}

/// Example of GDAL's manual.
const MANUAL: &str = "3500   white\n2500   235:220:175\n50%   190 185 135\n700    240 250 150\n\
                      0      50  180  50\nnv     0   0   0   0\n";

/// Returns the colour of an elevation as GDAL's manual describes it: blended between the two entries
/// around it and rounded to whole numbers, or the colour of the end.
fn by_the_manual(entries: &[(f64, [i32; 3])], elevation: f64) -> [i32; 3] {
    let below = entries.iter().filter(|(at, _)| *at <= elevation).max_by(|a, b| a.0.total_cmp(&b.0));
    let above = entries.iter().filter(|(at, _)| *at >= elevation).min_by(|a, b| a.0.total_cmp(&b.0));
    match (below, above) {
        (Some((low, from)), Some((high, to))) if high > low => [0, 1, 2].map(|channel| {
            let [from, to] = [from, to].map(|color| f64::from(color[channel]));
            (0.5 + from + (to - from) * (elevation - low) / (high - low)).floor() as i32
        }),
        (Some((_, color)), _) | (None, Some((_, color))) => *color,
        (None, None) => panic!("no entries"),
    }
}

/// Returns the share of elevations whose colours, rounded, are not the manual's.
fn share_of_others(color: impl Fn(f64) -> [f64; 4]) -> f64 {
    let range = [-200.0, 3700.0];
    let middle = 0.5 * (range[0] + range[1]);
    let entries = [
        (3500.0, [255, 255, 255]),
        (2500.0, [235, 220, 175]),
        (middle, [190, 185, 135]),
        (700.0, [240, 250, 150]),
        (0.0, [50, 180, 50]),
    ];
    let mut rng = Rng::new(5);
    let count = 20_000;
    let others = (0..count).filter(|_| {
        let elevation = range[0] + (range[1] - range[0]) * rng.unit();
        let expected = by_the_manual(&entries, elevation);
        let found = color(elevation);
        (0..3).any(|channel| found[channel].round() as i32 != expected[channel])
    });
    others.count() as f64 / f64::from(count)
}

#[test]
fn colours_are_those_of_gdals_manual() {
    let ramp = table(MANUAL).ramp([-200.0, 3700.0]);
    let share = share_of_others(|elevation| ramp.color(elevation));
    assert!(share < 1e-3, "{share}");
    // The comparison notices a table with one other number, and other percentages.
    let other = table(&MANUAL.replace("175", "179")).ramp([-200.0, 3700.0]);
    assert!(share_of_others(|elevation| other.color(elevation)) > 0.1);
    let other = table(MANUAL).ramp([0.0, 3500.0 - 200.0]);
    assert!(share_of_others(|elevation| other.color(elevation)) > 0.1);
    assert_eq!(table(MANUAL).nodata(), Some([0; 4]));
}

#[test]
fn separators_comments_and_names_are_gdals() {
    let expected = table("0 255 0 0\n10 191 127 63 128\n");
    for text in [
        "0,255,0,0\n10,191,127,63,128\n",
        "0\t255\t0\t0\r\n10\t191 127\t63 128\r\n",
        "0:255:0:0\n10:191:127:63:128",
        "# a comment\n/ another\n\n  0 red\n  10 BROWN 128 # the end\n",
        "\u{feff}0, 255, 0, 0\n10, 191, 127, 63, 128\n",
        "# QGIS Generated Color Map Export File\nINTERPOLATION:INTERPOLATED\n0,255,0,0,255,low\n\
         10,191,127,63,128,very high, 10 m\n",
    ] {
        assert_eq!(table(text), expected, "{text}");
    }
    let utf16: Vec<u8> = "\u{feff}0 red\n10 brown 128\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert_eq!(read(&utf16).expect("a table"), expected);
    let of_grass = table("0% black\nNV white\n100% white\ndefault 1:2:3\n");
    assert_eq!(of_grass.entries()[1].elevation, TableElevation::Percent(100.0));
    assert_eq!((of_grass.nodata(), of_grass.outside()), (Some([255; 4]), Some([1, 2, 3, 255])));
    assert!(!of_grass.has_absolute() && !of_grass.has_opacity() && expected.has_opacity());
}

#[test]
fn palettes_of_gmt_are_read() {
    let text = "# COLOR_MODEL = RGB\n-100 0 0 255 0 200 200 255\n0 0 128 0 500 255 255 255 L\n\
                B 0 0 0\nF 255 255 255\nN 128 128 128\n";
    let ramp = table(text).ramp([-100.0, 500.0]);
    let found = [-100.0, -1e-2, 1e-2, 500.0].map(|at| ramp.color(at).map(|part| part.round() as u8));
    let expected = [[0, 0, 255, 255], [200, 200, 255, 255], [0, 128, 0, 255], [255, 255, 255, 255]];
    assert_eq!(found, expected);
    assert_eq!(table(text).nodata(), Some([128, 128, 128, 255]));
}

#[test]
fn colours_are_read_from_six_digits() {
    let text = "0 #0080ff\n100,#FFFFFF,128 # snow\nnv #010203\n200 255 0 0 #ff\n";
    let ramp = table(text).ramp([0.0, 200.0]);
    let found = [0.0, 100.0, 200.0].map(|at| ramp.color(at).map(|part| part.round() as u8));
    assert_eq!(found, [[0, 128, 255, 255], [255, 255, 255, 128], [255, 0, 0, 255]]);
    assert_eq!(table(text).nodata(), Some([1, 2, 3, 255]));
}

#[test]
fn bad_tables_are_refused_with_line_and_remedy() {
    let head = "# COLOR_MODEL = RGB\n0 0 0 0 10 1 1 1\n";
    for (text, words) in [
        ("# nothing\n\n", &["no colour", "elevation, red, green and blue"][..]),
        ("0 1 2 3\n5 6 7\n", &["line 2", "3 fields", "give"]),
        ("0 1 2 3\n5\n", &["line 2", "1 field:", "#rrggbb"]),
        ("0 #12345\n", &["line 1", "1 field"]),
        ("0 #0080ff 300\n", &["line 1", "'300'"]),
        ("0,1,,3,4\n", &["line 1", "empty field"]),
        ("0 1 2 3\nnan 1 2 3\n", &["line 2", "'nan'", "finite"]),
        ("inf red\n", &["line 1", "'inf'"]),
        ("high red\n", &["line 1", "'high'", "nv"]),
        ("0 1 2 256\n", &["line 1", "'256'", "0 to 255"]),
        ("0 1 2 -3\n", &["line 1", "'-3'"]),
        ("0 0.5 0.5 1\n", &["line 1", "'0.5'", "whole"]),
        ("0 1 2 3 999\n", &["line 1", "'999'"]),
        ("0 nan 2 3\n", &["line 1", "'nan'"]),
        ("0 1 2 3\n10 1 2 3\n\n5 1 2 3\n", &["line 4", "5 comes after 10", "sort"]),
        ("10 1 2 3\n5 1 2 3\n6 1 2 3\n", &["line 3", "6 comes after 5", "fall"]),
        ("0% red\n60% red\n50% red\n", &["line 3", "50% comes after 60%"]),
        ("120% red\n", &["line 1", "'120%'", "100%"]),
        ("nan% red\n", &["line 1", "'nan%'"]),
        ("0 gren\n", &["line 1", "gren", "green"]),
        ("INTERPOLATION:DISCRETE\n0,1,2,3,255,a\n", &["line 1", "DISCRETE", "Linear"]),
        ("# COLOR_MODEL = HSV\n", &["line 1", "HSV", "RGB"]),
        (&format!("{head}20 0 0 0 30 1 1 1\n"), &["line 3", "begins at 20", "ends at 10"]),
        (&format!("{head}10 0 0 0\n"), &["line 3", "4 fields"]),
        (&format!("{head}50% 0 0 0 60% 1 1 1\n"), &["line 3", "'50%'"]),
    ] {
        let said = read(text.as_bytes()).expect_err(text).to_string();
        assert!(words.iter().all(|word| said.contains(word)), "{text}: {said}");
        assert!(said.starts_with("tints.txt: ") && said.len() < 300, "{said}");
    }
}

#[test]
fn other_files_and_endless_ones_are_refused() {
    let png = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR";
    let many: String = (0..1_000_000).map(|at| format!("{at} red\n")).collect();
    let long = vec![b' '; 9 << 20];
    for (bytes, words) in [
        (&png[..], "no text"),
        (&b"0 red\n\xff\xfe\xfd"[..], "no text"),
        (many.as_bytes(), "at most"),
        (&many.as_bytes()[..900_000], "line 65537: tables have at most 65536 entries"),
        (&long, "9437184 bytes"),
        (b"", "is empty"),
    ] {
        let said = read(bytes).expect_err(words).to_string();
        assert!(said.contains(words), "{said}");
    }
    let folder = crate::common::Folder::new();
    let said = read_color_table(folder.path()).expect_err("a folder").to_string();
    assert!(said.contains("is a folder"), "{said}");
}
