//! SIMD vectors of packets, and lanes of numbers with arithmetic operators.

use std::ops::{Add, Div, Mul, Sub};
use std::slice::from_ref;

use pulp::Simd;
use pulp::bytemuck::{cast, cast_slice};
use pulp::x86::{V3, V4};

use super::PathPacket;

/// Vectors with operations for which `pulp` has no common name: bits of masks, and conversions.
pub(super) trait Vector: Simd {
    /// Lanes of a mask as bits, the first one lowest.
    fn bits32(self, mask: Self::m32s) -> u32;
    /// Lanes of a mask as bits, the first one lowest.
    fn bits64(self, mask: Self::m64s) -> u32;
    /// Mask of some lanes. Bits above the number of lanes are ignored.
    fn mask32(self, bits: u32) -> Self::m32s;
    /// Mask of some lanes. Bits above the number of lanes are ignored.
    fn mask64(self, bits: u32) -> Self::m64s;
    /// Both halves of a packet, rounded to `f32`.
    fn narrow(self, halves: [Self::f64s; 2]) -> Self::f32s;
    /// Numbers without their fractions.
    fn truncate(self, a: Self::f64s) -> Self::f64s;
    /// Greatest whole numbers that are not greater than the numbers.
    fn floor(self, a: Self::f64s) -> Self::f64s;
}

/// Lanes of a set, one after the other.
#[inline]
pub(super) fn lanes_of(mut set: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = set.trailing_zeros() as usize;
        set &= set.wrapping_sub(1);
        (lane < PathPacket::LEN).then_some(lane)
    })
}

impl Vector for V3 {
    #[inline(always)]
    fn bits32(self, mask: Self::m32s) -> u32 {
        self.avx._mm256_movemask_ps(cast(mask)) as u32
    }

    #[inline(always)]
    fn bits64(self, mask: Self::m64s) -> u32 {
        self.avx._mm256_movemask_pd(cast(mask)) as u32
    }

    #[inline(always)]
    fn mask32(self, bits: u32) -> Self::m32s {
        let lanes = cast([1u32, 2, 4, 8, 16, 32, 64, 128]);
        self.equal_u32s(self.and_u32s(self.splat_u32s(bits), lanes), lanes)
    }

    #[inline(always)]
    fn mask64(self, bits: u32) -> Self::m64s {
        let lanes = cast([1u64, 2, 4, 8]);
        self.equal_u64s(self.and_u64s(self.splat_u64s(u64::from(bits)), lanes), lanes)
    }

    #[inline(always)]
    fn narrow(self, [low, high]: [Self::f64s; 2]) -> Self::f32s {
        cast([self.convert_f64x4_to_f32x4(low), self.convert_f64x4_to_f32x4(high)])
    }

    #[inline(always)]
    fn truncate(self, a: Self::f64s) -> Self::f64s {
        self.truncate_f64x4(a)
    }

    #[inline(always)]
    fn floor(self, a: Self::f64s) -> Self::f64s {
        cast(self.avx._mm256_floor_pd(cast(a)))
    }
}

impl Vector for V4 {
    #[inline(always)]
    fn bits32(self, mask: Self::m32s) -> u32 {
        u32::from(mask.0)
    }

    #[inline(always)]
    fn bits64(self, mask: Self::m64s) -> u32 {
        u32::from(mask.0)
    }

    #[inline(always)]
    fn mask32(self, bits: u32) -> Self::m32s {
        pulp::b16(bits as u16)
    }

    #[inline(always)]
    fn mask64(self, bits: u32) -> Self::m64s {
        pulp::b8(bits as u8)
    }

    #[inline(always)]
    fn narrow(self, [low, high]: [Self::f64s; 2]) -> Self::f32s {
        cast([self.convert_f64x8_to_f32x8(low), self.convert_f64x8_to_f32x8(high)])
    }

    #[inline(always)]
    fn truncate(self, a: Self::f64s) -> Self::f64s {
        self.truncate_f64x8(a)
    }

    #[inline(always)]
    fn floor(self, a: Self::f64s) -> Self::f64s {
        self.floor_f64x8(a)
    }
}

/// An `f32` in every lane of a packet.
#[derive(Clone, Copy)]
pub(super) struct Single<V: Vector> {
    v: V,
    /// Numbers as a vector.
    pub x: V::f32s,
}

/// An `f64` in every lane of half a packet.
#[derive(Clone, Copy)]
pub(super) struct Double<V: Vector> {
    v: V,
    /// Numbers as a vector.
    pub x: V::f64s,
}

/// Lanes of half a packet that satisfy a condition.
#[derive(Clone, Copy)]
pub(super) struct Mask<V: Vector> {
    v: V,
    m: V::m64s,
}

impl<V: Vector> Single<V> {
    /// One number in every lane.
    #[inline(always)]
    pub fn splat(v: V, x: f32) -> Self {
        Self { v, x: v.splat_f32s(x) }
    }

    /// Both halves, rounded to `f32`.
    #[inline(always)]
    pub fn narrow([low, high]: [Double<V>; 2]) -> Self {
        Self { v: low.v, x: low.v.narrow([low.x, high.x]) }
    }

    #[inline(always)]
    pub fn abs(self) -> Self {
        Self { v: self.v, x: self.v.abs_f32s(self.x) }
    }

    /// Lesser number; the other one if one is NaN.
    #[inline(always)]
    pub fn min(self, other: Self) -> Self {
        Self { v: self.v, x: self.v.min_f32s(self.x, other.x) }
    }

    /// Greater number; the other one if one is NaN.
    #[inline(always)]
    pub fn max(self, other: Self) -> Self {
        Self { v: self.v, x: self.v.max_f32s(self.x, other.x) }
    }

    /// Lanes in which this number is not greater, as bits.
    #[inline(always)]
    pub fn le(self, other: Self) -> u32 {
        self.v.bits32(self.v.less_than_or_equal_f32s(self.x, other.x))
    }

    /// This number in the lanes of `bits`, the other one elsewhere.
    #[inline(always)]
    pub fn where_or(self, bits: u32, other: Self) -> Self {
        Self { v: self.v, x: self.v.select_f32s(self.v.mask32(bits), self.x, other.x) }
    }

    /// Number in a lane.
    #[inline(always)]
    pub fn lane(&self, lane: usize) -> f32 {
        let numbers: &[f32] = cast_slice(from_ref(&self.x));
        numbers[lane]
    }

    /// Sum of all lanes.
    #[inline(always)]
    pub fn sum(self) -> f32 {
        self.v.reduce_sum_f32s(self.x)
    }

    /// Least number of all lanes.
    #[inline(always)]
    pub fn least(self) -> f32 {
        self.v.reduce_min_f32s(self.x)
    }

    /// Greatest number of all lanes.
    #[inline(always)]
    pub fn greatest(self) -> f32 {
        self.v.reduce_max_f32s(self.x)
    }
}

impl<V: Vector> Double<V> {
    #[inline(always)]
    pub fn new(v: V, x: V::f64s) -> Self {
        Self { v, x }
    }

    /// Numbers from index `first` on. There must be enough to fill the vector.
    #[inline(always)]
    pub fn load(v: V, numbers: &[f64], first: usize) -> Self {
        let (vectors, _) = V::as_simd_f64s(&numbers[first..]);
        Self { v, x: vectors[0] }
    }

    /// Whole numbers less than 2^51 away from 0 as integers in two's complement.
    #[inline(always)]
    pub fn to_integer(self) -> V::u64s {
        const MAGIC: f64 = (3u64 << 51) as f64;
        let sum = self.v.add_f64s(self.x, self.v.splat_f64s(MAGIC));
        self.v.sub_u64s(self.v.transmute_u64s_f64s(sum), self.v.splat_u64s(MAGIC.to_bits()))
    }

    /// One number in every lane.
    #[inline(always)]
    pub fn splat(v: V, x: f64) -> Self {
        Self { v, x: v.splat_f64s(x) }
    }

    #[inline(always)]
    pub fn abs(self) -> Self {
        Self { v: self.v, x: self.v.abs_f64s(self.x) }
    }

    /// Number in a lane.
    #[inline(always)]
    pub fn lane(&self, lane: usize) -> f64 {
        let numbers: &[f64] = cast_slice(from_ref(&self.x));
        numbers[lane]
    }

    #[inline(always)]
    pub fn sqrt(self) -> Self {
        Self { v: self.v, x: self.v.sqrt_f64s(self.x) }
    }

    /// Number without its fraction.
    #[inline(always)]
    pub fn truncate(self) -> Self {
        Self { v: self.v, x: self.v.truncate(self.x) }
    }

    /// Greatest whole number that is not greater than the number.
    #[inline(always)]
    pub fn floor(self) -> Self {
        Self { v: self.v, x: self.v.floor(self.x) }
    }

    /// Lesser number; the other one if one is NaN or they are equal: `ray::lesser` in lanes.
    #[inline(always)]
    pub fn lesser(self, other: Self) -> Self {
        Self { v: self.v, x: self.v.min_f64s(self.x, other.x) }
    }

    /// Greater number; the other one if one is NaN or they are equal: `ray::greater` in lanes.
    #[inline(always)]
    pub fn greater(self, other: Self) -> Self {
        Self { v: self.v, x: self.v.max_f64s(self.x, other.x) }
    }

    #[inline(always)]
    pub fn lt(self, other: Self) -> Mask<V> {
        Mask { v: self.v, m: self.v.less_than_f64s(self.x, other.x) }
    }

    #[inline(always)]
    pub fn le(self, other: Self) -> Mask<V> {
        Mask { v: self.v, m: self.v.less_than_or_equal_f64s(self.x, other.x) }
    }

    #[inline(always)]
    pub fn equals(self, other: Self) -> Mask<V> {
        Mask { v: self.v, m: self.v.equal_f64s(self.x, other.x) }
    }

    /// The vector type's token.
    #[inline(always)]
    pub fn token(self) -> V {
        self.v
    }

    /// Number with the opposite sign.
    #[inline(always)]
    pub fn negated(self) -> Self {
        Self { v: self.v, x: self.v.xor_f64s(self.x, self.v.splat_f64s(-0.0)) }
    }
}

impl<V: Vector> Mask<V> {
    /// Mask of some lanes. Bits above the number of lanes are ignored.
    #[inline(always)]
    pub fn of(v: V, bits: u32) -> Self {
        Self { v, m: v.mask64(bits) }
    }

    /// Mask of all lanes.
    #[inline(always)]
    pub fn all(v: V) -> Self {
        Self::of(v, !0)
    }

    /// Mask as `pulp` takes it.
    #[inline(always)]
    pub fn mask(self) -> V::m64s {
        self.m
    }

    /// Lanes as bits, the first one lowest.
    #[inline(always)]
    pub fn bits(self) -> u32 {
        self.v.bits64(self.m)
    }

    #[inline(always)]
    pub fn and(self, other: Self) -> Self {
        Self { v: self.v, m: self.v.and_m64s(self.m, other.m) }
    }

    #[inline(always)]
    pub fn or(self, other: Self) -> Self {
        Self { v: self.v, m: self.v.or_m64s(self.m, other.m) }
    }

    /// One number in the lanes of the mask, the other one elsewhere.
    #[inline(always)]
    pub fn choose(self, yes: Double<V>, no: Double<V>) -> Double<V> {
        Double { v: self.v, x: self.v.select_f64s(self.m, yes.x, no.x) }
    }
}

macro_rules! operators {
    ($lanes:ident, $($operator:ident $function:ident $simd:ident),*) => {
        $(impl<V: Vector> $operator for $lanes<V> {
            type Output = Self;

            #[inline(always)]
            fn $function(self, other: Self) -> Self {
                Self { v: self.v, x: self.v.$simd(self.x, other.x) }
            }
        })*
    };
}

operators!(Single, Add add add_f32s, Sub sub sub_f32s, Mul mul mul_f32s);
operators!(Double, Add add add_f64s, Sub sub sub_f64s, Mul mul mul_f64s, Div div div_f64s);
