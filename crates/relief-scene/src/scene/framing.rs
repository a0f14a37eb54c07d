//! Cameras that show what is seen of a scene, in the middle of the picture.

use glam::DVec3;
use relief_core::object::{EMPTY_HEIGHT, ImageObject};
use relief_shaders::Selection;
use relief_shaders::object::Solid;
use relief_shaders::surface::Proposal;

use super::seen_heights::points_of_relief;
use super::view::{Fit, View, aspect_of, axes_of, from_a_side, projection_of};
use super::{SceneObject, Surface};
use relief_core::camera::{Camera, CameraError, Projection};

/// The part of the picture that what is seen fills, along the axis along which it fills more.
const FILLED: f64 = 0.94;

/// The most steps toward the middle of a perspective picture. Each is at another pair of points or the last
/// one, and a few are enough.
const MOST_STEPS: usize = 64;

/// About how many texels of an object's images are looked at. The step from one to the next in an image is then
/// at most 3 % of its side for 100 images, and 1 % for 10: less than the picture's margin.
const OBJECT_TEXELS: f64 = 131_072.0;

/// The most rays that are followed through an object to where they leave it, and the most texels of images
/// that they may cross together.
const OBJECT_RAYS: u64 = 512;
const CROSSED_TEXELS: u64 = 1 << 20;

/// What a fitted camera goes by.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Framing {
    /// All space that the reliefs may fill, between heights 0 and 1. Where the depth of a scene differs from
    /// place to place, it does not lie in the middle of the picture.
    #[default]
    Volume,
    /// What is seen: opposite margins of the picture are equal. From above with parallel rays it fills the
    /// picture to its border.
    Seen,
}

impl Framing {
    /// Whether a view is filled to its border.
    pub fn fills_to_border(self, view: View, fit: Fit) -> bool {
        self == Framing::Seen && view == View::Top && fit == Fit::Orthographic
    }
}

/// The camera that looks from there and sees the scene as large as the picture allows, in its middle.
///
/// # Errors
///
/// When the field of view is impossible, or when meshes are so far apart that numbers overflow.
pub(super) fn fitted_to_seen(
    surfaces: &[Surface],
    view: View,
    fit: Fit,
    size: [u32; 2],
) -> Result<Camera, CameraError> {
    let axes = axes_of(view, fit)?;
    let points = seen_along(surfaces, axes);
    let aspect = aspect_of(size);
    let [across, up, deep] = [0, 1, 2].map(|axis| extent(&points, |point| point[axis]));
    let at = |place: [f64; 3]| axes[0] * place[0] + axes[1] * place[1] + axes[2] * place[2];
    match fit {
        Fit::Orthographic => {
            let filled = if Framing::Seen.fills_to_border(view, fit) { 1.0 } else { FILLED };
            let tall = (up[1] - up[0]).max((across[1] - across[0]) / aspect) / filled;
            let tall = from_a_side(tall, deep);
            let [x, y, z] = [across, up, deep].map(middle);
            let (eye, target) = (at([x, y, deep[1] + 0.5 * tall]), at([x, y, z]));
            Camera::with(eye, target, Projection::Orthographic { height_m: tall })
        }
        Fit::Perspective(_) => {
            let projection = projection_of(fit);
            let half_height =
                Camera::with(view.toward_eye(), DVec3::ZERO, projection)?.half_height() * FILLED;
            // Through opposite edges of the part that is filled go planes that all points are between. They
            // meet where the eye is nearest; the axis along which that is farther decides.
            let nearest = [half_height * aspect, half_height].into_iter().enumerate().map(|(axis, tan)| {
                let [low, _] = extent(&points, |point| point[axis] - tan * point.z);
                let [_, high] = extent(&points, |point| point[axis] + tan * point.z);
                0.5 * (high - low) / tan
            });
            // Where a scene is flat and seen from its edge there is still a way to it.
            let least = deep[1] + 1e-3 * (deep[1] - deep[0]).max(1e-6);
            let depth = nearest.fold(least, f64::max);
            let [x, y] = [0, 1].map(|axis| middle_in_perspective(&points, axis, depth));
            Camera::with(at([x, y, depth]), at([x, y, middle(deep)]), projection)
        }
    }
}

/// The size of a picture in the proportions of what is seen from a side by parallel rays, its longer side
/// `longer` pixels; none where nothing has a width or a height.
pub(super) fn proportional_size(surfaces: &[Surface], view: View, longer: u32) -> Option<[u32; 2]> {
    let points = seen_along(surfaces, axes_of(view, Fit::Orthographic).ok()?);
    let sides_m = [0, 1].map(|axis| extent(&points, |point| point[axis])).map(|[low, high]| high - low);
    let longer_m = sides_m[0].max(sides_m[1]);
    let is_proportion = longer_m > 0.0 && longer_m.is_finite();
    let side = |side_m: f64| (side_m / longer_m * f64::from(longer)).round().max(1.0) as u32;
    is_proportion.then(|| sides_m.map(side))
}

/// The place of an eye at `depth` along an axis of the picture from which points reach as far to one side as
/// to the other.
///
/// With the tangent `t` of half the angle that they fill, the place lies from the greatest of
/// `a - t (depth - z)` to the least of `a + t (depth - z)` of all points, and both are equal where they reach
/// as far to both sides. The first less the second is convex in `t` and at `t = 0` not negative, so that
/// Newton's steps from there never go past the root, and each is at another pair of points.
fn middle_in_perspective(points: &[DVec3], axis: usize, depth: f64) -> f64 {
    let mut tan = 0.0;
    let mut place = 0.0;
    for _ in 0..MOST_STEPS {
        let mut ends = [(f64::INFINITY, 0.0), (f64::NEG_INFINITY, 0.0)];
        for point in points {
            let (low, high) = (point[axis] - tan * point.z, point[axis] + tan * point.z);
            if low < ends[0].0 {
                ends[0] = (low, point.z);
            }
            if high > ends[1].0 {
                ends[1] = (high, point.z);
            }
        }
        let [(low, low_z), (high, high_z)] = ends;
        place = 0.5 * (low + high);
        // The points' own places along the axis.
        let apart = (high - tan * high_z) - (low + tan * low_z);
        let next = apart / (2.0 * depth - low_z - high_z);
        // Not a number is no step either.
        let is_step = next > tan;
        if !is_step {
            break;
        }
        tan = next;
    }
    place
}

fn middle([low, high]: [f64; 2]) -> f64 {
    0.5 * (low + high)
}

/// The least and the greatest of a measure over points.
fn extent(points: &[DVec3], measure: impl Fn(&DVec3) -> f64) -> [f64; 2] {
    let nothing = [f64::INFINITY, f64::NEG_INFINITY];
    points.iter().map(measure).fold(nothing, |[low, high], value| [low.min(value), high.max(value)])
}

/// Points around all that is seen of the surfaces, along the axes.
fn seen_along(surfaces: &[Surface], axes: [DVec3; 3]) -> Vec<DVec3> {
    let mut points: Vec<DVec3> = surfaces.iter().flat_map(seen).collect();
    for point in &mut points {
        *point = axes.map(|axis| point.dot(axis)).into();
    }
    points
}

/// Points in whose hull all lies that is seen of a surface.
fn seen(surface: &Surface) -> Vec<DVec3> {
    let points = surface.object().map(|object| seen_of_object(object, surface.selection()));
    if let Some(points) = points.filter(|points| !points.is_empty()) {
        return points;
    }
    let (mesh, selection) = (surface.mesh(), surface.selection());
    let paths = selection.paths();
    let lies_beside = if paths.has_relief() {
        // The relief is seen through its triangles, in their shells, or beside its quadrics.
        paths.proposal == Proposal::Shells || selection.quadrics().is_some()
    } else {
        !paths.shown.is_of_images() && selection.geometry().is_some()
    };
    if lies_beside {
        let has_backs = paths.proposal == Proposal::Shells && surface.two_sided();
        return points_of_relief(mesh, surface.height_map(), has_backs);
    }
    let mut is_used = vec![false; mesh.vertices().len()];
    for &corner in mesh.triangles().iter().flatten() {
        is_used[corner as usize] = true;
    }
    let used = mesh.vertices().iter().zip(is_used).filter(|(_, is_used)| *is_used);
    used.map(|(vertex, _)| vertex.position.as_dvec3()).collect()
}

/// Points of an object: those that its images see, and where some rays through them enter and leave it.
fn seen_of_object(shown: &SceneObject, selection: &Selection) -> Vec<DVec3> {
    let object = shown.object();
    let is_hull = selection.object_cells().is_some_and(|cells| cells.solid == Solid::Hull);
    let (edges, inside) = seen_texels(object);
    let sides = object.views().iter().map(|view| u64::from(view.size()[0].max(view.size()[1])));
    let rays = (CROSSED_TEXELS / sides.sum::<u64>().max(1)).clamp(1, OBJECT_RAYS);
    let some = |texels: &[SeenTexel], rays: u64| -> Vec<SeenTexel> {
        let step = (texels.len() as u64).div_ceil(rays).max(1) as usize;
        texels.iter().step_by(step).copied().collect()
    };
    // The corners of a visual hull lie where silhouettes end.
    let of_inside = if is_hull { 0 } else { rays / 2 };
    let mut followed = some(&edges, rays - of_inside);
    if of_inside > 0 {
        followed.extend(some(&inside, of_inside));
    }
    let ends = followed.into_iter().flat_map(|(number, [u, v, _])| {
        let ray = object.views()[number].ray(u, v);
        let intervals = if is_hull { object.hull_intervals(&ray) } else { object.intervals(&ray) };
        let ends = intervals.first().map(|[start, _]| *start).into_iter();
        let ends: Vec<f64> = ends.chain(intervals.last().map(|[_, end]| *end)).collect();
        ends.into_iter().flat_map(move |t| around(object, number, ray.at(t)))
    });
    let mut points: Vec<DVec3> = ends.filter(|point| point.is_finite()).collect();
    let hit = |&(number, at): &SeenTexel| (number, object.views()[number].point(at.into()));
    // What an image sees and others deny is no part of the object.
    let bounds = object.bounds();
    let slack = 1e-6 * object.views()[0].ball().1;
    let is_part = |point: &DVec3| {
        let is_inside =
            |[low, high]: [DVec3; 2]| point.cmpge(low - slack).all() && point.cmple(high + slack).all();
        point.is_finite() && bounds.is_none_or(is_inside)
    };
    if !is_hull || points.is_empty() {
        points.extend(inside.iter().map(|texel| hit(texel).1).filter(is_part));
        let of_edges = edges.iter().map(hit).flat_map(|(number, point)| around(object, number, point));
        points.extend(of_edges.filter(is_part));
    }
    points
}

/// Points half a texel of an image beside one: so far reaches what a texel at an edge shows.
fn around(object: &ImageObject, number: usize, point: DVec3) -> [DVec3; 4] {
    let view = &object.views()[number];
    let [right, down, _] = view.axes();
    let half = 0.5 * view.texel_m();
    [right * half, right * -half, down * half, down * -half].map(|aside| point + aside)
}

/// A texel of an object's images that sees something: the number of the image, and the texel's place and
/// height in it.
type SeenTexel = (usize, [f64; 3]);

/// Texels that see something, evenly over all images: those beside which nothing is seen, and the others.
fn seen_texels(object: &ImageObject) -> (Vec<SeenTexel>, Vec<SeenTexel>) {
    let sizes = object.views().iter().map(|view| view.size().map(f64::from));
    let step = (sizes.map(|[columns, rows]| columns * rows).sum::<f64>() / OBJECT_TEXELS).sqrt().ceil();
    let step = step.max(1.0) as u32;
    let (mut edges, mut inside) = (Vec::new(), Vec::new());
    for (number, (view, place)) in object.views().iter().zip(object.layout().places()).enumerate() {
        let [columns, rows] = view.size();
        let height_at = |x: u32, y: u32| {
            let at = (x < columns && y < rows).then(|| [place[0] + x, place[1] + y].map(i64::from));
            at.map_or(0.0, |[x, y]| f64::from(object.heights().texel(x, y)))
        };
        for y in (0..rows).step_by(step as usize) {
            for x in (0..columns).step_by(step as usize) {
                let height = height_at(x, y);
                if height <= EMPTY_HEIGHT {
                    continue;
                }
                let [u, v] =
                    [(x, columns), (y, rows)].map(|(at, side)| (f64::from(at) + 0.5) / f64::from(side));
                let beside =
                    [(x.wrapping_sub(step), y), (x + step, y), (x, y.wrapping_sub(step)), (x, y + step)];
                let is_edge = beside.into_iter().any(|(x, y)| height_at(x, y) <= EMPTY_HEIGHT);
                let texels = if is_edge { &mut edges } else { &mut inside };
                texels.push((number, [u, v, height]));
            }
        }
    }
    (edges, inside)
}
