//! Scenes prepared for a backend: the data that the shaders bind, and nothing else.

use std::sync::Arc;

use relief_core::{BakedMap, HeightMap, TexelMask};
use relief_shaders::cpu::{
    Bound, ColorTexture, Frame, HeightTexture, HoleTexture, PixelOut, Program, SurfaceSettings,
};
use relief_shaders::{MapSlot, Selection, SlotMaps};

pub use crate::light_views::LightViews;
use crate::mipmaps::Mipmaps;
pub use crate::prepare::Triangles;

/// Input of both backends. The same job gives the same picture on either.
#[derive(Clone, Debug)]
pub struct Job {
    /// Columns of the picture.
    pub width: u32,
    /// Rows of the picture.
    pub height: u32,
    /// Samples of a pixel's colour, at least 1.
    pub samples: u32,
    /// Data that changes with the frame: camera, lights and background.
    pub frame: Frame,
    /// Views of the shadow maps, which `frame` lists too. Empty where no surface reads shadow maps.
    pub light_views: LightViews,
    /// The surfaces. Each pixel shows the nearest one; ties go to the first.
    pub surfaces: Vec<JobSurface>,
}

/// A surface of a job. Renderers cache what they make from its parts as long as they get the same
/// parts again, by address.
#[derive(Clone, Debug)]
pub struct JobSurface {
    /// Settings, the same for all pixels of the surface.
    pub settings: SurfaceSettings,
    /// Variant and settings of each stage.
    pub selection: Selection,
    /// Triangles to draw, in world space.
    pub triangles: Arc<Triangles>,
    /// The height map.
    pub height_map: Arc<HeightMap>,
    /// The colour map, if any.
    pub color: Option<Arc<Mipmaps>>,
    /// The normal map, if any. Without one, and if a stage reads them, normals derived from the
    /// height map, from its second level on.
    pub normal_map: Option<Arc<Mipmaps>>,
    /// Maps of the material, if any are read: occlusion, roughness and metalness, then emission.
    pub material_maps: Option<Arc<Mipmaps>>,
    /// The baked maps that the selection reads, and the environment map if it is visible. A GPU
    /// renderer builds a missing pyramid of heights itself.
    pub maps: Vec<(MapSlot, Arc<BakedMap>)>,
    /// Whether back faces are rendered, with the surface turned over.
    pub two_sided: bool,
}

/// Flags of the settings' `has_holes`: holes of the height map, and holes by the colour map's
/// opacity.
pub(crate) const HOLES_OF_HEIGHTS: u32 = 1;
pub(crate) const HOLES_OF_COLORS: u32 = 2;

impl JobSurface {
    /// Returns the baked maps by slot.
    pub fn slots(&self) -> SlotMaps<'_> {
        self.maps.iter().map(|(slot, map)| (*slot, &**map)).collect()
    }

    /// Returns the holes of the height map, if they are visible.
    pub fn holes(&self) -> Option<&Arc<TexelMask>> {
        self.height_map.holes().filter(|_| self.settings.has_holes & HOLES_OF_HEIGHTS != 0)
    }

    /// Whether the surface casts the same shadows as `other`.
    pub(crate) fn casts_same_shadows(&self, other: &Self) -> bool {
        let colors = [self, other].map(|of| of.color.as_ref().map(Arc::as_ptr));
        let is_masked = self.settings.has_holes & HOLES_OF_COLORS != 0;
        (!is_masked || colors[0] == colors[1])
            && Arc::ptr_eq(&self.triangles, &other.triangles)
            && Arc::ptr_eq(&self.height_map, &other.height_map)
            && self.maps.len() == other.maps.len()
            && self.maps.iter().zip(&other.maps).all(|(a, b)| a.0 == b.0 && Arc::ptr_eq(&a.1, &b.1))
            && (self.settings, self.two_sided) == (other.settings, other.two_sided)
    }

    /// Returns the translated shaders over this surface in a frame. `light_map` holds the shadow
    /// maps, if the surface reads them.
    pub fn program<'a>(&'a self, frame: Frame, light_map: Option<&'a BakedMap>) -> Program<'a> {
        self.program_with(self.settings, frame, light_map)
    }

    /// Does the work of [`Self::program`] with other settings.
    pub(crate) fn program_with<'a>(
        &'a self,
        settings: SurfaceSettings,
        frame: Frame,
        light_map: Option<&'a BakedMap>,
    ) -> Program<'a> {
        Program::new(&self.bound(settings, frame, light_map))
    }

    /// Returns the data that the translated shaders bind.
    pub(crate) fn bound<'a>(
        &'a self,
        settings: SurfaceSettings,
        frame: Frame,
        light_map: Option<&'a BakedMap>,
    ) -> Bound<'a> {
        let color_map = self.color.as_deref().map_or(ColorTexture::BLANK, of_levels);
        let lights = light_map.map(|map| (MapSlot::Lights, map));
        let normal_map = self.normal_map.as_deref().map_or(ColorTexture::BLANK, of_levels);
        Bound {
            frame,
            surface_settings: settings,
            height_map: HeightTexture::new(&self.height_map, settings.height_levels),
            hole_map: HoleTexture::new(self.holes().map(Arc::as_ref)),
            color_map,
            normal_map,
            material_map: self.material_maps.as_deref().map_or(ColorTexture::BLANK, of_levels),
            maps: self.maps.iter().map(|(slot, map)| (*slot, &**map)).chain(lights).collect(),
        }
    }
}

fn of_levels(levels: &Mipmaps) -> ColorTexture<'_> {
    ColorTexture::new(levels.size(), levels.layers(), levels.finest(), levels.coarser())
}

/// Picture of a job: all pixels, row by row from the top.
///
/// A pixel's colour is the mean of its samples in linear light; samples that show no surface count
/// as black. The fourth channel is the share of samples that show a surface, from 0 to 1. All other
/// numbers belong to the pixel's centre. Where that shows no surface, `hit` is 0 and they are
/// zeros.
#[derive(Clone, Debug, PartialEq)]
pub struct Rendering {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// `width * height` pixels.
    pub pixels: Vec<PixelOut>,
}

/// Returns a pixel that no surface covers.
pub fn uncovered() -> PixelOut {
    PixelOut::new(
        [0.0; 4], 0u32, 0u32, [0.0; 2], 0.0, [0.0; 3], [0.0; 3], 0.0, 0.0, [0; 2], 0u32, 0u32, 0u32, 0.0,
        0u32, 0.0, 0u32, 1.0,
    )
}
