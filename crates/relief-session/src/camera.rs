//! The camera and the light that actions turn.

use glam::{DQuat, DVec3};
use relief_scene::light::Light;
use relief_scene::{Scene, SceneSpec};

use crate::Refused;

/// Closest to the poles that the eye comes, in degrees.
const POLE_DEG: f64 = 0.5;

/// Room around what is framed, as a factor.
const ROOM: f64 = 1.04;

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
    /// Middle and radius of a sphere around the scene, in metres.
    pub around: (DVec3, f64),
    /// Width over height of the picture.
    pub aspect: f64,
    /// Direction toward the first light, of any length; none without a directional light.
    pub light: Option<DVec3>,
}

impl Seen {
    /// A camera with a field of view of 40 degrees that looks at a point, and knows nothing of the scene.
    pub fn looking(eye: DVec3, target: DVec3) -> Self {
        let away = eye.distance(target);
        let height_m = 2.0 * 20_f64.to_radians().tan() * away;
        Self {
            eye,
            target,
            height_m,
            is_orthographic: false,
            around: (target, 0.5 * away),
            aspect: 4.0 / 3.0,
            light: None,
        }
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
        let (around, [width, height]) = (sphere_around(scene), scene.size());
        let aspect = f64::from(width) / f64::from(height.max(1));
        Self { eye, target, height_m, is_orthographic, around, aspect, light }
    }

    /// Where it is after keys of the document have been set: those that say it replace what was seen.
    pub fn at(self, spec: &SceneSpec) -> Self {
        let of = |given: Option<[f64; 3]>, seen: DVec3| given.map_or(seen, DVec3::from);
        let (eye, target) = (of(spec.eye, self.eye), of(spec.target, self.target));
        let away = eye.distance(target);
        let height_m = match (self.is_orthographic, spec.fov) {
            (true, _) => spec.view_height.unwrap_or(self.height_m),
            (false, Some(fov)) => 2.0 * (0.5 * fov.to_radians()).tan() * away,
            (false, None) => self.height_m * away / self.eye.distance(self.target).max(1e-9),
        };
        Self { eye, target, height_m, light: spec.light.map(DVec3::from).or(self.light), ..self }
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

    /// The eye, and the height of a picture with parallel rays, after coming nearer.
    pub fn zoomed(&self, factor: f64) -> Result<(DVec3, f64), Refused> {
        if !(factor > 0.0 && factor.is_finite()) {
            return Err(Refused::Number(factor.to_string(), "above 0 and finite"));
        }
        Ok((self.target + (self.eye - self.target) / factor, self.height_m / factor))
    }

    /// Eye, target and height of the picture from which all is seen, in the present direction.
    pub fn framed(&self) -> (DVec3, DVec3, f64) {
        let (middle, radius) = self.around;
        let back = (self.eye - self.target).normalize_or(DVec3::Z);
        // The half of the picture's shorter side.
        let narrow = self.aspect.min(1.0);
        let tan = 0.5 * self.height_m / self.eye.distance(self.target).max(1e-9) * narrow;
        let away = match self.is_orthographic {
            true => 4.0 * radius,
            // A sphere is seen whole where rays touch it.
            false => radius * (1.0 + 1.0 / (tan * tan)).sqrt(),
        };
        (middle + back * away * ROOM, middle, 2.0 * radius / narrow * ROOM)
    }

    /// The direction toward the light after turning it.
    pub fn lit_from(&self, degrees: [f64; 2]) -> Result<DVec3, Refused> {
        finite(&degrees)?;
        let light = self.light.ok_or(Refused::NotSeen)?;
        Ok(turned(light, degrees, 90.0))
    }
}

/// A sphere around the relief of all surfaces, about the middle of its box.
fn sphere_around(scene: &Scene) -> (DVec3, f64) {
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
        return (DVec3::ZERO, 1.0);
    }
    (middle, points().map(|point| point.distance(middle)).fold(1e-9, f64::max))
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
