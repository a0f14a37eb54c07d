//! Between the shaders' structs and the core's.

use relief_core::{HeightMap, PathMetric, RayUse};

use super::runtime::Vec4;
use super::{Choice, ColorTexture, HeightTexture, Hit, Light, Path, Resources, Settings};
use crate::{MAX_LIGHTS, SearchMap, SearchMapError, Selection};

impl From<&Path> for relief_core::Path {
    /// The same path, in `f64`.
    fn from(path: &Path) -> Self {
        let [uu, uv, vv, scale_m] =
            [path.metric.x, path.metric.y, path.metric.z, path.metric.w].map(f64::from);
        Self {
            uv: [path.uv.x.into(), path.uv.y.into()],
            duv: [path.duv.x.into(), path.duv.y.into()],
            h: [path.h.x.into(), path.h.y.into(), path.h.z.into()],
            exit: path.exit.into(),
            base: path.base.into(),
            metric: PathMetric { uu, uv, vv, scale_m },
        }
    }
}

impl From<&relief_core::Path> for Path {
    /// The path rounded to `f32`, of a view ray over the finest level of detail.
    fn from(path: &relief_core::Path) -> Self {
        let metric = &path.metric;
        Self::new(
            path.uv.map(|x| x as f32),
            path.duv.map(|x| x as f32),
            path.h.map(|x| x as f32),
            path.exit as f32,
            path.base as f32,
            [metric.uu, metric.uv, metric.vv, metric.scale_m].map(|x| x as f32),
            RayUse::View as u32,
            0u32,
        )
    }
}

impl From<&Hit> for relief_core::Hit {
    fn from(hit: &Hit) -> Self {
        Self {
            found: hit.found == 1,
            exhausted: hit.exhausted == 1,
            uv: [hit.uv.x.into(), hit.uv.y.into()],
            height: hit.height.into(),
            t: hit.t.into(),
            reads: hit.reads,
        }
    }
}

impl From<&relief_core::Hit> for Hit {
    fn from(hit: &relief_core::Hit) -> Self {
        Self::new(
            u32::from(hit.found),
            u32::from(hit.exhausted),
            hit.uv.map(|x| x as f32),
            hit.height as f32,
            hit.t as f32,
            hit.reads,
        )
    }
}

impl From<&crate::Choice> for Choice {
    fn from(choice: &crate::Choice) -> Self {
        Self::new(choice.number, choice.params)
    }
}

impl Settings {
    /// Settings for tracing a map with the stages chosen: no camera, no light, no maps but heights.
    pub fn tracing(map: &HeightMap, selection: &Selection) -> Self {
        let nowhere = || Vec4::splat(0.0);
        Self {
            choices: selection.choices.map(|choice| Choice::from(&choice)),
            eye: nowhere(),
            forward: nowhere(),
            corner: nowhere(),
            right: nowhere(),
            down: nowhere(),
            ambient: nowhere(),
            diffuse: nowhere(),
            specular: nowhere(),
            lights: [Light { place: nowhere(), color: nowhere() }; MAX_LIGHTS],
            height_size: [map.width(), map.height()].into(),
            color_size: [1, 1].into(),
            normal_size: [1, 1].into(),
            wrap: map.wrap() as u32,
            light_count: 0,
            shininess: 1,
            has_color: 0,
            has_normal: 0,
            scale_m: map.scale_m() as f32,
            bias_m: map.bias_m() as f32,
        }
    }
}

impl<'a> Resources<'a> {
    /// What the stages are called on to trace a map: see [`Settings::tracing`]. A search that reads a baked map needs it.
    ///
    /// # Errors
    ///
    /// When the search's map is missing or does not fit the height map.
    pub fn tracing(
        map: &'a HeightMap,
        selection: &Selection,
        search_map: Option<&'a SearchMap>,
    ) -> Result<Self, SearchMapError> {
        const BLANK: &[[f32; 4]] = &[[0.0; 4]];
        let blank = ColorTexture::new(1, BLANK);
        let search_map = selection.map_among(search_map, map)?;
        Ok(Self {
            color_map: blank,
            height_map: HeightTexture::new(map.width(), map.texels()),
            normal_map: blank,
            search_map: search_map.map_or(blank, |map| ColorTexture::new(map.size()[0], map.texels())),
            settings: Settings::tracing(map, selection),
        })
    }

    /// Search and refinement of one path.
    pub fn first_hit(&self, path: &relief_core::Path) -> relief_core::Hit {
        relief_core::Hit::from(&self.trace(Path::from(path)))
    }
}
