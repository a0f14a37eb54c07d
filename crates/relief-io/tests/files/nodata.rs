//! Nodata values: declared by the file, or given by the user.

use std::path::{Path, PathBuf};

use crate::common::files::png;
use crate::common::tiff_file::{Tiff, Value};
use crate::common::{Folder, default};
use png::{BitDepth, ColorType};
use relief_core::HeightMap;
use relief_io::{
    Fill, HeightOptions, HeightRange, ReadProblem, Values, inspect, read_height, read_height_file,
};

/// The tag of GDAL's nodata value.
fn nodata(text: &str) -> Vec<(u16, Value)> {
    vec![(42113, Value::Text(text.to_owned()))]
}

/// The values of a file's heights.
fn look(path: &Path, options: &HeightOptions) -> Values {
    let info = inspect(path, options).unwrap_or_else(|error| panic!("{error}"));
    info.values.expect("one channel holds the heights")
}

/// A map whose holes are filled.
fn filled(path: &Path, options: &HeightOptions) -> HeightMap {
    let options = HeightOptions { fill: Fill::Always, ..options.clone() };
    read_height(path, &options).unwrap_or_else(|error| panic!("{error}"))
}

/// Ground of 100 to 400 with a hole of six texels.
fn ground(hole: f64) -> Vec<f64> {
    let height = |at: u32| 100.0 + f64::from(at % 16 * 20);
    (0..16 * 8).map(|at| if matches!(at, 20..23 | 36..39) { hole } else { height(at) }).collect()
}

fn given(nodata: f64) -> HeightOptions {
    HeightOptions { nodata: Some(nodata), ..default() }
}

#[test]
fn where_white_is_zero_the_stored_number_is_compared() {
    let folder = Folder::new();
    // Column `i` stores `i` times the step.
    let ramp = |step: u32| -> Vec<f64> {
        (0..8).flat_map(|_| (0..256).map(move |column| f64::from(column * step))).collect()
    };
    for (bits, step, marker, photometric, range) in [
        (8, 1, 0, 0, [0.0, 254.0]),
        (8, 1, 255, 0, [1.0, 255.0]),
        (8, 1, 10, 0, [0.0, 255.0]),
        (8, 1, 0, 1, [1.0, 255.0]),
        (16, 257, 0, 0, [0.0, 65278.0]),
        (16, 257, 65535, 0, [257.0, 65535.0]),
    ] {
        let extra = nodata(&marker.to_string());
        let tiff = Tiff { photometric, extra, ..Tiff::grey(256, 8, bits, 1) };
        let path = folder.file("ramp.tif", &tiff.bytes(&ramp(step)));
        let found = look(&path, &default());
        assert_eq!((found.nodata, found.range), (8, Some(range)), "{bits} bits, {marker}");
        // The same number given for a file that declares none.
        let plain = Tiff { extra: Vec::new(), ..tiff.clone() };
        let path = folder.file("plain.tif", &plain.bytes(&ramp(step)));
        let found = look(&path, &given(f64::from(marker)));
        assert_eq!((found.nodata, found.range), (8, Some(range)), "{bits} bits, {marker} given");
        let map = filled(&path, &given(f64::from(marker)));
        let column = marker / step;
        let is_hole = |i: u32, j: u32| map.holes().is_some_and(|holes| holes.contains(i, j));
        assert!((0..8).all(|row| is_hole(column, row)), "{bits} bits, {marker}");
        assert_eq!(map.filled_texels(), 8);
    }
    // In a picture of two levels half of the texels are left.
    for (bits, levels) in [(1u16, 2u32), (2, 4), (4, 16)] {
        let texels: Vec<f64> = (0..128).map(|at| f64::from(at % 16 % levels)).collect();
        let tiff = Tiff { photometric: 0, extra: nodata("0"), ..Tiff::grey(16, 8, bits, 1) };
        let found = look(&folder.file("bits.tif", &tiff.bytes(&texels)), &default());
        assert_eq!((found.nodata, found.levels), (u64::from(128 / levels), u64::from(levels - 1)), "{bits}");
        assert_eq!(found.range, Some([0.0, f64::from(levels - 2)]), "{bits} bits");
    }
}

#[test]
fn opacity_is_not_inverted_if_white_is_zero() {
    let folder = Folder::new();
    let texels: Vec<f64> = (0..16).flat_map(|at| [f64::from(at), f64::from(100 + at)]).collect();
    let extra = vec![(338, Value::Short(vec![2]))];
    let tiff = Tiff { bands: 2, photometric: 0, extra, ..Tiff::grey(4, 4, 8, 1) };
    let path = folder.file("alpha.tif", &tiff.bytes(&texels));
    let range = |channel| look(&path, &crate::common::channel(channel)).range;
    assert_eq!([range("y"), range("a")], [Some([240.0, 255.0]), Some([100.0, 115.0])]);
}

#[test]
fn a_declared_value_need_not_have_the_digits_that_are_stored() {
    let folder = Folder::new();
    for (bits, declared, stored) in [
        (32, "-3.39999999999999996e+38", f64::from(f32::MIN)),
        (32, "-3.4028235e+38", f64::from(f32::MIN)),
        (32, "1.70141e+38", 1.701_410_009_187_828e38),
        (32, "9.97e+36", 9.969_209_968_386_869e36),
        (64, "-3.40282346638529e+38", f64::from(f32::MIN)),
        (64, "-1.79e+308", f64::MIN),
        (64, "-9999.9", f64::from(-9999.9f32)),
    ] {
        let tiff = Tiff { extra: nodata(declared), ..Tiff::grey(16, 8, bits, 3) };
        let path = folder.file("dem.tif", &tiff.bytes(&ground(stored)));
        let found = look(&path, &default());
        assert_eq!((found.nodata, found.not_finite), (6, 0), "{declared}");
        assert_eq!(found.range, Some([100.0, 400.0]), "{declared}");
    }
    // A value that differs in more than its last digits is another value.
    let tiff = Tiff { extra: nodata("-9999"), ..Tiff::grey(16, 8, 32, 3) };
    let found = look(&folder.file("dem.tif", &tiff.bytes(&ground(-9990.0))), &default());
    assert_eq!((found.nodata, found.range), (0, Some([-9990.0, 400.0])));
}

#[test]
fn a_value_is_given_for_files_of_all_types() {
    let folder = Folder::new();
    for (bits, format, hole) in [
        (8, 1, 0.0),
        (16, 1, 65535.0),
        (32, 1, 4_294_967_295.0),
        (16, 2, -32768.0),
        (32, 2, -2_147_483_648.0),
        (32, 3, -9999.0),
        (64, 3, -99999.0),
    ] {
        let values: Vec<f64> =
            ground(hole).iter().map(|value| if bits == 8 { value / 2.0 } else { *value }).collect();
        let path = folder.file("map.tif", &Tiff::grey(16, 8, bits, format).bytes(&values));
        assert_eq!(look(&path, &default()).nodata, 0);
        let map = filled(&path, &HeightOptions { range: Some(HeightRange::Extremes), ..given(hole) });
        let low = if bits == 8 { 50.0 } else { 100.0 };
        assert_eq!((map.filled_texels(), map.physical_range()), (6, Some([low, 4.0 * low])), "{hole}");
        // A file whose value is given is expected to have holes.
        let elevation = HeightOptions { fill: Fill::Elevation, ..given(hole) };
        assert!(read_height(&path, &elevation).is_ok_and(|map| map.filled_texels() == 6));
        let error = read_height(&path, &given(hole)).expect_err("holes are not to be filled");
        assert!(matches!(error.problem, ReadProblem::Holes { nodata: 6, column: 4, row: 1, .. }), "{error}");
        // Others stay as they are.
        assert_eq!(look(&path, &given(77.5)).nodata, 0);
    }
    // Both the file's nodata value and the given one count.
    let tiff = Tiff { extra: nodata("100"), ..Tiff::grey(16, 8, 16, 1) };
    let path = folder.file("map.tif", &tiff.bytes(&ground(7.0)));
    assert_eq!((look(&path, &default()).nodata, look(&path, &given(7.0)).nodata), (8, 14));
    let texels: Vec<u8> = (0..64).map(|at| if at < 5 { 255 } else { at }).collect();
    let path = folder.file("map.png", &png(8, 8, ColorType::Grayscale, BitDepth::Eight, &texels));
    assert_eq!(filled(&path, &given(255.0)).filled_texels(), 5);
    let everywhere = folder.file("all.png", &png(8, 8, ColorType::Grayscale, BitDepth::Eight, &[9; 64]));
    let error = read_height(&everywhere, &given(9.0)).expect_err("nothing is left");
    assert!(matches!(error.problem, ReadProblem::AllHoles), "{error}");
}

#[test]
fn a_range_by_the_extremes_leaves_holes_out() {
    let folder = Folder::new();
    let texels: Vec<u8> = (0..64).map(|at| if at == 9 { 0 } else { 44 + at % 26 }).collect();
    let path = folder.file("map.png", &png(8, 8, ColorType::Grayscale, BitDepth::Eight, &texels));
    let auto = HeightOptions { range: Some(HeightRange::Extremes), ..default() };
    let extremes = |options: &HeightOptions| {
        let map = filled(&path, options);
        (map.physical_range(), map.extremes())
    };
    assert_eq!(extremes(&auto), (Some([0.0, 69.0]), [0.0, 1.0]));
    let without = HeightOptions { nodata: Some(0.0), ..auto };
    assert_eq!(extremes(&without), (Some([44.0, 69.0]), [0.0, 1.0]));
    let level = folder.file("level.png", &png(8, 8, ColorType::Grayscale, BitDepth::Eight, &[9; 64]));
    assert_eq!(filled(&level, &without).extremes(), [0.0, 0.0]);
}

/// Notes of reading a file: rows of the table, and the values of options that change the reading.
fn notes(path: &Path, options: &HeightOptions) -> Vec<(&'static str, Option<String>)> {
    let options = HeightOptions { fill: Fill::Always, ..options.clone() };
    let of_map = read_height_file(path, &options).unwrap_or_else(|error| panic!("{error}")).notes;
    let of_look = inspect(path, &options).unwrap_or_else(|error| panic!("{error}")).notes;
    assert_eq!(of_map, of_look, "{}", path.display());
    of_map.into_iter().map(|note| (note.remark.row.name, note.remark.mend)).collect()
}

/// A file of 16 x 8 texels.
fn map(folder: &Folder, bits: u16, format: u16, values: &[f64]) -> PathBuf {
    folder.file("map.tif", &Tiff::grey(16, 8, bits, format).bytes(values))
}

#[test]
fn outlying_values_have_a_note_as_likely_nodata() {
    let folder = Folder::new();
    let auto = HeightOptions { range: Some(HeightRange::Extremes), ..default() };
    for (bits, format, hole, low, step) in [
        (32, 3, -9999.0, 100.0, 20.0),
        (16, 2, -32768.0, 100.0, 20.0),
        (32, 3, f64::from(f32::MIN), -50.0, 3.0),
        (32, 3, 1.701_410_009_187_828e38, 0.0, 1e-3),
        (16, 1, 65535.0, 100.0, 20.0),
        (32, 3, 9999.0, 0.0, 30.0),
        (64, 3, -99999.0, 1500.5, 20.25),
        (32, 2, -2_147_483_648.0, 0.0, 1.0),
        (16, 1, 0.0, 5000.0, 20.0),
        (8, 1, 255.0, 44.0, 1.0),
        (64, 3, f64::from(f32::MIN), 100.0, 20.0),
        (32, 3, -5000.0, 3.0, 0.5),
    ] {
        let height = |at: usize| low + step * ((at * 7) % 16) as f64;
        let is_hole = |at: &usize| matches!(at, 0..3 | 16..19);
        let values: Vec<f64> = (0..16 * 8).map(|at| if is_hole(&at) { hole } else { height(at) }).collect();
        let path = map(&folder, bits, format, &values);
        let found = notes(&path, &auto);
        let [("undeclared-nodata", Some(mend))] = &found[..] else { panic!("{hole}: {found:?}") };
        // The note's number works as the option.
        let mended = HeightOptions { nodata: mend.parse().ok(), ..auto.clone() };
        assert_eq!(notes(&path, &mended), [], "{hole}");
        let map = filled(&path, &mended);
        assert_eq!(map.filled_texels(), 6, "{hole}: {mend}");
        let [least, greatest] = map.physical_range().expect("a range");
        assert!((least - low).abs() < 1e-4 && (greatest - low - 15.0 * step).abs() < 1e-4, "{hole}");
    }
    // Both ends, and two numbers at one end.
    for (marks, count) in [([-9999.0, 9999.0], 2), ([-9999.0, -32768.0], 2), ([-9999.0, -9998.99], 2)] {
        let values: Vec<f64> = ground(marks[0]).into_iter().collect();
        let values: Vec<f64> =
            values.iter().enumerate().map(|(at, value)| if at > 125 { marks[1] } else { *value }).collect();
        let path = map(&folder, 32, 3, &values);
        let note = read_height_file(&path, &auto).expect("a map").notes.pop().expect("a note");
        assert_eq!(note.remark.mend.as_deref(), Some("-9999"), "{note}");
        assert_eq!(note.remark.text.matches("texels have").count(), count, "{note}");
    }
    // If white is stored as 0, the note has the stored number.
    let values: Vec<f64> = ground(65535.0);
    let tiff = Tiff { photometric: 0, ..Tiff::grey(16, 8, 16, 1) };
    let path = folder.file("white.tif", &tiff.bytes(&values));
    assert_eq!(notes(&path, &auto), [("undeclared-nodata", Some("65535".to_owned()))]);
}

/// The value at a texel.
type Shape = fn(u32, u32) -> f64;

#[test]
fn sound_elevation_models_are_read_without_notes() {
    let folder = Folder::new();
    let auto = HeightOptions { range: Some(HeightRange::Extremes), ..default() };
    let shapes: [(&str, Shape); 10] = [
        ("two levels", |i, j| if (i / 4 + j / 4) % 2 == 0 { 0.0 } else { 255.0 }),
        ("steps", |i, _| f64::from(i / 4) * 80.0),
        ("letters", |i, j| if (i + j) % 5 == 0 { 200.0 + f64::from(i * 3) } else { 0.0 }),
        ("a ramp", |i, j| f64::from(i * 8 + j)),
        ("level", |_, _| 7.0),
        ("a pole", |i, j| if (i, j) == (5, 5) { 255.0 } else { f64::from(i + j) }),
        ("a sea", |i, j| f64::from((i * i * j).saturating_sub(90)).min(255.0)),
        ("a cliff", |i, j| if i < 8 { f64::from(j * 4) } else { 180.0 + f64::from(j * 4) }),
        ("noise", |i, j| f64::from((i * 7919 + j * 104_729) % 251)),
        ("a wall", |i, _| if i == 7 { 250.0 } else { 10.0 }),
    ];
    for (name, shape) in shapes {
        let values: Vec<f64> = (0..8).flat_map(|j| (0..16).map(move |i| shape(i, j))).collect();
        for (bits, format) in [(8, 1), (16, 1), (16, 2), (32, 3)] {
            assert_eq!(notes(&map(&folder, bits, format, &values), &auto), [], "{name}, {bits} bits");
        }
    }
    // Those that the project ships.
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data");
    for name in ["bricks", "cobbles", "jacksboro", "logo", "noise", "spikes"] {
        assert_eq!(notes(&shipped.join(name).with_extension("png"), &default()), [], "{name}");
    }
}

#[test]
fn lossily_changed_nodata_values_are_holes() {
    let folder = Folder::new();
    // Values after LERC with a tolerance of half a metre, in blocks with different least values.
    for (declared, stored) in [
        ("9999", [9998.985, 9999.4]),
        ("-9999", [-9998.7, -9999.0]),
        ("-32768", [-32767.5, -32768.25]),
        ("99999", [99998.0, 99998.0]),
    ] {
        let values: Vec<f64> = ground(stored[0]);
        let values: Vec<f64> =
            values.iter().enumerate().map(|(at, value)| if at > 125 { stored[1] } else { *value }).collect();
        let tiff = Tiff { extra: nodata(declared), ..Tiff::grey(16, 8, 32, 3) };
        let path = folder.file("lossy.tif", &tiff.bytes(&values));
        assert_eq!(notes(&path, &default()), [("near-nodata", None)], "{declared}");
        let found = look(&path, &default());
        assert_eq!((found.nodata, found.range), (8, Some([100.0, 400.0])), "{declared}");
        let error = read_height(&path, &default()).expect_err("holes are not to be filled");
        assert!(matches!(error.problem, ReadProblem::Holes { nodata: 8, column: 4, row: 1, .. }), "{error}");
        // The same where the value is given.
        let plain = folder.file("plain.tif", &Tiff::grey(16, 8, 32, 3).bytes(&values));
        let options = given(declared.parse().expect("a number"));
        assert_eq!(
            (notes(&plain, &options), look(&plain, &options).nodata),
            (vec![("near-nodata", None)], 8)
        );
    }
    // Heights that are near the declared value are heights.
    let values: Vec<f64> = (0..128).map(|at| 9998.0 + f64::from(at) / 128.0).collect();
    let tiff = Tiff { extra: nodata("9999"), ..Tiff::grey(16, 8, 32, 3) };
    let path = folder.file("high.tif", &tiff.bytes(&values));
    assert_eq!((notes(&path, &default()), look(&path, &default()).nodata), (Vec::new(), 0));
}

#[test]
fn an_absent_given_nodata_value_has_a_note() {
    let folder = Folder::new();
    for (bits, format, absent) in [(32, 3, -32767.0), (8, 1, -1.0), (16, 1, 0.5), (16, 2, 1e9)] {
        let values: Vec<f64> = (0..128).map(f64::from).collect();
        let path = map(&folder, bits, format, &values);
        let range = Some(HeightRange::Extremes);
        assert_eq!(notes(&path, &HeightOptions { range, ..given(absent) }), [("absent-nodata", None)]);
    }
}

#[test]
fn narrow_ranges_have_a_note() {
    let folder = Folder::new();
    for (bits, photometric, [least, greatest]) in [
        (8, 1, [44u32, 69]),
        (8, 1, [0, 25]),
        (8, 1, [250, 255]),
        (8, 0, [44, 69]),
        (16, 1, [0, 255]),
        (16, 1, [30000, 36000]),
        (16, 0, [60000, 65535]),
        (16, 1, [100, 101]),
    ] {
        let span = greatest - least;
        let height = |at: u32| f64::from(least) + (f64::from(span * at) / 127.0).round();
        let values: Vec<f64> = (0..128).map(height).collect();
        let tiff = Tiff { photometric, ..Tiff::grey(16, 8, bits, 1) };
        let path = folder.file("map.tif", &tiff.bytes(&values));
        let [low, high] = look(&path, &default()).range.expect("a range");
        assert_eq!(notes(&path, &default()), [("narrow-range", Some(format!("{low},{high}")))], "{least}");
        for range in ["auto".to_owned(), format!("{low},{high}")] {
            let options = HeightOptions { range: range.parse().ok(), ..default() };
            assert_eq!((notes(&path, &options), filled(&path, &options).extremes()), (vec![], [0.0, 1.0]));
        }
    }
    // No notes: a tenth of the range, metres, and floats, whose extremes are used.
    for (bits, format, extra, greatest) in [
        (8, 1, vec![], 26.0),
        (16, 1, vec![], 6554.0),
        (16, 1, vec![(33550, Value::Double(vec![2.0, 2.0, 0.0]))], 300.0),
        (32, 3, vec![], 20.0),
    ] {
        let values: Vec<f64> = (0..128).map(|at| (f64::from(at) * greatest / 127.0).round()).collect();
        let tiff = Tiff { extra, ..Tiff::grey(16, 8, bits, format) };
        assert_eq!(notes(&folder.file("map.tif", &tiff.bytes(&values)), &default()), [], "{greatest}");
    }
}

#[test]
fn fitted_ranges_of_fractions_have_a_note() {
    let folder = Folder::new();
    let fractions = |low: f64, high: f64| -> Vec<f64> {
        (0..128).map(|at| low + (high - low) * f64::from(at) / 127.0).collect()
    };
    let expected = vec![("fitted-range", Some("0,1".to_owned()))];
    for (low, high, said) in [
        (0.1, 0.9, true),
        (0.0, 0.5, true),
        (0.4, 0.6, true),
        (0.02, 0.98, false),
        (-0.1, 0.5, false),
        (0.0, 2.0, false),
    ] {
        let path = map(&folder, 32, 3, &fractions(low, high));
        let expected = if said { expected.clone() } else { Vec::new() };
        assert_eq!(notes(&path, &default()), expected, "{low} to {high}");
    }
    let path = map(&folder, 32, 3, &fractions(0.1, 0.9));
    let whole = HeightOptions { range: Some([0.0, 1.0].into()), ..default() };
    assert_eq!(notes(&path, &whole), []);
    // The picture in integers, which has the same depth then.
    let integers: Vec<f64> = fractions(0.1, 0.9).iter().map(|value| (value * 65535.0).round()).collect();
    let [float, integer] = [filled(&path, &whole), filled(&map(&folder, 16, 1, &integers), &default())]
        .map(|map| map.extremes());
    assert!((0..2).all(|end| (float[end] - integer[end]).abs() < 1e-4), "{float:?} {integer:?}");
}
