//! Hits: the ends of paths.

/// End of a path, as a refinement or an exact tracer returns it.
///
/// `uv` does not follow from `t`. For example, the results of parallax mapping with offset limiting
/// lie beside the ray.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Whether there is a hit. If not, all other fields except `cost` are 0.
    pub found: bool,
    /// Whether the search ran out of steps. Then the hit is the last point that it reached.
    pub exhausted: bool,
    /// Texture coordinates of the hit, not wrapped.
    pub uv: [f64; 2],
    /// Height of the hit, a texel value in `[0, 1]`.
    pub height: f64,
    /// Parameter of the hit along the path.
    pub t: f64,
    /// Work of tracing the ray.
    pub cost: Cost,
}

/// Work of tracing a ray: its search and its refinement.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cost {
    /// Number of reads. A read is a bilinear evaluation, the four heights of a cell, a node of a
    /// pyramid, or one place of another map. For an exact tracer it is a node or a cell.
    pub reads: u32,
    /// Number of steps: turns of the loops of the search and the refinement. For an exact tracer:
    /// the nodes and cells, or the pieces of the path, that it visits.
    pub steps: u32,
    /// Bytes fetched by the reads, even if a cache held them. A height counts 4 bytes, so a cell
    /// 16. A texel of a baked map counts as many as it is stored in.
    pub bytes: u32,
}

impl Cost {
    /// Adds one step with this number of reads and bytes.
    #[inline(always)]
    pub(crate) fn step(&mut self, reads: u32, bytes: u32) {
        self.reads += reads;
        self.steps += 1;
        self.bytes += bytes;
    }
}

impl Hit {
    /// A miss with this cost.
    pub const fn miss(cost: Cost) -> Self {
        Self { found: false, exhausted: false, uv: [0.0; 2], height: 0.0, t: 0.0, cost }
    }
}
