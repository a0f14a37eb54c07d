//! What a PNG's chunks say of the picture besides its samples (PNG specification, third edition): how it is
//! turned, by which curve its samples were made, whether it moves.

use std::io::{Read, Seek, SeekFrom};

use crate::exif;
use crate::source::SourceReader;

/// Bytes of the signature; of a chunk's length and type, and of its checksum.
const SIGNATURE: u64 = 8;
const HEAD: usize = 8;
const CHECKSUM: u64 = 4;

/// Bytes of the header, the place of the colour type among them, and the types without an alpha channel.
const HEADER: u64 = 13;
const COLOUR_TYPE: usize = 9;
const GREY: u8 = 0;
const COLOUR: u8 = 2;
const PALETTE: u8 = 3;

/// The most bytes of EXIF metadata that are read. A JPEG's are at most 64 KiB.
const MOST_EXIF: u64 = 1 << 20;

/// The gamma of samples that are proportional to light, in the chunk's unit, and how far others may be from
/// it.
const LINEAR_GAMMA: u32 = 100_000;
const GAMMA_ROUNDING: u32 = 500;

/// The number of samples that are proportional to light among transfer functions (ITU-T H.273).
const LINEAR_TRANSFER: u8 = 8;

/// What the chunks say.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Chunks {
    /// The orientation in EXIF metadata, whatever number it is.
    pub orientation: Option<u32>,
    /// Whether samples are proportional to light.
    pub is_linear: bool,
    /// Whether there is an animation.
    pub is_animated: bool,
    /// The bytes of opacity, and how many its colours allow, where there are more. Decoders of each colour
    /// type make something else of it.
    pub long_opacity: Option<[u64; 2]>,
}

impl Chunks {
    /// Walks all chunks, since EXIF metadata may come last. What cannot be read ends it: the decoder says
    /// what is wrong with the file.
    pub(super) fn read(file: &mut SourceReader<'_>) -> Self {
        let mut found = Found::default();
        // What was found counts, whatever ended the walk.
        let _ = found.walk(file);
        let Found { orientation, gamma, has_curve, transfer, is_animated, .. } = found;
        let long_opacity = found.long_opacity();
        // The first that is there counts, in this order.
        let is_linear = match (transfer, has_curve, gamma) {
            (Some(transfer), ..) => transfer == LINEAR_TRANSFER,
            (None, true, _) => false,
            (None, false, gamma) => gamma.is_some_and(|gamma| gamma.abs_diff(LINEAR_GAMMA) <= GAMMA_ROUNDING),
        };
        Self { orientation, is_linear, is_animated, long_opacity }
    }
}

#[derive(Default)]
struct Found {
    orientation: Option<u32>,
    gamma: Option<u32>,
    /// Whether there is a colour profile or the word that it is sRGB.
    has_curve: bool,
    transfer: Option<u8>,
    is_animated: bool,
    colour_type: Option<u8>,
    /// Bytes of the palette and of its opacities.
    palette_len: Option<u64>,
    opacity_len: Option<u64>,
}

impl Found {
    fn long_opacity(&self) -> Option<[u64; 2]> {
        let most = match self.colour_type? {
            GREY => 2,
            COLOUR => 6,
            PALETTE => self.palette_len? / 3,
            _ => return None,
        };
        self.opacity_len.filter(|&bytes| bytes > most).map(|bytes| [bytes, most])
    }

    fn walk(&mut self, file: &mut SourceReader<'_>) -> std::io::Result<()> {
        file.seek(SeekFrom::Start(SIGNATURE))?;
        loop {
            let mut head = [0; HEAD];
            file.read_exact(&mut head)?;
            let [length, kind] = [0, 4].map(|at| [head[at], head[at + 1], head[at + 2], head[at + 3]]);
            let mut rest = u64::from(u32::from_be_bytes(length));
            match &kind {
                b"IHDR" if rest == HEADER => {
                    let mut header = [0; HEADER as usize];
                    file.read_exact(&mut header)?;
                    self.colour_type = Some(header[COLOUR_TYPE]);
                    rest = 0;
                }
                b"PLTE" => self.palette_len = Some(rest),
                b"tRNS" => self.opacity_len = Some(rest),
                b"eXIf" if rest <= MOST_EXIF => {
                    let mut bytes = Vec::new();
                    file.by_ref().take(rest).read_to_end(&mut bytes)?;
                    self.orientation = self.orientation.or(exif::orientation(&bytes));
                    rest = 0;
                }
                b"gAMA" if rest == 4 => {
                    let mut gamma = [0; 4];
                    file.read_exact(&mut gamma)?;
                    self.gamma = Some(u32::from_be_bytes(gamma));
                    rest = 0;
                }
                b"cICP" if rest == 4 => {
                    let mut code_points = [0; 4];
                    file.read_exact(&mut code_points)?;
                    self.transfer = Some(code_points[1]);
                    rest = 0;
                }
                b"sRGB" | b"iCCP" => self.has_curve = true,
                b"acTL" => self.is_animated = true,
                b"IEND" => return Ok(()),
                _ => {}
            }
            file.seek_relative((rest + CHECKSUM) as i64)?;
        }
    }
}
