//! Flags that name maps of a material for an engine, over the names in a folder.

use std::path::{Path, PathBuf};

use clap::Args;
use relief_io::{TextureRole, TextureSet};
use relief_scene::NO_MAP;

/// Files of maps.
#[derive(Args, Clone)]
#[command(next_help_heading = "Maps of a material for an engine")]
pub struct GivenMaps {
    /// Height map, in place of the folder's
    #[arg(id = "height-map", long = "height", value_name = "FILE", hide_short_help = true)]
    height: Option<PathBuf>,
    /// Colour map in sRGB, in place of the folder's. The name none drops it, as for all maps but heights
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    color: Option<PathBuf>,
    /// Tangent-space normal map
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    normal: Option<PathBuf>,
    /// Roughness map
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    roughness: Option<PathBuf>,
    /// Glossiness or smoothness map, in place of roughness
    #[arg(long, value_name = "FILE", conflicts_with = "roughness", hide_short_help = true)]
    glossiness: Option<PathBuf>,
    /// Metalness map
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    metallic: Option<PathBuf>,
    /// Occlusion map
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    occlusion: Option<PathBuf>,
    /// Occlusion, roughness and metalness in red, green and blue of one file
    #[arg(long, visible_alias = "arm", value_name = "FILE", hide_short_help = true)]
    orm: Option<PathBuf>,
    /// Metalness, occlusion and smoothness in red, green and opacity of one file
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    mask_map: Option<PathBuf>,
    /// Metalness in red and smoothness in opacity of one file
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    metallic_smoothness: Option<PathBuf>,
    /// Emission map in sRGB
    #[arg(long, value_name = "FILE", hide_short_help = true)]
    emission: Option<PathBuf>,
}

impl GivenMaps {
    /// Returns the maps that are named, with their flags and roles.
    fn each(&self) -> impl Iterator<Item = (&'static str, TextureRole, &Path)> {
        let all = [
            ("--height", TextureRole::Height, &self.height),
            ("--color", TextureRole::Color, &self.color),
            ("--normal", TextureRole::Normal, &self.normal),
            ("--roughness", TextureRole::Roughness, &self.roughness),
            ("--glossiness", TextureRole::Glossiness, &self.glossiness),
            ("--metallic", TextureRole::Metallic, &self.metallic),
            ("--occlusion", TextureRole::Occlusion, &self.occlusion),
            ("--orm", TextureRole::Orm, &self.orm),
            ("--mask-map", TextureRole::MaskMap, &self.mask_map),
            ("--metallic-smoothness", TextureRole::MetallicSmoothness, &self.metallic_smoothness),
            ("--emission", TextureRole::Emission, &self.emission),
        ];
        all.into_iter().filter_map(|(flag, role, path)| Some((flag, role, path.as_deref()?)))
    }

    /// Returns the first flag that is given.
    pub fn first(&self) -> Option<&'static str> {
        self.each().next().map(|(flag, ..)| flag)
    }

    /// Returns the height map that is named.
    pub fn height(&self) -> Option<&Path> {
        self.height.as_deref()
    }

    /// Returns a set with the maps that are named, in place of its own.
    pub fn over(&self, set: TextureSet) -> TextureSet {
        self.each().fold(set, |set, (_, role, path)| match path == Path::new(NO_MAP) {
            true if role != TextureRole::Height => set.without(role),
            _ => set.with(role, path.to_owned()),
        })
    }
}
