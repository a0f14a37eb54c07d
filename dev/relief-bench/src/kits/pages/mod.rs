//! What `relief engine` writes, opened as a stranger would: a height map becomes a page of three.js and a
//! scene of Godot by one command each.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::godot;
use crate::chromium;

/// Width of the pictures.
const WIDTH: usize = 400;

/// Least mean step from a pixel to the next in a picture of a lit relief. A smooth torus has a third of it.
pub const LEAST_STEP: f64 = 1.5;

/// Opens both. Returns the mean step from a pixel to the next in each picture.
pub fn open(relief: &Path, chromium: &Path) -> Result<[f64; 2], String> {
    let map = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/cobbles.png");
    let write = |engine: &str| -> Result<Vec<(String, Vec<u8>)>, String> {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let mut command = Command::new(relief);
        command.args(["-q", "engine", engine]).arg(&map).args(["--mesh", "torus", "--tile", "5,2"]);
        let output = command.args(["--scale", "3cm", "-o"]).arg(folder.path()).output();
        let output = output.map_err(|error| format!("{}: {error}: give it by --relief", relief.display()))?;
        if !output.status.success() {
            return Err(String::from_utf8_lossy(&output.stderr).into_owned());
        }
        files_of(folder.path())
    };
    let mut page = write("three")?;
    let of_page = page.iter().find(|(name, _)| name == "index.html").ok_or("there is no page")?;
    let looked_at = [include_bytes!("look.html").as_slice(), &of_page.1].concat();
    page.push(("looked_at.html".to_owned(), looked_at));
    let moved = b"<script>location.replace('looked_at.html?webgl')</script>".to_vec();
    page.push(("page.html".to_owned(), moved));
    let three = chromium::answer(chromium, &borrowed(&page)).map_err(|error| format!("three.js: {error}"))?;
    let scene = write("godot")?;
    // Pictures need an import, which is the editor's work. Without colours none is shown.
    let files = scene.into_iter().filter(|(name, _)| !name.ends_with(".png"));
    let mut game: Vec<(String, Vec<u8>)> =
        files.map(|(name, bytes)| (format!("stones/{name}"), bytes)).collect();
    game.push(("main.gd".to_owned(), include_bytes!("main.gd").to_vec()));
    let godot = godot::run(chromium, game)?;
    let steps = [three, godot].map(|pixels| mean_step(&pixels, WIDTH));
    match steps.iter().all(|step| *step >= LEAST_STEP) {
        true => Ok(steps),
        false => Err(format!("from a pixel to the next are {steps:?} steps: no relief is shown")),
    }
}

/// The mean difference of green between neighbours in a row.
pub fn mean_step(pixels: &[u8], width: usize) -> f64 {
    let greens: Vec<f64> = pixels.as_chunks::<4>().0.iter().map(|pixel| f64::from(pixel[1])).collect();
    let steps = greens.chunks(width).flat_map(|row| row.windows(2).map(|pair| (pair[1] - pair[0]).abs()));
    let (sum, count) = steps.fold((0.0, 0), |(sum, count), step| (sum + step, count + 1));
    sum / f64::from(count.max(1))
}

fn borrowed(files: &[(String, Vec<u8>)]) -> Vec<(&str, &[u8])> {
    files.iter().map(|(name, bytes)| (name.as_str(), bytes.as_slice())).collect()
}

fn files_of(folder: &Path) -> Result<Vec<(String, Vec<u8>)>, String> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(|error| error.to_string())? {
        let path = entry.map_err(|error| error.to_string())?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        files.push((name, fs::read(&path).map_err(|error| error.to_string())?));
    }
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_within_rows_count() {
        let row = |greens: [u8; 2]| -> Vec<u8> {
            (0..WIDTH).flat_map(|column| [0, greens[column % 2], 0, 255]).collect()
        };
        assert_eq!(mean_step(&[row([10, 14]), row([90, 94])].concat(), WIDTH), 4.0);
        assert_eq!(mean_step(&row([7, 7]), WIDTH), 0.0);
    }
}
