//! Unsafe code for sixteen lanes: memory by index or pointer, and calls of functions that need
//! instructions which the machine was checked for.

#![allow(unsafe_code)]

use super::*;

/// Proof that the machine has the instructions.
#[derive(Clone, Copy, Debug)]
pub(in crate::cpu::lanes) struct Sixteen(());

impl Sixteen {
    /// Returns the proof, if the machine has the instructions.
    pub(in crate::cpu::lanes) fn new() -> Option<Self> {
        let has_all = is_x86_feature_detected!("avx512f")
            && is_x86_feature_detected!("avx512dq")
            && is_x86_feature_detected!("avx512bw")
            && is_x86_feature_detected!("avx512vl")
            && is_x86_feature_detected!("f16c");
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
        F(unsafe { _mm512_mask_i32gather_ps::<4>(_mm512_setzero_ps(), inside.0, at.0, values.as_ptr()) })
    }
}

lanes! {
    /// Loads the number at a place and the next one, in each lane. Any numbers if not both exist.
    pub(super) fn gather_two(values: &[f32], at: I) -> Vec2<F> {
        let cell = gather_cell(values, 0, at);
        Vec2 { x: cell.x, y: cell.y }
    }
}

lanes! {
    /// Loads the numbers at a place and after it, and the same two `width` numbers further on. Any
    /// numbers if not all four exist.
    pub(super) fn gather_cell(values: &[f32], width: usize, at: I) -> Vec4<F> {
        let count = values.len().min(i32::MAX as usize).saturating_sub(width.saturating_add(1)) as u32;
        let inside = lt_u(u_of_i(at), splat_u(count)).0;
        let places = [_mm512_castsi512_si256(at.0), _mm512_extracti64x4_epi64::<1>(at.0)];
        // Both numbers of a line are read at once.
        let pairs = |start: usize| {
            let (zero, pairs) = (_mm512_setzero_pd(), values.as_ptr().wrapping_add(start).cast());
            // SAFETY: lanes of `inside` alone are read. After their place there are a line and one number
            // more, and it is less than 2^31, so that it is not taken for a negative one. A gather needs no
            // alignment.
            let [low, high] = unsafe {
                [
                    _mm512_mask_i32gather_pd::<4>(zero, inside as u8, places[0], pairs),
                    _mm512_mask_i32gather_pd::<4>(zero, (inside >> 8) as u8, places[1], pairs),
                ]
            };
            let (low, high) = (_mm512_castpd_ps(low), _mm512_castpd_ps(high));
            let first = _mm512_setr_epi32(0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30);
            let second = _mm512_setr_epi32(1, 3, 5, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31);
            (F(_mm512_permutex2var_ps(low, first, high)), F(_mm512_permutex2var_ps(low, second, high)))
        };
        let ((x, y), (z, w)) = (pairs(0), pairs(width));
        Vec4 { x, y, z, w }
    }
}

lanes! {
    /// Loads the texels of four numbers at these places; 0 for places outside.
    pub(super) fn gather_four(texels: &[[f32; 4]], at: I) -> Vec4<F> {
        let (values, first) = (texels.as_flattened(), mul_i(at, splat_i(4)));
        let low = gather_two(values, first);
        let high = gather_two(values, add_i(first, splat_i(2)));
        Vec4 { x: low.x, y: low.y, z: high.x, w: high.y }
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
            _mm512_mask_i32gather_epi32::<1>(_mm512_setzero_si512(), inside.0, at.0, values.as_ptr().cast())
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
            _mm512_mask_i32gather_epi32::<1>(_mm512_setzero_si512(), inside.0, at.0, values.as_ptr().cast())
        })
    }
}

lanes! {
    /// Loads a row of numbers.
    pub(super) fn load(row: &[f32; LANES]) -> F {
        // SAFETY: the row has as many numbers as are read, which need no alignment.
        F(unsafe { _mm512_loadu_ps(row.as_ptr()) })
    }
}

lanes! {
    /// Writes the lanes of a mask to a row.
    pub(super) fn store(row: &mut [f32; LANES], which: M, values: F) {
        // SAFETY: the row has as many numbers as may be written, which need no alignment.
        unsafe { _mm512_mask_storeu_ps(row.as_mut_ptr(), which.0, values.0) }
    }
}

lanes! {
    /// Writes the lanes of a mask to a row.
    pub(super) fn store_u(row: &mut [u32; LANES], which: M, values: U) {
        // SAFETY: the row has as many numbers as may be written, which need no alignment.
        unsafe { _mm512_mask_storeu_epi32(row.as_mut_ptr().cast(), which.0, values.0) }
    }
}

lanes! {
    /// Returns the number of each lane.
    pub(super) fn row_i(values: I) -> [i32; LANES] {
        let mut row = [0; LANES];
        // SAFETY: the row has as many numbers as are written, which need no alignment.
        unsafe { _mm512_storeu_si512(row.as_mut_ptr().cast(), values.0) };
        row
    }
}
