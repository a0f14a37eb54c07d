//! Rows of numbers, and calls of functions that need the instructions.

use super::*;

/// Four lanes, which the whole module needs: there is nothing to check.
#[derive(Clone, Copy, Debug)]
pub(in crate::cpu::lanes) struct Four(());

impl Four {
    pub(in crate::cpu::lanes) fn new() -> Option<Self> {
        Some(Self(()))
    }

    /// Does a task for the places that `which` has bits for.
    pub(in crate::cpu::lanes) fn run(self, r: &Resources<'_>, which: u16, task: Task<'_>) {
        pixels::run(r, which, task);
    }
}

lanes! {
    /// Loads a row of numbers.
    pub(super) fn load(row: &[f32; LANES]) -> F {
        let [x, y, z, w] = *row;
        F(f32x4(x, y, z, w))
    }
}

lanes! {
    /// Returns the number of each lane.
    pub(super) fn row_i(values: I) -> [i32; LANES] {
        [
            i32x4_extract_lane::<0>(values.0),
            i32x4_extract_lane::<1>(values.0),
            i32x4_extract_lane::<2>(values.0),
            i32x4_extract_lane::<3>(values.0),
        ]
    }
}
