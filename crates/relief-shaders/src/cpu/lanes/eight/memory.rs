//! Unsafe code for eight lanes: memory by index or pointer, and calls of functions that need
//! instructions which the machine was checked for.

#![allow(unsafe_code)]

use super::*;

/// Proof that the machine has the instructions.
#[derive(Clone, Copy, Debug)]
pub(in crate::cpu::lanes) struct Eight(());

impl Eight {
    /// Returns the proof, if the machine has the instructions.
    pub(in crate::cpu::lanes) fn new() -> Option<Self> {
        let has_all = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("f16c");
        has_all.then_some(Self(()))
    }

    /// Does a task for the places that `which` has bits for.
    pub(in crate::cpu::lanes) fn run(self, r: &Resources<'_>, which: u16, task: Task<'_>) {
        // SAFETY: values of this type exist only on machines with the instructions.
        unsafe { pixels::run(r, which, task) }
    }
}

lanes! {
    /// Loads the numbers at these places; 0 for places outside.
    pub(super) fn gather(values: &[f32], at: I) -> F {
        let count = values.len().min(i32::MAX as usize) as u32;
        let inside = lt_u(u_of_i(at), splat_u(count));
        // SAFETY: lanes of `inside` alone are read. Their index is less than the number of values and less
        // than 2^31, so that it is not taken for a negative one.
        F(unsafe { _mm256_mask_i32gather_ps::<4>(_mm256_setzero_ps(), values.as_ptr(), at.0, inside.0) })
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
    /// numbers if not all four exist. Fetched two by two they take longer here.
    pub(super) fn gather_cell(values: &[f32], width: usize, at: I) -> Vec4<F> {
        let count = values.len().min(i32::MAX as usize).saturating_sub(width.saturating_add(1)) as u32;
        let inside = lt_u(u_of_i(at), splat_u(count));
        // SAFETY: lanes of `inside` alone are read. After their place there are a line and one number more,
        // and it is less than 2^31, so that it is not taken for a negative one.
        let from = |start: usize| unsafe {
            let values = values.as_ptr().wrapping_add(start);
            F(_mm256_mask_i32gather_ps::<4>(_mm256_setzero_ps(), values, at.0, inside.0))
        };
        Vec4 { x: from(0), y: from(1), z: from(width), w: from(width.wrapping_add(1)) }
    }
}

lanes! {
    /// Loads the texels of four numbers at these places; 0 for places outside. Each is loaded as a
    /// whole: gathers would fetch every number by itself.
    pub(super) fn gather_four(texels: &[[f32; 4]], at: I) -> Vec4<F> {
        let rows = row_i(at).map(|at| {
            let [x, y, z, w] = texels.get(at as u32 as usize).copied().unwrap_or_default();
            _mm_setr_ps(x, y, z, w)
        });
        let [a, b, c, d] = [0, 1, 2, 3].map(|lane| _mm256_set_m128(rows[lane + 4], rows[lane]));
        let (low_ab, high_ab) = (_mm256_unpacklo_ps(a, b), _mm256_unpackhi_ps(a, b));
        let (low_cd, high_cd) = (_mm256_unpacklo_ps(c, d), _mm256_unpackhi_ps(c, d));
        Vec4 {
            x: F(_mm256_shuffle_ps::<0b01_00_01_00>(low_ab, low_cd)),
            y: F(_mm256_shuffle_ps::<0b11_10_11_10>(low_ab, low_cd)),
            z: F(_mm256_shuffle_ps::<0b01_00_01_00>(high_ab, high_cd)),
            w: F(_mm256_shuffle_ps::<0b11_10_11_10>(high_ab, high_cd)),
        }
    }
}

lanes! {
    /// Loads four bytes from these places on; 0 if not all four exist.
    pub(super) fn gather_of_8(values: &[u8], at: I) -> U {
        let count = values.len().min(i32::MAX as usize).saturating_sub(3) as u32;
        let inside = lt_u(u_of_i(at), splat_u(count));
        // SAFETY: lanes of `inside` alone are read. Their place is less than 2^31, and has three bytes after
        // it in the slice. A gather needs no alignment.
        U(unsafe {
            let (zero, which) = (_mm256_setzero_si256(), _mm256_castps_si256(inside.0));
            _mm256_mask_i32gather_epi32::<1>(zero, values.as_ptr().cast(), at.0, which)
        })
    }
}

lanes! {
    /// Loads four bytes from these places on, of numbers of two bytes. Places count bytes.
    pub(super) fn gather_of_16(values: &[u16], at: I) -> U {
        let count = size_of_val(values).min(i32::MAX as usize).saturating_sub(3) as u32;
        let inside = lt_u(u_of_i(at), splat_u(count));
        // SAFETY: as for single bytes; the count is in bytes.
        U(unsafe {
            let (zero, which) = (_mm256_setzero_si256(), _mm256_castps_si256(inside.0));
            _mm256_mask_i32gather_epi32::<1>(zero, values.as_ptr().cast(), at.0, which)
        })
    }
}

lanes! {
    /// Loads a row of numbers.
    pub(super) fn load(row: &[f32; LANES]) -> F {
        // SAFETY: the row has as many numbers as are read, which need no alignment.
        F(unsafe { _mm256_loadu_ps(row.as_ptr()) })
    }
}

lanes! {
    /// Writes the lanes of a mask to a row.
    pub(super) fn store(row: &mut [f32; LANES], which: M, values: F) {
        // SAFETY: the row has as many numbers as may be written, which need no alignment.
        unsafe { _mm256_maskstore_ps(row.as_mut_ptr(), _mm256_castps_si256(which.0), values.0) }
    }
}

lanes! {
    /// Writes the lanes of a mask to a row.
    pub(super) fn store_u(row: &mut [u32; LANES], which: M, values: U) {
        // SAFETY: the row has as many numbers as may be written, which need no alignment.
        unsafe { _mm256_maskstore_epi32(row.as_mut_ptr().cast(), _mm256_castps_si256(which.0), values.0) }
    }
}

lanes! {
    /// Returns the number of each lane.
    pub(super) fn row_i(values: I) -> [i32; LANES] {
        let mut row = [0; LANES];
        // SAFETY: the row has as many numbers as are written, which need no alignment.
        unsafe { _mm256_storeu_si256(row.as_mut_ptr().cast(), values.0) };
        row
    }
}
