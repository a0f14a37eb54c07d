//! The adapter that these tests run on.

use std::sync::OnceLock;

use relief_render::gpu::{AdapterChoice, Gpu, GpuRenderer, Prober};

use crate::adapter;

/// A software GPU; hardware may contract and reorder arithmetic, which these tests do not allow.
fn open() -> Option<Gpu> {
    adapter::open(AdapterChoice::Software)
}

/// The software GPU that tests share.
fn software() -> Option<&'static Gpu> {
    static GPU: OnceLock<Option<Gpu>> = OnceLock::new();
    GPU.get_or_init(open).as_ref()
}

/// A prober on a device of its own.
pub fn own_prober() -> Option<Prober> {
    open().map(Prober::new)
}

/// A prober on the shared device.
pub fn prober() -> Option<Prober> {
    software().cloned().map(Prober::new)
}

/// A renderer on it.
pub fn renderer() -> Option<GpuRenderer> {
    software().cloned().map(GpuRenderer::new)
}
