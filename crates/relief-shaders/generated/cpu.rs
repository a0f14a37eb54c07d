// The stages' translation. Written by `cargo xtask link`; do not edit.

use crate::cpu::runtime as rt;
use crate::cpu::runtime::{Convert as _, SquareRoot as _};

#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A ray over a quadric: along it and across it the changes of the texture coordinates and of the quadric.
pub struct Across {
    pub duv: rt::Vec2<f32>,
    /// The ray's descent per metre.
    pub descent: f32,
    /// The quadric's height at the end of a metre along the ray, of one across it, and the sum's
    /// mixed term.
    pub along: f32,
    pub across: f32,
    pub mixed: f32,
    /// The rise of a metre across the ray.
    pub sine: f32,
}
impl Across {
    pub fn new(
        duv: impl rt::Into<rt::Vec2<f32>>,
        descent: impl rt::Into<f32>,
        along: impl rt::Into<f32>,
        across: impl rt::Into<f32>,
        mixed: impl rt::Into<f32>,
        sine: impl rt::Into<f32>,
    ) -> Self {
        Self { duv: rt::into(duv), descent: rt::into(descent), along: rt::into(along), across: rt::into(across), mixed: rt::into(mixed), sine: rt::into(sine) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The four texels around a point of a level of a map other than the height map, and where the point lies
/// between them.
pub struct Around {
    pub columns: rt::Vec2<i32>,
    pub rows: rt::Vec2<i32>,
    pub part: rt::Vec2<f32>,
}
impl Around {
    pub fn new(
        columns: impl rt::Into<rt::Vec2<i32>>,
        rows: impl rt::Into<rt::Vec2<i32>>,
        part: impl rt::Into<rt::Vec2<f32>>,
    ) -> Self {
        Self { columns: rt::into(columns), rows: rt::into(rows), part: rt::into(part) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A point of the base, with its data.
pub struct BaseSite {
    pub position: rt::Vec3<f32>,
    pub direction: rt::Vec3<f32>,
    /// The place on the map that gives the displacement, and the point's own place on the map.
    pub seen_uv: rt::Vec2<f32>,
    pub uv: rt::Vec2<f32>,
    /// Texels of the map per metre, and the depth. Their product gives the level of the map.
    pub texels_per_m: f32,
    pub depth: f32,
    pub normal: rt::Vec3<f32>,
    pub tangent: rt::Vec3<f32>,
    pub bitangent: rt::Vec3<f32>,
    pub turn_u: rt::Vec3<f32>,
    pub turn_v: rt::Vec3<f32>,
}
impl BaseSite {
    pub fn new(
        position: impl rt::Into<rt::Vec3<f32>>,
        direction: impl rt::Into<rt::Vec3<f32>>,
        seen_uv: impl rt::Into<rt::Vec2<f32>>,
        uv: impl rt::Into<rt::Vec2<f32>>,
        texels_per_m: impl rt::Into<f32>,
        depth: impl rt::Into<f32>,
        normal: impl rt::Into<rt::Vec3<f32>>,
        tangent: impl rt::Into<rt::Vec3<f32>>,
        bitangent: impl rt::Into<rt::Vec3<f32>>,
        turn_u: impl rt::Into<rt::Vec3<f32>>,
        turn_v: impl rt::Into<rt::Vec3<f32>>,
    ) -> Self {
        Self { position: rt::into(position), direction: rt::into(direction), seen_uv: rt::into(seen_uv), uv: rt::into(uv), texels_per_m: rt::into(texels_per_m), depth: rt::into(depth), normal: rt::into(normal), tangent: rt::into(tangent), bitangent: rt::into(bitangent), turn_u: rt::into(turn_u), turn_v: rt::into(turn_v) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A vertex of the base.
pub struct BaseVertex {
    pub position: rt::Vec3<f32>,
    /// The vertex whose place on the map gives the displacement: one for each position.
    pub seen: u32,
    /// The direction of displacement, of any length: the same for all vertices at a position.
    pub direction: rt::Vec3<f32>,
    /// Texels of the map per metre around it.
    pub texels_per_m: f32,
    pub normal: rt::Vec3<f32>,
    pub tangent: rt::Vec3<f32>,
    pub bitangent: rt::Vec3<f32>,
    /// The derivatives of the direction by u and v.
    pub turn_u: rt::Vec3<f32>,
    pub turn_v: rt::Vec3<f32>,
    pub uv: rt::Vec2<f32>,
}
impl BaseVertex {
    pub fn new(
        position: impl rt::Into<rt::Vec3<f32>>,
        seen: impl rt::Into<u32>,
        direction: impl rt::Into<rt::Vec3<f32>>,
        texels_per_m: impl rt::Into<f32>,
        normal: impl rt::Into<rt::Vec3<f32>>,
        tangent: impl rt::Into<rt::Vec3<f32>>,
        bitangent: impl rt::Into<rt::Vec3<f32>>,
        turn_u: impl rt::Into<rt::Vec3<f32>>,
        turn_v: impl rt::Into<rt::Vec3<f32>>,
        uv: impl rt::Into<rt::Vec2<f32>>,
    ) -> Self {
        Self { position: rt::into(position), seen: rt::into(seen), direction: rt::into(direction), texels_per_m: rt::into(texels_per_m), normal: rt::into(normal), tangent: rt::into(tangent), bitangent: rt::into(bitangent), turn_u: rt::into(turn_u), turn_v: rt::into(turn_v), uv: rt::into(uv) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A part of a path: in one cell, or in a box of empty ones around it.
pub struct CellPart {
    pub cell: rt::Vec3<f32>,
    /// The parameters between which the path is there.
    pub begin: f32,
    pub end: f32,
    /// The parameters at which it leaves the cells, along u, v and the height.
    pub leave: rt::Vec3<f32>,
    /// Cells around this one that are empty, as is the cell; below 0 where it may not be.
    pub empty: f32,
    /// 1 behind the place where the height stops rising or falling.
    pub past_turn: u32,
    /// 1 where the path ends with this part, before it leaves the cells.
    pub is_last: u32,
}
impl CellPart {
    pub fn new(
        cell: impl rt::Into<rt::Vec3<f32>>,
        begin: impl rt::Into<f32>,
        end: impl rt::Into<f32>,
        leave: impl rt::Into<rt::Vec3<f32>>,
        empty: impl rt::Into<f32>,
        past_turn: impl rt::Into<u32>,
        is_last: impl rt::Into<u32>,
    ) -> Self {
        Self { cell: rt::into(cell), begin: rt::into(begin), end: rt::into(end), leave: rt::into(leave), empty: rt::into(empty), past_turn: rt::into(past_turn), is_last: rt::into(is_last) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The chosen variant of a stage.
pub struct Choice {
    /// The variant's place in the stage's list.
    pub number: u32,
    /// The variant's parameters, in the order of its registry entry.
    pub params: rt::Vec4<f32>,
}
impl Choice {
    pub fn new(
        number: impl rt::Into<u32>,
        params: impl rt::Into<rt::Vec4<f32>>,
    ) -> Self {
        Self { number: rt::into(number), params: rt::into(params) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A corner of a base triangle, in the world. Tangent and bitangent are as long as one tile in the
/// world.
pub struct Corner {
    pub position: rt::Vec3<f32>,
    pub normal: rt::Vec3<f32>,
    pub tangent: rt::Vec3<f32>,
    pub bitangent: rt::Vec3<f32>,
    pub uv: rt::Vec2<f32>,
    /// Data for the surface stage alone; zeros for surfaces without any. Quadrics: x, y and z are
    /// the coefficients of q(du, dv) = x du² + y du dv + z dv², which the base follows around the
    /// corner. It is in metres a tile squared, positive along the normal. Slices: their height at
    /// the corner, the distance between neighbours along an axis, and that axis, one of
    /// SLICES_ALONG_*.
    pub of_surface: rt::Vec3<f32>,
}
impl Corner {
    pub fn new(
        position: impl rt::Into<rt::Vec3<f32>>,
        normal: impl rt::Into<rt::Vec3<f32>>,
        tangent: impl rt::Into<rt::Vec3<f32>>,
        bitangent: impl rt::Into<rt::Vec3<f32>>,
        uv: impl rt::Into<rt::Vec2<f32>>,
        of_surface: impl rt::Into<rt::Vec3<f32>>,
    ) -> Self {
        Self { position: rt::into(position), normal: rt::into(normal), tangent: rt::into(tangent), bitangent: rt::into(bitangent), uv: rt::into(uv), of_surface: rt::into(of_surface) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The level of detail of a pixel.
pub struct Detail {
    /// The level of the maps that are traced.
    pub level: u32,
    /// See `Entered`.
    pub footprint: f32,
    pub fade: f32,
}
impl Detail {
    pub fn new(
        level: impl rt::Into<u32>,
        footprint: impl rt::Into<f32>,
        fade: impl rt::Into<f32>,
    ) -> Self {
        Self { level: rt::into(level), footprint: rt::into(footprint), fade: rt::into(fade) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// Where a point lies in its row.
pub struct DicePlace {
    pub row: u32,
    pub at: u32,
}
impl DicePlace {
    pub fn new(
        row: impl rt::Into<u32>,
        at: impl rt::Into<u32>,
    ) -> Self {
        Self { row: rt::into(row), at: rt::into(at) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A point of a triangle.
pub struct DicePoint {
    /// The triangle's side that the point lies on, and the number of parts before it there, fewer
    /// than the side has; or `INSIDE`, and its number among the points inside.
    pub side: u32,
    pub at: u32,
    /// The weights of the triangle's corners; not set for a point on a side.
    pub weights: rt::Vec3<f32>,
}
impl DicePoint {
    pub fn new(
        side: impl rt::Into<u32>,
        at: impl rt::Into<u32>,
        weights: impl rt::Into<rt::Vec3<f32>>,
    ) -> Self {
        Self { side: rt::into(side), at: rt::into(at), weights: rt::into(weights) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A triangle seen from the corner where its two longer sides meet.
pub struct DiceRows {
    /// The side from that corner onward, the side of fewest parts, and the side back to the corner;
    /// then the parts of each.
    pub sides: rt::Vec3<u32>,
    pub parts: rt::Vec3<u32>,
    /// Number of rows after the corner.
    pub count: u32,
}
impl DiceRows {
    pub fn new(
        sides: impl rt::Into<rt::Vec3<u32>>,
        parts: impl rt::Into<rt::Vec3<u32>>,
        count: impl rt::Into<u32>,
    ) -> Self {
        Self { sides: rt::into(sides), parts: rt::into(parts), count: rt::into(count) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A triangle of the pattern, with the winding of the whole one.
pub struct DiceTriangle {
    pub a: DicePlace,
    pub b: DicePlace,
    pub c: DicePlace,
}
impl DiceTriangle {
    pub fn new(
        a: impl rt::Into<DicePlace>,
        b: impl rt::Into<DicePlace>,
        c: impl rt::Into<DicePlace>,
    ) -> Self {
        Self { a: rt::into(a), b: rt::into(b), c: rt::into(c) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A ray's place on a surface: at first on its base; on the displaced surface after a hit has been
/// placed.
pub struct Entered {
    /// Number of segments of the way through the relief; 0 if the ray never enters it.
    pub segments: u32,
    /// The point, in the world and in texture space, and the frame there.
    pub point: rt::Vec3<f32>,
    pub uv: rt::Vec2<f32>,
    pub tangent: rt::Vec3<f32>,
    pub bitangent: rt::Vec3<f32>,
    pub normal: rt::Vec3<f32>,
    /// See `Path`.
    pub metric: rt::Vec4<f32>,
    pub level: u32,
    /// The normal, of any length, of the plane in which footprints of pixels are measured.
    pub facing: rt::Vec3<f32>,
    /// The extent of the ray in a shell: metres from its nearest place to the triangle.
    pub span: rt::Vec2<f32>,
    /// `Corner.of_surface` at the point. For quadrics positive toward the ray's side; the fourth
    /// number is the height of the point in the relief.
    pub of_surface: rt::Vec4<f32>,
    /// Width of the pixel's footprint in texels of the height map's finest level; 0 if everything is
    /// seen in the finest level.
    pub footprint: f32,
    /// The part, below 1, by which the traced relief is flattened: its heights are drawn toward
    /// their mean.
    pub fade: f32,
    /// For a placed hit: metres along the view axis, from the origin of the ray to the hit on the
    /// ray.
    pub depth: f32,
}
impl Entered {
    pub fn new(
        segments: impl rt::Into<u32>,
        point: impl rt::Into<rt::Vec3<f32>>,
        uv: impl rt::Into<rt::Vec2<f32>>,
        tangent: impl rt::Into<rt::Vec3<f32>>,
        bitangent: impl rt::Into<rt::Vec3<f32>>,
        normal: impl rt::Into<rt::Vec3<f32>>,
        metric: impl rt::Into<rt::Vec4<f32>>,
        level: impl rt::Into<u32>,
        facing: impl rt::Into<rt::Vec3<f32>>,
        span: impl rt::Into<rt::Vec2<f32>>,
        of_surface: impl rt::Into<rt::Vec4<f32>>,
        footprint: impl rt::Into<f32>,
        fade: impl rt::Into<f32>,
        depth: impl rt::Into<f32>,
    ) -> Self {
        Self { segments: rt::into(segments), point: rt::into(point), uv: rt::into(uv), tangent: rt::into(tangent), bitangent: rt::into(bitangent), normal: rt::into(normal), metric: rt::into(metric), level: rt::into(level), facing: rt::into(facing), span: rt::into(span), of_surface: rt::into(of_surface), footprint: rt::into(footprint), fade: rt::into(fade), depth: rt::into(depth) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A place on a face of the cube, from -1 to 1 from edge to edge.
pub struct FacePlace {
    pub face: i32,
    pub place: rt::Vec2<f32>,
}
impl FacePlace {
    pub fn new(
        face: impl rt::Into<i32>,
        place: impl rt::Into<rt::Vec2<f32>>,
    ) -> Self {
        Self { face: rt::into(face), place: rt::into(place) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The end of a path. `uv` is not derived from t: offset limiting lands beside the ray.
pub struct Hit {
    pub found: u32,
    pub exhausted: u32,
    pub uv: rt::Vec2<f32>,
    pub height: f32,
    pub t: f32,
    /// Reads, steps and bytes of the search and the refinement.
    pub cost: rt::Vec3<u32>,
}
impl Hit {
    pub fn new(
        found: impl rt::Into<u32>,
        exhausted: impl rt::Into<u32>,
        uv: impl rt::Into<rt::Vec2<f32>>,
        height: impl rt::Into<f32>,
        t: impl rt::Into<f32>,
        cost: impl rt::Into<rt::Vec3<u32>>,
    ) -> Self {
        Self { found: rt::into(found), exhausted: rt::into(exhausted), uv: rt::into(uv), height: rt::into(height), t: rt::into(t), cost: rt::into(cost) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The first hit of a pixel's ray with a triangle's relief.
pub struct FirstHit {
    pub hit: Hit,
    /// The number of its segment.
    pub segment: u32,
    /// Orders the hits of a pixel's ray: the greater, the nearer. From 0, infinitely far away, to 1
    /// at the eye.
    pub key: f32,
}
impl FirstHit {
    pub fn new(
        hit: impl rt::Into<Hit>,
        segment: impl rt::Into<u32>,
        key: impl rt::Into<f32>,
    ) -> Self {
        Self { hit: rt::into(hit), segment: rt::into(segment), key: rt::into(key) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// Factors of four terms, each for four texels.
pub struct FourTerms {
    pub first: rt::Vec4<f32>,
    pub second: rt::Vec4<f32>,
    pub third: rt::Vec4<f32>,
    pub fourth: rt::Vec4<f32>,
}
impl FourTerms {
    pub fn new(
        first: impl rt::Into<rt::Vec4<f32>>,
        second: impl rt::Into<rt::Vec4<f32>>,
        third: impl rt::Into<rt::Vec4<f32>>,
        fourth: impl rt::Into<rt::Vec4<f32>>,
    ) -> Self {
        Self { first: rt::into(first), second: rt::into(second), third: rt::into(third), fourth: rt::into(fourth) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A light: infinitely far away, or at a point.
pub struct Light {
    /// Direction toward the light (w = 0), or its position (w = 1).
    pub place: rt::Vec4<f32>,
    /// Linear RGB: irradiance of a directional light, intensity of a point light. The fourth part is
    /// the size of the light's disc: the tangent of half its angular diameter for a directional
    /// light, its radius in metres for a point light.
    pub color: rt::Vec4<f32>,
    /// The first of the light's shadow maps among the frame's views, and their number.
    pub first_view: u32,
    pub views: u32,
}
impl Light {
    pub fn new(
        place: impl rt::Into<rt::Vec4<f32>>,
        color: impl rt::Into<rt::Vec4<f32>>,
        first_view: impl rt::Into<u32>,
        views: impl rt::Into<u32>,
    ) -> Self {
        Self { place: rt::into(place), color: rt::into(color), first_view: rt::into(first_view), views: rt::into(views) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A shadow map's camera: square, with parallel rays, or with rays from a point.
pub struct LightView {
    /// Rows that give column and row in texels, and metres along the view axis, of a point of the
    /// world. For rays from a point, divide column and row by the latter.
    pub column: rt::Vec4<f32>,
    pub row: rt::Vec4<f32>,
    pub depth: rt::Vec4<f32>,
    /// Origin of the ray through the upper left corner; for rays from a point its direction. Then
    /// its change per texel to the right and downward, and the origin of rays from a point.
    pub corner: rt::Vec4<f32>,
    pub across: rt::Vec4<f32>,
    pub along: rt::Vec4<f32>,
    pub eye: rt::Vec4<f32>,
    /// See `Frame`.
    pub near: f32,
    /// Width of a texel in metres; at a distance of 1 m for rays from a point.
    pub texel_m: f32,
    /// 1 if all rays begin in one point.
    pub from_point: u32,
    /// Texels of a side.
    pub size: u32,
}
impl LightView {
    pub fn new(
        column: impl rt::Into<rt::Vec4<f32>>,
        row: impl rt::Into<rt::Vec4<f32>>,
        depth: impl rt::Into<rt::Vec4<f32>>,
        corner: impl rt::Into<rt::Vec4<f32>>,
        across: impl rt::Into<rt::Vec4<f32>>,
        along: impl rt::Into<rt::Vec4<f32>>,
        eye: impl rt::Into<rt::Vec4<f32>>,
        near: impl rt::Into<f32>,
        texel_m: impl rt::Into<f32>,
        from_point: impl rt::Into<u32>,
        size: impl rt::Into<u32>,
    ) -> Self {
        Self { column: rt::into(column), row: rt::into(row), depth: rt::into(depth), corner: rt::into(corner), across: rt::into(across), along: rt::into(along), eye: rt::into(eye), near: rt::into(near), texel_m: rt::into(texel_m), from_point: rt::into(from_point), size: rt::into(size) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// Data that changes from frame to frame.
pub struct Frame {
    /// The columns of the matrix from the world to clip space.
    pub view_projection: [rt::Vec4<f32>; 4],
    /// Origin of the ray through the picture's top-left corner, and its change per pixel to the
    /// right and downward. The change is zero if all rays begin in one eye.
    pub eye: rt::Vec4<f32>,
    pub eye_right: rt::Vec4<f32>,
    pub eye_down: rt::Vec4<f32>,
    /// Unit view axis.
    pub forward: rt::Vec4<f32>,
    /// The direction of that ray, and its change per pixel; the component along the view axis is 1.
    pub corner: rt::Vec4<f32>,
    pub right: rt::Vec4<f32>,
    pub down: rt::Vec4<f32>,
    pub ambient: rt::Vec4<f32>,
    /// The part of a pixel's width that a sample stands for.
    pub sample_width: f32,
    /// Depth in metres; nearer hits are ordered less finely than farther ones.
    pub near: f32,
    /// The depth buffer's value for a depth d is x + y / d + z d.
    pub clip: rt::Vec4<f32>,
    /// Linear RGB of the background, at the picture's upper and lower edge. If the fourth part is
    /// above 0, the environment map is seen there instead, times that part.
    pub background: rt::Vec4<f32>,
    pub background_below: rt::Vec4<f32>,
    pub lights: [Light; 8],
    pub light_count: u32,
    /// The shadow maps' cameras.
    pub light_views: [LightView; 48],
}
impl Frame {
    pub fn new(
        view_projection: impl rt::Into<[rt::Vec4<f32>; 4]>,
        eye: impl rt::Into<rt::Vec4<f32>>,
        eye_right: impl rt::Into<rt::Vec4<f32>>,
        eye_down: impl rt::Into<rt::Vec4<f32>>,
        forward: impl rt::Into<rt::Vec4<f32>>,
        corner: impl rt::Into<rt::Vec4<f32>>,
        right: impl rt::Into<rt::Vec4<f32>>,
        down: impl rt::Into<rt::Vec4<f32>>,
        ambient: impl rt::Into<rt::Vec4<f32>>,
        sample_width: impl rt::Into<f32>,
        near: impl rt::Into<f32>,
        clip: impl rt::Into<rt::Vec4<f32>>,
        background: impl rt::Into<rt::Vec4<f32>>,
        background_below: impl rt::Into<rt::Vec4<f32>>,
        lights: impl rt::Into<[Light; 8]>,
        light_count: impl rt::Into<u32>,
        light_views: impl rt::Into<[LightView; 48]>,
    ) -> Self {
        Self { view_projection: rt::into(view_projection), eye: rt::into(eye), eye_right: rt::into(eye_right), eye_down: rt::into(eye_down), forward: rt::into(forward), corner: rt::into(corner), right: rt::into(right), down: rt::into(down), ambient: rt::into(ambient), sample_width: rt::into(sample_width), near: rt::into(near), clip: rt::into(clip), background: rt::into(background), background_below: rt::into(background_below), lights: rt::into(lights), light_count: rt::into(light_count), light_views: rt::into(light_views) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The numbers of the frames, and the weight of each: barycentric coordinates of the direction
/// between them.
pub struct Frames {
    pub numbers: rt::Vec3<u32>,
    pub weights: rt::Vec3<f32>,
}
impl Frames {
    pub fn new(
        numbers: impl rt::Into<rt::Vec3<u32>>,
        weights: impl rt::Into<rt::Vec3<f32>>,
    ) -> Self {
        Self { numbers: rt::into(numbers), weights: rt::into(weights) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// What a ray sees of a translucent surface on its way so far.
pub struct Gathered {
    /// Linear RGB: the light that is scattered toward the eye.
    pub light: rt::Vec3<f32>,
    /// The part of the light from behind that comes through.
    pub transmittance: f32,
    /// Metres along the view axis to the first place that is not empty; NEVER without one.
    pub entry: f32,
    /// Metres along the ray up to which its segments are gathered, and to something opaque.
    pub until_m: f32,
    pub reach_m: f32,
    /// The part of the light that is scattered where it was not yet looked at.
    pub pending: f32,
}
impl Gathered {
    pub fn new(
        light: impl rt::Into<rt::Vec3<f32>>,
        transmittance: impl rt::Into<f32>,
        entry: impl rt::Into<f32>,
        until_m: impl rt::Into<f32>,
        reach_m: impl rt::Into<f32>,
        pending: impl rt::Into<f32>,
    ) -> Self {
        Self { light: rt::into(light), transmittance: rt::into(transmittance), entry: rt::into(entry), until_m: rt::into(until_m), reach_m: rt::into(reach_m), pending: rt::into(pending) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// What a ray sees so far, and how much light is still to be looked at on this segment: its part, the sum
/// of its places, each times its part, and the cells in which it was scattered.
pub struct Gathering {
    pub seen: Gathered,
    pub part: f32,
    pub places: f32,
    pub cells: u32,
}
impl Gathering {
    pub fn new(
        seen: impl rt::Into<Gathered>,
        part: impl rt::Into<f32>,
        places: impl rt::Into<f32>,
        cells: impl rt::Into<u32>,
    ) -> Self {
        Self { seen: rt::into(seen), part: rt::into(part), places: rt::into(places), cells: rt::into(cells) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The path in cell units: position at t = 0 and change per unit of t.
pub struct Grid {
    pub origin: rt::Vec2<f32>,
    pub step: rt::Vec2<f32>,
}
impl Grid {
    pub fn new(
        origin: impl rt::Into<rt::Vec2<f32>>,
        step: impl rt::Into<rt::Vec2<f32>>,
    ) -> Self {
        Self { origin: rt::into(origin), step: rt::into(step) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// An image: the rows that give a point's texture coordinates, its height and its depth, by products
/// with (x, y, z, 1). Texture coordinates and height come multiplied by the depth, which is 1 for
/// parallel rays. Then its place among the images (first corner and extent, in texture coordinates
/// of all); the unit direction against which it looks; and whether it looks from an eye, that eye,
/// and the depth at which its view begins.
pub struct Image {
    pub u: rt::Vec4<f32>,
    pub v: rt::Vec4<f32>,
    pub height: rt::Vec4<f32>,
    pub depth: rt::Vec4<f32>,
    pub corner: rt::Vec2<f32>,
    pub extent: rt::Vec2<f32>,
    pub toward: rt::Vec3<f32>,
    pub has_eye: bool,
    pub eye: rt::Vec3<f32>,
    pub nearest: f32,
}
impl Image {
    pub fn new(
        u: impl rt::Into<rt::Vec4<f32>>,
        v: impl rt::Into<rt::Vec4<f32>>,
        height: impl rt::Into<rt::Vec4<f32>>,
        depth: impl rt::Into<rt::Vec4<f32>>,
        corner: impl rt::Into<rt::Vec2<f32>>,
        extent: impl rt::Into<rt::Vec2<f32>>,
        toward: impl rt::Into<rt::Vec3<f32>>,
        has_eye: impl rt::Into<bool>,
        eye: impl rt::Into<rt::Vec3<f32>>,
        nearest: impl rt::Into<f32>,
    ) -> Self {
        Self { u: rt::into(u), v: rt::into(v), height: rt::into(height), depth: rt::into(depth), corner: rt::into(corner), extent: rt::into(extent), toward: rt::into(toward), has_eye: rt::into(has_eye), eye: rt::into(eye), nearest: rt::into(nearest) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A point of a surface in a light's view, and the square around it whose texels count.
pub struct InView {
    pub number: u32,
    pub point: rt::Vec3<f32>,
    pub normal: rt::Vec3<f32>,
    pub low: rt::Vec2<f32>,
    pub high: rt::Vec2<f32>,
    /// The least and the greatest depth of planes.
    pub least_depth: f32,
    pub most_depth: f32,
}
impl InView {
    pub fn new(
        number: impl rt::Into<u32>,
        point: impl rt::Into<rt::Vec3<f32>>,
        normal: impl rt::Into<rt::Vec3<f32>>,
        low: impl rt::Into<rt::Vec2<f32>>,
        high: impl rt::Into<rt::Vec2<f32>>,
        least_depth: impl rt::Into<f32>,
        most_depth: impl rt::Into<f32>,
    ) -> Self {
        Self { number: rt::into(number), point: rt::into(point), normal: rt::into(normal), low: rt::into(low), high: rt::into(high), least_depth: rt::into(least_depth), most_depth: rt::into(most_depth) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// What the pairs so far make: a way and its weight.
pub struct JoinedViews {
    pub first: rt::Vec2<f32>,
    pub low: rt::Vec2<f32>,
    pub high: rt::Vec2<f32>,
}
impl JoinedViews {
    pub fn new(
        first: impl rt::Into<rt::Vec2<f32>>,
        low: impl rt::Into<rt::Vec2<f32>>,
        high: impl rt::Into<rt::Vec2<f32>>,
    ) -> Self {
        Self { first: rt::into(first), low: rt::into(low), high: rt::into(high) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The two levels of a map between which a footprint lies.
pub struct Levels {
    /// The finer one.
    pub fine: u32,
    /// The weight of the next level, below 1.
    pub part: f32,
}
impl Levels {
    pub fn new(
        fine: impl rt::Into<u32>,
        part: impl rt::Into<f32>,
    ) -> Self {
        Self { fine: rt::into(fine), part: rt::into(part) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A ray segment in texture space: (u, v) is linear in t, the normalised height is h.x + h.y t + h.z
/// t². t is in metres along the ray, 0 at the entry (but see `bend`).
pub struct Path {
    pub uv: rt::Vec2<f32>,
    pub duv: rt::Vec2<f32>,
    pub h: rt::Vec3<f32>,
    pub exit: f32,
    /// The parameter t where the ray crosses the base surface. For an object's image: the image's
    /// number.
    pub base: f32,
    /// T·T, T·B, B·B in square metres per tile, and the displacement scale in metres.
    pub metric: rt::Vec4<f32>,
    /// Purpose of the ray: RAY_VIEW or RAY_SHADOW.
    pub ray: u32,
    /// The level of detail of the maps that are read.
    pub level: u32,
    /// Metres along the pixel's ray, from its origin, to the entry.
    pub start: f32,
    /// The part of the ray's whole way through the relief that this segment is. Searches that spread
    /// a number of steps over the whole way take that part of them.
    pub share: f32,
    /// Curvature of the parameter for an image with perspective: metres along the ray are t / (1 -
    /// bend t). In such an image rays are straight, and farther things look smaller. 0 otherwise.
    pub bend: f32,
}
impl Path {
    pub fn new(
        uv: impl rt::Into<rt::Vec2<f32>>,
        duv: impl rt::Into<rt::Vec2<f32>>,
        h: impl rt::Into<rt::Vec3<f32>>,
        exit: impl rt::Into<f32>,
        base: impl rt::Into<f32>,
        metric: impl rt::Into<rt::Vec4<f32>>,
        ray: impl rt::Into<u32>,
        level: impl rt::Into<u32>,
        start: impl rt::Into<f32>,
        share: impl rt::Into<f32>,
        bend: impl rt::Into<f32>,
    ) -> Self {
        Self { uv: rt::into(uv), duv: rt::into(duv), h: rt::into(h), exit: rt::into(exit), base: rt::into(base), metric: rt::into(metric), ray: rt::into(ray), level: rt::into(level), start: rt::into(start), share: rt::into(share), bend: rt::into(bend) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A ray from a hit toward a light.
pub struct LightRay {
    /// One of LIGHT_RAY_*.
    pub state: u32,
    /// The path to search, for an open ray.
    pub path: Path,
}
impl LightRay {
    pub fn new(
        state: impl rt::Into<u32>,
        path: impl rt::Into<Path>,
    ) -> Self {
        Self { state: rt::into(state), path: rt::into(path) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// Settings of a baked map.
pub struct MapSettings {
    /// 1 where its texels are codes of 8 bits: the value of code c is low + step c.
    pub coded: u32,
    /// Layers of each level.
    pub layers: u32,
    /// Bytes of a texel.
    pub texel_bytes: u32,
    /// The level of the height map whose place and size the map's finest level has.
    pub first_level: u32,
    pub low: rt::Vec4<f32>,
    pub step: rt::Vec4<f32>,
    /// Metres of a tile along u and v in the metric that it was baked in.
    pub tile_m: rt::Vec2<f32>,
}
impl MapSettings {
    pub fn new(
        coded: impl rt::Into<u32>,
        layers: impl rt::Into<u32>,
        texel_bytes: impl rt::Into<u32>,
        first_level: impl rt::Into<u32>,
        low: impl rt::Into<rt::Vec4<f32>>,
        step: impl rt::Into<rt::Vec4<f32>>,
        tile_m: impl rt::Into<rt::Vec2<f32>>,
    ) -> Self {
        Self { coded: rt::into(coded), layers: rt::into(layers), texel_bytes: rt::into(texel_bytes), first_level: rt::into(first_level), low: rt::into(low), step: rt::into(step), tile_m: rt::into(tile_m) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The material at a hit, read once for all lights. All colours are linear RGB.
pub struct Material {
    /// The part of the light that is scattered in all directions, and the part that passes through the
    /// surface.
    pub diffuse: rt::Vec3<f32>,
    pub transmitted: rt::Vec3<f32>,
    /// The highlight's colour, or the part of the light that is reflected along the normal.
    pub specular: rt::Vec3<f32>,
    /// The part of a light that is the same from all around that leaves toward the eye.
    pub around: rt::Vec3<f32>,
    /// Light that the surface gives by itself.
    pub emission: rt::Vec3<f32>,
    /// The part of the light from all around that arrives, by the material's map.
    pub occlusion: f32,
    /// The roughness in the footprint; its square alpha, the width of the facets' distribution; and the
    /// square of alpha.
    pub roughness: f32,
    pub alpha: f32,
    pub squared_alpha: f32,
    /// The cosine between the normal and the view, at least a little, and its share in the part of facets
    /// that others hide.
    pub upright: f32,
    pub masking: f32,
    /// The light that facets reflect more than once, as a part of the light reflected once by facets of
    /// specular colour 1.
    pub again: f32,
}
impl Material {
    pub fn new(
        diffuse: impl rt::Into<rt::Vec3<f32>>,
        transmitted: impl rt::Into<rt::Vec3<f32>>,
        specular: impl rt::Into<rt::Vec3<f32>>,
        around: impl rt::Into<rt::Vec3<f32>>,
        emission: impl rt::Into<rt::Vec3<f32>>,
        occlusion: impl rt::Into<f32>,
        roughness: impl rt::Into<f32>,
        alpha: impl rt::Into<f32>,
        squared_alpha: impl rt::Into<f32>,
        upright: impl rt::Into<f32>,
        masking: impl rt::Into<f32>,
        again: impl rt::Into<f32>,
    ) -> Self {
        Self { diffuse: rt::into(diffuse), transmitted: rt::into(transmitted), specular: rt::into(specular), around: rt::into(around), emission: rt::into(emission), occlusion: rt::into(occlusion), roughness: rt::into(roughness), alpha: rt::into(alpha), squared_alpha: rt::into(squared_alpha), upright: rt::into(upright), masking: rt::into(masking), again: rt::into(again) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The mirrored part of the light from all around.
pub struct Mirrored {
    /// The part of the light that is reflected.
    pub part: rt::Vec3<f32>,
    /// The deviation of facets from the normal, in radians.
    pub lean: f32,
    /// The deviations of two lobes around the mirrored view, and the weight of the second.
    pub lobes: rt::Vec2<f32>,
    pub second: f32,
    /// How far the lobes are turned from the mirrored view, 0, to the normal, 1.
    pub turn: f32,
}
impl Mirrored {
    pub fn new(
        part: impl rt::Into<rt::Vec3<f32>>,
        lean: impl rt::Into<f32>,
        lobes: impl rt::Into<rt::Vec2<f32>>,
        second: impl rt::Into<f32>,
        turn: impl rt::Into<f32>,
    ) -> Self {
        Self { part: rt::into(part), lean: rt::into(lean), lobes: rt::into(lobes), second: rt::into(second), turn: rt::into(turn) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The first triangle on a way in a tile.
pub struct MotifHit {
    /// NEVER without one.
    pub t: f32,
    pub cost: rt::Vec3<u32>,
}
impl MotifHit {
    pub fn new(
        t: impl rt::Into<f32>,
        cost: impl rt::Into<rt::Vec3<u32>>,
    ) -> Self {
        Self { t: rt::into(t), cost: rt::into(cost) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The motif at a place on it, along u, v and the height: the mean of the corners' normals, and the
/// triangle's own on the same side, of length 1.
pub struct MotifPoint {
    pub normal: rt::Vec3<f32>,
    pub facet: rt::Vec3<f32>,
}
impl MotifPoint {
    pub fn new(
        normal: impl rt::Into<rt::Vec3<f32>>,
        facet: impl rt::Into<rt::Vec3<f32>>,
    ) -> Self {
        Self { normal: rt::into(normal), facet: rt::into(facet) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A straight way in a tile, seen along its longest axis, which comes last. `shear` takes a place to the two
/// axes across the way; its third part is the parameter of one along the axis.
pub struct MotifRay {
    pub origin: rt::Vec3<f32>,
    pub inverse: rt::Vec3<f32>,
    pub axis: u32,
    pub shear: rt::Vec3<f32>,
}
impl MotifRay {
    pub fn new(
        origin: impl rt::Into<rt::Vec3<f32>>,
        inverse: impl rt::Into<rt::Vec3<f32>>,
        axis: impl rt::Into<u32>,
        shear: impl rt::Into<rt::Vec3<f32>>,
    ) -> Self {
        Self { origin: rt::into(origin), inverse: rt::into(inverse), axis: rt::into(axis), shear: rt::into(shear) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A triangle by its first texel, and the squared distance between a place and it.
pub struct NearTriangle {
    pub triangle: u32,
    pub apart: f32,
}
impl NearTriangle {
    pub fn new(
        triangle: impl rt::Into<u32>,
        apart: impl rt::Into<f32>,
    ) -> Self {
        Self { triangle: rt::into(triangle), apart: rt::into(apart) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The two layers that the normal map has from level 1 on.
pub struct NormalLayers {
    pub first: rt::Vec4<f32>,
    pub second: rt::Vec4<f32>,
}
impl NormalLayers {
    pub fn new(
        first: impl rt::Into<rt::Vec4<f32>>,
        second: impl rt::Into<rt::Vec4<f32>>,
    ) -> Self {
        Self { first: rt::into(first), second: rt::into(second) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The means of the normals n and the slopes s in an area, in tangent space. n is (-sx, -sy, 1) nz.
pub struct Normals {
    /// nx, ny, nz, sx
    pub first: rt::Vec4<f32>,
    /// sx² nz, sx sy nz, sy² nz, sy
    pub second: rt::Vec4<f32>,
}
impl Normals {
    pub fn new(
        first: impl rt::Into<rt::Vec4<f32>>,
        second: impl rt::Into<rt::Vec4<f32>>,
    ) -> Self {
        Self { first: rt::into(first), second: rt::into(second) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A point as an image sees it: the texture coordinates, the value that is compared with the map,
/// and the map.
pub struct OnImage {
    pub uv: rt::Vec2<f32>,
    pub height: f32,
    pub map: f32,
    /// Whether it is in the space that the image looks at.
    pub is_inside: bool,
}
impl OnImage {
    pub fn new(
        uv: impl rt::Into<rt::Vec2<f32>>,
        height: impl rt::Into<f32>,
        map: impl rt::Into<f32>,
        is_inside: impl rt::Into<bool>,
    ) -> Self {
        Self { uv: rt::into(uv), height: rt::into(height), map: rt::into(map), is_inside: rt::into(is_inside) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A point of a slice in the image whose surface is nearest to it.
pub struct OnSlice {
    /// Whether it is in the solids of all images.
    pub passes: bool,
    pub number: u32,
    pub nearest: OnImage,
    /// Height of that surface above the point.
    pub over: f32,
}
impl OnSlice {
    pub fn new(
        passes: impl rt::Into<bool>,
        number: impl rt::Into<u32>,
        nearest: impl rt::Into<OnImage>,
        over: impl rt::Into<f32>,
    ) -> Self {
        Self { passes: rt::into(passes), number: rt::into(number), nearest: rt::into(nearest), over: rt::into(over) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A path's axes, each from 0 to 1.
pub struct PathAxes {
    /// 1 if the path comes in at the top, or would have come in there before it begins.
    pub comes_in: u32,
    /// Azimuth in turns, elevation from upright to level, and the place of the bend: ½ for a straight path.
    pub turn: f32,
    pub elevation: f32,
    pub bend: f32,
    /// The parameter at height 1, not above 0, and its change on the whole way to height 0, or back to height 1.
    pub start: f32,
    pub whole: f32,
    /// The part F of the way per unit of t: the height's fall at the top.
    pub fall: f32,
}
impl PathAxes {
    pub fn new(
        comes_in: impl rt::Into<u32>,
        turn: impl rt::Into<f32>,
        elevation: impl rt::Into<f32>,
        bend: impl rt::Into<f32>,
        start: impl rt::Into<f32>,
        whole: impl rt::Into<f32>,
        fall: impl rt::Into<f32>,
    ) -> Self {
        Self { comes_in: rt::into(comes_in), turn: rt::into(turn), elevation: rt::into(elevation), bend: rt::into(bend), start: rt::into(start), whole: rt::into(whole), fall: rt::into(fall) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The space that the relief of a base triangle may fill, between its corners moved along their
/// normals.
pub struct Shell {
    /// The least and the greatest height under the triangle.
    pub heights: rt::Vec2<f32>,
    /// The places of the corners, 0 to 2, in an order that all triangles at an edge agree on: two
    /// bits for each, the first lowest. SHELL_FOLDED is added if the shell overlaps itself.
    pub order: u32,
    /// The height of the smooth base above the triangle, in metres. Each number belongs to the edge
    /// opposite to a corner, in that order, and is multiplied by the weights of the edge's ends.
    pub lift: rt::Vec3<f32>,
}
impl Shell {
    pub fn new(
        heights: impl rt::Into<rt::Vec2<f32>>,
        order: impl rt::Into<u32>,
        lift: impl rt::Into<rt::Vec3<f32>>,
    ) -> Self {
        Self { heights: rt::into(heights), order: rt::into(order), lift: rt::into(lift) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A pixel's ray and the base triangle that it meets. The direction's component along the view axis is 1.
pub struct PixelIn {
    pub origin: rt::Vec3<f32>,
    pub direction: rt::Vec3<f32>,
    /// -1 turns the triangle over: a back face seen two-sided.
    pub side: f32,
    pub a: Corner,
    pub b: Corner,
    pub c: Corner,
    pub shell: Shell,
}
impl PixelIn {
    pub fn new(
        origin: impl rt::Into<rt::Vec3<f32>>,
        direction: impl rt::Into<rt::Vec3<f32>>,
        side: impl rt::Into<f32>,
        a: impl rt::Into<Corner>,
        b: impl rt::Into<Corner>,
        c: impl rt::Into<Corner>,
        shell: impl rt::Into<Shell>,
    ) -> Self {
        Self { origin: rt::into(origin), direction: rt::into(direction), side: rt::into(side), a: rt::into(a), b: rt::into(b), c: rt::into(c), shell: rt::into(shell) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The result for a pixel. Zeros if `hit` is 0.
pub struct PixelOut {
    /// Linear RGB, and 1.
    pub color: rt::Vec4<f32>,
    /// 1 if the pixel shows the surface.
    pub hit: u32,
    /// 1 if the search ran out of steps: the hit is the last point that it reached.
    pub exhausted: u32,
    /// Texture coordinates and normalised height of the hit, and its parameter on the path.
    pub uv: rt::Vec2<f32>,
    pub height: f32,
    /// The hit in the world, and the displaced surface's unit normal there.
    pub position: rt::Vec3<f32>,
    pub normal: rt::Vec3<f32>,
    /// Metres from the eye along the view axis.
    pub depth: f32,
    pub t: f32,
    /// Column and row of the first texel of the dual cell that the hit lies in.
    pub cell: rt::Vec2<i32>,
    /// Reads of the search and the refinement: of a cell, a place between texels, a texel or a node
    /// each.
    pub reads: u32,
    /// Steps of the search and the refinement.
    pub steps: u32,
    /// Bytes that the reads fetched, caches aside.
    pub bytes: u32,
    /// The part of the first light that arrives, from 0 to 1, whichever way the surface faces; 0 without
    /// lights.
    pub lit: f32,
    /// The level of detail that was traced.
    pub level: u32,
    /// The hit's value in a depth buffer of the frame's clip space, from 0 to 1.
    pub z: f32,
    /// The surface's number in the scene.
    pub surface: u32,
    /// The part of the hit's light that comes through the translucent surfaces before it.
    pub transmittance: f32,
}
impl PixelOut {
    pub fn new(
        color: impl rt::Into<rt::Vec4<f32>>,
        hit: impl rt::Into<u32>,
        exhausted: impl rt::Into<u32>,
        uv: impl rt::Into<rt::Vec2<f32>>,
        height: impl rt::Into<f32>,
        position: impl rt::Into<rt::Vec3<f32>>,
        normal: impl rt::Into<rt::Vec3<f32>>,
        depth: impl rt::Into<f32>,
        t: impl rt::Into<f32>,
        cell: impl rt::Into<rt::Vec2<i32>>,
        reads: impl rt::Into<u32>,
        steps: impl rt::Into<u32>,
        bytes: impl rt::Into<u32>,
        lit: impl rt::Into<f32>,
        level: impl rt::Into<u32>,
        z: impl rt::Into<f32>,
        surface: impl rt::Into<u32>,
        transmittance: impl rt::Into<f32>,
    ) -> Self {
        Self { color: rt::into(color), hit: rt::into(hit), exhausted: rt::into(exhausted), uv: rt::into(uv), height: rt::into(height), position: rt::into(position), normal: rt::into(normal), depth: rt::into(depth), t: rt::into(t), cell: rt::into(cell), reads: rt::into(reads), steps: rt::into(steps), bytes: rt::into(bytes), lit: rt::into(lit), level: rt::into(level), z: rt::into(z), surface: rt::into(surface), transmittance: rt::into(transmittance) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A shell, seen from the place of the ray that is nearest to the triangle: corners, their normals,
/// and the coefficients of the smooth base.
pub struct Prism {
    pub p0_: rt::Vec3<f32>,
    pub p1_: rt::Vec3<f32>,
    pub p2_: rt::Vec3<f32>,
    pub n0_: rt::Vec3<f32>,
    pub n1_: rt::Vec3<f32>,
    pub n2_: rt::Vec3<f32>,
    pub lift: rt::Vec3<f32>,
}
impl Prism {
    pub fn new(
        p0_: impl rt::Into<rt::Vec3<f32>>,
        p1_: impl rt::Into<rt::Vec3<f32>>,
        p2_: impl rt::Into<rt::Vec3<f32>>,
        n0_: impl rt::Into<rt::Vec3<f32>>,
        n1_: impl rt::Into<rt::Vec3<f32>>,
        n2_: impl rt::Into<rt::Vec3<f32>>,
        lift: impl rt::Into<rt::Vec3<f32>>,
    ) -> Self {
        Self { p0_: rt::into(p0_), p1_: rt::into(p1_), p2_: rt::into(p2_), n0_: rt::into(n0_), n1_: rt::into(n1_), n2_: rt::into(n2_), lift: rt::into(lift) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// a + b x + c x² + d x³ + e x⁴
pub struct Quartic {
    pub a: f32,
    pub b: f32,
    pub c: f32,
    pub d: f32,
    pub e: f32,
}
impl Quartic {
    pub fn new(
        a: impl rt::Into<f32>,
        b: impl rt::Into<f32>,
        c: impl rt::Into<f32>,
        d: impl rt::Into<f32>,
        e: impl rt::Into<f32>,
    ) -> Self {
        Self { a: rt::into(a), b: rt::into(b), c: rt::into(c), d: rt::into(d), e: rt::into(e) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The first root in a cell, and the gap where the path enters it.
pub struct RootInCell {
    pub root: f32,
    pub gap: f32,
}
impl RootInCell {
    pub fn new(
        root: impl rt::Into<f32>,
        gap: impl rt::Into<f32>,
    ) -> Self {
        Self { root: rt::into(root), gap: rt::into(gap) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The result of a search. `status` is one of FOUND_*. `near` and `far` are parameters of the path,
/// and the gaps are its heights above the surface there.
pub struct SearchResult {
    pub status: u32,
    pub near: f32,
    pub far: f32,
    pub near_gap: f32,
    pub far_gap: f32,
    /// Reads, steps and bytes of the search.
    pub cost: rt::Vec3<u32>,
}
impl SearchResult {
    pub fn new(
        status: impl rt::Into<u32>,
        near: impl rt::Into<f32>,
        far: impl rt::Into<f32>,
        near_gap: impl rt::Into<f32>,
        far_gap: impl rt::Into<f32>,
        cost: impl rt::Into<rt::Vec3<u32>>,
    ) -> Self {
        Self { status: rt::into(status), near: rt::into(near), far: rt::into(far), near_gap: rt::into(near_gap), far_gap: rt::into(far_gap), cost: rt::into(cost) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// Means of the visible normals, in tangent space, and of the products of their parts.
pub struct SeenTable {
    pub mean: rt::Vec3<f32>,
    /// x², y², z²
    pub squares: rt::Vec3<f32>,
    /// xy, xz, yz
    pub products: rt::Vec3<f32>,
}
impl SeenTable {
    pub fn new(
        mean: impl rt::Into<rt::Vec3<f32>>,
        squares: impl rt::Into<rt::Vec3<f32>>,
        products: impl rt::Into<rt::Vec3<f32>>,
    ) -> Self {
        Self { mean: rt::into(mean), squares: rt::into(squares), products: rt::into(products) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The normals within a footprint as an eye sees them.
pub struct SeenNormals {
    /// The direction of the mean normal, in the world.
    pub normal: rt::Vec3<f32>,
    /// The length of the mean normal: 1 where all are the same.
    pub length: f32,
    /// 1 where the normals differ. The members below are known only then, in tangent space.
    pub differ: u32,
    /// The normal in the middle and its slope, and the change of normals and slopes in a deviation
    /// along two axes. The others are APART of these changes beside it, two on each axis.
    pub middle: rt::Vec3<f32>,
    pub along: rt::Vec3<f32>,
    pub across: rt::Vec3<f32>,
    pub slope: rt::Vec2<f32>,
    pub slope_along: rt::Vec2<f32>,
    pub slope_across: rt::Vec2<f32>,
    /// The squared cosine between the base's normal and the view.
    pub upright: f32,
    /// The visible part of a slope for each of the five, relative to all of them.
    pub middle_seen: f32,
    pub others_seen: rt::Vec4<f32>,
    /// The weight of the table of directions in place of the five normals, and the table's values.
    pub table_part: f32,
    pub table: SeenTable,
}
impl SeenNormals {
    pub fn new(
        normal: impl rt::Into<rt::Vec3<f32>>,
        length: impl rt::Into<f32>,
        differ: impl rt::Into<u32>,
        middle: impl rt::Into<rt::Vec3<f32>>,
        along: impl rt::Into<rt::Vec3<f32>>,
        across: impl rt::Into<rt::Vec3<f32>>,
        slope: impl rt::Into<rt::Vec2<f32>>,
        slope_along: impl rt::Into<rt::Vec2<f32>>,
        slope_across: impl rt::Into<rt::Vec2<f32>>,
        upright: impl rt::Into<f32>,
        middle_seen: impl rt::Into<f32>,
        others_seen: impl rt::Into<rt::Vec4<f32>>,
        table_part: impl rt::Into<f32>,
        table: impl rt::Into<SeenTable>,
    ) -> Self {
        Self { normal: rt::into(normal), length: rt::into(length), differ: rt::into(differ), middle: rt::into(middle), along: rt::into(along), across: rt::into(across), slope: rt::into(slope), slope_along: rt::into(slope_along), slope_across: rt::into(slope_across), upright: rt::into(upright), middle_seen: rt::into(middle_seen), others_seen: rt::into(others_seen), table_part: rt::into(table_part), table: rt::into(table) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A place between two levels of detail: the texels around it in either.
pub struct SeenPlace {
    pub fine: Around,
    pub coarse: Around,
    pub levels: Levels,
}
impl SeenPlace {
    pub fn new(
        fine: impl rt::Into<Around>,
        coarse: impl rt::Into<Around>,
        levels: impl rt::Into<Levels>,
    ) -> Self {
        Self { fine: rt::into(fine), coarse: rt::into(coarse), levels: rt::into(levels) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// One direction's values in a texel.
pub struct SeenTexel {
    /// x, y, z, x²
    pub first: rt::Vec4<f32>,
    /// xy, y², xz, yz
    pub second: rt::Vec4<f32>,
}
impl SeenTexel {
    pub fn new(
        first: impl rt::Into<rt::Vec4<f32>>,
        second: impl rt::Into<rt::Vec4<f32>>,
    ) -> Self {
        Self { first: rt::into(first), second: rt::into(second) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A point of a shell: weights of the corners, and the height.
pub struct ShellPoint {
    pub weights: rt::Vec3<f32>,
    pub height: f32,
}
impl ShellPoint {
    pub fn new(
        weights: impl rt::Into<rt::Vec3<f32>>,
        height: impl rt::Into<f32>,
    ) -> Self {
        Self { weights: rt::into(weights), height: rt::into(height) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// Settings of a surface: its maps, displacement, material and method.
pub struct SurfaceSettings {
    /// For each stage, in the order in which a pixel goes through them.
    pub choices: [Choice; 12],
    /// For each slot of baked maps.
    pub maps: [MapSettings; 8],
    /// Linear RGB. For `metallic-roughness`, the base colour, and the reflection of materials that
    /// are no metals.
    pub diffuse: rt::Vec4<f32>,
    pub specular: rt::Vec4<f32>,
    /// Light that the surface gives by itself, linear RGB.
    pub emission: rt::Vec4<f32>,
    /// Rows that turn texture coordinates (u, v) into the colour map's coordinates: x u + y v + z
    /// each.
    pub color_u: rt::Vec4<f32>,
    pub color_v: rt::Vec4<f32>,
    /// Columns and rows of the height map, the colour map, the normal map and the material map.
    pub height_size: rt::Vec2<u32>,
    pub color_size: rt::Vec2<u32>,
    pub normal_size: rt::Vec2<u32>,
    pub material_size: rt::Vec2<u32>,
    /// Levels of detail of each, at least 1. Normals derived from heights begin at level 1 of the
    /// height map, which is the finest level of the normal map.
    pub height_levels: u32,
    pub color_levels: u32,
    pub normal_levels: u32,
    pub material_levels: u32,
    /// Texels of the colour map, the normal map and the material map per texel of the height map.
    pub color_texels: f32,
    pub normal_texels: f32,
    pub material_texels: f32,
    /// Metres of a tile along u and v for which normals were derived.
    pub normal_tile_m: rt::Vec2<f32>,
    /// Wrap of the height map and the normal map, then of the colour map along both of its axes.
    pub wrap: u32,
    pub color_wrap_u: u32,
    pub color_wrap_v: u32,
    pub shininess: u32,
    /// Roughness and metalness, each from 0 to 1; factors on the material map's.
    pub roughness: f32,
    pub metallic: f32,
    /// 1 if the first layer of the material map is read: occlusion, roughness and metalness. 2 if
    /// the second one is: emission. 3 for both.
    pub has_material: u32,
    pub has_color: u32,
    pub has_normal: u32,
    /// 1 if hits in holes of the height map are misses; 2 if hits where the colour map's opacity is
    /// below the cut-off are; 3 for both.
    pub has_holes: u32,
    /// 1 if normals that are derived from heights are not taken across creases.
    pub has_creases: u32,
    /// 1 if the vertices of the triangles give the normals.
    pub has_vertex_normals: u32,
    /// 0 if the relief casts no shadows.
    pub has_shadows: u32,
    pub scale_m: f32,
    pub bias_m: f32,
    /// Metres along the normals at which heights 0 and 1 lie in shells. Shells always have a
    /// thickness.
    pub shell_m: rt::Vec2<f32>,
    /// The mean of the height map, if pixels have levels of detail.
    pub mean_height: f32,
    /// The part of the light that is refracted where it enters the surface, not scattered, and the index of
    /// refraction.
    pub transmission: f32,
    pub ior: f32,
    /// Number among the surfaces that are drawn: a surface of several materials is drawn as one for
    /// each.
    pub number: u32,
    /// Texels of a face's side in the finest level of the environment map, and its levels; at least
    /// 1 each.
    pub environment_side: u32,
    pub environment_levels: u32,
    /// Images of an object, and the number of the first ones among them that define the solid; 0 for
    /// a relief.
    pub images: u32,
    pub solids: u32,
    /// One of CELLS_*, and the difference of heights beyond which a cell of an image jumps.
    pub cells: u32,
    pub jump: f32,
    /// Columns, rows and slices of a volume, whose slices lie side by side in the height map, and the
    /// slices in a row of that map; zeros for heights.
    pub volume: rt::Vec4<u32>,
    /// Opacities of the colour map below this are holes.
    pub cutoff: f32,
    /// The surface's number among the translucent ones, and how many there are; zeros for opaque ones.
    pub translucent: rt::Vec2<u32>,
}
impl SurfaceSettings {
    pub fn new(
        choices: impl rt::Into<[Choice; 12]>,
        maps: impl rt::Into<[MapSettings; 8]>,
        diffuse: impl rt::Into<rt::Vec4<f32>>,
        specular: impl rt::Into<rt::Vec4<f32>>,
        emission: impl rt::Into<rt::Vec4<f32>>,
        color_u: impl rt::Into<rt::Vec4<f32>>,
        color_v: impl rt::Into<rt::Vec4<f32>>,
        height_size: impl rt::Into<rt::Vec2<u32>>,
        color_size: impl rt::Into<rt::Vec2<u32>>,
        normal_size: impl rt::Into<rt::Vec2<u32>>,
        material_size: impl rt::Into<rt::Vec2<u32>>,
        height_levels: impl rt::Into<u32>,
        color_levels: impl rt::Into<u32>,
        normal_levels: impl rt::Into<u32>,
        material_levels: impl rt::Into<u32>,
        color_texels: impl rt::Into<f32>,
        normal_texels: impl rt::Into<f32>,
        material_texels: impl rt::Into<f32>,
        normal_tile_m: impl rt::Into<rt::Vec2<f32>>,
        wrap: impl rt::Into<u32>,
        color_wrap_u: impl rt::Into<u32>,
        color_wrap_v: impl rt::Into<u32>,
        shininess: impl rt::Into<u32>,
        roughness: impl rt::Into<f32>,
        metallic: impl rt::Into<f32>,
        has_material: impl rt::Into<u32>,
        has_color: impl rt::Into<u32>,
        has_normal: impl rt::Into<u32>,
        has_holes: impl rt::Into<u32>,
        has_creases: impl rt::Into<u32>,
        has_vertex_normals: impl rt::Into<u32>,
        has_shadows: impl rt::Into<u32>,
        scale_m: impl rt::Into<f32>,
        bias_m: impl rt::Into<f32>,
        shell_m: impl rt::Into<rt::Vec2<f32>>,
        mean_height: impl rt::Into<f32>,
        transmission: impl rt::Into<f32>,
        ior: impl rt::Into<f32>,
        number: impl rt::Into<u32>,
        environment_side: impl rt::Into<u32>,
        environment_levels: impl rt::Into<u32>,
        images: impl rt::Into<u32>,
        solids: impl rt::Into<u32>,
        cells: impl rt::Into<u32>,
        jump: impl rt::Into<f32>,
        volume: impl rt::Into<rt::Vec4<u32>>,
        cutoff: impl rt::Into<f32>,
        translucent: impl rt::Into<rt::Vec2<u32>>,
    ) -> Self {
        Self { choices: rt::into(choices), maps: rt::into(maps), diffuse: rt::into(diffuse), specular: rt::into(specular), emission: rt::into(emission), color_u: rt::into(color_u), color_v: rt::into(color_v), height_size: rt::into(height_size), color_size: rt::into(color_size), normal_size: rt::into(normal_size), material_size: rt::into(material_size), height_levels: rt::into(height_levels), color_levels: rt::into(color_levels), normal_levels: rt::into(normal_levels), material_levels: rt::into(material_levels), color_texels: rt::into(color_texels), normal_texels: rt::into(normal_texels), material_texels: rt::into(material_texels), normal_tile_m: rt::into(normal_tile_m), wrap: rt::into(wrap), color_wrap_u: rt::into(color_wrap_u), color_wrap_v: rt::into(color_wrap_v), shininess: rt::into(shininess), roughness: rt::into(roughness), metallic: rt::into(metallic), has_material: rt::into(has_material), has_color: rt::into(has_color), has_normal: rt::into(has_normal), has_holes: rt::into(has_holes), has_creases: rt::into(has_creases), has_vertex_normals: rt::into(has_vertex_normals), has_shadows: rt::into(has_shadows), scale_m: rt::into(scale_m), bias_m: rt::into(bias_m), shell_m: rt::into(shell_m), mean_height: rt::into(mean_height), transmission: rt::into(transmission), ior: rt::into(ior), number: rt::into(number), environment_side: rt::into(environment_side), environment_levels: rt::into(environment_levels), images: rt::into(images), solids: rt::into(solids), cells: rt::into(cells), jump: rt::into(jump), volume: rt::into(volume), cutoff: rt::into(cutoff), translucent: rt::into(translucent) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A triangle as it is swept. Coordinates run along the sweep and across it. They count from the
/// first end of the primary edge, and the third corner lies above it.
pub struct Sweep {
    /// The ends of the primary edge and the third corner, as numbers of the triangle's corners.
    pub corners: rt::Vec3<u32>,
    /// The end of the primary edge; its first coordinate is the number of strips between columns, 0 where all
    /// corners lie in one voxel.
    pub end: rt::Vec2<i32>,
    /// The third corner.
    pub apex: rt::Vec2<i32>,
    /// Parts of the sides from the first end to the third corner, and from there to the other end.
    pub parts: rt::Vec2<i32>,
    /// 1 where pieces are turned over, as seen from the triangle.
    pub is_turned: u32,
}
impl Sweep {
    pub fn new(
        corners: impl rt::Into<rt::Vec3<u32>>,
        end: impl rt::Into<rt::Vec2<i32>>,
        apex: impl rt::Into<rt::Vec2<i32>>,
        parts: impl rt::Into<rt::Vec2<i32>>,
        is_turned: impl rt::Into<u32>,
    ) -> Self {
        Self { corners: rt::into(corners), end: rt::into(end), apex: rt::into(apex), parts: rt::into(parts), is_turned: rt::into(is_turned) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A column of points: the point of the primary edge, the points inside from below, the points of
/// the top along the sweep.
pub struct SweptColumn {
    pub column: i32,
    /// The lowest point inside, their number, and the number of the first.
    pub inside: i32,
    pub inner: i32,
    pub first: u32,
    /// The first point of the top, their number, and their partner.
    pub from_top: i32,
    pub of_top: i32,
    pub top: u32,
}
impl SweptColumn {
    pub fn new(
        column: impl rt::Into<i32>,
        inside: impl rt::Into<i32>,
        inner: impl rt::Into<i32>,
        first: impl rt::Into<u32>,
        from_top: impl rt::Into<i32>,
        of_top: impl rt::Into<i32>,
        top: impl rt::Into<u32>,
    ) -> Self {
        Self { column: rt::into(column), inside: rt::into(inside), inner: rt::into(inner), first: rt::into(first), from_top: rt::into(from_top), of_top: rt::into(of_top), top: rt::into(top) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// Some of a column's points, from below.
pub struct SweptChain {
    pub column: SweptColumn,
    /// The partner of these points.
    pub way: u32,
    pub count: i32,
}
impl SweptChain {
    pub fn new(
        column: impl rt::Into<SweptColumn>,
        way: impl rt::Into<u32>,
        count: impl rt::Into<i32>,
    ) -> Self {
        Self { column: rt::into(column), way: rt::into(way), count: rt::into(count) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A point of a triangle.
pub struct SweptPoint {
    /// The triangle's side that the point lies on, and the number of parts before it there, fewer
    /// than the side has; or `INSIDE`, and its number among the points inside.
    pub side: u32,
    pub at: u32,
    /// The point is (x / w, y / w).
    pub x: i32,
    pub y: i32,
    pub w: i32,
    /// The sides that the point lies on.
    pub sides: u32,
}
impl SweptPoint {
    pub fn new(
        side: impl rt::Into<u32>,
        at: impl rt::Into<u32>,
        x: impl rt::Into<i32>,
        y: impl rt::Into<i32>,
        w: impl rt::Into<i32>,
        sides: impl rt::Into<u32>,
    ) -> Self {
        Self { side: rt::into(side), at: rt::into(at), x: rt::into(x), y: rt::into(y), w: rt::into(w), sides: rt::into(sides) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// Settings of a tessellated base: the view, and the sizes of the base.
pub struct Tessellation {
    /// The eye, and unit vectors of the camera.
    pub eye: rt::Vec4<f32>,
    pub right: rt::Vec4<f32>,
    pub up: rt::Vec4<f32>,
    pub forward: rt::Vec4<f32>,
    /// Planes that cull: nothing is made at a position p where dot(plane, (p, 1)) > 0.
    pub planes: [rt::Vec4<f32>; 5],
    /// The middle of the picture, in voxels.
    pub middle: rt::Vec2<f32>,
    /// Voxels of a metre, in perspective at a depth of 1 m.
    pub per_m: f32,
    /// Voxels along the view axis from a depth to twice that.
    pub per_doubling: f32,
    /// The least depth; nearer sides are divided as if they were there.
    pub near_m: f32,
    /// 1 where rays are parallel.
    pub is_parallel: u32,
    /// Levels of the height map that are seen, at least 1.
    pub levels: u32,
    /// Vertices, edges and triangles of the base.
    pub vertices: u32,
    pub edges: u32,
    pub patches: u32,
    /// The most points besides the base's vertices, and the most triangles: with more the grid is coarser.
    pub most_points: u32,
    pub most_triangles: u32,
    /// Parts for a unit of u and of v; 0 where sides are divided by voxels.
    pub parts_of_uv: rt::Vec2<f32>,
    /// 1 if voxels fill the inside, too.
    pub is_swept: u32,
}
impl Tessellation {
    pub fn new(
        eye: impl rt::Into<rt::Vec4<f32>>,
        right: impl rt::Into<rt::Vec4<f32>>,
        up: impl rt::Into<rt::Vec4<f32>>,
        forward: impl rt::Into<rt::Vec4<f32>>,
        planes: impl rt::Into<[rt::Vec4<f32>; 5]>,
        middle: impl rt::Into<rt::Vec2<f32>>,
        per_m: impl rt::Into<f32>,
        per_doubling: impl rt::Into<f32>,
        near_m: impl rt::Into<f32>,
        is_parallel: impl rt::Into<u32>,
        levels: impl rt::Into<u32>,
        vertices: impl rt::Into<u32>,
        edges: impl rt::Into<u32>,
        patches: impl rt::Into<u32>,
        most_points: impl rt::Into<u32>,
        most_triangles: impl rt::Into<u32>,
        parts_of_uv: impl rt::Into<rt::Vec2<f32>>,
        is_swept: impl rt::Into<u32>,
    ) -> Self {
        Self { eye: rt::into(eye), right: rt::into(right), up: rt::into(up), forward: rt::into(forward), planes: rt::into(planes), middle: rt::into(middle), per_m: rt::into(per_m), per_doubling: rt::into(per_doubling), near_m: rt::into(near_m), is_parallel: rt::into(is_parallel), levels: rt::into(levels), vertices: rt::into(vertices), edges: rt::into(edges), patches: rt::into(patches), most_points: rt::into(most_points), most_triangles: rt::into(most_triangles), parts_of_uv: rt::into(parts_of_uv), is_swept: rt::into(is_swept) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A tetrahedron along a ray, in metres from the ray's middle: the extent of the ray inside, and the
/// weights of the triangle's corners, in their order, with the weight of the upper side.
pub struct Tetrahedron {
    pub inside: rt::Vec2<f32>,
    pub weights: rt::Vec4<f32>,
    /// The change of the weights per metre.
    pub change: rt::Vec4<f32>,
}
impl Tetrahedron {
    pub fn new(
        inside: impl rt::Into<rt::Vec2<f32>>,
        weights: impl rt::Into<rt::Vec4<f32>>,
        change: impl rt::Into<rt::Vec4<f32>>,
    ) -> Self {
        Self { inside: rt::into(inside), weights: rt::into(weights), change: rt::into(change) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A light as a point of the surface sees it.
pub struct Toward {
    /// Unit direction toward the light.
    pub direction: rt::Vec3<f32>,
    /// The factor on the light's colour at that distance.
    pub falloff: f32,
    /// Metres to the light; more than any other number for a light that is infinitely far away.
    pub distance: f32,
    /// Radius of the light's disc over its distance: the tangent of half its angular diameter.
    pub radius: f32,
    /// The light's number in the frame.
    pub number: u32,
}
impl Toward {
    pub fn new(
        direction: impl rt::Into<rt::Vec3<f32>>,
        falloff: impl rt::Into<f32>,
        distance: impl rt::Into<f32>,
        radius: impl rt::Into<f32>,
        number: impl rt::Into<u32>,
    ) -> Self {
        Self { direction: rt::into(direction), falloff: rt::into(falloff), distance: rt::into(distance), radius: rt::into(radius), number: rt::into(number) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A pair of elevations: the layer of the lower one, and its bend.
pub struct ViewPair {
    pub layer: i32,
    pub bend: f32,
}
impl ViewPair {
    pub fn new(
        layer: impl rt::Into<i32>,
        bend: impl rt::Into<f32>,
    ) -> Self {
        Self { layer: rt::into(layer), bend: rt::into(bend) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The views around a path. Two elevations are beside each other for each of two azimuths and two bends.
pub struct ViewsAround {
    /// 2 pairs of elevations for straight paths, or 4: azimuths run faster than bends.
    pub pairs: u32,
    pub before: f32,
    pub azimuths: f32,
    pub below: f32,
    pub elevations: f32,
    pub lower: f32,
    /// The parts of the way to the next azimuth, elevation and bend.
    pub part: rt::Vec3<f32>,
}
impl ViewsAround {
    pub fn new(
        pairs: impl rt::Into<u32>,
        before: impl rt::Into<f32>,
        azimuths: impl rt::Into<f32>,
        below: impl rt::Into<f32>,
        elevations: impl rt::Into<f32>,
        lower: impl rt::Into<f32>,
        part: impl rt::Into<rt::Vec3<f32>>,
    ) -> Self {
        Self { pairs: rt::into(pairs), before: rt::into(before), azimuths: rt::into(azimuths), below: rt::into(below), elevations: rt::into(elevations), lower: rt::into(lower), part: rt::into(part) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A vertex in grid space.
pub struct Voxel {
    /// The voxel of the vertex: right, down and away from the eye.
    pub at: rt::Vec3<i32>,
    /// The weight where points are divided in the picture: the inverse of its depth in perspective;
    /// 1 where they are divided on the base.
    pub share: f32,
}
impl Voxel {
    pub fn new(
        at: impl rt::Into<rt::Vec3<i32>>,
        share: impl rt::Into<f32>,
    ) -> Self {
        Self { at: rt::into(at), share: rt::into(share) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The values at the corners of a dual cell, in the order of `height_cell`: in the lower and in the upper slice.
pub struct VoxelCell {
    pub low: rt::Vec4<f32>,
    pub high: rt::Vec4<f32>,
}
impl VoxelCell {
    pub fn new(
        low: impl rt::Into<rt::Vec4<f32>>,
        high: impl rt::Into<rt::Vec4<f32>>,
    ) -> Self {
        Self { low: rt::into(low), high: rt::into(high) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A path in voxels: its place at t = 0, its change, and the bend of its height.
pub struct VoxelPath {
    pub origin: rt::Vec3<f32>,
    pub step: rt::Vec3<f32>,
    pub bend: f32,
}
impl VoxelPath {
    pub fn new(
        origin: impl rt::Into<rt::Vec3<f32>>,
        step: impl rt::Into<rt::Vec3<f32>>,
        bend: impl rt::Into<f32>,
    ) -> Self {
        Self { origin: rt::into(origin), step: rt::into(step), bend: rt::into(bend) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// The line through the shell: coefficients, by powers of the offset, of the weights over their sum.
pub struct Way {
    pub first: rt::Vec3<f32>,
    pub second: rt::Vec3<f32>,
    pub third: rt::Vec3<f32>,
    /// 1, or -1 where the order of the corners turns the triangle over.
    pub turn: f32,
}
impl Way {
    pub fn new(
        first: impl rt::Into<rt::Vec3<f32>>,
        second: impl rt::Into<rt::Vec3<f32>>,
        third: impl rt::Into<rt::Vec3<f32>>,
        turn: impl rt::Into<f32>,
    ) -> Self {
        Self { first: rt::into(first), second: rt::into(second), third: rt::into(third), turn: rt::into(turn) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A chord of the way: the offsets of its ends, and the number of chords in all.
pub struct WayChord {
    pub offsets: rt::Vec2<f32>,
    pub count: u32,
}
impl WayChord {
    pub fn new(
        offsets: impl rt::Into<rt::Vec2<f32>>,
        count: impl rt::Into<u32>,
    ) -> Self {
        Self { offsets: rt::into(offsets), count: rt::into(count) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// A point of the way.
pub struct WayPoint {
    pub point: ShellPoint,
    /// Metres along the ray from its nearest place to the triangle, and metres beside the ray.
    pub t: f32,
    pub beside: f32,
    /// Positive where the shell is not turned inside out.
    pub volume: f32,
}
impl WayPoint {
    pub fn new(
        point: impl rt::Into<ShellPoint>,
        t: impl rt::Into<f32>,
        beside: impl rt::Into<f32>,
        volume: impl rt::Into<f32>,
    ) -> Self {
        Self { point: rt::into(point), t: rt::into(t), beside: rt::into(beside), volume: rt::into(volume) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// What a look-up tells: the way to the solid in voxels, if something solid is on it.
pub struct WayToSolid {
    pub is_solid: u32,
    pub way: f32,
}
impl WayToSolid {
    pub fn new(
        is_solid: impl rt::Into<u32>,
        way: impl rt::Into<f32>,
    ) -> Self {
        Self { is_solid: rt::into(is_solid), way: rt::into(way) }
    }
}
#[rt::derive(rt::Clone, rt::Copy, rt::Debug, rt::PartialEq)]
#[repr(C)]
/// Two chains that are zipped, the first one to the left: its place, and the next points on each.
pub struct Zip {
    pub left: SweptChain,
    pub right: SweptChain,
    pub at_left: SweptPoint,
    pub at_right: SweptPoint,
    pub next_left: SweptPoint,
    pub next_right: SweptPoint,
    pub i: i32,
    pub j: i32,
    /// 1 where the end of that chain comes last, as it lies on the side on which the other chain ends.
    pub keeps_left: u32,
    pub keeps_right: u32,
}
impl Zip {
    pub fn new(
        left: impl rt::Into<SweptChain>,
        right: impl rt::Into<SweptChain>,
        at_left: impl rt::Into<SweptPoint>,
        at_right: impl rt::Into<SweptPoint>,
        next_left: impl rt::Into<SweptPoint>,
        next_right: impl rt::Into<SweptPoint>,
        i: impl rt::Into<i32>,
        j: impl rt::Into<i32>,
        keeps_left: impl rt::Into<u32>,
        keeps_right: impl rt::Into<u32>,
    ) -> Self {
        Self { left: rt::into(left), right: rt::into(right), at_left: rt::into(at_left), at_right: rt::into(at_right), next_left: rt::into(next_left), next_right: rt::into(next_right), i: rt::into(i), j: rt::into(j), keeps_left: rt::into(keeps_left), keeps_right: rt::into(keeps_right) }
    }
}
#[allow(non_upper_case_globals)]
pub const CELLS_BILINEAR: rt::Scalar<u32> = rt::Scalar(0u32);
#[allow(non_upper_case_globals)]
pub const CELLS_HIGHEST: rt::Scalar<u32> = rt::Scalar(2u32);
#[allow(non_upper_case_globals)]
pub const CELLS_MASK: rt::Scalar<u32> = rt::Scalar(4u32);
#[allow(non_upper_case_globals)]
pub const CELLS_NEAREST: rt::Scalar<u32> = rt::Scalar(3u32);
#[allow(non_upper_case_globals)]
pub const CELLS_STEP: rt::Scalar<u32> = rt::Scalar(1u32);
#[allow(non_upper_case_globals)]
pub const DICE_PARTS: rt::Scalar<u32> = rt::Scalar(32767u32);
#[allow(non_upper_case_globals)]
pub const FOUND_ABOVE: rt::Scalar<u32> = rt::Scalar(1u32);
#[allow(non_upper_case_globals)]
pub const FOUND_BELOW: rt::Scalar<u32> = rt::Scalar(2u32);
#[allow(non_upper_case_globals)]
pub const FOUND_BRACKET: rt::Scalar<u32> = rt::Scalar(3u32);
#[allow(non_upper_case_globals)]
pub const FOUND_EXHAUSTED: rt::Scalar<u32> = rt::Scalar(4u32);
#[allow(non_upper_case_globals)]
pub const FOUND_MISS: rt::Scalar<u32> = rt::Scalar(0u32);
#[allow(non_upper_case_globals)]
pub const FOUND_STARTED_BELOW: rt::Scalar<u32> = rt::Scalar(5u32);
#[allow(non_upper_case_globals)]
pub const FOUND_UNBRACKETED: rt::Scalar<u32> = rt::Scalar(6u32);
#[allow(non_upper_case_globals)]
pub const FRAMES: rt::Scalar<u32> = rt::Scalar(3u32);
#[allow(non_upper_case_globals)]
pub const HALVINGS: rt::Scalar<u32> = rt::Scalar(24u32);
#[allow(non_upper_case_globals)]
pub const HEIGHTS_READ: rt::Vec3<u32> = <rt::Vec3<u32>>::from_scalars(rt::Scalar(1u32), rt::Scalar(0u32), rt::Scalar(16u32));
#[allow(non_upper_case_globals)]
pub const HEIGHT_READ: rt::Vec3<u32> = <rt::Vec3<u32>>::from_scalars(rt::Scalar(1u32), rt::Scalar(0u32), rt::Scalar(4u32));
#[allow(non_upper_case_globals)]
pub const INSIDE: rt::Scalar<u32> = rt::Scalar(3u32);
#[allow(non_upper_case_globals)]
pub const LIGHT_RAY_DARK: rt::Scalar<u32> = rt::Scalar(1u32);
#[allow(non_upper_case_globals)]
pub const LIGHT_RAY_LIT: rt::Scalar<u32> = rt::Scalar(0u32);
#[allow(non_upper_case_globals)]
pub const LIGHT_RAY_OPEN: rt::Scalar<u32> = rt::Scalar(2u32);
#[allow(non_upper_case_globals)]
pub const STEP: rt::Vec3<u32> = <rt::Vec3<u32>>::from_scalars(rt::Scalar(0u32), rt::Scalar(1u32), rt::Scalar(0u32));
#[allow(non_upper_case_globals)]
pub const LOOK: rt::Vec3<u32> = <rt::Vec3<u32>>::from_scalars(rt::Scalar(1u32), rt::Scalar(1u32), rt::Scalar(16u32));
#[allow(non_upper_case_globals)]
pub const MAP_SLOTS: rt::Scalar<u32> = rt::Scalar(8u32);
#[allow(non_upper_case_globals)]
pub const MAX_LIGHTS: rt::Scalar<u32> = rt::Scalar(8u32);
#[allow(non_upper_case_globals)]
pub const MAX_LIGHT_VIEWS: rt::Scalar<u32> = rt::Scalar(48u32);
#[allow(non_upper_case_globals)]
pub const MOST_CELLS: rt::Scalar<u32> = rt::Scalar(2u32);
#[allow(non_upper_case_globals)]
pub const MOST_PIECES: rt::Scalar<u32> = rt::Scalar(7u32);
#[allow(non_upper_case_globals)]
pub const MOST_ROUNDS: rt::Scalar<u32> = rt::Scalar(256u32);
#[allow(non_upper_case_globals)]
pub const NEWTON_STEPS: rt::Scalar<u32> = rt::Scalar(6u32);
#[allow(non_upper_case_globals)]
pub const NODE_READ: rt::Vec3<u32> = <rt::Vec3<u32>>::from_scalars(rt::Scalar(1u32), rt::Scalar(0u32), rt::Scalar(32u32));
#[allow(non_upper_case_globals)]
pub const NO_COST: rt::Vec3<u32> = <rt::Vec3<u32>>::from_scalars(rt::Scalar(0u32), rt::Scalar(0u32), rt::Scalar(0u32));
#[allow(non_upper_case_globals)]
pub const ON_FIRST: rt::Scalar<u32> = rt::Scalar(2u32);
#[allow(non_upper_case_globals)]
pub const ON_PRIMARY: rt::Scalar<u32> = rt::Scalar(1u32);
#[allow(non_upper_case_globals)]
pub const ON_SECOND: rt::Scalar<u32> = rt::Scalar(4u32);
#[allow(non_upper_case_globals)]
pub const PARTS_OF_FOUR: rt::Vec4<f32> = <rt::Vec4<f32>>::from_scalars(rt::Scalar(0.45412415f32), rt::Scalar(0.45412415f32), rt::Scalar(0.04587585f32), rt::Scalar(0.04587585f32));
#[allow(non_upper_case_globals)]
pub const PIECE_HALVINGS: rt::Scalar<u32> = rt::Scalar(24u32);
#[allow(non_upper_case_globals)]
pub const POLISH_STEPS: rt::Scalar<u32> = rt::Scalar(3u32);
#[allow(non_upper_case_globals)]
pub const RAY_SHADOW: rt::Scalar<u32> = rt::Scalar(1u32);
#[allow(non_upper_case_globals)]
pub const RAY_VIEW: rt::Scalar<u32> = rt::Scalar(0u32);
#[allow(non_upper_case_globals)]
pub const ROOF_DOWN: rt::Scalar<u32> = rt::Scalar(4u32);
#[allow(non_upper_case_globals)]
pub const ROOF_UP: rt::Scalar<u32> = rt::Scalar(3u32);
#[allow(non_upper_case_globals)]
pub const SEARCH_STAGE: rt::Scalar<u32> = rt::Scalar(6u32);
#[allow(non_upper_case_globals)]
pub const SEEN_AZIMUTHS: rt::Scalar<u32> = rt::Scalar(8u32);
#[allow(non_upper_case_globals)]
pub const SEEN_ELEVATIONS: rt::Scalar<u32> = rt::Scalar(4u32);
#[allow(non_upper_case_globals)]
pub const SHADOW_STAGE: rt::Scalar<u32> = rt::Scalar(9u32);
#[allow(non_upper_case_globals)]
pub const SHELL_FOLDED: rt::Scalar<u32> = rt::Scalar(64u32);
#[allow(non_upper_case_globals)]
pub const SLICES_ALONG_HEIGHT: rt::Scalar<u32> = rt::Scalar(0u32);
#[allow(non_upper_case_globals)]
pub const SLICES_ALONG_U: rt::Scalar<u32> = rt::Scalar(1u32);
#[allow(non_upper_case_globals)]
pub const SLICES_ALONG_V: rt::Scalar<u32> = rt::Scalar(2u32);
#[allow(non_upper_case_globals)]
pub const SLOT_AMBIENT: rt::Scalar<u32> = rt::Scalar(4u32);
#[allow(non_upper_case_globals)]
pub const SLOT_DETAIL: rt::Scalar<u32> = rt::Scalar(0u32);
#[allow(non_upper_case_globals)]
pub const SLOT_ENVIRONMENT: rt::Scalar<u32> = rt::Scalar(5u32);
#[allow(non_upper_case_globals)]
pub const SLOT_SEARCH: rt::Scalar<u32> = rt::Scalar(1u32);
#[allow(non_upper_case_globals)]
pub const SLOT_SHADOW: rt::Scalar<u32> = rt::Scalar(3u32);
#[allow(non_upper_case_globals)]
pub const SLOT_SHADOW_SEARCH: rt::Scalar<u32> = rt::Scalar(2u32);
#[allow(non_upper_case_globals)]
pub const STAGES: rt::Scalar<u32> = rt::Scalar(12u32);
#[allow(non_upper_case_globals)]
pub const TOP_BEFORE: rt::Scalar<u32> = rt::Scalar(1u32);
#[allow(non_upper_case_globals)]
pub const TOP_NEXT: rt::Scalar<u32> = rt::Scalar(0u32);
#[allow(non_upper_case_globals)]
pub const TOP_ROOF: rt::Scalar<u32> = rt::Scalar(2u32);
#[allow(non_upper_case_globals)]
pub const TREE_COLUMNS: rt::Scalar<u32> = rt::Scalar(1024u32);
#[allow(non_upper_case_globals)]
pub const TREE_SHIFT: rt::Scalar<u32> = rt::Scalar(10u32);
#[allow(non_upper_case_globals)]
pub const TRIANGLE_READ: rt::Vec3<u32> = <rt::Vec3<u32>>::from_scalars(rt::Scalar(1u32), rt::Scalar(0u32), rt::Scalar(48u32));
#[allow(non_upper_case_globals)]
pub const TURN_STEPS: rt::Scalar<u32> = rt::Scalar(12u32);
#[allow(non_upper_case_globals)]
pub const VOXELS_READ: rt::Vec3<u32> = <rt::Vec3<u32>>::from_scalars(rt::Scalar(1u32), rt::Scalar(0u32), rt::Scalar(32u32));
#[allow(non_upper_case_globals)]
pub const WRAP_CLAMP: rt::Scalar<u32> = rt::Scalar(1u32);
#[allow(non_upper_case_globals)]
pub const WRAP_MIRROR: rt::Scalar<u32> = rt::Scalar(2u32);
#[allow(non_upper_case_globals)]
pub const WRAP_REPEAT: rt::Scalar<u32> = rt::Scalar(0u32);
#[derive(Clone, Copy, Debug)]
pub(crate) struct Resources<'g> {
    #[doc = "group(0) binding(9)"]
    pub(crate) ambient_map: rt::MapTexture<'g>,
    #[doc = "group(0) binding(2)"]
    pub(crate) color_map: rt::ColorTexture<'g>,
    #[doc = "group(0) binding(5)"]
    pub(crate) detail_map: rt::MapTexture<'g>,
    #[doc = "group(0) binding(10)"]
    pub(crate) environment_map: rt::MapTexture<'g>,
    #[doc = "group(0) binding(13)"]
    pub(crate) frame: Frame,
    #[doc = "group(0) binding(1)"]
    pub(crate) height_map: rt::HeightTexture<'g>,
    #[doc = "group(0) binding(15)"]
    pub(crate) hole_map: rt::HoleTexture<'g>,
    #[doc = "group(0) binding(11)"]
    pub(crate) light_map: rt::MapTexture<'g>,
    #[doc = "group(0) binding(16)"]
    pub(crate) material_map: rt::ColorTexture<'g>,
    #[doc = "group(0) binding(3)"]
    pub(crate) normal_map: rt::ColorTexture<'g>,
    #[doc = "group(0) binding(12)"]
    pub(crate) object_map: rt::MapTexture<'g>,
    #[doc = "group(0) binding(6)"]
    pub(crate) search_map: rt::MapTexture<'g>,
    #[doc = "group(0) binding(7)"]
    pub(crate) shadow_search_map: rt::MapTexture<'g>,
    #[doc = "group(0) binding(8)"]
    pub(crate) shadow_texels: rt::MapTexture<'g>,
    #[doc = "group(0) binding(0)"]
    pub(crate) surface_settings: SurfaceSettings,
}
impl<'g> Resources<'g> {
    pub(crate) fn quadratic(
        &self,
        c: impl rt::Into<rt::Vec3<f32>>,
        s: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_quadratic(rt::into(c), rt::into(s)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_quadratic(
        &self,
        c: rt::Vec3<f32>,
        s: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        return (c.x() + (s * (c.y() + (s * c.z()))));
    }
    pub(crate) fn across_roots(&self, ray: Across) -> rt::Vec3<f32> {
        rt::into(self.v_across_roots(ray))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_across_roots(&self, ray: Across) -> rt::Vec3<f32> {
        return <rt::Vec3<f32>>::from_scalars((rt::Scalar(ray.sine) * rt::Scalar(ray.sine)), (((rt::Scalar(-2f32) * rt::Scalar(ray.mixed)) * rt::Scalar(ray.sine)) - ((rt::Scalar(4f32) * rt::Scalar(ray.across)) * rt::Scalar(ray.descent))), ((rt::Scalar(ray.mixed) * rt::Scalar(ray.mixed)) - ((rt::Scalar(4f32) * rt::Scalar(ray.across)) * rt::Scalar(ray.along))));
    }
    pub(crate) fn across_discriminant(
        &self,
        ray_1: Across,
        t: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_across_discriminant(ray_1, rt::into(t)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_across_discriminant(
        &self,
        ray_1: Across,
        t: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let _e2 = self.v_across_roots(ray_1);
        let _e3 = self.v_quadratic(_e2, t);
        return _e3;
    }
    pub(crate) fn across_depth(
        &self,
        ray_2: Across,
        t_1: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_across_depth(ray_2, rt::into(t_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_across_depth(
        &self,
        ray_2: Across,
        t_1: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let c_23 = (t_1 * (rt::Scalar(ray_2.descent) + (t_1 * rt::Scalar(ray_2.along))));
        let _e7 = self.v_across_discriminant(ray_2, t_1);
        if rt::Scalar::into_branch_condition((!_e7.elementwise_ge(rt::Scalar(0f32)))) {
            return c_23;
        }
        let b_32 = ((t_1 * rt::Scalar(ray_2.mixed)) - rt::Scalar(ray_2.sine));
        let root = _e7.sqrt();
        if rt::Scalar::into_branch_condition(b_32.elementwise_lt(rt::Scalar(0f32))) {
            return ((rt::Scalar(2f32) * c_23) / (root - b_32));
        }
        if rt::Scalar::into_branch_condition(rt::Scalar(ray_2.across).elementwise_ne(rt::Scalar(0f32))) {
            return (((rt::Scalar(0f32) - b_32) - root) / (rt::Scalar(2f32) * rt::Scalar(ray_2.across)));
        }
        return c_23;
    }
    pub(crate) fn traced_scale_m(&self) -> f32 {
        rt::into(self.v_traced_scale_m())
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_traced_scale_m(&self) -> rt::Scalar<f32> {
        let _e2 = rt::Scalar(self.surface_settings.scale_m);
        return _e2.max(rt::Scalar(0.000000001f32));
    }
    pub(crate) fn climb(
        &self,
        at: Entered,
        direction: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_climb(at, rt::into(direction)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_climb(
        &self,
        at: Entered,
        direction: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let metric = at.metric;
        let td = at.tangent.dot(direction);
        let bd = at.bitangent.dot(direction);
        let area = ((metric.x() * metric.z()) - (metric.y() * metric.y()));
        let duv_2 = (<rt::Vec2<f32>>::from_scalars(((td * metric.z()) - (bd * metric.y())), ((bd * metric.x()) - (td * metric.y()))) / rt::Vec2::splat_from_scalar(area));
        let _e29 = self.v_traced_scale_m();
        return <rt::Vec3<f32>>::new_21(duv_2, (at.normal.dot(direction) / _e29));
    }
    pub(crate) fn quadric_slope(
        &self,
        quadric: impl rt::Into<rt::Vec3<f32>>,
        duv: impl rt::Into<rt::Vec2<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_quadric_slope(rt::into(quadric), rt::into(duv)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_quadric_slope(
        &self,
        quadric: rt::Vec3<f32>,
        duv: rt::Vec2<f32>,
    ) -> rt::Vec2<f32> {
        return <rt::Vec2<f32>>::from_scalars((((rt::Scalar(2f32) * quadric.x()) * duv.x()) + (quadric.y() * duv.y())), ((quadric.y() * duv.x()) + ((rt::Scalar(2f32) * quadric.z()) * duv.y())));
    }
    pub(crate) fn quadric_at(
        &self,
        quadric_1: impl rt::Into<rt::Vec3<f32>>,
        duv_1: impl rt::Into<rt::Vec2<f32>>,
    ) -> f32 {
        rt::into(self.v_quadric_at(rt::into(quadric_1), rt::into(duv_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_quadric_at(
        &self,
        quadric_1: rt::Vec3<f32>,
        duv_1: rt::Vec2<f32>,
    ) -> rt::Scalar<f32> {
        return quadric_1.dot(<rt::Vec3<f32>>::from_scalars((duv_1.x() * duv_1.x()), (duv_1.x() * duv_1.y()), (duv_1.y() * duv_1.y())));
    }
    pub(crate) fn across_of(
        &self,
        at_1: Entered,
        direction_1: impl rt::Into<rt::Vec3<f32>>,
    ) -> Across {
        rt::into(self.v_across_of(at_1, rt::into(direction_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_across_of(
        &self,
        at_1: Entered,
        direction_1: rt::Vec3<f32>,
    ) -> Across {
        let _e2 = self.v_climb(at_1, direction_1);
        let duv_3 = _e2.xy();
        let descent_1 = (rt::Scalar(0f32) - at_1.normal.dot(direction_1));
        let aside_1 = (at_1.normal + (direction_1 * descent_1));
        let sine = aside_1.length().max(rt::Scalar(0.0009765625f32));
        let q_8 = at_1.of_surface.xyz();
        let _e18 = self.v_climb(at_1, (aside_1 / rt::Vec3::splat_from_scalar(sine)));
        let beside_2 = _e18.xy();
        let _e20 = self.v_quadric_slope(q_8, duv_3);
        let mixed_1 = _e20.dot(beside_2);
        let _e22 = self.v_quadric_at(q_8, duv_3);
        let _e23 = self.v_quadric_at(q_8, beside_2);
        return <Across>::new(duv_3, descent_1, _e22, _e23, mixed_1, sine);
    }
    pub(crate) fn reached(
        &self,
        ray_3: Across,
        depth: impl rt::Into<rt::Scalar<f32>>,
        t_2: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_reached(ray_3, rt::into(depth), rt::into(t_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_reached(
        &self,
        ray_3: Across,
        depth: rt::Scalar<f32>,
        t_2: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let mut local: rt::Scalar<bool>;

        let _e3 = self.v_across_depth(ray_3, t_2);
        let off = (_e3 - depth).abs();
        if rt::Scalar::into_branch_condition(t_2.elementwise_lt(rt::Scalar(300000000000000000000000000000000000000f32))) {
            let _e10 = self.v_traced_scale_m();
            local = off.elementwise_le((rt::Scalar(0.0009765625f32) * (_e10 + depth.abs())));
        } else {
            local = rt::Scalar(false);
        }
        let _e17 = local;
        return rt::Scalar(300000000000000000000000000000000000000f32).select(t_2, _e17);
    }
    pub(crate) fn bent_descent(
        &self,
        depth_1: impl rt::Into<rt::Scalar<f32>>,
        descent: impl rt::Into<rt::Scalar<f32>>,
        bend: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_bent_descent(rt::into(depth_1), rt::into(descent), rt::into(bend)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_bent_descent(
        &self,
        depth_1: rt::Scalar<f32>,
        descent: rt::Scalar<f32>,
        bend: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let mut t_3: rt::Scalar<f32> = rt::Scalar(300000000000000000000000000000000000000f32);

        if rt::Scalar::into_branch_condition(bend.elementwise_eq(rt::Scalar(0f32))) {
            if rt::Scalar::into_branch_condition(descent.elementwise_gt(rt::Scalar(0f32))) {
                t_3 = (depth_1 / descent);
            }
            let _e10 = t_3;
            return _e10;
        }
        let discriminant = ((descent * descent) + ((rt::Scalar(4f32) * bend) * depth_1));
        if rt::Scalar::into_branch_condition(discriminant.elementwise_gt(rt::Scalar(0f32))) {
            let root_1 = discriminant.sqrt();
            if rt::Scalar::into_branch_condition(descent.elementwise_gt(rt::Scalar(0f32))) {
                t_3 = ((rt::Scalar(2f32) * depth_1) / (descent + root_1));
            } else {
                t_3 = ((root_1 - descent) / (rt::Scalar(2f32) * bend));
            }
        }
        let _e29 = t_3;
        return _e29;
    }
    pub(crate) fn down_across(
        &self,
        ray_4: Across,
        depth_2: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_down_across(ray_4, rt::into(depth_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_down_across(
        &self,
        ray_4: Across,
        depth_2: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let under = (depth_2 * (rt::Scalar(ray_4.sine) - (depth_2 * rt::Scalar(ray_4.across))));
        let _e12 = self.v_bent_descent(under, (rt::Scalar(ray_4.descent) + (depth_2 * rt::Scalar(ray_4.mixed))), rt::Scalar(ray_4.along));
        let _e13 = self.v_reached(ray_4, depth_2, _e12);
        return _e13;
    }
    pub(crate) fn down_along(
        &self,
        ray_5: Across,
        depth_3: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_down_along(ray_5, rt::into(depth_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_down_along(
        &self,
        ray_5: Across,
        depth_3: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let _e4 = self.v_bent_descent(depth_3, rt::Scalar(ray_5.descent), rt::Scalar(ray_5.along));
        let _e5 = self.v_reached(ray_5, depth_3, _e4);
        return _e5;
    }
    pub(crate) fn first_root(
        &self,
        c_1: impl rt::Into<rt::Vec3<f32>>,
        span: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_first_root(rt::into(c_1), rt::into(span)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_first_root(
        &self,
        c_1: rt::Vec3<f32>,
        span: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let mut a: rt::Scalar<f32> = rt::Scalar(300000000000000000000000000000000000000f32);
        let mut b: rt::Scalar<f32> = rt::Scalar(300000000000000000000000000000000000000f32);

        let discriminant_1 = ((c_1.y() * c_1.y()) - ((rt::Scalar(4f32) * c_1.z()) * c_1.x()));
        if rt::Scalar::into_branch_condition(discriminant_1.elementwise_ge(rt::Scalar(0f32))) {
            let root_2 = discriminant_1.sqrt();
            let q_9 = (rt::Scalar(-0.5f32) * (c_1.y() + (rt::Scalar(0f32) - root_2).select(root_2, c_1.y().elementwise_ge(rt::Scalar(0f32)))));
            if rt::Scalar::into_branch_condition(c_1.z().elementwise_ne(rt::Scalar(0f32))) {
                a = (q_9 / c_1.z());
            }
            if rt::Scalar::into_branch_condition(q_9.elementwise_ne(rt::Scalar(0f32))) {
                b = (c_1.x() / q_9);
            }
            let _e37 = a;
            let _e38 = a;
            a = rt::Scalar(300000000000000000000000000000000000000f32).select(_e37, _e38.elementwise_ge(rt::Scalar(0f32)));
            let _e43 = b;
            let _e44 = b;
            b = rt::Scalar(300000000000000000000000000000000000000f32).select(_e43, _e44.elementwise_ge(rt::Scalar(0f32)));
            let _e49 = a;
            let _e50 = b;
            let first_10 = _e49.min(_e50);
            if rt::Scalar::into_branch_condition(first_10.elementwise_le(span)) {
                return first_10;
            }
        }
        let _e53 = self.v_quadratic(c_1, span);
        if rt::Scalar::into_branch_condition(_e53.elementwise_le(rt::Scalar(0f32))) {
            return span;
        }
        return rt::Scalar(300000000000000000000000000000000000000f32);
    }
    pub(crate) fn jumps_below(
        &self,
        ray_6: Across,
        depth_4: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_jumps_below(ray_6, rt::into(depth_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_jumps_below(
        &self,
        ray_6: Across,
        depth_4: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let mut local_1: rt::Scalar<bool>;

        let _e2 = self.v_across_roots(ray_6);
        let _e4 = self.v_first_root(_e2, rt::Scalar(300000000000000000000000000000000000000f32));
        if rt::Scalar::into_branch_condition(_e4.elementwise_lt(rt::Scalar(300000000000000000000000000000000000000f32))) {
            local_1 = (_e4 * (rt::Scalar(ray_6.descent) + (_e4 * rt::Scalar(ray_6.along)))).elementwise_ge(depth_4);
        } else {
            local_1 = rt::Scalar(false);
        }
        let below_3 = local_1;
        return rt::Scalar(300000000000000000000000000000000000000f32).select(_e4, below_3);
    }
    pub(crate) fn across_span(
        &self,
        at_2: Entered,
        ray_7: Across,
        eye: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_across_span(at_2, ray_7, rt::into(eye)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_across_span(
        &self,
        at_2: Entered,
        ray_7: Across,
        eye: rt::Scalar<f32>,
    ) -> rt::Vec2<f32> {
        let mut local_2: rt::Scalar<bool>;
        let mut local_3: rt::Scalar<bool>;
        let mut leave: rt::Scalar<f32>;

        let nowhere = <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(-1f32));
        let _e6 = self.v_traced_scale_m();
        let height_18 = at_2.of_surface.w();
        let over = ((height_18 - rt::Scalar(1f32)) * _e6);
        let _e12 = self.v_down_across(ray_7, over);
        let _e13 = self.v_down_along(ray_7, over);
        let _e15 = self.v_jumps_below(ray_7, over);
        let begin_9 = _e12.min(_e13).min(_e15);
        if rt::Scalar::into_branch_condition((!(!begin_9.elementwise_lt(rt::Scalar(300000000000000000000000000000000000000f32))))) {
            if rt::Scalar::into_branch_condition(height_18.elementwise_ge(rt::Scalar(1f32))) {
                local_3 = begin_9.elementwise_lt(rt::Scalar(0f32));
            } else {
                local_3 = rt::Scalar(false);
            }
            let _e30 = local_3;
            local_2 = _e30;
        } else {
            local_2 = rt::Scalar(true);
        }
        let _e32 = local_2;
        if rt::Scalar::into_branch_condition(_e32) {
            return nowhere;
        }
        let enter_2 = begin_9.max(eye);
        let floor = (height_18 * _e6);
        let _e35 = self.v_down_across(ray_7, floor);
        let _e36 = self.v_down_along(ray_7, floor);
        let _e37 = self.v_jumps_below(ray_7, floor);
        leave = rt::Scalar(300000000000000000000000000000000000000f32).select(_e35, _e35.elementwise_gt(enter_2));
        let _e42 = leave;
        leave = _e42.min(rt::Scalar(300000000000000000000000000000000000000f32).select(_e36, _e36.elementwise_gt(enter_2)));
        let _e47 = leave;
        leave = _e47.min(rt::Scalar(300000000000000000000000000000000000000f32).select(_e37, _e37.elementwise_gt(enter_2)));
        if rt::Scalar::into_branch_condition(rt::Scalar(ray_7.along).elementwise_lt(rt::Scalar(0f32))) {
            let under_1 = ((rt::Scalar(ray_7.descent) * rt::Scalar(ray_7.descent)) + ((rt::Scalar(4f32) * rt::Scalar(ray_7.along)) * over));
            if rt::Scalar::into_branch_condition(under_1.elementwise_ge(rt::Scalar(0f32))) {
                let _e65 = leave;
                leave = _e65.min(((rt::Scalar(ray_7.descent) + under_1.sqrt()) / (rt::Scalar(-2f32) * rt::Scalar(ray_7.along))));
            }
        }
        let _e74 = leave;
        if rt::Scalar::into_branch_condition((!_e74.elementwise_lt(rt::Scalar(300000000000000000000000000000000000000f32)))) {
            return nowhere;
        }
        let _e78 = leave;
        let _e79 = leave;
        return <rt::Vec2<f32>>::from_scalars(enter_2, (_e78 + ((_e79 - enter_2) * rt::Scalar(0.000001f32))));
    }
    pub(crate) fn add_sample(
        &self,
        sum: impl rt::Into<rt::Vec4<f32>>,
        color: impl rt::Into<rt::Vec4<f32>>,
        weight: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_add_sample(rt::into(sum), rt::into(color), rt::into(weight)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_add_sample(
        &self,
        sum: rt::Vec4<f32>,
        color: rt::Vec4<f32>,
        weight: rt::Scalar<f32>,
    ) -> rt::Vec4<f32> {
        return (sum + (color * weight));
    }
    pub(crate) fn along_slice(
        &self,
        h: impl rt::Into<rt::Vec4<f32>>,
        at_3: impl rt::Into<rt::Vec2<f32>>,
        dx: impl rt::Into<rt::Scalar<f32>>,
        dy: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_along_slice(rt::into(h), rt::into(at_3), rt::into(dx), rt::into(dy)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_along_slice(
        &self,
        h: rt::Vec4<f32>,
        at_3: rt::Vec2<f32>,
        dx: rt::Scalar<f32>,
        dy: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let bx = (h.y() - h.x());
        let by_3 = (h.z() - h.x());
        let twist = ((h.x() - h.y()) + (h.w() - h.z()));
        return <rt::Vec3<f32>>::from_scalars((((h.x() + (bx * at_3.x())) + (by_3 * at_3.y())) + ((twist * at_3.x()) * at_3.y())), (((bx * dx) + (by_3 * dy)) + (twist * ((at_3.x() * dy) + (at_3.y() * dx)))), ((twist * dx) * dy));
    }
    pub(crate) fn from_tangent_space(
        &self,
        at_4: Entered,
        n: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_from_tangent_space(at_4, rt::into(n)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_from_tangent_space(
        &self,
        at_4: Entered,
        n: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let along_u = at_4.tangent.normalize();
        let along_v = at_4.bitangent.normalize();
        return (((along_u * n.x()) - (along_v * n.y())) + (at_4.normal * n.z()));
    }
    pub(crate) fn cell_of(&self, point: impl rt::Into<rt::Vec2<f32>>) -> rt::Vec2<f32> {
        rt::into(self.v_cell_of(rt::into(point)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_cell_of(&self, point: rt::Vec2<f32>) -> rt::Vec2<f32> {
        return point.floor().clamp(<rt::Vec2<f32>>::from_scalars(rt::Scalar(-1073741800f32), rt::Scalar(-1073741800f32)), <rt::Vec2<f32>>::from_scalars(rt::Scalar(1073741800f32), rt::Scalar(1073741800f32)));
    }
    pub(crate) fn unfolded(
        &self,
        i: impl rt::Into<rt::Scalar<i32>>,
        n_1: impl rt::Into<rt::Scalar<i32>>,
        period: impl rt::Into<rt::Scalar<i32>>,
    ) -> i32 {
        rt::into(self.v_unfolded(rt::into(i), rt::into(n_1), rt::into(period)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_unfolded(
        &self,
        i: rt::Scalar<i32>,
        n_1: rt::Scalar<i32>,
        period: rt::Scalar<i32>,
    ) -> rt::Scalar<i32> {
        return ((period - rt::Scalar(1i32)) - i).select(i, i.elementwise_lt(n_1));
    }
    pub(crate) fn continued_pair(
        &self,
        i_1: impl rt::Into<rt::Scalar<i32>>,
        n_2: impl rt::Into<rt::Scalar<i32>>,
        wrap: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec2<i32> {
        rt::into(self.v_continued_pair(rt::into(i_1), rt::into(n_2), rt::into(wrap)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_continued_pair(
        &self,
        i_1: rt::Scalar<i32>,
        n_2: rt::Scalar<i32>,
        wrap: rt::Scalar<u32>,
    ) -> rt::Vec2<i32> {
        let mut local_4: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition(wrap.elementwise_eq(WRAP_CLAMP)) {
            return <rt::Vec2<i32>>::from_scalars(i_1.clamp(rt::Scalar(0i32), (n_2 - rt::Scalar(1i32))), (i_1 + rt::Scalar(1i32)).clamp(rt::Scalar(0i32), (n_2 - rt::Scalar(1i32))));
        }
        if rt::Scalar::into_branch_condition(i_1.elementwise_ge(rt::Scalar(0i32))) {
            local_4 = (i_1 + rt::Scalar(1i32)).elementwise_lt(n_2);
        } else {
            local_4 = rt::Scalar(false);
        }
        let _e24 = local_4;
        if rt::Scalar::into_branch_condition(_e24) {
            return <rt::Vec2<i32>>::from_scalars(i_1, (i_1 + rt::Scalar(1i32)));
        }
        let period_1 = (rt::Scalar(2i32) * n_2).select(n_2, wrap.elementwise_eq(WRAP_REPEAT));
        let rest_4 = (i_1 % period_1);
        let first_11 = rest_4.select((rest_4 + period_1), rest_4.elementwise_lt(rt::Scalar(0i32)));
        let second_2 = (first_11 + rt::Scalar(1i32)).select(rt::Scalar(0i32), (first_11 + rt::Scalar(1i32)).elementwise_eq(period_1));
        let _e45 = self.v_unfolded(first_11, n_2, period_1);
        let _e46 = self.v_unfolded(second_2, n_2, period_1);
        return <rt::Vec2<i32>>::from_scalars(_e45, _e46);
    }
    pub(crate) fn wrap_pair(
        &self,
        i_2: impl rt::Into<rt::Scalar<i32>>,
        n_3: impl rt::Into<rt::Scalar<i32>>,
    ) -> rt::Vec2<i32> {
        rt::into(self.v_wrap_pair(rt::into(i_2), rt::into(n_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_wrap_pair(
        &self,
        i_2: rt::Scalar<i32>,
        n_3: rt::Scalar<i32>,
    ) -> rt::Vec2<i32> {
        let _e4 = rt::Scalar(self.surface_settings.wrap);
        let _e5 = self.v_continued_pair(i_2, n_3, _e4);
        return _e5;
    }
    pub(crate) fn texels_around(
        &self,
        uv: impl rt::Into<rt::Vec2<f32>>,
        n_4: impl rt::Into<rt::Vec2<i32>>,
    ) -> Around {
        rt::into(self.v_texels_around(rt::into(uv), rt::into(n_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_texels_around(
        &self,
        uv: rt::Vec2<f32>,
        n_4: rt::Vec2<i32>,
    ) -> Around {
        let point_22 = ((uv * n_4.to_f32()) - <rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32)));
        let _e8 = self.v_cell_of(point_22);
        let i_7 = _e8.to_i32();
        let _e12 = self.v_wrap_pair(i_7.x(), n_4.x());
        let _e15 = self.v_wrap_pair(i_7.y(), n_4.y());
        return <Around>::new(_e12, _e15, (point_22 - _e8));
    }
    pub(crate) fn level_texels(
        &self,
        finest: impl rt::Into<rt::Vec2<u32>>,
        level: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec2<i32> {
        rt::into(self.v_level_texels(rt::into(finest), rt::into(level)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_level_texels(
        &self,
        finest: rt::Vec2<u32>,
        level: rt::Scalar<u32>,
    ) -> rt::Vec2<i32> {
        return <rt::Vec2<i32>>::from_scalars((finest.x() >> level).to_i32().max(rt::Scalar(1i32)), (finest.y() >> level).to_i32().max(rt::Scalar(1i32)));
    }
    pub(crate) fn height_texels(&self, level_1: impl rt::Into<rt::Scalar<u32>>) -> rt::Vec2<i32> {
        rt::into(self.v_height_texels(rt::into(level_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_height_texels(&self, level_1: rt::Scalar<u32>) -> rt::Vec2<i32> {
        let _e3 = self.surface_settings.height_size;
        let _e4 = self.v_level_texels(_e3, level_1);
        return _e4;
    }
    pub(crate) fn bilinear(
        &self,
        h00_: impl rt::Into<rt::Vec4<f32>>,
        h10_: impl rt::Into<rt::Vec4<f32>>,
        h01_: impl rt::Into<rt::Vec4<f32>>,
        h11_: impl rt::Into<rt::Vec4<f32>>,
        part: impl rt::Into<rt::Vec2<f32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_bilinear(rt::into(h00_), rt::into(h10_), rt::into(h01_), rt::into(h11_), rt::into(part)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_bilinear(
        &self,
        h00_: rt::Vec4<f32>,
        h10_: rt::Vec4<f32>,
        h01_: rt::Vec4<f32>,
        h11_: rt::Vec4<f32>,
        part: rt::Vec2<f32>,
    ) -> rt::Vec4<f32> {
        let top_1 = (h00_ + ((h10_ - h00_) * part.x()));
        let bottom = (h01_ + ((h11_ - h01_) * part.x()));
        return (top_1 + ((bottom - top_1) * part.y()));
    }
    pub(crate) fn decoded(
        &self,
        texel: impl rt::Into<rt::Vec4<f32>>,
        map: MapSettings,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_decoded(rt::into(texel), map))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_decoded(
        &self,
        texel: rt::Vec4<f32>,
        map: MapSettings,
    ) -> rt::Vec4<f32> {
        if rt::Scalar::into_branch_condition(rt::Scalar(map.coded).elementwise_eq(rt::Scalar(1u32))) {
            return (map.low + (map.step * ((texel * rt::Scalar(255f32)) + <rt::Vec4<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32), rt::Scalar(0.5f32), rt::Scalar(0.5f32))).floor()));
        }
        return texel;
    }
    pub(crate) fn ambient_texel(
        &self,
        place: impl rt::Into<rt::Vec2<i32>>,
        layer: impl rt::Into<rt::Scalar<i32>>,
        level_2: impl rt::Into<rt::Scalar<i32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_ambient_texel(rt::into(place), rt::into(layer), rt::into(level_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_ambient_texel(
        &self,
        place: rt::Vec2<i32>,
        layer: rt::Scalar<i32>,
        level_2: rt::Scalar<i32>,
    ) -> rt::Vec4<f32> {
        let _e4 = rt::texture::Read::read_texel((&self.ambient_map), place, rt::Scalar::into_inner(layer), 0i32, rt::Scalar::into_inner(level_2));
        let _e8 = self.surface_settings.maps[4usize];
        let _e9 = self.v_decoded(_e4, _e8);
        return _e9;
    }
    pub(crate) fn ambient_texel_between(
        &self,
        uv_1: impl rt::Into<rt::Vec2<f32>>,
        level_3: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_ambient_texel_between(rt::into(uv_1), rt::into(level_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_ambient_texel_between(
        &self,
        uv_1: rt::Vec2<f32>,
        level_3: rt::Scalar<u32>,
    ) -> rt::Vec4<f32> {
        let first_12 = rt::Scalar(self.surface_settings.maps[4usize].first_level);
        let seen_9 = first_12.select(level_3, level_3.elementwise_gt(first_12));
        let _e9 = self.v_height_texels(seen_9);
        let _e10 = self.v_texels_around(uv_1, _e9);
        let k_55 = (seen_9 - first_12).to_i32();
        let _e19 = self.v_ambient_texel(<rt::Vec2<i32>>::from_scalars(_e10.columns.x(), _e10.rows.x()), rt::Scalar(0i32), k_55);
        let _e26 = self.v_ambient_texel(<rt::Vec2<i32>>::from_scalars(_e10.columns.y(), _e10.rows.x()), rt::Scalar(0i32), k_55);
        let _e33 = self.v_ambient_texel(<rt::Vec2<i32>>::from_scalars(_e10.columns.x(), _e10.rows.y()), rt::Scalar(0i32), k_55);
        let _e40 = self.v_ambient_texel(<rt::Vec2<i32>>::from_scalars(_e10.columns.y(), _e10.rows.y()), rt::Scalar(0i32), k_55);
        let _e42 = self.v_bilinear(_e19, _e26, _e33, _e40, _e10.part);
        return _e42;
    }
    pub(crate) fn ambient_bent_normal(
        &self,
        at_5: Entered,
        hit: Hit,
        normal: impl rt::Into<rt::Vec3<f32>>,
        view: impl rt::Into<rt::Vec3<f32>>,
        material: Material,
        params: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_ambient_bent_normal(at_5, hit, rt::into(normal), rt::into(view), material, rt::into(params)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_ambient_bent_normal(
        &self,
        at_5: Entered,
        hit: Hit,
        normal: rt::Vec3<f32>,
        view: rt::Vec3<f32>,
        material: Material,
        params: rt::Vec4<f32>,
    ) -> rt::Vec3<f32> {
        let _e8 = self.v_ambient_texel_between(hit.uv, rt::Scalar(at_5.level));
        let _e10 = self.v_from_tangent_space(at_5, _e8.xyz());
        let _e13 = self.frame.ambient;
        return ((_e13.xyz() * material.around) * normal.dot(_e10).max(rt::Scalar(0f32)));
    }
    pub(crate) fn ambient_bounce(
        &self,
        at_6: Entered,
        hit_1: Hit,
        normal_1: impl rt::Into<rt::Vec3<f32>>,
        view_1: impl rt::Into<rt::Vec3<f32>>,
        material_1: Material,
        params_1: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_ambient_bounce(at_6, hit_1, rt::into(normal_1), rt::into(view_1), material_1, rt::into(params_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_ambient_bounce(
        &self,
        at_6: Entered,
        hit_1: Hit,
        normal_1: rt::Vec3<f32>,
        view_1: rt::Vec3<f32>,
        material_1: Material,
        params_1: rt::Vec4<f32>,
    ) -> rt::Vec3<f32> {
        let _e8 = self.frame.ambient;
        let _e14 = self.v_ambient_texel_between(hit_1.uv, rt::Scalar(at_6.level));
        return ((_e8.xyz() * material_1.around) * _e14.x());
    }
    pub(crate) fn ambient_constant(
        &self,
        at_7: Entered,
        hit_2: Hit,
        normal_2: impl rt::Into<rt::Vec3<f32>>,
        view_2: impl rt::Into<rt::Vec3<f32>>,
        material_2: Material,
        params_2: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_ambient_constant(at_7, hit_2, rt::into(normal_2), rt::into(view_2), material_2, rt::into(params_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_ambient_constant(
        &self,
        at_7: Entered,
        hit_2: Hit,
        normal_2: rt::Vec3<f32>,
        view_2: rt::Vec3<f32>,
        material_2: Material,
        params_2: rt::Vec4<f32>,
    ) -> rt::Vec3<f32> {
        let _e8 = self.frame.ambient;
        return (_e8.xyz() * material_2.around);
    }
    pub(crate) fn cosine_inside(&self, cosine: impl rt::Into<rt::Scalar<f32>>) -> f32 {
        rt::into(self.v_cosine_inside(rt::into(cosine)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_cosine_inside(&self, cosine: rt::Scalar<f32>) -> rt::Scalar<f32> {
        let _e3 = rt::Scalar(self.surface_settings.ior);
        let eta = (rt::Scalar(1f32) / _e3);
        return (rt::Scalar(1f32) - ((eta * eta) * (rt::Scalar(1f32) - (cosine * cosine)))).max(rt::Scalar(0f32)).sqrt();
    }
    pub(crate) fn fresnel(&self, cosine_1: impl rt::Into<rt::Scalar<f32>>) -> f32 {
        rt::into(self.v_fresnel(rt::into(cosine_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_fresnel(&self, cosine_1: rt::Scalar<f32>) -> rt::Scalar<f32> {
        let ior = rt::Scalar(self.surface_settings.ior);
        let _e4 = self.v_cosine_inside(cosine_1);
        let across_1 = ((cosine_1 - (ior * _e4)) / (cosine_1 + (ior * _e4)).max(rt::Scalar(0.000001f32)));
        let along_21 = (((ior * cosine_1) - _e4) / ((ior * cosine_1) + _e4).max(rt::Scalar(0.000001f32)));
        let waves = <rt::Vec2<f32>>::from_scalars(across_1, along_21);
        return (rt::Scalar(0.5f32) * waves.dot(waves));
    }
    pub(crate) fn shade_blinn_phong_mirrored(
        &self,
        material_3: Material,
        mean: impl rt::Into<rt::Scalar<f32>>,
        cosine_2: impl rt::Into<rt::Scalar<f32>>,
        params_3: impl rt::Into<rt::Vec4<f32>>,
    ) -> Mirrored {
        rt::into(self.v_shade_blinn_phong_mirrored(material_3, rt::into(mean), rt::into(cosine_2), rt::into(params_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shade_blinn_phong_mirrored(
        &self,
        material_3: Material,
        mean: rt::Scalar<f32>,
        cosine_2: rt::Scalar<f32>,
        params_3: rt::Vec4<f32>,
    ) -> Mirrored {
        let _e4 = self.v_fresnel(cosine_2);
        let _e7 = rt::Scalar(self.surface_settings.shininess);
        let lean = ((rt::Scalar(2f32) / (_e7.to_f32() + rt::Scalar(2f32))) + (rt::Scalar(2f32) * (rt::Scalar(1f32) - mean).max(rt::Scalar(0f32)))).sqrt();
        return <Mirrored>::new(<rt::Vec3<f32>>::from_scalars(_e4, _e4, _e4), lean, <rt::Vec2<f32>>::from_scalars((rt::Scalar(2f32) * lean), (rt::Scalar(2f32) * lean)), rt::Scalar(0f32), rt::Scalar(0f32));
    }
    pub(crate) fn facet_reflection(
        &self,
        cosine_3: impl rt::Into<rt::Scalar<f32>>,
        alpha: impl rt::Into<rt::Scalar<f32>>,
        roughness: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_facet_reflection(rt::into(cosine_3), rt::into(alpha), rt::into(roughness)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_facet_reflection(
        &self,
        cosine_3: rt::Scalar<f32>,
        alpha: rt::Scalar<f32>,
        roughness: rt::Scalar<f32>,
    ) -> rt::Vec2<f32> {
        let x_6 = (cosine_3 / (cosine_3 + (rt::Scalar(0.65f32) * alpha)));
        let a6_ = (rt::Scalar(0.1878f32) + (alpha * (rt::Scalar(-0.9742f32) + (alpha * (rt::Scalar(1.3709f32) + (alpha * rt::Scalar(-0.6017f32)))))));
        let a0_ = (rt::Scalar(1.0034f32) + (alpha * (rt::Scalar(0.0071f32) + (alpha * a6_))));
        let a1_ = (rt::Scalar(-0.4137f32) + (alpha * (rt::Scalar(-0.4144f32) + (alpha * (rt::Scalar(-0.877f32) + (alpha * (rt::Scalar(-1.6058f32) + (alpha * rt::Scalar(0.9124f32)))))))));
        let a2_ = (rt::Scalar(2.5855f32) + (alpha * (rt::Scalar(0.3239f32) + (alpha * (rt::Scalar(2.4708f32) + (alpha * rt::Scalar(0.7166f32)))))));
        let a3_ = (rt::Scalar(-8.9277f32) + (alpha * (rt::Scalar(-0.5518f32) + (alpha * rt::Scalar(-3.0114f32)))));
        let a4_ = (rt::Scalar(11.8249f32) + (alpha * rt::Scalar(0.937f32)));
        let all_1 = (a0_ + (x_6 * (a1_ + (x_6 * (a2_ + (x_6 * (a3_ + (x_6 * (a4_ + (x_6 * rt::Scalar(-5.0796f32)))))))))));
        let b5_ = (rt::Scalar(3.4396f32) + (roughness * (rt::Scalar(-0.7093f32) + (roughness * rt::Scalar(-0.4004f32)))));
        let b0_ = (rt::Scalar(1.1487f32) + (roughness * (rt::Scalar(-3.4586f32) + (roughness * b5_))));
        let b1_ = (rt::Scalar(-0.6771f32) + (roughness * (rt::Scalar(5.7828f32) + (roughness * (rt::Scalar(-8.8951f32) + (roughness * rt::Scalar(4.2115f32)))))));
        let b2_ = (rt::Scalar(0.558f32) + (roughness * (rt::Scalar(-7.0899f32) + (roughness * rt::Scalar(4.2721f32)))));
        let b3_ = (rt::Scalar(0.1714f32) + (roughness * rt::Scalar(5.0718f32)));
        let rest_5 = (b0_ + (x_6 * (b1_ + (x_6 * (b2_ + (x_6 * (b3_ + (x_6 * rt::Scalar(-0.1958f32)))))))));
        let slant = (rt::Scalar(1f32) - cosine_3.min(rt::Scalar(1f32)));
        let squared = (slant * slant);
        let grazing = (((squared * squared) * slant) * rest_5);
        return <rt::Vec2<f32>>::from_scalars(all_1, grazing);
    }
    pub(crate) fn reflected_by(
        &self,
        once: impl rt::Into<rt::Vec2<f32>>,
        specular: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_reflected_by(rt::into(once), rt::into(specular)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_reflected_by(
        &self,
        once: rt::Vec2<f32>,
        specular: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let least = <rt::Vec3<f32>>::from_scalars(once.y(), once.y(), once.y());
        return (least + (specular * (once.x() - once.y()).max(rt::Scalar(0f32))));
    }
    pub(crate) fn shade_metallic_roughness_mirrored(
        &self,
        material_4: Material,
        mean_1: impl rt::Into<rt::Scalar<f32>>,
        cosine_4: impl rt::Into<rt::Scalar<f32>>,
        params_4: impl rt::Into<rt::Vec4<f32>>,
    ) -> Mirrored {
        rt::into(self.v_shade_metallic_roughness_mirrored(material_4, rt::into(mean_1), rt::into(cosine_4), rt::into(params_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shade_metallic_roughness_mirrored(
        &self,
        material_4: Material,
        mean_1: rt::Scalar<f32>,
        cosine_4: rt::Scalar<f32>,
        params_4: rt::Vec4<f32>,
    ) -> Mirrored {
        let white = <rt::Vec3<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32), rt::Scalar(1f32));
        let _e11 = self.v_facet_reflection(rt::Scalar(material_4.upright), rt::Scalar(material_4.alpha), rt::Scalar(material_4.roughness));
        let _e13 = self.v_reflected_by(_e11, material_4.specular);
        let part_17 = (_e13 * (white + (material_4.specular * rt::Scalar(material_4.again))));
        let alpha_2 = rt::Scalar(material_4.alpha);
        let turn_7 = (alpha_2 * rt::Scalar(material_4.roughness));
        return <Mirrored>::new(part_17, alpha_2, <rt::Vec2<f32>>::from_scalars((rt::Scalar(1.4f32) * alpha_2), (rt::Scalar(5.6f32) * alpha_2)), rt::Scalar(0.25f32), turn_7);
    }
    pub(crate) fn shade_mirrored_stage(
        &self,
        material_5: Material,
        mean_2: impl rt::Into<rt::Scalar<f32>>,
        cosine_5: impl rt::Into<rt::Scalar<f32>>,
    ) -> Mirrored {
        rt::into(self.v_shade_mirrored_stage(material_5, rt::into(mean_2), rt::into(cosine_5)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shade_mirrored_stage(
        &self,
        material_5: Material,
        mean_2: rt::Scalar<f32>,
        cosine_5: rt::Scalar<f32>,
    ) -> Mirrored {
        let _e7 = rt::Scalar(self.surface_settings.choices[8usize].number);
        match rt::Scalar::into_inner(_e7) {
            0u32 => {
                let _e12 = self.surface_settings.choices[8usize].params;
                let _e13 = self.v_shade_blinn_phong_mirrored(material_5, mean_2, cosine_5, _e12);
                return _e13;
            }
            _ => {
                let _e18 = self.surface_settings.choices[8usize].params;
                let _e19 = self.v_shade_metallic_roughness_mirrored(material_5, mean_2, cosine_5, _e18);
                return _e19;
            }
        }
    }
    pub(crate) fn levels_of(
        &self,
        footprint: impl rt::Into<rt::Scalar<f32>>,
        count: impl rt::Into<rt::Scalar<u32>>,
    ) -> Levels {
        rt::into(self.v_levels_of(rt::into(footprint), rt::into(count)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_levels_of(
        &self,
        footprint: rt::Scalar<f32>,
        count: rt::Scalar<u32>,
    ) -> Levels {
        let mut texels: rt::Scalar<f32>;
        let mut level_4: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut local_5: rt::Scalar<bool>;
        let mut local_6: rt::Scalar<bool>;

        texels = footprint;
        'naga_break: loop {
            'naga_continue: {
                let _e5 = texels;
                if rt::Scalar::into_branch_condition(_e5.elementwise_ge(rt::Scalar(2f32))) {
                    let _e10 = level_4;
                    local_5 = (_e10 + rt::Scalar(1u32)).elementwise_lt(count);
                } else {
                    local_5 = rt::Scalar(false);
                }
                let _e15 = local_5;
                if rt::Scalar::into_branch_condition(_e15) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e16 = texels;
                    texels = (_e16 * rt::Scalar(0.5f32));
                    let _e19 = level_4;
                    level_4 = (_e19 + rt::Scalar(1u32));
                }
            }
        }
        let _e22 = texels;
        if rt::Scalar::into_branch_condition(_e22.elementwise_gt(rt::Scalar(1f32))) {
            let _e27 = level_4;
            local_6 = (_e27 + rt::Scalar(1u32)).elementwise_lt(count);
        } else {
            local_6 = rt::Scalar(false);
        }
        let _e32 = local_6;
        if rt::Scalar::into_branch_condition(_e32) {
            let _e33 = level_4;
            let _e34 = texels;
            return <Levels>::new(_e33, (_e34 - rt::Scalar(1f32)));
        }
        let _e38 = level_4;
        return <Levels>::new(_e38, rt::Scalar(0f32));
    }
    pub(crate) fn face_place(&self, d: impl rt::Into<rt::Vec3<f32>>) -> FacePlace {
        rt::into(self.v_face_place(rt::into(d)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_face_place(&self, d: rt::Vec3<f32>) -> FacePlace {
        let mut local_7: rt::Scalar<bool>;

        let size_1 = d.abs();
        if rt::Scalar::into_branch_condition(size_1.x().elementwise_ge(size_1.y())) {
            local_7 = size_1.x().elementwise_ge(size_1.z());
        } else {
            local_7 = rt::Scalar(false);
        }
        let _e11 = local_7;
        if rt::Scalar::into_branch_condition(_e11) {
            if rt::Scalar::into_branch_condition(d.x().elementwise_gt(rt::Scalar(0f32))) {
                return <FacePlace>::new(rt::Scalar(0i32), (<rt::Vec2<f32>>::from_scalars((-d.z()), (-d.y())) / rt::Vec2::splat_from_scalar(size_1.x())));
            }
            return <FacePlace>::new(rt::Scalar(1i32), (<rt::Vec2<f32>>::from_scalars(d.z(), (-d.y())) / rt::Vec2::splat_from_scalar(size_1.x())));
        }
        if rt::Scalar::into_branch_condition(size_1.y().elementwise_ge(size_1.z())) {
            if rt::Scalar::into_branch_condition(d.y().elementwise_gt(rt::Scalar(0f32))) {
                return <FacePlace>::new(rt::Scalar(2i32), (<rt::Vec2<f32>>::from_scalars(d.x(), d.z()) / rt::Vec2::splat_from_scalar(size_1.y())));
            }
            return <FacePlace>::new(rt::Scalar(3i32), (<rt::Vec2<f32>>::from_scalars(d.x(), (-d.z())) / rt::Vec2::splat_from_scalar(size_1.y())));
        }
        if rt::Scalar::into_branch_condition(d.z().elementwise_gt(rt::Scalar(0f32))) {
            return <FacePlace>::new(rt::Scalar(4i32), (<rt::Vec2<f32>>::from_scalars(d.x(), (-d.y())) / rt::Vec2::splat_from_scalar(size_1.z())));
        }
        return <FacePlace>::new(rt::Scalar(5i32), (<rt::Vec2<f32>>::from_scalars((-d.x()), (-d.y())) / rt::Vec2::splat_from_scalar(size_1.z())));
    }
    pub(crate) fn environment_texel(
        &self,
        place_1: impl rt::Into<rt::Vec2<i32>>,
        face: impl rt::Into<rt::Scalar<i32>>,
        level_5: impl rt::Into<rt::Scalar<i32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_environment_texel(rt::into(place_1), rt::into(face), rt::into(level_5)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_environment_texel(
        &self,
        place_1: rt::Vec2<i32>,
        face: rt::Scalar<i32>,
        level_5: rt::Scalar<i32>,
    ) -> rt::Vec4<f32> {
        let _e4 = rt::texture::Read::read_texel((&self.environment_map), place_1, rt::Scalar::into_inner(face), 0i32, rt::Scalar::into_inner(level_5));
        let _e8 = self.surface_settings.maps[5usize];
        let _e9 = self.v_decoded(_e4, _e8);
        return _e9;
    }
    pub(crate) fn environment_of_level(
        &self,
        direction_2: impl rt::Into<rt::Vec3<f32>>,
        level_6: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_environment_of_level(rt::into(direction_2), rt::into(level_6)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_environment_of_level(
        &self,
        direction_2: rt::Vec3<f32>,
        level_6: rt::Scalar<u32>,
    ) -> rt::Vec3<f32> {
        let _e2 = self.v_face_place(direction_2);
        let _e5 = rt::Scalar(self.surface_settings.environment_side);
        let last_2 = ((_e5 >> level_6).to_i32().max(rt::Scalar(1i32)) - rt::Scalar(1i32));
        let point_23 = ((_e2.place + <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32))) * (rt::Scalar(0.5f32) * last_2.to_f32()));
        let most_4 = (last_2 - rt::Scalar(1i32)).max(rt::Scalar(0i32)).to_f32();
        let corner_4 = point_23.floor().clamp(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)), <rt::Vec2<f32>>::from_scalars(most_4, most_4));
        let texel_8 = corner_4.to_i32();
        let k_56 = level_6.to_i32();
        let _e35 = self.v_environment_texel(texel_8, rt::Scalar(_e2.face), k_56);
        let _e41 = self.v_environment_texel((texel_8 + <rt::Vec2<i32>>::from_scalars(rt::Scalar(1i32), rt::Scalar(0i32))), rt::Scalar(_e2.face), k_56);
        let _e47 = self.v_environment_texel((texel_8 + <rt::Vec2<i32>>::from_scalars(rt::Scalar(0i32), rt::Scalar(1i32))), rt::Scalar(_e2.face), k_56);
        let _e53 = self.v_environment_texel((texel_8 + <rt::Vec2<i32>>::from_scalars(rt::Scalar(1i32), rt::Scalar(1i32))), rt::Scalar(_e2.face), k_56);
        let _e55 = self.v_bilinear(_e35, _e41, _e47, _e53, (point_23 - corner_4));
        return _e55.xyz();
    }
    pub(crate) fn environment_in_lobe(
        &self,
        direction_3: impl rt::Into<rt::Vec3<f32>>,
        deviation: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_environment_in_lobe(rt::into(direction_3), rt::into(deviation)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_environment_in_lobe(
        &self,
        direction_3: rt::Vec3<f32>,
        deviation: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let _e5 = rt::Scalar(self.surface_settings.environment_levels);
        let width = (deviation * (rt::Scalar(1.2247449f32) * (rt::Scalar(1u32) << (_e5 - rt::Scalar(1u32))).to_f32()));
        let _e15 = rt::Scalar(self.surface_settings.environment_levels);
        let _e16 = self.v_levels_of(width, _e15);
        let _e18 = self.v_environment_of_level(direction_3, rt::Scalar(_e16.fine));
        if rt::Scalar::into_branch_condition(rt::Scalar(_e16.part).elementwise_gt(rt::Scalar(0f32))) {
            let _e25 = self.v_environment_of_level(direction_3, (rt::Scalar(_e16.fine) + rt::Scalar(1u32)));
            return (_e18 + ((_e25 - _e18) * rt::Scalar(_e16.part)));
        }
        return _e18;
    }
    pub(crate) fn environment_on(&self, normal_3: impl rt::Into<rt::Vec3<f32>>) -> rt::Vec3<f32> {
        rt::into(self.v_environment_on(rt::into(normal_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_environment_on(&self, normal_3: rt::Vec3<f32>) -> rt::Vec3<f32> {
        let _e3 = rt::Scalar(self.surface_settings.environment_levels);
        let _e6 = self.v_environment_of_level(normal_3, (_e3 - rt::Scalar(1u32)));
        return _e6;
    }
    pub(crate) fn ambient_environment(
        &self,
        at_8: Entered,
        hit_3: Hit,
        normal_4: impl rt::Into<rt::Vec3<f32>>,
        view_3: impl rt::Into<rt::Vec3<f32>>,
        material_6: Material,
        params_5: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_ambient_environment(at_8, hit_3, rt::into(normal_4), rt::into(view_3), material_6, rt::into(params_5)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_ambient_environment(
        &self,
        at_8: Entered,
        hit_3: Hit,
        normal_4: rt::Vec3<f32>,
        view_3: rt::Vec3<f32>,
        material_6: Material,
        params_5: rt::Vec4<f32>,
    ) -> rt::Vec3<f32> {
        let mut light: rt::Vec3<f32>;

        let mean_9 = normal_4.length();
        let n_17 = normal_4.normalize();
        let cosine_10 = n_17.dot(view_3).clamp(rt::Scalar(0f32), rt::Scalar(1f32));
        let _e12 = self.v_shade_mirrored_stage(material_6, mean_9, cosine_10);
        let reflected = ((n_17 * (rt::Scalar(2f32) * cosine_10)) - view_3);
        let axis_6 = (reflected + ((n_17 - reflected) * rt::Scalar(_e12.turn)));
        let _e23 = self.v_environment_in_lobe(axis_6, _e12.lobes.x());
        light = _e23;
        if rt::Scalar::into_branch_condition(rt::Scalar(_e12.second).elementwise_gt(rt::Scalar(0f32))) {
            let _e28 = light;
            let _e31 = self.v_environment_in_lobe(axis_6, _e12.lobes.y());
            let _e32 = light;
            light = (_e28 + ((_e31 - _e32) * rt::Scalar(_e12.second)));
        }
        let _e37 = light;
        light = (_e37 * _e12.part);
        let enters = (<rt::Vec3<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32), rt::Scalar(1f32)) - _e12.part);
        let _e46 = light;
        let _e47 = self.v_environment_on(n_17);
        light = (_e46 + ((_e47 * material_6.diffuse) * enters));
        let _e54 = rt::Scalar(self.surface_settings.transmission);
        if rt::Scalar::into_branch_condition(_e54.elementwise_gt(rt::Scalar(0f32))) {
            let _e59 = rt::Scalar(self.surface_settings.ior);
            let eta_1 = (rt::Scalar(1f32) / _e59);
            let _e63 = self.v_cosine_inside(cosine_10);
            let refracted = ((n_17 * ((eta_1 * cosine_10) - _e63)) - (view_3 * eta_1));
            let _e72 = self.v_environment_in_lobe(refracted, ((rt::Scalar(1f32) - eta_1) * rt::Scalar(_e12.lean)));
            let _e73 = light;
            light = (_e73 + (_e72 * (material_6.transmitted * enters)));
        }
        let _e78 = light;
        return (_e78 * params_5.x());
    }
    pub(crate) fn hemisphere_grade(
        &self,
        normal_5: impl rt::Into<rt::Vec3<f32>>,
        ground: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_hemisphere_grade(rt::into(normal_5), rt::into(ground)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_hemisphere_grade(
        &self,
        normal_5: rt::Vec3<f32>,
        ground: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        return (ground + ((rt::Scalar(1f32) - ground) * (rt::Scalar(0.5f32) + (rt::Scalar(0.5f32) * normal_5.y()))));
    }
    pub(crate) fn ambient_hemisphere(
        &self,
        at_9: Entered,
        hit_4: Hit,
        normal_6: impl rt::Into<rt::Vec3<f32>>,
        view_4: impl rt::Into<rt::Vec3<f32>>,
        material_7: Material,
        params_6: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_ambient_hemisphere(at_9, hit_4, rt::into(normal_6), rt::into(view_4), material_7, rt::into(params_6)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_ambient_hemisphere(
        &self,
        at_9: Entered,
        hit_4: Hit,
        normal_6: rt::Vec3<f32>,
        view_4: rt::Vec3<f32>,
        material_7: Material,
        params_6: rt::Vec4<f32>,
    ) -> rt::Vec3<f32> {
        let _e8 = self.frame.ambient;
        let _e13 = self.v_hemisphere_grade(normal_6, params_6.x());
        return ((_e8.xyz() * material_7.around) * _e13);
    }
    pub(crate) fn ambient_occlusion(
        &self,
        at_10: Entered,
        hit_5: Hit,
        normal_7: impl rt::Into<rt::Vec3<f32>>,
        view_5: impl rt::Into<rt::Vec3<f32>>,
        material_8: Material,
        params_7: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_ambient_occlusion(at_10, hit_5, rt::into(normal_7), rt::into(view_5), material_8, rt::into(params_7)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_ambient_occlusion(
        &self,
        at_10: Entered,
        hit_5: Hit,
        normal_7: rt::Vec3<f32>,
        view_5: rt::Vec3<f32>,
        material_8: Material,
        params_7: rt::Vec4<f32>,
    ) -> rt::Vec3<f32> {
        let _e8 = self.frame.ambient;
        let _e14 = self.v_ambient_texel_between(hit_5.uv, rt::Scalar(at_10.level));
        return ((_e8.xyz() * material_8.around) * _e14.x());
    }
    pub(crate) fn ambient_sky(
        &self,
        at_11: Entered,
        hit_6: Hit,
        normal_8: impl rt::Into<rt::Vec3<f32>>,
        view_6: impl rt::Into<rt::Vec3<f32>>,
        material_9: Material,
        params_8: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_ambient_sky(at_11, hit_6, rt::into(normal_8), rt::into(view_6), material_9, rt::into(params_8)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_ambient_sky(
        &self,
        at_11: Entered,
        hit_6: Hit,
        normal_8: rt::Vec3<f32>,
        view_6: rt::Vec3<f32>,
        material_9: Material,
        params_8: rt::Vec4<f32>,
    ) -> rt::Vec3<f32> {
        let _e8 = self.v_ambient_texel_between(hit_6.uv, rt::Scalar(at_11.level));
        let _e10 = self.v_from_tangent_space(at_11, _e8.xyz());
        let toward_8 = (rt::Scalar(0.5f32) * ((_e10 / rt::Vec3::splat_from_scalar(_e10.length().max(rt::Scalar(0.000001f32)))) + normal_8));
        let part_18 = normal_8.dot(_e10).max(rt::Scalar(0f32));
        let _e24 = self.frame.ambient;
        let _e29 = self.v_hemisphere_grade(toward_8, params_8.x());
        return ((_e24.xyz() * material_9.around) * (part_18 * _e29));
    }
    pub(crate) fn ambient_stage(
        &self,
        at_12: Entered,
        hit_7: Hit,
        normal_9: impl rt::Into<rt::Vec3<f32>>,
        view_7: impl rt::Into<rt::Vec3<f32>>,
        material_10: Material,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_ambient_stage(at_12, hit_7, rt::into(normal_9), rt::into(view_7), material_10))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_ambient_stage(
        &self,
        at_12: Entered,
        hit_7: Hit,
        normal_9: rt::Vec3<f32>,
        view_7: rt::Vec3<f32>,
        material_10: Material,
    ) -> rt::Vec3<f32> {
        let _e9 = rt::Scalar(self.surface_settings.choices[11usize].number);
        match rt::Scalar::into_inner(_e9) {
            0u32 => {
                let _e14 = self.surface_settings.choices[11usize].params;
                let _e15 = self.v_ambient_constant(at_12, hit_7, normal_9, view_7, material_10, _e14);
                return _e15;
            }
            1u32 => {
                let _e20 = self.surface_settings.choices[11usize].params;
                let _e21 = self.v_ambient_occlusion(at_12, hit_7, normal_9, view_7, material_10, _e20);
                return _e21;
            }
            2u32 => {
                let _e26 = self.surface_settings.choices[11usize].params;
                let _e27 = self.v_ambient_bent_normal(at_12, hit_7, normal_9, view_7, material_10, _e26);
                return _e27;
            }
            3u32 => {
                let _e32 = self.surface_settings.choices[11usize].params;
                let _e33 = self.v_ambient_bounce(at_12, hit_7, normal_9, view_7, material_10, _e32);
                return _e33;
            }
            4u32 => {
                let _e38 = self.surface_settings.choices[11usize].params;
                let _e39 = self.v_ambient_environment(at_12, hit_7, normal_9, view_7, material_10, _e38);
                return _e39;
            }
            5u32 => {
                let _e44 = self.surface_settings.choices[11usize].params;
                let _e45 = self.v_ambient_hemisphere(at_12, hit_7, normal_9, view_7, material_10, _e44);
                return _e45;
            }
            _ => {
                let _e50 = self.surface_settings.choices[11usize].params;
                let _e51 = self.v_ambient_sky(at_12, hit_7, normal_9, view_7, material_10, _e50);
                return _e51;
            }
        }
    }
    pub(crate) fn toward_image(
        &self,
        image: Image,
        point_1: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_toward_image(image, rt::into(point_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_toward_image(
        &self,
        image: Image,
        point_1: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        if rt::Scalar::into_branch_condition(rt::Scalar(image.has_eye)) {
            return (image.eye - point_1).normalize();
        }
        return image.toward;
    }
    pub(crate) fn eighth_turn(&self, tangent: impl rt::Into<rt::Scalar<f32>>) -> f32 {
        rt::into(self.v_eighth_turn(rt::into(tangent)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_eighth_turn(&self, tangent: rt::Scalar<f32>) -> rt::Scalar<f32> {
        let s_1 = (tangent * tangent);
        let series = (rt::Scalar(0.999866f32) + (s_1 * (rt::Scalar(-0.3302995f32) + (s_1 * (rt::Scalar(0.180141f32) + (s_1 * (rt::Scalar(-0.085133f32) + (s_1 * rt::Scalar(0.0208351f32)))))))));
        return ((tangent * series) * rt::Scalar(0.15915494f32));
    }
    pub(crate) fn turn_of(&self, v: impl rt::Into<rt::Vec2<f32>>) -> f32 {
        rt::into(self.v_turn_of(rt::into(v)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_turn_of(&self, v: rt::Vec2<f32>) -> rt::Scalar<f32> {
        let mut turn: rt::Scalar<f32>;

        let x_7 = v.x().abs();
        let y_1 = v.y().abs();
        if rt::Scalar::into_branch_condition((!(x_7 + y_1).elementwise_gt(rt::Scalar(0f32)))) {
            return rt::Scalar(0f32);
        }
        let _e13 = self.v_eighth_turn((x_7.min(y_1) / x_7.max(y_1)));
        turn = _e13;
        if rt::Scalar::into_branch_condition(y_1.elementwise_gt(x_7)) {
            let _e16 = turn;
            turn = (rt::Scalar(0.25f32) - _e16);
        }
        if rt::Scalar::into_branch_condition(v.x().elementwise_lt(rt::Scalar(0f32))) {
            let _e22 = turn;
            turn = (rt::Scalar(0.5f32) - _e22);
        }
        if rt::Scalar::into_branch_condition(v.y().elementwise_lt(rt::Scalar(0f32))) {
            let _e28 = turn;
            turn = (rt::Scalar(1f32) - _e28);
        }
        let _e31 = turn;
        let _e32 = turn;
        return _e31.select(rt::Scalar(0f32), _e32.elementwise_ge(rt::Scalar(1f32)));
    }
    pub(crate) fn depth_in_image(
        &self,
        image_1: Image,
        point_2: impl rt::Into<rt::Vec3<f32>>,
    ) -> f32 {
        rt::into(self.v_depth_in_image(image_1, rt::into(point_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_depth_in_image(
        &self,
        image_1: Image,
        point_2: rt::Vec3<f32>,
    ) -> rt::Scalar<f32> {
        return (image_1.depth.xyz().dot(point_2) + image_1.depth.w());
    }
    pub(crate) fn place_in_image(
        &self,
        image_2: Image,
        point_3: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_place_in_image(image_2, rt::into(point_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_place_in_image(
        &self,
        image_2: Image,
        point_3: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let _e2 = self.v_depth_in_image(image_2, point_3);
        let u = ((image_2.u.xyz().dot(point_3) + image_2.u.w()) / _e2).clamp(rt::Scalar(0f32), rt::Scalar(1f32));
        let v_3 = ((image_2.v.xyz().dot(point_3) + image_2.v.w()) / _e2).clamp(rt::Scalar(0f32), rt::Scalar(1f32));
        let h_5 = ((image_2.height.xyz().dot(point_3) + image_2.height.w()) / _e2);
        return <rt::Vec3<f32>>::new_21((image_2.corner + (image_2.extent * <rt::Vec2<f32>>::from_scalars(u, v_3))), h_5);
    }
    pub(crate) fn tangent_of_image(&self, image_3: Image) -> rt::Vec3<f32> {
        rt::into(self.v_tangent_of_image(image_3))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_tangent_of_image(&self, image_3: Image) -> rt::Vec3<f32> {
        let across_2 = (image_3.u.xyz() - (rt::Scalar(0.5f32) * image_3.depth.xyz()));
        return (across_2 / rt::Vec3::splat_from_scalar((across_2.dot(across_2) * image_3.extent.x())));
    }
    pub(crate) fn stretch_in_image(
        &self,
        image_4: Image,
        point_4: impl rt::Into<rt::Vec3<f32>>,
        height: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_stretch_in_image(image_4, rt::into(point_4), rt::into(height)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_stretch_in_image(
        &self,
        image_4: Image,
        point_4: rt::Vec3<f32>,
        height: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        if rt::Scalar::into_branch_condition((!rt::Scalar(image_4.has_eye))) {
            return rt::Scalar(1f32);
        }
        let _e6 = self.v_toward_image(image_4, point_4);
        let change_2 = (image_4.height.xyz().dot(_e6) - (height * image_4.depth.xyz().dot(_e6)));
        let _e15 = self.v_depth_in_image(image_4, point_4);
        let _e18 = rt::Scalar(self.surface_settings.scale_m);
        return (_e15 / (change_2 * _e18));
    }
    pub(crate) fn height_size(&self, level_7: impl rt::Into<rt::Scalar<u32>>) -> rt::Vec2<f32> {
        rt::into(self.v_height_size(rt::into(level_7)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_height_size(&self, level_7: rt::Scalar<u32>) -> rt::Vec2<f32> {
        let _e1 = self.v_height_texels(level_7);
        return _e1.to_f32();
    }
    pub(crate) fn wrapped_cell(
        &self,
        cell: impl rt::Into<rt::Vec2<i32>>,
        level_8: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_wrapped_cell(rt::into(cell), rt::into(level_8)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_wrapped_cell(
        &self,
        cell: rt::Vec2<i32>,
        level_8: rt::Scalar<u32>,
    ) -> rt::Vec4<f32> {
        let _e2 = self.v_height_texels(level_8);
        let k_57 = level_8.to_i32();
        let _e6 = self.v_wrap_pair(cell.x(), _e2.x());
        let _e9 = self.v_wrap_pair(cell.y(), _e2.y());
        let _e14 = rt::texture::Read::read_texel((&self.height_map), <rt::Vec2<i32>>::from_scalars(_e6.x(), _e9.x()), 0i32, 0i32, rt::Scalar::into_inner(k_57));
        let _e20 = rt::texture::Read::read_texel((&self.height_map), <rt::Vec2<i32>>::from_scalars(_e6.y(), _e9.x()), 0i32, 0i32, rt::Scalar::into_inner(k_57));
        let _e26 = rt::texture::Read::read_texel((&self.height_map), <rt::Vec2<i32>>::from_scalars(_e6.x(), _e9.y()), 0i32, 0i32, rt::Scalar::into_inner(k_57));
        let _e32 = rt::texture::Read::read_texel((&self.height_map), <rt::Vec2<i32>>::from_scalars(_e6.y(), _e9.y()), 0i32, 0i32, rt::Scalar::into_inner(k_57));
        return <rt::Vec4<f32>>::from_scalars(_e14.x(), _e20.x(), _e26.x(), _e32.x());
    }
    pub(crate) fn height_cell(
        &self,
        cell_1: impl rt::Into<rt::Vec2<i32>>,
        level_9: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_height_cell(rt::into(cell_1), rt::into(level_9)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_height_cell(
        &self,
        cell_1: rt::Vec2<i32>,
        level_9: rt::Scalar<u32>,
    ) -> rt::Vec4<f32> {
        let _e2 = self.v_wrapped_cell(cell_1, level_9);
        return _e2;
    }
    pub(crate) fn height_at(
        &self,
        uv_2: impl rt::Into<rt::Vec2<f32>>,
        level_10: impl rt::Into<rt::Scalar<u32>>,
    ) -> f32 {
        rt::into(self.v_height_at(rt::into(uv_2), rt::into(level_10)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_height_at(
        &self,
        uv_2: rt::Vec2<f32>,
        level_10: rt::Scalar<u32>,
    ) -> rt::Scalar<f32> {
        let _e2 = self.v_height_size(level_10);
        let point_24 = ((uv_2 * _e2) - <rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32)));
        let _e8 = self.v_cell_of(point_24);
        let f = (point_24 - _e8);
        let _e11 = self.v_height_cell(_e8.to_i32(), level_10);
        let top_2 = (_e11.x() + ((_e11.y() - _e11.x()) * f.x()));
        let bottom_1 = (_e11.z() + ((_e11.w() - _e11.z()) * f.x()));
        return (top_2 + ((bottom_1 - top_2) * f.y()));
    }
    pub(crate) fn angle_to_image(
        &self,
        image_5: Image,
        point_5: impl rt::Into<rt::Vec3<f32>>,
        view_8: impl rt::Into<rt::Vec3<f32>>,
        asked: impl rt::Into<rt::Scalar<bool>>,
    ) -> f32 {
        rt::into(self.v_angle_to_image(image_5, rt::into(point_5), rt::into(view_8), rt::into(asked)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_angle_to_image(
        &self,
        image_5: Image,
        point_5: rt::Vec3<f32>,
        view_8: rt::Vec3<f32>,
        asked: rt::Scalar<bool>,
    ) -> rt::Scalar<f32> {
        let _e4 = self.v_toward_image(image_5, point_5);
        let beside_3 = _e4.cross(view_8);
        let _e10 = self.v_turn_of(<rt::Vec2<f32>>::from_scalars(_e4.dot(view_8), beside_3.dot(beside_3).sqrt()));
        if rt::Scalar::into_branch_condition((!asked)) {
            return _e10;
        }
        let _e12 = self.v_place_in_image(image_5, point_5);
        let _e18 = self.surface_settings.height_size.x();
        let width_1 = (image_5.extent.x() * _e18.to_f32());
        let _e21 = self.v_tangent_of_image(image_5);
        let _e26 = self.v_depth_in_image(image_5, point_5);
        let wider = ((_e21.length() * image_5.extent.x()) * _e26);
        let _e29 = self.v_stretch_in_image(image_5, point_5, _e12.z());
        let _e32 = rt::Scalar(self.surface_settings.scale_m);
        let deeper = (_e29 * _e32);
        let _e37 = self.v_height_at(_e12.xy(), rt::Scalar(0u32));
        let off_1 = (_e12.z() - _e37).abs();
        return (_e10 + rt::Scalar(2f32).select(rt::Scalar(0f32), ((off_1 * width_1) * (deeper / wider)).elementwise_le(rt::Scalar(2f32))));
    }
    pub(crate) fn apart_from_edge(
        &self,
        place_2: impl rt::Into<rt::Vec3<f32>>,
        a_1: impl rt::Into<rt::Vec3<f32>>,
        b_1: impl rt::Into<rt::Vec3<f32>>,
    ) -> f32 {
        rt::into(self.v_apart_from_edge(rt::into(place_2), rt::into(a_1), rt::into(b_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_apart_from_edge(
        &self,
        place_2: rt::Vec3<f32>,
        a_1: rt::Vec3<f32>,
        b_1: rt::Vec3<f32>,
    ) -> rt::Scalar<f32> {
        let way_27 = (b_1 - a_1);
        let part_19 = ((place_2 - a_1).dot(way_27) / way_27.dot(way_27)).clamp(rt::Scalar(0f32), rt::Scalar(1f32));
        let apart = ((a_1 + (way_27 * part_19)) - place_2);
        return apart.dot(apart);
    }
    pub(crate) fn weights_under(
        &self,
        place_3: impl rt::Into<rt::Vec3<f32>>,
        a_2: impl rt::Into<rt::Vec3<f32>>,
        b_2: impl rt::Into<rt::Vec3<f32>>,
        c_2: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_weights_under(rt::into(place_3), rt::into(a_2), rt::into(b_2), rt::into(c_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_weights_under(
        &self,
        place_3: rt::Vec3<f32>,
        a_2: rt::Vec3<f32>,
        b_2: rt::Vec3<f32>,
        c_2: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let normal_28 = (b_2 - a_2).cross((c_2 - a_2));
        return <rt::Vec3<f32>>::from_scalars((c_2 - b_2).cross((place_3 - b_2)).dot(normal_28), (a_2 - c_2).cross((place_3 - c_2)).dot(normal_28), (b_2 - a_2).cross((place_3 - a_2)).dot(normal_28));
    }
    pub(crate) fn apart_from_triangle(
        &self,
        place_4: impl rt::Into<rt::Vec3<f32>>,
        a_3: impl rt::Into<rt::Vec3<f32>>,
        b_3: impl rt::Into<rt::Vec3<f32>>,
        c_3: impl rt::Into<rt::Vec3<f32>>,
    ) -> f32 {
        rt::into(self.v_apart_from_triangle(rt::into(place_4), rt::into(a_3), rt::into(b_3), rt::into(c_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_apart_from_triangle(
        &self,
        place_4: rt::Vec3<f32>,
        a_3: rt::Vec3<f32>,
        b_3: rt::Vec3<f32>,
        c_3: rt::Vec3<f32>,
    ) -> rt::Scalar<f32> {
        let _e4 = self.v_weights_under(place_4, a_3, b_3, c_3);
        if rt::Scalar::into_branch_condition(_e4.x().min(_e4.y()).min(_e4.z()).elementwise_ge(rt::Scalar(0f32))) {
            let normal_29 = (b_3 - a_3).cross((c_3 - a_3));
            let above_4 = (place_4 - a_3).dot(normal_29);
            return ((above_4 * above_4) / normal_29.dot(normal_29));
        }
        let _e20 = self.v_apart_from_edge(place_4, a_3, b_3);
        let _e21 = self.v_apart_from_edge(place_4, b_3, c_3);
        let first_13 = _e20.min(_e21);
        let _e23 = self.v_apart_from_edge(place_4, c_3, a_3);
        return first_13.min(_e23);
    }
    pub(crate) fn around_three(
        &self,
        place_5: impl rt::Into<rt::Scalar<u32>>,
        on: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_around_three(rt::into(place_5), rt::into(on)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_around_three(
        &self,
        place_5: rt::Scalar<u32>,
        on: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        return ((place_5 + on) % rt::Scalar(3u32));
    }
    pub(crate) fn near_uv(&self, uv_3: impl rt::Into<rt::Vec2<f32>>) -> rt::Vec2<f32> {
        rt::into(self.v_near_uv(rt::into(uv_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_near_uv(&self, uv_3: rt::Vec2<f32>) -> rt::Vec2<f32> {
        let _e3 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e3.elementwise_eq(WRAP_REPEAT)) {
            return (uv_3 - uv_3.floor());
        }
        let _e10 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e10.elementwise_eq(WRAP_MIRROR)) {
            return (uv_3 - (rt::Scalar(2f32) * (rt::Scalar(0.5f32) * uv_3).floor()));
        }
        return uv_3;
    }
    pub(crate) fn inside_unit(
        &self,
        x0_: impl rt::Into<rt::Scalar<f32>>,
        dx_1: impl rt::Into<rt::Scalar<f32>>,
        interval: impl rt::Into<rt::Vec2<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_inside_unit(rt::into(x0_), rt::into(dx_1), rt::into(interval)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_inside_unit(
        &self,
        x0_: rt::Scalar<f32>,
        dx_1: rt::Scalar<f32>,
        interval: rt::Vec2<f32>,
    ) -> rt::Vec2<f32> {
        let mut local_8: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition(dx_1.elementwise_eq(rt::Scalar(0f32))) {
            if rt::Scalar::into_branch_condition((!x0_.elementwise_lt(rt::Scalar(0f32)))) {
                local_8 = x0_.elementwise_gt(rt::Scalar(1f32));
            } else {
                local_8 = rt::Scalar(true);
            }
            let _e13 = local_8;
            if rt::Scalar::into_branch_condition(_e13) {
                return <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(-1f32));
            }
            return interval;
        }
        let a_32 = ((rt::Scalar(0f32) - x0_) / dx_1);
        let b_33 = ((rt::Scalar(1f32) - x0_) / dx_1);
        return <rt::Vec2<f32>>::from_scalars(interval.x().max(a_32.min(b_33)), interval.y().min(a_32.max(b_33)));
    }
    pub(crate) fn power_of_half(&self, exponent: impl rt::Into<rt::Scalar<u32>>) -> f32 {
        rt::into(self.v_power_of_half(rt::into(exponent)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_power_of_half(&self, exponent: rt::Scalar<u32>) -> rt::Scalar<f32> {
        let mut power: rt::Scalar<f32>;

        power = rt::Scalar(1f32).select(rt::Scalar(0.5f32), (exponent & rt::Scalar(1u32)).elementwise_ne(rt::Scalar(0u32)));
        let _e9 = power;
        power = (_e9 * rt::Scalar(1f32).select(rt::Scalar(0.25f32), (exponent & rt::Scalar(2u32)).elementwise_ne(rt::Scalar(0u32))));
        let _e18 = power;
        power = (_e18 * rt::Scalar(1f32).select(rt::Scalar(0.0625f32), (exponent & rt::Scalar(4u32)).elementwise_ne(rt::Scalar(0u32))));
        let _e27 = power;
        power = (_e27 * rt::Scalar(1f32).select(rt::Scalar(0.00390625f32), (exponent & rt::Scalar(8u32)).elementwise_ne(rt::Scalar(0u32))));
        let _e36 = power;
        power = (_e36 * rt::Scalar(1f32).select(rt::Scalar(0.000015258789f32), (exponent & rt::Scalar(16u32)).elementwise_ne(rt::Scalar(0u32))));
        let _e45 = power;
        power = (_e45 * rt::Scalar(1f32).select(rt::Scalar(0.00000000023283064f32), (exponent & rt::Scalar(32u32)).elementwise_ne(rt::Scalar(0u32))));
        let _e54 = power;
        return (_e54 * rt::Scalar(1f32).select(rt::Scalar(0.00000000000000000005421011f32), (exponent & rt::Scalar(64u32)).elementwise_ne(rt::Scalar(0u32))));
    }
    pub(crate) fn transmittance_of(&self, depth_5: impl rt::Into<rt::Scalar<f32>>) -> f32 {
        rt::into(self.v_transmittance_of(rt::into(depth_5)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_transmittance_of(&self, depth_5: rt::Scalar<f32>) -> rt::Scalar<f32> {
        if rt::Scalar::into_branch_condition((!depth_5.elementwise_lt(rt::Scalar(80f32)))) {
            return rt::Scalar(0f32);
        }
        let twos = (depth_5.max(rt::Scalar(0f32)) * rt::Scalar(1.442695f32));
        let whole = (twos + rt::Scalar(0.5f32)).floor();
        let f_1 = (whole - twos);
        let high_3 = (rt::Scalar(0.009618129f32) + (f_1 * (rt::Scalar(0.0013333558f32) + (f_1 * (rt::Scalar(0.0001540353f32) + (f_1 * rt::Scalar(0.000015252734f32)))))));
        let power_1 = (rt::Scalar(1f32) + (f_1 * (rt::Scalar(0.6931472f32) + (f_1 * (rt::Scalar(0.2402265f32) + (f_1 * (rt::Scalar(0.05550411f32) + (f_1 * high_3))))))));
        let _e36 = self.v_power_of_half(whole.to_u32());
        return (power_1 * _e36);
    }
    pub(crate) fn volume_size(&self) -> rt::Vec3<f32> {
        rt::into(self.v_volume_size())
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_volume_size(&self) -> rt::Vec3<f32> {
        let _e2 = self.surface_settings.volume;
        return _e2.xyz().to_f32();
    }
    pub(crate) fn voxel_path(&self, path: Path) -> VoxelPath {
        rt::into(self.v_voxel_path(path))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_voxel_path(&self, path: Path) -> VoxelPath {
        let _e1 = self.v_volume_size();
        return <VoxelPath>::new(((<rt::Vec3<f32>>::new_21(path.uv, path.h.x()) * _e1) - <rt::Vec3<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32), rt::Scalar(0.5f32))), (<rt::Vec3<f32>>::new_21(path.duv, path.h.y()) * _e1), (path.h.z() * _e1.z()));
    }
    pub(crate) fn turning_point(&self, way: VoxelPath) -> f32 {
        rt::into(self.v_turning_point(way))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_turning_point(&self, way: VoxelPath) -> rt::Scalar<f32> {
        if rt::Scalar::into_branch_condition(rt::Scalar(way.bend).elementwise_eq(rt::Scalar(0f32))) {
            return rt::Scalar(300000000000000000000000000000000000000f32);
        }
        let t_49 = ((rt::Scalar(0f32) - way.step.z()) / (rt::Scalar(2f32) * rt::Scalar(way.bend)));
        return rt::Scalar(300000000000000000000000000000000000000f32).select(t_49, t_49.elementwise_gt(rt::Scalar(0f32)));
    }
    pub(crate) fn search_texel(
        &self,
        path_1: Path,
        place_6: impl rt::Into<rt::Vec2<i32>>,
        layer_1: impl rt::Into<rt::Scalar<i32>>,
        level_11: impl rt::Into<rt::Scalar<i32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_search_texel(path_1, rt::into(place_6), rt::into(layer_1), rt::into(level_11)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_search_texel(
        &self,
        path_1: Path,
        place_6: rt::Vec2<i32>,
        layer_1: rt::Scalar<i32>,
        level_11: rt::Scalar<i32>,
    ) -> rt::Vec4<f32> {
        if rt::Scalar::into_branch_condition(rt::Scalar(path_1.ray).elementwise_eq(RAY_SHADOW)) {
            let texel_9 = rt::texture::Read::read_texel((&self.shadow_search_map), place_6, rt::Scalar::into_inner(layer_1), 0i32, rt::Scalar::into_inner(level_11));
            let _e12 = self.surface_settings.maps[2usize];
            let _e13 = self.v_decoded(texel_9, _e12);
            return _e13;
        }
        let _e15 = rt::texture::Read::read_texel((&self.search_map), place_6, rt::Scalar::into_inner(layer_1), 0i32, rt::Scalar::into_inner(level_11));
        let _e19 = self.surface_settings.maps[1usize];
        let _e20 = self.v_decoded(_e15, _e19);
        return _e20;
    }
    pub(crate) fn slice_begin(&self, slice: impl rt::Into<rt::Scalar<i32>>) -> rt::Vec2<i32> {
        rt::into(self.v_slice_begin(rt::into(slice)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_slice_begin(&self, slice: rt::Scalar<i32>) -> rt::Vec2<i32> {
        let _e3 = self.surface_settings.volume;
        let size_2 = _e3.xyz().to_i32();
        let _e9 = self.surface_settings.volume.w();
        let in_row = _e9.to_i32();
        let k_58 = slice.clamp(rt::Scalar(0i32), (size_2.z() - rt::Scalar(1i32)));
        let row_9 = ((k_58.to_f32() + rt::Scalar(0.5f32)) / in_row.to_f32()).to_i32();
        return <rt::Vec2<i32>>::from_scalars(((k_58 - (row_9 * in_row)) * size_2.x()), (row_9 * size_2.y()));
    }
    pub(crate) fn continued_index(
        &self,
        i_3: impl rt::Into<rt::Scalar<i32>>,
        n_5: impl rt::Into<rt::Scalar<i32>>,
        wrap_1: impl rt::Into<rt::Scalar<u32>>,
    ) -> i32 {
        rt::into(self.v_continued_index(rt::into(i_3), rt::into(n_5), rt::into(wrap_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_continued_index(
        &self,
        i_3: rt::Scalar<i32>,
        n_5: rt::Scalar<i32>,
        wrap_1: rt::Scalar<u32>,
    ) -> rt::Scalar<i32> {
        let mut local_9: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition(wrap_1.elementwise_eq(WRAP_CLAMP)) {
            return i_3.clamp(rt::Scalar(0i32), (n_5 - rt::Scalar(1i32)));
        }
        if rt::Scalar::into_branch_condition(i_3.elementwise_ge(rt::Scalar(0i32))) {
            local_9 = i_3.elementwise_lt(n_5);
        } else {
            local_9 = rt::Scalar(false);
        }
        let _e15 = local_9;
        if rt::Scalar::into_branch_condition(_e15) {
            return i_3;
        }
        let period_2 = (rt::Scalar(2i32) * n_5).select(n_5, wrap_1.elementwise_eq(WRAP_REPEAT));
        let rest_6 = (i_3 % period_2);
        let _e26 = self.v_unfolded(rest_6.select((rest_6 + period_2), rest_6.elementwise_lt(rt::Scalar(0i32))), n_5, period_2);
        return _e26;
    }
    pub(crate) fn wrap_index(
        &self,
        i_4: impl rt::Into<rt::Scalar<i32>>,
        n_6: impl rt::Into<rt::Scalar<i32>>,
    ) -> i32 {
        rt::into(self.v_wrap_index(rt::into(i_4), rt::into(n_6)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_wrap_index(
        &self,
        i_4: rt::Scalar<i32>,
        n_6: rt::Scalar<i32>,
    ) -> rt::Scalar<i32> {
        let _e4 = rt::Scalar(self.surface_settings.wrap);
        let _e5 = self.v_continued_index(i_4, n_6, _e4);
        return _e5;
    }
    pub(crate) fn wrap_cell(
        &self,
        i_5: impl rt::Into<rt::Scalar<i32>>,
        n_7: impl rt::Into<rt::Scalar<i32>>,
    ) -> i32 {
        rt::into(self.v_wrap_cell(rt::into(i_5), rt::into(n_7)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_wrap_cell(
        &self,
        i_5: rt::Scalar<i32>,
        n_7: rt::Scalar<i32>,
    ) -> rt::Scalar<i32> {
        let _e4 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e4.elementwise_eq(WRAP_REPEAT)) {
            let _e7 = self.v_wrap_index(i_5, n_7);
            return _e7;
        }
        let _e8 = self.v_wrap_pair(i_5, n_7);
        return _e8.x().min(_e8.y());
    }
    pub(crate) fn voxel_texel(&self, cell_2: impl rt::Into<rt::Vec3<i32>>) -> rt::Vec2<i32> {
        rt::into(self.v_voxel_texel(rt::into(cell_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_voxel_texel(&self, cell_2: rt::Vec3<i32>) -> rt::Vec2<i32> {
        let _e3 = self.surface_settings.volume;
        let size_3 = _e3.xyz().to_i32();
        let _e7 = self.v_slice_begin(cell_2.z());
        let _e10 = self.v_wrap_cell(cell_2.x(), size_3.x());
        let _e13 = self.v_wrap_cell(cell_2.y(), size_3.y());
        return (_e7 + <rt::Vec2<i32>>::from_scalars(_e10, _e13));
    }
    pub(crate) fn rises_on(
        &self,
        way_1: VoxelPath,
        has_turned: impl rt::Into<rt::Scalar<bool>>,
    ) -> bool {
        rt::into(self.v_rises_on(way_1, rt::into(has_turned)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_rises_on(
        &self,
        way_1: VoxelPath,
        has_turned: rt::Scalar<bool>,
    ) -> rt::Scalar<bool> {
        let mut local_10: rt::Scalar<bool>;
        let mut local_11: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition(has_turned) {
            return rt::Scalar(way_1.bend).elementwise_gt(rt::Scalar(0f32));
        }
        if rt::Scalar::into_branch_condition((!way_1.step.z().elementwise_gt(rt::Scalar(0f32)))) {
            if rt::Scalar::into_branch_condition(way_1.step.z().elementwise_eq(rt::Scalar(0f32))) {
                local_11 = rt::Scalar(way_1.bend).elementwise_gt(rt::Scalar(0f32));
            } else {
                local_11 = rt::Scalar(false);
            }
            let _e22 = local_11;
            local_10 = _e22;
        } else {
            local_10 = rt::Scalar(true);
        }
        let _e24 = local_10;
        return _e24;
    }
    pub(crate) fn meets_plane(
        &self,
        way_2: VoxelPath,
        plane: impl rt::Into<rt::Scalar<f32>>,
        rises: impl rt::Into<rt::Scalar<bool>>,
        has_turned_1: impl rt::Into<rt::Scalar<bool>>,
    ) -> f32 {
        rt::into(self.v_meets_plane(way_2, rt::into(plane), rt::into(rises), rt::into(has_turned_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_meets_plane(
        &self,
        way_2: VoxelPath,
        plane: rt::Scalar<f32>,
        rises: rt::Scalar<bool>,
        has_turned_1: rt::Scalar<bool>,
    ) -> rt::Scalar<f32> {
        let gap_1 = (plane - way_2.origin.z());
        let discriminant_2 = ((way_2.step.z() * way_2.step.z()) + ((rt::Scalar(4f32) * rt::Scalar(way_2.bend)) * gap_1));
        if rt::Scalar::into_branch_condition((!discriminant_2.elementwise_ge(rt::Scalar(0f32)))) {
            return rt::Scalar(300000000000000000000000000000000000000f32);
        }
        let root_3 = (rt::Scalar(0f32) - discriminant_2.sqrt()).select(discriminant_2.sqrt(), rises);
        if rt::Scalar::into_branch_condition(has_turned_1) {
            return ((root_3 - way_2.step.z()) / (rt::Scalar(2f32) * rt::Scalar(way_2.bend)));
        }
        let both_1 = (way_2.step.z() + root_3);
        return rt::Scalar(300000000000000000000000000000000000000f32).select(((rt::Scalar(2f32) * gap_1) / both_1), both_1.elementwise_ne(rt::Scalar(0f32)));
    }
    pub(crate) fn voxel_leave(
        &self,
        way_3: VoxelPath,
        cell_3: impl rt::Into<rt::Vec3<f32>>,
        reach: impl rt::Into<rt::Scalar<f32>>,
        has_turned_2: impl rt::Into<rt::Scalar<bool>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_voxel_leave(way_3, rt::into(cell_3), rt::into(reach), rt::into(has_turned_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_voxel_leave(
        &self,
        way_3: VoxelPath,
        cell_3: rt::Vec3<f32>,
        reach: rt::Scalar<f32>,
        has_turned_2: rt::Scalar<bool>,
    ) -> rt::Vec3<f32> {
        let none = <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32));
        let last_3 = <rt::Vec2<f32>>::from_scalars((rt::Scalar(1f32) + reach), (rt::Scalar(1f32) + reach));
        let ahead = (cell_3.xy() + <rt::Vec2<f32>>::from_scalars((rt::Scalar(0f32) - reach), (rt::Scalar(0f32) - reach)).select(last_3, way_3.step.xy().elementwise_gt(none)));
        let beside_4 = ((ahead - way_3.origin.xy()) / way_3.step.xy());
        let across_3 = <rt::Vec2<f32>>::from_scalars(rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32)).select(beside_4, way_3.step.xy().abs().elementwise_gt(none));
        let _e37 = self.v_rises_on(way_3, has_turned_2);
        let plane_2 = (cell_3.z() + (rt::Scalar(0f32) - reach).select((rt::Scalar(1f32) + reach), _e37));
        let _e45 = self.v_meets_plane(way_3, plane_2, _e37, has_turned_2);
        return <rt::Vec3<f32>>::new_21(across_3, _e45);
    }
    pub(crate) fn part_from(
        &self,
        path_2: Path,
        way_4: VoxelPath,
        turn_1: impl rt::Into<rt::Scalar<f32>>,
        cell_4: impl rt::Into<rt::Vec3<f32>>,
        begin: impl rt::Into<rt::Scalar<f32>>,
        past_turn: impl rt::Into<rt::Scalar<u32>>,
    ) -> CellPart {
        rt::into(self.v_part_from(path_2, way_4, rt::into(turn_1), rt::into(cell_4), rt::into(begin), rt::into(past_turn)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_part_from(
        &self,
        path_2: Path,
        way_4: VoxelPath,
        turn_1: rt::Scalar<f32>,
        cell_4: rt::Vec3<f32>,
        begin: rt::Scalar<f32>,
        past_turn: rt::Scalar<u32>,
    ) -> CellPart {
        let _e7 = self.v_voxel_texel(cell_4.to_i32());
        let _e10 = self.v_search_texel(path_2, _e7, rt::Scalar(0i32), rt::Scalar(0i32));
        let empty = (_e10.x() - rt::Scalar(1f32));
        let _e18 = self.v_voxel_leave(way_4, cell_4, empty.max(rt::Scalar(0f32)), past_turn.elementwise_eq(rt::Scalar(1u32)));
        let side_5 = _e18.x().min(_e18.y()).min(_e18.z());
        let last_4 = turn_1.min(rt::Scalar(path_2.exit)).select(rt::Scalar(path_2.exit), past_turn.elementwise_eq(rt::Scalar(1u32)));
        let end_5 = side_5.min(last_4).max(begin);
        return <CellPart>::new(cell_4, begin, end_5, _e18, empty, past_turn, rt::Scalar(0u32).select(rt::Scalar(1u32), end_5.elementwise_ge(rt::Scalar(path_2.exit))));
    }
    pub(crate) fn voxel_place_on(
        &self,
        way_5: VoxelPath,
        t_4: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_voxel_place_on(way_5, rt::into(t_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_voxel_place_on(
        &self,
        way_5: VoxelPath,
        t_4: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        return (way_5.origin + ((way_5.step + <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), (rt::Scalar(way_5.bend) * t_4))) * t_4));
    }
    pub(crate) fn first_part(
        &self,
        path_3: Path,
        way_6: VoxelPath,
        turn_2: impl rt::Into<rt::Scalar<f32>>,
    ) -> CellPart {
        rt::into(self.v_first_part(path_3, way_6, rt::into(turn_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_first_part(
        &self,
        path_3: Path,
        way_6: VoxelPath,
        turn_2: rt::Scalar<f32>,
    ) -> CellPart {
        let _e4 = self.v_voxel_place_on(way_6, rt::Scalar(0f32));
        let _e8 = self.v_part_from(path_3, way_6, turn_2, _e4.floor(), rt::Scalar(0f32), rt::Scalar(0u32));
        return _e8;
    }
    pub(crate) fn gap_in_cell(
        &self,
        way_7: VoxelPath,
        cell_5: impl rt::Into<rt::Vec3<f32>>,
        corners: VoxelCell,
        t_5: impl rt::Into<rt::Scalar<f32>>,
        span_1: impl rt::Into<rt::Scalar<f32>>,
    ) -> Quartic {
        rt::into(self.v_gap_in_cell(way_7, rt::into(cell_5), corners, rt::into(t_5), rt::into(span_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_gap_in_cell(
        &self,
        way_7: VoxelPath,
        cell_5: rt::Vec3<f32>,
        corners: VoxelCell,
        t_5: rt::Scalar<f32>,
        span_1: rt::Scalar<f32>,
    ) -> Quartic {
        let _e5 = self.v_voxel_place_on(way_7, t_5);
        let at_180 = (_e5 - cell_5);
        let slope_6 = ((way_7.step.z() + ((rt::Scalar(2f32) * rt::Scalar(way_7.bend)) * t_5)) * span_1);
        let bend_6 = (rt::Scalar(way_7.bend) * (span_1 * span_1));
        let dx_3 = (way_7.step.x() * span_1);
        let dy_1 = (way_7.step.y() * span_1);
        let _e26 = self.v_along_slice(corners.low, at_180.xy(), dx_3, dy_1);
        let _e29 = self.v_along_slice(corners.high, at_180.xy(), dx_3, dy_1);
        let rise_1 = (_e29 - _e26);
        return <Quartic>::new((rt::Scalar(0.5f32) - (_e26.x() + (rise_1.x() * at_180.z()))), (rt::Scalar(0f32) - ((_e26.y() + (rise_1.y() * at_180.z())) + (rise_1.x() * slope_6))), (rt::Scalar(0f32) - (((_e26.z() + (rise_1.z() * at_180.z())) + (rise_1.y() * slope_6)) + (rise_1.x() * bend_6))), (rt::Scalar(0f32) - ((rise_1.z() * slope_6) + (rise_1.y() * bend_6))), (rt::Scalar(0f32) - (rise_1.z() * bend_6)));
    }
    pub(crate) fn field_between(
        &self,
        way_8: VoxelPath,
        cell_6: impl rt::Into<rt::Vec3<f32>>,
        corners_1: VoxelCell,
        begin_1: impl rt::Into<rt::Scalar<f32>>,
        end: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_field_between(way_8, rt::into(cell_6), corners_1, rt::into(begin_1), rt::into(end)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_between(
        &self,
        way_8: VoxelPath,
        cell_6: rt::Vec3<f32>,
        corners_1: VoxelCell,
        begin_1: rt::Scalar<f32>,
        end: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let _e6 = self.v_gap_in_cell(way_8, cell_6, corners_1, begin_1, (end - begin_1));
        let mean_10 = ((((rt::Scalar(_e6.a) + (rt::Scalar(_e6.b) * rt::Scalar(0.5f32))) + (rt::Scalar(_e6.c) * rt::Scalar(0.33333334f32))) + (rt::Scalar(_e6.d) * rt::Scalar(0.25f32))) + (rt::Scalar(_e6.e) * rt::Scalar(0.2f32)));
        return ((rt::Scalar(0.5f32) - mean_10).max(rt::Scalar(0f32)) * (end - begin_1));
    }
    pub(crate) fn slice_cell(
        &self,
        cell_7: impl rt::Into<rt::Vec2<i32>>,
        slice_1: impl rt::Into<rt::Scalar<i32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_slice_cell(rt::into(cell_7), rt::into(slice_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_slice_cell(
        &self,
        cell_7: rt::Vec2<i32>,
        slice_1: rt::Scalar<i32>,
    ) -> rt::Vec4<f32> {
        let _e4 = self.surface_settings.volume;
        let size_4 = _e4.xyz().to_i32();
        let _e7 = self.v_slice_begin(slice_1);
        let _e13 = self.v_wrap_pair(cell_7.x(), size_4.x());
        let i_8 = (<rt::Vec2<i32>>::from_scalars(_e7.x(), _e7.x()) + _e13);
        let _e20 = self.v_wrap_pair(cell_7.y(), size_4.y());
        let j_1 = (<rt::Vec2<i32>>::from_scalars(_e7.y(), _e7.y()) + _e20);
        let _e27 = rt::texture::Read::read_texel((&self.height_map), <rt::Vec2<i32>>::from_scalars(i_8.x(), j_1.x()), 0i32, 0i32, rt::Scalar::into_inner(rt::Scalar(0i32)));
        let _e34 = rt::texture::Read::read_texel((&self.height_map), <rt::Vec2<i32>>::from_scalars(i_8.y(), j_1.x()), 0i32, 0i32, rt::Scalar::into_inner(rt::Scalar(0i32)));
        let _e41 = rt::texture::Read::read_texel((&self.height_map), <rt::Vec2<i32>>::from_scalars(i_8.x(), j_1.y()), 0i32, 0i32, rt::Scalar::into_inner(rt::Scalar(0i32)));
        let _e48 = rt::texture::Read::read_texel((&self.height_map), <rt::Vec2<i32>>::from_scalars(i_8.y(), j_1.y()), 0i32, 0i32, rt::Scalar::into_inner(rt::Scalar(0i32)));
        return <rt::Vec4<f32>>::from_scalars(_e27.x(), _e34.x(), _e41.x(), _e48.x());
    }
    pub(crate) fn voxel_cell(&self, cell_8: impl rt::Into<rt::Vec3<i32>>) -> VoxelCell {
        rt::into(self.v_voxel_cell(rt::into(cell_8)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_voxel_cell(&self, cell_8: rt::Vec3<i32>) -> VoxelCell {
        let _e3 = self.v_slice_cell(cell_8.xy(), cell_8.z());
        let _e8 = self.v_slice_cell(cell_8.xy(), (cell_8.z() + rt::Scalar(1i32)));
        return <VoxelCell>::new(_e3, _e8);
    }
    pub(crate) fn voxel_cell_at(
        &self,
        way_9: VoxelPath,
        cell_9: impl rt::Into<rt::Vec3<f32>>,
        reach_1: impl rt::Into<rt::Scalar<f32>>,
        t_6: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_voxel_cell_at(way_9, rt::into(cell_9), rt::into(reach_1), rt::into(t_6)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_voxel_cell_at(
        &self,
        way_9: VoxelPath,
        cell_9: rt::Vec3<f32>,
        reach_1: rt::Scalar<f32>,
        t_6: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let far_10 = <rt::Vec3<f32>>::from_scalars(reach_1, reach_1, reach_1);
        let _e5 = self.v_voxel_place_on(way_9, t_6);
        return _e5.floor().clamp((cell_9 - far_10), (cell_9 + far_10));
    }
    pub(crate) fn next_voxel_cell(
        &self,
        way_10: VoxelPath,
        cell_10: impl rt::Into<rt::Vec3<f32>>,
        reach_2: impl rt::Into<rt::Scalar<f32>>,
        leave_1: impl rt::Into<rt::Vec3<f32>>,
        rises_1: impl rt::Into<rt::Scalar<bool>>,
        t_7: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_next_voxel_cell(way_10, rt::into(cell_10), rt::into(reach_2), rt::into(leave_1), rt::into(rises_1), rt::into(t_7)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_next_voxel_cell(
        &self,
        way_10: VoxelPath,
        cell_10: rt::Vec3<f32>,
        reach_2: rt::Scalar<f32>,
        leave_1: rt::Vec3<f32>,
        rises_1: rt::Scalar<bool>,
        t_7: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let mut next: rt::Vec3<f32>;
        let mut local_12: rt::Scalar<bool>;

        let _e6 = self.v_voxel_cell_at(way_10, cell_10, reach_2, t_7);
        next = _e6;
        let far_11 = (reach_2 + rt::Scalar(1f32));
        if rt::Scalar::into_branch_condition(leave_1.x().elementwise_le(leave_1.y())) {
            local_12 = leave_1.x().elementwise_le(leave_1.z());
        } else {
            local_12 = rt::Scalar(false);
        }
        let _e19 = local_12;
        if rt::Scalar::into_branch_condition(_e19) {
            next.set_x((cell_10.x() + (rt::Scalar(0f32) - far_11).select(far_11, way_10.step.x().elementwise_gt(rt::Scalar(0f32)))));
        } else {
            if rt::Scalar::into_branch_condition(leave_1.y().elementwise_le(leave_1.z())) {
                next.set_y((cell_10.y() + (rt::Scalar(0f32) - far_11).select(far_11, way_10.step.y().elementwise_gt(rt::Scalar(0f32)))));
            } else {
                next.set_z((cell_10.z() + (rt::Scalar(0f32) - far_11).select(far_11, rises_1)));
            }
        }
        let _e49 = next;
        return _e49;
    }
    pub(crate) fn next_part(
        &self,
        path_4: Path,
        way_11: VoxelPath,
        turn_3: impl rt::Into<rt::Scalar<f32>>,
        before: CellPart,
    ) -> CellPart {
        rt::into(self.v_next_part(path_4, way_11, rt::into(turn_3), before))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_next_part(
        &self,
        path_4: Path,
        way_11: VoxelPath,
        turn_3: rt::Scalar<f32>,
        before: CellPart,
    ) -> CellPart {
        let mut local_13: rt::Scalar<bool>;

        let reach_3 = rt::Scalar(before.empty).max(rt::Scalar(0f32));
        let has_turned_5 = rt::Scalar(before.past_turn).elementwise_eq(rt::Scalar(1u32));
        let leave_7 = before.leave;
        let end_6 = rt::Scalar(before.end);
        let side_6 = leave_7.x().min(leave_7.y()).min(leave_7.z());
        if rt::Scalar::into_branch_condition((!has_turned_5)) {
            local_13 = side_6.elementwise_gt(turn_3.min(rt::Scalar(path_4.exit)));
        } else {
            local_13 = rt::Scalar(false);
        }
        let _e24 = local_13;
        if rt::Scalar::into_branch_condition(_e24) {
            let _e26 = self.v_voxel_cell_at(way_11, before.cell, reach_3, end_6);
            let _e28 = self.v_part_from(path_4, way_11, turn_3, _e26, end_6, rt::Scalar(1u32));
            return _e28;
        }
        let _e30 = self.v_rises_on(way_11, has_turned_5);
        let _e31 = self.v_next_voxel_cell(way_11, before.cell, reach_3, leave_7, _e30, end_6);
        let _e33 = self.v_part_from(path_4, way_11, turn_3, _e31, end_6, rt::Scalar(before.past_turn));
        return _e33;
    }
    pub(crate) fn field_along(
        &self,
        path_5: Path,
        params_9: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_field_along(path_5, rt::into(params_9)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_field_along(
        &self,
        path_5: Path,
        params_9: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        let mut sum_1: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut part_1: CellPart;
        let mut cells: rt::Scalar<u32> = rt::Scalar(1u32);
        let mut goes: rt::Scalar<bool> = rt::Scalar(true);
        let mut local_14: rt::Scalar<bool>;
        let mut local_15: rt::Scalar<bool>;

        let _e2 = self.v_voxel_path(path_5);
        let _e3 = self.v_turning_point(_e2);
        let enough = (rt::Scalar(8f32) / params_9.x().max(rt::Scalar(0.000000000000000000000000000000000000003333333f32)));
        let limit_2 = params_9.z().to_u32();
        let _e13 = self.v_first_part(path_5, _e2, _e3);
        part_1 = _e13;
        'naga_break: loop {
            'naga_continue: {
                let _e19 = goes;
                if rt::Scalar::into_branch_condition(_e19) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e21 = rt::Scalar(part_1.empty);
                    if rt::Scalar::into_branch_condition(_e21.elementwise_lt(rt::Scalar(0f32))) {
                        let _e24 = sum_1;
                        let _e26 = part_1.cell;
                        let _e28 = part_1.cell;
                        let _e30 = self.v_voxel_cell(_e28.to_i32());
                        let _e32 = rt::Scalar(part_1.begin);
                        let _e34 = rt::Scalar(part_1.end);
                        let _e35 = self.v_field_between(_e2, _e26, _e30, _e32, _e34);
                        sum_1 = (_e24 + _e35);
                    }
                    let _e38 = rt::Scalar(part_1.is_last);
                    if rt::Scalar::into_branch_condition(_e38.elementwise_eq(rt::Scalar(0u32))) {
                        let _e43 = cells;
                        local_14 = _e43.elementwise_lt(limit_2);
                    } else {
                        local_14 = rt::Scalar(false);
                    }
                    let _e46 = local_14;
                    if rt::Scalar::into_branch_condition(_e46) {
                        let _e49 = sum_1;
                        local_15 = _e49.elementwise_lt(enough);
                    } else {
                        local_15 = rt::Scalar(false);
                    }
                    let _e52 = local_15;
                    goes = _e52;
                    let _e53 = goes;
                    if rt::Scalar::into_branch_condition(_e53) {
                        let _e54 = part_1;
                        let _e55 = self.v_next_part(path_5, _e2, _e3, _e54);
                        part_1 = _e55;
                        let _e56 = cells;
                        cells = (_e56 + rt::Scalar(1u32));
                    }
                }
            }
        }
        let _e59 = sum_1;
        return _e59;
    }
    pub(crate) fn optical_depth(&self, path_6: Path) -> f32 {
        rt::into(self.v_optical_depth(path_6))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_optical_depth(&self, path_6: Path) -> rt::Scalar<f32> {
        let params_153 = self.surface_settings.choices[6usize].params;
        let _e6 = self.v_field_along(path_6, params_153);
        return (_e6 * params_153.x());
    }
    pub(crate) fn light_place(
        &self,
        view_9: LightView,
        point_6: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_light_place(view_9, rt::into(point_6)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_light_place(
        &self,
        view_9: LightView,
        point_6: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let at_181 = <rt::Vec4<f32>>::new_31(point_6, rt::Scalar(1f32));
        let depth_12 = view_9.depth.dot(at_181);
        let over_1 = rt::Scalar(1f32).select(depth_12, rt::Scalar(view_9.from_point).elementwise_eq(rt::Scalar(1u32)));
        return <rt::Vec3<f32>>::new_21((<rt::Vec2<f32>>::from_scalars(view_9.column.dot(at_181), view_9.row.dot(at_181)) / rt::Vec2::splat_from_scalar(over_1)), depth_12);
    }
    pub(crate) fn holds_filter(
        &self,
        view_10: LightView,
        place_7: impl rt::Into<rt::Vec3<f32>>,
        half: impl rt::Into<rt::Scalar<f32>>,
    ) -> bool {
        rt::into(self.v_holds_filter(view_10, rt::into(place_7), rt::into(half)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_holds_filter(
        &self,
        view_10: LightView,
        place_7: rt::Vec3<f32>,
        half: rt::Scalar<f32>,
    ) -> rt::Scalar<bool> {
        let mut local_16: rt::Scalar<bool>;
        let mut local_17: rt::Scalar<bool>;

        let least_1 = (place_7.x().min(place_7.y()) - half);
        let most_5 = (place_7.x().max(place_7.y()) + half);
        if rt::Scalar::into_branch_condition(place_7.z().elementwise_gt(rt::Scalar(0f32))) {
            local_16 = least_1.elementwise_ge(rt::Scalar(0f32));
        } else {
            local_16 = rt::Scalar(false);
        }
        let _e19 = local_16;
        if rt::Scalar::into_branch_condition(_e19) {
            local_17 = most_5.elementwise_le(rt::Scalar(view_10.size).to_f32());
        } else {
            local_17 = rt::Scalar(false);
        }
        let _e26 = local_17;
        return _e26;
    }
    pub(crate) fn footprint_m(&self, at_13: Entered) -> f32 {
        rt::into(self.v_footprint_m(at_13))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_footprint_m(&self, at_13: Entered) -> rt::Scalar<f32> {
        let _e7 = self.v_height_size(rt::Scalar(0u32));
        return ((rt::Scalar(at_13.footprint) * at_13.metric.x().sqrt()) / _e7.x());
    }
    pub(crate) fn plane_depth(
        &self,
        view_11: LightView,
        point_7: impl rt::Into<rt::Vec3<f32>>,
        normal_10: impl rt::Into<rt::Vec3<f32>>,
        texel_1: impl rt::Into<rt::Vec2<f32>>,
    ) -> f32 {
        rt::into(self.v_plane_depth(view_11, rt::into(point_7), rt::into(normal_10), rt::into(texel_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_plane_depth(
        &self,
        view_11: LightView,
        point_7: rt::Vec3<f32>,
        normal_10: rt::Vec3<f32>,
        texel_1: rt::Vec2<f32>,
    ) -> rt::Scalar<f32> {
        let corner_5 = ((view_11.corner.xyz() + (view_11.across.xyz() * texel_1.x())) + (view_11.along.xyz() * texel_1.y()));
        if rt::Scalar::into_branch_condition(rt::Scalar(view_11.from_point).elementwise_eq(rt::Scalar(1u32))) {
            return (normal_10.dot((point_7 - view_11.eye.xyz())) / normal_10.dot(corner_5));
        }
        return (normal_10.dot((point_7 - corner_5)) / normal_10.dot(view_11.depth.xyz()));
    }
    pub(crate) fn light_texel(
        &self,
        place_8: impl rt::Into<rt::Vec2<i32>>,
        view_12: impl rt::Into<rt::Scalar<i32>>,
    ) -> f32 {
        rt::into(self.v_light_texel(rt::into(place_8), rt::into(view_12)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_light_texel(
        &self,
        place_8: rt::Vec2<i32>,
        view_12: rt::Scalar<i32>,
    ) -> rt::Scalar<f32> {
        let _e4 = rt::texture::Read::read_texel((&self.light_map), place_8, rt::Scalar::into_inner(view_12), 0i32, rt::Scalar::into_inner(rt::Scalar(0i32)));
        return _e4.x();
    }
    pub(crate) fn row_sees(
        &self,
        at_14: InView,
        row: impl rt::Into<rt::Scalar<f32>>,
        last: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_row_sees(at_14, rt::into(row), rt::into(last)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_row_sees(
        &self,
        at_14: InView,
        row: rt::Scalar<f32>,
        last: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let mut sees: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut column: rt::Scalar<f32>;

        let view_36 = self.frame.light_views[rt::Scalar::into_array_index(rt::Scalar(at_14.number))];
        column = at_14.low.x().floor();
        'naga_break: loop {
            'naga_continue: {
                let _e14 = column;
                if rt::Scalar::into_branch_condition(_e14.elementwise_le(last)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e18 = column;
                    let _e24 = column;
                    let wide = (at_14.high.x().min((_e18 + rt::Scalar(1f32))) - at_14.low.x().max(_e24));
                    let _e27 = column;
                    let place_38 = <rt::Vec2<f32>>::from_scalars(_e27, row);
                    let _e35 = self.v_plane_depth(view_36, at_14.point, at_14.normal, (place_38 + <rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32))));
                    let depth_13 = _e35.clamp(rt::Scalar(at_14.least_depth), rt::Scalar(at_14.most_depth));
                    let key = (rt::Scalar(view_36.near) / (rt::Scalar(view_36.near) + depth_13.max(rt::Scalar(0f32))));
                    let _e48 = self.v_light_texel(place_38.to_i32(), rt::Scalar(at_14.number).to_i32());
                    if rt::Scalar::into_branch_condition((!_e48.elementwise_gt(key))) {
                        let _e51 = sees;
                        sees = (_e51 + wide);
                    }
                    let _e53 = column;
                    column = (_e53 + rt::Scalar(1f32));
                }
            }
        }
        let _e56 = sees;
        return _e56;
    }
    pub(crate) fn seen_part(
        &self,
        number: impl rt::Into<rt::Scalar<u32>>,
        at_15: Entered,
        normal_11: impl rt::Into<rt::Vec3<f32>>,
        place_9: impl rt::Into<rt::Vec3<f32>>,
        filter_width: impl rt::Into<rt::Scalar<f32>>,
        bias: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_seen_part(rt::into(number), at_15, rt::into(normal_11), rt::into(place_9), rt::into(filter_width), rt::into(bias)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_seen_part(
        &self,
        number: rt::Scalar<u32>,
        at_15: Entered,
        normal_11: rt::Vec3<f32>,
        place_9: rt::Vec3<f32>,
        filter_width: rt::Scalar<f32>,
        bias: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let mut seen: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut row_1: rt::Scalar<f32>;

        let view_37 = self.frame.light_views[rt::Scalar::into_array_index(number)];
        let texel_m = (rt::Scalar(view_37.texel_m) * rt::Scalar(1f32).select(place_9.z(), rt::Scalar(view_37.from_point).elementwise_eq(rt::Scalar(1u32))));
        let _e19 = self.v_footprint_m(at_15);
        let point_25 = (at_15.point + (normal_11 * (bias * texel_m.max(_e19))));
        let reach_4 = (rt::Scalar(16f32) * texel_m);
        let low_3 = (place_9.xy() - (<rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32)) * filter_width));
        let high_4 = (low_3 + <rt::Vec2<f32>>::from_scalars(filter_width, filter_width));
        let last_5 = high_4.floor().min((<rt::Vec2<f32>>::from_scalars(rt::Scalar(view_37.size).to_f32(), rt::Scalar(view_37.size).to_f32()) - <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32))));
        let in_view = <InView>::new(number, point_25, normal_11, low_3, high_4, (place_9.z() - reach_4), (place_9.z() + reach_4));
        row_1 = low_3.y().floor();
        'naga_break: loop {
            'naga_continue: {
                let _e55 = row_1;
                if rt::Scalar::into_branch_condition(_e55.elementwise_le(last_5.y())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e59 = row_1;
                    let _e64 = row_1;
                    let tall = (high_4.y().min((_e59 + rt::Scalar(1f32))) - low_3.y().max(_e64));
                    let _e67 = seen;
                    let _e68 = row_1;
                    let _e70 = self.v_row_sees(in_view, _e68, last_5.x());
                    seen = (_e67 + (_e70 * tall));
                    let _e73 = row_1;
                    row_1 = (_e73 + rt::Scalar(1f32));
                }
            }
        }
        let _e76 = seen;
        return (_e76 / (filter_width * filter_width)).min(rt::Scalar(1f32));
    }
    pub(crate) fn patch_seen(
        &self,
        at_16: Entered,
        normal_12: impl rt::Into<rt::Vec3<f32>>,
        number_1: impl rt::Into<rt::Scalar<u32>>,
        filter_texels: impl rt::Into<rt::Scalar<f32>>,
        bias_1: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_patch_seen(at_16, rt::into(normal_12), rt::into(number_1), rt::into(filter_texels), rt::into(bias_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_patch_seen(
        &self,
        at_16: Entered,
        normal_12: rt::Vec3<f32>,
        number_1: rt::Scalar<u32>,
        filter_texels: rt::Scalar<f32>,
        bias_1: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let mut k: rt::Scalar<u32>;

        let light_26 = self.frame.lights[rt::Scalar::into_array_index(number_1)];
        let width_2 = filter_texels.max(rt::Scalar(0.001f32));
        k = rt::Scalar(light_26.first_view);
        'naga_break: loop {
            'naga_continue: {
                let _e13 = k;
                if rt::Scalar::into_branch_condition(_e13.elementwise_lt((rt::Scalar(light_26.first_view) + rt::Scalar(light_26.views)))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e20 = k;
                    let _e22 = self.frame.light_views[rt::Scalar::into_array_index(_e20)];
                    let _e24 = self.v_light_place(_e22, at_16.point);
                    let _e27 = k;
                    let _e29 = self.frame.light_views[rt::Scalar::into_array_index(_e27)];
                    let _e32 = self.v_holds_filter(_e29, _e24, (rt::Scalar(0.5f32) * width_2));
                    if rt::Scalar::into_branch_condition(_e32) {
                        let _e33 = k;
                        let _e34 = self.v_seen_part(_e33, at_16, normal_12, _e24, width_2, bias_1);
                        return _e34;
                    }
                    let _e35 = k;
                    k = (_e35 + rt::Scalar(1u32));
                }
            }
        }
        return rt::Scalar(1f32);
    }
    pub(crate) fn arriving(&self, at_17: Entered, hit_8: Hit, toward: Toward) -> f32 {
        rt::into(self.v_arriving(at_17, hit_8, toward))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_arriving(&self, at_17: Entered, hit_8: Hit, toward: Toward) -> rt::Scalar<f32> {
        let mut interval_1: rt::Vec2<f32>;
        let mut part_2: rt::Scalar<f32> = rt::Scalar(1f32);

        let _e5 = rt::Scalar(self.surface_settings.has_shadows);
        if rt::Scalar::into_branch_condition(_e5.elementwise_eq(rt::Scalar(0u32))) {
            return rt::Scalar(1f32);
        }
        let _e10 = self.v_climb(at_17, toward.direction);
        let end_7 = rt::Scalar(0f32).select(rt::Scalar(1f32), _e10.z().elementwise_gt(rt::Scalar(0f32)));
        let across_4 = ((end_7 - rt::Scalar(hit_8.height)) / _e10.z());
        let _e22 = self.v_near_uv(hit_8.uv);
        interval_1 = <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(300000000000000000000000000000000000000f32).select(across_4, _e10.z().elementwise_ne(rt::Scalar(0f32))).min(rt::Scalar(toward.distance)));
        let _e35 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e35.elementwise_eq(WRAP_CLAMP)) {
            let _e40 = interval_1;
            let _e41 = self.v_inside_unit(_e22.x(), _e10.x(), _e40);
            interval_1 = _e41;
            let _e44 = interval_1;
            let _e45 = self.v_inside_unit(_e22.y(), _e10.y(), _e44);
            interval_1 = _e45;
        }
        let h_6 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(hit_8.height), _e10.z(), rt::Scalar(0f32));
        let _e52 = interval_1.y();
        let path_126 = <Path>::new(_e22, _e10.xy(), h_6, _e52, rt::Scalar(0f32), at_17.metric, RAY_VIEW, rt::Scalar(at_17.level), rt::Scalar(0f32), rt::Scalar(1f32), rt::Scalar(0f32));
        if rt::Scalar::into_branch_condition(rt::Scalar(path_126.exit).elementwise_gt(rt::Scalar(0f32))) {
            let _e66 = self.v_optical_depth(path_126);
            let _e67 = self.v_transmittance_of(_e66);
            part_2 = _e67;
        }
        let shadow = self.surface_settings.choices[9usize].params;
        if rt::Scalar::into_branch_condition(shadow.x().elementwise_gt(rt::Scalar(0f32))) {
            let _e76 = part_2;
            let _e81 = self.v_patch_seen(at_17, toward.direction, rt::Scalar(toward.number), shadow.z(), shadow.w());
            part_2 = (_e76 * _e81);
        }
        let _e83 = part_2;
        return _e83;
    }
    pub(crate) fn axis_of(
        &self,
        at_18: impl rt::Into<rt::Vec3<i32>>,
        axis: impl rt::Into<rt::Scalar<u32>>,
    ) -> i32 {
        rt::into(self.v_axis_of(rt::into(at_18), rt::into(axis)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_axis_of(
        &self,
        at_18: rt::Vec3<i32>,
        axis: rt::Scalar<u32>,
    ) -> rt::Scalar<i32> {
        return at_18.z().select(at_18.y(), axis.elementwise_eq(rt::Scalar(1u32))).select(at_18.x(), axis.elementwise_eq(rt::Scalar(0u32)));
    }
    pub(crate) fn pixel_direction(&self, pixel: impl rt::Into<rt::Vec2<f32>>) -> rt::Vec3<f32> {
        rt::into(self.v_pixel_direction(rt::into(pixel)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_pixel_direction(&self, pixel: rt::Vec2<f32>) -> rt::Vec3<f32> {
        let _e3 = self.frame.corner;
        let _e7 = self.frame.right;
        let _e14 = self.frame.down;
        return ((_e3.xyz() + (_e7.xyz() * pixel.x())) + (_e14.xyz() * pixel.y()));
    }
    pub(crate) fn background_at(
        &self,
        point_8: impl rt::Into<rt::Vec2<f32>>,
        rows: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_background_at(rt::into(point_8), rt::into(rows)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_background_at(
        &self,
        point_8: rt::Vec2<f32>,
        rows: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let _e5 = self.frame.background.w();
        if rt::Scalar::into_branch_condition(_e5.elementwise_gt(rt::Scalar(0f32))) {
            let _e8 = self.v_pixel_direction(point_8);
            let _e10 = self.v_environment_of_level(_e8, rt::Scalar(0u32));
            let _e14 = self.frame.background.w();
            return (_e10 * _e14);
        }
        let _e18 = self.frame.background;
        let top_3 = _e18.xyz();
        let _e22 = self.frame.background_below;
        return (top_3 + ((_e22.xyz() - top_3) * (point_8.y() / rows)));
    }
    pub(crate) fn base_height(&self) -> f32 {
        rt::into(self.v_base_height())
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_base_height(&self) -> rt::Scalar<f32> {
        let _e2 = rt::Scalar(self.surface_settings.bias_m);
        let _e5 = self.v_traced_scale_m();
        return ((rt::Scalar(0f32) - _e2) / _e5);
    }
    pub(crate) fn lift_of(
        &self,
        lift: impl rt::Into<rt::Vec3<f32>>,
        w: impl rt::Into<rt::Vec3<f32>>,
    ) -> f32 {
        rt::into(self.v_lift_of(rt::into(lift), rt::into(w)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_lift_of(
        &self,
        lift: rt::Vec3<f32>,
        w: rt::Vec3<f32>,
    ) -> rt::Scalar<f32> {
        return ((((lift.x() * w.y()) * w.z()) + ((lift.y() * w.z()) * w.x())) + ((lift.z() * w.x()) * w.y()));
    }
    pub(crate) fn way_point(
        &self,
        prism: Prism,
        along: impl rt::Into<rt::Vec3<f32>>,
        way_12: Way,
        offset: impl rt::Into<rt::Scalar<f32>>,
    ) -> WayPoint {
        rt::into(self.v_way_point(prism, rt::into(along), way_12, rt::into(offset)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_way_point(
        &self,
        prism: Prism,
        along: rt::Vec3<f32>,
        way_12: Way,
        offset: rt::Scalar<f32>,
    ) -> WayPoint {
        let low_4 = self.surface_settings.shell_m.x();
        let _e11 = self.surface_settings.shell_m.y();
        let width_3 = (_e11 - low_4).min(rt::Scalar(300000000000000000000000000000000000000f32));
        let _e16 = self.v_quadratic(way_12.first, offset);
        let _e18 = self.v_quadratic(way_12.second, offset);
        let _e20 = self.v_quadratic(way_12.third, offset);
        let parts_4 = <rt::Vec3<f32>>::from_scalars(_e16, _e18, _e20);
        let limited = parts_4.min(<rt::Vec3<f32>>::from_scalars(rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32)));
        let w_3 = (limited / rt::Vec3::splat_from_scalar(((limited.x() + limited.y()) + limited.z())));
        let normal_30 = (((prism.n0_ * w_3.x()) + (prism.n1_ * w_3.y())) + (prism.n2_ * w_3.z()));
        let place_39 = ((((prism.p0_ * w_3.x()) + (prism.p1_ * w_3.y())) + (prism.p2_ * w_3.z())) + (normal_30 * offset));
        let t_50 = place_39.dot(along).min(rt::Scalar(300000000000000000000000000000000000000f32));
        let second_3 = ((prism.p1_ - prism.p0_) + ((prism.n1_ - prism.n0_) * offset));
        let third_2 = ((prism.p2_ - prism.p0_) + ((prism.n2_ - prism.n0_) * offset));
        let volume = (second_3.cross(third_2).dot(normal_30) * rt::Scalar(way_12.turn));
        let _e83 = self.v_lift_of(prism.lift, w_3);
        let height_19 = (((offset - low_4) - _e83) / width_3).min(rt::Scalar(300000000000000000000000000000000000000f32));
        return <WayPoint>::new(<ShellPoint>::new(w_3, height_19), t_50, (place_39 - (along * t_50)).length(), volume);
    }
    pub(crate) fn before_turn(
        &self,
        prism_1: Prism,
        along_1: impl rt::Into<rt::Vec3<f32>>,
        way_13: Way,
        chord: impl rt::Into<rt::Vec2<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_before_turn(prism_1, rt::into(along_1), way_13, rt::into(chord)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_before_turn(
        &self,
        prism_1: Prism,
        along_1: rt::Vec3<f32>,
        way_13: Way,
        chord: rt::Vec2<f32>,
    ) -> rt::Vec2<f32> {
        let mut inner: rt::Scalar<f32>;
        let mut outer: rt::Scalar<f32>;
        let mut step: rt::Scalar<u32> = rt::Scalar(0u32);

        let _e5 = self.v_way_point(prism_1, along_1, way_13, chord.x());
        let is_first = rt::Scalar(_e5.volume).elementwise_gt(rt::Scalar(0f32));
        let _e10 = self.v_way_point(prism_1, along_1, way_13, chord.y());
        let is_last = rt::Scalar(_e10.volume).elementwise_gt(rt::Scalar(0f32));
        if rt::Scalar::into_branch_condition(is_first.elementwise_eq(is_last)) {
            return chord;
        }
        inner = chord.y().select(chord.x(), is_first);
        outer = chord.x().select(chord.y(), is_first);
        'naga_break: loop {
            'naga_continue: {
                let _e25 = step;
                if rt::Scalar::into_branch_condition(_e25.elementwise_lt(TURN_STEPS)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e28 = step;
                    step = (_e28 + rt::Scalar(1u32));
                    let _e31 = inner;
                    let _e32 = outer;
                    let between_2 = (rt::Scalar(0.5f32) * (_e31 + _e32));
                    let _e36 = self.v_way_point(prism_1, along_1, way_13, between_2);
                    if rt::Scalar::into_branch_condition(rt::Scalar(_e36.volume).elementwise_gt(rt::Scalar(0f32))) {
                        inner = between_2;
                    } else {
                        outer = between_2;
                    }
                }
            }
        }
        if rt::Scalar::into_branch_condition(is_first) {
            let _e41 = inner;
            return <rt::Vec2<f32>>::from_scalars(chord.x(), _e41);
        }
        let _e43 = inner;
        return <rt::Vec2<f32>>::from_scalars(_e43, chord.y());
    }
    pub(crate) fn path_uv(
        &self,
        path_7: Path,
        t_8: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_path_uv(path_7, rt::into(t_8)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_path_uv(
        &self,
        path_7: Path,
        t_8: rt::Scalar<f32>,
    ) -> rt::Vec2<f32> {
        return (path_7.uv + (path_7.duv * t_8));
    }
    pub(crate) fn path_height(
        &self,
        path_8: Path,
        t_9: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_path_height(path_8, rt::into(t_9)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_path_height(
        &self,
        path_8: Path,
        t_9: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        return (path_8.h.x() + (t_9 * (path_8.h.y() + (t_9 * path_8.h.z()))));
    }
    pub(crate) fn path_slope(
        &self,
        path_9: Path,
        t_10: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_path_slope(path_9, rt::into(t_10)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_path_slope(
        &self,
        path_9: Path,
        t_10: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        return (path_9.h.y() + ((rt::Scalar(2f32) * t_10) * path_9.h.z()));
    }
    pub(crate) fn beginning_at(
        &self,
        path_10: Path,
        t_11: impl rt::Into<rt::Scalar<f32>>,
    ) -> Path {
        rt::into(self.v_beginning_at(path_10, rt::into(t_11)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_beginning_at(
        &self,
        path_10: Path,
        t_11: rt::Scalar<f32>,
    ) -> Path {
        let _e2 = self.v_path_uv(path_10, t_11);
        let _e4 = self.v_path_height(path_10, t_11);
        let _e5 = self.v_path_slope(path_10, t_11);
        return <Path>::new(_e2, path_10.duv, <rt::Vec3<f32>>::from_scalars(_e4, _e5, path_10.h.z()), (rt::Scalar(path_10.exit) - t_11), rt::Scalar(path_10.base), path_10.metric, rt::Scalar(path_10.ray), rt::Scalar(path_10.level), (rt::Scalar(path_10.start) + t_11), rt::Scalar(path_10.share), rt::Scalar(path_10.bend));
    }
    pub(crate) fn bent_exit(&self, h_1: impl rt::Into<rt::Vec3<f32>>) -> f32 {
        rt::into(self.v_bent_exit(rt::into(h_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_bent_exit(&self, h_1: rt::Vec3<f32>) -> rt::Scalar<f32> {
        let mut exit: rt::Scalar<f32> = rt::Scalar(300000000000000000000000000000000000000f32);

        let floor_1 = (h_1.x() + rt::Scalar(0.000001f32));
        let under_2 = ((h_1.y() * h_1.y()) - ((rt::Scalar(4f32) * h_1.z()) * floor_1));
        if rt::Scalar::into_branch_condition(under_2.elementwise_ge(rt::Scalar(0f32))) {
            if rt::Scalar::into_branch_condition(h_1.y().elementwise_lt(rt::Scalar(0f32))) {
                exit = ((rt::Scalar(2f32) * floor_1) / (under_2.sqrt() - h_1.y()));
            } else {
                if rt::Scalar::into_branch_condition(h_1.z().elementwise_lt(rt::Scalar(0f32))) {
                    exit = ((h_1.y() + under_2.sqrt()) / (rt::Scalar(-2f32) * h_1.z()));
                }
            }
        }
        let room = (rt::Scalar(1f32) - h_1.x());
        let above_5 = ((h_1.y() * h_1.y()) + ((rt::Scalar(4f32) * h_1.z()) * room));
        if rt::Scalar::into_branch_condition(above_5.elementwise_ge(rt::Scalar(0f32))) {
            if rt::Scalar::into_branch_condition(h_1.y().elementwise_gt(rt::Scalar(0f32))) {
                let _e51 = exit;
                exit = _e51.min(((rt::Scalar(2f32) * room) / (h_1.y() + above_5.sqrt())));
            } else {
                if rt::Scalar::into_branch_condition(h_1.z().elementwise_gt(rt::Scalar(0f32))) {
                    let _e62 = exit;
                    exit = _e62.min(((above_5.sqrt() - h_1.y()) / (rt::Scalar(2f32) * h_1.z())));
                }
            }
        }
        let _e71 = exit;
        return _e71;
    }
    pub(crate) fn corner_value(
        &self,
        number_2: impl rt::Into<rt::Scalar<u32>>,
        a_4: impl rt::Into<rt::Vec3<f32>>,
        b_4: impl rt::Into<rt::Vec3<f32>>,
        c_4: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_corner_value(rt::into(number_2), rt::into(a_4), rt::into(b_4), rt::into(c_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_corner_value(
        &self,
        number_2: rt::Scalar<u32>,
        a_4: rt::Vec3<f32>,
        b_4: rt::Vec3<f32>,
        c_4: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let is_first_1 = number_2.elementwise_eq(rt::Scalar(0u32));
        let is_second = number_2.elementwise_eq(rt::Scalar(1u32));
        let second_4 = c_4.select(b_4, <rt::Vec3<bool>>::from_scalars(is_second, is_second, is_second));
        return second_4.select(a_4, <rt::Vec3<bool>>::from_scalars(is_first_1, is_first_1, is_first_1));
    }
    pub(crate) fn ordered(
        &self,
        pixel_1: PixelIn,
        place_10: impl rt::Into<rt::Scalar<u32>>,
    ) -> Corner {
        rt::into(self.v_ordered(pixel_1, rt::into(place_10)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_ordered(
        &self,
        pixel_1: PixelIn,
        place_10: rt::Scalar<u32>,
    ) -> Corner {
        let number_27 = ((rt::Scalar(pixel_1.shell.order) >> (rt::Scalar(2u32) * place_10)) & rt::Scalar(3u32));
        let a_33 = pixel_1.a;
        let b_34 = pixel_1.b;
        let c_24 = pixel_1.c;
        let _e15 = self.v_corner_value(number_27, a_33.position, b_34.position, c_24.position);
        let _e19 = self.v_corner_value(number_27, a_33.normal, b_34.normal, c_24.normal);
        let _e23 = self.v_corner_value(number_27, a_33.tangent, b_34.tangent, c_24.tangent);
        let _e27 = self.v_corner_value(number_27, a_33.bitangent, b_34.bitangent, c_24.bitangent);
        let _e37 = self.v_corner_value(number_27, <rt::Vec3<f32>>::new_21(a_33.uv, rt::Scalar(0f32)), <rt::Vec3<f32>>::new_21(b_34.uv, rt::Scalar(0f32)), <rt::Vec3<f32>>::new_21(c_24.uv, rt::Scalar(0f32)));
        let _e42 = self.v_corner_value(number_27, a_33.of_surface, b_34.of_surface, c_24.of_surface);
        return <Corner>::new(_e15, _e19, _e23, _e27, _e37.xy(), _e42);
    }
    pub(crate) fn uv_of(
        &self,
        pixel_2: PixelIn,
        weights: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_uv_of(pixel_2, rt::into(weights)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_uv_of(
        &self,
        pixel_2: PixelIn,
        weights: rt::Vec3<f32>,
    ) -> rt::Vec2<f32> {
        let _e3 = self.v_ordered(pixel_2, rt::Scalar(0u32));
        let _e8 = self.v_ordered(pixel_2, rt::Scalar(1u32));
        let _e14 = self.v_ordered(pixel_2, rt::Scalar(2u32));
        return (((_e3.uv * weights.x()) + (_e8.uv * weights.y())) + (_e14.uv * weights.z()));
    }
    pub(crate) fn beside_chord(
        &self,
        pixel_3: PixelIn,
        a_5: ShellPoint,
        m: ShellPoint,
        b_5: ShellPoint,
        at_19: ShellPoint,
        part_3: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_beside_chord(pixel_3, a_5, m, b_5, at_19, rt::into(part_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_beside_chord(
        &self,
        pixel_3: PixelIn,
        a_5: ShellPoint,
        m: ShellPoint,
        b_5: ShellPoint,
        at_19: ShellPoint,
        part_3: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let line = (a_5.weights + ((b_5.weights - a_5.weights).min(<rt::Vec3<f32>>::from_scalars(rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32))) * part_3));
        let _e19 = self.v_uv_of(pixel_3, (at_19.weights - line));
        let _e21 = self.v_height_size(rt::Scalar(0u32));
        let apart_1 = (_e19 * _e21).abs();
        let bend_7 = (rt::Scalar(2f32) * ((rt::Scalar(a_5.height) + rt::Scalar(b_5.height)) - (rt::Scalar(2f32) * rt::Scalar(m.height))));
        let slope_7 = ((rt::Scalar(b_5.height) - rt::Scalar(a_5.height)) - bend_7);
        let height_20 = (rt::Scalar(a_5.height) + (part_3 * (slope_7 + (part_3 * bend_7))));
        return apart_1.x().max(apart_1.y()).max(((rt::Scalar(at_19.height) - height_20).abs() / rt::Scalar(0.0625f32)));
    }
    pub(crate) fn beside_way(
        &self,
        pixel_4: PixelIn,
        a_6: WayPoint,
        b_6: WayPoint,
        bend_1: impl rt::Into<rt::Scalar<f32>>,
        at_20: WayPoint,
    ) -> f32 {
        rt::into(self.v_beside_way(pixel_4, a_6, b_6, rt::into(bend_1), at_20))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_beside_way(
        &self,
        pixel_4: PixelIn,
        a_6: WayPoint,
        b_6: WayPoint,
        bend_1: rt::Scalar<f32>,
        at_20: WayPoint,
    ) -> rt::Scalar<f32> {
        let part_20 = ((rt::Scalar(at_20.t) - rt::Scalar(a_6.t)) / (rt::Scalar(b_6.t) - rt::Scalar(a_6.t)));
        let line_1 = (a_6.point.weights + ((b_6.point.weights - a_6.point.weights).min(<rt::Vec3<f32>>::from_scalars(rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32))) * part_20));
        let _e29 = self.v_uv_of(pixel_4, (at_20.point.weights - line_1));
        let _e31 = self.v_height_size(rt::Scalar(0u32));
        let apart_2 = (_e29 * _e31).abs();
        let slope_8 = ((rt::Scalar(b_6.point.height) - rt::Scalar(a_6.point.height)) - bend_1);
        let height_21 = (rt::Scalar(a_6.point.height) + (part_20 * (slope_8 + (part_20 * bend_1))));
        return apart_2.x().max(apart_2.y()).max(((rt::Scalar(at_20.point.height) - height_21).abs() / rt::Scalar(0.0625f32)));
    }
    pub(crate) fn between(&self, a_7: ShellPoint, b_7: ShellPoint) -> ShellPoint {
        rt::into(self.v_between(a_7, b_7))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_between(&self, a_7: ShellPoint, b_7: ShellPoint) -> ShellPoint {
        return <ShellPoint>::new((rt::Scalar(0.5f32) * (a_7.weights + b_7.weights)), (rt::Scalar(0.5f32) * (rt::Scalar(a_7.height) + rt::Scalar(b_7.height))));
    }
    pub(crate) fn beyond_image(&self, image_6: Image) -> rt::Vec2<f32> {
        rt::into(self.v_beyond_image(image_6))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_beyond_image(&self, image_6: Image) -> rt::Vec2<f32> {
        let _e6 = self.v_height_size(rt::Scalar(0u32));
        return (<rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32)) / (image_6.extent * _e6));
    }
    pub(crate) fn bitangent_of_image(&self, image_7: Image) -> rt::Vec3<f32> {
        rt::into(self.v_bitangent_of_image(image_7))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_bitangent_of_image(&self, image_7: Image) -> rt::Vec3<f32> {
        let along_22 = (image_7.v.xyz() - (rt::Scalar(0.5f32) * image_7.depth.xyz()));
        return (along_22 / rt::Vec3::splat_from_scalar((along_22.dot(along_22) * image_7.extent.y())));
    }
    pub(crate) fn mixed(&self, seed: impl rt::Into<rt::Scalar<u32>>) -> u32 {
        rt::into(self.v_mixed(rt::into(seed)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_mixed(&self, seed: rt::Scalar<u32>) -> rt::Scalar<u32> {
        let mut x: rt::Scalar<u32>;

        x = (seed ^ (seed >> rt::Scalar(16u32)));
        let _e5 = x;
        x = (_e5 * rt::Scalar(2146121005u32));
        let _e8 = x;
        let _e9 = x;
        x = (_e8 ^ (_e9 >> rt::Scalar(15u32)));
        let _e13 = x;
        x = (_e13 * rt::Scalar(2221713035u32));
        let _e16 = x;
        let _e17 = x;
        return (_e16 ^ (_e17 >> rt::Scalar(16u32)));
    }
    pub(crate) fn bits_of_point(
        &self,
        point_9: impl rt::Into<rt::Vec2<f32>>,
        count_1: impl rt::Into<rt::Scalar<f32>>,
        seed_1: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_bits_of_point(rt::into(point_9), rt::into(count_1), rt::into(seed_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_bits_of_point(
        &self,
        point_9: rt::Vec2<f32>,
        count_1: rt::Scalar<f32>,
        seed_1: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        let within_1 = (point_9 - ((point_9 / rt::Vec2::splat_from_scalar(count_1)).floor() * count_1));
        let _e12 = self.v_mixed(seed_1);
        let _e14 = self.v_mixed((within_1.y().to_u32() + _e12));
        let _e16 = self.v_mixed((within_1.x().to_u32() + _e14));
        return _e16;
    }
    pub(crate) fn both_roots(&self, c_5: impl rt::Into<rt::Vec3<f32>>) -> rt::Vec2<f32> {
        rt::into(self.v_both_roots(rt::into(c_5)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_both_roots(&self, c_5: rt::Vec3<f32>) -> rt::Vec2<f32> {
        let mut roots: rt::Vec2<f32> = <rt::Vec2<f32>>::from_scalars(rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32));

        let discriminant_3 = ((c_5.y() * c_5.y()) - ((rt::Scalar(4f32) * c_5.z()) * c_5.x()));
        if rt::Scalar::into_branch_condition(discriminant_3.elementwise_ge(rt::Scalar(0f32))) {
            let root_4 = discriminant_3.sqrt();
            let q_10 = (rt::Scalar(-0.5f32) * (c_5.y() + (rt::Scalar(0f32) - root_4).select(root_4, c_5.y().elementwise_ge(rt::Scalar(0f32)))));
            if rt::Scalar::into_branch_condition(c_5.z().elementwise_ne(rt::Scalar(0f32))) {
                roots.set_x((q_10 / c_5.z()));
            }
            if rt::Scalar::into_branch_condition(q_10.elementwise_ne(rt::Scalar(0f32))) {
                roots.set_y((c_5.x() / q_10));
            }
        }
        let _e38 = roots;
        return _e38;
    }
    pub(crate) fn field_heights_gap(
        &self,
        path_11: Path,
        t_12: impl rt::Into<rt::Scalar<f32>>,
        params_10: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_field_heights_gap(path_11, rt::into(t_12), rt::into(params_10)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_heights_gap(
        &self,
        path_11: Path,
        t_12: rt::Scalar<f32>,
        params_10: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        let _e3 = self.v_path_height(path_11, t_12);
        let _e4 = self.v_path_uv(path_11, t_12);
        let _e6 = self.v_height_at(_e4, rt::Scalar(path_11.level));
        return (_e3 - _e6);
    }
    pub(crate) fn in_slice(
        &self,
        corners_2: impl rt::Into<rt::Vec4<f32>>,
        part_4: impl rt::Into<rt::Vec2<f32>>,
    ) -> f32 {
        rt::into(self.v_in_slice(rt::into(corners_2), rt::into(part_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_in_slice(
        &self,
        corners_2: rt::Vec4<f32>,
        part_4: rt::Vec2<f32>,
    ) -> rt::Scalar<f32> {
        let top_4 = (corners_2.x() + ((corners_2.y() - corners_2.x()) * part_4.x()));
        let bottom_2 = (corners_2.z() + ((corners_2.w() - corners_2.z()) * part_4.x()));
        return (top_4 + ((bottom_2 - top_4) * part_4.y()));
    }
    pub(crate) fn field_at_voxel(&self, place_11: impl rt::Into<rt::Vec3<f32>>) -> f32 {
        rt::into(self.v_field_at_voxel(rt::into(place_11)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_at_voxel(&self, place_11: rt::Vec3<f32>) -> rt::Scalar<f32> {
        let first_14 = place_11.floor();
        let part_21 = (place_11 - first_14);
        let _e4 = self.v_voxel_cell(first_14.to_i32());
        let _e7 = self.v_in_slice(_e4.low, part_21.xy());
        let _e10 = self.v_in_slice(_e4.high, part_21.xy());
        return (_e7 + ((_e10 - _e7) * part_21.z()));
    }
    pub(crate) fn voxel_place(&self, at_21: impl rt::Into<rt::Vec3<f32>>) -> rt::Vec3<f32> {
        rt::into(self.v_voxel_place(rt::into(at_21)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_voxel_place(&self, at_21: rt::Vec3<f32>) -> rt::Vec3<f32> {
        let _e1 = self.v_volume_size();
        return ((at_21 * _e1) - <rt::Vec3<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32), rt::Scalar(0.5f32)));
    }
    pub(crate) fn field_at(&self, at_22: impl rt::Into<rt::Vec3<f32>>) -> f32 {
        rt::into(self.v_field_at(rt::into(at_22)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_at(&self, at_22: rt::Vec3<f32>) -> rt::Scalar<f32> {
        let _e1 = self.v_voxel_place(at_22);
        let _e2 = self.v_field_at_voxel(_e1);
        return _e2;
    }
    pub(crate) fn field_volume_gap(
        &self,
        path_12: Path,
        t_13: impl rt::Into<rt::Scalar<f32>>,
        params_11: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_field_volume_gap(path_12, rt::into(t_13), rt::into(params_11)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_volume_gap(
        &self,
        path_12: Path,
        t_13: rt::Scalar<f32>,
        params_11: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        let _e3 = self.v_path_uv(path_12, t_13);
        let _e4 = self.v_path_height(path_12, t_13);
        let _e6 = self.v_field_at(<rt::Vec3<f32>>::new_21(_e3, _e4));
        return (rt::Scalar(0.5f32) - _e6);
    }
    pub(crate) fn field_motif_gap(
        &self,
        path_13: Path,
        t_14: impl rt::Into<rt::Scalar<f32>>,
        params_12: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_field_motif_gap(path_13, rt::into(t_14), rt::into(params_12)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_motif_gap(
        &self,
        path_13: Path,
        t_14: rt::Scalar<f32>,
        params_12: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        return rt::Scalar(1f32);
    }
    pub(crate) fn field_gap_stage(
        &self,
        path_14: Path,
        t_15: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_field_gap_stage(path_14, rt::into(t_15)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_field_gap_stage(
        &self,
        path_14: Path,
        t_15: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let _e6 = rt::Scalar(self.surface_settings.choices[4usize].number);
        match rt::Scalar::into_inner(_e6) {
            0u32 => {
                let _e11 = self.surface_settings.choices[4usize].params;
                let _e12 = self.v_field_heights_gap(path_14, t_15, _e11);
                return _e12;
            }
            1u32 => {
                let _e17 = self.surface_settings.choices[4usize].params;
                let _e18 = self.v_field_volume_gap(path_14, t_15, _e17);
                return _e18;
            }
            _ => {
                let _e23 = self.surface_settings.choices[4usize].params;
                let _e24 = self.v_field_motif_gap(path_14, t_15, _e23);
                return _e24;
            }
        }
    }
    pub(crate) fn path_gap(
        &self,
        path_15: Path,
        t_16: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_path_gap(path_15, rt::into(t_16)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_path_gap(
        &self,
        path_15: Path,
        t_16: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let _e2 = self.v_field_gap_stage(path_15, t_16);
        return _e2;
    }
    pub(crate) fn bracket_between(
        &self,
        path_16: Path,
        near: impl rt::Into<rt::Scalar<f32>>,
        far: impl rt::Into<rt::Scalar<f32>>,
        cost: impl rt::Into<rt::Vec3<u32>>,
    ) -> SearchResult {
        rt::into(self.v_bracket_between(path_16, rt::into(near), rt::into(far), rt::into(cost)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_bracket_between(
        &self,
        path_16: Path,
        near: rt::Scalar<f32>,
        far: rt::Scalar<f32>,
        cost: rt::Vec3<u32>,
    ) -> SearchResult {
        let mut local_18: rt::Scalar<bool>;

        let _e4 = self.v_path_gap(path_16, near);
        if rt::Scalar::into_branch_condition(near.elementwise_eq(rt::Scalar(0f32))) {
            local_18 = _e4.elementwise_lt(rt::Scalar(0f32));
        } else {
            local_18 = rt::Scalar(false);
        }
        let _e12 = local_18;
        if rt::Scalar::into_branch_condition(_e12) {
            return <SearchResult>::new(FOUND_STARTED_BELOW, rt::Scalar(0f32), rt::Scalar(0f32), _e4, _e4, (cost + HEIGHTS_READ));
        }
        let _e20 = self.v_path_gap(path_16, far);
        return <SearchResult>::new(FOUND_BRACKET, near, far, _e4, _e20, ((cost + HEIGHTS_READ) + HEIGHTS_READ));
    }
    pub(crate) fn cell_after(
        &self,
        grid: Grid,
        cell_11: impl rt::Into<rt::Vec2<f32>>,
        leave_2: impl rt::Into<rt::Vec2<f32>>,
        forward: impl rt::Into<rt::Vec2<bool>>,
        t_17: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_cell_after(grid, rt::into(cell_11), rt::into(leave_2), rt::into(forward), rt::into(t_17)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_cell_after(
        &self,
        grid: Grid,
        cell_11: rt::Vec2<f32>,
        leave_2: rt::Vec2<f32>,
        forward: rt::Vec2<bool>,
        t_17: rt::Scalar<f32>,
    ) -> rt::Vec2<f32> {
        let _e9 = self.v_cell_of((grid.origin + (grid.step * t_17)));
        let ahead_1 = _e9.max((cell_11 + <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)).select(<rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32)), leave_2.elementwise_le(<rt::Vec2<f32>>::from_scalars(t_17, t_17)))));
        let behind_1 = _e9.min((cell_11 - <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)).select(<rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32)), leave_2.elementwise_le(<rt::Vec2<f32>>::from_scalars(t_17, t_17)))));
        return behind_1.select(ahead_1, forward);
    }
    pub(crate) fn gap_to(
        &self,
        path_17: Path,
        grid_1: Grid,
        cell_12: impl rt::Into<rt::Vec2<f32>>,
        h_2: impl rt::Into<rt::Vec4<f32>>,
        t_18: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_gap_to(path_17, grid_1, rt::into(cell_12), rt::into(h_2), rt::into(t_18)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_gap_to(
        &self,
        path_17: Path,
        grid_1: Grid,
        cell_12: rt::Vec2<f32>,
        h_2: rt::Vec4<f32>,
        t_18: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let bx_1 = (h_2.y() - h_2.x());
        let by_4 = (h_2.z() - h_2.x());
        let twist_1 = ((h_2.x() - h_2.y()) + (h_2.w() - h_2.z()));
        let at_182 = ((grid_1.origin - cell_12) + (grid_1.step * t_18));
        let z_1 = (path_17.h.x() + (t_18 * (path_17.h.y() + (t_18 * path_17.h.z()))));
        let dz = (path_17.h.y() + ((rt::Scalar(2f32) * t_18) * path_17.h.z()));
        return <rt::Vec3<f32>>::from_scalars((z_1 - (((h_2.x() + (bx_1 * at_182.x())) + (by_4 * at_182.y())) + ((twist_1 * at_182.x()) * at_182.y()))), (dz - (((bx_1 * grid_1.step.x()) + (by_4 * grid_1.step.y())) + (twist_1 * ((at_182.x() * grid_1.step.y()) + (at_182.y() * grid_1.step.x()))))), (path_17.h.z() - ((twist_1 * grid_1.step.x()) * grid_1.step.y())));
    }
    pub(crate) fn object_none_cell(
        &self,
        cell_13: impl rt::Into<rt::Vec2<i32>>,
        level_12: impl rt::Into<rt::Scalar<u32>>,
        params_13: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_object_none_cell(rt::into(cell_13), rt::into(level_12), rt::into(params_13)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_object_none_cell(
        &self,
        cell_13: rt::Vec2<i32>,
        level_12: rt::Scalar<u32>,
        params_13: rt::Vec4<f32>,
    ) -> rt::Vec4<f32> {
        let _e3 = self.v_height_cell(cell_13, level_12);
        return _e3;
    }
    pub(crate) fn cell_of_images(
        &self,
        cell_14: impl rt::Into<rt::Vec2<i32>>,
        level_13: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_cell_of_images(rt::into(cell_14), rt::into(level_13)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_cell_of_images(
        &self,
        cell_14: rt::Vec2<i32>,
        level_13: rt::Scalar<u32>,
    ) -> rt::Vec4<f32> {
        let mut local_19: rt::Scalar<bool>;

        let _e4 = rt::Scalar(self.surface_settings.cells);
        if rt::Scalar::into_branch_condition(_e4.elementwise_eq(CELLS_BILINEAR)) {
            let _e7 = self.v_height_cell(cell_14, level_13);
            return _e7;
        }
        let _e10 = rt::Scalar(self.surface_settings.cells);
        if rt::Scalar::into_branch_condition(_e10.elementwise_eq(CELLS_HIGHEST)) {
            let _e13 = self.v_height_cell(cell_14, level_13);
            let most_6 = _e13.x().max(_e13.y()).max(_e13.z().max(_e13.w()));
            let least_2 = _e13.x().min(_e13.y()).min(_e13.z().min(_e13.w()));
            let _e31 = rt::Scalar(self.surface_settings.jump);
            if rt::Scalar::into_branch_condition((most_6 - least_2).elementwise_gt(_e31)) {
                return <rt::Vec4<f32>>::from_scalars(most_6, most_6, most_6, most_6);
            }
            return _e13;
        }
        let dual = <rt::Vec2<i32>>::from_scalars((cell_14.x() >> rt::Scalar(1u32)), (cell_14.y() >> rt::Scalar(1u32)));
        let _e41 = self.v_height_cell(dual, level_13);
        let most_7 = _e41.x().max(_e41.y()).max(_e41.z().max(_e41.w()));
        let least_3 = _e41.x().min(_e41.y()).min(_e41.z().min(_e41.w()));
        let right_1 = ((cell_14.x() - dual.x()) - dual.x()).elementwise_eq(rt::Scalar(1i32));
        let lower_3 = ((cell_14.y() - dual.y()) - dual.y()).elementwise_eq(rt::Scalar(1i32));
        let _e72 = rt::Scalar(self.surface_settings.cells);
        if rt::Scalar::into_branch_condition((!_e72.elementwise_eq(CELLS_NEAREST))) {
            let _e81 = rt::Scalar(self.surface_settings.jump);
            local_19 = (most_7 - least_3).elementwise_gt(_e81);
        } else {
            local_19 = rt::Scalar(true);
        }
        let _e84 = local_19;
        if rt::Scalar::into_branch_condition(_e84) {
            let nearest_3 = _e41.x().select(_e41.y(), right_1).select(_e41.z().select(_e41.w(), right_1), lower_3);
            return <rt::Vec4<f32>>::from_scalars(nearest_3, nearest_3, nearest_3, nearest_3);
        }
        let top_5 = (rt::Scalar(0.5f32) * (_e41.x() + _e41.y()));
        let bottom_3 = (rt::Scalar(0.5f32) * (_e41.z() + _e41.w()));
        let left_2 = (rt::Scalar(0.5f32) * (_e41.x() + _e41.z()));
        let side_7 = (rt::Scalar(0.5f32) * (_e41.y() + _e41.w()));
        let middle_10 = (rt::Scalar(0.5f32) * (top_5 + bottom_3));
        return <rt::Vec4<f32>>::from_scalars(_e41.x().select(top_5, right_1).select(left_2.select(middle_10, right_1), lower_3), top_5.select(_e41.y(), right_1).select(middle_10.select(side_7, right_1), lower_3), left_2.select(middle_10, right_1).select(_e41.z().select(bottom_3, right_1), lower_3), middle_10.select(side_7, right_1).select(bottom_3.select(_e41.w(), right_1), lower_3));
    }
    pub(crate) fn object_depth_cell(
        &self,
        cell_15: impl rt::Into<rt::Vec2<i32>>,
        level_14: impl rt::Into<rt::Scalar<u32>>,
        params_14: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_object_depth_cell(rt::into(cell_15), rt::into(level_14), rt::into(params_14)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_object_depth_cell(
        &self,
        cell_15: rt::Vec2<i32>,
        level_14: rt::Scalar<u32>,
        params_14: rt::Vec4<f32>,
    ) -> rt::Vec4<f32> {
        let _e3 = self.v_cell_of_images(cell_15, level_14);
        return _e3;
    }
    pub(crate) fn cell_of_mask(
        &self,
        cell_16: impl rt::Into<rt::Vec2<i32>>,
        level_15: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_cell_of_mask(rt::into(cell_16), rt::into(level_15)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_cell_of_mask(
        &self,
        cell_16: rt::Vec2<i32>,
        level_15: rt::Scalar<u32>,
    ) -> rt::Vec4<f32> {
        let _e2 = self.v_height_cell(cell_16, level_15);
        return <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32).select(rt::Scalar(1f32), _e2.x().elementwise_gt(rt::Scalar(0.00001f32))), rt::Scalar(0f32).select(rt::Scalar(1f32), _e2.y().elementwise_gt(rt::Scalar(0.00001f32))), rt::Scalar(0f32).select(rt::Scalar(1f32), _e2.z().elementwise_gt(rt::Scalar(0.00001f32))), rt::Scalar(0f32).select(rt::Scalar(1f32), _e2.w().elementwise_gt(rt::Scalar(0.00001f32))));
    }
    pub(crate) fn object_hull_cell(
        &self,
        cell_17: impl rt::Into<rt::Vec2<i32>>,
        level_16: impl rt::Into<rt::Scalar<u32>>,
        params_15: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_object_hull_cell(rt::into(cell_17), rt::into(level_16), rt::into(params_15)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_object_hull_cell(
        &self,
        cell_17: rt::Vec2<i32>,
        level_16: rt::Scalar<u32>,
        params_15: rt::Vec4<f32>,
    ) -> rt::Vec4<f32> {
        let _e3 = self.v_cell_of_mask(cell_17, level_16);
        return _e3;
    }
    pub(crate) fn object_blend_cell(
        &self,
        cell_18: impl rt::Into<rt::Vec2<i32>>,
        level_17: impl rt::Into<rt::Scalar<u32>>,
        params_16: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_object_blend_cell(rt::into(cell_18), rt::into(level_17), rt::into(params_16)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_object_blend_cell(
        &self,
        cell_18: rt::Vec2<i32>,
        level_17: rt::Scalar<u32>,
        params_16: rt::Vec4<f32>,
    ) -> rt::Vec4<f32> {
        let _e3 = self.v_height_cell(cell_18, level_17);
        return _e3;
    }
    pub(crate) fn object_cell_stage(
        &self,
        cell_19: impl rt::Into<rt::Vec2<i32>>,
        level_18: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_object_cell_stage(rt::into(cell_19), rt::into(level_18)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_object_cell_stage(
        &self,
        cell_19: rt::Vec2<i32>,
        level_18: rt::Scalar<u32>,
    ) -> rt::Vec4<f32> {
        let _e6 = rt::Scalar(self.surface_settings.choices[3usize].number);
        match rt::Scalar::into_inner(_e6) {
            0u32 => {
                let _e11 = self.surface_settings.choices[3usize].params;
                let _e12 = self.v_object_none_cell(cell_19, level_18, _e11);
                return _e12;
            }
            1u32 => {
                let _e17 = self.surface_settings.choices[3usize].params;
                let _e18 = self.v_object_depth_cell(cell_19, level_18, _e17);
                return _e18;
            }
            2u32 => {
                let _e23 = self.surface_settings.choices[3usize].params;
                let _e24 = self.v_object_hull_cell(cell_19, level_18, _e23);
                return _e24;
            }
            _ => {
                let _e29 = self.surface_settings.choices[3usize].params;
                let _e30 = self.v_object_blend_cell(cell_19, level_18, _e29);
                return _e30;
            }
        }
    }
    pub(crate) fn whole_cell(&self, cell_20: impl rt::Into<rt::Vec2<f32>>) -> rt::Vec2<i32> {
        rt::into(self.v_whole_cell(rt::into(cell_20)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_whole_cell(&self, cell_20: rt::Vec2<f32>) -> rt::Vec2<i32> {
        return cell_20.to_i32();
    }
    pub(crate) fn cell_gap(
        &self,
        path_18: Path,
        grid_2: Grid,
        cell_21: impl rt::Into<rt::Vec2<f32>>,
        t_19: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_cell_gap(path_18, grid_2, rt::into(cell_21), rt::into(t_19)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_cell_gap(
        &self,
        path_18: Path,
        grid_2: Grid,
        cell_21: rt::Vec2<f32>,
        t_19: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let _e4 = self.v_whole_cell(cell_21);
        let _e6 = self.v_object_cell_stage(_e4, rt::Scalar(path_18.level));
        let _e7 = self.v_gap_to(path_18, grid_2, cell_21, _e6, t_19);
        return _e7;
    }
    pub(crate) fn cell_leave(
        &self,
        grid_3: Grid,
        cell_22: impl rt::Into<rt::Vec2<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_cell_leave(grid_3, rt::into(cell_22)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_cell_leave(
        &self,
        grid_3: Grid,
        cell_22: rt::Vec2<f32>,
    ) -> rt::Vec2<f32> {
        let ahead_2 = <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)).select(<rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32)), grid_3.step.elementwise_gt(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32))));
        let leave_8 = (((cell_22 + ahead_2) - grid_3.origin) / grid_3.step);
        return <rt::Vec2<f32>>::from_scalars(rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32)).select(leave_8, grid_3.step.abs().elementwise_gt(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32))));
    }
    pub(crate) fn cell_next(
        &self,
        grid_4: Grid,
        cell_23: impl rt::Into<rt::Vec2<f32>>,
        leave_3: impl rt::Into<rt::Vec2<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_cell_next(grid_4, rt::into(cell_23), rt::into(leave_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_cell_next(
        &self,
        grid_4: Grid,
        cell_23: rt::Vec2<f32>,
        leave_3: rt::Vec2<f32>,
    ) -> rt::Vec2<f32> {
        let mut next_1: rt::Vec2<f32>;

        next_1 = cell_23;
        if rt::Scalar::into_branch_condition(leave_3.x().elementwise_le(leave_3.y())) {
            next_1.set_x((cell_23.x() + rt::Scalar(-1f32).select(rt::Scalar(1f32), grid_4.step.x().elementwise_gt(rt::Scalar(0f32)))));
        } else {
            next_1.set_y((cell_23.y() + rt::Scalar(-1f32).select(rt::Scalar(1f32), grid_4.step.y().elementwise_gt(rt::Scalar(0f32)))));
        }
        let _e27 = next_1;
        return _e27;
    }
    pub(crate) fn cell_slopes(
        &self,
        h_3: impl rt::Into<rt::Vec4<f32>>,
        part_5: impl rt::Into<rt::Vec2<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_cell_slopes(rt::into(h_3), rt::into(part_5)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_cell_slopes(
        &self,
        h_3: rt::Vec4<f32>,
        part_5: rt::Vec2<f32>,
    ) -> rt::Vec2<f32> {
        let top_6 = (h_3.y() - h_3.x());
        let left_3 = (h_3.z() - h_3.x());
        let twist_2 = ((h_3.w() - h_3.z()) - top_6);
        return <rt::Vec2<f32>>::from_scalars((top_6 + (twist_2 * part_5.y())), (left_3 + (twist_2 * part_5.x())));
    }
    pub(crate) fn swept_border(
        &self,
        sweep: Sweep,
        start: impl rt::Into<rt::Scalar<u32>>,
        to: impl rt::Into<rt::Scalar<u32>>,
        at_23: impl rt::Into<rt::Scalar<i32>>,
        parts: impl rt::Into<rt::Scalar<i32>>,
    ) -> rt::Vec2<u32> {
        rt::into(self.v_swept_border(sweep, rt::into(start), rt::into(to), rt::into(at_23), rt::into(parts)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_swept_border(
        &self,
        sweep: Sweep,
        start: rt::Scalar<u32>,
        to: rt::Scalar<u32>,
        at_23: rt::Scalar<i32>,
        parts: rt::Scalar<i32>,
    ) -> rt::Vec2<u32> {
        if rt::Scalar::into_branch_condition(at_23.elementwise_eq(rt::Scalar(0i32))) {
            return <rt::Vec2<u32>>::from_scalars(start, rt::Scalar(0u32));
        }
        if rt::Scalar::into_branch_condition(at_23.elementwise_eq(parts)) {
            return <rt::Vec2<u32>>::from_scalars(to, rt::Scalar(0u32));
        }
        let _e13 = self.v_around_three(start, rt::Scalar(1u32));
        if rt::Scalar::into_branch_condition(to.elementwise_eq(_e13)) {
            return <rt::Vec2<u32>>::from_scalars(start, at_23.to_u32());
        }
        return <rt::Vec2<u32>>::from_scalars(to, (parts - at_23).to_u32());
    }
    pub(crate) fn top_point(
        &self,
        sweep_1: Sweep,
        number_3: impl rt::Into<rt::Scalar<i32>>,
    ) -> SweptPoint {
        rt::into(self.v_top_point(sweep_1, rt::into(number_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_top_point(
        &self,
        sweep_1: Sweep,
        number_3: rt::Scalar<i32>,
    ) -> SweptPoint {
        let n_18 = sweep_1.parts.x();
        let m_4 = sweep_1.parts.y();
        let apex_1 = sweep_1.apex;
        if rt::Scalar::into_branch_condition(number_3.elementwise_le(n_18)) {
            let _e12 = self.v_swept_border(sweep_1, sweep_1.corners.x(), sweep_1.corners.z(), number_3, n_18);
            let sides = ON_FIRST.select(rt::Scalar(6u32), number_3.elementwise_eq(n_18));
            return <SweptPoint>::new(_e12.x(), _e12.y(), (apex_1.x() * number_3), (apex_1.y() * number_3), n_18, sides);
        }
        let k_59 = (number_3 - n_18);
        let _e29 = self.v_swept_border(sweep_1, sweep_1.corners.z(), sweep_1.corners.y(), k_59, m_4);
        let x_8 = ((apex_1.x() * (m_4 - k_59)) + (sweep_1.end.x() * k_59));
        let y_2 = ((apex_1.y() * (m_4 - k_59)) + (sweep_1.end.y() * k_59));
        return <SweptPoint>::new(_e29.x(), _e29.y(), x_8, y_2, m_4, ON_SECOND);
    }
    pub(crate) fn low_point(
        &self,
        sweep_2: Sweep,
        column_1: SweptColumn,
        at_24: impl rt::Into<rt::Scalar<i32>>,
    ) -> SweptPoint {
        rt::into(self.v_low_point(sweep_2, column_1, rt::into(at_24)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_low_point(
        &self,
        sweep_2: Sweep,
        column_1: SweptColumn,
        at_24: rt::Scalar<i32>,
    ) -> SweptPoint {
        let x_9 = rt::Scalar(column_1.column);
        if rt::Scalar::into_branch_condition(at_24.elementwise_gt(rt::Scalar(0i32))) {
            let y_3 = ((rt::Scalar(column_1.inside) + at_24) - rt::Scalar(1i32));
            return <SweptPoint>::new(INSIDE, (rt::Scalar(column_1.first) + (at_24 - rt::Scalar(1i32)).to_u32()), x_9, y_3, rt::Scalar(1i32), rt::Scalar(0u32));
        }
        let columns = sweep_2.end.x();
        let _e25 = self.v_swept_border(sweep_2, sweep_2.corners.x(), sweep_2.corners.y(), x_9, columns);
        let sides_1 = ((ON_PRIMARY + rt::Scalar(0u32).select(ON_FIRST, x_9.elementwise_eq(rt::Scalar(0i32)))) + rt::Scalar(0u32).select(ON_SECOND, x_9.elementwise_eq(columns)));
        return <SweptPoint>::new(_e25.x(), _e25.y(), (x_9 * columns), (sweep_2.end.y() * x_9), columns, sides_1);
    }
    pub(crate) fn chain_point(
        &self,
        sweep_3: Sweep,
        chain: SweptChain,
        number_4: impl rt::Into<rt::Scalar<i32>>,
    ) -> SweptPoint {
        rt::into(self.v_chain_point(sweep_3, chain, rt::into(number_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_chain_point(
        &self,
        sweep_3: Sweep,
        chain: SweptChain,
        number_4: rt::Scalar<i32>,
    ) -> SweptPoint {
        let column_8 = chain.column;
        let last_6 = ((rt::Scalar(column_8.from_top) + rt::Scalar(column_8.of_top)) - rt::Scalar(1i32));
        if rt::Scalar::into_branch_condition(rt::Scalar(chain.way).elementwise_eq(ROOF_DOWN)) {
            let _e13 = self.v_top_point(sweep_3, (last_6 - number_4));
            return _e13;
        }
        if rt::Scalar::into_branch_condition(rt::Scalar(chain.way).elementwise_eq(ROOF_UP)) {
            if rt::Scalar::into_branch_condition(number_4.elementwise_eq(rt::Scalar(0i32))) {
                let _e20 = self.v_low_point(sweep_3, column_8, rt::Scalar(column_8.inner));
                return _e20;
            }
            let _e25 = self.v_top_point(sweep_3, ((rt::Scalar(column_8.from_top) + number_4) - rt::Scalar(1i32)));
            return _e25;
        }
        if rt::Scalar::into_branch_condition(number_4.elementwise_le(rt::Scalar(column_8.inner))) {
            let _e28 = self.v_low_point(sweep_3, column_8, number_4);
            return _e28;
        }
        let on_1 = ((number_4 - rt::Scalar(column_8.inner)) - rt::Scalar(1i32));
        let is_from_behind = rt::Scalar(chain.way).elementwise_eq(TOP_BEFORE).elementwise_eq(rt::Scalar(column_8.top).elementwise_eq(rt::Scalar(chain.way)));
        let _e44 = self.v_top_point(sweep_3, (rt::Scalar(column_8.from_top) + on_1).select((last_6 - on_1), is_from_behind));
        return _e44;
    }
    pub(crate) fn chord_end(
        &self,
        at_25: Entered,
        k_1: impl rt::Into<rt::Scalar<u32>>,
    ) -> f32 {
        rt::into(self.v_chord_end(at_25, rt::into(k_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_chord_end(
        &self,
        at_25: Entered,
        k_1: rt::Scalar<u32>,
    ) -> rt::Scalar<f32> {
        return (at_25.span.x() + ((at_25.span.y() - at_25.span.x()).min(rt::Scalar(300000000000000000000000000000000000000f32)) * (k_1.to_f32() / rt::Scalar(at_25.segments).to_f32())));
    }
    pub(crate) fn shell_slack(
        &self,
        pixel_5: PixelIn,
        middle: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_shell_slack(pixel_5, rt::into(middle)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shell_slack(
        &self,
        pixel_5: PixelIn,
        middle: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let origin_4 = pixel_5.origin.abs();
        return (rt::Scalar(0.0000009536743f32) * (origin_4.x().max(origin_4.y()).max(origin_4.z()) + middle.abs()));
    }
    pub(crate) fn where_positive(
        &self,
        interval_2: impl rt::Into<rt::Vec2<f32>>,
        weight_1: impl rt::Into<rt::Scalar<f32>>,
        change: impl rt::Into<rt::Scalar<f32>>,
        slack: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_where_positive(rt::into(interval_2), rt::into(weight_1), rt::into(change), rt::into(slack)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_where_positive(
        &self,
        interval_2: rt::Vec2<f32>,
        weight_1: rt::Scalar<f32>,
        change: rt::Scalar<f32>,
        slack: rt::Scalar<f32>,
    ) -> rt::Vec2<f32> {
        if rt::Scalar::into_branch_condition(change.elementwise_eq(rt::Scalar(0f32))) {
            return <rt::Vec2<f32>>::from_scalars(rt::Scalar(300000000000000000000000000000000000000f32).select(interval_2.x(), weight_1.elementwise_ge((rt::Scalar(0f32) - slack))), interval_2.y());
        }
        let t_51 = (((rt::Scalar(0f32) - slack) - weight_1) / change);
        if rt::Scalar::into_branch_condition(change.elementwise_gt(rt::Scalar(0f32))) {
            return <rt::Vec2<f32>>::from_scalars(interval_2.x().max(t_51), interval_2.y());
        }
        return <rt::Vec2<f32>>::from_scalars(interval_2.x(), interval_2.y().min(t_51));
    }
    pub(crate) fn path_from(
        &self,
        path_19: Path,
        t_20: impl rt::Into<rt::Scalar<f32>>,
    ) -> Path {
        rt::into(self.v_path_from(path_19, rt::into(t_20)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_path_from(
        &self,
        path_19: Path,
        t_20: rt::Scalar<f32>,
    ) -> Path {
        let mut rest: Path;

        rest = path_19;
        let _e4 = self.v_path_uv(path_19, t_20);
        rest.uv = _e4;
        rest.h = <rt::Vec3<f32>>::from_scalars((path_19.h.x() + (t_20 * (path_19.h.y() + (t_20 * path_19.h.z())))), (path_19.h.y() + ((rt::Scalar(2f32) * t_20) * path_19.h.z())), path_19.h.z());
        rt::Scalar(rest.exit) = (rt::Scalar(path_19.exit) - t_20);
        rt::Scalar(rest.start) = (rt::Scalar(path_19.start) + t_20);
        let _e33 = rest;
        return _e33;
    }
    pub(crate) fn field_heights_is_ground(
        &self,
        level_19: impl rt::Into<rt::Scalar<u32>>,
        params_17: impl rt::Into<rt::Vec4<f32>>,
    ) -> bool {
        rt::into(self.v_field_heights_is_ground(rt::into(level_19), rt::into(params_17)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_heights_is_ground(
        &self,
        level_19: rt::Scalar<u32>,
        params_17: rt::Vec4<f32>,
    ) -> rt::Scalar<bool> {
        return rt::Scalar(true);
    }
    pub(crate) fn field_volume_is_ground(
        &self,
        level_20: impl rt::Into<rt::Scalar<u32>>,
        params_18: impl rt::Into<rt::Vec4<f32>>,
    ) -> bool {
        rt::into(self.v_field_volume_is_ground(rt::into(level_20), rt::into(params_18)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_volume_is_ground(
        &self,
        level_20: rt::Scalar<u32>,
        params_18: rt::Vec4<f32>,
    ) -> rt::Scalar<bool> {
        return rt::Scalar(false);
    }
    pub(crate) fn field_motif_is_ground(
        &self,
        level_21: impl rt::Into<rt::Scalar<u32>>,
        params_19: impl rt::Into<rt::Vec4<f32>>,
    ) -> bool {
        rt::into(self.v_field_motif_is_ground(rt::into(level_21), rt::into(params_19)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_motif_is_ground(
        &self,
        level_21: rt::Scalar<u32>,
        params_19: rt::Vec4<f32>,
    ) -> rt::Scalar<bool> {
        return rt::Scalar(false);
    }
    pub(crate) fn field_is_ground_stage(&self, level_22: impl rt::Into<rt::Scalar<u32>>) -> bool {
        rt::into(self.v_field_is_ground_stage(rt::into(level_22)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_field_is_ground_stage(&self, level_22: rt::Scalar<u32>) -> rt::Scalar<bool> {
        let _e5 = rt::Scalar(self.surface_settings.choices[4usize].number);
        match rt::Scalar::into_inner(_e5) {
            0u32 => {
                let _e10 = self.surface_settings.choices[4usize].params;
                let _e11 = self.v_field_heights_is_ground(level_22, _e10);
                return _e11;
            }
            1u32 => {
                let _e16 = self.surface_settings.choices[4usize].params;
                let _e17 = self.v_field_volume_is_ground(level_22, _e16);
                return _e17;
            }
            _ => {
                let _e22 = self.surface_settings.choices[4usize].params;
                let _e23 = self.v_field_motif_is_ground(level_22, _e22);
                return _e23;
            }
        }
    }
    pub(crate) fn object_none_parts(
        &self,
        level_23: impl rt::Into<rt::Scalar<u32>>,
        params_20: impl rt::Into<rt::Vec4<f32>>,
    ) -> i32 {
        rt::into(self.v_object_none_parts(rt::into(level_23), rt::into(params_20)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_object_none_parts(
        &self,
        level_23: rt::Scalar<u32>,
        params_20: rt::Vec4<f32>,
    ) -> rt::Scalar<i32> {
        return rt::Scalar(1i32);
    }
    pub(crate) fn parts_of_images(&self) -> i32 {
        rt::into(self.v_parts_of_images())
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_parts_of_images(&self) -> rt::Scalar<i32> {
        let mut local_20: rt::Scalar<bool>;

        let cells_2 = rt::Scalar(self.surface_settings.cells);
        if rt::Scalar::into_branch_condition((!cells_2.elementwise_eq(CELLS_STEP))) {
            local_20 = cells_2.elementwise_eq(CELLS_NEAREST);
        } else {
            local_20 = rt::Scalar(true);
        }
        let _e11 = local_20;
        return rt::Scalar(1i32).select(rt::Scalar(2i32), _e11);
    }
    pub(crate) fn object_depth_parts(
        &self,
        level_24: impl rt::Into<rt::Scalar<u32>>,
        params_21: impl rt::Into<rt::Vec4<f32>>,
    ) -> i32 {
        rt::into(self.v_object_depth_parts(rt::into(level_24), rt::into(params_21)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_object_depth_parts(
        &self,
        level_24: rt::Scalar<u32>,
        params_21: rt::Vec4<f32>,
    ) -> rt::Scalar<i32> {
        let _e2 = self.v_parts_of_images();
        return _e2;
    }
    pub(crate) fn object_hull_parts(
        &self,
        level_25: impl rt::Into<rt::Scalar<u32>>,
        params_22: impl rt::Into<rt::Vec4<f32>>,
    ) -> i32 {
        rt::into(self.v_object_hull_parts(rt::into(level_25), rt::into(params_22)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_object_hull_parts(
        &self,
        level_25: rt::Scalar<u32>,
        params_22: rt::Vec4<f32>,
    ) -> rt::Scalar<i32> {
        return rt::Scalar(1i32);
    }
    pub(crate) fn object_blend_parts(
        &self,
        level_26: impl rt::Into<rt::Scalar<u32>>,
        params_23: impl rt::Into<rt::Vec4<f32>>,
    ) -> i32 {
        rt::into(self.v_object_blend_parts(rt::into(level_26), rt::into(params_23)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_object_blend_parts(
        &self,
        level_26: rt::Scalar<u32>,
        params_23: rt::Vec4<f32>,
    ) -> rt::Scalar<i32> {
        return rt::Scalar(1i32);
    }
    pub(crate) fn object_parts_stage(&self, level_27: impl rt::Into<rt::Scalar<u32>>) -> i32 {
        rt::into(self.v_object_parts_stage(rt::into(level_27)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_object_parts_stage(&self, level_27: rt::Scalar<u32>) -> rt::Scalar<i32> {
        let _e5 = rt::Scalar(self.surface_settings.choices[3usize].number);
        match rt::Scalar::into_inner(_e5) {
            0u32 => {
                let _e10 = self.surface_settings.choices[3usize].params;
                let _e11 = self.v_object_none_parts(level_27, _e10);
                return _e11;
            }
            1u32 => {
                let _e16 = self.surface_settings.choices[3usize].params;
                let _e17 = self.v_object_depth_parts(level_27, _e16);
                return _e17;
            }
            2u32 => {
                let _e22 = self.surface_settings.choices[3usize].params;
                let _e23 = self.v_object_hull_parts(level_27, _e22);
                return _e23;
            }
            _ => {
                let _e28 = self.surface_settings.choices[3usize].params;
                let _e29 = self.v_object_blend_parts(level_27, _e28);
                return _e29;
            }
        }
    }
    pub(crate) fn grid_of(&self, path_20: Path) -> Grid {
        rt::into(self.v_grid_of(path_20))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_grid_of(&self, path_20: Path) -> Grid {
        let _e2 = self.v_height_size(rt::Scalar(path_20.level));
        let _e4 = self.v_object_parts_stage(rt::Scalar(path_20.level));
        let parts_5 = _e4.to_f32();
        return <Grid>::new((((path_20.uv * _e2) - <rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32))) * parts_5), ((path_20.duv * _e2) * parts_5));
    }
    pub(crate) fn rounded_gap(
        &self,
        path_21: Path,
        slack_1: impl rt::Into<rt::Scalar<f32>>,
        texels_1: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_rounded_gap(path_21, rt::into(slack_1), rt::into(texels_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_rounded_gap(
        &self,
        path_21: Path,
        slack_1: rt::Scalar<f32>,
        texels_1: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let _e4 = self.v_height_size(rt::Scalar(path_21.level));
        let _e11 = self.v_cell_of(((path_21.uv * _e4) - <rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32))));
        let _e14 = self.v_height_cell(_e11.to_i32(), rt::Scalar(path_21.level));
        let range = (_e14.x().max(_e14.y()).max(_e14.z().max(_e14.w())) - _e14.x().min(_e14.y()).min(_e14.z().min(_e14.w())));
        let change_3 = (path_21.duv.abs() * _e4);
        let places = ((path_21.uv.abs() * _e4) * rt::Scalar(0.0000009536743f32));
        let aside_2 = (((((change_3.x() + change_3.y()) * slack_1) + places.x()) + places.y()) + texels_1);
        return (((path_21.h.y().abs() * slack_1) + (range * aside_2)) + rt::Scalar(0.0000009536743f32));
    }
    pub(crate) fn out_of_ground(
        &self,
        path_22: Path,
        slack_2: impl rt::Into<rt::Scalar<f32>>,
        texels_2: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_out_of_ground(path_22, rt::into(slack_2), rt::into(texels_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_out_of_ground(
        &self,
        path_22: Path,
        slack_2: rt::Scalar<f32>,
        texels_2: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let mut cell_24: rt::Vec2<f32>;
        let mut t_21: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut local_21: rt::Scalar<bool>;
        let mut local_22: rt::Scalar<bool>;
        let mut local_23: rt::Scalar<bool>;

        let _e4 = self.v_field_is_ground_stage(rt::Scalar(path_22.level));
        if rt::Scalar::into_branch_condition((!_e4)) {
            return rt::Scalar(0f32);
        }
        let _e7 = self.v_grid_of(path_22);
        let _e8 = self.v_rounded_gap(path_22, slack_2, texels_2);
        let _e10 = self.v_cell_of(_e7.origin);
        cell_24 = _e10;
        let _e14 = cell_24;
        let _e16 = self.v_cell_gap(path_22, _e7, _e14, rt::Scalar(0f32));
        let is_near = _e16.x().elementwise_ge((rt::Scalar(0f32) - _e8));
        if rt::Scalar::into_branch_condition(_e16.x().elementwise_le(rt::Scalar(0f32))) {
            local_21 = _e16.y().elementwise_gt(rt::Scalar(0f32));
        } else {
            local_21 = rt::Scalar(false);
        }
        let comes_out = local_21;
        if rt::Scalar::into_branch_condition(is_near) {
            local_22 = (!comes_out);
        } else {
            local_22 = rt::Scalar(false);
        }
        let _e35 = local_22;
        if rt::Scalar::into_branch_condition(_e35) {
            return rt::Scalar(0f32);
        }
        let _e38 = self.v_rounded_gap(path_22, slack_2, rt::Scalar(0f32));
        'naga_break: loop {
            'naga_continue: {
                let _e39 = t_21;
                if rt::Scalar::into_branch_condition(_e39.elementwise_lt(rt::Scalar(path_22.exit))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e42 = cell_24;
                    let _e43 = self.v_cell_leave(_e7, _e42);
                    let end_8 = _e43.x().min(_e43.y()).min(rt::Scalar(path_22.exit));
                    let _e52 = cell_24;
                    let _e53 = t_21;
                    let _e54 = self.v_cell_gap(path_22, _e7, _e52, _e53);
                    let below_4 = (<rt::Vec3<f32>>::from_scalars(_e38, rt::Scalar(0f32), rt::Scalar(0f32)) - _e54);
                    if rt::Scalar::into_branch_condition((!below_4.x().elementwise_gt(rt::Scalar(0f32)))) {
                        let _e60 = t_21;
                        return _e60;
                    }
                    let _e61 = t_21;
                    let span_8 = (end_8 - _e61).max(rt::Scalar(0f32));
                    let _e65 = self.v_first_root(below_4, span_8);
                    if rt::Scalar::into_branch_condition(_e65.elementwise_lt(rt::Scalar(300000000000000000000000000000000000000f32))) {
                        let _e68 = t_21;
                        return (_e68 + _e65);
                    }
                    if rt::Scalar::into_branch_condition(is_near) {
                        let _e72 = self.v_quadratic(below_4, span_8);
                        local_23 = _e72.elementwise_gt((_e38 + _e8));
                    } else {
                        local_23 = rt::Scalar(false);
                    }
                    let _e76 = local_23;
                    if rt::Scalar::into_branch_condition(_e76) {
                        return rt::Scalar(0f32);
                    }
                    let _e78 = cell_24;
                    let _e79 = self.v_cell_next(_e7, _e78, _e43);
                    cell_24 = _e79;
                    let _e80 = t_21;
                    t_21 = _e80.max(end_8);
                }
            }
        }
        return rt::Scalar(path_22.exit);
    }
    pub(crate) fn chord_path(
        &self,
        pixel_6: PixelIn,
        at_26: Entered,
        middle_1: impl rt::Into<rt::Scalar<f32>>,
        params_24: impl rt::Into<rt::Vec4<f32>>,
        a_8: ShellPoint,
        b_8: ShellPoint,
        bend_2: impl rt::Into<rt::Scalar<f32>>,
        ends: impl rt::Into<rt::Vec2<f32>>,
        beyond: impl rt::Into<rt::Vec3<f32>>,
    ) -> Path {
        rt::into(self.v_chord_path(pixel_6, at_26, rt::into(middle_1), rt::into(params_24), a_8, b_8, rt::into(bend_2), rt::into(ends), rt::into(beyond)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_chord_path(
        &self,
        pixel_6: PixelIn,
        at_26: Entered,
        middle_1: rt::Scalar<f32>,
        params_24: rt::Vec4<f32>,
        a_8: ShellPoint,
        b_8: ShellPoint,
        bend_2: rt::Scalar<f32>,
        ends: rt::Vec2<f32>,
        beyond: rt::Vec3<f32>,
    ) -> Path {
        let mut inside: rt::Vec2<f32>;
        let mut path_23: Path;

        let heights_1 = pixel_6.shell.heights;
        let first_15 = ends.x();
        let long = (ends.y() - ends.x());
        let _e16 = self.v_uv_of(pixel_6, a_8.weights);
        let _e18 = self.v_uv_of(pixel_6, b_8.weights);
        let duv_4 = ((_e18 - _e16) / rt::Vec2::splat_from_scalar(long));
        let slope_9 = ((rt::Scalar(b_8.height) - rt::Scalar(a_8.height)) - bend_2);
        let _e26 = self.v_shell_slack(pixel_6, middle_1);
        let change_4 = ((b_8.weights - a_8.weights) / rt::Vec3::splat_from_scalar(long));
        inside = <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32).max(((rt::Scalar(0f32) - middle_1) - first_15)), long);
        let _e39 = inside;
        let _e44 = self.v_where_positive(_e39, a_8.weights.x(), change_4.x(), beyond.x());
        inside = _e44;
        let _e45 = inside;
        let _e50 = self.v_where_positive(_e45, a_8.weights.y(), change_4.y(), beyond.y());
        inside = _e50;
        let _e51 = inside;
        let _e56 = self.v_where_positive(_e51, a_8.weights.z(), change_4.z(), beyond.z());
        inside = _e56;
        let _e59 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e59.elementwise_eq(WRAP_CLAMP)) {
            let _e64 = inside;
            let _e65 = self.v_inside_unit(_e16.x(), duv_4.x(), _e64);
            inside = _e65;
            let _e68 = inside;
            let _e69 = self.v_inside_unit(_e16.y(), duv_4.y(), _e68);
            inside = _e69;
        }
        let _e76 = inside.y();
        path_23 = <Path>::new(_e16, duv_4, <rt::Vec3<f32>>::from_scalars(rt::Scalar(a_8.height), (slope_9 / long), (bend_2 / (long * long))), _e76, rt::Scalar(0f32), at_26.metric, RAY_VIEW, rt::Scalar(at_26.level), (middle_1 + first_15), (rt::Scalar(1f32) / rt::Scalar(at_26.segments).to_f32()), rt::Scalar(0f32));
        let _e90 = inside.y();
        let _e92 = inside.x();
        if rt::Scalar::into_branch_condition((!_e90.elementwise_gt(_e92))) {
            rt::Scalar(path_23.exit) = rt::Scalar(0f32);
            let _e97 = path_23;
            return _e97;
        }
        let _e98 = path_23;
        let _e100 = inside.x();
        let _e101 = self.v_path_from(_e98, _e100);
        path_23 = _e101;
        let _e104 = path_23.h.x();
        let above_6 = (_e104 - heights_1.y());
        if rt::Scalar::into_branch_condition(above_6.elementwise_gt(rt::Scalar(0f32))) {
            let _e109 = path_23;
            let _e112 = path_23.h.y();
            let _e115 = path_23.h.z();
            let _e118 = rt::Scalar(path_23.exit);
            let _e119 = self.v_first_root(<rt::Vec3<f32>>::from_scalars(above_6, _e112, _e115), _e118);
            let _e121 = rt::Scalar(path_23.exit);
            let _e123 = self.v_path_from(_e109, _e119.min(_e121));
            path_23 = _e123;
        }
        let _e125 = rt::Scalar(path_23.exit);
        if rt::Scalar::into_branch_condition(_e125.elementwise_gt(rt::Scalar(0f32))) {
            let _e128 = path_23;
            let _e129 = path_23;
            let _e133 = self.v_out_of_ground(_e129, (rt::Scalar(4f32) * _e26), params_24.x());
            let _e134 = self.v_path_from(_e128, _e133);
            path_23 = _e134;
        }
        let _e135 = path_23;
        return _e135;
    }
    pub(crate) fn chord_reach(
        &self,
        pixel_7: PixelIn,
        at_27: Entered,
        middle_2: impl rt::Into<rt::Scalar<f32>>,
        params_25: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_chord_reach(pixel_7, at_27, rt::into(middle_2), rt::into(params_25)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_chord_reach(
        &self,
        pixel_7: PixelIn,
        at_27: Entered,
        middle_2: rt::Scalar<f32>,
        params_25: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        let _e11 = self.v_height_size(rt::Scalar(0u32));
        let _e14 = self.v_height_size(rt::Scalar(0u32));
        let texel_10 = (at_27.metric.x().max(at_27.metric.z()).sqrt() / _e11.x().max(_e14.y()));
        let _e18 = self.v_shell_slack(pixel_7, middle_2);
        return (_e18 + ((rt::Scalar(2f32) * params_25.x()) * texel_10));
    }
    pub(crate) fn way_bend(
        &self,
        a_9: impl rt::Into<rt::Scalar<f32>>,
        m_1: impl rt::Into<rt::Scalar<f32>>,
        b_9: impl rt::Into<rt::Scalar<f32>>,
        part_6: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_way_bend(rt::into(a_9), rt::into(m_1), rt::into(b_9), rt::into(part_6)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_way_bend(
        &self,
        a_9: rt::Scalar<f32>,
        m_1: rt::Scalar<f32>,
        b_9: rt::Scalar<f32>,
        part_6: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let mut local_24: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition(part_6.elementwise_gt(rt::Scalar(0.125f32))) {
            local_24 = part_6.elementwise_lt(rt::Scalar(0.875f32));
        } else {
            local_24 = rt::Scalar(false);
        }
        let _e11 = local_24;
        if rt::Scalar::into_branch_condition(_e11) {
            return (((m_1 - a_9) - ((b_9 - a_9) * part_6)) / (part_6 * (part_6 - rt::Scalar(1f32))));
        }
        return rt::Scalar(0f32);
    }
    pub(crate) fn chords_of_piece(
        &self,
        pixel_8: PixelIn,
        prism_2: Prism,
        along_2: impl rt::Into<rt::Vec3<f32>>,
        way_14: Way,
        piece: impl rt::Into<rt::Vec2<f32>>,
        tolerance: impl rt::Into<rt::Scalar<f32>>,
    ) -> u32 {
        rt::into(self.v_chords_of_piece(pixel_8, prism_2, rt::into(along_2), way_14, rt::into(piece), rt::into(tolerance)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_chords_of_piece(
        &self,
        pixel_8: PixelIn,
        prism_2: Prism,
        along_2: rt::Vec3<f32>,
        way_14: Way,
        piece: rt::Vec2<f32>,
        tolerance: rt::Scalar<f32>,
    ) -> rt::Scalar<u32> {
        let mut local_25: rt::Scalar<bool>;
        let mut local_26: rt::Scalar<bool>;
        let mut local_27: rt::Scalar<bool>;
        let mut local_28: rt::Scalar<bool>;
        let mut local_29: rt::Scalar<bool>;
        let mut local_30: rt::Scalar<bool>;
        let mut local_31: rt::Scalar<bool>;

        let long_1 = (piece.y() - piece.x()).min(rt::Scalar(300000000000000000000000000000000000000f32));
        let _e12 = self.v_way_point(prism_2, along_2, way_14, piece.x());
        let _e17 = self.v_way_point(prism_2, along_2, way_14, (piece.x() + (rt::Scalar(0.25f32) * long_1)));
        let _e22 = self.v_way_point(prism_2, along_2, way_14, (piece.x() + (rt::Scalar(0.5f32) * long_1)));
        let _e27 = self.v_way_point(prism_2, along_2, way_14, (piece.x() + (rt::Scalar(0.75f32) * long_1)));
        let _e29 = self.v_way_point(prism_2, along_2, way_14, piece.y());
        if rt::Scalar::into_branch_condition(rt::Scalar(_e12.t).elementwise_lt(rt::Scalar(_e17.t))) {
            local_25 = rt::Scalar(_e17.t).elementwise_lt(rt::Scalar(_e22.t));
        } else {
            local_25 = rt::Scalar(false);
        }
        let _e39 = local_25;
        if rt::Scalar::into_branch_condition(_e39) {
            local_26 = rt::Scalar(_e22.t).elementwise_lt(rt::Scalar(_e27.t));
        } else {
            local_26 = rt::Scalar(false);
        }
        let _e46 = local_26;
        if rt::Scalar::into_branch_condition(_e46) {
            local_27 = rt::Scalar(_e27.t).elementwise_lt(rt::Scalar(_e29.t));
        } else {
            local_27 = rt::Scalar(false);
        }
        let rises_2 = local_27;
        if rt::Scalar::into_branch_condition(rt::Scalar(_e12.t).elementwise_gt(rt::Scalar(_e17.t))) {
            local_28 = rt::Scalar(_e17.t).elementwise_gt(rt::Scalar(_e22.t));
        } else {
            local_28 = rt::Scalar(false);
        }
        let _e63 = local_28;
        if rt::Scalar::into_branch_condition(_e63) {
            local_29 = rt::Scalar(_e22.t).elementwise_gt(rt::Scalar(_e27.t));
        } else {
            local_29 = rt::Scalar(false);
        }
        let _e70 = local_29;
        if rt::Scalar::into_branch_condition(_e70) {
            local_30 = rt::Scalar(_e27.t).elementwise_gt(rt::Scalar(_e29.t));
        } else {
            local_30 = rt::Scalar(false);
        }
        let falls = local_30;
        if rt::Scalar::into_branch_condition((!rises_2)) {
            local_31 = (!falls);
        } else {
            local_31 = rt::Scalar(false);
        }
        let _e83 = local_31;
        if rt::Scalar::into_branch_condition(_e83) {
            return rt::Scalar(16u32);
        }
        let _e98 = self.v_way_bend(rt::Scalar(_e12.point.height), rt::Scalar(_e22.point.height), rt::Scalar(_e29.point.height), ((rt::Scalar(_e22.t) - rt::Scalar(_e12.t)) / (rt::Scalar(_e29.t) - rt::Scalar(_e12.t))));
        let _e99 = self.v_beside_way(pixel_8, _e12, _e29, _e98, _e17);
        let _e100 = self.v_beside_way(pixel_8, _e12, _e29, _e98, _e27);
        let quarters = _e99.max(_e100);
        let _e102 = self.v_beside_way(pixel_8, _e12, _e29, _e98, _e22);
        let most_8 = _e102.max(quarters);
        return (most_8 / tolerance).sqrt().ceil().clamp(rt::Scalar(1f32), rt::Scalar(16f32)).to_u32();
    }
    pub(crate) fn factor_place(
        &self,
        number_5: impl rt::Into<rt::Scalar<i32>>,
        n_8: impl rt::Into<rt::Vec2<i32>>,
    ) -> rt::Vec2<i32> {
        rt::into(self.v_factor_place(rt::into(number_5), rt::into(n_8)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_factor_place(
        &self,
        number_5: rt::Scalar<i32>,
        n_8: rt::Vec2<i32>,
    ) -> rt::Vec2<i32> {
        let row_10 = ((number_5.to_f32() + rt::Scalar(0.5f32)) / n_8.x().to_f32()).to_i32();
        return <rt::Vec2<i32>>::from_scalars((number_5 - (row_10 * n_8.x())), (n_8.y() + row_10));
    }
    pub(crate) fn term_scales(
        &self,
        path_24: Path,
        number_6: impl rt::Into<rt::Scalar<i32>>,
        n_9: impl rt::Into<rt::Vec2<i32>>,
        layer_2: impl rt::Into<rt::Scalar<i32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_term_scales(path_24, rt::into(number_6), rt::into(n_9), rt::into(layer_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_term_scales(
        &self,
        path_24: Path,
        number_6: rt::Scalar<i32>,
        n_9: rt::Vec2<i32>,
        layer_2: rt::Scalar<i32>,
    ) -> rt::Vec4<f32> {
        let level_64 = rt::Scalar(path_24.level).to_i32();
        let _e6 = self.v_factor_place(number_6, n_9);
        let _e7 = self.v_search_texel(path_24, _e6, layer_2, level_64);
        let _e10 = self.v_factor_place((number_6 + rt::Scalar(1i32)), n_9);
        let _e11 = self.v_search_texel(path_24, _e10, layer_2, level_64);
        let root_5 = (_e7 + (_e11 * rt::Scalar(0.003921569f32)));
        return ((root_5 * root_5) * rt::Scalar(512f32));
    }
    pub(crate) fn clustered_way(
        &self,
        path_25: Path,
        texel_2: impl rt::Into<rt::Vec2<i32>>,
        pair: ViewPair,
        params_26: impl rt::Into<rt::Vec4<f32>>,
        layers: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_clustered_way(path_25, rt::into(texel_2), pair, rt::into(params_26), rt::into(layers)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_clustered_way(
        &self,
        path_25: Path,
        texel_2: rt::Vec2<i32>,
        pair: ViewPair,
        params_26: rt::Vec4<f32>,
        layers: rt::Scalar<u32>,
    ) -> rt::Vec2<f32> {
        let mut both: rt::Vec2<f32> = <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32));
        let mut layer_3: rt::Scalar<i32> = rt::Scalar(1i32);

        let _e6 = self.v_height_texels(rt::Scalar(path_25.level));
        let level_65 = rt::Scalar(path_25.level).to_i32();
        let bends = params_26.z().to_i32();
        let count_13 = ((params_26.x() * params_26.y()).to_i32() * bends);
        let _e17 = self.v_search_texel(path_25, texel_2, rt::Scalar(0i32), level_65);
        let cluster = ((_e17.x() * rt::Scalar(255f32)) + rt::Scalar(0.5f32)).floor().to_i32();
        let first_16 = (cluster * (count_13 + rt::Scalar(2i32)));
        let lower_view = ((first_16 + (rt::Scalar(pair.layer) * bends)) + rt::Scalar(pair.bend).to_i32());
        let _e34 = self.v_factor_place(lower_view, _e6);
        let _e36 = self.v_factor_place((lower_view + bends), _e6);
        'naga_break: loop {
            'naga_continue: {
                let _e43 = layer_3;
                if rt::Scalar::into_branch_condition(_e43.elementwise_lt(layers.to_i32())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e46 = layer_3;
                    let _e47 = self.v_search_texel(path_25, texel_2, _e46, level_65);
                    let _e49 = layer_3;
                    let _e50 = self.v_term_scales(path_25, (first_16 + count_13), _e6, _e49);
                    let scaled = (_e47 * _e50);
                    let _e52 = layer_3;
                    let _e53 = self.v_search_texel(path_25, _e34, _e52, level_65);
                    let _e54 = layer_3;
                    let _e55 = self.v_search_texel(path_25, _e36, _e54, level_65);
                    let _e56 = both;
                    both = (_e56 + (<rt::Vec2<f32>>::from_scalars(_e53.x(), _e55.x()) * scaled.x()));
                    let _e63 = both;
                    both = (_e63 + (<rt::Vec2<f32>>::from_scalars(_e53.y(), _e55.y()) * scaled.y()));
                    let _e70 = both;
                    both = (_e70 + (<rt::Vec2<f32>>::from_scalars(_e53.z(), _e55.z()) * scaled.z()));
                    let _e77 = both;
                    both = (_e77 + (<rt::Vec2<f32>>::from_scalars(_e53.w(), _e55.w()) * scaled.w()));
                    let _e84 = layer_3;
                    layer_3 = (_e84 + rt::Scalar(1i32));
                }
            }
        }
        let _e87 = both;
        return _e87;
    }
    pub(crate) fn flagged_ways(
        &self,
        lower: impl rt::Into<rt::Scalar<f32>>,
        upper: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_flagged_ways(rt::into(lower), rt::into(upper)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_flagged_ways(
        &self,
        lower: rt::Scalar<f32>,
        upper: rt::Scalar<f32>,
    ) -> rt::Vec4<f32> {
        let is_lower = lower.elementwise_lt(rt::Scalar(1.125f32));
        let is_upper = upper.elementwise_lt(rt::Scalar(1.125f32));
        return <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32).select(lower.clamp(rt::Scalar(0f32), rt::Scalar(0.99607843f32)), is_lower), rt::Scalar(0f32).select(rt::Scalar(1f32), is_lower), rt::Scalar(0f32).select(upper.clamp(rt::Scalar(0f32), rt::Scalar(0.99607843f32)), is_upper), rt::Scalar(0f32).select(rt::Scalar(1f32), is_upper));
    }
    pub(crate) fn joined_texels(
        &self,
        lower_1: impl rt::Into<rt::Vec4<f32>>,
        upper_1: impl rt::Into<rt::Vec4<f32>>,
        part_7: impl rt::Into<rt::Vec2<f32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_joined_texels(rt::into(lower_1), rt::into(upper_1), rt::into(part_7)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_joined_texels(
        &self,
        lower_1: rt::Vec4<f32>,
        upper_1: rt::Vec4<f32>,
        part_7: rt::Vec2<f32>,
    ) -> rt::Vec4<f32> {
        let _e5 = self.v_flagged_ways(lower_1.x(), upper_1.x());
        let _e8 = self.v_flagged_ways(lower_1.y(), upper_1.y());
        let _e11 = self.v_flagged_ways(lower_1.z(), upper_1.z());
        let _e14 = self.v_flagged_ways(lower_1.w(), upper_1.w());
        let _e15 = self.v_bilinear(_e5, _e8, _e11, _e14, part_7);
        return _e15;
    }
    pub(crate) fn clustered_ways(
        &self,
        path_26: Path,
        around: Around,
        pair_1: ViewPair,
        params_27: impl rt::Into<rt::Vec4<f32>>,
        layers_1: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_clustered_ways(path_26, around, pair_1, rt::into(params_27), rt::into(layers_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_clustered_ways(
        &self,
        path_26: Path,
        around: Around,
        pair_1: ViewPair,
        params_27: rt::Vec4<f32>,
        layers_1: rt::Scalar<u32>,
    ) -> rt::Vec4<f32> {
        let _e10 = self.v_clustered_way(path_26, <rt::Vec2<i32>>::from_scalars(around.columns.x(), around.rows.x()), pair_1, params_27, layers_1);
        let _e16 = self.v_clustered_way(path_26, <rt::Vec2<i32>>::from_scalars(around.columns.y(), around.rows.x()), pair_1, params_27, layers_1);
        let _e22 = self.v_clustered_way(path_26, <rt::Vec2<i32>>::from_scalars(around.columns.x(), around.rows.y()), pair_1, params_27, layers_1);
        let _e28 = self.v_clustered_way(path_26, <rt::Vec2<i32>>::from_scalars(around.columns.y(), around.rows.y()), pair_1, params_27, layers_1);
        let _e40 = self.v_joined_texels(<rt::Vec4<f32>>::from_scalars(_e10.x(), _e16.x(), _e22.x(), _e28.x()), <rt::Vec4<f32>>::from_scalars(_e10.y(), _e16.y(), _e22.y(), _e28.y()), around.part);
        return _e40;
    }
    pub(crate) fn coarser_voxel(
        &self,
        at_28: impl rt::Into<rt::Vec3<i32>>,
        level_28: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec3<i32> {
        rt::into(self.v_coarser_voxel(rt::into(at_28), rt::into(level_28)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_coarser_voxel(
        &self,
        at_28: rt::Vec3<i32>,
        level_28: rt::Scalar<u32>,
    ) -> rt::Vec3<i32> {
        return <rt::Vec3<i32>>::from_scalars((at_28.x() >> level_28), (at_28.y() >> level_28), (at_28.z() >> level_28));
    }
    pub(crate) fn color_texels_around(
        &self,
        place_12: impl rt::Into<rt::Vec2<f32>>,
        n_10: impl rt::Into<rt::Vec2<i32>>,
    ) -> Around {
        rt::into(self.v_color_texels_around(rt::into(place_12), rt::into(n_10)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_color_texels_around(
        &self,
        place_12: rt::Vec2<f32>,
        n_10: rt::Vec2<i32>,
    ) -> Around {
        let point_26 = ((place_12 * n_10.to_f32()) - <rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32)));
        let _e8 = self.v_cell_of(point_26);
        let i_9 = _e8.to_i32();
        let u_1 = rt::Scalar(self.surface_settings.color_wrap_u);
        let v_4 = rt::Scalar(self.surface_settings.color_wrap_v);
        let _e18 = self.v_continued_pair(i_9.x(), n_10.x(), u_1);
        let _e21 = self.v_continued_pair(i_9.y(), n_10.y(), v_4);
        return <Around>::new(_e18, _e21, (point_26 - _e8));
    }
    pub(crate) fn color_of_texels(
        &self,
        place_13: impl rt::Into<rt::Vec2<f32>>,
        level_29: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_color_of_texels(rt::into(place_13), rt::into(level_29)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_color_of_texels(
        &self,
        place_13: rt::Vec2<f32>,
        level_29: rt::Scalar<u32>,
    ) -> rt::Vec4<f32> {
        let _e4 = self.surface_settings.color_size;
        let _e5 = self.v_level_texels(_e4, level_29);
        let _e6 = self.v_color_texels_around(place_13, _e5);
        let k_60 = level_29.to_i32();
        let _e14 = rt::texture::Read::read_texel((&self.color_map), <rt::Vec2<i32>>::from_scalars(_e6.columns.x(), _e6.rows.x()), 0i32, 0i32, rt::Scalar::into_inner(k_60));
        let _e21 = rt::texture::Read::read_texel((&self.color_map), <rt::Vec2<i32>>::from_scalars(_e6.columns.y(), _e6.rows.x()), 0i32, 0i32, rt::Scalar::into_inner(k_60));
        let _e28 = rt::texture::Read::read_texel((&self.color_map), <rt::Vec2<i32>>::from_scalars(_e6.columns.x(), _e6.rows.y()), 0i32, 0i32, rt::Scalar::into_inner(k_60));
        let _e35 = rt::texture::Read::read_texel((&self.color_map), <rt::Vec2<i32>>::from_scalars(_e6.columns.y(), _e6.rows.y()), 0i32, 0i32, rt::Scalar::into_inner(k_60));
        let _e37 = self.v_bilinear(_e14, _e21, _e28, _e35, _e6.part);
        return _e37;
    }
    pub(crate) fn color_place(&self, uv_4: impl rt::Into<rt::Vec2<f32>>) -> rt::Vec2<f32> {
        rt::into(self.v_color_place(rt::into(uv_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_color_place(&self, uv_4: rt::Vec2<f32>) -> rt::Vec2<f32> {
        let _e4 = self.surface_settings.color_u.x();
        let _e10 = self.surface_settings.color_u.y();
        let u_2 = ((_e4 * uv_4.x()) + (_e10 * uv_4.y()));
        let _e17 = self.surface_settings.color_v.x();
        let _e23 = self.surface_settings.color_v.y();
        let v_5 = ((_e17 * uv_4.x()) + (_e23 * uv_4.y()));
        let _e30 = self.surface_settings.color_u.z();
        let _e35 = self.surface_settings.color_v.z();
        return <rt::Vec2<f32>>::from_scalars((u_2 + _e30), (v_5 + _e35));
    }
    pub(crate) fn color_at(
        &self,
        uv_5: impl rt::Into<rt::Vec2<f32>>,
        level_30: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_color_at(rt::into(uv_5), rt::into(level_30)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_color_at(
        &self,
        uv_5: rt::Vec2<f32>,
        level_30: rt::Scalar<u32>,
    ) -> rt::Vec4<f32> {
        let _e2 = self.v_color_place(uv_5);
        let _e3 = self.v_color_of_texels(_e2, level_30);
        return _e3;
    }
    pub(crate) fn object_texel(&self, place_14: impl rt::Into<rt::Vec2<i32>>) -> rt::Vec4<f32> {
        rt::into(self.v_object_texel(rt::into(place_14)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_object_texel(&self, place_14: rt::Vec2<i32>) -> rt::Vec4<f32> {
        let _e4 = rt::texture::Read::read_texel((&self.object_map), place_14, rt::Scalar::into_inner(rt::Scalar(0i32)), 0i32, rt::Scalar::into_inner(rt::Scalar(0i32)));
        return _e4;
    }
    pub(crate) fn frames_around(&self, toward_1: impl rt::Into<rt::Vec3<f32>>) -> Frames {
        rt::into(self.v_frames_around(rt::into(toward_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_frames_around(&self, toward_1: rt::Vec3<f32>) -> Frames {
        let mut x_1: rt::Scalar<f32>;
        let mut z: rt::Scalar<f32>;

        let _e3 = rt::Scalar(self.surface_settings.images);
        let row_11 = _e3.to_i32();
        let _e7 = self.v_object_texel(<rt::Vec2<i32>>::from_scalars(rt::Scalar(0i32), row_11));
        let _e10 = self.v_object_texel(<rt::Vec2<i32>>::from_scalars(rt::Scalar(1i32), row_11));
        let _e13 = self.v_object_texel(<rt::Vec2<i32>>::from_scalars(rt::Scalar(2i32), row_11));
        let last_7 = (_e7.w() - rt::Scalar(1f32)).max(rt::Scalar(1f32));
        let is_hemi = _e10.w().elementwise_gt(rt::Scalar(0f32));
        let up_2 = _e10.xyz().dot(toward_1);
        let y_4 = up_2.select(up_2.max(rt::Scalar(0f32)), is_hemi);
        let right_2 = _e7.xyz().dot(toward_1);
        let front = _e13.xyz().dot(toward_1);
        let sum_8 = ((right_2.abs() + y_4.abs()) + front.abs()).max(rt::Scalar(0.000001f32));
        x_1 = (right_2 / sum_8);
        z = (front / sum_8);
        if rt::Scalar::into_branch_condition(y_4.elementwise_lt(rt::Scalar(0f32))) {
            let _e44 = z;
            let _e48 = x_1;
            let folded_x = ((rt::Scalar(1f32) - _e44.abs()) * rt::Scalar(-1f32).select(rt::Scalar(1f32), _e48.elementwise_ge(rt::Scalar(0f32))));
            let _e55 = x_1;
            let _e59 = z;
            let folded_z = ((rt::Scalar(1f32) - _e55.abs()) * rt::Scalar(-1f32).select(rt::Scalar(1f32), _e59.elementwise_ge(rt::Scalar(0f32))));
            x_1 = folded_x;
            z = folded_z;
        }
        let _e66 = x_1;
        let _e69 = x_1;
        let _e70 = z;
        let across_5 = ((_e66 + rt::Scalar(1f32)).select(((_e69 + _e70) + rt::Scalar(1f32)), is_hemi) * (rt::Scalar(0.5f32) * last_7));
        let _e78 = z;
        let _e81 = z;
        let _e82 = x_1;
        let along_23 = ((_e78 + rt::Scalar(1f32)).select(((_e81 - _e82) + rt::Scalar(1f32)), is_hemi) * (rt::Scalar(0.5f32) * last_7));
        let place_40 = <rt::Vec2<f32>>::from_scalars(across_5, along_23).clamp(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)), <rt::Vec2<f32>>::from_scalars(last_7, last_7));
        let cell_42 = place_40.floor().min(<rt::Vec2<f32>>::from_scalars((last_7 - rt::Scalar(1f32)), (last_7 - rt::Scalar(1f32))));
        let part_22 = (place_40 - cell_42);
        let side_8 = (last_7.to_u32() + rt::Scalar(1u32));
        let first_17 = ((cell_42.y().to_u32() * side_8) + cell_42.x().to_u32());
        let beside_5 = (first_17 + side_8).select((first_17 + rt::Scalar(1u32)), part_22.x().elementwise_gt(part_22.y()));
        let least_4 = part_22.x().min(part_22.y());
        let most_9 = part_22.x().max(part_22.y());
        return <Frames>::new(<rt::Vec3<u32>>::from_scalars(first_17, beside_5, ((first_17 + side_8) + rt::Scalar(1u32))), <rt::Vec3<f32>>::from_scalars((rt::Scalar(1f32) - most_9), (most_9 - least_4), least_4));
    }
    pub(crate) fn image_of_object(&self, number_7: impl rt::Into<rt::Scalar<u32>>) -> Image {
        rt::into(self.v_image_of_object(rt::into(number_7)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_image_of_object(&self, number_7: rt::Scalar<u32>) -> Image {
        let mut depth_6: rt::Vec4<f32> = <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(1f32));
        let mut eye_1: rt::Vec4<f32> = <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));

        let row_12 = number_7.to_i32();
        let _e4 = self.v_object_texel(<rt::Vec2<i32>>::from_scalars(rt::Scalar(3i32), row_12));
        let _e7 = self.v_object_texel(<rt::Vec2<i32>>::from_scalars(rt::Scalar(4i32), row_12));
        let has_eye = _e7.w().elementwise_eq(rt::Scalar(1f32));
        if rt::Scalar::into_branch_condition(has_eye) {
            let _e25 = self.v_object_texel(<rt::Vec2<i32>>::from_scalars(rt::Scalar(5i32), row_12));
            depth_6 = _e25;
            let _e28 = self.v_object_texel(<rt::Vec2<i32>>::from_scalars(rt::Scalar(6i32), row_12));
            eye_1 = _e28;
        }
        let _e31 = self.v_object_texel(<rt::Vec2<i32>>::from_scalars(rt::Scalar(0i32), row_12));
        let _e34 = self.v_object_texel(<rt::Vec2<i32>>::from_scalars(rt::Scalar(1i32), row_12));
        let _e37 = self.v_object_texel(<rt::Vec2<i32>>::from_scalars(rt::Scalar(2i32), row_12));
        let _e38 = depth_6;
        let _e44 = eye_1;
        let _e47 = eye_1.w();
        return <Image>::new(_e31, _e34, _e37, _e38, _e4.xy(), <rt::Vec2<f32>>::from_scalars(_e4.z(), _e4.w()), _e7.xyz(), has_eye, _e44.xyz(), _e47);
    }
    pub(crate) fn frame_number(
        &self,
        frames: Frames,
        k_2: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_frame_number(frames, rt::into(k_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_frame_number(
        &self,
        frames: Frames,
        k_2: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        return frames.numbers.z().select(frames.numbers.y(), k_2.elementwise_eq(rt::Scalar(1u32))).select(frames.numbers.x(), k_2.elementwise_eq(rt::Scalar(0u32)));
    }
    pub(crate) fn frame_weight(
        &self,
        frames_1: Frames,
        k_3: impl rt::Into<rt::Scalar<u32>>,
    ) -> f32 {
        rt::into(self.v_frame_weight(frames_1, rt::into(k_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_frame_weight(
        &self,
        frames_1: Frames,
        k_3: rt::Scalar<u32>,
    ) -> rt::Scalar<f32> {
        return frames_1.weights.z().select(frames_1.weights.y(), k_3.elementwise_eq(rt::Scalar(1u32))).select(frames_1.weights.x(), k_3.elementwise_eq(rt::Scalar(0u32)));
    }
    pub(crate) fn color_of_frames(
        &self,
        at_29: Entered,
        view_13: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_color_of_frames(at_29, rt::into(view_13)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_color_of_frames(
        &self,
        at_29: Entered,
        view_13: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let mut sum_2: rt::Vec3<f32> = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
        let mut k_4: rt::Scalar<u32> = rt::Scalar(0u32);

        let _e2 = self.v_frames_around(view_13);
        'naga_break: loop {
            'naga_continue: {
                let _e10 = k_4;
                if rt::Scalar::into_branch_condition(_e10.elementwise_lt(FRAMES)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e13 = k_4;
                    let _e14 = self.v_frame_number(_e2, _e13);
                    let _e15 = self.v_image_of_object(_e14);
                    let _e16 = sum_2;
                    let _e18 = self.v_place_in_image(_e15, at_29.point);
                    let _e21 = self.v_color_at(_e18.xy(), rt::Scalar(0u32));
                    let _e23 = k_4;
                    let _e24 = self.v_frame_weight(_e2, _e23);
                    sum_2 = (_e16 + (_e21.xyz() * _e24));
                    let _e27 = k_4;
                    k_4 = (_e27 + rt::Scalar(1u32));
                }
            }
        }
        let _e30 = sum_2;
        return _e30;
    }
    pub(crate) fn object_color(
        &self,
        at_30: Entered,
        view_14: impl rt::Into<rt::Vec3<f32>>,
        asked_1: impl rt::Into<rt::Scalar<bool>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_object_color(at_30, rt::into(view_14), rt::into(asked_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_object_color(
        &self,
        at_30: Entered,
        view_14: rt::Vec3<f32>,
        asked_1: rt::Scalar<bool>,
    ) -> rt::Vec3<f32> {
        let mut angle1_: rt::Scalar<f32> = rt::Scalar(4f32);
        let mut angle2_: rt::Scalar<f32> = rt::Scalar(4f32);
        let mut angle3_: rt::Scalar<f32> = rt::Scalar(4f32);
        let mut angle4_: rt::Scalar<f32> = rt::Scalar(4f32);
        let mut image1_: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut image2_: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut image3_: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut k_5: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut weight1_: rt::Scalar<f32>;
        let mut weight2_: rt::Scalar<f32>;
        let mut weight3_: rt::Scalar<f32>;

        'naga_break: loop {
            'naga_continue: {
                let _e19 = k_5;
                let _e22 = rt::Scalar(self.surface_settings.images);
                if rt::Scalar::into_branch_condition(_e19.elementwise_lt(_e22)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e24 = k_5;
                    let _e25 = self.v_image_of_object(_e24);
                    let _e27 = self.v_angle_to_image(_e25, at_30.point, view_14, asked_1);
                    let _e28 = angle1_;
                    if rt::Scalar::into_branch_condition(_e27.elementwise_lt(_e28)) {
                        let _e30 = angle3_;
                        angle4_ = _e30;
                        let _e31 = angle2_;
                        angle3_ = _e31;
                        let _e32 = image2_;
                        image3_ = _e32;
                        let _e33 = angle1_;
                        angle2_ = _e33;
                        let _e34 = image1_;
                        image2_ = _e34;
                        angle1_ = _e27;
                        let _e35 = k_5;
                        image1_ = _e35;
                    } else {
                        let _e36 = angle2_;
                        if rt::Scalar::into_branch_condition(_e27.elementwise_lt(_e36)) {
                            let _e38 = angle3_;
                            angle4_ = _e38;
                            let _e39 = angle2_;
                            angle3_ = _e39;
                            let _e40 = image2_;
                            image3_ = _e40;
                            angle2_ = _e27;
                            let _e41 = k_5;
                            image2_ = _e41;
                        } else {
                            let _e42 = angle3_;
                            if rt::Scalar::into_branch_condition(_e27.elementwise_lt(_e42)) {
                                let _e44 = angle3_;
                                angle4_ = _e44;
                                angle3_ = _e27;
                                let _e45 = k_5;
                                image3_ = _e45;
                            } else {
                                let _e46 = angle4_;
                                if rt::Scalar::into_branch_condition(_e27.elementwise_lt(_e46)) {
                                    angle4_ = _e27;
                                }
                            }
                        }
                    }
                    let _e48 = k_5;
                    k_5 = (_e48 + rt::Scalar(1u32));
                }
            }
        }
        let _e51 = angle1_;
        let less = rt::Scalar(0f32).select(rt::Scalar(2f32), _e51.elementwise_ge(rt::Scalar(2f32)));
        let _e57 = angle4_;
        let last_8 = (_e57 - less).min(rt::Scalar(0.5f32));
        let _e61 = angle1_;
        weight1_ = (rt::Scalar(1f32) - ((_e61 - less) / last_8)).max(rt::Scalar(0f32));
        let _e69 = angle2_;
        weight2_ = (rt::Scalar(1f32) - ((_e69 - less) / last_8)).max(rt::Scalar(0f32));
        let _e77 = angle3_;
        weight3_ = (rt::Scalar(1f32) - ((_e77 - less) / last_8)).max(rt::Scalar(0f32));
        let _e85 = weight1_;
        let _e86 = weight2_;
        let _e88 = weight3_;
        if rt::Scalar::into_branch_condition((!((_e85 + _e86) + _e88).elementwise_gt(rt::Scalar(0f32)))) {
            weight1_ = rt::Scalar(1f32);
            let _e94 = angle2_;
            let _e95 = angle1_;
            weight2_ = rt::Scalar(0f32).select(rt::Scalar(1f32), _e94.elementwise_eq(_e95));
            let _e100 = angle3_;
            let _e101 = angle1_;
            weight3_ = rt::Scalar(0f32).select(rt::Scalar(1f32), _e100.elementwise_eq(_e101));
        }
        let _e106 = image1_;
        let _e107 = self.v_image_of_object(_e106);
        let _e109 = self.v_place_in_image(_e107, at_30.point);
        let uv1_ = _e109.xy();
        let _e111 = image2_;
        let _e112 = self.v_image_of_object(_e111);
        let _e114 = self.v_place_in_image(_e112, at_30.point);
        let uv2_ = _e114.xy();
        let _e116 = image3_;
        let _e117 = self.v_image_of_object(_e116);
        let _e119 = self.v_place_in_image(_e117, at_30.point);
        let uv3_ = _e119.xy();
        let _e122 = self.v_color_at(uv1_, rt::Scalar(0u32));
        let _e124 = weight1_;
        let first_18 = (_e122.xyz() * _e124);
        let _e127 = self.v_color_at(uv2_, rt::Scalar(0u32));
        let _e129 = weight2_;
        let _e133 = self.v_color_at(uv3_, rt::Scalar(0u32));
        let _e135 = weight3_;
        let sum_9 = ((first_18 + (_e127.xyz() * _e129)) + (_e133.xyz() * _e135));
        let _e138 = weight1_;
        let _e139 = weight2_;
        let _e141 = weight3_;
        return (sum_9 * (rt::Scalar(1f32) / ((_e138 + _e139) + _e141)));
    }
    pub(crate) fn color_of_object(
        &self,
        at_31: Entered,
        view_15: impl rt::Into<rt::Vec3<f32>>,
        how: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_color_of_object(at_31, rt::into(view_15), rt::into(how)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_color_of_object(
        &self,
        at_31: Entered,
        view_15: rt::Vec3<f32>,
        how: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let mut local_32: rt::Scalar<bool>;

        let _e5 = rt::Scalar(self.surface_settings.has_color);
        if rt::Scalar::into_branch_condition((!_e5.elementwise_ne(rt::Scalar(1u32)))) {
            local_32 = how.elementwise_eq(rt::Scalar(2f32));
        } else {
            local_32 = rt::Scalar(true);
        }
        let _e14 = local_32;
        if rt::Scalar::into_branch_condition(_e14) {
            return <rt::Vec3<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32), rt::Scalar(1f32));
        }
        if rt::Scalar::into_branch_condition(how.elementwise_eq(rt::Scalar(3f32))) {
            let _e21 = self.v_color_of_frames(at_31, view_15);
            return _e21;
        }
        let _e24 = self.v_object_color(at_31, view_15, how.elementwise_eq(rt::Scalar(1f32)));
        return _e24;
    }
    pub(crate) fn color_or_white(
        &self,
        uv_6: impl rt::Into<rt::Vec2<f32>>,
        footprint_1: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_color_or_white(rt::into(uv_6), rt::into(footprint_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_color_or_white(
        &self,
        uv_6: rt::Vec2<f32>,
        footprint_1: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let _e4 = rt::Scalar(self.surface_settings.has_color);
        if rt::Scalar::into_branch_condition(_e4.elementwise_ne(rt::Scalar(1u32))) {
            return <rt::Vec3<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32), rt::Scalar(1f32));
        }
        let _e13 = rt::Scalar(self.surface_settings.color_texels);
        let _e17 = rt::Scalar(self.surface_settings.color_levels);
        let _e18 = self.v_levels_of((footprint_1 * _e13), _e17);
        let _e20 = self.v_color_at(uv_6, rt::Scalar(_e18.fine));
        let fine = _e20.xyz();
        if rt::Scalar::into_branch_condition(rt::Scalar(_e18.part).elementwise_gt(rt::Scalar(0f32))) {
            let _e28 = self.v_color_at(uv_6, (rt::Scalar(_e18.fine) + rt::Scalar(1u32)));
            return (fine + ((_e28.xyz() - fine) * rt::Scalar(_e18.part)));
        }
        return fine;
    }
    pub(crate) fn comes_before(
        &self,
        a_10: impl rt::Into<rt::Vec2<f32>>,
        b_10: impl rt::Into<rt::Vec2<f32>>,
    ) -> u32 {
        rt::into(self.v_comes_before(rt::into(a_10), rt::into(b_10)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_comes_before(
        &self,
        a_10: rt::Vec2<f32>,
        b_10: rt::Vec2<f32>,
    ) -> rt::Scalar<u32> {
        return rt::Scalar(0u32).select(rt::Scalar(1u32), a_10.x().elementwise_le(b_10.x()));
    }
    pub(crate) fn wide_product(
        &self,
        a_11: impl rt::Into<rt::Scalar<u32>>,
        b_11: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec2<u32> {
        rt::into(self.v_wide_product(rt::into(a_11), rt::into(b_11)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_wide_product(
        &self,
        a_11: rt::Scalar<u32>,
        b_11: rt::Scalar<u32>,
    ) -> rt::Vec2<u32> {
        let a_high = (a_11 >> rt::Scalar(16u32));
        let a_low = (a_11 & rt::Scalar(65535u32));
        let b_high = (b_11 >> rt::Scalar(16u32));
        let b_low = (b_11 & rt::Scalar(65535u32));
        let low_5 = (a_low * b_low);
        let one = ((a_low * b_high) + (low_5 >> rt::Scalar(16u32)));
        let two = ((a_high * b_low) + (one & rt::Scalar(65535u32)));
        return <rt::Vec2<u32>>::from_scalars((((a_high * b_high) + (one >> rt::Scalar(16u32))) + (two >> rt::Scalar(16u32))), ((two << rt::Scalar(16u32)) | (low_5 & rt::Scalar(65535u32))));
    }
    pub(crate) fn compared(
        &self,
        a_12: impl rt::Into<rt::Scalar<u32>>,
        b_12: impl rt::Into<rt::Scalar<u32>>,
        c_6: impl rt::Into<rt::Scalar<u32>>,
        d_1: impl rt::Into<rt::Scalar<u32>>,
    ) -> i32 {
        rt::into(self.v_compared(rt::into(a_12), rt::into(b_12), rt::into(c_6), rt::into(d_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_compared(
        &self,
        a_12: rt::Scalar<u32>,
        b_12: rt::Scalar<u32>,
        c_6: rt::Scalar<u32>,
        d_1: rt::Scalar<u32>,
    ) -> rt::Scalar<i32> {
        let _e4 = self.v_wide_product(a_12, b_12);
        let _e5 = self.v_wide_product(c_6, d_1);
        let by_low = rt::Scalar(0i32).select(rt::Scalar(1i32), _e4.y().elementwise_gt(_e5.y())).select(rt::Scalar(-1i32), _e4.y().elementwise_lt(_e5.y()));
        return by_low.select(rt::Scalar(1i32), _e4.x().elementwise_gt(_e5.x())).select(rt::Scalar(-1i32), _e4.x().elementwise_lt(_e5.x()));
    }
    pub(crate) fn slope_of(&self, value: impl rt::Into<rt::Scalar<f32>>) -> f32 {
        rt::into(self.v_slope_of(rt::into(value)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_slope_of(&self, value: rt::Scalar<f32>) -> rt::Scalar<f32> {
        let squared_1 = ((rt::Scalar(0.125f32) * value) * value);
        if rt::Scalar::into_branch_condition(squared_1.elementwise_gt(rt::Scalar(0f32))) {
            return (((rt::Scalar(1f32) - value) * (rt::Scalar(1f32) + value)) / squared_1);
        }
        return rt::Scalar(-1f32);
    }
    pub(crate) fn cone_slope(
        &self,
        path_27: Path,
        texel_3: impl rt::Into<rt::Vec2<f32>>,
    ) -> f32 {
        rt::into(self.v_cone_slope(path_27, rt::into(texel_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_cone_slope(
        &self,
        path_27: Path,
        texel_3: rt::Vec2<f32>,
    ) -> rt::Scalar<f32> {
        let _e3 = self.v_height_texels(rt::Scalar(path_27.level));
        let _e4 = self.v_whole_cell(texel_3);
        let _e7 = self.v_wrap_index(_e4.x(), _e3.x());
        let _e10 = self.v_wrap_index(_e4.y(), _e3.y());
        let wrapped = <rt::Vec2<i32>>::from_scalars(_e7, _e10);
        let _e15 = self.v_search_texel(path_27, wrapped, rt::Scalar(0i32), rt::Scalar(path_27.level).to_i32());
        let _e17 = self.v_slope_of(_e15.x());
        return _e17;
    }
    pub(crate) fn corner_height(
        &self,
        heights: impl rt::Into<rt::Vec4<f32>>,
        corner: impl rt::Into<rt::Vec2<f32>>,
    ) -> f32 {
        rt::into(self.v_corner_height(rt::into(heights), rt::into(corner)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_corner_height(
        &self,
        heights: rt::Vec4<f32>,
        corner: rt::Vec2<f32>,
    ) -> rt::Scalar<f32> {
        let above_7 = heights.x().select(heights.y(), corner.x().elementwise_gt(rt::Scalar(0.5f32)));
        let below_5 = heights.z().select(heights.w(), corner.x().elementwise_gt(rt::Scalar(0.5f32)));
        return above_7.select(below_5, corner.y().elementwise_gt(rt::Scalar(0.5f32)));
    }
    pub(crate) fn covector(
        &self,
        at_32: Entered,
        gradient: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_covector(at_32, rt::into(gradient)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_covector(
        &self,
        at_32: Entered,
        gradient: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let metric_1 = at_32.metric;
        let area_1 = ((metric_1.x() * metric_1.z()) - (metric_1.y() * metric_1.y()));
        let along_u_1 = (((at_32.tangent * metric_1.z()) - (at_32.bitangent * metric_1.y())) / rt::Vec3::splat_from_scalar(area_1));
        let along_v_1 = (((at_32.bitangent * metric_1.x()) - (at_32.tangent * metric_1.y())) / rt::Vec3::splat_from_scalar(area_1));
        let _e32 = rt::Scalar(self.surface_settings.scale_m);
        let rise_2 = (at_32.normal * (gradient.z() / _e32));
        return (((along_u_1 * gradient.x()) + (along_v_1 * gradient.y())) + rise_2);
    }
    pub(crate) fn plane_distance(
        &self,
        pixel_9: PixelIn,
        normal_13: impl rt::Into<rt::Vec3<f32>>,
    ) -> f32 {
        rt::into(self.v_plane_distance(pixel_9, rt::into(normal_13)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_plane_distance(
        &self,
        pixel_9: PixelIn,
        normal_13: rt::Vec3<f32>,
    ) -> rt::Scalar<f32> {
        return (normal_13.dot((pixel_9.a.position - pixel_9.origin)) / normal_13.dot(pixel_9.direction));
    }
    pub(crate) fn depth_in_samples(&self, pixel_10: PixelIn, at_33: Entered) -> f32 {
        rt::into(self.v_depth_in_samples(pixel_10, at_33))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_depth_in_samples(&self, pixel_10: PixelIn, at_33: Entered) -> rt::Scalar<f32> {
        let _e3 = self.v_plane_distance(pixel_10, at_33.facing);
        let _e6 = self.frame.eye_right;
        let _e10 = self.frame.right;
        let _e17 = rt::Scalar(self.frame.sample_width);
        let width_4 = ((_e6.xyz() + (_e10.xyz() * _e3)).length() * _e17);
        let _e21 = rt::Scalar(self.surface_settings.scale_m);
        return (_e21 / width_4);
    }
    pub(crate) fn depth_on_ray(&self, pixel_11: PixelIn, path_28: Path, hit_9: Hit) -> f32 {
        rt::into(self.v_depth_on_ray(pixel_11, path_28, hit_9))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_depth_on_ray(&self, pixel_11: PixelIn, path_28: Path, hit_9: Hit) -> rt::Scalar<f32> {
        return ((rt::Scalar(path_28.start) + rt::Scalar(hit_9.t)) / pixel_11.direction.length());
    }
    pub(crate) fn footprint_axis(
        &self,
        pixel_12: PixelIn,
        at_34: Entered,
        normal_14: impl rt::Into<rt::Vec3<f32>>,
        t_22: impl rt::Into<rt::Scalar<f32>>,
        origin: impl rt::Into<rt::Vec3<f32>>,
        direction_4: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_footprint_axis(pixel_12, at_34, rt::into(normal_14), rt::into(t_22), rt::into(origin), rt::into(direction_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_footprint_axis(
        &self,
        pixel_12: PixelIn,
        at_34: Entered,
        normal_14: rt::Vec3<f32>,
        t_22: rt::Scalar<f32>,
        origin: rt::Vec3<f32>,
        direction_4: rt::Vec3<f32>,
    ) -> rt::Vec2<f32> {
        let aside_3 = (origin + (direction_4 * t_22));
        let along_24 = (normal_14.dot(aside_3) / normal_14.dot(pixel_12.direction));
        let _e15 = self.v_climb(at_34, (aside_3 - (pixel_12.direction * along_24)));
        let _e19 = self.surface_settings.height_size;
        return (_e15.xy() * _e19.to_f32());
    }
    pub(crate) fn footprint_of(
        &self,
        pixel_13: PixelIn,
        at_35: Entered,
        anisotropy: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_footprint_of(pixel_13, at_35, rt::into(anisotropy)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_footprint_of(
        &self,
        pixel_13: PixelIn,
        at_35: Entered,
        anisotropy: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let normal_31 = at_35.facing;
        let _e4 = self.v_plane_distance(pixel_13, normal_31);
        let _e7 = self.frame.eye_right;
        let _e11 = self.frame.right;
        let _e13 = self.v_footprint_axis(pixel_13, at_35, normal_31, _e4, _e7.xyz(), _e11.xyz());
        let _e16 = self.frame.eye_down;
        let _e20 = self.frame.down;
        let _e22 = self.v_footprint_axis(pixel_13, at_35, normal_31, _e4, _e16.xyz(), _e20.xyz());
        let both_2 = <rt::Vec4<f32>>::new_22(_e13, _e22);
        let sum_10 = both_2.dot(both_2);
        let area_2 = ((_e13.x() * _e22.y()) - (_e13.y() * _e22.x()));
        let apart_3 = ((sum_10 - (rt::Scalar(2f32) * area_2)) * (sum_10 + (rt::Scalar(2f32) * area_2))).max(rt::Scalar(0f32)).sqrt();
        let longer = (rt::Scalar(0.5f32) * (sum_10 + apart_3));
        let shorter = ((area_2 * area_2) / longer);
        let squared_2 = shorter.max((longer / (anisotropy * anisotropy)));
        let _e53 = rt::Scalar(self.frame.sample_width);
        return (squared_2.sqrt() * _e53);
    }
    pub(crate) fn detail_fade(
        &self,
        pixel_14: PixelIn,
        at_36: Entered,
        params_28: impl rt::Into<rt::Vec4<f32>>,
    ) -> Detail {
        rt::into(self.v_detail_fade(pixel_14, at_36, rt::into(params_28)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_detail_fade(
        &self,
        pixel_14: PixelIn,
        at_36: Entered,
        params_28: rt::Vec4<f32>,
    ) -> Detail {
        let _e4 = self.v_footprint_of(pixel_14, at_36, params_28.x());
        let begin_10 = (params_28.z() * params_28.w());
        let _e8 = self.v_depth_in_samples(pixel_14, at_36);
        let part_23 = ((begin_10 - _e8) / (begin_10 - params_28.z()).max(rt::Scalar(0.000001f32)));
        let _e19 = rt::Scalar(self.surface_settings.height_levels);
        let _e20 = self.v_levels_of((_e4 / params_28.y()), _e19);
        let level_66 = rt::Scalar(_e20.fine);
        return <Detail>::new(level_66, _e4, part_23.clamp(rt::Scalar(0f32), rt::Scalar(0.99902344f32)));
    }
    pub(crate) fn detail_footprint(
        &self,
        pixel_15: PixelIn,
        at_37: Entered,
        params_29: impl rt::Into<rt::Vec4<f32>>,
    ) -> Detail {
        rt::into(self.v_detail_footprint(pixel_15, at_37, rt::into(params_29)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_detail_footprint(
        &self,
        pixel_15: PixelIn,
        at_37: Entered,
        params_29: rt::Vec4<f32>,
    ) -> Detail {
        let _e4 = self.v_footprint_of(pixel_15, at_37, params_29.x());
        let _e9 = rt::Scalar(self.surface_settings.height_levels);
        let _e10 = self.v_levels_of((_e4 / params_29.y()), _e9);
        return <Detail>::new(rt::Scalar(_e10.fine), _e4, rt::Scalar(0f32));
    }
    pub(crate) fn detail_none(
        &self,
        pixel_16: PixelIn,
        at_38: Entered,
        params_30: impl rt::Into<rt::Vec4<f32>>,
    ) -> Detail {
        rt::into(self.v_detail_none(pixel_16, at_38, rt::into(params_30)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_detail_none(
        &self,
        pixel_16: PixelIn,
        at_38: Entered,
        params_30: rt::Vec4<f32>,
    ) -> Detail {
        return <Detail>::new(rt::Scalar(0u32), rt::Scalar(0f32), rt::Scalar(0f32));
    }
    pub(crate) fn detail_stage(&self, pixel_17: PixelIn, at_39: Entered) -> Detail {
        rt::into(self.v_detail_stage(pixel_17, at_39))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_detail_stage(&self, pixel_17: PixelIn, at_39: Entered) -> Detail {
        let _e6 = rt::Scalar(self.surface_settings.choices[5usize].number);
        match rt::Scalar::into_inner(_e6) {
            0u32 => {
                let _e11 = self.surface_settings.choices[5usize].params;
                let _e12 = self.v_detail_none(pixel_17, at_39, _e11);
                return _e12;
            }
            1u32 => {
                let _e17 = self.surface_settings.choices[5usize].params;
                let _e18 = self.v_detail_footprint(pixel_17, at_39, _e17);
                return _e18;
            }
            _ => {
                let _e23 = self.surface_settings.choices[5usize].params;
                let _e24 = self.v_detail_fade(pixel_17, at_39, _e23);
                return _e24;
            }
        }
    }
    pub(crate) fn detail_texel(
        &self,
        place_15: impl rt::Into<rt::Vec2<i32>>,
        layer_4: impl rt::Into<rt::Scalar<i32>>,
        level_31: impl rt::Into<rt::Scalar<i32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_detail_texel(rt::into(place_15), rt::into(layer_4), rt::into(level_31)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_detail_texel(
        &self,
        place_15: rt::Vec2<i32>,
        layer_4: rt::Scalar<i32>,
        level_31: rt::Scalar<i32>,
    ) -> rt::Vec4<f32> {
        let _e4 = rt::texture::Read::read_texel((&self.detail_map), place_15, rt::Scalar::into_inner(layer_4), 0i32, rt::Scalar::into_inner(level_31));
        let _e8 = self.surface_settings.maps[0usize];
        let _e9 = self.v_decoded(_e4, _e8);
        return _e9;
    }
    pub(crate) fn detail_texel_between(
        &self,
        at_40: Around,
        layer_5: impl rt::Into<rt::Scalar<i32>>,
        level_32: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_detail_texel_between(at_40, rt::into(layer_5), rt::into(level_32)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_detail_texel_between(
        &self,
        at_40: Around,
        layer_5: rt::Scalar<i32>,
        level_32: rt::Scalar<u32>,
    ) -> rt::Vec4<f32> {
        let _e7 = rt::Scalar(self.surface_settings.maps[0usize].first_level);
        let k_61 = (level_32 - _e7).to_i32();
        let _e15 = self.v_detail_texel(<rt::Vec2<i32>>::from_scalars(at_40.columns.x(), at_40.rows.x()), layer_5, k_61);
        let _e21 = self.v_detail_texel(<rt::Vec2<i32>>::from_scalars(at_40.columns.y(), at_40.rows.x()), layer_5, k_61);
        let _e27 = self.v_detail_texel(<rt::Vec2<i32>>::from_scalars(at_40.columns.x(), at_40.rows.y()), layer_5, k_61);
        let _e33 = self.v_detail_texel(<rt::Vec2<i32>>::from_scalars(at_40.columns.y(), at_40.rows.y()), layer_5, k_61);
        let _e35 = self.v_bilinear(_e15, _e21, _e27, _e33, at_40.part);
        return _e35;
    }
    pub(crate) fn one_of(
        &self,
        numbers: impl rt::Into<rt::Vec3<u32>>,
        place_16: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_one_of(rt::into(numbers), rt::into(place_16)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_one_of(
        &self,
        numbers: rt::Vec3<u32>,
        place_16: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        return numbers.z().select(numbers.y(), place_16.elementwise_eq(rt::Scalar(1u32))).select(numbers.x(), place_16.elementwise_eq(rt::Scalar(0u32)));
    }
    pub(crate) fn dice_border(
        &self,
        rows_1: DiceRows,
        side: impl rt::Into<rt::Scalar<u32>>,
        at_41: impl rt::Into<rt::Scalar<u32>>,
    ) -> DicePoint {
        rt::into(self.v_dice_border(rows_1, rt::into(side), rt::into(at_41)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_dice_border(
        &self,
        rows_1: DiceRows,
        side: rt::Scalar<u32>,
        at_41: rt::Scalar<u32>,
    ) -> DicePoint {
        let _e4 = self.v_one_of(rows_1.sides, side);
        let _e6 = self.v_one_of(rows_1.parts, side);
        let on_side = at_41.select((_e6 - at_41), side.elementwise_eq(rt::Scalar(2u32)));
        let no_weights = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
        if rt::Scalar::into_branch_condition(on_side.elementwise_eq(_e6)) {
            let _e17 = self.v_around_three(_e4, rt::Scalar(1u32));
            return <DicePoint>::new(_e17, rt::Scalar(0u32), no_weights);
        }
        return <DicePoint>::new(_e4, on_side, no_weights);
    }
    pub(crate) fn dice_guess(
        &self,
        rows_2: DiceRows,
        before_1: impl rt::Into<rt::Scalar<u32>>,
        all: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_dice_guess(rows_2, rt::into(before_1), rt::into(all)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_dice_guess(
        &self,
        rows_2: DiceRows,
        before_1: rt::Scalar<u32>,
        all: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        let part_24 = ((before_1.to_f32() + rt::Scalar(0.5f32)) / all.max(rt::Scalar(1u32)).to_f32()).sqrt();
        return (part_24 * rt::Scalar(rows_2.count).to_f32()).to_u32().clamp(rt::Scalar(0u32), (rt::Scalar(rows_2.count) - rt::Scalar(1u32)));
    }
    pub(crate) fn sum_of_quotients(
        &self,
        count_2: impl rt::Into<rt::Scalar<u32>>,
        by: impl rt::Into<rt::Scalar<u32>>,
        slope: impl rt::Into<rt::Scalar<u32>>,
        offset_1: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_sum_of_quotients(rt::into(count_2), rt::into(by), rt::into(slope), rt::into(offset_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_sum_of_quotients(
        &self,
        count_2: rt::Scalar<u32>,
        by: rt::Scalar<u32>,
        slope: rt::Scalar<u32>,
        offset_1: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        let mut n_11: rt::Scalar<u32>;
        let mut m_2: rt::Scalar<u32>;
        let mut a_13: rt::Scalar<u32>;
        let mut b_13: rt::Scalar<u32>;
        let mut sum_3: rt::Scalar<u32> = rt::Scalar(0u32);

        n_11 = count_2;
        m_2 = by;
        a_13 = slope;
        b_13 = offset_1;
        'naga_break: loop {
            'naga_continue: {
                let _e10 = n_11;
                if rt::Scalar::into_branch_condition(_e10.elementwise_gt(rt::Scalar(0u32))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e13 = sum_3;
                    let _e14 = n_11;
                    let _e15 = n_11;
                    let _e21 = a_13;
                    let _e22 = m_2;
                    let _e26 = n_11;
                    let _e27 = b_13;
                    let _e28 = m_2;
                    sum_3 = ((_e13 + (((_e14 * (_e15 - rt::Scalar(1u32))) / rt::Scalar(2u32)) * (_e21 / _e22))) + (_e26 * (_e27 / _e28)));
                    let _e32 = a_13;
                    let _e33 = m_2;
                    a_13 = (_e32 % _e33);
                    let _e35 = b_13;
                    let _e36 = m_2;
                    b_13 = (_e35 % _e36);
                    let _e38 = a_13;
                    let _e39 = n_11;
                    let _e41 = b_13;
                    let last_9 = ((_e38 * _e39) + _e41);
                    let _e43 = m_2;
                    n_11 = (last_9 / _e43);
                    let _e45 = m_2;
                    b_13 = (last_9 % _e45);
                    let swapped = m_2;
                    let _e48 = a_13;
                    m_2 = _e48.max(rt::Scalar(1u32));
                    a_13 = swapped;
                }
            }
        }
        let _e51 = sum_3;
        return _e51;
    }
    pub(crate) fn dice_parts_before(
        &self,
        rows_3: DiceRows,
        count_3: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_dice_parts_before(rows_3, rt::into(count_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_dice_parts_before(
        &self,
        rows_3: DiceRows,
        count_3: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        let _e9 = self.v_sum_of_quotients(count_3, rt::Scalar(rows_3.count), rows_3.parts.y(), (rows_3.parts.y() - rt::Scalar(1u32)));
        return _e9;
    }
    pub(crate) fn dice_points_before(
        &self,
        rows_4: DiceRows,
        row_2: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_dice_points_before(rows_4, rt::into(row_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_dice_points_before(
        &self,
        rows_4: DiceRows,
        row_2: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        let _e4 = self.v_dice_parts_before(rows_4, (row_2 - rt::Scalar(1u32)));
        return _e4;
    }
    pub(crate) fn dice_points(&self, rows_5: DiceRows) -> u32 {
        rt::into(self.v_dice_points(rows_5))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_dice_points(&self, rows_5: DiceRows) -> rt::Scalar<u32> {
        let _e2 = self.v_dice_points_before(rows_5, rt::Scalar(rows_5.count));
        return _e2;
    }
    pub(crate) fn dice_row_of_point(
        &self,
        rows_6: DiceRows,
        number_8: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_dice_row_of_point(rows_6, rt::into(number_8)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_dice_row_of_point(
        &self,
        rows_6: DiceRows,
        number_8: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        let mut row_3: rt::Scalar<u32>;

        let _e2 = self.v_dice_points(rows_6);
        let _e3 = self.v_dice_guess(rows_6, number_8, _e2);
        row_3 = _e3.max(rt::Scalar(1u32));
        'naga_break: loop {
            'naga_continue: {
                let _e7 = row_3;
                let _e8 = self.v_dice_points_before(rows_6, _e7);
                if rt::Scalar::into_branch_condition(_e8.elementwise_gt(number_8)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e10 = row_3;
                    row_3 = (_e10 - rt::Scalar(1u32));
                }
            }
        }
        'naga_break: loop {
            'naga_continue: {
                let _e13 = row_3;
                let _e16 = self.v_dice_points_before(rows_6, (_e13 + rt::Scalar(1u32)));
                if rt::Scalar::into_branch_condition(_e16.elementwise_le(number_8)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e18 = row_3;
                    row_3 = (_e18 + rt::Scalar(1u32));
                }
            }
        }
        let _e21 = row_3;
        return _e21;
    }
    pub(crate) fn dice_place(
        &self,
        rows_7: DiceRows,
        number_9: impl rt::Into<rt::Scalar<u32>>,
    ) -> DicePlace {
        rt::into(self.v_dice_place(rows_7, rt::into(number_9)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_dice_place(
        &self,
        rows_7: DiceRows,
        number_9: rt::Scalar<u32>,
    ) -> DicePlace {
        let _e2 = self.v_dice_row_of_point(rows_7, number_9);
        let _e3 = self.v_dice_points_before(rows_7, _e2);
        return <DicePlace>::new(_e2, ((number_9 - _e3) + rt::Scalar(1u32)));
    }
    pub(crate) fn dice_share(
        &self,
        rows_8: DiceRows,
        row_4: impl rt::Into<rt::Scalar<u32>>,
        parts_1: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_dice_share(rows_8, rt::into(row_4), rt::into(parts_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_dice_share(
        &self,
        rows_8: DiceRows,
        row_4: rt::Scalar<u32>,
        parts_1: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        return ((((row_4 * parts_1) + rt::Scalar(rows_8.count)) - rt::Scalar(1u32)) / rt::Scalar(rows_8.count));
    }
    pub(crate) fn dice_row_parts(
        &self,
        rows_9: DiceRows,
        row_5: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_dice_row_parts(rows_9, rt::into(row_5)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_dice_row_parts(
        &self,
        rows_9: DiceRows,
        row_5: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        let _e4 = self.v_dice_share(rows_9, row_5, rows_9.parts.y());
        return _e4;
    }
    pub(crate) fn dice_point(&self, rows_10: DiceRows, place_17: DicePlace) -> DicePoint {
        rt::into(self.v_dice_point(rows_10, place_17))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_dice_point(&self, rows_10: DiceRows, place_17: DicePlace) -> DicePoint {
        if rt::Scalar::into_branch_condition(rt::Scalar(place_17.row).elementwise_eq(rt::Scalar(0u32))) {
            let _e7 = self.v_dice_border(rows_10, rt::Scalar(0u32), rt::Scalar(0u32));
            return _e7;
        }
        if rt::Scalar::into_branch_condition(rt::Scalar(place_17.row).elementwise_eq(rt::Scalar(rows_10.count))) {
            let _e13 = self.v_dice_border(rows_10, rt::Scalar(1u32), rt::Scalar(place_17.at));
            return _e13;
        }
        let _e15 = self.v_dice_row_parts(rows_10, rt::Scalar(place_17.row));
        let _e19 = self.v_dice_share(rows_10, rt::Scalar(place_17.row), rows_10.parts.x());
        let _e23 = self.v_dice_share(rows_10, rt::Scalar(place_17.row), rows_10.parts.z());
        if rt::Scalar::into_branch_condition(rt::Scalar(place_17.at).elementwise_eq(rt::Scalar(0u32))) {
            let _e28 = self.v_dice_border(rows_10, rt::Scalar(0u32), _e19);
            return _e28;
        }
        if rt::Scalar::into_branch_condition(rt::Scalar(place_17.at).elementwise_eq(_e15)) {
            let _e32 = self.v_dice_border(rows_10, rt::Scalar(2u32), _e23);
            return _e32;
        }
        let on_short = (((_e15 - rt::Scalar(place_17.at)).to_f32() / _e15.to_f32()) * (_e19.to_f32() / rows_10.parts.x().to_f32()));
        let on_other = ((rt::Scalar(place_17.at).to_f32() / _e15.to_f32()) * (_e23.to_f32() / rows_10.parts.z().to_f32()));
        let on_corner = ((rt::Scalar(1f32) - on_short) - on_other);
        let x_10 = on_other.select(on_short, rows_10.sides.y().elementwise_eq(rt::Scalar(0u32))).select(on_corner, rows_10.sides.x().elementwise_eq(rt::Scalar(0u32)));
        let y_5 = on_other.select(on_short, rows_10.sides.y().elementwise_eq(rt::Scalar(1u32))).select(on_corner, rows_10.sides.x().elementwise_eq(rt::Scalar(1u32)));
        let z_2 = on_other.select(on_short, rows_10.sides.y().elementwise_eq(rt::Scalar(2u32))).select(on_corner, rows_10.sides.x().elementwise_eq(rt::Scalar(2u32)));
        let _e88 = self.v_dice_points_before(rows_10, rt::Scalar(place_17.row));
        let number_28 = ((_e88 + rt::Scalar(place_17.at)) - rt::Scalar(1u32));
        return <DicePoint>::new(INSIDE, number_28, <rt::Vec3<f32>>::from_scalars(x_10, y_5, z_2));
    }
    pub(crate) fn dice_triangles_before(
        &self,
        rows_11: DiceRows,
        row_6: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_dice_triangles_before(rows_11, rt::into(row_6)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_dice_triangles_before(
        &self,
        rows_11: DiceRows,
        row_6: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        let _e4 = self.v_dice_share(rows_11, row_6, rows_11.parts.x());
        let _e7 = self.v_dice_share(rows_11, row_6, rows_11.parts.z());
        let ends_1 = (_e4 + _e7);
        let _e10 = self.v_dice_parts_before(rows_11, row_6);
        let _e13 = self.v_dice_row_parts(rows_11, row_6);
        return (((rt::Scalar(2u32) * _e10) + ends_1) - _e13);
    }
    pub(crate) fn dice_triangles(&self, rows_12: DiceRows) -> u32 {
        rt::into(self.v_dice_triangles(rows_12))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_dice_triangles(&self, rows_12: DiceRows) -> rt::Scalar<u32> {
        let _e2 = self.v_dice_triangles_before(rows_12, rt::Scalar(rows_12.count));
        return _e2;
    }
    pub(crate) fn dice_row_of_triangle(
        &self,
        rows_13: DiceRows,
        number_10: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_dice_row_of_triangle(rows_13, rt::into(number_10)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_dice_row_of_triangle(
        &self,
        rows_13: DiceRows,
        number_10: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        let mut row_7: rt::Scalar<u32>;

        let _e2 = self.v_dice_triangles(rows_13);
        let _e3 = self.v_dice_guess(rows_13, number_10, _e2);
        row_7 = _e3;
        'naga_break: loop {
            'naga_continue: {
                let _e5 = row_7;
                let _e6 = self.v_dice_triangles_before(rows_13, _e5);
                if rt::Scalar::into_branch_condition(_e6.elementwise_gt(number_10)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e8 = row_7;
                    row_7 = (_e8 - rt::Scalar(1u32));
                }
            }
        }
        'naga_break: loop {
            'naga_continue: {
                let _e11 = row_7;
                let _e14 = self.v_dice_triangles_before(rows_13, (_e11 + rt::Scalar(1u32)));
                if rt::Scalar::into_branch_condition(_e14.elementwise_le(number_10)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e16 = row_7;
                    row_7 = (_e16 + rt::Scalar(1u32));
                }
            }
        }
        let _e19 = row_7;
        return (_e19 + rt::Scalar(1u32));
    }
    pub(crate) fn dice_rows(&self, parts_2: impl rt::Into<rt::Vec3<u32>>) -> DiceRows {
        rt::into(self.v_dice_rows(rt::into(parts_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_dice_rows(&self, parts_2: rt::Vec3<u32>) -> DiceRows {
        let mut local_33: rt::Scalar<bool>;

        let of_last = rt::Scalar(2u32).select(rt::Scalar(1u32), parts_2.y().elementwise_le(parts_2.z()));
        if rt::Scalar::into_branch_condition(parts_2.x().elementwise_le(parts_2.y())) {
            local_33 = parts_2.x().elementwise_le(parts_2.z());
        } else {
            local_33 = rt::Scalar(false);
        }
        let _e17 = local_33;
        let short = of_last.select(rt::Scalar(0u32), _e17);
        let _e20 = self.v_around_three(short, rt::Scalar(2u32));
        let _e22 = self.v_around_three(short, rt::Scalar(1u32));
        let sides_2 = <rt::Vec3<u32>>::from_scalars(_e20, short, _e22);
        let _e25 = self.v_one_of(parts_2, sides_2.x());
        let _e27 = self.v_one_of(parts_2, sides_2.y());
        let _e29 = self.v_one_of(parts_2, sides_2.z());
        let sorted = <rt::Vec3<u32>>::from_scalars(_e25, _e27, _e29);
        return <DiceRows>::new(sides_2, sorted, sorted.x().max(sorted.z()));
    }
    pub(crate) fn dice_steps_below(
        &self,
        above: impl rt::Into<rt::Scalar<u32>>,
        below: impl rt::Into<rt::Scalar<u32>>,
        steps: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_dice_steps_below(rt::into(above), rt::into(below), rt::into(steps)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_dice_steps_below(
        &self,
        above: rt::Scalar<u32>,
        below: rt::Scalar<u32>,
        steps: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        let mut j: rt::Scalar<u32>;
        let mut local_34: rt::Scalar<bool>;
        let mut local_35: rt::Scalar<bool>;

        let least_5 = rt::Scalar(0u32).select((steps - above), steps.elementwise_gt(above));
        let most_10 = below.min(steps);
        j = (((((rt::Scalar(2u32) * steps) * below) + above) + below) / (rt::Scalar(2u32) * (above + below))).clamp(least_5, most_10);
        'naga_break: loop {
            'naga_continue: {
                let _e19 = j;
                if rt::Scalar::into_branch_condition(_e19.elementwise_gt(least_5)) {
                    let _e24 = j;
                    let _e30 = j;
                    local_34 = (((rt::Scalar(2u32) * _e24) - rt::Scalar(1u32)) * above).elementwise_gt((((rt::Scalar(2u32) * (steps - _e30)) + rt::Scalar(1u32)) * below));
                } else {
                    local_34 = rt::Scalar(false);
                }
                let _e38 = local_34;
                if rt::Scalar::into_branch_condition(_e38) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e39 = j;
                    j = (_e39 - rt::Scalar(1u32));
                }
            }
        }
        'naga_break: loop {
            'naga_continue: {
                let _e42 = j;
                if rt::Scalar::into_branch_condition(_e42.elementwise_lt(most_10)) {
                    let _e47 = j;
                    let _e53 = j;
                    local_35 = (((rt::Scalar(2u32) * _e47) + rt::Scalar(1u32)) * above).elementwise_le((((rt::Scalar(2u32) * (steps - _e53)) - rt::Scalar(1u32)) * below));
                } else {
                    local_35 = rt::Scalar(false);
                }
                let _e61 = local_35;
                if rt::Scalar::into_branch_condition(_e61) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e62 = j;
                    j = (_e62 + rt::Scalar(1u32));
                }
            }
        }
        let _e65 = j;
        return _e65;
    }
    pub(crate) fn dice_triangle(
        &self,
        rows_14: DiceRows,
        number_11: impl rt::Into<rt::Scalar<u32>>,
    ) -> DiceTriangle {
        rt::into(self.v_dice_triangle(rows_14, rt::into(number_11)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_dice_triangle(
        &self,
        rows_14: DiceRows,
        number_11: rt::Scalar<u32>,
    ) -> DiceTriangle {
        let mut local_36: rt::Scalar<bool>;

        let _e2 = self.v_dice_row_of_triangle(rows_14, number_11);
        let _e5 = self.v_dice_row_parts(rows_14, (_e2 - rt::Scalar(1u32)));
        let _e6 = self.v_dice_row_parts(rows_14, _e2);
        if rt::Scalar::into_branch_condition(_e2.elementwise_gt(rt::Scalar(1u32))) {
            let _e15 = self.v_dice_share(rows_14, (_e2 - rt::Scalar(1u32)), rows_14.parts.x());
            let _e18 = self.v_dice_share(rows_14, _e2, rows_14.parts.x());
            local_36 = _e15.elementwise_eq(_e18);
        } else {
            local_36 = rt::Scalar(false);
        }
        let is_shared = local_36;
        let _e24 = self.v_dice_triangles_before(rows_14, (_e2 - rt::Scalar(1u32)));
        let step_6 = ((number_11 - _e24) + rt::Scalar(0u32).select(rt::Scalar(1u32), is_shared));
        let _e30 = self.v_dice_steps_below(_e5, _e6, step_6);
        let i_10 = (step_6 - _e30);
        let _e34 = self.v_dice_steps_below(_e5, _e6, (step_6 + rt::Scalar(1u32)));
        let goes_below = _e34.elementwise_gt(_e30);
        let next_12 = <DicePlace>::new((_e2 - rt::Scalar(1u32)).select(_e2, goes_below), (i_10 + rt::Scalar(1u32)).select((_e30 + rt::Scalar(1u32)), goes_below));
        return <DiceTriangle>::new(<DicePlace>::new((_e2 - rt::Scalar(1u32)), i_10), <DicePlace>::new(_e2, _e30), next_12);
    }
    pub(crate) fn displaced_derivative(
        &self,
        along_3: impl rt::Into<rt::Vec3<f32>>,
        up: impl rt::Into<rt::Vec3<f32>>,
        rise: impl rt::Into<rt::Vec3<f32>>,
        turned: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_displaced_derivative(rt::into(along_3), rt::into(up), rt::into(rise), rt::into(turned)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_displaced_derivative(
        &self,
        along_3: rt::Vec3<f32>,
        up: rt::Vec3<f32>,
        rise: rt::Vec3<f32>,
        turned: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        return (((along_3 - (up * up.dot(along_3))) + rise) + turned);
    }
    pub(crate) fn log2_of(&self, number_12: impl rt::Into<rt::Scalar<f32>>) -> f32 {
        rt::into(self.v_log2_of(rt::into(number_12)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_log2_of(&self, number_12: rt::Scalar<f32>) -> rt::Scalar<f32> {
        let mut rest_1: rt::Scalar<f32>;
        let mut exponent_1: rt::Scalar<f32> = rt::Scalar(0f32);

        rest_1 = number_12;
        'naga_break: loop {
            'naga_continue: {
                let _e4 = rest_1;
                if rt::Scalar::into_branch_condition(_e4.elementwise_gt(rt::Scalar(1.4142135f32))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e7 = rest_1;
                    rest_1 = (_e7 * rt::Scalar(0.5f32));
                    let _e10 = exponent_1;
                    exponent_1 = (_e10 + rt::Scalar(1f32));
                }
            }
        }
        'naga_break: loop {
            'naga_continue: {
                let _e13 = rest_1;
                if rt::Scalar::into_branch_condition((_e13 * rt::Scalar(1.4142135f32)).elementwise_lt(rt::Scalar(1f32))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e18 = rest_1;
                    rest_1 = (_e18 * rt::Scalar(2f32));
                    let _e21 = exponent_1;
                    exponent_1 = (_e21 - rt::Scalar(1f32));
                }
            }
        }
        let _e24 = rest_1;
        let _e27 = rest_1;
        let part_25 = ((_e24 - rt::Scalar(1f32)) / (_e27 + rt::Scalar(1f32)));
        let square_3 = (part_25 * part_25);
        let sum_11 = (rt::Scalar(1f32) + (square_3 * (rt::Scalar(0.33333334f32) + (square_3 * (rt::Scalar(0.2f32) + (square_3 * (rt::Scalar(0.14285715f32) + (square_3 * rt::Scalar(0.11111111f32)))))))));
        let _e45 = exponent_1;
        return (_e45 + ((rt::Scalar(2.88539f32) * part_25) * sum_11));
    }
    pub(crate) fn level_at(&self, grid_5: Tessellation, site: BaseSite) -> f32 {
        rt::into(self.v_level_at(grid_5, site))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_level_at(&self, grid_5: Tessellation, site: BaseSite) -> rt::Scalar<f32> {
        if rt::Scalar::into_branch_condition(rt::Scalar(grid_5.levels).elementwise_le(rt::Scalar(1u32))) {
            return rt::Scalar(0f32);
        }
        let texels_5 = ((rt::Scalar(site.texels_per_m) * rt::Scalar(site.depth)) / rt::Scalar(grid_5.per_m)).max(rt::Scalar(1f32));
        let _e13 = self.v_log2_of(texels_5);
        return _e13.min((rt::Scalar(grid_5.levels) - rt::Scalar(1u32)).to_f32());
    }
    pub(crate) fn height_and_slope(
        &self,
        uv_7: impl rt::Into<rt::Vec2<f32>>,
        level_33: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_height_and_slope(rt::into(uv_7), rt::into(level_33)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_height_and_slope(
        &self,
        uv_7: rt::Vec2<f32>,
        level_33: rt::Scalar<u32>,
    ) -> rt::Vec3<f32> {
        let _e2 = self.v_height_size(level_33);
        let point_27 = ((uv_7 * _e2) - <rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32)));
        let _e8 = self.v_cell_of(point_27);
        let f_2 = (point_27 - _e8);
        let _e11 = self.v_height_cell(_e8.to_i32(), level_33);
        let top_7 = (_e11.x() + ((_e11.y() - _e11.x()) * f_2.x()));
        let bottom_4 = (_e11.z() + ((_e11.w() - _e11.z()) * f_2.x()));
        let left_4 = (_e11.x() + ((_e11.z() - _e11.x()) * f_2.y()));
        let right_3 = (_e11.y() + ((_e11.w() - _e11.y()) * f_2.y()));
        return <rt::Vec3<f32>>::from_scalars((top_7 + ((bottom_4 - top_7) * f_2.y())), ((right_3 - left_4) * _e2.x()), ((bottom_4 - top_7) * _e2.y()));
    }
    pub(crate) fn relief_between_levels(
        &self,
        uv_8: impl rt::Into<rt::Vec2<f32>>,
        level_34: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_relief_between_levels(rt::into(uv_8), rt::into(level_34)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_relief_between_levels(
        &self,
        uv_8: rt::Vec2<f32>,
        level_34: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let finer = level_34.to_u32();
        let part_26 = (level_34 - finer.to_f32());
        let _e5 = self.v_height_and_slope(uv_8, finer);
        if rt::Scalar::into_branch_condition(part_26.elementwise_eq(rt::Scalar(0f32))) {
            return _e5;
        }
        let _e10 = self.v_height_and_slope(uv_8, (finer + rt::Scalar(1u32)));
        return (_e5 + ((_e10 - _e5) * part_26));
    }
    pub(crate) fn sloped_uv(
        &self,
        uv_9: impl rt::Into<rt::Vec2<f32>>,
        level_35: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_sloped_uv(rt::into(uv_9), rt::into(level_35)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_sloped_uv(
        &self,
        uv_9: rt::Vec2<f32>,
        level_35: rt::Scalar<f32>,
    ) -> rt::Vec2<f32> {
        let mut local_37: rt::Scalar<bool>;
        let mut local_38: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition(uv_9.x().min(uv_9.y()).elementwise_ge(rt::Scalar(0f32))) {
            local_37 = uv_9.x().max(uv_9.y()).elementwise_le(rt::Scalar(1f32));
        } else {
            local_37 = rt::Scalar(false);
        }
        let is_inside_1 = local_37;
        let _e18 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition((!_e18.elementwise_ne(WRAP_CLAMP))) {
            local_38 = (!is_inside_1);
        } else {
            local_38 = rt::Scalar(true);
        }
        let _e26 = local_38;
        if rt::Scalar::into_branch_condition(_e26) {
            return uv_9;
        }
        let _e29 = self.v_height_size(level_35.ceil().to_u32());
        let least_6 = (rt::Vec2::splat_from_scalar(rt::Scalar(0.515625f32)) / _e29);
        return uv_9.clamp(least_6, (<rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32)) - least_6).max(least_6));
    }
    pub(crate) fn displaced_site(&self, grid_6: Tessellation, site_1: BaseSite) -> Corner {
        rt::into(self.v_displaced_site(grid_6, site_1))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_displaced_site(&self, grid_6: Tessellation, site_1: BaseSite) -> Corner {
        let mut up_1: rt::Vec3<f32>;
        let mut normal_15: rt::Vec3<f32>;

        let _e2 = self.v_level_at(grid_6, site_1);
        let _e4 = self.v_relief_between_levels(site_1.seen_uv, _e2);
        let _e6 = self.v_sloped_uv(site_1.uv, _e2);
        let _e7 = self.v_relief_between_levels(_e6, _e2);
        let scale_m = rt::Scalar(self.surface_settings.scale_m);
        let _e17 = rt::Scalar(self.surface_settings.bias_m);
        let position_3 = (site_1.position + (site_1.direction * ((_e4.x() * scale_m) + _e17)));
        let _e25 = rt::Scalar(self.surface_settings.bias_m);
        let metres_1 = ((_e7.x() * scale_m) + _e25);
        up_1 = site_1.normal;
        let _e29 = up_1;
        let _e30 = up_1;
        if rt::Scalar::into_branch_condition(_e29.dot(_e30).elementwise_gt(rt::Scalar(0f32))) {
            let _e34 = up_1;
            up_1 = _e34.normalize();
        }
        let rise_u = (site_1.direction * (_e7.y() * scale_m));
        let rise_v = (site_1.direction * (_e7.z() * scale_m));
        let _e45 = up_1;
        let _e48 = self.v_displaced_derivative(site_1.tangent, _e45, rise_u, (site_1.turn_u * metres_1));
        let _e50 = up_1;
        let _e53 = self.v_displaced_derivative(site_1.bitangent, _e50, rise_v, (site_1.turn_v * metres_1));
        let _e57 = up_1;
        let is_mirrored = site_1.bitangent.cross(site_1.tangent).dot(_e57).elementwise_lt(rt::Scalar(0f32));
        normal_15 = (_e53.cross(_e48) * rt::Scalar(1f32).select(rt::Scalar(-1f32), is_mirrored));
        let _e67 = normal_15;
        let _e68 = normal_15;
        if rt::Scalar::into_branch_condition(_e67.dot(_e68).elementwise_gt(rt::Scalar(0f32))) {
            let _e72 = normal_15;
            normal_15 = _e72.normalize();
        } else {
            let _e74 = up_1;
            normal_15 = _e74;
        }
        let _e75 = normal_15;
        return <Corner>::new(position_3, _e75, _e48, _e53, site_1.uv, <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32)));
    }
    pub(crate) fn search_texel_between(
        &self,
        path_29: Path,
        uv_10: impl rt::Into<rt::Vec2<f32>>,
        layer_6: impl rt::Into<rt::Scalar<i32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_search_texel_between(path_29, rt::into(uv_10), rt::into(layer_6)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_search_texel_between(
        &self,
        path_29: Path,
        uv_10: rt::Vec2<f32>,
        layer_6: rt::Scalar<i32>,
    ) -> rt::Vec4<f32> {
        let _e4 = self.v_height_texels(rt::Scalar(path_29.level));
        let _e5 = self.v_texels_around(uv_10, _e4);
        let level_67 = rt::Scalar(path_29.level).to_i32();
        let _e13 = self.v_search_texel(path_29, <rt::Vec2<i32>>::from_scalars(_e5.columns.x(), _e5.rows.x()), layer_6, level_67);
        let _e19 = self.v_search_texel(path_29, <rt::Vec2<i32>>::from_scalars(_e5.columns.y(), _e5.rows.x()), layer_6, level_67);
        let _e25 = self.v_search_texel(path_29, <rt::Vec2<i32>>::from_scalars(_e5.columns.x(), _e5.rows.y()), layer_6, level_67);
        let _e31 = self.v_search_texel(path_29, <rt::Vec2<i32>>::from_scalars(_e5.columns.y(), _e5.rows.y()), layer_6, level_67);
        let _e33 = self.v_bilinear(_e13, _e19, _e25, _e31, _e5.part);
        return _e33;
    }
    pub(crate) fn distance_at(
        &self,
        path_30: Path,
        uv_11: impl rt::Into<rt::Vec2<f32>>,
        height_1: impl rt::Into<rt::Scalar<f32>>,
        slices: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_distance_at(path_30, rt::into(uv_11), rt::into(height_1), rt::into(slices)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_distance_at(
        &self,
        path_30: Path,
        uv_11: rt::Vec2<f32>,
        height_1: rt::Scalar<f32>,
        slices: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let place_41 = ((height_1 * slices) - rt::Scalar(0.5f32)).clamp(rt::Scalar(0f32), (slices - rt::Scalar(1f32)));
        let below_6 = place_41.floor();
        let _e13 = self.v_search_texel_between(path_30, uv_11, below_6.to_i32());
        let lower_4 = _e13.x();
        let _e21 = self.v_search_texel_between(path_30, uv_11, (below_6 + rt::Scalar(1f32)).min((slices - rt::Scalar(1f32))).to_i32());
        let upper_3 = _e21.x();
        return (lower_4 + ((upper_3 - lower_4) * (place_41 - below_6)));
    }
    pub(crate) fn material_of_texels(
        &self,
        place_18: impl rt::Into<rt::Vec2<f32>>,
        layer_7: impl rt::Into<rt::Scalar<i32>>,
        level_36: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_material_of_texels(rt::into(place_18), rt::into(layer_7), rt::into(level_36)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_material_of_texels(
        &self,
        place_18: rt::Vec2<f32>,
        layer_7: rt::Scalar<i32>,
        level_36: rt::Scalar<u32>,
    ) -> rt::Vec4<f32> {
        let _e5 = self.surface_settings.material_size;
        let _e6 = self.v_level_texels(_e5, level_36);
        let _e7 = self.v_color_texels_around(place_18, _e6);
        let k_62 = level_36.to_i32();
        let _e15 = rt::texture::Read::read_texel((&self.material_map), <rt::Vec2<i32>>::from_scalars(_e7.columns.x(), _e7.rows.x()), rt::Scalar::into_inner(layer_7), 0i32, rt::Scalar::into_inner(k_62));
        let _e22 = rt::texture::Read::read_texel((&self.material_map), <rt::Vec2<i32>>::from_scalars(_e7.columns.y(), _e7.rows.x()), rt::Scalar::into_inner(layer_7), 0i32, rt::Scalar::into_inner(k_62));
        let _e29 = rt::texture::Read::read_texel((&self.material_map), <rt::Vec2<i32>>::from_scalars(_e7.columns.x(), _e7.rows.y()), rt::Scalar::into_inner(layer_7), 0i32, rt::Scalar::into_inner(k_62));
        let _e36 = rt::texture::Read::read_texel((&self.material_map), <rt::Vec2<i32>>::from_scalars(_e7.columns.y(), _e7.rows.y()), rt::Scalar::into_inner(layer_7), 0i32, rt::Scalar::into_inner(k_62));
        let _e38 = self.v_bilinear(_e15, _e22, _e29, _e36, _e7.part);
        return _e38;
    }
    pub(crate) fn material_at(
        &self,
        uv_12: impl rt::Into<rt::Vec2<f32>>,
        layer_8: impl rt::Into<rt::Scalar<i32>>,
        level_37: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_material_at(rt::into(uv_12), rt::into(layer_8), rt::into(level_37)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_material_at(
        &self,
        uv_12: rt::Vec2<f32>,
        layer_8: rt::Scalar<i32>,
        level_37: rt::Scalar<u32>,
    ) -> rt::Vec4<f32> {
        let _e3 = self.v_color_place(uv_12);
        let _e4 = self.v_material_of_texels(_e3, layer_8, level_37);
        return _e4;
    }
    pub(crate) fn material_layer(
        &self,
        uv_13: impl rt::Into<rt::Vec2<f32>>,
        footprint_2: impl rt::Into<rt::Scalar<f32>>,
        layer_9: impl rt::Into<rt::Scalar<i32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_material_layer(rt::into(uv_13), rt::into(footprint_2), rt::into(layer_9)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_material_layer(
        &self,
        uv_13: rt::Vec2<f32>,
        footprint_2: rt::Scalar<f32>,
        layer_9: rt::Scalar<i32>,
    ) -> rt::Vec3<f32> {
        let _e5 = rt::Scalar(self.surface_settings.material_texels);
        let _e9 = rt::Scalar(self.surface_settings.material_levels);
        let _e10 = self.v_levels_of((footprint_2 * _e5), _e9);
        let _e12 = self.v_material_at(uv_13, layer_9, rt::Scalar(_e10.fine));
        let fine_1 = _e12.xyz();
        if rt::Scalar::into_branch_condition(rt::Scalar(_e10.part).elementwise_gt(rt::Scalar(0f32))) {
            let _e20 = self.v_material_at(uv_13, layer_9, (rt::Scalar(_e10.fine) + rt::Scalar(1u32)));
            return (fine_1 + ((_e20.xyz() - fine_1) * rt::Scalar(_e10.part)));
        }
        return fine_1;
    }
    pub(crate) fn emission_at(
        &self,
        uv_14: impl rt::Into<rt::Vec2<f32>>,
        footprint_3: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_emission_at(rt::into(uv_14), rt::into(footprint_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_emission_at(
        &self,
        uv_14: rt::Vec2<f32>,
        footprint_3: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let _e4 = rt::Scalar(self.surface_settings.has_material);
        if rt::Scalar::into_branch_condition((_e4 & rt::Scalar(2u32)).elementwise_eq(rt::Scalar(0u32))) {
            let _e11 = self.surface_settings.emission;
            return _e11.xyz();
        }
        let _e15 = self.surface_settings.emission;
        let _e18 = self.v_material_layer(uv_14, footprint_3, rt::Scalar(1i32));
        return (_e15.xyz() * _e18);
    }
    pub(crate) fn end_of_piece(
        &self,
        way_15: VoxelPath,
        part_8: CellPart,
        corners_3: VoxelCell,
        begin_2: impl rt::Into<rt::Scalar<f32>>,
        extinction: impl rt::Into<rt::Scalar<f32>>,
        most: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_end_of_piece(way_15, part_8, corners_3, rt::into(begin_2), rt::into(extinction), rt::into(most)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_end_of_piece(
        &self,
        way_15: VoxelPath,
        part_8: CellPart,
        corners_3: VoxelCell,
        begin_2: rt::Scalar<f32>,
        extinction: rt::Scalar<f32>,
        most: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let mut end_1: rt::Scalar<f32>;
        let mut k_6: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut local_39: rt::Scalar<bool>;

        end_1 = rt::Scalar(part_8.end);
        'naga_break: loop {
            'naga_continue: {
                let _e10 = k_6;
                if rt::Scalar::into_branch_condition(_e10.elementwise_lt(PIECE_HALVINGS)) {
                    let _e16 = end_1;
                    let _e17 = self.v_field_between(way_15, part_8.cell, corners_3, begin_2, _e16);
                    let _e19 = self.v_transmittance_of((_e17 * extinction));
                    local_39 = (rt::Scalar(1f32) - _e19).elementwise_gt(most);
                } else {
                    local_39 = rt::Scalar(false);
                }
                let _e24 = local_39;
                if rt::Scalar::into_branch_condition(_e24) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e25 = end_1;
                    end_1 = (begin_2 + (rt::Scalar(0.5f32) * (_e25 - begin_2)));
                    let _e30 = k_6;
                    k_6 = (_e30 + rt::Scalar(1u32));
                }
            }
        }
        let _e33 = end_1;
        return _e33;
    }
    pub(crate) fn ends_on(&self, sweep_4: Sweep, chain_1: SweptChain, other: SweptChain) -> bool {
        rt::into(self.v_ends_on(sweep_4, chain_1, other))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_ends_on(&self, sweep_4: Sweep, chain_1: SweptChain, other: SweptChain) -> rt::Scalar<bool> {
        if rt::Scalar::into_branch_condition(rt::Scalar(other.count).elementwise_lt(rt::Scalar(2i32))) {
            return rt::Scalar(false);
        }
        let _e10 = self.v_chain_point(sweep_4, chain_1, (rt::Scalar(chain_1.count) - rt::Scalar(1i32)));
        let end_9 = rt::Scalar(_e10.sides);
        let _e15 = self.v_chain_point(sweep_4, other, (rt::Scalar(other.count) - rt::Scalar(1i32)));
        let last_10 = rt::Scalar(_e15.sides);
        let _e20 = self.v_chain_point(sweep_4, other, (rt::Scalar(other.count) - rt::Scalar(2i32)));
        let before_10 = rt::Scalar(_e20.sides);
        return ((end_9 & last_10) & before_10).elementwise_ne(rt::Scalar(0u32));
    }
    pub(crate) fn plane_normal(&self, pixel_18: PixelIn) -> rt::Vec3<f32> {
        rt::into(self.v_plane_normal(pixel_18))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_plane_normal(&self, pixel_18: PixelIn) -> rt::Vec3<f32> {
        let a_34 = pixel_18.a.position;
        return (pixel_18.b.position - a_34).cross((pixel_18.c.position - a_34));
    }
    pub(crate) fn weights_of(
        &self,
        a_14: impl rt::Into<rt::Vec3<f32>>,
        b_14: impl rt::Into<rt::Vec3<f32>>,
        c_7: impl rt::Into<rt::Vec3<f32>>,
        normal_16: impl rt::Into<rt::Vec3<f32>>,
        point_10: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_weights_of(rt::into(a_14), rt::into(b_14), rt::into(c_7), rt::into(normal_16), rt::into(point_10)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_weights_of(
        &self,
        a_14: rt::Vec3<f32>,
        b_14: rt::Vec3<f32>,
        c_7: rt::Vec3<f32>,
        normal_16: rt::Vec3<f32>,
        point_10: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let nn = normal_16.dot(normal_16);
        let from_a = (point_10 - a_14);
        let wb = (from_a.cross((c_7 - a_14)).dot(normal_16) / nn);
        let wc = ((b_14 - a_14).cross(from_a).dot(normal_16) / nn);
        return <rt::Vec3<f32>>::from_scalars(((rt::Scalar(1f32) - wb) - wc), wb, wc);
    }
    pub(crate) fn plane_weights(
        &self,
        pixel_19: PixelIn,
        normal_17: impl rt::Into<rt::Vec3<f32>>,
        point_11: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_plane_weights(pixel_19, rt::into(normal_17), rt::into(point_11)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_plane_weights(
        &self,
        pixel_19: PixelIn,
        normal_17: rt::Vec3<f32>,
        point_11: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let _e9 = self.v_weights_of(pixel_19.a.position, pixel_19.b.position, pixel_19.c.position, normal_17, point_11);
        return _e9;
    }
    pub(crate) fn surface_plane_enter(
        &self,
        pixel_20: PixelIn,
        params_31: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_plane_enter(pixel_20, rt::into(params_31)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_plane_enter(
        &self,
        pixel_20: PixelIn,
        params_31: rt::Vec4<f32>,
    ) -> Entered {
        let mut local_40: rt::Scalar<bool>;
        let mut local_41: rt::Scalar<bool>;

        let _e2 = self.v_plane_normal(pixel_20);
        let _e5 = self.v_plane_distance(pixel_20, _e2);
        let point_28 = (pixel_20.origin + (pixel_20.direction * _e5));
        let _e8 = self.v_plane_weights(pixel_20, _e2, point_28);
        let wa = _e8.x();
        let wb_1 = _e8.y();
        let wc_1 = _e8.z();
        let uv_39 = (((pixel_20.a.uv * wa) + (pixel_20.b.uv * wb_1)) + (pixel_20.c.uv * wc_1));
        let tangent_1 = (((pixel_20.a.tangent * wa) + (pixel_20.b.tangent * wb_1)) + (pixel_20.c.tangent * wc_1));
        let bitangent = (((pixel_20.a.bitangent * wa) + (pixel_20.b.bitangent * wb_1)) + (pixel_20.c.bitangent * wc_1));
        let normal_32 = ((((pixel_20.a.normal * wa) + (pixel_20.b.normal * wb_1)) + (pixel_20.c.normal * wc_1)).normalize() * rt::Scalar(pixel_20.side));
        let tt = tangent_1.dot(tangent_1);
        let tb = tangent_1.dot(bitangent);
        let bb = bitangent.dot(bitangent);
        let area_3 = ((tt * bb) - (tb * tb));
        let _e67 = rt::Scalar(self.surface_settings.scale_m);
        let metric_2 = <rt::Vec4<f32>>::from_scalars(tt, tb, bb, _e67);
        let descent_2 = (rt::Scalar(0f32) - normal_32.dot((pixel_20.direction / rt::Vec3::splat_from_scalar(pixel_20.direction.length()))));
        if rt::Scalar::into_branch_condition((!descent_2.elementwise_gt(rt::Scalar(0f32)))) {
            let _e84 = rt::Scalar(self.surface_settings.scale_m);
            local_40 = _e84.elementwise_eq(rt::Scalar(0f32));
        } else {
            local_40 = rt::Scalar(true);
        }
        let is_entered = local_40;
        if rt::Scalar::into_branch_condition(area_3.elementwise_gt(rt::Scalar(0f32))) {
            local_41 = is_entered;
        } else {
            local_41 = rt::Scalar(false);
        }
        let _e96 = local_41;
        let segments = rt::Scalar(0u32).select(rt::Scalar(1u32), _e96);
        return <Entered>::new(segments, point_28, uv_39, tangent_1, bitangent, normal_32, metric_2, rt::Scalar(0u32), _e2, <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)), <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32)), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
    }
    pub(crate) fn middle_of(
        &self,
        pixel_21: PixelIn,
        along_4: impl rt::Into<rt::Vec3<f32>>,
    ) -> f32 {
        rt::into(self.v_middle_of(pixel_21, rt::into(along_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_middle_of(
        &self,
        pixel_21: PixelIn,
        along_4: rt::Vec3<f32>,
    ) -> rt::Scalar<f32> {
        let centre = (((pixel_21.a.position + pixel_21.b.position) + pixel_21.c.position) * rt::Scalar(0.33333334f32));
        return (centre - pixel_21.origin).dot(along_4);
    }
    pub(crate) fn prism_of(
        &self,
        pixel_22: PixelIn,
        along_5: impl rt::Into<rt::Vec3<f32>>,
        middle_3: impl rt::Into<rt::Scalar<f32>>,
        params_32: impl rt::Into<rt::Vec4<f32>>,
    ) -> Prism {
        rt::into(self.v_prism_of(pixel_22, rt::into(along_5), rt::into(middle_3), rt::into(params_32)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_prism_of(
        &self,
        pixel_22: PixelIn,
        along_5: rt::Vec3<f32>,
        middle_3: rt::Scalar<f32>,
        params_32: rt::Vec4<f32>,
    ) -> Prism {
        let origin_5 = (pixel_22.origin + (along_5 * middle_3));
        let _e8 = self.v_ordered(pixel_22, rt::Scalar(0u32));
        let _e10 = self.v_ordered(pixel_22, rt::Scalar(1u32));
        let _e12 = self.v_ordered(pixel_22, rt::Scalar(2u32));
        return <Prism>::new((_e8.position - origin_5), (_e10.position - origin_5), (_e12.position - origin_5), (_e8.normal * rt::Scalar(pixel_22.side)), (_e10.normal * rt::Scalar(pixel_22.side)), (_e12.normal * rt::Scalar(pixel_22.side)), (pixel_22.shell.lift * (params_32.y() * rt::Scalar(pixel_22.side))));
    }
    pub(crate) fn frame_at(
        &self,
        pixel_23: PixelIn,
        weights_1: impl rt::Into<rt::Vec3<f32>>,
        point_12: impl rt::Into<rt::Vec3<f32>>,
        uv_15: impl rt::Into<rt::Vec2<f32>>,
        facing: impl rt::Into<rt::Vec3<f32>>,
    ) -> Entered {
        rt::into(self.v_frame_at(pixel_23, rt::into(weights_1), rt::into(point_12), rt::into(uv_15), rt::into(facing)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_frame_at(
        &self,
        pixel_23: PixelIn,
        weights_1: rt::Vec3<f32>,
        point_12: rt::Vec3<f32>,
        uv_15: rt::Vec2<f32>,
        facing: rt::Vec3<f32>,
    ) -> Entered {
        let _e6 = self.v_ordered(pixel_23, rt::Scalar(0u32));
        let _e8 = self.v_ordered(pixel_23, rt::Scalar(1u32));
        let _e10 = self.v_ordered(pixel_23, rt::Scalar(2u32));
        let tangent_2 = (((_e6.tangent * weights_1.x()) + (_e8.tangent * weights_1.y())) + (_e10.tangent * weights_1.z()));
        let bitangent_1 = (((_e6.bitangent * weights_1.x()) + (_e8.bitangent * weights_1.y())) + (_e10.bitangent * weights_1.z()));
        let normal_33 = (((_e6.normal * weights_1.x()) + (_e8.normal * weights_1.y())) + (_e10.normal * weights_1.z()));
        let _e49 = rt::Scalar(self.surface_settings.scale_m);
        let metric_3 = <rt::Vec4<f32>>::from_scalars(tangent_2.dot(tangent_2), tangent_2.dot(bitangent_1), bitangent_1.dot(bitangent_1), _e49);
        let unit = (normal_33.normalize() * rt::Scalar(pixel_23.side));
        return <Entered>::new(rt::Scalar(1u32), point_12, uv_15, tangent_2, bitangent_1, unit, metric_3, rt::Scalar(0u32), facing, <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)), <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32)), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
    }
    pub(crate) fn facing_of(
        &self,
        pixel_24: PixelIn,
        along_6: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_facing_of(pixel_24, rt::into(along_6)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_facing_of(
        &self,
        pixel_24: PixelIn,
        along_6: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let _e2 = self.v_plane_normal(pixel_24);
        let unit_1 = (_e2 * (rt::Scalar(pixel_24.side) / _e2.dot(_e2).sqrt()));
        let cosine_11 = (rt::Scalar(0f32) - unit_1.dot(along_6));
        return (unit_1 - (along_6 * (rt::Scalar(0.0625f32) - cosine_11).max(rt::Scalar(0f32))));
    }
    pub(crate) fn shell_middle(
        &self,
        pixel_25: PixelIn,
        along_7: impl rt::Into<rt::Vec3<f32>>,
    ) -> Entered {
        rt::into(self.v_shell_middle(pixel_25, rt::into(along_7)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shell_middle(
        &self,
        pixel_25: PixelIn,
        along_7: rt::Vec3<f32>,
    ) -> Entered {
        let mut at_42: Entered;

        let third_3 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0.33333334f32), rt::Scalar(0.33333334f32), rt::Scalar(0.33333334f32));
        let uv_40 = (((pixel_25.a.uv + pixel_25.b.uv) + pixel_25.c.uv) * rt::Scalar(0.33333334f32));
        let _e17 = self.v_middle_of(pixel_25, along_7);
        let point_29 = (pixel_25.origin + (along_7 * _e17));
        let _e20 = self.v_facing_of(pixel_25, along_7);
        let _e21 = self.v_frame_at(pixel_25, third_3, point_29, uv_40, _e20);
        at_42 = _e21;
        rt::Scalar(at_42.segments) = rt::Scalar(0u32);
        let _e25 = at_42;
        return _e25;
    }
    pub(crate) fn way_weight(
        &self,
        along_8: impl rt::Into<rt::Vec3<f32>>,
        p: impl rt::Into<rt::Vec3<f32>>,
        n_12: impl rt::Into<rt::Vec3<f32>>,
        q: impl rt::Into<rt::Vec3<f32>>,
        m_3: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_way_weight(rt::into(along_8), rt::into(p), rt::into(n_12), rt::into(q), rt::into(m_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_way_weight(
        &self,
        along_8: rt::Vec3<f32>,
        p: rt::Vec3<f32>,
        n_12: rt::Vec3<f32>,
        q: rt::Vec3<f32>,
        m_3: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let most_11 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32));
        let middle_11 = (p.cross(m_3).min(most_11) + n_12.cross(q).min(most_11));
        return <rt::Vec3<f32>>::from_scalars(along_8.dot(p.cross(q)), along_8.dot(middle_11), along_8.dot(n_12.cross(m_3))).min(most_11);
    }
    pub(crate) fn way_of(
        &self,
        pixel_26: PixelIn,
        prism_3: Prism,
        along_9: impl rt::Into<rt::Vec3<f32>>,
    ) -> Way {
        rt::into(self.v_way_of(pixel_26, prism_3, rt::into(along_9)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_way_of(
        &self,
        pixel_26: PixelIn,
        prism_3: Prism,
        along_9: rt::Vec3<f32>,
    ) -> Way {
        let first_19 = (rt::Scalar(pixel_26.shell.order) & rt::Scalar(3u32));
        let second_5 = ((rt::Scalar(pixel_26.shell.order) >> rt::Scalar(2u32)) & rt::Scalar(3u32));
        let is_turned = (((second_5 + rt::Scalar(3u32)) - first_19) % rt::Scalar(3u32)).elementwise_ne(rt::Scalar(1u32));
        let _e24 = self.v_way_weight(along_9, prism_3.p1_, prism_3.n1_, prism_3.p2_, prism_3.n2_);
        let _e29 = self.v_way_weight(along_9, prism_3.p2_, prism_3.n2_, prism_3.p0_, prism_3.n0_);
        let _e34 = self.v_way_weight(along_9, prism_3.p0_, prism_3.n0_, prism_3.p1_, prism_3.n1_);
        return <Way>::new(_e24, _e29, _e34, rt::Scalar(pixel_26.side).select((rt::Scalar(0f32) - rt::Scalar(pixel_26.side)), is_turned));
    }
    pub(crate) fn offsets_of(&self, shell: Shell) -> rt::Vec2<f32> {
        rt::into(self.v_offsets_of(shell))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_offsets_of(&self, shell: Shell) -> rt::Vec2<f32> {
        let _e4 = self.surface_settings.shell_m.y();
        let _e8 = self.surface_settings.shell_m.x();
        let width_5 = (_e4 - _e8).min(rt::Scalar(300000000000000000000000000000000000000f32));
        let quarter = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0.25f32), rt::Scalar(0.25f32), rt::Scalar(0.25f32));
        let zero = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
        let lowered = shell.lift.min(zero).dot(quarter);
        let lifted = shell.lift.max(zero).dot(quarter);
        let _e29 = self.surface_settings.shell_m.x();
        return ((rt::Vec2::splat_from_scalar(_e29) + (width_5 * shell.heights)) + <rt::Vec2<f32>>::from_scalars(lowered, lifted));
    }
    pub(crate) fn way_offsets(
        &self,
        pixel_27: PixelIn,
        prism_4: Prism,
        slack_3: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_way_offsets(pixel_27, prism_4, rt::into(slack_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_way_offsets(
        &self,
        pixel_27: PixelIn,
        prism_4: Prism,
        slack_3: rt::Scalar<f32>,
    ) -> rt::Vec2<f32> {
        let mut shell_1: Shell;

        shell_1 = pixel_27.shell;
        shell_1.lift = prism_4.lift;
        let _e10 = self.surface_settings.shell_m.y();
        let _e14 = self.surface_settings.shell_m.x();
        let more = (slack_3 + (rt::Scalar(0.000001f32) * (_e10 - _e14)));
        let _e19 = shell_1;
        let _e20 = self.v_offsets_of(_e19);
        return (_e20 + <rt::Vec2<f32>>::from_scalars((rt::Scalar(0f32) - more), more));
    }
    pub(crate) fn sides_over_area(
        &self,
        prism_5: Prism,
        offset_2: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_sides_over_area(prism_5, rt::into(offset_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_sides_over_area(
        &self,
        prism_5: Prism,
        offset_2: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let a_35 = ((prism_5.p2_ - prism_5.p1_) + ((prism_5.n2_ - prism_5.n1_) * offset_2));
        let b_35 = ((prism_5.p0_ - prism_5.p2_) + ((prism_5.n0_ - prism_5.n2_) * offset_2));
        let c_25 = ((prism_5.p1_ - prism_5.p0_) + ((prism_5.n1_ - prism_5.n0_) * offset_2));
        return (<rt::Vec3<f32>>::from_scalars(a_35.length(), b_35.length(), c_25.length()) / rt::Vec3::splat_from_scalar(b_35.cross(c_25).length().max(rt::Scalar(0.000000000000000000000000000001f32))));
    }
    pub(crate) fn way_beyond(
        &self,
        prism_6: Prism,
        offsets: impl rt::Into<rt::Vec2<f32>>,
        metres: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_way_beyond(prism_6, rt::into(offsets), rt::into(metres)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_way_beyond(
        &self,
        prism_6: Prism,
        offsets: rt::Vec2<f32>,
        metres: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let _e4 = self.v_sides_over_area(prism_6, offsets.x());
        let _e6 = self.v_sides_over_area(prism_6, offsets.y());
        return (_e4.min(_e6) * metres);
    }
    pub(crate) fn grown_way(
        &self,
        way_16: Way,
        beyond_1: impl rt::Into<rt::Vec3<f32>>,
    ) -> Way {
        rt::into(self.v_grown_way(way_16, rt::into(beyond_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_grown_way(
        &self,
        way_16: Way,
        beyond_1: rt::Vec3<f32>,
    ) -> Way {
        let sum_12 = ((way_16.first + way_16.second) + way_16.third);
        return <Way>::new((way_16.first + (sum_12 * beyond_1.x())), (way_16.second + (sum_12 * beyond_1.y())), (way_16.third + (sum_12 * beyond_1.z())), rt::Scalar(way_16.turn));
    }
    pub(crate) fn root_behind(
        &self,
        c_8: impl rt::Into<rt::Vec3<f32>>,
        place_19: impl rt::Into<rt::Scalar<f32>>,
        end_2: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_root_behind(rt::into(c_8), rt::into(place_19), rt::into(end_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_root_behind(
        &self,
        c_8: rt::Vec3<f32>,
        place_19: rt::Scalar<f32>,
        end_2: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let mut first: rt::Scalar<f32>;

        let _e3 = self.v_both_roots(c_8);
        first = end_2;
        if rt::Scalar::into_branch_condition(_e3.x().elementwise_gt(place_19)) {
            let _e7 = first;
            first = _e7.min(_e3.x());
        }
        if rt::Scalar::into_branch_condition(_e3.y().elementwise_gt(place_19)) {
            let _e12 = first;
            first = _e12.min(_e3.y());
        }
        let _e15 = first;
        return _e15;
    }
    pub(crate) fn is_inside(
        &self,
        way_17: Way,
        offset_3: impl rt::Into<rt::Scalar<f32>>,
    ) -> bool {
        rt::into(self.v_is_inside(way_17, rt::into(offset_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_is_inside(
        &self,
        way_17: Way,
        offset_3: rt::Scalar<f32>,
    ) -> rt::Scalar<bool> {
        let mut local_42: rt::Scalar<bool>;

        let _e3 = self.v_quadratic(way_17.first, offset_3);
        let _e5 = self.v_quadratic(way_17.second, offset_3);
        let _e7 = self.v_quadratic(way_17.third, offset_3);
        if rt::Scalar::into_branch_condition((!_e3.min(_e5).min(_e7).elementwise_gt(rt::Scalar(0f32)))) {
            local_42 = _e3.max(_e5).max(_e7).elementwise_lt(rt::Scalar(0f32));
        } else {
            local_42 = rt::Scalar(true);
        }
        let _e20 = local_42;
        return _e20;
    }
    pub(crate) fn way_chord(
        &self,
        pixel_28: PixelIn,
        prism_7: Prism,
        along_10: impl rt::Into<rt::Vec3<f32>>,
        way_18: Way,
        offsets_1: impl rt::Into<rt::Vec2<f32>>,
        beyond_2: impl rt::Into<rt::Vec3<f32>>,
        tolerance_1: impl rt::Into<rt::Scalar<f32>>,
        number_13: impl rt::Into<rt::Scalar<u32>>,
    ) -> WayChord {
        rt::into(self.v_way_chord(pixel_28, prism_7, rt::into(along_10), way_18, rt::into(offsets_1), rt::into(beyond_2), rt::into(tolerance_1), rt::into(number_13)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_way_chord(
        &self,
        pixel_28: PixelIn,
        prism_7: Prism,
        along_10: rt::Vec3<f32>,
        way_18: Way,
        offsets_1: rt::Vec2<f32>,
        beyond_2: rt::Vec3<f32>,
        tolerance_1: rt::Scalar<f32>,
        number_13: rt::Scalar<u32>,
    ) -> WayChord {
        let mut chosen: rt::Vec2<f32> = <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32));
        let mut count_4: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut begin_3: rt::Scalar<f32>;
        let mut pieces: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut local_43: rt::Scalar<bool>;
        let mut local_44: rt::Scalar<bool>;

        let _e8 = self.v_grown_way(way_18, beyond_2);
        begin_3 = offsets_1.x();
        'naga_break: loop {
            'naga_continue: {
                let _e19 = pieces;
                if rt::Scalar::into_branch_condition(_e19.elementwise_lt(MOST_PIECES)) {
                    let _e24 = begin_3;
                    local_43 = _e24.elementwise_lt(offsets_1.y());
                } else {
                    local_43 = rt::Scalar(false);
                }
                let _e28 = local_43;
                if rt::Scalar::into_branch_condition(_e28) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e29 = pieces;
                    pieces = (_e29 + rt::Scalar(1u32));
                    let _e33 = begin_3;
                    let _e35 = self.v_root_behind(_e8.first, _e33, offsets_1.y());
                    let _e37 = begin_3;
                    let _e39 = self.v_root_behind(_e8.second, _e37, offsets_1.y());
                    let _e42 = begin_3;
                    let _e44 = self.v_root_behind(_e8.third, _e42, offsets_1.y());
                    let end_10 = _e35.min(_e39).min(_e44);
                    let _e46 = begin_3;
                    let _e50 = self.v_is_inside(_e8, (rt::Scalar(0.5f32) * (_e46 + end_10)));
                    if rt::Scalar::into_branch_condition(_e50) {
                        let _e51 = begin_3;
                        let _e53 = self.v_chords_of_piece(pixel_28, prism_7, along_10, way_18, <rt::Vec2<f32>>::from_scalars(_e51, end_10), tolerance_1);
                        let _e54 = count_4;
                        if rt::Scalar::into_branch_condition(number_13.elementwise_ge(_e54)) {
                            let _e58 = count_4;
                            local_44 = number_13.elementwise_lt((_e58 + _e53));
                        } else {
                            local_44 = rt::Scalar(false);
                        }
                        let _e62 = local_44;
                        if rt::Scalar::into_branch_condition(_e62) {
                            let _e63 = begin_3;
                            let long_2 = (end_10 - _e63).min(rt::Scalar(300000000000000000000000000000000000000f32));
                            let _e67 = count_4;
                            let part_27 = ((number_13 - _e67).to_f32() / _e53.to_f32());
                            let _e72 = count_4;
                            let next_13 = (((number_13 - _e72) + rt::Scalar(1u32)).to_f32() / _e53.to_f32());
                            let _e79 = begin_3;
                            let _e82 = begin_3;
                            chosen = <rt::Vec2<f32>>::from_scalars((_e79 + (long_2 * part_27)), (_e82 + (long_2 * next_13)));
                        }
                        let _e86 = count_4;
                        count_4 = (_e86 + _e53);
                    }
                    begin_3 = end_10;
                }
            }
        }
        let _e88 = chosen;
        let _e89 = count_4;
        return <WayChord>::new(_e88, _e89);
    }
    pub(crate) fn folded_enter(
        &self,
        pixel_29: PixelIn,
        params_33: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_folded_enter(pixel_29, rt::into(params_33)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_folded_enter(
        &self,
        pixel_29: PixelIn,
        params_33: rt::Vec4<f32>,
    ) -> Entered {
        let mut at_43: Entered;

        let along_25 = pixel_29.direction.normalize();
        let _e4 = self.v_middle_of(pixel_29, along_25);
        let _e5 = self.v_prism_of(pixel_29, along_25, _e4, params_33);
        let _e6 = self.v_shell_middle(pixel_29, along_25);
        at_43 = _e6;
        let _e8 = self.v_way_of(pixel_29, _e5, along_25);
        let _e9 = self.v_shell_slack(pixel_29, _e4);
        let _e10 = self.v_way_offsets(pixel_29, _e5, _e9);
        let _e11 = at_43;
        let _e12 = self.v_chord_reach(pixel_29, _e11, _e4, params_33);
        let _e13 = self.v_way_beyond(_e5, _e10, _e12);
        let _e17 = self.v_way_chord(pixel_29, _e5, along_25, _e8, _e10, _e13, params_33.x(), rt::Scalar(0u32));
        rt::Scalar(at_43.segments) = rt::Scalar(_e17.count);
        let _e19 = at_43;
        return _e19;
    }
    pub(crate) fn in_slab(
        &self,
        interval_3: impl rt::Into<rt::Vec2<f32>>,
        normal_18: impl rt::Into<rt::Vec3<f32>>,
        a_15: impl rt::Into<rt::Vec3<f32>>,
        b_15: impl rt::Into<rt::Vec3<f32>>,
        c_9: impl rt::Into<rt::Vec3<f32>>,
        d_2: impl rt::Into<rt::Vec3<f32>>,
        along_11: impl rt::Into<rt::Vec3<f32>>,
        slack_4: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_in_slab(rt::into(interval_3), rt::into(normal_18), rt::into(a_15), rt::into(b_15), rt::into(c_9), rt::into(d_2), rt::into(along_11), rt::into(slack_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_in_slab(
        &self,
        interval_3: rt::Vec2<f32>,
        normal_18: rt::Vec3<f32>,
        a_15: rt::Vec3<f32>,
        b_15: rt::Vec3<f32>,
        c_9: rt::Vec3<f32>,
        d_2: rt::Vec3<f32>,
        along_11: rt::Vec3<f32>,
        slack_4: rt::Scalar<f32>,
    ) -> rt::Vec2<f32> {
        let far_12 = <rt::Vec4<f32>>::from_scalars(normal_18.dot(a_15), normal_18.dot(b_15), normal_18.dot(c_9), normal_18.dot(d_2));
        let least_7 = far_12.x().min(far_12.y()).min(far_12.z().min(far_12.w()));
        let most_12 = far_12.x().max(far_12.y()).max(far_12.z().max(far_12.w()));
        let beyond_3 = (slack_4 * normal_18.length());
        let change_5 = normal_18.dot(along_11);
        let _e32 = self.v_where_positive(interval_3, (rt::Scalar(0f32) - least_7), change_5, beyond_3);
        let _e35 = self.v_where_positive(_e32, most_12, (rt::Scalar(0f32) - change_5), beyond_3);
        return _e35;
    }
    pub(crate) fn span_of(
        &self,
        pixel_30: PixelIn,
        prism_8: Prism,
        along_12: impl rt::Into<rt::Vec3<f32>>,
        middle_4: impl rt::Into<rt::Scalar<f32>>,
        params_34: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_span_of(pixel_30, prism_8, rt::into(along_12), rt::into(middle_4), rt::into(params_34)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_span_of(
        &self,
        pixel_30: PixelIn,
        prism_8: Prism,
        along_12: rt::Vec3<f32>,
        middle_4: rt::Scalar<f32>,
        params_34: rt::Vec4<f32>,
    ) -> rt::Vec2<f32> {
        let mut shell_2: Shell;
        let mut span_2: rt::Vec2<f32>;

        shell_2 = pixel_30.shell;
        let _e9 = shell_2.lift;
        shell_2.lift = (_e9 * params_34.y());
        let _e12 = shell_2;
        let _e13 = self.v_offsets_of(_e12);
        let _e14 = self.v_shell_slack(pixel_30, middle_4);
        let low0_ = (prism_8.p0_ + (prism_8.n0_ * _e13.x()));
        let low1_ = (prism_8.p1_ + (prism_8.n1_ * _e13.x()));
        let low2_ = (prism_8.p2_ + (prism_8.n2_ * _e13.x()));
        let high0_ = (prism_8.p0_ + (prism_8.n0_ * _e13.y()));
        let high1_ = (prism_8.p1_ + (prism_8.n1_ * _e13.y()));
        let high2_ = (prism_8.p2_ + (prism_8.n2_ * _e13.y()));
        span_2 = <rt::Vec2<f32>>::from_scalars((rt::Scalar(0f32) - middle_4), rt::Scalar(300000000000000000000000000000000000000f32));
        let _e50 = span_2;
        let _e54 = self.v_in_slab(_e50, (low1_ - low0_).cross((low2_ - low0_)), low0_, high0_, high1_, high2_, along_12, _e14);
        span_2 = _e54;
        let _e55 = span_2;
        let _e59 = self.v_in_slab(_e55, (high1_ - high0_).cross((high2_ - high0_)), high0_, low0_, low1_, low2_, along_12, _e14);
        span_2 = _e59;
        let _e61 = span_2.y();
        let _e63 = span_2.x();
        if rt::Scalar::into_branch_condition((!_e61.elementwise_gt(_e63))) {
            let _e66 = span_2;
            return _e66;
        }
        let _e67 = span_2;
        let _e71 = self.v_in_slab(_e67, (high1_ - low0_).cross((low1_ - high0_)), low0_, low1_, low2_, high2_, along_12, _e14);
        span_2 = _e71;
        let _e72 = span_2;
        let _e76 = self.v_in_slab(_e72, (high2_ - low1_).cross((low2_ - high1_)), low1_, low2_, low0_, high0_, along_12, _e14);
        span_2 = _e76;
        let _e78 = span_2.y();
        let _e80 = span_2.x();
        if rt::Scalar::into_branch_condition((!_e78.elementwise_gt(_e80))) {
            let _e83 = span_2;
            return _e83;
        }
        let _e84 = span_2;
        let _e88 = self.v_in_slab(_e84, (high0_ - low2_).cross((low0_ - high2_)), low2_, low0_, low1_, high1_, along_12, _e14);
        span_2 = _e88;
        let _e89 = span_2;
        return _e89;
    }
    pub(crate) fn passed_by(&self) -> Entered {
        rt::into(self.v_passed_by())
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_passed_by(&self) -> Entered {
        let zero_1 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
        let zeros = <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
        let uv_41 = <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32));
        return <Entered>::new(rt::Scalar(0u32), zero_1, uv_41, zero_1, zero_1, zero_1, zeros, rt::Scalar(0u32), zero_1, uv_41, zeros, rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
    }
    pub(crate) fn shell_point_from(
        &self,
        prism_9: Prism,
        place_20: impl rt::Into<rt::Vec3<f32>>,
        from_point: ShellPoint,
    ) -> ShellPoint {
        rt::into(self.v_shell_point_from(prism_9, rt::into(place_20), from_point))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_shell_point_from(
        &self,
        prism_9: Prism,
        place_20: rt::Vec3<f32>,
        from_point: ShellPoint,
    ) -> ShellPoint {
        let mut w_1: rt::Vec3<f32>;
        let mut h_4: rt::Scalar<f32>;
        let mut step_1: rt::Scalar<u32> = rt::Scalar(0u32);

        let low_6 = self.surface_settings.shell_m.x();
        let _e10 = self.surface_settings.shell_m.y();
        let width_6 = (_e10 - low_6).min(rt::Scalar(300000000000000000000000000000000000000f32));
        let l = prism_9.lift;
        w_1 = from_point.weights;
        h_4 = rt::Scalar(from_point.height);
        'naga_break: loop {
            'naga_continue: {
                let _e21 = step_1;
                if rt::Scalar::into_branch_condition(_e21.elementwise_lt(NEWTON_STEPS)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e24 = step_1;
                    step_1 = (_e24 + rt::Scalar(1u32));
                    let _e27 = h_4;
                    let _e30 = w_1;
                    let _e31 = self.v_lift_of(l, _e30);
                    let offset_7 = ((low_6 + (width_6 * _e27)) + _e31);
                    let _e35 = w_1.x();
                    let _e39 = w_1.y();
                    let _e44 = w_1.z();
                    let normal_34 = (((prism_9.n0_ * _e35) + (prism_9.n1_ * _e39)) + (prism_9.n2_ * _e44));
                    let _e49 = w_1.x();
                    let _e53 = w_1.y();
                    let _e58 = w_1.z();
                    let base_1 = (((prism_9.p0_ * _e49) + (prism_9.p1_ * _e53)) + (prism_9.p2_ * _e58));
                    let rest_7 = ((place_20 - base_1) - (normal_34 * offset_7));
                    let _e66 = w_1.x();
                    let _e68 = w_1.y();
                    let _e72 = w_1.z();
                    let second_6 = ((l.z() * (_e66 - _e68)) + (_e72 * (l.x() - l.y())));
                    let _e80 = w_1.x();
                    let _e82 = w_1.z();
                    let _e86 = w_1.y();
                    let third_4 = ((l.y() * (_e80 - _e82)) + (_e86 * (l.x() - l.z())));
                    let a_36 = (((prism_9.p1_ - prism_9.p0_) + ((prism_9.n1_ - prism_9.n0_) * offset_7)) + (normal_34 * second_6));
                    let b_36 = (((prism_9.p2_ - prism_9.p0_) + ((prism_9.n2_ - prism_9.n0_) * offset_7)) + (normal_34 * third_4));
                    let c_26 = (normal_34 * width_6);
                    let across_6 = b_36.cross(c_26);
                    let one_over = (rt::Scalar(1f32) / a_36.dot(across_6));
                    let db = (rest_7.dot(across_6) * one_over);
                    let dc = (rest_7.dot(c_26.cross(a_36)) * one_over);
                    let dh = (rest_7.dot(a_36.cross(b_36)) * one_over);
                    let _e126 = w_1.x();
                    let _e130 = w_1.y();
                    let _e133 = w_1.z();
                    w_1 = <rt::Vec3<f32>>::from_scalars(((_e126 - db) - dc), (_e130 + db), (_e133 + dc));
                    let _e136 = h_4;
                    h_4 = (_e136 + dh);
                    if rt::Scalar::into_branch_condition(db.abs().max(dc.abs()).max(dh.abs()).elementwise_lt(rt::Scalar(0.001f32))) {
                        break 'naga_break;
                    }
                }
            }
        }
        let _e145 = w_1;
        let _e146 = h_4;
        return <ShellPoint>::new(_e145, _e146);
    }
    pub(crate) fn shell_point(
        &self,
        prism_10: Prism,
        place_21: impl rt::Into<rt::Vec3<f32>>,
        height_2: impl rt::Into<rt::Scalar<f32>>,
    ) -> ShellPoint {
        rt::into(self.v_shell_point(prism_10, rt::into(place_21), rt::into(height_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shell_point(
        &self,
        prism_10: Prism,
        place_21: rt::Vec3<f32>,
        height_2: rt::Scalar<f32>,
    ) -> ShellPoint {
        let _e8 = self.v_shell_point_from(prism_10, place_21, <ShellPoint>::new(<rt::Vec3<f32>>::from_scalars(rt::Scalar(0.28125f32), rt::Scalar(0.375f32), rt::Scalar(0.34375f32)), height_2));
        return _e8;
    }
    pub(crate) fn surface_prism_enter(
        &self,
        pixel_31: PixelIn,
        params_35: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_prism_enter(pixel_31, rt::into(params_35)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_prism_enter(
        &self,
        pixel_31: PixelIn,
        params_35: rt::Vec4<f32>,
    ) -> Entered {
        let mut local_45: rt::Scalar<bool>;
        let mut at_44: Entered;

        if rt::Scalar::into_branch_condition(rt::Scalar(pixel_31.shell.order).elementwise_ge(SHELL_FOLDED)) {
            let _e6 = self.v_folded_enter(pixel_31, params_35);
            return _e6;
        }
        let along_26 = pixel_31.direction.normalize();
        let _e9 = self.v_middle_of(pixel_31, along_26);
        let _e10 = self.v_prism_of(pixel_31, along_26, _e9, params_35);
        let _e11 = self.v_span_of(pixel_31, _e10, along_26, _e9, params_35);
        let long_3 = (_e11.y() - _e11.x()).min(rt::Scalar(300000000000000000000000000000000000000f32));
        if rt::Scalar::into_branch_condition((!(!long_3.elementwise_gt(rt::Scalar(0f32))))) {
            local_45 = (!long_3.elementwise_lt(rt::Scalar(300000000000000000000000000000000000000f32)));
        } else {
            local_45 = rt::Scalar(true);
        }
        let _e27 = local_45;
        if rt::Scalar::into_branch_condition(_e27) {
            let _e28 = self.v_passed_by();
            return _e28;
        }
        let _e29 = self.v_shell_middle(pixel_31, along_26);
        at_44 = _e29;
        at_44.span = _e11;
        let height_22 = (rt::Scalar(0.5f32) * (pixel_31.shell.heights.x() + pixel_31.shell.heights.y()));
        let _e43 = at_44.span.x();
        let _e45 = self.v_shell_point(_e10, (along_26 * _e43), height_22);
        let _e48 = at_44.span.y();
        let _e50 = self.v_shell_point(_e10, (along_26 * _e48), height_22);
        let _e53 = at_44.span.x();
        let _e58 = self.v_between(_e45, _e50);
        let _e59 = self.v_shell_point_from(_e10, (along_26 * (_e53 + (rt::Scalar(0.5f32) * long_3))), _e58);
        let _e62 = at_44.span.x();
        let _e67 = self.v_between(_e45, _e59);
        let _e68 = self.v_shell_point_from(_e10, (along_26 * (_e62 + (rt::Scalar(0.25f32) * long_3))), _e67);
        let _e71 = at_44.span.x();
        let _e76 = self.v_between(_e59, _e50);
        let _e77 = self.v_shell_point_from(_e10, (along_26 * (_e71 + (rt::Scalar(0.75f32) * long_3))), _e76);
        let _e79 = self.v_beside_chord(pixel_31, _e45, _e59, _e50, _e68, rt::Scalar(0.25f32));
        let _e81 = self.v_beside_chord(pixel_31, _e45, _e59, _e50, _e77, rt::Scalar(0.75f32));
        let quarters_1 = _e79.max(_e81);
        let _e84 = self.v_beside_chord(pixel_31, _e45, _e59, _e50, _e59, rt::Scalar(0.5f32));
        let most_13 = _e84.max(quarters_1);
        rt::Scalar(at_44.segments) = (most_13 / params_35.x()).sqrt().ceil().clamp(rt::Scalar(1f32), rt::Scalar(32f32)).to_u32();
        let _e95 = at_44;
        return _e95;
    }
    pub(crate) fn weight_at(
        &self,
        order: impl rt::Into<rt::Scalar<u32>>,
        weights_2: impl rt::Into<rt::Vec3<f32>>,
    ) -> f32 {
        rt::into(self.v_weight_at(rt::into(order), rt::into(weights_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_weight_at(
        &self,
        order: rt::Scalar<u32>,
        weights_2: rt::Vec3<f32>,
    ) -> rt::Scalar<f32> {
        let corner_6 = (order & rt::Scalar(3u32));
        return weights_2.z().select(weights_2.y(), corner_6.elementwise_eq(rt::Scalar(1u32))).select(weights_2.x(), corner_6.elementwise_eq(rt::Scalar(0u32)));
    }
    pub(crate) fn ordered_weights(
        &self,
        shell_3: Shell,
        weights_3: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_ordered_weights(shell_3, rt::into(weights_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_ordered_weights(
        &self,
        shell_3: Shell,
        weights_3: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let _e3 = self.v_weight_at(rt::Scalar(shell_3.order), weights_3);
        let _e7 = self.v_weight_at((rt::Scalar(shell_3.order) >> rt::Scalar(2u32)), weights_3);
        let _e11 = self.v_weight_at((rt::Scalar(shell_3.order) >> rt::Scalar(4u32)), weights_3);
        return <rt::Vec3<f32>>::from_scalars(_e3, _e7, _e11);
    }
    pub(crate) fn quadric_of(
        &self,
        pixel_32: PixelIn,
        point_13: impl rt::Into<rt::Vec3<f32>>,
        lift_1: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_quadric_of(pixel_32, rt::into(point_13), rt::into(lift_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_quadric_of(
        &self,
        pixel_32: PixelIn,
        point_13: rt::Vec3<f32>,
        lift_1: rt::Scalar<f32>,
    ) -> rt::Vec4<f32> {
        let mut height_3: rt::Scalar<f32>;

        let _e3 = self.v_plane_normal(pixel_32);
        let _e4 = self.v_plane_weights(pixel_32, _e3, point_13);
        let quadric_2 = (((pixel_32.a.of_surface * _e4.x()) + (pixel_32.b.of_surface * _e4.y())) + (pixel_32.c.of_surface * _e4.z()));
        let _e19 = self.v_base_height();
        height_3 = _e19;
        let _e23 = rt::Scalar(self.surface_settings.bias_m);
        let _e26 = rt::Scalar(self.surface_settings.scale_m);
        if rt::Scalar::into_branch_condition((_e23 + _e26).elementwise_gt(rt::Scalar(0f32))) {
            let _e30 = height_3;
            height_3 = ((rt::Scalar(2f32) * _e30) - rt::Scalar(1f32)).select(rt::Scalar(1f32), rt::Scalar(pixel_32.side).elementwise_gt(rt::Scalar(0f32)));
        }
        let _e43 = self.v_ordered_weights(pixel_32.shell, _e4);
        let _e44 = self.v_lift_of(pixel_32.shell.lift, _e43);
        let lifted_1 = (_e44 * (lift_1 * rt::Scalar(pixel_32.side)));
        let _e50 = height_3;
        let _e51 = self.v_traced_scale_m();
        return <rt::Vec4<f32>>::new_31((quadric_2 * rt::Scalar(pixel_32.side)), (_e50 - (lifted_1 / _e51)));
    }
    pub(crate) fn surface_quadric_vertical_enter(
        &self,
        pixel_33: PixelIn,
        params_36: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_quadric_vertical_enter(pixel_33, rt::into(params_36)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_quadric_vertical_enter(
        &self,
        pixel_33: PixelIn,
        params_36: rt::Vec4<f32>,
    ) -> Entered {
        let mut at_45: Entered;

        let _e2 = self.v_surface_plane_enter(pixel_33, params_36);
        at_45 = _e2;
        let _e6 = at_45.point;
        let _e8 = self.v_quadric_of(pixel_33, _e6, params_36.y());
        at_45.of_surface = _e8;
        let _e11 = at_45.metric.x();
        let _e14 = at_45.metric.z();
        let _e18 = at_45.metric.y();
        let _e21 = at_45.metric.y();
        let area_4 = ((_e11 * _e14) - (_e18 * _e21));
        rt::Scalar(at_45.segments) = rt::Scalar(0u32).select(rt::Scalar(1u32), area_4.elementwise_gt(rt::Scalar(0f32)));
        let _e30 = at_45;
        return _e30;
    }
    pub(crate) fn surface_quadric_perpendicular_enter(
        &self,
        pixel_34: PixelIn,
        params_37: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_quadric_perpendicular_enter(pixel_34, rt::into(params_37)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_quadric_perpendicular_enter(
        &self,
        pixel_34: PixelIn,
        params_37: rt::Vec4<f32>,
    ) -> Entered {
        let mut at_46: Entered;

        let _e2 = self.v_surface_quadric_vertical_enter(pixel_34, params_37);
        at_46 = _e2;
        let along_27 = pixel_34.direction.length();
        let _e6 = at_46;
        let _e10 = self.v_across_of(_e6, (pixel_34.direction / rt::Vec3::splat_from_scalar(along_27)));
        let _e11 = self.v_plane_normal(pixel_34);
        let _e12 = self.v_plane_distance(pixel_34, _e11);
        let eye_2 = (rt::Scalar(0f32) - (_e12 * along_27));
        let _e17 = at_46;
        let _e18 = self.v_across_span(_e17, _e10, eye_2);
        at_46.span = _e18;
        let _e22 = rt::Scalar(at_46.segments);
        let _e28 = at_46.span.y();
        let _e31 = at_46.span.x();
        rt::Scalar(at_46.segments) = rt::Scalar(0u32).select((_e22 * params_37.z().to_u32()), _e28.elementwise_gt(_e31));
        let _e34 = at_46;
        return _e34;
    }
    pub(crate) fn moved_out(
        &self,
        corner_1: Corner,
        side_1: impl rt::Into<rt::Scalar<f32>>,
        offset_4: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_moved_out(corner_1, rt::into(side_1), rt::into(offset_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_moved_out(
        &self,
        corner_1: Corner,
        side_1: rt::Scalar<f32>,
        offset_4: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        return (corner_1.position + (corner_1.normal * (side_1 * offset_4)));
    }
    pub(crate) fn raised(
        &self,
        corner_2: Corner,
        side_2: impl rt::Into<rt::Scalar<f32>>,
        height_4: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_raised(corner_2, rt::into(side_2), rt::into(height_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_raised(
        &self,
        corner_2: Corner,
        side_2: rt::Scalar<f32>,
        height_4: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let shell_5 = self.surface_settings.shell_m;
        let _e14 = self.v_moved_out(corner_2, side_2, (shell_5.x() + ((shell_5.y() - shell_5.x()).min(rt::Scalar(300000000000000000000000000000000000000f32)) * height_4)));
        return _e14;
    }
    pub(crate) fn tetrahedron(
        &self,
        pixel_35: PixelIn,
        along_13: impl rt::Into<rt::Vec3<f32>>,
        middle_5: impl rt::Into<rt::Scalar<f32>>,
        number_14: impl rt::Into<rt::Scalar<u32>>,
    ) -> Tetrahedron {
        rt::into(self.v_tetrahedron(pixel_35, rt::into(along_13), rt::into(middle_5), rt::into(number_14)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_tetrahedron(
        &self,
        pixel_35: PixelIn,
        along_13: rt::Vec3<f32>,
        middle_5: rt::Scalar<f32>,
        number_14: rt::Scalar<u32>,
    ) -> Tetrahedron {
        let mut inside_1: rt::Vec2<f32>;
        let mut local_46: rt::Scalar<bool>;

        let origin_6 = (pixel_35.origin + (along_13 * middle_5));
        let is_first_2 = number_14.elementwise_eq(rt::Scalar(0u32));
        let is_last_1 = number_14.elementwise_eq(rt::Scalar(2u32));
        let _e12 = self.v_ordered(pixel_35, rt::Scalar(0u32));
        let _e15 = self.v_raised(_e12, rt::Scalar(pixel_35.side), rt::Scalar(0f32));
        let q0_ = (_e15 - origin_6);
        let _e20 = self.v_ordered(pixel_35, rt::Scalar(1u32).select(rt::Scalar(0u32), is_last_1));
        let _e25 = self.v_raised(_e20, rt::Scalar(pixel_35.side), rt::Scalar(0f32).select(rt::Scalar(1f32), is_last_1));
        let q1_ = (_e25 - origin_6);
        let _e30 = self.v_ordered(pixel_35, rt::Scalar(1u32).select(rt::Scalar(2u32), is_first_2));
        let _e35 = self.v_raised(_e30, rt::Scalar(pixel_35.side), rt::Scalar(1f32).select(rt::Scalar(0f32), is_first_2));
        let q2_ = (_e35 - origin_6);
        let _e38 = self.v_ordered(pixel_35, rt::Scalar(2u32));
        let _e41 = self.v_raised(_e38, rt::Scalar(pixel_35.side), rt::Scalar(1f32));
        let q3_ = (_e41 - origin_6);
        let e1_ = (q1_ - q0_);
        let e2_ = (q2_ - q0_);
        let e3_ = (q3_ - q0_);
        let n1_ = e2_.cross(e3_);
        let n2_ = e3_.cross(e1_);
        let n3_ = e1_.cross(e2_);
        let n0_ = (e2_ - e1_).cross((e3_ - e1_));
        let volume_1 = e1_.dot(n1_);
        let w1_ = ((rt::Scalar(0f32) - q0_.dot(n1_)) / volume_1);
        let w2_ = ((rt::Scalar(0f32) - q0_.dot(n2_)) / volume_1);
        let w3_ = ((rt::Scalar(0f32) - q0_.dot(n3_)) / volume_1);
        let w0_ = (q1_.dot(n0_) / volume_1);
        let g1_ = (along_13.dot(n1_) / volume_1);
        let g2_ = (along_13.dot(n2_) / volume_1);
        let g3_ = (along_13.dot(n3_) / volume_1);
        let g0_ = (rt::Scalar(0f32) - (along_13.dot(n0_) / volume_1));
        let _e77 = self.v_shell_slack(pixel_35, middle_5);
        let slack_5 = (_e77 / volume_1.abs());
        inside_1 = <rt::Vec2<f32>>::from_scalars((rt::Scalar(0f32) - middle_5), rt::Scalar(300000000000000000000000000000000000000f32));
        let _e85 = inside_1;
        let _e88 = self.v_where_positive(_e85, w0_, g0_, (slack_5 * n0_.length()));
        inside_1 = _e88;
        let _e89 = inside_1;
        let _e92 = self.v_where_positive(_e89, w1_, g1_, (slack_5 * n1_.length()));
        inside_1 = _e92;
        let _e93 = inside_1;
        let _e96 = self.v_where_positive(_e93, w2_, g2_, (slack_5 * n2_.length()));
        inside_1 = _e96;
        let _e97 = inside_1;
        let _e100 = self.v_where_positive(_e97, w3_, g3_, (slack_5 * n3_.length()));
        inside_1 = _e100;
        if rt::Scalar::into_branch_condition((!(!volume_1.abs().elementwise_gt(rt::Scalar(0f32))))) {
            let _e109 = inside_1.y();
            local_46 = (!_e109.elementwise_lt(rt::Scalar(300000000000000000000000000000000000000f32)));
        } else {
            local_46 = rt::Scalar(true);
        }
        let _e114 = local_46;
        if rt::Scalar::into_branch_condition(_e114) {
            inside_1 = <rt::Vec2<f32>>::from_scalars(rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(-300000000000000000000000000000000000000f32));
        }
        if rt::Scalar::into_branch_condition(is_first_2) {
            let _e118 = inside_1;
            return <Tetrahedron>::new(_e118, <rt::Vec4<f32>>::from_scalars(w0_, w1_, (w2_ + w3_), w3_), <rt::Vec4<f32>>::from_scalars(g0_, g1_, (g2_ + g3_), g3_));
        }
        if rt::Scalar::into_branch_condition(is_last_1) {
            let upper_4 = <rt::Vec2<f32>>::from_scalars(((w1_ + w2_) + w3_), ((g1_ + g2_) + g3_));
            let _e129 = inside_1;
            return <Tetrahedron>::new(_e129, <rt::Vec4<f32>>::from_scalars((w0_ + w1_), w2_, w3_, upper_4.x()), <rt::Vec4<f32>>::from_scalars((g0_ + g1_), g2_, g3_, upper_4.y()));
        }
        let _e137 = inside_1;
        return <Tetrahedron>::new(_e137, <rt::Vec4<f32>>::from_scalars(w0_, (w1_ + w2_), w3_, (w2_ + w3_)), <rt::Vec4<f32>>::from_scalars(g0_, (g1_ + g2_), g3_, (g2_ + g3_)));
    }
    pub(crate) fn is_met(
        &self,
        pixel_36: PixelIn,
        along_14: impl rt::Into<rt::Vec3<f32>>,
        middle_6: impl rt::Into<rt::Scalar<f32>>,
        number_15: impl rt::Into<rt::Scalar<u32>>,
    ) -> bool {
        rt::into(self.v_is_met(pixel_36, rt::into(along_14), rt::into(middle_6), rt::into(number_15)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_is_met(
        &self,
        pixel_36: PixelIn,
        along_14: rt::Vec3<f32>,
        middle_6: rt::Scalar<f32>,
        number_15: rt::Scalar<u32>,
    ) -> rt::Scalar<bool> {
        let _e4 = self.v_tetrahedron(pixel_36, along_14, middle_6, number_15);
        let inside_4 = _e4.inside;
        return inside_4.y().elementwise_gt(inside_4.x());
    }
    pub(crate) fn surface_tetrahedra_enter(
        &self,
        pixel_37: PixelIn,
        params_38: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_tetrahedra_enter(pixel_37, rt::into(params_38)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_tetrahedra_enter(
        &self,
        pixel_37: PixelIn,
        params_38: rt::Vec4<f32>,
    ) -> Entered {
        let mut local_47: rt::Scalar<bool>;
        let mut local_48: rt::Scalar<bool>;
        let mut at_47: Entered;

        let along_28 = pixel_37.direction.normalize();
        let _e4 = self.v_middle_of(pixel_37, along_28);
        let _e6 = self.v_is_met(pixel_37, along_28, _e4, rt::Scalar(0u32));
        if rt::Scalar::into_branch_condition((!_e6)) {
            let _e11 = self.v_is_met(pixel_37, along_28, _e4, rt::Scalar(1u32));
            local_47 = (!_e11);
        } else {
            local_47 = rt::Scalar(false);
        }
        let _e14 = local_47;
        if rt::Scalar::into_branch_condition(_e14) {
            let _e18 = self.v_is_met(pixel_37, along_28, _e4, rt::Scalar(2u32));
            local_48 = (!_e18);
        } else {
            local_48 = rt::Scalar(false);
        }
        let is_passed_by = local_48;
        if rt::Scalar::into_branch_condition(is_passed_by) {
            let _e22 = self.v_passed_by();
            return _e22;
        }
        let _e23 = self.v_shell_middle(pixel_37, along_28);
        at_47 = _e23;
        rt::Scalar(at_47.segments) = rt::Scalar(3u32);
        let _e27 = at_47;
        return _e27;
    }
    pub(crate) fn triangle_distance(
        &self,
        pixel_38: PixelIn,
        normal_19: impl rt::Into<rt::Vec3<f32>>,
    ) -> f32 {
        rt::into(self.v_triangle_distance(pixel_38, rt::into(normal_19)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_triangle_distance(
        &self,
        pixel_38: PixelIn,
        normal_19: rt::Vec3<f32>,
    ) -> rt::Scalar<f32> {
        let a_37 = (pixel_38.a.position - pixel_38.origin);
        let b_37 = (pixel_38.b.position - pixel_38.origin);
        let c_27 = (pixel_38.c.position - pixel_38.origin);
        let along_29 = (pixel_38.direction / rt::Vec3::splat_from_scalar(pixel_38.direction.dot(pixel_38.direction)));
        let places_1 = <rt::Vec3<f32>>::from_scalars(a_37.dot(along_29), b_37.dot(along_29), c_27.dot(along_29));
        let least_8 = places_1.x().min(places_1.y()).min(places_1.z());
        let most_14 = places_1.x().max(places_1.y()).max(places_1.z());
        let across_7 = normal_19.dot(pixel_38.direction);
        if rt::Scalar::into_branch_condition(across_7.elementwise_eq(rt::Scalar(0f32))) {
            return least_8;
        }
        return (normal_19.dot(a_37) / across_7).clamp(least_8, most_14);
    }
    pub(crate) fn triangle_weights(
        &self,
        pixel_39: PixelIn,
        normal_20: impl rt::Into<rt::Vec3<f32>>,
        point_14: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_triangle_weights(pixel_39, rt::into(normal_20), rt::into(point_14)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_triangle_weights(
        &self,
        pixel_39: PixelIn,
        normal_20: rt::Vec3<f32>,
        point_14: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let _e3 = self.v_plane_weights(pixel_39, normal_20, point_14);
        let inside_5 = _e3.max(<rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32)));
        return (inside_5 / rt::Vec3::splat_from_scalar(((inside_5.x() + inside_5.y()) + inside_5.z())));
    }
    pub(crate) fn is_on_map(&self, uv_16: impl rt::Into<rt::Vec2<f32>>) -> bool {
        rt::into(self.v_is_on_map(rt::into(uv_16)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_is_on_map(&self, uv_16: rt::Vec2<f32>) -> rt::Scalar<bool> {
        let mut local_49: rt::Scalar<bool>;

        let beyond_4 = ((uv_16.x() - rt::Scalar(0.5f32)).abs().max((uv_16.y() - rt::Scalar(0.5f32)).abs()) - rt::Scalar(0.5f32));
        let _e14 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition((!_e14.elementwise_ne(WRAP_CLAMP))) {
            local_49 = beyond_4.elementwise_le(rt::Scalar(0.000001f32));
        } else {
            local_49 = rt::Scalar(true);
        }
        let _e23 = local_49;
        return _e23;
    }
    pub(crate) fn surface_facets_enter(
        &self,
        pixel_40: PixelIn,
        params_39: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_facets_enter(pixel_40, rt::into(params_39)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_facets_enter(
        &self,
        pixel_40: PixelIn,
        params_39: rt::Vec4<f32>,
    ) -> Entered {
        let mut local_50: rt::Scalar<bool>;

        let _e2 = self.v_plane_normal(pixel_40);
        let _e5 = self.v_triangle_distance(pixel_40, _e2);
        let point_30 = (pixel_40.origin + (pixel_40.direction * _e5));
        let _e8 = self.v_triangle_weights(pixel_40, _e2, point_30);
        let uv_42 = (((pixel_40.a.uv * _e8.x()) + (pixel_40.b.uv * _e8.y())) + (pixel_40.c.uv * _e8.z()));
        let tangent_3 = (((pixel_40.a.tangent * _e8.x()) + (pixel_40.b.tangent * _e8.y())) + (pixel_40.c.tangent * _e8.z()));
        let bitangent_2 = (((pixel_40.a.bitangent * _e8.x()) + (pixel_40.b.bitangent * _e8.y())) + (pixel_40.c.bitangent * _e8.z()));
        let sum_13 = ((((pixel_40.a.normal * _e8.x()) + (pixel_40.b.normal * _e8.y())) + (pixel_40.c.normal * _e8.z())) * rt::Scalar(pixel_40.side));
        let tt_1 = tangent_3.dot(tangent_3);
        let tb_1 = tangent_3.dot(bitangent_2);
        let bb_1 = bitangent_2.dot(bitangent_2);
        if rt::Scalar::into_branch_condition(_e2.dot(_e2).elementwise_gt(rt::Scalar(0f32))) {
            let _e77 = self.v_is_on_map(uv_42);
            local_50 = _e77;
        } else {
            local_50 = rt::Scalar(false);
        }
        let _e79 = local_50;
        let _e84 = rt::Scalar(self.surface_settings.scale_m);
        return <Entered>::new(rt::Scalar(0u32).select(rt::Scalar(1u32), _e79), point_30, uv_42, tangent_3, bitangent_2, sum_13.normalize(), <rt::Vec4<f32>>::from_scalars(tt_1, tb_1, bb_1, _e84), rt::Scalar(0u32), _e2, <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)), <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32)), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
    }
    pub(crate) fn surface_slices_enter(
        &self,
        pixel_41: PixelIn,
        params_40: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_slices_enter(pixel_41, rt::into(params_40)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_slices_enter(
        &self,
        pixel_41: PixelIn,
        params_40: rt::Vec4<f32>,
    ) -> Entered {
        let mut local_51: rt::Scalar<bool>;
        let mut local_52: rt::Scalar<bool>;
        let mut local_53: rt::Scalar<bool>;

        let _e2 = self.v_plane_normal(pixel_41);
        let _e5 = self.v_triangle_distance(pixel_41, _e2);
        let point_31 = (pixel_41.origin + (pixel_41.direction * _e5));
        let _e8 = self.v_triangle_weights(pixel_41, _e2, point_31);
        let uv_43 = (((pixel_41.a.uv * _e8.x()) + (pixel_41.b.uv * _e8.y())) + (pixel_41.c.uv * _e8.z()));
        let tangent_4 = (((pixel_41.a.tangent * _e8.x()) + (pixel_41.b.tangent * _e8.y())) + (pixel_41.c.tangent * _e8.z()));
        let bitangent_3 = (((pixel_41.a.bitangent * _e8.x()) + (pixel_41.b.bitangent * _e8.y())) + (pixel_41.c.bitangent * _e8.z()));
        let raw_ = (((pixel_41.a.normal * _e8.x()) + (pixel_41.b.normal * _e8.y())) + (pixel_41.c.normal * _e8.z()));
        let slice_8 = (((pixel_41.a.of_surface * _e8.x()) + (pixel_41.b.of_surface * _e8.y())) + (pixel_41.c.of_surface * _e8.z()));
        let tt_2 = tangent_4.dot(tangent_4);
        let tb_2 = tangent_4.dot(bitangent_3);
        let bb_2 = bitangent_3.dot(bitangent_3);
        let area_5 = ((tt_2 * bb_2) - (tb_2 * tb_2));
        let _e87 = rt::Scalar(self.surface_settings.bias_m);
        let _e90 = rt::Scalar(self.surface_settings.scale_m);
        let height_m = (_e87 + (_e90 * slice_8.x()));
        let normal_35 = raw_.normalize();
        let _e95 = self.v_is_on_map(uv_43);
        if rt::Scalar::into_branch_condition(_e95) {
            local_51 = ((slice_8.x() - rt::Scalar(0.5f32)).abs() - rt::Scalar(0.5f32)).elementwise_le(rt::Scalar(0.000001f32));
        } else {
            local_51 = rt::Scalar(false);
        }
        let is_within = local_51;
        if rt::Scalar::into_branch_condition(_e2.dot(_e2).elementwise_gt(rt::Scalar(0f32))) {
            local_52 = area_5.elementwise_gt(rt::Scalar(0f32));
        } else {
            local_52 = rt::Scalar(false);
        }
        let _e118 = local_52;
        if rt::Scalar::into_branch_condition(_e118) {
            local_53 = is_within;
        } else {
            local_53 = rt::Scalar(false);
        }
        let _e122 = local_53;
        let _e128 = rt::Scalar(self.surface_settings.scale_m);
        return <Entered>::new(rt::Scalar(0u32).select(rt::Scalar(1u32), _e122), (point_31 - (raw_ * height_m)), uv_43, tangent_4, bitangent_3, normal_35, <rt::Vec4<f32>>::from_scalars(tt_2, tb_2, bb_2, _e128), rt::Scalar(0u32), normal_35, <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)), <rt::Vec4<f32>>::new_31(slice_8, rt::Scalar(0f32)), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
    }
    pub(crate) fn surface_object_enter(
        &self,
        pixel_42: PixelIn,
        params_41: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_object_enter(pixel_42, rt::into(params_41)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_object_enter(
        &self,
        pixel_42: PixelIn,
        params_41: rt::Vec4<f32>,
    ) -> Entered {
        let mut at_48: Entered;

        let _e2 = self.v_passed_by();
        at_48 = _e2;
        let _e7 = rt::Scalar(self.surface_settings.solids);
        rt::Scalar(at_48.segments) = _e7;
        at_48.point = pixel_42.origin;
        let _e10 = at_48;
        return _e10;
    }
    pub(crate) fn surface_frames_enter(
        &self,
        pixel_43: PixelIn,
        params_42: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_frames_enter(pixel_43, rt::into(params_42)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_frames_enter(
        &self,
        pixel_43: PixelIn,
        params_42: rt::Vec4<f32>,
    ) -> Entered {
        let mut at_49: Entered;

        let _e2 = self.v_passed_by();
        at_49 = _e2;
        rt::Scalar(at_49.segments) = FRAMES;
        at_49.point = pixel_43.origin;
        let _e8 = at_49;
        return _e8;
    }
    pub(crate) fn surface_object_slices_enter(
        &self,
        pixel_44: PixelIn,
        params_43: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_object_slices_enter(pixel_44, rt::into(params_43)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_object_slices_enter(
        &self,
        pixel_44: PixelIn,
        params_43: rt::Vec4<f32>,
    ) -> Entered {
        let mut at_50: Entered;

        let _e2 = self.v_plane_normal(pixel_44);
        let _e3 = self.v_passed_by();
        at_50 = _e3;
        rt::Scalar(at_50.segments) = rt::Scalar(0u32).select(rt::Scalar(1u32), _e2.dot(_e2).elementwise_gt(rt::Scalar(0f32)));
        let _e15 = self.v_triangle_distance(pixel_44, _e2);
        at_50.point = (pixel_44.origin + (pixel_44.direction * _e15));
        at_50.normal = (_e2.normalize() * rt::Scalar(1f32).select(rt::Scalar(-1f32), _e2.dot(pixel_44.direction).elementwise_gt(rt::Scalar(0f32))));
        let _e28 = at_50;
        return _e28;
    }
    pub(crate) fn surface_enter_stage(&self, pixel_45: PixelIn) -> Entered {
        rt::into(self.v_surface_enter_stage(pixel_45))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_enter_stage(&self, pixel_45: PixelIn) -> Entered {
        let _e5 = rt::Scalar(self.surface_settings.choices[1usize].number);
        match rt::Scalar::into_inner(_e5) {
            0u32 => {
                let _e10 = self.surface_settings.choices[1usize].params;
                let _e11 = self.v_surface_plane_enter(pixel_45, _e10);
                return _e11;
            }
            1u32 => {
                let _e16 = self.surface_settings.choices[1usize].params;
                let _e17 = self.v_surface_prism_enter(pixel_45, _e16);
                return _e17;
            }
            2u32 => {
                let _e22 = self.surface_settings.choices[1usize].params;
                let _e23 = self.v_surface_quadric_perpendicular_enter(pixel_45, _e22);
                return _e23;
            }
            3u32 => {
                let _e28 = self.surface_settings.choices[1usize].params;
                let _e29 = self.v_surface_quadric_vertical_enter(pixel_45, _e28);
                return _e29;
            }
            4u32 => {
                let _e34 = self.surface_settings.choices[1usize].params;
                let _e35 = self.v_surface_tetrahedra_enter(pixel_45, _e34);
                return _e35;
            }
            5u32 => {
                let _e40 = self.surface_settings.choices[1usize].params;
                let _e41 = self.v_surface_facets_enter(pixel_45, _e40);
                return _e41;
            }
            6u32 => {
                let _e46 = self.surface_settings.choices[1usize].params;
                let _e47 = self.v_surface_slices_enter(pixel_45, _e46);
                return _e47;
            }
            7u32 => {
                let _e52 = self.surface_settings.choices[1usize].params;
                let _e53 = self.v_surface_object_enter(pixel_45, _e52);
                return _e53;
            }
            8u32 => {
                let _e58 = self.surface_settings.choices[1usize].params;
                let _e59 = self.v_surface_frames_enter(pixel_45, _e58);
                return _e59;
            }
            _ => {
                let _e64 = self.surface_settings.choices[1usize].params;
                let _e65 = self.v_surface_object_slices_enter(pixel_45, _e64);
                return _e65;
            }
        }
    }
    pub(crate) fn enter_relief(&self, pixel_46: PixelIn) -> Entered {
        rt::into(self.v_enter_relief(pixel_46))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_enter_relief(&self, pixel_46: PixelIn) -> Entered {
        let mut at_51: Entered;

        let _e1 = self.v_surface_enter_stage(pixel_46);
        at_51 = _e1;
        let _e4 = rt::Scalar(at_51.segments);
        if rt::Scalar::into_branch_condition(_e4.elementwise_eq(rt::Scalar(0u32))) {
            let _e7 = at_51;
            return _e7;
        }
        let _e8 = at_51;
        let _e9 = self.v_detail_stage(pixel_46, _e8);
        rt::Scalar(at_51.level) = rt::Scalar(_e9.level);
        rt::Scalar(at_51.footprint) = rt::Scalar(_e9.footprint);
        rt::Scalar(at_51.fade) = rt::Scalar(_e9.fade);
        let _e16 = at_51;
        return _e16;
    }
    pub(crate) fn entered_once(
        &self,
        path_31: Path,
        grid_7: Grid,
        above_1: impl rt::Into<rt::Scalar<f32>>,
        below_1: impl rt::Into<rt::Scalar<f32>>,
        above_gap: impl rt::Into<rt::Scalar<f32>>,
        below_gap: impl rt::Into<rt::Scalar<f32>>,
        so_far: impl rt::Into<rt::Vec3<u32>>,
    ) -> SearchResult {
        rt::into(self.v_entered_once(path_31, grid_7, rt::into(above_1), rt::into(below_1), rt::into(above_gap), rt::into(below_gap), rt::into(so_far)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_entered_once(
        &self,
        path_31: Path,
        grid_7: Grid,
        above_1: rt::Scalar<f32>,
        below_1: rt::Scalar<f32>,
        above_gap: rt::Scalar<f32>,
        below_gap: rt::Scalar<f32>,
        so_far: rt::Vec3<u32>,
    ) -> SearchResult {
        let mut near_1: rt::Scalar<f32>;
        let mut far_1: rt::Scalar<f32>;
        let mut near_gap: rt::Scalar<f32>;
        let mut far_gap: rt::Scalar<f32>;
        let mut cost_1: rt::Vec3<u32>;
        let mut local_54: rt::Scalar<bool>;

        near_1 = above_1;
        far_1 = below_1;
        near_gap = above_gap;
        far_gap = below_gap;
        cost_1 = so_far;
        let wide_1 = (grid_7.step.x().abs() + grid_7.step.y().abs());
        'naga_break: loop {
            'naga_continue: {
                let _e19 = far_1;
                let _e20 = near_1;
                if rt::Scalar::into_branch_condition((wide_1 * (_e19 - _e20)).elementwise_gt(rt::Scalar(3f32))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e25 = cost_1;
                    cost_1 = (_e25 + STEP);
                    let _e28 = near_1;
                    let _e29 = far_1;
                    let middle_12 = (rt::Scalar(0.5f32) * (_e28 + _e29));
                    let _e33 = near_1;
                    if rt::Scalar::into_branch_condition(middle_12.elementwise_gt(_e33)) {
                        let _e37 = far_1;
                        local_54 = middle_12.elementwise_lt(_e37);
                    } else {
                        local_54 = rt::Scalar(false);
                    }
                    let _e40 = local_54;
                    if rt::Scalar::into_branch_condition((!_e40)) {
                        break 'naga_break;
                    }
                    let _e42 = self.v_path_gap(path_31, middle_12);
                    let _e43 = cost_1;
                    cost_1 = (_e43 + HEIGHTS_READ);
                    if rt::Scalar::into_branch_condition(_e42.elementwise_le(rt::Scalar(0f32))) {
                        far_1 = middle_12;
                        far_gap = _e42;
                    } else {
                        near_1 = middle_12;
                        near_gap = _e42;
                    }
                }
            }
        }
        let _e49 = near_1;
        let _e50 = far_1;
        let _e51 = near_gap;
        let _e52 = far_gap;
        let _e53 = cost_1;
        return <SearchResult>::new(FOUND_BRACKET, _e49, _e50, _e51, _e52, _e53);
    }
    pub(crate) fn quartic_slope(
        &self,
        q_1: Quartic,
        x_2: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_quartic_slope(q_1, rt::into(x_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_quartic_slope(
        &self,
        q_1: Quartic,
        x_2: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        return (rt::Scalar(q_1.b) + (x_2 * ((rt::Scalar(2f32) * rt::Scalar(q_1.c)) + (x_2 * ((rt::Scalar(3f32) * rt::Scalar(q_1.d)) + (x_2 * (rt::Scalar(4f32) * rt::Scalar(q_1.e))))))));
    }
    pub(crate) fn extremum_between(
        &self,
        q_2: Quartic,
        from_x: impl rt::Into<rt::Scalar<f32>>,
        to_x: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_extremum_between(q_2, rt::into(from_x), rt::into(to_x)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_extremum_between(
        &self,
        q_2: Quartic,
        from_x: rt::Scalar<f32>,
        to_x: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let mut low: rt::Scalar<f32>;
        let mut high: rt::Scalar<f32>;
        let mut k_7: rt::Scalar<u32> = rt::Scalar(0u32);

        low = from_x;
        high = to_x;
        let _e5 = self.v_quartic_slope(q_2, from_x);
        let rises_3 = _e5.elementwise_gt(rt::Scalar(0f32));
        'naga_break: loop {
            'naga_continue: {
                let _e10 = k_7;
                if rt::Scalar::into_branch_condition(_e10.elementwise_lt(HALVINGS)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e13 = low;
                    let _e14 = high;
                    let middle_13 = (rt::Scalar(0.5f32) * (_e13 + _e14));
                    let _e18 = self.v_quartic_slope(q_2, middle_13);
                    if rt::Scalar::into_branch_condition(_e18.elementwise_gt(rt::Scalar(0f32)).elementwise_eq(rises_3)) {
                        low = middle_13;
                    } else {
                        high = middle_13;
                    }
                    let _e22 = k_7;
                    k_7 = (_e22 + rt::Scalar(1u32));
                }
            }
        }
        let _e25 = high;
        return _e25;
    }
    pub(crate) fn facing_four(
        &self,
        middle_7: impl rt::Into<rt::Scalar<f32>>,
        along_15: impl rt::Into<rt::Scalar<f32>>,
        across: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_facing_four(rt::into(middle_7), rt::into(along_15), rt::into(across)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_facing_four(
        &self,
        middle_7: rt::Scalar<f32>,
        along_15: rt::Scalar<f32>,
        across: rt::Scalar<f32>,
    ) -> rt::Vec4<f32> {
        let x_11 = (along_15 * rt::Scalar(1.7320508f32));
        let y_6 = (across * rt::Scalar(1.7320508f32));
        return <rt::Vec4<f32>>::from_scalars((middle_7 + x_11), (middle_7 - x_11), (middle_7 + y_6), (middle_7 - y_6)).max(<rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32)));
    }
    pub(crate) fn least_at(
        &self,
        c_10: impl rt::Into<rt::Vec3<f32>>,
        span_3: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_least_at(rt::into(c_10), rt::into(span_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_least_at(
        &self,
        c_10: rt::Vec3<f32>,
        span_3: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        if rt::Scalar::into_branch_condition(c_10.z().elementwise_gt(rt::Scalar(0f32))) {
            return ((rt::Scalar(0f32) - c_10.y()) / (rt::Scalar(2f32) * c_10.z())).clamp(rt::Scalar(0f32), span_3);
        }
        return span_3;
    }
    pub(crate) fn falls_in_cell(
        &self,
        c_11: impl rt::Into<rt::Vec3<f32>>,
        span_4: impl rt::Into<rt::Scalar<f32>>,
    ) -> bool {
        rt::into(self.v_falls_in_cell(rt::into(c_11), rt::into(span_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_falls_in_cell(
        &self,
        c_11: rt::Vec3<f32>,
        span_4: rt::Scalar<f32>,
    ) -> rt::Scalar<bool> {
        let mut local_55: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition((!c_11.x().elementwise_le(rt::Scalar(0f32)))) {
            let _e8 = self.v_least_at(c_11, span_4);
            let _e9 = self.v_quadratic(c_11, _e8);
            local_55 = _e9.elementwise_le(rt::Scalar(0f32));
        } else {
            local_55 = rt::Scalar(true);
        }
        let _e13 = local_55;
        return _e13;
    }
    pub(crate) fn field_heights_cost(
        &self,
        level_38: impl rt::Into<rt::Scalar<u32>>,
        params_44: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<u32> {
        rt::into(self.v_field_heights_cost(rt::into(level_38), rt::into(params_44)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_heights_cost(
        &self,
        level_38: rt::Scalar<u32>,
        params_44: rt::Vec4<f32>,
    ) -> rt::Vec3<u32> {
        return HEIGHTS_READ;
    }
    pub(crate) fn field_volume_cost(
        &self,
        level_39: impl rt::Into<rt::Scalar<u32>>,
        params_45: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<u32> {
        rt::into(self.v_field_volume_cost(rt::into(level_39), rt::into(params_45)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_volume_cost(
        &self,
        level_39: rt::Scalar<u32>,
        params_45: rt::Vec4<f32>,
    ) -> rt::Vec3<u32> {
        return VOXELS_READ;
    }
    pub(crate) fn field_motif_cost(
        &self,
        level_40: impl rt::Into<rt::Scalar<u32>>,
        params_46: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<u32> {
        rt::into(self.v_field_motif_cost(rt::into(level_40), rt::into(params_46)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_motif_cost(
        &self,
        level_40: rt::Scalar<u32>,
        params_46: rt::Vec4<f32>,
    ) -> rt::Vec3<u32> {
        return NO_COST;
    }
    pub(crate) fn field_cost_stage(&self, level_41: impl rt::Into<rt::Scalar<u32>>) -> rt::Vec3<u32> {
        rt::into(self.v_field_cost_stage(rt::into(level_41)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_field_cost_stage(&self, level_41: rt::Scalar<u32>) -> rt::Vec3<u32> {
        let _e5 = rt::Scalar(self.surface_settings.choices[4usize].number);
        match rt::Scalar::into_inner(_e5) {
            0u32 => {
                let _e10 = self.surface_settings.choices[4usize].params;
                let _e11 = self.v_field_heights_cost(level_41, _e10);
                return _e11;
            }
            1u32 => {
                let _e16 = self.surface_settings.choices[4usize].params;
                let _e17 = self.v_field_volume_cost(level_41, _e16);
                return _e17;
            }
            _ => {
                let _e22 = self.surface_settings.choices[4usize].params;
                let _e23 = self.v_field_motif_cost(level_41, _e22);
                return _e23;
            }
        }
    }
    pub(crate) fn field_heights_height(
        &self,
        uv_17: impl rt::Into<rt::Vec2<f32>>,
        height_5: impl rt::Into<rt::Scalar<f32>>,
        level_42: impl rt::Into<rt::Scalar<u32>>,
        params_47: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_field_heights_height(rt::into(uv_17), rt::into(height_5), rt::into(level_42), rt::into(params_47)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_heights_height(
        &self,
        uv_17: rt::Vec2<f32>,
        height_5: rt::Scalar<f32>,
        level_42: rt::Scalar<u32>,
        params_47: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        let _e4 = self.v_height_at(uv_17, level_42);
        return _e4;
    }
    pub(crate) fn field_volume_height(
        &self,
        uv_18: impl rt::Into<rt::Vec2<f32>>,
        height_6: impl rt::Into<rt::Scalar<f32>>,
        level_43: impl rt::Into<rt::Scalar<u32>>,
        params_48: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_field_volume_height(rt::into(uv_18), rt::into(height_6), rt::into(level_43), rt::into(params_48)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_volume_height(
        &self,
        uv_18: rt::Vec2<f32>,
        height_6: rt::Scalar<f32>,
        level_43: rt::Scalar<u32>,
        params_48: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        return height_6;
    }
    pub(crate) fn field_motif_height(
        &self,
        uv_19: impl rt::Into<rt::Vec2<f32>>,
        height_7: impl rt::Into<rt::Scalar<f32>>,
        level_44: impl rt::Into<rt::Scalar<u32>>,
        params_49: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_field_motif_height(rt::into(uv_19), rt::into(height_7), rt::into(level_44), rt::into(params_49)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_motif_height(
        &self,
        uv_19: rt::Vec2<f32>,
        height_7: rt::Scalar<f32>,
        level_44: rt::Scalar<u32>,
        params_49: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        return height_7;
    }
    pub(crate) fn field_height_stage(
        &self,
        uv_20: impl rt::Into<rt::Vec2<f32>>,
        height_8: impl rt::Into<rt::Scalar<f32>>,
        level_45: impl rt::Into<rt::Scalar<u32>>,
    ) -> f32 {
        rt::into(self.v_field_height_stage(rt::into(uv_20), rt::into(height_8), rt::into(level_45)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_field_height_stage(
        &self,
        uv_20: rt::Vec2<f32>,
        height_8: rt::Scalar<f32>,
        level_45: rt::Scalar<u32>,
    ) -> rt::Scalar<f32> {
        let _e7 = rt::Scalar(self.surface_settings.choices[4usize].number);
        match rt::Scalar::into_inner(_e7) {
            0u32 => {
                let _e12 = self.surface_settings.choices[4usize].params;
                let _e13 = self.v_field_heights_height(uv_20, height_8, level_45, _e12);
                return _e13;
            }
            1u32 => {
                let _e18 = self.surface_settings.choices[4usize].params;
                let _e19 = self.v_field_volume_height(uv_20, height_8, level_45, _e18);
                return _e19;
            }
            _ => {
                let _e24 = self.surface_settings.choices[4usize].params;
                let _e25 = self.v_field_motif_height(uv_20, height_8, level_45, _e24);
                return _e25;
            }
        }
    }
    pub(crate) fn from_hit(&self, at_52: Entered, hit_10: Hit, light_1: Toward) -> Path {
        rt::into(self.v_from_hit(at_52, hit_10, light_1))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_from_hit(&self, at_52: Entered, hit_10: Hit, light_1: Toward) -> Path {
        let _e4 = self.v_climb(at_52, light_1.direction);
        let _e6 = self.v_near_uv(hit_10.uv);
        let _e8 = self.v_height_at(_e6, rt::Scalar(at_52.level));
        let h_7 = <rt::Vec3<f32>>::from_scalars(_e8, _e4.z(), rt::Scalar(0f32));
        return <Path>::new(_e6, _e4.xy(), h_7, rt::Scalar(0f32), rt::Scalar(0f32), at_52.metric, RAY_SHADOW, rt::Scalar(at_52.level), rt::Scalar(0f32), rt::Scalar(1f32), rt::Scalar(0f32));
    }
    pub(crate) fn way_out(&self, path_32: Path, light_2: Toward) -> f32 {
        rt::into(self.v_way_out(path_32, light_2))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_way_out(&self, path_32: Path, light_2: Toward) -> rt::Scalar<f32> {
        let mut way_19: rt::Scalar<f32>;
        let mut interval_4: rt::Vec2<f32>;

        way_19 = ((rt::Scalar(1f32) - path_32.h.x()) / path_32.h.y()).min(rt::Scalar(light_2.distance));
        let _e14 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e14.elementwise_eq(WRAP_CLAMP)) {
            let _e21 = way_19;
            let _e24 = self.v_inside_unit(path_32.uv.x(), path_32.duv.x(), <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), _e21));
            interval_4 = _e24;
            let _e30 = interval_4;
            let _e31 = self.v_inside_unit(path_32.uv.y(), path_32.duv.y(), _e30);
            interval_4 = _e31;
            let _e33 = interval_4.y();
            way_19 = _e33;
        }
        let _e34 = way_19;
        return _e34;
    }
    pub(crate) fn light_ray_over_heights(&self, at_53: Entered, hit_11: Hit, light_3: Toward) -> LightRay {
        rt::into(self.v_light_ray_over_heights(at_53, hit_11, light_3))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_light_ray_over_heights(&self, at_53: Entered, hit_11: Hit, light_3: Toward) -> LightRay {
        let mut local_56: rt::Scalar<bool>;

        let _e3 = self.v_from_hit(at_53, hit_11, light_3);
        if rt::Scalar::into_branch_condition((!_e3.h.y().elementwise_gt(rt::Scalar(0f32)))) {
            return <LightRay>::new(LIGHT_RAY_DARK, _e3);
        }
        let _e11 = self.v_way_out(_e3, light_3);
        if rt::Scalar::into_branch_condition((!_e11.elementwise_gt(rt::Scalar(0f32)))) {
            return <LightRay>::new(LIGHT_RAY_LIT, _e3);
        }
        let _e17 = self.v_grid_of(_e3);
        let _e19 = self.v_cell_of(_e17.origin);
        let _e20 = self.v_cell_leave(_e17, _e19);
        let end_11 = _e20.x().min(_e20.y()).min(_e11).max(rt::Scalar(0f32));
        let _e29 = self.v_height_cell(_e19.to_i32(), rt::Scalar(_e3.level));
        let _e31 = self.v_gap_to(_e3, _e17, _e19, _e29, rt::Scalar(0f32));
        if rt::Scalar::into_branch_condition((!_e31.y().elementwise_lt(rt::Scalar(0f32)))) {
            local_56 = (_e31.y() + (_e31.z() * end_11)).elementwise_lt(rt::Scalar(0f32));
        } else {
            local_56 = rt::Scalar(true);
        }
        let _e45 = local_56;
        if rt::Scalar::into_branch_condition(_e45) {
            return <LightRay>::new(LIGHT_RAY_DARK, _e3);
        }
        if rt::Scalar::into_branch_condition(end_11.elementwise_ge(_e11)) {
            return <LightRay>::new(LIGHT_RAY_LIT, _e3);
        }
        let _e51 = self.v_path_uv(_e3, end_11);
        let gap_2 = (end_11 * (_e31.y() + (_e31.z() * end_11)));
        let _e58 = self.v_height_at(_e51, rt::Scalar(_e3.level));
        let h_8 = <rt::Vec3<f32>>::from_scalars(((_e58 + gap_2) + rt::Scalar(0.0000009536743f32)), _e3.h.y(), rt::Scalar(0f32));
        let path_127 = <Path>::new(_e51, _e3.duv, h_8, (_e11 - end_11), rt::Scalar(0f32), _e3.metric, rt::Scalar(_e3.ray), rt::Scalar(_e3.level), end_11, rt::Scalar(1f32), rt::Scalar(0f32));
        return <LightRay>::new(LIGHT_RAY_OPEN, path_127);
    }
    pub(crate) fn field_heights_light_ray(
        &self,
        at_54: Entered,
        hit_12: Hit,
        light_4: Toward,
        params_50: impl rt::Into<rt::Vec4<f32>>,
    ) -> LightRay {
        rt::into(self.v_field_heights_light_ray(at_54, hit_12, light_4, rt::into(params_50)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_heights_light_ray(
        &self,
        at_54: Entered,
        hit_12: Hit,
        light_4: Toward,
        params_50: rt::Vec4<f32>,
    ) -> LightRay {
        let _e4 = self.v_light_ray_over_heights(at_54, hit_12, light_4);
        return _e4;
    }
    pub(crate) fn no_table(&self) -> SeenTable {
        rt::into(self.v_no_table())
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_no_table(&self) -> SeenTable {
        let none_1 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
        return <SeenTable>::new(none_1, none_1, none_1);
    }
    pub(crate) fn one_seen(&self, normal_21: impl rt::Into<rt::Vec3<f32>>) -> SeenNormals {
        rt::into(self.v_one_seen(rt::into(normal_21)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_one_seen(&self, normal_21: rt::Vec3<f32>) -> SeenNormals {
        let nothing = <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32));
        let none_2 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
        let parts_6 = <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
        let _e13 = self.v_no_table();
        return <SeenNormals>::new(normal_21, rt::Scalar(1f32), rt::Scalar(0u32), none_2, none_2, none_2, nothing, nothing, nothing, rt::Scalar(1f32), rt::Scalar(0f32), parts_6, rt::Scalar(0f32), _e13);
    }
    pub(crate) fn normal_between(
        &self,
        at_55: Around,
        layer_10: impl rt::Into<rt::Scalar<i32>>,
        level_46: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_normal_between(at_55, rt::into(layer_10), rt::into(level_46)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_normal_between(
        &self,
        at_55: Around,
        layer_10: rt::Scalar<i32>,
        level_46: rt::Scalar<u32>,
    ) -> rt::Vec4<f32> {
        let k_63 = level_46.to_i32();
        let _e10 = rt::texture::Read::read_texel((&self.normal_map), <rt::Vec2<i32>>::from_scalars(at_55.columns.x(), at_55.rows.x()), rt::Scalar::into_inner(layer_10), 0i32, rt::Scalar::into_inner(k_63));
        let _e17 = rt::texture::Read::read_texel((&self.normal_map), <rt::Vec2<i32>>::from_scalars(at_55.columns.y(), at_55.rows.x()), rt::Scalar::into_inner(layer_10), 0i32, rt::Scalar::into_inner(k_63));
        let _e24 = rt::texture::Read::read_texel((&self.normal_map), <rt::Vec2<i32>>::from_scalars(at_55.columns.x(), at_55.rows.y()), rt::Scalar::into_inner(layer_10), 0i32, rt::Scalar::into_inner(k_63));
        let _e31 = rt::texture::Read::read_texel((&self.normal_map), <rt::Vec2<i32>>::from_scalars(at_55.columns.y(), at_55.rows.y()), rt::Scalar::into_inner(layer_10), 0i32, rt::Scalar::into_inner(k_63));
        let _e33 = self.v_bilinear(_e10, _e17, _e24, _e31, at_55.part);
        return _e33;
    }
    pub(crate) fn normal_at(
        &self,
        uv_21: impl rt::Into<rt::Vec2<f32>>,
        level_47: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_normal_at(rt::into(uv_21), rt::into(level_47)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_normal_at(
        &self,
        uv_21: rt::Vec2<f32>,
        level_47: rt::Scalar<u32>,
    ) -> rt::Vec4<f32> {
        let _e4 = self.surface_settings.normal_size;
        let _e5 = self.v_level_texels(_e4, level_47);
        let _e6 = self.v_texels_around(uv_21, _e5);
        let _e8 = self.v_normal_between(_e6, rt::Scalar(0i32), level_47);
        return _e8;
    }
    pub(crate) fn sloped_cell(&self, i_6: impl rt::Into<rt::Vec2<i32>>) -> rt::Vec2<i32> {
        rt::into(self.v_sloped_cell(rt::into(i_6)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_sloped_cell(&self, i_6: rt::Vec2<i32>) -> rt::Vec2<i32> {
        let _e3 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e3.elementwise_ne(WRAP_CLAMP)) {
            return i_6;
        }
        let _e7 = self.v_height_texels(rt::Scalar(0u32));
        let last_11 = (_e7 - <rt::Vec2<i32>>::from_scalars(rt::Scalar(2i32), rt::Scalar(2i32))).max(<rt::Vec2<i32>>::from_scalars(rt::Scalar(0i32), rt::Scalar(0i32)));
        return i_6.clamp(<rt::Vec2<i32>>::from_scalars(rt::Scalar(0i32), rt::Scalar(0i32)), last_11);
    }
    pub(crate) fn slope_beside(
        &self,
        own: impl rt::Into<rt::Scalar<f32>>,
        beside: impl rt::Into<rt::Scalar<f32>>,
        rate: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_slope_beside(rt::into(own), rt::into(beside), rt::into(rate)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_slope_beside(
        &self,
        own: rt::Scalar<f32>,
        beside: rt::Scalar<f32>,
        rate: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let a_38 = (own * rate);
        let b_38 = (beside * rate);
        let along_30 = (rt::Scalar(1f32) + (a_38 * b_38));
        let apart_4 = (a_38 - b_38).abs();
        if rt::Scalar::into_branch_condition(apart_4.elementwise_le((rt::Scalar(0.5f32) * along_30))) {
            return beside;
        }
        if rt::Scalar::into_branch_condition(apart_4.elementwise_ge((rt::Scalar(1f32) * along_30))) {
            return own;
        }
        let part_28 = (((apart_4 / along_30) - rt::Scalar(0.5f32)) / rt::Scalar(0.5f32));
        return (beside + ((own - beside) * part_28));
    }
    pub(crate) fn slopes_between_creases(
        &self,
        at_56: Entered,
        uv_22: impl rt::Into<rt::Vec2<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_slopes_between_creases(at_56, rt::into(uv_22)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_slopes_between_creases(
        &self,
        at_56: Entered,
        uv_22: rt::Vec2<f32>,
    ) -> rt::Vec2<f32> {
        let mut part_9: rt::Vec2<f32>;

        let _e3 = self.v_height_size(rt::Scalar(0u32));
        let point_32 = ((uv_22 * _e3) - <rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32)));
        let _e9 = self.v_cell_of(point_32);
        let _e11 = self.v_sloped_cell(_e9.to_i32());
        let cell_43 = _e11.to_f32();
        part_9 = (point_32 - cell_43);
        let _e17 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e17.elementwise_eq(WRAP_CLAMP)) {
            let _e20 = part_9;
            part_9 = _e20.clamp(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)), <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32)));
        }
        let i_11 = cell_43.to_i32();
        let _e30 = self.v_height_cell(i_11, rt::Scalar(0u32));
        let _e31 = part_9;
        let _e32 = self.v_cell_slopes(_e30, _e31);
        let _e37 = self.v_sloped_cell((i_11 - <rt::Vec2<i32>>::from_scalars(rt::Scalar(1i32), rt::Scalar(0i32))));
        let _e39 = self.v_height_cell(_e37, rt::Scalar(0u32));
        let _e40 = part_9;
        let _e41 = self.v_cell_slopes(_e39, _e40);
        let before_u = _e41.x();
        let _e47 = self.v_sloped_cell((i_11 + <rt::Vec2<i32>>::from_scalars(rt::Scalar(1i32), rt::Scalar(0i32))));
        let _e49 = self.v_height_cell(_e47, rt::Scalar(0u32));
        let _e50 = part_9;
        let _e51 = self.v_cell_slopes(_e49, _e50);
        let behind_u = _e51.x();
        let _e57 = self.v_sloped_cell((i_11 - <rt::Vec2<i32>>::from_scalars(rt::Scalar(0i32), rt::Scalar(1i32))));
        let _e59 = self.v_height_cell(_e57, rt::Scalar(0u32));
        let _e60 = part_9;
        let _e61 = self.v_cell_slopes(_e59, _e60);
        let before_v = _e61.y();
        let _e67 = self.v_sloped_cell((i_11 + <rt::Vec2<i32>>::from_scalars(rt::Scalar(0i32), rt::Scalar(1i32))));
        let _e69 = self.v_height_cell(_e67, rt::Scalar(0u32));
        let _e70 = part_9;
        let _e71 = self.v_cell_slopes(_e69, _e70);
        let behind_v = _e71.y();
        let _e76 = rt::Scalar(self.surface_settings.scale_m);
        let rate_u = ((_e3.x() * _e76) / at_56.tangent.length());
        let _e84 = rt::Scalar(self.surface_settings.scale_m);
        let rate_v = ((_e3.y() * _e84) / at_56.bitangent.length());
        let _e90 = self.v_slope_beside(_e32.x(), before_u, rate_u);
        let _e92 = self.v_slope_beside(_e32.y(), before_v, rate_v);
        let before_11 = <rt::Vec2<f32>>::from_scalars(_e90, _e92);
        let _e95 = self.v_slope_beside(_e32.x(), behind_u, rate_u);
        let _e97 = self.v_slope_beside(_e32.y(), behind_v, rate_v);
        let behind_2 = <rt::Vec2<f32>>::from_scalars(_e95, _e97);
        let _e101 = part_9;
        return (rt::Scalar(0.5f32) * ((_e32 + before_11) + ((behind_2 - before_11) * _e101)));
    }
    pub(crate) fn normal_of_slopes(
        &self,
        at_57: Entered,
        slope_u: impl rt::Into<rt::Scalar<f32>>,
        slope_v: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_normal_of_slopes(at_57, rt::into(slope_u), rt::into(slope_v)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_normal_of_slopes(
        &self,
        at_57: Entered,
        slope_u: rt::Scalar<f32>,
        slope_v: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let along_u_2 = (at_57.tangent + (at_57.normal * slope_u));
        let along_v_2 = (at_57.bitangent + (at_57.normal * slope_v));
        let across_8 = along_v_2.cross(along_u_2).normalize();
        return (across_8 * rt::Scalar(-1f32).select(rt::Scalar(1f32), across_8.dot(at_57.normal).elementwise_ge(rt::Scalar(0f32))));
    }
    pub(crate) fn texels_apart(
        &self,
        place_22: impl rt::Into<rt::Scalar<f32>>,
        side_3: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_texels_apart(rt::into(place_22), rt::into(side_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_texels_apart(
        &self,
        place_22: rt::Scalar<f32>,
        side_3: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let _e4 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e4.elementwise_ne(WRAP_CLAMP)) {
            return rt::Scalar(2f32);
        }
        return ((rt::Scalar(2f32) - (rt::Scalar(1.5f32) - place_22).max(rt::Scalar(0f32))) - ((place_22 + rt::Scalar(1.5f32)) - side_3).max(rt::Scalar(0f32))).max(rt::Scalar(0.5f32));
    }
    pub(crate) fn normal_from_height(
        &self,
        at_58: Entered,
        uv_23: impl rt::Into<rt::Vec2<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_normal_from_height(at_58, rt::into(uv_23)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_normal_from_height(
        &self,
        at_58: Entered,
        uv_23: rt::Vec2<f32>,
    ) -> rt::Vec3<f32> {
        let _e3 = self.v_height_size(rt::Scalar(0u32));
        let _e6 = rt::Scalar(self.surface_settings.has_creases);
        if rt::Scalar::into_branch_condition(_e6.elementwise_eq(rt::Scalar(1u32))) {
            let _e9 = self.v_slopes_between_creases(at_58, uv_23);
            let _e13 = rt::Scalar(self.surface_settings.scale_m);
            let slopes = ((_e9 * _e3) * _e13);
            let _e17 = self.v_normal_of_slopes(at_58, slopes.x(), slopes.y());
            return _e17;
        }
        let du = <rt::Vec2<f32>>::from_scalars((rt::Scalar(1f32) / _e3.x()), rt::Scalar(0f32));
        let dv = <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), (rt::Scalar(1f32) / _e3.y()));
        let _e30 = self.v_height_at((uv_23 + du), rt::Scalar(0u32));
        let _e33 = self.v_height_at((uv_23 - du), rt::Scalar(0u32));
        let rise_u_1 = (_e30 - _e33);
        let _e37 = self.v_height_at((uv_23 + dv), rt::Scalar(0u32));
        let _e40 = self.v_height_at((uv_23 - dv), rt::Scalar(0u32));
        let rise_v_1 = (_e37 - _e40);
        let _e46 = self.v_texels_apart((uv_23.x() * _e3.x()), _e3.x());
        let rate_u_1 = (rt::Scalar(1f32) / _e46);
        let _e53 = self.v_texels_apart((uv_23.y() * _e3.y()), _e3.y());
        let rate_v_1 = (rt::Scalar(1f32) / _e53);
        let _e60 = rt::Scalar(self.surface_settings.scale_m);
        let slope_u_1 = (rise_u_1 * ((rate_u_1 * _e3.x()) * _e60));
        let _e67 = rt::Scalar(self.surface_settings.scale_m);
        let slope_v_1 = (rise_v_1 * ((rate_v_1 * _e3.y()) * _e67));
        let _e70 = self.v_normal_of_slopes(at_58, slope_u_1, slope_v_1);
        return _e70;
    }
    pub(crate) fn finest_normal(
        &self,
        at_59: Entered,
        uv_24: impl rt::Into<rt::Vec2<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_finest_normal(at_59, rt::into(uv_24)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_finest_normal(
        &self,
        at_59: Entered,
        uv_24: rt::Vec2<f32>,
    ) -> rt::Vec3<f32> {
        let _e4 = rt::Scalar(self.surface_settings.has_normal);
        if rt::Scalar::into_branch_condition(_e4.elementwise_eq(rt::Scalar(1u32))) {
            let _e8 = self.v_normal_at(uv_24, rt::Scalar(0u32));
            let _e10 = self.v_from_tangent_space(at_59, _e8.xyz());
            return _e10.normalize();
        }
        let _e12 = self.v_normal_from_height(at_59, uv_24);
        return _e12;
    }
    pub(crate) fn means_of_one(&self, n_13: impl rt::Into<rt::Vec3<f32>>) -> Normals {
        rt::into(self.v_means_of_one(rt::into(n_13)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_means_of_one(&self, n_13: rt::Vec3<f32>) -> Normals {
        let upright_1 = n_13.z().max(rt::Scalar(0.05f32));
        let slope_10 = (<rt::Vec2<f32>>::from_scalars((-n_13.x()), (-n_13.y())) / rt::Vec2::splat_from_scalar(upright_1));
        let square_4 = ((slope_10 * slope_10) * upright_1);
        return <Normals>::new(<rt::Vec4<f32>>::new_31(n_13, slope_10.x()), <rt::Vec4<f32>>::from_scalars(square_4.x(), ((slope_10.x() * slope_10.y()) * upright_1), square_4.y(), slope_10.y()));
    }
    pub(crate) fn to_tangent_space(
        &self,
        at_60: Entered,
        v_1: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_to_tangent_space(at_60, rt::into(v_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_to_tangent_space(
        &self,
        at_60: Entered,
        v_1: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let along_u_3 = at_60.tangent.normalize();
        let along_v_3 = at_60.bitangent.normalize();
        return <rt::Vec3<f32>>::from_scalars(along_u_3.dot(v_1), (-along_v_3.dot(v_1)), at_60.normal.dot(v_1));
    }
    pub(crate) fn normal_layers(
        &self,
        uv_25: impl rt::Into<rt::Vec2<f32>>,
        level_48: impl rt::Into<rt::Scalar<u32>>,
    ) -> NormalLayers {
        rt::into(self.v_normal_layers(rt::into(uv_25), rt::into(level_48)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_normal_layers(
        &self,
        uv_25: rt::Vec2<f32>,
        level_48: rt::Scalar<u32>,
    ) -> NormalLayers {
        let _e4 = self.surface_settings.normal_size;
        let _e5 = self.v_level_texels(_e4, level_48);
        let _e6 = self.v_texels_around(uv_25, _e5);
        let _e8 = self.v_normal_between(_e6, rt::Scalar(0i32), level_48);
        let _e10 = self.v_normal_between(_e6, rt::Scalar(1i32), level_48);
        return <NormalLayers>::new(_e8, _e10);
    }
    pub(crate) fn normals_of_level(
        &self,
        at_61: Entered,
        uv_26: impl rt::Into<rt::Vec2<f32>>,
        level_49: impl rt::Into<rt::Scalar<u32>>,
    ) -> Normals {
        rt::into(self.v_normals_of_level(at_61, rt::into(uv_26), rt::into(level_49)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_normals_of_level(
        &self,
        at_61: Entered,
        uv_26: rt::Vec2<f32>,
        level_49: rt::Scalar<u32>,
    ) -> Normals {
        let _e5 = rt::Scalar(self.surface_settings.has_normal);
        let has_normal = _e5.elementwise_eq(rt::Scalar(1u32));
        let _e11 = self.v_normal_layers(uv_26, (level_49 - rt::Scalar(1u32)).select(level_49, has_normal));
        if rt::Scalar::into_branch_condition(has_normal) {
            return <Normals>::new(_e11.first, _e11.second);
        }
        let tile_1 = self.surface_settings.normal_tile_m;
        let x_12 = ((tile_1.x() * at_61.tangent.normalize().dot(at_61.tangent)) / at_61.tangent.dot(at_61.tangent));
        let y_7 = ((tile_1.y() * at_61.bitangent.normalize().dot(at_61.bitangent)) / at_61.bitangent.dot(at_61.bitangent));
        let first_20 = _e11.first;
        let second_7 = _e11.second;
        let flatter = <rt::Vec3<f32>>::from_scalars((first_20.x() * x_12), (first_20.y() * y_7), first_20.z());
        let longer_1 = (first_20.xyz().dot(first_20.xyz()) / flatter.dot(flatter)).sqrt();
        let squares = (<rt::Vec3<f32>>::from_scalars(((second_7.x() * x_12) * x_12), ((second_7.y() * x_12) * y_7), ((second_7.z() * y_7) * y_7)) * longer_1);
        return <Normals>::new(<rt::Vec4<f32>>::new_31((flatter * longer_1), (first_20.w() * x_12)), <rt::Vec4<f32>>::new_31(squares, (second_7.w() * y_7)));
    }
    pub(crate) fn mean_of_five(
        &self,
        middle_8: impl rt::Into<rt::Scalar<f32>>,
        four: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_mean_of_five(rt::into(middle_8), rt::into(four)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_mean_of_five(
        &self,
        middle_8: rt::Scalar<f32>,
        four: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        return ((middle_8 * rt::Scalar(0.33333334f32)) + (four * rt::Scalar(0.16666667f32)));
    }
    pub(crate) fn sum_of_four(&self, four_1: impl rt::Into<rt::Vec4<f32>>) -> f32 {
        rt::into(self.v_sum_of_four(rt::into(four_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_sum_of_four(&self, four_1: rt::Vec4<f32>) -> rt::Scalar<f32> {
        return ((four_1.x() + four_1.y()) + (four_1.z() + four_1.w()));
    }
    pub(crate) fn seen_normals(
        &self,
        at_62: Entered,
        normals: Normals,
        view_16: impl rt::Into<rt::Vec3<f32>>,
    ) -> SeenNormals {
        rt::into(self.v_seen_normals(at_62, normals, rt::into(view_16)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_seen_normals(
        &self,
        at_62: Entered,
        normals: Normals,
        view_16: rt::Vec3<f32>,
    ) -> SeenNormals {
        let first_21 = normals.first;
        let second_8 = normals.second;
        let slope_11 = <rt::Vec2<f32>>::from_scalars(first_21.w(), second_8.w());
        let upright_2 = first_21.z().max(rt::Scalar(0.05f32));
        let x_13 = (first_21.x() / upright_2);
        let y_8 = (first_21.y() / upright_2);
        let a_39 = ((second_8.x() / upright_2) - (x_13 * x_13)).max(rt::Scalar(0f32)).sqrt().max(rt::Scalar(0.0001f32));
        let b_39 = (((second_8.y() / upright_2) - (x_13 * y_8)) / a_39);
        let spread = ((second_8.z() / upright_2) - (y_8 * y_8)).max(rt::Scalar(0f32));
        let d_4 = (spread - (b_39 * b_39)).max(rt::Scalar(0f32)).sqrt().max(rt::Scalar(0.0001f32));
        let with_x = ((-<rt::Vec3<f32>>::from_scalars(second_8.x(), second_8.y(), first_21.x())) - (first_21.xyz() * slope_11.x()));
        let with_y = ((-<rt::Vec3<f32>>::from_scalars(second_8.y(), second_8.z(), first_21.y())) - (first_21.xyz() * slope_11.y()));
        let most_15 = ((a_39 * a_39) + spread).sqrt().min(rt::Scalar(1f32));
        let along_31 = (with_x / rt::Vec3::splat_from_scalar(a_39.max((with_x.length() / most_15))));
        let rest_8 = (with_y - (along_31 * b_39));
        let across_9 = (rest_8 / rt::Vec3::splat_from_scalar(d_4.max((rest_8.length() / most_15))));
        let _e77 = self.v_to_tangent_space(at_62, view_16);
        let middle_14 = (_e77.z() - _e77.xy().dot(slope_11));
        let _e91 = self.v_facing_four(middle_14, (-((_e77.x() * a_39) + (_e77.y() * b_39))), (-(_e77.y() * d_4)));
        let one_1 = middle_14.max(rt::Scalar(0f32));
        let _e94 = self.v_sum_of_four(_e91);
        let _e95 = self.v_mean_of_five(one_1, _e94);
        let all_2 = _e95.max(rt::Scalar(0.001f32));
        let aside_4 = ((along_31 * ((_e91.x() - _e91.y()) / all_2)) + (across_9 * ((_e91.z() - _e91.w()) / all_2)));
        let _e113 = self.v_from_tangent_space(at_62, (first_21.xyz() + (aside_4 * rt::Scalar(0.28867513f32))));
        let _e133 = self.v_no_table();
        return <SeenNormals>::new(_e113.normalize(), _e113.length().min(rt::Scalar(1f32)), rt::Scalar(1u32), first_21.xyz(), along_31, across_9, slope_11, <rt::Vec2<f32>>::from_scalars(a_39, b_39), <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), d_4), (_e77.z().max(rt::Scalar(0f32)) * _e77.z().max(rt::Scalar(0f32))), (one_1 / all_2), (_e91 / rt::Vec4::splat_from_scalar(all_2)), rt::Scalar(0f32), _e133);
    }
    pub(crate) fn table_part(&self, at_63: Entered) -> f32 {
        rt::into(self.v_table_part(at_63))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_table_part(&self, at_63: Entered) -> rt::Scalar<f32> {
        let _e3 = rt::Scalar(self.surface_settings.has_normal);
        if rt::Scalar::into_branch_condition(_e3.elementwise_eq(rt::Scalar(1u32))) {
            return rt::Scalar(0f32);
        }
        return (rt::Scalar(at_63.fade) * ((rt::Scalar(at_63.footprint) * rt::Scalar(0.25f32)) - rt::Scalar(1f32)).clamp(rt::Scalar(0f32), rt::Scalar(1f32)));
    }
    pub(crate) fn has_table(&self, levels: Levels) -> bool {
        rt::into(self.v_has_table(levels))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_has_table(&self, levels: Levels) -> rt::Scalar<bool> {
        let _e6 = rt::Scalar(self.surface_settings.maps[0usize].first_level);
        return rt::Scalar(levels.fine).elementwise_ge(_e6);
    }
    pub(crate) fn with_table(
        &self,
        at_64: Entered,
        seen_1: SeenNormals,
        table: SeenTable,
        part_10: impl rt::Into<rt::Scalar<f32>>,
    ) -> SeenNormals {
        rt::into(self.v_with_table(at_64, seen_1, table, rt::into(part_10)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_with_table(
        &self,
        at_64: Entered,
        seen_1: SeenNormals,
        table: SeenTable,
        part_10: rt::Scalar<f32>,
    ) -> SeenNormals {
        let mut blended: SeenNormals;

        blended = seen_1;
        let before_12 = (seen_1.normal * rt::Scalar(seen_1.length));
        let _e9 = self.v_from_tangent_space(at_64, table.mean);
        let mean_11 = (before_12 + ((_e9 - before_12) * part_10));
        blended.normal = mean_11.normalize();
        rt::Scalar(blended.length) = mean_11.length().min(rt::Scalar(1f32));
        rt::Scalar(blended.table_part) = part_10;
        blended.table = table;
        let _e21 = blended;
        return _e21;
    }
    pub(crate) fn seen_between(
        &self,
        a_16: SeenTexel,
        b_16: SeenTexel,
        part_11: impl rt::Into<rt::Scalar<f32>>,
    ) -> SeenTexel {
        rt::into(self.v_seen_between(a_16, b_16, rt::into(part_11)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_seen_between(
        &self,
        a_16: SeenTexel,
        b_16: SeenTexel,
        part_11: rt::Scalar<f32>,
    ) -> SeenTexel {
        return <SeenTexel>::new((a_16.first + ((b_16.first - a_16.first) * part_11)), (a_16.second + ((b_16.second - a_16.second) * part_11)));
    }
    pub(crate) fn seen_texel(
        &self,
        at_65: Around,
        azimuth: impl rt::Into<rt::Scalar<i32>>,
        elevation: impl rt::Into<rt::Scalar<i32>>,
        level_50: impl rt::Into<rt::Scalar<u32>>,
    ) -> SeenTexel {
        rt::into(self.v_seen_texel(at_65, rt::into(azimuth), rt::into(elevation), rt::into(level_50)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_seen_texel(
        &self,
        at_65: Around,
        azimuth: rt::Scalar<i32>,
        elevation: rt::Scalar<i32>,
        level_50: rt::Scalar<u32>,
    ) -> SeenTexel {
        let layer_17 = (rt::Scalar(2i32) * ((azimuth * rt::Scalar(4i32)) + elevation));
        let _e9 = self.v_detail_texel_between(at_65, layer_17, level_50);
        let _e12 = self.v_detail_texel_between(at_65, (layer_17 + rt::Scalar(1i32)), level_50);
        return <SeenTexel>::new(_e9, _e12);
    }
    pub(crate) fn seen_in_levels(
        &self,
        at_66: SeenPlace,
        azimuth_1: impl rt::Into<rt::Scalar<i32>>,
        elevation_1: impl rt::Into<rt::Scalar<i32>>,
    ) -> SeenTexel {
        rt::into(self.v_seen_in_levels(at_66, rt::into(azimuth_1), rt::into(elevation_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_seen_in_levels(
        &self,
        at_66: SeenPlace,
        azimuth_1: rt::Scalar<i32>,
        elevation_1: rt::Scalar<i32>,
    ) -> SeenTexel {
        let _e6 = self.v_seen_texel(at_66.fine, azimuth_1, elevation_1, rt::Scalar(at_66.levels.fine));
        if rt::Scalar::into_branch_condition(rt::Scalar(at_66.levels.part).elementwise_gt(rt::Scalar(0f32))) {
            let _e16 = self.v_seen_texel(at_66.coarse, azimuth_1, elevation_1, (rt::Scalar(at_66.levels.fine) + rt::Scalar(1u32)));
            let _e19 = self.v_seen_between(_e6, _e16, rt::Scalar(at_66.levels.part));
            return _e19;
        }
        return _e6;
    }
    pub(crate) fn table_of(
        &self,
        at_67: Entered,
        uv_27: impl rt::Into<rt::Vec2<f32>>,
        view_17: impl rt::Into<rt::Vec3<f32>>,
        levels_1: Levels,
    ) -> SeenTable {
        rt::into(self.v_table_of(at_67, rt::into(uv_27), rt::into(view_17), levels_1))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_table_of(
        &self,
        at_67: Entered,
        uv_27: rt::Vec2<f32>,
        view_17: rt::Vec3<f32>,
        levels_1: Levels,
    ) -> SeenTable {
        let _e4 = self.v_climb(at_67, view_17);
        let tile_2 = self.surface_settings.maps[0usize].tile_m;
        let _e15 = rt::Scalar(self.surface_settings.scale_m);
        let toward_9 = <rt::Vec3<f32>>::new_21((_e4.xy() * tile_2), (_e4.z() * _e15));
        let up_3 = (toward_9.z() / toward_9.length());
        let elevation_3 = ((up_3 * rt::Scalar(4f32)) - rt::Scalar(1f32)).clamp(rt::Scalar(0f32), rt::Scalar(3f32));
        let _e29 = self.v_turn_of(toward_9.xy());
        let azimuth_4 = (_e29 * rt::Scalar(8f32));
        let a0_1 = (azimuth_4.floor().to_i32() % rt::Scalar(8i32));
        let a1_1 = ((a0_1 + rt::Scalar(1i32)) % rt::Scalar(8i32));
        let e0_ = elevation_3.floor().to_i32();
        let e1_1 = (e0_ + rt::Scalar(1i32)).min(rt::Scalar(3i32));
        let across_10 = (azimuth_4 - azimuth_4.floor());
        let _e49 = self.v_height_texels(rt::Scalar(levels_1.fine));
        let _e50 = self.v_texels_around(uv_27, _e49);
        let _e54 = self.v_height_texels((rt::Scalar(levels_1.fine) + rt::Scalar(1u32)));
        let _e55 = self.v_texels_around(uv_27, _e54);
        let place_42 = <SeenPlace>::new(_e50, _e55, levels_1);
        let _e57 = self.v_seen_in_levels(place_42, a0_1, e0_);
        let _e58 = self.v_seen_in_levels(place_42, a1_1, e0_);
        let _e59 = self.v_seen_between(_e57, _e58, across_10);
        let _e60 = self.v_seen_in_levels(place_42, a0_1, e1_1);
        let _e61 = self.v_seen_in_levels(place_42, a1_1, e1_1);
        let _e62 = self.v_seen_between(_e60, _e61, across_10);
        let _e65 = self.v_seen_between(_e59, _e62, (elevation_3 - elevation_3.floor()));
        let x_14 = ((tile_2.x() * at_67.tangent.normalize().dot(at_67.tangent)) / at_67.tangent.dot(at_67.tangent));
        let y_9 = ((tile_2.y() * at_67.bitangent.normalize().dot(at_67.bitangent)) / at_67.bitangent.dot(at_67.bitangent));
        let mean_12 = _e65.first.xyz();
        let flatter_1 = <rt::Vec3<f32>>::from_scalars((mean_12.x() * x_14), (mean_12.y() * y_9), mean_12.z());
        let squared_3 = (mean_12.dot(mean_12) / flatter_1.dot(flatter_1));
        let upright_3 = ((rt::Scalar(1f32) - _e65.first.w()) - _e65.second.y()).max(rt::Scalar(0f32));
        return <SeenTable>::new((flatter_1 * squared_3.sqrt()), (<rt::Vec3<f32>>::from_scalars(((_e65.first.w() * x_14) * x_14), ((_e65.second.y() * y_9) * y_9), upright_3) * squared_3), (<rt::Vec3<f32>>::from_scalars(((_e65.second.x() * x_14) * y_9), (_e65.second.z() * x_14), (_e65.second.w() * y_9)) * squared_3));
    }
    pub(crate) fn mesostructure_normals(
        &self,
        at_68: Entered,
        uv_28: impl rt::Into<rt::Vec2<f32>>,
        view_18: impl rt::Into<rt::Vec3<f32>>,
    ) -> SeenNormals {
        rt::into(self.v_mesostructure_normals(at_68, rt::into(uv_28), rt::into(view_18)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_mesostructure_normals(
        &self,
        at_68: Entered,
        uv_28: rt::Vec2<f32>,
        view_18: rt::Vec3<f32>,
    ) -> SeenNormals {
        let mut first_1: rt::Vec4<f32> = <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
        let mut second: rt::Vec4<f32>;

        let _e5 = rt::Scalar(self.surface_settings.has_vertex_normals);
        if rt::Scalar::into_branch_condition(_e5.elementwise_eq(rt::Scalar(1u32))) {
            let _e9 = self.v_one_seen(at_68.normal);
            return _e9;
        }
        let upright_4 = at_68.normal.dot(view_18);
        let shown = upright_4.max(rt::Scalar(0.5f32));
        let width_7 = (shown + ((rt::Scalar(1f32) - shown) * rt::Scalar(at_68.fade)));
        let _e22 = rt::Scalar(self.surface_settings.normal_texels);
        let texels_6 = ((rt::Scalar(at_68.footprint) * _e22) * width_7);
        let _e27 = rt::Scalar(self.surface_settings.normal_levels);
        let _e28 = self.v_levels_of(texels_6, _e27);
        let _e35 = first_1;
        second = _e35;
        if rt::Scalar::into_branch_condition(rt::Scalar(_e28.fine).elementwise_eq(rt::Scalar(0u32))) {
            let _e40 = self.v_finest_normal(at_68, uv_28);
            if rt::Scalar::into_branch_condition((!rt::Scalar(_e28.part).elementwise_gt(rt::Scalar(0f32)))) {
                let _e45 = self.v_one_seen(_e40);
                return _e45;
            }
            let _e46 = self.v_to_tangent_space(at_68, _e40);
            let _e47 = self.v_means_of_one(_e46);
            first_1 = _e47.first;
            second = _e47.second;
        } else {
            let _e51 = self.v_normals_of_level(at_68, uv_28, rt::Scalar(_e28.fine));
            first_1 = _e51.first;
            second = _e51.second;
        }
        if rt::Scalar::into_branch_condition(rt::Scalar(_e28.part).elementwise_gt(rt::Scalar(0f32))) {
            let _e60 = self.v_normals_of_level(at_68, uv_28, (rt::Scalar(_e28.fine) + rt::Scalar(1u32)));
            let _e61 = first_1;
            let _e63 = first_1;
            first_1 = (_e61 + ((_e60.first - _e63) * rt::Scalar(_e28.part)));
            let _e68 = second;
            let _e70 = second;
            second = (_e68 + ((_e60.second - _e70) * rt::Scalar(_e28.part)));
        }
        let _e75 = first_1;
        let _e76 = second;
        let _e78 = self.v_seen_normals(at_68, <Normals>::new(_e75, _e76), view_18);
        let _e79 = self.v_table_part(at_68);
        if rt::Scalar::into_branch_condition(_e79.elementwise_gt(rt::Scalar(0f32))) {
            let _e85 = rt::Scalar(self.surface_settings.height_levels);
            let _e86 = self.v_levels_of(rt::Scalar(at_68.footprint), _e85);
            let _e87 = self.v_has_table(_e86);
            if rt::Scalar::into_branch_condition(_e87) {
                let _e88 = self.v_table_of(at_68, uv_28, view_18, _e86);
                let _e89 = self.v_with_table(at_68, _e78, _e88, _e79);
                return _e89;
            }
        }
        return _e78;
    }
    pub(crate) fn field_heights_normals(
        &self,
        at_69: Entered,
        hit_13: Hit,
        view_19: impl rt::Into<rt::Vec3<f32>>,
        params_51: impl rt::Into<rt::Vec4<f32>>,
    ) -> SeenNormals {
        rt::into(self.v_field_heights_normals(at_69, hit_13, rt::into(view_19), rt::into(params_51)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_heights_normals(
        &self,
        at_69: Entered,
        hit_13: Hit,
        view_19: rt::Vec3<f32>,
        params_51: rt::Vec4<f32>,
    ) -> SeenNormals {
        let _e5 = self.v_mesostructure_normals(at_69, hit_13.uv, view_19);
        return _e5;
    }
    pub(crate) fn patch_normal(
        &self,
        at_70: Entered,
        uv_29: impl rt::Into<rt::Vec2<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_patch_normal(at_70, rt::into(uv_29)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_patch_normal(
        &self,
        at_70: Entered,
        uv_29: rt::Vec2<f32>,
    ) -> rt::Vec3<f32> {
        let _e4 = rt::Scalar(self.surface_settings.has_vertex_normals);
        if rt::Scalar::into_branch_condition(_e4.elementwise_eq(rt::Scalar(1u32))) {
            let facet = at_70.facing.normalize();
            return (facet * rt::Scalar(-1f32).select(rt::Scalar(1f32), facet.dot(at_70.normal).elementwise_ge(rt::Scalar(0f32))));
        }
        let _e18 = self.v_height_and_slope(uv_29, rt::Scalar(at_70.level));
        let _e24 = rt::Scalar(self.surface_settings.scale_m);
        let along_u_4 = (at_70.tangent + (at_70.normal * (_e18.y() * _e24)));
        let _e33 = rt::Scalar(self.surface_settings.scale_m);
        let along_v_4 = (at_70.bitangent + (at_70.normal * (_e18.z() * _e33)));
        let across_11 = along_v_4.cross(along_u_4).normalize();
        return (across_11 * rt::Scalar(-1f32).select(rt::Scalar(1f32), across_11.dot(at_70.normal).elementwise_ge(rt::Scalar(0f32))));
    }
    pub(crate) fn field_heights_patch_normal(
        &self,
        at_71: Entered,
        hit_14: Hit,
        params_52: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_field_heights_patch_normal(at_71, hit_14, rt::into(params_52)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_heights_patch_normal(
        &self,
        at_71: Entered,
        hit_14: Hit,
        params_52: rt::Vec4<f32>,
    ) -> rt::Vec3<f32> {
        let _e4 = self.v_patch_normal(at_71, hit_14.uv);
        return _e4;
    }
    pub(crate) fn field_slopes(&self, place_23: impl rt::Into<rt::Vec3<f32>>) -> rt::Vec3<f32> {
        rt::into(self.v_field_slopes(rt::into(place_23)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_slopes(&self, place_23: rt::Vec3<f32>) -> rt::Vec3<f32> {
        let i_12 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0f32), rt::Scalar(0f32));
        let j_2 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0.5f32), rt::Scalar(0f32));
        let k_64 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0.5f32));
        let _e14 = self.v_field_at_voxel((place_23 + i_12));
        let _e16 = self.v_field_at_voxel((place_23 - i_12));
        let along_i = (_e14 - _e16);
        let _e19 = self.v_field_at_voxel((place_23 + j_2));
        let _e21 = self.v_field_at_voxel((place_23 - j_2));
        let along_j = (_e19 - _e21);
        let _e24 = self.v_field_at_voxel((place_23 + k_64));
        let _e26 = self.v_field_at_voxel((place_23 - k_64));
        let along_k = (_e24 - _e26);
        return (<rt::Vec3<f32>>::from_scalars(along_i, along_j, along_k) / rt::Vec3::splat_from_scalar(rt::Scalar(1f32)));
    }
    pub(crate) fn light_ray_from(
        &self,
        at_72: Entered,
        begin_4: impl rt::Into<rt::Vec3<f32>>,
        change_1: impl rt::Into<rt::Vec3<f32>>,
        light_5: Toward,
    ) -> LightRay {
        rt::into(self.v_light_ray_from(at_72, rt::into(begin_4), rt::into(change_1), light_5))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_light_ray_from(
        &self,
        at_72: Entered,
        begin_4: rt::Vec3<f32>,
        change_1: rt::Vec3<f32>,
        light_5: Toward,
    ) -> LightRay {
        let h_9 = <rt::Vec3<f32>>::from_scalars(begin_4.z(), change_1.z(), rt::Scalar(0f32));
        let way_28 = <Path>::new(begin_4.xy(), change_1.xy(), h_9, rt::Scalar(0f32), rt::Scalar(0f32), at_72.metric, RAY_SHADOW, rt::Scalar(at_72.level), rt::Scalar(0f32), rt::Scalar(1f32), rt::Scalar(0f32));
        if rt::Scalar::into_branch_condition((!change_1.z().elementwise_gt(rt::Scalar(0f32)))) {
            return <LightRay>::new(LIGHT_RAY_DARK, way_28);
        }
        let _e25 = self.v_way_out(way_28, light_5);
        if rt::Scalar::into_branch_condition((!_e25.elementwise_gt(rt::Scalar(0f32)))) {
            return <LightRay>::new(LIGHT_RAY_LIT, way_28);
        }
        let path_128 = <Path>::new(begin_4.xy(), change_1.xy(), h_9, _e25, rt::Scalar(0f32), at_72.metric, RAY_SHADOW, rt::Scalar(at_72.level), rt::Scalar(0f32), rt::Scalar(1f32), rt::Scalar(0f32));
        return <LightRay>::new(LIGHT_RAY_OPEN, path_128);
    }
    pub(crate) fn light_ray_out_of_volume(&self, at_73: Entered, hit_15: Hit, light_6: Toward) -> LightRay {
        rt::into(self.v_light_ray_out_of_volume(at_73, hit_15, light_6))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_light_ray_out_of_volume(&self, at_73: Entered, hit_15: Hit, light_6: Toward) -> LightRay {
        let mut outside: rt::Vec3<f32>;

        let _e4 = self.v_climb(at_73, light_6.direction);
        let _e6 = self.v_near_uv(hit_15.uv);
        let _e9 = self.v_voxel_place(<rt::Vec3<f32>>::new_21(_e6, rt::Scalar(hit_15.height)));
        let _e10 = self.v_field_slopes(_e9);
        let steepness = _e10.length();
        outside = _e9;
        if rt::Scalar::into_branch_condition(steepness.elementwise_gt(rt::Scalar(0f32))) {
            outside = (_e9 - (_e10 * (rt::Scalar(0.125f32) / steepness)));
        }
        let _e19 = outside;
        let _e25 = self.v_volume_size();
        let _e27 = self.v_light_ray_from(at_73, ((_e19 + <rt::Vec3<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32), rt::Scalar(0.5f32))) / _e25), _e4, light_6);
        return _e27;
    }
    pub(crate) fn field_volume_light_ray(
        &self,
        at_74: Entered,
        hit_16: Hit,
        light_7: Toward,
        params_53: impl rt::Into<rt::Vec4<f32>>,
    ) -> LightRay {
        rt::into(self.v_field_volume_light_ray(at_74, hit_16, light_7, rt::into(params_53)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_volume_light_ray(
        &self,
        at_74: Entered,
        hit_16: Hit,
        light_7: Toward,
        params_53: rt::Vec4<f32>,
    ) -> LightRay {
        let _e4 = self.v_light_ray_out_of_volume(at_74, hit_16, light_7);
        return _e4;
    }
    pub(crate) fn motif_texel(&self, place_24: impl rt::Into<rt::Scalar<u32>>) -> rt::Vec4<f32> {
        rt::into(self.v_motif_texel(rt::into(place_24)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_motif_texel(&self, place_24: rt::Scalar<u32>) -> rt::Vec4<f32> {
        let row_13 = (place_24 >> TREE_SHIFT);
        let _e9 = self.v_object_texel(<rt::Vec2<i32>>::from_scalars((place_24 - (row_13 * TREE_COLUMNS)).to_i32(), row_13.to_i32()));
        return _e9;
    }
    pub(crate) fn nearest_of_leaf(
        &self,
        place_25: impl rt::Into<rt::Vec3<f32>>,
        leaf: impl rt::Into<rt::Scalar<u32>>,
        before_2: NearTriangle,
    ) -> NearTriangle {
        rt::into(self.v_nearest_of_leaf(rt::into(place_25), rt::into(leaf), before_2))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_nearest_of_leaf(
        &self,
        place_25: rt::Vec3<f32>,
        leaf: rt::Scalar<u32>,
        before_2: NearTriangle,
    ) -> NearTriangle {
        let mut nearest: NearTriangle;
        let mut triangle: rt::Scalar<u32>;

        nearest = before_2;
        triangle = leaf;
        'naga_break: loop {
            'naga_continue: {
                let _e5 = triangle;
                if rt::Scalar::into_branch_condition(_e5.elementwise_ne(rt::Scalar(0u32))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e8 = triangle;
                    let _e9 = self.v_motif_texel(_e8);
                    let _e10 = triangle;
                    let _e13 = self.v_motif_texel((_e10 + rt::Scalar(1u32)));
                    let _e14 = triangle;
                    let _e17 = self.v_motif_texel((_e14 + rt::Scalar(2u32)));
                    let _e21 = self.v_apart_from_triangle(place_25, _e9.xyz(), _e13.xyz(), _e17.xyz());
                    let _e23 = rt::Scalar(nearest.apart);
                    if rt::Scalar::into_branch_condition(_e21.elementwise_lt(_e23)) {
                        let _e25 = triangle;
                        nearest = <NearTriangle>::new(_e25, _e21);
                    }
                    let _e27 = triangle;
                    triangle = (_e27 + rt::Scalar(3u32)).select(rt::Scalar(0u32), _e9.w().elementwise_eq(rt::Scalar(0f32)));
                }
            }
        }
        let _e35 = nearest;
        return _e35;
    }
    pub(crate) fn point_of_triangle(
        &self,
        triangle_1: impl rt::Into<rt::Scalar<u32>>,
        place_26: impl rt::Into<rt::Vec3<f32>>,
    ) -> MotifPoint {
        rt::into(self.v_point_of_triangle(rt::into(triangle_1), rt::into(place_26)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_point_of_triangle(
        &self,
        triangle_1: rt::Scalar<u32>,
        place_26: rt::Vec3<f32>,
    ) -> MotifPoint {
        let _e2 = self.v_motif_texel(triangle_1);
        let a_40 = _e2.xyz();
        let _e6 = self.v_motif_texel((triangle_1 + rt::Scalar(1u32)));
        let b_40 = _e6.xyz();
        let _e10 = self.v_motif_texel((triangle_1 + rt::Scalar(2u32)));
        let c_28 = _e10.xyz();
        let _e13 = self.v_motif_texel(rt::Scalar(0u32));
        let normals_1 = (triangle_1 + _e13.x().to_u32());
        let _e17 = self.v_weights_under(place_26, a_40, b_40, c_28);
        let weights_7 = _e17.max(<rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32)));
        let _e23 = self.v_motif_texel(normals_1);
        let first_22 = (_e23.xyz() * weights_7.x());
        let _e29 = self.v_motif_texel((normals_1 + rt::Scalar(1u32)));
        let second_9 = (_e29.xyz() * weights_7.y());
        let _e36 = self.v_motif_texel((normals_1 + rt::Scalar(2u32)));
        let sum_14 = ((first_22 + second_9) + (_e36.xyz() * weights_7.z()));
        let flat_normal = (b_40 - a_40).cross((c_28 - a_40)).normalize();
        let facet_1 = (flat_normal * rt::Scalar(1f32).select(rt::Scalar(-1f32), flat_normal.dot(sum_14).elementwise_lt(rt::Scalar(0f32))));
        let size_5 = sum_14.length();
        if rt::Scalar::into_branch_condition(size_5.elementwise_gt(rt::Scalar(0f32))) {
            return <MotifPoint>::new((sum_14 / rt::Vec3::splat_from_scalar(size_5)), facet_1);
        }
        return <MotifPoint>::new(facet_1, facet_1);
    }
    pub(crate) fn motif_at(&self, place_27: impl rt::Into<rt::Vec3<f32>>) -> MotifPoint {
        rt::into(self.v_motif_at(rt::into(place_27)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_motif_at(&self, place_27: rt::Vec3<f32>) -> MotifPoint {
        let mut nearest_1: NearTriangle = <NearTriangle>::new(rt::Scalar(0u32), rt::Scalar(0.00000001f32));
        let mut node: rt::Scalar<u32> = rt::Scalar(1u32);
        let mut next_2: rt::Scalar<u32>;

        let reach_5 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0.0001f32), rt::Scalar(0.0001f32), rt::Scalar(0.0001f32));
        'naga_break: loop {
            'naga_continue: {
                let _e11 = node;
                if rt::Scalar::into_branch_condition(_e11.elementwise_ne(rt::Scalar(0u32))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e14 = node;
                    let _e15 = self.v_motif_texel(_e14);
                    let _e16 = node;
                    let _e19 = self.v_motif_texel((_e16 + rt::Scalar(1u32)));
                    next_2 = _e15.w().to_u32();
                    let beyond_5 = ((_e15.xyz() - reach_5) - place_27).max(((place_27 - _e19.xyz()) - reach_5));
                    if rt::Scalar::into_branch_condition(beyond_5.x().max(beyond_5.y()).max(beyond_5.z()).elementwise_le(rt::Scalar(0f32))) {
                        if rt::Scalar::into_branch_condition(_e19.w().elementwise_eq(rt::Scalar(0f32))) {
                            let _e40 = node;
                            next_2 = (_e40 + rt::Scalar(2u32));
                        } else {
                            let _e45 = nearest_1;
                            let _e46 = self.v_nearest_of_leaf(place_27, _e19.w().to_u32(), _e45);
                            nearest_1 = _e46;
                        }
                    }
                    let _e47 = next_2;
                    node = _e47;
                }
            }
        }
        let _e49 = rt::Scalar(nearest_1.triangle);
        if rt::Scalar::into_branch_condition(_e49.elementwise_eq(rt::Scalar(0u32))) {
            return <MotifPoint>::new(<rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(1f32)), <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(1f32)));
        }
        let _e62 = rt::Scalar(nearest_1.triangle);
        let _e63 = self.v_point_of_triangle(_e62, place_27);
        return _e63;
    }
    pub(crate) fn motif_of(&self, hit_17: Hit) -> MotifPoint {
        rt::into(self.v_motif_of(hit_17))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_motif_of(&self, hit_17: Hit) -> MotifPoint {
        let _e7 = self.v_motif_at(<rt::Vec3<f32>>::new_21((hit_17.uv - hit_17.uv.floor()), rt::Scalar(hit_17.height)));
        return _e7;
    }
    pub(crate) fn light_ray_out_of_motif(&self, at_75: Entered, hit_18: Hit, light_8: Toward) -> LightRay {
        rt::into(self.v_light_ray_out_of_motif(at_75, hit_18, light_8))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_light_ray_out_of_motif(&self, at_75: Entered, hit_18: Hit, light_8: Toward) -> LightRay {
        let _e4 = self.v_climb(at_75, light_8.direction);
        let _e5 = self.v_motif_of(hit_18);
        let facet_2 = _e5.facet;
        let aside_5 = (facet_2 * rt::Scalar(-0.0002f32).select(rt::Scalar(0.0002f32), facet_2.dot(_e4).elementwise_gt(rt::Scalar(0f32))));
        let _e15 = self.v_near_uv(hit_18.uv);
        let _e19 = self.v_light_ray_from(at_75, (<rt::Vec3<f32>>::new_21(_e15, rt::Scalar(hit_18.height)) + aside_5), _e4, light_8);
        return _e19;
    }
    pub(crate) fn field_motif_light_ray(
        &self,
        at_76: Entered,
        hit_19: Hit,
        light_9: Toward,
        params_54: impl rt::Into<rt::Vec4<f32>>,
    ) -> LightRay {
        rt::into(self.v_field_motif_light_ray(at_76, hit_19, light_9, rt::into(params_54)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_motif_light_ray(
        &self,
        at_76: Entered,
        hit_19: Hit,
        light_9: Toward,
        params_54: rt::Vec4<f32>,
    ) -> LightRay {
        let _e4 = self.v_light_ray_out_of_motif(at_76, hit_19, light_9);
        return _e4;
    }
    pub(crate) fn field_light_ray_stage(&self, at_77: Entered, hit_20: Hit, light_10: Toward) -> LightRay {
        rt::into(self.v_field_light_ray_stage(at_77, hit_20, light_10))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_field_light_ray_stage(&self, at_77: Entered, hit_20: Hit, light_10: Toward) -> LightRay {
        let _e7 = rt::Scalar(self.surface_settings.choices[4usize].number);
        match rt::Scalar::into_inner(_e7) {
            0u32 => {
                let _e12 = self.surface_settings.choices[4usize].params;
                let _e13 = self.v_field_heights_light_ray(at_77, hit_20, light_10, _e12);
                return _e13;
            }
            1u32 => {
                let _e18 = self.surface_settings.choices[4usize].params;
                let _e19 = self.v_field_volume_light_ray(at_77, hit_20, light_10, _e18);
                return _e19;
            }
            _ => {
                let _e24 = self.surface_settings.choices[4usize].params;
                let _e25 = self.v_field_motif_light_ray(at_77, hit_20, light_10, _e24);
                return _e25;
            }
        }
    }
    pub(crate) fn motif_is_closed(&self) -> bool {
        rt::into(self.v_motif_is_closed())
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_motif_is_closed(&self) -> rt::Scalar<bool> {
        let _e1 = self.v_motif_texel(rt::Scalar(0u32));
        return _e1.z().elementwise_eq(rt::Scalar(1f32));
    }
    pub(crate) fn field_motif_normals(
        &self,
        at_78: Entered,
        hit_21: Hit,
        view_20: impl rt::Into<rt::Vec3<f32>>,
        params_55: impl rt::Into<rt::Vec4<f32>>,
    ) -> SeenNormals {
        rt::into(self.v_field_motif_normals(at_78, hit_21, rt::into(view_20), rt::into(params_55)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_field_motif_normals(
        &self,
        at_78: Entered,
        hit_21: Hit,
        view_20: rt::Vec3<f32>,
        params_55: rt::Vec4<f32>,
    ) -> SeenNormals {
        let mut local_57: rt::Scalar<bool>;

        let _e4 = self.v_motif_of(hit_21);
        let _e5 = self.v_motif_is_closed();
        if rt::Scalar::into_branch_condition((!_e5)) {
            let _e10 = self.v_covector(at_78, _e4.facet);
            local_57 = _e10.dot(view_20).elementwise_ge(rt::Scalar(0f32));
        } else {
            local_57 = rt::Scalar(true);
        }
        let is_front = local_57;
        let side_9 = rt::Scalar(-1f32).select(rt::Scalar(1f32), is_front);
        let _e20 = self.v_covector(at_78, _e4.normal);
        let _e23 = self.v_one_seen((_e20.normalize() * side_9));
        return _e23;
    }
    pub(crate) fn field_motif_patch_normal(
        &self,
        at_79: Entered,
        hit_22: Hit,
        params_56: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_field_motif_patch_normal(at_79, hit_22, rt::into(params_56)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_motif_patch_normal(
        &self,
        at_79: Entered,
        hit_22: Hit,
        params_56: rt::Vec4<f32>,
    ) -> rt::Vec3<f32> {
        let _e3 = self.v_motif_of(hit_22);
        let _e5 = self.v_covector(at_79, _e3.facet);
        return _e5.normalize();
    }
    pub(crate) fn normal_of_field(&self, at_80: Entered, hit_23: Hit) -> rt::Vec3<f32> {
        rt::into(self.v_normal_of_field(at_80, hit_23))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_normal_of_field(&self, at_80: Entered, hit_23: Hit) -> rt::Vec3<f32> {
        let mut local_58: rt::Scalar<bool>;

        let _e5 = self.v_voxel_place(<rt::Vec3<f32>>::new_21(hit_23.uv, rt::Scalar(hit_23.height)));
        let _e6 = self.v_field_at_voxel(_e5);
        if rt::Scalar::into_branch_condition(_e6.elementwise_gt(rt::Scalar(0.51f32))) {
            return at_80.normal;
        }
        let _e10 = self.v_field_slopes(_e5);
        let _e11 = self.v_volume_size();
        let _e13 = self.v_covector(at_80, (_e10 * _e11));
        let steepness_1 = _e13.length();
        if rt::Scalar::into_branch_condition(steepness_1.elementwise_gt(rt::Scalar(0f32))) {
            local_58 = steepness_1.elementwise_lt(rt::Scalar(300000000000000000000000000000000000000f32));
        } else {
            local_58 = rt::Scalar(false);
        }
        let _e22 = local_58;
        if rt::Scalar::into_branch_condition(_e22) {
            return (_e13 * (rt::Scalar(-1f32) / steepness_1));
        }
        return at_80.normal;
    }
    pub(crate) fn field_volume_normals(
        &self,
        at_81: Entered,
        hit_24: Hit,
        view_21: impl rt::Into<rt::Vec3<f32>>,
        params_57: impl rt::Into<rt::Vec4<f32>>,
    ) -> SeenNormals {
        rt::into(self.v_field_volume_normals(at_81, hit_24, rt::into(view_21), rt::into(params_57)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_volume_normals(
        &self,
        at_81: Entered,
        hit_24: Hit,
        view_21: rt::Vec3<f32>,
        params_57: rt::Vec4<f32>,
    ) -> SeenNormals {
        let _e4 = self.v_normal_of_field(at_81, hit_24);
        let _e5 = self.v_one_seen(_e4);
        return _e5;
    }
    pub(crate) fn field_normals_stage(
        &self,
        at_82: Entered,
        hit_25: Hit,
        view_22: impl rt::Into<rt::Vec3<f32>>,
    ) -> SeenNormals {
        rt::into(self.v_field_normals_stage(at_82, hit_25, rt::into(view_22)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_field_normals_stage(
        &self,
        at_82: Entered,
        hit_25: Hit,
        view_22: rt::Vec3<f32>,
    ) -> SeenNormals {
        let _e7 = rt::Scalar(self.surface_settings.choices[4usize].number);
        match rt::Scalar::into_inner(_e7) {
            0u32 => {
                let _e12 = self.surface_settings.choices[4usize].params;
                let _e13 = self.v_field_heights_normals(at_82, hit_25, view_22, _e12);
                return _e13;
            }
            1u32 => {
                let _e18 = self.surface_settings.choices[4usize].params;
                let _e19 = self.v_field_volume_normals(at_82, hit_25, view_22, _e18);
                return _e19;
            }
            _ => {
                let _e24 = self.surface_settings.choices[4usize].params;
                let _e25 = self.v_field_motif_normals(at_82, hit_25, view_22, _e24);
                return _e25;
            }
        }
    }
    pub(crate) fn field_volume_patch_normal(
        &self,
        at_83: Entered,
        hit_26: Hit,
        params_58: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_field_volume_patch_normal(at_83, hit_26, rt::into(params_58)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_field_volume_patch_normal(
        &self,
        at_83: Entered,
        hit_26: Hit,
        params_58: rt::Vec4<f32>,
    ) -> rt::Vec3<f32> {
        let _e3 = self.v_normal_of_field(at_83, hit_26);
        return _e3;
    }
    pub(crate) fn field_patch_normal_stage(&self, at_84: Entered, hit_27: Hit) -> rt::Vec3<f32> {
        rt::into(self.v_field_patch_normal_stage(at_84, hit_27))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_field_patch_normal_stage(&self, at_84: Entered, hit_27: Hit) -> rt::Vec3<f32> {
        let _e6 = rt::Scalar(self.surface_settings.choices[4usize].number);
        match rt::Scalar::into_inner(_e6) {
            0u32 => {
                let _e11 = self.surface_settings.choices[4usize].params;
                let _e12 = self.v_field_heights_patch_normal(at_84, hit_27, _e11);
                return _e12;
            }
            1u32 => {
                let _e17 = self.surface_settings.choices[4usize].params;
                let _e18 = self.v_field_volume_patch_normal(at_84, hit_27, _e17);
                return _e18;
            }
            _ => {
                let _e23 = self.surface_settings.choices[4usize].params;
                let _e24 = self.v_field_motif_patch_normal(at_84, hit_27, _e23);
                return _e24;
            }
        }
    }
    pub(crate) fn miss(&self, cost_2: impl rt::Into<rt::Vec3<u32>>) -> Hit {
        rt::into(self.v_miss(rt::into(cost_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_miss(&self, cost_2: rt::Vec3<u32>) -> Hit {
        return <Hit>::new(rt::Scalar(0u32), rt::Scalar(0u32), <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)), rt::Scalar(0f32), rt::Scalar(0f32), cost_2);
    }
    pub(crate) fn surface_plane_segment(
        &self,
        pixel_47: PixelIn,
        at_85: Entered,
        k_8: impl rt::Into<rt::Scalar<u32>>,
        params_59: impl rt::Into<rt::Vec4<f32>>,
    ) -> Path {
        rt::into(self.v_surface_plane_segment(pixel_47, at_85, rt::into(k_8), rt::into(params_59)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_plane_segment(
        &self,
        pixel_47: PixelIn,
        at_85: Entered,
        k_8: rt::Scalar<u32>,
        params_59: rt::Vec4<f32>,
    ) -> Path {
        let mut enter: rt::Scalar<f32>;
        let mut leave_4: rt::Scalar<f32>;
        let mut interval_5: rt::Vec2<f32>;

        let along_32 = pixel_47.direction.length();
        let direction_8 = (pixel_47.direction / rt::Vec3::splat_from_scalar(along_32));
        let _e9 = self.v_climb(at_85, direction_8);
        let duv_5 = _e9.xy();
        let _e13 = rt::Scalar(self.surface_settings.scale_m);
        let is_flat = _e13.elementwise_eq(rt::Scalar(0f32));
        let descent_3 = (rt::Scalar(0f32) - at_85.normal.dot(direction_8)).max(rt::Scalar(-300000000000000000000000000000000000000f32).select(rt::Scalar(0.001f32), is_flat));
        let _e24 = self.v_traced_scale_m();
        let _e25 = self.v_base_height();
        let slope_12 = ((rt::Scalar(0f32) - descent_3) / _e24);
        let _e29 = self.v_plane_normal(pixel_47);
        let _e30 = self.v_plane_distance(pixel_47, _e29);
        let distance = (_e30 * along_32);
        let eye_3 = (rt::Scalar(0f32) - distance);
        let top_8 = (((_e25 - rt::Scalar(1f32)) * _e24) / descent_3);
        enter = top_8.max(eye_3);
        leave_4 = ((_e25 * _e24) / descent_3);
        let _e43 = leave_4;
        let _e44 = leave_4;
        leave_4 = (_e43 + ((_e44 - top_8) * rt::Scalar(0.000001f32)));
        let _e51 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e51.elementwise_eq(WRAP_CLAMP)) {
            let _e57 = enter;
            let _e58 = leave_4;
            let _e60 = self.v_inside_unit(at_85.uv.x(), duv_5.x(), <rt::Vec2<f32>>::from_scalars(_e57, _e58));
            interval_5 = _e60;
            let _e65 = interval_5;
            let _e66 = self.v_inside_unit(at_85.uv.y(), duv_5.y(), _e65);
            interval_5 = _e66;
            let _e68 = interval_5.x();
            enter = _e68;
            let _e70 = interval_5.y();
            leave_4 = _e70;
        }
        let _e71 = enter;
        let _e74 = enter;
        let entry_height = (_e25 + (slope_12 * _e71)).select(rt::Scalar(1f32), _e74.elementwise_eq(top_8));
        let _e78 = enter;
        let base_2 = (rt::Scalar(0f32) - _e78).clamp(rt::Scalar(-300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32));
        let _e85 = enter;
        let _e90 = leave_4;
        let _e91 = enter;
        let _e96 = enter;
        return <Path>::new((at_85.uv + (duv_5 * _e85)), duv_5, <rt::Vec3<f32>>::from_scalars(entry_height, slope_12, rt::Scalar(0f32)), (_e90 - _e91), base_2, at_85.metric, RAY_VIEW, rt::Scalar(at_85.level), (distance + _e96), rt::Scalar(1f32), rt::Scalar(0f32));
    }
    pub(crate) fn folded_segment(
        &self,
        pixel_48: PixelIn,
        at_86: Entered,
        k_9: impl rt::Into<rt::Scalar<u32>>,
        params_60: impl rt::Into<rt::Vec4<f32>>,
    ) -> Path {
        rt::into(self.v_folded_segment(pixel_48, at_86, rt::into(k_9), rt::into(params_60)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_folded_segment(
        &self,
        pixel_48: PixelIn,
        at_86: Entered,
        k_9: rt::Scalar<u32>,
        params_60: rt::Vec4<f32>,
    ) -> Path {
        let mut a_17: WayPoint;
        let mut b_17: WayPoint;
        let mut path_33: Path;
        let mut local_59: rt::Scalar<bool>;

        let along_33 = pixel_48.direction.normalize();
        let _e6 = self.v_middle_of(pixel_48, along_33);
        let _e7 = self.v_prism_of(pixel_48, along_33, _e6, params_60);
        let _e8 = self.v_shell_slack(pixel_48, _e6);
        let _e9 = self.v_way_of(pixel_48, _e7, along_33);
        let _e10 = self.v_way_offsets(pixel_48, _e7, _e8);
        let _e11 = self.v_chord_reach(pixel_48, at_86, _e6, params_60);
        let _e12 = self.v_way_beyond(_e7, _e10, _e11);
        let _e14 = self.v_way_chord(pixel_48, _e7, along_33, _e9, _e10, _e12, params_60.x(), k_9);
        let _e16 = self.v_before_turn(_e7, along_33, _e9, _e14.offsets);
        let _e18 = self.v_way_point(_e7, along_33, _e9, _e16.x());
        a_17 = _e18;
        let _e25 = self.v_way_point(_e7, along_33, _e9, (rt::Scalar(0.5f32) * (_e16.x() + _e16.y())));
        let _e27 = self.v_way_point(_e7, along_33, _e9, _e16.y());
        b_17 = _e27;
        let _e30 = rt::Scalar(b_17.t);
        let _e32 = rt::Scalar(a_17.t);
        if rt::Scalar::into_branch_condition(_e30.elementwise_lt(_e32)) {
            let turned_2 = b_17;
            let _e35 = a_17;
            b_17 = _e35;
            a_17 = turned_2;
        }
        let _e38 = rt::Scalar(a_17.t);
        let _e41 = rt::Scalar(b_17.t);
        let _e43 = rt::Scalar(a_17.t);
        let part_29 = ((rt::Scalar(_e25.t) - _e38) / (_e41 - _e43));
        let _e48 = rt::Scalar(a_17.point.height);
        let _e53 = rt::Scalar(b_17.point.height);
        let _e54 = self.v_way_bend(_e48, rt::Scalar(_e25.point.height), _e53, part_29);
        let _e56 = a_17.point;
        let _e58 = b_17.point;
        let _e60 = rt::Scalar(a_17.t);
        let _e62 = rt::Scalar(b_17.t);
        let _e64 = self.v_chord_path(pixel_48, at_86, _e6, params_60, _e56, _e58, _e54, <rt::Vec2<f32>>::from_scalars(_e60, _e62), _e12);
        path_33 = _e64;
        let _e67 = rt::Scalar(a_17.beside);
        if rt::Scalar::into_branch_condition((!(!_e67.elementwise_lt((rt::Scalar(4f32) * _e8))))) {
            let _e76 = rt::Scalar(b_17.beside);
            local_59 = (!_e76.elementwise_lt((rt::Scalar(4f32) * _e8)));
        } else {
            local_59 = rt::Scalar(true);
        }
        let _e82 = local_59;
        if rt::Scalar::into_branch_condition(_e82) {
            rt::Scalar(path_33.exit) = rt::Scalar(0f32);
        }
        let _e85 = path_33;
        return _e85;
    }
    pub(crate) fn surface_prism_segment(
        &self,
        pixel_49: PixelIn,
        at_87: Entered,
        k_10: impl rt::Into<rt::Scalar<u32>>,
        params_61: impl rt::Into<rt::Vec4<f32>>,
    ) -> Path {
        rt::into(self.v_surface_prism_segment(pixel_49, at_87, rt::into(k_10), rt::into(params_61)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_prism_segment(
        &self,
        pixel_49: PixelIn,
        at_87: Entered,
        k_10: rt::Scalar<u32>,
        params_61: rt::Vec4<f32>,
    ) -> Path {
        if rt::Scalar::into_branch_condition(rt::Scalar(pixel_49.shell.order).elementwise_ge(SHELL_FOLDED)) {
            let _e8 = self.v_folded_segment(pixel_49, at_87, k_10, params_61);
            return _e8;
        }
        let along_34 = pixel_49.direction.normalize();
        let _e11 = self.v_middle_of(pixel_49, along_34);
        let _e12 = self.v_prism_of(pixel_49, along_34, _e11, params_61);
        let heights_2 = pixel_49.shell.heights;
        let mean_13 = (rt::Scalar(0.5f32) * (heights_2.x() + heights_2.y()));
        let _e20 = self.v_chord_end(at_87, k_10);
        let _e23 = self.v_chord_end(at_87, (k_10 + rt::Scalar(1u32)));
        let _e25 = self.v_shell_point(_e12, (along_34 * _e20), mean_13);
        let _e27 = self.v_shell_point(_e12, (along_34 * _e23), mean_13);
        let _e32 = self.v_between(_e25, _e27);
        let _e33 = self.v_shell_point_from(_e12, (along_34 * (rt::Scalar(0.5f32) * (_e20 + _e23))), _e32);
        let bend_8 = (rt::Scalar(2f32) * ((rt::Scalar(_e25.height) + rt::Scalar(_e27.height)) - (rt::Scalar(2f32) * rt::Scalar(_e33.height))));
        let _e56 = self.v_chord_reach(pixel_49, at_87, _e11, params_61);
        let beyond_6 = (<rt::Vec3<f32>>::from_scalars((_e12.p2_ - _e12.p1_).length(), (_e12.p0_ - _e12.p2_).length(), (_e12.p1_ - _e12.p0_).length()) * (_e56 / (_e12.p1_ - _e12.p0_).cross((_e12.p2_ - _e12.p0_)).length()));
        let _e68 = self.v_chord_path(pixel_49, at_87, _e11, params_61, _e25, _e27, bend_8, <rt::Vec2<f32>>::from_scalars(_e20, _e23), beyond_6);
        return _e68;
    }
    pub(crate) fn surface_quadric_perpendicular_segment(
        &self,
        pixel_50: PixelIn,
        at_88: Entered,
        k_11: impl rt::Into<rt::Scalar<u32>>,
        params_62: impl rt::Into<rt::Vec4<f32>>,
    ) -> Path {
        rt::into(self.v_surface_quadric_perpendicular_segment(pixel_50, at_88, rt::into(k_11), rt::into(params_62)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_quadric_perpendicular_segment(
        &self,
        pixel_50: PixelIn,
        at_88: Entered,
        k_11: rt::Scalar<u32>,
        params_62: rt::Vec4<f32>,
    ) -> Path {
        let mut begin_5: rt::Scalar<f32>;
        let mut end_3: rt::Scalar<f32>;
        let mut local_60: rt::Scalar<bool>;
        let mut path_34: Path;
        let mut inside_2: rt::Vec2<f32>;

        let along_35 = pixel_50.direction.length();
        let _e9 = self.v_across_of(at_88, (pixel_50.direction / rt::Vec3::splat_from_scalar(along_35)));
        let _e10 = self.v_traced_scale_m();
        let _e11 = self.v_plane_normal(pixel_50);
        let _e12 = self.v_plane_distance(pixel_50, _e11);
        let distance_1 = (_e12 * along_35);
        let whole_1 = (at_88.span.y() - at_88.span.x());
        let first_23 = (at_88.span.x() + (whole_1 * (k_11.to_f32() / params_62.z())));
        let last_12 = (at_88.span.x() + (whole_1 * ((k_11 + rt::Scalar(1u32)).to_f32() / params_62.z())));
        let long_4 = (last_12 - first_23);
        let _e38 = self.v_across_depth(_e9, first_23);
        begin_5 = (at_88.of_surface.w() - (_e38 / _e10));
        if rt::Scalar::into_branch_condition(k_11.elementwise_eq(rt::Scalar(0u32))) {
            let _e44 = begin_5;
            begin_5 = _e44.min(rt::Scalar(1f32));
        }
        let _e52 = self.v_across_depth(_e9, (rt::Scalar(0.5f32) * (first_23 + last_12)));
        let middle_15 = (at_88.of_surface.w() - (_e52 / _e10));
        let _e57 = self.v_across_depth(_e9, last_12);
        end_3 = (at_88.of_surface.w() - (_e57 / _e10));
        if rt::Scalar::into_branch_condition((k_11 + rt::Scalar(1u32)).elementwise_eq(params_62.z().to_u32())) {
            let _e68 = end_3;
            local_60 = _e68.elementwise_lt(rt::Scalar(0.5f32));
        } else {
            local_60 = rt::Scalar(false);
        }
        let _e72 = local_60;
        if rt::Scalar::into_branch_condition(_e72) {
            let _e73 = end_3;
            end_3 = _e73.min(rt::Scalar(-0.000001f32));
        }
        let _e76 = begin_5;
        let _e77 = end_3;
        let bend_9 = (rt::Scalar(2f32) * ((_e76 + _e77) - (rt::Scalar(2f32) * middle_15)));
        let _e84 = end_3;
        let _e85 = begin_5;
        let slope_13 = ((_e84 - _e85) - bend_9);
        let base_3 = (rt::Scalar(0f32) - first_23).clamp(rt::Scalar(-300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32));
        let _e98 = begin_5;
        path_34 = <Path>::new((at_88.uv + (_e9.duv * first_23)), _e9.duv, <rt::Vec3<f32>>::from_scalars(_e98, (slope_13 / long_4), (bend_9 / (long_4 * long_4))), long_4, base_3, at_88.metric, RAY_VIEW, rt::Scalar(at_88.level), (distance_1 + first_23), (rt::Scalar(1f32) / params_62.z()), rt::Scalar(0f32));
        inside_2 = <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), long_4);
        let _e118 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e118.elementwise_eq(WRAP_CLAMP)) {
            let _e123 = path_34.uv.x();
            let _e126 = inside_2;
            let _e127 = self.v_inside_unit(_e123, _e9.duv.x(), _e126);
            inside_2 = _e127;
            let _e130 = path_34.uv.y();
            let _e133 = inside_2;
            let _e134 = self.v_inside_unit(_e130, _e9.duv.y(), _e133);
            inside_2 = _e134;
            let _e137 = inside_2.y();
            rt::Scalar(path_34.exit) = _e137;
            let _e138 = path_34;
            let _e140 = inside_2.x();
            let _e141 = self.v_path_from(_e138, _e140);
            path_34 = _e141;
        }
        let _e143 = rt::Scalar(path_34.exit);
        if rt::Scalar::into_branch_condition((!_e143.elementwise_gt(rt::Scalar(0f32)))) {
            rt::Scalar(path_34.exit) = rt::Scalar(0f32);
        }
        let _e149 = path_34;
        return _e149;
    }
    pub(crate) fn surface_quadric_vertical_segment(
        &self,
        pixel_51: PixelIn,
        at_89: Entered,
        k_12: impl rt::Into<rt::Scalar<u32>>,
        params_63: impl rt::Into<rt::Vec4<f32>>,
    ) -> Path {
        rt::into(self.v_surface_quadric_vertical_segment(pixel_51, at_89, rt::into(k_12), rt::into(params_63)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_quadric_vertical_segment(
        &self,
        pixel_51: PixelIn,
        at_89: Entered,
        k_12: rt::Scalar<u32>,
        params_63: rt::Vec4<f32>,
    ) -> Path {
        let mut local_61: rt::Scalar<bool>;
        let mut local_62: rt::Scalar<bool>;
        let mut enter_1: rt::Scalar<f32>;
        let mut leave_5: rt::Scalar<f32>;
        let mut interval_6: rt::Vec2<f32>;
        let mut path_35: Path;
        let mut local_63: rt::Scalar<bool>;

        let along_36 = pixel_51.direction.length();
        let direction_9 = (pixel_51.direction / rt::Vec3::splat_from_scalar(along_36));
        let _e9 = self.v_climb(at_89, direction_9);
        let duv_6 = _e9.xy();
        let descent_4 = (rt::Scalar(0f32) - at_89.normal.dot(direction_9));
        let _e15 = self.v_traced_scale_m();
        let height_23 = at_89.of_surface.w();
        let slope_14 = ((rt::Scalar(0f32) - descent_4) / _e15);
        let _e23 = self.v_quadric_at(at_89.of_surface.xyz(), duv_6);
        let curve = ((rt::Scalar(0f32) - _e23) / _e15);
        let _e27 = self.v_plane_normal(pixel_51);
        let _e28 = self.v_plane_distance(pixel_51, _e27);
        let distance_2 = (_e28 * along_36);
        let eye_4 = (rt::Scalar(0f32) - distance_2);
        let _e35 = self.v_bent_descent(((height_23 - rt::Scalar(1f32)) * _e15), descent_4, _e23);
        if rt::Scalar::into_branch_condition(_e35.elementwise_lt(rt::Scalar(300000000000000000000000000000000000000f32))) {
            if rt::Scalar::into_branch_condition((!height_23.elementwise_lt(rt::Scalar(1f32)))) {
                local_62 = _e35.elementwise_ge(rt::Scalar(0f32));
            } else {
                local_62 = rt::Scalar(true);
            }
            let _e48 = local_62;
            local_61 = _e48;
        } else {
            local_61 = rt::Scalar(false);
        }
        let comes_down = local_61;
        enter_1 = _e35.max(eye_4);
        let _e53 = enter_1;
        let _e54 = enter_1;
        let _e59 = enter_1;
        let begin_11 = (height_23 + (_e53 * (slope_14 + (curve * _e54)))).select(rt::Scalar(1f32), _e59.elementwise_eq(_e35));
        let _e63 = enter_1;
        let _e66 = enter_1;
        let _e70 = self.v_bent_exit(<rt::Vec3<f32>>::from_scalars(begin_11, (slope_14 + ((rt::Scalar(2f32) * curve) * _e66)), curve));
        leave_5 = (_e63 + _e70);
        if rt::Scalar::into_branch_condition(_e23.elementwise_eq(rt::Scalar(0f32))) {
            leave_5 = ((height_23 * _e15) / descent_4);
            let _e77 = leave_5;
            let _e78 = leave_5;
            leave_5 = (_e77 + ((_e78 - _e35) * rt::Scalar(0.000001f32)));
        }
        let _e85 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e85.elementwise_eq(WRAP_CLAMP)) {
            let _e91 = enter_1;
            let _e92 = leave_5;
            let _e94 = self.v_inside_unit(at_89.uv.x(), duv_6.x(), <rt::Vec2<f32>>::from_scalars(_e91, _e92));
            interval_6 = _e94;
            let _e99 = interval_6;
            let _e100 = self.v_inside_unit(at_89.uv.y(), duv_6.y(), _e99);
            interval_6 = _e100;
            let _e102 = interval_6.x();
            enter_1 = _e102;
            let _e104 = interval_6.y();
            leave_5 = _e104;
        }
        let _e105 = enter_1;
        let _e106 = enter_1;
        let _e111 = enter_1;
        let entry_height_1 = (height_23 + (_e105 * (slope_14 + (curve * _e106)))).select(rt::Scalar(1f32), _e111.elementwise_eq(_e35));
        let _e115 = enter_1;
        let base_4 = (rt::Scalar(0f32) - _e115).clamp(rt::Scalar(-300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32));
        let _e122 = enter_1;
        let _e127 = enter_1;
        let _e131 = leave_5;
        let _e132 = enter_1;
        let _e137 = enter_1;
        path_35 = <Path>::new((at_89.uv + (duv_6 * _e122)), duv_6, <rt::Vec3<f32>>::from_scalars(entry_height_1, (slope_14 + ((rt::Scalar(2f32) * curve) * _e127)), curve), (_e131 - _e132), base_4, at_89.metric, RAY_VIEW, rt::Scalar(at_89.level), (distance_2 + _e137), rt::Scalar(1f32), rt::Scalar(0f32));
        if rt::Scalar::into_branch_condition((!(!comes_down))) {
            let _e148 = rt::Scalar(path_35.exit);
            local_63 = (!_e148.elementwise_gt(rt::Scalar(0f32)));
        } else {
            local_63 = rt::Scalar(true);
        }
        let _e153 = local_63;
        if rt::Scalar::into_branch_condition(_e153) {
            rt::Scalar(path_35.exit) = rt::Scalar(0f32);
        }
        let _e156 = path_35;
        return _e156;
    }
    pub(crate) fn surface_tetrahedra_segment(
        &self,
        pixel_52: PixelIn,
        at_90: Entered,
        k_13: impl rt::Into<rt::Scalar<u32>>,
        params_64: impl rt::Into<rt::Vec4<f32>>,
    ) -> Path {
        rt::into(self.v_surface_tetrahedra_segment(pixel_52, at_90, rt::into(k_13), rt::into(params_64)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_tetrahedra_segment(
        &self,
        pixel_52: PixelIn,
        at_90: Entered,
        k_13: rt::Scalar<u32>,
        params_64: rt::Vec4<f32>,
    ) -> Path {
        let mut chosen_1: Tetrahedron;
        let mut inside_3: rt::Vec2<f32>;
        let mut path_36: Path;

        let along_37 = pixel_52.direction.normalize();
        let _e6 = self.v_middle_of(pixel_52, along_37);
        let _e8 = self.v_tetrahedron(pixel_52, along_37, _e6, rt::Scalar(0u32));
        let _e10 = self.v_tetrahedron(pixel_52, along_37, _e6, rt::Scalar(1u32));
        let _e12 = self.v_tetrahedron(pixel_52, along_37, _e6, rt::Scalar(2u32));
        let _e15 = self.v_comes_before(_e8.inside, _e10.inside);
        let _e18 = self.v_comes_before(_e8.inside, _e12.inside);
        let _e21 = self.v_comes_before(_e10.inside, _e12.inside);
        chosen_1 = _e8;
        if rt::Scalar::into_branch_condition((_e15 + (rt::Scalar(1u32) - _e21)).elementwise_eq(k_13)) {
            chosen_1 = _e10;
        }
        if rt::Scalar::into_branch_condition((_e18 + _e21).elementwise_eq(k_13)) {
            chosen_1 = _e12;
        }
        let _e30 = self.v_ordered(pixel_52, rt::Scalar(0u32));
        let _e32 = self.v_ordered(pixel_52, rt::Scalar(1u32));
        let _e34 = self.v_ordered(pixel_52, rt::Scalar(2u32));
        let w_4 = chosen_1.weights;
        let g = chosen_1.change;
        let uv_44 = (((_e30.uv * w_4.x()) + (_e32.uv * w_4.y())) + (_e34.uv * w_4.z()));
        let duv_7 = (((_e30.uv * g.x()) + (_e32.uv * g.y())) + (_e34.uv * g.z()));
        let _e61 = self.v_shell_slack(pixel_52, _e6);
        let beyond_7 = (rt::Scalar(0.000001f32) + (_e61 * g.w().abs()));
        let _e68 = chosen_1.inside;
        inside_3 = _e68;
        let _e70 = inside_3;
        let _e77 = self.v_where_positive(_e70, (w_4.w() - pixel_52.shell.heights.x()), g.w(), beyond_7);
        inside_3 = _e77;
        let _e78 = inside_3;
        let _e87 = self.v_where_positive(_e78, (pixel_52.shell.heights.y() - w_4.w()), (rt::Scalar(0f32) - g.w()), beyond_7);
        inside_3 = _e87;
        let _e90 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e90.elementwise_eq(WRAP_CLAMP)) {
            let _e95 = inside_3;
            let _e96 = self.v_inside_unit(uv_44.x(), duv_7.x(), _e95);
            inside_3 = _e96;
            let _e99 = inside_3;
            let _e100 = self.v_inside_unit(uv_44.y(), duv_7.y(), _e99);
            inside_3 = _e100;
        }
        let whole_2 = (((_e8.inside.y() - _e8.inside.x()).max(rt::Scalar(0f32)) + (_e10.inside.y() - _e10.inside.x()).max(rt::Scalar(0f32))) + (_e12.inside.y() - _e12.inside.x()).max(rt::Scalar(0f32)));
        let _e125 = inside_3.x();
        let _e131 = inside_3.x();
        let _e138 = inside_3.y();
        let _e140 = inside_3.x();
        let _e146 = inside_3.x();
        let _e149 = inside_3.y();
        let _e151 = inside_3.x();
        path_36 = <Path>::new((uv_44 + (duv_7 * _e125)), duv_7, <rt::Vec3<f32>>::from_scalars((w_4.w() + (g.w() * _e131)), g.w(), rt::Scalar(0f32)), (_e138 - _e140), rt::Scalar(0f32), at_90.metric, RAY_VIEW, rt::Scalar(at_90.level), (_e6 + _e146), ((_e149 - _e151) / whole_2), rt::Scalar(0f32));
        let _e159 = rt::Scalar(path_36.exit);
        if rt::Scalar::into_branch_condition(_e159.elementwise_gt(rt::Scalar(0f32))) {
            let _e162 = path_36;
            let _e163 = path_36;
            let _e167 = self.v_out_of_ground(_e163, (rt::Scalar(4f32) * _e61), rt::Scalar(0f32));
            let _e168 = self.v_path_from(_e162, _e167);
            path_36 = _e168;
        }
        let _e169 = path_36;
        return _e169;
    }
    pub(crate) fn surface_facets_segment(
        &self,
        pixel_53: PixelIn,
        at_91: Entered,
        k_14: impl rt::Into<rt::Scalar<u32>>,
        params_65: impl rt::Into<rt::Vec4<f32>>,
    ) -> Path {
        rt::into(self.v_surface_facets_segment(pixel_53, at_91, rt::into(k_14), rt::into(params_65)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_facets_segment(
        &self,
        pixel_53: PixelIn,
        at_91: Entered,
        k_14: rt::Scalar<u32>,
        params_65: rt::Vec4<f32>,
    ) -> Path {
        let _e4 = self.v_plane_normal(pixel_53);
        let _e5 = self.v_triangle_distance(pixel_53, _e4);
        let start_6 = (_e5 * pixel_53.direction.length());
        let _e11 = self.v_height_at(at_91.uv, rt::Scalar(at_91.level));
        let duv_8 = <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32));
        let h_10 = <rt::Vec3<f32>>::from_scalars(_e11, rt::Scalar(0f32), rt::Scalar(0f32));
        return <Path>::new(at_91.uv, duv_8, h_10, rt::Scalar(1f32), rt::Scalar(0f32), at_91.metric, RAY_VIEW, rt::Scalar(at_91.level), start_6, rt::Scalar(1f32), rt::Scalar(0f32));
    }
    pub(crate) fn slice_inside(
        &self,
        map_1: impl rt::Into<rt::Scalar<f32>>,
        slice_2: impl rt::Into<rt::Scalar<f32>>,
        spacing: impl rt::Into<rt::Scalar<f32>>,
        params_66: impl rt::Into<rt::Vec4<f32>>,
    ) -> bool {
        rt::into(self.v_slice_inside(rt::into(map_1), rt::into(slice_2), rt::into(spacing), rt::into(params_66)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_slice_inside(
        &self,
        map_1: rt::Scalar<f32>,
        slice_2: rt::Scalar<f32>,
        spacing: rt::Scalar<f32>,
        params_66: rt::Vec4<f32>,
    ) -> rt::Scalar<bool> {
        return map_1.elementwise_gt(slice_2);
    }
    pub(crate) fn slice_at_least(
        &self,
        map_2: impl rt::Into<rt::Scalar<f32>>,
        slice_3: impl rt::Into<rt::Scalar<f32>>,
        spacing_1: impl rt::Into<rt::Scalar<f32>>,
        params_67: impl rt::Into<rt::Vec4<f32>>,
    ) -> bool {
        rt::into(self.v_slice_at_least(rt::into(map_2), rt::into(slice_3), rt::into(spacing_1), rt::into(params_67)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_slice_at_least(
        &self,
        map_2: rt::Scalar<f32>,
        slice_3: rt::Scalar<f32>,
        spacing_1: rt::Scalar<f32>,
        params_67: rt::Vec4<f32>,
    ) -> rt::Scalar<bool> {
        return map_2.elementwise_ge(slice_3);
    }
    pub(crate) fn slice_band(
        &self,
        map_3: impl rt::Into<rt::Scalar<f32>>,
        slice_4: impl rt::Into<rt::Scalar<f32>>,
        spacing_2: impl rt::Into<rt::Scalar<f32>>,
        params_68: impl rt::Into<rt::Vec4<f32>>,
    ) -> bool {
        rt::into(self.v_slice_band(rt::into(map_3), rt::into(slice_4), rt::into(spacing_2), rt::into(params_68)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_slice_band(
        &self,
        map_3: rt::Scalar<f32>,
        slice_4: rt::Scalar<f32>,
        spacing_2: rt::Scalar<f32>,
        params_68: rt::Vec4<f32>,
    ) -> rt::Scalar<bool> {
        return (map_3 - slice_4).abs().elementwise_le((rt::Scalar(0.5f32) * spacing_2));
    }
    pub(crate) fn slices_stage(
        &self,
        map_4: impl rt::Into<rt::Scalar<f32>>,
        slice_5: impl rt::Into<rt::Scalar<f32>>,
        spacing_3: impl rt::Into<rt::Scalar<f32>>,
    ) -> bool {
        rt::into(self.v_slices_stage(rt::into(map_4), rt::into(slice_5), rt::into(spacing_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_slices_stage(
        &self,
        map_4: rt::Scalar<f32>,
        slice_5: rt::Scalar<f32>,
        spacing_3: rt::Scalar<f32>,
    ) -> rt::Scalar<bool> {
        let _e7 = rt::Scalar(self.surface_settings.choices[2usize].number);
        match rt::Scalar::into_inner(_e7) {
            0u32 => {
                let _e12 = self.surface_settings.choices[2usize].params;
                let _e13 = self.v_slice_inside(map_4, slice_5, spacing_3, _e12);
                return _e13;
            }
            1u32 => {
                let _e18 = self.surface_settings.choices[2usize].params;
                let _e19 = self.v_slice_at_least(map_4, slice_5, spacing_3, _e18);
                return _e19;
            }
            _ => {
                let _e24 = self.surface_settings.choices[2usize].params;
                let _e25 = self.v_slice_band(map_4, slice_5, spacing_3, _e24);
                return _e25;
            }
        }
    }
    pub(crate) fn slice_spacing(
        &self,
        at_92: Entered,
        axis_1: impl rt::Into<rt::Scalar<u32>>,
    ) -> f32 {
        rt::into(self.v_slice_spacing(at_92, rt::into(axis_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_slice_spacing(
        &self,
        at_92: Entered,
        axis_1: rt::Scalar<u32>,
    ) -> rt::Scalar<f32> {
        let step_7 = at_92.of_surface.y();
        if rt::Scalar::into_branch_condition(axis_1.elementwise_eq(SLICES_ALONG_HEIGHT)) {
            return step_7;
        }
        if rt::Scalar::into_branch_condition(axis_1.elementwise_eq(SLICES_ALONG_U)) {
            let _e12 = self.v_traced_scale_m();
            return ((step_7 * at_92.metric.x().sqrt()) / _e12);
        }
        if rt::Scalar::into_branch_condition(axis_1.elementwise_eq(SLICES_ALONG_V)) {
            let _e20 = self.v_traced_scale_m();
            return ((step_7 * at_92.metric.z().sqrt()) / _e20);
        }
        let _e22 = self.v_traced_scale_m();
        return (step_7 / _e22);
    }
    pub(crate) fn slice_above(
        &self,
        pixel_54: PixelIn,
        at_93: Entered,
        along_16: impl rt::Into<rt::Scalar<f32>>,
        far_2: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_slice_above(pixel_54, at_93, rt::into(along_16), rt::into(far_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_slice_above(
        &self,
        pixel_54: PixelIn,
        at_93: Entered,
        along_16: rt::Scalar<f32>,
        far_2: rt::Scalar<f32>,
    ) -> rt::Vec4<f32> {
        let mut local_64: rt::Scalar<bool>;

        let upward = (rt::Scalar(-1f32).select(rt::Scalar(1f32), pixel_54.direction.dot(at_93.normal).elementwise_lt(rt::Scalar(0f32))) * at_93.of_surface.y());
        let _e17 = rt::Scalar(self.surface_settings.scale_m);
        let step_m = (upward * _e17);
        let a_41 = (pixel_54.a.position + (pixel_54.a.normal * step_m));
        let b_41 = (pixel_54.b.position + (pixel_54.b.normal * step_m));
        let c_29 = (pixel_54.c.position + (pixel_54.c.normal * step_m));
        let n_19 = (b_41 - a_41).cross((c_29 - a_41));
        let t_52 = (n_19.dot((a_41 - pixel_54.origin)) / n_19.dot(pixel_54.direction));
        let lead = (far_2 - (t_52 * along_16));
        if rt::Scalar::into_branch_condition(lead.elementwise_gt((far_2 * rt::Scalar(0.0000005f32)))) {
            local_64 = t_52.abs().elementwise_le(rt::Scalar(1000000000f32));
        } else {
            local_64 = rt::Scalar(false);
        }
        let _e57 = local_64;
        if rt::Scalar::into_branch_condition((!_e57)) {
            return <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
        }
        let _e68 = self.v_weights_of(a_41, b_41, c_29, n_19, (pixel_54.origin + (pixel_54.direction * t_52)));
        let aside_6 = ((((pixel_54.a.uv * _e68.x()) + (pixel_54.b.uv * _e68.y())) + (pixel_54.c.uv * _e68.z())) - at_93.uv);
        return <rt::Vec4<f32>>::new_31((<rt::Vec3<f32>>::new_21(aside_6, upward) / rt::Vec3::splat_from_scalar(lead)), lead);
    }
    pub(crate) fn slice_beside(
        &self,
        at_94: Entered,
        climbs: impl rt::Into<rt::Vec3<f32>>,
        pace: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_slice_beside(at_94, rt::into(climbs), rt::into(pace)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_slice_beside(
        &self,
        at_94: Entered,
        climbs: rt::Vec3<f32>,
        pace: rt::Scalar<f32>,
    ) -> rt::Vec4<f32> {
        let mut local_65: rt::Scalar<bool>;

        let up_4 = (at_94.of_surface.x().select((rt::Scalar(1f32) - at_94.of_surface.x()), climbs.z().elementwise_lt(rt::Scalar(0f32))) / climbs.z().abs());
        let lead_1 = (at_94.of_surface.y() / pace).min(rt::Scalar(1000000000f32).select(up_4, climbs.z().abs().elementwise_gt(rt::Scalar(0f32))));
        if rt::Scalar::into_branch_condition(lead_1.elementwise_gt(rt::Scalar(0f32))) {
            local_65 = lead_1.elementwise_le(rt::Scalar(1000000000f32));
        } else {
            local_65 = rt::Scalar(false);
        }
        let _e33 = local_65;
        if rt::Scalar::into_branch_condition((!_e33)) {
            return <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
        }
        return <rt::Vec4<f32>>::new_31((<rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32)) - climbs), lead_1);
    }
    pub(crate) fn slice_before(
        &self,
        pixel_55: PixelIn,
        at_95: Entered,
        axis_2: impl rt::Into<rt::Scalar<u32>>,
        along_17: impl rt::Into<rt::Scalar<f32>>,
        far_3: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_slice_before(pixel_55, at_95, rt::into(axis_2), rt::into(along_17), rt::into(far_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_slice_before(
        &self,
        pixel_55: PixelIn,
        at_95: Entered,
        axis_2: rt::Scalar<u32>,
        along_17: rt::Scalar<f32>,
        far_3: rt::Scalar<f32>,
    ) -> rt::Vec4<f32> {
        if rt::Scalar::into_branch_condition(axis_2.elementwise_eq(SLICES_ALONG_HEIGHT)) {
            let _e7 = self.v_slice_above(pixel_55, at_95, along_17, far_3);
            return _e7;
        }
        let _e11 = self.v_climb(at_95, (pixel_55.direction / rt::Vec3::splat_from_scalar(along_17)));
        if rt::Scalar::into_branch_condition(axis_2.elementwise_eq(SLICES_ALONG_U)) {
            let _e16 = self.v_slice_beside(at_95, _e11, _e11.x().abs());
            return _e16;
        }
        if rt::Scalar::into_branch_condition(axis_2.elementwise_eq(SLICES_ALONG_V)) {
            let _e21 = self.v_slice_beside(at_95, _e11, _e11.y().abs());
            return _e21;
        }
        let _e24 = self.v_slice_beside(at_95, _e11, (rt::Scalar(1f32) / along_17));
        return _e24;
    }
    pub(crate) fn surface_slices_segment(
        &self,
        pixel_56: PixelIn,
        at_96: Entered,
        k_15: impl rt::Into<rt::Scalar<u32>>,
        params_69: impl rt::Into<rt::Vec4<f32>>,
    ) -> Path {
        rt::into(self.v_surface_slices_segment(pixel_56, at_96, rt::into(k_15), rt::into(params_69)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_slices_segment(
        &self,
        pixel_56: PixelIn,
        at_96: Entered,
        k_15: rt::Scalar<u32>,
        params_69: rt::Vec4<f32>,
    ) -> Path {
        let along_38 = pixel_56.direction.length();
        let _e6 = self.v_plane_normal(pixel_56);
        let _e7 = self.v_triangle_distance(pixel_56, _e6);
        let far_13 = (_e7 * along_38);
        let axis_7 = pixel_56.a.of_surface.z().to_u32();
        let height_24 = at_96.of_surface.x();
        let _e17 = self.v_height_at(at_96.uv, rt::Scalar(at_96.level));
        let _e18 = self.v_slice_spacing(at_96, axis_7);
        let _e19 = self.v_slices_stage(_e17, height_24, _e18);
        let _e20 = self.v_slice_before(pixel_56, at_96, axis_7, along_38, far_13);
        let lead_2 = (far_13 * rt::Scalar(0.0000005f32)).select(_e20.w().min(far_13), _e20.w().elementwise_gt(rt::Scalar(0f32)));
        return <Path>::new((at_96.uv + (_e20.xy() * lead_2)), (<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)) - _e20.xy()), <rt::Vec3<f32>>::from_scalars((height_24 + (_e20.z() * lead_2)), (rt::Scalar(0f32) - _e20.z()), rt::Scalar(0f32)), rt::Scalar(0f32).select(lead_2, _e19), lead_2, at_96.metric, RAY_VIEW, rt::Scalar(at_96.level), (far_13 - lead_2), rt::Scalar(1f32), rt::Scalar(0f32));
    }
    pub(crate) fn within_bounds(
        &self,
        x_3: impl rt::Into<rt::Scalar<f32>>,
        dx_2: impl rt::Into<rt::Scalar<f32>>,
        low_1: impl rt::Into<rt::Scalar<f32>>,
        high_1: impl rt::Into<rt::Scalar<f32>>,
        interval_7: impl rt::Into<rt::Vec2<f32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_within_bounds(rt::into(x_3), rt::into(dx_2), rt::into(low_1), rt::into(high_1), rt::into(interval_7)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_within_bounds(
        &self,
        x_3: rt::Scalar<f32>,
        dx_2: rt::Scalar<f32>,
        low_1: rt::Scalar<f32>,
        high_1: rt::Scalar<f32>,
        interval_7: rt::Vec2<f32>,
    ) -> rt::Vec2<f32> {
        let mut local_66: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition(dx_2.elementwise_eq(rt::Scalar(0f32))) {
            if rt::Scalar::into_branch_condition((!x_3.elementwise_lt(low_1))) {
                local_66 = x_3.elementwise_gt(high_1);
            } else {
                local_66 = rt::Scalar(true);
            }
            let _e13 = local_66;
            if rt::Scalar::into_branch_condition(_e13) {
                return <rt::Vec2<f32>>::from_scalars(rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(0f32));
            }
            return interval_7;
        }
        let a_42 = ((low_1 - x_3) / dx_2);
        let b_42 = ((high_1 - x_3) / dx_2);
        return <rt::Vec2<f32>>::from_scalars(interval_7.x().max(a_42.min(b_42)), interval_7.y().min(a_42.max(b_42)));
    }
    pub(crate) fn metric_of_image(
        &self,
        image_8: Image,
        depth_7: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_metric_of_image(image_8, rt::into(depth_7)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_metric_of_image(
        &self,
        image_8: Image,
        depth_7: rt::Scalar<f32>,
    ) -> rt::Vec4<f32> {
        let _e2 = self.v_tangent_of_image(image_8);
        let tangent_5 = (_e2 * depth_7);
        let _e4 = self.v_bitangent_of_image(image_8);
        let bitangent_4 = (_e4 * depth_7);
        let _e11 = rt::Scalar(self.surface_settings.scale_m);
        return <rt::Vec4<f32>>::from_scalars(tangent_5.dot(tangent_5), tangent_5.dot(bitangent_4), bitangent_4.dot(bitangent_4), _e11);
    }
    pub(crate) fn path_through_image(
        &self,
        pixel_57: PixelIn,
        k_16: impl rt::Into<rt::Scalar<u32>>,
    ) -> Path {
        rt::into(self.v_path_through_image(pixel_57, rt::into(k_16)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_path_through_image(
        &self,
        pixel_57: PixelIn,
        k_16: rt::Scalar<u32>,
    ) -> Path {
        let mut begin_6: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut local_67: rt::Scalar<bool>;
        let mut interval_8: rt::Vec2<f32> = <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(300000000000000000000000000000000000000f32));
        let mut height_9: rt::Vec3<f32>;

        let along_39 = pixel_57.direction.normalize();
        let _e4 = self.v_image_of_object(k_16);
        let deepens = _e4.depth.xyz().dot(along_39);
        let _e9 = self.v_depth_in_image(_e4, pixel_57.origin);
        if rt::Scalar::into_branch_condition(rt::Scalar(_e4.has_eye)) {
            let nearest_4 = (rt::Scalar(0.01f32) * rt::Scalar(_e4.nearest));
            begin_6 = rt::Scalar(0f32).select(rt::Scalar(300000000000000000000000000000000000000f32), _e9.elementwise_lt(nearest_4));
            if rt::Scalar::into_branch_condition(_e9.elementwise_lt(nearest_4)) {
                local_67 = deepens.elementwise_gt(rt::Scalar(0f32));
            } else {
                local_67 = rt::Scalar(false);
            }
            let _e26 = local_67;
            if rt::Scalar::into_branch_condition(_e26) {
                begin_6 = ((nearest_4 - _e9) / deepens);
            }
        }
        let _e30 = begin_6;
        let origin_7 = (pixel_57.origin + (along_39 * _e30));
        let _e33 = self.v_depth_in_image(_e4, origin_7);
        let bend_10 = (deepens / _e33);
        let u_3 = ((_e4.u.xyz().dot(origin_7) + _e4.u.w()) / _e33);
        let v_6 = ((_e4.v.xyz().dot(origin_7) + _e4.v.w()) / _e33);
        let h_11 = ((_e4.height.xyz().dot(origin_7) + _e4.height.w()) / _e33);
        let du_1 = ((_e4.u.xyz().dot(along_39) - (u_3 * deepens)) / _e33);
        let dv_1 = ((_e4.v.xyz().dot(along_39) - (v_6 * deepens)) / _e33);
        let dh_1 = ((_e4.height.xyz().dot(along_39) - (h_11 * deepens)) / _e33);
        let _e74 = self.v_beyond_image(_e4);
        let _e85 = interval_8;
        let _e86 = self.v_within_bounds(u_3, du_1, (rt::Scalar(0f32) - _e74.x()), (rt::Scalar(1f32) + _e74.x()), _e85);
        interval_8 = _e86;
        let _e93 = interval_8;
        let _e94 = self.v_within_bounds(v_6, dv_1, (rt::Scalar(0f32) - _e74.y()), (rt::Scalar(1f32) + _e74.y()), _e93);
        interval_8 = _e94;
        let _e97 = interval_8;
        let _e98 = self.v_within_bounds(h_11, dh_1, rt::Scalar(0.00001f32), rt::Scalar(1f32), _e97);
        interval_8 = _e98;
        let start_7 = interval_8.x();
        let nearer = (rt::Scalar(1f32) - (bend_10 * start_7));
        let change_6 = (nearer * nearer);
        height_9 = <rt::Vec3<f32>>::from_scalars((h_11 + (dh_1 * start_7)), (dh_1 * change_6), rt::Scalar(0f32));
        let _e113 = rt::Scalar(self.surface_settings.cells);
        if rt::Scalar::into_branch_condition(_e113.elementwise_eq(CELLS_MASK)) {
            height_9 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0f32), rt::Scalar(0f32));
        }
        let _e133 = height_9;
        let _e135 = interval_8.y();
        let _e140 = self.v_metric_of_image(_e4, (_e33 / nearer));
        let _e143 = begin_6;
        return <Path>::new((_e4.corner + (_e4.extent * <rt::Vec2<f32>>::from_scalars((u_3 + (du_1 * start_7)), (v_6 + (dv_1 * start_7))))), ((_e4.extent * <rt::Vec2<f32>>::from_scalars(du_1, dv_1)) * change_6), _e133, ((_e135 - start_7) / change_6), k_16.to_f32(), _e140, RAY_VIEW, rt::Scalar(0u32), (_e143 + (start_7 / nearer)), rt::Scalar(1f32), (bend_10 * nearer));
    }
    pub(crate) fn surface_object_segment(
        &self,
        pixel_58: PixelIn,
        at_97: Entered,
        k_17: impl rt::Into<rt::Scalar<u32>>,
        params_70: impl rt::Into<rt::Vec4<f32>>,
    ) -> Path {
        rt::into(self.v_surface_object_segment(pixel_58, at_97, rt::into(k_17), rt::into(params_70)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_object_segment(
        &self,
        pixel_58: PixelIn,
        at_97: Entered,
        k_17: rt::Scalar<u32>,
        params_70: rt::Vec4<f32>,
    ) -> Path {
        let _e4 = self.v_path_through_image(pixel_58, k_17);
        return _e4;
    }
    pub(crate) fn surface_frames_segment(
        &self,
        pixel_59: PixelIn,
        at_98: Entered,
        k_18: impl rt::Into<rt::Scalar<u32>>,
        params_71: impl rt::Into<rt::Vec4<f32>>,
    ) -> Path {
        rt::into(self.v_surface_frames_segment(pixel_59, at_98, rt::into(k_18), rt::into(params_71)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_frames_segment(
        &self,
        pixel_59: PixelIn,
        at_98: Entered,
        k_18: rt::Scalar<u32>,
        params_71: rt::Vec4<f32>,
    ) -> Path {
        let _e7 = self.v_frames_around((-pixel_59.direction.normalize()));
        let _e8 = self.v_frame_number(_e7, k_18);
        let _e9 = self.v_path_through_image(pixel_59, _e8);
        return _e9;
    }
    pub(crate) fn on_image(
        &self,
        image_9: Image,
        point_15: impl rt::Into<rt::Vec3<f32>>,
    ) -> OnImage {
        rt::into(self.v_on_image(image_9, rt::into(point_15)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_on_image(
        &self,
        image_9: Image,
        point_15: rt::Vec3<f32>,
    ) -> OnImage {
        let mut local_68: rt::Scalar<bool>;
        let mut local_69: rt::Scalar<bool>;
        let mut local_70: rt::Scalar<bool>;

        let _e2 = self.v_depth_in_image(image_9, point_15);
        let u_4 = ((image_9.u.xyz().dot(point_15) + image_9.u.w()) / _e2);
        let v_7 = ((image_9.v.xyz().dot(point_15) + image_9.v.w()) / _e2);
        let h_12 = ((image_9.height.xyz().dot(point_15) + image_9.height.w()) / _e2);
        let _e24 = self.v_beyond_image(image_9);
        let beside_6 = ((u_4 - rt::Scalar(0.5f32)).abs() - _e24.x()).max(((v_7 - rt::Scalar(0.5f32)).abs() - _e24.y()));
        let uv_45 = (image_9.corner + (image_9.extent * <rt::Vec2<f32>>::from_scalars(u_4, v_7)));
        let _e42 = self.v_height_size(rt::Scalar(0u32));
        let _e49 = self.v_object_parts_stage(rt::Scalar(0u32));
        let at_183 = (((uv_45 * _e42) - <rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32))) * _e49.to_f32());
        let _e52 = self.v_cell_of(at_183);
        let part_30 = (at_183 - _e52);
        let _e56 = self.v_object_cell_stage(_e52.to_i32(), rt::Scalar(0u32));
        let top_9 = (_e56.x() + ((_e56.y() - _e56.x()) * part_30.x()));
        let bottom_5 = (_e56.z() + ((_e56.w() - _e56.z()) * part_30.x()));
        let map_5 = (top_9 + ((bottom_5 - top_9) * part_30.y()));
        if rt::Scalar::into_branch_condition(_e2.elementwise_gt(rt::Scalar(0f32))) {
            local_68 = beside_6.elementwise_le(rt::Scalar(0.5f32));
        } else {
            local_68 = rt::Scalar(false);
        }
        let _e82 = local_68;
        if rt::Scalar::into_branch_condition(_e82) {
            local_69 = h_12.elementwise_gt(rt::Scalar(0.00001f32));
        } else {
            local_69 = rt::Scalar(false);
        }
        let _e88 = local_69;
        if rt::Scalar::into_branch_condition(_e88) {
            local_70 = h_12.elementwise_le(rt::Scalar(1f32));
        } else {
            local_70 = rt::Scalar(false);
        }
        let is_inside_2 = local_70;
        let _e97 = rt::Scalar(self.surface_settings.cells);
        return <OnImage>::new(uv_45, h_12.select(rt::Scalar(0.5f32), _e97.elementwise_eq(CELLS_MASK)), map_5, is_inside_2);
    }
    pub(crate) fn is_in_image(&self, at_99: OnImage) -> bool {
        rt::into(self.v_is_in_image(at_99))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_is_in_image(&self, at_99: OnImage) -> rt::Scalar<bool> {
        let mut local_71: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition(rt::Scalar(at_99.is_inside)) {
            let _e7 = self.v_slices_stage(rt::Scalar(at_99.map), rt::Scalar(at_99.height), rt::Scalar(0f32));
            local_71 = _e7;
        } else {
            local_71 = rt::Scalar(false);
        }
        let _e9 = local_71;
        return _e9;
    }
    pub(crate) fn with_image(
        &self,
        slice_6: OnSlice,
        number_16: impl rt::Into<rt::Scalar<u32>>,
        point_16: impl rt::Into<rt::Vec3<f32>>,
    ) -> OnSlice {
        rt::into(self.v_with_image(slice_6, rt::into(number_16), rt::into(point_16)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_with_image(
        &self,
        slice_6: OnSlice,
        number_16: rt::Scalar<u32>,
        point_16: rt::Vec3<f32>,
    ) -> OnSlice {
        let _e3 = self.v_image_of_object(number_16);
        let _e4 = self.v_on_image(_e3, point_16);
        let over_2 = (rt::Scalar(_e4.map) - rt::Scalar(_e4.height));
        let _e8 = self.v_is_in_image(_e4);
        if rt::Scalar::into_branch_condition(over_2.elementwise_lt(rt::Scalar(slice_6.over))) {
            return <OnSlice>::new(_e8, number_16, _e4, over_2);
        }
        return <OnSlice>::new(_e8, rt::Scalar(slice_6.number), slice_6.nearest, rt::Scalar(slice_6.over));
    }
    pub(crate) fn slice_at(&self, point_17: impl rt::Into<rt::Vec3<f32>>) -> OnSlice {
        rt::into(self.v_slice_at(rt::into(point_17)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_slice_at(&self, point_17: rt::Vec3<f32>) -> OnSlice {
        let mut slice_7: OnSlice = <OnSlice>::new(rt::Scalar(true), rt::Scalar(0u32), <OnImage>::new(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(false)), rt::Scalar(2f32));
        let mut number_17: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut local_72: rt::Scalar<bool>;

        'naga_break: loop {
            'naga_continue: {
                let _e15 = number_17;
                let _e18 = rt::Scalar(self.surface_settings.solids);
                if rt::Scalar::into_branch_condition(_e15.elementwise_lt(_e18)) {
                    let _e23 = rt::Scalar(slice_7.passes);
                    local_72 = _e23;
                } else {
                    local_72 = rt::Scalar(false);
                }
                let _e25 = local_72;
                if rt::Scalar::into_branch_condition(_e25) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e26 = slice_7;
                    let _e27 = number_17;
                    let _e28 = self.v_with_image(_e26, _e27, point_17);
                    slice_7 = _e28;
                    let _e29 = number_17;
                    number_17 = (_e29 + rt::Scalar(1u32));
                }
            }
        }
        let _e32 = slice_7;
        return _e32;
    }
    pub(crate) fn surface_object_slices_segment(
        &self,
        pixel_60: PixelIn,
        at_100: Entered,
        k_19: impl rt::Into<rt::Scalar<u32>>,
        params_72: impl rt::Into<rt::Vec4<f32>>,
    ) -> Path {
        rt::into(self.v_surface_object_slices_segment(pixel_60, at_100, rt::into(k_19), rt::into(params_72)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_object_slices_segment(
        &self,
        pixel_60: PixelIn,
        at_100: Entered,
        k_19: rt::Scalar<u32>,
        params_72: rt::Vec4<f32>,
    ) -> Path {
        let _e5 = self.v_slice_at(at_100.point);
        let _e7 = self.v_image_of_object(rt::Scalar(_e5.number));
        let far_14 = (at_100.point - pixel_60.origin).length();
        let lead_3 = (far_14 * rt::Scalar(0.0000005f32));
        let _e28 = self.v_depth_in_image(_e7, at_100.point);
        let _e29 = self.v_metric_of_image(_e7, _e28);
        return <Path>::new(_e5.nearest.uv, <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)), <rt::Vec3<f32>>::from_scalars(rt::Scalar(_e5.nearest.height), rt::Scalar(0f32), rt::Scalar(0f32)), rt::Scalar(0f32).select(lead_3, rt::Scalar(_e5.passes)), lead_3, _e29, RAY_VIEW, rt::Scalar(0u32), (far_14 - lead_3), rt::Scalar(1f32), rt::Scalar(0f32));
    }
    pub(crate) fn surface_segment_stage(
        &self,
        pixel_61: PixelIn,
        at_101: Entered,
        k_20: impl rt::Into<rt::Scalar<u32>>,
    ) -> Path {
        rt::into(self.v_surface_segment_stage(pixel_61, at_101, rt::into(k_20)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_segment_stage(
        &self,
        pixel_61: PixelIn,
        at_101: Entered,
        k_20: rt::Scalar<u32>,
    ) -> Path {
        let _e7 = rt::Scalar(self.surface_settings.choices[1usize].number);
        match rt::Scalar::into_inner(_e7) {
            0u32 => {
                let _e12 = self.surface_settings.choices[1usize].params;
                let _e13 = self.v_surface_plane_segment(pixel_61, at_101, k_20, _e12);
                return _e13;
            }
            1u32 => {
                let _e18 = self.surface_settings.choices[1usize].params;
                let _e19 = self.v_surface_prism_segment(pixel_61, at_101, k_20, _e18);
                return _e19;
            }
            2u32 => {
                let _e24 = self.surface_settings.choices[1usize].params;
                let _e25 = self.v_surface_quadric_perpendicular_segment(pixel_61, at_101, k_20, _e24);
                return _e25;
            }
            3u32 => {
                let _e30 = self.surface_settings.choices[1usize].params;
                let _e31 = self.v_surface_quadric_vertical_segment(pixel_61, at_101, k_20, _e30);
                return _e31;
            }
            4u32 => {
                let _e36 = self.surface_settings.choices[1usize].params;
                let _e37 = self.v_surface_tetrahedra_segment(pixel_61, at_101, k_20, _e36);
                return _e37;
            }
            5u32 => {
                let _e42 = self.surface_settings.choices[1usize].params;
                let _e43 = self.v_surface_facets_segment(pixel_61, at_101, k_20, _e42);
                return _e43;
            }
            6u32 => {
                let _e48 = self.surface_settings.choices[1usize].params;
                let _e49 = self.v_surface_slices_segment(pixel_61, at_101, k_20, _e48);
                return _e49;
            }
            7u32 => {
                let _e54 = self.surface_settings.choices[1usize].params;
                let _e55 = self.v_surface_object_segment(pixel_61, at_101, k_20, _e54);
                return _e55;
            }
            8u32 => {
                let _e60 = self.surface_settings.choices[1usize].params;
                let _e61 = self.v_surface_frames_segment(pixel_61, at_101, k_20, _e60);
                return _e61;
            }
            _ => {
                let _e66 = self.surface_settings.choices[1usize].params;
                let _e67 = self.v_surface_object_slices_segment(pixel_61, at_101, k_20, _e66);
                return _e67;
            }
        }
    }
    pub(crate) fn flattened(
        &self,
        path_37: Path,
        middle_9: impl rt::Into<rt::Scalar<f32>>,
        part_12: impl rt::Into<rt::Scalar<f32>>,
    ) -> Path {
        rt::into(self.v_flattened(path_37, rt::into(middle_9), rt::into(part_12)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_flattened(
        &self,
        path_37: Path,
        middle_9: rt::Scalar<f32>,
        part_12: rt::Scalar<f32>,
    ) -> Path {
        let mut start_1: rt::Scalar<f32> = rt::Scalar(0f32);

        let kept = (rt::Scalar(1f32) - part_12);
        let top_10 = (middle_9 + ((rt::Scalar(1f32) - middle_9) * kept));
        let above_8 = (path_37.h.x() - top_10);
        let begins = above_8.elementwise_gt(rt::Scalar(0f32));
        if rt::Scalar::into_branch_condition(begins) {
            let _e22 = self.v_first_root(<rt::Vec3<f32>>::from_scalars(above_8, path_37.h.y(), path_37.h.z()), rt::Scalar(path_37.exit));
            start_1 = _e22.min(rt::Scalar(path_37.exit));
        }
        let height_25 = (middle_9 + ((path_37.h.x() - middle_9) / kept)).select(rt::Scalar(1f32), begins);
        let _e32 = start_1;
        let _e33 = self.v_path_slope(path_37, _e32);
        let h_13 = <rt::Vec3<f32>>::from_scalars(height_25, (_e33 / kept), (path_37.h.z() / kept));
        let _e40 = start_1;
        let rest_9 = (rt::Scalar(path_37.exit) - _e40);
        let _e48 = self.v_first_root(<rt::Vec3<f32>>::from_scalars(h_13.x().max(rt::Scalar(0f32)), h_13.y(), h_13.z()), rest_9);
        let exit_1 = (_e48 * rt::Scalar(1.000001f32)).min(rest_9);
        let _e53 = start_1;
        let base_5 = (rt::Scalar(path_37.base) - _e53).clamp(rt::Scalar(-300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32));
        let _e58 = start_1;
        let _e59 = self.v_path_uv(path_37, _e58);
        let _e65 = start_1;
        return <Path>::new(_e59, path_37.duv, h_13, exit_1, base_5, path_37.metric, rt::Scalar(path_37.ray), rt::Scalar(path_37.level), (rt::Scalar(path_37.start) + _e65), rt::Scalar(path_37.share), rt::Scalar(path_37.bend));
    }
    pub(crate) fn segment_of(
        &self,
        pixel_62: PixelIn,
        at_102: Entered,
        k_21: impl rt::Into<rt::Scalar<u32>>,
    ) -> Path {
        rt::into(self.v_segment_of(pixel_62, at_102, rt::into(k_21)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_segment_of(
        &self,
        pixel_62: PixelIn,
        at_102: Entered,
        k_21: rt::Scalar<u32>,
    ) -> Path {
        let mut path_38: Path;

        let _e3 = self.v_surface_segment_stage(pixel_62, at_102, k_21);
        path_38 = _e3;
        if rt::Scalar::into_branch_condition(rt::Scalar(at_102.fade).elementwise_gt(rt::Scalar(0f32))) {
            let _e8 = path_38;
            let _e11 = rt::Scalar(self.surface_settings.mean_height);
            let _e13 = self.v_flattened(_e8, _e11, rt::Scalar(at_102.fade));
            path_38 = _e13;
            let _e16 = path_38.h.x();
            if rt::Scalar::into_branch_condition((!_e16.elementwise_gt(rt::Scalar(0f32)))) {
                rt::Scalar(path_38.exit) = rt::Scalar(0f32);
            }
        }
        let _e22 = path_38;
        return _e22;
    }
    pub(crate) fn surface_plane_polish(
        &self,
        pixel_63: PixelIn,
        at_103: Entered,
        path_39: Path,
        hit_28: Hit,
        params_73: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_surface_plane_polish(pixel_63, at_103, path_39, hit_28, rt::into(params_73)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_plane_polish(
        &self,
        pixel_63: PixelIn,
        at_103: Entered,
        path_39: Path,
        hit_28: Hit,
        params_73: rt::Vec4<f32>,
    ) -> Hit {
        return hit_28;
    }
    pub(crate) fn weights_at_offset(
        &self,
        prism_11: Prism,
        place_28: impl rt::Into<rt::Vec3<f32>>,
        offset_5: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_weights_at_offset(prism_11, rt::into(place_28), rt::into(offset_5)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_weights_at_offset(
        &self,
        prism_11: Prism,
        place_28: rt::Vec3<f32>,
        offset_5: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let corner_7 = (prism_11.p0_ + (prism_11.n0_ * offset_5));
        let a_43 = ((prism_11.p1_ - prism_11.p0_) + ((prism_11.n1_ - prism_11.n0_) * offset_5));
        let b_43 = ((prism_11.p2_ - prism_11.p0_) + ((prism_11.n2_ - prism_11.n0_) * offset_5));
        let rest_10 = (place_28 - corner_7);
        let across_12 = a_43.cross(b_43);
        let square_5 = across_12.dot(across_12);
        if rt::Scalar::into_branch_condition((!square_5.elementwise_gt(rt::Scalar(0f32)))) {
            return <rt::Vec3<f32>>::from_scalars(rt::Scalar(0.28125f32), rt::Scalar(0.375f32), rt::Scalar(0.34375f32));
        }
        let second_10 = (rest_10.cross(b_43).dot(across_12) / square_5);
        let third_5 = (a_43.cross(rest_10).dot(across_12) / square_5);
        return <rt::Vec3<f32>>::from_scalars(((rt::Scalar(1f32) - second_10) - third_5), second_10, third_5);
    }
    pub(crate) fn shell_point_near(
        &self,
        prism_12: Prism,
        place_29: impl rt::Into<rt::Vec3<f32>>,
        height_10: impl rt::Into<rt::Scalar<f32>>,
    ) -> ShellPoint {
        rt::into(self.v_shell_point_near(prism_12, rt::into(place_29), rt::into(height_10)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shell_point_near(
        &self,
        prism_12: Prism,
        place_29: rt::Vec3<f32>,
        height_10: rt::Scalar<f32>,
    ) -> ShellPoint {
        let low_7 = self.surface_settings.shell_m.x();
        let _e10 = self.surface_settings.shell_m.y();
        let offset_8 = (low_7 + ((_e10 - low_7).min(rt::Scalar(300000000000000000000000000000000000000f32)) * height_10));
        let _e16 = self.v_weights_at_offset(prism_12, place_29, offset_8);
        let _e18 = self.v_lift_of(prism_12.lift, _e16);
        let _e20 = self.v_weights_at_offset(prism_12, place_29, (offset_8 + _e18));
        let near_12 = <ShellPoint>::new(_e20, height_10);
        let _e22 = self.v_shell_point_from(prism_12, place_29, near_12);
        let moved = (_e22.weights - near_12.weights).abs();
        let away_1 = moved.x().max(moved.y()).max(moved.z().max((rt::Scalar(_e22.height) - height_10).abs()));
        if rt::Scalar::into_branch_condition(away_1.elementwise_lt(rt::Scalar(0.5f32))) {
            return _e22;
        }
        return near_12;
    }
    pub(crate) fn point_of_way(
        &self,
        pixel_64: PixelIn,
        prism_13: Prism,
        place_30: impl rt::Into<rt::Vec3<f32>>,
        height_11: impl rt::Into<rt::Scalar<f32>>,
    ) -> ShellPoint {
        rt::into(self.v_point_of_way(pixel_64, prism_13, rt::into(place_30), rt::into(height_11)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_point_of_way(
        &self,
        pixel_64: PixelIn,
        prism_13: Prism,
        place_30: rt::Vec3<f32>,
        height_11: rt::Scalar<f32>,
    ) -> ShellPoint {
        if rt::Scalar::into_branch_condition(rt::Scalar(pixel_64.shell.order).elementwise_ge(SHELL_FOLDED)) {
            let _e8 = self.v_shell_point_near(prism_13, place_30, height_11);
            return _e8;
        }
        let _e9 = self.v_shell_point(prism_13, place_30, height_11);
        return _e9;
    }
    pub(crate) fn surface_prism_polish(
        &self,
        pixel_65: PixelIn,
        at_104: Entered,
        path_40: Path,
        hit_29: Hit,
        params_74: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_surface_prism_polish(pixel_65, at_104, path_40, hit_29, rt::into(params_74)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_prism_polish(
        &self,
        pixel_65: PixelIn,
        at_104: Entered,
        path_40: Path,
        hit_29: Hit,
        params_74: rt::Vec4<f32>,
    ) -> Hit {
        let mut t_23: rt::Scalar<f32>;
        let mut point_18: ShellPoint;
        let mut step_2: rt::Scalar<u32> = rt::Scalar(0u32);

        let _e6 = self.v_field_is_ground_stage(rt::Scalar(path_40.level));
        if rt::Scalar::into_branch_condition((!_e6)) {
            return hit_29;
        }
        let along_40 = pixel_65.direction.normalize();
        let _e10 = self.v_middle_of(pixel_65, along_40);
        let _e11 = self.v_prism_of(pixel_65, along_40, _e10, params_74);
        let _e13 = self.v_path_gap(path_40, rt::Scalar(hit_29.t));
        let _e14 = self.v_grid_of(path_40);
        let texels_7 = _e14.step.abs();
        let most_16 = ((rt::Scalar(2f32) * params_74.x()) / texels_7.x().max(texels_7.y()).max((path_40.h.y().abs() / rt::Scalar(0.0625f32))));
        t_23 = rt::Scalar(hit_29.t);
        let _e33 = t_23;
        let _e37 = t_23;
        let _e38 = self.v_path_height(path_40, _e37);
        let _e39 = self.v_point_of_way(pixel_65, _e11, (along_40 * ((rt::Scalar(path_40.start) + _e33) - _e10)), _e38);
        point_18 = _e39;
        'naga_break: loop {
            'naga_continue: {
                let _e43 = step_2;
                if rt::Scalar::into_branch_condition(_e43.elementwise_lt(POLISH_STEPS)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e46 = step_2;
                    step_2 = (_e46 + rt::Scalar(1u32));
                    let _e50 = rt::Scalar(point_18.height);
                    let _e52 = point_18.weights;
                    let _e53 = self.v_uv_of(pixel_65, _e52);
                    let _e55 = self.v_height_at(_e53, rt::Scalar(path_40.level));
                    let gap_3 = ((_e50 - _e55) - _e13);
                    let _e60 = t_23;
                    let _e63 = self.v_cell_of((_e14.origin + (_e14.step * _e60)));
                    let _e64 = t_23;
                    let _e65 = self.v_cell_gap(path_40, _e14, _e63, _e64);
                    let change_7 = _e65.y();
                    if rt::Scalar::into_branch_condition(change_7.elementwise_lt(rt::Scalar(0f32))) {
                        let _e69 = t_23;
                        t_23 = (_e69 - (gap_3 / change_7)).clamp((rt::Scalar(hit_29.t) - most_16), (rt::Scalar(hit_29.t) + most_16));
                    }
                    let _e78 = t_23;
                    let place_43 = (along_40 * ((rt::Scalar(path_40.start) + _e78) - _e10));
                    if rt::Scalar::into_branch_condition(rt::Scalar(pixel_65.shell.order).elementwise_ge(SHELL_FOLDED)) {
                        let _e86 = t_23;
                        let _e87 = self.v_path_height(path_40, _e86);
                        let _e88 = self.v_shell_point_near(_e11, place_43, _e87);
                        point_18 = _e88;
                    } else {
                        let _e89 = point_18;
                        let _e90 = self.v_shell_point_from(_e11, place_43, _e89);
                        point_18 = _e90;
                    }
                }
            }
        }
        let _e94 = point_18.weights;
        let _e95 = self.v_uv_of(pixel_65, _e94);
        let _e97 = rt::Scalar(point_18.height);
        let _e98 = t_23;
        return <Hit>::new(rt::Scalar(1u32), rt::Scalar(hit_29.exhausted), _e95, _e97, _e98, hit_29.cost);
    }
    pub(crate) fn surface_quadric_perpendicular_polish(
        &self,
        pixel_66: PixelIn,
        at_105: Entered,
        path_41: Path,
        hit_30: Hit,
        params_75: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_surface_quadric_perpendicular_polish(pixel_66, at_105, path_41, hit_30, rt::into(params_75)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_quadric_perpendicular_polish(
        &self,
        pixel_66: PixelIn,
        at_105: Entered,
        path_41: Path,
        hit_30: Hit,
        params_75: rt::Vec4<f32>,
    ) -> Hit {
        return hit_30;
    }
    pub(crate) fn surface_quadric_vertical_polish(
        &self,
        pixel_67: PixelIn,
        at_106: Entered,
        path_42: Path,
        hit_31: Hit,
        params_76: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_surface_quadric_vertical_polish(pixel_67, at_106, path_42, hit_31, rt::into(params_76)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_quadric_vertical_polish(
        &self,
        pixel_67: PixelIn,
        at_106: Entered,
        path_42: Path,
        hit_31: Hit,
        params_76: rt::Vec4<f32>,
    ) -> Hit {
        return hit_31;
    }
    pub(crate) fn surface_tetrahedra_polish(
        &self,
        pixel_68: PixelIn,
        at_107: Entered,
        path_43: Path,
        hit_32: Hit,
        params_77: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_surface_tetrahedra_polish(pixel_68, at_107, path_43, hit_32, rt::into(params_77)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_tetrahedra_polish(
        &self,
        pixel_68: PixelIn,
        at_107: Entered,
        path_43: Path,
        hit_32: Hit,
        params_77: rt::Vec4<f32>,
    ) -> Hit {
        return hit_32;
    }
    pub(crate) fn surface_facets_polish(
        &self,
        pixel_69: PixelIn,
        at_108: Entered,
        path_44: Path,
        hit_33: Hit,
        params_78: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_surface_facets_polish(pixel_69, at_108, path_44, hit_33, rt::into(params_78)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_facets_polish(
        &self,
        pixel_69: PixelIn,
        at_108: Entered,
        path_44: Path,
        hit_33: Hit,
        params_78: rt::Vec4<f32>,
    ) -> Hit {
        return hit_33;
    }
    pub(crate) fn surface_slices_polish(
        &self,
        pixel_70: PixelIn,
        at_109: Entered,
        path_45: Path,
        hit_34: Hit,
        params_79: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_surface_slices_polish(pixel_70, at_109, path_45, hit_34, rt::into(params_79)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_slices_polish(
        &self,
        pixel_70: PixelIn,
        at_109: Entered,
        path_45: Path,
        hit_34: Hit,
        params_79: rt::Vec4<f32>,
    ) -> Hit {
        let mut counted: Hit;

        counted = hit_34;
        counted.cost = (hit_34.cost + HEIGHTS_READ);
        let _e10 = counted;
        return _e10;
    }
    pub(crate) fn metres_on(
        &self,
        path_46: Path,
        t_24: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_metres_on(path_46, rt::into(t_24)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_metres_on(
        &self,
        path_46: Path,
        t_24: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        return (t_24 / (rt::Scalar(1f32) - (rt::Scalar(path_46.bend) * t_24)));
    }
    pub(crate) fn polished_on_image(&self, path_47: Path, hit_35: Hit) -> Hit {
        rt::into(self.v_polished_on_image(path_47, hit_35))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_polished_on_image(&self, path_47: Path, hit_35: Hit) -> Hit {
        let mut polished: Hit;

        polished = hit_35;
        let _e5 = self.v_metres_on(path_47, rt::Scalar(hit_35.t));
        rt::Scalar(polished.t) = _e5;
        let _e6 = polished;
        return _e6;
    }
    pub(crate) fn surface_object_polish(
        &self,
        pixel_71: PixelIn,
        at_110: Entered,
        path_48: Path,
        hit_36: Hit,
        params_80: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_surface_object_polish(pixel_71, at_110, path_48, hit_36, rt::into(params_80)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_object_polish(
        &self,
        pixel_71: PixelIn,
        at_110: Entered,
        path_48: Path,
        hit_36: Hit,
        params_80: rt::Vec4<f32>,
    ) -> Hit {
        let _e5 = self.v_polished_on_image(path_48, hit_36);
        return _e5;
    }
    pub(crate) fn surface_frames_polish(
        &self,
        pixel_72: PixelIn,
        at_111: Entered,
        path_49: Path,
        hit_37: Hit,
        params_81: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_surface_frames_polish(pixel_72, at_111, path_49, hit_37, rt::into(params_81)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_frames_polish(
        &self,
        pixel_72: PixelIn,
        at_111: Entered,
        path_49: Path,
        hit_37: Hit,
        params_81: rt::Vec4<f32>,
    ) -> Hit {
        let _e5 = self.v_polished_on_image(path_49, hit_37);
        return _e5;
    }
    pub(crate) fn surface_object_slices_polish(
        &self,
        pixel_73: PixelIn,
        at_112: Entered,
        path_50: Path,
        hit_38: Hit,
        params_82: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_surface_object_slices_polish(pixel_73, at_112, path_50, hit_38, rt::into(params_82)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_object_slices_polish(
        &self,
        pixel_73: PixelIn,
        at_112: Entered,
        path_50: Path,
        hit_38: Hit,
        params_82: rt::Vec4<f32>,
    ) -> Hit {
        let mut counted_1: Hit;

        counted_1 = hit_38;
        let _e10 = rt::Scalar(self.surface_settings.solids);
        let _e15 = rt::Scalar(self.surface_settings.solids);
        counted_1.cost = (hit_38.cost + <rt::Vec3<u32>>::from_scalars(_e10, rt::Scalar(0u32), (rt::Scalar(16u32) * _e15)));
        let _e19 = counted_1;
        return _e19;
    }
    pub(crate) fn surface_polish_stage(&self, pixel_74: PixelIn, at_113: Entered, path_51: Path, hit_39: Hit) -> Hit {
        rt::into(self.v_surface_polish_stage(pixel_74, at_113, path_51, hit_39))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_polish_stage(&self, pixel_74: PixelIn, at_113: Entered, path_51: Path, hit_39: Hit) -> Hit {
        let _e8 = rt::Scalar(self.surface_settings.choices[1usize].number);
        match rt::Scalar::into_inner(_e8) {
            0u32 => {
                let _e13 = self.surface_settings.choices[1usize].params;
                let _e14 = self.v_surface_plane_polish(pixel_74, at_113, path_51, hit_39, _e13);
                return _e14;
            }
            1u32 => {
                let _e19 = self.surface_settings.choices[1usize].params;
                let _e20 = self.v_surface_prism_polish(pixel_74, at_113, path_51, hit_39, _e19);
                return _e20;
            }
            2u32 => {
                let _e25 = self.surface_settings.choices[1usize].params;
                let _e26 = self.v_surface_quadric_perpendicular_polish(pixel_74, at_113, path_51, hit_39, _e25);
                return _e26;
            }
            3u32 => {
                let _e31 = self.surface_settings.choices[1usize].params;
                let _e32 = self.v_surface_quadric_vertical_polish(pixel_74, at_113, path_51, hit_39, _e31);
                return _e32;
            }
            4u32 => {
                let _e37 = self.surface_settings.choices[1usize].params;
                let _e38 = self.v_surface_tetrahedra_polish(pixel_74, at_113, path_51, hit_39, _e37);
                return _e38;
            }
            5u32 => {
                let _e43 = self.surface_settings.choices[1usize].params;
                let _e44 = self.v_surface_facets_polish(pixel_74, at_113, path_51, hit_39, _e43);
                return _e44;
            }
            6u32 => {
                let _e49 = self.surface_settings.choices[1usize].params;
                let _e50 = self.v_surface_slices_polish(pixel_74, at_113, path_51, hit_39, _e49);
                return _e50;
            }
            7u32 => {
                let _e55 = self.surface_settings.choices[1usize].params;
                let _e56 = self.v_surface_object_polish(pixel_74, at_113, path_51, hit_39, _e55);
                return _e56;
            }
            8u32 => {
                let _e61 = self.surface_settings.choices[1usize].params;
                let _e62 = self.v_surface_frames_polish(pixel_74, at_113, path_51, hit_39, _e61);
                return _e62;
            }
            _ => {
                let _e67 = self.surface_settings.choices[1usize].params;
                let _e68 = self.v_surface_object_slices_polish(pixel_74, at_113, path_51, hit_39, _e67);
                return _e68;
            }
        }
    }
    pub(crate) fn polish_hit(&self, pixel_75: PixelIn, at_114: Entered, path_52: Path, hit_40: Hit) -> Hit {
        rt::into(self.v_polish_hit(pixel_75, at_114, path_52, hit_40))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_polish_hit(&self, pixel_75: PixelIn, at_114: Entered, path_52: Path, hit_40: Hit) -> Hit {
        let _e4 = self.v_surface_polish_stage(pixel_75, at_114, path_52, hit_40);
        return _e4;
    }
    pub(crate) fn key_of(&self, depth_8: impl rt::Into<rt::Scalar<f32>>) -> f32 {
        rt::into(self.v_key_of(rt::into(depth_8)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_key_of(&self, depth_8: rt::Scalar<f32>) -> rt::Scalar<f32> {
        let _e3 = rt::Scalar(self.frame.near);
        let _e6 = rt::Scalar(self.frame.near);
        return (_e3 / (_e6 + depth_8.max(rt::Scalar(0f32))));
    }
    pub(crate) fn is_in_hole(&self, uv_30: impl rt::Into<rt::Vec2<f32>>) -> bool {
        rt::into(self.v_is_in_hole(rt::into(uv_30)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_is_in_hole(&self, uv_30: rt::Vec2<f32>) -> rt::Scalar<bool> {
        let _e3 = rt::Scalar(self.surface_settings.has_holes);
        if rt::Scalar::into_branch_condition((_e3 & rt::Scalar(2u32)).elementwise_ne(rt::Scalar(0u32))) {
            let _e9 = self.v_color_at(uv_30, rt::Scalar(0u32));
            let _e13 = rt::Scalar(self.surface_settings.cutoff);
            if rt::Scalar::into_branch_condition(_e9.w().elementwise_lt(_e13)) {
                return rt::Scalar(true);
            }
        }
        let _e18 = rt::Scalar(self.surface_settings.has_holes);
        if rt::Scalar::into_branch_condition((_e18 & rt::Scalar(1u32)).elementwise_eq(rt::Scalar(0u32))) {
            return rt::Scalar(false);
        }
        let _e25 = self.v_height_texels(rt::Scalar(0u32));
        let _e27 = self.v_height_size(rt::Scalar(0u32));
        let _e33 = self.v_cell_of(((uv_30 * _e27) - <rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32))));
        let cell_44 = _e33.to_i32();
        let _e37 = self.v_wrap_pair(cell_44.x(), _e25.x());
        let _e40 = self.v_wrap_pair(cell_44.y(), _e25.y());
        let _e46 = rt::texture::Read::read_texel((&self.hole_map), <rt::Vec2<i32>>::from_scalars(_e37.x(), _e40.x()), 0i32, 0i32, rt::Scalar::into_inner(rt::Scalar(0i32)));
        let _e53 = rt::texture::Read::read_texel((&self.hole_map), <rt::Vec2<i32>>::from_scalars(_e37.y(), _e40.x()), 0i32, 0i32, rt::Scalar::into_inner(rt::Scalar(0i32)));
        let above_9 = _e46.x().max(_e53.x());
        let _e61 = rt::texture::Read::read_texel((&self.hole_map), <rt::Vec2<i32>>::from_scalars(_e37.x(), _e40.y()), 0i32, 0i32, rt::Scalar::into_inner(rt::Scalar(0i32)));
        let _e68 = rt::texture::Read::read_texel((&self.hole_map), <rt::Vec2<i32>>::from_scalars(_e37.y(), _e40.y()), 0i32, 0i32, rt::Scalar::into_inner(rt::Scalar(0i32)));
        let below_7 = _e61.x().max(_e68.x());
        return above_9.max(below_7).elementwise_gt(rt::Scalar(0f32));
    }
    pub(crate) fn in_hole(&self, uv_31: impl rt::Into<rt::Vec2<f32>>) -> bool {
        rt::into(self.v_in_hole(rt::into(uv_31)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_in_hole(&self, uv_31: rt::Vec2<f32>) -> rt::Scalar<bool> {
        let _e3 = rt::Scalar(self.surface_settings.has_holes);
        if rt::Scalar::into_branch_condition(_e3.elementwise_eq(rt::Scalar(0u32))) {
            return rt::Scalar(false);
        }
        let _e7 = self.v_is_in_hole(uv_31);
        return _e7;
    }
    pub(crate) fn hit_on_segment(
        &self,
        pixel_76: PixelIn,
        at_115: Entered,
        path_53: Path,
        found: Hit,
        k_22: impl rt::Into<rt::Scalar<u32>>,
    ) -> FirstHit {
        rt::into(self.v_hit_on_segment(pixel_76, at_115, path_53, found, rt::into(k_22)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_hit_on_segment(
        &self,
        pixel_76: PixelIn,
        at_115: Entered,
        path_53: Path,
        found: Hit,
        k_22: rt::Scalar<u32>,
    ) -> FirstHit {
        let mut first_2: FirstHit;

        first_2 = <FirstHit>::new(found, k_22, rt::Scalar(0f32));
        if rt::Scalar::into_branch_condition(rt::Scalar(found.found).elementwise_eq(rt::Scalar(1u32))) {
            let _e11 = self.v_polish_hit(pixel_76, at_115, path_53, found);
            let _e12 = self.v_depth_on_ray(pixel_76, path_53, _e11);
            let _e13 = self.v_key_of(_e12);
            first_2 = <FirstHit>::new(_e11, k_22, _e13);
            let _e16 = self.v_in_hole(_e11.uv);
            if rt::Scalar::into_branch_condition(_e16) {
                rt::Scalar(first_2.hit.found) = rt::Scalar(0u32);
            }
        }
        let _e20 = first_2;
        return _e20;
    }
    pub(crate) fn leaves_at_exit(&self, path_54: Path) -> bool {
        rt::into(self.v_leaves_at_exit(path_54))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_leaves_at_exit(&self, path_54: Path) -> rt::Scalar<bool> {
        let mut local_73: rt::Scalar<bool>;

        let _e2 = self.v_path_height(path_54, rt::Scalar(path_54.exit));
        if rt::Scalar::into_branch_condition((!_e2.elementwise_gt(rt::Scalar(0.000001f32)))) {
            let _e9 = self.v_field_is_ground_stage(rt::Scalar(path_54.level));
            local_73 = (!_e9);
        } else {
            local_73 = rt::Scalar(true);
        }
        let _e12 = local_73;
        return _e12;
    }
    pub(crate) fn hit_on_path(
        &self,
        path_55: Path,
        t_25: impl rt::Into<rt::Scalar<f32>>,
        exhausted: impl rt::Into<rt::Scalar<u32>>,
        cost_3: impl rt::Into<rt::Vec3<u32>>,
    ) -> Hit {
        rt::into(self.v_hit_on_path(path_55, rt::into(t_25), rt::into(exhausted), rt::into(cost_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_hit_on_path(
        &self,
        path_55: Path,
        t_25: rt::Scalar<f32>,
        exhausted: rt::Scalar<u32>,
        cost_3: rt::Vec3<u32>,
    ) -> Hit {
        let mut local_74: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition(t_25.elementwise_gt(rt::Scalar(path_55.exit))) {
            let _e8 = self.v_leaves_at_exit(path_55);
            local_74 = _e8;
        } else {
            local_74 = rt::Scalar(false);
        }
        let _e10 = local_74;
        if rt::Scalar::into_branch_condition(_e10) {
            let _e11 = self.v_miss(cost_3);
            return _e11;
        }
        let inside_6 = t_25.clamp(rt::Scalar(0f32), rt::Scalar(path_55.exit));
        let _e16 = self.v_path_uv(path_55, inside_6);
        let _e17 = self.v_path_height(path_55, inside_6);
        return <Hit>::new(rt::Scalar(1u32), exhausted, _e16, _e17, inside_6, cost_3);
    }
    pub(crate) fn starting_point(&self, path_56: Path, found_1: SearchResult) -> f32 {
        rt::into(self.v_starting_point(path_56, found_1))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_starting_point(&self, path_56: Path, found_1: SearchResult) -> rt::Scalar<f32> {
        let mut local_75: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition(rt::Scalar(found_1.status).elementwise_eq(FOUND_UNBRACKETED)) {
            return rt::Scalar(path_56.base);
        }
        if rt::Scalar::into_branch_condition((!rt::Scalar(found_1.status).elementwise_eq(FOUND_BRACKET))) {
            local_75 = rt::Scalar(found_1.status).elementwise_eq(FOUND_BELOW);
        } else {
            local_75 = rt::Scalar(true);
        }
        let _e16 = local_75;
        if rt::Scalar::into_branch_condition(_e16) {
            return rt::Scalar(found_1.far);
        }
        return rt::Scalar(found_1.near);
    }
    pub(crate) fn refine_none(
        &self,
        path_57: Path,
        found_2: SearchResult,
        params_83: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_refine_none(path_57, found_2, rt::into(params_83)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_refine_none(
        &self,
        path_57: Path,
        found_2: SearchResult,
        params_83: rt::Vec4<f32>,
    ) -> Hit {
        if rt::Scalar::into_branch_condition(rt::Scalar(found_2.status).elementwise_eq(FOUND_MISS)) {
            let _e7 = self.v_miss(found_2.cost);
            return _e7;
        }
        let exhausted_1 = rt::Scalar(0u32).select(rt::Scalar(1u32), rt::Scalar(found_2.status).elementwise_eq(FOUND_EXHAUSTED));
        let _e14 = self.v_starting_point(path_57, found_2);
        let _e16 = self.v_hit_on_path(path_57, _e14, exhausted_1, found_2.cost);
        return _e16;
    }
    pub(crate) fn refine_offset(
        &self,
        path_58: Path,
        found_3: SearchResult,
        params_84: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_refine_offset(path_58, found_3, rt::into(params_84)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_refine_offset(
        &self,
        path_58: Path,
        found_3: SearchResult,
        params_84: rt::Vec4<f32>,
    ) -> Hit {
        let mut t_26: rt::Scalar<f32>;

        if rt::Scalar::into_branch_condition(rt::Scalar(found_3.status).elementwise_eq(FOUND_MISS)) {
            let _e7 = self.v_miss(found_3.cost);
            return _e7;
        }
        let _e8 = self.v_starting_point(path_58, found_3);
        let _e9 = self.v_path_uv(path_58, _e8);
        let _e11 = self.v_height_at(_e9, rt::Scalar(path_58.level));
        let _e12 = self.v_path_slope(path_58, _e8);
        t_26 = _e8;
        if rt::Scalar::into_branch_condition(_e12.elementwise_ne(rt::Scalar(0f32))) {
            let _e16 = self.v_path_height(path_58, _e8);
            t_26 = (_e8 + ((_e11 - _e16) / _e12));
        }
        let _e20 = t_26;
        let _e30 = self.v_hit_on_path(path_58, _e20, rt::Scalar(0u32).select(rt::Scalar(1u32), rt::Scalar(found_3.status).elementwise_eq(FOUND_EXHAUSTED)), (found_3.cost + HEIGHTS_READ));
        return _e30;
    }
    pub(crate) fn refine_offset_limited(
        &self,
        path_59: Path,
        found_4: SearchResult,
        params_85: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_refine_offset_limited(path_59, found_4, rt::into(params_85)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_refine_offset_limited(
        &self,
        path_59: Path,
        found_4: SearchResult,
        params_85: rt::Vec4<f32>,
    ) -> Hit {
        let mut hit_41: Hit;

        if rt::Scalar::into_branch_condition(rt::Scalar(found_4.status).elementwise_eq(FOUND_MISS)) {
            let _e7 = self.v_miss(found_4.cost);
            return _e7;
        }
        let _e8 = self.v_starting_point(path_59, found_4);
        let _e9 = self.v_path_uv(path_59, _e8);
        let _e11 = self.v_height_at(_e9, rt::Scalar(path_59.level));
        let _e12 = self.v_path_height(path_59, _e8);
        let rise_m = ((_e11 - _e12) * path_59.metric.w());
        let exhausted_2 = rt::Scalar(0u32).select(rt::Scalar(1u32), rt::Scalar(found_4.status).elementwise_eq(FOUND_EXHAUSTED));
        let _e27 = self.v_hit_on_path(path_59, (_e8 - rise_m), exhausted_2, (found_4.cost + HEIGHTS_READ));
        hit_41 = _e27;
        let _e30 = rt::Scalar(hit_41.found);
        if rt::Scalar::into_branch_condition(_e30.elementwise_eq(rt::Scalar(1u32))) {
            rt::Scalar(hit_41.height) = _e11;
        }
        let _e34 = hit_41;
        return _e34;
    }
    pub(crate) fn normal_z(
        &self,
        path_60: Path,
        slope_1: impl rt::Into<rt::Vec2<f32>>,
    ) -> f32 {
        rt::into(self.v_normal_z(path_60, rt::into(slope_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_normal_z(
        &self,
        path_60: Path,
        slope_1: rt::Vec2<f32>,
    ) -> rt::Scalar<f32> {
        let m_5 = path_60.metric;
        let area_6 = ((m_5.x() * m_5.z()) - (m_5.y() * m_5.y()));
        let squared_4 = (((((slope_1.x() * slope_1.x()) * m_5.z()) - (((rt::Scalar(2f32) * slope_1.x()) * slope_1.y()) * m_5.y())) + ((slope_1.y() * slope_1.y()) * m_5.x())) / area_6);
        return (rt::Scalar(1f32) / (rt::Scalar(1f32) + ((m_5.w() * m_5.w()) * squared_4)).sqrt());
    }
    pub(crate) fn refine_slope(
        &self,
        path_61: Path,
        found_5: SearchResult,
        params_86: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_refine_slope(path_61, found_5, rt::into(params_86)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_refine_slope(
        &self,
        path_61: Path,
        found_5: SearchResult,
        params_86: rt::Vec4<f32>,
    ) -> Hit {
        let mut t_27: rt::Scalar<f32>;

        if rt::Scalar::into_branch_condition(rt::Scalar(found_5.status).elementwise_eq(FOUND_MISS)) {
            let _e7 = self.v_miss(found_5.cost);
            return _e7;
        }
        let _e8 = self.v_starting_point(path_61, found_5);
        let _e9 = self.v_path_uv(path_61, _e8);
        let _e11 = self.v_height_and_slope(_e9, rt::Scalar(path_61.level));
        let _e13 = self.v_path_height(path_61, _e8);
        let rise_3 = (_e11.x() - _e13);
        t_27 = _e8;
        if rt::Scalar::into_branch_condition(params_86.x().elementwise_gt(rt::Scalar(0.5f32))) {
            let _e19 = self.v_path_slope(path_61, _e8);
            let closing = (_e19 - ((_e11.y() * path_61.duv.x()) + (_e11.z() * path_61.duv.y())));
            if rt::Scalar::into_branch_condition(closing.elementwise_lt(rt::Scalar(0f32))) {
                t_27 = (_e8 + (rise_3 / closing));
            }
        } else {
            let _e40 = self.v_normal_z(path_61, <rt::Vec2<f32>>::from_scalars(_e11.y(), _e11.z()));
            t_27 = (_e8 - ((rise_3 * path_61.metric.w()) * _e40));
        }
        let _e43 = t_27;
        let _e53 = self.v_hit_on_path(path_61, _e43, rt::Scalar(0u32).select(rt::Scalar(1u32), rt::Scalar(found_5.status).elementwise_eq(FOUND_EXHAUSTED)), (found_5.cost + HEIGHTS_READ));
        return _e53;
    }
    pub(crate) fn refine_slope_iterative(
        &self,
        path_62: Path,
        found_6: SearchResult,
        params_87: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_refine_slope_iterative(path_62, found_6, rt::into(params_87)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_refine_slope_iterative(
        &self,
        path_62: Path,
        found_6: SearchResult,
        params_87: rt::Vec4<f32>,
    ) -> Hit {
        let mut t_28: rt::Scalar<f32>;
        let mut cost_4: rt::Vec3<u32>;
        let mut k_23: rt::Scalar<f32> = rt::Scalar(0f32);

        if rt::Scalar::into_branch_condition(rt::Scalar(found_6.status).elementwise_eq(FOUND_MISS)) {
            let _e7 = self.v_miss(found_6.cost);
            return _e7;
        }
        let _e8 = self.v_starting_point(path_62, found_6);
        t_28 = _e8;
        cost_4 = found_6.cost;
        'naga_break: loop {
            'naga_continue: {
                let _e14 = k_23;
                if rt::Scalar::into_branch_condition(_e14.elementwise_lt(params_87.x())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e17 = cost_4;
                    cost_4 = (_e17 + STEP);
                    let _e20 = t_28;
                    let _e21 = self.v_path_uv(path_62, _e20);
                    let _e23 = self.v_height_and_slope(_e21, rt::Scalar(path_62.level));
                    let _e24 = cost_4;
                    cost_4 = (_e24 + HEIGHTS_READ);
                    let _e28 = t_28;
                    let _e29 = self.v_path_height(path_62, _e28);
                    let rise_4 = (_e23.x() - _e29);
                    if rt::Scalar::into_branch_condition(params_87.y().elementwise_gt(rt::Scalar(0.5f32))) {
                        let _e34 = t_28;
                        let _e35 = self.v_path_slope(path_62, _e34);
                        let closing_1 = (_e35 - ((_e23.y() * path_62.duv.x()) + (_e23.z() * path_62.duv.y())));
                        if rt::Scalar::into_branch_condition(closing_1.elementwise_lt(rt::Scalar(0f32))) {
                            let _e48 = t_28;
                            t_28 = (_e48 + (rise_4 / closing_1));
                        }
                    } else {
                        let _e51 = t_28;
                        let _e58 = self.v_normal_z(path_62, <rt::Vec2<f32>>::from_scalars(_e23.y(), _e23.z()));
                        t_28 = (_e51 - ((rise_4 * path_62.metric.w()) * _e58));
                    }
                    let _e61 = t_28;
                    t_28 = _e61.clamp(rt::Scalar(0f32), rt::Scalar(path_62.exit));
                    let _e65 = k_23;
                    k_23 = (_e65 + rt::Scalar(1f32));
                }
            }
        }
        let _e68 = t_28;
        let _e75 = cost_4;
        let _e76 = self.v_hit_on_path(path_62, _e68, rt::Scalar(0u32).select(rt::Scalar(1u32), rt::Scalar(found_6.status).elementwise_eq(FOUND_EXHAUSTED)), _e75);
        return _e76;
    }
    pub(crate) fn has_interval(&self, found_7: SearchResult) -> bool {
        rt::into(self.v_has_interval(found_7))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_has_interval(&self, found_7: SearchResult) -> rt::Scalar<bool> {
        let mut local_76: rt::Scalar<bool>;
        let mut local_77: rt::Scalar<bool>;
        let mut local_78: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition(rt::Scalar(found_7.far).elementwise_gt(rt::Scalar(found_7.near))) {
            if rt::Scalar::into_branch_condition((!rt::Scalar(found_7.status).elementwise_eq(FOUND_BRACKET))) {
                local_77 = rt::Scalar(found_7.status).elementwise_eq(FOUND_UNBRACKETED);
            } else {
                local_77 = rt::Scalar(true);
            }
            let _e16 = local_77;
            if rt::Scalar::into_branch_condition((!_e16)) {
                local_78 = rt::Scalar(found_7.status).elementwise_eq(FOUND_ABOVE);
            } else {
                local_78 = rt::Scalar(true);
            }
            let _e24 = local_78;
            local_76 = _e24;
        } else {
            local_76 = rt::Scalar(false);
        }
        let _e26 = local_76;
        return _e26;
    }
    pub(crate) fn refine_binary(
        &self,
        path_63: Path,
        found_8: SearchResult,
        params_88: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_refine_binary(path_63, found_8, rt::into(params_88)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_refine_binary(
        &self,
        path_63: Path,
        found_8: SearchResult,
        params_88: rt::Vec4<f32>,
    ) -> Hit {
        let mut near_2: rt::Scalar<f32>;
        let mut far_4: rt::Scalar<f32>;
        let mut cost_5: rt::Vec3<u32>;
        let mut local_79: rt::Scalar<bool>;
        let mut crossed: rt::Scalar<bool>;
        let mut k_24: rt::Scalar<f32> = rt::Scalar(0f32);

        let _e3 = self.v_has_interval(found_8);
        if rt::Scalar::into_branch_condition((!_e3)) {
            let _e5 = self.v_refine_none(path_63, found_8, params_88);
            return _e5;
        }
        near_2 = rt::Scalar(found_8.near);
        far_4 = rt::Scalar(found_8.far);
        cost_5 = found_8.cost;
        if rt::Scalar::into_branch_condition((!rt::Scalar(found_8.status).elementwise_eq(FOUND_BRACKET))) {
            let _e18 = far_4;
            let _e19 = self.v_path_height(path_63, _e18);
            local_79 = _e19.elementwise_le(rt::Scalar(0.000001f32));
        } else {
            local_79 = rt::Scalar(true);
        }
        let _e23 = local_79;
        crossed = _e23;
        'naga_break: loop {
            'naga_continue: {
                let _e27 = k_24;
                if rt::Scalar::into_branch_condition(_e27.elementwise_lt(params_88.x())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e30 = cost_5;
                    cost_5 = (_e30 + STEP);
                    let _e33 = near_2;
                    let _e34 = far_4;
                    let middle_16 = (rt::Scalar(0.5f32) * (_e33 + _e34));
                    let _e38 = cost_5;
                    let _e40 = self.v_field_cost_stage(rt::Scalar(path_63.level));
                    cost_5 = (_e38 + _e40);
                    let _e42 = self.v_path_gap(path_63, middle_16);
                    if rt::Scalar::into_branch_condition(_e42.elementwise_le(rt::Scalar(0f32))) {
                        far_4 = middle_16;
                        crossed = rt::Scalar(true);
                    } else {
                        near_2 = middle_16;
                    }
                    let _e46 = k_24;
                    k_24 = (_e46 + rt::Scalar(1f32));
                }
            }
        }
        let _e49 = crossed;
        if rt::Scalar::into_branch_condition((!_e49)) {
            let _e51 = cost_5;
            let _e52 = self.v_miss(_e51);
            return _e52;
        }
        let _e53 = near_2;
        let _e54 = far_4;
        let _e59 = cost_5;
        let _e60 = self.v_hit_on_path(path_63, (rt::Scalar(0.5f32) * (_e53 + _e54)), rt::Scalar(0u32), _e59);
        return _e60;
    }
    pub(crate) fn refine_secant(
        &self,
        path_64: Path,
        found_9: SearchResult,
        params_89: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_refine_secant(path_64, found_9, rt::into(params_89)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_refine_secant(
        &self,
        path_64: Path,
        found_9: SearchResult,
        params_89: rt::Vec4<f32>,
    ) -> Hit {
        let mut near_3: rt::Scalar<f32>;
        let mut far_5: rt::Scalar<f32>;
        let mut near_gap_1: rt::Scalar<f32>;
        let mut far_gap_1: rt::Scalar<f32>;
        let mut cost_6: rt::Vec3<u32>;
        let mut t_29: rt::Scalar<f32>;
        let mut k_25: rt::Scalar<f32> = rt::Scalar(1f32);

        let _e3 = self.v_has_interval(found_9);
        if rt::Scalar::into_branch_condition((!_e3)) {
            let _e5 = self.v_refine_none(path_64, found_9, params_89);
            return _e5;
        }
        near_3 = rt::Scalar(found_9.near);
        far_5 = rt::Scalar(found_9.far);
        near_gap_1 = rt::Scalar(found_9.near_gap);
        far_gap_1 = rt::Scalar(found_9.far_gap);
        cost_6 = found_9.cost;
        if rt::Scalar::into_branch_condition(rt::Scalar(found_9.status).elementwise_ne(FOUND_BRACKET)) {
            let _e19 = near_3;
            let _e20 = self.v_path_gap(path_64, _e19);
            near_gap_1 = _e20;
            let _e21 = far_5;
            let _e22 = self.v_path_gap(path_64, _e21);
            far_gap_1 = _e22;
            let _e23 = cost_6;
            let _e25 = self.v_field_cost_stage(rt::Scalar(path_64.level));
            let _e28 = self.v_field_cost_stage(rt::Scalar(path_64.level));
            cost_6 = ((_e23 + _e25) + _e28);
            let _e30 = far_gap_1;
            if rt::Scalar::into_branch_condition(_e30.elementwise_gt(rt::Scalar(0f32))) {
                let _e33 = cost_6;
                let _e34 = self.v_miss(_e33);
                return _e34;
            }
        }
        let _e35 = far_5;
        t_29 = _e35;
        'naga_break: loop {
            'naga_continue: {
                let _e39 = k_25;
                if rt::Scalar::into_branch_condition(_e39.elementwise_le(params_89.x())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e42 = cost_6;
                    cost_6 = (_e42 + STEP);
                    let _e45 = near_gap_1;
                    let _e46 = far_gap_1;
                    let drop = (_e45 - _e46);
                    if rt::Scalar::into_branch_condition((!drop.elementwise_gt(rt::Scalar(0f32)))) {
                        break 'naga_break;
                    }
                    let _e51 = near_3;
                    let _e52 = far_5;
                    let _e53 = near_3;
                    let _e55 = near_gap_1;
                    t_29 = (_e51 + ((_e52 - _e53) * (_e55 / drop)));
                    let _e59 = k_25;
                    if rt::Scalar::into_branch_condition(_e59.elementwise_lt(params_89.x())) {
                        let _e62 = t_29;
                        let _e63 = self.v_path_gap(path_64, _e62);
                        let _e64 = cost_6;
                        let _e66 = self.v_field_cost_stage(rt::Scalar(path_64.level));
                        cost_6 = (_e64 + _e66);
                        if rt::Scalar::into_branch_condition(_e63.elementwise_le(rt::Scalar(0f32))) {
                            let _e70 = t_29;
                            far_5 = _e70;
                            far_gap_1 = _e63;
                        } else {
                            let _e71 = t_29;
                            near_3 = _e71;
                            near_gap_1 = _e63;
                        }
                    }
                    let _e72 = k_25;
                    k_25 = (_e72 + rt::Scalar(1f32));
                }
            }
        }
        let _e75 = t_29;
        let _e77 = cost_6;
        let _e78 = self.v_hit_on_path(path_64, _e75, rt::Scalar(0u32), _e77);
        return _e78;
    }
    pub(crate) fn refine_true_secant(
        &self,
        path_65: Path,
        found_10: SearchResult,
        params_90: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_refine_true_secant(path_65, found_10, rt::into(params_90)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_refine_true_secant(
        &self,
        path_65: Path,
        found_10: SearchResult,
        params_90: rt::Vec4<f32>,
    ) -> Hit {
        let mut before_3: rt::Scalar<f32>;
        let mut last_1: rt::Scalar<f32>;
        let mut before_gap: rt::Scalar<f32>;
        let mut last_gap: rt::Scalar<f32>;
        let mut cost_7: rt::Vec3<u32>;
        let mut k_26: rt::Scalar<f32> = rt::Scalar(1f32);

        let _e3 = self.v_has_interval(found_10);
        if rt::Scalar::into_branch_condition((!_e3)) {
            let _e5 = self.v_refine_none(path_65, found_10, params_90);
            return _e5;
        }
        before_3 = rt::Scalar(found_10.near);
        last_1 = rt::Scalar(found_10.far);
        before_gap = rt::Scalar(found_10.near_gap);
        last_gap = rt::Scalar(found_10.far_gap);
        cost_7 = found_10.cost;
        if rt::Scalar::into_branch_condition(rt::Scalar(found_10.status).elementwise_ne(FOUND_BRACKET)) {
            let _e19 = before_3;
            let _e20 = self.v_path_gap(path_65, _e19);
            before_gap = _e20;
            let _e21 = last_1;
            let _e22 = self.v_path_gap(path_65, _e21);
            last_gap = _e22;
            let _e23 = cost_7;
            let _e25 = self.v_field_cost_stage(rt::Scalar(path_65.level));
            let _e28 = self.v_field_cost_stage(rt::Scalar(path_65.level));
            cost_7 = ((_e23 + _e25) + _e28);
            let _e30 = last_gap;
            if rt::Scalar::into_branch_condition(_e30.elementwise_gt(rt::Scalar(0f32))) {
                let _e33 = cost_7;
                let _e34 = self.v_miss(_e33);
                return _e34;
            }
        }
        'naga_break: loop {
            'naga_continue: {
                let _e37 = k_26;
                if rt::Scalar::into_branch_condition(_e37.elementwise_le(params_90.x())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e40 = cost_7;
                    cost_7 = (_e40 + STEP);
                    let _e43 = before_gap;
                    let _e44 = last_gap;
                    let change_8 = (_e43 - _e44);
                    if rt::Scalar::into_branch_condition(change_8.elementwise_eq(rt::Scalar(0f32))) {
                        break 'naga_break;
                    }
                    let _e48 = last_1;
                    let _e49 = last_1;
                    let _e50 = before_3;
                    let _e52 = last_gap;
                    let t_53 = (_e48 + ((_e49 - _e50) * (_e52 / change_8))).clamp(rt::Scalar(found_10.near), rt::Scalar(found_10.far));
                    let _e59 = last_1;
                    before_3 = _e59;
                    let _e60 = last_gap;
                    before_gap = _e60;
                    last_1 = t_53;
                    let _e61 = k_26;
                    if rt::Scalar::into_branch_condition(_e61.elementwise_lt(params_90.x())) {
                        let _e64 = self.v_path_gap(path_65, t_53);
                        last_gap = _e64;
                        let _e65 = cost_7;
                        let _e67 = self.v_field_cost_stage(rt::Scalar(path_65.level));
                        cost_7 = (_e65 + _e67);
                    }
                    let _e69 = k_26;
                    k_26 = (_e69 + rt::Scalar(1f32));
                }
            }
        }
        let _e72 = last_1;
        let _e74 = cost_7;
        let _e75 = self.v_hit_on_path(path_65, _e72, rt::Scalar(0u32), _e74);
        return _e75;
    }
    pub(crate) fn refine_patch(
        &self,
        path_66: Path,
        found_11: SearchResult,
        params_91: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_refine_patch(path_66, found_11, rt::into(params_91)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_refine_patch(
        &self,
        path_66: Path,
        found_11: SearchResult,
        params_91: rt::Vec4<f32>,
    ) -> Hit {
        let mut t_30: rt::Scalar<f32>;
        let mut cell_25: rt::Vec2<f32>;
        let mut cost_8: rt::Vec3<u32>;
        let mut local_80: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition(rt::Scalar(found_11.status).elementwise_eq(FOUND_MISS)) {
            let _e7 = self.v_miss(found_11.cost);
            return _e7;
        }
        if rt::Scalar::into_branch_condition(rt::Scalar(found_11.status).elementwise_eq(FOUND_EXHAUSTED)) {
            let _e14 = self.v_hit_on_path(path_66, rt::Scalar(found_11.near), rt::Scalar(1u32), found_11.cost);
            return _e14;
        }
        if rt::Scalar::into_branch_condition(rt::Scalar(found_11.status).elementwise_eq(FOUND_STARTED_BELOW)) {
            let _e21 = self.v_hit_on_path(path_66, rt::Scalar(found_11.near), rt::Scalar(0u32), found_11.cost);
            return _e21;
        }
        let _e22 = self.v_grid_of(path_66);
        t_30 = rt::Scalar(found_11.near);
        let _e27 = t_30;
        let _e30 = self.v_cell_of((_e22.origin + (_e22.step * _e27)));
        cell_25 = _e30;
        cost_8 = found_11.cost;
        let _e35 = cost_8.x();
        let limit_3 = (_e35 + params_91.x().to_u32());
        'naga_break: loop {
            'naga_continue: {
                let _e40 = cost_8.x();
                if rt::Scalar::into_branch_condition(_e40.elementwise_lt(limit_3)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e42 = cost_8;
                    cost_8 = (_e42 + STEP);
                    let _e45 = cell_25;
                    let _e46 = self.v_cell_leave(_e22, _e45);
                    let end_12 = _e46.x().min(_e46.y()).min(rt::Scalar(found_11.far));
                    let _e52 = t_30;
                    let span_9 = (end_12 - _e52).max(rt::Scalar(0f32));
                    let _e56 = cell_25;
                    let _e57 = t_30;
                    let _e58 = self.v_cell_gap(path_66, _e22, _e56, _e57);
                    let _e59 = cost_8;
                    cost_8 = (_e59 + HEIGHTS_READ);
                    if rt::Scalar::into_branch_condition(_e58.x().elementwise_le(rt::Scalar(0f32))) {
                        let _e65 = t_30;
                        let _e67 = cost_8;
                        let _e68 = self.v_hit_on_path(path_66, _e65, rt::Scalar(0u32), _e67);
                        return _e68;
                    }
                    let _e69 = self.v_first_root(_e58, span_9);
                    if rt::Scalar::into_branch_condition(_e69.elementwise_lt(rt::Scalar(300000000000000000000000000000000000000f32))) {
                        let _e72 = t_30;
                        let _e75 = cost_8;
                        let _e76 = self.v_hit_on_path(path_66, (_e72 + _e69), rt::Scalar(0u32), _e75);
                        return _e76;
                    }
                    if rt::Scalar::into_branch_condition(end_12.elementwise_ge(rt::Scalar(found_11.far))) {
                        if rt::Scalar::into_branch_condition((!rt::Scalar(found_11.status).elementwise_eq(FOUND_BRACKET))) {
                            local_80 = rt::Scalar(found_11.status).elementwise_eq(FOUND_BELOW);
                        } else {
                            local_80 = rt::Scalar(true);
                        }
                        let _e89 = local_80;
                        if rt::Scalar::into_branch_condition(_e89) {
                            let _e92 = cost_8;
                            let _e93 = self.v_hit_on_path(path_66, rt::Scalar(found_11.far), rt::Scalar(0u32), _e92);
                            return _e93;
                        }
                        let _e94 = cost_8;
                        let _e95 = self.v_miss(_e94);
                        return _e95;
                    }
                    let _e96 = cell_25;
                    let _e97 = self.v_cell_next(_e22, _e96, _e46);
                    cell_25 = _e97;
                    let _e98 = t_30;
                    t_30 = _e98.max(end_12);
                }
            }
        }
        let _e100 = t_30;
        let _e102 = cost_8;
        let _e103 = self.v_hit_on_path(path_66, _e100, rt::Scalar(1u32), _e102);
        return _e103;
    }
    pub(crate) fn refine_half_texel(
        &self,
        path_67: Path,
        found_12: SearchResult,
        params_92: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_refine_half_texel(path_67, found_12, rt::into(params_92)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_refine_half_texel(
        &self,
        path_67: Path,
        found_12: SearchResult,
        params_92: rt::Vec4<f32>,
    ) -> Hit {
        let mut part_13: rt::Scalar<f32> = rt::Scalar(0.5f32);

        if rt::Scalar::into_branch_condition(rt::Scalar(found_12.status).elementwise_ne(FOUND_BELOW)) {
            let _e6 = self.v_refine_none(path_67, found_12, params_92);
            return _e6;
        }
        let _e9 = self.v_height_size(rt::Scalar(path_67.level));
        let speed_1 = (path_67.duv * _e9).length();
        if rt::Scalar::into_branch_condition((!(speed_1 * rt::Scalar(path_67.exit)).elementwise_gt(rt::Scalar(0.5f32)))) {
            let _e17 = self.v_refine_none(path_67, found_12, params_92);
            return _e17;
        }
        let half_1 = (rt::Scalar(0.5f32) / speed_1);
        let backward = (rt::Scalar(found_12.far) - half_1).max(rt::Scalar(0f32));
        let forward_2 = (rt::Scalar(found_12.far) + half_1).min(rt::Scalar(path_67.exit));
        let _e28 = self.v_path_gap(path_67, backward);
        let before_13 = _e28.abs();
        let _e30 = self.v_path_gap(path_67, forward_2);
        let behind_3 = _e30.abs();
        if rt::Scalar::into_branch_condition((before_13 + behind_3).elementwise_gt(rt::Scalar(0f32))) {
            part_13 = (before_13 / (before_13 + behind_3));
        }
        let cost_32 = ((found_12.cost + HEIGHTS_READ) + HEIGHTS_READ);
        let _e45 = part_13;
        let _e49 = self.v_hit_on_path(path_67, (backward + ((forward_2 - backward) * _e45)), rt::Scalar(0u32), cost_32);
        return _e49;
    }
    pub(crate) fn greatest_value(&self, cell_26: VoxelCell) -> f32 {
        rt::into(self.v_greatest_value(cell_26))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_greatest_value(&self, cell_26: VoxelCell) -> rt::Scalar<f32> {
        let most_17 = cell_26.low.max(cell_26.high);
        return most_17.x().max(most_17.y()).max(most_17.z().max(most_17.w()));
    }
    pub(crate) fn is_above_zero(&self, q_3: Quartic) -> bool {
        rt::into(self.v_is_above_zero(q_3))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_is_above_zero(&self, q_3: Quartic) -> rt::Scalar<bool> {
        let p1_ = (rt::Scalar(q_3.a) + (rt::Scalar(0.25f32) * rt::Scalar(q_3.b)));
        let p2_ = ((rt::Scalar(q_3.a) + (rt::Scalar(0.5f32) * rt::Scalar(q_3.b))) + (rt::Scalar(q_3.c) / rt::Scalar(6f32)));
        let p3_ = (((rt::Scalar(q_3.a) + (rt::Scalar(0.75f32) * rt::Scalar(q_3.b))) + (rt::Scalar(0.5f32) * rt::Scalar(q_3.c))) + (rt::Scalar(0.25f32) * rt::Scalar(q_3.d)));
        let p4_ = ((((rt::Scalar(q_3.a) + rt::Scalar(q_3.b)) + rt::Scalar(q_3.c)) + rt::Scalar(q_3.d)) + rt::Scalar(q_3.e));
        return rt::Scalar(q_3.a).min(p1_).min(p2_.min(p3_)).min(p4_).elementwise_gt(rt::Scalar(0f32));
    }
    pub(crate) fn inflections(&self, q_4: Quartic) -> rt::Vec2<f32> {
        rt::into(self.v_inflections(q_4))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_inflections(&self, q_4: Quartic) -> rt::Vec2<f32> {
        let mut local_81: rt::Scalar<bool>;
        let mut local_82: rt::Scalar<bool>;

        let b_44 = (rt::Scalar(3f32) * rt::Scalar(q_4.d));
        let a_44 = (rt::Scalar(6f32) * rt::Scalar(q_4.e));
        let discriminant_4 = ((b_44 * b_44) - ((rt::Scalar(4f32) * a_44) * rt::Scalar(q_4.c)));
        if rt::Scalar::into_branch_condition((!discriminant_4.elementwise_ge(rt::Scalar(0f32)))) {
            return <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32));
        }
        let root_6 = discriminant_4.sqrt();
        let s_2 = (rt::Scalar(-0.5f32) * (b_44 + (rt::Scalar(0f32) - root_6).select(root_6, b_44.elementwise_ge(rt::Scalar(0f32)))));
        let first_24 = rt::Scalar(1f32).select((s_2 / a_44), a_44.elementwise_ne(rt::Scalar(0f32)));
        let second_11 = rt::Scalar(1f32).select((rt::Scalar(q_4.c) / s_2), s_2.elementwise_ne(rt::Scalar(0f32)));
        if rt::Scalar::into_branch_condition(first_24.elementwise_gt(rt::Scalar(0f32))) {
            local_81 = first_24.elementwise_lt(rt::Scalar(1f32));
        } else {
            local_81 = rt::Scalar(false);
        }
        let _e46 = local_81;
        let x_15 = rt::Scalar(1f32).select(first_24, _e46);
        if rt::Scalar::into_branch_condition(second_11.elementwise_gt(rt::Scalar(0f32))) {
            local_82 = second_11.elementwise_lt(rt::Scalar(1f32));
        } else {
            local_82 = rt::Scalar(false);
        }
        let _e56 = local_82;
        let y_10 = rt::Scalar(1f32).select(second_11, _e56);
        return <rt::Vec2<f32>>::from_scalars(x_15.min(y_10), x_15.max(y_10));
    }
    pub(crate) fn quartic_at(
        &self,
        q_5: Quartic,
        x_4: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_quartic_at(q_5, rt::into(x_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_quartic_at(
        &self,
        q_5: Quartic,
        x_4: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        return (rt::Scalar(q_5.a) + (x_4 * (rt::Scalar(q_5.b) + (x_4 * (rt::Scalar(q_5.c) + (x_4 * (rt::Scalar(q_5.d) + (x_4 * rt::Scalar(q_5.e)))))))));
    }
    pub(crate) fn root_between(
        &self,
        q_6: Quartic,
        above_2: impl rt::Into<rt::Scalar<f32>>,
        below_2: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_root_between(q_6, rt::into(above_2), rt::into(below_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_root_between(
        &self,
        q_6: Quartic,
        above_2: rt::Scalar<f32>,
        below_2: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let mut near_4: rt::Scalar<f32>;
        let mut far_6: rt::Scalar<f32>;
        let mut k_27: rt::Scalar<u32> = rt::Scalar(0u32);

        near_4 = above_2;
        far_6 = below_2;
        'naga_break: loop {
            'naga_continue: {
                let _e7 = k_27;
                if rt::Scalar::into_branch_condition(_e7.elementwise_lt(HALVINGS)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e10 = near_4;
                    let _e11 = far_6;
                    let middle_17 = (rt::Scalar(0.5f32) * (_e10 + _e11));
                    let _e15 = self.v_quartic_at(q_6, middle_17);
                    if rt::Scalar::into_branch_condition(_e15.elementwise_gt(rt::Scalar(0f32))) {
                        near_4 = middle_17;
                    } else {
                        far_6 = middle_17;
                    }
                    let _e18 = k_27;
                    k_27 = (_e18 + rt::Scalar(1u32));
                }
            }
        }
        let _e21 = far_6;
        return _e21;
    }
    pub(crate) fn first_root_of_quartic(&self, q_7: Quartic) -> f32 {
        rt::into(self.v_first_root_of_quartic(q_7))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_first_root_of_quartic(&self, q_7: Quartic) -> rt::Scalar<f32> {
        let mut begin_7: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut k_28: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut local_83: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition((!rt::Scalar(q_7.a).elementwise_gt(rt::Scalar(0f32)))) {
            return rt::Scalar(0f32);
        }
        let _e6 = self.v_is_above_zero(q_7);
        if rt::Scalar::into_branch_condition(_e6) {
            return rt::Scalar(300000000000000000000000000000000000000f32);
        }
        let _e8 = self.v_inflections(q_7);
        'naga_break: loop {
            'naga_continue: {
                let _e13 = k_28;
                if rt::Scalar::into_branch_condition(_e13.elementwise_lt(rt::Scalar(3u32))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e17 = k_28;
                    let _e23 = k_28;
                    let end_13 = rt::Scalar(1f32).select(_e8.y(), _e17.elementwise_eq(rt::Scalar(1u32))).select(_e8.x(), _e23.elementwise_eq(rt::Scalar(0u32)));
                    let _e27 = begin_7;
                    if rt::Scalar::into_branch_condition(end_13.elementwise_gt(_e27)) {
                        let _e29 = begin_7;
                        let _e30 = self.v_quartic_slope(q_7, _e29);
                        let _e31 = self.v_quartic_slope(q_7, end_13);
                        if rt::Scalar::into_branch_condition(_e30.elementwise_lt(rt::Scalar(0f32))) {
                            local_83 = _e31.elementwise_gt(rt::Scalar(0f32));
                        } else {
                            local_83 = rt::Scalar(false);
                        }
                        let _e39 = local_83;
                        if rt::Scalar::into_branch_condition(_e39) {
                            let _e40 = begin_7;
                            let _e41 = self.v_extremum_between(q_7, _e40, end_13);
                            let _e42 = self.v_quartic_at(q_7, _e41);
                            if rt::Scalar::into_branch_condition((!_e42.elementwise_gt(rt::Scalar(0f32)))) {
                                let _e46 = begin_7;
                                let _e47 = self.v_root_between(q_7, _e46, _e41);
                                return _e47;
                            }
                        }
                        let _e48 = self.v_quartic_at(q_7, end_13);
                        if rt::Scalar::into_branch_condition((!_e48.elementwise_gt(rt::Scalar(0f32)))) {
                            let _e52 = begin_7;
                            let _e53 = self.v_root_between(q_7, _e52, end_13);
                            return _e53;
                        }
                    }
                    let _e54 = begin_7;
                    begin_7 = _e54.max(end_13);
                    let _e56 = k_28;
                    k_28 = (_e56 + rt::Scalar(1u32));
                }
            }
        }
        return rt::Scalar(300000000000000000000000000000000000000f32);
    }
    pub(crate) fn root_in_voxel_cell(
        &self,
        way_20: VoxelPath,
        cell_27: impl rt::Into<rt::Vec3<f32>>,
        t_31: impl rt::Into<rt::Scalar<f32>>,
        span_5: impl rt::Into<rt::Scalar<f32>>,
    ) -> RootInCell {
        rt::into(self.v_root_in_voxel_cell(way_20, rt::into(cell_27), rt::into(t_31), rt::into(span_5)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_root_in_voxel_cell(
        &self,
        way_20: VoxelPath,
        cell_27: rt::Vec3<f32>,
        t_31: rt::Scalar<f32>,
        span_5: rt::Scalar<f32>,
    ) -> RootInCell {
        let _e5 = self.v_voxel_cell(cell_27.to_i32());
        let _e6 = self.v_greatest_value(_e5);
        if rt::Scalar::into_branch_condition(_e6.elementwise_lt(rt::Scalar(0.5f32))) {
            return <RootInCell>::new(rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(1f32));
        }
        let _e12 = self.v_gap_in_cell(way_20, cell_27, _e5, t_31, span_5);
        let _e13 = self.v_first_root_of_quartic(_e12);
        return <RootInCell>::new(_e13, rt::Scalar(_e12.a));
    }
    pub(crate) fn first_root_on_path(
        &self,
        path_68: Path,
        from_t: impl rt::Into<rt::Scalar<f32>>,
        to_t: impl rt::Into<rt::Scalar<f32>>,
        limit: impl rt::Into<rt::Scalar<u32>>,
    ) -> SearchResult {
        rt::into(self.v_first_root_on_path(path_68, rt::into(from_t), rt::into(to_t), rt::into(limit)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_first_root_on_path(
        &self,
        path_68: Path,
        from_t: rt::Scalar<f32>,
        to_t: rt::Scalar<f32>,
        limit: rt::Scalar<u32>,
    ) -> SearchResult {
        let mut has_turned_3: rt::Scalar<bool>;
        let mut t_32: rt::Scalar<f32>;
        let mut cell_28: rt::Vec3<f32>;
        let mut cost_9: rt::Vec3<u32> = NO_COST;

        let _e4 = self.v_voxel_path(path_68);
        let _e5 = self.v_turning_point(_e4);
        has_turned_3 = from_t.elementwise_ge(_e5);
        t_32 = from_t;
        let _e9 = t_32;
        let _e10 = self.v_voxel_place_on(_e4, _e9);
        cell_28 = _e10.floor();
        'naga_break: loop {
            'naga_continue: {
                let _e16 = cost_9.y();
                if rt::Scalar::into_branch_condition(_e16.elementwise_lt(limit)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e18 = cost_9;
                    cost_9 = ((_e18 + STEP) + VOXELS_READ);
                    let _e24 = has_turned_3;
                    let end_of_part = _e5.min(to_t).select(to_t, _e24);
                    let _e26 = cell_28;
                    let _e28 = has_turned_3;
                    let _e29 = self.v_voxel_leave(_e4, _e26, rt::Scalar(0f32), _e28);
                    let side_10 = _e29.x().min(_e29.y()).min(_e29.z());
                    let _e36 = t_32;
                    let end_14 = side_10.min(end_of_part).max(_e36);
                    let _e38 = cell_28;
                    let _e39 = t_32;
                    let _e40 = t_32;
                    let _e42 = self.v_root_in_voxel_cell(_e4, _e38, _e39, (end_14 - _e40));
                    if rt::Scalar::into_branch_condition(rt::Scalar(_e42.root).elementwise_lt(rt::Scalar(300000000000000000000000000000000000000f32))) {
                        let _e47 = t_32;
                        let _e48 = t_32;
                        let _e50 = t_32;
                        let _e55 = cost_9;
                        return <SearchResult>::new(FOUND_BRACKET, _e47, (_e48 + (rt::Scalar(_e42.root) * (end_14 - _e50))), rt::Scalar(_e42.gap), rt::Scalar(0f32), _e55);
                    }
                    if rt::Scalar::into_branch_condition(end_14.elementwise_ge(to_t)) {
                        let _e60 = cost_9;
                        return <SearchResult>::new(FOUND_MISS, end_14, end_14, rt::Scalar(1f32), rt::Scalar(1f32), _e60);
                    }
                    if rt::Scalar::into_branch_condition(side_10.elementwise_gt(end_of_part)) {
                        has_turned_3 = rt::Scalar(true);
                    } else {
                        let _e66 = cell_28;
                        let _e68 = has_turned_3;
                        let _e69 = self.v_rises_on(_e4, _e68);
                        let _e70 = self.v_next_voxel_cell(_e4, _e66, rt::Scalar(0f32), _e29, _e69, end_14);
                        cell_28 = _e70;
                    }
                    t_32 = end_14;
                }
            }
        }
        let _e72 = t_32;
        let _e73 = t_32;
        let _e74 = cost_9;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e72, _e73, rt::Scalar(1f32), rt::Scalar(1f32), _e74);
    }
    pub(crate) fn refine_trilinear(
        &self,
        path_69: Path,
        found_13: SearchResult,
        params_93: impl rt::Into<rt::Vec4<f32>>,
    ) -> Hit {
        rt::into(self.v_refine_trilinear(path_69, found_13, rt::into(params_93)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_refine_trilinear(
        &self,
        path_69: Path,
        found_13: SearchResult,
        params_93: rt::Vec4<f32>,
    ) -> Hit {
        let _e3 = self.v_has_interval(found_13);
        if rt::Scalar::into_branch_condition((!_e3)) {
            let _e5 = self.v_refine_none(path_69, found_13, params_93);
            return _e5;
        }
        let _e10 = self.v_first_root_on_path(path_69, rt::Scalar(found_13.near), rt::Scalar(found_13.far), params_93.x().to_u32());
        let cost_33 = (found_13.cost + _e10.cost);
        if rt::Scalar::into_branch_condition(rt::Scalar(_e10.status).elementwise_eq(FOUND_BRACKET)) {
            let _e19 = self.v_hit_on_path(path_69, rt::Scalar(_e10.far), rt::Scalar(0u32), cost_33);
            return _e19;
        }
        if rt::Scalar::into_branch_condition(rt::Scalar(found_13.status).elementwise_eq(FOUND_BRACKET)) {
            let _e30 = self.v_hit_on_path(path_69, rt::Scalar(found_13.far), rt::Scalar(0u32).select(rt::Scalar(1u32), rt::Scalar(_e10.status).elementwise_eq(FOUND_EXHAUSTED)), cost_33);
            return _e30;
        }
        let _e31 = self.v_miss(cost_33);
        return _e31;
    }
    pub(crate) fn refine_stage(&self, path_70: Path, found_14: SearchResult) -> Hit {
        rt::into(self.v_refine_stage(path_70, found_14))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_refine_stage(&self, path_70: Path, found_14: SearchResult) -> Hit {
        let _e6 = rt::Scalar(self.surface_settings.choices[7usize].number);
        match rt::Scalar::into_inner(_e6) {
            0u32 => {
                let _e11 = self.surface_settings.choices[7usize].params;
                let _e12 = self.v_refine_none(path_70, found_14, _e11);
                return _e12;
            }
            1u32 => {
                let _e17 = self.surface_settings.choices[7usize].params;
                let _e18 = self.v_refine_offset(path_70, found_14, _e17);
                return _e18;
            }
            2u32 => {
                let _e23 = self.surface_settings.choices[7usize].params;
                let _e24 = self.v_refine_offset_limited(path_70, found_14, _e23);
                return _e24;
            }
            3u32 => {
                let _e29 = self.surface_settings.choices[7usize].params;
                let _e30 = self.v_refine_slope(path_70, found_14, _e29);
                return _e30;
            }
            4u32 => {
                let _e35 = self.surface_settings.choices[7usize].params;
                let _e36 = self.v_refine_slope_iterative(path_70, found_14, _e35);
                return _e36;
            }
            5u32 => {
                let _e41 = self.surface_settings.choices[7usize].params;
                let _e42 = self.v_refine_binary(path_70, found_14, _e41);
                return _e42;
            }
            6u32 => {
                let _e47 = self.surface_settings.choices[7usize].params;
                let _e48 = self.v_refine_secant(path_70, found_14, _e47);
                return _e48;
            }
            7u32 => {
                let _e53 = self.surface_settings.choices[7usize].params;
                let _e54 = self.v_refine_true_secant(path_70, found_14, _e53);
                return _e54;
            }
            8u32 => {
                let _e59 = self.surface_settings.choices[7usize].params;
                let _e60 = self.v_refine_patch(path_70, found_14, _e59);
                return _e60;
            }
            9u32 => {
                let _e65 = self.surface_settings.choices[7usize].params;
                let _e66 = self.v_refine_half_texel(path_70, found_14, _e65);
                return _e66;
            }
            _ => {
                let _e71 = self.surface_settings.choices[7usize].params;
                let _e72 = self.v_refine_trilinear(path_70, found_14, _e71);
                return _e72;
            }
        }
    }
    pub(crate) fn search_none(
        &self,
        path_71: Path,
        params_94: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_none(path_71, rt::into(params_94)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_search_none(
        &self,
        path_71: Path,
        params_94: rt::Vec4<f32>,
    ) -> SearchResult {
        return <SearchResult>::new(FOUND_UNBRACKETED, rt::Scalar(0f32), rt::Scalar(path_71.exit), rt::Scalar(0f32), rt::Scalar(0f32), NO_COST);
    }
    pub(crate) fn search_linear(
        &self,
        path_72: Path,
        params_95: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_linear(path_72, rt::into(params_95)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_linear(
        &self,
        path_72: Path,
        params_95: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut near_5: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut near_gap_2: rt::Scalar<f32>;
        let mut cost_10: rt::Vec3<u32>;
        let mut k_29: rt::Scalar<f32> = rt::Scalar(1f32);

        let cosine_12 = (path_72.h.y().abs() * path_72.metric.w()).clamp(rt::Scalar(0f32), rt::Scalar(1f32));
        let steps_2 = rt::Scalar(1f32).max(((params_95.x() * params_95.y().mix_scalar(rt::Scalar(1f32), cosine_12)) * rt::Scalar(path_72.share)).ceil());
        let _e24 = self.v_path_gap(path_72, rt::Scalar(0f32));
        near_gap_2 = _e24;
        let _e27 = self.v_field_cost_stage(rt::Scalar(path_72.level));
        cost_10 = _e27;
        let _e29 = near_gap_2;
        if rt::Scalar::into_branch_condition(_e29.elementwise_lt(rt::Scalar(0f32))) {
            let _e33 = near_gap_2;
            let _e34 = near_gap_2;
            let _e35 = cost_10;
            return <SearchResult>::new(FOUND_STARTED_BELOW, rt::Scalar(0f32), rt::Scalar(0f32), _e33, _e34, _e35);
        }
        'naga_break: loop {
            'naga_continue: {
                let _e41 = k_29;
                if rt::Scalar::into_branch_condition(_e41.elementwise_le(steps_2)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e43 = cost_10;
                    cost_10 = (_e43 + STEP);
                    let _e47 = k_29;
                    let t_54 = (rt::Scalar(path_72.exit) * (_e47 / steps_2));
                    let _e50 = self.v_path_gap(path_72, t_54);
                    let _e51 = cost_10;
                    let _e53 = self.v_field_cost_stage(rt::Scalar(path_72.level));
                    cost_10 = (_e51 + _e53);
                    if rt::Scalar::into_branch_condition(_e50.elementwise_le(rt::Scalar(0f32))) {
                        let _e58 = near_5;
                        let _e59 = near_gap_2;
                        let _e60 = cost_10;
                        return <SearchResult>::new(FOUND_BRACKET, _e58, t_54, _e59, _e50, _e60);
                    }
                    near_5 = t_54;
                    near_gap_2 = _e50;
                    let _e62 = k_29;
                    k_29 = (_e62 + rt::Scalar(1f32));
                }
            }
        }
        let _e66 = near_5;
        let _e67 = near_5;
        let _e68 = near_gap_2;
        let _e69 = near_gap_2;
        let _e70 = cost_10;
        return <SearchResult>::new(FOUND_MISS, _e66, _e67, _e68, _e69, _e70);
    }
    pub(crate) fn found_in_cell(
        &self,
        c_12: impl rt::Into<rt::Vec3<f32>>,
        t_33: impl rt::Into<rt::Scalar<f32>>,
        span_6: impl rt::Into<rt::Scalar<f32>>,
        first_3: impl rt::Into<rt::Scalar<bool>>,
        cost_11: impl rt::Into<rt::Vec3<u32>>,
    ) -> SearchResult {
        rt::into(self.v_found_in_cell(rt::into(c_12), rt::into(t_33), rt::into(span_6), rt::into(first_3), rt::into(cost_11)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_found_in_cell(
        &self,
        c_12: rt::Vec3<f32>,
        t_33: rt::Scalar<f32>,
        span_6: rt::Scalar<f32>,
        first_3: rt::Scalar<bool>,
        cost_11: rt::Vec3<u32>,
    ) -> SearchResult {
        let mut local_84: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition(c_12.x().elementwise_le(rt::Scalar(0f32))) {
            if rt::Scalar::into_branch_condition(first_3) {
                local_84 = c_12.x().elementwise_lt(rt::Scalar(0f32));
            } else {
                local_84 = rt::Scalar(false);
            }
            let _e14 = local_84;
            if rt::Scalar::into_branch_condition(_e14) {
                return <SearchResult>::new(FOUND_STARTED_BELOW, rt::Scalar(0f32), rt::Scalar(0f32), c_12.x(), c_12.x(), cost_11);
            }
            return <SearchResult>::new(FOUND_BRACKET, t_33, t_33, c_12.x(), c_12.x(), cost_11);
        }
        let _e25 = self.v_least_at(c_12, span_6);
        let _e29 = self.v_quadratic(c_12, _e25);
        return <SearchResult>::new(FOUND_BRACKET, t_33, (t_33 + _e25), c_12.x(), _e29, cost_11);
    }
    pub(crate) fn search_cells(
        &self,
        path_73: Path,
        params_96: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_cells(path_73, rt::into(params_96)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_cells(
        &self,
        path_73: Path,
        params_96: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut cell_29: rt::Vec2<f32>;
        let mut t_34: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_12: rt::Vec3<u32> = NO_COST;

        let _e2 = self.v_grid_of(path_73);
        let _e4 = self.v_cell_of(_e2.origin);
        cell_29 = _e4;
        let limit_4 = params_96.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e13 = cost_12.x();
                if rt::Scalar::into_branch_condition(_e13.elementwise_lt(limit_4)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e15 = cost_12;
                    cost_12 = (_e15 + STEP);
                    let _e18 = cell_29;
                    let _e19 = t_34;
                    let _e20 = self.v_cell_gap(path_73, _e2, _e18, _e19);
                    let _e21 = cost_12;
                    cost_12 = (_e21 + HEIGHTS_READ);
                    let _e24 = cell_29;
                    let _e25 = self.v_cell_leave(_e2, _e24);
                    let end_15 = _e25.x().min(_e25.y()).min(rt::Scalar(path_73.exit));
                    let _e31 = t_34;
                    let span_10 = (end_15 - _e31).max(rt::Scalar(0f32));
                    let _e35 = self.v_falls_in_cell(_e20, span_10);
                    if rt::Scalar::into_branch_condition(_e35) {
                        let _e36 = t_34;
                        let _e38 = cost_12.x();
                        let _e41 = cost_12;
                        let _e42 = self.v_found_in_cell(_e20, _e36, span_10, _e38.elementwise_eq(rt::Scalar(1u32)), _e41);
                        return _e42;
                    }
                    if rt::Scalar::into_branch_condition(end_15.elementwise_ge(rt::Scalar(path_73.exit))) {
                        let _e46 = t_34;
                        let _e49 = self.v_quadratic(_e20, span_10);
                        let _e50 = cost_12;
                        return <SearchResult>::new(FOUND_MISS, _e46, rt::Scalar(path_73.exit), _e20.x(), _e49, _e50);
                    }
                    let _e52 = cell_29;
                    let _e53 = self.v_cell_next(_e2, _e52, _e25);
                    cell_29 = _e53;
                    let _e54 = t_34;
                    t_34 = _e54.max(end_15);
                }
            }
        }
        let _e57 = t_34;
        let _e59 = cost_12;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e57, rt::Scalar(path_73.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e59);
    }
    pub(crate) fn image_of(
        &self,
        cell_30: impl rt::Into<rt::Scalar<i32>>,
        n_14: impl rt::Into<rt::Scalar<i32>>,
    ) -> rt::Vec2<i32> {
        rt::into(self.v_image_of(rt::into(cell_30), rt::into(n_14)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_image_of(
        &self,
        cell_30: rt::Scalar<i32>,
        n_14: rt::Scalar<i32>,
    ) -> rt::Vec2<i32> {
        let mut local_85: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition(cell_30.elementwise_ge(rt::Scalar(0i32))) {
            local_85 = cell_30.elementwise_lt(n_14);
        } else {
            local_85 = rt::Scalar(false);
        }
        let _e8 = local_85;
        if rt::Scalar::into_branch_condition(_e8) {
            return <rt::Vec2<i32>>::from_scalars(cell_30, rt::Scalar(0i32));
        }
        let _e13 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e13.elementwise_eq(WRAP_CLAMP)) {
            return <rt::Vec2<i32>>::from_scalars(cell_30.clamp(rt::Scalar(0i32), (n_14 - rt::Scalar(1i32))), rt::Scalar(2i32));
        }
        let _e24 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e24.elementwise_eq(WRAP_REPEAT)) {
            return <rt::Vec2<i32>>::from_scalars((((cell_30 % n_14) + n_14) % n_14), rt::Scalar(0i32));
        }
        let period_3 = (rt::Scalar(2i32) * n_14);
        let folded = (((cell_30 % period_3) + period_3) % period_3);
        if rt::Scalar::into_branch_condition(folded.elementwise_lt(n_14)) {
            return <rt::Vec2<i32>>::from_scalars(folded, rt::Scalar(0i32));
        }
        if rt::Scalar::into_branch_condition(folded.elementwise_eq((period_3 - rt::Scalar(1i32)))) {
            return <rt::Vec2<i32>>::from_scalars(rt::Scalar(0i32), rt::Scalar(2i32));
        }
        return <rt::Vec2<i32>>::from_scalars(((period_3 - rt::Scalar(2i32)) - folded), rt::Scalar(1i32));
    }
    pub(crate) fn frustum_slope(
        &self,
        path_74: Path,
        cell_31: impl rt::Into<rt::Vec2<i32>>,
        forward_1: impl rt::Into<rt::Vec2<bool>>,
    ) -> f32 {
        rt::into(self.v_frustum_slope(path_74, rt::into(cell_31), rt::into(forward_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_frustum_slope(
        &self,
        path_74: Path,
        cell_31: rt::Vec2<i32>,
        forward_1: rt::Vec2<bool>,
    ) -> rt::Scalar<f32> {
        let mut local_86: rt::Scalar<bool>;

        let _e4 = self.v_height_texels(rt::Scalar(path_74.level));
        let _e7 = self.v_image_of(cell_31.x(), _e4.x());
        let _e10 = self.v_image_of(cell_31.y(), _e4.y());
        if rt::Scalar::into_branch_condition((!_e7.y().elementwise_eq(rt::Scalar(2i32)))) {
            local_86 = _e10.y().elementwise_eq(rt::Scalar(2i32));
        } else {
            local_86 = rt::Scalar(true);
        }
        let _e21 = local_86;
        if rt::Scalar::into_branch_condition(_e21) {
            return rt::Scalar(-1f32);
        }
        let _e29 = self.v_search_texel(path_74, <rt::Vec2<i32>>::from_scalars(_e7.x(), _e10.x()), rt::Scalar(0i32), rt::Scalar(path_74.level).to_i32());
        let right_4 = forward_1.x().elementwise_eq(_e7.y().elementwise_eq(rt::Scalar(0i32)));
        let down = forward_1.y().elementwise_eq(_e10.y().elementwise_eq(rt::Scalar(0i32)));
        return _e29.w().select(_e29.z(), right_4).select(_e29.y().select(_e29.x(), right_4), down);
    }
    pub(crate) fn map_read(
        &self,
        path_75: Path,
        texels_3: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec3<u32> {
        rt::into(self.v_map_read(path_75, rt::into(texels_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_map_read(
        &self,
        path_75: Path,
        texels_3: rt::Scalar<u32>,
    ) -> rt::Vec3<u32> {
        let slot = SLOT_SEARCH.select(SLOT_SHADOW_SEARCH, rt::Scalar(path_75.ray).elementwise_eq(RAY_SHADOW));
        let _e14 = rt::Scalar(self.surface_settings.maps[rt::Scalar::into_array_index(slot)].texel_bytes);
        return <rt::Vec3<u32>>::from_scalars(rt::Scalar(1u32), rt::Scalar(0u32), (texels_3 * _e14));
    }
    pub(crate) fn stays_above(
        &self,
        above_3: impl rt::Into<rt::Vec3<f32>>,
        slope_2: impl rt::Into<rt::Scalar<f32>>,
        left: impl rt::Into<rt::Scalar<f32>>,
        speed: impl rt::Into<rt::Scalar<f32>>,
        lost: impl rt::Into<rt::Scalar<f32>>,
        span_7: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_stays_above(rt::into(above_3), rt::into(slope_2), rt::into(left), rt::into(speed), rt::into(lost), rt::into(span_7)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_stays_above(
        &self,
        above_3: rt::Vec3<f32>,
        slope_2: rt::Scalar<f32>,
        left: rt::Scalar<f32>,
        speed: rt::Scalar<f32>,
        lost: rt::Scalar<f32>,
        span_7: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let rise_5 = (slope_2 * speed.abs());
        let gap_4 = ((above_3.x() + (slope_2 * left)) - lost);
        if rt::Scalar::into_branch_condition(gap_4.elementwise_le(rt::Scalar(0f32))) {
            return rt::Scalar(0f32);
        }
        let closing_2 = ((rise_5 - above_3.y()) + (rt::Scalar(0.0000009536743f32) * (rise_5 + above_3.y().abs())));
        if rt::Scalar::into_branch_condition(above_3.z().elementwise_ne(rt::Scalar(0f32))) {
            let _e30 = self.v_first_root(<rt::Vec3<f32>>::from_scalars(gap_4, (rt::Scalar(0f32) - closing_2), above_3.z()), span_7);
            return _e30;
        }
        if rt::Scalar::into_branch_condition(closing_2.elementwise_gt(rt::Scalar(0f32))) {
            return (gap_4 / closing_2);
        }
        return rt::Scalar(300000000000000000000000000000000000000f32);
    }
    pub(crate) fn search_frustum(
        &self,
        path_76: Path,
        params_97: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_frustum(path_76, rt::into(params_97)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_frustum(
        &self,
        path_76: Path,
        params_97: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut cell_32: rt::Vec2<f32>;
        let mut t_35: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_13: rt::Vec3<u32> = NO_COST;
        let mut next_3: rt::Scalar<f32>;
        let mut slope_3: rt::Scalar<f32>;
        let mut local_87: rt::Scalar<bool>;

        let _e2 = self.v_grid_of(path_76);
        let forward_3 = _e2.step.elementwise_ge(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)));
        let _e9 = self.v_cell_of(_e2.origin);
        cell_32 = _e9;
        let limit_5 = params_97.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e18 = cost_13.x();
                if rt::Scalar::into_branch_condition(_e18.elementwise_lt(limit_5)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e20 = cost_13;
                    cost_13 = (_e20 + STEP);
                    let _e24 = cost_13.x();
                    let first_25 = _e24.elementwise_eq(rt::Scalar(0u32));
                    let _e27 = cell_32;
                    let _e28 = self.v_whole_cell(_e27);
                    let _e30 = self.v_height_cell(_e28, rt::Scalar(path_76.level));
                    let _e31 = cost_13;
                    cost_13 = (_e31 + HEIGHTS_READ);
                    let _e34 = cell_32;
                    let _e35 = self.v_cell_leave(_e2, _e34);
                    let end_16 = _e35.x().min(_e35.y()).min(rt::Scalar(path_76.exit));
                    let _e41 = t_35;
                    let span_11 = (end_16 - _e41).max(rt::Scalar(0f32));
                    let top_11 = _e30.x().max(_e30.y()).max(_e30.z().max(_e30.w()));
                    let _e52 = t_35;
                    let _e53 = self.v_path_height(path_76, _e52);
                    let _e55 = t_35;
                    let _e56 = self.v_path_slope(path_76, _e55);
                    let above_10 = <rt::Vec3<f32>>::from_scalars((_e53 - top_11), _e56, path_76.h.z());
                    let _e63 = t_35;
                    let _e67 = t_35;
                    let of_heights = (rt::Scalar(0.0000009536743f32) * (path_76.h.x().abs() + (_e63 * (path_76.h.y().abs() + (_e67 * path_76.h.z().abs())))));
                    let _e77 = t_35;
                    next_3 = _e77.max(end_16);
                    slope_3 = rt::Scalar(-1f32);
                    let _e82 = self.v_least_at(above_10, span_11);
                    let _e83 = self.v_quadratic(above_10, _e82);
                    if rt::Scalar::into_branch_condition(_e83.elementwise_gt(of_heights)) {
                        local_87 = above_10.x().elementwise_gt(of_heights);
                    } else {
                        local_87 = rt::Scalar(false);
                    }
                    let _e90 = local_87;
                    if rt::Scalar::into_branch_condition(_e90) {
                        if rt::Scalar::into_branch_condition(end_16.elementwise_lt(rt::Scalar(path_76.exit))) {
                            let _e93 = cell_32;
                            let _e94 = self.v_whole_cell(_e93);
                            let _e95 = self.v_frustum_slope(path_76, _e94, forward_3);
                            slope_3 = _e95;
                            let _e96 = slope_3;
                            if rt::Scalar::into_branch_condition(_e96.elementwise_ge(rt::Scalar(0f32))) {
                                let _e99 = cost_13;
                                let _e101 = self.v_map_read(path_76, rt::Scalar(1u32));
                                cost_13 = (_e99 + _e101);
                            }
                        }
                    } else {
                        let _e103 = cell_32;
                        let _e104 = t_35;
                        let _e105 = self.v_gap_to(path_76, _e2, _e103, _e30, _e104);
                        let _e106 = self.v_falls_in_cell(_e105, span_11);
                        if rt::Scalar::into_branch_condition(_e106) {
                            let _e107 = t_35;
                            let _e108 = cost_13;
                            let _e109 = self.v_found_in_cell(_e105, _e107, span_11, first_25, _e108);
                            return _e109;
                        }
                    }
                    let _e110 = slope_3;
                    if rt::Scalar::into_branch_condition(_e110.elementwise_ge(rt::Scalar(0f32))) {
                        let _e114 = cell_32;
                        let _e117 = t_35;
                        let at_184 = ((_e2.origin - _e114) + (_e2.step * _e117));
                        let left_5 = at_184.select((<rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32)) - at_184), forward_3);
                        let _e129 = t_35;
                        let far_15 = ((_e2.origin.abs() + (_e2.step.abs() * _e129)) + <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32)));
                        let _e137 = slope_3;
                        let lost_1 = (<rt::Vec2<f32>>::from_scalars(of_heights, of_heights) + ((rt::Scalar(0.0000009536743f32) * _e137) * far_15));
                        let _e143 = t_35;
                        let rest_11 = (rt::Scalar(path_76.exit) - _e143);
                        let _e145 = slope_3;
                        let _e150 = self.v_stays_above(above_10, _e145, left_5.x(), _e2.step.x(), lost_1.x(), rest_11);
                        let _e151 = slope_3;
                        let _e156 = self.v_stays_above(above_10, _e151, left_5.y(), _e2.step.y(), lost_1.y(), rest_11);
                        let _e157 = next_3;
                        let _e158 = t_35;
                        next_3 = _e157.max((_e158 + _e150.min(_e156)));
                    }
                    let _e162 = next_3;
                    if rt::Scalar::into_branch_condition(_e162.elementwise_ge(rt::Scalar(path_76.exit))) {
                        let _e166 = t_35;
                        let _e168 = cost_13;
                        return <SearchResult>::new(FOUND_MISS, _e166, rt::Scalar(path_76.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e168);
                    }
                    let _e172 = slope_3;
                    if rt::Scalar::into_branch_condition(_e172.elementwise_ge(rt::Scalar(0f32))) {
                        let _e175 = cell_32;
                        let _e176 = next_3;
                        let _e177 = self.v_cell_after(_e2, _e175, _e35, forward_3, _e176);
                        cell_32 = _e177;
                    } else {
                        let _e178 = cell_32;
                        let _e179 = self.v_cell_next(_e2, _e178, _e35);
                        cell_32 = _e179;
                    }
                    let _e180 = next_3;
                    t_35 = _e180;
                }
            }
        }
        let _e182 = t_35;
        let _e184 = cost_13;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e182, rt::Scalar(path_76.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e184);
    }
    pub(crate) fn nearest_corner(&self, at_116: impl rt::Into<rt::Vec2<f32>>) -> rt::Vec2<f32> {
        rt::into(self.v_nearest_corner(rt::into(at_116)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_nearest_corner(&self, at_116: rt::Vec2<f32>) -> rt::Vec2<f32> {
        return <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)).select(<rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32)), at_116.elementwise_ge(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32))));
    }
    pub(crate) fn stays_inside(
        &self,
        path_77: Path,
        grid_8: Grid,
        offset_6: impl rt::Into<rt::Vec2<f32>>,
        apex: impl rt::Into<rt::Scalar<f32>>,
        slope_4: impl rt::Into<rt::Scalar<f32>>,
        t_36: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_stays_inside(path_77, grid_8, rt::into(offset_6), rt::into(apex), rt::into(slope_4), rt::into(t_36)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_stays_inside(
        &self,
        path_77: Path,
        grid_8: Grid,
        offset_6: rt::Vec2<f32>,
        apex: rt::Scalar<f32>,
        slope_4: rt::Scalar<f32>,
        t_36: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let mut most_1: rt::Scalar<f32>;
        let mut local_88: rt::Scalar<bool>;
        let mut leave_6: rt::Scalar<f32> = rt::Scalar(300000000000000000000000000000000000000f32);

        let rest_12 = (rt::Scalar(path_77.exit) - t_36);
        let _e8 = self.v_path_height(path_77, t_36);
        let height_26 = (_e8 - apex);
        let terms = (path_77.h.y().abs() + ((rt::Scalar(2f32) * rt::Scalar(path_77.exit)) * path_77.h.z().abs()));
        let _e21 = self.v_path_slope(path_77, t_36);
        let rise_6 = ((_e21 + (path_77.h.z().min(rt::Scalar(0f32)) * rest_12)) - (rt::Scalar(0.0000009536743f32) * terms));
        most_1 = rest_12;
        if rt::Scalar::into_branch_condition(rise_6.elementwise_lt(rt::Scalar(0f32))) {
            let _e34 = most_1;
            most_1 = _e34.min((height_26 / (rt::Scalar(0f32) - rise_6)));
        }
        let _e39 = most_1;
        let end_17 = (t_36 + _e39);
        let _e52 = self.v_height_size(rt::Scalar(path_77.level));
        let far_16 = (((grid_8.origin.abs() + (grid_8.step.abs() * end_17)) + <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32))) / _e52);
        let of_heights_1 = (rt::Scalar(0.0000009536743f32) * (path_77.h.x().abs() + (end_17 * (path_77.h.y().abs() + (end_17 * path_77.h.z().abs())))));
        let lost_2 = (of_heights_1 + ((rt::Scalar(0.0000009536743f32) * slope_4) * (far_16.x() + far_16.y())));
        let gap_5 = (height_26 - (rt::Scalar(2f32) * lost_2));
        let _e85 = self.v_height_size(rt::Scalar(path_77.level));
        let aside_7 = (((grid_8.origin - offset_6) + (grid_8.step * t_36)) / _e85);
        let c_30 = (((slope_4 * aside_7.length()) - gap_5) * ((slope_4 * aside_7.length()) + gap_5));
        if rt::Scalar::into_branch_condition((!gap_5.elementwise_le(rt::Scalar(0f32)))) {
            local_88 = c_30.elementwise_ge(rt::Scalar(0f32));
        } else {
            local_88 = rt::Scalar(true);
        }
        let _e102 = local_88;
        if rt::Scalar::into_branch_condition(_e102) {
            return rt::Scalar(0f32);
        }
        let b_45 = (((slope_4 * slope_4) * aside_7.dot(path_77.duv)) - (gap_5 * rise_6));
        let a_45 = (((slope_4 * slope_4) * path_77.duv.dot(path_77.duv)) - (rise_6 * rise_6));
        let discriminant_5 = ((b_45 * b_45) - (a_45 * c_30));
        if rt::Scalar::into_branch_condition(discriminant_5.elementwise_ge(rt::Scalar(0f32))) {
            let root_7 = discriminant_5.sqrt();
            if rt::Scalar::into_branch_condition(b_45.elementwise_ge(rt::Scalar(0f32))) {
                leave_6 = ((rt::Scalar(0f32) - c_30) / (b_45 + root_7));
            } else {
                if rt::Scalar::into_branch_condition(a_45.elementwise_gt(rt::Scalar(0f32))) {
                    leave_6 = ((root_7 - b_45) / a_45);
                }
            }
        }
        let _e135 = leave_6;
        let _e136 = most_1;
        leave_6 = _e135.min(_e136);
        let _e139 = leave_6;
        let _e145 = leave_6;
        if rt::Scalar::into_branch_condition(((slope_4 * (aside_7 + (path_77.duv * _e139)).length()) + lost_2).elementwise_le((height_26 + (rise_6 * _e145)))) {
            let _e149 = leave_6;
            return _e149;
        }
        return rt::Scalar(0f32);
    }
    pub(crate) fn search_cone(
        &self,
        path_78: Path,
        params_98: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_cone(path_78, rt::into(params_98)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_cone(
        &self,
        path_78: Path,
        params_98: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut cell_33: rt::Vec2<f32>;
        let mut t_37: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_14: rt::Vec3<u32> = NO_COST;
        let mut next_4: rt::Scalar<f32>;

        let _e2 = self.v_grid_of(path_78);
        let forward_4 = _e2.step.elementwise_ge(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)));
        let _e9 = self.v_cell_of(_e2.origin);
        cell_33 = _e9;
        let limit_6 = params_98.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e18 = cost_14.x();
                if rt::Scalar::into_branch_condition(_e18.elementwise_lt(limit_6)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e20 = cost_14;
                    cost_14 = (_e20 + STEP);
                    let _e24 = cost_14.x();
                    let first_26 = _e24.elementwise_eq(rt::Scalar(0u32));
                    let _e27 = cell_33;
                    let _e28 = self.v_whole_cell(_e27);
                    let _e30 = self.v_height_cell(_e28, rt::Scalar(path_78.level));
                    let _e31 = cost_14;
                    cost_14 = (_e31 + HEIGHTS_READ);
                    let _e34 = cell_33;
                    let _e35 = self.v_cell_leave(_e2, _e34);
                    let end_18 = _e35.x().min(_e35.y()).min(rt::Scalar(path_78.exit));
                    let _e41 = t_37;
                    let span_12 = (end_18 - _e41).max(rt::Scalar(0f32));
                    let _e46 = cell_33;
                    let _e49 = t_37;
                    let at_185 = ((_e2.origin - _e46) + (_e2.step * _e49));
                    let _e52 = self.v_nearest_corner(at_185);
                    let _e53 = self.v_corner_height(_e30, _e52);
                    let _e54 = t_37;
                    next_4 = _e54;
                    let _e56 = t_37;
                    let _e57 = self.v_path_height(path_78, _e56);
                    if rt::Scalar::into_branch_condition(_e57.elementwise_gt(_e53)) {
                        let _e59 = cell_33;
                        let texel_11 = (_e59 + _e52);
                        let _e61 = self.v_cone_slope(path_78, texel_11);
                        let _e62 = cost_14;
                        let _e64 = self.v_map_read(path_78, rt::Scalar(1u32));
                        cost_14 = (_e62 + _e64);
                        if rt::Scalar::into_branch_condition(_e61.elementwise_ge(rt::Scalar(0f32))) {
                            let _e68 = t_37;
                            let _e69 = t_37;
                            let _e70 = self.v_stays_inside(path_78, _e2, texel_11, _e53, _e61, _e69);
                            next_4 = (_e68 + _e70);
                        }
                    }
                    let _e72 = next_4;
                    if rt::Scalar::into_branch_condition(_e72.elementwise_lt(end_18)) {
                        let _e74 = cell_33;
                        let _e75 = t_37;
                        let _e76 = self.v_gap_to(path_78, _e2, _e74, _e30, _e75);
                        let _e77 = self.v_falls_in_cell(_e76, span_12);
                        if rt::Scalar::into_branch_condition(_e77) {
                            let _e78 = t_37;
                            let _e79 = cost_14;
                            let _e80 = self.v_found_in_cell(_e76, _e78, span_12, first_26, _e79);
                            return _e80;
                        }
                        let _e81 = t_37;
                        next_4 = _e81.max(end_18);
                    }
                    let _e83 = next_4;
                    if rt::Scalar::into_branch_condition(_e83.elementwise_ge(rt::Scalar(path_78.exit))) {
                        let _e87 = t_37;
                        let _e89 = cost_14;
                        return <SearchResult>::new(FOUND_MISS, _e87, rt::Scalar(path_78.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e89);
                    }
                    let _e93 = cell_33;
                    let _e94 = next_4;
                    let _e95 = self.v_cell_after(_e2, _e93, _e35, forward_4, _e94);
                    cell_33 = _e95;
                    let _e96 = next_4;
                    t_37 = _e96;
                }
            }
        }
        let _e98 = t_37;
        let _e100 = cost_14;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e98, rt::Scalar(path_78.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e100);
    }
    pub(crate) fn node_extent(
        &self,
        cell_34: impl rt::Into<rt::Scalar<i32>>,
        image_10: impl rt::Into<rt::Vec2<i32>>,
        n_15: impl rt::Into<rt::Scalar<i32>>,
        level_51: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec2<i32> {
        rt::into(self.v_node_extent(rt::into(cell_34), rt::into(image_10), rt::into(n_15), rt::into(level_51)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_node_extent(
        &self,
        cell_34: rt::Scalar<i32>,
        image_10: rt::Vec2<i32>,
        n_15: rt::Scalar<i32>,
        level_51: rt::Scalar<u32>,
    ) -> rt::Vec2<i32> {
        let mut local_89: rt::Scalar<bool>;

        let first_27 = ((image_10.x() >> level_51) << level_51);
        let side_11 = (rt::Scalar(1i32) << level_51);
        if rt::Scalar::into_branch_condition(image_10.y().elementwise_eq(rt::Scalar(0i32))) {
            let low_8 = (cell_34 - (image_10.x() - first_27));
            return <rt::Vec2<i32>>::from_scalars(low_8, (low_8 + side_11.min((n_15 - first_27))));
        }
        if rt::Scalar::into_branch_condition(image_10.y().elementwise_eq(rt::Scalar(1i32))) {
            let high_5 = ((cell_34 + (image_10.x() - first_27)) + rt::Scalar(1i32));
            return <rt::Vec2<i32>>::from_scalars((high_5 - side_11.min(((n_15 - rt::Scalar(1i32)) - first_27))), high_5);
        }
        if rt::Scalar::into_branch_condition(level_51.elementwise_gt(rt::Scalar(0u32))) {
            let _e39 = rt::Scalar(self.surface_settings.wrap);
            local_89 = _e39.elementwise_eq(WRAP_CLAMP);
        } else {
            local_89 = rt::Scalar(false);
        }
        let _e43 = local_89;
        if rt::Scalar::into_branch_condition(_e43) {
            return <rt::Vec2<i32>>::from_scalars(rt::Scalar(-1073741824i32).select(n_15, cell_34.elementwise_ge(n_15)), rt::Scalar(0i32).select(rt::Scalar(1073741824i32), cell_34.elementwise_ge(n_15)));
        }
        return <rt::Vec2<i32>>::from_scalars(cell_34, (cell_34 + rt::Scalar(1i32)));
    }
    pub(crate) fn leaves_extent(
        &self,
        origin_1: impl rt::Into<rt::Scalar<f32>>,
        step_3: impl rt::Into<rt::Scalar<f32>>,
        extent: impl rt::Into<rt::Vec2<i32>>,
    ) -> f32 {
        rt::into(self.v_leaves_extent(rt::into(origin_1), rt::into(step_3), rt::into(extent)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_leaves_extent(
        &self,
        origin_1: rt::Scalar<f32>,
        step_3: rt::Scalar<f32>,
        extent: rt::Vec2<i32>,
    ) -> rt::Scalar<f32> {
        if rt::Scalar::into_branch_condition(step_3.elementwise_gt(rt::Scalar(0f32))) {
            return ((extent.y().to_f32() - origin_1) / step_3);
        }
        if rt::Scalar::into_branch_condition(step_3.elementwise_lt(rt::Scalar(0f32))) {
            return ((extent.x().to_f32() - origin_1) / step_3);
        }
        return rt::Scalar(300000000000000000000000000000000000000f32);
    }
    pub(crate) fn search_pyramid(
        &self,
        path_79: Path,
        params_99: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_pyramid(path_79, rt::into(params_99)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_pyramid(
        &self,
        path_79: Path,
        params_99: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut top: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut level_52: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut cell_35: rt::Vec2<i32>;
        let mut parent: rt::Vec2<i32> = <rt::Vec2<i32>>::from_scalars(rt::Scalar(-1i32), rt::Scalar(-1i32));
        let mut t_38: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_15: rt::Vec3<u32> = NO_COST;
        let mut local_90: rt::Scalar<bool>;
        let mut local_91: rt::Scalar<bool>;
        let mut local_92: rt::Scalar<bool>;

        let _e2 = self.v_grid_of(path_79);
        let _e4 = self.v_height_texels(rt::Scalar(path_79.level));
        let long_5 = (_e2.step.x().abs().max(_e2.step.y().abs()) * rt::Scalar(path_79.exit));
        'naga_break: loop {
            'naga_continue: {
                let _e18 = top;
                if rt::Scalar::into_branch_condition((rt::Scalar(1i32) << _e18).elementwise_lt(_e4.x().max(_e4.y()))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e25 = top;
                    top = (_e25 + rt::Scalar(1u32));
                    let _e28 = level_52;
                    if rt::Scalar::into_branch_condition((rt::Scalar(1i32) << _e28).to_f32().elementwise_lt(long_5)) {
                        let _e33 = level_52;
                        level_52 = (_e33 + rt::Scalar(1u32));
                    }
                }
            }
        }
        let _e37 = self.v_cell_of(_e2.origin);
        cell_35 = _e37.to_i32();
        let limit_7 = params_99.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e51 = cost_15.x();
                if rt::Scalar::into_branch_condition(_e51.elementwise_lt(limit_7)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e53 = cost_15;
                    cost_15 = (_e53 + STEP);
                    let _e57 = cell_35.x();
                    let _e59 = self.v_image_of(_e57, _e4.x());
                    let _e61 = cell_35.y();
                    let _e63 = self.v_image_of(_e61, _e4.y());
                    let place_44 = <rt::Vec2<i32>>::from_scalars(_e59.x(), _e63.x());
                    let _e67 = level_52;
                    let above_level = (_e67 + rt::Scalar(1u32));
                    let over_3 = <rt::Vec2<i32>>::from_scalars((place_44.x() >> above_level), (place_44.y() >> above_level));
                    let _e76 = parent.x();
                    if rt::Scalar::into_branch_condition(_e76.elementwise_ge(rt::Scalar(0i32))) {
                        let _e82 = parent.x();
                        if rt::Scalar::into_branch_condition((!_e82.elementwise_ne(over_3.x()))) {
                            let _e89 = parent.y();
                            local_91 = _e89.elementwise_ne(over_3.y());
                        } else {
                            local_91 = rt::Scalar(true);
                        }
                        let _e93 = local_91;
                        local_90 = _e93;
                    } else {
                        local_90 = rt::Scalar(false);
                    }
                    let left_6 = local_90;
                    if rt::Scalar::into_branch_condition(left_6) {
                        let _e98 = level_52;
                        let _e99 = top;
                        local_92 = _e98.elementwise_lt(_e99);
                    } else {
                        local_92 = rt::Scalar(false);
                    }
                    let _e102 = local_92;
                    if rt::Scalar::into_branch_condition(_e102) {
                        level_52 = above_level;
                    }
                    let _e104 = cell_35.x();
                    let _e106 = level_52;
                    let _e107 = self.v_node_extent(_e104, _e59, _e4.x(), _e106);
                    let _e109 = cell_35.y();
                    let _e111 = level_52;
                    let _e112 = self.v_node_extent(_e109, _e63, _e4.y(), _e111);
                    let _e117 = self.v_leaves_extent(_e2.origin.x(), _e2.step.x(), _e107);
                    let _e122 = self.v_leaves_extent(_e2.origin.y(), _e2.step.y(), _e112);
                    let end_19 = _e117.min(_e122).min(rt::Scalar(path_79.exit));
                    let _e126 = t_38;
                    let span_13 = (end_19 - _e126).max(rt::Scalar(0f32));
                    let low_9 = <rt::Vec2<i32>>::from_scalars(_e107.x(), _e112.x());
                    let last_13 = <rt::Vec2<i32>>::from_scalars((_e107.y() - rt::Scalar(1i32)), (_e112.y() - rt::Scalar(1i32)));
                    let _e140 = level_52;
                    if rt::Scalar::into_branch_condition(_e140.elementwise_eq(rt::Scalar(0u32))) {
                        let _e143 = cost_15;
                        cost_15 = (_e143 + HEIGHTS_READ);
                        let _e146 = cell_35;
                        let _e148 = cell_35;
                        let _e150 = self.v_object_cell_stage(_e148, rt::Scalar(path_79.level));
                        let _e151 = t_38;
                        let _e152 = self.v_gap_to(path_79, _e2, _e146.to_f32(), _e150, _e151);
                        let _e153 = self.v_falls_in_cell(_e152, span_13);
                        if rt::Scalar::into_branch_condition(_e153) {
                            let _e154 = t_38;
                            let _e155 = t_38;
                            let _e158 = cost_15;
                            let _e159 = self.v_found_in_cell(_e152, _e154, span_13, _e155.elementwise_eq(rt::Scalar(0f32)), _e158);
                            return _e159;
                        }
                    } else {
                        let _e160 = cost_15;
                        let _e162 = self.v_map_read(path_79, rt::Scalar(1u32));
                        cost_15 = (_e160 + _e162);
                        let _e165 = level_52;
                        let _e168 = level_52;
                        let node_2 = <rt::Vec2<i32>>::from_scalars((place_44.x() >> _e165), (place_44.y() >> _e168));
                        let _e172 = level_52;
                        let _e178 = self.v_search_texel(path_79, node_2, rt::Scalar(0i32), ((_e172 + rt::Scalar(path_79.level)).to_i32() - rt::Scalar(1i32)));
                        let highest_1 = _e178.y();
                        let _e180 = t_38;
                        let furthest = (_e180 + span_13);
                        let rounded = (path_79.h.x().abs() + (furthest * (path_79.h.y().abs() + (furthest * path_79.h.z().abs()))));
                        let _e195 = t_38;
                        let _e196 = self.v_path_height(path_79, _e195);
                        let _e201 = t_38;
                        let _e202 = self.v_path_slope(path_79, _e201);
                        let gap_6 = <rt::Vec3<f32>>::from_scalars(((_e196 - highest_1) - (rt::Scalar(0.0000009536743f32) * rounded)), _e202, path_79.h.z());
                        let _e206 = self.v_falls_in_cell(gap_6, span_13);
                        if rt::Scalar::into_branch_condition(_e206) {
                            if rt::Scalar::into_branch_condition(gap_6.x().elementwise_gt(rt::Scalar(0f32))) {
                                let _e210 = t_38;
                                let _e211 = self.v_first_root(gap_6, span_13);
                                t_38 = (_e210 + _e211.min(span_13));
                            }
                            let _e216 = t_38;
                            let _e219 = self.v_cell_of((_e2.origin + (_e2.step * _e216)));
                            cell_35 = _e219.to_i32().clamp(low_9, last_13);
                            let _e222 = level_52;
                            level_52 = (_e222 - rt::Scalar(1u32));
                            parent = <rt::Vec2<i32>>::from_scalars(rt::Scalar(-1i32), rt::Scalar(-1i32));
                            break 'naga_continue;
                        }
                    }
                    if rt::Scalar::into_branch_condition(end_19.elementwise_ge(rt::Scalar(path_79.exit))) {
                        let _e231 = t_38;
                        let _e233 = cost_15;
                        return <SearchResult>::new(FOUND_MISS, _e231, rt::Scalar(path_79.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e233);
                    }
                    let _e241 = self.v_cell_of((_e2.origin + (_e2.step * end_19)));
                    cell_35 = _e241.to_i32().clamp(low_9, last_13);
                    if rt::Scalar::into_branch_condition(_e117.elementwise_le(end_19)) {
                        cell_35.set_x((low_9.x() - rt::Scalar(1i32)).select(_e107.y(), _e2.step.x().elementwise_gt(rt::Scalar(0f32))));
                    }
                    if rt::Scalar::into_branch_condition(_e122.elementwise_le(end_19)) {
                        cell_35.set_y((low_9.y() - rt::Scalar(1i32)).select(_e112.y(), _e2.step.y().elementwise_gt(rt::Scalar(0f32))));
                    }
                    let _e267 = level_52;
                    let _e272 = level_52;
                    parent = <rt::Vec2<i32>>::from_scalars((place_44.x() >> (_e267 + rt::Scalar(1u32))), (place_44.y() >> (_e272 + rt::Scalar(1u32))));
                    let _e277 = t_38;
                    t_38 = _e277.max(end_19);
                }
            }
        }
        let _e280 = t_38;
        let _e282 = cost_15;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e280, rt::Scalar(path_79.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e282);
    }
    pub(crate) fn texel_extent(
        &self,
        texel_4: impl rt::Into<rt::Scalar<i32>>,
        n_16: impl rt::Into<rt::Scalar<i32>>,
        level_53: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec2<i32> {
        rt::into(self.v_texel_extent(rt::into(texel_4), rt::into(n_16), rt::into(level_53)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_texel_extent(
        &self,
        texel_4: rt::Scalar<i32>,
        n_16: rt::Scalar<i32>,
        level_53: rt::Scalar<u32>,
    ) -> rt::Vec2<i32> {
        let mut local_93: rt::Scalar<bool>;

        let _e3 = self.v_wrap_index(texel_4, n_16);
        let first_28 = ((_e3 >> level_53) << level_53);
        let last_14 = (first_28 + (rt::Scalar(1i32) << level_53)).min(n_16);
        if rt::Scalar::into_branch_condition((!texel_4.elementwise_eq(_e3))) {
            let _e16 = rt::Scalar(self.surface_settings.wrap);
            local_93 = _e16.elementwise_eq(WRAP_REPEAT);
        } else {
            local_93 = rt::Scalar(true);
        }
        let _e20 = local_93;
        if rt::Scalar::into_branch_condition(_e20) {
            return <rt::Vec2<i32>>::from_scalars(((texel_4 - _e3) + first_28), ((texel_4 - _e3) + last_14));
        }
        let _e28 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e28.elementwise_eq(WRAP_MIRROR)) {
            let period_4 = (rt::Scalar(2i32) * n_16);
            let folded_1 = (((texel_4 % period_4) + period_4) % period_4);
            if rt::Scalar::into_branch_condition(folded_1.elementwise_lt(n_16)) {
                return <rt::Vec2<i32>>::from_scalars(((texel_4 - _e3) + first_28), ((texel_4 - _e3) + last_14));
            }
            return <rt::Vec2<i32>>::from_scalars((((texel_4 + _e3) - last_14) + rt::Scalar(1i32)), (((texel_4 + _e3) - first_28) + rt::Scalar(1i32)));
        }
        return <rt::Vec2<i32>>::from_scalars(texel_4, (texel_4 + rt::Scalar(1i32)));
    }
    pub(crate) fn search_pyramid_texels(
        &self,
        path_80: Path,
        params_100: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_pyramid_texels(path_80, rt::into(params_100)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_pyramid_texels(
        &self,
        path_80: Path,
        params_100: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut level_54: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut texel_5: rt::Vec2<i32>;
        let mut t_39: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_16: rt::Vec3<u32> = NO_COST;
        let mut finest_1: rt::Scalar<u32>;
        let mut highest: rt::Scalar<f32>;
        let mut sinks: rt::Scalar<f32>;

        let _e3 = self.v_height_texels(rt::Scalar(path_80.level));
        let _e6 = self.v_height_size(rt::Scalar(path_80.level));
        let origin_8 = (path_80.uv * _e6);
        let _e10 = self.v_height_size(rt::Scalar(path_80.level));
        let step_8 = (path_80.duv * _e10);
        'naga_break: loop {
            'naga_continue: {
                let _e14 = level_54;
                if rt::Scalar::into_branch_condition((rt::Scalar(1i32) << _e14).elementwise_lt(_e3.x().max(_e3.y()))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e21 = level_54;
                    level_54 = (_e21 + rt::Scalar(1u32));
                }
            }
        }
        let _e24 = self.v_cell_of(origin_8);
        texel_5 = _e24.to_i32();
        let limit_8 = params_100.x().to_u32();
        let _e35 = level_54;
        finest_1 = params_100.y().to_u32().min(_e35);
        if rt::Scalar::into_branch_condition(rt::Scalar(path_80.ray).elementwise_eq(RAY_SHADOW)) {
            finest_1 = rt::Scalar(0u32);
        }
        'naga_break: loop {
            'naga_continue: {
                let _e43 = cost_16.x();
                if rt::Scalar::into_branch_condition(_e43.elementwise_lt(limit_8)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e45 = cost_16;
                    cost_16 = (_e45 + STEP);
                    let _e49 = texel_5.x();
                    let _e51 = self.v_wrap_index(_e49, _e3.x());
                    let _e53 = texel_5.y();
                    let _e55 = self.v_wrap_index(_e53, _e3.y());
                    let place_45 = <rt::Vec2<i32>>::from_scalars(_e51, _e55);
                    highest = rt::Scalar(0f32);
                    let _e59 = level_54;
                    if rt::Scalar::into_branch_condition(_e59.elementwise_eq(rt::Scalar(0u32))) {
                        let _e62 = cost_16;
                        cost_16 = (_e62 + HEIGHT_READ);
                        let _e67 = rt::texture::Read::read_texel((&self.height_map), place_45, 0i32, 0i32, rt::Scalar::into_inner(rt::Scalar(0i32)));
                        highest = _e67.x();
                    } else {
                        let _e70 = level_54;
                        let _e73 = level_54;
                        let node_3 = <rt::Vec2<i32>>::from_scalars((place_45.x() >> _e70), (place_45.y() >> _e73));
                        let _e76 = cost_16;
                        let _e78 = self.v_map_read(path_80, rt::Scalar(1u32));
                        cost_16 = (_e76 + _e78);
                        let _e81 = level_54;
                        let _e85 = self.v_search_texel(path_80, node_3, rt::Scalar(0i32), (_e81.to_i32() - rt::Scalar(1i32)));
                        highest = _e85.y();
                    }
                    let _e88 = texel_5.x();
                    let _e90 = level_54;
                    let _e91 = self.v_texel_extent(_e88, _e3.x(), _e90);
                    let _e93 = texel_5.y();
                    let _e95 = level_54;
                    let _e96 = self.v_texel_extent(_e93, _e3.y(), _e95);
                    let _e99 = self.v_leaves_extent(origin_8.x(), step_8.x(), _e91);
                    let _e102 = self.v_leaves_extent(origin_8.y(), step_8.y(), _e96);
                    let leave_9 = <rt::Vec2<f32>>::from_scalars(_e99, _e102);
                    let _e109 = t_39;
                    let end_20 = leave_9.x().min(leave_9.y()).min(rt::Scalar(path_80.exit)).max(_e109);
                    let _e111 = t_39;
                    let _e112 = self.v_path_height(path_80, _e111);
                    let _e113 = highest;
                    let _e115 = t_39;
                    let _e116 = self.v_path_slope(path_80, _e115);
                    let gap_7 = <rt::Vec3<f32>>::from_scalars((_e112 - _e113), _e116, path_80.h.z());
                    sinks = rt::Scalar(0f32);
                    if rt::Scalar::into_branch_condition(gap_7.x().elementwise_gt(rt::Scalar(0f32))) {
                        let _e125 = t_39;
                        let _e127 = self.v_first_root(gap_7, (end_20 - _e125));
                        sinks = _e127;
                    }
                    let low_10 = <rt::Vec2<i32>>::from_scalars(_e91.x(), _e96.x());
                    let last_15 = <rt::Vec2<i32>>::from_scalars((_e91.y() - rt::Scalar(1i32)), (_e96.y() - rt::Scalar(1i32)));
                    let _e138 = sinks;
                    if rt::Scalar::into_branch_condition(_e138.elementwise_lt(rt::Scalar(300000000000000000000000000000000000000f32))) {
                        let _e141 = t_39;
                        let _e142 = sinks;
                        t_39 = (_e141 + _e142);
                        let _e144 = level_54;
                        let _e145 = finest_1;
                        if rt::Scalar::into_branch_condition(_e144.elementwise_eq(_e145)) {
                            let _e148 = t_39;
                            let _e149 = cost_16;
                            return <SearchResult>::new(FOUND_BELOW, rt::Scalar(0f32), _e148, rt::Scalar(0f32), rt::Scalar(0f32), _e149);
                        }
                        let _e154 = level_54;
                        level_54 = (_e154 - rt::Scalar(1u32));
                        let _e157 = t_39;
                        let _e160 = self.v_cell_of((origin_8 + (step_8 * _e157)));
                        texel_5 = _e160.to_i32().clamp(low_10, last_15);
                    } else {
                        if rt::Scalar::into_branch_condition(end_20.elementwise_ge(rt::Scalar(path_80.exit))) {
                            let _e166 = t_39;
                            let _e168 = cost_16;
                            return <SearchResult>::new(FOUND_MISS, _e166, rt::Scalar(path_80.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e168);
                        }
                        let _e174 = self.v_cell_of((origin_8 + (step_8 * end_20)));
                        texel_5 = _e174.to_i32().clamp(low_10, last_15);
                        if rt::Scalar::into_branch_condition(leave_9.x().elementwise_le(end_20)) {
                            texel_5.set_x((low_10.x() - rt::Scalar(1i32)).select(_e91.y(), step_8.x().elementwise_gt(rt::Scalar(0f32))));
                        }
                        if rt::Scalar::into_branch_condition(leave_9.y().elementwise_le(end_20)) {
                            texel_5.set_y((low_10.y() - rt::Scalar(1i32)).select(_e96.y(), step_8.y().elementwise_gt(rt::Scalar(0f32))));
                        }
                        t_39 = end_20;
                    }
                }
            }
        }
        let _e200 = t_39;
        let _e202 = cost_16;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e200, rt::Scalar(path_80.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e202);
    }
    pub(crate) fn leaves_window(
        &self,
        grid_9: Grid,
        cell_36: impl rt::Into<rt::Vec2<f32>>,
        radius: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_leaves_window(grid_9, rt::into(cell_36), rt::into(radius)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_leaves_window(
        &self,
        grid_9: Grid,
        cell_36: rt::Vec2<f32>,
        radius: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let wide_2 = <rt::Vec2<f32>>::from_scalars(radius, radius);
        let _e5 = self.v_cell_leave(grid_9, (cell_36 - wide_2));
        let _e7 = self.v_cell_leave(grid_9, (cell_36 + wide_2));
        let leave_10 = _e5.select(_e7, grid_9.step.elementwise_gt(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32))));
        return leave_10.x().min(leave_10.y());
    }
    pub(crate) fn search_dilation_erosion(
        &self,
        path_81: Path,
        params_101: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_dilation_erosion(path_81, rt::into(params_101)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_dilation_erosion(
        &self,
        path_81: Path,
        params_101: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut cell_37: rt::Vec2<f32>;
        let mut t_40: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut safe_: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_17: rt::Vec3<u32> = NO_COST;
        let mut next_5: rt::Scalar<f32>;
        let mut looks: rt::Scalar<bool>;
        let mut local_94: rt::Scalar<bool>;
        let mut local_95: rt::Scalar<bool>;
        let mut local_96: rt::Scalar<bool>;
        let mut local_97: rt::Scalar<bool>;

        let _e2 = self.v_grid_of(path_81);
        let _e4 = self.v_height_texels(rt::Scalar(path_81.level));
        let forward_5 = _e2.step.elementwise_ge(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)));
        let _e11 = self.v_cell_of(_e2.origin);
        cell_37 = _e11;
        let limit_9 = params_101.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e22 = cost_17.x();
                if rt::Scalar::into_branch_condition(_e22.elementwise_lt(limit_9)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e24 = cost_17;
                    cost_17 = (_e24 + STEP);
                    let _e27 = cell_37;
                    let _e28 = self.v_cell_leave(_e2, _e27);
                    let end_21 = _e28.x().min(_e28.y()).min(rt::Scalar(path_81.exit));
                    let _e34 = t_40;
                    let span_14 = (end_21 - _e34).max(rt::Scalar(0f32));
                    let _e38 = t_40;
                    next_5 = _e38;
                    looks = params_101.y().elementwise_gt(rt::Scalar(0.5f32));
                    let _e44 = cell_37;
                    let _e45 = self.v_whole_cell(_e44);
                    let _e48 = self.v_image_of(_e45.x(), _e4.x());
                    let _e51 = self.v_image_of(_e45.y(), _e4.y());
                    if rt::Scalar::into_branch_condition((!_e48.y().elementwise_eq(rt::Scalar(2i32)))) {
                        local_94 = _e51.y().elementwise_eq(rt::Scalar(2i32));
                    } else {
                        local_94 = rt::Scalar(true);
                    }
                    let _e62 = local_94;
                    if rt::Scalar::into_branch_condition(_e62) {
                        looks = rt::Scalar(true);
                    } else {
                        let _e70 = self.v_search_texel(path_81, <rt::Vec2<i32>>::from_scalars(_e48.x(), _e51.x()), rt::Scalar(0i32), rt::Scalar(path_81.level).to_i32());
                        let _e71 = cost_17;
                        let _e73 = self.v_map_read(path_81, rt::Scalar(1u32));
                        cost_17 = (_e71 + _e73);
                        let _e75 = cell_37;
                        let _e77 = self.v_leaves_window(_e2, _e75, params_101.z());
                        let _e80 = t_40;
                        let reach_6 = (_e77.min(rt::Scalar(path_81.exit)) - _e80).max(rt::Scalar(0f32));
                        let _e84 = t_40;
                        let furthest_1 = (_e84 + reach_6);
                        let rounded_1 = (path_81.h.x().abs() + (furthest_1 * (path_81.h.y().abs() + (furthest_1 * path_81.h.z().abs()))));
                        let _e99 = t_40;
                        let _e100 = self.v_path_height(path_81, _e99);
                        let _e106 = t_40;
                        let _e107 = self.v_path_slope(path_81, _e106);
                        let gap_8 = <rt::Vec3<f32>>::from_scalars(((_e100 - _e70.y()) - (rt::Scalar(0.0000009536743f32) * rounded_1)), _e107, path_81.h.z());
                        if rt::Scalar::into_branch_condition(gap_8.x().elementwise_gt(rt::Scalar(0f32))) {
                            let _e114 = t_40;
                            safe_ = _e114;
                            let _e115 = t_40;
                            next_5 = (_e115 + reach_6);
                            let _e117 = self.v_least_at(gap_8, reach_6);
                            let _e118 = self.v_quadratic(gap_8, _e117);
                            if rt::Scalar::into_branch_condition(_e118.elementwise_le(rt::Scalar(0f32))) {
                                let _e121 = t_40;
                                let _e122 = self.v_first_root(gap_8, reach_6);
                                next_5 = (_e121 + _e122.min(reach_6));
                            }
                        }
                        let _e125 = looks;
                        if rt::Scalar::into_branch_condition((!_e125)) {
                            let _e129 = next_5;
                            local_95 = _e129.elementwise_lt(end_21);
                        } else {
                            local_95 = rt::Scalar(false);
                        }
                        let _e132 = local_95;
                        if rt::Scalar::into_branch_condition(_e132) {
                            let _e135 = self.v_path_height(path_81, end_21);
                            local_96 = _e135.elementwise_lt(_e70.x());
                        } else {
                            local_96 = rt::Scalar(false);
                        }
                        let _e139 = local_96;
                        if rt::Scalar::into_branch_condition(_e139) {
                            let _e140 = safe_;
                            let _e141 = cost_17;
                            let _e142 = self.v_bracket_between(path_81, _e140, end_21, _e141);
                            return _e142;
                        }
                    }
                    let _e143 = next_5;
                    if rt::Scalar::into_branch_condition((!_e143.elementwise_lt(end_21))) {
                        let _e148 = t_40;
                        local_97 = (!end_21.elementwise_gt(_e148));
                    } else {
                        local_97 = rt::Scalar(true);
                    }
                    let _e152 = local_97;
                    if rt::Scalar::into_branch_condition(_e152) {
                        let _e153 = looks;
                        if rt::Scalar::into_branch_condition(_e153) {
                            let _e154 = cost_17;
                            cost_17 = (_e154 + HEIGHTS_READ);
                            let _e158 = self.v_height_cell(_e45, rt::Scalar(path_81.level));
                            let _e159 = cell_37;
                            let _e160 = t_40;
                            let _e161 = self.v_gap_to(path_81, _e2, _e159, _e158, _e160);
                            let _e162 = self.v_falls_in_cell(_e161, span_14);
                            if rt::Scalar::into_branch_condition(_e162) {
                                let _e163 = t_40;
                                let _e164 = t_40;
                                let _e167 = cost_17;
                                let _e168 = self.v_found_in_cell(_e161, _e163, span_14, _e164.elementwise_eq(rt::Scalar(0f32)), _e167);
                                return _e168;
                            }
                        }
                        let _e169 = t_40;
                        next_5 = _e169.max(end_21);
                    }
                    let _e171 = next_5;
                    if rt::Scalar::into_branch_condition(_e171.elementwise_ge(rt::Scalar(path_81.exit))) {
                        let _e175 = t_40;
                        let _e177 = cost_17;
                        return <SearchResult>::new(FOUND_MISS, _e175, rt::Scalar(path_81.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e177);
                    }
                    let _e181 = cell_37;
                    let _e182 = next_5;
                    let _e183 = self.v_cell_after(_e2, _e181, _e28, forward_5, _e182);
                    cell_37 = _e183;
                    let _e184 = next_5;
                    t_40 = _e184;
                }
            }
        }
        let _e186 = t_40;
        let _e188 = cost_17;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e186, rt::Scalar(path_81.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e188);
    }
    pub(crate) fn search_sphere(
        &self,
        path_82: Path,
        params_102: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_sphere(path_82, rt::into(params_102)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_sphere(
        &self,
        path_82: Path,
        params_102: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut cell_38: rt::Vec2<f32>;
        let mut t_41: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_18: rt::Vec3<u32> = NO_COST;
        let mut next_6: rt::Scalar<f32>;
        let mut local_98: rt::Scalar<bool>;

        let _e2 = self.v_grid_of(path_82);
        let forward_6 = _e2.step.elementwise_ge(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)));
        let _e9 = self.v_path_slope(path_82, rt::Scalar(0f32));
        let _e12 = self.v_path_slope(path_82, rt::Scalar(path_82.exit));
        let climb_1 = _e9.abs().max(_e12.abs());
        let fastest = <rt::Vec3<f32>>::new_21(path_82.duv, climb_1).length();
        let speed_2 = (fastest + (rt::Scalar(0.0000009536743f32) * fastest));
        let far_17 = (path_82.uv.abs() + (path_82.duv.abs() * rt::Scalar(path_82.exit)));
        let height_terms = (path_82.h.x().abs() + (rt::Scalar(path_82.exit) * (path_82.h.y().abs() + (rt::Scalar(path_82.exit) * path_82.h.z().abs()))));
        let lost_3 = (rt::Scalar(0.0000009536743f32) * (((far_17.x() + far_17.y()) + height_terms) + rt::Scalar(1f32)));
        let _e52 = self.v_cell_of(_e2.origin);
        cell_38 = _e52;
        let limit_10 = params_102.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e61 = cost_18.x();
                if rt::Scalar::into_branch_condition(_e61.elementwise_lt(limit_10)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e63 = cost_18;
                    cost_18 = (_e63 + STEP);
                    let _e66 = cell_38;
                    let _e67 = self.v_cell_leave(_e2, _e66);
                    let end_22 = _e67.x().min(_e67.y()).min(rt::Scalar(path_82.exit));
                    let _e73 = t_41;
                    let span_15 = (end_22 - _e73).max(rt::Scalar(0f32));
                    let _e77 = t_41;
                    let _e78 = self.v_path_uv(path_82, _e77);
                    let _e79 = t_41;
                    let _e80 = self.v_path_height(path_82, _e79);
                    let _e82 = self.v_distance_at(path_82, _e78, _e80, params_102.z());
                    let free_1 = (_e82 - lost_3);
                    let _e84 = cost_18;
                    let _e86 = self.v_map_read(path_82, rt::Scalar(4u32));
                    let _e89 = self.v_map_read(path_82, rt::Scalar(4u32));
                    cost_18 = ((_e84 + _e86) + _e89);
                    let _e91 = t_41;
                    next_6 = _e91;
                    if rt::Scalar::into_branch_condition(free_1.elementwise_gt(rt::Scalar(0f32))) {
                        let _e95 = t_41;
                        next_6 = (_e95 + (free_1 / speed_2));
                    }
                    if rt::Scalar::into_branch_condition(params_102.y().elementwise_lt(rt::Scalar(0.5f32))) {
                        let _e101 = next_6;
                        let _e102 = t_41;
                        if rt::Scalar::into_branch_condition((!(_e101 - _e102).elementwise_gt((rt::Scalar(0.0000009536743f32) * rt::Scalar(path_82.exit))))) {
                            let _e110 = t_41;
                            let _e112 = cost_18;
                            return <SearchResult>::new(FOUND_ABOVE, _e110, rt::Scalar(path_82.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e112);
                        }
                    } else {
                        let _e116 = next_6;
                        if rt::Scalar::into_branch_condition((!_e116.elementwise_lt(end_22))) {
                            let _e121 = t_41;
                            local_98 = (!end_22.elementwise_gt(_e121));
                        } else {
                            local_98 = rt::Scalar(true);
                        }
                        let _e125 = local_98;
                        if rt::Scalar::into_branch_condition(_e125) {
                            let _e126 = cost_18;
                            cost_18 = (_e126 + HEIGHTS_READ);
                            let _e129 = cell_38;
                            let _e130 = cell_38;
                            let _e131 = self.v_whole_cell(_e130);
                            let _e133 = self.v_height_cell(_e131, rt::Scalar(path_82.level));
                            let _e134 = t_41;
                            let _e135 = self.v_gap_to(path_82, _e2, _e129, _e133, _e134);
                            let _e136 = self.v_falls_in_cell(_e135, span_15);
                            if rt::Scalar::into_branch_condition(_e136) {
                                let _e137 = t_41;
                                let _e138 = t_41;
                                let _e141 = cost_18;
                                let _e142 = self.v_found_in_cell(_e135, _e137, span_15, _e138.elementwise_eq(rt::Scalar(0f32)), _e141);
                                return _e142;
                            }
                            let _e143 = t_41;
                            next_6 = _e143.max(end_22);
                        }
                    }
                    let _e145 = next_6;
                    if rt::Scalar::into_branch_condition(_e145.elementwise_ge(rt::Scalar(path_82.exit))) {
                        let _e149 = t_41;
                        let _e151 = cost_18;
                        return <SearchResult>::new(FOUND_MISS, _e149, rt::Scalar(path_82.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e151);
                    }
                    let _e155 = cell_38;
                    let _e156 = next_6;
                    let _e157 = self.v_cell_after(_e2, _e155, _e67, forward_6, _e156);
                    cell_38 = _e157;
                    let _e158 = next_6;
                    t_41 = _e158;
                }
            }
        }
        let _e160 = t_41;
        let _e162 = cost_18;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e160, rt::Scalar(path_82.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e162);
    }
    pub(crate) fn search_cone_moved(
        &self,
        path_83: Path,
        params_103: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_cone_moved(path_83, rt::into(params_103)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_cone_moved(
        &self,
        path_83: Path,
        params_103: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut t_42: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut near_6: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut near_gap_3: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_19: rt::Vec3<u32> = NO_COST;
        let mut k_30: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut local_99: rt::Scalar<bool>;

        let aside_8 = path_83.duv.length();
        'naga_break: loop {
            'naga_continue: {
                let _e14 = k_30;
                if rt::Scalar::into_branch_condition(_e14.elementwise_lt(params_103.x())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e17 = cost_19;
                    cost_19 = (_e17 + STEP);
                    let _e20 = t_42;
                    let _e21 = self.v_path_gap(path_83, _e20);
                    let _e22 = cost_19;
                    cost_19 = (_e22 + HEIGHTS_READ);
                    if rt::Scalar::into_branch_condition(_e21.elementwise_le(rt::Scalar(0f32))) {
                        let _e27 = t_42;
                        if rt::Scalar::into_branch_condition(_e27.elementwise_eq(rt::Scalar(0f32))) {
                            local_99 = _e21.elementwise_lt(rt::Scalar(0f32));
                        } else {
                            local_99 = rt::Scalar(false);
                        }
                        let _e35 = local_99;
                        if rt::Scalar::into_branch_condition(_e35) {
                            let _e37 = cost_19;
                            return <SearchResult>::new(FOUND_STARTED_BELOW, rt::Scalar(0f32), rt::Scalar(0f32), _e21, _e21, _e37);
                        }
                        let _e42 = near_6;
                        let _e43 = t_42;
                        let _e44 = near_gap_3;
                        let _e45 = cost_19;
                        return <SearchResult>::new(FOUND_BRACKET, _e42, _e43, _e44, _e21, _e45);
                    }
                    let _e47 = t_42;
                    near_6 = _e47;
                    near_gap_3 = _e21;
                    let _e48 = t_42;
                    let _e49 = self.v_path_uv(path_83, _e48);
                    let _e51 = self.v_search_texel_between(path_83, _e49, rt::Scalar(0i32));
                    let _e53 = self.v_slope_of(_e51.x());
                    let _e54 = cost_19;
                    let _e56 = self.v_map_read(path_83, rt::Scalar(4u32));
                    cost_19 = (_e54 + _e56);
                    if rt::Scalar::into_branch_condition(_e53.elementwise_lt(rt::Scalar(0f32))) {
                        break 'naga_break;
                    }
                    let _e61 = t_42;
                    let rest_13 = (rt::Scalar(path_83.exit) - _e61);
                    let _e63 = t_42;
                    let _e64 = self.v_path_slope(path_83, _e63);
                    let rise_7 = (_e64 + (path_83.h.z().min(rt::Scalar(0f32)) * rest_13));
                    let terms_1 = (path_83.h.x().abs() + (rt::Scalar(path_83.exit) * (path_83.h.y().abs() + (rt::Scalar(path_83.exit) * path_83.h.z().abs()))));
                    let far_18 = (((path_83.uv.abs() + (path_83.duv.abs() * rt::Scalar(path_83.exit))) + <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32))) * _e53);
                    let lost_4 = (rt::Scalar(0.0000009536743f32) * ((terms_1 + far_18.x()) + far_18.y()));
                    let nearing = ((_e53 * aside_8) - rise_7);
                    let closing_3 = (nearing + (rt::Scalar(0.0000009536743f32) * nearing));
                    if rt::Scalar::into_branch_condition(closing_3.elementwise_le(rt::Scalar(0f32))) {
                        let _e112 = t_42;
                        let _e114 = cost_19;
                        return <SearchResult>::new(FOUND_MISS, _e112, rt::Scalar(path_83.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e114);
                    }
                    let _e118 = t_42;
                    t_42 = (_e118 + ((_e21 - lost_4).max(rt::Scalar(0f32)) / closing_3));
                    let _e124 = t_42;
                    if rt::Scalar::into_branch_condition(_e124.elementwise_ge(rt::Scalar(path_83.exit))) {
                        let _e128 = near_6;
                        let _e130 = cost_19;
                        return <SearchResult>::new(FOUND_MISS, _e128, rt::Scalar(path_83.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e130);
                    }
                    let _e134 = k_30;
                    k_30 = (_e134 + rt::Scalar(1f32));
                }
            }
        }
        let _e138 = t_42;
        let _e140 = t_42;
        let _e141 = self.v_path_height(path_83, _e140);
        let _e142 = cost_19;
        return <SearchResult>::new(FOUND_ABOVE, _e138, rt::Scalar(path_83.exit), _e141, rt::Scalar(0f32), _e142);
    }
    pub(crate) fn search_relaxed_cone(
        &self,
        path_84: Path,
        params_104: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_relaxed_cone(path_84, rt::into(params_104)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_relaxed_cone(
        &self,
        path_84: Path,
        params_104: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut cell_39: rt::Vec2<f32>;
        let mut t_43: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut near_7: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut near_gap_4: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_20: rt::Vec3<u32> = NO_COST;
        let mut local_100: rt::Scalar<bool>;
        let mut start_2: rt::Scalar<f32>;
        let mut gap: rt::Scalar<f32>;
        let mut next_7: rt::Scalar<f32>;
        let mut local_101: rt::Scalar<bool>;

        let _e2 = self.v_grid_of(path_84);
        let forward_7 = _e2.step.elementwise_ge(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)));
        let aside_9 = path_84.duv.length();
        let _e11 = self.v_path_slope(path_84, rt::Scalar(0f32));
        let terms_2 = (path_84.h.x().abs() + (rt::Scalar(path_84.exit) * path_84.h.y().abs()));
        let _e33 = self.v_height_size(rt::Scalar(path_84.level));
        let far_19 = (((_e2.origin.abs() + (_e2.step.abs() * rt::Scalar(path_84.exit))) + <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32))) / _e33);
        let _e36 = self.v_cell_of(_e2.origin);
        cell_39 = _e36;
        let limit_11 = params_104.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e49 = cost_20.x();
                if rt::Scalar::into_branch_condition(_e49.elementwise_lt(limit_11)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e51 = cost_20;
                    cost_20 = (_e51 + STEP);
                    let _e54 = cell_39;
                    let _e55 = self.v_cell_leave(_e2, _e54);
                    let end_23 = _e55.x().min(_e55.y()).min(rt::Scalar(path_84.exit));
                    let _e61 = t_43;
                    let span_16 = (end_23 - _e61).max(rt::Scalar(0f32));
                    let _e65 = cell_39;
                    let _e66 = cell_39;
                    let _e67 = self.v_whole_cell(_e66);
                    let _e69 = self.v_height_cell(_e67, rt::Scalar(path_84.level));
                    let _e70 = t_43;
                    let _e71 = self.v_gap_to(path_84, _e2, _e65, _e69, _e70);
                    let _e72 = cost_20;
                    cost_20 = (_e72 + HEIGHTS_READ);
                    if rt::Scalar::into_branch_condition(_e71.x().elementwise_le(rt::Scalar(0f32))) {
                        let _e78 = near_7;
                        let _e79 = t_43;
                        if rt::Scalar::into_branch_condition(_e78.elementwise_lt(_e79)) {
                            let _e83 = near_gap_4;
                            local_100 = _e83.elementwise_gt(rt::Scalar(0f32));
                        } else {
                            local_100 = rt::Scalar(false);
                        }
                        let _e87 = local_100;
                        if rt::Scalar::into_branch_condition(_e87) {
                            let _e88 = near_7;
                            let _e89 = t_43;
                            let _e90 = near_gap_4;
                            let _e92 = cost_20;
                            let _e93 = self.v_entered_once(path_84, _e2, _e88, _e89, _e90, _e71.x(), _e92);
                            return _e93;
                        }
                        let _e94 = t_43;
                        let _e95 = t_43;
                        let _e98 = cost_20;
                        let _e99 = self.v_found_in_cell(_e71, _e94, span_16, _e95.elementwise_eq(rt::Scalar(0f32)), _e98);
                        return _e99;
                    }
                    let _e100 = t_43;
                    start_2 = _e100;
                    gap = _e71.x();
                    if rt::Scalar::into_branch_condition(params_104.y().elementwise_gt(rt::Scalar(0.5f32))) {
                        let _e107 = self.v_falls_in_cell(_e71, span_16);
                        if rt::Scalar::into_branch_condition(_e107) {
                            let _e108 = t_43;
                            let _e109 = t_43;
                            let _e112 = cost_20;
                            let _e113 = self.v_found_in_cell(_e71, _e108, span_16, _e109.elementwise_eq(rt::Scalar(0f32)), _e112);
                            return _e113;
                        }
                        let _e114 = t_43;
                        start_2 = _e114.max(end_23);
                        let _e116 = self.v_quadratic(_e71, span_16);
                        gap = _e116;
                    }
                    let _e117 = start_2;
                    if rt::Scalar::into_branch_condition(_e117.elementwise_ge(rt::Scalar(path_84.exit))) {
                        let _e121 = t_43;
                        let _e123 = cost_20;
                        return <SearchResult>::new(FOUND_MISS, _e121, rt::Scalar(path_84.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e123);
                    }
                    let _e127 = start_2;
                    near_7 = _e127;
                    let _e128 = gap;
                    near_gap_4 = _e128;
                    let _e129 = cell_39;
                    let _e131 = cell_39;
                    let _e134 = start_2;
                    let _e137 = self.v_nearest_corner(((_e2.origin - _e131) + (_e2.step * _e134)));
                    let _e139 = self.v_cone_slope(path_84, (_e129 + _e137));
                    let _e140 = cost_20;
                    let _e142 = self.v_map_read(path_84, rt::Scalar(1u32));
                    cost_20 = (_e140 + _e142);
                    let _e144 = start_2;
                    next_7 = _e144;
                    if rt::Scalar::into_branch_condition(_e139.elementwise_ge(rt::Scalar(0f32))) {
                        let nearing_1 = ((_e139 * aside_9) - _e11);
                        let closing_4 = (nearing_1 + (rt::Scalar(0.0000009536743f32) * nearing_1));
                        let _e153 = gap;
                        let room_1 = (_e153 - (rt::Scalar(0.0000009536743f32) * (terms_2 + (_e139 * (far_19.x() + far_19.y())))));
                        next_7 = rt::Scalar(300000000000000000000000000000000000000f32);
                        if rt::Scalar::into_branch_condition(closing_4.elementwise_gt(rt::Scalar(0f32))) {
                            let _e165 = start_2;
                            next_7 = (_e165 + (room_1.max(rt::Scalar(0f32)) / closing_4));
                        }
                    }
                    if rt::Scalar::into_branch_condition(params_104.y().elementwise_lt(rt::Scalar(0.5f32))) {
                        let _e175 = next_7;
                        let _e176 = t_43;
                        local_101 = (!(_e175 - _e176).elementwise_gt((rt::Scalar(0.0000009536743f32) * rt::Scalar(path_84.exit))));
                    } else {
                        local_101 = rt::Scalar(false);
                    }
                    let _e184 = local_101;
                    if rt::Scalar::into_branch_condition(_e184) {
                        let _e186 = t_43;
                        let _e188 = gap;
                        let _e189 = cost_20;
                        return <SearchResult>::new(FOUND_ABOVE, _e186, rt::Scalar(path_84.exit), _e188, rt::Scalar(0f32), _e189);
                    }
                    let _e192 = next_7;
                    if rt::Scalar::into_branch_condition(_e192.elementwise_ge(rt::Scalar(path_84.exit))) {
                        let _e196 = self.v_path_gap(path_84, rt::Scalar(path_84.exit));
                        let _e197 = cost_20;
                        cost_20 = (_e197 + HEIGHTS_READ);
                        if rt::Scalar::into_branch_condition(_e196.elementwise_le(rt::Scalar(0f32))) {
                            let _e202 = start_2;
                            let _e204 = gap;
                            let _e205 = cost_20;
                            let _e206 = self.v_entered_once(path_84, _e2, _e202, rt::Scalar(path_84.exit), _e204, _e196, _e205);
                            return _e206;
                        }
                        let _e208 = start_2;
                        let _e210 = cost_20;
                        return <SearchResult>::new(FOUND_MISS, _e208, rt::Scalar(path_84.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e210);
                    }
                    let _e214 = cell_39;
                    let _e215 = next_7;
                    let _e216 = self.v_cell_after(_e2, _e214, _e55, forward_7, _e215);
                    cell_39 = _e216;
                    let _e217 = next_7;
                    t_43 = _e217;
                }
            }
        }
        let _e219 = t_43;
        let _e221 = cost_20;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e219, rt::Scalar(path_84.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e221);
    }
    pub(crate) fn search_relaxed_cone_resting(
        &self,
        path_85: Path,
        params_105: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_relaxed_cone_resting(path_85, rt::into(params_105)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_relaxed_cone_resting(
        &self,
        path_85: Path,
        params_105: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut cell_40: rt::Vec2<f32>;
        let mut t_44: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut near_8: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut near_gap_5: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_21: rt::Vec3<u32> = NO_COST;
        let mut local_102: rt::Scalar<bool>;
        let mut next_8: rt::Scalar<f32>;

        let _e2 = self.v_grid_of(path_85);
        let forward_8 = _e2.step.elementwise_ge(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)));
        let _e9 = self.v_cell_of(_e2.origin);
        cell_40 = _e9;
        let limit_12 = params_105.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e22 = cost_21.x();
                if rt::Scalar::into_branch_condition(_e22.elementwise_lt(limit_12)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e24 = cost_21;
                    cost_21 = (_e24 + STEP);
                    let _e27 = cell_40;
                    let _e28 = self.v_whole_cell(_e27);
                    let _e30 = self.v_height_cell(_e28, rt::Scalar(path_85.level));
                    let _e31 = cost_21;
                    cost_21 = (_e31 + HEIGHTS_READ);
                    let _e34 = cell_40;
                    let _e35 = self.v_cell_leave(_e2, _e34);
                    let end_24 = _e35.x().min(_e35.y()).min(rt::Scalar(path_85.exit));
                    let _e41 = t_44;
                    let span_17 = (end_24 - _e41).max(rt::Scalar(0f32));
                    let _e45 = cell_40;
                    let _e46 = t_44;
                    let _e47 = self.v_gap_to(path_85, _e2, _e45, _e30, _e46);
                    if rt::Scalar::into_branch_condition(_e47.x().elementwise_le(rt::Scalar(0f32))) {
                        let _e51 = near_8;
                        let _e52 = t_44;
                        if rt::Scalar::into_branch_condition(_e51.elementwise_lt(_e52)) {
                            let _e56 = near_gap_5;
                            local_102 = _e56.elementwise_gt(rt::Scalar(0f32));
                        } else {
                            local_102 = rt::Scalar(false);
                        }
                        let _e60 = local_102;
                        if rt::Scalar::into_branch_condition(_e60) {
                            let _e61 = near_8;
                            let _e62 = t_44;
                            let _e63 = near_gap_5;
                            let _e65 = cost_21;
                            let _e66 = self.v_entered_once(path_85, _e2, _e61, _e62, _e63, _e47.x(), _e65);
                            return _e66;
                        }
                        let _e67 = t_44;
                        let _e68 = t_44;
                        let _e71 = cost_21;
                        let _e72 = self.v_found_in_cell(_e47, _e67, span_17, _e68.elementwise_eq(rt::Scalar(0f32)), _e71);
                        return _e72;
                    }
                    let _e73 = self.v_falls_in_cell(_e47, span_17);
                    if rt::Scalar::into_branch_condition(_e73) {
                        let _e74 = t_44;
                        let _e75 = t_44;
                        let _e78 = cost_21;
                        let _e79 = self.v_found_in_cell(_e47, _e74, span_17, _e75.elementwise_eq(rt::Scalar(0f32)), _e78);
                        return _e79;
                    }
                    let _e80 = t_44;
                    let start_8 = _e80.max(end_24);
                    if rt::Scalar::into_branch_condition(start_8.elementwise_ge(rt::Scalar(path_85.exit))) {
                        let _e85 = t_44;
                        let _e87 = cost_21;
                        return <SearchResult>::new(FOUND_MISS, _e85, rt::Scalar(path_85.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e87);
                    }
                    near_8 = start_8;
                    let _e91 = self.v_quadratic(_e47, span_17);
                    near_gap_5 = _e91;
                    let _e93 = cell_40;
                    let _e98 = self.v_nearest_corner(((_e2.origin - _e93) + (_e2.step * start_8)));
                    let _e99 = self.v_corner_height(_e30, _e98);
                    next_8 = start_8;
                    let _e101 = self.v_path_height(path_85, start_8);
                    if rt::Scalar::into_branch_condition(_e101.elementwise_gt(_e99)) {
                        let _e103 = cell_40;
                        let texel_12 = (_e103 + _e98);
                        let _e105 = self.v_cone_slope(path_85, texel_12);
                        let _e106 = cost_21;
                        let _e108 = self.v_map_read(path_85, rt::Scalar(1u32));
                        cost_21 = (_e106 + _e108);
                        if rt::Scalar::into_branch_condition(_e105.elementwise_ge(rt::Scalar(0f32))) {
                            let _e112 = self.v_stays_inside(path_85, _e2, texel_12, _e99, _e105, start_8);
                            next_8 = (start_8 + _e112);
                        }
                    }
                    let _e114 = next_8;
                    if rt::Scalar::into_branch_condition(_e114.elementwise_ge(rt::Scalar(path_85.exit))) {
                        let _e118 = self.v_path_gap(path_85, rt::Scalar(path_85.exit));
                        let _e119 = cost_21;
                        cost_21 = (_e119 + HEIGHTS_READ);
                        if rt::Scalar::into_branch_condition(_e118.elementwise_le(rt::Scalar(0f32))) {
                            let _e125 = near_gap_5;
                            let _e126 = cost_21;
                            let _e127 = self.v_entered_once(path_85, _e2, start_8, rt::Scalar(path_85.exit), _e125, _e118, _e126);
                            return _e127;
                        }
                        let _e130 = cost_21;
                        return <SearchResult>::new(FOUND_MISS, start_8, rt::Scalar(path_85.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e130);
                    }
                    let _e134 = cell_40;
                    let _e135 = next_8;
                    let _e136 = self.v_cell_after(_e2, _e134, _e35, forward_8, _e135);
                    cell_40 = _e136;
                    let _e137 = next_8;
                    t_44 = _e137;
                }
            }
        }
        let _e139 = t_44;
        let _e141 = cost_21;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e139, rt::Scalar(path_85.exit), rt::Scalar(0f32), rt::Scalar(0f32), _e141);
    }
    pub(crate) fn search_voxels(
        &self,
        path_86: Path,
        params_106: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_voxels(path_86, rt::into(params_106)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_voxels(
        &self,
        path_86: Path,
        params_106: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut has_turned_4: rt::Scalar<bool> = rt::Scalar(false);
        let mut t_45: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cell_41: rt::Vec3<f32>;
        let mut cost_22: rt::Vec3<u32> = NO_COST;
        let mut local_103: rt::Scalar<bool>;

        let _e2 = self.v_voxel_path(path_86);
        let _e3 = self.v_turning_point(_e2);
        let _e8 = t_45;
        let _e9 = self.v_voxel_place_on(_e2, _e8);
        cell_41 = _e9.floor();
        let limit_13 = params_106.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e17 = cost_22.y();
                if rt::Scalar::into_branch_condition(_e17.elementwise_lt(limit_13)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e19 = cell_41;
                    let _e21 = self.v_voxel_texel(_e19.to_i32());
                    let _e24 = self.v_search_texel(path_86, _e21, rt::Scalar(0i32), rt::Scalar(0i32));
                    let empty_1 = _e24.x();
                    let _e26 = cost_22;
                    let _e30 = self.v_map_read(path_86, rt::Scalar(1u32));
                    cost_22 = ((_e26 + STEP) + _e30);
                    let reach_7 = (empty_1 - rt::Scalar(1f32)).max(rt::Scalar(0f32));
                    let _e39 = has_turned_4;
                    let end_of_part_1 = _e3.min(rt::Scalar(path_86.exit)).select(rt::Scalar(path_86.exit), _e39);
                    let _e41 = cell_41;
                    let _e42 = has_turned_4;
                    let _e43 = self.v_voxel_leave(_e2, _e41, reach_7, _e42);
                    let side_12 = _e43.x().min(_e43.y()).min(_e43.z());
                    let _e50 = t_45;
                    let end_25 = side_12.min(end_of_part_1).max(_e50);
                    if rt::Scalar::into_branch_condition(empty_1.elementwise_lt(rt::Scalar(0.5f32))) {
                        let _e54 = cost_22;
                        cost_22 = (_e54 + VOXELS_READ);
                        let _e57 = cell_41;
                        let _e58 = t_45;
                        let _e59 = t_45;
                        let _e61 = self.v_root_in_voxel_cell(_e2, _e57, _e58, (end_25 - _e59));
                        if rt::Scalar::into_branch_condition(rt::Scalar(_e61.root).elementwise_lt(rt::Scalar(300000000000000000000000000000000000000f32))) {
                            if rt::Scalar::into_branch_condition(rt::Scalar(_e61.gap).elementwise_lt(rt::Scalar(0f32))) {
                                let _e70 = t_45;
                                local_103 = _e70.elementwise_eq(rt::Scalar(0f32));
                            } else {
                                local_103 = rt::Scalar(false);
                            }
                            let begins_inside = local_103;
                            let status = FOUND_BRACKET.select(FOUND_STARTED_BELOW, begins_inside);
                            let _e78 = t_45;
                            let _e80 = t_45;
                            let far_20 = (_e78 + (rt::Scalar(_e61.root) * (end_25 - _e80)));
                            let _e84 = t_45;
                            let _e89 = cost_22;
                            return <SearchResult>::new(status, _e84, far_20, rt::Scalar(_e61.gap), rt::Scalar(_e61.gap).min(rt::Scalar(0f32)), _e89);
                        }
                    }
                    if rt::Scalar::into_branch_condition(end_25.elementwise_ge(rt::Scalar(path_86.exit))) {
                        let _e94 = cost_22;
                        return <SearchResult>::new(FOUND_MISS, end_25, end_25, rt::Scalar(1f32), rt::Scalar(1f32), _e94);
                    }
                    if rt::Scalar::into_branch_condition(side_12.elementwise_gt(end_of_part_1)) {
                        has_turned_4 = rt::Scalar(true);
                        let _e100 = cell_41;
                        let _e101 = self.v_voxel_cell_at(_e2, _e100, reach_7, end_25);
                        cell_41 = _e101;
                    } else {
                        let _e102 = cell_41;
                        let _e103 = has_turned_4;
                        let _e104 = self.v_rises_on(_e2, _e103);
                        let _e105 = self.v_next_voxel_cell(_e2, _e102, reach_7, _e43, _e104, end_25);
                        cell_41 = _e105;
                    }
                    t_45 = end_25;
                }
            }
        }
        let _e107 = t_45;
        let _e108 = t_45;
        let _e109 = cost_22;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e107, _e108, rt::Scalar(1f32), rt::Scalar(1f32), _e109);
    }
    pub(crate) fn way_to_solid(
        &self,
        path_87: Path,
        place_31: impl rt::Into<rt::Vec3<f32>>,
        direction_5: impl rt::Into<rt::Vec3<f32>>,
        params_107: impl rt::Into<rt::Vec4<f32>>,
    ) -> WayToSolid {
        rt::into(self.v_way_to_solid(path_87, rt::into(place_31), rt::into(direction_5), rt::into(params_107)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_way_to_solid(
        &self,
        path_87: Path,
        place_31: rt::Vec3<f32>,
        direction_5: rt::Vec3<f32>,
        params_107: rt::Vec4<f32>,
    ) -> WayToSolid {
        let mut sum_4: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut weights_4: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut k_31: rt::Scalar<u32> = rt::Scalar(0u32);

        let _e4 = self.v_volume_size();
        let last_16 = (_e4.z() - rt::Scalar(1f32));
        let inside_7 = <rt::Vec3<f32>>::new_21(place_31.xy(), place_31.z().clamp(rt::Scalar(0f32), last_16));
        let first_29 = inside_7.floor();
        let part_31 = (inside_7 - first_29);
        let _e15 = self.v_volume_size();
        let size_6 = _e15.xy().to_i32();
        let cell_45 = first_29.to_i32();
        let _e21 = self.v_wrap_pair(cell_45.x(), size_6.x());
        let _e24 = self.v_wrap_pair(cell_45.y(), size_6.y());
        let elevation_4 = ((rt::Scalar(0.5f32) + (rt::Scalar(0.5f32) * direction_5.z())) * (params_107.z() - rt::Scalar(1f32))).clamp(rt::Scalar(0f32), (params_107.z() - rt::Scalar(1f32)));
        let below_8 = elevation_4.floor().min((params_107.z() - rt::Scalar(2f32)));
        let _e45 = self.v_turn_of(direction_5.xy());
        let turn_8 = (_e45 * params_107.y());
        let before_14 = turn_8.floor();
        let most_18 = (params_107.w() * rt::Scalar(0.998f32));
        'naga_break: loop {
            'naga_continue: {
                let _e58 = k_31;
                if rt::Scalar::into_branch_condition(_e58.elementwise_lt(rt::Scalar(8u32))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e61 = k_31;
                    let is_next = (_e61 & rt::Scalar(1u32)).elementwise_eq(rt::Scalar(1u32));
                    let _e66 = k_31;
                    let is_above = (_e66 & rt::Scalar(2u32)).elementwise_eq(rt::Scalar(2u32));
                    let _e71 = k_31;
                    let is_upper_1 = (_e71 & rt::Scalar(4u32)).elementwise_eq(rt::Scalar(4u32));
                    let behind_4 = (before_14 + rt::Scalar(1f32)).select(rt::Scalar(0f32), (before_14 + rt::Scalar(1f32)).elementwise_ge(params_107.y()));
                    let azimuth_5 = before_14.select(behind_4, is_next);
                    let layer_18 = (((azimuth_5 * params_107.z()) + below_8) + rt::Scalar(0f32).select(rt::Scalar(1f32), is_above)).to_i32();
                    let of_azimuth = (rt::Scalar(1f32) - (turn_8 - before_14)).select((turn_8 - before_14), is_next);
                    let of_elevation = (rt::Scalar(1f32) - (elevation_4 - below_8)).select((elevation_4 - below_8), is_above);
                    let of_slice = (rt::Scalar(1f32) - part_31.z()).select(part_31.z(), is_upper_1);
                    let weight_2 = ((of_azimuth * of_elevation) * of_slice);
                    let _e115 = self.v_slice_begin((cell_45.z() + rt::Scalar(0i32).select(rt::Scalar(1i32), is_upper_1)));
                    let _e121 = self.v_search_texel(path_87, (_e115 + <rt::Vec2<i32>>::from_scalars(_e21.x(), _e24.x())), layer_18, rt::Scalar(0i32));
                    let _e128 = self.v_search_texel(path_87, (_e115 + <rt::Vec2<i32>>::from_scalars(_e21.y(), _e24.x())), layer_18, rt::Scalar(0i32));
                    let _e135 = self.v_search_texel(path_87, (_e115 + <rt::Vec2<i32>>::from_scalars(_e21.x(), _e24.y())), layer_18, rt::Scalar(0i32));
                    let _e142 = self.v_search_texel(path_87, (_e115 + <rt::Vec2<i32>>::from_scalars(_e21.y(), _e24.y())), layer_18, rt::Scalar(0i32));
                    let ways_1 = <rt::Vec4<f32>>::from_scalars(_e121.x(), _e128.x(), _e135.x(), _e142.x());
                    let beside_7 = <rt::Vec2<f32>>::from_scalars((rt::Scalar(1f32) - part_31.x()), part_31.x());
                    let corners_5 = (<rt::Vec4<f32>>::new_22((beside_7 * (rt::Scalar(1f32) - part_31.y())), (beside_7 * part_31.y())) * weight_2);
                    let limit_14 = <rt::Vec4<f32>>::from_scalars(most_18, most_18, most_18, most_18);
                    let none_3 = <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
                    let solid = none_3.select(corners_5, ways_1.elementwise_lt(limit_14));
                    let way_29 = (solid * ways_1);
                    let _e167 = weights_4;
                    weights_4 = (_e167 + ((solid.x() + solid.y()) + (solid.z() + solid.w())));
                    let _e176 = sum_4;
                    sum_4 = (_e176 + ((way_29.x() + way_29.y()) + (way_29.z() + way_29.w())));
                    let _e185 = k_31;
                    k_31 = (_e185 + rt::Scalar(1u32));
                }
            }
        }
        let _e188 = weights_4;
        if rt::Scalar::into_branch_condition(_e188.elementwise_ge(rt::Scalar(0.5f32))) {
            let _e192 = sum_4;
            let _e193 = weights_4;
            return <WayToSolid>::new(rt::Scalar(1u32), (_e192 / _e193));
        }
        return <WayToSolid>::new(rt::Scalar(0u32), params_107.w());
    }
    pub(crate) fn search_generalised(
        &self,
        path_88: Path,
        params_108: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_generalised(path_88, rt::into(params_108)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_generalised(
        &self,
        path_88: Path,
        params_108: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut t_46: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut cost_23: rt::Vec3<u32> = VOXELS_READ;
        let mut looked: rt::Scalar<u32> = rt::Scalar(0u32);

        let _e2 = self.v_voxel_path(path_88);
        let _e7 = t_46;
        let _e8 = self.v_voxel_place_on(_e2, _e7);
        let _e9 = self.v_field_at_voxel(_e8);
        if rt::Scalar::into_branch_condition(_e9.elementwise_gt(rt::Scalar(0.5f32))) {
            let _e13 = t_46;
            let _e14 = t_46;
            let _e15 = cost_23;
            return <SearchResult>::new(FOUND_STARTED_BELOW, _e13, _e14, rt::Scalar(0f32), rt::Scalar(0f32), _e15);
        }
        let _e19 = self.v_volume_size();
        let last_17 = (_e19.z() - rt::Scalar(1f32));
        let limit_15 = params_108.x().to_u32();
        'naga_break: loop {
            'naga_continue: {
                let _e27 = looked;
                if rt::Scalar::into_branch_condition(_e27.elementwise_lt(limit_15)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e33 = t_46;
                    let toward_10 = (_e2.step + <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), ((rt::Scalar(2f32) * rt::Scalar(_e2.bend)) * _e33)));
                    let speed_3 = toward_10.length();
                    let direction_10 = (toward_10 / rt::Vec3::splat_from_scalar(speed_3));
                    let _e42 = t_46;
                    let _e43 = self.v_voxel_place_on(_e2, _e42);
                    let beyond_8 = (_e43.z() - _e43.z().clamp(rt::Scalar(0f32), last_17));
                    let is_inward = (beyond_8 * direction_10.z()).elementwise_lt(rt::Scalar(0f32));
                    let before_15 = rt::Scalar(0f32).select((beyond_8 / direction_10.z()).abs(), is_inward);
                    let _e60 = self.v_way_to_solid(path_88, (_e43 + (direction_10 * before_15)), direction_10, params_108);
                    let _e61 = cost_23;
                    let _e65 = self.v_map_read(path_88, rt::Scalar(32u32));
                    cost_23 = ((_e61 + STEP) + _e65);
                    let _e67 = looked;
                    looked = (_e67 + rt::Scalar(1u32));
                    let _e70 = t_46;
                    let far_21 = (_e70 + ((before_15 + rt::Scalar(_e60.way)) / speed_3));
                    if rt::Scalar::into_branch_condition((!far_21.elementwise_lt(rt::Scalar(path_88.exit)))) {
                        let _e81 = cost_23;
                        return <SearchResult>::new(FOUND_MISS, rt::Scalar(path_88.exit), rt::Scalar(path_88.exit), rt::Scalar(1f32), rt::Scalar(1f32), _e81);
                    }
                    if rt::Scalar::into_branch_condition(rt::Scalar(_e60.is_solid).elementwise_eq(rt::Scalar(1u32))) {
                        let _e92 = t_46;
                        let _e95 = cost_23;
                        return <SearchResult>::new(FOUND_ABOVE, (far_21 - (rt::Scalar(0.5f32) / speed_3)).max(_e92), rt::Scalar(path_88.exit), rt::Scalar(0f32), rt::Scalar(1f32), _e95);
                    }
                    t_46 = far_21;
                }
            }
        }
        let _e100 = t_46;
        let _e101 = t_46;
        let _e102 = cost_23;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e100, _e101, rt::Scalar(1f32), rt::Scalar(1f32), _e102);
    }
    pub(crate) fn upright(&self, uv_32: impl rt::Into<rt::Vec2<f32>>) -> rt::Vec2<f32> {
        rt::into(self.v_upright(rt::into(uv_32)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_upright(&self, uv_32: rt::Vec2<f32>) -> rt::Vec2<f32> {
        let tile_3 = uv_32.floor();
        let is_odd = (tile_3 - (rt::Scalar(2f32) * (tile_3 * rt::Scalar(0.5f32)).floor())).elementwise_gt(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32)));
        let _e14 = rt::Scalar(self.surface_settings.wrap);
        if rt::Scalar::into_branch_condition(_e14.elementwise_ne(WRAP_MIRROR)) {
            return <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32));
        }
        return <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32)).select(<rt::Vec2<f32>>::from_scalars(rt::Scalar(-1f32), rt::Scalar(-1f32)), is_odd);
    }
    pub(crate) fn path_axes(
        &self,
        path_89: Path,
        depth_9: impl rt::Into<rt::Scalar<f32>>,
    ) -> PathAxes {
        rt::into(self.v_path_axes(path_89, rt::into(depth_9)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_path_axes(
        &self,
        path_89: Path,
        depth_9: rt::Scalar<f32>,
    ) -> PathAxes {
        let mut start_3: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut fall: rt::Scalar<f32>;
        let mut way_21: rt::Scalar<f32>;
        let mut local_104: rt::Scalar<bool>;
        let mut local_105: rt::Scalar<bool>;

        let below_9 = (path_89.h.x() - rt::Scalar(1f32));
        fall = (rt::Scalar(0f32) - path_89.h.y());
        if rt::Scalar::into_branch_condition(below_9.elementwise_lt(rt::Scalar(0f32))) {
            let discriminant_6 = ((path_89.h.y() * path_89.h.y()) - ((rt::Scalar(4f32) * path_89.h.z()) * below_9));
            fall = discriminant_6.max(rt::Scalar(0f32)).sqrt();
            let _e31 = fall;
            start_3 = ((rt::Scalar(2f32) * below_9) / (_e31 - path_89.h.y()));
        }
        let _e38 = fall;
        let _e39 = fall;
        let bend_11 = (path_89.h.z() / (_e38 * _e39));
        let speed_4 = path_89.duv.length();
        way_21 = (rt::Scalar(1f32) / bend_11);
        if rt::Scalar::into_branch_condition(bend_11.elementwise_lt(rt::Scalar(0.25f32))) {
            way_21 = (rt::Scalar(2f32) / (rt::Scalar(1f32) + (rt::Scalar(1f32) - (rt::Scalar(4f32) * bend_11)).sqrt()));
        }
        let _e58 = way_21;
        let _e59 = fall;
        let whole_3 = (_e58 / _e59);
        let _e61 = fall;
        if rt::Scalar::into_branch_condition(_e61.elementwise_gt(rt::Scalar(0f32))) {
            local_104 = whole_3.elementwise_gt(rt::Scalar(0f32));
        } else {
            local_104 = rt::Scalar(false);
        }
        let _e69 = local_104;
        if rt::Scalar::into_branch_condition(_e69) {
            let _e72 = start_3;
            local_105 = _e72.elementwise_ge((whole_3 * rt::Scalar(-1.001f32)));
        } else {
            local_105 = rt::Scalar(false);
        }
        let comes_in = local_105;
        let _e84 = start_3;
        let _e87 = self.v_upright((path_89.uv + (path_89.duv * _e84)));
        let _e89 = self.v_turn_of((path_89.duv * _e87));
        let _e90 = fall;
        let _e102 = start_3;
        let _e103 = fall;
        return <PathAxes>::new(rt::Scalar(0u32).select(rt::Scalar(1u32), comes_in), _e89, (speed_4 / (speed_4 + (depth_9 * _e90))), (rt::Scalar(0.5f32) + (rt::Scalar(0.5f32) * (bend_11 / (rt::Scalar(0.25f32) + bend_11.abs())))), _e102, whole_3, _e103);
    }
    pub(crate) fn views_around(
        &self,
        axes: PathAxes,
        params_109: impl rt::Into<rt::Vec4<f32>>,
    ) -> ViewsAround {
        rt::into(self.v_views_around(axes, rt::into(params_109)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_views_around(
        &self,
        axes: PathAxes,
        params_109: rt::Vec4<f32>,
    ) -> ViewsAround {
        let elevation_5 = ((rt::Scalar(axes.elevation) * params_109.y()) - rt::Scalar(0.5f32)).clamp(rt::Scalar(0f32), (params_109.y() - rt::Scalar(1f32)));
        let below_10 = elevation_5.floor().min((params_109.y() - rt::Scalar(2f32)));
        let bend_12 = ((rt::Scalar(axes.bend) * params_109.z()) - rt::Scalar(0.5f32)).clamp(rt::Scalar(0f32), (params_109.z() - rt::Scalar(1f32)));
        let lower_5 = bend_12.floor().min((params_109.z() - rt::Scalar(2f32)).max(rt::Scalar(0f32)));
        let turn_9 = ((rt::Scalar(axes.turn) * params_109.x()) - rt::Scalar(0.5f32));
        let before_16 = turn_9.floor();
        return <ViewsAround>::new(rt::Scalar(4u32).select(rt::Scalar(2u32), params_109.z().elementwise_eq(rt::Scalar(1f32))), before_16, params_109.x(), below_10, params_109.y(), lower_5, <rt::Vec3<f32>>::from_scalars((turn_9 - before_16), (elevation_5 - below_10), (bend_12 - lower_5)));
    }
    pub(crate) fn no_views(&self) -> JoinedViews {
        rt::into(self.v_no_views())
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_no_views(&self) -> JoinedViews {
        return <JoinedViews>::new(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)), <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)), <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)));
    }
    pub(crate) fn view_pair(
        &self,
        views: ViewsAround,
        k_32: impl rt::Into<rt::Scalar<u32>>,
    ) -> ViewPair {
        rt::into(self.v_view_pair(views, rt::into(k_32)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_view_pair(
        &self,
        views: ViewsAround,
        k_32: rt::Scalar<u32>,
    ) -> ViewPair {
        let mut azimuth_2: rt::Scalar<f32>;

        let is_next_1 = (k_32 & rt::Scalar(1u32)).elementwise_eq(rt::Scalar(1u32));
        azimuth_2 = (rt::Scalar(views.before) + rt::Scalar(0f32).select(rt::Scalar(1f32), is_next_1));
        let _e12 = azimuth_2;
        let _e13 = azimuth_2;
        let _e16 = azimuth_2;
        azimuth_2 = _e12.select((_e13 + rt::Scalar(views.azimuths)), _e16.elementwise_lt(rt::Scalar(0f32)));
        let _e20 = azimuth_2;
        let _e21 = azimuth_2;
        let _e24 = azimuth_2;
        azimuth_2 = _e20.select((_e21 - rt::Scalar(views.azimuths)), _e24.elementwise_ge(rt::Scalar(views.azimuths)));
        let _e28 = azimuth_2;
        let layer_19 = ((_e28 * rt::Scalar(views.elevations)) + rt::Scalar(views.below)).to_i32();
        return <ViewPair>::new(layer_19, (rt::Scalar(views.lower) + rt::Scalar(0f32).select(rt::Scalar(1f32), k_32.elementwise_gt(rt::Scalar(1u32)))));
    }
    pub(crate) fn with_pair(
        &self,
        joined: JoinedViews,
        views_1: ViewsAround,
        k_33: impl rt::Into<rt::Scalar<u32>>,
        ways: impl rt::Into<rt::Vec4<f32>>,
    ) -> JoinedViews {
        rt::into(self.v_with_pair(joined, views_1, rt::into(k_33), rt::into(ways)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_with_pair(
        &self,
        joined: JoinedViews,
        views_1: ViewsAround,
        k_33: rt::Scalar<u32>,
        ways: rt::Vec4<f32>,
    ) -> JoinedViews {
        let of_below = <rt::Vec2<f32>>::from_scalars(ways.x(), ways.y());
        let of_azimuth_1 = (of_below + ((<rt::Vec2<f32>>::from_scalars(ways.z(), ways.w()) - of_below) * views_1.part.y()));
        let of_bend = (joined.first + ((of_azimuth_1 - joined.first) * views_1.part.x()));
        if rt::Scalar::into_branch_condition(k_33.elementwise_eq(rt::Scalar(1u32))) {
            return <JoinedViews>::new(of_azimuth_1, of_bend, of_bend);
        }
        return <JoinedViews>::new(of_azimuth_1, joined.low, of_bend);
    }
    pub(crate) fn row_of_bend(
        &self,
        row_8: impl rt::Into<rt::Scalar<i32>>,
        bend_3: impl rt::Into<rt::Scalar<f32>>,
        rows_15: impl rt::Into<rt::Scalar<i32>>,
    ) -> i32 {
        rt::into(self.v_row_of_bend(rt::into(row_8), rt::into(bend_3), rt::into(rows_15)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_row_of_bend(
        &self,
        row_8: rt::Scalar<i32>,
        bend_3: rt::Scalar<f32>,
        rows_15: rt::Scalar<i32>,
    ) -> rt::Scalar<i32> {
        return (row_8 + (bend_3.to_i32() * rows_15));
    }
    pub(crate) fn ways_of_texel(
        &self,
        path_90: Path,
        texel_6: impl rt::Into<rt::Vec2<i32>>,
        layer_11: impl rt::Into<rt::Scalar<i32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_ways_of_texel(path_90, rt::into(texel_6), rt::into(layer_11)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_ways_of_texel(
        &self,
        path_90: Path,
        texel_6: rt::Vec2<i32>,
        layer_11: rt::Scalar<i32>,
    ) -> rt::Vec4<f32> {
        let level_68 = rt::Scalar(path_90.level).to_i32();
        let _e5 = self.v_search_texel(path_90, texel_6, layer_11, level_68);
        let below_11 = _e5.x();
        let _e9 = self.v_search_texel(path_90, texel_6, (layer_11 + rt::Scalar(1i32)), level_68);
        let above_11 = _e9.x();
        let is_below = below_11.elementwise_lt(rt::Scalar(0.998f32));
        let is_above_1 = above_11.elementwise_lt(rt::Scalar(0.998f32));
        return <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32).select(below_11, is_below), rt::Scalar(0f32).select(rt::Scalar(1f32), is_below), rt::Scalar(0f32).select(above_11, is_above_1), rt::Scalar(0f32).select(rt::Scalar(1f32), is_above_1));
    }
    pub(crate) fn ways_of_bend(
        &self,
        path_91: Path,
        around_1: Around,
        layer_12: impl rt::Into<rt::Scalar<i32>>,
        bend_4: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_ways_of_bend(path_91, around_1, rt::into(layer_12), rt::into(bend_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_ways_of_bend(
        &self,
        path_91: Path,
        around_1: Around,
        layer_12: rt::Scalar<i32>,
        bend_4: rt::Scalar<f32>,
    ) -> rt::Vec4<f32> {
        let _e5 = self.v_height_texels(rt::Scalar(path_91.level));
        let rows_16 = _e5.y();
        let _e9 = self.v_row_of_bend(around_1.rows.x(), bend_4, rows_16);
        let _e12 = self.v_row_of_bend(around_1.rows.y(), bend_4, rows_16);
        let _e16 = self.v_ways_of_texel(path_91, <rt::Vec2<i32>>::from_scalars(around_1.columns.x(), _e9), layer_12);
        let _e20 = self.v_ways_of_texel(path_91, <rt::Vec2<i32>>::from_scalars(around_1.columns.y(), _e9), layer_12);
        let _e24 = self.v_ways_of_texel(path_91, <rt::Vec2<i32>>::from_scalars(around_1.columns.x(), _e12), layer_12);
        let _e28 = self.v_ways_of_texel(path_91, <rt::Vec2<i32>>::from_scalars(around_1.columns.y(), _e12), layer_12);
        let _e30 = self.v_bilinear(_e16, _e20, _e24, _e28, around_1.part);
        return _e30;
    }
    pub(crate) fn hit_on_way(
        &self,
        path_92: Path,
        axes_1: PathAxes,
        way_22: impl rt::Into<rt::Vec2<f32>>,
        cost_24: impl rt::Into<rt::Vec3<u32>>,
    ) -> SearchResult {
        rt::into(self.v_hit_on_way(path_92, axes_1, rt::into(way_22), rt::into(cost_24)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_hit_on_way(
        &self,
        path_92: Path,
        axes_1: PathAxes,
        way_22: rt::Vec2<f32>,
        cost_24: rt::Vec3<u32>,
    ) -> SearchResult {
        let mut local_106: rt::Scalar<bool>;
        let mut local_107: rt::Scalar<bool>;

        let t_55 = (rt::Scalar(axes_1.start) + ((way_22.x() / way_22.y()) * rt::Scalar(axes_1.whole)));
        if rt::Scalar::into_branch_condition((!way_22.y().elementwise_lt(rt::Scalar(0.5f32)))) {
            local_106 = t_55.elementwise_lt(rt::Scalar(0f32));
        } else {
            local_106 = rt::Scalar(true);
        }
        let _e20 = local_106;
        if rt::Scalar::into_branch_condition((!_e20)) {
            local_107 = t_55.elementwise_gt(rt::Scalar(path_92.exit));
        } else {
            local_107 = rt::Scalar(true);
        }
        let _e27 = local_107;
        if rt::Scalar::into_branch_condition(_e27) {
            return <SearchResult>::new(FOUND_MISS, rt::Scalar(path_92.exit), rt::Scalar(path_92.exit), rt::Scalar(1f32), rt::Scalar(1f32), cost_24);
        }
        return <SearchResult>::new(FOUND_ABOVE, t_55, rt::Scalar(path_92.exit), rt::Scalar(0f32), rt::Scalar(1f32), cost_24);
    }
    pub(crate) fn joined_way(&self, joined_1: JoinedViews, views_2: ViewsAround) -> rt::Vec2<f32> {
        rt::into(self.v_joined_way(joined_1, views_2))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_joined_way(&self, joined_1: JoinedViews, views_2: ViewsAround) -> rt::Vec2<f32> {
        return (joined_1.low + ((joined_1.high - joined_1.low) * views_2.part.z()));
    }
    pub(crate) fn search_view_dependent(
        &self,
        path_93: Path,
        params_110: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_view_dependent(path_93, rt::into(params_110)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_view_dependent(
        &self,
        path_93: Path,
        params_110: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut joined_2: JoinedViews;
        let mut k_34: rt::Scalar<u32> = rt::Scalar(0u32);

        let _e3 = self.v_path_axes(path_93, params_110.w());
        let _e4 = self.v_views_around(_e3, params_110);
        let _e9 = self.v_map_read(path_93, (rt::Scalar(_e4.pairs) * rt::Scalar(8u32)));
        let cost_34 = (STEP + _e9);
        if rt::Scalar::into_branch_condition(rt::Scalar(_e3.comes_in).elementwise_eq(rt::Scalar(0u32))) {
            return <SearchResult>::new(FOUND_MISS, rt::Scalar(path_93.exit), rt::Scalar(path_93.exit), rt::Scalar(1f32), rt::Scalar(1f32), STEP);
        }
        let _e22 = self.v_path_uv(path_93, rt::Scalar(_e3.start));
        let _e24 = self.v_height_texels(rt::Scalar(path_93.level));
        let _e25 = self.v_texels_around(_e22, _e24);
        let _e26 = self.v_no_views();
        joined_2 = _e26;
        'naga_break: loop {
            'naga_continue: {
                let _e30 = k_34;
                if rt::Scalar::into_branch_condition(_e30.elementwise_lt(rt::Scalar(_e4.pairs))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e33 = k_34;
                    let _e34 = self.v_view_pair(_e4, _e33);
                    let _e35 = joined_2;
                    let _e36 = k_34;
                    let _e39 = self.v_ways_of_bend(path_93, _e25, rt::Scalar(_e34.layer), rt::Scalar(_e34.bend));
                    let _e40 = self.v_with_pair(_e35, _e4, _e36, _e39);
                    joined_2 = _e40;
                    let _e41 = k_34;
                    k_34 = (_e41 + rt::Scalar(1u32));
                }
            }
        }
        let _e44 = joined_2;
        let _e45 = self.v_joined_way(_e44, _e4);
        let _e46 = self.v_hit_on_way(path_93, _e3, _e45, cost_34);
        return _e46;
    }
    pub(crate) fn is_in_footprint(
        &self,
        square: impl rt::Into<rt::Vec2<f32>>,
        size: impl rt::Into<rt::Vec2<f32>>,
    ) -> bool {
        rt::into(self.v_is_in_footprint(rt::into(square), rt::into(size)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_is_in_footprint(
        &self,
        square: rt::Vec2<f32>,
        size: rt::Vec2<f32>,
    ) -> rt::Scalar<bool> {
        let mut local_108: rt::Scalar<bool>;
        let mut local_109: rt::Scalar<bool>;
        let mut local_110: rt::Scalar<bool>;
        let mut local_111: rt::Scalar<bool>;

        if rt::Scalar::into_branch_condition(square.x().elementwise_ge(rt::Scalar(0f32))) {
            local_108 = square.y().elementwise_ge(rt::Scalar(0f32));
        } else {
            local_108 = rt::Scalar(false);
        }
        let _e11 = local_108;
        if rt::Scalar::into_branch_condition(_e11) {
            local_109 = square.x().elementwise_lt(size.x());
        } else {
            local_109 = rt::Scalar(false);
        }
        let _e18 = local_109;
        if rt::Scalar::into_branch_condition(_e18) {
            local_110 = square.y().elementwise_lt(size.y());
        } else {
            local_110 = rt::Scalar(false);
        }
        let holds_square = local_110;
        if rt::Scalar::into_branch_condition((!holds_square)) {
            let _e31 = rt::Scalar(self.surface_settings.wrap);
            local_111 = _e31.elementwise_ne(WRAP_CLAMP);
        } else {
            local_111 = rt::Scalar(true);
        }
        let _e35 = local_111;
        return _e35;
    }
    pub(crate) fn step_of_axis(
        &self,
        place_32: impl rt::Into<rt::Scalar<f32>>,
        count_5: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_step_of_axis(rt::into(place_32), rt::into(count_5)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_step_of_axis(
        &self,
        place_32: rt::Scalar<f32>,
        count_5: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        return (place_32 * count_5).floor().clamp(rt::Scalar(0f32), (count_5 - rt::Scalar(1f32)));
    }
    pub(crate) fn longest_of_step(
        &self,
        bend_5: impl rt::Into<rt::Scalar<f32>>,
        count_6: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_longest_of_step(rt::into(bend_5), rt::into(count_6)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_longest_of_step(
        &self,
        bend_5: rt::Scalar<f32>,
        count_6: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        if rt::Scalar::into_branch_condition(count_6.elementwise_eq(rt::Scalar(1f32))) {
            return rt::Scalar(1f32);
        }
        let low_11 = (((rt::Scalar(2f32) * bend_5) / count_6) - rt::Scalar(1f32));
        let high_6 = (low_11 + (rt::Scalar(2f32) / count_6));
        if rt::Scalar::into_branch_condition(high_6.elementwise_lt(rt::Scalar(0.500001f32))) {
            return (rt::Scalar(2f32) / (rt::Scalar(1f32) + (rt::Scalar(1f32) - (high_6 / (rt::Scalar(1f32) - high_6.abs()))).max(rt::Scalar(0f32)).sqrt()));
        }
        let least_9 = low_11.max(rt::Scalar(0.5f32));
        return ((rt::Scalar(4f32) * (rt::Scalar(1f32) - least_9)) / least_9);
    }
    pub(crate) fn free_way_of_step(
        &self,
        path_94: Path,
        axes_2: PathAxes,
        square_1: impl rt::Into<rt::Vec2<i32>>,
        params_111: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_free_way_of_step(path_94, axes_2, rt::into(square_1), rt::into(params_111)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_free_way_of_step(
        &self,
        path_94: Path,
        axes_2: PathAxes,
        square_1: rt::Vec2<i32>,
        params_111: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        let _e5 = self.v_height_texels(rt::Scalar(path_94.level));
        let _e8 = self.v_step_of_axis(rt::Scalar(axes_2.turn), params_111.x());
        let _e11 = self.v_step_of_axis(rt::Scalar(axes_2.elevation), params_111.y());
        let _e14 = self.v_step_of_axis(rt::Scalar(axes_2.bend), params_111.z());
        let _e17 = self.v_wrap_index(square_1.y(), _e5.y());
        let _e19 = self.v_row_of_bend(_e17, _e14, _e5.y());
        let _e22 = self.v_wrap_index(square_1.x(), _e5.x());
        let at_186 = <rt::Vec2<i32>>::from_scalars(_e22, _e19);
        let _e30 = self.v_search_texel(path_94, at_186, ((_e8 * params_111.y()) + _e11).to_i32(), rt::Scalar(path_94.level).to_i32());
        let part_32 = _e30.x();
        let _e33 = self.v_longest_of_step(_e14, params_111.z());
        return (part_32 * _e33);
    }
    pub(crate) fn search_view_dependent_free(
        &self,
        path_95: Path,
        params_112: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_view_dependent_free(path_95, rt::into(params_112)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_view_dependent_free(
        &self,
        path_95: Path,
        params_112: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut local_112: rt::Scalar<bool>;
        let mut local_113: rt::Scalar<bool>;
        let mut local_114: rt::Scalar<bool>;
        let mut local_115: rt::Scalar<bool>;
        let mut local_116: rt::Scalar<bool>;

        let _e3 = self.v_path_axes(path_95, params_112.w());
        let _e6 = self.v_height_size(rt::Scalar(path_95.level));
        let place_46 = (path_95.uv * _e6);
        let _e8 = self.v_cell_of(place_46);
        let inside_8 = (place_46 - _e8);
        let near_13 = inside_8.x().min((rt::Scalar(1f32) - inside_8.x())).min(inside_8.y().min((rt::Scalar(1f32) - inside_8.y())));
        let rounded_2 = (rt::Scalar(0.0000009536743f32) * (place_46.x().abs().max(place_46.y().abs()) + rt::Scalar(1f32)));
        let _e31 = self.v_height_size(rt::Scalar(path_95.level));
        let _e32 = self.v_is_in_footprint(_e8, _e31);
        if rt::Scalar::into_branch_condition(path_95.h.x().elementwise_eq(rt::Scalar(1f32))) {
            local_112 = rt::Scalar(_e3.comes_in).elementwise_eq(rt::Scalar(1u32));
        } else {
            local_112 = rt::Scalar(false);
        }
        let _e43 = local_112;
        if rt::Scalar::into_branch_condition(_e43) {
            local_113 = near_13.elementwise_gt(rounded_2);
        } else {
            local_113 = rt::Scalar(false);
        }
        let _e48 = local_113;
        if rt::Scalar::into_branch_condition(_e48) {
            local_114 = _e32;
        } else {
            local_114 = rt::Scalar(false);
        }
        let is_known = local_114;
        if rt::Scalar::into_branch_condition((!(!is_known))) {
            if rt::Scalar::into_branch_condition(params_112.z().elementwise_eq(rt::Scalar(1f32))) {
                local_116 = path_95.h.z().elementwise_ne(rt::Scalar(0f32));
            } else {
                local_116 = rt::Scalar(false);
            }
            let _e67 = local_116;
            local_115 = _e67;
        } else {
            local_115 = rt::Scalar(true);
        }
        let _e69 = local_115;
        if rt::Scalar::into_branch_condition(_e69) {
            return <SearchResult>::new(FOUND_ABOVE, rt::Scalar(0f32), rt::Scalar(path_95.exit), rt::Scalar(0f32), rt::Scalar(1f32), STEP);
        }
        let _e77 = self.v_whole_cell(_e8);
        let _e78 = self.v_free_way_of_step(path_95, _e3, _e77, params_112);
        let free_2 = (_e78 / rt::Scalar(_e3.fall));
        let _e87 = self.v_map_read(path_95, rt::Scalar(1u32));
        return <SearchResult>::new(FOUND_ABOVE, free_2.min(rt::Scalar(path_95.exit)), rt::Scalar(path_95.exit), rt::Scalar(0f32), rt::Scalar(1f32), (STEP + _e87));
    }
    pub(crate) fn search_translucent(
        &self,
        path_96: Path,
        params_113: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_translucent(path_96, rt::into(params_113)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_translucent(
        &self,
        path_96: Path,
        params_113: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut part_14: CellPart;
        let mut cost_25: rt::Vec3<u32> = NO_COST;

        let _e2 = self.v_voxel_path(path_96);
        let _e3 = self.v_turning_point(_e2);
        let limit_16 = params_113.z().to_u32();
        let _e6 = self.v_first_part(path_96, _e2, _e3);
        part_14 = _e6;
        'naga_break: loop {
            'naga_continue: {
                let _e11 = cost_25.y();
                if rt::Scalar::into_branch_condition(_e11.elementwise_lt(limit_16)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e13 = cost_25;
                    let _e17 = self.v_map_read(path_96, rt::Scalar(1u32));
                    cost_25 = ((_e13 + STEP) + _e17);
                    let _e20 = rt::Scalar(part_14.empty);
                    if rt::Scalar::into_branch_condition(_e20.elementwise_lt(rt::Scalar(0f32))) {
                        let _e25 = rt::Scalar(part_14.begin);
                        let _e27 = rt::Scalar(part_14.begin);
                        let _e28 = cost_25;
                        return <SearchResult>::new(FOUND_ABOVE, _e25, _e27, rt::Scalar(0f32), rt::Scalar(1f32), _e28);
                    }
                    let _e33 = rt::Scalar(part_14.is_last);
                    if rt::Scalar::into_branch_condition(_e33.elementwise_eq(rt::Scalar(1u32))) {
                        let _e38 = rt::Scalar(part_14.end);
                        let _e40 = rt::Scalar(part_14.end);
                        let _e41 = cost_25;
                        return <SearchResult>::new(FOUND_MISS, _e38, _e40, rt::Scalar(1f32), rt::Scalar(1f32), _e41);
                    }
                    let _e45 = part_14;
                    let _e46 = self.v_next_part(path_96, _e2, _e3, _e45);
                    part_14 = _e46;
                }
            }
        }
        let _e49 = rt::Scalar(part_14.begin);
        let _e51 = rt::Scalar(part_14.begin);
        let _e52 = cost_25;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e49, _e51, rt::Scalar(1f32), rt::Scalar(1f32), _e52);
    }
    pub(crate) fn with_axis_last(
        &self,
        v_2: impl rt::Into<rt::Vec3<f32>>,
        axis_3: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_with_axis_last(rt::into(v_2), rt::into(axis_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_with_axis_last(
        &self,
        v_2: rt::Vec3<f32>,
        axis_3: rt::Scalar<u32>,
    ) -> rt::Vec3<f32> {
        if rt::Scalar::into_branch_condition(axis_3.elementwise_eq(rt::Scalar(0u32))) {
            return <rt::Vec3<f32>>::from_scalars(v_2.y(), v_2.z(), v_2.x());
        }
        if rt::Scalar::into_branch_condition(axis_3.elementwise_eq(rt::Scalar(1u32))) {
            return <rt::Vec3<f32>>::from_scalars(v_2.z(), v_2.x(), v_2.y());
        }
        return v_2;
    }
    pub(crate) fn motif_ray(
        &self,
        origin_2: impl rt::Into<rt::Vec3<f32>>,
        step_4: impl rt::Into<rt::Vec3<f32>>,
    ) -> MotifRay {
        rt::into(self.v_motif_ray(rt::into(origin_2), rt::into(step_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_motif_ray(
        &self,
        origin_2: rt::Vec3<f32>,
        step_4: rt::Vec3<f32>,
    ) -> MotifRay {
        let mut axis_4: rt::Scalar<u32>;

        let size_7 = step_4.abs();
        axis_4 = rt::Scalar(2u32).select(rt::Scalar(1u32), size_7.y().elementwise_gt(size_7.z()));
        let _e10 = axis_4;
        axis_4 = _e10.select(rt::Scalar(0u32), size_7.x().elementwise_gt(size_7.y().max(size_7.z())));
        let _e18 = axis_4;
        let _e19 = self.v_with_axis_last(step_4, _e18);
        let least_10 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0.000000000000000000000000000001f32), rt::Scalar(0.000000000000000000000000000001f32), rt::Scalar(0.000000000000000000000000000001f32));
        let inverse = <rt::Vec3<f32>>::from_scalars(rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32)).select((<rt::Vec3<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32), rt::Scalar(1f32)) / step_4), size_7.elementwise_gt(least_10));
        let _e35 = axis_4;
        return <MotifRay>::new(origin_2, inverse, _e35, <rt::Vec3<f32>>::from_scalars((_e19.x() / _e19.z()), (_e19.y() / _e19.z()), (rt::Scalar(1f32) / _e19.z())));
    }
    pub(crate) fn meets_box(
        &self,
        ray_8: MotifRay,
        low_2: impl rt::Into<rt::Vec3<f32>>,
        high_2: impl rt::Into<rt::Vec3<f32>>,
        near_9: impl rt::Into<rt::Scalar<f32>>,
        far_7: impl rt::Into<rt::Scalar<f32>>,
    ) -> bool {
        rt::into(self.v_meets_box(ray_8, rt::into(low_2), rt::into(high_2), rt::into(near_9), rt::into(far_7)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_meets_box(
        &self,
        ray_8: MotifRay,
        low_2: rt::Vec3<f32>,
        high_2: rt::Vec3<f32>,
        near_9: rt::Scalar<f32>,
        far_7: rt::Scalar<f32>,
    ) -> rt::Scalar<bool> {
        let a_46 = ((low_2 - ray_8.origin) * ray_8.inverse);
        let b_46 = ((high_2 - ray_8.origin) * ray_8.inverse);
        let first_30 = a_46.min(b_46);
        let last_18 = a_46.max(b_46);
        let enter_3 = first_30.x().max(first_30.y()).max(first_30.z().max(near_9));
        let leave_11 = last_18.x().min(last_18.y()).min(last_18.z().min(far_7));
        return enter_3.elementwise_le(leave_11);
    }
    pub(crate) fn seen_beside(
        &self,
        ray_9: MotifRay,
        corner_3: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_seen_beside(ray_9, rt::into(corner_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_seen_beside(
        &self,
        ray_9: MotifRay,
        corner_3: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let _e5 = self.v_with_axis_last((corner_3 - ray_9.origin), rt::Scalar(ray_9.axis));
        return <rt::Vec3<f32>>::from_scalars((_e5.x() - (ray_9.shear.x() * _e5.z())), (_e5.y() - (ray_9.shear.y() * _e5.z())), _e5.z());
    }
    pub(crate) fn meets_triangle(
        &self,
        ray_10: MotifRay,
        first_4: impl rt::Into<rt::Vec3<f32>>,
        second_1: impl rt::Into<rt::Vec3<f32>>,
        third: impl rt::Into<rt::Vec3<f32>>,
    ) -> f32 {
        rt::into(self.v_meets_triangle(ray_10, rt::into(first_4), rt::into(second_1), rt::into(third)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_meets_triangle(
        &self,
        ray_10: MotifRay,
        first_4: rt::Vec3<f32>,
        second_1: rt::Vec3<f32>,
        third: rt::Vec3<f32>,
    ) -> rt::Scalar<f32> {
        let mut local_117: rt::Scalar<bool>;
        let mut local_118: rt::Scalar<bool>;

        let _e4 = self.v_seen_beside(ray_10, first_4);
        let _e5 = self.v_seen_beside(ray_10, second_1);
        let _e6 = self.v_seen_beside(ray_10, third);
        let left_7 = <rt::Vec3<f32>>::from_scalars((_e6.x() * _e5.y()), (_e4.x() * _e6.y()), (_e5.x() * _e4.y()));
        let right_5 = <rt::Vec3<f32>>::from_scalars((_e6.y() * _e5.x()), (_e4.y() * _e6.x()), (_e5.y() * _e4.x()));
        let sides_3 = (left_7 - right_5);
        let slack_6 = ((left_7.abs() + right_5.abs()) * rt::Scalar(0.0000005f32));
        let most_19 = (sides_3 + slack_6);
        let least_11 = (sides_3 - slack_6);
        let is_front_1 = most_19.x().min(most_19.y()).min(most_19.z()).elementwise_ge(rt::Scalar(0f32));
        let is_back = least_11.x().max(least_11.y()).max(least_11.z()).elementwise_le(rt::Scalar(0f32));
        let all_3 = ((sides_3.x() + sides_3.y()) + sides_3.z());
        if rt::Scalar::into_branch_condition((!is_front_1)) {
            local_117 = is_back;
        } else {
            local_117 = rt::Scalar(true);
        }
        let _e58 = local_117;
        if rt::Scalar::into_branch_condition((!(!_e58))) {
            local_118 = all_3.elementwise_eq(rt::Scalar(0f32));
        } else {
            local_118 = rt::Scalar(true);
        }
        let _e66 = local_118;
        if rt::Scalar::into_branch_condition(_e66) {
            return rt::Scalar(300000000000000000000000000000000000000f32);
        }
        let along_41 = ((((sides_3.x() * _e4.z()) + (sides_3.y() * _e5.z())) + (sides_3.z() * _e6.z())) / all_3);
        let least_z = _e4.z().min(_e5.z()).min(_e6.z());
        let most_z = _e4.z().max(_e5.z()).max(_e6.z());
        return (along_41.clamp(least_z, most_z) * ray_10.shear.z());
    }
    pub(crate) fn first_of_leaf(
        &self,
        ray_11: MotifRay,
        leaf_1: impl rt::Into<rt::Scalar<u32>>,
        near_10: impl rt::Into<rt::Scalar<f32>>,
        far_8: impl rt::Into<rt::Scalar<f32>>,
    ) -> MotifHit {
        rt::into(self.v_first_of_leaf(ray_11, rt::into(leaf_1), rt::into(near_10), rt::into(far_8)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_first_of_leaf(
        &self,
        ray_11: MotifRay,
        leaf_1: rt::Scalar<u32>,
        near_10: rt::Scalar<f32>,
        far_8: rt::Scalar<f32>,
    ) -> MotifHit {
        let mut found_15: rt::Scalar<f32> = rt::Scalar(300000000000000000000000000000000000000f32);
        let mut cost_26: rt::Vec3<u32> = NO_COST;
        let mut triangle_2: rt::Scalar<u32>;
        let mut local_119: rt::Scalar<bool>;

        triangle_2 = leaf_1;
        'naga_break: loop {
            'naga_continue: {
                let _e9 = triangle_2;
                if rt::Scalar::into_branch_condition(_e9.elementwise_ne(rt::Scalar(0u32))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e12 = triangle_2;
                    let _e13 = self.v_motif_texel(_e12);
                    let _e14 = triangle_2;
                    let _e17 = self.v_motif_texel((_e14 + rt::Scalar(1u32)));
                    let _e18 = triangle_2;
                    let _e21 = self.v_motif_texel((_e18 + rt::Scalar(2u32)));
                    let _e22 = cost_26;
                    cost_26 = (_e22 + TRIANGLE_READ);
                    let _e28 = self.v_meets_triangle(ray_11, _e13.xyz(), _e17.xyz(), _e21.xyz());
                    if rt::Scalar::into_branch_condition(_e28.elementwise_ge(near_10)) {
                        let _e32 = found_15;
                        local_119 = _e28.elementwise_lt(_e32.min(far_8));
                    } else {
                        local_119 = rt::Scalar(false);
                    }
                    let _e36 = local_119;
                    if rt::Scalar::into_branch_condition(_e36) {
                        found_15 = _e28;
                    }
                    let _e37 = triangle_2;
                    triangle_2 = (_e37 + rt::Scalar(3u32)).select(rt::Scalar(0u32), _e13.w().elementwise_eq(rt::Scalar(0f32)));
                }
            }
        }
        let _e45 = found_15;
        let _e46 = cost_26;
        return <MotifHit>::new(_e45, _e46);
    }
    pub(crate) fn first_of_motif(
        &self,
        ray_12: MotifRay,
        near_11: impl rt::Into<rt::Scalar<f32>>,
        far_9: impl rt::Into<rt::Scalar<f32>>,
        before_4: impl rt::Into<rt::Vec3<u32>>,
        limit_1: impl rt::Into<rt::Scalar<u32>>,
    ) -> MotifHit {
        rt::into(self.v_first_of_motif(ray_12, rt::into(near_11), rt::into(far_9), rt::into(before_4), rt::into(limit_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_first_of_motif(
        &self,
        ray_12: MotifRay,
        near_11: rt::Scalar<f32>,
        far_9: rt::Scalar<f32>,
        before_4: rt::Vec3<u32>,
        limit_1: rt::Scalar<u32>,
    ) -> MotifHit {
        let mut cost_27: rt::Vec3<u32>;
        let mut found_16: rt::Scalar<f32> = rt::Scalar(300000000000000000000000000000000000000f32);
        let mut node_1: rt::Scalar<u32> = rt::Scalar(1u32);
        let mut local_120: rt::Scalar<bool>;
        let mut next_9: rt::Scalar<u32>;

        cost_27 = before_4;
        'naga_break: loop {
            'naga_continue: {
                let _e10 = node_1;
                if rt::Scalar::into_branch_condition(_e10.elementwise_ne(rt::Scalar(0u32))) {
                    let _e16 = cost_27.y();
                    local_120 = _e16.elementwise_lt(limit_1);
                } else {
                    local_120 = rt::Scalar(false);
                }
                let _e19 = local_120;
                if rt::Scalar::into_branch_condition(_e19) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e20 = node_1;
                    let _e21 = self.v_motif_texel(_e20);
                    let _e22 = node_1;
                    let _e25 = self.v_motif_texel((_e22 + rt::Scalar(1u32)));
                    let _e26 = cost_27;
                    cost_27 = ((_e26 + STEP) + NODE_READ);
                    let _e31 = found_16;
                    let best = _e31.min(far_9);
                    next_9 = _e21.w().to_u32();
                    let _e38 = self.v_meets_box(ray_12, _e21.xyz(), _e25.xyz(), near_11, best);
                    if rt::Scalar::into_branch_condition(_e38) {
                        if rt::Scalar::into_branch_condition(_e25.w().elementwise_eq(rt::Scalar(0f32))) {
                            let _e42 = node_1;
                            next_9 = (_e42 + rt::Scalar(2u32));
                        } else {
                            let _e47 = self.v_first_of_leaf(ray_12, _e25.w().to_u32(), near_11, best);
                            let _e48 = found_16;
                            found_16 = _e48.min(rt::Scalar(_e47.t));
                            let _e51 = cost_27;
                            cost_27 = (_e51 + _e47.cost);
                        }
                    }
                    let _e54 = next_9;
                    node_1 = _e54;
                }
            }
        }
        let _e55 = found_16;
        let _e56 = cost_27;
        return <MotifHit>::new(_e55, _e56);
    }
    pub(crate) fn search_shell_map(
        &self,
        path_97: Path,
        params_114: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_shell_map(path_97, rt::into(params_114)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_shell_map(
        &self,
        path_97: Path,
        params_114: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut cost_28: rt::Vec3<u32> = NO_COST;
        let mut tile: rt::Vec2<f32>;
        let mut t_47: rt::Scalar<f32> = rt::Scalar(0f32);

        let step_9 = <rt::Vec3<f32>>::new_21(path_97.duv, path_97.h.y());
        let slack_7 = (rt::Scalar(0.00002f32) / step_9.x().abs().max(step_9.y().abs()).max(step_9.z().abs()));
        let limit_17 = params_114.x().to_u32();
        tile = path_97.uv.floor();
        'naga_break: loop {
            'naga_continue: {
                let _e26 = cost_28.y();
                if rt::Scalar::into_branch_condition(_e26.elementwise_lt(limit_17)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e28 = tile;
                    let ahead_3 = (_e28 + <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)).select(<rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32)), path_97.duv.elementwise_gt(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)))));
                    let beside_8 = ((ahead_3 - path_97.uv) / path_97.duv);
                    let leave_12 = <rt::Vec2<f32>>::from_scalars(rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(300000000000000000000000000000000000000f32)).select(beside_8, path_97.duv.abs().elementwise_gt(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32))));
                    let _e61 = t_47;
                    let end_26 = leave_12.x().min(leave_12.y()).min(rt::Scalar(path_97.exit)).max(_e61);
                    let _e63 = t_47;
                    let _e64 = self.v_path_uv(path_97, _e63);
                    let _e65 = tile;
                    let _e67 = t_47;
                    let _e68 = self.v_path_height(path_97, _e67);
                    let _e70 = self.v_motif_ray(<rt::Vec3<f32>>::new_21((_e64 - _e65), _e68), step_9);
                    let _e73 = t_47;
                    let _e76 = cost_28;
                    let _e77 = self.v_first_of_motif(_e70, (rt::Scalar(0f32) - slack_7), ((end_26 - _e73) + slack_7), _e76, limit_17);
                    cost_28 = _e77.cost;
                    if rt::Scalar::into_branch_condition(rt::Scalar(_e77.t).elementwise_lt(rt::Scalar(300000000000000000000000000000000000000f32))) {
                        let _e82 = t_47;
                        let at_187 = (_e82 + rt::Scalar(_e77.t)).clamp(rt::Scalar(0f32), rt::Scalar(path_97.exit));
                        let _e89 = cost_28;
                        return <SearchResult>::new(FOUND_BRACKET, at_187, at_187, rt::Scalar(0f32), rt::Scalar(0f32), _e89);
                    }
                    if rt::Scalar::into_branch_condition((!end_26.elementwise_lt(rt::Scalar(path_97.exit)))) {
                        let _e97 = cost_28;
                        return <SearchResult>::new(FOUND_MISS, end_26, end_26, rt::Scalar(1f32), rt::Scalar(1f32), _e97);
                    }
                    let next_14 = <rt::Vec2<f32>>::from_scalars(rt::Scalar(-1f32), rt::Scalar(-1f32)).select(<rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32)), path_97.duv.elementwise_gt(<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32))));
                    if rt::Scalar::into_branch_condition(leave_12.x().elementwise_le(leave_12.y())) {
                        let _e118 = tile.x();
                        tile.set_x((_e118 + next_14.x()));
                    } else {
                        let _e123 = tile.y();
                        tile.set_y((_e123 + next_14.y()));
                    }
                    t_47 = end_26;
                }
            }
        }
        let _e127 = t_47;
        let _e128 = t_47;
        let _e129 = cost_28;
        return <SearchResult>::new(FOUND_EXHAUSTED, _e127, _e128, rt::Scalar(1f32), rt::Scalar(1f32), _e129);
    }
    pub(crate) fn search_layers(&self, path_98: Path) -> u32 {
        rt::into(self.v_search_layers(path_98))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_search_layers(&self, path_98: Path) -> rt::Scalar<u32> {
        let slot_1 = SLOT_SEARCH.select(SLOT_SHADOW_SEARCH, rt::Scalar(path_98.ray).elementwise_eq(RAY_SHADOW));
        let _e11 = rt::Scalar(self.surface_settings.maps[rt::Scalar::into_array_index(slot_1)].layers);
        return _e11;
    }
    pub(crate) fn signed_factors(
        &self,
        path_99: Path,
        texel_7: impl rt::Into<rt::Vec2<i32>>,
        layer_13: impl rt::Into<rt::Scalar<i32>>,
        level_55: impl rt::Into<rt::Scalar<i32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_signed_factors(path_99, rt::into(texel_7), rt::into(layer_13), rt::into(level_55)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_signed_factors(
        &self,
        path_99: Path,
        texel_7: rt::Vec2<i32>,
        layer_13: rt::Scalar<i32>,
        level_55: rt::Scalar<i32>,
    ) -> rt::Vec4<f32> {
        let _e4 = self.v_search_texel(path_99, texel_7, layer_13, level_55);
        return ((rt::Scalar(2f32) * _e4) - <rt::Vec4<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32), rt::Scalar(1f32), rt::Scalar(1f32)));
    }
    pub(crate) fn four_terms(
        &self,
        t00_: impl rt::Into<rt::Vec4<f32>>,
        t10_: impl rt::Into<rt::Vec4<f32>>,
        t01_: impl rt::Into<rt::Vec4<f32>>,
        t11_: impl rt::Into<rt::Vec4<f32>>,
    ) -> FourTerms {
        rt::into(self.v_four_terms(rt::into(t00_), rt::into(t10_), rt::into(t01_), rt::into(t11_)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_four_terms(
        &self,
        t00_: rt::Vec4<f32>,
        t10_: rt::Vec4<f32>,
        t01_: rt::Vec4<f32>,
        t11_: rt::Vec4<f32>,
    ) -> FourTerms {
        return <FourTerms>::new(<rt::Vec4<f32>>::from_scalars(t00_.x(), t10_.x(), t01_.x(), t11_.x()), <rt::Vec4<f32>>::from_scalars(t00_.y(), t10_.y(), t01_.y(), t11_.y()), <rt::Vec4<f32>>::from_scalars(t00_.z(), t10_.z(), t01_.z(), t11_.z()), <rt::Vec4<f32>>::from_scalars(t00_.w(), t10_.w(), t01_.w(), t11_.w()));
    }
    pub(crate) fn with_terms(
        &self,
        before_5: impl rt::Into<rt::Vec4<f32>>,
        texels_4: FourTerms,
        view_23: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_with_terms(rt::into(before_5), texels_4, rt::into(view_23)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_with_terms(
        &self,
        before_5: rt::Vec4<f32>,
        texels_4: FourTerms,
        view_23: rt::Vec4<f32>,
    ) -> rt::Vec4<f32> {
        let one_2 = (before_5 + (texels_4.first * view_23.x()));
        let two_1 = (one_2 + (texels_4.second * view_23.y()));
        let three = (two_1 + (texels_4.third * view_23.z()));
        return (three + (texels_4.fourth * view_23.w()));
    }
    pub(crate) fn summed_ways(
        &self,
        path_100: Path,
        around_2: Around,
        pair_2: ViewPair,
        params_115: impl rt::Into<rt::Vec4<f32>>,
        layers_2: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_summed_ways(path_100, around_2, pair_2, rt::into(params_115), rt::into(layers_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_summed_ways(
        &self,
        path_100: Path,
        around_2: Around,
        pair_2: ViewPair,
        params_115: rt::Vec4<f32>,
        layers_2: rt::Scalar<u32>,
    ) -> rt::Vec4<f32> {
        let mut lower_2: rt::Vec4<f32> = <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
        let mut upper_2: rt::Vec4<f32> = <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
        let mut layer_14: rt::Scalar<i32> = rt::Scalar(0i32);

        let _e6 = self.v_height_texels(rt::Scalar(path_100.level));
        let level_69 = rt::Scalar(path_100.level).to_i32();
        let bends_1 = params_115.z().to_i32();
        let lower_view_1 = ((rt::Scalar(pair_2.layer) * bends_1) + rt::Scalar(pair_2.bend).to_i32());
        let _e16 = self.v_factor_place(lower_view_1, _e6);
        let _e18 = self.v_factor_place((lower_view_1 + bends_1), _e6);
        let scale_number = ((params_115.x() * params_115.y()).to_i32() * bends_1);
        'naga_break: loop {
            'naga_continue: {
                let _e38 = layer_14;
                if rt::Scalar::into_branch_condition(_e38.elementwise_lt(layers_2.to_i32())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e41 = layer_14;
                    let _e42 = self.v_term_scales(path_100, scale_number, _e6, _e41);
                    let _e43 = layer_14;
                    let _e44 = self.v_signed_factors(path_100, _e16, _e43, level_69);
                    let a_47 = (_e44 * _e42);
                    let _e46 = layer_14;
                    let _e47 = self.v_signed_factors(path_100, _e18, _e46, level_69);
                    let b_47 = (_e47 * _e42);
                    let _e54 = layer_14;
                    let _e55 = self.v_signed_factors(path_100, <rt::Vec2<i32>>::from_scalars(around_2.columns.x(), around_2.rows.x()), _e54, level_69);
                    let _e61 = layer_14;
                    let _e62 = self.v_signed_factors(path_100, <rt::Vec2<i32>>::from_scalars(around_2.columns.y(), around_2.rows.x()), _e61, level_69);
                    let _e68 = layer_14;
                    let _e69 = self.v_signed_factors(path_100, <rt::Vec2<i32>>::from_scalars(around_2.columns.x(), around_2.rows.y()), _e68, level_69);
                    let _e75 = layer_14;
                    let _e76 = self.v_signed_factors(path_100, <rt::Vec2<i32>>::from_scalars(around_2.columns.y(), around_2.rows.y()), _e75, level_69);
                    let _e77 = self.v_four_terms(_e55, _e62, _e69, _e76);
                    let _e78 = lower_2;
                    let _e79 = self.v_with_terms(_e78, _e77, a_47);
                    lower_2 = _e79;
                    let _e80 = upper_2;
                    let _e81 = self.v_with_terms(_e80, _e77, b_47);
                    upper_2 = _e81;
                    let _e82 = layer_14;
                    layer_14 = (_e82 + rt::Scalar(1i32));
                }
            }
        }
        let _e85 = lower_2;
        let _e86 = upper_2;
        let _e88 = self.v_joined_texels(_e85, _e86, around_2.part);
        return _e88;
    }
    pub(crate) fn texel_reads(
        &self,
        path_101: Path,
        reads: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec3<u32> {
        rt::into(self.v_texel_reads(path_101, rt::into(reads)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_texel_reads(
        &self,
        path_101: Path,
        reads: rt::Scalar<u32>,
    ) -> rt::Vec3<u32> {
        let _e2 = self.v_map_read(path_101, reads);
        return (_e2 + <rt::Vec3<u32>>::from_scalars((reads - rt::Scalar(1u32)), rt::Scalar(0u32), rt::Scalar(0u32)));
    }
    pub(crate) fn search_view_dependent_svd(
        &self,
        path_102: Path,
        params_116: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_view_dependent_svd(path_102, rt::into(params_116)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_view_dependent_svd(
        &self,
        path_102: Path,
        params_116: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut joined_3: JoinedViews;
        let mut k_35: rt::Scalar<u32> = rt::Scalar(0u32);

        let _e3 = self.v_path_axes(path_102, params_116.w());
        if rt::Scalar::into_branch_condition(rt::Scalar(_e3.comes_in).elementwise_eq(rt::Scalar(0u32))) {
            return <SearchResult>::new(FOUND_MISS, rt::Scalar(path_102.exit), rt::Scalar(path_102.exit), rt::Scalar(1f32), rt::Scalar(1f32), STEP);
        }
        let _e14 = self.v_views_around(_e3, params_116);
        let _e16 = self.v_path_uv(path_102, rt::Scalar(_e3.start));
        let _e18 = self.v_height_texels(rt::Scalar(path_102.level));
        let _e19 = self.v_texels_around(_e16, _e18);
        let _e20 = self.v_search_layers(path_102);
        let _e21 = self.v_no_views();
        joined_3 = _e21;
        'naga_break: loop {
            'naga_continue: {
                let _e25 = k_35;
                if rt::Scalar::into_branch_condition(_e25.elementwise_lt(rt::Scalar(_e14.pairs))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e28 = k_35;
                    let _e29 = self.v_view_pair(_e14, _e28);
                    let _e30 = self.v_summed_ways(path_102, _e19, _e29, params_116, _e20);
                    let _e31 = joined_3;
                    let _e32 = k_35;
                    let _e33 = self.v_with_pair(_e31, _e14, _e32, _e30);
                    joined_3 = _e33;
                    let _e34 = k_35;
                    k_35 = (_e34 + rt::Scalar(1u32));
                }
            }
        }
        let _e42 = self.v_texel_reads(path_102, ((rt::Scalar(_e14.pairs) * _e20) * rt::Scalar(8u32)));
        let cost_35 = (STEP + _e42);
        let _e44 = joined_3;
        let _e45 = self.v_joined_way(_e44, _e14);
        let _e46 = self.v_hit_on_way(path_102, _e3, _e45, cost_35);
        return _e46;
    }
    pub(crate) fn search_view_dependent_clusters(
        &self,
        path_103: Path,
        params_117: impl rt::Into<rt::Vec4<f32>>,
    ) -> SearchResult {
        rt::into(self.v_search_view_dependent_clusters(path_103, rt::into(params_117)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_view_dependent_clusters(
        &self,
        path_103: Path,
        params_117: rt::Vec4<f32>,
    ) -> SearchResult {
        let mut joined_4: JoinedViews;
        let mut k_36: rt::Scalar<u32> = rt::Scalar(0u32);

        let _e3 = self.v_path_axes(path_103, params_117.w());
        if rt::Scalar::into_branch_condition(rt::Scalar(_e3.comes_in).elementwise_eq(rt::Scalar(0u32))) {
            return <SearchResult>::new(FOUND_MISS, rt::Scalar(path_103.exit), rt::Scalar(path_103.exit), rt::Scalar(1f32), rt::Scalar(1f32), STEP);
        }
        let _e14 = self.v_views_around(_e3, params_117);
        let _e16 = self.v_path_uv(path_103, rt::Scalar(_e3.start));
        let _e18 = self.v_height_texels(rt::Scalar(path_103.level));
        let _e19 = self.v_texels_around(_e16, _e18);
        let _e20 = self.v_search_layers(path_103);
        let _e21 = self.v_no_views();
        joined_4 = _e21;
        'naga_break: loop {
            'naga_continue: {
                let _e25 = k_36;
                if rt::Scalar::into_branch_condition(_e25.elementwise_lt(rt::Scalar(_e14.pairs))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e28 = k_36;
                    let _e29 = self.v_view_pair(_e14, _e28);
                    let _e30 = self.v_clustered_ways(path_103, _e19, _e29, params_117, _e20);
                    let _e31 = joined_4;
                    let _e32 = k_36;
                    let _e33 = self.v_with_pair(_e31, _e14, _e32, _e30);
                    joined_4 = _e33;
                    let _e34 = k_36;
                    k_36 = (_e34 + rt::Scalar(1u32));
                }
            }
        }
        let _e48 = self.v_texel_reads(path_103, ((rt::Scalar(_e14.pairs) * rt::Scalar(4u32)) * (rt::Scalar(1u32) + ((_e20 - rt::Scalar(1u32)) * rt::Scalar(5u32)))));
        let cost_36 = (STEP + _e48);
        let _e50 = joined_4;
        let _e51 = self.v_joined_way(_e50, _e14);
        let _e52 = self.v_hit_on_way(path_103, _e3, _e51, cost_36);
        return _e52;
    }
    pub(crate) fn search_stage(&self, path_104: Path) -> SearchResult {
        rt::into(self.v_search_stage(path_104))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_search_stage(&self, path_104: Path) -> SearchResult {
        let _e5 = rt::Scalar(self.surface_settings.choices[6usize].number);
        match rt::Scalar::into_inner(_e5) {
            0u32 => {
                let _e10 = self.surface_settings.choices[6usize].params;
                let _e11 = self.v_search_none(path_104, _e10);
                return _e11;
            }
            1u32 => {
                let _e16 = self.surface_settings.choices[6usize].params;
                let _e17 = self.v_search_linear(path_104, _e16);
                return _e17;
            }
            2u32 => {
                let _e22 = self.surface_settings.choices[6usize].params;
                let _e23 = self.v_search_cells(path_104, _e22);
                return _e23;
            }
            3u32 => {
                let _e28 = self.surface_settings.choices[6usize].params;
                let _e29 = self.v_search_frustum(path_104, _e28);
                return _e29;
            }
            4u32 => {
                let _e34 = self.surface_settings.choices[6usize].params;
                let _e35 = self.v_search_cone(path_104, _e34);
                return _e35;
            }
            5u32 => {
                let _e40 = self.surface_settings.choices[6usize].params;
                let _e41 = self.v_search_pyramid(path_104, _e40);
                return _e41;
            }
            6u32 => {
                let _e46 = self.surface_settings.choices[6usize].params;
                let _e47 = self.v_search_pyramid_texels(path_104, _e46);
                return _e47;
            }
            7u32 => {
                let _e52 = self.surface_settings.choices[6usize].params;
                let _e53 = self.v_search_dilation_erosion(path_104, _e52);
                return _e53;
            }
            8u32 => {
                let _e58 = self.surface_settings.choices[6usize].params;
                let _e59 = self.v_search_sphere(path_104, _e58);
                return _e59;
            }
            9u32 => {
                let _e64 = self.surface_settings.choices[6usize].params;
                let _e65 = self.v_search_cone_moved(path_104, _e64);
                return _e65;
            }
            10u32 => {
                let _e70 = self.surface_settings.choices[6usize].params;
                let _e71 = self.v_search_relaxed_cone(path_104, _e70);
                return _e71;
            }
            11u32 => {
                let _e76 = self.surface_settings.choices[6usize].params;
                let _e77 = self.v_search_relaxed_cone_resting(path_104, _e76);
                return _e77;
            }
            12u32 => {
                let _e82 = self.surface_settings.choices[6usize].params;
                let _e83 = self.v_search_voxels(path_104, _e82);
                return _e83;
            }
            13u32 => {
                let _e88 = self.surface_settings.choices[6usize].params;
                let _e89 = self.v_search_generalised(path_104, _e88);
                return _e89;
            }
            14u32 => {
                let _e94 = self.surface_settings.choices[6usize].params;
                let _e95 = self.v_search_view_dependent(path_104, _e94);
                return _e95;
            }
            15u32 => {
                let _e100 = self.surface_settings.choices[6usize].params;
                let _e101 = self.v_search_view_dependent_free(path_104, _e100);
                return _e101;
            }
            16u32 => {
                let _e106 = self.surface_settings.choices[6usize].params;
                let _e107 = self.v_search_translucent(path_104, _e106);
                return _e107;
            }
            17u32 => {
                let _e112 = self.surface_settings.choices[6usize].params;
                let _e113 = self.v_search_shell_map(path_104, _e112);
                return _e113;
            }
            18u32 => {
                let _e118 = self.surface_settings.choices[6usize].params;
                let _e119 = self.v_search_view_dependent_svd(path_104, _e118);
                return _e119;
            }
            _ => {
                let _e124 = self.surface_settings.choices[6usize].params;
                let _e125 = self.v_search_view_dependent_clusters(path_104, _e124);
                return _e125;
            }
        }
    }
    pub(crate) fn trace(&self, path_105: Path) -> Hit {
        rt::into(self.v_trace(path_105))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_trace(&self, path_105: Path) -> Hit {
        let _e1 = self.v_search_stage(path_105);
        let _e2 = self.v_refine_stage(path_105, _e1);
        return _e2;
    }
    pub(crate) fn object_none(
        &self,
        pixel_77: PixelIn,
        at_117: Entered,
        params_118: impl rt::Into<rt::Vec4<f32>>,
    ) -> FirstHit {
        rt::into(self.v_object_none(pixel_77, at_117, rt::into(params_118)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_object_none(
        &self,
        pixel_77: PixelIn,
        at_117: Entered,
        params_118: rt::Vec4<f32>,
    ) -> FirstHit {
        let mut cost_29: rt::Vec3<u32> = NO_COST;
        let mut first_5: FirstHit;
        let mut k_37: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut local_121: rt::Scalar<bool>;

        let _e5 = cost_29;
        let _e6 = self.v_miss(_e5);
        first_5 = <FirstHit>::new(_e6, rt::Scalar(0u32), rt::Scalar(0f32));
        'naga_break: loop {
            'naga_continue: {
                let _e13 = k_37;
                if rt::Scalar::into_branch_condition(_e13.elementwise_lt(rt::Scalar(at_117.segments))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e16 = k_37;
                    let _e17 = self.v_segment_of(pixel_77, at_117, _e16);
                    if rt::Scalar::into_branch_condition(rt::Scalar(_e17.exit).elementwise_gt(rt::Scalar(0f32))) {
                        let _e21 = self.v_trace(_e17);
                        let _e22 = k_37;
                        let _e23 = self.v_hit_on_segment(pixel_77, at_117, _e17, _e21, _e22);
                        let _e24 = cost_29;
                        cost_29 = (_e24 + _e23.hit.cost);
                        if rt::Scalar::into_branch_condition(rt::Scalar(_e23.hit.found).elementwise_eq(rt::Scalar(1u32))) {
                            let _e34 = rt::Scalar(first_5.hit.found);
                            if rt::Scalar::into_branch_condition((!_e34.elementwise_eq(rt::Scalar(0u32)))) {
                                let _e42 = rt::Scalar(first_5.key);
                                local_121 = rt::Scalar(_e23.key).elementwise_gt(_e42);
                            } else {
                                local_121 = rt::Scalar(true);
                            }
                            let _e45 = local_121;
                            if rt::Scalar::into_branch_condition(_e45) {
                                first_5 = _e23;
                            }
                            if rt::Scalar::into_branch_condition(rt::Scalar(pixel_77.shell.order).elementwise_lt(SHELL_FOLDED)) {
                                break 'naga_break;
                            }
                        }
                    }
                    let _e50 = k_37;
                    k_37 = (_e50 + rt::Scalar(1u32));
                }
            }
        }
        let _e55 = cost_29;
        first_5.hit.cost = _e55;
        let _e56 = first_5;
        return _e56;
    }
    pub(crate) fn first_in_all(&self, pixel_78: PixelIn, at_118: Entered) -> FirstHit {
        rt::into(self.v_first_in_all(pixel_78, at_118))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_first_in_all(&self, pixel_78: PixelIn, at_118: Entered) -> FirstHit {
        let mut cost_30: rt::Vec3<u32> = NO_COST;
        let mut first_6: FirstHit;
        let mut reached_1: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut agreed: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut k_38: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut turns: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut local_122: rt::Scalar<bool>;
        let mut local_123: rt::Scalar<bool>;
        let mut local_124: rt::Scalar<bool>;

        let _e4 = cost_30;
        let _e5 = self.v_miss(_e4);
        first_6 = <FirstHit>::new(_e5, rt::Scalar(0u32), rt::Scalar(0f32));
        let most_20 = (rt::Scalar(at_118.segments) * MOST_ROUNDS);
        'naga_break: loop {
            'naga_continue: {
                let _e21 = agreed;
                if rt::Scalar::into_branch_condition(_e21.elementwise_lt(rt::Scalar(at_118.segments))) {
                    let _e26 = turns;
                    local_122 = _e26.elementwise_lt(most_20);
                } else {
                    local_122 = rt::Scalar(false);
                }
                let _e29 = local_122;
                if rt::Scalar::into_branch_condition(_e29) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e30 = k_38;
                    let _e31 = self.v_segment_of(pixel_78, at_118, _e30);
                    let _e32 = reached_1;
                    let passed_m = (_e32 - rt::Scalar(_e31.start)).max(rt::Scalar(0f32));
                    let ahead_4 = (rt::Scalar(1f32) + (rt::Scalar(_e31.bend) * passed_m));
                    let passed = (passed_m / ahead_4);
                    if rt::Scalar::into_branch_condition(ahead_4.elementwise_gt(rt::Scalar(0f32))) {
                        local_123 = passed.elementwise_lt(rt::Scalar(_e31.exit));
                    } else {
                        local_123 = rt::Scalar(false);
                    }
                    let _e49 = local_123;
                    if rt::Scalar::into_branch_condition((!_e49)) {
                        let _e52 = cost_30;
                        let _e53 = self.v_miss(_e52);
                        first_6.hit = _e53;
                        let _e54 = first_6;
                        return _e54;
                    }
                    let _e55 = self.v_beginning_at(_e31, passed);
                    let _e56 = self.v_trace(_e55);
                    let _e57 = cost_30;
                    cost_30 = (_e57 + _e56.cost);
                    if rt::Scalar::into_branch_condition(rt::Scalar(_e56.found).elementwise_eq(rt::Scalar(0u32))) {
                        let _e64 = cost_30;
                        let _e65 = self.v_miss(_e64);
                        first_6.hit = _e65;
                        let _e66 = first_6;
                        return _e66;
                    }
                    let t_56 = (passed + rt::Scalar(_e56.t));
                    let _e70 = self.v_metres_on(_e31, t_56);
                    let at_m = (rt::Scalar(_e31.start) + _e70);
                    let _e74 = rt::Scalar(first_6.hit.found);
                    if rt::Scalar::into_branch_condition((!_e74.elementwise_eq(rt::Scalar(0u32)))) {
                        let _e80 = reached_1;
                        let _e81 = reached_1;
                        local_124 = at_m.elementwise_gt((_e80 + (_e81 * rt::Scalar(0.000002f32))));
                    } else {
                        local_124 = rt::Scalar(true);
                    }
                    let _e87 = local_124;
                    if rt::Scalar::into_branch_condition(_e87) {
                        reached_1 = at_m;
                        agreed = rt::Scalar(0u32);
                        let _e93 = cost_30;
                        let _e95 = k_38;
                        let _e96 = self.v_hit_on_segment(pixel_78, at_118, _e31, <Hit>::new(rt::Scalar(1u32), rt::Scalar(0u32), _e56.uv, rt::Scalar(_e56.height), t_56, _e93), _e95);
                        first_6 = _e96;
                        let _e99 = first_6.hit.cost;
                        cost_30 = _e99;
                    }
                    let _e100 = agreed;
                    agreed = (_e100 + rt::Scalar(1u32));
                    let _e103 = k_38;
                    let _e107 = k_38;
                    k_38 = (_e103 + rt::Scalar(1u32)).select(rt::Scalar(0u32), (_e107 + rt::Scalar(1u32)).elementwise_eq(rt::Scalar(at_118.segments)));
                    let _e113 = turns;
                    turns = (_e113 + rt::Scalar(1u32));
                }
            }
        }
        let _e120 = agreed;
        rt::Scalar(first_6.hit.exhausted) = rt::Scalar(0u32).select(rt::Scalar(1u32), _e120.elementwise_lt(rt::Scalar(at_118.segments)));
        let _e126 = cost_30;
        first_6.hit.cost = _e126;
        let _e127 = first_6;
        return _e127;
    }
    pub(crate) fn object_depth(
        &self,
        pixel_79: PixelIn,
        at_119: Entered,
        params_119: impl rt::Into<rt::Vec4<f32>>,
    ) -> FirstHit {
        rt::into(self.v_object_depth(pixel_79, at_119, rt::into(params_119)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_object_depth(
        &self,
        pixel_79: PixelIn,
        at_119: Entered,
        params_119: rt::Vec4<f32>,
    ) -> FirstHit {
        let _e3 = self.v_first_in_all(pixel_79, at_119);
        return _e3;
    }
    pub(crate) fn object_hull(
        &self,
        pixel_80: PixelIn,
        at_120: Entered,
        params_120: impl rt::Into<rt::Vec4<f32>>,
    ) -> FirstHit {
        rt::into(self.v_object_hull(pixel_80, at_120, rt::into(params_120)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_object_hull(
        &self,
        pixel_80: PixelIn,
        at_120: Entered,
        params_120: rt::Vec4<f32>,
    ) -> FirstHit {
        let _e3 = self.v_first_in_all(pixel_80, at_120);
        return _e3;
    }
    pub(crate) fn look_into_frame(&self, uv_33: impl rt::Into<rt::Vec2<f32>>) -> rt::Vec2<f32> {
        rt::into(self.v_look_into_frame(rt::into(uv_33)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_look_into_frame(&self, uv_33: rt::Vec2<f32>) -> rt::Vec2<f32> {
        let _e2 = self.v_height_size(rt::Scalar(0u32));
        let at_188 = ((uv_33 * _e2) - <rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32)));
        let _e8 = self.v_cell_of(at_188);
        let part_33 = (at_188 - _e8);
        let _e12 = self.v_height_cell(_e8.to_i32(), rt::Scalar(0u32));
        let x_16 = (rt::Scalar(1f32) - part_33.x());
        let y_11 = (rt::Scalar(1f32) - part_33.y());
        let weights_8 = <rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32).select((x_16 * y_11), _e12.x().elementwise_gt(rt::Scalar(0.00001f32))), rt::Scalar(0f32).select((part_33.x() * y_11), _e12.y().elementwise_gt(rt::Scalar(0.00001f32))), rt::Scalar(0f32).select((x_16 * part_33.y()), _e12.z().elementwise_gt(rt::Scalar(0.00001f32))), rt::Scalar(0f32).select((part_33.x() * part_33.y()), _e12.w().elementwise_gt(rt::Scalar(0.00001f32))));
        let cover_2 = ((weights_8.x() + weights_8.y()) + (weights_8.z() + weights_8.w()));
        if rt::Scalar::into_branch_condition(cover_2.elementwise_gt(rt::Scalar(0f32))) {
            return <rt::Vec2<f32>>::from_scalars(cover_2, (weights_8.dot(_e12) / cover_2));
        }
        return <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32));
    }
    pub(crate) fn look_along(
        &self,
        path_106: Path,
        image_11: Image,
        steps_1: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec2<f32> {
        rt::into(self.v_look_along(path_106, image_11, rt::into(steps_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_look_along(
        &self,
        path_106: Path,
        image_11: Image,
        steps_1: rt::Scalar<u32>,
    ) -> rt::Vec2<f32> {
        let mut height_12: rt::Scalar<f32> = rt::Scalar(0.5f32);
        let mut cover: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut step_5: rt::Scalar<u32> = rt::Scalar(0u32);

        let _e7 = self.v_height_size(rt::Scalar(0u32));
        let beyond_9 = (<rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32)) / _e7);
        let low_12 = (image_11.corner - beyond_9);
        let high_7 = ((image_11.corner + image_11.extent) + beyond_9);
        'naga_break: loop {
            'naga_continue: {
                let _e21 = step_5;
                if rt::Scalar::into_branch_condition(_e21.elementwise_le(steps_1)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e23 = height_12;
                    let _e30 = self.v_path_uv(path_106, ((_e23 - path_106.h.x()) / path_106.h.y()));
                    let _e32 = self.v_look_into_frame(_e30.clamp(low_12, high_7));
                    cover = _e32.x();
                    let _e34 = height_12;
                    let _e36 = cover;
                    height_12 = _e34.select(_e32.y(), _e36.elementwise_gt(rt::Scalar(0f32)));
                    let _e40 = step_5;
                    step_5 = (_e40 + rt::Scalar(1u32));
                }
            }
        }
        let _e43 = cover;
        let _e44 = height_12;
        return <rt::Vec2<f32>>::from_scalars(_e43, _e44);
    }
    pub(crate) fn object_blend(
        &self,
        pixel_81: PixelIn,
        at_121: Entered,
        params_121: impl rt::Into<rt::Vec4<f32>>,
    ) -> FirstHit {
        rt::into(self.v_object_blend(pixel_81, at_121, rt::into(params_121)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_object_blend(
        &self,
        pixel_81: PixelIn,
        at_121: Entered,
        params_121: rt::Vec4<f32>,
    ) -> FirstHit {
        let mut cost_31: rt::Vec3<u32> = NO_COST;
        let mut cover_1: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut along_18: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut heaviest: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut most_2: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut k_39: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut first_7: FirstHit;
        let mut local_125: rt::Scalar<bool>;

        let toward_11 = (-pixel_81.direction.normalize());
        let _e6 = self.v_frames_around(toward_11);
        'naga_break: loop {
            'naga_continue: {
                let _e19 = k_39;
                if rt::Scalar::into_branch_condition(_e19.elementwise_lt(FRAMES)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e22 = k_39;
                    let _e23 = self.v_frame_number(_e6, _e22);
                    let _e24 = self.v_image_of_object(_e23);
                    let _e25 = k_39;
                    let _e26 = self.v_frame_weight(_e6, _e25);
                    if rt::Scalar::into_branch_condition(_e24.toward.dot(toward_11).elementwise_ge(rt::Scalar(0.05f32))) {
                        let _e31 = k_39;
                        let _e32 = self.v_segment_of(pixel_81, at_121, _e31);
                        let _e35 = self.v_look_along(_e32, _e24, params_121.w().to_u32());
                        let seen_10 = (_e26 * _e35.x());
                        let _e38 = cost_31;
                        cost_31 = (_e38 + (LOOK * (params_121.w().to_u32() + rt::Scalar(1u32))));
                        let _e46 = cover_1;
                        cover_1 = (_e46 + seen_10);
                        let _e48 = along_18;
                        along_18 = (_e48 + (seen_10 * (rt::Scalar(_e32.start) + ((_e35.y() - _e32.h.x()) / _e32.h.y()))));
                        let _e60 = most_2;
                        if rt::Scalar::into_branch_condition(seen_10.elementwise_gt(_e60)) {
                            most_2 = seen_10;
                            let _e62 = k_39;
                            heaviest = _e62;
                        }
                    }
                    let _e63 = k_39;
                    k_39 = (_e63 + rt::Scalar(1u32));
                }
            }
        }
        let _e66 = cost_31;
        let _e67 = self.v_miss(_e66);
        first_7 = <FirstHit>::new(_e67, rt::Scalar(0u32), rt::Scalar(0f32));
        let _e72 = cover_1;
        if rt::Scalar::into_branch_condition((!_e72.elementwise_lt(rt::Scalar(0.5f32)))) {
            let _e78 = along_18;
            local_125 = _e78.elementwise_lt(rt::Scalar(0f32));
        } else {
            local_125 = rt::Scalar(true);
        }
        let _e82 = local_125;
        if rt::Scalar::into_branch_condition(_e82) {
            let _e83 = first_7;
            return _e83;
        }
        let _e84 = heaviest;
        let _e85 = self.v_segment_of(pixel_81, at_121, _e84);
        let _e86 = along_18;
        let _e87 = cover_1;
        let t_57 = ((_e86 / _e87) - rt::Scalar(_e85.start));
        let _e93 = self.v_path_uv(_e85, t_57);
        let _e94 = self.v_path_height(_e85, t_57);
        let _e95 = cost_31;
        let hit_86 = <Hit>::new(rt::Scalar(1u32), rt::Scalar(0u32), _e93, _e94, t_57, _e95);
        let _e97 = heaviest;
        let _e98 = self.v_hit_on_segment(pixel_81, at_121, _e85, hit_86, _e97);
        return _e98;
    }
    pub(crate) fn object_stage(&self, pixel_82: PixelIn, at_122: Entered) -> FirstHit {
        rt::into(self.v_object_stage(pixel_82, at_122))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_object_stage(&self, pixel_82: PixelIn, at_122: Entered) -> FirstHit {
        let _e6 = rt::Scalar(self.surface_settings.choices[3usize].number);
        match rt::Scalar::into_inner(_e6) {
            0u32 => {
                let _e11 = self.surface_settings.choices[3usize].params;
                let _e12 = self.v_object_none(pixel_82, at_122, _e11);
                return _e12;
            }
            1u32 => {
                let _e17 = self.surface_settings.choices[3usize].params;
                let _e18 = self.v_object_depth(pixel_82, at_122, _e17);
                return _e18;
            }
            2u32 => {
                let _e23 = self.surface_settings.choices[3usize].params;
                let _e24 = self.v_object_hull(pixel_82, at_122, _e23);
                return _e24;
            }
            _ => {
                let _e29 = self.surface_settings.choices[3usize].params;
                let _e30 = self.v_object_blend(pixel_82, at_122, _e29);
                return _e30;
            }
        }
    }
    pub(crate) fn first_hit(&self, pixel_83: PixelIn, at_123: Entered) -> FirstHit {
        rt::into(self.v_first_hit(pixel_83, at_123))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_first_hit(&self, pixel_83: PixelIn, at_123: Entered) -> FirstHit {
        let _e2 = self.v_object_stage(pixel_83, at_123);
        return _e2;
    }
    pub(crate) fn quotient_up(
        &self,
        dividend: impl rt::Into<rt::Scalar<i32>>,
        by_1: impl rt::Into<rt::Scalar<i32>>,
    ) -> i32 {
        rt::into(self.v_quotient_up(rt::into(dividend), rt::into(by_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_quotient_up(
        &self,
        dividend: rt::Scalar<i32>,
        by_1: rt::Scalar<i32>,
    ) -> rt::Scalar<i32> {
        return (((dividend + by_1) - rt::Scalar(1i32)) / by_1);
    }
    pub(crate) fn first_of_top(
        &self,
        sweep_5: Sweep,
        column_2: impl rt::Into<rt::Scalar<i32>>,
    ) -> i32 {
        rt::into(self.v_first_of_top(sweep_5, rt::into(column_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_first_of_top(
        &self,
        sweep_5: Sweep,
        column_2: rt::Scalar<i32>,
    ) -> rt::Scalar<i32> {
        let n_20 = sweep_5.parts.x();
        let m_6 = sweep_5.parts.y();
        let doubled = ((rt::Scalar(2i32) * column_2) - rt::Scalar(1i32));
        if rt::Scalar::into_branch_condition(column_2.elementwise_le(rt::Scalar(0i32))) {
            return rt::Scalar(0i32);
        }
        if rt::Scalar::into_branch_condition(column_2.elementwise_gt(sweep_5.end.x())) {
            return ((n_20 + m_6) + rt::Scalar(1i32));
        }
        if rt::Scalar::into_branch_condition(doubled.elementwise_le((rt::Scalar(2i32) * sweep_5.apex.x()))) {
            let _e29 = self.v_quotient_up((n_20 * doubled), (rt::Scalar(2i32) * sweep_5.apex.x()));
            return _e29;
        }
        let _e43 = self.v_quotient_up((m_6 * (doubled - (rt::Scalar(2i32) * sweep_5.apex.x()))), (rt::Scalar(2i32) * (sweep_5.end.x() - sweep_5.apex.x())));
        return (n_20 + _e43);
    }
    pub(crate) fn shadow_search_stage(&self, path_107: Path) -> SearchResult {
        rt::into(self.v_shadow_search_stage(path_107))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_shadow_search_stage(&self, path_107: Path) -> SearchResult {
        let _e5 = rt::Scalar(self.surface_settings.choices[10usize].number);
        match rt::Scalar::into_inner(_e5) {
            0u32 => {
                let _e10 = self.surface_settings.choices[10usize].params;
                let _e11 = self.v_search_none(path_107, _e10);
                return _e11;
            }
            1u32 => {
                let _e16 = self.surface_settings.choices[10usize].params;
                let _e17 = self.v_search_linear(path_107, _e16);
                return _e17;
            }
            2u32 => {
                let _e22 = self.surface_settings.choices[10usize].params;
                let _e23 = self.v_search_cells(path_107, _e22);
                return _e23;
            }
            3u32 => {
                let _e28 = self.surface_settings.choices[10usize].params;
                let _e29 = self.v_search_frustum(path_107, _e28);
                return _e29;
            }
            4u32 => {
                let _e34 = self.surface_settings.choices[10usize].params;
                let _e35 = self.v_search_cone(path_107, _e34);
                return _e35;
            }
            5u32 => {
                let _e40 = self.surface_settings.choices[10usize].params;
                let _e41 = self.v_search_pyramid(path_107, _e40);
                return _e41;
            }
            6u32 => {
                let _e46 = self.surface_settings.choices[10usize].params;
                let _e47 = self.v_search_pyramid_texels(path_107, _e46);
                return _e47;
            }
            7u32 => {
                let _e52 = self.surface_settings.choices[10usize].params;
                let _e53 = self.v_search_dilation_erosion(path_107, _e52);
                return _e53;
            }
            8u32 => {
                let _e58 = self.surface_settings.choices[10usize].params;
                let _e59 = self.v_search_sphere(path_107, _e58);
                return _e59;
            }
            9u32 => {
                let _e64 = self.surface_settings.choices[10usize].params;
                let _e65 = self.v_search_cone_moved(path_107, _e64);
                return _e65;
            }
            10u32 => {
                let _e70 = self.surface_settings.choices[10usize].params;
                let _e71 = self.v_search_relaxed_cone(path_107, _e70);
                return _e71;
            }
            11u32 => {
                let _e76 = self.surface_settings.choices[10usize].params;
                let _e77 = self.v_search_relaxed_cone_resting(path_107, _e76);
                return _e77;
            }
            12u32 => {
                let _e82 = self.surface_settings.choices[10usize].params;
                let _e83 = self.v_search_voxels(path_107, _e82);
                return _e83;
            }
            13u32 => {
                let _e88 = self.surface_settings.choices[10usize].params;
                let _e89 = self.v_search_generalised(path_107, _e88);
                return _e89;
            }
            14u32 => {
                let _e94 = self.surface_settings.choices[10usize].params;
                let _e95 = self.v_search_view_dependent(path_107, _e94);
                return _e95;
            }
            15u32 => {
                let _e100 = self.surface_settings.choices[10usize].params;
                let _e101 = self.v_search_view_dependent_free(path_107, _e100);
                return _e101;
            }
            16u32 => {
                let _e106 = self.surface_settings.choices[10usize].params;
                let _e107 = self.v_search_translucent(path_107, _e106);
                return _e107;
            }
            17u32 => {
                let _e112 = self.surface_settings.choices[10usize].params;
                let _e113 = self.v_search_shell_map(path_107, _e112);
                return _e113;
            }
            18u32 => {
                let _e118 = self.surface_settings.choices[10usize].params;
                let _e119 = self.v_search_view_dependent_svd(path_107, _e118);
                return _e119;
            }
            _ => {
                let _e124 = self.surface_settings.choices[10usize].params;
                let _e125 = self.v_search_view_dependent_clusters(path_107, _e124);
                return _e125;
            }
        }
    }
    pub(crate) fn free_way(&self, at_124: Entered, hit_42: Hit, light_11: Toward) -> f32 {
        rt::into(self.v_free_way(at_124, hit_42, light_11))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_free_way(&self, at_124: Entered, hit_42: Hit, light_11: Toward) -> rt::Scalar<f32> {
        let _e3 = self.v_field_light_ray_stage(at_124, hit_42, light_11);
        if rt::Scalar::into_branch_condition(rt::Scalar(_e3.state).elementwise_eq(LIGHT_RAY_LIT)) {
            return rt::Scalar(1f32);
        }
        if rt::Scalar::into_branch_condition(rt::Scalar(_e3.state).elementwise_eq(LIGHT_RAY_DARK)) {
            return rt::Scalar(0f32);
        }
        let _e13 = self.v_shadow_search_stage(_e3.path);
        return rt::Scalar(0f32).select(rt::Scalar(1f32), rt::Scalar(_e13.status).elementwise_eq(FOUND_MISS));
    }
    pub(crate) fn way_into_heights(
        &self,
        height_13: impl rt::Into<rt::Scalar<f32>>,
        slope_5: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_way_into_heights(rt::into(height_13), rt::into(slope_5)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_way_into_heights(
        &self,
        height_13: rt::Scalar<f32>,
        slope_5: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let mut local_126: rt::Scalar<bool>;

        let beyond_10 = (height_13 - height_13.clamp(rt::Scalar(0f32), rt::Scalar(1f32)));
        if rt::Scalar::into_branch_condition(beyond_10.abs().elementwise_gt(rt::Scalar(0f32))) {
            local_126 = slope_5.abs().elementwise_gt(rt::Scalar(0f32));
        } else {
            local_126 = rt::Scalar(false);
        }
        let _e17 = local_126;
        return rt::Scalar(0f32).select((beyond_10 / slope_5).abs(), _e17);
    }
    pub(crate) fn rest_of_segment(
        &self,
        path_108: Path,
        until_m: impl rt::Into<rt::Scalar<f32>>,
        reach_m: impl rt::Into<rt::Scalar<f32>>,
    ) -> Path {
        rt::into(self.v_rest_of_segment(path_108, rt::into(until_m), rt::into(reach_m)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_rest_of_segment(
        &self,
        path_108: Path,
        until_m: rt::Scalar<f32>,
        reach_m: rt::Scalar<f32>,
    ) -> Path {
        let mut rest_2: Path;

        let _e7 = self.v_way_into_heights(path_108.h.x(), path_108.h.y());
        let _e9 = self.v_path_height(path_108, rt::Scalar(path_108.exit));
        let _e11 = self.v_path_slope(path_108, rt::Scalar(path_108.exit));
        let _e12 = self.v_way_into_heights(_e9, _e11);
        let begin_12 = _e7.max((until_m - rt::Scalar(path_108.start)));
        rest_2 = path_108;
        if rt::Scalar::into_branch_condition(begin_12.elementwise_gt(rt::Scalar(0f32))) {
            let _e19 = self.v_beginning_at(path_108, begin_12);
            rest_2 = _e19;
        }
        let _e27 = rt::Scalar(rest_2.start);
        rt::Scalar(rest_2.exit) = ((rt::Scalar(path_108.exit) - _e12) - begin_12.max(rt::Scalar(0f32))).min((reach_m - _e27));
        let _e30 = rest_2;
        return _e30;
    }
    pub(crate) fn light_around(&self, at_125: Entered, path_109: Path) -> rt::Vec3<f32> {
        rt::into(self.v_light_around(at_125, path_109))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_light_around(&self, at_125: Entered, path_109: Path) -> rt::Vec3<f32> {
        let mut light_12: rt::Vec3<f32>;
        let mut k_40: rt::Scalar<u32> = rt::Scalar(0u32);

        let hit_87 = <Hit>::new(rt::Scalar(1u32), rt::Scalar(0u32), path_109.uv, path_109.h.x(), rt::Scalar(0f32), NO_COST);
        let zero_2 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
        let white_1 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32), rt::Scalar(1f32));
        let material_14 = <Material>::new(white_1, zero_2, zero_2, white_1, zero_2, rt::Scalar(1f32), rt::Scalar(1f32), rt::Scalar(1f32), rt::Scalar(1f32), rt::Scalar(1f32), rt::Scalar(0.5f32), rt::Scalar(0f32));
        light_12 = zero_2;
        'naga_break: loop {
            'naga_continue: {
                let _e29 = k_40;
                if rt::Scalar::into_branch_condition(_e29.elementwise_lt(rt::Scalar(6u32))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e32 = k_40;
                    let along_42 = rt::Scalar(-1f32).select(rt::Scalar(1f32), (_e32 & rt::Scalar(1u32)).elementwise_eq(rt::Scalar(0u32)));
                    let _e40 = k_40;
                    let axis_8 = (_e40 >> rt::Scalar(1u32));
                    let normal_36 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32).select(along_42, axis_8.elementwise_eq(rt::Scalar(0u32))), rt::Scalar(0f32).select(along_42, axis_8.elementwise_eq(rt::Scalar(1u32))), rt::Scalar(0f32).select(along_42, axis_8.elementwise_eq(rt::Scalar(2u32))));
                    let _e56 = light_12;
                    let _e57 = self.v_ambient_stage(at_125, hit_87, normal_36, normal_36, material_14);
                    light_12 = (_e56 + _e57);
                    let _e59 = k_40;
                    k_40 = (_e59 + rt::Scalar(1u32));
                }
            }
        }
        let _e62 = light_12;
        return (_e62 * rt::Scalar(0.16666667f32));
    }
    pub(crate) fn goes_on(&self, seen_2: Gathered) -> bool {
        rt::into(self.v_goes_on(seen_2))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_goes_on(&self, seen_2: Gathered) -> rt::Scalar<bool> {
        return rt::Scalar(seen_2.transmittance).elementwise_gt(rt::Scalar(0.000061035156f32));
    }
    pub(crate) fn placed_over(&self, at_126: Entered, hit_43: Hit) -> Entered {
        rt::into(self.v_placed_over(at_126, hit_43))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_placed_over(&self, at_126: Entered, hit_43: Hit) -> Entered {
        let mut placed: Entered;

        let uv_46 = hit_43.uv;
        let aside_10 = (uv_46 - at_126.uv);
        let _e7 = self.v_field_height_stage(uv_46, rt::Scalar(hit_43.height), rt::Scalar(at_126.level));
        let _e10 = rt::Scalar(self.surface_settings.bias_m);
        let _e13 = rt::Scalar(self.surface_settings.scale_m);
        let height_27 = (_e10 + (_e13 * _e7));
        placed = at_126;
        placed.point = (((at_126.point + (at_126.tangent * aside_10.x())) + (at_126.bitangent * aside_10.y())) + (at_126.normal * height_27));
        placed.uv = uv_46;
        let _e31 = placed;
        return _e31;
    }
    pub(crate) fn surface_plane_place(
        &self,
        pixel_84: PixelIn,
        at_127: Entered,
        path_110: Path,
        hit_44: Hit,
        params_122: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_plane_place(pixel_84, at_127, path_110, hit_44, rt::into(params_122)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_plane_place(
        &self,
        pixel_84: PixelIn,
        at_127: Entered,
        path_110: Path,
        hit_44: Hit,
        params_122: rt::Vec4<f32>,
    ) -> Entered {
        let _e5 = self.v_placed_over(at_127, hit_44);
        return _e5;
    }
    pub(crate) fn placed_at(
        &self,
        pixel_85: PixelIn,
        at_128: Entered,
        weights_5: impl rt::Into<rt::Vec3<f32>>,
        point_19: impl rt::Into<rt::Vec3<f32>>,
        uv_34: impl rt::Into<rt::Vec2<f32>>,
    ) -> Entered {
        rt::into(self.v_placed_at(pixel_85, at_128, rt::into(weights_5), rt::into(point_19), rt::into(uv_34)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_placed_at(
        &self,
        pixel_85: PixelIn,
        at_128: Entered,
        weights_5: rt::Vec3<f32>,
        point_19: rt::Vec3<f32>,
        uv_34: rt::Vec2<f32>,
    ) -> Entered {
        let mut placed_1: Entered;

        let _e6 = self.v_frame_at(pixel_85, weights_5, point_19, uv_34, at_128.facing);
        placed_1 = _e6;
        rt::Scalar(placed_1.level) = rt::Scalar(at_128.level);
        rt::Scalar(placed_1.footprint) = rt::Scalar(at_128.footprint);
        rt::Scalar(placed_1.fade) = rt::Scalar(at_128.fade);
        let _e14 = placed_1;
        return _e14;
    }
    pub(crate) fn surface_prism_place(
        &self,
        pixel_86: PixelIn,
        at_129: Entered,
        path_111: Path,
        hit_45: Hit,
        params_123: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_prism_place(pixel_86, at_129, path_111, hit_45, rt::into(params_123)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_prism_place(
        &self,
        pixel_86: PixelIn,
        at_129: Entered,
        path_111: Path,
        hit_45: Hit,
        params_123: rt::Vec4<f32>,
    ) -> Entered {
        let along_43 = pixel_86.direction.normalize();
        let _e7 = self.v_middle_of(pixel_86, along_43);
        let _e8 = self.v_prism_of(pixel_86, along_43, _e7, params_123);
        let s_3 = ((rt::Scalar(path_111.start) + rt::Scalar(hit_45.t)) - _e7);
        let _e15 = self.v_point_of_way(pixel_86, _e8, (along_43 * s_3), rt::Scalar(hit_45.height));
        let weights_9 = _e15.weights;
        let _e24 = self.v_placed_at(pixel_86, at_129, weights_9, (pixel_86.origin + (along_43 * (rt::Scalar(path_111.start) + rt::Scalar(hit_45.t)))), hit_45.uv);
        return _e24;
    }
    pub(crate) fn quadric_frame(
        &self,
        at_130: Entered,
        aside: impl rt::Into<rt::Vec2<f32>>,
    ) -> Entered {
        rt::into(self.v_quadric_frame(at_130, rt::into(aside)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_quadric_frame(
        &self,
        at_130: Entered,
        aside: rt::Vec2<f32>,
    ) -> Entered {
        let mut placed_2: Entered;
        let mut local_127: rt::Scalar<bool>;

        placed_2 = at_130;
        let _e5 = self.v_quadric_slope(at_130.of_surface.xyz(), aside);
        if rt::Scalar::into_branch_condition(_e5.x().elementwise_eq(rt::Scalar(0f32))) {
            local_127 = _e5.y().elementwise_eq(rt::Scalar(0f32));
        } else {
            local_127 = rt::Scalar(false);
        }
        let _e15 = local_127;
        if rt::Scalar::into_branch_condition(_e15) {
            let _e16 = placed_2;
            return _e16;
        }
        let m_7 = at_130.metric;
        let area_7 = ((m_7.x() * m_7.z()) - (m_7.y() * m_7.y()));
        let along_t = (((_e5.x() * m_7.z()) - (_e5.y() * m_7.y())) / area_7);
        let along_b = (((_e5.y() * m_7.x()) - (_e5.x() * m_7.y())) / area_7);
        placed_2.tangent = (at_130.tangent + (at_130.normal * _e5.x()));
        placed_2.bitangent = (at_130.bitangent + (at_130.normal * _e5.y()));
        placed_2.normal = ((at_130.normal - (at_130.tangent * along_t)) - (at_130.bitangent * along_b)).normalize();
        let _e63 = placed_2.tangent;
        let _e65 = placed_2.tangent;
        let tt_3 = _e63.dot(_e65);
        let _e68 = placed_2.tangent;
        let _e70 = placed_2.bitangent;
        let tb_3 = _e68.dot(_e70);
        let _e73 = placed_2.bitangent;
        let _e75 = placed_2.bitangent;
        let bb_3 = _e73.dot(_e75);
        placed_2.metric = <rt::Vec4<f32>>::from_scalars(tt_3, tb_3, bb_3, m_7.w());
        let _e80 = placed_2;
        return _e80;
    }
    pub(crate) fn surface_quadric_perpendicular_place(
        &self,
        pixel_87: PixelIn,
        at_131: Entered,
        path_112: Path,
        hit_46: Hit,
        params_124: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_quadric_perpendicular_place(pixel_87, at_131, path_112, hit_46, rt::into(params_124)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_quadric_perpendicular_place(
        &self,
        pixel_87: PixelIn,
        at_131: Entered,
        path_112: Path,
        hit_46: Hit,
        params_124: rt::Vec4<f32>,
    ) -> Entered {
        let mut placed_3: Entered;

        let _e8 = self.v_quadric_frame(at_131, (hit_46.uv - at_131.uv));
        placed_3 = _e8;
        placed_3.point = (pixel_87.origin + (pixel_87.direction.normalize() * (rt::Scalar(path_112.start) + rt::Scalar(hit_46.t))));
        placed_3.uv = hit_46.uv;
        let _e21 = placed_3;
        return _e21;
    }
    pub(crate) fn surface_quadric_vertical_place(
        &self,
        pixel_88: PixelIn,
        at_132: Entered,
        path_113: Path,
        hit_47: Hit,
        params_125: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_quadric_vertical_place(pixel_88, at_132, path_113, hit_47, rt::into(params_125)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_quadric_vertical_place(
        &self,
        pixel_88: PixelIn,
        at_132: Entered,
        path_113: Path,
        hit_47: Hit,
        params_125: rt::Vec4<f32>,
    ) -> Entered {
        let mut placed_4: Entered;

        let aside_11 = (hit_47.uv - at_132.uv);
        let _e11 = self.v_field_height_stage(hit_47.uv, rt::Scalar(hit_47.height), rt::Scalar(at_132.level));
        let _e14 = rt::Scalar(self.surface_settings.bias_m);
        let _e17 = rt::Scalar(self.surface_settings.scale_m);
        let height_28 = (_e14 + (_e17 * _e11));
        let _e20 = self.v_base_height();
        let _e24 = self.v_traced_scale_m();
        let _e28 = self.v_quadric_at(at_132.of_surface.xyz(), aside_11);
        let lifted_2 = (((_e20 - at_132.of_surface.w()) * _e24) + _e28);
        let _e30 = self.v_quadric_frame(at_132, aside_11);
        placed_4 = _e30;
        placed_4.point = (((at_132.point + (at_132.tangent * aside_11.x())) + (at_132.bitangent * aside_11.y())) + (at_132.normal * (height_28 + lifted_2)));
        placed_4.uv = hit_47.uv;
        let _e48 = placed_4;
        return _e48;
    }
    pub(crate) fn surface_tetrahedra_place(
        &self,
        pixel_89: PixelIn,
        at_133: Entered,
        path_114: Path,
        hit_48: Hit,
        params_126: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_tetrahedra_place(pixel_89, at_133, path_114, hit_48, rt::into(params_126)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_tetrahedra_place(
        &self,
        pixel_89: PixelIn,
        at_133: Entered,
        path_114: Path,
        hit_48: Hit,
        params_126: rt::Vec4<f32>,
    ) -> Entered {
        let mut nearest_2: Tetrahedron;
        let mut beside_1: rt::Scalar<f32>;
        let mut number_18: rt::Scalar<u32> = rt::Scalar(1u32);

        let along_44 = pixel_89.direction.normalize();
        let _e7 = self.v_middle_of(pixel_89, along_44);
        let t_58 = ((rt::Scalar(path_114.start) + rt::Scalar(hit_48.t)) - _e7);
        let _e13 = self.v_tetrahedron(pixel_89, along_44, _e7, rt::Scalar(0u32));
        nearest_2 = _e13;
        let _e17 = nearest_2.inside.x();
        let _e21 = nearest_2.inside.y();
        beside_1 = (_e17 - t_58).max((t_58 - _e21));
        'naga_break: loop {
            'naga_continue: {
                let _e27 = number_18;
                if rt::Scalar::into_branch_condition(_e27.elementwise_lt(rt::Scalar(3u32))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e30 = number_18;
                    let _e31 = self.v_tetrahedron(pixel_89, along_44, _e7, _e30);
                    let aside_12 = (_e31.inside.x() - t_58).max((t_58 - _e31.inside.y()));
                    let _e39 = beside_1;
                    if rt::Scalar::into_branch_condition(aside_12.elementwise_lt(_e39)) {
                        nearest_2 = _e31;
                        beside_1 = aside_12;
                    }
                    let _e41 = number_18;
                    number_18 = (_e41 + rt::Scalar(1u32));
                }
            }
        }
        let _e45 = nearest_2.weights;
        let _e47 = nearest_2.change;
        let weights_10 = (_e45 + (_e47 * t_58));
        let point_33 = (pixel_89.origin + (along_44 * (rt::Scalar(path_114.start) + rt::Scalar(hit_48.t))));
        let _e58 = self.v_placed_at(pixel_89, at_133, weights_10.xyz(), point_33, hit_48.uv);
        return _e58;
    }
    pub(crate) fn surface_facets_place(
        &self,
        pixel_90: PixelIn,
        at_134: Entered,
        path_115: Path,
        hit_49: Hit,
        params_127: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_facets_place(pixel_90, at_134, path_115, hit_49, rt::into(params_127)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_facets_place(
        &self,
        pixel_90: PixelIn,
        at_134: Entered,
        path_115: Path,
        hit_49: Hit,
        params_127: rt::Vec4<f32>,
    ) -> Entered {
        return at_134;
    }
    pub(crate) fn surface_slices_place(
        &self,
        pixel_91: PixelIn,
        at_135: Entered,
        path_116: Path,
        hit_50: Hit,
        params_128: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_slices_place(pixel_91, at_135, path_116, hit_50, rt::into(params_128)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_slices_place(
        &self,
        pixel_91: PixelIn,
        at_135: Entered,
        path_116: Path,
        hit_50: Hit,
        params_128: rt::Vec4<f32>,
    ) -> Entered {
        let _e5 = self.v_placed_over(at_135, hit_50);
        return _e5;
    }
    pub(crate) fn rise_of_mask(&self, uv_35: impl rt::Into<rt::Vec2<f32>>) -> rt::Vec2<f32> {
        rt::into(self.v_rise_of_mask(rt::into(uv_35)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_rise_of_mask(&self, uv_35: rt::Vec2<f32>) -> rt::Vec2<f32> {
        let _e2 = self.v_height_size(rt::Scalar(0u32));
        let at_189 = ((uv_35 * _e2) - <rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32)));
        let _e8 = self.v_cell_of(at_189);
        let _e11 = self.v_object_cell_stage(_e8.to_i32(), rt::Scalar(0u32));
        let part_34 = (at_189 - _e8);
        return <rt::Vec2<f32>>::from_scalars((((_e11.y() - _e11.x()) * (rt::Scalar(1f32) - part_34.y())) + ((_e11.w() - _e11.z()) * part_34.y())), (((_e11.z() - _e11.x()) * (rt::Scalar(1f32) - part_34.x())) + ((_e11.w() - _e11.y()) * part_34.x())));
    }
    pub(crate) fn normal_of_mask(
        &self,
        image_12: Image,
        uv_36: impl rt::Into<rt::Vec2<f32>>,
        within: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_normal_of_mask(image_12, rt::into(uv_36), rt::into(within)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_normal_of_mask(
        &self,
        image_12: Image,
        uv_36: rt::Vec2<f32>,
        within: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let _e3 = self.v_rise_of_mask(uv_36);
        let place_47 = ((uv_36 - image_12.corner) / image_12.extent);
        let along_u_5 = (image_12.u.xyz() - (image_12.depth.xyz() * place_47.x())).normalize();
        let along_v_5 = (image_12.v.xyz() - (image_12.depth.xyz() * place_47.y())).normalize();
        let outward = ((<rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32)) - (along_u_5 * _e3.x())) - (along_v_5 * _e3.y()));
        let square_6 = outward.dot(outward);
        if rt::Scalar::into_branch_condition(square_6.elementwise_gt(rt::Scalar(0f32))) {
            return (outward / rt::Vec3::splat_from_scalar(square_6.sqrt()));
        }
        return within;
    }
    pub(crate) fn placed_in_image(&self, pixel_92: PixelIn, at_136: Entered, path_117: Path, hit_51: Hit) -> Entered {
        rt::into(self.v_placed_in_image(pixel_92, at_136, path_117, hit_51))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_placed_in_image(&self, pixel_92: PixelIn, at_136: Entered, path_117: Path, hit_51: Hit) -> Entered {
        let mut placed_5: Entered;

        let _e6 = self.v_image_of_object(rt::Scalar(path_117.base).to_u32());
        placed_5 = at_136;
        placed_5.point = (pixel_92.origin + (pixel_92.direction.normalize() * (rt::Scalar(path_117.start) + rt::Scalar(hit_51.t))));
        placed_5.uv = hit_51.uv;
        let _e20 = placed_5.point;
        let _e21 = self.v_depth_in_image(_e6, _e20);
        let _e23 = placed_5.point;
        let _e25 = self.v_stretch_in_image(_e6, _e23, rt::Scalar(hit_51.height));
        let _e27 = self.v_tangent_of_image(_e6);
        placed_5.tangent = ((_e27 * _e21) / rt::Vec3::splat_from_scalar(_e25));
        let _e32 = self.v_bitangent_of_image(_e6);
        placed_5.bitangent = ((_e32 * _e21) / rt::Vec3::splat_from_scalar(_e25));
        let _e38 = placed_5.point;
        let _e39 = self.v_toward_image(_e6, _e38);
        placed_5.normal = _e39;
        let _e42 = rt::Scalar(self.surface_settings.has_normal);
        if rt::Scalar::into_branch_condition(_e42.elementwise_eq(rt::Scalar(1u32))) {
            placed_5.normal = _e6.toward;
        }
        placed_5.metric = path_117.metric;
        placed_5.facing = _e6.toward;
        let _e53 = rt::Scalar(self.surface_settings.cells);
        if rt::Scalar::into_branch_condition(_e53.elementwise_eq(CELLS_MASK)) {
            let _e59 = self.v_normal_of_mask(_e6, hit_51.uv, _e6.toward);
            placed_5.normal = _e59;
            let _e62 = placed_5.normal;
            placed_5.facing = _e62;
        }
        let _e63 = placed_5;
        return _e63;
    }
    pub(crate) fn surface_object_place(
        &self,
        pixel_93: PixelIn,
        at_137: Entered,
        path_118: Path,
        hit_52: Hit,
        params_129: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_object_place(pixel_93, at_137, path_118, hit_52, rt::into(params_129)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_surface_object_place(
        &self,
        pixel_93: PixelIn,
        at_137: Entered,
        path_118: Path,
        hit_52: Hit,
        params_129: rt::Vec4<f32>,
    ) -> Entered {
        let _e5 = self.v_placed_in_image(pixel_93, at_137, path_118, hit_52);
        return _e5;
    }
    pub(crate) fn normal_of_frames(&self, at_138: Entered, frames_2: Frames) -> rt::Vec3<f32> {
        rt::into(self.v_normal_of_frames(at_138, frames_2))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_normal_of_frames(&self, at_138: Entered, frames_2: Frames) -> rt::Vec3<f32> {
        let mut sum_5: rt::Vec3<f32> = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
        let mut k_41: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut seen_3: Entered;

        'naga_break: loop {
            'naga_continue: {
                let _e9 = k_41;
                if rt::Scalar::into_branch_condition(_e9.elementwise_lt(FRAMES)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e12 = k_41;
                    let _e13 = self.v_frame_number(frames_2, _e12);
                    let _e14 = self.v_image_of_object(_e13);
                    seen_3 = at_138;
                    let _e17 = self.v_tangent_of_image(_e14);
                    seen_3.tangent = _e17;
                    let _e19 = self.v_bitangent_of_image(_e14);
                    seen_3.bitangent = _e19;
                    seen_3.normal = _e14.toward;
                    let _e23 = self.v_place_in_image(_e14, at_138.point);
                    let uv_47 = _e23.xy();
                    let _e25 = sum_5;
                    let _e26 = seen_3;
                    let _e27 = self.v_finest_normal(_e26, uv_47);
                    let _e28 = k_41;
                    let _e29 = self.v_frame_weight(frames_2, _e28);
                    sum_5 = (_e25 + (_e27 * _e29));
                    let _e32 = k_41;
                    k_41 = (_e32 + rt::Scalar(1u32));
                }
            }
        }
        let _e35 = sum_5;
        let _e36 = sum_5;
        let square_7 = _e35.dot(_e36);
        if rt::Scalar::into_branch_condition(square_7.elementwise_gt(rt::Scalar(0f32))) {
            let _e40 = sum_5;
            return (_e40 / rt::Vec3::splat_from_scalar(square_7.sqrt()));
        }
        return at_138.normal;
    }
    pub(crate) fn surface_frames_place(
        &self,
        pixel_94: PixelIn,
        at_139: Entered,
        path_119: Path,
        hit_53: Hit,
        params_130: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_frames_place(pixel_94, at_139, path_119, hit_53, rt::into(params_130)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_frames_place(
        &self,
        pixel_94: PixelIn,
        at_139: Entered,
        path_119: Path,
        hit_53: Hit,
        params_130: rt::Vec4<f32>,
    ) -> Entered {
        let mut placed_6: Entered;
        let mut local_128: rt::Scalar<bool>;

        let _e5 = self.v_placed_in_image(pixel_94, at_139, path_119, hit_53);
        placed_6 = _e5;
        let _e9 = rt::Scalar(self.surface_settings.has_vertex_normals);
        if rt::Scalar::into_branch_condition(_e9.elementwise_eq(rt::Scalar(1u32))) {
            let _e16 = rt::Scalar(self.surface_settings.cells);
            local_128 = _e16.elementwise_ne(CELLS_MASK);
        } else {
            local_128 = rt::Scalar(false);
        }
        let _e20 = local_128;
        if rt::Scalar::into_branch_condition(_e20) {
            let _e22 = placed_6;
            let _e26 = self.v_frames_around((-pixel_94.direction.normalize()));
            let _e27 = self.v_normal_of_frames(_e22, _e26);
            placed_6.normal = _e27;
        }
        let _e28 = placed_6;
        return _e28;
    }
    pub(crate) fn surface_object_slices_place(
        &self,
        pixel_95: PixelIn,
        at_140: Entered,
        path_120: Path,
        hit_54: Hit,
        params_131: impl rt::Into<rt::Vec4<f32>>,
    ) -> Entered {
        rt::into(self.v_surface_object_slices_place(pixel_95, at_140, path_120, hit_54, rt::into(params_131)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_object_slices_place(
        &self,
        pixel_95: PixelIn,
        at_140: Entered,
        path_120: Path,
        hit_54: Hit,
        params_131: rt::Vec4<f32>,
    ) -> Entered {
        let mut of_image: Path;
        let mut placed_7: Entered;

        let _e6 = self.v_slice_at(at_140.point);
        let number_29 = rt::Scalar(_e6.number);
        of_image = path_120;
        rt::Scalar(of_image.base) = number_29.to_f32();
        let _e11 = of_image;
        let _e12 = self.v_placed_in_image(pixel_95, at_140, _e11, hit_54);
        placed_7 = _e12;
        let _e16 = rt::Scalar(self.surface_settings.cells);
        if rt::Scalar::into_branch_condition(_e16.elementwise_eq(CELLS_MASK)) {
            let _e20 = self.v_image_of_object(number_29);
            let _e23 = self.v_normal_of_mask(_e20, hit_54.uv, at_140.normal);
            placed_7.normal = _e23;
            let _e26 = placed_7.normal;
            placed_7.facing = _e26;
        }
        let _e27 = placed_7;
        return _e27;
    }
    pub(crate) fn surface_place_stage(&self, pixel_96: PixelIn, at_141: Entered, path_121: Path, hit_55: Hit) -> Entered {
        rt::into(self.v_surface_place_stage(pixel_96, at_141, path_121, hit_55))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_surface_place_stage(&self, pixel_96: PixelIn, at_141: Entered, path_121: Path, hit_55: Hit) -> Entered {
        let _e8 = rt::Scalar(self.surface_settings.choices[1usize].number);
        match rt::Scalar::into_inner(_e8) {
            0u32 => {
                let _e13 = self.surface_settings.choices[1usize].params;
                let _e14 = self.v_surface_plane_place(pixel_96, at_141, path_121, hit_55, _e13);
                return _e14;
            }
            1u32 => {
                let _e19 = self.surface_settings.choices[1usize].params;
                let _e20 = self.v_surface_prism_place(pixel_96, at_141, path_121, hit_55, _e19);
                return _e20;
            }
            2u32 => {
                let _e25 = self.surface_settings.choices[1usize].params;
                let _e26 = self.v_surface_quadric_perpendicular_place(pixel_96, at_141, path_121, hit_55, _e25);
                return _e26;
            }
            3u32 => {
                let _e31 = self.surface_settings.choices[1usize].params;
                let _e32 = self.v_surface_quadric_vertical_place(pixel_96, at_141, path_121, hit_55, _e31);
                return _e32;
            }
            4u32 => {
                let _e37 = self.surface_settings.choices[1usize].params;
                let _e38 = self.v_surface_tetrahedra_place(pixel_96, at_141, path_121, hit_55, _e37);
                return _e38;
            }
            5u32 => {
                let _e43 = self.surface_settings.choices[1usize].params;
                let _e44 = self.v_surface_facets_place(pixel_96, at_141, path_121, hit_55, _e43);
                return _e44;
            }
            6u32 => {
                let _e49 = self.surface_settings.choices[1usize].params;
                let _e50 = self.v_surface_slices_place(pixel_96, at_141, path_121, hit_55, _e49);
                return _e50;
            }
            7u32 => {
                let _e55 = self.surface_settings.choices[1usize].params;
                let _e56 = self.v_surface_object_place(pixel_96, at_141, path_121, hit_55, _e55);
                return _e56;
            }
            8u32 => {
                let _e61 = self.surface_settings.choices[1usize].params;
                let _e62 = self.v_surface_frames_place(pixel_96, at_141, path_121, hit_55, _e61);
                return _e62;
            }
            _ => {
                let _e67 = self.surface_settings.choices[1usize].params;
                let _e68 = self.v_surface_object_slices_place(pixel_96, at_141, path_121, hit_55, _e67);
                return _e68;
            }
        }
    }
    pub(crate) fn place_on_segment(&self, pixel_97: PixelIn, at_142: Entered, path_122: Path, hit_56: Hit) -> Entered {
        rt::into(self.v_place_on_segment(pixel_97, at_142, path_122, hit_56))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_place_on_segment(&self, pixel_97: PixelIn, at_142: Entered, path_122: Path, hit_56: Hit) -> Entered {
        let mut placed_8: Entered;

        let _e4 = self.v_surface_place_stage(pixel_97, at_142, path_122, hit_56);
        placed_8 = _e4;
        let _e7 = self.v_depth_on_ray(pixel_97, path_122, hit_56);
        rt::Scalar(placed_8.depth) = _e7;
        let _e8 = placed_8;
        return _e8;
    }
    pub(crate) fn toward_light(
        &self,
        number_19: impl rt::Into<rt::Scalar<u32>>,
        position: impl rt::Into<rt::Vec3<f32>>,
    ) -> Toward {
        rt::into(self.v_toward_light(rt::into(number_19), rt::into(position)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_toward_light(
        &self,
        number_19: rt::Scalar<u32>,
        position: rt::Vec3<f32>,
    ) -> Toward {
        let light_27 = self.frame.lights[rt::Scalar::into_array_index(number_19)];
        if rt::Scalar::into_branch_condition(light_27.place.w().elementwise_gt(rt::Scalar(0.5f32))) {
            let toward_12 = (light_27.place.xyz() - position);
            let squared_5 = toward_12.dot(toward_12);
            let distance_3 = squared_5.sqrt();
            let falloff = (rt::Scalar(1f32) / squared_5.max(rt::Scalar(0.000001f32)));
            return <Toward>::new(toward_12.normalize(), falloff, distance_3, (light_27.color.w() / distance_3), number_19);
        }
        return <Toward>::new(light_27.place.xyz().normalize(), rt::Scalar(1f32), rt::Scalar(300000000000000000000000000000000000000f32), light_27.color.w(), number_19);
    }
    pub(crate) fn scattered(
        &self,
        pixel_98: PixelIn,
        at_143: Entered,
        path_123: Path,
        t_48: impl rt::Into<rt::Scalar<f32>>,
        around_3: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_scattered(pixel_98, at_143, path_123, rt::into(t_48), rt::into(around_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_scattered(
        &self,
        pixel_98: PixelIn,
        at_143: Entered,
        path_123: Path,
        t_48: rt::Scalar<f32>,
        around_3: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let mut light_13: rt::Vec3<f32>;
        let mut k_42: rt::Scalar<u32> = rt::Scalar(0u32);

        let _e7 = self.v_path_uv(path_123, t_48);
        let _e8 = self.v_path_height(path_123, t_48);
        let hit_88 = <Hit>::new(rt::Scalar(1u32), rt::Scalar(0u32), _e7, _e8, t_48, NO_COST);
        let _e11 = self.v_place_on_segment(pixel_98, at_143, path_123, hit_88);
        let _e14 = self.surface_settings.diffuse;
        let _e18 = self.v_color_or_white(hit_88.uv, rt::Scalar(at_143.footprint));
        let albedo = (_e14.xyz() * _e18);
        light_13 = around_3;
        'naga_break: loop {
            'naga_continue: {
                let _e23 = k_42;
                let _e26 = rt::Scalar(self.frame.light_count);
                if rt::Scalar::into_branch_condition(_e23.elementwise_lt(_e26)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e28 = k_42;
                    let _e30 = self.v_toward_light(_e28, _e11.point);
                    let _e31 = self.v_arriving(_e11, hit_88, _e30);
                    let part_35 = (_e31 * rt::Scalar(_e30.falloff));
                    let _e34 = light_13;
                    let _e37 = k_42;
                    let _e40 = self.frame.lights[rt::Scalar::into_array_index(_e37)].color;
                    light_13 = (_e34 + (_e40.xyz() * (rt::Scalar(0.25f32) * part_35)));
                    let _e46 = k_42;
                    k_42 = (_e46 + rt::Scalar(1u32));
                }
            }
        }
        let _e49 = light_13;
        let _e53 = self.surface_settings.emission;
        return ((albedo * _e49) + _e53.xyz());
    }
    pub(crate) fn looked_at(
        &self,
        before_6: Gathering,
        pixel_99: PixelIn,
        at_144: Entered,
        path_124: Path,
        around_4: impl rt::Into<rt::Vec3<f32>>,
    ) -> Gathering {
        rt::into(self.v_looked_at(before_6, pixel_99, at_144, path_124, rt::into(around_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_looked_at(
        &self,
        before_6: Gathering,
        pixel_99: PixelIn,
        at_144: Entered,
        path_124: Path,
        around_4: rt::Vec3<f32>,
    ) -> Gathering {
        let mut now: Gathering;

        if rt::Scalar::into_branch_condition((!rt::Scalar(before_6.part).elementwise_gt(rt::Scalar(0f32)))) {
            return before_6;
        }
        let _e12 = self.v_scattered(pixel_99, at_144, path_124, (rt::Scalar(before_6.places) / rt::Scalar(before_6.part)), around_4);
        now = <Gathering>::new(before_6.seen, rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0u32));
        let _e23 = now.seen.light;
        let _e27 = rt::Scalar(now.seen.pending);
        now.seen.light = (_e23 + (_e12 * (rt::Scalar(before_6.part) + _e27)));
        rt::Scalar(now.seen.pending) = rt::Scalar(0f32);
        let _e34 = now;
        return _e34;
    }
    pub(crate) fn gathered_in_cell(
        &self,
        before_7: Gathering,
        pixel_100: PixelIn,
        at_145: Entered,
        path_125: Path,
        way_23: VoxelPath,
        part_15: CellPart,
        around_5: impl rt::Into<rt::Vec3<f32>>,
    ) -> Gathering {
        rt::into(self.v_gathered_in_cell(before_7, pixel_100, at_145, path_125, way_23, part_15, rt::into(around_5)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_gathered_in_cell(
        &self,
        before_7: Gathering,
        pixel_100: PixelIn,
        at_145: Entered,
        path_125: Path,
        way_23: VoxelPath,
        part_15: CellPart,
        around_5: rt::Vec3<f32>,
    ) -> Gathering {
        let mut now_1: Gathering;
        let mut begin_8: rt::Scalar<f32>;
        let mut local_129: rt::Scalar<bool>;
        let mut local_130: rt::Scalar<bool>;
        let mut local_131: rt::Scalar<bool>;

        let params_154 = self.surface_settings.choices[6usize].params;
        let _e14 = self.v_voxel_cell(part_15.cell.to_i32());
        let share_1 = (rt::Scalar(1f32) / params_154.y());
        now_1 = before_7;
        begin_8 = rt::Scalar(part_15.begin);
        'naga_break: loop {
            'naga_continue: {
                let _e21 = begin_8;
                if rt::Scalar::into_branch_condition(_e21.elementwise_lt(rt::Scalar(part_15.end))) {
                    let _e27 = now_1.seen;
                    let _e28 = self.v_goes_on(_e27);
                    local_129 = _e28;
                } else {
                    local_129 = rt::Scalar(false);
                }
                let _e30 = local_129;
                if rt::Scalar::into_branch_condition(_e30) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e31 = begin_8;
                    let _e35 = rt::Scalar(now_1.seen.transmittance);
                    let _e37 = self.v_end_of_piece(way_23, part_15, _e14, _e31, params_154.x(), (share_1 / _e35));
                    let _e39 = begin_8;
                    let _e40 = self.v_field_between(way_23, part_15.cell, _e14, _e39, _e37);
                    let depth_14 = (_e40 * params_154.x());
                    if rt::Scalar::into_branch_condition(depth_14.elementwise_gt(rt::Scalar(0f32))) {
                        let _e49 = rt::Scalar(now_1.seen.entry);
                        local_130 = _e49.elementwise_eq(rt::Scalar(300000000000000000000000000000000000000f32));
                    } else {
                        local_130 = rt::Scalar(false);
                    }
                    let _e53 = local_130;
                    if rt::Scalar::into_branch_condition(_e53) {
                        let _e61 = begin_8;
                        let _e64 = self.v_depth_on_ray(pixel_100, path_125, <Hit>::new(rt::Scalar(1u32), rt::Scalar(0u32), path_125.uv, path_125.h.x(), _e61, NO_COST));
                        rt::Scalar(now_1.seen.entry) = _e64;
                    }
                    let _e65 = self.v_transmittance_of(depth_14);
                    let _e68 = rt::Scalar(now_1.seen.transmittance);
                    let scattered_part = (_e68 * (rt::Scalar(1f32) - _e65));
                    let _e76 = rt::Scalar(now_1.seen.transmittance);
                    rt::Scalar(now_1.seen.transmittance) = (_e76 * _e65);
                    let _e80 = rt::Scalar(now_1.part);
                    rt::Scalar(now_1.part) = (_e80 + scattered_part);
                    let _e84 = rt::Scalar(now_1.places);
                    let _e85 = begin_8;
                    rt::Scalar(now_1.places) = (_e84 + (scattered_part * (rt::Scalar(0.5f32) * (_e85 + _e37))));
                    let _e92 = rt::Scalar(now_1.part);
                    if rt::Scalar::into_branch_condition(_e92.elementwise_ge(share_1)) {
                        let _e94 = now_1;
                        let _e95 = self.v_looked_at(_e94, pixel_100, at_145, path_125, around_5);
                        now_1 = _e95;
                    }
                    let _e97 = begin_8;
                    begin_8 = rt::Scalar(part_15.end).select(_e37, _e37.elementwise_gt(_e97));
                }
            }
        }
        let _e102 = rt::Scalar(now_1.cells);
        rt::Scalar(now_1.cells) = (_e102 + rt::Scalar(1u32));
        let _e106 = rt::Scalar(now_1.cells);
        if rt::Scalar::into_branch_condition(_e106.elementwise_ge(MOST_CELLS)) {
            let _e112 = rt::Scalar(now_1.part);
            local_131 = _e112.elementwise_ge((share_1 * rt::Scalar(0.125f32)));
        } else {
            local_131 = rt::Scalar(false);
        }
        let _e117 = local_131;
        if rt::Scalar::into_branch_condition(_e117) {
            let _e118 = now_1;
            let _e119 = self.v_looked_at(_e118, pixel_100, at_145, path_125, around_5);
            now_1 = _e119;
        }
        let _e120 = now_1;
        return _e120;
    }
    pub(crate) fn gather_segment(
        &self,
        before_8: Gathered,
        pixel_101: PixelIn,
        at_146: Entered,
        k_43: impl rt::Into<rt::Scalar<u32>>,
    ) -> Gathered {
        rt::into(self.v_gather_segment(before_8, pixel_101, at_146, rt::into(k_43)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_gather_segment(
        &self,
        before_8: Gathered,
        pixel_101: PixelIn,
        at_146: Entered,
        k_43: rt::Scalar<u32>,
    ) -> Gathered {
        let mut now_2: Gathering;
        let mut part_16: CellPart;
        let mut cells_1: rt::Scalar<u32> = rt::Scalar(1u32);
        let mut goes_1: rt::Scalar<bool> = rt::Scalar(true);
        let mut local_132: rt::Scalar<bool>;
        let mut local_133: rt::Scalar<bool>;

        let _e4 = self.v_segment_of(pixel_101, at_146, k_43);
        let _e7 = self.v_rest_of_segment(_e4, rt::Scalar(before_8.until_m), rt::Scalar(before_8.reach_m));
        if rt::Scalar::into_branch_condition((!rt::Scalar(_e7.exit).elementwise_gt(rt::Scalar(0f32)))) {
            return before_8;
        }
        let _e12 = self.v_voxel_path(_e7);
        let _e13 = self.v_turning_point(_e12);
        let _e19 = self.surface_settings.choices[6usize].params.z();
        let limit_18 = _e19.to_u32();
        let _e21 = self.v_light_around(at_146, _e7);
        now_2 = <Gathering>::new(before_8, rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0u32));
        rt::Scalar(now_2.seen.until_m) = (rt::Scalar(_e7.start) + rt::Scalar(_e7.exit));
        let _e32 = self.v_first_part(_e7, _e12, _e13);
        part_16 = _e32;
        'naga_break: loop {
            'naga_continue: {
                let _e38 = goes_1;
                if rt::Scalar::into_branch_condition(_e38) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e40 = rt::Scalar(part_16.empty);
                    if rt::Scalar::into_branch_condition(_e40.elementwise_lt(rt::Scalar(0f32))) {
                        let _e43 = now_2;
                        let _e44 = part_16;
                        let _e45 = self.v_gathered_in_cell(_e43, pixel_101, at_146, _e7, _e12, _e44, _e21);
                        now_2 = _e45;
                    } else {
                        let _e47 = rt::Scalar(now_2.part);
                        if rt::Scalar::into_branch_condition(_e47.elementwise_gt(rt::Scalar(0.000061035156f32))) {
                            let _e50 = now_2;
                            let _e51 = self.v_looked_at(_e50, pixel_101, at_146, _e7, _e21);
                            now_2 = _e51;
                        }
                    }
                    let _e53 = rt::Scalar(part_16.is_last);
                    if rt::Scalar::into_branch_condition(_e53.elementwise_eq(rt::Scalar(0u32))) {
                        let _e58 = cells_1;
                        local_132 = _e58.elementwise_lt(limit_18);
                    } else {
                        local_132 = rt::Scalar(false);
                    }
                    let _e61 = local_132;
                    if rt::Scalar::into_branch_condition(_e61) {
                        let _e65 = now_2.seen;
                        let _e66 = self.v_goes_on(_e65);
                        local_133 = _e66;
                    } else {
                        local_133 = rt::Scalar(false);
                    }
                    let _e68 = local_133;
                    goes_1 = _e68;
                    let _e69 = goes_1;
                    if rt::Scalar::into_branch_condition(_e69) {
                        let _e70 = part_16;
                        let _e71 = self.v_next_part(_e7, _e12, _e13, _e70);
                        part_16 = _e71;
                        let _e72 = cells_1;
                        cells_1 = (_e72 + rt::Scalar(1u32));
                    }
                }
            }
        }
        let _e76 = rt::Scalar(now_2.part);
        let _e79 = rt::Scalar(now_2.seen.pending);
        if rt::Scalar::into_branch_condition((_e76 + _e79).elementwise_gt(rt::Scalar(0.000061035156f32))) {
            let _e83 = now_2;
            let _e84 = self.v_looked_at(_e83, pixel_101, at_146, _e7, _e21);
            return _e84.seen;
        }
        let _e90 = rt::Scalar(now_2.seen.pending);
        let _e92 = rt::Scalar(now_2.part);
        rt::Scalar(now_2.seen.pending) = (_e90 + _e92);
        let _e95 = now_2.seen;
        return _e95;
    }
    pub(crate) fn quarter_sine(&self, turn_4: impl rt::Into<rt::Scalar<f32>>) -> f32 {
        rt::into(self.v_quarter_sine(rt::into(turn_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_quarter_sine(&self, turn_4: rt::Scalar<f32>) -> rt::Scalar<f32> {
        let x_17 = (turn_4 * rt::Scalar(6.2831855f32));
        let s_4 = (x_17 * x_17);
        let last_19 = (rt::Scalar(-0.0001984127f32) + (s_4 * rt::Scalar(0.0000027557319f32)));
        return (x_17 * (rt::Scalar(1f32) + (s_4 * (rt::Scalar(-0.16666667f32) + (s_4 * (rt::Scalar(0.008333334f32) + (s_4 * last_19)))))));
    }
    pub(crate) fn sine_of(&self, turn_5: impl rt::Into<rt::Scalar<f32>>) -> f32 {
        rt::into(self.v_sine_of(rt::into(turn_5)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_sine_of(&self, turn_5: rt::Scalar<f32>) -> rt::Scalar<f32> {
        let part_36 = (turn_5 - turn_5.floor());
        let _e11 = self.v_quarter_sine((rt::Scalar(0.25f32) - (rt::Scalar(0.25f32) - (part_36 - rt::Scalar(0.5f32)).abs()).abs()));
        return _e11.select((rt::Scalar(0f32) - _e11), part_36.elementwise_gt(rt::Scalar(0.5f32)));
    }
    pub(crate) fn turned_1(&self, turn_6: impl rt::Into<rt::Scalar<f32>>) -> rt::Vec2<f32> {
        rt::into(self.v_turned_1(rt::into(turn_6)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_turned_1(&self, turn_6: rt::Scalar<f32>) -> rt::Vec2<f32> {
        let _e3 = self.v_sine_of((turn_6 + rt::Scalar(0.25f32)));
        let _e4 = self.v_sine_of(turn_6);
        return <rt::Vec2<f32>>::from_scalars(_e3, _e4);
    }
    pub(crate) fn unit_of(&self, bits: impl rt::Into<rt::Scalar<u32>>) -> f32 {
        rt::into(self.v_unit_of(rt::into(bits)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_unit_of(&self, bits: rt::Scalar<u32>) -> rt::Scalar<f32> {
        return ((bits >> rt::Scalar(8u32)).to_f32() / rt::Scalar(16777216f32));
    }
    pub(crate) fn gradient_at(
        &self,
        point_20: impl rt::Into<rt::Vec2<f32>>,
        way_24: impl rt::Into<rt::Vec2<f32>>,
        count_7: impl rt::Into<rt::Scalar<f32>>,
        turns_1: impl rt::Into<rt::Scalar<f32>>,
        seed_2: impl rt::Into<rt::Scalar<u32>>,
    ) -> f32 {
        rt::into(self.v_gradient_at(rt::into(point_20), rt::into(way_24), rt::into(count_7), rt::into(turns_1), rt::into(seed_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_gradient_at(
        &self,
        point_20: rt::Vec2<f32>,
        way_24: rt::Vec2<f32>,
        count_7: rt::Scalar<f32>,
        turns_1: rt::Scalar<f32>,
        seed_2: rt::Scalar<u32>,
    ) -> rt::Scalar<f32> {
        let _e5 = self.v_bits_of_point(point_20, count_7, seed_2);
        let _e6 = self.v_unit_of(_e5);
        let _e8 = self.v_turned_1((_e6 + turns_1));
        return _e8.dot(way_24);
    }
    pub(crate) fn gradient_noise(
        &self,
        at_147: impl rt::Into<rt::Vec2<f32>>,
        count_8: impl rt::Into<rt::Scalar<f32>>,
        turns_2: impl rt::Into<rt::Scalar<f32>>,
        seed_3: impl rt::Into<rt::Scalar<u32>>,
    ) -> f32 {
        rt::into(self.v_gradient_noise(rt::into(at_147), rt::into(count_8), rt::into(turns_2), rt::into(seed_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_gradient_noise(
        &self,
        at_147: rt::Vec2<f32>,
        count_8: rt::Scalar<f32>,
        turns_2: rt::Scalar<f32>,
        seed_3: rt::Scalar<u32>,
    ) -> rt::Scalar<f32> {
        let cell_46 = at_147.floor();
        let part_37 = (at_147 - cell_46);
        let fade = (((part_37 * part_37) * part_37) * ((part_37 * ((part_37 * rt::Scalar(6f32)) - rt::Vec2::splat_from_scalar(rt::Scalar(15f32)))) + rt::Vec2::splat_from_scalar(rt::Scalar(10f32))));
        let right_6 = <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(0f32));
        let down_1 = <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(1f32));
        let _e24 = self.v_gradient_at(cell_46, part_37, count_8, turns_2, seed_3);
        let _e27 = self.v_gradient_at((cell_46 + right_6), (part_37 - right_6), count_8, turns_2, seed_3);
        let _e30 = self.v_gradient_at((cell_46 + down_1), (part_37 - down_1), count_8, turns_2, seed_3);
        let _e35 = self.v_gradient_at(((cell_46 + right_6) + down_1), ((part_37 - right_6) - down_1), count_8, turns_2, seed_3);
        let above_12 = (_e24 + ((_e27 - _e24) * fade.x()));
        let below_12 = (_e30 + ((_e35 - _e30) * fade.x()));
        return (above_12 + ((below_12 - above_12) * fade.y()));
    }
    pub(crate) fn is_before(
        &self,
        plane_1: impl rt::Into<rt::Vec4<f32>>,
        position_1: impl rt::Into<rt::Vec3<f32>>,
        direction_6: impl rt::Into<rt::Vec3<f32>>,
        low_m: impl rt::Into<rt::Scalar<f32>>,
        high_m: impl rt::Into<rt::Scalar<f32>>,
    ) -> bool {
        rt::into(self.v_is_before(rt::into(plane_1), rt::into(position_1), rt::into(direction_6), rt::into(low_m), rt::into(high_m)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_is_before(
        &self,
        plane_1: rt::Vec4<f32>,
        position_1: rt::Vec3<f32>,
        direction_6: rt::Vec3<f32>,
        low_m: rt::Scalar<f32>,
        high_m: rt::Scalar<f32>,
    ) -> rt::Scalar<bool> {
        let mut local_134: rt::Scalar<bool>;

        let low_13 = (plane_1.xyz().dot((position_1 + (direction_6 * low_m))) + plane_1.w());
        let high_8 = (plane_1.xyz().dot((position_1 + (direction_6 * high_m))) + plane_1.w());
        if rt::Scalar::into_branch_condition(low_13.elementwise_gt(rt::Scalar(0f32))) {
            local_134 = high_8.elementwise_gt(rt::Scalar(0f32));
        } else {
            local_134 = rt::Scalar(false);
        }
        let _e24 = local_134;
        return _e24;
    }
    pub(crate) fn is_left_out(
        &self,
        grid_10: Tessellation,
        a_18: BaseVertex,
        b_18: BaseVertex,
        c_13: BaseVertex,
        low_m_1: impl rt::Into<rt::Scalar<f32>>,
        high_m_1: impl rt::Into<rt::Scalar<f32>>,
    ) -> bool {
        rt::into(self.v_is_left_out(grid_10, a_18, b_18, c_13, rt::into(low_m_1), rt::into(high_m_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_is_left_out(
        &self,
        grid_10: Tessellation,
        a_18: BaseVertex,
        b_18: BaseVertex,
        c_13: BaseVertex,
        low_m_1: rt::Scalar<f32>,
        high_m_1: rt::Scalar<f32>,
    ) -> rt::Scalar<bool> {
        let mut k_44: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut local_135: rt::Scalar<bool>;
        let mut local_136: rt::Scalar<bool>;

        'naga_break: loop {
            'naga_continue: {
                let _e8 = k_44;
                if rt::Scalar::into_branch_condition(_e8.elementwise_lt(rt::Scalar(5u32))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e12 = k_44;
                    let plane_3 = grid_10.planes[rt::Scalar::into_array_index(_e12)];
                    let _e14 = k_44;
                    k_44 = (_e14 + rt::Scalar(1u32));
                    let _e19 = self.v_is_before(plane_3, a_18.position, a_18.direction, low_m_1, high_m_1);
                    if rt::Scalar::into_branch_condition(_e19) {
                        let _e24 = self.v_is_before(plane_3, b_18.position, b_18.direction, low_m_1, high_m_1);
                        local_135 = _e24;
                    } else {
                        local_135 = rt::Scalar(false);
                    }
                    let _e26 = local_135;
                    if rt::Scalar::into_branch_condition(_e26) {
                        let _e31 = self.v_is_before(plane_3, c_13.position, c_13.direction, low_m_1, high_m_1);
                        local_136 = _e31;
                    } else {
                        local_136 = rt::Scalar(false);
                    }
                    let _e33 = local_136;
                    if rt::Scalar::into_branch_condition(_e33) {
                        return rt::Scalar(true);
                    }
                }
            }
        }
        return rt::Scalar(false);
    }
    pub(crate) fn magnitude(&self, number_20: impl rt::Into<rt::Scalar<i32>>) -> u32 {
        rt::into(self.v_magnitude(rt::into(number_20)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_magnitude(&self, number_20: rt::Scalar<i32>) -> rt::Scalar<u32> {
        return number_20.abs().to_u32();
    }
    pub(crate) fn stretch_of(&self, a_19: SweptPoint, b_19: SweptPoint) -> u32 {
        rt::into(self.v_stretch_of(a_19, b_19))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_stretch_of(&self, a_19: SweptPoint, b_19: SweptPoint) -> rt::Scalar<u32> {
        let _e9 = self.v_magnitude(((rt::Scalar(b_19.x) * rt::Scalar(a_19.w)) - (rt::Scalar(a_19.x) * rt::Scalar(b_19.w))));
        let _e17 = self.v_magnitude(((rt::Scalar(b_19.y) * rt::Scalar(a_19.w)) - (rt::Scalar(a_19.y) * rt::Scalar(b_19.w))));
        return (_e9 + _e17);
    }
    pub(crate) fn is_no_longer(&self, a_20: SweptPoint, b_20: SweptPoint, c_14: SweptPoint, d_3: SweptPoint) -> bool {
        rt::into(self.v_is_no_longer(a_20, b_20, c_14, d_3))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_is_no_longer(&self, a_20: SweptPoint, b_20: SweptPoint, c_14: SweptPoint, d_3: SweptPoint) -> rt::Scalar<bool> {
        let _e4 = self.v_stretch_of(a_20, b_20);
        let _e9 = self.v_stretch_of(c_14, d_3);
        let _e14 = self.v_compared(_e4, (rt::Scalar(c_14.w) * rt::Scalar(d_3.w)).to_u32(), _e9, (rt::Scalar(a_20.w) * rt::Scalar(b_20.w)).to_u32());
        return _e14.elementwise_le(rt::Scalar(0i32));
    }
    pub(crate) fn longest_of(&self, between_1: impl rt::Into<rt::Vec3<i32>>) -> i32 {
        rt::into(self.v_longest_of(rt::into(between_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_longest_of(&self, between_1: rt::Vec3<i32>) -> rt::Scalar<i32> {
        let along_45 = between_1.abs();
        return along_45.x().max(along_45.y()).max(along_45.z());
    }
    pub(crate) fn is_swept(
        &self,
        grid_11: Tessellation,
        a_21: Voxel,
        b_21: Voxel,
        c_15: Voxel,
        level_56: impl rt::Into<rt::Scalar<u32>>,
    ) -> bool {
        rt::into(self.v_is_swept(grid_11, a_21, b_21, c_15, rt::into(level_56)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_is_swept(
        &self,
        grid_11: Tessellation,
        a_21: Voxel,
        b_21: Voxel,
        c_15: Voxel,
        level_56: rt::Scalar<u32>,
    ) -> rt::Scalar<bool> {
        let mut local_137: rt::Scalar<bool>;
        let mut local_138: rt::Scalar<bool>;

        let _e6 = self.v_coarser_voxel(a_21.at, level_56);
        let _e8 = self.v_coarser_voxel(b_21.at, level_56);
        let _e10 = self.v_coarser_voxel(c_15.at, level_56);
        let _e12 = self.v_longest_of((_e8 - _e6));
        let _e14 = self.v_longest_of((_e10 - _e8));
        let _e17 = self.v_longest_of((_e6 - _e10));
        let longest = _e12.max(_e14).max(_e17);
        if rt::Scalar::into_branch_condition(longest.elementwise_gt(rt::Scalar(0i32))) {
            local_137 = longest.elementwise_le(rt::Scalar(1023i32));
        } else {
            local_137 = rt::Scalar(false);
        }
        let _e26 = local_137;
        if rt::Scalar::into_branch_condition(_e26) {
            local_138 = rt::Scalar(grid_11.is_swept).elementwise_eq(rt::Scalar(1u32));
        } else {
            local_138 = rt::Scalar(false);
        }
        let _e33 = local_138;
        return _e33;
    }
    pub(crate) fn light_seen(
        &self,
        at_148: Entered,
        hit_57: Hit,
        number_21: impl rt::Into<rt::Scalar<u32>>,
        toward_2: impl rt::Into<rt::Vec3<f32>>,
        filter_texels_1: impl rt::Into<rt::Scalar<f32>>,
        bias_2: impl rt::Into<rt::Scalar<f32>>,
    ) -> f32 {
        rt::into(self.v_light_seen(at_148, hit_57, rt::into(number_21), rt::into(toward_2), rt::into(filter_texels_1), rt::into(bias_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_light_seen(
        &self,
        at_148: Entered,
        hit_57: Hit,
        number_21: rt::Scalar<u32>,
        toward_2: rt::Vec3<f32>,
        filter_texels_1: rt::Scalar<f32>,
        bias_2: rt::Scalar<f32>,
    ) -> rt::Scalar<f32> {
        let _e10 = rt::Scalar(self.frame.lights[rt::Scalar::into_array_index(number_21)].views);
        if rt::Scalar::into_branch_condition(_e10.elementwise_eq(rt::Scalar(0u32))) {
            return rt::Scalar(1f32);
        }
        let _e14 = self.v_field_patch_normal_stage(at_148, hit_57);
        if rt::Scalar::into_branch_condition((!_e14.dot(toward_2).elementwise_gt(rt::Scalar(0f32)))) {
            return rt::Scalar(0f32);
        }
        let _e20 = self.v_patch_seen(at_148, _e14, number_21, filter_texels_1, bias_2);
        return _e20;
    }
    pub(crate) fn main_axis(
        &self,
        start_4: impl rt::Into<rt::Vec3<i32>>,
        to_1: impl rt::Into<rt::Vec3<i32>>,
    ) -> u32 {
        rt::into(self.v_main_axis(rt::into(start_4), rt::into(to_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_main_axis(
        &self,
        start_4: rt::Vec3<i32>,
        to_1: rt::Vec3<i32>,
    ) -> rt::Scalar<u32> {
        let mut local_139: rt::Scalar<bool>;

        let along_46 = (to_1 - start_4).abs();
        let of_last_1 = rt::Scalar(2u32).select(rt::Scalar(1u32), along_46.y().elementwise_ge(along_46.z()));
        if rt::Scalar::into_branch_condition(along_46.x().elementwise_ge(along_46.y())) {
            local_139 = along_46.x().elementwise_ge(along_46.z());
        } else {
            local_139 = rt::Scalar(false);
        }
        let _e20 = local_139;
        return of_last_1.select(rt::Scalar(0u32), _e20);
    }
    pub(crate) fn shadow_ray(
        &self,
        at_149: Entered,
        hit_58: Hit,
        light_14: Toward,
        params_132: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_shadow_ray(at_149, hit_58, light_14, rt::into(params_132)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shadow_ray(
        &self,
        at_149: Entered,
        hit_58: Hit,
        light_14: Toward,
        params_132: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        let _e4 = self.v_free_way(at_149, hit_58, light_14);
        return _e4;
    }
    pub(crate) fn shadow_none(
        &self,
        at_150: Entered,
        hit_59: Hit,
        light_15: Toward,
        params_133: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_shadow_none(at_150, hit_59, light_15, rt::into(params_133)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shadow_none(
        &self,
        at_150: Entered,
        hit_59: Hit,
        light_15: Toward,
        params_133: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        return rt::Scalar(1f32);
    }
    pub(crate) fn shadow_entry(
        &self,
        at_151: Entered,
        hit_60: Hit,
        light_16: Toward,
        params_134: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_shadow_entry(at_151, hit_60, light_16, rt::into(params_134)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_shadow_entry(
        &self,
        at_151: Entered,
        hit_60: Hit,
        light_16: Toward,
        params_134: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        let _e4 = self.v_from_hit(at_151, hit_60, light_16);
        if rt::Scalar::into_branch_condition((!_e4.h.y().elementwise_gt(rt::Scalar(0f32)))) {
            return rt::Scalar(0f32);
        }
        let _e11 = self.v_way_out(_e4, light_16);
        if rt::Scalar::into_branch_condition((!_e11.elementwise_gt(rt::Scalar(0f32)))) {
            return rt::Scalar(1f32);
        }
        let _e16 = self.v_path_height(_e4, _e11);
        let _e17 = self.v_path_uv(_e4, _e11);
        let _e29 = self.v_base_height();
        let down_2 = <Path>::new(_e17, (<rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)) - _e4.duv), <rt::Vec3<f32>>::from_scalars(_e16, (rt::Scalar(0f32) - _e4.h.y()), rt::Scalar(0f32)), _e11, ((_e16 - _e29) / _e4.h.y()), _e4.metric, RAY_VIEW, rt::Scalar(_e4.level), rt::Scalar(0f32), rt::Scalar(1f32), rt::Scalar(0f32));
        let _e41 = self.v_search_stage(down_2);
        let _e42 = self.v_refine_stage(down_2, _e41);
        if rt::Scalar::into_branch_condition(rt::Scalar(_e42.found).elementwise_eq(rt::Scalar(0u32))) {
            return rt::Scalar(1f32);
        }
        let _e52 = self.v_height_size(rt::Scalar(_e4.level));
        let apart_5 = ((_e42.uv - _e4.uv).abs() * _e52);
        return rt::Scalar(0f32).select(rt::Scalar(1f32), apart_5.x().max(apart_5.y()).elementwise_le(params_134.x()));
    }
    pub(crate) fn seed_of(&self, hit_61: Hit) -> u32 {
        rt::into(self.v_seed_of(hit_61))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_seed_of(&self, hit_61: Hit) -> rt::Scalar<u32> {
        let place_48 = ((hit_61.uv - hit_61.uv.floor()) * rt::Scalar(16777216f32)).to_u32();
        let _e10 = self.v_mixed(place_48.y());
        let _e12 = self.v_mixed((place_48.x() ^ _e10));
        return _e12;
    }
    pub(crate) fn point_of_disc(
        &self,
        light_17: Toward,
        seed_4: impl rt::Into<rt::Scalar<u32>>,
        k_45: impl rt::Into<rt::Scalar<u32>>,
        count_9: impl rt::Into<rt::Scalar<u32>>,
    ) -> Toward {
        rt::into(self.v_point_of_disc(light_17, rt::into(seed_4), rt::into(k_45), rt::into(count_9)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_point_of_disc(
        &self,
        light_17: Toward,
        seed_4: rt::Scalar<u32>,
        k_45: rt::Scalar<u32>,
        count_9: rt::Scalar<u32>,
    ) -> Toward {
        let _e8 = self.v_mixed(((seed_4 + k_45) + rt::Scalar(1u32)));
        let _e9 = self.v_unit_of(_e8);
        let ring = ((k_45.to_f32() + _e9) / count_9.to_f32());
        let _e16 = self.v_unit_of(seed_4);
        let _e18 = self.v_turned_1(((k_45.to_f32() * rt::Scalar(0.618034f32)) + _e16));
        let place_49 = (_e18 * (ring.sqrt() * rt::Scalar(light_17.radius)));
        let other_1 = rt::Scalar(0f32).select(rt::Scalar(1f32), light_17.direction.x().abs().elementwise_gt(rt::Scalar(0.6f32)));
        let right_7 = <rt::Vec3<f32>>::from_scalars((rt::Scalar(1f32) - other_1), other_1, rt::Scalar(0f32)).cross(light_17.direction).normalize();
        let up_5 = light_17.direction.cross(right_7);
        let toward_13 = ((light_17.direction + (right_7 * place_49.x())) + (up_5 * place_49.y()));
        let along_47 = toward_13.length();
        return <Toward>::new((toward_13 / rt::Vec3::splat_from_scalar(along_47)), rt::Scalar(light_17.falloff), (rt::Scalar(light_17.distance) * along_47), rt::Scalar(0f32), rt::Scalar(light_17.number));
    }
    pub(crate) fn shadow_soft(
        &self,
        at_152: Entered,
        hit_62: Hit,
        light_18: Toward,
        params_135: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_shadow_soft(at_152, hit_62, light_18, rt::into(params_135)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_shadow_soft(
        &self,
        at_152: Entered,
        hit_62: Hit,
        light_18: Toward,
        params_135: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        let mut free: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut k_46: rt::Scalar<u32> = rt::Scalar(0u32);

        let count_14 = params_135.x().to_u32();
        let _e6 = self.v_seed_of(hit_62);
        'naga_break: loop {
            'naga_continue: {
                let _e11 = k_46;
                if rt::Scalar::into_branch_condition(_e11.elementwise_lt(count_14)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e13 = free;
                    let _e14 = k_46;
                    let _e15 = self.v_point_of_disc(light_18, _e6, _e14, count_14);
                    let _e16 = self.v_free_way(at_152, hit_62, _e15);
                    free = (_e13 + _e16);
                    let _e18 = k_46;
                    k_46 = (_e18 + rt::Scalar(1u32));
                }
            }
        }
        let _e21 = free;
        return (_e21 / count_14.to_f32());
    }
    pub(crate) fn shadow_heuristic(
        &self,
        at_153: Entered,
        hit_63: Hit,
        light_19: Toward,
        params_136: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_shadow_heuristic(at_153, hit_63, light_19, rt::into(params_136)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_shadow_heuristic(
        &self,
        at_153: Entered,
        hit_63: Hit,
        light_19: Toward,
        params_136: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        let mut most_3: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut k_47: rt::Scalar<f32> = rt::Scalar(1f32);

        let _e4 = self.v_from_hit(at_153, hit_63, light_19);
        if rt::Scalar::into_branch_condition((!_e4.h.y().elementwise_gt(rt::Scalar(0f32)))) {
            return rt::Scalar(0f32);
        }
        let _e11 = self.v_way_out(_e4, light_19);
        'naga_break: loop {
            'naga_continue: {
                let _e16 = k_47;
                if rt::Scalar::into_branch_condition(_e16.elementwise_lt(params_136.x())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e19 = k_47;
                    let part_38 = (_e19 / params_136.x());
                    let _e22 = most_3;
                    let _e24 = self.v_path_gap(_e4, (part_38 * _e11));
                    most_3 = _e22.max(((rt::Scalar(0f32) - _e24) * (rt::Scalar(1f32) - part_38)));
                    let _e31 = k_47;
                    k_47 = (_e31 + rt::Scalar(1f32));
                }
            }
        }
        let _e35 = most_3;
        return (rt::Scalar(1f32) - (params_136.y() * _e35).min(rt::Scalar(1f32)));
    }
    pub(crate) fn shadow_texel(
        &self,
        place_33: impl rt::Into<rt::Vec2<i32>>,
        layer_15: impl rt::Into<rt::Scalar<i32>>,
        level_57: impl rt::Into<rt::Scalar<i32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_shadow_texel(rt::into(place_33), rt::into(layer_15), rt::into(level_57)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shadow_texel(
        &self,
        place_33: rt::Vec2<i32>,
        layer_15: rt::Scalar<i32>,
        level_57: rt::Scalar<i32>,
    ) -> rt::Vec4<f32> {
        let _e4 = rt::texture::Read::read_texel((&self.shadow_texels), place_33, rt::Scalar::into_inner(layer_15), 0i32, rt::Scalar::into_inner(level_57));
        let _e8 = self.surface_settings.maps[3usize];
        let _e9 = self.v_decoded(_e4, _e8);
        return _e9;
    }
    pub(crate) fn shadow_texel_between(
        &self,
        uv_37: impl rt::Into<rt::Vec2<f32>>,
        layer_16: impl rt::Into<rt::Scalar<i32>>,
        level_58: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_shadow_texel_between(rt::into(uv_37), rt::into(layer_16), rt::into(level_58)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shadow_texel_between(
        &self,
        uv_37: rt::Vec2<f32>,
        layer_16: rt::Scalar<i32>,
        level_58: rt::Scalar<u32>,
    ) -> rt::Vec4<f32> {
        let _e3 = self.v_height_texels(level_58);
        let _e4 = self.v_texels_around(uv_37, _e3);
        let k_65 = level_58.to_i32();
        let _e11 = self.v_shadow_texel(<rt::Vec2<i32>>::from_scalars(_e4.columns.x(), _e4.rows.x()), layer_16, k_65);
        let _e17 = self.v_shadow_texel(<rt::Vec2<i32>>::from_scalars(_e4.columns.y(), _e4.rows.x()), layer_16, k_65);
        let _e23 = self.v_shadow_texel(<rt::Vec2<i32>>::from_scalars(_e4.columns.x(), _e4.rows.y()), layer_16, k_65);
        let _e29 = self.v_shadow_texel(<rt::Vec2<i32>>::from_scalars(_e4.columns.y(), _e4.rows.y()), layer_16, k_65);
        let _e31 = self.v_bilinear(_e11, _e17, _e23, _e29, _e4.part);
        return _e31;
    }
    pub(crate) fn own_slope(&self, way_25: Path) -> f32 {
        rt::into(self.v_own_slope(way_25))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_own_slope(&self, way_25: Path) -> rt::Scalar<f32> {
        let mut level_59: Path;

        let _e1 = self.v_grid_of(way_25);
        let _e3 = self.v_cell_of(_e1.origin);
        let _e4 = self.v_cell_leave(_e1, _e3);
        let end_27 = _e4.x().min(_e4.y()).max(rt::Scalar(0f32));
        level_59 = way_25;
        level_59.h = <rt::Vec3<f32>>::from_scalars(way_25.h.x(), rt::Scalar(0f32), rt::Scalar(0f32));
        rt::Scalar(level_59.exit) = end_27;
        let _e18 = level_59;
        let _e21 = self.v_height_cell(_e3.to_i32(), rt::Scalar(way_25.level));
        let _e23 = self.v_gap_to(_e18, _e1, _e3, _e21, rt::Scalar(0f32));
        return (rt::Scalar(0f32) - _e23.y().min((_e23.y() + (_e23.z() * end_27))));
    }
    pub(crate) fn part_above(&self, height_14: impl rt::Into<rt::Scalar<f32>>) -> f32 {
        rt::into(self.v_part_above(rt::into(height_14)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_part_above(&self, height_14: rt::Scalar<f32>) -> rt::Scalar<f32> {
        let x_18 = height_14.clamp(rt::Scalar(-1f32), rt::Scalar(1f32));
        let s_5 = (x_18 * x_18);
        return (rt::Scalar(0.5f32) + (x_18 * (rt::Scalar(0.6401074f32) + (s_5 * (rt::Scalar(-0.13985065f32) + (s_5 * (rt::Scalar(0.06702511f32) + (s_5 * rt::Scalar(-0.06728186f32)))))))));
    }
    pub(crate) fn shadow_horizon(
        &self,
        at_154: Entered,
        hit_64: Hit,
        light_20: Toward,
        params_137: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_shadow_horizon(at_154, hit_64, light_20, rt::into(params_137)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_shadow_horizon(
        &self,
        at_154: Entered,
        hit_64: Hit,
        light_20: Toward,
        params_137: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        let _e5 = self.v_climb(at_154, light_20.direction);
        let map_6 = self.surface_settings.maps[3usize];
        let along_48 = (_e5.xy() * map_6.tile_m);
        let _e13 = self.v_turn_of(along_48);
        let azimuth_6 = (_e13 * params_137.x());
        let first_31 = azimuth_6.floor();
        let count_15 = params_137.x().to_i32();
        let before_17 = (first_31.to_i32() % count_15);
        let part_39 = (azimuth_6 - first_31);
        let _e24 = self.v_shadow_texel_between(hit_64.uv, before_17, rt::Scalar(at_154.level));
        let low_14 = _e24.x();
        let _e31 = self.v_shadow_texel_between(hit_64.uv, ((before_17 + rt::Scalar(1i32)) % count_15), rt::Scalar(at_154.level));
        let sine_1 = (low_14 + ((_e31.x() - low_14) * part_39));
        let squared_6 = ((sine_1 * sine_1) / ((rt::Scalar(1f32) - sine_1) * (rt::Scalar(1f32) + sine_1)).max(rt::Scalar(0.0000001f32)));
        let far_22 = (squared_6 * along_48.dot(along_48)).sqrt();
        let _e48 = self.v_from_hit(at_154, hit_64, light_20);
        let _e49 = self.v_own_slope(_e48);
        let _e52 = rt::Scalar(self.surface_settings.scale_m);
        let near_14 = (_e49 * _e52);
        let horizon = far_22.max(near_14);
        let up_6 = at_154.normal.dot(light_20.direction);
        if rt::Scalar::into_branch_condition((!rt::Scalar(light_20.radius).elementwise_gt(rt::Scalar(0f32)))) {
            return rt::Scalar(0f32).select(rt::Scalar(1f32), up_6.elementwise_gt(horizon));
        }
        let flat = (rt::Scalar(1f32) - (up_6 * up_6)).max(rt::Scalar(0f32));
        let beside_9 = (flat + (up_6 * horizon));
        if rt::Scalar::into_branch_condition((!beside_9.elementwise_gt(rt::Scalar(0f32)))) {
            return rt::Scalar(0f32).select(rt::Scalar(1f32), up_6.elementwise_gt(horizon));
        }
        let _e86 = self.v_part_above(((flat.sqrt() * (up_6 - horizon)) / (beside_9 * rt::Scalar(light_20.radius))));
        return _e86;
    }
    pub(crate) fn open_part(
        &self,
        at_155: Entered,
        hit_65: Hit,
        azimuth_3: impl rt::Into<rt::Scalar<i32>>,
        elevation_2: impl rt::Into<rt::Scalar<i32>>,
        elevations: impl rt::Into<rt::Scalar<i32>>,
    ) -> f32 {
        rt::into(self.v_open_part(at_155, hit_65, rt::into(azimuth_3), rt::into(elevation_2), rt::into(elevations)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_open_part(
        &self,
        at_155: Entered,
        hit_65: Hit,
        azimuth_3: rt::Scalar<i32>,
        elevation_2: rt::Scalar<i32>,
        elevations: rt::Scalar<i32>,
    ) -> rt::Scalar<f32> {
        let _e9 = self.v_shadow_texel_between(hit_65.uv, ((azimuth_3 * elevations) + elevation_2), rt::Scalar(at_155.level));
        return (rt::Scalar(1f32) - _e9.z());
    }
    pub(crate) fn shadow_visibility(
        &self,
        at_156: Entered,
        hit_66: Hit,
        light_21: Toward,
        params_138: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_shadow_visibility(at_156, hit_66, light_21, rt::into(params_138)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_shadow_visibility(
        &self,
        at_156: Entered,
        hit_66: Hit,
        light_21: Toward,
        params_138: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        let _e5 = self.v_climb(at_156, light_21.direction);
        if rt::Scalar::into_branch_condition((!_e5.z().elementwise_gt(rt::Scalar(0f32)))) {
            return rt::Scalar(0f32);
        }
        let map_7 = self.surface_settings.maps[3usize];
        let along_49 = (_e5.xy() * map_7.tile_m);
        let _e21 = rt::Scalar(self.surface_settings.scale_m);
        let height_29 = (_e5.z() * _e21);
        let squared_7 = ((height_29 * height_29) / (along_49.dot(along_49) + (height_29 * height_29)));
        let azimuths = params_138.x().to_i32();
        let elevations_1 = params_138.y().to_i32();
        let _e32 = self.v_turn_of(along_49);
        let azimuth_7 = (_e32 * params_138.x());
        let elevation_6 = ((squared_7 * params_138.y()) - rt::Scalar(0.5f32)).clamp(rt::Scalar(0f32), (params_138.y() - rt::Scalar(1f32)));
        if rt::Scalar::into_branch_condition(params_138.z().elementwise_lt(rt::Scalar(2f32))) {
            let a_48 = ((azimuth_7 + rt::Scalar(0.5f32)).floor().to_i32() % azimuths);
            let _e56 = self.v_open_part(at_156, hit_66, a_48, (elevation_6 + rt::Scalar(0.5f32)).floor().to_i32(), elevations_1);
            return _e56;
        }
        let a0_2 = (azimuth_7.floor().to_i32() % azimuths);
        let a1_2 = ((a0_2 + rt::Scalar(1i32)) % azimuths);
        let e0_1 = elevation_6.floor().to_i32();
        let e1_2 = (e0_1 + rt::Scalar(1i32)).min((elevations_1 - rt::Scalar(1i32)));
        let along_azimuth = (azimuth_7 - azimuth_7.floor());
        let along_elevation = (elevation_6 - elevation_6.floor());
        let _e74 = self.v_open_part(at_156, hit_66, a1_2, e0_1, elevations_1);
        let _e75 = self.v_open_part(at_156, hit_66, a0_2, e1_2, elevations_1);
        if rt::Scalar::into_branch_condition((along_azimuth + along_elevation).elementwise_le(rt::Scalar(1f32))) {
            let _e79 = self.v_open_part(at_156, hit_66, a0_2, e0_1, elevations_1);
            return ((_e79 + ((_e74 - _e79) * along_azimuth)) + ((_e75 - _e79) * along_elevation));
        }
        let _e86 = self.v_open_part(at_156, hit_66, a1_2, e1_2, elevations_1);
        return ((_e86 + ((_e75 - _e86) * (rt::Scalar(1f32) - along_azimuth))) + ((_e74 - _e86) * (rt::Scalar(1f32) - along_elevation)));
    }
    pub(crate) fn shadow_map(
        &self,
        at_157: Entered,
        hit_67: Hit,
        light_22: Toward,
        params_139: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_shadow_map(at_157, hit_67, light_22, rt::into(params_139)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shadow_map(
        &self,
        at_157: Entered,
        hit_67: Hit,
        light_22: Toward,
        params_139: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        let _e8 = self.v_light_seen(at_157, hit_67, rt::Scalar(light_22.number), light_22.direction, params_139.z(), params_139.w());
        return _e8;
    }
    pub(crate) fn shadow_scene(
        &self,
        at_158: Entered,
        hit_68: Hit,
        light_23: Toward,
        params_140: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_shadow_scene(at_158, hit_68, light_23, rt::into(params_140)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shadow_scene(
        &self,
        at_158: Entered,
        hit_68: Hit,
        light_23: Toward,
        params_140: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        return rt::Scalar(1f32);
    }
    pub(crate) fn shadow_stage(&self, at_159: Entered, hit_69: Hit, light_24: Toward) -> f32 {
        rt::into(self.v_shadow_stage(at_159, hit_69, light_24))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_shadow_stage(&self, at_159: Entered, hit_69: Hit, light_24: Toward) -> rt::Scalar<f32> {
        let _e7 = rt::Scalar(self.surface_settings.choices[9usize].number);
        match rt::Scalar::into_inner(_e7) {
            0u32 => {
                let _e12 = self.surface_settings.choices[9usize].params;
                let _e13 = self.v_shadow_ray(at_159, hit_69, light_24, _e12);
                return _e13;
            }
            1u32 => {
                let _e18 = self.surface_settings.choices[9usize].params;
                let _e19 = self.v_shadow_none(at_159, hit_69, light_24, _e18);
                return _e19;
            }
            2u32 => {
                let _e24 = self.surface_settings.choices[9usize].params;
                let _e25 = self.v_shadow_entry(at_159, hit_69, light_24, _e24);
                return _e25;
            }
            3u32 => {
                let _e30 = self.surface_settings.choices[9usize].params;
                let _e31 = self.v_shadow_soft(at_159, hit_69, light_24, _e30);
                return _e31;
            }
            4u32 => {
                let _e36 = self.surface_settings.choices[9usize].params;
                let _e37 = self.v_shadow_heuristic(at_159, hit_69, light_24, _e36);
                return _e37;
            }
            5u32 => {
                let _e42 = self.surface_settings.choices[9usize].params;
                let _e43 = self.v_shadow_horizon(at_159, hit_69, light_24, _e42);
                return _e43;
            }
            6u32 => {
                let _e48 = self.surface_settings.choices[9usize].params;
                let _e49 = self.v_shadow_visibility(at_159, hit_69, light_24, _e48);
                return _e49;
            }
            7u32 => {
                let _e54 = self.surface_settings.choices[9usize].params;
                let _e55 = self.v_shadow_map(at_159, hit_69, light_24, _e54);
                return _e55;
            }
            _ => {
                let _e60 = self.surface_settings.choices[9usize].params;
                let _e61 = self.v_shadow_scene(at_159, hit_69, light_24, _e60);
                return _e61;
            }
        }
    }
    pub(crate) fn mirrored_light(&self, pixel_102: PixelIn, at_160: Entered, hit_70: Hit) -> f32 {
        rt::into(self.v_mirrored_light(pixel_102, at_160, hit_70))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_mirrored_light(&self, pixel_102: PixelIn, at_160: Entered, hit_70: Hit) -> rt::Scalar<f32> {
        if rt::Scalar::into_branch_condition(rt::Scalar(hit_70.found).elementwise_eq(rt::Scalar(0u32))) {
            return rt::Scalar(0f32);
        }
        let down_3 = pixel_102.direction.normalize();
        let up_7 = (down_3 - (at_160.normal * (rt::Scalar(2f32) * down_3.dot(at_160.normal))));
        let _e24 = self.v_shadow_stage(at_160, hit_70, <Toward>::new(up_7, rt::Scalar(1f32), rt::Scalar(300000000000000000000000000000000000000f32), (rt::Scalar(0.125f32) * down_3.x().abs()), rt::Scalar(0u32)));
        return _e24;
    }
    pub(crate) fn nothing_gathered(&self, reach_m_1: impl rt::Into<rt::Scalar<f32>>) -> Gathered {
        rt::into(self.v_nothing_gathered(rt::into(reach_m_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_nothing_gathered(&self, reach_m_1: rt::Scalar<f32>) -> Gathered {
        return <Gathered>::new(<rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32)), rt::Scalar(1f32), rt::Scalar(300000000000000000000000000000000000000f32), rt::Scalar(-300000000000000000000000000000000000000f32), reach_m_1, rt::Scalar(0f32));
    }
    pub(crate) fn object_blend_color(
        &self,
        at_161: Entered,
        hit_71: Hit,
        view_24: impl rt::Into<rt::Vec3<f32>>,
        params_141: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_object_blend_color(at_161, hit_71, rt::into(view_24), rt::into(params_141)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_object_blend_color(
        &self,
        at_161: Entered,
        hit_71: Hit,
        view_24: rt::Vec3<f32>,
        params_141: rt::Vec4<f32>,
    ) -> rt::Vec3<f32> {
        let _e5 = self.v_color_of_object(at_161, view_24, params_141.z());
        return _e5;
    }
    pub(crate) fn object_none_color(
        &self,
        at_162: Entered,
        hit_72: Hit,
        view_25: impl rt::Into<rt::Vec3<f32>>,
        params_142: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_object_none_color(at_162, hit_72, rt::into(view_25), rt::into(params_142)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_object_none_color(
        &self,
        at_162: Entered,
        hit_72: Hit,
        view_25: rt::Vec3<f32>,
        params_142: rt::Vec4<f32>,
    ) -> rt::Vec3<f32> {
        let _e6 = self.v_color_or_white(hit_72.uv, rt::Scalar(at_162.footprint));
        return _e6;
    }
    pub(crate) fn object_depth_color(
        &self,
        at_163: Entered,
        hit_73: Hit,
        view_26: impl rt::Into<rt::Vec3<f32>>,
        params_143: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_object_depth_color(at_163, hit_73, rt::into(view_26), rt::into(params_143)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_object_depth_color(
        &self,
        at_163: Entered,
        hit_73: Hit,
        view_26: rt::Vec3<f32>,
        params_143: rt::Vec4<f32>,
    ) -> rt::Vec3<f32> {
        let _e5 = self.v_color_of_object(at_163, view_26, params_143.z());
        return _e5;
    }
    pub(crate) fn object_hull_color(
        &self,
        at_164: Entered,
        hit_74: Hit,
        view_27: impl rt::Into<rt::Vec3<f32>>,
        params_144: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_object_hull_color(at_164, hit_74, rt::into(view_27), rt::into(params_144)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_object_hull_color(
        &self,
        at_164: Entered,
        hit_74: Hit,
        view_27: rt::Vec3<f32>,
        params_144: rt::Vec4<f32>,
    ) -> rt::Vec3<f32> {
        let _e5 = self.v_color_of_object(at_164, view_27, params_144.z());
        return _e5;
    }
    pub(crate) fn object_color_stage(
        &self,
        at_165: Entered,
        hit_75: Hit,
        view_28: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_object_color_stage(at_165, hit_75, rt::into(view_28)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_object_color_stage(
        &self,
        at_165: Entered,
        hit_75: Hit,
        view_28: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let _e7 = rt::Scalar(self.surface_settings.choices[3usize].number);
        match rt::Scalar::into_inner(_e7) {
            0u32 => {
                let _e12 = self.surface_settings.choices[3usize].params;
                let _e13 = self.v_object_none_color(at_165, hit_75, view_28, _e12);
                return _e13;
            }
            1u32 => {
                let _e18 = self.surface_settings.choices[3usize].params;
                let _e19 = self.v_object_depth_color(at_165, hit_75, view_28, _e18);
                return _e19;
            }
            2u32 => {
                let _e24 = self.surface_settings.choices[3usize].params;
                let _e25 = self.v_object_hull_color(at_165, hit_75, view_28, _e24);
                return _e25;
            }
            _ => {
                let _e30 = self.surface_settings.choices[3usize].params;
                let _e31 = self.v_object_blend_color(at_165, hit_75, view_28, _e30);
                return _e31;
            }
        }
    }
    pub(crate) fn occlusion_roughness_metalness(
        &self,
        uv_38: impl rt::Into<rt::Vec2<f32>>,
        footprint_4: impl rt::Into<rt::Scalar<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_occlusion_roughness_metalness(rt::into(uv_38), rt::into(footprint_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_occlusion_roughness_metalness(
        &self,
        uv_38: rt::Vec2<f32>,
        footprint_4: rt::Scalar<f32>,
    ) -> rt::Vec3<f32> {
        let _e4 = rt::Scalar(self.surface_settings.has_material);
        if rt::Scalar::into_branch_condition((_e4 & rt::Scalar(1u32)).elementwise_eq(rt::Scalar(0u32))) {
            return <rt::Vec3<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32), rt::Scalar(1f32));
        }
        let _e14 = self.v_material_layer(uv_38, footprint_4, rt::Scalar(0i32));
        return _e14;
    }
    pub(crate) fn parts_by_uv(
        &self,
        grid_12: Tessellation,
        along_19: impl rt::Into<rt::Vec2<f32>>,
        level_60: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_parts_by_uv(grid_12, rt::into(along_19), rt::into(level_60)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_parts_by_uv(
        &self,
        grid_12: Tessellation,
        along_19: rt::Vec2<f32>,
        level_60: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        let both_3 = (along_19 * grid_12.parts_of_uv);
        let parts_7 = ((both_3.x().max(both_3.y()) / (rt::Scalar(1u32) << level_60).to_f32()) - rt::Scalar(0.0009765625f32)).ceil();
        return parts_7.clamp(rt::Scalar(1f32), rt::Scalar(32767f32)).to_u32();
    }
    pub(crate) fn parts_by_voxels(
        &self,
        a_22: Voxel,
        b_22: Voxel,
        level_61: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_parts_by_voxels(a_22, b_22, rt::into(level_61)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_parts_by_voxels(
        &self,
        a_22: Voxel,
        b_22: Voxel,
        level_61: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        let _e4 = self.v_coarser_voxel(b_22.at, level_61);
        let _e6 = self.v_coarser_voxel(a_22.at, level_61);
        let _e8 = self.v_longest_of((_e4 - _e6));
        return _e8.to_u32().clamp(rt::Scalar(1u32), DICE_PARTS);
    }
    pub(crate) fn parts_between(
        &self,
        grid_13: Tessellation,
        a_23: Voxel,
        b_23: Voxel,
        along_20: impl rt::Into<rt::Vec2<f32>>,
        level_62: impl rt::Into<rt::Scalar<u32>>,
    ) -> u32 {
        rt::into(self.v_parts_between(grid_13, a_23, b_23, rt::into(along_20), rt::into(level_62)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_parts_between(
        &self,
        grid_13: Tessellation,
        a_23: Voxel,
        b_23: Voxel,
        along_20: rt::Vec2<f32>,
        level_62: rt::Scalar<u32>,
    ) -> rt::Scalar<u32> {
        if rt::Scalar::into_branch_condition(grid_13.parts_of_uv.x().elementwise_gt(rt::Scalar(0f32))) {
            let _e9 = self.v_parts_by_uv(grid_13, along_20, level_62);
            return _e9;
        }
        let _e10 = self.v_parts_by_voxels(a_23, b_23, level_62);
        return _e10;
    }
    pub(crate) fn pass_segment(
        &self,
        before_9: Gathered,
        pixel_103: PixelIn,
        at_166: Entered,
        k_48: impl rt::Into<rt::Scalar<u32>>,
    ) -> Gathered {
        rt::into(self.v_pass_segment(before_9, pixel_103, at_166, rt::into(k_48)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_pass_segment(
        &self,
        before_9: Gathered,
        pixel_103: PixelIn,
        at_166: Entered,
        k_48: rt::Scalar<u32>,
    ) -> Gathered {
        let mut seen_4: Gathered;

        let _e4 = self.v_segment_of(pixel_103, at_166, k_48);
        let _e7 = self.v_rest_of_segment(_e4, rt::Scalar(before_9.until_m), rt::Scalar(before_9.reach_m));
        if rt::Scalar::into_branch_condition((!rt::Scalar(_e7.exit).elementwise_gt(rt::Scalar(0f32)))) {
            return before_9;
        }
        seen_4 = before_9;
        rt::Scalar(seen_4.until_m) = (rt::Scalar(_e7.start) + rt::Scalar(_e7.exit));
        let _e19 = rt::Scalar(seen_4.transmittance);
        let _e20 = self.v_optical_depth(_e7);
        let _e21 = self.v_transmittance_of(_e20);
        rt::Scalar(seen_4.transmittance) = (_e19 * _e21);
        let _e23 = seen_4;
        return _e23;
    }
    pub(crate) fn pixel_eye(&self, pixel_104: impl rt::Into<rt::Vec2<f32>>) -> rt::Vec3<f32> {
        rt::into(self.v_pixel_eye(rt::into(pixel_104)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_pixel_eye(&self, pixel_104: rt::Vec2<f32>) -> rt::Vec3<f32> {
        let _e3 = self.frame.eye;
        let _e7 = self.frame.eye_right;
        let _e14 = self.frame.eye_down;
        return ((_e3.xyz() + (_e7.xyz() * pixel_104.x())) + (_e14.xyz() * pixel_104.y()));
    }
    pub(crate) fn pixel_of(
        &self,
        a_24: Corner,
        b_24: Corner,
        c_16: Corner,
        shell_4: Shell,
        side_4: impl rt::Into<rt::Scalar<f32>>,
        point_21: impl rt::Into<rt::Vec2<f32>>,
    ) -> PixelIn {
        rt::into(self.v_pixel_of(a_24, b_24, c_16, shell_4, rt::into(side_4), rt::into(point_21)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_pixel_of(
        &self,
        a_24: Corner,
        b_24: Corner,
        c_16: Corner,
        shell_4: Shell,
        side_4: rt::Scalar<f32>,
        point_21: rt::Vec2<f32>,
    ) -> PixelIn {
        let _e6 = self.v_pixel_eye(point_21);
        let _e7 = self.v_pixel_direction(point_21);
        return <PixelIn>::new(_e6, _e7, side_4, a_24, b_24, c_16, shell_4);
    }
    pub(crate) fn place_hit(
        &self,
        pixel_105: PixelIn,
        at_167: Entered,
        segment: impl rt::Into<rt::Scalar<u32>>,
        hit_76: Hit,
    ) -> Entered {
        rt::into(self.v_place_hit(pixel_105, at_167, rt::into(segment), hit_76))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_place_hit(
        &self,
        pixel_105: PixelIn,
        at_167: Entered,
        segment: rt::Scalar<u32>,
        hit_76: Hit,
    ) -> Entered {
        let _e4 = self.v_segment_of(pixel_105, at_167, segment);
        let _e5 = self.v_place_on_segment(pixel_105, at_167, _e4, hit_76);
        return _e5;
    }
    pub(crate) fn point_of_light(
        &self,
        at_168: Entered,
        hit_77: Hit,
        number_22: impl rt::Into<rt::Scalar<u32>>,
        k_49: impl rt::Into<rt::Scalar<u32>>,
        count_10: impl rt::Into<rt::Scalar<u32>>,
    ) -> Toward {
        rt::into(self.v_point_of_light(at_168, hit_77, rt::into(number_22), rt::into(k_49), rt::into(count_10)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_point_of_light(
        &self,
        at_168: Entered,
        hit_77: Hit,
        number_22: rt::Scalar<u32>,
        k_49: rt::Scalar<u32>,
        count_10: rt::Scalar<u32>,
    ) -> Toward {
        let _e6 = self.v_toward_light(number_22, at_168.point);
        if rt::Scalar::into_branch_condition(count_10.elementwise_gt(rt::Scalar(0u32))) {
            let _e9 = self.v_seed_of(hit_77);
            let _e10 = self.v_point_of_disc(_e6, _e9, k_49, count_10);
            return _e10;
        }
        return _e6;
    }
    pub(crate) fn primary_length(
        &self,
        start_5: impl rt::Into<rt::Vec3<i32>>,
        to_2: impl rt::Into<rt::Vec3<i32>>,
        third_1: impl rt::Into<rt::Vec3<i32>>,
    ) -> i32 {
        rt::into(self.v_primary_length(rt::into(start_5), rt::into(to_2), rt::into(third_1)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_primary_length(
        &self,
        start_5: rt::Vec3<i32>,
        to_2: rt::Vec3<i32>,
        third_1: rt::Vec3<i32>,
    ) -> rt::Scalar<i32> {
        let mut local_140: rt::Scalar<bool>;

        let _e3 = self.v_main_axis(start_5, to_2);
        let _e4 = self.v_axis_of(start_5, _e3);
        let _e5 = self.v_axis_of(to_2, _e3);
        let _e6 = self.v_axis_of(third_1, _e3);
        if rt::Scalar::into_branch_condition(_e4.min(_e5).elementwise_le(_e6)) {
            local_140 = _e6.elementwise_le(_e4.max(_e5));
        } else {
            local_140 = rt::Scalar(false);
        }
        let is_primary = local_140;
        return ((_e5 - _e4).abs() + rt::Scalar(0i32).select(rt::Scalar(1048576i32), is_primary));
    }
    pub(crate) fn procedure_bumps(
        &self,
        place_34: impl rt::Into<rt::Vec2<f32>>,
        time: impl rt::Into<rt::Scalar<f32>>,
        seed_5: impl rt::Into<rt::Scalar<u32>>,
        params_145: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_procedure_bumps(rt::into(place_34), rt::into(time), rt::into(seed_5), rt::into(params_145)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_procedure_bumps(
        &self,
        place_34: rt::Vec2<f32>,
        time: rt::Scalar<f32>,
        seed_5: rt::Scalar<u32>,
        params_145: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        let mut height_15: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut k_50: rt::Scalar<u32> = rt::Scalar(0u32);

        let at_190 = (place_34 * params_145.x());
        let own_1 = at_190.floor();
        'naga_break: loop {
            'naga_continue: {
                let _e11 = k_50;
                if rt::Scalar::into_branch_condition(_e11.elementwise_lt(rt::Scalar(9u32))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e14 = k_50;
                    let _e18 = k_50;
                    let cell_47 = ((own_1 + <rt::Vec2<f32>>::from_scalars((_e14 % rt::Scalar(3u32)).to_f32(), (_e18 / rt::Scalar(3u32)).to_f32())) - <rt::Vec2<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32)));
                    let _e29 = self.v_bits_of_point(cell_47, params_145.x(), seed_5);
                    let _e30 = self.v_unit_of(_e29);
                    let _e33 = self.v_mixed((_e29 + rt::Scalar(1u32)));
                    let _e34 = self.v_unit_of(_e33);
                    let beside_10 = (<rt::Vec2<f32>>::from_scalars(_e30, _e34) - <rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32)));
                    let middle_18 = ((cell_47 + <rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32))) + (beside_10 * (rt::Scalar(0.5f32) * params_145.z())));
                    let away_2 = ((at_190 - middle_18) / rt::Vec2::splat_from_scalar(params_145.y()));
                    let _e55 = self.v_mixed((_e29 + rt::Scalar(2u32)));
                    let _e56 = self.v_unit_of(_e55);
                    let _e58 = self.v_sine_of((time + _e56));
                    let wave = (rt::Scalar(0.5f32) + (rt::Scalar(0.5f32) * _e58));
                    let high_9 = (rt::Scalar(0.3f32) + (rt::Scalar(0.7f32) * wave));
                    let _e67 = height_15;
                    height_15 = _e67.max((high_9 * (rt::Scalar(1f32) - away_2.dot(away_2)).max(rt::Scalar(0f32)).sqrt()));
                    let _e76 = k_50;
                    k_50 = (_e76 + rt::Scalar(1u32));
                }
            }
        }
        let _e79 = height_15;
        return _e79;
    }
    pub(crate) fn procedure_fbm(
        &self,
        place_35: impl rt::Into<rt::Vec2<f32>>,
        time_1: impl rt::Into<rt::Scalar<f32>>,
        seed_6: impl rt::Into<rt::Scalar<u32>>,
        params_146: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_procedure_fbm(rt::into(place_35), rt::into(time_1), rt::into(seed_6), rt::into(params_146)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_procedure_fbm(
        &self,
        place_35: rt::Vec2<f32>,
        time_1: rt::Scalar<f32>,
        seed_6: rt::Scalar<u32>,
        params_146: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        let mut height_16: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut sum_6: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut strength: rt::Scalar<f32> = rt::Scalar(1f32);
        let mut count_11: rt::Scalar<f32>;
        let mut octave: rt::Scalar<u32> = rt::Scalar(0u32);

        count_11 = params_146.x();
        'naga_break: loop {
            'naga_continue: {
                let _e14 = octave;
                if rt::Scalar::into_branch_condition(_e14.to_f32().elementwise_lt(params_146.y())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e18 = octave;
                    let turns_3 = (time_1 * (_e18 + rt::Scalar(1u32)).to_f32());
                    let _e23 = height_16;
                    let _e24 = strength;
                    let _e25 = count_11;
                    let _e27 = count_11;
                    let _e28 = octave;
                    let _e30 = self.v_gradient_noise((place_35 * _e25), _e27, turns_3, (seed_6 + _e28));
                    height_16 = (_e23 + (_e24 * _e30));
                    let _e33 = sum_6;
                    let _e34 = strength;
                    sum_6 = (_e33 + _e34);
                    let _e36 = strength;
                    strength = (_e36 * params_146.z());
                    let _e39 = count_11;
                    count_11 = (_e39 * rt::Scalar(2f32));
                    let _e42 = octave;
                    octave = (_e42 + rt::Scalar(1u32));
                }
            }
        }
        let _e45 = height_16;
        let _e48 = sum_6;
        return (rt::Scalar(0.5f32) + ((rt::Scalar(0.5f32) * _e45) / (_e48 * rt::Scalar(0.7071068f32))));
    }
    pub(crate) fn procedure_waves(
        &self,
        place_36: impl rt::Into<rt::Vec2<f32>>,
        time_2: impl rt::Into<rt::Scalar<f32>>,
        seed_7: impl rt::Into<rt::Scalar<u32>>,
        params_147: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_procedure_waves(rt::into(place_36), rt::into(time_2), rt::into(seed_7), rt::into(params_147)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_procedure_waves(
        &self,
        place_36: rt::Vec2<f32>,
        time_2: rt::Scalar<f32>,
        seed_7: rt::Scalar<u32>,
        params_147: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        let mut height_17: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut sum_7: rt::Scalar<f32> = rt::Scalar(0f32);
        let mut k_51: rt::Scalar<u32> = rt::Scalar(0u32);

        'naga_break: loop {
            'naga_continue: {
                let _e10 = k_51;
                if rt::Scalar::into_branch_condition(_e10.to_f32().elementwise_lt(params_147.y())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e15 = k_51;
                    let _e18 = self.v_mixed((seed_7 + (rt::Scalar(4u32) * _e15)));
                    let _e19 = k_51;
                    let part_40 = (_e19.to_f32() / params_147.y());
                    let size_8 = (params_147.x() * (rt::Scalar(1f32) + ((rt::Scalar(6f32) * part_40) * part_40)));
                    let along_50 = (size_8 + rt::Scalar(0.5f32)).floor().max(rt::Scalar(1f32));
                    let _e39 = self.v_unit_of(_e18);
                    let across_13 = ((((rt::Scalar(2f32) * size_8) * params_147.z()) * (_e39 - rt::Scalar(0.5f32))) + rt::Scalar(0.5f32)).floor();
                    let length = ((along_50 * along_50) + (across_13 * across_13)).sqrt();
                    let pace_1 = ((rt::Scalar(2f32) * (length / params_147.x()).sqrt()) + rt::Scalar(0.5f32)).floor().max(rt::Scalar(1f32));
                    let _e62 = self.v_mixed((_e18 + rt::Scalar(1u32)));
                    let _e63 = self.v_unit_of(_e62);
                    let _e72 = self.v_sine_of(((((along_50 * place_36.x()) + (across_13 * place_36.y())) - (pace_1 * time_2)) + _e63));
                    let crest = (rt::Scalar(0.5f32) + (rt::Scalar(0.5f32) * _e72));
                    let _e77 = height_17;
                    height_17 = (_e77 + ((crest + (params_147.w() * ((crest * crest) - crest))) / length));
                    let _e85 = sum_7;
                    sum_7 = (_e85 + (rt::Scalar(1f32) / length));
                    let _e89 = k_51;
                    k_51 = (_e89 + rt::Scalar(1u32));
                }
            }
        }
        let _e92 = height_17;
        let _e93 = sum_7;
        return (_e92 / _e93);
    }
    pub(crate) fn procedure_height(
        &self,
        number_23: impl rt::Into<rt::Scalar<u32>>,
        place_37: impl rt::Into<rt::Vec2<f32>>,
        time_3: impl rt::Into<rt::Scalar<f32>>,
        seed_8: impl rt::Into<rt::Scalar<u32>>,
        params_148: impl rt::Into<rt::Vec4<f32>>,
    ) -> f32 {
        rt::into(self.v_procedure_height(rt::into(number_23), rt::into(place_37), rt::into(time_3), rt::into(seed_8), rt::into(params_148)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_procedure_height(
        &self,
        number_23: rt::Scalar<u32>,
        place_37: rt::Vec2<f32>,
        time_3: rt::Scalar<f32>,
        seed_8: rt::Scalar<u32>,
        params_148: rt::Vec4<f32>,
    ) -> rt::Scalar<f32> {
        match rt::Scalar::into_inner(number_23) {
            0u32 => {
                let _e5 = self.v_procedure_waves(place_37, time_3, seed_8, params_148);
                return _e5;
            }
            1u32 => {
                let _e6 = self.v_procedure_fbm(place_37, time_3, seed_8, params_148);
                return _e6;
            }
            _ => {
                let _e7 = self.v_procedure_bumps(place_37, time_3, seed_8, params_148);
                return _e7;
            }
        }
    }
    pub(crate) fn quotient_near(
        &self,
        dividend_1: impl rt::Into<rt::Scalar<i32>>,
        by_2: impl rt::Into<rt::Scalar<i32>>,
    ) -> i32 {
        rt::into(self.v_quotient_near(rt::into(dividend_1), rt::into(by_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_quotient_near(
        &self,
        dividend_1: rt::Scalar<i32>,
        by_2: rt::Scalar<i32>,
    ) -> rt::Scalar<i32> {
        let doubled_1 = ((rt::Scalar(2i32) * dividend_1) + by_2);
        let whole_4 = (doubled_1 / (rt::Scalar(2i32) * by_2));
        return whole_4.select((whole_4 - rt::Scalar(1i32)), ((whole_4 * rt::Scalar(2i32)) * by_2).elementwise_gt(doubled_1));
    }
    pub(crate) fn ray_to_light(
        &self,
        at_169: Entered,
        hit_78: Hit,
        number_24: impl rt::Into<rt::Scalar<u32>>,
        k_52: impl rt::Into<rt::Scalar<u32>>,
        count_12: impl rt::Into<rt::Scalar<u32>>,
    ) -> LightRay {
        rt::into(self.v_ray_to_light(at_169, hit_78, rt::into(number_24), rt::into(k_52), rt::into(count_12)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_ray_to_light(
        &self,
        at_169: Entered,
        hit_78: Hit,
        number_24: rt::Scalar<u32>,
        k_52: rt::Scalar<u32>,
        count_12: rt::Scalar<u32>,
    ) -> LightRay {
        let _e5 = self.v_point_of_light(at_169, hit_78, number_24, k_52, count_12);
        let _e6 = self.v_field_light_ray_stage(at_169, hit_78, _e5);
        return _e6;
    }
    pub(crate) fn reach_of_hit(
        &self,
        found_17: impl rt::Into<rt::Scalar<u32>>,
        depth_10: impl rt::Into<rt::Scalar<f32>>,
        direction_7: impl rt::Into<rt::Vec3<f32>>,
    ) -> f32 {
        rt::into(self.v_reach_of_hit(rt::into(found_17), rt::into(depth_10), rt::into(direction_7)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_reach_of_hit(
        &self,
        found_17: rt::Scalar<u32>,
        depth_10: rt::Scalar<f32>,
        direction_7: rt::Vec3<f32>,
    ) -> rt::Scalar<f32> {
        return rt::Scalar(300000000000000000000000000000000000000f32).select((depth_10 * direction_7.length()), found_17.elementwise_eq(rt::Scalar(1u32)));
    }
    pub(crate) fn shade_blinn_phong_material(
        &self,
        at_170: Entered,
        hit_79: Hit,
        normal_22: impl rt::Into<rt::Vec3<f32>>,
        mean_3: impl rt::Into<rt::Scalar<f32>>,
        view_29: impl rt::Into<rt::Vec3<f32>>,
        color_1: impl rt::Into<rt::Vec3<f32>>,
        params_149: impl rt::Into<rt::Vec4<f32>>,
    ) -> Material {
        rt::into(self.v_shade_blinn_phong_material(at_170, hit_79, rt::into(normal_22), rt::into(mean_3), rt::into(view_29), rt::into(color_1), rt::into(params_149)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shade_blinn_phong_material(
        &self,
        at_170: Entered,
        hit_79: Hit,
        normal_22: rt::Vec3<f32>,
        mean_3: rt::Scalar<f32>,
        view_29: rt::Vec3<f32>,
        color_1: rt::Vec3<f32>,
        params_149: rt::Vec4<f32>,
    ) -> Material {
        let transmission = rt::Scalar(self.surface_settings.transmission);
        let _e12 = self.surface_settings.diffuse;
        let diffuse = ((_e12.xyz() * color_1) * (rt::Scalar(1f32) - transmission));
        let none_4 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
        let transmitted = <rt::Vec3<f32>>::from_scalars(transmission, transmission, transmission);
        let _e25 = self.surface_settings.specular;
        let specular_1 = _e25.xyz();
        return <Material>::new(diffuse, transmitted, specular_1, diffuse, none_4, rt::Scalar(1f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
    }
    pub(crate) fn shade_metallic_roughness_material(
        &self,
        at_171: Entered,
        hit_80: Hit,
        normal_23: impl rt::Into<rt::Vec3<f32>>,
        mean_4: impl rt::Into<rt::Scalar<f32>>,
        view_30: impl rt::Into<rt::Vec3<f32>>,
        color_2: impl rt::Into<rt::Vec3<f32>>,
        params_150: impl rt::Into<rt::Vec4<f32>>,
    ) -> Material {
        rt::into(self.v_shade_metallic_roughness_material(at_171, hit_80, rt::into(normal_23), rt::into(mean_4), rt::into(view_30), rt::into(color_2), rt::into(params_150)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_shade_metallic_roughness_material(
        &self,
        at_171: Entered,
        hit_80: Hit,
        normal_23: rt::Vec3<f32>,
        mean_4: rt::Scalar<f32>,
        view_30: rt::Vec3<f32>,
        color_2: rt::Vec3<f32>,
        params_150: rt::Vec4<f32>,
    ) -> Material {
        let mut roughness_1: rt::Scalar<f32>;
        let mut alpha_1: rt::Scalar<f32>;
        let mut squared_alpha: rt::Scalar<f32>;

        let _e9 = self.v_occlusion_roughness_metalness(hit_80.uv, rt::Scalar(at_171.footprint));
        let _e12 = rt::Scalar(self.surface_settings.roughness);
        roughness_1 = (_e12 * _e9.y()).max(rt::Scalar(0.045f32));
        let _e20 = rt::Scalar(self.surface_settings.metallic);
        let metallic = (_e20 * _e9.z());
        let _e25 = self.surface_settings.diffuse;
        let base_6 = (_e25.xyz() * color_2);
        let transmission_1 = rt::Scalar(self.surface_settings.transmission);
        let diffuse_1 = (base_6 * ((rt::Scalar(1f32) - metallic) * (rt::Scalar(1f32) - transmission_1)));
        let transmitted_1 = (base_6 * ((rt::Scalar(1f32) - metallic) * transmission_1));
        let _e43 = self.surface_settings.specular;
        let dielectric = _e43.xyz();
        let specular_2 = (dielectric + ((base_6 - dielectric).max(<rt::Vec3<f32>>::from_scalars(rt::Scalar(-1f32), rt::Scalar(-1f32), rt::Scalar(-1f32))) * metallic));
        let _e53 = roughness_1;
        let _e54 = roughness_1;
        alpha_1 = (_e53 * _e54);
        let _e57 = alpha_1;
        let _e58 = alpha_1;
        squared_alpha = (_e57 * _e58);
        if rt::Scalar::into_branch_condition(mean_4.elementwise_lt(rt::Scalar(1f32))) {
            let _e63 = squared_alpha;
            squared_alpha = (_e63 + ((rt::Scalar(2f32) * (rt::Scalar(1f32) - mean_4)) / mean_4)).min(rt::Scalar(1f32));
            let _e72 = squared_alpha;
            alpha_1 = _e72.sqrt();
            let _e74 = alpha_1;
            roughness_1 = _e74.sqrt();
        }
        let upright_5 = normal_23.dot(view_30).max(rt::Scalar(0.0001f32));
        let aside_13 = (rt::Scalar(1f32) - (upright_5 * upright_5)).max(rt::Scalar(0f32));
        let _e85 = squared_alpha;
        let masking = ((upright_5 * upright_5) + (_e85 * aside_13)).sqrt();
        let _e89 = alpha_1;
        let _e90 = roughness_1;
        let _e91 = self.v_facet_reflection(upright_5, _e89, _e90);
        let again = ((rt::Scalar(1f32) / _e91.x()) - rt::Scalar(1f32)).max(rt::Scalar(0f32));
        let white_2 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32), rt::Scalar(1f32));
        let _e103 = self.v_reflected_by(_e91, specular_2);
        let reflected_1 = (_e103 * (white_2 + (specular_2 * again)));
        let _e117 = self.v_emission_at(hit_80.uv, rt::Scalar(at_171.footprint));
        let _e119 = roughness_1;
        let _e120 = alpha_1;
        let _e121 = squared_alpha;
        return <Material>::new(diffuse_1, transmitted_1, specular_2, (reflected_1 + (diffuse_1 * (white_2 - reflected_1).max(<rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32))))), _e117, _e9.x(), _e119, _e120, _e121, upright_5, masking, again);
    }
    pub(crate) fn shade_material_stage(
        &self,
        at_172: Entered,
        hit_81: Hit,
        normal_24: impl rt::Into<rt::Vec3<f32>>,
        mean_5: impl rt::Into<rt::Scalar<f32>>,
        view_31: impl rt::Into<rt::Vec3<f32>>,
        color_3: impl rt::Into<rt::Vec3<f32>>,
    ) -> Material {
        rt::into(self.v_shade_material_stage(at_172, hit_81, rt::into(normal_24), rt::into(mean_5), rt::into(view_31), rt::into(color_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shade_material_stage(
        &self,
        at_172: Entered,
        hit_81: Hit,
        normal_24: rt::Vec3<f32>,
        mean_5: rt::Scalar<f32>,
        view_31: rt::Vec3<f32>,
        color_3: rt::Vec3<f32>,
    ) -> Material {
        let _e10 = rt::Scalar(self.surface_settings.choices[8usize].number);
        match rt::Scalar::into_inner(_e10) {
            0u32 => {
                let _e15 = self.surface_settings.choices[8usize].params;
                let _e16 = self.v_shade_blinn_phong_material(at_172, hit_81, normal_24, mean_5, view_31, color_3, _e15);
                return _e16;
            }
            _ => {
                let _e21 = self.surface_settings.choices[8usize].params;
                let _e22 = self.v_shade_metallic_roughness_material(at_172, hit_81, normal_24, mean_5, view_31, color_3, _e21);
                return _e22;
            }
        }
    }
    pub(crate) fn table_cosine(
        &self,
        table_1: SeenTable,
        toward_3: impl rt::Into<rt::Vec3<f32>>,
    ) -> f32 {
        rt::into(self.v_table_cosine(table_1, rt::into(toward_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_table_cosine(
        &self,
        table_1: SeenTable,
        toward_3: rt::Vec3<f32>,
    ) -> rt::Scalar<f32> {
        let mean_14 = table_1.mean.dot(toward_3);
        let squares_1 = table_1.squares.dot((toward_3 * toward_3)).min(rt::Scalar(16f32));
        let pairs = <rt::Vec3<f32>>::from_scalars((toward_3.x() * toward_3.y()), (toward_3.x() * toward_3.z()), (toward_3.y() * toward_3.z()));
        let products = (rt::Scalar(2f32) * table_1.products.dot(pairs)).min(rt::Scalar(16f32));
        let deviation_1 = ((squares_1 + products) - (mean_14 * mean_14)).max(rt::Scalar(0f32)).sqrt();
        let inner_1 = (deviation_1 * rt::Scalar(0.7419638f32));
        let outer_1 = (deviation_1 * rt::Scalar(2.3344142f32));
        let four_2 = <rt::Vec4<f32>>::from_scalars((mean_14 + inner_1), (mean_14 - inner_1), (mean_14 + outer_1), (mean_14 - outer_1));
        return four_2.max(<rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32))).dot(PARTS_OF_FOUR);
    }
    pub(crate) fn seen_cosine(
        &self,
        at_173: Entered,
        seen_5: SeenNormals,
        toward_4: impl rt::Into<rt::Vec3<f32>>,
    ) -> f32 {
        rt::into(self.v_seen_cosine(at_173, seen_5, rt::into(toward_4)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_seen_cosine(
        &self,
        at_173: Entered,
        seen_5: SeenNormals,
        toward_4: rt::Vec3<f32>,
    ) -> rt::Scalar<f32> {
        let mut cosine_6: rt::Scalar<f32>;

        if rt::Scalar::into_branch_condition(rt::Scalar(seen_5.differ).elementwise_eq(rt::Scalar(0u32))) {
            return seen_5.normal.dot(toward_4).max(rt::Scalar(0f32));
        }
        let _e10 = self.v_to_tangent_space(at_173, toward_4);
        let middle_19 = seen_5.middle.dot(_e10);
        let _e17 = self.v_facing_four(middle_19, seen_5.along.dot(_e10), seen_5.across.dot(_e10));
        let one_3 = (rt::Scalar(seen_5.middle_seen) * middle_19.max(rt::Scalar(0f32))).min(rt::Scalar(1000000f32));
        let others = seen_5.others_seen.dot(_e17).min(rt::Scalar(1000000f32));
        let _e28 = self.v_mean_of_five(one_3, others);
        cosine_6 = _e28;
        if rt::Scalar::into_branch_condition(rt::Scalar(seen_5.table_part).elementwise_gt(rt::Scalar(0f32))) {
            let _e33 = cosine_6;
            let _e35 = self.v_table_cosine(seen_5.table, _e10);
            let _e36 = cosine_6;
            cosine_6 = (_e33 + ((_e35 - _e36) * rt::Scalar(seen_5.table_part)));
        }
        let _e43 = rt::Scalar(self.surface_settings.has_shadows);
        if rt::Scalar::into_branch_condition(_e43.elementwise_eq(rt::Scalar(1u32))) {
            let falls_1 = (_e10.z() - _e10.xy().dot(seen_5.slope));
            let _e59 = self.v_facing_four(falls_1, (-_e10.xy().dot(seen_5.slope_along)), (-_e10.xy().dot(seen_5.slope_across)));
            let _e62 = self.v_sum_of_four(_e59);
            let _e63 = self.v_mean_of_five(falls_1.max(rt::Scalar(0f32)), _e62);
            let lit = (falls_1.max(rt::Scalar(0f32)) / _e63.max(rt::Scalar(0.001f32)));
            let _e69 = cosine_6;
            return (_e69 * (rt::Scalar(1f32) - ((rt::Scalar(1f32) - lit) * rt::Scalar(seen_5.upright))));
        }
        let _e77 = cosine_6;
        return _e77;
    }
    pub(crate) fn whole_power(
        &self,
        base: impl rt::Into<rt::Scalar<f32>>,
        exponent_2: impl rt::Into<rt::Scalar<u32>>,
    ) -> f32 {
        rt::into(self.v_whole_power(rt::into(base), rt::into(exponent_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_whole_power(
        &self,
        base: rt::Scalar<f32>,
        exponent_2: rt::Scalar<u32>,
    ) -> rt::Scalar<f32> {
        let mut result: rt::Scalar<f32> = rt::Scalar(1f32);
        let mut square_2: rt::Scalar<f32>;
        let mut rest_3: rt::Scalar<u32>;

        square_2 = base;
        rest_3 = exponent_2;
        'naga_break: loop {
            'naga_continue: {
                let _e6 = rest_3;
                if rt::Scalar::into_branch_condition(_e6.elementwise_gt(rt::Scalar(0u32))) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e9 = rest_3;
                    if rt::Scalar::into_branch_condition((_e9 & rt::Scalar(1u32)).elementwise_eq(rt::Scalar(1u32))) {
                        let _e14 = result;
                        let _e15 = square_2;
                        result = (_e14 * _e15);
                    }
                    let _e17 = square_2;
                    let _e18 = square_2;
                    square_2 = (_e17 * _e18);
                    let _e20 = rest_3;
                    rest_3 = (_e20 >> rt::Scalar(1u32));
                }
            }
        }
        let _e23 = result;
        return _e23;
    }
    pub(crate) fn shade_blinn_phong_light(
        &self,
        material_11: Material,
        normal_25: impl rt::Into<rt::Vec3<f32>>,
        mean_6: impl rt::Into<rt::Scalar<f32>>,
        cosine_7: impl rt::Into<rt::Scalar<f32>>,
        view_32: impl rt::Into<rt::Vec3<f32>>,
        toward_5: impl rt::Into<rt::Vec3<f32>>,
        params_151: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_shade_blinn_phong_light(material_11, rt::into(normal_25), rt::into(mean_6), rt::into(cosine_7), rt::into(view_32), rt::into(toward_5), rt::into(params_151)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_shade_blinn_phong_light(
        &self,
        material_11: Material,
        normal_25: rt::Vec3<f32>,
        mean_6: rt::Scalar<f32>,
        cosine_7: rt::Scalar<f32>,
        view_32: rt::Vec3<f32>,
        toward_5: rt::Vec3<f32>,
        params_151: rt::Vec4<f32>,
    ) -> rt::Vec3<f32> {
        let mut exponent_3: rt::Scalar<u32>;
        let mut dimmed: rt::Scalar<f32> = rt::Scalar(1f32);

        if rt::Scalar::into_branch_condition(cosine_7.elementwise_gt(rt::Scalar(0f32))) {
            let _e11 = rt::Scalar(self.surface_settings.shininess);
            exponent_3 = _e11;
            if rt::Scalar::into_branch_condition(mean_6.elementwise_lt(rt::Scalar(1f32))) {
                let _e19 = rt::Scalar(self.surface_settings.shininess);
                let sharp = _e19.to_f32();
                let wide_3 = ((sharp * mean_6) / (mean_6 + (sharp * (rt::Scalar(1f32) - mean_6)))).floor().max(rt::Scalar(1f32));
                exponent_3 = wide_3.to_u32();
                dimmed = ((wide_3 + rt::Scalar(8f32)) / (sharp + rt::Scalar(8f32)));
            }
            let lobe = normal_25.dot((toward_5 + view_32).normalize()).max(rt::Scalar(0f32));
            let _e42 = exponent_3;
            let _e43 = self.v_whole_power(lobe, _e42);
            let _e44 = dimmed;
            let specular_3 = (material_11.specular * (_e43 * _e44));
            return ((material_11.diffuse * cosine_7) + specular_3);
        }
        return <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
    }
    pub(crate) fn shade_metallic_roughness_light(
        &self,
        material_12: Material,
        normal_26: impl rt::Into<rt::Vec3<f32>>,
        mean_7: impl rt::Into<rt::Scalar<f32>>,
        cosine_8: impl rt::Into<rt::Scalar<f32>>,
        view_33: impl rt::Into<rt::Vec3<f32>>,
        toward_6: impl rt::Into<rt::Vec3<f32>>,
        params_152: impl rt::Into<rt::Vec4<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_shade_metallic_roughness_light(material_12, rt::into(normal_26), rt::into(mean_7), rt::into(cosine_8), rt::into(view_33), rt::into(toward_6), rt::into(params_152)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_shade_metallic_roughness_light(
        &self,
        material_12: Material,
        normal_26: rt::Vec3<f32>,
        mean_7: rt::Scalar<f32>,
        cosine_8: rt::Scalar<f32>,
        view_33: rt::Vec3<f32>,
        toward_6: rt::Vec3<f32>,
        params_152: rt::Vec4<f32>,
    ) -> rt::Vec3<f32> {
        if rt::Scalar::into_branch_condition(cosine_8.elementwise_gt(rt::Scalar(0f32))) {
            let sum_15 = (toward_6 + view_33);
            let squared_sum = sum_15.dot(sum_15).max(rt::Scalar(0.000001f32));
            let along_51 = normal_26.dot(sum_15);
            let across_14 = normal_26.cross(sum_15);
            let a_49 = rt::Scalar(material_12.squared_alpha);
            let spread_1 = ((((along_51 * along_51) * a_49) + across_14.dot(across_14)) / squared_sum);
            let shadowing = ((cosine_8 * cosine_8) + (a_49 * (rt::Scalar(1f32) - (cosine_8 * cosine_8)).max(rt::Scalar(0f32)))).sqrt();
            let visible_3 = ((cosine_8 * rt::Scalar(material_12.masking)) + (rt::Scalar(material_12.upright) * shadowing));
            let facets = ((rt::Scalar(0.5f32) * a_49) / ((spread_1 * spread_1) * visible_3));
            let rest_14 = (rt::Scalar(1f32) - (rt::Scalar(0.5f32) * squared_sum.sqrt())).max(rt::Scalar(0f32));
            let squared_rest = (rest_14 * rest_14);
            let white_3 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(1f32), rt::Scalar(1f32), rt::Scalar(1f32));
            let more_1 = (white_3 - material_12.specular).max(<rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32)));
            let fresnel_1 = (material_12.specular + (more_1 * ((squared_rest * squared_rest) * rest_14)));
            let specular_4 = ((fresnel_1 * (white_3 + (material_12.specular * rt::Scalar(material_12.again)))) * facets);
            return (((material_12.diffuse * (white_3 - fresnel_1)) + specular_4) * cosine_8);
        }
        return <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
    }
    pub(crate) fn shade_light_stage(
        &self,
        material_13: Material,
        normal_27: impl rt::Into<rt::Vec3<f32>>,
        mean_8: impl rt::Into<rt::Scalar<f32>>,
        cosine_9: impl rt::Into<rt::Scalar<f32>>,
        view_34: impl rt::Into<rt::Vec3<f32>>,
        toward_7: impl rt::Into<rt::Vec3<f32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_shade_light_stage(material_13, rt::into(normal_27), rt::into(mean_8), rt::into(cosine_9), rt::into(view_34), rt::into(toward_7)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shade_light_stage(
        &self,
        material_13: Material,
        normal_27: rt::Vec3<f32>,
        mean_8: rt::Scalar<f32>,
        cosine_9: rt::Scalar<f32>,
        view_34: rt::Vec3<f32>,
        toward_7: rt::Vec3<f32>,
    ) -> rt::Vec3<f32> {
        let _e10 = rt::Scalar(self.surface_settings.choices[8usize].number);
        match rt::Scalar::into_inner(_e10) {
            0u32 => {
                let _e15 = self.surface_settings.choices[8usize].params;
                let _e16 = self.v_shade_blinn_phong_light(material_13, normal_27, mean_8, cosine_9, view_34, toward_7, _e15);
                return _e16;
            }
            _ => {
                let _e21 = self.surface_settings.choices[8usize].params;
                let _e22 = self.v_shade_metallic_roughness_light(material_13, normal_27, mean_8, cosine_9, view_34, toward_7, _e21);
                return _e22;
            }
        }
    }
    pub(crate) fn reflected_light(
        &self,
        at_174: Entered,
        hit_82: Hit,
        seen_6: SeenNormals,
        view_35: impl rt::Into<rt::Vec3<f32>>,
        color_4: impl rt::Into<rt::Vec3<f32>>,
        visible: [rt::Vec4<f32>; 8],
    ) -> rt::Vec3<f32> {
        rt::into(self.v_reflected_light(at_174, hit_82, seen_6, rt::into(view_35), rt::into(color_4), visible))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_reflected_light(
        &self,
        at_174: Entered,
        hit_82: Hit,
        seen_6: SeenNormals,
        view_35: rt::Vec3<f32>,
        color_4: rt::Vec3<f32>,
        visible: [rt::Vec4<f32>; 8],
    ) -> rt::Vec3<f32> {
        let mut light_25: rt::Vec3<f32>;
        let mut k_53: rt::Scalar<u32> = rt::Scalar(0u32);

        let _e8 = self.v_shade_material_stage(at_174, hit_82, seen_6.normal, rt::Scalar(seen_6.length), view_35, color_4);
        let _e12 = self.v_ambient_stage(at_174, hit_82, (seen_6.normal * rt::Scalar(seen_6.length)), view_35, _e8);
        light_25 = ((_e12 * rt::Scalar(_e8.occlusion)) + _e8.emission);
        'naga_break: loop {
            'naga_continue: {
                let _e20 = k_53;
                let _e23 = rt::Scalar(self.frame.light_count);
                if rt::Scalar::into_branch_condition(_e20.elementwise_lt(_e23)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e25 = k_53;
                    let _e27 = self.v_toward_light(_e25, at_174.point);
                    let _e29 = self.v_seen_cosine(at_174, seen_6, _e27.direction);
                    let _e33 = self.v_shade_light_stage(_e8, seen_6.normal, rt::Scalar(seen_6.length), _e29, view_35, _e27.direction);
                    let _e34 = light_25;
                    let _e37 = k_53;
                    let _e40 = self.frame.lights[rt::Scalar::into_array_index(_e37)].color;
                    let _e44 = k_53;
                    light_25 = (_e34 + ((_e33 * _e40.xyz()) * (rt::Scalar(_e27.falloff) * visible[rt::Scalar::into_array_index(_e44)].x())));
                    let _e50 = k_53;
                    k_53 = (_e50 + rt::Scalar(1u32));
                }
            }
        }
        let _e53 = light_25;
        return _e53;
    }
    pub(crate) fn roof_left(&self, sweep_6: Sweep, column_3: SweptColumn) -> i32 {
        rt::into(self.v_roof_left(sweep_6, column_3))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_roof_left(&self, sweep_6: Sweep, column_3: SweptColumn) -> rt::Scalar<i32> {
        return (sweep_6.parts.x() - rt::Scalar(column_3.from_top)).max(rt::Scalar(1i32));
    }
    pub(crate) fn seen_along(
        &self,
        at_175: impl rt::Into<rt::Vec3<i32>>,
        axis_5: impl rt::Into<rt::Scalar<u32>>,
    ) -> rt::Vec3<i32> {
        rt::into(self.v_seen_along(rt::into(at_175), rt::into(axis_5)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_seen_along(
        &self,
        at_175: rt::Vec3<i32>,
        axis_5: rt::Scalar<u32>,
    ) -> rt::Vec3<i32> {
        if rt::Scalar::into_branch_condition(axis_5.elementwise_eq(rt::Scalar(0u32))) {
            return at_175;
        }
        if rt::Scalar::into_branch_condition(axis_5.elementwise_eq(rt::Scalar(1u32))) {
            return <rt::Vec3<i32>>::from_scalars(at_175.y(), at_175.z(), at_175.x());
        }
        return <rt::Vec3<i32>>::from_scalars(at_175.z(), at_175.x(), at_175.y());
    }
    pub(crate) fn seen_through(
        &self,
        behind: impl rt::Into<rt::Vec4<f32>>,
        seen_7: Gathered,
    ) -> rt::Vec4<f32> {
        rt::into(self.v_seen_through(rt::into(behind), seen_7))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_seen_through(
        &self,
        behind: rt::Vec4<f32>,
        seen_7: Gathered,
    ) -> rt::Vec4<f32> {
        let part_41 = (rt::Scalar(1f32) - rt::Scalar(seen_7.transmittance));
        return <rt::Vec4<f32>>::new_31((seen_7.light + (behind.xyz() * rt::Scalar(seen_7.transmittance))), (part_41 + (behind.w() * rt::Scalar(seen_7.transmittance))));
    }
    pub(crate) fn z_of(&self, depth_11: impl rt::Into<rt::Scalar<f32>>) -> f32 {
        rt::into(self.v_z_of(rt::into(depth_11)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_z_of(&self, depth_11: rt::Scalar<f32>) -> rt::Scalar<f32> {
        let _e4 = self.frame.clip.y();
        if rt::Scalar::into_branch_condition(_e4.elementwise_eq(rt::Scalar(0f32))) {
            let _e10 = self.frame.clip.x();
            let _e14 = self.frame.clip.z();
            return (_e10 + (_e14 * depth_11)).clamp(rt::Scalar(0f32), rt::Scalar(1f32));
        }
        let _e23 = self.frame.clip.x();
        let _e27 = self.frame.clip.y();
        return (_e23 + (_e27 / depth_11.max(rt::Scalar(0f32)))).clamp(rt::Scalar(0f32), rt::Scalar(1f32));
    }
    pub(crate) fn shade_hit(
        &self,
        origin_3: impl rt::Into<rt::Vec3<f32>>,
        at_176: Entered,
        hit_83: Hit,
        visible_1: [rt::Vec4<f32>; 8],
    ) -> PixelOut {
        rt::into(self.v_shade_hit(rt::into(origin_3), at_176, hit_83, visible_1))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_shade_hit(
        &self,
        origin_3: rt::Vec3<f32>,
        at_176: Entered,
        hit_83: Hit,
        visible_1: [rt::Vec4<f32>; 8],
    ) -> PixelOut {
        if rt::Scalar::into_branch_condition(rt::Scalar(hit_83.found).elementwise_eq(rt::Scalar(0u32))) {
            return <PixelOut>::new(<rt::Vec4<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32)), rt::Scalar(0u32), rt::Scalar(0u32), <rt::Vec2<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32)), rt::Scalar(0f32), <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32)), <rt::Vec3<f32>>::from_scalars(rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32)), rt::Scalar(0f32), rt::Scalar(0f32), <rt::Vec2<i32>>::from_scalars(rt::Scalar(0i32), rt::Scalar(0i32)), hit_83.cost.x(), hit_83.cost.y(), hit_83.cost.z(), rt::Scalar(0f32), rt::Scalar(0u32), rt::Scalar(0f32), rt::Scalar(0u32), rt::Scalar(1f32));
        }
        let _e46 = self.v_field_height_stage(hit_83.uv, rt::Scalar(hit_83.height), rt::Scalar(at_176.level));
        let view_38 = (origin_3 - at_176.point).normalize();
        let _e50 = self.v_field_normals_stage(at_176, hit_83, view_38);
        let _e51 = self.v_object_color_stage(at_176, hit_83, view_38);
        let _e52 = self.v_reflected_light(at_176, hit_83, _e50, view_38, _e51, visible_1);
        let _e57 = self.frame.forward;
        let depth_15 = (at_176.point - origin_3).dot(_e57.xyz());
        let _e62 = self.v_height_size(rt::Scalar(0u32));
        let _e68 = self.v_cell_of(((hit_83.uv * _e62) - <rt::Vec2<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32))));
        let _e88 = self.v_z_of(rt::Scalar(at_176.depth));
        let _e91 = rt::Scalar(self.surface_settings.number);
        return <PixelOut>::new(<rt::Vec4<f32>>::new_31(_e52, rt::Scalar(1f32)), rt::Scalar(1u32), rt::Scalar(hit_83.exhausted), hit_83.uv, _e46, at_176.point, _e50.normal, depth_15, rt::Scalar(hit_83.t), _e68.to_i32(), hit_83.cost.x(), hit_83.cost.y(), hit_83.cost.z(), visible_1[0usize].x(), rt::Scalar(at_176.level), _e88, _e91, rt::Scalar(1f32));
    }
    pub(crate) fn visible_light(
        &self,
        at_177: Entered,
        hit_84: Hit,
        number_25: impl rt::Into<rt::Scalar<u32>>,
    ) -> f32 {
        rt::into(self.v_visible_light(at_177, hit_84, rt::into(number_25)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_visible_light(
        &self,
        at_177: Entered,
        hit_84: Hit,
        number_25: rt::Scalar<u32>,
    ) -> rt::Scalar<f32> {
        let _e4 = self.v_toward_light(number_25, at_177.point);
        let _e5 = self.v_shadow_stage(at_177, hit_84, _e4);
        return _e5;
    }
    pub(crate) fn visible_lights(&self, at_178: Entered, hit_85: Hit) -> [rt::Vec4<f32>; 8] {
        rt::into(self.v_visible_lights(at_178, hit_85))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_visible_lights(&self, at_178: Entered, hit_85: Hit) -> [rt::Vec4<f32>; 8] {
        let mut visible_2: [rt::Vec4<f32>; 8] = rt::zero();
        let mut k_54: rt::Scalar<u32> = rt::Scalar(0u32);

        if rt::Scalar::into_branch_condition(rt::Scalar(hit_85.found).elementwise_eq(rt::Scalar(0u32))) {
            let _e7 = visible_2;
            return _e7;
        }
        'naga_break: loop {
            'naga_continue: {
                let _e10 = k_54;
                let _e13 = rt::Scalar(self.frame.light_count);
                if rt::Scalar::into_branch_condition(_e10.elementwise_lt(_e13)) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e15 = k_54;
                    let _e17 = k_54;
                    let _e18 = self.v_visible_light(at_178, hit_85, _e17);
                    visible_2[rt::Scalar::into_array_index(_e15)] = <rt::Vec4<f32>>::from_scalars(_e18, rt::Scalar(0f32), rt::Scalar(0f32), rt::Scalar(0f32));
                    let _e23 = k_54;
                    k_54 = (_e23 + rt::Scalar(1u32));
                }
            }
        }
        let _e26 = visible_2;
        return _e26;
    }
    pub(crate) fn shade_pixel(&self, pixel_106: PixelIn) -> PixelOut {
        rt::into(self.v_shade_pixel(pixel_106))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_shade_pixel(&self, pixel_106: PixelIn) -> PixelOut {
        let _e1 = self.v_enter_relief(pixel_106);
        let _e2 = self.v_first_hit(pixel_106, _e1);
        let _e5 = self.v_place_hit(pixel_106, _e1, rt::Scalar(_e2.segment), _e2.hit);
        let _e9 = self.v_visible_lights(_e5, _e2.hit);
        let _e10 = self.v_shade_hit(pixel_106.origin, _e5, _e2.hit, _e9);
        return _e10;
    }
    pub(crate) fn sign_of(&self, number_26: impl rt::Into<rt::Scalar<i32>>) -> i32 {
        rt::into(self.v_sign_of(rt::into(number_26)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_sign_of(&self, number_26: rt::Scalar<i32>) -> rt::Scalar<i32> {
        return number_26.clamp(rt::Scalar(-1i32), rt::Scalar(1i32));
    }
    pub(crate) fn weighted_site(
        &self,
        a_25: BaseSite,
        b_25: BaseSite,
        c_17: BaseSite,
        w_2: impl rt::Into<rt::Vec3<f32>>,
    ) -> BaseSite {
        rt::into(self.v_weighted_site(a_25, b_25, c_17, rt::into(w_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_weighted_site(
        &self,
        a_25: BaseSite,
        b_25: BaseSite,
        c_17: BaseSite,
        w_2: rt::Vec3<f32>,
    ) -> BaseSite {
        return <BaseSite>::new((((a_25.position * w_2.x()) + (b_25.position * w_2.y())) + (c_17.position * w_2.z())), (((a_25.direction * w_2.x()) + (b_25.direction * w_2.y())) + (c_17.direction * w_2.z())), (((a_25.seen_uv * w_2.x()) + (b_25.seen_uv * w_2.y())) + (c_17.seen_uv * w_2.z())), (((a_25.uv * w_2.x()) + (b_25.uv * w_2.y())) + (c_17.uv * w_2.z())), (((rt::Scalar(a_25.texels_per_m) * w_2.x()) + (rt::Scalar(b_25.texels_per_m) * w_2.y())) + (rt::Scalar(c_17.texels_per_m) * w_2.z())), (((rt::Scalar(a_25.depth) * w_2.x()) + (rt::Scalar(b_25.depth) * w_2.y())) + (rt::Scalar(c_17.depth) * w_2.z())), (((a_25.normal * w_2.x()) + (b_25.normal * w_2.y())) + (c_17.normal * w_2.z())), (((a_25.tangent * w_2.x()) + (b_25.tangent * w_2.y())) + (c_17.tangent * w_2.z())), (((a_25.bitangent * w_2.x()) + (b_25.bitangent * w_2.y())) + (c_17.bitangent * w_2.z())), (((a_25.turn_u * w_2.x()) + (b_25.turn_u * w_2.y())) + (c_17.turn_u * w_2.z())), (((a_25.turn_v * w_2.x()) + (b_25.turn_v * w_2.y())) + (c_17.turn_v * w_2.z())));
    }
    pub(crate) fn site_between(
        &self,
        a_26: BaseSite,
        b_26: BaseSite,
        shares: impl rt::Into<rt::Vec2<f32>>,
        at_179: impl rt::Into<rt::Scalar<u32>>,
        parts_3: impl rt::Into<rt::Scalar<u32>>,
    ) -> BaseSite {
        rt::into(self.v_site_between(a_26, b_26, rt::into(shares), rt::into(at_179), rt::into(parts_3)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_site_between(
        &self,
        a_26: BaseSite,
        b_26: BaseSite,
        shares: rt::Vec2<f32>,
        at_179: rt::Scalar<u32>,
        parts_3: rt::Scalar<u32>,
    ) -> BaseSite {
        let of_a = ((parts_3 - at_179).to_f32() * shares.x());
        let of_b = (at_179.to_f32() * shares.y());
        let sum_16 = (of_a + of_b);
        let _e17 = self.v_weighted_site(a_26, b_26, b_26, <rt::Vec3<f32>>::from_scalars((of_a / sum_16), (of_b / sum_16), rt::Scalar(0f32)));
        return _e17;
    }
    pub(crate) fn site_inside(
        &self,
        a_27: BaseSite,
        b_27: BaseSite,
        c_18: BaseSite,
        shares_1: impl rt::Into<rt::Vec3<f32>>,
        weights_6: impl rt::Into<rt::Vec3<f32>>,
    ) -> BaseSite {
        rt::into(self.v_site_inside(a_27, b_27, c_18, rt::into(shares_1), rt::into(weights_6)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_site_inside(
        &self,
        a_27: BaseSite,
        b_27: BaseSite,
        c_18: BaseSite,
        shares_1: rt::Vec3<f32>,
        weights_6: rt::Vec3<f32>,
    ) -> BaseSite {
        let shared_out = (weights_6 * shares_1);
        let sum_17 = ((shared_out.x() + shared_out.y()) + shared_out.z());
        let _e13 = self.v_weighted_site(a_27, b_27, c_18, (shared_out / rt::Vec3::splat_from_scalar(sum_17)));
        return _e13;
    }
    pub(crate) fn site_of_vertex(&self, vertex: BaseVertex, seen_8: BaseVertex, voxel: Voxel) -> BaseSite {
        rt::into(self.v_site_of_vertex(vertex, seen_8, voxel))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_site_of_vertex(&self, vertex: BaseVertex, seen_8: BaseVertex, voxel: Voxel) -> BaseSite {
        return <BaseSite>::new(vertex.position, vertex.direction, seen_8.uv, vertex.uv, rt::Scalar(seen_8.texels_per_m), (rt::Scalar(1f32) / rt::Scalar(voxel.share)), vertex.normal, vertex.tangent, vertex.bitangent, vertex.turn_u, vertex.turn_v);
    }
    pub(crate) fn sweep_from(
        &self,
        primary: impl rt::Into<rt::Scalar<u32>>,
        a_28: impl rt::Into<rt::Vec3<i32>>,
        b_28: impl rt::Into<rt::Vec3<i32>>,
        c_19: impl rt::Into<rt::Vec3<i32>>,
    ) -> Sweep {
        rt::into(self.v_sweep_from(rt::into(primary), rt::into(a_28), rt::into(b_28), rt::into(c_19)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_sweep_from(
        &self,
        primary: rt::Scalar<u32>,
        a_28: rt::Vec3<i32>,
        b_28: rt::Vec3<i32>,
        c_19: rt::Vec3<i32>,
    ) -> Sweep {
        let mut first_8: rt::Vec3<i32>;
        let mut end_4: rt::Vec3<i32>;
        let mut corners_4: rt::Vec3<u32>;

        let _e4 = self.v_main_axis(a_28, b_28);
        let _e5 = self.v_axis_of(b_28, _e4);
        let _e6 = self.v_axis_of(a_28, _e4);
        let is_back_1 = _e5.elementwise_lt(_e6);
        first_8 = a_28;
        end_4 = b_28;
        let _e11 = self.v_around_three(primary, rt::Scalar(1u32));
        let _e13 = self.v_around_three(primary, rt::Scalar(2u32));
        corners_4 = <rt::Vec3<u32>>::from_scalars(primary, _e11, _e13);
        if rt::Scalar::into_branch_condition(is_back_1) {
            first_8 = b_28;
            end_4 = a_28;
            let _e17 = corners_4.y();
            let _e19 = corners_4.x();
            let _e21 = corners_4.z();
            corners_4 = <rt::Vec3<u32>>::from_scalars(_e17, _e19, _e21);
        }
        let _e23 = end_4;
        let _e24 = first_8;
        let _e26 = self.v_seen_along((_e23 - _e24), _e4);
        let _e27 = first_8;
        let _e29 = self.v_seen_along((c_19 - _e27), _e4);
        let in_first = ((_e26.x() * _e29.y()) - (_e26.y() * _e29.x()));
        let in_second = ((_e26.x() * _e29.z()) - (_e26.z() * _e29.x()));
        let is_first_3 = in_first.abs().elementwise_ge(in_second.abs());
        let upward_1 = rt::Scalar(1i32).select(rt::Scalar(-1i32), in_second.select(in_first, is_first_3).elementwise_lt(rt::Scalar(0i32)));
        let _e53 = corners_4;
        let _e66 = first_8;
        let _e68 = self.v_longest_of((c_19 - _e66));
        let _e71 = end_4;
        let _e73 = self.v_longest_of((c_19 - _e71));
        return <Sweep>::new(_e53, <rt::Vec2<i32>>::from_scalars(_e26.x(), (_e26.z().select(_e26.y(), is_first_3) * upward_1)), <rt::Vec2<i32>>::from_scalars(_e29.x(), (_e29.z().select(_e29.y(), is_first_3) * upward_1)), <rt::Vec2<i32>>::from_scalars(_e68.max(rt::Scalar(1i32)), _e73.max(rt::Scalar(1i32))), rt::Scalar(0u32).select(rt::Scalar(1u32), is_back_1));
    }
    pub(crate) fn sweep_of(
        &self,
        a_29: impl rt::Into<rt::Vec3<i32>>,
        b_29: impl rt::Into<rt::Vec3<i32>>,
        c_20: impl rt::Into<rt::Vec3<i32>>,
    ) -> Sweep {
        rt::into(self.v_sweep_of(rt::into(a_29), rt::into(b_29), rt::into(c_20)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_sweep_of(
        &self,
        a_29: rt::Vec3<i32>,
        b_29: rt::Vec3<i32>,
        c_20: rt::Vec3<i32>,
    ) -> Sweep {
        let mut local_141: rt::Scalar<bool>;

        let _e3 = self.v_primary_length(a_29, b_29, c_20);
        let _e4 = self.v_primary_length(b_29, c_20, a_29);
        let _e5 = self.v_primary_length(c_20, a_29, b_29);
        if rt::Scalar::into_branch_condition(_e3.elementwise_ge(_e4)) {
            local_141 = _e3.elementwise_ge(_e5);
        } else {
            local_141 = rt::Scalar(false);
        }
        let _e11 = local_141;
        if rt::Scalar::into_branch_condition(_e11) {
            let _e13 = self.v_sweep_from(rt::Scalar(0u32), a_29, b_29, c_20);
            return _e13;
        }
        if rt::Scalar::into_branch_condition(_e4.elementwise_ge(_e5)) {
            let _e16 = self.v_sweep_from(rt::Scalar(1u32), b_29, c_20, a_29);
            return _e16;
        }
        let _e18 = self.v_sweep_from(rt::Scalar(2u32), c_20, a_29, b_29);
        return _e18;
    }
    pub(crate) fn sweep_on(
        &self,
        a_30: Voxel,
        b_30: Voxel,
        c_21: Voxel,
        level_63: impl rt::Into<rt::Scalar<u32>>,
    ) -> Sweep {
        rt::into(self.v_sweep_on(a_30, b_30, c_21, rt::into(level_63)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_sweep_on(
        &self,
        a_30: Voxel,
        b_30: Voxel,
        c_21: Voxel,
        level_63: rt::Scalar<u32>,
    ) -> Sweep {
        let _e5 = self.v_coarser_voxel(a_30.at, level_63);
        let _e7 = self.v_coarser_voxel(b_30.at, level_63);
        let _e9 = self.v_coarser_voxel(c_21.at, level_63);
        let _e10 = self.v_sweep_of(_e5, _e7, _e9);
        return _e10;
    }
    pub(crate) fn swept_chain(
        &self,
        sweep_7: Sweep,
        column_4: SweptColumn,
        way_26: impl rt::Into<rt::Scalar<u32>>,
    ) -> SweptChain {
        rt::into(self.v_swept_chain(sweep_7, column_4, rt::into(way_26)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_swept_chain(
        &self,
        sweep_7: Sweep,
        column_4: SweptColumn,
        way_26: rt::Scalar<u32>,
    ) -> SweptChain {
        if rt::Scalar::into_branch_condition(way_26.elementwise_eq(ROOF_UP)) {
            let _e5 = self.v_roof_left(sweep_7, column_4);
            return <SweptChain>::new(column_4, way_26, (rt::Scalar(1i32) + _e5));
        }
        if rt::Scalar::into_branch_condition(way_26.elementwise_eq(ROOF_DOWN)) {
            let _e12 = self.v_roof_left(sweep_7, column_4);
            return <SweptChain>::new(column_4, way_26, (rt::Scalar(column_4.of_top) - _e12));
        }
        let of_top = rt::Scalar(column_4.of_top).min(rt::Scalar(1i32)).select(rt::Scalar(column_4.of_top), rt::Scalar(column_4.top).elementwise_eq(way_26));
        return <SweptChain>::new(column_4, way_26, ((rt::Scalar(1i32) + rt::Scalar(column_4.inner)) + of_top));
    }
    pub(crate) fn swept_column(
        &self,
        sweep_8: Sweep,
        column_5: impl rt::Into<rt::Scalar<i32>>,
        first_9: impl rt::Into<rt::Scalar<u32>>,
    ) -> SweptColumn {
        rt::into(self.v_swept_column(sweep_8, rt::into(column_5), rt::into(first_9)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_swept_column(
        &self,
        sweep_8: Sweep,
        column_5: rt::Scalar<i32>,
        first_9: rt::Scalar<u32>,
    ) -> SweptColumn {
        let mut local_142: rt::Scalar<bool>;

        let n_21 = sweep_8.parts.x();
        let m_8 = sweep_8.parts.y();
        let _e7 = self.v_first_of_top(sweep_8, column_5);
        let _e10 = self.v_first_of_top(sweep_8, (column_5 + rt::Scalar(1i32)));
        let is_behind = (_e10 - rt::Scalar(1i32)).elementwise_gt(n_21);
        let top_12 = TOP_NEXT.select(TOP_BEFORE.select(TOP_ROOF, _e7.elementwise_lt(n_21)), is_behind);
        let from_top = _e7.max(rt::Scalar(1i32));
        let of_top_1 = (_e10.min((n_21 + m_8)) - from_top);
        if rt::Scalar::into_branch_condition((!column_5.elementwise_le(rt::Scalar(0i32)))) {
            local_142 = column_5.elementwise_ge(sweep_8.end.x());
        } else {
            local_142 = rt::Scalar(true);
        }
        let _e34 = local_142;
        if rt::Scalar::into_branch_condition(_e34) {
            return <SweptColumn>::new(column_5, rt::Scalar(0i32), rt::Scalar(0i32), first_9, from_top, of_top_1, top_12);
        }
        let _e43 = self.v_quotient_near((sweep_8.end.y() * column_5), sweep_8.end.x());
        let inside_9 = (_e43 + rt::Scalar(1i32));
        let _e46 = self.v_top_point(sweep_8, from_top);
        let _e50 = self.v_top_point(sweep_8, ((from_top + of_top_1) - rt::Scalar(1i32)));
        let _e53 = self.v_quotient_near(rt::Scalar(_e46.y), rt::Scalar(_e46.w));
        let _e56 = self.v_quotient_near(rt::Scalar(_e50.y), rt::Scalar(_e50.w));
        let above_13 = _e53.min(_e56);
        return <SweptColumn>::new(column_5, inside_9, (above_13 - inside_9).max(rt::Scalar(0i32)), first_9, from_top, of_top_1, top_12);
    }
    pub(crate) fn swept_points_of(&self, sweep_9: Sweep) -> u32 {
        rt::into(self.v_swept_points_of(sweep_9))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_swept_points_of(&self, sweep_9: Sweep) -> rt::Scalar<u32> {
        let mut points: rt::Scalar<u32> = rt::Scalar(0u32);
        let mut column_6: rt::Scalar<i32> = rt::Scalar(1i32);

        'naga_break: loop {
            'naga_continue: {
                let _e5 = column_6;
                if rt::Scalar::into_branch_condition(_e5.elementwise_lt(sweep_9.end.x())) {
                } else {
                    break 'naga_break;
                }
                {
                    let _e9 = points;
                    let _e10 = column_6;
                    let _e12 = self.v_swept_column(sweep_9, _e10, rt::Scalar(0u32));
                    points = (_e9 + rt::Scalar(_e12.inner).to_u32());
                    let _e16 = column_6;
                    column_6 = (_e16 + rt::Scalar(1i32));
                }
            }
        }
        let _e19 = points;
        return _e19;
    }
    pub(crate) fn swept_weights(
        &self,
        sweep_10: Sweep,
        x_5: impl rt::Into<rt::Scalar<i32>>,
        y: impl rt::Into<rt::Scalar<i32>>,
    ) -> rt::Vec3<f32> {
        rt::into(self.v_swept_weights(sweep_10, rt::into(x_5), rt::into(y)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_swept_weights(
        &self,
        sweep_10: Sweep,
        x_5: rt::Scalar<i32>,
        y: rt::Scalar<i32>,
    ) -> rt::Vec3<f32> {
        let end_28 = sweep_10.end;
        let apex_2 = sweep_10.apex;
        let twice = ((end_28.x() * apex_2.y()) - (end_28.y() * apex_2.x())).to_f32();
        let of_end = (((x_5 * apex_2.y()) - (y * apex_2.x())).to_f32() / twice);
        let of_apex = (((end_28.x() * y) - (end_28.y() * x_5)).to_f32() / twice);
        let of_first = ((rt::Scalar(1f32) - of_end) - of_apex);
        let corners_6 = sweep_10.corners;
        return <rt::Vec3<f32>>::from_scalars(of_apex.select(of_end, corners_6.y().elementwise_eq(rt::Scalar(0u32))).select(of_first, corners_6.x().elementwise_eq(rt::Scalar(0u32))), of_apex.select(of_end, corners_6.y().elementwise_eq(rt::Scalar(1u32))).select(of_first, corners_6.x().elementwise_eq(rt::Scalar(1u32))), of_apex.select(of_end, corners_6.y().elementwise_eq(rt::Scalar(2u32))).select(of_first, corners_6.x().elementwise_eq(rt::Scalar(2u32))));
    }
    pub(crate) fn turn_of_piece(&self, a_31: SweptPoint, b_31: SweptPoint, c_22: SweptPoint) -> i32 {
        rt::into(self.v_turn_of_piece(a_31, b_31, c_22))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_turn_of_piece(&self, a_31: SweptPoint, b_31: SweptPoint, c_22: SweptPoint) -> rt::Scalar<i32> {
        let bx_2 = ((rt::Scalar(b_31.x) * rt::Scalar(a_31.w)) - (rt::Scalar(a_31.x) * rt::Scalar(b_31.w)));
        let by_5 = ((rt::Scalar(b_31.y) * rt::Scalar(a_31.w)) - (rt::Scalar(a_31.y) * rt::Scalar(b_31.w)));
        let cx = ((rt::Scalar(c_22.x) * rt::Scalar(a_31.w)) - (rt::Scalar(a_31.x) * rt::Scalar(c_22.w)));
        let cy = ((rt::Scalar(c_22.y) * rt::Scalar(a_31.w)) - (rt::Scalar(a_31.y) * rt::Scalar(c_22.w)));
        let _e31 = self.v_sign_of(bx_2);
        let _e32 = self.v_sign_of(cy);
        let of_first_1 = (_e31 * _e32);
        let _e34 = self.v_sign_of(by_5);
        let _e35 = self.v_sign_of(cx);
        let of_second = (_e34 * _e35);
        if rt::Scalar::into_branch_condition(of_first_1.elementwise_ne(of_second)) {
            return rt::Scalar(1i32).select(rt::Scalar(-1i32), of_first_1.elementwise_lt(of_second));
        }
        let _e42 = self.v_magnitude(bx_2);
        let _e43 = self.v_magnitude(cy);
        let _e44 = self.v_magnitude(by_5);
        let _e45 = self.v_magnitude(cx);
        let _e46 = self.v_compared(_e42, _e43, _e44, _e45);
        return (of_first_1 * _e46);
    }
    pub(crate) fn voxel_of(
        &self,
        grid_14: Tessellation,
        position_2: impl rt::Into<rt::Vec3<f32>>,
    ) -> Voxel {
        rt::into(self.v_voxel_of(grid_14, rt::into(position_2)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_voxel_of(
        &self,
        grid_14: Tessellation,
        position_2: rt::Vec3<f32>,
    ) -> Voxel {
        let mut share: rt::Scalar<f32> = rt::Scalar(1f32);
        let mut away: rt::Scalar<f32>;

        let from_eye = (position_2 - grid_14.eye.xyz());
        let depth_16 = grid_14.forward.xyz().dot(from_eye);
        let seen_11 = depth_16.max(rt::Scalar(grid_14.near_m));
        away = (depth_16 * rt::Scalar(grid_14.per_m));
        if rt::Scalar::into_branch_condition(rt::Scalar(grid_14.is_parallel).elementwise_eq(rt::Scalar(0u32))) {
            share = (rt::Scalar(1f32) / seen_11);
            let _e22 = self.v_log2_of((seen_11 / rt::Scalar(grid_14.near_m)));
            away = (_e22 * rt::Scalar(grid_14.per_doubling));
        }
        let _e30 = share;
        let right_8 = (((grid_14.right.xyz().dot(from_eye) * rt::Scalar(grid_14.per_m)) * _e30) + grid_14.middle.x());
        let _e42 = share;
        let down_4 = (grid_14.middle.y() - ((grid_14.up.xyz().dot(from_eye) * rt::Scalar(grid_14.per_m)) * _e42));
        let far_23 = <rt::Vec3<f32>>::from_scalars(rt::Scalar(262144f32), rt::Scalar(262144f32), rt::Scalar(262144f32));
        let _e49 = away;
        let at_191 = <rt::Vec3<f32>>::from_scalars(right_8, down_4, _e49).clamp((-far_23), far_23);
        let _e60 = share;
        return <Voxel>::new((at_191 + <rt::Vec3<f32>>::from_scalars(rt::Scalar(0.5f32), rt::Scalar(0.5f32), rt::Scalar(0.5f32))).floor().to_i32(), _e60.select(rt::Scalar(1f32), grid_14.parts_of_uv.x().elementwise_gt(rt::Scalar(0f32))));
    }
    pub(crate) fn zip_goes_left(&self, zip: Zip) -> bool {
        rt::into(self.v_zip_goes_left(zip))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_zip_goes_left(&self, zip: Zip) -> rt::Scalar<bool> {
        let mut local_143: rt::Scalar<bool>;
        let mut local_144: rt::Scalar<bool>;
        let mut local_145: rt::Scalar<bool>;
        let mut local_146: rt::Scalar<bool>;
        let mut local_147: rt::Scalar<bool>;

        let on_left = ((rt::Scalar(zip.left.count) - rt::Scalar(1i32)) - rt::Scalar(zip.i));
        let on_right = ((rt::Scalar(zip.right.count) - rt::Scalar(1i32)) - rt::Scalar(zip.j));
        if rt::Scalar::into_branch_condition(on_left.elementwise_eq(rt::Scalar(0i32))) {
            return rt::Scalar(false);
        }
        if rt::Scalar::into_branch_condition(on_right.elementwise_eq(rt::Scalar(0i32))) {
            return rt::Scalar(true);
        }
        if rt::Scalar::into_branch_condition(rt::Scalar(zip.left.way).elementwise_eq(ROOF_UP)) {
            local_143 = rt::Scalar(zip.i).elementwise_eq(rt::Scalar(0i32));
        } else {
            local_143 = rt::Scalar(false);
        }
        let _e29 = local_143;
        if rt::Scalar::into_branch_condition(_e29) {
            return rt::Scalar(true);
        }
        if rt::Scalar::into_branch_condition(rt::Scalar(zip.keeps_right).elementwise_eq(rt::Scalar(1u32))) {
            local_144 = on_right.elementwise_eq(rt::Scalar(1i32));
        } else {
            local_144 = rt::Scalar(false);
        }
        let _e39 = local_144;
        if rt::Scalar::into_branch_condition(_e39) {
            return rt::Scalar(true);
        }
        if rt::Scalar::into_branch_condition(rt::Scalar(zip.keeps_left).elementwise_eq(rt::Scalar(1u32))) {
            local_145 = on_left.elementwise_eq(rt::Scalar(1i32));
        } else {
            local_145 = rt::Scalar(false);
        }
        let _e49 = local_145;
        if rt::Scalar::into_branch_condition(_e49) {
            return rt::Scalar(false);
        }
        let _e54 = self.v_turn_of_piece(zip.at_left, zip.at_right, zip.next_left);
        let _e58 = self.v_turn_of_piece(zip.at_left, zip.at_right, zip.next_right);
        let _e63 = self.v_is_no_longer(zip.next_left, zip.at_right, zip.at_left, zip.next_right);
        if rt::Scalar::into_branch_condition(_e54.elementwise_eq(_e58)) {
            return _e63;
        }
        if rt::Scalar::into_branch_condition(_e54.elementwise_gt(rt::Scalar(0i32))) {
            if rt::Scalar::into_branch_condition((!_e58.elementwise_le(rt::Scalar(0i32)))) {
                local_147 = _e63;
            } else {
                local_147 = rt::Scalar(true);
            }
            let _e75 = local_147;
            local_146 = _e75;
        } else {
            local_146 = rt::Scalar(false);
        }
        let _e77 = local_146;
        return _e77;
    }
    pub(crate) fn zip_next(
        &self,
        sweep_11: Sweep,
        zip_1: Zip,
        goes_left: impl rt::Into<rt::Scalar<bool>>,
    ) -> Zip {
        rt::into(self.v_zip_next(sweep_11, zip_1, rt::into(goes_left)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_zip_next(
        &self,
        sweep_11: Sweep,
        zip_1: Zip,
        goes_left: rt::Scalar<bool>,
    ) -> Zip {
        let mut next_10: Zip;

        next_10 = zip_1;
        if rt::Scalar::into_branch_condition(goes_left) {
            rt::Scalar(next_10.i) = (rt::Scalar(zip_1.i) + rt::Scalar(1i32));
            next_10.at_left = zip_1.next_left;
            let _e20 = self.v_chain_point(sweep_11, zip_1.left, (rt::Scalar(zip_1.i) + rt::Scalar(2i32)).min((rt::Scalar(zip_1.left.count) - rt::Scalar(1i32))));
            next_10.next_left = _e20;
        } else {
            rt::Scalar(next_10.j) = (rt::Scalar(zip_1.j) + rt::Scalar(1i32));
            next_10.at_right = zip_1.next_right;
            let _e37 = self.v_chain_point(sweep_11, zip_1.right, (rt::Scalar(zip_1.j) + rt::Scalar(2i32)).min((rt::Scalar(zip_1.right.count) - rt::Scalar(1i32))));
            next_10.next_right = _e37;
        }
        let _e38 = next_10;
        return _e38;
    }
    pub(crate) fn zip_of(
        &self,
        sweep_12: Sweep,
        column_7: SweptColumn,
        next_11: SweptColumn,
        which: impl rt::Into<rt::Scalar<u32>>,
    ) -> Zip {
        rt::into(self.v_zip_of(sweep_12, column_7, next_11, rt::into(which)))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    pub(super) fn v_zip_of(
        &self,
        sweep_12: Sweep,
        column_7: SweptColumn,
        next_11: SweptColumn,
        which: rt::Scalar<u32>,
    ) -> Zip {
        let mut left_1: SweptChain;
        let mut right: SweptChain;
        let mut local_148: rt::Scalar<bool>;
        let mut local_149: rt::Scalar<bool>;
        let mut local_150: rt::Scalar<bool>;

        let _e5 = self.v_swept_chain(sweep_12, column_7, TOP_NEXT);
        left_1 = _e5;
        let _e8 = self.v_swept_chain(sweep_12, next_11, TOP_BEFORE);
        right = _e8;
        if rt::Scalar::into_branch_condition(which.elementwise_ne(rt::Scalar(1u32))) {
            let under_3 = which.elementwise_eq(rt::Scalar(0u32));
            if rt::Scalar::into_branch_condition((!rt::Scalar(column_7.top).elementwise_ne(TOP_ROOF))) {
                local_148 = rt::Scalar(column_7.column).elementwise_ne(rt::Scalar(0i32));
            } else {
                local_148 = rt::Scalar(true);
            }
            let _e27 = local_148;
            let has_none = rt::Scalar(next_11.top).elementwise_ne(TOP_ROOF).select(_e27, under_3);
            if rt::Scalar::into_branch_condition(under_3) {
                let _e30 = self.v_swept_chain(sweep_12, column_7, ROOF_UP);
                left_1 = _e30;
                let _e32 = self.v_swept_chain(sweep_12, column_7, ROOF_DOWN);
                right = _e32;
            } else {
                let _e34 = self.v_swept_chain(sweep_12, next_11, ROOF_UP);
                left_1 = _e34;
                let _e36 = self.v_swept_chain(sweep_12, next_11, ROOF_DOWN);
                right = _e36;
            }
            if rt::Scalar::into_branch_condition(has_none) {
                rt::Scalar(left_1.count) = rt::Scalar(1i32);
                rt::Scalar(right.count) = rt::Scalar(1i32);
            }
        }
        let _e42 = rt::Scalar(left_1.count);
        if rt::Scalar::into_branch_condition(_e42.elementwise_gt(rt::Scalar(1i32))) {
            let _e47 = left_1;
            let _e48 = right;
            let _e49 = self.v_ends_on(sweep_12, _e47, _e48);
            local_149 = _e49;
        } else {
            local_149 = rt::Scalar(false);
        }
        let keeps_left = local_149;
        let _e53 = rt::Scalar(right.count);
        if rt::Scalar::into_branch_condition(_e53.elementwise_gt(rt::Scalar(1i32))) {
            let _e58 = right;
            let _e59 = left_1;
            let _e60 = self.v_ends_on(sweep_12, _e58, _e59);
            local_150 = _e60;
        } else {
            local_150 = rt::Scalar(false);
        }
        let keeps_right = local_150;
        let _e63 = left_1;
        let _e64 = right;
        let _e65 = left_1;
        let _e67 = self.v_chain_point(sweep_12, _e65, rt::Scalar(0i32));
        let _e68 = right;
        let _e70 = self.v_chain_point(sweep_12, _e68, rt::Scalar(0i32));
        let _e71 = left_1;
        let _e73 = rt::Scalar(left_1.count);
        let _e78 = self.v_chain_point(sweep_12, _e71, rt::Scalar(1i32).min((_e73 - rt::Scalar(1i32))));
        let _e79 = right;
        let _e81 = rt::Scalar(right.count);
        let _e86 = self.v_chain_point(sweep_12, _e79, rt::Scalar(1i32).min((_e81 - rt::Scalar(1i32))));
        return <Zip>::new(_e63, _e64, _e67, _e70, _e78, _e86, rt::Scalar(0i32), rt::Scalar(0i32), rt::Scalar(0u32).select(rt::Scalar(1u32), keeps_left), rt::Scalar(0u32).select(rt::Scalar(1u32), keeps_right));
    }
    pub(crate) fn zip_rest(&self, zip_2: Zip) -> i32 {
        rt::into(self.v_zip_rest(zip_2))
    }
    #[allow(unused_parens, clippy::all, clippy::pedantic, clippy::nursery)]
    #[inline(always)]
    pub(super) fn v_zip_rest(&self, zip_2: Zip) -> rt::Scalar<i32> {
        return ((((rt::Scalar(zip_2.left.count) + rt::Scalar(zip_2.right.count)) - rt::Scalar(2i32)) - rt::Scalar(zip_2.i)) - rt::Scalar(zip_2.j));
    }
}

impl<'g> Resources<'g> {
    /// What the stages are called on.
    pub(crate) fn of(bound: &crate::cpu::Bound<'g>) -> Self {
        Self {
            ambient_map: bound.slot(crate::MapSlot::Ambient),
            color_map: bound.color_map,
            detail_map: bound.slot(crate::MapSlot::Detail),
            environment_map: bound.slot(crate::MapSlot::Environment),
            frame: bound.frame,
            height_map: bound.height_map,
            hole_map: bound.hole_map,
            light_map: bound.slot(crate::MapSlot::Lights),
            material_map: bound.material_map,
            normal_map: bound.normal_map,
            object_map: bound.slot(crate::MapSlot::Object),
            search_map: bound.slot(crate::MapSlot::Search),
            shadow_search_map: bound.slot(crate::MapSlot::ShadowSearch),
            shadow_texels: bound.slot(crate::MapSlot::Shadow),
            surface_settings: bound.surface_settings,
        }
    }
}
