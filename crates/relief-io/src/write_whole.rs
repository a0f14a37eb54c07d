//! Atomic writing of files: into a temporary file in the same folder, synced to the disk, then
//! renamed.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

use crate::{WriteError, WriteProblem};

/// Writes a file atomically: at any moment either its old content or all of its new content is
/// present.
///
/// `content` writes into a temporary file beside it. If it succeeds, the bytes are synced to the
/// disk and the file is renamed. If anything fails, the temporary file is removed and an existing
/// file keeps its content.
///
/// # Errors
///
/// When the folder cannot be written to, when `content` fails (on a full disk, for example), or
/// when the file cannot be renamed.
pub fn write_atomically(
    path: &Path,
    content: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> Result<(), WriteError> {
    write_file(path, |out| content(out).map_err(WriteProblem::Io))
}

/// Writes a file like [`write_atomically`], for encoders that seek and have errors of their own.
pub(crate) fn write_file(
    path: &Path,
    content: impl FnOnce(&mut BufWriter<&File>) -> Result<(), WriteProblem>,
) -> Result<(), WriteError> {
    write_and_rename(path, content).map_err(|problem| problem.at(path))
}

fn write_and_rename(
    path: &Path,
    content: impl FnOnce(&mut BufWriter<&File>) -> Result<(), WriteProblem>,
) -> Result<(), WriteProblem> {
    path.file_name().ok_or(WriteProblem::NoName)?;
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    builder.prefix(".relief-").suffix(".tmp");
    // Temporary files are private by default. The finished file gets the permissions that the
    // process' mask allows.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    let temporary = builder.tempfile_in(folder).map_err(WriteProblem::Folder)?;
    let mut out = BufWriter::with_capacity(1 << 16, temporary.as_file());
    content(&mut out)?;
    out.flush()?;
    drop(out);
    temporary.as_file().sync_all()?;
    temporary.persist(path).map_err(|error| WriteProblem::Rename(error.error))?;
    Ok(())
}
