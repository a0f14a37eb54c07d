//! Pictures are turned by their stated orientation for every use; ignored orientations cause notes.

use crate::common::files::{Scan, big_endian, exif, hdr, jpeg, png, png_by_hand, with_chunk, with_exif};
use crate::common::mesh_file::{data_uri, gltf, gltf_buffer};
use crate::common::tiff_file::{Tiff, Value};
use crate::common::{Folder, Random, default};
use png::{BitDepth, ColorType};
use relief_core::mesh::cube;
use relief_io::{
    Fill, HeightNote, HeightOptions, MeshOptions, PngTexture, ReadProblem, Source, inspect, read_height,
    read_mesh, read_normal_vectors, read_notes, read_picture, write_png_rows,
};

/// Width and height of the stored pictures.
const STORED: [u32; 2] = [13, 9];

const ORIENTATION: u16 = 274;

/// A picture: its size and its texels.
#[derive(Clone, Debug, PartialEq)]
struct Texels<T> {
    size: [u32; 2],
    texels: Vec<T>,
}

impl<T: Copy> Texels<T> {
    fn mirrored(&self) -> Self {
        let rows = self.texels.chunks(self.size[0] as usize);
        Self { size: self.size, texels: rows.flat_map(|row| row.iter().rev().copied()).collect() }
    }

    /// Turned clockwise by 90 degrees: the left column is the top row.
    fn turned(&self) -> Self {
        let [width, height] = self.size.map(|side| side as usize);
        let texel = |row: usize, column: usize| self.texels[(height - 1 - column) * width + row];
        let texels = (0..width).flat_map(|row| (0..height).map(move |column| (row, column)));
        Self {
            size: [self.size[1], self.size[0]],
            texels: texels.map(|(row, column)| texel(row, column)).collect(),
        }
    }

    /// Turns the picture as the name of the EXIF orientation says.
    fn shown(&self, orientation: u16) -> Self {
        match orientation {
            2 => self.mirrored(),
            3 => self.turned().turned(),
            4 => self.turned().turned().mirrored(),
            5 => self.mirrored().turned().turned().turned(),
            6 => self.turned(),
            7 => self.mirrored().turned(),
            8 => self.turned().turned().turned(),
            _ => self.clone(),
        }
    }
}

/// Names of the notes on a picture's header.
fn noted(name: &str, bytes: &[u8]) -> Vec<&'static str> {
    let notes = read_notes(Source::bytes(name, bytes)).unwrap_or_else(|error| panic!("{error}"));
    notes.iter().map(|note| note.remark.row.name).collect()
}

fn numbers(count: u32, most: usize) -> Vec<f64> {
    let mut random = Random::new(7);
    (0..count).map(|_| random.below(most) as f64).collect()
}

fn tagged(tiff: &Tiff, orientation: u16, samples: &[f64]) -> Vec<u8> {
    Tiff { extra: vec![(ORIENTATION, Value::Short(vec![orientation]))], ..tiff.clone() }.bytes(samples)
}

/// Rows of the seven passes of an interlaced grey PNG, each with its filter.
fn interlaced(bytes: &[u8]) -> Vec<u8> {
    let passes =
        [[0, 0, 8, 8], [4, 0, 8, 8], [0, 4, 4, 8], [2, 0, 4, 4], [0, 2, 2, 4], [1, 0, 2, 2], [0, 1, 1, 2]];
    let mut rows = Vec::new();
    for [left, top, right, down] in passes {
        for y in (top..STORED[1] as usize).step_by(down) {
            let row = (left..STORED[0] as usize).step_by(right).map(|x| bytes[y * STORED[0] as usize + x]);
            rows.push(0);
            rows.extend(row);
        }
    }
    rows
}

/// Files of every format with orientations, with one channel: names and bytes with the given
/// orientation.
fn grey_files(orientation: u16) -> Vec<(&'static str, Vec<u8>)> {
    let [width, height] = STORED;
    let wide = numbers(width * height, 60_000);
    let bytes: Vec<u8> = wide.iter().map(|&sample| (sample / 256.0) as u8).collect();
    let eighths: Vec<f64> = wide.iter().map(|sample| sample / 8192.0 - 3.0).collect();
    let grey = png(width, height, ColorType::Grayscale, BitDepth::Sixteen, &big_endian(&wide));
    let passes = png_by_hand(STORED, 8, 0, 1, &interlaced(&bytes));
    let tiled =
        Tiff { tile_width: Some(16), deflate: true, big_endian: true, ..Tiff::grey(width, height, 32, 3) };
    let long = Tiff { block_rows: 4, ..Tiff::grey(width, height, 32, 2) };
    vec![
        (
            "strips.tif",
            tagged(&Tiff { block_rows: 2, ..Tiff::grey(width, height, 16, 1) }, orientation, &wide),
        ),
        ("tiles.tif", tagged(&tiled, orientation, &eighths)),
        ("halves.tif", tagged(&Tiff::grey(width, height, 16, 3), orientation, &eighths)),
        ("integers.tif", tagged(&long, orientation, &wide)),
        ("first.png", with_chunk(&grey, b"eXIf", &exif(orientation, true), b"IDAT")),
        ("last.png", with_chunk(&passes, b"eXIf", &exif(orientation, false), b"IEND")),
        ("grey.jpg", with_exif(&jpeg(width, height, 1, &bytes), &exif(orientation, orientation > 4))),
    ]
}

fn heights(name: &str, bytes: &[u8], options: &HeightOptions) -> Texels<f32> {
    let map = read_height(Source::bytes(name, bytes), options).unwrap_or_else(|error| panic!("{error}"));
    Texels { size: [map.width(), map.height()], texels: map.texels().to_vec() }
}

#[test]
fn height_maps_follow_the_orientation_of_their_files() {
    let stored: Vec<Texels<f32>> =
        grey_files(1).iter().map(|(name, bytes)| heights(name, bytes, &default())).collect();
    assert!(stored.iter().all(|stored| stored.size == STORED));
    for orientation in 1..=8 {
        for ((name, bytes), stored) in grey_files(orientation).iter().zip(&stored) {
            let found = heights(name, bytes, &default());
            assert_eq!(found, stored.shown(orientation), "{name}, orientation {orientation}");
            let info = inspect(Source::bytes(name, bytes), &default()).expect("the same file");
            assert_eq!([info.width, info.height], found.size);
            assert_eq!(info.orientation, Some(u32::from(orientation)).filter(|&number| number > 1));
            assert!(info.notes.is_empty(), "{:?}", info.notes);
        }
    }
}

fn picture(name: &str, bytes: &[u8]) -> Texels<[f32; 4]> {
    let found = read_picture(Source::bytes(name, bytes), 1 << 26).unwrap_or_else(|error| panic!("{error}"));
    Texels { size: [found.width, found.height], texels: found.texels }
}

#[test]
fn pictures_and_normals_follow_the_orientation() {
    let [width, height] = STORED;
    let samples = numbers(3 * width * height, 256);
    let bytes: Vec<u8> = samples.iter().map(|&sample| sample as u8).collect();
    let planar =
        Tiff { bands: 3, photometric: 2, planar: 2, block_rows: 5, ..Tiff::grey(width, height, 8, 1) };
    let files = |orientation: u16| {
        let rgb = png(width, height, ColorType::Rgb, BitDepth::Eight, &bytes);
        [
            ("a.png", with_chunk(&rgb, b"eXIf", &exif(orientation, true), b"IDAT")),
            ("a.tif", tagged(&planar, orientation, &samples)),
            ("a.jpg", with_exif(&jpeg(width, height, 3, &bytes), &exif(orientation, false))),
        ]
    };
    let normals = |name: &str, bytes: &[u8]| {
        let found = read_normal_vectors(Source::bytes(name, bytes), 1 << 26).expect("red, green and blue");
        Texels { size: [found.width, found.height], texels: found.vectors }
    };
    for orientation in 1..=8 {
        for ((name, stored), (_, bytes)) in files(1).iter().zip(files(orientation)) {
            let at = format!("{name}, orientation {orientation}");
            assert_eq!(picture(name, &bytes), picture(name, stored).shown(orientation), "{at}");
            assert_eq!(normals(name, &bytes), normals(name, stored).shown(orientation), "{at}");
        }
    }
}

#[test]
fn holes_masks_and_colours_are_labelled() {
    let [width, height] = STORED;
    let [column, row] = [4, 2];
    let at = (row * width + column) as usize;
    let mut samples = numbers(width * height, 1000);
    samples[at] = 5000.0;
    let orientation = (ORIENTATION, Value::Short(vec![6]));
    let nodata = vec![orientation.clone(), (42113, Value::Text("5000".into()))];
    let grey = Tiff::grey(width, height, 16, 1);
    let of_mask: Vec<f64> = (0..samples.len()).map(|texel| f64::from(u8::from(texel != at))).collect();
    let mask =
        Tiff { photometric: 4, extra: vec![(254, Value::Long(vec![4]))], ..Tiff::grey(width, height, 1, 1) };
    let masked = Tiff { extra: vec![orientation], ..grey.clone() };
    for (name, bytes) in [
        ("nodata.tif", Tiff { extra: nodata, ..grey }.bytes(&samples)),
        ("mask.tif", masked.bytes_before(&samples, &[(mask, of_mask)])),
    ] {
        let problem = read_height(Source::bytes(name, &bytes), &default()).expect_err("a hole").problem;
        let ReadProblem::Holes { column: x, row: y, .. } = problem else { panic!("{problem}") };
        assert_eq!([x, y], [height - 1 - row, column], "{name}");
        let options = HeightOptions { fill: Fill::Always, ..default() };
        let map = read_height(Source::bytes(name, &bytes), &options).expect("it is filled");
        let holes = map.holes().expect("one");
        assert!(holes.contains(x, y) && map.filled_texels() == 1, "{name}");
    }
    let mut bytes = vec![90; 3 * samples.len()];
    bytes[3 * at] = 10;
    let colour = png(width, height, ColorType::Rgb, BitDepth::Eight, &bytes);
    let colour = with_chunk(&colour, b"eXIf", &exif(6, true), b"IDAT");
    let problem = read_height(Source::bytes("a.png", &colour), &default()).expect_err("a colour").problem;
    let ReadProblem::NotGrey { column: x, row: y, .. } = problem else { panic!("{problem}") };
    assert_eq!([x, y], [height - 1 - row, column]);
}

#[test]
fn invalid_orientations_have_a_note() {
    for number in [0, 9, 65_535] {
        for ((name, bytes), (_, stored)) in grey_files(number).iter().zip(grey_files(1)) {
            assert_eq!(
                heights(name, bytes, &default()),
                heights(name, &stored, &default()),
                "{name} {number}"
            );
            assert_eq!(noted(name, bytes), ["no-orientation"], "{name}");
            let notes = read_notes(Source::bytes(name, bytes)).expect("a picture");
            assert!(notes[0].remark.text.contains(&number.to_string()));
        }
    }
    // Damaged metadata cause no note: the picture is intact.
    let [width, height] = STORED;
    let grey = png(width, height, ColorType::Grayscale, BitDepth::Eight, &[7; 117]);
    let whole = exif(6, true);
    for broken in [&b""[..], b"Exif", &whole[..20], &[&whole[..4], &[0xff; 30]].concat()] {
        let png = with_chunk(&grey, b"eXIf", broken, b"IDAT");
        assert_eq!(heights("a.png", &png, &default()).size, STORED);
        assert_eq!(noted("a.png", &png), [""; 0]);
        let jpeg = with_exif(&jpeg(width, height, 1, &[7; 117]), broken);
        assert_eq!(heights("a.jpg", &jpeg, &default()).size, STORED);
    }
}

#[test]
fn georeferenced_rows_keep_their_stored_order() {
    let [width, height] = STORED;
    let samples = numbers(width * height, 1000);
    let model = |orientation: u16| {
        let keys = vec![1, 1, 0, 2, 1024, 0, 1, 1, 3072, 0, 1, 32633];
        let extra = vec![
            (ORIENTATION, Value::Short(vec![orientation])),
            (33550, Value::Double(vec![10.0, 20.0, 0.0])),
            (33922, Value::Double(vec![0.0, 0.0, 0.0, 5e5, 5e6, 0.0])),
            (34735, Value::Short(keys)),
        ];
        Tiff { extra, ..Tiff::grey(width, height, 16, 1) }.bytes(&samples)
    };
    let stored = heights("a.tif", &model(1), &default());
    assert_eq!(stored.size, STORED);
    for orientation in [2, 4, 6, 9] {
        let bytes = model(orientation);
        assert_eq!(heights("a.tif", &bytes, &default()), stored);
        let info = inspect(Source::bytes("a.tif", &bytes), &default()).expect("a model");
        assert!(info.notes.iter().any(|note| note.remark.row.name == "orientation-on-ground"));
        assert_eq!(noted("a.tif", &bytes), ["orientation-on-ground"]);
        assert_eq!((info.orientation, info.texel_size_m), (None, Some([10.0, 20.0])));
    }
    assert_eq!(noted("a.tif", &model(1)), [""; 0]);
}

#[test]
fn a_place_in_a_file_beside_the_picture_comes_before_its_orientation() {
    let [width, height] = STORED;
    let bytes: Vec<u8> = numbers(width * height, 256).iter().map(|&sample| sample as u8).collect();
    let grey = png(width, height, ColorType::Grayscale, BitDepth::Eight, &bytes);
    let stored = heights("a.png", &grey, &default());
    let files = [
        ("a.png", with_chunk(&grey, b"eXIf", &exif(6, true), b"IDAT"), "a.pgw"),
        ("b.tif", tagged(&Tiff::grey(width, height, 8, 1), 6, &numbers(width * height, 256)), "b.tfw"),
    ];
    for (name, bytes, world) in files {
        // North up, and from the south as old programs store it.
        for (row, expected) in [("-20", stored.clone()), ("20", stored.shown(4))] {
            let folder = Folder::new();
            let path = folder.file(name, &bytes);
            folder.file(world, format!("10\n0\n0\n{row}\n500000\n5000000\n").as_bytes());
            let map = read_height(&path, &default()).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!([map.width(), map.height()], STORED, "{name} {row}");
            // An elevation model's least and greatest value are its heights 0 and 1.
            let order = |texels: &[f32]| {
                let mut order: Vec<usize> = (0..texels.len()).collect();
                order.sort_by(|&a, &b| texels[a].total_cmp(&texels[b]));
                order
            };
            assert_eq!(order(map.texels()), order(&expected.texels), "{name} {row}");
            let notes = inspect(&path, &default()).expect("a map").notes;
            assert!(notes.iter().any(|note| note.remark.row.name == "orientation-on-ground"), "{name} {row}");
        }
    }
}

#[test]
fn webp_follows_its_orientation() {
    let [width, height] = STORED;
    let samples: Vec<u8> = numbers(3 * width * height, 256).iter().map(|&sample| sample as u8).collect();
    let webp = |metadata: Option<Vec<u8>>| {
        let mut bytes = Vec::new();
        let mut encoder = image_webp::WebPEncoder::new(&mut bytes);
        metadata.into_iter().for_each(|metadata| encoder.set_exif_metadata(metadata));
        encoder.encode(&samples, width, height, image_webp::ColorType::Rgb8).expect("a WebP");
        bytes
    };
    let stored = picture("a.webp", &webp(None));
    for orientation in 0..10 {
        let bytes = webp(Some(exif(orientation, false)));
        assert_eq!(picture("a.webp", &bytes), stored.shown(orientation), "{orientation}");
        let is_none = matches!(orientation, 0 | 9);
        assert_eq!(noted("a.webp", &bytes).len(), usize::from(is_none), "{orientation}");
    }
    assert_eq!(picture("a.webp", &webp(Some(b"Exif".to_vec()))), stored);
}

#[test]
fn pictures_of_a_gltf_keep_their_stored_orientation() {
    let mesh = cube(1).expect("a built-in mesh");
    let [width, height] = STORED;
    let bytes: Vec<u8> = numbers(3 * width * height, 256).iter().map(|&sample| sample as u8).collect();
    let plain = png(width, height, ColorType::Rgb, BitDepth::Eight, &bytes);
    let expected = read_picture(Source::bytes("a.png", &plain), 1 << 26).expect("a picture");
    let turned = with_chunk(&plain, b"eXIf", &exif(6, true), b"IDAT");
    let linear = with_chunk(&plain, b"gAMA", &100_000u32.to_be_bytes(), b"IDAT");
    for (picture, is_noted) in [(plain, false), (turned, true), (linear, false)] {
        let material = format!(
            r#""materials": [{{"pbrMetallicRoughness": {{"baseColorTexture": {{"index": 0}}}}}}],
            "textures": [{{"source": 0}}], "images": [{{"uri": "{}"}}], "buffers""#,
            data_uri(&picture)
        );
        let json = gltf(&mesh, Some(&data_uri(&gltf_buffer(&mesh))), "");
        let json = json.replace(r#""indices": 3"#, r#""indices": 3, "material": 0"#);
        let json = json.replacen(r#""buffers""#, &material, 1);
        let options = MeshOptions { colors: true, ..MeshOptions::default() };
        let file = read_mesh(Source::bytes("a.gltf", json.as_bytes()), &options);
        let file = file.unwrap_or_else(|error| panic!("{error}"));
        let found = file.colors.and_then(|colors| colors.materials[0].picture.clone()).expect("a picture");
        assert!(*found == expected, "{is_noted}");
        assert_eq!(file.notes.len(), usize::from(is_noted), "{:?}", file.notes);
    }
}

#[test]
fn radiance_pictures_have_any_order_of_rows_and_columns() {
    let [width, height] = STORED;
    let mut random = Random::new(3);
    let texels: Vec<[u8; 4]> = (0..width * height)
        .map(|_| {
            let level = random.below(256) as u8;
            [level, level, level, 130]
        })
        .collect();
    for scan in [Scan::Flat, Scan::Components] {
        let usual = hdr(width, height, scan, &texels);
        let stored = heights("a.hdr", &usual, &default());
        // Lines of 13 texels, 9 of them; y runs up.
        for (axes, orientation) in [
            ("-Y 9 +X 13", 1),
            ("-Y 9 -X 13", 2),
            ("+Y 9 -X 13", 3),
            ("+Y 9 +X 13", 4),
            ("+X 9 -Y 13", 5),
            ("-X 9 -Y 13", 6),
            ("-X 9 +Y 13", 7),
            ("+X 9 +Y 13", 8),
        ] {
            let at = usual.windows(10).position(|text| text == b"-Y 9 +X 13").expect("the usual order");
            let turned = [&usual[..at], axes.as_bytes(), &usual[at + 10..]].concat();
            assert_eq!(heights("a.hdr", &turned, &default()), stored.shown(orientation), "{axes}");
        }
        for axes in ["-Y 9 +Y 13", "+X 9 -X 13", "-Z 9 +X 13", "-Y 9", "9 13"] {
            let at = usual.windows(10).position(|text| text == b"-Y 9 +X 13").expect("the usual order");
            let bytes = [&usual[..at], axes.as_bytes(), &usual[at + 10..]].concat();
            assert!(read_height(Source::bytes("a.hdr", &bytes), &default()).is_err(), "{axes}");
        }
    }
}

#[test]
fn turning_takes_no_more_memory() {
    let grey = Tiff { block_rows: 8, ..Tiff::grey(300, 200, 16, 1) };
    let samples = numbers(300 * 200, 60_000);
    let limited = |orientation: u16, max_bytes: u64| {
        let bytes = tagged(&grey, orientation, &samples);
        read_height(Source::bytes("a.tif", &bytes), &HeightOptions { max_bytes, ..default() })
    };
    let problem = limited(1, 1000).expect_err("it needs more").problem;
    let ReadProblem::TooMuchMemory { needed, .. } = problem else { panic!("{problem}") };
    for orientation in [1, 3, 6, 7] {
        assert!(limited(orientation, needed).is_ok(), "{orientation}");
        assert!(limited(orientation, needed - 1).is_err(), "{orientation}");
    }
}

#[test]
fn the_tile_follows_the_orientation() {
    let folder = Folder::new();
    let path = folder.path().join("a.png");
    let note = HeightNote { tile_m: [2.6, 0.9], scale_m: 0.1, bias_m: 0.0, of_mesh: false };
    let texture = PngTexture { width: STORED[0], height: STORED[1], channels: 1, bits: 8 };
    let metadata = note.metadata(Vec::new()).expect("plain text");
    write_png_rows(&path, &texture, &metadata, &mut |_, texels| {
        texels.fill(0.5);
        Ok(())
    })
    .expect("the folder is writable");
    let plain = std::fs::read(&path).expect("it was written");
    for (orientation, texel_m) in [(1, [0.2, 0.1]), (3, [0.2, 0.1]), (8, [0.1, 0.2])] {
        let path = folder.file("b.png", &with_chunk(&plain, b"eXIf", &exif(orientation, true), b"IDAT"));
        let [u, v] = read_height(&path, &default()).expect("a map").texel_size_m().expect("it is noted");
        assert!((u - texel_m[0]).abs() < 1e-9 && (v - texel_m[1]).abs() < 1e-9, "{orientation}: {u} {v}");
    }
}

#[test]
fn unread_parts_of_a_file_are_counted() {
    let [width, height] = STORED;
    let samples = numbers(width * height, 1000);
    let page = Tiff::grey(width, height, 16, 1);
    let of_kind = |kind: u32, bits: u16| Tiff {
        photometric: if kind == 4 { 4 } else { 1 },
        extra: vec![(254, Value::Long(vec![kind]))],
        ..Tiff::grey(width, height, bits, 1)
    };
    let ones = vec![1.0; samples.len()];
    let notes = |more: &[(Tiff, Vec<f64>)]| {
        let bytes = page.bytes_before(&samples, more);
        assert_eq!(heights("a.tif", &bytes, &default()), heights("a.tif", &page.bytes(&samples), &default()));
        let notes = read_notes(Source::bytes("a.tif", &bytes)).expect("a picture");
        notes.into_iter().map(|note| note.remark.text).collect::<Vec<_>>()
    };
    // A mask and a reduced copy belong to the picture.
    let beside = [(of_kind(4, 1), ones.clone()), (of_kind(1, 16), samples.clone())];
    assert_eq!(notes(&beside), [""; 0]);
    let two = [(page.clone(), samples.clone()), (of_kind(2, 16), samples.clone())];
    assert!(matches!(&notes(&two)[..], [text] if text.contains("3 pages")));
    let all = notes(&[beside.as_slice(), &two].concat());
    assert!(matches!(&all[..], [text] if text.contains("3 pages")), "{all:?}");
    // An animation shows its default picture.
    let grey = png(width, height, ColorType::Grayscale, BitDepth::Eight, &[7; 117]);
    let animation = [2u32.to_be_bytes(), 0u32.to_be_bytes()].concat();
    let animated = with_chunk(&grey, b"acTL", &animation, b"IDAT");
    assert_eq!(noted("a.png", &animated), ["animation"]);
    assert_eq!(heights("a.png", &animated, &default()).size, STORED);
}
