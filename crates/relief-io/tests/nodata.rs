//! Values of texels without one: as the file declares them, and as they are given.

mod common;

use std::path::Path;

use common::files::png;
use common::tiff_file::{Tiff, Value};
use common::{Folder, default};
use png::{BitDepth, ColorType};
use relief_core::HeightMap;
use relief_io::{Fill, HeightOptions, HeightRange, ReadProblem, Values, inspect, read_height};

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
fn opacity_is_stored_as_it_is_where_white_is_zero() {
    let folder = Folder::new();
    let texels: Vec<f64> = (0..16).flat_map(|at| [f64::from(at), f64::from(100 + at)]).collect();
    let extra = vec![(338, Value::Short(vec![2]))];
    let tiff = Tiff { bands: 2, photometric: 0, extra, ..Tiff::grey(4, 4, 8, 1) };
    let path = folder.file("alpha.tif", &tiff.bytes(&texels));
    let range = |channel| look(&path, &common::channel(channel)).range;
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
    // What differs in more than its digits is another value.
    let tiff = Tiff { extra: nodata("-9999"), ..Tiff::grey(16, 8, 32, 3) };
    let found = look(&folder.file("dem.tif", &tiff.bytes(&ground(-9998.0))), &default());
    assert_eq!((found.nodata, found.range), (0, Some([-9998.0, 400.0])));
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
    // Both the file's and the one that is given have none.
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
