//! Journal of a set's changes, written before the first change. A process that finds a journal can
//! finish the work of a killed process, or undo it.
//!
//! The new content of step `i` lies in its staging folder as `new.i`. The file that it replaces or
//! removes stays there as `old.i` until all steps are done.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::disk::{Disk, is_there};
use super::staging::{StagingFolder, is_folder};
use super::target::{Target, from_bytes, to_bytes};

/// Journal of work to be finished.
const JOURNAL: &str = "journal";

/// Journal of work to be undone.
const UNDO: &str = "undo";

/// First and last field of a journal.
const BEGIN: &[u8] = b"relief journal 1";
const END: &[u8] = b"end";

/// Change of one file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Step {
    pub(super) action: Action,
    /// Folder of the file, if it is not the one that holds the staging folder.
    pub(super) other_folder: Option<PathBuf>,
    pub(super) name: std::ffi::OsString,
}

/// Kind of change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Action {
    /// The file gets new content; `replaces` if it exists already.
    Put { replaces: bool },
    /// The file is removed.
    Remove,
}

impl Step {
    /// Staging folder with the step's content, old and new.
    pub(super) fn staging_path(&self, staging: &StagingFolder) -> io::Result<PathBuf> {
        self.other_folder
            .as_ref()
            .map_or_else(|| Ok(staging.path.clone()), |folder| staging.remote_path(folder))
    }

    /// Path of the file that changes.
    pub(super) fn target(&self, staging: &StagingFolder) -> PathBuf {
        let beside = staging.path.parent().unwrap_or(Path::new("."));
        self.other_folder.as_deref().unwrap_or(beside).join(&self.name)
    }

    /// Does the step, or the part of it that is not yet done.
    fn redo(&self, disk: &Disk, staging: &StagingFolder, number: usize) -> io::Result<()> {
        let (aside, target) = (self.staging_path(staging)?, self.target(staging));
        let (new, old) = (aside.join(format!("new.{number}")), aside.join(format!("old.{number}")));
        let keeps = match self.action {
            // Without new content nothing remains to be done.
            Action::Put { .. } if !is_there(&new)? => return Ok(()),
            Action::Put { replaces } => replaces,
            Action::Remove => true,
        };
        if keeps && !is_there(&old)? && is_there(&target)? {
            if !fs::symlink_metadata(&target)?.is_file() {
                return Err(io::Error::other("it is not a regular file any more"));
            }
            // A hard link keeps the file in its place until the new one replaces it. Some file
            // systems have no hard links.
            if self.action == Action::Remove || disk.link(&target, &old).is_err() {
                disk.rename(&target, &old)?;
            }
        }
        if self.action == Action::Remove { Ok(()) } else { disk.rename(&new, &target) }
    }

    /// Undoes the step, or the part of it that is not yet undone.
    fn undo(&self, disk: &Disk, staging: &StagingFolder, number: usize) -> io::Result<()> {
        let (aside, target) = (self.staging_path(staging)?, self.target(staging));
        let (new, old) = (aside.join(format!("new.{number}")), aside.join(format!("old.{number}")));
        if is_there(&old)? {
            return disk.rename(&old, &target);
        }
        let is_added = self.action == Action::Put { replaces: false };
        if is_added && !is_there(&new)? && is_there(&target)? {
            return disk.rename(&target, &new);
        }
        Ok(())
    }
}

/// Failed change: the file, and the error.
pub(super) type Failed = (PathBuf, io::Error);

/// Carries out all steps. If one fails, the done ones are undone; the second value is the error of
/// undoing.
pub(super) fn change(
    disk: &Disk,
    staging: &StagingFolder,
    steps: &[Step],
) -> Result<(), (Failed, Option<io::Error>)> {
    let journal = staging.path.join(JOURNAL);
    let new = staging.path.join("journal.new");
    let noted =
        to_text(steps).and_then(|text| disk.write(&new, &text)).and_then(|()| disk.rename(&new, &journal));
    // Nothing has changed so far.
    noted.map_err(|error| ((staging.path.clone(), error), None))?;
    let Err(failed) = redo(disk, staging, steps) else {
        // Removing the journal ends the change. If it cannot be removed, the next run finds nothing
        // left to do.
        let _ = disk.remove_file(&journal);
        return Ok(());
    };
    let undone = disk.rename(&journal, &staging.path.join(UNDO)).and_then(|()| undo(disk, staging, steps));
    Err((failed, undone.err()))
}

/// Finishes or undoes the changes of a killed process.
pub(super) fn recover(disk: &Disk, staging: &StagingFolder) -> io::Result<()> {
    let [journal, undo_journal] = [JOURNAL, UNDO].map(|name| staging.path.join(name));
    if is_there(&undo_journal)? {
        undo(disk, staging, &from_text(&fs::read(&undo_journal)?)?)?;
    } else if is_there(&journal)? {
        let steps = from_text(&fs::read(&journal)?)?;
        redo(disk, staging, &steps).map_err(|(path, error)| {
            io::Error::new(error.kind(), format!("{} cannot be replaced ({error})", path.display()))
        })?;
        disk.remove_file(&journal)?;
    }
    Ok(())
}

/// Whether changes must still be finished or undone.
pub(super) fn is_pending(staging: &StagingFolder) -> bool {
    [JOURNAL, UNDO].iter().any(|name| is_there(&staging.path.join(name)).unwrap_or(true))
}

/// Carries out the steps. A folder without this set's staging folder is skipped: the journal was
/// not written for it.
fn redo(disk: &Disk, staging: &StagingFolder, steps: &[Step]) -> Result<(), Failed> {
    for (number, step) in steps.iter().enumerate() {
        let done = step
            .staging_path(staging)
            .and_then(|aside| if is_folder(&aside) { step.redo(disk, staging, number) } else { Ok(()) });
        done.map_err(|error| (step.target(staging), error))?;
    }
    Ok(())
}

/// Undoes the steps in reverse order, then removes the journal.
fn undo(disk: &Disk, staging: &StagingFolder, steps: &[Step]) -> io::Result<()> {
    for (number, step) in steps.iter().enumerate().rev() {
        if is_folder(&step.staging_path(staging)?) {
            step.undo(disk, staging, number)?;
        }
    }
    disk.remove_file(&staging.path.join(UNDO))
}

/// Encodes a journal: fields that end with a zero byte, which no name contains.
fn to_text(steps: &[Step]) -> io::Result<Vec<u8>> {
    let mut text = Vec::new();
    let mut field = |bytes: &[u8]| {
        text.extend_from_slice(bytes);
        text.push(0);
    };
    field(BEGIN);
    for Step { action, other_folder, name } in steps {
        field(match action {
            Action::Put { replaces: true } => b"replace",
            Action::Put { replaces: false } => b"add",
            Action::Remove => b"remove",
        });
        field(other_folder.as_ref().map_or(Ok(&[][..]), |folder| to_bytes(folder.as_os_str()))?);
        field(to_bytes(name)?);
    }
    field(END);
    Ok(text)
}

fn from_text(text: &[u8]) -> io::Result<Vec<Step>> {
    let damaged = || io::Error::other("its journal is damaged");
    let mut fields = text.split(|&byte| byte == 0);
    if fields.next() != Some(BEGIN) {
        return Err(damaged());
    }
    let mut steps = Vec::new();
    loop {
        let action = match fields.next() {
            Some(b"replace") => Action::Put { replaces: true },
            Some(b"add") => Action::Put { replaces: false },
            Some(b"remove") => Action::Remove,
            Some(END) => return Ok(steps),
            _ => return Err(damaged()),
        };
        let (Some(other_folder), Some(name)) = (fields.next(), fields.next()) else { return Err(damaged()) };
        let (other_folder, name) = (Path::new(from_bytes(other_folder)?), from_bytes(name)?);
        let is_name = Path::new(name).file_name() == Some(name);
        if !is_name || !(other_folder.as_os_str().is_empty() || other_folder.is_absolute()) {
            return Err(damaged());
        }
        let other_folder = (!other_folder.as_os_str().is_empty()).then(|| other_folder.to_owned());
        steps.push(Step { action, other_folder, name: name.to_owned() });
    }
}

impl Step {
    /// Creates a step for a target, for a set whose staging folder lies in `beside`.
    pub(super) fn new(action: Action, target: Target, beside: &Path) -> Self {
        let Target { folder, name } = target;
        Self { action, other_folder: (folder != beside).then_some(folder), name }
    }
}
