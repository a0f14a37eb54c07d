//! Surfaces: what turns a fragment into path segments. A new one is a `.wesl` and a `.rs` file here and its
//! name in the two lists below.

use relief_core::registry::{Entry, Param, RayClass};

use crate::SURVEY;

mod facets;
mod frames;
mod object;
mod object_slices;
mod plane;
mod prism;
mod quadric_perpendicular;
mod quadric_vertical;
mod slices;
mod tetrahedra;

/// All of them.
pub const ENTRIES: &[Entry] = &[
    plane::ENTRY,
    prism::ENTRY,
    quadric_perpendicular::ENTRY,
    quadric_vertical::ENTRY,
    tetrahedra::ENTRY,
    facets::ENTRY,
    slices::ENTRY,
    object::ENTRY,
    frames::ENTRY,
    object_slices::ENTRY,
];

/// What each of them makes of rays, in the same order.
pub const PATHS: &[Paths] = &[
    plane::PATHS,
    prism::PATHS,
    quadric_perpendicular::PATHS,
    quadric_vertical::PATHS,
    tetrahedra::PATHS,
    facets::PATHS,
    slices::PATHS,
    object::PATHS,
    frames::PATHS,
    object_slices::PATHS,
];

/// What is added to the order of a shell's corners where the shell overlaps itself.
pub const FOLDED: u32 = 64;

/// How much larger the hulls of shells and the boxes around them are for a ray, relative to the largest
/// coordinate in play: more than rounding moves the ray, so that no shell is left out that it would have hit.
pub const SHELL_SLACK: f64 = 5e-6;

/// How far behind a hit, relative to its depth, shells and polygons may begin that are still looked into: keys
/// and depths are rounded in other ways. Smaller, and the backends may show different ones; larger costs time
/// only.
pub const DEPTH_SLACK: f64 = 1e-5;

/// What a surface makes of a pixel's ray.
#[derive(Clone, Copy, Debug)]
pub struct Paths {
    /// The classes of its segments: searches and refinements must be possible for all of them.
    pub rays: &'static [RayClass],
    /// Where its relief may be seen.
    pub proposal: Proposal,
    /// What the triangles show.
    pub shown: Shown,
    /// The variants of other stages that make nothing of its segments.
    pub refused: &'static [Refused],
}

/// What triangles show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// The height map's relief, which lies on them.
    Relief,
    /// Where they run through it.
    Slices,
    /// Themselves: they are all that there is to see.
    Triangles,
    /// What images see in a box around them.
    Object,
    /// Where they run through that.
    ObjectSlices,
}

impl Shown {
    /// Which surfaces show such triangles, as the end of a sentence.
    pub(crate) const fn needs(self) -> &'static str {
        match self {
            Shown::Relief => "only the surface 'slices' goes with the geometry 'slices'",
            Shown::Slices => "its triangles run through the relief, which the surface 'slices' alone shows",
            Shown::Object => {
                "its box holds what images see, which the surfaces 'object' and 'frames' alone show"
            }
            Shown::ObjectSlices => {
                "its triangles run through what images see, which the surface 'object-slices' alone shows"
            }
            Shown::Triangles => {
                "its triangles are displaced already, and only the surface 'facets' shows them as they are"
            }
        }
    }
}

impl Paths {
    /// Whether triangles are slices, which have no back.
    pub const fn is_sliced(&self) -> bool {
        matches!(self.shown, Shown::Slices | Shown::ObjectSlices)
    }

    /// Whether the height map's relief lies on the triangles.
    pub const fn has_relief(&self) -> bool {
        matches!(self.shown, Shown::Relief)
    }

    /// Whether normals are those of the relief, not of the triangles.
    pub const fn has_normals_of_relief(&self) -> bool {
        !matches!(self.shown, Shown::Triangles)
    }
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
        names: Names::These(&["none"]),
        reason: "a ray has several segments there, none of which begins at the base",
    },
    Refused {
        stage: "detail",
        names: Names::These(&["fade"]),
        reason: "a segment may begin anywhere in the relief there, and a flatter one may be above it",
    },
    NO_ENTRY_OF_LIGHT,
];

/// What surfaces of slices refuse.
const SLICES_ARE_SEARCHED: Refused = Refused {
    stage: "search",
    names: Names::AllBut(&["none"]),
    reason: "slices are what is searched: choose 'none'",
};

/// What surfaces of an object's images refuse.
const OF_IMAGES_REFUSE: &[Refused] = &[
    Refused {
        stage: "search",
        names: Names::AllBut(&["cells", "pyramid", "none"]),
        reason: "rays come into images from all sides: choose 'cells' or 'pyramid'",
    },
    Refused {
        stage: "refine",
        names: Names::AllBut(&["patch", "none"]),
        reason: "heights of images jump from cell to cell: choose 'patch'",
    },
    IMAGES_HAVE_NO_LEVELS,
    Refused {
        stage: "shadow",
        names: Names::AllBut(&["none", "map", "scene"]),
        reason: "one image alone does not know the object: choose 'map', 'scene' or 'none'",
    },
    IMAGES_KNOW_NO_SURROUNDINGS,
];

/// What all surfaces of images refuse.
const IMAGES_HAVE_NO_LEVELS: Refused = Refused {
    stage: "detail",
    names: Names::AllBut(&["none"]),
    reason: "images lie side by side in one, and would be mixed in coarser levels",
};

/// What all surfaces of images refuse.
const IMAGES_KNOW_NO_SURROUNDINGS: Refused = Refused {
    stage: "ambient",
    names: Names::ReadingMaps,
    reason: "one image alone does not know what is around a point of the object",
};

/// What all surfaces refuse on which the relief bends with the mesh.
const NO_ENTRY_OF_LIGHT: Refused = Refused {
    stage: "shadow",
    names: Names::These(&["entry"]),
    reason: "where a ray to a light enters the relief is not known there",
};

/// The settings of surfaces of quadrics. Hosts read them, too: see
/// [`Selection::quadrics`](crate::Selection::quadrics).
const QUADRIC_PARAMS: &[Param] = &[
    Param {
        name: "coefficients",
        summary: "2 leaves out the product of both directions: cheaper, and some saddles are lost",
        unit: "",
        min: 2.0,
        max: 3.0,
        default: 3.0,
        integer: true,
        names: &[],
    },
    LIFT,
];

/// The parameter of surfaces that can begin on a smooth base.
const LIFT: Param = Param {
    name: "lift",
    summary: "1 lays the relief on a smooth base in place of flat triangles",
    unit: "",
    min: 0.0,
    max: 1.0,
    default: 0.0,
    integer: true,
    names: &[],
};

/// Variants that a surface cannot be used with.
#[derive(Clone, Copy, Debug)]
pub struct Refused {
    /// The key of their stage.
    pub stage: &'static str,
    /// Which.
    pub names: Names,
    /// Why, as the end of a sentence.
    pub reason: &'static str,
}

/// Some variants of a stage, by their names or by what they read.
#[derive(Clone, Copy, Debug)]
pub enum Names {
    /// These.
    These(&'static [&'static str]),
    /// All others.
    AllBut(&'static [&'static str]),
    /// Those that read a baked map.
    ReadingMaps,
    /// Those that read a baked map of this kind.
    Reading(&'static str),
}

impl Names {
    /// Whether a variant is one of them.
    pub fn contain(&self, entry: &Entry) -> bool {
        match self {
            Names::These(names) => names.contains(&entry.name),
            Names::AllBut(names) => !names.contains(&entry.name),
            Names::ReadingMaps => !entry.maps.is_empty(),
            Names::Reading(kind) => entry.maps.iter().any(|map| map.kind == *kind),
        }
    }
}
