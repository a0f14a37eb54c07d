//! What files that come in change in a scene: they are recognised by their content and their names.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use relief_io::{Files, FoundTexture, GreenSign, LeftReason, TextureRole, find_textures};
use relief_scene::{MeshChoice, SceneSpec, SurfaceSpec};
use relief_session::{Session, Taken};

use crate::given::GivenError;
use crate::kind::Kind;
use crate::scene_files::scene_among;

/// A change of a scene by files.
#[derive(Clone, Debug)]
pub struct Coming {
    folder: PathBuf,
    by: By,
    /// Whether the scene is a sample, whose maps belong to its own heights.
    is_onto_sample: bool,
}

/// What they change.
#[derive(Clone, Debug)]
enum By {
    /// The value of a key, as a scene file writes it.
    Key { key: String, value: String },
    /// The only surface.
    Surface(Box<SurfaceSpec>),
    /// All, by a scene file of this name.
    Scene(Box<SceneSpec>, String),
}

impl Coming {
    /// A file for a key.
    pub(crate) fn of_key(folder: PathBuf, key: &str, file: &Path) -> Self {
        let value = toml::Value::String(file.display().to_string()).to_string();
        Self { folder, by: By::Key { key: key.to_owned(), value }, is_onto_sample: false }
    }

    /// Files that say by themselves what they are.
    pub(crate) fn of_files(folder: PathBuf, given: &[PathBuf], files: &Files) -> Result<Self, GivenError> {
        let by = recognised(&folder, given, files)?;
        Ok(Self { folder, by, is_onto_sample: false })
    }

    /// Says that the scene is a sample: where heights come, its other maps go.
    #[must_use]
    pub fn onto_sample(self) -> Self {
        Self { is_onto_sample: true, ..self }
    }

    /// Returns the folder in which the files lie.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Returns the document of a session with the files in it.
    ///
    /// # Errors
    ///
    /// When the document refuses them, or it is not clear which surface they are for.
    pub fn with(&self, session: &Session) -> Result<Taken, GivenError> {
        Ok(match &self.by {
            By::Key { key, value } => session.with_file(key, value)?,
            By::Scene(scene, name) => {
                let taken = session.with_files(&|_| (**scene).clone())?;
                Taken { name: Some(name.clone()), ..taken }
            }
            By::Surface(_) if !session.spec().surfaces.is_empty() => {
                let said = "the scene has several surfaces: drop the file onto a control of one";
                return Err(GivenError::Files(said.to_owned()));
            }
            By::Surface(own) => session.with_files(&|spec| {
                let mut surface = spec.surface.clone();
                if self.is_onto_sample && has_relief(own) {
                    surface.forget_maps();
                }
                SceneSpec { surface: surface.overridden_by((**own).clone()), ..spec.clone() }
            })?,
        })
    }
}

/// Whether a surface has a relief of its own.
fn has_relief(own: &SurfaceSpec) -> bool {
    [&own.height, &own.textures, &own.object, &own.volume].into_iter().any(Option::is_some)
}

/// What files change in a scene.
fn recognised(root: &Path, given: &[PathBuf], files: &Files) -> Result<By, GivenError> {
    let mut kinds: BTreeMap<Option<Kind>, Vec<&PathBuf>> = BTreeMap::new();
    for file in given {
        kinds.entry(Kind::of(file, files)).or_default().push(file);
    }
    let of = |kind: Kind| kinds.get(&Some(kind)).map_or(&[][..], Vec::as_slice);
    let one = |kind: Kind| match of(kind) {
        [] => Ok(None),
        [file] => Ok(Some((*file).clone())),
        several => Err(GivenError::Files(format!(
            "{} files are each a {}: drop one of them",
            several.len(),
            kind.name()
        ))),
    };
    if let Some(scene) = one(Kind::Scene)? {
        let spec = scene_among(&scene, root, given, files)?;
        return Ok(By::Scene(Box::new(spec), name_of(&scene)));
    }
    if let object @ Some(_) = one(Kind::Object)? {
        return Ok(By::Surface(Box::new(SurfaceSpec { object, ..SurfaceSpec::default() })));
    }
    let (volume, mesh) = (one(Kind::Volume)?, one(Kind::Mesh)?);
    let images = match &mesh {
        // A glTF names its own pictures.
        Some(mesh) if is_gltf(mesh) && given.len() > 1 => &[],
        _ => of(Kind::Picture),
    };
    if volume.is_none() && mesh.is_none() && images.is_empty() {
        return Err(GivenError::Files(match kinds.get(&None).and_then(|others| others.first()) {
            Some(file) => {
                format!("{}: it is no picture, mesh, volume or scene that can be read", name_of(file))
            }
            None => "there is no file in it".to_owned(),
        }));
    }
    let maps = Maps::of(root, images, files)?;
    let mesh = mesh.map(MeshChoice::File);
    Ok(By::Surface(Box::new(SurfaceSpec { volume, mesh, ..maps.surface() })))
}

/// Pictures, and what each of them is.
enum Maps {
    /// A folder of textures of its own.
    Folder(PathBuf),
    /// Files, each with its role.
    Files(Vec<(TextureRole, PathBuf, Option<GreenSign>)>),
}

impl Maps {
    fn of(root: &Path, images: &[&PathBuf], files: &Files) -> Result<Self, GivenError> {
        let Some(folder) = images.first().and_then(|image| image.parent()) else {
            return Ok(Self::Files(Vec::new()));
        };
        if images.iter().any(|image| image.parent() != Some(folder)) {
            let said = "pictures of several folders came at once: drop one folder of textures";
            return Err(GivenError::Files(said.to_owned()));
        }
        let set = match find_textures(files.source(folder), None) {
            Ok(set) => set,
            // A single picture may have any name.
            Err(_) if images.len() == 1 => return Ok(Self::heights(images[0])),
            Err(error) => return Err(error.into()),
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
                return Err(GivenError::Files(format!(
                    "{}: the name does not say what it is: end it with _height, _color, _normal or \
                     _roughness, or drop the file onto a control",
                    names.join(", ")
                )));
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
