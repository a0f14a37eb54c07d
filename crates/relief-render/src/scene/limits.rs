//! What a picture may take.

use relief_core::ByteSize;

/// The longest side of a picture in pixels.
pub const MAX_IMAGE_SIDE: u32 = 32_768;

/// The memory that maps and picture may take when nothing else is said.
pub const DEFAULT_MAX_MEMORY: ByteSize = ByteSize(4 << 30);
