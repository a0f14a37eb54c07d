//! Registry entry of the shadow `none`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// No shadows.
pub const ENTRY: Entry = Entry {
    name: "none",
    summary: "no shadows: nothing is in a light's way",
    publication: Publication { paper: super::SURVEY, section: "6" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Right where the relief casts no shadow.",
    role: Role::Idle,
};
