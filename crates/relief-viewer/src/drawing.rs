//! Pictures for the page: one view, or two of the same scene by two methods. A drawing keeps what its scenes
//! share: files that were read, baked maps, and what the renderers have built.

use std::collections::BTreeSet;

use relief_core::{ByteSize, Lanes, Watch};
use relief_io::Files;
use relief_maps::Maps;
use relief_render::false_color::{Judge, Quantity, Scale, quantity_of};
use relief_render::{Bands, RenderInfo};
use relief_scene::{Scene, SceneError, SceneSpec, Shown, ValueError};
use relief_session::Seen;
use relief_shaders::cpu::PixelOut;
use serde_json::{Value, json};
use web_time::Instant;

use crate::exact::Exact;
use crate::pane::{Painted, Pane};
use crate::pixel::Looked;
use crate::takeover::{Device, Warming};
use crate::{Asked, NotDrawn, colors};

/// The views of a scene.
#[derive(Debug)]
pub struct Drawn {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Samples per pixel.
    pub samples: u32,
    /// Notes about the scene's files.
    pub notes: Vec<String>,
    /// Seconds from the request to the picture.
    pub seconds: f64,
    /// What the first view shows, for [`Session::shown`](relief_session::Session::shown).
    pub seen: Seen,
    /// One view, or two.
    views: Vec<View>,
}

/// One view.
#[derive(Debug)]
struct View {
    /// What the page learns of it.
    about: Value,
    /// Red, green, blue and 255, row by row from the top; none if it cannot be drawn.
    pixels: Vec<u8>,
}

/// A view that has been drawn, or the reason why it cannot be.
type Made = Result<(Painted, RenderInfo), String>;

/// Says what is worth a note about the files of a scene.
pub type Notes = fn(&SceneSpec, &Scene) -> Vec<String>;

/// Draws scenes, and keeps what they share: files that were read, baked maps, and what the renderers have
/// built.
#[derive(Debug)]
pub struct Drawing {
    files: Files,
    maps: Maps,
    most_memory: ByteSize,
    lanes: Option<Lanes>,
    notes: Notes,
    device: Device,
    panes: Vec<Pane>,
    /// The last picture of a view at rest.
    looked: Option<Looked>,
}

impl Drawing {
    /// Draws scenes whose files are in `files`, with baked maps from `maps`. A scene may take at most
    /// `most_memory`, whatever it says itself.
    pub fn new(files: Files, maps: Maps, most_memory: ByteSize) -> Self {
        let notes: Notes = |_, scene| scene.notes().iter().map(ToString::to_string).collect();
        let device = Device::default();
        let panes = vec![Pane::new(&device)];
        Self { files, maps, most_memory, lanes: None, notes, device, panes, looked: None }
    }

    /// Sets the SIMD width of the CPU.
    #[must_use]
    pub fn with_lanes(self, lanes: Lanes) -> Self {
        Self { lanes: Some(lanes), ..self }
    }

    /// Sets the GPU that may take over from the CPU. Default: the best hardware GPU there is.
    #[cfg(feature = "gpu")]
    #[must_use]
    pub fn with_gpu(self, gpu: relief_render::gpu::Gpu) -> Self {
        let device = Device::of(gpu);
        Self { panes: vec![Pane::new(&device)], device, ..self }
    }

    /// Sets what is noted about the files of a scene. Default: the notes of their readers.
    #[must_use]
    pub fn with_notes(self, notes: Notes) -> Self {
        Self { notes, ..self }
    }

    /// Returns the files.
    pub fn files(&self) -> &Files {
        &self.files
    }

    /// Returns the files for changing them.
    pub fn files_mut(&mut self) -> &mut Files {
        &mut self.files
    }

    /// Draws the views of a scene. Where a GPU works, the thread goes on; the CPU's work is done on this
    /// thread, without a pause.
    ///
    /// # Errors
    ///
    /// When no view can be drawn: a file cannot be read, a value is refused, or the backend fails; and when
    /// `watch` cancels the work.
    pub async fn draw(
        &mut self,
        spec: &SceneSpec,
        asked: Asked,
        watch: &Watch<'_>,
    ) -> Result<Drawn, NotDrawn> {
        let started = Instant::now();
        self.looked = None;
        let views = of_views(&shown(spec, asked.pane));
        let Self { device, panes, .. } = self;
        panes.resize_with(views.len(), || Pane::new(device));
        let (scenes, mut notes, seen) = self.scenes(&views, asked)?;
        let exact = self.exact(&views, &scenes, watch)?;
        // Numbers have one scale, and some errors look at neighbours.
        let is_shared = views.iter().all(|view| view.quantity.is_none());
        let asked = if is_shared { asked } else { Asked { rows: [0.0, 1.0], ..asked } };
        let mut made: Vec<Made> = Vec::new();
        for (number, (view, scene)) in views.iter().zip(&scenes).enumerate() {
            let drawn = match scene {
                Ok(scene) => self.view(number, view, scene, asked, exact.as_ref(), watch).await,
                Err(said) => Err(NotDrawn::NoView(said.clone())),
            };
            made.push(match drawn {
                Ok(drawn) => Ok(drawn),
                Err(NotDrawn::Cancelled(cancelled)) => return Err(cancelled.into()),
                Err(error) if views.len() == 1 => return Err(error),
                Err(error) => Err(error.to_string()),
            });
        }
        if let Some(Err(said)) = made.first().filter(|_| made.iter().all(Result::is_err)) {
            return Err(NotDrawn::NoView(said.clone()));
        }
        let fallen = self.panes.iter().filter_map(|pane| pane.fallen_back.as_ref());
        notes.extend(fallen.map(|why| format!("the CPU draws in place of the GPU: {why}")));
        let exact = exact.and_then(Result::ok);
        let shown = views.iter().zip(&made).zip(&scenes).map(|((view, own), scene)| {
            let scale = view.quantity.map(|quantity| {
                let same = views.iter().zip(&made).filter(|(other, _)| other.shown == view.shown);
                colors::scale(quantity, same.filter_map(|(_, made)| Some(&made.as_ref().ok()?.0)))
            });
            View::of(view, scene.as_ref().ok(), own, scale.as_ref(), exact.as_ref())
        });
        let shown: Vec<View> = shown.collect();
        let first = scenes.first().and_then(|scene| scene.as_ref().ok());
        let (size, samples) = first.map_or(([0; 2], 0), |scene| (scene.size(), scene.samples()));
        if !asked.is_quick {
            let painted = made.into_iter().map(|made| made.ok().map(|(painted, _)| painted));
            let quantities = views.iter().map(|view| view.quantity);
            let each = scenes.into_iter().map(Result::ok).zip(painted).zip(quantities);
            self.looked =
                Some(Looked::new(each.map(|((scene, painted), of)| Some((scene?, painted?, of))), exact));
        }
        let seconds = started.elapsed().as_secs_f64();
        Ok(Drawn { size, samples, notes, seconds, seen, views: shown })
    }

    /// Loads a scene within the memory that may be taken. The first view, if it is of the same scene, then
    /// reads no file again.
    ///
    /// # Errors
    ///
    /// See [`SceneSpec::load`].
    pub fn load(&mut self, spec: &SceneSpec) -> Result<Scene, SceneError> {
        let Self { files, panes, most_memory, .. } = self;
        panes[0].load(spec, files, *most_memory)
    }

    /// Whether the CPU draws a scene in the first view.
    pub(crate) fn draws_on_cpu(&self, scene: &Scene) -> bool {
        self.panes[0].draws_on_cpu(scene)
    }

    /// Renders a scene on the CPU in bands of rows, as the first view does.
    pub(crate) fn bands_on_cpu(
        &mut self,
        scene: &Scene,
        numbers: bool,
        watch: &Watch,
        sink: &mut Bands<'_>,
    ) -> Result<(), NotDrawn> {
        let Self { maps, panes, .. } = self;
        panes[0].bands_on_cpu(scene, maps, numbers, watch, sink)
    }

    /// Renders the pixels of a scene, as the first view does.
    pub(crate) async fn pixels(
        &mut self,
        scene: &Scene,
        numbers: bool,
        watch: &Watch<'_>,
    ) -> Result<Vec<PixelOut>, NotDrawn> {
        let Self { maps, panes, .. } = self;
        panes[0].pixels(scene, maps, numbers, watch).await
    }

    /// Returns the work that lets a GPU take over from the CPU in the views of the last picture at rest, for
    /// the background; none if there is nothing to do. A GPU that is faster draws the next pictures.
    pub fn warming(&self) -> Vec<Warming> {
        let scenes = self.looked.iter().flat_map(Looked::scenes);
        let each = scenes.zip(&self.panes).filter_map(|(scene, pane)| Some((scene?, pane)));
        each.filter_map(|(scene, pane)| pane.warming(scene, &self.maps)).collect()
    }

    /// Loads the scenes of all views; with notes, and with what the first one shows.
    #[expect(clippy::type_complexity, reason = "it is taken apart at once")]
    fn scenes(
        &mut self,
        views: &[OfView],
        asked: Asked,
    ) -> Result<(Vec<Result<Scene, String>>, Vec<String>, Seen), NotDrawn> {
        let Self { files, panes, most_memory, lanes, notes: of_files, .. } = self;
        let (mut scenes, mut notes) = (Vec::with_capacity(views.len()), Vec::new());
        let mut seen = None;
        for (view, pane) in views.iter().zip(panes) {
            pane.lanes = *lanes;
            match pane.load(&view.spec, files, *most_memory) {
                Ok(whole) => {
                    notes.extend(of_files(&view.spec, &whole));
                    seen.get_or_insert_with(|| Seen::of(&whole));
                    scenes.push(Ok(reduced(&whole, asked)?));
                }
                Err(error) if scenes.is_empty() => return Err(error.into()),
                Err(error) => scenes.push(Err(error.to_string())),
            }
        }
        let mut told = BTreeSet::new();
        notes.retain(|note: &String| told.insert(note.clone()));
        let seen = seen.ok_or_else(|| NotDrawn::NoView("there is nothing to show".to_owned()))?;
        Ok((scenes, notes, seen))
    }

    /// Returns what is under a pixel of the last views at rest, as JSON; none if they have changed since, and
    /// outside of the picture.
    ///
    /// # Errors
    ///
    /// See [`Self::draw`].
    pub async fn pixel(&mut self, at: [u32; 2], watch: &Watch<'_>) -> Result<Option<Value>, NotDrawn> {
        let Self { maps, panes, looked, .. } = self;
        match looked {
            Some(looked) => looked.at(at, panes, maps, watch).await,
            None => Ok(None),
        }
    }

    /// Draws one view.
    async fn view(
        &mut self,
        number: usize,
        view: &OfView,
        scene: &Scene,
        asked: Asked,
        exact: Option<&Result<Exact, String>>,
        watch: &Watch<'_>,
    ) -> Result<(Painted, RenderInfo), NotDrawn> {
        let Self { maps, panes, .. } = self;
        let Some(quantity) = view.quantity else {
            if asked.is_quick
                && let Some(drawn) = panes[number].screen(scene, maps, watch).await?
            {
                return Ok(drawn);
            }
            let rows = asked.rows_of(scene.size()[1]);
            return panes[number].picture(scene, rows, maps, watch).await;
        };
        if let Some(why) = view.spec.why_not_shown(view.shown) {
            return Err(NotDrawn::NotShown(why));
        }
        quantity.check(scene)?;
        let judge: Option<&dyn Judge> = match exact.filter(|_| view.is_compared()) {
            Some(Ok(exact)) => Some(exact.judge()),
            Some(Err(said)) => return Err(NotDrawn::NoView(said.clone())),
            None => None,
        };
        panes[number].quantity(scene, quantity, judge, maps, watch).await
    }

    /// The exact picture, if a view is compared with it; or the reason why there is none.
    fn exact(
        &mut self,
        views: &[OfView],
        scenes: &[Result<Scene, String>],
        watch: &Watch,
    ) -> Result<Option<Result<Exact, String>>, NotDrawn> {
        let compared = || views.iter().zip(scenes).filter(|(view, _)| view.is_compared());
        let Some(scene) = compared().find_map(|(_, scene)| scene.as_ref().ok()) else { return Ok(None) };
        let quantities = compared().filter_map(|(view, _)| view.quantity);
        let lanes = self.lanes.unwrap_or_else(Lanes::widest);
        match Exact::of(quantities, scene, lanes, &mut self.maps, watch).map_err(NotDrawn::from) {
            Ok(exact) => Ok(Some(Ok(exact))),
            Err(NotDrawn::Cancelled(cancelled)) => Err(cancelled.into()),
            Err(error) => Ok(Some(Err(error.to_string()))),
        }
    }
}

/// A view to be drawn.
struct OfView {
    shown: Shown,
    quantity: Option<&'static Quantity>,
    spec: SceneSpec,
}

impl OfView {
    /// Whether it is compared with the exact picture.
    fn is_compared(&self) -> bool {
        let is_comparison = self.quantity.is_some_and(|quantity| quantity.value.is_comparison());
        is_comparison && self.spec.why_not_shown(self.shown).is_none()
    }
}

/// The views of a scene. What is compared with the exact picture has the finest level of the maps, as in
/// `relief compare`.
fn of_views(spec: &SceneSpec) -> Vec<OfView> {
    let view = |(shown, spec): (Shown, SceneSpec)| {
        let view = OfView { shown, quantity: quantity_of(shown), spec };
        match view.is_compared() {
            true => OfView { spec: view.spec.at_finest_level(), ..view },
            false => view,
        }
    };
    spec.views().into_iter().map(view).collect()
}

impl View {
    fn of(
        view: &OfView,
        scene: Option<&Scene>,
        made: &Made,
        scale: Option<&Scale>,
        exact: Option<&Exact>,
    ) -> Self {
        let show = view.shown.name();
        let (Ok((painted, info)), Some(scene)) = (made, scene) else {
            let said = made.as_ref().err().map_or("", String::as_str);
            return Self {
                about: json!({ "show": show, "failed": said, "rows": [0, 0] }),
                pixels: Vec::new(),
            };
        };
        let mut methods: Vec<String> =
            scene.surfaces().iter().map(|surface| surface.selection().method_name()).collect();
        methods.dedup();
        let legend = view.quantity.zip(scale).map(|(quantity, scale)| colors::legend(quantity, scale));
        let compared = view.quantity.filter(|_| view.is_compared()).zip(exact);
        let errors = compared.and_then(|(quantity, exact)| colors::errors(quantity, exact, painted, scene));
        let about = json!({
            "show": show, "method": methods.join(", "), "backend": info.backend, "device": info.device,
            "failed": null, "legend": legend, "errors": errors, "rows": painted.rows(scene.size()[1]),
        });
        Self { about, pixels: colors::bytes(painted, scale, scene.size()) }
    }
}

impl Drawn {
    /// Returns what a page shows of the views, as JSON. `said` makes its texts fit for the page: notes, and
    /// why a view is not there.
    pub fn about(&self, revision: u64, said: impl Fn(&str) -> String) -> Value {
        let view = |view: &View| {
            let mut about = view.about.clone();
            about["failed"] = about["failed"].as_str().map_or(Value::Null, |failed| json!(said(failed)));
            about
        };
        json!({
            "revision": revision, "size": self.size, "samples": self.samples, "seconds": self.seconds,
            "notes": self.notes.iter().map(|note| said(note)).collect::<Vec<_>>(),
            "views": self.views.iter().map(view).collect::<Vec<_>>(),
        })
    }

    /// Returns red, green, blue and 255 of all pixels of the rows that were asked for, from the top: of all views
    /// that could be drawn, one after the other.
    pub fn into_pixels(self) -> Vec<u8> {
        let mut views = self.views.into_iter().map(|view| view.pixels);
        let mut all = views.next().unwrap_or_default();
        views.for_each(|pixels| all.extend(pixels));
        all
    }
}

/// Returns the scene with a size: the pane's, if it has none of its own.
pub fn shown(spec: &SceneSpec, pane: [u32; 2]) -> SceneSpec {
    SceneSpec { size: spec.size.or(Some(pane.into())), ..spec.clone() }
}

/// The scene of a quick picture. Its surfaces are the whole one's, so that nothing is baked for it.
fn reduced(scene: &Scene, asked: Asked) -> Result<Scene, ValueError> {
    let part = if asked.part.is_finite() { asked.part.clamp(0.01, 1.0) } else { 1.0 };
    let [width, height] = scene.size().map(|side| ((f64::from(side) * part).round() as u32).max(1));
    let samples = if asked.is_quick { 1 } else { scene.samples() };
    if [width, height] == scene.size() && samples == scene.samples() {
        return Ok(scene.clone());
    }
    scene.to_builder().size(width, height).samples(samples).build()
}
