//! Why a mesh cannot be captured.

use relief_core::object::{MAX_VIEWS, ObjectError, ViewError};
use relief_core::{Cancelled, HeightMapError};

use super::{MAX_IMAGE_SIDE, MIN_IMAGE_SIDE};
use crate::arrangement::MAX_GRID;
use crate::verify::MAX_PICTURES;

/// Why a mesh cannot be captured.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CaptureError {
    /// Images are too small or too large.
    #[error("images of {0} texels a side: use {MIN_IMAGE_SIDE} to {MAX_IMAGE_SIDE}")]
    BadSize(u32),
    /// There are no views, or too many.
    #[error("{0} views: an object has 1 to {MAX_VIEWS}")]
    BadCount(usize),
    /// A grid is too small or too large.
    #[error("a grid of {0} frames a side: use 2 to {MAX_GRID}")]
    BadGrid(u32),
    /// Depths are stored in 8, 16 or 32 bits.
    #[error("depths of {0} bits: use 8, 16 or 32")]
    BadBits(u32),
    /// A field of view is given for views that have one already.
    #[error("the views are perspective and have fields of view already: give none")]
    OwnFov,
    /// There are too many pictures to compare, or the pictures are too large.
    #[error(
        "{views} pictures of {size}x{size} to compare: at most {} of {} a side are possible",
        MAX_PICTURES[0], MAX_PICTURES[1]
    )]
    BadPictures {
        /// Number of pictures.
        views: u32,
        /// Side of each picture in pixels.
        size: u32,
    },
    /// A view is impossible.
    #[error("view {number}: {problem}")]
    View {
        /// Number of the view, counted from 1.
        number: usize,
        /// The reason.
        problem: ViewError,
    },
    /// A view does not show all of the mesh.
    #[error("view {number} does not show all of the mesh: parts that an image does not show are lost")]
    CutOff {
        /// Number of the view, counted from 1.
        number: usize,
    },
    /// The images are too large.
    #[error(transparent)]
    Size(#[from] HeightMapError),
    /// The capture takes more memory than allowed.
    #[error(
        "{views} images of {size}x{size} and the mesh take {} MiB of memory, {} MiB are allowed",
        needed.div_ceil(1 << 20), limit >> 20
    )]
    TooMuchMemory {
        /// Number of images.
        views: usize,
        /// Side of each image in texels.
        size: u32,
        /// Bytes needed.
        needed: u64,
        /// Bytes allowed.
        limit: u64,
    },
    /// The captured images do not define an object.
    #[error(transparent)]
    Object(#[from] ObjectError),
    /// The capture was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
