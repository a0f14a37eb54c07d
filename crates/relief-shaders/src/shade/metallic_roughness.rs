//! Registry entry of the shading `metallic-roughness`.

use relief_core::registry::{Guarantee, Guarantees, Publication};

use crate::entry::{Entry, Role};

/// The material model of glTF.
pub const ENTRY: Entry = Entry {
    name: "metallic-roughness",
    summary: "the material model of glTF: facets that reflect (GGX), and what they scatter",
    publication: Publication { paper: "glTF 2.0; Turquin 2019", section: "appendix B" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "",
    role: Role::ReadsMaterials,
};
