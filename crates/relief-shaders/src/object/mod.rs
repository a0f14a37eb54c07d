//! Objects: what a ray meets in images that look at something from around it. A new kind is a `.wesl` and a
//! `.rs` file here and its name in the list below.

use relief_core::object::{DEFAULT_JUMP_TEXELS, JumpCells};
use relief_core::registry::Param;

use crate::entry::{Companion, Entry};

mod blend;
mod depth;
mod hull;
mod none;

/// All of them.
pub static ENTRIES: &[Entry] = &[none::ENTRY, depth::ENTRY, hull::ENTRY, blend::ENTRY];

/// Most images of an object that all of them are asked of.
pub const MAX_IMAGES: usize = 64;

/// How many texels of the map of images each of them has.
pub const IMAGE_TEXELS: u32 = 7;

/// What [`JumpCells`] are called, in their order.
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
            "where heights jump from texel to texel: bilinear as elsewhere; as high as the nearest texel \
             (step), or as the highest around (highest); nearest: the nearest texel everywhere",
            CELLS,
        )
    },
    Param {
        name: "jump",
        summary: "by how many texels' width heights differ where they jump",
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
            "of the three images that look along the view most; of those alone that see the place; of none, \
             but light on the images' normals; blend: of the three frames of a grid that are around the view",
            &["three", "seen", "normals", "blend"],
        )
    },
    Param {
        name: "steps",
        summary: "of blended frames: how often a place is moved by the depth that is seen there",
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
    /// What it is.
    pub solid: Solid,
    /// The variants of other stages that are chosen with it where those that are chosen do not serve it.
    pub companions: &'static [Companion],
}

/// How the images of an object are read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectCells {
    /// What cells are in which heights jump.
    pub cells: JumpCells,
    /// By how many texels' width heights differ there.
    pub jump_texels: f32,
    /// What is made of them.
    pub solid: Solid,
    /// Whether colours are those of a grid's frames, blended.
    pub has_blended_colors: bool,
}

/// What is made of the images of an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solid {
    /// The intersection of what they see.
    Depth,
    /// That of their silhouettes.
    Hull,
    /// A blend of three frames.
    Blend,
}

impl ObjectCells {
    /// Those of a solid with the settings of objects, in the order of these.
    pub(crate) fn of(solid: Solid, [cells, jump_texels, color, _]: [f32; 4]) -> Self {
        let cells = JumpCells::ALL.get(cells as usize).copied().unwrap_or_default();
        Self { cells, jump_texels, solid, has_blended_colors: color == BLENDED_COLORS }
    }

    /// Whether no cell is higher than the highest of its corners' texels says, and cells lie between the
    /// centres of texels: so that what bounds texels bounds them.
    pub(crate) fn is_under_texels(&self) -> bool {
        self.solid == Solid::Depth && matches!(self.cells, JumpCells::Bilinear | JumpCells::Highest)
    }
}

/// The value of the setting `object.color` for those of blended frames.
pub(crate) const BLENDED_COLORS: f32 = 3.0;

/// What the shaders call cells of silhouettes, after those of [`JumpCells`].
pub const MASK_CELLS: u32 = JumpCells::ALL.len() as u32;
