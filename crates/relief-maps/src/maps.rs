//! The provider of baked maps.

use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use relief_bake::{BakeError, SettingsError, WantedMap, baked_map};
use relief_core::registry::UnknownName;
use relief_core::{
    BakedMap, ByteSize, Cancelled, HeightMap, MapFormat, MapIdentity, MapLayout, Metric, Watch,
};
use relief_shaders::{MapNeed, MapSlot, Selection, SlotMaps};
use web_time::Instant;

use crate::cache::{Cache, CacheError};
use crate::file::CacheEntry;

/// Default memory limit for maps of earlier calls: 1 GiB.
const DEFAULT_MEMORY: ByteSize = ByteSize(1 << 30);

/// Provides the baked maps that methods read: from memory, from the cache folder, or freshly baked. Clones share
/// the maps that are there.
#[derive(Clone, Debug)]
pub struct Maps {
    cache: Option<Cache>,
    format: MapFormat,
    memory: u64,
    /// Maps in memory, the most recently used one last.
    in_memory: Vec<Arc<BakedMap>>,
}

/// Why a map cannot be provided.
#[derive(Debug, thiserror::Error)]
pub enum MapsError {
    /// The registry names a kind that does not exist.
    #[error(transparent)]
    Kind(#[from] UnknownName),
    /// The registry names a setting that does not exist.
    #[error(transparent)]
    Settings(#[from] SettingsError),
    /// The map cannot be baked.
    #[error(transparent)]
    Bake(BakeError),
    /// The bake was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl From<BakeError> for MapsError {
    fn from(error: BakeError) -> Self {
        match error {
            BakeError::Cancelled(cancelled) => cancelled.into(),
            other => Self::Bake(other),
        }
    }
}

/// Origin of a provided map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The map was baked.
    Bake,
    /// The map was read from the cache folder.
    Cache,
    /// The map was in memory from an earlier call.
    Memory,
}

/// Report on how a map was provided.
#[derive(Debug)]
pub struct Account {
    /// Name of the map's kind.
    pub kind: &'static str,
    /// Name of the texture, for kinds with several; empty for the only one.
    pub texture: &'static str,
    /// Origin of the map.
    pub origin: Origin,
    /// Time that it took.
    pub elapsed: Duration,
    /// File from which the map was read or into which it was stored.
    pub file: Option<PathBuf>,
    /// Whether the cache folder held a damaged file of the map.
    pub was_damaged: bool,
    /// Why the cache folder could not store the map, if there is a folder.
    pub not_kept: Option<CacheError>,
}

/// The maps that a selection reads, each with its slot.
#[derive(Debug, Default)]
pub struct Provided {
    maps: Vec<(MapSlot, Arc<BakedMap>)>,
    accounts: Vec<Account>,
}

impl Provided {
    /// Maps by slot, as the renderer takes them.
    pub fn slots(&self) -> SlotMaps<'_> {
        self.maps.iter().map(|(slot, map)| (*slot, &**map)).collect()
    }

    /// Maps with their slots.
    pub fn maps(&self) -> &[(MapSlot, Arc<BakedMap>)] {
        &self.maps
    }

    /// Reports on the maps. A map that several slots read has one report.
    pub fn accounts(&self) -> &[Account] {
        &self.accounts
    }

    /// Returns the maps and the reports.
    pub fn into_parts(self) -> (Vec<(MapSlot, Arc<BakedMap>)>, Vec<Account>) {
        (self.maps, self.accounts)
    }
}

impl Maps {
    /// Creates a provider that stores maps in memory only.
    pub fn in_memory() -> Self {
        Self { cache: None, format: MapFormat::default(), memory: DEFAULT_MEMORY.0, in_memory: Vec::new() }
    }

    /// Creates a provider that also stores maps in a cache folder, from run to run. Leftovers of
    /// killed processes in the folder are deleted.
    pub fn with_cache(cache: Cache) -> Self {
        cache.tidy();
        Self { cache: Some(cache), ..Self::in_memory() }
    }

    /// Sets the format of maps. Maps with fewer bits take less memory. Their guarantees hold for
    /// the rounded values.
    #[must_use]
    pub fn with_format(self, format: MapFormat) -> Self {
        Self { format, ..self }
    }

    /// Sets the memory limit for maps of earlier calls. The maps of the last call do not count. The
    /// default is 1 GiB.
    #[must_use]
    pub fn with_memory(self, memory: ByteSize) -> Self {
        Self { memory: memory.0, ..self }
    }

    /// Adds a map that the caller has baked or read. It is used wherever its identity and layout
    /// match.
    pub fn insert(&mut self, map: Arc<BakedMap>) {
        self.remember(map);
        self.forget(1);
    }

    /// Provides the baked maps that a selection reads over a height map, on a surface with this
    /// metric.
    ///
    /// If a folder cannot be used, the map's report says so, and the map is still provided. The
    /// tasks reported to `watch` are the kinds that are baked, each from 0 to 1.
    ///
    /// # Errors
    ///
    /// When a map cannot be baked, or the bake is cancelled.
    pub fn provide(
        &mut self,
        selection: &Selection,
        heights: &HeightMap,
        surface: Metric,
        watch: &Watch,
    ) -> Result<Provided, MapsError> {
        self.provide_except(selection, heights, surface, &|_| false, watch)
    }

    /// Provides maps as [`Self::provide`], except those that the caller builds with equal values. A
    /// map for which `built` returns true is neither baked nor searched in the folder. It is still
    /// provided if it is in memory, for example [inserted](Self::insert), and if the format is not
    /// 32-bit floats.
    ///
    /// # Errors
    ///
    /// As [`Self::provide`].
    pub fn provide_except(
        &mut self,
        selection: &Selection,
        heights: &HeightMap,
        surface: Metric,
        built: &dyn Fn(&MapNeed) -> bool,
        watch: &Watch,
    ) -> Result<Provided, MapsError> {
        let mut provided = Provided::default();
        for need in selection.map_needs() {
            if self.format == MapFormat::F32 && built(&need) && !self.has(&need, heights, surface)? {
                continue;
            }
            let (map, account) = self.one(&need, heights, surface, watch)?;
            // A map that several slots read gets one report.
            if !provided.maps.iter().any(|(_, known)| Arc::ptr_eq(known, &map)) {
                provided.accounts.push(account);
            }
            provided.maps.push((need.slot, map));
        }
        self.forget(provided.maps.len());
        Ok(provided)
    }

    /// Memory of a selection's maps, in bytes, for a height map of `size` columns and rows. A map
    /// that several slots read counts once.
    ///
    /// # Errors
    ///
    /// When one of the maps cannot be baked from such a height map.
    pub fn bytes(&self, selection: &Selection, size: [u32; 2]) -> Result<u64, MapsError> {
        let needs = selection.map_needs();
        needs.iter().enumerate().try_fold(0u64, |bytes, (place, need)| {
            if needs[..place].iter().any(|other| other.is_same_map(need)) {
                return Ok(bytes);
            }
            let layout = self.wanted(need, size, Metric::UNIT)?.layout(size)?;
            Ok(bytes.saturating_add(layout.bytes()))
        })
    }

    /// Most memory that baking these maps takes in addition to them and the height map, in bytes.
    /// Maps are baked one after the other.
    ///
    /// # Errors
    ///
    /// As [`Self::bytes`].
    pub fn working_bytes(&self, selection: &Selection, size: [u32; 2]) -> Result<u64, MapsError> {
        let texels = |level: u32| {
            let [width, height] = size.map(|side| f64::from((side >> level).max(1)));
            width * height
        };
        selection.map_needs().iter().try_fold(0, |bytes, need| {
            let WantedMap { kind, settings, height_level, .. } = self.wanted(need, size, Metric::UNIT)?;
            // The height map stores its coarser levels once they are computed.
            let last = if height_level > 0 { size[0].max(size[1]).max(1).ilog2() } else { 0 };
            let levels: f64 = (1..=last).map(texels).sum();
            let working = texels(height_level) * f64::from((kind.working_maps)(&settings));
            Ok(bytes.max((4.0 * (working + levels)) as u64))
        })
    }

    /// Whether a map is in memory. Heights are hashed only if a map of the same kind is.
    fn has(&self, need: &MapNeed, heights: &HeightMap, surface: Metric) -> Result<bool, MapsError> {
        if self.in_memory.iter().all(|map| map.identity().kind != need.input.kind) {
            return Ok(false);
        }
        let size = [heights.width(), heights.height()];
        let wanted = self.wanted(need, size, surface)?;
        let layout = wanted.layout(size)?;
        Ok(self.remembered(&wanted.identity(heights), &layout).is_some())
    }

    fn wanted(
        &self,
        need: &MapNeed,
        size: [u32; 2],
        surface: Metric,
    ) -> Result<WantedMap<'static>, MapsError> {
        let kind = relief_bake::kind(need.input.kind)?;
        let mut settings = kind.defaults();
        for (name, value) in &need.settings {
            settings.set(name, f64::from(*value))?;
        }
        let (texture, levels) = (need.input.texture, need.input.levels);
        let (metric, format) = (need.metric(surface), self.format);
        let height_level = need.height_level(size);
        Ok(WantedMap { kind, texture, settings, metric, levels, height_level, format })
    }

    fn one(
        &mut self,
        need: &MapNeed,
        heights: &HeightMap,
        surface: Metric,
        watch: &Watch,
    ) -> Result<(Arc<BakedMap>, Account), MapsError> {
        let started = Instant::now();
        let size = [heights.width(), heights.height()];
        let wanted = self.wanted(need, size, surface)?;
        let identity = wanted.identity(heights);
        let layout = wanted.layout(size)?;
        let mut account = Account {
            kind: need.input.kind,
            texture: need.input.texture,
            origin: Origin::Memory,
            elapsed: Duration::ZERO,
            file: None,
            was_damaged: false,
            not_kept: None,
        };
        let map = match self.remembered(&identity, &layout) {
            Some(map) => map,
            None => Arc::new(self.fresh(&wanted, identity, layout, heights, watch, &mut account)?),
        };
        account.elapsed = started.elapsed();
        self.remember(Arc::clone(&map));
        Ok((map, account))
    }

    /// Returns a map from the folder, or bakes and stores it.
    fn fresh(
        &self,
        wanted: &WantedMap,
        identity: MapIdentity,
        layout: MapLayout,
        heights: &HeightMap,
        watch: &Watch,
        account: &mut Account,
    ) -> Result<BakedMap, MapsError> {
        if let Some(cache) = &self.cache {
            match cache.read(&identity, &layout) {
                CacheEntry::Valid(map) => {
                    (account.origin, account.file) = (Origin::Cache, Some(cache.path(&identity, &layout)));
                    return Ok(*map);
                }
                CacheEntry::Damaged => account.was_damaged = true,
                CacheEntry::Missing => {}
            }
        }
        account.origin = Origin::Bake;
        let map = baked_map(heights, wanted, &watch.task(wanted.kind.name))?;
        match self.cache.as_ref().map(|cache| cache.write(&map)) {
            Some(Ok(path)) => account.file = Some(path),
            Some(Err(error)) => account.not_kept = Some(error),
            None => {}
        }
        Ok(map)
    }

    fn remembered(&self, identity: &MapIdentity, layout: &MapLayout) -> Option<Arc<BakedMap>> {
        self.in_memory.iter().find(|map| map.identity() == identity && map.layout() == layout).cloned()
    }

    /// Marks a map as the most recently used one.
    fn remember(&mut self, map: Arc<BakedMap>) {
        self.in_memory.retain(|other| other.identity() != map.identity() || other.layout() != map.layout());
        self.in_memory.push(map);
    }

    /// Drops the least recently used maps until the limit is met. The last `last` maps are never
    /// dropped.
    fn forget(&mut self, last: usize) {
        let mut held: u64 = self.in_memory.iter().map(|map| map.layout().bytes()).sum();
        while self.in_memory.len() > last && held > self.memory {
            held -= self.in_memory.remove(0).layout().bytes();
        }
    }
}

#[cfg(test)]
mod tests;
