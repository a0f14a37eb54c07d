//! Why normals give no heights, and the limits that decide.

use relief_core::{Cancelled, HeightMapError};

/// A normal shorter than this has lost its direction: rounding to 8 bit alone moves its end by up to 0.007.
pub const SHORTEST: f32 = 0.1;

/// Why normals give no heights.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FromNormalsError {
    /// The size is not that of a height map.
    #[error(transparent)]
    Size(#[from] HeightMapError),
    /// A plane has not one value for each texel.
    #[error("a map of {width}x{height} needs {} values a plane, {given} were given", u64::from(*width) * u64::from(*height))]
    WrongLength {
        /// Width in texels.
        width: u32,
        /// Height in texels.
        height: u32,
        /// How many were given.
        given: usize,
    },
    /// A value is NaN or infinite.
    #[error("the value at texel ({column}, {row}) is not finite")]
    NotFinite {
        /// Column of the first such texel.
        column: u32,
        /// Row of the first such texel.
        row: u32,
    },
    /// No normal has a direction.
    #[error("no normal has a direction: all are shorter than {SHORTEST} or not finite")]
    NoDirection,
    /// A number of the integration cannot be used.
    #[error("{what} is {value}: it must be {must}")]
    BadNumber {
        /// Which number.
        what: &'static str,
        /// Its value.
        value: f64,
        /// What it must be.
        must: &'static str,
    },
    /// It was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Whether slopes can be limited to that one.
pub(super) fn check_steepest(steepest: f64) -> Result<(), FromNormalsError> {
    if !(steepest > 0.0 && steepest <= 1e6) {
        let (what, must) = ("the steepest slope", "above 0 and at most 1e6");
        return Err(FromNormalsError::BadNumber { what, value: steepest, must });
    }
    Ok(())
}
