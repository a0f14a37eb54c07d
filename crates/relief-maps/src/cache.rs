//! Baked maps kept from run to run, in a folder, by the hash of what they are made from.
//!
//! Files are written aside and renamed, so that a reader finds a whole map or none. Who writes holds a lock
//! on the folder, which the system takes back from a process that dies: whatever lies aside while nobody
//! holds it is left over, and is removed. Before a map is written, those that were unused longest make room,
//! so that the folder never holds more than its limit. It may be emptied at any time.

use std::fs::{self, DirEntry, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::thread::sleep;
use std::time::{Duration, Instant, SystemTime};

use blake3::Hash;
use etcetera::base_strategy::{BaseStrategy, choose_native_strategy};
use relief_core::{BadByteSize, BakedMap, ByteSize, MapIdentity, MapLayout};

use crate::file::{self, Found};
use crate::key::key;

/// The environment variable that names the folder.
pub const FOLDER_VARIABLE: &str = "RELIEF_CACHE";

/// The environment variable that says how much the folder may hold, as in `512MiB`.
pub const LIMIT_VARIABLE: &str = "RELIEF_CACHE_SIZE";

/// What the folder may hold when nothing else is said.
pub const DEFAULT_LIMIT: ByteSize = ByteSize(2 << 30);

/// The file that a writer locks.
const LOCK: &str = ".lock";

/// How the names of maps end.
const MAP: &str = ".map";

/// How the names of files begin that are still being written.
const ASIDE: &str = ".aside-";

/// How long a writer waits for others: a large map takes a second or two. Longer, and a stopped process stops
/// everyone.
const PATIENCE: Duration = Duration::from_secs(10);

/// How long it sleeps between two tries.
const PAUSE: Duration = Duration::from_millis(10);

/// A folder of baked maps.
#[derive(Clone, Debug)]
pub struct Cache {
    folder: PathBuf,
    limit: u64,
}

/// Why a folder keeps no map.
#[derive(Debug, thiserror::Error)]
pub enum CacheError {
    /// The system has no place for such files.
    #[error("the system names no folder for caches: {0}")]
    NoPlace(String),
    /// The environment variable is no size.
    #[error("the environment's {LIMIT_VARIABLE}: {0}")]
    BadLimit(#[from] BadByteSize),
    /// The folder cannot be made or written to.
    #[error("{}: {source}", folder.display())]
    Folder {
        /// The folder.
        folder: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// Another process has been writing into the folder for a long time.
    #[error("{}: another process is busy with it", .0.display())]
    Busy(PathBuf),
    /// The map alone is larger than all that the folder may hold.
    #[error("{}: a map of {needed} bytes is more than the {limit} that the folder may hold", folder.display())]
    TooLarge {
        /// The folder.
        folder: PathBuf,
        /// Bytes of the map's file.
        needed: u64,
        /// Bytes that the folder may hold.
        limit: u64,
    },
}

impl Cache {
    /// The cache in that folder, which need not exist. It never holds more than the limit.
    pub fn new(folder: impl Into<PathBuf>, limit: ByteSize) -> Self {
        Self { folder: folder.into(), limit: limit.0 }
    }

    /// The cache in the folder that the environment's `RELIEF_CACHE` names, or in the system's place for such
    /// files. It may hold what `RELIEF_CACHE_SIZE` says, or 2 GiB.
    ///
    /// # Errors
    ///
    /// When no folder is known, or the environment's size is none.
    pub fn usual() -> Result<Self, CacheError> {
        Ok(Self::new(Self::usual_folder()?, Self::usual_limit()?))
    }

    /// The folder that the environment's `RELIEF_CACHE` names, or the system's place for such files.
    ///
    /// # Errors
    ///
    /// When no folder is known.
    pub fn usual_folder() -> Result<PathBuf, CacheError> {
        if let Some(folder) = std::env::var_os(FOLDER_VARIABLE).filter(|folder| !folder.is_empty()) {
            return Ok(folder.into());
        }
        let places = choose_native_strategy().map_err(|error| CacheError::NoPlace(error.to_string()))?;
        Ok(places.cache_dir().join("relief"))
    }

    /// What the environment's `RELIEF_CACHE_SIZE` says, or 2 GiB.
    ///
    /// # Errors
    ///
    /// When the environment's size is none.
    pub fn usual_limit() -> Result<ByteSize, CacheError> {
        match std::env::var(LIMIT_VARIABLE) {
            Ok(text) if !text.is_empty() => Ok(text.parse()?),
            _ => Ok(DEFAULT_LIMIT),
        }
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Where a map of that identity and shape is kept.
    pub(crate) fn path(&self, identity: &MapIdentity, layout: &MapLayout) -> PathBuf {
        self.folder.join(name(identity, key(identity, layout)))
    }

    /// The map of that identity and shape, if it is there.
    pub(crate) fn read(&self, identity: &MapIdentity, layout: &MapLayout) -> Found {
        let key = key(identity, layout);
        let path = self.folder.join(name(identity, key));
        let found = file::read(&path, key, identity.clone(), *layout);
        if let Found::Whole(_) = found {
            // What was used last stays longest. Where the folder is read-only nothing is dropped either.
            let _ = File::options()
                .append(true)
                .open(&path)
                .and_then(|file| file.set_modified(SystemTime::now()));
        }
        found
    }

    /// Keeps a map, in place of what is there.
    pub(crate) fn write(&self, map: &BakedMap) -> Result<PathBuf, CacheError> {
        let needed = file::length(map.layout());
        if needed > self.limit {
            let (folder, limit) = (self.folder.clone(), self.limit);
            return Err(CacheError::TooLarge { folder, needed, limit });
        }
        fs::create_dir_all(&self.folder).map_err(|error| self.failed(error))?;
        let _lock = self.locked(PATIENCE)?;
        let key = key(map.identity(), map.layout());
        let name = name(map.identity(), key);
        let path = self.folder.join(&name);
        // Who waited for another process that baked the same map need not write it again.
        if let Found::Whole(_) = file::read(&path, key, map.identity().clone(), *map.layout()) {
            return Ok(path);
        }
        let written = || {
            self.remove_left_over()?;
            // The old file of that name goes, too: beside the new one it would count twice.
            remove(&path)?;
            self.make_room(needed)?;
            let aside = self.folder.join(format!("{ASIDE}{name}"));
            file::write(&aside, key, map).and_then(|()| fs::rename(&aside, &path)).inspect_err(|_| {
                // The error that led here says more than one of this.
                let _ = remove(&aside);
            })
        };
        written().map_err(|error| self.failed(error))?;
        Ok(path)
    }

    /// Removes what killed processes left, and what is above the limit. A folder that somebody else is
    /// writing into is left to him.
    pub(crate) fn tidy(&self) {
        let Ok(files) = self.files() else { return };
        let left_over = files.iter().any(|file| is_aside(&file.name));
        let held: u64 = files.iter().filter(|file| is_map(&file.name)).map(|file| file.bytes).sum();
        if (left_over || held > self.limit)
            && let Ok(_lock) = self.locked(Duration::ZERO)
        {
            // What cannot be removed now is tried again by the next run.
            let _ = self.remove_left_over().and_then(|()| self.make_room(0));
        }
    }

    fn failed(&self, source: io::Error) -> CacheError {
        CacheError::Folder { folder: self.folder.clone(), source }
    }

    /// The folder for this process alone, until the file is closed.
    fn locked(&self, patience: Duration) -> Result<File, CacheError> {
        let path = self.folder.join(LOCK);
        let lock = File::options().create(true).truncate(false).write(true).open(path);
        let lock = lock.map_err(|error| self.failed(error))?;
        let started = Instant::now();
        loop {
            match lock.try_lock() {
                Ok(()) => return Ok(lock),
                Err(TryLockError::WouldBlock) if started.elapsed() < patience => sleep(PAUSE),
                Err(TryLockError::WouldBlock) => return Err(CacheError::Busy(self.folder.clone())),
                Err(TryLockError::Error(error)) => return Err(self.failed(error)),
            }
        }
    }

    /// To be called with the lock held.
    fn remove_left_over(&self) -> io::Result<()> {
        self.files()?.iter().filter(|file| is_aside(&file.name)).try_for_each(|file| remove(&file.path))
    }

    /// Drops maps, those unused longest first, until so many bytes more fit. To be called with the lock held.
    fn make_room(&self, needed: u64) -> io::Result<()> {
        let mut maps: Vec<Kept> = self.files()?.into_iter().filter(|file| is_map(&file.name)).collect();
        maps.sort_by(|a, b| a.used.cmp(&b.used).then_with(|| a.name.cmp(&b.name)));
        let mut held: u64 = maps.iter().map(|map| map.bytes).sum();
        for map in maps {
            if held.saturating_add(needed) <= self.limit {
                break;
            }
            remove(&map.path)?;
            held -= map.bytes;
        }
        Ok(())
    }

    fn files(&self) -> io::Result<Vec<Kept>> {
        let entries = fs::read_dir(&self.folder)?.filter_map(|entry| entry.ok().and_then(Kept::of));
        Ok(entries.collect())
    }
}

/// A file in the folder.
struct Kept {
    path: PathBuf,
    name: String,
    bytes: u64,
    used: SystemTime,
}

impl Kept {
    /// None for what is no file, or has gone meanwhile.
    fn of(entry: DirEntry) -> Option<Self> {
        let about = entry.metadata().ok().filter(fs::Metadata::is_file)?;
        let name = entry.file_name().into_string().ok()?;
        let used = about.modified().unwrap_or(SystemTime::UNIX_EPOCH);
        Some(Self { path: entry.path(), name, bytes: about.len(), used })
    }
}

/// The file's name: kind and texture for people, the key for us.
fn name(identity: &MapIdentity, key: Hash) -> String {
    let MapIdentity { kind, texture, .. } = identity;
    let dash = if texture.is_empty() { "" } else { "-" };
    format!("{kind}{dash}{texture}-{}{MAP}", key.to_hex())
}

/// Whether a file is a map of ours: files of other people are neither counted nor removed.
fn is_map(name: &str) -> bool {
    let digits = name.strip_suffix(MAP).and_then(|name| name.rsplit_once('-')).map(|(_, digits)| digits);
    digits.is_some_and(|digits| digits.len() == 64 && digits.bytes().all(|digit| digit.is_ascii_hexdigit()))
        && !is_aside(name)
}

fn is_aside(name: &str) -> bool {
    name.starts_with(ASIDE)
}

/// Removes a file that may have gone already.
fn remove(path: &Path) -> io::Result<()> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests;
