//! A scene to a picture, on the backend that was asked for.

use std::time::{Duration, Instant};

use relief_core::exact::FastTracer;
use relief_shaders::{SearchMapError, Selection};

use crate::cpu;
#[cfg(feature = "gpu")]
use crate::gpu::{AdapterChoice, Gpu, GpuError};
use crate::job::Rendering;
use crate::prepare::Prepared;
use crate::raycast::RayCaster;
use crate::scene::{BackendChoice, Sampling, Scene};

/// A finished picture and how it came about.
#[derive(Clone, Debug)]
pub struct Rendered {
    /// The pixels.
    pub rendering: Rendering,
    /// "cpu" or "gpu".
    pub backend: &'static str,
    /// What the backend is: the number of threads, or the adapter and its driver.
    pub device: String,
    /// Why that backend, when it was chosen automatically.
    pub reason: Option<String>,
    /// What was run.
    pub selection: Selection,
    /// Time of the rendering alone.
    pub elapsed: Duration,
}

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// The search reads a baked map that the scene does not have.
    #[error(transparent)]
    SearchMap(#[from] SearchMapError),
    /// The CPU was asked for the sampling that only GPUs have.
    #[error(
        "sampling 'fast' uses a GPU's texture sampler, which the CPU backend does not have{0}: use --sampling exact"
    )]
    FastOnCpu(&'static str),
    /// The GPU backend was asked for and is not in this build.
    #[error("this build has no GPU backend: build with the feature 'gpu', or use --backend cpu")]
    NoGpuBackend,
    /// The GPU failed.
    #[cfg(feature = "gpu")]
    #[error(transparent)]
    Gpu(#[from] GpuError),
}

/// Renders a scene. `progress` is told the finished part, from 0 to 1, from any thread.
///
/// # Errors
///
/// When the search lacks the baked map that it reads, the backend is not available, or the backend fails.
pub fn render(scene: &Scene, progress: &(dyn Fn(f32) + Sync)) -> Result<Rendered, RenderError> {
    let selection = *scene.selection();
    match choose(scene)? {
        #[cfg(feature = "gpu")]
        Chosen::Gpu { gpu, reason } => {
            let prepared = Prepared::new(scene, &selection)?;
            let started = Instant::now();
            let rendering = gpu.render(&prepared.job(), scene.sampling(), progress)?;
            let elapsed = started.elapsed();
            Ok(Rendered { rendering, backend: "gpu", device: gpu.description(), reason, selection, elapsed })
        }
        Chosen::Cpu { reason } => on_cpu(scene, selection, reason, progress),
    }
}

fn on_cpu(
    scene: &Scene,
    selection: Selection,
    reason: Option<String>,
    progress: &(dyn Fn(f32) + Sync),
) -> Result<Rendered, RenderError> {
    let started = Instant::now();
    let prepared = Prepared::new(scene, &selection)?;
    let base = RayCaster::new(scene.mesh());
    let tracer = selection.is_exact().then(|| FastTracer::new(scene.height_map()));
    let rendering = cpu::render(&prepared.job(), &base, tracer.as_ref(), progress);
    let threads = rayon::current_num_threads();
    let device = format!("{threads} thread{}", if threads == 1 { "" } else { "s" });
    Ok(Rendered { rendering, backend: "cpu", device, reason, selection, elapsed: started.elapsed() })
}

enum Chosen {
    #[cfg(feature = "gpu")]
    Gpu {
        gpu: Gpu,
        reason: Option<String>,
    },
    Cpu {
        reason: Option<String>,
    },
}

#[cfg(feature = "gpu")]
fn choose(scene: &Scene) -> Result<Chosen, RenderError> {
    let fast = scene.sampling() == Sampling::Fast;
    match scene.backend() {
        BackendChoice::Cpu if fast => Err(RenderError::FastOnCpu("")),
        BackendChoice::Cpu => Ok(Chosen::Cpu { reason: None }),
        BackendChoice::Gpu => Ok(Chosen::Gpu { gpu: Gpu::new(AdapterChoice::Any)?, reason: None }),
        BackendChoice::Auto => match Gpu::new(AdapterChoice::Real) {
            Ok(gpu) => Ok(Chosen::Gpu { gpu, reason: Some("a GPU was found".to_owned()) }),
            Err(_) if fast => Err(RenderError::FastOnCpu(", and no GPU was found")),
            Err(error) => Ok(Chosen::Cpu { reason: Some(why_not(&error)) }),
        },
    }
}

/// Why there is no GPU, to someone who did not ask for one.
#[cfg(feature = "gpu")]
fn why_not(error: &GpuError) -> String {
    match error {
        GpuError::NoAdapter { found, .. } if found.is_empty() => "no GPU was found".to_owned(),
        GpuError::NoAdapter { found, .. } => {
            format!("no hardware GPU was found, only {}, which --backend gpu takes", found.join(" and "))
        }
        other => other.to_string(),
    }
}

#[cfg(not(feature = "gpu"))]
fn choose(scene: &Scene) -> Result<Chosen, RenderError> {
    match scene.backend() {
        BackendChoice::Gpu => Err(RenderError::NoGpuBackend),
        _ if scene.sampling() == Sampling::Fast => Err(RenderError::FastOnCpu("")),
        BackendChoice::Auto => Ok(Chosen::Cpu { reason: Some("this build has no GPU backend".to_owned()) }),
        BackendChoice::Cpu => Ok(Chosen::Cpu { reason: None }),
    }
}
