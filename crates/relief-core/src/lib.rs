//! The core of Relief: height maps, meshes, rays and the exact first hit.
//!
//! A [`HeightMap`] lies on a [`Mesh`](mesh::Mesh), oriented by a [`TangentFrame`]. A ray takes a
//! [`Path`] through the map and ends at a [`Hit`]. The tracers in [`exact`] find the true hit, by
//! which every faster method is judged.
//!
//! This crate contains no file access, no GPU code and no shader compiler. The project's
//! conventions are documented at their types: texture axes and reconstruction at [`HeightMap`],
//! handedness at [`TangentFrame`], the ray parameter at [`Path`].
//!
//! ```
//! use relief_core::exact::FastTracer;
//! use relief_core::{HeightMap, Path, Wrap};
//!
//! let wave = |i: u32, j: u32| 0.5 + 0.4 * (i as f32 * 0.1).sin() * (j as f32 * 0.1).cos();
//! let heights = HeightMap::from_fn(128, 128, Wrap::Repeat, wave)?;
//! // From texture coordinates (0.2, 0.1) at height 1 down to (0.7, 0.4) at height 0.
//! let path = Path::between([0.2, 0.1, 1.0], [0.7, 0.4, 0.0]);
//! let hit = FastTracer::new(&heights).trace(&path).hit;
//! let [u, v, height] = path.at(hit.t);
//! assert!((heights.height_at(u, v) - height).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod area_mean;
mod baked_map;
mod byte_size;
pub mod camera;
pub mod encoding;
mod equal_steps;
pub mod exact;
mod found_state;
mod height_bounds;
mod height_map;
mod heights_hash;
pub mod hierarchy;
mod hit;
mod lanes;
pub mod mesh;
mod metric;
pub mod metrics;
mod motif_tree;
pub mod object;
mod path;
mod pyramid;
pub mod raycast;
pub mod registry;
pub mod rng;
mod slice_axis;
mod tangent_frame;
mod texel_mask;
mod volume;
mod watch;
mod wrap;

pub use baked_map::{
    BakedMap, LevelPlace, MAX_LAYERS, MapFormat, MapIdentity, MapLayout, MapLayoutError, MapTexels,
};
pub use byte_size::{BadByteSize, ByteSize};
pub use encoding::Rounding;
pub use equal_steps::EqualSteps;
pub use found_state::FoundState;
pub use height_bounds::HeightBounds;
pub use height_map::{HeightMap, HeightMapError, MAX_SIDE, MAX_TEXELS};
pub use heights_hash::HeightsHash;
pub use hit::{Cost, Hit};
pub use lanes::{Lanes, LanesError};
pub use metric::{Metric, MetricError};
pub use motif_tree::{
    BYTES_PER_TILE_TRIANGLE, MOST_IN_A_TILE, MotifTree, MotifTreeError, TREE_SHIFT, TileTriangle,
};
pub use path::{Path, PathMetric, RayUse};
/// The SIMD vectors in which [`Lanes::run`] runs code.
pub use pulp;
pub use pyramid::{MaxPyramid, MinPyramid};
pub use slice_axis::SliceAxis;
pub use tangent_frame::{TangentFrame, TangentFrameError};
pub use texel_mask::TexelMask;
pub use volume::{MAX_SLICES, SliceLayout, Volume, VolumeCell, VolumeError, VolumeHit};
pub use watch::{Cancelled, Watch};
pub use wrap::Wrap;
