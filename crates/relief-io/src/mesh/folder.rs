//! Resolution of files that a mesh refers to: they must be in its folder or below.

use std::path::{Component, Path, PathBuf};

use crate::ReadProblem;

/// Resolves `path` relative to `folder`. The file must exist in the folder or below. Errors show
/// `named`.
pub fn inside(folder: &Path, path: &Path, named: &str) -> Result<PathBuf, ReadProblem> {
    let outside = || ReadProblem::OutsideFolder { file: named.chars().take(200).collect() };
    if !stays(path) {
        return Err(outside());
    }
    let file = folder.join(path);
    // A link may lead out of the folder.
    let real = |path: &Path| {
        let of_part = |error| ReadProblem::Part { file: file.clone(), problem: Box::new(error) };
        path.canonicalize().map_err(|error| of_part(ReadProblem::Io(error)))
    };
    let here = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    if !real(&file)?.starts_with(real(here)?) {
        return Err(outside());
    }
    Ok(file)
}

/// Whether a path stays in the folder in which it begins, on every system.
///
/// Only its text is read: links are not followed. Paths with `..`, a colon, a backslash or a NUL
/// are refused, as are absolute and empty paths.
pub fn stays(path: &Path) -> bool {
    // A colon belongs to a scheme or a drive, and backslashes are separators on some systems.
    let is_plain = !path.to_string_lossy().contains([':', '\\', '\0']);
    let mut components = path.components().peekable();
    let stays = components.peek().is_some()
        && components.all(|part| matches!(part, Component::Normal(_) | Component::CurDir));
    is_plain && stays
}
