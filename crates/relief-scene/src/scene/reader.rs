//! Loading of one scene after the other, as a viewer does: files are read again where their keys changed.

use std::path::{Path, PathBuf};

use relief_core::ByteSize;
use relief_io::{FileStamp, Files, files_of_mesh};
use relief_object::read_description;
use relief_shaders::{AMBIENT, DETAIL, SHADOW, Selection};

use super::{Scene, SceneError, SceneSpec, Surface};

/// Loads scenes one after the other, and keeps what the next one shares with the last.
///
/// A scene that differs from the last one in camera, lights, size, samples or tone alone is loaded
/// without a file being read. It is the same scene that [`SceneSpec::load`] returns, but for the memory
/// that is left for triangles, and its surfaces share what the last scene's have, so that a renderer
/// finds again what it built.
///
/// Files that changed since then are read again, and so are the scene's other files.
///
/// # Examples
///
/// ```no_run
/// use relief_scene::{SceneReader, read_scene};
///
/// let mut spec = read_scene("wall.toml")?;
/// let mut reader = SceneReader::default();
/// let first = reader.load(&spec)?;
/// spec.eye = Some([1.0, 0.5, 0.0]);
/// let turned = reader.load(&spec)?;
/// assert!(std::sync::Arc::ptr_eq(first.surfaces()[0].mesh(), turned.surfaces()[0].mesh()));
/// # Ok::<(), relief_scene::SceneError>(())
/// ```
#[derive(Debug, Default)]
pub struct SceneReader {
    files: Files,
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
    /// The files and their states when they were read.
    read: Vec<(PathBuf, Option<FileStamp>)>,
}

impl SceneReader {
    /// Creates a reader of scenes whose files are in `files`. The default is the disk.
    pub fn of_files(files: Files) -> Self {
        Self { files, last: None }
    }

    /// Returns the files.
    pub fn files(&self) -> &Files {
        &self.files
    }

    /// Returns the files for changing them.
    pub fn files_mut(&mut self) -> &mut Files {
        &mut self.files
    }

    /// Loads a scene.
    ///
    /// # Errors
    ///
    /// See [`SceneSpec::load`]. The scene before stays known.
    pub fn load(&mut self, spec: &SceneSpec) -> Result<Scene, SceneError> {
        if let Some(last) = &self.last
            && let Some(scene) = last.seen_by(spec, &self.files)?
        {
            return Ok(scene);
        }
        let files = &self.files;
        let (whole, notes) = spec.whole(files)?;
        // What changes while it is read is read again.
        let read = named_files(&whole, spec, files).into_iter();
        let read = read.map(|path| (path.clone(), files.stamp(&path))).collect();
        let scene = whole.load_whole(files, notes)?;
        let selections = whole.selections()?;
        let last = Last { asked: spec.clone(), whole, selections, scene: scene.clone(), read };
        self.last = Some(last);
        Ok(scene)
    }
}

impl Last {
    /// This scene as another description shows it, if no file must be read for it.
    fn seen_by(&self, spec: &SceneSpec, files: &Files) -> Result<Option<Scene>, SceneError> {
        let is_known = surfaces_of(spec) == surfaces_of(&self.asked)
            && !spec.is_of_map_size()
            && !self.asked.is_of_map_size()
            && !self.whole.each_surface().iter().any(|surface| surface.has_walls());
        if !is_known || self.read.iter().any(|(path, state)| files.stamp(path) != *state) {
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

/// The files that a scene is read from, as far as their names are known. `asked` is the description without
/// the content of folders.
fn named_files(whole: &SceneSpec, asked: &SceneSpec, files: &Files) -> Vec<PathBuf> {
    let mut named: Vec<PathBuf> = asked.files().chain(whole.files()).cloned().collect();
    for path in whole.files() {
        named.extend(files_of_mesh(files.source(path)));
    }
    for object in whole.each_surface().iter().filter_map(|surface| surface.object.as_deref()) {
        named.extend(files_of_object(object, files));
    }
    named.sort();
    named.dedup();
    named
}

/// The pictures of an object. None if its file cannot be read.
fn files_of_object(path: &Path, files: &Files) -> Vec<PathBuf> {
    let Ok(description) = read_description(files.source(path)) else { return Vec::new() };
    let names = [Some(description.depth), description.color, description.normal];
    names.into_iter().flatten().map(|name| path.with_file_name(name)).collect()
}
