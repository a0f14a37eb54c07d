//! Lights.
//!
//! Light is measured relative to a white surface: an irradiance of 1 makes a diffuse surface of colour 1 that
//! faces the light appear with the linear picture value 1. Colours are linear, red, green, blue.

use glam::{DVec3, Vec3};
pub use relief_shaders::MAX_LIGHTS;

/// Something that lights a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// A light infinitely far away.
    Directional {
        /// Unit vector from the scene toward the light.
        toward: DVec3,
        /// Irradiance on a surface that faces the light.
        irradiance: Vec3,
        /// How large the light's disc appears: its diameter in degrees.
        diameter_deg: f64,
    },
    /// A light at a point.
    Point {
        /// Position in metres.
        position_m: DVec3,
        /// Irradiance on a surface that faces the light from 1 m away; it falls with the square of the
        /// distance.
        intensity: Vec3,
        /// Radius of the disc, turned to what it lights, that shines; 0 for a point.
        radius_m: f64,
    },
}

/// Diameter of the sun's disc, and of the moon's, in degrees. Default of a light that is infinitely far away.
pub const SUN_DEG: f64 = 0.53;

/// The largest diameter of a light that is infinitely far away, in degrees.
pub const MAX_DIAMETER_DEG: f64 = 90.0;

/// Why there is no such light.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LightError {
    /// The direction is 0 or not finite.
    #[error("{0} is no direction toward a light: it must be finite and not zero")]
    NoDirection(DVec3),
    /// The position is not finite.
    #[error("a light at {0}: its position must be finite")]
    BadPosition(DVec3),
    /// A colour is negative or not finite.
    #[error("a light of {0}: each part must be finite and not negative")]
    BadColour(Vec3),
    /// A light's diameter is out of range.
    #[error("a light of {0} degrees: it must be from 0 to {MAX_DIAMETER_DEG} degrees wide")]
    BadDiameter(f64),
    /// A light's radius is negative or not finite.
    #[error("a light with a radius of {0} m: it must be finite and not negative")]
    BadRadius(f64),
    /// A light at a point is given a diameter in degrees, or one infinitely far away a radius in metres.
    #[error(
        "the size of a light at a position is its radius in metres, of another one its diameter in degrees"
    )]
    OtherSize,
    /// A light has both or neither of a direction and a position.
    #[error("a light has either a direction or a position")]
    DirectionOrPosition,
    /// There are more lights than [`MAX_LIGHTS`].
    #[error("{0} lights are too many: at most {MAX_LIGHTS} are possible")]
    TooMany(usize),
}

impl Light {
    /// A light infinitely far away in the direction `toward`, of any length, as large as the sun appears.
    ///
    /// # Errors
    ///
    /// When the direction is 0 or not finite, or a part of the irradiance is negative or not finite.
    pub fn directional(toward: DVec3, irradiance: Vec3) -> Result<Self, LightError> {
        // Scaled first, so that neither very long nor very short vectors lose their direction.
        let scaled = toward / toward.abs().max_element();
        let toward = scaled.try_normalize().ok_or(LightError::NoDirection(toward))?;
        Ok(Light::Directional { toward, irradiance: checked_colour(irradiance)?, diameter_deg: SUN_DEG })
    }

    /// The same light, infinitely far away, with a disc of that diameter in degrees, from 0 to
    /// [`MAX_DIAMETER_DEG`]. Shadows of the whole disc are soft: those that look at one of its points only
    /// take its centre.
    ///
    /// # Errors
    ///
    /// When the diameter is out of range, or the light is at a point.
    pub fn with_diameter(self, diameter_deg: f64) -> Result<Self, LightError> {
        let Light::Directional { toward, irradiance, .. } = self else { return Err(LightError::OtherSize) };
        if !(0.0..=MAX_DIAMETER_DEG).contains(&diameter_deg) {
            return Err(LightError::BadDiameter(diameter_deg));
        }
        Ok(Light::Directional { toward, irradiance, diameter_deg })
    }

    /// The same light at a point with a disc of that radius in metres. Its intensity stays the same.
    ///
    /// # Errors
    ///
    /// When the radius is negative or not finite, or the light is infinitely far away.
    pub fn with_radius(self, radius_m: f64) -> Result<Self, LightError> {
        let Light::Point { position_m, intensity, .. } = self else { return Err(LightError::OtherSize) };
        if !(radius_m >= 0.0 && radius_m.is_finite()) {
            return Err(LightError::BadRadius(radius_m));
        }
        Ok(Light::Point { position_m, intensity, radius_m })
    }

    /// A light at a point, in metres, with the irradiance that it gives at 1 m.
    ///
    /// # Errors
    ///
    /// When the position is not finite, or a part of the intensity is negative or not finite.
    pub fn point(position_m: DVec3, intensity: Vec3) -> Result<Self, LightError> {
        if !position_m.is_finite() {
            return Err(LightError::BadPosition(position_m));
        }
        Ok(Light::Point { position_m, intensity: checked_colour(intensity)?, radius_m: 0.0 })
    }
}

/// The colour, unless a part of it is negative or not finite.
pub(crate) fn checked_colour(colour: Vec3) -> Result<Vec3, LightError> {
    if colour.is_finite() && colour.min_element() >= 0.0 {
        Ok(colour)
    } else {
        Err(LightError::BadColour(colour))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_become_unit_vectors_whatever_their_length() {
        for length in [1e-300, 1e-3, 1.0, 1e300] {
            let light = Light::directional(DVec3::new(3.0, 0.0, -4.0) * length, Vec3::ONE);
            let Ok(Light::Directional { toward, .. }) = light else { panic!("{light:?}") };
            assert!((toward - DVec3::new(0.6, 0.0, -0.8)).length() < 1e-15);
        }
    }

    #[test]
    fn impossible_lights_are_refused() {
        for toward in [DVec3::ZERO, DVec3::NAN, DVec3::new(f64::INFINITY, 1.0, 0.0)] {
            assert!(
                matches!(Light::directional(toward, Vec3::ONE), Err(LightError::NoDirection(_))),
                "{toward}"
            );
        }
        assert!(matches!(Light::point(DVec3::NAN, Vec3::ONE), Err(LightError::BadPosition(_))));
        for colour in [Vec3::new(1.0, -0.1, 0.0), Vec3::NAN, Vec3::INFINITY] {
            assert!(matches!(Light::point(DVec3::ZERO, colour), Err(LightError::BadColour(_))), "{colour}");
        }
        let sun = Light::directional(DVec3::Y, Vec3::ONE).expect("a light");
        let lamp = Light::point(DVec3::Y, Vec3::ONE).expect("a light");
        for diameter in [-1.0, 90.1, f64::NAN, f64::INFINITY] {
            assert!(matches!(sun.with_diameter(diameter), Err(LightError::BadDiameter(_))), "{diameter}");
        }
        for radius in [-1.0, f64::NAN, f64::INFINITY] {
            assert!(matches!(lamp.with_radius(radius), Err(LightError::BadRadius(_))), "{radius}");
        }
        assert_eq!(sun.with_radius(1.0), Err(LightError::OtherSize));
        assert_eq!(lamp.with_diameter(1.0), Err(LightError::OtherSize));
    }
}
