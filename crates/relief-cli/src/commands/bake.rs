//! `relief bake`: a height map to the maps that methods read.
//!
//! A bake goes into a hidden folder inside the output folder: texels as they come, then the finished files.
//! Only when all files of a kind are whole do they take their names. A bake that fails or is cancelled
//! removes the folder.

mod files;
pub mod identity;
mod spool;
mod storage;
#[cfg(test)]
mod tests;

use std::borrow::Cow;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use clap::Args;
use relief_bake::{BakeError, KINDS, Kind, Progress as BakeProgress, Settings, Texture};
use relief_core::registry::UnknownName;
use relief_core::{ByteSize, HeightMap, Metric, Wrap};
use relief_io::read_height;
use serde_json::{Value, json};

use self::files::{FilesError, Packing};
use self::identity::Identity;
use self::spool::Spool;
use self::storage::{FileFormat, Storage, TexelChoice};
use super::maps::HeightArguments;
use crate::failure::Failure;
use crate::progress::Progress;
use crate::values;

/// Displacement in metres between heights 0 and 1 unless the file or the user says otherwise; that of
/// `relief render`.
const DEFAULT_SCALE_M: f64 = 0.05;

/// The part of a bake's time that is given to baking; the rest goes to writing files.
const BAKING_PART: f32 = 0.9;

/// What `relief bake` is given.
#[derive(Args)]
#[command(after_help = after_help())]
pub struct Arguments {
    /// Height map: PNG, JPEG, EXR, TIFF, GeoTIFF, HDR, PGM or headerless 16-bit raw
    height: PathBuf,
    /// Kinds of maps to bake, as in cone,normal; listed below
    #[arg(long, value_name = "KIND[,KIND...]", value_delimiter = ',', required = true)]
    kind: Vec<String>,
    /// Folder for the files; it must exist
    #[arg(short, long, value_name = "DIR")]
    output: PathBuf,
    /// File format
    #[arg(long, value_enum, default_value = "exr")]
    format: FileFormat,
    /// Setting of a kind, as in cone.bits=8; may be repeated
    #[arg(long, value_name = "KIND.NAME=VALUE", value_parser = setting)]
    set: Vec<(String, f64)>,
    /// Metres of displacement between heights 0 and 1
    /// [default: the range of a georeferenced elevation model, else 0.05]
    #[arg(long, value_name = "M")]
    scale: Option<f64>,
    /// Metres of a tile along u and v [default: from a georeferenced file's texel size, else of square texels, the
    /// longer side 1]
    #[arg(long, value_name = "U,V", value_parser = values::pair)]
    tile_size: Option<[f64; 2]>,
    /// How values are stored; they are rounded to the side that keeps a map's promise
    #[arg(long, value_enum, default_value = "auto", help_heading = "Storage")]
    texels: TexelChoice,
    /// Compress KTX2 levels with Zstandard
    #[arg(long, help_heading = "Storage")]
    zstd: bool,
    /// Allow heights in block-compressed texels, which keep 8 levels a block: for copies only
    #[arg(long, help_heading = "Storage")]
    lossy_heights: bool,
    /// Bake again what has been baked before
    #[arg(long)]
    force: bool,
    /// Print one JSON object about the files
    #[arg(long)]
    pub json: bool,
    /// Refuse to take more memory than this, as in 512MiB [default: 4GiB to read the map]
    #[arg(long, value_name = "SIZE")]
    max_memory: Option<ByteSize>,
    #[command(flatten)]
    reading: HeightArguments,
}

fn setting(text: &str) -> Result<(String, f64), String> {
    values::setting(text).map_err(|_| "write it as KIND.NAME=NUMBER, as in cone.bits=8".to_owned())
}

/// Examples, what is written, and all kinds with their settings.
fn after_help() -> String {
    let mut text = String::from(
        "Examples:\n  relief bake bricks.png --kind cone --set cone.bits=8 --format ktx2 -o maps\n  \
         relief bake dem.tif --fill --wrap clamp --kind normal,horizon -o maps\n\n\
         Files are named HEIGHT.KIND.FORMAT, with the texture's name, channels or mip level between where a kind has \
         several. Each holds its metadata: kind, settings, hash of the source, wrap, tile and scale in metres, channels \
         with ranges and rounding, names of all files of the bake. A bake whose files are there is not repeated. Ctrl-C \
         leaves no file behind (exit code 1). While it bakes, a hidden folder in DIR takes 4 bytes a value.\n\n\
         Kinds:\n",
    );
    for kind in KINDS {
        text += &format!("  {}: {}\n", kind.name, kind.summary);
        for param in kind.params {
            let (key, default) = (format!("{}.{}", kind.name, param.name), param.default);
            text += &format!("      {key}={default} ({} to {}): {}\n", param.min, param.max, param.summary);
        }
    }
    text
}

/// Set by Ctrl-C while there is something to clean up.
static CANCEL: AtomicBool = AtomicBool::new(false);

/// Reads, bakes and writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let kinds = choose(arguments, relief_bake::kind)?;
    let (job, map) = Job::new(arguments, kinds)?;
    // Until here nothing exists that an interrupted program would leave behind.
    ctrlc::set_handler(|| CANCEL.store(true, Ordering::Relaxed)).map_err(Failure::work)?;
    job.run(map, &CANCEL, &mut io::stdout().lock())
}

/// The kinds of that names, with their settings.
fn choose<'k>(
    arguments: &Arguments,
    kind: impl Fn(&str) -> Result<&'k Kind, UnknownName>,
) -> Result<Vec<(&'k Kind, Settings)>, Failure> {
    let mut kinds: Vec<(&Kind, Settings)> = Vec::new();
    for name in &arguments.kind {
        let kind = kind(name.trim()).map_err(Failure::usage)?;
        if !kinds.iter().any(|(known, _)| known.name == kind.name) {
            kinds.push((kind, kind.defaults()));
        }
    }
    for (key, value) in &arguments.set {
        let (name, param) = key.split_once('.').ok_or_else(|| {
            Failure::Usage(format!("--set {key}: write it as KIND.NAME=NUMBER, as in cone.bits=8"))
        })?;
        let names = kinds.iter().map(|(kind, _)| kind.name);
        let unknown = UnknownName::new("kind among those to bake", name, names);
        let chosen = kinds.iter_mut().find(|(kind, _)| kind.name == name);
        let (_, settings) = chosen.ok_or_else(|| Failure::usage(unknown))?;
        settings.set(param, *value).map_err(Failure::usage)?;
    }
    Ok(kinds)
}

/// What is to be made of a map that has been read.
struct Job<'a> {
    arguments: &'a Arguments,
    kinds: Vec<(&'a Kind, Settings)>,
    size: [u32; 2],
    wrap: Wrap,
    metric: Metric,
    source_hash: String,
    /// The beginning of the files' names.
    stem: String,
}

/// What became of a kind.
struct Baked {
    kind: &'static str,
    key: String,
    files: Vec<String>,
    up_to_date: bool,
    seconds: f64,
}

impl<'a> Job<'a> {
    /// Reads the map, and finds out whether the kinds can be made of it.
    fn new(arguments: &'a Arguments, kinds: Vec<(&'a Kind, Settings)>) -> Result<(Self, HeightMap), Failure> {
        if !arguments.output.is_dir() {
            let folder = arguments.output.display();
            return Err(Failure::Work(format!(
                "there is no folder {folder}: create it, or give another --output"
            )));
        }
        if arguments.zstd && arguments.format != FileFormat::Ktx2 {
            return Err(Failure::usage("--zstd is for --format ktx2"));
        }
        for (_, settings) in &kinds {
            Storage::choose(arguments.texels, arguments.format, bits(settings)).map_err(Failure::Usage)?;
        }
        let stem = arguments.height.file_stem().and_then(|stem| stem.to_str());
        let stem =
            stem.ok_or_else(|| Failure::usage("the height map's name is not UTF-8: rename it"))?.to_owned();
        let options = arguments.reading.options(arguments.max_memory);
        let map = read_height(&arguments.height, &options).map_err(Failure::of_map)?;
        let metric = metric(arguments, &map)?;
        let map = map.with_displacement(metric.scale_m, -metric.scale_m).map_err(Failure::usage)?;
        let source_hash = map.heights_hash().to_string();
        let (size, wrap) = ([map.width(), map.height()], map.wrap());
        Ok((Self { arguments, kinds, size, wrap, metric, source_hash, stem }, map))
    }

    fn run(&self, map: HeightMap, cancel: &AtomicBool, out: &mut dyn Write) -> Result<(), Failure> {
        let mut all = Vec::new();
        let mut finished = |baked: Baked| {
            let printed = if self.arguments.json { Ok(()) } else { baked.print(&self.arguments.output, out) };
            all.push(baked);
            printed
        };
        if let Some(((last, settings), others)) = self.kinds.split_last() {
            for (kind, settings) in others {
                finished(self.kind(kind, settings, Cow::Borrowed(&map), cancel)?)?;
            }
            // The last kind may have the map, and needs no copy where it rounds heights.
            finished(self.kind(last, settings, Cow::Owned(map), cancel)?)?;
        }
        if self.arguments.json {
            writeln!(out, "{:#}", self.as_json(&all))?;
        }
        Ok(())
    }

    /// Bakes a kind into the hidden folder and moves its files to their places.
    fn kind(
        &self,
        kind: &Kind,
        settings: &Settings,
        map: Cow<HeightMap>,
        cancel: &AtomicBool,
    ) -> Result<Baked, Failure> {
        let Arguments { output, format, texels, zstd, .. } = self.arguments;
        let started = Instant::now();
        let storage = Storage::choose(*texels, *format, bits(settings)).map_err(Failure::Usage)?;
        let identity =
            Identity::new(kind, settings, &map, &self.source_hash, self.metric, *format, storage, *zstd);
        let baked = |files, up_to_date| Baked {
            kind: kind.name,
            key: identity.key().to_owned(),
            files,
            up_to_date,
            seconds: started.elapsed().as_secs_f64(),
        };
        if !self.arguments.force
            && let Some(files) = identity.files_in(output, &self.stem, kind.name, *format)
        {
            return Ok(baked(files, true));
        }
        let in_folder =
            |error: io::Error| Failure::Work(format!("{}: cannot write into it: {error}", output.display()));
        let staging =
            tempfile::Builder::new().prefix(".relief-bake-").tempdir_in(output).map_err(in_folder)?;
        let bar = Progress::bar(kind.name, self.arguments.json);
        let check = |texture: &Texture| self.check(storage, texture);
        let mut spool = Spool::new(staging.path(), &check).map_err(in_folder)?;
        let report = |part: f32| bar.show(part * BAKING_PART);
        let progress = BakeProgress::new(&report, cancel);
        let done = match map {
            Cow::Borrowed(map) => relief_bake::bake(kind, map, self.metric, settings, &progress, &mut spool),
            Cow::Owned(map) => {
                relief_bake::bake_last(kind, map, self.metric, settings, &progress, &mut spool)
            }
        };
        done.map_err(|error| match error {
            BakeError::Cancelled(_) => cancelled(),
            other => Failure::work(other),
        })?;
        let (textures, mut reader) = spool.finish().map_err(Failure::work)?;
        let base = format!("{}.{}", self.stem, kind.name);
        let packing = Packing { format: *format, storage, zstd: *zstd };
        let mut at = |part: f32| {
            bar.show(BAKING_PART + part * (1.0 - BAKING_PART));
            !cancel.load(Ordering::Relaxed)
        };
        let files = files::write(staging.path(), &base, packing, &textures, &mut reader, &identity, &mut at);
        let files = files.map_err(|error| match error {
            FilesError::Cancelled => cancelled(),
            // The file is named by where it was to go, not by the hidden folder.
            FilesError::Write(error) => {
                let name = error.path.file_name().unwrap_or_default();
                Failure::Work(format!("{}: {}", output.join(name).display(), error.problem))
            }
            other => Failure::work(other),
        })?;
        for file in &files {
            let target = output.join(file);
            std::fs::rename(staging.path().join(file), &target).map_err(|error| {
                Failure::Work(format!("{}: cannot be replaced: {error}", target.display()))
            })?;
        }
        Ok(baked(files, false))
    }

    /// Whether a texture can be stored, and fits: a 2-D bake holds its input and its output, and half as much
    /// again.
    fn check(&self, storage: Storage, texture: &Texture) -> Result<(), String> {
        storage.check(self.arguments.format, texture, self.arguments.lossy_heights)?;
        let [width, height, depth] = texture.size.map(u64::from);
        if let Some(ByteSize(limit)) = self.arguments.max_memory
            && depth == 1
        {
            let output = width.saturating_mul(height).saturating_mul(4 * texture.channels.len() as u64);
            let [columns, rows] = self.size.map(u64::from);
            let input = 4 * columns * rows;
            let needed = output.saturating_add(input).saturating_mul(3) / 2;
            if needed > limit {
                return Err(format!(
                    "{width}x{height} texels of {} channels need about {needed} bytes of memory, {limit} are allowed: \
                     raise --max-memory",
                    texture.channels.len()
                ));
            }
        }
        Ok(())
    }

    fn as_json(&self, all: &[Baked]) -> Value {
        let baked: Vec<Value> = all
            .iter()
            .map(|baked| {
                json!({
                    "kind": baked.kind, "key": baked.key, "files": baked.files, "up_to_date": baked.up_to_date,
                    "seconds": baked.seconds,
                })
            })
            .collect();
        json!({
            "height": self.arguments.height, "folder": self.arguments.output, "source": self.source_hash,
            "width": self.size[0], "height_texels": self.size[1], "wrap": self.wrap.name(),
            "tile_m": self.metric.tile_m, "scale_m": self.metric.scale_m, "baked": baked,
        })
    }
}

impl Baked {
    fn print(&self, folder: &Path, out: &mut dyn Write) -> io::Result<()> {
        let files: Vec<String> =
            self.files.iter().map(|file| folder.join(file).display().to_string()).collect();
        let files = files.join(", ");
        if self.up_to_date {
            let (verb, files) = match self.files.len() {
                1 => ("is", files),
                count => ("are", format!("the {count} files {files}")),
            };
            writeln!(
                out,
                "{}: nothing to do, {files} {verb} baked from the same inputs already (--force bakes again)",
                self.kind
            )
        } else {
            writeln!(out, "{}: {files} in {:.2} s", self.kind, self.seconds)
        }
    }
}

fn bits(settings: &Settings) -> u32 {
    settings.iter().find(|(name, _)| *name == "bits").map_or(0, |(_, bits)| bits as u32)
}

fn cancelled() -> Failure {
    Failure::Work("cancelled: no file was written".to_owned())
}

/// The metric asked for, or that of a georeferenced file, or a tile whose longer side is 1 m with a shallow relief.
fn metric(arguments: &Arguments, map: &HeightMap) -> Result<Metric, Failure> {
    let tile = arguments.tile_size.or(map.stated_tile_m()).unwrap_or_else(|| map.proportions());
    let span = map.stated_lengths_m().map(|(_, span)| span);
    Metric::new(tile, arguments.scale.or(span).unwrap_or(DEFAULT_SCALE_M)).map_err(Failure::usage)
}
