//! Channel, range, convention, holes and limits.

use crate::common::files::{big_endian, png};
use crate::common::tiff_file::Tiff;
use crate::common::{Folder, channel, exr_file, samples};
use exr::prelude::{Compression, SampleType as ExrSample};
use png::{BitDepth, ColorType};
use relief_core::Wrap;
use relief_io::{Convention, Fill, HeightOptions, ReadProblem, inspect, read_height};

fn float_file(folder: &Folder, width: u32, values: &[f64]) -> std::path::PathBuf {
    let size = [width, values.len() as u32 / width];
    let bytes = exr_file::exr(size, None, Compression::ZIP16, &[("height", ExrSample::F32, values)]);
    folder.file("floats.exr", &bytes)
}

#[test]
fn unknown_channels_are_refused_with_a_suggestion() {
    let folder = Folder::new();
    let path = float_file(&folder, 2, &[0.0, 1.0]);
    let error = read_height(&path, &channel("hieght")).expect_err("a misspelt channel");
    match error.problem {
        ReadProblem::UnknownChannel(name) => assert_eq!(name.nearest.as_deref(), Some("height")),
        other => panic!("{other}"),
    }
}

#[test]
fn floats_map_their_extremes_unless_a_range_is_given() {
    let folder = Folder::new();
    let path = float_file(&folder, 2, &[-50.0, 150.0, 50.0, 0.0]);
    let map = read_height(&path, &HeightOptions::default()).expect("a valid map");
    assert_eq!(map.texels(), [0.0, 1.0, 0.5, 0.25]);
    assert_eq!(map.physical_range(), Some([-50.0, 150.0]));
    let ranged = |range: [f64; 2]| {
        read_height(&path, &HeightOptions { range: Some(range.into()), ..HeightOptions::default() })
    };
    let map = ranged([-250.0, 150.0]).expect("a range around the values");
    assert_eq!(map.texels(), [0.5, 1.0, 0.75, 0.625]);
    assert_eq!(map.physical_range(), Some([-250.0, 150.0]));
    match ranged([0.0, 200.0]).expect_err("a value is below the range").problem {
        ReadProblem::OutsideRange { actual, .. } => assert_eq!(actual, [-50.0, 150.0]),
        other => panic!("{other}"),
    }
    for bad in [[1.0, 1.0], [2.0, 1.0], [f64::NAN, 1.0], [0.0, f64::INFINITY]] {
        assert!(
            matches!(ranged(bad).expect_err("no range").problem, ReadProblem::BadRange { .. }),
            "{bad:?}"
        );
    }
    let constant = float_file(&folder, 2, &[7.5; 6]);
    let map = read_height(&constant, &HeightOptions::default()).expect("a flat map");
    assert_eq!((map.texels()[0], map.physical_range()), (0.0, Some([7.5, 7.5])));
}

#[test]
fn a_range_is_in_sample_values() {
    let folder = Folder::new();
    let bytes = png(3, 1, ColorType::Grayscale, BitDepth::Sixteen, &big_endian(&[1000.0, 2000.0, 3000.0]));
    let path = folder.file("range.png", &bytes);
    let options = HeightOptions { range: Some([1000.0, 3000.0].into()), ..HeightOptions::default() };
    assert_eq!(read_height(&path, &options).expect("a valid map").texels(), [0.0, 0.5, 1.0]);
}

#[test]
fn depth_is_inverted() {
    let folder = Folder::new();
    let path = float_file(&folder, 2, &[10.0, 30.0, 15.0, 20.0]);
    let options = HeightOptions { convention: Some(Convention::Depth), ..HeightOptions::default() };
    let map = read_height(&path, &options).expect("a valid map");
    assert_eq!(map.texels(), [1.0, 0.0, 0.75, 0.5]);
    assert_eq!(map.physical_range(), Some([30.0, 10.0]), "texel 0 stands for the deepest");
}

#[test]
fn holes_are_an_error_or_filled() {
    let folder = Folder::new();
    let mut values = samples(32, 16, 100.0);
    (values[37], values[38], values[300]) = (f64::NAN, f64::INFINITY, f64::NEG_INFINITY);
    let path = float_file(&folder, 32, &values);
    let error = read_height(&path, &HeightOptions::default()).expect_err("three texels have no value");
    assert!(
        matches!(
            error.problem,
            ReadProblem::Holes { not_finite: 3, nodata: 0, masked: 0, column: 5, row: 1 }
        ),
        "{error}"
    );
    let options = HeightOptions { fill: Fill::Always, wrap: Some(Wrap::Clamp), ..HeightOptions::default() };
    let map = read_height(&path, &options).expect("the holes are filled");
    assert_eq!(map.wrap(), Wrap::Clamp);
    let [least, greatest] = map.physical_range().expect("a read map has a range");
    for at in [37, 38, 300] {
        let value = least + f64::from(map.texels()[at]) * (greatest - least);
        assert!((value - samples(32, 16, 100.0)[at]).abs() < 5.0, "texel {at} is {value}");
    }
    let nothing = float_file(&folder, 4, &[f64::NAN; 8]);
    for options in [options, HeightOptions::default()] {
        let error = read_height(&nothing, &options).expect_err("no texel has a value");
        assert!(matches!(error.problem, ReadProblem::AllHoles), "{error}");
    }
}

#[test]
fn wide_types_keep_their_detail() {
    let folder = Folder::new();
    // A relief of a millimetre at ten thousand kilometres, far below the resolution of an f32 there.
    let values: Vec<f64> = samples(40, 30, 1000.0).iter().map(|s| 1e7 + s * 1e-6).collect();
    let path = folder.file("high.tif", &Tiff::grey(40, 30, 64, 3).bytes(&values));
    let map = read_height(&path, &HeightOptions::default()).expect("a valid map");
    let [least, greatest] = map.physical_range().expect("a read map has a range");
    for (texel, value) in map.texels().iter().zip(&values) {
        assert!((least + f64::from(*texel) * (greatest - least) - value).abs() < 3e-9);
    }
}

#[test]
fn memory_is_limited_by_the_option() {
    let folder = Folder::new();
    let path = float_file(&folder, 64, &samples(64, 64, 1.0));
    let limited = |max_bytes| read_height(&path, &HeightOptions { max_bytes, ..HeightOptions::default() });
    assert!(limited(64 * 64 * 8 + (1 << 16)).is_ok());
    let error = limited(64 * 64 * 8 - 1).expect_err("too little memory");
    assert!(matches!(error.problem, ReadProblem::TooMuchMemory { width: 64, height: 64, .. }), "{error}");
}

#[test]
fn inspect_counts_values_and_holes() {
    let folder = Folder::new();
    let mut values: Vec<f64> = (0..640).map(|i| f64::from(i % 64)).collect();
    (values[0], values[1]) = (f64::NAN, f64::NAN);
    let info = inspect(&float_file(&folder, 64, &values), &HeightOptions::default()).expect("a valid map");
    assert_eq!((info.width, info.height, info.channels.len()), (64, 10, 1));
    let found = info.values.expect("there is one channel");
    assert_eq!((found.range, found.levels, found.not_finite, found.nodata), (Some([0.0, 63.0]), 64, 2, 0));
    assert_eq!(found.histogram[0], 9, "one of ten is NaN");
    assert_eq!(found.histogram.iter().sum::<u64>(), 638);
    assert_eq!(found.tiling, None);

    let tiling = |values: &[f64]| {
        let info = inspect(&float_file(&folder, 64, values), &HeightOptions::default()).expect("a valid map");
        info.values.and_then(|values| values.tiling).expect("every texel has a value").tiles
    };
    let turn = |i: usize| (std::f64::consts::TAU * i as f64 / 64.0).sin();
    let wave: Vec<f64> = (0..64 * 64).map(|at| turn(at % 64) + turn(at / 64)).collect();
    assert_eq!(tiling(&wave), [true, true]);
    let ramp: Vec<f64> = (0..64 * 64).map(|at| turn(at % 64) + (at / 64) as f64).collect();
    assert_eq!(tiling(&ramp), [true, false]);

    let colour: Vec<u8> = (0..=255).flat_map(|i| [i, 255 - i, 7]).collect();
    let path = folder.file("colour.png", &png(16, 16, ColorType::Rgb, BitDepth::Eight, &colour));
    let info = inspect(&path, &HeightOptions::default()).expect("a picture");
    assert_eq!(info.values, None);
    let names: Vec<&str> = info.channels.iter().map(|channel| channel.name.as_str()).collect();
    assert_eq!(names, ["r", "g", "b"]);
    let green = inspect(&path, &channel("g")).expect("a picture").values.expect("a channel was chosen");
    assert_eq!((green.normalised_range, green.range), (Some([0.0, 255.0]), Some([0.0, 255.0])));
}
