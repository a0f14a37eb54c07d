//! `readers`: small made PNG, TIFF and EXR files, read here and by Pillow, tifffile and OpenEXR.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use clap::Args;
use relief_io::{Channel, HeightOptions, inspect, read_height_file};
use serde_json::Value;

use crate::python::require;
use crate::table::table;

/// The script, which is run as it is here.
const SCRIPT: &str = include_str!("../python/readers_beside.py");

/// Files that lie in the folder at a time.
const BATCH: u64 = 1000;

/// What a texel's `f32` may be off, as a part of the channel's range.
const ROUNDING: f64 = 2e-7;

/// Arguments of `readers`.
#[derive(Args)]
pub struct Arguments {
    /// A Python with numpy, pillow, tifffile, imagecodecs and OpenEXR
    #[arg(long, value_name = "FILE", default_value = "python3")]
    python: PathBuf,
    /// Files, a third of each format
    #[arg(long, value_name = "N", default_value_t = 20_000)]
    files: u64,
    /// First seed: each file has its own
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// Differences of each kind that are printed
    #[arg(long, value_name = "N", default_value_t = 5)]
    examples: usize,
}

/// How two readings of a file compare.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Outcome {
    Same,
    SameWithNote,
    DifferentWithNote,
    OursRefuses,
    TheirsRefuses,
    BothRefuse,
    Different,
}

impl Outcome {
    const ALL: [(Self, &'static str); 7] = [
        (Self::Same, "same values"),
        (Self::SameWithNote, "same values, with a note"),
        (Self::DifferentWithNote, "other values, with a note"),
        (Self::OursRefuses, "error here alone"),
        (Self::BothRefuse, "error in both"),
        (Self::TheirsRefuses, "error there alone"),
        (Self::Different, "other values, silently"),
    ];
}

/// What became of all files, by format.
#[derive(Default)]
struct Tally {
    counts: BTreeMap<(String, Outcome), u64>,
    /// What is printed of errors and differences, once a kind.
    kinds: BTreeMap<(String, Outcome, String), Vec<String>>,
}

/// Prints the table, and fails where values differ silently.
pub fn run(arguments: &Arguments) -> Result<ExitCode, String> {
    let packages = "numpy pillow tifffile imagecodecs OpenEXR";
    require(&arguments.python, "import numpy, PIL, tifffile, imagecodecs, OpenEXR", packages)?;
    let mut tally = Tally::default();
    let (mut versions, mut unmade) = (Value::Null, 0);
    for first in (0..arguments.files).step_by(BATCH as usize) {
        let folder = tempfile::tempdir().map_err(|error| error.to_string())?;
        let count = BATCH.min(arguments.files - first);
        let answers = made(&arguments.python, folder.path(), arguments.seed + first, count)?;
        let (said, files) = answers.split_first().ok_or("the script said nothing")?;
        versions = said.clone();
        for file in files {
            if file.get("unmade").is_some() {
                unmade += 1;
                continue;
            }
            let name = file["file"].as_str().ok_or("a file has no name")?;
            let (outcome, why) = compared(&folder.path().join(name), file)?;
            let format = name.rsplit('.').next().unwrap_or_default().to_owned();
            let what = file["what"].as_str().unwrap_or_default();
            *tally.counts.entry((format.clone(), outcome.clone())).or_default() += 1;
            let example = format!("{name}: {what}: {why}");
            tally.kinds.entry((format, outcome, kind_of(&why))).or_default().push(example);
        }
    }
    print(&tally, &versions, unmade, arguments.examples);
    let silent = tally.counts.iter().filter(|((_, outcome), _)| *outcome == Outcome::Different);
    Ok(if silent.count() == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Lets the script make and read files.
fn made(python: &Path, folder: &Path, seed: u64, count: u64) -> Result<Vec<Value>, String> {
    let output = Command::new(python)
        .args(["-c", SCRIPT])
        .arg(folder)
        .args([seed.to_string(), count.to_string()])
        .output()
        .map_err(|error| format!("the readers cannot be run: {error}"))?;
    if !output.status.success() {
        return Err(format!("the script failed: {}", String::from_utf8_lossy(&output.stderr)));
    }
    let text = String::from_utf8_lossy(&output.stdout);
    text.lines().map(|line| serde_json::from_str(line).map_err(|error| format!("{error}: {line}"))).collect()
}

/// Compares both readings of a file, and says why they differ.
fn compared(path: &Path, theirs: &Value) -> Result<(Outcome, String), String> {
    let ours = read(path);
    let Some(channels) = theirs["channels"].as_array() else {
        let why = theirs["error"].as_str().unwrap_or_default().to_owned();
        let is_read = ours.is_ok();
        return Ok((if is_read { Outcome::TheirsRefuses } else { Outcome::BothRefuse }, why));
    };
    let ours = match ours {
        Ok(ours) => ours,
        Err(error) => return Ok((Outcome::OursRefuses, error)),
    };
    let bytes = fs::read(path.with_added_extension("samples")).map_err(|error| error.to_string())?;
    let samples: Vec<f64> = bytes.as_chunks::<8>().0.iter().map(|&bytes| f64::from_le_bytes(bytes)).collect();
    let size = [0, 1].map(|at| theirs["size"][at].as_u64().unwrap_or(0));
    let difference = difference(&ours, size, channels, &samples);
    let noted = ours.notes.join("; ");
    Ok(match (difference, noted.is_empty()) {
        (None, true) => (Outcome::Same, String::new()),
        (None, false) => (Outcome::SameWithNote, noted),
        (Some(_), false) => (Outcome::DifferentWithNote, noted),
        (Some(difference), true) => (Outcome::Different, difference),
    })
}

/// A file as it is read here.
struct Ours {
    size: [u64; 2],
    /// Name, fractions and raw range of each channel.
    channels: Vec<(String, Vec<f32>, [f64; 2])>,
    notes: Vec<String>,
}

/// Reads each channel as heights.
fn read(path: &Path) -> Result<Ours, String> {
    let info = inspect(path, &HeightOptions::default()).map_err(|error| error.problem.to_string())?;
    let mut ours = Ours { size: [info.width.into(), info.height.into()], channels: vec![], notes: vec![] };
    for Channel { name, .. } in &info.channels {
        let options = HeightOptions { channel: Some(name.clone()), ..HeightOptions::default() };
        let file = read_height_file(path, &options).map_err(|error| error.problem.to_string())?;
        // Notes on ranges are about heights and not about reading.
        let is_of_reading = |row: &str| !matches!(row, "narrow-range" | "fitted-range" | "undeclared-nodata");
        let notes = file.notes.iter().filter(|note| is_of_reading(note.remark.row.name));
        ours.notes.extend(notes.map(|note| note.remark.row.name.to_owned()));
        let range = file.map.physical_range().ok_or("it has no range")?;
        ours.channels.push((name.clone(), file.map.texels().to_vec(), range));
    }
    ours.notes.sort();
    ours.notes.dedup();
    Ok(ours)
}

/// The first thing in which the readings differ.
fn difference(ours: &Ours, size: [u64; 2], channels: &[Value], samples: &[f64]) -> Option<String> {
    if ours.size != size {
        return Some(format!("another size: {:?}, not {size:?}", ours.size));
    }
    let names: Vec<&str> = channels.iter().filter_map(|channel| channel[0].as_str()).collect();
    let mut found: Vec<&str> = ours.channels.iter().map(|(name, ..)| name.as_str()).collect();
    let mut expected = names.clone();
    found.sort_unstable();
    expected.sort_unstable();
    if found != expected {
        return Some(format!("channels {}, not {}", found.join(" "), expected.join(" ")));
    }
    let count = (size[0] * size[1]) as usize;
    for (name, texels, [low, high]) in &ours.channels {
        let at = names.iter().position(|other| other == name)?;
        let (white, off) = (channels[at][1].as_f64().unwrap_or(0.0), channels[at][2].as_f64().unwrap_or(0.0));
        let theirs = &samples[at * count..][..count];
        let is_off = |(&texel, &sample): (&f32, &f64)| {
            let (value, wanted, span) = if white > 0.0 {
                (f64::from(texel), sample / white, 1.0)
            } else {
                let largest = low.abs().max(high.abs());
                (low + f64::from(texel) * (high - low), sample, (high - low).max(1e-6 * largest))
            };
            let is_near = (value - wanted).abs() <= (off + ROUNDING) * span;
            !is_near
        };
        let wrong = texels.iter().zip(theirs).filter(|&pair| is_off(pair)).count();
        if wrong > 0 {
            return Some(format!("{wrong} of {count} values of a channel"));
        }
    }
    None
}

/// The words of an error that hold no number and no path, so that errors of a kind are one.
fn kind_of(error: &str) -> String {
    let is_word = |word: &&str| !word.contains(|letter: char| letter.is_ascii_digit() || letter == '/');
    let words: Vec<&str> = error.split_whitespace().filter(is_word).take(16).collect();
    words.join(" ")
}

fn print(tally: &Tally, versions: &Value, unmade: u64, examples: usize) {
    for ((format, outcome, why), files) in &tally.kinds {
        if matches!(outcome, Outcome::Same) {
            continue;
        }
        let name = Outcome::ALL.iter().find(|(known, _)| known == outcome).map_or("", |(_, name)| name);
        println!("{format}, {name}, {} files: {why}", files.len());
        files.iter().take(examples).for_each(|file| println!("    {file}"));
    }
    let formats = [("png", "PNG"), ("tif", "TIFF"), ("exr", "EXR")];
    let mut table = table(&["", "PNG", "TIFF", "EXR", "all"]);
    for (outcome, name) in Outcome::ALL {
        let count =
            |format: &str| tally.counts.get(&(format.to_owned(), outcome.clone())).copied().unwrap_or(0);
        let counts = formats.map(|(format, _)| count(format));
        let all = counts.iter().sum::<u64>();
        table.add_row(
            [name.to_owned()].into_iter().chain(counts.into_iter().chain([all]).map(|n| n.to_string())),
        );
    }
    println!("\n{table}\n\n{unmade} pairs of settings that a peer does not write; {versions}");
}
