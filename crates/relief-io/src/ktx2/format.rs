//! Texel formats that are written and read.

use exr::prelude::f16;
use ktx2::Format;

use crate::texture::unorm_code;

/// Storage format of a texel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TexelFormat {
    /// One 8-bit unsigned normalised integer.
    R8,
    /// Two 8-bit unsigned normalised integers.
    Rg8,
    /// Four 8-bit unsigned normalised integers.
    Rgba8,
    /// One 16-bit unsigned normalised integer.
    R16,
    /// Two 16-bit unsigned normalised integers.
    Rg16,
    /// Four 16-bit unsigned normalised integers.
    Rgba16,
    /// One 16-bit float.
    R16F,
    /// Two 16-bit floats.
    Rg16F,
    /// Four 16-bit floats.
    Rgba16F,
    /// One 32-bit float.
    R32F,
    /// Two 32-bit floats.
    Rg32F,
    /// Four 32-bit floats.
    Rgba32F,
    /// One channel in blocks of 4x4 texels and 8 bytes: between two 8-bit values, 8 steps a block.
    Bc4,
    /// Two channels like BC4, in 16 bytes a block.
    Bc5,
    /// Four channels of about 7 bits in blocks of 4x4 texels and 16 bytes.
    Bc7,
}

/// Storage format of a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sample {
    Unorm8,
    Unorm16,
    Half,
    Float,
    /// In blocks of 4x4 texels.
    Block,
}

impl TexelFormat {
    /// All formats.
    pub const ALL: [TexelFormat; 15] = [
        TexelFormat::R8,
        TexelFormat::Rg8,
        TexelFormat::Rgba8,
        TexelFormat::R16,
        TexelFormat::Rg16,
        TexelFormat::Rgba16,
        TexelFormat::R16F,
        TexelFormat::Rg16F,
        TexelFormat::Rgba16F,
        TexelFormat::R32F,
        TexelFormat::Rg32F,
        TexelFormat::Rgba32F,
        TexelFormat::Bc4,
        TexelFormat::Bc5,
        TexelFormat::Bc7,
    ];

    /// Number of channels.
    pub const fn channels(self) -> usize {
        match self {
            Self::R8 | Self::R16 | Self::R16F | Self::R32F | Self::Bc4 => 1,
            Self::Rg8 | Self::Rg16 | Self::Rg16F | Self::Rg32F | Self::Bc5 => 2,
            Self::Rgba8 | Self::Rgba16 | Self::Rgba16F | Self::Rgba32F | Self::Bc7 => 4,
        }
    }

    /// Whether texels are stored in blocks of 4x4, with loss.
    pub const fn is_block_compressed(self) -> bool {
        matches!(self, Self::Bc4 | Self::Bc5 | Self::Bc7)
    }

    pub(super) const fn sample(self) -> Sample {
        match self {
            Self::R8 | Self::Rg8 | Self::Rgba8 => Sample::Unorm8,
            Self::R16 | Self::Rg16 | Self::Rgba16 => Sample::Unorm16,
            Self::R16F | Self::Rg16F | Self::Rgba16F => Sample::Half,
            Self::R32F | Self::Rg32F | Self::Rgba32F => Sample::Float,
            Self::Bc4 | Self::Bc5 | Self::Bc7 => Sample::Block,
        }
    }

    /// Side of a block in texels: 4, or 1 without blocks.
    pub(super) const fn block_side(self) -> u32 {
        if self.is_block_compressed() { 4 } else { 1 }
    }

    /// Bytes of a block, or of a texel without blocks.
    pub(super) const fn block_bytes(self) -> usize {
        match self {
            Self::Bc4 => 8,
            Self::Bc5 | Self::Bc7 => 16,
            _ => self.channels() * self.sample().bytes(),
        }
    }

    /// Bytes of a row of blocks.
    pub(super) const fn row_bytes(self, width: u32) -> u64 {
        width.div_ceil(self.block_side()) as u64 * self.block_bytes() as u64
    }

    /// Bytes of a level; none if the number exceeds 64 bits.
    pub(super) fn level_bytes(self, [width, height, depth]: [u32; 3]) -> Option<u64> {
        let slice = self.row_bytes(width).checked_mul(u64::from(height.div_ceil(self.block_side())))?;
        slice.checked_mul(u64::from(depth))
    }

    pub(super) const fn vulkan(self) -> Format {
        match self {
            Self::R8 => Format::R8_UNORM,
            Self::Rg8 => Format::R8G8_UNORM,
            Self::Rgba8 => Format::R8G8B8A8_UNORM,
            Self::R16 => Format::R16_UNORM,
            Self::Rg16 => Format::R16G16_UNORM,
            Self::Rgba16 => Format::R16G16B16A16_UNORM,
            Self::R16F => Format::R16_SFLOAT,
            Self::Rg16F => Format::R16G16_SFLOAT,
            Self::Rgba16F => Format::R16G16B16A16_SFLOAT,
            Self::R32F => Format::R32_SFLOAT,
            Self::Rg32F => Format::R32G32_SFLOAT,
            Self::Rgba32F => Format::R32G32B32A32_SFLOAT,
            Self::Bc4 => Format::BC4_UNORM_BLOCK,
            Self::Bc5 => Format::BC5_UNORM_BLOCK,
            Self::Bc7 => Format::BC7_UNORM_BLOCK,
        }
    }

    pub(super) fn of_vulkan(format: Format) -> Option<Self> {
        Self::ALL.into_iter().find(|known| known.vulkan() == format)
    }
}

impl Sample {
    pub(super) const fn bytes(self) -> usize {
        match self {
            Self::Unorm8 | Self::Block => 1,
            Self::Unorm16 | Self::Half => 2,
            Self::Float => 4,
        }
    }

    /// Encodes a value, rounded to the nearest that can be stored.
    pub(super) fn encode(self, value: f32, place: &mut [u8]) {
        match self {
            Self::Unorm8 | Self::Block => place[0] = unorm_code(value, 255) as u8,
            Self::Unorm16 => place.copy_from_slice(&(unorm_code(value, 65535) as u16).to_le_bytes()),
            Self::Half => place.copy_from_slice(&f16::from_f32(value).to_le_bytes()),
            Self::Float => place.copy_from_slice(&value.to_le_bytes()),
        }
    }

    /// Decodes a value as a GPU reads it.
    pub(super) fn decode(self, place: &[u8]) -> f32 {
        match (self, place) {
            (Self::Unorm16, &[a, b]) => f32::from(u16::from_le_bytes([a, b])) / 65535.0,
            (Self::Half, &[a, b]) => f16::from_le_bytes([a, b]).to_f32(),
            (Self::Float, &[a, b, c, d]) => f32::from_le_bytes([a, b, c, d]),
            (_, place) => f32::from(place[0]) / 255.0,
        }
    }
}
