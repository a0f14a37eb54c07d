//! Materials: metallic-roughness or Blinn-Phong, with optional emission and refraction.

use glam::Vec3;

/// Greatest index of refraction, germanium's. The least is 1, a vacuum's.
pub const MAX_IOR: f32 = 4.0;

/// Greatest shininess. Shininess is a whole number so that shaders raise to it by multiplication
/// alone, with the same bits everywhere. A highlight beyond this is smaller than a pixel.
pub const MAX_SHININESS: u32 = 1024;

/// Greatest part of an emission. It is the greatest 16-bit float, which the pictures of GPUs hold.
pub const MAX_EMISSION: f32 = 65504.0;

/// Shading model of a material.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ShadingModel {
    /// The stage's variant `blinn-phong`: diffuse and specular colour, and a shininess.
    BlinnPhong,
    /// The stage's variant `metallic-roughness`: base colour, roughness and metalness, as in glTF
    /// 2.0 and most engines.
    MetallicRoughness,
}

/// Material that may give light and may be transparent.
///
/// Under irradiance `E` from direction `L`, seen from `V`, with `h` half-way between, a Blinn-Phong
/// material reflects `E (diffuse (N·L) + specular (N·h)^shininess)`. A metallic-roughness material
/// reflects what appendix B of glTF 2.0 says, times pi, so that a white surface under an irradiance
/// of 1 shows as 1. A default material suits both models; the scene's look chooses one.
///
/// Colours are linear red, green and blue, each from 0 to 1. A transparent material refracts a part
/// of the light that enters instead of scattering it. The ambient variant `environment` computes
/// refraction and mirrored light from the environment map.
///
/// # Examples
///
/// ```
/// use glam::Vec3;
/// use relief_scene::material::Material;
///
/// let gold = Material::metallic_roughness(Vec3::new(1.0, 0.77, 0.34), 1.0, 0.3)?;
/// let lamp = Material::default().with_emission(Vec3::splat(4.0))?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    model: Option<ShadingModel>,
    diffuse: Vec3,
    specular: Vec3,
    shininess: u32,
    roughness: f32,
    metallic: f32,
    emission: Vec3,
    transmission: f32,
    ior: f32,
}

/// Reason why a material is invalid.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MaterialError {
    /// A component of a colour is not from 0 to 1.
    #[error("the {what} colour is {colour}: each part must be from 0 to 1")]
    BadColour {
        /// Name of the colour: `diffuse`, `specular` or `base`.
        what: &'static str,
        /// Value of the colour.
        colour: Vec3,
    },
    /// The shininess is out of range.
    #[error("the shininess is {0}: it must be a whole number from 1 to {MAX_SHININESS}")]
    BadShininess(u32),
    /// The roughness or the metalness is out of range.
    #[error("the {what} is {value}: it must be from 0 to 1")]
    BadPart {
        /// Name of the value: `roughness` or `metalness`.
        what: &'static str,
        /// Value.
        value: f32,
    },
    /// A part of the emission is out of range.
    #[error("the emission is {0}: each part must be from 0 to {MAX_EMISSION}")]
    BadEmission(Vec3),
    /// The transmission is out of range.
    #[error("the transmission is {0}: it must be from 0 to 1")]
    BadTransmission(f32),
    /// The index of refraction is out of range.
    #[error("the index of refraction is {0}: it must be from 1 to {MAX_IOR}")]
    BadIor(f32),
}

impl Material {
    /// Creates an opaque Blinn-Phong material from linear colours, each component from 0 to 1.
    ///
    /// `shininess` is a whole number from 1 to [`MAX_SHININESS`]. If the surface has a colour
    /// picture, `diffuse` multiplies it.
    ///
    /// # Errors
    ///
    /// When a component of a colour or the shininess is out of range.
    pub fn new(diffuse: Vec3, specular: Vec3, shininess: u32) -> Result<Self, MaterialError> {
        check_colour("diffuse", diffuse)?;
        check_colour("specular", specular)?;
        if !(1..=MAX_SHININESS).contains(&shininess) {
            return Err(MaterialError::BadShininess(shininess));
        }
        let model = Some(ShadingModel::BlinnPhong);
        Ok(Self { model, diffuse, specular, shininess, ..Self::default() })
    }

    /// Creates an opaque metallic-roughness material (glTF 2.0, 3.9.2).
    ///
    /// `base` is a linear colour, each component from 0 to 1: what is scattered, and what a metal
    /// reflects. `metallic` is 0 for all but metals, whose value is 1. `roughness` is from 0 for
    /// mirrors to 1; its square is the width of the highlight. Shaders use at least 0.045.
    ///
    /// Pictures of the surface multiply these values.
    ///
    /// # Errors
    ///
    /// When a component of the colour, `metallic` or `roughness` is not from 0 to 1.
    pub fn metallic_roughness(base: Vec3, metallic: f32, roughness: f32) -> Result<Self, MaterialError> {
        check_colour("base", base)?;
        for (what, value) in [("metalness", metallic), ("roughness", roughness)] {
            if !(0.0..=1.0).contains(&value) {
                return Err(MaterialError::BadPart { what, value });
            }
        }
        let model = Some(ShadingModel::MetallicRoughness);
        Ok(Self { model, diffuse: base, metallic, roughness, ..Self::default() })
    }

    /// Sets the light that the surface gives by itself: linear radiance, each part from 0, the
    /// default, to [`MAX_EMISSION`]. Shadings other than `metallic-roughness` ignore it.
    ///
    /// # Errors
    ///
    /// When a part is out of range.
    pub fn with_emission(self, emission: Vec3) -> Result<Self, MaterialError> {
        let possible = emission.cmpge(Vec3::ZERO) & emission.cmple(Vec3::splat(MAX_EMISSION));
        if !possible.all() {
            return Err(MaterialError::BadEmission(emission));
        }
        Ok(Self { emission, ..self })
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

    /// Returns the material without a model of its own: the look chooses one.
    pub(crate) fn for_any_model(self) -> Self {
        Self { model: None, ..self }
    }

    /// Replaces the diffuse colour, each component clamped to 0..1.
    #[must_use]
    pub(crate) fn with_diffuse(self, diffuse: Vec3) -> Self {
        Self { diffuse: diffuse.clamp(Vec3::ZERO, Vec3::ONE), ..self }
    }

    /// Returns the shading model for which the material was made. `None` for a default material,
    /// which suits all.
    pub fn model(&self) -> Option<ShadingModel> {
        self.model
    }

    /// Returns the linear diffuse or base colour, from 0 to 1: the part of the light that is
    /// scattered in all directions, or reflected by a metal. Default: 0.4 each.
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

    /// Returns the roughness, from 0 to 1. Default: 0.5.
    pub fn roughness(&self) -> f32 {
        self.roughness
    }

    /// Returns the metalness, from 0 to 1. Default: 0.
    pub fn metallic(&self) -> f32 {
        self.metallic
    }

    /// Returns the light that the surface gives by itself, linear radiance. Default: 0.
    pub fn emission(&self) -> Vec3 {
        self.emission
    }

    /// Returns the part of light along the normal that a surface other than a metal reflects, by
    /// its index of refraction: 0.04 at 1.5.
    pub fn reflectance(&self) -> f32 {
        let part = (self.ior - 1.0) / (self.ior + 1.0);
        part * part
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
        Self {
            model: None,
            diffuse,
            specular,
            shininess: 32,
            roughness: 0.5,
            metallic: 0.0,
            emission: Vec3::ZERO,
            transmission: 0.0,
            ior: 1.5,
        }
    }
}

impl Material {
    /// Returns the default material for a surface with a colour picture. Its diffuse colour is 0.8
    /// instead of 0.4, so that it darkens the picture only a little.
    pub fn under_colours() -> Self {
        Self { diffuse: Vec3::splat(0.8), ..Self::default() }
    }
}

fn check_colour(what: &'static str, colour: Vec3) -> Result<(), MaterialError> {
    if (colour.cmpge(Vec3::ZERO) & colour.cmple(Vec3::ONE)).all() {
        return Ok(());
    }
    Err(MaterialError::BadColour { what, colour })
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
        let plain = Material::default();
        let own = Material::new(plain.diffuse, plain.specular, plain.shininess);
        let own = own.and_then(|own| own.with_transmission(plain.transmission, plain.ior));
        assert_eq!(own, Ok(Material { model: Some(ShadingModel::BlinnPhong), ..plain }));
        assert!((plain.reflectance() - 0.04).abs() < 1e-7);
        for transmission in [-0.1, 1.1, f32::INFINITY] {
            let error = Material::default().with_transmission(transmission, 1.5);
            assert_eq!(error, Err(MaterialError::BadTransmission(transmission)));
        }
        for ior in [0.9, 4.5, f32::INFINITY] {
            assert_eq!(Material::default().with_transmission(0.0, ior), Err(MaterialError::BadIor(ior)));
        }
        for (metallic, roughness) in [(1.1, 0.5), (0.5, -0.1), (f32::NAN, 0.5), (0.5, f32::INFINITY)] {
            let error = Material::metallic_roughness(Vec3::ONE, metallic, roughness);
            assert!(matches!(error, Err(MaterialError::BadPart { .. })), "{error:?}");
        }
        let base = Vec3::new(0.5, 1.5, 0.5);
        let error = Material::metallic_roughness(base, 0.0, 1.0);
        assert_eq!(error, Err(MaterialError::BadColour { what: "base", colour: base }));
        for emission in [Vec3::NAN, Vec3::splat(-1.0), Vec3::splat(1e6)] {
            assert!(Material::default().with_emission(emission).is_err());
        }
        assert!(Material::default().with_transmission(f32::NAN, 1.5).is_err());
        assert!(Material::default().with_transmission(0.5, f32::NAN).is_err());
    }
}
