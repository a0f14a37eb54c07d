//! File sets with processes that stop before any of their operations, and with operations that
//! fail.

mod manifests;
mod refused;
mod stopped;

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use super::*;

/// Stops the operations of a [`Disk`] at a chosen one.
#[derive(Debug)]
pub(super) struct Hook {
    /// Number of operations so far.
    done: AtomicUsize,
    /// Number of the operation that fails.
    stop: AtomicUsize,
    /// Whether all later operations fail, too, as when a process is killed.
    dies: AtomicBool,
    /// Whether hard links are supported.
    has_links: AtomicBool,
}

impl Default for Hook {
    fn default() -> Self {
        let (dies, has_links) = (AtomicBool::new(false), AtomicBool::new(true));
        Self { done: AtomicUsize::new(0), stop: AtomicUsize::new(usize::MAX), dies, has_links }
    }
}

impl Hook {
    pub(super) fn allow(&self) -> io::Result<()> {
        let done = self.done.fetch_add(1, Ordering::Relaxed);
        let stop = self.stop.load(Ordering::Relaxed);
        if done == stop || (done > stop && self.dies.load(Ordering::Relaxed)) {
            return Err(io::Error::other("stopped by the test"));
        }
        Ok(())
    }

    pub(super) fn has_links(&self) -> bool {
        self.has_links.load(Ordering::Relaxed)
    }
}

/// Disk whose operation `stop` fails, and the later ones, too, if the process dies.
fn disk(stop: usize, dies: bool, has_links: bool) -> Disk {
    let disk = Disk::default();
    disk.hook.stop.store(stop, Ordering::Relaxed);
    disk.hook.dies.store(dies, Ordering::Relaxed);
    disk.hook.has_links.store(has_links, Ordering::Relaxed);
    disk
}

/// All files below a folder by name, hidden ones included, with their content and the targets of
/// links.
type State = BTreeMap<String, String>;

fn state(root: &Path) -> State {
    let mut state = State::new();
    let mut folders = vec![root.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("the folder is there") {
            let path = entry.expect("an entry").path();
            let name = path.strip_prefix(root).expect("it is below").display().to_string();
            let about = fs::symlink_metadata(&path).expect("it is there");
            if about.is_dir() {
                state.insert(name, "a folder".to_owned());
                folders.push(path);
            } else {
                let link = fs::read_link(&path).map(|to| format!("{} -> ", to.display())).unwrap_or_default();
                let content = fs::read(&path).map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
                state.insert(name, link + &content.unwrap_or_default());
            }
        }
    }
    state
}

fn open(disk: &Disk, folder: &Path) -> Result<FileSet, FileSetError> {
    FileSet::open_on(disk.clone(), folder, OsStr::new("wall"), &mut |_| false)
}

fn write(disk: &Disk, set: &mut FileSet, path: &Path, text: &str) -> Result<(), FileSetError> {
    let aside = set.put(path)?;
    let written = disk.write(&aside, text.as_bytes());
    written.map_err(|source| FileSetError::Replace { path: path.to_owned(), source })
}
