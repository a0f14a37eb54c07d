//! The core of Relief: height maps, meshes, rays and the exact first hit.
//!
//! A [`HeightMap`] lies on a [`Mesh`](mesh::Mesh), oriented by a [`TangentFrame`]. A ray takes a
//! [`Path`] through the map and ends at a [`Hit`]. The tracers in [`exact`] find the true hit, by
//! which every faster method is judged.
//!
//! This crate contains no file access, no GPU code and no shader compiler. The project's
//! conventions are documented at their types: texture axes and reconstruction at [`HeightMap`],
//! handedness at [`TangentFrame`], the ray parameter at [`Path`].

pub mod area_mean;
mod baked_map;
mod byte_size;
pub mod camera;
pub mod encoding;
pub mod exact;
mod found;
mod height_bounds;
mod height_map;
mod heights_hash;
pub mod hierarchy;
mod hit;
mod lanes;
pub mod mesh;
mod metric;
pub mod metrics;
pub mod object;
mod path;
mod pyramid;
pub mod raycast;
pub mod registry;
pub mod rng;
mod slice_axis;
mod tangent_frame;
mod texel_mask;
mod watch;
mod wrap;

pub use baked_map::{
    BakedMap, LevelPlace, MAX_LAYERS, MapFormat, MapIdentity, MapLayout, MapLayoutError, MapTexels,
};
pub use byte_size::{BadByteSize, ByteSize};
pub use encoding::Rounding;
pub use found::FoundState;
pub use height_bounds::HeightBounds;
pub use height_map::{HeightMap, HeightMapError, MAX_SIDE, MAX_TEXELS};
pub use heights_hash::HeightsHash;
pub use hit::{Cost, Hit};
pub use lanes::{Lanes, LanesError};
pub use metric::{Metric, MetricError};
pub use path::{Path, PathMetric, RayUse};
/// The SIMD vectors in which [`Lanes::run`] runs code.
pub use pulp;
pub use pyramid::{MaxPyramid, MinPyramid};
pub use slice_axis::SliceAxis;
pub use tangent_frame::{TangentFrame, TangentFrameError};
pub use texel_mask::TexelMask;
pub use watch::{Cancelled, Watch};
pub use wrap::Wrap;
