//! Registry entry of the ambient light `constant`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::SURVEY;
use crate::entry::{Entry, Role};

/// Constant light, the same everywhere.
pub const ENTRY: Entry = Entry {
    name: "constant",
    summary: "the same light everywhere, as if the relief hid none of the sky",
    publication: Publication { paper: SURVEY, section: "2.1" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Right on ground as level as the base.",
    role: Role::Plain,
};
