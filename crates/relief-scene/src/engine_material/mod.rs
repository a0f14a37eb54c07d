//! Materials for engines: a texture set or a height map, packed and written as an engine takes it.
//!
//! [`relief_io::ENGINES`] has the conventions.

mod note;
mod write;

use std::path::{Path, PathBuf};

use relief_core::{Cancelled, HeightMap, Metric};
use relief_io::{
    Engine, EngineModel, EngineShape, EngineTexture, FoundTexture, GreenSign, ModelTextures, ReadError,
    SurfaceChannel, TextureContent, TextureRole, TextureSet, WriteError,
};

use crate::material_maps::{MaterialMap, MaterialMapError};

/// Material that is written for an engine.
///
/// Textures are read when they are written, one after the other.
#[derive(Clone, Debug)]
pub struct EngineMaterial<'a> {
    engine: &'static Engine,
    name: &'a str,
    heights: &'a HeightMap,
    metric: Metric,
    set: Option<&'a TextureSet>,
    green: GreenSign,
    max_bytes: u64,
}

/// Error of writing a material for an engine.
#[derive(Debug, thiserror::Error)]
pub enum EngineMaterialError {
    /// A picture cannot be read.
    #[error(transparent)]
    Picture(#[from] ReadError),
    /// A picture is no map of a material.
    #[error("{}: {problem}", path.display())]
    Map {
        /// File of the picture.
        path: PathBuf,
        /// Reason.
        problem: MaterialMapError,
    },
    /// A file cannot be written.
    #[error(transparent)]
    Write(#[from] WriteError),
    /// Writing was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Facts about textures that are known once they are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WrittenFacts {
    /// Whether the base colour has texels that are not opaque.
    pub has_opacity: bool,
    /// Factor on the emission, at least 1: the brightest value of the set's map.
    pub emission_strength: f32,
    /// Columns and rows to which maps of different sizes were resampled, to share a file.
    pub resampled: Option<[u32; 2]>,
    /// Texels of the set's normal map without a direction. They are written as level.
    pub degenerate_normals: u64,
}

impl Default for WrittenFacts {
    fn default() -> Self {
        Self { has_opacity: false, emission_strength: 1.0, resampled: None, degenerate_normals: 0 }
    }
}

/// Roles of textures that give parts of a surface, by the kinds of material maps.
const SURFACE_ROLES: [(MaterialMap, TextureRole); 7] = [
    (MaterialMap::Packed, TextureRole::Orm),
    (MaterialMap::Mask, TextureRole::MaskMap),
    (MaterialMap::MetallicSmoothness, TextureRole::MetallicSmoothness),
    (MaterialMap::Occlusion, TextureRole::Occlusion),
    (MaterialMap::Roughness, TextureRole::Roughness),
    (MaterialMap::Glossiness, TextureRole::Glossiness),
    (MaterialMap::Metallic, TextureRole::Metallic),
];

impl<'a> EngineMaterial<'a> {
    /// Creates a material of heights alone, for `engine`. `name` begins the names of its files. The
    /// map's displacement and the metric hold the scale.
    pub fn new(engine: &'static Engine, name: &'a str, heights: &'a HeightMap, metric: Metric) -> Self {
        let (set, green, max_bytes) = (None, GreenSign::PlusY, u64::MAX);
        Self { engine, name, heights, metric, set, green, max_bytes }
    }

    /// Returns the material with the textures of a set. `green` is the direction of green in the
    /// set's normal map.
    #[must_use]
    pub fn with_textures(self, set: &'a TextureSet, green: GreenSign) -> Self {
        Self { set: Some(set), green, ..self }
    }

    /// Returns the material with a limit in bytes on the memory for reading one picture.
    #[must_use]
    pub fn with_max_bytes(self, max_bytes: u64) -> Self {
        Self { max_bytes, ..self }
    }

    /// Returns the engine.
    pub fn engine(&self) -> &'static Engine {
        self.engine
    }

    fn texture(&self, role: TextureRole) -> Option<&'a FoundTexture> {
        self.set?.texture(role)
    }

    /// Returns the set's normal map. Without one, the normals come from the heights.
    pub fn normal_map(&self) -> Option<&'a FoundTexture> {
        self.texture(TextureRole::Normal)
    }

    /// Returns the textures that are written.
    pub fn textures(&self) -> Vec<&'static EngineTexture> {
        let is_written = |texture: &&EngineTexture| match texture.content {
            TextureContent::Color => self.texture(TextureRole::Color).is_some(),
            TextureContent::Normal | TextureContent::Height(_) => true,
            TextureContent::Surface(_) => self.surface_files().next().is_some(),
            TextureContent::Emission => self.texture(TextureRole::Emission).is_some(),
        };
        self.engine.textures.iter().filter(is_written).collect()
    }

    /// Returns the name of a texture's file.
    pub fn file_name(&self, texture: &EngineTexture) -> String {
        texture.file_name(self.name)
    }

    /// Returns the set's files that are read beside the heights.
    pub fn files(&self) -> Vec<&'a FoundTexture> {
        let roles = [TextureRole::Color, TextureRole::Normal, TextureRole::Emission];
        let single = roles.into_iter().filter_map(|role| self.texture(role));
        single.chain(self.surface_files().map(|(_, texture)| texture)).collect()
    }

    /// Returns the set's files that are not read.
    pub fn unread(&self) -> Vec<&'a FoundTexture> {
        let roles = [TextureRole::Opacity, TextureRole::Specular];
        roles.into_iter().filter_map(|role| self.texture(role)).collect()
    }

    /// Returns the parts of a material that the set lacks, in plain words. Normals come from the
    /// heights and most surfaces emit nothing, so neither is among them.
    pub fn missing(&self) -> Vec<&'static str> {
        let color = self.texture(TextureRole::Color).is_none().then_some("base colour");
        let parts = [SurfaceChannel::Occlusion, SurfaceChannel::Roughness, SurfaceChannel::Metalness];
        let surface = parts.into_iter().filter(|part| !self.has(*part)).map(SurfaceChannel::name);
        color.into_iter().chain(surface).collect()
    }

    /// Returns the files of the surface's parts, in the order in which later ones go before earlier.
    fn surface_files(&self) -> impl Iterator<Item = (MaterialMap, &'a FoundTexture)> {
        SURFACE_ROLES.into_iter().filter_map(|(map, role)| Some((map, self.texture(role)?)))
    }

    /// Whether the set gives a part of the surface.
    fn has(&self, part: SurfaceChannel) -> bool {
        let roles: &[TextureRole] = match part {
            SurfaceChannel::Occlusion => &[TextureRole::Occlusion],
            SurfaceChannel::Roughness | SurfaceChannel::Smoothness => {
                &[TextureRole::Roughness, TextureRole::Glossiness]
            }
            SurfaceChannel::Metalness => &[TextureRole::Metallic],
            SurfaceChannel::Unused => &[],
        };
        let gives = |texture: &FoundTexture| {
            let channels = texture.role.channels();
            roles.contains(&texture.role) || channels.iter().any(|(_, role)| roles.contains(role))
        };
        self.surface_files().any(|(_, texture)| gives(texture))
    }

    /// Returns a plane with this material, if the engine takes materials from a glTF.
    pub fn plane(&self, facts: &WrittenFacts) -> Option<EngineModel> {
        let cells = self.engine.plane_cells?;
        Some(self.model(facts, EngineShape::Plane { tile_m: self.metric.tile_m, cells }))
    }

    /// Returns a mesh with this material.
    pub fn model(&self, facts: &WrittenFacts, shape: EngineShape) -> EngineModel {
        let mut textures = ModelTextures {
            has_opacity: facts.has_opacity,
            has_occlusion: self.has(SurfaceChannel::Occlusion),
            emission_strength: facts.emission_strength,
            ..ModelTextures::default()
        };
        for texture in self.textures() {
            let slot = match texture.content {
                TextureContent::Color => &mut textures.color,
                TextureContent::Normal => &mut textures.normal,
                TextureContent::Surface(_) => &mut textures.surface,
                TextureContent::Height(_) => &mut textures.height,
                TextureContent::Emission => &mut textures.emission,
            };
            *slot = Some(self.file_name(texture));
        }
        EngineModel {
            name: self.name.to_owned(),
            shape,
            scale_m: self.heights.scale_m(),
            bias_m: self.heights.bias_m(),
            wrap: self.heights.wrap(),
            textures,
        }
    }
}

/// Returns a path's last part, for messages.
fn file_name(path: &Path) -> String {
    path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned()
}
