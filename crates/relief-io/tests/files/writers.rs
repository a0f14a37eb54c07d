//! Written files are read back unchanged; failed writes leave nothing.

use std::io::{Cursor, Write};
use std::path::Path;

use crate::common::{Folder, channel};
use relief_io::{
    DEFAULT_MAX_BYTES, HeightOptions, LineSink, Metadata, PictureFormat, PictureSink, PngColour,
    WriteProblem, encode_exr_lines, encode_picture, read_height, read_picture, write_atomically, write_exr,
    write_exr_lines, write_picture, write_png8, write_png16,
};

fn entries(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .expect("the folder is there")
        .map(|entry| entry.expect("it is readable").file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

#[test]
fn png_round_trips() {
    let folder = Folder::new();
    let path = folder.path().join("map.png");
    let wide: Vec<u16> = (0..7 * 300).map(|at| (at * 31) as u16).collect();
    write_png16(&path, 300, 7, &wide).expect("the folder is writable");
    let map = read_height(&path, &HeightOptions::default()).expect("it is a map");
    let back: Vec<u16> = map.texels().iter().map(|texel| (texel * 65535.0).round() as u16).collect();
    assert_eq!((map.width(), map.height(), back), (300, 7, wide));

    for colour in [PngColour::Grey, PngColour::Rgb, PngColour::Rgba] {
        let samples: Vec<u8> = (0..5 * 4 * colour.channels()).map(|at| (at * 11) as u8).collect();
        write_png8(&path, 5, 4, colour, &samples).expect("the folder is writable");
        let picture = read_picture(&path, DEFAULT_MAX_BYTES).expect("it is a picture");
        assert_eq!((picture.width, picture.height), (5, 4));
        let name = if colour == PngColour::Grey { "y" } else { "b" };
        let map = read_height(&path, &channel(name)).expect("it is a map");
        let place = if colour == PngColour::Grey { 0 } else { 2 };
        for (texel, samples) in map.texels().iter().zip(samples.chunks(colour.channels())) {
            assert_eq!((texel * 255.0).round() as u8, samples[place]);
        }
    }
    assert_eq!(entries(folder.path()), ["map.png"]);
}

#[test]
fn exr_round_trips_bit_by_bit_and_is_the_same_every_time() {
    let folder = Folder::new();
    let (first, second) = (folder.path().join("a.exr"), folder.path().join("b.exr"));
    let (width, height) = (83, 41);
    let heights: Vec<f32> = (0..width * height).map(|at| (at as f32).sin() * 1e-3 + 8848.0).collect();
    let cones: Vec<f32> = (0..width * height).map(|at| 1.0 / (1.0 + at as f32)).collect();
    write_exr(&first, width, height, &[("height", &heights), ("cone", &cones)]).expect("it is writable");
    write_exr(&second, width, height, &[("height", &heights), ("cone", &cones)]).expect("it is writable");
    let bytes = |path| std::fs::read(path).expect("it was written");
    assert_eq!(bytes(&first), bytes(&second));
    let map = read_height(&first, &channel("cone")).expect("it is a map");
    assert_eq!(map.physical_range(), Some([f64::from(cones[cones.len() - 1]), 1.0]));
    // Bits of the samples survive where the range is already 0 to 1.
    let mut fractions = cones.clone();
    fractions[7] = 0.0;
    write_exr(&first, width, height, &[("cone", &fractions)]).expect("it is writable");
    assert_eq!(read_height(&first, &HeightOptions::default()).expect("it is a map").texels(), fractions);
}

#[test]
fn textures_that_do_not_fit_are_refused_and_leave_no_file() {
    let folder = Folder::new();
    let path = folder.path().join("map");
    let problem = |result: Result<(), relief_io::WriteError>| result.expect_err("it does not fit").problem;
    assert!(matches!(
        problem(write_png16(&path, 3, 3, &[0; 8])),
        WriteProblem::WrongLength { expected: 9, given: 8, .. }
    ));
    assert!(matches!(problem(write_png16(&path, 0, 3, &[])), WriteProblem::NotStorable(_)));
    assert!(matches!(
        problem(write_png8(&path, 2, 2, PngColour::Rgb, &[0; 16])),
        WriteProblem::WrongLength { expected: 12, given: 16, .. }
    ));
    assert!(matches!(problem(write_exr(&path, 1, 1, &[])), WriteProblem::NotStorable(_)));
    let twice: [(&str, &[f32]); 2] = [("a", &[0.0]), ("a", &[0.0])];
    assert!(matches!(problem(write_exr(&path, 1, 1, &twice)), WriteProblem::NotStorable(_)));
    for name in ["", "höhe", "a\0b", &"x".repeat(256)] {
        assert!(matches!(problem(write_exr(&path, 1, 1, &[(name, &[0.0])])), WriteProblem::NotStorable(_)));
    }
    write_exr(&path, 1, 1, &[(&"x".repeat(255), &[0.5])]).expect("the longest name");
    read_height(&path, &HeightOptions::default()).expect("it is a map");
    assert_eq!(entries(folder.path()), ["map"]);
}

#[test]
fn failed_writes_keep_the_old_file_and_leave_no_other() {
    let folder = Folder::new();
    let path = folder.file("kept.txt", b"old");
    let failed = write_atomically(&path, |out| {
        out.write_all(&[7; 100_000])?;
        Err(std::io::Error::from(std::io::ErrorKind::StorageFull))
    });
    let error = failed.expect_err("the disk was said to be full");
    assert!(matches!(error.problem, WriteProblem::Io(_)), "{error}");
    assert_eq!(std::fs::read(&path).expect("it is still there"), b"old");
    assert_eq!(entries(folder.path()), ["kept.txt"]);

    write_atomically(&path, |out: &mut dyn Write| out.write_all(b"new")).expect("the folder is writable");
    assert_eq!(std::fs::read(&path).expect("it is there"), b"new");

    let missing = folder.path().join("no such folder").join("file");
    let error = write_atomically(&missing, |_| Ok(())).expect_err("there is no such folder");
    assert!(matches!(error.problem, WriteProblem::Folder(_)), "{error}");
    std::fs::create_dir(folder.path().join("folder")).expect("it can be made");
    let error = write_atomically(&folder.path().join("folder"), |_| Ok(())).expect_err("it is a folder");
    assert!(matches!(error.problem, WriteProblem::Rename(_)), "{error}");
    let error = write_atomically(Path::new("/"), |_| Ok(())).expect_err("it is no file name");
    assert!(matches!(error.problem, WriteProblem::NoName), "{error}");
    assert_eq!(entries(folder.path()), ["folder", "kept.txt"]);
}

/// Where [`child`] writes to.
const TARGET: &str = "RELIEF_IO_WRITE_TARGET";

/// Not a test of its own: what the next one runs in a process that may not write large files.
#[test]
fn child() {
    let Some(path) = std::env::var_os(TARGET) else {
        return;
    };
    let mut random = crate::common::Random::new(3);
    let noise: Vec<u8> = (0..512 * 512).map(|_| random.below(256) as u8).collect();
    match write_png8(Path::new(&path), 512, 512, PngColour::Grey, &noise) {
        Ok(()) => println!("child: written"),
        Err(error) => println!("child: io error {}", matches!(error.problem, WriteProblem::Io(_))),
    }
}

#[cfg(unix)]
#[test]
fn a_full_disk_is_an_error_and_leaves_no_file() {
    let folder = Folder::new();
    let path = folder.file("map.png", b"old");
    let program = std::env::current_exe().expect("the test knows its program");
    // A limit of 16 KiB to each file, whose signal is ignored, fails a write as a full disk does.
    let output = std::process::Command::new("sh")
        .args(["-c", "trap '' XFSZ; ulimit -f 32; exec \"$0\" --exact writers::child --nocapture"])
        .arg(program)
        .env(TARGET, &path)
        .output()
        .expect("a shell runs");
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("child: io error true"), "{text}");
    assert_eq!(std::fs::read(&path).expect("it is still there"), b"old");
    assert_eq!(entries(folder.path()), ["map.png"]);
}

#[cfg(unix)]
#[test]
fn files_get_the_usual_permissions() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new();
    let usual = folder.file("usual", b"");
    let path = folder.path().join("written");
    write_atomically(&path, |_| Ok(())).expect("the folder is writable");
    let mode = |path: &Path| std::fs::metadata(path).expect("it is there").permissions().mode();
    assert_eq!(mode(&path), mode(&usual));
}

#[test]
fn encoded_bytes_are_those_of_the_file() {
    let folder = Folder::new();
    let path = folder.path().join("picture");
    let size = [37, 21];
    let value = |x: u32, y: u32| ((x * 7 + y * 13) % 97) as f32 / 96.0;
    let rows = |sink: &mut PictureSink<'_>| {
        (0..size[1]).try_for_each(|y| {
            let row: Vec<[f32; 3]> = (0..size[0]).map(|x| [value(x, y), value(y, x), 0.25]).collect();
            sink(&row)
        })
    };
    for format in [PictureFormat::Png8, PictureFormat::Png16, PictureFormat::Exr, PictureFormat::Jpeg] {
        write_picture(&path, size, format, rows).expect("the folder is writable");
        let mut bytes = Cursor::new(Vec::new());
        encode_picture(&mut bytes, size, format, rows).expect("memory is there");
        assert!(std::fs::read(&path).expect("it was written") == bytes.into_inner(), "{format:?}");
        let short = encode_picture(&mut Cursor::new(Vec::new()), size, format, |_| Ok(()));
        assert!(short.is_err(), "{format:?}");
    }
    let lines = |sink: &mut LineSink<'_>| {
        (0..size[1]).try_for_each(|y| {
            let line: Vec<f32> = (0..size[0]).map(|x| value(x, y)).collect();
            sink(&[&line, &line])
        })
    };
    let metadata = Metadata::default();
    write_exr_lines(&path, size, &["b", "a"], &metadata, lines).expect("the folder is writable");
    let mut bytes = Cursor::new(Vec::new());
    encode_exr_lines(&mut bytes, size, &["b", "a"], &metadata, lines).expect("memory is there");
    assert_eq!(std::fs::read(&path).expect("it was written"), bytes.into_inner());
}
