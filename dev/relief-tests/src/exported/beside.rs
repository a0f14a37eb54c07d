//! Pictures by exports beside the renderer's.

use relief_core::Watch;
use relief_export::{Exported, Options, Placement, Profile, export};
use relief_render::gpu::GpuRenderer;
use relief_render::job::Job;
use relief_shaders::Selection;
use relief_shaders::wgsl::Sampling;

use super::Device;

/// A device; where there is none the test says that it skips, unless one is required.
///
/// # Panics
///
/// When one is required.
pub fn device() -> Option<Device> {
    let device = Device::open();
    let is_required = std::env::var_os("RELIEF_REQUIRE_GPU").is_some_and(|value| value == "1");
    assert!(device.is_some() || !is_required, "RELIEF_REQUIRE_GPU is 1: there is no software adapter");
    if device.is_none() {
        println!("skipped: there is no software adapter");
    }
    device
}

/// A selection in four languages, with depth.
///
/// # Panics
///
/// When it cannot be exported.
pub fn exported(selection: &Selection, placement: Option<Placement>) -> Exported {
    let profiles = vec![Profile::Wgsl, Profile::Spirv13, Profile::Core450, Profile::Hlsl51];
    let options = Options { profiles, placement, depth: true, ..Options::default() };
    export(selection, &options).expect("an export")
}

/// The renderer's linear colours.
///
/// # Panics
///
/// When it makes no picture.
pub fn rendered(device: &Device, job: &Job) -> Vec<[f32; 4]> {
    let mut renderer = GpuRenderer::new(device.gpu());
    let rendering = renderer.render(job, Sampling::Exact, &Watch::none()).expect("a picture");
    rendering.pixels.iter().map(|pixel| pixel.color).map(|of| [of.x, of.y, of.z, of.w]).collect()
}

/// Difference of a picture from another one of the same size.
pub struct Difference {
    /// Pixels with other bits.
    pub bits: usize,
    /// Pixels with a colour that is off by more than rounding explains.
    pub far: usize,
    /// Pixels that show a surface.
    pub covered: usize,
}

/// Returns the difference of two pictures of one size.
///
/// # Panics
///
/// When they are not of one size.
pub fn compare(a: &[[f32; 4]], b: &[[f32; 4]]) -> Difference {
    assert_eq!(a.len(), b.len());
    let count =
        |is_it: &dyn Fn(&[f32; 4], &[f32; 4]) -> bool| a.iter().zip(b).filter(|(a, b)| is_it(a, b)).count();
    Difference {
        bits: count(&|a, b| a.map(f32::to_bits) != b.map(f32::to_bits)),
        far: count(&|a, b| a.iter().zip(b).any(|(a, b)| (a - b).abs() > 1e-4)),
        covered: count(&|a, _| a[3] > 0.0),
    }
}
