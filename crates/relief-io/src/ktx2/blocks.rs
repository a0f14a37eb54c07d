//! Compression of rows of 4x4 blocks: BC4, BC5 and BC7 ("Khronos Data Format Specification",
//! chapters 20 and 21).

use block_compression::decode::decompress_blocks_as_rgba8;
use block_compression::encode::compress_rgba8;
use block_compression::{BC7Settings, CompressionVariant};

use super::TexelFormat;
use super::format::Sample;

/// Variant of the `block_compression` crate for a format.
fn variant(format: TexelFormat) -> CompressionVariant {
    match format {
        TexelFormat::Bc4 => CompressionVariant::BC4,
        TexelFormat::Bc5 => CompressionVariant::BC5,
        _ => CompressionVariant::BC7(BC7Settings::alpha_basic()),
    }
}

/// Compresses a row of blocks. `texels` holds four rows of each channel, row after row, channel
/// after channel. Texels beyond the width repeat the last column.
pub(super) fn compress_row(format: TexelFormat, width: usize, texels: &[f32], bytes: &mut [u8]) {
    let padded = width.div_ceil(4) * 4;
    let mut rgba = vec![255; padded * 4 * 4];
    for (channel, rows) in texels.chunks_exact(4 * width).enumerate() {
        for (row, line) in rows.chunks_exact(width).zip(rgba.chunks_exact_mut(padded * 4)) {
            for (column, texel) in line.chunks_exact_mut(4).enumerate() {
                Sample::Unorm8.encode(row[column.min(width - 1)], &mut texel[channel..=channel]);
            }
        }
    }
    compress_rgba8(variant(format), &rgba, bytes, padded as u32, 4, padded as u32 * 4);
}

/// Decompresses a row of blocks into `texels`, laid out as for [`compress_row`].
pub(super) fn decompress_row(format: TexelFormat, width: usize, bytes: &[u8], texels: &mut [f32]) {
    match format {
        TexelFormat::Bc4 | TexelFormat::Bc5 => {
            let channels = format.channels();
            for (at, block) in bytes.as_chunks::<8>().0.iter().enumerate() {
                let (left, channel) = (at / channels * 4, at % channels);
                let rows = &mut texels[channel * 4 * width..][..4 * width];
                for (place, value) in decode_bc4(block).into_iter().enumerate() {
                    if let Some(texel) = rows
                        .chunks_exact_mut(width)
                        .nth(place / 4)
                        .and_then(|row| row.get_mut(left + place % 4))
                    {
                        *texel = value;
                    }
                }
            }
        }
        _ => {
            let padded = width.div_ceil(4) * 4;
            let mut rgba = vec![0; padded * 4 * 4];
            decompress_blocks_as_rgba8(variant(format), padded as u32, 4, bytes, &mut rgba);
            for (channel, rows) in texels.chunks_exact_mut(4 * width).enumerate() {
                for (row, line) in rows.chunks_exact_mut(width).zip(rgba.chunks_exact(padded * 4)) {
                    for (texel, rgba) in row.iter_mut().zip(line.as_chunks::<4>().0) {
                        *texel = f32::from(rgba[channel]) / 255.0;
                    }
                }
            }
        }
    }
}

/// Decodes the 16 values of a BC4 block, row by row. Hardware interpolates between the two ends
/// with more than 8 bits; decoders to bytes lose them.
fn decode_bc4(block: &[u8; 8]) -> [f32; 16] {
    let [low, high] = [block[0], block[1]].map(|end| f32::from(end) / 255.0);
    // If the first end is not the greater one, two of the steps are 0 and 1.
    let steps = if block[0] > block[1] { 7 } else { 5 };
    let value = |index: u64| match index {
        0 => low,
        1 => high,
        6 if steps == 5 => 0.0,
        7 if steps == 5 => 1.0,
        index => {
            let part = (index - 1) as f32 / steps as f32;
            low + part * (high - low)
        }
    };
    let indices = block[2..].iter().rev().fold(0, |bits, &byte| (bits << 8) | u64::from(byte));
    std::array::from_fn(|place| value((indices >> (3 * place)) & 7))
}
