//! The hidden folder in which a set is prepared, and the lock in it.
//!
//! It lies beside the outputs, so that files only need a new name to get to their places. An output that a
//! link leads elsewhere, or that is meant for another folder, has a *room away* there for the same reason.
//! The room lists its rooms away before they are made.

use std::ffi::OsStr;
use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::thread::sleep;
use std::time::{Duration, Instant};

use same_file::Handle;

use super::disk::{Disk, is_there};
use super::place::{from_bytes, to_bytes};

/// How the names of rooms begin; 16 hexadecimal digits follow.
const ROOM: &str = ".relief-";

/// How the names of rooms away begin.
const AWAY: &str = ".relief-away-";

/// The file that the process at work holds a lock on.
const LOCK: &str = "lock";

/// The file that lists the folders of the rooms away.
const LIST: &str = "away";

/// How long a process sleeps that waits for another.
const PAUSE: Duration = Duration::from_millis(20);

/// A room that this process holds.
#[derive(Debug)]
pub(super) struct Room {
    pub(super) path: PathBuf,
    _lock: File,
}

impl Room {
    /// Makes the room of that name, and locks it. None when the caller does not wait for who holds it.
    pub(super) fn take(
        disk: &Disk,
        folder: &Path,
        name: &OsStr,
        wait: &mut dyn FnMut(Duration) -> bool,
    ) -> io::Result<Option<Self>> {
        let path = folder.join(format!("{ROOM}{}", digits(to_bytes(name)?)));
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
                // Who held it has just removed it.
                Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
                Err(error) => return Err(error),
            };
            match lock.try_lock() {
                Ok(()) if is_current(&lock, &path) => return Ok(Some(Self { path, _lock: lock })),
                Ok(()) => {}
                Err(TryLockError::WouldBlock) if wait(started.elapsed()) => sleep(PAUSE),
                Err(TryLockError::WouldBlock) => return Ok(None),
                // Where the system has no locks there is one process at a time, or the user's care.
                Err(TryLockError::Error(error)) if error.kind() == io::ErrorKind::Unsupported => {
                    return Ok(Some(Self { path, _lock: lock }));
                }
                Err(TryLockError::Error(error)) => return Err(error),
            }
        }
    }

    /// The rooms in the folder whose processes were killed. Those are held now.
    pub(super) fn abandoned(disk: &Disk, folder: &Path) -> Vec<Self> {
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        let rooms = entries.filter(|entry| entry.file_name().to_str().is_some_and(is_room));
        rooms.filter_map(|entry| Self::take_abandoned(disk, entry.path())).collect()
    }

    fn take_abandoned(disk: &Disk, path: PathBuf) -> Option<Self> {
        if !is_folder(&path) {
            return None;
        }
        let Ok(lock) = File::options().write(true).open(path.join(LOCK)) else {
            // An empty one may go: who has just made it makes it again.
            let _ = disk.remove_folder(&path);
            return None;
        };
        (lock.try_lock().is_ok() && is_current(&lock, &path)).then_some(Self { path, _lock: lock })
    }

    /// The room away in another folder.
    pub(super) fn away(&self, folder: &Path) -> io::Result<PathBuf> {
        Ok(folder.join(format!("{AWAY}{}", digits(to_bytes(self.path.as_os_str())?))))
    }

    /// Makes the rooms away in those folders, where they are missing.
    pub(super) fn make_away(&self, disk: &Disk, folders: &[PathBuf]) -> io::Result<()> {
        let mut list = Vec::new();
        for folder in folders {
            list.extend_from_slice(to_bytes(folder.as_os_str())?);
            list.push(0);
        }
        let new = self.path.join("away.new");
        disk.write(&new, &list)?;
        disk.rename(&new, &self.path.join(LIST))?;
        for folder in folders {
            let room = self.away(folder)?;
            match disk.make_folder(&room) {
                Err(error) if error.kind() != io::ErrorKind::AlreadyExists => return Err(error),
                _ if !is_folder(&room) => return Err(in_the_way(&room)),
                _ => {}
            }
        }
        Ok(())
    }

    /// Removes the files in the room but the lock, and the rooms away.
    pub(super) fn clean(&self, disk: &Disk) -> io::Result<()> {
        let list = self.path.join(LIST);
        if let Ok(folders) = fs::read(&list) {
            for folder in folders.split(|&byte| byte == 0).filter(|folder| !folder.is_empty()) {
                let room = self.away(Path::new(from_bytes(folder)?))?;
                if is_folder(&room) {
                    remove_files(disk, &room, |_| true)?;
                    disk.remove_folder(&room)?;
                }
            }
        }
        remove_files(disk, &self.path, |name| name != LOCK && name != LIST)?;
        if list.exists() { disk.remove_file(&list) } else { Ok(()) }
    }

    /// Removes the room. What cannot be removed is left to the next run.
    pub(super) fn leave(&self, disk: &Disk) {
        let _ = self
            .clean(disk)
            .and_then(|()| disk.remove_file(&self.path.join(LOCK)))
            .and_then(|()| disk.remove_folder(&self.path));
    }
}

/// The lock may have been taken on a file that has been removed meanwhile: then somebody else may hold the
/// room.
fn is_current(lock: &File, room: &Path) -> bool {
    let held = lock.try_clone().and_then(Handle::from_file);
    matches!((held, Handle::from_path(room.join(LOCK))), (Ok(held), Ok(found)) if held == found)
}

/// Whether it is a folder and no link to one.
pub(super) fn is_folder(path: &Path) -> bool {
    fs::symlink_metadata(path).is_ok_and(|about| about.is_dir())
}

fn in_the_way(path: &Path) -> io::Error {
    io::Error::other(format!("{} is in the way: remove it", path.display()))
}

fn is_room(name: &str) -> bool {
    let digits = name.strip_prefix(ROOM);
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

/// Names of any length and with any characters become 16 digits.
fn digits(name: &[u8]) -> String {
    let mut digits = blake3::hash(name).to_hex().to_string();
    digits.truncate(16);
    digits
}
