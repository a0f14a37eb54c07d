//! Shading of a block's hits.

use glam::Vec3;
use relief_core::Lanes;
use relief_shaders::cpu::{
    BLOCK, EnteredBlock, LightPoint, PathBlock, PixelOut, PixelOutBlock, Row, Vec3 as ShaderVec3,
};
use relief_shaders::{LightRayState, MAX_LIGHTS};

use super::block::{places, places_where};
use super::block_hits::BlockHits;
use super::prepared_surface::{PreparedSurface, SceneRays, ShaderRay};

/// Share of each light that arrives, from 0 to 1.
type Visible = [Row<f32>; MAX_LIGHTS];

impl PreparedSurface<'_> {
    /// Shades the points whose bits `which` has, and calls `put` with each. `scene` is the geometry
    /// that may block lights, if shadow rays go through all of it.
    pub fn shade(
        &self,
        seen: &BlockHits,
        which: u16,
        scene: Option<&SceneRays>,
        lanes: Lanes,
        put: &mut dyn FnMut(usize, PixelOut),
    ) {
        let BlockHits { points, faces, at, paths, hits, .. } = seen;
        let mut placed = EnteredBlock::default();
        faces.each(self, points, which, lanes, |rays, which, lanes| {
            self.program.place_block(rays, which, lanes, (at, paths, hits), &mut placed);
        });
        let visible = self.visible(seen, &placed, which, scene, lanes);
        let mut pixels = PixelOutBlock::default();
        self.program.shade_block(points, which, lanes, (&placed, hits, &visible), &mut pixels);
        for place in places(which) {
            put(place, pixels.get(place));
        }
    }

    /// Returns the share of each light that arrives at placed hits.
    fn visible(
        &self,
        seen: &BlockHits,
        placed: &EnteredBlock,
        which: u16,
        scene: Option<&SceneRays>,
        lanes: Lanes,
    ) -> Visible {
        let mut visible = [[0.0; BLOCK]; MAX_LIGHTS];
        let through = self.rays_through_scene.zip(scene);
        for (light, visible) in (0..self.lights).zip(&mut visible) {
            if let Some((count, scene)) = through {
                for place in places(which) {
                    visible[place] = self.lit_through(scene, seen, placed, [place as u32, light, count]);
                }
            } else if self.traces_shadows || self.sends_rays && lanes != Lanes::One {
                self.lit_by_rays(seen, placed, which, light, lanes, visible);
            } else {
                self.program.visible_block(light, which, lanes, (placed, &seen.hits), visible);
            }
        }
        visible
    }

    /// Computes the share of a light that arrives. The shaders make the rays; the exact tracers or
    /// the shadow search trace them.
    fn lit_by_rays(
        &self,
        seen: &BlockHits,
        placed: &EnteredBlock,
        which: u16,
        light: u32,
        lanes: Lanes,
        visible: &mut Row<f32>,
    ) {
        let count = self.points_of_lights;
        let (mut states, mut paths) = ([0; BLOCK], PathBlock::default());
        let mut lit = [0u32; BLOCK];
        for point in 0..count.max(1) {
            let to = LightPoint { light, point, count };
            let hits = (placed, &seen.hits);
            self.program.rays_to_light_block(to, which, lanes, hits, &mut states, &mut paths);
            let is = |state: LightRayState| which & places_where(|place| states[place] == state as u32);
            let open = is(LightRayState::Open);
            let free = if open == 0 { 0 } else { self.free_block(&paths, open, lanes) };
            for place in places(free | is(LightRayState::Lit)) {
                lit[place] += 1;
            }
        }
        for place in places(which) {
            visible[place] = lit[place] as f32 / count.max(1) as f32;
        }
    }

    /// Returns the share of a light that arrives at a placed hit through the whole scene, by
    /// `count` rays from the light.
    fn lit_through(
        &self,
        scene: &SceneRays,
        seen: &BlockHits,
        placed: &EnteredBlock,
        [place, light, count]: [u32; 3],
    ) -> f32 {
        let (at, hit) = (placed.get(place as usize), seen.hits.get(place as usize));
        let three = |v: ShaderVec3<f32>| Vec3::new(v.x, v.y, v.z);
        let end = three(at.point);
        let part_lit = |point: u32| {
            // A single ray goes to the light's centre.
            let of = if count > 1 { [point, count] } else { [0, 0] };
            let toward = self.program.point_of_light(at, hit, light, of);
            let direction = three(toward.direction);
            let way = toward.distance.min(scene.reach_m);
            let [origin, direction] = [end + direction * way, -direction].map(|v| v.to_array().into());
            let (aim, way) = (ShaderRay { origin, direction }, way - self.shorter_m);
            if scene.opaque.iter().any(|surface| surface.hides(aim, way)) {
                return 0.0;
            }
            scene.translucent.iter().map(|surface| surface.lets_through(aim, way)).product()
        };
        (0..count).map(part_lit).sum::<f32>() / count as f32
    }
}
