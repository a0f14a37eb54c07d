//! Objects: each combines a ray's hits in images that look at something from around it.
//!
//! A new kind is a `.wesl` and a `.rs` file here and its name in the list below.

use relief_core::object::{DEFAULT_JUMP_TEXELS, JumpCells};
use relief_core::registry::{MAX_PARAMS, Param};

use crate::entry::{Companion, Entry};

mod blend;
mod depth;
mod hull;
mod none;

/// All objects, in the order of their numbers in the shaders.
pub static ENTRIES: &[Entry] = &[none::ENTRY, depth::ENTRY, hull::ENTRY, blend::ENTRY];

/// The most images of an object that a ray may read all of.
pub const MAX_IMAGES: usize = 64;

/// Texels of each image's row in the map of images.
pub const IMAGE_TEXELS: u32 = 7;

/// The names of [`JumpCells`], in their order.
const CELLS: &[&str] = &[
    JumpCells::Bilinear.name(),
    JumpCells::Step.name(),
    JumpCells::Highest.name(),
    JumpCells::Nearest.name(),
];

/// The settings of objects, which are the same for all kinds.
const PARAMS: &[Param] = &[
    Param {
        default: JumpCells::Highest as u32 as f32,
        ..Param::of_names(
            "cells",
            "the surface where heights jump from texel to texel: bilinear, as elsewhere; step: as high as \
             the nearest texel; highest: as the highest around; nearest: the nearest texel, everywhere",
            CELLS,
        )
    },
    Param {
        name: "jump",
        summary: "difference of heights, in widths of a texel, beyond which they jump",
        unit: "texels",
        min: 0.0,
        max: 1e9,
        default: DEFAULT_JUMP_TEXELS as f32,
        integer: false,
        names: &[],
    },
    Param {
        default: 1.0,
        ..Param::of_names(
            "color",
            "three: from the three images that look along the view most; seen: only from images that see the \
             place; normals: none, light on the images' normals; blend: from the three frames of a grid \
             around the view",
            &["three", "seen", "normals", "blend"],
        )
    },
    Param {
        name: "steps",
        summary: "for blended frames: how often a place is moved by the depth that is seen there",
        unit: "steps",
        min: 0.0,
        max: 16.0,
        default: 3.0,
        integer: true,
        names: &[],
    },
];

/// The solid that the images of an object show.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectRole {
    /// The kind of solid.
    pub solid: Solid,
    /// The variants of other stages that are chosen with it if the chosen ones do not serve it.
    pub companions: &'static [Companion],
}

/// The way in which the images of an object are read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectCells {
    /// The kind of cells in which heights jump.
    pub cells: JumpCells,
    /// Difference of heights beyond which they jump, in widths of a texel.
    pub jump_texels: f32,
    /// The solid that the images define.
    pub solid: Solid,
    /// Whether colours are blended from a grid's frames.
    pub has_blended_colors: bool,
}

/// The solid that the images of an object define.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solid {
    /// The intersection of the solids of all images.
    Depth,
    /// The intersection of their silhouettes.
    Hull,
    /// A blend of three frames.
    Blend,
}

impl ObjectCells {
    /// Cells by a solid and the settings of objects, in their order.
    pub(crate) fn of(solid: Solid, [cells, jump_texels, color, ..]: [f32; MAX_PARAMS]) -> Self {
        let cells = JumpCells::ALL.get(cells as usize).copied().unwrap_or_default();
        Self { cells, jump_texels, solid, has_blended_colors: color == BLENDED_COLORS }
    }

    /// Whether bounds of texels bound cells: no cell is higher than the highest of its corners'
    /// texels, and cells lie between the centres of texels.
    pub(crate) fn is_under_texels(&self) -> bool {
        self.solid == Solid::Depth && matches!(self.cells, JumpCells::Bilinear | JumpCells::Highest)
    }
}

/// The value of the setting `object.color` for blended frames.
pub(crate) const BLENDED_COLORS: f32 = 3.0;

/// The number of cells of silhouettes in the shaders, after the numbers of [`JumpCells`].
pub const MASK_CELLS: u32 = JumpCells::ALL.len() as u32;
