//! Motifs as trees, for rays that meet them in the shells of another mesh.

use glam::DVec3;
use relief_core::mesh::RawMesh;
use relief_core::{MotifTree, MotifTreeError, TileTriangle};

use super::ShellMapError;
use super::lattice::{Lattice, STEPS};

/// A motif for rays in the space of a tile.
#[derive(Clone, Debug, PartialEq)]
pub struct MotifForRays {
    /// The tree of its triangles.
    pub tree: MotifTree,
    /// The part of its vertices below height 0 or above height 1, where it is cut off.
    pub beyond: f64,
}

/// Makes the tree of a motif, with the triangles that [`map_shells`](super::map_shells) puts on a mesh.
///
/// A position of the motif is `(u, height, v)`, as there.
///
/// ```
/// use relief_mesh::motif::{MotifKind, MotifSettings, motif};
/// use relief_mesh::shell_map::motif_for_rays;
///
/// let mail = motif(&MotifSettings::new(MotifKind::Mail))?;
/// let made = motif_for_rays(&(&mail.mesh).into())?;
/// // Links that reach into the next tile count in both.
/// assert!(made.tree.triangles() as usize > mail.mesh.triangles().len());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// When the motif lies elsewhere, or has too many triangles.
pub fn motif_for_rays(motif: &RawMesh) -> Result<MotifForRays, ShellMapError> {
    let lattice = Lattice::new(motif, 0)?;
    let place = |point: &[i64; 3]| DVec3::from(point.map(|step| step as f64)) / STEPS as f64;
    let triangles: Vec<TileTriangle> = lattice
        .triangles
        .iter()
        .map(|triangle| TileTriangle {
            corners: [0, 1, 2].map(|corner| place(&triangle.points[corner])),
            normals: triangle.normals.map(|normal| normal.as_vec3()),
        })
        .collect();
    let tree = MotifTree::new(&triangles).map_err(|error| match error {
        MotifTreeError::Nothing => ShellMapError::Nothing,
        error => ShellMapError::Tree(error),
    })?;
    Ok(MotifForRays { tree, beyond: lattice.beyond })
}
