//! `sheet`: what a new user sees of every map in a folder: the picture without any flag, or the error.

use std::path::{Path, PathBuf};

use clap::Args;
use relief_core::Watch;
use relief_io::{PictureFormat, write_picture};
use relief_maps::Maps;
use relief_render::picture::{linear, srgb};
use relief_render::render;
use relief_scene::{BackendChoice, SceneSpec, SurfaceSpec};

use crate::table::table;

/// Size of a picture on the sheet.
const SIZE: [u32; 2] = [144, 108];

/// Pictures of a row of the sheet.
const COLUMNS: usize = 6;

/// Between which bytes the mean of the pixels that show a surface lies, where nothing is washed out nor too
/// dark.
const MEAN: std::ops::RangeInclusive<f64> = 70.0..=180.0;

/// The most of the pictures whose mean may lie elsewhere: one in ten.
const ODD: f64 = 0.1;

/// Endings of the names of files that hold no picture.
const OTHERS: [&str; 6] = ["md", "txt", "obj", "toml", "zip", "relief-manifest"];

/// Arguments of `sheet`.
#[derive(Args)]
pub struct Arguments {
    /// Folder with height maps; files in folders below it count, too
    folder: PathBuf,
    /// Sheet of all pictures to write
    #[arg(short, long, default_value = "docs/notes/first-try.png")]
    output: PathBuf,
}

/// A picture, and the mean of its bytes where it shows a surface.
struct Shown {
    rows: Vec<Vec<[f32; 3]>>,
    mean: f64,
    covered: f64,
}

/// Writes the sheet and prints the table.
pub fn run(arguments: &Arguments) -> Result<(), String> {
    let mut files = Vec::new();
    collect(&arguments.folder, &mut files).map_err(|error| error.to_string())?;
    files.sort();
    let mut table = table(&["map", "place on the sheet", "covered", "mean byte"]);
    let (mut shown, mut refused) = (Vec::new(), Vec::new());
    for file in &files {
        let name = file.strip_prefix(&arguments.folder).unwrap_or(file).display().to_string();
        match show(file) {
            Ok(picture) => {
                let (row, column) = (shown.len() / COLUMNS + 1, shown.len() % COLUMNS + 1);
                table.add_row([
                    name,
                    format!("row {row}, {column}"),
                    format!("{:.0} %", 100.0 * picture.covered),
                    format!("{:.0}", picture.mean),
                ]);
                shown.push(picture);
            }
            Err(error) => {
                // The folder is not the same for everyone.
                let folder = format!("{}/", arguments.folder.display());
                refused.push(error.replace(&folder, ""));
            }
        }
    }
    println!("{table}\n");
    println!("Refused:\n");
    for error in &refused {
        println!("* {error}");
    }
    let odd = shown.iter().filter(|picture| !MEAN.contains(&picture.mean)).count();
    println!("\n{} of {} pictures have a mean from 70 to 180.", shown.len() - odd, shown.len());
    write(&shown, &arguments.output)?;
    let is_fine = odd as f64 <= ODD * shown.len() as f64;
    if is_fine { Ok(()) } else { Err(format!("{odd} pictures are too dark or too bright")) }
}

fn collect(folder: &Path, files: &mut Vec<PathBuf>) -> std::io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        let ending = path.extension().map(|ending| ending.to_string_lossy().into_owned()).unwrap_or_default();
        if path.is_dir() {
            collect(&path, files)?;
        } else if !OTHERS.contains(&ending.as_str()) {
            files.push(path);
        }
    }
    Ok(())
}

fn show(file: &Path) -> Result<Shown, String> {
    let surface = SurfaceSpec { height: Some(file.to_owned()), ..SurfaceSpec::default() };
    let spec = SceneSpec {
        size: Some(SIZE.into()),
        backend: Some(BackendChoice::Cpu),
        ..SceneSpec::of_surface(surface)
    };
    let scene = spec.load().map_err(|error| error.to_string())?;
    let rendered =
        render(&scene, &mut Maps::in_memory(), &Watch::none()).map_err(|error| error.to_string())?;
    let pixels = &rendered.rendering.pixels;
    let colours: Vec<[f32; 3]> = linear(&rendered.rendering, &scene).into_iter().map(srgb).collect();
    let (mut sum, mut covered) = (0.0, 0usize);
    for (colour, _) in colours.iter().zip(pixels).filter(|(_, pixel)| pixel.hit == 1) {
        sum += colour.iter().map(|part| f64::from(*part) * 255.0).sum::<f64>() / 3.0;
        covered += 1;
    }
    let mean = if covered == 0 { 0.0 } else { sum / covered as f64 };
    let rows = colours.chunks(SIZE[0] as usize).map(<[_]>::to_vec).collect();
    Ok(Shown { rows, mean, covered: covered as f64 / pixels.len() as f64 })
}

fn write(shown: &[Shown], path: &Path) -> Result<(), String> {
    let [width, height] = SIZE.map(|side| side as usize);
    let rows = shown.len().div_ceil(COLUMNS);
    let size = [(COLUMNS * width) as u32, (rows * height) as u32];
    let written = write_picture(path, size, PictureFormat::Png8, |sink| {
        for row in 0..rows * height {
            let mut line = Vec::with_capacity(COLUMNS * width);
            for column in 0..COLUMNS {
                match shown.get(row / height * COLUMNS + column) {
                    Some(picture) => line.extend(&picture.rows[row % height]),
                    None => line.extend(std::iter::repeat_n([0.0; 3], width)),
                }
            }
            sink(&line)?;
        }
        Ok(())
    });
    written.map_err(|error| error.to_string())
}
