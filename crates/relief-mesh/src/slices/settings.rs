//! Settings of slices.

use relief_core::camera::Camera;

/// Settings of slices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliceSettings {
    /// Number of slices over the displacement from height 0 to 1. Slices in other directions are as
    /// many metres apart (section 3.4). 0: slices are a texel apart.
    pub count: u32,
    /// Direction of the slices.
    pub direction: SliceDirection,
}

/// Direction of slices.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SliceDirection {
    /// Along the base, at equal heights: direction a (section 3.1).
    Surface,
    /// At equal `u`, upright on the base: direction b (section 3.2).
    AcrossU,
    /// At equal `v`, upright on the base: direction c.
    AcrossV,
    /// One of the three directions above for each triangle of the base: the one whose planes face
    /// the camera most.
    Facing(Camera),
    /// At equal depths from a camera (section 3.3).
    Screen(Camera, SliceAnchor),
    /// At equal depths from a camera, as quads of one size over flat polygons. Each polygon shows
    /// the whole map once. The renderer clips the quads where the texture or the displacement ends.
    Quads(Camera, SliceAnchor),
}

/// Anchor with which slices of equal depth move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SliceAnchor {
    /// The eye, as in the paper. Slices then move through objects at rest as the camera comes
    /// nearer.
    Eye,
    /// The origin of the world.
    Object,
}
