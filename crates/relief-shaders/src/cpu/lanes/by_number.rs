//! Memory by index, number by number, for vectors without gathers, included once for each of their widths.

use super::memory::{load, row_i};
use super::*;

lanes! {
    /// Loads the numbers at these places; 0 for places outside.
    pub(in crate::cpu::lanes) fn gather(values: &[f32], at: I) -> F {
        let read = |at: i32| values.get(usize::try_from(at).ok()?).copied();
        load(&row_i(at).map(|at| read(at).unwrap_or(0.0)))
    }
}

lanes! {
    /// Loads the number at a place and the next one, in each lane; 0 for places outside.
    pub(in crate::cpu::lanes) fn gather_two(values: &[f32], at: I) -> Vec2<F> {
        Vec2 { x: gather(values, at), y: gather(values, add_i(at, splat_i(1))) }
    }
}

lanes! {
    /// Loads the numbers at a place and after it, and the same two `width` numbers further on. Any
    /// numbers if not all four exist.
    pub(in crate::cpu::lanes) fn gather_cell(values: &[f32], width: usize, at: I) -> Vec4<F> {
        let below = add_i(at, splat_i(width as i32));
        let (above, below) = (gather_two(values, at), gather_two(values, below));
        Vec4 { x: above.x, y: above.y, z: below.x, w: below.y }
    }
}

lanes! {
    /// Loads the texels of four numbers at these places; 0 for places outside.
    pub(in crate::cpu::lanes) fn gather_four(texels: &[[f32; 4]], at: I) -> Vec4<F> {
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
    pub(in crate::cpu::lanes) fn gather_of_8(values: &[u8], at: I) -> U {
        let read = |at: i32| values.get(usize::try_from(at).ok()?..)?.first_chunk();
        load_u(&row_i(at).map(|at| read(at).map_or(0, |bytes| u32::from_le_bytes(*bytes))))
    }
}

lanes! {
    /// Loads four bytes from these places on, of numbers of two bytes. Places count bytes, and are
    /// even.
    pub(in crate::cpu::lanes) fn gather_of_16(values: &[u16], at: I) -> U {
        let read = |at: i32| values.get(usize::try_from(at).ok()? / 2..)?.first_chunk();
        let both = |[low, high]: &[u16; 2]| u32::from(*low) | u32::from(*high) << 16;
        load_u(&row_i(at).map(|at| read(at).map_or(0, both)))
    }
}

lanes! {
    /// Writes the lanes of a mask to a row.
    pub(in crate::cpu::lanes) fn store(row: &mut [f32; LANES], which: M, values: F) {
        *row = super::row(sel(which, values, load(row)));
    }
}

lanes! {
    /// Writes the lanes of a mask to a row.
    pub(in crate::cpu::lanes) fn store_u(row: &mut [u32; LANES], which: M, values: U) {
        *row = row_u(sel_u(which, values, load_u(row)));
    }
}
