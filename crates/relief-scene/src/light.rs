//! Lights of a scene: directional lights and point lights.
//!
//! Light is measured relative to a white surface. Under an irradiance of 1, a diffuse surface of
//! colour 1 that faces the light has the linear picture value 1. Colours are linear red, green and
//! blue.

use glam::{DVec3, Vec3};
pub use relief_shaders::MAX_LIGHTS;

/// Light of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Light {
    /// Light infinitely far away.
    Directional {
        /// Unit vector from the scene toward the light.
        toward: DVec3,
        /// Irradiance on a surface that faces the light.
        irradiance: Vec3,
        /// Apparent diameter of the light's disc in degrees, from 0 to [`MAX_DIAMETER_DEG`].
        diameter_deg: f64,
    },
    /// Light at a point.
    Point {
        /// Position in metres.
        position_m: DVec3,
        /// Irradiance on a surface that faces the light at a distance of 1 m. It falls with the
        /// square of the distance.
        intensity: Vec3,
        /// Radius in metres of a shining disc that faces the lit point. 0 for a point.
        radius_m: f64,
    },
}

/// Apparent diameter of the sun and of the moon in degrees. Default of directional lights.
pub const SUN_DEG: f64 = 0.53;

/// Largest diameter of a directional light in degrees.
pub const MAX_DIAMETER_DEG: f64 = 90.0;

/// Reason why a light is invalid.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LightError {
    /// The direction is 0 or not finite.
    #[error("the direction toward a light is {0}: it must be finite and not zero")]
    NoDirection(DVec3),
    /// The position is infinite or NaN.
    #[error("the position of a light is {0}: it must be finite")]
    BadPosition(DVec3),
    /// A colour is negative or not finite.
    #[error("the colour is {0}: each part must be finite and not negative")]
    BadColour(Vec3),
    /// A light's diameter is out of range.
    #[error("the diameter of a light is {0} degrees: it must be from 0 to {MAX_DIAMETER_DEG} degrees")]
    BadDiameter(f64),
    /// A light's radius is negative or not finite.
    #[error("the radius of a light is {0} m: it must be finite and not negative")]
    BadRadius(f64),
    /// A point light has a diameter in degrees, or a directional light a radius in metres.
    #[error(
        "a light at a position has a radius in metres, a light with a direction a diameter in degrees: give \
         only the one that fits"
    )]
    OtherSize,
    /// A light has both a direction and a position, or neither.
    #[error("a light needs either a direction or a position: give exactly one of them")]
    DirectionOrPosition,
    /// There are more lights than [`MAX_LIGHTS`].
    #[error("the scene has {0} lights: give at most {MAX_LIGHTS}")]
    TooMany(usize),
}

impl Light {
    /// Creates a light infinitely far away.
    ///
    /// `toward` points from the scene to the light; its length does not matter. The diameter is
    /// [`SUN_DEG`].
    ///
    /// # Errors
    ///
    /// When the direction is 0 or not finite, or a component of the irradiance is negative or not
    /// finite.
    pub fn directional(toward: DVec3, irradiance: Vec3) -> Result<Self, LightError> {
        // Scaled first, so that neither very long nor very short vectors lose their direction.
        let scaled = toward / toward.abs().max_element();
        let toward = scaled.try_normalize().ok_or(LightError::NoDirection(toward))?;
        Ok(Light::Directional { toward, irradiance: checked_colour(irradiance)?, diameter_deg: SUN_DEG })
    }

    /// Sets the apparent diameter of a directional light's disc in degrees, from 0 to
    /// [`MAX_DIAMETER_DEG`].
    ///
    /// Shadow variants that sample the whole disc become soft. Variants that trace a single ray use
    /// its centre.
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

    /// Sets the radius of a point light's disc in metres. The intensity does not change.
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

    /// Creates a point light at a position in metres.
    ///
    /// `intensity` is the irradiance on a surface that faces it at a distance of 1 m. The radius is
    /// 0.
    ///
    /// # Errors
    ///
    /// When the position is not finite, or a component of the intensity is negative or not finite.
    pub fn point(position_m: DVec3, intensity: Vec3) -> Result<Self, LightError> {
        if !position_m.is_finite() {
            return Err(LightError::BadPosition(position_m));
        }
        Ok(Light::Point { position_m, intensity: checked_colour(intensity)?, radius_m: 0.0 })
    }
}

/// Returns the colour, or an error if a component is negative or not finite.
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
