//! Files of the simpler formats, as bytes.

use std::io::Write;

use image::codecs::jpeg::JpegEncoder;
use png::{BitDepth, ColorType, Encoder};

/// A PNG of samples that are stored as they are.
pub fn png(width: u32, height: u32, colour: ColorType, depth: BitDepth, data: &[u8]) -> Vec<u8> {
    png_with(width, height, colour, depth, data, |_| {})
}

/// A PNG whose encoder is set up further.
pub fn png_with(
    width: u32,
    height: u32,
    colour: ColorType,
    depth: BitDepth,
    data: &[u8],
    set: impl FnOnce(&mut Encoder<'_, &mut Vec<u8>>),
) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width, height);
    encoder.set_color(colour);
    encoder.set_depth(depth);
    set(&mut encoder);
    let mut writer = encoder.write_header().expect("a valid header");
    writer.write_image_data(data).expect("as many samples as the header says");
    writer.finish().expect("memory is writable");
    bytes
}

/// Inserts a chunk into a PNG, before the first chunk of kind `before`.
pub fn with_chunk(png: &[u8], kind: &[u8; 4], data: &[u8], before: &[u8; 4]) -> Vec<u8> {
    let at = png.windows(4).position(|bytes| bytes == before).expect("such a chunk") - 4;
    [&png[..at], &png_chunk(kind, data), &png[at..]].concat()
}

/// Inserts EXIF metadata into a JPEG, after its first marker.
pub fn with_exif(jpeg: &[u8], exif: &[u8]) -> Vec<u8> {
    let length = (exif.len() as u16 + 8).to_be_bytes();
    [&jpeg[..2], &[0xff, 0xe1], &length, b"Exif\0\0", exif, &jpeg[2..]].concat()
}

/// EXIF metadata with an orientation, after another entry.
pub fn exif(orientation: u16, big_endian: bool) -> Vec<u8> {
    let short = |value: u16| if big_endian { value.to_be_bytes() } else { value.to_le_bytes() };
    let long = |value: u32| if big_endian { value.to_be_bytes() } else { value.to_le_bytes() };
    let mut bytes = if big_endian { b"MM\0*".to_vec() } else { b"II*\0".to_vec() };
    bytes.extend(long(8));
    bytes.extend(short(2));
    for (tag, value) in [(0x103, 6), (0x112, orientation)] {
        bytes.extend([short(tag), short(3)].concat());
        bytes.extend(long(1));
        bytes.extend([short(value), [0; 2]].concat());
    }
    bytes.extend(long(0));
    bytes
}

/// A chunk of a PNG with its checksum.
fn png_chunk(kind: &[u8; 4], data: &[u8]) -> Vec<u8> {
    let mut checksum = flate2::Crc::new();
    checksum.update(kind);
    checksum.update(data);
    let mut chunk = (data.len() as u32).to_be_bytes().to_vec();
    chunk.extend_from_slice(kind);
    chunk.extend_from_slice(data);
    chunk.extend_from_slice(&checksum.sum().to_be_bytes());
    chunk
}

/// A PNG put together by hand: any header, and rows with their filter bytes, which are compressed.
pub fn png_by_hand(size: [u32; 2], depth: u8, colour: u8, interlaced: u8, rows: &[u8]) -> Vec<u8> {
    let mut header = Vec::new();
    header.extend_from_slice(&size[0].to_be_bytes());
    header.extend_from_slice(&size[1].to_be_bytes());
    header.extend_from_slice(&[depth, colour, 0, 0, interlaced]);
    let mut bytes = b"\x89PNG\r\n\x1a\n".to_vec();
    bytes.extend(png_chunk(b"IHDR", &header));
    bytes.extend(png_chunk(b"IDAT", &zlib(rows)));
    bytes.extend(png_chunk(b"IEND", b""));
    bytes
}

/// Bytes in a zlib stream.
pub fn zlib(data: &[u8]) -> Vec<u8> {
    let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
    encoder.write_all(data).expect("memory is writable");
    encoder.finish().expect("memory is writable")
}

/// 16-bit samples, high byte first.
pub fn big_endian(samples: &[f64]) -> Vec<u8> {
    samples.iter().flat_map(|&sample| (sample as u16).to_be_bytes()).collect()
}

/// A JPEG; grey for one channel, colour for three.
pub fn jpeg(width: u32, height: u32, channels: usize, data: &[u8]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let colour = if channels == 1 { image::ExtendedColorType::L8 } else { image::ExtendedColorType::Rgb8 };
    let mut encoder = JpegEncoder::new_with_quality(&mut bytes, 95);
    encoder.encode(data, width, height, colour).expect("a valid picture");
    bytes
}

/// A binary PGM; two bytes a sample above a maxval of 255.
pub fn pgm(width: u32, height: u32, maxval: u16, samples: &[f64]) -> Vec<u8> {
    let mut bytes = format!("P5\n# a comment\n{width} {height}\n{maxval}\n").into_bytes();
    if maxval > 255 {
        bytes.extend(big_endian(samples));
    } else {
        bytes.extend(samples.iter().map(|&sample| sample as u8));
    }
    bytes
}

/// A plain PGM.
pub fn plain_pgm(width: u32, height: u32, maxval: u16, samples: &[f64]) -> Vec<u8> {
    let mut text = format!("P2 {width} {height} {maxval}\n");
    for row in samples.chunks(width as usize) {
        let row: Vec<String> = row.iter().map(|sample| format!("{sample}")).collect();
        text += &row.join(" ");
        text.push('\n');
    }
    text.into_bytes()
}

/// Encoding of a Radiance picture's scan lines.
#[derive(Clone, Copy, Debug)]
pub enum Scan {
    Flat,
    /// Repeats of whole texels.
    Repeats,
    /// Runs, component by component.
    Components,
}

/// A Radiance picture of RGBE texels.
pub fn hdr(width: u32, height: u32, scan: Scan, texels: &[[u8; 4]]) -> Vec<u8> {
    let mut bytes = format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n").into_bytes();
    for row in texels.chunks(width.max(1) as usize) {
        match scan {
            Scan::Flat => bytes.extend(row.as_flattened()),
            Scan::Repeats => {
                for run in row.chunk_by(|a, b| a == b) {
                    bytes.extend(run[0]);
                    let mut repeats = run.len() - 1;
                    while repeats > 0 {
                        bytes.extend([1, 1, 1, repeats as u8]);
                        repeats >>= 8;
                    }
                }
            }
            Scan::Components => {
                bytes.extend([2, 2, (width >> 8) as u8, width as u8]);
                for component in 0..4 {
                    let line: Vec<u8> = row.iter().map(|texel| texel[component]).collect();
                    for run in line.chunk_by(|a, b| a == b).flat_map(|run| run.chunks(127)) {
                        match run {
                            [one] => bytes.extend([1, *one]),
                            _ => bytes.extend([128 + run.len() as u8, run[0]]),
                        }
                    }
                }
            }
        }
    }
    bytes
}
