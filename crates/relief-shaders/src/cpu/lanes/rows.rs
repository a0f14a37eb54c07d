//! Values of all lanes as rows in memory, included once for each width.

use super::*;

lanes! {
    /// Returns the number of each lane.
    pub(super) fn row(values: F) -> [f32; LANES] {
        row_i(bits_of_f(values)).map(|bits| f32::from_bits(bits as u32))
    }
}

lanes! {
    /// Returns the number of each lane.
    pub(super) fn row_u(values: U) -> [u32; LANES] {
        row_i(i_of_u(values)).map(|number| number as u32)
    }
}

lanes! {
    /// Loads a row of numbers.
    pub(super) fn load_i(row: &[i32; LANES]) -> I {
        bits_of_f(load(&row.map(|number| f32::from_bits(number as u32))))
    }
}

lanes! {
    /// Loads a row of numbers.
    pub(super) fn load_u(row: &[u32; LANES]) -> U {
        u_of_i(bits_of_f(load(&row.map(f32::from_bits))))
    }
}

lanes! {
    /// Loads a mask.
    pub(super) fn load_m(row: &[bool; LANES]) -> M {
        lanes_of(row.iter().enumerate().fold(0, |bits, (lane, yes)| bits | u32::from(*yes) << lane))
    }
}

lanes! {
    /// Writes the lanes of a mask to a row.
    pub(super) fn store_i(row: &mut [i32; LANES], which: M, values: I) {
        let mut bits = row.map(|number| number as u32);
        store_u(&mut bits, which, u_of_i(values));
        *row = bits.map(|number| number as i32);
    }
}
