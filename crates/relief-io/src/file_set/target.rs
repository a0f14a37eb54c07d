//! Final path of an output. Links are followed, so that they stay.

use std::ffi::{OsStr, OsString};
use std::io;
use std::path::{Path, PathBuf};

use super::FileSetError;

/// Greatest length of a chain of links.
const MOST_LINKS: usize = 40;

/// Path of a file, resolved to a folder without links and a name in it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Target {
    pub(super) folder: PathBuf,
    pub(super) name: OsString,
}

impl Target {
    /// Resolves a path. The file need not exist; its folder must.
    pub(super) fn of(path: &Path) -> Result<Self, FileSetError> {
        let mut next = path.to_owned();
        for _ in 0..MOST_LINKS {
            let name = next.file_name().ok_or_else(|| FileSetError::NoName(path.to_owned()))?.to_owned();
            let beside = folder_of(&next);
            let folder = beside.canonicalize().and_then(|folder| match folder.is_dir() {
                true => Ok(folder),
                false => Err(io::ErrorKind::NotADirectory.into()),
            });
            let folder =
                folder.map_err(|source| FileSetError::Folder { folder: beside.to_owned(), source })?;
            let file = folder.join(&name);
            match std::fs::symlink_metadata(&file) {
                Ok(about) if about.is_symlink() => {
                    let to = std::fs::read_link(&file)
                        .map_err(|source| FileSetError::Replace { path: file.clone(), source })?;
                    next = folder.join(to);
                }
                Ok(about) if about.is_dir() => return Err(FileSetError::IsFolder(path.to_owned())),
                Ok(about) if !about.is_file() => return Err(FileSetError::NoFile(path.to_owned())),
                Err(source) if source.kind() != io::ErrorKind::NotFound => {
                    return Err(FileSetError::Replace { path: path.to_owned(), source });
                }
                _ => return Ok(Self { folder, name }),
            }
        }
        Err(FileSetError::EndlessLink(path.to_owned()))
    }
}

/// Whether two paths lead to one file: by the same name, a link, or a hard link. The files need not
/// exist.
pub fn is_same_file(a: &Path, b: &Path) -> bool {
    let is_file = |path: &Path| std::fs::metadata(path).is_ok_and(|about| about.is_file());
    // Only regular files are opened: opening a pipe would block.
    let is_same = is_file(a) && is_file(b) && same_file::is_same_file(a, b).unwrap_or(false);
    is_same || matches!((Target::of(a), Target::of(b)), (Ok(a), Ok(b)) if a == b)
}

/// Folder that contains a file.
fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Bytes of a name.
#[cfg(unix)]
#[expect(clippy::unnecessary_wraps, reason = "elsewhere names may have no bytes")]
pub(super) fn to_bytes(name: &OsStr) -> io::Result<&[u8]> {
    Ok(std::os::unix::ffi::OsStrExt::as_bytes(name))
}

/// Name from its bytes.
#[cfg(unix)]
#[expect(clippy::unnecessary_wraps, reason = "elsewhere bytes may be no name")]
pub(super) fn from_bytes(bytes: &[u8]) -> io::Result<&OsStr> {
    Ok(std::os::unix::ffi::OsStrExt::from_bytes(bytes))
}

/// Bytes of a name.
#[cfg(not(unix))]
pub(super) fn to_bytes(name: &OsStr) -> io::Result<&[u8]> {
    let text = name.to_str().ok_or_else(|| io::Error::other("a name is not Unicode: rename it"))?;
    Ok(text.as_bytes())
}

/// Name from its bytes.
#[cfg(not(unix))]
pub(super) fn from_bytes(bytes: &[u8]) -> io::Result<&OsStr> {
    Ok(OsStr::new(std::str::from_utf8(bytes).map_err(io::Error::other)?))
}
