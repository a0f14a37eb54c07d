//! Surfaces prepared for the rays of a frame: hits and shading.

use std::sync::Arc;

use glam::{DVec3, Vec3};
use relief_core::exact::FastTracer;
use relief_core::{BakedMap, Lanes};
use relief_shaders::cpu::{
    Corner, Entered, FirstHit, Frame, Hit, Path, PixelIn, Program, Triangle, Vec3 as ShaderVec3, Vec4,
};
use relief_shaders::surface::{DEPTH_SLACK, FOLDED};

use crate::job::{Job, JobSurface};
use crate::light_views::{frame_of_rays, relief_points};
use crate::prepare::Triangles;
use crate::shellcast::ShellCaster;
use relief_core::camera::Ray;
use relief_core::raycast::tiles::{PictureRays, TileCaster, TileHit};
use relief_core::raycast::{RayCaster, Sides};

/// Builds the BVH of a mesh's triangles.
pub fn caster(triangles: &Triangles) -> RayCaster {
    let position = |corner: &Corner| Vec3::new(corner.position.x, corner.position.y, corner.position.z);
    RayCaster::of_corners(triangles.iter().map(|Triangle { a, b, c, .. }| [&a, &b, &c].map(position)))
}

/// Distance before a point at which rays from lights end, as parts of the displacement and of the
/// largest coordinate. If it is smaller, surfaces shadow themselves by rounding where light grazes
/// them. If it is larger, curved surfaces lose their own shadows.
const SHORTER_BY_SCALE: f32 = 3e-3;
const SHORTER_BY_EXTENT: f32 = 1e-5;

/// Tolerance of segments beside a ray from a light, in texels. Where light grazes the relief, a
/// point that far beside the ray can be in another crest's shadow.
const LIGHT_TOLERANCE_TEXELS: f32 = 0.01;

/// First hit of a ray in the relief of a base triangle, with its entry and its path.
pub struct ReliefHit {
    pub at: Entered,
    pub path: Path,
    pub first: FirstHit,
}

/// BVH that proposes triangles to a ray: of the triangles themselves, or of their shells.
#[derive(Clone)]
pub enum Base {
    Polygons(Arc<RayCaster>),
    Shells(Arc<ShellCaster>),
}

/// BVH and exact tracers of a surface, cached from job to job.
#[derive(Clone)]
pub struct Acceleration {
    pub base: Base,
    /// Exact tracers of all levels of detail, if the surface is traced by them.
    pub tracers: Option<Arc<[FastTracer]>>,
}

/// Origin and direction of a ray. The direction has a component of 1 along the view axis.
#[derive(Clone, Copy)]
pub struct ShaderRay {
    pub origin: ShaderVec3<f32>,
    pub direction: ShaderVec3<f32>,
}

impl ShaderRay {
    /// Converts the ray to 64 bits.
    pub fn ray(&self) -> Ray {
        let three = |v: ShaderVec3<f32>| [v.x, v.y, v.z].map(f64::from).into();
        Ray { origin: three(self.origin), direction: three(self.direction) }
    }
}

/// A surface ready to be traced.
pub struct PreparedSurface<'a> {
    pub(super) program: Program<'a>,
    rays: PictureRays,
    triangles: &'a Triangles,
    pub(super) base: Base,
    pub(super) sides: Sides,
    /// Exact tracers of all levels of detail, if the surface is traced by them.
    pub(super) tracers: Option<Arc<[FastTracer]>>,
    /// Whether the exact tracers trace shadows, too.
    pub(super) traces_shadows: bool,
    /// Whether shadows send rays, and the number of points on a light that the rays go to.
    pub(super) sends_rays: bool,
    pub(super) points_of_lights: u32,
    /// Number of points on a light if shadow rays go through the whole scene.
    pub(super) rays_through_scene: Option<u32>,
    pub(super) lights: u32,
    /// Whether light is gathered through it, and nothing is hit.
    pub(super) is_translucent: bool,
    /// Whether it is a depth object, whose segments are not parts of one path.
    pub(super) is_object: bool,
    /// Whether the relief nowhere lies above its base, or there is none.
    is_carved: bool,
    /// Depth below which keys are ordered less finely, see [`Frame`].
    near: f64,
    /// Distance before the surface at which rays from lights end, in metres.
    pub(super) shorter_m: f32,
}

impl<'a> PreparedSurface<'a> {
    /// Prepares a surface for a frame. `light_map` holds the shadow maps, if the surface reads
    /// them.
    pub fn new(
        surface: &'a JobSurface,
        frame: Frame,
        light_map: Option<&'a BakedMap>,
        acceleration: Acceleration,
    ) -> Self {
        Self::with_program(surface, surface.program(frame, light_map), frame, acceleration)
    }

    /// Prepares a surface for rays from lights through the whole scene.
    fn for_light(surface: &'a JobSurface, frame: Frame, acceleration: Acceleration) -> Self {
        let finer = surface.selection.with_tolerance_within(LIGHT_TOLERANCE_TEXELS);
        let settings = surface.settings.with_choices_of(&finer);
        Self::with_program(surface, surface.program_with(settings, frame, None), frame, acceleration)
    }

    fn with_program(
        surface: &'a JobSurface,
        program: Program<'a>,
        frame: Frame,
        acceleration: Acceleration,
    ) -> Self {
        let Acceleration { base, tracers } = acceleration;
        let traces_shadows = tracers.is_some() && surface.selection.has_exact_shadows();
        let sides = if surface.two_sided { Sides::Both } else { Sides::Front };
        Self {
            program,
            rays: picture_rays(&frame),
            triangles: &surface.triangles,
            base,
            sides,
            tracers,
            traces_shadows,
            sends_rays: surface.selection.sends_rays_to_lights(),
            points_of_lights: surface.selection.points_of_lights(),
            rays_through_scene: surface.selection.rays_through_scene(),
            lights: frame.light_count,
            is_translucent: surface.selection.is_translucent(),
            is_object: surface.selection.object_cells().is_some(),
            is_carved: !surface.selection.paths().has_relief()
                || surface.settings.bias_m + surface.settings.scale_m <= 0.0,
            near: frame.near.into(),
            shorter_m: SHORTER_BY_SCALE * surface.settings.scale_m
                + SHORTER_BY_EXTENT * extent_m(&surface.triangles),
        }
    }

    /// Returns the caster by tiles for a picture of the given columns and rows, if the base has
    /// one.
    pub fn tiles(&self, size: [u32; 2], lanes: Lanes) -> Option<TileCaster<'_>> {
        match &self.base {
            Base::Polygons(caster) => Some(TileCaster::new(caster, self.rays, size, self.sides, lanes)),
            Base::Shells(_) => None,
        }
    }

    /// Whether a ray hits anything at a depth below `depth_m`.
    pub fn hides(&self, aim: ShaderRay, depth_m: f32) -> bool {
        let least = self.program.key_of_depth(depth_m);
        let mut is_hidden = false;
        self.propose(aim, f64::from(depth_m), |(_, triangle), side| {
            is_hidden = is_hidden
                || self.trace_triangle(triangle, side, aim).is_some_and(|met| met.first.key > least);
            if is_hidden { f64::NEG_INFINITY } else { f64::from(depth_m) }
        });
        is_hidden
    }

    /// Calls `look` with the triangles whose relief a ray may hit, and with their sides, roughly
    /// from near to far. It stops at triangles that begin beyond a depth: at first `reach`, then
    /// the depth that `look` returned.
    pub(super) fn propose(
        &self,
        aim: ShaderRay,
        mut reach: f64,
        mut look: impl FnMut((bool, u32), f32) -> f64,
    ) {
        let ray = aim.ray();
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

    /// Calls `look` with the base triangles that a ray hits, in the order of `hits`.
    pub(super) fn propose_polygons(
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

    /// Returns the ray through a point of the picture, in pixels.
    pub(super) fn ray_through(&self, point: [f32; 2]) -> ShaderRay {
        ShaderRay { origin: self.program.pixel_eye(point), direction: self.program.pixel_direction(point) }
    }

    /// Returns a triangle with its corners.
    pub(super) fn triangle(&self, number: u32) -> Triangle {
        self.triangles.get(number as usize)
    }

    /// Returns a ray and a side of a triangle as the input of the shaders.
    pub(super) fn pixel(&self, triangle: u32, side: f32, aim: ShaderRay) -> PixelIn {
        let Triangle { a, b, c, shell } = self.triangle(triangle);
        PixelIn { origin: aim.origin, direction: aim.direction, side, a, b, c, shell }
    }

    /// Returns the first hit of a ray in the relief of a triangle's side.
    pub(super) fn trace_triangle(&self, triangle: u32, side: f32, aim: ShaderRay) -> Option<ReliefHit> {
        let pixel = self.pixel(triangle, side, aim);
        self.first_from(pixel, self.program.enter(pixel), 0, [0; 3].into())
    }

    /// Returns the greatest depth at which geometry nearer than `key` may begin.
    pub(super) fn reach(&self, key: f32) -> f64 {
        self.depth_of(key, DEPTH_SLACK)
    }

    /// Returns the depth of a key, moved away by a relative slack.
    fn depth_of(&self, key: f32, slack: f64) -> f64 {
        self.near / f64::from(key) * (1.0 + slack) - self.near
    }

    /// Returns the first hit of a ray on the segments from number `from` on, like the shaders'
    /// `first_hit`. In a shell that overlaps itself it is the nearest of all hits. `cost` is the
    /// cost of the segments before.
    pub(super) fn first_from(
        &self,
        pixel: PixelIn,
        at: Entered,
        from: u32,
        mut cost: ShaderVec3<u32>,
    ) -> Option<ReliefHit> {
        if self.is_object {
            let first = self.program.first_hit(pixel, at);
            let path = self.program.segment(pixel, at, first.segment);
            return (first.hit.found == 1).then_some(ReliefHit { at, path, first });
        }
        let mut first: Option<ReliefHit> = None;
        for number in from..at.segments {
            let path = self.program.segment(pixel, at, number);
            if path.exit > 0.0 {
                let found = match &self.tracers {
                    None => self.program.trace(path),
                    Some(tracers) => Hit::from(&tracers[at.level as usize].trace(&(&path).into()).hit),
                };
                let here = self.program.hit_on_segment(pixel, at, path, found, number);
                cost = cost + here.hit.cost;
                if here.hit.found == 1 {
                    if first.as_ref().is_none_or(|met| here.key > met.first.key) {
                        first = Some(ReliefHit { at, path, first: here });
                    }
                    if pixel.shell.order < FOLDED {
                        break;
                    }
                }
            }
        }
        if let (Some(met), None) = (&mut first, &self.tracers) {
            // Searches report the cost of all segments, tracers the cost of finding the hit.
            met.first.hit.cost = cost;
        }
        first
    }

    /// Adds a sample to a pixel's sum of colours.
    pub fn add_sample(&self, sum: Vec4<f32>, color: Vec4<f32>, weight: f32) -> Vec4<f32> {
        self.program.add_sample(sum, color, weight)
    }
}

/// All surfaces of a scene, for rays from lights.
pub struct SceneRays<'a> {
    pub opaque: Vec<PreparedSurface<'a>>,
    pub translucent: Vec<PreparedSurface<'a>>,
    /// Distance in metres that leads out of the scene from any of its points.
    pub reach_m: f32,
}

impl<'a> SceneRays<'a> {
    /// Creates the rays through the scene of a job, from its prepared surfaces.
    pub fn new(job: &'a Job, accelerations: &[Acceleration]) -> Self {
        let points = || job.surfaces.iter().flat_map(relief_points);
        let (low, high) = points().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(low, high), point| {
            (low.min(point), high.max(point))
        });
        let across = (high - low).length();
        let reach_m = if across.is_finite() { across * 1.01 } else { 1.0 };
        let frame = frame_of_rays(reach_m);
        let ready = job.surfaces.iter().zip(accelerations);
        let surfaces = ready
            .map(|(surface, acceleration)| PreparedSurface::for_light(surface, frame, acceleration.clone()));
        let (translucent, opaque) = surfaces.partition(|surface| surface.is_translucent);
        Self { opaque, translucent, reach_m: reach_m as f32 }
    }
}

/// Returns the rays of a frame's picture, the same as in the shaders.
pub fn picture_rays(frame: &Frame) -> PictureRays {
    let three = |v: Vec4<f32>| Vec3::new(v.x, v.y, v.z);
    PictureRays {
        origin: [frame.eye, frame.eye_right, frame.eye_down].map(three),
        direction: [frame.corner, frame.right, frame.down].map(three),
    }
}

/// Returns the largest absolute coordinate of the triangles' corners, in metres.
fn extent_m(triangles: &Triangles) -> f32 {
    let largest = |of: &Corner| [of.position.x, of.position.y, of.position.z].map(f32::abs);
    triangles.corners().iter().flat_map(largest).fold(0.0, f32::max)
}
