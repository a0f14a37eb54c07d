//! The material: Blinn-Phong.

use glam::Vec3;

/// Greatest index of refraction, germanium's. A vacuum has the least, 1.
pub const MAX_IOR: f32 = 4.0;

/// The greatest shininess. It is a whole number so that shaders can raise to it by multiplication alone, with
/// the same bits everywhere; beyond this a highlight is smaller than a pixel.
pub const MAX_SHININESS: u32 = 1024;

/// A Blinn-Phong material that may be transparent: under irradiance `E` from direction `L`, seen from `V`,
/// with `h` half-way between, `E (diffuse (N·L) + specular (N·h)^shininess)`.
///
/// Colours are linear, red, green, blue, each part from 0 to 1. Of a transparent one a part of the light that
/// enters is refracted in place of being scattered; what is seen by it, and how much is reflected of the
/// surroundings, the ambient light `environment` says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    diffuse: Vec3,
    specular: Vec3,
    shininess: u32,
    transmission: f32,
    ior: f32,
}

/// Why there is no such material.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MaterialError {
    /// A colour is not between 0 and 1.
    #[error("the {what} colour is {colour}: each part must be from 0 to 1")]
    BadColour {
        /// Which colour.
        what: &'static str,
        /// Its value.
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
    /// A material of those colours; `shininess` is a whole number from 1 to [`MAX_SHININESS`]. Where a scene
    /// has a colour picture, `diffuse` multiplies it.
    ///
    /// # Errors
    ///
    /// When a part of a colour or the shininess is out of range.
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

    /// The same with a part of the light that is refracted, not scattered, from 0 to 1 (by default 0), and an
    /// index of refraction, from 1 to [`MAX_IOR`] (by default 1.5, as of glass).
    ///
    /// # Errors
    ///
    /// When one of them is out of range.
    pub fn with_transmission(self, transmission: f32, ior: f32) -> Result<Self, MaterialError> {
        if !(0.0..=1.0).contains(&transmission) {
            return Err(MaterialError::BadTransmission(transmission));
        }
        if !(1.0..=MAX_IOR).contains(&ior) {
            return Err(MaterialError::BadIor(ior));
        }
        Ok(Self { transmission, ior, ..self })
    }

    /// The same of another diffuse colour, whose parts are cut off at 0 and 1.
    #[must_use]
    pub(crate) fn with_diffuse(self, diffuse: Vec3) -> Self {
        Self { diffuse: diffuse.clamp(Vec3::ZERO, Vec3::ONE), ..self }
    }

    /// The part of the light that is scattered in all directions.
    pub fn diffuse(&self) -> Vec3 {
        self.diffuse
    }

    /// The strength of the highlight.
    pub fn specular(&self) -> Vec3 {
        self.specular
    }

    /// The exponent of the highlight: greater is smaller.
    pub fn shininess(&self) -> u32 {
        self.shininess
    }

    /// The part of the light that is refracted, not scattered.
    pub fn transmission(&self) -> f32 {
        self.transmission
    }

    /// The index of refraction.
    pub fn ior(&self) -> f32 {
        self.ior
    }
}

impl Default for Material {
    /// Grey with a faint, broad highlight, so that the default light leaves room for brighter slopes.
    fn default() -> Self {
        let (diffuse, specular) = (Vec3::splat(0.4), Vec3::splat(0.1));
        Self { diffuse, specular, shininess: 32, transmission: 0.0, ior: 1.5 }
    }
}

impl Material {
    /// Returns the material of a surface with colours of its own, which it darkens only a little.
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
