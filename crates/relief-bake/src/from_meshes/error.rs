//! Why there are no heights between two meshes.

use relief_core::{Cancelled, HeightMapError};

/// The most tiles that a triangle may lie over along an axis: with more the map has hardly a place for each
/// of its points.
pub const MAX_TILES: u32 = 16;

/// Why there are no heights between two meshes.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FromMeshesError {
    /// The map is none.
    #[error(transparent)]
    Map(#[from] HeightMapError),
    /// The simple mesh has no triangles.
    #[error("the simple mesh has no triangles for a map to lie on")]
    NothingToLieOn,
    /// The detailed mesh has no triangles.
    #[error("the detailed mesh has no triangles to be found")]
    NothingToFind,
    /// The cage is no length.
    #[error("the farthest to look is {0} m: it must be finite and above 0")]
    BadCage(f64),
    /// A triangle lies beyond the edges of a map that does not go on there.
    #[error(
        "triangle {triangle} of the simple mesh has texture coordinates outside of 0 to 1, where a clamped \
         map has no texels: tile or mirror the map, or move the coordinates"
    )]
    Outside {
        /// The first such triangle.
        triangle: u32,
    },
    /// A triangle lies over many tiles.
    #[error(
        "triangle {triangle} of the simple mesh lies over {tiles} tiles of the map, at most {MAX_TILES} are \
         possible: give every place its own part of the map"
    )]
    Tiled {
        /// The first such triangle.
        triangle: u32,
        /// Its tiles along the longer axis.
        tiles: f64,
    },
    /// No texel lies on the simple mesh.
    #[error(
        "no triangle of the simple mesh lies on the centre of any texel: the map is too small, or the \
         texture coordinates have no area"
    )]
    NoTexel,
    /// No line found the detailed mesh.
    #[error(
        "none of {texels} texels finds the detailed mesh within {cage_m} m along its normal: do both \
         meshes lie in the same place, in the same unit?{}", of_backs(*behind)
    )]
    NothingFound {
        /// Texels that looked.
        texels: u64,
        /// How far they looked, in metres.
        cage_m: f64,
        /// Those that found faces which look the other way.
        behind: u64,
    },
    /// It was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

/// What is said where there are backs.
fn of_backs(behind: u64) -> String {
    match behind {
        0 => String::new(),
        _ => format!(
            " {behind} of them find faces that look the other way: turn these, or let both sides count"
        ),
    }
}
