//! Pictures of scenes, by two backends: the CPU, which every machine has, and the GPU through wgpu.
//!
//! [`render()`] makes a picture of a [`Scene`](relief_scene::Scene); a [`Renderer`] makes several and keeps
//! what they share. Both backends run the same shaders and give the same picture. [`picture`] turns it into
//! bytes and channels.

pub mod cpu;
mod error;
mod frame_cache;
mod frame_time;
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
mod wire;

pub use error::RenderError;
pub use frame_time::{FrameTime, PassTimes};
pub use prepare::GeometryError;
pub use renderer::{Bands, Made, RENDERING, Reason, Rendered, Renderer, render};
#[cfg(feature = "gpu")]
pub use wgpu;
pub use wire::Wire;
