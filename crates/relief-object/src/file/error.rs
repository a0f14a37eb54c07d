//! Errors of the files of an object.

use std::path::PathBuf;

use relief_core::HeightMapError;
use relief_core::object::{MAX_VIEWS, ObjectError, ViewError};
use relief_core::registry::UnknownName;
use relief_io::ReadError;

use crate::ViewKind;

/// Why the files of an object cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum ObjectFileError {
    /// The file cannot be read.
    #[error("{}: cannot be read: {source}", path.display())]
    Io {
        /// Path of the file.
        path: PathBuf,
        /// Error of the system.
        source: std::io::Error,
    },
    /// The file is not TOML, or has a value of the wrong type.
    #[error("{}: {source}", path.display())]
    Toml {
        /// Path of the file.
        path: PathBuf,
        /// Error of the parser, with the line.
        source: Box<toml::de::Error>,
    },
    /// The file has impossible content.
    #[error(
        "{}, line {line}{}: {problem}",
        path.display(),
        view.map(|number| format!(", view {number}")).unwrap_or_default()
    )]
    InFile {
        /// Path of the file.
        path: PathBuf,
        /// Line, counted from 1.
        line: usize,
        /// Number of the view, counted from 1, if the error belongs to one.
        view: Option<usize>,
        /// The problem.
        problem: Box<ObjectFileProblem>,
    },
    /// A picture cannot be read.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// A picture has another size than the depths.
    #[error(
        "{} is {}x{} texels, {} is {}x{}: make them equally large",
        path.display(), size[0], size[1], depth.display(), depth_size[0], depth_size[1]
    )]
    OtherSize {
        /// Path of the picture.
        path: PathBuf,
        /// Columns and rows of the picture.
        size: [u32; 2],
        /// Path of the picture of depths.
        depth: PathBuf,
        /// Columns and rows of the picture of depths.
        depth_size: [u32; 2],
    },
    /// The object takes more memory than allowed.
    #[error(
        "{}: its views take {} MiB of memory, {} MiB are allowed: make them smaller or raise the limit",
        path.display(), needed.div_ceil(1 << 20), limit >> 20
    )]
    TooMuchMemory {
        /// Path of the file.
        path: PathBuf,
        /// Bytes needed.
        needed: u64,
        /// Bytes allowed.
        limit: u64,
    },
    /// Views and depths do not define an object.
    #[error("{}: {source}", path.display())]
    Object {
        /// Path of the file.
        path: PathBuf,
        /// The reason.
        source: ObjectError,
    },
}

/// A problem in an object's file.
#[derive(Debug, thiserror::Error)]
pub enum ObjectFileProblem {
    /// A key or a name is unknown.
    #[error(transparent)]
    Unknown(#[from] UnknownName),
    /// There are no views, or too many.
    #[error("an object has 1 to {MAX_VIEWS} views, this one {0}: write [[view]] before each")]
    BadCount(usize),
    /// A key has the wrong number of numbers.
    #[error("'{key}' has {given} numbers: it must have {must}")]
    OtherLength {
        /// Name of the key.
        key: &'static str,
        /// Number of numbers given.
        given: usize,
        /// Number of numbers needed.
        must: usize,
    },
    /// A key is missing.
    #[error("'{key}' is missing: every {kind} view needs it")]
    Missing {
        /// Name of the key.
        key: &'static str,
        /// Kind of the object's views.
        kind: ViewKind,
    },
    /// A key belongs to views of the other kind.
    #[error("'{key}' does not belong to a view that is {kind}")]
    OtherKind {
        /// Name of the key.
        key: &'static str,
        /// Kind of the object's views.
        kind: ViewKind,
    },
    /// A view is impossible.
    #[error(transparent)]
    View(#[from] ViewError),
    /// The rectangle has no texels, or too many.
    #[error("'rect' cannot be used: {0}")]
    Size(#[from] HeightMapError),
    /// The rectangle reaches beyond the picture of depths.
    #[error("its rect {rect:?} reaches beyond {}, which is {}x{} texels", depth.display(), size[0], size[1])]
    Outside {
        /// Column, row, width and height.
        rect: [u32; 4],
        /// Path of the picture of depths.
        depth: PathBuf,
        /// Columns and rows of that picture.
        size: [u32; 2],
    },
    /// Two rectangles share texels.
    #[error("its rect {rect:?} overlaps {with:?} of view {other}: give each view its own texels")]
    Overlap {
        /// Column, row, width and height.
        rect: [u32; 4],
        /// Number of the other view, counted from 1.
        other: usize,
        /// Rectangle of the other view.
        with: [u32; 4],
    },
    /// A measured number is impossible.
    #[error("'{key}' is {value}: it must be {must}")]
    Measured {
        /// Name of the key.
        key: &'static str,
        /// Value of the key.
        value: f64,
        /// Accepted values.
        must: &'static str,
    },
    /// The views cannot be packed into an atlas.
    #[error(transparent)]
    Layout(#[from] ObjectError),
}
