//! How a mesh is made.

use crate::{BaseSurface, Directions, EDGE_RULES, EdgeRule, INTERIORS, Interior, Seams, Shading};

/// How a mesh is made.
#[derive(Clone, Copy, Debug)]
pub struct MeshSettings {
    /// Where the sides of patches are divided.
    pub edges: &'static EdgeRule,
    /// What fills a patch.
    pub interior: &'static Interior,
    /// For the edge rule `texels`: a point every so many texels, at least 1.
    pub texels: u32,
    /// The surface that is displaced.
    pub base: BaseSurface,
    /// Along what it is displaced.
    pub directions: Directions,
    /// The normals of the vertices.
    pub shading: Shading,
    /// What becomes of seams and hard edges.
    pub seams: Seams,
}

impl Default for MeshSettings {
    /// A point every texel, in a fixed pattern, on flat triangles along interpolated normals, without gaps.
    fn default() -> Self {
        Self {
            edges: &EDGE_RULES[0],
            interior: &INTERIORS[0],
            texels: 1,
            base: BaseSurface::default(),
            directions: Directions::default(),
            shading: Shading::default(),
            seams: Seams::default(),
        }
    }
}
