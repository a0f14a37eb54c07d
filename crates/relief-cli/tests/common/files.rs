//! A small valid file of every format, and headers that claim any size.

use std::io::Cursor;

use exr::prelude::{
    AnyChannel, AnyChannels, Encoding, FlatSamples, Image, Layer, LayerAttributes, SmallVec, WritableImage,
};
use image::{DynamicImage, GrayImage, ImageFormat};

use super::maps::{Map, encoded};

/// The size of the files of [`every_format`].
pub const SIZE: [u32; 2] = [24, 16];

/// A file and the flags that it needs.
#[derive(Clone, Debug)]
pub struct Sample {
    pub format: &'static str,
    pub name: String,
    pub bytes: Vec<u8>,
    pub flags: &'static str,
}

impl Sample {
    fn new(format: &'static str, extension: &str, bytes: Vec<u8>) -> Self {
        Self { format, name: format!("map.{extension}"), bytes, flags: "" }
    }
}

/// Returns the same valid hills in every format.
pub fn every_format() -> Vec<Sample> {
    let [width, height] = SIZE;
    let map = Map::new(width, height, |x, y| (x * 2000 + y * 1000 + (x * y) % 7 * 300) as u16);
    let floats: Vec<f32> = map.texels.iter().map(|&h| f32::from(h) / 65535.0).collect();
    let grey: Vec<u8> = map.texels.iter().map(|&h| (h >> 8) as u8).collect();
    let image = DynamicImage::ImageLuma8(
        GrayImage::from_raw(width, height, grey).expect("as many texels as the size says"),
    );
    let wide: Vec<u8> = map.texels.iter().flat_map(|h| h.to_le_bytes()).collect();
    let float_bytes: Vec<u8> = floats.iter().flat_map(|h| h.to_le_bytes()).collect();
    let raw = Sample { flags: "--raw 24x16,le", ..Sample::new("raw", "r16", wide.clone()) };
    vec![
        Sample::new("PNG8", "png", encoded(&image, ImageFormat::Png)),
        Sample::new("PNG16", "png", map.png()),
        Sample::new("JPEG", "jpg", encoded(&image, ImageFormat::Jpeg)),
        Sample::new("EXR", "exr", exr(SIZE, &[("Y", floats.clone())])),
        Sample::new("TIFF", "tif", tiff(SIZE, Samples::Short, &wide, &[])),
        Sample::new("GeoTIFF", "tif", tiff(SIZE, Samples::Float, &float_bytes, &georeference())),
        Sample::new("HDR", "hdr", hdr(SIZE, &floats)),
        Sample::new("PGM", "pgm", pgm(SIZE, &map.texels)),
        raw,
    ]
}

/// Files with a proper header of that size, and next to nothing behind it. JPEG counts to 65535
/// only.
pub fn claiming(size: [u32; 2]) -> Vec<Sample> {
    let [width, height] = size;
    let mut png = Map::constant(0.5).png();
    // Signature, length and type of the header come first; its checksum is over type and content.
    png[16..24].copy_from_slice(&[width.to_be_bytes(), height.to_be_bytes()].concat());
    let checksum = crc32(&png[12..29]);
    png[29..33].copy_from_slice(&checksum.to_be_bytes());

    let mut jpeg = encoded(&DynamicImage::ImageLuma8(GrayImage::new(8, 8)), ImageFormat::Jpeg);
    let frame = jpeg.windows(2).position(|marker| marker == [0xff, 0xc0]).expect("a frame header");
    let [w, h] = size.map(|side| side.min(65535) as u16);
    jpeg[frame + 5..frame + 9].copy_from_slice(&[h.to_be_bytes(), w.to_be_bytes()].concat());

    let mut open_exr = exr([1, 1], &[("Y", vec![0.5])]);
    for name in [&b"dataWindow\0box2i\0"[..], b"displayWindow\0box2i\0"] {
        let at =
            open_exr.windows(name.len()).position(|bytes| bytes == name).expect("the attribute is there");
        // The value's length, and the first corner, come before the last corner.
        let last = at + name.len() + 4 + 8;
        let corner = size.map(|side| (side as i32 - 1).to_le_bytes());
        open_exr[last..last + 8].copy_from_slice(&corner.concat());
    }
    vec![
        Sample::new("PNG", "png", png),
        Sample::new("JPEG", "jpg", jpeg),
        Sample::new("EXR", "exr", open_exr),
        Sample::new("TIFF", "tif", tiff(size, Samples::Short, &[1, 2], &[])),
        Sample::new("GeoTIFF", "tif", tiff(size, Samples::Float, &[1, 2, 3, 4], &georeference())),
        Sample::new("HDR", "hdr", [hdr_header(size).as_bytes(), &[1, 2, 3, 130]].concat()),
        Sample::new("PGM", "pgm", format!("P5 {width} {height} 65535\n12").into_bytes()),
    ]
}

/// An EXR of 32-bit floats.
pub fn exr([width, height]: [u32; 2], channels: &[(&str, Vec<f32>)]) -> Vec<u8> {
    let mut list = SmallVec::new();
    for (name, values) in channels {
        list.push(AnyChannel::new(*name, FlatSamples::F32(values.clone())));
    }
    let size = (width as usize, height as usize);
    let attributes = LayerAttributes::default();
    let layer = Layer::new(size, attributes, Encoding::SMALL_LOSSLESS, AnyChannels::sort(list));
    let mut bytes = Vec::new();
    Image::from_layer(layer).write().to_buffered(Cursor::new(&mut bytes)).expect("a valid picture");
    bytes
}

/// Storage of the samples of a TIFF.
#[derive(Clone, Copy, Debug)]
pub enum Samples {
    /// 16 bit, unsigned.
    Short,
    /// 32-bit floats.
    Float,
}

/// A tag of a TIFF: number, type, and its values' bytes.
pub type Tag = (u16, u16, Vec<u8>);

/// Bytes of one value of a type: texts, shorts, longs and doubles are used.
fn value_len(kind: u16) -> usize {
    match kind {
        2 => 1,
        3 => 2,
        4 => 4,
        _ => 8,
    }
}

/// Returns the bytes before the samples of a little-endian TIFF whose strips have `rows_per_strip`
/// rows.
pub fn tiff_header(
    [width, height]: [u32; 2],
    rows_per_strip: u32,
    samples: Samples,
    more: &[Tag],
) -> Vec<u8> {
    let (bits, format) = match samples {
        Samples::Short => (16u16, 1u16),
        Samples::Float => (32, 3),
    };
    let short = |tag: u16, value: u16| (tag, 3, value.to_le_bytes().to_vec());
    let long = |tag: u16, value: u32| (tag, 4, value.to_le_bytes().to_vec());
    let row = u64::from(width) * u64::from(bits) / 8;
    let strips = height.div_ceil(rows_per_strip.max(1)).clamp(1, 4096);
    let len = |strip: u32| {
        let rows = rows_per_strip.min(height.saturating_sub(strip * rows_per_strip));
        (row * u64::from(rows)).min(u64::from(u32::MAX)) as u32
    };
    let counts: Vec<u8> = (0..strips).flat_map(|strip| len(strip).to_le_bytes()).collect();
    let mut tags: Vec<Tag> = vec![
        long(256, width),
        long(257, height),
        short(258, bits),
        short(259, 1),
        short(262, 1),
        (273, 4, counts.clone()),
        short(277, 1),
        long(278, rows_per_strip),
        (279, 4, counts),
        short(339, format),
    ];
    tags.extend_from_slice(more);
    tags.sort_by_key(|tag| tag.0);
    // Values of more than four bytes stand behind the directory, and the samples behind them.
    let directory = 8 + 2 + 12 * tags.len() + 4;
    let start = directory + tags.iter().map(|tag| tag.2.len()).filter(|&len| len > 4).sum::<usize>();
    if let Some(offsets) = tags.iter_mut().find(|tag| tag.0 == 273) {
        let mut next = start as u32;
        offsets.2.clear();
        for strip in 0..strips {
            offsets.2.extend(next.to_le_bytes());
            next = next.wrapping_add(len(strip));
        }
    }
    let mut file = b"II\x2a\0\x08\0\0\0".to_vec();
    file.extend((tags.len() as u16).to_le_bytes());
    let mut values = Vec::new();
    for (tag, kind, bytes) in &tags {
        let count = (bytes.len() / value_len(*kind)) as u32;
        file.extend([tag.to_le_bytes(), kind.to_le_bytes()].concat());
        file.extend(count.to_le_bytes());
        if bytes.len() > 4 {
            file.extend(((directory + values.len()) as u32).to_le_bytes());
            values.extend_from_slice(bytes);
        } else {
            file.extend(bytes.iter().copied().chain([0; 4]).take(4));
        }
    }
    file.extend([0; 4]);
    file.extend(values);
    file
}

/// A TIFF of one strip.
pub fn tiff(size: [u32; 2], samples: Samples, data: &[u8], more: &[Tag]) -> Vec<u8> {
    [&tiff_header(size, size[1], samples, more), data].concat()
}

/// Texels of 30 m in a projected system, and a nodata value.
pub fn georeference() -> Vec<Tag> {
    let doubles = |values: &[f64]| values.iter().flat_map(|value| value.to_le_bytes()).collect();
    let shorts = |values: &[u16]| values.iter().flat_map(|value| value.to_le_bytes()).collect();
    vec![
        (33550, 12, doubles(&[30.0, 30.0, 0.0])),
        (33922, 12, doubles(&[0.0, 0.0, 0.0, 5e5, 4e6, 0.0])),
        (34735, 3, shorts(&[1, 1, 0, 3, 1024, 0, 1, 1, 1025, 0, 1, 1, 3072, 0, 1, 32617])),
        (42113, 2, b"-9999\0".to_vec()),
    ]
}

fn hdr_header([width, height]: [u32; 2]) -> String {
    format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y {height} +X {width}\n")
}

/// Grey values below 1 with the exponent of the numbers from 1/2 to 1, each scan line flat.
fn hdr(size: [u32; 2], values: &[f32]) -> Vec<u8> {
    let texels = values.iter().flat_map(|value| {
        let mantissa = (value * 255.0) as u8;
        [mantissa, mantissa, mantissa, 128]
    });
    hdr_header(size).into_bytes().into_iter().chain(texels).collect()
}

pub fn pgm([width, height]: [u32; 2], texels: &[u16]) -> Vec<u8> {
    let samples = texels.iter().flat_map(|texel| texel.to_be_bytes());
    format!("P5 {width} {height} 65535\n").into_bytes().into_iter().chain(samples).collect()
}

/// The checksum of PNG's chunks.
pub fn crc32(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _| if crc & 1 == 1 { 0xedb8_8320 ^ (crc >> 1) } else { crc >> 1 };
    !bytes.iter().fold(!0, |crc, &byte| (0..8).fold(crc ^ u32::from(byte), step))
}

/// A text as programs on other systems write it: with a byte order mark, in UTF-16, with old line
/// ends.
pub fn foreign(text: &str) -> Vec<(&'static str, Vec<u8>)> {
    let units: Vec<u16> = std::iter::once(0xfeff).chain(text.encode_utf16()).collect();
    vec![
        ("marked", [b"\xef\xbb\xbf", text.as_bytes()].concat()),
        ("utf-16 le", units.iter().flat_map(|unit| unit.to_le_bytes()).collect()),
        ("utf-16 be", units.iter().flat_map(|unit| unit.to_be_bytes()).collect()),
        ("crlf", text.replace('\n', "\r\n").into_bytes()),
        ("cr", text.replace('\n', "\r").into_bytes()),
    ]
}
