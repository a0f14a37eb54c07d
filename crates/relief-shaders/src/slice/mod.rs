//! Slices: what of a slice through the relief is drawn. A new test is a `.wesl` and a `.rs` file here and its
//! name in the list below.

use relief_core::registry::Param;

use crate::entry::Entry;

mod at_least;
mod band;
mod inside;

/// All of them.
pub static ENTRIES: &[Entry] = &[inside::ENTRY, at_least::ENTRY, band::ENTRY];

/// The settings of slices, which are the same for all tests. Hosts read them, since they make the slices.
const PARAMS: &[Param] = &[
    Param {
        name: "count",
        summary: "slices over the whole displacement, others as many metres apart; 0: a texel apart",
        unit: "",
        min: 0.0,
        max: 1e9,
        default: 64.0,
        integer: true,
        names: &[],
    },
    Param {
        name: "refine",
        summary: "steps of false position between a slice that is drawn and the one before; 0: none",
        unit: "",
        min: 0.0,
        max: 64.0,
        default: 0.0,
        integer: true,
        names: &[],
    },
    Param::of_names(
        "direction",
        "a: along the base; b, c: upright, at equal u or v; of an object at equal x, y, z; auto: of these \
         what faces the eye most, triangle by triangle; screen: at equal depths",
        &["auto", "a", "b", "c", "screen"],
    ),
    Param::of_names(
        "anchor",
        "with what slices at equal depths move: the eye, or the world's origin",
        &["eye", "object"],
    ),
];

/// How slices run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SliceDirection {
    /// Of the next three what faces the eye most, triangle by triangle.
    Auto,
    /// Along the base; of an object at equal `x`.
    A,
    /// Upright on the base, at equal `u`; of an object at equal `y`.
    B,
    /// Upright on the base, at equal `v`; of an object at equal `z`.
    C,
    /// At equal depths from the eye.
    Screen,
}

/// Which slices a selection shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slices {
    /// How many there are over the whole displacement; 0: they are a texel apart.
    pub count: u32,
    /// How they run.
    pub direction: SliceDirection,
    /// Whether those at equal depths move with the eye; else with the world's origin.
    pub with_eye: bool,
    /// Whether the border of the texture clips those at equal depths; else they end at the relief's sides.
    pub by_border: bool,
}

impl Slices {
    /// Those of the settings, in the order of these, and of the geometry's clipping.
    pub(crate) fn of([count, _, direction, anchor]: [f32; 4], clip: f32) -> Self {
        let direction = match direction as u32 {
            0 => SliceDirection::Auto,
            1 => SliceDirection::A,
            2 => SliceDirection::B,
            3 => SliceDirection::C,
            _ => SliceDirection::Screen,
        };
        Self { count: count as u32, direction, with_eye: anchor == 0.0, by_border: clip != 0.0 }
    }

    /// Why such slices can't be made; none where they can.
    pub(crate) fn refused(&self) -> Option<&'static str> {
        let is_refused = self.by_border && self.direction != SliceDirection::Screen;
        is_refused.then_some("a border clips slices at equal depths alone")
    }
}
