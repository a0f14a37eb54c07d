//! Texels side by side that are searched for at once: one lane each.

/// How many texels of a row are searched for at once. They share the walk through the pyramid and are
/// compared together; more of them would have fewer nodes in common.
pub(crate) const LANES: usize = 8;

/// One number for each texel.
pub(crate) type Lanes = [f64; LANES];

/// A bit for each lane.
pub(crate) const LANE_BITS: [u64; LANES] = [1, 2, 4, 8, 16, 32, 64, 128];

/// How far each lane's texel is from the first.
pub(crate) const COLUMNS: Lanes = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];

/// The same in `f32`.
pub(super) const COLUMNS_F32: [f32; LANES] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];

/// The numbers of the bits that are set.
#[inline(always)]
pub(crate) fn bits_of(mut set: u64) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let bit = (set != 0).then_some(set.trailing_zeros() as usize);
        set &= set.wrapping_sub(1);
        bit
    })
}
