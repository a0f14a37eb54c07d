//! Letters in pictures: characters of one width, as coverages of pixels.

use noto_sans_mono_bitmap::{FontWeight, RasterHeight, get_raster, get_raster_width};

/// Stands for characters that the font lacks.
const UNKNOWN: char = '?';

/// Height of a line of text in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GlyphSize {
    /// 16 pixels.
    Small,
    /// 24 pixels.
    Medium,
    /// 32 pixels.
    Large,
}

impl GlyphSize {
    const fn raster(self) -> RasterHeight {
        match self {
            GlyphSize::Small => RasterHeight::Size16,
            GlyphSize::Medium => RasterHeight::Size24,
            GlyphSize::Large => RasterHeight::Size32,
        }
    }

    /// Returns the height of a line in pixels.
    pub const fn height(self) -> u32 {
        self.raster().val() as u32
    }

    /// Returns the width of a character in pixels.
    pub fn advance(self) -> u32 {
        get_raster_width(FontWeight::Regular, self.raster()) as u32
    }

    /// Calls `put` for each pixel of a line of text, with its column and row from the upper left
    /// corner of the text and its coverage from 1 to 255. Characters without a glyph are question
    /// marks.
    ///
    /// ```
    /// use relief_render::glyphs::GlyphSize;
    ///
    /// let mut inked = 0;
    /// GlyphSize::Small.draw("relief", |[x, y], _| {
    ///     assert!(x < 6 * GlyphSize::Small.advance() && y < 16);
    ///     inked += 1;
    /// });
    /// assert!(inked > 100);
    /// ```
    pub fn draw(self, text: &str, mut put: impl FnMut([u32; 2], u8)) {
        let raster = |character| get_raster(character, FontWeight::Regular, self.raster());
        for (character, left) in text.chars().zip((0..).step_by(self.advance() as usize)) {
            let Some(glyph) = raster(character).or_else(|| raster(UNKNOWN)) else { continue };
            for (y, row) in (0..).zip(glyph.rows()) {
                for (x, &coverage) in (left..).zip(row).filter(|(_, coverage)| **coverage > 0) {
                    put([x, y], coverage);
                }
            }
        }
    }
}

/// Returns a channel with ink over it that covers a part of the pixel.
pub fn inked(below: u8, ink: u8, coverage: u8) -> u8 {
    let [below, ink, coverage] = [below, ink, coverage].map(u32::from);
    ((below * (255 - coverage) + ink * coverage + 127) / 255) as u8
}
