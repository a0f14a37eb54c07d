//! EXR files through the `exr` crate's writer.

use std::io::Cursor;

use exr::math::RoundingMode;
use exr::prelude::*;

/// A channel to be written: name, type and values.
pub type Samples<'a> = (&'a str, SampleType, &'a [f64]);

/// Every compression that is read, with what the crate rounds away at values up to 1.
pub const COMPRESSIONS: [(&str, Compression, f64); 10] = [
    ("none", Compression::Uncompressed, 0.0),
    ("rle", Compression::RLE, 0.0),
    ("zips", Compression::ZIP1, 0.0),
    ("zip", Compression::ZIP16, 0.0),
    ("piz", Compression::PIZ, 0.0),
    ("pxr24", Compression::PXR24, 1e-4),
    ("b44", Compression::B44, 0.02),
    ("b44a", Compression::B44A, 0.02),
    ("dwaa", Compression::DWAA(None), 0.05),
    ("dwab", Compression::DWAB(None), 0.05),
];

/// An EXR of one part.
pub fn exr(
    size: [u32; 2],
    tile: Option<[usize; 2]>,
    compression: Compression,
    channels: &[Samples<'_>],
) -> Vec<u8> {
    let image = Image::from_layer(layer(None, size, tile, compression, channels));
    let mut bytes = Vec::new();
    image.write().non_parallel().to_buffered(Cursor::new(&mut bytes)).expect("a valid picture");
    bytes
}

/// An EXR of two parts.
pub fn two_parts(first: ([u32; 2], &[Samples<'_>]), second: ([u32; 2], &[Samples<'_>])) -> Vec<u8> {
    let part = |name, (size, channels)| layer(Some(name), size, None, Compression::ZIP16, channels);
    let window = IntegerBounds::from_dimensions((first.0[0] as usize, first.0[1] as usize));
    let image =
        Image::from_layers(ImageAttributes::new(window), vec![part("base", first), part("extra", second)]);
    let mut bytes = Vec::new();
    image.write().non_parallel().to_buffered(Cursor::new(&mut bytes)).expect("a valid picture");
    bytes
}

/// A tiled EXR with resolution levels; the lower ones hold -1.
pub fn with_levels(size: [u32; 2], samples: &[f64]) -> Vec<u8> {
    let full = Vec2(size[0] as usize, size[1] as usize);
    let rounding_mode = RoundingMode::Up;
    let level_data = exr::meta::mip_map_levels(rounding_mode, full).map(|(level, size)| {
        let values = samples.iter().map(|&value| value as f32).collect();
        FlatSamples::F32(if level == 0 { values } else { vec![-1.0; size.area()] })
    });
    let levels = Levels::Mip { level_data: level_data.collect(), rounding_mode };
    let channels = AnyChannels::sort([AnyChannel::new("height", levels)].into_iter().collect());
    let encoding = Encoding {
        compression: Compression::ZIP16,
        blocks: Blocks::Tiles(Vec2(16, 16)),
        line_order: LineOrder::Increasing,
    };
    let image = Image::from_layer(Layer::new(full, LayerAttributes::default(), encoding, channels));
    let mut bytes = Vec::new();
    image.write().non_parallel().to_buffered(Cursor::new(&mut bytes)).expect("a valid picture");
    bytes
}

fn layer(
    name: Option<&str>,
    size: [u32; 2],
    tile: Option<[usize; 2]>,
    compression: Compression,
    channels: &[Samples<'_>],
) -> Layer<AnyChannels<FlatSamples>> {
    let channel = |&(name, kind, values): &Samples<'_>| {
        let values = values.iter();
        let samples = match kind {
            SampleType::F16 => FlatSamples::F16(values.map(|&value| f16::from_f64(value)).collect()),
            SampleType::F32 => FlatSamples::F32(values.map(|&value| value as f32).collect()),
            SampleType::U32 => FlatSamples::U32(values.map(|&value| value as u32).collect()),
        };
        AnyChannel::new(name, samples)
    };
    let encoding = Encoding {
        compression,
        blocks: tile.map_or(Blocks::ScanLines, |[columns, rows]| Blocks::Tiles(Vec2(columns, rows))),
        line_order: LineOrder::Increasing,
    };
    let attributes = name.map_or_else(LayerAttributes::default, LayerAttributes::named);
    let list = AnyChannels::sort(channels.iter().map(channel).collect());
    Layer::new((size[0] as usize, size[1] as usize), attributes, encoding, list)
}
