//! Opened source before its header is read, and tools for all decoders.

use std::io;

use relief_core::HeightMap;

use crate::layout::Format;
use crate::source::SourceReader;
use crate::{ReadProblem, Source};

/// Opened source with its length and the limits of memory.
pub(crate) struct Input<'a> {
    pub source: Source<'a>,
    pub file: SourceReader<'a>,
    pub file_len: u64,
    pub bytes_per_texel: u64,
    pub max_bytes: u64,
}

impl<'a> Input<'a> {
    /// Opens a source. The caller will hold `bytes_per_texel` for each texel, and at most
    /// `max_bytes` in all.
    pub(crate) fn open(
        source: Source<'a>,
        bytes_per_texel: u64,
        max_bytes: u64,
    ) -> Result<Self, ReadProblem> {
        let (file, file_len) = source.open()?;
        Ok(Self { source, file, file_len, bytes_per_texel, max_bytes })
    }

    /// Refuses sizes that are invalid for a height map, need too much memory, or do not fit into a
    /// file of this length.
    ///
    /// `decoder_bytes` is the decoder's own peak memory, and `least_file_bytes` the length of the
    /// shortest file that can hold such a picture.
    pub(crate) fn check_size(
        &self,
        format: Format,
        [width, height]: [u32; 2],
        decoder_bytes: u64,
        least_file_bytes: u64,
    ) -> Result<(), ReadProblem> {
        HeightMap::check_size(width, height)?;
        let texels = u64::from(width) * u64::from(height);
        let needed = (texels * self.bytes_per_texel).saturating_add(decoder_bytes);
        if needed > self.max_bytes {
            return Err(ReadProblem::TooMuchMemory { width, height, needed, limit: self.max_bytes });
        }
        if least_file_bytes > self.file_len {
            let what = format!(
                "{width}x{height} texels need at least {least_file_bytes} bytes, but the file has {}",
                self.file_len
            );
            return Err(ReadProblem::damaged(format.name(), what));
        }
        Ok(())
    }
}

/// Allocates `len` zeros. Returns an error, instead of aborting, if the system has no memory for
/// it.
pub(crate) fn zeros<T: Clone + Default>(len: usize) -> Result<Vec<T>, ReadProblem> {
    let mut values = Vec::new();
    let needed = (len as u64).saturating_mul(size_of::<T>() as u64);
    values.try_reserve_exact(len).map_err(|_| ReadProblem::OutOfMemory { needed })?;
    values.resize(len, T::default());
    Ok(values)
}

/// Converts an error of reading: reading past the end means a cut-off file; other errors are the
/// system's.
pub(crate) fn io_problem(format: Format, error: io::Error) -> ReadProblem {
    match error.kind() {
        io::ErrorKind::UnexpectedEof => ReadProblem::damaged(format.name(), "it ends too early"),
        io::ErrorKind::InvalidData | io::ErrorKind::InvalidInput => {
            ReadProblem::damaged(format.name(), error)
        }
        _ => ReadProblem::Io(error),
    }
}
