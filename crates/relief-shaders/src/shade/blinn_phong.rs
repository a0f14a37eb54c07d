//! Registry entry of the shading `blinn-phong`.

use relief_core::registry::{Entry, Guarantee, Guarantees, Publication};

/// Ambient, diffuse and a specular lobe around the half vector.
pub const ENTRY: Entry = Entry {
    id: 0,
    name: "blinn-phong",
    summary: "ambient, diffuse and a specular lobe around the half vector",
    publication: Publication { paper: super::SURVEY, section: "2.1" },
    maps: &[],
    params: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    argument: "",
};
