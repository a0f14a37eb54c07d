//! Loading of one scene after the other, as a viewer does: files are read again where their keys changed.

use std::path::PathBuf;
use std::time::SystemTime;

use relief_core::ByteSize;
use relief_shaders::{AMBIENT, DETAIL, SHADOW, Selection};

use super::{Scene, SceneError, SceneSpec, Surface};

/// Loads scenes one after the other, and keeps what the next one shares with the last.
///
/// A scene that differs from the last one in camera, lights, size, samples or tone alone is loaded without a
/// file being read. It is the same scene that [`SceneSpec::load`] returns, but for the memory that is left for
/// triangles, and its surfaces share what the last scene's have, so that a renderer finds again what it built.
///
/// Files that changed on the disk since then are read again.
///
/// # Examples
///
/// ```no_run
/// use relief_scene::{SceneReader, read_scene};
///
/// let mut spec = read_scene("wall.toml".as_ref())?;
/// let mut reader = SceneReader::default();
/// let first = reader.load(&spec)?;
/// spec.eye = Some([1.0, 0.5, 0.0]);
/// let turned = reader.load(&spec)?;
/// assert!(std::sync::Arc::ptr_eq(first.surfaces()[0].mesh(), turned.surfaces()[0].mesh()));
/// # Ok::<(), relief_scene::SceneError>(())
/// ```
#[derive(Debug, Default)]
pub struct SceneReader {
    last: Option<Last>,
}

/// The last scene that was loaded.
#[derive(Debug)]
struct Last {
    asked: SceneSpec,
    /// With what folders of textures and files of meshes say.
    whole: SceneSpec,
    /// The selections that the description gave.
    selections: Vec<Selection>,
    scene: Scene,
    read: Vec<Stamp>,
}

/// A file and what it was when it was read.
#[derive(Debug, PartialEq)]
struct Stamp {
    path: PathBuf,
    state: Option<(u64, Option<SystemTime>)>,
}

impl SceneReader {
    /// Loads a scene.
    ///
    /// # Errors
    ///
    /// See [`SceneSpec::load`]. The scene before stays known.
    pub fn load(&mut self, spec: &SceneSpec) -> Result<Scene, SceneError> {
        if let Some(last) = &self.last
            && let Some(scene) = last.seen_by(spec)?
        {
            return Ok(scene);
        }
        let (whole, notes) = spec.whole()?;
        // What changes while it is read is read again.
        let read = stamps(&whole);
        let scene = whole.load_whole(notes)?;
        let selections = whole.selections()?;
        let last = Last { asked: spec.clone(), whole, selections, scene: scene.clone(), read };
        self.last = Some(last);
        Ok(scene)
    }
}

impl Last {
    /// This scene as another description shows it, if no file must be read for it.
    fn seen_by(&self, spec: &SceneSpec) -> Result<Option<Scene>, SceneError> {
        let is_known = surfaces_of(spec) == surfaces_of(&self.asked)
            && !spec.is_of_map_size()
            && !self.asked.is_of_map_size()
            && !self.whole.each_surface().iter().any(|surface| surface.has_walls());
        if !is_known || stamps(&self.whole) != self.read {
            return Ok(None);
        }
        let Self { whole, scene, .. } = self;
        let whole = SceneSpec {
            surface: whole.surface.clone(),
            surfaces: whole.surfaces.clone(),
            environment: whole.environment.clone(),
            ..spec.clone()
        };
        whole.check()?;
        let selections = whole.selections()?;
        let each = scene.surfaces.iter().zip(&self.selections).zip(&selections);
        let surfaces: Option<Vec<Surface>> = each
            .map(|((surface, before), after)| {
                // What a file changed in the selection is not known here.
                let is_own = is_same(surface.selection(), before);
                (is_own && is_alike(before, after)).then(|| with_seen(surface, after))
            })
            .collect();
        let Some(surfaces) = surfaces.filter(|surfaces| surfaces.len() == selections.len()) else {
            return Ok(None);
        };
        // The surfaces stay, the picture may be another.
        let room =
            scene.geometry_memory.0.saturating_add(self.whole.bytes_beside_surfaces(&self.selections)?);
        let left = room.checked_sub(whole.bytes_beside_surfaces(&selections)?);
        let Some(left) = left else { return Ok(None) };
        let mut builder = whole.builder(surfaces)?;
        if let Some(environment) = &scene.environment {
            builder = builder.environment(environment.clone());
        }
        let notes = scene.notes.clone();
        let scene = builder.geometry_memory(ByteSize(left)).build()?;
        Ok(Some(Scene { notes, ..scene }))
    }
}

/// The stages whose settings follow from samples and size of a picture. Of the detail the variant does, too.
const SEEN: [usize; 3] = [DETAIL, SHADOW, AMBIENT];

/// Whether two selections are the same but for what follows from the picture.
fn is_alike(one: &Selection, other: &Selection) -> bool {
    let mut each = one.choices.iter().zip(&other.choices).enumerate();
    each.all(|(stage, (one, other))| {
        (one.number == other.number || stage == DETAIL)
            && (one.params == other.params || SEEN.contains(&stage))
    })
}

/// Whether two selections are the same.
fn is_same(one: &Selection, other: &Selection) -> bool {
    let mut each = one.choices.iter().zip(&other.choices);
    each.all(|(one, other)| one.number == other.number && one.params == other.params)
}

/// A surface with the choices that follow from the picture.
fn with_seen(surface: &Surface, selection: &Selection) -> Surface {
    let mut own = *surface.selection();
    for stage in SEEN {
        own.choices[stage] = selection.choices[stage];
    }
    surface.clone().with_selection(own)
}

/// What surfaces depend on: a description without camera, lights and picture.
fn surfaces_of(spec: &SceneSpec) -> SceneSpec {
    SceneSpec {
        surface: spec.surface.clone(),
        surfaces: spec.surfaces.clone(),
        // It shades materials, and shares shadows.
        look: spec.look,
        environment: spec.environment.clone(),
        max_memory: spec.max_memory,
        ..SceneSpec::default()
    }
}

/// The files that a description names, as they are now.
fn stamps(spec: &SceneSpec) -> Vec<Stamp> {
    let state = |path: &PathBuf| {
        let about = std::fs::metadata(path).ok()?;
        Some((about.len(), about.modified().ok()))
    };
    spec.files().map(|path| Stamp { state: state(path), path: path.clone() }).collect()
}
