//! Filter of the coarser levels of a height map, for meshes that are made for a view.

use std::str::FromStr;
use std::sync::atomic::AtomicBool;

use relief_bake::{Filter, filter_levels};
use relief_core::registry::UnknownName;
use relief_core::{ByteSize, HeightMap, Watch};

use crate::failure::Failure;
use crate::interrupt::cancelled;
use crate::progress::Progress;

/// Filter of coarser levels, or none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LevelFilter(pub Option<Filter>);

impl Default for LevelFilter {
    /// Returns the most accurate filter that takes little time.
    fn default() -> Self {
        Self(Some(Filter::LeastSquares))
    }
}

/// Name of no filter.
const NONE: &str = "none";

impl FromStr for LevelFilter {
    type Err = UnknownName;

    fn from_str(name: &str) -> Result<Self, UnknownName> {
        if name == NONE {
            return Ok(Self(None));
        }
        let names = || Filter::ALL.map(Filter::name).into_iter().chain([NONE]);
        name.parse().map(|filter| Self(Some(filter))).map_err(|_| UnknownName::new("filter", name, names()))
    }
}

/// Memory for making and keeping the levels, in height maps.
const MAPS: f64 = 2.5;

impl LevelFilter {
    /// Returns the coarser levels of a map of `bytes` bytes, within `limit` bytes of memory.
    pub fn levels(
        self,
        map: &HeightMap,
        [bytes, limit]: [u64; 2],
        json: bool,
        cancel: &AtomicBool,
    ) -> Result<Vec<HeightMap>, Failure> {
        let Some(filter) = self.0 else { return Ok(Vec::new()) };
        let needed = bytes + (bytes as f64 * MAPS) as u64;
        if needed > limit {
            let (mib, limit) = (needed.div_ceil(1 << 20), ByteSize(limit));
            return Err(Failure::Work(format!(
                "the levels of the height map take {mib} MiB to make, more than the {limit} allowed: raise \
                 --max-memory, or give --level-filter none"
            )));
        }
        let bar = Progress::bar("filtering", json);
        let tell = |_: &str, part: f32| bar.show(part);
        let levels = filter_levels(map, filter, &Watch::new(&tell, cancel));
        let mut levels = levels.map_err(|error| match error {
            relief_bake::BakeError::Cancelled(_) => cancelled(),
            other => Failure::work(other),
        })?;
        // The first level is the map itself.
        Ok(levels.split_off(1))
    }
}
