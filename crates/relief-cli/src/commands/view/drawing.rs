//! Pictures for the page: one view, or two of the same scene by two methods. A drawing keeps what its scenes share:
//! files that were read, baked maps, and what the renderers have built.

use std::collections::BTreeSet;
use std::time::Instant;

use relief_compare::{CompareError, ExactPicture};
use relief_core::Watch;
use relief_maps::Maps;
use relief_render::RenderInfo;
use relief_render::false_color::{Judge, Quantity, Scale, quantity_of};
use relief_scene::{Scene, SceneError, SceneSpec, Shown};
use relief_session::Seen;
use serde_json::{Value, json};

use super::colors;
use super::pane::{Painted, Pane};
use super::pixel::Looked;
use super::said;
use crate::commands::maps::{By, of_reading};
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

/// The views of a scene.
pub struct Drawn {
    pub size: [u32; 2],
    pub samples: u32,
    pub notes: Vec<String>,
    pub seconds: f64,
    pub seen: Seen,
    pub views: Vec<View>,
}

/// One view.
pub struct View {
    /// What the page learns of it.
    about: Value,
    /// Red, green, blue and 255, row by row from the top; none if it cannot be drawn.
    pixels: Vec<u8>,
}

/// A view that has been drawn, or the reason why it cannot be.
type Made = Result<(Painted, RenderInfo), String>;

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
    maps: Maps,
    panes: Vec<Pane>,
    /// The last picture of a view at rest.
    looked: Option<Looked>,
}

impl Drawing {
    pub fn new(maps: Maps) -> Self {
        Self { maps, panes: Vec::new(), looked: None }
    }

    /// Draws the views of a scene.
    pub fn draw(&mut self, spec: &SceneSpec, asked: Asked, watch: &Watch) -> Result<Drawn, NotDrawn> {
        let started = Instant::now();
        self.looked = None;
        let views = of_views(&shown(spec, asked.pane));
        self.panes.resize_with(views.len(), Pane::default);
        let (scenes, notes, seen) = self.scenes(&views, asked)?;
        let exact = self.exact(&views, &scenes, watch)?;
        let mut made: Vec<Made> = Vec::new();
        for (number, (view, scene)) in views.iter().zip(&scenes).enumerate() {
            let scene = scene.as_ref().map_err(|said| NotDrawn::Failed(said.clone()));
            let drawn = scene.and_then(|scene| self.view(number, view, scene, exact.as_ref(), watch));
            made.push(match drawn {
                Ok(drawn) => Ok(drawn),
                Err(NotDrawn::Failed(said)) => Err(said),
                Err(NotDrawn::Ended) => return Err(NotDrawn::Ended),
            });
        }
        if let Some(Err(said)) = made.first().filter(|_| made.iter().all(Result::is_err)) {
            return Err(NotDrawn::Failed(said.clone()));
        }
        let exact = exact.and_then(Result::ok);
        let shown = views.iter().zip(&made).zip(&scenes).map(|((view, own), scene)| {
            let scale = view.quantity.map(|quantity| {
                let same = views.iter().zip(&made).filter(|(other, _)| other.shown == view.shown);
                colors::scale(quantity, same.filter_map(|(_, made)| Some(&made.as_ref().ok()?.0)))
            });
            View::of(view, scene.as_ref().ok(), own, scale.as_ref(), exact.as_ref())
        });
        let shown: Vec<View> = shown.collect();
        let [size, samples] = match scenes.first() {
            Some(Ok(scene)) => [scene.size(), [scene.samples(); 2]],
            _ => [[0; 2]; 2],
        };
        if !asked.is_quick {
            let painted = made.into_iter().map(|made| made.ok().map(|(painted, _)| painted));
            self.looked = Some(Looked::new(scenes.into_iter().map(Result::ok).zip(painted), exact));
        }
        let seconds = started.elapsed().as_secs_f64();
        Ok(Drawn { size, samples: samples[0], notes, seconds, seen, views: shown })
    }

    /// Loads the scenes of all views; with notes, and with what the first one shows.
    #[expect(clippy::type_complexity, reason = "it is taken apart at once")]
    fn scenes(
        &mut self,
        views: &[OfView],
        asked: Asked,
    ) -> Result<(Vec<Result<Scene, String>>, Vec<String>, Seen), NotDrawn> {
        let mut notes: Vec<String> = Vec::new();
        let (mut scenes, mut seen) = (Vec::new(), None);
        for (view, pane) in views.iter().zip(&mut self.panes) {
            match pane.reader.load(&view.spec) {
                Ok(whole) => {
                    let of_files = of_reading(&view.spec, &whole, By::Keys);
                    notes.extend(of_files.iter().map(ToString::to_string));
                    seen.get_or_insert_with(|| Seen::of(&whole));
                    scenes.push(Ok(reduced(&whole, asked)?));
                }
                Err(error) if scenes.is_empty() => return Err(NotDrawn::Failed(said::of_scene(&error))),
                Err(error) => scenes.push(Err(said::of_scene(&error))),
            }
        }
        let mut told = BTreeSet::new();
        notes.retain(|note| told.insert(note.clone()));
        let seen = seen.ok_or_else(|| NotDrawn::Failed("there is nothing to show".to_owned()))?;
        Ok((scenes, notes, seen))
    }

    /// Loads a scene. The first view, if it is of the same scene, then reads no file again.
    pub fn load(&mut self, spec: &SceneSpec) -> Result<(), SceneError> {
        if self.panes.is_empty() {
            self.panes.push(Pane::default());
        }
        self.panes[0].reader.load(spec).map(drop)
    }

    /// What is under a pixel of the last views at rest; none if they have changed since.
    pub fn pixel(&mut self, at: [u32; 2], watch: &Watch) -> Result<Option<Value>, NotDrawn> {
        let Self { maps, panes, looked } = self;
        looked.as_mut().map_or(Ok(None), |looked| looked.at(at, panes, maps, watch))
    }

    /// Draws one view.
    fn view(
        &mut self,
        number: usize,
        view: &OfView,
        scene: &Scene,
        exact: Option<&Result<ExactPicture, String>>,
        watch: &Watch,
    ) -> Result<(Painted, RenderInfo), NotDrawn> {
        let Self { maps, panes, .. } = self;
        let Some(quantity) = view.quantity else { return panes[number].picture(scene, maps, watch) };
        quantity.check(scene).map_err(|error| NotDrawn::Failed(error.to_string()))?;
        let judge: Option<&dyn Judge> = match exact.filter(|_| view.is_compared()) {
            Some(Ok(exact)) => {
                colors::check(quantity, exact, scene).map_err(NotDrawn::Failed)?;
                Some(exact)
            }
            Some(Err(said)) => return Err(NotDrawn::Failed(said.clone())),
            None => None,
        };
        panes[number].quantity(scene, quantity, judge, maps, watch)
    }

    /// The exact picture, if a view is compared with it; or the reason why there is none.
    fn exact(
        &mut self,
        views: &[OfView],
        scenes: &[Result<Scene, String>],
        watch: &Watch,
    ) -> Result<Option<Result<ExactPicture, String>>, NotDrawn> {
        let mut compared = views.iter().zip(scenes).filter(|(view, _)| view.is_compared());
        let Some(scene) = compared.find_map(|(_, scene)| scene.as_ref().ok()) else { return Ok(None) };
        match ExactPicture::new(scene, lanes::from_environment()?, &mut self.maps, watch) {
            Ok(exact) => Ok(Some(Ok(exact))),
            Err(CompareError::Cancelled(_)) => Err(NotDrawn::Ended),
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
    fn is_compared(&self) -> bool {
        self.quantity.is_some_and(|quantity| quantity.value.is_comparison())
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
        exact: Option<&ExactPicture>,
    ) -> Self {
        let show = view.shown.name();
        let (Ok((painted, info)), Some(scene)) = (made, scene) else {
            let said = made.as_ref().err().map_or("", String::as_str);
            return Self { about: json!({ "show": show, "failed": said }), pixels: Vec::new() };
        };
        let selection = scene.surfaces().first().map(|surface| surface.selection().method_name());
        let legend = view.quantity.zip(scale).map(|(quantity, scale)| colors::legend(quantity, scale));
        let compared = view.quantity.filter(|_| view.is_compared()).zip(exact);
        let errors = compared.and_then(|(quantity, exact)| colors::errors(quantity, exact, painted, scene));
        let about = json!({
            "show": show, "method": selection, "backend": info.backend, "device": info.device,
            "failed": null, "legend": legend, "errors": errors,
        });
        Self { about, pixels: colors::bytes(painted, scale, scene.size()) }
    }
}

impl Drawn {
    /// What the page learns of the views.
    pub fn about(&self, revision: u64) -> Value {
        let views: Vec<&Value> = self.views.iter().map(|view| &view.about).collect();
        json!({
            "revision": revision, "size": self.size, "samples": self.samples, "seconds": self.seconds,
            "notes": self.notes, "views": views,
        })
    }

    /// The pixels of all views that could be drawn, one after the other.
    pub fn into_pixels(self) -> impl Iterator<Item = Vec<u8>> {
        self.views.into_iter().map(|view| view.pixels)
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
