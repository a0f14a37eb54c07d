//! One texture of a bake as the value that shaders read.

use rayon::prelude::*;
use relief_core::area_mean::{coarser_size, level_count};
use relief_core::encoding::{code::Codes, half};
use relief_core::registry::MapLevels;
use relief_core::{BakedMap, HeightMap, MapFormat, MapIdentity, MapLayout, MapTexels, Metric, Watch};

use crate::{BakeError, Channel, Kind, Settings, Shape, Sink, SinkError, Texture, bake};

/// Request for one baked map.
#[derive(Clone)]
pub struct WantedMap<'a> {
    /// The kind.
    pub kind: &'a Kind,
    /// Name of one of the kind's textures; empty for the only one.
    pub texture: &'a str,
    /// The kind's settings.
    pub settings: Settings,
    /// The metric to bake in.
    pub metric: Metric,
    /// The levels.
    pub levels: MapLevels,
    /// The level of the height map that it is baked from, at most the last; 0 is the map itself.
    pub height_level: u32,
    /// Format of stored values. With fewer bits, values are rounded to the side that keeps the
    /// kind's promise.
    pub format: MapFormat,
}

impl WantedMap<'_> {
    /// Returns everything that determines the values of the map baked from `map`.
    pub fn identity(&self, map: &HeightMap) -> MapIdentity {
        MapIdentity {
            kind: self.kind.name.to_owned(),
            revision: self.kind.revision,
            texture: self.texture.to_owned(),
            settings: self.settings.iter().map(|(name, value)| (name.to_owned(), value)).collect(),
            heights: map.heights_hash(),
            wrap: map.wrap(),
            metric: self.metric,
            first_level: self.first_level(),
            height_level: match self.levels {
                MapLevels::MeansFrom(first) => self.height_level + first,
                MapLevels::One | MapLevels::EachDetail | MapLevels::ChainFrom(_) => self.height_level,
            },
        }
    }

    /// Returns the shape of the map baked from a height map of `size` columns and rows, known
    /// before the bake.
    ///
    /// # Errors
    ///
    /// When the kind has no texture of that name, or no map has the texture's shape.
    pub fn layout(&self, size: [u32; 2]) -> Result<MapLayout, BakeError> {
        let impossible = |reason: String| BakeError::Impossible { kind: self.kind.name, reason };
        let size = (0..self.height_level).fold(size, |size, _| coarser_size(size));
        let shapes = (self.kind.shapes)(size, &self.settings);
        let shape = shapes.iter().find(|shape| shape.name == self.texture);
        let shape = shape.ok_or_else(|| impossible(format!("it has no texture '{}'", self.texture)))?;
        let layout = self.layout_of(shape);
        layout.check().map_err(|error| impossible(error.to_string()))?;
        Ok(layout)
    }

    fn first_level(&self) -> u32 {
        match self.levels {
            MapLevels::One | MapLevels::EachDetail | MapLevels::MeansFrom(_) => 0,
            MapLevels::ChainFrom(first) => first,
        }
    }

    fn layout_of(&self, shape: &Shape) -> MapLayout {
        // A texel of three channels is stored as four.
        let channels = if shape.channels == 3 { 4 } else { shape.channels };
        let (size, levels) = match self.levels {
            MapLevels::One => ([shape.size[0], shape.size[1]], 1),
            MapLevels::EachDetail => {
                let size = [shape.size[0], shape.size[1]];
                (size, level_count(size))
            }
            MapLevels::ChainFrom(_) | MapLevels::MeansFrom(_) => {
                // A texture of a single level is its own chain.
                let last = shape.mips.len() as u32;
                let first = self.first_level().min(last);
                (shape.chain_size(first as usize), last - first + 1)
            }
        };
        MapLayout { size, levels, layers: shape.size[2], channels, format: self.format }
    }
}

/// Bakes the map `wanted` from a height map. Takes the memory of the result besides the memory of
/// the bake.
///
/// # Errors
///
/// Fails as [`bake()`] does. Fails, too, when the kind has no texture of that name, no
/// map has its shape, or a value has no stored value on its safe side.
pub fn baked_map(map: &HeightMap, wanted: &WantedMap, watch: &Watch) -> Result<BakedMap, BakeError> {
    let layout = wanted.layout([map.width(), map.height()])?;
    let impossible = |reason: String| BakeError::Impossible { kind: wanted.kind.name, reason };
    let identity = wanted.identity(map);
    let map = &map.level(wanted.height_level);
    let sink = if wanted.levels == MapLevels::EachDetail {
        bake_details(map, wanted, layout, watch)?
    } else {
        let mut sink = TextureSink::new(wanted.texture, wanted.first_level(), layout).map_err(impossible)?;
        bake(wanted.kind, map, wanted.metric, &wanted.settings, watch, &mut sink)?;
        sink
    };
    BakedMap::new(identity, layout, sink.codes, sink.texels).map_err(|error| impossible(error.to_string()))
}

/// Bakes each level of detail from its own heights.
fn bake_details<'a>(
    map: &HeightMap,
    wanted: &WantedMap<'a>,
    layout: MapLayout,
    watch: &Watch,
) -> Result<TextureSink<'a>, BakeError> {
    let impossible = |reason: String| BakeError::Impossible { kind: wanted.kind.name, reason };
    // Levels may differ in range, but codes use the range of all levels. Codes are therefore made
    // last.
    let format = if layout.format == MapFormat::Unorm8 { MapFormat::F32 } else { layout.format };
    let mut sink = TextureSink::new(wanted.texture, 0, MapLayout { format, ..layout }).map_err(impossible)?;
    // Time is proportional to the number of texels.
    let texels = |level| layout.level_size(level).map(|side| side as f32).iter().product::<f32>();
    let whole: f32 = (0..layout.levels).map(texels).sum();
    let mut done = 0.0;
    for level in 0..layout.levels {
        let part = texels(level) / whole;
        sink.detail = Some(level);
        let (heights, watch) = (map.level(level), watch.piece(done, done + part));
        bake(wanted.kind, &heights, wanted.metric, &wanted.settings, &watch, &mut sink)?;
        done += part;
    }
    if layout.format == MapFormat::Unorm8 { sink.coded().map_err(impossible) } else { Ok(sink) }
}

/// Sink that keeps the levels of one texture.
struct TextureSink<'a> {
    wanted: &'a str,
    first_level: u32,
    /// Level of the map at which the bake's finest level is stored, when each level has its own
    /// bake.
    detail: Option<u32>,
    layout: MapLayout,
    /// Channels, with the range of all levels so far.
    channels: Vec<Channel>,
    codes: [Codes; 4],
    texels: MapTexels,
    /// The texture being received, if it is the wanted one.
    incoming: Option<Incoming>,
    /// First texel of the map's next level.
    start: usize,
}

/// Position in the texture being received.
struct Incoming {
    texture: Texture,
    level: usize,
    slice: u32,
}

impl<'a> TextureSink<'a> {
    fn new(wanted: &'a str, first_level: u32, layout: MapLayout) -> Result<Self, String> {
        let values = layout.texels() * u64::from(layout.channels);
        let texels = match layout.format {
            MapFormat::F32 => MapTexels::F32(zeros(values)?),
            MapFormat::F16 => MapTexels::F16(zeros(values)?),
            MapFormat::Unorm8 => MapTexels::Unorm8(zeros(values)?),
        };
        let codes = [Codes { low: 0.0, step: 0.0 }; 4];
        let (detail, channels, incoming) = (None, Vec::new(), None);
        Ok(Self { wanted, first_level, detail, layout, channels, codes, texels, incoming, start: 0 })
    }

    /// Converts values stored as `f32` into 8-bit codes.
    fn coded(self) -> Result<Self, String> {
        let MapTexels::F32(values) = &self.texels else { return Ok(self) };
        let count = self.layout.channels as usize;
        let code = |(place, value): (usize, &f32)| match self.channels.get(place % count) {
            Some(channel) => self.codes[place % count].code(*value, channel.rounding),
            // Padding of a texel of three channels to four.
            None => Some(0),
        };
        let codes: Option<Vec<u8>> = values.par_iter().enumerate().map(code).collect();
        let texels = MapTexels::Unorm8(codes.ok_or_else(|| no_stored_value(self.wanted))?);
        Ok(Self { texels, ..self })
    }

    /// Stores a slice of a level of the map as layer `layer`.
    fn store(
        &mut self,
        level: u32,
        layer: u32,
        width: usize,
        planes: &[&[f32]],
        channels: &[Channel],
    ) -> bool {
        let [columns, rows] = self.layout.level_size(level).map(|side| side as usize);
        let count = self.layout.channels as usize;
        let first = (self.start + layer as usize * columns * rows) * count;
        let span = first..first + columns * rows * count;
        let row = columns * count;
        match &mut self.texels {
            MapTexels::F32(values) => {
                store(&mut values[span], row, count, width, planes, |_, value| Some(value))
            }
            MapTexels::F16(values) => {
                store(&mut values[span], row, count, width, planes, |channel, value| {
                    let bits = half::normal_bits(value, channels[channel].rounding);
                    half::value(bits).is_finite().then_some(bits)
                })
            }
            MapTexels::Unorm8(values) => {
                store(&mut values[span], row, count, width, planes, |channel, value| {
                    self.codes[channel].code(value, channels[channel].rounding)
                })
            }
        }
    }
}

fn no_stored_value(texture: &str) -> String {
    format!("a value of the texture '{texture}' has no stored value of fewer bits on its safe side")
}

/// Returns a vector of zeros, or an error text when memory does not suffice.
fn zeros<T: Clone + Default>(count: u64) -> Result<Vec<T>, String> {
    let mut values = Vec::new();
    let refused = || format!("the map of {count} values does not fit into memory");
    let length = usize::try_from(count).map_err(|_| refused())?;
    values.try_reserve_exact(length).map_err(|_| refused())?;
    values.resize(length, T::default());
    Ok(values)
}

/// Stores planes of `width` texels a row in rows of `row` values, `count` a texel. Returns false
/// when a value cannot be stored.
fn store<T: Send>(
    values: &mut [T],
    row: usize,
    count: usize,
    width: usize,
    planes: &[&[f32]],
    stored: impl Fn(usize, f32) -> Option<T> + Sync,
) -> bool {
    values.par_chunks_mut(row).enumerate().all(|(at, values)| {
        planes.iter().enumerate().all(|(channel, plane)| {
            let plane = plane.get(at * width..(at + 1) * width).unwrap_or(&[]);
            values
                .iter_mut()
                .skip(channel)
                .step_by(count)
                .zip(plane)
                .all(|(place, value)| stored(channel, *value).map(|value| *place = value).is_some())
        })
    })
}

impl Sink for TextureSink<'_> {
    fn begin(&mut self, texture: &Texture) -> Result<(), SinkError> {
        self.incoming = None;
        if texture.name == self.wanted {
            let mut channels = texture.channels.clone();
            for (channel, before) in channels.iter_mut().zip(&self.channels) {
                let [[low, high], [lowest, highest]] = [channel.range, before.range];
                channel.range = [low.min(lowest), high.max(highest)];
            }
            for (codes, channel) in self.codes.iter_mut().zip(&channels) {
                *codes = Codes::of_range(channel.range);
            }
            self.channels = channels;
            self.incoming = Some(Incoming { texture: texture.clone(), level: 0, slice: 0 });
        }
        Ok(())
    }

    fn slice(&mut self, planes: &[&[f32]]) -> Result<(), SinkError> {
        let Some(mut incoming) = self.incoming.take() else { return Ok(()) };
        let [width, _, slices] = incoming.texture.level_size(incoming.level);
        let last = incoming.texture.mips.len();
        let first = (self.first_level as usize).min(last);
        let level = match self.detail {
            Some(detail) => (incoming.level == 0).then_some(detail),
            None => incoming.level.checked_sub(first).map(|level| level as u32),
        };
        if let Some(level) = level.filter(|level| *level < self.layout.levels) {
            if !self.store(level, incoming.slice, width as usize, planes, &incoming.texture.channels) {
                return Err(SinkError(no_stored_value(incoming.texture.name)));
            }
            if incoming.slice + 1 == slices {
                let size = self.layout.level_size(level).map(|side| side as usize);
                self.start += size[0] * size[1] * self.layout.layers as usize;
            }
        }
        incoming.slice += 1;
        if incoming.slice == slices {
            (incoming.level, incoming.slice) = (incoming.level + 1, 0);
        }
        if incoming.level <= last {
            self.incoming = Some(incoming);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use relief_core::{Rounding, Wrap};

    use super::*;
    use crate::{Collected, CollectedTexture, KINDS, kind};

    fn map(width: u32, height: u32) -> HeightMap {
        let texel = |i: u32, j: u32| ((i * 7 + j * 5) % 11) as f32 / 10.0;
        HeightMap::from_fn(width, height, Wrap::Mirror, texel).expect("a valid map")
    }

    fn wanted<'a>(name: &str, texture: &'a str, levels: MapLevels, format: MapFormat) -> WantedMap<'a> {
        let kind = kind(name).expect("a kind");
        let (settings, metric) = (kind.defaults(), Metric::UNIT);
        WantedMap { kind, texture, settings, metric, levels, height_level: 0, format }
    }

    fn collected(map: &HeightMap, wanted: &WantedMap) -> CollectedTexture {
        let mut all = Collected::default();
        bake(wanted.kind, map, wanted.metric, &wanted.settings, &Watch::none(), &mut all).expect("a bake");
        all.textures.into_iter().find(|found| found.texture.name == wanted.texture).expect("the texture")
    }

    /// Compares every value of the map with the bake's value, with the channel's rounding.
    fn compare(map: &HeightMap, wanted: &WantedMap, each: impl Fn(f32, f32, Rounding)) {
        let baked = baked_map(map, wanted, &Watch::none()).expect("a bake");
        let found = collected(map, wanted);
        // A single texel has no level above it.
        let first = wanted.first_level().min(found.texture.mips.len() as u32);
        for level in 0..baked.layout().levels {
            let [width, height, slices] = found.texture.level_size((level + first) as usize);
            let [columns, rows] = baked.layout().level_size(level);
            assert!(width <= columns && height <= rows && slices == baked.layout().layers);
            for (channel, texels) in found.levels[(level + first) as usize].iter().enumerate() {
                for (at, value) in texels.iter().enumerate() {
                    let at = at as u32;
                    let place = [at % width, at / width % height];
                    let stored = baked.value(level, at / (width * height), place, channel as u32);
                    let rounding = found.texture.channels[channel].rounding;
                    each(*value, stored.expect("a texel"), rounding);
                }
            }
        }
    }

    #[test]
    fn floats_are_those_of_the_bake() {
        let cases = [
            ("frustum", "slopes", MapLevels::One),
            ("frustum", "top", MapLevels::One),
            ("pyramid", "", MapLevels::One),
            ("pyramid", "", MapLevels::ChainFrom(0)),
            ("pyramid", "", MapLevels::ChainFrom(1)),
            ("distance", "", MapLevels::One),
            ("bent-normal", "", MapLevels::One),
        ];
        for (name, texture, levels) in cases {
            for size in [[7, 5], [1, 1], [1, 13], [16, 16], [33, 4]] {
                let wanted = wanted(name, texture, levels, MapFormat::F32);
                compare(&map(size[0], size[1]), &wanted, |value, stored, _| assert_eq!(value, stored));
            }
        }
    }

    #[test]
    fn fewer_bits_stay_on_the_safe_side_and_lose_little() {
        let cases = [
            ("cone", "", MapLevels::One),
            ("frustum", "slopes", MapLevels::One),
            ("pyramid", "", MapLevels::ChainFrom(1)),
            ("dilation-erosion", "", MapLevels::One),
            ("distance", "", MapLevels::One),
            ("horizon", "", MapLevels::One),
        ];
        for (name, texture, levels) in cases {
            for (format, lost) in [(MapFormat::F16, 1e-3), (MapFormat::Unorm8, 4.1e-3)] {
                let wanted = wanted(name, texture, levels, format);
                let map = map(37, 21);
                let ranges: Vec<[f32; 2]> =
                    collected(&map, &wanted).texture.channels.iter().map(|channel| channel.range).collect();
                let span = ranges.iter().map(|range| range[1] - range[0]).fold(0.0, f32::max);
                compare(&map, &wanted, |value, stored, rounding| {
                    match rounding {
                        Rounding::Down => assert!(stored <= value, "{name}: {stored} for {value}"),
                        Rounding::Up => assert!(stored >= value, "{name}: {stored} for {value}"),
                        Rounding::Nearest => {}
                    }
                    assert!((stored - value).abs() <= lost * span, "{name} {format:?}: {stored} for {value}");
                });
            }
        }
    }

    #[test]
    fn kinds_say_their_shapes_before_they_bake() {
        for kind in KINDS {
            for size in [[1, 1], [5, 3], [1, 9], [32, 8]] {
                let map = map(size[0], size[1]);
                let mut settings = kind.defaults();
                for _ in 0..2 {
                    let mut all = Collected::default();
                    bake(kind, &map, Metric::UNIT, &settings, &Watch::none(), &mut all).expect("a bake");
                    let baked: Vec<Shape> = all.textures.iter().map(|found| found.texture.shape()).collect();
                    assert_eq!((kind.shapes)(size, &settings), baked, "{} {size:?}", kind.name);
                    let values: usize =
                        all.textures.iter().flat_map(|t| t.levels.iter().flatten()).map(Vec::len).sum();
                    assert_eq!(values as u64, baked.iter().map(Shape::values).sum::<u64>());
                    // Once more with other settings.
                    // The sides of a volume must fit its map.
                    for param in kind.params.iter().filter(|_| !kind.of_volume) {
                        if param.name != "bits" {
                            settings
                                .set(param.name, f64::from(param.min.max(1.0).min(param.max)))
                                .expect("in range");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn what_no_slot_can_hold_is_refused_before_it_is_baked() {
        let refused = |wanted: &WantedMap, size: [u32; 2]| match wanted.layout(size) {
            Err(BakeError::Impossible { reason, .. }) => reason,
            other => panic!("{other:?}"),
        };
        let missing = wanted("cone", "no such texture", MapLevels::One, MapFormat::F32);
        assert!(refused(&missing, [4, 4]).contains("no such texture"));
        let mut deep = wanted("distance", "", MapLevels::One, MapFormat::F32);
        deep.settings.set("slices", 257.0).expect("in range");
        assert!(refused(&deep, [4, 4]).contains("257 layers"));
        let six = wanted("normal", "", MapLevels::One, MapFormat::F32);
        assert!(refused(&six, [4, 4]).contains("6 channels"));
    }
}
