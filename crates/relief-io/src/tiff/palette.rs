//! Colours of a palette (TIFF 6.0, tag ColorMap).

use tiff_reader::{ColorModel, Ifd};

use super::problem;
use crate::ReadProblem;

/// Greatest byte, and the factor that extends it to 16 bits.
const BYTE: u16 = 255;
const BYTE_STEP: u16 = 257;

/// Palette: red, green and blue for each sample.
pub(super) struct Palette {
    colours: [Vec<u16>; 3],
    /// Bits of a colour: 8 or 16.
    pub bits: u8,
    /// Whether the samples themselves are a channel, before the colours.
    pub has_index: bool,
}

impl Palette {
    /// Reads the palette of a picture; none if it has none.
    pub(super) fn read(header: &Ifd) -> Result<Option<Self>, ReadProblem> {
        let ColorModel::Palette { color_map, .. } = header.color_model().map_err(problem)? else {
            return Ok(None);
        };
        let mut colours = [color_map.red(), color_map.green(), color_map.blue()].map(<[u16]>::to_vec);
        let all = |is: fn(u16) -> bool| colours.iter().flatten().all(|&part| is(part));
        // Colours of 16 bits mostly hold bytes: repeated, above zeros, or unscaled as old programs
        // write them.
        let step = match () {
            () if all(|part| part <= BYTE) => Some(1),
            () if all(|part| part.is_multiple_of(BYTE_STEP)) => Some(BYTE_STEP),
            () if all(|part| part.is_multiple_of(BYTE + 1)) => Some(BYTE + 1),
            () => None,
        };
        if let Some(step) = step {
            colours.iter_mut().flatten().for_each(|part| *part /= step);
        }
        Ok(Some(Self { colours, bits: if step.is_some() { 8 } else { 16 }, has_index: false }))
    }

    /// Names of the palette's channels.
    pub(super) fn channels(&self) -> &'static [&'static str] {
        if self.has_index { &["index", "r", "g", "b"] } else { &["r", "g", "b"] }
    }

    /// Converts a sample to a channel's value.
    pub(super) fn sample(&self, channel: usize, index: f64) -> f64 {
        let colour = if self.has_index { channel.checked_sub(1) } else { Some(channel) };
        let plane = colour.and_then(|colour| self.colours.get(colour));
        plane.map_or(index, |plane| plane.get(index as usize).copied().map_or(0.0, f64::from))
    }
}
