//! The files that `relief height` writes: all of them whole, or none.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use relief_core::registry::UnknownName;
use relief_io::{Metadata, PngTexture, write_exr_rows, write_png_rows};
use tempfile::TempDir;

use super::cancelled;
use crate::failure::Failure;

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
        match inputs.iter().find(|input| is_same(path, input)) {
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

/// Whether two names are of one file, which need not be there yet.
pub fn is_same(a: &Path, b: &Path) -> bool {
    let place = |path: &Path| match path.canonicalize() {
        Ok(place) => Some(place),
        Err(_) => Some(folder_of(path).canonicalize().ok()?.join(path.file_name()?)),
    };
    place(a).is_some_and(|a| Some(a) == place(b))
}

/// Files that are whole, in hidden folders beside the places that they are meant for. Dropped, they are gone.
#[derive(Default)]
pub struct Staged(Vec<(TempDir, PathBuf)>);

impl Staged {
    /// Writes a file aside.
    pub fn add(&mut self, output: &Output, content: &Content, cancel: &AtomicBool) -> Result<(), Failure> {
        let Output { path, format } = output;
        let failed = |what: &dyn std::fmt::Display| Failure::Work(format!("{}: {what}", path.display()));
        let file = path.file_name().ok_or_else(|| failed(&"is no file name"))?;
        let folder = tempfile::Builder::new().prefix(".relief-height-").tempdir_in(folder_of(path));
        let folder = folder.map_err(|error| failed(&format!("cannot write into its folder ({error})")))?;
        let aside = folder.path().join(file);
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
        written.map_err(|error| failed(&error.problem))?;
        self.0.push((folder, path.clone()));
        Ok(())
    }

    /// Gives all files their names.
    pub fn finish(self) -> Result<(), Failure> {
        for (folder, path) in &self.0 {
            let aside = folder.path().join(path.file_name().unwrap_or_default());
            std::fs::rename(aside, path)
                .map_err(|error| Failure::Work(format!("{}: cannot be replaced: {error}", path.display())))?;
        }
        Ok(())
    }
}
