//! `relief bake`: bakes a height map into the maps that methods read.
//!
//! A bake writes into a hidden folder inside the output folder: first raw texels, then finished
//! files. When all files of all kinds are whole, they take their names, with a manifest that lists
//! them. A bake that fails or is cancelled changes nothing.

pub mod early;
mod files;
pub mod for_engine;
pub mod identity;
mod outputs;
mod report;
mod source;
mod spool;
mod storage;
#[cfg(test)]
mod tests;

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use clap::Args;
use relief_bake::{BakeError, KINDS, Kind, Settings, Shape, Texture};
use relief_core::registry::UnknownName;
use relief_core::{ByteSize, HeightMap, Metric, Watch, Wrap};
use relief_io::file_set::is_same_file;

use self::files::{FilesError, Plan};
use self::for_engine::{EngineArguments, FolderArguments};
use self::identity::Identity;
use self::outputs::{EarlierBakes, Outputs};
use self::report::BakedKind;
use self::spool::Spool;
use self::storage::{FileFormat, Packing, Storage, TexelChoice};
use super::maps::{self, HeightArguments, Note};
use crate::failure::Failure;
use crate::interrupt::{self, cancelled};
use crate::progress::Progress;
use crate::streams::{Files, tell_written};
use crate::{say, units, values};

/// Default displacement in metres between heights 0 and 1, the same as in `relief render`.
const DEFAULT_SCALE_M: f64 = 0.05;

/// Share of the progress bar that is baking; the rest is writing files.
const BAKING_PART: f32 = 0.9;

/// Arguments of `relief bake`.
#[derive(Args)]
#[command(after_help = short_help(), after_long_help = after_help())]
pub struct Arguments {
    /// Height map: PNG, JPEG, EXR, TIFF, GeoTIFF, HDR, PGM or headerless 16-bit raw; - for standard
    /// input (its files are named stdin). With --for also a folder of textures
    height: PathBuf,
    /// Kinds of baked maps, as in cone,normal; listed below
    #[arg(
        long,
        value_name = "KIND[,KIND...]",
        value_delimiter = ',',
        required_unless_present = "engine",
        conflicts_with = "engine"
    )]
    kind: Vec<String>,
    #[command(flatten)]
    engine: EngineArguments,
    /// Folder for the files, created if missing; or, for a single kind, the file itself, as in
    /// normal.png
    #[arg(short, long, value_name = "DIR|FILE")]
    output: PathBuf,
    /// File format [default: png for normal, occlusion and bent-normal, which other programs read
    /// as pictures; exr for the rest and for --texels float]
    #[arg(long, value_enum, conflicts_with = "engine")]
    format: Option<FileFormat>,
    /// Setting of a kind, as in cone.bits=8; repeatable
    #[arg(long, value_name = "KIND.NAME=VALUE", value_parser = setting, conflicts_with = "engine")]
    set: Vec<(String, f64)>,
    /// Displacement in metres between heights 0 and 1, or with a unit, as in 5cm [default: the
    /// range of a georeferenced elevation model, else 0.05]
    #[arg(long, value_name = "M", value_parser = units::length)]
    scale: Option<f64>,
    /// Tile size along u and v in metres, or with units, as in 30cm,20cm [default: a georeferenced
    /// file's, else square texels and 1 m for the longer side]
    #[arg(long, value_name = "U,V", value_parser = units::two_lengths)]
    tile_size: Option<[f64; 2]>,
    /// Storage of values, which are rounded to the side that keeps a map's guarantee
    #[arg(long, value_enum, default_value = "auto", conflicts_with = "engine", help_heading = "Storage")]
    texels: TexelChoice,
    /// Compress the levels of KTX2 files with Zstandard
    #[arg(long, conflicts_with = "engine", help_heading = "Storage", hide_short_help = true)]
    zstd: bool,
    /// Allow block compression of heights, which keeps 8 levels per block: for copies only
    #[arg(long, conflicts_with = "engine", help_heading = "Storage", hide_short_help = true)]
    lossy_heights: bool,
    /// Bake again even if the files are up to date, and replace files of other programs
    #[arg(long)]
    force: bool,
    /// Print the result as one JSON object
    #[arg(long)]
    pub json: bool,
    /// Memory limit, as in 512MiB; work that needs more is refused [default: 4GiB to read the map]
    #[arg(long, value_name = "SIZE", hide_short_help = true)]
    max_memory: Option<ByteSize>,
    #[command(flatten)]
    reading: HeightArguments,
}

/// What the textures of a material are written from, and how.
pub struct MaterialJob {
    pub height: PathBuf,
    pub folder: FolderArguments,
    pub output: PathBuf,
    pub scale: Option<f64>,
    pub tile_size: Option<[f64; 2]>,
    pub force: bool,
    pub json: bool,
    pub max_memory: Option<ByteSize>,
    pub reading: HeightArguments,
}

impl From<MaterialJob> for Arguments {
    fn from(job: MaterialJob) -> Self {
        let MaterialJob { height, folder, output, scale, tile_size, force, json, max_memory, reading } = job;
        Self {
            height,
            kind: Vec::new(),
            engine: EngineArguments { name: None, folder },
            output,
            format: None,
            set: Vec::new(),
            scale,
            tile_size,
            texels: TexelChoice::Auto,
            zstd: false,
            lossy_heights: false,
            force,
            json,
            max_memory,
            reading,
        }
    }
}

/// Examples, and the names of all kinds.
fn short_help() -> String {
    let names: Vec<&str> = KINDS.iter().map(|kind| kind.name).collect();
    format!(
        "Examples:\n  relief bake bricks.png --kind normal -o bricks_normal.png\n  \
         relief bake bricks.png --kind cone --set cone.bits=8 --format ktx2 -o maps\n  \
         relief bake Bricks090 --for unreal -o unreal    # a folder of textures\n\n\
         Kinds: {}; `relief bake --help` describes them and their settings.",
        names.join(", ")
    )
}

fn setting(text: &str) -> Result<(String, f64), String> {
    values::setting(text).map_err(|_| "write it as KIND.NAME=NUMBER, as in cone.bits=8".to_owned())
}

/// Examples, what is written, and all kinds with their settings.
fn after_help() -> String {
    let mut text = String::from(
        "Examples:\n  relief bake bricks.png --kind cone --set cone.bits=8 --format ktx2 -o maps\n  \
         relief bake dem.tif --fill --wrap clamp --kind normal,horizon -o maps\n  \
         relief bake Bricks090 --for unreal -o unreal\n\n\
         Files are named HEIGHT.KIND.FORMAT. Where a kind has several, the texture's name, channels, mip \
         level or slices come before FORMAT. Each file holds its metadata: kind, settings, hash of the \
         source, wrap, tile and scale in metres, channels with ranges and rounding, and the names of all \
         files of the bake.\n\n\
         HEIGHT.relief-manifest lists the files of all bakes of a map with their hashes. Files that are up \
         to date are not baked again. Files that a new bake of a kind no longer writes are removed, unless \
         they were changed. Files of other programs are replaced only with --force.\n\n\
         All files take their names at the end; Ctrl-C changes nothing (exit code 1). While it bakes, a \
         hidden folder in DIR takes 4 bytes a value. The next run finishes or removes what a killed run \
         left.\n\n",
    );
    text += &for_engine::long_help();
    text += "\n\nKinds:\n";
    for kind in KINDS {
        text += &format!("  {}: {}\n", kind.name, kind.summary);
        for param in kind.params {
            let key = format!("{}.{}", kind.name, param.name);
            let default =
                if param.name == MIPS { "1 in ktx2, else 0".to_owned() } else { param.default.to_string() };
            text += &format!("      {key}={default} ({} to {}): {}\n", param.min, param.max, param.summary);
        }
    }
    text
}

/// Reads, bakes and writes.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    if let Some(name) = &arguments.engine.name {
        return for_engine::run(arguments, name);
    }
    arguments.refuse_folder()?;
    let kinds = choose(arguments, relief_bake::kind)?;
    let (job, map) = Job::new(arguments, kinds)?;
    // Until here nothing exists that an interrupted program would leave behind.
    let cancel = interrupt::catch()?;
    tell_written(arguments.json, |out| job.run(map, cancel, out))
}

/// The parameter that adds mip levels.
pub const MIPS: &str = "mips";

/// Returns the kinds of the given names, with their settings.
fn choose<'k>(
    arguments: &Arguments,
    kind_of: impl Fn(&str) -> Result<&'k Kind, UnknownName>,
) -> Result<Vec<(&'k Kind, Settings)>, Failure> {
    let mut kinds: Vec<(&Kind, Settings)> = Vec::new();
    for name in &arguments.kind {
        let kind = kind_of(name.trim()).map_err(Failure::usage)?;
        if !kinds.iter().any(|(known, _)| known.name == kind.name) {
            kinds.push((kind, kind.defaults()));
        }
    }
    for (key, value) in &arguments.set {
        let (name, param) = key.split_once('.').ok_or_else(|| {
            Failure::Usage(format!("--set {key}: write it as KIND.NAME=NUMBER, as in cone.bits=8"))
        })?;
        let names = kinds.iter().map(|(kind, _)| kind.name);
        let unknown = UnknownName::new("kind to bake", name, names);
        let name = kind_of(name).map_or(name, |kind| kind.name);
        let chosen = kinds.iter_mut().find(|(kind, _)| kind.name == name);
        let (_, settings) = chosen.ok_or_else(|| Failure::usage(unknown))?;
        settings.set(param, *value).map_err(Failure::usage)?;
    }
    // If each level is a file of its own, levels are written only when asked for.
    for (kind, settings) in &mut kinds {
        let is_given = |(key, _): &(String, f64)| {
            key.split_once('.').is_some_and(|(name, param)| {
                param == MIPS && kind_of(name).is_ok_and(|given| given.name == kind.name)
            })
        };
        let has_mips = kind.params.iter().any(|param| param.name == MIPS);
        if has_mips && !arguments.set.iter().any(is_given) {
            let mips = f64::from(u8::from(arguments.format_of(kind) == FileFormat::Ktx2));
            settings.set(MIPS, mips).map_err(Failure::usage)?;
        }
    }
    Ok(kinds)
}

impl Arguments {
    /// Returns the file that may be standard input.
    pub fn files(&mut self) -> Files<'_> {
        Files { read: vec![&mut self.height], ..Files::default() }
    }

    /// Refuses a folder where a height map is needed.
    fn refuse_folder(&self) -> Result<(), Failure> {
        let name = self.height.display();
        if self.height.is_dir() {
            return Err(Failure::Usage(format!(
                "{name}: this is a folder: --kind bakes a height map; give its file, or the whole folder an \
                 engine with --for"
            )));
        }
        if self.engine.folder.udim.is_some() || self.engine.folder.green.is_some() {
            return Err(Failure::usage("--udim and --green are for folders of textures: add --for"));
        }
        if let Some(flag) = self.engine.folder.maps.first() {
            return Err(Failure::Usage(format!("{flag} names a map of a material for an engine: add --for")));
        }
        Ok(())
    }

    /// Returns the format of a kind's files.
    fn format_of(&self, kind: &Kind) -> FileFormat {
        let usual = match self.texels {
            TexelChoice::Float => FileFormat::Exr,
            _ if kind.is_picture => FileFormat::Png,
            _ => FileFormat::Exr,
        };
        self.file().map(|file| file.format).or(self.format).unwrap_or(usual)
    }

    /// Returns the file to write, if the output is a file and not a folder.
    fn file(&self) -> Option<OutputFile> {
        let ending = self.output.extension()?.to_str()?.to_ascii_lowercase();
        let format = FileFormat::ALL.into_iter().find(|format| format.extension() == ending)?;
        let (name, stem) = (self.output.file_name()?.to_str()?, self.output.file_stem()?.to_str()?);
        (!self.output.is_dir()).then(|| OutputFile { name: name.to_owned(), stem: stem.to_owned(), format })
    }

    /// Returns the folder that files are written into.
    fn folder(&self) -> &Path {
        match self.file() {
            None => &self.output,
            Some(_) => match self.output.parent() {
                Some(folder) if !folder.as_os_str().is_empty() => folder,
                _ => Path::new("."),
            },
        }
    }

    /// Checks that a single file can be written, if one is asked for.
    fn check_file(&self, kinds: usize) -> Result<(), Failure> {
        let Some(file) = self.file() else { return Ok(()) };
        let name = self.output.display();
        if kinds != 1 {
            return Err(Failure::Usage(format!(
                "--output {name}: one file cannot hold {kinds} kinds: give the name of a folder"
            )));
        }
        if let Some(format) = self.format.filter(|format| *format != file.format) {
            let [ending, format] = [file.format, format].map(FileFormat::extension);
            return Err(Failure::Usage(format!(
                "--output {name}: the ending says {ending}, --format says {format}: leave --format out"
            )));
        }
        if !self.folder().is_dir() {
            let folder = self.folder().display();
            return Err(Failure::Work(format!(
                "{name}: cannot be written: there is no folder {folder}: make it first"
            )));
        }
        Ok(())
    }
}

/// A single file to write.
struct OutputFile {
    name: String,
    stem: String,
    format: FileFormat,
}

/// Bake of a height map that has been read.
struct Job<'a> {
    arguments: &'a Arguments,
    folder: &'a Path,
    /// Name of the only file, where it is given.
    file_name: Option<String>,
    tasks: Vec<Task<'a>>,
    size: [u32; 2],
    wrap: Wrap,
    metric: Metric,
    source_hash: String,
    /// Beginning of the files' names.
    stem: String,
    /// Notes from reading the map.
    notes: BTreeSet<Note>,
}

/// A kind to bake.
struct Task<'a> {
    kind: &'a Kind,
    settings: Settings,
    packing: Packing,
    identity: Identity,
    /// Beginning of its files' names.
    base: String,
    /// Name in the manifest.
    part: String,
    /// Names of its files, by the shapes of its textures.
    names: Vec<String>,
}

impl<'a> Job<'a> {
    /// Reads the map, and checks that the kinds can be baked and written.
    fn new(arguments: &'a Arguments, kinds: Vec<(&'a Kind, Settings)>) -> Result<(Self, HeightMap), Failure> {
        arguments.check_file(kinds.len())?;
        let file = arguments.file();
        if file.is_none() && arguments.output.exists() && !arguments.output.is_dir() {
            let folder = arguments.output.display();
            return Err(Failure::Work(format!("{folder}: this is not a folder: give another --output")));
        }
        if arguments.zstd && kinds.iter().any(|(kind, _)| arguments.format_of(kind) != FileFormat::Ktx2) {
            return Err(Failure::usage("--zstd needs --format ktx2: add it, or leave --zstd out"));
        }
        for (kind, settings) in &kinds {
            let format = arguments.format_of(kind);
            Storage::choose(arguments.texels, format, bits(settings)).map_err(Failure::Usage)?;
        }
        let stem = arguments.height.file_stem().and_then(|stem| stem.to_str());
        let stem =
            stem.ok_or_else(|| Failure::usage("the height map's name is not UTF-8: rename it"))?.to_owned();
        let (stem, file_name) = match file {
            Some(file) => (file.stem, Some(file.name)),
            None => (stem, None),
        };
        let (map, kinds, mut notes) = source::read(arguments, kinds)?;
        let metric = metric(arguments, &map)?;
        let map = map.with_displacement(metric.scale_m, -metric.scale_m).map_err(Failure::usage)?;
        notes.extend(maps::of_depth(&arguments.height, &map, metric));
        if !arguments.json {
            notes.iter().for_each(say::note);
        }
        let source_hash = map.heights_hash().to_string();
        let (size, wrap) = ([map.width(), map.height()], map.wrap());
        let (folder, tasks) = (arguments.folder(), Vec::new());
        let mut job =
            Self { arguments, folder, file_name, tasks, size, wrap, metric, source_hash, stem, notes };
        let count = kinds.len();
        for (at, (kind, settings)) in kinds.into_iter().enumerate() {
            let task = job.task(kind, settings, &map, at + 1 < count)?;
            job.tasks.push(task);
        }
        Ok((job, map))
    }

    /// Returns a kind that can be baked and written, as far as that is known in advance.
    fn task(
        &self,
        kind: &'a Kind,
        settings: Settings,
        map: &HeightMap,
        is_followed: bool,
    ) -> Result<Task<'a>, Failure> {
        let Arguments { texels, zstd, lossy_heights, max_memory, .. } = self.arguments;
        let format = self.arguments.format_of(kind);
        let storage = Storage::choose(*texels, format, bits(&settings)).map_err(Failure::Usage)?;
        let packing = Packing { format, storage, zstd: *zstd };
        let base = match self.file_name {
            Some(_) => self.stem.clone(),
            None => format!("{}.{}", self.stem, kind.name),
        };
        let shapes = (kind.shapes)(self.size, &settings);
        let plans = self.plans(&base, format, &shapes);
        if let (Some(_), count @ 2..) = (&self.file_name, plans.len()) {
            return Err(Failure::Usage(format!(
                "--output {}: one file cannot hold the {count} files of '{}': give the name of a folder, or \
                 another ending ({})",
                self.arguments.output.display(),
                kind.name,
                FileFormat::ALL.map(|format| format!(".{}", format.extension())).join(", ")
            )));
        }
        let copies_heights = is_followed && bits(&settings) != 0;
        early::check_files(&plans, packing, &shapes)
            .and_then(|()| early::check_memory(&shapes, self.size, copies_heights, *max_memory))
            .and_then(|()| {
                early::check_channels(kind, &settings, self.wrap, self.metric, packing, *lossy_heights)
            })
            .map_err(Failure::Work)?;
        let names: Vec<String> = plans.into_iter().map(|plan| plan.name).collect();
        if let Some(name) =
            names.iter().find(|name| is_same_file(&self.folder.join(name), &self.arguments.height))
        {
            let (file, input) = (self.folder.join(name), &self.arguments.height);
            return Err(Failure::Usage(format!(
                "{} would replace the input {}: give another --output",
                file.display(),
                input.display()
            )));
        }
        let hash = &self.source_hash;
        let identity = Identity::new(kind, &settings, map, hash, self.metric, packing);
        let part = format!("{}.{}", kind.name, format.extension());
        Ok(Task { kind, settings, packing, identity, base, part, names })
    }

    /// Returns the files for textures of the given shapes.
    fn plans(&self, base: &str, format: FileFormat, shapes: &[Shape]) -> Vec<Plan> {
        let mut plans = files::plan(base, format, shapes);
        if let (Some(name), [plan]) = (&self.file_name, plans.as_mut_slice()) {
            plan.name.clone_from(name);
        }
        plans
    }

    fn run(&self, map: HeightMap, cancel: &AtomicBool, out: &mut dyn Write) -> Result<(), Failure> {
        let (output, Arguments { force, json, .. }) = (self.folder, self.arguments);
        let has_manifest = self.file_name.is_none();
        let mut outputs = match Outputs::open(output, &self.stem, has_manifest, *force, *json, cancel) {
            Ok(outputs) => outputs,
            // A folder that nobody may write into can already hold all files.
            Err(failure) => {
                let earlier = EarlierBakes::find(output, &self.stem).ok().filter(|_| has_manifest);
                let all = earlier.map(|earlier| self.up_to_date(&earlier)).unwrap_or_default();
                let is_whole = all.len() == self.tasks.len() && !cancel.load(Ordering::Relaxed);
                return if is_whole { self.tell(&all, &[], out) } else { Err(failure) };
            }
        };
        let mut all = self.up_to_date(outputs.earlier());
        let is_done = |task: &&Task| all.iter().any(|baked| baked.kind == task.kind.name);
        let tasks: Vec<&Task> = self.tasks.iter().filter(|task| !is_done(task)).collect();
        let Some((last, others)) = tasks.split_last() else { return self.tell(&all, &[], out) };
        let manifest = outputs.earlier().name().to_owned();
        for name in tasks.iter().flat_map(|task| &task.names).chain(has_manifest.then_some(&manifest)) {
            outputs.check(name)?;
        }
        for task in others {
            all.push(self.bake(task, Cow::Borrowed(&map), &mut outputs, cancel)?);
        }
        // The last kind may have the map, and needs no copy where it rounds heights.
        all.push(self.bake(last, Cow::Owned(map), &mut outputs, cancel)?);
        let kept = outputs.finish(cancel)?;
        all.sort_by_key(|baked| self.tasks.iter().position(|task| task.kind.name == baked.kind));
        self.tell(&all, &kept, out)
    }

    /// Returns the kinds whose files are up to date, or none with --force.
    fn up_to_date(&self, earlier: &EarlierBakes) -> Vec<BakedKind> {
        let whole = |task: &Task| {
            let started = Instant::now();
            let files = earlier.whole(&task.part, task.identity.key())?;
            Some(BakedKind::new(task, files, true, started))
        };
        if self.arguments.force { Vec::new() } else { self.tasks.iter().filter_map(whole).collect() }
    }

    /// Bakes a kind and writes its files, which take their names later.
    fn bake(
        &self,
        task: &Task,
        map: Cow<HeightMap>,
        outputs: &mut Outputs,
        cancel: &AtomicBool,
    ) -> Result<BakedKind, Failure> {
        let (output, Arguments { json, lossy_heights, .. }) = (self.folder, self.arguments);
        let Task { kind, settings, packing, identity, base, part, .. } = task;
        let started = Instant::now();
        let in_folder =
            |error: io::Error| Failure::Work(format!("{}: cannot write into it: {error}", output.display()));
        let bar = Progress::bar(kind.name, *json);
        let check = |texture: &Texture| packing.storage.check(packing.format, texture, *lossy_heights);
        let mut spool = Spool::new(outputs.hidden_folder(), &check).map_err(in_folder)?;
        let tell = |_: &str, part: f32| bar.show(part);
        let whole = Watch::new(&tell, cancel);
        let watch = whole.piece(0.0, BAKING_PART);
        let done = match map {
            Cow::Borrowed(map) => relief_bake::bake(kind, map, self.metric, settings, &watch, &mut spool),
            Cow::Owned(map) => relief_bake::bake_last(kind, map, self.metric, settings, &watch, &mut spool),
        };
        done.map_err(|error| match error {
            BakeError::Cancelled(_) => cancelled(),
            other => Failure::work(other),
        })?;
        let (textures, mut reader) = spool.finish().map_err(Failure::work)?;
        let shapes: Vec<Shape> = textures.iter().map(|spooled| spooled.texture.shape()).collect();
        let plans = self.plans(base, packing.format, &shapes);
        let places = plans.iter().map(|plan| outputs.place(&plan.name)).collect::<Result<Vec<_>, _>>()?;
        let watch = whole.piece(BAKING_PART, 1.0);
        let written = files::write(&plans, &places, *packing, &textures, &mut reader, identity, &watch);
        written.map_err(|error| match error {
            FilesError::Cancelled(_) => cancelled(),
            FilesError::Write { name, problem } => {
                Failure::Work(format!("{}: {problem}", output.join(name).display()))
            }
            other @ FilesError::Value(_) => Failure::work(other),
        })?;
        let names: Vec<String> = plans.into_iter().map(|plan| plan.name).collect();
        let files: Vec<(String, PathBuf)> = names.iter().cloned().zip(places).collect();
        outputs.add(part, identity.key(), &files).map_err(in_folder)?;
        Ok(BakedKind::new(task, names, false, started))
    }
}

fn bits(settings: &Settings) -> u32 {
    settings.iter().find(|(name, _)| *name == "bits").map_or(0, |(_, bits)| bits as u32)
}

/// Returns the metric asked for or the georeferenced file's, else a shallow relief on a tile whose
/// longer side is 1 m.
fn metric(arguments: &Arguments, map: &HeightMap) -> Result<Metric, Failure> {
    let tile = arguments.tile_size.or(map.stated_tile_m()).unwrap_or_else(|| map.proportions());
    // If a map's unit is not known, its tile is 1 m long, or as long as given.
    let span = map.stated_lengths().map(|(stated, span)| match map.stated_tile_m() {
        None if arguments.tile_size.is_none() => span / stated[0].max(stated[1]),
        _ => span,
    });
    Metric::new(tile, arguments.scale.or(span).unwrap_or(DEFAULT_SCALE_M)).map_err(Failure::usage)
}
