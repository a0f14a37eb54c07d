//! What files that come in change in a scene: they are recognised by their content and their names.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use relief_io::{FoundTexture, GreenSign, LeftReason, MeshFormat, TextureRole, find_textures};
use relief_scene::{MeshChoice, SceneSpec, SurfaceSpec};
use relief_session::{Session, Taken};

use super::scene_files::scene_among;
use crate::file_kind::FileKind;

/// A change of a scene by files.
pub struct Coming {
    /// The folder in which they lie.
    pub folder: PathBuf,
    by: By,
}

/// What they change.
enum By {
    /// The value of a key, as a scene file writes it.
    Key { key: String, value: String },
    /// The only surface.
    Surface(Box<dyn Fn(&mut SurfaceSpec)>),
    /// All.
    Scene(Box<SceneSpec>),
}

impl Coming {
    /// A file for a key.
    pub fn of_key(folder: PathBuf, key: &str, file: &Path) -> Self {
        let value = toml::Value::String(file.display().to_string()).to_string();
        Self { folder, by: By::Key { key: key.to_owned(), value } }
    }

    /// Files that say by themselves what they are.
    pub fn of_files(folder: PathBuf, files: &[PathBuf]) -> Result<Self, String> {
        let by = recognised(&folder, files)?;
        Ok(Self { folder, by })
    }

    /// The document of a session with the files in it.
    pub fn with(&self, session: &Session) -> Result<Taken, String> {
        let taken = match &self.by {
            By::Key { key, value } => session.with_file(key, value),
            By::Scene(scene) => session.with_files(&|_| (**scene).clone()),
            By::Surface(_) if !session.spec().surfaces.is_empty() => {
                return Err("the scene has several surfaces: drop the file onto a control of one".to_owned());
            }
            By::Surface(change) => session.with_files(&|spec| {
                let mut spec = spec.clone();
                change(&mut spec.surface);
                spec
            }),
        };
        taken.map_err(|refused| refused.to_string())
    }
}

/// What files change in a scene.
fn recognised(root: &Path, files: &[PathBuf]) -> Result<By, String> {
    let mut kinds: BTreeMap<&'static str, Vec<&PathBuf>> = BTreeMap::new();
    let mut others = Vec::new();
    for file in files {
        match kind_of(file) {
            Some(kind) => kinds.entry(kind.flag()).or_default().push(file),
            None => others.push(file),
        }
    }
    let of = |kind: FileKind| kinds.get(kind.flag()).map_or(&[][..], Vec::as_slice);
    let one = |kind: FileKind, name: &str| match of(kind) {
        [] => Ok(None),
        [file] => Ok(Some((*file).clone())),
        several => Err(format!("{} files are each a {name}: drop one of them", several.len())),
    };
    if let Some(scene) = one(FileKind::Scene, "scene")? {
        return scene_among(&scene, root, files).map(Box::new).map(By::Scene);
    }
    if let Some(object) = one(FileKind::Object, "depth object")? {
        return Ok(By::Surface(Box::new(move |surface| {
            let own = SurfaceSpec { object: Some(object.clone()), ..SurfaceSpec::default() };
            *surface = surface.clone().overridden_by(own);
        })));
    }
    let volume = one(FileKind::Volume, "volume")?;
    let mesh = one(FileKind::Mesh, "mesh")?;
    let images = match &mesh {
        // A glTF names its own pictures.
        Some(mesh) if is_gltf(mesh) && files.len() > 1 => &[],
        _ => of(FileKind::HeightMap),
    };
    if volume.is_none() && mesh.is_none() && images.is_empty() {
        return Err(match others.first() {
            Some(file) => {
                format!("{}: it is no picture, mesh, volume or scene that can be read", name_of(file))
            }
            None => "there is no file in it".to_owned(),
        });
    }
    let maps = Maps::of(root, images)?;
    Ok(By::Surface(Box::new(move |surface| {
        let own = SurfaceSpec {
            volume: volume.clone(),
            mesh: mesh.clone().map(MeshChoice::File),
            ..maps.surface()
        };
        *surface = surface.clone().overridden_by(own);
    })))
}

/// Pictures, and what each of them is.
enum Maps {
    /// A folder of textures of its own.
    Folder(PathBuf),
    /// Files, each with its role.
    Files(Vec<(TextureRole, PathBuf, Option<GreenSign>)>),
}

impl Maps {
    fn of(root: &Path, images: &[&PathBuf]) -> Result<Self, String> {
        let Some(folder) = images.first().and_then(|image| image.parent()) else {
            return Ok(Self::Files(Vec::new()));
        };
        if images.iter().any(|image| image.parent() != Some(folder)) {
            return Err("pictures of several folders came at once: drop one folder of textures".to_owned());
        }
        let set = match find_textures(folder, None) {
            Ok(set) => set,
            // A single picture may have any name.
            Err(_) if images.len() == 1 => return Ok(Self::heights(images[0])),
            Err(error) => return Err(error.to_string()),
        };
        if images.len() > 1 && folder != root && set.height().is_ok() {
            return Ok(Self::Folder(folder.to_owned()));
        }
        let known = |texture: &FoundTexture| (texture.role, texture.path.clone(), texture.green);
        let mut files: Vec<_> = set.textures.iter().map(known).collect();
        let is_named = |image: &&&PathBuf| {
            let is_left =
                set.left.iter().any(|(left, why)| left == **image && *why != LeftReason::NotRecognised);
            is_left || set.textures.iter().any(|texture| texture.path == ***image)
        };
        let unnamed: Vec<&PathBuf> = images.iter().filter(|image| !is_named(image)).copied().collect();
        match unnamed[..] {
            [] => {}
            [image] if set.height().is_err() => files.push((TextureRole::Height, image.clone(), None)),
            ref several => {
                let names: Vec<String> = several.iter().map(|image| name_of(image)).collect();
                return Err(format!(
                    "{}: the name does not say what it is: end it with _height, _color, _normal or _roughness, or \
                     drop the file onto a control",
                    names.join(", ")
                ));
            }
        }
        let has_place = files.iter().any(|(role, ..)| SurfaceSpec::default().map_of(*role).is_some());
        if has_place { Ok(Self::Files(files)) } else { Ok(Self::heights(images[0])) }
    }

    fn heights(image: &Path) -> Self {
        Self::Files(vec![(TextureRole::Height, image.to_owned(), None)])
    }

    /// The keys of a surface that has them.
    fn surface(&self) -> SurfaceSpec {
        let mut own = SurfaceSpec::default();
        match self {
            Self::Folder(folder) => own.textures = Some(folder.clone()),
            Self::Files(files) => {
                for (role, path, green) in files {
                    let Some(place) = own.map_of(*role) else { continue };
                    *place = Some(path.clone());
                    own.green = own.green.or(*green);
                    if *role == TextureRole::Depth {
                        own.depth = Some(true);
                    }
                }
            }
        }
        own
    }
}

/// A file's own name.
pub fn name_of(file: &Path) -> String {
    file.file_name().unwrap_or_default().to_string_lossy().into_owned()
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
