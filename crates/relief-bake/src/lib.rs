//! From a height map to every map that displacement mapping methods read.
//!
//! [`mod@kind`] lists the map kinds, one file each. A bake takes a [`BakeInput`], which is a height map and the [`Metric`](relief_core::Metric) that it
//! is laid out in, and the kind's [`Settings`], and hands its [`Texture`]s to a [`Sink`] slice by slice, so that a volume
//! need not fit in memory. [`Collected`] is the sink that keeps them; [`baked_map()`] makes one of them as shaders
//! take it.
//!
//! Where a kind states a bound, it holds for the *bilinear* surface between texel centres, and for what is stored: when
//! values are quantised, heights are quantised first, the map is baked against the decoded heights, and values are rounded
//! to the safe side.

mod bake;
mod baked_map;
mod fill;
pub mod from_normals;
pub mod kind;
pub mod photometric;
mod progress;
pub mod quantise;
mod settings;
mod sink;

pub use bake::{BakeError, bake, bake_last};
pub use baked_map::{WantedMap, baked_map};
pub use kind::{KINDS, Kind, kind};
pub use progress::{Cancelled, Progress};
pub use settings::{Settings, SettingsError};
pub use sink::{Channel, Collected, CollectedTexture, Shape, Sink, SinkError, Texture};

/// What a bake is made from.
#[derive(Clone, Copy, Debug)]
pub struct BakeInput<'a> {
    /// The height map. When values are quantised its texels are the decoded ones.
    pub map: &'a relief_core::HeightMap,
    /// World lengths of the tile and the relief.
    pub metric: relief_core::Metric,
}
