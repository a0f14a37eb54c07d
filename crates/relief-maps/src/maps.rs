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
use crate::file::Found;

/// What maps in memory may take besides those of the last call when nothing else is said.
const DEFAULT_MEMORY: ByteSize = ByteSize(1 << 30);

/// Provides the baked maps that methods read: those it has provided before, those a folder keeps, or fresh
/// ones.
#[derive(Debug)]
pub struct Maps {
    cache: Option<Cache>,
    format: MapFormat,
    memory: u64,
    /// The one used last at the end.
    kept: Vec<Arc<BakedMap>>,
}

/// Why there is no map.
#[derive(Debug, thiserror::Error)]
pub enum MapsError {
    /// The registry names a kind that does not exist.
    #[error(transparent)]
    Kind(#[from] UnknownName),
    /// The registry names a setting that does not exist.
    #[error(transparent)]
    Settings(#[from] SettingsError),
    /// It cannot be baked.
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

/// Where a map came from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// It was baked.
    Bake,
    /// It was read from the folder that keeps maps.
    Cache,
    /// It had been provided before.
    Memory,
}

/// How a map came about.
#[derive(Debug)]
pub struct Account {
    /// Name of its kind.
    pub kind: &'static str,
    /// Name of the texture among those of the kind; empty for the only one.
    pub texture: &'static str,
    /// Where it came from.
    pub origin: Origin,
    /// How long that took.
    pub elapsed: Duration,
    /// The file that it was read from or is kept in.
    pub file: Option<PathBuf>,
    /// Whether the folder had a file of it that was damaged.
    pub was_damaged: bool,
    /// Why the folder does not keep it, though there is one.
    pub not_kept: Option<CacheError>,
}

/// The maps that a selection reads, each for its slot.
#[derive(Debug, Default)]
pub struct Provided {
    maps: Vec<(MapSlot, Arc<BakedMap>)>,
    accounts: Vec<Account>,
}

impl Provided {
    /// The maps in their slots.
    pub fn slots(&self) -> SlotMaps<'_> {
        self.maps.iter().map(|(slot, map)| (*slot, &**map)).collect()
    }

    /// The maps, with their slots.
    pub fn maps(&self) -> &[(MapSlot, Arc<BakedMap>)] {
        &self.maps
    }

    /// How each came about; one that is read in several slots is there once.
    pub fn accounts(&self) -> &[Account] {
        &self.accounts
    }

    /// The maps, and how each came about.
    pub fn into_parts(self) -> (Vec<(MapSlot, Arc<BakedMap>)>, Vec<Account>) {
        (self.maps, self.accounts)
    }
}

impl Maps {
    /// A provider that keeps maps in memory alone.
    pub fn in_memory() -> Self {
        Self { cache: None, format: MapFormat::default(), memory: DEFAULT_MEMORY.0, kept: Vec::new() }
    }

    /// A provider that keeps maps in a folder, too, from run to run. What killed processes left in it is
    /// removed.
    pub fn with_cache(cache: Cache) -> Self {
        cache.tidy();
        Self { cache: Some(cache), ..Self::in_memory() }
    }

    /// The same with maps of another format. In fewer bits maps take less memory, and promise what they
    /// promise of their rounded values.
    #[must_use]
    pub fn with_format(self, format: MapFormat) -> Self {
        Self { format, ..self }
    }

    /// The same with other limits to what maps in memory may take besides those of the last call; by default
    /// 1 GiB.
    #[must_use]
    pub fn with_memory(self, memory: ByteSize) -> Self {
        Self { memory: memory.0, ..self }
    }

    /// Adds a map that the caller has baked or read. It is found by what it was made from.
    pub fn insert(&mut self, map: Arc<BakedMap>) {
        self.remember(map);
        self.forget(1);
    }

    /// The baked maps that a selection reads over that height map, on a surface of that metric.
    ///
    /// A folder that cannot be used is noted in the map's account; the map is there all the same. The watch's
    /// tasks are the kinds that are baked, each from 0 to 1.
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

    /// As [`Self::provide`], but for those maps that the caller builds himself, with the values that they are
    /// baked with: a map that `built` names is neither baked nor looked for in the folder. It is provided all
    /// the same where it is in memory, as one that was [inserted](Self::insert) is, and where maps are of
    /// another format than 32-bit floats.
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
            // One that several slots read came about once.
            if !provided.maps.iter().any(|(_, known)| Arc::ptr_eq(known, &map)) {
                provided.accounts.push(account);
            }
            provided.maps.push((need.slot, map));
        }
        self.forget(provided.maps.len());
        Ok(provided)
    }

    /// What a selection's maps take in memory for a height map of so many columns and rows. One that is read
    /// in several slots counts once.
    ///
    /// # Errors
    ///
    /// When one of them cannot be baked from such a height map.
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

    /// What making them takes at most besides them and the height map, one after the other.
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
            // The height map keeps its coarser levels once they are made.
            let last = if height_level > 0 { size[0].max(size[1]).max(1).ilog2() } else { 0 };
            let levels: f64 = (1..=last).map(texels).sum();
            let working = texels(height_level) * f64::from((kind.working_maps)(&settings));
            Ok(bytes.max((4.0 * (working + levels)) as u64))
        })
    }

    /// Whether that map is in memory. Heights are hashed only where one of its kind is.
    fn has(&self, need: &MapNeed, heights: &HeightMap, surface: Metric) -> Result<bool, MapsError> {
        if self.kept.iter().all(|map| map.identity().kind != need.input.kind) {
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

    /// A map out of the folder, or baked and kept there.
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
                Found::Whole(map) => {
                    (account.origin, account.file) = (Origin::Cache, Some(cache.path(&identity, &layout)));
                    return Ok(*map);
                }
                Found::Damaged => account.was_damaged = true,
                Found::Nothing => {}
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
        self.kept.iter().find(|map| map.identity() == identity && map.layout() == layout).cloned()
    }

    /// Makes a map the one used last.
    fn remember(&mut self, map: Arc<BakedMap>) {
        self.kept.retain(|kept| kept.identity() != map.identity() || kept.layout() != map.layout());
        self.kept.push(map);
    }

    /// Drops the maps that were unused longest until the memory suffices; the last so many stay whatever they
    /// take.
    fn forget(&mut self, last: usize) {
        let mut held: u64 = self.kept.iter().map(|map| map.layout().bytes()).sum();
        while self.kept.len() > last && held > self.memory {
            held -= self.kept.remove(0).layout().bytes();
        }
    }
}

#[cfg(test)]
mod tests;
