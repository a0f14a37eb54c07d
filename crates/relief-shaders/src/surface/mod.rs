//! Surfaces: each turns a pixel's ray into path segments.
//!
//! A new surface is a `.wesl` and a `.rs` file here and its name in the list below.

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

/// All surfaces, in the order of their numbers in the shaders.
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

/// The number that is added to the order of a shell's corners where the shell overlaps itself.
pub const FOLDED: u32 = 64;

/// Enlargement of the hulls of shells, and of the boxes around them, for a ray, relative to the
/// largest coordinate in play. It is more than rounding moves the ray, so that no shell is left out
/// that the ray would have hit.
pub const SHELL_SLACK: f64 = 5e-6;

/// The greatest distance behind a hit, relative to its depth, at which a shell or polygon is still
/// traced: keys and depths are rounded in other ways. Smaller, and the backends may show different
/// ones; larger costs time only.
pub const DEPTH_SLACK: f64 = 1e-5;

/// The path segments of a pixel's ray on a surface.
#[derive(Clone, Copy, Debug)]
pub struct Paths {
    /// The ray classes of its segments: searches and refinements must be possible for all of them.
    pub rays: &'static [RayClass],
    /// The place where its relief may be seen.
    pub proposal: Proposal,
    /// The content of its triangles; geometries with the same content go with it.
    pub shown: Shown,
    /// The images of an object that its rays read; none for surfaces without an object.
    pub images: Option<AskedImages>,
    /// Whether rays go through the frame of the point at which they meet the base, and need no more of
    /// its triangle: such surfaces have a form in tangent space.
    pub through_frame: bool,
    /// The variants of other stages that cannot handle its segments.
    pub refused: &'static [Refused],
}

/// The images of an object that a ray reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AskedImages {
    /// All images.
    All,
    /// The three images of a grid that look along the ray most.
    OfGrid,
}

/// The content of triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shown {
    /// The height map's relief, which lies on them.
    Relief,
    /// The height map's relief, which they run through.
    Slices,
    /// The triangles themselves, without a relief.
    Triangles,
    /// An object of images with depth, in the box that they make.
    Object,
    /// An object of images with depth, which they run through.
    ObjectSlices,
}

impl Shown {
    /// Whether triangles are slices, which have no back.
    pub const fn is_sliced(self) -> bool {
        matches!(self, Shown::Slices | Shown::ObjectSlices)
    }

    /// Whether images with depth define the content.
    pub const fn is_of_images(self) -> bool {
        matches!(self, Shown::Object | Shown::ObjectSlices)
    }

    /// The surfaces that show the triangles of a geometry, as the end of a sentence. `other` is the
    /// content of the chosen surface.
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
            Shown::Object => format!("its box holds an object of images, which {shown}"),
            Shown::ObjectSlices => format!("its triangles run through an object of images, which {shown}"),
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
        through_frame: true,
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

    /// Whether the relief gives the normals, not the triangles.
    pub const fn has_normals_of_relief(&self) -> bool {
        !matches!(self.shown, Shown::Triangles)
    }
}

/// The place where a triangle's relief may be seen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Proposal {
    /// On the triangle itself.
    Polygons,
    /// In its shell: the triangle with its corners moved along their normals.
    Shells,
}

/// Variants of another stage that a surface cannot be used with.
#[derive(Clone, Copy, Debug)]
pub struct Refused {
    /// The key of their stage.
    pub stage: &'static str,
    /// Whether a variant is refused, by its entry.
    pub refuses: fn(&Entry) -> bool,
    /// The reason, as the end of a sentence that may name the stage's other variants.
    pub reason: fn(others: &Variants) -> String,
}

/// Refusals of surfaces on which a ray has several segments.
const SEGMENTS_REFUSE: &[Refused] = &[
    Refused {
        stage: "search",
        refuses: Entry::is_idle,
        reason: |_| "a ray has several segments there, and none begins at the base".to_owned(),
    },
    Refused {
        stage: "search",
        refuses: |entry| entry.tracing().begins_at_top,
        reason: |_| "it knows rays from the relief's top, and a segment may begin anywhere there".to_owned(),
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

/// Refusals of surfaces of slices.
const SLICES_ARE_SEARCHED: Refused = Refused {
    stage: "search",
    refuses: is_active,
    reason: |others| format!("the slices replace the search: choose {}", others.or()),
};

/// Refusals of surfaces of an object's images.
const OF_IMAGES_REFUSE: &[Refused] = &[
    Refused {
        stage: "search",
        refuses: serves_no_images,
        reason: |others| format!("rays enter images from all sides: choose {}", others.active().or()),
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

/// Refusals of levels of detail by all surfaces of images.
const IMAGES_HAVE_NO_LEVELS: Refused = Refused {
    stage: "detail",
    refuses: is_active,
    reason: |_| "images lie side by side in one map, and would be mixed in coarser levels".to_owned(),
};

/// Refusals of baked ambient lights by all surfaces of images.
const IMAGES_KNOW_NO_SURROUNDINGS: Refused = Refused {
    stage: "ambient",
    refuses: |entry| !entry.maps.is_empty(),
    reason: |_| "one image alone does not know what is around a point of the object".to_owned(),
};

/// Refusals by all surfaces on which the relief bends with the mesh.
const NO_ENTRY_OF_LIGHT: Refused = Refused {
    stage: "shadow",
    refuses: |entry| entry.shadow() == Some(ShadowRole::FromEntry),
    reason: |_| "the entry of a ray to a light into the relief is not known there".to_owned(),
};

/// Whether a variant does something.
fn is_active(entry: &Entry) -> bool {
    !entry.is_idle()
}

/// Whether a search or a refinement does something, but not for the images of an object.
fn serves_no_images(entry: &Entry) -> bool {
    is_active(entry) && !entry.tracing().serves_images
}

/// Whether a shadow comes only from a surface's own relief.
fn is_shadow_of_one_surface(entry: &Entry) -> bool {
    is_active(entry) && !entry.shadow().is_some_and(ShadowRole::sees_scene)
}

/// The settings of surfaces of quadrics. Hosts read them, too: see
/// [`Selection::quadrics`](crate::Selection::quadrics).
const QUADRIC_PARAMS: &[Param] = &[
    Param {
        name: "coefficients",
        summary: "2 drops the product of both directions: cheaper, but loses some saddles",
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
