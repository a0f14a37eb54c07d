//! Culling: parts of a displaced mesh that a camera cannot see.
//!
//! Source: Gumhold and Hüttner 1999. Section 3.3 moves the planes of the view out by the greatest
//! displacement of all (equations 7 and 8). Here each patch is bounded by its own least and
//! greatest displacement, along its own directions. Section 6 asks for cones of normals, to find
//! patches that face away. Slopes of the relief do not bound how triangles over it are turned:
//! three points nearly on one line can make a triangle that faces anywhere. So each triangle is
//! tested itself.

use glam::{DVec2, DVec3, DVec4, Vec3};
use relief_core::camera::Camera;

use crate::edge::Divides;
use crate::{MeshSettings, MesherError, Shading, View};

/// Parts of a mesh that are left out for one camera: for pictures, not for files.
///
/// Nothing that the camera sees is left out, and the rest has the same bits as without culling. If
/// invisible parts may cast shadows on visible ones, create `outside` by [`Outside::of_light_paths`]
/// and keep `backs` false.
///
/// With any value of this type, flat base triangles that reach behind the eye in perspective are
/// halved until few points are there. Most of what is behind can then be left out.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cull {
    /// Patches beside the picture or behind the eye, at any height of their relief, and single
    /// triangles there.
    pub outside: Outside,
    /// Triangles that face away from the eye, by more than a rasteriser rounds.
    pub backs: bool,
}

/// Bounds of a whole mesh, including the parts that are left out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FullBounds {
    /// Least and greatest depth along the view axis, in metres from the eye.
    pub depths_m: [f64; 2],
    /// Points whose convex hull contains the mesh, up to rounding.
    pub around: Vec<DVec3>,
}

/// Planes of a view beyond which nothing is made: its four sides and the plane of the eye.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Outside {
    planes: [bool; 5],
    beside_m: f64,
}

impl Outside {
    /// Leaves nothing out.
    pub const NOTHING: Self = Self { planes: [false; 5], beside_m: 0.0 };

    /// Leaves out all parts beyond any of the planes.
    pub const ALL: Self = Self { planes: [true; 5], beside_m: 0.0 };

    /// Leaves out the parts beyond each plane that has no light beyond it.
    ///
    /// Nothing there lies between a visible point and a light, or within `beside_m` metres of the
    /// line between them. A light is its position and 1, or the direction toward it and 0 if it is
    /// infinitely far away.
    ///
    /// Visible points lie behind each of the planes. If a light does too, so does the whole line to
    /// it.
    pub fn of_light_paths(lights: impl IntoIterator<Item = DVec4>, view: &View, beside_m: f64) -> Self {
        let volume = ViewVolume::new(view);
        let mut planes = [true; 5];
        for light in lights {
            for (is_left_out, (normal, out)) in planes.iter_mut().zip(volume.planes) {
                let from_eye = light.truncate() - volume.camera.eye() * light.w;
                *is_left_out &= normal.dot(from_eye) <= out * light.w;
            }
        }
        Self { planes, beside_m }
    }
}

impl Cull {
    /// Returns whether anything is left out.
    pub(crate) fn leaves_out(&self) -> bool {
        self.backs || self.outside.planes.contains(&true)
    }

    /// Returns the planes beyond which parts are left out, for a test of `f32` points whose
    /// coordinates are at most `largest_m` metres.
    ///
    /// A point is left out if the dot product of a plane and `(point, 1)` is positive.
    pub fn planes(&self, view: &View, largest_m: f64) -> [DVec4; 5] {
        let volume = ViewVolume::new(view);
        let eye = volume.camera.eye();
        let margin = self.outside.beside_m + ROUNDING_TWICE * largest_m.max(eye.abs().max_element());
        let mut planes = [DVec4::new(0.0, 0.0, 0.0, -1.0); 5];
        for (plane, ((normal, out), is_left_out)) in
            planes.iter_mut().zip(volume.planes.into_iter().zip(self.outside.planes))
        {
            if is_left_out && margin.is_finite() {
                *plane = normal.extend(-(normal.dot(eye) + out + margin));
            }
        }
        planes
    }
}

/// Returns an error where culling makes no sense with the other settings.
pub fn check(settings: &MeshSettings) -> Result<(), MesherError> {
    if settings.cull.is_none() {
        return Ok(());
    }
    if !matches!(settings.edges.divides, Divides::Voxels(_)) {
        return Err(MesherError::CullOfNoView { edges: settings.edges.name });
    }
    if settings.shading == Shading::Mesh { Err(MesherError::CullOfMeshNormals) } else { Ok(()) }
}

/// Margin around the picture in pixels: more than rays and rasterisers round.
const BESIDE_PIXELS: f64 = 1.0;

/// Rounding of positions and the eye in shaders, and of points beside the hull of exact ones, as a
/// part of the largest coordinate.
pub const ROUNDING: f64 = 2e-6;

/// [`ROUNDING`] where the test itself rounds, too.
const ROUNDING_TWICE: f64 = 2.0 * ROUNDING;

/// Least distance in pixels of a corner from the opposite side of a triangle that counts as facing
/// away. A rasteriser that rounds corners to 1/256 of a pixel may see the front of a thinner one.
const LEAST_PIXELS: f64 = 1.0 / 64.0;

/// Bound of a patch: its points lie within `radius_m` of the convex hull of `points`, up to
/// rounding.
#[derive(Clone, Copy, Debug)]
pub struct Hull {
    pub points: [DVec3; 6],
    pub radius_m: f64,
}

impl Hull {
    /// Returns points whose convex hull contains the patch.
    pub fn around(&self) -> impl Iterator<Item = DVec3> {
        // A ball lies within the octahedron whose sides touch it.
        let reach = self.radius_m * 3.0_f64.sqrt();
        let beside = DVec3::AXES.into_iter().flat_map(move |axis| [axis * reach, -axis * reach]);
        let beside = beside.take(if reach > 0.0 { 6 } else { 1 });
        self.points.into_iter().flat_map(move |point| beside.clone().map(move |beside| point + beside))
    }

    /// Returns the largest coordinate of the hull and of `other`.
    fn largest(&self, other: DVec3) -> f64 {
        largest(&self.points, other) + self.radius_m
    }
}

/// Returns the largest coordinate of `points` and of `other`.
fn largest(points: &[DVec3], other: DVec3) -> f64 {
    points.iter().fold(other.abs(), |most, point| most.max(point.abs())).max_element()
}

/// View volume of a camera.
#[derive(Clone, Copy, Debug)]
pub struct ViewVolume {
    camera: Camera,
    /// Outward unit normals of the planes, and the planes' distances from the eye.
    planes: [(DVec3, f64); 5],
    /// Pixels per metre; in perspective at a depth of 1 m.
    pixels: f64,
}

impl ViewVolume {
    pub fn new(view: &View) -> Self {
        let (camera, [width, height]) = (view.camera, view.size.map(f64::from));
        let half = camera.half_height();
        let pixels = height / (2.0 * half);
        let margin = BESIDE_PIXELS / pixels;
        let [right, up, forward] = [camera.right(), camera.up(), camera.forward()];
        let side = |aside: DVec3, to: f64| {
            let to = to + margin;
            if camera.is_orthographic() { (aside, to) } else { ((aside - forward * to).normalize(), 0.0) }
        };
        let wide = half * width / height;
        let planes =
            [side(right, wide), side(-right, wide), side(up, half), side(-up, half), (-forward, 0.0)];
        Self { camera, planes, pixels }
    }

    /// Returns whether nothing within a hull is to be made.
    ///
    /// Visible points lie behind all planes, in perspective also behind the side planes, as their
    /// depth is not negative. A hull whose points are all farther before one plane than its radius
    /// lies before that plane.
    pub fn misses(&self, hull: &Hull, outside: &Outside) -> bool {
        self.misses_points(&hull.points, hull.radius_m, outside)
    }

    #[inline(always)]
    fn misses_points(&self, points: &[DVec3], radius_m: f64, outside: &Outside) -> bool {
        let eye = self.camera.eye();
        let largest = largest(points, eye) + radius_m;
        // Points beyond the range of `f32` are not left out here: making them fails with an error.
        let is_stored = largest <= f64::from(f32::MAX);
        let margin = radius_m + ROUNDING * largest + outside.beside_m;
        let is_before =
            |(normal, out): &(DVec3, f64)| points.iter().all(|point| normal.dot(*point - eye) > out + margin);
        let planes = self.planes.iter().zip(outside.planes).filter(|(_, is_left_out)| *is_left_out);
        is_stored && planes.map(|(plane, _)| plane).any(is_before)
    }

    /// Returns whether a triangle is left out.
    #[inline(always)]
    pub fn is_unseen(&self, corners: [Vec3; 3], cull: &Cull) -> bool {
        (cull.backs && self.is_back(corners))
            || self.misses_points(&corners.map(Vec3::as_dvec3), 0.0, &cull.outside)
    }

    /// Returns the least and greatest depth of a hull along the view axis, in metres from the eye.
    pub fn depths_m(&self, hull: &Hull) -> [f64; 2] {
        let nothing = [f64::INFINITY, f64::NEG_INFINITY];
        let [near, far] = hull.points.iter().fold(nothing, |[near, far], point| {
            let depth = self.camera.forward().dot(*point - self.camera.eye());
            [near.min(depth), far.max(depth)]
        });
        let margin = hull.radius_m + ROUNDING * hull.largest(DVec3::ZERO);
        [near - margin, far + margin]
    }

    /// Returns whether no rasteriser sees the front of a triangle. It then has no area, or its
    /// corners run clockwise in the picture. They lie far enough from one line that rounding cannot
    /// turn it over.
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
