//! Registry entry of the shadow `none`.

use relief_core::registry::{Entry, Guarantee, Guarantees, Publication};

/// Nothing is in a light's way.
pub const ENTRY: Entry = Entry {
    name: "none",
    summary: "nothing is in a light's way",
    publication: Publication { paper: "", section: "" },
    maps: &[],
    params: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    argument: "",
};
