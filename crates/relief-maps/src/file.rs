//! File format of a cached map: its key, the meaning of its codes, its texels, and a hash of all
//! these.
//!
//! The hash detects files that were truncated or changed. Nothing of such a file is used.

use std::fs::File;
use std::io::{self, BufReader, BufWriter, Read, Write};
use std::path::Path;

use blake3::{Hash, Hasher};
use relief_core::encoding::code::Codes;
use relief_core::{BakedMap, MapFormat, MapIdentity, MapLayout, MapTexels};

/// First bytes of every file. Another file format gets other ones.
const MAGIC: &[u8; 16] = b"relief map 2\n\0\0\0";

/// Bytes before the texels: the magic, the key and the codes.
const HEAD: u64 = 16 + 32 + 32;

/// Bytes of the hash at the end.
const TAIL: u64 = 32;

/// Number of values read or written at once.
const CHUNK: usize = 1 << 14;

/// Content of a file.
#[derive(Debug, PartialEq)]
pub enum CacheEntry {
    /// The file does not exist.
    Missing,
    /// The file is not as it was written.
    Damaged,
    /// The map is complete.
    Valid(Box<BakedMap>),
}

/// Size of a map's file in bytes.
pub fn length(layout: &MapLayout) -> u64 {
    HEAD + layout.bytes() + TAIL
}

/// Writes a map's file.
pub fn write(path: &Path, key: Hash, map: &BakedMap) -> io::Result<()> {
    let mut out =
        Hashed { inner: BufWriter::with_capacity(1 << 16, File::create(path)?), hasher: Hasher::new() };
    out.put(MAGIC)?;
    out.put(key.as_bytes())?;
    for Codes { low, step } in map.codes() {
        out.put(&low.to_le_bytes())?;
        out.put(&step.to_le_bytes())?;
    }
    match map.texels() {
        MapTexels::F32(values) => out.values(values, |value| value.to_le_bytes())?,
        MapTexels::F16(values) => out.values(values, |value| value.to_le_bytes())?,
        MapTexels::Unorm8(values) => out.values(values, |value| [value])?,
    }
    let tail = out.hasher.finalize();
    out.inner.write_all(tail.as_bytes())?;
    out.inner.flush()
}

/// Reads the map with this identity and layout. Memory is allocated only if the file has the right
/// length.
pub fn read(path: &Path, key: Hash, identity: MapIdentity, layout: MapLayout) -> CacheEntry {
    match std::fs::metadata(path) {
        // A file without readable metadata counts as missing.
        Err(_) => CacheEntry::Missing,
        Ok(about) if about.is_file() && about.len() == length(&layout) => {
            let map = read_valid(path, key, identity, layout).ok().flatten();
            map.map_or(CacheEntry::Damaged, |map| CacheEntry::Valid(Box::new(map)))
        }
        _ => CacheEntry::Damaged,
    }
}

/// Reads the map from a file of the right length. `None` if any byte differs from what was written.
fn read_valid(
    path: &Path,
    key: Hash,
    identity: MapIdentity,
    layout: MapLayout,
) -> io::Result<Option<BakedMap>> {
    let mut file =
        Hashed { inner: BufReader::with_capacity(1 << 16, File::open(path)?), hasher: Hasher::new() };
    let mut head = [0; HEAD as usize];
    file.fill(&mut head)?;
    if head[..16] != MAGIC[..] || head[16..48] != key.as_bytes()[..] {
        return Ok(None);
    }
    let numbers = head[48..].as_chunks::<4>().0;
    let codes = [0, 1, 2, 3].map(|channel| {
        let [low, step] = [0, 1].map(|part| f32::from_le_bytes(numbers[2 * channel + part]));
        Codes { low, step }
    });
    let texels = match layout.format {
        MapFormat::F32 => MapTexels::F32(file.all(&layout, f32::from_le_bytes)?),
        MapFormat::F16 => MapTexels::F16(file.all(&layout, u16::from_le_bytes)?),
        MapFormat::Unorm8 => MapTexels::Unorm8(file.all(&layout, |[code]: [u8; 1]| code)?),
    };
    let expected = file.hasher.finalize();
    let mut tail = [0; TAIL as usize];
    file.inner.read_exact(&mut tail)?;
    if expected != tail {
        return Ok(None);
    }
    Ok(BakedMap::new(identity, layout, codes, texels).ok())
}

/// A file whose bytes are hashed while they pass.
struct Hashed<T> {
    inner: T,
    hasher: Hasher,
}

impl<T: Write> Hashed<T> {
    fn put(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.hasher.update(bytes);
        self.inner.write_all(bytes)
    }

    fn values<V: Copy, const N: usize>(
        &mut self,
        values: &[V],
        bytes: impl Fn(V) -> [u8; N],
    ) -> io::Result<()> {
        let mut chunk = Vec::with_capacity(N * CHUNK);
        for values in values.chunks(CHUNK) {
            chunk.clear();
            chunk.extend(values.iter().flat_map(|value| bytes(*value)));
            self.put(&chunk)?;
        }
        Ok(())
    }
}

impl<T: Read> Hashed<T> {
    fn fill(&mut self, bytes: &mut [u8]) -> io::Result<()> {
        self.inner.read_exact(bytes)?;
        self.hasher.update(bytes);
        Ok(())
    }

    fn all<V, const N: usize>(
        &mut self,
        layout: &MapLayout,
        value: impl Fn([u8; N]) -> V,
    ) -> io::Result<Vec<V>> {
        let count = (layout.texels() * u64::from(layout.channels)) as usize;
        let mut values = Vec::new();
        values.try_reserve_exact(count).map_err(io::Error::other)?;
        let mut bytes = vec![0; N * CHUNK];
        while values.len() < count {
            let bytes = &mut bytes[..N * CHUNK.min(count - values.len())];
            self.fill(bytes)?;
            values.extend(bytes.as_chunks::<N>().0.iter().map(|bytes| value(*bytes)));
        }
        Ok(values)
    }
}
