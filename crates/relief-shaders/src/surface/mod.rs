//! Surfaces: what turns a fragment into path segments. A new one is a `.wesl` and a `.rs` file here and its
//! name in the two lists below.

use relief_core::registry::{Entry, RayClass};

use crate::SURVEY;

mod plane;
mod prism;
mod tetrahedra;

/// All of them.
pub const ENTRIES: &[Entry] = &[plane::ENTRY, prism::ENTRY, tetrahedra::ENTRY];

/// What each of them makes of rays, in the same order.
pub const PATHS: &[Paths] = &[plane::PATHS, prism::PATHS, tetrahedra::PATHS];

/// What is added to the order of a shell's corners where the shell overlaps itself.
pub const FOLDED: u32 = 64;

/// What a surface makes of a pixel's ray.
#[derive(Clone, Copy, Debug)]
pub struct Paths {
    /// The classes of its segments: searches and refinements must be possible for all of them.
    pub rays: &'static [RayClass],
    /// Where its relief may be seen.
    pub proposal: Proposal,
    /// The variants of other stages that make nothing of its segments.
    pub refused: &'static [Refused],
}

/// Where a triangle's relief may be seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Proposal {
    /// Where the triangle itself is.
    Polygons,
    /// Where its shell is: the triangle with its corners moved along their normals.
    Shells,
}

/// What surfaces refuse on which a ray has several segments.
const SEGMENTS_REFUSE: &[Refused] = &[
    Refused {
        stage: "search",
        names: &["none"],
        reason: "a ray has several segments there, none of which begins at the base",
    },
    Refused {
        stage: "detail",
        names: &["fade"],
        reason: "a segment may begin anywhere in the relief there, and a flatter one may be above it",
    },
    Refused {
        stage: "shadow",
        names: &["entry"],
        reason: "where a ray to a light enters the relief is not known there",
    },
];

/// Variants that a surface cannot be used with.
#[derive(Clone, Copy, Debug)]
pub struct Refused {
    /// The key of their stage.
    pub stage: &'static str,
    /// Their names.
    pub names: &'static [&'static str],
    /// Why, as the end of a sentence.
    pub reason: &'static str,
}
