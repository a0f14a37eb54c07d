//! A scene to a picture, on the backend that was asked for.

use std::time::{Duration, Instant};

use relief_core::exact::FastTracer;
use relief_maps::{Account, Maps, MapsError, Watch};
use relief_shaders::Selection;

use crate::cpu;
#[cfg(feature = "gpu")]
use crate::gpu::{AdapterChoice, Gpu, GpuError};
use crate::job::Rendering;
use crate::prepare::Prepared;
use crate::raycast::RayCaster;
use crate::scene::{BackendChoice, Sampling, Scene};

/// A finished picture and how it came about.
#[derive(Debug)]
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
    /// How the baked maps came about that the method reads.
    pub maps: Vec<Account>,
    /// Time of the rendering alone.
    pub elapsed: Duration,
}

/// What a renderer is at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// It bakes a map of that kind.
    Baking(&'static str),
    /// It makes the picture.
    Rendering,
}

/// Is told what a renderer is at, and the part of it that is done, from 0 to 1, from any thread.
pub type Progress<'a> = dyn Fn(Task, f32) + Sync + 'a;

/// Why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum RenderError {
    /// A baked map that the method reads cannot be provided.
    #[error(transparent)]
    Maps(#[from] MapsError),
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

/// Renders a scene. The baked maps that its method reads are those of the provider.
///
/// # Errors
///
/// When a baked map cannot be provided, the backend is not available, or the backend fails.
pub fn render(scene: &Scene, maps: &mut Maps, progress: &Progress) -> Result<Rendered, RenderError> {
    let selection = *scene.selection();
    let chosen = choose(scene)?;
    let baking = |kind, part| progress(Task::Baking(kind), part);
    let watch = Watch { baking: &baking, ..Watch::none() };
    let provided = maps.provide(&selection, scene.height_map(), scene.metric(), &watch)?;
    let rendering = |part| progress(Task::Rendering, part);
    let started = Instant::now();
    let prepared = Prepared::new(scene, provided.slots());
    let (rendering, backend, device, reason) = match chosen {
        #[cfg(feature = "gpu")]
        Chosen::Gpu { gpu, reason } => {
            let picture = gpu.render(&prepared.job(), scene.sampling(), &rendering)?;
            (picture, "gpu", gpu.description(), reason)
        }
        Chosen::Cpu { reason } => {
            let base = RayCaster::new(scene.mesh());
            let tracer = selection.is_exact().then(|| FastTracer::new(scene.height_map()));
            let picture = cpu::render(&prepared.job(), &base, tracer.as_ref(), &rendering);
            let threads = rayon::current_num_threads();
            let device = format!("{threads} thread{}", if threads == 1 { "" } else { "s" });
            (picture, "cpu", device, reason)
        }
    };
    let elapsed = started.elapsed();
    let (_, maps) = provided.into_parts();
    Ok(Rendered { rendering, backend, device, reason, selection, maps, elapsed })
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
