//! PNG and EXR textures row by row, and the metadata in files of every format.

use crate::common::{Folder, Random, channel};
use relief_io::{
    Convention, HeightNote, HeightOptions, Ktx2Texture, Metadata, PngTexture, Row, TexelFormat, WriteProblem,
    inspect, read_height, read_metadata, write_exr_rows, write_ktx2, write_png_rows,
};

fn metadata() -> Metadata {
    let entries = [("relief.kind", "normal"), ("relief.note.bound", "h ≤ 1, a = b"), ("empty", "")];
    Metadata::new(entries.map(|(key, value)| (key.to_owned(), value.to_owned())).into()).expect("valid names")
}

/// 16-bit fractions that differ by channel.
fn code(row: Row, column: usize) -> u16 {
    (column as u32 * 331 + row.row * 1013 + row.channel as u32 * 17_000) as u16
}

fn fill(row: Row, texels: &mut [f32]) -> std::io::Result<()> {
    for (column, texel) in texels.iter_mut().enumerate() {
        *texel = f32::from(code(row, column)) / 65535.0;
    }
    Ok(())
}

#[test]
fn each_format_keeps_metadata_and_the_same_bytes() {
    let folder = Folder::new();
    let metadata = metadata();
    for name in ["a.png", "a.exr", "a.ktx2"] {
        let path = folder.path().join(name);
        let write = || {
            match name {
                "a.png" => {
                    let texture = PngTexture { width: 9, height: 5, channels: 3, bits: 16 };
                    write_png_rows(&path, &texture, &metadata, &mut fill)
                }
                "a.exr" => write_exr_rows(&path, 9, 5, &["x", "y", "z"], &metadata, &mut fill),
                _ => {
                    let texture = Ktx2Texture {
                        format: TexelFormat::Rgba16,
                        size: [9, 5, 1],
                        levels: 1,
                        channels: 3,
                        zstd: true,
                        metadata: metadata.clone(),
                    };
                    write_ktx2(&path, &texture, &mut fill)
                }
            }
            .expect("the folder is writable");
            std::fs::read(&path).expect("it was written")
        };
        let bytes = write();
        assert_eq!(bytes, write(), "{name}");
        let found = read_metadata(&path).expect("it has metadata");
        for (key, value) in metadata.iter() {
            assert_eq!(found.get(key), Some(value), "{name}");
        }
        // Truncated or damaged metadata are an error or are read in part, without a panic.
        let mut random = Random::new(1);
        for _ in 0..800 {
            let mut broken = bytes.clone();
            broken[random.below(bytes.len().min(700))] ^= 1 << random.below(8);
            broken.truncate(1 + random.below(bytes.len()));
            let _ = read_metadata(&folder.file("broken", &broken)).is_ok();
        }
    }
    assert!(read_metadata(&folder.file("none", b"text")).is_err());
    assert!(read_metadata(folder.path()).is_err());
}

#[test]
fn texels_come_back() {
    let folder = Folder::new();
    let path = folder.path().join("map");
    for (bits, channels) in [(8, 1), (8, 4), (16, 1), (16, 3), (16, 4)] {
        let texture = PngTexture { width: 300, height: 7, channels, bits };
        write_png_rows(&path, &texture, &metadata(), &mut fill).expect("the folder is writable");
        for at in 0..channels {
            let options =
                if channels == 1 { HeightOptions::default() } else { channel(["r", "g", "b", "a"][at]) };
            let map = read_height(&path, &options).expect("it is a map");
            for (place, texel) in map.texels().iter().enumerate() {
                let row = Row { level: 0, slice: 0, channel: at, row: place as u32 / 300 };
                let expected = f32::from(code(row, place % 300)) / 65535.0;
                let step = 0.501 / f64::from((1u32 << bits) - 1);
                assert!(f64::from((texel - expected).abs()) <= step, "{bits} bits, channel {at}");
            }
        }
    }
    // Channels are stored by name, in whatever order they are given.
    write_exr_rows(&path, 300, 40, &["slope", "height", "a"], &metadata(), &mut fill)
        .expect("it is writable");
    for (at, name) in ["slope", "height", "a"].into_iter().enumerate() {
        let options = HeightOptions { range: Some([0.0, 1.0].into()), ..channel(name) };
        let map = read_height(&path, &options).expect("it is a map");
        for (place, &texel) in map.texels().iter().enumerate() {
            let row = Row { level: 0, slice: 0, channel: at, row: place as u32 / 300 };
            assert_eq!(texel, f32::from(code(row, place % 300)) / 65535.0);
        }
    }
}

#[test]
fn unstorable_textures_are_refused_and_leave_no_file() {
    let folder = Folder::new();
    let path = folder.path().join("map");
    let texture = PngTexture { width: 3, height: 3, channels: 1, bits: 16 };
    for texture in [
        PngTexture { width: 0, ..texture },
        PngTexture { channels: 5, ..texture },
        PngTexture { channels: 0, ..texture },
        PngTexture { bits: 12, ..texture },
    ] {
        let error = write_png_rows(&path, &texture, &metadata(), &mut fill).expect_err("it does not fit");
        assert!(matches!(error.problem, WriteProblem::NotStorable(_)), "{error}");
    }
    for names in [&[][..], &["a", "a"], &[""], &["höhe"]] {
        let error = write_exr_rows(&path, 3, 3, names, &metadata(), &mut fill).expect_err("it does not fit");
        assert!(matches!(error.problem, WriteProblem::NotStorable(_)), "{error}");
    }
    let mut missing = |row: Row, texels: &mut [f32]| match row.row {
        2 => Err(std::io::Error::other("no such row")),
        _ => fill(row, texels),
    };
    let error = write_png_rows(&path, &texture, &metadata(), &mut missing).expect_err("a row is missing");
    assert!(matches!(error.problem, WriteProblem::Io(_)), "{error}");
    let error = write_exr_rows(&path, 3, 3, &["a"], &metadata(), &mut missing).expect_err("a row is missing");
    assert!(matches!(error.problem, WriteProblem::Io(_)), "{error}");
    assert_eq!(std::fs::read_dir(folder.path()).expect("it is there").count(), 0);
}

#[test]
fn a_size_in_metadata_is_read() {
    let folder = Folder::new();
    let note = HeightNote { tile_m: [3.0, 0.5], scale_m: 0.25, bias_m: -0.1, of_mesh: false };
    let metadata = note.metadata(Vec::new()).expect("plain text");
    let mut ramp = |_: Row, texels: &mut [f32]| {
        texels.iter_mut().enumerate().for_each(|(column, texel)| *texel = column as f32 / 4.0);
        Ok(())
    };
    let [png, exr, other] = ["a.png", "a.exr", "other.png"].map(|name| folder.path().join(name));
    let texture = PngTexture { width: 5, height: 2, channels: 1, bits: 16 };
    write_png_rows(&png, &texture, &metadata, &mut ramp).expect("the folder is writable");
    write_exr_rows(&exr, 5, 2, &["height"], &metadata, &mut ramp).expect("the folder is writable");
    for path in [&png, &exr] {
        let read = |convention| {
            let options = HeightOptions { convention: Some(convention), ..HeightOptions::default() };
            read_height(path, &options).expect("it is a map")
        };
        let map = read(Convention::Height);
        assert_eq!(map.texel_size_m(), Some([0.6, 0.25]));
        let [zero, one] = map.physical_range().expect("it is known");
        assert!((zero + 0.1).abs() < 1e-12 && (one - 0.15).abs() < 1e-12, "{zero} {one}");
        let [zero, one] = read(Convention::Depth).physical_range().expect("it is known");
        assert!((zero - 0.15).abs() < 1e-12 && (one + 0.1).abs() < 1e-12, "{zero} {one}");
        let about = inspect(path, &HeightOptions::default()).expect("it is a map");
        assert_eq!((about.note, about.texel_size_m), (Some(note), Some([0.6, 0.25])));
    }
    // In other kinds of files the same names mean something else.
    let kind = |value: &str| Metadata::new(vec![("relief.kind".to_owned(), value.to_owned())]);
    write_png_rows(&other, &texture, &kind("cone").expect("plain text"), &mut ramp).expect("writable");
    let map = read_height(&other, &HeightOptions::default()).expect("it is a map");
    assert_eq!((map.texel_size_m(), map.physical_range()), (None, Some([0.0, 65535.0])));
}
