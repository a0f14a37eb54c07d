//! Results of a search, as the refinement receives them.

/// Result of a search along a path.
///
/// The discriminants are the numbers that the shaders use. `near` and `far` are the two points of
/// the path that the search hands to the refinement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum FoundState {
    /// The path leaves the map without touching the surface.
    Miss = 0,
    /// `near` is above the surface or on it, and no hit lies before it. `far` is the end of the
    /// path.
    Above = 1,
    /// `far` is below the surface and `near` is the entry. The path may cross the surface anywhere
    /// between them.
    Below = 2,
    /// `near` is above the surface and `far` is below it.
    Bracket = 3,
    /// The search ran out of steps at `near`, above the surface. The rest of the path is not
    /// searched.
    Exhausted = 4,
    /// The path begins below the surface.
    StartedBelow = 5,
    /// No search took place: `near` and `far` are the entry and the exit.
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

    /// Describes the result in a few words.
    pub const fn description(self) -> &'static str {
        match self {
            FoundState::Miss => "a miss",
            FoundState::Above => "a point above the surface",
            FoundState::Below => "a point below the surface",
            FoundState::Bracket => "a bracket",
            FoundState::Exhausted => "the point where the steps ran out",
            FoundState::StartedBelow => "a start below the surface",
            FoundState::Unbracketed => "an unsearched path",
        }
    }

    /// Name in the shaders' constants, after `FOUND_`.
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
