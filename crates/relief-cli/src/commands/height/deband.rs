//! `relief height deband`: turns the steps of few levels into slopes.

use std::collections::BTreeSet;
use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use clap::Args;
use relief_bake::deband::{BYTES_PER_TEXEL, DebandError, Debanding, deband, steps_of};
use relief_core::{ByteSize, HeightMap, Watch};
use relief_io::{DEFAULT_MAX_BYTES, HeightNote, Metadata, read_height_file};
use serde_json::json;

use super::annotated_heights::AnnotatedHeights;
use super::check_memory;
use super::output::{Content, Format, Output};
use crate::commands::maps::{self, HeightArguments, Note};
use crate::commands::staged::Staged;
use crate::failure::Failure;
use crate::interrupt::{self, cancelled};
use crate::progress::Progress;
use crate::streams::{Files, Written, tell_written};
use crate::{say, values};

/// Arguments of `relief height deband`.
#[derive(Args)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// Height map: PNG, JPEG, EXR, TIFF, GeoTIFF, HDR, PGM or headerless 16-bit raw
    height: PathBuf,
    /// Height map to write
    #[arg(short, long, value_name = "FILE.png|exr")]
    output: PathBuf,
    /// Number of levels from height 0 to height 1, 2 to 65536, as in 256 for 8 bits [default: found
    /// from the map's values]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(2..=65536))]
    levels: Option<u32>,
    /// Difference between neighbouring levels in the file's values, or in metres if the file states
    /// metres: above 0 [default: found from the map's values]
    #[arg(long, value_name = "S", conflicts_with = "levels", allow_hyphen_values = true)]
    step: Option<f64>,
    /// Format of a height map on standard output, as in -o - --format exr
    #[arg(long, value_enum, value_name = "png|exr", hide_short_help = true)]
    format: Option<Format>,
    /// Print the result as one JSON object
    #[arg(long)]
    pub(super) json: bool,
    /// Memory limit, as in 512MiB; work that needs more is refused [default: 4GiB]
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    max_memory: Option<ByteSize>,
    #[command(flatten)]
    reading: HeightArguments,
}

const AFTER_HELP: &str = "Examples:\n  relief height deband rock.png --channel a -o rock.exr\n  \
    relief height deband wall.png --wrap clamp -o wall16.png\n\n\
    8 bits hold 256 levels. Where a relief is gentle, each level becomes a terrace, and lights and occlusion \
    show its edge. `relief inspect` says when a map has such terraces.\n\n\
    The result is the map with the least curvature within half a step of the given one: no height moves \
    farther than rounding may have moved it. Where the relief is rougher than its steps, heights stay.\n\n\
    The step is found from the values that occur: 1/255 in 8 bits, and also the step of 8 bits that were \
    stretched or stored in 16. Write an EXR, or a PNG, which has 16 bits.";

/// Reads the map, smooths its steps and writes it.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let started = Instant::now();
    let Arguments { height: path, json, .. } = arguments;
    if let Some(step) = arguments.step.filter(|step| !(*step > 0.0 && step.is_finite())) {
        return Err(Failure::Usage(format!("--step: {step} cannot be used: it must be above 0")));
    }
    let output = Output::new("--output", &arguments.output, &[path])?;
    let file = {
        let _reading = Progress::spinner("reading", *json);
        read_height_file(path, &arguments.reading.options(arguments.max_memory)).map_err(Failure::of_map)?
    };
    let notes = maps::of_file(path, &file, &arguments.reading);
    if !json {
        notes.iter().for_each(say::note);
    }
    let map = file.map;
    let max_bytes = arguments.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0);
    check_memory([map.width(), map.height()], BYTES_PER_TEXEL, max_bytes)?;
    let step = arguments.step(&map)?;
    // Until here nothing exists that an interrupted program would leave behind.
    let cancel = interrupt::catch()?;
    let mut staged = Staged::open(&[&output.path], *json, cancel)?;
    let texels = {
        let bar = Progress::bar("smoothing", *json);
        let tell = |_: &str, part: f32| bar.show(part);
        deband(&map, &Debanding::of_step(step), &Watch::new(&tell, cancel)).map_err(of_deband)?
    };
    let moved = texels.iter().zip(map.texels()).filter(|(a, b)| a != b).count();
    let moved_percent = 100.0 * moved as f64 / texels.len() as f64;
    let content = content(&map, texels, step, &output)?;
    output.write(&mut staged, &content, cancel)?;
    staged.finish()?;
    let answer = Answer { step, moved_percent, seconds: started.elapsed().as_secs_f64() };
    answer.tell(arguments, &map, &output, &notes)
}

impl Arguments {
    /// Returns the files that may be standard streams.
    pub fn files(&mut self) -> Files<'_> {
        let format = self.format.map(Format::ending);
        let heights = Written { flag: "--output", path: &mut self.output, format };
        Files { read: vec![&mut self.height], written: vec![heights], ..Files::default() }
    }

    /// Returns the step in heights from 0 to 1.
    fn step(&self, map: &HeightMap) -> Result<f64, Failure> {
        if let Some(levels) = self.levels {
            return Ok(1.0 / f64::from(levels - 1));
        }
        if let Some(step) = self.step {
            let span = map.physical_range().map_or(1.0, |[zero, one]| (one - zero).abs());
            let part = step / span;
            if span > 0.0 && !(1e-7..=1.0).contains(&part) {
                let [step, span] = [step, span].map(values::six_digits);
                return Err(Failure::Usage(format!(
                    "--step: {step} does not fit heights 0 and 1, which are {span} apart: give a part of that"
                )));
            }
            return Ok(if span > 0.0 { part } else { 1.0 });
        }
        let [low, high] = map.extremes();
        if low == high {
            // Nothing will move in a level map.
            return Ok(1.0);
        }
        steps_of(map).map(|steps| steps.step).ok_or_else(|| {
            Failure::Work(format!(
                "{}: its values do not lie on equal steps, so none is found: if it was rounded before it was \
                 changed, give --levels or --step",
                self.height.display()
            ))
        })
    }
}

fn of_deband(error: DebandError) -> Failure {
    match error {
        DebandError::Cancelled(_) => cancelled(),
        other => Failure::work(other),
    }
}

/// Returns the lengths of the map's file, if it states any.
fn note(map: &HeightMap) -> Option<HeightNote> {
    if let Some([low, high]) = map.stated_displacement_m() {
        let tile_m = map.stated_tile_m().unwrap_or(map.proportions());
        return Some(HeightNote { tile_m, scale_m: high - low, bias_m: low, of_mesh: true });
    }
    let (tile_m, scale_m) = map.stated_lengths_m()?;
    let [zero, one] = map.physical_range()?;
    // Depths count downward.
    let bias_m = if zero <= one { zero } else { -zero };
    Some(HeightNote { tile_m, scale_m, bias_m, of_mesh: false })
}

fn content(map: &HeightMap, texels: Vec<f32>, step: f64, output: &Output) -> Result<Content, Failure> {
    let size = [map.width(), map.height()];
    let origin = vec![("settings", format!("step={step}")), ("source", map.heights_hash().to_string())];
    if let Some(note) = note(map) {
        let annotated = AnnotatedHeights {
            size,
            texels,
            wrap: map.wrap(),
            note,
            origin,
            published: None,
            guarantee: Some("no height moves by more than half a step"),
            more: Vec::new(),
        };
        return annotated.content(output);
    }
    // The given file states no lengths, so this one states none.
    let generator = ("generator", concat!("relief ", env!("CARGO_PKG_VERSION")).to_owned());
    let wrap = ("wrap", map.wrap().name().to_owned());
    let entries = origin.into_iter().chain([generator, wrap]);
    let entries = entries.map(|(name, value)| (format!("relief.{name}"), value)).collect();
    let metadata = Metadata::new(entries).map_err(|problem| Failure::Work(problem.to_string()))?;
    Ok(Content { size, names: &["height"], planes: vec![texels], bits: 16, metadata })
}

/// Figures of the answer.
struct Answer {
    step: f64,
    /// Share of the texels that moved.
    moved_percent: f64,
    seconds: f64,
}

impl Answer {
    fn tell(
        &self,
        arguments: &Arguments,
        map: &HeightMap,
        output: &Output,
        notes: &BTreeSet<Note>,
    ) -> Result<(), Failure> {
        let Self { step, moved_percent, seconds } = *self;
        let [width, height] = [map.width(), map.height()];
        tell_written(arguments.json, |out| {
            if arguments.json {
                let about = json!({
                    "input": arguments.height.display().to_string(),
                    "output": output.path.display().to_string(),
                    "width": width, "height": height, "step": step, "moved_percent": moved_percent,
                    "seconds": seconds, "notes": maps::as_json(notes),
                });
                writeln!(out, "{about:#}")?;
                return Ok(());
            }
            writeln!(out, "{}: {width}x{height} heights in {seconds:.2} s", output.path.display())?;
            let levels = values::six_digits(1.0 / step + 1.0);
            writeln!(out, "  step        {} ({levels} levels from 0 to 1)", values::six_digits(step))?;
            writeln!(out, "  moved       {moved_percent:.1} % of the texels, by at most half a step")?;
            if output.format == Format::Exr && note(map).is_none() {
                writeln!(out, "  range       as in the input, if read with --range 0,1")?;
            }
            Ok(())
        })
    }
}
