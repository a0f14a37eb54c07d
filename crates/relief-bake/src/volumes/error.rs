//! Errors of volumes.

use relief_core::mesh::FramingError;
use relief_core::{Cancelled, HeightMapError, VolumeError};

use super::MAX_TILES;

/// Reason why there is no volume.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum VolumesError {
    /// The size is invalid for a volume.
    #[error(transparent)]
    Volume(#[from] VolumeError),
    /// The displacement does not fit.
    #[error(transparent)]
    Displacement(#[from] HeightMapError),
    /// The mesh cannot be used.
    #[error(transparent)]
    Mesh(#[from] FramingError),
    /// The mesh has no extent along an axis.
    #[error("the mesh is flat along its {axis} axis, so nothing of it is solid: give a closed mesh")]
    Flat {
        /// The axis: x, y or z.
        axis: &'static str,
    },
    /// The margin leaves no voxel for the mesh.
    #[error(
        "a margin of {margin} voxels on both sides leaves nothing of {}x{}x{} voxels: make the margin \
         smaller",
        size[0], size[1], size[2]
    )]
    NoRoom {
        /// Voxels beside the mesh.
        margin: f64,
        /// Columns, rows and slices.
        size: [u32; 3],
    },
    /// The mesh reaches too far beyond its tile.
    #[error(
        "the mesh reaches {tiles} tiles from its own, at most {MAX_TILES} are possible: bring it to \
         coordinates from 0 to 1"
    )]
    TooWide {
        /// Tiles between the mesh's farthest point and its tile.
        tiles: f64,
    },
    /// Too many triangles reach over several tiles.
    #[error("most triangles of the mesh reach over many tiles: bring it to coordinates from 0 to 1")]
    TooManyCopies,
    /// Nothing of the mesh lies between heights 0 and 1.
    #[error("no part of the mesh lies between the heights 0 and 1 of the tile: bring it there")]
    Outside,
    /// A setting is outside its range.
    #[error("{what} is {value}: it must be {must}")]
    BadSetting {
        /// Name of the setting.
        what: &'static str,
        /// Value given.
        value: f64,
        /// Range of the setting.
        must: &'static str,
    },
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}
