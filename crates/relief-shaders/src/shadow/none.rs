//! Registry entry of the shadow `none`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// Nothing is in a light's way.
pub const ENTRY: Entry = Entry {
    name: "none",
    summary: "nothing is in a light's way",
    publication: Publication { paper: super::SURVEY, section: "6" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Right where the relief throws no shadow.",
    role: Role::Idle,
};
