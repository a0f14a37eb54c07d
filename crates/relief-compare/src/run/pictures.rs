//! Methods in pictures.

use relief_core::Hit;
use relief_core::exact::ExactHit;
use relief_core::metrics::CostReport;
use relief_maps::Maps;
use relief_render::camera::Camera;
use relief_render::scene::{Scene, Surface};
use relief_render::{RenderError, Rendered, Renderer};
use relief_shaders::Selection;

use super::reference::{hit_of, in_tile_of, is_flat, seen_by_judge, selection, truth};
use super::{Baked, Compared, Done, Reference, Shown};
use crate::case::judged;
use crate::comparison::{Comparison, Machine, MachineBackend, Watch};
use crate::contender::Contender;
use crate::error::CompareError;
use crate::picture::{
    Image, PIXELS_PER_DEGREE, flip, peak_signal_to_noise, root_mean_square, structural_similarity,
};
use crate::record::{LeftOut, MachineRecord, MethodRecord, PictureRecord};

/// How far the second frame is moved to the right, in pixels of the point looked at.
const STEP_PIXELS: f64 = 0.1;

/// What makes reference pictures.
const EXACT: &str = "exact";

/// What pictures of a subject are compared with.
struct Truth {
    image: Image,
    hits: Vec<ExactHit>,
    /// How much frames change that many samples are taken of.
    still: Option<Change>,
}

/// How much two frames differ.
#[derive(Clone, Copy)]
struct Change {
    rms: f64,
    flip: f64,
}

impl Change {
    fn between(frames: &[Image; 2]) -> Result<Self, CompareError> {
        let [a, b] = frames;
        Ok(Self { rms: root_mean_square(a, b)?, flip: flip(a, b, PIXELS_PER_DEGREE)?.mean() })
    }
}

impl Comparison {
    /// Adds every method's picture of every subject, on every machine.
    pub(super) fn pictures(
        &self,
        subjects: &[Surface],
        contenders: &[Contender],
        baked: &mut Baked,
        done: &mut Done,
        watch: &Watch,
        compared: &mut Compared,
    ) -> Result<(), CompareError> {
        let mut renderers = Vec::new();
        for &machine in &self.machines {
            let (renderer, device) = self.renderer(machine)?;
            compared.records.about.machines.push(MachineRecord {
                backend: machine.name().to_owned(),
                sampling: machine.sampling.name().to_owned(),
                device,
            });
            renderers.push((machine, renderer));
        }
        if renderers.is_empty() {
            return Ok(());
        }
        let mut own = self.renderer(Machine::CPU)?.0;
        for subject in subjects {
            done.next(watch, EXACT);
            let truth = self.truth(subject, &mut own, &mut baked.maps, watch)?;
            let heights = subject.height_map();
            let (map_size, scale_m) = ([heights.width(), heights.height()], heights.scale_m());
            compared.references.push(Reference { map_size, scale_m, image: truth.image.clone() });
            for (machine, renderer) in &mut renderers {
                let first = compared.records.pictures.len();
                let mut shown = Vec::new();
                for contender in contenders {
                    done.next(watch, &contender.name);
                    if self.picture(subject, contender, *machine, renderer, &truth, baked, watch, compared)? {
                        shown.push(contender.clone());
                    }
                }
                done.next(watch, "times");
                let times = self.times(subject, &shown, *machine, renderer, &mut baked.maps, watch)?;
                if self.timing.is_some() && !times.is_empty() && times.iter().all(Option::is_none) {
                    let reason = "frames are timed beside bump mapping, of which this surface has none";
                    compared
                        .records
                        .left_out
                        .push(LeftOut { what: "times".to_owned(), reason: reason.to_owned() });
                }
                for (record, times) in compared.records.pictures[first..].iter_mut().zip(times) {
                    record.times = times;
                }
            }
        }
        Ok(())
    }

    fn renderer(&self, machine: Machine) -> Result<(Renderer, String), CompareError> {
        let renderer = Renderer::new(machine.backend_choice(), machine.sampling);
        let mut renderer = renderer.map_err(|source| of(machine.name(), source))?;
        renderer.set_lanes(self.lanes);
        let device = renderer.device();
        Ok((renderer, device))
    }

    /// What pictures of a subject are compared with, on the CPU.
    fn truth(
        &self,
        subject: &Surface,
        renderer: &mut Renderer,
        maps: &mut Maps,
        watch: &Watch,
    ) -> Result<Truth, CompareError> {
        let is_flat = is_flat(subject.mesh());
        let selection = selection(subject, is_flat)?;
        let scene = self.scene_of(subject, selection, self.scene.samples())?;
        let rendered = rendered(&scene, renderer, maps, EXACT, watch)?;
        let hits = if is_flat {
            rendered.rendering.pixels.iter().map(|pixel| truth(hit_of(pixel))).collect()
        } else {
            seen_by_judge(subject, self.scene.camera(), self.scene.size())?
        };
        let image = Image::of(&rendered.rendering, &self.scene.look())?;
        let still = match self.flicker_samples {
            Some(samples) => {
                let scene = self.scene_of(subject, selection, samples)?;
                let frames = [scene.clone(), moved(&scene)?]
                    .map(|scene| self.image(&scene, renderer, maps, EXACT, watch));
                let [first, second] = frames;
                Some(Change::between(&[first?, second?])?)
            }
            None => None,
        };
        Ok(Truth { image, hits, still })
    }

    /// Adds a method's picture, unless it cannot be made of such a surface.
    fn picture(
        &self,
        subject: &Surface,
        contender: &Contender,
        machine: Machine,
        renderer: &mut Renderer,
        truth: &Truth,
        baked: &mut Baked,
        watch: &Watch,
        compared: &mut Compared,
    ) -> Result<bool, CompareError> {
        let heights = subject.height_map();
        let of_method = baked.provide(&contender.selection, heights, watch)?;
        let label = contender.label();
        let scene = self.scene_of(subject, contender.on(subject)?, self.scene.samples())?;
        let rendered = match rendered(&scene, renderer, &mut baked.maps, &label, watch) {
            Ok(rendered) => rendered,
            // Too many triangles, say: the others can be compared all the same.
            Err(CompareError::Render { source, .. }) if matches!(*source, RenderError::Geometry { .. }) => {
                compared.records.left_out.push(LeftOut { what: label, reason: source.to_string() });
                return Ok(false);
            }
            Err(other) => return Err(other),
        };
        let image = Image::of(&rendered.rendering, &self.scene.look())?;
        let change = match truth.still {
            Some(still) => {
                let second = self.image(&moved(&scene)?, renderer, &mut baked.maps, &label, watch)?;
                let own = Change::between(&[image.clone(), second])?;
                Some(Change { rms: own.rms - still.rms, flip: own.flip - still.flip })
            }
            None => None,
        };
        let hits: Vec<Hit> = rendered
            .rendering
            .pixels
            .iter()
            .zip(&truth.hits)
            .map(|(pixel, truth)| in_tile_of(hit_of(pixel), &truth.hit, heights.wrap()))
            .collect();
        let size = self.scene.size();
        let is_searched = contender.is_of_rays()
            && !(machine.backend == MachineBackend::Cpu && contender.selection.is_exact());
        let on_surface = hits.iter().zip(&truth.hits).filter(|(hit, truth)| hit.found || truth.hit.found);
        let on_surface: Vec<Hit> = on_surface.map(|(hit, _)| *hit).collect();
        let report = judged(&truth.hits, &hits, heights);
        let difference = flip(&truth.image, &image, PIXELS_PER_DEGREE)?;
        compared.records.pictures.push(PictureRecord {
            method: MethodRecord::of(contender, heights, &of_method),
            backend: machine.name().to_owned(),
            sampling: machine.sampling.name().to_owned(),
            size,
            samples: self.scene.samples(),
            flip: difference.mean(),
            ssim: structural_similarity(&truth.image, &image)?,
            psnr_db: peak_signal_to_noise(&truth.image, &image)?,
            rms: root_mean_square(&truth.image, &image)?,
            flicker_rms: change.map(|change| change.rms),
            flicker_flip: change.map(|change| change.flip),
            error: (&report).into(),
            cost: is_searched.then(|| (&CostReport::of(&on_surface, 1)).into()),
            wave_reads: is_searched.then(|| CostReport::of(&hits, size[0] as usize).reads.wave),
            times: None,
        });
        compared.shown.push(Shown { image, difference, reference: compared.references.len() - 1 });
        Ok(true)
    }

    /// The scene with another surface.
    fn scene_of(&self, subject: &Surface, selection: Selection, samples: u32) -> Result<Scene, CompareError> {
        let surface = subject.clone().with_selection(selection);
        Ok(self.scene.to_builder().surfaces(vec![surface]).samples(samples).build()?)
    }

    /// What a scene looks like.
    fn image(
        &self,
        scene: &Scene,
        renderer: &mut Renderer,
        maps: &mut Maps,
        method: &str,
        watch: &Watch,
    ) -> Result<Image, CompareError> {
        let rendered = rendered(scene, renderer, maps, method, watch)?;
        Ok(Image::of(&rendered.rendering, &scene.look())?)
    }
}

/// A picture, unless the work is ended.
fn rendered(
    scene: &Scene,
    renderer: &mut Renderer,
    maps: &mut Maps,
    method: &str,
    watch: &Watch,
) -> Result<Rendered, CompareError> {
    watch.check()?;
    renderer.render(scene, maps, &|_, _| {}).map_err(|source| of(method, source))
}

pub(super) fn of(method: &str, source: RenderError) -> CompareError {
    CompareError::Render { method: method.to_owned(), source: Box::new(source) }
}

/// The scene as it is seen a little more from the right.
fn moved(scene: &Scene) -> Result<Scene, CompareError> {
    let camera = scene.camera();
    let [_, rows] = scene.size();
    let distance = if camera.is_orthographic() { 1.0 } else { (camera.target() - camera.eye()).length() };
    let pixel_m = 2.0 * camera.half_height() * distance / f64::from(rows);
    let aside = camera.right() * (STEP_PIXELS * pixel_m);
    let moved: Camera = camera.moved(camera.eye() + aside, camera.target() + aside)?;
    Ok(scene.to_builder().camera(moved).build()?)
}
