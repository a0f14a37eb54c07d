//! Views of the shadow maps.
//!
//! A directional light has a cascade of shadow maps with parallel rays. Each covers what the camera
//! sees in a range of depths, as far as there are surfaces. A point light has the faces of a cube
//! around it that show any surface. A shadow map with parallel rays covers all that lies between
//! the light and what it shows.

use std::ops::RangeInclusive;

use glam::{DMat4, DVec3, DVec4};
use relief_shaders::cpu::{Corner, Frame, LightView, Vec4};
use relief_shaders::surface::Proposal;
use relief_shaders::{LIGHT_FACES, SHADOW, Selection};

use crate::job::JobSurface;
use relief_core::camera::Camera;
use relief_scene::light::Light;
use relief_scene::shadow_map::{filter_texels, shadow_map_side};
use relief_scene::{Scene, Surface};

/// Texels at a shadow map's border besides half a filter, for rounding.
const BORDER: f64 = 2.0;

/// Least part of a shadow map that remains without its border.
const LEAST_INSIDE: f64 = 0.5;

/// Near plane of a point light's shadow map, as a part of the far plane. What is nearer casts no
/// shadow.
const NEAREST: f64 = 1e-4;

/// Depth below which keys are ordered less finely, as a part of the greatest depth.
const NEAR_OF_KEYS: f64 = 0.01;

/// Weight of the logarithmic split of cascades against the even one (Zhang et al. 2006,
/// Parallel-split shadow maps, section 3.2).
const LOGARITHMIC: f64 = 0.5;

/// Width of a light's ray, as a part of a pixel's width. It is next to nothing, so that the finest
/// level of detail is traced.
const SAMPLE_WIDTH: f32 = 1e-12;

/// Views of all shadow maps of a frame.
#[derive(Clone, Debug, Default)]
pub struct LightViews {
    /// Side of each shadow map, in texels.
    pub size: u32,
    /// Frames that render the shadow maps, light by light.
    pub frames: Vec<Frame>,
    views: Vec<LightView>,
    /// First view of each light, and the number of its views.
    of_lights: Vec<[u32; 2]>,
}

impl LightViews {
    /// Creates the views of the shadow maps that surfaces read; none where no surface does. Their
    /// resolution follows the columns and rows of `frame`. The filter width is set in each surface.
    pub(crate) fn new(
        lights: &[Light],
        camera: &Camera,
        frame: [u32; 2],
        surfaces: &mut [JobSurface],
    ) -> Self {
        let asked = ShadowMapNeeds::by(surfaces.iter().map(|surface| &surface.selection), frame);
        asked.map_or_else(Self::default, |asked| Self::asked(&asked, lights, camera, frame, surfaces))
    }

    fn asked(
        asked: &ShadowMapNeeds,
        lights: &[Light],
        camera: &Camera,
        frame: [u32; 2],
        surfaces: &mut [JobSurface],
    ) -> Self {
        let ShadowMapNeeds { shape, most, cascades, .. } = *asked;
        for JobSurface { settings, selection, .. } in surfaces.iter_mut() {
            if selection.light_views().is_some() {
                let texels = selection.choices[SHADOW].params[2];
                settings.choices[SHADOW].params.z = filter_texels(texels, most, shape.size);
            }
        }
        let (size, aspect) = (shape.size, f64::from(frame[0]) / f64::from(frame[1]));
        let surfaces = &*surfaces;
        let points: Vec<DVec3> = surfaces.iter().flat_map(relief_points).collect();
        let mut made = Self { size, ..Self::default() };
        for light in lights {
            let views = match *light {
                Light::Directional { toward, .. } => {
                    let seen = depths_seen(camera, &points);
                    let ends = cascade_ends(camera, seen, cascades);
                    let each = ends.windows(2).filter_map(|ends| {
                        let shown = corners(camera, aspect, [ends[0], ends[1]]);
                        shape.parallel(toward, &points, &shown)
                    });
                    each.collect::<Vec<ShadowView>>()
                }
                Light::Point { position_m, .. } => shape.cube(position_m, &points),
            };
            made.of_lights.push([made.views.len() as u32, views.len() as u32]);
            made.views.extend(views.iter().map(ShadowView::shader_view));
            made.frames.extend(views.iter().map(ShadowView::frame));
        }
        made
    }

    /// Creates the views with shadow maps of the given side, whatever the frame asks for.
    #[cfg(test)]
    pub(crate) fn of_side(
        side: u32,
        lights: &[Light],
        camera: &Camera,
        frame: [u32; 2],
        surfaces: &mut [JobSurface],
    ) -> Self {
        let selections = || surfaces.iter().map(|surface| &surface.selection);
        let ShadowMapNeeds { most, cascades, .. } =
            ShadowMapNeeds::by(selections(), frame).expect("shadows are looked up");
        let asked = ShadowMapNeeds::of_side(selections(), side, most, cascades);
        Self::asked(&asked, lights, camera, frame, surfaces)
    }

    /// Writes the views into a frame.
    pub(crate) fn write_into(&self, frame: &mut Frame) {
        for (light, [first, count]) in frame.lights.iter_mut().zip(&self.of_lights) {
            (light.first_view, light.views) = (*first, *count);
        }
        for (slot, view) in frame.light_views.iter_mut().zip(&self.views) {
            *slot = *view;
        }
    }
}

/// Requirements of all surfaces on the shadow maps.
struct ShadowMapNeeds {
    shape: ShadowMapShape,
    /// Largest allowed side of a shadow map, in texels.
    most: u32,
    cascades: u32,
    /// Texels beside a point's own that a lookup may read.
    beside: f64,
}

impl ShadowMapNeeds {
    /// Combines the requirements of surfaces for a frame of the given columns and rows; `None`
    /// where no surface reads shadow maps.
    fn by<'a>(selections: impl Iterator<Item = &'a Selection> + Clone, frame: [u32; 2]) -> Option<Self> {
        let asked = selections.clone().filter_map(Selection::light_views);
        let [most, cascades] = asked.reduce(|[a, b], [c, d]| [a.max(c), b.max(d)])?;
        Some(Self::of_side(selections, shadow_map_side(most, frame), most, cascades))
    }

    /// Combines the requirements for shadow maps of the given side.
    fn of_side<'a>(
        selections: impl Iterator<Item = &'a Selection>,
        size: u32,
        most: u32,
        cascades: u32,
    ) -> Self {
        let filters = selections.filter(|selection| selection.light_views().is_some());
        let filters = filters.map(|selection| selection.choices[SHADOW].params[2]);
        let filter = filters.map(|texels| filter_texels(texels, most, size)).fold(0.0, f32::max);
        let beside = 0.5 * f64::from(filter) + BORDER;
        let inside = (f64::from(size) - 2.0 * beside) / f64::from(size);
        let shape = ShadowMapShape { size, inside: inside.max(LEAST_INSIDE) };
        Self { shape, most, cascades, beside }
    }
}

/// Returns the distance in metres from a shadow ray within which geometry can change what a shadow
/// map lookup finds; 0 where no surface reads shadow maps.
pub fn beside_m(scene: &Scene) -> f64 {
    let selections = scene.surfaces().iter().map(Surface::selection);
    let Some(ShadowMapNeeds { shape, beside, .. }) = ShadowMapNeeds::by(selections, scene.size()) else {
        return 0.0;
    };
    // Bounds of the scene, with a margin: directions of displacement are at most twice as long as
    // normals.
    let boxes = scene.surfaces().iter().map(|surface| {
        let map = surface.height_map();
        let margin = DVec3::splat(4.0 * (map.bias_m().abs() + map.scale_m().abs()));
        let nothing = [DVec3::INFINITY, DVec3::NEG_INFINITY];
        let [least, greatest] =
            surface.mesh().vertices().iter().fold(nothing, |[least, greatest], vertex| {
                let at = vertex.position.as_dvec3();
                [least.min(at), greatest.max(at)]
            });
        [least - margin, greatest + margin]
    });
    let all = boxes.reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]);
    let [least, greatest] = all.unwrap_or([DVec3::ZERO; 2]);
    let widest = scene.lights().iter().map(|light| match *light {
        Light::Directional { .. } => least.distance(greatest),
        // Pictures of a cube are twice as wide as they are deep.
        Light::Point { position_m, .. } => {
            2.0 * (least - position_m).abs().max((greatest - position_m).abs()).max_element()
        }
    });
    // One texel more for the way's own place in its texel.
    let texels = f64::from(shape.size) * shape.inside;
    widest.fold(0.0, f64::max) / texels * (beside + 1.0) * 2.0_f64.sqrt()
}

/// Returns points whose hull holds all of a surface's relief, up to rounding.
pub fn relief_points(surface: &JobSurface) -> impl Iterator<Item = DVec3> {
    let settings = &surface.settings;
    let (bias, scale) = (settings.bias_m, settings.scale_m);
    let shell_m = [settings.shell_m.x, settings.shell_m.y];
    let (proposal, both) = (surface.selection.paths().proposal, surface.two_sided);
    // Without relief on triangles, their corners are enough, or the points around these and culled
    // ones.
    let around = surface.triangles.around();
    let has_shells = proposal == Proposal::Shells;
    let (bare, count) = match surface.selection.paths().has_relief() || has_shells {
        true => (&[][..], surface.triangles.len()),
        false if around.is_some() => (&[][..], 0),
        false => (surface.triangles.corners(), 0),
    };
    let under_relief = surface.triangles.iter().take(count).flat_map(move |triangle| {
        let [low, high] = match proposal {
            // Some surfaces move their base out, and carve all relief into it.
            Proposal::Polygons => [bias.min(-scale), (bias + scale).max(0.0)],
            Proposal::Shells => triangle.shell.offsets_m(shell_m),
        };
        let ends = if both { [low.min(-high), high.max(-low)] } else { [low, high] };
        [triangle.a, triangle.b, triangle.c].into_iter().flat_map(move |corner| {
            let (position, normal) = (corner_position(&corner), three(corner.normal));
            ends.map(|offset| position + normal * f64::from(offset))
        })
    });
    bare.iter().map(corner_position).chain(around.unwrap_or_default().iter().copied()).chain(under_relief)
}

fn three(v: relief_shaders::cpu::Vec3<f32>) -> DVec3 {
    DVec3::new(v.x.into(), v.y.into(), v.z.into())
}

/// Returns the position of a corner, in metres.
pub fn corner_position(corner: &Corner) -> DVec3 {
    three(corner.position)
}

/// Returns the least and the greatest value of a measure over points.
fn extent(points: &[DVec3], measure: impl Fn(DVec3) -> f64) -> [f64; 2] {
    let nothing = [f64::INFINITY, f64::NEG_INFINITY];
    let values = points.iter().map(|point| measure(*point));
    values.fold(nothing, |[low, high], value| [low.min(value), high.max(value)])
}

/// Returns the range of depths in which the camera may see points.
fn depths_seen(camera: &Camera, points: &[DVec3]) -> RangeInclusive<f64> {
    let [near, far] = extent(points, |point| camera.forward().dot(point - camera.eye()));
    near.max(if camera.is_orthographic() { 0.0 } else { NEAREST * far })..=far
}

/// Returns the depths at which cascades begin and end, from near to far; empty where the camera
/// sees nothing.
fn cascade_ends(camera: &Camera, seen: RangeInclusive<f64>, count: u32) -> Vec<f64> {
    let (near, far) = seen.into_inner();
    if !(far > 0.0 && near <= far) {
        return Vec::new();
    }
    let end = |number: u32| {
        let part = f64::from(number) / f64::from(count);
        let even = near + (far - near) * part;
        if camera.is_orthographic() || near <= 0.0 {
            return even;
        }
        even + (near * (far / near).powf(part) - even) * LOGARITHMIC
    };
    (0..=count).map(end).collect()
}

/// Returns the corners of the camera's frustum between two depths.
fn corners(camera: &Camera, aspect: f64, depths: [f64; 2]) -> Vec<DVec3> {
    let (tall, wide) = (camera.up() * camera.half_height(), camera.right() * camera.half_height() * aspect);
    let aside = [wide + tall, wide - tall, -wide + tall, -wide - tall];
    let at = |depth: f64| {
        let spread = if camera.is_orthographic() { 1.0 } else { depth };
        aside.map(|aside| camera.eye() + camera.forward() * depth + aside * spread)
    };
    depths.into_iter().flat_map(at).collect()
}

/// Returns the axes of a view along a unit vector: right and up.
fn axes(forward: DVec3) -> [DVec3; 2] {
    let upward = if forward.y.abs() < 0.9 { DVec3::Y } else { DVec3::Z };
    let right = forward.cross(upward).normalize();
    [right, right.cross(forward)]
}

/// Size and border of shadow maps.
#[derive(Clone, Copy)]
struct ShadowMapShape {
    size: u32,
    /// Part of a side that is not border.
    inside: f64,
}

impl ShadowMapShape {
    /// Creates the view of a directional light over the points `shown`. Its depths span all of
    /// `points`. Returns `None` where no point lies within its sides.
    fn parallel(&self, toward: DVec3, points: &[DVec3], shown: &[DVec3]) -> Option<ShadowView> {
        let forward = -toward;
        let [right, up] = axes(forward);
        let [[left, rightmost], [bottom, top]] = [right, up].map(|axis| {
            let [[low, high], [from, to]] = [points, shown].map(|of| extent(of, |point| point.dot(axis)));
            [low.max(from), high.min(to)]
        });
        let [near, far] = extent(points, |point| point.dot(forward));
        let finite = [left, rightmost, bottom, top, near, far].iter().all(|side| side.is_finite());
        if !(finite && rightmost >= left && top >= bottom) {
            return None;
        }
        // What is flat and seen from its edge still has a picture.
        let least = 1e-6 * (far - near).max(rightmost - left).max(top - bottom).max(f64::MIN_POSITIVE);
        let side = |from: f64, to: f64| {
            let length = (to - from).max(least) / self.inside;
            (0.5 * (from + to), length)
        };
        let ((x, wide), (y, tall)) = (side(left, rightmost), side(bottom, top));
        let deep = (far - near).max(least);
        let corner = right * (x - 0.5 * wide) + up * (y + 0.5 * tall) + forward * (near - 0.01 * deep);
        let texels = f64::from(self.size);
        Some(ShadowView {
            size: self.size,
            from_point: false,
            eye: corner,
            corner: forward,
            across: right * (wide / texels),
            along: up * (-tall / texels),
            forward,
            near: deep,
            planes: [0.0, 1.02 * deep],
        })
    }

    /// Creates the faces of a cube around a light that show any of the points.
    fn cube(&self, eye: DVec3, points: &[DVec3]) -> Vec<ShadowView> {
        let far = points.iter().map(|point| (*point - eye).abs().max_element()).fold(0.0, f64::max);
        if !(far > 0.0 && far.is_finite()) {
            return Vec::new();
        }
        let tan = 1.0 / self.inside;
        let axes_of = |number: usize| {
            let axis = DVec3::AXES[number % 3];
            if number < 3 { axis } else { -axis }
        };
        let faces = (0..LIGHT_FACES).map(axes_of).filter_map(|forward| {
            let [right, up] = axes(forward);
            let along = |axis: DVec3| move |point: &DVec3| (*point - eye).dot(axis);
            let (x, y, depth) = (along(right), along(up), along(forward));
            // What is beyond one of the planes around a face is not in it.
            let beyond = [
                points.iter().all(|point| depth(point) <= 0.0),
                points.iter().all(|point| x(point) > tan * depth(point)),
                points.iter().all(|point| -x(point) > tan * depth(point)),
                points.iter().all(|point| y(point) > tan * depth(point)),
                points.iter().all(|point| -y(point) > tan * depth(point)),
            ];
            let texel = 2.0 * tan / f64::from(self.size);
            (!beyond.contains(&true)).then(|| ShadowView {
                size: self.size,
                from_point: true,
                eye,
                corner: forward + (up - right) * tan,
                across: right * texel,
                along: up * -texel,
                forward,
                near: NEAR_OF_KEYS * far,
                planes: [NEAREST * far, 1.01 * far],
            })
        });
        faces.collect()
    }
}

/// View of one shadow map.
struct ShadowView {
    size: u32,
    from_point: bool,
    /// Origin of rays: of all of them, or of the one through the upper left corner.
    eye: DVec3,
    /// Direction of that ray, with a component of 1 along the view axis.
    corner: DVec3,
    /// Change of directions or of origins per texel, to the right and downward.
    across: DVec3,
    along: DVec3,
    /// Unit view axis.
    forward: DVec3,
    /// Depth below which keys are ordered less finely, see [`Frame`].
    near: f64,
    /// Depths of the rasteriser's near and far planes.
    planes: [f64; 2],
}

fn four(v: DVec3, w: f64) -> Vec4<f32> {
    [v.x as f32, v.y as f32, v.z as f32, w as f32].into()
}

impl ShadowView {
    /// Vectors whose products with a point (and a 1) are its column, row and depth. For a point
    /// light, column and row must be divided by the depth.
    fn rows(&self) -> [DVec4; 3] {
        let depth = self.forward.extend(-self.forward.dot(self.eye));
        let [column, row] = [self.across, self.along].map(|step| {
            let step = step / step.length_squared();
            step.extend(-step.dot(self.eye)) - depth * step.dot(self.corner)
        });
        [column, row, depth]
    }

    fn view_projection(&self) -> DMat4 {
        let [column, row, depth] = self.rows();
        let [near, far] = self.planes;
        let whole = 2.0 / f64::from(self.size);
        let (w, z) = if self.from_point {
            (depth, (depth * far - DVec4::W * (near * far)) / (far - near))
        } else {
            (DVec4::W, (depth - DVec4::W * near) / (far - near))
        };
        DMat4::from_cols(column * whole - w, w - row * whole, z, w).transpose()
    }

    /// Returns the frame that renders the shadow map.
    fn frame(&self) -> Frame {
        let nothing = four(DVec3::ZERO, 0.0);
        let (across, along) = (four(self.across, 0.0), four(self.along, 0.0));
        let of_rays = |from_point: bool, step| if self.from_point == from_point { step } else { nothing };
        Frame {
            view_projection: self.view_projection().as_mat4().to_cols_array_2d().map(Into::into),
            eye: four(self.eye, 1.0),
            eye_right: of_rays(false, across),
            eye_down: of_rays(false, along),
            forward: four(self.forward, 0.0),
            corner: four(self.corner, 0.0),
            right: of_rays(true, across),
            down: of_rays(true, along),
            sample_width: SAMPLE_WIDTH,
            near: self.near as f32,
            ..Frame::none()
        }
    }

    /// Returns the view by which shaders look up points in the shadow map.
    fn shader_view(&self) -> LightView {
        let [column, row, depth] = self.rows().map(|row| four(row.truncate(), row.w));
        LightView {
            column,
            row,
            depth,
            corner: four(if self.from_point { self.corner } else { self.eye }, 0.0),
            across: four(self.across, 0.0),
            along: four(self.along, 0.0),
            eye: four(self.eye, 1.0),
            near: self.near as f32,
            texel_m: self.across.length().max(self.along.length()) as f32,
            from_point: u32::from(self.from_point),
            size: self.size,
        }
    }
}

/// Creates a frame without a camera for single rays of lights; `reach_m` is the size of the scene
/// in metres.
pub fn frame_of_rays(reach_m: f64) -> Frame {
    Frame { sample_width: SAMPLE_WIDTH, near: (NEAR_OF_KEYS * reach_m) as f32, ..Frame::none() }
}

#[cfg(test)]
mod frames;

#[cfg(test)]
mod tests {
    use super::*;

    /// Where a point is in a view: column, row, depth.
    fn place(view: &LightView, point: DVec3) -> [f64; 3] {
        let at = point.as_vec3().extend(1.0);
        let dot = |v: Vec4<f32>| f64::from(glam::Vec4::new(v.x, v.y, v.z, v.w).dot(at));
        let (column, row, depth) = (dot(view.column), dot(view.row), dot(view.depth));
        let over = if view.from_point == 1 { depth } else { 1.0 };
        [column / over, row / over, depth]
    }

    /// The point of a frame's ray through a place, at a depth.
    fn along(frame: &Frame, [x, y, depth]: [f64; 3]) -> DVec3 {
        let v = |v: Vec4<f32>| DVec3::new(v.x.into(), v.y.into(), v.z.into());
        let eye = v(frame.eye) + v(frame.eye_right) * x + v(frame.eye_down) * y;
        eye + (v(frame.corner) + v(frame.right) * x + v(frame.down) * y) * depth
    }

    fn points() -> Vec<DVec3> {
        let side = [-0.5, 0.7];
        let each = side.iter().flat_map(|x| side.iter().map(move |y| (*x, *y)));
        each.flat_map(|(x, y)| side.map(|z| DVec3::new(x, y, 0.3 * z))).collect()
    }

    #[test]
    fn rays_and_places_of_a_view_are_each_others_inverse() {
        let shape = ShadowMapShape { size: 64, inside: 0.9 };
        let toward = DVec3::new(0.3, 0.8, -0.4).normalize();
        let mut views: Vec<ShadowView> = shape.parallel(toward, &points(), &points()).into_iter().collect();
        views.extend(shape.cube(DVec3::new(0.1, 1.9, 0.2), &points()));
        assert!(views.len() >= 2);
        for view in views {
            let (frame, looked_up) = (view.frame(), view.shader_view());
            for at in [[3.0, 60.0, 0.5], [32.5, 7.25, 1.5]] {
                let found = place(&looked_up, along(&frame, at));
                let near = |(a, b): (f64, f64)| (a - b).abs() < 1e-4;
                assert!(found.into_iter().zip(at).all(near), "{at:?} is found at {found:?}");
                let clip = view.view_projection() * along(&frame, at).extend(1.0);
                let ndc = clip / clip.w;
                assert!((32.0 * (ndc.x + 1.0) - at[0]).abs() < 1e-4);
                assert!((32.0 * (1.0 - ndc.y) - at[1]).abs() < 1e-4);
            }
        }
    }

    #[test]
    fn a_view_of_parallel_rays_holds_all_that_is_shown_within_its_border() {
        let shape = ShadowMapShape { size: 128, inside: 0.95 };
        let view = shape.parallel(DVec3::Y, &points(), &points()).expect("a view").shader_view();
        for point in points() {
            let [x, y, depth] = place(&view, point);
            assert!([x, y].iter().all(|place| (3.0..=125.0).contains(place)) && depth > 0.0, "{point}");
        }
        let aside = points().iter().map(|point| *point + DVec3::X * 9.0).collect::<Vec<_>>();
        assert!(shape.parallel(DVec3::Y, &points(), &aside).is_none());
    }

    #[test]
    fn a_light_above_all_needs_one_face_and_one_in_the_middle_six() {
        let shape = ShadowMapShape { size: 128, inside: 0.95 };
        assert_eq!(shape.cube(DVec3::Y * 5.0, &points()).len(), 1);
        assert_eq!(shape.cube(DVec3::ZERO, &points()).len(), LIGHT_FACES);
        assert!(shape.cube(DVec3::ZERO, &[]).is_empty());
    }

    #[test]
    fn cascades_go_on_where_the_one_before_ends() {
        let camera = Camera::new(DVec3::Z * 3.0, DVec3::ZERO, 40.0).expect("a camera");
        let ends = cascade_ends(&camera, 0.01..=5.0, 4);
        assert!(ends.len() == 5 && ends.is_sorted() && ends[0] == 0.01 && (ends[4] - 5.0).abs() < 1e-12);
        assert!(cascade_ends(&camera, 1.0..=-5.0, 4).is_empty());
    }
}
