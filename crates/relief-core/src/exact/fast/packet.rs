//! Tracing of many paths: packets of neighbouring rays descend the hierarchy together, one lane per
//! ray.
//!
//! A block of the hierarchy or a cell is fetched once for all rays that visit it. Rays without
//! neighbours descend by themselves, in turns. Every lane computes the same as the scalar search,
//! operation by operation, on the same nodes in the same order. So its answer has the same bits.

#[cfg(target_arch = "x86_64")]
mod cell;
#[cfg(target_arch = "x86_64")]
mod groups;
#[cfg(target_arch = "x86_64")]
mod incoherent;
#[cfg(target_arch = "x86_64")]
mod search;
#[cfg(target_arch = "x86_64")]
mod setup;
#[cfg(target_arch = "x86_64")]
mod vector;

use super::FastTracer;
use crate::exact::ExactHit;
use crate::{Cost, Hit, Lanes, Path, PathMetric};

/// Sixteen paths as a structure of arrays: the fields of [`Path`] that tracing uses.
///
/// The paths should be neighbours, for example 4 x 4 pixels row by row, so that they visit the same
/// nodes. A lane whose exit is NaN holds no path; its answer is a miss.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct PathPacket {
    /// Texture coordinates at the entry.
    pub uv: [[f64; Self::LEN]; 2],
    /// Change of the texture coordinates per unit of `t`.
    pub duv: [[f64; Self::LEN]; 2],
    /// Coefficients of the height.
    pub h: [[f64; Self::LEN]; 3],
    /// Parameter of the path's end; NaN for a lane without a path.
    pub exit: [f64; Self::LEN],
}

/// Answers to a packet as a structure of arrays, with the fields of [`ExactHit`]. All numbers of a
/// miss are 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct HitPacket {
    /// Bit mask of the lanes with a hit; lane 0 is the lowest bit.
    pub found: u16,
    /// Bit mask of the lanes that were given up.
    pub exhausted: u16,
    /// Parameter along the path.
    pub t: [f64; Self::LEN],
    /// Texture coordinates of the hit.
    pub uv: [[f64; Self::LEN]; 2],
    /// Height of the hit.
    pub height: [f64; Self::LEN],
    /// Dual cell of the hit.
    pub cell: [[i64; Self::LEN]; 2],
    /// Derivative of the gap at the hit, in heights per unit of `t`.
    pub slope: [f64; Self::LEN],
    /// Gap at the hit: 0, or negative if the path begins below the surface.
    pub clearance: [f64; Self::LEN],
    /// Steps; each is one read.
    pub steps: [u32; Self::LEN],
    /// Bytes that the reads fetched.
    pub bytes: [u32; Self::LEN],
}

impl PathPacket {
    /// Number of paths, for every SIMD width.
    pub const LEN: usize = 16;

    /// A packet without paths.
    pub const EMPTY: Self = Self {
        uv: [[0.0; Self::LEN]; 2],
        duv: [[0.0; Self::LEN]; 2],
        h: [[0.0; Self::LEN]; 3],
        exit: [f64::NAN; Self::LEN],
    };

    /// Creates a packet of the first sixteen paths, or fewer if there are fewer.
    pub fn new(paths: &[Path]) -> Self {
        let mut packet = Self::EMPTY;
        for (lane, path) in paths.iter().enumerate().take(Self::LEN) {
            packet.set(lane, path);
        }
        packet
    }

    /// Stores a path in a lane.
    ///
    /// # Panics
    ///
    /// When there is no such lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, path: &Path) {
        for k in 0..2 {
            self.uv[k][lane] = path.uv[k];
            self.duv[k][lane] = path.duv[k];
        }
        for k in 0..3 {
            self.h[k][lane] = path.h[k];
        }
        self.exit[lane] = path.exit;
    }

    /// Path of a lane, with a placeholder for base and metric.
    ///
    /// # Panics
    ///
    /// When there is no such lane.
    pub fn path(&self, lane: usize) -> Path {
        Path {
            uv: self.uv.map(|lanes| lanes[lane]),
            duv: self.duv.map(|lanes| lanes[lane]),
            h: self.h.map(|lanes| lanes[lane]),
            exit: self.exit[lane],
            base: 0.0,
            metric: PathMetric::unit(1.0),
        }
    }
}

impl Default for PathPacket {
    fn default() -> Self {
        Self::EMPTY
    }
}

impl HitPacket {
    /// Number of answers.
    pub const LEN: usize = PathPacket::LEN;

    /// A packet of misses.
    pub const MISSES: Self = Self {
        found: 0,
        exhausted: 0,
        t: [0.0; Self::LEN],
        uv: [[0.0; Self::LEN]; 2],
        height: [0.0; Self::LEN],
        cell: [[0; Self::LEN]; 2],
        slope: [0.0; Self::LEN],
        clearance: [0.0; Self::LEN],
        steps: [0; Self::LEN],
        bytes: [0; Self::LEN],
    };

    /// Answer of a lane.
    ///
    /// # Panics
    ///
    /// When there is no such lane.
    #[inline(always)]
    pub fn hit(&self, lane: usize) -> ExactHit {
        let is_in = |lanes: u16| lanes >> lane & 1 == 1;
        let cost = Cost { reads: self.steps[lane], steps: self.steps[lane], bytes: self.bytes[lane] };
        let hit = Hit {
            found: is_in(self.found),
            exhausted: is_in(self.exhausted),
            uv: self.uv.map(|lanes| lanes[lane]),
            height: self.height[lane],
            t: self.t[lane],
            cost,
        };
        ExactHit {
            hit,
            cell: self.cell.map(|lanes| lanes[lane]),
            slope: self.slope[lane],
            clearance: self.clearance[lane],
        }
    }

    /// Stores an answer in a lane.
    fn set(&mut self, lane: usize, answer: &ExactHit) {
        let bit = 1 << lane;
        let with = |lanes: u16, is_in: bool| lanes & !bit | if is_in { bit } else { 0 };
        self.found = with(self.found, answer.hit.found);
        self.exhausted = with(self.exhausted, answer.hit.exhausted);
        self.t[lane] = answer.hit.t;
        for k in 0..2 {
            self.uv[k][lane] = answer.hit.uv[k];
            self.cell[k][lane] = answer.cell[k];
        }
        self.height[lane] = answer.hit.height;
        self.slope[lane] = answer.slope;
        self.clearance[lane] = answer.clearance;
        self.steps[lane] = answer.hit.cost.steps;
        self.bytes[lane] = answer.hit.cost.bytes;
    }
}

impl Default for HitPacket {
    fn default() -> Self {
        Self::MISSES
    }
}

impl FastTracer {
    /// Returns the first hits of many paths. Every answer has the bits of [`Self::trace`], its cost
    /// included. The number of answers is the length of the shorter slice.
    ///
    /// Sixteen consecutive paths form a packet, so sort them by neighbourhood: pixels by blocks of
    /// 4 x 4. In vectors of sixteen lanes such paths are traced four times as fast as one by one.
    /// Scattered paths, which are traced in turns, are one and a half times as fast.
    ///
    /// Some paths are traced one by one: paths that are bent, begin below the map, leave the tile
    /// of the texture, or are longer than [`MAX_TRAVEL`](crate::exact::MAX_TRAVEL).
    ///
    /// ```
    /// use relief_core::exact::{ExactHit, FastTracer};
    /// use relief_core::{Cost, HeightMap, Lanes, Path, Wrap};
    ///
    /// let map = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| ((i * j) % 7) as f32 / 7.0)?;
    /// let tracer = FastTracer::new(&map);
    /// // From the top of the relief to its bottom, half a tile further.
    /// let path = |k: u32| {
    ///     let [u, v] = [k % 4, k / 4].map(|pixel| f64::from(pixel) / 64.0);
    ///     Path::between([u, v, 1.0], [u + 0.5, v + 0.25, 0.0])
    /// };
    /// let paths: Vec<Path> = (0..16).map(path).collect();
    /// let mut answers = vec![ExactHit::miss(Cost::default(), 0.0); paths.len()];
    /// tracer.trace_all(&paths, Lanes::widest(), &mut answers);
    /// assert!(paths.iter().zip(&answers).all(|(path, answer)| *answer == tracer.trace(path)));
    /// # Ok::<(), relief_core::HeightMapError>(())
    /// ```
    pub fn trace_all(&self, paths: &[Path], lanes: Lanes, answers: &mut [ExactHit]) {
        if !is_for_packets(lanes) {
            for (path, answer) in paths.iter().zip(answers) {
                *answer = self.trace(path);
            }
            return;
        }
        let mut hits = HitPacket::MISSES;
        for (paths, answers) in paths.chunks(PathPacket::LEN).zip(answers.chunks_mut(PathPacket::LEN)) {
            let packet = PathPacket::new(paths);
            self.trace_packets(std::slice::from_ref(&packet), lanes, std::slice::from_mut(&mut hits));
            for (lane, answer) in answers.iter_mut().enumerate().take(paths.len()) {
                *answer = hits.hit(lane);
            }
        }
    }

    /// Traces packets as [`Self::trace_all`], for renderers that create paths sixteen at a time.
    pub fn trace_packets(&self, paths: &[PathPacket], lanes: Lanes, answers: &mut [HitPacket]) {
        #[cfg(target_arch = "x86_64")]
        if groups::trace(self, paths, lanes, answers) {
            return;
        }
        #[cfg(not(target_arch = "x86_64"))]
        let _ = lanes;
        for (paths, answers) in paths.iter().zip(answers) {
            for lane in 0..PathPacket::LEN {
                answers.set(lane, &self.trace(&paths.path(lane)));
            }
        }
    }

    /// Tests which of many paths are blocked. Every answer equals [`Self::is_blocked`]. See
    /// [`Self::trace_all`] for the order of paths and for paths that are not traced together.
    pub fn is_blocked_all(&self, paths: &[Path], lanes: Lanes, blocked: &mut [bool]) {
        if !is_for_packets(lanes) {
            for (path, blocked) in paths.iter().zip(blocked) {
                *blocked = self.is_blocked(path);
            }
            return;
        }
        for (paths, blocked) in paths.chunks(PathPacket::LEN).zip(blocked.chunks_mut(PathPacket::LEN)) {
            let [bits] = self.blocked_packets(&[PathPacket::new(paths)], lanes);
            for (lane, blocked) in blocked.iter_mut().enumerate().take(paths.len()) {
                *blocked = bits >> lane & 1 == 1;
            }
        }
    }

    /// Returns a bit mask of the blocked paths of each packet; lane 0 is the lowest bit. It serves
    /// renderers that create paths sixteen at a time; see [`Self::is_blocked_all`].
    pub fn blocked_packets<const N: usize>(&self, paths: &[PathPacket; N], lanes: Lanes) -> [u16; N] {
        let mut blocked = [0; N];
        #[cfg(target_arch = "x86_64")]
        if groups::blocked(self, paths, lanes, &mut blocked) {
            return blocked;
        }
        #[cfg(not(target_arch = "x86_64"))]
        let _ = lanes;
        for (paths, blocked) in paths.iter().zip(&mut blocked) {
            for lane in 0..PathPacket::LEN {
                *blocked |= u16::from(self.is_blocked(&paths.path(lane))) << lane;
            }
        }
        blocked
    }
}

/// Whether packets are used for this width, and the machine has such vectors. Four lanes are too
/// few.
fn is_for_packets(lanes: Lanes) -> bool {
    matches!(lanes, Lanes::Eight | Lanes::Sixteen) && lanes.is_available()
}
