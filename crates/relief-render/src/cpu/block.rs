//! Blocks of 4 x 4 neighbouring sample points, which go through the stages together.

use relief_core::Lanes;
use relief_core::exact::{HitPacket, PathPacket};
pub use relief_shaders::cpu::places;
use relief_shaders::cpu::{BLOCK, Hit, HitBlock, PathBlock, Row, TriangleRays};

use super::prepared_surface::PreparedSurface;

/// Points along a side of a block.
pub const BLOCK_SIDE: usize = 4;

const _: () = assert!(BLOCK_SIDE * BLOCK_SIDE == BLOCK && BLOCK == PathPacket::LEN);

/// Least number of a triangle's rays that are computed in SIMD lanes. Fewer are computed one by
/// one.
const LEAST_IN_LANES: u32 = 3;

/// Returns the places of a block for which `holds` is true, a bit for each.
pub fn places_where(holds: impl Fn(usize) -> bool) -> u16 {
    (0..BLOCK).fold(0, |which, place| which | u16::from(holds(place)) << place)
}

/// Returns the SIMD width for the places whose bits `which` has.
pub fn lanes_for(which: u16, lanes: Lanes) -> Lanes {
    if which.count_ones() < LEAST_IN_LANES { Lanes::One } else { lanes }
}

/// Triangle and side that each ray of a block hits.
#[derive(Clone)]
pub struct Faces {
    /// Whether the mesh is turned over, and the triangle's number.
    pub rank: Row<(bool, u32)>,
    /// 1 on the triangle's front, -1 on its back.
    pub side: Row<f32>,
}

impl Faces {
    /// Creates the faces of a block whose rays hit nothing yet.
    pub fn new() -> Self {
        Self { rank: [(false, 0); BLOCK], side: [1.0; BLOCK] }
    }

    /// Calls `of` for each triangle, with its rays among the bits of `which`, and with their SIMD
    /// width.
    pub fn each(
        &self,
        surface: &PreparedSurface,
        points: &[Row<f32>; 2],
        which: u16,
        lanes: Lanes,
        mut of: impl FnMut(TriangleRays, u16, Lanes),
    ) {
        let mut rest = which;
        while rest != 0 {
            let first = rest.trailing_zeros() as usize;
            let (number, side) = (self.rank[first].1, self.side[first]);
            let same = rest & places_where(|place| self.rank[place].1 == number && self.side[place] == side);
            let rays = TriangleRays { triangle: &surface.triangle(number), side, points };
            of(rays, same, lanes_for(same, lanes));
            rest &= !same;
        }
    }
}

impl PreparedSurface<'_> {
    /// Traces the paths that `which` has bits for.
    pub fn trace_block(&self, paths: &PathBlock, which: u16, lanes: Lanes, hits: &mut HitBlock) {
        if self.tracers.is_none() {
            return self.program.trace_block(paths, which, lanes, hits);
        }
        self.each_level(paths, which, lanes, |which, found| {
            for place in places(which) {
                hits.set(place, &Hit::from(&found.hit(place).hit));
            }
        });
    }

    /// Returns the paths to lights, among the bits of `which`, that nothing blocks. The exact
    /// tracers decide if the surface uses them for shadows, else the shadow search.
    pub fn free_block(&self, paths: &PathBlock, which: u16, lanes: Lanes) -> u16 {
        if !self.traces_shadows {
            return self.program.free_block(paths, which, lanes);
        }
        let mut free = 0;
        self.each_level(paths, which, lanes, |which, hits| free |= which & !hits.found);
        free
    }

    /// Traces paths by the exact tracers, level of detail by level of detail, and calls `of` with
    /// the hits of each level.
    fn each_level(&self, paths: &PathBlock, which: u16, lanes: Lanes, mut of: impl FnMut(u16, &HitPacket)) {
        let Some(tracers) = &self.tracers else { return };
        let mut hits = HitPacket::MISSES;
        let mut rest = which;
        while rest != 0 {
            let level = paths.level[rest.trailing_zeros() as usize];
            let same = rest & places_where(|place| paths.level[place] == level);
            let wide = |row: &Row<f32>| row.map(f64::from);
            let mut packet = PathPacket {
                uv: paths.uv.each_ref().map(wide),
                duv: paths.duv.each_ref().map(wide),
                h: paths.h.each_ref().map(wide),
                exit: wide(&paths.exit),
            };
            for place in places(!same) {
                packet.exit[place] = f64::NAN;
            }
            let (packet, answers) = (std::slice::from_ref(&packet), std::slice::from_mut(&mut hits));
            tracers[level as usize].trace_packets(packet, lanes, answers);
            of(same, &hits);
            rest &= !same;
        }
    }
}
