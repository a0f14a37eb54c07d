//! Registry entry of the geometry `tessellate`.

use relief_core::registry::{Guarantee, Guarantees, Param, Publication};

use super::{Geometry, GeometryRole};
use crate::entry::{Entry, Role};

/// How the triangles of a base are tessellated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tessellated {
    /// How many pixels of the picture wide the voxels are that sides are divided by.
    pub pixels: f32,
    /// Texels of the height map between points of a side, where these divide them in place of voxels.
    pub texels: Option<u32>,
    /// Whether the inside is filled by the voxels, too, and not by a pattern.
    pub is_swept: bool,
}

impl Tessellated {
    /// That of the geometry's parameters.
    pub(crate) fn of([pixels, texels, interior, ..]: [f32; 4]) -> Self {
        Self { pixels, texels: (texels > 0.0).then_some(texels as u32), is_swept: interior != 0.0 }
    }

    /// Why such triangles can't be made; none where they can.
    pub(crate) fn refused(&self) -> Option<&'static str> {
        let is_refused = self.is_swept && self.texels.is_some();
        is_refused.then_some("a sweep goes through voxels, and sides divided by texels have no point in each")
    }
}

/// Base triangles cut by a pattern or along voxels, as finely as the picture's pixels are, displaced.
pub const ENTRY: Entry = Entry {
    name: "tessellate",
    summary: "displaced triangles: each base triangle cut by itself for each view, on a GPU if there is one",
    publication: Publication {
        paper: "Gumhold and Hüttner 1999, Multiresolution Rendering With Displacement Mapping",
        section: "3",
    },
    maps: &[],
    params: PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "As `remesh`, or, where `texels` says so, as `vertex`; but what is inside of a base triangle \
        is filled by a pattern for the points of its three sides, whose every point and triangle is found by \
        its number, or by the points of a grid of voxels in columns, each of which follows from the three \
        corners: nothing is made one after the other. Where the picture would have more than eight triangles \
        for each of its voxels, voxels are twice as wide, or four times, until it has not. Base triangles \
        with more than 1,023 voxels along a side have the pattern in either case.",
    role: Role::Geometry(GeometryRole {
        triangles: Some(|params, _| Geometry::Tessellated(Tessellated::of(params))),
        ..GeometryRole::DISPLACED
    }),
};

const PARAMS: &[Param] = &[
    super::spacing("pixels", "pixels of the picture between vertices of the base", 0.25, false),
    Param {
        name: "texels",
        summary: "texels of the height map between vertices of the base; 0: as many as pixels say",
        unit: "texels",
        min: 0.0,
        max: 4_096.0,
        default: 0.0,
        integer: true,
        names: &[],
    },
    Param::of_names(
        "interior",
        "what fills base triangles: a pattern, or the grid of voxels that divides their sides",
        &["dice", "sweep"],
    ),
];
