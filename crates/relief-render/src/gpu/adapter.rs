//! Choice of a GPU.

#[cfg(not(target_arch = "wasm32"))]
use std::sync::OnceLock;

use wgpu::{Adapter, AdapterInfo, Backends, DeviceType, Features, Instance, InstanceDescriptor, Limits};

use super::GpuError;
use super::tessellate::STORAGE_BUFFERS;

/// Kind of adapter to use among the machine's.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AdapterChoice {
    /// A hardware adapter: discrete, integrated or virtual, in that order. Never a software one.
    #[default]
    Real,
    /// A software adapter, such as Mesa's lavapipe: slow, and the same bits on every machine.
    Software,
    /// A hardware adapter if there is one, else a software one.
    Any,
}

impl AdapterChoice {
    /// Returns the place of a kind of adapter in the order of preference, or `None` if it is not
    /// wanted.
    fn rank(self, kind: DeviceType) -> Option<u32> {
        let rank = match kind {
            DeviceType::DiscreteGpu => 0,
            DeviceType::IntegratedGpu => 1,
            DeviceType::VirtualGpu => 2,
            // A browser names no kind, but for software.
            DeviceType::Other if cfg!(target_arch = "wasm32") => 2,
            DeviceType::Other => 3,
            DeviceType::Cpu => 4,
        };
        let wanted = match self {
            AdapterChoice::Real => rank < 3,
            AdapterChoice::Software => kind == DeviceType::Cpu,
            AdapterChoice::Any => true,
        };
        wanted.then_some(rank)
    }

    /// Finds the best adapter of the kind.
    pub(super) async fn find(self) -> Result<Adapter, GpuError> {
        let adapters = instance().enumerate_adapters(Backends::all()).await;
        let found = adapters.iter().map(|adapter| described(&adapter.get_info())).collect();
        adapters
            .into_iter()
            .filter_map(|adapter| Some((self.rank(adapter.get_info().device_type)?, adapter)))
            .min_by_key(|(rank, _)| *rank)
            .map(|(_, adapter)| adapter)
            .ok_or(GpuError::NoAdapter { wanted: self, found })
    }
}

/// Returns the `wgpu` instance. There is one a process: some drivers crash if several threads load
/// and unload them at once (NVIDIA's on Linux), and loading takes long.
#[cfg(not(target_arch = "wasm32"))]
fn instance() -> &'static Instance {
    static INSTANCE: OnceLock<Instance> = OnceLock::new();
    INSTANCE.get_or_init(new_instance)
}

/// Returns a new `wgpu` instance. A browser has one thread.
#[cfg(target_arch = "wasm32")]
fn instance() -> Instance {
    new_instance()
}

fn new_instance() -> Instance {
    Instance::new(InstanceDescriptor {
        backends: Backends::VULKAN | Backends::METAL | Backends::DX12 | Backends::BROWSER_WEBGPU,
        ..InstanceDescriptor::new_without_display_handle()
    })
}

/// Describes an adapter in one line: name, backend and driver.
pub(super) fn described(info: &AdapterInfo) -> String {
    let driver = [info.driver.as_str(), info.driver_info.as_str()].map(str::trim);
    let driver: Vec<&str> = driver.into_iter().filter(|part| !part.is_empty()).collect();
    let driver = if driver.is_empty() { String::new() } else { format!(", {}", driver.join(" ")) };
    // Browsers keep names to themselves.
    let name = if info.name.trim().is_empty() { "GPU" } else { info.name.trim() };
    format!("{name} ({}{driver})", info.backend)
}

/// Returns the limits to request: WebGPU's reduced defaults, with the adapter's own sizes of
/// textures and buffers.
pub(super) fn limits(adapter: &Adapter) -> Limits {
    let (has, reduced) = (adapter.limits(), Limits::downlevel_defaults());
    Limits {
        max_storage_buffer_binding_size: has.max_storage_buffer_binding_size,
        max_buffer_size: has.max_buffer_size,
        max_storage_buffers_per_shader_stage: has
            .max_storage_buffers_per_shader_stage
            .min(STORAGE_BUFFERS.max(reduced.max_storage_buffers_per_shader_stage)),
        ..reduced.using_resolution(has)
    }
}

/// Pixels of a band of rows, which is traced, shaded and read back at once: 24 MiB of records. With
/// larger bands, slow adapters may take so long that the system resets them. With smaller ones, the
/// mesh is drawn more often.
pub(super) const BAND_PIXELS: u32 = 1 << 18;

/// Pixels of a band on a graphics card: 96 MiB of records. Each band waits for the one before. With
/// smaller bands, waiting takes a tenth of a fast card's frame.
const CARD_BAND_PIXELS: u32 = 1 << 20;

/// Returns the pixels of a band on an adapter of a kind.
pub(super) fn band_pixels(kind: DeviceType) -> u32 {
    if kind == DeviceType::DiscreteGpu { CARD_BAND_PIXELS } else { BAND_PIXELS }
}

/// Returns the features to request, if the adapter has them: for fast sampling, times of passes and
/// stencil buffers.
pub(super) fn features(adapter: &Adapter) -> Features {
    let wanted = Features::FLOAT32_FILTERABLE | Features::TIMESTAMP_QUERY | Features::DEPTH32FLOAT_STENCIL8;
    adapter.features() & wanted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_software_adapter_is_never_taken_for_a_real_one() {
        for kind in [DeviceType::Cpu, DeviceType::Other] {
            assert_eq!(AdapterChoice::Real.rank(kind), None, "{kind:?}");
        }
        for kind in [DeviceType::DiscreteGpu, DeviceType::IntegratedGpu, DeviceType::VirtualGpu] {
            assert!(AdapterChoice::Real.rank(kind).is_some(), "{kind:?}");
            assert_eq!(AdapterChoice::Software.rank(kind), None, "{kind:?}");
            assert!(AdapterChoice::Any.rank(kind) < AdapterChoice::Any.rank(DeviceType::Cpu), "{kind:?}");
        }
    }
}
