//! Facts from a PNG's chunks other than its samples (PNG specification, third edition):
//! orientation, transfer curve and animation.

use std::io::{Read, Seek, SeekFrom};

use crate::exif;
use crate::source::SourceReader;

/// Bytes of the signature, of a chunk's length and type, and of its checksum.
const SIGNATURE: u64 = 8;
const HEAD: usize = 8;
const CHECKSUM: u64 = 4;

/// Bytes of the header, offset of the colour type, and colour types without an alpha channel.
const HEADER: u64 = 13;
const COLOUR_TYPE: usize = 9;
const GREY: u8 = 0;
const COLOUR: u8 = 2;
const PALETTE: u8 = 3;

/// Greatest number of bytes of EXIF metadata that are read. A JPEG's are at most 64 KiB.
const MOST_EXIF: u64 = 1 << 20;

/// Gamma of samples that are proportional to light, in the chunk's unit, and its tolerance.
const LINEAR_GAMMA: u32 = 100_000;
const GAMMA_ROUNDING: u32 = 500;

/// Code of linear samples among transfer functions (ITU-T H.273).
const LINEAR_TRANSFER: u8 = 8;

/// Facts from the chunks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Chunks {
    /// Orientation number in EXIF metadata, of any value.
    pub orientation: Option<u32>,
    /// Whether samples are proportional to light.
    pub is_linear: bool,
    /// Whether the file is animated.
    pub is_animated: bool,
    /// Number of bytes of opacity, and the greatest number that the colours allow, if there are
    /// more. Decoders treat them differently for each colour type.
    pub long_opacity: Option<[u64; 2]>,
}

impl Chunks {
    /// Walks all chunks, since EXIF metadata may come last. An error only ends the walk: the
    /// decoder reports faults of the file.
    pub(super) fn read(file: &mut SourceReader<'_>) -> Self {
        let mut facts = ChunkFacts::default();
        // Chunks before an error count.
        let _ = facts.walk(file);
        let ChunkFacts { orientation, gamma, has_curve, transfer, is_animated, .. } = facts;
        let long_opacity = facts.long_opacity();
        // The first one present counts, in this order.
        let is_linear = match (transfer, has_curve, gamma) {
            (Some(transfer), ..) => transfer == LINEAR_TRANSFER,
            (None, true, _) => false,
            (None, false, gamma) => gamma.is_some_and(|gamma| gamma.abs_diff(LINEAR_GAMMA) <= GAMMA_ROUNDING),
        };
        Self { orientation, is_linear, is_animated, long_opacity }
    }
}

#[derive(Default)]
struct ChunkFacts {
    orientation: Option<u32>,
    gamma: Option<u32>,
    /// Whether there is a colour profile or an sRGB chunk.
    has_curve: bool,
    transfer: Option<u8>,
    is_animated: bool,
    colour_type: Option<u8>,
    /// Bytes of the palette and of its opacities.
    palette_len: Option<u64>,
    opacity_len: Option<u64>,
}

impl ChunkFacts {
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
