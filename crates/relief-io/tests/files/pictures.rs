//! Colour pictures, normal maps, and detection of conventions from a pair of maps.

use crate::common::files::{Scan, big_endian, hdr, jpeg, png, png_with, with_chunk};
use crate::common::tiff_file::Tiff;
use crate::common::{Folder, exr_file, landscape};
use ::exr::prelude::{Compression, SampleType as ExrSample};
use png::{BitDepth, ColorType};
use relief_core::{HeightMap, Wrap};
use relief_io::{
    Convention, Curve, DEFAULT_MAX_BYTES, GreenSign, NormalMap, Picture, ReadProblem, Source, detect,
    read_normal_map, read_normal_vectors, read_picture, read_picture_as, read_vector_map, write_exr,
};

fn picture(path: &std::path::Path) -> Picture {
    read_picture(path, DEFAULT_MAX_BYTES).unwrap_or_else(|error| panic!("{error}"))
}

fn assert_near(found: [f32; 4], expected: [f64; 4]) {
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((f64::from(found) - expected).abs() < 1e-6, "{found}, not {expected}");
    }
}

#[test]
fn integers_are_decoded_by_the_srgb_curve_and_opacity_is_not() {
    let folder = Folder::new();
    // Values of the curve from IEC 61966-2-1: below 0.04045 linear; 0.5 encoded is 0.214041 linear.
    let bytes = png(2, 1, ColorType::Rgba, BitDepth::Eight, &[0, 255, 10, 51, 128, 64, 1, 255]);
    let found = picture(&folder.file("rgba.png", &bytes));
    assert_eq!((found.width, found.height), (2, 1));
    assert_near(found.texels[0], [0.0, 1.0, 10.0 / 255.0 / 12.92, 0.2]);
    assert_near(found.texels[1], [0.215_860_5, 0.051_269_46, 1.0 / 255.0 / 12.92, 1.0]);

    let wide = big_endian(&[32767.5f64.round(), 65535.0, 0.0]);
    let found = picture(&folder.file("rgb.png", &png(1, 1, ColorType::Rgb, BitDepth::Sixteen, &wide)));
    assert_near(found.texels[0], [0.214_048_3, 1.0, 0.0, 1.0]);

    let grey = png(1, 1, ColorType::GrayscaleAlpha, BitDepth::Eight, &[128, 0]);
    assert_near(
        picture(&folder.file("ga.png", &grey)).texels[0],
        [0.215_860_5, 0.215_860_5, 0.215_860_5, 0.0],
    );
    let indexed = png_with(2, 1, ColorType::Indexed, BitDepth::Eight, &[1, 0], |encoder| {
        encoder.set_palette(vec![0, 0, 0, 255, 0, 128]);
        encoder.set_trns(vec![0, 51]);
    });
    assert_near(picture(&folder.file("palette.png", &indexed)).texels[0], [1.0, 0.0, 0.215_860_5, 0.2]);
    let tiff = Tiff { bands: 3, photometric: 2, ..Tiff::grey(1, 1, 8, 1) };
    let found = picture(&folder.file("rgb.tif", &tiff.bytes(&[255.0, 128.0, 0.0])));
    assert_near(found.texels[0], [1.0, 0.215_860_5, 0.0, 1.0]);
    let found = picture(&folder.file("rgb.jpg", &jpeg(8, 8, 3, &[128; 192])));
    assert!((found.texels[9][0] - 0.2159).abs() < 0.01);
}

#[test]
fn vectors_of_displacement_are_stored_numbers() {
    let folder = Folder::new();
    let read = |path: &std::path::Path| read_vector_map(path, DEFAULT_MAX_BYTES);
    let floats: [(&str, &[f32]); 4] =
        [("R", &[0.25, 0.5]), ("G", &[7.5, 0.75]), ("B", &[0.0, 1.0]), ("A", &[0.0, 1.0])];
    write_exr(&folder.path().join("v.exr"), 2, 1, &floats).expect("written");
    let found = read(&folder.path().join("v.exr")).expect("vectors");
    assert_eq!((found.width, found.height, found.most), (2, 1, None));
    assert_eq!(found.vectors, [[0.25, 7.5, 0.0], [0.5, 0.75, 1.0]]);
    write_exr(&folder.path().join("xyz.exr"), 1, 1, &[("X", &[-3.0]), ("Y", &[1.0]), ("Z", &[2.0])])
        .expect("written");
    assert_eq!(read(&folder.path().join("xyz.exr")).expect("vectors").vectors, [[-3.0, 1.0, 2.0]]);
    // The middle of whole numbers is no displacement.
    let wide = big_endian(&[0.0, 32768.0, 65535.0]);
    let found =
        read(&folder.file("v.png", &png(1, 1, ColorType::Rgb, BitDepth::Sixteen, &wide))).expect("vectors");
    assert_eq!((found.vectors, found.most), (vec![[-1.0, (1.0f64 / 65535.0) as f32, 1.0]], Some(65535)));
    let problem = |name: &str| read(&folder.path().join(name)).expect_err("it is refused").problem;
    write_exr(&folder.path().join("grey.exr"), 1, 1, &[("Y", &[1.0])]).expect("written");
    assert!(matches!(problem("grey.exr"), ReadProblem::NoColour { .. }));
    let bad: [(&str, &[f32]); 3] =
        [("R", &[0.0; 4]), ("G", &[0.0, 0.0, f32::NAN, f32::INFINITY]), ("B", &[0.0; 4])];
    write_exr(&folder.path().join("bad.exr"), 2, 2, &bad).expect("written");
    assert!(matches!(problem("bad.exr"), ReadProblem::NotFinite { not_finite: 2, column: 0, row: 1 }));
}

#[test]
fn png_files_declare_their_curve() {
    let chunk = |kind: &[u8; 4], data: &[u8]| (*kind, data.to_vec());
    let gamma = |gamma: u32| chunk(b"gAMA", &gamma.to_be_bytes());
    let (srgb, linear) = (0.214_048_3, 0.500_007_6);
    let profile = [b"a\0\0", crate::common::files::zlib(&[0; 128]).as_slice()].concat();
    for (chunks, expected) in [
        (vec![], srgb),
        (vec![gamma(100_000)], linear),
        (vec![gamma(99_998)], linear),
        (vec![gamma(45_455)], srgb),
        (vec![gamma(55_556)], srgb),
        (vec![gamma(0)], srgb),
        (vec![chunk(b"cICP", &[1, 8, 0, 1])], linear),
        (vec![chunk(b"cICP", &[1, 13, 0, 1]), gamma(100_000)], srgb),
        // The more exact statement wins.
        (vec![chunk(b"sRGB", &[0]), gamma(100_000)], srgb),
        (vec![chunk(b"iCCP", &profile), gamma(100_000)], srgb),
    ] {
        for depth in [BitDepth::Eight, BitDepth::Sixteen] {
            let samples = if depth == BitDepth::Eight { vec![128; 3] } else { big_endian(&[32768.0; 3]) };
            let plain = png(1, 1, ColorType::Rgb, depth, &samples);
            let bytes = chunks
                .iter()
                .fold(plain.clone(), |bytes, (kind, data)| with_chunk(&bytes, kind, data, b"IDAT"));
            let read =
                |bytes: &[u8]| read_picture(Source::bytes("a.png", bytes), 1 << 26).expect("a picture");
            let [found, ..] = read(&bytes).texels[0];
            let rounding = if depth == BitDepth::Eight { 0.003 } else { 1e-6 };
            assert!((f64::from(found) - expected).abs() < rounding, "{chunks:?}: {found}, not {expected}");
            // A declared curve is applied; heights and normals are stored numbers.
            for (curve, expected) in [(Curve::Srgb, srgb), (Curve::Linear, linear)] {
                let told =
                    read_picture_as(Source::bytes("a.png", &bytes), curve, 1 << 26).expect("a picture");
                assert!((f64::from(told.texels[0][0]) - expected).abs() < rounding);
            }
            let stored = |bytes: &[u8]| {
                read_normal_vectors(Source::bytes("a.png", bytes), 1 << 26).expect("normals").vectors
            };
            assert_eq!(stored(&bytes), stored(&plain));
        }
    }
}

#[test]
fn floats_are_linear() {
    let folder = Folder::new();
    let channels: [exr_file::Samples<'_>; 4] = [
        ("R", ExrSample::F32, &[0.5]),
        ("G", ExrSample::F32, &[4.0]),
        ("B", ExrSample::F16, &[-0.25]),
        ("A", ExrSample::F16, &[0.75]),
    ];
    let bytes = exr_file::exr([1, 1], None, Compression::ZIP16, &channels);
    assert_eq!(picture(&folder.file("rgba.exr", &bytes)).texels[0], [0.5, 4.0, -0.25, 0.75]);
    let bytes = hdr(1, 1, Scan::Flat, &[[128, 64, 0, 129]]);
    assert_eq!(picture(&folder.file("map.hdr", &bytes)).texels[0], [1.0, 0.5, 0.0, 1.0]);
    let bytes = exr_file::exr([1, 1], None, Compression::ZIP16, &[("Y", ExrSample::F32, &[f64::NAN])]);
    let error = read_picture(&folder.file("nan.exr", &bytes), DEFAULT_MAX_BYTES).expect_err("it is NaN");
    assert!(matches!(error.problem, ReadProblem::NotFinite { not_finite: 1, column: 0, row: 0 }), "{error}");
    let two: [exr_file::Samples<'_>; 2] = [("u", ExrSample::F32, &[0.0]), ("v", ExrSample::F32, &[0.0])];
    let bytes = exr_file::exr([1, 1], None, Compression::ZIP16, &two);
    let error = read_picture(&folder.file("uv.exr", &bytes), DEFAULT_MAX_BYTES).expect_err("no colour");
    assert!(matches!(error.problem, ReadProblem::NoColour { .. }), "{error}");
}

#[test]
fn normals_have_length_one_and_point_up_in_green() {
    let folder = Folder::new();
    let bytes = png(3, 1, ColorType::Rgb, BitDepth::Eight, &[128, 128, 255, 128, 255, 128, 127, 128, 127]);
    let path = folder.file("normal.png", &bytes);
    let map = read_normal_map(&path, GreenSign::PlusY, DEFAULT_MAX_BYTES).expect("a normal map");
    assert_eq!(map.degenerate, 1, "the last has no direction");
    assert_eq!(map.normals[2], [0.0, 0.0, 1.0]);
    assert!(map.normals[0][2] > 0.9999 && map.normals[1][1] > 0.9999);
    for normal in &map.normals {
        let length: f32 = normal.iter().map(|value| value * value).sum();
        assert!((length - 1.0).abs() < 1e-5);
    }
    let turned = read_normal_map(&path, GreenSign::MinusY, DEFAULT_MAX_BYTES).expect("a normal map");
    assert!(turned.normals[1][1] < -0.9999);

    // Floats with negative values are directions. Without them they are packed like bytes.
    let path = folder.path().join("normal.exr");
    let write = |r: f32, g: f32, b: f32| {
        write_exr(&path, 1, 1, &[("R", &[r]), ("G", &[g]), ("B", &[b])]).expect("the folder is writable");
        read_normal_map(&path, GreenSign::PlusY, DEFAULT_MAX_BYTES).expect("a normal map").normals[0]
    };
    assert_eq!(write(-0.6, 0.0, 0.8), [-0.6, 0.0, 0.8]);
    assert_eq!(write(0.5, 0.5, 1.0), [0.0, 0.0, 1.0]);
    // A level normal has no negative values, and is a direction already.
    assert_eq!(write(0.0, 0.0, 1.0), [0.0, 0.0, 1.0]);
    // Channels with the names of a vector's components hold a vector.
    write_exr(&path, 1, 1, &[("x", &[0.6]), ("y", &[0.0]), ("z", &[0.8])]).expect("the folder is writable");
    let named = read_normal_vectors(&path, DEFAULT_MAX_BYTES).expect("a normal map");
    assert_eq!((named.vectors[0], named.most), ([0.6, 0.0, 0.8], None));
    let path = folder.file("grey.png", &png(1, 1, ColorType::Grayscale, BitDepth::Eight, &[7]));
    let error = read_normal_map(&path, GreenSign::PlusY, DEFAULT_MAX_BYTES).expect_err("it is grey");
    assert!(matches!(error.problem, ReadProblem::NoColour { .. }), "{error}");
}

#[test]
fn the_code_of_zero_is_found_from_level_normals() {
    let folder = Folder::new();
    let read = |reds: &[u8]| -> Vec<f32> {
        let samples: Vec<u8> = reds.iter().flat_map(|&red| [red, 77, 255]).collect();
        let bytes = png(reds.len() as u32, 1, ColorType::Rgb, BitDepth::Eight, &samples);
        let vectors = read_normal_vectors(&folder.file("n.png", &bytes), DEFAULT_MAX_BYTES).expect("normals");
        assert_eq!(vectors.most, Some(255));
        vectors.with_zero_centred().vectors.iter().map(|vector| vector[0] * 255.0).collect()
    };
    // A map of level normals only is level, with either code of zero.
    assert_eq!(read(&[128; 4]), [0.0; 4]);
    assert_eq!(read(&[127; 4]), [0.0; 4]);
    // If the neighbouring codes are as frequent, values stay. Other codes never change.
    let as_they_are = read(&[126, 127, 128, 129, 0, 255]);
    for (found, expected) in as_they_are.iter().zip([-3.0, -1.0, 1.0, 3.0, -255.0, 255.0]) {
        assert!((found - expected).abs() < 1e-4, "{as_they_are:?}");
    }
    // Four level normals beside one that is not.
    let mixed = read(&[127, 128, 128, 128, 128, 128, 129]);
    assert!((mixed[1] - 0.2).abs() < 1e-4, "{mixed:?}");
}

/// Normals of a landscape with slopes up to about 1. `x` is against the slope along `u`; `y` is with the
/// slope along `v`.
fn normals(width: u32, height: u32) -> NormalMap {
    let h = landscape(width, height);
    let slope = |a: f64, b: f64| (a - b) * f64::from(width) * 0.1;
    let mut normals = Vec::new();
    for j in 0..height {
        for i in 0..width {
            let du = slope(h((i + 1).min(width - 1), j), h(i.saturating_sub(1), j));
            let dv = slope(h(i, (j + 1).min(height - 1)), h(i, j.saturating_sub(1)));
            let length = (du * du + dv * dv + 1.0).sqrt();
            normals.push([-du / length, dv / length, 1.0 / length].map(|value| value as f32));
        }
    }
    NormalMap { width, height, normals, degenerate: 0 }
}

#[test]
fn all_four_conventions_are_distinguished() {
    let surface = landscape(64, 48);
    for (width, height) in [(64, 48), (32, 24)] {
        for convention in [Convention::Height, Convention::Depth] {
            for green in [GreenSign::PlusY, GreenSign::MinusY] {
                let map = HeightMap::from_fn(64, 48, Wrap::Clamp, |i, j| match convention {
                    Convention::Height => surface(i, j) as f32,
                    Convention::Depth => 1.0 - surface(i, j) as f32,
                });
                let mut pair = normals(width, height);
                if green == GreenSign::MinusY {
                    pair.normals.iter_mut().for_each(|normal| normal[1] = -normal[1]);
                }
                let found = detect(&map.expect("a valid map"), &pair);
                assert_eq!((found.convention, found.green), (convention, green));
                assert!(found.convention_confidence > 0.8 && found.green_confidence > 0.8, "{found:?}");
            }
        }
    }
}

#[test]
fn unrelated_maps_give_no_confidence() {
    let flat = HeightMap::from_fn(64, 48, Wrap::Clamp, |_, _| 0.5).expect("a valid map");
    let found = detect(&flat, &normals(64, 48));
    assert_eq!((found.convention_confidence, found.green_confidence), (0.0, 0.0));
    let mut random = crate::common::Random::new(7);
    let noise = HeightMap::from_fn(64, 48, Wrap::Clamp, |_, _| random.below(1000) as f32 / 1000.0);
    let found = detect(&noise.expect("a valid map"), &normals(64, 48));
    assert!(found.convention_confidence < 0.1 && found.green_confidence < 0.1, "{found:?}");
}
