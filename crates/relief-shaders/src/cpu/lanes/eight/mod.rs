//! Eight lanes: AVX2.
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
const LANES: usize = 8;

/// A 32-bit float in each lane.
#[derive(Clone, Copy)]
struct F(__m256);

/// A signed number in each lane.
#[derive(Clone, Copy)]
struct I(__m256i);

/// An unsigned number in each lane.
#[derive(Clone, Copy)]
struct U(__m256i);

/// A truth value in each lane.
#[derive(Clone, Copy)]
struct M(__m256);

/// A short function, compiled into its callers.
macro_rules! lanes {
    ($($item:tt)*) => {
        #[inline]
        #[target_feature(enable = "avx2,f16c")]
        $($item)*
    };
}

/// A function that is compiled by itself, which keeps compiling short.
macro_rules! stage {
    ($($item:tt)*) => {
        #[inline(never)]
        #[target_feature(enable = "avx2,f16c")]
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

pub(super) use memory::Eight;

use memory::{
    gather, gather_cell, gather_four, gather_of_8, gather_of_16, gather_two, load, row_i, store, store_u,
};
use rows::{load_i, load_m, load_u, row, row_u, store_i};
use textures::{
    color_texel, color_texel_of_each, height_cell, height_texel, height_texel_of_each, map_texel,
    map_texel_of_each, whole_cell,
};

operations! {
    splat(x: f32) -> F = _mm256_set1_ps(x);
    add(a: F, b: F) -> F = _mm256_add_ps(a.0, b.0);
    sub(a: F, b: F) -> F = _mm256_sub_ps(a.0, b.0);
    mul(a: F, b: F) -> F = _mm256_mul_ps(a.0, b.0);
    div(a: F, b: F) -> F = _mm256_div_ps(a.0, b.0);
    sqrt(a: F) -> F = _mm256_sqrt_ps(a.0);
    neg(a: F) -> F = _mm256_xor_ps(a.0, _mm256_set1_ps(-0.0));
    abs(a: F) -> F = _mm256_andnot_ps(_mm256_set1_ps(-0.0), a.0);
    floor(a: F) -> F = _mm256_floor_ps(a.0);
    ceil(a: F) -> F = _mm256_ceil_ps(a.0);
    // Without NaN the instruction gives its second operand where both are equal; of a NaN the other is left.
    min(a: F, b: F) -> F = sel(ordered(a), F(_mm256_min_ps(b.0, a.0)), b).0;
    max(a: F, b: F) -> F = sel(ordered(a), F(_mm256_max_ps(b.0, a.0)), b).0;
    // Minimum with a second number that is no NaN.
    min_with(a: F, b: F) -> F = _mm256_min_ps(a.0, b.0);
    max_with(a: F, b: F) -> F = _mm256_max_ps(a.0, b.0);
    lt(a: F, b: F) -> M = _mm256_cmp_ps::<_CMP_LT_OQ>(a.0, b.0);
    le(a: F, b: F) -> M = _mm256_cmp_ps::<_CMP_LE_OQ>(a.0, b.0);
    gt(a: F, b: F) -> M = _mm256_cmp_ps::<_CMP_GT_OQ>(a.0, b.0);
    ge(a: F, b: F) -> M = _mm256_cmp_ps::<_CMP_GE_OQ>(a.0, b.0);
    eq(a: F, b: F) -> M = _mm256_cmp_ps::<_CMP_EQ_OQ>(a.0, b.0);
    ne(a: F, b: F) -> M = _mm256_cmp_ps::<_CMP_NEQ_UQ>(a.0, b.0);
    ordered(a: F) -> M = _mm256_cmp_ps::<_CMP_ORD_Q>(a.0, a.0);
    sel(m: M, a: F, b: F) -> F = _mm256_blendv_ps(b.0, a.0, m.0);
    f_of_i(a: I) -> F = _mm256_cvtepi32_ps(a.0);
    // Both halves are exact, so that their sum is rounded once.
    f_of_u(a: U) -> F = {
        let (high, low) = (_mm256_srli_epi32::<16>(a.0), and_u(a, splat_u(0xffff)).0);
        let high = _mm256_mul_ps(_mm256_cvtepi32_ps(high), _mm256_set1_ps(65536.0));
        _mm256_add_ps(high, _mm256_cvtepi32_ps(low))
    };
    f_of_half(a: U) -> F = _mm256_cvtph_ps(
        _mm_packus_epi32(_mm256_castsi256_si128(a.0), _mm256_extracti128_si256::<1>(a.0))
    );
}

operations! {
    splat_i(x: i32) -> I = _mm256_set1_epi32(x);
    add_i(a: I, b: I) -> I = _mm256_add_epi32(a.0, b.0);
    sub_i(a: I, b: I) -> I = _mm256_sub_epi32(a.0, b.0);
    mul_i(a: I, b: I) -> I = _mm256_mullo_epi32(a.0, b.0);
    min_i(a: I, b: I) -> I = _mm256_min_epi32(a.0, b.0);
    max_i(a: I, b: I) -> I = _mm256_max_epi32(a.0, b.0);
    shl_i(a: I, by: U) -> I = _mm256_sllv_epi32(a.0, by.0);
    shr_i(a: I, by: U) -> I = _mm256_srav_epi32(a.0, by.0);
    lt_i(a: I, b: I) -> M = _mm256_castsi256_ps(_mm256_cmpgt_epi32(b.0, a.0));
    ge_i(a: I, b: I) -> M = not(lt_i(a, b)).0;
    eq_i(a: I, b: I) -> M = _mm256_castsi256_ps(_mm256_cmpeq_epi32(a.0, b.0));
    ne_i(a: I, b: I) -> M = not(eq_i(a, b)).0;
    sel_i(m: M, a: I, b: I) -> I = _mm256_blendv_epi8(b.0, a.0, _mm256_castps_si256(m.0));
    i_of_u(a: U) -> I = a.0;
    bits_of_f(a: F) -> I = _mm256_castps_si256(a.0);
    // For a number that is no NaN and in range.
    i_of_small(a: F) -> I = _mm256_cvttps_epi32(a.0);
}

operations! {
    splat_u(x: u32) -> U = _mm256_set1_epi32(x as i32);
    add_u(a: U, b: U) -> U = _mm256_add_epi32(a.0, b.0);
    sub_u(a: U, b: U) -> U = _mm256_sub_epi32(a.0, b.0);
    mul_u(a: U, b: U) -> U = _mm256_mullo_epi32(a.0, b.0);
    xor_u(a: U, b: U) -> U = _mm256_xor_si256(a.0, b.0);
    min_u(a: U, b: U) -> U = _mm256_min_epu32(a.0, b.0);
    shr_u(a: U, by: I) -> U = _mm256_srlv_epi32(a.0, by.0);
    and_u(a: U, b: U) -> U = _mm256_and_si256(a.0, b.0);
    lt_u(a: U, b: U) -> M = gt_u(b, a).0;
    gt_u(a: U, b: U) -> M = ne_u(min_u(a, b), a).0;
    ge_u(a: U, b: U) -> M = not(lt_u(a, b)).0;
    eq_u(a: U, b: U) -> M = _mm256_castsi256_ps(_mm256_cmpeq_epi32(a.0, b.0));
    ne_u(a: U, b: U) -> M = not(eq_u(a, b)).0;
    sel_u(m: M, a: U, b: U) -> U = _mm256_blendv_epi8(b.0, a.0, _mm256_castps_si256(m.0));
    u_of_i(a: I) -> U = a.0;
}

operations! {
    splat_m(yes: bool) -> M = _mm256_castsi256_ps(_mm256_set1_epi32(-i32::from(yes)));
    no_lane() -> M = _mm256_setzero_ps();
    // The lanes of a number's lowest bits.
    lanes_of(bits: u32) -> M = {
        let own = splat_u_each();
        eq_u(and_u(splat_u(bits), own), own).0
    };
    and(a: M, b: M) -> M = _mm256_and_ps(a.0, b.0);
    and_not(a: M, b: M) -> M = _mm256_andnot_ps(b.0, a.0);
    or(a: M, b: M) -> M = _mm256_or_ps(a.0, b.0);
    not(a: M) -> M = _mm256_xor_ps(a.0, splat_m(true).0);
    eq_m(a: M, b: M) -> M = not(M(_mm256_xor_ps(a.0, b.0))).0;
    sel_m(m: M, a: M, b: M) -> M = _mm256_blendv_ps(b.0, a.0, m.0);
    // A bit for each lane.
    splat_u_each() -> U = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
}

lanes! { fn any(m: M) -> bool { bits_of(m) != 0 } }
lanes! { fn none(m: M) -> bool { bits_of(m) == 0 } }
lanes! { fn bits_of(m: M) -> u32 { _mm256_movemask_ps(m.0) as u32 } }

// Converts towards zero. NaN gives 0, and a number out of range the nearest one.
lanes! { fn i_of_f(a: F) -> I {
    // Out of range the instruction gives the least number; its bits inverted are the greatest.
    let above = _mm256_castps_si256(ge(a, splat(2_147_483_648.0)).0);
    let near = _mm256_xor_si256(_mm256_cvttps_epi32(a.0), above);
    I(_mm256_and_si256(near, _mm256_castps_si256(ordered(a).0)))
} }

// Converts to numbers without a sign, in the same way.
lanes! { fn u_of_f(a: F) -> U {
    let positive = max_with(a, splat(0.0));
    let is_high = ge(positive, splat(2_147_483_648.0));
    let is_beyond = _mm256_castps_si256(ge(positive, splat(4_294_967_296.0)).0);
    let low = sel(is_high, sub(positive, splat(2_147_483_648.0)), positive);
    let top = sel_u(is_high, splat_u(1 << 31), splat_u(0));
    U(_mm256_or_si256(_mm256_xor_si256(_mm256_cvttps_epi32(low.0), top.0), is_beyond))
} }

// The remainder with the sign of the first number. Quotients of 32-bit numbers that are rounded to `f64` are
// not rounded up to the next whole number, so that cutting them off is exact. By zero it is some number.
lanes! { fn rem_i(a: I, b: I) -> I {
    let quotient = |a: __m128i, b: __m128i| {
        _mm256_cvttpd_epi32(_mm256_div_pd(_mm256_cvtepi32_pd(a), _mm256_cvtepi32_pd(b)))
    };
    let low = quotient(_mm256_castsi256_si128(a.0), _mm256_castsi256_si128(b.0));
    let high = quotient(_mm256_extracti128_si256::<1>(a.0), _mm256_extracti128_si256::<1>(b.0));
    sub_i(a, mul_i(I(_mm256_set_m128i(high, low)), b))
} }
