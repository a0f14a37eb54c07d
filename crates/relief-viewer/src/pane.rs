//! One view of a scene: its picture, or numbers of its pixels.

use std::sync::Arc;

use rayon::prelude::*;
use relief_core::{ByteSize, Lanes, Watch};
use relief_io::Files;
use relief_maps::Maps;
use relief_render::false_color::{Content, Gathered, Judge, Quantity};
use relief_render::picture::{Display, bytes_of};
use relief_render::{RenderError, RenderInfo, Renderer};
use relief_scene::{BackendChoice, DEFAULT_MAX_MEMORY, Sampling, Scene, SceneError, SceneReader, SceneSpec};
use relief_shaders::cpu::PixelOut;

use crate::NotDrawn;
use crate::drawing::Band;

/// What a view keeps from one picture to the next.
#[derive(Debug, Default)]
pub struct Pane {
    reader: SceneReader,
    /// SIMD width of the CPU; none for the widest.
    pub lanes: Option<Lanes>,
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

/// What a view shows.
pub enum Painted {
    /// Red, green, blue and 255, row by row from the top.
    Picture(Vec<u8>),
    /// Numbers or directions, with the picture's pixels.
    Quantity(Content, Vec<PixelOut>),
}

impl Pane {
    /// Loads a scene within the memory that may be taken.
    pub fn load(&mut self, spec: &SceneSpec, files: &Files, most: ByteSize) -> Result<Scene, SceneError> {
        let most = spec.max_memory.unwrap_or(DEFAULT_MAX_MEMORY).0.min(most.0);
        // Copies share the bytes.
        self.reader.files_mut().clone_from(files);
        self.reader.load(&SceneSpec { max_memory: Some(ByteSize(most)), ..spec.clone() })
    }

    /// Draws the picture of a scene.
    pub fn picture(
        &mut self,
        scene: &Scene,
        maps: &mut Maps,
        watch: &Watch,
    ) -> Result<(Painted, RenderInfo), NotDrawn> {
        let [columns, rows] = scene.size().map(|side| side as usize);
        let mut bytes = Vec::with_capacity(4 * columns * rows);
        let (display, mut row) = (Display::of(scene), 0);
        let info = self.bands(scene, maps, false, watch, &mut |band| {
            for line in band.chunks(columns.max(1)) {
                let colours = display.linear_row(row, line);
                row += 1;
                bytes.par_extend(colours.into_par_iter().flat_map_iter(opaque));
            }
            Ok(())
        })?;
        Ok((Painted::Picture(bytes), info))
    }

    /// Draws a quantity of a scene.
    pub fn quantity(
        &mut self,
        scene: &Scene,
        quantity: &'static Quantity,
        judge: Option<&dyn Judge>,
        maps: &mut Maps,
        watch: &Watch,
    ) -> Result<(Painted, RenderInfo), NotDrawn> {
        let mut gathered = Gathered::new(scene, &[Some(quantity)]);
        if let Some(judge) = judge {
            gathered = gathered.with_judge(judge);
        }
        let mut pixels = Vec::with_capacity(scene.size().map(|side| side as usize).iter().product());
        let info = self.bands(scene, maps, true, watch, &mut |band| {
            gathered.add(band);
            pixels.extend_from_slice(band);
            Ok(())
        })?;
        let content = gathered.finish().into_iter().next().unwrap_or(Content::Numbers(Vec::new()));
        Ok((Painted::Quantity(content, pixels), info))
    }

    /// Draws the numbers of a scene's pixels, one sample each.
    pub fn pixels(
        &mut self,
        scene: &Scene,
        maps: &mut Maps,
        watch: &Watch,
    ) -> Result<Vec<PixelOut>, NotDrawn> {
        let mut pixels = Vec::with_capacity(scene.size().map(|side| side as usize).iter().product());
        self.bands(scene, maps, true, watch, &mut |band| {
            pixels.extend_from_slice(band);
            Ok(())
        })?;
        Ok(pixels)
    }

    /// Renders a scene in bands of rows.
    pub fn bands(
        &mut self,
        scene: &Scene,
        maps: &mut Maps,
        numbers: bool,
        watch: &Watch,
        sink: &mut Band<'_>,
    ) -> Result<RenderInfo, NotDrawn> {
        let Made { renderer, scene: last, .. } = Made::of(&mut self.renderer, scene, self.lanes)?;
        *last = scene.clone();
        let rendered = renderer.render_bands(scene, maps, numbers, watch, &mut |band| {
            sink(band)?;
            watch.check()
        });
        Ok(rendered?)
    }
}

impl Made {
    /// The renderer for a scene: the one before, if it serves.
    fn of<'a>(
        before: &'a mut Option<Made>,
        scene: &Scene,
        lanes: Option<Lanes>,
    ) -> Result<&'a mut Made, RenderError> {
        let (backend, sampling) = (scene.backend(), scene.sampling());
        let kept = before.take().filter(|made| {
            // A GPU's renderer keeps its programs; one on the CPU holds data of other maps.
            (made.backend, made.sampling) == (backend, sampling)
                && (made.renderer.backend() == "gpu" || has_same_maps(&made.scene, scene))
        });
        let made = match kept {
            Some(made) => made,
            None => {
                let mut renderer = Renderer::new(backend, sampling)?;
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
