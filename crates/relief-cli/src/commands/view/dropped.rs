//! Files that come in from the page: kept in a folder of the session, recognised, and put into the scene.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Read, Write};
use std::path::{Component, Path, PathBuf};

use relief_io::{MeshFormat, find_textures};
use relief_scene::{MeshChoice, SceneSpec, SurfaceSpec, read_scene};
use relief_session::{Changed, Session};
use tempfile::TempDir;

use crate::commands::scene_arguments::of_scene_file;
use crate::failure::Failure;
use crate::file_kind::FileKind;

/// Most files that come in at once.
const MAX_FILES: usize = 1000;

/// Most bytes of all files that come in at once.
const MAX_BYTES: u64 = 8 << 30;

/// Most parts of a path.
const MAX_PARTS: usize = 16;

/// The files of the session, each group in a folder of its own.
pub struct Dropped {
    folder: TempDir,
    groups: BTreeMap<u64, Group>,
}

#[derive(Default)]
struct Group {
    files: Vec<PathBuf>,
    bytes: u64,
}

impl Dropped {
    pub fn new() -> Result<Self, Failure> {
        let folder = tempfile::Builder::new().prefix("relief-view-").tempdir();
        let folder = folder
            .map_err(|error| Failure::Work(format!("a folder for dropped files cannot be made: {error}")))?;
        Ok(Self { folder, groups: BTreeMap::new() })
    }

    /// Removes all files. Threads that still wait for a request hold them, so nobody else would.
    pub fn remove(&self) -> Result<(), Failure> {
        let folder = self.folder.path();
        fs::remove_dir_all(folder).map_err(|error| {
            Failure::Work(format!("{}: the dropped files cannot be removed: {error}", folder.display()))
        })
    }

    /// The folder of all files.
    pub fn folder(&self) -> &Path {
        self.folder.path()
    }

    /// The place for a file of a group: where it is to be written.
    pub fn place(&mut self, number: u64, path: &str, length: u64) -> Result<PathBuf, String> {
        let inside = inside(path).ok_or_else(|| format!("'{path}' is no path of a dropped file"))?;
        let root = self.root(number);
        let group = self.groups.entry(number).or_default();
        if group.files.len() >= MAX_FILES {
            return Err(format!("more than {MAX_FILES} files come at once: drop fewer"));
        }
        if group.bytes.saturating_add(length) > MAX_BYTES {
            return Err(format!("{path}: the files are larger than 8 GiB together: drop fewer"));
        }
        group.bytes += length;
        let place = root.join(inside);
        if !group.files.contains(&place) {
            group.files.push(place.clone());
        }
        Ok(place)
    }

    fn root(&self, number: u64) -> PathBuf {
        self.folder.path().join(number.to_string())
    }

    /// Puts the files of a group into the scene; onto a key, if one is named.
    pub fn take(&mut self, number: u64, key: Option<&str>, session: &mut Session) -> Result<Changed, String> {
        let group = self.groups.remove(&number).ok_or("no file has come")?;
        let files: Vec<PathBuf> = group.files.into_iter().filter(|file| is_meant(file)).collect();
        if let Some(key) = key {
            let [file] = &files[..] else { return Err(format!("{key}: it takes one file")) };
            let path = toml::Value::String(file.display().to_string()).to_string();
            return session.take_value(key, &path).map_err(|refused| refused.to_string());
        }
        let (change, is_whole) = change(&files)?;
        if !is_whole && !session.spec().surfaces.is_empty() {
            return Err("the scene has several surfaces: drop the file onto a control of one".to_owned());
        }
        session.take(&*change).map_err(|refused| refused.to_string())
    }

    /// A text in which files of the page have the names that the user knows.
    pub fn named(&self, text: &str) -> String {
        let start = format!("{}/", self.folder.path().display());
        let mut parts = text.split(&start);
        let mut named = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            // The number of a group.
            named += part.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start_matches('/');
        }
        named
    }
}

/// A path within a folder.
fn inside(path: &str) -> Option<PathBuf> {
    let path = PathBuf::from(path);
    let is_plain = path.components().all(|part| matches!(part, Component::Normal(_)));
    let count = path.components().count();
    let is_short = path.components().all(|part| part.as_os_str().len() < 250);
    (is_plain && is_short && (1..=MAX_PARTS).contains(&count)).then_some(path)
}

/// Writes a file whose length was said before. Nothing is left of one that is cut.
pub fn write(place: &Path, length: u64, bytes: &mut dyn Read) -> Result<(), String> {
    let name = place.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let mut write = || -> io::Result<u64> {
        fs::create_dir_all(place.parent().unwrap_or(Path::new("")))?;
        let mut file = fs::File::create(place)?;
        let copied = io::copy(&mut bytes.take(length), &mut file)?;
        file.flush()?;
        Ok(copied)
    };
    let failed = match write() {
        Ok(copied) if copied == length => return Ok(()),
        Ok(copied) => format!("{name}: {copied} of {length} bytes came: drop it again"),
        Err(error) => format!("{name}: it cannot be kept: {error}"),
    };
    let _ = fs::remove_file(place);
    Err(failed)
}

/// Whether a file is no companion that systems put into folders.
fn is_meant(file: &Path) -> bool {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    !name.starts_with('.') && !["Thumbs.db", "desktop.ini"].contains(&&*name)
}

/// A change of a scene.
type Change = Box<dyn Fn(&SceneSpec) -> SceneSpec>;

/// What files change in a scene, and whether they are a whole one.
fn change(files: &[PathBuf]) -> Result<(Change, bool), String> {
    let mut kinds: BTreeMap<&'static str, Vec<&PathBuf>> = BTreeMap::new();
    let mut others = Vec::new();
    for file in files {
        match kind_of(file) {
            Some(kind) => kinds.entry(kind.flag()).or_default().push(file),
            None => others.push(file),
        }
    }
    let of = |kind: FileKind| kinds.get(kind.flag()).map_or(&[][..], Vec::as_slice);
    let one = |kind: FileKind| match of(kind) {
        [] => Ok(None),
        [file] => Ok(Some((*file).clone())),
        several => Err(format!("{} files are each read as {}: drop one of them", several.len(), kind.flag())),
    };
    if let Some(scene) = one(FileKind::Scene)? {
        let spec = read_scene(&scene).map_err(|error| match of_scene_file(error) {
            Failure::Usage(what) | Failure::Work(what) => what,
            Failure::ReaderGone => String::new(),
        })?;
        return Ok((Box::new(move |_| spec.clone()), true));
    }
    if let Some(object) = one(FileKind::Object)? {
        return Ok(changed(move |surface| {
            let own = SurfaceSpec { object: Some(object.clone()), ..SurfaceSpec::default() };
            *surface = surface.clone().overridden_by(own);
        }));
    }
    let volume = one(FileKind::Volume)?;
    let mesh = one(FileKind::Mesh)?;
    let images = match &mesh {
        // A glTF names its own pictures.
        Some(mesh) if is_gltf(mesh) && files.len() > 1 => &[],
        _ => of(FileKind::HeightMap),
    };
    let image = match images {
        [image] => Some((*image).clone()),
        _ => None,
    };
    let textures = (images.len() > 1).then(|| common_folder(images));
    if [&volume, &mesh, &image, &textures].iter().all(|found| found.is_none()) {
        let name = others.first().map(|file| file.file_name().unwrap_or_default().to_string_lossy());
        return Err(match name {
            Some(name) => {
                format!("{name}: it is no picture, mesh, volume or scene that can be read")
            }
            None => "there is no file in it".to_owned(),
        });
    }
    Ok(changed(move |surface| {
        let own = SurfaceSpec {
            volume: volume.clone(),
            mesh: mesh.clone().map(MeshChoice::File),
            textures: textures.clone(),
            ..SurfaceSpec::default()
        };
        *surface = surface.clone().overridden_by(own);
        if let Some(image) = &image {
            take_image(surface, image);
        }
    }))
}

/// A change of the only surface, or of what all have in common.
fn changed(change: impl Fn(&mut SurfaceSpec) + 'static) -> (Change, bool) {
    let of_scene = move |spec: &SceneSpec| {
        let mut spec = spec.clone();
        change(&mut spec.surface);
        spec
    };
    (Box::new(of_scene), false)
}

/// Puts a picture where its name says, else in place of the heights.
fn take_image(surface: &mut SurfaceSpec, image: &Path) {
    let role = image.parent().and_then(|folder| {
        let set = find_textures(folder, None).ok()?;
        let texture = set.textures.into_iter().find(|texture| texture.path == image)?;
        Some(texture.role)
    });
    let mut own = SurfaceSpec::default();
    let is_taken = match role.and_then(|role| own.map_of(role)) {
        Some(place) => {
            *place = Some(image.to_owned());
            true
        }
        None => false,
    };
    if !is_taken {
        own.height = Some(image.to_owned());
    }
    *surface = surface.clone().overridden_by(own);
}

fn is_gltf(mesh: &Path) -> bool {
    mesh.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("gltf"))
}

/// What a file is, if it can be shown.
fn kind_of(file: &Path) -> Option<FileKind> {
    let kind = FileKind::of(file).ok()?;
    let ending = file.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    match kind {
        // Any other file would be taken for a scene.
        FileKind::Scene if ending != "toml" => None,
        FileKind::Mesh if MeshFormat::by_name(file).is_none() => None,
        kind => Some(kind),
    }
}

/// The folder in which all of these lie.
fn common_folder(files: &[&PathBuf]) -> PathBuf {
    let mut folder = files[0].parent().unwrap_or(Path::new("")).to_owned();
    while !files.iter().all(|file| file.starts_with(&folder)) && folder.pop() {}
    folder
}
