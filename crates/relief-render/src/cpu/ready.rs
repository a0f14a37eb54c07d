//! A surface made ready for the rays of a frame: what they meet of it, and what that looks like.

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

/// The hierarchy of a mesh's polygons.
pub fn caster(triangles: &Triangles) -> RayCaster {
    let position = |corner: &Corner| Vec3::new(corner.position.x, corner.position.y, corner.position.z);
    RayCaster::of_corners(triangles.iter().map(|Triangle { a, b, c, .. }| [&a, &b, &c].map(position)))
}

/// How far before a point rays to it from lights end, as parts of the displacement and of the largest
/// coordinate: nearer, and rounding lets surfaces hide themselves where light grazes them; farther, and they
/// do not where they are curved.
const SHORTER_BY_SCALE: f32 = 3e-3;
const SHORTER_BY_EXTENT: f32 = 1e-5;

/// How many texels beside a ray from a light its segments may run: where light grazes the relief, what is
/// that far beside it can be in another crest's shadow.
const LIGHT_TOLERANCE_TEXELS: f32 = 0.01;

/// What a ray meets of a polygon's relief: where it enters that, and on which path.
pub struct Met {
    pub at: Entered,
    pub path: Path,
    pub first: FirstHit,
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

impl Aim {
    /// The same in 64 bits.
    pub fn ray(&self) -> Ray {
        let three = |v: ShaderVec3<f32>| [v.x, v.y, v.z].map(f64::from).into();
        Ray { origin: three(self.origin), direction: three(self.direction) }
    }
}

/// A surface ready to be traced.
pub struct Ready<'a> {
    pub(super) program: Program<'a>,
    rays: PictureRays,
    triangles: &'a Triangles,
    pub(super) base: Base,
    pub(super) sides: Sides,
    /// The exact tracers of all levels of detail.
    pub(super) tracers: Option<Arc<[FastTracer]>>,
    /// Whether they serve shadows, too.
    pub(super) traces_shadows: bool,
    /// Whether shadows send rays, and the number of points of a light that the rays go to.
    pub(super) sends_rays: bool,
    pub(super) points_of_lights: u32,
    /// The same of shadows by rays through the whole scene.
    pub(super) rays_through_scene: Option<u32>,
    pub(super) lights: u32,
    /// Whether it is an object, whose segments are not parts of one way.
    pub(super) is_object: bool,
    /// Whether the relief nowhere lies above its base, or there is none.
    is_carved: bool,
    /// As in [`Frame`].
    near: f64,
    /// How far before the surface rays of lights end, in metres.
    pub(super) shorter_m: f32,
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
            is_object: surface.selection.object_cells().is_some(),
            is_carved: !surface.selection.paths().has_relief()
                || surface.settings.bias_m + surface.settings.scale_m <= 0.0,
            near: frame.near.into(),
            shorter_m: SHORTER_BY_SCALE * surface.settings.scale_m
                + SHORTER_BY_EXTENT * extent_m(&surface.triangles),
        }
    }

    /// Returns the caster by tiles for a picture of the given columns and rows, if the base has one.
    pub fn tiles(&self, size: [u32; 2], lanes: Lanes) -> Option<TileCaster<'_>> {
        match &self.base {
            Base::Polygons(caster) => Some(TileCaster::new(caster, self.rays, size, self.sides, lanes)),
            Base::Shells(_) => None,
        }
    }

    /// Whether a ray hits anything at a depth below that.
    pub fn hides(&self, aim: Aim, depth_m: f32) -> bool {
        let least = self.program.key_of_depth(depth_m);
        let mut is_hidden = false;
        self.propose(aim, f64::from(depth_m), |(_, triangle), side| {
            is_hidden = is_hidden || self.look(triangle, side, aim).is_some_and(|met| met.first.key > least);
            if is_hidden { f64::NEG_INFINITY } else { f64::from(depth_m) }
        });
        is_hidden
    }

    /// Calls `look` with the triangles that a ray may meet the relief of, roughly from near to far, and with
    /// their sides, until what comes begins beyond a depth: at first `reach`, then what `look` says.
    pub(super) fn propose(&self, aim: Aim, mut reach: f64, mut look: impl FnMut((bool, u32), f32) -> f64) {
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

    /// The same of polygons that a ray hits, in that order.
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

    /// Where the ray through a point of the picture begins, and where it goes.
    pub(super) fn aim(&self, point: [f32; 2]) -> Aim {
        Aim { origin: self.program.pixel_eye(point), direction: self.program.pixel_direction(point) }
    }

    /// A triangle with its corners.
    pub(super) fn triangle(&self, number: u32) -> Triangle {
        self.triangles.get(number as usize)
    }

    /// A ray and a side of a triangle, as the shaders have them.
    pub(super) fn pixel(&self, triangle: u32, side: f32, aim: Aim) -> PixelIn {
        let Triangle { a, b, c, shell } = self.triangle(triangle);
        PixelIn { origin: aim.origin, direction: aim.direction, side, a, b, c, shell }
    }

    /// What a ray first hits in the relief of a side of a triangle.
    pub(super) fn look(&self, triangle: u32, side: f32, aim: Aim) -> Option<Met> {
        let pixel = self.pixel(triangle, side, aim);
        self.first_from(pixel, self.program.enter(pixel), 0, [0; 3].into())
    }

    /// How deep what is nearer than that key may begin.
    pub(super) fn reach(&self, key: f32) -> f64 {
        self.depth_of(key, DEPTH_SLACK)
    }

    /// Depth beyond a key's depth, by a relative slack.
    fn depth_of(&self, key: f32, slack: f64) -> f64 {
        self.near / f64::from(key) * (1.0 + slack) - self.near
    }

    /// The first hit of a ray on the segments from that number on, as the shaders' `first_hit` has it: in a
    /// shell that overlaps itself the nearest of all. The segments before have cost so much.
    pub(super) fn first_from(
        &self,
        pixel: PixelIn,
        at: Entered,
        from: u32,
        mut cost: ShaderVec3<u32>,
    ) -> Option<Met> {
        if self.is_object {
            let first = self.program.first_hit(pixel, at);
            let path = self.program.segment(pixel, at, first.segment);
            return (first.hit.found == 1).then_some(Met { at, path, first });
        }
        let mut first: Option<Met> = None;
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
                        first = Some(Met { at, path, first: here });
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

    /// A pixel's colour so far with one more sample.
    pub fn add_sample(&self, sum: Vec4<f32>, color: Vec4<f32>, weight: f32) -> Vec4<f32> {
        self.program.add_sample(sum, color, weight)
    }
}

/// All surfaces of a scene, for rays from lights.
pub struct SceneRays<'a> {
    pub surfaces: Vec<Ready<'a>>,
    /// Metres from anywhere in the scene to a place out of it.
    pub reach_m: f32,
}

impl<'a> SceneRays<'a> {
    /// Creates the rays through the scene of a job, from its prepared surfaces.
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

/// Rays of a frame's picture, the same as in the shaders.
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
