//! What a camera cannot see of a displaced mesh.
//!
//! Source: Gumhold and Hüttner 1999. Section 3.3 moves the planes of the view out by the greatest
//! displacement of all (equations 7 and 8); here each patch is bounded by its own least and greatest one,
//! along its own directions. Section 6 asks for cones of normals to tell patches that turn their backs.
//! Slopes do not bound how triangles of chords are turned, though: three points that are nearly on one line
//! can make one that faces anywhere. So triangles themselves are looked at.

use glam::{DVec2, DVec3, DVec4, Vec3};
use relief_core::camera::Camera;

use crate::edge::Divides;
use crate::{MeshSettings, MesherError, Shading, View};

/// What is not made of a mesh that one camera looks at: for pictures, not for files.
/// Nothing that the camera sees is left out, and the rest has the same bits as with neither choice. Where
/// what is seen may lie in the shadow of what is not, see [`Outside::of_ways_to`], and backs are to be made.
///
/// With either and with neither, flat base triangles that reach behind the eye in perspective are halved
/// until few points are there, so that most of what is behind can be left out.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cull {
    /// What lies beside the picture, or behind the eye: patches, whatever their relief, and single triangles.
    pub outside: Outside,
    /// Triangles that turn their back to the eye, by more than a rasteriser rounds.
    pub backs: bool,
}

/// Where all of a mesh may lie, also what was left out of it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Everything {
    /// From where to where along the view axis, in metres from the eye.
    pub depths_m: [f64; 2],
    /// Points whose hull has all of it within, but for rounding.
    pub around: Vec<DVec3>,
}

/// Beyond which planes of a view nothing is made: those of its four sides, and that of the eye.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outside {
    planes: [bool; 5],
    beside_m: f64,
}

impl Outside {
    /// Beyond none of them.
    pub const NOTHING: Self = Self { planes: [false; 5], beside_m: 0.0 };

    /// Beyond all of them.
    pub const ALL: Self = Self { planes: [true; 5], beside_m: 0.0 };

    /// Beyond those that no light lies beyond: nothing there is in the way from what is seen to a light, nor
    /// nearer to that way than `beside_m` metres. A light is its position and 1, or the direction toward it
    /// and 0 where it is infinitely far away.
    ///
    /// What is seen lies behind each of the planes. If a light does, too, then so does all of the way to it.
    pub fn of_ways_to(lights: impl IntoIterator<Item = DVec4>, view: &View, beside_m: f64) -> Self {
        let sight = Sight::new(view);
        let mut planes = [true; 5];
        for light in lights {
            for (is_left_out, (normal, out)) in planes.iter_mut().zip(sight.planes) {
                let from_eye = light.truncate() - sight.camera.eye() * light.w;
                *is_left_out &= normal.dot(from_eye) <= out * light.w;
            }
        }
        Self { planes, beside_m }
    }
}

impl Cull {
    /// Whether it leaves anything out.
    pub(crate) fn leaves_out(&self) -> bool {
        self.backs || self.outside.planes.contains(&true)
    }

    /// The planes beyond which something is left out, for a program that tests points of 32 bits, none of
    /// whose coordinates is larger than that many metres: what is left out has a positive sum of the plane's
    /// parts times the point's and 1.
    pub fn planes(&self, view: &View, largest_m: f64) -> [DVec4; 5] {
        let sight = Sight::new(view);
        let eye = sight.camera.eye();
        let room = self.outside.beside_m + ROUNDING_TWICE * largest_m.max(eye.abs().max_element());
        let mut planes = [DVec4::new(0.0, 0.0, 0.0, -1.0); 5];
        for (plane, ((normal, out), is_left_out)) in
            planes.iter_mut().zip(sight.planes.into_iter().zip(self.outside.planes))
        {
            if is_left_out && room.is_finite() {
                *plane = normal.extend(-(normal.dot(eye) + out + room));
            }
        }
        planes
    }
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

/// What shaders round positions and the eye by, and points are rounded by beside the hull of exact ones, as a
/// part of the largest coordinate.
pub const ROUNDING: f64 = 2e-6;

/// The same where the test itself rounds, too.
const ROUNDING_TWICE: f64 = 2.0 * ROUNDING;

/// The least distance of a corner from the opposite side of a triangle that is taken to turn its back, in
/// pixels: nearer, and a rasteriser that rounds corners to a 256th of a pixel may see its front.
const LEAST_PIXELS: f64 = 1.0 / 64.0;

/// What a patch is within: no point of it is farther from the hull of the points, but by rounding.
#[derive(Clone, Copy, Debug)]
pub struct Hull {
    pub points: [DVec3; 6],
    pub radius_m: f64,
}

impl Hull {
    /// Points whose hull has all of it within.
    pub fn around(&self) -> impl Iterator<Item = DVec3> {
        // A ball lies within the octahedron whose sides touch it.
        let reach = self.radius_m * 3.0_f64.sqrt();
        let beside = DVec3::AXES.into_iter().flat_map(move |axis| [axis * reach, -axis * reach]);
        let beside = beside.take(if reach > 0.0 { 6 } else { 1 });
        self.points.into_iter().flat_map(move |point| beside.clone().map(move |beside| point + beside))
    }

    /// The largest coordinate of its points, and of another.
    fn largest(&self, other: DVec3) -> f64 {
        largest(&self.points, other) + self.radius_m
    }
}

/// The largest coordinate of some points, and of another.
fn largest(points: &[DVec3], other: DVec3) -> f64 {
    points.iter().fold(other.abs(), |most, point| most.max(point.abs())).max_element()
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

    /// Whether nothing within a hull is to be made.
    ///
    /// What is seen lies behind all of the planes, also behind those of the sides in perspective, as its
    /// depth is not negative. A hull whose points are farther before one of them than its radius lies before
    /// it.
    pub fn misses(&self, hull: &Hull, outside: &Outside) -> bool {
        self.misses_points(&hull.points, hull.radius_m, outside)
    }

    #[inline(always)]
    fn misses_points(&self, points: &[DVec3], radius_m: f64, outside: &Outside) -> bool {
        let eye = self.camera.eye();
        let largest = largest(points, eye) + radius_m;
        // What is displaced beyond what is stored is kept, and refused when it is made.
        let is_stored = largest <= f64::from(f32::MAX);
        let room = radius_m + ROUNDING * largest + outside.beside_m;
        let is_before =
            |(normal, out): &(DVec3, f64)| points.iter().all(|point| normal.dot(*point - eye) > out + room);
        let planes = self.planes.iter().zip(outside.planes).filter(|(_, is_left_out)| *is_left_out);
        is_stored && planes.map(|(plane, _)| plane).any(is_before)
    }

    /// Whether nothing of a triangle is to be made.
    #[inline(always)]
    pub fn is_unseen(&self, corners: [Vec3; 3], cull: &Cull) -> bool {
        (cull.backs && self.is_back(corners))
            || self.misses_points(&corners.map(Vec3::as_dvec3), 0.0, &cull.outside)
    }

    /// From where to where something within a hull may lie along the view axis, in metres from the eye.
    pub fn depths_m(&self, hull: &Hull) -> [f64; 2] {
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let [near, far] = hull.points.iter().fold(nothing, |[near, far], point| {
            let depth = self.camera.forward().dot(*point - self.camera.eye());
            [near.min(depth), far.max(depth)]
        });
        let room = hull.radius_m + ROUNDING * hull.largest(DVec3::ZERO);
        [near - room, far + room]
    }

    /// Whether no rasteriser sees the front of a triangle: it has no area, or its corners run clockwise in
    /// the picture and are not so nearly in one line that rounding may turn it over.
    #[inline(always)]
    pub fn is_back(&self, corners: [Vec3; 3]) -> bool {
        let [a, b, c] = corners.map(Vec3::as_dvec3);
        let normal = (b - a).cross(c - a);
        if normal == DVec3::ZERO {
            return true;
        }
        let Self { camera, pixels, .. } = self;
        let toward = if camera.is_orthographic() { -camera.forward() } else { camera.eye() - a };
        if normal.dot(toward) > 0.0 {
            return false;
        }
        let mut places = [DVec2::ZERO; 3];
        for (place, corner) in places.iter_mut().zip([a, b, c]) {
            let from_eye = corner - camera.eye();
            let depth = if camera.is_orthographic() { 1.0 } else { camera.forward().dot(from_eye) };
            if depth.is_nan() || depth <= 0.0 {
                return false;
            }
            let aside = DVec2::new(camera.right().dot(from_eye), camera.up().dot(from_eye));
            *place = aside * (pixels / depth);
        }
        let [a, b, c] = places;
        let (ab, ac, bc) = (b - a, c - a, c - b);
        let longest_squared = ab.length_squared().max(ac.length_squared()).max(bc.length_squared());
        let twice_area = ab.perp_dot(ac);
        // The height over the longest side, squared like the side.
        twice_area < 0.0 && twice_area * twice_area > LEAST_PIXELS * LEAST_PIXELS * longest_squared
    }
}
