//! Patches and their points.

/// Patch that an interior fills.
#[derive(Clone, Copy, Debug)]
pub enum Patch<'a> {
    /// A base triangle.
    Triangle {
        /// Number of parts, at least 1, of each side. Side `k` goes from corner `k` to the next.
        parts: [u32; 3],
        /// Voxels in which its corners lie, for edge rules that divide by voxels.
        voxels: [[i32; 3]; 3],
    },
    /// A tile of a plane: the places of the lines across `u` and across `v`, at least two of each.
    Tile([&'a [f64]; 2]),
}

/// Point of a patch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PatchPoint {
    /// Point of the border. On a triangle it is the point `at` of `side`, counted from the side's
    /// first corner; `at` is less than the side's number of parts. On a tile it is the crossing of
    /// line `side` across `u` with line `at` across `v`.
    Border {
        /// The side, or the number of the line across `u`.
        side: u32,
        /// The point, or the number of the line across `v`.
        at: u32,
    },
    /// Point inside.
    Inner {
        /// Number among the inner points of the patch.
        number: u32,
        /// Barycentric weights of the second and the third corner.
        weights: [f64; 2],
    },
}
