//! Bakes every map that displacement mapping methods read from a height map.
//!
//! [`mod@kind`] lists the kinds of map, one file each. Code that several kinds share lies beside
//! it. A bake takes a [`BakeInput`], which is a height map with its
//! [`Metric`](relief_core::Metric), and the kind's [`Settings`]. It hands its [`Texture`]s to a
//! [`Sink`] slice by slice, so that a volume need not fit into memory. [`Collected`] is the sink
//! that keeps them all. [`baked_map()`] returns one of them in the form that shaders read.
//!
//! Stated bounds hold for the *bilinear* surface between texel centres, and for the values as
//! stored. Quantised values keep their bounds, too: heights are quantised first, the map is baked
//! from the decoded heights, and values are rounded to the safe side.
//!
//! ```
//! use relief_bake::{Collected, bake, kind};
//! use relief_core::{HeightMap, Metric, Watch, Wrap};
//!
//! let heights = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| ((i ^ j) & 8) as f32 / 8.0)?;
//! let metric = Metric { tile_m: [1.0, 1.0], scale_m: 0.05 };
//! let occlusion = kind("occlusion")?;
//! let mut baked = Collected::default();
//! bake(occlusion, &heights, metric, &occlusion.defaults(), &Watch::none(), &mut baked)?;
//! let visibility = &baked.textures[0].levels[0][0];
//! assert!(visibility.len() == 64 * 64 && visibility.iter().all(|part| (0.0..=1.0).contains(part)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod azimuths;
mod bake;
mod baked_map;
mod cone_search;
pub mod deband;
mod error;
mod fill;
mod fixed_point;
pub mod from_meshes;
pub mod from_normals;
pub mod from_shading;
mod horizon_sweep;
mod input;
pub mod kind;
pub mod photometric;
pub mod quantise;
mod settings;
mod sheared_lines;
mod sink;
mod spectrum;
mod texel_pyramid;
mod transpose;
mod upper_hulls;
mod upper_planes;
pub mod view_dependent;
pub mod volumes;

pub use bake::{bake, bake_last, bits_of_heights};
pub use baked_map::{WantedMap, baked_map};
pub use error::BakeError;
pub use input::BakeInput;
pub use kind::filter_levels::{Filter, filter_level, filter_levels};
pub use kind::{KINDS, Kind, kind};
pub use settings::{Settings, SettingsError};
pub use sink::{Channel, Collected, CollectedTexture, Shape, Sink, SinkError, Texture};
