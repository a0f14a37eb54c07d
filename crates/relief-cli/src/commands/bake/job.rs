//! Bake of a height map: its kinds are checked, baked and written.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use relief_bake::{BakeError, Kind, Settings, Shape, Texture};
use relief_core::{HeightMap, Metric, Watch, Wrap};
use relief_io::file_set::is_same_file;

use super::files::{FilesError, Plan};
use super::identity::Identity;
use super::outputs::{EarlierBakes, Outputs};
use super::report::BakedKind;
use super::spool::Spool;
use super::storage::{FileFormat, Packing, Storage};
use super::{Arguments, early, files, source};
use crate::commands::maps::{self, Note};
use crate::failure::Failure;
use crate::interrupt::cancelled;
use crate::progress::Progress;
use crate::say;

/// Default displacement in metres between heights 0 and 1, the same as in `relief render`.
const DEFAULT_SCALE_M: f64 = 0.05;

/// Share of the progress bar that is baking; the rest is writing files.
const BAKING_PART: f32 = 0.9;

/// Bake of a height map that has been read.
pub(super) struct Job<'a> {
    pub(super) arguments: &'a Arguments,
    pub(super) folder: &'a Path,
    /// Name of the only file, where it is given.
    pub(super) file_name: Option<String>,
    pub(super) tasks: Vec<Task<'a>>,
    pub(super) size: [u32; 2],
    pub(super) wrap: Wrap,
    pub(super) metric: Metric,
    pub(super) source_hash: String,
    /// Beginning of the files' names.
    pub(super) stem: String,
    /// Notes from reading the map.
    pub(super) notes: BTreeSet<Note>,
}

/// A kind to bake.
pub(super) struct Task<'a> {
    pub(super) kind: &'a Kind,
    pub(super) settings: Settings,
    pub(super) packing: Packing,
    pub(super) identity: Identity,
    /// Beginning of its files' names.
    pub(super) base: String,
    /// Name in the manifest.
    pub(super) part: String,
    /// Names of its files, by the shapes of its textures.
    pub(super) names: Vec<String>,
}

impl<'a> Job<'a> {
    /// Reads the map, and checks that the kinds can be baked and written.
    pub(super) fn new(
        arguments: &'a Arguments,
        kinds: Vec<(&'a Kind, Settings)>,
    ) -> Result<(Self, HeightMap), Failure> {
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

    pub(super) fn run(
        &self,
        map: HeightMap,
        cancel: &AtomicBool,
        out: &mut dyn Write,
    ) -> Result<(), Failure> {
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
pub(super) fn metric(arguments: &Arguments, map: &HeightMap) -> Result<Metric, Failure> {
    let tile = arguments.tile_size.or(map.stated_tile_m()).unwrap_or_else(|| map.proportions());
    // If a map's unit is not known, its tile is 1 m long, or as long as given.
    let span = map.stated_lengths().map(|(stated, span)| match map.stated_tile_m() {
        None if arguments.tile_size.is_none() => span / stated[0].max(stated[1]),
        _ => span,
    });
    Metric::new(tile, arguments.scale.or(span).unwrap_or(DEFAULT_SCALE_M)).map_err(Failure::usage)
}
