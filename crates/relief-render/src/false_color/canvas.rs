//! Canvas of sRGB pixels, with text.

use crate::glyphs::{GlyphSize, inked};

/// Colour of paper and of text.
const PAPER: [u8; 3] = [255; 3];
const INK: [u8; 3] = [26; 3];

/// The two colours of the pattern that marks pixels without a surface, and its period in pixels.
const HATCH: [[u8; 3]; 2] = [[244; 3], [214; 3]];
const HATCH_PERIOD: u32 = 8;

/// Returns the colour of a pixel without a surface, a part of a pattern.
pub fn hatched([x, y]: [u32; 2]) -> [u8; 3] {
    let is_line = (x + y) % HATCH_PERIOD < HATCH_PERIOD / 4;
    HATCH[usize::from(is_line)]
}

/// Size of text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TextSize {
    /// Letters of 16 pixels.
    Small,
    /// Letters of 32 pixels, for large pictures.
    Large,
}

impl TextSize {
    const fn glyphs(self) -> GlyphSize {
        match self {
            TextSize::Small => GlyphSize::Small,
            TextSize::Large => GlyphSize::Large,
        }
    }

    /// Returns the height of a line in pixels.
    pub const fn height(self) -> u32 {
        self.glyphs().height()
    }

    /// Returns the width of a text in pixels.
    pub fn width(self, text: &str) -> u32 {
        text.chars().count() as u32 * self.glyphs().advance()
    }
}

/// Picture in 8-bit sRGB that is drawn on. What lies outside is cut off.
#[derive(Clone, Debug, PartialEq)]
pub struct Canvas {
    size: [u32; 2],
    pixels: Vec<[u8; 3]>,
}

impl Canvas {
    /// Creates a white canvas of the given columns and rows.
    pub(super) fn new(size: [u32; 2]) -> Self {
        let count = size.map(|side| side as usize).iter().product();
        Self { size, pixels: vec![PAPER; count] }
    }

    /// Returns the numbers of columns and rows.
    pub fn size(&self) -> [u32; 2] {
        self.size
    }

    /// Returns the pixels, row by row from the top.
    pub fn pixels(&self) -> &[[u8; 3]] {
        &self.pixels
    }

    /// Returns the rows from the top, with parts from 0 to 1, as writers of pictures take them.
    pub fn rows(&self) -> impl Iterator<Item = Vec<[f32; 3]>> + '_ {
        let width = self.size[0].max(1) as usize;
        let part = |byte: u8| f32::from(byte) / 255.0;
        self.pixels.chunks(width).map(move |row| row.iter().map(|pixel| pixel.map(part)).collect())
    }

    /// Sets a pixel.
    pub(super) fn set(&mut self, [x, y]: [u32; 2], color: [u8; 3]) {
        if x < self.size[0] && y < self.size[1] {
            self.pixels[y as usize * self.size[0] as usize + x as usize] = color;
        }
    }

    /// Marks a pixel as one without a surface, by its part of a pattern.
    pub(super) fn hatch(&mut self, at: [u32; 2]) {
        self.set(at, hatched(at));
    }

    /// Draws the outline of a rectangle around its pixels.
    pub(super) fn frame(&mut self, [left, top]: [u32; 2], [width, height]: [u32; 2]) {
        for x in left.saturating_sub(1)..=left + width {
            self.set([x, top.saturating_sub(1)], INK);
            self.set([x, top + height], INK);
        }
        for y in top..top + height {
            self.set([left.saturating_sub(1), y], INK);
            self.set([left + width, y], INK);
        }
    }

    /// Draws a vertical line down from a pixel.
    pub(super) fn line(&mut self, [x, y]: [u32; 2], length: u32) {
        (y..y + length).for_each(|y| self.set([x, y], INK));
    }

    /// Draws a text from its upper left corner. Characters without a glyph are question marks.
    pub(super) fn text(&mut self, [left, top]: [u32; 2], text: &str, size: TextSize) {
        size.glyphs().draw(text, |[x, y], coverage| {
            if let Some(at) = self.place([left + x, top + y]) {
                let below = self.pixels[at];
                self.pixels[at] = [0, 1, 2].map(|part| inked(below[part], INK[part], coverage));
            }
        });
    }

    fn place(&self, [x, y]: [u32; 2]) -> Option<usize> {
        let is_inside = x < self.size[0] && y < self.size[1];
        is_inside.then(|| y as usize * self.size[0] as usize + x as usize)
    }
}
