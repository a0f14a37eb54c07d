//! Why a set of files is not written.

use std::io;
use std::path::PathBuf;

/// Why a set of files is not written. The files are as they were before, unless the text says otherwise.
#[derive(Debug, thiserror::Error)]
pub enum FileSetError {
    /// The folder cannot be made or written into.
    #[error("{}: cannot write into this folder ({source}): check its permissions, or give another one", folder.display())]
    Folder {
        /// The folder.
        folder: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// Another process works on the same files, and the caller does not wait any longer.
    #[error(
        "{}: another process is writing the files of '{name}' into this folder: wait until it has ended, or end it",
        folder.display()
    )]
    Busy {
        /// The folder.
        folder: PathBuf,
        /// The set's name.
        name: String,
    },
    /// The path ends in no file name.
    #[error("{}: is no file name", .0.display())]
    NoName(PathBuf),
    /// A folder has the name of an output.
    #[error("{}: cannot be written: it is a folder", .0.display())]
    IsFolder(PathBuf),
    /// Something has the name of an output that is neither file nor folder.
    #[error("{}: cannot be written: it is no regular file", .0.display())]
    NoFile(PathBuf),
    /// Links that lead to each other.
    #[error("{}: cannot be written: it is a link that leads nowhere", .0.display())]
    EndlessLink(PathBuf),
    /// Two outputs are the same file.
    #[error("{}: is named for two outputs, or links lead two of them to it", .0.display())]
    Twice(PathBuf),
    /// A file that is to be put in its place was not written.
    #[error("{}: has no new content", .0.display())]
    NotWritten(PathBuf),
    /// A file cannot be put in its place, or not be looked at.
    #[error("{}: cannot be replaced: {source}", path.display())]
    Replace {
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: io::Error,
    },
    /// Neither the old state nor the new one could be reached.
    #[error(
        "{}: the files beside this folder are neither all new nor all old, since {source}: mend that and run again, which \
         finishes the work, or remove this folder to leave the files as they are",
        room.display()
    )]
    Stuck {
        /// The hidden folder with the journal.
        room: PathBuf,
        /// What went wrong.
        source: io::Error,
    },
}
