//! What tells the slices through a relief apart.

/// What changes from one slice through a relief to the next.
///
/// The discriminants are the numbers that the shaders use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub enum SliceAxis {
    /// The height.
    Height = 0,
    /// The texture coordinate `u`.
    U = 1,
    /// The texture coordinate `v`.
    V = 2,
    /// The depth along the view axis, in metres.
    Depth = 3,
}

impl SliceAxis {
    /// Every axis, in the order of the shaders' numbers.
    pub const ALL: [SliceAxis; 4] = [SliceAxis::Height, SliceAxis::U, SliceAxis::V, SliceAxis::Depth];

    /// Its name in the shaders' constants, after `SLICES_ALONG_`.
    pub const fn name(self) -> &'static str {
        match self {
            SliceAxis::Height => "HEIGHT",
            SliceAxis::U => "U",
            SliceAxis::V => "V",
            SliceAxis::Depth => "DEPTH",
        }
    }
}
