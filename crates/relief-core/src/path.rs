//! The path of a ray through the relief, in texture space.

use crate::HeightMap;

/// A ray segment in texture space: `(u, v)` is linear in the parameter `t`, and the normalised height above
/// the base is `H(t) = h[0] + h[1] t + h[2] t²`.
///
/// * `t` is 0 at the entry and `exit` where the path ends; it is the distance along the ray in metres.
/// * `H` is a texel height: 0 and 1 are the lowest and the highest level of the map. On a plane `h[2]` is 0.
/// * Texture coordinates are not wrapped; under [`Wrap::Clamp`](crate::Wrap::Clamp) whoever makes the path
///   ends it at the edge of the footprint `[0, 1]²`.
/// * The shaders hold the same struct in `f32`; here it is `f64`, so that the exact tracers judge precisely
///   the ray that a shader was given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// Texture coordinates at the entry.
    pub uv: [f64; 2],
    /// Change of the texture coordinates per unit of `t`.
    pub duv: [f64; 2],
    /// Coefficients of the normalised height `H(t)`.
    pub h: [f64; 3],
    /// The parameter where the path ends.
    pub exit: f64,
    /// The parameter where the path crosses the base surface, which is where `offset` and `slope` methods
    /// begin.
    pub base: f64,
    /// What turns texture units and heights into world lengths.
    pub metric: PathMetric,
}

/// What a ray is for.
///
/// The discriminants are the numbers that the shaders use.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[repr(u32)]
pub enum RayUse {
    /// To see what it hits.
    #[default]
    View = 0,
    /// To see whether anything is in a light's way.
    Shadow = 1,
}

impl RayUse {
    /// Every use, in the order of the shaders' numbers.
    pub const ALL: [RayUse; 2] = [RayUse::View, RayUse::Shadow];

    /// Its name in the shaders' constants, after `RAY_`.
    pub const fn name(self) -> &'static str {
        match self {
            RayUse::View => "VIEW",
            RayUse::Shadow => "SHADOW",
        }
    }
}

/// World lengths of texture units: a step `(du, dv, dH)` is
/// `sqrt(uu du² + 2 uv du dv + vv dv² + (scale dH)²)` metres long.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathMetric {
    /// `T·T`, with the tangent as long as one tile in metres.
    pub uu: f64,
    /// `T·B`.
    pub uv: f64,
    /// `B·B`.
    pub vv: f64,
    /// Metres of displacement between texel 0 and texel 1.
    pub scale_m: f64,
}

impl PathMetric {
    /// A unit square tile with the given displacement scale.
    pub const fn unit(scale_m: f64) -> Self {
        Self { uu: 1.0, uv: 0.0, vv: 1.0, scale_m }
    }
}

impl Path {
    /// A straight path from `(u, v, H)` to another such point, with `t` from 0 to 1, in a tile of 1 m and
    /// relief of 1 m. The base is where it reaches `H = 1`, or the entry when it never does.
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

    /// Texture coordinates and normalised height at `t`.
    #[inline]
    pub fn at(&self, t: f64) -> [f64; 3] {
        [
            self.uv[0] + self.duv[0] * t,
            self.uv[1] + self.duv[1] * t,
            self.h[0] + t * (self.h[1] + t * self.h[2]),
        ]
    }

    /// The height of the path above the map at `t`: positive above, negative below.
    pub fn clearance(&self, map: &HeightMap, t: f64) -> f64 {
        let [u, v, h] = self.at(t);
        h - map.height_at(u, v)
    }
}
