//! Memory by index, number by number, as the web's vectors have no gathers.

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
    /// Loads the numbers at these places; 0 for places outside.
    pub(super) fn gather(values: &[f32], at: I) -> F {
        let read = |at: i32| values.get(usize::try_from(at).ok()?).copied();
        load(&row_i(at).map(|at| read(at).unwrap_or(0.0)))
    }
}

lanes! {
    /// Loads the number at a place and the next one, in each lane; 0 for places outside.
    pub(super) fn gather_two(values: &[f32], at: I) -> Vec2<F> {
        Vec2 { x: gather(values, at), y: gather(values, add_i(at, splat_i(1))) }
    }
}

lanes! {
    /// Loads the numbers at a place and after it, and the same two `width` numbers further on. Any
    /// numbers if not all four exist.
    pub(super) fn gather_cell(values: &[f32], width: usize, at: I) -> Vec4<F> {
        let below = add_i(at, splat_i(width as i32));
        let (above, below) = (gather_two(values, at), gather_two(values, below));
        Vec4 { x: above.x, y: above.y, z: below.x, w: below.y }
    }
}

lanes! {
    /// Loads the texels of four numbers at these places; 0 for places outside.
    pub(super) fn gather_four(texels: &[[f32; 4]], at: I) -> Vec4<F> {
        let (values, first) = (texels.as_flattened(), mul_i(at, splat_i(4)));
        let after = |by: i32| add_i(first, splat_i(by));
        Vec4 {
            x: gather(values, first),
            y: gather(values, after(1)),
            z: gather(values, after(2)),
            w: gather(values, after(3)),
        }
    }
}

lanes! {
    /// Loads four bytes from these places on; 0 if not all four exist.
    pub(super) fn gather_of_8(values: &[u8], at: I) -> U {
        let read = |at: i32| values.get(usize::try_from(at).ok()?..)?.first_chunk();
        load_u(&row_i(at).map(|at| read(at).map_or(0, |bytes| u32::from_le_bytes(*bytes))))
    }
}

lanes! {
    /// Loads four bytes from these places on, of numbers of two bytes. Places count bytes, and are
    /// even.
    pub(super) fn gather_of_16(values: &[u16], at: I) -> U {
        let read = |at: i32| values.get(usize::try_from(at).ok()? / 2..)?.first_chunk();
        let both = |[low, high]: &[u16; 2]| u32::from(*low) | u32::from(*high) << 16;
        load_u(&row_i(at).map(|at| read(at).map_or(0, both)))
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
    /// Writes the lanes of a mask to a row.
    pub(super) fn store(row: &mut [f32; LANES], which: M, values: F) {
        *row = super::row(sel(which, values, load(row)));
    }
}

lanes! {
    /// Writes the lanes of a mask to a row.
    pub(super) fn store_u(row: &mut [u32; LANES], which: M, values: U) {
        *row = row_u(sel_u(which, values, load_u(row)));
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
