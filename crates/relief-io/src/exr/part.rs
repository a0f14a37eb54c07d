//! Part of an EXR file, as its header describes it: the layout and sizes of its blocks.

use exr::meta::BlockDescription;
use exr::meta::attribute::{LevelMode, TileDescription};
use exr::prelude::{ChannelDescription, Compression, SampleType as ExrSample, Text, Vec2};

use crate::omissions::{DISPLAY_WINDOW, Remark};

/// Flat part of a file.
pub(super) struct Part {
    pub name: Option<String>,
    pub channels: Vec<ExrChannel>,
    pub compression: Compression,
    pub size: [u32; 2],
    /// Data window: left, top, right and bottom, inclusive.
    pub data_window: [i64; 4],
    /// Display window, which viewers show, in the same form.
    pub display_window: Option<[i64; 4]>,
    /// Width and height of a tile, clipped to the size of the picture.
    pub tiles: Option<[u32; 2]>,
    /// Number of entries in the offset table, resolution levels included.
    pub table_len: u64,
}

/// Channel of a part.
pub(super) struct ExrChannel {
    pub name: String,
    pub sample: ExrSample,
    pub quantize_linearly: bool,
}

impl ExrChannel {
    pub(super) fn description(&self) -> ChannelDescription {
        // A name read byte by byte always converts. Only DWA looks at it, to tell colours from
        // other channels.
        let name = Text::new_or_none(&self.name).unwrap_or_else(|| Text::from("?"));
        ChannelDescription::new(name, self.sample, self.quantize_linearly)
    }
}

impl Part {
    /// Note for the user, if the display window differs from the data window.
    pub(super) fn remark(&self) -> Option<Remark> {
        let text = |[left, top, right, bottom]: [i64; 4]| {
            format!("{}x{} from {left}, {top}", right - left + 1, bottom - top + 1)
        };
        let display = self.display_window.filter(|window| *window != self.data_window)?;
        let text = format!(
            "its display window ({}) differs from its data window ({}): the data window is read",
            text(display),
            text(self.data_window)
        );
        Some(Remark::new(&DISPLAY_WINDOW, text))
    }

    /// Name of a channel in the whole file: prefixed with the part's name if it has one.
    pub(super) fn full_name(&self, channel: &str) -> String {
        match &self.name {
            Some(part) => format!("{part}.{channel}"),
            None => channel.to_owned(),
        }
    }

    pub(super) fn bytes_per_texel(&self) -> u64 {
        self.channels.iter().map(|channel| channel.sample.bytes_per_sample() as u64).sum()
    }

    pub(super) fn rows_per_block(&self) -> u64 {
        match self.tiles {
            Some([_, rows]) => u64::from(rows),
            None => self.compression.scan_lines_per_block() as u64,
        }
    }

    /// Bytes of the largest block.
    pub(super) fn block_bytes(&self) -> u64 {
        let columns = self.tiles.map_or(self.size[0], |[columns, _]| columns);
        self.rows_per_block().min(u64::from(self.size[1])) * u64::from(columns) * self.bytes_per_texel()
    }

    /// Number of blocks along x and y.
    pub(super) fn blocks(&self) -> (u64, u64) {
        let columns = u64::from(self.tiles.map_or(self.size[0], |[columns, _]| columns));
        (u64::from(self.size[0]).div_ceil(columns), u64::from(self.size[1]).div_ceil(self.rows_per_block()))
    }

    /// Number of blocks in the first resolution level.
    pub(super) fn chunks(&self) -> u64 {
        self.blocks().0 * self.blocks().1
    }

    /// Least number of bytes to which `bytes` bytes of texels can be compressed.
    pub(super) fn least_bytes(&self, bytes: u64) -> u64 {
        match self.compression {
            Compression::Uncompressed => bytes,
            // Two bytes stand for at most 128.
            Compression::RLE => bytes / 64,
            // Deflate turns one byte into at most 1032.
            Compression::ZIP1 | Compression::ZIP16 => bytes / 1032,
            // Deflate, after one of four bytes of each float was dropped.
            Compression::PXR24 => bytes / 1376,
            // Three bytes stand for 32.
            Compression::B44 | Compression::B44A => bytes / 11,
            // The others compress constant blocks to almost nothing.
            _ => 0,
        }
    }

    /// Bytes of all texels.
    pub(super) fn bytes(&self) -> u64 {
        u64::from(self.size[0]) * u64::from(self.size[1]) * self.bytes_per_texel()
    }

    /// Rectangle of a block: left and top, width and height.
    pub(super) fn block_rectangle(&self, [x, y]: [u64; 2]) -> [[u32; 2]; 2] {
        let columns = u64::from(self.tiles.map_or(self.size[0], |[columns, _]| columns));
        let (left, top) = (x * columns, y * self.rows_per_block());
        let width = columns.min(u64::from(self.size[0]) - left);
        let height = self.rows_per_block().min(u64::from(self.size[1]) - top);
        [[left as u32, top as u32], [width as u32, height as u32]]
    }

    pub(super) fn block_description(&self) -> BlockDescription {
        match self.tiles {
            Some([columns, rows]) => BlockDescription::Tiles(TileDescription {
                tile_size: Vec2(columns as usize, rows as usize),
                level_mode: LevelMode::Singular,
                rounding_mode: exr::math::RoundingMode::Down,
            }),
            None => BlockDescription::ScanLines,
        }
    }
}
