//! What can be wrong with the files of an object.

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
        /// The file.
        path: PathBuf,
        /// What the system says.
        source: std::io::Error,
    },
    /// The file is no TOML, or has a value of the wrong kind.
    #[error("{}: {source}", path.display())]
    Toml {
        /// The file.
        path: PathBuf,
        /// What is wrong, with the line.
        source: Box<toml::de::Error>,
    },
    /// The file says what cannot be.
    #[error(
        "{}, line {line}{}: {problem}",
        path.display(),
        view.map(|number| format!(", view {number}")).unwrap_or_default()
    )]
    InFile {
        /// The file.
        path: PathBuf,
        /// The line, counted from 1.
        line: usize,
        /// The view, counted from 1, if it is one's.
        view: Option<usize>,
        /// What is wrong.
        problem: Box<ObjectFileProblem>,
    },
    /// A picture cannot be read.
    #[error(transparent)]
    Read(#[from] ReadError),
    /// A picture has another size than the depths.
    #[error(
        "{} is {}x{} texels, {} is {}x{}: make them alike",
        path.display(), size[0], size[1], depth.display(), depth_size[0], depth_size[1]
    )]
    OtherSize {
        /// The picture.
        path: PathBuf,
        /// Its columns and rows.
        size: [u32; 2],
        /// The picture of the depths.
        depth: PathBuf,
        /// Its columns and rows.
        depth_size: [u32; 2],
    },
    /// The object takes more memory than allowed.
    #[error(
        "{}: its views take {} MiB of memory, {} MiB are allowed: make them smaller or raise the limit",
        path.display(), needed.div_ceil(1 << 20), limit >> 20
    )]
    TooMuchMemory {
        /// The file.
        path: PathBuf,
        /// Bytes that are needed.
        needed: u64,
        /// Bytes that are allowed.
        limit: u64,
    },
    /// Views and depths make no object.
    #[error("{}: {source}", path.display())]
    Object {
        /// The file.
        path: PathBuf,
        /// Why.
        source: ObjectError,
    },
}

/// What is wrong in an object's file.
#[derive(Debug, thiserror::Error)]
pub enum ObjectFileProblem {
    /// A key or a name that there is not.
    #[error(transparent)]
    Unknown(#[from] UnknownName),
    /// There are no views, or too many.
    #[error("an object has 1 to {MAX_VIEWS} views, this one {0}: write [[view]] before each")]
    BadCount(usize),
    /// There are more or fewer numbers than belong there.
    #[error("'{key}' has {given} numbers: it must have {must}")]
    OtherLength {
        /// The key.
        key: &'static str,
        /// How many there are.
        given: usize,
        /// How many there must be.
        must: usize,
    },
    /// A key is missing.
    #[error("'{key}' is missing: a view that is {kind} has it")]
    Missing {
        /// The key.
        key: &'static str,
        /// What the object's views are.
        kind: ViewKind,
    },
    /// A key belongs to views of the other kind.
    #[error("'{key}' does not belong to a view that is {kind}")]
    OtherKind {
        /// The key.
        key: &'static str,
        /// What the object's views are.
        kind: ViewKind,
    },
    /// There is no such view.
    #[error(transparent)]
    View(#[from] ViewError),
    /// The rectangle has no texels, or more than there can be.
    #[error("'rect' cannot be used: {0}")]
    Size(#[from] HeightMapError),
    /// The rectangle lies beside the atlas.
    #[error("its rect {rect:?} reaches beyond {}, which is {}x{} texels", depth.display(), size[0], size[1])]
    Outside {
        /// Column, row, width and height.
        rect: [u32; 4],
        /// The picture of the depths.
        depth: PathBuf,
        /// Its columns and rows.
        size: [u32; 2],
    },
    /// Two rectangles share texels.
    #[error("its rect {rect:?} overlaps that of view {other}, {with:?}: each view has texels of its own")]
    Overlap {
        /// Column, row, width and height.
        rect: [u32; 4],
        /// The other view, counted from 1.
        other: usize,
        /// Its rectangle.
        with: [u32; 4],
    },
    /// A measured number that cannot be.
    #[error("'{key}' is {value}: it must be {must}")]
    Measured {
        /// The key.
        key: &'static str,
        /// The value.
        value: f64,
        /// What it must be.
        must: &'static str,
    },
    /// The views make no layout.
    #[error(transparent)]
    Layout(#[from] ObjectError),
}
