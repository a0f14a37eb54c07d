//! What is asked of a picture.

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
}

impl Asked {
    /// Asks for the whole picture in a pane of this size.
    pub const fn whole(pane: [u32; 2]) -> Self {
        Self { pane, part: 1.0, is_quick: false }
    }

    /// Reads a wish in JSON: `width` and `height` of the pane, `part`, and `samples`, `"one"` or `"all"`.
    ///
    /// # Errors
    ///
    /// When the text is another one.
    pub fn of_json(text: &str) -> Result<Self, serde_json::Error> {
        let Wish { width, height, part, samples } = serde_json::from_str(text)?;
        Ok(Self { pane: [width, height], part, is_quick: samples == Samples::One })
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Wish {
    width: u32,
    height: u32,
    part: f64,
    samples: Samples,
}

#[derive(Deserialize, PartialEq)]
#[serde(rename_all = "lowercase")]
enum Samples {
    One,
    All,
}
