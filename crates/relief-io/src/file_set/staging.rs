//! Hidden folder in which a set is staged, and the lock in it.
//!
//! The staging folder lies beside the outputs, so that files only need to be renamed. An output in
//! another folder, or behind a link to another folder, has a *remote staging folder* there for the
//! same reason. The staging folder lists its remote ones before they are created.

use std::ffi::OsStr;
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::thread::sleep;
use std::time::{Duration, Instant};

use same_file::Handle;

use super::disk::{Disk, is_there};
use super::target::{from_bytes, to_bytes};

/// Prefix of staging folders' names; 16 hexadecimal digits follow.
const PREFIX: &str = ".relief-";

/// Prefix of remote staging folders' names.
const REMOTE_PREFIX: &str = ".relief-away-";

/// File that the working process holds a lock on.
const LOCK: &str = "lock";

/// File that lists the folders with remote staging folders.
const LIST: &str = "away";

/// Sleep between two attempts to take the lock.
const PAUSE: Duration = Duration::from_millis(20);

/// Staging folder that this process has locked.
#[derive(Debug)]
pub(super) struct StagingFolder {
    pub(super) path: PathBuf,
    _lock: File,
}

impl StagingFolder {
    /// Creates the staging folder for `name` and locks it. None if another process holds it and
    /// `wait` returns false.
    pub(super) fn take(
        disk: &Disk,
        folder: &Path,
        name: &OsStr,
        wait: &mut dyn FnMut(Duration) -> bool,
    ) -> io::Result<Option<Self>> {
        let path = folder.join(format!("{PREFIX}{}", digits(to_bytes(name)?)));
        let started = Instant::now();
        loop {
            match disk.make_folder(&path) {
                Err(error) if error.kind() != io::ErrorKind::AlreadyExists => return Err(error),
                _ => {}
            }
            if !is_folder(&path) && is_there(&path)? {
                return Err(in_the_way(&path));
            }
            let lock = match disk.open_lock(&path.join(LOCK)) {
                Ok(lock) => lock,
                // The process that held it has just removed it.
                Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
                Err(error) => return Err(error),
            };
            match lock.try_lock() {
                Ok(()) if is_current(&lock, &path) => return Ok(Some(Self { path, _lock: lock })),
                Ok(()) => {}
                Err(TryLockError::WouldBlock) if wait(started.elapsed()) => sleep(PAUSE),
                Err(TryLockError::WouldBlock) => return Ok(None),
                // A file system without locks relies on the user to run one process at a time.
                Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => {
                    return Ok(Some(Self { path, _lock: lock }));
                }
                Err(TryLockError::Error(error)) => return Err(error),
            }
        }
    }

    /// Staging folders of killed processes in `folder`, now locked by this process.
    pub(super) fn abandoned(disk: &Disk, folder: &Path) -> Vec<Self> {
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        let names = entries.filter(|entry| entry.file_name().to_str().is_some_and(is_staging_name));
        names.filter_map(|entry| Self::take_abandoned(disk, entry.path())).collect()
    }

    fn take_abandoned(disk: &Disk, path: PathBuf) -> Option<Self> {
        if !is_folder(&path) {
            return None;
        }
        let Ok(lock) = File::options().write(true).open(path.join(LOCK)) else {
            // An empty one may be removed: a process that has just created it creates it again.
            let _ = disk.remove_folder(&path);
            return None;
        };
        (lock.try_lock().is_ok() && is_current(&lock, &path)).then_some(Self { path, _lock: lock })
    }

    /// Path of the remote staging folder in another folder.
    pub(super) fn remote_path(&self, folder: &Path) -> io::Result<PathBuf> {
        Ok(folder.join(format!("{REMOTE_PREFIX}{}", digits(to_bytes(self.path.as_os_str())?))))
    }

    /// Creates the missing remote staging folders in the given folders.
    pub(super) fn make_remote(&self, disk: &Disk, folders: &[PathBuf]) -> io::Result<()> {
        let mut list = Vec::new();
        for folder in folders {
            list.extend_from_slice(to_bytes(folder.as_os_str())?);
            list.push(0);
        }
        let new = self.path.join("away.new");
        disk.write(&new, &list)?;
        disk.rename(&new, &self.path.join(LIST))?;
        for folder in folders {
            let staging = self.remote_path(folder)?;
            match disk.make_folder(&staging) {
                Err(error) if error.kind() != io::ErrorKind::AlreadyExists => return Err(error),
                _ if !is_folder(&staging) => return Err(in_the_way(&staging)),
                _ => {}
            }
        }
        Ok(())
    }

    /// Removes all files in the staging folder except the lock, and the remote staging folders.
    pub(super) fn clean(&self, disk: &Disk) -> io::Result<()> {
        let list = self.path.join(LIST);
        if let Ok(folders) = fs::read(&list) {
            for folder in folders.split(|&byte| byte == 0).filter(|folder| !folder.is_empty()) {
                let staging = self.remote_path(Path::new(from_bytes(folder)?))?;
                if is_folder(&staging) {
                    remove_files(disk, &staging, |_| true)?;
                    disk.remove_folder(&staging)?;
                }
            }
        }
        remove_files(disk, &self.path, |name| name != LOCK && name != LIST)?;
        if list.exists() { disk.remove_file(&list) } else { Ok(()) }
    }

    /// Removes the staging folder. Anything that cannot be removed is left to the next run.
    pub(super) fn leave(&self, disk: &Disk) {
        let _ = self
            .clean(disk)
            .and_then(|()| disk.remove_file(&self.path.join(LOCK)))
            .and_then(|()| disk.remove_folder(&self.path));
    }
}

/// Whether the lock's file is still in the folder. If it was removed meanwhile, another process may
/// hold the folder.
fn is_current(lock: &File, staging: &Path) -> bool {
    let held = lock.try_clone().and_then(Handle::from_file);
    matches!((held, Handle::from_path(staging.join(LOCK))), (Ok(held), Ok(found)) if held == found)
}

/// Whether the path is a folder and not a link to one.
pub(super) fn is_folder(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|about| about.is_dir())
}

fn in_the_way(path: &Path) -> io::Error {
    io::Error::other(format!("{} is in the way: remove it", path.display()))
}

fn is_staging_name(name: &str) -> bool {
    let digits = name.strip_prefix(PREFIX);
    digits.is_some_and(|digits| digits.len() == 16 && digits.bytes().all(|digit| digit.is_ascii_hexdigit()))
}

fn remove_files(disk: &Disk, folder: &Path, which: impl Fn(&OsStr) -> bool) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        if which(&entry.file_name()) && !entry.file_type()?.is_dir() {
            disk.remove_file(&entry.path())?;
        }
    }
    Ok(())
}

/// Maps a name of any length and characters to 16 hexadecimal digits.
fn digits(name: &[u8]) -> String {
    let mut digits = blake3::hash(name).to_hex().to_string();
    digits.truncate(16);
    digits
}
