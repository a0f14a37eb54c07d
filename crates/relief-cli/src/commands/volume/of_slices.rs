//! Volumes of numbered pictures.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use relief_core::{HeightMap, MAX_SLICES, Volume};
use relief_io::{HeightOptions, ReadError, ReadProblem, read_height};
use serde_json::{Map, json};

use super::{Arguments, Made};
use crate::failure::Failure;
use crate::interrupt::cancelled;
use crate::pattern::Pattern;
use crate::progress::Progress;

/// Scale of pictures.
const DEFAULT_SCALE_M: f64 = 0.05;

/// Bytes that a voxel takes.
const BYTES_PER_VOXEL: u64 = 16;

pub(super) fn make(arguments: &Arguments, cancel: &AtomicBool) -> Result<Made, Failure> {
    let files = files(arguments)?;
    let bar = Progress::bar("reading", arguments.json);
    let mut channel = None;
    let mut size = None;
    let mut values = Vec::new();
    for (at, path) in files.iter().enumerate() {
        if cancel.load(Ordering::Relaxed) {
            return Err(cancelled());
        }
        let map = match channel {
            None => {
                // The first picture decides whether opacity counts.
                let opacity = read(arguments, path, Some("a"));
                let has_none = |error: &ReadError| matches!(error.problem, ReadProblem::UnknownChannel(_));
                match opacity {
                    Err(error) if has_none(&error) => {
                        channel = Some(None);
                        read(arguments, path, None)
                    }
                    other => {
                        channel = Some(Some("a"));
                        other
                    }
                }
            }
            Some(channel) => read(arguments, path, channel),
        };
        let map = map.map_err(Failure::of_picture)?;
        let found = [map.width(), map.height()];
        let first = *size.get_or_insert(found);
        if found != first {
            return Err(Failure::Work(format!(
                "{}: has {}x{} texels, but {} has {}x{}: give pictures of one size",
                path.display(),
                found[0],
                found[1],
                files[0].display(),
                first[0],
                first[1]
            )));
        }
        if at == 0 {
            arguments.check_memory([first[0], first[1], files.len() as u32], BYTES_PER_VOXEL, 0)?;
        }
        values.extend_from_slice(map.texels());
        bar.show((at + 1) as f32 / files.len() as f32);
    }
    drop(bar);
    let [width, height] = size.unwrap_or_default();
    let size = [width, height, files.len() as u32];
    if let Some(given) = arguments.size.filter(|given| *given != size) {
        let [a, b, c] = given;
        return Err(Failure::Usage(format!(
            "--size {a}x{b}x{c}: the pictures make {width}x{height}x{} voxels: leave it out",
            size[2]
        )));
    }
    let volume = Volume::new(size, &values, arguments.wrap.unwrap_or_default()).map_err(Failure::work)?;
    let tile_m = arguments.tile.unwrap_or([1.0, f64::from(height) / f64::from(width)]);
    let volume = volume.with_displacement(DEFAULT_SCALE_M, 0.0).map_err(Failure::work)?;
    let what = if channel.flatten().is_some() { "opacity" } else { "grey" };
    let lines = vec![("pictures", format!("{}, values by {what}", files.len()))];
    let about =
        Map::from_iter([("pictures".to_owned(), json!(files.len())), ("channel".to_owned(), json!(what))]);
    Ok(Made { volume, tile_m, lines, about, notes: Vec::new() })
}

/// Returns the pictures: from number 0 or 1 to the last before a number without a file.
fn files(arguments: &Arguments) -> Result<Vec<PathBuf>, Failure> {
    let name = arguments.input.display();
    let text = arguments.input.to_string_lossy();
    let pattern = Pattern::parse(&text).map_err(|error| Failure::Usage(format!("{name}: {error}")))?;
    let path = |number: u32| PathBuf::from(pattern.with(number));
    let Some(first) = [0, 1].into_iter().find(|number| path(*number).is_file()) else {
        let (zero, one) = (path(0), path(1));
        return Err(Failure::Work(format!(
            "{name}: there is neither {} nor {}: number the pictures from 0 or 1",
            zero.display(),
            one.display()
        )));
    };
    let files: Vec<PathBuf> =
        (first..=first + MAX_SLICES).map(path).take_while(|path| path.is_file()).collect();
    if files.len() > MAX_SLICES as usize {
        return Err(Failure::Work(format!("{name}: there are more than {MAX_SLICES} pictures: give fewer")));
    }
    Ok(files)
}

fn read(arguments: &Arguments, path: &Path, channel: Option<&str>) -> Result<HeightMap, ReadError> {
    let max_bytes = arguments.max_bytes();
    let options =
        HeightOptions { channel: channel.map(str::to_owned), max_bytes, ..HeightOptions::default() };
    read_height(path, &options)
}
