//! From a height map to every map that displacement mapping methods read.
//!
//! [`mod@kind`] lists the map kinds, one file each; what several kinds share lies beside it. A bake takes a
//! [`BakeInput`], which is a height map and the [`Metric`](relief_core::Metric) that it is laid out in, and
//! the kind's [`Settings`]. It hands its [`Texture`]s to a [`Sink`] slice by slice, so that a volume need not
//! fit in memory. [`Collected`] is the sink that keeps them; [`baked_map()`] makes one of them as shaders
//! take it.
//!
//! Where a kind states a bound, it holds for the *bilinear* surface between texel centres, and for what is
//! stored: when values are quantised, heights are quantised first, the map is baked against the decoded
//! heights, and values are rounded to the safe side.

mod azimuths;
mod bake;
mod baked_map;
mod cone_search;
mod error;
mod fill;
mod fixed_point;
pub mod from_meshes;
pub mod from_normals;
mod horizon_sweep;
mod input;
pub mod kind;
pub mod photometric;
pub mod quantise;
mod settings;
mod sheared_lines;
mod sink;
mod texel_pyramid;
mod transpose;
mod upper_hulls;
mod upper_planes;

pub use bake::{bake, bake_last, bits_of_heights};
pub use baked_map::{WantedMap, baked_map};
pub use error::BakeError;
pub use input::BakeInput;
pub use kind::filter_levels::{Filter, filter_level, filter_levels};
pub use kind::{KINDS, Kind, kind};
pub use settings::{Settings, SettingsError};
pub use sink::{Channel, Collected, CollectedTexture, Shape, Sink, SinkError, Texture};
