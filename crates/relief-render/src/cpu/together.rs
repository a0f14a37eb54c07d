//! Paths of a block of points that are traced together.

use relief_core::Lanes;
use relief_core::exact::{FastTracer, HitPacket, PathPacket};
use relief_shaders::cpu::{Entered, Hit, PixelIn, Vec4};
use relief_shaders::{LightRayState, MAX_LIGHTS};

use super::ready::Ready;
use crate::raycast::tiles::TileHit;

/// Points along a side of a block.
pub const BLOCK: usize = 4;

/// Points of a block, as many as paths of a packet.
pub const BLOCK_POINTS: usize = BLOCK * BLOCK;

const _: () = assert!(BLOCK_POINTS == PathPacket::LEN);

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
    /// The level of detail that it is in.
    pub level: u32,
}

/// How much of each light arrives.
pub type Visible = [Vec4<f32>; MAX_LIGHTS];

impl Ready<'_> {
    /// Whether the paths of a block's first polygons are traced together.
    pub fn traces_ahead(&self, lanes: Lanes) -> bool {
        self.tracers.is_some() && lanes != Lanes::One
    }

    /// Of the points of a block what their first polygons show, as far as that can be traced together: by
    /// the exact tracer, and in one level of detail.
    pub fn ahead(&self, points: &Block<([f32; 2], TileHit)>, lanes: Lanes) -> Block<Ahead> {
        let mut ahead = [None; BLOCK_POINTS];
        let Some(tracers) = &self.tracers else { return ahead };
        let mut packet = PathPacket::EMPTY;
        let mut level = None;
        for (lane, (point, ahead)) in points.iter().zip(&mut ahead).enumerate() {
            let Some((place, TileHit { triangle, front, .. })) = *point else { continue };
            let pixel = self.pixel(triangle, if front { 1.0 } else { -1.0 }, self.aim(place));
            let at = self.program.enter(pixel);
            if at.segments == 0 || *level.get_or_insert(at.level) != at.level {
                continue;
            }
            let path = self.program.segment(pixel, at, 0);
            if path.exit > 0.0 {
                packet.set(lane, &(&path).into());
                let hit = Hit::from(&relief_core::Hit::miss(Default::default()));
                *ahead = Some(Ahead { pixel, at, hit });
            }
        }
        if let Some(level) = level {
            let hits = traced(&tracers[level as usize], &packet, lanes);
            for (lane, ahead) in ahead.iter_mut().enumerate() {
                if let Some(ahead) = ahead {
                    ahead.hit = Hit::from(&hits.hit(lane).hit);
                }
            }
        }
        ahead
    }

    /// What of the lights arrives at placed hits: rays that the shaders make, traced by the tracers.
    pub fn visible_lights(
        &self,
        tracers: &[FastTracer],
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
        tracers: &[FastTracer],
        placed: &Block<Placed>,
        [light, point, count]: [u32; 3],
        lanes: Lanes,
        lit: &mut [u32; BLOCK_POINTS],
    ) {
        let mut packet = PathPacket::EMPTY;
        let mut level = None;
        let mut open = [false; BLOCK_POINTS];
        for (lane, placed) in placed.iter().enumerate() {
            let Some(Placed { at, hit, level: own }) = *placed else { continue };
            let ray = self.program.ray_to_light(at, hit, light, [point, count]);
            if ray.state != LightRayState::Open as u32 {
                lit[lane] += u32::from(ray.state == LightRayState::Lit as u32);
            } else if lanes != Lanes::One && *level.get_or_insert(own) == own {
                packet.set(lane, &(&ray.path).into());
                open[lane] = true;
            } else {
                lit[lane] += u32::from(!tracers[own as usize].trace(&(&ray.path).into()).hit.found);
            }
        }
        if let Some(level) = level {
            let hits = traced(&tracers[level as usize], &packet, lanes);
            for (lane, open) in open.into_iter().enumerate() {
                lit[lane] += u32::from(open && hits.found >> lane & 1 == 0);
            }
        }
    }
}

fn traced(tracer: &FastTracer, packet: &PathPacket, lanes: Lanes) -> HitPacket {
    let mut hits = HitPacket::MISSES;
    tracer.trace_packets(std::slice::from_ref(packet), lanes, std::slice::from_mut(&mut hits));
    hits
}
