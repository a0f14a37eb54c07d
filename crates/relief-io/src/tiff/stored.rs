//! Sources of the TIFF decoder. It must own its source, which is possible for an opened file, but
//! not for the caller's bytes. The decoder gets copies of the ranges of bytes that it requests, one
//! block or less at a time, and then repeats the request.

use std::collections::HashMap;
use std::fs::File;
use std::io::{Read, Seek, SeekFrom};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use tiff_reader::header::TiffHeader;
use tiff_reader::ifd::parse_ifd_chain_with_budgets;
use tiff_reader::source::TiffSource;
use tiff_reader::{Ifd, OpenOptions, ParseBudgets, TiffError};

use crate::ReadProblem;
use crate::input::Input;
use crate::source::SourceReader;

/// Greatest number of bytes of a header.
const HEADER_BYTES: u64 = 16;

/// File or bytes, as the decoder sees them.
pub(super) enum Stored<'a> {
    File(Arc<StoredFile>),
    Memory(&'a [u8], Arc<CopiedRanges>),
}

impl<'a> Stored<'a> {
    pub(super) fn of(input: &Input<'a>) -> Result<Self, ReadProblem> {
        Ok(match &input.file {
            SourceReader::File(file) => {
                let file = Mutex::new(file.get_ref().try_clone()?);
                Self::File(Arc::new(StoredFile { file, len: input.file_len }))
            }
            SourceReader::Memory(bytes) => Self::Memory(
                bytes.get_ref(),
                Arc::new(CopiedRanges { len: input.file_len, ranges: Mutex::default() }),
            ),
        })
    }

    /// Reads the headers of all pictures.
    pub(super) fn pictures(&self, budgets: ParseBudgets) -> Result<Vec<Ifd>, TiffError> {
        let parse = |source: &dyn TiffSource| {
            let header = source.read_exact_at(0, source.len().min(HEADER_BYTES) as usize)?;
            parse_ifd_chain_with_budgets(source, &TiffHeader::parse(&header)?, budgets)
        };
        match self {
            Self::File(file) => parse(file.as_ref()),
            Self::Memory(bytes, copied) => parse(&Recording { bytes, copied }),
        }
    }

    /// Creates a decoder, which reads the same headers again.
    pub(super) fn decoder(&self, options: OpenOptions) -> Result<tiff_reader::TiffFile, TiffError> {
        self.with_ranges(|| {
            let source: Arc<dyn TiffSource> = match self {
                Self::File(file) => file.clone(),
                Self::Memory(_, copied) => copied.clone(),
            };
            tiff_reader::TiffFile::from_source_with_options(source, options)
        })
    }

    /// Runs an action with the decoder, and repeats it until all requested ranges have been copied.
    pub(super) fn with_ranges<T>(&self, action: impl Fn() -> Result<T, TiffError>) -> Result<T, TiffError> {
        let Self::Memory(bytes, copied) = self else { return action() };
        loop {
            copied.copy(bytes);
            let result = action();
            let mut ranges = copied.ranges();
            if !std::mem::take(&mut ranges.missing) {
                ranges.by_range.clear();
                return result;
            }
        }
    }
}

/// Opened file.
pub(super) struct StoredFile {
    file: Mutex<File>,
    len: u64,
}

impl TiffSource for StoredFile {
    fn len(&self) -> u64 {
        self.len
    }

    fn read_exact_at(&self, offset: u64, len: usize) -> Result<Vec<u8>, TiffError> {
        check(offset, len, self.len)?;
        let mut bytes = vec![0; len];
        let mut file = self.file.lock().unwrap_or_else(PoisonError::into_inner);
        file.seek(SeekFrom::Start(offset))
            .and_then(|_| file.read_exact(&mut bytes))
            .map_err(|error| TiffError::Io(error, String::new()))?;
        Ok(bytes)
    }
}

/// Copied ranges of the caller's bytes.
pub(super) struct CopiedRanges {
    len: u64,
    ranges: Mutex<Ranges>,
}

#[derive(Default)]
struct Ranges {
    /// Ranges by offset and length.
    by_range: HashMap<(usize, usize), RangeCopies>,
    /// Whether a requested range was missing.
    missing: bool,
}

#[derive(Default)]
struct RangeCopies {
    /// Number of requests.
    asked: usize,
    /// One copy for each request, which is moved out. There is no second copy of a block that the
    /// decoder holds.
    copies: Vec<Vec<u8>>,
}

impl CopiedRanges {
    /// Copies the requested ranges.
    fn copy(&self, bytes: &[u8]) {
        for (&(start, len), range) in &mut self.ranges().by_range {
            range.copies.resize_with(range.asked, || bytes[start..][..len].to_vec());
        }
    }

    fn ranges(&self) -> MutexGuard<'_, Ranges> {
        self.ranges.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl TiffSource for CopiedRanges {
    fn len(&self) -> u64 {
        self.len
    }

    fn read_exact_at(&self, offset: u64, len: usize) -> Result<Vec<u8>, TiffError> {
        check(offset, len, self.len)?;
        let mut ranges = self.ranges();
        let range = ranges.by_range.entry((offset as usize, len)).or_default();
        if let Some(bytes) = range.copies.pop() {
            return Ok(bytes);
        }
        range.asked += 1;
        ranges.missing = true;
        Err(TiffError::Other("bytes that have not been copied yet".into()))
    }
}

/// Direct access to the bytes, which records the ranges that are read.
struct Recording<'a> {
    bytes: &'a [u8],
    copied: &'a CopiedRanges,
}

impl TiffSource for Recording<'_> {
    fn len(&self) -> u64 {
        self.copied.len
    }

    fn read_exact_at(&self, offset: u64, len: usize) -> Result<Vec<u8>, TiffError> {
        check(offset, len, self.copied.len)?;
        let start = offset as usize;
        self.copied.ranges().by_range.entry((start, len)).or_default().asked += 1;
        Ok(self.bytes[start..][..len].to_vec())
    }
}

/// Refuses a range outside a source of length `source_len`.
fn check(offset: u64, len: usize, source_len: u64) -> Result<(), TiffError> {
    let length = len as u64;
    if offset.checked_add(length).is_some_and(|end| end <= source_len) {
        Ok(())
    } else {
        Err(TiffError::OffsetOutOfBounds { offset, length, data_len: source_len })
    }
}
