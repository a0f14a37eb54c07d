//! The file that keeps a map: what it is found by, what its codes stand for, its texels, and a hash of all of
//! that.
//!
//! The hash tells a file that was cut short or changed from a whole one; nothing of such a file is used.

use std::fs::File;
use std::io::{self, BufReader, BufWriter, Read, Write};
use std::path::Path;

use blake3::{Hash, Hasher};
use relief_core::encoding::code::Codes;
use relief_core::{BakedMap, MapFormat, MapIdentity, MapLayout, MapTexels};

/// The first bytes of every file; another layout of the file gets other ones.
const MAGIC: &[u8; 16] = b"relief map 2\n\0\0\0";

/// Bytes before the texels: the magic, the key and the codes.
const HEAD: u64 = 16 + 32 + 32;

/// Bytes of the hash at the end.
const TAIL: u64 = 32;

/// Values that are read or written at once.
const CHUNK: usize = 1 << 14;

/// What a file holds.
#[derive(Debug, PartialEq)]
pub enum Found {
    /// There is none.
    Nothing,
    /// It is not what was written.
    Damaged,
    /// The map.
    Whole(Box<BakedMap>),
}

/// Bytes of the file of a map.
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

/// Reads a map of that identity and shape. Memory is taken only when the file has the length that it must
/// have.
pub fn read(path: &Path, key: Hash, identity: MapIdentity, layout: MapLayout) -> Found {
    match std::fs::metadata(path) {
        // What cannot even be looked at is as good as not there.
        Err(_) => Found::Nothing,
        Ok(about) if about.is_file() && about.len() == length(&layout) => {
            let whole = read_whole(path, key, identity, layout).ok().flatten();
            whole.map_or(Found::Damaged, |map| Found::Whole(Box::new(map)))
        }
        _ => Found::Damaged,
    }
}

/// The map of a file of the right length; none when a byte of it is not what was written.
fn read_whole(
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

/// A file whose bytes are hashed on their way.
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
