//! The core of Relief: a [`HeightMap`], the [`Mesh`](mesh::Mesh) that it lies on and the [`TangentFrame`]
//! that lays it there, the [`Path`] that a ray takes through it, the [`Hit`] where the path ends, and the
//! exact answer that every faster method is judged by.
//!
//! No file access, no GPU and no shader compiler lives here. The conventions that the whole project follows
//! are written at the types that carry them: texture axes and reconstruction at [`HeightMap`], handedness at
//! [`TangentFrame`], the ray parameter at [`Path`].

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
/// The vectors that [`Lanes::run`] runs something in.
pub use pulp;
pub use pyramid::{MaxPyramid, MinPyramid};
pub use slice_axis::SliceAxis;
pub use tangent_frame::{TangentFrame, TangentFrameError};
pub use texel_mask::TexelMask;
pub use watch::{Cancelled, Watch};
pub use wrap::Wrap;
