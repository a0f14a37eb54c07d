//! What goes wrong with slices.

/// Why there are no slices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SliceError {
    /// None are asked for.
    #[error("0 slices show nothing: at least 1 is needed")]
    None,
    /// A corner lies too far away.
    #[error(
        "a corner of a slice lies beyond what 32-bit numbers hold: choose a smaller displacement or mesh"
    )]
    NotFinite,
    /// They were not waited for.
    #[error("cancelled")]
    Cancelled,
}
