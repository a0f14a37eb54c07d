//! Errors of slices.

use relief_core::Cancelled;

/// Reason why there are no slices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SliceError {
    /// All slices would lie in one place.
    #[error(
        "its slices would lie in one place: they need a displacement, and texture coordinates that define \
         their spacing"
    )]
    NoSpacing,
    /// No border of a texture clips the slices.
    #[error(
        "no border of a texture clips its slices: they need the wrap 'clamp' and at most 256 flat \
         polygons that each show the whole map once"
    )]
    NoBorder,
    /// A corner lies beyond the range of `f32`.
    #[error(
        "a corner of a slice lies beyond the range of 32-bit numbers: choose a smaller displacement or mesh"
    )]
    NotFinite,
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
