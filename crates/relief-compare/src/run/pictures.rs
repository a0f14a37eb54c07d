//! Comparison of methods in pictures.

use relief_core::camera::Camera;
use relief_core::metrics::CostReport;
use relief_core::{Hit, MapFormat, Watch};
use relief_maps::Maps;
use relief_render::{RenderError, Rendered, Renderer};
use relief_scene::{Scene, Surface};
use relief_shaders::{Choice, SHADOW, SHADOW_SEARCH, Selection};

use super::reference::hit_of;
use super::shadow::{has_disc, true_shadow};
use super::subject::{Subject, with_selections};
use super::{Compared, MachineRenderer, MapsOf, MethodPicture, Reference, Renderers, Work};
use crate::comparison::{Comparison, Machine, MachineBackend};
use crate::contender::Contender;
use crate::error::CompareError;
use crate::exact_picture::{ExactPicture, exact_scene};
use crate::picture::{
    Image, PIXELS_PER_DEGREE, flip, peak_signal_to_noise, root_mean_square, structural_similarity,
};
use crate::record::{LeftOut, MachineRecord, MethodRecord, PictureRecord};

/// Distance by which the camera moves to the right for the second frame, in pixels at its target.
const STEP_PIXELS: f64 = 0.1;

/// Name of the method of reference pictures.
const EXACT: &str = "exact";

/// Surfaces seen from a camera, and the references for their pictures.
pub struct Shot<'a> {
    pub subject: &'a Subject,
    pub scene: Scene,
    distance_m: Option<f64>,
    truths: Vec<Truth>,
}

/// Reference for pictures with certain shadows.
struct Truth {
    /// Exact shadow for each surface.
    shadows: Vec<Choice>,
    /// Index among all references.
    reference: usize,
    exact: ExactPicture,
    /// Difference between two frames with many samples.
    still: Option<Change>,
}

/// Difference between two frames.
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
    /// Adds every method's picture of every subject from every distance, on every machine.
    pub(super) fn pictures(
        &self,
        make: &Renderers,
        subjects: &[Subject],
        contenders: &[Contender],
        work: &mut Work,
    ) -> Result<(), CompareError> {
        let mut stations = Vec::new();
        for &machine in &self.machines {
            let (station, device) = self.station(make, machine)?;
            work.compared.records.about.machines.push(MachineRecord {
                backend: machine.name().to_owned(),
                sampling: machine.sampling.name().to_owned(),
                device,
            });
            stations.push(station);
        }
        if stations.is_empty() {
            return Ok(());
        }
        // References are rendered on the CPU.
        let mut own = self.station(make, Machine::CPU)?.0;
        let views = self.views()?;
        for (subject, (distance_m, scene)) in
            subjects.iter().flat_map(|subject| views.iter().map(move |view| (subject, view)))
        {
            let mut shot =
                Shot { subject, scene: scene.clone(), distance_m: *distance_m, truths: Vec::new() };
            for contender in contenders {
                let shadows = true_shadows(&shot, contender)?;
                if shot.truth(&shadows).is_none() {
                    work.next(EXACT)?;
                    let truth = self.truth(&shot, shadows, &mut own.renderer, work)?;
                    shot.truths.push(truth);
                }
            }
            for station in &mut stations {
                self.on_machine(&shot, contenders, station, work)?;
            }
        }
        Ok(())
    }

    /// Adds every method's picture of a shot, and its times.
    fn on_machine(
        &self,
        shot: &Shot,
        contenders: &[Contender],
        station: &mut MachineRenderer,
        work: &mut Work,
    ) -> Result<(), CompareError> {
        let first = work.compared.records.pictures.len();
        let mut shown = Vec::new();
        for contender in contenders {
            work.next(&contender.name)?;
            if self.picture(shot, contender, station, work)? {
                shown.push(contender.clone());
            }
        }
        work.next("times")?;
        let times = self.times(shot, &shown, &mut station.renderer, work)?;
        if self.timing.is_some() && !times.is_empty() && times.iter().all(Option::is_none) {
            let reason = "frames are timed relative to bump mapping, which this surface does not support";
            work.compared.leave_out("times", reason);
        }
        for (record, times) in work.compared.records.pictures[first..].iter_mut().zip(times) {
            record.times = times;
        }
        Ok(())
    }

    /// Creates a machine's renderer, and returns its device's name.
    fn station(&self, make: &Renderers, machine: Machine) -> Result<(MachineRenderer, String), CompareError> {
        let mut renderer = make(machine).map_err(|error| CompareError::of_picture(machine.name(), error))?;
        renderer.set_lanes(self.lanes);
        let device = renderer.device();
        Ok((MachineRenderer { machine, renderer }, device))
    }

    /// Renders the reference for pictures with the given shadows, on the CPU.
    fn truth(
        &self,
        shot: &Shot,
        shadows: Vec<Choice>,
        renderer: &mut Renderer,
        work: &mut Work,
    ) -> Result<Truth, CompareError> {
        let Shot { subject, scene, distance_m, .. } = shot;
        let Work { baked, compared, watch, .. } = work;
        let maps = baked.maps(MapFormat::F32);
        let exact = |samples: u32| exact_scene(scene, &subject.surfaces, &shadows, samples);
        let picture =
            ExactPicture::drawn(&exact(scene.samples())?, &subject.surfaces, renderer, maps, &watch.quiet())?;
        let still = match self.flicker_samples {
            Some(samples) => {
                let scene = exact(samples)?;
                let first = self.image(&scene, renderer, maps, EXACT, watch)?;
                let second = self.image(&moved(&scene)?, renderer, maps, EXACT, watch)?;
                Some(Change::between(&[first, second])?)
            }
            None => None,
        };
        let shown = self.shown(
            &exact(scene.samples())?,
            picture.image(),
            renderer,
            (baked.maps(MapFormat::F32), EXACT),
            watch,
        )?;
        let reference = compared.references.len();
        compared.references.push(Reference {
            map_size: subject.map_size,
            scale_m: subject.scale_m,
            shadow: shadows.first().map_or(String::new(), |shadow| shadow.entry.name.to_owned()),
            distance_m: *distance_m,
            image: shown,
        });
        Ok(Truth { shadows, reference, exact: picture, still })
    }

    /// Adds a method's picture. Returns false if the method cannot render such surfaces on this
    /// machine.
    fn picture(
        &self,
        shot: &Shot,
        contender: &Contender,
        MachineRenderer { machine, renderer }: &mut MachineRenderer,
        work: &mut Work,
    ) -> Result<bool, CompareError> {
        let Work { baked, compared, watch, .. } = work;
        let (label, surfaces) = (contender.label(), &shot.subject.surfaces);
        let selections = contender.on_all(surfaces)?.selections;
        let is_of_gpu = machine.backend == MachineBackend::Gpu;
        if is_of_gpu && selections.iter().any(|selection| selection.rays_through_scene().is_some()) {
            compared.leave_out(
                &format!("{label} on a GPU"),
                "rays through a whole scene are only traced on the CPU",
            );
            return Ok(false);
        }
        let Some(truth) = shot.truth(&true_shadows(shot, contender)?) else { return Ok(false) };
        let mut maps_of = MapsOf::default();
        for (surface, selection) in surfaces.iter().zip(&selections) {
            let read = with_shadow_of(&contender.selection, selection);
            baked.provide(&read, contender.format(), surface, &mut maps_of, watch)?;
        }
        let scene = with_selections(&shot.scene, surfaces, &selections, shot.scene.samples())?;
        let maps = baked.maps(contender.format());
        let rendered = match rendered(&scene, renderer, maps, &label, watch) {
            Ok(rendered) => rendered,
            // Geometry may fail, for example by too many triangles; the other methods are still
            // compared.
            Err(CompareError::Render { source, .. }) if matches!(*source, RenderError::Geometry { .. }) => {
                compared.leave_out(&label, &source.to_string());
                return Ok(false);
            }
            Err(other) => return Err(other),
        };
        let image = Image::of(&rendered.rendering, &scene)?;
        let change = match truth.still {
            Some(still) => {
                let second = self.image(&moved(&scene)?, renderer, maps, &label, watch)?;
                let own = Change::between(&[image.clone(), second])?;
                Some(Change { rms: own.rms - still.rms, flip: own.flip - still.flip })
            }
            None => None,
        };
        let pixels = &rendered.rendering.pixels;
        let (hits, error) = match truth.exact.hits() {
            Some(exact) => {
                let (hits, error) = exact.judged(pixels);
                (hits, Some(error))
            }
            None => (pixels.iter().map(hit_of).collect(), None),
        };
        let size = scene.size();
        let is_searched = contender.is_of_rays() && (is_of_gpu || !contender.selection.is_exact());
        let is_true = |pixel: usize| truth.exact.hits().is_some_and(|hits| hits.hit(pixel).is_some());
        let on_surface = hits.iter().enumerate().filter(|(pixel, hit)| hit.found || is_true(*pixel));
        let on_surface: Vec<Hit> = on_surface.map(|(_, hit)| *hit).collect();
        let (exact, difference) = (truth.exact.image(), truth.exact.flip(&image)?);
        compared.records.pictures.push(PictureRecord {
            method: MethodRecord::of(contender, shot.subject, &maps_of),
            backend: machine.name().to_owned(),
            sampling: machine.sampling.name().to_owned(),
            size,
            samples: scene.samples(),
            distance_m: shot.distance_m,
            flip: difference.mean(),
            ssim: structural_similarity(exact, &image)?,
            psnr_db: peak_signal_to_noise(exact, &image)?,
            rms: root_mean_square(exact, &image)?,
            flicker_rms: change.map(|change| change.rms),
            flicker_flip: change.map(|change| change.flip),
            error,
            cost: is_searched.then(|| (&CostReport::of(&on_surface, 1)).into()),
            wave_reads: is_searched.then(|| CostReport::of(&hits, size[0] as usize).reads.wave),
            times: None,
        });
        let image = self.shown(&scene, &image, renderer, (baked.maps(contender.format()), &label), watch)?;
        compared.shown.push(MethodPicture { image, difference, reference: truth.reference });
        Ok(true)
    }

    /// Returns the picture to display for a scene whose compared picture is `compared`.
    fn shown(
        &self,
        scene: &Scene,
        compared: &Image,
        renderer: &mut Renderer,
        (maps, method): (&mut Maps, &str),
        watch: &Watch,
    ) -> Result<Image, CompareError> {
        let Some(look) = self.shown_look else { return Ok(compared.clone()) };
        let lit = scene.to_builder().background(look.background()).lights(look.lights(scene.camera()));
        self.image(&lit.build()?, renderer, maps, method, watch)
    }

    /// Renders the picture of a scene.
    fn image(
        &self,
        scene: &Scene,
        renderer: &mut Renderer,
        maps: &mut Maps,
        method: &str,
        watch: &Watch,
    ) -> Result<Image, CompareError> {
        let rendered = rendered(scene, renderer, maps, method, watch)?;
        Ok(Image::of(&rendered.rendering, scene)?)
    }
}

impl Shot<'_> {
    /// Returns the reference for pictures with the given exact shadows.
    fn truth(&self, shadows: &[Choice]) -> Option<&Truth> {
        let is_same = |(a, b): (&Choice, &Choice)| (a.number, a.params) == (b.number, b.params);
        self.truths.iter().find(|truth| truth.shadows.iter().zip(shadows).all(is_same))
    }
}

impl Compared {
    /// Notes once that something could not be compared.
    fn leave_out(&mut self, what: &str, reason: &str) {
        let left_out = LeftOut { what: what.to_owned(), reason: reason.to_owned() };
        if !self.records.left_out.contains(&left_out) {
            self.records.left_out.push(left_out);
        }
    }
}

/// Exact shadow for each surface: of the contender's shadow or, without one, of the surface's.
fn true_shadows(shot: &Shot, contender: &Contender) -> Result<Vec<Choice>, CompareError> {
    let has_disc = has_disc(&shot.scene);
    let of = |surface: &Surface| {
        let shadow = contender.shadow.unwrap_or(surface.selection().choices[SHADOW]);
        Ok(true_shadow(&shadow, has_disc)?)
    };
    shot.subject.surfaces.iter().map(of).collect()
}

/// Combines a method's selection with its shadow on a surface: the stages for which it reads maps.
fn with_shadow_of(method: &Selection, on_surface: &Selection) -> Selection {
    let mut selection = *method;
    for place in [SHADOW, SHADOW_SEARCH] {
        selection.choices[place] = on_surface.choices[place];
    }
    selection
}

/// Renders a picture, unless the work is cancelled.
fn rendered(
    scene: &Scene,
    renderer: &mut Renderer,
    maps: &mut Maps,
    method: &str,
    watch: &Watch,
) -> Result<Rendered, CompareError> {
    watch.check()?;
    renderer.render(scene, maps, &watch.quiet()).map_err(|error| CompareError::of_picture(method, error))
}

/// Moves the scene's camera slightly to the right.
fn moved(scene: &Scene) -> Result<Scene, CompareError> {
    let camera = scene.camera();
    let [_, rows] = scene.size();
    let distance = if camera.is_orthographic() { 1.0 } else { (camera.target() - camera.eye()).length() };
    let pixel_m = 2.0 * camera.half_height() * distance / f64::from(rows);
    let aside = camera.right() * (STEP_PIXELS * pixel_m);
    let moved: Camera = camera.moved(camera.eye() + aside, camera.target() + aside)?;
    Ok(scene.to_builder().camera(moved).build()?)
}
