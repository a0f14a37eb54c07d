//! Cameras fitted to the visible part of a scene, which lies in the middle of the picture.

use glam::DVec3;
use relief_core::mesh::Vertex;
use relief_core::object::{EMPTY_HEIGHT, ImageObject};
use relief_shaders::Selection;
use relief_shaders::field::Solids;
use relief_shaders::object::Solid;
use relief_shaders::surface::Proposal;

use super::hull_points::points_of_relief;
use super::view::{Fit, View, aspect_of, axes_of, from_a_side, projection_of};
use super::{SceneObject, Surface};
use relief_core::camera::{Camera, CameraError, Projection};

/// Part of the picture that the visible scene fills, along the axis that it fills more.
const FILLED: f64 = 0.94;

/// Most steps toward the middle of a perspective picture. Each step uses another pair of points or
/// is the last, and a few are enough.
const MOST_STEPS: usize = 64;

/// Approximate number of texels sampled from an object's images. The step between samples in an
/// image is then at most 3 % of its side for 100 images, and 1 % for 10. The picture's margin is
/// wider.
const OBJECT_TEXELS: f64 = 131_072.0;

/// Most rays that are traced through an object to their exit, and most texels of images that they
/// may cross together.
const OBJECT_RAYS: u64 = 512;
const CROSSED_TEXELS: u64 = 1 << 20;

/// Extent of a scene that a fitted camera shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Framing {
    /// The whole space between heights 0 and 1 of every relief. If the depth differs from place to
    /// place, the scene is not in the middle of the picture.
    #[default]
    Volume,
    /// The visible surface. Opposite margins of the picture are equal. From the view `top` with
    /// parallel rays, it fills the picture to its border.
    Visible,
}

impl Framing {
    /// Returns whether the scene fills the picture to its border, without a margin.
    pub fn fills_to_border(self, view: View, fit: Fit) -> bool {
        self == Framing::Visible && view == View::Top && fit == Fit::Orthographic
    }
}

/// Returns the camera in a view that shows the visible scene in the middle of the picture, as large
/// as the picture allows.
///
/// # Errors
///
/// When the field of view is impossible, or when meshes are so far apart that numbers overflow.
pub(super) fn fitted_to_visible(
    surfaces: &[Surface],
    view: View,
    fit: Fit,
    size: [u32; 2],
) -> Result<Camera, CameraError> {
    let axes = axes_of(view, fit)?;
    let points = points_along(surfaces, axes);
    let aspect = aspect_of(size);
    let [across, up, deep] = [0, 1, 2].map(|axis| extent(&points, |point| point[axis]));
    let at = |place: [f64; 3]| axes[0] * place[0] + axes[1] * place[1] + axes[2] * place[2];
    match fit {
        Fit::Orthographic => {
            let filled = if Framing::Visible.fills_to_border(view, fit) { 1.0 } else { FILLED };
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
            // Planes through opposite edges of the filled part enclose all points. They meet at the
            // nearest possible eye. The axis with the farther eye decides.
            let nearest = [half_height * aspect, half_height].into_iter().enumerate().map(|(axis, tan)| {
                let [low, _] = extent(&points, |point| point[axis] - tan * point.z);
                let [_, high] = extent(&points, |point| point[axis] + tan * point.z);
                0.5 * (high - low) / tan
            });
            // A flat scene seen edge-on still needs a distance from the eye.
            let least = deep[1] + 1e-3 * (deep[1] - deep[0]).max(1e-6);
            let depth = nearest.fold(least, f64::max);
            let [x, y] = [0, 1].map(|axis| middle_in_perspective(&points, axis, depth));
            Camera::with(at([x, y, depth]), at([x, y, middle(deep)]), projection)
        }
    }
}

/// Returns the size of a picture in the proportions of the scene, seen in a view by parallel rays.
/// Its longer side has `longer` pixels. `None` if the scene has neither width nor height.
pub(super) fn proportional_size(surfaces: &[Surface], view: View, longer: u32) -> Option<[u32; 2]> {
    let points = points_along(surfaces, axes_of(view, Fit::Orthographic).ok()?);
    let sides_m = [0, 1].map(|axis| extent(&points, |point| point[axis])).map(|[low, high]| high - low);
    let longer_m = sides_m[0].max(sides_m[1]);
    let is_proportion = longer_m > 0.0 && longer_m.is_finite();
    let side = |side_m: f64| (side_m / longer_m * f64::from(longer)).round().max(1.0) as u32;
    is_proportion.then(|| sides_m.map(side))
}

/// Returns the position of an eye at `depth` along an axis of the picture, such that points reach
/// equally far to both sides.
///
/// Let `t` be the tangent of half the angle that the points fill. The position lies between two
/// bounds over all points: the greatest `a - t (depth - z)` and the least `a + t (depth - z)`. Both
/// are equal if the points reach equally far to both sides. The first minus the second is convex in
/// `t`, and at `t = 0` not negative. So Newton's steps from there never pass the root, and each
/// uses another pair of points.
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
        // The points' own positions along the axis.
        let apart = (high - tan * high_z) - (low + tan * low_z);
        let next = apart / (2.0 * depth - low_z - high_z);
        // NaN is no step either.
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

/// Returns the least and the greatest measure over points.
fn extent(points: &[DVec3], measure: impl Fn(&DVec3) -> f64) -> [f64; 2] {
    let nothing = [f64::INFINITY, f64::NEG_INFINITY];
    points.iter().map(measure).fold(nothing, |[low, high], value| [low.min(value), high.max(value)])
}

/// Returns points around the visible part of all surfaces, as coordinates along the axes.
fn points_along(surfaces: &[Surface], axes: [DVec3; 3]) -> Vec<DVec3> {
    let mut points: Vec<DVec3> = surfaces.iter().flat_map(points_of_surface).collect();
    for point in &mut points {
        *point = axes.map(|axis| point.dot(axis)).into();
    }
    points
}

/// Returns points whose convex hull contains the visible part of a surface.
fn points_of_surface(surface: &Surface) -> Vec<DVec3> {
    let points = surface.object().map(|object| points_of_object(object, surface.selection()));
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
    if lies_beside && surface.solids() != Solids::Heights {
        // A volume or a motif may be solid at any height.
        let map = surface.height_map();
        let heights = [map.bias_m(), map.bias_m() + map.scale_m()];
        let vertices = mesh.vertices().iter();
        let at =
            |vertex: &Vertex, height: f64| vertex.position.as_dvec3() + vertex.normal.as_dvec3() * height;
        return vertices.flat_map(|vertex| heights.map(|height| at(vertex, height))).collect();
    }
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

/// Returns points of an object: those that its images show, and the entries and exits of some rays
/// through them.
fn points_of_object(shown: &SceneObject, selection: &Selection) -> Vec<DVec3> {
    let object = shown.object();
    let is_hull = selection.object_cells().is_some_and(|cells| cells.solid == Solid::Hull);
    let (edges, inside) = covered_texels(object);
    let sides = object.views().iter().map(|view| u64::from(view.size()[0].max(view.size()[1])));
    let rays = (CROSSED_TEXELS / sides.sum::<u64>().max(1)).clamp(1, OBJECT_RAYS);
    let some = |texels: &[CoveredTexel], rays: u64| -> Vec<CoveredTexel> {
        let step = (texels.len() as u64).div_ceil(rays).max(1) as usize;
        texels.iter().step_by(step).copied().collect()
    };
    // The corners of a visual hull lie on the borders of silhouettes.
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
    let hit = |&(number, at): &CoveredTexel| (number, object.views()[number].point(at.into()));
    // A point that one image shows and another excludes is no part of the object.
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

/// Returns points half a texel of an image beside `point`. A texel at an edge shows the object that
/// far.
fn around(object: &ImageObject, number: usize, point: DVec3) -> [DVec3; 4] {
    let view = &object.views()[number];
    let [right, down, _] = view.axes();
    let half = 0.5 * view.texel_m();
    [right * half, right * -half, down * half, down * -half].map(|aside| point + aside)
}

/// Texel of an object's images that shows the object: the index of the image, and the texel's
/// position and height in it.
type CoveredTexel = (usize, [f64; 3]);

/// Returns texels that show the object, spread evenly over all images: texels beside an empty one,
/// then the others.
fn covered_texels(object: &ImageObject) -> (Vec<CoveredTexel>, Vec<CoveredTexel>) {
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
