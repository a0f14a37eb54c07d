//! Values and pictures of a material beside its colour.

use std::sync::Arc;

use relief_core::Wrap;

use super::MeshMaterial;
use crate::Picture;

/// Values of a metallic-roughness material beside its colour (glTF 2.0, 3.9, and the extensions
/// `KHR_materials_emissive_strength`, `ior`, `specular` and `transmission`).
///
/// The default is rough and no metal, like a file without materials.
#[derive(Clone, Debug, PartialEq)]
pub struct MaterialValues {
    /// Metalness, from 0 to 1. It multiplies the blue channel of the picture.
    pub metallic: f32,
    /// Roughness, from 0 to 1. It multiplies the green channel of the picture.
    pub roughness: f32,
    /// Light that the surface gives by itself: linear red, green and blue, each from 0 to 1.
    pub emission: [f32; 3],
    /// Factor on the emission, at least 0.
    pub emission_strength: f32,
    /// Index of refraction, at least 1; or 0, by which all light is reflected.
    pub ior: f32,
    /// Part of the reflection that a surface other than a metal keeps, from 0 to 1.
    pub specular: f32,
    /// Linear colour of that reflection along the normal, at least 0.
    pub specular_color: [f32; 3],
    /// Part of the light that passes the surface instead of being scattered, from 0 to 1.
    pub transmission: f32,
    /// Pictures.
    pub textures: MaterialTextures,
}

/// Pictures of a material beside its colours. All but the normals lie as the colour picture does:
/// by [`MeshMaterial::transform`] and [`MeshMaterial::wrap`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MaterialTextures {
    /// Roughness in green and metalness in blue.
    pub metallic_roughness: Option<Arc<Picture>>,
    /// Part of the light from all around that arrives, in red.
    pub occlusion: Option<OcclusionTexture>,
    /// Light that the surface gives by itself, linear; the emission multiplies it.
    pub emission: Option<Arc<Picture>>,
    /// Normals in tangent space, on the mesh's own texture coordinates.
    pub normal: Option<NormalTexture>,
}

/// Picture of occlusion.
#[derive(Clone, Debug, PartialEq)]
pub struct OcclusionTexture {
    /// Picture; red is from 0, where no light arrives, to 1.
    pub picture: Arc<Picture>,
    /// Part of the darkening that is applied, from 0 to 1.
    pub strength: f32,
}

/// Picture of normals.
#[derive(Clone, Debug, PartialEq)]
pub struct NormalTexture {
    /// Picture as it is stored: twice a channel, less 1, is `x` along growing `u`, `y` up in the
    /// picture, and `z` out of the surface.
    pub picture: Arc<Picture>,
    /// Factor on `x` and `y`.
    pub scale: f32,
    /// Continuation of the picture beyond its sides, along `u` and `v`.
    pub wrap: [Wrap; 2],
}

impl Default for MaterialValues {
    fn default() -> Self {
        Self {
            metallic: 0.0,
            roughness: 1.0,
            emission: [0.0; 3],
            emission_strength: 1.0,
            ior: 1.5,
            specular: 1.0,
            specular_color: [1.0; 3],
            transmission: 0.0,
            textures: MaterialTextures::default(),
        }
    }
}

impl MaterialValues {
    /// Returns the light that the surface gives where its picture is white, linear red, green and
    /// blue.
    pub fn light(&self) -> [f32; 3] {
        self.emission.map(|part| part * self.emission_strength)
    }
}

impl MaterialTextures {
    /// Whether there is a picture of roughness, metalness, occlusion or emission.
    pub fn has_maps(&self) -> bool {
        self.metallic_roughness.is_some() || self.occlusion.is_some() || self.emission.is_some()
    }

    /// Returns all pictures.
    pub fn pictures(&self) -> impl Iterator<Item = &Arc<Picture>> {
        let of_occlusion = self.occlusion.as_ref().map(|of| &of.picture);
        let of_normal = self.normal.as_ref().map(|of| &of.picture);
        let all = [self.metallic_roughness.as_ref(), of_occlusion, self.emission.as_ref(), of_normal];
        all.into_iter().flatten()
    }
}

impl NormalTexture {
    /// Returns the unit normal of each texel, row by row from the top: `x` along growing `u`, `y` up in
    /// the picture, `z` out of the surface. Texels without a direction have `(0, 0, 1)`.
    pub fn normals(&self) -> Vec<[f32; 3]> {
        let normal = |&[x, y, z, _]: &[f32; 4]| {
            let [x, y, z] = [x, y, z].map(|part| 2.0 * part - 1.0);
            let scaled = glam::Vec3::new(self.scale * x, self.scale * y, z);
            if scaled.length() < crate::SHORTEST { [0.0, 0.0, 1.0] } else { scaled.normalize().into() }
        };
        self.picture.texels.iter().map(normal).collect()
    }
}

impl MeshMaterial {
    /// Whether a picture lies by [`Self::transform`] and [`Self::wrap`]: of colours, roughness,
    /// metalness, occlusion or emission.
    pub fn has_placed_pictures(&self) -> bool {
        self.picture.is_some() || self.values.textures.has_maps()
    }

    /// Returns all pictures, the colour picture first.
    pub fn pictures(&self) -> impl Iterator<Item = &Arc<Picture>> {
        self.picture.iter().chain(self.values.textures.pictures())
    }
}

impl MaterialValues {
    /// Whether Blinn-Phong shading cannot show the material: it is a metal with a roughness of its own,
    /// has maps of roughness, metalness, occlusion or emission, emits light, is transparent, or
    /// reflects otherwise than glass.
    pub(super) fn needs_roughness(&self, has_maps: bool) -> bool {
        let is_metal = self.metallic > 0.0 && [self.metallic, self.roughness] != [1.0; 2];
        is_metal || has_maps || self.has_extensions() || self.light() != [0.0; 3]
    }

    /// Whether a value belongs to an extension of glTF.
    fn has_extensions(&self) -> bool {
        let plain = Self::default();
        (self.ior, self.specular, self.transmission) != (plain.ior, plain.specular, plain.transmission)
            || self.specular_color != plain.specular_color
    }
}
