//! Heights and the written material of a folder of textures.

use std::borrow::Cow;
use std::path::Path;
use std::sync::Arc;

use relief_io::{
    MaterialTextures, MaterialValues, MeshFormat, MeshMaterial, OcclusionTexture, Picture, TextureRole,
    TextureSet, find_textures,
};
use relief_scene::Surface;
use relief_scene::material_maps::MaterialMaps;

use super::{Arguments, Materials};

impl Arguments {
    /// Returns the folder of textures that gives the material, if there is one.
    pub(super) fn textures(&self) -> Option<&Path> {
        self.textures.as_deref().or_else(|| self.is_set().then_some(self.height.as_path()))
    }

    /// Whether the heights come from a folder of textures.
    pub(super) fn is_set(&self) -> bool {
        self.height.is_dir()
    }

    /// Returns the set whose heights are displaced. A folder that cannot be used is refused with the
    /// scene.
    fn set(&self) -> Option<TextureSet> {
        self.is_set().then(|| find_textures(&self.height, self.udim).ok()).flatten()
    }

    /// Returns the file of the heights.
    pub(super) fn height_file(&self) -> Cow<'_, Path> {
        let of_set = self.set().and_then(|set| set.height().ok().map(|texture| texture.path.clone()));
        of_set.map_or(Cow::Borrowed(&self.height), Cow::Owned)
    }

    /// Whether a folder of textures has depths in place of heights.
    pub(super) fn is_set_of_depths(&self) -> bool {
        self.set().is_some_and(|set| set.height().is_ok_and(|texture| texture.role == TextureRole::Depth))
    }
}

/// Returns the material of a surface whose maps are a folder's: colour, occlusion, roughness, metalness
/// and emission. The relief itself gives the normals.
///
/// # Errors
///
/// With the reason if the format has no such materials.
pub fn material(surface: &Surface, name: &str, format: MeshFormat) -> Result<Materials, String> {
    if format != MeshFormat::Gltf {
        return Err(format!("{format} cannot hold them, a .glb can"));
    }
    let of_surface = surface.material();
    let [red, green, blue] = of_surface.diffuse().to_array();
    let wrap = [surface.height_map().wrap(); 2];
    let maps = surface.material_maps();
    let mut values = MaterialValues {
        metallic: of_surface.metallic(),
        roughness: of_surface.roughness(),
        emission: of_surface.emission().to_array(),
        textures: maps.map(|maps| textures(maps)).unwrap_or_default(),
        ..MaterialValues::default()
    };
    // Pictures and colours of a glTF hold no light above 1.
    let brightest = values.textures.emission.as_ref().map_or(0.0, |picture| brightest(picture));
    if brightest > 1.0
        && let Some(picture) = values.textures.emission.as_mut().map(Arc::make_mut)
    {
        picture
            .texels
            .iter_mut()
            .for_each(|[r, g, b, _]| [r, g, b].into_iter().for_each(|part| *part /= brightest));
    }
    let factor = values.emission.iter().copied().fold(1.0, f32::max);
    values.emission = values.emission.map(|part| part / factor);
    values.emission_strength = factor * brightest.max(1.0);
    let plain = MeshMaterial { wrap, ..MeshMaterial::default() };
    let material = MeshMaterial {
        name: Some(name.into()),
        factor: [red, green, blue, 1.0],
        values,
        ..surface.color_material().unwrap_or(plain)
    };
    Ok((vec![material], Vec::new()))
}

/// Returns the greatest part of a picture's colours.
fn brightest(picture: &Picture) -> f32 {
    picture.texels.iter().flat_map(|[r, g, b, _]| [*r, *g, *b]).fold(0.0, f32::max)
}

/// Returns the maps of a material as pictures of a glTF.
fn textures(maps: &MaterialMaps) -> MaterialTextures {
    let [width, height] = maps.size();
    let picture = |texel: fn(&[f32; 8]) -> [f32; 4]| {
        Arc::new(Picture { width, height, texels: maps.texels().iter().map(texel).collect() })
    };
    let of_surface = maps.has_surface().then(|| picture(|texel| [texel[0], texel[1], texel[2], 1.0]));
    // A channel without a map is 1.
    let has_occlusion = maps.texels().iter().any(|texel| texel[0] != 1.0);
    let occlusion = of_surface.clone().filter(|_| has_occlusion);
    MaterialTextures {
        occlusion: occlusion.map(|picture| OcclusionTexture { picture, strength: 1.0 }),
        metallic_roughness: of_surface,
        emission: maps.has_emission().then(|| picture(|texel| [texel[4], texel[5], texel[6], 1.0])),
        normal: None,
    }
}
