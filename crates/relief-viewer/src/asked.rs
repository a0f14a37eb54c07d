//! What is asked of a picture.

use std::ops::Range;

use serde::Deserialize;

/// What is asked of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Asked {
    /// Columns and rows of the pane, for scenes without a size.
    pub pane: [u32; 2],
    /// Factor on both sides, from 0 to 1.
    pub part: f64,
    /// Whether one sample for each pixel is enough.
    pub is_quick: bool,
    /// Part of the rows to be drawn, from 0, at the top, to 1: where it begins and where it ends. Views that
    /// need all pixels at once, and pictures by a GPU, are drawn whole.
    pub rows: [f64; 2],
}

impl Asked {
    /// Asks for the whole picture in a pane of this size.
    pub const fn whole(pane: [u32; 2]) -> Self {
        Self { pane, part: 1.0, is_quick: false, rows: [0.0, 1.0] }
    }

    /// Reads a wish in JSON: `width` and `height` of the pane, `part`, and `samples`, `"one"` or `"all"`;
    /// with `rows`, a part of the rows.
    ///
    /// # Errors
    ///
    /// When the text is another one.
    pub fn of_json(text: &str) -> Result<Self, serde_json::Error> {
        let Wish { width, height, part, samples, rows } = serde_json::from_str(text)?;
        let rows = rows.unwrap_or([0.0, 1.0]);
        Ok(Self { pane: [width, height], part, is_quick: samples == Samples::One, rows })
    }

    /// Returns the rows to be drawn of a picture of this height. Parts that meet share no row.
    pub(crate) fn rows_of(&self, height: u32) -> Range<u32> {
        let [begin, end] = self.rows.map(|part| (part.clamp(0.0, 1.0) * f64::from(height)).round() as u32);
        begin..end.max(begin)
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Wish {
    width: u32,
    height: u32,
    part: f64,
    samples: Samples,
    rows: Option<[f64; 2]>,
}

#[derive(Deserialize, PartialEq)]
#[serde(rename_all = "lowercase")]
enum Samples {
    One,
    All,
}
