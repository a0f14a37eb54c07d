//! What the functions of a method need at each vertex of a bent mesh.

use relief_core::mesh::{Mesh, QuadricCoefficients};

use crate::mesh::tangent;

/// The frame and the curvature of a mesh at each of its vertices, for an engine's vertex attributes.
///
/// A fragment shader can make the same from derivatives, one value for each triangle. Interpolated
/// from vertices they are smooth, so relief meets the renderer's.
///
/// ```
/// use relief_core::mesh::sphere;
/// use relief_io::VertexFrames;
///
/// let mesh = sphere(64, 32)?;
/// let frames = VertexFrames::of(&mesh);
/// assert_eq!(frames.tangents.len(), mesh.vertices().len());
/// // The radius is 0.5 m: d metres away a sphere has fallen by d² metres.
/// for ([along_u, _], [x, _, _]) in frames.tiles_m.iter().zip(&frames.curvatures) {
///     assert!((x + along_u * along_u).abs() < 1e-4);
/// }
/// # Ok::<(), relief_core::mesh::MeshError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct VertexFrames {
    /// glTF's `TANGENT`: the unit tangent along growing `u`, perpendicular to the normal, and 1 or -1.
    pub tangents: Vec<[f32; 4]>,
    /// `_TILE`: the length of a tile of the texture along `u` and along `v`, in metres.
    pub tiles_m: Vec<[f32; 2]>,
    /// `_CURVATURE`: `x`, `y` and `z` of the height `x du² + y du dv + z dv²` of the mesh beside the
    /// vertex, in metres, `(du, dv)` tiles away ([`Mesh::quadrics`]).
    pub curvatures: Vec<[f32; 3]>,
}

impl VertexFrames {
    /// Returns the frames of a mesh.
    pub fn of(mesh: &Mesh) -> Self {
        let vertices = mesh.vertices();
        Self {
            tangents: vertices.iter().map(tangent).collect(),
            tiles_m: vertices
                .iter()
                .map(|vertex| [vertex.tangent.length(), vertex.bitangent.length()])
                .collect(),
            curvatures: mesh.quadrics(QuadricCoefficients::Three),
        }
    }
}
