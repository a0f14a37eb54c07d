//! Files that a user gives: their places, and their names.

use std::collections::BTreeMap;
use std::io;
use std::path::{Component, Path, PathBuf};

use relief_io::{Files, TextureSetError};
use relief_scene::{SceneError, SceneSpec};
use relief_session::Refused;

use crate::coming::Coming;

/// Most files that are given at once.
const MAX_FILES: usize = 1000;

/// Most parts of a path.
const MAX_PARTS: usize = 16;

/// Longest part of a path, in bytes.
const MAX_PART_BYTES: usize = 249;

/// A height map of 4 times 4 texels.
const STAND_IN: &[u8] = b"P5 4 4 255 0123456789abcdef";

/// Files that were given, each group in a folder of its own.
#[derive(Clone, Debug)]
pub struct Given {
    root: PathBuf,
    most_bytes: u64,
    groups: BTreeMap<u64, Group>,
}

#[derive(Clone, Debug, Default)]
struct Group {
    files: Vec<PathBuf>,
    bytes: u64,
}

/// Reason why given files are not taken into a scene.
#[derive(Debug, thiserror::Error)]
pub enum GivenError {
    /// A scene cannot be read, or cannot be loaded with the files.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The document refuses them.
    #[error(transparent)]
    Refused(#[from] Refused),
    /// A folder has several sets of textures.
    #[error(transparent)]
    Textures(#[from] TextureSetError),
    /// They are too many or too large, or it is not clear what they are.
    #[error("{0}")]
    Files(String),
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

    /// Returns the folder of a group.
    pub fn folder(&self, number: u64) -> PathBuf {
        self.root.join(number.to_string())
    }

    /// Adds a file to a group, and returns the path where the caller keeps it. `path` is the file's path in
    /// what was dropped.
    ///
    /// # Errors
    ///
    /// When the path leaves its folder, or the group has too many files or bytes.
    pub fn place(&mut self, number: u64, path: &str, length: u64) -> Result<PathBuf, String> {
        let inside = inside(path).ok_or_else(|| format!("'{path}' is no path of a dropped file"))?;
        let place = self.folder(number).join(inside);
        let group = self.groups.entry(number).or_default();
        if group.files.len() >= MAX_FILES {
            return Err(format!("more than {MAX_FILES} files come at once: drop fewer"));
        }
        if group.bytes.saturating_add(length) > self.most_bytes {
            let most = relief_core::ByteSize(self.most_bytes);
            return Err(format!("{path}: the files are larger than {most} together: drop fewer"));
        }
        group.bytes += length;
        if !group.files.contains(&place) {
            group.files.push(place.clone());
        }
        Ok(place)
    }

    /// Returns what the files of a group change in a scene; under a key, if one is named. The group is then
    /// forgotten.
    ///
    /// # Errors
    ///
    /// When the group has no file, or it is not clear what its files are.
    pub fn coming(&mut self, number: u64, key: Option<&str>, files: &Files) -> Result<Coming, GivenError> {
        let none = || GivenError::Files("no file has come".to_owned());
        let group = self.groups.remove(&number).ok_or_else(none)?;
        let given: Vec<PathBuf> = group.files.into_iter().filter(|file| is_meant(file)).collect();
        match (key, &given[..]) {
            (None, _) => Coming::of_files(self.folder(number), &given, files),
            (Some(key), [file]) => Ok(Coming::of_key(self.folder(number), key, file)),
            (Some(key), _) => Err(GivenError::Files(format!("{key}: it takes one file"))),
        }
    }

    /// Adds a small height map for scenes that have none yet, see [`Coming::tried`]. Returns its path.
    ///
    /// # Errors
    ///
    /// When it cannot be kept.
    pub fn stand_in(&self, files: &mut Files) -> io::Result<PathBuf> {
        let path = self.root.join("stand-in.pgm");
        match files {
            Files::Disk => std::fs::write(&path, STAND_IN)?,
            Files::Memory(files) => files.insert(&path, STAND_IN).map_err(io::Error::other)?,
        }
        Ok(path)
    }

    /// Returns the files of a group that has come.
    pub(crate) fn files_of(&self, number: u64) -> &[PathBuf] {
        self.groups.get(&number).map_or(&[], |group| &group.files)
    }

    /// Returns the path of a given file below what was dropped; none of other files.
    fn below<'a>(&self, file: &'a Path) -> Option<&'a Path> {
        let mut parts = file.strip_prefix(&self.root).ok()?.components();
        // The number of a group.
        parts.next();
        Some(parts.as_path())
    }

    /// Returns the value of a key as a file of the scene, if `value` is the name by which the user knows one.
    pub fn meant(&self, value: &str, spec: &SceneSpec) -> Option<String> {
        let name = match value.parse::<toml::Value>() {
            Ok(toml::Value::String(name)) => name,
            _ => value.to_owned(),
        };
        let file = spec.files().find(|file| self.below(file) == Some(Path::new(&name)))?;
        Some(toml::Value::String(file.display().to_string()).to_string())
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

    /// Returns the text of the scene's file. Given files have the names that the user knows: they belong
    /// beside the scene's file. Other files have the path that `other` returns.
    pub fn scene_text(&self, spec: &SceneSpec, other: impl Fn(&Path) -> PathBuf) -> String {
        let mut spec = spec.clone();
        let mut has_given = false;
        for file in spec.files_mut() {
            let below = self.below(file).map(Path::to_owned);
            has_given |= below.is_some();
            *file = below.unwrap_or_else(|| other(file));
        }
        let text = spec.to_toml();
        match has_given {
            true => format!("# Files that were dropped lie beside this one.\n\n{text}"),
            false => text,
        }
    }
}

/// Returns a path if it lies within a folder.
pub fn inside(path: &str) -> Option<PathBuf> {
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
