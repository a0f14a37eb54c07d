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
    },
    /// A light at a point.
    Point {
        /// Position in metres.
        position_m: DVec3,
        /// Irradiance on a surface that faces the light from 1 m away; it falls with the square of the
        /// distance.
        intensity: Vec3,
    },
}

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
    /// A light has both or neither of a direction and a position.
    #[error("a light has either a direction or a position")]
    DirectionOrPosition,
    /// There are more lights than [`MAX_LIGHTS`].
    #[error("{0} lights are too many: at most {MAX_LIGHTS} are possible")]
    TooMany(usize),
}

impl Light {
    /// A light infinitely far away in the direction `toward`, of any length.
    ///
    /// # Errors
    ///
    /// When the direction is 0 or not finite, or a part of the irradiance is negative or not finite.
    pub fn directional(toward: DVec3, irradiance: Vec3) -> Result<Self, LightError> {
        // Scaled first, so that neither very long nor very short vectors lose their direction.
        let scaled = toward / toward.abs().max_element();
        let toward = scaled.try_normalize().ok_or(LightError::NoDirection(toward))?;
        Ok(Light::Directional { toward, irradiance: checked_colour(irradiance)? })
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
        Ok(Light::Point { position_m, intensity: checked_colour(intensity)? })
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
    }
}
