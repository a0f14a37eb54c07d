//! What is about to change, written down before the first change: who finds a journal can finish the work of
//! a killed process, or undo it.
//!
//! The new content of step `i` lies in its room as `new.i`. What it replaces or removes is kept there as
//! `old.i` until all is done.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use super::disk::{Disk, is_there};
use super::place::{Place, from_bytes, to_bytes};
use super::room::{Room, is_folder};

/// The journal of work to be finished.
const JOURNAL: &str = "journal";

/// The journal of work to be undone.
const UNDO: &str = "undo";

/// What a journal begins and ends with.
const BEGIN: &[u8] = b"relief journal 1";
const END: &[u8] = b"end";

/// A change of one file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Step {
    pub(super) action: Action,
    /// The folder, where it is not the one beside the room.
    pub(super) away: Option<PathBuf>,
    pub(super) name: std::ffi::OsString,
}

/// What is done to a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Action {
    /// It gets new content; `replaces` when it had one before.
    Put { replaces: bool },
    /// It goes.
    Remove,
}

impl Step {
    /// The folder with the step's content, old and new.
    pub(super) fn room(&self, room: &Room) -> io::Result<PathBuf> {
        self.away.as_ref().map_or_else(|| Ok(room.path.clone()), |folder| room.away(folder))
    }

    /// The file that changes.
    pub(super) fn target(&self, room: &Room) -> PathBuf {
        let beside = room.path.parent().unwrap_or(Path::new("."));
        self.away.as_deref().unwrap_or(beside).join(&self.name)
    }

    /// Does it, or what is left of it to do.
    fn redo(&self, disk: &Disk, room: &Room, number: usize) -> io::Result<()> {
        let (aside, target) = (self.room(room)?, self.target(room));
        let (new, old) = (aside.join(format!("new.{number}")), aside.join(format!("old.{number}")));
        let keeps = match self.action {
            // Without new content there is nothing left to do.
            Action::Put { .. } if !is_there(&new)? => return Ok(()),
            Action::Put { replaces } => replaces,
            Action::Remove => true,
        };
        if keeps && !is_there(&old)? && is_there(&target)? {
            if !fs::symlink_metadata(&target)?.is_file() {
                return Err(io::Error::other("it is no regular file any more"));
            }
            // A second name keeps the file in its place until the new one takes it. Some file systems have
            // none.
            if self.action == Action::Remove || disk.link(&target, &old).is_err() {
                disk.rename(&target, &old)?;
            }
        }
        if self.action == Action::Remove { Ok(()) } else { disk.rename(&new, &target) }
    }

    /// Undoes it, or what is left of it to undo.
    fn undo(&self, disk: &Disk, room: &Room, number: usize) -> io::Result<()> {
        let (aside, target) = (self.room(room)?, self.target(room));
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

/// A change that failed: the file, and why.
pub(super) type Failed = (PathBuf, io::Error);

/// Changes all files as the steps say. When that fails, undoes what was done; the second value is why that
/// failed, too.
pub(super) fn change(disk: &Disk, room: &Room, steps: &[Step]) -> Result<(), (Failed, Option<io::Error>)> {
    let journal = room.path.join(JOURNAL);
    let new = room.path.join("journal.new");
    let noted =
        to_text(steps).and_then(|text| disk.write(&new, &text)).and_then(|()| disk.rename(&new, &journal));
    // Nothing has changed so far.
    noted.map_err(|error| ((room.path.clone(), error), None))?;
    let Err(failed) = redo(disk, room, steps) else {
        // Without the journal it is done. When it cannot be removed, the next run finds nothing left to do.
        let _ = disk.remove_file(&journal);
        return Ok(());
    };
    let undone = disk.rename(&journal, &room.path.join(UNDO)).and_then(|()| undo(disk, room, steps));
    Err((failed, undone.err()))
}

/// Finishes or undoes what a killed process had begun.
pub(super) fn recover(disk: &Disk, room: &Room) -> io::Result<()> {
    let [journal, undo_journal] = [JOURNAL, UNDO].map(|name| room.path.join(name));
    if is_there(&undo_journal)? {
        undo(disk, room, &from_text(&fs::read(&undo_journal)?)?)?;
    } else if is_there(&journal)? {
        let steps = from_text(&fs::read(&journal)?)?;
        redo(disk, room, &steps).map_err(|(path, error)| {
            io::Error::new(error.kind(), format!("{} cannot be replaced ({error})", path.display()))
        })?;
        disk.remove_file(&journal)?;
    }
    Ok(())
}

/// Whether there is work that must be finished or undone.
pub(super) fn is_pending(room: &Room) -> bool {
    [JOURNAL, UNDO].iter().any(|name| is_there(&room.path.join(name)).unwrap_or(true))
}

/// Goes through the steps. A folder without our room is not one that the journal was written for.
fn redo(disk: &Disk, room: &Room, steps: &[Step]) -> Result<(), Failed> {
    for (number, step) in steps.iter().enumerate() {
        let done = step
            .room(room)
            .and_then(|aside| if is_folder(&aside) { step.redo(disk, room, number) } else { Ok(()) });
        done.map_err(|error| (step.target(room), error))?;
    }
    Ok(())
}

/// Goes back through the steps, then drops the journal.
fn undo(disk: &Disk, room: &Room, steps: &[Step]) -> io::Result<()> {
    for (number, step) in steps.iter().enumerate().rev() {
        if is_folder(&step.room(room)?) {
            step.undo(disk, room, number)?;
        }
    }
    disk.remove_file(&room.path.join(UNDO))
}

/// A journal's bytes: fields that end with a zero byte, which no name has.
fn to_text(steps: &[Step]) -> io::Result<Vec<u8>> {
    let mut text = Vec::new();
    let mut field = |bytes: &[u8]| {
        text.extend_from_slice(bytes);
        text.push(0);
    };
    field(BEGIN);
    for Step { action, away, name } in steps {
        field(match action {
            Action::Put { replaces: true } => b"replace",
            Action::Put { replaces: false } => b"add",
            Action::Remove => b"remove",
        });
        field(away.as_ref().map_or(Ok(&[][..]), |folder| to_bytes(folder.as_os_str()))?);
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
        let (Some(away), Some(name)) = (fields.next(), fields.next()) else { return Err(damaged()) };
        let (away, name) = (Path::new(from_bytes(away)?), from_bytes(name)?);
        let is_name = Path::new(name).file_name() == Some(name);
        if !is_name || !(away.as_os_str().is_empty() || away.is_absolute()) {
            return Err(damaged());
        }
        let away = (!away.as_os_str().is_empty()).then(|| away.to_owned());
        steps.push(Step { action, away, name: name.to_owned() });
    }
}

impl Step {
    /// Of a file in that place, for a set whose room lies in `beside`.
    pub(super) fn new(action: Action, place: Place, beside: &Path) -> Self {
        let Place { folder, name } = place;
        Self { action, away: (folder != beside).then_some(folder), name }
    }
}
