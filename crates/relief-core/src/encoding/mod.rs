//! How values are stored in fewer bits, or in another form, without breaking what was promised of them.

pub mod code;
pub mod cone;
pub mod half;
pub mod seen_normal;

/// Which side a stored value may be rounded to without breaking the map's guarantee.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rounding {
    /// To the nearest: the map makes no one-sided promise.
    Nearest,
    /// Downward: a smaller value is safe.
    Down,
    /// Upward: a larger value is safe.
    Up,
}
