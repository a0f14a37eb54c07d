//! Execution of a comparison: rays first, then pictures, for each level of the map and each scale.

mod pictures;
mod rays;
pub(crate) mod reference;
pub(crate) mod shadow;
pub(crate) mod subject;
mod time_again;
mod times;

use relief_core::registry::RayClass;
use relief_core::{Cancelled, MapFormat, MapIdentity, Watch};
use relief_maps::{Maps, Origin, Provided};
use relief_render::{RenderError, Renderer};
use relief_scene::{Look, Surface};
use relief_shaders::{GEOMETRY, REFINE, SEARCH, Selection};

use self::subject::Subject;
use crate::comparison::{Comparison, Machine};
use crate::contender::Contender;
use crate::error::CompareError;
use crate::picture::{Flip, Image};
use crate::record::{About, LeftOut, MethodRecord, Records};

/// Results of a comparison.
#[derive(Clone, Debug, Default)]
pub struct Compared {
    /// Figures.
    pub records: Records,
    /// Pictures, one for each of [`Records::pictures`] in their order.
    pub shown: Vec<MethodPicture>,
    /// Reference pictures.
    pub references: Vec<Reference>,
    /// Drawings of how methods find a hit, one for each method that follows rays.
    pub drawings: Vec<MethodDrawing>,
    /// Look whose light and background the displayed pictures have, unless they are the scene's
    /// own.
    pub shown_look: Option<Look>,
}

/// Drawing of a method's way to a hit, on the [default ray](crate::explain::Ray) through the first
/// map that is compared.
#[derive(Clone, Debug)]
pub struct MethodDrawing {
    /// Name of the method.
    pub method: String,
    /// Drawing as SVG.
    pub svg: String,
}

/// Picture of a method.
#[derive(Clone, Debug)]
pub struct MethodPicture {
    /// Picture.
    pub image: Image,
    /// Difference from the reference.
    pub difference: Flip,
    /// Index of the reference in [`Compared::references`].
    pub reference: usize,
}

/// Reference picture, with which others are compared.
#[derive(Clone, Debug)]
pub struct Reference {
    /// Columns and rows of the height map; of the first one if there are several surfaces.
    pub map_size: [u32; 2],
    /// Metres between heights 0 and 1; of the first map if there are several surfaces.
    pub scale_m: f64,
    /// Name of the shadow; of the first surface if there are several.
    pub shadow: String,
    /// Metres between the camera and its target, if distances are compared.
    pub distance_m: Option<f64>,
    /// Picture.
    pub image: Image,
}

/// Baked maps of methods, and their baking times.
struct Baked {
    /// Providers of maps, by format.
    maps: Vec<(MapFormat, Maps)>,
    seconds: Vec<(MapFormat, MapIdentity, f64)>,
}

/// Maps of a method.
#[derive(Default)]
struct MapsOf {
    /// Identities of the maps.
    identities: Vec<MapIdentity>,
    /// Total size in bytes.
    bytes: u64,
    /// Total baking time in seconds.
    seconds: f64,
}

impl Baked {
    fn new() -> Self {
        Self { maps: Vec::new(), seconds: Vec::new() }
    }

    /// Returns the provider of maps of a format.
    fn maps(&mut self, format: MapFormat) -> &mut Maps {
        let known = self.maps.iter().position(|(known, _)| *known == format);
        let place = known.unwrap_or(self.maps.len());
        if known.is_none() {
            self.maps.push((format, Maps::in_memory().with_format(format)));
        }
        &mut self.maps[place].1
    }

    /// Provides the maps of a method on a surface, and adds them to those that it reads.
    fn provide(
        &mut self,
        selection: &Selection,
        format: MapFormat,
        surface: &Surface,
        read: &mut MapsOf,
        watch: &Watch,
    ) -> Result<Provided, CompareError> {
        watch.check()?;
        let maps = self.maps(format);
        let provided = maps.provide(selection, surface.height_map(), surface.metric(), &watch.quiet())?;
        let mut different: Vec<(&MapIdentity, u64)> = Vec::new();
        for (_, map) in provided.maps() {
            if !different.iter().any(|(known, _)| *known == map.identity()) {
                different.push((map.identity(), map.layout().bytes()));
            }
        }
        for ((identity, bytes), account) in different.into_iter().zip(provided.accounts()) {
            if account.origin == Origin::Bake {
                self.seconds.push((format, identity.clone(), account.elapsed.as_secs_f64()));
            }
            // A map that several surfaces share is counted once.
            if read.identities.contains(identity) {
                continue;
            }
            read.identities.push(identity.clone());
            read.bytes += bytes;
            let known = self.seconds.iter().find(|(of, known, _)| (*of, known) == (format, identity));
            read.seconds += known.map_or(0.0, |(_, _, seconds)| *seconds);
        }
        Ok(provided)
    }
}

impl Comparison {
    /// Runs the comparison. The watch's tasks are the methods; its progress covers the whole
    /// comparison.
    ///
    /// # Errors
    ///
    /// When a number is not possible, there is nothing to compare, a map cannot be baked, a picture
    /// cannot be rendered, or the work was cancelled. Methods that cannot be used on the surfaces
    /// are [left out](Records::left_out), with the reason.
    pub fn run(&self, watch: &Watch) -> Result<Compared, CompareError> {
        self.run_on(&|machine| Renderer::new(machine.backend_choice(), machine.sampling), watch)
    }

    /// Runs the comparison with renderers from the caller, for example on a device that is already
    /// open.
    ///
    /// # Errors
    ///
    /// See [`Self::run`].
    pub fn run_on(&self, renderers: &Renderers, watch: &Watch) -> Result<Compared, CompareError> {
        self.check()?;
        let surfaces = self.scene.surfaces();
        let mut compared = Compared { shown_look: self.shown_look, ..Compared::default() };
        let left_out = &mut compared.records.left_out;
        let mut usable = Vec::new();
        for contender in self.entrants()? {
            let what = contender.label();
            match contender.on_all(surfaces) {
                Ok(used) => {
                    left_out.extend(used.others.into_iter().map(|(number, error)| LeftOut {
                        what: format!("{what} on surface {}", number + 1),
                        reason: error.to_string(),
                    }));
                    usable.push(contender);
                }
                Err(error) => left_out.push(LeftOut { what, reason: error.to_string() }),
            }
        }
        if surfaces.len() > 1 && self.rays > 0 {
            left_out.push(LeftOut {
                what: "errors of hits, along rays and in pictures".to_owned(),
                reason: format!(
                    "the scene has {} surfaces that hide each other, and a true hit belongs to one map",
                    surfaces.len()
                ),
            });
        }
        let subjects = self.subjects()?;
        let is_flat = matches!(surfaces, [surface] if reference::is_flat(surface.mesh()));
        let seen = if self.shadows.is_empty() { usable.clone() } else { without_shadows(&usable) };
        let of_rays = if is_flat && self.rays > 0 { seen.len() } else { 0 };
        let truths = self.shadows.len().max(1);
        let of_pictures =
            if self.machines.is_empty() { 0 } else { truths + (usable.len() + 1) * self.machines.len() };
        let of_pictures = of_pictures * self.distances_m.len().max(1);
        let parts = subjects.len() * (of_rays + of_pictures);
        let mut work = Work { baked: Baked::new(), compared, watch: *watch, parts, done: 0 };
        if of_rays > 0 {
            for subject in &subjects {
                self.rays(subject, &seen, &mut work)?;
            }
        }
        self.pictures(renderers, &subjects, &usable, &mut work)?;
        let mut compared = work.compared;
        let first = surfaces.first();
        let map = first.map(Surface::height_map);
        compared.records.about = About {
            map: self.name.clone(),
            map_size: map.map_or([0; 2], |map| [map.width(), map.height()]),
            tile_m: first.map_or([0.0; 2], |surface| surface.metric().tile_m),
            surfaces: surfaces.len(),
            program: format!("relief {}", env!("CARGO_PKG_VERSION")),
            reference: reference::words(surfaces).to_owned(),
            ..compared.records.about
        };
        Ok(compared)
    }
}

/// Creates the renderer of a machine.
pub type Renderers<'a> = dyn Fn(Machine) -> Result<Renderer, RenderError> + 'a;

/// Returns the methods without shadows, each once: shadows do not affect view rays.
fn without_shadows(contenders: &[Contender]) -> Vec<Contender> {
    let mut seen: Vec<Contender> = Vec::new();
    for contender in contenders {
        let contender = Contender { shadow: None, ..contender.clone() };
        if !seen.iter().any(|known| known.label() == contender.label()) {
            seen.push(contender);
        }
    }
    seen
}

/// State of a running comparison.
struct Work<'a> {
    /// Maps that methods read.
    baked: Baked,
    /// Results so far.
    compared: Compared,
    watch: Watch<'a>,
    /// Total number of parts, and the number done.
    parts: usize,
    done: usize,
}

impl Work<'_> {
    /// Reports the next task.
    fn next(&mut self, what: &str) -> Result<(), Cancelled> {
        self.watch.task(what).at(self.done as f32 / self.parts.max(1) as f32)?;
        self.done += 1;
        Ok(())
    }
}

/// Machine with its renderer.
struct MachineRenderer {
    machine: Machine,
    renderer: Renderer,
}

impl MethodRecord {
    fn of(contender: &Contender, subject: &Subject, maps: &MapsOf) -> Self {
        let name = |place: usize| contender.selection.choices[place].entry.name.to_owned();
        Self {
            method: contender.name.clone(),
            steps: contender.steps,
            steps_key: contender.steps.and(contender.steps_key()).map(str::to_owned),
            map_format: contender.map_format.map(|format| format.name().to_owned()),
            shadow: contender.shadow.map(|shadow| shadow.entry.name.to_owned()),
            geometry: name(GEOMETRY),
            search: name(SEARCH),
            refine: name(REFINE),
            promise: contender.selection.guarantee(RayClass::View).name().to_owned(),
            map_size: subject.map_size,
            map_texels: subject.map_texels(),
            scale_m: subject.scale_m,
            map_bytes: maps.bytes,
            bake_seconds: maps.seconds,
        }
    }
}
