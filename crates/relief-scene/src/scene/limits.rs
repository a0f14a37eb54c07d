//! What a picture may take.

use relief_core::ByteSize;

/// The longest side of a picture in pixels.
pub const MAX_IMAGE_SIDE: u32 = 32_768;

/// The memory that maps and picture may take when nothing else is said.
pub const DEFAULT_MAX_MEMORY: ByteSize = ByteSize(4 << 30);

/// The most samples of a pixel.
pub const MAX_SAMPLES: u32 = 1024;

/// The samples of a pixel when nothing else is said: enough for edges without steps.
pub const DEFAULT_SAMPLES: u32 = 4;

/// The most stops by which a picture is made brighter or darker.
pub const MAX_EXPOSURE: f32 = 32.0;
