//! The ray that is drawn.

use relief_core::{HeightMap, Metric, Path, PathMetric};

/// A ray through a relief, from height 1 down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Texture coordinates where the ray enters the relief.
    pub at: [f64; 2],
    /// Degrees between the ray and the normal, from 0 to below 90.
    pub angle_deg: f64,
    /// Direction on the surface in degrees: 0 toward greater `u`, 90 toward greater `v`.
    pub direction_deg: f64,
    /// Radius in metres by which the base curves away under the ray; negative if it curves toward the
    /// ray. None for a flat base.
    pub radius_m: Option<f64>,
}

impl Default for Ray {
    /// A ray that grazes the relief at 75 degrees, off the axes and the diagonals of the map.
    fn default() -> Self {
        Self { at: [0.2, 0.8], angle_deg: 75.0, direction_deg: 20.0, radius_m: None }
    }
}

/// A ray's number that cannot be.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum RayError {
    /// The angle is no number from 0 to below 90.
    #[error("an angle of {0} degrees: it must be from 0 to 89.9")]
    Angle(f64),
    /// A place or a direction is no finite number.
    #[error("{0}: places and directions must be finite numbers")]
    NotFinite(f64),
    /// The radius is 0 or no finite number.
    #[error("a radius of {0} m: it must be a number other than 0")]
    Radius(f64),
    /// The map has no depth that a ray could enter.
    #[error("the relief has no depth: give it a scale above 0")]
    Flat,
}

/// The greatest angle in degrees.
const MOST_DEGREES: f64 = 89.9;

/// How far below the floor a path ends, relatively, as in the surface stage.
const BELOW_FLOOR: f64 = 1.000_001;

impl Ray {
    /// Returns the ray's path, rounded as for a shader. `metric` has the size of a tile.
    ///
    /// Over a curved base the path is a parabola in the height, as the surface stage has it: the base falls
    /// away by the square of the distance over twice the radius.
    ///
    /// # Errors
    ///
    /// When a number is out of its range, or the map has no depth.
    pub fn path(&self, heights: &HeightMap, metric: Metric) -> Result<Path, RayError> {
        let scale_m = heights.scale_m();
        if !(0.0..=MOST_DEGREES).contains(&self.angle_deg) {
            return Err(RayError::Angle(self.angle_deg));
        }
        if let Some(wrong) = [self.at[0], self.at[1], self.direction_deg].iter().find(|it| !it.is_finite()) {
            return Err(RayError::NotFinite(*wrong));
        }
        if let Some(wrong) = self.radius_m.filter(|radius| !radius.is_finite() || *radius == 0.0) {
            return Err(RayError::Radius(wrong));
        }
        if scale_m <= 0.0 {
            return Err(RayError::Flat);
        }
        let (sine, cosine) = self.angle_deg.to_radians().sin_cos();
        let (sin, cos) = self.direction_deg.to_radians().sin_cos();
        let [wide, high] = metric.tile_m;
        let fall = cosine / scale_m;
        let curve = self.radius_m.map_or(0.0, |radius| sine * sine / (2.0 * radius * scale_m));
        let path = Path {
            uv: self.at,
            duv: [sine * cos / wide, sine * sin / high],
            h: [1.0, -fall, curve],
            exit: exit(fall, curve),
            base: 0.0,
            metric: PathMetric { uu: wide * wide, uv: 0.0, vv: high * high, scale_m },
        };
        Ok(Path::from(&relief_shaders::cpu::Path::from(&path)))
    }
}

/// The place where the height `1 - fall t + curve t²` reaches the floor, or else the top again.
fn exit(fall: f64, curve: f64) -> f64 {
    let discriminant = fall * fall - 4.0 * curve;
    if discriminant >= 0.0 { 2.0 / (fall + discriminant.sqrt()) * BELOW_FLOOR } else { fall / curve }
}
