//! From where a mesh is looked at, and the levels of its height map that are seen.

use std::str::FromStr;
use std::sync::atomic::AtomicBool;

use relief_bake::{Filter, filter_levels};
use relief_core::registry::UnknownName;
use relief_core::{ByteSize, HeightMap, Watch};
use relief_io::GlbMaterials;
use relief_mesh::View;
use relief_scene::Surface;

use super::ground::Metres;
use crate::failure::Failure;
use crate::interrupt::cancelled;
use crate::progress::Progress;

/// What a mesh is made of, and from where it is looked at.
pub struct Seen<'a> {
    pub surface: &'a Surface,
    pub view: Option<View>,
    /// Coarser levels of the height map, which are seen where voxels are wider than its texels.
    pub coarser: Vec<HeightMap>,
    /// The metres that it is written in.
    pub metres: &'a Metres,
    /// The materials of the base that are written.
    pub materials: Option<GlbMaterials>,
}

/// How coarser levels are made, if they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LevelFilter(pub Option<Filter>);

impl Default for LevelFilter {
    /// The nearest that takes no time.
    fn default() -> Self {
        Self(Some(Filter::LeastSquares))
    }
}

/// The name of no filter.
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

/// Height maps' worth of memory that it takes to make levels, and to keep them.
const MAPS: f64 = 2.5;

impl LevelFilter {
    /// The coarser levels of a map that takes so many bytes of those that are allowed.
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
                "the levels of the height map take {mib} MiB to make, more than the {limit} allowed: \
                 --max-memory raises it, --level-filter none makes none"
            )));
        }
        let bar = Progress::bar("filtering", json);
        let tell = |_: &str, part: f32| bar.show(part);
        let levels = filter_levels(map, filter, &Watch::new(&tell, cancel));
        let mut levels = levels.map_err(|error| match error {
            relief_bake::BakeError::Cancelled(_) => cancelled(),
            other => Failure::work(other),
        })?;
        // The first is the map itself.
        Ok(levels.split_off(1))
    }
}
