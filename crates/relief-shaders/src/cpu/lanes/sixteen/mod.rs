//! Sixteen lanes: AVX-512.
//!
//! All operations have the bits of the translation to single numbers.

use std::arch::x86_64::*;

use naga_rust_rt::{Vec2, Vec3, Vec4};

use super::block::{EnteredBlock, HitBlock, PathBlock, PixelOutBlock};
use super::task::Task;
use crate::cpu::Triangle;
use crate::cpu::generated as single;
use crate::cpu::generated::Resources;
use crate::cpu::runtime::{ColorTexture, HeightTexture, MapTexture, Texels};

/// Number of lanes.
const LANES: usize = 16;

/// A 32-bit float in each lane.
#[derive(Clone, Copy)]
struct F(__m512);

/// A signed number in each lane.
#[derive(Clone, Copy)]
struct I(__m512i);

/// An unsigned number in each lane.
#[derive(Clone, Copy)]
struct U(__m512i);

/// A truth value in each lane.
#[derive(Clone, Copy)]
struct M(__mmask16);

/// A short function, compiled into its callers.
macro_rules! lanes {
    ($($item:tt)*) => {
        #[inline]
        #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,f16c")]
        $($item)*
    };
}

/// A function that is compiled by itself, which keeps compiling short.
macro_rules! stage {
    ($($item:tt)*) => {
        #[inline(never)]
        #[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl,f16c")]
        $($item)*
    };
}

/// Functions that are one expression.
macro_rules! operations {
    ($($name:ident($($argument:ident: $kind:ty),*) -> $result:ident = $made:expr;)*) => {
        $(lanes! { fn $name($($argument: $kind),*) -> $result { $result($made) } })*
    };
}

mod memory;
#[path = "../textures.rs"]
mod textures;
#[path = "../../../../generated/lanes.rs"]
#[rustfmt::skip]
#[allow(unused, clippy::all)]
mod stages;
#[path = "../../../../generated/pixel_lanes.rs"]
#[rustfmt::skip]
#[allow(unused, clippy::all)]
mod pixel_stages;
#[path = "../pixels.rs"]
mod pixels;
#[path = "../rows.rs"]
mod rows;
#[path = "../tracing.rs"]
mod tracing;

pub(super) use memory::Sixteen;

use memory::{
    gather, gather_cell, gather_four, gather_of_8, gather_of_16, gather_two, load, row_i, store, store_u,
};
use rows::{load_i, load_m, load_u, row, row_u, store_i};
use textures::{
    color_texel, color_texel_of_each, height_cell, height_texel, height_texel_of_each, map_texel,
    map_texel_of_each, whole_cell,
};

/// Towards minus infinity, and towards infinity.
const DOWN: i32 = _MM_FROUND_TO_NEG_INF | _MM_FROUND_NO_EXC;
const UP: i32 = _MM_FROUND_TO_POS_INF | _MM_FROUND_NO_EXC;

operations! {
    splat(x: f32) -> F = _mm512_set1_ps(x);
    add(a: F, b: F) -> F = _mm512_add_ps(a.0, b.0);
    sub(a: F, b: F) -> F = _mm512_sub_ps(a.0, b.0);
    mul(a: F, b: F) -> F = _mm512_mul_ps(a.0, b.0);
    div(a: F, b: F) -> F = _mm512_div_ps(a.0, b.0);
    sqrt(a: F) -> F = _mm512_sqrt_ps(a.0);
    neg(a: F) -> F = _mm512_xor_ps(a.0, _mm512_set1_ps(-0.0));
    abs(a: F) -> F = _mm512_abs_ps(a.0);
    floor(a: F) -> F = _mm512_roundscale_ps::<DOWN>(a.0);
    ceil(a: F) -> F = _mm512_roundscale_ps::<UP>(a.0);
    // Without NaN the instruction gives its second operand where both are equal; of a NaN the other is left.
    min(a: F, b: F) -> F = _mm512_mask_min_ps(b.0, ordered(a).0, b.0, a.0);
    max(a: F, b: F) -> F = _mm512_mask_max_ps(b.0, ordered(a).0, b.0, a.0);
    // Minimum with a second number that is no NaN.
    min_with(a: F, b: F) -> F = _mm512_min_ps(a.0, b.0);
    max_with(a: F, b: F) -> F = _mm512_max_ps(a.0, b.0);
    lt(a: F, b: F) -> M = _mm512_cmp_ps_mask::<_CMP_LT_OQ>(a.0, b.0);
    le(a: F, b: F) -> M = _mm512_cmp_ps_mask::<_CMP_LE_OQ>(a.0, b.0);
    gt(a: F, b: F) -> M = _mm512_cmp_ps_mask::<_CMP_GT_OQ>(a.0, b.0);
    ge(a: F, b: F) -> M = _mm512_cmp_ps_mask::<_CMP_GE_OQ>(a.0, b.0);
    eq(a: F, b: F) -> M = _mm512_cmp_ps_mask::<_CMP_EQ_OQ>(a.0, b.0);
    ne(a: F, b: F) -> M = _mm512_cmp_ps_mask::<_CMP_NEQ_UQ>(a.0, b.0);
    ordered(a: F) -> M = _mm512_cmp_ps_mask::<_CMP_ORD_Q>(a.0, a.0);
    sel(m: M, a: F, b: F) -> F = _mm512_mask_blend_ps(m.0, b.0, a.0);
    f_of_i(a: I) -> F = _mm512_cvtepi32_ps(a.0);
    f_of_u(a: U) -> F = _mm512_cvtepu32_ps(a.0);
    f_of_half(a: U) -> F = _mm512_cvtph_ps(_mm512_cvtepi32_epi16(a.0));
}

operations! {
    splat_i(x: i32) -> I = _mm512_set1_epi32(x);
    add_i(a: I, b: I) -> I = _mm512_add_epi32(a.0, b.0);
    sub_i(a: I, b: I) -> I = _mm512_sub_epi32(a.0, b.0);
    mul_i(a: I, b: I) -> I = _mm512_mullo_epi32(a.0, b.0);
    min_i(a: I, b: I) -> I = _mm512_min_epi32(a.0, b.0);
    max_i(a: I, b: I) -> I = _mm512_max_epi32(a.0, b.0);
    shl_i(a: I, by: U) -> I = _mm512_sllv_epi32(a.0, by.0);
    shr_i(a: I, by: U) -> I = _mm512_srav_epi32(a.0, by.0);
    lt_i(a: I, b: I) -> M = _mm512_cmplt_epi32_mask(a.0, b.0);
    ge_i(a: I, b: I) -> M = _mm512_cmpge_epi32_mask(a.0, b.0);
    eq_i(a: I, b: I) -> M = _mm512_cmpeq_epi32_mask(a.0, b.0);
    ne_i(a: I, b: I) -> M = _mm512_cmpneq_epi32_mask(a.0, b.0);
    sel_i(m: M, a: I, b: I) -> I = _mm512_mask_blend_epi32(m.0, b.0, a.0);
    i_of_u(a: U) -> I = a.0;
    bits_of_f(a: F) -> I = _mm512_castps_si512(a.0);
    // For a number that is no NaN and in range.
    i_of_small(a: F) -> I = _mm512_cvttps_epi32(a.0);
}

operations! {
    splat_u(x: u32) -> U = _mm512_set1_epi32(x as i32);
    add_u(a: U, b: U) -> U = _mm512_add_epi32(a.0, b.0);
    sub_u(a: U, b: U) -> U = _mm512_sub_epi32(a.0, b.0);
    mul_u(a: U, b: U) -> U = _mm512_mullo_epi32(a.0, b.0);
    xor_u(a: U, b: U) -> U = _mm512_xor_epi32(a.0, b.0);
    min_u(a: U, b: U) -> U = _mm512_min_epu32(a.0, b.0);
    shr_u(a: U, by: I) -> U = _mm512_srlv_epi32(a.0, by.0);
    and_u(a: U, b: U) -> U = _mm512_and_epi32(a.0, b.0);
    lt_u(a: U, b: U) -> M = _mm512_cmplt_epu32_mask(a.0, b.0);
    gt_u(a: U, b: U) -> M = _mm512_cmpgt_epu32_mask(a.0, b.0);
    ge_u(a: U, b: U) -> M = _mm512_cmpge_epu32_mask(a.0, b.0);
    eq_u(a: U, b: U) -> M = _mm512_cmpeq_epi32_mask(a.0, b.0);
    ne_u(a: U, b: U) -> M = _mm512_cmpneq_epi32_mask(a.0, b.0);
    sel_u(m: M, a: U, b: U) -> U = _mm512_mask_blend_epi32(m.0, b.0, a.0);
    u_of_i(a: I) -> U = a.0;
}

operations! {
    splat_m(yes: bool) -> M = 0u16.wrapping_sub(u16::from(yes));
    no_lane() -> M = 0;
    // The lanes of a number's lowest bits.
    lanes_of(bits: u32) -> M = bits as u16;
    and(a: M, b: M) -> M = a.0 & b.0;
    and_not(a: M, b: M) -> M = a.0 & !b.0;
    or(a: M, b: M) -> M = a.0 | b.0;
    not(a: M) -> M = !a.0;
    eq_m(a: M, b: M) -> M = !(a.0 ^ b.0);
    sel_m(m: M, a: M, b: M) -> M = (m.0 & a.0) | (b.0 & !m.0);
}

lanes! { fn any(m: M) -> bool { m.0 != 0 } }
lanes! { fn none(m: M) -> bool { m.0 == 0 } }
lanes! { fn bits_of(m: M) -> u32 { u32::from(m.0) } }

// Converts towards zero. NaN gives 0, and a number out of range the nearest one.
lanes! { fn i_of_f(a: F) -> I {
    let near = _mm512_cvttps_epi32(a.0);
    let above = ge(a, splat(2_147_483_648.0));
    let near = _mm512_mask_mov_epi32(near, above.0, _mm512_set1_epi32(i32::MAX));
    I(_mm512_maskz_mov_epi32(ordered(a).0, near))
} }

// Converts to numbers without a sign, in the same way.
lanes! { fn u_of_f(a: F) -> U {
    // A number beyond the greatest becomes the greatest.
    U(_mm512_cvttps_epu32(max_with(a, splat(0.0)).0))
} }

// The remainder with the sign of the first number. Quotients of 32-bit numbers that are rounded to `f64` are
// not rounded up to the next whole number, so that cutting them off is exact. By zero it is some number.
lanes! { fn rem_i(a: I, b: I) -> I {
    let quotient = |a: __m256i, b: __m256i| {
        _mm512_cvttpd_epi32(_mm512_div_pd(_mm512_cvtepi32_pd(a), _mm512_cvtepi32_pd(b)))
    };
    let low = quotient(_mm512_castsi512_si256(a.0), _mm512_castsi512_si256(b.0));
    let high = quotient(_mm512_extracti64x4_epi64::<1>(a.0), _mm512_extracti64x4_epi64::<1>(b.0));
    let whole = _mm512_inserti64x4::<1>(_mm512_castsi256_si512(low), high);
    sub_i(a, mul_i(I(whole), b))
} }
