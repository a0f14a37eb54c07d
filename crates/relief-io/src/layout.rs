//! Header of a file: format, channels and sample types; and the interface by which decoders pass on
//! samples.

use std::path::Path;

use crate::ReadProblem;
use crate::elevation::{Elevation, Georeference};
use crate::georeference::{Facts, GivenUnits, Grid};
use crate::omissions::{NO_ORIENTATION, ORIENTATION_ON_GROUND, Remark};
use crate::orientation::Orientation;

/// Supported file format of height maps and pictures.
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
    /// WebP, 8 bit, lossy or lossless; the first picture of an animation.
    Webp,
    /// 16-bit samples without a header.
    Raw,
}

/// File extensions of height maps and pictures.
const ENDINGS: [(&str, Format); 14] = [
    ("png", Format::Png),
    ("jpg", Format::Jpeg),
    ("jpeg", Format::Jpeg),
    ("exr", Format::Exr),
    ("tif", Format::Tiff),
    ("tiff", Format::Tiff),
    ("hdr", Format::Hdr),
    ("pgm", Format::Pgm),
    ("ppm", Format::Pgm),
    ("pnm", Format::Pgm),
    ("webp", Format::Webp),
    ("raw", Format::Raw),
    ("r16", Format::Raw),
    ("bin", Format::Raw),
];

impl Format {
    /// Returns the format that a file's extension, in upper or lower case, stands for. None if it is
    /// not one of a picture. Readers recognise all formats but raw by the content instead.
    pub fn by_name(path: &Path) -> Option<Self> {
        Self::by_ending(path.extension()?.to_str()?)
    }

    /// Returns the format that an extension stands for.
    pub(crate) fn by_ending(ending: &str) -> Option<Self> {
        ENDINGS.into_iter().find(|(known, _)| known.eq_ignore_ascii_case(ending)).map(|(_, format)| format)
    }

    /// Returns the format's common name.
    pub const fn name(self) -> &'static str {
        match self {
            Format::Png => "PNG",
            Format::Jpeg => "JPEG",
            Format::Exr => "EXR",
            Format::Tiff => "TIFF",
            Format::Hdr => "Radiance HDR",
            Format::Pgm => "PGM",
            Format::Webp => "WebP",
            Format::Raw => "raw",
        }
    }
}

/// Number type of a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SampleKind {
    /// Integer from 0.
    Unsigned,
    /// Integer in two's complement.
    Signed,
    /// IEEE float (or, in Radiance files, a shared exponent).
    Float,
}

/// Number type and depth of a sample.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SampleType {
    /// Integer or float.
    pub kind: SampleKind,
    /// Bits per sample.
    pub bits: u8,
}

impl SampleType {
    pub(crate) const fn unsigned(bits: u8) -> Self {
        Self { kind: SampleKind::Unsigned, bits }
    }

    pub(crate) const fn float(bits: u8) -> Self {
        Self { kind: SampleKind::Float, bits }
    }

    /// Whether `f32` holds every sample exactly.
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

/// Channel of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Channel {
    /// Name: as stored in EXR files; `y`, `r`, `g`, `b`, `a`, or `band1` and so on in others.
    pub name: String,
    /// Type of its samples.
    pub sample: SampleType,
}

/// Header of a file's picture.
#[derive(Clone, Debug)]
pub(crate) struct Layout {
    pub format: Format,
    pub width: u32,
    pub height: u32,
    /// Channels, in the file's order.
    pub channels: Vec<Channel>,
    /// Raw value of 1, for unsigned samples of at most 16 bit; none if the range of the values
    /// decides.
    pub full_scale: Option<f64>,
    /// Nodata value: the raw value that marks a texel without a value.
    pub nodata: Option<f64>,
    /// Whether the file declares its integers as proportional to light.
    pub is_linear: bool,
    /// Orientation number of EXIF or TIFF that the file states, of any value; none if it states
    /// none.
    pub stated_orientation: Option<u32>,
    /// Transform from the stored picture to the displayed one.
    pub orientation: Orientation,
    /// Georeference and units of the values. An error, with the reason, if they are impossible;
    /// that stops readers of heights, but not of pictures.
    pub terrain: Result<Option<Terrain>, String>,
    /// Facts from which `terrain` is derived.
    pub facts: Facts,
    /// Notes on everything that the format's reader ignores or assumes.
    pub remarks: Vec<Remark>,
}

/// Data of an elevation model.
#[derive(Clone, Debug)]
pub(crate) struct Terrain {
    /// Position of the map on the ground, if the file gives it.
    pub georeference: Option<Georeference>,
    /// Meaning of the values of each channel.
    pub channels: Vec<Elevation>,
    /// Size of a texel along `u` and `v` in the unit that ground and heights share, if nobody names
    /// it.
    pub relative_texel_size: Option<[f64; 2]>,
}

impl Terrain {
    /// Size of a texel along `u` and `v` in metres, if known.
    pub(crate) fn texel_size_m(&self) -> Option<[f64; 2]> {
        self.georeference.as_ref()?.texel_size_m.clone().ok()
    }
}

impl Layout {
    /// Creates a layout whose channels all have the same sample type, without georeference.
    /// Unsigned samples are divided by their type's maximum.
    pub(crate) fn new(format: Format, [width, height]: [u32; 2], names: &[&str], sample: SampleType) -> Self {
        let channel = |name: &&str| Channel { name: (*name).to_owned(), sample };
        let full_scale = match sample.kind {
            SampleKind::Unsigned if sample.bits <= 16 => Some(f64::from((1u32 << sample.bits) - 1)),
            _ => None,
        };
        let channels = names.iter().map(channel).collect();
        Self {
            format,
            width,
            height,
            channels,
            full_scale,
            nodata: None,
            is_linear: false,
            stated_orientation: None,
            orientation: Orientation::STORED,
            remarks: Vec::new(),
            terrain: Ok(None),
            facts: Facts::default(),
        }
    }

    /// Sets the facts about ground and heights.
    pub(crate) fn set_facts(&mut self, facts: Result<Facts, String>) {
        match facts {
            Ok(facts) => {
                self.terrain = facts.terrain(self.channels.len(), None);
                self.facts = facts;
            }
            Err(what) => self.terrain = Err(what),
        }
    }

    /// Replaces the file's units by those that a user gives, if any.
    pub(crate) fn give_units(&mut self, units: Option<GivenUnits>) {
        if units.is_some() && self.terrain.is_ok() {
            self.terrain = self.facts.terrain(self.channels.len(), units);
        }
    }

    /// Turns the layout of the stored picture into the displayed picture's.
    ///
    /// A georeferenced map has north on top and east to the right. Its stated orientation is
    /// ignored, since the georeference refers to the grid as it is stored.
    pub(crate) fn shown(mut self) -> Self {
        let terrain = self.terrain.as_ref().ok().and_then(Option::as_ref);
        let on_ground = terrain.and_then(|terrain| terrain.georeference.as_ref());
        let of_grid = || self.facts.grid.as_ref().map(Grid::turned_over);
        let on_ground = on_ground.map(|georeference| georeference.turned_over).or_else(of_grid);
        let stated = self.stated_orientation;
        let note = match (on_ground, stated) {
            (Some(turned_over), stated) => {
                self.orientation = Orientation { turned_over, transposed: false };
                let is_turned = |number: &u32| *number != 1;
                stated.filter(is_turned).map(|number| {
                    let text = format!(
                        "it names the orientation {number} and has a georeference: its rows are read as \
                         the georeference says"
                    );
                    Remark::new(&ORIENTATION_ON_GROUND, text)
                })
            }
            (None, Some(number)) => match Orientation::of_number(number) {
                Some(orientation) => {
                    self.orientation = orientation;
                    None
                }
                None => {
                    let text = format!(
                        "it names the orientation {number}, but only 1 to 8 exist: the picture is read as \
                         it is stored"
                    );
                    Some(Remark::new(&NO_ORIENTATION, text))
                }
            },
            (None, None) => None,
        };
        self.remarks.extend(note);
        [self.width, self.height] = self.orientation.shown([self.width, self.height]);
        self
    }

    /// Returns the orientation number by which the picture is turned; none if it is displayed as
    /// stored.
    pub(crate) fn turning_number(&self) -> Option<u32> {
        let is_followed =
            |number: &u32| *number != 1 && Orientation::of_number(*number) == Some(self.orientation);
        self.stated_orientation.filter(is_followed)
    }

    /// Returns the data of an elevation model; none if the file is not one.
    pub(crate) fn terrain(&self) -> Result<Option<&Terrain>, ReadProblem> {
        self.terrain
            .as_ref()
            .map(Option::as_ref)
            .map_err(|what| ReadProblem::Georeference { what: what.clone() })
    }

    /// Whether the file is an elevation model.
    pub(crate) fn is_elevation(&self) -> bool {
        matches!(self.terrain, Ok(Some(_)))
    }

    /// Returns the raw value of height 1; none if the range of the values decides, as in every
    /// elevation model.
    pub(crate) fn height_full_scale(&self) -> Option<f64> {
        self.full_scale.filter(|_| matches!(self.terrain, Ok(None)))
    }

    /// Finds a channel by its name, in any case.
    pub(crate) fn channel(&self, name: &str) -> Option<usize> {
        self.channels.iter().position(|channel| channel.name.eq_ignore_ascii_case(name))
    }

    /// Returns the channels' names, in the file's order.
    pub(crate) fn channel_names(&self) -> Vec<String> {
        self.channels.iter().map(|channel| channel.name.clone()).collect()
    }
}

/// Samples of a stored row, or of a part of it: texel `k` of the span is in column `column + k *
/// step`.
pub(crate) struct Span<'a> {
    pub row: u32,
    pub column: u32,
    pub step: u32,
    /// Raw values, the chosen channels interleaved.
    pub samples: &'a [f64],
}

/// Receiver of the spans of a picture. Every texel comes exactly once, in the decoder's order.
pub(crate) type Sink<'a> = dyn FnMut(Span<'_>) -> Result<(), ReadProblem> + 'a;

/// Sends the rows of a picture that is decoded as bytes to a sink, with the chosen channels. A row
/// has `row_len` bytes and a texel `texel_len` bytes.
pub(crate) fn send_bytes(
    bytes: &[u8],
    [row_len, texel_len]: [usize; 2],
    channels: &[usize],
    sink: &mut Sink<'_>,
) -> Result<(), ReadProblem> {
    let mut samples = Vec::with_capacity(row_len / texel_len * channels.len());
    for (row, texels) in (0..).zip(bytes.chunks_exact(row_len)) {
        samples.clear();
        for texel in texels.chunks_exact(texel_len) {
            samples.extend(channels.iter().map(|&channel| f64::from(texel[channel])));
        }
        sink(Span { row, column: 0, step: 1, samples: &samples })?;
    }
    Ok(())
}
