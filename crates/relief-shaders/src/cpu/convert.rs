//! Conversions between the shaders' structs and the core's.

use relief_core::object::JumpCells;
use relief_core::{BakedMap, Cost, HeightMap, MapFormat, PathMetric, RayUse, SliceLayout};

use super::{
    Bound, Choice, ColorTexture, Frame, HeightTexture, Hit, HoleTexture, Light, LightView, MapSettings,
    MapTexture, Path, Shell, SurfaceSettings, Vec2, Vec4,
};
use crate::{MAX_LIGHT_VIEWS, MAX_LIGHTS, MapSlot, Selection, SlotMaps};

impl From<&Path> for relief_core::Path {
    /// Converts the path to `f64`.
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
    /// Rounds the path to `f32`, as a view ray over the finest level of detail.
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
            0.0,
            1.0,
            0.0,
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
            cost: Cost { reads: hit.cost.x, steps: hit.cost.y, bytes: hit.cost.z },
        }
    }
}

impl From<&relief_core::Hit> for Hit {
    fn from(hit: &relief_core::Hit) -> Self {
        let Cost { reads, steps, bytes } = hit.cost;
        Self::new(
            u32::from(hit.found),
            u32::from(hit.exhausted),
            hit.uv.map(|x| x as f32),
            hit.height as f32,
            hit.t as f32,
            [reads, steps, bytes],
        )
    }
}

impl Shell {
    /// Returns a shell with heights from 0 to 1 and corners in the order of the triangle, for a
    /// shell without other data.
    pub fn whole() -> Self {
        Self::between([0.0, 1.0], [0, 1, 2], [0.0; 3])
    }

    /// Returns a shell between two heights, least and greatest, from 0 to 1. `places` is the order
    /// of its corners, from [`places_of`](Self::places_of). `lift` has the coefficients of a smooth
    /// base in metres, in the same order.
    pub fn between(heights: [f32; 2], places: [u32; 3], lift: [f32; 3]) -> Self {
        Self::new(heights, places[0] | (places[1] << 2) | (places[2] << 4), lift)
    }

    /// Returns the offsets along the normals, in metres, between which the relief lies. The heights
    /// 0 and 1 lie at `bottom` and `top`, in metres.
    pub fn offsets_m(&self, [bottom, top]: [f32; 2]) -> [f32; 2] {
        let lifts = [self.lift.x, self.lift.y, self.lift.z];
        // The product of two weights is at most a quarter.
        let lifted = |side: fn(f32, f32) -> f32| lifts.map(|lift| side(lift, 0.0) / 4.0).iter().sum::<f32>();
        let at = |height: f32| bottom + (top - bottom) * height;
        [at(self.heights.x) + lifted(f32::min), at(self.heights.y) + lifted(f32::max)]
    }

    /// Returns the shell with the mark that it overlaps itself.
    #[must_use]
    pub fn folded(self) -> Self {
        Self { order: self.order | crate::surface::FOLDED, ..self }
    }

    /// Returns the order of a triangle's corners by rising `numbers`. The first result is the
    /// corner with the lowest number, from 0 to 2; the last is the corner with the highest.
    ///
    /// `numbers` are the corners' vertices in the welded mesh. All triangles then agree on the
    /// order of the ends of a shared side.
    pub fn places_of(numbers: [u32; 3]) -> [u32; 3] {
        let mut places = [0u32, 1, 2];
        places.sort_by_key(|place| numbers[*place as usize]);
        places
    }
}

impl From<&crate::Choice> for Choice {
    fn from(choice: &crate::Choice) -> Self {
        let [x, y, z, w, ..] = choice.params;
        Self::new(choice.number, [x, y, z, w])
    }
}

impl From<Option<&BakedMap>> for MapSettings {
    /// Settings of a map; without one, settings of no map.
    fn from(map: Option<&BakedMap>) -> Self {
        let Some(map) = map else {
            return Self::new(0u32, 0u32, 0u32, 0u32, [0.0; 4], [0.0; 4], [1.0; 2]);
        };
        let layout = map.layout();
        let coded = u32::from(layout.format == MapFormat::Unorm8);
        let texel_bytes = layout.channels * layout.format.bytes() as u32;
        let codes = map.codes();
        let identity = map.identity();
        let tile_m = identity.metric.tile_m.map(|length| length as f32);
        let [low, step] = [codes.map(|codes| codes.low), codes.map(|codes| codes.step)];
        Self::new(coded, layout.layers, texel_bytes, identity.height_level, low, step, tile_m)
    }
}

impl SlotMaps<'_> {
    /// Returns the settings of the maps, in the order of the slots.
    pub fn settings(&self) -> [MapSettings; MapSlot::ALL.len()] {
        MapSlot::ALL.map(|slot| MapSettings::from(self.get(slot)))
    }
}

/// The least thickness of shells, in metres, if nothing is known of the mesh.
const LEAST_SHELL_M: f32 = 1e-9;

/// The metres along the normals at which heights 0 and 1 lie in shells with at least that
/// thickness, in metres.
fn shell_m(map: &HeightMap, least_m: f32) -> Vec2<f32> {
    let (low, scale) = (map.bias_m() as f32, map.scale_m() as f32);
    [low, low + scale.max(least_m)].into()
}

impl SurfaceSettings {
    /// Returns the settings with shells of at least that thickness, in metres. Where the relief is
    /// thinner than a hundred-thousandth of the mesh, `f32` cannot separate the lower from the
    /// upper side.
    #[must_use]
    pub fn with_least_shell(self, map: &HeightMap, least_m: f32) -> Self {
        Self { shell_m: shell_m(map, least_m), ..self }
    }

    /// Returns the settings with the parameters of another selection of the same variants.
    #[must_use]
    pub fn with_choices_of(self, selection: &Selection) -> Self {
        Self { choices: selection.choices.map(|choice| Choice::from(&choice)), ..self }
    }

    /// Returns settings for tracing a map by a selection with the baked maps that it reads, without
    /// colours.
    pub fn tracing(map: &HeightMap, selection: &Selection, maps: &SlotMaps) -> Self {
        let surroundings = maps.get(MapSlot::Environment).map(BakedMap::layout);
        let [environment_side, environment_levels] =
            surroundings.map_or([1, 1], |layout| [layout.size[0], layout.levels]);
        Self {
            choices: selection.choices.map(|choice| Choice::from(&choice)),
            maps: maps.settings(),
            diffuse: Vec4::splat(0.0),
            specular: Vec4::splat(0.0),
            emission: Vec4::splat(0.0),
            height_size: [map.width(), map.height()].into(),
            color_size: [1, 1].into(),
            normal_size: [1, 1].into(),
            material_size: [1, 1].into(),
            height_levels: selection.levels_of(map),
            color_levels: 1,
            normal_levels: 1,
            material_levels: 1,
            color_texels: 1.0,
            normal_texels: 1.0,
            material_texels: 1.0,
            normal_tile_m: [1.0, 1.0].into(),
            wrap: map.wrap() as u32,
            color_u: Vec4::new(1.0, 0.0, 0.0, 0.0),
            color_v: Vec4::new(0.0, 1.0, 0.0, 0.0),
            color_wrap_u: map.wrap() as u32,
            color_wrap_v: map.wrap() as u32,
            shininess: 1,
            roughness: 1.0,
            metallic: 0.0,
            has_material: 0,
            has_color: 0,
            has_normal: 0,
            has_holes: 0,
            has_creases: 0,
            has_vertex_normals: u32::from(!selection.has_normals_of_relief() || selection.blends_normals()),
            has_shadows: u32::from(selection.has_shadows()),
            scale_m: map.scale_m() as f32,
            bias_m: map.bias_m() as f32,
            shell_m: shell_m(map, LEAST_SHELL_M),
            mean_height: if selection.has_levels() { map.mean() } else { 0.0 },
            transmission: 0.0,
            ior: 1.0,
            number: 0,
            environment_side,
            environment_levels,
            images: 0,
            solids: 0,
            cells: JumpCells::Bilinear as u32,
            jump: 0.0,
            volume: [0; 4].into(),
            cutoff: 0.0,
            translucent: [0; 2].into(),
        }
    }

    /// Returns the settings for a volume whose slices lie side by side in the height map.
    #[must_use]
    pub fn with_volume(self, layout: SliceLayout) -> Self {
        let [width, height, slices] = layout.size();
        let volume = [width, height, slices, layout.slices_in_a_row()].into();
        Self { volume, height_size: [width, height].into(), ..self }
    }
}

impl Frame {
    /// The difference in direction between rays of neighbouring pixels without a camera.
    pub const BESIDE: f32 = 0.0625;

    /// Returns a frame without a camera and without lights. Rays of neighbouring pixels differ by
    /// [`BESIDE`](Self::BESIDE) in direction.
    pub fn none() -> Self {
        let nowhere = || Vec4::splat(0.0);
        Self {
            view_projection: [nowhere(); 4],
            eye: nowhere(),
            eye_right: nowhere(),
            eye_down: nowhere(),
            forward: nowhere(),
            corner: nowhere(),
            right: [Self::BESIDE, 0.0, 0.0, 0.0].into(),
            down: [0.0, 0.0, Self::BESIDE, 0.0].into(),
            ambient: nowhere(),
            sample_width: 1.0,
            near: 1.0,
            clip: nowhere(),
            background: nowhere(),
            background_below: nowhere(),
            lights: [Light { place: nowhere(), color: nowhere(), first_view: 0, views: 0 }; MAX_LIGHTS],
            light_count: 0,
            light_views: [LightView::none(); MAX_LIGHT_VIEWS],
        }
    }
}

impl LightView {
    /// Returns the camera of a shadow map that sees nothing.
    pub fn none() -> Self {
        let nowhere = || Vec4::splat(0.0);
        Self {
            column: nowhere(),
            row: nowhere(),
            depth: nowhere(),
            corner: nowhere(),
            across: nowhere(),
            along: nowhere(),
            eye: nowhere(),
            near: 1.0,
            texel_m: 0.0,
            from_point: 0,
            size: 0,
        }
    }
}

impl<'a> Bound<'a> {
    /// A frame without a surface, for functions that read no height map. `level` is bound in its
    /// place.
    pub(super) fn of_nothing(frame: Frame, level: &'a HeightMap, maps: SlotMaps<'a>) -> Self {
        Self {
            frame,
            surface_settings: SurfaceSettings::tracing(level, &Selection::default(), &maps),
            height_map: HeightTexture::new(level, 1),
            hole_map: HoleTexture::new(None),
            color_map: ColorTexture::BLANK,
            normal_map: ColorTexture::BLANK,
            material_map: ColorTexture::BLANK,
            maps,
        }
    }

    /// Returns the texture of a slot.
    pub(super) fn slot(&self, slot: MapSlot) -> MapTexture<'a> {
        MapTexture::new(self.maps.get(slot))
    }
}
