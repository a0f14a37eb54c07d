//! Scenes to pictures, on the backend that was asked for.

use std::time::Duration;

use relief_core::{Cancelled, Lanes, Watch};
use relief_maps::{Account, Maps};
#[cfg(feature = "gpu")]
use relief_shaders::MapNeed;
use relief_shaders::cpu::PixelOut;
use relief_shaders::wgsl::Sampling;
use web_time::Instant;

use crate::cpu::CpuRenderer;
use crate::error::RenderError;
use crate::frame_time::FrameTime;
#[cfg(feature = "gpu")]
use crate::gpu::{AdapterChoice, Gpu, GpuError, GpuRenderer, Work};
use crate::job::{Job, Rendering};
use crate::prepare::Preparer;
use relief_scene::{BackendChoice, Scene, Surface};

/// A finished picture and how it came about.
#[derive(Debug)]
pub struct Rendered {
    /// The pixels.
    pub rendering: Rendering,
    /// How they were made.
    pub made: Made,
}

/// How a picture was made.
#[derive(Debug)]
pub struct Made {
    /// "cpu" or "gpu".
    pub backend: &'static str,
    /// What the backend is: the number of threads, or the adapter and its driver.
    pub device: String,
    /// Why that backend, when it was chosen automatically.
    pub reason: Option<Reason>,
    /// How the baked maps came about that the methods read.
    pub maps: Vec<Account>,
    /// Time of the rendering alone, with what it prepares and uploads, without baking.
    pub elapsed: Duration,
}

/// Why a backend was chosen.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Reason {
    /// There is a GPU.
    #[error("a GPU was found")]
    GpuFound,
    /// There is none.
    #[error("no GPU was found")]
    NoGpu,
    /// There are software adapters, which are taken only when a GPU is asked for.
    #[error("no hardware GPU was found, only {}", .0.join(" and "))]
    SoftwareOnly(Vec<String>),
    /// The GPU that there is cannot be used.
    #[cfg(feature = "gpu")]
    #[error(transparent)]
    Unusable(GpuError),
    /// This build has no GPU backend.
    #[error("this build has no GPU backend")]
    NotBuilt,
}

/// The [task](Watch::task) in which a renderer makes the picture. Before it, each kind of map that is baked is
/// a task of that kind's name.
pub const RENDERING: &str = "rendering";

/// Takes the pixels of a band of whole rows, from the top of the picture to its bottom. Its error cancels the
/// rendering.
pub type Bands<'a> = dyn FnMut(&[PixelOut]) -> Result<(), Cancelled> + 'a;

/// Renders scenes, and keeps what they have in common from one to the next: a second frame costs its pixels.
#[derive(Debug)]
pub struct Renderer {
    backend: Backend,
    reason: Option<Reason>,
    preparer: Preparer,
}

#[derive(Debug)]
enum Backend {
    Cpu(Box<CpuRenderer>),
    #[cfg(feature = "gpu")]
    Gpu(Box<GpuRenderer>, Sampling),
}

impl Renderer {
    /// A renderer of a kind, which reads textures so: a GPU if there is one, else the CPU, unless one of both
    /// is asked for.
    ///
    /// # Errors
    ///
    /// When a GPU is asked for and there is none, or when the CPU is to sample as only GPUs do.
    pub fn new(backend: BackendChoice, sampling: Sampling) -> Result<Self, RenderError> {
        let (backend, reason) = choose(backend, sampling)?;
        let no_gpu = reason.is_some();
        if sampling == Sampling::Fast && matches!(backend, Backend::Cpu(_)) {
            return Err(RenderError::FastOnCpu { no_gpu });
        }
        Ok(Self { backend, reason, preparer: Preparer::default() })
    }

    /// A renderer on the CPU.
    pub fn on_cpu() -> Self {
        let backend = Backend::Cpu(Box::default());
        Self { backend, reason: None, preparer: Preparer::default() }
    }

    /// A renderer on that GPU.
    #[cfg(feature = "gpu")]
    pub fn on_gpu(gpu: Gpu, sampling: Sampling) -> Self {
        let backend = Backend::Gpu(Box::new(GpuRenderer::new(gpu)), sampling);
        Self { backend, reason: None, preparer: Preparer::default() }
    }

    /// Sets the SIMD width of the CPU backend. Default: the widest that the machine has. Pictures have the
    /// same bits.
    pub fn set_lanes(&mut self, lanes: Lanes) {
        match &mut self.backend {
            #[cfg(feature = "gpu")]
            Backend::Gpu(..) => {}
            Backend::Cpu(renderer) => renderer.set_lanes(lanes),
        }
    }

    /// Renders a scene; its choice of backend and sampling was made when the renderer was. The
    /// provider gives the baked maps that its methods read. The watch's tasks are the kinds of maps that are
    /// baked, then [`RENDERING`], each from 0 to 1.
    ///
    /// # Errors
    ///
    /// When a baked map cannot be provided, the backend fails, or the work is cancelled.
    pub fn render(&mut self, scene: &Scene, maps: &mut Maps, watch: &Watch) -> Result<Rendered, RenderError> {
        let (job, accounts, started) = self.prepare(scene, maps, watch)?;
        let watch = watch.task(RENDERING);
        let rendering = match &mut self.backend {
            #[cfg(feature = "gpu")]
            Backend::Gpu(renderer, sampling) => renderer.render(&job, *sampling, &watch)?,
            Backend::Cpu(renderer) => {
                renderer.render(&job, &watch).map_err(|error| RenderError::of_cpu(error, &job))?
            }
        };
        Ok(Rendered { rendering, made: self.made(accounts, started) })
    }

    /// As [`Self::render`], for pictures that no memory need hold: each band of rows is handed over when it
    /// is done. With `numbers` all numbers of a pixel are as in a [`Rendering`]; else its colour is, and the
    /// rest belong to one of its samples, which takes less time.
    ///
    /// # Errors
    ///
    /// As [`Self::render`], and when the sink cancels the rendering.
    pub fn render_bands(
        &mut self,
        scene: &Scene,
        maps: &mut Maps,
        numbers: bool,
        watch: &Watch,
        sink: &mut Bands,
    ) -> Result<Made, RenderError> {
        let (job, accounts, started) = self.prepare(scene, maps, watch)?;
        let watch = watch.task(RENDERING);
        match &mut self.backend {
            #[cfg(feature = "gpu")]
            Backend::Gpu(renderer, sampling) => {
                renderer.render_bands(&job, *sampling, numbers, &watch, sink)?;
            }
            Backend::Cpu(renderer) => renderer
                .render_bands(&job, numbers, &watch, sink)
                .map_err(|error| RenderError::of_cpu(error, &job))?,
        }
        Ok(self.made(accounts, started))
    }

    /// Draws a scene, keeps nothing of it, and says how long that took. On the CPU a first frame of a scene
    /// takes longer, as it is made ready in it.
    ///
    /// # Errors
    ///
    /// As [`Self::render`].
    pub fn time(&mut self, scene: &Scene, maps: &mut Maps, watch: &Watch) -> Result<FrameTime, RenderError> {
        let (job, _, started) = self.prepare(scene, maps, watch)?;
        match &mut self.backend {
            #[cfg(feature = "gpu")]
            Backend::Gpu(renderer, sampling) => Ok(renderer.time(&job, *sampling)?),
            Backend::Cpu(renderer) => {
                renderer
                    .render_bands(&job, false, &watch.task(RENDERING), &mut |_| Ok(()))
                    .map_err(|error| RenderError::of_cpu(error, &job))?;
                Ok(FrameTime { elapsed: started.elapsed(), ..FrameTime::default() })
            }
        }
    }

    /// "cpu" or "gpu".
    pub fn backend(&self) -> &'static str {
        match &self.backend {
            #[cfg(feature = "gpu")]
            Backend::Gpu(..) => "gpu",
            Backend::Cpu(_) => "cpu",
        }
    }

    /// What the backend is: the number of threads, or the adapter and its driver.
    pub fn device(&self) -> String {
        match &self.backend {
            #[cfg(feature = "gpu")]
            Backend::Gpu(renderer, _) => renderer.gpu().description().to_owned(),
            Backend::Cpu(_) => {
                let threads = rayon::current_num_threads();
                format!("{threads} thread{}", if threads == 1 { "" } else { "s" })
            }
        }
    }

    fn made(&self, maps: Vec<Account>, started: Instant) -> Made {
        Made {
            backend: self.backend(),
            device: self.device(),
            reason: self.reason.clone(),
            maps,
            elapsed: started.elapsed(),
        }
    }

    /// Draws a scene into a picture that stays on the GPU: linear colours in 16-bit floats, for the caller to
    /// show. None on the CPU. The next call draws over it.
    ///
    /// # Errors
    ///
    /// As [`Self::render`].
    #[cfg(feature = "gpu")]
    pub async fn draw(
        &mut self,
        scene: &Scene,
        maps: &mut Maps,
        watch: &Watch<'_>,
    ) -> Result<Option<&wgpu::Texture>, RenderError> {
        let (job, ..) = self.prepare(scene, maps, watch)?;
        match &mut self.backend {
            Backend::Gpu(renderer, sampling) => Ok(Some(renderer.draw(&job, *sampling).await?)),
            Backend::Cpu(_) => Ok(None),
        }
    }

    /// What the last picture took besides the drawing; nothing on the CPU.
    #[cfg(feature = "gpu")]
    pub fn last_work(&self) -> Work {
        match &self.backend {
            Backend::Gpu(renderer, _) => renderer.last_work(),
            Backend::Cpu(_) => Work::default(),
        }
    }

    fn prepare(
        &mut self,
        scene: &Scene,
        maps: &mut Maps,
        watch: &Watch,
    ) -> Result<(Job, Vec<Account>, Instant), RenderError> {
        let accounts = match &self.backend {
            #[cfg(feature = "gpu")]
            Backend::Gpu(renderer, sampling) => {
                let built = |need: &MapNeed| renderer.builds(need, *sampling);
                self.preparer.provide(scene, maps, &built, watch)?
            }
            Backend::Cpu(_) => {
                let is_counted = |surface: &Surface| surface.selection().counts_in_stencil();
                if let Some(surface) = scene.surfaces().iter().position(is_counted) {
                    return Err(RenderError::StencilOnCpu { surface });
                }
                self.preparer.provide(scene, maps, &|_| false, watch)?
            }
        };
        let started = Instant::now();
        Ok((self.preparer.job(scene, watch)?, accounts, started))
    }
}

/// Renders a scene once, on the backend and with the sampling that it names. The provider gives the baked
/// maps that its methods read. For more pictures than one see [`Renderer`].
///
/// # Errors
///
/// When a baked map cannot be provided, the backend is not available or fails, or the work is cancelled.
pub fn render(scene: &Scene, maps: &mut Maps, watch: &Watch) -> Result<Rendered, RenderError> {
    Renderer::new(scene.backend(), scene.sampling())?.render(scene, maps, watch)
}

#[cfg(feature = "gpu")]
fn choose(backend: BackendChoice, sampling: Sampling) -> Result<(Backend, Option<Reason>), RenderError> {
    let on_gpu = |gpu| Backend::Gpu(Box::new(GpuRenderer::new(gpu)), sampling);
    let on_cpu = || Backend::Cpu(Box::default());
    match backend {
        BackendChoice::Cpu => Ok((on_cpu(), None)),
        BackendChoice::Gpu => Ok((on_gpu(Gpu::new(AdapterChoice::Any)?), None)),
        BackendChoice::Auto => Ok(match Gpu::new(AdapterChoice::Real) {
            Ok(gpu) => (on_gpu(gpu), Some(Reason::GpuFound)),
            Err(error) => (on_cpu(), Some(why_not(error))),
        }),
    }
}

/// Why there is no GPU, to someone who did not ask for one.
#[cfg(feature = "gpu")]
fn why_not(error: GpuError) -> Reason {
    match error {
        GpuError::NoAdapter { found, .. } if found.is_empty() => Reason::NoGpu,
        GpuError::NoAdapter { found, .. } => Reason::SoftwareOnly(found),
        other => Reason::Unusable(other),
    }
}

#[cfg(not(feature = "gpu"))]
fn choose(backend: BackendChoice, _: Sampling) -> Result<(Backend, Option<Reason>), RenderError> {
    let on_cpu = Backend::Cpu(Box::default());
    match backend {
        BackendChoice::Gpu => Err(RenderError::NoGpuBackend),
        BackendChoice::Auto => Ok((on_cpu, Some(Reason::NotBuilt))),
        BackendChoice::Cpu => Ok((on_cpu, None)),
    }
}
