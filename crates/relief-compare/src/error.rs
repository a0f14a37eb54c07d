//! Errors of comparisons.

use relief_core::camera::CameraError;
use relief_core::exact::DisplacedMeshError;
use relief_core::{ByteSize, Cancelled, HeightMapError};
use relief_maps::MapsError;
use relief_render::RenderError;
use relief_scene::ValueError;
use relief_shaders::SelectionError;

use crate::picture::ImageError;

/// Reason why a comparison failed.
#[derive(Debug, thiserror::Error)]
pub enum CompareError {
    /// A number is out of range.
    #[error("{what} is {value}: it must be {must}")]
    Value {
        /// Name of the number.
        what: &'static str,
        /// Value of the number.
        value: f64,
        /// Allowed range.
        must: &'static str,
    },
    /// There is nothing to compare.
    #[error("there are no {0} to compare: name at least one")]
    Nothing(&'static str),
    /// A surface is a depth object.
    #[error("a surface is an object of images: compare methods on a height map on a mesh")]
    Object,
    /// A surface is a volume or a motif, as the text says.
    #[error("a surface is {0}: compare methods on a height map on a mesh")]
    Solid(&'static str),
    /// The exact hits of a scene's pixels are unknown.
    #[error(
        "errors of hits need a scene with one height map on a mesh, where the exact hit is known, and this \
         is {0}: show another quantity"
    )]
    NoExactHits(String),
    /// The comparison needs too much memory.
    #[error(
        "rays and pictures need {} MiB of memory, but {limit} are allowed: compare fewer or smaller ones, or \
         raise the limit",
        needed.div_ceil(1 << 20)
    )]
    TooMuchMemory {
        /// Bytes needed.
        needed: u64,
        /// Memory limit.
        limit: ByteSize,
    },
    /// The map has no level with that side.
    #[error(
        "the map of {}x{} texels has no level of {side} texels: choose one of {}",
        size[0],
        size[1],
        listed(sides)
    )]
    NoLevel {
        /// Side that was requested.
        side: u32,
        /// Columns and rows of the map.
        size: [u32; 2],
        /// Longer sides of the map's levels.
        sides: Vec<u32>,
    },
    /// Distances were given for an orthographic camera, whose picture does not depend on them.
    #[error(
        "an orthographic picture is the same from every distance: compare without distances, or use a \
         perspective camera"
    )]
    Orthographic,
    /// A method does not allow such settings.
    #[error(transparent)]
    Selection(#[from] SelectionError),
    /// The height map cannot be displaced as requested.
    #[error(transparent)]
    Heights(#[from] HeightMapError),
    /// A baked map cannot be provided.
    #[error(transparent)]
    Maps(MapsError),
    /// A picture cannot be rendered.
    #[error("{method}: {source}")]
    Render {
        /// Label of the method.
        method: String,
        /// Error of the renderer.
        source: Box<RenderError>,
    },
    /// A method cannot render the scene.
    #[error(transparent)]
    Scene(#[from] ValueError),
    /// The camera cannot be moved.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// The exact tracer cannot judge a surface.
    #[error(transparent)]
    Judge(#[from] DisplacedMeshError),
    /// Pictures cannot be compared.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// The comparison was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl CompareError {
    /// Creates the error of a method's picture.
    pub(crate) fn of_picture(method: &str, error: RenderError) -> Self {
        match error {
            RenderError::Cancelled(cancelled) => cancelled.into(),
            source => Self::Render { method: method.to_owned(), source: Box::new(source) },
        }
    }
}

impl From<MapsError> for CompareError {
    fn from(error: MapsError) -> Self {
        match error {
            MapsError::Cancelled(cancelled) => cancelled.into(),
            other => Self::Maps(other),
        }
    }
}

fn listed(sides: &[u32]) -> String {
    sides.iter().map(u32::to_string).collect::<Vec<_>>().join(", ")
}
