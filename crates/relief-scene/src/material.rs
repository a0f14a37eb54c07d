//! Blinn-Phong materials with optional refraction.

use glam::Vec3;

/// Greatest index of refraction, germanium's. The least is 1, a vacuum's.
pub const MAX_IOR: f32 = 4.0;

/// Greatest shininess. Shininess is a whole number so that shaders raise to it by multiplication
/// alone, with the same bits everywhere. A highlight beyond this is smaller than a pixel.
pub const MAX_SHININESS: u32 = 1024;

/// Blinn-Phong material that may be transparent.
///
/// Under irradiance `E` from direction `L`, seen from `V`, with `h` half-way between, its light is
/// `E (diffuse (N·L) + specular (N·h)^shininess)`.
///
/// Colours are linear red, green and blue, each from 0 to 1. A transparent material refracts a part
/// of the light that enters instead of scattering it. The ambient variant `environment` computes
/// refraction and reflection from the environment map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    diffuse: Vec3,
    specular: Vec3,
    shininess: u32,
    transmission: f32,
    ior: f32,
}

/// Reason why a material is invalid.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MaterialError {
    /// A component of a colour is not from 0 to 1.
    #[error("the {what} colour is {colour}: each part must be from 0 to 1")]
    BadColour {
        /// Name of the colour: `diffuse` or `specular`.
        what: &'static str,
        /// Value of the colour.
        colour: Vec3,
    },
    /// The shininess is out of range.
    #[error("the shininess is {0}: it must be a whole number from 1 to {MAX_SHININESS}")]
    BadShininess(u32),
    /// The transmission is out of range.
    #[error("the transmission is {0}: it must be from 0 to 1")]
    BadTransmission(f32),
    /// The index of refraction is out of range.
    #[error("the index of refraction is {0}: it must be from 1 to {MAX_IOR}")]
    BadIor(f32),
}

impl Material {
    /// Creates an opaque material from linear colours, each component from 0 to 1.
    ///
    /// `shininess` is a whole number from 1 to [`MAX_SHININESS`]. If the surface has a colour
    /// picture, `diffuse` multiplies it.
    ///
    /// # Errors
    ///
    /// When a component of a colour or the shininess is out of range.
    pub fn new(diffuse: Vec3, specular: Vec3, shininess: u32) -> Result<Self, MaterialError> {
        for (what, colour) in [("diffuse", diffuse), ("specular", specular)] {
            if !(colour.cmpge(Vec3::ZERO) & colour.cmple(Vec3::ONE)).all() {
                return Err(MaterialError::BadColour { what, colour });
            }
        }
        if !(1..=MAX_SHININESS).contains(&shininess) {
            return Err(MaterialError::BadShininess(shininess));
        }
        Ok(Self { diffuse, specular, shininess, ..Self::default() })
    }

    /// Sets the refracted part of the light and the index of refraction.
    ///
    /// `transmission` is from 0 (default) to 1; the rest is scattered. `ior` is from 1 to
    /// [`MAX_IOR`]. Its default is 1.5, the index of glass.
    ///
    /// # Errors
    ///
    /// When `transmission` or `ior` is out of range.
    pub fn with_transmission(self, transmission: f32, ior: f32) -> Result<Self, MaterialError> {
        if !(0.0..=1.0).contains(&transmission) {
            return Err(MaterialError::BadTransmission(transmission));
        }
        if !(1.0..=MAX_IOR).contains(&ior) {
            return Err(MaterialError::BadIor(ior));
        }
        Ok(Self { transmission, ior, ..self })
    }

    /// Replaces the diffuse colour, each component clamped to 0..1.
    #[must_use]
    pub(crate) fn with_diffuse(self, diffuse: Vec3) -> Self {
        Self { diffuse: diffuse.clamp(Vec3::ZERO, Vec3::ONE), ..self }
    }

    /// Returns the linear diffuse colour: the part of the light that is scattered in all
    /// directions, from 0 to 1. Default: 0.4 each.
    pub fn diffuse(&self) -> Vec3 {
        self.diffuse
    }

    /// Returns the linear specular colour: the strength of the highlight, from 0 to 1. Default: 0.1
    /// each.
    pub fn specular(&self) -> Vec3 {
        self.specular
    }

    /// Returns the exponent of the highlight, from 1 to [`MAX_SHININESS`]. Greater exponents give
    /// smaller highlights. Default: 32.
    pub fn shininess(&self) -> u32 {
        self.shininess
    }

    /// Returns the part of the light that is refracted instead of scattered, from 0 to 1. Default:
    /// 0.
    pub fn transmission(&self) -> f32 {
        self.transmission
    }

    /// Returns the index of refraction, from 1 to [`MAX_IOR`]. Default: 1.5.
    pub fn ior(&self) -> f32 {
        self.ior
    }
}

impl Default for Material {
    /// Grey with a faint, broad highlight. The grey leaves a margin for brighter slopes under the
    /// default light.
    fn default() -> Self {
        let (diffuse, specular) = (Vec3::splat(0.4), Vec3::splat(0.1));
        Self { diffuse, specular, shininess: 32, transmission: 0.0, ior: 1.5 }
    }
}

impl Material {
    /// Returns the default material for a surface with a colour picture. Its diffuse colour is 0.8
    /// instead of 0.4, so that it darkens the picture only a little.
    pub fn under_colours() -> Self {
        Self { diffuse: Vec3::splat(0.8), ..Self::default() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_colours_and_exponents_in_range_are_accepted() {
        assert!(
            Material::new(Vec3::ONE, Vec3::ZERO, 1).is_ok()
                && Material::new(Vec3::ONE, Vec3::ONE, 1024).is_ok()
        );
        for colour in [Vec3::new(0.0, 1.1, 0.0), Vec3::new(-0.1, 0.0, 0.0), Vec3::NAN] {
            assert!(matches!(
                Material::new(colour, Vec3::ONE, 1),
                Err(MaterialError::BadColour { what: "diffuse", .. })
            ));
            assert!(matches!(
                Material::new(Vec3::ONE, colour, 1),
                Err(MaterialError::BadColour { what: "specular", .. })
            ));
        }
        for shininess in [0, 1025] {
            assert_eq!(
                Material::new(Vec3::ONE, Vec3::ONE, shininess),
                Err(MaterialError::BadShininess(shininess))
            );
        }
        let Material { diffuse, specular, shininess, transmission, ior } = Material::default();
        let default = Material::new(diffuse, specular, shininess);
        assert_eq!(default.and_then(|own| own.with_transmission(transmission, ior)), Ok(Material::default()));
        for transmission in [-0.1, 1.1, f32::INFINITY] {
            let error = Material::default().with_transmission(transmission, 1.5);
            assert_eq!(error, Err(MaterialError::BadTransmission(transmission)));
        }
        for ior in [0.9, 4.5, f32::INFINITY] {
            assert_eq!(Material::default().with_transmission(0.0, ior), Err(MaterialError::BadIor(ior)));
        }
        assert!(Material::default().with_transmission(f32::NAN, 1.5).is_err());
        assert!(Material::default().with_transmission(0.5, f32::NAN).is_err());
    }
}
