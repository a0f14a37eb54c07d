//! Files that a user gives: their places, their kinds, and what they change in a scene.

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

use relief_io::{Files, Format, MeshFormat, find_textures};
use relief_scene::{MeshChoice, SceneSpec, SurfaceSpec, read_scene};
use relief_session::{Changed, Session};

/// Most files that are given at once.
const MAX_FILES: usize = 1000;

/// Most parts of a path.
const MAX_PARTS: usize = 16;

/// Longest part of a path, in bytes.
const MAX_PART_BYTES: usize = 249;

/// Bytes at the start of a file that decide its kind: an object's first tables.
const START_BYTES: u64 = 1 << 16;

/// Name of a depth object's description.
const OBJECT: &str = "object.toml";

/// Files that were given, each group in a folder of its own.
#[derive(Debug)]
pub struct Given {
    root: PathBuf,
    most_bytes: u64,
    groups: BTreeMap<u64, Group>,
}

#[derive(Debug, Default)]
struct Group {
    files: Vec<PathBuf>,
    bytes: u64,
}

impl Given {
    /// Creates an empty set, whose files lie in the folder `root`, at most `most_bytes` in a group.
    pub fn new(root: impl Into<PathBuf>, most_bytes: u64) -> Self {
        Self { root: root.into(), most_bytes, groups: BTreeMap::new() }
    }

    /// Returns the folder of all files.
    pub fn root(&self) -> &Path {
        &self.root
    }

    /// Adds a file to a group, and returns the path where the caller keeps it. `path` is the file's path in
    /// what was dropped.
    ///
    /// # Errors
    ///
    /// When the path leaves its folder, or the group has too many files or bytes.
    pub fn place(&mut self, number: u64, path: &str, length: u64) -> Result<PathBuf, String> {
        let inside = inside(path).ok_or_else(|| format!("'{path}' is no path of a dropped file"))?;
        let group = self.groups.entry(number).or_default();
        if group.files.len() >= MAX_FILES {
            return Err(format!("more than {MAX_FILES} files come at once: drop fewer"));
        }
        if group.bytes.saturating_add(length) > self.most_bytes {
            let most = relief_core::ByteSize(self.most_bytes);
            return Err(format!("{path}: the files are larger than {most} together: drop fewer"));
        }
        group.bytes += length;
        let place = self.root.join(number.to_string()).join(inside);
        if !group.files.contains(&place) {
            group.files.push(place.clone());
        }
        Ok(place)
    }

    /// Puts the files of a group into the scene; under a key, if one is named.
    ///
    /// # Errors
    ///
    /// When the group has no file, its files are unclear or cannot be shown, or the scene refuses them.
    pub fn take(
        &mut self,
        number: u64,
        key: Option<&str>,
        files: &Files,
        session: &mut Session,
    ) -> Result<Changed, String> {
        let group = self.groups.remove(&number).ok_or("no file has come")?;
        let given: Vec<PathBuf> = group.files.into_iter().filter(|file| is_meant(file)).collect();
        if let Some(key) = key {
            let [file] = &given[..] else { return Err(format!("{key}: it takes one file")) };
            let path = toml::Value::String(file.display().to_string()).to_string();
            let taken = session.with_file(key, &path).map_err(|refused| refused.to_string())?;
            return Ok(session.take(taken));
        }
        let change = change(&given, files)?;
        if !matches!(change, Change::Scene(_)) && !session.spec().surfaces.is_empty() {
            return Err("the scene has several surfaces: drop the file onto a control of one".to_owned());
        }
        let taken = session.with_files(&|spec| change.of(spec)).map_err(|refused| refused.to_string())?;
        Ok(session.take(taken))
    }

    /// Returns a text in which the files have the names that the user knows.
    pub fn named(&self, text: &str) -> String {
        let start = format!("{}/", self.root.display());
        let mut parts = text.split(&start);
        let mut named = parts.next().unwrap_or_default().to_owned();
        for part in parts {
            // The number of a group.
            named += part.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start_matches('/');
        }
        named
    }
}

/// Returns a path if it lies within a folder.
fn inside(path: &str) -> Option<PathBuf> {
    let path = PathBuf::from(path);
    let mut parts = path.components();
    let is_plain = parts.all(|part| matches!(part, Component::Normal(name) if name.len() <= MAX_PART_BYTES));
    (is_plain && (1..=MAX_PARTS).contains(&path.components().count())).then_some(path)
}

/// Returns whether a file is no companion that systems put into folders.
fn is_meant(file: &Path) -> bool {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    !name.starts_with('.') && !["Thumbs.db", "desktop.ini"].contains(&&*name)
}

/// Kind of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Scene,
    Object,
    Volume,
    Mesh,
    Picture,
}

impl Kind {
    /// Returns the kind of a file that can be shown, by its name or its content.
    fn of(file: &Path, files: &Files) -> Option<Self> {
        if MeshFormat::by_name(file).is_some() {
            return Some(Self::Mesh);
        }
        let ending = file.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
        let start = files.source(file).start(START_BYTES).unwrap_or_default();
        match &*ending {
            "ktx2" => Some(Self::Volume),
            _ if Format::by_signature(&start).is_some() || Format::by_name(file).is_some() => {
                Some(Self::Picture)
            }
            "toml" => {
                let has_views = String::from_utf8_lossy(&start).lines().any(|line| line.trim() == "[[view]]");
                let is_object = has_views || file.file_name().is_some_and(|name| name == OBJECT);
                Some(if is_object { Self::Object } else { Self::Scene })
            }
            _ => None,
        }
    }

    const fn name(self) -> &'static str {
        match self {
            Self::Scene => "scene",
            Self::Object => "object",
            Self::Volume => "volume",
            Self::Mesh => "mesh",
            Self::Picture => "picture",
        }
    }
}

/// What files change in a scene.
enum Change {
    Scene(Box<SceneSpec>),
    /// Keys of the only surface, or of what all have in common.
    Surface(Box<SurfaceSpec>),
}

impl Change {
    fn of_surface(own: SurfaceSpec) -> Self {
        Self::Surface(Box::new(own))
    }

    fn of(&self, spec: &SceneSpec) -> SceneSpec {
        match self {
            Self::Scene(spec) => SceneSpec::clone(spec),
            Self::Surface(own) => {
                let surface = spec.surface.clone().overridden_by(SurfaceSpec::clone(own));
                SceneSpec { surface, ..spec.clone() }
            }
        }
    }
}

/// Returns what files change in a scene.
fn change(given: &[PathBuf], files: &Files) -> Result<Change, String> {
    let mut kinds: BTreeMap<Option<Kind>, Vec<&PathBuf>> = BTreeMap::new();
    for file in given {
        kinds.entry(Kind::of(file, files)).or_default().push(file);
    }
    let of = |kind: Kind| kinds.get(&Some(kind)).map_or(&[][..], Vec::as_slice);
    let one = |kind: Kind| match of(kind) {
        [] => Ok(None),
        [file] => Ok(Some(PathBuf::clone(file))),
        several => Err(format!("{} files are each a {}: drop one of them", several.len(), kind.name())),
    };
    if let Some(scene) = one(Kind::Scene)? {
        let spec = read_scene(files.source(&scene)).map_err(|error| error.to_string())?;
        return Ok(Change::Scene(Box::new(spec)));
    }
    if let object @ Some(_) = one(Kind::Object)? {
        return Ok(Change::of_surface(SurfaceSpec { object, ..SurfaceSpec::default() }));
    }
    let (volume, mesh) = (one(Kind::Volume)?, one(Kind::Mesh)?);
    let pictures = match &mesh {
        // A glTF names its own pictures.
        Some(mesh) if is_gltf(mesh) && given.len() > 1 => &[],
        _ => of(Kind::Picture),
    };
    if volume.is_none() && mesh.is_none() && pictures.is_empty() {
        return Err(match kinds.get(&None).and_then(|others| others.first()?.file_name()) {
            Some(name) => {
                format!(
                    "{}: it is no picture, mesh, volume or scene that can be read",
                    name.to_string_lossy()
                )
            }
            None => "there is no file in it".to_owned(),
        });
    }
    let mut own = SurfaceSpec { volume, mesh: mesh.map(MeshChoice::File), ..SurfaceSpec::default() };
    match pictures {
        [] => {}
        [picture] => take_picture(&mut own, picture, files),
        several => own.textures = Some(common_folder(several)),
    }
    Ok(Change::of_surface(own))
}

/// Puts a picture where its name says, otherwise in place of the heights.
fn take_picture(own: &mut SurfaceSpec, picture: &Path, files: &Files) {
    let role = picture.parent().and_then(|folder| {
        let set = find_textures(files.source(folder), None).ok()?;
        Some(set.textures.into_iter().find(|texture| texture.path == picture)?.role)
    });
    match role.and_then(|role| own.map_of(role)) {
        Some(place) => *place = Some(picture.to_owned()),
        None => own.height = Some(picture.to_owned()),
    }
}

fn is_gltf(mesh: &Path) -> bool {
    mesh.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("gltf"))
}

/// Returns the folder in which all of these lie.
fn common_folder(files: &[&PathBuf]) -> PathBuf {
    let mut folder = files[0].parent().unwrap_or(Path::new("")).to_owned();
    while !files.iter().all(|file| file.starts_with(&folder)) && folder.pop() {}
    folder
}
