//! The shaders as Rust: the same functions, translated, with the same bits in exact sampling.
//!
//! * [`MethodTracer`] traces rays through a method.
//! * [`Program`] is the whole shader over everything in [`Bound`], for renderers.
//! * [`Program::trace_block`] and [`MethodTracer::first_hits`] trace many paths at once, in SIMD
//!   lanes.
//! * [`MethodTracer::explain`] returns every turn of a method's loops.
//! * The other structs are the shaders' own, and [`Shared`] has their bytes in a GPU's buffers.

use crate::SlotMaps;

mod background;
mod bytes;
mod convert;
mod explain;
#[path = "../../generated/cpu.rs"]
#[rustfmt::skip]
#[allow(missing_docs, unused, unused_lifetimes, unused_qualifications, clippy::all)]
mod generated;
mod lanes;
#[path = "../../generated/layout.rs"]
#[rustfmt::skip]
#[allow(missing_docs, unused_imports, clippy::all)]
mod layout;
mod method_tracer;
mod procedure;
mod program;
mod runtime;
mod tessellator;
mod triangle;

pub use background::background_row;
pub use bytes::{Shared, read_all, write_all};
pub use explain::{Explanation, Mark};
pub use generated::{
    BaseSite, BaseVertex, Choice, Corner, DicePlace, DicePoint, DiceRows, DiceTriangle, Entered, FirstHit,
    Frame, Gathered, Hit, Light, LightRay, LightView, MapSettings, Path, PixelIn, PixelOut, SearchResult,
    Shell, SurfaceSettings, Sweep, SweptColumn, Tessellation, Toward, Voxel,
};
pub use lanes::{
    BLOCK, EnteredBlock, HitBlock, LightPoint, PathBlock, PixelOutBlock, Row, TriangleRays, places,
};
pub use layout::{
    BaseEdge, BasePatch, Face, PassSettings, Probe, PyramidPass, Record, ScreenSettings, ShellNode, Tally,
    TessellationTotals,
};
pub use method_tracer::MethodTracer;
/// A vector of the shaders.
pub use naga_rust_rt::{Vec2, Vec3, Vec4};
pub(crate) use procedure::procedure_rows;
pub use program::Program;
pub use runtime::{ColorTexture, HeightTexture, HoleTexture, MapTexture};
pub use tessellator::Tessellator;
pub use triangle::Triangle;

/// The settings and textures of a [`Program`].
#[derive(Clone, Copy, Debug)]
pub struct Bound<'a> {
    /// Settings of the frame.
    pub frame: Frame,
    /// Settings of the surface.
    pub surface_settings: SurfaceSettings,
    /// Heights.
    pub height_map: HeightTexture<'a>,
    /// Holes.
    pub hole_map: HoleTexture<'a>,
    /// Linear colours.
    pub color_map: ColorTexture<'a>,
    /// Normals in tangent space.
    pub normal_map: ColorTexture<'a>,
    /// Occlusion, roughness and metalness in the first layer, linear emission in the second.
    pub material_map: ColorTexture<'a>,
    /// Baked maps in their slots.
    pub maps: SlotMaps<'a>,
}
