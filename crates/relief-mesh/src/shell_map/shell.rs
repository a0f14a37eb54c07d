//! The shell of a base triangle: three tetrahedra.

use glam::{DVec2, DVec3, Vec3};
use relief_core::mesh::Vertex;

use super::lattice::STEPS;
use super::predicates::{Point, volume};
use super::{MAX_TILES_OF_A_TRIANGLE, ShellMapError};

/// A corner of a shell: of the triangle's corners by their order, the lower or the upper one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ShellCorner {
    pub of: usize,
    pub is_upper: bool,
}

const fn lower(of: usize) -> ShellCorner {
    ShellCorner { of, is_upper: false }
}

const fn upper(of: usize) -> ShellCorner {
    ShellCorner { of, is_upper: true }
}

/// The tetrahedra. Their corners come in an order that all neighbours agree on: lower ones before
/// upper ones, and both by the vertices' numbers.
pub const TETRAHEDRA: [[ShellCorner; 4]; 3] = [
    [lower(0), lower(1), lower(2), upper(2)],
    [lower(0), lower(1), upper(1), upper(2)],
    [lower(0), upper(0), upper(1), upper(2)],
];

/// A base triangle with its corners in the order of the welded vertices' numbers.
pub struct Shell<'a> {
    pub triangle: usize,
    pub vertices: [&'a Vertex; 3],
    /// Texture coordinates on the lattice.
    uvs: [[i64; 2]; 3],
    lengths: [f64; 2],
    /// Whether the texture is mirrored on the triangle.
    pub is_mirrored: bool,
}

impl<'a> Shell<'a> {
    /// The shell between two lengths above the triangle. `None` if the triangle has no area in texture
    /// coordinates.
    pub fn new(
        triangle: usize,
        vertices: [&'a Vertex; 3],
        numbers: [u32; 3],
        lengths: [f64; 2],
    ) -> Result<Option<Self>, ShellMapError> {
        let span = |axis: usize| {
            let along = vertices.map(|vertex| f64::from(vertex.uv[axis]));
            along.iter().fold(f64::NEG_INFINITY, |most, at| most.max(*at))
                - along.iter().fold(f64::INFINITY, |least, at| least.min(*at))
        };
        let tiles = span(0).max(span(1)).ceil();
        if tiles > f64::from(MAX_TILES_OF_A_TRIANGLE) {
            return Err(ShellMapError::TooWide { triangle, tiles: tiles as u64 });
        }
        let uv =
            |vertex: &Vertex| [0, 1].map(|axis| (f64::from(vertex.uv[axis]) * STEPS as f64).round() as i64);
        let turn = area(vertices.map(uv));
        if turn == 0 {
            return Ok(None);
        }
        let mut order = [0, 1, 2];
        order.sort_by_key(|at: &usize| numbers[*at]);
        let vertices = order.map(|at| vertices[at]);
        // Seen from the front, v points down: triangles that are not mirrored turn the other way.
        Ok(Some(Self { triangle, vertices, uvs: vertices.map(uv), lengths, is_mirrored: turn > 0 }))
    }

    /// The area in texture coordinates, in tiles.
    pub fn tiles_covered(&self) -> f64 {
        let steps = STEPS as f64;
        area(self.uvs).unsigned_abs() as f64 / (2.0 * steps * steps)
    }

    /// A corner on the lattice, as a tile sees it.
    pub fn point(&self, corner: ShellCorner, tile: [i64; 2]) -> Point {
        let [u, v] = self.uvs[corner.of];
        [u - tile[0] * STEPS, v - tile[1] * STEPS, if corner.is_upper { STEPS } else { 0 }]
    }

    /// Least and greatest texture coordinates on the lattice.
    pub fn extent(&self) -> [[i64; 2]; 2] {
        let [a, b, c] = self.uvs;
        [
            [0, 1].map(|axis| a[axis].min(b[axis]).min(c[axis])),
            [0, 1].map(|axis| a[axis].max(b[axis]).max(c[axis])),
        ]
    }

    /// The position of a corner.
    pub fn position(&self, corner: ShellCorner) -> DVec3 {
        let Vertex { position, normal, .. } = self.vertices[corner.of];
        position.as_dvec3() + normal.as_dvec3() * self.lengths[usize::from(corner.is_upper)]
    }

    pub fn uv(&self, corner: ShellCorner) -> DVec2 {
        self.vertices[corner.of].uv.as_dvec2()
    }

    /// The corners' tangents and bitangents by their weights.
    pub fn tangents(&self, weights: [f64; 3]) -> [Vec3; 2] {
        let sum = |part: fn(&Vertex) -> Vec3| {
            let each =
                self.vertices.iter().zip(weights).map(|(vertex, weight)| part(vertex).as_dvec3() * weight);
            each.sum::<DVec3>().as_vec3()
        };
        [sum(|vertex| vertex.tangent), sum(|vertex| vertex.bitangent)]
    }

    /// How the motif's normals turn in a tetrahedron: the images of the normals along `u`, `v` and
    /// the height, times one positive factor. Zero where the tetrahedron is flat.
    pub fn normals_in(&self, corners: &[ShellCorner; 4]) -> [DVec3; 3] {
        let place = corners.map(|corner| {
            let uv = self.uv(corner);
            DVec3::new(uv.x, uv.y, f64::from(u8::from(corner.is_upper)))
        });
        let [q0, q1, q2, q3] = corners.map(|corner| self.position(corner));
        let [p1, p2, p3] = [1, 2, 3].map(|at| place[at] - place[0]);
        let [e1, e2, e3] = [q1 - q0, q2 - q0, q3 - q0];
        // The gradients of the weights in the world carry covectors: n = sum of (n . p_k) g_k.
        let [g1, g2, g3] = [e2.cross(e3), e3.cross(e1), e1.cross(e2)];
        let sign = if e1.dot(g1) < 0.0 { -1.0 } else { 1.0 };
        [0, 1, 2].map(|axis| sign * (g1 * p1[axis] + g2 * p2[axis] + g3 * p3[axis]))
    }

    /// Whether height 1 lies below height 0.
    pub fn is_inverted(&self) -> bool {
        self.lengths[1] < self.lengths[0]
    }

    /// Whether a tetrahedron is turned inside out in the world.
    pub fn is_folded(&self) -> bool {
        TETRAHEDRA.iter().any(|corners| {
            let [a, b, c, d] = corners.map(|corner| self.point(corner, [0, 0]));
            let [q0, q1, q2, q3] = corners.map(|corner| self.position(corner));
            let in_world = (q1 - q0).cross(q2 - q0).dot(q3 - q0);
            // From (u, v, height) to a world where the front is above, the turn changes.
            let keeps = (volume(a, b, c, d) < 0) == (in_world > 0.0);
            keeps == (self.is_mirrored != self.is_inverted())
        })
    }
}

/// Twice the signed area of a triangle.
fn area([a, b, c]: [[i64; 2]; 3]) -> i128 {
    let way = |to: [i64; 2]| [0, 1].map(|axis| i128::from(to[axis] - a[axis]));
    let ([bx, by], [cx, cy]) = (way(b), way(c));
    bx * cy - by * cx
}
