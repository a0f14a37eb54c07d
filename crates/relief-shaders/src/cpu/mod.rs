//! The shaders as Rust: the same functions, translated, with the same bits in exact sampling.
//!
//! [`Resources`] is what a GPU binds: the settings and the maps. Its methods are the shader's functions;
//! [`Resources::shade_pixel`] is a whole pixel.

use crate::SlotMaps;

mod bytes;
mod convert;
#[path = "../../generated/cpu.rs"]
#[rustfmt::skip]
#[allow(missing_docs, unused, unused_lifetimes, unused_qualifications, clippy::all)]
mod generated;
#[path = "../../generated/layout.rs"]
#[rustfmt::skip]
#[allow(missing_docs, unused_imports, clippy::all)]
mod layout;
pub mod runtime;

pub use bytes::{Shared, read_all, write_all};
pub use generated::{
    Choice, Corner, Entered, Found, Frame, Hit, Light, MapSettings, Path, PixelIn, PixelOut, Resources,
    SurfaceSettings,
};
pub use layout::{PassSettings, Probe, Record, Triangle};
pub use runtime::{ColorTexture, HeightTexture, MapTexture};

/// Everything that can be bound.
#[derive(Clone, Copy, Debug)]
pub struct Bound<'a> {
    /// What changes with the frame.
    pub frame: Frame,
    /// What changes with the surface.
    pub surface_settings: SurfaceSettings,
    /// Heights.
    pub height_map: HeightTexture<'a>,
    /// Linear colours.
    pub color_map: ColorTexture<'a>,
    /// Normals in tangent space.
    pub normal_map: ColorTexture<'a>,
    /// Baked maps in their slots.
    pub maps: SlotMaps<'a>,
}
