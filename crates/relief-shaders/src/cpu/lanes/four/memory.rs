//! Rows of numbers, and unsafe calls of functions that need instructions which the machine was checked for.

use std::arch::is_aarch64_feature_detected;

use super::*;

/// Proof that the machine has the instructions.
#[derive(Clone, Copy, Debug)]
pub(in crate::cpu::lanes) struct Four(());

impl Four {
    /// Returns the proof, if the machine has the instructions.
    pub(in crate::cpu::lanes) fn new() -> Option<Self> {
        is_aarch64_feature_detected!("neon").then_some(Self(()))
    }

    /// Does a task for the places that `which` has bits for.
    #[allow(unsafe_code)]
    pub(in crate::cpu::lanes) fn run(self, r: &Resources<'_>, which: u16, task: Task<'_>) {
        // SAFETY: values of this type exist only on machines with the instructions.
        unsafe { pixels::run(r, which, task) }
    }
}

lanes! {
    /// Loads a row of numbers.
    pub(super) fn load(row: &[f32; LANES]) -> F {
        let [x, y, z, w] = *row;
        let values = vsetq_lane_f32::<1>(y, vdupq_n_f32(x));
        F(vsetq_lane_f32::<3>(w, vsetq_lane_f32::<2>(z, values)))
    }
}

lanes! {
    /// Returns the number of each lane.
    pub(super) fn row_i(values: I) -> [i32; LANES] {
        [
            vgetq_lane_s32::<0>(values.0),
            vgetq_lane_s32::<1>(values.0),
            vgetq_lane_s32::<2>(values.0),
            vgetq_lane_s32::<3>(values.0),
        ]
    }
}
