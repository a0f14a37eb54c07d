//! Each target over its corpus and over seeded changes of it.

use std::collections::HashSet;

use super::*;

/// Changed inputs a target.
const CHANGES: u64 = 2000;

fn assert_no_failure(target: &Target) {
    let corpus = target.corpus();
    for (at, input) in corpus.inputs().iter().enumerate() {
        assert_eq!(target.attempt(input), Ok(true), "{}: input {at} of the corpus", target.name);
    }
    let mut valid = 0;
    for seed in 0..CHANGES {
        match target.attempt(&corpus.mutated(seed)) {
            Ok(is_valid) => valid += u64::from(is_valid),
            Err(message) => panic!("{}, seed {seed}: {message}", target.name),
        }
    }
    // Changes that are all refused at the first byte, or that change nothing, would test nothing.
    assert!((CHANGES / 20..CHANGES).contains(&valid), "{}: {valid} of {CHANGES} are valid", target.name);
    println!("{}: {} in the corpus, {valid} of {CHANGES} are valid", target.name, corpus.inputs().len());
}

#[test]
fn height_maps_from_any_bytes() {
    assert_no_failure(&READ_HEIGHT);
}

#[test]
fn normal_maps_from_any_bytes() {
    assert_no_failure(&READ_NORMALS);
}

#[test]
fn pictures_from_any_bytes() {
    assert_no_failure(&READ_PICTURE);
}

#[test]
fn textures_from_any_bytes() {
    assert_no_failure(&READ_TEXTURE);
}

#[test]
fn volumes_from_any_bytes() {
    assert_no_failure(&READ_VOLUME);
}

#[test]
fn meshes_from_any_bytes() {
    assert_no_failure(&READ_MESH);
}

#[test]
fn objects_from_any_text() {
    assert_no_failure(&OBJECT);
}

#[test]
fn scenes_from_any_text() {
    assert_no_failure(&SCENE);
}

#[test]
fn bakes_of_any_map() {
    assert_no_failure(&BAKE);
}

#[test]
fn displaced_meshes_of_any_map() {
    assert_no_failure(&MESH);
}

/// The package of cargo-fuzz has a file for each target.
#[test]
fn cargo_fuzz_has_every_target() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fuzz/fuzz_targets");
    let files = std::fs::read_dir(folder).expect("the folder of cargo-fuzz's targets");
    let name = |path: std::path::PathBuf| path.file_stem().map(|name| name.to_string_lossy().into_owned());
    let files: HashSet<String> = files.flatten().filter_map(|file| name(file.path())).collect();
    assert_eq!(files, TARGETS.iter().map(|target| target.name.to_owned()).collect());
}

/// The same seed gives the same bytes, and most seeds give bytes of their own.
#[test]
fn mutations_follow_from_their_seed() {
    for target in [READ_HEIGHT, OBJECT, READ_MESH] {
        let corpus = target.corpus();
        let inputs: Vec<_> = (0..CHANGES).map(|seed| corpus.mutated(seed)).collect();
        let again = target.corpus();
        assert!((0..CHANGES).zip(&inputs).all(|(seed, input)| again.mutated(seed) == *input));
        let unlike: HashSet<_> = inputs.iter().collect();
        assert!(unlike.len() as u64 > CHANGES * 3 / 4, "{} of {CHANGES}", unlike.len());
    }
}

/// Faults that are planted in a target are found: by integers at borders, numbers in texts, cuts, and behind
/// the checksum of a PNG.
#[test]
fn planted_faults_are_found() {
    type IsHit = fn(&[u8]) -> bool;
    let faults: [(&str, IsHit, Target); 5] = [
        ("an integer", |input| input.windows(4).any(|bytes| bytes == [0xff, 0xff, 0xff, 0x7f]), READ_MESH),
        ("a number", |input| text(input).contains("-1e999"), OBJECT),
        ("a line twice", |input| text(input).contains("radius = 1.0\nradius = 1.0\n"), OBJECT),
        ("a cut", |input| input.len() < 8, READ_TEXTURE),
        ("a large picture", |input| is_large_png(input), READ_PICTURE),
    ];
    for (what, is_hit, target) in faults {
        let corpus = target.corpus();
        assert!(!corpus.inputs().iter().any(|input| is_hit(input)), "{what} is in the corpus");
        assert!((0..10_000).any(|seed| is_hit(&corpus.mutated(seed))), "{what} is not found");
    }
}

/// Whether a PNG with right checksums says that it is large.
fn is_large_png(input: &[u8]) -> bool {
    let Some(header) =
        input.get(1..).filter(|png| png.starts_with(b"\x89PNG")).and_then(|png| png.get(12..33))
    else {
        return false;
    };
    let mut checksum = flate2::Crc::new();
    checksum.update(&header[..17]);
    header[17..] == checksum.sum().to_be_bytes() && header[4..6] != [0, 0]
}

/// A panic becomes an error with the panic's message.
#[test]
fn panics_are_caught() {
    let target = Target {
        name: "panics",
        run: |input| {
            assert!(!input.is_empty(), "no bytes");
            true
        },
        make: || vec![vec![1]],
    };
    assert_eq!((target.attempt(&[1]), target.attempt(&[])), (Ok(true), Err("no bytes".to_owned())));
}
