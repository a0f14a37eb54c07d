//! The shaders' functions that hosts call.

use relief_core::Lanes;

use super::explain::{Explanation, explain};
use super::generated::{Material, Resources};
use super::lanes::{
    self, EnteredBlock, HitBlock, LightPoint, PathBlock, PixelOutBlock, Row, Task, TriangleRays,
};
use super::{
    Bound, Entered, FirstHit, Gathered, Hit, Path, PixelIn, PixelOut, SearchResult, Toward, Triangle, Vec3,
    Vec4,
};
use crate::MAX_LIGHTS;

/// The shaders with their bindings: the same functions that GPUs run, with the same bits in exact
/// sampling.
///
/// A renderer calls [`Self::shade_pixel`] for every pixel that a triangle covers. For rays without
/// a picture there is [`MethodTracer`](super::MethodTracer).
#[derive(Clone, Copy, Debug)]
pub struct Program<'a>(Resources<'a>);

impl<'a> Program<'a> {
    /// Creates the shaders over these settings and maps.
    pub fn new(bound: &Bound<'a>) -> Self {
        Self(Resources::of(bound))
    }

    /// Returns the origin of the camera's ray through a point of the picture, in pixels from its
    /// top-left corner.
    #[inline]
    pub fn pixel_eye(&self, point: [f32; 2]) -> Vec3<f32> {
        self.0.pixel_eye(point)
    }

    /// Returns the direction of the camera's ray through a point of the picture, in pixels from its
    /// top-left corner. Its component along the camera's axis is 1.
    #[inline]
    pub fn pixel_direction(&self, point: [f32; 2]) -> Vec3<f32> {
        self.0.pixel_direction(point)
    }

    /// Returns the stages' input for a point of the picture that a triangle covers. `side` is 1 on
    /// its front, -1 on its back.
    #[inline]
    pub fn pixel_of(&self, triangle: &Triangle, side: f32, point: [f32; 2]) -> PixelIn {
        let Triangle { a, b, c, shell } = *triangle;
        self.0.pixel_of(a, b, c, shell, side, point)
    }

    /// Runs the stages surface and detail: the point where the ray meets the surface, the number of
    /// its segments through the relief, and the level of detail.
    #[inline]
    pub fn enter(&self, pixel: PixelIn) -> Entered {
        self.0.enter_relief(pixel)
    }

    /// Returns a segment of the ray's way through the relief, by its number. A segment whose exit
    /// is not positive is empty.
    #[inline]
    pub fn segment(&self, pixel: PixelIn, entered: Entered, number: u32) -> Path {
        self.0.segment_of(pixel, entered, number)
    }

    /// Returns the first hit, segment after segment.
    #[inline]
    pub fn first_hit(&self, pixel: PixelIn, entered: Entered) -> FirstHit {
        self.0.first_hit(pixel, entered)
    }

    /// Moves a hit on a segment onto the segment's ray.
    #[inline]
    pub fn polish(&self, pixel: PixelIn, entered: Entered, path: Path, hit: Hit) -> Hit {
        self.0.polish_hit(pixel, entered, path, hit)
    }

    /// Returns the result of search and refinement on segment `number` as the first hit of the ray:
    /// moved onto the ray, and a miss in a hole.
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

    /// Returns a key that orders the hits of a pixel's ray: the greater, the nearer. From 0,
    /// infinitely far away, to 1 at the eye.
    #[inline]
    pub fn key(&self, pixel: PixelIn, path: Path, hit: Hit) -> f32 {
        self.0.key_of(self.0.depth_on_ray(pixel, path, hit))
    }

    /// Returns the key of a depth in metres along the view axis.
    #[inline]
    pub fn key_of_depth(&self, depth_m: f32) -> f32 {
        self.0.key_of(depth_m)
    }

    /// Places a hit on the displaced surface: its position in the world, and the frame there.
    #[inline]
    pub fn place(&self, pixel: PixelIn, entered: Entered, segment: u32, hit: Hit) -> Entered {
        self.0.place_hit(pixel, entered, segment, hit)
    }

    /// Runs the search stage.
    #[inline]
    pub fn search(&self, path: Path) -> SearchResult {
        self.0.search_stage(path)
    }

    /// Runs the refinement stage.
    #[inline]
    pub fn refine(&self, path: Path, found: SearchResult) -> Hit {
        self.0.refine_stage(path, found)
    }

    /// Runs search and refinement on a path with marks.
    pub(super) fn explain(&self, path: &relief_core::Path) -> Explanation {
        explain(&self.0, path)
    }

    /// Runs search and refinement on a path.
    #[inline]
    pub fn trace(&self, path: Path) -> Hit {
        self.0.trace(path)
    }

    /// Returns the linear light that the selected shading reflects toward an eye in direction
    /// `view`, under an irradiance of 1 from direction `toward`. The directions are unit vectors.
    /// `color` is the colour map's, `uv` the place in the material maps. The surface's own light
    /// and the light from all around are left out.
    pub fn reflected(
        &self,
        color: [f32; 3],
        uv: [f32; 2],
        [normal, view, toward]: [[f32; 3]; 3],
    ) -> Vec3<f32> {
        let material = self.material(color, uv, [normal, view]);
        let cosine = (normal[0] * toward[0] + normal[1] * toward[1]) + normal[2] * toward[2];
        self.0.shade_light_stage(material, normal, 1.0, cosine.max(0.0), view, toward)
    }

    /// Returns the linear light that the selected shading reflects toward an eye in direction
    /// `view`, under a light of 1 that is the same from all around. See [`Program::reflected`].
    pub fn reflected_from_around(
        &self,
        color: [f32; 3],
        uv: [f32; 2],
        directions: [[f32; 3]; 2],
    ) -> Vec3<f32> {
        self.material(color, uv, directions).around
    }

    fn material(&self, color: [f32; 3], uv: [f32; 2], [normal, view]: [[f32; 3]; 2]) -> Material {
        let at = EnteredBlock::default().get(0);
        let hit = Hit { uv: uv.into(), ..HitBlock::default().get(0) };
        self.0.shade_material_stage(at, hit, normal, 1.0, view, color)
    }

    /// Runs search and refinement in SIMD lanes on the paths of a block that `which` has bits for.
    /// The other hits stay as they were.
    #[inline]
    pub fn trace_block(&self, paths: &PathBlock, which: u16, lanes: Lanes, hits: &mut HitBlock) {
        lanes::run(&self.0, lanes, which, Task::Trace { paths, hits });
    }

    /// Runs the search for shadows in SIMD lanes on the paths to lights that `which` has bits for.
    /// Returns bits of the free ones.
    #[inline]
    pub fn free_block(&self, paths: &PathBlock, which: u16, lanes: Lanes) -> u16 {
        let mut free = 0;
        lanes::run(&self.0, lanes, which, Task::Free { paths, free: &mut free });
        free
    }

    /// Runs [`Self::enter`] and [`Self::segment`] in SIMD lanes for the rays that `which` has bits
    /// for: the points where they meet the surface, and their first segments, if they have any.
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

    /// Runs [`Self::segment`] in SIMD lanes, for rays that have a segment of that number.
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

    /// Runs [`Self::hit_on_segment`] in SIMD lanes, for hits on segments of that number. `keys`
    /// receives the keys of the hits.
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

    /// Places hits on these paths in SIMD lanes: positions in the world, and the frames there.
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

    /// Makes the rays from placed hits to a point of a light in SIMD lanes. `states` receives their
    /// states, each a [`LightRayState`](crate::LightRayState).
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

    /// Returns the part of light number `light` that arrives at placed hits, in SIMD lanes.
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

    /// Shades pixels with placed hits in SIMD lanes. `visible` holds the parts of the lights that
    /// arrive there; `points` are columns and rows in the picture.
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

    /// Runs all stages for a pixel.
    #[inline]
    pub fn shade_pixel(&self, pixel: PixelIn) -> PixelOut {
        self.0.shade_pixel(pixel)
    }

    /// Returns light number `light` from a placed hit: point `k` of `count` on its disc, as for the
    /// shadow `soft`, or its centre if `count` is 0.
    #[inline]
    pub fn point_of_light(&self, placed: Entered, hit: Hit, light: u32, [k, count]: [u32; 2]) -> Toward {
        self.0.point_of_light(placed, hit, light, k, count)
    }

    /// Returns the part of a light that arrives at a placed hit. The light has a disc of some
    /// degrees, and its direction is the pixel's ray after a mirror in the base surface.
    #[inline]
    pub fn mirrored_light(&self, pixel: PixelIn, placed: Entered, hit: Hit) -> f32 {
        self.0.mirrored_light(pixel, placed, hit)
    }

    /// Begins a ray that gathers the light of a translucent surface, up to an opaque hit at that depth along
    /// the view axis; without one, on and on.
    #[inline]
    pub fn begin_gathering(&self, direction: Vec3<f32>, opaque: Option<f32>) -> Gathered {
        let (found, depth) = opaque.map_or((0, 0.0), |depth| (1, depth));
        self.0.nothing_gathered(self.0.reach_of_hit(found, depth, direction))
    }

    /// Gathers the light on segment `number` of a shell. The segments of all shells are to be given in the
    /// order in which they begin on the ray, as long as [`Self::goes_on`] holds.
    #[inline]
    pub fn gather(&self, before: Gathered, pixel: PixelIn, entered: Entered, number: u32) -> Gathered {
        self.0.gather_segment(before, pixel, entered, number)
    }

    /// Finds which part of light comes through segment `number` of a shell, as the transmittance of what
    /// is gathered. See [`Self::gather`].
    #[inline]
    pub fn let_through(&self, before: Gathered, pixel: PixelIn, entered: Entered, number: u32) -> Gathered {
        self.0.pass_segment(before, pixel, entered, number)
    }

    /// Returns the optical depth of a translucent volume along a path. Beyond 8, where hardly any light is
    /// left, a part of it may be missing.
    #[inline]
    pub fn optical_depth(&self, path: Path) -> f32 {
        self.0.optical_depth(path)
    }

    /// Returns the part of light that comes through an optical depth, from 0 on.
    #[inline]
    pub fn transmittance(&self, optical_depth: f32) -> f32 {
        self.0.transmittance_of(optical_depth)
    }

    /// Whether there may be more to gather: light still comes through.
    #[inline]
    pub fn goes_on(&self, gathered: &Gathered) -> bool {
        self.0.goes_on(*gathered)
    }

    /// Returns a colour that is seen through what a ray gathered. The fourth part is the covered part of
    /// the pixel.
    #[inline]
    pub fn seen_through(&self, behind: Vec4<f32>, gathered: Gathered) -> Vec4<f32> {
        self.0.seen_through(behind, gathered)
    }

    /// Returns the colour of a pixel's samples so far, with one more sample of that weight. The
    /// fourth part is the covered part of the pixel.
    #[inline]
    pub fn add_sample(&self, sum: Vec4<f32>, color: Vec4<f32>, weight: f32) -> Vec4<f32> {
        self.0.add_sample(sum, color, weight)
    }
}
