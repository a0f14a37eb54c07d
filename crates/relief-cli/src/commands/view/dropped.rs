//! Files that come in from the page: kept in a folder of the session, and named as the user knows them.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Read, Write};
use std::path::{Component, Path, PathBuf};

use relief_scene::SceneSpec;
use tempfile::TempDir;

use super::coming::Coming;
use crate::failure::Failure;

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

    /// What the files of a group change in a scene; onto a key, if one is named.
    pub fn coming(&mut self, number: u64, key: Option<&str>) -> Result<Coming, String> {
        let group = self.groups.remove(&number).ok_or("no file has come")?;
        let files: Vec<PathBuf> = group.files.into_iter().filter(|file| is_meant(file)).collect();
        let root = self.root(number);
        match key {
            None => Coming::of_files(root, &files),
            Some(key) => {
                let [file] = &files[..] else { return Err(format!("{key}: it takes one file")) };
                Ok(Coming::of_key(root, key, file))
            }
        }
    }

    /// Removes the files of a group, which were not taken.
    pub fn forget(&self, number: u64) {
        // What stays is removed at the end.
        let _ = fs::remove_dir_all(self.root(number));
    }

    /// A file that may stand in for heights that no file gives yet.
    pub fn stand_in(&self) -> io::Result<PathBuf> {
        let path = self.folder.path().join("stand-in.pgm");
        fs::write(&path, b"P5 4 4 255 0123456789abcdef")?;
        Ok(path)
    }

    /// The path of a file of the page below what was dropped; none of others.
    fn below<'a>(&self, file: &'a Path) -> Option<&'a Path> {
        let mut parts = file.strip_prefix(self.folder.path()).ok()?.components();
        // The number of a group.
        parts.next();
        Some(parts.as_path())
    }

    /// The value of a key as a file of the scene, if the page names one as the user knows it.
    pub fn meant(&self, value: &str, spec: &SceneSpec) -> Option<String> {
        let name = match value.parse::<toml::Value>() {
            Ok(toml::Value::String(name)) => name,
            _ => value.to_owned(),
        };
        let file = spec.files().find(|file| self.below(file) == Some(Path::new(&name)))?;
        Some(toml::Value::String(file.display().to_string()).to_string())
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
