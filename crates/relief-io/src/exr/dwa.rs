//! Check of the counters at the head of a DWA block, before the decompressor allocates memory by
//! them.
//!
//! There are eleven 64-bit counters (OpenEXR, `internal_dwa_compressor.h`): version; sizes of the
//! raw channels, uncompressed and compressed; compressed sizes of the AC, DC and RLE parts; sizes
//! of the RLE part inflated and unpacked; numbers of AC and DC coefficients; and the AC
//! compression.

use exr::prelude::Compression;

use super::part::Part;
use crate::ReadProblem;

/// Coefficients per side of a block of the cosine transform.
const TRANSFORM_SIDE: u64 = 8;

/// Refuses counters greater than texels of this size can need.
pub(super) fn check(part: &Part, [columns, rows]: [u32; 2], compressed: &[u8]) -> Result<(), ReadProblem> {
    if !matches!(part.compression, Compression::DWAA(_) | Compression::DWAB(_)) || compressed.is_empty() {
        return Ok(());
    }
    let bytes = u64::from(columns) * u64::from(rows) * part.bytes_per_texel();
    if compressed.len() as u64 == bytes {
        // Stored uncompressed.
        return Ok(());
    }
    let transforms = u64::from(columns).div_ceil(TRANSFORM_SIDE)
        * u64::from(rows).div_ceil(TRANSFORM_SIDE)
        * part.channels.len() as u64;
    // Run-length tokens are at most twice as long as their expansion.
    let limits = [(1, bytes), (6, 2 * bytes), (7, bytes), (8, transforms * 64), (9, transforms)];
    let (counters, _) = compressed.as_chunks::<8>();
    let within = |&(index, limit): &(usize, u64)| {
        counters.get(index).is_some_and(|&counter| u64::from_le_bytes(counter) <= limit)
    };
    if limits.iter().all(within) {
        Ok(())
    } else {
        Err(ReadProblem::damaged("EXR", "a DWA block claims more than its texels need"))
    }
}
