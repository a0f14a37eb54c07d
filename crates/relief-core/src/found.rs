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
    /// `far` is below the surface; how far before it the surface was crossed is not known: `near` is the
    /// entry.
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

impl FoundState {
    /// Every state, in the order of the shaders' numbers.
    pub const ALL: [FoundState; 7] = [
        FoundState::Miss,
        FoundState::Above,
        FoundState::Below,
        FoundState::Bracket,
        FoundState::Exhausted,
        FoundState::StartedBelow,
        FoundState::Unbracketed,
    ];

    /// What is known then, in a few words.
    pub const fn description(self) -> &'static str {
        match self {
            FoundState::Miss => "a miss",
            FoundState::Above => "a point above the surface",
            FoundState::Below => "a point below the surface",
            FoundState::Bracket => "a bracket",
            FoundState::Exhausted => "the point where the steps ran out",
            FoundState::StartedBelow => "a start below the surface",
            FoundState::Unbracketed => "a path of which nothing is known",
        }
    }

    /// Its name in the shaders' constants, after `FOUND_`.
    pub const fn name(self) -> &'static str {
        match self {
            FoundState::Miss => "MISS",
            FoundState::Above => "ABOVE",
            FoundState::Below => "BELOW",
            FoundState::Bracket => "BRACKET",
            FoundState::Exhausted => "EXHAUSTED",
            FoundState::StartedBelow => "STARTED_BELOW",
            FoundState::Unbracketed => "UNBRACKETED",
        }
    }
}
