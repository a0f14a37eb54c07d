//! The path of a ray through the relief, in texture space.

use crate::HeightMap;

/// A ray segment in texture space. `(u, v)` is linear in the parameter `t`, and the height is
/// `H(t) = h[0] + h[1] t + h[2] t²`.
///
/// * `t` is the distance along the ray in metres: 0 at the entry and `exit` at the end of the path.
/// * `H` is a texel height: 0 and 1 are the lowest and the highest level of the map. On a plane
///   `h[2]` is 0.
/// * Texture coordinates are not wrapped. Under [`Wrap::Clamp`](crate::Wrap::Clamp) the path's
///   creator ends it at the edge of the footprint `[0, 1]²`.
/// * The shaders use the same struct in `f32`. Here it is `f64`, so that the exact tracers judge
///   precisely the ray that a shader received.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// Texture coordinates at the entry.
    pub uv: [f64; 2],
    /// Change of the texture coordinates per unit of `t`.
    pub duv: [f64; 2],
    /// Coefficients of the height `H(t)`.
    pub h: [f64; 3],
    /// Parameter of the path's end.
    pub exit: f64,
    /// Parameter at which the path crosses the base surface. `offset` and `slope` methods begin
    /// there.
    pub base: f64,
    /// Conversion of texture units and heights to lengths in metres.
    pub metric: PathMetric,
}

/// Purpose of a ray.
///
/// The discriminants are the numbers that the shaders use.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum RayUse {
    /// View ray: it finds what the camera sees.
    #[default]
    View = 0,
    /// Shadow ray: it finds whether anything blocks a light.
    Shadow = 1,
}

impl RayUse {
    /// All purposes, in the order of the shaders' numbers.
    pub const ALL: [RayUse; 2] = [RayUse::View, RayUse::Shadow];

    /// Name in the shaders' constants, after `RAY_`.
    pub const fn name(self) -> &'static str {
        match self {
            RayUse::View => "VIEW",
            RayUse::Shadow => "SHADOW",
        }
    }
}

/// Lengths in metres of texture units on a surface: a step `(du, dv, dH)` is
/// `sqrt(uu du² + 2 uv du dv + vv dv² + (scale dH)²)` metres long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathMetric {
    /// `T·T`, where the length of the tangent is one tile in metres.
    pub uu: f64,
    /// `T·B`.
    pub uv: f64,
    /// `B·B`.
    pub vv: f64,
    /// Metres of displacement between texel 0 and texel 1.
    pub scale_m: f64,
}

impl PathMetric {
    /// Metric of a square tile of 1 m with this displacement scale in metres.
    pub const fn unit(scale_m: f64) -> Self {
        Self { uu: 1.0, uv: 0.0, vv: 1.0, scale_m }
    }
}

impl Path {
    /// Creates a straight path between two points `(u, v, H)`, with `t` from 0 to 1, in a tile of 1
    /// m with a relief of 1 m. The base is where the path reaches `H = 1`, or the entry if it never
    /// does.
    pub fn between(from: [f64; 3], to: [f64; 3]) -> Self {
        let dh = to[2] - from[2];
        let base = if dh != 0.0 { ((1.0 - from[2]) / dh).clamp(0.0, 1.0) } else { 0.0 };
        Self {
            uv: [from[0], from[1]],
            duv: [to[0] - from[0], to[1] - from[1]],
            h: [from[2], dh, 0.0],
            exit: 1.0,
            base,
            metric: PathMetric::unit(1.0),
        }
    }

    /// Texture coordinates and height at `t`.
    #[inline]
    pub fn at(&self, t: f64) -> [f64; 3] {
        [
            self.uv[0] + self.duv[0] * t,
            self.uv[1] + self.duv[1] * t,
            self.h[0] + t * (self.h[1] + t * self.h[2]),
        ]
    }

    /// Height of the path above the map at `t`, in texel values: positive above, negative below.
    pub fn clearance(&self, map: &HeightMap, t: f64) -> f64 {
        let [u, v, h] = self.at(t);
        h - map.height_at(u, v)
    }
}
