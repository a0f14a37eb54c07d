//! `relief height procedure`: generates height maps from a formula.

use std::fmt::Write as _;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};
use std::time::Instant;

use clap::Args;
use rayon::prelude::*;
use relief_core::{ByteSize, HeightMap, Watch, Wrap};
use relief_io::{DEFAULT_MAX_BYTES, HeightNote};
use relief_shaders::Entry;
use relief_shaders::procedure::{ENTRIES, Procedure};
use serde_json::json;

use super::annotated_heights::AnnotatedHeights;
use super::check_memory;
use super::output::{Content, Format, Output, check_distinct};
use crate::commands::numbered::Numbering;
use crate::commands::staged::Staged;
use crate::failure::Failure;
use crate::frames::Frames;
use crate::progress::Progress;
use crate::streams::{Files, Written, tell_written};
use crate::{interrupt, units, values};

/// Bytes per texel of the outputs.
const BYTES_PER_TEXEL: u64 = 12;

/// Rows that one task fills.
const BAND: u32 = 16;

/// Publication of the formulas.
const PUBLISHED: &str = "Szirmay-Kalos and Umenhoffer 2008 3.1";

/// Arguments of `relief height procedure`.
#[derive(Args)]
#[command(after_help = after_help())]
pub struct Arguments {
    /// Formula: waves, fbm or bumps
    procedure: String,
    /// Height map to write; with --frames, a name with a placeholder for the frame number, as in
    /// waves_%04d.png
    #[arg(short, long, value_name = "FILE.png|exr")]
    output: PathBuf,
    /// Parameter of the formula, as in count=8; repeatable; listed below
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting)]
    settings: Vec<(String, f64)>,
    /// Width and height of the map in texels
    #[arg(
        long,
        value_name = "WxH",
        value_parser = values::size,
        default_value = "512x512",
        allow_hyphen_values = true
    )]
    size: [u32; 2],
    /// Time in periods of the animation: 0 and 1 show the same
    #[arg(long, value_name = "T", default_value_t = 0.0, allow_hyphen_values = true)]
    time: f64,
    /// Write one map per frame number from A to B, inclusive, as in 0..47; together they are one
    /// period
    #[arg(long, value_name = "A..B", allow_hyphen_values = true)]
    frames: Option<Frames>,
    /// Seed of the random numbers
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u32,
    /// Displacement in metres between heights 0 and 1, stored in the file
    #[arg(
        long,
        value_name = "M",
        value_parser = units::length,
        default_value = "0.05",
        allow_hyphen_values = true
    )]
    scale: f64,
    /// Size of the map along u and v in metres, one number or two [default: 1 m for the longer
    /// side]
    #[arg(long, value_name = "U[,V]", value_parser = units::one_or_two_lengths, allow_hyphen_values = true)]
    tile_size: Option<[f64; 2]>,
    /// Also write the formula as WGSL: a function of texture coordinates, time, seed and parameters
    #[arg(long, value_name = "FILE.wgsl")]
    wgsl: Option<PathBuf>,
    /// Format of a height map on standard output, as in -o - --format exr
    #[arg(long, value_enum, value_name = "png|exr", hide_short_help = true)]
    format: Option<Format>,
    /// Print the result as one JSON object
    #[arg(long)]
    pub(super) json: bool,
    /// Memory limit, as in 512MiB; work that needs more is refused [default: 4GiB]
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true)]
    max_memory: Option<ByteSize>,
}

fn after_help() -> String {
    let mut text = String::from(
        "Examples:\n  relief height procedure fbm --size 1024x1024 -o ground.exr\n  \
         relief height procedure waves --frames 0..47 -o waves_%04d.png\n  \
         relief render --height waves_%04d.png --frames 0..47 -o out_%04d.png\n\n\
         Formulas and their parameters:\n",
    );
    // Writing to a string cannot fail.
    for Entry { name, summary, params, .. } in ENTRIES {
        let _ = writeln!(text, "  {name:<8} {summary}");
        for param in *params {
            let (name, summary) = (param.name, param.summary);
            let _ = writeln!(text, "    {name:<10} {summary} [{}]", param.default);
        }
    }
    text + "\nMaps tile without a seam. The same flags give the same heights."
}

/// Reads a setting `NAME=VALUE`.
fn setting(text: &str) -> Result<(String, f64), String> {
    let wrong = || "write it as NAME=VALUE, as in count=8".to_owned();
    let (name, value) = text.split_once('=').ok_or_else(wrong)?;
    Ok((name.trim().to_owned(), value.trim().parse().map_err(|_| wrong())?))
}

/// Generates the maps and writes them.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let started = Instant::now();
    let procedure = arguments.procedure()?;
    let outputs = arguments.outputs()?;
    let [width, height] = arguments.size;
    HeightMap::check_size(width, height)
        .map_err(|error| Failure::Usage(format!("--size {width}x{height}: {error}")))?;
    let max_bytes = arguments.max_memory.map_or(DEFAULT_MAX_BYTES, |size| size.0);
    check_memory(arguments.size, BYTES_PER_TEXEL, max_bytes)?;
    let cancel = interrupt::catch()?;
    let paths: Vec<&Path> =
        outputs.iter().map(|(output, _)| output.path.as_path()).chain(arguments.wgsl.as_deref()).collect();
    let mut staged = Staged::open(&paths, arguments.json, cancel)?;
    {
        let bar = Progress::bar("filling", arguments.json);
        let tell = |_: &str, part: f32| bar.show(part);
        let watch = Watch::new(&tell, cancel);
        let whole = outputs.len() as f32;
        for (number, (output, time)) in outputs.iter().enumerate() {
            let [from, to] = [number, number + 1].map(|number| number as f32 / whole);
            let procedure = procedure.at_time(*time);
            let texels = filled(&procedure, arguments.size, &watch.piece(from, to))?;
            output.write(&mut staged, &arguments.content(&procedure, texels, output)?, cancel)?;
        }
    }
    if let Some(path) = &arguments.wgsl {
        staged.write(path, procedure.wgsl())?;
    }
    staged.finish()?;
    let seconds = started.elapsed().as_secs_f64();
    tell_written(arguments.json, |out| {
        if arguments.json {
            let settings: serde_json::Map<_, _> =
                named(&procedure).map(|(name, value)| (name.to_owned(), value.into())).collect();
            let files: Vec<_> = outputs
                .iter()
                .map(|(output, time)| json!({ "output": output.path.display().to_string(), "time": time }))
                .collect();
            let about = json!({
                "procedure": procedure.entry().name, "settings": settings, "seed": arguments.seed,
                "width": width, "height": height, "scale_m": arguments.scale, "tile_m": arguments.tile_m(),
                "wgsl": arguments.wgsl.as_ref().map(|path| path.display().to_string()), "maps": files,
                "seconds": seconds,
            });
            writeln!(out, "{about:#}")?;
            return Ok(());
        }
        let first = outputs.first().map(|(output, _)| output.path.display().to_string()).unwrap_or_default();
        let what = match outputs.len() {
            1 => first,
            count => format!("{first} and {} more", count - 1),
        };
        writeln!(out, "{what}: {width}x{height} heights of {} in {seconds:.2} s", procedure.entry().name)?;
        let settings: Vec<String> =
            named(&procedure).map(|(name, value)| format!("{name}={value}")).collect();
        writeln!(out, "  settings    {}, seed {}", settings.join(" "), arguments.seed)?;
        let [u, v] = arguments.tile_m().map(values::six_digits);
        writeln!(
            out,
            "  relief      --scale {} on a tile of {u} m x {v} m",
            values::six_digits(arguments.scale)
        )?;
        Ok(())
    })
}

/// Returns the parameters with their names.
fn named(procedure: &Procedure) -> impl Iterator<Item = (&'static str, f32)> {
    procedure.entry().params.iter().zip(procedure.params()).map(|(param, value)| (param.name, value))
}

/// Computes all heights, band by band.
fn filled(procedure: &Procedure, size: [u32; 2], watch: &Watch) -> Result<Vec<f32>, Failure> {
    let bands = size[1].div_ceil(BAND);
    let done = AtomicU32::new(0);
    let band = |band: u32| {
        watch.check()?;
        let rows = band * BAND..((band + 1) * BAND).min(size[1]);
        let heights = procedure.rows(size, rows).map_err(Failure::work)?;
        watch.at((done.fetch_add(1, Ordering::Relaxed) + 1) as f32 / bands as f32)?;
        Ok(heights)
    };
    let all = (0..bands).into_par_iter().map(band).collect::<Result<Vec<_>, Failure>>()?;
    Ok(all.concat())
}

impl Arguments {
    /// Returns the files that may be standard streams.
    pub fn files(&mut self) -> Files<'_> {
        let format = self.format.map(Format::ending);
        let written = vec![Written { flag: "--output", path: &mut self.output, format }];
        Files { written, ..Files::default() }
    }

    fn procedure(&self) -> Result<Procedure, Failure> {
        let mut procedure =
            Procedure::named(&self.procedure).map_err(|error| Failure::Usage(error.to_string()))?;
        for (name, value) in &self.settings {
            let set = procedure.set(name, *value);
            set.map_err(|error| Failure::Usage(format!("--set {name}={value}: {error}")))?;
        }
        if !self.time.is_finite() {
            return Err(Failure::Usage(format!("--time {}: it must be a number", self.time)));
        }
        if self.scale <= 0.0 {
            return Err(Failure::Usage(format!("--scale {}: it must be greater than 0", self.scale)));
        }
        Ok(procedure.with_seed(self.seed))
    }

    /// Returns the map's size in metres.
    fn tile_m(&self) -> [f64; 2] {
        let [width, height] = self.size.map(f64::from);
        self.tile_size.unwrap_or([width, height].map(|side| side / width.max(height)))
    }

    /// Returns the files to write, each with its time.
    fn outputs(&self) -> Result<Vec<(Output, f64)>, Failure> {
        let names = Numbering::of(None);
        let is_pattern = names.is_pattern(&self.output);
        let outputs = match self.frames {
            None if is_pattern => {
                let path = self.output.display();
                return Err(Failure::Usage(format!(
                    "--output {path}: the name has a placeholder for a frame number: give the range with \
                     --frames, as in --frames 0..47"
                )));
            }
            Some(_) if !is_pattern => {
                let path = self.output.display();
                return Err(Failure::Usage(format!(
                    "--output {path}: all frames would have this name: give it a placeholder for their \
                     numbers, as in waves_%04d.png"
                )));
            }
            None => vec![(Output::new("--output", &self.output, &[])?, self.time)],
            Some(frames) => {
                let count = frames.count() as f64;
                let frame = |number: u32| {
                    let part = f64::from(number - frames.first()) / count;
                    let path = names.path(&self.output, number)?;
                    Ok((Output::new("--output", &path, &[])?, self.time + part))
                };
                frames.numbers().map(frame).collect::<Result<Vec<_>, Failure>>()?
            }
        };
        if let (Some(wgsl), [(first, _), ..]) = (&self.wgsl, &outputs[..]) {
            check_distinct([Some(wgsl), Some(&first.path)])?;
        }
        Ok(outputs)
    }

    fn content(&self, procedure: &Procedure, texels: Vec<f32>, output: &Output) -> Result<Content, Failure> {
        let settings: Vec<String> = named(procedure).map(|(name, value)| format!("{name}={value}")).collect();
        let annotated = AnnotatedHeights {
            size: self.size,
            texels,
            wrap: Wrap::Repeat,
            note: HeightNote {
                tile_m: self.tile_m(),
                scale_m: self.scale,
                bias_m: -self.scale,
                of_mesh: false,
            },
            origin: vec![
                ("procedure", procedure.entry().name.to_owned()),
                ("settings", settings.join(" ")),
                ("time", procedure.time().to_string()),
                ("seed", procedure.seed().to_string()),
            ],
            published: Some(PUBLISHED),
            guarantee: None,
            more: Vec::new(),
        };
        annotated.content(output)
    }
}
