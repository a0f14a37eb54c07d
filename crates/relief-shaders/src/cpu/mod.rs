//! The shaders as Rust: the same functions, translated, with the same bits in exact sampling.
//!
//! [`Resources`] is what a GPU binds: the [`Settings`] and the maps. Its methods are the shader's functions;
//! [`Resources::shade_pixel`] is a whole pixel.

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
    Choice, Corner, Entered, Found, Hit, Light, MapSettings, Path, PixelIn, PixelOut, Resources, Settings,
};
pub use layout::{Band, Probe, Record, Triangle};
pub use runtime::{ColorTexture, HeightTexture, MapTexture};
