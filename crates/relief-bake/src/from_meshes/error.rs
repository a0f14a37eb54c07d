//! Errors of heights between two meshes.

use relief_core::{Cancelled, HeightMapError};

/// Most tiles that a triangle may span along an axis. With more, the map has hardly a texel for
/// each of its points.
pub const MAX_TILES: u32 = 16;

/// Reason why there are no heights between two meshes.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FromMeshesError {
    /// The map's size is invalid.
    #[error(transparent)]
    Map(#[from] HeightMapError),
    /// The simple mesh has no triangles.
    #[error("the simple mesh has no triangles for a map to lie on")]
    NothingToLieOn,
    /// The detailed mesh has no triangles.
    #[error("the detailed mesh has no triangles")]
    NothingToFind,
    /// The cage is not a finite length above 0.
    #[error("the search distance is {0} m: it must be finite and above 0")]
    BadCage(f64),
    /// A triangle lies beyond the edges of a clamped map.
    #[error(
        "triangle {triangle} of the simple mesh has texture coordinates outside of 0 to 1, where a clamped \
         map has no texels: tile or mirror the map, or move the coordinates"
    )]
    Outside {
        /// The first such triangle.
        triangle: u32,
    },
    /// A triangle spans too many tiles.
    #[error(
        "triangle {triangle} of the simple mesh spans {tiles} tiles of the map, at most {MAX_TILES} are \
         possible: give every place its own part of the map"
    )]
    Tiled {
        /// The first such triangle.
        triangle: u32,
        /// Tiles along the longer axis.
        tiles: f64,
    },
    /// No texel lies on the simple mesh.
    #[error(
        "no triangle of the simple mesh lies on the centre of any texel: the map is too small, or the \
         texture coordinates have no area"
    )]
    NoTexel,
    /// No line hits the detailed mesh.
    #[error(
        "none of {texels} texels finds the detailed mesh within {cage_m} m along its normal: check that \
         both meshes lie in the same place and use the same unit{}", of_backs(*behind)
    )]
    NothingFound {
        /// Texels with a line.
        texels: u64,
        /// Greatest distance of a hit, in metres.
        cage_m: f64,
        /// Texels whose lines hit only faces turned the other way.
        behind: u64,
    },
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// Sentence about back faces, empty without any.
fn of_backs(behind: u64) -> String {
    match behind {
        0 => String::new(),
        _ => format!(
            ". {behind} of them find faces that look the other way: turn these, or let both sides count"
        ),
    }
}
