//! What a file's header says: the format, the channels, how samples are stored; and how decoders hand samples
//! over.

use crate::ReadProblem;
use crate::elevation::{Elevation, Georeference};
use crate::georeference::{Facts, GivenUnits, Grid};
use crate::omissions::{NO_ORIENTATION, ORIENTATION_ON_GROUND, Remark};
use crate::orientation::Orientation;

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
    /// WebP, 8 bit, lossy or lossless; of an animation its first picture.
    Webp,
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
            Format::Webp => "WebP",
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
    /// The raw value that stands for 1, for unsigned samples of at most 16 bit; none where the range of the
    /// values decides.
    pub full_scale: Option<f64>,
    /// The raw value that marks a texel without a value.
    pub nodata: Option<f64>,
    /// Whether the file says that integers are proportional to light.
    pub is_linear: bool,
    /// The orientation that the file names by a number of EXIF or TIFF, if it names one, whatever it is.
    pub stated_orientation: Option<u32>,
    /// How the stored picture is turned to be shown.
    pub orientation: Orientation,
    /// What the file says of the ground and of the metres of its values. An error, with the reason, where
    /// what it says cannot be; that stops who reads heights, not who reads a picture.
    pub terrain: Result<Option<Terrain>, String>,
    /// What that follows from.
    pub facts: Facts,
    /// What the format's reader leaves out or assumes, for notes.
    pub remarks: Vec<Remark>,
}

/// What makes a file an elevation model.
#[derive(Clone, Debug)]
pub(crate) struct Terrain {
    /// Where the map lies on the ground, if the file says so.
    pub georeference: Option<Georeference>,
    /// What the values of each channel stand for.
    pub channels: Vec<Elevation>,
    /// Size of a texel along `u` and `v` in the unit that ground and heights share, where nobody names it.
    pub relative_texel_size: Option<[f64; 2]>,
}

impl Terrain {
    /// Size of a texel along `u` and `v` in metres, where it is known.
    pub(crate) fn texel_size_m(&self) -> Option<[f64; 2]> {
        self.georeference.as_ref()?.texel_size_m.clone().ok()
    }
}

impl Layout {
    /// A layout whose channels are all stored alike, without georeference; unsigned samples are divided by
    /// their type's maximum.
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

    /// Takes what is said of ground and heights.
    pub(crate) fn set_facts(&mut self, facts: Result<Facts, String>) {
        match facts {
            Ok(facts) => {
                self.terrain = facts.terrain(self.channels.len(), None);
                self.facts = facts;
            }
            Err(what) => self.terrain = Err(what),
        }
    }

    /// Puts the units that a user gives, if any, in the place of the file's.
    pub(crate) fn give_units(&mut self, units: Option<GivenUnits>) {
        if units.is_some() && self.terrain.is_ok() {
            self.terrain = self.facts.terrain(self.channels.len(), units);
        }
    }

    /// The same picture as it is shown.
    ///
    /// On the ground north is on top and east to the right. What the file says of its orientation does not
    /// count there, as the place is given for the grid as it is stored.
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
                        "it names the orientation {number} and a place on the ground: its rows are read as \
                         the place says"
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
                        "it names the orientation {number}, which is none of 1 to 8: the picture is read as \
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

    /// The number of EXIF or TIFF by which the picture is turned; none where it is shown as it is stored.
    pub(crate) fn turning_number(&self) -> Option<u32> {
        let is_followed =
            |number: &u32| *number != 1 && Orientation::of_number(*number) == Some(self.orientation);
        self.stated_orientation.filter(is_followed)
    }

    /// What the file says as an elevation model; none where it is none.
    pub(crate) fn terrain(&self) -> Result<Option<&Terrain>, ReadProblem> {
        self.terrain
            .as_ref()
            .map(Option::as_ref)
            .map_err(|what| ReadProblem::Georeference { what: what.clone() })
    }

    /// Whether it is an elevation model.
    pub(crate) fn is_elevation(&self) -> bool {
        matches!(self.terrain, Ok(Some(_)))
    }

    /// The raw value that stands for height 1; none where the range of the values decides, as in every
    /// elevation model.
    pub(crate) fn height_full_scale(&self) -> Option<f64> {
        self.full_scale.filter(|_| matches!(self.terrain, Ok(None)))
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

/// Samples of one stored row, or of a part of it: texel `k` of the span lies in column `column + k * step`.
pub(crate) struct Span<'a> {
    pub row: u32,
    pub column: u32,
    pub step: u32,
    /// Raw values, the chosen channels side by side.
    pub samples: &'a [f64],
}

/// Takes the spans of a picture; every texel comes exactly once, in the decoder's order.
pub(crate) type Sink<'a> = dyn FnMut(Span<'_>) -> Result<(), ReadProblem> + 'a;

/// Hands over the rows of a picture that is decoded as bytes, with the chosen channels: `row_len`
/// bytes a row, `texel_len` bytes a texel.
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
