//! Errors of heights from normals, and their limits.

use relief_core::{Cancelled, HeightMapError};

/// A normal shorter than this has lost its direction: rounding to 8 bits alone moves its end by up
/// to 0.007.
pub const SHORTEST: f32 = 0.1;

/// Reason why normals give no heights.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FromNormalsError {
    /// The size is invalid for a height map.
    #[error(transparent)]
    Size(#[from] HeightMapError),
    /// A plane does not have one value for each texel.
    #[error(
        "a map of {width}x{height} needs {} values a plane, {given} were given",
        u64::from(*width) * u64::from(*height)
    )]
    WrongLength {
        /// Width in texels.
        width: u32,
        /// Height in texels.
        height: u32,
        /// Values given.
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
        /// Name of the number.
        what: &'static str,
        /// Value given.
        value: f64,
        /// Accepted values.
        must: &'static str,
    },
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Checks that slopes can be limited to this one.
pub(super) fn check_steepest(steepest: f64) -> Result<(), FromNormalsError> {
    if !(steepest > 0.0 && steepest <= 1e6) {
        let (what, must) = ("the steepest slope", "above 0 and at most 1e6");
        return Err(FromNormalsError::BadNumber { what, value: steepest, must });
    }
    Ok(())
}
