//! A surface made ready for the rays of a frame: what they meet of it, and what that looks like.

use std::sync::Arc;

use glam::{DVec3, Vec3};
use relief_core::exact::FastTracer;
use relief_core::{BakedMap, Cost, Lanes};
use relief_shaders::MAX_LIGHTS;
use relief_shaders::cpu::{
    Corner, Entered, FirstHit, Frame, Hit, Path, PixelIn, PixelOut, Program, Triangle, Vec3 as ShaderVec3,
    Vec4,
};
use relief_shaders::surface::FOLDED;

use super::together::{Ahead, Block, Placed, Visible};
use crate::camera::Ray;
use crate::job::{Job, JobSurface};
use crate::light_views::{frame_of_rays, relief_points};
use crate::raycast::tiles::{PictureRays, TileCaster, TileHit, TileHits};
use crate::raycast::{RayCaster, Sides};
use crate::shellcast::ShellCaster;
use crate::triangles::Triangles;

/// The hierarchy of a mesh's polygons.
pub fn caster(triangles: &Triangles) -> RayCaster {
    let position = |corner: &Corner| Vec3::new(corner.position.x, corner.position.y, corner.position.z);
    RayCaster::of_corners(triangles.iter().map(|Triangle { a, b, c, .. }| [&a, &b, &c].map(position)))
}

/// The depths, relative to the nearest hit, up to which base polygons are looked at: keys and depths are
/// rounded in other ways. Smaller, and the backends may show different polygons; larger costs time only.
const DEPTH_SLACK: f64 = 1e-5;

/// How far before a point rays to it from lights end, as parts of the displacement and of the largest
/// coordinate: nearer, and rounding lets surfaces hide themselves where light grazes them; farther, and they
/// do not where they are curved.
const SHORTER_BY_SCALE: f32 = 3e-3;
const SHORTER_BY_EXTENT: f32 = 1e-5;

/// How many texels beside a ray from a light its segments may run: where light grazes the relief, what is
/// that far beside it can be in another crest's shadow.
const LIGHT_TOLERANCE_TEXELS: f32 = 0.01;

/// What a ray meets of a surface, and all that is needed to shade it.
#[derive(Clone, Copy)]
pub struct Seen {
    pixel: PixelIn,
    at: Entered,
    pub first: FirstHit,
    /// Of equally near ones the least counts: whether the mesh was turned over, and the triangle.
    rank: (bool, u32),
}

/// What proposes triangles to a ray.
#[derive(Clone)]
pub enum Base {
    Polygons(Arc<RayCaster>),
    Shells(Arc<ShellCaster>),
}

/// What is made of a surface once.
#[derive(Clone)]
pub struct Made {
    pub base: Base,
    /// The exact tracers of all levels of detail, where they serve.
    pub tracers: Option<Arc<[FastTracer]>>,
}

/// Where a ray begins and where it goes; its direction has a component of 1 along the view axis.
#[derive(Clone, Copy)]
pub struct Aim {
    pub origin: ShaderVec3<f32>,
    pub direction: ShaderVec3<f32>,
}

/// A surface ready to be traced.
pub struct Ready<'a> {
    pub(super) program: Program<'a>,
    rays: PictureRays,
    triangles: &'a Triangles,
    base: Base,
    sides: Sides,
    /// The exact tracers of all levels of detail.
    pub(super) tracers: Option<Arc<[FastTracer]>>,
    /// Whether they serve shadows, too.
    traces_shadows: bool,
    /// Whether anything is searched for, and whether shadows are those of rays, and to how many points of a
    /// light these go.
    pub(super) is_traced: bool,
    sends_rays: bool,
    pub(super) points_of_lights: u32,
    /// The same of shadows by rays through the whole scene.
    rays_through_scene: Option<u32>,
    pub(super) lights: u32,
    /// Whether the relief nowhere lies above its base, or there is none.
    is_carved: bool,
    /// As in [`Frame`].
    near: f64,
    /// How far before the surface rays of lights end, in metres.
    shorter_m: f32,
}

impl<'a> Ready<'a> {
    /// The surface in a frame, with what its lights see where shadows are looked up there.
    pub fn new(surface: &'a JobSurface, frame: Frame, light_map: Option<&'a BakedMap>, made: Made) -> Self {
        Self::with_program(surface, surface.program(frame, light_map), frame, made)
    }

    /// The surface for rays from lights through a whole scene.
    fn for_light(surface: &'a JobSurface, frame: Frame, made: Made) -> Self {
        let finer = surface.selection.with_tolerance_within(LIGHT_TOLERANCE_TEXELS);
        let settings = surface.settings.with_choices_of(&finer);
        Self::with_program(surface, surface.program_with(settings, frame, None), frame, made)
    }

    fn with_program(surface: &'a JobSurface, program: Program<'a>, frame: Frame, made: Made) -> Self {
        let Made { base, tracers } = made;
        let sides = if surface.two_sided { Sides::Both } else { Sides::Front };
        Self {
            program,
            rays: picture_rays(&frame),
            triangles: &surface.triangles,
            base,
            sides,
            tracers,
            traces_shadows: surface.selection.has_exact_shadows(),
            is_traced: surface.selection.is_traced(),
            sends_rays: surface.selection.sends_rays_to_lights(),
            points_of_lights: surface.selection.points_of_lights(),
            rays_through_scene: surface.selection.rays_through_scene(),
            lights: frame.light_count,
            is_carved: !surface.selection.paths().has_relief
                || surface.settings.bias_m + surface.settings.scale_m <= 0.0,
            near: frame.near.into(),
            shorter_m: SHORTER_BY_SCALE * surface.settings.scale_m
                + SHORTER_BY_EXTENT * extent_m(&surface.triangles),
        }
    }

    /// What casts the rays of a picture of so many columns and rows by tiles, if anything does.
    pub fn tiles(&self, size: [u32; 2], lanes: Lanes) -> Option<TileCaster<'_>> {
        match &self.base {
            Base::Polygons(caster) => Some(TileCaster::new(caster, self.rays, size, self.sides, lanes)),
            Base::Shells(_) => None,
        }
    }

    /// What a point of the picture shows of the surface: the nearest hit of all base polygons along the ray,
    /// and of equally near ones that of the first polygon. `cast` are the tile that the point is in, where
    /// that was cast, and its number there, and `ahead` is what is known of the first polygon.
    pub fn seen(
        &self,
        point: [f32; 2],
        cast: Option<(&TileCaster, &TileHits, usize)>,
        mut ahead: Option<&Ahead>,
    ) -> Option<Seen> {
        if cast.is_some_and(|(_, hits, point)| hits.is_miss(point)) {
            return None;
        }
        let aim = self.aim(point);
        let mut best: Option<Seen> = None;
        let look = |rank, side| {
            match ahead.take() {
                Some(&Ahead { pixel, at, hit }) => {
                    let first = self.first_hit(pixel, at, Some(hit));
                    keep_nearest(&mut best, Seen { pixel, at, first, rank });
                }
                None => self.look(&mut best, rank, side, aim),
            }
            self.reach(best.as_ref())
        };
        match cast {
            Some((caster, hits, point)) => {
                self.propose_polygons(caster.hits(hits, point), f64::INFINITY, look);
            }
            None => self.propose(aim, f64::INFINITY, look),
        }
        best
    }

    /// Whether a ray hits anything at a depth below that.
    pub fn hides(&self, aim: Aim, depth_m: f32) -> bool {
        let least = self.program.key_of_depth(depth_m);
        let mut best: Option<Seen> = None;
        let mut is_hidden = false;
        self.propose(aim, f64::from(depth_m), |rank, side| {
            if !is_hidden {
                self.look(&mut best, rank, side, aim);
                is_hidden = best.as_ref().is_some_and(|best| best.first.key > least);
            }
            if is_hidden { f64::NEG_INFINITY } else { f64::from(depth_m) }
        });
        is_hidden
    }

    /// Calls `look` with the triangles that a ray may meet the relief of, roughly from near to far, and with
    /// their sides, until what comes begins beyond a depth: at first `reach`, then what `look` says.
    fn propose(&self, aim: Aim, mut reach: f64, mut look: impl FnMut((bool, u32), f32) -> f64) {
        let ray = ray_of(aim);
        match &self.base {
            Base::Polygons(caster) => {
                self.propose_polygons(caster.hits(&ray, self.sides).map(TileHit::from), reach, look);
            }
            Base::Shells(caster) => caster.each(&ray, |triangle| {
                reach = look((false, triangle), 1.0).min(reach);
                if self.sides == Sides::Both {
                    reach = look((true, triangle), -1.0).min(reach);
                }
                reach
            }),
        }
    }

    /// The same of polygons that a ray hits, in that order.
    fn propose_polygons(
        &self,
        hits: impl Iterator<Item = TileHit>,
        mut reach: f64,
        mut look: impl FnMut((bool, u32), f32) -> f64,
    ) {
        for hit in hits {
            // What lies behind its polygon is not nearer than that.
            if self.is_carved && hit.t > reach {
                break;
            }
            reach = look((false, hit.triangle), if hit.front { 1.0 } else { -1.0 });
        }
    }

    /// Where the ray through a point of the picture begins, and where it goes.
    pub(super) fn aim(&self, point: [f32; 2]) -> Aim {
        Aim { origin: self.program.pixel_eye(point), direction: self.program.pixel_direction(point) }
    }

    /// A ray and a side of a triangle, as the shaders have them.
    pub(super) fn pixel(&self, triangle: u32, side: f32, aim: Aim) -> PixelIn {
        let Triangle { a, b, c, shell } = self.triangles.get(triangle as usize);
        PixelIn { origin: aim.origin, direction: aim.direction, side, a, b, c, shell }
    }

    /// Traces a side of a triangle, and keeps what it shows where that is the nearest so far.
    fn look(&self, best: &mut Option<Seen>, rank: (bool, u32), side: f32, aim: Aim) {
        let pixel = self.pixel(rank.1, side, aim);
        let at = self.program.enter(pixel);
        let first = self.first_hit(pixel, at, None);
        keep_nearest(best, Seen { pixel, at, first, rank });
    }

    /// The first hit of a ray in the relief of a polygon; `ahead` is the hit of its first segment, where that
    /// is known.
    fn first_hit(&self, pixel: PixelIn, at: Entered, ahead: Option<Hit>) -> FirstHit {
        match (&self.tracers, ahead) {
            (None, None) => self.program.first_hit(pixel, at),
            (None, Some(_)) => {
                let trace = |path| self.program.trace(path);
                let (mut first, cost) = self.first_of_segments(pixel, at, ahead, trace);
                first.hit.cost = cost;
                first
            }
            (Some(tracers), _) => {
                let tracer = &tracers[at.level as usize];
                let trace = |path: Path| Hit::from(&tracer.trace(&(&path).into()).hit);
                // What other segments cost is not told.
                self.first_of_segments(pixel, at, ahead, trace).0
            }
        }
    }

    /// How deep what is nearer than that may begin.
    fn reach(&self, best: Option<&Seen>) -> f64 {
        best.map_or(f64::INFINITY, |best| self.depth_of(best.first.key, DEPTH_SLACK))
    }

    /// A depth beyond that of a key, by as much slack, relatively.
    fn depth_of(&self, key: f32, slack: f64) -> f64 {
        self.near / f64::from(key) * (1.0 + slack) - self.near
    }

    /// The first hit that is in no hole, as the shaders' function of that name has it, and what all segments
    /// cost that were traced. In a shell that overlaps itself it is the nearest of all segments'.
    fn first_of_segments(
        &self,
        pixel: PixelIn,
        at: Entered,
        mut ahead: Option<Hit>,
        trace: impl Fn(Path) -> Hit,
    ) -> (FirstHit, ShaderVec3<u32>) {
        let miss = Hit::from(&relief_core::Hit::miss(Cost::default()));
        let mut cost = miss.cost;
        let mut first = FirstHit { hit: miss, segment: 0, key: 0.0 };
        for number in 0..at.segments {
            let path = self.program.segment(pixel, at, number);
            if path.exit > 0.0 {
                let hit = ahead.take().unwrap_or_else(|| trace(path));
                cost = cost + hit.cost;
                let hit = if hit.found == 1 { self.program.polish(pixel, at, path, hit) } else { hit };
                if hit.found == 1 && !self.program.in_hole(hit.uv) {
                    let key = self.program.key(pixel, path, hit);
                    if first.hit.found == 0 || key > first.key {
                        first = FirstHit { hit, segment: number, key };
                    }
                    if pixel.shell.order < FOLDED {
                        break;
                    }
                }
            }
        }
        (first, cost)
    }

    /// A pixel's colour so far with one more sample.
    pub fn add_sample(&self, sum: Vec4<f32>, color: Vec4<f32>, weight: f32) -> Vec4<f32> {
        self.program.add_sample(sum, color, weight)
    }

    /// What the hits of a block of points look like, handed on point by point; `scene` is all that may be in
    /// a light's way.
    pub fn shade(
        &self,
        seen: &Block<&Seen>,
        scene: Option<&SceneRays>,
        lanes: Lanes,
        put: &mut dyn FnMut(usize, PixelOut),
    ) {
        let place = |Seen { pixel, at, first, .. }: &Seen| {
            let placed = self.program.place(*pixel, *at, first.segment, first.hit);
            Placed { at: placed, hit: first.hit }
        };
        let tracers = self.tracers.as_deref().filter(|_| self.traces_shadows);
        let through = self.rays_through_scene.zip(scene);
        let is_together = tracers.is_some() || self.sends_rays && lanes != Lanes::One;
        if through.is_none() && is_together {
            let placed = seen.map(|seen| seen.map(place));
            let visible = self.visible_lights(tracers, &placed, lanes);
            for (point, ((seen, placed), visible)) in seen.iter().zip(&placed).zip(visible).enumerate() {
                if let (Some(seen), Some(Placed { at, hit }), Some(visible)) = (seen, placed, visible) {
                    put(point, self.program.shade_hit(seen.pixel, *at, *hit, visible));
                }
            }
            return;
        }
        for (point, seen) in seen.iter().enumerate() {
            let Some(seen) = seen else { continue };
            let Placed { at, hit } = place(seen);
            let visible = match through {
                Some((count, scene)) => self.visible_through(scene, at, hit, count),
                None => self.program.visible_lights(at, hit),
            };
            put(point, self.program.shade_hit(seen.pixel, at, hit, visible));
        }
    }

    /// What of the lights arrives at a placed hit through a scene, by so many rays from each.
    fn visible_through(&self, scene: &SceneRays, at: Entered, hit: Hit, count: u32) -> Visible {
        let three = |v: ShaderVec3<f32>| Vec3::new(v.x, v.y, v.z);
        let end = three(at.point);
        let mut visible = [Vec4::from([0.0; 4]); MAX_LIGHTS];
        for (visible, light) in visible.iter_mut().zip(0..self.lights) {
            let is_lit = |point: &u32| {
                // A single ray goes to the light's centre.
                let of = if count > 1 { [*point, count] } else { [0, 0] };
                let toward = self.program.point_of_light(at, hit, light, of);
                let direction = three(toward.direction);
                let way = toward.distance.min(scene.reach_m);
                let [origin, direction] = [end + direction * way, -direction].map(|v| v.to_array().into());
                let is_hidden =
                    |surface: &Ready| surface.hides(Aim { origin, direction }, way - self.shorter_m);
                !scene.surfaces.iter().any(is_hidden)
            };
            visible.x = (0..count).filter(is_lit).count() as f32 / count as f32;
        }
        visible
    }
}

/// Keeps what a polygon shows where that is the nearest so far.
fn keep_nearest(best: &mut Option<Seen>, seen: Seen) {
    let (key, rank) = (seen.first.key, seen.rank);
    let is_nearer = |best: &Seen| key > best.first.key || (key == best.first.key && rank < best.rank);
    if seen.first.hit.found == 1 && best.as_ref().is_none_or(is_nearer) {
        *best = Some(seen);
    }
}

/// All surfaces of a scene, for rays from lights.
pub struct SceneRays<'a> {
    pub surfaces: Vec<Ready<'a>>,
    /// Metres from anywhere in the scene to a place out of it.
    pub reach_m: f32,
}

impl<'a> SceneRays<'a> {
    /// Those of a job, of which so much was made.
    pub fn new(job: &'a Job, made: &[Made]) -> Self {
        let points = || job.surfaces.iter().flat_map(relief_points);
        let (low, high) = points().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), point| {
            (low.min(point), high.max(point))
        });
        let across = (high - low).length();
        let reach_m = if across.is_finite() { across * 1.01 } else { 1.0 };
        let frame = frame_of_rays(reach_m);
        let ready = job.surfaces.iter().zip(made);
        let surfaces = ready.map(|(surface, made)| Ready::for_light(surface, frame, made.clone()));
        Self { surfaces: surfaces.collect(), reach_m: reach_m as f32 }
    }
}

fn ray_of(aim: Aim) -> Ray {
    let three = |v: ShaderVec3<f32>| [v.x, v.y, v.z].map(f64::from).into();
    Ray { origin: three(aim.origin), direction: three(aim.direction) }
}

/// The rays of a frame's picture, which are those of the shaders.
pub fn picture_rays(frame: &Frame) -> PictureRays {
    let three = |v: Vec4<f32>| Vec3::new(v.x, v.y, v.z);
    PictureRays {
        origin: [frame.eye, frame.eye_right, frame.eye_down].map(three),
        direction: [frame.corner, frame.right, frame.down].map(three),
    }
}

/// The largest absolute coordinate of some triangles' corners, in metres.
fn extent_m(triangles: &Triangles) -> f32 {
    let largest = |of: &Corner| [of.position.x, of.position.y, of.position.z].map(f32::abs);
    triangles.corners().iter().flat_map(largest).fold(0.0, f32::max)
}
