//! Writer of DDS textures of floats, which Godot and others read without an import.

use std::io::Write;
use std::path::Path;

use super::{Row, RowSource};
use crate::write_whole::write_file;
use crate::{WriteError, WriteProblem};

/// `DXGI_FORMAT` of 32-bit floats, by the number of channels: `R32`, `R32G32` and `R32G32B32A32`.
const FORMATS: [(usize, u32); 3] = [(1, 41), (2, 16), (4, 2)];

/// Flags of the head: which of its numbers count.
const HAS_SIZE_AND_PITCH: u32 = 0x1 | 0x2 | 0x4 | 0x8 | 0x1000;

/// Flag of the pixel format: a second head says which.
const IN_SECOND_HEAD: u32 = 0x4;

/// Flag of all textures.
const IS_TEXTURE: u32 = 0x1000;

/// Dimension of a plain picture in the second head.
const IS_2D: u32 = 3;

/// Writes a texture of 32-bit floats of 1 to 4 channels, without mip levels. Three channels are
/// stored as four, with 0 in the last. Rows are requested from the top, channel by channel.
///
/// # Errors
///
/// When there are no texels, or more than 2^20 on a side, or no channels or more than four; when `rows`
/// fails; or when the file cannot be written. Nothing is left behind then.
pub fn write_dds(
    path: &Path,
    [width, height]: [u32; 2],
    channels: usize,
    rows: &mut RowSource<'_>,
) -> Result<(), WriteError> {
    let most = relief_core::MAX_SIDE;
    let is_stored = |side: u32| (1..=most).contains(&side);
    let format = FORMATS.into_iter().find(|(stored, _)| channels >= 1 && *stored >= channels);
    let (Some((stored, format)), true) = (format, is_stored(width) && is_stored(height)) else {
        let what = format!(
            "a texture has 1 to {most} texels a side and 1 to 4 channels, not {width}x{height} and {channels}"
        );
        return Err(WriteProblem::NotStorable(what).at(path));
    };
    write_file(path, |out| {
        let line_bytes = width * 4 * stored as u32;
        let mut head = vec![124, HAS_SIZE_AND_PITCH, height, width, line_bytes, 0, 1];
        head.extend([0; 11]);
        head.extend([32, IN_SECOND_HEAD, u32::from_le_bytes(*b"DX10"), 0, 0, 0, 0, 0]);
        head.extend([IS_TEXTURE, 0, 0, 0, 0]);
        head.extend([format, IS_2D, 0, 1, 0]);
        out.write_all(b"DDS ")?;
        out.write_all(&head.into_iter().flat_map(u32::to_le_bytes).collect::<Vec<u8>>())?;
        let mut line = vec![0.0_f32; width as usize * stored];
        let mut texels = vec![0.0_f32; width as usize];
        for row in 0..height {
            for channel in 0..channels {
                rows(Row { level: 0, slice: 0, channel, row }, &mut texels)?;
                for (at, texel) in texels.iter().enumerate() {
                    line[at * stored + channel] = *texel;
                }
            }
            out.write_all(&line.iter().flat_map(|value| value.to_le_bytes()).collect::<Vec<u8>>())?;
        }
        Ok(())
    })
}

#[cfg(test)]
mod tests {
    use std::error::Error;

    use super::*;

    #[test]
    fn texels_follow_the_heads_row_by_row() -> Result<(), Box<dyn Error>> {
        let folder = tempfile::tempdir()?;
        let path = folder.path().join("a.dds");
        let mut rows = |row: Row, texels: &mut [f32]| {
            for (column, texel) in texels.iter_mut().enumerate() {
                *texel = (100 * row.channel as u32 + 10 * row.row) as f32 + column as f32;
            }
            Ok(())
        };
        write_dds(&path, [3, 2], 1, &mut rows)?;
        let bytes = std::fs::read(&path)?;
        let floats = |bytes: &[u8]| -> Vec<f32> {
            bytes[148..].as_chunks().0.iter().map(|of| f32::from_le_bytes(*of)).collect()
        };
        assert_eq!(&bytes[..4], b"DDS ");
        assert_eq!(floats(&bytes), [0.0, 1.0, 2.0, 10.0, 11.0, 12.0]);
        write_dds(&path, [1, 1], 3, &mut rows)?;
        assert_eq!(floats(&std::fs::read(&path)?), [0.0, 100.0, 200.0, 0.0]);
        for (size, channels) in [([0, 1], 1), ([1, 1 << 21], 1), ([1, 1], 0), ([1, 1], 5)] {
            assert!(write_dds(&path, size, channels, &mut rows).is_err());
        }
        Ok(())
    }
}
