//! EXR, TIFF and GeoTIFF files, written by the test, give the heights that were put in.

mod common;

use ::exr::prelude::SampleType as ExrSample;
use common::tiff_file::{Tiff, Value};
use common::{Folder, SIZE, assert_reads, channel, default, exr_file, samples};
use relief_io::{Fill, HeightOptions, ReadProblem, read_height};

#[test]
fn exr_of_every_compression_type_and_layout() {
    let folder = Folder::new();
    let [width, height] = SIZE;
    let values: Vec<f64> = samples(width, height, 1000.0).iter().map(|s| s / 1000.0).collect();
    let whole = samples(width, height, 3e9);
    for (name, compression, lossy) in exr_file::COMPRESSIONS {
        for tile in [None, Some([16, 16]), Some([64, 7])] {
            let channels: [exr_file::Samples<'_>; 3] = [
                ("half", ExrSample::F16, &values),
                ("single", ExrSample::F32, &values),
                ("whole", ExrSample::U32, &whole),
            ];
            let file = format!("{name}-{}.exr", tile.is_some());
            let path = folder.file(&file, &exr_file::exr(SIZE, tile, compression, &channels));
            assert_reads(&path, &channel("half"), &values, 5e-4 + lossy);
            assert_reads(&path, &channel("single"), &values, 1e-7 + lossy);
            assert_reads(&path, &channel("whole"), &whole, 3e9 / 16e6);
            let error = read_height(&path, &default()).expect_err("no channel stands out");
            assert!(matches!(error.problem, ReadProblem::ChooseChannel { .. }), "{error}");
        }
    }
}

#[test]
fn exr_channels_parts_and_levels() {
    let folder = Folder::new();
    let values: Vec<f64> = samples(61, 37, 1000.0).iter().map(|s| s / 1000.0).collect();
    let other: Vec<f64> = values.iter().map(|value| 1.0 - value).collect();
    let none = ::exr::prelude::Compression::Uncompressed;
    let path = folder.file("y.exr", &exr_file::exr(SIZE, None, none, &[("Y", ExrSample::F32, &values)]));
    assert_reads(&path, &default(), &values, 1e-7);
    assert_reads(&path, &channel("luminance"), &values, 1e-7);
    let grey = ["R", "G", "B"].map(|name| (name, ExrSample::F16, values.as_slice()));
    let path = folder.file("grey.exr", &exr_file::exr(SIZE, None, none, &grey));
    assert_reads(&path, &default(), &values, 5e-4);

    let first: [exr_file::Samples<'_>; 1] = [("height", ExrSample::F32, &values)];
    let second: [exr_file::Samples<'_>; 1] = [("height", ExrSample::F32, &other)];
    let path = folder.file("parts.exr", &exr_file::two_parts((SIZE, &first), (SIZE, &second)));
    assert_reads(&path, &channel("base.height"), &values, 1e-7);
    assert_reads(&path, &channel("extra.height"), &other, 1e-7);
    let path = folder
        .file("sizes.exr", &exr_file::two_parts((SIZE, &first), ([1, 1], &[("z", ExrSample::F32, &[0.0])])));
    let error = read_height(&path, &channel("base.height")).expect_err("its parts differ in size");
    assert!(matches!(error.problem, ReadProblem::Unsupported { .. }), "{error}");

    let path = folder.file("levels.exr", &exr_file::with_levels(SIZE, &values));
    assert_reads(&path, &default(), &values, 1e-7);
}

#[test]
fn tiff_of_every_type_and_layout() {
    let folder = Folder::new();
    let [width, height] = SIZE;
    for (bits, format, maximum) in [
        (8, 1, 255.0),
        (16, 1, 65535.0),
        (32, 1, 4e9),
        (64, 1, 1e15),
        (8, 2, 100.0),
        (16, 2, 30000.0),
        (32, 2, 2e9),
        (64, 2, 1e15),
        (32, 3, 1.0),
        (64, 3, 1.0),
    ] {
        let mut values = samples(width, height, if format == 3 { 1000.0 } else { maximum });
        if format == 3 {
            values.iter_mut().for_each(|value| *value /= 1000.0);
        }
        if format == 2 {
            values.iter_mut().for_each(|value| *value -= (maximum / 3.0).round());
        }
        let grey = Tiff::grey(width, height, bits, format);
        let tiles = Tiff { tile_width: Some(32), ..grey.clone() };
        for (name, tiff) in [
            ("strips", grey.clone()),
            ("one strip", Tiff { block_rows: height, ..grey.clone() }),
            ("big endian", Tiff { big_endian: true, ..grey.clone() }),
            ("deflate", Tiff { deflate: true, ..grey.clone() }),
            ("deflated tiles", Tiff { deflate: true, ..tiles.clone() }),
            ("tiles", tiles),
        ] {
            let path = folder.file(&format!("{name} {bits} {format}.tif"), &tiff.bytes(&values));
            assert_reads(&path, &default(), &values, maximum * 1.2e-7);
        }
    }
}

#[test]
fn tiff_bands_are_channels() {
    let folder = Folder::new();
    let [width, height] = SIZE;
    let values = samples(width, height, 60000.0);
    let three: Vec<f64> = values.iter().flat_map(|&s| [s, s / 2.0, 65535.0 - s].map(f64::floor)).collect();
    let halves: Vec<f64> = values.iter().map(|s| (s / 2.0).floor()).collect();
    let grey = Tiff { bands: 3, ..Tiff::grey(width, height, 16, 1) };
    for (planar, tile_width) in [(1, None), (2, None), (1, Some(16)), (2, Some(16))] {
        let tiff = Tiff { planar, tile_width, deflate: true, ..grey.clone() };
        let path = folder.file("bands.tif", &tiff.bytes(&three));
        assert_reads(&path, &channel("band2"), &halves, 0.01);
        assert!(read_height(&path, &default()).is_err());
        let path = folder.file("rgb.tif", &Tiff { photometric: 2, ..tiff }.bytes(&three));
        assert_reads(&path, &channel("g"), &halves, 0.01);
    }
    // White is zero: the highest is stored as 0.
    let white: Vec<f64> = values.iter().map(|s| 65535.0 - s).collect();
    let tiff = Tiff { photometric: 0, ..Tiff::grey(width, height, 16, 1) };
    assert_reads(&folder.file("white.tif", &tiff.bytes(&white)), &default(), &values, 0.01);
}

#[test]
fn geotiff_georeference_and_nodata() {
    let folder = Folder::new();
    let [width, height] = SIZE;
    let mut values = samples(width, height, 500.0);
    let scale = |x, y| (33550, Value::Double(vec![x, y, 0.0]));
    let tie = |x, y| (33922, Value::Double(vec![0.0, 0.0, 0.0, x, y, 0.0]));
    let keys = |keys: &[[u16; 2]]| {
        let mut directory = vec![1, 1, 0, keys.len() as u16];
        keys.iter().for_each(|[key, value]| directory.extend([*key, 0, 1, *value]));
        (34735, Value::Short(directory))
    };
    let size = |extra: Vec<(u16, Value)>| {
        let tiff = Tiff { extra, ..Tiff::grey(width, height, 16, 1) };
        let path = folder.file("geo.tif", &tiff.bytes(&values));
        read_height(&path, &default()).expect("a valid map").texel_size_m()
    };
    assert_eq!(size(vec![]), None);
    assert_eq!(
        size(vec![scale(3.0, 4.0), tie(5e5, 4e6), keys(&[[1024, 1], [3076, 9001]])]),
        Some([3.0, 4.0])
    );
    let feet = size(vec![scale(10.0, 10.0), tie(0.0, 0.0), keys(&[[1024, 1], [3076, 9003]])])
        .expect("feet are known");
    assert!((feet[0] - 3.048_006_096).abs() < 1e-9 && feet[0] == feet[1]);
    assert_eq!(size(vec![scale(3.0, 3.0), tie(0.0, 0.0), keys(&[[1024, 1], [3076, 9999]])]), None);
    // One degree at the equator: 111.32 km along it, 110.57 km along a meridian (WGS 84); at 60 degrees north
    // 55.80 and 111.41.
    let degrees = |middle: f64| {
        let top = middle + f64::from(height) / 2.0;
        size(vec![scale(1.0, 1.0), tie(0.0, top), keys(&[[1024, 2], [2054, 9102]])])
            .expect("degrees are known")
    };
    let near = |[a, b]: [f64; 2], [c, d]: [f64; 2]| (a - c).abs() < 5.0 && (b - d).abs() < 5.0;
    assert!(near(degrees(0.0), [111_319.5, 110_574.3]), "{:?}", degrees(0.0));
    assert!(near(degrees(60.0), [55_800.0, 111_412.2]), "{:?}", degrees(60.0));
    // A rotated grid: texels of 5 m.
    let matrix = vec![3.0, 4.0, 0.0, 0.0, 4.0, -3.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0];
    let metres = keys(&[[1024, 1], [3076, 9001]]);
    assert_eq!(size(vec![(34264, Value::Double(matrix)), metres]), Some([5.0, 5.0]));

    values[70] = 9999.0;
    let nodata =
        Tiff { extra: vec![(42113, Value::Text("9999".into()))], ..Tiff::grey(width, height, 16, 1) };
    let path = folder.file("nodata.tif", &nodata.bytes(&values));
    let error = read_height(&path, &default()).expect_err("a texel has no value");
    assert!(
        matches!(
            error.problem,
            ReadProblem::Holes { nodata: 1, not_finite: 0, masked: 0, column: 9, row: 1 }
        ),
        "{error}"
    );
    let map = read_height(&path, &HeightOptions { fill: Fill::Always, ..default() }).expect("it is filled");
    let filled = f64::from(map.texels()[70]) * 65535.0;
    assert!((filled - samples(width, height, 500.0)[70]).abs() < 20.0, "{filled}");

    // The block that a sparse file leaves out is nodata, not sea level.
    let sparse = Tiff { sparse: vec![1], ..nodata };
    let path = folder.file("sparse.tif", &sparse.bytes(&samples(width, height, 500.0)));
    let error = read_height(&path, &default()).expect_err("a block is left out");
    assert!(matches!(error.problem, ReadProblem::Holes { nodata: 976, column: 0, row: 16, .. }), "{error}");
}
