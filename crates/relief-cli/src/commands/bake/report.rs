//! Report on a run of `relief bake`.

use std::io::{self, Write};
use std::path::Path;
use std::time::Instant;

use serde_json::{Value, json};

use super::job::{Job, Task};
use crate::commands::maps;
use crate::failure::Failure;
use crate::say;

/// Result for one kind.
pub struct BakedKind {
    /// Name of the kind.
    pub kind: &'static str,
    key: String,
    files: Vec<String>,
    up_to_date: bool,
    seconds: f64,
}

impl BakedKind {
    /// Creates the result of a task whose files are written, or were `up_to_date`.
    pub fn new(task: &Task, files: Vec<String>, up_to_date: bool, started: Instant) -> Self {
        let (kind, key) = (task.kind.name, task.identity.key().to_owned());
        Self { kind, key, files, up_to_date, seconds: started.elapsed().as_secs_f64() }
    }

    fn print(&self, folder: &Path, out: &mut dyn Write) -> io::Result<()> {
        let files: Vec<String> =
            self.files.iter().map(|file| folder.join(file).display().to_string()).collect();
        let files = files.join(", ");
        if self.up_to_date {
            let (verb, files) = match self.files.len() {
                1 => ("is", files),
                count => ("are", format!("the {count} files {files}")),
            };
            writeln!(out, "{}: nothing to do, {files} {verb} up to date (--force bakes again)", self.kind)
        } else {
            writeln!(out, "{}: {files} in {:.2} s", self.kind, self.seconds)
        }
    }
}

impl Job<'_> {
    /// Reports the results of all kinds, and the files of earlier bakes that stayed because they
    /// were changed.
    pub fn tell(&self, all: &[BakedKind], changed: &[String], out: &mut dyn Write) -> Result<(), Failure> {
        let folder = self.folder;
        if self.arguments.json {
            writeln!(out, "{:#}", self.as_json(all, changed))?;
            return Ok(());
        }
        for name in changed {
            say::note(format_args!(
                "{} stays: an earlier bake wrote it, this one does not, and it has been changed since",
                folder.join(name).display()
            ));
        }
        all.iter().try_for_each(|baked| baked.print(folder, out))?;
        Ok(())
    }

    fn as_json(&self, all: &[BakedKind], changed: &[String]) -> Value {
        let baked: Vec<Value> = all
            .iter()
            .map(|baked| {
                json!({
                    "kind": baked.kind, "key": baked.key,
                    "files": baked.files, "up_to_date": baked.up_to_date,
                    "seconds": baked.seconds,
                })
            })
            .collect();
        json!({
            "input": self.arguments.height, "output": self.arguments.output, "source": self.source_hash,
            "width": self.size[0], "height": self.size[1], "wrap": self.wrap.name(),
            "tile_m": self.metric.tile_m, "scale_m": self.metric.scale_m, "baked": baked, "kept": changed,
            "notes": maps::as_json(&self.notes),
        })
    }
}
