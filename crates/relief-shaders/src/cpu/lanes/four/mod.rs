//! Four lanes: NEON.
//!
//! All operations have the bits of the translation to single numbers.

use std::arch::aarch64::*;

use naga_rust_rt::{Vec2, Vec3, Vec4};

use super::block::{EnteredBlock, HitBlock, PathBlock, PixelOutBlock};
use super::task::Task;
use crate::cpu::Triangle;
use crate::cpu::generated as single;
use crate::cpu::generated::Resources;
use crate::cpu::runtime::{ColorTexture, HeightTexture, MapTexture, Texels};

/// Number of lanes.
const LANES: usize = 4;

/// A 32-bit float in each lane.
#[derive(Clone, Copy)]
struct F(float32x4_t);

/// A signed number in each lane.
#[derive(Clone, Copy)]
struct I(int32x4_t);

/// An unsigned number in each lane.
#[derive(Clone, Copy)]
struct U(uint32x4_t);

/// A truth value in each lane.
#[derive(Clone, Copy)]
struct M(uint32x4_t);

/// A short function, compiled into its callers.
macro_rules! lanes {
    ($($item:tt)*) => {
        #[inline]
        #[target_feature(enable = "neon")]
        $($item)*
    };
}

/// A function that is compiled by itself, which keeps compiling short.
macro_rules! stage {
    ($($item:tt)*) => {
        #[inline(never)]
        #[target_feature(enable = "neon")]
        $($item)*
    };
}

/// Functions that are one expression.
macro_rules! operations {
    ($($name:ident($($argument:ident: $kind:ty),*) -> $result:ident = $made:expr;)*) => {
        $(lanes! { fn $name($($argument: $kind),*) -> $result { $result($made) } })*
    };
}

#[path = "../by_number.rs"]
mod by_number;
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

pub(super) use memory::Four;

use by_number::{gather, gather_cell, gather_four, gather_of_8, gather_of_16, gather_two, store, store_u};
use memory::{load, row_i};
use rows::{load_i, load_m, load_u, row, row_u, store_i};
use textures::{
    color_texel, color_texel_of_each, height_cell, height_texel, height_texel_of_each, map_texel,
    map_texel_of_each, whole_cell,
};

operations! {
    splat(x: f32) -> F = vdupq_n_f32(x);
    add(a: F, b: F) -> F = vaddq_f32(a.0, b.0);
    sub(a: F, b: F) -> F = vsubq_f32(a.0, b.0);
    mul(a: F, b: F) -> F = vmulq_f32(a.0, b.0);
    div(a: F, b: F) -> F = vdivq_f32(a.0, b.0);
    sqrt(a: F) -> F = vsqrtq_f32(a.0);
    neg(a: F) -> F = vnegq_f32(a.0);
    abs(a: F) -> F = vabsq_f32(a.0);
    floor(a: F) -> F = vrndmq_f32(a.0);
    ceil(a: F) -> F = vrndpq_f32(a.0);
    // The same instructions as for single numbers on such machines: a NaN gives the other number.
    min(a: F, b: F) -> F = vminnmq_f32(a.0, b.0);
    max(a: F, b: F) -> F = vmaxnmq_f32(a.0, b.0);
    // Minimum with a second number that is no NaN.
    min_with(a: F, b: F) -> F = vminnmq_f32(a.0, b.0);
    max_with(a: F, b: F) -> F = vmaxnmq_f32(a.0, b.0);
    lt(a: F, b: F) -> M = vcltq_f32(a.0, b.0);
    le(a: F, b: F) -> M = vcleq_f32(a.0, b.0);
    gt(a: F, b: F) -> M = vcgtq_f32(a.0, b.0);
    ge(a: F, b: F) -> M = vcgeq_f32(a.0, b.0);
    eq(a: F, b: F) -> M = vceqq_f32(a.0, b.0);
    ne(a: F, b: F) -> M = not(eq(a, b)).0;
    sel(m: M, a: F, b: F) -> F = vbslq_f32(m.0, a.0, b.0);
    f_of_i(a: I) -> F = vcvtq_f32_s32(a.0);
    f_of_u(a: U) -> F = vcvtq_f32_u32(a.0);
    f_of_half(a: U) -> F = vcvt_f32_f16(vreinterpret_f16_u16(vmovn_u32(a.0)));
}

operations! {
    splat_i(x: i32) -> I = vdupq_n_s32(x);
    add_i(a: I, b: I) -> I = vaddq_s32(a.0, b.0);
    sub_i(a: I, b: I) -> I = vsubq_s32(a.0, b.0);
    mul_i(a: I, b: I) -> I = vmulq_s32(a.0, b.0);
    min_i(a: I, b: I) -> I = vminq_s32(a.0, b.0);
    max_i(a: I, b: I) -> I = vmaxq_s32(a.0, b.0);
    shl_i(a: I, by: U) -> I = vshlq_s32(a.0, places(by).0);
    shr_i(a: I, by: U) -> I = vshlq_s32(a.0, vnegq_s32(places(by).0));
    lt_i(a: I, b: I) -> M = vcltq_s32(a.0, b.0);
    ge_i(a: I, b: I) -> M = vcgeq_s32(a.0, b.0);
    eq_i(a: I, b: I) -> M = vceqq_s32(a.0, b.0);
    ne_i(a: I, b: I) -> M = not(eq_i(a, b)).0;
    sel_i(m: M, a: I, b: I) -> I = vbslq_s32(m.0, a.0, b.0);
    i_of_u(a: U) -> I = vreinterpretq_s32_u32(a.0);
    bits_of_f(a: F) -> I = vreinterpretq_s32_f32(a.0);
    // Converts towards zero. NaN gives 0, and a number out of range the nearest one.
    i_of_f(a: F) -> I = vcvtq_s32_f32(a.0);
    // For a number that is no NaN and in range.
    i_of_small(a: F) -> I = vcvtq_s32_f32(a.0);
    // Number of bits to shift by: 32 shifts all out, and the instruction reads only the lowest
    // byte.
    places(by: U) -> I = i_of_u(min_u(by, splat_u(32))).0;
}

operations! {
    splat_u(x: u32) -> U = vdupq_n_u32(x);
    add_u(a: U, b: U) -> U = vaddq_u32(a.0, b.0);
    sub_u(a: U, b: U) -> U = vsubq_u32(a.0, b.0);
    mul_u(a: U, b: U) -> U = vmulq_u32(a.0, b.0);
    xor_u(a: U, b: U) -> U = veorq_u32(a.0, b.0);
    min_u(a: U, b: U) -> U = vminq_u32(a.0, b.0);
    shr_u(a: U, by: I) -> U = vshlq_u32(a.0, vnegq_s32(places(u_of_i(by)).0));
    and_u(a: U, b: U) -> U = vandq_u32(a.0, b.0);
    lt_u(a: U, b: U) -> M = vcltq_u32(a.0, b.0);
    gt_u(a: U, b: U) -> M = vcgtq_u32(a.0, b.0);
    ge_u(a: U, b: U) -> M = vcgeq_u32(a.0, b.0);
    eq_u(a: U, b: U) -> M = vceqq_u32(a.0, b.0);
    ne_u(a: U, b: U) -> M = not(eq_u(a, b)).0;
    sel_u(m: M, a: U, b: U) -> U = vbslq_u32(m.0, a.0, b.0);
    u_of_i(a: I) -> U = vreinterpretq_u32_s32(a.0);
    // Converts like signed numbers.
    u_of_f(a: F) -> U = vcvtq_u32_f32(a.0);
}

operations! {
    splat_m(yes: bool) -> M = vdupq_n_u32(0u32.wrapping_sub(u32::from(yes)));
    no_lane() -> M = vdupq_n_u32(0);
    // The lanes of a number's lowest bits.
    lanes_of(bits: u32) -> M = vtstq_u32(vdupq_n_u32(bits), splat_u_each().0);
    and(a: M, b: M) -> M = vandq_u32(a.0, b.0);
    and_not(a: M, b: M) -> M = vbicq_u32(a.0, b.0);
    or(a: M, b: M) -> M = vorrq_u32(a.0, b.0);
    not(a: M) -> M = vmvnq_u32(a.0);
    eq_m(a: M, b: M) -> M = vceqq_u32(a.0, b.0);
    sel_m(m: M, a: M, b: M) -> M = vbslq_u32(m.0, a.0, b.0);
    // A bit for each lane.
    splat_u_each() -> U = load_u(&[1, 2, 4, 8]).0;
}

lanes! { fn any(m: M) -> bool { vmaxvq_u32(m.0) != 0 } }
lanes! { fn none(m: M) -> bool { vmaxvq_u32(m.0) == 0 } }
lanes! { fn bits_of(m: M) -> u32 { vaddvq_u32(vandq_u32(m.0, splat_u_each().0)) } }

// The remainder with the sign of the first number. Quotients of 32-bit numbers that are rounded to `f64` are
// not rounded up to the next whole number, so that cutting them off is exact. By zero it is some number.
lanes! { fn rem_i(a: I, b: I) -> I {
    let quotient = |a: int32x2_t, b: int32x2_t| {
        let quotient = vdivq_f64(vcvtq_f64_s64(vmovl_s32(a)), vcvtq_f64_s64(vmovl_s32(b)));
        vmovn_s64(vcvtq_s64_f64(quotient))
    };
    let low = quotient(vget_low_s32(a.0), vget_low_s32(b.0));
    let high = quotient(vget_high_s32(a.0), vget_high_s32(b.0));
    sub_i(a, mul_i(I(vcombine_s32(low, high)), b))
} }
