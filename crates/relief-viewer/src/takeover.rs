//! A GPU that takes over from the CPU. The CPU draws at once; meanwhile the GPU's programs are compiled
//! beside it and its frames are timed. From then on the faster of the two draws, until the GPU fails.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use relief_core::Watch;
use relief_maps::Maps;
use relief_render::gpu::{AdapterChoice, Gpu, GpuError};
use relief_render::{RenderError, RenderInfo, Renderer};
use relief_scene::{BackendChoice, Sampling, Scene};
use relief_shaders::STAGES;

/// Number of times that a GPU may be lost before it is left alone.
const MOST_LOSSES: u32 = 3;

/// Size of the picture for which programs are compiled.
const SMALL: [u32; 2] = [16, 12];

/// Number of frames that are timed. The first one allocates memory of the picture's size.
const FRAMES: u32 = 2;

/// The device that the views of a viewer share.
#[derive(Clone, Debug, Default)]
pub struct Device(Arc<Mutex<Opened>>);

/// What is known of the device.
#[derive(Debug, Default)]
struct Opened {
    gpu: Option<Gpu>,
    /// Number of times that it was lost, which tells apart what was made for it.
    losses: u32,
    /// Whether there is none, or it is left alone.
    is_given_up: bool,
}

/// The GPU's part in one view.
#[derive(Debug)]
pub struct Takeover {
    device: Device,
    beside: Arc<Mutex<Beside>>,
    /// Least seconds for a sample on the CPU, of scenes with the same programs.
    on_cpu: Option<(Programs, f64)>,
}

/// What there is beside the CPU.
#[derive(Debug)]
enum Beside {
    /// Nothing yet, or a renderer that waits for its next scene.
    Idle(Option<Made>),
    /// Work goes on in the background.
    Away,
    /// A renderer that has drawn a scene with these programs, in least seconds for a sample.
    Ready(Made, Programs, f64),
    /// The GPU, after some losses, cannot draw scenes with these programs.
    Refused(Programs, u32),
}

/// A renderer, and the losses of the device before it was made.
#[derive(Debug)]
struct Made {
    renderer: Box<Renderer>,
    losses: u32,
}

/// What a scene's programs depend on: of each surface the variants, and whether it has two sides.
#[derive(Clone, Debug, PartialEq)]
struct Programs(Vec<([u32; STAGES.len()], bool)>);

/// The GPU's renderer while it draws a picture.
#[derive(Debug)]
pub struct Taken {
    made: Made,
    programs: Programs,
    seconds: f64,
}

/// Work in the background: a device is opened, programs are compiled, frames are timed.
#[derive(Debug)]
pub struct Warming {
    device: Device,
    beside: Arc<Mutex<Beside>>,
    made: Option<Made>,
    scene: Scene,
    maps: Maps,
}

impl Takeover {
    #[cfg_attr(
        target_arch = "wasm32",
        expect(clippy::arc_with_non_send_sync, reason = "the web has one thread")
    )]
    pub fn new(device: Device) -> Self {
        Self { device, beside: Arc::new(Mutex::new(Beside::Idle(None))), on_cpu: None }
    }

    /// Whether the GPU draws a scene, since it is ready and faster than the CPU.
    pub fn draws(&self, scene: &Scene) -> bool {
        let (programs, losses) = (Programs::of(scene), locked(&self.device.0).losses);
        let Beside::Ready(made, of, seconds) = &*locked(&self.beside) else { return false };
        let is_slower = self.on_cpu.as_ref().is_some_and(|(of, on_cpu)| *of == programs && on_cpu < seconds);
        scene.backend() == BackendChoice::Auto && *of == programs && !is_slower && made.losses == losses
    }

    /// Takes the GPU's renderer for a picture, if the GPU [draws](Self::draws) it.
    pub fn take(&self, scene: &Scene) -> Option<Taken> {
        if !self.draws(scene) {
            return None;
        }
        let mut beside = locked(&self.beside);
        match std::mem::replace(&mut *beside, Beside::Away) {
            Beside::Ready(made, programs, seconds) => Some(Taken { made, programs, seconds }),
            other => {
                *beside = other;
                None
            }
        }
    }

    /// Puts a renderer back that has drawn a picture, or was told to stop.
    pub fn give_back(&self, taken: Taken, scene: &Scene, drawn: Option<&RenderInfo>) {
        let Taken { made, programs, seconds } = taken;
        let seconds = drawn.map_or(seconds, |info| seconds.min(per_sample(scene, info)));
        *locked(&self.beside) = Beside::Ready(made, programs, seconds);
    }

    /// Gives up a renderer that has failed.
    pub fn fail(&self, taken: Taken, error: &RenderError) {
        self.device.note(error, taken.made.losses);
        *locked(&self.beside) = after(error, taken.programs, taken.made.losses);
    }

    /// Notes how long the CPU took.
    pub fn cpu_drew(&mut self, scene: &Scene, info: &RenderInfo) {
        let (programs, seconds) = (Programs::of(scene), per_sample(scene, info));
        let least = match &self.on_cpu {
            Some((of, least)) if *of == programs => seconds.min(*least),
            _ => seconds,
        };
        self.on_cpu = Some((programs, least));
    }

    /// Returns what is to be done in the background for a scene that the CPU has drawn, if anything is.
    pub fn warming(&self, scene: &Scene, maps: &Maps) -> Option<Warming> {
        self.device.look();
        let device = locked(&self.device.0);
        if device.is_given_up || scene.backend() != BackendChoice::Auto {
            return None;
        }
        let mut beside = locked(&self.beside);
        let programs = Programs::of(scene);
        let made = match &mut *beside {
            Beside::Away => return None,
            Beside::Refused(of, losses) if *of == programs && *losses == device.losses => return None,
            Beside::Ready(made, of, _) if *of == programs && made.losses == device.losses => return None,
            other => match std::mem::replace(other, Beside::Away) {
                Beside::Ready(made, ..) | Beside::Idle(Some(made)) => Some(made),
                Beside::Away | Beside::Idle(None) | Beside::Refused(..) => None,
            },
        };
        *beside = Beside::Away;
        let made = made.filter(|made| made.losses == device.losses);
        let (device, beside) = (self.device.clone(), Arc::clone(&self.beside));
        Some(Warming { device, beside, made, scene: scene.clone(), maps: maps.clone() })
    }
}

impl Taken {
    /// Returns the renderer.
    pub fn renderer(&mut self) -> &mut Renderer {
        &mut self.made.renderer
    }
}

impl Warming {
    /// Does the work. Where the GPU works, the thread goes on.
    pub async fn run(self) {
        let Self { device, beside, made, scene, mut maps } = self;
        let programs = Programs::of(&scene);
        let losses = locked(&device.0).losses;
        let ended = match made {
            Some(made) => Ok(made),
            None => device.open().await.map(|(gpu, losses)| {
                let renderer = Box::new(Renderer::on_gpu(gpu, Sampling::Exact));
                Made { renderer, losses }
            }),
        };
        let ended = match ended {
            Ok(made) => timed(made, &scene, &mut maps).await,
            Err(error) => Err(error.into()),
        };
        let after = match ended {
            Ok((made, seconds)) => Beside::Ready(made, programs, seconds),
            Err(error) => {
                device.note(&error, losses);
                after(&error, programs, losses)
            }
        };
        *locked(&beside) = after;
    }
}

/// What is left after an error: another scene may go well.
fn after(error: &RenderError, programs: Programs, losses: u32) -> Beside {
    match error {
        RenderError::Gpu(GpuError::Lost(_)) => Beside::Idle(None),
        _ => Beside::Refused(programs, losses),
    }
}

/// Compiles the programs of a scene, and times its frames for a screen. Returns the least seconds for a sample.
async fn timed(mut made: Made, scene: &Scene, maps: &mut Maps) -> Result<(Made, f64), RenderError> {
    let quiet = Watch::none();
    let sized = |[width, height]: [u32; 2], samples| {
        scene.to_builder().size(width, height).samples(samples).build().unwrap_or_else(|_| scene.clone())
    };
    let (small, whole) = (sized(SMALL, scene.samples()), sized(scene.size(), 1));
    made.renderer.render_bands_async(&small, maps, false, &quiet, &mut |_| Ok(())).await?;
    let mut least = f64::INFINITY;
    for _ in 0..FRAMES {
        if let Some((_, info)) = made.renderer.screen_async(&whole, maps, &quiet).await? {
            least = least.min(per_sample(&whole, &info));
        }
    }
    Ok((made, least))
}

impl Device {
    /// Takes a GPU that is open.
    pub fn of(gpu: Gpu) -> Self {
        Self(Arc::new(Mutex::new(Opened { gpu: Some(gpu), ..Opened::default() })))
    }

    /// Opens the device unless it is open, and returns it with the number of losses before.
    async fn open(&self) -> Result<(Gpu, u32), GpuError> {
        let (open, losses) = {
            let opened = locked(&self.0);
            (opened.gpu.clone(), opened.losses)
        };
        let gpu = match open {
            Some(gpu) => gpu,
            None => Gpu::open(AdapterChoice::Real).await.inspect_err(|_| {
                // A machine without a GPU does not get one.
                locked(&self.0).is_given_up = true;
            })?,
        };
        let mut opened = locked(&self.0);
        opened.gpu = Some(gpu.clone());
        Ok((gpu, losses))
    }

    /// Notes an error of what was made after some losses.
    fn note(&self, error: &RenderError, losses: u32) {
        let mut opened = locked(&self.0);
        if matches!(error, RenderError::Gpu(GpuError::Lost(_))) && opened.losses == losses {
            opened.lose();
        }
    }

    /// Looks whether the device was lost meanwhile, which another error may have hidden.
    fn look(&self) {
        let mut opened = locked(&self.0);
        if opened.gpu.as_ref().is_some_and(Gpu::is_lost) {
            opened.lose();
        }
    }
}

impl Opened {
    fn lose(&mut self) {
        self.gpu = None;
        self.losses += 1;
        self.is_given_up |= self.losses >= MOST_LOSSES;
    }
}

impl Programs {
    fn of(scene: &Scene) -> Self {
        let of_surface = |surface: &relief_scene::Surface| {
            (surface.selection().choices.map(|choice| choice.number), surface.two_sided())
        };
        Self(scene.surfaces().iter().map(of_surface).collect())
    }
}

/// Seconds for a sample of a pixel.
fn per_sample(scene: &Scene, info: &RenderInfo) -> f64 {
    let pixels: f64 = scene.size().map(f64::from).iter().product();
    info.elapsed.as_secs_f64() / (pixels * f64::from(scene.samples())).max(1.0)
}

/// What another thread left is whole: it changes by single assignments.
fn locked<T>(what: &Mutex<T>) -> MutexGuard<'_, T> {
    what.lock().unwrap_or_else(PoisonError::into_inner)
}
