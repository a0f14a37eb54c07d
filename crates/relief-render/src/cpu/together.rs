//! Paths of a block of points that are traced together.

use relief_core::Lanes;
use relief_core::exact::{FastTracer, HitPacket, PathPacket};
use relief_shaders::cpu::{BLOCK, Entered, Hit, HitBlock, Path, PathBlock, PixelIn, Program, Vec4};
use relief_shaders::{LightRayState, MAX_LIGHTS};

use super::ready::Ready;
use crate::raycast::tiles::TileHit;

/// Points along a side of a block.
pub const BLOCK_SIDE: usize = 4;

/// Points of a block, as many as paths of a packet.
pub const BLOCK_POINTS: usize = BLOCK_SIDE * BLOCK_SIDE;

const _: () = assert!(BLOCK_POINTS == PathPacket::LEN && BLOCK_POINTS == BLOCK);

/// Something of each point of a block that has it.
pub type Block<T> = [Option<T>; BLOCK_POINTS];

/// What is known of the first polygon that a point's ray meets, before anything is looked at.
#[derive(Clone, Copy)]
pub struct Ahead {
    pub pixel: PixelIn,
    pub at: Entered,
    /// What the path's first segment hits.
    pub hit: Hit,
}

/// A hit in the world.
#[derive(Clone, Copy)]
pub struct Placed {
    pub at: Entered,
    pub hit: Hit,
}

/// How much of each light arrives.
pub type Visible = [Vec4<f32>; MAX_LIGHTS];

/// Sixteen paths as that is told of them which traces them.
enum Paths<'a> {
    /// Of a level of detail, for its exact tracer; none before there is a path.
    Exact(&'a [FastTracer], PathPacket, Option<u32>),
    /// Of any levels, for the stages over lanes.
    Searched(&'a Program<'a>, PathBlock),
}

impl<'a> Paths<'a> {
    fn new(program: &'a Program<'a>, tracers: Option<&'a [FastTracer]>) -> Self {
        match tracers {
            Some(tracers) => Self::Exact(tracers, PathPacket::EMPTY, None),
            None => Self::Searched(program, PathBlock::default()),
        }
    }

    /// Puts a path in a place, unless it must be traced by itself.
    fn set(&mut self, place: usize, path: &Path) -> bool {
        match self {
            Self::Exact(_, packet, level) => {
                let is_of_level = *level.get_or_insert(path.level) == path.level;
                if is_of_level {
                    packet.set(place, &path.into());
                }
                is_of_level
            }
            Self::Searched(_, block) => {
                block.set(place, path);
                true
            }
        }
    }

    /// What the paths hit that `which` has bits for.
    fn hits(&self, which: u16, lanes: Lanes) -> [Option<Hit>; BLOCK_POINTS] {
        let is_in = |place: usize| which >> place & 1 == 1;
        match self {
            Self::Exact(tracers, packet, level) => {
                let Some(level) = level else { return [None; BLOCK_POINTS] };
                let hits = traced(&tracers[*level as usize], packet, lanes);
                std::array::from_fn(|place| is_in(place).then(|| Hit::from(&hits.hit(place).hit)))
            }
            Self::Searched(program, block) => {
                let mut hits = HitBlock::default();
                program.trace_block(block, which, lanes, &mut hits);
                std::array::from_fn(|place| is_in(place).then(|| hits.get(place)))
            }
        }
    }

    /// Which of the paths to lights are free of those that `which` has bits for.
    fn free(&self, which: u16, lanes: Lanes) -> u16 {
        match self {
            Self::Exact(tracers, packet, level) => {
                let found = level.map(|level| traced(&tracers[level as usize], packet, lanes).found);
                which & !found.unwrap_or_default()
            }
            Self::Searched(program, block) => program.free_block(block, which, lanes),
        }
    }
}

fn traced(tracer: &FastTracer, packet: &PathPacket, lanes: Lanes) -> HitPacket {
    let mut hits = HitPacket::MISSES;
    tracer.trace_packets(std::slice::from_ref(packet), lanes, std::slice::from_mut(&mut hits));
    hits
}

impl Ready<'_> {
    /// Whether the paths of a block's first polygons are traced together.
    pub fn traces_ahead(&self, lanes: Lanes) -> bool {
        self.is_traced && lanes != Lanes::One
    }

    /// Of the points of a block what their first polygons show, as far as that can be traced together.
    pub fn ahead(&self, points: &Block<([f32; 2], TileHit)>, lanes: Lanes) -> Block<Ahead> {
        let mut ahead: Block<Ahead> = [None; BLOCK_POINTS];
        let mut paths = Paths::new(&self.program, self.tracers.as_deref());
        let mut which = 0;
        for (place, (point, ahead)) in points.iter().zip(&mut ahead).enumerate() {
            let Some((point, TileHit { triangle, front, .. })) = *point else { continue };
            let pixel = self.pixel(triangle, if front { 1.0 } else { -1.0 }, self.aim(point));
            let at = self.program.enter(pixel);
            if at.segments > 0 {
                let path = self.program.segment(pixel, at, 0);
                if path.exit > 0.0 && paths.set(place, &path) {
                    which |= 1 << place;
                    let hit = Hit::from(&relief_core::Hit::miss(Default::default()));
                    *ahead = Some(Ahead { pixel, at, hit });
                }
            }
        }
        if which != 0 {
            for (ahead, hit) in ahead.iter_mut().zip(paths.hits(which, lanes)) {
                if let (Some(ahead), Some(hit)) = (ahead, hit) {
                    ahead.hit = hit;
                }
            }
        }
        ahead
    }

    /// What of the lights arrives at placed hits: rays that the shaders make, traced by the tracers or by the
    /// search for shadows.
    pub fn visible_lights(
        &self,
        tracers: Option<&[FastTracer]>,
        placed: &Block<Placed>,
        lanes: Lanes,
    ) -> Block<Visible> {
        let mut visible = placed.map(|placed| placed.map(|_| [Vec4::from([0.0; 4]); MAX_LIGHTS]));
        let (count, rays) = (self.points_of_lights, self.points_of_lights.max(1));
        for light in 0..self.lights {
            let mut lit = [0u32; BLOCK_POINTS];
            for point in 0..rays {
                self.add_lit(tracers, placed, [light, point, count], lanes, &mut lit);
            }
            for (visible, lit) in visible.iter_mut().zip(lit) {
                if let Some(visible) = visible {
                    visible[light as usize].x = lit as f32 / rays as f32;
                }
            }
        }
        visible
    }

    /// Counts the hits that one point of a light is seen from.
    fn add_lit(
        &self,
        tracers: Option<&[FastTracer]>,
        placed: &Block<Placed>,
        [light, point, count]: [u32; 3],
        lanes: Lanes,
        lit: &mut [u32; BLOCK_POINTS],
    ) {
        let mut paths = Paths::new(&self.program, tracers);
        let mut which = 0;
        for (place, placed) in placed.iter().enumerate() {
            let Some(Placed { at, hit }) = *placed else { continue };
            let ray = self.program.ray_to_light(at, hit, light, [point, count]);
            if ray.state != LightRayState::Open as u32 {
                lit[place] += u32::from(ray.state == LightRayState::Lit as u32);
            } else if paths.set(place, &ray.path) {
                which |= 1 << place;
            } else {
                let mut alone = Paths::new(&self.program, tracers);
                alone.set(place, &ray.path);
                lit[place] += u32::from(alone.free(1 << place, Lanes::One) != 0);
            }
        }
        let free = if which == 0 { 0 } else { paths.free(which, lanes) };
        for (place, lit) in lit.iter_mut().enumerate() {
            *lit += u32::from(free >> place & 1);
        }
    }
}
