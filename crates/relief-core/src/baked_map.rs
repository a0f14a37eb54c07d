//! A baked map as a value: what it is, what it was made from, and its texels.

use std::str::FromStr;

use crate::area_mean::level_count;
use crate::encoding::code::Codes;
use crate::registry::UnknownName;
use crate::{HeightMap, HeightsHash, MAX_SIDE, Metric, Wrap};

/// The most layers of a map, the least that GPUs offer.
pub const MAX_LAYERS: u32 = 256;

/// How the values of a map are stored.
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
    /// Every format, the one of the most bits first.
    pub const ALL: [MapFormat; 3] = [MapFormat::F32, MapFormat::F16, MapFormat::Unorm8];

    /// Its name, as in the texels of files.
    pub const fn name(self) -> &'static str {
        match self {
            MapFormat::F32 => "float",
            MapFormat::F16 => "half",
            MapFormat::Unorm8 => "unorm8",
        }
    }

    /// Bytes of a value.
    pub const fn bytes(self) -> u64 {
        match self {
            MapFormat::F32 => 4,
            MapFormat::F16 => 2,
            MapFormat::Unorm8 => 1,
        }
    }
}

/// The shape of a map: texels of 1, 2 or 4 channels, in layers, in levels of detail.
///
/// The slices of a volume, azimuths, directions and the faces of a cube are layers. Each level has half the
/// columns and rows of the one before, rounded down but at least one, as textures of GPUs have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct MapLayout {
    /// Columns and rows of the finest level.
    pub size: [u32; 2],
    /// Levels.
    pub levels: u32,
    /// Layers.
    pub layers: u32,
    /// Channels of a texel: 1, 2 or 4.
    pub channels: u32,
    /// How each value is stored.
    pub format: MapFormat,
}

impl MapLayout {
    /// Columns and rows of a level.
    pub fn level_size(&self, level: u32) -> [u32; 2] {
        self.size.map(|side| side.checked_shr(level).unwrap_or(0).max(1))
    }

    /// Texels of all levels and layers.
    pub fn texels(&self) -> u64 {
        let of_level = |level| self.level_size(level).map(u64::from).iter().product::<u64>();
        (0..self.levels).map(of_level).sum::<u64>() * u64::from(self.layers)
    }

    /// Bytes of all texels.
    pub fn bytes(&self) -> u64 {
        self.texels() * u64::from(self.channels) * self.format.bytes()
    }

    /// Whether there can be a map of that shape.
    ///
    /// # Errors
    ///
    /// When a side, the layers or the levels are none or too many, or the channels are not 1, 2 or 4.
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

/// Why texels make no map.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MapLayoutError {
    /// No map has that shape.
    #[error(
        "no map has {} x {} texels of {} channels in {} layers and {} levels: channels are 1, 2 or 4, layers at most {MAX_LAYERS}",
        .0.size[0], .0.size[1], .0.channels, .0.layers, .0.levels
    )]
    Impossible(MapLayout),
    /// There are not as many values as the shape has.
    #[error("the map has {wanted} values, {given} were given")]
    Length {
        /// Values of the shape.
        wanted: u64,
        /// Values given.
        given: usize,
    },
    /// The values are of another format than the shape says.
    #[error("the map's values are of another format than its layout says")]
    Format,
}

/// What decides the values of a map.
#[derive(Clone, Debug, PartialEq)]
pub struct MapIdentity {
    /// Name of the kind.
    pub kind: String,
    /// Revision of the kind, which is raised with every change of the values that it bakes.
    pub revision: u32,
    /// Name of the texture among those of the kind; empty for the only one.
    pub texture: String,
    /// All of the kind's settings.
    pub settings: Vec<(String, f32)>,
    /// The heights that it was made from.
    pub heights: HeightsHash,
    /// How these go on beyond their edges.
    pub wrap: Wrap,
    /// The metric that it was baked in.
    pub metric: Metric,
    /// The level of the kind's texture that is the map's finest: the finest of all, or of a chain whose
    /// finest level says nothing that the heights do not say a coarser one.
    pub first_level: u32,
    /// The level of the height map whose place and size the map's finest level has. A map that is baked from
    /// a coarser level begins at that level.
    pub height_level: u32,
}

impl MapIdentity {
    /// That of a kind of map which is made from something else than heights: heights, wrap and metric say
    /// nothing.
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

/// The values of a map: level by level from the finest, layer by layer, row by row from the top, the channels
/// of a texel side by side.
#[derive(Clone, Debug, PartialEq)]
pub enum MapTexels {
    /// 32-bit floats.
    F32(Vec<f32>),
    /// 16-bit floats, as their bits.
    F16(Vec<u16>),
    /// Codes.
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

/// A map that was baked from a height map, for a shader to read: one value from the bake over the cache to
/// the GPU and to the translated shaders.
///
/// Where the kind promises something of its values, it holds for the stored ones: in fewer bits they are
/// rounded to the safe side.
#[derive(Clone, Debug, PartialEq)]
pub struct BakedMap {
    identity: MapIdentity,
    layout: MapLayout,
    codes: [Codes; 4],
    texels: MapTexels,
    places: Vec<LevelPlace>,
}

/// Where a level lies among a map's texels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LevelPlace {
    /// The first of its texels.
    pub start: usize,
    /// Columns.
    pub width: usize,
    /// Rows.
    pub height: usize,
}

impl BakedMap {
    /// A map of those texels. `codes` say what the codes of each channel stand for where texels are codes.
    ///
    /// # Errors
    ///
    /// When there can be no map of that shape, or the texels are not as many.
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

    /// What it was made from, and how.
    pub fn identity(&self) -> &MapIdentity {
        &self.identity
    }

    /// Its shape.
    pub fn layout(&self) -> &MapLayout {
        &self.layout
    }

    /// What the codes of each channel stand for; of no meaning where texels are floats.
    pub fn codes(&self) -> &[Codes; 4] {
        &self.codes
    }

    /// Its values as they are stored.
    pub fn texels(&self) -> &MapTexels {
        &self.texels
    }

    /// Where each level begins.
    pub fn places(&self) -> &[LevelPlace] {
        &self.places
    }

    /// The value of a channel of a texel, by level, layer, column and row. None where there is no such texel.
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

    /// Whether it was baked from the heights and the wrap of that map.
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
