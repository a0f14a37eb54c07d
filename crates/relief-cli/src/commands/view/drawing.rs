//! Pictures for the page. A drawing keeps what its scenes share: files that were read, baked maps, and what the
//! renderer has built.

use std::sync::Arc;
use std::time::Instant;

use rayon::prelude::*;
use relief_core::{Cancelled, Watch};
use relief_maps::Maps;
use relief_render::picture::{Display, bytes_of};
use relief_render::{RenderError, RenderInfo, Renderer};
use relief_scene::{BackendChoice, Sampling, Scene, SceneReader, SceneSpec};
use relief_session::Seen;
use serde_json::json;

use crate::advice;
use crate::commands::maps::{By, of_reading};
use crate::commands::scene_arguments::of_scene_file;
use crate::failure::Failure;
use crate::lanes;

/// What is asked of a picture.
#[derive(Clone, Copy, Debug)]
pub struct Asked {
    /// Columns and rows of the pane, for scenes without a size.
    pub pane: [u32; 2],
    /// Factor on both sides, from 0 to 1.
    pub part: f64,
    /// Whether one sample for each pixel is enough.
    pub is_quick: bool,
}

/// A picture.
pub struct Drawn {
    pub size: [u32; 2],
    pub samples: u32,
    /// Red, green, blue and 255, row by row from the top.
    pub pixels: Vec<u8>,
    pub info: RenderInfo,
    pub notes: Vec<String>,
    pub seconds: f64,
    pub seen: Seen,
}

/// Why there is no picture.
pub enum NotDrawn {
    /// A change ended it.
    Ended,
    Failed(String),
}

impl From<Failure> for NotDrawn {
    fn from(failure: Failure) -> Self {
        match failure {
            Failure::Usage(what) | Failure::Work(what) => NotDrawn::Failed(what),
            Failure::ReaderGone => NotDrawn::Ended,
        }
    }
}

/// What pictures share.
pub struct Drawing {
    reader: SceneReader,
    maps: Maps,
    renderer: Option<Made>,
}

/// A renderer, with what it was made for.
struct Made {
    backend: BackendChoice,
    sampling: Sampling,
    renderer: Renderer,
    scene: Scene,
}

impl Drawing {
    pub fn new(maps: Maps) -> Self {
        Self { reader: SceneReader::default(), maps, renderer: None }
    }

    /// Draws a scene.
    pub fn draw(&mut self, spec: &SceneSpec, asked: Asked, watch: &Watch) -> Result<Drawn, NotDrawn> {
        let started = Instant::now();
        let spec = shown(spec, asked.pane);
        let whole = self.reader.load(&spec).map_err(of_scene_file)?;
        let seen = Seen::of(&whole);
        let scene = reduced(&whole, asked)?;
        let notes = of_reading(&spec, &whole, By::Keys).iter().map(ToString::to_string).collect();
        let Made { renderer, scene: last, .. } = Made::of(&mut self.renderer, &scene)?;
        *last = scene.clone();
        let mut pixels =
            Vec::with_capacity(4 * scene.size().map(|side| side as usize).iter().product::<usize>());
        let (display, width) = (Display::of(&scene), scene.size()[0].max(1) as usize);
        let mut row = 0;
        let rendered = renderer.render_bands(&scene, &mut self.maps, false, watch, &mut |band| {
            for line in band.chunks(width) {
                let colours = display.linear_row(row, line);
                row += 1;
                pixels.par_extend(colours.into_par_iter().flat_map_iter(bytes));
            }
            match watch.at(row as f32 / scene.size()[1] as f32) {
                Ok(()) => Ok(()),
                Err(_) => Err(Cancelled),
            }
        });
        let info = rendered.map_err(|error| match error {
            RenderError::Cancelled(_) => NotDrawn::Ended,
            other => NotDrawn::Failed(advice::with(&other, advice::of_render(&other))),
        })?;
        let (size, samples, seconds) = (scene.size(), scene.samples(), started.elapsed().as_secs_f64());
        Ok(Drawn { size, samples, pixels, info, notes, seconds, seen })
    }
}

impl Drawn {
    /// What the page learns of the picture.
    pub fn about(&self, revision: u64) -> serde_json::Value {
        json!({
            "revision": revision, "size": self.size, "samples": self.samples, "seconds": self.seconds,
            "backend": self.info.backend, "device": self.info.device, "notes": self.notes,
        })
    }
}

impl Made {
    /// The renderer for a scene: the one before, if it serves.
    fn of<'a>(before: &'a mut Option<Made>, scene: &Scene) -> Result<&'a mut Made, NotDrawn> {
        let (backend, sampling) = (scene.backend(), scene.sampling());
        let kept = before.take().filter(|made| {
            // A GPU's renderer keeps its programs; one on the CPU holds data of other maps.
            (made.backend, made.sampling) == (backend, sampling)
                && (made.renderer.backend() == "gpu" || has_same_maps(&made.scene, scene))
        });
        let made = match kept {
            Some(made) => made,
            None => {
                let renderer = Renderer::new(backend, sampling);
                let mut renderer = renderer
                    .map_err(|error| NotDrawn::Failed(advice::with(&error, advice::of_render(&error))))?;
                renderer.set_lanes(lanes::from_environment()?);
                Made { backend, sampling, renderer, scene: scene.clone() }
            }
        };
        Ok(before.insert(made))
    }
}

/// A scene with a size: the pane's, if it has none of its own.
pub fn shown(spec: &SceneSpec, [width, height]: [u32; 2]) -> SceneSpec {
    let mut spec = spec.clone();
    spec.size = spec.size.or(Some([width, height].into()));
    spec
}

/// The scene of a quick picture. Its surfaces are the whole one's, so that nothing is baked for it.
fn reduced(scene: &Scene, asked: Asked) -> Result<Scene, NotDrawn> {
    let part = if asked.part.is_finite() { asked.part.clamp(0.01, 1.0) } else { 1.0 };
    let [width, height] = scene.size().map(|side| ((f64::from(side) * part).round() as u32).max(1));
    let samples = if asked.is_quick { 1 } else { scene.samples() };
    if [width, height] == scene.size() && samples == scene.samples() {
        return Ok(scene.clone());
    }
    let built = scene.to_builder().size(width, height).samples(samples).build();
    built.map_err(|error| NotDrawn::Failed(error.to_string()))
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
fn bytes(linear: [f32; 3]) -> [u8; 4] {
    let [red, green, blue] = bytes_of(linear);
    [red, green, blue, u8::MAX]
}
