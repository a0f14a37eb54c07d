//! Errors of tables of colours.

use relief_core::registry::UnknownName;

use crate::ReadProblem;

/// Reason why a table of colours cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ColorTableProblem {
    /// The file is not a text.
    #[error(
        "is no text, so it holds no table of colours: give lines such as '1200 190 185 135', with elevation, \
         red, green and blue"
    )]
    NoText,
    /// The file is too long.
    #[error("has {bytes} bytes, and tables of colours have at most {most}: give a table of fewer lines")]
    TooLong {
        /// Bytes of the file.
        bytes: u64,
        /// Most bytes.
        most: u64,
    },
    /// There is no entry.
    #[error(
        "has no colour: give lines such as '1200 190 185 135', with elevation, red, green and blue (lines \
         that begin with # are comments)"
    )]
    Empty,
    /// There are too many entries.
    #[error("tables have at most {most} entries: give fewer, colours between entries are interpolated")]
    TooMany {
        /// Most entries.
        most: usize,
    },
    /// A line has too few fields.
    #[error(
        "'{text}' is no entry, with {fields} field{}: give an elevation, and red, green and blue (0 to 255), \
         a name or #rrggbb, as in 200 0 128 64",
        if *fields == 1 { "" } else { "s" }
    )]
    TooFew {
        /// Text of the line.
        text: String,
        /// Number of fields.
        fields: usize,
    },
    /// Nothing stands between two commas.
    #[error("'{text}' has an empty field: give a number between the commas")]
    Gap {
        /// Text of the line.
        text: String,
    },
    /// An elevation is no finite number.
    #[error("the elevation '{0}' is no finite number: give a number, a percentage such as 50%, or nv")]
    BadElevation(
        /// The word.
        String,
    ),
    /// A percentage is not from 0 to 100.
    #[error("the percentage '{0}' is not possible: it must be from 0% to 100%")]
    BadPercentage(
        /// The word.
        String,
    ),
    /// A part of a colour is no whole number from 0 to 255.
    #[error("'{0}' is not possible in a colour: its numbers must be whole and from 0 to 255")]
    BadColor(
        /// The word.
        String,
    ),
    /// A name of a colour is unknown.
    #[error("{0}")]
    UnknownColor(UnknownName),
    /// An elevation is on the wrong side of the one before.
    #[error(
        "{at} comes after {before}, but elevations {} before: sort the lines",
        if *rise { "rise" } else { "fall" }
    )]
    Order {
        /// The elevation, as it is written.
        at: String,
        /// The elevation before it.
        before: String,
        /// Whether the elevations before it rise.
        rise: bool,
    },
    /// A palette of GMT leaves out elevations.
    #[error("begins at {at}, and the line before ends at {before}: close the gap between both")]
    GapOfElevations {
        /// First elevation of the line.
        at: f64,
        /// Last elevation of the line before.
        before: f64,
    },
    /// The colours are interpolated in another way, or in another colour model.
    #[error("says '{said}', which is not supported: {advice}")]
    Unsupported {
        /// Words of the file.
        said: String,
        /// Remedy.
        advice: &'static str,
    },
}

impl ColorTableProblem {
    /// Returns the problem of a file as a whole.
    pub(super) fn whole(self) -> ReadProblem {
        ReadProblem::ColorTable { line: None, problem: Box::new(self) }
    }

    /// Returns the problem of a line, counted from 1.
    pub(super) fn at(self, line: usize) -> ReadProblem {
        ReadProblem::ColorTable { line: Some(line), problem: Box::new(self) }
    }
}
