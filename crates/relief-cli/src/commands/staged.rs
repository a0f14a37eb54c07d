//! Output files of a command: all of them are written whole, or none.

use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

use relief_core::registry::UnknownName;
use relief_io::file_set::{FileSet, FileSetError};

use super::inputs::replaced;
use crate::failure::Failure;
use crate::interrupt::cancelled;
use crate::waiting::waiting;

/// Returns the format of the file that a flag names, by its ending. The file must be writable and
/// must not replace an input, or a file that belongs to one.
pub fn format_of<F: Copy>(
    flag: &str,
    path: &Path,
    formats: &[(&str, F)],
    inputs: &[&Path],
) -> Result<F, Failure> {
    let name = path.display();
    let endings: Vec<String> = formats.iter().map(|(ending, _)| format!(".{ending}")).collect();
    let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
    let Some(extension) = extension else {
        let endings = match endings.split_last() {
            Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
            _ => endings.concat(),
        };
        return Err(Failure::Usage(format!("{flag} {name}: give it a name that ends in {endings}")));
    };
    let known = formats.iter().find(|(known, _)| *known == extension);
    let Some(&(_, format)) = known else {
        let unknown = UnknownName::new("file format", &extension, formats.iter().map(|(known, _)| *known));
        return Err(Failure::Usage(format!("{flag} {name}: {unknown}")));
    };
    if !folder_of(path).is_dir() {
        let folder = folder_of(path).display();
        return Err(Failure::Work(format!(
            "{name}: cannot be written: there is no folder {folder}: make it first"
        )));
    }
    if path.is_dir() {
        return Err(Failure::Work(format!(
            "{name}: cannot be written: it is a folder: give the name of a file"
        )));
    }
    match replaced(path, inputs) {
        Some(input) => {
            let input = input.display();
            Err(Failure::Usage(format!("{flag} {name}: would replace the input {input}: give another name")))
        }
        None => Ok(format),
    }
}

fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Files that are whole, in a hidden folder beside their places. Dropping it removes them.
pub struct Staged(FileSet);

impl Staged {
    /// Checks that all of the outputs, at least one, can be written. Waits for another process that
    /// writes the first, and repairs what a killed process left.
    pub fn open(outputs: &[&Path], quiet: bool, cancel: &AtomicBool) -> Result<Self, Failure> {
        let first = outputs.first().copied().unwrap_or(Path::new(""));
        let (folder, name) = (folder_of(first), first.file_name().unwrap_or_default());
        let set = FileSet::open(folder, name, &mut waiting(folder, quiet, cancel));
        let mut set = set.map_err(|error| match error {
            FileSetError::Busy { .. } if cancel.load(Ordering::Relaxed) => cancelled(),
            other => Failure::Work(format!("{}: cannot be written: {other}", first.display())),
        })?;
        outputs.iter().try_for_each(|output| set.check(output)).map_err(Failure::work)?;
        Ok(Self(set))
    }

    /// Returns where to write an output until it takes its name.
    pub fn aside(&mut self, output: &Path) -> Result<PathBuf, Failure> {
        self.0.put(output).map_err(Failure::work)
    }

    /// Writes an output aside; it takes its name at the end.
    pub fn write(&mut self, output: &Path, bytes: impl AsRef<[u8]>) -> Result<(), Failure> {
        let written = std::fs::write(self.aside(output)?, bytes);
        written.map_err(|error| Failure::Work(format!("{}: cannot be written: {error}", output.display())))
    }

    /// Gives all files their names.
    pub fn finish(self) -> Result<(), Failure> {
        self.0.commit().map_err(Failure::work)
    }
}
