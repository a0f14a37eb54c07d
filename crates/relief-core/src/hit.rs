//! Where a path ends.

/// The end of a path: what a refinement makes of a search's result, or what an exact tracer answers.
///
/// `uv` is not derived from `t`: offset limiting, for one, lands beside the ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Whether there is a hit; when not, the other fields except `reads` are 0.
    pub found: bool,
    /// Whether the search ran out of steps; such a hit is the last point it reached.
    pub exhausted: bool,
    /// Texture coordinates of the hit, not wrapped.
    pub uv: [f64; 2],
    /// Normalised height of the hit, a texel value in `[0, 1]`.
    pub height: f64,
    /// Parameter along the path.
    pub t: f64,
    /// Height reads: one bilinear evaluation, one 2x2 cell fetch, one pyramid node or one texel of another
    /// map is 1.
    pub reads: u32,
}

impl Hit {
    /// No hit, after that many reads.
    pub const fn miss(reads: u32) -> Self {
        Self { found: false, exhausted: false, uv: [0.0; 2], height: 0.0, t: 0.0, reads }
    }
}
