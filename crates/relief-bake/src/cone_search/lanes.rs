//! Texels side by side that are searched at once, one lane each.

/// Texels of a row that are searched at once. They share the walk through the pyramid and are
/// compared together. More of them would have fewer nodes in common.
pub(crate) const LANES: usize = 8;

/// One number for each texel.
pub(crate) type Lanes = [f64; LANES];

/// A bit for each lane.
pub(crate) const LANE_BITS: [u64; LANES] = [1, 2, 4, 8, 16, 32, 64, 128];

/// Columns from the first texel to each lane's texel.
pub(crate) const COLUMNS: Lanes = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];

/// [`COLUMNS`] in `f32`.
pub(super) const COLUMNS_F32: [f32; LANES] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];

/// Returns the numbers of the bits that are set.
#[inline(always)]
pub(crate) fn bits_of(mut set: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let bit = (set != 0).then_some(set.trailing_zeros() as usize);
        set &= set.wrapping_sub(1);
        bit
    })
}
