//! Limits and defaults of a picture: size, memory, samples and exposure.

use relief_core::ByteSize;

/// Longest side of a picture in pixels.
pub const MAX_IMAGE_SIDE: u32 = 32_768;

/// Default memory limit for maps and picture.
pub const DEFAULT_MAX_MEMORY: ByteSize = ByteSize(4 << 30);

/// Most samples per pixel.
pub const MAX_SAMPLES: u32 = 1024;

/// Default samples per pixel, enough for smooth edges.
pub const DEFAULT_SAMPLES: u32 = 4;

/// Greatest exposure in stops. The least is its negative.
pub const MAX_EXPOSURE: f32 = 32.0;
