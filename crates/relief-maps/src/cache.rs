//! A folder of baked maps that persists between runs. Maps are found by the hash of everything that
//! determines them.
//!
//! Files are written under another name and renamed, so that a reader finds a complete map or none.
//! A writer holds a lock on the folder; the system releases it if the process dies. An unfinished
//! file while nobody holds the lock is a leftover, and is removed. Before a map is written, the
//! least recently used maps are deleted, so that the folder never exceeds its limit. The folder may
//! be emptied at any time.

use std::fs::{self, DirEntry, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::thread::sleep;
use std::time::{Duration, Instant, SystemTime};

use blake3::Hash;
use etcetera::base_strategy::{BaseStrategy, choose_native_strategy};
use relief_core::{BadByteSize, BakedMap, ByteSize, MapIdentity, MapLayout};

use crate::file::{self, CacheEntry};
use crate::key::key;

/// Environment variable with the folder's path.
pub const FOLDER_VARIABLE: &str = "RELIEF_CACHE";

/// Environment variable with the folder's size limit, as in `512MiB`.
pub const LIMIT_VARIABLE: &str = "RELIEF_CACHE_SIZE";

/// Default size limit of the folder: 2 GiB.
pub const DEFAULT_LIMIT: ByteSize = ByteSize(2 << 30);

/// File that a writer locks.
const LOCK: &str = ".lock";

/// Suffix of the names of maps.
const MAP: &str = ".map";

/// Prefix of the names of unfinished files.
const UNFINISHED: &str = ".aside-";

/// Time that a writer waits for others. A large map takes a second or two. With a longer wait, a
/// stopped process would stop all others.
const LOCK_TIMEOUT: Duration = Duration::from_secs(10);

/// Pause between two attempts to lock.
const LOCK_PAUSE: Duration = Duration::from_millis(10);

/// A folder of baked maps.
#[derive(Clone, Debug)]
pub struct Cache {
    folder: PathBuf,
    limit: u64,
}

/// Why a folder cannot store a map.
#[derive(Debug, thiserror::Error)]
pub enum CacheError {
    /// The system has no folder for caches.
    #[error("the system names no folder for caches: {0}")]
    NoPlace(String),
    /// The environment variable does not hold a size.
    #[error("the environment's {LIMIT_VARIABLE}: {0}")]
    BadLimit(#[from] BadByteSize),
    /// The folder cannot be created or written to.
    #[error("{}: {source}", folder.display())]
    Folder {
        /// Path of the folder.
        folder: PathBuf,
        /// Error of the system.
        source: io::Error,
    },
    /// Another process has been writing into the folder for a long time.
    #[error("{}: another process is still writing to it: try again later", .0.display())]
    Busy(PathBuf),
    /// The map alone exceeds the folder's limit.
    #[error("{}: a map of {needed} bytes exceeds the folder's limit of {limit} bytes", folder.display())]
    TooLarge {
        /// Path of the folder.
        folder: PathBuf,
        /// Size of the map's file in bytes.
        needed: u64,
        /// Limit of the folder in bytes.
        limit: u64,
    },
}

impl Cache {
    /// Creates a cache in a folder, which need not exist, with a size limit.
    pub fn new(folder: impl Into<PathBuf>, limit: ByteSize) -> Self {
        Self { folder: folder.into(), limit: limit.0 }
    }

    /// Creates the cache in its usual folder with its usual limit: see
    /// [`usual_folder`](Self::usual_folder) and [`usual_limit`](Self::usual_limit).
    ///
    /// # Errors
    ///
    /// When no folder is known, or the environment variable does not hold a size.
    pub fn usual() -> Result<Self, CacheError> {
        Ok(Self::new(Self::usual_folder()?, Self::usual_limit()?))
    }

    /// Returns the folder in the environment variable `RELIEF_CACHE`, or else the system's folder
    /// for caches.
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

    /// Returns the limit in the environment variable `RELIEF_CACHE_SIZE`, or else 2 GiB.
    ///
    /// # Errors
    ///
    /// When the environment variable does not hold a size.
    pub fn usual_limit() -> Result<ByteSize, CacheError> {
        match std::env::var(LIMIT_VARIABLE) {
            Ok(text) if !text.is_empty() => Ok(text.parse()?),
            _ => Ok(DEFAULT_LIMIT),
        }
    }

    /// Path of the folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Path of the map with this identity and layout.
    pub(crate) fn path(&self, identity: &MapIdentity, layout: &MapLayout) -> PathBuf {
        self.folder.join(name(identity, key(identity, layout)))
    }

    /// Reads the map with this identity and layout, if the folder holds it.
    pub(crate) fn read(&self, identity: &MapIdentity, layout: &MapLayout) -> CacheEntry {
        let key = key(identity, layout);
        let path = self.folder.join(name(identity, key));
        let found = file::read(&path, key, identity.clone(), *layout);
        if let CacheEntry::Valid(_) = found {
            // The most recently used maps are deleted last. In a read-only folder nothing is
            // deleted.
            let _ = File::options()
                .append(true)
                .open(&path)
                .and_then(|file| file.set_modified(SystemTime::now()));
        }
        found
    }

    /// Stores a map, replacing an existing file.
    pub(crate) fn write(&self, map: &BakedMap) -> Result<PathBuf, CacheError> {
        let needed = file::length(map.layout());
        if needed > self.limit {
            let (folder, limit) = (self.folder.clone(), self.limit);
            return Err(CacheError::TooLarge { folder, needed, limit });
        }
        fs::create_dir_all(&self.folder).map_err(|error| self.failed(error))?;
        let _lock = self.locked(LOCK_TIMEOUT)?;
        let key = key(map.identity(), map.layout());
        let name = name(map.identity(), key);
        let path = self.folder.join(&name);
        // Another process may have stored the same map during the wait.
        if let CacheEntry::Valid(_) = file::read(&path, key, map.identity().clone(), *map.layout()) {
            return Ok(path);
        }
        let written = || {
            self.remove_unfinished()?;
            // The old file with this name is deleted, too. Beside the new one it would count twice.
            remove(&path)?;
            self.evict(needed)?;
            let aside = self.folder.join(format!("{UNFINISHED}{name}"));
            file::write(&aside, key, map).and_then(|()| fs::rename(&aside, &path)).inspect_err(|_| {
                // The error that led here is more informative than an error of this call.
                let _ = remove(&aside);
            })
        };
        written().map_err(|error| self.failed(error))?;
        Ok(path)
    }

    /// Deletes leftovers of killed processes, and maps above the limit. A folder into which another
    /// process is writing is left alone.
    pub(crate) fn tidy(&self) {
        let Ok(files) = self.files() else { return };
        let has_leftovers = files.iter().any(|file| is_unfinished(&file.name));
        let held: u64 = files.iter().filter(|file| is_map(&file.name)).map(|file| file.bytes).sum();
        if (has_leftovers || held > self.limit)
            && let Ok(_lock) = self.locked(Duration::ZERO)
        {
            // Deletions that fail now are tried again in the next run.
            let _ = self.remove_unfinished().and_then(|()| self.evict(0));
        }
    }

    fn failed(&self, source: io::Error) -> CacheError {
        CacheError::Folder { folder: self.folder.clone(), source }
    }

    /// Locks the folder for this process until the returned file is closed.
    fn locked(&self, patience: Duration) -> Result<File, CacheError> {
        let path = self.folder.join(LOCK);
        let lock = File::options().create(true).truncate(false).write(true).open(path);
        let lock = lock.map_err(|error| self.failed(error))?;
        let started = Instant::now();
        loop {
            match lock.try_lock() {
                Ok(()) => return Ok(lock),
                Err(TryLockError::WouldBlock) if started.elapsed() < patience => sleep(LOCK_PAUSE),
                Err(TryLockError::WouldBlock) => return Err(CacheError::Busy(self.folder.clone())),
                Err(TryLockError::Error(error)) => return Err(self.failed(error)),
            }
        }
    }

    /// Deletes unfinished files. The lock must be held.
    fn remove_unfinished(&self) -> io::Result<()> {
        self.files()?.iter().filter(|file| is_unfinished(&file.name)).try_for_each(|file| remove(&file.path))
    }

    /// Deletes the least recently used maps until `needed` more bytes fit. The lock must be held.
    fn evict(&self, needed: u64) -> io::Result<()> {
        let mut maps: Vec<CacheFile> = self.files()?.into_iter().filter(|file| is_map(&file.name)).collect();
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

    fn files(&self) -> io::Result<Vec<CacheFile>> {
        let entries = fs::read_dir(&self.folder)?.filter_map(|entry| entry.ok().and_then(CacheFile::of));
        Ok(entries.collect())
    }
}

/// A file in the folder.
struct CacheFile {
    path: PathBuf,
    name: String,
    bytes: u64,
    used: SystemTime,
}

impl CacheFile {
    /// Returns `None` for anything but a file, and for a file that has been deleted meanwhile.
    fn of(entry: DirEntry) -> Option<Self> {
        let about = entry.metadata().ok().filter(fs::Metadata::is_file)?;
        let name = entry.file_name().into_string().ok()?;
        let used = about.modified().unwrap_or(SystemTime::UNIX_EPOCH);
        Some(Self { path: entry.path(), name, bytes: about.len(), used })
    }
}

/// Name of the file: kind and texture for people, the key for the cache.
fn name(identity: &MapIdentity, key: Hash) -> String {
    let MapIdentity { kind, texture, .. } = identity;
    let dash = if texture.is_empty() { "" } else { "-" };
    format!("{kind}{dash}{texture}-{}{MAP}", key.to_hex())
}

/// Whether a file is a map of this cache. Other files are neither counted nor deleted.
fn is_map(name: &str) -> bool {
    let digits = name.strip_suffix(MAP).and_then(|name| name.rsplit_once('-')).map(|(_, digits)| digits);
    digits.is_some_and(|digits| digits.len() == 64 && digits.bytes().all(|digit| digit.is_ascii_hexdigit()))
        && !is_unfinished(name)
}

fn is_unfinished(name: &str) -> bool {
    name.starts_with(UNFINISHED)
}

/// Deletes a file that may be missing already.
fn remove(path: &Path) -> io::Result<()> {
    match fs::remove_file(path) {
        Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests;
