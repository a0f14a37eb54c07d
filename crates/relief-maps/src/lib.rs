//! Provides the baked maps that displacement methods read. Maps are looked up in memory and in a
//! cache folder that persists between runs. Missing ones are baked and stored.
//!
//! ```
//! use relief_core::{HeightMap, Metric, Watch, Wrap};
//! use relief_maps::Maps;
//! use relief_shaders::{MapSlot, Selection};
//!
//! let heights = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| (i * j % 64) as f32 / 63.0)?;
//! let cone = Selection::method("cone")?;
//! let mut maps = Maps::in_memory();
//! let provided = maps.provide(&cone, &heights, Metric::UNIT, &Watch::none())?;
//! assert!(provided.slots().get(MapSlot::Search).is_some());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod cache;
mod file;
mod key;
mod maps;

pub use cache::{Cache, CacheError, DEFAULT_LIMIT, FOLDER_VARIABLE, LIMIT_VARIABLE};
pub use maps::{Account, Maps, MapsError, Origin, Provided};
