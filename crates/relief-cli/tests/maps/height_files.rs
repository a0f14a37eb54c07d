//! Files of `relief height`: all of one run, whatever becomes of the process.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::process::Stdio;
use std::time::Instant;

use crate::common::command::Folder;
use crate::common::maps::encoded;
use image::{DynamicImage, ImageFormat, RgbImage};
use relief_io::file_set::FileSet;

/// A folder with three photographs and their lights.
fn map_folder() -> Folder {
    let folder = Folder::new();
    let mut lights = String::new();
    for (at, light) in ["[0.5, 0.1, 1]", "[-0.5, 0, 1]", "[0, 0.5, 1]"].iter().enumerate() {
        let grey = |x: u32, y: u32| 90 + ((x * (3 + at as u32) + y * 5) % 60) as u8;
        let photo = RgbImage::from_fn(160, 120, |x, y| image::Rgb([grey(x, y); 3]));
        folder.write(&format!("{at}.png"), encoded(&DynamicImage::ImageRgb8(photo), ImageFormat::Png));
        lights += &format!("[[photo]]\nfile = '{at}.png'\nlight = {light}\n");
    }
    folder.write("bright.toml", format!("{lights}intensity = 1.5\n"));
    folder.write("lights.toml", lights);
    for out in ["out", "elsewhere"] {
        std::fs::create_dir(folder.path(out)).expect("writable");
    }
    folder
}

/// Three outputs in two folders, of other bytes for other lights.
fn line(lights: &str) -> String {
    format!("height from-photos {lights} -o out/h.exr --normals out/n.png --albedo elsewhere/a.exr")
}

/// Everything in both folders, hidden files and folders, too.
fn files(folder: &Folder) -> BTreeMap<PathBuf, Vec<u8>> {
    let entries = ["out", "elsewhere"].map(|out| std::fs::read_dir(folder.path(out)).expect("it is there"));
    let paths = entries.into_iter().flatten().map(|entry| entry.expect("readable").path());
    paths.map(|path| (path.clone(), std::fs::read(&path).unwrap_or_default())).collect()
}

#[test]
fn killed_runs_leave_the_files_of_one_run_and_nothing_over() {
    const LIGHTS: [&str; 2] = ["lights.toml", "bright.toml"];
    let folder = map_folder();
    let mut took = Vec::new();
    let sets = LIGHTS.map(|lights| {
        let started = Instant::now();
        folder.relief(&line(lights)).fine();
        took.push(started.elapsed());
        files(&folder)
    });
    assert!(sets[0].len() == 3 && sets[0].iter().zip(&sets[1]).all(|(one, other)| one.1 != other.1));
    let mut state = 1u32;
    for round in 0..20 {
        let mut command = folder.command();
        command.args(line(LIGHTS[round % 2]).split_ascii_whitespace());
        let run = command.stdout(Stdio::null()).stderr(Stdio::null()).spawn();
        let mut run = run.expect("the command starts");
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        std::thread::sleep(took[1].mul_f64(1.1 * f64::from(state) / f64::from(u32::MAX)));
        run.kill().expect("it is ours");
        run.wait().expect("it ends");
        // The next run cleans up first.
        drop(FileSet::open(&folder.path("out"), "h.exr", &mut |_| false).expect("nobody holds it"));
        let left = files(&folder);
        assert!(sets.contains(&left), "round {round}: {:?}", left.keys());
    }
    folder.relief(&line(LIGHTS[0])).fine();
    assert_eq!(files(&folder), sets[0]);
}

#[cfg(unix)]
#[test]
fn links_stay_and_second_names_of_inputs_are_refused() {
    let folder = map_folder();
    std::os::unix::fs::symlink("../elsewhere/h.exr", folder.path("out/h.exr")).expect("writable");
    for _ in 0..2 {
        folder.relief(&line("lights.toml")).fine();
        assert!(folder.path("out/h.exr").is_symlink() && folder.path("elsewhere/h.exr").is_file());
        assert_eq!(files(&folder).len(), 4);
    }
    std::fs::hard_link(folder.path("0.png"), folder.path("out/second.png")).expect("writable");
    let refused = folder.relief("height from-photos lights.toml -o out/second.png");
    assert!(refused.code == Some(2) && refused.stderr.contains("0.png"), "{refused:?}");
    assert_eq!(files(&folder).len(), 5);
}
