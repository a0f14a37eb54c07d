//! Sources of a file's bytes, and their readers.

use std::borrow::Cow;
use std::ffi::OsString;
use std::fmt;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Cursor, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use crate::files::MemoryFiles;
use crate::{ReadError, ReadProblem};

/// Input of a reader: a file on disk, a file among [`Files`](crate::Files), or the bytes of a file in memory.
///
/// Every reader takes each of them. A reference to any path converts to a source on disk:
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
    place: Place<'a>,
}

/// The files beside the bytes of one file.
static NO_FILES: MemoryFiles = MemoryFiles::new();

/// Place of a source's bytes.
#[derive(Clone, Copy)]
enum Place<'a> {
    Disk,
    /// The bytes of one file, which has no folder.
    Bytes(&'a [u8]),
    Memory(&'a MemoryFiles),
}

impl<'a> Source<'a> {
    /// Creates a source from the bytes of a whole file, with a name for errors.
    ///
    /// Formats are recognised by content. The name is used if the content shows no format: bytes
    /// with a name such as `terrain.r16` are headerless and need their layout.
    pub fn bytes(name: &'a (impl AsRef<Path> + ?Sized), bytes: &'a [u8]) -> Self {
        Self { name: name.as_ref(), place: Place::Bytes(bytes) }
    }

    /// Creates the source of a file in memory.
    pub(crate) fn in_memory(name: &'a Path, files: &'a MemoryFiles) -> Self {
        Self { name, place: Place::Memory(files) }
    }

    /// Returns the file's path, or the name given with its bytes.
    pub fn name(&self) -> &'a Path {
        self.name
    }

    /// Returns the source of another path in the same place. Beside the bytes of one file there is no other,
    /// so reading the result fails.
    pub fn with_name<'b>(&self, name: &'b Path) -> Source<'b>
    where
        'a: 'b,
    {
        match self.place {
            Place::Disk => Source::from(name),
            Place::Bytes(_) => Source::in_memory(name, &NO_FILES),
            Place::Memory(files) => Source::in_memory(name, files),
        }
    }

    /// Returns whether the source is a regular file: no folder, pipe or device.
    ///
    /// # Errors
    ///
    /// When it does not exist or cannot be accessed.
    pub fn is_file(&self) -> io::Result<bool> {
        match self.place {
            Place::Disk => Ok(std::fs::metadata(self.name)?.is_file()),
            Place::Bytes(_) => Ok(true),
            Place::Memory(files) => match files.read(self.name) {
                Ok(_) => Ok(true),
                Err(error) if error.kind() == io::ErrorKind::IsADirectory => Ok(false),
                Err(error) => Err(error),
            },
        }
    }

    /// Returns whether the source is a folder.
    pub(crate) fn is_folder(&self) -> bool {
        match self.place {
            Place::Disk => self.name.is_dir(),
            Place::Bytes(_) => false,
            Place::Memory(files) => files.is_folder(self.name),
        }
    }

    /// Reads the first `most` bytes, or all of them if there are fewer.
    ///
    /// # Errors
    ///
    /// When the file cannot be read.
    pub fn start(&self, most: u64) -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        match self.held() {
            Some(held) => held?.take(most).read_to_end(&mut bytes)?,
            None => File::open(self.name)?.take(most).read_to_end(&mut bytes)?,
        };
        Ok(bytes)
    }

    /// Returns the names of the entries of the folder that this source names, in no order. Bytes alone are no
    /// folder.
    pub(crate) fn entries(&self, most: usize) -> io::Result<Vec<OsString>> {
        match self.place {
            Place::Disk => {
                let here = if self.name.as_os_str().is_empty() { Path::new(".") } else { self.name };
                let entries = std::fs::read_dir(here)?.take(most);
                entries.map(|entry| Ok(entry?.file_name())).collect()
            }
            Place::Bytes(_) => Err(io::ErrorKind::NotADirectory.into()),
            Place::Memory(files) => files.entries(self.name, most),
        }
    }

    /// Returns the path that names this folder itself, for messages: on disk without links and `..`.
    pub(crate) fn real_name(&self) -> PathBuf {
        match self.place {
            Place::Disk => self.name.canonicalize().unwrap_or_else(|_| self.name.to_owned()),
            Place::Bytes(_) | Place::Memory(_) => self.name.to_owned(),
        }
    }

    /// Returns the path of a sidecar file with the name of this file and one more extension, if it
    /// exists. Bytes alone have no sidecars.
    pub(crate) fn beside(&self, extension: &str) -> Option<PathBuf> {
        let mut name = self.name.file_name()?.to_owned();
        name.push(".");
        name.push(extension);
        self.existing(self.name.with_file_name(name))
    }

    /// Returns the path of a sidecar file with this file's name and another extension, if it
    /// exists.
    pub(crate) fn in_place(&self, extension: &str) -> Option<PathBuf> {
        self.existing(self.name.with_extension(extension)).filter(|path| path != self.name)
    }

    /// Returns a path in the same place, if a file is there.
    fn existing(&self, path: PathBuf) -> Option<PathBuf> {
        let is_file = self.with_name(&path).is_file().is_ok_and(|is_file| is_file);
        is_file.then_some(path)
    }

    /// Returns the file's folder, empty for the current one. Bytes alone have none.
    pub(crate) fn folder(&self) -> Option<&'a Path> {
        match self.place {
            Place::Bytes(_) => None,
            Place::Disk | Place::Memory(_) => Some(self.name.parent().unwrap_or(Path::new(""))),
        }
    }

    /// Returns whether links may lead from this place to files elsewhere.
    pub(crate) fn has_links(&self) -> bool {
        matches!(self.place, Place::Disk)
    }

    /// Returns all bytes, at least one. `take` gets the length before memory is allocated; bytes in
    /// memory need no allocation.
    pub(crate) fn whole(
        self,
        take: impl FnOnce(u64) -> Result<(), ReadProblem>,
    ) -> Result<Cow<'a, [u8]>, ReadProblem> {
        let (reader, len) = self.open()?;
        let reader = match reader {
            SourceReader::Memory(bytes) => return Ok(Cow::Borrowed(bytes.into_inner())),
            SourceReader::File(reader) => reader,
        };
        take(len)?;
        let mut bytes = Vec::new();
        let capacity = usize::try_from(len).unwrap_or(usize::MAX);
        bytes.try_reserve_exact(capacity).map_err(|_| ReadProblem::OutOfMemory { needed: len })?;
        reader.take(len).read_to_end(&mut bytes)?;
        Ok(Cow::Owned(bytes))
    }

    /// Returns all bytes of another file in the same place, like [`Self::whole`].
    pub(crate) fn whole_of(
        self,
        name: &Path,
        take: impl FnOnce(u64) -> Result<(), ReadProblem>,
    ) -> Result<Cow<'a, [u8]>, ReadProblem> {
        let Place::Memory(files) = self.place else {
            return Ok(Cow::Owned(self.with_name(name).whole(take)?.into_owned()));
        };
        let bytes = files.read(name)?;
        if bytes.is_empty() { Err(ReadProblem::Empty) } else { Ok(Cow::Borrowed(bytes)) }
    }

    /// Creates the error of a problem with this source.
    pub(crate) fn error(self, problem: ReadProblem) -> ReadError {
        ReadError { path: self.name.to_owned(), problem }
    }

    /// Opens the source, and returns its length in bytes, which is not 0.
    pub(crate) fn open(self) -> Result<(SourceReader<'a>, u64), ReadProblem> {
        let (reader, len) = match self.held() {
            Some(held) => {
                let bytes = held.map_err(|error| match error.kind() {
                    io::ErrorKind::IsADirectory => ReadProblem::Folder,
                    _ => ReadProblem::Io(error),
                })?;
                (SourceReader::Memory(Cursor::new(bytes)), bytes.len() as u64)
            }
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

    /// Returns the bytes of a source in memory, or the error that it does not exist; `None` on disk.
    fn held(&self) -> Option<io::Result<&'a [u8]>> {
        match self.place {
            Place::Disk => None,
            Place::Bytes(bytes) => Some(Ok(bytes)),
            Place::Memory(files) => Some(files.read(self.name)),
        }
    }
}

impl<'a, P: AsRef<Path> + ?Sized> From<&'a P> for Source<'a> {
    fn from(path: &'a P) -> Self {
        Self { name: path.as_ref(), place: Place::Disk }
    }
}

impl fmt::Debug for Source<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let len = self.held().and_then(Result::ok).map(<[u8]>::len);
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
