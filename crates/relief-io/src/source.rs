//! A file that has been recognised and whose header has been checked: what it holds, and its samples row by row.

use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom};
use std::path::{Path, PathBuf};

use relief::HeightMap;

use crate::exr::ExrSource;
use crate::hdr::HdrSource;
use crate::jpeg::JpegSource;
use crate::pgm::PgmSource;
use crate::png::PngSource;
use crate::raw::RawSource;
use crate::tiff::TiffSource;
use crate::{RawLayout, ReadProblem};

/// A file format that is read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// Portable Network Graphics, 1 to 16 bit.
    Png,
    /// JPEG, 8 bit.
    Jpeg,
    /// OpenEXR: 16 and 32-bit floats and 32-bit integers, flat parts.
    Exr,
    /// TIFF, BigTIFF and GeoTIFF.
    Tiff,
    /// Radiance RGBE.
    Hdr,
    /// Netpbm grey and colour maps: P2, P3, P5, P6.
    Pgm,
    /// 16-bit samples without a header.
    Raw,
}

impl Format {
    /// The format's name, as users know it.
    pub const fn name(self) -> &'static str {
        match self {
            Format::Png => "PNG",
            Format::Jpeg => "JPEG",
            Format::Exr => "EXR",
            Format::Tiff => "TIFF",
            Format::Hdr => "Radiance HDR",
            Format::Pgm => "PGM",
            Format::Raw => "raw",
        }
    }
}

/// How a sample is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SampleKind {
    /// Integer from 0.
    Unsigned,
    /// Integer in two's complement.
    Signed,
    /// IEEE float (or, in Radiance files, a shared exponent).
    Float,
}

/// How a sample is stored, and in how many bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SampleType {
    /// Integer or float.
    pub kind: SampleKind,
    /// Bits a sample.
    pub bits: u8,
}

impl SampleType {
    pub(crate) const fn unsigned(bits: u8) -> Self {
        Self { kind: SampleKind::Unsigned, bits }
    }

    pub(crate) const fn float(bits: u8) -> Self {
        Self { kind: SampleKind::Float, bits }
    }

    /// Whether each sample is exactly an `f32`.
    pub(crate) const fn fits_f32(self) -> bool {
        match self.kind {
            SampleKind::Float => self.bits <= 32,
            SampleKind::Unsigned | SampleKind::Signed => self.bits <= 24,
        }
    }
}

impl std::fmt::Display for SampleType {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let kind = match self.kind {
            SampleKind::Unsigned => "unsigned",
            SampleKind::Signed => "signed",
            SampleKind::Float => "float",
        };
        write!(f, "{}-bit {kind}", self.bits)
    }
}

/// One channel of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Channel {
    /// Its name: as stored in EXR files; `y`, `r`, `g`, `b`, `a`, or `band1` and so on in others.
    pub name: String,
    /// How its samples are stored.
    pub sample: SampleType,
}

/// What a file's header says of the whole picture.
#[derive(Clone, Debug)]
pub(crate) struct Layout {
    pub format: Format,
    pub width: u32,
    pub height: u32,
    /// The channels, in the file's order.
    pub channels: Vec<Channel>,
    /// The raw value that stands for 1, for unsigned samples of at most 16 bit; none where the range of the values decides.
    pub full_scale: Option<f64>,
    /// The raw value that marks a texel without a value.
    pub nodata: Option<f64>,
    /// Size of a texel along `u` and `v`, in metres.
    pub texel_size_m: Option<[f64; 2]>,
}

impl Layout {
    /// A layout whose channels are all stored alike, without georeference; unsigned samples are divided by their
    /// type's maximum.
    pub(crate) fn new(format: Format, [width, height]: [u32; 2], names: &[&str], sample: SampleType) -> Self {
        let channel = |name: &&str| Channel { name: (*name).to_owned(), sample };
        let full_scale = match sample.kind {
            SampleKind::Unsigned if sample.bits <= 16 => Some(f64::from((1u32 << sample.bits) - 1)),
            _ => None,
        };
        let channels = names.iter().map(channel).collect();
        Self { format, width, height, channels, full_scale, nodata: None, texel_size_m: None }
    }

    /// The channel of that name, whatever its case.
    pub(crate) fn channel(&self, name: &str) -> Option<usize> {
        self.channels.iter().position(|channel| channel.name.eq_ignore_ascii_case(name))
    }

    /// The channels' names, in the file's order.
    pub(crate) fn channel_names(&self) -> Vec<String> {
        self.channels.iter().map(|channel| channel.name.clone()).collect()
    }
}

/// Samples of one row, or of a part of it: texel `k` of the span lies in column `column + k * step`.
pub(crate) struct Span<'a> {
    pub row: u32,
    pub column: u32,
    pub step: u32,
    /// Raw values, the chosen channels side by side.
    pub samples: &'a [f64],
}

/// Takes the spans of a picture; every texel comes exactly once, in the decoder's order.
pub(crate) type Sink<'a> = dyn FnMut(Span<'_>) -> Result<(), ReadProblem> + 'a;

/// A recognised file. Its header is checked; no memory has been taken for samples.
pub(crate) enum Source {
    Png(Box<PngSource>),
    Jpeg(JpegSource),
    Exr(ExrSource),
    Tiff(Box<TiffSource>),
    Hdr(HdrSource),
    Pgm(PgmSource),
    Raw(RawSource),
}

/// The largest of the formats' signatures.
const SIGNATURE_LEN: u64 = 16;

impl Source {
    /// Opens a file and recognises it by its content; with a raw layout it is read as raw, whatever it holds.
    ///
    /// `bytes_per_texel` is what the caller will hold for each texel; it and the decoder's own buffers must stay
    /// within `max_bytes`.
    pub(crate) fn open(
        path: &Path,
        raw: Option<RawLayout>,
        bytes_per_texel: u64,
        max_bytes: u64,
    ) -> Result<Self, ReadProblem> {
        let kind = std::fs::metadata(path)?;
        if kind.is_dir() {
            return Err(ReadProblem::Folder);
        }
        // A pipe would block, a device has no length: formats are told apart by what can be read twice.
        if !kind.is_file() {
            return Err(ReadProblem::NoFile);
        }
        let mut file = File::open(path)?;
        let file_len = file.metadata()?.len();
        if file_len == 0 {
            return Err(ReadProblem::Empty);
        }
        let mut signature = Vec::with_capacity(SIGNATURE_LEN as usize);
        file.by_ref().take(SIGNATURE_LEN).read_to_end(&mut signature)?;
        file.seek(SeekFrom::Start(0))?;
        let input =
            Input { path: path.to_owned(), file: BufReader::new(file), file_len, bytes_per_texel, max_bytes };
        if let Some(layout) = raw {
            return Ok(Self::Raw(RawSource::open(input, layout)?));
        }
        match recognise(&signature) {
            Some(Format::Png) => Ok(Self::Png(Box::new(PngSource::open(input)?))),
            Some(Format::Jpeg) => Ok(Self::Jpeg(JpegSource::open(input)?)),
            Some(Format::Exr) => Ok(Self::Exr(ExrSource::open(input)?)),
            Some(Format::Tiff) => Ok(Self::Tiff(Box::new(TiffSource::open(input)?))),
            Some(Format::Hdr) => Ok(Self::Hdr(HdrSource::open(input)?)),
            Some(Format::Pgm) => Ok(Self::Pgm(PgmSource::open(input)?)),
            Some(Format::Raw) | None => {
                let extension = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase());
                match extension.as_deref() {
                    Some("raw" | "r16" | "bin") => Err(ReadProblem::NeedsRawLayout),
                    _ => Err(ReadProblem::Unrecognised),
                }
            }
        }
    }

    pub(crate) fn layout(&self) -> &Layout {
        match self {
            Self::Png(source) => source.layout(),
            Self::Jpeg(source) => source.layout(),
            Self::Exr(source) => source.layout(),
            Self::Tiff(source) => source.layout(),
            Self::Hdr(source) => source.layout(),
            Self::Pgm(source) => source.layout(),
            Self::Raw(source) => source.layout(),
        }
    }

    /// Decodes the chosen channels and gives every texel once.
    pub(crate) fn decode(self, channels: &[usize], sink: &mut Sink<'_>) -> Result<(), ReadProblem> {
        match self {
            Self::Png(source) => source.decode(channels, sink),
            Self::Jpeg(source) => source.decode(channels, sink),
            Self::Exr(source) => source.decode(channels, sink),
            Self::Tiff(source) => source.decode(channels, sink),
            Self::Hdr(source) => source.decode(channels, sink),
            Self::Pgm(source) => source.decode(channels, sink),
            Self::Raw(source) => source.decode(sink),
        }
    }
}

fn recognise(signature: &[u8]) -> Option<Format> {
    match signature {
        [0x89, b'P', b'N', b'G', ..] => Some(Format::Png),
        [0xff, 0xd8, 0xff, ..] => Some(Format::Jpeg),
        [0x76, 0x2f, 0x31, 0x01, ..] => Some(Format::Exr),
        [b'I', b'I', 42 | 43, 0, ..] | [b'M', b'M', 0, 42 | 43, ..] => Some(Format::Tiff),
        [b'#', b'?', ..] => Some(Format::Hdr),
        [b'P', b'2' | b'3' | b'5' | b'6', after, ..] if after.is_ascii_whitespace() || *after == b'#' => {
            Some(Format::Pgm)
        }
        _ => None,
    }
}

/// An opened file with what is known of it before its header is read.
pub(crate) struct Input {
    pub path: PathBuf,
    pub file: BufReader<File>,
    pub file_len: u64,
    bytes_per_texel: u64,
    max_bytes: u64,
}

impl Input {
    /// Refuses sizes that no height map has, that need too much memory, or that a file of this length cannot hold.
    ///
    /// `decoder_bytes` is what the decoder itself holds at its peak, and `least_file_bytes` the length of the
    /// shortest file that can hold such a picture.
    pub(crate) fn check_size(
        &self,
        format: Format,
        [width, height]: [u32; 2],
        decoder_bytes: u64,
        least_file_bytes: u64,
    ) -> Result<(), ReadProblem> {
        HeightMap::check_size(width, height)?;
        let texels = u64::from(width) * u64::from(height);
        let needed = (texels * self.bytes_per_texel).saturating_add(decoder_bytes);
        if needed > self.max_bytes {
            return Err(ReadProblem::TooMuchMemory { width, height, needed, limit: self.max_bytes });
        }
        if least_file_bytes > self.file_len {
            let what = format!(
                "a header of {width}x{height} texels needs at least {least_file_bytes} bytes, the file has {}",
                self.file_len
            );
            return Err(ReadProblem::damaged(format.name(), what));
        }
        Ok(())
    }
}

/// A vector of `len` zeros; an error, not an abort, where the system has no memory for it.
pub(crate) fn zeros<T: Clone + Default>(len: usize) -> Result<Vec<T>, ReadProblem> {
    let mut values = Vec::new();
    let needed = (len as u64).saturating_mul(size_of::<T>() as u64);
    values.try_reserve_exact(len).map_err(|_| ReadProblem::OutOfMemory { needed })?;
    values.resize(len, T::default());
    Ok(values)
}

/// Reading past the end means a cut-off file; everything else is the system's.
pub(crate) fn io_problem(format: Format, error: io::Error) -> ReadProblem {
    match error.kind() {
        io::ErrorKind::UnexpectedEof => ReadProblem::damaged(format.name(), "it ends too early"),
        io::ErrorKind::InvalidData | io::ErrorKind::InvalidInput => {
            ReadProblem::damaged(format.name(), error)
        }
        _ => ReadProblem::Io(error),
    }
}
