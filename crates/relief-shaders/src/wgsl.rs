//! The linked shaders, as plain WGSL without imports, for any engine that reads it.
//!
//! Written by `cargo xtask link`. Each comes in two samplings: *exact* loads texels and interpolates in plain arithmetic,
//! which gives the same bits on every machine; *fast* uses the GPU's sampler. What a search reads besides the heights is
//! bound as `search_map`, a texture of one texel where it reads nothing: see [`MapSlot`](crate::MapSlot).

/// Rasterises and traces the base mesh (`vertex_main`, `fragment_main`), then shades every pixel (`shade_main`).
pub const RENDER_EXACT: &str = include_str!("../generated/render_exact.wgsl");

/// [`RENDER_EXACT`] with sampler reads.
pub const RENDER_FAST: &str = include_str!("../generated/render_fast.wgsl");

/// Runs the stages over a list of rays (`probe_main`) and writes every stage's result.
pub const PROBE_EXACT: &str = include_str!("../generated/probe_exact.wgsl");

/// [`PROBE_EXACT`] with sampler reads.
pub const PROBE_FAST: &str = include_str!("../generated/probe_fast.wgsl");
