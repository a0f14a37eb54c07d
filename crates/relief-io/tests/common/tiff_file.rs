//! TIFF files put together by hand: any tags, strips or tiles, either byte order.

use super::files::zlib;

/// The value of a tag.
#[derive(Clone, Debug)]
pub enum Value {
    Short(Vec<u16>),
    Long(Vec<u32>),
    Double(Vec<f64>),
    Text(String),
}

/// A TIFF to be written.
#[derive(Clone, Debug)]
pub struct Tiff {
    pub width: u32,
    pub height: u32,
    pub bands: u16,
    pub bits: u16,
    /// 1 unsigned, 2 signed, 3 float.
    pub format: u16,
    pub photometric: u16,
    pub planar: u16,
    pub deflate: bool,
    /// Whether floats are stored as differences of their bytes (Adobe's third predictor); of one band.
    pub float_predictor: bool,
    pub big_endian: bool,
    /// Rows a strip; or, with `tile_width`, rows a tile.
    pub block_rows: u32,
    pub tile_width: Option<u32>,
    /// Blocks that are left out, as in sparse files.
    pub sparse: Vec<usize>,
    pub extra: Vec<(u16, Value)>,
}

impl Tiff {
    /// One band in strips of 16 rows.
    pub fn grey(width: u32, height: u32, bits: u16, format: u16) -> Self {
        Self {
            width,
            height,
            bands: 1,
            bits,
            format,
            photometric: 1,
            planar: 1,
            deflate: false,
            float_predictor: false,
            big_endian: false,
            block_rows: 16,
            tile_width: None,
            sparse: Vec::new(),
            extra: Vec::new(),
        }
    }

    /// The file for samples, the bands of a texel side by side.
    pub fn bytes(&self, samples: &[f64]) -> Vec<u8> {
        self.bytes_before(samples, &[])
    }

    /// The file for samples with more pictures behind it, each with its samples.
    pub fn bytes_before(&self, samples: &[f64], more: &[(Tiff, Vec<f64>)]) -> Vec<u8> {
        let mut file = if self.big_endian { b"MM\0*".to_vec() } else { b"II*\0".to_vec() };
        file.extend(self.long(0));
        let mut link = self.append(&mut file, samples, 4);
        for (tiff, samples) in more {
            link = tiff.append(&mut file, samples, link);
        }
        file
    }

    /// Appends a picture that the link at a place leads to, and gives the place of the next link.
    fn append(&self, file: &mut Vec<u8>, samples: &[f64], link: usize) -> usize {
        let blocks = self.blocks(samples);
        let (mut offsets, mut counts) = (Vec::new(), Vec::new());
        for (index, block) in blocks.iter().enumerate() {
            if self.sparse.contains(&index) {
                offsets.push(0);
                counts.push(0);
            } else {
                offsets.push(file.len() as u32);
                counts.push(block.len() as u32);
                file.extend(block);
            }
        }
        let mut tags = vec![
            (256, Value::Long(vec![self.width])),
            (257, Value::Long(vec![self.height])),
            (258, Value::Short(vec![self.bits; usize::from(self.bands)])),
            (259, Value::Short(vec![if self.deflate { 8 } else { 1 }])),
            (262, Value::Short(vec![self.photometric])),
            (277, Value::Short(vec![self.bands])),
            (284, Value::Short(vec![self.planar])),
            (339, Value::Short(vec![self.format; usize::from(self.bands)])),
        ];
        if self.float_predictor {
            tags.push((317, Value::Short(vec![3])));
        }
        match self.tile_width {
            Some(tile_width) => tags.extend([
                (322, Value::Long(vec![tile_width])),
                (323, Value::Long(vec![self.block_rows])),
                (324, Value::Long(offsets)),
                (325, Value::Long(counts)),
            ]),
            None => tags.extend([
                (273, Value::Long(offsets)),
                (278, Value::Long(vec![self.block_rows])),
                (279, Value::Long(counts)),
            ]),
        }
        tags.extend(self.extra.iter().cloned());
        tags.sort_by_key(|(tag, _)| *tag);
        self.directory(file, &tags, link)
    }

    fn directory(&self, file: &mut Vec<u8>, tags: &[(u16, Value)], link: usize) -> usize {
        let mut entries = Vec::new();
        for (tag, value) in tags {
            let (kind, count, bytes) = match value {
                Value::Short(v) => (3, v.len(), v.iter().flat_map(|&v| self.short(v)).collect::<Vec<u8>>()),
                Value::Long(v) => (4, v.len(), v.iter().flat_map(|&v| self.long(v)).collect()),
                Value::Double(v) => (12, v.len(), v.iter().flat_map(|&v| self.number(v, 64, 3)).collect()),
                Value::Text(text) => (2, text.len() + 1, [text.as_bytes(), b"\0"].concat()),
            };
            entries.extend(self.short(*tag));
            entries.extend(self.short(kind));
            entries.extend(self.long(count as u32));
            if bytes.len() <= 4 {
                entries.extend(bytes.iter().copied().chain([0; 4]).take(4));
            } else {
                entries.extend(self.long(file.len() as u32));
                file.extend(bytes);
            }
        }
        let start = self.long(file.len() as u32);
        file[link..link + 4].copy_from_slice(&start);
        file.extend(self.short(tags.len() as u16));
        file.extend(entries);
        file.extend(self.long(0));
        file.len() - 4
    }

    fn blocks(&self, samples: &[f64]) -> Vec<Vec<u8>> {
        let bands = usize::from(self.bands);
        let planes: Vec<Vec<usize>> = if self.planar == 2 {
            (0..bands).map(|band| vec![band]).collect()
        } else {
            vec![(0..bands).collect()]
        };
        let columns = self.tile_width.unwrap_or(self.width);
        let mut blocks = Vec::new();
        for plane in &planes {
            for top in (0..self.height).step_by(self.block_rows as usize) {
                for left in (0..self.width).step_by(columns as usize) {
                    // Tiles are whole, strips end with the picture.
                    let rows = if self.tile_width.is_some() {
                        self.block_rows
                    } else {
                        self.block_rows.min(self.height - top)
                    };
                    let mut bytes = Vec::new();
                    for j in top..top + rows {
                        if self.bits < 8 {
                            bytes.extend(self.packed_row(samples, j.min(self.height - 1), [left, columns]));
                            continue;
                        }
                        let start = bytes.len();
                        for i in left..left + columns {
                            let at = (j.min(self.height - 1) * self.width + i.min(self.width - 1)) as usize;
                            for band in plane {
                                bytes.extend(self.number(samples[at * bands + band], self.bits, self.format));
                            }
                        }
                        if self.float_predictor {
                            let row = self.predicted(&bytes[start..]);
                            bytes.splice(start.., row);
                        }
                    }
                    blocks.push(if self.deflate { zlib(&bytes) } else { bytes });
                }
            }
        }
        blocks
    }

    /// A row of floats as differences: the highest bytes of all come first, and each byte less the one
    /// before.
    fn predicted(&self, row: &[u8]) -> Vec<u8> {
        let size = usize::from(self.bits / 8);
        let byte = |of: usize| move |sample: &[u8]| sample[if self.big_endian { of } else { size - 1 - of }];
        let planes: Vec<u8> = (0..size).flat_map(|of| row.chunks_exact(size).map(byte(of))).collect();
        let before = std::iter::once(&0).chain(&planes);
        planes.iter().zip(before).map(|(byte, before)| byte.wrapping_sub(*before)).collect()
    }

    /// A row of samples of less than a byte, the first one highest.
    fn packed_row(&self, samples: &[f64], row: u32, [left, columns]: [u32; 2]) -> Vec<u8> {
        let bits = u32::from(self.bits);
        let mut bytes = vec![0; (columns * bits).div_ceil(8) as usize];
        for column in 0..columns {
            let at = row * self.width + (left + column).min(self.width - 1);
            // Any number but 0 is a single bit.
            let sample = samples[at as usize] as u8;
            let sample = if bits == 1 { sample.min(1) } else { sample };
            let first = column * bits;
            bytes[(first / 8) as usize] |= sample << (8 - bits - first % 8);
        }
        bytes
    }

    fn short(&self, value: u16) -> Vec<u8> {
        self.number(f64::from(value), 16, 1)
    }

    fn long(&self, value: u32) -> Vec<u8> {
        self.number(f64::from(value), 32, 1)
    }

    fn number(&self, value: f64, bits: u16, format: u16) -> Vec<u8> {
        let mut bytes = match (format, bits) {
            (1, 8) => vec![value as u8],
            (1, 16) => (value as u16).to_le_bytes().to_vec(),
            (1, 32) => (value as u32).to_le_bytes().to_vec(),
            (1, 64) => (value as u64).to_le_bytes().to_vec(),
            (2, 8) => (value as i8).to_le_bytes().to_vec(),
            (2, 16) => (value as i16).to_le_bytes().to_vec(),
            (2, 32) => (value as i32).to_le_bytes().to_vec(),
            (2, 64) => (value as i64).to_le_bytes().to_vec(),
            (3, 16) => exr::prelude::f16::from_f64(value).to_le_bytes().to_vec(),
            (3, 32) => (value as f32).to_le_bytes().to_vec(),
            (3, 64) => value.to_le_bytes().to_vec(),
            other => panic!("no samples of format and bits {other:?}"),
        };
        if self.big_endian {
            bytes.reverse();
        }
        bytes
    }
}
