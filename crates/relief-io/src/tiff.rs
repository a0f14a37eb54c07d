//! Reader of TIFF, BigTIFF and GeoTIFF, block by block, through `tiff-reader`: strips and tiles,
//! both planar configurations, integers of 1 to 64 bit, floats of 16 to 64, palettes, uncompressed,
//! LZW, Deflate, PackBits, ZSTD and LERC.
//!
//! The first full-resolution picture of the file is read. Blocks that a sparse file omits hold its
//! nodata value, or zeros if it has none. A mask marks the texels that have a value: a picture of
//! its own in the file, or a sidecar file.

mod gdal;
mod geo;
mod halves;
mod keys;
mod palette;
mod raster;
mod stored;

use tiff_reader::{Ifd, TiffError};

use self::raster::{PARSE_BUDGETS, Raster};
use self::stored::Stored;
use crate::input::Input;
use crate::layout::{Channel, Format, Layout, SampleType, Sink};
use crate::omissions::{NO_PHOTOMETRIC, PAGES, Remark};
use crate::{ReadProblem, Source};

const TAG_NEW_SUBFILE_TYPE: u16 = 254;
const TAG_ORIENTATION: u16 = 274;
/// Bits of NewSubfileType.
const REDUCED_COPY: u32 = 1;
const MASK: u32 = 4;

const WHITE_IS_ZERO: u16 = 0;
const BLACK_IS_ZERO: u16 = 1;
const RGB: u16 = 2;

/// The only channel in which white may be stored as 0. The others are opacity or extra channels.
const GREY: usize = 0;

/// Extension of GDAL's mask files, after the map's name.
const MASK_EXTENSION: &str = "msk";

pub(crate) struct TiffFile<'a> {
    raster: Raster<'a>,
    layout: Layout,
    /// Index of the picture that is the mask.
    mask: Option<usize>,
    source: Source<'a>,
    bytes_per_texel: u64,
    max_bytes: u64,
}

impl<'a> TiffFile<'a> {
    pub(crate) fn open(input: Input<'a>) -> Result<Self, ReadProblem> {
        // The decoder's cache is sized by the blocks, so the headers are needed before the decoder.
        let stored = Stored::of(&input)?;
        let pictures = stored.pictures(PARSE_BUDGETS).map_err(problem)?;
        let ifd = full_resolution(&pictures)?;
        let header = &pictures[ifd];
        let mut raster = Raster::open(&input, stored, header, ifd)?;
        let stated_photometric = header.photometric_interpretation();
        let photometric = stated_photometric.unwrap_or(BLACK_IS_ZERO);
        let mut layout = match &mut raster.palette {
            Some(palette) => {
                // In an elevation model the samples are the heights, and their colours are for
                // display.
                let terrain =
                    geo::facts(header, raster.bands).and_then(|facts| facts.terrain(raster.bands, None));
                palette.has_index = !matches!(terrain, Ok(None));
                let colour = SampleType::unsigned(palette.bits);
                let mut layout = Layout::new(Format::Tiff, raster.size, palette.channels(), colour);
                if palette.has_index {
                    layout.channels[0].sample = raster.sample;
                }
                layout
            }
            None => {
                let sample = raster.sample;
                let mut layout = Layout::new(Format::Tiff, raster.size, &[], sample);
                let channels = channel_names(header, photometric, raster.bands)?;
                layout.channels = channels.into_iter().map(|name| Channel { name, sample }).collect();
                layout
            }
        };
        layout.set_facts(geo::facts(header, layout.channels.len()));
        match gdal::nodata(header, raster.sample) {
            Ok(nodata) => layout.nodata = nodata,
            Err(what) => layout.terrain = Err(what),
        }
        layout.stated_orientation = header.tag(TAG_ORIENTATION).and_then(|tag| tag.value.as_u32());
        if stated_photometric.is_none() {
            let text = "it does not say whether 0 is black or white (PhotometricInterpretation): 0 is black";
            layout.remarks.push(Remark::new(&NO_PHOTOMETRIC, text));
        }
        let pages = pictures.iter().filter(|ifd| kind(ifd) & (REDUCED_COPY | MASK) == 0).count();
        if pages > 1 {
            layout.remarks.push(Remark::new(&PAGES, format!("it holds {pages} pages: the first is read")));
        }
        raster.nodata = layout.nodata;
        raster.inverted_white = layout.full_scale.filter(|_| photometric == WHITE_IS_ZERO);
        let Input { source, bytes_per_texel, max_bytes, .. } = input;
        Ok(Self { raster, layout, mask: mask_of(&pictures, ifd), source, bytes_per_texel, max_bytes })
    }

    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Applies changes of the layout by sidecars: the value of omitted blocks, and whether the
    /// samples of a palette are heights.
    pub(crate) fn follow_layout(&mut self) {
        self.raster.nodata = self.layout.nodata;
        let is_elevation = !matches!(self.layout.terrain, Ok(None));
        if let Some(palette) = self.raster.palette.as_mut().filter(|of| is_elevation && !of.has_index) {
            palette.has_index = true;
            let index = Channel { name: palette.channels()[0].to_owned(), sample: self.raster.sample };
            self.layout.channels.insert(0, index);
            if self.layout.terrain.is_ok() {
                self.layout.set_facts(Ok(self.layout.facts.clone()));
            }
        }
    }

    pub(crate) fn layout_mut(&mut self) -> &mut Layout {
        &mut self.layout
    }

    /// Returns the sample of white of a channel of shades that stores white as 0. None for samples
    /// of an elevation model, which are numbers and not shades, and for channels other than grey.
    pub(crate) fn white_of_heights(&self, channel: usize) -> Option<f64> {
        let is_elevation = matches!(self.layout.terrain, Ok(Some(_)));
        self.raster.inverted_white.filter(|_| channel == GREY && !is_elevation)
    }

    /// Leaves the samples as they are stored, even if they store white as 0.
    pub(crate) fn keep_stored(&mut self) {
        self.raster.inverted_white = None;
    }

    pub(crate) fn decode(self, channels: &[usize], sink: &mut Sink<'_>) -> Result<(), ReadProblem> {
        self.raster.decode(channels, sink)
    }

    /// Decodes the mask, if there is one: 0 for texels without a value. A mask in the file takes
    /// precedence over a sidecar.
    pub(crate) fn decode_mask(&self, channel: usize, sink: &mut Sink<'_>) -> Result<(), ReadProblem> {
        let beside = if self.mask.is_none() { self.source.beside(MASK_EXTENSION) } else { None };
        let (source, name) = match (&beside, self.mask) {
            (Some(path), _) => (self.source.with_name(path), path.display().to_string()),
            (None, Some(_)) => (self.source, "inside the file".to_owned()),
            (None, None) => return Ok(()),
        };
        self.decode_mask_of(source, channel, sink)
            .map_err(|problem| ReadProblem::Mask { mask: name, problem: Box::new(problem) })
    }

    fn decode_mask_of(
        &self,
        source: Source<'_>,
        channel: usize,
        sink: &mut Sink<'_>,
    ) -> Result<(), ReadProblem> {
        let input = Input::open(source, self.bytes_per_texel, self.max_bytes)?;
        let stored = Stored::of(&input)?;
        let pictures = stored.pictures(PARSE_BUDGETS).map_err(problem)?;
        let ifd = self.mask.map_or_else(|| full_resolution(&pictures), Ok)?;
        let header = pictures.get(ifd).ok_or_else(|| ReadProblem::damaged("TIFF", "it has changed"))?;
        let mask = Raster::open(&input, stored, header, ifd)?;
        let each_its_own = mask.bands == self.raster.bands;
        if mask.size != self.raster.size || !(mask.bands == 1 || each_its_own) {
            let text = |raster: &Raster<'_>| {
                format!("{}x{} texels of {} channel(s)", raster.size[0], raster.size[1], raster.bands)
            };
            return Err(ReadProblem::MaskSize { mask: text(&mask), map: text(&self.raster) });
        }
        mask.decode(&[if each_its_own { channel } else { 0 }], sink)
    }
}

/// Kind of the picture (TIFF 6.0, NewSubfileType).
fn kind(ifd: &Ifd) -> u32 {
    ifd.tag(TAG_NEW_SUBFILE_TYPE).and_then(|tag| tag.value.as_u32()).unwrap_or(0)
}

/// Finds the first picture that is neither a reduced copy nor a mask.
fn full_resolution(pictures: &[Ifd]) -> Result<usize, ReadProblem> {
    pictures
        .iter()
        .position(|ifd| kind(ifd) & (REDUCED_COPY | MASK) == 0)
        .ok_or_else(|| ReadProblem::damaged("TIFF", "it holds no picture at full resolution"))
}

/// Finds the mask of a picture: the first at full resolution before the next picture.
fn mask_of(pictures: &[Ifd], ifd: usize) -> Option<usize> {
    let full = |number: &usize| kind(&pictures[*number]) & REDUCED_COPY == 0;
    (ifd + 1..pictures.len()).find(full).filter(|&number| kind(&pictures[number]) & MASK != 0)
}

fn channel_names(header: &Ifd, photometric: u16, count: usize) -> Result<Vec<String>, ReadProblem> {
    let extra = header.extra_samples().map_err(problem)?;
    // Extra sample 0 is unspecified, 1 and 2 are opacity.
    let opacity = extra.first().is_some_and(|extra| matches!(extra.to_code(), 1 | 2));
    let names: &[&str] = match (photometric, count) {
        (WHITE_IS_ZERO | BLACK_IS_ZERO, 1) => &["y"],
        (WHITE_IS_ZERO | BLACK_IS_ZERO, 2) if opacity => &["y", "a"],
        (RGB, 3) => &["r", "g", "b"],
        (RGB, 4) if opacity => &["r", "g", "b", "a"],
        (WHITE_IS_ZERO | BLACK_IS_ZERO | RGB, _) => {
            return Ok((1..=count).map(|band| format!("band{band}")).collect());
        }
        (other, _) => {
            let space = COLOUR_SPACES.iter().find(|(number, _)| *number == other);
            let space =
                space.map_or_else(|| format!("the colour space number {other}"), |(_, name)| (*name).into());
            return Err(unsupported(space, "convert it to RGB, for instance with magick -colorspace sRGB"));
        }
    };
    Ok(names.iter().map(ToString::to_string).collect())
}

/// Unsupported colour spaces, by their codes.
const COLOUR_SPACES: [(u16, &str); 6] = [
    (3, "a palette with opacity"),
    (5, "inks (CMYK)"),
    (6, "the colour space YCbCr"),
    (8, "the colour space CIELab"),
    (32803, "the raw mosaic of a camera"),
    (34892, "the raw samples of a camera"),
];

/// Advice for unsupported types of samples, and for unsupported compressions.
const TO_FLOATS: &str = "convert it to 32-bit floats, for instance with gdal_translate -ot Float32";
const TO_DEFLATE: &str = "convert it, for instance with gdal_translate -co COMPRESS=DEFLATE";

fn unsupported(what: String, advice: &'static str) -> ReadProblem {
    ReadProblem::Unsupported { what, advice }
}

/// Returns the name of an unsupported compression if users know it, otherwise its code.
fn compression_name(code: u16) -> String {
    match code {
        34925 => "LZMA compression".into(),
        other => format!("TIFF compression number {other}"),
    }
}

fn problem(error: TiffError) -> ReadProblem {
    match error {
        TiffError::Io(error, _) => crate::input::io_problem(Format::Tiff, error),
        TiffError::UnsupportedCompression(code) => unsupported(compression_name(code), TO_DEFLATE),
        error @ (TiffError::UnsupportedPredictor(_) | TiffError::UnsupportedPlanarConfiguration(_)) => {
            unsupported(error.to_string(), TO_DEFLATE)
        }
        TiffError::UnsupportedBitsPerSample(bits) => {
            unsupported(format!("samples of {bits} bits"), TO_FLOATS)
        }
        TiffError::UnsupportedSampleFormat(format) => {
            unsupported(format!("samples of format {format} (complex numbers are 5 and 6)"), TO_FLOATS)
        }
        other => ReadProblem::damaged("TIFF", other),
    }
}
