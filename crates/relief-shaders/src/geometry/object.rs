//! Registry entry of the geometry `object`.

use relief_core::registry::{Entry, Guarantee, Guarantees, Publication};

/// A box around an object that is known from images.
pub const ENTRY: Entry = Entry {
    name: "object",
    summary: "object: a box around what images with depth look at",
    publication: Publication { paper: crate::DEPTH_OBJECTS, section: "4" },
    maps: &[],
    params: &[],
    states: &[],
    guarantee: Guarantees::all(Guarantee::Exact),
    weakened: &[],
    argument: "The box holds all that every image may see: rays that pass it by see nothing of the object.",
};
