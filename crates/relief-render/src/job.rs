//! A scene made ready for a backend: what the shaders bind, and nothing else.

use relief_core::HeightMap;
use relief_shaders::cpu::{ColorTexture, HeightTexture, MapTexture, PixelOut, Resources, Settings, Triangle};
use relief_shaders::{MapSlot, SlotMaps};

/// A map of four numbers a texel, row by row from the top: linear colour, or normals in tangent space.
#[derive(Clone, Copy, Debug)]
pub struct TexelMap<'a> {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// `width * height` texels.
    pub texels: &'a [[f32; 4]],
}

/// What both backends are given. The same job gives the same picture on either.
pub struct Job<'a> {
    /// Columns of the picture.
    pub width: u32,
    /// Rows of the picture.
    pub height: u32,
    /// What is the same for all pixels.
    pub settings: Settings,
    /// The base mesh, in the world.
    pub triangles: &'a [Triangle],
    /// World to clip space, `z` from 0 to 1, column by column.
    pub view_projection: [[f32; 4]; 4],
    /// The height map.
    pub height_map: &'a HeightMap,
    /// The colour map, if any.
    pub color_map: Option<TexelMap<'a>>,
    /// The normal map, if any.
    pub normal_map: Option<TexelMap<'a>>,
    /// The baked maps that the stages of the settings read.
    pub maps: SlotMaps<'a>,
    /// Whether back faces are rendered, turned over.
    pub two_sided: bool,
}

/// What stands in for a map that a job lacks; the settings say that it is not to be read.
const BLANK: &[[f32; 4]] = &[[0.0; 4]];

impl<'a> Job<'a> {
    /// The colour map, or a single texel.
    pub fn color_map_or_blank(&self) -> TexelMap<'a> {
        self.color_map.unwrap_or(TexelMap { width: 1, height: 1, texels: BLANK })
    }

    /// The normal map, or a single texel.
    pub fn normal_map_or_blank(&self) -> TexelMap<'a> {
        self.normal_map.unwrap_or(TexelMap { width: 1, height: 1, texels: BLANK })
    }

    /// What the translated shaders are called on.
    pub fn resources(&self) -> Resources<'a> {
        let texture = |map: TexelMap<'a>| ColorTexture::new(map.width, map.texels);
        let baked = |slot| MapTexture::new(self.maps.get(slot));
        Resources {
            color_map: texture(self.color_map_or_blank()),
            height_map: HeightTexture::new(self.height_map.width(), self.height_map.texels()),
            normal_map: texture(self.normal_map_or_blank()),
            search_map: baked(MapSlot::Search),
            shadow_search_map: baked(MapSlot::ShadowSearch),
            shadow_texels: baked(MapSlot::Shadow),
            ambient_map: baked(MapSlot::Ambient),
            environment_map: baked(MapSlot::Environment),
            settings: self.settings,
        }
    }
}

/// The result of a job: every pixel, row by row from the top. A pixel that nothing covers has `hit` 0 and zeros.
#[derive(Clone, Debug, PartialEq)]
pub struct Rendering {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// `width * height` pixels.
    pub pixels: Vec<PixelOut>,
}
