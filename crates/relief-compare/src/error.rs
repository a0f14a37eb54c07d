//! Why there is no comparison.

use relief_core::camera::CameraError;
use relief_core::exact::DisplacedMeshError;
use relief_core::{ByteSize, Cancelled, HeightMapError};
use relief_maps::MapsError;
use relief_render::RenderError;
use relief_scene::ValueError;
use relief_shaders::SelectionError;

use crate::picture::ImageError;

/// Why there is no comparison.
#[derive(Debug, thiserror::Error)]
pub enum CompareError {
    /// A number is out of range.
    #[error("{what} is {value}: it must be {must}")]
    Value {
        /// What it is of.
        what: &'static str,
        /// The number.
        value: f64,
        /// What it must be.
        must: &'static str,
    },
    /// There is nothing to compare.
    #[error("there are no {0} to compare")]
    Nothing(&'static str),
    /// A surface is an object of images.
    #[error("a surface is an object of images: methods are compared on height maps on meshes")]
    Object,
    /// It is too much.
    #[error(
        "{} MiB are needed for rays and pictures, more than the {limit} allowed",
        needed.div_ceil(1 << 20)
    )]
    TooMuchMemory {
        /// Bytes.
        needed: u64,
        /// The most that may be taken.
        limit: ByteSize,
    },
    /// The map has no level of that size.
    #[error(
        "the map of {}x{} texels cannot be filtered down to {side}: its levels are {}",
        size[0],
        size[1],
        listed(sides)
    )]
    NoLevel {
        /// The side that was asked for.
        side: u32,
        /// Columns and rows of the map.
        size: [u32; 2],
        /// The longer sides of the map's levels.
        sides: Vec<u32>,
    },
    /// An orthographic camera sees the same from everywhere along its view.
    #[error("an orthographic picture is the same from every distance")]
    Orthographic,
    /// A method cannot have such settings.
    #[error(transparent)]
    Selection(#[from] SelectionError),
    /// The height map cannot be displaced so.
    #[error(transparent)]
    Heights(#[from] HeightMapError),
    /// A baked map cannot be provided.
    #[error(transparent)]
    Maps(MapsError),
    /// A picture cannot be made.
    #[error("{method}: {source}")]
    Render {
        /// The method.
        method: String,
        /// Why.
        source: Box<RenderError>,
    },
    /// The scene cannot be shown by a method.
    #[error(transparent)]
    Scene(#[from] ValueError),
    /// The camera cannot be moved.
    #[error(transparent)]
    Camera(#[from] CameraError),
    /// There is no judge of such a surface.
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
    /// The error of a method's picture.
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
