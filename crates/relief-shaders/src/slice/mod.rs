//! Slice tests: each decides where a slice through the relief is drawn.
//!
//! A new test is a `.wesl` and a `.rs` file here and its name in the list below.

use relief_core::registry::{MAX_PARAMS, Param};

use crate::entry::Entry;

mod at_least;
mod band;
mod inside;

/// All slice tests, in the order of their numbers in the shaders.
pub static ENTRIES: &[Entry] = &[inside::ENTRY, at_least::ENTRY, band::ENTRY];

/// The settings of slices, which are the same for all tests. Hosts read them, since they make the
/// slices.
const PARAMS: &[Param] = &[
    Param {
        name: "count",
        summary: "slices over the whole displacement; slices in other directions keep that \
            distance in metres; 0: one texel apart",
        unit: "",
        min: 0.0,
        max: 1e9,
        default: 64.0,
        integer: true,
        names: &[],
    },
    Param {
        name: "refine",
        summary: "steps of false position between a drawn slice and the one before; 0: none",
        unit: "",
        min: 0.0,
        max: 64.0,
        default: 0.0,
        integer: true,
        names: &[],
    },
    Param::of_names(
        "direction",
        "a: along the base; b, c: upright, at equal u or v; for an object at equal x, y, z; auto: per \
         triangle the one of these that faces the eye most; screen: at equal depths",
        &["auto", "a", "b", "c", "screen"],
    ),
    Param::of_names(
        "anchor",
        "what slices at equal depths move with: the eye, or the world's origin",
        &["eye", "object"],
    ),
];

/// The direction of slices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SliceDirection {
    /// Per triangle the one of `A`, `B` and `C` that faces the eye most.
    Auto,
    /// Along the base; for an object at equal `x`.
    A,
    /// Upright on the base, at equal `u`; for an object at equal `y`.
    B,
    /// Upright on the base, at equal `v`; for an object at equal `z`.
    C,
    /// At equal depths from the eye.
    Screen,
}

/// The slices that a selection shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slices {
    /// Number of slices over the whole displacement; 0 puts them one texel apart.
    pub count: u32,
    /// Direction of the slices.
    pub direction: SliceDirection,
    /// Whether slices at equal depths move with the eye; if not, with the world's origin.
    pub with_eye: bool,
    /// Whether the border of the texture clips slices at equal depths; if not, they end at the
    /// relief's sides.
    pub by_border: bool,
}

impl Slices {
    /// Slices by the settings, in their order, and by the geometry's clipping.
    pub(crate) fn of([count, _, direction, anchor, ..]: [f32; MAX_PARAMS], clip: f32) -> Self {
        let direction = match direction as u32 {
            0 => SliceDirection::Auto,
            1 => SliceDirection::A,
            2 => SliceDirection::B,
            3 => SliceDirection::C,
            _ => SliceDirection::Screen,
        };
        Self { count: count as u32, direction, with_eye: anchor == 0.0, by_border: clip != 0.0 }
    }

    /// Reason why such slices can't be made, if they can't.
    pub(crate) fn refused(&self) -> Option<&'static str> {
        let is_refused = self.by_border && self.direction != SliceDirection::Screen;
        is_refused.then_some("a border clips slices at equal depths alone")
    }
}
