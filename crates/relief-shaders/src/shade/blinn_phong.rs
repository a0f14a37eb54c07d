//! Registry entry of the shading `blinn-phong`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// Diffuse, and a specular lobe around the half vector.
pub const ENTRY: Entry = Entry {
    name: "blinn-phong",
    summary: "diffuse, and a specular lobe around the half vector",
    publication: Publication { paper: super::SURVEY, section: "2.1" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "",
    role: Role::Plain,
};
