//! Roles of textures: what a picture of a material stores.

use std::fmt;

/// Role of a texture: what its values mean.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum TextureRole {
    /// Base colour, also called albedo or diffuse colour.
    Color,
    /// Height, also called displacement.
    Height,
    /// Depth below the surface: 1 is deepest.
    Depth,
    /// Normals in tangent space.
    Normal,
    /// Roughness: 0 is smooth.
    Roughness,
    /// Glossiness or smoothness: 1 is smooth.
    Glossiness,
    /// Metalness: 1 is metal.
    Metallic,
    /// Ambient occlusion: 1 is open.
    Occlusion,
    /// Colour of the light that the surface emits.
    Emission,
    /// Opacity: 1 is opaque.
    Opacity,
    /// Reflectance, as a colour or a level.
    Specular,
    /// Occlusion, roughness and metalness in red, green and blue, also called ARM.
    Orm,
    /// Metalness in red and smoothness in alpha, as in Unity.
    MetallicSmoothness,
    /// Metalness, occlusion, detail mask and smoothness in red, green, blue and alpha, as in Unity's
    /// HDRP.
    MaskMap,
}

impl TextureRole {
    /// Returns the role in plain words.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Color => "colour",
            Self::Height => "height",
            Self::Depth => "depth",
            Self::Normal => "normals",
            Self::Roughness => "roughness",
            Self::Glossiness => "glossiness",
            Self::Metallic => "metalness",
            Self::Occlusion => "occlusion",
            Self::Emission => "emission",
            Self::Opacity => "opacity",
            Self::Specular => "specular reflection",
            Self::Orm => "occlusion, roughness and metalness in one map",
            Self::MetallicSmoothness => "metalness and smoothness in one map",
            Self::MaskMap => "metalness, occlusion, detail mask and smoothness in one map",
        }
    }

    /// Returns the roles that a packed map gives, each with its channel: 0 is red, 3 is alpha.
    /// Empty for a map of one role.
    pub const fn channels(self) -> &'static [(usize, TextureRole)] {
        match self {
            Self::Orm => &[(0, Self::Occlusion), (1, Self::Roughness), (2, Self::Metallic)],
            Self::MetallicSmoothness => &[(0, Self::Metallic), (3, Self::Glossiness)],
            Self::MaskMap => &[(0, Self::Metallic), (1, Self::Occlusion), (3, Self::Glossiness)],
            _ => &[],
        }
    }
}

impl fmt::Display for TextureRole {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
