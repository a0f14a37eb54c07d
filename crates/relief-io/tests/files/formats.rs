//! PNG, JPEG, Radiance, PGM and raw files, written by the test, give the heights that were put in.

use crate::common::files::{
    Scan, big_endian, hdr, jpeg, pgm, plain_pgm, png, png_by_hand, png_with, with_chunk,
};
use crate::common::{Folder, SIZE, assert_reads, channel, default, samples};
use png::{BitDepth, ColorType};
use relief_io::{HeightOptions, ReadProblem, Source, read_height, read_notes, read_picture};

#[test]
#[should_panic(expected = "texel 70")]
fn a_wrong_texel_fails_the_comparison() {
    let folder = Folder::new();
    let mut values = samples(61, 37, 65535.0);
    let path = folder.file("map.pgm", &pgm(61, 37, 65535, &values));
    values[70] += 1.0;
    assert_reads(&path, &default(), &values, 0.01);
}

#[test]
fn png_of_every_depth_and_colour() {
    let folder = Folder::new();
    let [width, height] = SIZE;
    let bytes: Vec<u8> = samples(width, height, 255.0).iter().map(|&s| s as u8).collect();
    let grey: Vec<f64> = bytes.iter().map(|&byte| f64::from(byte)).collect();
    let inverse: Vec<f64> = bytes.iter().map(|&byte| f64::from(255 - byte)).collect();

    let path = folder.file("grey8.png", &png(width, height, ColorType::Grayscale, BitDepth::Eight, &bytes));
    assert_reads(&path, &default(), &grey, 1e-4);
    let two: Vec<u8> = bytes.iter().flat_map(|&byte| [byte, 255 - byte]).collect();
    let path = folder.file("ga8.png", &png(width, height, ColorType::GrayscaleAlpha, BitDepth::Eight, &two));
    assert_reads(&path, &default(), &grey, 1e-4);
    assert_reads(&path, &channel("a"), &inverse, 1e-4);
    let four: Vec<u8> = bytes.iter().flat_map(|&byte| [byte, byte / 2, byte / 3, 255 - byte]).collect();
    let path = folder.file("rgba8.png", &png(width, height, ColorType::Rgba, BitDepth::Eight, &four));
    assert_reads(&path, &channel("alpha"), &inverse, 1e-4);
    assert_reads(&path, &channel("R"), &grey, 1e-4);

    let wide = samples(width, height, 65535.0);
    let path = folder
        .file("grey16.png", &png(width, height, ColorType::Grayscale, BitDepth::Sixteen, &big_endian(&wide)));
    assert_reads(&path, &default(), &wide, 0.01);
    let three: Vec<f64> = wide.iter().flat_map(|&s| [s, 65535.0 - s, 7.0]).collect();
    let path =
        folder.file("rgb16.png", &png(width, height, ColorType::Rgb, BitDepth::Sixteen, &big_endian(&three)));
    assert_reads(&path, &channel("r"), &wide, 0.01);
}

#[test]
fn png_of_few_bits_and_with_palettes() {
    let folder = Folder::new();
    // Two rows of four texels with 4 bits each: 0 5 10 15 and 15 10 5 0.
    let path = folder.file("grey4.png", &png_by_hand([4, 2], 4, 0, 0, &[0, 0x05, 0xaf, 0, 0xfa, 0x50]));
    assert_reads(&path, &default(), &[0.0, 5.0, 10.0, 15.0, 15.0, 10.0, 5.0, 0.0], 1e-5);
    let path = folder.file("grey1.png", &png_by_hand([3, 1], 1, 0, 0, &[0, 0b1010_0000]));
    assert_reads(&path, &default(), &[1.0, 0.0, 1.0], 0.0);
    // A palette of greys is grey, one of colours is not.
    let indexed = |palette: Vec<u8>| {
        png_with(4, 1, ColorType::Indexed, BitDepth::Eight, &[0, 1, 2, 1], |encoder| {
            encoder.set_palette(palette);
        })
    };
    let path = folder.file("palette.png", &indexed(vec![0, 0, 0, 40, 40, 40, 255, 255, 255]));
    assert_reads(&path, &default(), &[0.0, 40.0, 255.0, 40.0], 1e-4);
    let path = folder.file("colours.png", &indexed(vec![0, 0, 0, 40, 40, 60, 255, 255, 255]));
    let error = read_height(&path, &default()).expect_err("it is in colour");
    assert!(matches!(error.problem, ReadProblem::NotGrey { column: 1, row: 0, .. }), "{error}");
    assert_reads(&path, &channel("b"), &[0.0, 60.0, 255.0, 60.0], 1e-4);
    // Of one that lossy compression has tinted the mean is taken, and said.
    let path = folder.file("tinted.png", &indexed(vec![0, 0, 0, 40, 43, 40, 255, 255, 255]));
    assert_reads(&path, &default(), &[0.0, 41.0, 255.0, 41.0], 1e-4);
    assert_eq!(read_height(&path, &default()).expect("nearly grey").nearly_grey_texels(), 2);
    // A colour over heights in alpha: which of them is asked, with a hint.
    let rgba = png_with(2, 1, ColorType::Rgba, BitDepth::Eight, &[200, 90, 10, 0, 200, 90, 10, 255], |_| ());
    let path = folder.file("packed.png", &rgba);
    let error = read_height(&path, &default()).expect_err("it is in colour");
    assert!(matches!(error.problem, ReadProblem::NotGrey { alpha_varies: true, .. }), "{error}");
    assert_reads(&path, &channel("a"), &[0.0, 255.0], 1e-4);
}

#[test]
fn interlaced_png() {
    // The seven passes of Adam7 for sizes at which some are empty.
    let passes =
        [[0, 0, 8, 8], [4, 0, 8, 8], [0, 4, 4, 8], [2, 0, 4, 4], [0, 2, 2, 4], [1, 0, 2, 2], [0, 1, 1, 2]];
    let folder = Folder::new();
    for [width, height] in [[61, 37], [1, 1], [2, 9], [5, 3]] {
        let values = samples(width, height, 255.0);
        let mut rows = Vec::new();
        for [left, top, column_step, row_step] in passes {
            for row in (top..height).step_by(row_step as usize) {
                let line = (left..width)
                    .step_by(column_step as usize)
                    .map(|i| values[(row * width + i) as usize] as u8);
                let line: Vec<u8> = line.collect();
                if !line.is_empty() {
                    rows.push(0);
                    rows.extend(line);
                }
            }
        }
        let path = folder.file("adam7.png", &png_by_hand([width, height], 8, 0, 1, &rows));
        assert_reads(&path, &default(), &values, 1e-4);
    }
}

#[test]
fn gamma_of_a_png_is_not_applied() {
    let folder = Folder::new();
    let bytes: Vec<u8> = (0..=255).collect();
    let tagged = png_with(256, 1, ColorType::Grayscale, BitDepth::Eight, &bytes, |encoder| {
        encoder.set_source_gamma(png::ScaledFloat::new(0.3));
    });
    let expected: Vec<f64> = (0..256).map(f64::from).collect();
    assert_reads(&folder.file("gamma.png", &tagged), &default(), &expected, 1e-4);
}

#[test]
fn jpeg_grey_and_colour() {
    let folder = Folder::new();
    let [width, height] = SIZE;
    let values = samples(width, height, 255.0);
    let bytes: Vec<u8> = values.iter().map(|&s| s as u8).collect();
    let path = folder.file("grey.jpg", &jpeg(width, height, 1, &bytes));
    assert_reads(&path, &default(), &values, 6.0);
    // Grey stored as colour stays grey: its two colour components are constant.
    let three: Vec<u8> = bytes.iter().flat_map(|&byte| [byte; 3]).collect();
    let path = folder.file("rgb.jpg", &jpeg(width, height, 3, &three));
    assert_reads(&path, &default(), &values, 6.0);
}

#[test]
fn radiance_pictures() {
    let folder = Folder::new();
    let [width, height] = SIZE;
    let values = samples(width, height, 255.0);
    let texels: Vec<[u8; 4]> = values.iter().map(|&s| [s as u8, s as u8, s as u8, 136]).collect();
    let mut steps = texels.clone();
    for (at, step) in steps.iter_mut().enumerate() {
        *step = texels[at / 20 * 20];
    }
    for (texels, scan) in [
        (&texels, Scan::Flat),
        (&steps, Scan::Repeats),
        (&texels, Scan::Components),
        (&steps, Scan::Components),
    ] {
        let path = folder.file("picture.hdr", &hdr(width, height, scan, texels));
        let expected: Vec<f64> = texels.iter().map(|texel| f64::from(texel[0])).collect();
        assert_reads(&path, &default(), &expected, 1e-4);
    }
}

#[test]
fn pgm_plain_and_binary_of_any_maxval() {
    let folder = Folder::new();
    let [width, height] = SIZE;
    for maxval in [1, 7, 255, 256, 1000, 65535] {
        let values = samples(width, height, f64::from(maxval));
        for bytes in [pgm(width, height, maxval, &values), plain_pgm(width, height, maxval, &values)] {
            let path = folder.file("map.pgm", &bytes);
            assert_reads(&path, &default(), &values, 0.01);
            let map = read_height(&path, &default()).expect("a valid map");
            assert_eq!(map.physical_range(), Some([0.0, f64::from(maxval)]));
        }
    }
}

#[test]
fn headerless_samples_of_either_byte_order() {
    let folder = Folder::new();
    let [width, height] = SIZE;
    let values = samples(width, height, 65535.0);
    let big = big_endian(&values);
    let little: Vec<u8> = big.chunks(2).flat_map(|pair| [pair[1], pair[0]]).collect();
    for (bytes, order) in [(big, "be"), (little, "le")] {
        let path = folder.file("map.r16", &bytes);
        let raw = |text: &str| HeightOptions { raw: Some(text.parse().expect("a layout")), ..default() };
        assert_reads(&path, &raw(&format!("61x37,{order}")), &values, 0.01);
        let error = read_height(&path, &raw("61x38,le")).expect_err("another size");
        assert!(
            matches!(error.problem, ReadProblem::RawSize { expected: 4636, actual: 4514, .. }),
            "{error}"
        );
        let error = read_height(&path, &default()).expect_err("no layout");
        assert!(matches!(error.problem, ReadProblem::NeedsRawLayout), "{error}");
    }
}

/// A palette with more opacities than colours is read as opaque, with a note, at every depth; fewer or as
/// many are followed. So is the transparent colour of others, which has a note where it is too long.
#[test]
fn too_much_opacity_has_a_note() {
    let palette = |depth, count: usize, opacities: usize| {
        let set = |encoder: &mut png::Encoder<'_, &mut Vec<u8>>| encoder.set_palette(vec![7; 3 * count]);
        let bytes = png_with(8, 1, ColorType::Indexed, depth, &[0; 8][..depth as usize], set);
        with_chunk(&bytes, b"tRNS", &vec![9; opacities], b"IDAT")
    };
    let seen = |bytes: &[u8]| {
        let notes = read_notes(Source::bytes("a.png", bytes)).unwrap_or_else(|error| panic!("{error}"));
        let names: Vec<_> = notes.iter().map(|note| note.remark.row.name).collect();
        let picture = read_picture(Source::bytes("a.png", bytes), 64 << 20);
        (names, picture.unwrap_or_else(|error| panic!("{error}")).texels[0][3])
    };
    for (depth, count) in
        [(BitDepth::One, 2), (BitDepth::Two, 3), (BitDepth::Four, 16), (BitDepth::Eight, 200)]
    {
        assert_eq!(seen(&palette(depth, count, count + 1)), (vec!["long-opacity"], 1.0), "{depth:?}");
        for fewer in [1, count] {
            assert_eq!(seen(&palette(depth, count, fewer)), (vec![], 9.0 / 255.0), "{depth:?}");
        }
    }
    let others = [
        (ColorType::Grayscale, BitDepth::One, 1, 2),
        (ColorType::Grayscale, BitDepth::Eight, 1, 2),
        (ColorType::Grayscale, BitDepth::Sixteen, 2, 2),
        (ColorType::Rgb, BitDepth::Eight, 3, 6),
        (ColorType::Rgb, BitDepth::Sixteen, 6, 6),
    ];
    for (colour, depth, bytes, right) in others {
        let file = png(1, 1, colour, depth, &[0; 6][..bytes]);
        let opacity = |bytes: usize| with_chunk(&file, b"tRNS", &vec![0; bytes], b"IDAT");
        assert_eq!(seen(&opacity(right)), (vec![], 0.0), "{colour:?} {depth:?}");
        assert_eq!(seen(&opacity(right + 2)).0, ["long-opacity"], "{colour:?} {depth:?}");
    }
    // The palette of colours is a suggestion, and no bound.
    let colours =
        with_chunk(&png(1, 1, ColorType::Rgb, BitDepth::Eight, &[1, 2, 3]), b"PLTE", &[1, 2, 3], b"IDAT");
    assert_eq!(seen(&with_chunk(&colours, b"tRNS", &[0; 6], b"IDAT")), (vec![], 1.0));
}
