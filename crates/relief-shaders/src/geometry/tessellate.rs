//! Registry entry of the geometry `tessellate`.

use relief_core::registry::{Guarantee, Guarantees, MAX_PARAMS, Param, Publication};

use super::{Geometry, GeometryRole};
use crate::entry::{Entry, Role};

/// The tessellation of a base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tessellated {
    /// Width of the voxels that divide sides, in pixels of the picture.
    pub pixels: f32,
    /// Texels of the height map between points of a side, if texels divide sides in place of
    /// voxels.
    pub texels: Option<u32>,
    /// Whether voxels fill the inside, too, in place of a pattern.
    pub is_swept: bool,
}

impl Tessellated {
    /// The tessellation by the geometry's parameters.
    pub(crate) fn of([pixels, texels, interior, ..]: [f32; MAX_PARAMS]) -> Self {
        Self { pixels, texels: (texels > 0.0).then_some(texels as u32), is_swept: interior != 0.0 }
    }

    /// Reason why such triangles can't be made, if they can't.
    pub(crate) fn refused(&self) -> Option<&'static str> {
        let is_refused = self.is_swept && self.texels.is_some();
        is_refused.then_some(
            "a sweep needs a point of each side in every voxel, and sides divided by texels \
             have none in some",
        )
    }
}

/// Base triangles cut by a pattern or along voxels, as fine as the picture's pixels, and displaced.
pub const ENTRY: Entry = Entry {
    name: "tessellate",
    summary: "displaced triangles: each base triangle cut by itself for each view, on a GPU if \
        there is one",
    publication: Publication {
        paper: "Gumhold and Hüttner 1999, Multiresolution Rendering With Displacement Mapping",
        section: "3",
    },
    maps: &[],
    params: PARAMS,
    states: &[],
    guarantee: Guarantees::all(Guarantee::Approximate),
    weakened: &[],
    argument: "Sides are divided as by `remesh`, or, with `texels`, as by `vertex`. The inside \
        of a base triangle is filled by a pattern for the points of its three sides, whose every \
        point and triangle is found by its number. Or it is filled by the points of a grid of \
        voxels in columns, and each column follows from the three corners. Nothing is made one after \
        the other. Where the picture would have more than eight triangles for each of its voxels, \
        voxels are made twice as wide, or four times, until it has not. Base triangles with more \
        than 1,023 voxels along a side have the pattern in either case.",
    role: Role::Geometry(GeometryRole {
        triangles: Some(|params, _| Geometry::Tessellated(Tessellated::of(params))),
        ..GeometryRole::DISPLACED
    }),
};

const PARAMS: &[Param] = &[
    super::spacing("pixels", "pixels of the picture between vertices of the base", 0.25, false),
    Param {
        name: "texels",
        summary: "texels of the height map between vertices of the base; 0: `pixels` decides",
        unit: "texels",
        min: 0.0,
        max: 4_096.0,
        default: 0.0,
        integer: true,
        names: &[],
    },
    Param::of_names(
        "interior",
        "filling of base triangles: a pattern (dice), or the grid of voxels that divides their sides (sweep)",
        &["dice", "sweep"],
    ),
];
