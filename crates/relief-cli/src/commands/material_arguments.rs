//! Flags of the material and its maps.

use std::path::PathBuf;

use clap::Args;
use relief_scene::{MaterialSpec, SurfaceSpec};

use crate::values;

/// Values of the material, and the files of its maps.
#[derive(Args)]
pub struct MaterialArguments {
    /// Folder of a material's maps, recognised by their names, as ambientCG, Poly Haven, Substance,
    /// Unreal and Unity give them. Flags that name a map replace one of them; the name none drops it,
    /// as in --normal none [default: none]
    #[arg(long, value_name = "FOLDER", help_heading = "Maps and mesh")]
    textures: Option<PathBuf>,
    /// UDIM tile whose maps are taken from the folder, as in 1001 [default: the only one]
    #[arg(long, value_name = "N", help_heading = "Maps and mesh", hide_short_help = true)]
    udim: Option<u32>,
    /// Roughness map, 0 smooth to 1 rough, in its first channel [default: none]
    #[arg(
        long,
        value_name = "FILE",
        value_parser = |text: &str| values::map_file(text, "roughness"),
        help_heading = "Maps and mesh",
        hide_short_help = true
    )]
    roughness: Option<PathBuf>,
    /// Metalness map, 1 for metal, in its first channel [default: none]
    #[arg(
        long,
        value_name = "FILE",
        value_parser = |text: &str| values::map_file(text, "metallic"),
        help_heading = "Maps and mesh",
        hide_short_help = true
    )]
    metallic: Option<PathBuf>,
    /// Occlusion map for the light from all around, 1 for open, in its first channel [default: none]
    #[arg(long, value_name = "FILE", help_heading = "Maps and mesh", hide_short_help = true)]
    occlusion: Option<PathBuf>,
    /// Occlusion, roughness and metalness in red, green and blue of one file, called ORM or ARM.
    /// Maps of their own replace its channels [default: none]
    #[arg(long, visible_alias = "arm", value_name = "FILE", help_heading = "Maps and mesh")]
    orm: Option<PathBuf>,
    /// Metalness, occlusion and smoothness in red, green and opacity of one file, the mask map of
    /// Unity's HDRP [default: none]
    #[arg(long, value_name = "FILE", help_heading = "Maps and mesh", hide_short_help = true)]
    mask_map: Option<PathBuf>,
    /// Metalness in red and smoothness in opacity of one file, as Unity has them [default: none]
    #[arg(long, value_name = "FILE", help_heading = "Maps and mesh", hide_short_help = true)]
    metallic_smoothness: Option<PathBuf>,
    /// Glossiness or smoothness map, 1 less the roughness, in its first channel [default: none]
    #[arg(long, value_name = "FILE", help_heading = "Maps and mesh", hide_short_help = true)]
    glossiness: Option<PathBuf>,
    /// Emission map in sRGB: the light that the surface gives by itself [default: none]
    #[arg(long, value_name = "FILE", help_heading = "Maps and mesh", hide_short_help = true)]
    emission: Option<PathBuf>,
    /// Material parameter, repeatable: base=0.9,0.6,0.2 (linear, 0 to 1) or base=#c08040 (sRGB),
    /// roughness=0.3 or metallic=1 (0 to 1), emission=2,1,0.5 (linear); these multiply the maps. With
    /// diffuse=R,G,B, specular=R,G,B or shininess=N (1 to 1024) the shading is blinn-phong [default:
    /// base 0.4, 1 under a colour map; roughness 0.5 and metallic 0, 1 under a map]
    #[arg(
        long,
        value_name = "PART=VALUE",
        value_parser = values::material,
        help_heading = "Maps and mesh",
        hide_short_help = true,
    )]
    material: Vec<MaterialSpec>,
    /// Share of light that is refracted instead of scattered, 0 to 1; 1 is clear glass, which shows
    /// the environment map [default: 0]
    #[arg(
        long,
        value_name = "F",
        allow_hyphen_values = true,
        help_heading = "Maps and mesh",
        hide_short_help = true
    )]
    transmission: Option<f32>,
    /// How dense a translucent volume is: its optical depth on a metre of way where it is 1. Twice as
    /// much is twice as dense; of light straight through M metres exp(-N M) is left. For --method
    /// translucent [default: 8 over the scale]
    #[arg(
        long,
        value_name = "N",
        allow_hyphen_values = true,
        help_heading = "Maps and mesh",
        hide_short_help = true
    )]
    extinction: Option<f64>,
    /// Index of refraction, 1 to 4; also sets how much is reflected [default: 1.5]
    #[arg(
        long,
        value_name = "N",
        allow_hyphen_values = true,
        help_heading = "Maps and mesh",
        hide_short_help = true
    )]
    ior: Option<f32>,
}

impl MaterialArguments {
    /// Returns a description of a surface with this material.
    pub fn surface(&self, surface: SurfaceSpec) -> SurfaceSpec {
        SurfaceSpec {
            textures: self.textures.clone(),
            udim: self.udim,
            roughness: self.roughness.clone(),
            metallic: self.metallic.clone(),
            occlusion: self.occlusion.clone(),
            orm: self.orm.clone(),
            mask_map: self.mask_map.clone(),
            metallic_smoothness: self.metallic_smoothness.clone(),
            glossiness: self.glossiness.clone(),
            emission: self.emission.clone(),
            material: self.material.iter().cloned().reduce(MaterialSpec::merged),
            transmission: self.transmission,
            extinction: self.extinction,
            ior: self.ior,
            ..surface
        }
    }

    /// Whether a folder of textures is named.
    pub fn names_textures(&self) -> bool {
        self.textures.is_some()
    }

    /// Returns the files of its maps, which may be standard input.
    pub fn files(&mut self) -> impl Iterator<Item = &mut PathBuf> {
        let Self {
            roughness,
            metallic,
            occlusion,
            orm,
            mask_map,
            metallic_smoothness,
            glossiness,
            emission,
            ..
        } = self;
        let single = [roughness, metallic, occlusion, glossiness, emission].into_iter();
        single.chain([orm, mask_map, metallic_smoothness]).flatten()
    }
}
