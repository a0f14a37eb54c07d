//! Renders pictures of scenes on the CPU, or on a GPU through wgpu.
//!
//! [`render()`] renders one picture of a [`Scene`](relief_scene::Scene). A [`Renderer`] renders
//! several and caches what they share. Both backends run the same shaders and give the same
//! picture. [`picture`] converts it to bytes and channels; [`false_color`] shows numbers in colours.
//!
//! ```
//! use relief_core::{HeightMap, Watch, Wrap, mesh::square};
//! use relief_maps::Maps;
//! use relief_render::{picture, render};
//! use relief_scene::{Look, Scene, Surface};
//!
//! let heights = HeightMap::from_fn(64, 64, Wrap::Repeat, |i, j| ((i ^ j) & 8) as f32 / 8.0)?;
//! let surface = Surface::new(square(1)?, heights.with_displacement(0.05, 0.0)?);
//! let scene = Scene::builder(surface).look(Look::Studio).size(64, 48).build()?;
//! let rendered = render(&scene, &mut Maps::in_memory(), &Watch::none())?;
//! assert_eq!(picture::srgb8(&rendered.rendering, &scene).len(), 64 * 48 * 3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod cpu;
mod error;
pub mod false_color;
mod frame_cache;
mod frame_time;
pub mod glyphs;
#[cfg(feature = "gpu")]
pub mod gpu;
pub mod job;
mod light_views;
pub mod mipmaps;
pub mod picture;
mod prepare;
mod renderer;
mod samples;
mod shellcast;
#[cfg(test)]
mod tests;
mod wait;
mod wire;

pub use error::RenderError;
pub use frame_time::{FrameTime, PassTimes};
pub use prepare::GeometryError;
pub use renderer::{Bands, RENDERING, Reason, RenderInfo, Rendered, Renderer, render};
pub use wait::block_on;
#[cfg(feature = "gpu")]
pub use wgpu;
pub use wire::Wire;
