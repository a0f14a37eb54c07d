//! The camera and the light that actions turn.

use glam::{DQuat, DVec3};
use relief_scene::light::Light;
use relief_scene::{Scene, SceneSpec};

use crate::Refused;

/// Closest to the poles that the eye comes, in degrees.
const POLE_DEG: f64 = 0.5;

/// Part of the picture that a framed scene fills along the axis that it fills more, as from a view.
const FILLED: f64 = 0.94;

/// Least and greatest height of a zoomed picture, in radii of the scene: some texels of a fine map, and a
/// scene of a few pixels.
const HEIGHTS: [f64; 2] = [1e-4, 1e2];

/// Tangent of half the field of view that a camera has by default.
const HALF_VIEW: f64 = 0.363_970_234_266_202_4;

/// Camera and light of a picture: where actions turn them from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// Position of the eye in metres.
    pub eye: DVec3,
    /// Point that it looks at, in metres.
    pub target: DVec3,
    /// Height of the picture where the target is, in metres.
    pub height_m: f64,
    /// Whether rays are parallel.
    pub is_orthographic: bool,
    /// Space that the scene takes; none: it is not known.
    pub extent: Option<Extent>,
    /// Width over height of the picture.
    pub aspect: f64,
    /// Direction toward the first light, of any length; none without a directional light.
    pub light: Option<DVec3>,
}

/// Space that a scene takes: what a sphere and a box with the same middle have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    /// Middle in metres.
    pub middle: DVec3,
    /// Radius of the sphere in metres.
    pub radius: f64,
    /// Half the sides of the box in metres.
    pub half: DVec3,
}

impl Extent {
    /// Space of a sphere.
    pub fn sphere(middle: DVec3, radius: f64) -> Self {
        Self { middle, radius, half: DVec3::splat(radius) }
    }

    /// Space that the relief of all surfaces takes.
    fn of(scene: &Scene) -> Self {
        let points = || {
            scene.surfaces().iter().flat_map(|surface| {
                let map = surface.height_map();
                let heights = [map.bias_m(), map.bias_m() + map.scale_m()];
                surface.mesh().vertices().iter().flat_map(move |vertex| {
                    let (position, normal) = (vertex.position.as_dvec3(), vertex.normal.as_dvec3());
                    heights.map(|height| position + normal * height)
                })
            })
        };
        let least = points().fold(DVec3::INFINITY, DVec3::min);
        let greatest = points().fold(DVec3::NEG_INFINITY, DVec3::max);
        let middle = 0.5 * (least + greatest);
        if !middle.is_finite() {
            return Self::sphere(DVec3::ZERO, 1.0);
        }
        let radius = points().map(|point| point.distance(middle)).fold(1e-9, f64::max);
        Self { middle, radius, half: 0.5 * (greatest - least) }
    }

    /// The most that a point of it reaches along a vector, beyond the middle.
    fn reach(&self, along: DVec3) -> f64 {
        along.abs().dot(self.half).min(self.radius * along.length())
    }
}

impl Seen {
    /// A camera with a field of view of 40 degrees that looks at a point, and knows nothing of the scene.
    pub fn looking(eye: DVec3, target: DVec3) -> Self {
        let away = eye.distance(target);
        let height_m = 2.0 * HALF_VIEW * away;
        Self { eye, target, height_m, is_orthographic: false, extent: None, aspect: 4.0 / 3.0, light: None }
    }

    /// What a loaded scene shows.
    pub fn of(scene: &Scene) -> Self {
        let camera = scene.camera();
        let (eye, target, is_orthographic) = (camera.eye(), camera.target(), camera.is_orthographic());
        let away = if is_orthographic { 1.0 } else { eye.distance(target) };
        let height_m = 2.0 * camera.half_height() * away;
        let light = scene.lights().iter().find_map(|light| match light {
            Light::Directional { toward, .. } => Some(*toward),
            Light::Point { .. } => None,
        });
        let (extent, [width, height]) = (Some(Extent::of(scene)), scene.size());
        let aspect = f64::from(width) / f64::from(height.max(1));
        Self { eye, target, height_m, is_orthographic, extent, aspect, light }
    }

    /// Where it is after keys of the document have been set: those that say it replace what was seen.
    pub fn at(self, spec: &SceneSpec) -> Self {
        let of = |given: Option<[f64; 3]>, seen: DVec3| given.map_or(seen, DVec3::from);
        let (eye, target) = (of(spec.eye, self.eye), of(spec.target, self.target));
        let away = eye.distance(target);
        let height_m = match (self.is_orthographic, spec.fov) {
            (true, _) => spec.view_height.unwrap_or(self.height_m),
            (false, Some(fov)) => 2.0 * (0.5 * fov.to_radians()).tan() * away,
            (false, None) => 2.0 * self.half_view() * away,
        };
        Self { eye, target, height_m, light: spec.light.map(DVec3::from).or(self.light), ..self }
    }

    /// Tangent of half the field of view.
    fn half_view(&self) -> f64 {
        let tan = 0.5 * self.height_m / self.eye.distance(self.target);
        if tan.is_finite() && tan > 0.0 { tan } else { HALF_VIEW }
    }

    /// The eye after turning around the target.
    pub fn orbited(&self, degrees: [f64; 2]) -> Result<DVec3, Refused> {
        finite(&degrees)?;
        Ok(self.target + turned(self.eye - self.target, degrees, 90.0 - POLE_DEG))
    }

    /// Eye and target after moving across the picture.
    pub fn panned(&self, by: [f64; 2]) -> Result<[DVec3; 2], Refused> {
        finite(&by)?;
        let forward = (self.target - self.eye).normalize_or(-DVec3::Z);
        let right = forward.cross(DVec3::Y).try_normalize().unwrap_or(DVec3::X);
        let up = right.cross(forward);
        let way = (right * by[0] + up * by[1]) * -self.height_m;
        Ok([self.eye + way, self.target + way])
    }

    /// Eye and target once a point is in the middle of the picture.
    pub fn looked_at(&self, point: [f64; 3]) -> Result<[DVec3; 2], Refused> {
        finite(&point)?;
        let point = DVec3::from(point);
        Ok([point + self.eye - self.target, point])
    }

    /// The eye, and the height of a picture with parallel rays, after coming nearer: no nearer and no farther
    /// than the scene can be seen from.
    pub fn zoomed(&self, factor: f64) -> Result<(DVec3, f64), Refused> {
        if !(factor > 0.0 && factor.is_finite()) {
            return Err(Refused::Number(factor.to_string(), "above 0 and finite"));
        }
        let wanted = self.height_m / factor;
        let height_m = self.extent.map_or(wanted, |extent| {
            let [least, most] = HEIGHTS.map(|height| height * extent.radius);
            wanted.clamp(least.min(self.height_m), most.max(self.height_m))
        });
        Ok((self.target + (self.eye - self.target) * (height_m / self.height_m), height_m))
    }

    /// Eye, target and height of the picture from which all is seen, in the present direction. None if it is
    /// not known where the scene is.
    pub fn framed(&self) -> Option<(DVec3, DVec3, f64)> {
        let extent = self.extent?;
        let back = (self.eye - self.target).normalize_or(DVec3::Z);
        let right = DVec3::Y.cross(back).try_normalize().unwrap_or(DVec3::X);
        let up = back.cross(right);
        let deep = extent.reach(back);
        if self.is_orthographic {
            let tall = extent.reach(up).max(extent.reach(right) / self.aspect) * 2.0 / FILLED;
            return Some((extent.middle + back * (deep + tall), extent.middle, tall));
        }
        // Planes through opposite edges of the filled part enclose all points. The axis whose planes meet
        // farther away decides.
        let half_view = self.half_view();
        let tans = [half_view * FILLED * self.aspect, half_view * FILLED];
        let [across, along] = [0, 1].map(|axis| {
            let (side, tan) = ([right, up][axis], tans[axis]);
            let [low, high] = [back * tan - side, back * tan + side].map(|plane| extent.reach(plane));
            (0.5 * (high - low), 0.5 * (high + low) / tan)
        });
        // What is seen edge-on still needs a distance.
        let away = across.1.max(along.1).max(deep + 1e-3 * extent.radius);
        let target = extent.middle + right * across.0 + up * along.0;
        Some((target + back * away, target, 2.0 * half_view * away))
    }

    /// The direction toward the light after turning it.
    pub fn lit_from(&self, degrees: [f64; 2]) -> Result<DVec3, Refused> {
        finite(&degrees)?;
        let light = self.light.ok_or(Refused::NoLight)?;
        Ok(turned(light, degrees, 90.0))
    }
}

/// A vector turned around the vertical and then up, no farther than `most` degrees above or below.
fn turned(vector: DVec3, [right, up]: [f64; 2], most: f64) -> DVec3 {
    let length = vector.length();
    let flat = vector.x.hypot(vector.z);
    let altitude = vector.y.atan2(flat).to_degrees();
    let heading = if flat > 0.0 { DVec3::new(vector.x, 0.0, vector.z) / flat } else { DVec3::Z };
    let heading = DQuat::from_rotation_y(right.rem_euclid(360.0).to_radians()) * heading;
    let altitude = (altitude + up).clamp(-most, most).to_radians();
    (heading * altitude.cos() + DVec3::Y * altitude.sin()) * length
}

fn finite(numbers: &[f64]) -> Result<(), Refused> {
    match numbers.iter().find(|number| !number.is_finite()) {
        Some(number) => Err(Refused::Number(number.to_string(), "finite")),
        None => Ok(()),
    }
}
