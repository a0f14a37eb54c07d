//! Bytes in memory are read like a file, errors included.

use std::path::Path;

use crate::common::broken::{BrokenFile, broken_files, flipped, valid_files};
use crate::common::tiff_file::Tiff;
use crate::common::{Folder, Random};
use relief_io::{
    Convention, DEFAULT_MAX_BYTES, Files, GreenSign, HeightNote, HeightOptions, Ktx2Texture, MemoryFiles,
    PngTexture, ReadError, ReadProblem, Row, Source, TexelFormat, inspect, read_height, read_ktx2,
    read_metadata, read_normal_map, read_normal_vectors, read_picture, read_vector_map, write_exr_rows,
    write_ktx2, write_png_rows,
};

/// Flips of bits a valid file.
const FLIPS: u64 = 8;

/// Result of a reader as text, so that NaN values compare equal.
fn answer<T: std::fmt::Debug>(read: Result<T, ReadError>) -> String {
    match read {
        Ok(read) => format!("{read:?}"),
        Err(error) => {
            let kind = std::mem::discriminant(&error.problem);
            format!("{kind:?} {error}")
        }
    }
}

/// Results of all readers.
fn answers(source: Source<'_>, options: &HeightOptions) -> [String; 8] {
    [
        answer(read_height(source, options)),
        answer(inspect(source, options)),
        answer(read_picture(source, DEFAULT_MAX_BYTES)),
        answer(read_normal_map(source, GreenSign::PlusY, DEFAULT_MAX_BYTES)),
        answer(read_normal_vectors(source, DEFAULT_MAX_BYTES)),
        answer(read_vector_map(source, DEFAULT_MAX_BYTES)),
        answer(read_ktx2(source, DEFAULT_MAX_BYTES)),
        answer(read_metadata(source)),
    ]
}

fn assert_same(name: &str, path: &Path, bytes: &[u8], options: &HeightOptions) {
    let from_file = answers(path.into(), options);
    let mut memory = MemoryFiles::new();
    memory.insert(path, bytes).expect("a path");
    let files = Files::Memory(memory);
    let from_memory = [Source::bytes(path, bytes), files.source(path)].map(|source| answers(source, options));
    let each = from_memory.iter().flat_map(|answers| from_file.iter().zip(answers).enumerate());
    for (reader, (from_file, from_bytes)) in each {
        let start = |text: &str| text.chars().take(200).collect::<String>();
        assert!(
            *from_file == *from_bytes,
            "{name}, reader {reader}: {}, not {}",
            start(from_bytes),
            start(from_file)
        );
    }
}

/// Compares a file and its beginnings, cut off at many lengths.
fn assert_same_cut_off(folder: &Folder, name: &str, path: &Path) {
    let bytes = std::fs::read(path).expect("it was written");
    assert_same(name, path, &bytes, &HeightOptions::default());
    let mut random = Random::new(7);
    for _ in 0..40 {
        let cut = &bytes[..random.below(bytes.len())];
        let path = folder.file("cut", cut);
        assert_same(&format!("{name} cut at {}", cut.len()), &path, cut, &HeightOptions::default());
    }
}

#[test]
fn files_read_like_their_bytes_whole_and_broken() {
    let folder = Folder::new();
    let same = |file: &BrokenFile| {
        let path = folder.file(&format!("file.{}", file.extension), &file.bytes);
        assert_same(&file.name, &path, &file.bytes, &file.options);
    };
    broken_files().iter().for_each(same);
    for file in valid_files() {
        (0..FLIPS).for_each(|seed| same(&flipped(&file, seed)));
    }
}

#[test]
fn textures_with_notes_read_like_their_bytes() {
    let folder = Folder::new();
    let mut fill = |row: Row, texels: &mut [f32]| {
        texels.iter_mut().enumerate().for_each(|(column, texel)| {
            *texel = (column as u32 + row.row * 3 + row.level) as f32 / 64.0;
        });
        Ok(())
    };
    let note = HeightNote { tile_m: [3.0, 0.5], scale_m: 0.25, bias_m: -0.1, of_mesh: false };
    let metadata = note.metadata(Vec::new()).expect("plain text");
    let [png, exr] = ["a.png", "a.exr"].map(|name| folder.path().join(name));
    let texture = PngTexture { width: 9, height: 5, channels: 1, bits: 16 };
    write_png_rows(&png, &texture, &metadata, &mut fill).expect("the folder is writable");
    write_exr_rows(&exr, 9, 5, &["height"], &metadata, &mut fill).expect("the folder is writable");
    for path in [&png, &exr] {
        let bytes = std::fs::read(path).expect("it was written");
        let map = read_height(Source::bytes("a", &bytes), &HeightOptions::default()).expect("a valid map");
        assert_eq!(map.texel_size_m(), Some([3.0 / 9.0, 0.1]), "{}", path.display());
        assert_eq!(map.stated_displacement_m(), None, "of any mesh");
        assert_same_cut_off(&folder, "a noted map", path);
    }
    // Of the mesh that a map was made for the displacements are known, whatever its least and greatest texel.
    let of_mesh = HeightNote { of_mesh: true, ..note }.metadata(Vec::new()).expect("plain text");
    write_png_rows(&png, &texture, &of_mesh, &mut fill).expect("the folder is writable");
    write_exr_rows(&exr, 9, 5, &["height"], &of_mesh, &mut fill).expect("the folder is writable");
    for path in [&png, &exr] {
        let map = read_height(path, &HeightOptions::default()).expect("a valid map");
        let [low, high] = map.stated_displacement_m().expect("the file says it");
        assert_eq!([low, high - low], [map.bias_m(), map.scale_m()]);
        let metres = map.displacement_m(f64::from(map.texel(4, 2)));
        assert!((metres - (-0.1 + 0.25 * 10.0 / 64.0)).abs() < 1e-5, "{}: {metres}", path.display());
        let depth = HeightOptions { convention: Some(Convention::Depth), ..HeightOptions::default() };
        let map = read_height(path, &depth).expect("a valid map");
        assert_eq!(map.stated_displacement_m(), None, "what is deep is no displacement outward");
    }
    for format in [TexelFormat::Rgba8, TexelFormat::R16F, TexelFormat::Rg32F, TexelFormat::Bc5] {
        for zstd in [false, true] {
            let path = folder.path().join("texture.ktx2");
            let texture = Ktx2Texture {
                format,
                size: [12, 8, 1],
                levels: 3,
                channels: format.channels(),
                zstd,
                metadata: metadata.clone(),
            };
            write_ktx2(&path, &texture, &mut fill).expect("the folder is writable");
            assert_same_cut_off(&folder, &format!("{format:?}, Zstandard {zstd}"), &path);
        }
    }
}

/// Files of GDAL say at their beginning how blocks are wrapped, which is read besides headers and blocks.
/// Here the first block says so, and no block is wrapped.
#[test]
fn compressed_tiffs_read_alike_from_files_and_bytes() {
    let folder = Folder::new();
    let (width, height) = (64, 48);
    for wrapping in ["BLOCK_LEADER=SIZE_AS_UINT4\n", "BLOCK_TRAILER=LAST_4_BYTES_REPEATED\n"] {
        let text = format!("GDAL_STRUCTURAL_METADATA_SIZE={:06} bytes\n{wrapping}", wrapping.len());
        let samples = text.bytes().map(f64::from).chain((0..).map(|at| f64::from(at % 251)));
        let samples: Vec<f64> = samples.take((width * height) as usize).collect();
        let bytes = Tiff::grey(width, height, 8, 1).bytes(&samples);
        assert!(bytes[8..].starts_with(text.as_bytes()), "the first block follows the header");
        let path = folder.file("wrapped.tif", &bytes);
        assert!(read_height(&path, &HeightOptions::default()).is_ok());
        assert_same(wrapping, &path, &bytes, &HeightOptions::default());
    }
}

#[test]
fn bytes_are_named_in_errors() {
    let problem = |name, bytes: &[u8]| {
        let source = Source::bytes(name, bytes);
        let error = read_height(source, &HeightOptions::default()).expect_err("no map");
        assert!(error.path == source.name() && error.to_string().starts_with(name), "{error}");
        error.problem
    };
    assert!(matches!(problem("terrain.r16", &[7; 128]), ReadProblem::NeedsRawLayout));
    assert!(matches!(problem("terrain", &[7; 128]), ReadProblem::Unrecognised));
    assert!(matches!(problem("terrain.png", &[]), ReadProblem::Empty));
    let empty = Source::bytes("nothing", &[]);
    assert_eq!(format!("{empty:?}"), "Source { name: \"nothing\", len: Some(0) }");
    let problems = [
        read_picture(empty, DEFAULT_MAX_BYTES).map(drop),
        read_normal_map(empty, GreenSign::PlusY, DEFAULT_MAX_BYTES).map(drop),
        read_normal_vectors(empty, DEFAULT_MAX_BYTES).map(drop),
        read_vector_map(empty, DEFAULT_MAX_BYTES).map(drop),
        inspect(empty, &HeightOptions::default()).map(drop),
        read_ktx2(empty, DEFAULT_MAX_BYTES).map(drop),
        read_metadata(empty).map(drop),
    ];
    for read in problems {
        assert!(matches!(read.expect_err("no bytes").problem, ReadProblem::Empty));
    }
}
