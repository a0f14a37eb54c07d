//! What a search knows when it ends.

/// How a search ended.
///
/// The discriminants are the numbers that the shaders use.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum FoundState {
    /// The path leaves without touching the surface.
    Miss = 0,
    /// `near` is above the surface (or on it) and nothing lies before it; `far` is the end of the path.
    Above = 1,
    /// `far` is below the surface; how far before it the surface was crossed is not known: `near` is the entry.
    Below = 2,
    /// `near` is above the surface and `far` is below it.
    Bracket = 3,
    /// The steps ran out at `near`, above the surface, with the rest of the path unexplored.
    Exhausted = 4,
    /// The path began below the surface.
    StartedBelow = 5,
    /// Nothing was searched: `near` and `far` are the entry and the exit.
    Unbracketed = 6,
}

/// A search's result: parameters along the path, in `[0, exit]`, and what is known of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Found {
    /// How the search ended.
    pub state: FoundState,
    /// The last parameter known to be above the surface.
    pub near: f32,
    /// The first parameter known to be below the surface, or the end of what is left to look at.
    pub far: f32,
    /// Height of the path above the surface at `near`.
    pub near_gap: f32,
    /// Height of the path above the surface at `far`; negative below.
    pub far_gap: f32,
    /// Height reads so far.
    pub reads: u32,
}
