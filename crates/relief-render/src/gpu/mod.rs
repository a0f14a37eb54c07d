//! GPU backend: the linked shaders on `wgpu`.
//!
//! A picture takes two passes. The first rasterises the base mesh and traces every fragment's ray
//! through the relief; a fragment whose ray misses the relief is discarded, so that the surface
//! behind it shows. The second shades each pixel once. Rays are made from pixel and triangle, not
//! from interpolated attributes. So the picture differs from the CPU's only by rounding, and where
//! the two disagree on which triangle covers a pixel.
//!
//! Pyramids of heights, which two searches read, are built on the GPU, too, and rebuilt when the
//! heights change.

mod adapter;
mod device;
mod draw_call;
mod error;
mod layouts;
mod light_map;
mod pass_clock;
mod pipelines;
mod probe;
mod program_cache;
mod programs;
mod promise;
mod pyramid;
mod renderer;
mod resident;
mod shells;
mod stencil;
mod targets;
mod tessellate;
#[cfg(test)]
mod tests;
mod textures;

pub use adapter::AdapterChoice;
pub use device::Gpu;
pub use error::GpuError;
pub use probe::Prober;
pub use renderer::{GpuRenderer, Work};
