//! What the decoder reads from. It wants to own that, which an opened file allows and bytes of the caller's
//! do not: of those it is lent copies of the ranges that it asks for, one block or less at a time, and then
//! asks again.

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

/// The most bytes of a header.
const HEADER_BYTES: u64 = 16;

/// A file or bytes, as the decoder sees them.
pub(super) enum Stored<'a> {
    File(Arc<StoredFile>),
    Memory(&'a [u8], Arc<Lent>),
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
                Arc::new(Lent { len: input.file_len, ranges: Mutex::default() }),
            ),
        })
    }

    /// The headers of all pictures.
    pub(super) fn pictures(&self, budgets: ParseBudgets) -> Result<Vec<Ifd>, TiffError> {
        let parse = |source: &dyn TiffSource| {
            let header = source.read_exact_at(0, source.len().min(HEADER_BYTES) as usize)?;
            parse_ifd_chain_with_budgets(source, &TiffHeader::parse(&header)?, budgets)
        };
        match self {
            Self::File(file) => parse(file.as_ref()),
            Self::Memory(bytes, lent) => parse(&Lending { bytes, lent }),
        }
    }

    /// A decoder, which reads the same headers once more.
    pub(super) fn decoder(&self, options: OpenOptions) -> Result<tiff_reader::TiffFile, TiffError> {
        self.lending(|| {
            let source: Arc<dyn TiffSource> = match self {
                Self::File(file) => file.clone(),
                Self::Memory(_, lent) => lent.clone(),
            };
            tiff_reader::TiffFile::from_source_with_options(source, options)
        })
    }

    /// Does something with the decoder, again and again until it has been lent all that it asks for.
    pub(super) fn lending<T>(&self, action: impl Fn() -> Result<T, TiffError>) -> Result<T, TiffError> {
        let Self::Memory(bytes, lent) = self else { return action() };
        loop {
            lent.copy(bytes);
            let result = action();
            let mut ranges = lent.ranges();
            if !std::mem::take(&mut ranges.missing) {
                ranges.by_place.clear();
                return result;
            }
        }
    }
}

/// An opened file.
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

/// Ranges of bytes that the caller keeps.
pub(super) struct Lent {
    len: u64,
    ranges: Mutex<LentRanges>,
}

#[derive(Default)]
struct LentRanges {
    /// By offset and length.
    by_place: HashMap<(usize, usize), LentRange>,
    /// Whether one was asked for in vain.
    missing: bool,
}

#[derive(Default)]
struct LentRange {
    /// How often it is asked for.
    asked: usize,
    /// A copy for each time, given away once, so that there is no second one of a block that the decoder
    /// holds.
    copies: Vec<Vec<u8>>,
}

impl Lent {
    /// Copies the ranges that have been asked for.
    fn copy(&self, bytes: &[u8]) {
        for (&(start, len), range) in &mut self.ranges().by_place {
            range.copies.resize_with(range.asked, || bytes[start..][..len].to_vec());
        }
    }

    fn ranges(&self) -> MutexGuard<'_, LentRanges> {
        self.ranges.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl TiffSource for Lent {
    fn len(&self) -> u64 {
        self.len
    }

    fn read_exact_at(&self, offset: u64, len: usize) -> Result<Vec<u8>, TiffError> {
        check(offset, len, self.len)?;
        let mut ranges = self.ranges();
        let range = ranges.by_place.entry((offset as usize, len)).or_default();
        if let Some(bytes) = range.copies.pop() {
            return Ok(bytes);
        }
        range.asked += 1;
        ranges.missing = true;
        Err(TiffError::Other("bytes that have not been lent yet".into()))
    }
}

/// The bytes themselves while they are at hand. What is read of them is asked for.
struct Lending<'a> {
    bytes: &'a [u8],
    lent: &'a Lent,
}

impl TiffSource for Lending<'_> {
    fn len(&self) -> u64 {
        self.lent.len
    }

    fn read_exact_at(&self, offset: u64, len: usize) -> Result<Vec<u8>, TiffError> {
        check(offset, len, self.lent.len)?;
        let start = offset as usize;
        self.lent.ranges().by_place.entry((start, len)).or_default().asked += 1;
        Ok(self.bytes[start..][..len].to_vec())
    }
}

/// Refuses a range that does not lie in a source of that length.
fn check(offset: u64, len: usize, source_len: u64) -> Result<(), TiffError> {
    let length = len as u64;
    if offset.checked_add(length).is_some_and(|end| end <= source_len) {
        Ok(())
    } else {
        Err(TiffError::OffsetOutOfBounds { offset, length, data_len: source_len })
    }
}
