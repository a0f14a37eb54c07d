//! Baked maps kept from run to run, in a folder, by the hash of what they are made from.
//!
//! A file is written aside and renamed, so that of two processes at once either one's file stays, whole. It ends with a hash
//! of all before it: a file that was cut short or changed is told from a whole one, and nothing of it is used. The
//! folder may be emptied at any time.

use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::{Path, PathBuf};

use blake3::Hash;
use etcetera::base_strategy::{BaseStrategy, choose_native_strategy};
use relief_io::{WriteError, WriteProblem, write_atomically};

/// The first bytes of every file; another layout gets other ones.
const MAGIC: &[u8; 16] = b"relief map 1\n\0\0\0";

/// Bytes before the texels: the magic and the hash that the map is found by.
const HEAD: u64 = 16 + 32;

/// Bytes of the hash at the end.
const TAIL: u64 = 32;

/// Texels that are read or written at once.
const CHUNK: usize = 1 << 12;

/// The environment variable that names the folder.
pub const VARIABLE: &str = "RELIEF_CACHE";

/// A folder of baked maps.
pub struct MapCache {
    folder: PathBuf,
}

/// What there is of a map.
#[derive(Debug, PartialEq)]
pub enum Kept {
    /// Nothing.
    Nothing,
    /// A file that is not what was written.
    Damaged,
    /// The texels.
    Whole(Vec<[f32; 4]>),
}

impl MapCache {
    /// The cache in that folder, which need not exist.
    pub fn new(folder: PathBuf) -> Self {
        Self { folder }
    }

    /// The cache in the folder that the environment names, or in the system's place for such files.
    ///
    /// # Errors
    ///
    /// When neither is known; the text says why.
    pub fn usual() -> Result<Self, String> {
        if let Some(folder) = std::env::var_os(VARIABLE).filter(|folder| !folder.is_empty()) {
            return Ok(Self::new(folder.into()));
        }
        let places = choose_native_strategy().map_err(|error| error.to_string())?;
        Ok(Self::new(places.cache_dir().join("relief")))
    }

    /// Where a map with that hash is kept. `what` is for people.
    pub fn path(&self, what: &str, key: Hash) -> PathBuf {
        self.folder.join(format!("{what}-{}.map", key.to_hex()))
    }

    /// Reads a map of so many texels. Memory is taken only when the file has the length that it must have.
    pub fn read(path: &Path, key: Hash, count: usize) -> Kept {
        match std::fs::metadata(path) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => Kept::Nothing,
            Ok(about) if about.is_file() && about.len() == HEAD + 16 * count as u64 + TAIL => {
                read_whole(path, key, count).ok().flatten().map_or(Kept::Damaged, Kept::Whole)
            }
            _ => Kept::Damaged,
        }
    }

    /// Keeps a map, in place of what is there.
    pub fn write(&self, path: &Path, key: Hash, texels: &[[f32; 4]]) -> Result<(), WriteError> {
        let no_folder =
            |error| WriteError { path: self.folder.clone(), problem: WriteProblem::Folder(error) };
        std::fs::create_dir_all(&self.folder).map_err(no_folder)?;
        write_atomically(path, |out| {
            let mut hasher = blake3::Hasher::new();
            let mut put = |bytes: &[u8]| {
                hasher.update(bytes);
                out.write_all(bytes)
            };
            put(MAGIC)?;
            put(key.as_bytes())?;
            let mut bytes = Vec::with_capacity(16 * CHUNK);
            for texels in texels.chunks(CHUNK) {
                bytes.clear();
                bytes.extend(texels.as_flattened().iter().flat_map(|value| value.to_le_bytes()));
                put(&bytes)?;
            }
            out.write_all(hasher.finalize().as_bytes())
        })
    }
}

/// The texels of a file of the right length; none when a byte of it is not what was written.
fn read_whole(path: &Path, key: Hash, count: usize) -> io::Result<Option<Vec<[f32; 4]>>> {
    let mut file = BufReader::new(File::open(path)?);
    let mut hasher = blake3::Hasher::new();
    let mut head = [0; HEAD as usize];
    file.read_exact(&mut head)?;
    if head[..16] != MAGIC[..] || head[16..] != key.as_bytes()[..] {
        return Ok(None);
    }
    hasher.update(&head);
    let mut texels = Vec::new();
    texels.try_reserve_exact(count).map_err(io::Error::other)?;
    let mut bytes = vec![0; 16 * CHUNK];
    while texels.len() < count {
        let bytes = &mut bytes[..16 * CHUNK.min(count - texels.len())];
        file.read_exact(bytes)?;
        hasher.update(bytes);
        texels.extend(bytes.as_chunks::<16>().0.iter().map(|texel| {
            let values = texel.as_chunks::<4>().0;
            [0, 1, 2, 3].map(|channel| f32::from_le_bytes(values[channel]))
        }));
    }
    let mut tail = [0; TAIL as usize];
    file.read_exact(&mut tail)?;
    Ok((hasher.finalize() == tail).then_some(texels))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texels(count: usize) -> Vec<[f32; 4]> {
        (0..count).map(|at| [at as f32, -1.5, f32::MIN_POSITIVE, 1.0 / (at + 1) as f32]).collect()
    }

    #[test]
    fn what_is_kept_is_read_and_nothing_else_is_taken_for_it() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let cache = MapCache::new(folder.path().join("made when needed"));
        let (key, other) = (blake3::hash(b"one"), blake3::hash(b"other"));
        let path = cache.path("kind-texture", key);
        assert_eq!(MapCache::read(&path, key, 5), Kept::Nothing);
        for count in [0, 1, CHUNK, CHUNK + 1, 3 * CHUNK - 1] {
            cache.write(&path, key, &texels(count)).expect("a writable folder");
            assert_eq!(MapCache::read(&path, key, count), Kept::Whole(texels(count)));
            assert_eq!(MapCache::read(&path, key, count + 1), Kept::Damaged);
            assert_eq!(MapCache::read(&path, other, count), Kept::Damaged);
        }
        assert_ne!(path, cache.path("kind-texture", other));
    }

    #[test]
    fn every_changed_byte_and_every_cut_is_seen() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let cache = MapCache::new(folder.path().to_owned());
        let key = blake3::hash(b"one");
        let path = cache.path("kind", key);
        cache.write(&path, key, &texels(3)).expect("a writable folder");
        let right = std::fs::read(&path).expect("the file");
        for at in 0..right.len() {
            let mut wrong = right.clone();
            wrong[at] ^= 4;
            std::fs::write(&path, &wrong).expect("the folder is writable");
            assert_eq!(MapCache::read(&path, key, 3), Kept::Damaged, "byte {at}");
            std::fs::write(&path, &right[..at]).expect("the folder is writable");
            assert_eq!(MapCache::read(&path, key, 3), Kept::Damaged, "cut at {at}");
        }
        std::fs::remove_file(&path).expect("the file");
        std::fs::create_dir(&path).expect("the folder is writable");
        assert_eq!(MapCache::read(&path, key, 3), Kept::Damaged);
        assert!(cache.write(&path, key, &texels(3)).is_err());
    }
}
