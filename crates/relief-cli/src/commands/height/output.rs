//! The files that `relief height` writes: all of them whole, or none.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use relief_core::registry::UnknownName;
use relief_io::file_set::{FileSet, FileSetError, is_same_file};
use relief_io::{Metadata, PngTexture, write_exr_rows, write_png_rows};

use super::cancelled;
use crate::failure::Failure;
use crate::waiting::waiting;

/// A file format, by the ending of the output's name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    Png,
    Exr,
}

const FORMATS: [(&str, Format); 2] = [("png", Format::Png), ("exr", Format::Exr)];

/// A file to be written.
#[derive(Clone, Debug)]
pub struct Output {
    pub path: PathBuf,
    pub format: Format,
}

/// What a file is to hold: planes of texels, in PNG files from 0 to 1.
pub struct Content {
    pub size: [u32; 2],
    /// The channels' names in EXR files.
    pub names: &'static [&'static str],
    pub planes: Vec<Vec<f32>>,
    /// Bits of a sample in PNG files.
    pub bits: u32,
    pub metadata: Metadata,
}

impl Output {
    /// The file that a flag names, if it can be written and is none of those that are read.
    pub fn new(flag: &str, path: &Path, inputs: &[&Path]) -> Result<Self, Failure> {
        let name = path.display();
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
        let Some(extension) = extension else {
            return Err(Failure::Usage(format!("{flag} {name}: give it a name that ends in .png or .exr")));
        };
        let known = FORMATS.iter().find(|(known, _)| *known == extension);
        let Some(&(_, format)) = known else {
            let unknown = UnknownName::new("file format", &extension, FORMATS.map(|(known, _)| known));
            return Err(Failure::Usage(format!("{flag} {name}: {unknown}")));
        };
        if !folder_of(path).is_dir() {
            let folder = folder_of(path).display();
            return Err(Failure::Work(format!("{name}: cannot be written: there is no folder {folder}")));
        }
        if path.is_dir() {
            return Err(Failure::Work(format!("{name}: cannot be written: it is a folder")));
        }
        let output = Self { path: path.to_owned(), format };
        match inputs.iter().find(|input| is_same_file(path, input)) {
            Some(input) => {
                let input = input.display();
                Err(Failure::Usage(format!("{flag} {name}: would replace {input}, which is read")))
            }
            None => Ok(output),
        }
    }

    /// How texels are stored, as metadata say it.
    pub const fn stored_as(&self) -> &'static str {
        match self.format {
            Format::Png => "unorm16",
            Format::Exr => "float32",
        }
    }
}

fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Files that are whole, in a hidden folder beside their places. Dropped, they are gone.
pub struct Staged(FileSet);

impl Staged {
    /// Finds out whether all of the outputs can be written, of which there is at least one. Waits for another
    /// process that writes the first, and mends what a killed one left.
    pub fn open(outputs: &[&Output], quiet: bool, cancel: &AtomicBool) -> Result<Self, Failure> {
        let first = outputs.first().map_or(Path::new(""), |output| output.path.as_path());
        let (folder, name) = (folder_of(first), first.file_name().unwrap_or_default());
        let set = FileSet::open(folder, name, &mut waiting(folder, quiet, cancel));
        let mut set = set.map_err(|error| match error {
            FileSetError::Busy { .. } if cancel.load(Ordering::Relaxed) => cancelled(),
            other => Failure::work(other),
        })?;
        outputs.iter().try_for_each(|output| set.check(&output.path)).map_err(Failure::work)?;
        Ok(Self(set))
    }

    /// Writes a file aside.
    pub fn add(&mut self, output: &Output, content: &Content, cancel: &AtomicBool) -> Result<(), Failure> {
        let Output { path, format } = output;
        let aside = self.0.put(path).map_err(Failure::work)?;
        let [width, height] = content.size;
        let mut rows = |row: relief_io::Row, texels: &mut [f32]| -> io::Result<()> {
            if cancel.load(Ordering::Relaxed) {
                return Err(io::Error::other("cancelled"));
            }
            let start = row.row as usize * width as usize;
            texels.copy_from_slice(&content.planes[row.channel][start..start + width as usize]);
            Ok(())
        };
        let written = match format {
            Format::Png => {
                let texture =
                    PngTexture { width, height, channels: content.planes.len(), bits: content.bits };
                write_png_rows(&aside, &texture, &content.metadata, &mut rows)
            }
            Format::Exr => write_exr_rows(&aside, width, height, content.names, &content.metadata, &mut rows),
        };
        if cancel.load(Ordering::Relaxed) {
            return Err(cancelled());
        }
        written.map_err(|error| Failure::Work(format!("{}: {}", path.display(), error.problem)))
    }

    /// Gives all files their names.
    pub fn finish(self) -> Result<(), Failure> {
        self.0.commit().map_err(Failure::work)
    }
}
