//! Which slices there are.

use relief_core::camera::Camera;

/// Which slices there are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SliceSettings {
    /// Slices over the displacement from height 0 to 1; those that run in other directions are as many metres
    /// apart (section 3.4). 0: they are a texel apart.
    pub count: u32,
    /// How they run.
    pub direction: SliceDirection,
}

/// How slices run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SliceDirection {
    /// Along the base, at equal heights: direction a (section 3.1).
    Surface,
    /// At equal `u`, upright on the base: direction b (section 3.2).
    AcrossU,
    /// At equal `v`, upright on the base: direction c.
    AcrossV,
    /// Over each triangle of the base as one of those three, of which the planes face the camera most.
    Facing(Camera),
    /// At equal depths from a camera (section 3.3).
    Screen(Camera, SliceAnchor),
    /// The same as quads of one size over flat polygons, each of which shows the whole map once: they are
    /// clipped by whatever draws them, where the texture or the displacement ends.
    Quads(Camera, SliceAnchor),
}

/// With what slices of equal depth move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SliceAnchor {
    /// With the eye, as in the paper: what is at rest is cut elsewhere when the camera comes nearer.
    Eye,
    /// With the origin of the world.
    Object,
}
