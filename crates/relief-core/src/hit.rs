//! Where a path ends.

/// The end of a path: what a refinement makes of a search's result, or what an exact tracer answers.
///
/// `uv` is not derived from `t`: offset limiting, for one, lands beside the ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Whether there is a hit; when not, the other fields except `cost` are 0.
    pub found: bool,
    /// Whether the search ran out of steps; such a hit is the last point it reached.
    pub exhausted: bool,
    /// Texture coordinates of the hit, not wrapped.
    pub uv: [f64; 2],
    /// Normalised height of the hit, a texel value in `[0, 1]`.
    pub height: f64,
    /// Parameter along the path.
    pub t: f64,
    /// What it took to find out.
    pub cost: Cost,
}

/// What it took to trace a ray: the work of its search and its refinement.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// How often something was read: a bilinear evaluation, the heights of a cell, a node of a pyramid, or
    /// one place of another map. An exact tracer's reads are the nodes and cells that it looks at.
    pub reads: u32,
    /// Turns of the loops of the search and the refinement; of an exact tracer the nodes and cells, or the
    /// pieces of the path, that it goes through.
    pub steps: u32,
    /// Bytes that the reads fetched, whatever of them a cache may have held: of heights 4 each, so 16 of a
    /// cell; of a baked map those of its texels as it stores them.
    pub bytes: u32,
}

impl Cost {
    /// Adds a step that read so often, and so many bytes.
    #[inline(always)]
    pub(crate) fn step(&mut self, reads: u32, bytes: u32) {
        self.reads += reads;
        self.steps += 1;
        self.bytes += bytes;
    }
}

impl Hit {
    /// No hit, at that cost.
    pub const fn miss(cost: Cost) -> Self {
        Self { found: false, exhausted: false, uv: [0.0; 2], height: 0.0, t: 0.0, cost }
    }
}
