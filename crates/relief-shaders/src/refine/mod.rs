//! Refinements: each converges inside a search's bracket.
//!
//! A new refinement is a `.wesl` and a `.rs` file here and its name in the list below.

use relief_core::FoundState;

use crate::SURVEY;
use crate::entry::Entry;

mod binary;
mod half_texel;
mod none;
mod offset;
mod offset_limited;
mod patch;
mod secant;
mod slope;
mod slope_iterative;
mod trilinear;
mod true_secant;

/// All refinements, in the order of their numbers in the shaders.
pub static ENTRIES: &[Entry] = &[
    none::ENTRY,
    offset::ENTRY,
    offset_limited::ENTRY,
    slope::ENTRY,
    slope_iterative::ENTRY,
    binary::ENTRY,
    secant::ENTRY,
    true_secant::ENTRY,
    patch::ENTRY,
    half_texel::ENTRY,
    trilinear::ENTRY,
];

/// Inputs of a refinement that narrows an interval or corrects a point on the way.
const ANY_INTERVAL: &[FoundState] = &[FoundState::Above, FoundState::Bracket, FoundState::Unbracketed];

/// Inputs of a refinement that changes nothing.
const ALL_STATES: &[FoundState] =
    &[FoundState::Above, FoundState::Below, FoundState::Bracket, FoundState::Unbracketed];
