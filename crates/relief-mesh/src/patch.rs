//! Patches, and points of them.

/// A patch: what an interior fills.
#[derive(Clone, Copy, Debug)]
pub enum Patch<'a> {
    /// A base triangle.
    Triangle {
        /// The numbers of parts, at least 1, of its three sides: side `k` goes from corner `k` to the next.
        parts: [u32; 3],
        /// The voxels that its corners lie in, for edge rules that go by them.
        voxels: [[i32; 3]; 3],
    },
    /// A tile of a plane, by the places of the lines across `u` and across `v`, at least two of each.
    Tile([&'a [f64]; 2]),
}

/// A point of a patch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PatchPoint {
    /// A point of the border. Of a triangle's side the point that so many parts lie before, counted from the
    /// side's first corner, fewer than there are parts. Of a tile the place in the grid of its lines is
    /// `side` across `u` and `at` across `v`.
    Border {
        /// The side, or the number of the line across `u`.
        side: u32,
        /// The point, or the number of the line across `v`.
        at: u32,
    },
    /// A point inside.
    Inner {
        /// Its number among those of the patch.
        number: u32,
        /// The barycentric weights of the second and the third corner.
        weights: [f64; 2],
    },
}
