//! Resolution of files that a mesh refers to: they must be in its folder or below.

use std::path::{Component, Path, PathBuf};

use crate::{ReadProblem, Source};

/// Resolves `path` relative to the folder of `source`. The file must exist in the folder or below.
/// Errors show `named`.
pub fn inside(source: Source<'_>, path: &Path, named: &str) -> Result<PathBuf, ReadProblem> {
    let Some(folder) = source.folder() else {
        let what = "another file, which bytes in memory cannot refer to".to_owned();
        return Err(ReadProblem::Unsupported { what, advice: "give its path, or a GLB" });
    };
    let outside = || ReadProblem::OutsideFolder { file: named.chars().take(200).collect() };
    if !stays(path) {
        return Err(outside());
    }
    let file = folder.join(path);
    let of_part = |error| ReadProblem::Part { file: file.clone(), problem: Box::new(ReadProblem::Io(error)) };
    if !source.has_links() {
        source.with_name(&file).is_file().map_err(of_part)?;
        return Ok(file);
    }
    // A link may lead out of the folder.
    let real = |path: &Path| path.canonicalize().map_err(of_part);
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
