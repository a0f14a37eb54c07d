//! KTX2 files: round trips of every format, the container's rules, and damaged or false files.

use std::path::Path;

use crate::common::{Folder, Random};
use ktx2::dfd::{Basic, Block};
use ktx2::{Format, Reader, SupercompressionScheme};
use relief_io::{
    Ktx2File, Ktx2Texture, Metadata, ReadProblem, Row, TexelFormat, WriteProblem, read_ktx2, read_metadata,
    write_ktx2,
};

const LIMIT: u64 = 64 << 20;

/// A smooth texel in `[0, 1]` that differs by level, slice and channel.
fn texel(row: Row, column: usize) -> f32 {
    let phase = row.level as f32 + 0.7 * row.slice as f32 + 1.9 * row.channel as f32;
    0.5 + 0.5 * (0.05 * column as f32 + 0.03 * row.row as f32 + phase).sin()
}

fn fill(row: Row, texels: &mut [f32]) -> std::io::Result<()> {
    for (column, place) in texels.iter_mut().enumerate() {
        *place = texel(row, column);
    }
    Ok(())
}

fn texture(format: TexelFormat, size: [u32; 3], levels: u32, zstd: bool) -> Ktx2Texture {
    let entries = [("relief.kind", "cone"), ("relief.wrap", "repeat"), ("a note", "5 µm²")];
    let entries = entries.map(|(key, value)| (key.to_owned(), value.to_owned()));
    let metadata = Metadata::new(entries.into()).expect("valid names");
    Ktx2Texture { format, size, levels, channels: format.channels(), zstd, metadata }
}

fn written(texture: &Ktx2Texture) -> Vec<u8> {
    let folder = Folder::new();
    let path = folder.path().join("texture.ktx2");
    write_ktx2(&path, texture, &mut fill).expect("the folder is writable");
    std::fs::read(&path).expect("it was written")
}

fn read(bytes: &[u8]) -> Result<Ktx2File, relief_io::ReadError> {
    let folder = Folder::new();
    read_ktx2(&folder.file("texture.ktx2", bytes), LIMIT)
}

/// Greatest error of a stored value: half a step, or the loss of block compression on smooth
/// texels.
fn tolerance(format: TexelFormat) -> f32 {
    match format {
        TexelFormat::R8 | TexelFormat::Rg8 | TexelFormat::Rgba8 => 0.5001 / 255.0,
        TexelFormat::R16 | TexelFormat::Rg16 | TexelFormat::Rgba16 => 0.501 / 65535.0,
        TexelFormat::R16F | TexelFormat::Rg16F | TexelFormat::Rgba16F => 0.5 / 2048.0,
        TexelFormat::R32F | TexelFormat::Rg32F | TexelFormat::Rgba32F => 0.0,
        TexelFormat::Bc4 | TexelFormat::Bc5 => 0.02,
        TexelFormat::Bc7 => 0.06,
    }
}

/// Greatest difference between a file and its source texels.
fn difference(file: &Ktx2File) -> f32 {
    let mut most = 0.0f32;
    for (level, content) in file.levels.iter().enumerate() {
        let [width, height, depth] = content.size;
        for (channel, plane) in content.planes.iter().enumerate() {
            assert_eq!(plane.len(), (width * height * depth) as usize);
            for (row, texels) in plane.chunks(width as usize).enumerate() {
                let (slice, row) = (row as u32 / height, row as u32 % height);
                let row = Row { level: level as u32, slice, channel, row };
                for (column, value) in texels.iter().enumerate() {
                    most = most.max((value - texel(row, column)).abs());
                }
            }
        }
    }
    most
}

#[test]
fn every_format_and_chain_round_trips() {
    for format in TexelFormat::ALL {
        for zstd in [false, true] {
            for (size, levels) in
                [([61, 37, 1], 6), ([61, 37, 1], 1), ([1, 1, 1], 1), ([1, 130, 1], 8), ([16, 8, 5], 5)]
            {
                if size[2] > 1 && format.is_block_compressed() {
                    continue;
                }
                let texture = texture(format, size, levels, zstd);
                let bytes = written(&texture);
                assert_eq!(bytes, written(&texture), "{format:?}: not the same bytes twice");
                let file = read(&bytes).unwrap_or_else(|error| panic!("{format:?} {size:?}: {error}"));
                assert_eq!((file.format, file.zstd, file.levels.len()), (format, zstd, levels as usize));
                let difference = difference(&file);
                assert!(difference <= tolerance(format), "{format:?} {size:?}: off by {difference}");
                for (key, value) in texture.metadata.iter() {
                    assert_eq!(file.metadata.get(key), Some(value));
                }
                assert!(
                    file.metadata.get("KTXwriter").is_some_and(|writer| writer.starts_with("relief-io "))
                );
            }
        }
    }
}

/// Checks the comparison itself: one changed byte of the texels is noticed.
#[test]
fn a_changed_texel_gives_a_difference() {
    let texture = texture(TexelFormat::R32F, [61, 37, 1], 1, false);
    let mut bytes = written(&texture);
    let last = bytes.len() - 1;
    bytes[last] ^= 1;
    assert!(difference(&read(&bytes).expect("it is still a texture")) > 0.0);
}

#[test]
fn the_container_follows_the_specification() {
    for format in TexelFormat::ALL {
        for zstd in [false, true] {
            let texture = texture(format, [60, 37, 1], 6, zstd);
            let bytes = written(&texture);
            let reader = Reader::new(bytes.as_slice()).expect("it is a KTX2 file");
            let header = reader.header();
            let vulkan = header.format.expect("a Vulkan format");
            assert_eq!((header.pixel_width, header.pixel_height, header.pixel_depth), (60, 37, 0));
            assert_eq!((header.layer_count, header.face_count, header.level_count), (0, 1, 6));
            assert_eq!(header.supercompression_scheme, zstd.then_some(SupercompressionScheme::Zstandard));
            let (basic, type_size) = Basic::from_format(vulkan).expect("a known format");
            assert_eq!(header.type_size, type_size);
            assert_eq!(reader.dfd_blocks(), [Block::Basic(basic.clone())]);
            let keys: Vec<&str> = reader.key_value_data().map(|(key, _)| key).collect();
            assert!(keys.is_sorted() && keys.contains(&"KTXorientation"), "{keys:?}");
            // Levels follow each other from the smallest to the finest, at multiples of 4 and of the block's
            // bytes.
            let places: Vec<(usize, usize)> = reader
                .levels()
                .map(|level| (level.data.as_ptr() as usize - bytes.as_ptr() as usize, level.data.len()))
                .collect();
            assert!(places.windows(2).all(|pair| pair[0].0 >= pair[1].0 + pair[1].1));
            assert_eq!(places[0].0 + places[0].1, bytes.len());
            let block = usize::from(basic.bytes_planes[0]).max(4);
            assert!(zstd || places.iter().all(|(offset, _)| offset % block == 0), "{format:?}: {places:?}");
        }
    }
    let bytes = written(&texture(TexelFormat::R16, [8, 4, 3], 1, false));
    let reader = Reader::new(bytes.as_slice()).expect("it is a KTX2 file");
    assert_eq!((reader.header().pixel_depth, reader.header().format), (3, Some(Format::R16_UNORM)));
}

#[test]
fn rows_are_asked_for_in_the_order_of_the_file() {
    let folder = Folder::new();
    let texture = Ktx2Texture { channels: 3, ..texture(TexelFormat::Rgba32F, [4, 2, 2], 2, false) };
    let mut asked = Vec::new();
    let path = folder.path().join("volume.ktx2");
    let result = write_ktx2(&path, &texture, &mut |row, texels| {
        asked.push((row.level, row.slice, row.row, row.channel));
        fill(row, texels)
    });
    result.expect("the folder is writable");
    let mut expected = vec![(1, 0, 0, 0), (1, 0, 0, 1), (1, 0, 0, 2)];
    for (slice, row) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        expected.extend((0..3).map(|channel| (0, slice, row, channel)));
    }
    assert_eq!(asked, expected);
    // The channel that the texture does not have is opaque.
    let file = read_ktx2(&path, LIMIT).expect("it is a texture");
    assert!(file.levels[0].planes[3].iter().all(|&opacity| opacity == 1.0));
}

#[test]
fn unstorable_data_are_refused_and_leave_no_file() {
    let folder = Folder::new();
    let path = folder.path().join("texture.ktx2");
    let plain = || texture(TexelFormat::R8, [4, 4, 1], 1, false);
    let reserved = Metadata::new(vec![("KTXcubemapIncomplete".into(), "1".into())]).expect("a valid name");
    let refused = [
        Ktx2Texture { size: [0, 4, 1], ..plain() },
        Ktx2Texture { size: [u32::MAX; 3], ..plain() },
        Ktx2Texture { levels: 0, ..plain() },
        Ktx2Texture { levels: 4, ..plain() },
        Ktx2Texture { channels: 2, ..plain() },
        Ktx2Texture { format: TexelFormat::Bc4, size: [4, 4, 4], ..plain() },
        Ktx2Texture { metadata: reserved, ..plain() },
    ];
    for texture in refused {
        let error = write_ktx2(&path, &texture, &mut fill).expect_err("it cannot be stored");
        assert!(matches!(error.problem, WriteProblem::NotStorable(_)), "{texture:?}: {error}");
    }
    for (key, value) in [("", "x"), ("a=b", "x"), ("é", "x"), (" a", "x"), ("a", "x\ny"), ("a", "x\0")] {
        assert!(Metadata::new(vec![(key.into(), value.into())]).is_err(), "{key} {value}");
    }
    let twice = vec![("a".to_owned(), "1".to_owned()), ("a".to_owned(), "2".to_owned())];
    assert!(Metadata::new(twice).is_err());
    // A row that cannot be had, with and without the compressor between.
    for zstd in [false, true] {
        let texture = texture(TexelFormat::R32F, [600, 600, 1], 1, zstd);
        let error = write_ktx2(&path, &texture, &mut |row, texels| match row.row {
            500 => Err(std::io::Error::other("no such row")),
            _ => fill(row, texels),
        });
        assert!(matches!(error.expect_err("a row is missing").problem, WriteProblem::Io(_)));
    }
    assert_eq!(std::fs::read_dir(folder.path()).expect("it is there").count(), 0);
}

#[test]
fn cut_off_files_are_errors() {
    for zstd in [false, true] {
        let bytes = written(&texture(TexelFormat::Rg16, [61, 37, 1], 6, zstd));
        let whole = bytes.len();
        for length in (0..400).chain((400..whole).step_by(97)).chain([whole - 1]) {
            // A KTX2 file ends with its finest level, so that no cut goes unseen.
            assert!(read(&bytes[..length.min(whole - 1)]).is_err(), "{length} of {whole} bytes are read");
        }
    }
}

#[test]
fn flipped_bits_never_panic() {
    for (format, zstd) in [(TexelFormat::R32F, false), (TexelFormat::R16, true), (TexelFormat::Bc7, true)] {
        let bytes = written(&texture(format, [61, 37, 1], 6, zstd));
        let folder = Folder::new();
        let mut random = Random::new(5);
        // Every bit of the container's numbers once, of the others some.
        let header = if zstd && format == TexelFormat::R16 { 8 * 230 } else { 0 };
        let content = (0..400).map(|_| random.below(8 * bytes.len())).collect::<Vec<usize>>();
        for bit in (0..header).chain(content) {
            let mut flipped = bytes.clone();
            flipped[bit / 8] ^= 1 << (bit % 8);
            let path = folder.file("flipped.ktx2", &flipped);
            // Either an error or another texture is correct.
            if let Ok(file) = read_ktx2(&path, LIMIT) {
                assert!(!file.levels.is_empty());
            }
            let _ = read_metadata(&path).is_ok();
        }
    }
}

/// Overwrites a number of the header.
fn patched(bytes: &[u8], offset: usize, value: u32) -> Vec<u8> {
    let mut patched = bytes.to_vec();
    patched[offset..offset + 4].copy_from_slice(&value.to_le_bytes());
    patched
}

#[test]
fn sizes_are_checked_before_memory_is_taken() {
    let plain = written(&texture(TexelFormat::R32F, [8, 8, 1], 1, false));
    let zstd = written(&texture(TexelFormat::R32F, [8, 8, 1], 1, true));
    let problem = |bytes: &[u8]| read(bytes).expect_err("it lies").problem;
    for bytes in [&plain, &zstd] {
        // Width and height of 2^20: 4 TiB.
        let huge = patched(&patched(bytes, 20, 1 << 20), 24, 1 << 20);
        assert!(matches!(problem(&huge), ReadProblem::TooMuchMemory { .. }));
        assert!(matches!(problem(&patched(bytes, 20, u32::MAX)), ReadProblem::Damaged { .. }));
        // This fits in the limit, but not in the file.
        let large = patched(&patched(bytes, 20, 2000), 24, 2000);
        assert!(matches!(problem(&large), ReadProblem::Damaged { .. }));
        assert!(matches!(problem(&patched(bytes, 40, 40)), ReadProblem::Damaged { .. }));
        // More key/value data than the file has bytes.
        assert!(matches!(problem(&patched(bytes, 60, u32::MAX)), ReadProblem::Damaged { .. }));
        // Array layers, cube faces, formats and compressions that are not read.
        for (offset, value) in [(32, 6), (36, 6), (12, 43), (12, 0), (44, 1), (44, 3)] {
            assert!(
                matches!(problem(&patched(bytes, offset, value)), ReadProblem::Unsupported { .. }),
                "{offset}"
            );
        }
    }
    // A frame whose length is less than any frame of that content needs.
    let mut bomb = patched(&patched(&zstd, 20, 2048), 24, 2048);
    bomb[80 + 16..80 + 24].copy_from_slice(&(4u64 * 2048 * 2048).to_le_bytes());
    assert!(matches!(problem(&bomb), ReadProblem::Damaged { .. }));
    assert!(matches!(problem(b""), ReadProblem::Empty));
    assert!(matches!(problem(&[7; 100]), ReadProblem::Unsupported { .. }));
    assert!(read_ktx2(Path::new("no such file"), LIMIT).is_err());
}
