//! The coordinate along which the slices through a relief are spaced.

/// Coordinate that differs between the slices through a relief.
///
/// The discriminants are the numbers that the shaders use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum SliceAxis {
    /// Height.
    Height = 0,
    /// Texture coordinate `u`.
    U = 1,
    /// Texture coordinate `v`.
    V = 2,
    /// Depth along the view axis, in metres.
    Depth = 3,
}

impl SliceAxis {
    /// All axes, in the order of the shaders' numbers.
    pub const ALL: [SliceAxis; 4] = [SliceAxis::Height, SliceAxis::U, SliceAxis::V, SliceAxis::Depth];

    /// Name in the shaders' constants, after `SLICES_ALONG_`.
    pub const fn name(self) -> &'static str {
        match self {
            SliceAxis::Height => "HEIGHT",
            SliceAxis::U => "U",
            SliceAxis::V => "V",
            SliceAxis::Depth => "DEPTH",
        }
    }
}
