//! What a camera cannot see of a displaced mesh.
//!
//! Source: Gumhold and Hüttner 1999. Section 3.3 moves the planes of the view out by the greatest
//! displacement of all (equations 7 and 8); here each patch is bounded by its own least and greatest one,
//! along its own directions. Section 6 asks for cones of normals to tell patches that turn their backs.
//! Slopes do not bound how triangles of chords are turned, though: three points that are nearly on one line
//! can make one that faces anywhere. So triangles themselves are looked at.

use glam::{DVec3, Vec3};
use relief_core::camera::Camera;

use crate::edge::Divides;
use crate::{MeshSettings, MesherError, Shading, View};

/// What is not made of a mesh that one camera looks at, and nothing else: for pictures, not for files.
/// Nothing that the camera sees is left out, and the rest has the same bits as with neither choice.
///
/// With either and with neither, flat base triangles that reach behind the eye in perspective are halved
/// until few points are there, so that most of what is behind can be left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cull {
    /// Patches that lie beside the picture, or behind the eye, whatever their relief.
    pub outside: bool,
    /// Patches of which all triangles turn their back to the eye, by more than a rasteriser rounds.
    pub backs: bool,
}

/// Refuses to leave something out where that makes no sense.
pub fn check(settings: &MeshSettings) -> Result<(), MesherError> {
    if settings.cull.is_none() {
        return Ok(());
    }
    if !matches!(settings.edges.divides, Divides::Voxels(_)) {
        return Err(MesherError::CullOfNoView { edges: settings.edges.name });
    }
    if settings.shading == Shading::Mesh { Err(MesherError::CullOfMeshNormals) } else { Ok(()) }
}

/// How far beside the picture something may be seen, in pixels: more than rays and rasterisers round.
const BESIDE_PIXELS: f64 = 1.0;

/// What shaders round positions and the eye by, as a part of the largest coordinate.
const ROUNDING: f64 = 1e-6;

/// The least distance of a corner from the opposite side of a triangle that is taken to turn its back, in
/// pixels: nearer, and a rasteriser that rounds corners to a 256th of a pixel may see its front.
const LEAST_PIXELS: f64 = 1.0 / 64.0;

/// What a patch is within: no point of it is farther from the hull of the points.
#[derive(Clone, Copy, Debug)]
pub struct Hull {
    pub points: [DVec3; 6],
    pub radius_m: f64,
}

/// What the camera of a view sees.
#[derive(Clone, Copy, Debug)]
pub struct Sight {
    camera: Camera,
    /// Unit normals that point out of what is seen, and how far out of the eye's place the planes lie.
    planes: [(DVec3, f64); 5],
    /// Pixels of a metre, in perspective at a depth of 1 m.
    pixels: f64,
}

impl Sight {
    pub fn new(view: &View) -> Self {
        let (camera, [width, height]) = (view.camera, view.size.map(f64::from));
        let half = camera.half_height();
        let pixels = height / (2.0 * half);
        let room = BESIDE_PIXELS / pixels;
        let [right, up, forward] = [camera.right(), camera.up(), camera.forward()];
        let side = |aside: DVec3, to: f64| {
            let to = to + room;
            if camera.is_orthographic() { (aside, to) } else { ((aside - forward * to).normalize(), 0.0) }
        };
        let wide = half * width / height;
        let planes =
            [side(right, wide), side(-right, wide), side(up, half), side(-up, half), (-forward, 0.0)];
        Self { camera, planes, pixels }
    }

    /// Whether nothing within a hull is seen.
    ///
    /// What is seen lies behind all of the planes, also behind those of the sides in perspective, as its
    /// depth is not negative. A hull whose points are farther before one of them than its radius lies before
    /// it.
    pub fn misses(&self, hull: &Hull) -> bool {
        let eye = self.camera.eye();
        let largest = hull.points.iter().fold(eye, |most, point| most.abs().max(point.abs())).max_element();
        // What is displaced beyond what is stored is kept, and refused when it is made.
        let is_stored = largest + hull.radius_m <= f64::from(f32::MAX);
        let room = hull.radius_m + ROUNDING * largest;
        let is_before = |(normal, out): &(DVec3, f64)| {
            hull.points.iter().all(|point| normal.dot(*point - eye) > out + room)
        };
        is_stored && self.planes.iter().any(is_before)
    }

    /// From where to where something within a hull may lie along the view axis, in metres from the eye.
    pub fn depths_m(&self, hull: &Hull) -> [f64; 2] {
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let [near, far] = hull.points.iter().fold(nothing, |[near, far], point| {
            let depth = self.camera.forward().dot(*point - self.camera.eye());
            [near.min(depth), far.max(depth)]
        });
        [near - hull.radius_m, far + hull.radius_m]
    }

    /// Whether no rasteriser sees the front of a triangle: it has no area, or its corners run clockwise in
    /// the picture and are not so nearly in one line that rounding may turn it over.
    pub fn is_back(&self, corners: [Vec3; 3]) -> bool {
        let [a, b, c] = corners.map(Vec3::as_dvec3);
        if (b - a).cross(c - a) == DVec3::ZERO {
            return true;
        }
        let Self { camera, pixels, .. } = self;
        let mut places = [[0.0; 2]; 3];
        for (place, corner) in places.iter_mut().zip(corners) {
            let from_eye = corner.as_dvec3() - camera.eye();
            let depth = if camera.is_orthographic() { 1.0 } else { camera.forward().dot(from_eye) };
            if depth.is_nan() || depth <= 0.0 {
                return false;
            }
            *place = [camera.right(), camera.up()].map(|axis| axis.dot(from_eye) / depth * pixels);
        }
        let [a, b, c] = places;
        let side = |from: [f64; 2], to: [f64; 2]| [to[0] - from[0], to[1] - from[1]];
        let [ab, bc, ca] = [side(a, b), side(b, c), side(c, a)];
        let longest = [ab, bc, ca].map(|[x, y]| x.hypot(y)).into_iter().fold(0.0, f64::max);
        let twice_area = ab[0] * bc[1] - ab[1] * bc[0];
        -twice_area > LEAST_PIXELS * longest
    }
}
