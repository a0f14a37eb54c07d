//! Surfaces: what turns a fragment into path segments. A new one is a `.wesl` and a `.rs` file here and its
//! name in the list below.

use relief_core::registry::{Param, RayClass};

use crate::entry::Entry;
use crate::shadow::ShadowRole;
use crate::stages::{GEOMETRY, SURFACE};
use crate::{SURVEY, Variants};

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
pub static ENTRIES: &[Entry] = &[
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
    /// What the triangles show: it goes with geometries that show the same.
    pub shown: Shown,
    /// Which images of an object its rays ask; none where it shows no object.
    pub images: Option<AskedImages>,
    /// The variants of other stages that make nothing of its segments.
    pub refused: &'static [Refused],
}

/// Which images of an object a ray asks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AskedImages {
    /// All of them.
    All,
    /// Of images that make a grid the three that look along the ray most.
    OfGrid,
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
    /// Whether triangles are slices, which have no back.
    pub const fn is_sliced(self) -> bool {
        matches!(self, Shown::Slices | Shown::ObjectSlices)
    }

    /// Whether what is seen is known from images with depth.
    pub const fn is_of_images(self) -> bool {
        matches!(self, Shown::Object | Shown::ObjectSlices)
    }

    /// Which surfaces show the triangles of a geometry, as the end of a sentence; `other` is what the chosen
    /// surface shows instead.
    pub(crate) fn needs(self, other: Self) -> String {
        let surfaces = Variants::of(SURFACE, |entry| entry.paths().shown == self);
        let [s, y] = if surfaces.are_several() { ["s", ""] } else { ["", "s"] };
        let shown = format!("the surface{s} {} alone show{y}", surfaces.and());
        match self {
            Shown::Relief => {
                let geometries = Variants::of(GEOMETRY, |entry| entry.geometry().shown == other);
                let surfaces = Variants::of(SURFACE, |entry| entry.paths().shown == other);
                let [s, goes] = if surfaces.are_several() { ["s", "go"] } else { ["", "goes"] };
                format!("only the surface{s} {} {goes} with the geometry {}", surfaces.and(), geometries.or())
            }
            Shown::Slices => format!("its triangles run through the relief, which {shown}"),
            Shown::Object => format!("its box holds what images see, which {shown}"),
            Shown::ObjectSlices => format!("its triangles run through what images see, which {shown}"),
            Shown::Triangles => format!(
                "its triangles are displaced already, and only the surface{s} {} show{y} them as they are",
                surfaces.and()
            ),
        }
    }
}

impl Paths {
    /// One straight segment in a relief that lies on the triangles.
    pub const STRAIGHT: Self = Self {
        rays: &[RayClass::View],
        proposal: Proposal::Polygons,
        shown: Shown::Relief,
        images: None,
        refused: &[],
    };

    /// Whether triangles are slices, which have no back.
    pub const fn is_sliced(&self) -> bool {
        self.shown.is_sliced()
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

/// Variants of another stage that a surface cannot be used with.
#[derive(Clone, Copy, Debug)]
pub struct Refused {
    /// The key of their stage.
    pub stage: &'static str,
    /// Whether a variant is one of them, by what its entry says.
    pub refuses: fn(&Entry) -> bool,
    /// Why, as the end of a sentence that may name the stage's other variants.
    pub reason: fn(others: &Variants) -> String,
}

/// What surfaces refuse on which a ray has several segments.
const SEGMENTS_REFUSE: &[Refused] = &[
    Refused {
        stage: "search",
        refuses: Entry::is_idle,
        reason: |_| "a ray has several segments there, none of which begins at the base".to_owned(),
    },
    Refused {
        stage: "detail",
        refuses: Entry::flattens,
        reason: |_| {
            "a segment may begin anywhere in the relief there, and a flatter one may be above it".to_owned()
        },
    },
    NO_ENTRY_OF_LIGHT,
];

/// What surfaces of slices refuse.
const SLICES_ARE_SEARCHED: Refused = Refused {
    stage: "search",
    refuses: is_active,
    reason: |others| format!("slices are what is searched: choose {}", others.or()),
};

/// What surfaces of an object's images refuse.
const OF_IMAGES_REFUSE: &[Refused] = &[
    Refused {
        stage: "search",
        refuses: serves_no_images,
        reason: |others| format!("rays come into images from all sides: choose {}", others.active().or()),
    },
    Refused {
        stage: "refine",
        refuses: serves_no_images,
        reason: |others| format!("heights of images jump from cell to cell: choose {}", others.active().or()),
    },
    IMAGES_HAVE_NO_LEVELS,
    Refused {
        stage: "shadow",
        refuses: is_shadow_of_one_surface,
        reason: |others| format!("one image alone does not know the object: choose {}", others.or()),
    },
    IMAGES_KNOW_NO_SURROUNDINGS,
];

/// What all surfaces of images refuse.
const IMAGES_HAVE_NO_LEVELS: Refused = Refused {
    stage: "detail",
    refuses: is_active,
    reason: |_| "images lie side by side in one, and would be mixed in coarser levels".to_owned(),
};

/// What all surfaces of images refuse.
const IMAGES_KNOW_NO_SURROUNDINGS: Refused = Refused {
    stage: "ambient",
    refuses: |entry| !entry.maps.is_empty(),
    reason: |_| "one image alone does not know what is around a point of the object".to_owned(),
};

/// What all surfaces refuse on which the relief bends with the mesh.
const NO_ENTRY_OF_LIGHT: Refused = Refused {
    stage: "shadow",
    refuses: |entry| entry.shadow() == Some(ShadowRole::FromEntry),
    reason: |_| "where a ray to a light enters the relief is not known there".to_owned(),
};

/// Whether a variant does something.
fn is_active(entry: &Entry) -> bool {
    !entry.is_idle()
}

/// Whether a search or a refinement does something, but not for the images of an object.
fn serves_no_images(entry: &Entry) -> bool {
    is_active(entry) && !entry.tracing().serves_images
}

/// Whether a shadow is one of a surface's own relief.
fn is_shadow_of_one_surface(entry: &Entry) -> bool {
    is_active(entry) && !entry.shadow().is_some_and(ShadowRole::sees_scene)
}

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
