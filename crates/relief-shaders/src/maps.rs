//! The baked maps that a selection reads, and tests whether given maps are the right ones.

use relief_core::registry::{MapInput, MapLevels, MapMetric, MapSetting};
use relief_core::{BakedMap, HeightMap, Metric, Wrap};

use crate::slots::MapSlot;
use crate::stages::STAGES;
use crate::{Choice, Selection};

/// A baked map that a chosen variant reads.
#[derive(Clone, Debug, PartialEq)]
pub struct MapNeed {
    /// The slot in which the shaders find it.
    pub slot: MapSlot,
    /// The reader: the title of its stage, and its name.
    pub reader: (&'static str, &'static str),
    /// The kind and texture of the map, with its requirements.
    pub input: MapInput,
    /// The kind's settings that differ from the defaults, with their values.
    pub settings: Vec<(&'static str, f32)>,
    /// The most texels of the longer side of the height map's level that it is baked from; `None`:
    /// it is baked from the height map itself.
    pub side: Option<u32>,
}

/// The reason why a selection has no map to read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("the {} '{}' reads a baked map of the kind '{kind}': {problem}", .reader.0, .reader.1)]
pub struct MapError {
    /// The reader: the title of its stage, and its name.
    pub reader: (&'static str, &'static str),
    /// The kind of map.
    pub kind: &'static str,
    /// The fault.
    pub problem: MapProblem,
}

/// The fault of a map that cannot be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum MapProblem {
    /// No map of that kind and texture was given.
    #[error("there is none: bake it first")]
    Missing,
    /// The map was baked from other heights.
    #[error("the one given was baked from other heights: bake it from this height map")]
    Heights,
    /// The map was baked for another wrap.
    #[error("the one given was baked for the wrap '{given}', the height map's is '{wanted}'")]
    Wrap {
        /// The map's wrap.
        given: Wrap,
        /// The height map's wrap.
        wanted: Wrap,
    },
    /// The map was baked in another metric.
    #[error("the one given was baked in another metric, {given:?}; it must be {wanted:?}")]
    Metric {
        /// The map's metric.
        given: Metric,
        /// The metric that is read.
        wanted: Metric,
    },
    /// The map was baked with another setting.
    #[error(
        "the one given was baked with {name} = {}; it must be {wanted}",
        given.map_or("none".to_owned(), |given| given.to_string())
    )]
    Setting {
        /// The name of the setting.
        name: &'static str,
        /// The map's value; `None` if the kind has no such setting.
        given: Option<f32>,
        /// The value that is read.
        wanted: f32,
    },
    /// The map was baked from another level of the height map.
    #[error("the one given lies on level {given} of the height map; it must be level {wanted}")]
    HeightLevel {
        /// The map's level.
        given: u32,
        /// The level that is read.
        wanted: u32,
    },
    /// The map has other levels.
    #[error("the one given begins with level {given} of its texture and has {levels}; it must be {wanted:?}")]
    Levels {
        /// The level of the kind's texture that is the map's finest.
        given: u32,
        /// Number of the map's levels.
        levels: u32,
        /// The levels that are read.
        wanted: MapLevels,
    },
}

impl MapNeed {
    /// Whether another slot or reader needs the same map.
    pub fn is_same_map(&self, other: &MapNeed) -> bool {
        self.input == other.input && self.settings == other.settings && self.side == other.side
    }

    /// Returns the metric that the map must be baked in, for a surface with the metric `surface`.
    pub fn metric(&self, surface: Metric) -> Metric {
        match self.input.metric {
            MapMetric::Texture => Metric::UNIT,
            MapMetric::Scene => surface,
        }
    }

    /// Returns the level of the kind's texture that is the map's finest.
    pub fn first_level(&self) -> u32 {
        match self.input.levels {
            MapLevels::One | MapLevels::EachDetail | MapLevels::MeansFrom(_) => 0,
            MapLevels::ChainFrom(first) => first,
        }
    }

    /// Returns the level of a height map of `width` x `height` texels that it is baked from: the
    /// finest whose longer side is short enough, or the last.
    pub fn height_level(&self, [width, height]: [u32; 2]) -> u32 {
        let (longer, side) = (width.max(height).max(1), self.side.unwrap_or(u32::MAX).max(1));
        // Each level halves the sides, rounded down.
        (0..longer.ilog2()).find(|level| longer >> level <= side).unwrap_or(longer.ilog2())
    }

    /// Checks that `map` is the one that is read, for the height map `heights` on a surface with
    /// the metric `surface`.
    ///
    /// # Errors
    ///
    /// When it is another one; the error names the difference.
    pub fn check(&self, map: &BakedMap, heights: &HeightMap, surface: Metric) -> Result<(), MapError> {
        self.problem(map, heights, surface).map_or(Ok(()), |problem| Err(self.error(problem)))
    }

    fn problem(&self, map: &BakedMap, heights: &HeightMap, surface: Metric) -> Option<MapProblem> {
        let about = map.identity();
        if about.kind != self.input.kind || about.texture != self.input.texture {
            return Some(MapProblem::Missing);
        }
        if about.heights != heights.heights_hash() {
            return Some(MapProblem::Heights);
        }
        if about.wrap != heights.wrap() {
            return Some(MapProblem::Wrap { given: about.wrap, wanted: heights.wrap() });
        }
        let wanted = self.metric(surface);
        if about.metric != wanted {
            return Some(MapProblem::Metric { given: about.metric, wanted });
        }
        for &(name, wanted) in &self.settings {
            let given = about.settings.iter().find(|(of, _)| of == name).map(|(_, value)| *value);
            if given != Some(wanted) {
                return Some(MapProblem::Setting { name, given, wanted });
            }
        }
        let from = self.height_level([heights.width(), heights.height()]);
        let height_level = match self.input.levels {
            MapLevels::MeansFrom(first) => from + first,
            MapLevels::One | MapLevels::EachDetail | MapLevels::ChainFrom(_) => from,
        };
        if about.height_level != height_level {
            return Some(MapProblem::HeightLevel { given: about.height_level, wanted: height_level });
        }
        let levels = map.layout().levels;
        let right = match self.input.levels {
            MapLevels::One => levels == 1 && about.first_level == 0,
            MapLevels::EachDetail => levels == heights.levels() - from && about.first_level == 0,
            MapLevels::ChainFrom(first) => about.first_level == first,
            MapLevels::MeansFrom(_) => about.first_level == 0,
        };
        let wanted = self.input.levels;
        (!right).then_some(MapProblem::Levels { given: about.first_level, levels, wanted })
    }

    fn error(&self, problem: MapProblem) -> MapError {
        MapError { reader: self.reader, kind: self.input.kind, problem }
    }
}

/// The maps that a selection reads, each in its slot.
#[derive(Clone, Copy, Debug, Default)]
pub struct SlotMaps<'a>([Option<&'a BakedMap>; MapSlot::ALL.len()]);

impl<'a> FromIterator<(MapSlot, &'a BakedMap)> for SlotMaps<'a> {
    /// Collects maps without any check; see [`Selection::slot_maps`].
    fn from_iter<T: IntoIterator<Item = (MapSlot, &'a BakedMap)>>(maps: T) -> Self {
        let mut slots = Self::default();
        for (slot, map) in maps {
            slots.0[slot as usize] = Some(map);
        }
        slots
    }
}

impl<'a> SlotMaps<'a> {
    /// Returns the map of a slot, if one is read there.
    pub fn get(&self, slot: MapSlot) -> Option<&'a BakedMap> {
        self.0[slot as usize]
    }
}

impl Selection {
    /// Returns the baked maps that the chosen variants read.
    pub fn map_needs(&self) -> Vec<MapNeed> {
        let mut needs = Vec::new();
        for (place, (stage, choice)) in STAGES.iter().zip(&self.choices).enumerate() {
            if let Some(slot) = stage.slot.filter(|_| self.uses(place)) {
                let reader = (stage.title, choice.entry.name);
                needs.extend(choice.entry.maps.iter().map(|input| {
                    MapNeed {
                        slot,
                        reader,
                        input: self.in_levels(*input),
                        settings: input
                            .settings
                            .iter()
                            .map(|(name, value)| {
                                (*name, choice.map_value(value, self.has_levels(), self.volume_size))
                            })
                            .collect(),
                        side: input
                            .side
                            .map(|side| choice.map_value(&side, self.has_levels(), self.volume_size) as u32),
                    }
                }));
            }
        }
        needs
    }

    /// The input with all levels of detail, if the selection has any.
    fn in_levels(&self, input: MapInput) -> MapInput {
        match input.levels {
            MapLevels::One if self.has_levels() => MapInput { levels: MapLevels::EachDetail, ..input },
            _ => input,
        }
    }

    /// Picks from `maps` those that the chosen variants read, for that height map on a surface with
    /// that metric, each in its slot.
    ///
    /// # Errors
    ///
    /// When a map is missing or does not fit; the error names the difference.
    pub fn slot_maps<'a>(
        &self,
        given: impl IntoIterator<Item = &'a BakedMap> + Clone,
        heights: &HeightMap,
        surface: Metric,
    ) -> Result<SlotMaps<'a>, MapError> {
        let mut maps = SlotMaps::default();
        for need in self.map_needs() {
            let mut problem = MapProblem::Missing;
            for map in given.clone() {
                match need.problem(map, heights, surface) {
                    None => maps.0[need.slot as usize] = Some(map),
                    // A fault of a map of that kind says more than that there is none.
                    Some(MapProblem::Missing) => {}
                    Some(other) => problem = other,
                }
            }
            if maps.get(need.slot).is_none() {
                return Err(need.error(problem));
            }
        }
        Ok(maps)
    }
}

impl Choice {
    /// The value of a map's setting, with levels of detail or without, over a volume of that size.
    fn map_value(&self, setting: &MapSetting, has_levels: bool, volume: [u32; 3]) -> f32 {
        match setting {
            MapSetting::Fixed(value) => *value,
            MapSetting::Param(name) => self.value(name),
            MapSetting::Volume(axis) => volume.get(*axis).map_or(0.0, |&side| side as f32),
            MapSetting::Levels(finest, all) => {
                if has_levels {
                    *all
                } else {
                    *finest
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use relief_core::encoding::code::Codes;
    use relief_core::{MapFormat, MapIdentity, MapLayout, MapTexels};

    use super::*;

    fn heights(wrap: Wrap) -> HeightMap {
        HeightMap::from_fn(3, 2, wrap, |i, _| i as f32 / 2.0).expect("a valid map")
    }

    fn identity() -> MapIdentity {
        MapIdentity {
            kind: "cone".to_owned(),
            revision: 1,
            texture: String::new(),
            settings: vec![("apex".to_owned(), 0.0), ("bits".to_owned(), 0.0)],
            heights: heights(Wrap::Repeat).heights_hash(),
            wrap: Wrap::Repeat,
            metric: Metric::UNIT,
            first_level: 0,
            height_level: 0,
        }
    }

    fn baked(identity: MapIdentity, levels: u32) -> BakedMap {
        let layout = MapLayout { size: [3, 2], levels, layers: 1, channels: 1, format: MapFormat::F32 };
        let texels = MapTexels::F32(vec![0.5; layout.texels() as usize]);
        BakedMap::new(identity, layout, [Codes { low: 0.0, step: 0.0 }; 4], texels).expect("a valid map")
    }

    #[test]
    fn a_search_gets_its_own_map_or_the_reason_why_not() {
        let cone = Selection::method("cone").expect("a method");
        let surface = Metric { tile_m: [2.0, 2.0], scale_m: 0.1 };
        let map = heights(Wrap::Repeat);
        let right = baked(identity(), 1);
        let found = cone.slot_maps([&right], &map, surface).expect("the right map");
        assert_eq!(found.get(MapSlot::Search), Some(&right));
        assert_eq!(found.get(MapSlot::Shadow), None);

        let problem = |given: &[BakedMap], map: &HeightMap| {
            let error = cone.slot_maps(given, map, surface).expect_err("a wrong map");
            assert_eq!((error.reader, error.kind), (("search", "cone"), "cone"));
            error.problem
        };
        assert_eq!(problem(&[], &map), MapProblem::Missing);
        let other_kind = baked(MapIdentity { kind: "frustum".to_owned(), ..identity() }, 1);
        assert_eq!(problem(&[other_kind], &map), MapProblem::Missing);
        let flat = HeightMap::from_fn(3, 2, Wrap::Repeat, |_, _| 0.5).expect("a valid map");
        assert_eq!(problem(std::slice::from_ref(&right), &flat), MapProblem::Heights);
        let wraps = MapProblem::Wrap { given: Wrap::Repeat, wanted: Wrap::Mirror };
        assert_eq!(problem(std::slice::from_ref(&right), &heights(Wrap::Mirror)), wraps);
        let metric = baked(MapIdentity { metric: surface, ..identity() }, 1);
        assert!(matches!(problem(&[metric], &map), MapProblem::Metric { .. }));
        let settings = vec![("apex".to_owned(), 1.0)];
        let apex = baked(MapIdentity { settings, ..identity() }, 1);
        let setting = MapProblem::Setting { name: "apex", given: Some(1.0), wanted: 0.0 };
        assert_eq!(problem(&[apex], &map), setting);
        assert!(matches!(problem(&[baked(identity(), 2)], &map), MapProblem::Levels { .. }));
        let exact = Selection::method("exact").expect("a method");
        assert!(
            exact.slot_maps([&right], &map, surface).is_ok_and(|maps| maps.get(MapSlot::Search).is_none())
        );
    }
}
