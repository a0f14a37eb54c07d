//! Scenes, and the two backends that render them: the CPU, which every machine has, and the GPU through wgpu.
//!
//! A [`Scene`](scene::Scene) is built or loaded, and [`render()`] makes a picture of it. Both backends run
//! the same shaders and give the same picture; [`picture`] turns it into bytes and channels.

pub mod background;
pub mod cpu;
pub mod depth_buffer;
mod displaced;
pub mod environment;
mod frame_time;
#[cfg(feature = "gpu")]
pub mod gpu;
mod heights_under;
pub mod job;
mod kept;
mod kept_triangles;
pub mod light;
mod light_views;
pub mod material;
pub mod mipmaps;
mod parts;
pub mod picture;
mod pictures;
mod prepare;
mod renderer;
mod samples;
pub mod scene;
mod shadow_map_size;
mod shellcast;
mod sliced;
mod tessellation;
pub mod tone;
mod triangles;
mod wire;

pub use displaced::GeometryError;
pub use frame_time::{FrameTime, PassTimes};
pub use glam;
/// Cameras, base meshes of which scenes are made, and rays against them; they are the core's.
pub use relief_core::{camera, mesh, raycast};
pub use renderer::{Bands, Made, RENDERING, Reason, RenderError, Rendered, Renderer, render};
#[cfg(feature = "gpu")]
pub use wgpu;
pub use wire::Wire;
