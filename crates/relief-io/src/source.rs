//! Sources of a file's bytes, and their readers.

use std::borrow::Cow;
use std::fmt;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Cursor, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use crate::{ReadError, ReadProblem};

/// Input of a reader: a file by its path, or the bytes of a file in memory.
///
/// Every reader takes either. A reference to any path converts to a source:
///
/// ```no_run
/// # fn main() -> Result<(), relief_io::ReadError> {
/// use relief_io::{HeightOptions, Source, read_height};
///
/// let from_disk = read_height("rock.png", &HeightOptions::default())?;
/// # let downloaded: Vec<u8> = Vec::new();
/// let from_memory = read_height(Source::bytes("rock.png", &downloaded), &HeightOptions::default())?;
/// # Ok(())
/// # }
/// ```
///
/// Bytes are not copied: they are decoded row by row or block by block, as files are.
#[derive(Clone, Copy)]
pub struct Source<'a> {
    /// Path of the file, or the name given with bytes.
    name: &'a Path,
    bytes: Option<&'a [u8]>,
}

impl<'a> Source<'a> {
    /// Creates a source from the bytes of a whole file, with a name for errors.
    ///
    /// Formats are recognised by content. The name is used if the content shows no format: bytes
    /// with a name such as `terrain.r16` are headerless and need their layout.
    pub fn bytes(name: &'a (impl AsRef<Path> + ?Sized), bytes: &'a [u8]) -> Self {
        Self { name: name.as_ref(), bytes: Some(bytes) }
    }

    /// Returns the file's path, or the name given with its bytes.
    pub fn name(&self) -> &'a Path {
        self.name
    }

    /// Returns the path of a sidecar file with the name of this file and one more extension, if it
    /// exists. Bytes in memory have no sidecars.
    pub(crate) fn beside(&self, extension: &str) -> Option<PathBuf> {
        if self.bytes.is_some() {
            return None;
        }
        let mut name = self.name.file_name()?.to_owned();
        name.push(".");
        name.push(extension);
        Some(self.name.with_file_name(name)).filter(|path| path.is_file())
    }

    /// Returns the path of a sidecar file with this file's name and another extension, if it
    /// exists.
    pub(crate) fn in_place(&self, extension: &str) -> Option<PathBuf> {
        if self.bytes.is_some() {
            return None;
        }
        Some(self.name.with_extension(extension)).filter(|path| path != self.name && path.is_file())
    }

    /// Returns the file's folder, empty for the current one. Bytes in memory have none.
    pub(crate) fn folder(&self) -> Option<&'a Path> {
        if self.bytes.is_some() { None } else { Some(self.name.parent().unwrap_or(Path::new(""))) }
    }

    /// Returns all bytes, at least one. `take` gets the length before memory is allocated; bytes in
    /// memory need no allocation.
    pub(crate) fn whole(
        self,
        take: impl FnOnce(u64) -> Result<(), ReadProblem>,
    ) -> Result<Cow<'a, [u8]>, ReadProblem> {
        let (reader, len) = self.open()?;
        if let Some(bytes) = self.bytes {
            return Ok(Cow::Borrowed(bytes));
        }
        take(len)?;
        let mut bytes = Vec::new();
        let capacity = usize::try_from(len).unwrap_or(usize::MAX);
        bytes.try_reserve_exact(capacity).map_err(|_| ReadProblem::OutOfMemory { needed: len })?;
        reader.take(len).read_to_end(&mut bytes)?;
        Ok(Cow::Owned(bytes))
    }

    /// Creates the error of a problem with this source.
    pub(crate) fn error(self, problem: ReadProblem) -> ReadError {
        ReadError { path: self.name.to_owned(), problem }
    }

    /// Opens the source, and returns its length in bytes, which is not 0.
    pub(crate) fn open(self) -> Result<(SourceReader<'a>, u64), ReadProblem> {
        let (reader, len) = match self.bytes {
            Some(bytes) => (SourceReader::Memory(Cursor::new(bytes)), bytes.len() as u64),
            None => {
                let kind = std::fs::metadata(self.name)?;
                if kind.is_dir() {
                    return Err(ReadProblem::Folder);
                }
                // A pipe would block, and a device has no length. Recognising formats requires that
                // a file can be read twice.
                if !kind.is_file() {
                    return Err(ReadProblem::NoFile);
                }
                let file = File::open(self.name)?;
                let len = file.metadata()?.len();
                (SourceReader::File(BufReader::new(file)), len)
            }
        };
        if len == 0 {
            return Err(ReadProblem::Empty);
        }
        Ok((reader, len))
    }
}

impl<'a, P: AsRef<Path> + ?Sized> From<&'a P> for Source<'a> {
    fn from(path: &'a P) -> Self {
        Self { name: path.as_ref(), bytes: None }
    }
}

impl fmt::Debug for Source<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let len = self.bytes.map(<[u8]>::len);
        f.debug_struct("Source").field("name", &self.name).field("len", &len).finish()
    }
}

/// Opened source. Bytes in memory need no buffer.
pub(crate) enum SourceReader<'a> {
    File(BufReader<File>),
    Memory(Cursor<&'a [u8]>),
}

impl Read for SourceReader<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        match self {
            Self::File(file) => file.read(buffer),
            Self::Memory(bytes) => bytes.read(buffer),
        }
    }

    fn read_exact(&mut self, buffer: &mut [u8]) -> io::Result<()> {
        match self {
            Self::File(file) => file.read_exact(buffer),
            Self::Memory(bytes) => bytes.read_exact(buffer),
        }
    }
}

impl BufRead for SourceReader<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        match self {
            Self::File(file) => file.fill_buf(),
            Self::Memory(bytes) => bytes.fill_buf(),
        }
    }

    fn consume(&mut self, count: usize) {
        match self {
            Self::File(file) => file.consume(count),
            Self::Memory(bytes) => bytes.consume(count),
        }
    }
}

impl Seek for SourceReader<'_> {
    fn seek(&mut self, to: SeekFrom) -> io::Result<u64> {
        match self {
            Self::File(file) => file.seek(to),
            Self::Memory(bytes) => bytes.seek(to),
        }
    }

    /// Seeks without discarding a file's buffer.
    fn seek_relative(&mut self, by: i64) -> io::Result<()> {
        match self {
            Self::File(file) => file.seek_relative(by),
            Self::Memory(bytes) => bytes.seek_relative(by),
        }
    }
}
