//! The shaders' functions that hosts call.

use relief_core::Lanes;

use super::generated::Resources;
use super::lanes::{
    self, EnteredBlock, HitBlock, LightPoint, PathBlock, PixelOutBlock, Row, Task, TriangleRays,
};
use super::{Bound, Entered, FirstHit, Found, Hit, Path, PixelIn, PixelOut, Toward, Triangle, Vec3, Vec4};
use crate::MAX_LIGHTS;

/// The shaders with what is bound to them: the same functions that GPUs run, with the same bits in exact
/// sampling.
///
/// A renderer calls [`Self::shade_pixel`] for every pixel that a triangle covers. Rays without a picture have
/// [`MethodTracer`](super::MethodTracer).
#[derive(Clone, Copy, Debug)]
pub struct Program<'a>(Resources<'a>);

impl<'a> Program<'a> {
    /// The shaders over these settings and maps.
    pub fn new(bound: &Bound<'a>) -> Self {
        Self(Resources::of(bound))
    }

    /// Where the ray begins along which the camera sees a point of the picture, in pixels from its upper left
    /// corner.
    #[inline]
    pub fn pixel_eye(&self, point: [f32; 2]) -> Vec3<f32> {
        self.0.pixel_eye(point)
    }

    /// The direction in which the camera sees a point of the picture, in pixels from its upper left corner.
    /// Its component along the camera's axis is 1.
    #[inline]
    pub fn pixel_direction(&self, point: [f32; 2]) -> Vec3<f32> {
        self.0.pixel_direction(point)
    }

    /// What the stages are given of a point of the picture that a triangle covers. `side` is 1 on its front,
    /// -1 on its back.
    #[inline]
    pub fn pixel_of(&self, triangle: &Triangle, side: f32, point: [f32; 2]) -> PixelIn {
        let Triangle { a, b, c, shell } = *triangle;
        self.0.pixel_of(a, b, c, shell, side, point)
    }

    /// The stages surface and detail: where the ray meets the surface, in how many segments it goes through
    /// the relief, and the level of detail.
    #[inline]
    pub fn enter(&self, pixel: PixelIn) -> Entered {
        self.0.enter_relief(pixel)
    }

    /// A segment of the ray's way through the relief, by its number. One whose exit is not positive is none.
    #[inline]
    pub fn segment(&self, pixel: PixelIn, entered: Entered, number: u32) -> Path {
        self.0.segment_of(pixel, entered, number)
    }

    /// The first hit, segment after segment.
    #[inline]
    pub fn first_hit(&self, pixel: PixelIn, entered: Entered) -> FirstHit {
        self.0.first_hit(pixel, entered)
    }

    /// A hit that was found on a segment, where the segment's ray truly is.
    #[inline]
    pub fn polish(&self, pixel: PixelIn, entered: Entered, path: Path, hit: Hit) -> Hit {
        self.0.polish_hit(pixel, entered, path, hit)
    }

    /// What was found on the segment of that number, as what the ray meets there: a hit where the segment's
    /// ray truly is, and none in a hole.
    #[inline]
    pub fn hit_on_segment(
        &self,
        pixel: PixelIn,
        entered: Entered,
        path: Path,
        found: Hit,
        number: u32,
    ) -> FirstHit {
        self.0.hit_on_segment(pixel, entered, path, found, number)
    }

    /// What orders the hits of a pixel's ray: the greater, the nearer. From 0, infinitely far away, to 1 at
    /// the eye.
    #[inline]
    pub fn key(&self, pixel: PixelIn, path: Path, hit: Hit) -> f32 {
        self.0.key_of(self.0.depth_on_ray(pixel, path, hit))
    }

    /// That of a depth in metres along the view axis.
    #[inline]
    pub fn key_of_depth(&self, depth_m: f32) -> f32 {
        self.0.key_of(depth_m)
    }

    /// A hit on the displaced surface: its place in the world, and the frame there.
    #[inline]
    pub fn place(&self, pixel: PixelIn, entered: Entered, segment: u32, hit: Hit) -> Entered {
        self.0.place_hit(pixel, entered, segment, hit)
    }

    /// The search stage.
    #[inline]
    pub fn search(&self, path: Path) -> Found {
        self.0.search_stage(path)
    }

    /// The refinement stage.
    #[inline]
    pub fn refine(&self, path: Path, found: Found) -> Hit {
        self.0.refine_stage(path, found)
    }

    /// Search and refinement of a path.
    #[inline]
    pub fn trace(&self, path: Path) -> Hit {
        self.0.trace(path)
    }

    /// The same of the paths of a block that `which` has bits for, over lanes. The hits of the others stay as
    /// they were.
    #[inline]
    pub fn trace_block(&self, paths: &PathBlock, which: u16, lanes: Lanes, hits: &mut HitBlock) {
        lanes::run(&self.0, lanes, which, Task::Trace { paths, hits });
    }

    /// Of the paths to lights of a block that `which` has bits for, those that are free by the search for
    /// shadows, over lanes.
    #[inline]
    pub fn free_block(&self, paths: &PathBlock, which: u16, lanes: Lanes) -> u16 {
        let mut free = 0;
        lanes::run(&self.0, lanes, which, Task::Free { paths, free: &mut free });
        free
    }

    /// Of the rays that `which` has bits for, where they meet the surface, and their first segments where
    /// they have any: [`Self::enter`] and [`Self::segment`] over lanes.
    #[inline]
    pub fn enter_block(
        &self,
        rays: TriangleRays<'_>,
        which: u16,
        lanes: Lanes,
        at: &mut EnteredBlock,
        paths: &mut PathBlock,
    ) {
        lanes::run(&self.0, lanes, which, Task::Enter { rays, at, paths });
    }

    /// [`Self::segment`] over lanes, of rays that have a segment of that number.
    #[inline]
    pub fn segment_block(
        &self,
        rays: TriangleRays<'_>,
        number: u32,
        which: u16,
        lanes: Lanes,
        at: &EnteredBlock,
        paths: &mut PathBlock,
    ) {
        lanes::run(&self.0, lanes, which, Task::Segment { rays, number, at, paths });
    }

    /// [`Self::hit_on_segment`] over lanes, of what was found on segments of that number, with what orders
    /// it.
    #[inline]
    pub fn meet_block(
        &self,
        (rays, number): (TriangleRays<'_>, u32),
        which: u16,
        lanes: Lanes,
        (at, paths): (&EnteredBlock, &PathBlock),
        hits: &mut HitBlock,
        keys: &mut Row<f32>,
    ) {
        lanes::run(&self.0, lanes, which, Task::Meet { rays, number, at, paths, hits, keys });
    }

    /// The places in the world of hits on those paths, and the frames there, over lanes.
    #[inline]
    pub fn place_block(
        &self,
        rays: TriangleRays<'_>,
        which: u16,
        lanes: Lanes,
        (at, paths, hits): (&EnteredBlock, &PathBlock, &HitBlock),
        placed: &mut EnteredBlock,
    ) {
        lanes::run(&self.0, lanes, which, Task::Place { rays, at, paths, hits, placed });
    }

    /// The rays from placed hits to a point of a light, over lanes, and the states of them, each a
    /// [`LightRayState`](crate::LightRayState).
    #[inline]
    pub fn rays_to_light_block(
        &self,
        to: LightPoint,
        which: u16,
        lanes: Lanes,
        (placed, hits): (&EnteredBlock, &HitBlock),
        states: &mut Row<u32>,
        paths: &mut PathBlock,
    ) {
        lanes::run(&self.0, lanes, which, Task::RaysToLight { to, placed, hits, states, paths });
    }

    /// The part of the light of that number that arrives at placed hits, over lanes.
    #[inline]
    pub fn visible_block(
        &self,
        light: u32,
        which: u16,
        lanes: Lanes,
        (placed, hits): (&EnteredBlock, &HitBlock),
        parts: &mut Row<f32>,
    ) {
        lanes::run(&self.0, lanes, which, Task::Visible { light, placed, hits, parts });
    }

    /// Pixels whose hits are known and placed, and the parts of the lights that arrive there, over lanes.
    /// `points` are columns and rows in the picture.
    #[inline]
    pub fn shade_block(
        &self,
        points: &[Row<f32>; 2],
        which: u16,
        lanes: Lanes,
        (placed, hits, visible): (&EnteredBlock, &HitBlock, &[Row<f32>; MAX_LIGHTS]),
        pixels: &mut PixelOutBlock,
    ) {
        lanes::run(&self.0, lanes, which, Task::Shade { points, placed, hits, visible, pixels });
    }

    /// A whole pixel: all stages.
    #[inline]
    pub fn shade_pixel(&self, pixel: PixelIn) -> PixelOut {
        self.0.shade_pixel(pixel)
    }

    /// The light of that number from a placed hit: a point of its disc, by its
    /// number and how many there are, as the shadow `soft` has them, or its centre where there are none.
    #[inline]
    pub fn point_of_light(&self, placed: Entered, hit: Hit, light: u32, [k, count]: [u32; 2]) -> Toward {
        self.0.point_of_light(placed, hit, light, k, count)
    }

    /// The part of a light that arrives at a placed hit, for a light of some degrees whose direction is that
    /// of the pixel's ray after a mirror in the base surface.
    #[inline]
    pub fn mirrored_light(&self, pixel: PixelIn, placed: Entered, hit: Hit) -> f32 {
        self.0.mirrored_light(pixel, placed, hit)
    }

    /// The colour of a pixel's samples so far with one more, of that weight. The fourth part is how much of
    /// the pixel is covered.
    #[inline]
    pub fn add_sample(&self, sum: Vec4<f32>, color: Vec4<f32>, weight: f32) -> Vec4<f32> {
        self.0.add_sample(sum, color, weight)
    }
}
