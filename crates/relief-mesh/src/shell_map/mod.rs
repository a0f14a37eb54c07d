//! Shell maps: a closed mesh in the space of one tile, which every triangle of a base mesh repeats
//! in its shell.
//!
//! The shell of a base triangle is the space between its corners and the same corners moved along
//! their normals. It is cut into three tetrahedra, and in each of them positions are linear in
//! `(u, v, height)`, as the surface `tetrahedra` of `relief-shaders` shows them. So the motif is cut at
//! the tetrahedra's faces, and each piece is moved to its place.
//!
//! A point on a face is computed from the face's three corners alone, and a point on an edge from its
//! two ends. So both sides have the same point, to the bit: a closed motif stays closed on a closed
//! base. What lies inside and outside is decided in whole numbers, without rounding.
//!
//! * Porumbescu, Budge, Feng and Joy 2005, "Shell maps".
//! * Schein, Karpen and Elber 2005, "Real-time geometric deformation displacement maps".
//! * Szirmay-Kalos and Umenhoffer 2008, sections 5.2 and 7.

mod cut;
mod lattice;
mod output;
mod predicates;
mod shell;
mod tree;

use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::prelude::*;
use relief_core::mesh::{Mesh, MeshError, RawMesh};
use relief_core::{Cancelled, MotifTreeError, Watch};

use self::lattice::Lattice;
use self::output::Output;
use self::shell::Shell;
pub use self::tree::{MotifForRays, motif_for_rays};

/// Most tiles that one base triangle may span along `u` or `v`.
pub const MAX_TILES_OF_A_TRIANGLE: u32 = 128;

/// Most triangles of the result.
pub const MAX_TRIANGLES: u64 = 1 << 28;

/// Memory in bytes for a triangle of the result, while it is made.
pub const BYTES_PER_TRIANGLE: u64 = 400;

/// Settings of [`map_shells`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShellMapSettings {
    /// Metres between the heights 0 and 1.
    pub scale_m: f64,
    /// Metres of height 0 above the base.
    pub bias_m: f64,
    /// Most triangles of the result, at most [`MAX_TRIANGLES`].
    pub triangles: u64,
}

impl Default for ShellMapSettings {
    fn default() -> Self {
        Self { scale_m: 0.05, bias_m: 0.0, triangles: MAX_TRIANGLES }
    }
}

/// Why a motif cannot be put on a mesh.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ShellMapError {
    /// The work was cancelled.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// Scale or bias are not finite, or the scale is 0.
    #[error("scale {scale_m} m and bias {bias_m} m: both must be finite, and the scale not 0")]
    Lengths {
        /// Metres between the heights 0 and 1.
        scale_m: f64,
        /// Metres of height 0 above the base.
        bias_m: f64,
    },
    /// Faces of the motif lie on faces of the shells, however it is moved.
    #[error(
        "faces of the motif lie exactly on the shells' faces, however it is moved: turn or move the \
         motif a little"
    )]
    Aligned,
    /// Nothing of the motif lies between the heights 0 and 1 over the base.
    #[error(
        "nothing of the motif lies on the mesh: its heights must be between 0 and 1, and the mesh needs \
         texture coordinates"
    )]
    Nothing,
    /// The motif has a vertex that is not finite, or lies more than 16 tiles away.
    #[error(
        "vertex {0} of the motif lies more than 16 tiles away: x and z are 0 to 1 along the tile, y is \
         the height from 0 to 1"
    )]
    FarMotif(usize),
    /// A base triangle spans too many tiles.
    #[error(
        "triangle {triangle} of the mesh spans {tiles} tiles, more than {MAX_TILES_OF_A_TRIANGLE}: give \
         larger tiles, or a finer mesh"
    )]
    TooWide {
        /// The triangle.
        triangle: usize,
        /// Tiles that it spans.
        tiles: u64,
    },
    /// The motif makes no tree for rays.
    #[error(transparent)]
    Tree(#[from] MotifTreeError),
    /// The result is no mesh.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The result would be too large.
    #[error(
        "the mesh would have about {expected} triangles, more than {most}: give larger tiles, or a simpler \
         motif"
    )]
    TooLarge {
        /// About how many triangles there would be.
        expected: u64,
        /// How many are allowed.
        most: u64,
    },
}

/// A motif on all shells of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct ShellMap {
    /// The triangles, with the base's texture coordinates.
    pub mesh: Mesh,
    /// Edges with an odd number of triangles. There are none if motif and base are closed.
    pub open_edges: u64,
    /// Base triangles whose shell is folded somewhere: it is deeper than the base is curved.
    pub folded: Vec<u32>,
    /// Base triangles without an area in texture coordinates, which carry nothing.
    pub without_area: u64,
    /// The part of the motif's vertices below height 0 or above height 1, where it is cut off.
    pub beyond: f64,
    /// Triangles of the motif that lie on another one that looks the other way, also in the next tile:
    /// the caps of threads. They are inside the solid, and are left out.
    pub doubled: u64,
}

/// Puts a motif on a mesh.
///
/// A position of the motif is `(u, height, v)`: `u` and `v` from 0 to 1 along the tile, heights from
/// 0 to 1 above the base. Parts that cross the tile's edges reach into the tiles beside it. Parts
/// below height 0 or above height 1 are cut off. The tiles are the base's texture coordinates.
///
/// Places are rounded to 2⁻²⁴ of a tile first. The result has the same bytes with any number of
/// threads.
///
/// ```
/// use relief_core::Watch;
/// use relief_core::mesh::torus;
/// use relief_mesh::motif::{MotifKind, MotifSettings, motif};
/// use relief_mesh::shell_map::{ShellMapSettings, map_shells};
///
/// let mail = motif(&MotifSettings { detail: 4, ..MotifSettings::new(MotifKind::Mail) })?;
/// let torus = torus(16, 8)?.tiled(glam::Vec2::new(4.0, 2.0))?;
/// let made = map_shells(&torus, &(&mail.mesh).into(), &ShellMapSettings::default(), &Watch::none())?;
/// assert_eq!(made.open_edges, 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// When the motif lies elsewhere, the base has no texture coordinates, the result would be too large,
/// or the work is cancelled.
pub fn map_shells(
    base: &Mesh,
    motif: &RawMesh,
    settings: &ShellMapSettings,
    watch: &Watch,
) -> Result<ShellMap, ShellMapError> {
    let ShellMapSettings { scale_m, bias_m, .. } = *settings;
    if !(scale_m.is_finite() && bias_m.is_finite()) || scale_m == 0.0 {
        return Err(ShellMapError::Lengths { scale_m, bias_m });
    }
    // Where something of the motif lies exactly on a face, all of it is moved a little, and cut anew.
    for attempt in 0..ATTEMPTS {
        if let Some(made) = attempted(base, motif, settings, attempt, watch)? {
            return Ok(made);
        }
    }
    Err(ShellMapError::Aligned)
}

/// Returns the triangles of a mesh whose shells fold between two lengths above it, in metres: they are deeper
/// than the mesh is curved, so that a tetrahedron of theirs is turned inside out.
///
/// Triangles without an area in texture coordinates, and those that span too many tiles, are left out.
pub fn folded_shells(base: &Mesh, lengths_m: [f64; 2]) -> Vec<u32> {
    let welded = base.welded();
    let folds = |triangle: &usize| {
        let corners = base.triangles()[*triangle];
        let vertices = corners.map(|corner| &base.vertices()[corner as usize]);
        let numbers = corners.map(|corner| welded[corner as usize]);
        let shell = Shell::new(*triangle, vertices, numbers, lengths_m);
        matches!(shell, Ok(Some(shell)) if shell.is_folded())
    };
    (0..base.triangles().len()).filter(folds).map(|triangle| triangle as u32).collect()
}

/// Ways to move a motif that are tried.
const ATTEMPTS: u32 = 24;

/// Makes the mesh with a motif that is moved by one of some small ways. `None` if something of it then lies
/// exactly on a face.
fn attempted(
    base: &Mesh,
    motif: &RawMesh,
    settings: &ShellMapSettings,
    attempt: u32,
    watch: &Watch,
) -> Result<Option<ShellMap>, ShellMapError> {
    let lattice = Lattice::new(motif, attempt)?;
    let welded = base.welded();
    let lengths = [settings.bias_m, settings.bias_m + settings.scale_m];
    let (mut shells, mut without_area, mut expected) = (Vec::new(), 0, 0.0);
    for (triangle, corners) in base.triangles().iter().enumerate() {
        let vertices = corners.map(|corner| &base.vertices()[corner as usize]);
        let numbers = corners.map(|corner| welded[corner as usize]);
        match Shell::new(triangle, vertices, numbers, lengths)? {
            Some(shell) => {
                expected += shell.tiles_covered() * lattice.triangles.len() as f64;
                shells.push(shell);
            }
            None => without_area += 1,
        }
    }
    let most = settings.triangles.min(MAX_TRIANGLES);
    if expected > most as f64 {
        return Err(ShellMapError::TooLarge { expected: expected as u64, most });
    }
    let (done, all) = (AtomicUsize::new(0), shells.len().max(1));
    // In the order of the base's triangles, whichever thread makes them.
    let pieces: Vec<Option<cut::Pieces>> = shells
        .par_iter()
        .map(|shell| {
            let pieces = cut::pieces(shell, &lattice);
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            watch.at(0.9 * done as f32 / all as f32)?;
            Ok(pieces)
        })
        .collect::<Result<_, Cancelled>>()?;
    let Some(pieces) = pieces.into_iter().collect::<Option<Vec<_>>>() else { return Ok(None) };
    let count: u64 = pieces.iter().map(|pieces| pieces.triangles.len() as u64).sum();
    if count > most {
        return Err(ShellMapError::TooLarge { expected: count, most });
    }
    let mut output = Output::default();
    for (shell, pieces) in shells.iter().zip(&pieces) {
        output.add(shell, pieces);
    }
    watch.at(1.0)?;
    if output.is_empty() {
        return Err(ShellMapError::Nothing);
    }
    let (mesh, open_edges) = output.finish()?;
    let folded = shells.iter().filter(|shell| shell.is_folded()).map(|shell| shell.triangle as u32).collect();
    let (beyond, doubled) = (lattice.beyond, lattice.doubled);
    Ok(Some(ShellMap { mesh, open_edges, folded, without_area, beyond, doubled }))
}

#[cfg(test)]
mod tests;
