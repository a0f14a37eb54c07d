//! Four lanes on the web: the vectors of 128 bits (`simd128`), which browsers have had since 2023.
//!
//! All operations have the bits of the translation to single numbers.

use std::arch::wasm32::*;

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
struct F(v128);

/// A signed number in each lane.
#[derive(Clone, Copy)]
struct I(v128);

/// An unsigned number in each lane.
#[derive(Clone, Copy)]
struct U(v128);

/// A truth value in each lane.
#[derive(Clone, Copy)]
struct M(v128);

/// A short function, compiled into its callers.
macro_rules! lanes {
    ($($item:tt)*) => {
        #[inline]
        #[target_feature(enable = "simd128")]
        $($item)*
    };
}

/// A function that is compiled by itself, which keeps compiling short.
macro_rules! stage {
    ($($item:tt)*) => {
        #[inline(never)]
        #[target_feature(enable = "simd128")]
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
    splat(x: f32) -> F = f32x4_splat(x);
    add(a: F, b: F) -> F = f32x4_add(a.0, b.0);
    sub(a: F, b: F) -> F = f32x4_sub(a.0, b.0);
    mul(a: F, b: F) -> F = f32x4_mul(a.0, b.0);
    div(a: F, b: F) -> F = f32x4_div(a.0, b.0);
    sqrt(a: F) -> F = f32x4_sqrt(a.0);
    neg(a: F) -> F = f32x4_neg(a.0);
    abs(a: F) -> F = f32x4_abs(a.0);
    floor(a: F) -> F = f32x4_floor(a.0);
    ceil(a: F) -> F = f32x4_ceil(a.0);
    // The instruction gives its first operand where both are equal, and where one is a NaN;
    // of a NaN the other is left.
    min(a: F, b: F) -> F = sel(ordered(a), F(f32x4_pmin(a.0, b.0)), b).0;
    max(a: F, b: F) -> F = sel(ordered(a), F(f32x4_pmax(a.0, b.0)), b).0;
    // Minimum with a second number that is no NaN.
    min_with(a: F, b: F) -> F = f32x4_pmin(b.0, a.0);
    max_with(a: F, b: F) -> F = f32x4_pmax(b.0, a.0);
    lt(a: F, b: F) -> M = f32x4_lt(a.0, b.0);
    le(a: F, b: F) -> M = f32x4_le(a.0, b.0);
    gt(a: F, b: F) -> M = f32x4_gt(a.0, b.0);
    ge(a: F, b: F) -> M = f32x4_ge(a.0, b.0);
    eq(a: F, b: F) -> M = f32x4_eq(a.0, b.0);
    ne(a: F, b: F) -> M = f32x4_ne(a.0, b.0);
    ordered(a: F) -> M = eq(a, a).0;
    sel(m: M, a: F, b: F) -> F = v128_bitselect(a.0, b.0, m.0);
    f_of_i(a: I) -> F = f32x4_convert_i32x4(a.0);
    f_of_u(a: U) -> F = f32x4_convert_u32x4(a.0);
    // Digits and exponent move to their places in 32 bits; a factor corrects the exponent, of small numbers,
    // too. Infinity and NaN have the greatest exponent in both.
    f_of_half(a: U) -> F = {
        let digits = u32x4_shl(v128_and(a.0, u32x4_splat(0x7fff)), 13);
        let near = f32x4_mul(digits, f32x4_splat(5.192_296_858_534_827_6e33));
        let is_beyond = u32x4_ge(v128_and(a.0, u32x4_splat(0x7fff)), u32x4_splat(0x7c00));
        let beyond = v128_and(is_beyond, u32x4_splat(0x7f80_0000));
        let sign = u32x4_shl(v128_and(a.0, u32x4_splat(0x8000)), 16);
        v128_or(v128_or(near, beyond), sign)
    };
}

operations! {
    splat_i(x: i32) -> I = i32x4_splat(x);
    add_i(a: I, b: I) -> I = i32x4_add(a.0, b.0);
    sub_i(a: I, b: I) -> I = i32x4_sub(a.0, b.0);
    mul_i(a: I, b: I) -> I = i32x4_mul(a.0, b.0);
    min_i(a: I, b: I) -> I = i32x4_min(a.0, b.0);
    max_i(a: I, b: I) -> I = i32x4_max(a.0, b.0);
    shl_i(a: I, by: U) -> I = i_of_u(shifted(u_of_i(a), by, u32::checked_shl)).0;
    // Digits of the sign come in: 31 shifts all others out.
    shr_i(a: I, by: U) -> I = {
        let (values, by) = (row_i(a), row_u(min_u(by, splat_u(31))));
        load_i(&std::array::from_fn(|lane| values[lane] >> by[lane])).0
    };
    lt_i(a: I, b: I) -> M = i32x4_lt(a.0, b.0);
    ge_i(a: I, b: I) -> M = i32x4_ge(a.0, b.0);
    eq_i(a: I, b: I) -> M = i32x4_eq(a.0, b.0);
    ne_i(a: I, b: I) -> M = i32x4_ne(a.0, b.0);
    sel_i(m: M, a: I, b: I) -> I = v128_bitselect(a.0, b.0, m.0);
    i_of_u(a: U) -> I = a.0;
    bits_of_f(a: F) -> I = a.0;
    // Converts towards zero. NaN gives 0, and a number out of range the nearest one.
    i_of_f(a: F) -> I = i32x4_trunc_sat_f32x4(a.0);
    // For a number that is no NaN and in range.
    i_of_small(a: F) -> I = i32x4_trunc_sat_f32x4(a.0);
}

operations! {
    splat_u(x: u32) -> U = u32x4_splat(x);
    add_u(a: U, b: U) -> U = i32x4_add(a.0, b.0);
    sub_u(a: U, b: U) -> U = i32x4_sub(a.0, b.0);
    mul_u(a: U, b: U) -> U = i32x4_mul(a.0, b.0);
    xor_u(a: U, b: U) -> U = v128_xor(a.0, b.0);
    min_u(a: U, b: U) -> U = u32x4_min(a.0, b.0);
    shr_u(a: U, by: I) -> U = shifted(a, u_of_i(by), u32::checked_shr).0;
    and_u(a: U, b: U) -> U = v128_and(a.0, b.0);
    lt_u(a: U, b: U) -> M = u32x4_lt(a.0, b.0);
    gt_u(a: U, b: U) -> M = u32x4_gt(a.0, b.0);
    ge_u(a: U, b: U) -> M = u32x4_ge(a.0, b.0);
    eq_u(a: U, b: U) -> M = i32x4_eq(a.0, b.0);
    ne_u(a: U, b: U) -> M = i32x4_ne(a.0, b.0);
    sel_u(m: M, a: U, b: U) -> U = v128_bitselect(a.0, b.0, m.0);
    u_of_i(a: I) -> U = a.0;
    // Converts like signed numbers.
    u_of_f(a: F) -> U = u32x4_trunc_sat_f32x4(a.0);
}

operations! {
    splat_m(yes: bool) -> M = i32x4_splat(-i32::from(yes));
    no_lane() -> M = i32x4_splat(0);
    // The lanes of a number's lowest bits.
    lanes_of(bits: u32) -> M = {
        let own = splat_u_each();
        eq_u(and_u(splat_u(bits), own), own).0
    };
    and(a: M, b: M) -> M = v128_and(a.0, b.0);
    and_not(a: M, b: M) -> M = v128_andnot(a.0, b.0);
    or(a: M, b: M) -> M = v128_or(a.0, b.0);
    not(a: M) -> M = v128_not(a.0);
    eq_m(a: M, b: M) -> M = i32x4_eq(a.0, b.0);
    sel_m(m: M, a: M, b: M) -> M = v128_bitselect(a.0, b.0, m.0);
    // A bit for each lane.
    splat_u_each() -> U = u32x4(1, 2, 4, 8);
}

lanes! { fn any(m: M) -> bool { v128_any_true(m.0) } }
lanes! { fn none(m: M) -> bool { !v128_any_true(m.0) } }
lanes! { fn bits_of(m: M) -> u32 { u32::from(i32x4_bitmask(m.0)) } }

// Shifts each lane by its own number of bits; a number of 32 or more shifts all out.
lanes! { fn shifted(a: U, by: U, shift: fn(u32, u32) -> Option<u32>) -> U {
    let (values, by) = (row_u(a), row_u(by));
    load_u(&std::array::from_fn(|lane| shift(values[lane], by[lane]).unwrap_or(0)))
} }

// The remainder with the sign of the first number. By zero it is some number.
lanes! { fn rem_i(a: I, b: I) -> I {
    let (a, b) = (row_i(a), row_i(b));
    load_i(&std::array::from_fn(|lane| a[lane].checked_rem(b[lane]).unwrap_or(0)))
} }
