//! Renderer of scenes on the CPU or a GPU.

use std::ops::Range;
use std::time::Duration;

use relief_core::{Cancelled, Lanes, Watch};
use relief_maps::{Account, Maps};
#[cfg(feature = "gpu")]
use relief_shaders::MapNeed;
use relief_shaders::cpu::PixelOut;
use relief_shaders::wgsl::Sampling;
use web_time::Instant;

use crate::block_on;
use crate::cpu::CpuRenderer;
use crate::error::RenderError;
use crate::frame_time::FrameTime;
#[cfg(feature = "gpu")]
use crate::gpu::{AdapterChoice, Gpu, GpuError, GpuRenderer, Work};
use crate::job::{Job, Rendering};
use crate::prepare::Preparer;
use relief_scene::{BackendChoice, Scene, Surface};

/// A rendered picture, with the backend, maps and time that it took.
#[derive(Debug)]
pub struct Rendered {
    /// The pixels.
    pub rendering: Rendering,
    /// Backend, baked maps and time.
    pub info: RenderInfo,
}

/// Backend, device, baked maps and time of a rendering.
#[derive(Debug)]
pub struct RenderInfo {
    /// Backend: "cpu" or "gpu".
    pub backend: &'static str,
    /// Device: the number of threads, or the adapter and its driver.
    pub device: String,
    /// Reason for the backend if it was chosen automatically, else `None`.
    pub reason: Option<Reason>,
    /// Origin of each baked map that the methods read.
    pub maps: Vec<Account>,
    /// Time of the rendering, with preparing and uploading, without baking.
    pub elapsed: Duration,
}

/// Reason for an automatically chosen backend.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Reason {
    /// A hardware GPU was found.
    #[error("a GPU was found")]
    GpuFound,
    /// No adapter was found.
    #[error("no GPU was found")]
    NoGpu,
    /// Only software adapters were found. They are used only when a GPU is asked for.
    #[error("no hardware GPU was found, only {}", .0.join(" and "))]
    SoftwareOnly(Vec<String>),
    /// A GPU was found and cannot be used.
    #[cfg(feature = "gpu")]
    #[error(transparent)]
    Unusable(GpuError),
    /// This build has no GPU backend.
    #[error("this build has no GPU backend")]
    NotBuilt,
}

/// Name of the [task](Watch::task) that renders the picture. Baking comes before it, as one task
/// for each kind of map, with the kind's name.
pub const RENDERING: &str = "rendering";

/// Callback for the pixels of a band of whole rows. Bands come from the top of the picture to its
/// bottom. An error cancels the rendering.
pub type Bands<'a> = dyn FnMut(&[PixelOut]) -> Result<(), Cancelled> + 'a;

/// Renders scenes and caches what they share, such as meshes, maps and shaders. A second frame of
/// the same scene costs only its pixels.
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
    /// Creates a renderer for `backend` that reads textures by `sampling`. [`BackendChoice::Auto`]
    /// takes a hardware GPU if there is one, else the CPU. It waits for the GPU, which the web does
    /// not allow: use [`Self::open`] there.
    ///
    /// # Errors
    ///
    /// When a GPU is asked for and there is none, or when the CPU is asked for [`Sampling::Fast`].
    pub fn new(backend: BackendChoice, sampling: Sampling) -> Result<Self, RenderError> {
        block_on(Self::open(backend, sampling))
    }

    /// Creates a renderer like [`Self::new`], without blocking the thread.
    ///
    /// # Errors
    ///
    /// See [`Self::new`].
    pub async fn open(backend: BackendChoice, sampling: Sampling) -> Result<Self, RenderError> {
        let (backend, reason) = choose(backend, sampling).await?;
        let no_gpu = reason.is_some();
        if sampling == Sampling::Fast && matches!(backend, Backend::Cpu(_)) {
            return Err(RenderError::FastOnCpu { no_gpu });
        }
        Ok(Self { backend, reason, preparer: Preparer::default() })
    }

    /// Creates a renderer on the CPU.
    pub fn on_cpu() -> Self {
        let backend = Backend::Cpu(Box::default());
        Self { backend, reason: None, preparer: Preparer::default() }
    }

    /// Creates a renderer on `gpu` that reads textures by `sampling`.
    #[cfg(feature = "gpu")]
    pub fn on_gpu(gpu: Gpu, sampling: Sampling) -> Self {
        let backend = Backend::Gpu(Box::new(GpuRenderer::new(gpu)), sampling);
        Self { backend, reason: None, preparer: Preparer::default() }
    }

    /// Sets the SIMD width of the CPU backend. Default: the widest that the machine has. Pictures
    /// have the same bits for all widths. On a GPU it does nothing.
    pub fn set_lanes(&mut self, lanes: Lanes) {
        match &mut self.backend {
            #[cfg(feature = "gpu")]
            Backend::Gpu(..) => {}
            Backend::Cpu(renderer) => renderer.set_lanes(lanes),
        }
    }

    /// Renders a scene. The scene's own choice of backend and sampling is ignored: the renderer has
    /// them already. `maps` provides the baked maps that the methods read. The tasks of `watch` are
    /// the kinds of maps that are baked, then [`RENDERING`], each from 0 to 1. It waits for the GPU,
    /// which the web does not allow: use [`Self::render_async`] there.
    ///
    /// # Errors
    ///
    /// When a baked map cannot be provided, the backend fails, or the work is cancelled.
    pub fn render(&mut self, scene: &Scene, maps: &mut Maps, watch: &Watch) -> Result<Rendered, RenderError> {
        block_on(self.render_async(scene, maps, watch))
    }

    /// Renders a scene like [`Self::render`]. Where the GPU works, the thread goes on; the CPU's work
    /// is done on this thread, without a pause.
    ///
    /// # Errors
    ///
    /// See [`Self::render`].
    pub async fn render_async(
        &mut self,
        scene: &Scene,
        maps: &mut Maps,
        watch: &Watch<'_>,
    ) -> Result<Rendered, RenderError> {
        let (job, accounts, started) = self.prepare(scene, maps, watch)?;
        let watch = watch.task(RENDERING);
        let rendering = match &mut self.backend {
            #[cfg(feature = "gpu")]
            Backend::Gpu(renderer, sampling) => renderer.render_async(&job, *sampling, &watch).await?,
            Backend::Cpu(renderer) => {
                renderer.render(&job, &watch).map_err(|error| RenderError::of_cpu(error, &job))?
            }
        };
        Ok(Rendered { rendering, info: self.info(accounts, started) })
    }

    /// Renders a scene in bands of rows, so that the picture need not fit into memory. `sink` gets
    /// each band when it is done. With `numbers`, pixels are the same as in a [`Rendering`].
    /// Without, only the colour is; the other values come from one of the pixel's samples, which
    /// takes less time. It waits for the GPU, which the web does not allow: use
    /// [`Self::render_bands_async`] there.
    ///
    /// # Errors
    ///
    /// See [`Self::render`]. Also when `sink` cancels the rendering.
    pub fn render_bands(
        &mut self,
        scene: &Scene,
        maps: &mut Maps,
        numbers: bool,
        watch: &Watch,
        sink: &mut Bands,
    ) -> Result<RenderInfo, RenderError> {
        block_on(self.render_bands_async(scene, maps, numbers, watch, sink))
    }

    /// Renders a scene like [`Self::render_bands`]. Where the GPU works, the thread goes on; the
    /// CPU's work is done on this thread, without a pause.
    ///
    /// # Errors
    ///
    /// See [`Self::render_bands`].
    pub async fn render_bands_async(
        &mut self,
        scene: &Scene,
        maps: &mut Maps,
        numbers: bool,
        watch: &Watch<'_>,
        sink: &mut Bands<'_>,
    ) -> Result<RenderInfo, RenderError> {
        self.render_rows_async(scene, maps, 0..u32::MAX, numbers, watch, sink).await
    }

    /// Renders some rows of a scene, counted from the top, like [`Self::render_bands_async`]. Several
    /// renderers can share a picture in this way: on one backend its pixels are the same. Rows below
    /// the picture do not count.
    ///
    /// # Errors
    ///
    /// See [`Self::render_bands`].
    pub async fn render_rows_async(
        &mut self,
        scene: &Scene,
        maps: &mut Maps,
        rows: Range<u32>,
        numbers: bool,
        watch: &Watch<'_>,
        sink: &mut Bands<'_>,
    ) -> Result<RenderInfo, RenderError> {
        let (job, accounts, started) = self.prepare(scene, maps, watch)?;
        let watch = watch.task(RENDERING);
        match &mut self.backend {
            #[cfg(feature = "gpu")]
            Backend::Gpu(renderer, sampling) => {
                renderer.render_rows_async(&job, *sampling, rows, numbers, &watch, sink).await?;
            }
            Backend::Cpu(renderer) => renderer
                .render_rows(&job, rows, numbers, &watch, sink)
                .map_err(|error| RenderError::of_cpu(error, &job))?,
        }
        Ok(self.info(accounts, started))
    }

    /// Measures the time of a frame; the picture is dropped. On the CPU the first frame of a scene
    /// takes longer, because it includes the preparation.
    ///
    /// # Errors
    ///
    /// See [`Self::render`].
    pub fn time(&mut self, scene: &Scene, maps: &mut Maps, watch: &Watch) -> Result<FrameTime, RenderError> {
        let (job, _, started) = self.prepare(scene, maps, watch)?;
        match &mut self.backend {
            #[cfg(feature = "gpu")]
            Backend::Gpu(renderer, sampling) => Ok(renderer.time(&job, *sampling)?),
            Backend::Cpu(renderer) => {
                renderer
                    .render_rows(&job, 0..job.height, false, &watch.task(RENDERING), &mut |_| Ok(()))
                    .map_err(|error| RenderError::of_cpu(error, &job))?;
                Ok(FrameTime { elapsed: started.elapsed(), ..FrameTime::default() })
            }
        }
    }

    /// Backend: "cpu" or "gpu".
    pub fn backend(&self) -> &'static str {
        match &self.backend {
            #[cfg(feature = "gpu")]
            Backend::Gpu(..) => "gpu",
            Backend::Cpu(_) => "cpu",
        }
    }

    /// Device: the number of threads, or the adapter and its driver.
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

    fn info(&self, maps: Vec<Account>, started: Instant) -> RenderInfo {
        RenderInfo {
            backend: self.backend(),
            device: self.device(),
            reason: self.reason.clone(),
            maps,
            elapsed: started.elapsed(),
        }
    }

    /// Draws a scene into a texture that stays on the GPU, for the caller to show. It holds linear
    /// colours in 16-bit floats. Returns `None` on the CPU. The next call draws over the texture.
    ///
    /// # Errors
    ///
    /// See [`Self::render`].
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

    /// Renders a scene into a picture for screens on the GPU: red, green, blue and 255 of each pixel in
    /// sRGB, row by row from the top. Each byte is the one of [`picture::srgb8`](crate::picture::srgb8),
    /// or a neighbour; it comes sooner, since exposure and tone curve are applied on the GPU. Returns
    /// `None` on the CPU.
    ///
    /// # Errors
    ///
    /// See [`Self::render`].
    #[cfg(feature = "gpu")]
    pub async fn screen_async(
        &mut self,
        scene: &Scene,
        maps: &mut Maps,
        watch: &Watch<'_>,
    ) -> Result<Option<(Vec<u8>, RenderInfo)>, RenderError> {
        if matches!(self.backend, Backend::Cpu(_)) {
            return Ok(None);
        }
        let (job, accounts, started) = self.prepare(scene, maps, watch)?;
        let (gain, tone) = (scene.exposure().exp2(), scene.tone());
        match &mut self.backend {
            Backend::Gpu(renderer, sampling) => {
                let picture = renderer.screen_async(&job, *sampling, gain, tone).await?;
                watch.task(RENDERING).at(1.0)?;
                Ok(Some((picture, self.info(accounts, started))))
            }
            Backend::Cpu(_) => Ok(None),
        }
    }

    /// Uploads, compiled programs and built maps of the last picture; zeros on the CPU.
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

/// Renders a scene once, on the backend and with the sampling that it names. `maps` provides the
/// baked maps that the methods read. For several pictures, use a [`Renderer`].
///
/// # Errors
///
/// When a baked map cannot be provided, the backend is not available or fails, or the work is
/// cancelled.
pub fn render(scene: &Scene, maps: &mut Maps, watch: &Watch) -> Result<Rendered, RenderError> {
    Renderer::new(scene.backend(), scene.sampling())?.render(scene, maps, watch)
}

#[cfg(feature = "gpu")]
async fn choose(
    backend: BackendChoice,
    sampling: Sampling,
) -> Result<(Backend, Option<Reason>), RenderError> {
    let on_gpu = |gpu| Backend::Gpu(Box::new(GpuRenderer::new(gpu)), sampling);
    let on_cpu = || Backend::Cpu(Box::default());
    match backend {
        BackendChoice::Cpu => Ok((on_cpu(), None)),
        BackendChoice::Gpu => Ok((on_gpu(Gpu::open(AdapterChoice::Any).await?), None)),
        BackendChoice::Auto => Ok(match Gpu::open(AdapterChoice::Real).await {
            Ok(gpu) => (on_gpu(gpu), Some(Reason::GpuFound)),
            Err(error) => (on_cpu(), Some(why_not(error))),
        }),
    }
}

/// Reason for the CPU where the choice was automatic.
#[cfg(feature = "gpu")]
fn why_not(error: GpuError) -> Reason {
    match error {
        GpuError::NoAdapter { found, .. } if found.is_empty() => Reason::NoGpu,
        GpuError::NoAdapter { found, .. } => Reason::SoftwareOnly(found),
        other => Reason::Unusable(other),
    }
}

#[cfg(not(feature = "gpu"))]
async fn choose(backend: BackendChoice, _: Sampling) -> Result<(Backend, Option<Reason>), RenderError> {
    let on_cpu = Backend::Cpu(Box::default());
    match backend {
        BackendChoice::Gpu => Err(RenderError::NoGpuBackend),
        BackendChoice::Auto => Ok((on_cpu, Some(Reason::NotBuilt))),
        BackendChoice::Cpu => Ok((on_cpu, None)),
    }
}
