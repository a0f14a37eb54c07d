//! Runtime of the translated shaders: the translator's library, textures, a missing function, and
//! conversions that are compiled into their callers.

pub use naga_rust_rt::*;

use relief_core::area_mean::coarser_size;
use relief_core::encoding::half;
use relief_core::{BakedMap, HeightMap, LevelPlace, MapTexels, TexelMask};
use texture::Read;

/// A height map as a texture: one number a texel, row by row from the top.
#[derive(Clone, Copy, Debug)]
pub struct HeightTexture<'a> {
    width: i32,
    texels: &'a [f32],
    coarser: &'a [HeightMap],
}

/// Holes as a texture: 1 in texels that are holes.
#[derive(Clone, Copy, Debug)]
pub struct HoleTexture<'a>(Option<&'a TexelMask>);

/// A colour or normal map as a texture: four numbers a texel, row by row from the top, in one layer.
#[derive(Clone, Copy, Debug)]
pub struct ColorTexture<'a> {
    size: [u32; 2],
    /// Layers of the levels after the finest.
    layers: usize,
    texels: &'a [[f32; 4]],
    /// The levels that follow, one after the other.
    coarser: &'a [[f32; 4]],
}

/// A baked map as a texture.
#[derive(Clone, Copy, Debug)]
pub struct MapTexture<'a> {
    pub(super) texels: Texels<'a>,
    pub(super) width: isize,
    pub(super) layers: usize,
    pub(super) places: &'a [LevelPlace],
}

/// Texels by their channels and format.
#[derive(Clone, Copy, Debug)]
pub(super) enum Texels<'a> {
    One(&'a [f32]),
    Two(&'a [[f32; 2]]),
    Four(&'a [[f32; 4]]),
    Half { values: &'a [u16], channels: usize },
    Codes { values: &'a [u8], channels: usize },
}

impl<'a> MapTexture<'a> {
    /// Returns the texture of a map; without one, a texture without texels.
    pub fn new(map: Option<&'a BakedMap>) -> Self {
        let Some(map) = map else {
            return Self { texels: Texels::One(&[]), width: 0, layers: 0, places: &[] };
        };
        let channels = map.layout().channels as usize;
        let texels = match map.texels() {
            MapTexels::F32(values) => match channels {
                1 => Texels::One(values),
                2 => Texels::Two(values.as_chunks().0),
                _ => Texels::Four(values.as_chunks().0),
            },
            MapTexels::F16(values) => Texels::Half { values, channels },
            MapTexels::Unorm8(values) => Texels::Codes { values, channels },
        };
        let width = map.layout().size[0] as isize;
        Self { texels, width, layers: map.layout().layers as usize, places: map.places() }
    }

    /// Whether the place of each byte, and of each number, fits into a signed number of 32 bits.
    #[cfg(all(
        feature = "lanes",
        any(target_arch = "aarch64", target_arch = "wasm32", target_arch = "x86_64")
    ))]
    fn has_places_of_32_bits(&self) -> bool {
        let count = match self.texels {
            Texels::One(texels) => texels.len(),
            Texels::Two(texels) => 2 * texels.len(),
            Texels::Four(texels) => 4 * texels.len(),
            Texels::Half { values, .. } => size_of_val(values),
            Texels::Codes { values, .. } => values.len(),
        };
        i32::try_from(count).is_ok()
    }

    /// The number of a texel among all; a number beyond all if there is no such texel.
    #[inline(always)]
    fn place(&self, at: Vec2<i32>, layer: i32, level: i32) -> usize {
        if layer | level == 0 {
            // The shaders wrap before they read, so that all places are inside the finest level.
            return (at.y as isize * self.width + at.x as isize) as usize;
        }
        let inside = || {
            let place = self.places.get(usize::try_from(level).ok()?)?;
            let layer = usize::try_from(layer).ok().filter(|layer| *layer < self.layers)?;
            let column = usize::try_from(at.x).ok().filter(|column| *column < place.width)?;
            let row = usize::try_from(at.y).ok().filter(|row| *row < place.height)?;
            Some(place.start + (layer * place.height + row) * place.width + column)
        };
        inside().unwrap_or(usize::MAX)
    }
}

/// The texels from one on.
#[inline(always)]
fn from(texels: &[[f32; 4]], first: usize) -> &[[f32; 4]] {
    texels.get(first..).unwrap_or_default()
}

#[cfg(all(feature = "lanes", any(target_arch = "aarch64", target_arch = "wasm32", target_arch = "x86_64")))]
impl super::generated::Resources<'_> {
    /// Whether the place of each number and each byte of all maps fits into a signed number of 32 bits.
    pub(super) fn has_places_of_32_bits(&self) -> bool {
        let maps = [
            &self.search_map,
            &self.shadow_search_map,
            &self.shadow_texels,
            &self.ambient_map,
            &self.detail_map,
            &self.environment_map,
        ];
        let colors = [&self.color_map, &self.normal_map, &self.material_map];
        maps.iter().all(|map| map.has_places_of_32_bits())
            && colors.iter().all(|map| map.has_places_of_32_bits())
    }
}

/// The channels of a texel that is not stored in 32-bit floats; missing channels are as on GPUs.
#[inline(always)]
fn channels<T: Copy>(values: &[T], channels: usize, at: usize, value: impl Fn(T) -> f32) -> [f32; 4] {
    let mut texel = [0.0, 0.0, 0.0, 1.0];
    let start = at.saturating_mul(channels);
    if let Some(values) = values.get(start..start.saturating_add(channels)) {
        for (channel, stored) in texel.iter_mut().zip(values) {
            *channel = value(*stored);
        }
    }
    texel
}

impl<'a> HeightTexture<'a> {
    /// Returns the texture of a map, with its coarser levels if `levels` is more than one.
    pub fn new(map: &'a HeightMap, levels: u32) -> Self {
        let coarser = if levels > 1 { map.coarser() } else { &[] };
        Self { width: map.width() as i32, texels: map.texels(), coarser }
    }

    /// Returns columns and texels of a level; none if there is no such level.
    #[inline(always)]
    pub(super) fn level(&self, level: i32) -> (i32, &'a [f32]) {
        match level {
            0 => (self.width, self.texels),
            _ => match self.coarser.get((level as usize).wrapping_sub(1)) {
                Some(map) => (map.width() as i32, map.texels()),
                None => (0, &[][..]),
            },
        }
    }
}

impl<'a> HoleTexture<'a> {
    /// Returns the texture of the holes of a map; without holes, a texture without texels.
    pub fn new(holes: Option<&'a TexelMask>) -> Self {
        Self(holes)
    }
}

impl<'a> ColorTexture<'a> {
    /// A single black texel, for a map that the settings turn off.
    pub const BLANK: Self = Self { size: [1, 1], layers: 1, texels: &[[0.0; 4]], coarser: &[] };

    /// Returns a texture of `size` columns and rows and of `layers` layers. If the finest level
    /// holds fewer layers, the others are not read. `coarser` holds the following levels, one after
    /// the other, each with half the sides of the one before, rounded down but at least 1.
    pub fn new(size: [u32; 2], layers: usize, texels: &'a [[f32; 4]], coarser: &'a [[f32; 4]]) -> Self {
        Self { size, layers, texels, coarser }
    }

    /// Returns columns and texels of a layer of a level.
    #[inline(always)]
    pub(super) fn layer(&self, layer: i32, level: i32) -> (i32, &'a [[f32; 4]]) {
        let [width, height] = self.size;
        match level {
            0 => (width as i32, from(self.texels, layer as usize * height as usize * width as usize)),
            _ => self.coarser_layer(layer, level),
        }
    }

    /// Columns and texels of a layer of a level after the finest.
    fn coarser_layer(&self, layer: i32, level: i32) -> (i32, &'a [[f32; 4]]) {
        let area = |[width, height]: [u32; 2]| width as usize * height as usize;
        let (mut size, mut start) = (coarser_size(self.size), 0);
        for _ in 1..level {
            start += area(size) * self.layers;
            size = coarser_size(size);
        }
        start += area(size) * layer as usize;
        (size[0] as i32, from(self.coarser, start))
    }

    /// Whether the place of each number fits into a signed number of 32 bits.
    #[cfg(all(
        feature = "lanes",
        any(target_arch = "aarch64", target_arch = "wasm32", target_arch = "x86_64")
    ))]
    fn has_places_of_32_bits(&self) -> bool {
        let count = |texels: &[[f32; 4]]| i32::try_from(texels.as_flattened().len());
        count(self.texels).is_ok() && count(self.coarser).is_ok()
    }
}

/// A read outside the map gives 0, one of the results that WGSL allows; the shaders wrap before they read.
impl Read for HeightTexture<'_> {
    type Coordinates = Vec2<i32>;
    type Component = f32;

    #[inline(always)]
    fn read_texel(&self, at: Vec2<i32>, _layer: i32, _sample: i32, level: i32) -> Vec4<f32> {
        let (width, texels) = self.level(level);
        let index = at.y as isize * width as isize + at.x as isize;
        let texel = texels.get(index as usize).copied().unwrap_or(0.0);
        Vec4 { x: texel, y: 0.0, z: 0.0, w: 1.0 }
    }
}

impl Read for HoleTexture<'_> {
    type Coordinates = Vec2<i32>;
    type Component = f32;

    #[inline(always)]
    fn read_texel(&self, at: Vec2<i32>, _layer: i32, _sample: i32, _level: i32) -> Vec4<f32> {
        let is_in = |holes: &TexelMask| {
            u32::try_from(at.x).is_ok_and(|x| u32::try_from(at.y).is_ok_and(|y| holes.contains(x, y)))
        };
        Vec4 { x: if self.0.is_some_and(is_in) { 1.0 } else { 0.0 }, y: 0.0, z: 0.0, w: 1.0 }
    }
}

impl Read for ColorTexture<'_> {
    type Coordinates = Vec2<i32>;
    type Component = f32;

    #[inline(always)]
    fn read_texel(&self, at: Vec2<i32>, layer: i32, _sample: i32, level: i32) -> Vec4<f32> {
        let (width, texels) = self.layer(layer, level);
        let index = at.y as isize * width as isize + at.x as isize;
        let [x, y, z, w] = texels.get(index as usize).copied().unwrap_or([0.0; 4]);
        Vec4 { x, y, z, w }
    }
}

impl Read for MapTexture<'_> {
    type Coordinates = Vec2<i32>;
    type Component = f32;

    #[inline(always)]
    fn read_texel(&self, at: Vec2<i32>, layer: i32, _sample: i32, level: i32) -> Vec4<f32> {
        let at = self.place(at, layer, level);
        let [x, y, z, w] = match self.texels {
            Texels::One(texels) => [texels.get(at).copied().unwrap_or(0.0), 0.0, 0.0, 1.0],
            Texels::Two(texels) => {
                let [x, y] = texels.get(at).copied().unwrap_or([0.0; 2]);
                [x, y, 0.0, 1.0]
            }
            Texels::Four(texels) => texels.get(at).copied().unwrap_or([0.0; 4]),
            Texels::Half { values, channels: count } => channels(values, count, at, half::value),
            // Codes as a GPU gives them; the shader decodes them.
            Texels::Codes { values, channels: count } => {
                channels(values, count, at, |code| f32::from(code) / 255.0)
            }
        };
        Vec4 { x, y, z, w }
    }
}

/// The square root, correctly rounded as on GPUs that the project is tested on.
pub(crate) trait SquareRoot {
    fn sqrt(self) -> Self;
}

impl SquareRoot for Scalar<f32> {
    #[inline(always)]
    fn sqrt(self) -> Self {
        Scalar(self.0.sqrt())
    }
}

/// A number that converts to other types like `as`.
pub(crate) trait Number: Copy {
    fn as_f32(self) -> f32;
    fn as_i32(self) -> i32;
    fn as_u32(self) -> u32;
}

macro_rules! number {
    ($own:ty $(, $by:ty)?) => {
        impl Number for $own {
            #[inline(always)]
            fn as_f32(self) -> f32 {
                self $(as $by)? as f32
            }

            #[inline(always)]
            fn as_i32(self) -> i32 {
                self $(as $by)? as i32
            }

            #[inline(always)]
            fn as_u32(self) -> u32 {
                self $(as $by)? as u32
            }
        }
    };
}

number!(f32);
number!(i32);
number!(u32);
number!(bool, u8);

/// Numbers as another type. The library's own conversions are calls each time.
pub(crate) trait Convert {
    type With<T>;

    fn to_f32(self) -> Self::With<f32>;
    fn to_i32(self) -> Self::With<i32>;
    fn to_u32(self) -> Self::With<u32>;
}

macro_rules! convert {
    ($($numbers:ident),+) => {
        $(impl<N: Number> Convert for $numbers<N> {
            type With<T> = $numbers<T>;

            #[inline(always)]
            fn to_f32(self) -> $numbers<f32> {
                self.map(N::as_f32)
            }

            #[inline(always)]
            fn to_i32(self) -> $numbers<i32> {
                self.map(N::as_i32)
            }

            #[inline(always)]
            fn to_u32(self) -> $numbers<u32> {
                self.map(N::as_u32)
            }
        })+
    };
}

convert!(Scalar, Vec2, Vec3, Vec4);
