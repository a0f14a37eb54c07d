//! A baked map as a value: its identity, its shape and its texels.

use std::str::FromStr;

use crate::area_mean::level_count;
use crate::encoding::code::Codes;
use crate::registry::UnknownName;
use crate::{HeightMap, HeightsHash, MAX_SIDE, Metric, Wrap};

/// Most layers of a map: the number that every GPU supports.
pub const MAX_LAYERS: u32 = 256;

/// Number format of a map's values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum MapFormat {
    /// 32-bit floats: the values as they were baked.
    #[default]
    F32,
    /// 16-bit floats.
    F16,
    /// 8-bit codes: see [`Codes`].
    Unorm8,
}

impl FromStr for MapFormat {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        let named = |format: &&Self| format.name() == name;
        let unknown = || UnknownName::new("format", name, Self::ALL.map(Self::name));
        Self::ALL.iter().find(named).copied().ok_or_else(unknown)
    }
}

impl MapFormat {
    /// All formats, from the most bits to the fewest.
    pub const ALL: [MapFormat; 3] = [MapFormat::F32, MapFormat::F16, MapFormat::Unorm8];

    /// Name of the format in the files of baked maps.
    pub const fn name(self) -> &'static str {
        match self {
            MapFormat::F32 => "float",
            MapFormat::F16 => "half",
            MapFormat::Unorm8 => "unorm8",
        }
    }

    /// Bytes per value.
    pub const fn bytes(self) -> u64 {
        match self {
            MapFormat::F32 => 4,
            MapFormat::F16 => 2,
            MapFormat::Unorm8 => 1,
        }
    }
}

/// Shape of a map: texels of 1, 2 or 4 channels, in layers and mip levels.
///
/// Layers are the slices of a volume, azimuths, directions or the faces of a cube. Each level has
/// half the columns and rows of the previous one, rounded down, but at least one, as in GPU
/// textures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MapLayout {
    /// Columns and rows of the finest level.
    pub size: [u32; 2],
    /// Number of mip levels.
    pub levels: u32,
    /// Number of layers.
    pub layers: u32,
    /// Channels of a texel: 1, 2 or 4.
    pub channels: u32,
    /// Format of each value.
    pub format: MapFormat,
}

impl MapLayout {
    /// Columns and rows of a level.
    pub fn level_size(&self, level: u32) -> [u32; 2] {
        self.size.map(|side| side.checked_shr(level).unwrap_or(0).max(1))
    }

    /// Number of texels in all levels and layers.
    pub fn texels(&self) -> u64 {
        let of_level = |level| self.level_size(level).map(u64::from).iter().product::<u64>();
        (0..self.levels).map(of_level).sum::<u64>() * u64::from(self.layers)
    }

    /// Bytes of all levels and layers.
    pub fn bytes(&self) -> u64 {
        self.texels() * u64::from(self.channels) * self.format.bytes()
    }

    /// Checks that a map can have this shape.
    ///
    /// # Errors
    ///
    /// When a side, the layers or the levels are 0 or too many, or the channels are not 1, 2 or 4.
    pub fn check(&self) -> Result<(), MapLayoutError> {
        let longest = self.size[0].max(self.size[1]);
        let most_levels = if longest == 0 { 0 } else { level_count(self.size) };
        let fits = self.size.iter().all(|side| (1..=MAX_SIDE).contains(side))
            && (1..=most_levels).contains(&self.levels)
            && (1..=MAX_LAYERS).contains(&self.layers)
            && matches!(self.channels, 1 | 2 | 4);
        if fits { Ok(()) } else { Err(MapLayoutError::Impossible(*self)) }
    }
}

/// Why values do not make a map.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MapLayoutError {
    /// No map has that shape.
    #[error(
        "no map has {} x {} texels of {} channels in {} layers and {} levels: channels are 1, 2 or 4, layers \
         at most {MAX_LAYERS}",
        .0.size[0], .0.size[1], .0.channels, .0.layers, .0.levels
    )]
    Impossible(MapLayout),
    /// The number of values does not fit the layout.
    #[error("the map has {wanted} values, {given} were given")]
    Length {
        /// Values of the shape.
        wanted: u64,
        /// Values given.
        given: usize,
    },
    /// The values have another format than the layout.
    #[error("the map's values are of another format than its layout says")]
    Format,
}

/// Everything that determines the values of a baked map.
#[derive(Clone, Debug, PartialEq)]
pub struct MapIdentity {
    /// Name of the kind.
    pub kind: String,
    /// Revision of the kind. It is raised with every change to the values that the kind bakes.
    pub revision: u32,
    /// Name of the texture, for kinds with several; empty for the only one.
    pub texture: String,
    /// All settings of the kind.
    pub settings: Vec<(String, f32)>,
    /// Hash of the heights that the map is baked from.
    pub heights: HeightsHash,
    /// Wrap of these heights.
    pub wrap: Wrap,
    /// Metric in which the map is baked.
    pub metric: Metric,
    /// Level of the kind's texture that is stored as the map's finest level. Usually 0; higher if
    /// the finer levels repeat the heights themselves.
    pub first_level: u32,
    /// Mip level of the height map to which the map's finest level corresponds in place and size.
    /// It is above 0 for maps that are baked from a coarser level.
    pub height_level: u32,
}

impl MapIdentity {
    /// Identity of a map that is not made from heights. Heights, wrap and metric are placeholders.
    pub fn without_heights(kind: &str) -> Self {
        Self {
            kind: kind.to_owned(),
            revision: 1,
            texture: String::new(),
            settings: Vec::new(),
            heights: HeightsHash([0; 32]),
            wrap: Wrap::Clamp,
            metric: Metric::UNIT,
            first_level: 0,
            height_level: 0,
        }
    }
}

/// Values of a map. The order is: levels from the finest, layers, rows from the top, texels,
/// channels.
#[derive(Clone, Debug, PartialEq)]
pub enum MapTexels {
    /// 32-bit floats.
    F32(Vec<f32>),
    /// 16-bit floats, as their bits.
    F16(Vec<u16>),
    /// 8-bit codes; see [`Codes`].
    Unorm8(Vec<u8>),
}

impl MapTexels {
    fn len(&self) -> usize {
        match self {
            MapTexels::F32(values) => values.len(),
            MapTexels::F16(values) => values.len(),
            MapTexels::Unorm8(values) => values.len(),
        }
    }

    fn format(&self) -> MapFormat {
        match self {
            MapTexels::F32(_) => MapFormat::F32,
            MapTexels::F16(_) => MapFormat::F16,
            MapTexels::Unorm8(_) => MapFormat::Unorm8,
        }
    }
}

/// A map baked from a height map, to be read by shaders. The bake, the cache, the GPU and the CPU
/// shaders all use this type.
///
/// A guarantee of the map's kind holds for the stored values. Formats with fewer bits round to the
/// safe side.
#[derive(Clone, Debug, PartialEq)]
pub struct BakedMap {
    identity: MapIdentity,
    layout: MapLayout,
    codes: [Codes; 4],
    texels: MapTexels,
    places: Vec<LevelPlace>,
}

/// Position of one mip level among a map's texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LevelPlace {
    /// Index of the level's first texel.
    pub start: usize,
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
}

impl BakedMap {
    /// Creates a map. `codes` holds the meaning of the codes of each channel, if the texels are
    /// codes.
    ///
    /// # Errors
    ///
    /// When no map can have this shape, or the number or the format of the texels differs from it.
    pub fn new(
        identity: MapIdentity,
        layout: MapLayout,
        codes: [Codes; 4],
        texels: MapTexels,
    ) -> Result<Self, MapLayoutError> {
        layout.check()?;
        if texels.format() != layout.format {
            return Err(MapLayoutError::Format);
        }
        let wanted = layout.texels() * u64::from(layout.channels);
        if texels.len() as u64 != wanted {
            return Err(MapLayoutError::Length { wanted, given: texels.len() });
        }
        let mut start = 0;
        let places = (0..layout.levels).map(|level| {
            let [width, height] = layout.level_size(level).map(|side| side as usize);
            let place = LevelPlace { start, width, height };
            start += width * height * layout.layers as usize;
            place
        });
        let places = places.collect();
        Ok(Self { identity, layout, codes, texels, places })
    }

    /// Heights, kind and settings that the map is made from.
    pub fn identity(&self) -> &MapIdentity {
        &self.identity
    }

    /// Shape of the map.
    pub fn layout(&self) -> &MapLayout {
        &self.layout
    }

    /// Meaning of the codes of each channel. Not used when the texels are floats.
    pub fn codes(&self) -> &[Codes; 4] {
        &self.codes
    }

    /// Values as they are stored.
    pub fn texels(&self) -> &MapTexels {
        &self.texels
    }

    /// Position of each level, from the finest.
    pub fn places(&self) -> &[LevelPlace] {
        &self.places
    }

    /// Value of one channel of a texel, by level, layer, column and row. `None` if there is no such
    /// texel.
    pub fn value(&self, level: u32, layer: u32, [column, row]: [u32; 2], channel: u32) -> Option<f32> {
        let place = self.places.get(level as usize)?;
        let (column, row, layer) = (column as usize, row as usize, layer as usize);
        let (channels, channel) = (self.layout.channels as usize, channel as usize);
        if column >= place.width
            || row >= place.height
            || layer >= self.layout.layers as usize
            || channel >= channels
        {
            return None;
        }
        let texel = place.start + (layer * place.height + row) * place.width + column;
        let at = texel * channels + channel;
        match &self.texels {
            MapTexels::F32(values) => values.get(at).copied(),
            MapTexels::F16(values) => values.get(at).map(|bits| crate::encoding::half::value(*bits)),
            MapTexels::Unorm8(values) => values.get(at).map(|code| self.codes[channel].value(*code)),
        }
    }

    /// Whether the map is baked from the heights of `map`, with the same wrap.
    pub fn is_of(&self, map: &HeightMap) -> bool {
        self.identity.wrap == map.wrap() && self.identity.heights == map.heights_hash()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn identity() -> MapIdentity {
        let map = HeightMap::new(2, 1, vec![0.0, 1.0], Wrap::Clamp).expect("a valid map");
        MapIdentity {
            kind: "kind".to_owned(),
            revision: 1,
            texture: String::new(),
            settings: Vec::new(),
            heights: map.heights_hash(),
            wrap: map.wrap(),
            metric: Metric::UNIT,
            first_level: 0,
            height_level: 0,
        }
    }

    const CODES: [Codes; 4] = [Codes { low: -1.0, step: 0.5 }; 4];

    #[test]
    fn values_are_found_by_level_layer_and_channel() {
        let layout = MapLayout { size: [5, 3], levels: 3, layers: 2, channels: 2, format: MapFormat::F32 };
        // Levels of 5x3, 2x1 and 1x1 texels.
        assert_eq!(layout.texels(), 36);
        assert_eq!(layout.bytes(), 288);
        let texels = MapTexels::F32((0..72).map(|value| value as f32).collect());
        let map = BakedMap::new(identity(), layout, CODES, texels).expect("a map of that shape");
        assert_eq!(map.value(0, 0, [4, 2], 1), Some(29.0));
        assert_eq!(map.value(0, 1, [0, 0], 0), Some(30.0));
        assert_eq!(map.value(1, 1, [1, 0], 0), Some(66.0));
        assert_eq!(map.value(2, 1, [0, 0], 1), Some(71.0));
        for (level, layer, at, channel) in
            [(3, 0, [0, 0], 0), (0, 2, [0, 0], 0), (1, 0, [2, 0], 0), (1, 0, [0, 1], 0), (0, 0, [0, 0], 2)]
        {
            assert_eq!(map.value(level, layer, at, channel), None);
        }
    }

    #[test]
    fn stored_values_are_decoded() {
        let layout = |format| MapLayout { size: [2, 1], levels: 1, layers: 1, channels: 1, format };
        let codes = MapTexels::Unorm8(vec![0, 6]);
        let map = BakedMap::new(identity(), layout(MapFormat::Unorm8), CODES, codes).expect("a valid map");
        assert_eq!((map.value(0, 0, [0, 0], 0), map.value(0, 0, [1, 0], 0)), (Some(-1.0), Some(2.0)));
        let halves = MapTexels::F16(vec![0x3c00, 0xc000]);
        let map = BakedMap::new(identity(), layout(MapFormat::F16), CODES, halves).expect("a valid map");
        assert_eq!((map.value(0, 0, [0, 0], 0), map.value(0, 0, [1, 0], 0)), (Some(1.0), Some(-2.0)));
    }

    #[test]
    fn impossible_shapes_are_refused() {
        let layout = MapLayout { size: [4, 4], levels: 1, layers: 1, channels: 1, format: MapFormat::F32 };
        let impossible = [
            MapLayout { size: [0, 4], ..layout },
            MapLayout { size: [4, MAX_SIDE + 1], ..layout },
            MapLayout { levels: 0, ..layout },
            MapLayout { levels: 4, ..layout },
            MapLayout { layers: 0, ..layout },
            MapLayout { layers: MAX_LAYERS + 1, ..layout },
            MapLayout { channels: 3, ..layout },
        ];
        for layout in impossible {
            assert_eq!(layout.check(), Err(MapLayoutError::Impossible(layout)));
        }
        let short = BakedMap::new(identity(), layout, CODES, MapTexels::F32(vec![0.0; 15]));
        assert_eq!(short, Err(MapLayoutError::Length { wanted: 16, given: 15 }));
        let other = BakedMap::new(identity(), layout, CODES, MapTexels::Unorm8(vec![0; 16]));
        assert_eq!(other, Err(MapLayoutError::Format));
    }

    #[test]
    fn a_map_of_other_heights_or_another_wrap_is_told() {
        let layout = MapLayout { size: [2, 1], levels: 1, layers: 1, channels: 1, format: MapFormat::F32 };
        let map =
            BakedMap::new(identity(), layout, CODES, MapTexels::F32(vec![0.0; 2])).expect("a valid map");
        let heights = |texels: Vec<f32>, wrap| HeightMap::new(2, 1, texels, wrap).expect("a valid map");
        assert!(map.is_of(&heights(vec![0.0, 1.0], Wrap::Clamp)));
        assert!(!map.is_of(&heights(vec![0.0, 1.0], Wrap::Repeat)));
        assert!(!map.is_of(&heights(vec![0.0, 0.5], Wrap::Clamp)));
        assert!(!map.is_of(&HeightMap::new(1, 2, vec![0.0, 1.0], Wrap::Clamp).expect("a valid map")));
    }
}
