//! EXR, TIFF and GeoTIFF files, written by the test, give the heights that were put in.

use crate::common::tiff_file::{Tiff, Value};
use crate::common::{Folder, SIZE, assert_reads, channel, default, exr_file, samples};
use ::exr::prelude::SampleType as ExrSample;
use relief_io::{Fill, HeightOptions, ReadProblem, Source, read_height, read_notes};

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

/// Names that differ in their case alone are channels of their own, and any case finds a name that stands
/// alone.
#[test]
fn exr_channel_names_may_differ_only_in_case() {
    let folder = Folder::new();
    let none = ::exr::prelude::Compression::Uncompressed;
    let values: Vec<f64> = samples(61, 37, 1000.0).iter().map(|s| s / 1000.0).collect();
    let other: Vec<f64> = values.iter().map(|value| 1.0 - value).collect();
    let channels: [exr_file::Samples<'_>; 5] = [
        ("R", ExrSample::F32, &values),
        ("r", ExrSample::F32, &other),
        ("Height", ExrSample::F32, &other),
        ("height", ExrSample::F32, &values),
        ("Depth", ExrSample::F32, &other),
    ];
    let path = folder.file("cases.exr", &exr_file::exr(SIZE, None, none, &channels));
    let lone = [("depth", &other), ("DEPTH", &other)];
    for (name, wanted) in
        [("R", &values), ("r", &other), ("Height", &other), ("height", &values)].iter().chain(&lone)
    {
        assert_reads(&path, &channel(name), wanted, 1e-7);
    }
    let [first, second] = [&channels[..1], &channels[1..2]];
    let path = folder.file("parts.exr", &exr_file::two_parts((SIZE, first), (SIZE, second)));
    assert_reads(&path, &channel("extra.r"), &other, 1e-7);
    assert_reads(&path, &channel("EXTRA.R"), &other, 1e-7);
}

fn notes(name: &str, bytes: &[u8]) -> Vec<&'static str> {
    let notes = read_notes(Source::bytes(name, bytes)).unwrap_or_else(|error| panic!("{error}"));
    notes.iter().map(|note| note.remark.row.name).collect()
}

/// An EXR whose display window is moved, larger or smaller is read by its data window, with a note.
#[test]
fn exr_with_another_display_window_has_a_note() {
    let none = ::exr::prelude::Compression::Uncompressed;
    let values: Vec<f64> = samples(61, 37, 1000.0).iter().map(|s| s / 1000.0).collect();
    let channels: [exr_file::Samples<'_>; 1] = [("Y", ExrSample::F32, &values)];
    let plain = exr_file::exr(SIZE, None, none, &channels);
    assert_eq!(notes("a.exr", &plain), Vec::<&str>::new());
    let both = exr_file::two_parts((SIZE, &channels), (SIZE, &channels));
    let attribute = b"displayWindow\0box2i\0";
    let folder = Folder::new();
    for (bytes, option) in [(plain, default()), (both, channel("base.Y"))] {
        let at = bytes.windows(attribute.len()).position(|found| found == attribute).expect("it has one");
        for window in [[-5, 0, 60, 36], [0, 0, 99, 99], [4, 4, 30, 30], [0, 0, 60, 35]] {
            let mut bytes = bytes.clone();
            let numbers = window.map(i32::to_le_bytes);
            bytes[at + attribute.len() + 4..][..16].copy_from_slice(numbers.as_flattened());
            assert_eq!(notes("a.exr", &bytes), ["display-window"], "{window:?}");
            assert_reads(&folder.file("a.exr", &bytes), &option, &values, 1e-7);
        }
    }
}

/// A TIFF that does not say whether 0 is black is read with 0 as black, with a note.
#[test]
fn tiff_without_a_photometric_interpretation_has_a_note() {
    let folder = Folder::new();
    let values = samples(61, 37, 1.0);
    for tiff in [
        Tiff::grey(61, 37, 1, 1),
        Tiff::grey(61, 37, 8, 1),
        Tiff { big_endian: true, ..Tiff::grey(61, 37, 16, 1) },
        Tiff::grey(61, 37, 32, 3),
    ] {
        let stated = tiff.bytes(&values);
        assert_eq!(notes("a.tif", &stated), Vec::<&str>::new());
        let [mut entry, mut other] = [[262u16, 3], [263, 3]].map(|pair| pair.map(u16::to_le_bytes).concat());
        if tiff.big_endian {
            [&mut entry, &mut other]
                .into_iter()
                .for_each(|entry| entry.chunks_mut(2).for_each(<[u8]>::reverse));
        }
        let mut unstated = stated.clone();
        let at = unstated.windows(4).rposition(|found| found == entry).expect("the tag is there");
        unstated[at..at + 4].copy_from_slice(&other);
        assert_eq!(notes("a.tif", &unstated), ["no-photometric"], "{} bits", tiff.bits);
        let [stated, unstated] = [folder.file("a.tif", &stated), folder.file("b.tif", &unstated)];
        let read = |path| read_height(path, &default()).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(read(&stated), read(&unstated));
    }
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
fn tiff_of_sixteen_bit_floats() {
    let folder = Folder::new();
    let [width, height] = SIZE;
    // Each is a float of 16 bits.
    let values: Vec<f64> = samples(width, height, 2000.0).iter().map(|value| value / 64.0 - 8.0).collect();
    let grey = Tiff { deflate: true, ..Tiff::grey(width, height, 16, 3) };
    let tiles = Tiff { tile_width: Some(16), ..grey.clone() };
    for big_endian in [false, true] {
        for (name, tiff) in [
            ("plain", Tiff { deflate: false, ..grey.clone() }),
            ("deflate", grey.clone()),
            ("predicted", Tiff { float_predictor: true, ..grey.clone() }),
            ("predicted tiles", Tiff { float_predictor: true, ..tiles.clone() }),
            ("tiles", tiles.clone()),
            ("one row a strip", Tiff { block_rows: 1, ..grey.clone() }),
        ] {
            let path = folder.file(&format!("{name}.tif"), &Tiff { big_endian, ..tiff }.bytes(&values));
            assert_reads(&path, &default(), &values, 1e-5);
        }
    }
    let three: Vec<f64> = values.iter().flat_map(|&value| [value, -value, value / 2.0]).collect();
    for planar in [1, 2] {
        let bands = Tiff { bands: 3, planar, ..grey.clone() };
        let halves: Vec<f64> = values.iter().map(|value| value / 2.0).collect();
        assert_reads(&folder.file("bands.tif", &bands.bytes(&three)), &channel("band3"), &halves, 1e-5);
    }
    // Values that are none, and the nodata value as a float of 16 bits has it.
    let mut holes = values.clone();
    [holes[3], holes[70], holes[71]] = [f64::NAN, f64::INFINITY, -9999.0];
    let nodata = Tiff { extra: vec![(42113, Value::Text("-9999".into()))], ..grey };
    let error = read_height(&folder.file("holes.tif", &nodata.bytes(&holes)), &default());
    let problem = error.expect_err("values are missing").problem;
    assert!(matches!(problem, ReadProblem::Holes { nodata: 1, not_finite: 2, .. }), "{problem}");
}

#[test]
fn tiff_palettes_are_colours() {
    let folder = Folder::new();
    let [width, height] = SIZE;
    for (bits, count) in [(8, 256), (4, 16)] {
        let values: Vec<f64> = samples(width, height, f64::from(count - 1));
        let palette = |colour: &dyn Fn(u32, u32) -> u32| {
            let planes = (0..3).flat_map(|plane| (0..count).map(move |index| (plane, index)));
            (320, Value::Short(planes.map(|(plane, index)| colour(plane, index) as u16).collect()))
        };
        let of = |colours: (u16, Value)| {
            let tiff = Tiff { photometric: 3, extra: vec![colours], ..Tiff::grey(width, height, bits, 1) };
            folder.file("palette.tif", &tiff.bytes(&values))
        };
        let step = 255 / (count - 1);
        let grey: Vec<f64> = values.iter().map(|value| value * f64::from(step)).collect();
        // Bytes repeated, above zeros, and as old programs write them; then one turned over.
        for factor in [257, 256, 1] {
            let path = of(palette(&|_, index| index * step * factor));
            assert_reads(&path, &default(), &grey, 1e-4);
        }
        let inverse: Vec<f64> = grey.iter().map(|value| 255.0 - value).collect();
        let path = of(palette(&|_, index| (255 - index * step) * 257));
        assert_reads(&path, &default(), &inverse, 1e-4);
        // Of 16 bits, and in colour.
        let wide: Vec<f64> = values.iter().map(|value| value * 250.0 + 3.0).collect();
        assert_reads(&of(palette(&|_, index| index * 250 + 3)), &default(), &wide, 0.01);
        let path = of(palette(&|plane, index| if plane == 1 { 257 * 7 } else { index * step * 257 }));
        assert_reads(&path, &channel("b"), &grey, 1e-4);
        assert!(matches!(
            read_height(&path, &default()).expect_err("a colour").problem,
            ReadProblem::NotGrey { .. }
        ));
        let picture = relief_io::read_picture(&path, 1 << 20).expect("a picture");
        let green = relief_io::srgb_to_linear(7.0 / 255.0);
        assert!(picture.texels.iter().all(|texel| (f64::from(texel[1]) - green).abs() < 1e-6));
        // The samples of an elevation model are its heights.
        let scale = "<GDALMetadata><Item sample=\"0\" role=\"scale\">2</Item></GDALMetadata>";
        let colours = palette(&|plane, index| if plane == 1 { 0 } else { index * step * 257 });
        let extra = vec![colours, (42112, Value::Text(scale.into()))];
        let model = Tiff { photometric: 3, extra, ..Tiff::grey(width, height, bits, 1) };
        let path = folder.file("model.tif", &model.bytes(&values));
        let metres: Vec<f64> = values.iter().map(|value| 2.0 * value).collect();
        assert_reads(&path, &channel("index"), &metres, 1e-4);
        assert!(relief_io::read_picture(&path, 1 << 20).is_ok());
    }
    let short = vec![(320, Value::Short(vec![0; 30]))];
    let broken = Tiff { photometric: 3, extra: short, ..Tiff::grey(width, height, 8, 1) };
    let path = folder.file("short.tif", &broken.bytes(&samples(width, height, 255.0)));
    assert!(matches!(read_height(&path, &default()).expect_err("30").problem, ReadProblem::Damaged { .. }));
}

#[test]
fn tiff_errors_advise_on_their_cause() {
    let grey = Tiff::grey(4, 4, 8, 1);
    let compression = |code: u16| {
        let mut bytes = grey.bytes(&[0.0; 16]);
        let at = bytes.windows(4).position(|tag| tag == [3, 1, 3, 0]).expect("the tag");
        bytes[at + 8..at + 10].copy_from_slice(&code.to_le_bytes());
        bytes
    };
    let bits = |bits: u16, format: u16| {
        let mut bytes = Tiff::grey(4, 4, 32, format).bytes(&[0.0; 16]);
        let at = bytes.windows(4).position(|tag| tag == [2, 1, 3, 0]).expect("the tag");
        bytes[at + 8..at + 10].copy_from_slice(&bits.to_le_bytes());
        bytes
    };
    for (bytes, words) in [
        (compression(34925), ["LZMA", "COMPRESS=DEFLATE"]),
        (bits(24, 3), ["24", "-ot Float32"]),
        (bits(24, 1), ["24", "-ot Float32"]),
        (Tiff { photometric: 6, bands: 3, ..grey.clone() }.bytes(&[0.0; 48]), ["YCbCr", "sRGB"]),
        (Tiff { photometric: 5, bands: 4, ..grey.clone() }.bytes(&[0.0; 64]), ["CMYK", "sRGB"]),
    ] {
        let problem = read_height(Source::bytes("a.tif", &bytes), &default()).expect_err(words[0]).problem;
        let text = problem.to_string();
        assert!(matches!(problem, ReadProblem::Unsupported { .. }), "{text}");
        assert!(words.iter().all(|word| text.contains(word)), "{text}");
    }
}

#[test]
fn compressions_of_exr_that_are_not_read_are_named_and_nonsense_is_damage() {
    let [width, height] = SIZE;
    let values = samples(width, height, 1.0);
    let (_, compression, _) = exr_file::COMPRESSIONS[0];
    let bytes = exr_file::exr(SIZE, None, compression, &[("Y", ExrSample::F32, &values)]);
    let name = b"compression\0compression\0";
    let at = bytes.windows(name.len()).position(|text| text == name).expect("the attribute");
    let read = |code: u8| {
        let mut bytes = bytes.clone();
        bytes[at + name.len() + 4] = code;
        read_height(Source::bytes("a.exr", &bytes), &default()).expect_err("not read").problem
    };
    for (code, name) in [(10, "HTJ2K"), (11, "HTJ2K"), (12, "LJ2K"), (13, "ZSTD")] {
        let problem = read(code);
        let text = problem.to_string();
        assert!(matches!(problem, ReadProblem::Unsupported { .. }) && text.contains(name), "{text}");
        assert_eq!(text.contains("newer than this program"), code > 11, "{text}");
        assert!(text.contains("ZIP"), "{text}");
    }
    for code in [14, 200, 255] {
        assert!(matches!(read(code), ReadProblem::Damaged { .. }), "{code}");
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
