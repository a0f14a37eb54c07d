//! Storage of values in fewer bits or in another form, so that the guarantees of maps still hold.

pub mod code;
pub mod cone;
pub mod half;
pub mod seen_normal;

/// Direction in which a stored value may be rounded without breaking the map's guarantee.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// To the nearest: the map makes no one-sided promise.
    Nearest,
    /// Downward: a smaller value is safe.
    Down,
    /// Upward: a larger value is safe.
    Up,
}
