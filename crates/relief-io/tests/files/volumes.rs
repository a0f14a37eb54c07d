//! Volumes in KTX2 files: round trips, what another reader finds, and damaged or false files.

use std::path::Path;

use crate::common::{Folder, Random};
use ktx2::{Format, Reader};
use relief_core::{Volume, Wrap};
use relief_io::{
    Ktx2Texture, Metadata, ReadProblem, Row, Source, TexelFormat, VolumeFormat, VolumeOptions, WriteProblem,
    read_volume, write_ktx2, write_volume,
};

fn ball(size: [u32; 3], wrap: Wrap) -> Volume {
    let volume = Volume::from_fn(size, wrap, |[u, v, h]| {
        let [x, y, z] = [u - 0.4, v - 0.5, h - 0.6];
        0.5 + 3.0 * (0.3 - (x * x + y * y + z * z).sqrt())
    });
    volume.and_then(|volume| volume.with_displacement(0.25, -0.125)).expect("a volume")
}

fn written(volume: &Volume, format: &VolumeFormat) -> Vec<u8> {
    let folder = Folder::new();
    let path = folder.path().join("a.ktx2");
    write_volume(&path, volume, format).expect("the folder is writable");
    std::fs::read(&path).expect("it was written")
}

fn read(bytes: &[u8]) -> Result<relief_io::VolumeFile, ReadProblem> {
    let file = read_volume(Source::bytes("a.ktx2", bytes), &VolumeOptions::default());
    file.map_err(|error| error.problem)
}

#[test]
fn volumes_come_back_as_they_were_stored() {
    for (texel, step) in
        [(TexelFormat::R16, 0.5 / 65535.0), (TexelFormat::R8, 0.5 / 255.0), (TexelFormat::R32F, 0.0)]
    {
        for (zstd, wrap) in [(true, Wrap::Repeat), (false, Wrap::Mirror)] {
            for size in [[9, 6, 5], [1, 7, 1], [4, 1, 11]] {
                let volume = ball(size, wrap);
                let more = vec![("note".to_owned(), "a ball".to_owned())];
                let format = VolumeFormat { texel, zstd, tile_m: [2.0, 0.5], more };
                let bytes = written(&volume, &format);
                assert_eq!(bytes, written(&volume, &format));
                let file = read(&bytes).expect("a volume");
                assert_eq!((file.format, file.zstd, file.tile_m), (texel, zstd, Some([2.0, 0.5])));
                assert_eq!(file.metadata.get("relief.note"), Some("a ball"));
                let back = &file.volume;
                assert_eq!((back.size(), back.wrap()), (size, wrap));
                assert_eq!((back.atlas().scale_m(), back.atlas().bias_m()), (0.25, -0.125));
                let apart = back.values().into_iter().zip(volume.values()).map(|(a, b)| (a - b).abs());
                assert!(apart.fold(0.0, f32::max) <= step * 1.001, "{texel:?} {size:?}");
                let options = VolumeOptions { wrap: Some(Wrap::Clamp), ..VolumeOptions::default() };
                let clamped = read_volume(Source::bytes("a.ktx2", &bytes), &options).expect("a volume");
                assert_eq!(clamped.volume.wrap(), Wrap::Clamp);
            }
        }
    }
}

/// The `ktx2` crate finds a 3-D texture with slice 0 first.
#[test]
fn another_reader_finds_a_3d_texture() {
    let volume = ball([8, 4, 6], Wrap::Repeat);
    let bytes = written(&volume, &VolumeFormat { zstd: false, ..VolumeFormat::default() });
    let reader = Reader::new(&bytes).expect("a KTX2 file");
    let header = reader.header();
    assert_eq!([header.pixel_width, header.pixel_height, header.pixel_depth], [8, 4, 6]);
    assert_eq!((header.format, header.level_count, header.layer_count), (Some(Format::R16_UNORM), 1, 0));
    let level = reader.levels().next().expect("a level").data;
    let texels: Vec<f32> = level
        .chunks_exact(2)
        .map(|bytes| f32::from(u16::from_le_bytes([bytes[0], bytes[1]])) / 65535.0)
        .collect();
    let values = volume.values();
    assert!(texels.len() == values.len() && texels.iter().zip(values).all(|(a, b)| (a - b).abs() < 1e-5));
}

fn texture(
    path: &Path,
    format: TexelFormat,
    size: [u32; 3],
    levels: u32,
    entries: &[(&str, &str)],
    value: f32,
) {
    let entries = entries.iter().map(|(name, value)| (format!("relief.{name}"), (*value).to_owned()));
    let metadata = Metadata::new(entries.collect()).expect("valid names");
    let texture = Ktx2Texture { format, size, levels, channels: format.channels(), zstd: false, metadata };
    let mut fill = |_: Row, texels: &mut [f32]| {
        texels.fill(value);
        Ok(())
    };
    write_ktx2(path, &texture, &mut fill).expect("the folder is writable");
}

const NOTE: [(&str, &str); 6] = [
    ("kind", "volume"),
    ("tile_m", "1 1"),
    ("scale_m", "0.1"),
    ("bias_m", "0"),
    ("wrap", "repeat"),
    ("surface", "0.5"),
];

#[test]
fn textures_that_are_no_volumes_are_refused() {
    let folder = Folder::new();
    let path = folder.path().join("a.ktx2");
    type Case<'a> = (TexelFormat, [u32; 3], u32, &'a [(&'a str, &'a str)], f32, &'a str);
    let cases: [Case; 8] = [
        (TexelFormat::R16, [4, 4, 1], 1, &[], 0.5, "a 2-D texture"),
        (TexelFormat::R16, [4, 4, 4], 2, &[], 0.5, "2 mip levels"),
        (TexelFormat::Rgba8, [4, 4, 4], 1, &[], 0.5, "R8_UNORM"),
        (TexelFormat::R16F, [4, 4, 4], 1, &[], 0.5, "R8_UNORM"),
        (TexelFormat::R8, [4, 4, 4], 1, &[("kind", "distance")], 0.5, "the kind distance"),
        (TexelFormat::R32F, [4, 4, 4], 1, &[], f32::NAN, "voxel (0, 0, 0) is NaN"),
        (TexelFormat::R32F, [4, 4, 4], 1, &[], 1.5, "voxel (0, 0, 0) is 1.5"),
        (TexelFormat::R8, [1, 1, 5000], 1, &[], 0.5, "at most 4096 slices"),
    ];
    for (format, size, levels, entries, value, expected) in cases {
        texture(&path, format, size, levels, entries, value);
        let error = read_volume(path.as_path(), &VolumeOptions::default()).expect_err(expected).to_string();
        assert!(error.contains(expected), "{error}");
    }
    // A volume of another program has no note.
    texture(&path, TexelFormat::R8, [4, 4, 4], 1, &[], 0.5);
    let file = read_volume(path.as_path(), &VolumeOptions::default()).expect("a volume");
    assert_eq!((file.tile_m, file.volume.wrap(), file.volume.atlas().scale_m()), (None, Wrap::Repeat, 1.0));
    texture(&path, TexelFormat::R8, [4, 4, 1], 1, &NOTE, 0.5);
    let file = read_volume(path.as_path(), &VolumeOptions::default()).expect("a volume of a single slice");
    assert_eq!((file.volume.size(), file.volume.atlas().scale_m()), ([4, 4, 1], 0.1));
}

#[test]
fn impossible_entries_are_refused() {
    let folder = Folder::new();
    let path = folder.path().join("a.ktx2");
    for (name, value) in [
        ("tile_m", "1"),
        ("tile_m", "0 1"),
        ("tile_m", "1 inf"),
        ("scale_m", "-1"),
        ("scale_m", "deep"),
        ("bias_m", "nan"),
        ("wrap", "around"),
        ("surface", "0.25"),
    ] {
        let entries = NOTE.map(|(own, old)| (own, if own == name { value } else { old }));
        texture(&path, TexelFormat::R8, [4, 4, 4], 1, &entries, 0.5);
        assert!(read_volume(path.as_path(), &VolumeOptions::default()).is_err(), "{name} = {value}");
        let others: Vec<_> = NOTE.into_iter().filter(|(own, _)| *own != name).collect();
        texture(&path, TexelFormat::R8, [4, 4, 4], 1, &others, 0.5);
        assert!(read_volume(path.as_path(), &VolumeOptions::default()).is_err(), "without {name}");
    }
}

/// A file that claims more than there is memory for is refused by its header.
#[test]
fn large_claims_are_refused_before_memory_is_taken() {
    let bytes = written(&ball([9, 6, 5], Wrap::Repeat), &VolumeFormat::default());
    let options = VolumeOptions { max_bytes: 1 << 20, ..VolumeOptions::default() };
    let error = read_volume(Source::bytes("a.ktx2", &bytes), &options).expect_err("8 MiB for Zstandard");
    assert!(matches!(error.problem, ReadProblem::VolumeMemory { size: [9, 6, 5], limit: 0x10_0000, .. }));
    let mut large = bytes;
    for (place, side) in [(20, 4000u32), (24, 4000), (28, 4000)] {
        large[place..place + 4].copy_from_slice(&side.to_le_bytes());
    }
    let error = read(&large).expect_err("64e9 voxels").to_string();
    assert!(error.contains("4000x4000x4000"), "{error}");
}

#[test]
fn damaged_files_are_errors() {
    for zstd in [true, false] {
        let bytes =
            written(&ball([9, 6, 5], Wrap::Repeat), &VolumeFormat { zstd, ..VolumeFormat::default() });
        for length in 0..bytes.len() {
            assert!(read(&bytes[..length]).is_err(), "{length} of {} bytes", bytes.len());
        }
        let mut random = Random::new(5);
        for _ in 0..3000 {
            let mut changed = bytes.clone();
            for _ in 0..=random.below(3) {
                let at = random.below(changed.len());
                changed[at] = random.below(256) as u8;
            }
            if let Ok(file) = read(&changed) {
                let voxels = file.volume.layout().voxels() as usize;
                assert!(file.volume.values().len() == voxels);
            }
        }
    }
}

#[test]
fn what_cannot_be_stored_leaves_no_file() {
    let folder = Folder::new();
    let path = folder.path().join("a.ktx2");
    let volume = ball([4, 4, 4], Wrap::Repeat);
    for format in [
        VolumeFormat { texel: TexelFormat::Rg8, ..VolumeFormat::default() },
        VolumeFormat { texel: TexelFormat::R16F, ..VolumeFormat::default() },
        VolumeFormat { tile_m: [0.0, 1.0], ..VolumeFormat::default() },
        VolumeFormat { tile_m: [1.0, f64::NAN], ..VolumeFormat::default() },
        VolumeFormat { more: vec![("wrap".into(), "clamp".into())], ..VolumeFormat::default() },
    ] {
        let error = write_volume(&path, &volume, &format).expect_err("not storable");
        assert!(matches!(error.problem, WriteProblem::NotStorable(_)) && !path.exists());
    }
}
