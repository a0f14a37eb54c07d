//! Reading any file ends soon, in an error or a valid map.

use std::path::Path;
use std::time::{Duration, Instant};

use crate::common::Folder;
use crate::common::broken::{BrokenFile, Expect, broken_files, flipped, valid_files};
use relief_io::{
    DEFAULT_MAX_BYTES, GreenSign, HeightOptions, ReadProblem, inspect, read_height, read_normal_map,
    read_picture,
};

/// Number of flipped copies per valid file. Each of some 30 encodings gets as many.
const FLIPS: u64 = 120;

/// Reads a file with every reader. `HeightMap` itself checks the texels of a map.
fn read(folder: &Folder, file: &BrokenFile) -> bool {
    let path = folder.file(&format!("file.{}", file.extension), &file.bytes);
    let start = Instant::now();
    let map = read_height(&path, &file.options);
    let info = inspect(&path, &file.options);
    // Flips can turn a file into a valid or invalid one for these readers; they only must return.
    let _ = read_picture(&path, DEFAULT_MAX_BYTES);
    let _ = read_normal_map(&path, GreenSign::PlusY, DEFAULT_MAX_BYTES);
    assert!(start.elapsed() < Duration::from_secs(20), "{} takes too long", file.name);
    if map.is_ok() {
        assert!(info.is_ok(), "{}: it is read but not inspected", file.name);
    }
    match (&map, file.expect) {
        (Ok(_), Expect::Error) => panic!("{}: it was read", file.name),
        (Err(error), Expect::Map) => panic!("{}: {error}", file.name),
        _ => {}
    }
    if let Err(error) = &map {
        assert_eq!(error.path, path);
        assert!(!matches!(error.problem, ReadProblem::OutOfMemory { .. }), "{}: {error}", file.name);
    }
    map.is_ok()
}

#[test]
fn broken_files_are_refused_and_small_ones_read() {
    let folder = Folder::new();
    let files = broken_files();
    assert!(files.iter().filter(|file| file.expect == Expect::Error).count() >= 60);
    files.iter().for_each(|file| {
        read(&folder, file);
    });
}

#[test]
fn flipped_bits_give_an_error_or_a_valid_map() {
    let folder = Folder::new();
    for file in valid_files() {
        let survivors = (0..FLIPS).filter(|&seed| read(&folder, &flipped(&file, seed))).count();
        println!("{}: {survivors} of {FLIPS} are still read", file.name);
    }
}

#[test]
fn folders_and_missing_files_have_clear_errors() {
    let folder = Folder::new();
    let problem = |path: &Path| read_height(path, &HeightOptions::default()).expect_err("no file").problem;
    assert!(matches!(problem(folder.path()), ReadProblem::Folder));
    let missing = folder.path().join("missing.png");
    assert!(
        matches!(problem(&missing), ReadProblem::Io(error) if error.kind() == std::io::ErrorKind::NotFound)
    );
    assert!(matches!(problem(Path::new("")), ReadProblem::Io(_)));
}
