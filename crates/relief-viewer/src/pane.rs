//! One view of a scene: its picture, or numbers of its pixels.

use std::ops::Range;
use std::sync::Arc;

use rayon::prelude::*;
use relief_core::{ByteSize, Cancelled, Lanes, Watch};
use relief_io::Files;
use relief_maps::Maps;
use relief_render::false_color::{Content, Gathered, Judge, Quantity};
use relief_render::picture::{Display, bytes_of};
use relief_render::{Bands, RenderError, RenderInfo, Renderer, block_on};
use relief_scene::{BackendChoice, DEFAULT_MAX_MEMORY, Sampling, Scene, SceneError, SceneReader, SceneSpec};
use relief_shaders::cpu::PixelOut;

use crate::NotDrawn;
use crate::takeover::{Device, Takeover, Warming};

/// What a view keeps from one picture to the next.
#[derive(Debug)]
pub struct Pane {
    reader: SceneReader,
    /// SIMD width of the CPU; none for the widest.
    pub lanes: Option<Lanes>,
    renderer: Option<Made>,
    takeover: Takeover,
    /// Why the CPU draws in place of a GPU that had taken over, until the GPU draws again.
    pub fallen_back: Option<String>,
}

/// A renderer, with what it was made for.
#[derive(Debug)]
struct Made {
    backend: BackendChoice,
    sampling: Sampling,
    renderer: Renderer,
    scene: Scene,
}

/// What a view shows.
pub enum Painted {
    /// Some rows: red, green, blue and 255, from the top.
    Picture(Vec<u8>, Range<u32>),
    /// Numbers or directions, with the picture's pixels.
    Quantity(Content, Vec<PixelOut>),
}

impl Painted {
    /// The rows that were drawn of a picture of this height: the first one, and the one behind the last.
    pub fn rows(&self, height: u32) -> [u32; 2] {
        match self {
            Self::Picture(_, rows) => [rows.start, rows.end],
            Self::Quantity(..) => [0, height],
        }
    }
}

/// Part of a picture.
pub enum Part<'a> {
    /// The picture begins, if need be again.
    Begin,
    /// The next band of rows.
    Band(&'a [PixelOut]),
}

/// All rows of any picture.
const ALL: Range<u32> = 0..u32::MAX;

/// Receiver of the parts of a picture.
pub type Parts<'a> = dyn FnMut(Part<'_>) -> Result<(), Cancelled> + 'a;

impl Pane {
    /// Creates a pane that shares a device with others.
    pub fn new(device: &Device) -> Self {
        Self {
            reader: SceneReader::default(),
            lanes: None,
            renderer: None,
            takeover: Takeover::new(device.clone()),
            fallen_back: None,
        }
    }

    /// Loads a scene within the memory that may be taken.
    pub fn load(&mut self, spec: &SceneSpec, files: &Files, most: ByteSize) -> Result<Scene, SceneError> {
        let most = spec.max_memory.unwrap_or(DEFAULT_MAX_MEMORY).0.min(most.0);
        // Copies share the bytes.
        self.reader.files_mut().clone_from(files);
        self.reader.load(&SceneSpec { max_memory: Some(ByteSize(most)), ..spec.clone() })
    }

    /// Draws the picture of a scene for a screen, if a GPU draws it: each byte is the one of
    /// [`picture`](Self::picture), or a neighbour.
    pub async fn screen(
        &mut self,
        scene: &Scene,
        maps: &mut Maps,
        watch: &Watch<'_>,
    ) -> Result<Option<(Painted, RenderInfo)>, NotDrawn> {
        let drawn = match self.takeover.take(scene) {
            Some(mut taken) => match screen(taken.renderer(), scene, maps, watch).await {
                Err(RenderError::Cancelled(cancelled)) => {
                    self.takeover.give_back(taken, scene, None);
                    return Err(cancelled.into());
                }
                Err(error) => {
                    self.takeover.fail(taken, &error);
                    self.fallen_back = Some(error.to_string());
                    None
                }
                Ok(drawn) => {
                    self.takeover.give_back(taken, scene, drawn.as_ref().map(|(_, info)| info));
                    self.fallen_back = None;
                    drawn
                }
            },
            None if backend_of(scene) == BackendChoice::Cpu => None,
            None => {
                let made = Made::of(&mut self.renderer, scene, self.lanes).await?;
                made.scene = scene.clone();
                let drawn = screen(&mut made.renderer, scene, maps, watch).await;
                // A device that was lost stays lost.
                if drawn.as_ref().is_err_and(|error| !matches!(error, RenderError::Cancelled(_))) {
                    self.renderer = None;
                }
                drawn?
            }
        };
        let rows = 0..scene.size()[1];
        Ok(drawn.map(|(bytes, info)| (Painted::Picture(bytes, rows), info)))
    }

    /// Draws some rows of the picture of a scene; on a GPU, all.
    pub async fn picture(
        &mut self,
        scene: &Scene,
        rows: Range<u32>,
        maps: &mut Maps,
        watch: &Watch<'_>,
    ) -> Result<(Painted, RenderInfo), NotDrawn> {
        let [columns, height] = scene.size();
        let rows = if self.draws_on_cpu(scene) { rows } else { 0..height };
        let columns = columns as usize;
        let mut bytes = Vec::with_capacity(4 * columns * rows.len());
        let (display, mut row) = (Display::of(scene), rows.start);
        let mut sink = |part: Part<'_>| {
            let Part::Band(band) = part else {
                bytes.clear();
                row = rows.start;
                return Ok(());
            };
            for line in band.chunks(columns.max(1)) {
                let colours = display.linear_row(row, line);
                row += 1;
                bytes.par_extend(colours.into_par_iter().flat_map_iter(opaque));
            }
            Ok(())
        };
        let info = self.parts(scene, rows.clone(), maps, false, watch, &mut sink).await?;
        Ok((Painted::Picture(bytes, rows), info))
    }

    /// Draws a quantity of a scene.
    pub async fn quantity(
        &mut self,
        scene: &Scene,
        quantity: &'static Quantity,
        judge: Option<&dyn Judge>,
        maps: &mut Maps,
        watch: &Watch<'_>,
    ) -> Result<(Painted, RenderInfo), NotDrawn> {
        let begin = || {
            let gathered = Gathered::new(scene, &[Some(quantity)]);
            match judge {
                Some(judge) => gathered.with_judge(judge),
                None => gathered,
            }
        };
        let (mut gathered, mut pixels) = (begin(), with_room_for(scene));
        let mut sink = |part: Part<'_>| {
            match part {
                Part::Begin => {
                    gathered = begin();
                    pixels.clear();
                }
                Part::Band(band) => {
                    gathered.add(band);
                    pixels.extend_from_slice(band);
                }
            }
            Ok(())
        };
        let info = self.parts(scene, ALL, maps, true, watch, &mut sink).await?;
        let content = gathered.finish().into_iter().next().unwrap_or(Content::Numbers(Vec::new()));
        Ok((Painted::Quantity(content, pixels), info))
    }

    /// Draws the numbers of a scene's pixels, of one of a pixel's samples unless `numbers` are asked for.
    pub async fn pixels(
        &mut self,
        scene: &Scene,
        maps: &mut Maps,
        numbers: bool,
        watch: &Watch<'_>,
    ) -> Result<Vec<PixelOut>, NotDrawn> {
        let mut pixels = with_room_for(scene);
        let mut sink = |part: Part<'_>| {
            match part {
                Part::Begin => pixels.clear(),
                Part::Band(band) => pixels.extend_from_slice(band),
            }
            Ok(())
        };
        self.parts(scene, ALL, maps, numbers, watch, &mut sink).await?;
        Ok(pixels)
    }

    /// Renders rows of a scene in bands, on the GPU if it is asked for or faster. If that fails and the CPU
    /// would do, the picture begins again.
    async fn parts(
        &mut self,
        scene: &Scene,
        rows: Range<u32>,
        maps: &mut Maps,
        numbers: bool,
        watch: &Watch<'_>,
        sink: &mut Parts<'_>,
    ) -> Result<RenderInfo, NotDrawn> {
        if let Some(mut taken) = self.takeover.take(scene) {
            sink(Part::Begin)?;
            let drawn = bands(taken.renderer(), scene, rows.clone(), maps, numbers, watch, sink).await;
            match drawn {
                Ok(info) => {
                    self.takeover.give_back(taken, scene, Some(&info));
                    self.fallen_back = None;
                    return Ok(info);
                }
                Err(RenderError::Cancelled(cancelled)) => {
                    self.takeover.give_back(taken, scene, None);
                    return Err(cancelled.into());
                }
                Err(error) => {
                    self.takeover.fail(taken, &error);
                    self.fallen_back = Some(error.to_string());
                }
            }
        }
        sink(Part::Begin)?;
        let Made { renderer, scene: last, .. } = Made::of(&mut self.renderer, scene, self.lanes).await?;
        *last = scene.clone();
        let is_on_cpu = renderer.backend() == "cpu";
        let drawn = bands(renderer, scene, rows, maps, numbers, watch, sink).await;
        match &drawn {
            Ok(info) if is_on_cpu => self.takeover.cpu_drew(scene, info),
            // A device that was lost stays lost.
            Err(_) if !is_on_cpu && !matches!(drawn, Err(RenderError::Cancelled(_))) => self.renderer = None,
            _ => {}
        }
        Ok(drawn?)
    }

    /// Renders a scene that the [CPU draws](Self::draws_on_cpu) in bands of rows.
    pub fn bands_on_cpu(
        &mut self,
        scene: &Scene,
        maps: &mut Maps,
        numbers: bool,
        watch: &Watch,
        sink: &mut Bands<'_>,
    ) -> Result<(), NotDrawn> {
        let mut sink = |part: Part<'_>| match part {
            Part::Begin => Ok(()),
            Part::Band(band) => sink(band),
        };
        // On the CPU it never pauses.
        block_on(async {
            let made = Made::of(&mut self.renderer, scene, self.lanes).await?;
            made.scene = scene.clone();
            bands(&mut made.renderer, scene, ALL, maps, numbers, watch, &mut sink).await?;
            Ok(())
        })
    }

    /// Whether the CPU draws a scene.
    pub fn draws_on_cpu(&self, scene: &Scene) -> bool {
        !self.takeover.draws(scene) && backend_of(scene) == BackendChoice::Cpu
    }

    /// Returns what is to be done in the background so that the GPU can take over; nothing if it has, or
    /// cannot.
    pub fn warming(&self, scene: &Scene, maps: &Maps) -> Option<Warming> {
        self.draws_on_cpu(scene).then(|| self.takeover.warming(scene, maps)).flatten()
    }
}

/// Renders a scene for a screen; nothing on the CPU.
async fn screen(
    renderer: &mut Renderer,
    scene: &Scene,
    maps: &mut Maps,
    watch: &Watch<'_>,
) -> Result<Option<(Vec<u8>, RenderInfo)>, RenderError> {
    #[cfg(feature = "gpu")]
    return renderer.screen_async(scene, maps, watch).await;
    #[cfg(not(feature = "gpu"))]
    {
        let _ = (renderer, scene, maps, watch);
        Ok(None)
    }
}

/// Renders rows of a scene in bands.
async fn bands(
    renderer: &mut Renderer,
    scene: &Scene,
    rows: Range<u32>,
    maps: &mut Maps,
    numbers: bool,
    watch: &Watch<'_>,
    sink: &mut Parts<'_>,
) -> Result<RenderInfo, RenderError> {
    let mut sink = |band: &[PixelOut]| {
        sink(Part::Band(band))?;
        watch.check()
    };
    renderer.render_rows_async(scene, maps, rows, numbers, watch, &mut sink).await
}

/// An empty list with room for the pixels of a scene.
fn with_room_for(scene: &Scene) -> Vec<PixelOut> {
    Vec::with_capacity(scene.size().map(|side| side as usize).iter().product())
}

/// The backend that draws a scene at first: the CPU, unless the GPU is asked for or is the only one that can.
fn backend_of(scene: &Scene) -> BackendChoice {
    let needs_gpu = scene.sampling() == Sampling::Fast
        || scene.surfaces().iter().any(|surface| surface.selection().counts_in_stencil());
    match scene.backend() {
        BackendChoice::Auto if !needs_gpu => BackendChoice::Cpu,
        other => other,
    }
}

impl Made {
    /// The renderer for a scene: the one before, if it serves.
    async fn of<'a>(
        before: &'a mut Option<Made>,
        scene: &Scene,
        lanes: Option<Lanes>,
    ) -> Result<&'a mut Made, RenderError> {
        let (backend, sampling) = (backend_of(scene), scene.sampling());
        let kept = before.take().filter(|made| {
            // A GPU's renderer keeps its programs; one on the CPU holds data of other maps.
            (made.backend, made.sampling) == (backend, sampling)
                && (made.renderer.backend() == "gpu" || has_same_maps(&made.scene, scene))
        });
        let made = match kept {
            Some(made) => made,
            None => {
                let mut renderer = Renderer::open(backend, sampling).await?;
                if let Some(lanes) = lanes {
                    renderer.set_lanes(lanes);
                }
                Made { backend, sampling, renderer, scene: scene.clone() }
            }
        };
        Ok(before.insert(made))
    }
}

/// Whether surfaces share their maps and meshes with those before.
fn has_same_maps(before: &Scene, scene: &Scene) -> bool {
    let each = before.surfaces().iter().zip(scene.surfaces());
    before.surfaces().len() == scene.surfaces().len()
        && each.into_iter().all(|(before, surface)| {
            Arc::ptr_eq(before.height_map(), surface.height_map())
                && Arc::ptr_eq(before.mesh(), surface.mesh())
        })
}

/// A colour of the page.
fn opaque(linear: [f32; 3]) -> [u8; 4] {
    let [red, green, blue] = bytes_of(linear);
    [red, green, blue, u8::MAX]
}

#[cfg(all(test, feature = "gpu"))]
mod tests;
