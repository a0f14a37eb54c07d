//! Broken files: cut off, damaged, with false sizes, or of another kind; and the smallest valid
//! ones.

use exr::prelude::{Compression, SampleType as ExrSample};
use png::{BitDepth, ColorType};
use relief_io::{Fill, HeightOptions};

use super::files::{Scan, big_endian, hdr, jpeg, pgm, plain_pgm, png, png_by_hand};
use super::tiff_file::{Tiff, Value};
use super::{Random, channel, exr_file, samples};

/// Expected result of reading a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Expect {
    Error,
    Map,
    /// Damage that a reader cannot always detect: an error or a valid map, but no panic and no
    /// exhausted memory.
    Either,
}

/// File with the options for reading it.
#[derive(Clone, Debug)]
pub struct BrokenFile {
    pub name: String,
    pub extension: &'static str,
    pub bytes: Vec<u8>,
    pub options: HeightOptions,
    pub expect: Expect,
}

impl BrokenFile {
    fn new(name: impl Into<String>, extension: &'static str, bytes: Vec<u8>, expect: Expect) -> Self {
        Self { name: name.into(), extension, bytes, options: HeightOptions::default(), expect }
    }

    fn with(mut self, options: HeightOptions) -> Self {
        self.options = options;
        self
    }
}

fn raw(text: &str) -> HeightOptions {
    HeightOptions { raw: Some(text.parse().expect("a layout")), ..HeightOptions::default() }
}

/// Valid files of every format and encoding.
pub fn valid_files() -> Vec<BrokenFile> {
    let [width, height] = [37, 29];
    let bytes: Vec<u8> = samples(width, height, 255.0).iter().map(|&s| s as u8).collect();
    let wide = samples(width, height, 65535.0);
    let fractions: Vec<f64> = wide.iter().map(|s| s / 65535.0).collect();
    let grey16 = png(width, height, ColorType::Grayscale, BitDepth::Sixteen, &big_endian(&wide));
    let rgba: Vec<u8> = bytes.iter().flat_map(|&byte| [byte, byte, byte, 255 - byte]).collect();
    let three: Vec<u8> = bytes.iter().flat_map(|&byte| [byte; 3]).collect();
    let texels: Vec<[u8; 4]> = bytes.iter().map(|&byte| [byte, byte, byte, 130]).collect();
    let tiff = Tiff { extra: vec![(42113, Value::Text("-9999".into()))], ..Tiff::grey(width, height, 32, 3) };
    let tiled = Tiff { tile_width: Some(16), deflate: true, ..tiff.clone() };
    let planar =
        Tiff { bands: 3, photometric: 2, planar: 2, deflate: true, ..Tiff::grey(width, height, 16, 1) };
    let equal: Vec<f64> = wide.iter().flat_map(|&s| [s; 3]).collect();
    let mut files = vec![
        BrokenFile::new("grey png", "png", grey16, Expect::Map),
        BrokenFile::new(
            "rgba png",
            "png",
            png(width, height, ColorType::Rgba, BitDepth::Eight, &rgba),
            Expect::Map,
        ),
        BrokenFile::new("grey jpeg", "jpg", jpeg(width, height, 1, &bytes), Expect::Map),
        BrokenFile::new("colour jpeg", "jpg", jpeg(width, height, 3, &three), Expect::Map),
        BrokenFile::new("tiff", "tif", tiff.bytes(&fractions), Expect::Map),
        BrokenFile::new("geotiff", "tif", geotiff(width, height, &wide), Expect::Map),
        BrokenFile::new("tiled tiff", "tif", tiled.bytes(&fractions), Expect::Map),
        BrokenFile::new("planar tiff", "tif", planar.bytes(&equal), Expect::Map),
        BrokenFile::new("flat hdr", "hdr", hdr(width, height, Scan::Flat, &texels), Expect::Map),
        BrokenFile::new("run-length hdr", "hdr", hdr(width, height, Scan::Components, &texels), Expect::Map),
        BrokenFile::new("pgm", "pgm", pgm(width, height, 65535, &wide), Expect::Map),
        BrokenFile::new("plain pgm", "pgm", plain_pgm(width, height, 65535, &wide), Expect::Map),
        BrokenFile::new("raw", "r16", big_endian(&wide), Expect::Map).with(raw("37x29,be")),
    ];
    for (name, compression, _) in exr_file::COMPRESSIONS {
        let channels: [exr_file::Samples<'_>; 3] = [
            ("half", ExrSample::F16, &fractions),
            ("single", ExrSample::F32, &fractions),
            ("whole", ExrSample::U32, &wide),
        ];
        for (layout, tile) in [("scan line", None), ("tiled", Some([16, 16]))] {
            let bytes = exr_file::exr([width, height], tile, compression, &channels);
            let name = format!("{layout} {name} exr");
            files.push(BrokenFile::new(name, "exr", bytes, Expect::Map).with(channel("single")));
        }
    }
    files
}

/// Elevation model with a mask that excludes no texel.
fn geotiff(width: u32, height: u32, values: &[f64]) -> Vec<u8> {
    let keys = vec![1, 1, 0, 4, 1024, 0, 1, 2, 2048, 0, 1, 4326, 2054, 0, 1, 9102, 4099, 0, 1, 9002];
    let items = "<Item sample=\"0\" role=\"scale\">0.5</Item><Item sample=\"0\" role=\"offset\">-9</Item>";
    let extra = vec![
        (33550, Value::Double(vec![0.01, 0.01, 0.0])),
        (33922, Value::Double(vec![0.0, 0.0, 0.0, 7.0, 48.0, 0.0])),
        (34735, Value::Short(keys)),
        (42112, Value::Text(format!("<GDALMetadata>{items}</GDALMetadata>"))),
        (42113, Value::Text("65535".into())),
    ];
    let mask =
        Tiff { photometric: 4, extra: vec![(254, Value::Long(vec![4]))], ..Tiff::grey(width, height, 1, 1) };
    let more = [(mask, vec![1.0; values.len()])];
    Tiff { extra, ..Tiff::grey(width, height, 16, 1) }.bytes_before(values, &more)
}

/// Valid files, each cut off at several lengths.
fn cut_off() -> Vec<BrokenFile> {
    let mut files = Vec::new();
    for file in valid_files() {
        // A plain PGM is valid without its last line end, and another one without its last digits.
        let last = if file.name.starts_with("plain") { 8 } else { 1 };
        let len = file.bytes.len();
        for cut in [1, 4, 12, 24, len / 4, len / 2, 3 * len / 4, len - last] {
            let mut broken = file.clone();
            broken.name = format!("{} cut at {cut} of {len}", file.name);
            broken.bytes.truncate(cut);
            broken.expect = Expect::Error;
            files.push(broken);
        }
    }
    files
}

/// Flips up to four bits of a valid file, the same ones for the same seed; half of them in its
/// first 600 bytes, which contain the header.
pub fn flipped(file: &BrokenFile, seed: u64) -> BrokenFile {
    let mut random = Random::new(seed);
    let mut broken = file.clone();
    let flips = 1 + random.below(4);
    for _ in 0..flips {
        let within = if random.below(2) == 0 { broken.bytes.len().min(600) } else { broken.bytes.len() };
        let at = random.below(within);
        broken.bytes[at] ^= 1 << random.below(8);
    }
    broken.name = format!("{} with {flips} flips of seed {seed}", file.name);
    broken.expect = Expect::Either;
    broken
}

/// Headers that claim a size, with almost no data.
fn sized([width, height]: [u32; 2], expect: Expect) -> Vec<BrokenFile> {
    let size = format!("{width}x{height}");
    let name = |format: &str| format!("{format} of {size}");
    let mut jpeg_file = jpeg(8, 8, 1, &[7; 64]);
    let frame = jpeg_file.windows(2).position(|marker| marker == [0xff, 0xc0]).expect("a frame header");
    jpeg_file[frame + 5..frame + 9]
        .copy_from_slice(&[(height as u16).to_be_bytes(), (width as u16).to_be_bytes()].concat());
    let mut exr_bytes =
        exr_file::exr([1, 1], None, Compression::ZIP16, &[("height", ExrSample::F32, &[0.5])]);
    let window = exr_bytes.windows(10).position(|name| name == b"dataWindow").expect("a data window");
    let value = window + b"dataWindow\0box2i\0".len() + 4;
    exr_bytes[value + 8..value + 12].copy_from_slice(&(width as i32 - 1).to_le_bytes());
    exr_bytes[value + 12..value + 16].copy_from_slice(&(height as i32 - 1).to_le_bytes());
    let mut tiff = Tiff::grey(1, 1, 16, 1).bytes(&[7.0]);
    for (tag, side) in [(256u16, width), (257, height), (278, height)] {
        let entry = [tag.to_le_bytes(), 4u16.to_le_bytes()].concat();
        let at = tiff.windows(4).position(|bytes| bytes == entry).expect("the tag is there");
        tiff[at + 8..at + 12].copy_from_slice(&side.to_le_bytes());
    }
    vec![
        BrokenFile::new(name("png"), "png", png_by_hand([width, height], 8, 0, 0, &[0, 7]), expect),
        BrokenFile::new(
            name("interlaced png"),
            "png",
            png_by_hand([width, height], 8, 0, 1, &[0, 7]),
            expect,
        ),
        BrokenFile::new(name("jpeg"), "jpg", jpeg_file, expect),
        BrokenFile::new(name("exr"), "exr", exr_bytes, expect),
        BrokenFile::new(name("tiff"), "tif", tiff, expect),
        BrokenFile::new(name("hdr"), "hdr", hdr(width, height, Scan::Flat, &[[1, 2, 3, 130]; 1]), expect),
        BrokenFile::new(name("pgm"), "pgm", format!("P5 {width} {height} 255\n7").into_bytes(), expect),
        BrokenFile::new(name("plain pgm"), "pgm", format!("P2 {width} {height} 255\n7").into_bytes(), expect),
    ]
}

/// Smallest valid maps, and maps one texel wide.
fn small() -> Vec<BrokenFile> {
    let mut files = Vec::new();
    for [width, height] in [[1, 1], [1, 9], [9, 1]] {
        let count = (width * height) as usize;
        let values: Vec<f64> = (0..count).map(|at| at as f64).collect();
        let bytes: Vec<u8> = (0..count as u8).collect();
        let texels = vec![[64, 64, 64, 129]; count];
        let name = |format: &str| format!("{format} of {width}x{height}");
        let exr_bytes =
            exr_file::exr([width, height], None, Compression::PIZ, &[("Y", ExrSample::F32, &values)]);
        files.extend([
            BrokenFile::new(
                name("png"),
                "png",
                png(width, height, ColorType::Grayscale, BitDepth::Eight, &bytes),
                Expect::Map,
            ),
            BrokenFile::new(name("jpeg"), "jpg", jpeg(width, height, 1, &bytes), Expect::Map),
            BrokenFile::new(name("exr"), "exr", exr_bytes, Expect::Map),
            BrokenFile::new(
                name("tiff"),
                "tif",
                Tiff::grey(width, height, 32, 3).bytes(&values),
                Expect::Map,
            ),
            BrokenFile::new(name("hdr"), "hdr", hdr(width, height, Scan::Flat, &texels), Expect::Map),
            BrokenFile::new(name("pgm"), "pgm", pgm(width, height, 255, &values), Expect::Map),
            BrokenFile::new(name("raw"), "raw", big_endian(&values), Expect::Map)
                .with(raw(&format!("{width}x{height},be"))),
        ]);
    }
    files
}

/// Intact files that cannot be read with their options.
fn unfit() -> Vec<BrokenFile> {
    let values = samples(8, 8, 100.0);
    let float = |value: f64| {
        let mut values = values.clone();
        values[9] = value;
        let exr = exr_file::exr([8, 8], None, Compression::ZIP1, &[("Y", ExrSample::F32, &values)]);
        let tiff = Tiff::grey(8, 8, 32, 3).bytes(&values);
        [
            BrokenFile::new(format!("exr with {value}"), "exr", exr, Expect::Error),
            BrokenFile::new(format!("tiff with {value}"), "tif", tiff, Expect::Error),
        ]
    };
    let grey = || png(8, 8, ColorType::Grayscale, BitDepth::Eight, &[7; 64]);
    let colour: Vec<u8> = (0..192u32).map(|at| (at * 37 % 256) as u8).collect();
    let mut lzma = Tiff::grey(8, 8, 16, 1).bytes(&values);
    let compression = lzma.windows(4).position(|bytes| bytes == [3, 1, 3, 0]).expect("tag 259, a short");
    lzma[compression + 8..compression + 10].copy_from_slice(&34925u16.to_le_bytes());
    let nothing = exr_file::exr([8, 8], None, Compression::ZIP1, &[("Y", ExrSample::F32, &[f64::NAN; 64])]);
    let filled = HeightOptions { fill: Fill::Always, ..HeightOptions::default() };
    let mut files = vec![
        BrokenFile::new("empty", "png", Vec::new(), Expect::Error),
        BrokenFile::new("empty raw", "r16", Vec::new(), Expect::Error).with(raw("1x1,le")),
        BrokenFile::new("text", "png", b"This is no picture at all.\n".to_vec(), Expect::Error),
        BrokenFile::new("zip", "exr", b"PK\x03\x04abcdefghijkl".to_vec(), Expect::Error),
        BrokenFile::new("zeros", "tif", vec![0; 4096], Expect::Error),
        BrokenFile::new("bitmap", "bmp", b"BM\x7a\0\0\0\0\0\0\0\x36\0\0\0\x28\0\0\0".to_vec(), Expect::Error),
        BrokenFile::new("signature of png alone", "png", b"\x89PNG\r\n\x1a\n".to_vec(), Expect::Error),
        BrokenFile::new("raw without layout", "r16", vec![7; 128], Expect::Error),
        BrokenFile::new("raw of another size", "r16", vec![7; 128], Expect::Error).with(raw("8x9,le")),
        BrokenFile::new("unknown channel", "png", grey(), Expect::Error).with(channel("a")),
        BrokenFile::new("colour", "png", png(8, 8, ColorType::Rgb, BitDepth::Eight, &colour), Expect::Error),
        BrokenFile::new("lzma tiff", "tif", lzma, Expect::Error),
        BrokenFile::new("nothing to fill from", "exr", nothing, Expect::Error).with(filled),
        BrokenFile::new("maxval 0", "pgm", b"P5 1 1 0\n\0".to_vec(), Expect::Error),
        BrokenFile::new("sample above maxval", "pgm", b"P2 2 1 9\n3 10\n".to_vec(), Expect::Error),
        BrokenFile::new("letters in pgm", "pgm", b"P2 2 1 9\n3 x\n".to_vec(), Expect::Error),
        BrokenFile::new("negative size", "pgm", b"P2 -2 1 9\n3 3\n".to_vec(), Expect::Error),
        BrokenFile::new("size beyond 32 bit", "pgm", b"P5 99999999999 1 9\n3".to_vec(), Expect::Error),
        BrokenFile::new("endless hdr header", "hdr", b"#?RADIANCE\n".repeat(5000), Expect::Error),
        BrokenFile::new("another extension", "jpg", grey(), Expect::Map),
    ];
    files.extend([f64::NAN, f64::INFINITY, f64::NEG_INFINITY].into_iter().flat_map(float));
    files
}

/// All cases except bit flips, which [`flipped`] makes from [`valid_files`].
pub fn broken_files() -> Vec<BrokenFile> {
    let mut files = valid_files();
    files.extend(cut_off());
    files.extend(sized([0, 0], Expect::Error));
    files.extend(sized([0, 5], Expect::Error));
    files.extend(sized([100_000, 100_000], Expect::Error));
    files.extend(sized([20_000, 20_000], Expect::Error));
    files.extend(small());
    files.extend(unfit());
    files
}
