//! `relief render --frames`: renders one picture per frame number.

use std::collections::{BTreeSet, HashMap};
use std::ffi::OsString;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use relief_io::beside_file;
use relief_object::read_description;
use relief_render::RENDERING;
use relief_scene::SceneSpec;
use serde_json::json;

use super::output::Outputs;
use super::report::Picture;
use super::{Arguments, PictureRenderer};
use crate::commands::numbered::{Numbering, files};
use crate::commands::scene_arguments::of_scene;
use crate::failure::Failure;
use crate::frames::Frames;
use crate::progress::Progress;
use crate::streams::{answer, tell_written};
use crate::{interrupt, say};

/// Renders and writes all frames, each the same as if rendered alone.
pub fn run(
    arguments: &Arguments,
    spec: &SceneSpec,
    numbering: &Numbering,
    frames: Frames,
) -> Result<(), Failure> {
    let sequence = Sequence { arguments, spec, numbering };
    {
        let _checking = Progress::spinner("checking files", arguments.json);
        sequence.check(frames)?;
    }
    let mut renderer = PictureRenderer::new(arguments);
    let cancel = interrupt::catch()?;
    let bar = Progress::bar("rendering", arguments.json);
    let mut report =
        FrameReport { json: arguments.json, all: Vec::new(), printed: BTreeSet::new(), is_read: true };
    let count = frames.count();
    for (done, number) in (0u64..).zip(frames.numbers()) {
        let tell = |task: &str, part: f32| {
            if task == RENDERING {
                bar.show((done as f32 + part) / count as f32);
            }
        };
        let rendered = sequence.frame(number, &mut renderer, &bar, &tell, &mut report, cancel);
        rendered.map_err(|failure| match (cancel.load(Ordering::Relaxed), done) {
            (false, _) => of_frame(failure, number, done),
            (true, 0) => interrupt::cancelled(),
            (true, _) => {
                Failure::Work(format!("cancelled: {done} of {count} frames were written, each whole"))
            }
        })?;
    }
    drop(bar);
    match arguments.json {
        true => answer(|out| Ok(writeln!(out, "{:#}", json!({ "frames": report.all }))?)),
        false => Ok(()),
    }
}

/// Adds to a failure the frame's number, and the number of frames that were written before.
fn of_frame(failure: Failure, number: u32, done: u64) -> Failure {
    let text = |message: String| match done {
        0 => format!("frame {number}: {message}"),
        1 => format!("frame {number}: {message} (the frame before was written)"),
        _ => format!("frame {number}: {message} (the {done} frames before were written)"),
    };
    match failure {
        Failure::Usage(message) => Failure::Usage(text(message)),
        Failure::Work(message) => Failure::Work(text(message)),
        Failure::ReaderGone => Failure::ReaderGone,
    }
}

/// Report on frames.
struct FrameReport {
    json: bool,
    /// JSON of all frames.
    all: Vec<serde_json::Value>,
    /// Lines and notes that were printed, and hold for later frames, too.
    printed: BTreeSet<String>,
    /// Whether somebody still reads the report.
    is_read: bool,
}

/// Scene whose files differ from frame to frame.
struct Sequence<'a> {
    arguments: &'a Arguments,
    spec: &'a SceneSpec,
    numbering: &'a Numbering<'a>,
}

impl Sequence<'_> {
    /// Checks all frames, as far as names and files tell. Inputs exist, no input is written, and no
    /// file is written twice.
    fn check(&self, frames: Frames) -> Result<(), Failure> {
        let of_flags = Numbering::of(None);
        for (flag, path) in
            [("--output", Some(&self.arguments.output)), ("--aov", self.arguments.aov.as_ref())]
        {
            let Some(path) = path else { continue };
            // A bad pattern is reported as that, before a missing placeholder is.
            of_flags.path(path, frames.first())?;
            if !of_flags.is_pattern(path) {
                let path = path.display();
                return Err(Failure::Usage(format!(
                    "{flag} {path}: all frames would have this name: give it a placeholder for their \
                     numbers, as in out_%04d.png"
                )));
            }
        }
        self.numbering.spec(self.spec, frames.first())?;
        if !self.numbering.has_frames(self.spec) {
            return Err(Failure::usage(
                "--frames: no file of the scene differs from frame to frame: put a placeholder for the \
                 number into the name of a file, as in --height height_%04d.png or the key object = \
                 \"walk/%04d/object.toml\"",
            ));
        }
        let in_files_of_meshes = self.numbering.has_frames_of_meshes(self.spec);
        let in_all = files(self.spec);
        let mut places = FramePaths::default();
        for number in frames.numbers() {
            let at = |failure| of_frame(failure, number, 0);
            let spec = self.numbering.spec(self.spec, number)?;
            let is_first = number == frames.first();
            // A file that is the same in all frames is checked once.
            let is_new = |file: &&PathBuf| is_first || !in_all.contains(*file);
            let are_there = |read: &[PathBuf]| {
                read.iter().filter(is_new).try_for_each(|file| must_be_there(file)).map_err(at)
            };
            are_there(&files(&spec))?;
            let whole = match is_first || in_files_of_meshes {
                true => spec.with_keys_of_meshes().map_err(|error| at(of_scene(error)))?,
                false => spec,
            };
            let read = files(&whole);
            are_there(&read)?;
            for surface in whole.each_surface() {
                if let Some(object) = surface.object.filter(|file| is_new(&file)) {
                    pictures_must_be_there(&object).map_err(at)?;
                }
            }
            let outputs = self.outputs(number, &whole)?;
            places.reads(number, &read, self.arguments.scene.file());
            places.writes(number, &outputs)?;
        }
        places.check()
    }

    /// Returns the files of a frame.
    fn outputs(&self, number: u32, spec: &SceneSpec) -> Result<Outputs, Failure> {
        let of_flags = Numbering::of(None);
        let picture = of_flags.path(&self.arguments.output, number)?;
        let aov = self.arguments.aov.as_ref().map(|path| of_flags.path(path, number)).transpose()?;
        Outputs::new(self.arguments, picture, aov, spec)
    }

    /// Renders a frame and reports it.
    fn frame(
        &self,
        number: u32,
        renderer: &mut PictureRenderer,
        bar: &Progress,
        tell: &(dyn Fn(&str, f32) + Sync),
        report: &mut FrameReport,
        cancel: &AtomicBool,
    ) -> Result<(), Failure> {
        let spec = self.numbering.spec(self.spec, number)?.with_keys_of_meshes().map_err(of_scene)?;
        let outputs = self.outputs(number, &spec)?;
        let scene = spec.load().map_err(of_scene)?;
        if cancel.load(Ordering::Relaxed) {
            return Err(interrupt::cancelled());
        }
        let (counts, made) = renderer.draw(&scene, &outputs, tell)?;
        let picture = Picture { spec: &spec, scene: &scene, outputs: &outputs, counts, made: &made };
        if report.json {
            let mut about = picture.as_json();
            about["frame"] = number.into();
            report.all.push(about);
            return Ok(());
        }
        let notes = renderer.notes(&spec, &scene, &made);
        bar.aside(|| {
            for note in notes {
                if report.printed.insert(note.clone()) {
                    say::note(note);
                }
            }
            report.tell(&picture)
        })
    }
}

impl FrameReport {
    /// Reports a picture, without lines that a frame before had in the same words.
    fn tell(&mut self, picture: &Picture) -> Result<(), Failure> {
        if !self.is_read {
            return Ok(());
        }
        let mut text = Vec::new();
        picture.tell(&mut text)?;
        let text = String::from_utf8_lossy(&text).into_owned();
        let read = tell_written(false, |out| {
            for line in text.lines().filter(|line| self.printed.insert((*line).to_owned())) {
                out.extend_from_slice(line.as_bytes());
                out.push(b'\n');
            }
            Ok(())
        });
        match read {
            // Who wanted only the first lines still wants all pictures.
            Err(Failure::ReaderGone) => self.is_read = false,
            other => other?,
        }
        Ok(())
    }
}

fn must_be_there(file: &Path) -> Result<(), Failure> {
    let failed = |what: &dyn std::fmt::Display| {
        Err(Failure::Work(format!("{}: cannot be read: {what}", file.display())))
    };
    match std::fs::metadata(file) {
        Ok(about) if about.is_dir() => failed(&"it is a folder"),
        Ok(_) => Ok(()),
        Err(error) => failed(&error),
    }
}

/// Checks that a depth object's pictures exist.
fn pictures_must_be_there(object: &Path) -> Result<(), Failure> {
    let description = read_description(object).map_err(Failure::work)?;
    for name in [Some(description.depth), description.color, description.normal].into_iter().flatten() {
        must_be_there(&beside_file(object, &name).map_err(Failure::of_picture)?)?;
    }
    Ok(())
}

/// Paths of all frames' files: folders are resolved, so that links do not hide equal files.
#[derive(Default)]
struct FramePaths {
    folders: HashMap<PathBuf, PathBuf>,
    /// Files that are read, each with its frame.
    read: HashMap<PathBuf, u32>,
    /// Files that are written, each with its frame and its name.
    written: HashMap<PathBuf, (u32, PathBuf)>,
}

impl FramePaths {
    fn of(&mut self, path: &Path) -> PathBuf {
        if path.is_symlink()
            && let Ok(place) = path.canonicalize()
        {
            return place;
        }
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let known = self.folders.entry(folder.to_owned());
        let folder = known.or_insert_with(|| folder.canonicalize().unwrap_or_else(|_| folder.to_owned()));
        folder.join(path.file_name().map_or_else(OsString::new, ToOwned::to_owned))
    }

    fn reads(&mut self, frame: u32, files: &[PathBuf], scene: Option<&Path>) {
        for file in files.iter().map(AsRef::as_ref).chain(scene) {
            let place = self.of(file);
            self.read.entry(place).or_insert(frame);
        }
    }

    fn writes(&mut self, frame: u32, outputs: &Outputs) -> Result<(), Failure> {
        for path in [Some(&outputs.picture), outputs.aov.as_ref()].into_iter().flatten() {
            let place = self.of(path);
            if let Some((other, _)) = self.written.insert(place, (frame, path.clone())) {
                let path = path.display();
                return Err(Failure::Usage(format!(
                    "{path} is named for frame {other} and for frame {frame}: give each its own name"
                )));
            }
        }
        Ok(())
    }

    /// Checks that no frame writes what another one reads.
    fn check(&self) -> Result<(), Failure> {
        // The first frame is named, whatever the order in the map.
        let replaced = self
            .written
            .iter()
            .filter_map(|(place, (frame, path))| self.read.get(place).map(|reader| (frame, path, reader)));
        match replaced.min() {
            Some((frame, path, reader)) => Err(Failure::Usage(format!(
                "{}: frame {frame} would replace it, and frame {reader} reads it: give another --output",
                path.display()
            ))),
            None => Ok(()),
        }
    }
}
