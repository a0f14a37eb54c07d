//! Errors of writing a set of files.

use std::io;
use std::path::PathBuf;

/// Reason why a set of files was not written. The files are unchanged, unless the text says
/// otherwise.
#[derive(Debug, thiserror::Error)]
pub enum FileSetError {
    /// The folder cannot be created or written into.
    #[error(
        "{}: cannot write into this folder ({source}): check its permissions, or give another one",
        folder.display()
    )]
    Folder {
        /// The folder.
        folder: PathBuf,
        /// Error of the system.
        source: io::Error,
    },
    /// Another process works on the same files, and the caller stopped waiting.
    #[error(
        "{}: another process is writing the files of '{name}' into this folder: wait until it has ended, or \
         end it",
        folder.display()
    )]
    Busy {
        /// The folder.
        folder: PathBuf,
        /// The set's name.
        name: String,
    },
    /// The path has no file name.
    #[error("{}: has no file name: end the path with one", .0.display())]
    NoName(PathBuf),
    /// A folder has the name of an output.
    #[error("{}: cannot be written: it is a folder: give another name", .0.display())]
    IsFolder(PathBuf),
    /// Something that is neither file nor folder has the name of an output.
    #[error("{}: cannot be written: it is not a regular file: give another name", .0.display())]
    NoFile(PathBuf),
    /// Links lead to each other in a circle.
    #[error(
        "{}: cannot be written: it is a link that leads nowhere: remove the link or give another name",
        .0.display()
    )]
    EndlessLink(PathBuf),
    /// Two outputs are the same file.
    #[error("{}: two outputs would be written to this file: give them different names", .0.display())]
    Twice(PathBuf),
    /// A planned file was not written.
    #[error("{}: has no new content", .0.display())]
    NotWritten(PathBuf),
    /// A file cannot be replaced or examined.
    #[error("{}: cannot be replaced: {source}", path.display())]
    Replace {
        /// The file.
        path: PathBuf,
        /// Error of the system.
        source: io::Error,
    },
    /// Neither the old nor the new state could be reached.
    #[error(
        "{}: some files beside this folder are new and some are old, because of an error ({source}): fix it \
         and run again, which finishes the work, or remove this folder to leave the files as they are",
        staging.display()
    )]
    Stuck {
        /// The hidden staging folder with the journal.
        staging: PathBuf,
        /// Error that occurred.
        source: io::Error,
    },
}
