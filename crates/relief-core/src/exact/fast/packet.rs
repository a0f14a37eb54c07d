//! Many paths at once: packets of neighbouring rays that go down the hierarchy together, a lane a ray.
//!
//! A block of the hierarchy or a cell is fetched once for all rays that come to it. Rays with no neighbours
//! go down by themselves, in turn. Every lane does what the search one by one does, operation by operation,
//! on the same nodes in the same order, so that its answer has the same bits.

#[cfg(target_arch = "x86_64")]
mod cell;
#[cfg(target_arch = "x86_64")]
mod search;
#[cfg(target_arch = "x86_64")]
mod setup;
#[cfg(target_arch = "x86_64")]
mod strays;
#[cfg(target_arch = "x86_64")]
mod together;
#[cfg(target_arch = "x86_64")]
mod vector;

use super::FastTracer;
use crate::exact::ExactHit;
use crate::{Cost, Hit, Lanes, Path, PathMetric};

/// Sixteen paths, number by number: what [`Path`] holds of each, but for what tracing does not ask for.
///
/// The paths should be neighbours, such as those of 4 x 4 pixels row by row; then they share their way. A
/// lane whose exit is NaN holds no path and is answered by a miss.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct PathPacket {
    /// Texture coordinates at the entry.
    pub uv: [[f64; Self::LEN]; 2],
    /// Change of the texture coordinates per unit of `t`.
    pub duv: [[f64; Self::LEN]; 2],
    /// Coefficients of the normalised height.
    pub h: [[f64; Self::LEN]; 3],
    /// The parameter where the path ends, NaN where there is none.
    pub exit: [f64; Self::LEN],
}

/// The answers to a packet, number by number, as [`ExactHit`] has them. All numbers of a miss are 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(align(64))]
pub struct HitPacket {
    /// The lanes with a hit, lane 0 the lowest bit.
    pub found: u16,
    /// The lanes that were given up.
    pub exhausted: u16,
    /// Parameter along the path.
    pub t: [f64; Self::LEN],
    /// Texture coordinates of the hit.
    pub uv: [[f64; Self::LEN]; 2],
    /// Normalised height of the hit.
    pub height: [f64; Self::LEN],
    /// The dual cell that was hit.
    pub cell: [[i64; Self::LEN]; 2],
    /// How fast the gap closes, in heights a unit of `t`.
    pub slope: [f64; Self::LEN],
    /// The gap at the hit: 0, or negative where the path begins below the surface.
    pub clearance: [f64; Self::LEN],
    /// Steps, each of which is one read.
    pub steps: [u32; Self::LEN],
    /// Bytes that they fetched.
    pub bytes: [u32; Self::LEN],
}

impl PathPacket {
    /// How many paths it has room for, whatever the width of the machine's vectors.
    pub const LEN: usize = 16;

    /// No paths.
    pub const EMPTY: Self = Self {
        uv: [[0.0; Self::LEN]; 2],
        duv: [[0.0; Self::LEN]; 2],
        h: [[0.0; Self::LEN]; 3],
        exit: [f64::NAN; Self::LEN],
    };

    /// The first sixteen of those paths, or as many as there are.
    pub fn new(paths: &[Path]) -> Self {
        let mut packet = Self::EMPTY;
        for (lane, path) in paths.iter().enumerate().take(Self::LEN) {
            packet.set(lane, path);
        }
        packet
    }

    /// Puts a path into a lane.
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

    /// The path of a lane, with a base and a metric that are of no use.
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
    /// How many answers it holds.
    pub const LEN: usize = PathPacket::LEN;

    /// Nothing but misses.
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

    /// The answer of a lane.
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

    /// Puts an answer into a lane.
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
    /// The first hits of many paths: every answer has the bits of [`Self::trace`], its cost included. There
    /// are as many answers as the shorter of both slices is long.
    ///
    /// Sixteen paths in a row make a packet, so order them by neighbours: pixels by blocks of 4 x 4. In
    /// vectors of sixteen lanes such paths are traced four times as fast as one by one, and scattered ones,
    /// which go their own ways in turn, one and a half times. Paths that are bent, begin below the map, leave
    /// the tile of the texture, or are longer than [`MAX_TRAVEL`](crate::exact::MAX_TRAVEL) are traced one by
    /// one.
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

    /// [`Self::trace_all`] for a renderer that makes its paths sixteen at a time.
    pub fn trace_packets(&self, paths: &[PathPacket], lanes: Lanes, answers: &mut [HitPacket]) {
        #[cfg(target_arch = "x86_64")]
        if together::trace(self, paths, lanes, answers) {
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

    /// Which of many paths are blocked: each answer is that of [`Self::is_blocked`]. See [`Self::trace_all`]
    /// for the order of paths and for what is not traced together.
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

    /// The blocked paths of each packet, lane 0 the lowest bit: [`Self::is_blocked_all`] for a renderer that
    /// makes its paths sixteen at a time.
    pub fn blocked_packets<const N: usize>(&self, paths: &[PathPacket; N], lanes: Lanes) -> [u16; N] {
        let mut blocked = [0; N];
        #[cfg(target_arch = "x86_64")]
        if together::blocked(self, paths, lanes, &mut blocked) {
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

/// Whether there are vectors of so many lanes for packets, which four are too few for.
fn is_for_packets(lanes: Lanes) -> bool {
    matches!(lanes, Lanes::Eight | Lanes::Sixteen) && lanes.is_available()
}
