//! A scene made ready for a backend: what the shaders bind, and nothing else.

use relief_core::HeightMap;
use relief_shaders::cpu::{ColorTexture, HeightTexture, PixelOut, Resources, Settings, Triangle};

/// A map of four numbers a texel, row by row from the top: linear colour, normals in tangent space, or a baked map.
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
    /// The baked map that the search of the settings reads, if it reads one: of the height map's size.
    pub search_map: Option<TexelMap<'a>>,
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

    /// The search's map, or a single texel.
    pub fn search_map_or_blank(&self) -> TexelMap<'a> {
        self.search_map.unwrap_or(TexelMap { width: 1, height: 1, texels: BLANK })
    }

    /// What the translated shaders are called on.
    pub fn resources(&self) -> Resources<'a> {
        let texture = |map: TexelMap<'a>| ColorTexture::new(map.width, map.texels);
        Resources {
            color_map: texture(self.color_map_or_blank()),
            height_map: HeightTexture::new(self.height_map.width(), self.height_map.texels()),
            normal_map: texture(self.normal_map_or_blank()),
            search_map: texture(self.search_map_or_blank()),
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
