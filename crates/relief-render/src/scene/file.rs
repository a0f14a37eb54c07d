//! Scene files: TOML.

use super::{SceneError, SceneSpec};
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use toml::de::DeTable;

/// The longest scene file that is read, in bytes. Scenes are short; what is longer is some other file.
const MAX_FILE_BYTES: u64 = 1 << 20;

/// Reads a scene file and checks all that needs no other file. Relative paths in it start at the folder that it lies in.
///
/// # Errors
///
/// When the file cannot be read, is longer than 1 MiB, is no TOML, has an unknown key, or has a value that cannot be
/// used; errors in the file say their line.
pub fn read_scene(path: &Path) -> Result<SceneSpec, SceneError> {
    let text = read_text(path).map_err(|source| SceneError::Io { path: path.to_owned(), source })?;
    let mut spec: SceneSpec = toml::from_str(&text)
        .map_err(|source| SceneError::Toml { path: path.to_owned(), source: Box::new(source) })?;
    spec.check().map_err(|source| {
        let line = line_of(&text, source.key);
        SceneError::InFile { path: path.to_owned(), line, source }
    })?;
    let folder = path.parent().unwrap_or(Path::new(""));
    for file in [&mut spec.height, &mut spec.color, &mut spec.normal] {
        *file = file.take().map(|file: PathBuf| folder.join(file));
    }
    Ok(spec)
}

fn read_text(path: &Path) -> io::Result<String> {
    let mut bytes = Vec::new();
    File::open(path)?.take(MAX_FILE_BYTES + 1).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > MAX_FILE_BYTES {
        let what = "it is too long for a scene; a height map is given with --height";
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, what));
    }
    String::from_utf8(bytes).map_err(|_| {
        let what = "it holds no text, which scenes are; a height map is given with --height";
        io::Error::new(io::ErrorKind::InvalidData, what)
    })
}

/// The line, counted from 1, where a top-level key has its value.
fn line_of(text: &str, key: &str) -> usize {
    let start = DeTable::parse(text).ok().and_then(|table| {
        let mut entries = table.get_ref().iter();
        entries.find(|(name, _)| name.get_ref().as_ref() == key).map(|(name, _)| name.span().start)
    });
    // Only keys of the file can be wrong, since every default is possible: then the key is found.
    text[..start.unwrap_or(0)].matches('\n').count() + 1
}
