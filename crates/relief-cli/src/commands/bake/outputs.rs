//! Files of all bakes of a height map in a folder: which are up to date, which may be written, and
//! writing all at once.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use relief_io::file_set::{FileSet, FileSetError, ListedFile, Manifest, ManifestState, Part};
use relief_io::write_atomically;

use super::identity::is_baked;
use crate::failure::Failure;
use crate::interrupt::cancelled;
use crate::waiting::waiting;

/// Ending of the manifest's name.
const MANIFEST: &str = ".relief-manifest";

/// Manifest of the earlier bakes of a height map.
pub struct EarlierBakes<'a> {
    folder: &'a Path,
    /// Name of the manifest.
    name: String,
    manifest: Manifest,
    /// Whether another program's file has the manifest's name.
    is_strange: bool,
}

impl<'a> EarlierBakes<'a> {
    /// Reads the manifest of the height map named `stem` in a folder.
    pub fn find(folder: &'a Path, stem: &str) -> Result<Self, Failure> {
        let name = format!("{stem}{MANIFEST}");
        let path = folder.join(&name);
        let found = Manifest::find(&path);
        let found = found.map_err(|error| Failure::Work(format!("{}: {error}", path.display())))?;
        let is_strange = found == ManifestState::OtherFile;
        let manifest =
            if let ManifestState::Valid(manifest) = found { manifest } else { Manifest::default() };
        Ok(Self { folder, name, manifest, is_strange })
    }

    /// Returns no earlier bakes, for a single file, which no manifest lists.
    pub fn none(folder: &'a Path, stem: &str) -> Self {
        let name = format!("{stem}{MANIFEST}");
        Self { folder, name, manifest: Manifest::default(), is_strange: false }
    }

    /// Returns the manifest's name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Whether an earlier bake wrote files of a part that are still there.
    pub fn has_part(&self, part: &str) -> bool {
        let files = self.manifest.part(part).into_iter().flat_map(|part| &part.files);
        files.into_iter().any(|file| self.folder.join(&file.name).exists())
    }

    /// Returns the names of a part's files, if they were made from `made_from` and are all
    /// unchanged.
    pub fn whole(&self, part: &str, made_from: &str) -> Option<Vec<String>> {
        let part = self.manifest.whole(self.folder, part, made_from)?;
        Some(part.files.iter().map(|file| file.name.clone()).collect())
    }
}

/// Output files of a run on their way to a folder. Dropped before [`finish`](Self::finish), nothing
/// changes.
pub struct Outputs<'a> {
    set: FileSet,
    earlier: EarlierBakes<'a>,
    /// Whether a manifest lists the files.
    has_manifest: bool,
    /// Whether files of other programs are replaced.
    force: bool,
    parts: Vec<Part>,
}

impl<'a> Outputs<'a> {
    /// Creates the folder if it is missing, waits for other processes, and repairs what killed ones
    /// left.
    pub fn open(
        folder: &'a Path,
        stem: &str,
        has_manifest: bool,
        force: bool,
        quiet: bool,
        cancel: &AtomicBool,
    ) -> Result<Self, Failure> {
        let set = FileSet::open(folder, stem, &mut waiting(folder, quiet, cancel));
        let set = set.map_err(|error| match error {
            FileSetError::Busy { .. } if cancel.load(Ordering::Relaxed) => cancelled(),
            other => Failure::work(other),
        })?;
        let earlier = match has_manifest {
            true => EarlierBakes::find(folder, stem)?,
            false => EarlierBakes::none(folder, stem),
        };
        Ok(Self { set, earlier, has_manifest, force, parts: Vec::new() })
    }

    /// Returns the earlier bakes.
    pub fn earlier(&self) -> &EarlierBakes<'a> {
        &self.earlier
    }

    /// Returns the folder for files without a name.
    pub fn hidden_folder(&self) -> &Path {
        self.set.staging_folder()
    }

    /// Checks that a file of that name can be written, and is not another program's.
    pub fn check(&mut self, name: &str) -> Result<(), Failure> {
        let path = self.earlier.folder.join(name);
        self.set.check(&path).map_err(Failure::work)?;
        let is_ours = if name == self.earlier.name {
            !self.earlier.is_strange
        } else {
            self.earlier.manifest.lists(name) || !path.exists() || is_baked(&path)
        };
        if is_ours || self.force {
            return Ok(());
        }
        Err(Failure::Work(format!(
            "{}: exists already, and relief did not write it for this map: move it away, give another \
             --output, or replace it with --force",
            path.display()
        )))
    }

    /// Checks that a file that an earlier run wrote has not been changed since, unless all is replaced.
    pub fn check_unchanged(&self, name: &str) -> Result<(), Failure> {
        let mut files = self.earlier.manifest.parts().iter().flat_map(|part| &part.files);
        let listed = files.find(|file| file.name == name);
        let path = self.earlier.folder.join(name);
        match listed {
            Some(file) if !self.force && path.exists() && !file.is_in(self.earlier.folder) => {
                Err(Failure::Work(format!(
                    "{}: has been changed since relief wrote it: move it away, give another --output, or \
                     replace it with --force",
                    path.display()
                )))
            }
            _ => Ok(()),
        }
    }

    /// Returns where to write a file of that name.
    pub fn place(&mut self, name: &str) -> Result<PathBuf, Failure> {
        // It may have come since the first check.
        self.check(name)?;
        self.set.put(&self.earlier.folder.join(name)).map_err(Failure::work)
    }

    /// Adds a part whose files have been written, each to its place.
    pub fn add(&mut self, name: &str, made_from: &str, files: &[(String, PathBuf)]) -> io::Result<()> {
        let listed = files.iter().map(|(name, place)| ListedFile::of(place, name));
        let files = listed.collect::<io::Result<_>>()?;
        self.parts.push(Part { name: name.to_owned(), made_from: made_from.to_owned(), files });
        Ok(())
    }

    /// Gives all files their names. Removes files of earlier bakes of the same parts that are no
    /// longer written. Returns the names of removable files that stayed because somebody has
    /// changed them.
    pub fn finish(mut self, cancel: &AtomicBool) -> Result<Vec<String>, Failure> {
        let mut manifest = self.earlier.manifest.clone();
        let mut before = Vec::new();
        for part in self.parts {
            before.extend(manifest.part(&part.name).into_iter().flat_map(|part| part.files.clone()));
            manifest.set(part);
        }
        let mut changed = Vec::new();
        for file in before.into_iter().filter(|file| !manifest.lists(&file.name)) {
            match std::fs::symlink_metadata(self.earlier.folder.join(&file.name)) {
                Ok(about) if about.is_file() && file.is_in(self.earlier.folder) => {
                    self.set.remove(&file.name).map_err(Failure::work)?;
                }
                Ok(_) => changed.push(file.name),
                Err(_) => {}
            }
        }
        if self.has_manifest {
            let path = self.earlier.folder.join(&self.earlier.name);
            let aside = self.set.put(&path).map_err(Failure::work)?;
            let written = write_atomically(&aside, |out| out.write_all(manifest.to_text().as_bytes()));
            written.map_err(|error| Failure::Work(format!("{}: {}", path.display(), error.problem)))?;
        }
        if cancel.load(Ordering::Relaxed) {
            return Err(cancelled());
        }
        self.set.commit().map_err(Failure::work)?;
        Ok(changed)
    }
}
