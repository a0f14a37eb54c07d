//! A scene made ready for a backend: what the shaders bind, and nothing else.

use std::sync::Arc;

use relief_core::{BakedMap, HeightMap, TexelMask};
use relief_shaders::cpu::{
    Bound, ColorTexture, Frame, HeightTexture, HoleTexture, PixelOut, Program, SurfaceSettings,
};
use relief_shaders::{MapSlot, Selection, SlotMaps};

pub use crate::light_views::LightViews;
use crate::mipmaps::Mipmaps;
pub use crate::prepare::Triangles;

/// What both backends are given. The same job gives the same picture on either.
#[derive(Clone, Debug)]
pub struct Job {
    /// Columns of the picture.
    pub width: u32,
    /// Rows of the picture.
    pub height: u32,
    /// Samples of a pixel's colour, at least 1.
    pub samples: u32,
    /// What changes with the frame.
    pub frame: Frame,
    /// What lights see, where shadows are looked up there: the frame knows these views.
    pub light_views: LightViews,
    /// The surfaces. Of several the nearest is seen; of equally near ones the first.
    pub surfaces: Vec<JobSurface>,
}

/// A surface of a job. Renderers keep what they have made of its parts as long as they are given the same
/// ones again: the same by their address.
#[derive(Clone, Debug)]
pub struct JobSurface {
    /// What is the same for all of its pixels.
    pub settings: SurfaceSettings,
    /// What is run.
    pub selection: Selection,
    /// The base mesh, in the world.
    pub triangles: Arc<Triangles>,
    /// The height map.
    pub height_map: Arc<HeightMap>,
    /// The colour map, if any.
    pub color: Option<Arc<Mipmaps>>,
    /// The normal map, if any; or where there is none, normals derived from the height map's second level on,
    /// if these are read.
    pub normal_map: Option<Arc<Mipmaps>>,
    /// The baked maps that the selection reads, and the surroundings where they are seen. A GPU renderer
    /// builds a pyramid of the heights itself where it is not among them.
    pub maps: Vec<(MapSlot, Arc<BakedMap>)>,
    /// Whether back faces are rendered, turned over.
    pub two_sided: bool,
}

/// Parts of the settings' `has_holes`: holes of the height map, and holes by the colour map's opacity.
pub(crate) const HOLES_OF_HEIGHTS: u32 = 1;
pub(crate) const HOLES_OF_COLORS: u32 = 2;

impl JobSurface {
    /// The baked maps in their slots.
    pub fn slots(&self) -> SlotMaps<'_> {
        self.maps.iter().map(|(slot, map)| (*slot, &**map)).collect()
    }

    /// The holes of the height map, where they are to be seen.
    pub fn holes(&self) -> Option<&Arc<TexelMask>> {
        self.height_map.holes().filter(|_| self.settings.has_holes & HOLES_OF_HEIGHTS != 0)
    }

    /// Whether lights see the same of it as of another one.
    pub(crate) fn looks_same_to_lights(&self, other: &Self) -> bool {
        let colors = [self, other].map(|of| of.color.as_ref().map(Arc::as_ptr));
        let is_masked = self.settings.has_holes & HOLES_OF_COLORS != 0;
        (!is_masked || colors[0] == colors[1])
            && Arc::ptr_eq(&self.triangles, &other.triangles)
            && Arc::ptr_eq(&self.height_map, &other.height_map)
            && self.maps.len() == other.maps.len()
            && self.maps.iter().zip(&other.maps).all(|(a, b)| a.0 == b.0 && Arc::ptr_eq(&a.1, &b.1))
            && (self.settings, self.two_sided) == (other.settings, other.two_sided)
    }

    /// The translated shaders over this surface in a frame, with what lights see in its views where it looks
    /// up shadows there.
    pub fn program<'a>(&'a self, frame: Frame, light_map: Option<&'a BakedMap>) -> Program<'a> {
        self.program_with(self.settings, frame, light_map)
    }

    /// The same with other settings.
    pub(crate) fn program_with<'a>(
        &'a self,
        settings: SurfaceSettings,
        frame: Frame,
        light_map: Option<&'a BakedMap>,
    ) -> Program<'a> {
        Program::new(&self.bound(settings, frame, light_map))
    }

    /// What the translated shaders are given.
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
            maps: self.maps.iter().map(|(slot, map)| (*slot, &**map)).chain(lights).collect(),
        }
    }
}

fn of_levels(levels: &Mipmaps) -> ColorTexture<'_> {
    ColorTexture::new(levels.size(), levels.layers(), levels.finest(), levels.coarser())
}

/// The result of a job: every pixel, row by row from the top.
///
/// A pixel's colour is the mean of its samples in linear light, black where they show no surface; its fourth
/// part is the part of them that do. All other numbers belong to the pixel's centre: where that shows no
/// surface, `hit` is 0 and they are zeros.
#[derive(Clone, Debug, PartialEq)]
pub struct Rendering {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// `width * height` pixels.
    pub pixels: Vec<PixelOut>,
}

/// A pixel that nothing covers.
pub fn uncovered() -> PixelOut {
    PixelOut::new(
        [0.0; 4], 0u32, 0u32, [0.0; 2], 0.0, [0.0; 3], [0.0; 3], 0.0, 0.0, [0; 2], 0u32, 0u32, 0u32, 0.0,
        0u32, 0.0, 0u32,
    )
}
