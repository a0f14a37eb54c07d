//! Registry entry of the geometry `tessellate`.

use relief_core::registry::{Entry, Guarantee, Guarantees, Param, Publication};

/// Base triangles cut by a fixed pattern, as finely as the picture's pixels are, displaced.
pub const ENTRY: Entry = Entry {
    name: "tessellate",
    summary: "displaced triangles: each base triangle cut by a pattern for each view, on a GPU where there is one",
    publication: Publication {
        paper: "Gumhold and Hüttner 1999, Multiresolution Rendering With Displacement Mapping",
        section: "3.1",
    },
    maps: &[],
    params: PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "As `remesh`, but what is inside of a base triangle is filled by a pattern for the points of \
        its three sides, whose every point and triangle is found by its number: nothing is made one after \
        the other. Where the picture would have more than eight triangles for each of its voxels, all sides \
        have half as many parts, or a quarter, until it has not.",
};

const PARAMS: &[Param] =
    &[super::spacing("pixels", "pixels of the picture between vertices of the base", 0.25, false)];
