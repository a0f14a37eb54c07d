//! Pictures of one scene after the other.

use std::sync::Arc;

use relief_core::{ByteSize, Cancelled, Watch};
use relief_io::Files;
use relief_maps::Maps;
use relief_render::picture::{Display, bytes_of};
use relief_render::{Bands, RenderError, RenderInfo, Renderer};
use relief_scene::{
    BackendChoice, DEFAULT_MAX_MEMORY, Sampling, Scene, SceneError, SceneReader, SceneSpec, ValueError,
};
use relief_session::Seen;
use serde::Deserialize;
use serde_json::{Value, json};
use web_time::Instant;

/// What is asked of a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Asked {
    /// Columns and rows of the pane, for scenes without a size.
    pub pane: [u32; 2],
    /// Factor on both sides, from 0 to 1.
    pub part: f64,
    /// Whether one sample for each pixel is enough.
    pub is_quick: bool,
}

impl Asked {
    /// Asks for the whole picture in a pane of this size.
    pub const fn whole(pane: [u32; 2]) -> Self {
        Self { pane, part: 1.0, is_quick: false }
    }

    /// Reads a wish in JSON: `width` and `height` of the pane, `part`, and `samples`, `"one"` or `"all"`.
    ///
    /// # Errors
    ///
    /// When the text is another one.
    pub fn of_json(text: &str) -> Result<Self, serde_json::Error> {
        let Wish { width, height, part, samples } = serde_json::from_str(text)?;
        Ok(Self { pane: [width, height], part, is_quick: samples == Samples::One })
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Wish {
    width: u32,
    height: u32,
    part: f64,
    samples: Samples,
}

#[derive(Deserialize, PartialEq)]
#[serde(rename_all = "lowercase")]
enum Samples {
    One,
    All,
}

/// A picture.
#[derive(Debug)]
pub struct Drawn {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Samples per pixel.
    pub samples: u32,
    /// Red, green, blue and 255, row by row from the top.
    pub pixels: Vec<u8>,
    /// Backend, baked maps and time of rendering.
    pub info: RenderInfo,
    /// Notes of the readers of the scene's files.
    pub notes: Vec<String>,
    /// Seconds from the request to the picture.
    pub seconds: f64,
    /// What the picture shows, for [`Session::shown`](relief_session::Session::shown).
    pub seen: Seen,
}

impl Drawn {
    /// Returns what a page shows of the picture, as JSON.
    pub fn about(&self, revision: u64) -> Value {
        json!({
            "revision": revision, "size": self.size, "samples": self.samples, "seconds": self.seconds,
            "backend": self.info.backend, "device": self.info.device, "notes": self.notes,
        })
    }
}

/// Reason why there is no picture.
#[derive(Debug, thiserror::Error)]
pub enum NotDrawn {
    /// It was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// The scene cannot be loaded.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// A scene of the picture's size and samples is refused.
    #[error(transparent)]
    Value(#[from] ValueError),
    /// Rendering failed.
    #[error(transparent)]
    Render(RenderError),
}

impl From<RenderError> for NotDrawn {
    fn from(error: RenderError) -> Self {
        match error {
            RenderError::Cancelled(cancelled) => Self::Cancelled(cancelled),
            other => Self::Render(other),
        }
    }
}

/// Draws scenes. Files that were read, baked maps and the renderer's own data are kept for the next one.
#[derive(Debug)]
pub struct Drawing {
    reader: SceneReader,
    maps: Maps,
    most_memory: ByteSize,
    renderer: Option<Made>,
}

/// A renderer, with what it was made for.
#[derive(Debug)]
struct Made {
    backend: BackendChoice,
    sampling: Sampling,
    renderer: Renderer,
    scene: Scene,
}

impl Drawing {
    /// Draws scenes whose files are in `files`, with baked maps from `maps`. A scene may take at most
    /// `most_memory`, whatever it says itself.
    pub fn new(files: Files, maps: Maps, most_memory: ByteSize) -> Self {
        Self { reader: SceneReader::of_files(files), maps, most_memory, renderer: None }
    }

    /// Returns the files.
    pub fn files(&self) -> &Files {
        self.reader.files()
    }

    /// Returns the files for changing them.
    pub fn files_mut(&mut self) -> &mut Files {
        self.reader.files_mut()
    }

    /// Draws a scene.
    ///
    /// # Errors
    ///
    /// When a file cannot be read, a value is refused, the backend fails, or `watch` cancels the work.
    pub fn draw(&mut self, spec: &SceneSpec, asked: Asked, watch: &Watch) -> Result<Drawn, NotDrawn> {
        let started = Instant::now();
        let whole = self.load(&shown(spec, asked.pane))?;
        let (seen, scene) = (Seen::of(&whole), reduced(&whole, asked)?);
        let [width, height] = scene.size();
        let mut pixels = Vec::with_capacity(4 * width as usize * height as usize);
        let display = Display::of(&scene);
        let info = self.render(&scene, false, watch, &mut |row, line| {
            let colours = display.linear_row(row, line).into_iter().map(bytes_of);
            pixels.extend(colours.flat_map(|[red, green, blue]| [red, green, blue, u8::MAX]));
            Ok(())
        })?;
        let notes = whole.notes().iter().map(ToString::to_string).collect();
        let (size, samples, seconds) = (scene.size(), scene.samples(), started.elapsed().as_secs_f64());
        Ok(Drawn { size, samples, pixels, info, notes, seconds, seen })
    }

    /// Loads a scene within the memory that may be taken.
    pub(crate) fn load(&mut self, spec: &SceneSpec) -> Result<Scene, SceneError> {
        let most = spec.max_memory.unwrap_or(DEFAULT_MAX_MEMORY).0.min(self.most_memory.0);
        self.reader.load(&SceneSpec { max_memory: Some(ByteSize(most)), ..spec.clone() })
    }

    /// Renders a scene row by row from the top, each with its number.
    pub(crate) fn render(
        &mut self,
        scene: &Scene,
        numbers: bool,
        watch: &Watch,
        sink: &mut Rows<'_>,
    ) -> Result<RenderInfo, NotDrawn> {
        let Made { renderer, scene: last, .. } = Made::of(&mut self.renderer, scene)?;
        *last = scene.clone();
        let (width, mut next) = (scene.size()[0].max(1) as usize, 0);
        let bands: &mut Bands<'_> = &mut |band| {
            band.chunks(width).try_for_each(|line| {
                next += 1;
                sink(next - 1, line)
            })
        };
        Ok(renderer.render_bands(scene, &mut self.maps, numbers, watch, bands)?)
    }
}

/// Receiver of a row of pixels with its number. An error ends the picture.
pub(crate) type Rows<'a> = dyn FnMut(u32, &[relief_shaders::cpu::PixelOut]) -> Result<(), Cancelled> + 'a;

impl Made {
    /// Returns the renderer for a scene: the one before, if it serves.
    fn of<'a>(before: &'a mut Option<Made>, scene: &Scene) -> Result<&'a mut Made, RenderError> {
        let (backend, sampling) = (scene.backend(), scene.sampling());
        let kept = before.take().filter(|made| {
            // A GPU's renderer keeps its programs; one on the CPU holds data of other maps.
            (made.backend, made.sampling) == (backend, sampling)
                && (made.renderer.backend() == "gpu" || has_same_maps(&made.scene, scene))
        });
        let made = match kept {
            Some(made) => made,
            None => {
                let renderer = Renderer::new(backend, sampling)?;
                Made { backend, sampling, renderer, scene: scene.clone() }
            }
        };
        Ok(before.insert(made))
    }
}

/// Returns the scene with a size: the pane's, if it has none of its own.
pub fn shown(spec: &SceneSpec, pane: [u32; 2]) -> SceneSpec {
    SceneSpec { size: spec.size.or(Some(pane.into())), ..spec.clone() }
}

/// Returns the scene of a quick picture. Its surfaces are the whole one's, so that nothing is baked for it.
fn reduced(scene: &Scene, asked: Asked) -> Result<Scene, ValueError> {
    let part = if asked.part.is_finite() { asked.part.clamp(0.01, 1.0) } else { 1.0 };
    let [width, height] = scene.size().map(|side| ((f64::from(side) * part).round() as u32).max(1));
    let samples = if asked.is_quick { 1 } else { scene.samples() };
    if [width, height] == scene.size() && samples == scene.samples() {
        return Ok(scene.clone());
    }
    scene.to_builder().size(width, height).samples(samples).build()
}

/// Returns whether surfaces share their maps and meshes with another scene's.
fn has_same_maps(before: &Scene, scene: &Scene) -> bool {
    let each = before.surfaces().iter().zip(scene.surfaces());
    before.surfaces().len() == scene.surfaces().len()
        && each.into_iter().all(|(before, surface)| {
            Arc::ptr_eq(before.height_map(), surface.height_map())
                && Arc::ptr_eq(before.mesh(), surface.mesh())
        })
}
