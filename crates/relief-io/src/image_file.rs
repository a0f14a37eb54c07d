//! Image file that has been recognised and whose header has been checked, with its samples row by
//! row.

use std::io::{Read, Seek, SeekFrom};

use crate::exr::ExrFile;
use crate::georeference::apply_sidecars;
use crate::hdr::HdrFile;
use crate::input::Input;
use crate::jpeg::JpegFile;
use crate::layout::{Format, Layout, Sink};
use crate::orientation::LineSink;
use crate::pgm::PgmFile;
use crate::png::PngFile;
use crate::raw::RawFile;
use crate::text::MARK;
use crate::tiff::TiffFile;
use crate::webp::WebpFile;
use crate::{ForeignFormat, GivenUnits, RawLayout, ReadProblem, Source};

/// Recognised image file. Its header is checked; no memory has been allocated for samples.
pub(crate) struct ImageFile<'a> {
    stored: StoredImage<'a>,
    /// Header of the picture as it is displayed.
    layout: Layout,
}

/// Picture of a file as it is stored.
enum StoredImage<'a> {
    Png(Box<PngFile<'a>>),
    Jpeg(JpegFile<'a>),
    Exr(ExrFile<'a>),
    Tiff(Box<TiffFile<'a>>),
    Hdr(HdrFile<'a>),
    Pgm(PgmFile<'a>),
    Webp(Box<WebpFile<'a>>),
    Raw(RawFile<'a>),
}

/// Length of the longest signature of a format.
const SIGNATURE_LEN: u64 = 16;

impl<'a> ImageFile<'a> {
    /// Opens a source and recognises it by its content. With a raw layout it is read as raw,
    /// whatever its content.
    ///
    /// `bytes_per_texel` is the caller's memory for each texel; with the decoder's own buffers it
    /// must stay within `max_bytes`.
    pub(crate) fn open(
        source: Source<'a>,
        raw: Option<RawLayout>,
        bytes_per_texel: u64,
        max_bytes: u64,
    ) -> Result<Self, ReadProblem> {
        let stored = StoredImage::open(source, raw, bytes_per_texel, max_bytes)?;
        let layout = stored.layout().clone().shown();
        Ok(Self { stored, layout })
    }

    /// Returns the header of the picture as it is displayed.
    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    /// Replaces the file's units by the user's, if any are given.
    pub(crate) fn in_units(mut self, units: Option<GivenUnits>) -> Self {
        self.stored.layout_mut().give_units(units);
        self.layout.give_units(units);
        self
    }

    /// Returns the picture as it is stored, ignoring its orientation.
    pub(crate) fn unturned(mut self) -> Self {
        self.layout = self.stored.layout().clone();
        self
    }

    /// Decodes the mask of a channel: numbers that mark which texels have a value, 0 for none.
    /// Calls `sink` for no texel if the file has no mask.
    pub(crate) fn decode_mask(&self, channel: usize, sink: &mut LineSink<'_>) -> Result<(), ReadProblem> {
        let (orientation, size) = (self.layout.orientation, self.stored_size());
        match &self.stored {
            StoredImage::Tiff(file) => {
                file.decode_mask(channel, &mut |span| sink(orientation.line(size, &span)))
            }
            _ => Ok(()),
        }
    }

    /// Returns the sample of white of a channel that stores white as 0. The raw height is this
    /// sample minus the stored number. None for elevations, which are numbers and not shades.
    pub(crate) fn white_of_heights(&self, channel: usize) -> Option<f64> {
        match &self.stored {
            StoredImage::Tiff(file) => file.white_of_heights(channel),
            _ => None,
        }
    }

    /// Returns the file with its samples as stored, even if they store white as 0.
    pub(crate) fn into_stored(mut self) -> Self {
        if let StoredImage::Tiff(file) = &mut self.stored {
            file.keep_stored();
        }
        self
    }

    /// Decodes the chosen channels and passes every texel to `sink` once.
    pub(crate) fn decode(self, channels: &[usize], sink: &mut LineSink<'_>) -> Result<(), ReadProblem> {
        let (orientation, size) = (self.layout.orientation, self.stored_size());
        let sink: &mut Sink<'_> = &mut |span| sink(orientation.line(size, &span));
        match self.stored {
            StoredImage::Png(file) => file.decode(channels, sink),
            StoredImage::Jpeg(file) => file.decode(channels, sink),
            StoredImage::Exr(file) => file.decode(channels, sink),
            StoredImage::Tiff(file) => file.decode(channels, sink),
            StoredImage::Hdr(file) => file.decode(channels, sink),
            StoredImage::Pgm(file) => file.decode(channels, sink),
            StoredImage::Webp(file) => file.decode(channels, sink),
            StoredImage::Raw(file) => file.decode(sink),
        }
    }

    fn stored_size(&self) -> [u32; 2] {
        let Layout { width, height, .. } = self.stored.layout();
        [*width, *height]
    }
}

impl<'a> StoredImage<'a> {
    fn open(
        source: Source<'a>,
        raw: Option<RawLayout>,
        bytes_per_texel: u64,
        max_bytes: u64,
    ) -> Result<Self, ReadProblem> {
        let mut input = Input::open(source, bytes_per_texel, max_bytes)?;
        let mut signature = Vec::with_capacity(SIGNATURE_LEN as usize);
        input.file.by_ref().take(SIGNATURE_LEN).read_to_end(&mut signature)?;
        input.file.rewind()?;
        if let Some(layout) = raw {
            return Ok(Self::Raw(RawFile::open(input, layout)?));
        }
        // A plain PGM is a text file, which may begin with a byte order mark.
        let text = signature.strip_prefix(MARK).filter(|text| matches!(text, [b'P', b'2' | b'3', ..]));
        if text.is_some() {
            input.file.seek(SeekFrom::Start(MARK.len() as u64))?;
        }
        match recognise(text.unwrap_or(&signature)) {
            Some(Format::Png) => {
                Ok(Self::Png(Box::new(PngFile::open(input)?)).with_sidecars(source, max_bytes))
            }
            Some(Format::Jpeg) => Ok(Self::Jpeg(JpegFile::open(input)?).with_sidecars(source, max_bytes)),
            Some(Format::Exr) => Ok(Self::Exr(ExrFile::open(input)?)),
            Some(Format::Tiff) => {
                Ok(Self::Tiff(Box::new(TiffFile::open(input)?)).with_sidecars(source, max_bytes))
            }
            Some(Format::Hdr) => Ok(Self::Hdr(HdrFile::open(input)?)),
            Some(Format::Pgm) => Ok(Self::Pgm(PgmFile::open(input)?)),
            Some(Format::Webp) => Ok(Self::Webp(Box::new(WebpFile::open(input)?))),
            Some(Format::Raw) | None => {
                if let Some(foreign) = ForeignFormat::of(source.name(), input.file_len, &signature) {
                    return Err(ReadProblem::Foreign(foreign));
                }
                match Format::by_name(source.name()) {
                    Some(Format::Raw) => Err(ReadProblem::NeedsRawLayout),
                    _ => Err(ReadProblem::Unrecognised),
                }
            }
        }
    }

    fn layout(&self) -> &Layout {
        match self {
            Self::Png(file) => file.layout(),
            Self::Jpeg(file) => file.layout(),
            Self::Exr(file) => file.layout(),
            Self::Tiff(file) => file.layout(),
            Self::Hdr(file) => file.layout(),
            Self::Pgm(file) => file.layout(),
            Self::Webp(file) => file.layout(),
            Self::Raw(file) => file.layout(),
        }
    }

    fn layout_mut(&mut self) -> &mut Layout {
        match self {
            Self::Png(file) => file.layout_mut(),
            Self::Jpeg(file) => file.layout_mut(),
            Self::Exr(file) => file.layout_mut(),
            Self::Tiff(file) => file.layout_mut(),
            Self::Hdr(file) => file.layout_mut(),
            Self::Pgm(file) => file.layout_mut(),
            Self::Webp(file) => file.layout_mut(),
            Self::Raw(file) => file.layout_mut(),
        }
    }

    /// Applies the file's sidecars.
    fn with_sidecars(mut self, source: Source<'a>, max_bytes: u64) -> Self {
        apply_sidecars(source, max_bytes, self.layout_mut());
        if let Self::Tiff(file) = &mut self {
            file.follow_layout();
        }
        self
    }
}

impl Format {
    /// Recognises the format by the first bytes of a file. None if it is not a supported picture.
    /// Raw files have no signature.
    pub fn by_signature(start: &[u8]) -> Option<Self> {
        recognise(start)
    }
}

fn recognise(signature: &[u8]) -> Option<Format> {
    match signature {
        [0x89, b'P', b'N', b'G', ..] => Some(Format::Png),
        [0xff, 0xd8, 0xff, ..] => Some(Format::Jpeg),
        [0x76, 0x2f, 0x31, 0x01, ..] => Some(Format::Exr),
        [b'I', b'I', 42 | 43, 0, ..] | [b'M', b'M', 0, 42 | 43, ..] => Some(Format::Tiff),
        [b'#', b'?', ..] => Some(Format::Hdr),
        [b'R', b'I', b'F', b'F', _, _, _, _, b'W', b'E', b'B', b'P', ..] => Some(Format::Webp),
        [b'P', b'2' | b'3' | b'5' | b'6', after, ..] if after.is_ascii_whitespace() || *after == b'#' => {
            Some(Format::Pgm)
        }
        _ => None,
    }
}
