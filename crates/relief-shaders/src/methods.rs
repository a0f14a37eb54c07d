//! Methods by name: a geometry, a search, a refinement and the settings under which they were
//! published.

use relief_core::registry::{Publication, UnknownName};

use crate::field::Solids;
use crate::object::BLENDED_COLORS;
use crate::slice::SliceDirection;
use crate::stages::{GEOMETRY, SEARCH, STAGES, entry_place};
use crate::{DEPTH_OBJECTS, SURVEY, object, slice};

/// A published pair of search and refinement, or a geometry without a search: displaced triangles,
/// or slices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Method {
    /// The name on the command line and in scenes.
    pub name: &'static str,
    /// The name in the literature.
    pub summary: &'static str,
    /// Name of the geometry; `none` if the relief is traced for each pixel.
    pub geometry: &'static str,
    /// Name of the search.
    pub search: &'static str,
    /// Name of the refinement.
    pub refine: &'static str,
    /// Settings that differ from the entries' defaults, such as `("search.grazing", 4.0)`.
    pub settings: &'static [(&'static str, f32)],
    /// Where it was published.
    pub publication: Publication,
}

/// A family of methods, by what its pictures are made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Rays into the relief of a base, or displaced triangles.
    Ray,
    /// Slices through the relief.
    Slices,
    /// Objects of images with depth.
    Object,
    /// Rays into a volume on a base.
    Volume,
    /// Rays into a motif that a base repeats.
    Motif,
}

impl Family {
    /// Returns the word used in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Family::Ray => "ray",
            Family::Slices => "slices",
            Family::Object => "object",
            Family::Volume => "volume",
            Family::Motif => "motif",
        }
    }
}

impl Method {
    /// Whether it shows height maps on meshes, and and no objects of images, volumes or motifs.
    pub fn is_of_reliefs(&self) -> bool {
        matches!(self.family(), Family::Ray | Family::Slices)
    }

    /// Returns the family that it belongs to.
    pub fn family(&self) -> Family {
        let search = STAGES[SEARCH].first(|entry| entry.name == self.search);
        match search.map(|(_, entry)| entry.tracing().solids) {
            Some(Solids::Volumes) => return Family::Volume,
            Some(Solids::Motifs) => return Family::Motif,
            _ => {}
        }
        let geometry = STAGES[GEOMETRY].first(|entry| entry.name == self.geometry);
        geometry.map_or(Family::Ray, |(_, entry)| entry.geometry().family)
    }
}

/// No settings of its own.
const DEFAULTS: &[(&str, f32)] = &[];

/// The settings of slices along the base, drawn down to their floor.
const ALONG_SURFACE: &[(&str, f32)] = &[
    ("slices.direction", SliceDirection::A as u32 as f32),
    ("slices.test", entry_place(slice::ENTRIES, "at-least") as f32),
];

/// The settings of slices at equal depths.
const ALONG_SCREEN: &[(&str, f32)] = &[("slices.direction", SliceDirection::Screen as u32 as f32)];

/// The settings of objects of images with depth.
const OF_DEPTH: &[(&str, f32)] = &[("object.solid", entry_place(object::ENTRIES, "depth") as f32)];

/// The settings of visual hulls.
const OF_SILHOUETTES: &[(&str, f32)] = &[("object.solid", entry_place(object::ENTRIES, "hull") as f32)];

/// The settings of blended impostors.
const OF_FRAMES: &[(&str, f32)] =
    &[("object.solid", entry_place(object::ENTRIES, "blend") as f32), ("object.color", BLENDED_COLORS)];

const fn survey(
    name: &'static str,
    search: &'static str,
    refine: &'static str,
    settings: &'static [(&'static str, f32)],
    section: &'static str,
    summary: &'static str,
) -> Method {
    Method {
        name,
        summary,
        geometry: "none",
        search,
        refine,
        settings,
        publication: Publication { paper: SURVEY, section },
    }
}

/// All methods.
pub static METHODS: &[Method] = &[
    survey("bump", "none", "none", DEFAULTS, "4.1.1", "bump mapping: normals alone"),
    survey("parallax", "none", "offset", DEFAULTS, "4.1.2", "parallax mapping"),
    survey(
        "parallax-limited",
        "none",
        "offset-limited",
        DEFAULTS,
        "4.1.3",
        "parallax mapping with offset limiting",
    ),
    survey(
        "parallax-slope",
        "none",
        "slope",
        DEFAULTS,
        "4.1.4",
        "parallax mapping taking into account the slope",
    ),
    survey("parallax-iterative", "none", "slope-iterative", DEFAULTS, "4.2.1", "iterative parallax mapping"),
    survey("binary-search", "none", "binary", DEFAULTS, "4.2.2", "binary search over the whole path"),
    survey(
        "secant-search",
        "none",
        "secant",
        &[("refine.steps", 8.0)],
        "4.2.3",
        "false position over the whole path",
    ),
    survey("steep", "linear", "none", DEFAULTS, "4.3.1", "steep parallax mapping: linear search alone"),
    survey("relief", "linear", "binary", DEFAULTS, "4.4.1", "relief mapping: linear, then binary search"),
    survey(
        "occlusion",
        "linear",
        "secant",
        DEFAULTS,
        "4.4.2",
        "parallax occlusion mapping: linear search, then secant",
    ),
    survey("exact", "cells", "patch", DEFAULTS, "4.3.1", "the first hit with the bilinear surface"),
    survey(
        "cone",
        "cone",
        "patch",
        DEFAULTS,
        "4.3.5",
        "cone stepping: the exact first hit with fewer reads, over empty cones",
    ),
    survey(
        "ray-casting",
        "linear",
        "secant",
        &[("refine.steps", 1.0)],
        "4.4.2",
        "linear search, then a single secant step",
    ),
    survey(
        "interval",
        "linear",
        "secant",
        &[("refine.steps", 3.0)],
        "4.4.2",
        "interval mapping: linear search, then three secant steps",
    ),
    survey(
        "erosion-dilation",
        "dilation-erosion",
        "patch",
        DEFAULTS,
        "4.3.2",
        "the exact first hit over boxes of equal size",
    ),
    survey(
        "quadtree",
        "pyramid",
        "patch",
        DEFAULTS,
        "4.3.3",
        "the exact first hit over the nodes of a pyramid that bounds the surface",
    ),
    survey(
        "pyramidal",
        "pyramid-texels",
        "none",
        DEFAULTS,
        "4.3.3",
        "pyramidal displacement mapping: texels as level columns",
    ),
    survey(
        "pyramidal-bilinear",
        "pyramid-texels",
        "half-texel",
        DEFAULTS,
        "4.3.3",
        "pyramidal displacement mapping with its half-texel interpolation",
    ),
    survey(
        "sphere-tracing",
        "sphere",
        "patch",
        DEFAULTS,
        "4.3.4",
        "the exact first hit over spheres of a distance field",
    ),
    survey(
        "cone-stepping",
        "cone-moved",
        "none",
        DEFAULTS,
        "4.3.5",
        "cone stepping as published: a fixed number of steps",
    ),
    survey(
        "relaxed-cone-stepping",
        "relaxed-cone",
        "binary",
        DEFAULTS,
        "4.4.3",
        "relaxed cone stepping: over wider cones to a bracket, then binary search",
    ),
    survey(
        "voxels",
        "voxels",
        "trilinear",
        DEFAULTS,
        "5.2",
        "the first hit with a volume: grass, mail and cloth, voxel by voxel",
    ),
    survey(
        "translucent",
        "translucent",
        "none",
        DEFAULTS,
        "5.2",
        "volumes that light shines through: absorption, scattering and shadows on themselves",
    ),
    survey(
        "shell-map",
        "shell-map",
        "none",
        DEFAULTS,
        "5.2",
        "shell maps: the triangles of a motif, such as links of mail, in the shells of a mesh",
    ),
    survey(
        "generalised",
        "generalised",
        "none",
        DEFAULTS,
        "6.3",
        "generalised displacement mapping: the hit with a volume, looked up by place and direction",
    ),
    survey(
        "view-dependent",
        "view-dependent",
        "none",
        DEFAULTS,
        "6.3",
        "view-dependent displacement mapping: the hit, looked up by place and direction",
    ),
    survey(
        "view-dependent-svd",
        "view-dependent-svd",
        "none",
        DEFAULTS,
        "6.3",
        "view-dependent displacement mapping out of a map compressed by a singular value decomposition",
    ),
    survey(
        "view-dependent-clusters",
        "view-dependent-clusters",
        "none",
        DEFAULTS,
        "6.3",
        "view-dependent displacement mapping out of non-negative factors of clusters of texels",
    ),
    Method {
        name: "view-dependent-free",
        summary: "the exact first hit: over a way that is free by place and direction, then cell by cell",
        geometry: "none",
        search: "view-dependent-free",
        refine: "patch",
        settings: DEFAULTS,
        publication: Publication { paper: "Relief", section: "" },
    },
    Method {
        name: "relaxed",
        summary: "relaxed cones that stay on their texel: few reads, rarely misses a hit",
        geometry: "none",
        search: "relaxed-cone-resting",
        refine: "patch",
        settings: DEFAULTS,
        publication: Publication { paper: "Relief", section: "" },
    },
    Method {
        name: "frustum",
        summary: "the exact first hit with fewer reads, over quadrant frusta",
        geometry: "none",
        search: "frustum",
        refine: "patch",
        settings: DEFAULTS,
        publication: Publication { paper: "Relief", section: "" },
    },
    Method {
        name: "vertex",
        summary: "displaced triangles: the base with vertices one texel apart, or more",
        geometry: "vertex",
        search: "none",
        refine: "none",
        settings: DEFAULTS,
        publication: Publication { paper: SURVEY, section: "3.1" },
    },
    Method {
        name: "remesh",
        summary: "displaced triangles: the base divided anew for each view, as fine as its pixels",
        geometry: "remesh",
        search: "none",
        refine: "none",
        settings: DEFAULTS,
        publication: Publication {
            paper: "Gumhold and Hüttner 1999, Multiresolution Rendering With Displacement Mapping",
            section: "3",
        },
    },
    Method {
        name: "tessellate",
        summary: "displaced triangles: each base triangle cut by itself, as fine as the view's pixels",
        geometry: "tessellate",
        search: "none",
        refine: "none",
        settings: DEFAULTS,
        publication: Publication {
            paper: "Gumhold and Hüttner 1999, Multiresolution Rendering With Displacement Mapping",
            section: "3",
        },
    },
    Method {
        name: "slices-surface",
        summary: "slices along the base, drawn where the relief is at least as high",
        geometry: "slices",
        search: "none",
        refine: "none",
        settings: ALONG_SURFACE,
        publication: Publication { paper: DEPTH_OBJECTS, section: "3.1" },
    },
    Method {
        name: "slices-orthogonal",
        summary: "slices along the base or upright on it, whichever face the eye; drawn inside the relief",
        geometry: "slices",
        search: "none",
        refine: "none",
        settings: DEFAULTS,
        publication: Publication { paper: DEPTH_OBJECTS, section: "3.2" },
    },
    Method {
        name: "slices-screen",
        summary: "slices at equal depths from the eye, drawn inside the relief",
        geometry: "slices",
        search: "none",
        refine: "none",
        settings: ALONG_SCREEN,
        publication: Publication { paper: DEPTH_OBJECTS, section: "3.3" },
    },
    Method {
        name: "depth-object",
        summary: "an object of images with depth: the intersection of what they show",
        geometry: "object",
        search: "pyramid",
        refine: "patch",
        settings: OF_DEPTH,
        publication: Publication { paper: DEPTH_OBJECTS, section: "4" },
    },
    Method {
        name: "depth-object-slices",
        summary: "slices through an object of images with depth, drawn where all of them show something",
        geometry: "object-slices",
        search: "none",
        refine: "none",
        settings: OF_DEPTH,
        publication: Publication { paper: DEPTH_OBJECTS, section: "4.1" },
    },
    Method {
        name: "visual-hull",
        summary: "the visual hull of an object: the intersection of the silhouettes of all images",
        geometry: "object",
        search: "cells",
        refine: "patch",
        settings: OF_SILHOUETTES,
        publication: Publication { paper: DEPTH_OBJECTS, section: "5" },
    },
    Method {
        name: "visual-hull-slices",
        summary: "slices through the visual hull of an object, drawn inside all silhouettes",
        geometry: "object-slices",
        search: "none",
        refine: "none",
        settings: OF_SILHOUETTES,
        publication: Publication { paper: DEPTH_OBJECTS, section: "5" },
    },
    Method {
        name: "impostor-blend",
        summary: "an octahedral impostor as engines draw it: three frames, blended",
        geometry: "object",
        search: "none",
        refine: "none",
        settings: OF_FRAMES,
        publication: Publication { paper: "Brucks 2018, Octahedral Impostors", section: "" },
    },
];

/// Returns the method of that name.
///
/// # Errors
///
/// When no method has that name; the error names the nearest.
pub fn method(name: &str) -> Result<&'static Method, UnknownName> {
    METHODS
        .iter()
        .find(|method| method.name == name)
        .ok_or_else(|| UnknownName::new("method", name, METHODS.iter().map(|method| method.name)))
}
