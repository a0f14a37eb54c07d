//! Fixed-point numbers in `f64`: multiples of 2⁻⁴⁰, exact below 2¹².

/// Fixed-point numbers are multiples of one over this. A sum of products of slopes and whole
/// numbers of texels is a fixed-point number, too. Below [`EXACT`], `f64` does not round it.
pub const GRID: f64 = (1u64 << 40) as f64;

/// Multiples of one over [`GRID`] below this are exact in `f64`.
pub const EXACT: f64 = (1u64 << 12) as f64;

/// Greatest multiple of one over [`GRID`] that is not above a number.
#[inline(always)]
pub fn floor(number: f64) -> f64 {
    (number * GRID).floor() / GRID
}
